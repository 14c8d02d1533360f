#!/usr/bin/env python3
"""Prints the tables of this folder's README: errors by basis, mesh and number of points; how jagged a stress history is.

    examples/moving_square/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws stress.png beside this script, too, where
python3 has matplotlib.
"""
import math
import pathlib
import random
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples
from waves import axes_of, np, probe


def mesh(cells, seed):
    """Points of a square grid, moved by up to a fifth of a cell, on the sides along them."""
    number = random.Random(seed).random
    h = 1 / cells
    shift = lambda i: 0.2 * h * (2 * number() - 1) if 0 < i < cells else 0
    return [[i * h + shift(i), j * h + shift(j)] for j in range(cells + 1) for i in range(cells + 1)]


def solve(basis, cells, count, seed=1, folder=None, changes=None):
    """@param count  material points a triangle, there being two a square."""
    side = round(math.sqrt(2 * count) * cells)
    settings = {"grid.basis": basis, "grid.points": mesh(cells, seed), "material_points.across": [side, side],
                "history.every": 1 if folder else 5, "analysis.time_step": 5e-5 if cells > 8 else 1e-4}
    return run("powell_sabin.json", settings | (changes or {}), folder)


def rms(summary, of="displacement"):
    return summary["errors"]["over_time"][of]["rms"] if isinstance(summary, dict) else math.nan


print("# RMS error of the displacement over points and times [m], and its order")
table("basis", "vertices a side", "functions", "32 points a triangle", "order", "seconds", "128 points", "order", "seconds")
for basis, sizes in (("powell_sabin", (4, 8, 16)), ("linear", (8, 16))):
    before = None
    for cells in sizes:
        done = [solve(basis, cells, count) for count in (32, 128)]
        now = [rms(summary) for summary in done]
        orders = [f"{math.log2(b / e):.2f}" for b, e in zip(before, now)] if before else ["", ""]
        functions = (3 if basis == "powell_sabin" else 1) * (cells + 1) ** 2
        row(basis, cells + 1, functions,
            *(x for e, o, s in zip(now, orders, done) for x in (f"{e:.2e}", o, seconds(s))))
        before = now

print("\n# Other meshes, 32 points a triangle: RMS of Powell-Sabin with 9 vertices a side, linear with 17")
table("seed", "powell_sabin", "linear", "ratio")
for seed in (1, 2, 3, 4):
    error = rms(solve("powell_sabin", 8, 32, seed)), rms(solve("linear", 16, 32, seed))
    row(seed, *(f"{e:.2e}" for e in error), f"{error[1] / error[0]:.1f}")

print("\n# σ_xx of the point near (0.25, 0.47): total variation over that of the exact one")
table("basis", "ratio")
E, NU = 1e7, 0.3
LAMBDA, MU, W = E * NU / ((1 + NU) * (1 - 2 * NU)), E / (2 * (1 + NU)), 100 * math.pi
drawn = {}
for basis, cells in (("powell_sabin", 8), ("linear", 16)):
    with tempfile.TemporaryDirectory() as folder:
        solve(basis, cells, 32, 1, folder)
        point = probe(folder, "point")
    x, t = point["position"][0], point["t"]
    a = 1 + 0.1 * math.pi * np.cos(2 * math.pi * x[0]) * np.sin(W * t)
    b = 1 - 0.1 * math.pi * np.cos(2 * math.pi * x[1]) * np.sin(W * t)
    exact = (LAMBDA * np.log(a * b) + MU * (a * a - 1)) / (a * b)
    variation = lambda values: np.abs(np.diff(values)).sum()
    row(basis, f"{variation(point['stress'][:, 0]) / variation(exact):.2f}")
    drawn[basis] = t, point["stress"][:, 0], exact

figure, axes = axes_of(1, 2, (10, 3.8))
if figure:
    for axis, (basis, (t, stress, exact)) in zip(axes, drawn.items()):
        axis.plot(1e3 * t, stress / 1e6, label=basis)
        axis.plot(1e3 * t, exact / 1e6, "k--", linewidth=0.9, label="exact")
        axis.set(xlabel="t [ms]", ylabel="σ_xx [MPa]")
        axis.legend()
        axis.grid(alpha=0.3)
    figure.savefig(HERE / "stress.png", dpi=110)
