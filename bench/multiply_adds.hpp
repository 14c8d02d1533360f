#pragma once
// The kernel of the scalar bound; its file is compiled without vectorisation.

namespace shoreline::bench {

inline constexpr int chains = 12;  ///< as many as hide the latency and fit the registers

/// Works out a ← a·b + c in every chain, @p count times.
/// @return the sum of the chains
[[nodiscard]] double multiply_adds(long count, double b, double c);

/// Whether that file was compiled for fused multiply-adds.
[[nodiscard]] bool has_fma();

}  // namespace shoreline::bench
