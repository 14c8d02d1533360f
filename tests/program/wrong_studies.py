"""Wrong studies, one fault each: made from a study that has every key, and the fault's place and message."""

import json

from right_cases import Wrong, changed, replaced

STUDY = {
    "title": "every key",
    "case": "right.json",
    "set": {"ghost": 1e-3},
    "sweep": [
        {"name": "basis", "choices": [{"name": "bilinear", "set": {"grid.basis": "bilinear"}},
                                      {"name": "splines", "set": {"grid.basis": "bspline"}}]},
        {"zip": {"grid.degree": [1, 2], "material_points.per_cell": [2, 3]}, "label": "grid.degree", "name": "degree"},
        {"key": "grid.cell_size", "values": [0.5, 0.25, 0.125], "name": "cells"},
    ],
    "refine": "cells",
    "repeat": 3,
    "budget": {"seconds": 60, "memory": 1e9},
    "samples": 40,
    "errors": ["stress.l2_relative"],
    "reference": {"set": {"grid.cell_size": 0.1}},
    "outside": ["other.csv"],
}

KEYS = ["title", "case", "set", "sweep", "refine", "repeat", "budget", "samples", "errors", "reference", "outside",
        "sweep/0/name", "sweep/0/choices", "sweep/0/choices/0/name", "sweep/0/choices/0/set", "sweep/1/zip",
        "sweep/1/label", "sweep/1/name", "sweep/2/key", "sweep/2/values", "sweep/2/name", "budget/seconds",
        "budget/memory", "reference/set"]
REQUIRED = {"case", "sweep", "sweep/0/name", "sweep/0/choices", "sweep/0/choices/0/name", "sweep/0/choices/0/set",
            "sweep/1/zip", "sweep/2/key", "sweep/2/values", "reference/set"}
TELLING = {"sweep/0/choices", "sweep/1/zip", "reference/set"}  # which of several objects it is

FILES = {  # what studies of the table below name, beside right.json
    "list.json": "[1, 2]", "broken.json": '{"title": ', "empty.json": "",
    "other.csv": "line,seconds\nother,1.5\n", "hours.csv": "line,hours\nother,1\n",
    "ragged.csv": "line,seconds\nother\n", "blank.csv": "", "slow.csv": "line,seconds\nother,slow\n",
}


def every_key_misspelt_mistyped_missing():
    for path in KEYS:
        parent, key = ("/" + path).rsplit("/", 1)
        misspelt = key[:-1] + "q" + key[-1]
        if path in TELLING:
            text = changed(path, lambda at, last: at.__setitem__(misspelt, at.pop(last)), STUDY)
            yield Wrong(f"misspelt /{path}", text, parent, ["expected"], True)
        else:
            text = changed(path, lambda at, last: at.__setitem__(misspelt, at.pop(last)), STUDY)
            yield Wrong(f"misspelt /{path}", text, parent, ["found unknown key", misspelt, "expected"], True)
        yield Wrong(f"mistyped /{path}", replaced(path, None, STUDY), "/" + path, ["found null", "expected"], True)
        if path in REQUIRED:
            words = ["expected"] if path in TELLING else [f'"{key}" is missing', "expected"]
            yield Wrong(f"missing /{path}", changed(path, lambda at, last: at.pop(last), STUDY), parent, words, True)


