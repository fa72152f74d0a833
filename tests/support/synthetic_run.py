"""A made-up run.nc with the names and shapes of a real one: python3 synthetic_run.py DIR [kind]. It solves no equation.

A triangular heap whose mass follows the paper's figure 12, with a flowing layer 5 mm deep on its right face."""

import sys
from pathlib import Path

import netCDF4
import numpy as np

THETA, LENGTH, BOX_HEIGHT, GAP, FILM = np.radians(29.2), 0.6, 0.3, 0.003, 5e-4
MASS_TIMES = (0.0, 7.2, 12.4, 16.8, 30.8, 56.0, 150.0, 155.2, 174.4, 202.0, 252.0, 297.6, 330.0)
MASSES = (0.0, 0.02, 0.045, 0.065, 0.11, 0.15, 0.175, 0.16, 0.11, 0.08, 0.04, 0.01, 0.0)
LAYER_DEPTH = 5e-3  # m, normal to the face


class Kind:
    """What is made: `heap`, or one that lacks something."""

    def __init__(self, kind="heap", nx=150, nz=32):
        self.name, self.nx, self.nz = kind, nx, nz
        self.periodic = kind == "periodic"
        self.tilt = np.radians(45.0) if self.periodic else THETA
        self.length = 0.02 if self.periodic else LENGTH
        self.rate = 0.0 if self.periodic else 0.0046
        self.stop = np.inf if kind in ("no_stop", "periodic") else 150.0
        self.end = {"no_stop": 100.0, "no_drain": 150.0, "early": 20.3, "periodic": 2.0}.get(kind, 320.0)
        paper = [t for t in (7.2, 12.4, 16.8, 30.8, 56, 150, 151.2, 155.2, 174.4, 202, 252, 297.6) if t <= self.end]
        step = {"sparse": 1e9, "periodic": 0.1}.get(kind, 2.0)
        self.times = np.unique([0.0, *paper, *np.arange(0.0, self.end, step), self.end])
        self.series_times = np.linspace(0.0, self.end, 641)


def triangle(slope, x):
    """Height over the base of a heap with its right face at `slope` [rad] to the horizontal, its apex under the jet."""
    right, left = np.tan(slope - THETA), np.tan(np.radians(22.0) + THETA)
    apex = 0.11
    for _ in range(60):
        height = (LENGTH - apex) * right
        apex = 0.11 + (BOX_HEIGHT - height) * np.tan(THETA)
    return np.maximum(0.0, np.minimum((LENGTH - x) * right, height - (apex - x) * left)), apex, height


class Heap:
    """Shape and flow at a time."""

    def __init__(self, kind):
        self.kind = kind
        self.x_face = np.linspace(0.0, kind.length, kind.nx + 1)
        self.x = 0.5 * (self.x_face[1:] + self.x_face[:-1])
        slopes = np.linspace(THETA + 1e-3, np.radians(51.0), 200)
        self.slopes = slopes
        self.masses = [1500.0 * GAP * triangle(s, self.x)[0].mean() * LENGTH for s in slopes]

    def mass(self, t):
        return np.interp(t, MASS_TIMES, MASSES)

    def height(self, t):
        if self.kind.periodic:
            return np.full_like(self.x, 0.012)
        slope = np.interp(self.mass(t), self.masses, self.slopes)
        height, self.apex_x, self.apex_z = triangle(slope, self.x)
        self.angle = np.degrees(slope)
        return 2.0 * FILM * 0.9 + height

    def outflow(self, t):
        return max(0.0, self.kind.rate * (t < self.kind.stop) - (self.mass(t + 0.05) - self.mass(t - 0.05)) / 0.1)

    def surface_speed(self, t):
        if self.kind.periodic:
            return np.full_like(self.x, 0.24 * np.tanh(t / 0.1))
        flow = (self.outflow(t) / 0.0046) ** 0.6
        return 0.27 * flow * (self.x > self.apex_x) * (self.height(t) > 3.0 * FILM)


def depths(height, nz):
    """Depth under the surface of the interfaces, base first, clustered towards the surface."""
    s = np.linspace(1.0, 0.0, nz + 1)[:, None]
    return 3e-3 * ((1.0 + height / 3e-3) ** s - 1.0)


def profile(depth):
    """(speed, inertial number) relative to the surface at a depth [m] normal to the face: a power, a creeping tail."""
    r = np.clip(1.0 - depth / LAYER_DEPTH, 0.0, 1.0)
    return r ** 1.5 * (1.0 - 1e-3) + 1e-3 * np.exp(-depth / 4e-3), np.sqrt(r) + 1e-3 * np.exp(-depth / 4e-3)


