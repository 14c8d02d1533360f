#pragma once
// One code for a single point and for several side by side.

#include <type_traits>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// The same number for all points.
template <class Number>
Number uniform(double value) {
  if constexpr (std::is_same_v<Number, double>)
    return value;
  else
    return Number::Constant(value);
}

}  // namespace shoreline
