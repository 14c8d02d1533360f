#pragma once
// Boundary pieces, probes and expressions of a case.

#include <map>

#include "node.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline {

using Constants = std::map<std::string, double>;

/// A number, which ramps, or a formula.
[[nodiscard]] Quantity read_quantity(const Node& node, const Constants& constants);

/// Two of them, x and y.
[[nodiscard]] std::array<Quantity, 2> read_pair(const Node& node, const Constants& constants);

/// A formula, or a number that does not ramp.
[[nodiscard]] Expression read_expression(const Node& node, const Constants& constants);

/// What conditions refer to.
struct Known {
  const Constants& constants;
  bool exact;           ///< whether the case has an exact solution
  double nitsche_band;  ///< default δ/h of Nitsche's method
};

/// @throws CaseError for points that make no piece, names that repeat, a band where there is none, the value of an
///         exact solution where there is none
[[nodiscard]] std::vector<Case::Boundary> read_boundaries(const Node& node, const Known& known);

/// @throws CaseError for names that repeat
[[nodiscard]] std::vector<Case::Probe> read_probes(const Node& node);

}  // namespace shoreline
