"""Wrong cases, one fault each: made from right ones, and the fault's place and message."""

import json

from right_cases import CASE, MESHES, PROJECTION, SQUARE, Wrong, changed, replaced
from wrong_dynamics import wrong_dynamics
from wrong_keys import every_key_misspelt_mistyped_missing


def wrong_values():
    table = [  # path, value, in the message, whether the schema sees it
        ("title", 5, "a string", True),
        ("analysis/type", "explicit_dynamic", 'nearest: "explicit_dynamics"', True),
        ("analysis/plane", "stres", 'nearest: "stress"', True),
        ("analysis/load_steps", 0, "whole number from 1", True),
        ("analysis/load_steps", -3, "whole number from 1", True),
        ("analysis/load_steps", 1.5, "whole number", True),
        ("analysis/load_steps", 1000001, "1000000", True),
        ("analysis/load_steps", 1e300, "1000000", True),
        ("analysis/load", "x*t", "which depends on place", False),
        ("analysis/load", "q*t", "character 1", False),
        ("analysis/load", [1], "a number or an expression", True),
        ("material/youngs_modulus", 0, "> 0", True),
        ("material/youngs_modulus", -1e7, "> 0", True),
        ("material/youngs_modulus", "1e7", "a number", True),
        ("material/youngs_modulus", 1e31, "1e+30", True),
        ("material/poissons_ratio", 0.5, "< 0.5", True),
        ("material/poissons_ratio", -1, "> -1", True),
        ("material/density", 0, "> 0", True),
        ("grid/cells", "hexagon", '"quadrilateral"', True),
        ("grid/cells", "triangle", 'expected "quadrilateral"', False),
        ("grid/basis", "bsplines", 'nearest: "bspline"', True),
        ("grid/degree", 0, "from 1 to 3", True),
        ("grid/degree", 4, "from 1 to 3", True),
        ("grid/lower", [0], "list of 2", True),
        ("grid/lower/0", 2e9, "1e+09", True),
        ("grid/upper", [0, 0, 0], "list of 2", True),
        ("grid/upper/1", -2, "expected more than -2", False),
        ("grid/cell_size", 0, "> 0", True),
        ("grid/cell_size", -0.5, "> 0", True),
        ("grid/cell_size", [0.5], "list of 2", True),
        ("grid/cell_size", 1.2e-4, "1.11e+09 cells, expected at most 1e+08", False),
        ("grid/cell_size", 1e-300, "cells, expected at most 1e+08", False),
        ("grid/cell_size", "NaN", "a number", True),
        ("boundaries", [], "at least 1", True),
        ("boundaries", {}, "a list", True),
        ("boundaries/0", "bottom", "an object", True),
        ("boundaries/0/name", "", "a name", True),
        ("boundaries/0/name", "a/b", "a name", True),
        ("boundaries/1/name", "bottom", "the name of boundary 0", False),
        ("boundaries/0/points", [[0, 0]], "at least 2", True),
        ("boundaries/0/points/1", [0], "list of 2", True),
        ("boundaries/0/points/1", [-1, 0], "the same point twice", False),
        ("boundaries/0/points/1/0", 1e10, "1e+09", True),
        ("boundaries/0/corners/0", 0, "an inner point, 1 to 1", False),
        ("boundaries/0/corners/0", -1, "whole number", True),
        ("boundaries/0/condition/type", "rollar", 'nearest: "roller"', True),
        ("boundaries/0/condition/type", "displacment", 'nearest: "displacement"', True),
        ("boundaries/0/condition/method", "penalty", '"nitsche"', True),
        ("boundaries/0/condition/band", 0, "> 0", True),
        ("boundaries/0/condition/band", 0.2, "0.1", True),
        ("boundaries/1/condition/value", "q*t", "character 1", False),
        ("boundaries/1/condition/value", "p=t", "==", False),
        ("boundaries/1/condition/value", "", "empty", False),
        ("boundaries/1/arc/radius", -1, "> 0", True),
        ("boundaries/1/arc/points", 1, "from 2", True),
        ("boundaries/2/circle/points", 2, "from 3", True),
        ("boundaries/2/circle/hole", "yes", "true or false", True),
        ("boundaries/2/condition/value", [1], "list of 2", True),
        ("boundaries/2/condition/value/1", "sin(t", "parenthesis", False),
        ("boundaries/3/line/points", 1000001, "1000000", True),
        ("boundaries/4/condition/normal", [0, 1], "a number or an expression", True),
        ("boundaries/4/condition/normal", "exakt", "character 1", False),
        ("boundaries/5/condition/value", "exakt", '"exact"', True),
        ("boundaries/5/condition/value", 1, 'a list of 2', True),
        ("boundaries/5/condition/value", {}, 'or "exact"', True),
        ("boundaries/5/condition/value", [0, 0, 0], "a list of 2", True),
        ("material_points", [], "an object", True),
        ("material_points/per_cell", 0, "from 1 to 1000", True),
        ("material_points/per_cell", 1001, "from 1 to 1000", True),
        ("material_points/per_cell", [2, 2, 2], "list of 2", True),
        ("material_points/fill", "polr", 'nearest: "polar"', True),
        ("material_points/volumes", "exact", '"clipped"', True),
        ("body_force", 1, "list of 2", True),
        ("gravity/1", "down", "a number", True),
        ("ghost", -1e-3, "≥ 0", True),
        ("constants/p", "1000", "a number", True),
        ("exact/type", "plate", 'nearest: "plate_with_hole"', True),
        ("exact/displacement", [0], "list of 2", True),
        ("exact/stress/1", "p*z", "character 3", False),
        ("samples", 0, "whole number from 2 to 10000", True),
        ("samples", 1.5, "whole number", True),
        ("samples", 10001, "10000", True),
        ("samples", "many", "whole number", True),
        ("probes", [], "at least 1", True),
        ("probes/0", [1, 0], "an object", True),
        ("probes/0/name", "a.b", "a name", True),
        ("probes/1/name", "tip", "the name of probe 0", False),
        ("probes/0/position", [0], "list of 2", True),
        ("probes/0/position/1", -1e30, "-1e+09", True),
        ("probes/0/at", "plcae", 'nearest: "place"', True),
        ("tracking", 4, "an object", True),
        ("tracking/respace", 1, "> 1", True),
        ("tracking/respace", 1e300, "1e+06", True),
        ("solver/threads", -1, "from 0", True),
        ("solver/threads", 100000, "1024", True),
        ("solver/type", "bnad", 'nearest: "band"', True),
        ("solver/type", 1, '"cholmod"', True),
        ("diagnostics/condition_estimate", 1, "true or false", True),
        ("diagnostics/cut_fractions", "yes", "true or false", True),
        ("diagnostics/strain_energy", "J", "true or false", True),
        ("diagnostics/error_estimate", 1e-3, "true or false", True),
        ("output/every", 0, "from 1", True),
        ("output/pictures", "no", "true or false", True),
    ]
    for path, value, words, structural in table:
        formula = words in ("character 1", "character 3", "==", "empty", "parenthesis")
        found = "formula" if formula else "found"
        yield Wrong(f"{path} = {value!r}", replaced(path, value), "/" + path, [found, words], structural)


