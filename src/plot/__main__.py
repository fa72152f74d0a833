"""Draws the pictures of a run, or the page of a study or a fit: python3 src/plot RUN_DIR [--out DIR] [--movie | --report]"""

import argparse
import os
import sys
import time
from pathlib import Path

OK, SETUP_FAILED, OUTPUT_FAILED = 0, 3, 5  # exit codes of talus
SYSTEM_PYTHON = "/usr/bin/python3"         # the one that Debian's packages serve


class Progress:
    """One line that rewrites itself on a terminal; a plain line a picture elsewhere."""

    def __init__(self, stream=sys.stderr):
        self.stream, self.live = stream, stream.isatty()

    def begin(self, words):
        self.words, self.start = words, time.monotonic()
        self.show(0.0)

    def show(self, fraction):
        if self.live:
            self.stream.write(f"\r\033[K{self.words} {100.0 * fraction:.0f} %")
            self.stream.flush()

    def end(self, result):
        taken = time.monotonic() - self.start
        self.stream.write(("\r\033[K" if self.live else "") + f"{self.words}: {result} ({taken:.1f} s)\n")
        self.stream.flush()


def arguments():
    parser = argparse.ArgumentParser(prog="python3 src/plot", description="Draws the pictures of a run of Talus.")
    parser.add_argument("run", type=Path, help="folder that holds run.nc or study.nc")
    parser.add_argument("--out", type=Path, help="folder for the pictures (default: 'pictures' in the run's folder)")
    parser.add_argument("--movie", action="store_true", help="a movie of the whole event, too")
    parser.add_argument("--report", action="store_true", help="one HTML page instead of pictures; --out is then its name")
    return parser.parse_args()


def draw_study(options, study_pages):
    progress = Progress()
    progress.begin("study")
    try:
        progress.end(study_pages.draw(options.run, options.out or options.run).name)
    except OSError as error:
        progress.end(f"failed, {error}")
        return OUTPUT_FAILED
    return OK


def draw_fit(fit_page, folder):
    try:
        print(fit_page.draw(folder)[0])
    except OSError as error:
        print(error, file=sys.stderr)
        return OUTPUT_FAILED
    return OK


def write_report(run, path):
    import report_page

    try:
        print(report_page.draw(run, path, Progress()))
    except OSError as error:
        print(f"{path} cannot be written: {error}", file=sys.stderr)
        return OUTPUT_FAILED
    return OK


def main():
    options = arguments()
    try:
        import fit_page
        import heap_movie
        import pictures
        import study_pages
        from run_data import Missing, Run
    except ImportError as error:
        if sys.prefix != "/usr" and os.access(SYSTEM_PYTHON, os.X_OK):  # another Python comes first on the PATH
            os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, *sys.argv])
        print(f"{error}: the pictures need python3-xarray, python3-netcdf4 and python3-matplotlib", file=sys.stderr)
        return SETUP_FAILED
    if options.report:
        try:
            return write_report(Run(options.run), options.out or options.run / "report.html")
        except Missing as error:
            print(error, file=sys.stderr)
            return SETUP_FAILED
    if (options.run / "study.nc").exists():
        return draw_study(options, study_pages)
    if (options.run / "fit.nc").exists() and not (options.run / "run.nc").exists():
        return draw_fit(fit_page, options.run)
    folder = options.out or options.run / "pictures"
    try:
        run = Run(options.run)
        folder.mkdir(parents=True, exist_ok=True)
    except (Missing, OSError) as error:
        print(error, file=sys.stderr)
        return SETUP_FAILED

    progress = Progress()
    drawn = [(words, draw) for words, draw, _ in pictures.of(run)]
    if options.movie:
        drawn.append(("movie", lambda run, folder: heap_movie.draw(run, folder, progress.show)))
    n_missing = 0
    for words, draw in drawn:
        progress.begin(words)
        try:
            progress.end(", ".join(path.name for path in draw(run, folder)))
        except Missing as reason:
            n_missing += 1
            progress.end(f"left out, {reason}")
        except OSError as error:
            progress.end(f"failed, {error}")
            return OUTPUT_FAILED
    return OUTPUT_FAILED if n_missing == len(drawn) else OK


if __name__ == "__main__":
    sys.exit(main())
