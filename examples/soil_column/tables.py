#!/usr/bin/env python3
"""Prints the tables of this folder's README: the column by mass and transfer, at rest, and by law.

    examples/soil_column/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws mass.png beside this script, too, where
python3 has matplotlib.
"""
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples
from waves import axes_of, last_step, np, probe, reference

WEIGHT, MODULUS = 9810.0, 1e5  # rho g H [Pa], E [Pa]
KAPPA = WEIGHT / (2 * MODULUS)
SPEED = math.sqrt(MODULUS / 1000)


def blocks(columns, rows):
    """The large column on another grid, one empty row of blocks above its top."""
    return {"grid.cell_size": [0.1 / columns, 1 / rows], "grid.upper": [0.1, 1 + 1 / rows]}


def run_to(settings, case="large.json"):
    with tempfile.TemporaryDirectory() as folder:
        summary = run(case, settings, folder)
        if isinstance(summary, str):
            return summary, None, None
        return summary, probe(folder, "middle"), last_step(folder)


print("# Large deformation to 2.5 s: errors averaged over time")
table("blocks", "mass", "transfer", "u [% of κH]", "v [% of 2κc]", "σ [% of σ₀]", "critical step, start [s]", "smallest",
      "energy gained [% of the strain energy swung]", "seconds")
drawn = {}
for columns, rows in ((1, 8), (2, 16)):
    for mass, transfer in (("consistent", "flip"), ("lumped", "flip"), ("partly_lumped", "flip"),
                           ("partly_lumped", "pic")):
        summary, middle, last = run_to(
            blocks(columns, rows) | {"analysis.mass": mass, "analysis.transfer": transfer})
        if isinstance(summary, str):
            print(f"\n{columns} x {rows} {mass}: {summary.strip()}\n")
            continue
        over = [summary["errors"]["over_time"][of]["mean_rms"] for of in ("displacement", "velocity", "stress")]
        energy = [summary["energy"][end]["total"] for end in ("start", "end")]
        row(f"{columns} x {rows}", mass, transfer,
            *(f"{100 * e / s:.2f}" for e, s in zip(over, (KAPPA, 2 * KAPPA * SPEED, WEIGHT))),
            f"{summary['dynamics']['critical_step_at_start']:.2e}",
            f"{summary['dynamics']['smallest_critical_step']:.2e}",
            f"{100 * (energy[1] - energy[0]) / 64.2:.2f}", seconds(summary))
        if columns == 1:
            drawn[f"{mass}, {transfer}"] = middle, last

print("\n# One block wide to t = 1 s: volumes as weights, and weights that are fitted to the outline")
table("blocks", "basis, mass, transfer", "weights", "u [% of κH]", "v [% of 2κc]", "σ [% of σ₀]",
      "critical step, smallest [s]", "energy gained [% of the strain energy swung]", "share of the fit in the time",
      "seconds")


def strip(rows):
    """The large column one block wide, which its walls allow."""
    width = 0.8 / rows
    corners = [[0, 0], [width, 0], [width, 1], [0, 1]]
    return {"grid.cell_size": [width, 1 / rows], "grid.upper": [width, 1 + 1 / rows],
            "probes.0.position": [width / 2, 0.5], "analysis.end_time": 1, "analysis.time_step": 4e-3 / rows} | {
                f"boundaries.{k}.points": [corners[k], corners[(k + 1) % 4]] for k in range(4)}


SCHEMES = {"Powell-Sabin, partly lumped, pic": {"analysis.mass": "partly_lumped", "analysis.transfer": "pic"},
           "Powell-Sabin, consistent, ghost 0.01, pic": {"analysis.mass": "consistent", "ghost": 0.01,
                                                         "analysis.transfer": "pic"},
           "linear, lumped, flip": {"grid.basis": "linear", "analysis.mass": "lumped"}}
for scheme, settings in SCHEMES.items():
    for volumes in ("clipped", "fitted"):
        for rows in (8, 16, 32) if "ghost" not in settings else (8, 16):
            summary, _, _ = run_to(strip(rows) | settings | {"material_points.volumes": volumes})
            if isinstance(summary, str):
                print(f"\n{rows} {scheme} {volumes}: {summary.strip()}\n")
                continue
            over = [summary["errors"]["over_time"][of]["mean_rms"] for of in ("displacement", "velocity", "stress")]
            energy = [summary["energy"][end]["total"] for end in ("start", "end")]
            time = summary["timings"]
            row(f"1 x {rows}", scheme, volumes,
                *(f"{100 * e / s:.2f}" for e, s in zip(over, (KAPPA, 2 * KAPPA * SPEED, WEIGHT))),
                f"{summary['dynamics']['smallest_critical_step']:.2e}",
                f"{100 * (energy[1] - energy[0]) / (64.2 * 8 / rows):.2f}",
                f"{time.get('weights', 0.0) / time['total']:.2f}", seconds(summary))

