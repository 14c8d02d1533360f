#include "shoreline/engine/assembler.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>
#include <ranges>
#include <utility>

#include "threads.hpp"

namespace shoreline {
namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Lists of different length, one behind the other: list k is entry[first[k]] … entry[first[k + 1] − 1].
struct Lists {
  std::vector<Index> first;
  std::vector<Index> entry;

  /// Builds @p count lists in parallel from their lengths and a function that writes one to a place.
  template <class Length, class Write>
  static Lists build(Index count, Length&& length, Write&& write) {
    Lists lists{.first = std::vector<Index>(at(count) + 1, 0), .entry = {}};
#pragma omp parallel for schedule(static) if (worth_threads(at(count)))
    for (Index k = 0; k < count; ++k) lists.first[at(k) + 1] = length(k);
    std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
    lists.entry.resize(at(lists.first.back()));
#pragma omp parallel for schedule(static) if (worth_threads(at(count)))
    for (Index k = 0; k < count; ++k) write(k, lists.entry.begin() + lists.first[at(k)]);
    return lists;
  }
};

/// For each function the blocks in which it occurs.
/// @param block  functions of each block
Lists blocks_of_functions(const Lists& block, Index functions) {
  Lists lists{.first = std::vector<Index>(at(functions) + 1, 0), .entry = std::vector<Index>(block.entry.size())};
  for (const Index f : block.entry) ++lists.first[at(f) + 1];
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  std::vector<Index> next(lists.first.begin(), lists.first.end() - 1);
  for (std::size_t b = 0; b + 1 < block.first.size(); ++b)
    for (Index k = block.first[b]; k < block.first[b + 1]; ++k)
      lists.entry[at(next[at(block.entry[at(k)])]++)] = static_cast<Index>(b);
  return lists;
}

/// For each function the functions >= it that share a block with it, ascending.
/// @param block  functions of each block
Lists couplings(const Lists& block, Index functions) {
  const Lists blocks_of = blocks_of_functions(block, functions);
  const auto coupled = [&](Index f) -> const std::vector<Index>& {
    thread_local std::vector<Index> found;
    found.clear();
    for (Index k = blocks_of.first[at(f)]; k < blocks_of.first[at(f) + 1]; ++k) {
      const std::size_t b = at(blocks_of.entry[at(k)]);
      for (Index i = block.first[b]; i < block.first[b + 1]; ++i)
        if (block.entry[at(i)] >= f) found.push_back(block.entry[at(i)]);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  };
  return Lists::build(
      functions, [&](Index f) { return static_cast<Index>(coupled(f).size()); },
      [&](Index f, std::vector<Index>::iterator to) { std::ranges::copy(coupled(f), to); });
}

bool has_masters(const std::vector<Constraint>& constraints) {
  return std::ranges::any_of(constraints, [](const Constraint& c) { return !c.masters.empty(); });
}

/// The functions of each block and the masters of those that are constrained, which may be listed twice.
/// @param constraint_of  (2 · functions) the constraint with masters of each component, or none
template <class ConstraintOf>
Lists functions_with_masters(const ElementBlocks& blocks, ConstraintOf&& constraint_of) {
  Lists lists{.first = {0}, .entry = {}};
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    for (Index k = blocks.first[b]; k < blocks.first[b + 1]; ++k) {
      const Index f = blocks.function[at(k)];
      lists.entry.push_back(f);
      for (const Index unknown : {2 * f, 2 * f + 1})
        if (const Constraint* c = constraint_of(unknown))
          for (const ComponentTerm& m : c->masters) lists.entry.push_back(m.function);
    }
    lists.first.push_back(static_cast<Index>(lists.entry.size()));
  }
  return lists;
}

}  // namespace

bool Assembler::prepare(const ElementBlocks& blocks, const std::vector<Constraint>& constraints, Index functions) {
  const bool same_constraints = std::ranges::equal(constraints, constraints_, [](const auto& a, const auto& b) {
    return a.function == b.function && a.component == b.component && a.masters == b.masters;
  });
  constraints_ = constraints;
  if (same_constraints && blocks.first == first_ && blocks.function == function_ &&
      equation_.size() == 2 * at(functions))
    return true;
  first_ = blocks.first;
  function_ = blocks.function;
  number_unknowns(functions);
  build_pattern(blocks);
  return false;
}

