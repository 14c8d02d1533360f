"""Checks a rule of the source tree: check.py includes|tests|marks ROOT. Prints every breach; exit status 1 if any."""

import pathlib
import re
import sys

# A part may include itself and what stands below it.
BELOW = {"bases": ["bases"], "boundary": ["bases", "boundary"], "engine": ["bases", "boundary", "engine"]}
MARKS = re.compile(r"\b(TODO|FIXME|XXX|HACK|for now|not implemented|stub)\b")


def included(file):
    return re.findall(r'^\s*#\s*include\s*([<"])([^">]+)[">]', file.read_text(encoding="utf-8"), re.MULTILINE)


def includes(root):
    """Arrows between the parts; a public header includes the standard library, Eigen and public headers alone."""
    for part, allowed in BELOW.items():
        for file in sorted((root / part).rglob("*.[ch]pp")):
            public = (root / part / "include") in file.parents
            for bracket, name in included(file):
                if name.startswith("shoreline/") and name.split("/")[1] not in allowed:
                    yield f"{file}: {part} may not include {name}"
                elif public and bracket == '"' and not name.startswith("shoreline/"):
                    yield f"{file}: a public header includes the private {name}"
                elif public and bracket == "<" and not (re.fullmatch(r"[a-z_]+", name) or name.startswith("Eigen/")):
                    yield f"{file}: a public header includes <{name}>"


def tests(root):
    """Every public header has a test file of its name; names of tests hold no semicolon, which splits them in CTest."""
    for part in BELOW:
        for header in sorted((root / part / "include").rglob("*.hpp")):
            test = root / "tests" / part / (header.stem + ".test.cpp")
            if not test.is_file():
                yield f"{header}: has no test {test.relative_to(root)}"
    for file in sorted((root / "tests").rglob("*.test.cpp")):
        for name in re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.|"\s*")*)"', file.read_text()):
            if ";" in name:
                yield f"{file}: the name of a test holds a semicolon: {name}"


def marks(root):
    """No marks of unfinished work."""
    for folder in ["bases", "boundary", "engine", "tests", "examples", "cmake", "docs"]:
        for file in sorted((root / folder).rglob("*")):
            if file == pathlib.Path(__file__).resolve() or file.suffix not in {".cpp", ".hpp", ".py", ".md", ".cmake", ".txt"}:
                continue
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                if MARKS.search(line):
                    yield f"{file}:{number}: {line.strip()}"


def main():
    rule, root = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    breaches = list({"includes": includes, "tests": tests, "marks": marks}[rule](root))
    print("\n".join(breaches))
    sys.exit(1 if breaches else 0)


main()
