"""The schemas of cases and studies are valid, accept every example and refuse what structure alone gives away as wrong;
and the reference pages in docs are those that the program prints.

Usage: schema.py PROGRAM SOURCE_FOLDER"""

import glob
import json
import os
import subprocess
import sys

from jsonschema import Draft202012Validator

from right_cases import CASE, DYNAMICS, PROJECTION
from wrong_cases import all_wrong_cases
from wrong_studies import STUDY, all_wrong_studies

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


def accepted(validator, wrongs):
    """Wrong files that structure alone gives away."""
    for wrong in wrongs:
        if wrong.structural and validator.is_valid(json.loads(wrong.text)):
            yield f"accepted: {wrong.name}"


def page_faults(page, *arguments):
    with open(os.path.join(SOURCE, "docs", page), encoding="utf-8") as stream:
        if stream.read() != printed(*arguments, "--markdown"):
            yield f"docs/{page} is not what `shoreline schema {' '.join([*arguments, '--markdown'])}` prints"


def validator_of(*arguments):
    schema = json.loads(printed(*arguments))
    Draft202012Validator.check_schema(schema)
    return Draft202012Validator(schema)


def case_faults():
    validator = validator_of()
    yield from (f"{path} has no description" for path in undescribed(validator.schema))
    for case in (CASE, PROJECTION, DYNAMICS):
        yield from (f"{case['title']}: {error.message}" for error in validator.iter_errors(case))
    examples = [f for f in glob.glob(os.path.join(SOURCE, "examples", "*", "*.json"))
                if "analysis" in json.load(open(f))]
    if not examples:
        yield "no example found"
    for file in examples:
        yield from (f"{file}: {error.message}" for error in validator.iter_errors(json.load(open(file))))
    yield from accepted(validator, all_wrong_cases())
    yield from page_faults("case_format.md")


def study_faults():
    validator = validator_of("--study")
    yield from (f"{path} of a study has no description" for path in undescribed(validator.schema))
    least = {"case": STUDY["case"], "sweep": STUDY["sweep"][2:]}
    for study in (STUDY, least, *({**least, "reference": word} for word in ("finest", "richardson"))):
        yield from (f"{study}: {error.message}" for error in validator.iter_errors(study))
    yield from accepted(validator, all_wrong_studies())
    studies = glob.glob(os.path.join(SOURCE, "studies", "*.json"))
    if not studies:
        yield "no study found"
    for file in studies:
        yield from (f"{file}: {error.message}" for error in validator.iter_errors(json.load(open(file))))
    yield from page_faults("study_format.md", "--study")


found = [*case_faults(), *study_faults()]
print("\n".join(found) or "no faults")
sys.exit(1 if found else 0)
