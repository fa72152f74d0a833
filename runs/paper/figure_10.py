"""Figure 10: speed and inertial number through the depth at the three experimental inflows; table 2's slopes.

The measured profiles of the paper's figures 7 and 10(a) are not available: only the theory is drawn."""

import reproduction
from comparison import Row, compare
from figure_9 import COLOURS, MATERIAL
from reproduction import look, plt
from table_2 import PRINTED


def draw(talus, folder):
    exact = talus.steady(MATERIAL, Q=list(PRINTED), points=400).flows
    printed = talus.steady(MATERIAL, zeta=[float(text) for text in PRINTED.values()], points=400).flows
    law = talus.law(MATERIAL, "partial")
    figure, (speed, inertia) = plt.subplots(1, 2, figsize=(11.0, 5.0), sharey=True)
    for Q, flow, other in zip(PRINTED, exact, printed):
        for axes, curve, thin in ((speed, flow.u, other.u), (inertia, flow.I, other.I)):
            axes.plot(curve, 1e3 * flow.z, color=COLOURS[Q], label=f"{1e3 * Q:.1f} g/s, {flow.zeta:.2f}°")
            axes.plot(thin, 1e3 * other.z, color=COLOURS[Q], linestyle=":", linewidth=1.2)
    speed.plot([], [], color=look.INK, linestyle=":", linewidth=1.2, label="at the slopes that the paper prints")
    for bound, style, words in ((law.neutral[-1], "--", "C = 0"), (law.linear_bound, "-.", "linear theory")):
        inertia.axvline(bound, color=look.INK, linestyle=style, linewidth=1.2)
        inertia.annotate(f"{words}, {bound:.4f}", (bound, -9.0), xytext=(-3, 4), textcoords="offset points", rotation=90, ha="right",
                         va="bottom", fontsize=9)
    speed.set(xlabel="u [m s$^{-1}$]", ylabel="z [mm]", xlim=(0.0, 0.48), ylim=(-9.0, 0.0))
    inertia.set(xlabel="I", xlim=(0.0, 1.85))
    speed.legend(loc="lower right")
    for number, (axes, words) in enumerate(((speed, "speed, theory alone"), (inertia, "inertial number"))):
        look.label(axes, number, words)
        look.grid(axes)
    return [reproduction.save(figure, folder, "figure_10.png")], rows(exact, law)


def rows(exact, law):
    surface = ", ".join(f"{flow.surface_I:.4f}" for flow in exact)
    return [
        Row("figures 7, 10(a)", "measured profiles", "drawn", "left out", "", "the measurements are not printed as numbers"),
        compare("section 4.3, figure 10(b)", "where C = 0, upper bound of I", "1.0297", law.neutral[-1], digits=6),
        Row("figure 10(b)", "the same by the linear theory, mu - I mu'/2 = 1", "not given", f"{law.linear_bound:.5f}", "",
            "C > 0 means growth only where I mu'/mu < 1/2 (models/rheology)"),
        Row("section 4.3, figure 10(b)", "I at the surface at 2.0, 4.6, 6.0 g/s", "below 1.0297", surface, "holds", "by 0.3 % at 6.0 g/s"),
    ]


if __name__ == "__main__":
    reproduction.main(draw)
