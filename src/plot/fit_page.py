"""The page of a fit, from fit.nc alone: slopes, profiles, heap shapes, series, residuals, profile likelihoods and directions."""

import re
import textwrap
from functools import partial

import numpy as np
import xarray as xr

import look
from look import plt


def draw(folder):
    with xr.open_dataset(folder / "fit.nc", decode_times=False) as data:
        data.load()
    panels = [draw_residuals]
    if "curve_Q_kg_s" in data:
        panels.insert(0, draw_slopes)
    if "profile_curve_place" in data:
        panels.insert(1 if len(panels) > 1 else 0, draw_speeds)
    kinds = [str(kind) for kind in dict.fromkeys(data["data_kind"].values[np.isfinite(data["data_time_s"].values)])]
    panels += [draw_shapes if kind.startswith("height") else partial(draw_series, kind=kind) for kind in kinds]
    if "likelihood_name" in data:
        panels.append(draw_likelihoods)
    panels += [draw_directions, draw_table]
    rows = (len(panels) + 1) // 2
    figure, axes = plt.subplots(rows, 2, figsize=(11.7, 3.6 * rows + 0.6), squeeze=False)
    places = list(axes.flat)
    if len(panels) % 2:  # the estimates take the whole last row
        places[-1].remove()
        places[-2].remove()
        places[-2] = figure.add_subplot(rows, 2, (2 * rows - 1, 2 * rows))
    for number, (panel, ax) in enumerate(zip(panels, places)):
        panel(data, ax, number)
    freedom = int(data.attrs["degrees_of_freedom"])
    worth = f", chance of more {data.attrs['chance_of_more']:.2g}" if freedom > 0 else ""
    figure.suptitle(f"{data.attrs['title']}\n{data.attrs['law'].replace('_', ' ')} law, "
                    f"$\\chi^2$ = {data.attrs['chi2']:.3g} with {freedom} degree{'' if freedom == 1 else 's'} of freedom{worth}")
    return [look.save(figure, folder, "fit.png")]


def short(name):
    """A name without the folders of the files in it."""
    return re.sub(r"\S*/", "", str(name))


def is_slope(data):
    return np.array([str(kind).startswith("slope") for kind in data["data_kind"].values])


def draw_slopes(data, axes, number):
    slopes = is_slope(data)
    grams = 1e3
    axes.plot(grams * data["curve_Q_kg_s"], data["curve_zeta_deg"], color=look.BLUE, label="best model")
    if slopes.any():
        axes.errorbar(grams * data["data_Q_kg_s"][slopes], data["data_measured"][slopes], data["data_error"][slopes],
                      fmt="o", color=look.INK, markersize=5, capsize=3, label="measured")
    if "prediction_Q_kg_s" in data:
        axes.errorbar(grams * data["prediction_Q_kg_s"], data["prediction_zeta_deg"], data["prediction_zeta_error_deg"].fillna(0.0),
                      fmt="s", color=look.BLUE, markerfacecolor="white", capsize=5, label="predicted, held back")
        if np.isfinite(data["prediction_measured_deg"]).any():
            axes.plot(grams * data["prediction_Q_kg_s"], data["prediction_measured_deg"], "x", color=look.ACCENT,
                      label="measured there")
    axes.set(xlabel="mass flow [g s$^{-1}$]", ylabel="slope [degree]")
    axes.legend(loc="lower right")
    look.grid(axes)
    look.label(axes, number, "slope against flow")


def draw_speeds(data, axes, number):
    places = list(dict.fromkeys(str(p) for p in data["profile_curve_place"].values))
    of_curve, of_data = data["profile_curve_place"].values.astype(str), data["data_place"].values.astype(str)
    for place, colour in zip(places, look.sequence_colours(len(places))):
        curve, points = of_curve == place, of_data == place
        axes.plot(data["profile_curve_speed_m_s"][curve], 1e3 * data["profile_curve_depth_m"][curve], color=colour)
        axes.errorbar(data["data_measured"][points], 1e3 * data["data_depth_m"][points], xerr=data["data_error"][points],
                      fmt="o", color=colour, markersize=4, label=short(place))
    axes.invert_yaxis()
    axes.set(xlabel="speed [m s$^{-1}$]", ylabel="depth as measured [mm]")
    axes.legend(loc="lower right")
    look.grid(axes)
    look.label(axes, number, "speed against depth")


def draw_shapes(data, axes, number):
    heights = np.array([str(kind).startswith("height") for kind in data["data_kind"].values])
    times = np.unique(data["data_time_s"].values[heights])
    for time, colour in zip(times, look.sequence_colours(times.size)):
        here = heights & (data["data_time_s"].values == time)
        order = np.argsort(data["data_x_m"].values[here])
        x, measured, error, model = (data[f"data_{c}"].values[here][order] * f
                                     for c, f in (("x_m", 1.0), ("measured", 1e3), ("error", 1e3), ("model", 1e3)))
        axes.plot(x, model, color=colour)
        axes.errorbar(x, measured, error, fmt="o", color=colour, markersize=3, linewidth=0.8, label=f"{time:g} s")
    axes.set(xlabel="distance down the base [m]", ylabel="height [mm]", ylim=(0.0, None))
    axes.legend(loc="upper right", fontsize=8)
    look.grid(axes)
    look.label(axes, number, "heap shapes: measured, and best model")