def variables_at(heap, t):
    """Fields of one output."""
    kind = heap.kind
    height = heap.height(t)
    H_face = np.interp(heap.x_face, heap.x, height)
    z_node = H_face - depths(H_face, kind.nz)
    z_edge = height - depths(height, kind.nz)
    z = 0.5 * (z_edge[1:] + z_edge[:-1])
    slope = np.arctan(-np.gradient(height, heap.x))
    normal_depth = (height - z) * np.cos(slope)
    speed_shape, inertia_shape = profile(normal_depth)
    speed = heap.surface_speed(t) * speed_shape
    pressure = 1500.0 * 9.81 * normal_depth * np.cos(kind.tilt + slope)
    inertia = 1.1 * inertia_shape * np.maximum(heap.surface_speed(t) / 0.27, 1e-4)
    return {"height": height, "z_node": z_node, "z": z, "speed": speed, "u_centre": speed * np.cos(slope),
            "w_centre": -speed * np.sin(slope), "pressure": pressure, "inertial_number": inertia,
            "cap_active": (inertia < 2e-4).astype(float), "strain_rate": inertia * np.sqrt(pressure / 2500.0) / 1.5e-3}


SHAPES = {"height": ("column",), "z_node": ("interface", "face")}
UNITS = {"height": "m", "z_node": "m", "z": "m", "pressure": "Pa", "inertial_number": "1", "cap_active": "1",
         "strain_rate": "s-1"}


def write(folder, kind="heap", **size):
    """Writes folder/run.nc and returns its Kind."""
    kind = Kind(kind, **size)
    heap = Heap(kind)
    Path(folder).mkdir(parents=True, exist_ok=True)
    with netCDF4.Dataset(Path(folder) / "run.nc", "w") as file:
        file.setncatts({"Conventions": "CF-1.8", "scene_name": {"heap": "heap_q46"}.get(kind.name, kind.name),
                        "box_tilt_deg": np.degrees(kind.tilt), "box_length": kind.length, "box_height": BOX_HEIGHT,
                        "inflow_rate_kg_s": kind.rate, "gap_m": GAP, "film_m": FILM, "end_time_s": kind.end})
        for name, n in {"time": None, "series_time": None, "column": kind.nx, "face": kind.nx + 1, "layer": kind.nz,
                        "interface": kind.nz + 1, "exact_point": 80}.items():
            file.createDimension(name, n)
        fixed = {"x": (("column",), heap.x), "x_face": (("face",), heap.x_face)}
        depth = np.linspace(0.0, LAYER_DEPTH, 80)
        speed, inertia = profile(depth)
        fixed.update({"exact_depth": (("exact_point",), depth), "exact_speed": (("exact_point",), 0.27 * speed),
                      "exact_inertial_number": (("exact_point",), 1.1 * inertia)})
        for name, (dimensions, values) in fixed.items():
            file.createVariable(name, "f8", dimensions)[:] = values
        write_fields(file, heap)
        write_series(file, heap)
    return kind


def write_fields(file, heap):
    file.createVariable("time", "f8", ("time",)).units = "s"
    for record, t in enumerate(heap.kind.times):
        file["time"][record] = t
        for name, values in variables_at(heap, t).items():
            if record == 0:
                variable = file.createVariable(name, "f4", ("time", *SHAPES.get(name, ("layer", "column"))))
                variable.units = UNITS.get(name, "m s-1")
            file[name][record] = values


def write_series(file, heap):
    kind, t = heap.kind, heap.kind.series_times
    file.createVariable("series_time", "f8", ("series_time",)).units = "s"
    file["series_time"][:] = t
    lines = {"height_series": np.array([heap.height(v) for v in t]),
             "surface_speed_series": np.array([heap.surface_speed(v) for v in t])}
    outflow = np.zeros_like(t) if kind.periodic else np.array([heap.outflow(v) for v in t])
    mass_in = kind.rate * np.minimum(t, kind.stop)
    stored = np.full_like(t, 0.0011) if kind.periodic else heap.mass(t)
    n = 900.0 * (1.0 - np.exp(-t / 60.0)) + t
    work = n / n[-1]
    scalars = {
        "mass_stored": stored, "mass_inflow": mass_in, "mass_outflow_right": mass_in - stored,
        "mass_outflow_left": 0.0 * t, "mass_error": 1e-15 * n, "inflow_rate": np.where(t <= kind.stop, kind.rate, 1e-27),
        "outflow_rate_right": outflow, "outflow_rate_left": 0.0 * t, "heap_angle": 29.2 + 112.0 * stored,
        "n_steps": n.round(), "n_error_test_failures": (0.02 * n).round(), "n_newton_failures": (0.004 * n).round(),
        "n_factorisations": (0.3 * n).round(), "order": 1.0 + (n.round() % 3 > 0),
        "last_step": 0.02 + 0.4 * (1.0 - np.exp(-(t % 150.0) / 30.0)), "cpu_residual": 8.0 * work,
        "cpu_jacobian": 6.0 * work, "cpu_factor": 30.0 * work, "cpu_solve": 5.0 * work}
    for name, values in lines.items():
        file.createVariable(name, "f4", ("series_time", "column"))[:] = values
    for name, values in scalars.items():
        file.createVariable(name, "f8", ("series_time",))[:] = values


if __name__ == "__main__":
    write(*sys.argv[1:3])
