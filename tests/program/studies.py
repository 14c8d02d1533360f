"""Studies through the command line: failing runs are rows, a killed study goes on where it was, answers are right.

Usage: studies.py PROGRAM [TEST …], the names of functions below; without names, all of them."""

import copy
import csv
import fcntl
import glob
import json
import os
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = os.path.abspath(sys.argv[1])

SQUARE = {
    "analysis": {"type": "quasi_static", "plane": "strain"},
    "material": {"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.3},
    "grid": {"lower": [-0.25, -0.25], "upper": [1.2, 1.2], "cell_size": 0.25, "basis": "bspline", "degree": 2},
    "material_points": {"per_cell": 4, "volumes": "fitted"},
}


def sine_square():
    """u = (a sin kx, 0): a smooth field with the body force in balance with it."""
    case = copy.deepcopy(SQUARE)
    case["boundaries"] = [
        {"name": name, "line": {"from": start, "to": end, "points": 2},
         "condition": {"type": "displacement", "value": "exact", "method": "nitsche"}}
        for name, start, end in (("bottom", [0, 0], [1, 0]), ("right", [1, 0], [1, 1]), ("top", [1, 1], [0, 1]),
                                 ("left", [0, 1], [0, 0]))]
    case["constants"] = {"k": 4.0, "a": 1e-4, "lambda": 1e6 * 0.3 / (1.3 * 0.4), "mu": 1e6 / 2.6}
    case["body_force"] = ["(lambda+2*mu)*a*k^2*sin(k*X)*t", "0"]
    case["exact"] = {"type": "expressions", "displacement": ["a*sin(k*X)*t", "0"],
                     "stress": ["(lambda+2*mu)*a*k*cos(k*X)*t", "lambda*a*k*cos(k*X)*t", "0"]}
    return case


def write(name, value):
    with open(name, "w") as stream:
        json.dump(value, stream)


def load(name):
    with open(name) as stream:
        return json.load(stream)


def study(name, case, sweep, **keys):
    write(f"{name}_case.json", case)
    write(f"{name}.json", {"title": name, "case": f"{name}_case.json", "sweep": sweep, "samples": 40} | keys)
    return f"{name}.json"


def run(file, *options, status=0, folder=None):
    """The study's study.json after a call that must end with a status."""
    folder = folder or file.removesuffix(".json")
    done = subprocess.run([PROGRAM, "study", file, "--output", folder, *options], capture_output=True, text=True,
                          timeout=300)
    assert done.returncode == status, f"status {done.returncode}, expected {status}: {done.stderr}"
    with open(os.path.join(folder, "study.json")) as stream:
        return json.load(stream) | {"said": done.stdout, "complained": done.stderr}


def failing_runs_are_rows():
    sweep = [{"key": "grid.degree", "values": [2, 9]}, {"key": "grid.cell_size", "values": [0.5, 0.25]}]
    done = run(study("degrees", sine_square(), sweep))
    assert [row["status"] for row in done["rows"]] == ["completed"] * 2 + ["failed"] * 2
    assert "/grid/degree: found 9" in done["rows"][2]["reason"], done["rows"][2]["reason"]
    assert "4 runs, 2 failed" in done["said"]

    done = run(study("typing", sine_square(), [{"key": "grid.cel_size", "values": [0.5, 0.25]}]), status=1)
    assert 'nearest: "cell_size"' in done["rows"][0]["reason"], done["rows"][0]["reason"]

    done = run(study("lists", sine_square(), [{"key": "boundaries.tpo.condition.band", "values": [0.1]}]), status=1)
    assert 'nearest: "top"' in done["rows"][0]["reason"], done["rows"][0]["reason"]


def budgets_hold():
    sweep = [{"key": "grid.cell_size", "values": [0.5, 0.002]}]
    done = run(study("memory", sine_square(), sweep, budget={"memory": 3e8}))
    assert [row["status"] for row in done["rows"]] == ["completed", "failed"], done["rows"]
    assert "more memory than budget.memory, 3e+08 bytes" in done["rows"][1]["reason"], done["rows"][1]["reason"]

    done = run(study("seconds", sine_square(), sweep, budget={"seconds": 1.0}))
    assert "longer than budget.seconds, 1 s" in done["rows"][1]["reason"], done["rows"][1]["reason"]


def a_limited_address_space_fails_a_row():
    sweep = [{"key": "grid.cell_size", "values": [0.5, 0.002]}]
    file = study("ulimit", sine_square(), sweep)
    limit = lambda: resource.setrlimit(resource.RLIMIT_AS, (6 * 10**8, 6 * 10**8))
    status = subprocess.run([PROGRAM, "study", file, "--output", "ulimit", "--quiet"], preexec_fn=limit, timeout=300,
                            capture_output=True).returncode
    with open("ulimit/study.json") as stream:
        rows = json.load(stream)["rows"]
    assert status == 0 and "memory" in rows[1]["reason"], rows[1]["reason"]


def without_times(done):
    """What of a study does not depend on the moment."""
    timeless = copy.deepcopy(done["rows"])
    for row in timeless:
        for key in ("seconds", "phases", "peak_memory_bytes"):
            row.pop(key, None)
    return timeless


def children_of(folder):
    """Processes whose arguments name a folder."""
    found = []
    for name in glob.glob("/proc/[0-9]*/cmdline"):
        try:
            with open(name, "rb") as stream:
                arguments = stream.read()
        except OSError:  # it has ended
            continue
        if os.path.join(folder, "runs").encode() in arguments:
            found.append(arguments)
    return found


def a_killed_study_goes_on():
    sweep = [{"key": "material_points.per_cell", "values": [2, 3, 4, 5, 6, 7]},
             {"key": "grid.cell_size", "values": [0.25, 0.2, 0.125, 0.1]}]
    file = study("killed", sine_square(), sweep)
    whole = run(file, folder="undisturbed")
    walls = [load(name)["wall"] for name in glob.glob("undisturbed/runs/*/record.json")]
    window = 5.0 * sum(walls) / len(walls)  # a few runs long, whatever else the machine does
    draw = random.Random(5)
    for _ in range(20):
        child = subprocess.Popen([PROGRAM, "study", file, "--output", "killed", "--quiet"], stdout=subprocess.DEVNULL)
        time.sleep(draw.uniform(0.0, window))
        child.send_signal(signal.SIGKILL)
        child.wait()
    time.sleep(0.2)
    assert not children_of("killed"), "a run went on after its study was killed"
    before = len(glob.glob("killed/runs/*/record.json"))
    resumed = run(file, folder="killed")
    assert 0 < before, "the test kills too early to see anything"
    assert without_times(resumed) == without_times(whole)

    records = {name: os.stat(name).st_mtime_ns for name in glob.glob("killed/runs/*/record.json")}
    again = run(file, folder="killed")
    assert records == {name: os.stat(name).st_mtime_ns for name in glob.glob("killed/runs/*/record.json")}
    assert again["rows"] == resumed["rows"]

    sweep[1]["values"].append(0.5)
    run(study("killed", sine_square(), sweep), folder="killed")
    new = {name for name in glob.glob("killed/runs/*/record.json")} - set(records)
    assert len(new) == 6, f"{len(new)} new runs, expected those of the new cell size"


def one_study_at_a_time():
    file = study("locked", sine_square(), [{"key": "grid.cell_size", "values": [0.5]}])
    run(file)
    with open("locked/runs/lock") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = subprocess.run([PROGRAM, "study", file, "--output", "locked"], capture_output=True, text=True)
    assert done.returncode == 3 and "another study" in done.stderr, done.stderr


def answer(name, case, tolerance, sweep=({"key": "grid.cell_size", "values": [0.125]},)):
    return run(study(name, case, list(sweep)), "--tolerance", tolerance)


def stretched_square():
    """Stretched by half in two steps: logarithmic in the limit of many, however coarse the grid."""
    case = sine_square()
    case["analysis"]["load_steps"] = 2
    case["boundaries"] = [
        {"name": name, "line": {"from": start, "to": end, "points": 2}, "condition": condition}
        for name, start, end, condition in (
            ("bottom", [0, 0], [1, 0], {"type": "roller"}),
            ("right", [1, 0], [1, 1], {"type": "displacement", "value": ["0.5*X*t", "0"]}),
            ("top", [1, 1], [0, 1], {"type": "roller"}), ("left", [0, 1], [0, 0], {"type": "roller"}))]
    del case["body_force"]
    case["grid"]["upper"] = [1.7, 1.2]
    case["exact"] = {"type": "expressions", "displacement": ["0.5*X*t", "0"],
                     "stress": ["(lambda+2*mu)*ln(1+0.5*t)", "lambda*ln(1+0.5*t)", "0"]}
    return case


def cylinder(points):
    arcs = [("outer", 2, 0, 90), ("inner", 1, 90, 0)]
    outer, inner = ({"name": name, "arc": {"centre": [0, 0], "radius": radius, "from": a, "to": b, "points": points}}
                    for name, radius, a, b in arcs)
    inner["condition"] = {"type": "pressure", "value": 1e3}
    sides = [{"name": name, "points": ends, "condition": {"type": "roller", "method": "nitsche"}}
             for name, ends in (("bottom", [[1, 0], [2, 0]]), ("left", [[0, 2], [0, 1]]))]
    return {"analysis": {"type": "quasi_static", "plane": "strain"}, "material": SQUARE["material"],
            "grid": {"lower": [-0.1, -0.1], "upper": [2.2, 2.2], "cell_size": 0.125, "basis": "bspline"},
            "boundaries": [sides[0], outer, sides[1], inner], "material_points": {"per_cell": 4, "volumes": "fitted"},
            "exact": {"type": "thick_cylinder", "inner_radius": 1, "outer_radius": 2, "pressure": 1e3}}


def the_part_that_dominates_is_named():
    smooth = sine_square()
    few = copy.deepcopy(smooth)
    few["material_points"] = {"across": [16, 16], "volumes": "lattice"}
    banded = copy.deepcopy(smooth)
    for piece in banded["boundaries"]:
        piece["condition"] |= {"method": "implicit_boundary", "band": 0.1}
    for name, case, norm, part in (("coarse", smooth, "stress.l2_relative", "grid"),
                                   ("few", few, "stress.l2_relative", "points"),
                                   ("arcs", cylinder(3), "displacement.l2_relative", "boundary points"),
                                   ("banded", banded, "displacement.l2_relative", "band"),
                                   ("steps", stretched_square(), "stress.l2_relative", "time step")):
        found = answer(name, case, f"{norm}=0.9")["tolerance"]
        assert found["dominant"] == part, f"{name}: {found}, expected {part}"


def the_chosen_setting_holds_on_a_shifted_grid():
    sweep = [{"key": "material_points.volumes", "values": ["lattice", "fitted"]},
             {"key": "grid.cell_size", "values": [0.5, 0.25, 0.125, 0.0625]}]
    done = answer("chosen", sine_square(), "stress.l2_relative=1e-2", sweep)
    row = done["rows"][done["tolerance"]["chosen"]]
    assert row["errors"]["stress.l2_relative"] <= 1e-2
    cheaper = [r for r in done["rows"] if r["status"] == "completed" and r["errors"]["stress.l2_relative"] <= 1e-2
               and r["seconds"]["median"] < row["seconds"]["median"]]
    h = row["labels"]["grid.cell_size"]
    with open(f"chosen/{row['folder']}/case.json") as stream:
        case = json.load(stream)
    case["grid"]["lower"] = [-0.25 - 0.37 * h, -0.25 - 0.21 * h]
    write("shifted.json", case)
    subprocess.run([PROGRAM, "run", "shifted.json", "--output", "shifted"], check=True, capture_output=True)
    with open("shifted/summary.json") as stream:
        assert json.load(stream)["errors"]["stress"]["l2_relative"] <= 1e-2
    for other in cheaper:  # they were tried, and refused
        assert f"not material_points.volumes {other['labels']['material_points.volumes']}" in done["said"]

    done = answer("unmet", sine_square(), "stress.l2_relative=1e-9", sweep)
    assert "no setting of this study has stress.l2_relative <= 1e-09" in done["said"], done["said"]


def without_an_exact_solution_runs_are_compared():
    case = sine_square()
    del case["exact"]
    for piece in case["boundaries"]:
        piece["condition"] = {"type": "fixed", "method": "nitsche"}
    case["boundaries"][1]["condition"] = {"type": "traction", "value": [0, 0]}
    case["boundaries"][1]["line"]["points"] = 3
    case["probes"] = [{"name": "edge", "position": [1, 0.5]}, {"name": "middle", "position": [0.4, 0.5]}]
    sweep = [{"key": "grid.cell_size", "values": [0.25, 0.125, 0.0625, 0.03125]}]
    finest = run(study("finest", case, sweep))
    errors = [row["errors"] for row in finest["rows"]]
    assert errors[3] == {} and {"energy", "probe.edge.displacement", "reaction.top"} <= set(errors[0])
    assert errors[0]["energy"] > 4 * errors[1]["energy"] > 16 * errors[2]["energy"]

    limit = run(study("limit", case, sweep, reference="richardson"))
    own = run(study("own", case, sweep, reference={"set": {"grid.cell_size": 0.015625}}))
    for name in ("energy", "probe.edge.displacement", "probe.middle.displacement"):
        exact = own["rows"][2]["errors"][name]
        assert abs(limit["rows"][2]["errors"][name] / exact - 1) < 0.1, name
    picked = run(study("finest", case, sweep), "--tolerance", "energy=1e-2")["tolerance"]
    assert picked["dominant"] == "grid" and picked["error_left"]["grid"] < 1e-2, picked
    assert "Richardson" in limit["device"] and "of their own" in own["device"]


def rows_come_from_outside():
    sweep = [{"key": "grid.cell_size", "values": [0.5, 0.25]}]
    first = run(study("first", sine_square(), sweep))
    second = run(study("second", sine_square(), sweep, outside=["first/study.csv"]))
    assert [row["unknowns"] for row in second["outside"]] == [row["unknowns"] for row in first["rows"]]
    for mine, theirs in zip(first["rows"], second["outside"]):
        assert abs(theirs["errors"]["stress.l2_relative"] / mine["errors"]["stress.l2_relative"] - 1) < 1e-9
    with open("second/study.csv", newline="") as stream:
        table = list(csv.DictReader(stream))
    assert [row["status"] for row in table] == ["completed"] * 2
    with open("other.csv", "w") as stream:
        stream.write("line,points,seconds\nother,10,fast\n")
    done = subprocess.run([PROGRAM, "study", study("third", sine_square(), sweep, outside=["other.csv"]), "--output",
                           "third"], capture_output=True, text=True)
    assert done.returncode == 2 and "other.csv: row 2" in done.stderr, done.stderr


def main():
    tests = [failing_runs_are_rows, budgets_hold, a_limited_address_space_fails_a_row,
             a_killed_study_goes_on, one_study_at_a_time,
             the_part_that_dominates_is_named, the_chosen_setting_holds_on_a_shifted_grid,
             without_an_exact_solution_runs_are_compared, rows_come_from_outside]
    wanted = sys.argv[2:]
    unknown = set(wanted) - {test.__name__ for test in tests}
    assert not unknown, f"no such test: {unknown}"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for test in tests:
            if wanted and test.__name__ not in wanted:
                continue
            start = time.monotonic()
            test()
            print(f"{test.__name__}: {time.monotonic() - start:.1f} s")


main()
