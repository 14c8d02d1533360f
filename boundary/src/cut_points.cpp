#include "shoreline/boundary/cut_points.hpp"

#include "cover.hpp"

namespace shoreline {
namespace {

constexpr double trifle = 1e-13;  ///< of an area: nothing
constexpr int most_rounds = 14;

/// What is covered of the sub-rectangles of a box.
struct Round {
  std::vector<Vec2> position;
  std::vector<double> area;
  Box covered{Vec2::Zero(), Vec2::Zero()};  ///< of the sub-rectangles that are not empty
};

Round round_in(const Cover& cover, const Box& box, const std::array<int, 2>& divisions) {
  const Vec2 size = (box.upper - box.lower).cwiseQuotient(Vec2(divisions[0], divisions[1]));
  const Vec2 half = 0.5 * size;
  const std::array<Vec2, 4> corners{-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())};
  Round round;
  for (int j = 0; j < divisions[1]; ++j)
    for (int i = 0; i < divisions[0]; ++i) {
      const Vec2 lower = box.lower + Vec2(i, j).cwiseProduct(size);
      const Moments m = cover.moments(corners, lower + half, 1e-9 * size.minCoeff());
      if (m[0] <= trifle * size.prod()) continue;
      if (round.area.empty()) round.covered = {lower, lower + size};
      round.covered.lower = round.covered.lower.cwiseMin(lower);
      round.covered.upper = round.covered.upper.cwiseMax(lower + size);
      round.position.emplace_back(lower + half + m.segment<2>(1) / m[0]);
      round.area.push_back(m[0]);
    }
  return round;
}

}  // namespace

struct CutPoints::Body {
  Cover cover;
};

CutPoints::CutPoints(std::span<const SplineCurve> curves) : body_(std::make_unique<Body>(Body{Cover(curves)})) {}
CutPoints::~CutPoints() = default;
CutPoints::CutPoints(CutPoints&&) noexcept = default;
CutPoints& CutPoints::operator=(CutPoints&&) noexcept = default;

AreaPoints CutPoints::in(const Box& rectangle, const std::array<int, 2>& divisions) const {
  const auto few = static_cast<std::size_t>(divisions[0] * divisions[1] / 4);
  Round round = round_in(body_->cover, rectangle, divisions);
  for (int k = 0; k < most_rounds && !round.area.empty() && round.area.size() < few; ++k) {
    const Box box = round.covered;
    if ((box.upper - box.lower).prod() <= trifle * (rectangle.upper - rectangle.lower).prod()) break;
    round = round_in(body_->cover, box, divisions);
  }
  const auto n = static_cast<Eigen::Index>(round.area.size());
  AreaPoints points{Eigen::Matrix2Xd(2, n), Eigen::Map<const Eigen::VectorXd>(round.area.data(), n)};
  for (Eigen::Index p = 0; p < n; ++p) points.position.col(p) = round.position[static_cast<std::size_t>(p)];
  return points;
}

}  // namespace shoreline
