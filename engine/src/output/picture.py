"""Draws results.h5: deformed.png, the body at its last saved step, coloured by a stress and by displacement; or field.png,
a projected field and its error. Of a dynamic run history.png, too, as picture_history.py says; error_estimate.png, the
estimated error of the stress, where the last step holds it."""

try:
    import h5py
except ImportError:
    sys.exit(77)
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm
from matplotlib.path import Path

MOST_DRAWN_POINTS = 200_000  # more of them are drawn as their means in square bins
BINS = 350  # along the body's longer side
MOST_BACKED_POINTS = 50_000  # among more of them no gaps are seen
SMALLEST_VISIBLE = 0.02  # of the body's size; smaller displacements are exaggerated to 0.05 of it
STRESS_NAMES = ["σ_xx", "σ_yy", "σ_xy", "σ_zz"]
PREFIXES = {"": 1.0, "m": 1e-3, "µ": 1e-6, "n": 1e-9, "k": 1e3, "M": 1e6, "G": 1e9}


def readable_unit(values, unit):
    """The unit with the prefix that brings the largest magnitudes to 1..1000, and how much of the plain one it is."""
    largest = np.percentile(np.abs(values), 99.5)
    fitting = [p for p, scale in PREFIXES.items() if 1 <= largest / scale < 1000]
    prefix = fitting[0] if fitting else ""
    return prefix + unit, PREFIXES[prefix]


def in_readable_unit(values, unit):
    readable, scale = readable_unit(values, unit)
    return values / scale, readable


def most_telling(stress):
    """The stress component that varies most; the largest one where the stress is uniform."""
    spread = np.ptp(stress, axis=0)
    largest = np.abs(stress).max(axis=0)
    uniform = spread.max() < 1e-6 * largest.max()
    return int(np.argmax(largest if uniform else spread))


def colour_limits(values):
    """Limits that a few extreme points do not spoil, wide enough to hide rounding, and whether values lie beyond."""
    low, high = np.percentile(values, [0.5, 99.5])
    least = 1e-3 * max(abs(low), abs(high)) or 1.0
    if high - low < least:
        low, high = (low + high - least) / 2, (low + high + least) / 2
    slack = 0.05 * (high - low)
    below, above = values.min() < low - slack, values.max() > high + slack
    return low, high, {(0, 0): "neither", (1, 0): "min", (0, 1): "max", (1, 1): "both"}[(int(below), int(above))]


def exaggeration(displacement, size):
    """1 where displacements are visible, else a round factor that makes them so."""
    largest = np.linalg.norm(displacement, axis=1).max()
    if largest >= SMALLEST_VISIBLE * size or largest < 1e-12 * size:
        return 1
    wanted = 0.05 * size / largest
    decade = 10.0 ** np.floor(np.log10(wanted))
    return int(max(f * decade for f in (1, 2, 5) if f * decade <= wanted))


def binned(origin, displacement, stress, volume, width):
    """Means of the points by square bins, weighted with their volumes, which are summed."""
    column, row = np.floor((origin - origin.min(axis=0)) / width).astype(np.int64).T
    _, of_point = np.unique(column * (row.max() + 1) + row, return_inverse=True)
    total = np.bincount(of_point, volume)
    means = [np.column_stack([np.bincount(of_point, volume * c) / total for c in field.T])
             for field in (origin, displacement, stress)]
    return *means, total


def is_dynamic(file):
    return file.attrs["analysis"] == "explicit_dynamics"