def wrong_together():
    """Keys that are right alone."""
    def also(path, key, value, pointer, words, structural):
        text = changed(path + "/" + key, lambda at, last: at.__setitem__(last, value))
        return Wrong(f"{path} with {key}", text, pointer, words, structural)

    yield also("boundaries/0", "line", {"from": [0, 0], "to": [1, 0]}, "/boundaries/0", ["exactly one of"], True)
    yield also("boundaries/0/condition", "value", 3, "/boundaries/0/condition", ['unknown key "value"'], True)
    yield also("boundaries/1/condition", "band", 0.01, "/boundaries/1/condition", ['unknown key "band"'], True)
    yield also("boundaries/0/condition", "method", "grid", "/boundaries/0/condition/band", ["expected none"], False)
    yield also("boundaries/1/arc", "to", 360, "/boundaries/1/arc", ["360"], False)
    yield also("boundaries/3/line", "to", [0, -2], "/boundaries/3/line", ["different"], False)
    yield also("constants", "t", 1, "/constants/t", ["variable"], False)
    yield also("constants", "sin", 1, "/constants/sin", ["function"], False)
    yield also("constants", "1p", 1, "/constants/1p", ["letters"], False)
    yield also("boundaries/4/condition", "value", [0, 0], "/boundaries/4/condition", ["exactly one of"], True)
    yield also("boundaries/5/condition", "band", 1e-3, "/boundaries/5/condition/band", ["expected none"], False)
    yield Wrong("a condition estimate by multigrid", replaced("solver/type", "multigrid"),
                "/diagnostics/condition_estimate", ["found true", "expected false", '"multigrid"'], False)
    yield Wrong("an exact displacement of no exact solution", changed("exact", lambda at, last: at.pop(last)),
                "/boundaries/5/condition/value", ['the key "exact"'], False)
    inexact = {key: value for key, value in CASE.items() if key != "exact"}
    yield Wrong("samples of no exact solution", replaced("boundaries/5/condition/value", [0, 0], inexact), "/samples",
                ["found sample points", 'the key "exact"'], False)
    yield also("material_points", "points", [[0, 0]], "/material_points", ["unknown key"], True)
    yield also("material_points", "across", [2, 2], "/material_points", ['"per_cell" and "across"', "exactly one of"], True)
    yield also("material_points", "seed", 1, "/material_points", ['unknown key "seed"'], True)
    for value, pointer, words, structural in [
            ({"fill": "vertex", "across": [28, 8], "per_cell": 2}, "", ["exactly one of"], True),
            ({"fill": "vertex"}, "", ["exactly one of"], True),
            ({"fill": "vertex", "across": [1, 8]}, "/across/0", ["from 2"], True),
            ({"fill": "vertex", "across": 8}, "/across", ["list of 2"], True),
            ({"volumes": "equal"}, "", ["found none", '"per_cell", "per_block", "across"'], True),
            ({"per_block": 0}, "/per_block", ["from 1 to 1000"], True),
            ({"across": 8}, "/across", ["list of 2"], True),
            ({"across": [0, 8]}, "/across/0", ["from 1"], True),
            ({"across": [100000, 100000]}, "/across", ["1e+10 points"], False),
            ({"fill": "random"}, "", ['"per_cell" is missing'], True),
            ({"fill": "random", "per_cell": [2, 2]}, "/per_cell", ["whole number from 1 to 1000"], True),
            ({"fill": "random", "per_cell": 2, "seed": -1}, "/seed", ["from 0"], True),
            ({"fill": "random", "per_cell": 2, "volumes": "clipped"}, "/volumes", ['"voronoi"'], True),
            ({"fill": "polar", "per_cell": 2}, "", ['unknown key "per_cell"'], True),
            ({"fill": "polar", "across": [2, 1e300]}, "/across/1", ["1000000"], True),
            ({"fill": "polar", "across": [100000, 100000]}, "/across", ["1e+10 points"], False),
            ({"fill": "polar", "across": [2, 2], "centre": [0]}, "/centre", ["list of 2"], True),
            ({"fill": "polar", "across": [2, 2], "volumes": "lattice"}, "/volumes", ['"equal"'], True)]:
        yield Wrong(f"material_points = {value}", replaced("material_points", value), "/material_points" + pointer,
                    words, structural)
    for value, pointer, words, structural in [
            ({"type": "plate_with_hole", "radius": 0, "far_field_stress": 1}, "/radius", ["> 0"], True),
            ({"type": "plate_with_hole", "radius": 1, "far_field_stress": 1e31}, "/far_field_stress", ["1e+30"], True),
            ({"type": "plate_with_hole", "radius": 1, "pressure": 1}, "", ['unknown key "pressure"'], True),
            ({"type": "thick_cylinder", "inner_radius": -1, "outer_radius": 2, "pressure": 1}, "/inner_radius",
             ["> 0"], True),
            ({"type": "thick_cylinder", "inner_radius": 2, "outer_radius": 2, "pressure": 1}, "/outer_radius",
             ["more than 2"], False),
            ({"type": "thick_cylinder", "inner_radius": 1, "outer_radius": 2, "pressure": "p"}, "/pressure",
             ["a number"], True)]:
        yield Wrong(f"exact = {value}", replaced("exact", value), "/exact" + pointer, words, structural)
    yield Wrong("more volumes than points", replaced("material_points", {"points": [[0, 0]], "volumes": [1, 1]}),
                "/material_points/volumes", ["2 volumes", "1 point"], False)
    yield Wrong("a negative volume", replaced("material_points", {"points": [[0, 0]], "volumes": [-1]}),
                "/material_points/volumes/0", ["found -1", "> 0"], True)
    disc = {key: CASE[key] for key in ("analysis", "material", "grid", "material_points", "constants")}
    disc["boundaries"] = [{"name": "edge", "circle": {"centre": [0, 0], "radius": 1}}]
    for place in ([1.1, 0], [9, 9]):
        probes = [{"name": "far", "position": [9, 9]}, {"name": "off", "position": place, "at": "place"}]
        yield Wrong(f"a probe at {place}", json.dumps({**disc, "probes": probes}), "/probes/1/position",
                    [f"found ({place[0]}, {place[1]}), outside the outline", "expected", '"nearest"'], False)
    yield Wrong("gravity without density", changed("material/density", lambda at, last: at.pop(last)),
                "/gravity", ["density"], False)


