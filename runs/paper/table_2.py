"""Table 2: slopes of the heap at the three experimental inflows, and what else the table's parameters fix."""

import math

import reproduction
from comparison import Row, compare
from figure_9 import EXPERIMENT, MATERIAL
from reproduction import look, plt

PRINTED = {0.0020: "43.3769", 0.0046: "47.9899", 0.0060: "49.5276"}   # kg/s: degree, figure 10; the table keeps two decimals
REASON = "does not follow from the printed parameters: factor_1_15.md"


def draw(talus, folder):
    study = talus.steady(MATERIAL, Q=list(PRINTED))
    exact, exact_parameters = study.flows, study.parameters
    printed = talus.steady(MATERIAL, zeta=[float(text) for text in PRINTED.values()]).flows
    I_N = talus.law(MATERIAL, "classical").neutral[0]
    rows = [compare("table 2, figure 10", f"slope at {1e3 * Q:.1f} g/s", text, flow.zeta, "deg", REASON, digits=6)
            for (Q, text), flow in zip(PRINTED.items(), exact)]
    rows += [compare("table 2, figure 10", f"flow at {text} deg", f"{1e3 * Q:.1f}", 1e3 * flow.Q, "g/s", REASON)
             for (Q, text), flow in zip(PRINTED.items(), printed)]
    return [draw_slopes([flow.zeta for flow in exact], folder)], [
        given(exact_parameters),
        *rows,
        Row("section 4.3", "slopes less the measured ones", f"within 1.5 deg; its own numbers: {off(float(text) for text in PRINTED.values())}",
            off(flow.zeta for flow in exact) + " deg", "not the first", "nor in the print: +1.75"),
        compare("table 2", "I_N, lower neutral point of the classical law", "0.05178", I_N, digits=7),
        compare("section 4.3", "tan 22 deg", "0.4", math.tan(math.radians(22.0))),
        Row("figures 6(c), 7", "measured slope at 4.6 g/s", "49.34 and 49.35 deg", "48.9 + 0.44 = 49.34", "0.01", "two roundings in the print"),
    ]


def given(parameters):
    """The table's parameters, which are input here."""
    names = ("mu_inf", "mu_s", "mu_d", "I_N", "mu_w", "I_0", "gap_m", "Phi", "gravity_m_s2", "d_m", "alpha")
    return Row("table 2", "mu_inf, mu_s, mu_d, I_N, mu_w, I_0, W [m], Phi, g [m/s2], d [m], alpha", "1.3, 0.4, 0.9, 0.05178, 0.3727, 1.3, 0.003, 0.6, 9.81, 0.00073, 1.9",
               ", ".join(f"{parameters[name]:g}" for name in names), "the same", "input; rho_star, which the table lacks, is table 1's")


def draw_slopes(exact, folder):
    """The table's two lines of slopes, and those that follow from its parameters."""
    figure, axes = plt.subplots(figsize=(8.0, 4.6))
    inflows = [1e3 * Q for Q in PRINTED]
    for words, slopes, marker, colour, side in (("measured", list(EXPERIMENT.values()), "^", look.ACCENT, "right"),
                                                ("fitted, as printed", [float(text) for text in PRINTED.values()], "o", look.ORANGE, "left"),
                                                ("exact, from the printed parameters", exact, "s", look.BLUE, "left")):
        axes.plot(inflows, slopes, marker, color=colour, markersize=9, markerfacecolor="white", markeredgewidth=1.8, label=words)
        for Q, slope in zip(inflows, slopes):
            axes.annotate(f"{slope:.2f}°", (Q, slope), xytext=(9 if side == "left" else -9, -4), textcoords="offset points", fontsize=9, color=colour, ha=side)
    axes.set(xlabel="Q [g s$^{-1}$]", ylabel=r"$\zeta$ [degree]", xlim=(1.0, 7.5), ylim=(40.0, 52.0))
    axes.legend(loc="lower right")
    look.grid(axes)
    return reproduction.save(figure, folder, "table_2.png")


def off(slopes):
    """Slopes less the measured ones, in words."""
    return ", ".join(f"{slope - measured:+.2f}" for slope, measured in zip(slopes, EXPERIMENT.values()))


if __name__ == "__main__":
    reproduction.main(draw)
