"""Right cases that between them have every key, what may be left out of them, and how to change them."""

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
    "solver": {"threads": 1, "type": "band"},
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
