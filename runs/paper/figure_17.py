"""Figures 17 and 18: profiles of speed normal to the face, along one heap, and for the three inflows beside the exact ones."""

from itertools import pairwise

import numpy as np

import heap_runs
import layer_profiles
import reproduction
from comparison import Row
from figure_9 import COLOURS
from layer_profiles import Exact, Slice
from reproduction import look, plt

N_POINTS = 240
DEPTH = 9e-3   # m, normal to the face
FEW = 0.1      # volume fraction below which a cell's speed is the air's


def draw(talus, folder):
    heaps = {Q: heap_runs.both(talus, scene) for scene, Q in heap_runs.INFLOWS.items()}
    path, new = draw_18(heaps, folder)
    rows = [row for heap in heaps[0.0046] for row in (superposition(heap), inertial_number(heap))]
    return [draw_17(heaps[0.0046], folder), path], rows + new


def slices_of(run, k):
    height = run.field("height", k)
    s = np.linspace(0.0, DEPTH, N_POINTS)
    return [Slice(run, k, height, x, s) for x in layer_profiles.slice_positions(run, k, height)]


def along_face(run, k, name):
    """A field for slices: where the two-fluid model has air, that of the uppermost cell below in which there are grains."""
    field = run.field(name, k)
    if run.has("phi"):
        field[run.field("phi", k) < FEW] = np.nan
        for below, row in pairwise(field):
            np.copyto(row, below, where=np.isnan(row))
    return field


def speeds(run):
    """Slices of the steady output, and the speed along each."""
    k = run.steady_output
    field = along_face(run, k, "speed")
    slices = slices_of(run, k)
    return slices, [cut.values(field, to_surface=True) for cut in slices]


def draw_17(heaps, folder):
    """A row a model."""
    figure, panels = plt.subplots(len(heaps), 2, figsize=(12.0, 5.0 * len(heaps)), squeeze=False)
    for number, (heap, (profiles, where)) in enumerate(zip(heaps, panels)):
        run = heap.run
        slices, along = speeds(run)
        colours = look.sequence_colours(len(slices), "plasma")
        for cut, u, colour in zip(slices, along, colours):
            profiles.plot(u, -1e3 * cut.s, color=colour, label=f"x = {cut.x:.3f} m")
        layer_profiles.draw_map(where, run, run.steady_output, slices, colours)
        profiles.set(xlabel="|u| [m s$^{-1}$]", ylabel="z, normal to the face [mm]", ylim=(-1e3 * DEPTH, 0.0), xlim=(0.0, 0.42))
        profiles.legend(loc="lower right")
        look.grid(profiles)
        look.label(profiles, 2 * number, f"{heap.label}: speed at t = {look.seconds(run.times[run.steady_output])}")
        look.label(where, 2 * number + 1, "where")
    return reproduction.save(figure, folder, "figure_17.png")


def draw_18(heaps, folder):
    figure, panels = plt.subplots(1, 3, figsize=(13.0, 4.8), sharey=True)
    rows = []
    for number, (axes, (Q, models)) in enumerate(zip(panels, heaps.items())):
        for heap, style in zip(models, ("-", "--")):
            slices, along = speeds(heap.run)
            mean = np.nanmean(along, axis=0)
            axes.plot(mean, -1e3 * slices[0].s, color=COLOURS[Q], linestyle=style, label=f"computed, {heap.label}")
            rows.append(against_exact(heap, Q, slices[0].s, mean))
        exact = Exact(models[0].run)
        if exact.known:
            axes.plot(exact.speed, -1e3 * exact.depth, color=look.INK, linestyle="-.", label="exact, steady, uniform")
        axes.set(xlabel="|u| [m s$^{-1}$]", ylim=(-1e3 * DEPTH, 0.0), xlim=(0.0, 0.5))
        axes.legend(loc="lower right")
        look.grid(axes)
        look.label(axes, number, f"{1e3 * Q:.1f} g/s")
    panels[0].set_ylabel("z, normal to the face [mm]")
    return reproduction.save(figure, folder, "figure_18.png"), rows


def against_exact(heap, Q, s, mean):
    exact = Exact(heap.run)
    where, what = f"section 6.3, figure 18, {heap.model}", f"computed speeds against the exact ones, {1e3 * Q:.1f} g/s"
    if not exact.known:
        return Row(where, what, "very close", "no exact flow known", "")
    inside = (s <= exact.depth[-1]) & np.isfinite(mean)
    wanted = np.interp(s[inside], exact.depth, exact.speed)
    off = np.sqrt(np.sum((mean[inside] - wanted) ** 2) / np.sum(wanted ** 2))
    return Row(where, what, "very close but for a blunter top", f"{100.0 * off:.1f} % (L2); surface {mean[0]:.3f}, exact {exact.speed[0]:.3f} m/s", "",
               heap.reason("the layer has no mixed cells at its surface, so no blunter top"))


def superposition(heap):
    """How far the profiles of several places lie from their mean, over the mean's surface speed."""
    _, along = speeds(heap.run)
    spread = np.nanmax(np.abs(along - np.nanmean(along, axis=0))) / np.nanmean(along, axis=0)[0]
    return Row(f"section 6.3, figure 17, {heap.model}", "profiles down the face against their mean", "almost exactly superimposed", f"within {100.0 * spread:.1f} % of the surface speed",
               *(("holds", "") if spread < 0.1 else ("differs", heap.reason(""))))


def inertial_number(heap):
    """The largest over the run in what is deeper than the film, against the bound of (3.18)."""
    run = heap.run
    largest, place = 0.0, ""
    for k in range(run.times.size):
        height = run.field("height", k)
        I = run.grains_only(run.field("inertial_number", k), k)
        I[:, run.is_film(height)] = np.ma.masked
        if I.count() and I.max() > largest:
            largest = float(I.max())
            column = np.unravel_index(np.ma.argmax(I), I.shape)[1]
            place = f"t = {run.times[k]:g} s, x = {run.x[column]:.2f} m, {1e3 * height[column]:.1f} mm deep"
    k = run.steady_output
    steady = max(float(np.nanmax(cut.values(along_face(run, k, "inertial_number")))) for cut in slices_of(run, k))
    return Row(f"sections 4.3, 7, figure 14, {heap.model}", "I stays below 1.0297 at 4.6 g/s", "below, close to it", f"{steady:.3f} on the steady face; {largest:.2f} anywhere ({place})",
               "holds" if largest < 1.0297 else "on the face only" if steady < 1.0297 else "differs", "" if largest < 1.0297 else heap.reason("the young heap's toe passes it for a moment; the bound of linear theory is 1.7495"))


def costs(talus):
    return heap_runs.costs(talus, heap_runs.INFLOWS)


if __name__ == "__main__":
    reproduction.main(draw)
