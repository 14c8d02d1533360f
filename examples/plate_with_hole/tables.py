#!/usr/bin/env python3
"""Prints the tables of this folder's README: errors over the cell size, the band, the points and the place of the grid.

    examples/plate_with_hole/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png and error_map.png beside
this script, too, where python3 has matplotlib and h5py.
"""
import math
import pathlib
import random
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples

HELD = ("outer", "left", "bottom")
OUTER_LENGTH = 4.1412792974  # m
EXPONENTS = range(1, 7)


def cells(exponent):
    return {"grid.cell_size": 2.0**-exponent}


def support(method, band):
    return {f"boundaries.{p}.condition.{key}": v for p in HELD for key, v in (("method", method), ("band", band))}


def mean_u(summary):
    return summary["errors"]["displacement"]["mean_absolute"][0]


def mean_v(summary):
    return summary["errors"]["displacement"]["mean_absolute"][1]


def l2(summary, field):
    return summary["errors"][field]["l2_relative"]


def rate(coarse, fine, halvings=1):
    return f"{math.log2(coarse / fine) / halvings:.2f}"


def over_cell_size(case, settings):
    """A table of errors, rates and cost; the runs by exponent."""
    table("h [m]", "mean error u [m]", "mean error v [m]", "rel. L2, displacement", "rate", "rel. L2, stress", "rate",
          "points", "unknowns", "seconds")
    done = {}
    for k in EXPONENTS:
        s = run(case, cells(k) | settings)
        if isinstance(s, str):
            row(f"2^-{k}", "singular", *[""] * 8)
            continue
        before = done.get(k - 1)
        row(f"2^-{k}" + ("*" if s["warnings"] else ""), f"{mean_u(s):.3e}", f"{mean_v(s):.3e}",
            f"{l2(s, 'displacement'):.3e}", rate(l2(before, "displacement"), l2(s, "displacement")) if before else "",
            f"{l2(s, 'stress'):.3e}", rate(l2(before, "stress"), l2(s, "stress")) if before else "",
            s["material_points"], s["degrees_of_freedom"], seconds(s))
        done[k] = s
    return done


def slope(runs, norm, first, last):
    return rate(norm(runs[first]), norm(runs[last]), last - first)


curves = {}

print("# Traction on the outer boundary: cell size")
for volumes, ghost in (("clipped", 0), ("clipped", 1e-3), ("lattice", 0), ("lattice", 1e-3)):
    print(f"\n{volumes} volumes, ghost {ghost}:")
    runs = over_cell_size("neumann.json", {"material_points.volumes": volumes, "ghost": ghost})
    first = min(runs)
    print(f"\nslope from 2^-{first} to 2^-6: u {slope(runs, mean_u, first, 6)}, v {slope(runs, mean_v, first, 6)}")
    curves[f"traction, {volumes}, ghost {ghost}"] = runs

print("\n# Both cases: 20 places of the grid, h = 1/8, ghost 1e-3")
table("case", "norm", "least", "median", "greatest")
for case in ("neumann", "dirichlet"):
    draw = random.Random(11)
    places = [[-draw.random() / 8, -draw.random() / 8] for _ in range(20)]
    runs = [run(f"{case}.json", cells(3) | {"ghost": 1e-3, "grid.lower": place}) for place in places]
    for name, norm in (("mean error u [m]", mean_u), ("mean error v [m]", mean_v),
                       ("rel. L2, stress", lambda s: l2(s, "stress"))):
        values = sorted(map(norm, runs))
        row(f"`{case}.json`", name, f"{values[0]:.3e}", f"{(values[9] + values[10]) / 2:.3e}", f"{values[-1]:.3e}")

print("\n# Displacement on the outer boundary: the fit")
table("h [m]", "mean [m]", "rate", "rms [m]", "rate")
fits = {}
for k in EXPONENTS:
    fit = run("dirichlet.json", cells(k))["displacement_fit"]["outer"]
    fits[k] = fit["mean"], fit["l2"] / math.sqrt(OUTER_LENGTH)
    row(f"2^-{k}", *(e for mine, before in zip(fits[k], fits.get(k - 1, (None, None)))
                     for e in (f"{mine:.3e}", rate(before, mine) if before else "")))
print("\nslope from 2^-1 to 2^-6:", *(rate(a, b, 5) for a, b in zip(fits[1], fits[6])))

print("\n# Displacement on the outer boundary: method and band over the cell size")
for method, band, ghost in (("implicit_boundary", 1e-3, 0), ("implicit_boundary", 1e-6, 0), ("nitsche", 0.01, 1e-3)):
    print(f"\n{method}, band {band:g}, ghost {ghost}:")
    runs = over_cell_size("dirichlet.json", support(method, band) | {"ghost": ghost})
    print(f"\nslope from 2^-1 to 2^-6: u {slope(runs, mean_u, 1, 6)}, v {slope(runs, mean_v, 1, 6)}")
    curves[f"displacement, {method} {band:g}"] = runs

