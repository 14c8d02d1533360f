#include "element_table.hpp"

#include <algorithm>
#include <numeric>

namespace shoreline {

ElementTable::ElementTable(const Basis& basis) : parts(basis.grid().parts()), n(basis.functions_per_cell()) {
  const Index cells = basis.grid().cells();
  for (Index cell = 0; cell < cells; ++cell) {
    const ShortIndices here = basis.functions_of(cell);
    if (cell % parts == 0) function.insert(function.end(), here.begin(), here.end());
    const auto begin = function.end() - n;
    for (const Index f : here) place.push_back(static_cast<std::uint8_t>(std::find(begin, function.end(), f) - begin));
  }
  first.assign(static_cast<std::size_t>(basis.functions()) + 1, 0);
  for (const Index f : function) ++first[static_cast<std::size_t>(f) + 1];
  std::partial_sum(first.begin(), first.end(), first.begin());
  slot.resize(function.size());
  std::vector<Index> next(first.begin(), first.end() - 1);
  for (std::size_t s = 0; s < function.size(); ++s)
    slot[static_cast<std::size_t>(next[static_cast<std::size_t>(function[s])]++)] = static_cast<Index>(s);
}

bool OccupiedElements::find(const ElementTable& table, const std::vector<Index>& cell) {
  before_.swap(element);
  for (const Index e : before_) number[static_cast<std::size_t>(e)] = -1;
  number.resize(static_cast<std::size_t>(table.elements()), -1);
  element.clear();
  first_cell.clear();
  for (std::size_t c = 0; c < cell.size(); ++c) {
    const Index e = cell[c] / table.parts;
    if (!element.empty() && element.back() == e) continue;
    number[static_cast<std::size_t>(e)] = static_cast<Index>(element.size());
    element.push_back(e);
    first_cell.push_back(static_cast<Index>(c));
  }
  first_cell.push_back(static_cast<Index>(cell.size()));
  const bool others = element != before_;
  if (others) find_slots(table);
  return others;
}

void OccupiedElements::find_slots(const ElementTable& table) {
  first.clear();
  slot.clear();
  for (Index f = 0; f < table.functions(); ++f) {
    first.push_back(static_cast<Index>(slot.size()));
    for (Index s = table.first[static_cast<std::size_t>(f)]; s < table.first[static_cast<std::size_t>(f) + 1]; ++s) {
      const Index of_all = table.slot[static_cast<std::size_t>(s)];
      const Index e = number[static_cast<std::size_t>(of_all / table.n)];
      if (e >= 0) slot.push_back(e * table.n + of_all % table.n);
    }
  }
  first.push_back(static_cast<Index>(slot.size()));
}

}  // namespace shoreline
