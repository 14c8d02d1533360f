"""Draws study.json: error_time.png and error_refinement.png, the errors over time and over refinement; phases.png, what
the finest runs spend their time on; memory.png, peak memory over the number of unknowns."""

import zlib

MOST_BARS = 30
MOST_IN_NAME = 46  # characters of a bar's name in one row
SMALLEST_PHASE = 0.01  # of a run; phases that are smaller in every run are drawn as one
PHASES = ["setup", "support", "weights", "boundary", "pattern", "assembly", "analyse", "factorise", "solve", "update",
          "errors", "cells", "mass", "ghost_mass", "forces", "damping", "accelerate", "move", "history",
          "critical_step", "gravity", "projection", "diagnostics", "condition_estimate", "report", "output",
          "pictures"]
SECONDS = ("seconds", "median")
OF_TIME = {0.5: "1/2", 1: "1", 1.5: "3/2", 2: "2", 3: "3", 4: "4"}  # exponents whose guides are drawn
ORDERS = [1, 2, 3, 4]
REPEATS = "medians, with whiskers from the least to the greatest time"
MOST_FIGURES = 8  # lines whose observed order is written at their fine end


def colour_of(phase):
    """The same in every picture of every study."""
    if phase == "other":
        return "0.75"
    place = PHASES.index(phase) if phase in PHASES else zlib.crc32(phase.encode())
    return matplotlib.colormaps["tab20" if place < 20 else "tab20b"](place % 20)


def add_legends(figure, study, others):
    """What colours, markers and dashes stand for."""
    for group in study.groups:
        entries = []
        for label, look in group.looks.items():
            line = {} if group.shown_by == ("marker",) else {"linestyle": look.get("linestyle", "solid")}
            entries.append((look | line, label))
        figure.legend(group.title, entries)
    if others:
        figure.legend("other programs", [(line.look, line.name) for line in others])


def add_tolerance(figure, study, shown, x):
    """The wanted error as a line, and a ring around the run that was chosen for it."""
    tolerance = study.content.get("tolerance")
    if not tolerance or tolerance["norm"] not in shown:
        return
    axes = figure.panels[shown.index(tolerance["norm"])]
    wanted = {"color": "0.15", "linewidth": 1.0, "linestyle": (0, (8, 2, 1, 2))}
    axes.axhline(tolerance["value"], **wanted, zorder=1)
    entries = [(wanted, f"{tolerance['value']:g} wanted")]
    chosen = tolerance.get("chosen")
    row = study.rows[chosen] if chosen is not None else None
    if number(row, *x) and number(row, "errors", tolerance["norm"]):
        ring = {"color": "black", "marker": "o", "markersize": 12, "markerfacecolor": "none", "markeredgewidth": 1.4}
        axes.plot([number(row, *x)], [number(row, "errors", tolerance["norm"])], **ring, zorder=4)
        entries.append((ring | {"linestyle": "none"}, ", ".join(dict.fromkeys(
            [row["line"], *(with_unit(name, value) for name, value in row["labels"].items()
                            if name == study.content["refine"])]))))
    figure.legend(f"tolerance of {norm_title(tolerance['norm'])}", entries)


def guides(figure, axes, runs, candidates, label):
    """Slopes of the candidates that fit the runs, drawn when the axes have their place."""
    slopes = slopes_of(runs)
    sign = 1.0 if sum(slope > 0 for slope in slopes) > len(slopes) / 2 else -1.0  # a steep one may be noise of time
    chosen = fitting(candidates, [sign * slope for slope in slopes])
    if chosen:
        figure.after_layout.append(lambda: draw_slopes(axes, [sign * c for c in chosen], [label(c) for c in chosen]))


