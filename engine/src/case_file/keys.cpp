#include "key_rows.hpp"
#include "shoreline/engine/case.hpp"

namespace shoreline::keys {
namespace {

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

/// @param dynamic  in explicit dynamics
Object held(bool dynamic) {
  if (dynamic)
    return {{key("method", {Choice{{"grid", "implicit_boundary", "nitsche"}}}, otherwise("grid"), "",
                 "`grid` alone: elimination on grid lines; the bands of the others would rule the time step")},
            {}};
  return {{key("method", {Choice{{"implicit_boundary", "nitsche", "grid"}}}, otherwise("implicit_boundary"), "",
               "how the condition enters: penalty of a band, the same made consistent, or elimination on grid lines"),
           key("band", {Number{{0.0, 0.1, true}}}, optional, "",
               "width of the band δ/h in cells; default 1e-3 for `implicit_boundary`; for `nitsche` 0.01, 0.02 with "
               "`powell_sabin`, less where a thin layer of a cell lies behind the edge; not with `grid`")},
          {}};
}

Schema condition(bool dynamic) {
  const Schema vector_or_exact{Either{{several(2, {Formula{}}), {Choice{{"exact"}}}}}};
  const Object traction{{key("value", vector_or_exact, required, "Pa",
                             "force per area on the body, x and y; `exact`: of the exact solution")},
                        {}};
  const Object pressure{{key("value", {Formula{}}, required, "Pa", "pushes into the body, along its current normal")},
                        {}};
  Object displacement = held(dynamic);
  displacement.keys.insert(
      displacement.keys.begin(),
      {key("value", vector_or_exact, optional, "m",
           "displacement since the start, x and y; `exact`: of the exact solution"),
       key("normal", {Formula{}}, optional, "m",
           "its component along the inward normal alone, positive into the body, free along the piece; or `exact`")});
  displacement.exactly_one = {"value", "normal"};
  return {Tagged{{{"fixed", held(dynamic)},
                  {"roller", held(dynamic)},
                  {"displacement", displacement},
                  {"traction", traction},
                  {"pressure", pressure}}}};
}

Schema boundary(bool dynamic) {
  return {Object{
      {key("name", {Name{}}, required, "", "name of the piece in results, messages and paths; no two alike"),
       key("points", list(position(), 2, many), optional, "m",
           "tracking points of the spline, the material to their left; last equal to first: a closed, smooth loop"),
       key("line", line(), optional, "", "short form: a straight piece"),
       key("arc", arc(), optional, "", "short form: a piece of a circle"),
       key("circle", circle(), optional, "", "short form: a closed circle"),
       key("corners", list({Integer{0, static_cast<int>(many)}}, 0, many), otherwise(Json::array()), "",
           "numbers of inner points (the first point is 0) at which the tangent may jump"),
       key("condition", condition(dynamic), optional, "", "without it the piece is free of traction")},
      {"points", "line", "arc", "circle"}}};
}

Schema exact(bool dynamic) {
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
  if (dynamic) {
    const Object column{{key("height", length(), required, "m",
                             "of a column on y = 0 onto which `gravity` is let at t = 0; law `linear_large`")},
                        {}};
    return {Tagged{{{"self_weight_column", column}, {"expressions", expressions}}}};
  }
  return {Tagged{{{"plate_with_hole", plate}, {"thick_cylinder", cylinder}, {"expressions", expressions}}}};
}

Schema probe(bool dynamic) {
  Object probe{{key("name", {Name{}}, required, "", "name in results; no two alike"),
                key("position", position(), required, "m", "place at the start")},
               {}};
  if (!dynamic)
    probe.keys.push_back(
        key("at", {Choice{{"nearest", "place"}}}, otherwise("nearest"), "",
            "what is followed: the nearest material point or tracking point, or the material at that very place, "
            "which is the same one whatever the points are"));
  return {probe};
}

Schema tracking() {
  return {
      Object{{key("respace", {Number{{1.0, 1e6, true}}}, optional, "",
                  "largest ratio of chords between two corners that is tolerated; beyond it the tracking points there "
                  "are spaced evenly along the curve; default: never")},
             {}}};
}

Object solver() { return {{key("threads", {Integer{0, 1024}}, otherwise(Case{}.threads), "", "0: all cores")}, {}}; }
Object solver_of_load_steps() {
  Object keys = solver();
  keys.keys.push_back(key("type", {Choice{{"auto", "band", "cholmod", "multigrid"}}}, otherwise(name_of(Case{}.solver)),
                          "",
                          "`band`: Cholesky of the band in grid order; `cholmod`: sparse Cholesky in a fill-reducing "
                          "order; `multigrid`: conjugate gradients with algebraic multigrid, an optional component; "
                          "`auto`: one of them by measured rules (docs/solvers.md)"));
  return keys;
}

Key error_estimate() {
  return key("error_estimate", {Boolean{}}, otherwise(Case{}.error_estimate), "",
             "estimate the error of the stress at the end from the run alone, by recovery");
}

Schema diagnostics() {
  return {Object{{key("condition_estimate", {Boolean{}}, otherwise(Case{}.condition_estimate), "",
                      "estimate the condition number of the scaled system; a warning above 1e14"),
                  key("cut_fractions", {Boolean{}}, otherwise(Case{}.cut_fractions), "",
                      "tell where the system is weak: the smallest cut cell, the smallest pivot, stray points"),
                  key("strain_energy", {Boolean{}}, otherwise(Case{}.strain_energy), "",
                      "the energy that the body stores at the end"),
                  error_estimate()},
                 {}}};
}

Key pictures() {
  return key("pictures", {Boolean{}}, otherwise(Case{}.output.pictures), "", "draw PNG pictures at the end");
}
Key fields() {
  return key("fields", list({Choice{{"strain"}}}, 0, 1), otherwise(Json::array({"strain"})), "",
             "what is saved of the material points beside position, displacement, stress and volume; no memory is kept "
             "for what is not listed");
}
Schema output_of_load_steps() {
  return {Object{{key("every", {Integer{1, 1000000}}, otherwise(Case{}.output.every), "",
                      "load steps from one saved step to the next; the last is always saved"),
                  fields(), pictures()},
                 {}}};
}
Schema output_of_time_steps() {
  return {Object{{key("every", {Integer{1, 100000000}}, optional, "",
                      "steps from one saved step to the next; the last is always saved; default: a step is saved "
                      "whenever a fiftieth of the time has passed"),
                  fields(), pictures()},
                 {}}};
}
Schema output_of_projection() { return {Object{{pictures()}, {}}}; }

Key title() { return key("title", {Text{}}, optional, "", "one line for people; default: the name of the file"); }
Key boundaries(const Presence& presence, std::string meaning, bool dynamic = false) {
  return key("boundaries", list(boundary(dynamic), 1, 100000), presence, "", std::move(meaning));
}
Key constants() {
  return key("constants", map_of(any_number()), otherwise(Json::object()), "", "numbers by name, for expressions");
}
Key settings(std::string name, Schema schema, std::string meaning) {
  return key(std::move(name), std::move(schema), otherwise(Json::object()), "", std::move(meaning));
}

Object quasi_static_case() {
  return {
      {title(), key("analysis", analysis(), required, "", "what is computed"),
       key("material", small_strain_material(), required, "", "the law of the material"),
       key("grid", grid(), required, "", "the background grid and its basis"),
       boundaries(required, "pieces of the outline, each one spline; pieces that meet end to end close into loops"),
       key("material_points", material_points(), required, "", "points that carry the state of the material"),
       key("body_force", several(2, {Formula{}}), optional, "N/m³", "force per volume, x and y"),
       key("gravity", several(2, any_number()), optional, "m/s²", "acceleration, x and y; needs `material.density`"),
       key("ghost", {Number{{0.0, 1e6}}}, optional, "",
           "γ of the ghost penalty; default 5e-4 for `bspline` (degree 1: 1e-3, degree 3: 1e-5) and 1e-4 for "
           "`powell_sabin` unless "
           "every "
           "piece has method `grid`; 0 for `bilinear` and `linear`, but 1e-3 and 1e-2 where a piece uses `nitsche`"),
       constants(),
       key("exact", exact(false), optional, "",
           "exact solution as functions of the original position and t; with it, errors are computed"),
       key("samples", {Integer{2, 10000}}, optional, "",
           "errors are measured at a lattice of sample points, this many along the longer side of the body's bounding "
           "box, carried along with the material, instead of at the material points: the same places and weights "
           "whatever the grid, the basis and the points; needs `exact`"),
       key("probes", list(probe(false), 1, 100000), optional, "",
           "history of the material point or tracking point nearest to a place, or of the material there, saved at "
           "every step"),
       settings("tracking", tracking(), "how tracking points are kept"),
       settings("solver", {solver_of_load_steps()}, "how systems are solved"),
       settings("diagnostics", diagnostics(), "measured only where asked for"),
       settings("output", output_of_load_steps(), "what is written")},
      {}};
}

Schema history() {
  return {Object{{key("every", {Integer{1, 100000000}}, otherwise(1), "", "steps from one record to the next")}, {}}};
}

Object dynamic_case() {
  const Schema field = several(2, {Formula{}});
  return {
      {title(), key("analysis", analysis(), required, "", "what is computed"),
       key("material", large_strain_material(), required, "", "the law of the material"),
       key("grid", grid(), required, "", "the background grid and its basis"),
       boundaries(optional,
                  "pieces of the outline, each one spline; pieces that meet end to end close into loops; listed points "
                  "may do without",
                  true),
       key("material_points", material_points(), required, "", "points that carry the state of the material"),
       key("body_force", field, optional, "N/m³", "force per current volume, x and y"),
       key("gravity", field, optional, "m/s²",
           "acceleration, x and y: numbers, or formulas, of which a point takes the value at its place"),
       key("ghost", {Number{{0.0, 1e6}}}, otherwise(ExplicitDynamics{}.ghost), "",
           "γ of a ghost mass, which binds functions with little material to their neighbours; with the `consistent` "
           "mass alone, as lumping erases it"),
       key("initial_velocity", field, optional, "m/s", "velocity at t = 0, x and y; default: at rest"), constants(),
       key("exact", exact(true), optional, "",
           "exact solution as functions of the original position and t; with it, errors are computed at the end, and "
           "over time with `history`"),
       key("history", history(), optional, "",
           "energies and momentum over time, and how often probes are recorded; without it, probes are at every step"),
       key("probes", list(probe(true), 1, 100000), optional, "",
           "history of the material point or tracking point nearest to a place"),
       settings("solver", {solver()}, "how systems are solved"),
       settings("diagnostics", Schema{Object{{error_estimate()}, {}}}, "measured only where asked for"),
       settings("output", output_of_time_steps(), "what is written")},
      {}};
}

Object projection_case() {
  return {{title(), key("analysis", analysis(), required, "", "what is computed"),
           key("grid", grid(), required, "", "the grid and the basis that is projected onto"),
           boundaries(optional, "outline that a fill of `material_points` needs; without conditions"),
           key("material_points", material_points(), optional, "",
               "points whose values are projected, with their volumes as weights; without them, the projection "
               "integrates over all cells"),
           constants(), settings("solver", {solver()}, "how systems are solved"),
           settings("output", output_of_projection(), "what is written")},
          {}};
}

}  // namespace

const Schema& case_keys() {
  static const Schema table{Depending{"analysis",
                                      {{"quasi_static", quasi_static_case()},
                                       {"explicit_dynamics", dynamic_case()},
                                       {"projection", projection_case()}}}};
  return table;
}

}  // namespace shoreline::keys
