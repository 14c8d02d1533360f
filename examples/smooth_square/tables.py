#!/usr/bin/env python3
"""Prints the tables of this folder's README: errors and cost of every basis, exactly integrated and with equal points.

    examples/smooth_square/tables.py [PROGRAM]

PROGRAM is the built `shoreline`; without it, the one that ./run builds. Draws convergence.png beside this script, too,
where python3 has matplotlib.
"""
import json
import math
import pathlib
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from runs import HERE, run, row, seconds, table  # beside the folders of the examples

BASES = {
    "bilinear": {"basis": "bilinear"},
    "linear": {"basis": "linear"},
    "powell_sabin": {"basis": "powell_sabin"},
    "bspline, degree 2": {"basis": "bspline", "degree": 2},
    "bspline, degree 3": {"basis": "bspline", "degree": 3},
}
CASE = json.loads((HERE / "square.json").read_text())

# Gauss-Legendre points and weights on [0, 1], exact to degree 7
NEAR, FAR = (math.sqrt(3 / 7 - s * 2 / 7 * math.sqrt(6 / 5)) / 2 for s in (1, -1))
GAUSS = [(0.5 + side * x, (18 + s * math.sqrt(30)) / 72) for x, s in ((NEAR, 1), (FAR, -1)) for side in (-1, 1)]


def on_rectangle(x, y, h):
    return [((x + h * a, y + h * b), u * v * h * h) for a, u in GAUSS for b, v in GAUSS]


def on_triangle(p, q, r):
    """The rule of a square, collapsed: exact to degree 6."""
    twice_area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    at = lambda a, b: tuple(p[i] + a * (q[i] - p[i] + b * (r[i] - q[i])) for i in (0, 1))
    return [(at(a, b), u * v * a * twice_area) for a, u in GAUSS for b, v in GAUSS]


def in_six(p, q, r):
    """The Powell-Sabin parts of a triangle whose edges are met in the middle: about the incentre."""
    side = [math.dist(q, r), math.dist(r, p), math.dist(p, q)]
    middle = lambda a, b: tuple((a[i] + b[i]) / 2 for i in (0, 1))
    z = tuple(sum(s * v[i] for s, v in zip(side, (p, q, r))) / sum(side) for i in (0, 1))
    for v, after, before in ((p, q, r), (q, r, p), (r, p, q)):
        yield v, middle(v, after), z
        yield v, z, middle(before, v)


def exact_points(basis, n):
    """Points and volumes that integrate every function's products exactly on n cells a side."""
    h = 1 / n
    rule = []
    for x, y in ((i * h, j * h) for j in range(n) for i in range(n)):
        if basis in ("bilinear", "bspline"):
            rule += on_rectangle(x, y, h)
            continue
        corner = (x, y), (x + h, y), (x + h, y + h), (x, y + h)
        for triangle in (corner[:3], (corner[0], *corner[2:])):
            for part in in_six(*triangle) if basis == "powell_sabin" else [triangle]:
                rule += on_triangle(*part)
    return {"points": [x for x, _ in rule], "volumes": [v for _, v in rule]}


def solve(basis, n, points):
    """Summary of the square with a basis on n cells a side and given material points."""
    case = CASE | {"grid": CASE["grid"] | BASES[basis] | {"cell_size": 1 / n}, "material_points": points}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(json.dumps(case))
        file.flush()
        return run(file.name, {})


def errors(summary):
    return [summary["errors"][field]["l2_relative"] for field in ("displacement", "stress")]


def rate(before, after):
    return f"{math.log2(before / after):.2f}"


def to_reach(error, done, k):
    """(unknowns, seconds) at which norm k falls to an error, along the line through the nearest two runs."""
    runs = [(errors(s)[k], s["degrees_of_freedom"], float(seconds(s))) for s in done.values()]
    inside = [i for i in range(1, len(runs)) if runs[i][0] <= error]
    coarse, fine = runs[(inside or [len(runs) - 1])[0] - 1:][:2]
    share = math.log(coarse[0] / error) / math.log(coarse[0] / fine[0])
    at = lambda i: math.exp(math.log(coarse[i]) + share * (math.log(fine[i]) - math.log(coarse[i])))
    mark = "" if inside else " (continued)"
    return f"{at(1):.2g}{mark}", f"{at(2):.2g}{mark}"


print("# Exactly integrated: 16 Gauss points a cell")
curves = {}
for name, grid in BASES.items():
    print(f"\n{name}:")
    table("cells a side", "unknowns", "rel. L2, displacement", "rate", "rel. L2, stress", "rate", "seconds")
    done = curves[name] = {}
    for n in (8, 16, 32, 64, 128)[:4 if name == "powell_sabin" else 5]:
        done[n] = solve(name, n, exact_points(grid["basis"], n))
        (u, s), before = errors(done[n]), done.get(n // 2)
        rates = [rate(*pair) for pair in zip(errors(before), (u, s))] if before else ["", ""]
        row(n, done[n]["degrees_of_freedom"], f"{u:.3e}", rates[0], f"{s:.3e}", rates[1], seconds(done[n]))

print("\n# What an error costs")
table("basis", "unknowns for 1e-4 displacement", "seconds", "unknowns for 1e-3 stress", "seconds")
for name, done in curves.items():
    row(name, *to_reach(1e-4, done, 0), *to_reach(1e-3, done, 1))

def listed_lattice(per_square, n):
    """Equal points on a lattice that knows nothing of triangles."""
    m = n * per_square
    return {"points": [((i + 0.5) / m, (j + 0.5) / m) for j in range(m) for i in range(m)], "volumes": [1 / m**2] * m**2}


print("\n# Equal points, placed cell by cell (fill lattice): displacement / stress (relative L2)")
for n in (8, 16, 32):
    print(f"\n{n} cells a side:")
    table("points a cell", *BASES)
    for per_cell in (2, 4, 8, 16):
        done = [solve(name, n, {"per_cell": per_cell}) for name in BASES]
        row(f"{per_cell}²", *(f"{errors(s)[0]:.1e} / {errors(s)[1]:.1e}" if isinstance(s, dict) else "singular"
                              for s in done))
    row("exact", *(f"{errors(c[n])[0]:.1e} / {errors(c[n])[1]:.1e}" for c in curves.values()))

print("\n# Equal points on one lattice, whatever the cells: displacement / stress (relative L2)")
table("cells a side", "points a square", "linear", "powell_sabin")
for n in (8, 16, 32):
    for per_square in (2, 4, 8, 16):
        done = [solve(name, n, listed_lattice(per_square, n)) for name in ("linear", "powell_sabin")]
        row(n, f"{per_square}²", *(f"{errors(s)[0]:.1e} / {errors(s)[1]:.1e}" if isinstance(s, dict) else "singular"
                                  for s in done))

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit()
figure, axes = plt.subplots(1, 2, figsize=(10, 4), constrained_layout=True)
for k, (axis, field) in enumerate(zip(axes, ("displacement", "stress"))):
    for name, done in curves.items():
        axis.loglog([s["degrees_of_freedom"] for s in done.values()], [errors(s)[k] for s in done.values()], "o-",
                    label=name, markersize=4)
    axis.set(xlabel="unknowns", ylabel=f"relative L2 error, {field}")
    axis.grid(alpha=0.3)
axes[0].legend()
figure.savefig(HERE / "convergence.png", dpi=110)
