"""Figure 9: profiles of both laws at two slopes, and slope against mass-inflow rate, with table 2's parameters."""

import numpy as np

import reproduction
from comparison import Row, compare
from reproduction import look, plt

CLASSICAL, PARTIAL = look.ACCENT, look.INK
SLOPES = [float(np.degrees(np.arctan(0.9 + step))) for step in (-0.15, 0.15)]      # just below and above arctan(mu_d)
EXPERIMENT = {0.0020: 41.63, 0.0046: 49.35, 0.0060: 49.80}                         # kg/s: degree
COLOURS = {0.0020: "#d9a300", 0.0046: "#c0392b", 0.0060: look.BLUE}                # as the paper tells the inflows apart
MATERIAL = "table_2.toml"


def draw(talus, folder):
    partial = talus.steady(MATERIAL, zeta=SLOPES, points=400).flows
    classical = talus.steady(MATERIAL, zeta=SLOPES[:1], law="classical", points=400)
    figure, (profiles, slopes) = plt.subplots(1, 2, figsize=(12.0, 5.4))
    beyond = below_infinity(classical.parameters, SLOPES[1])
    draw_profiles(profiles, partial, classical.flows[0], *beyond)
    draw_slopes(slopes, talus, partial, classical)
    look.label(profiles, 0, "speed")
    look.label(slopes, 1, "slope of the heap against inflow")
    return [reproduction.save(figure, folder, "figure_9.png")], rows(talus, partial, classical, beyond[-1])


def draw_profiles(axes, partial, classical, z, u, z_infinite):
    inset = axes.inset_axes((0.36, 0.09, 0.6, 0.4))
    for panel in (axes, inset):
        panel.plot(classical.u, 1e3 * classical.z, color=CLASSICAL, label=f"classical, {classical.zeta:.2f}°")
        for flow, style in zip(partial, ("-", "--")):
            panel.plot(flow.u, 1e3 * flow.z, color=PARTIAL, linestyle=style,
                       label=f"partially regularised, {flow.zeta:.2f}°")
        panel.plot(u, 1e3 * z, color=CLASSICAL, linestyle="--", label=f"classical, {SLOPES[1]:.2f}°")
    inset.axhline(1e3 * z_infinite, color=CLASSICAL, linestyle=":", linewidth=1.2)
    inset.annotate(r"classical, $u \to \infty$", (8.0, 1e3 * z_infinite), xytext=(-4, 3), textcoords="offset points", color=CLASSICAL, fontsize=9,
                   ha="right")
    inset.set(xlim=(0.0, 8.0), ylim=(-6.0, 0.0))
    inset.tick_params(labelsize=8)
    markers = [(classical.z_st, "D", CLASSICAL, "white"), (z[0], "D", CLASSICAL, "#bdbdbd"),
               (partial[0].z_st, "o", PARTIAL, "white"), (partial[1].z_st, "o", PARTIAL, "#bdbdbd")]
    for height, marker, colour, fill in markers:
        axes.plot(0.0, 1e3 * height, marker, color=colour, markerfacecolor=fill, markersize=7, clip_on=False, zorder=5)
    axes.set(xlabel="u [m s$^{-1}$]", ylabel="z [mm]", xlim=(0.0, 0.6), ylim=(-9.0, 0.0))
    axes.legend(loc="upper right")
    look.grid(axes)


def below_infinity(parameters, slope):
    """The classical law's speed on a slope that it cannot hold, from z_st up to where mu reaches mu_d, and that height [m]: (4.12), for
    which `talus steady` rightly has no flow."""
    tan, cos = np.tan(np.radians(slope)), np.cos(np.radians(slope))
    gradient = parameters["mu_w"] / parameters["gap_m"]
    z_st, z_infinite = ((parameters[name] - tan) / gradient for name in ("mu_s", "mu_d"))
    z = z_st + (z_infinite - z_st) * (1.0 - np.linspace(1.0, 0.0, 4000) ** 2)[:-1]
    mu = tan + gradient * z
    I = parameters["I_0"] * (mu - parameters["mu_s"]) / (parameters["mu_d"] - mu)
    rate = I / parameters["d_m"] * np.sqrt(-parameters["Phi"] * parameters["gravity_m_s2"] * cos * z)
    return z, np.concatenate([[0.0], np.cumsum(0.5 * (rate[1:] + rate[:-1]) * np.diff(z))]), z_infinite


