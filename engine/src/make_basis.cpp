#include "make_basis.hpp"

#include "shoreline/bases/bilinear.hpp"
#include "shoreline/bases/bspline.hpp"
#include "shoreline/bases/linear_triangle.hpp"
#include "shoreline/bases/powell_sabin.hpp"

namespace shoreline {
namespace {

TriangleMesh triangles(const Case::Grid& grid) {
  return grid.mesh ? *grid.mesh : triangulate(rectangles(grid), grid.pattern);
}

}  // namespace

std::unique_ptr<const Basis> make_basis(const Case::Grid& grid) {
  switch (grid.basis) {
    case Case::BasisType::linear:
      return std::make_unique<LinearTriangleBasis>(triangles(grid));
    case Case::BasisType::powell_sabin:
      return std::make_unique<PowellSabinBasis>(triangles(grid));
    case Case::BasisType::bspline:
      return std::make_unique<BSplineBasis>(rectangles(grid), grid.degree);
    case Case::BasisType::bilinear:
      break;
  }
  return std::make_unique<BilinearBasis>(rectangles(grid));
}

Vec2 rectangles_of(const Case::Grid& grid) {
  constexpr double whole = 1e-9;  // of a cell: an extent this little over whole cells is whole
  return ((grid.upper - grid.lower).cwiseQuotient(grid.cell_size).array() - whole).ceil().max(1.0);
}

QuadrilateralGrid rectangles(const Case::Grid& grid) {
  const Vec2 count = rectangles_of(grid);
  return {grid.lower, grid.cell_size, {static_cast<Index>(count.x()), static_cast<Index>(count.y())}};
}

const char* name_of(Case::BasisType basis) {
  switch (basis) {
    case Case::BasisType::linear:
      return "linear";
    case Case::BasisType::powell_sabin:
      return "powell_sabin";
    case Case::BasisType::bspline:
      return "bspline";
    case Case::BasisType::bilinear:
      break;
  }
  return "bilinear";
}

void name_basis(const Case::Grid& grid, Summary& summary) {
  summary.basis = name_of(grid.basis);
  if (grid.basis == Case::BasisType::bspline) summary.degree = grid.degree;
}

}  // namespace shoreline
