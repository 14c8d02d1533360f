#!/usr/bin/env python3
"""Prints the tables of this folder's README: error of the projection against unknowns, for every basis and both masses.

    examples/projection/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png beside this script, too.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, table  # beside the folders of the examples

BASES = {"bilinear": {"grid.basis": "bilinear"}, "linear": {"grid.basis": "linear"},
         "Powell-Sabin": {"grid.basis": "powell_sabin"},
         "Powell-Sabin, in four": {"grid.basis": "powell_sabin", "grid.pattern": "four"},
         "B-spline, degree 2": {"grid.basis": "bspline", "grid.degree": 2},
         "B-spline, degree 3": {"grid.basis": "bspline", "grid.degree": 3}}
SQUARES = (2, 4, 8, 16, 32)


def order(error, before):
    return "" if before is None else f"{math.log2(before / error):.2f}"


drawn = {}
for mass in ("consistent", "lumped"):
    print(f"\n### {mass} mass")
    table("basis", "squares a side", "unknowns", "L2 error", "order", "of ∂/∂x", "order", "seconds")
    for name, keys in BASES.items():
        last = [None, None]
        for n in SQUARES:
            s = run("case.json", keys | {"grid.cell_size": 1 / n, "analysis.mass": mass})
            errors = [s["errors"]["projection"][key] for key in ("l2", "x_derivative_l2")]
            row(name, n, s["degrees_of_freedom"], f"{errors[0]:.3e}", order(errors[0], last[0]), f"{errors[1]:.3e}",
                order(errors[1], last[1]), f"{s['timings']['projection']:.4f}")
            drawn.setdefault((name, mass), []).append((s["degrees_of_freedom"], *errors))
            last = errors

try:
    import matplotlib
except ImportError:
    sys.exit("convergence.png not drawn: this python3 has no matplotlib; try /usr/bin/python3")
matplotlib.use("Agg")
from matplotlib import pyplot

figure, panels = pyplot.subplots(1, 2, figsize=(12, 4.2), layout="constrained")
for (name, mass), rows in drawn.items():
    unknowns, *errors = zip(*rows)
    colour = f"C{list(BASES).index(name)}"
    for axes, error in zip(panels, errors):
        axes.loglog(unknowns, error, color=colour, marker="o" if mass == "consistent" else "x",
                    linestyle="-" if mass == "consistent" else "--", label=name if mass == "consistent" else None)
for axes, title in zip(panels, ("L2 error of the field", "L2 error of its x-derivative")):
    axes.set(xlabel="unknowns", title=title)
    axes.grid(alpha=0.3)
panels[1].legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize="small",
                 title="consistent (solid),\nlumped (dashed)", title_fontsize="small")
figure.savefig(HERE / "convergence.png", dpi=110)
