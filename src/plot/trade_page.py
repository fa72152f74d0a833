"""What accuracy costs: error against CPU time, one curve a kind of choice, and where the time goes."""

import matplotlib.pyplot as plt
import numpy as np

import look

KINDS = ("residual", "jacobian", "factor", "solve")
COLOURS = dict(zip(KINDS, (look.BLUE, look.GREEN, look.ORANGE, look.PURPLE)))
MARKERS = "osD^v<>Pph*X"


def filled(variable):
    return np.ma.filled(np.ma.masked_invalid(variable[:]), np.nan).astype(float)


def curves(axes, data, errors, unit, number, title, limit=None):
    """Each group as a curve through its choices and the scene as it stands; the front below them."""
    cost = filled(data["cpu_seconds"])
    groups = [str(g) for g in data["group"][:]]
    words = [str(w) for w in data["choice_words"][:]]
    names = [g for g in dict.fromkeys(groups) if g not in ("scene", "reference")]
    floor = np.nanmin(errors[errors > 0.0]) if np.any(errors > 0.0) else 1e-16
    shown = np.where(errors > 0.0, errors, 0.5 * floor)
    for colour, marker, name in zip(look.sequence_colours(len(names), "turbo"), MARKERS * 3, names):
        members = [i for i, g in enumerate(groups) if g in (name, "scene") and np.isfinite(errors[i])]
        members.sort(key=lambda i: cost[i])
        if any(groups[i] == name for i in members):
            axes.plot(cost[members], shown[members], "-", color=colour, linewidth=0.9, alpha=0.7)
            own = [i for i in members if groups[i] == name]
            axes.plot(cost[own], shown[own], marker, color=colour, label=name, markersize=6)
    for i, name in enumerate(groups):
        if name == "grid" and np.isfinite(errors[i]):
            axes.annotate(words[i], (cost[i], shown[i]), xytext=(5, 4), textcoords="offset points", fontsize=8)
    if np.isfinite(errors[0]):
        axes.plot(cost[0], shown[0], "o", color=look.INK, markersize=9, fillstyle="none", markeredgewidth=1.6, label="the scene as it stands")
    front = front_of(cost, errors)
    axes.step(cost[front], shown[front], where="post", color=look.INK, linewidth=1.4, linestyle="--", label="nothing better")
    if limit is not None and np.isfinite(limit) and limit > 0.0:
        axes.axhspan(axes.get_ylim()[0], limit, color="#eeeeee", zorder=0)
        axes.text(0.99, limit, "what the reference itself is known to", transform=axes.get_yaxis_transform(), ha="right", va="bottom", fontsize=8,
                  color=look.FAINT)
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel("CPU seconds of the run")
    axes.set_ylabel(unit)
    look.grid(axes)
    look.label(axes, number, title)


def front_of(cost, errors):
    front, best = [], np.inf
    for i in np.lexsort((errors, cost)):
        if np.isfinite(cost[i]) and errors[i] < best:
            front.append(i)
            best = errors[i]
    return front


def shares(axes, data, number):
    """Where the CPU time of each choice went."""
    cost = filled(data["cpu_seconds"])
    names = [f"{g} {w}" for g, w in zip(data["group"][:], data["choice_words"][:])]
    rows = [i for i in np.argsort(cost) if np.isfinite(cost[i])]
    place = np.arange(len(rows))
    left = np.zeros(len(rows))
    for kind in KINDS:
        if f"cpu_{kind}" not in data.variables:
            continue
        part = np.nan_to_num(filled(data[f"cpu_{kind}"])[rows])
        axes.barh(place, part / cost[rows], left=left, color=COLOURS[kind], label=kind, height=0.75)
        left = left + part / cost[rows]
    axes.barh(place, np.maximum(1.0 - left, 0.0), left=left, color="#d9d9d9", label="the rest, output included", height=0.75)
    axes.set_yticks(place, [f"{names[i]}  ({cost[i]:.3g} s)" for i in rows], fontsize=8)
    axes.set_xlim(0.0, 1.0)
    axes.set_xlabel("share of CPU time")
    axes.legend(ncols=3, loc="lower center", bbox_to_anchor=(0.45, 1.03))
    look.label(axes, number, "where the time goes")


def draw(data, folder):
    judge = data.judge
    error = data[f"error_{judge}"]
    exact = "exact_slope_error" in data.variables
    n = len(data.dimensions["choice"])
    figure = plt.figure(figsize=(16, max(9.0, 0.24 * n + 2.0)))
    grid = figure.add_gridspec(2 if exact else 1, 2, width_ratios=(1.35, 1.0))
    first = figure.add_subplot(grid[0, 0])
    curves(first, data, filled(error) / error.reference_scale, f"largest error of {judge}, relative", 0, "against the reference",
           error.reference_uncertainty / error.reference_scale)
    first.legend(fontsize=8, ncols=2, loc="best")
    if exact:
        curves(figure.add_subplot(grid[1, 0]), data, filled(data["exact_slope_error"]), "error of the slope [degrees]", 1, "against the exact slope")
    shares(figure.add_subplot(grid[:, 1]), data, 2 if exact else 1)
    figure.suptitle(data.title, fontsize=12)
    return look.save(figure, folder, "study.png")
