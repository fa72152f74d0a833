"""Appendix A: from deposits on a rough plane to mu_s, mu_d and I_0 of the classical law, and back, for table 1. No picture.

The paper prints no beta: 0.136, Pouliquen's (1999) for glass beads, stands in for it."""

import json
import math

import reproduction
from comparison import Row
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
    return [], [
        Row("(A2), (A6)", f"L of table 1's law, with beta = {BETA}", "not given", f"{1e3 * curve['L_m']:.4f} mm = {curve['L_m'] / law['d_m']:.3f} d", "",
            "the paper prints no beta"),
        Row("(A2)", "slopes with a deposit, table 1", "arctan mu_s to arctan mu_d", f"{low:.2f} to {high:.2f} deg", "holds"),
        Row("(A2), (A5), (A6)", "law to deposits to law, by fit: mu_s, mu_d, I_0", "the same", f"within {bound(off)}", "holds"),
        Row("(A4)", f"Fr/h of the exact flow against 2 sqrt(Phi) I/(5 d), {ZETA:g} deg", "the same",
            f"within {bound(abs(flow.froude / THICKNESS / bagnold - 1.0))}", "holds"),
    ]


def bound(number):
    """The next power of ten above a number, in words."""
    return f"1e{math.ceil(math.log10(max(number, 1e-12)))}"


if __name__ == "__main__":
    reproduction.main(draw)