print("\n# Greatest errors of u and v [m]")
table("outer boundary", "h [m]", "the paper", "lattice volumes", "clipped volumes")
for name, case, k, settings, paper in (
        ("traction", "neumann.json", 5, {}, "5.61e-04, 3.59e-04"),
        ("displacement, band 1e-6", "dirichlet.json", 6, support("implicit_boundary", 1e-6), "3.16e-05, 1.93e-05")):
    runs = [run(case, cells(k) | settings | {"material_points.volumes": v}) for v in ("lattice", "clipped")]
    row(name, f"2^-{k}", paper, *(", ".join(f"{e:.2e}" for e in s["errors"]["displacement"]["max_absolute"]) for s in runs))

print("\n# Displacement on the outer boundary: points a cell, mean error u and mean relative error of σ_xx")
table("volumes", "points a cell", *(f"u, 2^-{k}" for k in EXPONENTS), *(f"σ_xx, 2^-{k}" for k in EXPONENTS))
for volumes in ("lattice", "clipped"):
    for n in (2, 4, 8):
        runs = [run("dirichlet.json", cells(k) | {"material_points.per_cell": n, "material_points.volumes": volumes})
                for k in EXPONENTS]
        row(volumes, f"{n}²", *(f"{mean_u(s):.1e}" for s in runs),
            *(f"{s['errors']['stress']['mean_relative'][0]:.1e}" for s in runs))

print("\n# Every basis: relative L2 errors, displacement / stress")
BASES = {"bilinear": {}, "linear": {"basis": "linear"}, "powell_sabin": {"basis": "powell_sabin"},
         "bspline, degree 2": {"basis": "bspline", "degree": 2}, "bspline, degree 3": {"basis": "bspline", "degree": 3}}
NITSCHE = {f"boundaries.{p}.condition.method": "nitsche" for p in HELD}
for name, case, settings in (("tractions", "neumann", {}), ("displacements, implicit boundary", "dirichlet", {}),
                             ("displacements, Nitsche", "dirichlet", NITSCHE)):
    print(f"\n{name}:")
    table("basis", "h = 1/8", "1/16", "1/32", "orders", "points at 1/32", "unknowns", "seconds")
    for basis, keys in BASES.items():
        runs = [run(f"{case}.json", cells(k) | settings | {f"grid.{key}": v for key, v in keys.items()})
                for k in (3, 4, 5)]
        last = runs[-1]
        row(f"{basis}", *(f"{l2(s, 'displacement'):.2e} / {l2(s, 'stress'):.2e}" for s in runs),
            " / ".join(rate(l2(runs[1], field), l2(last, field)) for field in ("displacement", "stress")),
            last["material_points"], last["degrees_of_freedom"], seconds(last))

print("\n# Weights fitted to the outline, Nitsche's method: relative L2 errors, displacement / stress")
ROLLERS = {f"boundaries.{p}.condition.method": "nitsche" for p in ("left", "bottom")}
paper = run("neumann.json", cells(5) | {"material_points.volumes": "lattice", "boundaries.left.condition.band": 1e-6,
                                        "boundaries.bottom.condition.band": 1e-6})
PER_CELL = {"bilinear": 2, "linear": 2, "powell_sabin": 2, "bspline, degree 2": 3, "bspline, degree 3": 4}
for name, case, settings in (("tractions", "neumann", ROLLERS), ("displacements", "dirichlet", NITSCHE)):
    print(f"\n{name}:")
    table("basis", "h = 1/8", "1/16", "1/32", "orders", "points at 1/32", "unknowns", "seconds", "of which weights")
    for basis, keys in BASES.items():
        fitted = {"material_points.volumes": "fitted", "material_points.per_cell": PER_CELL[basis]}
        runs = [run(f"{case}.json", cells(k) | settings | fitted | {f"grid.{key}": v for key, v in keys.items()})
                for k in (3, 4, 5)]
        last = runs[-1]
        row(f"{basis}", *(f"{l2(s, 'displacement'):.2e} / {l2(s, 'stress'):.2e}" for s in runs),
            " / ".join(rate(l2(runs[1], field), l2(last, field)) for field in ("displacement", "stress")),
            last["material_points"], last["degrees_of_freedom"], seconds(last), f"{last['timings']['weights']:.3f}")
    if case == "neumann":
        row("the papers' method", "", "", f"{l2(paper, 'displacement'):.2e} / {l2(paper, 'stress'):.2e}", "",
            paper["material_points"], paper["degrees_of_freedom"], seconds(paper), "")

