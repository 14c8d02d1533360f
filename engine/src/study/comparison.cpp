#include "comparison.hpp"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace shoreline {
namespace {

Eigen::VectorXd vector_of(const Json& numbers) {
  Eigen::VectorXd vector(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    vector[static_cast<Eigen::Index>(i)] = numbers[i].is_number() ? numbers[i].get<double>() : std::nan("");
  return vector;
}

std::optional<std::size_t> finest_of(const std::vector<StudyRow>& rows) {
  std::optional<std::size_t> finest;
  const auto unknowns = [&](std::size_t r) { return rows[r].result.summary["degrees_of_freedom"].get<long>(); };
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].result.completed && (!finest || unknowns(r) >= unknowns(*finest))) finest = r;
  return finest;
}

std::string name_of(const StudyRow& row) { return fmt::format("{}", fmt::join(row.plan.labels, ", ")); }

/// The limit of three vectors; nothing where their differences do not fall.
std::optional<Eigen::VectorXd> limit_of(const Eigen::VectorXd& q1, const Eigen::VectorXd& q2,
                                        const Eigen::VectorXd& q3) {
  if (q1.size() != q2.size() || q2.size() != q3.size()) return std::nullopt;
  if (q2 == q3) return q3;
  const double growth = (q2 - q1).norm() / (q3 - q2).norm();
  if (!(growth > 1.0)) return std::nullopt;
  return q3 + (q3 - q2) / (growth - 1.0);
}

/// Completed rows on the line of one.
std::vector<std::size_t> line_of(const std::vector<StudyRow>& rows, std::size_t one) {
  std::vector<std::size_t> line;
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (rows[r].result.completed && rows[r].plan.line == rows[one].plan.line && rows[r].plan.refinement)
      line.push_back(r);
  return line;
}

}  // namespace

Comparison finest_run(const std::vector<StudyRow>& rows) {
  const auto finest = finest_of(rows);
  if (!finest) return {"no run completed, so there is nothing to compare with", Json(), {}};
  return {"differences from the finest run, " + name_of(rows[*finest]), rows[*finest].result.quantities, finest};
}

Comparison richardson_limit(const std::vector<StudyRow>& rows) {
  const auto finest = finest_of(rows);
  if (!finest) return finest_run(rows);
  const std::vector<std::size_t> line = line_of(rows, *finest);
  const std::string name = rows[*finest].plan.line;
  if (line.size() < 3)
    return {fmt::format("the line {} has {} completed runs, and a Richardson limit takes three", name, line.size()),
            Json(),
            {}};
  const auto run = [&](std::size_t from_last) -> const StudyRow& { return rows[line[line.size() - from_last]]; };
  const double first = *run(3).plan.refinement / *run(2).plan.refinement;
  const double second = *run(2).plan.refinement / *run(1).plan.refinement;
  if (std::abs(first / second - 1.0) > 0.01)
    return {
        fmt::format("the last three runs of {} are not refined by one ratio ({:.3g}, {:.3g}), as a Richardson limit "
                    "needs",
                    name, first, second),
        Json(),
        {}};
  Json limits = Json::object();
  for (const auto& [quantity, last] : run(1).result.quantities.items()) {
    const Json& before = run(2).result.quantities;
    const Json& first_of_three = run(3).result.quantities;
    if (!before.contains(quantity) || !first_of_three.contains(quantity)) continue;
    const auto limit = limit_of(vector_of(first_of_three[quantity]), vector_of(before[quantity]), vector_of(last));
    if (limit) limits[quantity] = std::vector<double>(limit->begin(), limit->end());
  }
  return {"differences from the Richardson limit of " + name, limits, {}};
}

void compare(const Comparison& comparison, StudyRow& row) {
  if (comparison.quantities.is_null() || !row.result.completed) return;
  for (const auto& [name, value] : row.result.quantities.items()) {
    if (!comparison.quantities.contains(name)) continue;
    const Eigen::VectorXd mine = vector_of(value);
    const Eigen::VectorXd reference = vector_of(comparison.quantities[name]);
    if (mine.size() != reference.size()) continue;
    const double size = reference.norm();
    row.norms[name] = (mine - reference).norm() / (size > 0.0 ? size : 1.0);
  }
}

}  // namespace shoreline
