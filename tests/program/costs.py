"""What a case does not name costs nothing, and what it names is counted.

Usage: costs.py PROGRAM TEST"""

import copy
import json
import os
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])
E, NU = 1e6, 0.25
COLUMN = {
    "analysis": {"type": "quasi_static", "plane": "strain"},
    "material": {"type": "linear_elastic", "youngs_modulus": E, "poissons_ratio": NU},
    "grid": {"lower": [0, 0], "upper": [1.25, 1.25], "cell_size": 0.125, "basis": "bspline", "degree": 2},
    "ghost": 0,
    "boundaries": [
        {"name": "bottom", "points": [[0.103, 0.057], [1.103, 0.057]], "condition": {"type": "fixed"}},
        {"name": "right", "points": [[1.103, 0.057], [1.103, 1.057]]},
        {"name": "top", "points": [[1.103, 1.057], [0.103, 1.057]], "condition": {"type": "traction", "value": [0, -1]}},
        {"name": "left", "points": [[0.103, 1.057], [0.103, 0.057]]},
    ],
    "material_points": {"per_cell": 3},
    "output": {"pictures": False, "fields": []},
    "solver": {"threads": 1},
}


def with_keys(case, keys):
    changed = copy.deepcopy(case)
    for path, value in keys.items():
        at = changed
        *parents, last = path.split("/")
        for name in parents:
            at = at[int(name)] if isinstance(at, list) else at.setdefault(name, {})
        at[int(last) if isinstance(at, list) else last] = value
    return changed


def run(case, name="case"):
    with open(f"{name}.json", "w") as stream:
        json.dump(case, stream)
    done = subprocess.run([PROGRAM, "run", f"{name}.json", "--output", name, "--quiet"], capture_output=True, text=True,
                          timeout=200)
    assert done.returncode == 0, done.stderr
    with open(f"{name}/summary.json") as stream:
        return json.load(stream)


def plan(case):
    with open("plan.json", "w") as stream:
        json.dump(case, stream)
    done = subprocess.run([PROGRAM, "check", "plan.json"], capture_output=True, text=True, timeout=200)
    assert done.returncode == 0, done.stderr
    return done.stdout


EXACT = {"type": "expressions", "displacement": ["0", "-1e-6*(Y-0.057)*t"], "stress": ["0", "-t", "0"]}
# Effect: the keys that name it, the name under which it is listed, and the counts of it that are zero without.
EFFECTS = {
    "ghost penalty": ({"ghost": 1e-3}, "ghost_penalty", ["normal_derivatives"]),
    "fitted weights": ({"material_points/volumes": "fitted"}, "fitted_weights", ["weight_fits"]),
    "errors": ({"exact": EXACT}, "errors", ["exact_values"]),
    "samples": ({"exact": EXACT, "samples": 20}, "samples", ["exact_values"]),
    "probes": ({"probes": [{"name": "p", "position": [0.5, 0.5]}]}, "probes", []),
    "body force": ({"body_force": [0, -1]}, "body_force", []),
    "projected dilatation": ({"material/dilatation": "projected"}, "projected_dilatation", []),
    "traction": ({"boundaries/1/condition": {"type": "traction", "value": [1, 0]}}, "traction:right", []),
    "prescribed displacement": ({"boundaries/0/condition": {"type": "displacement", "value": [0, 1e-6]}}, None,
                                ["displacement_fits"]),
    "condition estimate": ({"diagnostics/condition_estimate": True}, "condition_estimate", []),
    "cut fractions": ({"diagnostics/cut_fractions": True}, "cut_fractions", []),
    "strain energy": ({"diagnostics/strain_energy": True}, "strain_energy", []),
    "error estimate": ({"diagnostics/error_estimate": True}, "error_estimate", []),
    "pictures": ({"output/pictures": True}, "pictures", []),
}


def what_is_not_named_is_not_done():
    without = run(COLUMN)
    assert set(without["effects"]) == {"linear_elastic", "implicit_boundary:bottom", "traction:top"}, without["effects"]
    for effect, (keys, listed, counters) in EFFECTS.items():
        named = run(with_keys(COLUMN, keys))
        more = {name for name in named["counters"] if named["counters"][name] > without["counters"][name]}
        for counter in counters:
            assert without["counters"][counter] == 0 and counter in more, (effect, counter, named["counters"])
        if listed:
            assert listed not in without["effects"] and listed in named["effects"], (effect, named["effects"])
            assert named["effect_costs"][listed]["calls"] > 0, effect
    assert run(COLUMN)["counters"] == without["counters"]


