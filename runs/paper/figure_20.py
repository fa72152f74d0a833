"""Figure 20: a layer 0.2 m deep between walls on six slopes, the column over the exact curves."""

import reproduction
from column_figure import ALL, COARSE, Case, agreement, blues, curves, draw_curves, froude, joint_agreement, name_markers
from comparison import Row, compare
from reproduction import look, plt

SCENE = "figure_20.toml"
PRINTED = {41: "0.1051", 47: "0.5007", 51: "1.2047", 54: "2.2171", 57: "3.9787", 59: "5.8308"}   # degree: m2/s
TABLE_1 = ("grains.d=1.43e-4", "time.end=30000")


def draw(talus, folder):
    coarse, fine = (curves(talus, SCENE, [Case(f"{zeta}°", zeta, sets) for zeta in PRINTED], layers)
                    for sets, layers in (((), ALL), (TABLE_1, COARSE)))
    figure, panels = plt.subplots(1, 2, figsize=(11.5, 5.2), sharey=True)
    for number, (axes, drawn, words) in enumerate(zip(panels, (coarse, fine), ("d = 8 mm", "d = 0.143 mm, as in table 1"))):
        draw_curves(axes, drawn, blues(len(drawn)))
        look.label(axes, number, words)
    name_markers(panels[0])
    panels[0].legend(loc="lower right", title=r"$\zeta$")
    panels[1].set_ylabel("")
    return [reproduction.save(figure, folder, "figure_20.png")], rows(coarse, fine)


def rows(coarse, fine):
    result = [compare("figure 20", f"flow at {zeta} deg with d = 8 mm, exact", printed, curve.exact.volume_flux, "m2/s",
                      "fifth digit; they may have integrated with an error of that size", 7)
              for (zeta, printed), curve in zip(PRINTED.items(), coarse)]
    result.append(Row("figure 20", "the six with d of table 1", ", ".join(PRINTED.values()) + " m2/s",
                      ", ".join(f"{curve.exact.volume_flux:.5g}" for curve in fine),
                      f"x {fine[0].exact.volume_flux / coarse[0].exact.volume_flux:.2f}", "the figure was not made with table 1's d"))
    result += [
        Row("figure 20", "mu_w", "0.277", "0.277", "", "table 1, which the caption refers to for the rest, has 0.27"),
        Row("figure 20", "I at the surface, six slopes", "not given", ", ".join(f"{curve.exact.surface_I:.2f}" for curve in coarse), "",
            "57 and 59 deg are beyond 16.99 and the linear theory's 17.91"),
        Row("figure 20", "z_st at 57 and 59 deg", "not given", f"{coarse[4].exact.z_st:.4f}, {coarse[5].exact.z_st:.4f} m", "",
            "below the layer of 0.2 m, in creep that carries nothing"),
        froude("figure 20, appendix B", coarse),
    ]
    result += [agreement("figure 20", f"{curve.label}, d = 8 mm", curve) for curve in coarse]
    result.append(joint_agreement("figure 20", "the six with d = 8 mm", coarse)[1])
    result += joint_agreement("figure 20", "the six with d of table 1", fine)
    return result


if __name__ == "__main__":
    reproduction.main(draw)