void Assembler::number_unknowns(Index functions) {
  equation_.assign(2 * at(functions), -1);
  for (const Index f : function_) equation_[2 * at(f)] = equation_[2 * at(f) + 1] = 0;
  for (const Constraint& c : constraints_)
    if (equation_[at(2 * c.function + c.component)] == 0)
      for (const ComponentTerm& m : c.masters) equation_[at(2 * m.function + m.component)] = 0;
  for (std::size_t k = 0; k < constraints_.size(); ++k) {
    const Constraint& c = constraints_[k];
    equation_[at(2 * c.function + c.component)] = c.masters.empty() ? -1 : -2 - static_cast<Index>(k);
  }
  unknown_.clear();
  for (std::size_t k = 0; k < equation_.size(); ++k) {
    if (equation_[k] < 0) continue;
    equation_[k] = equations();
    unknown_.push_back(static_cast<Index>(k));
  }
}

void Assembler::build_pattern(const ElementBlocks& blocks) {
  const auto constraint_of = [&](Index unknown) {
    const Index e = equation_[at(unknown)];
    return e <= -2 ? &constraints_[at(-2 - e)] : nullptr;
  };
  const Lists functions =
      has_masters(constraints_) ? functions_with_masters(blocks, constraint_of) : Lists{first_, function_};
  const Lists coupled = couplings(functions, static_cast<Index>(equation_.size() / 2));
  const auto each_row = [&](Index e, auto&& use) {  // of the lower half of column e
    const std::size_t f = at(unknown(e) / 2);
    for (Index k = coupled.first[f]; k < coupled.first[f + 1]; ++k)
      for (const Index component : {0, 1})
        if (const Index row = equation_[at(2 * coupled.entry[at(k)] + component)]; row >= e) use(row);
  };
  Lists columns = Lists::build(
      equations(),
      [&](Index e) {
        Index rows = 0;
        each_row(e, [&](Index) { ++rows; });
        return rows;
      },
      [&](Index e, std::vector<Index>::iterator to) { each_row(e, [&](Index row) { *to++ = row; }); });
  column_ = std::move(columns.first);
  row_ = std::move(columns.entry);
  find_places(blocks);
  find_shares(blocks);
}

Index Assembler::place(Index row, Index column) const {
  const auto begin = row_.begin() + column_[at(column)];
  return static_cast<Index>(std::lower_bound(begin, row_.begin() + column_[at(column) + 1], row) - row_.begin());
}

void Assembler::find_places(const ElementBlocks& blocks) {
  place_.resize(blocks.matrix.size());
  places_.resize(blocks.size());
#pragma omp parallel for schedule(static) if (worth_threads(place_.size()))
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    std::size_t k = blocks.entry[b];
    const auto equation = [&](Index i) { return equation_[2 * at(function_[at(first_[b] + i / 2)]) + at(i % 2)]; };
    const Index m = 2 * (first_[b + 1] - first_[b]);
    for (Index j = 0; j < m; ++j) {
      const Index there = equation(j);
      std::pair<Index, Index> last{-1, -1};
      for (Index i = j; i < m; ++i, ++k) {
        const std::pair<Index, Index> now = std::minmax(equation(i), there);
        const auto [column, row] = now;
        const bool next_row = column == last.first && row == last.second + 1;  // stands next in the column
        place_[k] = column < 0 ? -1 : next_row ? place_[k - 1] + 1 : place(row, column);
        last = now;
      }
    }
    const auto [low, high] = std::minmax_element(place_.begin() + static_cast<std::ptrdiff_t>(blocks.entry[b]),
                                                 place_.begin() + static_cast<std::ptrdiff_t>(k));
    places_[b] = {*low, *high};
  }
}

/// Where the entries of Tᵀ K T come from that involve a component with masters.
void Assembler::find_shares(const ElementBlocks& blocks) {
  shares_.clear();
  if (!has_masters(constraints_)) return;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto unknown = [&](Index i) { return 2 * function_[at(first_[b] + i / 2)] + i % 2; };
    const auto given = [&](Index i) { return equation_[at(unknown(i))] <= -2; };
    const Index m = 2 * (first_[b + 1] - first_[b]);
    if (std::ranges::none_of(std::views::iota(0, m), given)) continue;
    std::size_t k = blocks.entry[b];
    for (Index j = 0; j < m; ++j)
      for (Index i = j; i < m; ++i, ++k) {
        if (!given(i) && !given(j)) continue;
        for (const Term& row : terms(unknown(i)))
          for (const Term& column : terms(unknown(j))) {
            if (i == j && row.equation < column.equation) continue;  // its mirror image is stored
            const auto [c, r] = std::minmax(row.equation, column.equation);
            const double both = i != j && r == c ? 2.0 : 1.0;  // (i, j) and (j, i) meet on the diagonal
            shares_.push_back({k, place(r, c), both * row.coefficient * column.coefficient});
          }
      }
  }
}

