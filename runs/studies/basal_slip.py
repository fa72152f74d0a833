"""What slip on the base does to the heap of 0.0046 kg/s, Coulomb's and Navier's: first grains on the balance, mass in the box against the
experiment's, and when the last grains leave.

    /usr/bin/python3 runs/studies/basal_slip.py [--talus build/release/talus] [--out out/basal_slip]

Runs what is missing of the heaps below, prints a table and draws basal_slip_coulomb.png and basal_slip_navier.png. The experiment's masses are figure 12's areas at figure 3's
times; 346 s is left out, whose print cannot hold (runs/paper)."""

import argparse
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "runs" / "paper"))

import heap_runs
from figure_12 import EXPERIMENT_MASSES, EXPERIMENT_STOP, EXPERIMENT_TIMES, MISPRINTED
from figure_15 import ARRIVED, NOTHING
from heap_runs import STOP, Heap
from reproduction import look, plt
from talus import DEFAULT_PROGRAM, Talus, settings

COARSE, STANDARD = (60, 16), (150, 16)
SLOW, FAST = 5e-4, 5e-3  # u_c [m/s]


class Base(NamedTuple):
    """How grains meet the base: Coulomb's friction mu_b, Navier's slip length [mm], both, or neither."""
    mu_b: float = None
    slip_mm: float = 0.0

    @property
    def words(self):
        said = [*([f"mu_b = {self.mu_b}"] if self.mu_b else []), *([f"l = {self.slip_mm:g} mm"] if self.slip_mm else [])]
        return ", ".join(said) or "sticks"


STICKS = Base()
# Grid, base, u_c.
COULOMB = [*((COARSE, Base(mu_b), SLOW) for mu_b in (None, 0.5, 0.4, 0.35, 0.3, 0.25, 0.2)), (COARSE, STICKS, FAST), (COARSE, Base(0.3), FAST),
           (STANDARD, STICKS, SLOW), (STANDARD, Base(0.3), SLOW), (STANDARD, Base(0.25), SLOW)]
NAVIER = [(COARSE, STICKS, SLOW), *((COARSE, Base(None, l), SLOW) for l in (0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0)), (COARSE, Base(0.25), SLOW),
          (COARSE, Base(0.25, 1.0), SLOW)]
PARTS = {"coulomb": COULOMB, "navier": NAVIER}
POINTS = [(t, m) for t, m in zip(EXPERIMENT_TIMES, EXPERIMENT_MASSES) if t != MISPRINTED]


def heap(talus, grid, base, u_c):
    sets = [f"grid.columns={grid[0]}", f"grid.layers={grid[1]}", f"wall.u_c={u_c}", *([f"box.base_friction={base.mu_b}"] if base.mu_b else []),
            *([f"box.base_slip_length={1e-3 * base.slip_mm:g}"] if base.slip_mm else [])]
    options = settings(sets)
    name = f"{grid[0]}x{grid[1]}_mu_b_{base.mu_b}_u_c_{u_c:g}" + (f"_l_{base.slip_mm:g}" if base.slip_mm else "")
    return Heap(heap_runs.kept(talus, heap_runs.EXAMPLES / "heap_q46.toml", name, options), "layer")


def mass_at(heap, t):
    """In the box [kg] at a time of the experiment, whose steady state lasts longer."""
    if t > STOP:
        t = max(t - EXPERIMENT_STOP + STOP, STOP - 1.0)
    return heap.mass(t)


def offs(heap):
    """Root mean square differences [g] from the experiment while the heap grows and while it drains."""
    off = [(t, 1e3 * (mass_at(heap, t) - m)) for t, m in POINTS]
    return [float(np.sqrt(np.mean([d * d for t, d in off if (t > EXPERIMENT_STOP) == drains]))) for drains in (False, True)]


def all_out(heap):
    """Seconds from the end of the inflow to that of the grains, in words."""
    t, left = heap.run.series_times, heap.run.series("mass_stored") - heap.film
    gone = (t > STOP) & (left < NOTHING)
    return f"{t[np.argmax(gone)] - STOP:.0f}" if gone.any() else f"after {t[-1] - STOP:.0f}"


