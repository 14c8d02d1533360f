#pragma once
// Macro-elements: groups of neighbouring elements, on each of which the projected dilatation is one polynomial.

#include <vector>

#include "shoreline/bases/basis.hpp"

namespace shoreline {

/// The polynomials x^a y^b with a + b <= degree, or with a, b <= degree.
struct PolynomialSpace {
  int degree;
  bool tensor = false;  ///< a, b <= degree

  /// Number of polynomials m.
  [[nodiscard]] Eigen::Index size() const {
    return tensor ? (degree + 1) * (degree + 1) : (degree + 1) * (degree + 2) / 2;
  }
  /// 1, x, x², …, y, x y, … at a place, (m).
  [[nodiscard]] Eigen::VectorXd operator()(const Vec2& x) const;
};

/// Every element of a grid belongs to one macro-element.
struct MacroElements {
  std::vector<Index> of_element;  ///< (elements) the number of its macro-element, from 0
  Index count;
  PolynomialSpace polynomials;  ///< on each of them
};

/// The macro-elements of a basis of degree p, (I.2): on rectangles blocks of 3 × 3 cells, or up to 5 where a grid is
/// not that wide; on triangles those around a vertex and what is left between them. They depend on the grid alone.
[[nodiscard]] MacroElements macro_elements(const Basis& basis);

/// Macro-elements with those that are less than half full joined to others, (I.8), so that none is a sliver at the edge
/// of the body; the numbers of what is joined are not used any more.
/// @param volume  (elements) of the material points in each [m²]
[[nodiscard]] MacroElements without_slivers(MacroElements groups, const Grid& grid, const std::vector<double>& volume);

}  // namespace shoreline
