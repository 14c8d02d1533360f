#pragma once
// A hard case on one discretisation, computed on many places of its grid, and what that tells.

#include <string>
#include <vector>

#include "shoreline/engine/case.hpp"
#include "shoreline/engine/quasi_static.hpp"

namespace shoreline::test {

/// How a body is discretised.
struct Discretisation {
  Case::BasisType basis = Case::BasisType::bilinear;
  int degree = 2;  ///< of B-splines
  EssentialMethod method = EssentialMethod::implicit_boundary;
  double ghost = 0.0;
  double band = 1e-3;  ///< δ/h
  bool narrows = false;
  bool fitted = false;  ///< weights, with p + 1 points along a cell; else clipped volumes
  int per_cell = 4;
};

/// The default band of the method and the basis, γ of the basis, and 4² points a cell (cubic B-splines 6²).
[[nodiscard]] Discretisation remedied(Case::BasisType basis, int degree, EssentialMethod method);

/// remedied() of every basis: bilinear, linear, Powell-Sabin, B-splines of degree 2 and 3.
[[nodiscard]] std::vector<Discretisation> every_basis(EssentialMethod method);

/// implicit_boundary and nitsche.
[[nodiscard]] std::vector<EssentialMethod> both_methods();

/// "bspline 2", "nitsche".
[[nodiscard]] std::string basis_name(const Discretisation& discretisation);
[[nodiscard]] std::string method_name(EssentialMethod method);

/// What one computation came to.
struct Outcome {
  std::string place;          ///< of the grid
  std::string failure;        ///< message of a refusal; empty: it went to its end
  std::string warning;        ///< on the stiffness, else the first
  bool singular = false;      ///< went on although the matrix was singular, (L.5)
  bool indefinite = false;    ///< Cholesky's factorisation does not exist
  double condition = 0.0;     ///< (L.3)
  double displacement = 0.0;  ///< relative L2 error
  double stress = 0.0;        ///< largest error at a point, relative to the largest stress
  double ghost_share = 0.0;   ///< share of the time of the load step that the ghost penalty took
  double weight_share = 0.0;  ///< that of fitted weights
  double seconds = 0.0;       ///< with reading the outline and filling it with points
};

/// Computes a case as it is; it has an exact solution.
[[nodiscard]] Outcome compute(const Case& problem);

/// The case with a basis, method, band, penalty and points; grid sizes and conditions stay.
[[nodiscard]] Case discretised(Case problem, const Discretisation& discretisation);

struct Spread {
  double median = 0.0;
  double largest = 0.0;
  [[nodiscard]] double ratio() const { return largest / median; }
};

/// Many computations of one case, as a row of a table.
struct Row {
  std::string label;
  Discretisation on;
  int runs = 0;
  int failures = 0;  ///< refused
  int singular = 0;  ///< went on with a warning
  int indefinite = 0;
  Spread condition{};  ///< over those that went to their end, as all below
  Spread displacement{};
  Spread stress{};
  double ghost_share = 0.0;   ///< median
  double weight_share = 0.0;  ///< median
  double seconds = 0.0;       ///< median
  std::string worst{};        ///< place of the grid of the first failure; else of the largest displacement error
  std::string said{};         ///< message of the first failure or the first warning
};

[[nodiscard]] Row summarised(std::string label, const Discretisation& on, const std::vector<Outcome>& outcomes);

/// Slides the grid through a cell: @p offsets places that fill it evenly, the same at each call.
[[nodiscard]] Row over_offsets(std::string label, const Case& problem, const Discretisation& on, int offsets);

/// One place of the grid.
[[nodiscard]] inline Row at_one_place(std::string label, const Case& problem, const Discretisation& on) {
  return over_offsets(std::move(label), problem, on, 1);
}

}  // namespace shoreline::test
