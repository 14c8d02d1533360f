#include "weight_constraints.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "threads.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

constexpr int most_rows = 6 * max_support;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_rows, 1>;
using Centres = Eigen::Matrix<double, 2, Eigen::Dynamic, 0, 2, max_support>;

}  // namespace

WeightConstraints::WeightConstraints(Consistency consistency, const Basis& basis, const MaterialPoints& points,
                                     const PointSupports& supports)
    : moments_(consistency == Consistency::linear ? 3 : 1), basis_(basis), points_(points), supports_(supports) {
  evaluate_basis();
  const Index parts = basis.grid().parts();
  h_.assign(at(basis.functions()), 0.0);
  for (Index c = 0; c < supports.cells(); ++c) {
    const Index cell = supports.cell[at(c)];
    const double size = basis.grid().size(cell);
    for (const Index f : basis.functions_of(cell)) h_[at(f)] = std::max(h_[at(f)], size);
    if (c > 0 && supports.cell[at(c - 1)] / parts == cell / parts)
      ++element_.back().last_cell;
    else
      element_.push_back({c, c + 1});
  }
  seen_.assign(at(basis.functions()), 0);
  for (const Element& element : element_)
    for (const Index f : functions_of(element)) seen_[at(f)] = 1;
}

void WeightConstraints::evaluate_basis() {
  const auto n = at(supports_.functions);
  gradient_.resize(supports_.point.size() * 2 * n);
  if (moments_ > 1) value_.resize(supports_.point.size() * n);
#pragma omp parallel if (worth_threads(supports_.point.size()))
  {
    BasisAtPoints basis(basis_, supports_);
#pragma omp for schedule(static)
    for (Index c = 0; c < supports_.cells(); ++c) {
      const Index begin = supports_.first[at(c)];
      const auto count = at(supports_.first[at(c) + 1] - begin);
      basis.evaluate(c);
      std::copy_n(basis.gradient(begin), count * 2 * n, &gradient_[at(begin) * 2 * n]);
      if (moments_ > 1) std::copy_n(basis.value(begin), count * n, &value_[at(begin) * n]);
    }
  }
}

ShortIndices WeightConstraints::functions_of(const Element& element) const {
  return basis_.functions_of(supports_.cell[at(element.first_cell)]);
}

Eigen::Vector3d WeightConstraints::shape(Index function, const Vec2& x, const Vec2& centre) const {
  const double h = h_[at(function)];
  return {1.0, (x.x() - centre.x()) / h, (x.y() - centre.y()) / h};
}

template <class Use>
void WeightConstraints::for_points(const Element& element, Use&& use) const {
  const auto n = static_cast<std::size_t>(supports_.functions);
  const ShortIndices order = functions_of(element);
  ShortGradients gradient(2, order.size());
  for (Index c = element.first_cell; c < element.last_cell; ++c) {
    const ShortIndices here = basis_.functions_of(supports_.cell[at(c)]);
    std::array<Eigen::Index, max_support> place{};
    for (std::size_t a = 0; a < n; ++a)
      place[a] = std::find(order.begin(), order.end(), here[static_cast<Eigen::Index>(a)]) - order.begin();
    for (Index k = supports_.first[at(c)]; k < supports_.first[at(c) + 1]; ++k) {
      const double* const from = &gradient_[at(k) * 2 * n];
      for (std::size_t a = 0; a < n; ++a) gradient.col(place[a]) << from[2 * a], from[2 * a + 1];
      use(k, Vec2(points_.position.col(supports_.point[at(k)])), gradient);
    }
  }
}

Eigen::VectorXd WeightConstraints::right_side(const std::vector<Edge>& edges) const {
  Eigen::VectorXd side = Eigen::VectorXd::Zero(rows());
  for (const Edge& edge : edges)
    for (std::size_t k = 0; k < edge.points.size(); ++k) {
      const BoundaryPoint& p = edge.points[k];
      const Support support = basis_.support(edge.support_cell[edge.segment_of(k)], p.x);
      for (Eigen::Index a = 0; a < support.function.size(); ++a) {
        const Index f = support.function[a];
        const Eigen::Vector3d s = shape(f, p.x, basis_.control_point(f));
        for (int m = 0; m < moments_; ++m)
          side.segment<2>(2 * (moments_ * f + m)) -= p.weight * support.value[a] * s[m] * p.normal;
      }
    }
  if (moments_ == 1) return side;
  const auto n = static_cast<std::size_t>(supports_.functions);
  for (Index c = 0; c < supports_.cells(); ++c) {
    const ShortIndices functions = basis_.functions_of(supports_.cell[at(c)]);
    for (Index k = supports_.first[at(c)]; k < supports_.first[at(c) + 1]; ++k)
      for (std::size_t a = 0; a < n; ++a) {
        const Index f = functions[static_cast<Eigen::Index>(a)];
        const double part = points_.volume[supports_.point[at(k)]] * value_[at(k) * n + a] / h_[at(f)];
        side[2 * (3 * f + 1)] -= part;
        side[2 * (3 * f + 2) + 1] -= part;
      }
  }
  return side;
}

