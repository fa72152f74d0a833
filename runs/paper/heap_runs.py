"""The two-dimensional runs behind figures 11 to 19: run once, kept, and continued where they were stopped. A heap lies in
runs/<scene>_<preset>, the same by the two-fluid model, on cells of 20, 10 or 5 mm, in runs/two_fluid_<scene>_<preset>."""

import json
import subprocess
import sys
import tomllib
from dataclasses import dataclass

import numpy as np

import reproduction  # noqa: F401, finds src/plot
from run_data import Run
from talus import ROOT, settings, status

EXAMPLES = ROOT / "runs" / "examples"
TWO_FLUID = ROOT / "runs" / "benchmarks" / "two_fluid_heap.toml"
INFLOWS = {"heap_q20": 0.0020, "heap_q46": 0.0046, "heap_q60": 0.0060}  # kg/s
STOP = 150.0                                                           # s, of the inflow of 0.0046 kg/s
BASE_FRICTION = 0.25
CELLS = {"draft": (30, 15), "standard": (60, 30), "fine": (120, 60)}    # of the two-fluid model: 20, 10, 5 mm
RESTARTABLE = 75
UNRESOLVED = "not resolved: its cells are deeper than the layer that flows"


@dataclass
class Heap:
    """A finished run; masses without the film that lies in the box from the start."""
    run: Run
    model: str

    @property
    def label(self):
        """The model, and the size of cells that do not resolve the flowing layer."""
        return self.model if self.model.startswith("layer") else f"{self.model}, cells of {1e3 * np.diff(self.run.x_face).max():.0f} mm"

    def reason(self, of_the_layer):
        """Why a number differs: that of the layer model, or the one reason of a heap that is not resolved."""
        return of_the_layer if self.model.startswith("layer") else UNRESOLVED

    @property
    def film(self):
        return self.run.series("mass_stored")[0]

    def mass(self, t):
        """In the box [kg]."""
        return float(np.interp(t, self.run.series_times, self.run.series("mass_stored"))) - self.film

    def number(self, name, t):
        """A single number of the model at a time."""
        return float(np.interp(t, self.run.series_times, self.run.series(name)))

    @property
    def cost(self):
        """In words, for the page."""
        summary = json.loads((self.run.folder / "summary.json").read_text())
        sizes = self.run.data.sizes
        return (f"{self.run.folder.name}, {sizes['column']}x{sizes['layer']} cells: {self.cpu_seconds:.0f} s of CPU, "
                f"{summary['statistics']['steps']} steps, by {summary['git_revision']}")

    @property
    def cpu_seconds(self):
        return json.loads((self.run.folder / "summary.json").read_text())["cpu_seconds"]


def layer(talus, scene):
    """The heap of an example scene by the layer, at the preset that `talus` carries."""
    return Heap(kept(talus, EXAMPLES / f"{scene}.toml", f"{scene}_{talus.preset}", ["--preset", talus.preset]), "layer")


def sliding(talus):
    """The heap of 0.0046 kg/s on a base of the friction that brings it closest to the experiment (runs/studies, basal slip)."""
    options = ["--preset", talus.preset, "--set", f"box.base_friction={BASE_FRICTION}"]
    return Heap(kept(talus, EXAMPLES / "heap_q46.toml", f"heap_q46_sliding_{talus.preset}", options), f"layer sliding, {BASE_FRICTION}")


def jet(talus):
    """The dilute jet alone, by the two-fluid model."""
    return Heap(kept(talus, EXAMPLES / "two_fluid_jet.toml", "two_fluid_jet"), "two-fluid")


def two_fluid(talus, scene):
    """The same inflow by the two-fluid model; heaps that no figure shows draining only to the end of their inflow."""
    example = tomllib.loads((EXAMPLES / f"{scene}.toml").read_text(encoding="utf-8"))
    rate, mu_w = example["inflow"]["rate"], example["wall"]["mu_w"]
    stop = example["inflow"].get("stop", example["time"]["end"])
    drains = scene == "heap_q46"
    columns, layers = CELLS[talus.preset]
    keys = {"grid.columns": columns, "grid.layers": layers, "inflow.rate": rate, "inflow.stop": stop, "wall.mu_w": mu_w,
            "time.end": example["time"]["end"] if drains else min(stop + 1.0, example["time"]["end"])}
    keys["output.times"] = [t for t in example["output"]["times"] if t <= keys["time.end"]]
    if mu_w == 0.0:
        keys["two_fluid.cells"] = "box"  # no heap bounds what grains can reach
    sets = settings(f"{key}={value}" for key, value in keys.items())
    return Heap(kept(talus, TWO_FLUID, f"two_fluid_{scene}_{talus.preset}", sets), "two-fluid")


def both(talus, scene):
    return [layer(talus, scene), two_fluid(talus, scene)]


def costs(talus, scenes):
    """Of the runs behind a figure, in words."""
    return [heap.cost for scene in scenes for heap in both(talus, scene)]


def cpu_seconds(talus):
    """Of the kept runs of this preset: (name, seconds)."""
    kept_ones = sorted([*(talus.out / "runs").glob(f"*heap*_{talus.preset}"), *(talus.out / "runs").glob("two_fluid_jet")])
    return [(folder.name, json.loads((folder / "summary.json").read_text())["cpu_seconds"]) for folder in kept_ones if status(folder) == "finished"]


def kept(talus, scene, name, options=()):
    """The finished run of a scene in runs/<name>. What is missing is run, with the program's own progress; a stop by a signal leaves a
    checkpoint, which the next call goes on from."""
    folder = talus.out / "runs" / name
    if status(folder) == "finished":
        return Run(folder)
    print(f"running {name}", file=sys.stderr)
    anew = [talus.program, "run", scene, *options, "--out", folder, "--force"]
    done = None
    if folder.is_dir() and any(folder.glob("checkpoint_*.nc")):
        done = subprocess.run([talus.program, "restart", folder], check=False, stdout=subprocess.DEVNULL)
    if done is None or done.returncode not in (0, RESTARTABLE):
        done = subprocess.run(anew, check=False, stdout=subprocess.DEVNULL)
    if done.returncode != 0:
        sys.exit(f"{name}: talus ended with {done.returncode}; the same command goes on")
    return Run(folder)
