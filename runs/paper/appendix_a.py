"""Appendix A: from deposits on a rough plane to mu_s, mu_d and I_0 of the classical law, and back, for table 1.

The paper prints no beta: 0.136, Pouliquen's (1999) for glass beads, stands in for it."""

import json
import math

import numpy as np

import reproduction
from comparison import Row
from reproduction import look, plt
from talus import HERE

MATERIAL, BETA = "table_1.toml", 0.136
THICKNESS, ZETA = 0.05, 25.0   # m, degree, of the flow that (A4) is checked on


def draw(talus, folder):
    deposits = folder / "deposits.csv"
    law = json.loads(talus.call("hstop", "--law", HERE / MATERIAL, "--beta", BETA, "--zeta", "19:29:0.5", "--csv", deposits, "--json"))
    fit = json.loads(talus.call("hstop", "--data", deposits, "--beta", BETA, "--d", law["d_m"], "--Phi", law["Phi"], "--json"))["law"]
    off = max(abs(fit[name] / value - 1.0) for name, value in law["law"].items())
    flow = talus.steady(MATERIAL, zeta=[ZETA], law="classical", thickness=THICKNESS, sets=["wall.mu_w=0"]).flows[0]
    bagnold = 2.0 * math.sqrt(law["Phi"]) / (5.0 * law["d_m"]) * flow.surface_I
    curve, low, high = law["curve"], *(math.degrees(math.atan(law["law"][name])) for name in ("mu_s", "mu_d"))
    return [draw_curves(talus, folder, deposits, curve, fit)], [
        Row("(A2), (A6)", f"L of table 1's law, with beta = {BETA}", "not given", f"{1e3 * curve['L_m']:.4f} mm = {curve['L_m'] / law['d_m']:.3f} d", "",
            "the paper prints no beta"),
        Row("(A2)", "slopes with a deposit, table 1", "arctan mu_s to arctan mu_d", f"{low:.2f} to {high:.2f} deg", "holds"),
        Row("(A2), (A5), (A6)", "law to deposits to law, by fit: mu_s, mu_d, I_0", "the same", f"within {bound(off)}", "holds"),
        Row("(A4)", f"Fr/h of the exact flow against 2 sqrt(Phi) I/(5 d), {ZETA:g} deg", "the same",
            f"within {bound(abs(flow.froude / THICKNESS / bagnold - 1.0))}", "holds"),
    ]


def draw_curves(talus, folder, deposits, curve, fit):
    """Deposits and their curve (A2); the law that follows from them (A5) beside table 1's."""
    figure, (stops, laws) = plt.subplots(1, 2, figsize=(12.0, 4.8))
    zeta, h_stop = np.loadtxt(deposits, delimiter=",", skiprows=1, usecols=(0, 1)).T
    mu_s, mu_d, L = curve["mu_s"], curve["mu_d"], curve["L_m"]
    fine = np.linspace(zeta[0], zeta[-1], 300)
    tan = np.tan(np.radians(fine))
    stops.plot(fine, 1e3 * L * (mu_d - tan) / (tan - mu_s), color=look.INK, label="(A2)")
    stops.plot(zeta, 1e3 * h_stop, "o", color=look.BLUE, markerfacecolor="white", label="deposits that talus hstop lists")
    stops.set(xlabel=r"$\zeta$ [degree]", ylabel="h$_{stop}$ [mm]", yscale="log")
    stops.legend()
    I = np.logspace(-4.0, 1.0, 200)
    laws.semilogx(I, talus.friction(MATERIAL, "classical", I)["mu"], color=look.ACCENT, label="classical law, table 1")
    some = I[::12]
    laws.plot(some, fit["mu_s"] + (fit["mu_d"] - fit["mu_s"]) / (fit["I_0"] / some + 1.0), "o", color=look.BLUE, markerfacecolor="white", label="(A5), (A6) from the deposits")
    laws.set(xlabel="I", ylabel=r"$\mu$")
    laws.legend(loc="upper left")
    for number, (axes, words) in enumerate(((stops, "deposits on a rough plane"), (laws, "the law from them"))):
        look.label(axes, number, words)
        look.grid(axes)
    return reproduction.save(figure, folder, "appendix_a.png")


def bound(number):
    """The next power of ten above a number, in words."""
    return f"1e{math.ceil(math.log10(max(number, 1e-12)))}"


if __name__ == "__main__":
    reproduction.main(draw)
