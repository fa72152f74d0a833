"""Slopes of many draft heaps over mass flow, wall friction, gap and diameter, against the exact ones, and where the model is ill-posed.

Runs the sweep heap_slopes.toml (members that are finished in the folder are not run again), gathers it into sweep.nc, draws heap_slopes.png
there and prints what came out as a table.
"""

import argparse
import itertools
import json
import re
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

import netCDF4
import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path += [str(ROOT / "src" / "plot"), str(ROOT / "runs" / "paper")]
import look  # noqa: E402
from look import plt  # noqa: E402
from talus import DEFAULT_PROGRAM, Talus, listed  # noqa: E402

AXES = {"Q": "inflow_rate", "mu_w": "wall_mu_w", "W": "box_gap", "d": "grains_d"}   # in this order, the dimensions of every array
N_AT_ONCE = 2
FINISHED = 4          # of the variable status
SMOOTHEST = 0.2       # surface_roughness up to which a face is taken for straight
LAST = 100.0          # s, in which a steady face may not turn any more


@dataclass
class Heaps:
    """The sweep, NaN where a member has no such number; shape of all: Q, mu_w, W, d."""
    axes: dict               # of AXES: values in SI units
    member: np.ndarray
    status: np.ndarray
    angle: np.ndarray        # degree
    roughness: np.ndarray
    ill_posed: np.ndarray    # share of the flowing area with C > 0
    growing: np.ndarray      # share in which short waves grow
    apex: np.ndarray         # m
    turned: np.ndarray       # degree, range of the angle over the LAST seconds
    cpu: np.ndarray          # s

    @property
    def smooth(self):
        return self.roughness <= SMOOTHEST


@dataclass
class Exact:
    """The exact steady flow of each member; same shape."""
    angle: np.ndarray        # degree, for u_c -> 0; NaN where there is none
    own: np.ndarray          # degree, with the scene's u_c and regularisations
    C: np.ndarray            # at the surface, (3.18)
    q: np.ndarray            # mu - I mu'/2 at the surface


def run(talus, sweep, folder, jobs):
    """Runs what is not finished; failed members are no reason to end. Returns the wall time [s]."""
    began = time.monotonic()
    command = [talus.program, "sweep", sweep, "--out", folder, *(["--jobs", str(jobs)] if jobs else [])]
    done = subprocess.run(command, check=False, stdout=sys.stderr)
    if done.returncode not in (0, 9):
        sys.exit(done.returncode)
    return time.monotonic() - began


def read(folder):
    with netCDF4.Dataset(folder / "sweep.nc") as sweep:
        order = list(AXES.values())

        def array(name):
            variable = sweep[name]
            moved = [variable.dimensions.index(axis) for axis in order] + list(range(len(order), variable.ndim))
            return np.ma.filled(variable[:].astype(float), np.nan).transpose(moved)

        late = sweep["series_time"][:].filled() >= sweep["series_time"][-1] - LAST
        return Heaps({short: sweep[name][:].filled() for short, name in AXES.items()}, array("member").astype(int), array("status"),
                     array("final_heap_angle"), array("final_surface_roughness"), array("final_ill_posed_share"),
                     array("final_growing_share"), array("final_apex_z"), np.ptp(array("series_heap_angle")[..., late], axis=-1),
                     array("cpu_seconds"))


def exact_flows(talus, folder, heaps):
    shape = heaps.member.shape
    exact = Exact(*(np.full(shape, np.nan) for _ in range(4)))

    def scene(member):
        return folder / "scenes" / f"{member:04d}.toml"

    def for_all_flows(place):
        cases = json.loads(talus.call("steady", scene(heaps.member[(0, *place)]), "--json", "--Q", listed(heaps.axes["Q"])))["cases"]
        for i, case in enumerate(cases):
            if case["exists"]:
                exact.angle[(i, *place)], exact.C[(i, *place)], exact.q[(i, *place)] = (
                    case[key] for key in ("zeta_deg", "surface_C", "surface_q"))

    def for_own_numerics(place):
        found = re.search(r"slope ([0-9.]+) degrees with this scene's", talus.call("check", scene(heaps.member[place])))
        exact.own[place] = float(found[1]) if found else np.nan

    with ThreadPoolExecutor(N_AT_ONCE) as pool:
        list(pool.map(for_all_flows, itertools.product(*map(range, shape[1:]))))
        list(pool.map(for_own_numerics, itertools.product(*map(range, shape))))
    return exact


