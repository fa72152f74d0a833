"""All computed figures and tables of the paper: pictures, their numbers, printed numbers beside ours, and one page of it all, index.html.

    make paper      or      /usr/bin/python3 runs/paper/reproduce.py [--talus build/release/talus] [--out out/paper] [--preset standard]

The heaps behind figures 12 to 19 are run once and kept; a call that was stopped is gone on from."""

import resource
import sys
import time

import appendix_a
import comparison
import figure_8
import figure_9
import figure_10
import figure_11
import figure_12
import figure_15
import figure_16
import figure_17
import figure_19
import figure_20
import figure_21
import heap_runs
import reproduction
import table_2
from paper_page import Part, write
from talus import Talus

EXACT = (
    ("Figure 8", figure_8, "Friction of the classical and the partially regularised law, and where the equations are well-posed."),
    ("Figure 9", figure_9, "Profiles of both laws at two slopes, and slope against inflow: the classical law ends before the larger inflows."),
    ("Table 2", table_2, "Parameters fitted to the three heaps, and the slopes that should follow from them."),
    ("Figure 10", figure_10, "Speed and inertial number through the depth at the three inflows, by theory."),
    ("Appendix A", appendix_a, "From deposits on a rough plane to the classical law."),
    ("Figure 20", figure_20, "Six steep layers in a periodic box against the exact profiles."),
    ("Figure 21", figure_21, "Five gaps, and Bagnold's profile for the widest."))
HEAPS = (
    ("Figure 11", figure_11, "The dilute jet alone: volume fraction, speed, and the flow through each height."),
    ("Figures 12 to 14", figure_12, "Speed, pressure and inertial number as the heap grows for 150 s and drains."),
    ("Figure 15", figure_15, "Mass on the balance in time, against the experiment's; what the text says of the event. What the paper misses, basal slip, closes the gap: "
     "on a base of friction 0.25 growth and drain follow the experiment within 9 g. Navier's slip does as much with a length of 15 mm (runs/studies)."),
    ("Figure 16", figure_16, "Steady heaps of the three inflows, each slightly steeper than the measured."),
    ("Figures 17 and 18", figure_17, "Profiles of speed down the face, which fall together, and beside the exact ones."),
    ("Figure 19", figure_19, "Without wall friction no heap stands; a Bagnold flow runs down the base."))


def main():
    options = reproduction.arguments(__doc__)
    options.out.mkdir(parents=True, exist_ok=True)
    talus = Talus(options.talus, options.out, options.preset)
    tables, parts = {}, []
    for table, group in (("table.md", EXACT), ("heap_table.md", HEAPS)):
        done = [draw(talus, options.out, *one) for one in group]
        tables[table] = [row for part in done for row in part.rows]
        parts += done
        (options.out / table).write_text("\n".join(comparison.markdown(tables[table])) + "\n", encoding="utf-8")
    parts.sort(key=lambda part: order(part.name))
    print(write(parts, talus.call("--version"), [("this call, in all", cpu_seconds()), *heap_runs.cpu_seconds(talus)], options.out / "index.html"))


def cpu_seconds():
    """Of this process and all that it started and waited for."""
    return sum(time for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN) for time in resource.getrusage(who)[:2])


def draw(talus, folder, name, module, says):
    start = time.monotonic()
    part = Part(name, says)
    part.paths, part.rows = module.draw(talus, folder)
    part.seconds = time.monotonic() - start
    part.costs = module.costs(talus) if hasattr(module, "costs") else []
    said = ", ".join([*(path.name for path in part.paths), f"{len(part.rows)} rows"])
    print(f"{name}: {said} ({part.seconds:.1f} s)", file=sys.stderr)
    return part


def order(name):
    """As the paper has them: figures by number, table 2 with figure 10, appendix A before figure 20."""
    digits = "".join(c if c.isdigit() else " " for c in name).split()
    return {"Table 2": 9.5, "Appendix A": 19.5}.get(name) or float(digits[0])


if __name__ == "__main__":
    main()
