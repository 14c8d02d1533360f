#pragma once
// Cases of the examples, computed in the process of the test.

#include <string>
#include <vector>

#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

/// A case of an example after its load steps.
struct ExampleRun {
  Scene scene;
  RunRecord record{};
  std::function<void(int)> after_step = [](int) {};

  /// @param file       "plate_with_hole/neumann.json"
  /// @param overrides  "path=value", as on the command line
  ExampleRun(const std::string& file, const std::vector<std::string>& overrides)
      : scene(build_scene(read_case(std::string(SHORELINE_EXAMPLES) + "/" + file, overrides))) {}

  ExampleRun& compute() {
    run_load_steps(scene, {.after_step = after_step}, record);
    return *this;
  }
  [[nodiscard]] ErrorNorms errors() const { return error_norms(scene.points, *scene.exact, 1.0); }
};

inline ErrorNorms errors_of_example(const std::string& file, const std::vector<std::string>& overrides) {
  return ExampleRun(file, overrides).compute().errors();
}

/// "key=2^-k" for an override.
inline std::string power_of_two(const std::string& key, int exponent) {
  return key + "=" + std::to_string(std::ldexp(1.0, exponent));
}

}  // namespace shoreline::test
