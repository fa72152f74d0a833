"""Draws what the cap eta_max costs an explicit method and BDF: steps of a column from rest, from the last result that bench.py stored."""

import argparse
import json
import pathlib
import re

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("result", type=pathlib.Path, help="a JSON file of bench.py")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "runs/benchmarks/stiffness.png")
    arguments = parser.parse_args()
    series = {}
    for name, figure in json.loads(arguments.result.read_text()).items():
        if found := re.fullmatch(r"column, (.*), eta_max 1e/(\d+)", name):
            series.setdefault(found.group(1), []).append((10.0 ** int(found.group(2)), figure["steps"], 1e3 * figure["cpu_s"]))
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    print("| method | eta_max [Pa s] | steps | CPU [ms] |\n|---|---|---|---|")
    for label, points in series.items():
        points.sort()
        for eta, steps, cpu in points:
            print(f"| {label} | {eta:.0e} | {steps:.0f} | {cpu:.3g} |")
        for axes, column in ((left, 1), (right, 2)):
            axes.loglog([p[0] for p in points], [p[column] for p in points], "o-", label=label)
    left.set(xlabel="eta_max [Pa s]", ylabel="steps for 0.25 s")
    right.set(xlabel="eta_max [Pa s]", ylabel="CPU time [ms]")
    left.legend(frameon=False)
    for axes in (left, right):
        axes.grid(alpha=0.3)
    figure.savefig(arguments.out, dpi=130)


if __name__ == "__main__":
    main()
