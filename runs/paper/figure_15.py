"""Figure 15: mass on the balance under the outlet, the computed drain moved to where the experiment's inflow ends; and what the text says
of the event in time."""

from itertools import pairwise

import numpy as np

import heap_runs
import reproduction
from comparison import Row
from figure_12 import EXPERIMENT_MASSES, EXPERIMENT_STOP, EXPERIMENT_TIMES
from heap_runs import STOP
from reproduction import look, plt

RATE = 0.0046            # kg/s
ALL_OUT = 429.5          # s, of the experiment
ARRIVED = 1e-4           # kg, about two hundred grains: the balance has noticed
FACE = (0.3, 0.8)        # of the height of the apex: the straight part of the right face
LEFT_TOE = 0.1           # of the height of the apex
MOVED = 5e-3             # m
STEEPENS = (18.0, 30.8, 56.0, 106.0)  # s
NOTHING = 5e-4           # kg
FILM = "the film of 0.5 mm that stays on the base holds the front, and no grain flies"


def draw(talus, folder):
    heaps = [heap_runs.layer(talus, "heap_q46"), heap_runs.sliding(talus), heap_runs.two_fluid(talus, "heap_q46")]
    figure, axes = plt.subplots(figsize=(9.6, 6.2))
    inset = axes.inset_axes((0.07, 0.6, 0.34, 0.36))
    for heap, colour in zip(heaps, (look.BLUE, look.ORANGE, look.GREEN)):
        t, out = heap.run.series_times, heap.run.series("mass_outflow_right")
        pouring = t <= STOP
        shift = EXPERIMENT_STOP - STOP
        for panel in (axes, inset):
            panel.plot(t[pouring], out[pouring], color=colour, label=heap.label)
        end = float(np.interp(STOP, t, out))
        axes.plot([STOP, EXPERIMENT_STOP], [end, end + RATE * shift], color=colour, linestyle="--")
        axes.plot(t[~pouring] + shift, out[~pouring] + RATE * shift, color=colour)
    axes.plot([], [], color=look.INK, linestyle="--", label="steady state, continued; its drain moved")
    measured = RATE * np.minimum(EXPERIMENT_TIMES, EXPERIMENT_STOP) - EXPERIMENT_MASSES
    for panel in (axes, inset):
        panel.plot(EXPERIMENT_TIMES, measured, "o", color=look.ACCENT, markerfacecolor="white", label="experiment: poured less figure 12's areas")
    axes.axvline(EXPERIMENT_STOP, color=look.FAINT, linestyle=":")
    axes.axvline(ALL_OUT, color=look.ACCENT, linestyle=":", label="experiment: all out")
    axes.set(xlabel="time [s]", ylabel="mass on the balance [kg]", xlim=(0.0, 520.0), ylim=(0.0, 1.7))
    inset.set(xlim=(0.0, 30.0), ylim=(0.0, 0.08))
    inset.tick_params(labelsize=8)
    inset.grid(True, color="#e6e6e6", linewidth=0.7)
    axes.legend(loc="lower right", frameon=True, framealpha=1.0, edgecolor="white", bbox_to_anchor=(1.0, 0.03))
    look.grid(axes)
    return [reproduction.save(figure, folder, "figure_15.png")], [row for heap in heaps for row in rows(heap)]


def rows(heap):
    run, model = heap.run, heap.model
    t, out, rate = run.series_times, run.series("mass_outflow_right"), run.series("outflow_rate_right")
    arrives = float(t[np.argmax(out > ARRIVED)]) if out.max() > ARRIVED else float("nan")
    toe_at, short = toe_arrives(run), 1e3 * (run.x_face[-1] - toe(run, heights_at(run, 18.0)))
    result = [
        Row(f"section 6.2, figure 15, {model}", "first grains on the balance", "about 1 s, experiment", f"{arrives:.1f} s", f"{arrives - 1.0:+.1f} s",
            heap.reason(FILM if slides(heap) else "grains stick to the base; on one of friction 0.25 they come earlier")),
        Row(f"section 6.1, {model}", "break in slope at the toe reaches the outlet", "about 18 s", f"{toe_at:.0f} s; at 18 s {abs(short):.0f} mm {'short of' if short > 0.0 else 'beyond'} it", f"{toe_at - 18.0:+.0f} s",
            heap.reason("the toe is where the straight face, continued, meets the base; a layer of some millimetres runs ahead of it")),
        Row(f"sections 6.1, 6.2, {model}", "steady from 106 s on: outflow over inflow at 106 s", "essentially steady", f"{100.0 * heap.number('outflow_rate_right', 106.0) / RATE:.1f} %",
            *(("holds", "") if heap.number("outflow_rate_right", 106.0) > 0.95 * RATE else ("not yet", heap.reason("as the experiment, it grows more slowly")))),
        Row(f"section 6.1, {model}", "it never is quite: mass in the box from 106 to 150 s", "creeps on, very slowly", f"{heap.mass(106.0):.4f} to {heap.mass(STOP):.4f} kg",
            f"{100.0 * (heap.mass(STOP) / heap.mass(106.0) - 1.0):+.1f} %"),
        Row(f"section 6.1, {model}", "right face at 18, 30.8, 56, 106 s", "steepens progressively", ", ".join(f"{heap.number('heap_angle', t):.1f}" for t in STEEPENS) + " deg",
            *(("holds", "") if all(a < b for a, b in pairwise(heap.number("heap_angle", t) for t in STEEPENS)) else ("differs", heap.reason("")))),
        Row(f"section 6.1, {model}", "slopes of the left and the right face at 12.4 s", "approximately the same", *both_faces(heap, 12.4)),
        Row(f"section 6.1, {model}", "slope of the right face, 106 to 150 s", "constant, about 50 deg",
            f"{heap.number('heap_angle', 106.0):.2f} to {heap.number('heap_angle', STOP - 0.1):.2f} deg", f"{heap.number('heap_angle', STOP - 0.1) - 50.0:+.1f}",
            heap.reason("48.81 is exact for the printed parameters, 47.99 printed as the fit")),
        Row(f"section 6.2, figure 15, {model}", "grains on the balance at 30 s", "experiment above computation", f"{heap.number('mass_outflow_right', 30.0):.3f} kg; experiment at 20, 43 s "
            f"{measured(20.0):.3f}, {measured(43.0):.3f}", "holds" if heap.number("mass_outflow_right", 20.0) < measured(20.0) else "differs"),
    ]
    if t[-1] > STOP + 10.0:
        result += drain_rows(heap)
    return result


