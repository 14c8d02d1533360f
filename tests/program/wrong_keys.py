"""Every key of every right case misspelt, of a wrong type, or missing."""

from right_cases import CASE, DYNAMICS, OPTIONAL, OPTIONAL_IN_DYNAMICS, OTHERS, PROJECTION, Wrong, changed, replaced


def keys(value, pointer=""):
    """The pointers of all keys of objects, at any depth, and the objects."""
    entries = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for key, inner in entries:
        if isinstance(value, dict):
            yield f"{pointer}/{key}", value
        yield from keys(inner, f"{pointer}/{key}")


def one_of_several(key, among):
    """Whether a key stands for others that could be there in its place."""
    families = [("mass", {"value", "data"}), ("name", {"points", "line", "arc", "circle"}), ("method", {"value", "normal"}),
                ("fill", {"per_cell", "per_block", "across"} if among.get("fill") in ("vertex", "lattice") else {})]
    return any(beside in among and key in family for beside, family in families)


def wrong_key(case, pointer, among):
    """One key misspelt, mistyped, missing."""
    parent, key = pointer.rsplit("/", 1)
    path = pointer[1:]
    tag = key == "type" and parent != "/solver"
    if parent != "/constants":
        misspelt = key[:-1] + "q" + key[-1]
        text = changed(path, lambda at, last: at.__setitem__(misspelt, at.pop(last)), case)
        words = ['"type" is missing'] if tag else ["found unknown key", misspelt, "expected"]
        yield Wrong(f"misspelt {pointer}", text, parent, words, True)
    yield Wrong(f"mistyped {pointer}", replaced(path, None, case), pointer, ["found null", "expected"], True)
    first = key in ("points", "mesh") and "name" not in among  # tells what the object is
    optional = OPTIONAL - {"density"} | OPTIONAL_IN_DYNAMICS if case is DYNAMICS else OPTIONAL
    if (key not in optional or one_of_several(key, among)) and not first and pointer != "/solver/type":
        text = changed(path, lambda at, last: at.pop(last), case)
        words = ["exactly one of"] if one_of_several(key, among) else [f'"{key}" is missing', "expected"]
        yield Wrong(f"missing {pointer}", text, parent, words, True)


def every_key_misspelt_mistyped_missing():
    for pointer, among in keys(CASE):
        yield from wrong_key(CASE, pointer, among)
    for case in (PROJECTION, DYNAMICS):
        for pointer, among in keys(case):
            yield from wrong_key(case, pointer, among)
    for place, value in OTHERS:
        for pointer, among in keys(value, f"/{place}"):
            yield from wrong_key({**CASE, place: value}, pointer, among)
