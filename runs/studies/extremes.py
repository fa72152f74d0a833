"""Each parameter of three scenes to its extremes, one at a time, and how each run ends: right, wrong, refused or failed.

Right: finished, and equal to what is known without the run. column, after 1000 s: the steady state that KINSOL finds without a way
through time, within 1 %
of the speed in the top layer. chute, the periodic layer: the column at the same time, likewise (with rtol above 1 %, within that).
heap: mass poured, gone and stored, within 1e-8. Refused: exit 2 with the key. Failed, placed: exit 6 with the place of the trouble.
Wrong, too long (CPU time), bad: anything else, as NaN or a crash. Leaves extremes.csv and extremes.png, with --keep beside this file.
"""

import argparse
import csv
import math
import pathlib
import re
import signal

import netCDF4
import numpy as np
from extremes_map import draw
from short_runs import ROOT, run_all

HERE = pathlib.Path(__file__).resolve().parent
QUIET = {"output.times": []}
SCENES = {
    "column": ("chute_periodic", {"model.name": "column", "grid.layers": 64, "time.end": 1000.0, "output.series_interval": 1000.0, **QUIET}),
    "chute": ("chute_periodic", {"model.name": "layer", "grid.columns": 4, "grid.layers": 24, "time.end": 2.0, "output.series_interval": 0.5, **QUIET}),
    "heap": ("heap_q46", {"grid.columns": 30, "grid.layers": 8, "time.end": 5.0, "inflow.stop": 4.0, "output.series_interval": 0.5,
                          "integrator.linear_solver": "automatic", **QUIET}),
}
# What turns a scene into the one that it is compared with.
CHECK = {"column": {"integrator.method": "steady"}, "chute": {"model.name": "column"}}
ALL, UNIFORM, HEAP, LAYERS = tuple(SCENES), ("column", "chute"), ("heap",), ("chute", "heap")


def scaled(scene, factor):
    """Lengths of a scene by one factor, so that the box still holds its layer."""
    lengths = {"chute_periodic": {"box.length": 0.02, "box.height": 0.05, "model.initial_thickness": 0.012, "grid.cluster_depth": 0.01}}
    return {key: value * factor for key, value in lengths[scene].items()}


def decades(key, first, last, step=2):
    return [(f"1e{e}", {key: f"1e{e}"}) for e in range(first, last + 1, step)]


def tolerances(rtol):
    return {"integrator.rtol": rtol, "integrator.atol_velocity": 0.1 * rtol, "integrator.atol_pressure": 1e3 * rtol,
            "integrator.atol_height": 1e-2 * rtol}


def on_and_off(last, period=1.0):
    changes = range(1, int(last / period))
    return {"inflow.times": [i * period for i in changes], "inflow.shares": [(i + 1) % 2 for i in changes]}


# What is varied: name, unit, scenes, [(label, settings)].
DESIGN = [
    ("as it stands", "", ALL, [("", {})]),
    ("eta_max", "Pa s", ALL, decades("rheology.eta_max", -2, 12)),
    ("p_0", "Pa", ALL, decades("rheology.p_0", -6, 3, 3)),
    ("u_c", "m/s", ALL, decades("wall.u_c", -8, 0)),
    ("rtol", "1", ALL, [(f"1e{e}", tolerances(10.0 ** e)) for e in range(-11, 0, 2)]),
    ("max_order", "", ALL, [(k, {"integrator.max_order": k}) for k in (1, 2, 3, 4, 5)]),
    ("tilt", "degree", UNIFORM, [(a, {"box.tilt": a}) for a in (0, 21.8, 60, 89)]),
    ("tilt", "degree", HEAP, [(a, {"box.tilt": a}) for a in (0, 21.8, 60)] + [("89", {"box.tilt": 89, "inflow.along_gravity": "false"})]),
    ("gap W", "m", ALL, decades("box.gap", -4, 2)),
    ("d", "m", ALL, decades("grains.d", -6, -1, 1)),
    ("g", "m/s2", ALL, [(v, {"box.gravity": v}) for v in ("1e-3", "1e3")]),
    ("rho_star", "x", ALL, [("1e-6", {"grains.rho_star": 2500e-6}), ("1e6", {"grains.rho_star": 2500e6})]),
    ("rho_star, eta_max, p_0", "x", ALL, [("1e6", {"grains.rho_star": 2500e6, "rheology.eta_max": 1e9, "rheology.p_0": 1e4,
                                           "integrator.atol_pressure": 1e5})]),
    ("layers", "", UNIFORM, [(n, {"grid.layers": n}) for n in (1, 2, 3, 400)]),
    ("columns", "", LAYERS, [(n, {"grid.columns": n}) for n in (1, 2)] + [("2000", {"grid.columns": 2000, "grid.layers": 4, "time.end": 0.2, "output.series_interval": 0.2})]),
    ("one column, two layers", "", LAYERS, [("", {"grid.columns": 1, "grid.layers": 2})]),
    ("Q", "kg/s", HEAP, [("0", {"inflow.rate": 0}), ("1e-6", {"inflow.rate": "1e-6"}), ("0.1", {"inflow.rate": "0.1"}), ("1", {"inflow.rate": "1"})]),
    ("Q jumps", "", HEAP, [("0.2 s", {"inflow.times": [1, 2], "inflow.shares": [0.1, 3]}),
                           ("1 ms", {"inflow.times": [1, 2], "inflow.shares": [0.1, 3], "inflow.ramp": 1e-3})]),
    ("Q on and off", "", HEAP, [("every s", on_and_off(5.0))]),
    ("box full", "m", HEAP, [("0.29", {"model.initial_thickness": 0.29}), ("0.3", {"model.initial_thickness": 0.3})]),
    ("film", "m", HEAP, [("1e-6", {"model.film": "1e-6"}), ("1e-2", {"model.film": "1e-2"}), ("0.2", {"model.film": "0.2"})]),
    ("thickness", "m", UNIFORM, [("6e-4", {"model.initial_thickness": 6e-4}), ("0.049", {"model.initial_thickness": 0.049})]),
    ("all lengths of the box", "x", UNIFORM, [("0.01", {**scaled("chute_periodic", 0.01), "model.film": "5e-6"}), ("1000", scaled("chute_periodic", 1000.0))]),
    ("jet's width", "m", HEAP, [("1e-4", {"inflow.width": "1e-4"}), ("0.03", {"inflow.width": 0.03})]),
    ("mu_w", "1", ALL, [("0", {"wall.mu_w": 0}), ("100", {"wall.mu_w": 100})]),
]


