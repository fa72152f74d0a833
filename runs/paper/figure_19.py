"""Figure 19: the same inflow without wall friction. No heap; a Bagnold flow (B2) far enough down the chute."""

import numpy as np

import heap_runs
import reproduction
from comparison import Row
from reproduction import look, plt

PLACE = 0.5          # m down the chute: far enough
CREEPING = 1e-3      # m/s


def draw(talus, folder):
    heap = heap_runs.layer(talus, "heap_no_walls")
    run, k = heap.run, heap.run.times.size - 1
    figure, (field, profile) = plt.subplots(1, 2, figsize=(12.0, 4.6), width_ratios=[1.5, 1.0])
    speed = run.grains_only(run.field("speed", k), k)
    speed[:, run.is_film(run.field("height", k))] = np.ma.masked
    mesh = field.pcolormesh(*run.nodes(k), speed, vmin=0.0)
    field.plot(*run.surface(run.field("height", k)), color=look.INK, linewidth=0.8)
    field.plot(*run.base(), color=look.INK, linewidth=1.6)
    field.set(aspect="equal", xlabel="X, horizontal [m]", ylabel="Z, up [m]")
    figure.colorbar(mesh, ax=field, label="|u| [m s$^{-1}$]", shrink=0.8)
    depth, u, exact_depth, exact_u, thickness = far_down(run, k)
    profile.plot(u, 1e3 * (thickness - depth), "o", color=look.BLUE, markerfacecolor="white", label=f"computed, x = {PLACE:g} m")
    profile.plot(exact_u, 1e3 * (exact_depth[-1] - exact_depth), color=look.ACCENT, linestyle="--", label="Bagnold, (B2)")
    profile.set(xlabel="u [m s$^{-1}$]", ylabel="height above the base [mm]")
    profile.set_xlim(left=0.0)
    profile.set_ylim(bottom=0.0)
    profile.legend(loc="lower right")
    look.grid(profile)
    look.label(field, 0, f"speed at t = {look.seconds(run.times[k])}")
    look.label(profile, 1, "far down the chute")
    return [reproduction.save(figure, folder, "figure_19.png")], rows(run, k, depth, u, exact_depth, exact_u, thickness)


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
