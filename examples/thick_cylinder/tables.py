#!/usr/bin/env python3
"""Prints the tables of this folder's README: errors of the deformed radii over the cell size and the points.

    examples/thick_cylinder/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png beside this script, too,
where python3 has matplotlib.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples

SIZES = (1, 0.5, 0.25, 0.125)


def radius(summary, piece):
    return summary["errors"]["boundary"][piece]["radius"]["mean_relative"]


curves = {}

print("# Cell size, 512² points")
variants = {
    "conventional": ("conventional.json", lambda h: {}),
    "implicit": ("implicit.json", lambda h: {}),
    "implicit, grid moved by -0.3 h": ("implicit.json", lambda h: {"grid.lower": [-0.3 * h, -0.3 * h]}),
    "implicit, grid moved by -0.7 h": ("implicit.json", lambda h: {"grid.lower": [-0.7 * h, -0.7 * h]}),
    "conventional, equal volumes": ("conventional.json", lambda h: {"material_points.volumes": "equal"}),
}
table("rollers", "h [m]", "inner radius", "rate", "outer radius", "rate", "rel. L2, displacement", "rel. L2, stress",
      "seconds")
for name, (case, settings) in variants.items():
    errors = []
    for h in SIZES:
        s = run(case, {"grid.cell_size": h} | settings(h))
        inner, outer = radius(s, "inner"), radius(s, "outer")
        rates = [f"{math.log2(b / a):.2f}" for b, a in zip(errors[-1], (inner, outer))] if errors else ["", ""]
        row(name, h, f"{inner:.3e}", rates[0], f"{outer:.3e}", rates[1],
            *(f"{s['errors'][field]['l2_relative']:.2e}" for field in ("displacement", "stress")), seconds(s))
        errors.append((inner, outer))
    curves[name] = [inner for inner, _ in errors]

print("\n# Points, conventional rollers")
table("points", *(f"{piece} radius, h = {h:g}" for h in (1, 0.25) for piece in ("inner", "outer")))
by_points = {}
failures = []
for n in (8, 16, 32, 64, 128, 256, 512):
    entries = []
    for h in (1, 0.25):
        s = run("conventional.json", {"grid.cell_size": h, "material_points.across": [n, n]})
        if isinstance(s, str):
            failures.append(f"{n}² points, h = {h:g}: {s.strip()}")
            entries += ["fails", "fails"]
            continue
        entries += [f"{radius(s, 'inner'):.3e}", f"{radius(s, 'outer'):.3e}"]
        by_points[h, n] = radius(s, "inner"), radius(s, "outer")
    row(f"{n}²", *entries)
print("", *failures, sep="\n")

print("\n# Tracking points of each arc, h = 0.25")
table("tracking points", "inner radius", "outer radius")
for n in (9, 17, 33, 65, 129):
    s = run("conventional.json", {f"boundaries.{piece}.arc.points": n for piece in ("inner", "outer")})
    row(n, f"{radius(s, 'inner'):.3e}", f"{radius(s, 'outer'):.3e}")

try:
    import matplotlib
except ImportError:
    sys.exit("convergence.png not drawn: this python3 has no matplotlib; try /usr/bin/python3")
matplotlib.use("Agg")
from matplotlib import pyplot

figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
for (name, errors), marker in zip(curves.items(), "osv^x"):
    left.loglog(SIZES, errors, marker=marker, label=name, fillstyle="none")
left.loglog(SIZES, [0.04 * h**2 for h in SIZES], color="0.6", linestyle=":", label="order two")
left.set(xlabel="h [m]", xticks=SIZES, xticklabels=SIZES, title="relative error of the inner radius, 512² points")
left.minorticks_off()
for h, style in ((1, "-"), (0.25, "--")):
    counts = [n for size, n in by_points if size == h]
    for piece, name in enumerate(("inner", "outer")):
        right.loglog(counts, [by_points[h, n][piece] for n in counts], style, marker="o", color=f"C{piece}",
                     label=f"{name} radius, h = {h:g} m")
right.set_ylim(bottom=5e-5)
right.set(xlabel="points in each direction", title="relative error of the radii")
for axes in (left, right):
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", loc="lower right" if axes is left else "lower left")
figure.savefig(HERE / "convergence.png", dpi=110)