std::vector<Assembler::Term> Assembler::terms(Index unknown) const {
  const Index e = equation_[at(unknown)];
  if (e >= 0) return {{e, 1.0}};
  std::vector<Term> terms;
  if (e <= -2)
    for (const ComponentTerm& m : constraints_[at(-2 - e)].masters)
      terms.push_back({equation_[at(2 * m.function + m.component)], m.coefficient});
  return terms;
}

void Assembler::assemble(const ElementBlocks& blocks, SparseMatrix& matrix, Eigen::VectorXd& force) const {
  matrix.size = equations();
  matrix.column = column_;
  matrix.row = row_;
  matrix.value.resize(row_.size());
  force.setZero(equations());
#pragma omp parallel if (worth_threads(place_.size()))
  {
    // Each thread sums its own range of values over all blocks in order: no sum depends on the number of threads.
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    const auto me = static_cast<std::size_t>(omp_get_thread_num());
    const auto low = static_cast<Index>(row_.size() * me / threads);
    const auto high = static_cast<Index>(row_.size() * (me + 1) / threads);
    std::fill(matrix.value.begin() + low, matrix.value.begin() + high, 0.0);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const auto [first, last] = places_[b];
      if (last < low || first >= high) continue;
      const bool all = first >= low && last < high;
      for (std::size_t k = blocks.entry[b]; k < blocks.entry[b + 1]; ++k)
        if (all || (place_[k] >= low && place_[k] < high)) matrix.value[at(place_[k])] += blocks.matrix[k];
    }
    for (const Share& s : shares_)
      if (s.place >= low && s.place < high) matrix.value[at(s.place)] += s.factor * blocks.matrix[s.entry];
  }
  for (std::size_t k = 0; k < blocks.function.size(); ++k)
    for (const Index c : {0, 1}) add_force(2 * blocks.function[k] + c, blocks.force[2 * k + at(c)], force);
  add_prescribed(blocks, force);
}

void Assembler::add_force(Index unknown, double value, Eigen::VectorXd& force) const {
  const Index e = equation_[at(unknown)];
  if (e >= 0) force[e] += value;
  if (e <= -2)
    for (const Term& term : terms(unknown)) force[term.equation] += term.coefficient * value;
}

void Assembler::add_prescribed(const ElementBlocks& blocks, Eigen::VectorXd& force) const {
  if (std::ranges::all_of(constraints_, [](const Constraint& c) { return c.value == 0.0; })) return;
  const Eigen::Matrix2Xd prescribed = expand(Eigen::VectorXd::Zero(equations()));
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto begin = blocks.function.begin() + blocks.first[b];
    const auto end = blocks.function.begin() + blocks.first[b + 1];
    if (std::all_of(begin, end, [&](Index f) { return prescribed.col(f).isZero(0.0); })) continue;
    const Eigen::VectorXd product = blocks.times(b, prescribed);
    for (auto f = begin; f != end; ++f)
      for (const Index c : {0, 1}) add_force(2 * *f + c, -product[2 * (f - begin) + c], force);
  }
}

Eigen::Matrix2Xd Assembler::expand(const Eigen::VectorXd& solution) const {
  Eigen::Matrix2Xd increment = Eigen::Matrix2Xd::Zero(2, static_cast<Eigen::Index>(equation_.size() / 2));
  for (Index e = 0; e < equations(); ++e) increment(unknown(e) % 2, unknown(e) / 2) = solution[e];
  for (const Constraint& c : constraints_) {
    double& value = increment(c.component, c.function) = c.value;
    for (const ComponentTerm& m : c.masters) value += m.coefficient * increment(m.component, m.function);
  }
  return increment;
}

Eigen::Matrix2Xd Assembler::reactions(const ElementBlocks& blocks, const Eigen::Matrix2Xd& increment) const {
  std::vector<char> held(equation_.size() / 2, 0);
  for (const Constraint& c : constraints_) held[at(c.function)] = 1;
  Eigen::Matrix2Xd force = Eigen::Matrix2Xd::Zero(2, increment.cols());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const auto begin = blocks.function.begin() + blocks.first[b];
    const auto end = blocks.function.begin() + blocks.first[b + 1];
    if (std::none_of(begin, end, [&](Index f) { return held[at(f)]; })) continue;
    const Eigen::VectorXd residual = blocks.times(b, increment) - blocks.force_of(b);
    for (auto f = begin; f != end; ++f) force.col(*f) += residual.segment<2>(2 * (f - begin));
  }
  return force;
}

}  // namespace shoreline
