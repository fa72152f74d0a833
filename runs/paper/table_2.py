"""Table 2: slopes of the heap at the three experimental inflows, and what else the table's parameters fix. No picture."""

import math

import reproduction
from comparison import Row, compare
from figure_9 import EXPERIMENT, MATERIAL

PRINTED = {0.0020: "43.3769", 0.0046: "47.9899", 0.0060: "49.5276"}   # kg/s: degree, figure 10; the table keeps two decimals
REASON = "does not follow from the printed parameters: factor_1_15.md"


def draw(talus, _):
    exact = talus.steady(MATERIAL, Q=list(PRINTED)).flows
    printed = talus.steady(MATERIAL, zeta=[float(text) for text in PRINTED.values()]).flows
    I_N = talus.law(MATERIAL, "classical").neutral[0]
    rows = [compare("table 2, figure 10", f"slope at {1e3 * Q:.1f} g/s", text, flow.zeta, "deg", REASON, digits=6)
            for (Q, text), flow in zip(PRINTED.items(), exact)]
    rows += [compare("table 2, figure 10", f"flow at {text} deg", f"{1e3 * Q:.1f}", 1e3 * flow.Q, "g/s", REASON)
             for (Q, text), flow in zip(PRINTED.items(), printed)]
    return [], [
        *rows,
        Row("section 4.3", "slopes less the measured ones", f"within 1.5 deg; its own numbers: {off(float(text) for text in PRINTED.values())}",
            off(flow.zeta for flow in exact) + " deg", "not the first", "nor in the print: +1.75"),
        compare("table 2", "I_N, lower neutral point of the classical law", "0.05178", I_N, digits=7),
        compare("section 4.3", "tan 22 deg", "0.4", math.tan(math.radians(22.0))),
        Row("figures 6(c), 7", "measured slope at 4.6 g/s", "49.34 and 49.35 deg", "48.9 + 0.44 = 49.34", "0.01", "two roundings in the print"),
    ]


def off(slopes):
    """Slopes less the measured ones, in words."""
    return ", ".join(f"{slope - measured:+.2f}" for slope, measured in zip(slopes, EXPERIMENT.values()))


if __name__ == "__main__":
    reproduction.main(draw)
