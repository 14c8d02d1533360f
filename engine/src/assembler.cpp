#include "shoreline/engine/assembler.hpp"

#include <omp.h>

#include <algorithm>
#include <numeric>
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
Lists blocks_of_functions(const ElementBlocks& blocks, Index functions) {
  Lists lists{.first = std::vector<Index>(at(functions) + 1, 0), .entry = std::vector<Index>(blocks.function.size())};
  for (const Index f : blocks.function) ++lists.first[at(f) + 1];
  std::partial_sum(lists.first.begin(), lists.first.end(), lists.first.begin());
  std::vector<Index> next(lists.first.begin(), lists.first.end() - 1);
  for (std::size_t b = 0; b < blocks.size(); ++b)
    for (Index k = blocks.first[b]; k < blocks.first[b + 1]; ++k)
      lists.entry[at(next[at(blocks.function[at(k)])]++)] = static_cast<Index>(b);
  return lists;
}

/// For each function the functions >= it that share a block with it, ascending.
Lists couplings(const ElementBlocks& blocks, Index functions) {
  const Lists blocks_of = blocks_of_functions(blocks, functions);
  const auto coupled = [&](Index f) -> const std::vector<Index>& {
    thread_local std::vector<Index> found;
    found.clear();
    for (Index k = blocks_of.first[at(f)]; k < blocks_of.first[at(f) + 1]; ++k) {
      const std::size_t b = at(blocks_of.entry[at(k)]);
      for (Index i = blocks.first[b]; i < blocks.first[b + 1]; ++i)
        if (blocks.function[at(i)] >= f) found.push_back(blocks.function[at(i)]);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  };
  return Lists::build(
      functions, [&](Index f) { return static_cast<Index>(coupled(f).size()); },
      [&](Index f, std::vector<Index>::iterator to) { std::ranges::copy(coupled(f), to); });
}

}  // namespace

bool Assembler::prepare(const ElementBlocks& blocks, const std::vector<Constraint>& constraints, Index functions) {
  const bool same_constraints = std::ranges::equal(constraints, constraints_, [](const auto& a, const auto& b) {
    return a.function == b.function && a.component == b.component;
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
  for (const Constraint& c : constraints_) equation_[at(2 * c.function + c.component)] = -1;
  unknown_.clear();
  for (std::size_t k = 0; k < equation_.size(); ++k) {
    if (equation_[k] < 0) continue;
    equation_[k] = equations();
    unknown_.push_back(static_cast<Index>(k));
  }
}

void Assembler::build_pattern(const ElementBlocks& blocks) {
  const Lists coupled = couplings(blocks, static_cast<Index>(equation_.size() / 2));
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

  place_.resize(blocks.matrix.size());
  places_.resize(blocks.size());
#pragma omp parallel for schedule(static) if (worth_threads(place_.size()))
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    std::size_t k = blocks.entry[b];
    const auto equation = [&](Index i) { return equation_[2 * at(function_[at(first_[b] + i / 2)]) + at(i % 2)]; };
    const Index m = 2 * (first_[b + 1] - first_[b]);
    for (Index j = 0; j < m; ++j)
      for (Index i = j; i < m; ++i, ++k) {
        const auto [c, r] = std::minmax({equation(i), equation(j)});
        if (c < 0) {
          place_[k] = -1;
          continue;
        }
        const auto begin = row_.begin() + column_[at(c)];
        place_[k] = static_cast<Index>(std::lower_bound(begin, row_.begin() + column_[at(c) + 1], r) - row_.begin());
      }
    const auto [low, high] = std::minmax_element(place_.begin() + static_cast<std::ptrdiff_t>(blocks.entry[b]),
                                                 place_.begin() + static_cast<std::ptrdiff_t>(k));
    places_[b] = {*low, *high};
  }
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
      if (places_[b].second < low || places_[b].first >= high) continue;
      for (std::size_t k = blocks.entry[b]; k < blocks.entry[b + 1]; ++k)
        if (place_[k] >= low && place_[k] < high) matrix.value[at(place_[k])] += blocks.matrix[k];
    }
  }
  for (std::size_t k = 0; k < blocks.function.size(); ++k)
    for (std::size_t c = 0; c < 2; ++c)
      if (const Index e = equation_[2 * at(blocks.function[k]) + c]; e >= 0) force[e] += blocks.force[2 * k + c];
  add_prescribed(blocks, force);
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
      for (std::size_t c = 0; c < 2; ++c)
        if (const Index e = equation_[2 * at(*f) + c]; e >= 0)
          force[e] -= product[2 * (f - begin) + static_cast<Eigen::Index>(c)];
  }
}

Eigen::Matrix2Xd Assembler::expand(const Eigen::VectorXd& solution) const {
  Eigen::Matrix2Xd increment = Eigen::Matrix2Xd::Zero(2, static_cast<Eigen::Index>(equation_.size() / 2));
  for (const Constraint& c : constraints_) increment(c.component, c.function) = c.value;
  for (Index e = 0; e < equations(); ++e) increment(unknown(e) % 2, unknown(e) / 2) = solution[e];
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