def left_over(heap, where, what, printed, t, reason):
    if t > heap.run.times[-1]:
        return Row(where, what, printed, "not run so far", "")
    left = heap.mass(t)
    return Row(where, what, printed, f"{left:.3f} kg", *(("holds", "") if left < NOTHING else ("slower", heap.reason(reason))))


def slides(heap):
    return "base_friction" in heap.run.scene.get("box", {})


def measured(t):
    """On the experiment's balance, from figure 12's areas [kg]."""
    return RATE * t - EXPERIMENT_MASSES[EXPERIMENT_TIMES.index(t)]


def drain_rows(heap):
    run, model, end = heap.run, heap.model, heap.run.times[-1]
    left = left_base_moves(run)
    after = ALL_OUT - EXPERIMENT_STOP
    result = [
        Row(f"section 6.1, {model}", "after shut-off, 154 s: slope 50, 100, 300 mm below the apex", "parallel to the base (29.2 deg), then a break to a steeper part",
            ", ".join(f"{slope_below(run, 154.0, x):.1f}" for x in (0.05, 0.1, 0.3)) + " deg", "a bend, no break",
            heap.reason("as in the experiment the upper part is steeper than the base; the slope falls off smoothly")),
        Row(f"section 6.1, {model}", "the left base of the pile begins to move down", "by 290 s", f"{left:.0f} s" if np.isfinite(left) else
            "not before all was out" if heap.mass(end) < NOTHING else f"not by {end:.0f} s", "" if np.isfinite(left) else "differs",
            heap.reason("moved means by 5 mm")),
        left_over(heap, f"section 6.1, {model}", "mass left at 320 s", "0: all drained", 320.0, "the late drain follows u_c, and basal slip (runs/studies)"),
        left_over(heap, f"sections 2, 6.2, {model}", f"mass left {after:g} s after the inflow ended", "0, experiment", STOP + after,
                  "so is the paper's computation, for want of basal slip"),
    ]
    return result


def heights_at(run, t):
    return run.series("height_series")[int(np.argmin(np.abs(run.series_times - t)))]


def toe(run, height):
    """Where the straight part of the right face, continued, meets the base [m]."""
    apex = int(np.argmax(height))
    face = (np.arange(height.size) > apex) & (height > FACE[0] * height[apex]) & (height < FACE[1] * height[apex])
    if height[apex] < 20.0 * run.film or face.sum() < 4:
        return float("nan")
    slope, level = np.polyfit(run.x[face], height[face], 1)
    return -level / slope


def both_faces(heap, t):
    """Slopes of the straight parts of both faces against the horizontal, by how much the right one is steeper, and why, in words."""
    run, height = heap.run, heights_at(heap.run, t)
    apex = int(np.argmax(height))
    straight = (height > FACE[0] * height[apex]) & (height < FACE[1] * height[apex])
    slopes = []
    for side, sign in ((np.arange(height.size) < apex, 1.0), (np.arange(height.size) > apex, -1.0)):
        if (straight & side).sum() < 2:
            return "too few cells", "", ""
        slopes.append(np.degrees(np.arctan(sign * np.polyfit(run.x[straight & side], height[straight & side], 1)[0])) - sign * run.tilt)
    return ", ".join(f"{slope:.1f}" for slope in slopes) + " deg", f"{slopes[1] - slopes[0]:+.1f}", heap.reason("the right face carries more of the flow, and is steeper for it")


def toe_arrives(run):
    """When the toe reaches the outlet [s]."""
    toes = np.array([toe(run, height) for height in run.series("height_series")])
    return float(run.series_times[np.argmax(toes >= run.x_face[-1])]) if np.nanmax(toes) >= run.x_face[-1] else float("nan")


def slope_below(run, t, distance):
    """Slope of the surface [degree] at a distance [m] along the base below the apex."""
    height = heights_at(run, t)
    at = run.x[int(np.argmax(height))] + distance
    return float(run.tilt - np.degrees(np.arctan(np.interp(at, run.x, np.gradient(height, run.x)))))


def left_base_moves(run):
    """When the left toe has left its place at the end of the inflow by MOVED [s]."""
    heights = run.series("height_series")
    toe = np.array([run.x[np.argmax(height > LEFT_TOE * height.max())] for height in heights])
    start = toe[int(np.argmin(np.abs(run.series_times - STOP)))]
    late = (run.series_times > STOP) & (toe > start + MOVED)
    return float(run.series_times[np.argmax(late)]) if late.any() else float("nan")


def costs(talus):
    return [heap.cost for heap in (*heap_runs.both(talus, "heap_q46"), heap_runs.sliding(talus))]


if __name__ == "__main__":
    reproduction.main(draw)