class Body:
    """What is drawn: points of the last step, and curves at the start and then, all with exaggerated displacements."""

    def __init__(self, file):
        steps = sorted(file["steps"], key=int)
        if not steps:
            sys.exit("results.h5 holds no saved step")
        first, last = file["steps"][steps[0]], file["steps"][steps[-1]]
        self.caption = f"load step {last.attrs['step']}, t = {last.attrs['t']:.6g}"
        if is_dynamic(file):
            self.caption = f"step {last.attrs['step']}, t = {last.attrs['t']:.6g} s"
        self.edges = file["grid/edges"][:] if "grid/edges" in file else None
        self.read_points(last["points"])
        self.start = read_curves(first)
        now = read_curves(last)
        if self.factor != 1:
            self.caption += f", displacements × {self.factor}"
        if self.start:
            self.caption += " (boundary solid, at the start dashed)"
        self.now = [a + self.factor * (b - a) if a.shape == b.shape else b for a, b in zip(self.start, now)]
        self.outline = closed_path(self.now, 1e-3 * self.size)
        if self.outline is not None:
            self.reach_outline()
            self.fill_gaps()

    def read_points(self, points):
        displacement, stress = points["displacement"][:, :2], points["stress"][:]
        if "stress_error_estimate" in points:  # goes with the stress into a fifth column
            stress = np.column_stack([stress, points["stress_error_estimate"][:]])
        origin = points["position"][:, :2] - displacement
        sound = np.isfinite(origin + displacement).all(axis=1) & np.isfinite(stress).all(axis=1)
        if not sound.any():
            sys.exit("results.h5 holds no material point whose stress and position are finite")
        self.size = max(np.ptp(origin[sound], axis=0).max(), np.sqrt(points["volume"][:].max()))
        self.factor = exaggeration(displacement[sound], self.size)
        origin, displacement, stress = origin[sound], displacement[sound], stress[sound]
        volume = points["volume"][:][sound]
        if len(volume) > MOST_DRAWN_POINTS:
            origin, displacement, stress, volume = binned(origin, displacement, stress, volume, self.size / BINS)
        self.displacement, self.stress, self.side = displacement, stress, np.sqrt(volume)
        self.x = origin + self.factor * displacement

    def reach_outline(self):
        """Draws cut sub-cells of a lattice behind the whole ones, and so large that they reach the outline."""
        whole = self.side > 0.999 * self.side.max()
        if whole.mean() < 0.25:
            return
        order = np.argsort(self.side, kind="stable")
        self.side[~whole] = 1.4 * self.side.max()
        self.x, self.displacement, self.stress, self.side = (
            field[order] for field in (self.x, self.displacement, self.stress, self.side))

    def fill_gaps(self):
        """Draws every point also behind all others, so large that no gap shows where the material turned or stretched."""
        if len(self.x) > MOST_BACKED_POINTS:
            return
        self.side = np.concatenate([3.0 * self.side, self.side])
        self.x, self.displacement, self.stress = (
            np.vstack([field, field]) for field in (self.x, self.displacement, self.stress))

    def bounds(self):
        half = self.side[:, None] / 2 if self.outline is None else 0
        everything = np.vstack([self.x - half, self.x + half, *self.start, *self.now])
        margin = 0.04 * np.ptp(everything, axis=0).max()
        return everything.min(axis=0) - margin, everything.max(axis=0) + margin


def read_curves(step):
    return [curve["polyline"][:, :2] for curve in step.get("curves", {}).values()]


def closed_path(curves, tolerance):
    """The path around the body; none where the curves do not close into loops."""
    left, vertices, codes = list(curves), [], []
    while left:
        loop = left.pop()
        while np.abs(loop[-1] - loop[0]).max() > tolerance:
            following = [k for k, curve in enumerate(left) if np.abs(curve[0] - loop[-1]).max() <= tolerance]
            if not following:
                return None
            loop = np.vstack([loop, left.pop(following[0])])
        vertices.append(loop)
        codes += [Path.MOVETO] + [Path.LINETO] * (len(loop) - 2) + [Path.CLOSEPOLY]
    return Path(np.vstack(vertices), codes) if vertices else None


def draw_edges(axes, edges, colour, order):
    if edges is not None:
        axes.add_collection(LineCollection(edges.reshape(-1, 2, 2), colors=colour, linewidths=0.4, zorder=order))


def draw(axes, body, values, label):
    low, high = body.bounds()
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), xlabel="x [m]", ylabel="y [m]", aspect="equal")
    draw_edges(axes, body.edges, "0.85", 0)
    least, most, beyond = colour_limits(values)
    squares = axes.scatter(*body.x.T, c=values, marker="s", linewidths=0, vmin=least, vmax=most, zorder=1)
    if body.outline is not None:
        squares.set_clip_path(body.outline, transform=axes.transData)
    axes.add_collection(LineCollection(body.start, colors="0.35", linewidths=0.9, linestyles="dashed", zorder=2))
    axes.add_collection(LineCollection(body.now, colors="black", linewidths=1.2, zorder=3))
    axes.figure.colorbar(squares, ax=axes, label=label, extend=beyond, shrink=0.9)
    return squares


