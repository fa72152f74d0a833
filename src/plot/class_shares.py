"""How much of what flows is well-posed, damped, ill-posed or held by the viscosity's cap, in time: shares of area and of flux."""

import numpy as np

import look
from look import plt
from run_data import Missing

CLASSES = (("well_posed", "well-posed", "#9fc3e6"), ("capped", "held by the cap", "#cfcfcf"), ("damped", "C > 0, damped", look.ORANGE),
           ("ill_posed", "ill-posed", look.ACCENT))
CRITERIA = (("ill_posed_share", "C > 0, (3.18)", look.ORANGE), ("growing_share", "short waves grow", look.ACCENT),
            ("not_elliptic_share", "q > 1", look.PURPLE))


def draw(run, folder):
    if not run.has(*(name for name, _, _ in CRITERIA)):
        raise Missing("the model does not say where it is well-posed")
    classed = run.has("class_ill_posed_area")
    t = run.series_times
    figure, panels = plt.subplots(3 if classed else 1, 1, figsize=(8.2, 8.4 if classed else 3.6), sharex=True, squeeze=False)
    panels = panels[:, 0]
    if classed:
        for axes, kind in zip(panels, ("area", "flux")):
            shares = [np.nan_to_num(run.series(f"class_{name}_{kind}")) for name, _, _ in CLASSES]
            axes.stackplot(t, *shares, colors=[colour for _, _, colour in CLASSES], linewidth=0,
                           labels=[f"{words}: at most {100.0 * share.max():.3g} %" for (_, words, _), share in zip(CLASSES, shares)])
            axes.set(ylabel=f"share of flowing {kind}", ylim=(0.0, 1.0))
            axes.legend(loc="lower right", frameon=True, framealpha=0.9, fontsize=9)
    for name, words, colour in CRITERIA:
        panels[-1].plot(t, 100.0 * run.series(name), color=colour, label=words)
    panels[-1].set(ylabel="% of flowing area", xlabel="time [s]", xlim=(t[0], max(t[-1], t[0] + 1e-9)))
    panels[-1].set_ylim(-0.05 * max(panels[-1].get_ylim()[1], 1.0), max(panels[-1].get_ylim()[1], 1.0))
    panels[-1].legend(loc="upper right")
    look.grid(panels[-1])
    titles = ("classes, by area", "classes, by flux", "criteria")[3 - len(panels):]
    for number, (axes, words) in enumerate(zip(panels, titles)):
        look.label(axes, number, words)
    figure.suptitle(f"{run.name}: well-posedness of what flows")
    return [look.save(figure, folder, "well_posedness.png")]
