#include "shoreline/engine/fill.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "shoreline/bases/error.hpp"

namespace shoreline {
namespace {

constexpr double on_lattice = 1e-9;  ///< of a sub-cell: how far off the outline a point of a vertex lattice may lie

/// The sub-cells of those grid cells that meet the body.
QuadrilateralGrid sub_cells(const Box& body, const QuadrilateralGrid& grid, const std::array<int, 2>& per_cell) {
  const Box all = grid.bounds();
  Vec2 lower;
  std::array<Index, 2> count{};
  for (int axis = 0; axis < 2; ++axis) {
    const double h = grid.spacing()[axis];
    const double first = std::floor((body.lower[axis] - all.lower[axis]) / h - on_lattice);
    const double last = std::ceil((body.upper[axis] - all.lower[axis]) / h + on_lattice);
    lower[axis] = grid.line(axis, static_cast<Index>(first));
    count[static_cast<std::size_t>(axis)] = static_cast<Index>(last - first) * per_cell[static_cast<std::size_t>(axis)];
  }
  return {lower, grid.spacing().cwiseQuotient(Vec2(per_cell[0], per_cell[1])), count};
}

Vec2 centre(const QuadrilateralGrid& lattice, Index cell) { return lattice.corner(cell) + 0.5 * lattice.spacing(); }

/// Points at chosen places of the covered cells.
/// @param place  (k, cell) → whether there is a point, where, and its volume
template <class Place>
MaterialPoints place_points(const CellMoments& covered, Place&& place) {
  Eigen::Matrix2Xd position(2, static_cast<Eigen::Index>(covered.cell.size()));
  Eigen::VectorXd volume(position.cols());
  Eigen::Index n = 0;
  for (std::size_t k = 0; k < covered.cell.size(); ++k)
    if (const auto at = place(static_cast<Eigen::Index>(k), covered.cell[k])) {
      position.col(n) = at->first;
      volume[n++] = at->second;
    }
  position.conservativeResize(2, n);
  volume.conservativeResize(n);
  return points_at(std::move(position), std::move(volume));
}

using Placed = std::optional<std::pair<Vec2, double>>;

void share_equally(double area, MaterialPoints& points) {
  points.volume.setConstant(area / static_cast<double>(points.size()));
}

/// The spacing of a vertex lattice on a body of a given width and height.
Vec2 vertex_spacing(const Vec2& extent, const Vec2& cell_size, const VertexFill& fill) {
  if (!fill.across) return cell_size.cwiseQuotient(Vec2(fill.count[0], fill.count[1]));
  if (std::min(fill.count[0], fill.count[1]) < 2)
    throw InvalidArgument(fmt::format("fill \"vertex\" needs at least 2 points across the body, got {} x {}",
                                      fill.count[0], fill.count[1]));
  return extent.cwiseQuotient(Vec2(fill.count[0] - 1, fill.count[1] - 1));
}

/// The sub-cells centred at the nodes of a vertex lattice.
QuadrilateralGrid vertex_lattice(const Box& body, const Vec2& cell_size, const VertexFill& fill) {
  const Vec2 spacing = vertex_spacing(body.upper - body.lower, cell_size, fill);
  const Vec2 steps = (body.upper - body.lower).cwiseQuotient(spacing);
  const Vec2 whole = steps.array().round();
  if ((steps - whole).cwiseAbs().maxCoeff() > on_lattice * steps.maxCoeff() || whole.minCoeff() < 1.0)
    throw InvalidArgument(fmt::format(
        "the body is {:.6g} x {:.6g} sub-cells of {:.6g} m x {:.6g} m; fill \"vertex\" needs whole numbers (change "
        "per_cell or the outline, or use fill \"lattice\")",
        steps.x(), steps.y(), spacing.x(), spacing.y()));
  return {body.lower - 0.5 * spacing, spacing, {static_cast<Index>(whole.x()) + 1, static_cast<Index>(whole.y()) + 1}};
}

}  // namespace

MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const QuadrilateralGrid& grid,
                            const LatticeFill& fill) {
  const Region region(curves);
  const QuadrilateralGrid lattice = sub_cells(region.bounds(), grid, fill.per_cell);
  const CellMoments covered = cell_moments(curves, lattice, 1);
  if (fill.volumes == VolumeRule::clipped)
    return place_points(covered, [&](Eigen::Index k, Index cell) -> Placed {
      constexpr double rounding = 1e-12;  // of a sub-cell: where the outline runs along its side
      const auto moment = covered.moment.col(k);
      if (moment[0] <= rounding * lattice.spacing().prod()) return std::nullopt;
      return std::pair(Vec2(centre(lattice, cell) + moment.segment<2>(1) / moment[0]), moment[0]);
    });
  MaterialPoints points = place_points(covered, [&](Eigen::Index, Index cell) -> Placed {
    if (!region.contains(centre(lattice, cell))) return std::nullopt;
    return std::pair(centre(lattice, cell), lattice.spacing().prod());
  });
  if (fill.volumes == VolumeRule::equal) share_equally(region.area(), points);
  return points;
}

MaterialPoints fill_lattice(std::span<const SplineCurve> curves, const AcrossFill& fill) {
  const Box body = Region(curves).bounds();
  const Vec2 spacing = (body.upper - body.lower).cwiseQuotient(Vec2(fill.across[0], fill.across[1]));
  return fill_lattice(curves, {body.lower, spacing, fill.across}, {{1, 1}, fill.volumes});
}

MaterialPoints fill_vertex(std::span<const SplineCurve> curves, const Vec2& cell_size, const VertexFill& fill) {
  const Region region(curves);
  const QuadrilateralGrid lattice = vertex_lattice(region.bounds(), cell_size, fill);
  const Vec2& spacing = lattice.spacing();
  const CellMoments covered = cell_moments(curves, lattice, 0);
  double area = 0.0;
  MaterialPoints points = place_points(covered, [&](Eigen::Index k, Index cell) -> Placed {
    const Vec2 x = centre(lattice, cell);
    if (!region.contains(x) && !region.near_outline(x, on_lattice * spacing.maxCoeff())) return std::nullopt;
    area += covered.moment(0, k);
    return std::pair(x, fill.volumes == VolumeRule::clipped ? covered.moment(0, k) : spacing.prod());
  });
  if (std::abs(area - region.area()) > on_lattice * region.area())
    throw InvalidArgument(fmt::format(
        "points of a lattice with spacing {:.6g} m x {:.6g} m hold {:.6g} m² of the body's {:.6g} m²; fill \"vertex\" "
        "needs an outline along the lattice (use fill \"lattice\")",
        spacing.x(), spacing.y(), area, region.area()));
  if (fill.volumes == VolumeRule::equal) share_equally(region.area(), points);
  return points;
}

void mark_outline(const Region& region, double tolerance, MaterialPoints& points) {
  constexpr int directions = 16;
  for (Index p = 0; p < points.size(); ++p) {
    const Vec2 x = points.position.col(p);
    if (!region.near_outline(x, tolerance)) continue;
    Vec2 inward = Vec2::Zero();
    for (int k = 0; k < directions; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.5) / directions;
      const Vec2 direction(std::cos(angle), std::sin(angle));
      if (region.contains(x + 1e3 * tolerance * direction)) inward += direction;
    }
    if (inward.norm() > 1e-3) points.on_outline.push_back({p, inward.normalized()});
  }
}

}  // namespace shoreline
