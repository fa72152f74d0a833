"""A run's output, read record by record: names, times, and the way from the box to gravity's coordinates."""

import os
import tomllib
from functools import cached_property
from pathlib import Path

os.environ.setdefault("HDF5_USE_FILE_LOCKING", "FALSE")  # read along while the run still writes

import numpy as np
import xarray

import paper


class Missing(Exception):
    """What a picture needs is not in this run."""


class Run:
    """Lazy access to run.nc. Lengths in m, times in s, angles in degrees; k numbers the field outputs."""

    def __init__(self, folder):
        self.folder = Path(folder)
        path = self.folder / "run.nc"
        if not self.folder.is_dir():
            raise Missing(f"{self.folder}: no such folder")
        if not path.is_file():
            raise Missing(f"{path} does not exist: run the scene first (talus run SCENE.toml --out {self.folder})")
        try:
            self.data = xarray.open_dataset(path, engine="netcdf4", decode_times=False, cache=False)
        except (OSError, ValueError) as error:
            raise Missing(f"{path} cannot be read as netCDF: {error}") from error
        self.times = self.values("time")
        self.series_times = self.values("series_time") if "series_time" in self.data else np.empty(0)
        if self.times.size == 0:
            raise Missing(f"{path} holds no output time yet")
        self.tilt = float(self.attribute("box_tilt_deg", 0.0))
        self.film = float(self.attribute("film_m", 0.0))

    # Names

    @property
    def is_column(self):
        """A uniform layer, u(z, t) alone."""
        return self.attribute("model") == "column"

    def attribute(self, name, default=None):
        return self.data.attrs.get(name, default)

    @cached_property
    def scene(self):
        """The effective scene, its sections as dictionaries."""
        return tomllib.loads(str(self.attribute("scene", "")))

    def stated(self, section, key):
        if key not in self.scene.get(section, {}):
            raise Missing(f"the scene in run.nc has no {section}.{key}")
        return self.scene[section][key]

    @property
    def name(self):
        return str(self.attribute("scene_name", self.folder.name))

    def has(self, *names):
        return all(name in self.data for name in names)

    def values(self, name):
        if name not in self.data:
            raise Missing(f"run.nc has no variable '{name}'")
        return np.asarray(self.data[name].values, dtype=float)

    def field(self, name, k):
        if name not in self.data:
            raise Missing(f"run.nc has no variable '{name}'")
        return np.asarray(self.data[name].isel(time=k).values, dtype=float)

    def series(self, name):
        """A variable along series_time, its first dimension."""
        values = self.values(name)
        if values.shape[0] != self.series_times.size:
            raise Missing(f"'{name}' does not run along series_time")
        return values

    # Times

    @property
    def duration(self):
        """Between the first and the last output."""
        return float(self.times[-1] - self.times[0])

    def nearest(self, t):
        return int(np.argmin(np.abs(self.times - t)))

    def pick(self, wanted):
        """Numbers of the outputs nearest to the wanted times, each once; wanted times after the end are left out."""
        slack = 0.05 * self.times[-1]
        return sorted({self.nearest(t) for t in wanted if t <= self.times[-1] + slack})

    @property
    def inflow_stop(self):
        """When the inflow ended, None where it did not or never was."""
        if not self.has("inflow_rate") or self.series_times.size == 0:
            return None
        rate = self.series("inflow_rate")
        flowing = np.flatnonzero(rate > 1e-9 * rate.max())  # a solved-for rate ends at rounding, not at zero
        if rate.max() <= 0.0 or flowing[-1] + 1 >= self.series_times.size:
            return None
        return float(self.series_times[flowing[-1]])

    @property
    def is_paper_scene(self):
        """The heap of figures 12-15: Q = 0.0046 kg/s, 29.2 degrees, between rough walls."""
        rate = float(self.attribute("inflow_rate_kg_s", 0.0))
        stop = self.inflow_stop
        return (abs(rate / paper.INFLOW_RATE - 1.0) < 0.01 and abs(self.tilt - paper.TILT) < 0.05
                and float(self.attribute("wall_friction", 1.0)) > 0.0 and "no_walls" not in self.name
                and (stop is None or abs(stop - paper.INFLOW_STOP) < 2.0))

    def still_outputs(self):
        """Numbers of the outputs to draw, (growth, drain): the paper's times, stretched to this run's inflow; without
        an inflow the run's own times, evenly by number."""
        end, stop = self.times[-1], self.inflow_stop
        if float(self.attribute("inflow_rate_kg_s", 0.0)) <= 0.0:
            return sorted(set(np.linspace(0, self.times.size - 1, 6).round().astype(int))), []
        scale = (stop if stop is not None else max(end, paper.INFLOW_STOP)) / paper.INFLOW_STOP
        if abs(scale - 1.0) < 0.02:
            scale = 1.0
        growth = self.pick([scale * t for t in paper.GROWTH_TIMES])
        if stop is None:
            return sorted({*growth, self.times.size - 1}), []
        return growth, [k for k in self.pick([scale * t for t in paper.DRAIN_TIMES]) if k not in growth]

    @property
    def steady_output(self):
        """The last output with the inflow still on: the closest to a steady state."""
        stop = self.inflow_stop
        if stop is None:
            return self.times.size - 1
        return int(np.flatnonzero(self.times <= stop + 1e-6)[-1]) if self.times[0] <= stop else 0

    # Space

    @cached_property
    def x(self):
        return self.values("x")

    @cached_property
    def x_face(self):
        return self.values("x_face")

    def to_gravity(self, x, z):
        """(X, Z), X horizontal and Z up, from the box's x down the base and z normal to it. The base ends at Z = 0."""
        c, s = np.cos(np.radians(self.tilt)), np.sin(np.radians(self.tilt))
        lowest = -s * (self.x_face[-1] if s > 0.0 else self.x_face[0])
        return c * x + s * z, -s * x + c * z - lowest

    def nodes(self, k):
        """Cell corners in gravity's coordinates, X and Z of shape (interface, face)."""
        z = self.field("z_node", k)
        return self.to_gravity(np.broadcast_to(self.x_face, z.shape), z)

    def surface(self, height):
        """The free surface in gravity's coordinates: a point a column, and the box's ends at the height of the last."""
        return self.to_gravity(np.concatenate([self.x_face[:1], self.x, self.x_face[-1:]]),
                               np.concatenate([height[:1], height, height[-1:]]))

    def outline(self, height):
        """The area between base and surface, a closed polygon in gravity's coordinates."""
        return tuple(np.concatenate([top, base[::-1]]) for top, base in zip(self.surface(height), self.base()))

    def base(self):
        return self.to_gravity(self.x_face[[0, -1]], np.zeros(2))

    def is_film(self, height):
        """Columns that hold no more than the film on the base: their velocity means nothing."""
        return height <= 2.0 * self.film

    def grains_only(self, field, k):
        """A field of output k, masked where it is not finite and, of grains and air, where air is more than half."""
        masked = np.ma.masked_invalid(field)
        return np.ma.masked_where(self.field("phi", k) < 0.5, masked) if self.has("phi") else masked

    def extent(self, outputs, margin=0.04):
        """Axis limits (X0, X1, Z0, Z1) around base and surfaces of these outputs."""
        lines = [self.surface(self.field("height", k)) for k in outputs] + [self.base()]
        X, Z = (np.concatenate([line[i] for line in lines]) for i in (0, 1))
        pad = margin * max(np.nanmax(X) - np.nanmin(X), np.nanmax(Z) - np.nanmin(Z))
        return np.nanmin(X) - pad, np.nanmax(X) + pad, np.nanmin(Z) - pad, np.nanmax(Z) + pad
