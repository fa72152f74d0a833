"""How all pictures look: fonts, colours, panels and the way they are saved."""

import string

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

INK = "#222222"
FAINT = "#9a9a9a"
GRAINS = "#e9dfc7"
ACCENT = "#c2410c"   # the paper's numbers and the exact solution's rivals
BLUE, ORANGE, GREEN, PURPLE = "#1f5fa8", "#d1731f", "#2e8b57", "#7b4fa3"

plt.rcParams.update({
    "figure.facecolor": "white", "axes.facecolor": "white", "savefig.dpi": 130,
    "font.size": 11, "axes.titlesize": 12, "axes.labelsize": 11, "legend.fontsize": 10,
    "xtick.labelsize": 10, "ytick.labelsize": 10, "figure.titlesize": 14,
    "axes.spines.top": False, "axes.spines.right": False, "axes.edgecolor": INK, "axes.linewidth": 0.8,
    "legend.frameon": False, "lines.linewidth": 1.6, "image.cmap": "viridis", "figure.constrained_layout.use": True,
})


def sequence_colours(n, name="viridis"):
    """n distinct colours in order, the palest end of the map left out."""
    return [plt.get_cmap(name)(v) for v in np.linspace(0.0, 0.88, max(n, 2))][:n]


def label(axes, number, text):
    """Title at the left: '(a) text'."""
    axes.set_title(f"({string.ascii_lowercase[number]})  {text}", loc="left")


def grid(axes):
    axes.grid(True, color="#e6e6e6", linewidth=0.7)
    axes.set_axisbelow(True)


def seconds(t):
    """A time in words, without digits that mean nothing."""
    return f"{t:.3g} s" if t < 10.0 else f"{t:.1f} s".replace(".0 s", " s")


def save(figure, folder, name):
    path = folder / name
    figure.savefig(path)
    plt.close(figure)
    return path
