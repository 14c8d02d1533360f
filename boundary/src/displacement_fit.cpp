#include "shoreline/boundary/displacement_fit.hpp"

#include <Eigen/SparseCholesky>
#include <cmath>

#include "shoreline/bases/counters.hpp"
#include "shoreline/bases/derivatives.hpp"

namespace shoreline {
namespace {

constexpr double smoothing = 1e-6;  ///< ε, of jumps of the derivatives of order p
constexpr int solutions = 3;        ///< each takes away most of what η and κ leave behind

/// η, of the gradient. On a bent curve the trace sees the slope across it, by the square of the bend: smooth bases,
/// which are as accurate as that, need a smaller η.
constexpr double flatness(int degree) { return degree == 1 ? 1e-8 : 1e-12; }

/// κ over the largest diagonal entry, for what no slope sees.
constexpr double ridge(int degree) { return degree == 1 ? 1e-12 : 1e-14; }

using Sparse = Eigen::SparseMatrix<double>;

Support support_at(const Basis& basis, const Edge& edge, std::size_t k) {
  return basis.support(edge.support_cell[edge.segment_of(k)], edge.points[k].x);
}

Mat2 held_part(const HeldEdge& held, const Vec2& normal) {
  return held.normal_only ? Mat2(normal * normal.transpose()) : Mat2(Mat2::Identity());
}

/// The normal equations of the fit, over the functions that some curve sees.
class NormalEquations {
 public:
  NormalEquations(const Basis& basis, std::span<const HeldEdge> edges)
      : basis_(basis), number_(static_cast<std::size_t>(basis.functions()), -1) {
    for (const HeldEdge& held : edges)
      for (const Index cell : held.edge.support_cell)
        for (const Index f : basis.functions_of(cell)) {
          if (number_[static_cast<std::size_t>(f)] >= 0) continue;
          number_[static_cast<std::size_t>(f)] = static_cast<int>(function_.size());
          function_.push_back(f);
        }
    data_ = Eigen::VectorXd::Zero(2 * static_cast<Eigen::Index>(function_.size()));
    for (const HeldEdge& held : edges) {
      for (std::size_t k = 0; k < held.edge.points.size(); ++k) add_point(held, k);
      for (std::size_t s = 0; s + 1 < held.edge.segments.size(); ++s) add_jump(held.edge, s);
    }
  }

  /// (2, functions of the basis)
  [[nodiscard]] Eigen::Matrix2Xd solution() const {
    const Sparse fit = sum(fit_);
    Sparse identity(fit.rows(), fit.cols());
    identity.setIdentity();
    const int p = basis_.degree();
    const double largest = Eigen::VectorXd(fit.diagonal()).maxCoeff();
    const Eigen::SimplicialLDLT<Sparse> factors(fit + flatness(p) * sum(slope_) + ridge(p) * largest * identity);
    Eigen::VectorXd unknown = Eigen::VectorXd::Zero(data_.size());
    for (int k = 0; k < solutions; ++k) unknown += factors.solve(data_ - fit * unknown);
    Eigen::Matrix2Xd coefficient = Eigen::Matrix2Xd::Zero(2, basis_.functions());
    for (std::size_t i = 0; i < function_.size(); ++i)
      coefficient.col(function_[i]) = unknown.segment<2>(2 * static_cast<Eigen::Index>(i));
    return coefficient;
  }

 private:
  using Entries = std::vector<Eigen::Triplet<double>>;

  /// The derivatives of order p on one side of a jump.
  struct Side {
    ShortIndices function;
    ShortDerivatives derivative;
    double sign;
  };

  [[nodiscard]] int row(Index function) const { return 2 * number_[static_cast<std::size_t>(function)]; }

