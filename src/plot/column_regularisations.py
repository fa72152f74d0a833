"""Where in a uniform layer, and when, each named regularisation acts."""

import numpy as np

import look
from column_profiles import spread, thickness
from look import plt

N_OUTPUTS = 24
PANELS = (("wall_mobilisation", "wall friction turned on: tanh(|u|/u_c)", "viridis", (0.0, 1.0)),
          ("cap_active", "viscosity cap takes more than half", "Greys", (0.0, 1.4)),
          ("rate_floor_active", "floor above the strain rate", "Greys", (0.0, 1.4)),
          ("pressure_shift", "log$_{10}$ of what p$_0$ adds to the pressure, relative", "magma", (-8.0, 0.0)))


def draw(run, folder):
    outputs = spread(run, N_OUTPUTS)
    height = run.values("z_interface")
    edges = np.arange(len(outputs) + 1)
    figure, panels = plt.subplots(2, 2, figsize=(12.0, 8.5), sharex=True, sharey=True)
    for number, (axes, (name, words, colours, limits)) in enumerate(zip(panels.flat, PANELS)):
        values = np.array([run.field(name, k) for k in outputs]).T
        if name == "pressure_shift":
            pressure = np.array([run.field("pressure", k) for k in outputs]).T
            values = np.log10(np.maximum(values / pressure, 1e-30))
        mesh = axes.pcolormesh(edges, 1e3 * (height[-1] - height), values, cmap=colours, vmin=limits[0], vmax=limits[1])
        if colours != "Greys":
            figure.colorbar(mesh, ax=axes, extend="min" if limits[0] < 0.0 else "neither")
        elif values.max() < 0.5:
            axes.text(0.5, 0.5, "nowhere", transform=axes.transAxes, ha="center", color=look.FAINT)
        shown = edges[:-1][::max(1, len(outputs) // 8)]
        axes.set_xticks(shown + 0.5, [f"{run.times[outputs[i]]:.3g}" for i in shown])
        axes.set_ylim(1e3 * thickness(run), 0.0)
        look.label(axes, number, words)
    for axes in panels[1]:
        axes.set_xlabel("time of the output [s], not to scale")
    for axes in panels[:, 0]:
        axes.set_ylabel("depth below the surface [mm]")
    figure.suptitle(f"{run.name}: where the regularisations act")
    return [look.save(figure, folder, "regularisations.png")]
