"""The reproduction of the paper runs, leaves its pictures, and says what runs/paper/README.md says: python3 paper.py PROGRAM

Lines about exact numbers must stand in the README word for word. Those about computed layers hold errors, which follow the integrator's
steps: here they must be small, there is what was measured. Heaps are run at draft quality."""

import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

FOLDER = Path(__file__).resolve().parents[2] / "runs" / "paper"
COMPUTED = "against the exact curve"
LARGEST_ERROR = 0.05    # per cent, of speeds with 100 cells
FIGURES = {f"figure_{n}" for n in range(8, 22)}
LARGEST_PAGE = 15e6     # bytes
PROGRAM = sys.argv.pop()

sys.path.insert(0, str(FOLDER.parents[1] / "tests" / "support"))
import browser


class Paper(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.out = Path(cls.folder.name)
        cls.command = [sys.executable, FOLDER / "reproduce.py", "--talus", PROGRAM, "--out", cls.out, "--preset", "draft"]
        cls.done = subprocess.run(cls.command, capture_output=True, text=True, check=False)
        cls.lines, cls.heap_lines = (table.read_text(encoding="utf-8").splitlines() if table.exists() else []
                                     for table in (cls.out / "table.md", cls.out / "heap_table.md"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_ends_well(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)

    def test_pictures_and_their_numbers(self):
        self.assertEqual({path.stem for path in self.out.glob("*.png") if path.stat().st_size > 10_000}, FIGURES)
        with_fields = {"figure_13", "figure_14"}  # in run.nc
        self.assertEqual({path.stem for path in self.out.glob("figure_*.csv") if path.stat().st_size > 1_000}, FIGURES - with_fields)

    def test_one_page_holds_all(self):
        page = self.out / "index.html"
        self.assertLess(page.stat().st_size, LARGEST_PAGE)
        driver = browser.start()
        self.addCleanup(driver.quit)
        self.assertEqual(browser.open_page(driver, page), [])
        self.assertEqual(browser.fetched(driver), [])
        seen = browser.pictures(driver)
        self.assertEqual({alt.replace(" ", "_") for alt, width, complete in seen if complete and width > 300}, FIGURES)
        self.assertLessEqual(browser.overflow(driver, 390), 0)
        rows = driver.execute_script("return document.querySelectorAll('#all_printed_numbers .comparison tbody tr').length")
        self.assertEqual(rows, len(self.lines) + len(self.heap_lines) - 4)  # two heads of two lines

    def test_heaps_give_what_they_gave(self):
        """At draft quality: the steady slope within a degree of the exact one, masses of figure 12 from 30 s to the shut-off within 15 %."""
        slope = self.number("slope of the steady heap, 4.6 g/s")
        self.assertLess(abs(slope - 48.81), 1.0)
        for t, printed in ((30.8, 0.11), (56, 0.15), (150, 0.175)):
            self.assertLess(abs(self.number(f"mass in the box at {t:g} s") / printed - 1.0), 0.15)
        self.assertFalse([line for line in self.heap_lines if "nan" in line])

    def number(self, what):
        """Ours, in the first row of that name."""
        line = next(line for line in self.heap_lines if what in line)
        return float(re.match(r"[-+0-9.e]+", line.split("|")[4].strip())[0])

    def test_runs_are_kept(self):
        runs = {path: path.stat().st_mtime_ns for path in self.out.glob("runs/heap*/run.nc")}
        self.assertEqual(len(runs), 5)
        again = subprocess.run([sys.executable, FOLDER / "figure_16.py", *map(str, self.command[2:])], capture_output=True, text=True, check=False)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("running", again.stderr)
        self.assertEqual(runs, {path: path.stat().st_mtime_ns for path in runs})

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
