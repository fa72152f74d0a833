"""Surfaces of the heap as it grows and drains, in gravity's coordinates (figures 3 and 12)."""

import numpy as np

import look
import paper
from look import plt


def draw(run, folder):
    growth, drain = run.still_outputs()
    phases = [("growth" if drain or run.inflow_stop or run.attribute("inflow_rate_kg_s", 0.0) else "surface", growth)]
    if drain:
        phases.append(("drain", drain))
    X0, X1, Z0, Z1 = run.extent(growth + drain)
    width = 6.4
    height = max(2.6, width * min(1.0, (Z1 - Z0) / (X1 - X0)) + 0.9)
    figure, panels = plt.subplots(1, len(phases), figsize=(width * len(phases), height), sharey=True, squeeze=False)
    for number, (axes, (phase, outputs)) in enumerate(zip(panels[0], phases)):
        draw_phase(axes, run, outputs)
        axes.set(xlim=(X0, X1), ylim=(Z0, Z1), aspect="equal", xlabel="X, horizontal [m]")
        look.label(axes, number, phase)
        axes.legend(title="time", loc="upper right", labelspacing=0.3)
    panels[0, 0].set_ylabel("Z, up [m]")
    panels[0, 0].text(0.03, 0.04, slope_words(run), transform=panels[0, 0].transAxes, va="bottom", linespacing=1.5)
    figure.suptitle(f"{run.name}: shape of the heap")
    return [look.save(figure, folder, "heap_shapes.png")]


def slope_words(run):
    """The slope of the right face at the end of the inflow, beside the paper's."""
    if not run.has("heap_angle") or run.series_times.size == 0:
        return ""
    t = run.times[run.steady_output]
    angle = run.series("heap_angle")[int(np.argmin(np.abs(run.series_times - t)))]
    if not np.isfinite(angle):
        return ""
    words = f"right face at {look.seconds(t)}: {angle:.2f}°"
    if run.is_paper_scene and t > 0.9 * paper.INFLOW_STOP:
        words += f"\nexact, steady: {paper.SLOPE_EXACT:.2f}°\nprinted in the paper: {paper.SLOPE_PRINTED:.2f}°"
    return words


def draw_phase(axes, run, outputs):
    look.grid(axes)
    axes.plot(*run.base(), color=look.INK, linewidth=2.0)
    for k, colour in zip(outputs, look.sequence_colours(len(outputs))):
        axes.plot(*run.surface(run.field("height", k)), color=colour, label=look.seconds(run.times[k]))
    largest = max((run.field("height", k) for k in outputs), key=np.nanmax)
    axes.fill(*run.outline(largest), color=look.GRAINS, zorder=0, linewidth=0)
