"""What each regularisation and each numerical choice costs a uniform layer: error tables in Markdown, from some eighty short runs.

Errors of the mass flow are relative, in the steady state; errors of the surface speed are the largest at the scene's output times,
the start-up, relative to the steady one. Both against a run in which all that varies is as fine as it goes; the table of cells
against Bagnold's flow in closed form.
"""

import argparse
import json
import math
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENE = ROOT / "runs/examples/chute_periodic.toml"
BASE = {"model.name": "column", "grid.spacing": "uniform", "grid.layers": 400, "rheology.eta_max": 1e6, "rheology.p_0": 0.0,
        "wall.u_c": 1e-3, "integrator.rtol": 1e-8, "integrator.atol_velocity": 1e-10, "integrator.linear_solver": "banded",
        "time.end": 20.0, "output.series_interval": 20.0}
LOOSE = {"integrator.rtol": 1e-4, "integrator.atol_velocity": 1e-6}
WALL = {"integrator.rtol": 1e-6, "integrator.atol_velocity": 1e-8}
PRESSURE = {"rheology.eta_max": 1e4, **LOOSE}
CELLS = [25, 50, 100, 200, 400, 800]


def run(out, settings):
    """A run's summary; a run that is finished in `out` is read, not run again."""
    folder = out / ("_".join(f"{key.split('.')[1]}={value}" for key, value in settings.items() if BASE.get(key) != value) or "base")
    summary = folder / "summary.json"
    if not summary.exists() or json.loads(summary.read_text())["status"] != "finished":
        command = [ROOT / "build/release/talus", "run", SCENE, "--out", folder, "--force"]
        for key, value in settings.items():
            command += ["--set", f"{key}={value}"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if not summary.exists():
            sys.exit(f"{folder.name}: {done.stderr}")
    return json.loads(summary.read_text())


def counts(summary):
    s = summary["statistics"]
    return [s["steps"], s["newton_failures"], s["error_test_failures"], s["factorisations"]]


def errors(summary, reference):
    """Of the steady flow, and of the surface speed on the way."""
    steady = reference["final"]["surface_speed"]
    way = max(abs(a["surface_speed"] - b["surface_speed"]) for a, b in zip(summary["records"], reference["records"]))
    return [f"{summary['final']['mass_flow'] / reference['final']['mass_flow'] - 1.0:+.1e}", f"{way / steady:.1e}"]


def table(title, heads, rows):
    print(f"\n{title}\n\n| " + " | ".join(heads) + " |\n|" + "---|" * len(heads))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |", flush=True)


def outcome(summary, reference):
    if summary["status"] != "finished":
        return ["failed", "", *counts(summary)]
    return [*errors(summary, reference), *counts(summary)]


def vary(out, title, head, key, values, reference, **more):
    rows = ([f"{v:g}" if isinstance(v, float) else v, *outcome(run(out, {**BASE, key: v, **more}), reference)] for v in values)
    table(title, [head, "flow", "surface speed on the way", "steps", "Newton f.", "error f.", "LUs"], rows)


def bagnold(slope, thickness):
    """(surface speed [m/s], flow per width [m2/s]) of Bagnold's flow (B2) down the slope [degree], by `talus steady`."""
    command = [ROOT / "build/release/talus", "steady", SCENE, "--zeta", str(slope), "--thickness", str(thickness), "--set", "wall.mu_w=0", "--json"]
    case = json.loads(subprocess.run(command, capture_output=True, text=True, check=True).stdout)["cases"][0]
    return case["surface_speed_m_s"], case["volume_flux_m2_s"]


def cells(out):
    """Steady errors on uniform and clustered grids, and the order between neighbours."""
    slope, thickness = 26.0, 0.01
    speed, flow = bagnold(slope, thickness)
    for spacing in ("uniform", "clustered"):
        rows, last = [], None
        for layers in CELLS:
            s = run(out, {**BASE, "box.tilt": slope, "wall.mu_w": 0.0, "model.initial_thickness": thickness, "grid.spacing": spacing,
                          "grid.layers": layers, "initial.state": "steady", "grid.cluster_depth": 0.002})
            now = [abs(s["final"]["flow_per_width"] / flow - 1.0), abs(s["final"]["surface_speed"] / speed - 1.0)]
            orders = [f"{math.log2(a / b):.2f}" for a, b in zip(last, now)] if last else ["", ""]
            rows.append([layers, f"{now[0]:.2e}", orders[0], f"{now[1]:.2e}", orders[1], *counts(s)])
            last = now
        table(f"Cells, {spacing}: Bagnold's flow at {slope:g} degrees, {1e3 * thickness:g} mm, without walls",
              ["layers", "flow", "order", "surface speed", "order", "steps", "Newton f.", "error f.", "LUs"], rows)


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "column_errors", help="folder of the runs")
    out = arguments.parse_args().out
    reference = run(out, BASE)
    decades = lambda first, last: [float(f"1e{e}") for e in range(first, last + 1)]
    for cap in ("smooth", "hard"):
        vary(out, f"Cap, {cap}, rtol 1e-4", "eta_max [Pa s]", "rheology.eta_max", decades(0, 10), reference, **{"rheology.cap": cap}, **LOOSE)
    sharp = run(out, {**BASE, **WALL, "wall.u_c": 1e-6})
    vary(out, "Wall friction, rtol 1e-6; errors against u_c = 1e-6 m/s", "u_c [m/s]", "wall.u_c", [1e-1, 1e-2, 1e-3, 1e-4, 1e-5], sharp, **WALL)
    vary(out, "Smoothing of the pressure, eta_max 1e4, rtol 1e-4; p on the base is 125 Pa", "p_0 [Pa]", "rheology.p_0", [100.0, 10.0, 1.0, 0.1, 0.01, 1e-3],
         run(out, {**BASE, **PRESSURE}), **PRESSURE)
    tight = run(out, {**BASE, "integrator.rtol": 1e-9, "integrator.atol_velocity": 1e-11})
    rows = [[f"{r:g}", f"{1e-2 * r:g}", *outcome(run(out, {**BASE, "integrator.rtol": r, "integrator.atol_velocity": 1e-2 * r}), tight)]
            for r in decades(-8, -2)[::-1]]
    table("Tolerance of a step; errors against rtol 1e-9", ["rtol", "atol [m/s]", "flow", "surface speed on the way", "steps", "Newton f.", "error f.", "LUs"], rows)
    for rtol in (1e-4, 1e-7):
        vary(out, f"Highest order of the method, rtol {rtol:g}", "max_order", "integrator.max_order", [1, 2, 3, 4, 5], tight,
             **{"integrator.rtol": rtol, "integrator.atol_velocity": 1e-2 * rtol})
    cells(out)


if __name__ == "__main__":
    main()
