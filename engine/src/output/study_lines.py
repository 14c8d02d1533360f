# What study.json tells, as lines: the runs that differ in refinement alone, each line with a look of its own.

import json
import math
import textwrap

COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7A4B2A", "#7B3FA0"]
MARKERS = ["o", "s", "^", "D", "v", "P", "X", "<", ">", "p"]
DASHES = ["solid", (0, (5, 2)), (0, (1, 1.3)), (0, (6, 1.5, 1, 1.5)), (0, (3, 1, 3, 1, 1, 1)), (0, (9, 2)), (0, (2, 3))]
OTHER_MARKERS = ["*", "X", "d", "h", "8", "p"]  # of other programs, black and dashed
COMPONENTS = {"displacement": ["x", "y"], "stress": ["xx", "yy", "xy", "zz"]}
NORMS = {"l2": "L2 error", "l2_relative": "relative L2 error", "mean_relative": "mean relative error",
         "mean_absolute": "mean error", "max_absolute": "largest error", "rms": "rms error over time",
         "mean_rms": "mean rms error over time"}
QUANTITIES = {"l2_displacement": "L2 error of displacement", "displacement": "displacement", "velocity": "velocity",
              "stress": "stress", "position": "position"}
UNITS = {"cell_size": "m", "time_step": "s"}  # of axes, by the last part of their key


def text_of(value):
    return f"{value:g}" if isinstance(value, float) else str(value)


def unit_of(axis):
    return UNITS.get(axis.split(".")[-1], "")


def axis_title(axis):
    return f"{axis} [{unit_of(axis)}]" if unit_of(axis) else axis


def with_unit(axis, value):
    return f"{axis} {text_of(value)} {unit_of(axis)}".strip()


def norm_title(name):
    """The name of a norm as one reads it: displacement, relative L2 error; probe tip: displacement."""
    head, _, rest = name.partition(".")
    middle, _, last = rest.rpartition(".")
    if head == "error_estimate":
        return f"{norm_title(rest)}, estimated"
    if head in COMPONENTS and middle in NORMS and last.isdigit() and int(last) < len(COMPONENTS[head]):
        return f"{head} {COMPONENTS[head][int(last)]}, {NORMS[middle]}"
    if last in NORMS:
        return f"{middle if head == 'over_time' else f'{head} {middle}'.strip()}, {NORMS[last]}"
    if head in ("probe", "boundary") and middle and last in QUANTITIES:
        return f"{head} {middle}: {QUANTITIES[last]}"
    return f"{head} {rest}".strip()


def number(row, *keys):
    """What stands under the keys; None where that is no number a logarithmic axis can show."""
    for key in keys:
        row = (row or {}).get(key)
    return row if isinstance(row, (int, float)) and math.isfinite(row) and row > 0 else None


class Line:
    """Completed runs in order of refinement, with the looks of their labels."""

    def __init__(self, name, rows):
        self.name = name
        self.rows = sorted(rows, key=lambda row: number(row, "refinement") or 0)
        self.finest = max(self.rows, key=lambda row: ((number(row, "unknowns") or 0) * (number(row, "steps") or 1),
                                                      number(row, "points") or 0))
        self.look = {"color": COLOURS[0], "marker": MARKERS[0], "linestyle": DASHES[0]}

    def points(self, x, y):
        """The runs that have both numbers, which are given as keys of a row."""
        runs = [(number(row, *x), number(row, *y), row) for row in self.rows]
        return [run for run in runs if run[0] is not None and run[1] is not None]


