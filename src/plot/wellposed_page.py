"""Is a model well-posed on grids: growth over inertial number and grid, and the modes of its steady state."""

import textwrap

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import SymLogNorm

import look


def filled(variable):
    return np.ma.filled(np.ma.masked_invalid(np.ma.asarray(variable[:], dtype=float)), np.nan)


def bounds(axes, data):
    """Where C of (3.18) changes its sign, and where short waves begin to grow by linear theory."""
    for name, style, words in (("symbol_C_bound", "--", "C = 0, (3.18)"), ("symbol_growth_bound", "-", "bound of linear theory")):
        if name in data.variables:
            for i, place in enumerate(filled(data[name])):
                axes.axvline(place, color="black", linestyle=style, linewidth=1.1, label=words if i == 0 else None)


def growth_map(figure, axes, data):
    I, cells = filled(data["symbol_I"]), np.asarray(data["symbol_cells"][:])
    growth = filled(data["symbol_layer"])
    largest = np.nanmax(np.abs(growth))
    mesh = axes.pcolormesh(I, cells, growth.T, norm=SymLogNorm(max(1e-8 * largest, 1e-3), vmin=-largest, vmax=largest), cmap="RdBu_r",
                           shading="nearest")
    axes.set_xscale("log")
    axes.set_yscale("log", base=2)
    axes.set_yticks(cells, [str(n) for n in cells])
    axes.set_xlabel("inertial number I")
    axes.set_ylabel("cells a side")
    bounds(axes, data)
    axes.legend(loc="lower left", frameon=True)
    figure.colorbar(mesh, ax=axes, label="fastest growth over the shear rate")
    look.label(axes, 0, "the layer's operator: red grows, blue decays")


def against_closed_form(axes, data):
    """Growth over eta k^2/rho at the finest grid, with the wave number of its fastest wave."""
    I = filled(data["symbol_I"])
    cells = np.asarray(data["symbol_cells"][:])
    closed = filled(data["symbol_closed_form"])
    axes.plot(I, np.clip(closed, -1.2, 3.0), color="black", label="closed form, every wave")
    scale = filled(data["symbol_scale"])
    for name, colour, words in (("layer", look.BLUE, "layer"), ("averaged", look.ORANGE, "averaged viscosity")):
        k2 = (2 * np.sin(filled(data[f"symbol_{name}_kx"]) / 2)) ** 2 + (2 * np.sin(filled(data[f"symbol_{name}_kz"]) / 2)) ** 2
        value = filled(data[f"symbol_{name}"]) / scale / k2
        axes.plot(I, np.clip(value[:, -1], -1.2, 3.0), "o", color=colour, markersize=3.5, label=f"fastest wave of {cells[-1]} cells, {words}")
    axes.set_xscale("log")
    axes.axhline(0.0, color=look.FAINT, linewidth=0.8)
    bounds(axes, data)
    axes.set_xlabel("inertial number I")
    axes.set_ylabel(r"growth over $\eta k^2/\rho$, cut at 3")
    axes.legend(loc="best", fontsize=8, frameon=True)
    look.grid(axes)
    look.label(axes, 1, "against the closed form")


def hidden(axes, data):
    """Over grids: what the layer sees and what averages hide, at inertial numbers that grow."""
    I, cells = filled(data["symbol_I"]), np.asarray(data["symbol_cells"][:])
    layer, averaged = filled(data["symbol_layer"]), filled(data["symbol_averaged"])
    grows = np.nonzero(data["symbol_closed_form"][:] > 0.0)[0]
    chosen = grows[np.unique(np.linspace(0, len(grows) - 1, 4).astype(int))] if len(grows) else []
    for colour, i in zip(look.sequence_colours(len(chosen)), chosen):
        for values, style, marker in ((layer, "-", "o"), (averaged, "--", "s")):
            positive = np.where(values[i] > 0.0, values[i], np.nan)
            axes.plot(cells, positive, style, marker=marker, color=colour, markersize=4,
                      label=f"I = {I[i]:.2g}" if style == "-" else None)
    axes.set_xscale("log", base=2)
    if len(chosen):
        axes.set_yscale("log")
        axes.legend(loc="best", fontsize=8, frameon=True)
    else:
        axes.text(0.5, 0.5, "nothing grows at any I", transform=axes.transAxes, ha="center")
    axes.set_xlabel("cells a side")
    axes.set_ylabel("growth over the shear rate")
    look.grid(axes)
    look.label(axes, 2, "seen (solid) and hidden by averages (dashed); none: decays")