def draw_slopes(axes, talus, partial, classical):
    limit = (1e3 * classical.largest_Q, classical.steepest)
    for law, colour, words, slopes in (("classical", CLASSICAL, "classical", np.linspace(22.5, limit[1] - 1e-6, 160)),
                                       ("partial", PARTIAL, "partially regularised", np.linspace(5.0, 54.0, 160))):
        flows = talus.steady(MATERIAL, zeta=slopes, law=law).flows
        axes.plot([1e3 * flow.Q for flow in flows], [flow.zeta for flow in flows], color=colour, label=words)
    axes.plot(*limit, "*", color=CLASSICAL, markersize=13, zorder=5)
    axes.plot([limit[0]] * 2, [20.0, limit[1]], color=CLASSICAL, linestyle="--", linewidth=1.2)
    for flow, marker, colour, fill in ((classical.flows[0], "D", CLASSICAL, "white"), (partial[0], "o", PARTIAL, "white"),
                                       (partial[1], "o", PARTIAL, "#bdbdbd")):
        axes.plot(1e3 * flow.Q, flow.zeta, marker, color=colour, markerfacecolor=fill, markersize=7, zorder=5)
    for Q, zeta in EXPERIMENT.items():
        axes.plot(1e3 * Q, zeta, "^", color=COLOURS[Q], markersize=9, markeredgecolor=look.INK, zorder=6)
    axes.plot([], [], "^", color="white", markeredgecolor=look.INK, markersize=9, label="experiment")
    axes.set(xlabel="Q [g s$^{-1}$]", ylabel=r"$\zeta$ [degree]", xlim=(0.0, 8.0), ylim=(20.0, 54.0))
    axes.legend(loc="lower right")
    look.grid(axes)


def rows(talus, partial, classical, z_infinite):
    where, one = "section 4.2, figure 9", classical.flows[0]
    low = [talus.steady(MATERIAL, Q=[2e-5], law=law).flows[0].zeta for law in ("classical", "partial")]
    steepest = talus.steady("table_1.toml", zeta=[25.0], law="classical").steepest
    return [
        compare(where + "(a)", "arctan(mu_d - 0.15)", "36.87", partial[0].zeta, "deg", digits=6),
        compare(where + "(a)", "arctan(mu_d + 0.15)", "46.40", partial[1].zeta, "deg", digits=6),
        compare(where, "arctan(mu_d), table 2", "41.98", classical.steepest, "deg", "41.987 cut, not rounded", digits=6),
        compare("section 7", "the same", "42", classical.steepest, "deg", digits=6),
        drawn(where + "(a)", "z_st at 36.87 deg: classical; regularised", f"{1e3 * one.z_st:.3f}; {1e3 * partial[0].z_st:.3f} mm"),
        drawn(where + "(a)", "z_st at 46.40 deg, regularised", f"{1e3 * partial[1].z_st:.3f} mm"),
        drawn(where + "(a)", "height at which the classical u is infinite, 46.40 deg", f"{1e3 * z_infinite:.3f} mm"),
        drawn(where + "(b)", "Q at 36.87 deg: classical; regularised", f"{1e3 * one.Q:.4f}; {1e3 * partial[0].Q:.4f} g/s"),
        drawn(where + "(b)", "Q at 46.40 deg, regularised", f"{1e3 * partial[1].Q:.4f} g/s"),
        Row(where + "(b), section 7", "classical flow for the two larger inflows", "none, Q_max < 4.6 g/s",
            f"Q_max = {1e3 * classical.largest_Q:.4f} g/s", "holds", "by 0.15 %, with 4.6 g/s given to 1 %"),
        Row(where + "(b)", "slope at a small inflow, 0.02 g/s: classical; regularised", "almost indistinguishable",
            f"{low[0]:.2f}; {low[1]:.2f} deg", f"{low[1] - low[0]:+.2f}", "mu_inf acts already: I = 0.4 at the surface"),
        compare(where, "largest slope of the classical law, table 1", "29.1", steepest, "deg", digits=6),
        compare("section 7", "the same", "29", steepest, "deg", digits=6),
        compare("section 4.1", "tan 50 deg, above mu_d = 0.557", "1.19", float(np.tan(np.radians(50.0)))),
    ]


def drawn(where, what, ours):
    return Row(where, what, "drawn, not printed", ours, "")


if __name__ == "__main__":
    reproduction.main(draw)
