"""A uniform layer in time: speed of the surface, mass flow, how the box moves, and what acts on the layer."""

import numpy as np

import look
from look import plt

FORCES = (("weight", "weight", look.INK), ("wall_friction", "side walls", look.ORANGE),
          ("base_stress", "base", look.GREEN), ("momentum_rate", "rate of momentum", look.BLUE))


def draw(run, folder):
    t = run.series_times
    figure, (speed, flow, box, force) = plt.subplots(4, 1, figsize=(8.2, 11.0), sharex=True,
                                                     height_ratios=[3, 3, 2, 3])
    speed.plot(t, run.series("surface_speed"), color=look.BLUE, label="on the surface")
    speed.plot(t, run.series("mean_speed"), color=look.GREEN, label="mean over the thickness")
    flow.plot(t, 1e3 * run.series("mass_flow"), color=look.BLUE, label="computed")
    if run.has("exact_speed"):
        at_end = "exact, steady, at the slope and gap of the end"
        speed.axhline(run.values("exact_speed")[0], color=look.INK, linestyle="-.", linewidth=1.1, label=at_end)
        flow.axhline(1e3 * float(run.attribute("exact_mass_flow_kg_s")), color=look.INK, linestyle="-.", linewidth=1.1,
                     label=at_end)
    speed.set_ylabel("velocity [m s$^{-1}$]")
    flow.set_ylabel("mass flow [g s$^{-1}$]")

    box.plot(t, run.series("slope"), color=look.PURPLE, label="slope")
    box.set(ylabel="slope [degree]", ylim=padded(run.series("slope")))
    gap = 1e3 * run.series("gap")
    words = f"the box: slope; gap {gap[0]:.3g} mm"
    if np.ptp(gap) > 0.0:
        words = "the box: slope (solid) and gap (dashed)"
        right = box.twinx()
        right.spines["right"].set_visible(True)
        right.plot(t, gap, color=look.ORANGE, linestyle="--")
        right.set(ylabel="gap [mm]", ylim=padded(gap))

    for name, label, colour in FORCES:
        force.plot(t, run.series(name), color=colour, label=label)
    force.set(ylabel="force on a unit area [Pa]", xlabel="time [s]", xlim=(t[0], max(t[-1], t[0] + 1e-9)))
    for number, (axes, title) in enumerate(((speed, "velocity down the slope"), (flow, "mass flow"),
                                            (box, words),
                                            (force, "what acts on the layer, positive down the slope"))):
        look.label(axes, number, title)
        look.grid(axes)
        if axes is not box:
            axes.legend(loc="best")
    figure.suptitle(f"{run.name}: the layer in time")
    return [look.save(figure, folder, "history.png")]


def padded(values):
    """Axis limits around values that may all be alike."""
    pad = max(0.1 * np.ptp(values), 0.02 * np.abs(values).max())
    return values.min() - pad, values.max() + pad
