#pragma once
// What a run without an exact solution can be compared by.

#include "case_file/json_text.hpp"

namespace shoreline {

/// Vectors of numbers by name: `energy` [J/m], `reaction.PIECE` (Fx, Fy) [N/m], `probe.NAME.displacement` [m],
/// `probe.NAME.stress` [Pa], `curve.PIECE`, the displacements of the points that draw a piece's curve [m].
///
/// @param summary  of a completed run
/// @param folder   that holds its results.h5
/// @throws OutputError if results.h5 cannot be read
[[nodiscard]] Json quantities_of(const Json& summary, const std::filesystem::path& folder);

/// Every norm in the summary's errors and estimate by its dotted name, `displacement.l2_relative`; null ones left out.
[[nodiscard]] std::map<std::string, double> norms_of(const Json& summary);

}  // namespace shoreline