Eigen::VectorXd WeightConstraints::at_points(const Eigen::VectorXd& multiplier) const {
  Eigen::VectorXd change(static_cast<Eigen::Index>(supports_.point.size()));
#pragma omp parallel for schedule(static) if (worth_threads(supports_.point.size()))
  for (std::size_t e = 0; e < element_.size(); ++e) {
    const ShortIndices functions = functions_of(element_[e]);
    Centres centre(2, functions.size());
    for (Eigen::Index a = 0; a < functions.size(); ++a) centre.col(a) = basis_.control_point(functions[a]);
    for_points(element_[e], [&](Index k, const Vec2& x, const ShortGradients& gradient) {
      double sum = 0.0;
      for (Eigen::Index a = 0; a < functions.size(); ++a) {
        const Eigen::Vector3d s = shape(functions[a], x, centre.col(a));
        for (int m = 0; m < moments_; ++m)
          sum += s[m] * gradient.col(a).dot(multiplier.segment<2>(2 * (moments_ * functions[a] + m)));
      }
      change[k] = sum;
    });
  }
  return change;
}

Eigen::VectorXd WeightConstraints::sums(const Eigen::VectorXd& weight) const {
  std::vector<Rows> part(element_.size());
#pragma omp parallel for schedule(static) if (worth_threads(supports_.point.size()))
  for (std::size_t e = 0; e < element_.size(); ++e) {
    const ShortIndices functions = functions_of(element_[e]);
    Centres centre(2, functions.size());
    for (Eigen::Index a = 0; a < functions.size(); ++a) centre.col(a) = basis_.control_point(functions[a]);
    part[e] = Rows::Zero(2 * moments_ * functions.size());
    for_points(element_[e], [&](Index k, const Vec2& x, const ShortGradients& gradient) {
      for (Eigen::Index a = 0; a < functions.size(); ++a) {
        const Eigen::Vector3d s = shape(functions[a], x, centre.col(a));
        for (int m = 0; m < moments_; ++m)
          part[e].segment<2>(2 * (moments_ * a + m)) += weight[k] * s[m] * gradient.col(a);
      }
    });
  }
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(rows());
  for (std::size_t e = 0; e < element_.size(); ++e) {
    const ShortIndices functions = functions_of(element_[e]);
    for (Eigen::Index a = 0; a < functions.size(); ++a)
      sum.segment(2 * moments_ * functions[a], 2 * moments_) += part[e].segment(2 * moments_ * a, 2 * moments_);
  }
  return sum;
}

void WeightConstraints::blocks(const Eigen::VectorXd& weight, ElementBlocks& blocks) const {
  blocks.clear();
  std::vector<Index> pseudo;
  for (const Element& element : element_) {
    pseudo.clear();
    for (const Index f : functions_of(element))
      for (int m = 0; m < moments_; ++m) pseudo.push_back(moments_ * f + m);
    blocks.append(pseudo);
  }
#pragma omp parallel for schedule(static) if (worth_threads(supports_.point.size()))
  for (std::size_t e = 0; e < element_.size(); ++e) {
    const ShortIndices functions = functions_of(element_[e]);
    const Index first = supports_.first[at(element_[e].first_cell)];
    Eigen::MatrixXd root(2 * moments_ * functions.size(), supports_.first[at(element_[e].last_cell)] - first);
    for_points(element_[e], [&](Index k, const Vec2& x, const ShortGradients& gradient) {
      for (Eigen::Index a = 0; a < functions.size(); ++a) {
        const Eigen::Vector3d s = shape(functions[a], x, basis_.control_point(functions[a]));
        for (int m = 0; m < moments_; ++m)
          root.col(k - first).segment<2>(2 * (moments_ * a + m)) = std::sqrt(weight[k]) * s[m] * gradient.col(a);
      }
    });
    Eigen::MatrixXd squared = Eigen::MatrixXd::Zero(root.rows(), root.rows());
    squared.selfadjointView<Eigen::Lower>().rankUpdate(root);
    blocks.add(e, squared);
  }
}

}  // namespace shoreline
