#pragma once
// Dynamic cases of the examples, computed in the process of the test.

#include <string>
#include <vector>

#include "shoreline/engine/case_reader.hpp"
#include "shoreline/engine/dynamics.hpp"

namespace shoreline::test {

/// A dynamic case of an example and its run.
struct Motion {
  DynamicScene scene;
  DynamicRecord record{};

  explicit Motion(DynamicScene made) : scene(std::move(made)) {}

  /// @param file       "soil_column/large.json"
  /// @param overrides  "path=value", as on the command line
  Motion(const std::string& file, const std::vector<std::string>& overrides)
      : scene(build_dynamic_scene(read_case(std::string(SHORELINE_EXAMPLES) + "/" + file, overrides))) {}

  Motion& compute() & {
    run_time_steps(scene, {}, record);
    return *this;
  }
  Motion compute() && {
    compute();
    return std::move(*this);
  }

  /// Errors of "displacement", "velocity" or "stress" over time.
  [[nodiscard]] ErrorNorms::OverTime over_time(const std::string& of) const {
    for (const ErrorNorms::OverTime& norm : record.errors_over_time)
      if (norm.of == of) return norm;
    return {};
  }
  [[nodiscard]] ErrorNorms errors() const { return error_norms(scene.body.points, *scene.body.exact, record.t); }
};

}  // namespace shoreline::test
