"""A heap pushed out of the well-posed range: the classical law, and Q rising until the surface passes C = 0 and q = 1.

Five questions, each answered by the layer model from runs that are kept in `out/` and not made twice:

- full: the paper's box, Q = 4.6 g/s, classical law, cells halved twice. What does refinement do?
- modes: a shorter box, the same law and inflow. How fast do modes of the discrete steady state grow, on which grid?
- resolved: one of these steady states carried on with steps that resolve its modes. Does it leave at their rate?
- face: the regularised law on a steady face without ends, from below C = 0 to beyond q = 1: plane waves on three grids. Do they grow?
- rise: half a heap against a wall, regularised law, Q rising slowly from 0 to 80 g/s on three grids. Where does it break?

Prints tables in Markdown and draws heap_ill_posed.png.
"""

import argparse
import json
import pathlib
import resource
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "src/plot"))

import matplotlib.pyplot as plt
import netCDF4
import numpy as np

import look

PROGRAM = ROOT / "build/release/talus"
SCENE = ROOT / "runs/examples/heap_q46.toml"
PARTS = ["full", "modes", "resolved", "face", "rise"]
CLASSICAL = {"rheology.law": "classical", "output.times": "[]"}
FULL = CLASSICAL | {"time.end": 150, "inflow.stop": 160, "output.interval": 0.5}
SHORT = CLASSICAL | {"box.length": 0.24, "box.height": 0.12, "inflow.position": 0.03, "inflow.stop": 40, "time.end": 45}
LONG_STEPS = SHORT | {"time.end": 40, "inflow.stop": 60}
HALF = {"box.left": "wall", "box.length": 0.3, "inflow.position": 0.03, "inflow.along_gravity": "false", "inflow.rate": 0.08,
        "inflow.stop": 200, "inflow.ramp": 100, "time.end": 100, "output.interval": 0.25, "output.times": "[]"}
FACE = {"box.periodic": "true", "box.height": 0.1, "inflow.rate": 0, "model.initial_thickness": 0.03, "time.end": 10, "output.times": "[]"}
FULL_GRIDS = [(60, 16), (120, 32), (240, 64)]
SHORT_GRIDS = [(48, 16), (72, 24), (96, 32), (144, 48)]
HALF_GRIDS = [(30, 12), (60, 24), (120, 48)]
FACE_GRIDS = [(5.0e-3, 16), (2.5e-3, 32), (1.25e-3, 64)]  # column [m], layers over 30 mm
FACE_FLOWS = [0.006, 0.010, 0.017, 0.030, 0.0465, 0.060]  # kg/s
RESOLVED = (96, 32)
RESOLVED_STEP = 2.5e-4  # s; backward Euler damps a mode of 12 1/s and 112 rad/s at steps above 1.9e-3 s
RESOLVED_END = 42.6  # s
SHORT_STEP = 1e-3  # s; a rising inflow needs 0.1 s a step where nothing breaks


def settings_of(values, columns, layers):
    merged = values | {"grid.columns": columns, "grid.layers": layers}
    return [part for key, value in merged.items() for part in ("--set", f"{key}={value}")]


def call(command, limit):
    """Exit code of the program; `limit` of CPU time [s], at which the program stops as at SIGTERM."""
    print(" ".join(str(c) for c in command[1:4]), "...", file=sys.stderr, flush=True)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit)))
    return done.returncode


def summary_of(folder):
    file = folder / "summary.json"
    return json.loads(file.read_text()) if file.exists() else None


def run(folder, values, grid, limit):
    """A run that ended, by itself or by the limit, is not made again."""
    if summary_of(folder) is None and not (folder / "limit").exists():
        code = call([PROGRAM, "run", SCENE, "--out", folder, "--force", *settings_of(values, *grid)], limit)
        if code < 0:
            (folder / "limit").write_text(f"{limit} s of CPU time\n")
    return folder


class Series:
    """Time series of a run: arrays by name, over the times of the series."""

    def __init__(self, folder):
        with netCDF4.Dataset(folder / "run.nc") as data:
            self.t = np.array(data["series_time"][:])
            self.values = {name: np.array(v[:]) for name, v in data.variables.items() if v.dimensions[:1] == ("series_time",)}

    def __getitem__(self, name):
        return self.values[name]

    def first(self, condition):
        """Index of the first time at which a condition holds and never ceases to; None where there is none."""
        found = np.nonzero(~condition)[0]
        start = found[-1] + 1 if len(found) else 0
        return start if start < len(condition) else None


