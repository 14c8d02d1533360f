#pragma once
// The effects that a case names, and those that it does not: what `shoreline check` tells.

#include <string>
#include <vector>

#include "shoreline/engine/scene.hpp"

namespace shoreline {

struct EffectList {
  struct Built {
    std::string name;   ///< as in summary.json
    std::string needs;  ///< what it evaluates, and where
  };
  struct LeftOut {
    std::string name;
    std::string why;
  };
  std::vector<Built> built;
  std::vector<LeftOut> left_out;

  /// Lists an effect as built, or as left out where a case does not name it.
  void add(bool named, const std::string& name, const std::string& needs, const std::string& why);
};

/// Adds the contributions of a scene, pieces that the grid holds, probes, and what quasi-static runs and time steps
/// have in common.
void add_common_effects(const Case& problem, const Scene& scene, EffectList& list);

/// "will run", and "will not run".
[[nodiscard]] std::string text_of(const EffectList& list);

}  // namespace shoreline