def wrong_values():
    table = [  # path, value, where, in the message, whether the schema sees it
        ("title", ["a"], "", "a string", True),
        ("case", "", "", "the name of a file", False),
        ("set", [], "", "an object", True),
        ("set", {"": 1}, "", "dotted path", False),
        ("set", {"grid..degree": 1}, "", "dotted path", False),
        ("set", {"ghost=1": 1}, "", "dotted path", False),
        ("sweep", [], "", "at least 1", True),
        ("sweep", {}, "", "a list", True),
        ("sweep", [7], "/0", "found 7", True),
        ("sweep", [{}], "/0", "expected", True),
        ("sweep/0/choices", [], "", "at least 1", True),
        ("sweep/0/choices", {}, "", "a list", True),
        ("sweep/0/choices/0", "bilinear", "", "an object", True),
        ("sweep/0/choices/0/name", 1, "", "a string", True),
        ("sweep/0/choices/0/set", ["grid.basis"], "", "an object", True),
        ("sweep/0/choices/0/set", {"grid.": 1}, "", "dotted path", False),
        ("sweep/0/choices/1/name", "bilinear", "@/sweep/0", '"bilinear" twice', False),
        ("sweep/1/zip", {}, "", "found no key", False),
        ("sweep/1/zip", [[1, 2]], "@/sweep/1", "expected", True),
        ("sweep/1/zip/grid.degree", [], "", "at least 1", True),
        ("sweep/1/zip/grid.degree", 2, "", "a list", True),
        ("sweep/1/zip/grid.degree", [1, 2, 3], "@/sweep/1/zip/material_points.per_cell",
         'found 2 values, expected 3 as under "grid.degree"', False),
        ("sweep/1/label", "grid.degre", "", 'nearest: "grid.degree"', False),
        ("sweep/1/label", "", "", '"grid.degree"', False),
        ("sweep/2/key", "", "", "dotted path", False),
        ("sweep/2/key", ".cell_size", "", "dotted path", False),
        ("sweep/2/key", ["grid.cell_size"], "", "a string", True),
        ("sweep/2/values", [], "", "at least 1", True),
        ("sweep/2/values", 0.5, "", "a list", True),
        ("sweep/2/values", list(range(1, 10002)), "", "a list of 10001, expected at most 10000", True),
        ("sweep/2/values", [0.5, 0.25, 0.5], "@/sweep/2", '"0.5" twice', False),
        ("sweep/2/values", [1, 1.0], "@/sweep/2", '"1" twice', False),
        ("sweep/2/values", [0.5, -0.25], "@/refine", "numbers > 0", False),
        ("sweep/2/name", "degree", "@/sweep/2", 'second axis "degree"', False),
        ("refine", "cell", "", 'nearest: "cells"', False),
        ("refine", "basis", "", "numbers > 0", False),
        ("refine", 2, "", "a string", True),
        ("repeat", 0, "", "from 1 to 1000", True),
        ("repeat", -1, "", "from 1 to 1000", True),
        ("repeat", 1.5, "", "whole number", True),
        ("repeat", 1e300, "", "from 1 to 1000", True),
        ("repeat", "3", "", "whole number", True),
        ("budget", 60, "", "an object", True),
        ("budget/seconds", 0, "", "> 0", True),
        ("budget/seconds", -1, "", "> 0", True),
        ("budget/seconds", 1e10, "", "1e+09", True),
        ("budget/seconds", "60", "", "a number", True),
        ("budget/memory", 0, "", "1e+06", True),
        ("budget/memory", -1e9, "", "1e+06", True),
        ("budget/memory", 1e16, "", "1e+15", True),
        ("budget/memory", "1 GB", "", "a number", True),
        ("samples", -1, "", "from 0 to 10000", True),
        ("samples", 1, "", "found 1", False),
        ("samples", 10001, "", "10000", True),
        ("samples", 1e300, "", "10000", True),
        ("samples", "many", "", "whole number", True),
        ("errors", [], "", "at least 1", True),
        ("errors", "stress.l2_relative", "", "a list", True),
        ("errors", ["a", "b", "c", "d", "e", "f", "g"], "", "at most 6", True),
        ("errors", [1], "/0", "a string", True),
        ("reference", "finst", "", 'nearest: "finest"', True),
        ("reference", "", "", '"finest", "richardson"', True),
        ("reference", 0.1, "", "found 0.1", True),
        ("reference", {}, "", "expected", True),
        ("reference/set", 0.1, "", "an object", True),
        ("reference/set", {"grid=": 1}, "", "dotted path", False),
        ("outside", [], "", "at least 1", True),
        ("outside", "other.csv", "", "a list", True),
        ("outside", [7], "/0", "a string", True),
        ("outside", ["other.csv", ""], "/1", "the name of a file", False),
    ]
    for path, value, where, words, structural in table:
        pointer = where[1:] if where.startswith("@") else "/" + path + where
        yield Wrong(f"{path} = {str(value)[:60]}", replaced(path, value, STUDY), pointer,
                    ["expected", words], structural)


