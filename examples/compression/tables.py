#!/usr/bin/env python3
"""Prints the tables of this folder's README: error against points and against the band.

    examples/compression/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws band.png beside this script, too.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, table  # beside the folders of the examples

PIECES = ("bottom", "right", "left")


def through_outer_points(n):
    """The square whose outline runs through the outer of n points a cell and direction."""
    low, high = 0.25 / n, 1 - 0.25 / n
    corner = ([low, low], [high, low], [high, high], [low, high])
    sides = {name: [corner[k], corner[(k + 1) % 4]] for k, name in enumerate(("bottom", "right", "top", "left"))}
    return {"material_points.per_cell": n, "constants.y0": low} | {
        f"boundaries.{name}.points": points for name, points in sides.items()}


def band(value, method="implicit_boundary"):
    return {f"boundaries.{p}.condition.{key}": v for p in PIECES for key, v in (("method", method), ("band", value))}


def number(value):
    return "-" if value is None else f"{value:.3e}"


def stress(summary, component):
    return number(None if isinstance(summary, str) else summary["errors"]["stress"]["mean_relative"][component])


def displacement(summary, kind, component):
    return number(None if isinstance(summary, str) else summary["errors"]["displacement"][kind][component])


print("### aligned.json: points")
table("points a cell", "R_σxx", "R_σyy", "A_v [m]")
for n in range(1, 9):
    s = run("aligned.json", {"material_points.per_cell": n})
    row(f"{n}²", stress(s, 0), stress(s, 1), displacement(s, "mean_absolute", 1))

print("\n### implicit.json: points, band 1e-6")
table("points a cell", "R_σyy, volumes adjusted", "R_σyy, whole volumes", "A_v [m], adjusted", "A_v [m], whole")
for n in (2, 4, 8, 16, 32):
    adjusted = run("implicit.json", through_outer_points(n))
    whole = run("implicit.json", through_outer_points(n) | {"material_points.volumes": "lattice"})
    row(f"{n}²", stress(adjusted, 1), stress(whole, 1), displacement(adjusted, "mean_absolute", 1),
        displacement(whole, "mean_absolute", 1))

print("\n### implicit.json: band, 32² points a cell")
table("δ/h", "R_σxx", "R_σyy", "A_u [m]", "A_v [m]")
for k in range(1, 13):
    s = run("implicit.json", band(10.0**-k))
    row(f"1e-{k}", stress(s, 0), stress(s, 1), displacement(s, "mean_absolute", 0), displacement(s, "mean_absolute", 1))

drawn = {}
for angle in (45, 60):
    print(f"\n### rotated_{angle}.json: band, one point a cell")
    table("method", "δ/h", "R_σyy", "R_v", "condition (scaled)", "Cholesky")
    for method, powers in (("implicit_boundary", range(1, 13)), ("nitsche", range(1, 4))):
        for k in powers:
            s = run(f"rotated_{angle}.json",
                    band(10.0**-k, method) | {"ghost": 0, "diagnostics.condition_estimate": True})
            failed = isinstance(s, str)
            row(method, f"1e-{k}", stress(s, 1), displacement(s, "mean_relative", 1),
                "-" if failed else number(s["condition_estimate"]),
                "failed" if failed else "no, LU" if s["warnings"] else "yes")
            if not failed:
                drawn.setdefault((angle, method), []).append(
                    (10.0**-k, s["errors"]["stress"]["mean_relative"][1], s["condition_estimate"]))

try:
    import matplotlib
except ImportError:
    sys.exit("band.png not drawn: this python3 has no matplotlib; try /usr/bin/python3")
matplotlib.use("Agg")
from matplotlib import pyplot

figure, (left, right) = pyplot.subplots(1, 2, figsize=(10, 4), layout="constrained")
for (angle, method), rows in drawn.items():
    bands, errors, conditions = zip(*rows)
    style = {"marker": "o" if method == "implicit_boundary" else "s", "linestyle": "-" if angle == 45 else "--",
             "color": "C0" if method == "implicit_boundary" else "C1", "label": f"{method}, {angle}°"}
    left.loglog(bands, errors, **style)
    right.loglog(bands, conditions, **style)
for axes, title in ((left, "mean relative error of σ_yy"), (right, "condition number, scaled matrix")):
    axes.set(xlabel="band δ/h", title=title)
    axes.invert_xaxis()
    axes.grid(alpha=0.3)
left.legend(fontsize="small")
figure.savefig(HERE / "band.png", dpi=110)
