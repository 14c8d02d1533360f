#!/usr/bin/env python3
"""What an effect costs a case that does not name it: instructions of the whole program, counted by valgrind.

Usage: effects.py PROGRAM. Each row adds one key to a case, at a value that names no effect and at one that does."""

import json
import os
import re
import subprocess
import sys
import tempfile

CASE = {
    "analysis": {"type": "quasi_static", "plane": "strain"},
    "material": {"type": "linear_elastic", "youngs_modulus": 1e6, "poissons_ratio": 0.25},
    "grid": {"lower": [0, 0], "upper": [1.25, 1.25], "cell_size": 0.05, "basis": "bspline", "degree": 2},
    "ghost": 0,
    "boundaries": [
        {"name": "bottom", "points": [[0.103, 0.057], [1.103, 0.057]], "condition": {"type": "fixed"}},
        {"name": "right", "points": [[1.103, 0.057], [1.103, 1.057]]},
        {"name": "top", "points": [[1.103, 1.057], [0.103, 1.057]], "condition": {"type": "traction", "value": [0, -1]}},
        {"name": "left", "points": [[0.103, 1.057], [0.103, 0.057]]},
    ],
    "material_points": {"per_cell": 4},
}
EXACT = '{"type":"expressions","displacement":["0","-1e-6*Y*t"],"stress":["0","-t","0"]}'
ROWS = [  # what, without effect, with it
    ("ghost penalty", "ghost=0", "ghost=0.001"),
    ("fitted weights", "material_points.volumes=clipped", "material_points.volumes=fitted"),
    ("projected dilatation", "material.dilatation=plain", "material.dilatation=projected"),
    ("body force", "", "body_force=[0,-1]"),
    ("errors", "", f"exact={EXACT}"),
    ("probes", "", 'probes=[{"name":"p","position":[0.1,0.1]}]'),
    ("traction on a piece", "", 'boundaries.right.condition={"type":"traction","value":[1,0]}'),
    ("prescribed value", "", 'boundaries.bottom.condition={"type":"displacement","value":[0,1e-6]}'),
    ("re-spacing", "", "tracking.respace=50"),
    ("condition estimate", "diagnostics.condition_estimate=false", "diagnostics.condition_estimate=true"),
    ("cut fractions", "diagnostics.cut_fractions=false", "diagnostics.cut_fractions=true"),
    ("strain energy", "diagnostics.strain_energy=false", "diagnostics.strain_energy=true"),
    ("error estimate", "diagnostics.error_estimate=false", "diagnostics.error_estimate=true"),
    ("saved strain", "output.fields=[]", 'output.fields=["strain"]'),
    ("pictures", "output.pictures=false", "output.pictures=true"),
]


def instructions(program, case, folder, *settings):
    command = ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", program, "run", case, "--quiet",
               "--threads", "1", "--output", os.path.join(folder, "out")]
    for setting in ("output.pictures=false", "output.fields=[]") + settings:
        command += ["--set", setting] if setting else []
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    with open(os.path.join(folder, "out", "summary.json")) as stream:
        counters = json.load(stream)["counters"]
    return int(re.search(r"Collected : (\d+)", done.stderr).group(1)), counters


def main():
    program = os.path.abspath(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        case = os.path.join(folder, "case.json")
        with open(case, "w") as stream:
            json.dump(CASE, stream)
        bare, counters = instructions(program, case, folder)
        print(f"{bare / 1e6:.2f} million instructions without any of them\n")
        print(f"{'effect':<22}{'not named':>12}{'named':>12}   counts that it adds to")
        for what, without, named in ROWS:
            off, counters_off = instructions(program, case, folder, without)
            on, counters_on = instructions(program, case, folder, named)
            assert counters_off == counters, what
            more = [name for name in counters_on if counters_on[name] > counters[name]]
            print(f"{what:<22}{100 * (off / bare - 1):>+11.2f}%{100 * (on / bare - 1):>+11.2f}%   {', '.join(more)}")


main()
