#include "diagnosis.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "weak_spots.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Sets of functions joined by blocks: for each function one that stands for its set.
class Parts {
 public:
  Parts(const ElementBlocks& blocks, Index functions) : parent_(at(functions)) {
    std::iota(parent_.begin(), parent_.end(), 0);
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (Index k = blocks.first[b] + 1; k < blocks.first[b + 1]; ++k)
        parent_[at(root(blocks.function[at(k)]))] = root(blocks.function[at(blocks.first[b])]);
  }

  Index root(Index f) {
    while (parent_[at(f)] != f) f = parent_[at(f)] = parent_[at(parent_[at(f)])];
    return f;
  }

 private:
  std::vector<Index> parent_;
};

/// The material of one part.
struct Body {
  Index points = 0;
  Index cells = 0;
  double volume = 0.0;
  Vec2 centre = Vec2::Zero();
  Mat3 energy = Mat3::Zero();    ///< of unit translations and a rotation about the centre
  Vec3 strength = Vec3::Zero();  ///< the same from the diagonal of K alone, which never vanishes
};

std::map<Index, Body> bodies(const StepState& step, Parts& parts) {
  std::map<Index, Body> found;
  for (std::size_t c = 0; c < step.supports.cell.size(); ++c) {
    Body& body = found[parts.root(step.basis.functions_of(step.supports.cell[c])[0])];
    ++body.cells;
    for (Index k = step.supports.first[c]; k < step.supports.first[c + 1]; ++k) {
      const Index p = step.supports.point[at(k)];
      ++body.points;
      body.volume += step.points.volume[p];
      body.centre += step.points.volume[p] * step.points.position.col(p);
    }
  }
  for (auto& [root, body] : found) body.centre /= body.volume;
  return found;
}

/// Displacement of a control point by the three rigid motions, (2, 3).
Eigen::Matrix<double, 2, 3> rigid(const Vec2& x, const Body& body) {
  const Vec2 arm = (x - body.centre) / std::sqrt(body.volume);
  Eigen::Matrix<double, 2, 3> motion;
  motion << 1.0, 0.0, -arm.y(), 0.0, 1.0, arm.x();
  return motion;
}

void add_energy(const StepState& step, const ElementBlocks& blocks, std::size_t b, Body& body) {
  const Eigen::Index m = 2 * blocks.functions_in(b);
  Eigen::Matrix<double, Eigen::Dynamic, 3> modes(m, 3);
  for (Eigen::Index a = 0; a < m / 2; ++a)
    modes.middleRows<2>(2 * a) =
        rigid(step.basis.control_point(blocks.function[at(blocks.first[b] + static_cast<Index>(a))]), body);
  const double* k = blocks.matrix.data() + blocks.entry[b];
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = j; i < m; ++i, ++k) {
      const Mat3 product = *k * modes.row(i).transpose() * modes.row(j);
      body.energy += i == j ? product : Mat3(product + product.transpose());
      if (i == j) body.strength += product.diagonal().cwiseAbs();
    }
}

std::string describe(const Vec3& mode) {
  if (std::abs(mode[2]) > 0.5) return "turn";
  return fmt::format("slide along ({:.2g}, {:.2g})", mode[0], mode[1]);
}

Index points_in(const StepState& step, std::size_t cell) {
  return step.supports.first[cell + 1] - step.supports.first[cell];
}

std::string count(Index number, const char* one) { return fmt::format("{} {}{}", number, one, number == 1 ? "" : "s"); }

/// ", 2.5e-07 of which the body covers,", or nothing where no outline says.
std::string covered_share(const StepState& step, Index cell) {
  const std::vector<CutFraction> cuts = cut_fractions(step);
  const auto cut = std::ranges::find(cuts, cell / step.basis.grid().parts(), &CutFraction::element);
  return cut == cuts.end() ? "" : fmt::format(", {:.3g} of which the body covers,", cut->fraction);
}

/// Where a cell is, how much of it is in the body, and what it holds.
/// @param cell  place in the list of active cells
std::string describe_cell(const StepState& step, std::size_t cell) {
  Vec2 centre = Vec2::Zero();
  const std::vector<Vec2> polygon = step.basis.grid().polygon(step.supports.cell[cell]);
  for (const Vec2& vertex : polygon) centre += vertex / static_cast<double>(polygon.size());
  return fmt::format("around ({:.6g}, {:.6g}){} with {}", centre.x(), centre.y(),
                     covered_share(step, step.supports.cell[cell]), count(points_in(step, cell), "material point"));
}

}  // namespace