def draw_series(data, axes, number, kind):
    here = data["data_kind"].values.astype(str) == kind
    order = np.argsort(data["data_time_s"].values[here], kind="stable")
    time, measured, error, model = (data[f"data_{c}"].values[here][order] for c in ("time_s", "measured", "error", "model"))
    axes.plot(time, model, color=look.BLUE, label="best model")
    axes.errorbar(time, measured, error, fmt="o", color=look.INK, markersize=3, linewidth=0.8, label="measured")
    name, unit = kind.removesuffix("]").split(" [")
    axes.set(xlabel="time [s]", ylabel=f"{name.replace('_', ' ')} [{unit}]")
    axes.legend(loc="best", fontsize=8)
    look.grid(axes)
    look.label(axes, number, f"{name.replace('_', ' ')} against time")


def draw_residuals(data, axes, number):
    residual = data["data_residual"].values
    kinds = np.array([str(kind).split(" ")[0].replace("_", " ") for kind in data["data_kind"].values])
    order = np.arange(1, residual.size + 1)
    axes.axhspan(-2.0, 2.0, color="#eef3f8")
    axes.axhline(0.0, color=look.FAINT, linewidth=0.8)
    size = 5 if order.size < 60 else 3
    for word, colour in zip(dict.fromkeys(kinds), (look.BLUE, look.ORANGE, look.GREEN, look.PURPLE, look.INK)):
        kind = kinds == word
        axes.vlines(order[kind], 0.0, residual[kind], color=colour, linewidth=1.0)
        axes.plot(order[kind], residual[kind], "o", color=colour, markersize=size, label=word)
    reach = max(3.0, 1.15 * np.abs(residual).max())
    axes.set(xlabel="datum", ylabel="(measured - model)/error", ylim=(-reach, 1.3 * reach))
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.legend(loc="upper right", ncols=2)
    look.label(axes, number, "residuals; shaded: two standard deviations")


def draw_likelihoods(data, axes, number):
    names = data["likelihood_name"].values.astype(str)
    value = dict(zip(data["unknown_name"].values.astype(str), zip(data["unknown_value"].values, data["unknown_error"].values)))
    x = np.linspace(-3.2, 3.2, 100)
    axes.plot(x, x ** 2, color=look.FAINT, linestyle=":", label="normal")
    unique = list(dict.fromkeys(names))
    for name, colour in zip(unique, look.sequence_colours(len(unique))):
        best, error = value[name]
        here = names == name
        axes.plot((data["likelihood_at"].values[here] - best) / error, data["likelihood_rise"].values[here], "o-",
                  color=colour, markersize=3, label=short(name))
    axes.axhline(1.0, color=look.FAINT, linewidth=0.8)
    axes.set(xlabel="(held value - best)/error", ylabel="rise of $\\chi^2$", ylim=(0.0, 10.0), xlim=(-3.2, 3.2))
    axes.legend(loc="upper center", fontsize=8)
    look.label(axes, number, "profile likelihoods")


def draw_directions(data, axes, number):
    seen = data["direction_seen"].values.astype(str) == "yes"
    values = data["direction_singular_value"].values
    floor = 1e-3 * values[seen].min()
    rank = np.arange(values.size)[::-1]
    axes.barh(rank, np.maximum(values, floor), left=0.0, height=0.25, color=[look.BLUE if s else look.ACCENT for s in seen])
    for y, text, is_seen in zip(rank, data["direction_parts"].values.astype(str), seen):
        axes.text(floor, y + 0.2, short(text) + ("" if is_seen else "   not seen by the data"), va="bottom", fontsize=8.5,
                  color=look.INK if is_seen else look.ACCENT)
    axes.set(xscale="log", xlim=(floor, None), ylim=(-0.5, values.size - 0.2), yticks=[],
             xlabel="singular value (1/standard deviation of a relative change)")
    axes.spines["left"].set_visible(False)
    look.label(axes, number, "directions of relative changes")


def of_stages(data, name, unit):
    """What the steady flow alone says of a parameter."""
    here = int(np.flatnonzero(data["stage_name"].values == name)[0])
    value, error = (float(data[f"stage_{c}"].values[here]) for c in ("before", "before_error"))
    if not np.isfinite(value):
        return "by the layer's data only"
    return f"steady flow alone: {value:.5g}{unit}" + (f" $\\pm$ {error:.2g}" if np.isfinite(error) else ", without an error")


def draw_table(data, axes, number):
    axes.axis("off")
    rows = []  # of a name, and a line
    for name, value, error, unit, note in zip(*(data[f"unknown_{c}"].values for c in ("name", "value", "error", "unit", "note"))):
        unit = "" if str(unit) == "1" else f" {unit}"
        text = f"{value:.5g} $\\pm$ {error:.2g}{unit}" if np.isfinite(error) else f"{value:.3g}{unit}: {str(note).split(',')[0]}"
        first, *more = textwrap.wrap(text, 54)
        rows += [(short(name), first), *(("", line) for line in more)]
        if "stage_name" in data:
            rows += [("", line) for line in textwrap.wrap(of_stages(data, name, unit), 54)]
    if "lump_name" in data:
        for name, value, error, unit, formula in zip(*(data[f"lump_{c}"].values for c in ("name", "value", "error", "unit", "formula"))):
            rows.append((str(name), f"{value:.5g} $\\pm$ {error:.2g}" + ("" if str(unit) == "1" else f" {unit}")))
            rows.append(("", f"= {formula}"))
    step = min(0.11, 0.95 / max(len(rows), 1))
    for i, (name, text) in enumerate(rows):
        axes.text(0.0, 0.93 - i * step, name, transform=axes.transAxes, fontsize=9, color=look.BLUE)
        axes.text(0.36, 0.93 - i * step, text, transform=axes.transAxes, fontsize=8.5).set_in_layout(False)
    look.label(axes, number, "estimates")
