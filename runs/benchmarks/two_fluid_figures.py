"""The heap by two fluids beside the layer model, the exact flow and the paper's numbers (figures 12 to 19), from stored runs.

    /usr/bin/python3 runs/benchmarks/two_fluid_figures.py --pair out/two_fluid_heap out/heap_q46 [--pair TWO_FLUID LAYER ...]
        [--no-walls TWO_FLUID LAYER] [--talus build/release/talus] [--out out/two_fluid_figures]

The first pair is drawn at all times; the others, of other inflows, by their shapes at the end of the inflow.
"""

import argparse
import sys
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src" / "plot"), str(ROOT / "runs" / "paper")]
import look  # noqa: E402
import paper  # noqa: E402
from layer_profiles import Exact, Slice  # noqa: E402
from look import plt  # noqa: E402
from matplotlib.colors import LogNorm  # noqa: E402
from run_data import Run  # noqa: E402
from talus import DEFAULT_PROGRAM, Talus  # noqa: E402

FIELD_TIMES = (7.2, 30.8, 150.0, 174.4)   # s, of figures 12 to 14
PROFILE_AT = (0.4, 0.55, 0.7)             # of the way from the apex to the end of the base
DEPTH = 0.03                              # m, of profiles
LINES = (("two fluids", "-"), ("layer", "--"))


def main():
    options = arguments()
    options.out.mkdir(parents=True, exist_ok=True)
    pairs = [tuple(Run(folder) for folder in pair) for pair in options.pair]
    paths = [draw_fields(*pairs[0], options.out), draw_growth(*pairs[0], options.out), draw_mass(*pairs[0], options.out),
             draw_shapes(pairs, options.no_walls and tuple(Run(folder) for folder in options.no_walls),
                         Talus(options.talus, options.out), options.out),
             draw_profiles(*pairs[0], options.out)]
    print("\n".join(map(str, paths)))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pair", nargs=2, action="append", required=True, metavar=("TWO_FLUID", "LAYER"), help="folders of finished runs")
    parser.add_argument("--no-walls", nargs=2, metavar=("TWO_FLUID", "LAYER"), help="the same without friction of the side walls")
    parser.add_argument("--talus", type=Path, default=DEFAULT_PROGRAM, help="the program, for exact slopes")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "two_fluid_figures")
    return parser.parse_args()


def reached(run, times):
    return [t for t in times if t <= run.times[-1] + 0.5]


def draw_fields(two, layer, folder):
    """Speeds at the paper's times: the mixture with its surface where phi is one half, and the layer."""
    times = reached(two, FIELD_TIMES)
    figure, panels = plt.subplots(len(times), 2, figsize=(11.0, 3.1 * len(times)), sharex=True, sharey=True, squeeze=False)
    norm = LogNorm(1e-4, 1.0)
    for row, t in zip(panels, times):
        for axes, run, (name, _) in zip(row, (two, layer), LINES):
            k = run.nearest(t)
            X, Z = run.nodes(k)
            mesh = axes.pcolormesh(X, Z, np.ma.masked_invalid(run.field("speed", k)), norm=norm, cmap="viridis", rasterized=True)
            if run.has("phi"):
                corners = run.field("z", k)
                axes.contour(*run.to_gravity(np.broadcast_to(run.x, corners.shape), corners), np.nan_to_num(run.field("phi", k)), [0.5],
                             colors="white", linewidths=1.2)
            axes.plot(*run.base(), color=look.INK, linewidth=2.0)
            axes.set(aspect="equal")
            axes.set_title(f"{name}, {look.seconds(run.times[k])}", loc="left")
        row[0].set_ylabel("Z, up [m]")
    for axes in panels[-1]:
        axes.set_xlabel("X, horizontal [m]")
    figure.colorbar(mesh, ax=panels, label="speed [m s$^{-1}$]", shrink=0.6, extend="both")
    figure.suptitle("Speed of grains and air (white: grains fill half), and of the layer")
    return look.save(figure, folder, "fields.png")


def draw_growth(two, layer, folder):
    """Surfaces of both models as the heap grows and drains (figure 12)."""
    phases = [("growth", reached(two, paper.GROWTH_TIMES)), ("drain", reached(two, paper.DRAIN_TIMES[1:]))]
    phases = [phase for phase in phases if phase[1]]
    figure, panels = plt.subplots(1, len(phases), figsize=(6.4 * len(phases), 5.2), sharey=True, squeeze=False)
    for number, (axes, (phase, times)) in enumerate(zip(panels[0], phases)):
        look.grid(axes)
        axes.plot(*two.base(), color=look.INK, linewidth=2.0)
        for t, colour in zip(times, look.sequence_colours(len(times))):
            for run, (_, style) in zip((two, layer), LINES):
                axes.plot(*run.surface(run.field("height", run.nearest(t))), style, color=colour, linewidth=1.3)
            axes.plot([], [], color=colour, label=look.seconds(t))
        axes.set(aspect="equal", xlabel="X, horizontal [m]")
        axes.legend(title="time", loc="upper right", labelspacing=0.3)
        look.label(axes, number, phase)
    panels[0, 0].set_ylabel("Z, up [m]")
    figure.suptitle("Shape of the heap: two fluids (solid), layer (dashed)")
    return look.save(figure, folder, "growth.png")