std::optional<std::string> free_motion(const StepState& step, const ElementBlocks& blocks,
                                       const std::vector<Constraint>& constraints) {
  Parts parts(blocks, step.basis.functions());
  std::map<Index, Body> found = bodies(step, parts);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    add_energy(step, blocks, b, found.at(parts.root(blocks.function[at(blocks.first[b])])));
  for (const Constraint& c : constraints)
    if (const auto body = found.find(parts.root(c.function)); body != found.end()) {
      Vec3 held = rigid(step.basis.control_point(c.function), body->second).row(c.component);
      for (const ComponentTerm& m : c.masters)
        held -= m.coefficient * rigid(step.basis.control_point(m.function), body->second).row(m.component).transpose();
      body->second.energy += body->second.strength.maxCoeff() * held * held.transpose();
    }
  for (const auto& [root, body] : found) {
    const Vec3 scale = body.strength.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Mat3> modes(scale.asDiagonal() * body.energy * scale.asDiagonal());
    if (modes.eigenvalues()[0] > 1e-13) continue;
    const Vec3 mode = (scale.asDiagonal() * modes.eigenvectors().col(0)).normalized();
    return fmt::format("{} with {} in {} around ({:.6g}, {:.6g}) can {} freely: nothing holds it",
                       found.size() == 1 ? "the body" : "a separate part of the body",
                       count(body.points, "material point"), count(body.cells, "cell"), body.centre.x(),
                       body.centre.y(), describe(mode));
  }
  return std::nullopt;
}

std::string weak_unknown(const StepState& step, Index unknown) {
  const Index function = unknown / 2;
  double volume = 0.0;
  Index points = 0;
  std::optional<std::size_t> emptiest;
  for (std::size_t c = 0; c < step.supports.cell.size(); ++c) {
    const ShortIndices functions = step.basis.functions_of(step.supports.cell[c]);
    if (std::find(functions.begin(), functions.end(), function) == functions.end()) continue;
    if (!emptiest || points_in(step, c) < points_in(step, *emptiest)) emptiest = c;
    for (Index k = step.supports.first[c]; k < step.supports.first[c + 1]; ++k, ++points)
      volume += step.points.volume[step.supports.point[at(k)]];
  }
  const Vec2 x = step.basis.control_point(function);
  return fmt::format("the {} displacement of the function at ({:.6g}, {:.6g}), which sees {} of {:.3g} m² in all{}",
                     unknown % 2 == 0 ? "x" : "y", x.x(), x.y(), count(points, "material point"), volume,
                     emptiest ? "; its emptiest cell is " + describe_cell(step, *emptiest) : "");
}

std::optional<std::string> stray_point(const StepState& step, const Eigen::Matrix2Xd& increment) {
  BasisAtPoints basis(step.basis, step.supports, Evaluate::values);
  double largest = 0.0;
  std::size_t cell = 0;
  Index point = 0;
  for (std::size_t c = 0; c < step.supports.cell.size(); ++c) {
    const ShortIndices functions = step.basis.functions_of(step.supports.cell[c]);
    basis.evaluate(static_cast<Index>(c));
    for (Index k = step.supports.first[c]; k < step.supports.first[c + 1]; ++k) {
      Vec2 motion = Vec2::Zero();
      for (Eigen::Index a = 0; a < functions.size(); ++a) motion += basis.value(k)[a] * increment.col(functions[a]);
      if (motion.norm() <= largest) continue;
      largest = motion.norm();
      cell = c;
      point = step.supports.point[at(k)];
    }
  }
  const auto& x = step.points.position;
  const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).norm();
  if (largest <= size) return std::nullopt;
  return fmt::format(
      "the material point at ({:.6g}, {:.6g}) would move by {:.1e} m, more than the size of the body, {:.3g} m; it is "
      "in "
      "the cell {}",
      x(0, point), x(1, point), largest, size, describe_cell(step, cell));
}

}  // namespace shoreline
