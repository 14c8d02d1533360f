#pragma once
// Components of a field on the grid that conventional conditions give, (C.4).

#include <vector>

#include "shoreline/engine/assembler.hpp"

namespace shoreline {

/// Constraints of a step in the form that a field is held by: x_slave = value + Σ T x_master.
struct HeldComponents {
  std::vector<Constraint> constraint;
  bool any_masters = false;

  explicit HeldComponents(std::vector<Constraint> constraints = {}) : constraint(std::move(constraints)) {
    for (const Constraint& c : constraint) any_masters |= !c.masters.empty();
  }

  /// Gives the held components of a field what they are held at.
  /// @param scale  of the prescribed values: 1, or 0 for a direction of search
  void set(Eigen::Matrix2Xd& field, double scale) const {
    for (const Constraint& c : constraint) {
      double value = scale * c.value;
      for (const ComponentTerm& m : c.masters) value += m.coefficient * field(m.component, m.function);
      field(c.component, c.function) = value;
    }
  }

  /// Tᵀ: moves what falls to held components to their masters.
  void reduce(Eigen::Matrix2Xd& force) const {
    for (const Constraint& c : constraint) {
      double& here = force(c.component, c.function);
      for (const ComponentTerm& m : c.masters) force(m.component, m.function) += m.coefficient * here;
      here = 0.0;
    }
  }
};

}  // namespace shoreline
