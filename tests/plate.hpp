#pragma once
// The plate with a hole of Bing et al. 2019, §4.4.

#include "shoreline/boundary/spline.hpp"

namespace shoreline::test {

/// Its outer boundary, run with the body to its left.
inline Piece plate_outer() {
  return {.name = "outer",
          .points = {{1.5, 0.0},
                     {1.78, 0.21},
                     {2.0, 0.75},
                     {1.75, 1.3},
                     {1.5, 1.35},
                     {1.0, 1.15},
                     {0.73, 1.31},
                     {0.6, 1.8},
                     {0.35, 1.95},
                     {0.1, 1.75},
                     {0.0, 1.5}}};
}

}  // namespace shoreline::test
