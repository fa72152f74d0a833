"""`talus report` of a run by each model, opened in a real browser; and what it says of folders that hold no run: report.py PROGRAM"""

import json
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "support"))

import browser
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

PROGRAM = sys.argv.pop()
EXAMPLES = ROOT / "runs" / "examples"
SMALL = ("time.end=8", "output.times=[2,4,8]", "output.interval=2", "output.series_interval=0.5")
RUNS = {"layer": (EXAMPLES / "heap_q46.toml", ("grid.columns=40", "grid.layers=8", *SMALL)),
        "triangle": (EXAMPLES / "heap_q46.toml", ("model.name=triangle", *SMALL)),
        "column": (EXAMPLES / "column_start.toml", ("grid.layers=30", "output.times=[0.2,1,3,6]")),
        "two_fluid": (ROOT / "runs" / "benchmarks" / "two_fluid_heap.toml",
                      ("grid.columns=30", "grid.layers=15", "time.end=2", "output.times=[1,2]", "output.interval=1"))}
LARGEST_PAGE = 15e6  # bytes
PICTURES = {"layer": 8, "triangle": 3, "column": 5, "two_fluid": 7}  # at least, the frame of the animation left aside
SECTIONS = ["scene", "verdicts", "animation", "figures", "statistics", "provenance"]


def talus(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], capture_output=True, text=True, check=False)


def each_page(test):
    """The test on the page of each model, freshly opened; it is told what the console said."""
    def on_all(self):
        for model, page in self.pages.items():
            with self.subTest(model=model):
                test(self, model, page, browser.open_page(self.driver, page))
    return on_all


class Pages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        holder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(holder.cleanup)
        cls.folder = Path(holder.name)
        cls.pages = {model: cls.made(model, *run) for model, run in RUNS.items()}
        cls.driver = browser.start()
        cls.addClassCleanup(cls.driver.quit)

    @classmethod
    def made(cls, model, scene, sets):
        out = cls.folder / model
        for done in (talus("run", scene, "--out", out, *(word for one in sets for word in ("--set", one))), talus("report", out)):
            if done.returncode != 0:
                raise AssertionError(f"{model}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
        return out / "report.html"

    def frame(self):
        """Number of the frame that is shown, and its picture, read back in small."""
        return self.driver.execute_script("""
            const image = document.getElementById("frame"), canvas = document.createElement("canvas");
            [canvas.width, canvas.height] = [200, 150];
            canvas.getContext("2d").drawImage(image, 0, 0, 200, 150);
            return [Number(image.dataset.frame), image.naturalWidth > 0 ? canvas.toDataURL() : ""];""")

    def wait_for(self, true):
        """Whether it became true within a time that is long even on a busy machine."""
        deadline = time.monotonic() + 60.0
        while not true() and time.monotonic() < deadline:
            time.sleep(0.05)
        return true()

    @each_page
    def test_loads_without_complaint_and_asks_for_nothing(self, model, page, console):
        self.assertEqual(console, [])
        self.assertEqual(browser.fetched(self.driver), [])
        self.assertLess(page.stat().st_size, LARGEST_PAGE)
        ids = [part.get_attribute("id") for part in self.driver.find_elements(By.TAG_NAME, "section")]
        self.assertEqual(ids, SECTIONS)

    @each_page
    def test_pictures_are_seen(self, model, page, console):
        seen = browser.pictures(self.driver)
        self.assertGreaterEqual(len(seen), 1 + PICTURES[model])
        self.assertEqual([picture for picture in seen if not picture[2] or picture[1] < 300], [])

    @each_page
    def test_slider_moves_the_animation(self, model, page, console):
        slider, clock = (self.driver.find_element(By.ID, name) for name in ("slider", "clock"))
        slider.send_keys(Keys.HOME)
        (first, begin), then = self.frame(), clock.text
        slider.send_keys(Keys.END)
        last, end = self.frame()
        self.assertEqual((first, last), (0, int(slider.get_attribute("max"))))
        self.assertNotEqual(begin, end)
        self.assertNotEqual(clock.text, then)
        slider.send_keys(Keys.ARROW_LEFT)
        self.assertEqual(self.frame()[0], last - 1)

    @each_page
    def test_animation_plays_and_pauses(self, model, page, console):
        self.driver.find_element(By.CSS_SELECTOR, "#rate option").click()  # slow
        self.driver.find_element(By.ID, "play").click()
        began, picture = self.frame()
        self.assertTrue(self.wait_for(lambda: self.frame()[0] >= began + 3))
        self.assertNotEqual(self.frame()[1], picture)
        # In one go, for a short film may end by itself, and a click would then play it again.
        still = self.driver.execute_script("""
            const play = document.getElementById("play");
            if (play.getAttribute("aria-label") === "pause") play.click();
            return Number(document.getElementById("frame").dataset.frame);""")
        time.sleep(0.4)
        self.assertEqual(self.frame()[0], still)

    @each_page
    def test_narrow_windows_need_no_sideways_scrolling(self, model, page, console):
        self.assertLessEqual(browser.overflow(self.driver, 390), 0)

    @each_page
    def test_says_what_the_run_said(self, model, page, console):
        words = self.driver.find_element(By.TAG_NAME, "body").text
        summary = json.loads((page.parent / "summary.json").read_text())
        for wanted in (f"finished at {summary['end_seconds']:g} s", f"model {model}", summary["git_revision"], f"{summary['statistics']['steps']:,}"):
            self.assertIn(wanted, words)
        if summary["well_posedness_verdict"]:
            self.assertIn(summary["well_posedness_verdict"].partition(": ")[2][1:], words)
        headings = [heading.text for heading in self.driver.find_elements(By.TAG_NAME, "h3")]
        self.assertEqual("Left out" in headings, model == "triangle", headings)
        if model != "two_fluid":  # in two seconds it has no face with a slope yet
            self.assertEqual("left out" in words.lower(), model != "layer")


class Failures(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = Path(holder.name)

    def refused(self, code, *words, out=()):
        done = talus("report", self.folder / "run", *out)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def run_of_triangle(self):
        done = talus("run", EXAMPLES / "heap_q46.toml", "--out", self.folder / "run",
                     *(word for one in RUNS["triangle"][1] for word in ("--set", one)))
        self.assertEqual(done.returncode, 0, done.stderr)
        return self.folder / "run"

    def test_no_folder_no_run_and_other_results(self):
        self.refused(2, "holds no run (no run.nc)")
        (self.folder / "run").mkdir()
        self.refused(2, "holds no run (no run.nc)")
        (self.folder / "run" / "study.nc").write_bytes(b"")
        self.refused(2, "study.nc", "talus plot")

    def test_truncated_file(self):
        data = self.run_of_triangle() / "run.nc"
        data.write_bytes(data.read_bytes()[:data.stat().st_size // 3])
        self.refused(3, "run.nc cannot be read as netCDF")

    def test_summary_that_is_no_json(self):
        (self.run_of_triangle() / "summary.json").write_text("{")
        self.refused(3, "summary.json cannot be read")

    def test_page_that_cannot_be_written(self):
        self.run_of_triangle()
        self.refused(5, "cannot be written", out=("--out", self.folder / "nowhere" / "page.html"))

    def test_killed_run_is_reported_as_such(self):
        folder = self.run_of_triangle()
        (folder / "summary.json").unlink()
        done = talus("report", folder, "--out", self.folder / "page.html")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("the run goes on still, or was killed", (self.folder / "page.html").read_text())
        shutil.rmtree(folder)


if __name__ == "__main__":
    unittest.main()
