#pragma once
// Random input with a fixed seed: every run of a test sees the same.

#include <cmath>
#include <random>

#include "shoreline/bases/quadrilateral_grid.hpp"

namespace shoreline::test {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  [[nodiscard]] Index whole(Index from, Index to) { return std::uniform_int_distribution<Index>(from, to)(engine_); }
  [[nodiscard]] Vec2 vector(double from = -1.0, double to = 1.0) { return {uniform(from, to), uniform(from, to)}; }
  [[nodiscard]] Vec2 direction() {
    const double angle = uniform(0.0, 6.3);
    return {std::cos(angle), std::sin(angle)};
  }
  [[nodiscard]] Vec2 in(const Box& box) {
    return {uniform(box.lower.x(), box.upper.x()), uniform(box.lower.y(), box.upper.y())};
  }
  /// One displacement (or control point) a function.
  [[nodiscard]] Eigen::Matrix2Xd field(Index functions) {
    return Eigen::Matrix2Xd::NullaryExpr(2, functions, [&] { return uniform(-1.0, 1.0); });
  }
  /// Any origin and spacing, at least two columns and rows.
  [[nodiscard]] QuadrilateralGrid grid(Index most = 9) {
    return {vector(-5.0, 5.0), vector(0.05, 2.0), {whole(2, most), whole(2, most)}};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace shoreline::test