def error_figure(study, x, note, spread=None):
    """Panels of the norms that the study holds with an x, with their lines; none where there is no such run."""
    lines = study.lines + study.others
    shown = [norm for norm in study.norms if any(line.points(x, ("errors", norm)) for line in study.lines)]
    if not shown:
        return None, [], {}
    figure = Figure(study, len(shown), 3.3 if len(shown) > 1 else 4.4, [study.content["device"], note])
    runs_of = {norm: [line.points(x, ("errors", norm)) for line in lines] for norm in shown}
    for k, (axes, norm) in enumerate(zip(figure.panels, shown)):
        runs = [run for of_line in runs_of[norm] for run in of_line]
        limits = [bound for run in runs for bound in (spread(run[2]) if spread else ()) if bound]
        tolerance = study.content.get("tolerance") or {}
        wished = [tolerance["value"]] if tolerance.get("norm") == norm else []
        logarithmic(axes.xaxis, [run[0] for run in runs] + limits,
                    ticks=None if spread else [run[0] for run in runs])
        logarithmic(axes.yaxis, [run[1] for run in runs] + wished, powers=True)
        for line, of_line in zip(lines, runs_of[norm]):
            draw_line(axes, line, of_line, spread)
        axes.set_title(plain(norm_title(norm)), fontsize=10.5)
        axes.set_ylabel("error" if k % 2 == 0 else "")
        axes.grid(color="0.92", linewidth=0.6)
    add_legends(figure, study, [line for k, line in enumerate(lines) if line in study.others
                                and any(runs_of[norm][k] for norm in shown)])
    add_tolerance(figure, study, shown, x)
    return figure, shown, runs_of


def draw_error_time(folder, study):
    """Work and precision: what error costs how many seconds."""
    def spread(row):
        return number(row, "seconds", "least"), number(row, "seconds", "greatest")

    repeated = any(least != greatest for least, greatest in map(spread, study.rows))
    figure, shown, runs_of = error_figure(study, SECONDS, REPEATS if repeated else "", spread)
    if figure:
        for axes, norm in zip(figure.panels, shown):
            guides(figure, axes, runs_of[norm], OF_TIME, lambda q: f"$t^{{-{OF_TIME[q]}}}$")
            axes.set_xlabel("seconds of the whole run without output")
        figure.save(folder, "error_time.png")


def observed_orders(study, norm):
    """The rate that the study found at the finest run of each line, as (colour, (x, error), order)."""
    found = [(line.look["color"], (number(line.finest, "refinement"), number(line.finest, "errors", norm)),
              (line.finest.get("rates") or {}).get(norm)) for line in study.lines]
    return [(colour, xy, order) for colour, xy, order in found if None not in (*xy, order)]


def draw_error_refinement(folder, study):
    orders = {norm: observed_orders(study, norm) for norm in study.norms}
    written = any(orders.values()) and len(study.lines) <= MOST_FIGURES
    figure, shown, runs_of = error_figure(study, ("refinement",),
                                          "figures: order observed at the finest run" if written else "")
    if not figure:
        return
    for axes, norm in zip(figure.panels, shown):
        guides(figure, axes, runs_of[norm], ORDERS, lambda order: f"order {order}")
        axes.set_xlabel(plain(axis_title(study.content["refine"])))
        if written and orders[norm]:
            make_room(axes, orders[norm][0][1][0])
            figure.after_layout.append(lambda axes=axes, found=orders[norm]: draw_orders(axes, found))
    figure.save(folder, "error_refinement.png")


def draw_memory(folder, study):
    unknowns, bytes_ = ("unknowns",), ("peak_memory_bytes",)
    runs_of = [[(x, y / 2**20, row) for x, y, row in line.points(unknowns, bytes_)] for line in study.lines]
    runs = [run for of_line in runs_of for run in of_line]
    if not runs:
        return
    figure = Figure(study, 1, 4.4)
    axes = figure.panels[0]
    logarithmic(axes.xaxis, [run[0] for run in runs])
    logarithmic(axes.yaxis, [run[1] for run in runs])
    for line, of_line in zip(study.lines, runs_of):
        draw_line(axes, line, of_line)
    axes.set(xlabel="unknowns", ylabel="peak memory [MiB]")
    axes.grid(color="0.92", linewidth=0.6)
    add_legends(figure, study, [])
    figure.save(folder, "memory.png")


