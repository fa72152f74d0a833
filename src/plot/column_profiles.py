"""Profiles of a uniform layer through time, beside the exact steady one of the slope and gap at the end."""

import numpy as np

import look
from look import plt

N_PROFILES = 8


def draw(run, folder):
    depth = depths(run)
    outputs = spread(run, N_PROFILES)
    colours = look.sequence_colours(len(outputs))
    figure, panels = plt.subplots(2, 2, figsize=(12.0, 9.0))
    drawn = ((panels[0, 0], "u", "velocity down the slope [m s$^{-1}$]", "velocity", False),
             (panels[0, 1], "speed", "speed [m s$^{-1}$]", "speed, creep included", True),
             (panels[1, 0], "inertial_number", "I [1]", "inertial number", False),
             (panels[1, 1], "viscosity", "viscosity [Pa s]", "viscosity, as regularised", True))
    for number, (axes, name, symbol, words, logarithmic) in enumerate(drawn):
        top = 0.0
        for k, colour in zip(outputs, colours):
            values = run.field(name, k)
            top = max(top, float(np.nanmax(values)))
            line = axes.semilogx if logarithmic else axes.plot
            line(np.where(values > 0.0, values, np.nan) if logarithmic else values, 1e3 * depth, color=colour,
                 label=look.seconds(run.times[k]))
        draw_exact(axes, run, name, logarithmic)
        axes.set(xlabel=symbol, ylabel="depth below the surface [mm]", ylim=(1e3 * thickness(run), 0.0))
        if logarithmic and name == "speed" and top > 0.0:
            axes.set_xlim(1e-6 * top, 2.0 * top)
        look.label(axes, number, words)
        look.grid(axes)
    panels[0, 0].legend(title="time", loc="best")
    figure.suptitle(f"{run.name}: profiles of the layer")
    return [look.save(figure, folder, "profiles.png")]


def depths(run):
    """Of the middles of the layers [m]."""
    return thickness(run) - run.values("z")


def thickness(run):
    return float(run.values("z_interface")[-1])


def spread(run, n):
    """Numbers of at most n outputs: the first, the last, and those between, evenly by number."""
    return sorted(set(np.linspace(0, run.times.size - 1, n).round().astype(int)))


def draw_exact(axes, run, name, logarithmic):
    exact = {"u": "exact_speed", "speed": "exact_speed", "inertial_number": "exact_inertial_number"}.get(name)
    if exact is None or not run.has("exact_depth", exact):
        return
    values = run.values(exact)
    if values.max() < 1e-3 * max(np.nanmax(run.field(name, k)) for k in spread(run, N_PROFILES)):
        return  # at rest beside what went before
    line = axes.semilogx if logarithmic else axes.plot
    line(np.where(values > 0.0, values, np.nan) if logarithmic else values, 1e3 * run.values("exact_depth"),
         color=look.INK, linestyle="-.", label="exact, steady")
