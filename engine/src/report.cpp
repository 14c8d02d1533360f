#include "shoreline/engine/report.hpp"

#include <fmt/format.h>

#include <optional>

namespace shoreline {
namespace {

std::string number(const std::optional<double>& value) { return value ? fmt::format("{:.3e}", *value) : "–"; }

std::string row(const std::string& name, const ErrorNorms::Component& error) {
  return fmt::format("  {:<20}{:>14}{:>14}{:>14}\n", name, number(error.mean_relative), number(error.mean_absolute),
                     number(error.max_absolute));
}

std::string errors_of(const ErrorNorms& errors) {
  std::string text = fmt::format("errors at {} {}\n{:<22}{:>14}{:>14}{:>14}\n", errors.places,
                                 errors.at_samples ? "sample points" : "material points", "", "mean relative",
                                 "mean absolute", "max absolute");
  text += row("displacement u [m]", errors.displacement[0]) + row("displacement v [m]", errors.displacement[1]);
  text += row("stress xx [Pa]", errors.stress[0]) + row("stress yy [Pa]", errors.stress[1]) +
          row("stress xy [Pa]", errors.stress[2]);
  text += fmt::format("  relative L2: displacement {}, stress {}; absolute {:.3e} m^2, {:.3e} Pa m\n",
                      number(errors.displacement_l2_relative), number(errors.stress_l2_relative),
                      errors.displacement_l2, errors.stress_l2);
  for (const ErrorNorms::OverTime& error : errors.over_time) {
    const char* unit = error.of == "displacement" ? "m" : error.of == "velocity" ? "m/s" : "Pa";
    text += fmt::format("  over time, {} [{}]: rms {:.3e}, mean of rms {:.3e}\n", error.of, unit, error.rms,
                        error.mean_rms);
  }
  for (const auto& [piece, error] : errors.boundary_l2_displacement)
    text += fmt::format("  L2 of displacement on {}: {:.3e} m^1.5\n", piece, error);
  for (const auto& [piece, radius] : errors.boundary_radius)
    text += fmt::format("  radius of {}: {:.7g} m, exact {:.7g} m, mean relative error {:.3e}\n", piece, radius.mean,
                        radius.exact, radius.mean_relative);
  return text;
}

std::string errors_of(const ProjectionErrors& errors) {
  std::string text =
      fmt::format("error of the projection: L2 {:.4e}, relative {}\n", errors.l2, number(errors.l2_relative));
  if (errors.derivative_l2)
    text += fmt::format("  of its derivatives: L2 {:.4e} (x), {:.4e} (y)\n", (*errors.derivative_l2)[0],
                        (*errors.derivative_l2)[1]);
  return text;
}

/// With an exact solution also the effectivity, the estimate over the error.
std::string estimate_of(const ErrorEstimate& estimate, const std::optional<ErrorNorms>& errors) {
  const bool known = errors && errors->stress_l2 > 0.0;
  return fmt::format("\nestimated error of stress: L2 {:.3e} Pa m, relative {}{}\n", estimate.stress_l2,
                     number(estimate.stress_l2_relative),
                     known ? fmt::format("; {:.3g} times the error", estimate.stress_l2 / errors->stress_l2) : "");
}

std::string fits_of(const Summary& summary) {
  std::string text = "\nprescribed displacements, error of the fit\n";
  for (const auto& [piece, error] : summary.displacement_fit)
    text += fmt::format("  {:<20}L2 {:.3e} m^1.5, mean {:.3e} m\n", piece, error.l2, error.mean);
  return summary.displacement_fit.empty() ? "" : text;
}

std::string probes_of(const Summary& summary) {
  std::string text = fmt::format("\n{:<22}{:>14}{:>14}\n", "probes", "u [m]", "v [m]");
  for (const Probe& probe : summary.probes) {
    const Vec2& at = probe.history.front().position;
    const Vec2& u = probe.history.back().displacement;
    text += fmt::format("  {:<20}{:>14.6g}{:>14.6g}  {} from ({:.6g}, {:.6g})\n", probe.name, u.x(), u.y(),
                        followed_by(probe), at.x(), at.y());
  }
  return summary.probes.empty() ? "" : text;
}

std::string dynamics_of(const Summary::Dynamics& d) {
  const auto line = [](const char* name, const std::string& value) { return fmt::format("  {:<20}{}\n", name, value); };
  std::string text = "\ndynamics\n" + line("law", d.law + (d.objective ? "" : ", not objective"));
  text += line("mass", d.mass);
  text += line("transfer", fmt::format("{:.6g} PIC, {:.6g} FLIP", d.pic, 1.0 - d.pic));
  if (d.damping > 0.0) text += line("damping", fmt::format("{:.6g}", d.damping));
  text += line("time step [s]",
               fmt::format("{:.4g} to {:.4g}, until t = {:.6g}", d.smallest_step, d.largest_step, d.end_time));
  text +=
      line("critical step [s]", fmt::format("{:.4g} at the start, smallest {:.4g} at t = {:.6g}",
                                            d.critical_step_at_start, d.smallest_critical_step, d.time_of_smallest));
  text += line("Courant number", fmt::format("{:.4g}", d.courant));
  return text + (d.dropped_points > 0 ? line("dropped points", fmt::format("{}", d.dropped_points)) : "");
}

std::string energies_of(const std::vector<HistoryState>& history) {
  std::string text =
      fmt::format("\n{:<22}{:>14}{:>14}{:>14}{:>14}\n", "energies [J/m]", "kinetic", "strain", "gravity", "total");
  const auto row = [&text](const char* name, const HistoryState& s) {
    text +=
        fmt::format("  {:<20}{:>14.6g}{:>14.6g}{:>14.6g}{:>14.6g}\n", name, s.kinetic, s.strain, s.gravity, s.total());
  };
  row("start", history.front());
  row("end", history.back());
  return text;
}

std::string diagnostics_of(const Diagnostics& d) {
  std::string text = "\nweak spots:";
  if (d.smallest_cut)
    text += fmt::format(" smallest cut {:.3g} of the cell around ({:.6g}, {:.6g});", d.smallest_cut->fraction,
                        d.smallest_cut->centre.x(), d.smallest_cut->centre.y());
  if (d.smallest_pivot)
    text += fmt::format(" smallest pivot {:.1e}, {} of the function at ({:.6g}, {:.6g})", d.smallest_pivot->value,
                        d.smallest_pivot->component == 0 ? "x" : "y", d.smallest_pivot->control_point.x(),
                        d.smallest_pivot->control_point.y());
  text += fmt::format("\n  fewest points in a cell {}; stray points {}", d.fewest_points, d.stray_points);
  if (d.first_stray) text += fmt::format(", first at ({:.6g}, {:.6g})", d.first_stray->x(), d.first_stray->y());
  return text + "\n";
}

std::string weights_of(const WeightReport& w) {
  std::string text =
      fmt::format("\nfitted weights: {:.0f} % of the points changed by more than a tenth, {} at the bound",
                  100.0 * w.changed, w.bounded);
  if (w.iterations > 0) text += fmt::format("; constraints unmet by up to {:.1e} of the largest", w.unmet);
  if (w.unserved > 0.0) text += fmt::format("; {:.1e} of the body lies in elements without points", w.unserved);
  return text + "\n";
}

std::string timings_of(const Summary& summary) {
  std::string text = fmt::format("{:<22}{:>14}\n", "time", "seconds");
  for (const auto& [phase, seconds] : summary.timings) text += fmt::format("  {:<20}{:>14.4f}\n", phase, seconds);
  return text;
}

}  // namespace

std::string report(const Summary& summary, const std::filesystem::path& output) {
  const auto plural = [](long n, const char* one) { return fmt::format("{} {}{}", n, one, n == 1 ? "" : "s"); };
  const char* step = summary.dynamics ? "step" : "load step";
  std::string text = fmt::format("{}: {}, {}{}, {}, {}\n", summary.title, summary.completed ? "completed" : "failed",
                                 summary.steps > 0 ? plural(summary.steps, step) + ", " : "",
                                 plural(summary.material_points, "material point"),
                                 plural(summary.degrees_of_freedom, "unknown"), plural(summary.threads, "thread"));
  if (summary.dynamics) text += dynamics_of(*summary.dynamics);
  if (!summary.history.empty()) text += energies_of(summary.history);
  if (summary.errors) text += "\n" + errors_of(*summary.errors);
  if (summary.error_estimate) text += estimate_of(*summary.error_estimate, summary.errors);
  if (summary.projection_errors) text += "\n" + errors_of(*summary.projection_errors);
  text += fits_of(summary) + probes_of(summary) + "\n" + timings_of(summary);
  if (summary.condition_estimate) text += fmt::format("\ncondition estimate: {:.2e}\n", *summary.condition_estimate);
  if (summary.strain_energy) text += fmt::format("\nstrain energy: {:.6e} J/m\n", *summary.strain_energy);
  if (summary.fitted_weights) text += weights_of(*summary.fitted_weights);
  if (summary.diagnostics) text += diagnostics_of(*summary.diagnostics);
  if (!summary.warnings.empty()) text += "\n";
  for (const std::string& warning : summary.warnings) text += "warning: " + warning + "\n";
  return text + "\nresults: " + output.string() + "\n";
}

}  // namespace shoreline
