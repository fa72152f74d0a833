"""Figure 19: the same inflow without wall friction. No heap; a Bagnold flow (B2) far enough down the chute."""

import numpy as np

import heap_runs
import reproduction
from comparison import Row
from reproduction import look, plt
import field_maps

PLACE = 0.5          # m down the chute: far enough
CREEPING = 1e-3      # m/s
FEW = 0.05           # volume fraction below which a cell's speed is the air's
RATE = 4.6           # g/s


def draw(talus, folder):
    heaps = heap_runs.both(talus, "heap_no_walls")
    figure, (*fields, profile) = plt.subplots(1, 3, figsize=(15.0, 4.6), width_ratios=[1.25, 1.25, 1.0])
    last = [heap.run.times.size - 1 for heap in heaps]
    speeds = [where_grains_are(heap.run, k) for heap, k in zip(heaps, last)]
    fastest = float(speeds[0].max())  # the jet, which the layer has not, is faster
    X0, X1, Z0, Z1 = heaps[0].run.extent([last[0]])
    for number, (heap, k, speed, axes) in enumerate(zip(heaps, last, speeds, fields)):
        mesh = field_maps.paint(axes, heap.run, k, "speed", speed, vmin=0.0, vmax=fastest)
        axes.set(aspect="equal", xlabel="X, horizontal [m]", ylabel="Z, up [m]" if number == 0 else "", xlim=(X0, X1), ylim=(Z0, Z1))
        look.label(axes, number, f"{heap.label}, t = {look.seconds(heap.run.times[k])}")
    figure.colorbar(mesh, ax=fields, label="|u| [m s$^{-1}$]", shrink=0.8, extend="max")
    run, k = heaps[0].run, last[0]
    depth, u, exact_depth, exact_u, thickness = far_down(run, k)
    profile.plot(u, 1e3 * (thickness - depth), "o", color=look.BLUE, markerfacecolor="white", label=f"computed, layer, x = {PLACE:g} m")
    draw_cells(profile, heaps[1], last[1])
    profile.plot(exact_u, 1e3 * (exact_depth[-1] - exact_depth), color=look.ACCENT, linestyle="--", label="Bagnold, (B2)")
    profile.set(xlabel="u [m s$^{-1}$]", ylabel="height above the base [mm]")
    profile.set_xlim(left=0.0)
    profile.set_ylim(0.0, 20.0)
    profile.legend(loc="upper left", frameon=True, framealpha=1.0, edgecolor="white", fontsize=9)
    look.grid(profile)
    look.label(profile, 2, "far down the chute")
    return [reproduction.save(figure, folder, "figure_19.png")], rows(run, k, depth, u, exact_depth, exact_u, thickness) + two_fluid_rows(heaps[1], last[1])


def where_grains_are(run, k):
    """Speeds, without cells of air and columns that hold no more than the film."""
    speed = np.ma.masked_invalid(run.field("speed", k))
    if run.has("phi"):
        return np.ma.masked_where(run.field("phi", k) < FEW, speed)
    speed[:, run.is_film(run.field("height", k))] = np.ma.masked
    return speed


def draw_cells(axes, heap, k):
    """Speeds of the two-fluid model at PLACE, each as high as its cell, where there are grains."""
    run = heap.run
    j = int(np.argmin(np.abs(run.x - PLACE)))
    phi, u, z = run.field("phi", k)[:, j], run.field("speed", k)[:, j], run.field("z_node", k)[:, j]
    for i in np.flatnonzero(phi > FEW):
        axes.plot([u[i]] * 2, 1e3 * z[i:i + 2], color=look.GREEN, linewidth=4.0, solid_capstyle="butt", label=f"a cell of the two-fluid model, {100.0 * phi[i]:.0f} % grains")


def two_fluid_rows(heap, k):
    run, where = heap.run, f"section 7, figure 19, {heap.model}"
    phi, speed = run.field("phi", k), run.field("speed", k)
    still = (phi > 0.5) & (speed < CREEPING) & (run.x < run.stated("inflow", "position"))
    held = 1e3 * heap.mass(run.times[k])
    return [
        Row(where, "heap without wall friction", "none forms", f"{held:.0f} g in the box, {100.0 * held / (RATE * run.times[k]):.0f} % of what was poured", "holds"),
        Row(where, "profile far down the chute against (B2)", "Bagnold profile", f"one cell of {1e3 * np.diff(run.x_face).max():.0f} mm, where 6.06 mm flow", "differs", heap.reason("")),
        Row(where, "a small static region up-slope of the jet", "there is one", f"{still.sum()} cells that stand" if still.any() else "none", "holds" if still.any() else "differs",
            "" if still.any() else heap.reason("")),
    ]


def far_down(run, k):
    """Depths and speeds of the column at PLACE, of the exact flow, and the computed thickness there [m]."""
    j = int(np.argmin(np.abs(run.x - PLACE)))
    thickness = float(run.field("height", k)[j])
    return (thickness - run.field("z", k)[:, j], run.field("speed", k)[:, j], np.abs(run.values("exact_depth")), run.values("exact_speed"), thickness)


def rows(run, k, depth, u, exact_depth, exact_u, thickness):
    order = np.argsort(exact_depth)
    wanted = np.interp(depth, exact_depth[order], exact_u[order])
    off = float(np.sqrt(np.sum((u - wanted) ** 2) / np.sum(wanted ** 2)))
    height, speed = run.field("height", k), run.field("speed", k)
    deep = np.flatnonzero(height > 4.0 * run.film)
    return [
        Row("section 7, figure 19, layer", "heap without wall friction", "none forms", f"layer of {1e3 * thickness:.2f} mm, exact {1e3 * exact_depth.max():.2f}", "holds"),
        Row("section 7, figure 19, layer", "profile far down the chute against (B2)", "Bagnold profile", f"u within {100.0 * off:.1f} % (L2) at x = {PLACE:g} m, surface {u[-1]:.3f} m/s, "
            f"exact {exact_u.max():.3f}", "holds" if off < 0.05 else "differs"),
        Row("section 7, figure 19, layer", "a small static region up-slope of the jet", "there is one", f"none: the uppermost column above 2 mm moves at "
            f"{1e3 * speed[-1, deep[0]]:.0f} mm/s on top" if speed[-1, deep[0]] > CREEPING else "there is one", "differs" if speed[-1, deep[0]] > CREEPING else "holds",
            "the layer holds grains there as a film of 0.5 mm, without the angle of repose of a dry corner"),
    ]


def costs(talus):
    return heap_runs.costs(talus, ["heap_no_walls"])


if __name__ == "__main__":
    reproduction.main(draw)