def row(heap, grid, base, u_c):
    t, out = heap.run.series_times, heap.run.series("mass_outflow_right")
    arrives = t[np.argmax(out > ARRIVED)]
    masses = " ".join(f"{mass_at(heap, at):.3f}" for at, _ in POINTS)
    growth, drain = offs(heap)
    slope = heap.number("heap_angle", STOP - 0.1)
    return (f"| {grid[0]}x{grid[1]} | {base.words} | {1e3 * u_c:g} | {arrives:.1f} | {slope:.2f} | {masses} | {growth:.1f} | {drain:.1f} | "
            f"{heap.mass(239.0):.3f} | {all_out(heap)} |")


def draw(heaps, folder, name):
    figure, panels = plt.subplots(1, 2, figsize=(12.0, 4.8))
    bases = list(dict.fromkeys(base for _, base, _ in heaps))
    colours = look.sequence_colours(len(bases), "plasma")
    both_laws = any(base.slip_mm for base in bases)
    for (grid, base, u_c), one in heaps.items():
        t, mass = one.run.series_times, one.run.series("mass_stored") - one.film
        style = dict(color=colours[bases.index(base)], linestyle="--" if u_c == FAST else "-." if both_laws and base.mu_b else "-", linewidth=2.4 if grid == STANDARD else 1.2)
        label = f"{base.words}, {grid[0]}x{grid[1]}" + (f", u_c = {1e3 * u_c:g} mm/s" if u_c == FAST else "")
        panels[0].plot(t[t <= STOP], mass[t <= STOP], label=label, **style)
        panels[1].plot(t[t >= STOP] - STOP, mass[t >= STOP], **style)
    for panel, drains, start in ((panels[0], False, 0.0), (panels[1], True, EXPERIMENT_STOP)):
        at = [(t - start, m) for t, m in POINTS if (t > EXPERIMENT_STOP) == drains]
        panel.plot(*zip(*at), "o", color=look.ACCENT, markerfacecolor="white", zorder=5, label="experiment, figure 12's areas read as kg")
        look.grid(panel)
    panels[1].plot(89.0, 0.0, "x", color=look.ACCENT, markersize=9, clip_on=False, zorder=5)
    panels[0].set(xlabel="time [s]", ylabel="mass in the box [kg]", xlim=(0.0, 100.0), ylim=(0.0, 0.2))
    panels[1].set(xlabel="time since the inflow ended [s]", xlim=(0.0, 170.0), ylim=(0.0, 0.2))
    panels[1].legend(*panels[0].get_legend_handles_labels(), fontsize=8, loc="upper right")
    look.label(panels[0], 0, "growth")
    look.label(panels[1], 1, "drain (x: all out)")
    return look.save(figure, folder, name)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--talus", type=Path, default=DEFAULT_PROGRAM)
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "basal_slip")
    parser.add_argument("--of", choices=PARTS, action="append", help="the heaps of one law of slip alone")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    talus = Talus(options.talus, options.out)
    parts = options.of or list(PARTS)
    heaps = {one: heap(talus, *one) for part in parts for one in PARTS[part]}
    times = " ".join(f"{t:g}" for t, _ in POINTS)
    print(f"| grid | base | u_c [mm/s] | first grains [s] | slope at 150 s | mass [kg] at {times} s of the experiment | growth [g] | drain [g] | left after 89 s [kg] | all out after [s] |")
    print("|---|---|---|---|---|---|---|---|---|---|")
    print(f"| experiment | | | about 1 | 49.35 | {' '.join(f'{m:.3f}' for _, m in POINTS)} | | | 0 | 89 |")
    for one, found in heaps.items():
        print(row(found, *one))
    for part in parts:
        print(draw({one: heaps[one] for one in PARTS[part]}, options.out, f"basal_slip_{part}.png"))


if __name__ == "__main__":
    main()