class LookGroup:
    """One or more axes, whose values the lines show by some of colour, marker and dashes."""

    def __init__(self, axes, shown_by):
        self.names, self.shown_by = [axis["name"] for axis in axes], shown_by
        self.title = " × ".join(map(text_of, self.names))
        self.looks = {}

    def label(self, row):
        return ", ".join(text_of(row["labels"].get(name, "")) for name in self.names)

    def give_looks(self, lines, axes):
        """Looks for the values that occur, in the order in which the axes list them."""
        ranks = {axis["name"]: {text_of(v): k for k, v in enumerate(axis["values"])} for axis in axes}
        rank = {self.label(line.rows[0]): [ranks[name].get(text_of(line.rows[0]["labels"].get(name)), 0)
                                           for name in self.names] for line in lines}
        labels = sorted(rank, key=rank.get)
        colours = COLOURS
        if len(labels) > len(COLOURS):
            colours = [matplotlib.colormaps["turbo"](f) for f in np.linspace(0.05, 0.95, len(labels))]
        for k, label in enumerate(labels):
            look = {"color": colours[k % len(colours)], "marker": MARKERS[k % len(MARKERS)],
                    "linestyle": DASHES[k % len(DASHES)]}
            self.looks[label] = {key: look[key] for key in self.shown_by}
        for line in lines:
            line.look |= self.looks[self.label(line.rows[0])]


def by_key(rows, key):
    """The rows with the same key together, in order of appearance."""
    groups = {}
    for row in rows:
        groups.setdefault(key(row), []).append(row)
    return groups


def why_nothing_ran(rows):
    if not rows:
        return "study.json holds no run"
    return f"all {len(rows)} runs of the study failed, the first with: {textwrap.shorten(rows[0]['reason'] or '', 300)}"


class Study:
    """What study.json holds, with its lines and the looks by which they are told apart."""

    def __init__(self, folder):
        with open(os.path.join(folder, "study.json"), encoding="utf-8") as file:
            self.content = json.load(file)
        self.rows, self.norms = self.content["rows"], self.content["errors"]
        completed = [row for row in self.rows if row["status"] == "completed"]
        if not completed:
            sys.exit(why_nothing_ran(self.rows))
        self.refines = any(number(row, "refinement") for row in completed)
        axes = [axis for axis in self.content["axes"] if not (self.refines and axis["name"] == self.content["refine"])
                and len({text_of(row["labels"].get(axis["name"])) for row in completed}) > 1]
        self.lines = self.lines_along(axes, completed)
        self.groups = look_groups(axes)
        for group in self.groups:
            group.give_looks(self.lines, axes)
        self.others = [Line(name, rows) for name, rows in by_key(self.content["outside"], lambda r: r["line"]).items()]
        for k, line in enumerate(self.others):
            line.look = {"color": "black", "linestyle": DASHES[1], "markersize": 7,
                         "markeredgecolor": "black", "marker": OTHER_MARKERS[k % len(OTHER_MARKERS)]}

    def lines_along(self, axes, rows):
        """Lines of the runs that agree in all these axes; each run is one where refinement is no number."""
        labels = [axis["name"] for axis in axes]
        runs = by_key(rows, lambda row: (row["line"], *(text_of(row["labels"].get(name)) for name in labels)))
        return [Line(key[0] if self.refines else ", ".join(key[1:]) or key[0], group) for key, group in runs.items()]

    def caption(self):
        """What ran where, in one line."""
        threads = sorted({row["threads"] for row in self.rows if row.get("threads")})
        used = " or ".join(map(str, threads)) + (" thread" if threads == [1] else " threads")
        failed = sum(row["status"] != "completed" for row in self.rows)
        parts = [self.content["program"], self.content["machine"], used if threads else "",
                 f"{failed} of {len(self.rows)} runs failed and are left out" if failed else ""]
        return " · ".join(part for part in parts if part)


def look_groups(axes):
    """The first axis by colour, the second by marker, the others together by dashes; one alone by colour and marker."""
    if len(axes) == 1:
        return [LookGroup(axes, ("color", "marker"))]
    parts = [(axes[:1], "color"), (axes[1:2], "marker"), (axes[2:], "linestyle")]
    return [LookGroup(part, (shown_by,)) for part, shown_by in parts if part]