def phases_of(rows):
    """Phases in a fixed order, those that are small in every run as one; and their seconds (phase, run)."""
    runs = [{name: seconds for name, seconds in row["phases"].items() if seconds} for row in rows]
    large = {name for run in runs for name, seconds in run.items() if seconds >= SMALLEST_PHASE * sum(run.values())}
    phases = [name for name in PHASES if name in large] + sorted(large - set(PHASES))
    seconds = [[run.get(name, 0.0) for run in runs] for name in phases]
    others = [sum(s for name, s in run.items() if name not in large) for run in runs]
    return (phases + ["other"], np.array(seconds + [others])) if any(others) else (phases, np.array(seconds))


def finest_note(study, lines):
    """At which refinement the bars are, as most have it; and the lines' names, those of others with their own."""
    refinements = [number(line.finest, "refinement") for line in lines]
    common = max(refinements, key=refinements.count)
    names = [line.name if own == common else f"{line.name} ({own:g})" for line, own in zip(lines, refinements)]
    if not common:
        return "", names
    note = f"each line at its finest run: {with_unit(study.content['refine'], common)}"
    return note + (", where no other is said" if len(set(refinements)) > 1 else ""), names


def draw_bars(axes, phases, widths):
    """Stacked bars, one a column of widths (phase, line)."""
    left = np.zeros(widths.shape[1])
    for phase, width in zip(phases, widths):
        axes.barh(range(len(width)), width, left=left, height=0.74, color=colour_of(phase))
        left += width


def draw_phases(folder, study):
    """Seconds by phase, and what share of the run each phase takes."""
    lines = [line for line in study.lines if sum((line.finest.get("phases") or {}).values()) > 0]
    if not lines:
        return
    if len(lines) > MOST_BARS:
        lines = sorted(lines, key=lambda line: number(line.finest, "errors", *study.norms[:1]) or math.inf)[:MOST_BARS]
    lines.sort(key=lambda line: -sum(line.finest["phases"].values()))
    phases, seconds = phases_of([line.finest for line in lines])
    note, names = finest_note(study, lines)
    figure = Figure(study, 2, 0.75 + 0.235 * len(lines), [note])
    totals = seconds.sum(axis=0)
    for axes, widths, most in zip(figure.panels, (seconds, 100 * seconds / totals), (1.25 * totals.max(), 100)):
        draw_bars(axes, phases, widths)
        axes.set(xlim=(0, most), ylim=(-0.6, len(lines) - 0.4), yticks=[])
    for k, total in enumerate(totals):
        figure.panels[0].annotate(f"{total:#.3g} s" if total < 100 else f"{total:.0f} s", (total, k), xytext=(4, 0),
                                  textcoords="offset points", va="center", fontsize=8)
    figure.panels[0].set_yticks(range(len(lines)), [plain(textwrap.fill(name, MOST_IN_NAME)) for name in names],
                                fontsize=8.5 if max(map(len, names)) <= MOST_IN_NAME else 6.5)
    figure.panels[0].set_xlabel("seconds by phase")
    figure.panels[1].set_xlabel("share by phase [%]")
    figure.legend("phases", [({"color": colour_of(phase), "marker": "s", "markersize": 8}, phase.replace("_", " "))
                             for phase in phases], columns=6)
    figure.save(folder, "phases.png")


def study_pictures(folder):
    for name in ("error_time.png", "error_refinement.png", "phases.png", "memory.png"):
        if os.path.exists(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    study = Study(folder)
    draw_error_time(folder, study)
    draw_error_refinement(folder, study)
    draw_phases(folder, study)
    draw_memory(folder, study)


study_pictures(sys.argv[1])