def the_plan_lists_what_will_run():
    for keys in [{}] + [keys for keys, _, _ in EFFECTS.values()]:
        case = with_keys(COLUMN, keys)
        lines = plan(case).split("will not run")[0].splitlines()
        listed = {line.split()[0] for line in lines[3:] if line.strip()} - {"strain"}
        assert listed == set(run(case)["effects"]), (keys, listed, run(case)["effects"])


def a_linear_step_is_one_factorisation():
    for basis in ({"basis": "bilinear"}, {"basis": "bspline", "degree": 2}, {"basis": "powell_sabin"},
                  {"basis": "linear"}):
        case = copy.deepcopy(COLUMN)
        case["grid"] = {key: COLUMN["grid"][key] for key in ("lower", "upper", "cell_size")} | basis
        if basis["basis"] in ("linear", "powell_sabin"):
            case["grid"]["cells"] = "triangle"
        case["ghost"] = 1e-3
        case["material_points"]["per_cell"] = 6
        one = run(case)["counters"]
        assert one["factorisations"] == 1, (basis, one)
        three = run(with_keys(case, {"analysis/load_steps": 3}))["counters"]
        assert three["factorisations"] == 3, (basis, three)
        cholmod = with_keys(case, {"analysis/load_steps": 3, "solver/type": "cholmod"})
        assert run(cholmod)["counters"]["analyses"] == 1, basis  # the loads are small: the pattern stays
        assert one["analyses"] == 0, (basis, one)  # the band needs none


def load_cases_share_one_factorisation():
    """With geometry initial the state after a step is what its load would do alone, in one step from the start."""
    place = {"name": "corner", "position": [1.103, 1.057]}
    case = with_keys(COLUMN, {"analysis/geometry": "initial", "ghost": 1e-3, "probes": [place]})
    loads = [["0", "-1"], ["1", "0"], ["3", "-2"]]
    together = copy.deepcopy(case)
    together["analysis"]["load_steps"] = 3
    together["boundaries"][2]["condition"]["value"] = [
        f"t<0.4 ? {loads[0][k]} : (t<0.7 ? {loads[1][k]} : {loads[2][k]})" for k in (0, 1)]
    done = run(together, "together")
    assert done["counters"]["factorisations"] == 1, done["counters"]
    assert done["counters"]["traces"] < 2 * run(case)["counters"]["traces"]
    alone = copy.deepcopy(case)
    alone["boundaries"][2]["condition"]["value"] = [float(number) for number in loads[2]]
    single = run(alone, "alone")
    for a, b in zip(done["probes"]["corner"]["displacement"], single["probes"]["corner"]["displacement"]):
        assert abs(a - b) <= 1e-14, (a, b)
    for a, b in zip(done["reactions"]["bottom"], single["reactions"]["bottom"]):
        assert abs(a - b) <= 1e-9, (a, b)


def loops_over_points_do_not_allocate():
    counts = {}
    for per_cell in (3, 9):
        for steps in (1, 2):
            case = with_keys(COLUMN, {"material_points/per_cell": per_cell, "analysis/load_steps": steps,
                                      "body_force": [0, -1]})
            counts[per_cell, steps] = run(case)["counters"]["allocations"]
    assert counts[3, 1] > 0, "the program does not count"
    assert counts[9, 1] == counts[3, 1] and counts[9, 2] == counts[3, 2], counts


def memory_is_predicted():
    for keys in ({"grid/cell_size": 0.01}, {"grid/cell_size": 0.01, "material_points/per_cell": 6},
                 {"grid/basis": "bilinear", "grid/cell_size": 0.005},
                 {"grid/cell_size": 0.02, "material_points/per_cell": 24, "output/fields": ["strain"]},
                 {"grid/cell_size": 0.004, "grid/basis": "bilinear", "material_points/per_cell": 2},
                 {"grid/cell_size": 0.01, "diagnostics/error_estimate": True},
                 {"grid/cell_size": 0.01, "material_points/volumes": "fitted", "ghost": 1e-3}):
        case = with_keys(COLUMN, keys)
        if case["grid"]["basis"] == "bilinear":
            del case["grid"]["degree"]
        text = plan(case)
        predicted = 1e6 * float(text.split("predicted memory")[1].split()[0])
        used = run(case)["peak_memory_bytes"]
        assert abs(predicted / used - 1) <= 0.2, (keys, predicted, used)


def main():
    names = ["what_is_not_named_is_not_done", "the_plan_lists_what_will_run", "a_linear_step_is_one_factorisation",
             "load_cases_share_one_factorisation", "loops_over_points_do_not_allocate", "memory_is_predicted"]
    assert sys.argv[2] in names, f"no such test: {sys.argv[2]}"
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        globals()[sys.argv[2]]()


main()