def show(headings, rows):
    print("| " + " | ".join(headings) + " |")
    print("|" + "---|" * len(headings))
    for row in rows:
        print("| " + " | ".join(str(cell) for cell in row) + " |")
    print(flush=True)


def study_full(out, limit):
    rows = []
    for grid in FULL_GRIDS:
        folder = run(out / f"full_{grid[0]}x{grid[1]}", FULL, grid, limit)
        series, summary = Series(folder), summary_of(folder)
        rows.append([f"{grid[0]}x{grid[1]}", summary["status"], f"{series['heap_angle'][-1]:.3f}", f"{series['mass_stored'][-1]:.4f}",
                     f"{100 * series['class_ill_posed_area'][-1]:.1f}", f"{100 * series['class_ill_posed_flux'][-1]:.1f}",
                     f"{100 * series['surface_roughness'][-1]:.0f}", summary["statistics"]["steps"], f"{summary['statistics']['last_step']:.1f}",
                     f"{summary['cpu_seconds']:.0f}"])
    show(["grid", "ends", "slope at 150 s [deg]", "mass [kg]", "ill-posed area [%]", "flux [%]", "roughness [% of a layer]", "steps",
          "last step [s]", "CPU [s]"], rows)


def modes_of(out, grid, limit):
    """Growth rate and frequency of the modes of one grid's steady state, the fastest first; its folder and its verdict."""
    folder = out / f"modes_{grid[0]}x{grid[1]}"
    if not (folder / "study.nc").exists():
        call([PROGRAM, "study", "wellposed", SCENE, "--parts", "modes", "--out", folder, *settings_of(SHORT, *grid)], limit)
    if not (folder / "study.nc").exists():
        return folder, None, None
    with netCDF4.Dataset(folder / "study.nc") as data:
        order = np.argsort(-data["mode_growth"][:])
        return folder, np.array(data["mode_growth"][:])[order], np.array(data["mode_frequency"][:])[order]


def study_modes(out, limit):
    rows = []
    for grid in SHORT_GRIDS:
        folder, growth, frequency = modes_of(out, grid, limit)
        if growth is None:
            rows.append([f"{grid[0]}x{grid[1]}", "not found within the limit of CPU time", "", ""])
            continue
        words = json.loads((folder / "verdict.json").read_text())["words"]
        rows.append([f"{grid[0]}x{grid[1]}", f"{growth[0]:.4g}", f"{abs(frequency[0]):.4g}", words.split("; ")[-1].rstrip(".")])
    show(["grid", "leading rate [1/s]", "its frequency [rad/s]", "searched"], rows)


def resolved_series(out, limit):
    """The steady state by long steps, carried on in a copy with steps of RESOLVED_STEP."""
    from_rest = run(out / f"long_steps_{RESOLVED[0]}x{RESOLVED[1]}", LONG_STEPS, RESOLVED, limit)
    folder = out / f"resolved_{RESOLVED[0]}x{RESOLVED[1]}"
    if not folder.exists():
        shutil.copytree(from_rest, folder)
    finished = summary_of(folder)
    if finished["final"]["time"] < RESOLVED_END - 1e-9:
        changed = {"time.end": RESOLVED_END, "integrator.max_step": RESOLVED_STEP, "output.interval": 0.02}
        call([PROGRAM, "restart", folder, *[p for k, v in changed.items() for p in ("--set", f"{k}={v}", "--allow", k)]], limit)
    return Series(from_rest), Series(folder)


def oscillation(series, after):
    """Largest third difference in time of the surface speed over the columns [m/s], and its times: a filter of slow drift."""
    keep = np.nonzero(series.t > after + 1e-9)[0]
    speed = series["surface_speed_series"][keep].astype(float)
    third = speed[3:] - 3.0 * speed[2:-1] + 3.0 * speed[1:-2] - speed[:-3]
    return series.t[keep][1:-2], np.abs(third).max(axis=1)


def growth_of(t, amplitude):
    """Rate fitted between ten times the noise of single precision and a hundredth of a metre per second [1/s]; None if out of reach."""
    window = np.nonzero((amplitude > 2e-6) & (amplitude < 1e-2))[0]
    window = window[: np.argmax(amplitude[window]) + 1] if len(window) else window
    if len(window) < 10:
        return None
    rate, _ = np.polyfit(t[window], np.log(amplitude[window]), 1)
    return rate, t[window[0]], t[window[-1]]