def draw_mass(two, layer, folder):
    """Mass in the box (figure 15); grains in the air apart."""
    figure, axes = plt.subplots(figsize=(7.5, 4.6))
    look.grid(axes)
    for run, (name, style), colour in zip((two, layer), LINES, (look.BLUE, look.ORANGE)):
        mass = run.series("mass_stored")
        axes.plot(run.series_times, mass - mass[0], style, color=colour, label=name)  # the layer starts with a film
    axes.plot(two.series_times, two.series("mass_stored") - two.series("mass_airborne"), ":", color=look.BLUE,
              label="two fluids, in cells filled half or more")
    shown = [k for k, t in enumerate(paper.MASS_TIMES) if t <= two.series_times[-1] + 0.5]
    axes.plot(np.array(paper.MASS_TIMES)[shown], np.array(paper.MASSES)[shown], "o", color=look.ACCENT, label="paper, figure 12 read as kg")
    axes.set(xlabel="t [s]", ylabel="mass in the box [kg]", xlim=(0.0, two.series_times[-1]), ylim=(0.0, None))
    axes.legend()
    figure.suptitle("Mass in the box")
    return look.save(figure, folder, "mass.png")


def steady_slope(run):
    angles = run.series("heap_angle")
    return angles[int(np.argmin(np.abs(run.series_times - run.times[run.steady_output])))]


def draw_shapes(pairs, no_walls, program, folder):
    """Surfaces at the end of the inflow (figure 16) with the exact slope through the layer's toe, and without walls (figure 19)."""
    all_pairs = [*pairs, *([no_walls] if no_walls else [])]
    figure, panels = plt.subplots(1, len(all_pairs), figsize=(5.0 * len(all_pairs), 5.4), sharey=True, squeeze=False)
    panels[0, 0].set_ylim(-0.02, 0.5)
    for number, (axes, pair) in enumerate(zip(panels[0], all_pairs)):
        look.grid(axes)
        axes.plot(*pair[0].base(), color=look.INK, linewidth=2.0)
        words = []
        for run, (name, style), colour in zip(pair, LINES, (look.BLUE, look.ORANGE)):
            k = run.steady_output
            axes.plot(*run.surface(run.field("height", k)), style, color=colour, label=name)
            words.append(f"{name}: {steady_slope(run):.2f}° at {look.seconds(run.times[k])}")
        Q = float(pair[0].attribute("inflow_rate_kg_s"))
        if pair is not no_walls:
            exact = program.steady("table_2.toml", Q=[Q]).flows[0].zeta
            X, Z = (line[1] for line in pair[0].base())
            reach = 0.42
            axes.plot([X - reach, X], [Z + reach * np.tan(np.radians(exact)), Z], ":", color=look.ACCENT, label="exact slope")
            words.append(f"exact: {exact:.2f}°")
        axes.text(0.03, 0.04, "\n".join(words), transform=axes.transAxes, va="bottom", fontsize=9)
        axes.set(aspect="equal", xlabel="X, horizontal [m]")
        look.label(axes, number, f"{1e3 * Q:.1f} g/s" + (", no wall friction" if pair is no_walls else ""))
    panels[0, 0].set_ylabel("Z, up [m]")
    panels[0, 0].legend(loc="upper right")
    figure.suptitle("Shape when the inflow ends")
    return look.save(figure, folder, "shapes.png")


def draw_profiles(two, layer, folder):
    """Speed and I along normals of the face at the end of the inflow (figures 17, 18), beside the exact flow."""
    figure, panels = plt.subplots(1, 2, figsize=(12.0, 5.2))
    exact = Exact(layer)
    if exact.known:
        for axes, values in zip(panels, (exact.speed, exact.inertial_number)):
            axes.plot(values, -1e3 * exact.depth, color=look.INK, linewidth=2.0, label="exact")
    depth = np.linspace(0.0, DEPTH, 200)
    for run, (name, style) in zip((two, layer), LINES):
        k = run.steady_output
        height = run.field("height", k)
        apex = run.x[int(np.argmax(height))]
        for share, colour in zip(PROFILE_AT, look.sequence_colours(len(PROFILE_AT), "plasma")):
            here = Slice(run, k, height, apex + share * (run.x_face[-1] - apex), depth)
            for axes, field in zip(panels, ("speed", "inertial_number")):
                axes.plot(here.values(run.field(field, k)), -1e3 * depth, style, color=colour, linewidth=1.3,
                          label=f"{name}, x = {here.x:.2f} m" if axes is panels[0] else None)
    panels[0].set(xlabel="speed [m s$^{-1}$]", ylabel="distance from the surface [mm]", xlim=(0.0, None))
    panels[1].set(xlabel="inertial number", xscale="log", xlim=(1e-4, 3.0))
    for axes in panels:
        look.grid(axes)
        axes.set_ylim(-1e3 * DEPTH, 0.0)
    panels[0].legend(fontsize=9)
    figure.suptitle(f"Face at t = {look.seconds(two.times[two.steady_output])}")
    return look.save(figure, folder, "profiles.png")


if __name__ == "__main__":
    main()
