"""Asks the program `talus` for what the figures need: exact flows, friction laws, runs of the column."""

import json
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

import netCDF4
import numpy as np

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
DEFAULT_PROGRAM = ROOT / "build" / "release" / "talus"
DEFAULT_OUT = ROOT / "out" / "paper"


@dataclass(frozen=True)
class Flow:
    """An exact steady uniform flow; z from the foot up, where a profile was asked for."""
    zeta: float                # degree
    Q: float                   # kg/s
    volume_flux: float         # m2/s
    z_st: float                # m
    surface_speed: float       # m/s
    surface_I: float
    froude: float
    z: np.ndarray = field(default_factory=lambda: np.empty(0))   # m
    u: np.ndarray = field(default_factory=lambda: np.empty(0))   # m/s
    I: np.ndarray = field(default_factory=lambda: np.empty(0))


@dataclass(frozen=True)
class Study:
    """Flows of one material, and what holds for all of them."""
    flows: list
    parameters: dict           # as the program reports them
    largest_Q: float           # kg/s, of the law; None without bound
    steepest: float            # degree; None without bound


@dataclass(frozen=True)
class Law:
    name: str
    at_rest: float             # mu(0)
    neutral: list              # I where C = 0
    linear_bound: float        # I where mu - I mu'/2 = 1, None if nowhere
    well_posed: list           # ranges of I where C <= 0


@dataclass(frozen=True)
class Profile:
    """The last state of a run of a uniform layer, by the column or by the two-dimensional layer."""
    z: np.ndarray              # m, of the cells' middles, from the surface
    u: np.ndarray              # m/s
    flux: float                # m2/s


class Talus:
    def __init__(self, program, out, preset="standard"):
        """`preset` is the accuracy of the heaps, which take long; `out` holds their runs."""
        self.program, self.out, self.preset = Path(program), Path(out), preset

    def call(self, *arguments):
        """Standard output of the program. A failure ends the script with the program's own words."""
        try:
            done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True, check=False)
        except OSError as error:
            sys.exit(f"{self.program}: {error.strerror}; build it, or name it with --talus")
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, [self.program, *arguments]))[:300]}\n{done.stderr}exit code {done.returncode}")
        return done.stdout

    def steady(self, material, zeta=None, Q=None, law=None, points=0, thickness=None, sets=()):
        """The flows at slopes zeta [degree] or mass flows Q [kg/s]; thickness [m] of a layer over a base, none for a heap."""
        arguments = ["steady", HERE / material, "--json", "--zeta" if Q is None else "--Q", listed(zeta if Q is None else Q)]
        for option, value in (("--law", law), ("--points", points or None), ("--thickness", thickness)):
            arguments += [option, value] if value is not None else []
        answer = json.loads(self.call(*arguments, *settings(sets)))
        missing = [case["reason"] for case in answer["cases"] if not case["exists"]]
        if missing:
            sys.exit(f"{material}: {missing[0]}")
        return Study([flow_of(case) for case in answer["cases"]], answer["parameters"], answer["Q_max_kg_s"], answer["zeta_max_deg"])

    def law(self, material, name):
        entry = self.rheology(material, name)
        neutral, bounds = ([point["I"] for point in entry[key] if point["relevant"]] for key in ("neutral_points", "ellipticity_bounds"))
        return Law(name, entry["mu_at_rest"], neutral, bounds[-1] if bounds else None, entry["well_posed_by_C"])

    def friction(self, material, name, I):
        """Columns mu, C and others at the inertial numbers I."""
        points = self.rheology(material, name, "--I", listed(I))["points"]
        return {column: np.array(entry["values"]) for column, entry in points.items()}

    def rheology(self, material, name, *arguments):
        word = "partially_regularised" if name == "partial" else name
        return json.loads(self.call("rheology", HERE / material, "--json", "--law", word, *arguments))["laws"][0]

    def run(self, scene, name, sets):
        """Runs a scene into a folder, which it returns; not again where it has been run."""
        folder = self.out / "runs" / name
        if status(folder) != "finished":
            self.call("run", HERE / scene, "--out", folder, "--force", *settings(sets))
        return folder


def status(folder):
    """What a run's summary says, "" where there is none."""
    summary = Path(folder) / "summary.json"
    return json.loads(summary.read_text())["status"] if summary.exists() else ""


def last_profile(folder):
    """The last state of a run, averaged along x where there is one. Not for threads: HDF5 then complains at length."""
    with netCDF4.Dataset(folder / "run.nc") as run:
        names = ("z", "z_interface", "u") if "z_interface" in run.variables else ("z", "z_node", "u_centre")
        z, edges, u = (last(run[name]) for name in names)
    return Profile(z - edges[-1], u, float(np.sum(u * np.diff(edges))))


def last(variable):
    """The last record of a variable, averaged along x."""
    values = variable[-1 if variable.dimensions[0] == "time" else slice(None)].filled()
    return values.mean(axis=1) if values.ndim == 2 else values


def listed(numbers):
    return ",".join(repr(float(number)) for number in numbers)


def settings(sets):
    return [word for setting in sets for word in ("--set", setting)]


def flow_of(case):
    profile = {name: np.array(values)[::-1] for name, values in case.get("profile", {}).items()}
    columns = {"z": -profile["depth_m"], "u": profile["speed_m_s"], "I": profile["inertial_number"]} if profile else {}
    return Flow(case["zeta_deg"], case["Q_kg_s"], case["volume_flux_m2_s"], case["z_st_m"], case["surface_speed_m_s"],
                case["surface_inertial_number"], case["froude_number"], **columns)
