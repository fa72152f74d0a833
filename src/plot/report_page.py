"""The report of a run: what was run, verdicts, figures, an animation, statistics and provenance on one page that needs nothing else."""

import io
import re
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

import column_movie
import heap_movie
import look
import page
import pictures
import verdicts
from look import plt
from page import text
from run_data import Missing

MOST_FRAMES = 161
FRAME_WIDTH = 1040   # pixels
FRAME_QUALITY = 70   # of WebP
PICTURE_DPI = 110


def draw(run, path, progress):
    """Writes the page to `path` and returns it. `progress` is told what is being drawn."""
    summary = verdicts.read_summary(run)
    figures, left_out = figures_of(run, progress)
    animation = animation_of(run, progress)
    sections = [("scene", "What was run", scene_of(run)), ("verdicts", "Verdicts", verdict_cards(run, summary)),
                ("animation", "The run in motion", animation), ("figures", "Figures", figures + omissions(left_out)),
                ("statistics", "Statistics", statistics_of(run, summary)), ("provenance", "Provenance", provenance_of(run, summary))]
    path.write_text(page.document(f"{run.name}: report", lead(run), sections), encoding="utf-8")
    return path


def lead(run):
    title = run.attribute("title", run.name)
    return (f"<h1>{text(title)}</h1><p class=\"facts\">Scene <b>{text(run.name)}</b>, model <b>{text(run.attribute('model', 'unknown'))}</b>, "
            f"{grid_words(run)}, {look.seconds(run.times[0])} to {look.seconds(run.times[-1])}, {run.times.size} outputs</p>")


def grid_words(run):
    sizes = run.data.sizes
    if "column" in sizes and "layer" in sizes:
        return f"{sizes['column']} column{'' if sizes['column'] == 1 else 's'} of {sizes['layer']} layers"
    return f"{sizes['layer']} layers" if "layer" in sizes else "one number in time"


# Verdicts

def verdict_cards(run, summary):
    words = {"good": "good", "note": "look", "bad": "bad", "none": ""}
    cards = [f'<div class="verdict {v.state}"><b>{text(v.name)}<span>{words[v.state]}</span></b><strong>{text(v.answer)}</strong>{text(v.words)}</div>'
             for v in verdicts.of(run)]
    warned = "".join(f'<div class="verdict note"><b>Warning before the run<span>look</span></b>{text(w)}</div>' for w in summary.get("warnings", []))
    bounds = (f"Balances are called good below {verdicts.BALANCE[0]:.0e} and bad above {verdicts.BALANCE[1]:.0e}; steadiness within "
              f"{100 * verdicts.STEADY[0]:.0f} and {100 * verdicts.STEADY[1]:.0f} %; well-posedness where short waves grow nowhere, and bad above "
              f"{100 * verdicts.ILL_POSED[1]:.0f} % of what flows.")
    return f'<div class="verdicts">{"".join(cards)}{warned}</div><p class="facts">{bounds}</p>{share_table(run)}'


def share_table(run):
    rows = []
    for name, words in (("ill_posed", "ill-posed: short waves grow"), ("damped", "C of (3.18) > 0, yet damped"), ("capped", "held by the viscosity's cap"),
                        ("well_posed", "well-posed")):
        if run.has(f"class_{name}_area"):
            area, flux = (100.0 * run.series(f"class_{name}_{kind}") for kind in ("area", "flux"))
            when = run.series_times[int(np.nanargmax(area))] if np.isfinite(area).any() else 0.0
            rows.append([words, f"{np.nanmax(area):.3g} %", look.seconds(when), f"{area[-1]:.3g} %", f"{np.nanmax(flux):.3g} %", f"{flux[-1]:.3g} %"])
    if not rows:
        return ""
    return "<h3>Shares of what flows</h3>" + page.table(["class", "of area, most", "at", "of area, at the end", "of flux, most", "of flux, at the end"], rows, "numbers")


# Pictures

def figures_of(run, progress):
    """The pictures of this run as HTML, and those left out as (words, reason)."""
    parts, left_out = [], []
    usual = plt.rcParams["savefig.dpi"]
    plt.rcParams["savefig.dpi"] = PICTURE_DPI
    try:
        with tempfile.TemporaryDirectory() as folder:
            for words, paint, caption in pictures.of(run):
                progress.begin(words)
                try:
                    paths = paint(run, Path(folder))
                except Missing as reason:
                    left_out.append((words, str(reason)))
                    progress.end(f"left out, {reason}")
                    continue
                parts += [page.picture(path, text(caption), len(parts) + 1 + i) for i, path in enumerate(paths)]
                progress.end(f"{len(paths)} drawn")
    finally:
        plt.rcParams["savefig.dpi"] = usual
    return "".join(parts), left_out


def omissions(left_out):
    rows = [[text(words), text(reason)] for words, reason in left_out]
    return "<h3>Left out</h3>" + page.table(["figure", "because"], rows) if rows else ""


