"""The two-dimensional runs behind figures 11 to 19: run once, kept, and continued where they were stopped. A heap lies in
runs/<scene>_<preset>. Heaps by the two-fluid model take hours: where one stands in runs/two_fluid_<scene> it is drawn beside."""

import json
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

import reproduction  # noqa: F401, finds src/plot
from run_data import Missing, Run
from talus import ROOT

EXAMPLES = ROOT / "runs" / "examples"
INFLOWS = {"heap_q20": 0.0020, "heap_q46": 0.0046, "heap_q60": 0.0060}  # kg/s
STOP = 150.0                                                           # s, of the inflow of 0.0046 kg/s
BASE_FRICTION = 0.25
RESTARTABLE = 75


@dataclass
class Heap:
    """A finished run; masses without the film that lies in the box from the start."""
    run: Run
    model: str

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
        return (f"{self.run.folder.name}, {sizes['column']}x{sizes['layer']} cells: {summary['cpu_seconds']:.0f} s of CPU, "
                f"{summary['statistics']['steps']} steps, by {summary['git_revision']}")


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
    """The same by the two-fluid model, None where nobody has run it. A run that was stopped shows what there is."""
    folder = talus.out / "runs" / f"two_fluid_{scene}"
    try:
        return Heap(Run(folder), "two-fluid") if status(folder) else None
    except Missing as reason:
        print(f"{folder.name}: {reason}", file=sys.stderr)
        return None


def both(talus, scene):
    return [heap for heap in (layer(talus, scene), two_fluid(talus, scene)) if heap is not None]


def costs(talus, scenes):
    """Of the runs behind a figure, in words."""
    return [heap.cost for scene in scenes for heap in both(talus, scene)]


def status(folder):
    """What a run's summary says, "" where there is none."""
    summary = Path(folder) / "summary.json"
    return json.loads(summary.read_text())["status"] if summary.exists() else ""


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
