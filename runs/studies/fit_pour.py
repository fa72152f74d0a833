"""Data for fit/pour.toml: a run at known parameters, and two steady slopes, with normal errors.

    /usr/bin/python3 runs/studies/fit_pour.py [--talus build/release/talus] [--out out/fit_pour]

Writes pour_slopes.csv, pour_shapes.csv and pour_outflow.csv into --out; those in fit/ are its answer of 2026-11-26 with --seed 1."""

import argparse
import json
import subprocess
from pathlib import Path

import numpy as np
import xarray as xr

ROOT = Path(__file__).resolve().parents[2]
SCENE = ROOT / "runs" / "studies" / "fit" / "pour_heap.toml"
TRUTH = ("wall.mu_w=0.3727", "box.base_friction=0.3")
SHAPE_TIMES, OUTFLOW_TIMES = (4.0, 8.0, 10.0, 14.0), tuple(float(t) for t in range(2, 20))
HEIGHT_ERROR, MASS_ERROR, SLOPE_ERROR = 5e-4, 3e-4, 0.3  # m, kg, degree


def settings(*all_sets):
    return [word for one in all_sets for word in ("--set", one)]


def write(path, comment, header, rows):
    path.write_text("\n".join([f"# {comment}", header, *(",".join(f"{x:.6g}" for x in row) for row in rows)]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--talus", type=Path, default=ROOT / "build" / "release" / "talus")
    parser.add_argument("--out", type=Path, default=ROOT / "out" / "fit_pour")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    out, random = options.out, np.random.default_rng(options.seed)
    times = sorted({*SHAPE_TIMES, *OUTFLOW_TIMES})
    subprocess.run([options.talus, "run", SCENE, "--out", out / "truth", "--force",
                    *settings(*TRUTH, f"output.times={list(times)}", "output.fields=false")], check=True)
    with xr.open_dataset(out / "truth" / "run.nc", decode_times=False) as run:
        run.load()
    comment = "made by fit_pour.py from " + ", ".join(TRUTH) + f", with normal errors; seed {options.seed}"
    at = np.arange(0.06, 0.245, 0.01)
    rows = []
    for t in SHAPE_TIMES:
        heights = np.interp(at, run["x"], run["height_series"].sel(series_time=t, drop=True))
        rows += [(t, x, h + HEIGHT_ERROR * random.standard_normal(), HEIGHT_ERROR) for x, h in zip(at, heights) if h > 6.0 * HEIGHT_ERROR]
    write(out / "pour_shapes.csv", comment, "time_s,x_m,height_m,height_error_m", rows)
    rows = [(t, float(run["mass_outflow_right"].sel(series_time=t)) + MASS_ERROR * random.standard_normal(), MASS_ERROR) for t in OUTFLOW_TIMES]
    write(out / "pour_outflow.csv", comment, "time_s,mass_kg,mass_error_kg", rows)
    steady = json.loads(subprocess.run([options.talus, "steady", SCENE, "--Q", "0.002,0.0046", "--json", *settings(*TRUTH)], check=True,
                                       capture_output=True, text=True).stdout)
    rows = [(Q, 0.0, case["zeta_deg"] + SLOPE_ERROR * random.standard_normal(), SLOPE_ERROR)
            for Q, case in zip((0.002, 0.0046), steady["cases"])]
    write(out / "pour_slopes.csv", comment, "Q_kg_s,Q_error_kg_s,zeta_deg,zeta_error_deg", rows)


if __name__ == "__main__":
    main()
