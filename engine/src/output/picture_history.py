# Of a dynamic run: history.png, its energies and its probes over time.

ENERGIES = {"kinetic": "C0", "strain": "C1", "gravity": "C2", "total": "black"}
MOST_NAMES_A_COLUMN = 10  # of a legend


class Curve:
    """One quantity over time, with its exact course where that is known."""

    def __init__(self, name, t, values, exact=None, colour=None):
        self.name, self.t, self.values, self.exact, self.colour = name, t, values, exact, colour


def energy_curves(history):
    """Gravity's potential counts from its start; energies that stay zero are left out."""
    energy = {name: history[name][:] for name in ENERGIES}
    energy["total"] = energy["total"] - energy["gravity"][0]
    energy["gravity"] = energy["gravity"] - energy["gravity"][0]
    return [Curve(name, history["t"][:], values, colour=ENERGIES[name])
            for name, values in energy.items() if name == "total" or np.any(values)]


def probe_curves(probes, field, symbol):
    """Of every probe that has the field the component that varies most."""
    curves = []
    for probe in probes:
        if field not in probe:
            continue
        values = probe[field][:]
        component = most_telling(values)
        exact = probe[f"exact_{field}"][:, component] if f"exact_{field}" in probe else None
        index = ("xx", "yy", "xy", "zz")[component] if values.shape[1] == 4 else "xy"[component]
        curves.append(Curve(f"{symbol}_{index} of {probe.attrs['name']}", probe["t"][:], values[:, component], exact))
    return curves


def draw_curves(axes, curves, quantity, unit, seconds):
    """The curves in a readable unit, over t in units of so many seconds."""
    readable, scale = readable_unit(np.concatenate([curve.values for curve in curves]), unit)
    for k, curve in enumerate(curves):
        axes.plot(curve.t / seconds, curve.values / scale, color=curve.colour or f"C{k % 10}", linewidth=1.3,
                  label=plain(curve.name))
    for k, curve in enumerate(curve for curve in curves if curve.exact is not None):
        axes.plot(curve.t / seconds, curve.exact / scale, color="black", linewidth=0.9, linestyle="dashed",
                  label=None if k else "exact")
    axes.set_ylabel(f"{quantity} [{readable}]")
    axes.grid(color="0.9", linewidth=0.6)
    axes.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), frameon=False, fontsize="small",
                ncols=1 + (len(curves) - 1) // MOST_NAMES_A_COLUMN)


def draw_history(folder, title, file):
    """The energies, and of every probe displacement, velocity and stress; nothing where the file holds none."""
    probes = list(file["probes"].values()) if "probes" in file else []
    panels = [("energy", "J/m", energy_curves(file["history"]) if "history" in file else []),
              ("displacement", "m", probe_curves(probes, "displacement", "u")),
              ("velocity", "m/s", probe_curves(probes, "velocity", "v")),
              ("stress", "Pa", probe_curves(probes, "stress", "σ"))]
    panels = [panel for panel in panels if panel[2]]
    if not panels:
        return
    t = np.concatenate([curve.t for _, _, curves in panels for curve in curves])
    readable, seconds = readable_unit(t, "s")
    figure, rows = plt.subplots(len(panels), 1, sharex=True, squeeze=False, figsize=(11, 0.9 + 2.3 * len(panels)),
                                dpi=130, layout="constrained")
    figure.suptitle(plain(title))
    for axes, (quantity, unit, curves) in zip(rows[:, 0], panels):
        draw_curves(axes, curves, quantity, unit, seconds)
    rows[-1, 0].set(xlabel=f"t [{readable}]", xlim=(0.0, t.max() / seconds or 1.0))
    figure.align_ylabels()
    save(figure, folder, "history.png")
