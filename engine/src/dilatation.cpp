#include "shoreline/engine/dilatation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "threads.hpp"

namespace shoreline {
namespace {

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

/// Volume of the points in each element [m²].
std::vector<double> volumes(const Grid& grid, const MaterialPoints& points, const PointSupports& supports) {
  std::vector<double> volume(at(grid.cells() / grid.parts()), 0.0);
  for (Index c = 0; c < supports.cells(); ++c)
    for (Index k = supports.first[at(c)]; k < supports.first[at(c) + 1]; ++k)
      volume[at(supports.cell[at(c)] / grid.parts())] += points.volume[supports.point[at(k)]];
  return volume;
}

/// What sums over the points of one patch, cell by cell, need.
struct PatchPoints {
  const Basis& basis;
  const MaterialPoints& points;
  const PointSupports& supports;
  const std::vector<Index>& cells;  ///< of the patch, as places in supports.cell

  /// Calls visit(number of the point, its place).
  template <class Visit>
  void each(Visit&& visit) const {
    for (const Index c : cells)
      for (Index k = supports.first[at(c)]; k < supports.first[at(c) + 1]; ++k)
        visit(supports.point[at(k)], supports.place[at(k)]);
  }

  /// Calls visit(number of the point, its place, gradients there, functions of its cell).
  template <class Visit>
  void each_with_gradients(Visit&& visit) const {
    BasisAtPoints at_points(basis, supports);
    for (const Index c : cells) {
      const ShortIndices functions = basis.functions_of(supports.cell[at(c)]);
      at_points.evaluate(c);
      for (Index k = supports.first[at(c)]; k < supports.first[at(c) + 1]; ++k)
        visit(supports.point[at(k)], supports.place[at(k)], at_points.gradient(k), functions);
    }
  }
};

std::vector<Index> functions_of(const PatchPoints& all) {
  std::vector<Index> functions;
  for (const Index c : all.cells) {
    const ShortIndices here = all.basis.functions_of(all.supports.cell[at(c)]);
    functions.insert(functions.end(), here.begin(), here.end());
  }
  std::ranges::sort(functions);
  functions.erase(std::ranges::unique(functions).begin(), functions.end());
  return functions;
}

/// Half the width of the cells of a patch [m].
double half_width(const PatchPoints& all) {
  Vec2 lower = all.basis.grid().polygon(all.supports.cell[at(all.cells[0])])[0];
  Vec2 upper = lower;
  for (const Index c : all.cells)
    for (const Vec2& v : all.basis.grid().polygon(all.supports.cell[at(c)])) {
      lower = lower.cwiseMin(v);
      upper = upper.cwiseMax(v);
    }
  return 0.5 * (upper - lower).maxCoeff();
}

Vec2 centroid(const PatchPoints& all) {
  double volume = 0.0;
  Vec2 moment = Vec2::Zero();
  all.each([&](Index p, const Vec2& x) {
    volume += all.points.volume[p];
    moment += all.points.volume[p] * x;
  });
  return moment / volume;
}

Eigen::Index place_of(const std::vector<Index>& functions, Index function) {
  return 2 * (std::ranges::lower_bound(functions, function) - functions.begin());
}

/// Combinations of monomials with Σ V q qᵀ = I, from the mass matrix of the monomials: the first is the constant, each
/// next one takes in the monomial that is farthest from those before. What the points hardly tell apart is left out.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& mass) {
  constexpr double told_apart = 1e-3;
  Eigen::MatrixXd q = Eigen::MatrixXd::Zero(mass.rows(), mass.cols());
  Eigen::VectorXd distance = mass.diagonal();  // squared, from the span of q
  Eigen::Index kept = 0;
  for (Eigen::Index next = 0; kept < mass.rows(); ++kept, distance.maxCoeff(&next)) {
    if (!(distance[next] > told_apart * mass(0, 0))) break;
    Eigen::VectorXd row = Eigen::VectorXd::Unit(mass.rows(), next);
    row -= q.topRows(kept).transpose() * (q.topRows(kept) * mass.col(next));
    row /= std::sqrt(row.dot(mass * row));
    q.row(kept) = row;
    distance -= (mass * row).cwiseAbs2();
  }
  return q.topRows(kept);
}

DilatationPatch make_patch(const PatchPoints& all, const PolynomialSpace& polynomials) {
  DilatationPatch patch{functions_of(all), centroid(all), half_width(all), {}, {}, {}};
  const Eigen::Index m = polynomials.size();
  Eigen::MatrixXd mass = Eigen::MatrixXd::Zero(m, m);
  Eigen::MatrixXd divergence = Eigen::MatrixXd::Zero(m, 2 * static_cast<Eigen::Index>(patch.functions.size()));
  all.each_with_gradients([&](Index p, const Vec2& x, const double* gradient, const ShortIndices& functions) {
    const Eigen::VectorXd q = polynomials((x - patch.centre) / patch.length);
    const Eigen::VectorXd weighted = all.points.volume[p] * q;
    mass += weighted * q.transpose();
    for (Eigen::Index a = 0; a < functions.size(); ++a) {
      const Eigen::Index to = place_of(patch.functions, functions[a]);
      divergence.col(to) += gradient[2 * a] * weighted;
      divergence.col(to + 1) += gradient[2 * a + 1] * weighted;
    }
  });
  patch.orthonormal = orthonormal(mass);
  patch.divergence = patch.orthonormal * divergence;
  patch.prescribed = Eigen::VectorXd::Zero(patch.orthonormal.rows());
  return patch;
}

}  // namespace

