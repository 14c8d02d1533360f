#!/usr/bin/env python3
"""Prints the tables of this folder's README: deflection of the tip over cells, points, loading, support and steps.

    examples/cantilever/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png beside this script, too,
where python3 has matplotlib.
"""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples

LAYOUTS = ((14, 4), (28, 8), (56, 16), (112, 32))
SIZES = (3, 1.5, 0.75, 0.375)
REFERENCE = 2.8220  # m, finite element solution of Bing et al. 2019, figure 12b
LIMITS = {"1 step": 2.7454, "5 steps, incremental": 2.7605, "5 steps, residual": 2.8009}  # m, of finite_elements.py


def beam(h, across, high, pressure, steps, loading):
    return {"grid.cell_size": h, "analysis.load_steps": steps, "analysis.loading": loading,
            "boundaries.top.condition.value": pressure, "boundaries.bottom.line.points": across,
            "boundaries.top.line.points": across, "boundaries.tip.line.points": high + 1,
            "material_points.across": [across, high]}


def central(h, across, high, pressure=1500, steps=5, loading="incremental", ghost=0):
    """The central piece of the left edge's spline is fixed, the rest of the edge a roller."""
    above, below = ([0.25, 1.5 + side / (high - 1)] for side in (1, -1))
    return run("central_support.json", beam(h, across, high, pressure, steps, loading) | {
        "boundaries.upper.line.to": above, "boundaries.support.line.from": above,
        "boundaries.support.line.to": below, "boundaries.lower.line.from": below,
        "boundaries.upper.line.points": high // 2, "boundaries.lower.line.points": high // 2, "ghost": ghost})


def clamped(h, across, high, pressure=1500, steps=5, loading="incremental", ghost=0):
    return run("clamped.json", beam(h, across, high, pressure, steps, loading) | {
        "boundaries.left.line.points": high, "ghost": ghost})


def deflection(summary):
    """Of the middle of the tip [m]."""
    return -summary["probes"]["tip"]["displacement"][1]


def entry(summary, failures=None, name=""):
    """The deflection, with a star where a function was left at rest or the matrix was not definite."""
    if isinstance(summary, str):
        if failures is not None:
            failures.append(f"{name}: {summary.strip()}")
        return "fails"
    return f"{deflection(summary):.4f}" + ("*" if summary["warnings"] else "")


print("# The paper's figures, central support, incremental loading")
table("pressure [Pa]", "steps", "h [m]", "points", "deflection [m]", "with ghost 1e-3", "unknowns", "seconds")
for pressure, steps, h, across, high in ((3000, 10, 0.75, 28, 8), (1500, 5, 1.5, 56, 16), (1500, 5, 0.375, 112, 32)):
    s = central(h, across, high, pressure, steps)
    stabilised = central(h, across, high, pressure, steps, ghost=1e-3)
    row(pressure, steps, h, f"{across} × {high}", entry(s), entry(stabilised), s["degrees_of_freedom"], seconds(s))

drawn = {}
for pressure, steps in ((1500, 5), (3000, 10)):
    for ghost in (0, 1e-3):
        print(f"\n# Layouts, central support, {pressure} Pa in {steps} steps, ghost {ghost}")
        table("h [m]", *(f"{across} × {high}" for across, high in LAYOUTS))
        failures = []
        for h in SIZES:
            runs = [central(h, across, high, pressure, steps, ghost=ghost) for across, high in LAYOUTS]
            row(h, *(entry(s, failures, f"h = {h}, {across} × {high}") for s, (across, high) in zip(runs, LAYOUTS)))
            if pressure == 1500 and ghost:
                drawn[h] = [(a * b, deflection(s)) for s, (a, b) in zip(runs, LAYOUTS) if not isinstance(s, str)]
        print("", *failures, sep="\n")

print("\n# Loading, 1500 Pa in 5 steps")
table("h [m]", "points", "central, incremental", "central, residual", "clamped, incremental", "clamped, residual")
for h, across, high in ((1.5, 56, 16), (0.75, 112, 32), (0.375, 112, 32), (0.1875, 448, 128)):
    row(h, f"{across} × {high}", *(entry(support(h, across, high, loading=loading)) for support in (central, clamped)
                                   for loading in ("incremental", "residual")))

print("\n# Left edge fixed over its height, 1500 Pa: cells and points")
table("h [m]", "points", "points a cell", "1 step", "5 steps, incremental", "5 steps, residual", "unknowns", "seconds")
missing = {}
for fineness in (1, 2):
    for k in range(6):
        h, across, high = 3 / 2**k, 28 * fineness * 2**k, 8 * fineness * 2**k
        runs = [clamped(h, across, high, steps=n, loading=loading)
                for n, loading in ((1, "residual"), (5, "incremental"), (5, "residual"))]
        row(h, f"{across} × {high}", f"{h * across / 10:.1f} × {h * high / 2:.0f}", *map(entry, runs),
            runs[1]["degrees_of_freedom"], seconds(runs[1]))
        for (name, limit), s in zip(LIMITS.items(), runs):
            missing.setdefault((fineness, name), []).append((h, abs(1 - deflection(s) / limit)))

print("\n# Number of load steps, 1500 Pa, ghost 1e-3")
table("support", "h [m]", "points", "loading", *(f"N = {n}" for n in (1, 2, 5, 20, 80)))
for name, support, h, across, high in (("central", central, 0.375, 112, 32), ("clamped", clamped, 0.375, 112, 32),
                                       ("clamped", clamped, 0.375, 448, 128), ("clamped", clamped, 0.1875, 448, 128)):
    for loading in ("incremental", "residual"):
        row(name, h, f"{across} × {high}", loading,
            *(entry(support(h, across, high, steps=n, loading=loading, ghost=1e-3)) for n in (1, 2, 5, 20, 80)))

try:
    import matplotlib
except ImportError:
    sys.exit("convergence.png not drawn: this python3 has no matplotlib; try /usr/bin/python3")
matplotlib.use("Agg")
from matplotlib import pyplot

figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.6), layout="constrained")
for h, values in drawn.items():
    left.semilogx(*zip(*values), marker="o", label=f"h = {h:g} m")
left.set_ylim(bottom=0.9)
left.axhline(REFERENCE, color="0.6", linestyle="--", label="the paper's finite elements")
left.set(xlabel="material points", title="deflection [m], central support, ghost 1e-3")
for (fineness, name), values in missing.items():
    colour = list(LIMITS).index(name)
    right.loglog(*zip(*values), marker="o" if fineness == 2 else "x", linestyle="-" if fineness == 2 else ":",
                 color=f"C{colour}", label=f"{name}, {'17 × 24' if fineness == 2 else '8 × 12'} points a cell")
right.loglog((3, 0.09375), (0.5, 0.5 / 1024), color="0.6", linestyle="--", label="order two")
right.set(xlabel="h [m]", title="|1 - deflection / limit|, left edge fixed")
for axes in (left, right):
    axes.grid(alpha=0.3)
    axes.legend(fontsize="small", loc="lower right")
figure.savefig(HERE / "convergence.png", dpi=110)
