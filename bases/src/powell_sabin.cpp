#include "shoreline/bases/powell_sabin.hpp"

#include "control_triangles.hpp"
#include "shoreline/bases/powell_sabin_refinement.hpp"

namespace shoreline {
namespace {

std::size_t at(Index number) { return static_cast<std::size_t>(number); }

/// Barycentric coordinates of x in a triangle: the three functions τ of (S.7). Where x lies on a side one of them is
/// zero, not rounding, so that functions vanish where they should.
Eigen::Vector3d barycentric(const std::array<Vec2, 3>& q, const Vec2& x) {
  constexpr double rounding = 1e-12;
  const Eigen::Vector3d twice(twice_area(x, q[1], q[2]), twice_area(q[0], x, q[2]), twice_area(q[0], q[1], x));
  const Eigen::Vector3d tau = (twice.array().abs() < rounding * twice.sum()).select(0.0, twice);
  return tau / tau.sum();
}

TriangleMesh checked_refinement(const TriangleMesh& mesh) {
  check(mesh);
  return powell_sabin_refinement(mesh);
}

}  // namespace

PowellSabinBasis::PowellSabinBasis(const TriangleMesh& mesh)
    : grid_(checked_refinement(mesh), powell_sabin_parts), control_(control_triangles(mesh, grid_.mesh())) {
  piece_.reserve(at(grid_.cells()));
  for (Index cell = 0; cell < grid_.cells(); ++cell) piece_.push_back(make_piece(mesh, cell));
}

PowellSabinBasis::Piece PowellSabinBasis::make_piece(const TriangleMesh& main, Index cell) const {
  const std::size_t k = at(cell % powell_sabin_parts / 2);
  const bool after = cell % 2 == 0;  // R lies on the edge after V_i, or on the one before it
  const auto& v = main.triangle[at(cell / powell_sabin_parts)];
  const std::array<Index, 3> vertex{v[k], v[(k + (after ? 1 : 2)) % 3], v[(k + (after ? 2 : 1)) % 3]};
  const std::array<Vec2, 3> p{main.vertex[at(vertex[0])], main.vertex[at(vertex[1])], main.vertex[at(vertex[2])]};
  const std::array<Vec2, 3> part = corners(grid_.mesh(), cell);
  const Vec2& r = after ? part[1] : part[2];
  const Vec2& z = after ? part[2] : part[1];

  Piece piece;
  piece.vertex = vertex;
  piece.origin = p[0];
  const Vec2 vr = r - p[0];
  const Vec2 vz = z - p[0];
  piece.slope_r = Vec2(vz.y(), -vz.x()) / cross(vr, vz);
  piece.slope_z = Vec2(-vr.y(), vr.x()) / cross(vr, vz);
  piece.lambda_j = vr.norm() / (p[1] - p[0]).norm();
  piece.lambda_i = 1.0 - piece.lambda_j;
  const Eigen::Vector3d opposite((p[2] - p[1]).norm(), (p[0] - p[2]).norm(), (p[1] - p[0]).norm());
  const Eigen::Vector3d a = opposite / opposite.sum();
  piece.a_i = a[0];
  piece.a_j = a[1];
  const auto tau = [&](std::size_t corner, const Vec2& end) {
    return barycentric(control_[at(vertex[corner])], 0.5 * (end - p[corner]));
  };
  piece.ordinate << tau(0, p[0]), tau(0, r), tau(0, z), piece.lambda_j * tau(1, r), tau(1, z), a[2] * tau(2, z);
  return piece;
}

ShortIndices PowellSabinBasis::functions_of(Index cell) const {
  ShortIndices functions(9);
  for (int a = 0; a < 9; ++a) functions[a] = 3 * piece_[at(cell)].vertex[at(a / 3)] + a % 3;
  return functions;
}

Vec2 PowellSabinBasis::control_point(Index function) const {
  return grid_.mesh().vertex[at(function / 3)] + control_[at(function / 3)][at(function % 3)];
}

template <class Point, class Number>
SHORELINE_INLINE void PowellSabinBasis::evaluate_all(Index cell, std::span<const Point> x, Number* value,
                                                     Number* gradient) const {
  const Piece& piece = piece_[at(cell)];
  const double li = piece.lambda_i;
  const double lj = piece.lambda_j;
  for (const Point& point : x) {
    const Number dx = point[0] - piece.origin.x();
    const Number dy = point[1] - piece.origin.y();
    const Number r = piece.slope_r.x() * dx + piece.slope_r.y() * dy;
    const Number s = piece.slope_z.x() * dx + piece.slope_z.y() * dy;
    const Number v = 1.0 - r - s;
    // The six functions of (S.9) and their derivatives by r and s.
    const Number f[6] = {
        v * v, r * (2 * v + li * r), s * (2 * v + 2 * li * r + piece.a_i * s), r * r, s * (2 * lj * r + piece.a_j * s),
        s * s};
    for (Eigen::Index q = 0; q < 3; ++q) {
      const auto o = piece.ordinate.row(q);
      value[q] = o[0] * f[0] + o[1] * f[1] + o[2] * f[2];
      value[3 + q] = o[3] * f[3] + o[4] * f[4];
      value[6 + q] = o[5] * f[5];
    }
    value += 9;
    if (gradient == nullptr) continue;
    const Number fr[5] = {-2 * v, 2 * (v - r + li * r), 2 * (li - 1) * s, 2 * r, 2 * lj * s};
    const Number fs[6] = {
        -2 * v, -2 * r, 2 * (v - s + li * r + piece.a_i * s), Number(0.0), 2 * (lj * r + piece.a_j * s), 2 * s};
    for (Eigen::Index d = 0; d < 2; ++d) {
      Number g[6];
      for (int c = 0; c < 5; ++c) g[c] = fr[c] * piece.slope_r[d] + fs[c] * piece.slope_z[d];
      g[5] = fs[5] * piece.slope_z[d];
      for (Eigen::Index q = 0; q < 3; ++q) {
        const auto o = piece.ordinate.row(q);
        gradient[2 * q + d] = o[0] * g[0] + o[1] * g[1] + o[2] * g[2];
        gradient[6 + 2 * q + d] = o[3] * g[3] + o[4] * g[4];
        gradient[12 + 2 * q + d] = o[5] * g[5];
      }
    }
    gradient += 18;
  }
}

void PowellSabinBasis::evaluate(Index cell, std::span<const Vec2> x, double* value, double* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

SHORELINE_CLONES void PowellSabinBasis::evaluate_lanes(Index cell, std::span<const LanePoint> x, Lanes* value,
                                                       Lanes* gradient) const {
  evaluate_all(cell, x, value, gradient);
}

void PowellSabinBasis::evaluate(Index cell, std::span<const LanePoint> x, Lanes* value, Lanes* gradient) const {
  evaluate_lanes(cell, x, value, gradient);
}

ShortCurvatures PowellSabinBasis::curvatures(Index cell, const Vec2& /*x*/) const {
  const Piece& piece = piece_[at(cell)];
  const auto product = [](const Vec2& a, const Vec2& b) {  // second derivatives of the product of two coordinates
    return Eigen::Vector3d(2 * a.x() * b.x(), 2 * a.y() * b.y(), a.x() * b.y() + a.y() * b.x());
  };
  const Vec2& r = piece.slope_r;
  const Vec2& s = piece.slope_z;
  const Vec2 v = -r - s;
  Eigen::Matrix<double, 3, 6> f;
  f << product(v, v), 2 * product(v, r) + piece.lambda_i * product(r, r),
      2 * product(v, s) + 2 * piece.lambda_i * product(r, s) + piece.a_i * product(s, s), product(r, r),
      2 * piece.lambda_j * product(r, s) + piece.a_j * product(s, s), product(s, s);
  ShortCurvatures second(3, 9);
  second << f.leftCols<3>() * piece.ordinate.leftCols<3>().transpose(),
      f.middleCols<2>(3) * piece.ordinate.middleCols<2>(3).transpose(), f.col(5) * piece.ordinate.col(5).transpose();
  return second;
}

}  // namespace shoreline
