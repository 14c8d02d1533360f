#pragma once
// Sums of products of gradients over the points of one cell: what a constant tangent needs to know of them.

#include <span>

#include "shoreline/bases/types.hpp"

namespace shoreline {

/// The 2 n numbers of a point, made up to whole groups of four.
constexpr int padded(int n) { return (2 * n + 3) / 4 * 4; }

/// Σ V g gᵀ, g = (∂x φ_1, ∂y φ_1, ∂x φ_2, …): entries on and below the diagonal of the first 2 n rows and columns.
template <int n>
using GradientMoments = Eigen::Matrix<double, padded(n), padded(n)>;

/// Adds Σ V g gᵀ. Sums run over the points in their order, whatever registers the processor has.
/// @param n         functions: 3, 4, 9 or 16
/// @param gradient  (2n) numbers of one point after the other, and two more that may be read
/// @param moments   those of GradientMoments<n>
void add_products(int n, std::span<const double> volume, const double* gradient, double* moments);

/// Σ s gᵀ with four numbers s of each point: column k has Σ s_k g.
template <int n>
using GradientSums = Eigen::Matrix<double, padded(n), 4>;

/// Adds Σ s gᵀ, likewise.
/// @param factor  (4) numbers of one point after the other
/// @param sums    those of GradientSums<n>
void add_sums(int n, std::span<const double> factor, const double* gradient, double* sums);

}  // namespace shoreline
