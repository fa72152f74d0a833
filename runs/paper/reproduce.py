"""All figures and tables of the paper that need no two-dimensional run: pictures, and a table of printed numbers beside ours.

    make paper      or      /usr/bin/python3 runs/paper/reproduce.py [--talus build/release/talus] [--out out/paper]
"""

import sys
import time

import appendix_a
import comparison
import figure_8
import figure_9
import figure_10
import figure_20
import figure_21
import reproduction
import table_2
from talus import Talus

PARTS = [("figure 8", figure_8), ("figure 9", figure_9), ("table 2", table_2), ("figure 10", figure_10), ("appendix A", appendix_a),
         ("figure 20", figure_20), ("figure 21", figure_21)]


def main():
    options = reproduction.arguments(__doc__)
    options.out.mkdir(parents=True, exist_ok=True)
    talus, rows = Talus(options.talus, options.out), []
    for name, part in PARTS:
        start = time.monotonic()
        paths, new = part.draw(talus, options.out)
        rows += new
        print(f"{name}: {', '.join([*(path.name for path in paths), f'{len(new)} rows'])} ({time.monotonic() - start:.1f} s)", file=sys.stderr)
    table = options.out / "table.md"
    table.write_text("\n".join(comparison.markdown(rows)) + "\n", encoding="utf-8")
    print(table)


if __name__ == "__main__":
    main()
