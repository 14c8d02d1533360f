#include "quantities.hpp"

#include "output/results_reader.hpp"

namespace shoreline {
namespace {

/// Numbers among an object's values, lists and inner objects.
void collect(const Json& value, const std::string& name, std::map<std::string, double>& norms) {
  if (value.is_number_float() || value.is_number_integer()) norms[name] = value;
  if (!value.is_structured()) return;
  for (const auto& [key, entry] : value.items()) collect(entry, name + "." + key, norms);
}

}  // namespace

Json quantities_of(const Json& summary, const std::filesystem::path& folder) {
  Json found = Json::object();
  if (summary.contains("strain_energy")) found["energy"] = {summary["strain_energy"]};
  if (summary.contains("energy")) found["energy"] = {summary["energy"]["end"]["total"]};
  const Json reactions = summary.value("reactions", Json::object());
  for (const auto& [piece, reaction] : reactions.items()) found["reaction." + piece] = {reaction[0], reaction[1]};
  const Json probes = summary.value("probes", Json::object());
  for (const auto& [name, probe] : probes.items()) {
    found["probe." + name + ".displacement"] = probe["displacement"];
    if (probe.contains("stress")) found["probe." + name + ".stress"] = probe["stress"];
  }
  for (const auto& [piece, displacement] : curve_displacements(folder / "results.h5"))
    found["curve." + piece] = std::vector<double>(displacement.reshaped().begin(), displacement.reshaped().end());
  return found;
}

std::map<std::string, double> norms_of(const Json& summary) {
  std::map<std::string, double> norms;
  if (!summary.is_object()) return norms;
  const Json errors = summary.value("errors", Json::object());
  for (const auto& [field, of_field] : errors.items())
    if (of_field.is_object()) collect(of_field, field, norms);
  if (summary.contains("error_estimate")) collect(summary["error_estimate"], "error_estimate", norms);
  return norms;
}

}  // namespace shoreline
