"""The heap on several grids, inflows and wall-friction speeds: runs what is missing, prints one table in Markdown.

Source of the paper's masses: figure 12, its areas read as kilograms. The film that lies in the box from the start is taken off.
"""

import argparse
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
U_C = "2e-4"  # m/s, of the runs that vary grid and inflow
GRIDS = [(60, 16), (150, 16), (150, 32), (300, 32)]
INFLOWS = ["heap_q20", "heap_q46", "heap_q60"]
WALL_SPEEDS = ["1e-4", "2e-4", "1e-3", "5e-3", "1e-2"]
STEADY = {"heap_q20": 250.0, "heap_q46": 150.0, "heap_q60": 150.0}  # s, when the inflow ends
GROWTH = [30.8, 56.0, 150.0]
DRAIN = [155.2, 202.0, 252.0, 297.6]
PAPER = {30.8: 0.11, 56.0: 0.15, 150.0: 0.175, 155.2: 0.16, 202.0: 0.08, 252.0: 0.04, 297.6: 0.01}


def run(scene, columns, layers, out, settings=(), u_c=U_C):
    """Runs a scene unless `out` holds it finished; its summary, or None where it left none."""
    folder = out / "_".join([scene, f"{columns}x{layers}", *[s.split("=")[1] for s in settings]])
    summary = folder / "summary.json"
    if not summary.exists() or json.loads(summary.read_text())["status"] != "finished":
        command = [ROOT / "build/release/talus", "run", ROOT / f"runs/examples/{scene}.toml", "--out", folder, "--force"]
        for setting in [f"grid.columns={columns}", f"grid.layers={layers}", f"wall.u_c={u_c}", *settings]:
            command += ["--set", setting]
        print(f"running {folder.name}", file=sys.stderr)
        subprocess.run(command, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL, check=False)
    return json.loads(summary.read_text()) if summary.exists() else None


def at(summary, time, name):
    """The recorded number nearest to a time, NaN where the run did not come there."""
    records = [r for r in summary["records"] if abs(r["time"] - time) < 1e-6 and r.get(name) is not None]
    return records[0][name] if records else float("nan")


def film(summary):
    """Mass in the box before anything was poured [kg]."""
    last = summary["final"]
    return last["mass_stored"] - last["mass_inflow"] + last["mass_outflow_left"] + last["mass_outflow_right"]


def row(name, summary, times, steady=150.0):
    if summary is None:
        return f"| {name} | no summary |"
    counts = summary["statistics"]
    masses = [f"{at(summary, t, 'mass_stored') - film(summary):.4f}" for t in times]
    cells = [name, summary["status"], counts["steps"], counts["newton_failures"], counts["error_test_failures"],
             counts["factorisations"], f"{at(summary, steady, 'heap_angle'):.3f}",
             f"{100.0 * at(summary, steady, 'surface_roughness'):.2f}", *masses,
             f"{abs(summary['final']['mass_error']) / summary['final']['mass_inflow']:.0e}",
             f"{summary['peak_memory_bytes'] / 2**20:.0f}", f"{summary['cpu_seconds']:.0f}", f"{summary['wall_seconds']:.0f}"]
    return "| " + " | ".join(str(c) for c in cells) + " |"


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "matrix", help="folder of the runs")
    arguments.add_argument("--wall-speed", action="store_true", help="vary u_c at 150x16, and show the drain")
    choice = arguments.parse_args()
    times = GROWTH + (DRAIN if choice.wall_speed else [])
    print("| run | status | steps | Newton f. | error f. | LUs | slope when the inflow ends [deg] | roughness [% of a layer] | "
          + " | ".join(f"m({t:g} s) [kg]" for t in times) + " | mass error | MiB | CPU [s] | wall [s] |")
    print("|" + "---|" * (12 + len(times)))
    if choice.wall_speed:
        for speed in WALL_SPEEDS:
            print(row(f"u_c = {speed} m/s", run("heap_q46", 150, 16, choice.out / f"u_c_{speed}", u_c=speed), times), flush=True)
        print("| paper | | | | | | | | " + " | ".join(f"{PAPER[t]:g}" for t in times) + " | | | | |")
        return
    for scene in INFLOWS:
        for columns, layers in GRIDS:
            print(row(f"{scene} {columns}x{layers}", run(scene, columns, layers, choice.out), times, STEADY[scene]), flush=True)


if __name__ == "__main__":
    main()
