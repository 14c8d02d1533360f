# A figure with panels of lines on logarithmic axes, guides to read their slopes by, and its legends below.

from matplotlib.lines import Line2D
from matplotlib.ticker import FixedLocator, FuncFormatter, LogLocator, NullLocator

WIDTH, DPI = 9.5, 160  # [in], [1/in]
CHARACTER = 0.065  # width of a character of a tick [in]
FAN = 0.25  # size of the slope guides, in parts of a panel
MOST_ROWS = 8  # of a legend's column


def power_of_ten(value, _):
    exponent = math.floor(math.log10(value) + 1e-9)
    mantissa = round(value / 10.0**exponent)
    return f"$10^{{{exponent}}}$" if mantissa == 1 else rf"${mantissa} \cdot 10^{{{exponent}}}$"


def logarithmic(axis, values, powers=False, ticks=None):
    """Limits around the values, at least 0.7 decades apart, with few ticks; the given ones, as far as not crowded."""
    low, high = math.log10(min(values)), math.log10(max(values))
    slack = max(0.07 * (high - low), (0.7 - (high - low)) / 2)
    limits = 10.0 ** (low - slack), 10.0 ** (high + slack)
    (axis.axes.set_xscale if axis.axis_name == "x" else axis.axes.set_yscale)("log")
    (axis.axes.set_xlim if axis.axis_name == "x" else axis.axes.set_ylim)(limits)
    decades = high - low + 2 * slack
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if decades < 2 else (1,)))
    axis.set_minor_locator(LogLocator(subs=range(2, 10)) if 2 <= decades < 8 else NullLocator())
    if ticks:
        width, kept = axis.axes.get_window_extent().width / DPI, []
        for tick in sorted(set(ticks), reverse=True):
            if not kept or math.log10(kept[-1] / tick) > (len(f"{tick:g}") + 1) * CHARACTER / width * decades:
                kept.append(tick)
        axis.set_major_locator(FixedLocator(kept))
        axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(power_of_ten if powers else lambda value, _: f"{value:g}"))
    axis.set_minor_formatter(FuncFormatter(lambda *_: ""))


def draw_line(axes, line, runs, spread=None):
    """One line through the runs (x, y, row); spread(row) gives where whiskers along x end."""
    x, y = [run[0] for run in runs], [run[1] for run in runs]
    shape = {"linewidth": 1.2, "markersize": 4.8, "markeredgecolor": "white", "markeredgewidth": 0.4}
    axes.plot(x, y, **(shape | line.look), zorder=3)
    for _, height, row in runs if spread else []:
        least, greatest = spread(row)
        if least and greatest:
            axes.plot([least, greatest], [height, height], color=line.look["color"], linewidth=1.0, marker="|",
                      markersize=3.5, zorder=2)


def slopes_of(all_runs):
    """Slope between the last two runs at the fine end of each line."""
    slopes = []
    for runs in all_runs:
        steps = [math.log(b[1] / a[1]) / math.log(b[0] / a[0]) for a, b in zip(runs, runs[1:]) if a[0] != b[0]]
        slopes += steps[:1] + steps[-1:]
    return [slope for slope in slopes if math.isfinite(slope)]


def emptier_corner(axes, rising):
    """Of the two corners that lines of such a slope leave free the one with fewer of them: its least x and y."""
    left, right, low, high = 0.03, 0.87 - FAN, 0.09, 0.91 - FAN  # with room for labels
    corners = [(right, low), (left, high)] if rising else [(left, low), (right, high)]

    def crowd(corner):
        inside = 0
        for drawn in axes.lines:
            xy = axes.transAxes.inverted().transform(drawn.get_transform().transform(drawn.get_xydata()))
            along = np.vstack([a + np.linspace(0, 1, 20)[:, None] * (b - a) for a, b in zip(xy, xy[1:])] or [xy])
            inside += np.all((along > np.subtract(corner, 0.02)) & (along < np.add(corner, FAN + 0.02)), axis=1).sum()
        return inside

    return min(corners, key=crowd)


def draw_slopes(axes, slopes, labels):
    """Guides of the slopes, a fan from one place in a corner, as many as have room for their label; to be called once
    the limits of the axes are known."""
    decades = [math.log10(high / low) for low, high in (axes.get_xlim(), axes.get_ylim())]
    rising, ends = slopes[0] > 0, []
    start = np.add(emptier_corner(axes, rising), (0.0, 0.0 if rising else FAN))
    for slope, label in zip(slopes, labels):
        step = np.array([1.0 / decades[0], slope / decades[1]])  # in parts of the panel
        step *= FAN / np.abs(step).max()
        end, sideways = start + step, abs(step[0]) >= abs(step[1])
        if any(np.all(np.abs(end - other) < (0.09, 0.06)) for other in ends):
            continue
        ends.append(end)
        axes.plot(*zip(start, end), transform=axes.transAxes, color="0.6", linewidth=0.8, zorder=1)
        axes.annotate(label, end, xycoords=axes.transAxes, xytext=(3, 0) if sideways else (0, 2 if rising else -2),
                      textcoords="offset points", ha="left" if sideways else "center",
                      va="center" if sideways else "bottom" if rising else "top", fontsize=8, color="0.35", zorder=1)