def wrong_grids():
    frame = {"lower": [-2, -2], "upper": [2, 2], "cell_size": 0.5}
    line = [[0, 0], [1, 1], [2, 2]]
    for grid, pointer, words, structural in [
            ({**frame, "cells": "quadrilateral", "basis": "powell_sabin"}, "/cells", ['expected "triangle"', "remove"],
             False),
            ({**frame, "cells": "triangle", "basis": "bspline"}, "/cells", ['expected "quadrilateral"'], False),
            ({**frame, "basis": "bilinear", "degree": 2}, "/degree", ["found a degree", '"bspline"'], False),
            ({**frame, "cells": "triangle", "degree": 2}, "/degree", ["found a degree", '"bspline"'], False),
            ({**frame, "pattern": "four"}, "/pattern", ["found a pattern", '"linear"'], False),
            ({**frame, "basis": "linear", "pattern": "fuor"}, "/pattern", ['nearest: "four"'], True),
            ({**frame, "mesh": "square.msh"}, "/lower", ['"lower" beside "mesh"'], True),
            ({**frame, "points": SQUARE}, "/lower", ['"lower" beside "points"'], True),
            ({"mesh": "square.msh", "cell_size": 0.5}, "/cell_size", ['"cell_size" beside "mesh"'], True),
            ({"mesh": "square.msh", "points": SQUARE}, "/points", ['"points" beside "mesh"'], True),
            ({"mesh": "square.msh", "basis": "linear", "pattern": "four"}, "/pattern", ['beside "mesh"'], True),
            ({"mesh": "square.msh", "basis": "bspline"}, "/basis", ['"powell_sabin"'], True),
            ({"mesh": "square.msh", "cells": "quadrilateral"}, "/cells", ['"triangle"'], True),
            ({**frame, "basis": "linear", "cell_size": [0.001, 0.1]}, "/cell_size", ["0.573 degrees", "at least 1"],
             False),
            ({**frame, "basis": "powell_sabin", "cell_size": 1e-3}, "/cell_size", ["of 12 triangles = 1.92e+08"], False),
            ({"mesh": "missing.msh"}, "/mesh", ["missing.msh: ", "No such file", "Gmsh"], False),
            ({"mesh": "."}, "/mesh", ["found a folder", "Gmsh"], False),
            ({"points": [[0, 0], [1, 0]]}, "/points", ["at least 3"], True),
            ({"points": line}, "/points", ["one line"], False),
            ({"points": [*SQUARE, SQUARE[0]]}, "/points", ["vertex ", " at (-2, -2)"], False)]:
        yield Wrong(f"grid = {grid}", replaced("grid", grid), "/grid" + pointer, words, structural)
    for file, (_, words) in MESHES.items():
        yield Wrong(file, replaced("grid", {"mesh": file}), "/grid/mesh", words, False)
    square = {**CASE, "grid": {"mesh": "square.msh"}}
    yield Wrong("vertices per cell on a mesh", replaced("material_points", {"fill": "vertex", "per_cell": 2}, square),
                "/material_points/per_cell", ["mesh", '"across"'], False)
    yield Wrong("points per block on a mesh", replaced("material_points", {"per_block": 2}, square),
                "/material_points/per_block", ["no rectangles", '"across"'], False)
    yield Wrong("two numbers a triangle", replaced("material_points", {"per_cell": [2, 3]}, square),
                "/material_points/per_cell", ["found [2,3]", "one number"], False)
    many = {**CASE, "grid": {**frame, "cell_size": 0.004, "basis": "linear"}}
    yield Wrong("too many points in triangles", replaced("material_points", {"per_cell": 23}, many),
                "/material_points/per_cell", ["1.06e+09 points"], False)


