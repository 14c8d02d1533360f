# A figure with panels of lines on logarithmic axes, guides to read their slopes by, and its legends below.

import textwrap

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator

WIDTH, DPI = 9.5, 160  # [in], [1/in]
ROSE = 0.26  # size of the slope guides, in parts of a panel
MOST_ROWS = 8  # of a legend's column
SMALL = {"fontsize": 8, "color": "0.35"}


def power_of_ten(value, _):
    exponent = math.floor(math.log10(value) + 1e-9)
    mantissa = round(value / 10.0**exponent)
    return f"$10^{{{exponent}}}$" if mantissa == 1 else rf"${mantissa} \cdot 10^{{{exponent}}}$"


def logarithmic(axis, values, powers=False, ticks=None):
    """Limits around the values, at least 0.7 decades apart, with few ticks; the given ones where they are not crowded."""
    low, high = math.log10(min(values)), math.log10(max(values))
    slack = max(0.07 * (high - low), (0.7 - (high - low)) / 2)
    limits = 10.0 ** (low - slack), 10.0 ** (high + slack)
    (axis.axes.set_xscale if axis.axis_name == "x" else axis.axes.set_yscale)("log")
    (axis.axes.set_xlim if axis.axis_name == "x" else axis.axes.set_ylim)(limits)
    decades = high - low + 2 * slack
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2 else (1,)))
    axis.set_minor_locator(LogLocator(subs=range(2, 10)) if 2 <= decades < 8 else NullLocator())
    if ticks:
        kept = []
        for tick in sorted(set(ticks), reverse=True):
            if not kept or math.log10(kept[-1] / tick) > 0.1 * decades:
                kept.append(tick)
        axis.set_major_locator(FixedLocator(kept))
        axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(power_of_ten if powers else lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(FuncFormatter(lambda *_: ""))


def draw_line(axes, line, runs, spread=None):
    """One line through the runs (x, y, row); spread(row) gives where whiskers along x end."""
    x, y = [run[0] for run in runs], [run[1] for run in runs]
    axes.plot(x, y, **line.look, linewidth=1.2, markersize=4.8, markeredgecolor="white", markeredgewidth=0.4, zorder=3)
    for _, height, row in runs if spread else []:
        least, greatest = spread(row)
        if least and greatest:
            axes.plot([least, greatest], [height, height], color=line.look["color"], linewidth=1.0, marker="|",
                      markersize=4, zorder=2)


def slopes_of(all_runs):
    """Slope between the last two runs at the fine end of each line."""
    slopes = []
    for runs in all_runs:
        steps = [math.log(b[1] / a[1]) / math.log(b[0] / a[0]) for a, b in zip(runs, runs[1:]) if a[0] != b[0]]
        slopes += steps[:1] + steps[-1:]
    return [slope for slope in slopes if math.isfinite(slope)]


def emptier_corner(axes, rising):
    """Of the two corners that lines of such a slope leave free the one with fewer of them: its least x and y."""
    edge, far = 0.03, 0.97 - ROSE
    corners = [(far, edge), (edge, far)] if rising else [(edge, edge), (far, far)]

    def crowd(corner):
        inside = 0
        for drawn in axes.lines:
            xy = axes.transAxes.inverted().transform(drawn.get_transform().transform(drawn.get_xydata()))
            along = np.vstack([a + np.linspace(0, 1, 20)[:, None] * (b - a) for a, b in zip(xy, xy[1:])] or [xy])
            inside += np.all((along > np.subtract(corner, 0.02)) & (along < np.add(corner, ROSE + 0.02)), axis=1).sum()
        return inside

    return min(corners, key=crowd)


def draw_slopes(axes, slopes, labels):
    """Guides of the slopes, a fan from one place in a corner; to be called once the axes lie where they will."""
    box = axes.get_window_extent()
    decades = [math.log10(high / low) for low, high in (axes.get_xlim(), axes.get_ylim())]
    rising = slopes[0] > 0
    corner = emptier_corner(axes, rising)
    start = np.add(corner, (0.0, 0.0 if rising else ROSE))
    for slope, label in zip(slopes, labels):
        step = np.array([1.0 / decades[0], slope / decades[1]])  # in parts of the panel
        step *= (ROSE - 0.06) * min(box.width, box.height) / np.hypot(*(step * (box.width, box.height)))
        end = start + step
        axes.plot(*zip(start, end), transform=axes.transAxes, color="0.6", linewidth=0.8, zorder=1)
        axes.annotate(label, end, xycoords=axes.transAxes, xytext=3 * step / np.hypot(*step), textcoords="offset points",
                      ha="left", va="center", fontsize=7.5, color="0.4", zorder=1)


def fitting(candidates, slopes):
    """The candidates near what was observed."""
    return [c for c in candidates if min(slopes) - 0.3 < c < max(slopes) + 0.3] if slopes else []


class Figure:
    """Panels in columns with a title and a caption above, legends below; save() puts it together."""

    def __init__(self, study, panels, panel_height, notes=()):
        columns = min(panels, 2)
        rows = -(-panels // columns)
        self.height = panel_height * rows
        self.figure, axes = plt.subplots(rows, columns, squeeze=False, figsize=(WIDTH, self.height), dpi=DPI,
                                         layout="constrained")
        self.panels = list(axes.flat)[:panels]
        for unused in list(axes.flat)[panels:]:
            unused.remove()
        caption = "\n".join(textwrap.fill(note, 135) for note in (study.caption(), *notes) if note)
        self.title, self.caption = textwrap.fill(study.content["title"], 85), caption
        self.legends, self.after_layout = [], []

    def legend(self, title, entries):
        """A legend of entries (look, label), laid out by save()."""
        handles = [Line2D([], [], **{"color": "0.3", "linestyle": "none", "markersize": 5.5, "linewidth": 1.6, **look})
                   for look, _ in entries]
        self.legends.append(dict(handles=handles, labels=[plain(label) for _, label in entries], title=plain(title),
                                 ncols=-(-len(entries) // MOST_ROWS)))

    def lay_out_legends(self):
        """Legends side by side as far as they fit, then in a further row; gives their height [in]."""
        renderer = self.figure.canvas.get_renderer()
        placed, x, y, row_height = [], 0.1, 0.0, 0.0
        for legend in self.legends:
            box = self.figure.legend(**legend, loc="upper left", alignment="left", frameon=False, fontsize=9,
                                     title_fontproperties={"size": 9, "weight": "bold"}, borderaxespad=0)
            extent = box.get_window_extent(renderer)
            width, height = extent.width / DPI, extent.height / DPI
            if x > 0.1 and x + width > WIDTH:
                x, y, row_height = 0.1, y + row_height, 0.0
            placed.append((box, x, y))
            x, row_height = x + width + 0.15, max(row_height, height)
        return placed, y + row_height

    def save(self, folder, name):
        placed, below = self.lay_out_legends()
        lines = self.caption.count("\n") + 1
        above = 0.12 + 0.22 * (self.title.count("\n") + 1) + 0.15 * lines
        whole = self.height + above + below
        self.figure.set_size_inches(WIDTH, whole)
        self.figure.get_layout_engine().set(rect=(0, below / whole, 1, self.height / whole))
        self.figure.text(0.1 / WIDTH, 1 - 0.08 / whole, plain(self.title), fontsize=12, va="top")
        self.figure.text(0.1 / WIDTH, 1 - (above - 0.04) / whole, plain(self.caption), va="bottom", **SMALL)
        for box, x, y in placed:
            box.set_bbox_to_anchor((x / WIDTH, (below - y) / whole))
        self.figure.draw_without_rendering()
        for finish in self.after_layout:
            finish()
        save(self.figure, folder, name)
