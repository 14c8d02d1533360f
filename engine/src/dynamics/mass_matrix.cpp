#include "mass_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../threads.hpp"
#include "shoreline/bases/counters.hpp"
#include "shoreline/engine/failures.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

}  // namespace

MassMatrix::MassMatrix(const ElementTable& table, MassForm form) : table_(table), form_(form) {
  if (has_blocks()) build_pattern();
}

void MassMatrix::build_pattern() {
  const Index n = table_.n;
  row_.assign(at(table_.functions()) + 1, 0);
  place_.resize(table_.slot.size() * at(n));
  std::vector<Index> coupled;
  for (Index f = 0; f < table_.functions(); ++f) {
    coupled.clear();
    for (Index s = table_.first[at(f)]; s < table_.first[at(f) + 1]; ++s) {
      const auto begin = table_.function.begin() + table_.slot[at(s)] / n * n;
      coupled.insert(coupled.end(), begin, begin + n);
    }
    std::ranges::sort(coupled);
    coupled.erase(std::unique(coupled.begin(), coupled.end()), coupled.end());
    for (Index s = table_.first[at(f)]; s < table_.first[at(f) + 1]; ++s)
      for (Index b = 0; b < n; ++b) {
        const Index other = table_.function[at(table_.slot[at(s)] / n * n + b)];
        place_[at(s) * at(n) + at(b)] = static_cast<Index>(std::ranges::lower_bound(coupled, other) - coupled.begin());
      }
    diagonal_place_.push_back(row_[at(f)] + static_cast<Index>(std::ranges::lower_bound(coupled, f) - coupled.begin()));
    column_.insert(column_.end(), coupled.begin(), coupled.end());
    row_[at(f) + 1] = static_cast<Index>(column_.size());
  }
  value_.resize(column_.size());
}

void MassMatrix::assemble(const OccupiedElements& occupied, const Eigen::VectorXd& row_sum,
                          const std::vector<double>& blocks) {
  count(Work::mass_matrices);
  row_sum_ = row_sum;
  diagonal_ = row_sum;
  ghost_ = nullptr;
  if (!has_blocks()) return;
  if (form_ == MassForm::partly_lumped) find_lumped(occupied);
  sum_blocks(occupied, blocks);
  if (form_ == MassForm::partly_lumped) move_to_diagonal();
  for (Index f = 0; f < table_.functions(); ++f) diagonal_[f] = value_[at(diagonal_place_[at(f)])];
}

void MassMatrix::add(const GhostMass::Matrix& ghost) {
  ghost_ = &ghost;
  diagonal_ += ghost.diagonal();
}

void MassMatrix::sum_blocks(const OccupiedElements& occupied, const std::vector<double>& blocks) {
  const Index n = table_.n;
#pragma omp parallel for schedule(static) if (worth_threads(value_.size()))
  for (Index f = 0; f < table_.functions(); ++f) {
    double* const row = &value_[at(row_[at(f)])];
    std::fill(row, row + (row_[at(f) + 1] - row_[at(f)]), 0.0);
    for (Index s = table_.first[at(f)]; s < table_.first[at(f) + 1]; ++s) {
      const Index slot = table_.slot[at(s)];
      const Index block = occupied.number[at(slot / n)];
      if (block < 0) continue;
      const double* from = &blocks[(at(block) * at(n) + at(slot % n)) * at(n)];
      const Index* to = &place_[at(s) * at(n)];
      for (Index b = 0; b < n; ++b) row[to[b]] += from[b];
    }
  }
}

void MassMatrix::find_lumped(const OccupiedElements& occupied) {
  is_lumped_.assign(at(table_.functions()), 0);
  for (Index f = 0; f < table_.functions(); ++f)
    for (Index s = table_.first[at(f)]; s < table_.first[at(f) + 1]; ++s)
      if (occupied.number[at(table_.slot[at(s)] / table_.n)] < 0) {
        is_lumped_[at(f)] = 1;
        break;
      }
}

void MassMatrix::move_to_diagonal() {
#pragma omp parallel for schedule(static) if (worth_threads(value_.size()))
  for (Index f = 0; f < table_.functions(); ++f) {
    double moved = 0.0;
    for (Index k = row_[at(f)]; k < row_[at(f) + 1]; ++k) {
      const Index g = column_[at(k)];
      if (g == f || (is_lumped_[at(f)] == 0 && is_lumped_[at(g)] == 0)) continue;
      moved += value_[at(k)];
      value_[at(k)] = 0.0;
    }
    value_[at(diagonal_place_[at(f)])] += moved;
  }
}

