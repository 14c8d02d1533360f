#pragma once
// Random closed pieces, and grids that hold them.

#include <cmath>
#include <numbers>
#include <random>

#include "shoreline/bases/quadrilateral_grid.hpp"
#include "shoreline/boundary/spline.hpp"

namespace shoreline::test {

class RandomPieces {
 public:
  explicit RandomPieces(unsigned seed) : engine_(seed) {}

  [[nodiscard]] double uniform(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(engine_);
  }
  [[nodiscard]] int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(engine_); }

  /// Counter-clockwise around (0, 0), |x| < 1.
  [[nodiscard]] Piece star() {
    Piece piece{.name = "star", .closed = true};
    const int count = whole(5, 16);
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + uniform(0.0, 0.5)) / count;
      piece.points.push_back(uniform(0.5, 1.0) * Vec2(std::cos(angle), std::sin(angle)));
    }
    return piece;
  }

  /// Points anywhere: crosses itself in most cases, and has corners in some.
  [[nodiscard]] Piece wild() {
    Piece piece{.name = "wild", .closed = true};
    const int count = whole(3, 12);
    for (int k = 0; k < count; ++k) piece.points.emplace_back(uniform(-1.0, 1.0), uniform(-1.0, 1.0));
    for (int corners = whole(-2, 2); corners > 0; --corners) piece.corners.push_back(whole(0, count - 1));
    return piece;
  }

  /// A star, an open part of one, or a wild piece.
  [[nodiscard]] Piece any() {
    const int kind = whole(0, 2);
    if (kind == 0) return wild();
    Piece piece = star();
    piece.closed = kind == 1;
    if (whole(0, 1) == 0) piece.corners = {whole(1, static_cast<int>(piece.points.size()) - 2)};
    return piece;
  }

  /// A grid of random origin, spacing and extent that holds the curve.
  [[nodiscard]] QuadrilateralGrid grid_around(const SplineCurve& curve) {
    Box box = curve.spans.front().bounds();
    for (const CubicSpan& span : curve.spans) {
      box.lower = box.lower.cwiseMin(span.bounds().lower);
      box.upper = box.upper.cwiseMax(span.bounds().upper);
    }
    const Vec2 spacing(uniform(0.03, 1.0), uniform(0.03, 1.0));
    const Vec2 lower = box.lower - Vec2(uniform(0.0, 1.0), uniform(0.0, 1.0)).cwiseProduct(spacing);
    const Vec2 cells = (box.upper - lower).cwiseQuotient(spacing);
    return {lower, spacing, {static_cast<Index>(cells.x()) + 1, static_cast<Index>(cells.y()) + 1}};
  }

 private:
  std::mt19937 engine_;
};

}  // namespace shoreline::test