def top_speed(result):
    """The last one in the top layer [m/s], fastest along x; None where the run did not finish."""
    if not result.finished():
        return None
    with netCDF4.Dataset(result.folder / "run.nc") as run:
        return float(np.max(run["u"][-1][-1]))


def cases():
    for name, unit, scenes, values in DESIGN:
        for scene in scenes:
            for label, settings in values:
                example, base = SCENES[scene]
                merged = {**base, **settings}
                yield scene, name, unit, str(label), (example, {k: v for k, v in merged.items() if v is not None})


def finite(summary):
    return all(math.isfinite(v) for v in summary["final"].values() if isinstance(v, (int, float)))


def off_by(scene, result, reference, rtol):
    """Error of a finished run against what is known, how large it may be, and what it is of."""
    if scene == "heap":
        last = result.summary["final"]
        return abs(last["mass_error"]) / max(last["mass_stored"], last["mass_inflow"]), 1e-8, "mass"
    if reference is None:
        return math.inf, 0.0, "nothing to compare: "
    # Slower than a hundredth of the absolute tolerance is rest.
    return abs(top_speed(result) - reference) / max(abs(reference), 1e-7), max(0.01, rtol), "speed"


def verdict(scene, result, reference, rtol):
    """Outcome, error, and the words that tell the user what is wrong."""
    last_words = next((line for line in result.said.splitlines() if line.startswith("talus:")), "").replace(f"{ROOT}/", "")
    if result.code == 2:
        return ("refused" if re.search(r"[a-z_]+\.[a-zA-Z_0-9]+:", result.said) else "bad"), "", last_words
    if result.code == 6:
        placed = re.search(r"(layer|column|face|interface) \d+|H of|mass", result.said)
        return ("failed, placed" if placed else "bad"), "", last_words
    if result.code in (-signal.SIGXCPU, -signal.SIGKILL):
        return "too long", "", "more CPU time than allowed"
    if not result.finished() or not finite(result.summary):
        return "bad", "", last_words
    error, allowed, what = off_by(scene, result, reference, rtol)
    return ("right" if error <= allowed else "wrong"), f"{what} {error:.1e}", ""


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--jobs", type=int, default=2, help="runs at once")
    arguments.add_argument("--limit", type=int, default=60, help="CPU time of one run [s]")
    arguments.add_argument("--only", default="", help="names of factors that contain this")
    arguments.add_argument("--program", type=pathlib.Path, default=ROOT / "build/release/talus", help="talus")
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "out/extremes", help="folder of table and picture; --keep: beside this file")
    arguments.add_argument("--keep", action="store_true", help="leave them beside this file")
    choice = arguments.parse_args()
    out = HERE if choice.keep else choice.out
    out.mkdir(parents=True, exist_ok=True)
    design = [c for c in cases() if choice.only in c[1]]
    more = {"limit": choice.limit, "program": choice.program.resolve()}
    checks = [(example, {**settings, **CHECK[scene]}) for scene, *_, (example, settings) in design if scene in CHECK]
    references = run_all(checks, choice.jobs, **more)
    known = [top_speed(next(references)) if scene in CHECK else None for scene, *_ in design]
    rows = []
    for (scene, name, unit, label, case), reference, result in zip(design, known, run_all([c[-1] for c in design], choice.jobs, **more)):
        outcome, error, words = verdict(scene, result, reference, float(case[1].get("integrator.rtol", 0.0)))
        rows.append({"scene": scene, "factor": name, "unit": unit, "value": label, "outcome": outcome, "exit": result.code, "error": error,
                     **{key: result.count(key) for key in ("steps", "newton_failures", "error_test_failures", "factorisations")}, "words": words})
        print(f"{scene:7} {name} {label} {unit}: {outcome} {error} {words}", flush=True)
    with (out / "extremes.csv").open("w", newline="") as file:
        table = csv.DictWriter(file, rows[0].keys(), lineterminator="\n")
        table.writeheader()
        table.writerows(rows)
    draw(rows, out / "extremes.png")


if __name__ == "__main__":
    main()