try:
    import h5py
    import matplotlib
except ImportError:
    sys.exit("pictures not drawn: this python3 has no matplotlib or h5py; try /usr/bin/python3")
matplotlib.use("Agg")
import numpy
from matplotlib import colors, pyplot

figure, (left, right) = pyplot.subplots(1, 2, figsize=(11, 4.5), layout="constrained")
shown = {"traction, clipped, ghost 0.001": ("C0", "o"), "traction, lattice, ghost 0.001": ("C0", "s"),
         "displacement, implicit_boundary 0.001": ("C1", "o"), "displacement, implicit_boundary 1e-06": ("C1", "s"),
         "displacement, nitsche 0.01": ("C1", "^")}
for name, (colour, marker) in shown.items():
    sizes = [2.0**-k for k in curves[name]]
    left.loglog(sizes, [mean_u(s) for s in curves[name].values()], color=colour, marker=marker, label=name,
                linestyle="--" if marker == "s" else "-")
    right.loglog(sizes, [l2(s, "stress") for s in curves[name].values()], color=colour, marker=marker,
                 linestyle="--" if marker == "s" else "-")
left.loglog(sizes, [4e-2 * h**2 for h in sizes], color="0.6", linestyle=":", label="orders two and one")
right.loglog(sizes, [0.2 * h for h in sizes], color="0.6", linestyle=":")
for axes, title in ((left, "mean error of u [m]"), (right, "relative L2 error of stress")):
    axes.set(xlabel="h [m]", title=title)
    axes.grid(alpha=0.3)
left.legend(fontsize="small")
figure.savefig(HERE / "convergence.png", dpi=110)


def exact_displacement(x, y):
    """Kirsch's solution, plane stress, with the figures of both cases."""
    a, stress, youngs_modulus, poissons_ratio = 0.5, 1e6, 1e7, 0.2
    kappa = (3 - poissons_ratio) / (1 + poissons_ratio)
    r, theta = numpy.hypot(x, y) / a, numpy.arctan2(y, x)
    scale = stress * a * (1 + poissons_ratio) / (4 * youngs_modulus)
    cos, sin, cos3, sin3 = numpy.cos(theta), numpy.sin(theta), numpy.cos(3 * theta), numpy.sin(3 * theta)
    return (scale * (r * (kappa + 1) * cos + 2 / r * ((1 + kappa) * cos + cos3) - 2 / r**3 * cos3),
            scale * (r * (kappa - 3) * sin + 2 / r * ((1 - kappa) * sin + sin3) - 2 / r**3 * sin3))


def near(curve, x, y, distance):
    """Which points lie nearer than a distance to a curve, given as a polyline."""
    at = numpy.linspace(0, len(curve) - 1, 1000)
    samples = zip(*(numpy.interp(at, range(len(curve)), c) for c in curve.T))
    return numpy.any([numpy.hypot(x - a, y - b) < distance for a, b in samples], axis=0)


print("\n# Where the error is, h = 1/32: mean of its magnitude [m] within h/2 of a boundary")
table("case", "outer boundary", "hole", "whole body")
figure, panels = pyplot.subplots(1, 2, figsize=(11, 5), layout="constrained", sharey=True)
for axes, case in zip(panels, ("neumann", "dirichlet")):
    with tempfile.TemporaryDirectory() as folder:
        run(f"{case}.json", {}, folder)
        with h5py.File(pathlib.Path(folder) / "results.h5") as file:
            points = file["steps"][max(file["steps"], key=int)]["points"]
            moved = points["displacement"][:, :2]
            x, y = (points["position"][:, :2] - moved).T
            volume = points["volume"][:]
            start = file["steps"][min(file["steps"], key=int)]["curves"]
            places = [near(start[piece]["polyline"][:, :2], x, y, 1 / 64) for piece in ("outer", "hole")]
    error = numpy.hypot(*(moved.T - exact_displacement(x, y)))
    dots = axes.scatter(x, y, c=error, s=0.7, linewidths=0, norm=colors.LogNorm(1e-6, 3e-4))
    means = [numpy.average(error[place], weights=volume[place]) for place in (*places, slice(None))]
    row(f"`{case}.json`", *(f"{mean:.1e}" for mean in means))
    axes.set(aspect="equal", xlabel="x [m]", title=f"{case}.json: mean {means[-1]:.1e} m, most {error.max():.1e} m")
panels[0].set(ylabel="y [m]")
figure.colorbar(dots, ax=panels, label="|error of displacement| [m], at original positions", extend="both")
figure.savefig(HERE / "error_map.png", dpi=110)
