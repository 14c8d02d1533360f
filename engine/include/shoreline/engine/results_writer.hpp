#pragma once
// The files of a run: results.h5 for programs, results.xdmf beside it for viewers.

#include <filesystem>
#include <string>

#include "shoreline/bases/grid.hpp"
#include "shoreline/engine/material_points.hpp"
#include "shoreline/engine/results.hpp"

namespace shoreline {

/// Writes saved steps to results.h5 and results.xdmf, which ParaView opens as it is.
///
/// results.h5, arrays row by row, one row a point; each carries its unit as the attribute "unit":
///
///     steps/000012                    attributes step, t
///       points/position               (n, 3) [m], z = 0: viewers live in space
///       points/displacement           (n, 3) [m], z = 0
///       points/stress                 (n, 4) xx, yy, xy, zz [Pa]
///       points/strain                 (n, 3) xx, yy, xy (engineering) [1]
///       points/volume                 (n) [m^2], m³ per metre of thickness
///       points/velocity               (n, 3) [m/s], z = 0; dynamics alone
///       points/stress_error_estimate  (n) |σ* − σ| [Pa], (Z.2); of the last step, where asked for
///       curves/NAME/points            (k, 3) tracking points [m]
///       curves/NAME/polyline          (m, 3) the spline, sampled [m]
///     probes/NAME/t                   (steps + 1), whatever steps are saved above; [s] in dynamics
///     probes/NAME/position            (steps + 1, 2) [m]
///     probes/NAME/displacement        (steps + 1, 2) [m]
///     probes/NAME/stress              (steps + 1, 4) xx, yy, xy, zz [Pa]; not of tracking points
///     probes/NAME/velocity            (steps + 1, 2) [m/s]; dynamics alone
///     probes/NAME/exact_displacement  (steps + 1, 2) [m]; dynamics with an exact solution alone
///     probes/NAME/exact_velocity      (steps + 1, 2) [m/s]; likewise
///     history/t                       (k) [s]; dynamics alone
///     history/kinetic, strain, gravity, total  (k) [J/m]
///     history/momentum                (k, 2) [N s/m]
///     field/position                  (n, 3) of a projection: corners of triangles that cover its cells [m], z = 0
///     field/value, field/error        (n)
///     grid/edges                      (e, 4) x, y of both ends [m]
///     connectivity                    the cells of results.xdmf
///
/// NAME is that of the boundary or probe, with '/', ':', '|', '%' and control characters as %XX; its attribute "name"
/// is the name itself. The attributes "title" and "analysis" of the root are those of the case. The file is closed
/// between two steps: it can be read while the run goes on, and after it was killed.
class ResultsWriter {
 public:
  /// Creates @p folder and an empty results.h5 in it. Removes what an earlier run left there of summary.json,
  /// results.xdmf and pictures, so that no old result lies beside a new one.
  ///
  /// @param title     of the case
  /// @param grid      drawn in the picture where it has at most 10⁴ cells
  /// @param analysis  its type; that of Summary
  /// @throws OutputError with path and reason
  ResultsWriter(std::filesystem::path folder, const std::string& title, const Grid& grid,
                const std::string& analysis = "quasi_static");
  ~ResultsWriter();
  ResultsWriter(const ResultsWriter&) = delete;
  ResultsWriter& operator=(const ResultsWriter&) = delete;

  /// Appends one step to results.h5 and rewrites results.xdmf, by rename; beyond 50 steps with every 2 % more of them
  /// and at the end, so that its cost stays in proportion.
  /// @throws OutputError with path and reason
  void write(const SavedStep& step, const MaterialPoints& points);

  /// Writes the field of a projection to results.h5, and results.xdmf.
  /// @throws OutputError with path and reason
  void write(const SampledField& field);

  /// Appends to results.h5 what the history of every probe has gained since the call before.
  /// @throws OutputError with path and reason
  void append(const std::vector<Probe>& probes);

  /// Appends to results.h5 the energies and momenta that @p history has gained since the call before.
  /// @throws OutputError with path and reason
  void append(const std::vector<HistoryState>& history);

 private:
  void write_index();

  std::filesystem::path folder_;
  std::string unit_of_time_;
  int saved_ = 0;             ///< steps in results.h5
  int indexed_ = 0;           ///< of them in results.xdmf
  std::size_t recorded_ = 0;  ///< states of every probe in results.h5
  std::size_t energies_ = 0;  ///< states of the history in results.h5
  std::string point_grids_;   ///< of results.xdmf, one a step
  std::string curve_grids_;
};

}  // namespace shoreline