def wrong_projections():
    points = {"points": [[0.6, 0.3], [1.6, 0.3]], "volumes": [1, 1]}
    outline = [{"name": "edge", "circle": {"centre": [1, 1], "radius": 0.5}}]
    held = [{**outline[0], "condition": {"type": "fixed"}}]
    value = PROJECTION["analysis"]["value"]
    for name, more, pointer, words, structural in [
            *[(f"projection with {key}", {key: CASE[key]}, f"/{key}", ["expected none", '"projection"'], True)
              for key in ("material", "body_force", "gravity", "ghost", "exact", "samples", "probes", "tracking",
                          "diagnostics")],
            ("load steps", {"analysis": {"type": "projection", "value": 1, "load_steps": 2}}, "/analysis",
             ['unknown key "load_steps"'], True),
            ("saved steps", {"output": {"every": 2}}, "/output", ['unknown key "every"'], True),
            ("value and data", {"analysis": {"type": "projection", "value": 1, "data": [1]}}, "/analysis",
             ["exactly one of"], True),
            ("an unknown mass", {"analysis": {"type": "projection", "value": 1, "mass": "lmped"}}, "/analysis/mass",
             ['nearest: "lumped"'], True),
            ("time", {"analysis": {"type": "projection", "value": "x*t"}}, "/analysis/value", ["depends on t"], False),
            ("a wrong formula", {"analysis": {"type": "projection", "value": "q*x"}}, "/analysis/value",
             ["character 1"], False),
            ("one slope", {"analysis": {"type": "projection", "value": value, "gradient": [1]}}, "/analysis/gradient",
             ["list of 2"], True),
            ("data of no points", {"analysis": {"type": "projection", "data": [1]}}, "/analysis/data",
             ["found 1 numbers", "0 listed points"], False),
            ("too few data", {"analysis": {"type": "projection", "data": [1]}, "material_points": points},
             "/analysis/data", ["found 1 numbers", "2 listed points"], False),
            ("a gradient of data", {"analysis": {"type": "projection", "data": [1, 2], "gradient": [0, 0]},
                                    "material_points": points}, "/analysis/gradient", ["beside \"data\""], False),
            ("a fill without outline", {"material_points": {"per_cell": 2}}, "/material_points", ['"boundaries"'], False),
            ("an outline without fill", {"boundaries": outline}, "/boundaries", ["without a fill"], False),
            ("an outline around points", {"boundaries": outline, "material_points": points}, "/boundaries",
             ["without a fill"], False),
            ("a condition", {"boundaries": held, "material_points": {"per_cell": 2}}, "/boundaries/0/condition",
             ["expected none"], False),
            ("a point outside", {"material_points": {**points, "points": [[0.5, 0.5], [9, 9]]}},
             "/material_points/points", ["point 1 at (9, 9)", "outside the grid"], False),
            ("too few points", {"material_points": points, "grid": {"lower": [0, 0], "upper": [2, 2], "cell_size": 1}},
             "/material_points", ["singular", "function ", "more points", "lumped"], False),
            ("points on one edge", {"material_points": {**points, "points": [[0.5, 0], [1.5, 0]]}}, "/material_points",
             ["function ", "sees no point", "spread points"], False),
            ("an outline outside", {"boundaries": [{"name": "edge", "circle": {"centre": [2, 1], "radius": 0.5}}],
                                    "material_points": {"per_cell": 2}}, "/boundaries/0", ["grid.upper"], False)]:
        yield Wrong(name, json.dumps({**PROJECTION, **more}), pointer, words, structural)
    yield Wrong("a value in load steps", replaced("analysis/value", 1), "/analysis", ['unknown key "value"'], True)


