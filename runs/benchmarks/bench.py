"""Times kernels and whole scenes, stores the result as JSON, and prints each figure beside its ratio to the last stored one of this machine.

CPU times are the least of some repetitions (kernels) or of one run (scenes): on a busy machine they scatter by a third, counts do not.
"""

import argparse
import datetime
import json
import math
import os
import pathlib
import re
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
KERNELS = ["dual", "layer", "sparse_pattern", "stiffness"]
SHORT = {"inflow.stop": 0.9, "output.times": "[]", "time.end": 1.0}
SCENES = {
    "column from rest, 2 s": ("chute_periodic", {"model.name": "column"}),
    "heap 60x16, 320 s": ("heap_q46", {"grid.columns": 60, "grid.layers": 16}),
    "heap 150x16, 320 s": ("heap_q46", {"grid.columns": 150, "grid.layers": 16}),
    "heap 300x32, first second": ("heap_q46", SHORT),
}
GROWTH = [75, 150, 300, 600, 1200]  # columns of 16 layers, for one second
GRIDS = [(75, 8), (150, 16), (300, 32)]  # columns and layers, for the whole event


def machine():
    """The processor and the number of cores: what makes two results comparable."""
    model = re.search(r"model name\s*:\s*(.*)", pathlib.Path("/proc/cpuinfo").read_text())
    return re.sub(r"\W+", "_", f"{model.group(1) if model else 'unknown'} {os.cpu_count()} cores").strip("_")


def kernels(build):
    figures = {}
    for name in KERNELS:
        command = [build / f"tests/bench_{name}", "--benchmark_format=json", "--benchmark_min_time=0.1", "--benchmark_repetitions=5"]
        for b in json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["benchmarks"]:
            if b["run_type"] != "iteration":
                continue
            figure = figures.setdefault(b["name"].split("/iterations")[0].removesuffix("/process_time"), {})
            scale = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3}[b["time_unit"]]
            figure["cpu_s"] = min(figure.get("cpu_s", math.inf), b["cpu_time"] * scale)
            figure |= {key: b[key] for key in ("steps", "residuals") if key in b}
    return figures


def scene(build, name, settings):
    with tempfile.TemporaryDirectory() as folder:
        command = [build / "talus", "run", ROOT / f"runs/examples/{name}.toml", "--out", pathlib.Path(folder) / "run"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise SystemExit(f"{name}: {done.stderr[-2000:]}")
        summary = json.loads((pathlib.Path(folder) / "run/summary.json").read_text())
    s = summary["statistics"]
    calls = {"residual": "residuals", "jacobian": "jacobians", "factor": "factorisations", "solve": "solves"}
    parts = {f"{part}_ms": 1e3 * s[f"cpu_{part}"] / s[count] for part, count in calls.items() if s[count]}
    return {"cpu_s": summary["cpu_seconds"], "wall_s": summary["wall_seconds"], "memory_MB": summary["peak_memory_bytes"] / 1e6,
            "steps": s["steps"], "newton_failures": s["newton_failures"], "factorisations": s["factorisations"], "solves": s["solves"]} | parts


def exponent(cells, seconds):
    """Of seconds against cells: the slope of a straight line through the logarithms."""
    x, y = [math.log(n) for n in cells], [math.log(t) for t in seconds]
    mean_x, mean_y = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mean_x) * (b - mean_y) for a, b in zip(x, y)) / sum((a - mean_x) ** 2 for a in x)


def growth(build):
    """What heaps cost on more and more cells: the whole event refined both ways, and a first second with more columns alone."""
    figures = {}
    for what, grids, settings in (("320 s", GRIDS, {}), ("first second", [(n, 16) for n in GROWTH], SHORT)):
        runs = {grid: scene(build, "heap_q46", settings | {"grid.columns": grid[0], "grid.layers": grid[1]}) for grid in grids}
        figures |= {f"heap {n}x{m}, {what}": run for (n, m), run in runs.items()}
        for per in ("", " and step"):
            seconds = [run["cpu_s"] / (run["steps"] if per else 1) for run in runs.values()]
            fit = exponent([n * m for n, m in grids], seconds)
            print(f"heap, {what}, {grids[0][0]}x{grids[0][1]} to {grids[-1][0]}x{grids[-1][1]}: CPU time{per} grows as cells to the power {fit:.2f}", flush=True)
    return figures


def show(figures, last):
    for name, figure in figures.items():
        cells = []
        for key, value in figure.items():
            before = last.get(name, {}).get(key)
            cells.append(f"{key} {value:.4g}" + (f" ({value / before:.2f})" if before else ""))
        print(f"{name}: " + ", ".join(cells))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="where talus and the benchmarks were built")
    parser.add_argument("--out", type=pathlib.Path, default=ROOT / "out/bench", help="where results are stored, a folder a machine")
    parser.add_argument("--growth", action="store_true", help="also heaps on more and more cells (minutes)")
    parser.add_argument("--scenes", action="store_true", help="only scenes, no kernels")
    arguments = parser.parse_args()
    folder = arguments.out / machine()
    stored = sorted(folder.glob("*.json"))
    last = json.loads(stored[-1].read_text()) if stored else {}
    print("ratios to " + stored[-1].name if stored else "no earlier result of this machine", flush=True)
    figures = {} if arguments.scenes else kernels(arguments.build)
    for name, (example, settings) in SCENES.items():
        figures[name] = scene(arguments.build, example, settings)
    if arguments.growth:
        figures |= growth(arguments.build)
    show(figures, last)
    folder.mkdir(parents=True, exist_ok=True)
    path = folder / f"{datetime.datetime.now(datetime.timezone.utc):%Y-%m-%dT%H-%M-%S}.json"
    path.write_text(json.dumps(figures, indent=1) + "\n")
    print(f"stored in {path}")


if __name__ == "__main__":
    main()