def draw(heaps, exact, path):
    """For each diameter a row of slopes and a row of ill-posed shares; a column for each wall friction."""
    n_mu, n_d = len(heaps.axes["mu_w"]), len(heaps.axes["d"])
    figure, (blank, *panels) = plt.subplots(2 * n_d + 1, n_mu, figsize=(2.6 * n_mu + 1.6, 4.8 * n_d + 1.2), squeeze=False, sharex=True,
                                            sharey="row", gridspec_kw={"height_ratios": [0.3] + n_d * [1.2] + n_d * [0.8]})
    panels = np.array(panels)
    for axes in blank:   # room for the legend
        axes.set_axis_off()
    map_of_shares = None
    for k, j in itertools.product(range(n_d), range(n_mu)):
        slopes, shares = panels[k, j], panels[n_d + k, j]
        draw_slopes(slopes, heaps, exact, j, k)
        map_of_shares = draw_shares(shares, heaps, exact, j, k)
        words = f"d = {1e3 * heaps.axes['d'][k]:g} mm"
        if k == 0:
            slopes.set_title(f"$\\mu_w$ = {heaps.axes['mu_w'][j]:.4g}")
        if j == 0:
            slopes.set_ylabel(f"{words}\nslope [degree]")
            shares.set_ylabel(f"{words}\ngap W [mm]")
        if k == n_d - 1:
            shares.set_xlabel("mass flow Q [g/s]")
    draw_legend(figure, heaps)
    bar = figure.colorbar(map_of_shares, ax=panels[n_d:, :], aspect=30, pad=0.01)
    bar.set_label("ill-posed share of the flowing area (C > 0) [%]")
    figure.savefig(path, dpi=90)
    plt.close(figure)


def draw_slopes(axes, heaps, exact, j, k):
    Q = 1e3 * heaps.axes["Q"]
    for i, colour in enumerate(gap_colours(heaps)):
        axes.plot(Q, exact.angle[:, j, i, k], color=colour, linewidth=1.3)
        angle, smooth = heaps.angle[:, j, i, k], heaps.smooth[:, j, i, k]
        inside = heaps.ill_posed[:, j, i, k] == 0.0
        axes.plot(Q[smooth & inside], angle[smooth & inside], "o", color=colour, markersize=4.5)
        axes.plot(Q[smooth & ~inside], angle[smooth & ~inside], "o", color=colour, markersize=4.5, markerfacecolor="white")
        axes.plot(Q[~smooth], angle[~smooth], "x", color=colour, markersize=5.5, markeredgewidth=1.6)
    look.grid(axes)
    log_flow(axes, Q)


def draw_shares(axes, heaps, exact, j, k):
    Q, W = 1e3 * heaps.axes["Q"], 1e3 * heaps.axes["W"]
    largest = max(100.0 * np.nanmax(heaps.ill_posed), 1.0)
    share = 100.0 * np.where(heaps.ill_posed[:, j, :, k] > 0.0, heaps.ill_posed[:, j, :, k], np.nan)
    axes.set_facecolor("#eef1f4")
    image = axes.pcolormesh(edges(Q, np.log, np.exp), edges(W, np.asarray, np.asarray), share.T, cmap="YlOrRd", vmin=0.0, vmax=largest)
    C = exact.C[:, j, :, k]
    if np.nanmin(C) < 0.0 < np.nanmax(C):
        axes.contour(Q, W, C.T, levels=[0.0], colors=look.INK, linewidths=1.6)
    for marker, places in ((".", heaps.growing[:, j, :, k] > 0.0), ("x", ~heaps.smooth[:, j, :, k])):
        flows, gaps = np.nonzero(places)
        axes.plot(Q[flows], W[gaps], marker, color=look.INK, markersize=8 if marker == "." else 4, linestyle="none")
    log_flow(axes, Q)
    axes.set_yticks(W)
    return image


def draw_legend(figure, heaps):
    def sample(words, **style):
        return plt.Line2D([], [], label=words, **{"color": "#555555", "linestyle": "none", "markersize": 5, **style})

    handles = [sample(f"W = {1e3 * W:.3g} mm", color=colour, linestyle="-", linewidth=2.5)
               for W, colour in zip(heaps.axes["W"], gap_colours(heaps))]
    handles += [sample("exact, for $u_c \\to 0$", linestyle="-"), sample("run, well-posed everywhere", marker="o"),
                sample("run, in part ill-posed", marker="o", markerfacecolor="white"),
                sample("run, face not smooth: grid too coarse", marker="x", markeredgewidth=1.6),
                sample("exact: C = 0 at the surface", linestyle="-", color=look.INK, linewidth=1.6),
                sample("short waves grow", marker=".", color=look.INK, markersize=8)]
    figure.legend(handles=handles, loc="upper center", ncols=4, fontsize=9)