Dilatation::Dilatation(const Basis& basis, const ProjectedDilatation& law, const MaterialPoints& points,
                       const PointSupports& supports)
    : basis_(&basis), lambda_(law.lambda), polynomials_(law.groups.polynomials) {
  const Grid& grid = basis.grid();
  const MacroElements groups = without_slivers(law.groups, grid, volumes(grid, points, supports));
  std::vector<Index> patch_of_group(at(groups.count), -1);
  patch_of_element_.assign(groups.of_element.size(), -1);
  std::vector<std::vector<Index>> cells;  // of each patch
  for (Index c = 0; c < supports.cells(); ++c) {
    const Index element = supports.cell[at(c)] / grid.parts();
    Index& patch = patch_of_group[at(groups.of_element[at(element)])];
    if (patch < 0) {
      patch = static_cast<Index>(cells.size());
      cells.emplace_back();
    }
    patch_of_element_[at(element)] = patch;
    cells[at(patch)].push_back(c);
  }
  patches_.resize(cells.size());
#pragma omp parallel for schedule(static) if (worth_threads(supports.point.size()))
  for (std::size_t k = 0; k < patches_.size(); ++k)
    patches_[k] = make_patch({basis, points, supports, cells[k]}, polynomials_);
}

void Dilatation::let_slip(const Edge& edge, const std::vector<BoundaryPoint>& points,
                          const Eigen::Matrix2Xd& prescribed) {
  const std::size_t per_segment = points.size() / edge.segments.size();
  for (std::size_t k = 0; k < points.size(); ++k) {
    const BoundaryPoint& p = points[k];
    const Index cell = edge.support_cell[k / per_segment];
    DilatationPatch& patch = patches_[patch_of(cell)];
    const Support support = basis_->support(cell, p.x);
    const Eigen::VectorXd q = p.weight * polynomials(patch, p.x);
    for (Eigen::Index a = 0; a < support.value.size(); ++a)
      patch.divergence.middleCols<2>(place_of(patch.functions, support.function[a])) +=
          support.value[a] * q * p.normal.transpose();
    if (prescribed.cols() > 0) patch.prescribed -= p.normal.dot(support.interpolate(prescribed)) * q;
  }
}

std::size_t Dilatation::patch_of(Index cell) const {
  const Index patch = patch_of_element_[at(cell / basis_->grid().parts())];
  assert(patch >= 0);
  return at(patch);
}

Eigen::VectorXd Dilatation::polynomials(const DilatationPatch& patch, const Vec2& x) const {
  return patch.orthonormal * polynomials_((x - patch.centre) / patch.length);
}

Eigen::VectorXd Dilatation::coefficients(const DilatationPatch& patch, const Eigen::Matrix2Xd& increment) const {
  Eigen::VectorXd sum = patch.prescribed;
  for (std::size_t a = 0; a < patch.functions.size(); ++a)
    sum += patch.divergence.middleCols<2>(2 * static_cast<Eigen::Index>(a)) * increment.col(patch.functions[a]);
  return sum;
}

double Dilatation::stress(Index cell, const Vec2& x, const Eigen::Matrix2Xd& increment) const {
  const DilatationPatch& patch = patches_[patch_of(cell)];
  return lambda_ * polynomials(patch, x).dot(coefficients(patch, increment));
}

Eigen::RowVectorXd Dilatation::correction(const MaterialPoints& points, const PointSupports& supports,
                                          const Eigen::Matrix2Xd& increment) const {
  std::vector<Eigen::VectorXd> coefficient;
  for (const DilatationPatch& patch : patches_) coefficient.push_back(coefficients(patch, increment));
  Eigen::RowVectorXd stress(points.size());
#pragma omp parallel if (worth_threads(supports.point.size()))
  {
    BasisAtPoints basis(*basis_, supports);
#pragma omp for schedule(static)
    for (Index c = 0; c < supports.cells(); ++c) {
      const std::size_t patch = patch_of(supports.cell[at(c)]);
      const Eigen::Matrix2Xd d = increment(Eigen::all, basis_->functions_of(supports.cell[at(c)]));
      basis.evaluate(c);
      for (Index k = supports.first[at(c)]; k < supports.first[at(c) + 1]; ++k) {
        const Eigen::Map<const Eigen::Matrix2Xd> gradient(basis.gradient(k), 2, supports.functions);
        const double projected = polynomials(patches_[patch], supports.place[at(k)]).dot(coefficient[patch]);
        stress[supports.point[at(k)]] = lambda_ * (projected - gradient.cwiseProduct(d).sum());
      }
    }
  }
  return stress;
}

}  // namespace shoreline
