#include "shoreline/boundary/cut_points.hpp"

#include <algorithm>

#include "closed_spans.hpp"
#include "contour_moments.hpp"
#include "cubic.hpp"
#include "grid_crossings.hpp"
#include "shoreline/boundary/region.hpp"
#include "span_tree.hpp"

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

/// One sub-rectangle: the sum of the closed runs through it, and whether there are any.
struct SubRectangle {
  bool met = false;
  bool whole = false;  ///< if no run meets it
  Moments runs = Moments::Zero();
};

/// The sub-rectangles of a box, which all have the corners and the moments of the first one about their centres.
struct SubRectangles {
  QuadrilateralGrid lattice;
  std::array<Vec2, 4> corners;
  Moments whole;

  SubRectangles(const Box& box, const std::array<int, 2>& divisions)
      : lattice(box.lower, (box.upper - box.lower).cwiseQuotient(Vec2(divisions[0], divisions[1])),
                {divisions[0], divisions[1]}) {
    const Vec2 half = 0.5 * lattice.spacing();
    corners = {-half, Vec2(half.x(), -half.y()), half, Vec2(-half.x(), half.y())};
    whole = along_border(corners, {3, corners[0]}, corners[0]);
  }

  [[nodiscard]] Vec2 centre(Index k) const { return lattice.corner(k) + 0.5 * lattice.spacing(); }

  /// Which one holds x, or -1.
  [[nodiscard]] Index at(const Vec2& x) const {
    const Box box = lattice.bounds();
    const bool inside = (x.array() >= box.lower.array()).all() && (x.array() <= box.upper.array()).all();
    return inside ? lattice.locate(x, 0).value_or(-1) : -1;
  }
};

void add_runs(const CubicSpan& span, const SubRectangles& subs, std::vector<SubRectangle>& found) {
  const std::vector<double> u = split_at_lines(span, subs.lattice);
  for (std::size_t i = 0; i + 1 < u.size(); ++i) {
    const Index k = by_majority(u[i], u[i + 1], [&](double at) { return subs.at(span.position(at)); });
    if (k < 0) continue;
    found[static_cast<std::size_t>(k)].met = true;
    found[static_cast<std::size_t>(k)].runs += closed_run(part(span, u[i], u[i + 1]), subs.corners, subs.centre(k));
  }
}

/// Finds out which of them without runs are whole. Two neighbours without runs are alike, so a patch of them asks once.
void settle(const Region& region, const SubRectangles& subs, std::vector<SubRectangle>& found) {
  const Index columns = subs.lattice.columns();
  for (Index k = 0; k < subs.lattice.cells(); ++k) {
    SubRectangle* const here = &found[static_cast<std::size_t>(k)];
    if (here->met) continue;
    if (k % columns > 0 && !(here - 1)->met)
      here->whole = (here - 1)->whole;
    else if (k >= columns && !(here - columns)->met)
      here->whole = (here - columns)->whole;
    else
      here->whole = region.contains(subs.centre(k));
  }
}

Moments covered(const SubRectangle& sub, const Moments& whole, const Region& region, const Vec2& centre) {
  if (!sub.met) return sub.whole ? whole : Moments(Moments::Zero());
  return sub.runs + whole * missing_wholes(sub.runs[0] / whole[0], [&] { return region.contains(centre); });
}

Round round_in(const Region& region, std::span<const CubicSpan> spans, const Box& box,
               const std::array<int, 2>& divisions) {
  const SubRectangles subs(box, divisions);
  std::vector<SubRectangle> found(static_cast<std::size_t>(subs.lattice.cells()));
  for (const CubicSpan& span : spans) add_runs(span, subs, found);
  settle(region, subs, found);
  Round round;
  for (Index k = 0; k < subs.lattice.cells(); ++k) {
    const Vec2 centre = subs.centre(k);
    const Moments m = covered(found[static_cast<std::size_t>(k)], subs.whole, region, centre);
    if (m[0] <= trifle * subs.whole[0]) continue;
    const Box around{subs.lattice.corner(k), subs.lattice.corner(k) + subs.lattice.spacing()};
    if (round.area.empty()) round.covered = around;
    round.covered.lower = round.covered.lower.cwiseMin(around.lower);
    round.covered.upper = round.covered.upper.cwiseMax(around.upper);
    round.position.emplace_back(centre + m.segment<2>(1) / m[0]);
    round.area.push_back(m[0]);
  }
  return round;
}

}  // namespace

struct CutPoints::Body {
  explicit Body(std::span<const SplineCurve> curves) : region(curves), spans(closed_spans(curves)), tree(spans) {}

  [[nodiscard]] std::vector<CubicSpan> spans_near(const Box& box) const {
    std::vector<CubicSpan> near;
    tree.for_each_in(box, [&](std::size_t k) { near.push_back(spans[k]); });
    return near;
  }

  Region region;
  std::vector<CubicSpan> spans;
  SpanTree tree;
};

CutPoints::CutPoints(std::span<const SplineCurve> curves) : body_(std::make_unique<Body>(curves)) {}
CutPoints::~CutPoints() = default;
CutPoints::CutPoints(CutPoints&&) noexcept = default;
CutPoints& CutPoints::operator=(CutPoints&&) noexcept = default;

AreaPoints CutPoints::in(const Box& rectangle, const std::array<int, 2>& divisions) const {
  const auto few = static_cast<std::size_t>(divisions[0] * divisions[1] / 4);
  const std::vector<CubicSpan> spans = body_->spans_near(rectangle);
  Round round = round_in(body_->region, spans, rectangle, divisions);
  for (int k = 0; k < most_rounds && !round.area.empty() && round.area.size() < few; ++k) {
    const Box box = round.covered;
    if ((box.upper - box.lower).prod() <= trifle * (rectangle.upper - rectangle.lower).prod()) break;
    round = round_in(body_->region, spans, box, divisions);
  }
  const auto n = static_cast<Eigen::Index>(round.area.size());
  AreaPoints points{Eigen::Matrix2Xd(2, n), Eigen::Map<const Eigen::VectorXd>(round.area.data(), n)};
  for (Eigen::Index p = 0; p < n; ++p) points.position.col(p) = round.position[static_cast<std::size_t>(p)];
  return points;
}

}  // namespace shoreline
