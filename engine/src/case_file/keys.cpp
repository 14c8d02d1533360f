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
  const Object traction{{key("value", several(2, {Formula{}}), required, "Pa", "force per area on the body, x and y")},
                        {}};
  const Object pressure{{key("value", {Formula{}}, required, "Pa", "pushes into the body, along its current normal")},
                        {}};
  return {Tagged{{{"fixed", held()}, {"roller", held()}, {"traction", traction}, {"pressure", pressure}}}};
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

Schema material_points() {
  const Object listed{
      {key("points", list(position(), 1, many), required, "m", "positions"),
       key("volumes", list(positive_number(), 1, many), required, "m³ per metre of thickness", "one a point")},
      {}};
  const Object filled{
      {key("per_cell", one_or_pair({Integer{1, 1000}}), required, "", "sub-cells in each direction of a cell"),
       key("fill", {Choice{{"lattice", "vertex"}}}, otherwise("lattice"), "",
           "points at the centres of sub-cells, or on a lattice whose outer layer lies on the outline"),
       key("volumes", {Choice{{"lattice", "clipped"}}}, otherwise("clipped"), "",
           "`clipped`: each point has the part of its sub-cell inside the outline, and on `lattice` fill sits at its "
           "centroid (`vertex` fill: halves on edges, quarters at corners); `lattice`: the whole sub-cell")},
      {}};
  return {Either{{{listed}, {filled}}}};
}

Schema exact() {
  const Object expressions{{key("displacement", several(2, {Formula{}}), required, "m", "u, v"),
                            key("stress", several(3, {Formula{}}), required, "Pa", "xx, yy, xy; tension positive")},
                           {}};
  return {Tagged{{{"expressions", expressions}}}};
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
