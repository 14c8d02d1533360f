"""Wrong cases, one fault each: made from a case that has every key, and the fault's place and message."""

import copy
import json

CASE = {
    "title": "every key",
    "analysis": {"type": "quasi_static", "plane": "strain", "load_steps": 2, "load": "t^2", "loading": "residual"},
    "material": {"type": "linear_elastic", "youngs_modulus": 1e7, "poissons_ratio": 0.2, "density": 2000.0},
    "grid": {"cells": "quadrilateral", "basis": "bspline", "degree": 2, "lower": [-2, -2], "upper": [2, 2],
             "cell_size": 0.5},
    "boundaries": [
        {"name": "bottom", "points": [[-1, 0], [0, 0], [1, 0]], "corners": [1],
         "condition": {"type": "roller", "method": "nitsche", "band": 0.01}},
        {"name": "top", "arc": {"centre": [0, 0], "radius": 1, "from": 0, "to": 180, "points": 9},
         "condition": {"type": "pressure", "value": "p*t"}},
        {"name": "hole", "circle": {"centre": [0, 0.4], "radius": 0.2, "points": 12, "hole": True},
         "condition": {"type": "traction", "value": [0, "p*t"]}},
        {"name": "beam", "line": {"from": [0, -2], "to": [1, -2], "points": 2},
         "condition": {"type": "fixed", "method": "implicit_boundary", "band": 1e-3}},
        {"name": "slide", "points": [[0, 1], [1, 1]],
         "condition": {"type": "displacement", "normal": "p*t", "method": "nitsche", "band": 0.01}},
        {"name": "moved", "points": [[0, 2], [1, 2]],
         "condition": {"type": "displacement", "value": "exact", "method": "grid"}},
    ],
    "material_points": {"per_cell": [2, 2], "fill": "lattice", "volumes": "clipped"},
    "body_force": [0, "p"],
    "gravity": [0, -9.81],
    "ghost": 1e-3,
    "constants": {"p": 1000.0},
    "exact": {"type": "expressions", "displacement": [0, "p*y"], "stress": [0, "p", 0]},
    "samples": 20,
    "probes": [{"name": "tip", "position": [1, 0], "at": "place"}, {"name": "root", "position": [-1, 0]}],
    "tracking": {"respace": 4.0},
    "solver": {"threads": 1},
    "diagnostics": {"condition_estimate": True, "cut_fractions": False, "strain_energy": True, "error_estimate": True},
    "output": {"every": 1, "pictures": False},
}

SQUARE = [(-2, -2), (2, -2), (2, 2), (-2, 2)]


def gmsh(vertices, triangles):
    """A mesh in Gmsh's format 2.2; vertices count from 1."""
    nodes = [f"{i + 1} {x} {y} 0" for i, (x, y) in enumerate(vertices)]
    elements = [f"{i + 1} 2 2 1 1 {a} {b} {c}" for i, (a, b, c) in enumerate(triangles)]
    return "\n".join(["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(nodes)), *nodes, "$EndNodes",
                      "$Elements", str(len(elements)), *elements, "$EndElements", ""])