def study_resolved(out, limit):
    _, fine = resolved_series(out, limit)
    t, amplitude = oscillation(fine, 40.0)
    fit = growth_of(t, amplitude)
    print(f"Steps of {RESOLVED_STEP:g} s from t = 40 s, {RESOLVED[0]}x{RESOLVED[1]}: the surface speed oscillates by {amplitude[5]:.1e} m/s at {t[5]:.2f} s, "
          f"{amplitude[-1]:.1e} at {t[-1]:.2f} s" + (f", as exp({fit[0]:.1f} t / s) from {fit[1]:.2f} to {fit[2]:.2f} s.\n" if fit else ".\n"))


def exact_faces():
    """Slope [degree], surface inertial number and Froude number of the exact steady face at each of FACE_FLOWS."""
    asked = subprocess.run([PROGRAM, "steady", SCENE, "--Q", ",".join(map(str, FACE_FLOWS)), "--json"], capture_output=True, text=True, check=True)
    return [(case["zeta_deg"], case["surface_inertial_number"], case["froude_number"]) for case in json.loads(asked.stdout)["cases"]]


def fastest_wave(out, flow, tilt, grid, advection, limit):
    """Growth rate [1/s] and wavelength [m] of the fastest plane wave on one grid, and the rate of the shortest one."""
    folder = out / f"face_{1e3 * flow:g}gs_{1e3 * grid[0]:g}mm_{advection}"
    if not (folder / "verdict.json").exists():
        values = FACE | {"box.tilt": tilt, "box.length": 8 * grid[0], "model.advection": advection}
        call([PROGRAM, "study", "wellposed", SCENE, "--parts", "modes", "--out", folder, *settings_of(values, 8, grid[1])], limit)
    waves = json.loads((folder / "verdict.json").read_text())["modes"]["waves"]
    fastest, shortest = max(waves, key=lambda w: w["growth_1_s"]), min(waves, key=lambda w: w["wavelength_m"])
    return fastest["growth_1_s"], fastest["wavelength_m"], shortest["growth_1_s"]


def study_face(out, limit):
    for advection in ["central", "upwind"]:
        rows = []
        for flow, (tilt, inertial, froude) in zip(FACE_FLOWS, exact_faces()):
            cells = []
            for grid in FACE_GRIDS:
                rate, length, shortest = fastest_wave(out, flow, tilt, grid, advection, limit)
                cells.append(f"{rate:.3g} ({1e3 * length:.3g} mm), {shortest:.3g}")
            rows.append([f"{1e3 * flow:g}", f"{tilt:.2f}", f"{inertial:.2f}", f"{froude:.2f}", *cells])
        print(f"Advection {advection}: rate of the fastest wave [1/s] and its length, rate of the shortest (three columns)\n")
        show(["Q [g/s]", "slope [deg]", "I at the surface", "Froude number", *[f"{1e3 * g[0]:g} mm x {g[1]}" for g in FACE_GRIDS]], rows)


def rise_row(folder, grid):
    series = Series(folder)
    flows = 1e3 * series["outflow_rate_right"]
    steps = np.diff(series["n_steps"]) / np.diff(series.t)
    at = {"C": series.first(series["class_damped_area"] + series["class_ill_posed_area"] > 0.01),
          "rough": series.first(series["surface_roughness"] > 1.0),
          "q": series.first(series["class_ill_posed_area"] > 0.01),
          "fast": series.first(np.append(steps[:1], steps) > 1.0 / SHORT_STEP)}
    said = {name: f"{flows[i]:.1f}" if i is not None else "-" for name, i in at.items()}
    ends = (folder / "limit").read_text().strip() if (folder / "limit").exists() else summary_of(folder)["status"]
    return [f"{grid[0]}x{grid[1]}", said["C"], said["rough"], said["fast"], said["q"], f"{series.t[-1]:.1f} s, {flows[-1]:.1f} g/s: {ends}"]


def study_rise(out, limit):
    rows = [rise_row(run(out / f"rise_{grid[0]}x{grid[1]}", HALF, grid, limit), grid) for grid in HALF_GRIDS]
    show(["grid", "C > 0 in 1 % from", "roughness above a layer from", f"steps below {1e3 * SHORT_STEP:g} ms from", "ill-posed in 1 % from", "ends"], rows)
    print("Numbers are the outflow [g/s] from which on it holds; exact steady face: C = 0 at 6.1, q = 1 at 46.5 g/s.\n")


