#!/usr/bin/env python3
"""Prints the tables of docs/error_estimate.md: effectivity, the estimated error of the stress over the true one.

    examples/effectivity.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. An entry is the effectivity and, behind it, the
relative L2 error of the stress.
"""
from runs import row, run, table

BASES = {
    "bilinear": {"basis": "bilinear"},
    "linear, diagonal": {"basis": "linear"},
    "linear, four": {"basis": "linear", "pattern": "four"},
    "Powell-Sabin, diagonal": {"basis": "powell_sabin"},
    "Powell-Sabin, four": {"basis": "powell_sabin", "pattern": "four"},
    "B-splines of degree 2": {"basis": "bspline", "degree": 2},
    "B-splines of degree 3": {"basis": "bspline", "degree": 3},
}
ASKED = {"diagnostics": {"error_estimate": True}, "output": {"every": 1000000, "pictures": False}}


def effectivity(summary):
    if isinstance(summary, str):
        return "singular"
    true, estimate = summary["errors"]["stress"], summary["error_estimate"]["stress"]
    if true["l2_relative"] is not None and true["l2_relative"] < 1e-10:
        return f"exact ({true['l2_relative']:.0e})"
    size = f" ({true['l2_relative']:.1e})" if true["l2_relative"] is not None else ""
    return f"{estimate['l2'] / true['l2']:.2f}{size}"


def keys(basis):
    return {f"grid.{key}": value for key, value in BASES[basis].items()}


def fitted(basis):
    """Few points with weights that integrate what the basis needs."""
    n = BASES[basis].get("degree", 1) + 1
    return {"material_points": {"per_cell": n, "volumes": "fitted"}}


def over_sizes(title, case, sizes, settings_of):
    print(f"\n## {title}")
    table("basis", *(f"h = 1/{n}" for n in sizes))
    for basis in BASES:
        row(basis, *(effectivity(run(case, {"grid.cell_size": 1 / n} | ASKED | keys(basis) | settings_of(basis)))
                     for n in sizes))


def supports(method):
    return {f"boundaries.{piece}.condition.method": method for piece in ("left", "bottom")}


def with_nitsche(basis):
    return fitted(basis) | supports("nitsche")


def moved_with_nitsche(basis):
    return with_nitsche(basis) | {"boundaries.outer.condition.method": "nitsche"}


SIZES = (4, 8, 16, 32, 64)
over_sizes("Smooth square, fitted weights", "smooth_square/square.json", SIZES, fitted)
over_sizes("Smooth square, 4² equal points a cell", "smooth_square/square.json", SIZES[1:4], lambda basis: {})
over_sizes("Plate, tractions, fitted weights", "plate_with_hole/neumann.json", SIZES, with_nitsche)
over_sizes("Plate, displacements, fitted weights", "plate_with_hole/dirichlet.json", SIZES, moved_with_nitsche)
over_sizes("Plate, tractions, 4² equal points a cell", "plate_with_hole/neumann.json", SIZES[1:4],
           lambda basis: {"material_points.per_cell": 4})
over_sizes("Plate, displacements, 4² equal points a cell", "plate_with_hole/dirichlet.json", SIZES[1:4],
           lambda basis: {"material_points.per_cell": 4})
over_sizes("Thick cylinder, fitted weights", "thick_cylinder/implicit.json", (1, 2, 4, 8), fitted)
over_sizes("Thick cylinder, 512² polar points", "thick_cylinder/implicit.json", (1, 2, 4, 8), lambda basis: {})

print("\n## Compression, as the example has it")
table("case", "effectivity")
for case in ("aligned", "rotated_45", "rotated_60"):
    row(f"`{case}.json`", effectivity(run(f"compression/{case}.json", ASKED)))

print("\n## Vibrating bar, 0.1 % strain, t = 0.02 s")
BLOCKS = (4, 8, 16, 32)
table("basis", *(f"{n} blocks" for n in BLOCKS))
for basis in ("linear, four", "Powell-Sabin, four"):
    row(basis, *(effectivity(run("vibrating_bar/small.json", ASKED | keys(basis) | {"grid.cell_size": [25 / n, 2]}))
                 for n in BLOCKS))

print("\n## Other motions, as the examples have them")
table("case", "effectivity")
for case in ("vibrating_bar/large", "soil_column/small", "soil_column/large", "soil_column/equilibrium",
             "moving_square/powell_sabin"):
    row(f"`{case}.json`", effectivity(run(f"{case}.json", ASKED)))
