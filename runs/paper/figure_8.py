"""Figure 8: friction, and where the equations are well-posed, for the classical and the partially regularised law of table 1."""

import numpy as np

import reproduction
from comparison import Row, compare
from reproduction import look, plt

CLASSICAL, PARTIAL = look.ACCENT, look.BLUE
SHORT, LONG = 0.45, 20.0   # ends of the axes in I: the classical law's well-posed range, the regularised law's


def draw(talus, folder):
    laws = {name: talus.law("table_1.toml", name) for name in ("classical", "partial")}
    figure, ((near, far), (near_C, far_C)) = plt.subplots(2, 2, figsize=(10.0, 7.4))
    draw_friction(near, talus, laws, SHORT, "classical")
    draw_friction(far, talus, laws, LONG, "partial")
    draw_condition(near_C, talus, laws["classical"], SHORT, CLASSICAL)
    draw_condition(far_C, talus, laws["partial"], LONG, PARTIAL)
    low = near_C.inset_axes((0.55, 0.14, 0.4, 0.36))
    draw_condition(low, talus, laws["classical"], 0.01, CLASSICAL)
    low.set(xlabel="", ylabel="", xticks=(0.0, 0.005, 0.01))
    low.tick_params(labelsize=8)
    bound = laws["partial"].linear_bound
    far_C.axvline(bound, color=look.FAINT, linestyle="--", linewidth=1.2)
    far_C.annotate("linear theory", (bound, 0.0), xytext=(-4, -6), textcoords="offset points", rotation=90, ha="right", va="top",
                   fontsize=9, color="#666666")
    for number, (axes, words) in enumerate(((near, "friction, and the classical law's range"), (far, "and the regularised law's"),
                                            (near_C, "condition (3.18), classical law"), (far_C, "regularised law"))):
        look.label(axes, number, words)
        look.grid(axes)
    near.legend(loc="lower right")
    return [reproduction.save(figure, folder, "figure_8.png")], rows(talus, laws)


def draw_friction(axes, talus, laws, end, shaded):
    for name, colour, words in (("classical", CLASSICAL, "classical (1.3)"), ("partial", PARTIAL, "partially regularised (3.19)")):
        table = talus.friction("table_1.toml", name, inertial_numbers(end))
        axes.plot(table["I"], table["mu"], color=colour, label=words)
        axes.plot(0.0, laws[name].at_rest, "o", color=colour, markersize=6, clip_on=False, zorder=5)
    low, high = laws[shaded].well_posed[0]
    axes.axvspan(low, min(high, end), color=CLASSICAL if shaded == "classical" else PARTIAL, alpha=0.12, linewidth=0)
    axes.set(xlabel="I", ylabel=r"$\mu$", xlim=(-0.012 * end, end))
    axes.set_ylim(bottom=0.0)


def draw_condition(axes, talus, law, end, colour):
    table = talus.friction("table_1.toml", law.name, inertial_numbers(end))
    axes.axhline(0.0, color=look.INK, linewidth=0.8)
    axes.plot(table["I"], table["C"], color=colour)
    zeros = [I for I in law.neutral if I <= end]
    axes.plot(zeros, np.zeros(len(zeros)), "o", color=look.INK, markersize=5, zorder=5)
    axes.set(xlabel="I", ylabel="C", xlim=(-0.012 * end, end))


def inertial_numbers(end):
    """Dense near zero, where the creep branch rises from rest more steeply than any power of I."""
    return np.concatenate([np.logspace(-290.0, -7.0, 200), end * np.linspace(0.01, 1.0, 400) ** 3])


def rows(talus, laws):
    (low, high), partial = laws["classical"].neutral, laws["partial"]
    table = {name: talus.friction("table_1.toml", name, [0.3])["mu"][0] for name in laws}
    excess = 100.0 * (table["partial"] / table["classical"] - 1.0)
    return [
        compare("section 3.4, figure 8(c)", "where the classical law becomes well-posed, I", "0.004", low),
        compare("section 3.4, figure 8(c)", "and where it ceases to be", "0.3", high),
        compare("table 1, section 3.5", "I_N, the first of these", "0.004", low),
        compare("section 3.5, figure 8(d)", "where the regularised law ceases to be well-posed, I", "16.99", partial.neutral[-1], digits=6),
        Row("figure 8(d)", "the same by the linear theory, mu - I mu'/2 = 1", "not given", f"{partial.linear_bound:.4f}", "",
            "C > 0 means growth only where I mu'/mu < 1/2 (models/rheology)"),
        Row("section 3.5, figure 8(a)", "regularised above classical friction, I up to 0.3", "very close", f"up to {excess:.1f} %", "holds"),
        Row("section 3.4", "Bagnold flow of Barker et al. (2015) at 32 deg", "ill-posed", "no such flow", "",
            "tan 32 deg = 0.625 is above table 1's mu_d = 0.557: their parameters were others"),
    ]


if __name__ == "__main__":
    reproduction.main(draw)
