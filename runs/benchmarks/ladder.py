"""The heap of heap_q46 on every rung: error of its slope and of its stored mass at 150 s against CPU time, from the summaries of finished
runs. With --run, rungs that are missing are run first, but for the two_fluid ones of more than a CPU minute, whose commands are printed.
"""

import argparse
import json
import pathlib
import resource
import subprocess

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAP = "runs/examples/heap_q46.toml"
TWO_FLUID = "runs/benchmarks/two_fluid_heap.toml"
STEADY = 150.0  # s, when the inflow ends
EXACT = 48.8126  # degree, of the printed parameters
PAPER_MASS = 0.175  # kg, figure 12 at 150 s read as kilograms
REFERENCE = "300x32"  # whose mass the others are measured by


def grid(columns, layers, *settings):
    return HEAP, [f"grid.columns={columns}", f"grid.layers={layers}", *settings]


# rung -> name of the run -> scene and settings
RUNS = {
    "triangle": {"triangle": (HEAP, ["model.name=triangle"])},
    "layer": {
        "draft 60x8": grid(60, 8, "integrator.rtol=3e-4"),
        "60x16": grid(60, 16),
        "standard 150x16": grid(150, 16),
        "150x32": grid(150, 32),
        "300x32": grid(300, 32),
    },
    "two_fluid": {
        "20 mm": (TWO_FLUID, ["grid.columns=30", "grid.layers=15"]),
        "10 mm": (TWO_FLUID, []),
        "5 mm": (TWO_FLUID, ["grid.columns=120", "grid.layers=60"]),
        "2.5 mm": (TWO_FLUID, ["grid.columns=240", "grid.layers=120"]),
    },
}
DEAR = {"5 mm", "2.5 mm"}  # minutes of CPU time
# CPU hours for 320 s of the paper's method (explicit, OpenFOAM), extrapolated from a preformed heap: seconds of CPU time a simulated
# second times 320. Its slope and mass on these grids are not known; what is known of its error is written beside.
PEER = [
    ("5 mm, cap 100 Pa s", 36 * 320, ""),
    ("2.5 mm, cap 100 Pa s", 650 * 320, "speeds with caps of 10 and 100 Pa s\ndiffer by 55 % after 1 s"),
    ("2.5 mm, cap 1000 Pa s", 7100 * 320, ""),
    ("1.25 mm, cap 100 Pa s", 25600 * 320, ""),
]
MARKS = {"triangle": "v", "layer": "o", "two_fluid": "s"}


def folder_of(out, rung, name):
    return out / f"{rung}_{name.replace(',', '').replace(' ', '_')}"


def command(scene, settings, folder):
    line = ["build/release/talus", "run", scene, "--out", str(folder)]
    for setting in settings:
        line += ["--set", setting]
    return line


def summary_of(folder):
    path = folder / "summary.json"
    summary = json.loads(path.read_text()) if path.exists() else None
    return summary if summary and summary["status"] == "finished" else None


def read(out, run):
    """(rung, name) -> CPU seconds, slope [degree], stored mass without the film [kg]; of finished runs."""
    found = {}
    for rung, runs in RUNS.items():
        for name, (scene, settings) in runs.items():
            folder = folder_of(out, rung, name)
            line = command(scene, settings, folder)
            if summary_of(folder) is None:
                if not run or name in DEAR:
                    print("missing:", " ".join(line))
                    continue
                subprocess.run(line, cwd=ROOT, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            summary = summary_of(folder)
            last = summary["final"]
            record = next(r for r in [*summary["records"], last] if abs(r["time"] - STEADY) < 1e-6)
            film = last["mass_stored"] - last["mass_inflow"] + sum(v for key, v in last.items() if key.startswith("mass_outflow"))
            found[rung, name] = summary["cpu_seconds"], record["heap_angle"], record["mass_stored"] - film
    return found


def steady_seconds():
    """CPU seconds of the exact steady flow: the whole program, start to end."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(["build/release/talus", "steady", HEAP, "--Q", "0.0046"], cwd=ROOT, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def draw(axes, points, title, unit):
    lowest = min(error for _, _, _, error in points) / 3.0
    for rung in RUNS:
        mine = [(cpu, error, name) for r, name, cpu, error in points if r == rung]
        axes.loglog([p[0] for p in mine], [p[1] for p in mine], MARKS[rung] + "-", label=rung)
        for cpu, error, name in mine:
            # The layer's points lie closest to others, which have their names above them.
            place, side = ((-5, -10), "right") if rung == "layer" and name != mine[-1][2] else ((5, -10 if rung == "layer" else 5), "left")
            axes.annotate(name, (cpu, error), textcoords="offset points", xytext=place, ha=side, fontsize=7)
    for name, seconds, known in PEER:
        axes.axvline(seconds, color="grey", linestyle=":", linewidth=1)
        axes.annotate(f"peer, {name}" + (f"\n{known}" if known else ""), (seconds, lowest), rotation=90, fontsize=6, color="dimgrey",
                      va="bottom", ha="right")
    axes.set(xlabel="CPU time of the whole event, 320 s [s]", ylabel=f"{title} [{unit}]", ylim=(lowest, None))
    axes.grid(alpha=0.3)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/ladder", help="folder of the runs")
    parser.add_argument("--run", action="store_true", help="run what is missing")
    parser.add_argument("--picture", type=pathlib.Path, default=ROOT / "runs/benchmarks/ladder.png")
    choice = parser.parse_args()
    found = read(choice.out, choice.run)
    reference = found["layer", REFERENCE][2]
    print("| rung | run | CPU [s] | slope at 150 s [deg] | off the exact one | stored at 150 s [kg] | off 300x32 [%] |\n|---|---|---|---|---|---|---|")
    for (rung, name), (cpu, slope, mass) in found.items():
        print(f"| {rung} | {name} | {cpu:.3g} | {slope:.3f} | {slope - EXACT:+.3f} | {mass:.4f} | {100 * (mass / reference - 1):+.2f} |")
    exact_cpu = steady_seconds()
    print(f"| steady | exact | {exact_cpu:.3g} | {EXACT} | 0 | - | - |")
    figure, (left, right) = plt.subplots(1, 2, figsize=(12, 5), layout="constrained")
    draw(left, [(*key, cpu, abs(slope - EXACT)) for key, (cpu, slope, _) in found.items()], "slope at 150 s, off the exact one", "degree")
    left.axvline(exact_cpu, color="tab:red", linewidth=1)
    left.annotate("steady: exact by definition", (exact_cpu, left.get_ylim()[1]), rotation=90, fontsize=7, color="tab:red", va="top", ha="right")
    masses = [(*key, cpu, 100 * abs(mass / reference - 1)) for key, (cpu, _, mass) in found.items() if key != ("layer", REFERENCE)]
    draw(right, masses, f"stored mass at 150 s, off layer {REFERENCE}", "%")
    right.axhline(100 * abs(PAPER_MASS / reference - 1), color="tab:red", linewidth=1)
    right.annotate("the paper, figure 12 read as kg", (1.0, 100 * abs(PAPER_MASS / reference - 1)), fontsize=7, color="tab:red", va="bottom")
    left.legend(frameon=False, loc="lower center")
    figure.suptitle("Heap of 4.6 g/s by every rung. Peer: CPU time extrapolated from some seconds; its slope and mass on these grids are not known")
    figure.savefig(choice.picture, dpi=130)


if __name__ == "__main__":
    main()
