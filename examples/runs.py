"""What the tables.py of every example share: runs of the program, and tables in Markdown.

Called by a script of an example's folder, or beside this one; its first argument is the built `shoreline`, without it the one that ./run
builds.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(sys.argv[0]).resolve().parent
PROJECT = pathlib.Path(__file__).resolve().parents[1]
PROGRAM = sys.argv[1] if len(sys.argv) > 1 else PROJECT / "build/release/engine/shoreline"


def run(case, settings, folder=None):
    """Summary of one run of a case of the calling script's folder with changed keys, or as text why it failed."""
    with tempfile.TemporaryDirectory() as spare:
        folder = folder or spare
        changes = {"output.pictures": False} | settings
        sets = [part for key, value in changes.items() for part in ("--set", f"{key}={json.dumps(value)}")]
        done = subprocess.run([PROGRAM, "run", HERE / case, "--output", folder, "--quiet", *sets], capture_output=True,
                              text=True, check=False)
        if done.returncode == 2:
            sys.exit(done.stderr)
        return json.loads((pathlib.Path(folder) / "summary.json").read_text()) if done.returncode == 0 else done.stderr


def row(*entries):
    print("| " + " | ".join(str(e) for e in entries) + " |")


def table(*head):
    print()
    row(*head)
    row(*["---:"] * len(head))


def seconds(summary):
    """Of the whole run without output."""
    return f"{summary['timings']['total'] - summary['timings']['output']:.2f}"
