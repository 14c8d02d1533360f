"""Every wrong case, study and command line ends with status 2 and a line that says where and what; nothing written before is touched.

Usage: bad_input.py PROGRAM"""

import json
import os
import subprocess
import sys
import tempfile

from right_cases import CASE, MESHES, PROJECTION, SQUARE, gmsh
from wrong_cases import all_wrong_cases
from wrong_studies import FILES, STUDY, all_wrong_studies, wrong_companions

PROGRAM = os.path.abspath(sys.argv[1])


def run(arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, timeout=60)
    return done.returncode, done.stdout.decode(), done.stderr.decode(errors="replace")


def faults(result, words):
    status, out, err = result
    if status != 2:
        yield f"status {status}, expected 2"
    if out:
        yield f"{len(out)} characters on stdout, expected none"
    if not 1 <= err.count("\n") <= 3:
        yield f"{err.count(chr(10))} lines on stderr, expected 1 to 3"
    for word in words:
        if word not in err:
            yield f"no {word!r} in {err.strip()!r}"


def state(folder):
    return {entry.name: (entry.stat().st_mtime_ns, open(entry.path, "rb").read()) for entry in os.scandir(folder)}


def wrong_files():
    """(name, arguments, words) for every wrong case, written to a file that the arguments name."""
    for name, text in {"square.msh": gmsh(SQUARE, [(1, 2, 3), (1, 3, 4)]), **{f: t for f, (t, _) in MESHES.items()}}.items():
        with open(name, "w", encoding="latin-1", newline="") as stream:
            stream.write(text)
    for i, wrong in enumerate(all_wrong_cases()):
        file = f"wrong_{i}.json"
        with open(file, "wb") as stream:
            stream.write(wrong.text.encode(errors="surrogateescape"))
        place = f"{file}: {wrong.pointer}: " if wrong.pointer else f"{file}: "
        yield wrong.name, [file], [place, *wrong.words]


def wrong_commands():
    """(name, arguments, words) for wrong command lines and files that are none."""
    os.mkdir("folder.json")
    with open("right.json", "w") as stream:
        json.dump(CASE, stream)
    yield "no such file", ["missing.json"], ["missing.json", "No such file"]
    yield "a folder", ["folder.json"], ["folder.json", "folder"]
    if os.geteuid() != 0:  # root reads everything
        with open("closed.json", "w") as stream:
            json.dump(CASE, stream)
        os.chmod("closed.json", 0)
        yield "no permission", ["closed.json"], ["closed.json", "Permission denied"]
    for value, words in [("grid.cellsize=1", ["right.json: /grid: ", '"cellsize"', 'nearest: "cell_size"']),
                         ("grid.cell_size=-1", ["right.json: /grid/cell_size: ", "found -1", "> 0"]),
                         ("grid.cell_size=1e999", ["/grid/cell_size", "double"]),
                         ("grid.cell_size=[1,", ["/grid/cell_size", "line 1"]),
                         ("grid.cell_size=", ["/grid/cell_size", "no value"]),
                         ("grid.cell_size", ["grid.cell_size", "expected path=value"]),
                         ("=1", ["expected path=value"]),
                         ("grid..cell_size=1", ["grid..cell_size=1", "expected path=value"]),
                         ("grid.lower.2=1", ["/grid/lower", '"2"', "below 2"]),
                         ("grid.lower.0.x=1", ["/grid/lower/0", "found -2"]),
                         ("boundaries.tpo.name=a", ["/boundaries", '"tpo"', 'nearest: "top"']),
                         ("boundaries.7.name=a", ["/boundaries", '"7"', "below 6"])]:
        yield f"--set {value}", ["right.json", "--set", value], words
    yield "--set alone", ["right.json", "--set"], ["--set"]
    yield "--threads -1", ["right.json", "--threads", "-1"], ["/solver/threads", "found -1"]
    yield "--threads two", ["right.json", "--threads", "two"], ["--threads"]
    yield "an unknown option", ["right.json", "--treads", "2"], ["--treads"]
    yield "two files", ["right.json", "right.json"], ["right.json"]
    yield "no file", [], ["CASE"]


def wrong_studies():
    """(name, arguments, words) for every wrong study, written to a file that the arguments name."""
    for name, text in FILES.items():
        with open(name, "w") as stream:
            stream.write(text)
    for i, wrong in enumerate(all_wrong_studies()):
        file = f"wrong_study_{i}.json"
        with open(file, "w") as stream:
            stream.write(wrong.text)
        yield f"study: {wrong.name}", [file], [f"{file}: {wrong.pointer}", *wrong.words]
    for i, (name, study, words) in enumerate(wrong_companions()):
        file = f"companion_{i}.json"
        with open(file, "w") as stream:
            json.dump(study, stream)
        yield f"study: {name}", [file], words
    with open("study.json", "w") as stream:
        json.dump(STUDY, stream)
    yield "study: no such file", ["missing.json"], ["missing.json", "No such file", "a study file"]
    yield "study: a folder", ["folder.json"], ["folder.json", "folder"]
    for tolerance in ("x", "=1", "a=-1", "a=b", "a=", "a=0", "a=nan", "a=1e999", "a=1x", "="):
        yield f"--tolerance {tolerance}", ["study.json", "--tolerance", tolerance], [
            f'--tolerance: found "{tolerance}"', "expected NORM=VALUE"]
    yield "--tolerance alone", ["study.json", "--tolerance"], ["--tolerance"]
    for threads in ("-1", "1025", "two"):
        yield f"study: --threads {threads}", ["study.json", "--threads", threads], ["--threads", threads]
    yield "study: --set", ["study.json", "--set", "ghost=1"], ["--set"]
    yield "study: no file", [], ["STUDY"]


def norm_of_no_run():
    """A misspelt norm is seen once there are runs, which stay on record."""
    case = {key: value for key, value in PROJECTION.items() if key != "title"}
    with open("projection.json", "w") as stream:
        json.dump(case, stream)
    with open("projections.json", "w") as stream:
        json.dump({"case": "projection.json", "sweep": [{"key": "grid.cell_size", "values": [1]}]}, stream)
    return run(["study", "projections.json", "--output", "norms", "--quiet", "--tolerance", "projection.l2_relativ=1"])


def main():
    failures = count = 0

    def check(name, result, words):
        nonlocal failures, count
        count += 1
        for fault in faults(result, words):
            failures += 1
            print(f"{name}: {fault}")

    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        os.mkdir("out")
        with open("out/summary.json", "w") as stream:
            stream.write("from a run before")
        before = state("out")
        for family in (wrong_files, wrong_commands):
            for name, arguments, words in family():
                check(name, run(["run", "--output", "out", *arguments]), words)
        for name, arguments, words in wrong_studies():
            check(name, run(["study", "--output", "out", *arguments]), words)
        check("a norm of no run", norm_of_no_run(),
              ["--tolerance projection.l2_relativ: ", "found no such norm", 'nearest: "projection.l2_relative"'])
        check("check, no such file", run(["check", "missing.json"]), ["missing.json", "No such file"])
        check("check --set", run(["check", "right.json", "--set", "ghost=-1"]), ["right.json: /ghost: ", "found -1"])
        check("no command", run([]), ["expected one of", "run"])
        check("a misspelt command", run(["rnu", "right.json"]), ['"rnu"', 'nearest: "run"'])
        check("an argument too many", run(["schema", "right.json"]), ["right.json"])
        if state("out") != before:
            failures += 1
            print("the output folder of a run before was touched")
    print(f"{count} wrong inputs, {failures} faults")
    sys.exit(1 if failures or count < 900 else 0)


main()
