#!/usr/bin/env python3
"""Prints the tables of this folder's README: errors of the small bar, the large one over 20 s, laws at large strain.

    examples/vibrating_bar/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png and laws.png beside this
script, too, where python3 has matplotlib.
"""
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples
from waves import axes_of, np, probe, reference

print("# Small deformation, t = 0.02 s: absolute L2 error of the displacement [m²]")
errors = {}
for basis, blocks in (("powell_sabin", (1, 2, 4, 8)), ("linear", (4, 8, 16))):
    print(f"\n{basis}:")
    table("blocks", "unknowns", "L2", "order", "seconds")
    curve = errors[basis] = []
    for n in blocks:
        summary = run("small.json", {"grid.basis": basis, "grid.cell_size": [25 / n, 2]})
        curve.append((summary["degrees_of_freedom"], summary["errors"]["displacement"]["l2"]))
        order = f"{math.log2(curve[-2][1] / curve[-1][1]):.2f}" if len(curve) > 1 else ""
        row(n, curve[-1][0], f"{curve[-1][1]:.3e}", order, seconds(summary))

print("\n# 7 % strain, 20 s")
AMPLITUDE = 0.1 / (math.pi * math.sqrt(2))
CASES = {
    "Powell-Sabin, 10 blocks, 20 points a triangle, consistent": {},
    "the same with pic": {"analysis.transfer": "pic"},
    "Powell-Sabin, 20 blocks, 20 points a triangle": {
        "grid.cell_size": [0.05, 0.05], "material_points.per_block": [10, 8], "analysis.time_step": 2.5e-3},
    "Powell-Sabin, 20 blocks, 5 points a triangle": {
        "grid.cell_size": [0.05, 0.05], "material_points.per_block": [5, 4], "analysis.time_step": 2.5e-3},
    "Powell-Sabin, 10 blocks, lumped": {"analysis.mass": "lumped"},
    "linear, 20 blocks, 20 points a triangle, lumped": {
        "grid.basis": "linear", "grid.cell_size": [0.05, 0.05], "analysis.mass": "lumped"},
    "quadratic B-splines, 10 cells, 80 points a cell, consistent": {
        "grid": {"lower": [0, 0], "upper": [1, 0.05], "cell_size": [0.1, 0.05], "basis": "bspline"}},
}
table("", "unknowns", "error of u over time, % of its amplitude", "energy gained, %", "critical step [s]", "seconds")
for name, changes in CASES.items():
    summary = run("large.json", changes)
    if isinstance(summary, str):
        row(name, "", summary.strip(), "", "", "")
        continue
    energy = [summary["energy"][end]["total"] for end in ("start", "end")]
    row(name, summary["degrees_of_freedom"],
        f"{100 * summary['errors']['over_time']['displacement']['rms'] / AMPLITUDE:.2f}",
        f"{100 * (energy[1] / energy[0] - 1):.2f}", f"{summary['dynamics']['critical_step_at_start']:.2e}",
        seconds(summary))

print("\n# Laws at large strain: the bar at 28 % strain beside a reference in one dimension, first 2 s")
table("law", "largest difference of u in the middle, % of its amplitude", "period of the reference [s]")
curves = {}
for law in ("linear_large", "neo_hookean", "hypoelastic"):
    with tempfile.TemporaryDirectory() as folder:
        summary = run("large.json", {"material.type": law, "constants.v0": 0.4, "analysis.end_time": 2,
                                     "analysis.time_step": 2e-3, "history.every": 5}, folder)
        if isinstance(summary, str):
            row(law, summary.strip(), "")
            continue
        middle = probe(folder, "middle")
    x0 = middle["position"][0, 0]
    times, x, u, _ = reference(law, 1.0, 50.0, 25.0, 2.0, velocity=lambda x: 0.4 * np.sin(np.pi * x))
    exact = np.interp(middle["t"], times, [np.interp(x0, x, state) for state in u])
    curves[law] = middle["t"], middle["displacement"][:, 0], exact
    down = np.flatnonzero((exact[:-1] > 0) & (exact[1:] <= 0))
    row(law, f"{100 * np.abs(exact - middle['displacement'][:, 0]).max() / np.abs(exact).max():.2f}",
        f"{2 * middle['t'][down[0]]:.2f}" if len(down) else "")

figure, axes = axes_of(1, 2, (10, 4))
if figure:
    for basis, curve in errors.items():
        axes[0].loglog(*zip(*curve), "o-", label=basis.replace("_", "-"), markersize=4)
    axes[0].set(xlabel="unknowns", ylabel="L2 error of the displacement [m²]", title="small bar, t = 0.02 s")
    axes[0].legend()
    for law, (t, u, exact) in curves.items():
        line, = axes[1].plot(t, 1e3 * u, label=law)
        axes[1].plot(t, 1e3 * exact, "--", color="black", linewidth=0.8)
    axes[1].set(xlabel="t [s]", ylabel="displacement of the middle [mm]", title="28 % strain, by law (dashed: reference)")
    axes[1].legend()
    for axis in axes:
        axis.grid(alpha=0.3)
    figure.savefig(HERE / "convergence.png", dpi=110)