def make_room(axes, x):
    """For figures at an end of the lines, that at x."""
    low, high = axes.get_xlim()
    wider = (high / low) ** 0.05
    axes.set_xlim((low / wider, high) if x < math.sqrt(low * high) else (low, high * wider))


def draw_orders(axes, orders):
    """Figures (colour, (x, y), order) at the fine ends of lines, moved apart where they would overlap."""
    low, high = axes.get_xlim()
    at_left = orders[0][1][0] < math.sqrt(low * high)
    places = sorted((axes.transData.transform(xy)[1] * 72 / DPI, xy, colour, order) for colour, xy, order in orders)
    free = -math.inf
    for height, xy, colour, order in places:
        free = max(height, free + 8.5)
        axes.annotate(f"{order:.1f}", xy, xytext=(-5 if at_left else 5, free - height), textcoords="offset points",
                      ha="right" if at_left else "left", va="center", fontsize=8, color=colour)


def fitting(candidates, slopes):
    """The candidates near what was observed."""
    return [c for c in candidates if min(slopes) - 0.3 < c < max(slopes) + 0.3] if slopes else []


class Figure:
    """Panels in columns with a title and a caption above, legends below; save() puts it together."""

    def __init__(self, study, panels, panel_height, notes=()):
        columns = min(panels, 2)
        self.rows = -(-panels // columns)
        self.panel_height, self.free = panel_height, self.rows * columns > panels
        self.figure, axes = plt.subplots(self.rows, columns, squeeze=False, figsize=(WIDTH, panel_height * self.rows),
                                         dpi=DPI, layout="constrained")
        self.panels = list(axes.flat)[:panels]
        for axis in self.panels:
            axis.tick_params(labelsize=9)
        for unused in list(axes.flat)[panels:]:
            unused.remove()
        notes = " · ".join(note for note in notes if note)
        self.title = textwrap.fill(study.content["title"], 105)
        self.caption = "\n".join(textwrap.fill(line, 160) for line in (study.caption(), notes) if line)
        self.legends, self.after_layout = [], []

    def legend(self, title, entries, columns=1):
        """A legend of entries (look, label), laid out by save()."""
        usual = {"color": "0.3", "linestyle": "none", "markersize": 6, "linewidth": 1.5}
        self.legends.append({"handles": [Line2D([], [], **(usual | look)) for look, _ in entries],
                             "labels": [plain(textwrap.fill(label, 80)) for _, label in entries], "title": plain(title),
                             "ncols": max(columns, -(-len(entries) // MOST_ROWS))})

    def lay_out_legends(self, width):
        """Legends side by side as far as they fit, then in a further row, as (legend, x, y), and their height [in]."""
        renderer = self.figure.canvas.get_renderer()
        placed, x, y, row_height = [], 0.0, 0.0, 0.0
        for legend in self.legends:
            box = self.figure.legend(**legend, loc="upper left", alignment="left", frameon=False, fontsize=9,
                                     title_fontproperties={"size": 9, "weight": "bold"}, borderaxespad=0,
                                     handlelength=2.8)
            extent = box.get_window_extent(renderer)
            if x > 0 and x + extent.width / DPI > width:
                x, y, row_height = 0.0, y + row_height, 0.0
            placed.append((box, x, y))
            x, row_height = x + extent.width / DPI + 0.15, max(row_height, extent.height / DPI)
        return placed, y + row_height

    def place_legends(self):
        """In the place of a last panel that is not there, if they fit; else below the panels, which moves these up."""
        if self.free:
            placed, height = self.lay_out_legends(WIDTH / 2 - 0.6)
            if height < self.panel_height:
                return placed, WIDTH / 2 + 0.5, self.panel_height - 0.2, 0.0
            for box, _, _ in placed:
                box.remove()
        placed, height = self.lay_out_legends(WIDTH - 0.1)
        return placed, 0.1, height, height

    def save(self, folder, name):
        placed, left, top, below = self.place_legends()
        above = 0.15 + 0.22 * (self.title.count("\n") + 1) + 0.15 * (self.caption.count("\n") + 1)
        panels = self.panel_height * self.rows
        whole = panels + above + below
        self.figure.set_size_inches(WIDTH, whole)
        self.figure.get_layout_engine().set(rect=(0, below / whole, 0.995, panels / whole))
        self.figure.text(0.1 / WIDTH, 1 - 0.08 / whole, plain(self.title), fontsize=12, va="top")
        self.figure.text(0.1 / WIDTH, 1 - (above - 0.05) / whole, plain(self.caption), va="bottom", fontsize=8,
                         color="0.35")
        for box, x, y in placed:
            box.set_bbox_to_anchor(((left + x) / WIDTH, (top - y) / whole))
        self.figure.draw_without_rendering()
        for finish in self.after_layout:
            finish()
        save(self.figure, folder, name)
