"""The program and what it runs on: the BLAS that is told, the component of multigrid that may be missing.

Usage: solvers.py PROGRAM TEST"""

import glob
import json
import os
import subprocess
import sys
import tempfile

PROGRAM = os.path.abspath(sys.argv[1])
SQUARE = {
    "analysis": {"type": "quasi_static", "plane": "strain"},
    "material": {"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.25},
    "grid": {"lower": [0, 0], "upper": [1, 1], "cell_size": 0.25},
    "boundaries": [
        {"name": "bottom", "points": [[0.1, 0.1], [0.9, 0.1]], "condition": {"type": "fixed"}},
        {"name": "right", "points": [[0.9, 0.1], [0.9, 0.9]]},
        {"name": "top", "points": [[0.9, 0.9], [0.1, 0.9]], "condition": {"type": "traction", "value": [0, -1]}},
        {"name": "left", "points": [[0.1, 0.9], [0.1, 0.1]]},
    ],
    "material_points": {"per_cell": [2, 2]},
    "output": {"pictures": False},
}


def run(*arguments, **environment):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60,
                          env={**os.environ, **environment})


def summary():
    with open("out/summary.json") as stream:
        return json.load(stream)


def the_blas_at_work_is_told():
    done = run("run", "square.json", "--output", "out")
    assert done.returncode == 0 and done.stderr.startswith("BLAS: OpenBLAS"), done.stderr
    assert summary()["blas"].startswith("OpenBLAS"), summary()["blas"]
    assert not summary()["warnings"], summary()["warnings"]
    assert run("run", "square.json", "--output", "out", "--quiet").stderr == ""


def a_reference_blas_is_warned_of():
    found = glob.glob("/usr/lib/*/blas/libblas.so.3")
    assert found, "no reference BLAS to preload (package libblas3)"
    done = run("run", "square.json", "--output", "out", LD_PRELOAD=found[0])
    assert done.returncode == 0 and "warning: slow BLAS: reference BLAS" in done.stderr, done.stderr
    assert "reference BLAS" in summary()["blas"] and "reference BLAS" in summary()["warnings"][0], summary()


def what_solved_is_in_the_summary():
    for solver, ran in [("auto", "band"), ("band", "band"), ("cholmod", "cholmod")]:
        assert run("run", "square.json", "--output", "out", "--set", f"solver.type={solver}").returncode == 0
        used = summary()["solver"]
        assert used["type"] == ran and used["unknowns"] == summary()["degrees_of_freedom"] and used["bytes"] > 0, used
        assert f"solver              {ran}: " in run("check", "square.json", "--set", f"solver.type={solver}").stdout


def multigrid_is_refused_where_it_is_missing():
    with open("libshoreline_multigrid.so", "w"):
        pass  # no library: found first, and not to be loaded
    for command in ["run", "check"]:
        done = run(command, "square.json", "--set", "solver.type=multigrid", LD_LIBRARY_PATH=os.getcwd())
        assert done.returncode == 2, done
        for word in ["square.json: /solver/type: ", '"multigrid"', "PETSc", "libpetsc-real-dev", '"cholmod"']:
            assert word in done.stderr, done.stderr
    assert not os.path.exists("out")


def multigrid_runs_quietly():
    done = run("run", "square.json", "--output", "out", "--quiet", "--set", "solver.type=multigrid")
    if "component of multigrid cannot be loaded" in done.stderr:
        return  # this build has none
    assert done.returncode == 0 and done.stderr == "", done.stderr
    assert summary()["solver"]["type"] == "multigrid" and summary()["solver"]["iterations"] > 0, summary()["solver"]


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    with open("square.json", "w") as stream:
        json.dump(SQUARE, stream)
    globals()[sys.argv[2]]()
