"""What the scripts of this folder share: the common look, the command line of a single figure, and the order of all."""

import argparse
import sys
from pathlib import Path

from talus import DEFAULT_OUT, DEFAULT_PROGRAM, ROOT, Talus

sys.path.insert(0, str(ROOT / "src" / "plot"))
import look  # noqa: E402
from look import plt  # noqa: E402,F401

import comparison  # noqa: E402

GAP_COLOURS = look.sequence_colours  # light to dark


def arguments(description):
    parser = argparse.ArgumentParser(description=description)
    parser.add_argument("--talus", type=Path, default=DEFAULT_PROGRAM, help="the program (default: build/release/talus)")
    parser.add_argument("--out", type=Path, default=DEFAULT_OUT, help="folder for pictures and tables (default: out/paper)")
    return parser.parse_args()


def main(draw):
    """Runs one figure by itself: draws it and prints its rows of the table."""
    options = arguments(sys.modules["__main__"].__doc__)
    options.out.mkdir(parents=True, exist_ok=True)
    paths, rows = draw(Talus(options.talus, options.out), options.out)
    print("\n".join([*comparison.markdown(rows), *(str(path) for path in paths)]))
