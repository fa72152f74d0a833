"""Verdicts of src/plot on made-up runs: each says good of a sound run, and bad of the same run spoilt in one place."""

import json
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "src" / "plot"), str(ROOT / "tests" / "support")]

import netCDF4
import numpy as np
import synthetic_run
import verdicts
from run_data import Missing, Run

ENDED = {"status": "finished", "exit_code": 0, "reason": None, "simulated_seconds": 320.0, "end_seconds": 320.0,
         "well_posedness_verdict": "well-posedness: short waves grew nowhere in what flowed"}


class Verdicts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.sound = Path(holder.name)
        synthetic_run.write(cls.sound, "heap", nx=40, nz=16)
        with netCDF4.Dataset(cls.sound / "run.nc", "a") as file:
            file.setncatts({"exact_slope_deg": 48.81, "flowing_depth_m": 5.7e-3, "layers_in_flow": 9.3, "fewest_layers_in_flow": 4.0})
            file.createVariable("class_ill_posed_area", "f8", ("series_time",))[:] = 0.0

    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)
        shutil.copy(self.sound / "run.nc", self.folder)
        self.summarise(**ENDED)

    def summarise(self, **summary):
        (self.folder / "summary.json").write_text(json.dumps(summary))

    def spoil(self, name, change):
        with netCDF4.Dataset(self.folder / "run.nc", "a") as file:
            file[name][:] = change(file[name][:].filled())

    def verdict(self, name):
        return next(v for v in verdicts.of(Run(self.folder)) if v.name == name)

    def test_end(self):
        self.assertEqual(self.verdict("How it ended").state, "good")
        self.summarise(**{**ENDED, "status": "stopped", "exit_code": 75, "reason": "stopped by SIGTERM", "simulated_seconds": 20.0})
        stopped = self.verdict("How it ended")
        self.assertEqual((stopped.state, stopped.answer), ("note", "stopped at 20 s of 320 s"))
        self.assertIn("SIGTERM (exit code 75)", stopped.words)
        self.summarise(**{**ENDED, "status": "failed", "exit_code": 6, "reason": "IDA_CONV_FAIL"})
        self.assertEqual(self.verdict("How it ended").state, "bad")
        (self.folder / "summary.json").unlink()
        self.assertEqual(self.verdict("How it ended").state, "bad")

    def test_balance(self):
        self.assertEqual(self.verdict("Balance").state, "good")
        self.spoil("mass_error", lambda error: error + 1e-6)   # of 0.69 kg
        self.assertEqual(self.verdict("Balance").state, "note")
        self.spoil("mass_error", lambda error: error + 1e-2)
        self.assertEqual(self.verdict("Balance").state, "bad")

    def test_well_posedness(self):
        sound = self.verdict("Well-posedness")
        self.assertEqual((sound.state, sound.words), ("good", "Short waves grew nowhere in what flowed."))
        self.spoil("class_ill_posed_area", lambda share: np.where(np.arange(share.size) == 100, 0.03, share))
        self.assertEqual(self.verdict("Well-posedness").state, "note")
        self.spoil("class_ill_posed_area", lambda share: share + 0.3)
        self.assertEqual(self.verdict("Well-posedness").state, "bad")

    def test_resolution(self):
        self.assertEqual(self.verdict("Resolution of the flowing layer").state, "good")
        with netCDF4.Dataset(self.folder / "run.nc", "a") as file:
            file.layers_in_flow = 3.9
        self.assertEqual(self.verdict("Resolution of the flowing layer").state, "bad")

    def test_layers_are_counted_in_the_output(self):
        """The made-up speed falls as a power of the depth: 1 % of it lies 4.77 mm of 5 mm below the surface, normal to it."""
        run = Run(self.folder)
        k = run.steady_output
        height = run.field("height", k)
        j = (int(np.argmax(height)) + height.size - 1) // 2
        cosine = np.cos(np.arctan(np.gradient(height, run.x)[j]))
        deep = (height[j] - run.field("z", k)[:, j]) * cosine
        counted = verdicts.layers_that_move(run)
        self.assertAlmostEqual(counted, np.count_nonzero(deep < 4.77e-3), delta=1)
        self.assertGreater(counted, 3)

    def test_steadiness(self):
        """The made-up heap still grows: of the last 15 s of its inflow 94.2 % flows out, 0.0046 kg/s less 0.025 kg in 94 s."""
        growing = self.verdict("Steadiness")
        self.assertEqual((growing.state, growing.answer), ("note", "94.2 % flows out again"))
        with netCDF4.Dataset(self.folder / "run.nc", "a") as file:
            file["mass_outflow_right"][:] = file["mass_inflow"][:] - 0.1
        self.assertEqual(self.verdict("Steadiness").state, "good")
        self.spoil("mass_outflow_right", lambda mass: 0.8 * mass)
        self.assertEqual(self.verdict("Steadiness").state, "bad")

    def test_slope_stands_beside_the_exact_one(self):
        self.assertIn("exact and steady 48.81°", self.verdict("Slope").words)

    def test_what_a_model_lacks_is_left_out_with_its_reason(self):
        with netCDF4.Dataset(self.folder / "run.nc", "a") as file:
            file.renameVariable("heap_angle", "something_else")
        left = self.verdict("Slope")
        self.assertEqual((left.state, left.answer), ("none", "left out"))

    def test_broken_summary(self):
        (self.folder / "summary.json").write_text("{")
        with self.assertRaisesRegex(Missing, "summary.json cannot be read"):
            verdicts.of(Run(self.folder))


if __name__ == "__main__":
    unittest.main()