MESHES = {  # file: its text, in the message
    "binary.msh": ("$MeshFormat\n2.2 1 8\n\1\0\0\0\n$EndMeshFormat\n", ["binary.msh:2", "Mesh.Binary = 0"]),
    "old.msh": ("$MeshFormat\n1.0 0 8\n", ["old.msh:2", '"1.0"', "2.2 or 4.1"]),
    "picture.msh": ("\x89PNG\r\n\x1a\n", ["picture.msh:1", "$MeshFormat"]),
    "empty.msh": ("", ["empty.msh:1", "the file ends", "$MeshFormat"]),
    "cut.msh": (gmsh(SQUARE, [(1, 2, 3)])[:80], ["cut.msh:", "expected"]),
    "absurd.msh": (gmsh(SQUARE, [(1, 2, 3)]).replace("$Nodes\n4", "$Nodes\n999999999999"), ["absurd.msh:", "$EndNodes"]),
    "points.msh": (gmsh(SQUARE, []), ["points.msh:", "no triangles"]),
    "nan.msh": (gmsh([(0, 0), (1, "nan"), (1, 1)], [(1, 2, 3)]), ["nan.msh: ", "vertex 1 at (1, nan)", "not finite"]),
    "twice.msh": (gmsh([*SQUARE, (2, 2)], [(1, 2, 3), (1, 5, 4)]), ["twice.msh: ", "vertex 2 and vertex 3 at (2, 2)"]),
    "inverted.msh": (gmsh(SQUARE, [(1, 2, 3), (1, 4, 3)]), ["inverted.msh: ", "triangle 1 ", "clockwise"]),
    "sliver.msh": (gmsh([(0, 0), (1, 0), (0.5, 0.001)], [(1, 2, 3)]), ["sliver.msh: ", "triangle 0 ", "0.11", "sliver"]),
    "hanging.msh": (gmsh([*SQUARE, (0, 0)], [(1, 2, 3), (1, 5, 4), (5, 3, 4)]), ["hanging.msh: ", "(0, 0)", "hangs on"]),
    "apart.msh": (gmsh([(0, 0), (1, 0), (0, 1), (5, 5), (6, 5), (5, 6)], [(1, 2, 3), (4, 5, 6)]),
                  ["apart.msh: ", "triangle 1 ", "hang together"]),
}

PROJECTION = {
    "title": "every key of a projection",
    "analysis": {"type": "projection", "value": "p*x^2", "gradient": ["2*p*x", 0], "mass": "consistent"},
    "grid": {"cells": "triangle", "basis": "powell_sabin", "lower": [0, 0], "upper": [2, 2], "cell_size": 1},
    "constants": {"p": 3.0},
    "solver": {"threads": 1},
    "output": {"pictures": False},
}

DYNAMICS = {
    "title": "every key of explicit dynamics",
    "analysis": {"type": "explicit_dynamics", "time_step": "auto", "safety": 0.5, "end_time": 0.1,
                 "mass": "partly_lumped", "transfer": 0.5, "damping": 0.1, "leaving": "drop"},
    "material": {"type": "linear_large", "youngs_modulus": 1e6, "poissons_ratio": 0.2, "density": 2000.0},
    "grid": {"basis": "bilinear", "lower": [-1, -1], "upper": [2, 2], "cell_size": 0.5},
    "boundaries": [
        {"name": "base", "points": [[0, 0], [1, 0]], "condition": {"type": "fixed", "method": "grid"}},
        {"name": "right", "points": [[1, 0], [1, 1]], "condition": {"type": "roller", "method": "grid"}},
        {"name": "top", "points": [[1, 1], [0, 1]], "condition": {"type": "traction", "value": [0, "p*t"]}},
        {"name": "left", "points": [[0, 1], [0, 0]],
         "condition": {"type": "displacement", "value": [0, "1e-9*t"], "method": "grid"}},
    ],
    "material_points": {"per_cell": 2, "fill": "lattice"},
    "body_force": [0, "p"],
    "gravity": [0, -9.81],
    "initial_velocity": ["1e-6*p*x", 0],
    "constants": {"p": 1000.0},
    "exact": {"type": "self_weight_column", "height": 1.0},
    "history": {"every": 10},
    "probes": [{"name": "tip", "position": [1, 1]}],
    "solver": {"threads": 1},
    "diagnostics": {"error_estimate": True},
    "output": {"every": 100, "pictures": False},
}

