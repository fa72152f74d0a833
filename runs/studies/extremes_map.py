"""The map of extremes: a row a factor and scene, a cell a value, its colour how the run ended, its numbers steps and failures."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = {"right": "#a6dba0", "refused": "#c2d8ee", "failed, placed": "#fdd49e", "wrong": "#d7301f", "too long": "#fc8d59", "bad": "#67001f"}


def numbers(row):
    if row["steps"] in (None, ""):
        return ""
    failures = int(row["newton_failures"]) + int(row["error_test_failures"])
    return f"{row['steps']}" + (f" ({failures})" if failures else "")


def draw(rows, path):
    lines = {}
    for row in rows:
        lines.setdefault((row["factor"], row["scene"]), []).append(row)
    widest = max(len(line) for line in lines.values())
    figure, axes = plt.subplots(figsize=(2.6 + 0.95 * widest, 1.0 + 0.27 * len(lines)))
    for y, ((factor, scene), line) in enumerate(lines.items()):
        unit = f" [{line[0]['unit']}]" if line[0]["unit"] else ""
        axes.text(-0.1, y + 0.5, f"{factor}{unit}  {scene}", ha="right", va="center", fontsize=7)
        for x, row in enumerate(line):
            dark = row["outcome"] in ("wrong", "bad")
            axes.add_patch(plt.Rectangle((x, y), 0.96, 0.92, color=COLOURS[row["outcome"]], lw=0))
            axes.text(x + 0.04, y + 0.46, row["value"], ha="left", va="center", fontsize=6, weight="bold", color="white" if dark else "black")
            axes.text(x + 0.93, y + 0.46, numbers(row), ha="right", va="center", fontsize=6, color="white" if dark else "black")
    axes.set(xlim=(0, widest), ylim=(len(lines), 0))
    axes.axis("off")
    met = [name for name in COLOURS if any(row["outcome"] == name for row in rows)]
    figure.legend([plt.Rectangle((0, 0), 1, 1, color=COLOURS[name]) for name in met], met, ncol=len(met), fontsize=7, frameon=False,
                  loc="upper center", title="bold: the value; then steps (failures of Newton's method and of the error test)", title_fontsize=7)
    figure.tight_layout(rect=(0.12, 0, 1, 1 - 0.45 / figure.get_figheight()))
    figure.savefig(path, dpi=80)
    plt.close(figure)
