#pragma once
// The light half of results: what ParaView needs to know of the arrays in results.h5.

#include <string>

#include "shoreline/engine/material_points.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// The group of one step in results.h5.
[[nodiscard]] std::string step_group(const SavedStep& step);

/// A boundary's name as one link of an HDF5 path: '/', ':', '|', '%' and control characters as %XX, '.' too where it is
/// the whole name; no name is "%".
[[nodiscard]] std::string link_name(const std::string& name);

/// Tables of cells in results.h5 over n points: every point by itself, or all in one line.
[[nodiscard]] std::string vertices_table(Eigen::Index points);
[[nodiscard]] std::string line_table(Eigen::Index points);

/// The triangles of a sampled field in results.h5.
[[nodiscard]] std::string triangle_table();

/// The XDMF grids of one step, over arrays that have been written under step_group. No grid where there is no curve.
[[nodiscard]] std::string point_grid(const SavedStep& step, const MaterialPoints& points);

/// Whether a step is saved with the strain of its points.
[[nodiscard]] bool saves_strain(const SavedStep& step, const MaterialPoints& points);
[[nodiscard]] std::string curve_grid(const SavedStep& step);

/// A whole XDMF file. Two collections in time; the points are the last one, which is what readers of one mesh take.
[[nodiscard]] std::string xdmf(const std::string& curve_grids, const std::string& point_grids);

/// A whole XDMF file of one field.
[[nodiscard]] std::string xdmf(const SampledField& field);

}  // namespace shoreline
