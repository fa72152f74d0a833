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
FIGURES = {f"figure_{n}" for n in range(8, 22)} | {"table_2", "appendix_a"}
SECTIONS = ("Figure 8", "Figure 9", "Table 2", "Figure 10", "Figure 11", "Figures 12 to 14", "Figure 15", "Figure 16", "Figures 17 and 18", "Figure 19",
            "Appendix A", "Figure 20", "Figure 21")
BOTH_MODELS = ("Figures 12 to 14", "Figure 15", "Figure 16", "Figures 17 and 18", "Figure 19")
# Of the paper's text, what it says and how: each must have a row.
SAID = (("reaches the outlet", "about 18 s"), ("steady from 106 s on", "essentially steady"), ("slope of the right face, 106 to 150 s", "about 50 deg"),
        ("right face at 18, 30.8, 56, 106 s", "steepens"), ("left and the right face", "approximately the same"), ("mass left at 320 s", "all drained"),
        ("left base of the pile begins", "by 290 s"), ("after shut-off, 154 s", "break"), ("mass left 89 s after", "0, experiment"), ("first grains on the balance", "about 1 s"),
        ("grains on the balance at 30 s", "above computation"), ("mass of the pile when the inflow ends", "slight"), ("I stays below 1.0297", "below"),
        ("upper bound of I", "1.0297"), ("classical flow for the two larger inflows", "none"), ("largest slope of the classical law, table 1", "29.1"),
        ("arctan(mu_d), table 2", "41.98"), ("tan 50 deg", "1.19"), ("tan 22 deg", "0.4"), ("slopes less the measured ones", "within 1.5 deg"), ("I_N", "0.05178"),
        ("ceases to be well-posed", "16.99"), ("becomes well-posed", "0.004"), ("where it ceases to be", "0.3"), ("largest pressure", "left"), ("top 5 mm of the face", "lithostatic"),
        ("cap acts", "deep in the pile"), ("profiles down the face", "superimposed"), ("heap without wall friction", "none forms"), ("static region up-slope", "there is one"),
        ("Froude numbers", "2/3"), *((f"slope at {Q} g/s", zeta) for Q, zeta in (("2.0", "43.3769"), ("4.6", "47.9899"), ("6.0", "49.5276"))),
        *((f"slope of the steady heap, {Q} g/s", zeta) for Q, zeta in (("2.0", "41.63"), ("4.6", "49.35"), ("6.0", "49.8"))),
        *((f"flow at {zeta} deg with d = 8 mm", Q) for zeta, Q in ((41, "0.1051"), (47, "0.5007"), (51, "1.2047"), (54, "2.2171"), (57, "3.9787"), (59, "5.8308"))),
        *((f"mass in the box at {t} s (areas", f"{m} kg") for t, m in (("7.2", 0.02), ("12.4", 0.045), ("16.8", 0.065), ("30.8", 0.11), ("56", 0.15), ("150", 0.175), ("151.2", 0.175),
                                                                     ("155.2", 0.16), ("174.4", 0.11), ("202", 0.08), ("252", 0.04), ("297.6", 0.01))),
        *((f"mass in the box at {t} s", f"about {m} kg") for t, m in ((6, 0.02), (12, 0.045), (20, 0.065), (43, 0.11), (83, 0.15), (321, 0.175))),
        *((f"mass in the box {t} s after", f"about {m} kg") for t, m in (("0.5", 0.175), ("3.5", 0.16), ("5.5", 0.11), ("29.5", 0.08), ("57.5", 0.04), ("83.5", 0.01))))
REFERENCE = re.compile(r"""(?:src|href|action|data|poster)\s*=\s*["']?(?!data:|#)([^"'\s>]+)|url\(\s*["']?(?!data:)([^)]+)|(@import[^;]*)""")
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
        self.assertEqual({path.stem for path in self.out.glob("*.csv") if path.stem in FIGURES and path.stat().st_size > 500}, FIGURES - with_fields)

    def test_one_page_holds_all(self):
        page = self.out / "index.html"
        self.assertLess(page.stat().st_size, LARGEST_PAGE)
        driver = self.driver(page)
        self.assertEqual(browser.fetched(driver), [])
        seen = browser.pictures(driver)
        self.assertEqual({alt.replace(" ", "_") for alt, width, complete in seen if complete and width > 300}, FIGURES)
        self.assertLessEqual(browser.overflow(driver, 390), 0)
        rows = driver.execute_script("return document.querySelectorAll('#all_printed_numbers .comparison tbody tr').length")
        self.assertEqual(rows, len(self.lines) + len(self.heap_lines) - 4)  # two heads of two lines

    def driver(self, page):
        driver = browser.start()
        self.addCleanup(driver.quit)
        self.assertEqual(browser.open_page(driver, page), [])
        return driver

    def test_the_page_names_nothing_but_the_numbers_beside_it(self):
        """Everything that a browser would fetch is in the page; links lead to files of its own folder, which are there."""
        found = {"".join(groups) for groups in REFERENCE.findall((self.out / "index.html").read_text(encoding="utf-8"))}
        self.assertGreater(len(found), 10)
        self.assertEqual({name for name in found if not name.endswith(".csv") or not (self.out / name).is_file()}, set())

    def test_every_figure_has_picture_print_ours_difference_reason_and_cost(self):
        driver = self.driver(self.out / "index.html")
        parts = dict(driver.execute_script("""return [...document.querySelectorAll('main > section')].map((s) => [s.querySelector('h2').textContent,
            [s.querySelectorAll('img').length, [...s.querySelectorAll('.comparison th')].map((h) => h.textContent), s.textContent]])"""))
        self.assertEqual(tuple(parts)[:len(SECTIONS)], SECTIONS)
        for name in SECTIONS:
            pictures, head, words = parts[name]
            self.assertGreaterEqual(pictures, 1, name)
            self.assertEqual(head, ["where", "what", "paper", "here", "difference", "reason"], name)
            self.assertRegex(words, r"Cost: [\d.]+ s", name)
        for name in BOTH_MODELS:
            self.assertIn(", layer", parts[name][2])
            self.assertIn(", two-fluid", parts[name][2])
            self.assertRegex(parts[name][2], r"two_fluid_heap\w+_draft, 30x15 cells: \d+ s of CPU", name)

    def test_what_the_text_says_has_a_row(self):
        rows = [line.split(" | ") for line in self.lines + self.heap_lines if line.startswith("| ")]
        self.assertEqual([said for said in SAID if not any(said[0] in row[1] and said[1] in row[2] for row in rows)], [])

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
        self.assertEqual(len(list(self.out.glob("runs/*heap*/run.nc"))), 9)
        runs = {path: path.stat().st_mtime_ns for path in self.out.glob("runs/*/run.nc")}
        for figure in ("figure_16.py", "figure_21.py"):
            again = subprocess.run([sys.executable, FOLDER / figure, *map(str, self.command[2:])], capture_output=True, text=True, check=False)
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