def dispersion(axes, data, number):
    length, growth = 1e3 * filled(data["wave_length"]), filled(data["wave_growth"])
    axes.plot(length, growth, "o-", color=look.BLUE, markersize=4)
    axes.axhline(0.0, color=look.FAINT, linewidth=0.8)
    axes.set_xscale("log")
    axes.set_yscale("symlog", linthresh=max(1e-3 * np.nanmax(np.abs(growth)), 1e-6))
    axes.set_xlabel("wavelength [mm]")
    axes.set_ylabel("growth rate [1/s]")
    look.grid(axes)
    look.label(axes, number, "waves on the uniform layer")


def wave_field(figure, axes, data, number):
    """One wavelength of the fastest growing mode."""
    growth = filled(data["wave_growth"])
    i = int(np.nanargmax(growth))
    z = 1e3 * filled(data["wave_layer_z"])
    phase = np.linspace(0.0, 2.0 * np.pi, 65)
    shape = filled(data["wave_u_real"])[i] + 1j * filled(data["wave_u_imag"])[i]
    field = np.real(shape[:, None] * np.exp(1j * phase)[None, :])
    mesh = axes.pcolormesh(phase / (2.0 * np.pi), z, field, cmap="RdBu_r", vmin=-1, vmax=1, shading="gouraud")
    axes.plot(0.5 + 0.5 * filled(data["wave_layer_speed"]) / np.nanmax(np.abs(filled(data["wave_layer_speed"]))), z, color="black",
              linewidth=1.0, label="speed of the steady state")
    axes.set_xlabel("x over the wavelength")
    axes.set_ylabel("z [mm]")
    axes.legend(loc="lower right", fontsize=8, frameon=True)
    figure.colorbar(mesh, ax=axes, label="u of the mode")
    look.label(axes, number, f"mode of {1e3 * filled(data['wave_length'])[i]:.3g} mm, {growth[i]:.3g} 1/s")


def spectrum(axes, data, number):
    growth, frequency = filled(data["mode_growth"]), filled(data["mode_frequency"])
    axes.scatter(growth, np.abs(frequency), s=22, color=np.where(growth > 0.0, look.ACCENT, look.BLUE))
    axes.axvline(0.0, color=look.FAINT, linewidth=0.8)
    axes.set_xscale("symlog", linthresh=0.01)
    axes.set_yscale("symlog", linthresh=0.01)
    axes.set_xlabel("growth rate [1/s]")
    axes.set_ylabel("frequency [rad/s]")
    look.grid(axes)
    look.label(axes, number, "modes of the steady state")


def mode_field(figure, axes, data, number, mode):
    x, z = filled(data["mode_x"]), 1e3 * filled(data["mode_z"])
    field = filled(data["mode_u_real"])[mode]
    mesh = axes.pcolormesh(np.broadcast_to(1e3 * x, z.shape), z, field, cmap="RdBu_r", vmin=-1, vmax=1, shading="gouraud")
    axes.plot(1e3 * x, 1e3 * filled(data["mode_base_height"]), color="black", linewidth=1.0)
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("z [mm]")
    figure.colorbar(mesh, ax=axes, label="u of the mode")
    look.label(axes, number, f"mode {mode}: {filled(data['mode_growth'])[mode]:.3g} 1/s, {abs(filled(data['mode_frequency'])[mode]):.3g} rad/s")