bool MassMatrix::lumped(Index function) const {
  return form_ == MassForm::lumped || (!is_lumped_.empty() && is_lumped_[at(function)] != 0);
}

const Eigen::Matrix2Xd& MassMatrix::times(const Eigen::Matrix2Xd& x) {
  product_.resize(2, x.cols());
  if (!has_blocks()) return product_ = x * diagonal_.asDiagonal();
#pragma omp parallel for schedule(static) if (worth_threads(value_.size()))
  for (Index f = 0; f < table_.functions(); ++f) {
    double sum_x = 0.0;
    double sum_y = 0.0;
    for (Index k = row_[at(f)]; k < row_[at(f) + 1]; ++k) {
      const double* const from = x.data() + 2 * column_[at(k)];
      sum_x += value_[at(k)] * from[0];
      sum_y += value_[at(k)] * from[1];
    }
    product_(0, f) = sum_x;
    product_(1, f) = sum_y;
  }
  if (ghost_ != nullptr) product_.transpose() += *ghost_ * x.transpose();
  return product_;
}

void MassMatrix::solve(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x, double tolerance) {
  if (!has_blocks() && !held.any_masters) return divide(held, f, x);
  iterate(held, f, x, tolerance);
}

void MassMatrix::divide(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x) const {
  x.resize(2, f.cols());
  for (Eigen::Index i = 0; i < f.cols(); ++i)
    x.col(i) = diagonal_[i] > 0.0 ? Vec2(f.col(i) / diagonal_[i]) : Vec2(Vec2::Zero());
  held.set(x, 1.0);
}

void MassMatrix::iterate(const HeldComponents& held, const Eigen::Matrix2Xd& f, Eigen::Matrix2Xd& x, double tolerance) {
  constexpr int most = 2000;
  inverse_.resize(2, f.cols());
  inverse_.row(0) = inverse_.row(1) = diagonal_.transpose();
  for (const Constraint& c : held.constraint) {
    for (const ComponentTerm& m : c.masters)
      inverse_(m.component, m.function) += m.coefficient * m.coefficient * diagonal_[c.function];
    inverse_(c.component, c.function) = 0.0;
  }
  inverse_ = inverse_.unaryExpr([](double d) { return d > 0.0 ? 1.0 / d : 0.0; });
  for (Eigen::Index i = 0; i < f.cols(); ++i)  // exact, also where the mass is too small to show in the residual
    if (lumped(static_cast<Index>(i))) x.col(i) = f.col(i).cwiseProduct(inverse_.col(i));
  x = (inverse_.array() > 0.0).select(x, 0.0);
  held.set(x, 1.0);
  residual_ = f - times(x);
  held.reduce(residual_);
  preconditioned_ = f;
  held.reduce(preconditioned_);
  const double load = preconditioned_.cwiseAbs2().cwiseProduct(inverse_).sum();
  preconditioned_ = residual_.cwiseProduct(inverse_);
  direction_ = preconditioned_;
  double size = residual_.cwiseProduct(preconditioned_).sum();
  const double target = tolerance * tolerance * (load + size);  // of |r|² in the norm of M⁻¹; a load may be missing
  for (int k = 0; k < most && size > target; ++k, ++iterations_) {
    held.set(direction_, 0.0);
    static_cast<void>(times(direction_));  // into product_
    held.reduce(product_);
    const double step = size / direction_.cwiseProduct(product_).sum();
    x += step * direction_;
    residual_ -= step * product_;
    preconditioned_ = residual_.cwiseProduct(inverse_);
    const double before = std::exchange(size, residual_.cwiseProduct(preconditioned_).sum());
    direction_ = preconditioned_ + size / before * direction_;
  }
  if (!(size <= target))
    throw ComputationError(fmt::format(
        "the mass matrix is singular to rounding: conjugate gradients stopped after {} iterations at {:.1e} of the "
        "right side; take {}more material points, or \"mass\": \"lumped\"",
        most, std::sqrt(size / target) * tolerance,
        form_ == MassForm::consistent ? "\"mass\": \"partly_lumped\", " : ""));
}

}  // namespace shoreline
