"""The reproduction of the paper runs, leaves its pictures, and says what runs/paper/README.md says: python3 paper.py PROGRAM

Lines about exact numbers must stand in the README word for word. Those about computed layers hold errors, which follow the integrator's
steps: here they must be small, there is what was measured."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "runs" / "paper"
COMPUTED = "against the exact curve"
LARGEST_ERROR = 0.05    # per cent, of speeds with 100 cells
PICTURES = {"figure_8.png", "figure_9.png", "figure_10.png", "figure_20.png", "figure_21.png"}
PROGRAM = sys.argv.pop()


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name)
        cls.done = subprocess.run([sys.executable, FOLDER / "reproduce.py", "--talus", PROGRAM, "--out", cls.out], capture_output=True,
                                 text=True, check=False)
        table = cls.out / "table.md"
        cls.lines = table.read_text(encoding="utf-8").splitlines() if table.exists() else []

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_ends_well(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_pictures(self):
        self.assertEqual({path.name for path in self.out.glob("*.png") if path.stat().st_size > 10_000}, PICTURES)

    def test_exact_numbers_are_those_of_the_readme(self):
        readme = (FOLDER / "README.md").read_text(encoding="utf-8").splitlines()
        exact = [line for line in self.lines if COMPUTED not in line]
        self.assertGreater(len(exact), 40)
        self.assertEqual([line for line in exact if line not in readme], [])

    def test_computed_layers_meet_the_exact_curves(self):
        computed = [line for line in self.lines if COMPUTED in line]
        self.assertGreater(len(computed), 10)
        for line in computed:
            for errors in re.findall(r"within ([0-9.e, -]+) %", line):
                self.assertLess(max(float(error) for error in errors.split(", ")), LARGEST_ERROR, line)


if __name__ == "__main__":
    unittest.main()