def fit_squares(squares, body):
    """Gives every point the area of its volume and no seams, once it is known where the axes lie."""
    axes = squares.axes
    points_a_metre = axes.get_window_extent().width * 72 / axes.figure.dpi / np.ptp(axes.get_xlim())
    squares.set_sizes((body.side * points_a_metre + 0.5) ** 2)


def two_panels(width, height, title):
    side_by_side = width < 2.2 * height
    figure, panels = plt.subplots(*((1, 2) if side_by_side else (2, 1)), figsize=(12, 5.4) if side_by_side else (9, 7),
                                  dpi=130, layout="constrained")
    figure.suptitle(plain(title))
    return figure, panels


def draw_body(folder, title, body):
    figure, panels = two_panels(*np.subtract(*reversed(body.bounds())), f"{title}\n{body.caption}")

    component = most_telling(body.stress[:, :4])
    stress, unit = in_readable_unit(body.stress[:, component], "Pa")
    distance, unit_of_distance = in_readable_unit(np.linalg.norm(body.displacement, axis=1), "m")
    drawn = [draw(panels[0], body, stress, f"{STRESS_NAMES[component]} [{unit}]"),
             draw(panels[1], body, distance, f"|u| [{unit_of_distance}]")]
    figure.draw_without_rendering()
    for squares in drawn:
        fit_squares(squares, body)
    save(figure, folder, "deformed.png")


def draw_estimate(folder, title, body):
    """The estimated error of the stress at the points, in a logarithmic scale."""
    figure, axes = plt.subplots(figsize=(7.5, 6), dpi=130, layout="constrained")
    figure.suptitle(f"{title}\n{body.caption}".replace("$", r"\$"))
    rounding = 1e-12 * np.abs(body.stress[:, :4]).max()  # less is none
    error = np.maximum(body.stress[:, 4], rounding)
    unit, scale = readable_unit(error, "Pa")
    error = error / scale
    most = max(np.percentile(error, 99.5), 10 * rounding / scale) or 1.0
    least = np.clip(np.percentile(error, 0.5), 1e-4 * most, 0.1 * most)
    squares = draw(axes, body, np.maximum(error, least), f"estimated error of stress |σ* − σ| [{unit}]")
    squares.set_norm(LogNorm(least, most))
    figure.draw_without_rendering()
    fit_squares(squares, body)
    save(figure, folder, "error_estimate.png")


def draw_field(folder, title, file):
    """The field, and its error where that is known."""
    x, y = file["field/position"][:, :2].T
    triangles, edges = file["connectivity/triangles"][:], file["grid/edges"][:] if "grid/edges" in file else None
    figure, panels = two_panels(np.ptp(x), np.ptp(y), title)
    for axes, name, colours in zip(panels, ("value", "error"), ("viridis", "RdBu_r")):
        if name not in file["field"]:
            axes.remove()
            continue
        values = file[f"field/{name}"][:]
        most = np.abs(values).max() or 1.0
        limits = {"vmin": -most, "vmax": most} if name == "error" else {}
        field = axes.tripcolor(x, y, triangles, values, shading="gouraud", cmap=colours, **limits)
        draw_edges(axes, edges, "0.4", 2)
        axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal")
        figure.colorbar(field, ax=axes, label="projected field" if name == "value" else "its error", shrink=0.9)
    save(figure, folder, "field.png")


def picture(folder):
    with h5py.File(os.path.join(folder, "results.h5"), "r") as file:
        title = file.attrs["title"]
        if "field" in file:
            draw_field(folder, title, file)
        else:
            body = Body(file)
            draw_body(folder, title, body)
            if body.stress.shape[1] > 4:
                draw_estimate(folder, title, body)
        if is_dynamic(file):
            draw_history(folder, title, file)


picture(sys.argv[1])
