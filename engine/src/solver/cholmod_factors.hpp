#pragma once
// Sparse Cholesky: CHOLMOD, supernodal, ordered by AMD.

#include <memory>

#include "factors.hpp"

namespace shoreline {

[[nodiscard]] std::unique_ptr<Factors> make_cholmod_factors();

}  // namespace shoreline
