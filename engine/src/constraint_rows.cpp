#include "constraint_rows.hpp"

#include <algorithm>
#include <cmath>

namespace shoreline {
namespace {

constexpr double implied = 1e-9;    ///< a row whose coefficients all are smaller follows from those before
constexpr double rounding = 1e-12;  ///< coefficients that would be zero in exact arithmetic

using Terms = ConstraintRow::Terms;

void add_multiple(double factor, const Terms& from, Terms& to) {
  for (const auto& [component, coefficient] : from) to[component] += factor * coefficient;
}

void erase_rounding(Terms& terms) {
  std::erase_if(terms, [](const auto& term) { return std::abs(term.second) < rounding; });
}

}  // namespace

/// Replaces every slave in a row by its masters; these may be slaves of later rows, so it goes on until none is left.
void ConstraintRows::substitute(Solved& row) const {
  for (auto term = row.coefficient.begin(); term != row.coefficient.end();) {
    const auto found = row_of_.find(term->first);
    if (found == row_of_.end()) {
      ++term;
      continue;
    }
    const Solved& given = rows_[found->second];
    const double factor = -term->second;
    row.coefficient.erase(term);
    add_multiple(factor, given.coefficient, row.coefficient);
    row.value += factor * given.value;
    for (const auto& [piece, terms] : given.parts) add_multiple(factor, terms, row.parts[piece]);
    term = row.coefficient.begin();
  }
  erase_rounding(row.coefficient);
}

void ConstraintRows::add(const ConstraintRow& asked) {
  Solved row{.coefficient = asked.coefficient, .value = asked.value, .piece = asked.piece, .parts = {}};
  row.parts[asked.piece] = asked.coefficient;
  substitute(row);
  const auto largest = std::ranges::max_element(row.coefficient, {}, [](const auto& t) { return std::abs(t.second); });
  if (largest == row.coefficient.end() || std::abs(largest->second) < implied) return;
  const double pivot = largest->second;
  row.slave = largest->first;
  row.coefficient.erase(largest);
  for (auto& [component, coefficient] : row.coefficient) coefficient /= pivot;
  row.value /= pivot;
  for (auto& [piece, terms] : row.parts)
    for (auto& [component, coefficient] : terms) coefficient /= pivot;
  row_of_.emplace(row.slave, rows_.size());
  rows_.push_back(std::move(row));
}

std::vector<Constraint> ConstraintRows::solved() const {
  std::vector<Constraint> constraints;
  constraints.reserve(rows_.size());
  for (Solved row : rows_) {
    substitute(row);
    Constraint& c = constraints.emplace_back();
    c = {row.slave / 2, row.slave % 2, row.piece, row.value};
    for (const auto& [component, coefficient] : row.coefficient)
      c.masters.push_back({component / 2, component % 2, -coefficient});
    for (auto& [piece, terms] : row.parts) {
      erase_rounding(terms);
      if (piece == row.piece) continue;
      for (const auto& [component, coefficient] : terms)
        c.others.push_back({piece, {component / 2, component % 2, coefficient}});
    }
  }
  return constraints;
}

}  // namespace shoreline
