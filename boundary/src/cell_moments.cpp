#include <algorithm>
#include <cmath>

#include "closed_spans.hpp"
#include "grid_crossings.hpp"
#include "message.hpp"
#include "shoreline/bases/quadrature.hpp"
#include "shoreline/boundary/region.hpp"
#include "shoreline/boundary/trace.hpp"

namespace shoreline {
namespace {

/// Integrals of ξ^a η^b over [−w/2, w/2] × [−h/2, h/2], direction by direction, and how monomials are numbered.
struct Monomials {
  Monomials(int highest, const Vec2& spacing)
      : order(highest), across(powers_integral(spacing.x())), along(powers_integral(spacing.y())) {}

  [[nodiscard]] Eigen::Index count() const { return (order + 1) * (order + 2) / 2; }

  /// ∫∫ ξ^a η^b of all monomials where the integrals over η are @p eta.
  [[nodiscard]] Eigen::VectorXd full_width(const Eigen::VectorXd& eta) const {
    Eigen::VectorXd moments(count());
    for (int degree = 0, m = 0; degree <= order; ++degree)
      for (int b = 0; b <= degree; ++b, ++m) moments[m] = across[degree - b] * eta[b];
    return moments;
  }

  int order;
  Eigen::VectorXd across;  ///< (order + 1) ∫ ξ^a dξ
  Eigen::VectorXd along;   ///< (order + 1) ∫ η^b dη

 private:
  [[nodiscard]] Eigen::VectorXd powers_integral(double width) const {
    Eigen::VectorXd integral = Eigen::VectorXd::Zero(order + 1);
    for (int a = 0; a <= order; a += 2) integral[a] = 2.0 * std::pow(0.5 * width, a + 1) / (a + 1);
    return integral;
  }
};

/// A part of a span in one cell of the lattice.
struct Run {
  Index cell;
  const CubicSpan* span;
  double begin;
  double end;
};

/// The parts of the spans in the cells, in the order of the cells. On a line between two cells either serves: moments
/// are continuous across it.
std::vector<Run> runs_in_cells(std::span<const CubicSpan> spans, const QuadrilateralGrid& lattice) {
  const Box box = lattice.bounds();
  const Vec2 tolerance = 1e-9 * lattice.spacing();
  std::vector<Run> runs;
  for (const CubicSpan& span : spans) {
    const std::vector<double> u = split_at_lines(span, lattice);
    for (std::size_t i = 0; i + 1 < u.size(); ++i) {
      const Vec2 x = span.position(0.5 * (u[i] + u[i + 1]));
      const Vec2 inside = x.cwiseMax(box.lower).cwiseMin(box.upper);
      if (((x - inside).cwiseAbs().array() > tolerance.array()).any())
        throw OutsideGrid("cell_moments: a curve leaves the lattice at " + text(x) + "; the lattice reaches from " +
                          text(box.lower) + " to " + text(box.upper));
      runs.push_back({lattice.locate(inside, 0).value(), &span, u[i], u[i + 1]});
    }
  }
  std::ranges::sort(runs, {}, &Run::cell);
  return runs;
}

/// What one part of the curve adds: to its own cell, and by its height to all cells on its right.
struct Sweep {
  Eigen::VectorXd own;     ///< (monomials) −∫ (Ξ_a(w/2) − Ξ_a(ξ)) η^b dη, Ξ_a = ξ^{a+1}/(a+1)
  Eigen::VectorXd height;  ///< (order + 1) −∫ η^b dη
};

void add_run(const Run& run, const QuadrilateralGrid& lattice, const QuadratureRule& rule, Sweep& sweep) {
  const Eigen::Index order = sweep.height.size() - 1;
  const Vec2 half = 0.5 * lattice.spacing();
  const Vec2 centre = lattice.corner(run.cell) + half;
  const double width = run.end - run.begin;
  for (Eigen::Index q = 0; q < rule.point.size(); ++q) {
    const double u = run.begin + width * rule.point[q];
    const Vec2 x = run.span->position(u) - centre;
    const double deta = rule.weight[q] * width * run.span->derivative(u).y();
    Eigen::Matrix<double, max_moment_order + 1, 1> strip;  // ∫_ξ^{w/2} ξ^a dξ
    Eigen::Matrix<double, max_moment_order + 1, 1> eta;    // η^b
    double xi_power = x.x();
    double half_power = half.x();
    double eta_power = 1.0;
    for (Eigen::Index a = 0; a <= order; ++a) {
      strip[a] = (half_power - xi_power) / static_cast<double>(a + 1);
      eta[a] = eta_power;
      xi_power *= x.x();
      half_power *= half.x();
      eta_power *= x.y();
    }
    for (Eigen::Index degree = 0, m = 0; degree <= order; ++degree)
      for (Eigen::Index b = 0; b <= degree; ++b, ++m) sweep.own[m] -= strip[degree - b] * eta[b] * deta;
    sweep.height -= eta.head(order + 1) * deta;
  }
}

/// Covered cells and their moments as they are found, cell by cell.
class Collector {
 public:
  explicit Collector(double cell_area) : least_(1e-13 * cell_area) {}

  void add(Index cell, const Eigen::VectorXd& moments) {
    if (std::abs(moments[0]) <= least_) return;
    cells_.push_back(cell);
    moments_.insert(moments_.end(), moments.begin(), moments.end());
  }

  [[nodiscard]] CellMoments take(Eigen::Index monomials) && {
    const Eigen::Map<const Eigen::MatrixXd> matrix(moments_.data(), monomials,
                                                   static_cast<Eigen::Index>(cells_.size()));
    return {std::move(cells_), matrix};
  }

 private:
  double least_;
  std::vector<Index> cells_;
  std::vector<double> moments_;
};

}  // namespace

CellMoments cell_moments(std::span<const SplineCurve> curves, const QuadrilateralGrid& lattice, int order) {
  if (order < 0 || order > max_moment_order)
    throw InvalidArgument("cell_moments: order must be 0 to " + std::to_string(max_moment_order) + ", got " +
                          std::to_string(order));
  const std::vector<CubicSpan> spans = closed_spans(curves);
  const std::vector<Run> runs = runs_in_cells(spans, lattice);
  const QuadratureRule rule = gauss((3 * order + 6 + 1) / 2);  // degree 3 (order + 1) + 2
  const Monomials monomials(order, lattice.spacing());
  const Eigen::VectorXd full = monomials.full_width(monomials.along);

  Collector covered(full[0]);
  Eigen::VectorXd height = Eigen::VectorXd::Zero(order + 1);  // −∫ η^b dη of the row's curves left of the cell
  for (auto run = runs.begin(); run != runs.end();) {
    const Index cell = run->cell;
    Sweep sweep{monomials.full_width(height), Eigen::VectorXd::Zero(order + 1)};
    for (; run != runs.end() && run->cell == cell; ++run) add_run(*run, lattice, rule, sweep);
    covered.add(cell, sweep.own);
    height += sweep.height;

    const Index row_end = (cell / lattice.columns() + 1) * lattice.columns();
    const Index next = run == runs.end() ? row_end : std::min(run->cell, row_end);
    const double winding = std::round(height[0] / monomials.along[0]);
    if (cell + 1 == next && next != row_end) continue;
    for (Index whole = cell + 1; whole < next; ++whole) covered.add(whole, winding * full);
    height = winding * monomials.along;  // drops rounding errors; 0 at the end of a row
  }
  return std::move(covered).take(monomials.count());
}

}  // namespace shoreline