OTHERS = [("grid", {"cells": "triangle", "basis": "linear", "pattern": "four", "lower": [0, 0], "upper": [1, 1],
                    "cell_size": [1, 1]}),
          ("grid", {"mesh": "square.msh", "cells": "triangle", "basis": "powell_sabin"}),
          ("grid", {"points": SQUARE, "cells": "triangle", "basis": "linear"}),
          ("material_points", {"fill": "vertex", "across": [28, 8], "volumes": "lattice"}),
          ("material_points", {"fill": "vertex", "per_cell": 2}),
          ("material_points", {"fill": "lattice", "per_block": [2, 3]}),
          ("material_points", {"fill": "lattice", "across": [20, 8], "volumes": "equal"}),
          ("material_points", {"fill": "random", "per_cell": 4, "seed": 7, "volumes": "voronoi"}),
          ("material_points", {"fill": "polar", "across": [9, 17], "centre": [0, 0], "volumes": "equal"}),
          ("exact", {"type": "plate_with_hole", "radius": 0.5, "far_field_stress": 1e6}),
          ("exact", {"type": "thick_cylinder", "inner_radius": 1.0, "outer_radius": 5.0, "pressure": 1e6})]

OPTIONAL = {"title", "load_steps", "load", "loading", "density", "cells", "basis", "degree", "pattern", "corners", "condition", "method", "band",
            "fill", "volumes", "body_force", "gravity", "ghost", "constants", "exact", "samples", "strain_energy", "probes", "at", "tracking", "respace",
            "centre", "seed", "solver", "threads", "diagnostics", "condition_estimate", "cut_fractions", "error_estimate", "output", "every", "pictures", "hole", "p",
            "gradient", "mass"}
OPTIONAL_IN_DYNAMICS = {"time_step", "safety", "transfer", "damping", "leaving", "boundaries", "initial_velocity",
                        "history"}


class Wrong:
    """One wrong case: its name, its text, where the fault lies, what the message must say.

    structural: the JSON Schema alone must refuse it."""

    def __init__(self, name, text, pointer, words, structural):
        self.name, self.text, self.pointer, self.words, self.structural = name, text, pointer, words, structural


def changed(path, change, case=CASE):
    """The case's text after change(parent, last key) at a path like grid/lower/0."""
    case = copy.deepcopy(case)
    at = case
    *steps, last = [int(s) if s.isdigit() else s for s in path.split("/")]
    for step in steps:
        at = at[step]
    change(at, last)
    return json.dumps(case)


def replaced(path, value, case=CASE):
    return changed(path, lambda at, last: at.__setitem__(last, value), case)


def keys(value, pointer=""):
    """The pointers of all keys of objects, at any depth, and the objects."""
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in entries:
        if isinstance(value, dict):
            yield f"{pointer}/{key}", value
        yield from keys(inner, f"{pointer}/{key}")


def one_of_several(key, among):
    """Whether a key stands for others that could be there in its place."""
    families = [("mass", {"value", "data"}), ("name", {"points", "line", "arc", "circle"}), ("method", {"value", "normal"}),
                ("fill", {"per_cell", "per_block", "across"} if among.get("fill") in ("vertex", "lattice") else {})]
    return any(beside in among and key in family for beside, family in families)


def wrong_key(case, pointer, among):
    """One key misspelt, mistyped, missing."""
    parent, key = pointer.rsplit("/", 1)
    path = pointer[1:]
    tag = key == "type"
    if parent != "/constants":
        misspelt = key[:-1] + "q" + key[-1]
        text = changed(path, lambda at, last: at.__setitem__(misspelt, at.pop(last)), case)
        words = ['"type" is missing'] if tag else ["found unknown key", misspelt, "expected"]
        yield Wrong(f"misspelt {pointer}", text, parent, words, True)
    yield Wrong(f"mistyped {pointer}", replaced(path, None, case), pointer, ["found null", "expected"], True)
    first = key in ("points", "mesh") and "name" not in among  # tells what the object is
    optional = OPTIONAL - {"density"} | OPTIONAL_IN_DYNAMICS if case is DYNAMICS else OPTIONAL
    if (key not in optional or one_of_several(key, among)) and not first:
        text = changed(path, lambda at, last: at.pop(last), case)
        words = ["exactly one of"] if one_of_several(key, among) else [f'"{key}" is missing', "expected"]
        yield Wrong(f"missing {pointer}", text, parent, words, True)


