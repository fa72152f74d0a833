"""Mass in the box, mass on the balance under the outlet, and mass-flow rates (figure 5)."""

import look
import paper
from look import plt


def draw(run, folder):
    t = run.series_times
    stored = run.series("mass_stored")
    figure, (box, balance, rate) = plt.subplots(3, 1, figsize=(8.2, 9.2), sharex=True)

    at_start = f", with {1e3 * stored[0]:.2g} g there at the start" if stored[0] > 0.0 else ""
    box.plot(t, stored, color=look.BLUE, label=f"computed{at_start}")
    if run.is_paper_scene:
        until = [i for i, time in enumerate(paper.MASS_TIMES) if time <= t[-1]]
        box.plot([paper.MASS_TIMES[i] for i in until], [paper.MASSES[i] for i in until], "o", color=look.ACCENT,
                 markerfacecolor="white", markeredgewidth=1.5, label="paper, figure 12 (its areas read as kg)")
    box.set_ylabel("mass in the box [kg]")
    box.set_ylim(bottom=0.0)
    box.legend()
    look.label(box, 0, "stored")

    right, left, inflow = (run.series(name) for name in ("mass_outflow_right", "mass_outflow_left", "mass_inflow"))
    balance.plot(t, inflow, color=look.FAINT, label="poured in")
    balance.plot(t, right, color=look.BLUE, label="out at the right")
    if left.max() > 1e-6 * max(inflow.max(), stored.max()):
        balance.plot(t, left, color=look.ORANGE, label="out at the left")
    balance.set_ylabel("accumulated mass [kg]")
    balance.legend()
    look.label(balance, 1, "accumulated")

    inflow_rate = run.series("inflow_rate")
    rate.plot(t, 1e3 * inflow_rate, color=look.FAINT, label="in")
    rate.plot(t, 1e3 * run.series("outflow_rate_right"), color=look.BLUE, label="out at the right")
    if run.has("outflow_rate_left") and left.max() > 1e-6 * max(inflow.max(), stored.max()):
        rate.plot(t, 1e3 * run.series("outflow_rate_left"), color=look.ORANGE, label="out at the left")
    rate.set(xlabel="time [s]", ylabel="mass-flow rate [g s$^{-1}$]", xlim=(t[0], max(t[-1], t[0] + 1e-9)))
    rate.set_ylim(bottom=min(0.0, rate.get_ylim()[0]))
    rate.legend()
    look.label(rate, 2, "rates")

    for axes in (box, balance, rate):
        look.grid(axes)
        if run.inflow_stop is not None:
            axes.axvline(run.inflow_stop, color=look.FAINT, linestyle=":", linewidth=1.2)
    if run.inflow_stop is not None:
        box.annotate("inflow stops", (run.inflow_stop, 0.0), xytext=(5, 6), textcoords="offset points", color="#666666")
    figure.suptitle(f"{run.name}: mass")
    return [look.save(figure, folder, "mass.png")]