def wrong_texts():
    whole = json.dumps(CASE)
    yield Wrong("empty", "", "", ["empty"], False)
    yield Wrong("blank", " \n\t\n", "", ["empty"], False)
    yield Wrong("no JSON", "title: square", "", ["line 1, column"], False)
    yield Wrong("truncated", json.dumps(CASE, indent=1)[:400], "", ["line ", "column "], False)
    yield Wrong("something behind", whole + "}", "", ["line 1, column"], False)
    yield Wrong("a list", "[1, 2]", "", ["found [1,2]", "an object"], True)
    yield Wrong("a number", "7", "", ["found 7", "an object"], True)
    yield Wrong("NaN", whole.replace("0.2,", "NaN,", 1), "", ["line 1, column"], False)
    yield Wrong("Infinity", whole.replace("0.2,", "-Infinity,", 1), "", ["line 1, column"], False)
    yield Wrong("1e999", whole.replace("0.2,", "1e999,", 1), "/material/poissons_ratio", ["double"], False)
    yield Wrong("a key twice", whole.replace('"plane"', '"type": "quasi_static", "plane"', 1), "/analysis/type",
                ["twice"], False)
    yield Wrong("nested without end", '{"title": ' + "[" * 200000, "/title" + "/0" * 32, ["deeper"], False)
    yield Wrong("bytes that are no text", '{"title": "\udcff"}', "", ["line 1", "UTF-8"], False)


def all_wrong_cases():
    for family in (every_key_misspelt_mistyped_missing, wrong_values, wrong_together, wrong_grids,
                   wrong_projections, wrong_dynamics, wrong_texts):
        yield from family()