def every_key_misspelt_mistyped_missing():
    for pointer, among in keys(CASE):
        yield from wrong_key(CASE, pointer, among)
    for case in (PROJECTION, DYNAMICS):
        for pointer, among in keys(case):
            yield from wrong_key(case, pointer, among)
    for place, value in OTHERS:
        for pointer, among in keys(value, f"/{place}"):
            yield from wrong_key({**CASE, place: value}, pointer, among)


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


def wrong_dynamics():
    table = [  # path, value, in the message, whether the schema sees it
        ("analysis/plane", "stress", 'expected "strain"', True),
        ("analysis/time_step", 0, "> 0", True),
        ("analysis/time_step", -1e-3, "> 0", True),
        ("analysis/time_step", 1e300, "1e+30", True),
        ("analysis/time_step", "atuo", '"auto"', True),
        ("analysis/time_step", "NaN", '"auto"', True),
        ("analysis/safety", 0, "> 0", True),
        ("analysis/safety", 1.1, "1", True),
        ("analysis/end_time", 0, "> 0", True),
        ("analysis/end_time", -1, "> 0", True),
        ("analysis/end_time", "1", "a number", True),
        ("analysis/mass", "lumpd", 'nearest: "lumped"', True),
        ("analysis/mass", "partly-lumped", 'nearest: "partly_lumped"', True),
        ("analysis/transfer", 1.5, "1", True),
        ("analysis/transfer", -0.1, "0", True),
        ("analysis/transfer", "apic", '"pic"', True),
        ("analysis/damping", 1, "< 1", True),
        ("analysis/damping", -0.1, "≥ 0", True),
        ("analysis/leaving", "ignore", '"stop", "drop"', True),
        ("material/type", "linear_elastic", '"linear_large"', True),
        ("material/type", "neohookean", 'nearest: "neo_hookean"', True),
        ("material/density", 0, "> 0", True),
        ("boundaries/0/condition/method", "nitshe", 'nearest: "nitsche"', True),
        ("boundaries/0/condition/method", "nitsche", 'method "grid" alone', False),
        ("boundaries/1/condition/method", "implicit_boundary", 'method "grid" alone', False),
        ("boundaries/3/condition/method", "nitsche", 'method "grid" alone', False),
        ("boundaries/2/condition/value/1", "p*z", "character 3", False),
        ("gravity", [0], "list of 2", True),
        ("gravity/1", [0], "a number", True),
        ("initial_velocity", 1, "list of 2", True),
        ("initial_velocity/0", "p*z", "character 3", False),
        ("exact/type", "self_weight_colum", 'nearest: "self_weight_column"', True),
        ("exact/height", 0, "> 0", True),
        ("history", 10, "an object", True),
        ("history/every", 0, "from 1", True),
        ("history/every", 1.5, "whole number", True),
        ("diagnostics/error_estimate", "yes", "true or false", True),
        ("output/every", 0, "from 1", True),
    ]
    for path, value, words, structural in table:
        yield Wrong(f"dynamics: {path} = {value!r}", replaced(path, value, DYNAMICS), "/" + path,
                    ["formula" if words == "character 3" else "", words], structural)

    listed = {"points": [[0.25, 0.25], [0.75, 0.25]], "volumes": [0.25, 0.25]}
    fixed_step = {**DYNAMICS["analysis"], "time_step": 1e-3}
    without_safety = {key: value for key, value in fixed_step.items() if key != "safety"}
    without_gravity = {key: value for key, value in DYNAMICS.items() if key != "gravity"}
    unbounded = {key: value for key, value in DYNAMICS.items() if key != "boundaries"}
    base = DYNAMICS["boundaries"][0]
    for name, case, pointer, words, structural in [
            ("a safety factor beside a time step", {**DYNAMICS, "analysis": fixed_step}, "/analysis/safety",
             ["found a safety factor", '"auto"'], False),
            ("a time step above the critical one",
             {**DYNAMICS, "analysis": {**without_safety, "time_step": 0.05}}, "/analysis/time_step",
             ["found 0.05 s", "expected at most ", "critical step", "partly_lumped", '"auto"'], False),
            ("a huge time step", {**DYNAMICS, "analysis": {**without_safety, "time_step": 1e20}},
             "/analysis/time_step", ["found 0.1 s", "expected at most "], False),
            ("a time step of too many", {**DYNAMICS, "analysis": {**without_safety, "time_step": 1e-12}},
             "/analysis/time_step", ["1e+11 steps", "at most 1e+09"], False),
            ("the column without gravity", without_gravity, "/exact/type", ['expected "gravity"'], False),
            ("the column under sideways gravity", {**DYNAMICS, "gravity": [1, -9.81]}, "/exact/type",
             ['expected "gravity"', "the first 0"], False),
            ("the column under a field of gravity", {**DYNAMICS, "gravity": [0, "-9.81"]}, "/exact/type",
             ['expected "gravity"', "two numbers"], False),
            ("the column of another law", {**DYNAMICS, "material": {**DYNAMICS["material"], "type": "neo_hookean"}},
             "/material/type", ['found "neo_hookean"', '"linear_large"', "self_weight_column"], False),
            ("an exact solution of load steps", {**DYNAMICS, "exact": {"type": "plate_with_hole", "radius": 1,
                                                                       "far_field_stress": 1}},
             "/exact/type", ['"self_weight_column"'], True),
            ("a band", {**DYNAMICS, "boundaries": [{**base, "condition": {"type": "fixed", "band": 1e-3}}]},
             "/boundaries/0/condition", ['unknown key "band"'], True),
            ("a support off the grid lines",
             {**DYNAMICS, "grid": {**DYNAMICS["grid"], "lower": [-1.1, -1.1]}}, "/boundaries",
             ['"base"', "leaves the grid lines"], False),
            ("a fill without an outline", unbounded, "/material_points", ["outline"], False),
            ("a point outside the grid", {**unbounded, "material_points": {**listed, "points": [[0.5, 0.5], [9, 9]]}},
             "/material_points", ["point 1 at (9, 9)", "outside the grid"], False),
            *[(f"dynamics with {key}", {**DYNAMICS, key: CASE[key]}, f"/{key}", ["expected none", '"explicit_dynamics"'],
               True) for key in ("tracking", "samples")],
            ("dynamics with a condition estimate", {**DYNAMICS, "diagnostics": {"condition_estimate": True}},
             "/diagnostics", ['unknown key "condition_estimate"'], True),
            ("a probe at a place in dynamics", {**DYNAMICS, "probes": [{**DYNAMICS["probes"][0], "at": "place"}]},
             "/probes/0", ['unknown key "at"'], True),
            ("a ghost mass beside a lumped mass", {**DYNAMICS, "ghost": 1e-3}, "/ghost", ["lumping erases", "consistent"],
             False),
            *[(f"dynamics with analysis.{key}", {**DYNAMICS, "analysis": {**DYNAMICS["analysis"], key: value}},
               "/analysis", [f'unknown key "{key}"'], True)
              for key, value in (("load_steps", 2), ("load", "t"), ("loading", "residual"))],
            *[(f"load steps with {key}", {**CASE, key: DYNAMICS[key]}, f"/{key}", ["expected none", '"quasi_static"'],
               True) for key in ("initial_velocity", "history")]]:
        yield Wrong(name, json.dumps(case), pointer, words, structural)
    whole = json.dumps(DYNAMICS)
    for number in ("NaN", "Infinity"):
        yield Wrong(f"a time step of {number}", whole.replace('"auto"', number, 1), "", ["line 1, column"], False)
    yield Wrong("a time step of 1e999", whole.replace('"auto"', "1e999", 1), "/analysis/time_step", ["double"], False)


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