def draw(out, limit, file):
    figure, panels = plt.subplots(2, 2, figsize=(12.5, 8.6))
    folder, growth, frequency = modes_of(out, RESOLVED, limit)
    with netCDF4.Dataset(folder / "study.nc") as data:
        lead = int(np.argmax(data["mode_growth"][:6]))
        mode = np.array(data["mode_u_real"][lead])
        x = np.broadcast_to(data["mode_x"][:], mode.shape)
        picture = panels[0, 0].pcolormesh(1e3 * x, 1e3 * np.array(data["mode_z"][:]), mode / np.abs(mode).max(), cmap="RdBu_r", vmin=-1, vmax=1, shading="gouraud")
    figure.colorbar(picture, ax=panels[0, 0], label="u of the mode")
    look.label(panels[0, 0], 0, f"classical law, {RESOLVED[0]}x{RESOLVED[1]}: mode of {growth[0]:.1f} 1/s, {abs(frequency[0]):.0f} rad/s")
    panels[0, 0].set(xlabel="x [mm]", ylabel="z [mm]")

    coarse, fine = resolved_series(out, limit)
    t, amplitude = oscillation(fine, 40.0)
    panels[0, 1].semilogy(t, amplitude, color=look.ORANGE, label=f"steps of {1e3 * RESOLVED_STEP:g} ms")
    fit = growth_of(t, amplitude)
    if fit:
        middle = np.searchsorted(t, 0.5 * (fit[1] + fit[2]))
        panels[0, 1].semilogy(t, amplitude[middle] * np.exp(growth[0] * (t - t[middle])), color=look.INK, linestyle=":", label=f"exp({growth[0]:.1f} t), the mode")
    look.label(panels[0, 1], 1, "the same steady state, steps that resolve the mode")
    panels[0, 1].set(xlabel="t [s]", ylabel="oscillation of the surface speed [m/s]", ylim=(3e-8, 3.0 * amplitude.max()))
    panels[0, 1].legend()

    colours = look.sequence_colours(len(HALF_GRIDS))
    for grid, colour in zip(HALF_GRIDS, colours):
        series = Series(out / f"rise_{grid[0]}x{grid[1]}")
        flow = 1e3 * series["inflow_rate"]
        steps = np.gradient(series["n_steps"].astype(float), series.t)
        panels[1, 0].plot(flow, series["heap_angle"], color=colour, label=f"{grid[0]}x{grid[1]}")
        panels[1, 1].semilogy(flow, np.maximum(steps, 0.1), color=colour, label=f"{grid[0]}x{grid[1]}")
    for axes in panels[1]:
        for value, name in [(6.1, "C = 0"), (46.5, "q = 1")]:
            axes.axvline(value, color=look.FAINT, linewidth=0.9, linestyle="--")
            axes.text(value + 0.6, 0.02, name, color=look.FAINT, transform=axes.get_xaxis_transform())
        axes.set(xlabel="inflow, rising with time [g/s]")
        axes.legend()
    look.label(panels[1, 0], 2, "regularised law, half a heap: slope of the face")
    panels[1, 0].set(ylabel="slope [degree]")
    look.label(panels[1, 1], 3, "steps that a second takes")
    panels[1, 1].set(ylabel="steps [1/s]")
    for axes in panels.flat[1:]:
        look.grid(axes)
    look.save(figure, file.parent, file.name)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--out", type=pathlib.Path, default=ROOT / "out" / "heap_ill_posed", help="folder of the runs")
    arguments.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS, help="questions to answer; the picture needs the last three")
    arguments.add_argument("--limit", type=int, default=900, help="CPU seconds of a run")
    choice = arguments.parse_args()
    choice.out.mkdir(parents=True, exist_ok=True)
    for part in choice.parts:
        {"full": study_full, "modes": study_modes, "resolved": study_resolved, "face": study_face, "rise": study_rise}[part](choice.out, choice.limit)
    if set(PARTS[1:]) <= set(choice.parts):
        draw(choice.out, choice.limit, ROOT / "runs/studies/heap_ill_posed.png")


if __name__ == "__main__":
    main()
