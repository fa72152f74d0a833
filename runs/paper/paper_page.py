"""The reproduction as one self-contained HTML page: each figure with what the paper says, what Talus gets, the difference, the reason and
the cost; then every printed number in one table."""

from dataclasses import dataclass, field

import reproduction  # noqa: F401, finds src/plot
import page
from comparison import HEAD
from page import text

TITLE = "On the formation of super-stable granular heaps: the computed figures, computed again"
LEAD = ("Every computed figure and printed number of the paper (J. Fluid Mech., doi 10.1017/jfm.2024.1106) beside what Talus gets from the equations "
        "and parameters as printed. Where they differ, it says so and why. Curves lie beside each picture as CSV, fields in the run.nc of each run.")
TWO_FLUID = ("Heaps are computed by two models. The layer has its grid under a moving surface and is resolved. The two-fluid model is the paper's own, grains and "
             "excess air on fixed cells; here they are of 10 mm (20 mm in drafts), for finer ones take hours, and the layer that flows is 4 to 6 mm deep. Its heap stands "
             "and its mass is near, but it is not converged: the face is rough and 3.5 to 6 degrees too flat, the grains on it a quarter to a third as fast as they should be, the "
             "left side is filled level by a jet that is smeared on its way, so that some leave over the left end, and what is thinner than a cell stands instead of draining. It holds a heap at this size with eight times the drag of real air, a film on the "
             "base, and grains parted from air along the normal of the base; with the paper's own settings none stands.")
# Printed numbers that no computation here can meet, in groups: (where, numbers, why).
NOT_COMPARED = (
    ("section 1", "tan 23.3 deg, tan 33.7 deg, 0.1 to 0.8 mm, slopes above 60 deg, 2.5 times (Taberlet et al.)", "another material, whose law is not given"),
    ("section 1, figure 1", "angle of repose of about 22 deg", "measured; enters as mu_s = 0.4"),
    ("section 2, figure 2", "600 x 300 x 10 mm, 3 mm gap, 710 to 750 micrometres, coatings, 29.2 deg, Q", "the apparatus: input of the scenes, or without effect on them"),
    ("section 2, figure 6", "664 frames a second, 1000 images of 1000 x 120 pixels, 48.9 +- 0.1 deg, 0.44 deg", "how it was measured"),
    ("figures 5, 7, 10(a)", "measured masses, flows and profiles in time and depth", "drawn, not printed as numbers"),
    ("section 1", "I from 1e-3 to 1e-1 in the dense inertial regime", "a definition"),
    ("section 3.5", "a largest friction at I of 0.6 to 0.8 (particle simulations)", "another law than the paper's"),
    ("sections 5.1, 5.4", "air 0.01 and 1.81e-5 kg/(m s), inlet 0.02 m at 0.1 to 0.12 m, dilution 0.2, jet region 0.025 m and 0.02 m, CFL below 1",
     "choices of the method: input of the two-fluid scenes"),
    ("appendix B", "box of 0.21 x 0.0022 m, 0.2 m of grains, 0.01 m of air, four cells", "input of figures 20 and 21"))


@dataclass
class Part:
    """What a figure or table became."""
    name: str
    says: str                     # what the paper shows, in a sentence
    paths: list = field(default_factory=list)
    rows: list = field(default_factory=list)
    seconds: float = 0.0
    costs: list = field(default_factory=list)   # of kept runs, in words


def write(parts, program, cpu, path):
    """`cpu` lists (what, seconds of CPU)."""
    sections = [(name_of(part), part.name, of_part(part)) for part in parts]
    rows = [row for part in parts for row in part.rows]
    numbers = f"<p>{len(rows)} rows, in the order of the figures.</p>" + comparison(rows) + "<h3>Printed, and not compared</h3>" + page.table(
        ["where", "numbers", "why"], [[text(cell) for cell in row] for row in NOT_COMPARED])
    sections.append(("all_printed_numbers", "All printed numbers", numbers))
    sections.append(("provenance", "Provenance", page.folded("talus --version", program) + page.facts(
        [[text(part.name), f"{part.seconds:.1f} s"] for part in parts]) + "<h3>CPU</h3>" + page.facts([[text(what), f"{seconds:.0f} s"] for what, seconds in cpu])))
    path.write_text(page.document(TITLE, f"<h1>{text(TITLE)}</h1><p>{text(LEAD)}</p><p>{text(TWO_FLUID)}</p>", sections), encoding="utf-8")
    return path


def name_of(part):
    return part.name.lower().replace(" ", "_").replace(",", "")


def of_part(part):
    pictures = "".join(page.picture(image, f'numbers: <a href="{image.stem}.csv">{image.stem}.csv</a>' if image.with_suffix(".csv").exists() else
                                    "numbers: run.nc of the run named below") for image in part.paths)
    cost = "; ".join([f"{part.seconds:.1f} s for this section", *part.costs])
    return f"<p>{text(part.says)}</p>{pictures}" + (comparison(part.rows) if part.rows else "") + f'<p class="facts">Cost: {text(cost)}.</p>'


def comparison(rows):
    return page.table([text(word) for word in HEAD], [[text(cell) for cell in row.cells()] for row in rows], "comparison")