def wrong_together():
    whole = json.dumps(STUDY)
    values = {"key": "ghost", "values": [1, 2]}
    for name, more, pointer, words, structural in [
            ("values and zip", {"sweep": [{**values, "zip": {"ghost": [1]}}]}, "/sweep/0/", ["found", "beside"], True),
            ("values and choices", {"sweep": [{**values, "name": "a", "choices": STUDY["sweep"][0]["choices"]}]},
             "/sweep/0/", ["found", "beside"], True),
            ("the same axis twice", {"sweep": [values, values], "refine": "ghost"}, "/sweep/1",
             ['second axis "ghost"'], False),
            ("richardson of two", {"sweep": [values], "refine": "ghost", "reference": "richardson"}, "/reference",
             ["at least 3"], False),
            ("11 axes", {"sweep": [{**values, "name": str(k)} for k in range(11)], "refine": "1"}, "/sweep",
             ["at most 10 "], True),
            ("too many runs", {"sweep": [{"key": k, "values": list(range(1, 102))} for k in ("a", "b", "c")],
                               "refine": "a"}, "/sweep", ["1.03e+06 runs", "at most 100000"], False)]:
        yield Wrong(name, json.dumps({**STUDY, **more}), pointer, words, structural)
    without = {key: value for key, value in STUDY.items() if key not in ("refine", "sweep")}
    words_alone = [{"key": "grid.basis", "values": ["bilinear", "bspline", "linear"]}]
    yield Wrong("richardson of words", json.dumps({**without, "sweep": words_alone, "reference": "richardson"}),
                "/reference", ["an axis to refine", "at least 3"], False)
    yield Wrong("NaN", whole.replace("0.125", "NaN", 1), "", ["line 1, column"], False)
    yield Wrong("1e999", whole.replace("0.125", "1e999", 1), "/sweep/2/values/2", ["double"], False)
    yield Wrong("a key twice", whole.replace('"repeat"', '"samples": 1, "repeat"', 1), "/samples", ["twice"], False)
    yield Wrong("empty", "", "", ["empty"], False)
    yield Wrong("a list", "[1, 2]", "", ["found [1,2]", "an object"], True)
    yield Wrong("no JSON", "title: study", "", ["line 1, column"], False)


def all_wrong_studies():
    for family in (every_key_misspelt_mistyped_missing, wrong_values, wrong_together):
        yield from family()


def wrong_companions():
    """(name, study, words): studies that are right, of cases and tables that are not."""
    for case, words in [("missing.json", ["missing.json: ", "No such file", "expected a case file"]),
                        (".", ["found a folder", "expected a case file"]),
                        ("list.json", ["list.json: ", "found [1,2]", "expected a case"]),
                        ("broken.json", ["broken.json: ", "line 1, column"]),
                        ("empty.json", ["empty.json: ", "is empty"])]:
        yield f"case = {case!r}", {**STUDY, "case": case}, words
    for table, words in [("missing.csv", ["missing.csv: ", "No such file", "another program's runs"]),
                         ("hours.csv", ["hours.csv: ", 'no column "seconds"', "hours"]),
                         ("ragged.csv", ["ragged.csv: ", "row 2", "1 cells, expected 2"]),
                         ("blank.csv", ["blank.csv: ", "is empty"]),
                         ("slow.csv", ["slow.csv: ", "row 2", '"seconds"'])]:
        yield f"outside = {table!r}", {**STUDY, "outside": ["other.csv", table]}, words
