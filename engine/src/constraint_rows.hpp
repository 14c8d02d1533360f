#pragma once
// Linear conditions on displacement components, each solved for one of them.

#include <map>
#include <vector>

#include "shoreline/engine/assembler.hpp"

namespace shoreline {

/// Σ coefficient · component = value, (C.3).
struct ConstraintRow {
  using Terms = std::map<Index, double>;  ///< coefficient of component 2·function + component

  Terms coefficient;
  double value = 0.0;  ///< [m]
  int piece = 0;       ///< boundary piece that asks for it
};

/// Independent conditions in echelon form.
class ConstraintRows {
 public:
  /// Adds a condition, unless those before imply it.
  /// @param row  with coefficients whose largest is of order 1
  void add(const ConstraintRow& row);

  /// The conditions solved: no slave is a master, (C.4).
  [[nodiscard]] std::vector<Constraint> solved() const;

 private:
  /// A condition after others were put in.
  struct Solved {
    Index slave = -1;                  ///< coefficient 1; in no later row
    ConstraintRow::Terms coefficient;  ///< of the others
    double value;
    int piece;
    std::map<int, ConstraintRow::Terms> parts;  ///< by piece; all components together are the row
  };
  void substitute(Solved& row) const;

  std::vector<Solved> rows_;
  std::map<Index, std::size_t> row_of_;  ///< by slave
};

}  // namespace shoreline
