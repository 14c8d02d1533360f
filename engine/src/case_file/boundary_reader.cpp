#include "boundary_reader.hpp"

#include <fmt/format.h>

#include <set>

#include "shoreline/boundary/short_forms.hpp"

namespace shoreline {
namespace {

Piece listed_points(const Node& node) {
  Piece piece;
  for (std::size_t i = 0; i < node.size(); ++i) {
    piece.points.push_back(node.entry(i).vector());
    if (i > 0 && piece.points[i] == piece.points[i - 1])
      node.entry(i).place.fail(
          fmt::format("found the same point twice, {}, expected two different points in succession",
                      described(node.entry(i).value)));
  }
  piece.closed = piece.points.front() == piece.points.back();
  if (piece.closed) piece.points.pop_back();
  if (piece.closed && piece.points.size() < 3)
    node.place.fail(
        fmt::format("found a closed piece of {} different points, expected at least 3", piece.points.size()));
  return piece;
}

Piece read_shape(const Node& node) {
  if (node.has("points")) return listed_points(node["points"]);
  if (node.has("line")) {
    const Node form = node["line"];
    return form.made([&] { return line(form["from"].vector(), form["to"].vector(), form["points"].as<int>()); });
  }
  if (node.has("arc")) {
    const Node form = node["arc"];
    return form.made([&] {
      return arc(form["centre"].vector(), form["radius"].as<double>(), form["from"].as<double>(),
                 form["to"].as<double>(), form["points"].as<int>());
    });
  }
  const Node form = node["circle"];
  return form.made([&] {
    return circle(form["centre"].vector(), form["radius"].as<double>(), form["points"].as<int>(),
                  form["hole"].as<bool>());
  });
}

std::vector<int> read_corners(const Node& node, const Piece& piece) {
  const int first = piece.closed ? 0 : 1;
  const int last = static_cast<int>(piece.points.size()) - (piece.closed ? 1 : 2);
  std::set<int> corners;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const int corner = node.entry(i).as<int>();
    if (corner < first || corner > last)
      node.entry(i).place.fail(
          first > last ? fmt::format("found {}, but the piece has no inner point", corner)
                       : fmt::format("found {}, expected the number of an inner point, {} to {}", corner, first, last));
    if (!corners.insert(corner).second)
      node.entry(i).place.fail(fmt::format("found {} twice, expected it once", corner));
  }
  return {corners.begin(), corners.end()};
}

Essential read_essential(const Node& node, const Known& known) {
  Essential essential{.normal_only = node["type"].is("roller") || node.has("normal")};
  if (node["method"].is("nitsche")) {
    essential.method = EssentialMethod::nitsche;
    essential.band = known.nitsche_band;
    essential.narrows = !node.has("band");
  } else if (node["method"].is("grid")) {
    essential.method = EssentialMethod::grid;
    if (node.has("band")) node["band"].place.fail("found a band, expected none with \"method\": \"grid\"");
  }
  if (node.has("band")) essential.band = node["band"].as<double>();
  return essential;
}

/// Whether a value is that of the exact solution.
bool from_exact(const Node& value, const Known& known) {
  if (value.is("exact") && !known.exact)
    value.place.fail("found \"exact\", expected the key \"exact\" in the case, which says what is exact");
  return value.is("exact");
}

Case::Traction read_traction(const Node& value, const Known& known) {
  if (from_exact(value, known)) return {Case::FromExact{}};
  return {read_pair(value, known.constants)};
}

Case::Displacement read_displacement(const Node& node, const Known& known) {
  const Essential support = read_essential(node, known);
  const Node value = node[support.normal_only ? "normal" : "value"];
  if (from_exact(value, known)) return {Case::FromExact{}, support};
  if (support.normal_only) return {read_quantity(value, known.constants), support};
  return {read_pair(value, known.constants), support};
}

Case::Condition read_condition(const Node& node, const Known& known) {
  if (node["type"].is("traction")) return read_traction(node["value"], known);
  if (node["type"].is("pressure")) return Case::Pressure{read_quantity(node["value"], known.constants)};
  if (node["type"].is("displacement")) return read_displacement(node, known);
  return read_essential(node, known);
}

}  // namespace

Quantity read_quantity(const Node& node, const Constants& constants) {
  if (node.value.is_number()) return node.as<double>();
  return read_expression(node, constants);
}

std::array<Quantity, 2> read_pair(const Node& node, const Constants& constants) {
  return {read_quantity(node.entry(0), constants), read_quantity(node.entry(1), constants)};
}

Expression read_expression(const Node& node, const Constants& constants) {
  return node.made([&] {
    return Expression(node.value.is_number() ? fmt::format("{}", node.as<double>()) : node.as<std::string>(),
                      constants);
  });
}

std::vector<Case::Boundary> read_boundaries(const Node& node, const Known& known) {
  std::vector<Case::Boundary> boundaries;
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Node entry = node.entry(i);
    Case::Boundary boundary{read_shape(entry), Case::Free{}};
    boundary.piece.name = entry["name"].as<std::string>();
    const auto [before, is_new] = seen.emplace(boundary.piece.name, i);
    if (!is_new)
      entry["name"].place.fail(fmt::format("found \"{}\", the name of boundary {} too, expected another",
                                           boundary.piece.name, before->second));
    boundary.piece.corners = read_corners(entry["corners"], boundary.piece);
    if (entry.has("condition")) boundary.condition = read_condition(entry["condition"], known);
    boundaries.push_back(std::move(boundary));
  }
  return boundaries;
}

std::vector<Case::Probe> read_probes(const Node& node) {
  std::vector<Case::Probe> probes;
  std::map<std::string, std::size_t> seen;
  for (std::size_t i = 0; i < node.size(); ++i) {
    const Node entry = node.entry(i);
    const bool at_place = entry.has("at") && entry["at"].is("place");
    probes.push_back({entry["name"].as<std::string>(), entry["position"].vector(), at_place});
    const auto [before, is_new] = seen.emplace(probes.back().name, i);
    if (!is_new)
      entry["name"].place.fail(
          fmt::format("found \"{}\", the name of probe {} too, expected another", probes.back().name, before->second));
  }
  return probes;
}

}  // namespace shoreline
