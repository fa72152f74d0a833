"""Refinement of a scene: how each number and each field nears its limit, and at which order."""

import textwrap

import matplotlib.pyplot as plt
import numpy as np

import look

COLOURS = {"settled": look.FAINT, "convergent": look.GREEN, "slow": look.ORANGE, "oscillating": look.PURPLE,
           "divergent": look.ACCENT, "unknown": "#000000"}
MOST_LINES = 12


def tendencies(variable):
    words = variable.flag_meanings.split()
    return [words[i] for i in variable[:]]


def filled(variable):
    return np.ma.filled(np.ma.masked_invalid(variable[:]), np.nan).astype(float)


def differences(data):
    """Relative differences between neighbouring levels of each number that changes, with its tendency."""
    rows = []
    for name, values, tendency in zip(data["number_name"][:], filled(data["number_value"]), tendencies(data["number_tendency"])):
        steps = np.abs(np.diff(values))
        scale = np.nanmax(np.abs(values))
        if scale > 0.0 and tendency not in ("settled", "unknown"):
            rows.append((name, steps / scale, tendency))
    return rows


def name_ends(axes, rows):
    """Each line's name beside its end, moved up where it would cover another."""
    low, high = axes.get_ylim()
    apart = 0.033 * np.log(high / low)
    place = -np.inf
    for name, steps, tendency in sorted((row for row in rows if row[1][-1] > 0.0), key=lambda row: row[1][-1]):
        place = max(np.log(steps[-1]), place + apart)
        axes.annotate(name, (len(steps), steps[-1]), xytext=(len(steps) + 0.12, np.exp(place)), fontsize=7.5, va="center",
                      color=COLOURS[tendency], annotation_clip=False,
                      arrowprops={"arrowstyle": "-", "color": COLOURS[tendency], "linewidth": 0.5})


def fall(axes, rows, title, number):
    axes.set_yscale("log")
    for name, steps, tendency in rows[:MOST_LINES]:
        axes.plot(np.arange(1, len(steps) + 1), steps, "o-", color=COLOURS[tendency], alpha=0.8, markersize=4)
    name_ends(axes, rows[:MOST_LINES])
    if rows:
        n = max(len(steps) for _, steps, _ in rows)
        levels = np.arange(1, n + 1)
        top = np.nanmax([np.nanmax(np.where(steps > 0, steps, np.nan)) for _, steps, _ in rows if np.any(steps > 0)] or [1.0])
        for order in (1, 2):
            axes.plot(levels, 2.0 * top * 0.5 ** (order * (levels - 1)), ":", color=look.FAINT, linewidth=1.2)
            axes.text(levels[-1], 2.0 * top * 0.5 ** (order * (n - 1)), f" order {order}", color=look.FAINT, fontsize=8)
        axes.set_xlim(0.8, n + 0.9 * max(1, n) * 0.6)
        axes.set_xticks(levels, [f"{i - 1} to {i}" for i in levels])
    look.grid(axes)
    axes.set_xlabel("levels compared")
    look.label(axes, number, title + (f", the first {MOST_LINES} of {len(rows)}" if len(rows) > MOST_LINES else ""))


def orders(axes, data):
    """The order of the last three levels of everything that has one."""
    names, found, colours = [], [], []
    for kind in ("number", "field"):
        if f"{kind}_order" not in data.variables:
            continue
        last = filled(data[f"{kind}_order"])[:, -1]
        for name, order, tendency in zip(data[f"{kind}_name"][:], last, tendencies(data[f"{kind}_tendency"])):
            if tendency in ("settled", "unknown"):
                continue
            names.append(name)
            found.append(order)
            colours.append(COLOURS[tendency])
    places = np.arange(len(names))
    shown = np.clip(np.nan_to_num(found, nan=0.0), -2.0, 5.0)
    axes.barh(places, shown, color=colours, height=0.7)
    for place, order, length in zip(places, found, shown):
        text = "sign changes" if np.isnan(order) else f"{order:.2f}"
        axes.text(max(length, 0.0) + 0.05, place, text, va="center", fontsize=8)
    axes.set_yticks(places, names, fontsize=8)
    axes.invert_yaxis()
    for order in (1, 2):
        axes.axvline(order, color=look.FAINT, linewidth=0.8, linestyle=":")
    axes.set_xlim(min(0.0, shown.min() if len(shown) else 0.0) - 0.1, max(3.0, shown.max() + 0.8 if len(shown) else 3.0))
    axes.set_xlabel("observed order of the three finest levels")
    look.label(axes, 2, "orders, none left out")


def draw(data, folder):
    n = sum(len(data.dimensions[d]) for d in ("number", "field") if d in data.dimensions)
    figure = plt.figure(figsize=(14, max(8.0, 0.2 * n + 3.0)))
    grid = figure.add_gridspec(2, 2, width_ratios=(1.15, 1.0))
    fall(figure.add_subplot(grid[0, 0]), differences(data) if "number" in data.dimensions else [],
         "numbers: relative difference between levels", 0)
    fields = []
    if "field" in data.dimensions and "step" in data.dimensions:
        for name, steps, tendency in zip(data["field_name"][:], filled(data["field_difference_L2"]),
                                         tendencies(data["field_tendency"])):
            if steps[0] > 0.0 and tendency != "settled":
                fields.append((name, steps / steps[0], tendency))
    fall(figure.add_subplot(grid[1, 0]), fields, "fields: L2 of differences over the first", 1)
    right = figure.add_subplot(grid[:, 1])
    orders(right, data)
    handles = [plt.Line2D([], [], color=c, marker="o", label=word) for word, c in COLOURS.items() if word not in ("settled", "unknown")]
    right.legend(handles=handles, loc="lower right")
    figure.suptitle(data.title + "\n" + "\n".join(textwrap.wrap(data.verdict, 150)), fontsize=11)
    return look.save(figure, folder, "study.png")