print("\n# At rest (equilibrium.json): RMS error of the stress, % of σ₀, and of u, relative")
table("mass", "transfer", "stress", "u", "seconds")
for mass, transfer in (("partly_lumped", "flip"), ("partly_lumped", "pic"), ("lumped", "flip")):
    summary, _, _ = run_to({"analysis.mass": mass, "analysis.transfer": transfer}, "equilibrium.json")
    row(mass, transfer, f"{100 * summary['errors']['stress']['l2'] / math.sqrt(0.1 * (1 - KAPPA)) / WEIGHT:.2f}",
        f"{summary['errors']['displacement']['l2_relative']:.2e}", seconds(summary))

print("\n# Laws: settlement of the point at mid-height [mm], damped to rest, and by quasi-static load steps")
XI = np.linspace(0, 1, 20001)


def settlement(law, height):
    """Closed form at X = height: y - X with sigma(X) = -w (H - X)."""
    s = -2 * KAPPA * (1 - XI)
    stretch = {"linear_large": 1 + s, "neo_hookean": s + np.sqrt(s * s + 1), "hypoelastic": 1 / (1 - s)}[law]
    y = np.concatenate([[0], np.cumsum((stretch[1:] + stretch[:-1]) / 2 * np.diff(XI))])
    return np.interp(height, XI, y) - height


table("law", "E [Pa]", "closed form", "damped", "quasi-static, 1 step", "quasi-static, 100 steps")
for modulus in (1e5, 1.8e7):
    KAPPA = WEIGHT / (2 * modulus)
    step = {"material.youngs_modulus": modulus}
    still = []
    for steps in (1, 100):
        with tempfile.TemporaryDirectory() as folder:
            summary = run("quasi_static.json", step | {"analysis.load_steps": steps}, folder)
            still.append(summary["probes"]["middle"]["displacement"][1])
    for law in ("linear_large", "neo_hookean", "hypoelastic"):
        time = {} if modulus < 1e6 else {"analysis.end_time": 0.3, "analysis.time_step": 3.5e-5}
        summary, middle, _ = run_to(step | time | {"material.type": law}, "equilibrium.json")
        if isinstance(summary, str):
            row(law, f"{modulus:g}", summary.strip(), "", "", "")
            continue
        exact = settlement(law, middle["position"][0, 1])
        row(law, f"{modulus:g}", *(f"{1e3 * u:.4g}" for u in (exact, middle["displacement"][-1, 1], *still)))
KAPPA = WEIGHT / (2 * MODULUS)

print("\n# Laws in motion: largest difference to a reference in one dimension to t = 1 s, % of its amplitude")
table("law", "difference of u at mid-height")
for law in ("linear_large", "neo_hookean", "hypoelastic"):
    changes = {"material.type": law, "analysis.end_time": 1, "analysis.transfer": "pic"}
    if law != "linear_large":
        changes["exact"] = {"type": "expressions", "displacement": [0, 0], "stress": [0, 0, 0]}
    summary, middle, _ = run_to(changes)
    if isinstance(summary, str):
        row(law, summary.strip())
        continue
    times, x, u, _ = reference(law, 1.0, MODULUS, 1000.0, 1.0, force=-9.81, free_end=True)
    exact = np.interp(middle["t"], times, [np.interp(middle["position"][0, 1], x, state) for state in u])
    row(law, f"{100 * np.abs(exact - middle['displacement'][:, 1]).max() / np.abs(exact).max():.2f}")

figure, axes = axes_of(1, 2, (11, 4.2))
if figure:
    wave = next(iter(drawn.values()))[0]
    axes[0].plot(wave["t"], wave["exact_velocity"][:, 1], "k--", linewidth=0.9, label="exact")
    for name, (middle, (origin, _, stress)) in drawn.items():
        axes[0].plot(middle["t"], middle["velocity"][:, 1], linewidth=0.9, label=name)
        axes[1].plot(stress[:, 1] / 1e3, origin[:, 1], ".", markersize=3, label=name)
    times, x, _, stress = reference("linear_large", 1.0, MODULUS, 1000.0, 2.5, force=-9.81, free_end=True)
    axes[1].plot(stress[-1] / 1e3, (x[1:] + x[:-1]) / 2, "k--", linewidth=0.9, label="reference in one dimension")
    axes[0].set(xlabel="t [s]", ylabel="velocity at mid-height [m/s]", ylim=(-0.8, 1.3), title="1 x 8 blocks")
    axes[1].set(xlabel="σ_yy [kPa]", ylabel="original height [m]", title="stress at t = 2.5 s")
    for axis, corner in zip(axes, ("upper right", "upper left")):
        axis.legend(fontsize=7, loc=corner)
        axis.grid(alpha=0.3)
    figure.savefig(HERE / "mass.png", dpi=110)
