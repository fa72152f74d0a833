"""What the scripts of this folder share: the common look, pictures with their numbers, and the command line of a single figure."""

import argparse
import csv
import sys
from pathlib import Path

from talus import DEFAULT_OUT, DEFAULT_PROGRAM, ROOT, Talus

sys.path.insert(0, str(ROOT / "src" / "plot"))
import look  # noqa: E402
from look import plt  # noqa: E402,F401

import comparison  # noqa: E402

GAP_COLOURS = look.sequence_colours  # light to dark
PRESETS = ("draft", "standard", "fine")


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--talus", type=Path, default=DEFAULT_PROGRAM, help="the program (default: build/release/talus)")
    parser.add_argument("--out", type=Path, default=DEFAULT_OUT, help="folder for pictures, tables and runs (default: out/paper)")
    parser.add_argument("--preset", choices=PRESETS, default="standard", help="accuracy of the heaps (default: standard)")
    return parser.parse_args()


def main(draw):
    """Runs one figure by itself: draws it and prints its rows of the table."""
    options = arguments(sys.modules["__main__"].__doc__)
    options.out.mkdir(parents=True, exist_ok=True)
    paths, rows = draw(Talus(options.talus, options.out, options.preset), options.out)
    print("\n".join([*comparison.markdown(rows), *(str(path) for path in paths)]))


def save(figure, folder, name):
    """Writes the picture and, beside it, all its curves as CSV: one line a point, with panel, axes and label."""
    with open((folder / name).with_suffix(".csv"), "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(["panel", "x_axis", "y_axis", "curve", "x", "y"])
        for axes in figure.axes:
            for panel in (axes, *axes.child_axes):
                write_curves(writer, panel)
    return look.save(figure, folder, name)


def write_curves(writer, axes):
    head = [axes.get_title(loc="left"), axes.get_xlabel(), axes.get_ylabel()]
    for number, line in enumerate(axes.get_lines()):
        label = line.get_label()
        x, y = line.get_xdata(orig=True), line.get_ydata(orig=True)
        if len(x) > 0:
            writer.writerows([*head, f"curve {number + 1}" if label.startswith("_") else label, f"{a:.9g}", f"{b:.9g}"] for a, b in zip(x, y))