  [[nodiscard]] Sparse sum(const Entries& entries) const {
    Sparse matrix(data_.size(), data_.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  }

  void add_point(const HeldEdge& held, std::size_t k) {
    const BoundaryPoint& p = held.edge.points[k];
    const Support support = support_at(basis_, held.edge, k);
    const double h = basis_.grid().size(held.edge.support_cell[held.edge.segment_of(k)]);
    const Mat2 part = held_part(held, p.normal);
    const Vec2 value = part * held.value.col(static_cast<Eigen::Index>(k));
    for (Eigen::Index a = 0; a < support.value.size(); ++a) {
      const int i = row(support.function[a]);
      data_.segment<2>(i) += p.weight * support.value[a] * value;
      for (Eigen::Index b = 0; b < support.value.size(); ++b) {
        const int j = row(support.function[b]);
        const double slopes = p.weight * h * h * support.gradient.col(a).dot(support.gradient.col(b));
        for (const int c : {0, 1}) {
          slope_.emplace_back(i + c, j + c, slopes);
          for (const int d : {0, 1})
            fit_.emplace_back(i + c, j + d, p.weight * support.value[a] * support.value[b] * part(c, d));
        }
      }
    }
  }

  /// ε h^(2p+1) [∇ᵖu]·[∇ᵖv], mean over segment s and the next: the difference of their polynomials, each continued to
  /// the other's segment.
  void add_jump(const Edge& edge, std::size_t s) {
    if (edge.support_cell[s] == edge.support_cell[s + 1]) return;
    const auto n = static_cast<std::size_t>(edge.points_per_segment);
    for (std::size_t k = s * n; k < (s + 2) * n; ++k)
      add_jump(edge.support_cell[s], edge.support_cell[s + 1], edge.points[k].x, 0.5 / static_cast<double>(n));
  }

  void add_jump(Index cell, Index next, const Vec2& x, double share) {
    const int p = basis_.degree();
    const double weight = share * smoothing * std::pow(basis_.grid().size(cell), 2 * p + 1);
    const Side here{basis_.functions_of(cell), derivatives(basis_, cell, x, p), 1.0};
    const Side there{basis_.functions_of(next), derivatives(basis_, next, x, p), -1.0};
    for (const Side* one : {&here, &there})
      for (const Side* other : {&here, &there})
        for (Eigen::Index a = 0; a < one->function.size(); ++a)
          for (Eigen::Index b = 0; b < other->function.size(); ++b)
            for (const int c : {0, 1})
              fit_.emplace_back(
                  row(one->function[a]) + c, row(other->function[b]) + c,
                  weight * one->sign * other->sign * one->derivative.col(a).dot(other->derivative.col(b)));
  }

  const Basis& basis_;
  std::vector<int> number_;  ///< (functions of the basis) or −1
  std::vector<Index> function_;
  Entries fit_;    ///< ∫ Mᵀ P M dS + ε Σ h^(2p+1) [∇ᵖM]ᵀ [∇ᵖM]
  Entries slope_;  ///< ∫ h² ∇Mᵀ ∇M dS
  Eigen::VectorXd data_;
};

FitError error_of(const Basis& basis, const HeldEdge& held, const Eigen::Matrix2Xd& coefficient) {
  double length = 0.0;
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < held.edge.points.size(); ++k) {
    const BoundaryPoint& p = held.edge.points[k];
    const Vec2 fitted = support_at(basis, held.edge, k).interpolate(coefficient);
    const double error = (held_part(held, p.normal) * (fitted - held.value.col(static_cast<Eigen::Index>(k)))).norm();
    length += p.weight;
    sum += p.weight * error;
    squares += p.weight * error * error;
  }
  return {.l2 = std::sqrt(squares), .mean = sum / length};
}

}  // namespace

DisplacementFit fit_displacement(const Basis& basis, std::span<const HeldEdge> edges) {
  count(Work::displacement_fits);
  DisplacementFit fit{.coefficient = NormalEquations(basis, edges).solution(), .error = {}};
  for (const HeldEdge& held : edges) fit.error.push_back(error_of(basis, held, fit.coefficient));
  return fit;
}

}  // namespace shoreline
