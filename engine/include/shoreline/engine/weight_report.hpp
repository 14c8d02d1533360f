#pragma once
// What the fit of weights reports.

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// What fitting the weights of material points to the outline came to, (W.1)–(W.9).
struct WeightReport {
  double changed = 0.0;     ///< share of the points whose weight differs from the plain one by more than 10 %
  Index bounded = 0;        ///< points at the lower bound
  double unmet = 0.0;       ///< largest |A w − r|, in parts of the largest |r|
  Index cells_unmet = 0;    ///< cells whose points do not integrate gradients by themselves; quasi-static
  double unserved = 0.0;    ///< share of the body in elements without points; quasi-static runs alone
  long iterations = 0;      ///< of Newton's method for consistent weights
  long factorisations = 0;  ///< of its matrix

  /// Takes in another fit: the worst of both, and their iterations together.
  void add(const WeightReport& other);
};

}  // namespace shoreline
