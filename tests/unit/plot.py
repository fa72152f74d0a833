"""Tests of src/plot on made-up runs: what it picks and computes, that it draws, and what it says when it cannot."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src" / "plot"), str(ROOT / "tests" / "support")]

import netCDF4
import numpy as np
import field_maps
import heap_movie
import heap_shapes
import layer_profiles
import look
import mass_curves
import paper
import solver_history
import synthetic_run
from run_data import Missing, Run

PICTURES = {heap_shapes: 1, field_maps: 3, mass_curves: 1, layer_profiles: 1, solver_history: 1}
look.plt.rcParams["savefig.dpi"] = 40


def make(folder, kind):
    run = Path(tempfile.mkdtemp(prefix=kind, dir=folder))
    synthetic_run.write(run, kind, nx=48, nz=16)
    return run


def plot(*arguments):
    return subprocess.run([sys.executable, ROOT / "src" / "plot", *map(str, arguments)], capture_output=True, text=True)


class WithFolder(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = Path(holder.name)

    def times(self, run, outputs):
        return [float(run.times[k]) for k in outputs]


class Choices(WithFolder):
    """Which outputs are drawn."""

    def test_whole_heap_shows_the_papers_times(self):
        run = Run(make(self.folder, "heap"))
        growth, drain = run.still_outputs()
        np.testing.assert_allclose(self.times(run, growth), paper.GROWTH_TIMES)
        np.testing.assert_allclose(self.times(run, drain), paper.DRAIN_TIMES)
        self.assertAlmostEqual(run.times[run.steady_output], 150.0)
        self.assertTrue(run.is_paper_scene)

    def test_run_stopped_early_shows_what_there_is_and_its_last_state(self):
        run = Run(make(self.folder, "early"))
        growth, drain = run.still_outputs()
        np.testing.assert_allclose(self.times(run, growth), [7.2, 12.4, 16.8, 20.3])
        self.assertEqual(drain, [])
        self.assertIsNone(run.inflow_stop)

    def test_sparse_outputs_are_each_shown_once(self):
        run = Run(make(self.folder, "sparse"))
        growth, drain = run.still_outputs()
        self.assertEqual(len(growth + drain), len(set(growth + drain)))

    def test_no_inflow_shows_the_whole_run_evenly(self):
        run = Run(make(self.folder, "periodic"))
        growth, drain = run.still_outputs()
        np.testing.assert_allclose(self.times(run, growth), [0.0, 0.4, 0.8, 1.2, 1.6, 2.0], atol=0.051)
        self.assertEqual(drain, [])
        self.assertFalse(run.is_paper_scene)


class Geometry(WithFolder):
    def test_gravity_coordinates_keep_lengths_and_put_the_outlet_at_the_bottom(self):
        run = Run(make(self.folder, "heap"))
        X, Z = run.base()
        self.assertAlmostEqual(Z[1], 0.0)
        self.assertAlmostEqual(np.hypot(X[1] - X[0], Z[1] - Z[0]), 0.6)
        self.assertAlmostEqual(np.degrees(np.arctan2(Z[0] - Z[1], X[1] - X[0])), 29.2)

    def test_profile_of_a_linear_field_is_exact_along_the_normal(self):
        """On a straight surface a field of the depth alone must come back as depth normal to it over the cosine."""
        run = Run(make(self.folder, "heap"))
        k = run.steady_output
        height = 0.15 - 0.36 * run.x
        z = run.field("z", k)
        z[:] = height * np.linspace(0.1, 0.97, z.shape[0])[:, None]
        run.field = lambda name, _: z
        s = np.linspace(0.0, 0.02, 30)
        cut = layer_profiles.Slice(run, k, height, 0.3, s)
        self.assertAlmostEqual(cut.slope, -0.36)
        self.assertAlmostEqual(layer_profiles.face_angle(cut), 29.2 + np.degrees(np.arctan(0.36)))
        np.testing.assert_allclose(cut.values(3.0 * (height - z), to_surface=True), 3.0 * s * np.hypot(1.0, 0.36), atol=1e-9)


class Drawing(WithFolder):
    def test_every_kind_of_run_is_drawn(self):
        cheap = (heap_shapes, mass_curves, layer_profiles)
        for kind, modules in (("periodic", PICTURES), ("no_stop", cheap), ("no_drain", cheap), ("sparse", cheap)):
            run = Run(make(self.folder, kind))
            for module in modules:
                with self.subTest(kind=kind, picture=module.__name__):
                    paths = module.draw(run, run.folder)
                    self.assertEqual(len(paths), PICTURES[module])
                    for path in paths:
                        image = look.plt.imread(path)[..., :3].reshape(-1, 3)
                        self.assertGreater(len(np.unique(image.round(2), axis=0)), 30, f"{path} is nearly blank")

    def test_film_is_left_blank(self):
        run = Run(make(self.folder, "heap"))
        film = run.is_film(run.field("height", run.steady_output))
        self.assertTrue(film[0] and not film[film.size // 2])

    def test_movies_of_fields_and_of_surfaces(self):
        for kind, scene in (("early", heap_movie.FieldScene), ("sparse", heap_movie.SurfaceScene)):
            with self.subTest(kind=kind):
                run = Run(make(self.folder, kind))
                times = heap_movie.frame_times(run)[:12]
                self.assertEqual(scene is heap_movie.FieldScene, bool(heap_movie.FieldScene.fits(run, times)))
                frames = heap_movie.Frames(run, scene(run))
                first, last = (np.frombuffer(frames.draw(t), np.uint8) for t in (times[1], times[-1]))
                look.plt.close(frames.figure)
                self.assertEqual(first.size, 4 * heap_movie.WIDTH * heap_movie.HEIGHT)
                self.assertGreater(np.count_nonzero(first != last), 1000)


class CommandLine(WithFolder):
    def test_pictures_and_movie_of_a_run(self):
        run = make(self.folder, "early")
        done = plot(run, "--movie", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        names = sorted(path.name for path in (self.folder / "out").iterdir())
        self.assertEqual(names, ["field_inertial_number.png", "field_pressure.png", "field_speed.png",
                                 "heap_shapes.png", "integrator.png", "mass.png", "movie.mp4", "profiles.png"])
        probe = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=width,height,pix_fmt",
                                "-of", "csv=p=0", self.folder / "out" / "movie.mp4"],
                               capture_output=True, text=True, check=True)
        width, height, pixels = probe.stdout.strip().split(",")
        self.assertEqual((int(width) % 2, int(height) % 2, pixels), (0, 0, "yuv420p"))

    def test_a_missing_run_is_said_plainly(self):
        for folder, words in ((self.folder / "nowhere", "no such folder"), (self.folder, "run.nc does not exist")):
            done = plot(folder)
            self.assertEqual(done.returncode, 3)
            self.assertIn(words, done.stderr)
            self.assertNotIn("Traceback", done.stderr)

    def test_a_file_that_is_not_netcdf_or_holds_no_time(self):
        broken, empty = self.folder / "broken", self.folder / "empty"
        broken.mkdir()
        empty.mkdir()
        (broken / "run.nc").write_text("not netCDF")
        with netCDF4.Dataset(empty / "run.nc", "w") as file:
            file.createDimension("time", None)
            file.createVariable("time", "f8", ("time",))
        with self.assertRaisesRegex(Missing, "cannot be read"):
            Run(broken)
        with self.assertRaisesRegex(Missing, "no output time yet"):
            Run(empty)

    def test_a_missing_variable_costs_one_picture(self):
        run = make(self.folder, "early")
        with netCDF4.Dataset(run / "run.nc", "a") as file:
            file.renameVariable("mass_stored", "something_else")
        done = plot(run)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("mass: left out, run.nc has no variable 'mass_stored'", done.stderr)
        self.assertTrue((run / "pictures" / "profiles.png").exists())
        self.assertFalse((run / "pictures" / "mass.png").exists())


if __name__ == "__main__":
    unittest.main()