def gap_colours(heaps):
    return look.sequence_colours(len(heaps.axes["W"]))


def log_flow(axes, Q):
    axes.set_xscale("log")
    ticks = [q for q in (0.5, 1, 2, 4, 8, 16) if Q[0] * 0.99 <= q <= Q[-1] * 1.01]
    axes.set_xticks(ticks, [f"{q:g}" for q in ticks])
    axes.minorticks_off()


def edges(middles, there, back):
    """Borders of cells around points that are evenly spaced in the measure `there`."""
    x = there(middles)
    step = np.diff(x) if len(x) > 1 else np.array([0.1])
    return back(np.concatenate([[x[0] - step[0] / 2], x[:-1] + step[: len(x) - 1] / 2, [x[-1] + step[-1] / 2]]))


def report(heaps, exact, wall):
    finished = (heaps.status == FINISHED) & np.isfinite(heaps.angle)
    beyond = exact.C > 0.0
    rows = [("members finished with a heap", f"{finished.sum()} of {finished.size}"),
            ("members with a steady heap by the exact solution", f"{np.isfinite(exact.angle).sum()}"),
            ("CPU time, sum and longest [s]", f"{np.nansum(heaps.cpu):.0f}, {np.nanmax(heaps.cpu):.1f}"),
            ("wall time of this call [s]", f"{wall:.0f}"),
            (f"largest turn of a face over the last {LAST:g} s [degree]", f"{np.nanmax(heaps.turned):.1e}"),
            ("highest heap [m]", f"{np.nanmax(heaps.apex):.3f}"),
            ("faces not smooth", f"{(finished & ~heaps.smooth).sum()}"),
            ("in part ill-posed: runs, exact surfaces, both", f"{(heaps.ill_posed > 0).sum()}, {beyond.sum()}, "
             f"{((heaps.ill_posed > 0) & beyond).sum()}"),
            ("largest ill-posed share [%]", f"{100.0 * np.nanmax(heaps.ill_posed):.1f}"),
            ("short waves grow: runs, exact surfaces, both",
             f"{(heaps.growing > 0).sum()}, {(exact.q > 1.0).sum()}, {((heaps.growing > 0) & (exact.q > 1.0)).sum()}")]
    for whose, slope in (("exact slope", exact.angle), ("slope with the scenes' u_c and regularisations", exact.own)):
        error = heaps.angle - slope
        for words, chosen in (("all", finished), ("smooth faces", finished & heaps.smooth),
                              ("smooth, well-posed", finished & heaps.smooth & (heaps.ill_posed == 0.0))):
            rows.append((f"error against the {whose}, {words} ({chosen.sum()}): median, lowest, highest [degree]",
                         words_of(error[chosen])))
        rows.append(("where: lowest, highest of all", "; ".join(parameters_of(heaps, find(error)) for find in (np.nanargmin, np.nanargmax))))
    print("| what | figure |\n|---|---|")
    for what, figure in rows:
        print(f"| {what} | {figure} |")


def words_of(error):
    error = error[np.isfinite(error)]
    return f"{np.median(error):+.2f}, {error.min():+.2f}, {error.max():+.2f}" if error.size else "none"


def parameters_of(heaps, place):
    Q, mu_w, W, d = (values[i] for values, i in zip(heaps.axes.values(), np.unravel_index(place, heaps.member.shape)))
    return f"Q = {1e3 * Q:.3g} g/s, mu_w = {mu_w:g}, W = {1e3 * W:g} mm, d = {1e3 * d:g} mm"


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--talus", type=Path, default=DEFAULT_PROGRAM, help="the program (default: build/release/talus)")
    arguments.add_argument("--sweep", type=Path, default=HERE / "heap_slopes.toml", help="a sweep over the same four axes")
    arguments.add_argument("--out", type=Path, default=ROOT / "out" / "heap_slopes", help="folder of the sweep")
    arguments.add_argument("--jobs", type=int, help="members at a time (default: one on each core)")
    options = arguments.parse_args()
    talus = Talus(options.talus, options.out)
    wall = run(talus, options.sweep, options.out, options.jobs)
    talus.call("collect", options.out, "--series", "heap_angle")
    heaps = read(options.out)
    exact = exact_flows(talus, options.out, heaps)
    draw(heaps, exact, options.out / "heap_slopes.png")
    report(heaps, exact, wall)


if __name__ == "__main__":
    main()
