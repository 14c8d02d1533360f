"""Tables of the benchmarks.

    table.py PROGRAM [OPTIONS]    runs shoreline_bench with options of Google Benchmark, writes bench.json (or the file
                                  of --benchmark_out) and prints what it holds
    table.py FILE.json            prints it
    table.py --compare A B        ratios of the times of B to those of A, for what both files hold
    table.py --memory SHORELINE   runs the program `shoreline` and prints the peak memory by point and by unknown

Of several repetitions the medians count.
"""

import json
import math
import os
import re
import statistics
import subprocess
import sys
import tempfile

OURS = ["support", "boundary", "assembly", "pattern", "update"]
SOLVER = ["analyse", "factorise", "solve"]
BYTES_OF_POINT = 96  # state 72, order 4, place 16, cell 4
EXPLICIT = ["boundary", "forces", "mass", "accelerate", "move", "cells"]


def load(path):
    """Counters by name, with the time that counts in seconds as `time`."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    rows = {}
    for run in runs:
        if run.get("aggregate_name", "median") != "median" or run.get("error_occurred"):
            continue
        name = re.sub(r"/(iterations:1|manual_time|repeats:\d+)|_median$", "", run["name"])
        if "aggregate_name" in run or "aggregate_name" not in rows.get(name, {}):
            unit = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}[run["time_unit"]]
            rows[name] = {**run, "time": run["real_time"] * unit}
    return rows


def select(rows, group):
    """Rows of a group: the parts of the names after it, and the counters."""
    return [(name.split("/")[1:], row) for name, row in rows.items() if name.startswith(group + "/")]


def value_of(part):
    return int(part.split(":")[1])


def line(*cells):
    print(" ".join(f"{c:9.2f}" if isinstance(c, float) else f"{c:>9}" for c in cells))


def print_bounds(rows):
    for (threads,), row in select(rows, "bounds"):
        operations, traffic = row["operations"] / 1e9, row["bytes"] / 1e9
        print(f"{threads}: {operations:.1f}e9 scalar operations and {traffic:.1f}e9 bytes a second")


def print_support(rows):
    costs = {}
    for (basis, part), row in select(rows, "support"):
        costs.setdefault(basis, {})[part] = 1e9 * row["seconds_a_point"]
    if not all(len(c) == 2 for c in costs.values()) or "bilinear" not in costs:
        return
    print(f"\nnanoseconds a point\n{'basis':<18} {'locate':>9} {'evaluate':>9} {'sum':>9} {'/bilinear':>9}")
    for basis, c in costs.items():
        total, ratio = sum(c.values()), sum(c.values()) / sum(costs["bilinear"].values())
        print(f"{basis:<18} {c['locate']:9.1f} {c['evaluate']:9.1f} {total:9.1f} {ratio:9.2f}")


def phases(row, step, names):
    return [row.get(f"step{step}_{name}", 0.0) for name in names]


def load_steps(rows):
    """Rows of load steps as (basis, threads, counters)."""
    return [(parts[0], value_of(parts[-1]), row) for parts, row in select(rows, "load_step")]


def print_load_steps(rows):
    if not load_steps(rows):
        return
    triad = max(row["triad"] for _, _, row in load_steps(rows))
    print(f"\nload steps, milliseconds; passes: support and assembly, in triads over {BYTES_OF_POINT} bytes a point")
    print(f"at {triad / 1e9:.1f}e9 bytes a second")
    line("basis", "points", "unknowns", "threads", "step", *OURS, *SOLVER, "rest/fact", "passes")
    for basis, threads, row in load_steps(rows):
        for step in (1, 2):
            seconds = phases(row, step, OURS + SOLVER)
            factorise = phases(row, step, ["factorise"])[0]
            line(basis, int(row["points"]), int(row["unknowns"]), threads, step, *(1e3 * s for s in seconds),
                 (sum(seconds) - factorise) / factorise,
                 sum(phases(row, step, ["support", "assembly"])) * triad / (BYTES_OF_POINT * row["points"]))
    print("\none thread, nanoseconds a point (step 2) and an unknown (pattern and analyse: step 1)")
    line("basis", "points", "unknowns", "support", "assembly", "update", "pattern", "analyse", "factorise", "solve")
    for basis, threads, row in load_steps(rows):
        if threads == 1:
            by_point = [1e9 * s / row["points"] for s in phases(row, 2, ["support", "assembly", "update"])]
            by_unknown = phases(row, 1, ["pattern", "analyse"]) + phases(row, 2, ["factorise", "solve"])
            line(basis, int(row["points"]), int(row["unknowns"]), *by_point,
                 *(1e9 * s / row["unknowns"] for s in by_unknown))


def print_finite_elements(rows):
    elements = {row["cells"]: row for _, row in select(rows, "finite_elements")}
    ours = {row["cells"]: row for basis, threads, row in reversed(load_steps(rows))
            if (basis, threads) == ("bilinear", 1) and row["points"] < 17 * row["cells"]}
    shared = [cells for cells in elements if cells in ours]
    if not shared:
        return
    print("\nassembly, one thread, step 2, microseconds a cell: finite elements with 4 Gauss points (elements,")
    print("scatter), 16 material points a cell (support, assembly)")
    line("cells", "elements", "scatter", "support", "assembly", "ratio")
    for cells in shared:
        plain = phases(elements[cells], 2, ["elements", "scatter"])
        material = phases(ours[cells], 2, ["support", "assembly"])
        line(int(cells), *(1e6 * s / cells for s in plain + material), sum(material) / sum(plain))


def own_seconds(row):
    return sum(phases(row, 2, OURS))


def print_exponents(rows):
    """Of cost in points, at fixed unknowns and with 16 points a cell."""
    for sizes, what in [("fixed_unknowns", "at fixed unknowns"), ("points:", "at 16 points a cell")]:
        found = [(row["points"], own_seconds(row), row["time"]) for parts, row in select(rows, "load_step")
                 if parts[0] == "bilinear" and parts[1].startswith(sizes) and value_of(parts[-1]) == 1]
        for low, high in zip(found, found[1:]):
            points, own, step = (math.log(b / a) for a, b in zip(low, high))
            print(f"exponent in points {what}, {low[0]:.3g} to {high[0]:.3g}: {own / points:.3f} without the solver, "
                  f"{step / points:.3f} of the step")


def fit_two(p, q):
    """a and b for which a p + b q is nearest to one."""
    pp, pq, qq = (sum(x * y for x, y in zip(*pair)) for pair in [(p, p), (p, q), (q, q)])
    determinant = pp * qq - pq * pq
    return (sum(p) * qq - sum(q) * pq) / determinant, (sum(q) * pp - sum(p) * pq) / determinant


def power_law(rows, value):
    """c and e of value = c unknowns^e."""
    law = statistics.linear_regression(*([math.log(v(row)) for row in rows] for v in (lambda r: r["unknowns"], value)))
    return math.exp(law.intercept), law.slope


def print_model(rows):
    """Fits what a step on one thread costs, and says what that means for 1e8 points."""
    fit = [row for basis, threads, row in load_steps(rows)
           if (basis, threads) == ("bilinear", 1) and row["points"] > 5e4]
    large = [row for row in fit if row["unknowns"] > 5e4]
    if len(large) < 3 or max(row["points"] / row["cells"] for row in fit) < 100:
        return
    a, b = fit_two(*([row[key] / own_seconds(row) for row in fit] for key in ("points", "cells")))
    off = max(abs((a * row["points"] + b * row["cells"]) / own_seconds(row) - 1) for row in fit)
    laws = {name: power_law(large, value) for name, value in
            [("factorise", lambda r: r["step2_factorise"]), ("solve", lambda r: r["step2_solve"]),
             ("factor", lambda r: r["factor_bytes"])]}
    print("\nseconds of a step that reuses pattern and analysis, bilinear, one thread:")
    print(f"  {a * 1e9:.1f}e-9 points + {b * 1e9:.0f}e-9 cells (off by at most {100 * off:.0f} %)")
    for name in ("factorise", "solve"):
        print(f"  + {laws[name][0]:.2e} unknowns^{laws[name][1]:.2f} ({name})")
    print(f"bytes of the factor: {laws['factor'][0]:.0f} unknowns^{laws['factor'][1]:.2f}")
    for per_cell in (16, 160, 1600):
        unknowns = 2e8 / per_cell
        factorise, solve, factor = (c * unknowns**e for c, e in laws.values())
        own = a * 1e8 + b * unknowns / 2
        print(f"1e8 points, {per_cell} a cell, {unknowns:.3g} unknowns: all but the solver {own:.1f} s, "
              f"factorise {factorise:.1f} s, solve {solve:.1f} s, factor {factor * 1e-9:.1f} GB")


def print_solvers(rows):
    found = select(rows, "solvers")
    if found:
        print("\nsolvers, milliseconds of both steps")
        line("body", "unknowns", "method", "first", "second", "MB", "cg")
    for (body, _, method), row in found:
        line(body, int(row["unknowns"]), method, *(1e3 * sum(phases(row, step, SOLVER)) for step in (1, 2)),
             1e-6 * row["factor_bytes"], int(row["cg"]))


def print_explicit(rows):
    found = select(rows, "explicit_step")
    if not found:
        return
    columns = " ".join(f"{name:>7}" for name in ["points", "threads", "M/s", "best", "speedup", "/scalar", "/triad"])
    phase_names = " ".join(f"{phase:>5.5}" for phase in EXPLICIT)
    print(f"\nexplicit steps\n{'basis':<12} {'mass':<13} {columns} {'cg':>6}  {phase_names}")
    for (basis, mass, threads), row in found:
        one = rows.get(f"explicit_step/{basis}/{mass}/threads:1", row)
        spent = [row.get("phase_" + phase, 0.0) for phase in EXPLICIT]
        rates = [1e-6 * row["points"] / row[key] for key in ("time", "best")]
        ratios = [one["time"] / row["time"], row["/scalar"], row["/triad"]]
        print(f"{basis:<12} {mass:<13} {row['points']:7.0f} {value_of(threads):7d} "
              + " ".join(f"{v:7.2f}" for v in rates + ratios) + f" {row['cg']:6.1f}  "
              + " ".join(f"{100 * s / sum(spent):4.0f}%" for s in spent))


def compare(before, after):
    """Times and seconds by phase of the second file over those of the first."""
    for name in (n for n in before if n in after):
        a, b = before[name], after[name]
        keys = ["time"] + [k for k in a if re.match("step|phase_", k) and a[k] > 1e-4 and b.get(k, 0) > 0]
        print(f"{name}: " + ", ".join(f"{key} {b[key] / a[key]:.2f}" for key in keys))


def peak_memory(shoreline, cells, per_cell):
    """Bytes of a child process that runs two load steps."""
    low, high = 0.3 / cells, 1 - 0.4 / cells
    corners = [[low, low], [high, low], [high, high], [low, high], [low, low]]
    conditions = [{"type": "roller"}, {"type": "roller"}, {"type": "traction", "value": [0, -1]}, {"type": "roller"}]
    case = {"title": "memory", "analysis": {"type": "quasi_static", "plane": "strain", "load_steps": 2},
            "material": {"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.25},
            "grid": {"lower": [0, 0], "upper": [1, 1], "cell_size": 1 / cells}, "solver": {"type": "cholmod"},
            "boundaries": [{"name": f"side{k}", "points": corners[k:k + 2], "condition": condition}
                           for k, condition in enumerate(conditions)],
            "material_points": {"per_cell": [per_cell, per_cell]}, "output": {"pictures": False, "every": 2}}
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "case.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump(case, file)
        child = subprocess.Popen([shoreline, "run", path, "--output", folder, "--quiet"], stdout=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status:
            sys.exit("the run failed")
        with open(os.path.join(folder, "summary.json"), encoding="utf-8") as file:
            summary = json.load(file)
    return summary["material_points"], summary["degrees_of_freedom"], 1024 * usage.ru_maxrss


def print_memory(shoreline):
    runs = {key: peak_memory(shoreline, *key) for key in [(79, 13), (79, 40), (250, 4), (500, 4)]}
    for points, unknowns, memory in runs.values():
        print(f"{points} points, {unknowns} unknowns: {memory / 1e6:.0f} MB")
    (p, _, m), (q, _, n) = runs[79, 13], runs[79, 40]
    point = (n - m) / (q - p)
    (p, u, m), (q, v, n) = runs[250, 4], runs[500, 4]
    print(f"{point:.0f} bytes a point at fixed unknowns; at 16 points a cell "
          f"{(n - m - point * (q - p)) / (v - u):.0f} bytes an unknown besides, with CHOLMOD's factor")


def run(program, options):
    out = next((o.split("=", 1)[1] for o in options if o.startswith("--benchmark_out=")), "bench.json")
    environment = {"OMP_WAIT_POLICY": "passive", "OPENBLAS_THREAD_TIMEOUT": "4", **os.environ}
    command = [program, *options, f"--benchmark_out={out}"]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
    return out


def main(arguments):
    if arguments[:1] == ["--compare"] and len(arguments) == 3:
        return compare(load(arguments[1]), load(arguments[2]))
    if arguments[:1] == ["--memory"] and len(arguments) == 2:
        return print_memory(arguments[1])
    if not arguments or arguments[0].startswith("-"):
        sys.exit(__doc__)
    rows = load(arguments[0] if arguments[0].endswith(".json") else run(arguments[0], arguments[1:]))
    for table in [print_bounds, print_support, print_finite_elements, print_load_steps, print_exponents, print_model,
                  print_solvers, print_explicit]:
        table(rows)


main(sys.argv[1:])
