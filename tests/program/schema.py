"""The schema is valid, accepts every example and refuses the wrong cases that structure alone gives away; and the
reference page in docs is the one that the program prints.

Usage: schema.py PROGRAM SOURCE_FOLDER"""

import glob
import json
import os
import subprocess
import sys

from jsonschema import Draft202012Validator

from wrong_cases import CASE, DYNAMICS, PROJECTION, all_wrong_cases

PROGRAM, SOURCE = sys.argv[1:3]


def printed(*arguments):
    return subprocess.run([PROGRAM, "schema", *arguments], capture_output=True, check=True).stdout.decode()


def undescribed(schema, path=""):
    """Keys without a description."""
    for name, key in schema.get("properties", {}).items():
        if "const" not in key and not key.get("description"):
            yield f"{path}/{name}"
        yield from undescribed(key, f"{path}/{name}")
    for inner in schema.get("oneOf", []) + [schema[k] for k in ("items",) if k in schema]:
        yield from undescribed(inner, path)


def faults():
    schema = json.loads(printed())
    Draft202012Validator.check_schema(schema)
    validator = Draft202012Validator(schema)
    yield from (f"{path} has no description" for path in undescribed(schema))
    for case in (CASE, PROJECTION, DYNAMICS):
        yield from (f"{case['title']}: {error.message}" for error in validator.iter_errors(case))
    examples = [f for f in glob.glob(os.path.join(SOURCE, "examples", "*", "*.json"))
                if "analysis" in json.load(open(f))]
    if not examples:
        yield "no example found"
    for file in examples:
        yield from (f"{file}: {error.message}" for error in validator.iter_errors(json.load(open(file))))
    for wrong in all_wrong_cases():
        if wrong.structural and validator.is_valid(json.loads(wrong.text)):
            yield f"accepted: {wrong.name}"
    with open(os.path.join(SOURCE, "docs", "case_format.md"), encoding="utf-8") as page:
        if page.read() != printed("--markdown"):
            yield "docs/case_format.md is not what `shoreline schema --markdown` prints"


found = list(faults())
print("\n".join(found) or "no faults")
sys.exit(1 if found else 0)