def animation_of(run, progress):
    times = frame_times(run)
    if times.size < 2:
        return "<p>Left out: the run holds one output only.</p>"
    progress.begin("animation")
    try:
        frames = frames_of(run, times)
    except Missing as reason:
        progress.end(f"left out, {reason}")
        return f"<p>Left out: {text(reason)}.</p>"
    encoded = []
    for number, t in enumerate(times):
        encoded.append(encode(frames.draw(t), frames.figure))
        progress.show((number + 1) / times.size)
    plt.close(frames.figure)
    progress.end(f"{len(encoded)} frames")
    between = "" if run.is_column else " Between two outputs mesh and values are interpolated."
    return page.player(encoded, [f"t = {look.seconds(t)}" for t in times], ".webp",
                       f"Drag the slider, or press play; with the slider in focus the arrow keys step.{between}",
                       first=int(np.argmin(np.abs(times - cover_time(run)))))


def frame_times(run):
    """Evenly from the first output to the last; no more than one for each output of a short run, four for one of few."""
    n = min(MOST_FRAMES, max(4 * (run.times.size - 1) + 1, 2)) if run.duration > 0.0 else 1
    return np.linspace(run.times[0], run.times[-1], n)


def cover_time(run):
    """When there is most to see: a uniform layer at its fastest, a heap at its steepest."""
    return run.series_times[int(np.argmax(run.series("surface_speed")))] if run.is_column else run.times[run.steady_output]


def frames_of(run, times):
    if run.is_column:
        return column_movie.Frames(run)
    scene = heap_movie.FieldScene if run.has("speed", "z_node") else heap_movie.SurfaceScene
    return heap_movie.Frames(run, scene(run))


def encode(frame, figure):
    """WebP of a frame of RGBA bytes."""
    width, height = figure.canvas.get_width_height()
    image = Image.frombuffer("RGBA", (width, height), frame).convert("RGB")
    image = image.resize((FRAME_WIDTH, round(height * FRAME_WIDTH / width)), Image.Resampling.LANCZOS)
    buffer = io.BytesIO()
    image.save(buffer, "WEBP", quality=FRAME_QUALITY, method=2)
    return buffer.getvalue()


# Tables

def scene_of(run):
    scene = str(run.attribute("scene", ""))
    rows, part = [], ""
    for line in scene.splitlines():
        if line.startswith("["):
            part = line.strip("[]")
        stated = re.match(r"(\w+) = (.+?)(?:  # (.*))?$", line)
        if stated and not (stated[3] or "").endswith("default"):
            unit = "" if stated[3] in (None, "1") else f" {stated[3]}"
            rows.append([text(f"{part}.{stated[1]}"), text(stated[2].strip('"') + unit)])
    stated = page.facts(rows) if rows else "<p>run.nc holds no scene.</p>"
    return "<p>What the scene states; all else stands at its default.</p>" + stated + page.folded("The whole scene, defaults included", scene)


def statistics_of(run, summary):
    counts = [[text(str(name)[2:].replace("_", " ")), f"{run.series(name)[-1]:,.0f}"] for name in run.data
              if str(name).startswith("n_") and "series_time" in run.data[name].dims]
    parts = [("Counts", page.table([], counts, "numbers")), ("CPU seconds", page.table(*cpu_table(run), "numbers"))]
    if "wall_seconds" in summary:
        parts.append(("All in all", page.table([], [("wall time", f"{summary['wall_seconds']:.1f} s"), ("CPU time", f"{summary['cpu_seconds']:.1f} s"),
                                                    ("largest memory", f"{summary['peak_memory_bytes'] / 1e6:.0f} MB")], "numbers")))
    return page.beside(*parts)


def cpu_table(run):
    """Head and rows: CPU seconds by kind of work, while grains are poured and after that."""
    works = [(words, run.series(f"cpu_{name}")) for name, words in
             (("residual", "residuals"), ("jacobian", "Jacobians"), ("factor", "factorisations"), ("solve", "solves"))]
    stop = run.inflow_stop
    if stop is None:
        return ["work", "whole run"], [[words, f"{seconds[-1]:.3g}"] for words, seconds in works]
    i = int(np.argmin(np.abs(run.series_times - stop)))
    steps = run.series("n_steps")
    rows = [[words, f"{seconds[i]:.3g}", f"{seconds[-1] - seconds[i]:.3g}", f"{seconds[-1]:.3g}"] for words, seconds in works]
    return (["work", f"pouring, to {look.seconds(stop)}", "draining", "whole run"],
            rows + [["steps", f"{steps[i]:.0f}", f"{steps[-1] - steps[i]:.0f}", f"{steps[-1]:.0f}"]])


def provenance_of(run, summary):
    rows = [["program", text(run.attribute("source", "unknown"))], ["git revision", f"<code>{text(run.attribute('git_revision', 'unknown'))}</code>"],
            ["libraries", text(run.attribute("libraries", "unknown"))]]
    rows += [["command", f"<code>{text(line)}</code>"] for line in str(run.attribute("history", "unknown")).splitlines()]
    if summary.get("integrator"):
        rows.append(["integrator", text(summary["integrator"])])
    files = [[text(file.name), f"{file.stat().st_size / 1e6:.2f} MB"] for file in sorted(run.folder.iterdir()) if file.is_file() and file.suffix != ".html"]
    return page.table([], rows, "facts-table") + "<h3>Files of the run</h3>" + page.table([], files, "numbers")