def courses(axes, data, number, row):
    """A disturbance on each grid in units of its mode's time; what is not fitted, faint."""
    for i, colour in enumerate(look.sequence_colours(len(data.dimensions["growth_grid"]))):
        at = lambda name: filled(data[f"growth_{name}"])[row, i]
        unit = abs(at("predicted"))
        axes.plot(at("time") * unit, at("amplitude"), color=colour, linewidth=1.0, alpha=0.5)
        axes.plot(at("time") * unit, at("others"), color=colour, linewidth=0.8, linestyle=":")
        inside = (at("time") >= at("from")) & (at("time") <= at("to"))
        fitted = np.isfinite(at("rate"))
        rate = f"{at('rate'):.4g} 1/s" if fitted else "no rate"
        axes.plot(at("time")[inside] * unit, at("amplitude")[inside], color=colour, linewidth=2.0 if fitted else 1.0,
                  label=f"{at('columns'):.0f}x{at('layers'):.0f}: {rate}, modes {at('predicted'):.4g}")
    axes.set_yscale("log")
    # Waves that nothing disturbed begin at zero.
    amplitude = filled(data["growth_amplitude"])[row]
    if np.any(amplitude > 0.0):
        axes.set_ylim(bottom=0.01 * np.nanmin(amplitude[amplitude > 0.0]))
    axes.set_xlabel("time over that of the fastest disturbed mode")
    axes.set_ylabel("rms of u [m/s]")
    axes.legend(loc="best", fontsize=8, frameon=True)
    look.grid(axes)
    words = data["growth_verdict"].flag_meanings.split()[int(data["growth_verdict"][row])].replace("_", " ")
    exponent = float(filled(data["growth_exponent"])[row])
    words += f" as k^{exponent:.2f}" if words == "blows up" else ""
    look.label(axes, number, f"{data['growth_name'][row]}: {words} (solid: fitted; dotted: other waves)")


def rates(axes, data, number):
    """Fitted rates over grids, against those of the modes."""
    layers = filled(data["growth_layers"])
    names = data["growth_name"][:]
    for row, colour in enumerate((look.BLUE, look.ORANGE, look.GREEN, look.ACCENT, *look.sequence_colours(max(0, len(names) - 4)))[:len(names)]):
        axes.errorbar(layers[row], filled(data["growth_rate"])[row], yerr=filled(data["growth_uncertainty"])[row], fmt="o", color=colour, markersize=5,
                      capsize=3, label=names[row])
        axes.plot(layers[row], filled(data["growth_predicted"])[row], "--", color=colour, linewidth=1.0)
    axes.set_xscale("log", base=2)
    axes.set_xticks(layers[0], [f"{c:.0f}x{n:.0f}" for c, n in zip(filled(data["growth_columns"])[0], layers[0])])
    axes.axhline(0.0, color=look.FAINT, linewidth=0.8)
    axes.set_yscale("symlog", linthresh=10.0 ** np.ceil(np.log10(0.01 * np.nanmax(np.abs(filled(data["growth_predicted"]))))))
    axes.set_xlabel("cells")
    axes.set_ylabel("growth rate [1/s]")
    axes.legend(loc="best", fontsize=8, frameon=True)
    look.grid(axes)
    look.label(axes, number, "growth rates in time; dashed: of the grid's modes")


def draw(data, folder):
    panels = []
    if "symbol_I" in data.variables:
        panels += [growth_map, lambda f, a, d: against_closed_form(a, d), lambda f, a, d: hidden(a, d)]
    if "wave_length" in data.variables:
        panels += [lambda f, a, d, n=len(panels): dispersion(a, d, n), lambda f, a, d, n=len(panels) + 1: wave_field(f, a, d, n)]
    if "growth_rate" in data.variables:
        for row in range(len(data.dimensions["growth_disturbance"])):
            panels.append(lambda f, a, d, n=len(panels), row=row: courses(a, d, n, row))
        panels.append(lambda f, a, d, n=len(panels): rates(a, d, n))
    if "mode_growth" in data.variables:
        n = len(panels)
        panels.append(lambda f, a, d, n=n: spectrum(a, d, n))
        for mode in range(min(2, len(data.dimensions["kept_mode"]))):
            panels.append(lambda f, a, d, n=n, mode=mode: mode_field(f, a, d, n + 1 + mode, mode))
    n_across = min(2, len(panels))
    rows = (len(panels) + n_across - 1) // n_across
    figure = plt.figure(figsize=(14 if n_across > 1 else 11, 4.6 * rows + 1.0))
    grid = figure.add_gridspec(rows, n_across)
    for i, panel in enumerate(panels):
        panel(figure, figure.add_subplot(grid[i // n_across, i % n_across]), data)
    words = [part for line in data.verdict.split("\n") for part in textwrap.wrap(line, 150)]
    figure.suptitle(data.title + "\n" + "\n".join(words), fontsize=10)
    return look.save(figure, folder, "study.png")
