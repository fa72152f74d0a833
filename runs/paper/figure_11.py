"""Figure 11: the dilute jet, which only the two-fluid model has: volume fraction, speed, and the flow through each height."""

import numpy as np

import heap_runs
import reproduction
from comparison import Row
from reproduction import look, plt

RATE = 0.0046    # kg/s
ENDS = (0.15, 0.85)   # of the height: between the splash and the inlet's first cells


def draw(talus, folder):
    run = heap_runs.jet(talus).run
    k = run.times.size - 1
    figure, (phi, speed, flow) = plt.subplots(1, 3, figsize=(12.0, 5.6))
    for axes, values, words, colours in ((phi, run.field("phi", k), "volume fraction of grains", "cividis"), (speed, run.field("speed", k), "|u| [m s$^{-1}$]", "viridis")):
        mesh = axes.pcolormesh(*run.nodes(k), values, cmap=colours, vmin=0.0)
        axes.set(aspect="equal", xlabel="X [m]")
        figure.colorbar(mesh, ax=axes, label=words)
    phi.set_ylabel("Z [m]")
    Z, Q = through_each_height(run, k)
    flow.plot(1e3 * Q, Z, "o", color=look.BLUE, markersize=3, label="computed")
    flow.axvline(1e3 * RATE, color=look.ACCENT, label="poured in")
    flow.set(xlabel="Q [g s$^{-1}$]", xlim=(0.0, 6.0))
    flow.set_ylabel("Z [m]")
    flow.legend(loc="center left")
    look.grid(flow)
    for number, (axes, words) in enumerate(((phi, f"grains, t = {look.seconds(run.times[k])}"), (speed, "speed"), (flow, "flow through each height"))):
        look.label(axes, number, words)
    return [reproduction.save(figure, folder, "figure_11.png")], [row(Z, Q)]


def costs(talus):
    return [heap_runs.jet(talus).cost]


def through_each_height(run, k):
    """Heights [m] and mass flow down through each [kg/s], from the middles of the cells."""
    rho = float(run.stated("grains", "rho_star")) * float(run.stated("grains", "Phi"))
    flux = -np.sum(run.field("phi", k) * run.field("w_centre", k) * np.diff(run.x_face), axis=1)
    return run.field("z", k).mean(axis=1), rho * float(run.stated("box", "gap")) * flux


def row(Z, Q):
    inside = (Z > ENDS[0] * Z.max()) & (Z < ENDS[1] * Z.max())
    off = np.abs(Q[inside] / RATE - 1.0).max()
    return Row("figure 11, two-fluid", "flow through each height, inlet and splash (15 % at either end) left aside", "4.6 g/s",
               f"{1e3 * Q[inside].min():.3f} to {1e3 * Q[inside].max():.3f} g/s", "holds" if off < 0.02 else "differs",
               "fluxes through faces carry 4.6 g/s everywhere; drawn are products of cells' means, which at the inlet fall short")


if __name__ == "__main__":
    reproduction.main(draw)
