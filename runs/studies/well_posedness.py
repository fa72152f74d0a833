"""Where is mu(I) ill-posed: the paper's criterion C > 0 (3.18) against growth of short waves by linear theory, both laws, tables 1 and 2.

Draws well_posedness.png and prints where the two part. The numbers are the program's, `talus rheology`.
"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src/plot"))

import matplotlib.pyplot as plt
import numpy as np

import look

TABLES = {"table 1": "runs/paper/table_1.toml", "table 2": "runs/paper/table_2.toml"}
LAWS = {"classical": "classical", "partially_regularised": "partially regularised"}
CLASSES = {"ill_posed": ("#e8b4a6", "short waves grow"), "damped": ("#f3e3b3", "C > 0, but they decay"), "well_posed": ("#dbe9dc", "C <= 0")}


def ask(talus, file, inertial_numbers):
    done = subprocess.run([talus, "rheology", ROOT / file, "--law", ",".join(LAWS), "--I", inertial_numbers, "--json"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr)
    return json.loads(done.stdout)["laws"]


def values(law, name):
    return np.array([np.nan if v is None else v for v in law["points"][name]["values"]], dtype=float)


def inside(ranges, I):
    """Whether each I lies in one of the ranges; a range without an end is open."""
    return np.any([(I >= low) & (I <= (np.inf if high is None else high)) for low, high in ranges], axis=0)


def classes(law, I):
    damped, condition = inside(law["well_posed_by_linear_theory"], I), inside(law["well_posed_by_C"], I)
    return np.where(~damped, "ill_posed", np.where(condition, "well_posed", "damped"))


def draw(axes, number, table, law):
    I = values(law, "I")
    q, nu, mu = values(law, "q"), values(law, "nu"), values(law, "mu")
    C = q**2 - 4.0 * nu * (1.0 - nu)
    found = classes(law, I)
    edges = np.concatenate(([I[0]], np.sqrt(I[1:] * I[:-1]), [I[-1]]))
    for name, (colour, _) in CLASSES.items():
        for i in np.nonzero(found == name)[0]:
            axes.axvspan(edges[i], edges[i + 1], color=colour, linewidth=0)
    axes.plot(I, C, color=look.BLUE, label="C of (3.18)")
    axes.plot(I, np.clip(q - 1.0, -2.0, 2.0), color=look.ORANGE, label="q - 1")
    axes.plot(I, nu, color=look.GREEN, label=r"$\nu = I\mu'/\mu$")
    axes.axhline(0.0, color=look.INK, linewidth=0.8)
    axes.axhline(0.5, color=look.GREEN, linewidth=0.8, linestyle=":")
    axes.set_xscale("log")
    axes.set_ylim(-1.3, 1.6)
    axes.set_xlim(I[0], I[-1])
    axes.set_xlabel("inertial number I")
    look.label(axes, number, f"{table}, {LAWS[law['law']]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--talus", type=pathlib.Path, default=ROOT / "build/release/talus")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/studies")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    figure, panels = plt.subplots(2, 2, figsize=(13, 8.5), sharex=True)
    number = 0
    print("| table | law | C <= 0 at I | no growth at I |\n|---|---|---|---|")
    for row, (table, file) in zip(panels, TABLES.items()):
        for axes, law in zip(row, ask(options.talus, file, "1e-5:1e3:x801")):
            draw(axes, number, table, law)
            number += 1
            words = ["; ".join(f"{low:.5g} to {'infinity' if high is None else f'{high:.5g}'}" for low, high in law[key])
                     for key in ("well_posed_by_C", "well_posed_by_linear_theory")]
            print(f"| {table} | {LAWS[law['law']]} | {words[0]} | {words[1]} |")
    handles = [plt.Rectangle((0, 0), 1, 1, color=colour, label=words) for colour, words in CLASSES.values()]
    lines, _ = panels[0, 0].get_legend_handles_labels()
    panels[0, 0].legend(handles=handles + lines, loc="upper center", ncols=2, frameon=True, fontsize=8)
    figure.suptitle("Two criteria of well-posedness")
    print(look.save(figure, options.out, "well_posedness.png"))


if __name__ == "__main__":
    main()
