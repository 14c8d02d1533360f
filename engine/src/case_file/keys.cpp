#include "keys.hpp"

#include "shoreline/engine/case.hpp"

namespace shoreline::keys {
namespace {

constexpr double huge = 1e30;           // beyond, squares of stresses and stiffnesses could overflow
constexpr std::size_t many = 10000000;  // entries of a list that a person or script might still write

/// Whether a key may be missing, and what it is then.
struct Presence {
  bool required;
  Json fallback;
};
const Presence required{true, {}};
const Presence optional{false, {}};
Presence otherwise(Json fallback) { return {false, std::move(fallback)}; }

Key key(std::string name, Schema schema, Presence presence, std::string unit, std::string meaning) {
  return {std::move(name),   std::move(schema), std::move(unit), presence.required, std::move(presence.fallback),
          std::move(meaning)};
}

Schema any_number() { return {Number{{-huge, huge}}}; }
Schema positive_number() { return {Number{{0.0, huge, true}}}; }
Schema coordinate() { return {Number{{-1e9, 1e9}}}; }
Schema length() { return {Number{{0.0, 1e9, true}}}; }
Schema list(Schema entry, std::size_t at_least, std::size_t at_most) {
  return {List{std::make_shared<const Schema>(std::move(entry)), at_least, at_most}};
}
Schema several(std::size_t n, Schema entry) { return list(std::move(entry), n, n); }
Schema position() { return several(2, coordinate()); }
Schema one_or_pair(const Schema& entry) { return {Either{{entry, several(2, entry)}}}; }

Schema analysis() {
  const Object quasi_static{
      {key("plane", {Choice{{"strain", "stress"}}}, required, "", "plane strain or plane stress"),
       key("load_steps", {Integer{1, 1000000}}, otherwise(Case{}.load_steps), "",
           "equal steps N; t = k/N at the end of step k"),
       key("load", {Formula{}}, optional, "",
           "load factor, an expression of t by which plain numbers ramp; default t itself"),
       key("loading", {Choice{{"residual", "incremental"}}}, otherwise("residual"), "",
           "what a step balances: the whole load less what is carried already, or the increment of load alone")},
      {}};
  return {Tagged{{{"quasi_static", quasi_static}}}};
}

Schema material() {
  const Object linear_elastic{{key("youngs_modulus", positive_number(), required, "Pa", "E"),
                               key("poissons_ratio", {Number{{-1.0, 0.5, true, true}}}, required, "", "ν"),
                               key("density", positive_number(), optional, "kg/m³", "ρ; needed by `gravity`")},
                              {}};
  return {Tagged{{{"linear_elastic", linear_elastic}}}};
}

Schema grid() {
  return {Object{
      {key("cells", {Choice{{"quadrilateral"}}}, otherwise("quadrilateral"), "", "shape of the cells"),
       key("basis", {Choice{{"bilinear"}}}, otherwise("bilinear"), "", "basis functions on the cells"),
       key("lower", position(), required, "m", "lower left corner"),
       key("upper", position(), required, "m",
           "upper right corner, moved out to whole cells; above and right of `lower`"),
       key("cell_size", one_or_pair(length()), required, "m", "width and height of a cell; at most 1e8 cells in all")},
      {}}};
}

Schema line() {
  return {
      Object{{key("from", position(), required, "m", "first point"), key("to", position(), required, "m", "last point"),
              key("points", {Integer{2, 1000000}}, otherwise(2), "", "number of tracking points")},
             {}}};
}

Schema arc() {
  const Schema angle{Number{{-3600.0, 3600.0}}};
  return {Object{{key("centre", position(), required, "m", "centre"), key("radius", length(), required, "m", "radius"),
                  key("from", angle, required, "°", "angle of the first point, counter-clockwise from +x"),
                  key("to", angle, required, "°", "angle of the last point; less than a full turn from `from`"),
                  key("points", {Integer{2, 1000000}}, otherwise(9), "", "number of tracking points")},
                 {}}};
}

Schema circle() {
  return {Object{{key("centre", position(), required, "m", "centre"), key("radius", length(), required, "m", "radius"),
                  key("points", {Integer{3, 1000000}}, otherwise(16), "", "number of tracking points"),
                  key("hole", {Boolean{}}, otherwise(false), "", "runs clockwise, with the material outside")},
                 {}}};
}

Object held() {
  return {{key("method", {Choice{{"implicit_boundary", "nitsche", "grid"}}}, otherwise("implicit_boundary"), "",
               "how the condition enters: penalty of a band, the same made consistent, or elimination on grid lines"),
           key("band", {Number{{0.0, 0.1, true}}}, optional, "",
               "width of the band δ/h in cells; default 1e-3 for `implicit_boundary`, 0.01 for `nitsche`; "
               "not with `grid`")},
          {}};
}

Schema condition() {
  const Schema vector_or_exact{Either{{several(2, {Formula{}}), {Choice{{"exact"}}}}}};
  const Object traction{{key("value", vector_or_exact, required, "Pa",
                             "force per area on the body, x and y; `exact`: of the exact solution")},
                        {}};
  const Object pressure{{key("value", {Formula{}}, required, "Pa", "pushes into the body, along its current normal")},
                        {}};
  Object displacement = held();
  displacement.keys.insert(
      displacement.keys.begin(),
      {key("value", vector_or_exact, optional, "m",
           "displacement since the start, x and y; `exact`: of the exact solution"),
       key("normal", {Formula{}}, optional, "m",
           "its component along the inward normal alone, positive into the body, free along the piece; or `exact`")});
  displacement.exactly_one = {"value", "normal"};
  return {Tagged{{{"fixed", held()},
                  {"roller", held()},
                  {"displacement", displacement},
                  {"traction", traction},
                  {"pressure", pressure}}}};
}

Schema boundary() {
  return {Object{
      {key("name", {Name{}}, required, "", "name of the piece in results, messages and paths; no two alike"),
       key("points", list(position(), 2, many), optional, "m",
           "tracking points of the spline, the material to their left; last equal to first: a closed, smooth loop"),
       key("line", line(), optional, "", "short form: a straight piece"),
       key("arc", arc(), optional, "", "short form: a piece of a circle"),
       key("circle", circle(), optional, "", "short form: a closed circle"),
       key("corners", list({Integer{0, static_cast<int>(many)}}, 0, many), otherwise(Json::array()), "",
           "numbers of inner points (the first point is 0) at which the tangent may jump"),
       key("condition", condition(), optional, "", "without it the piece is free of traction")},
      {"points", "line", "arc", "circle"}}};
}

Key volumes(std::vector<std::string> rules, std::string meaning) {
  return key("volumes", {Choice{std::move(rules)}}, otherwise("clipped"), "", std::move(meaning));
}

Schema material_points() {
  const auto per_cell = [](const Presence& presence) {
    return key("per_cell", one_or_pair({Integer{1, 1000}}), presence, "", "sub-cells in each direction of a cell");
  };
  const Schema layers = several(2, {Integer{2, 1000000}});
  const Object listed{
      {key("points", list(position(), 1, many), required, "m", "positions"),
       key("volumes", list(positive_number(), 1, many), required, "m³ per metre of thickness", "one a point")},
      {}};
  const Object lattice{
      {per_cell(required), volumes({"clipped", "lattice", "equal"},
                                   "`clipped`: a point at the centroid of each sub-cell's part inside the outline, "
                                   "with its area; `lattice`: at its centre, with the whole sub-cell; `equal`: there, "
                                   "each with the same share of the body")},
      {}};
  const Object vertex{
      {per_cell(optional),
       key("across", layers, optional, "", "points from side to side in x and y, both outer layers included"),
       volumes({"clipped", "lattice", "equal"},
               "`clipped`: the part of a point's sub-cell inside the outline (halves on edges, quarters at corners); "
               "`lattice`: the whole sub-cell; `equal`: the same share of the body for each")},
      {"per_cell", "across"}};
  const Object polar{
      {key("across", layers, required, "", "points along the radius and along the angle, both outer layers included"),
       key("centre", position(), otherwise(Json::array({0, 0})), "m", "of the ring or sector that the outline bounds"),
       volumes({"clipped", "equal"},
               "`clipped`: a point's own sector of the ring, halved at the outer layers; `equal`: "
               "the same share of the body for each")},
      {}};
  return {
      Either{{{listed}, {Tagged{{{"lattice", lattice}, {"vertex", vertex}, {"polar", polar}}, "fill", "lattice"}}}}};
}

Schema exact() {
  const Object plate{{key("radius", length(), required, "m", "radius of a hole about the origin"),
                      key("far_field_stress", any_number(), required, "Pa", "σ_xx far away, times the load factor")},
                     {}};
  const Object cylinder{{key("inner_radius", length(), required, "m", "inner radius of a ring about the origin"),
                         key("outer_radius", length(), required, "m", "outer radius; greater than `inner_radius`"),
                         key("pressure", any_number(), required, "Pa", "on the inner radius, times the load factor")},
                        {}};
  const Object expressions{{key("displacement", several(2, {Formula{}}), required, "m", "u, v"),
                            key("stress", several(3, {Formula{}}), required, "Pa", "xx, yy, xy; tension positive")},
                           {}};
  return {Tagged{{{"plate_with_hole", plate}, {"thick_cylinder", cylinder}, {"expressions", expressions}}}};
}

Schema probe() {
  return {Object{{key("name", {Name{}}, required, "", "name in results; no two alike"),
                  key("position", position(), required, "m", "place at the start")},
                 {}}};
}

Schema tracking() {
  return {
      Object{{key("respace", {Number{{1.0, 1e6, true}}}, optional, "",
                  "largest ratio of chords between two corners that is tolerated; beyond it the tracking points there "
                  "are spaced evenly along the curve; default: never")},
             {}}};
}

Schema solver() {
  return {Object{{key("threads", {Integer{0, 1024}}, otherwise(Case{}.threads), "", "0: all cores")}, {}}};
}

Schema diagnostics() {
  return {Object{{key("condition_estimate", {Boolean{}}, otherwise(Case{}.condition_estimate), "",
                      "estimate the condition number of the scaled system")},
                 {}}};
}

Schema output() {
  return {Object{{key("every", {Integer{1, 1000000}}, otherwise(Case{}.output.every), "",
                      "steps from one saved step to the next; the last is always saved"),
                  key("pictures", {Boolean{}}, otherwise(Case{}.output.pictures), "", "draw PNG pictures at the end")},
                 {}}};
}

Schema whole_case() {
  const Json nothing_said = Json::object();
  return {Object{
      {key("title", {Text{}}, optional, "", "one line for people; default: the name of the file"),
       key("analysis", analysis(), required, "", "what is computed"),
       key("material", material(), required, "", "the law of the material"),
       key("grid", grid(), required, "", "the background grid"),
       key("boundaries", list(boundary(), 1, 100000), required, "",
           "pieces of the outline, each one spline; pieces that meet end to end close into loops"),
       key("material_points", material_points(), required, "", "points that carry the state of the material"),
       key("body_force", several(2, {Formula{}}), optional, "N/m³", "force per volume, x and y"),
       key("gravity", several(2, any_number()), optional, "m/s²", "acceleration, x and y; needs `material.density`"),
       key("ghost", {Number{{0.0, 1e6}}}, optional, "",
           "γ of the ghost penalty; default 0, or 1e-3 where a piece uses `nitsche`"),
       key("constants", {NumberMap{{-huge, huge}}}, otherwise(nothing_said), "", "numbers by name, for expressions"),
       key("exact", exact(), optional, "",
           "exact solution as functions of the original position and t; with it, errors are computed"),
       key("probes", list(probe(), 1, 100000), optional, "",
           "history of the material point or tracking point nearest to a place, saved at every step"),
       key("tracking", tracking(), otherwise(nothing_said), "", "how tracking points are kept"),
       key("solver", solver(), otherwise(nothing_said), "", "how systems are solved"),
       key("diagnostics", diagnostics(), otherwise(nothing_said), "", "measured only where asked for"),
       key("output", output(), otherwise(nothing_said), "", "what is written")},
      {}}};
}

}  // namespace

const Schema& case_keys() {
  static const Schema table = whole_case();
  return table;
}

}  // namespace shoreline::keys
