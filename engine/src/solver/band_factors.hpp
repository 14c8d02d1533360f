#pragma once
// Cholesky of a band: LAPACK's dpbtrf on lower band storage.

#include <memory>

#include "band_order.hpp"
#include "factors.hpp"

namespace shoreline {

/// @param order  of the matrices to come
[[nodiscard]] std::unique_ptr<Factors> make_band_factors(BandOrder order);

}  // namespace shoreline
