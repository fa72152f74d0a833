"""Figure 21: a layer 0.2 m deep at 28 degrees between walls at five distances, the column over the exact curves, and Bagnold's flow."""

import reproduction
from column_figure import ALL, COARSE, Case, agreement, blues, curves, draw_curves, froude, joint_agreement, name_markers
from comparison import Row
from reproduction import look, plt

SCENE, ZETA = "figure_21.toml", 28.0
GAPS = (0.18, 0.45, 1.0, 3.0, 500.0)                                    # m
TABLE_1 = ("grains.d=1.43e-4", "time.end=30000")
MU_W = {"figure 20": 0.277, "table 1": 0.27}


def draw(talus, folder):
    choices = [("d = 8 mm", "figure 20", (), ALL), ("d = 0.143 mm", "table 1", TABLE_1, COARSE)]
    figure, panels = plt.subplots(1, 2, figsize=(11.5, 5.2), sharey=True)
    result = []
    for number, (axes, (words, source, sets, layers)) in enumerate(zip(panels, choices)):
        cases = [Case(f"{gap:g} m", ZETA, (*sets, f"wall.mu_w={MU_W[source]}", f"box.gap={gap}")) for gap in GAPS]
        *drawn, bagnold = curves(talus, SCENE, [*cases, Case("Bagnold", ZETA, (*sets, "wall.mu_w=0"))], layers)
        draw_curves(axes, drawn, blues(len(drawn)))
        axes.plot(bagnold.exact.u, bagnold.exact.z, color=look.ACCENT, linestyle="--", label="Bagnold (B2)", zorder=5)
        look.label(axes, number, f"{words}, as in {source}")
        result += rows(words, drawn, bagnold)
    name_markers(panels[0])
    panels[0].legend(loc="lower right", title="W")
    panels[1].set_ylabel("")
    return [reproduction.save(figure, folder, "figure_21.png")], result


def rows(words, drawn, bagnold):
    if len(bagnold.layers) > 1:
        result = [agreement("figure 21", f"W = {curve.label}, {words}", curve) for curve in drawn]
        result.append(agreement("figure 21", f"Bagnold, {words}", bagnold))
    else:
        result = joint_agreement("figure 21", f"five gaps and Bagnold, {words}", [*drawn, bagnold])[:1]
    result.append(joint_agreement("figure 21", f"five gaps and Bagnold, {words}", [*drawn, bagnold])[1])
    result.append(froude(f"figure 21, {words}", [*drawn, bagnold]))
    wide, limit = drawn[-1].exact.surface_speed, bagnold.exact.surface_speed
    result.append(Row("figure 21", f"exact surface speed at W = 500 m and Bagnold's (B2), {words}", "the same", f"{wide:.6g}, {limit:.6g} m/s",
                      f"{100.0 * (wide / limit - 1.0):+.1g} %",
                      "what walls 500 m apart still take"))
    return result


if __name__ == "__main__":
    reproduction.main(draw)
