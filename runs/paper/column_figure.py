"""What figures 20 and 21 share: a uniform layer, run from rest to its steady state by the column at several resolutions and by the
two-dimensional layer in a periodic box four cells long, as the paper's, over the exact curves."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np

from comparison import Row
from reproduction import look, plt
from talus import Flow, Profile, last_profile

DEPTH = 0.2                    # m, of the layer
COARSE = (100,)                # layers; the first are drawn
ALL = (100, 200, 400)
BOX = ("model.name=layer", "grid.columns=4")
N_CIRCLES = 25
N_AT_ONCE = 2                  # runs


@dataclass(frozen=True)
class Curve:
    """One flow: exact, by columns of `layers` layers, and by the periodic box with as many layers as the first of them."""
    label: str
    exact: Flow
    layers: tuple
    columns: list
    box: Profile

    def speed_error(self, profile):
        """Relative L2 difference of a profile's speeds from the exact ones."""
        exact = np.interp(profile.z, self.exact.z, self.exact.u)
        return float(np.sqrt(np.sum((profile.u - exact) ** 2) / np.sum(exact ** 2)))

    def flux_error(self, profile):
        return profile.flux / self.exact.volume_flux - 1.0


@dataclass(frozen=True)
class Case:
    """What tells a curve from the scene's others: its slope [degree], and settings."""
    label: str
    zeta: float
    sets: tuple = ()


def curves(talus, scene, cases, layers):
    """All cases of a scene. Their runs lie in folders named after scene, slope and settings."""
    def run(case, *more):
        sets = (f"box.tilt={case.zeta}", *case.sets, *more)
        return talus.run(scene, "_".join([scene.removesuffix(".toml"), *(one.split("=")[1] for one in sets)]), sets)

    with ThreadPoolExecutor(N_AT_ONCE) as pool:
        columns = [[pool.submit(run, case, f"grid.layers={n}") for n in layers] for case in cases]
        boxes = [pool.submit(run, case, *BOX, f"grid.layers={layers[0]}") for case in cases]
        exact = [talus.steady(scene, zeta=[case.zeta], thickness=DEPTH, points=2001, sets=case.sets).flows[0] for case in cases]
        return [Curve(case.label, flow, layers, [last_profile(one.result()) for one in row], last_profile(box.result()))
                for case, flow, row, box in zip(cases, exact, columns, boxes)]


def draw_curves(axes, curves, colours):
    for curve, colour in zip(curves, colours):
        axes.plot(curve.exact.u, curve.exact.z, color=colour, label=curve.label)
        column = curve.columns[0]
        chosen = np.unique(np.linspace(0, column.z.size - 1, N_CIRCLES).astype(int))
        axes.plot(curve.box.u[chosen], curve.box.z[chosen], "o", color=colour, markersize=5.5, markerfacecolor="white", zorder=4)
        axes.plot(column.u[chosen], column.z[chosen], ".", color=look.INK, markersize=3, zorder=5)
    axes.set(xlabel="u [m s$^{-1}$]", ylabel="z [m]", ylim=(-DEPTH, 0.0))
    axes.set_xlim(left=0.0)
    look.grid(axes)


def name_markers(axes):
    """Entries of the legend for the computed points."""
    axes.plot([], [], "o", color=look.INK, markersize=5.5, markerfacecolor="white", label="layer, 4 x 100 cells")
    axes.plot([], [], ".", color=look.INK, markersize=3, label="column, 100 cells")


def blues(n):
    """Light to dark."""
    return [plt.get_cmap("Blues")(v) for v in np.linspace(0.35, 1.0, n)]


def agreement(where, what, curve):
    """The row that says how well the columns meet the exact curve."""
    return row(where, f"column, {what}", [(curve, column) for column in curve.columns], f"{', '.join(str(n) for n in curve.layers)} cells")


def joint_agreement(where, what, curves):
    """The same for several curves, first columns and boxes, in a row each."""
    n = curves[0].layers[0]
    return [row(where, f"column, {what}", [(curve, curve.columns[0]) for curve in curves], f"{n} cells"),
            row(where, f"two-dimensional layer, {what}", [(curve, curve.box) for curve in curves], f"4 x {n} cells")]


def row(where, what, pairs, cells):
    speeds = ", ".join(f"{100.0 * curve.speed_error(profile):.2g}" for curve, profile in pairs)
    flux = max(abs(curve.flux_error(profile)) for curve, profile in pairs)
    return Row(where, f"against the exact curve: {what}", "good agreement", f"u within {speeds} % (L2)", f"flux within {100.0 * flux:.1g} %", cells)


def froude(where, curves):
    numbers = [curve.exact.froude for curve in curves]
    return Row(where, "Froude numbers of the layers", "waves above about 2/3", f"{min(numbers):.3g} to {max(numbers):.3g}", "",
               "a column has no waves; the paper's box is too short for them")
