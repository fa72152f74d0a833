"""What a run's output says of its own worth: how it ended, what it kept, whether it is resolved, steady and well-posed."""

import json
from dataclasses import dataclass

import numpy as np

import look
from run_data import Missing
from solver_history import balance_error

# What is called good, and what bad; between them lies a note.
BALANCE = (1e-8, 1e-4)     # largest relative error of the balance
STEADY = (0.02, 0.1)       # relative change over the last tenth, or outflow off the inflow
ILL_POSED = (0.0, 0.05)    # largest share of the flowing area where short waves grow
MOVING = 0.01              # of the surface speed: the flowing layer ends where it is slower


@dataclass(frozen=True)
class Verdict:
    name: str
    state: str      # good, note, bad, or none where the run gives nothing to judge
    answer: str
    words: str = ""


def judge(value, bounds):
    return "good" if value <= bounds[0] else "note" if value <= bounds[1] else "bad"


def read_summary(run):
    """summary.json; empty where there is none yet."""
    try:
        return json.loads((run.folder / "summary.json").read_text(encoding="utf-8"))
    except FileNotFoundError:
        return {}
    except (OSError, ValueError) as error:
        raise Missing(f"{run.folder / 'summary.json'} cannot be read: {error}") from error


def of(run):
    """All verdicts. One that this run cannot have says why."""
    summary = read_summary(run)
    questions = (("How it ended", ending), ("Balance", balance), ("Well-posedness", well_posedness),
                 ("Resolution of the flowing layer", resolution), ("Steadiness", steadiness), ("Slope", slope))
    found = []
    for name, ask in questions:
        try:
            found.append(Verdict(name, *ask(run, summary)))
        except Missing as reason:
            found.append(Verdict(name, "none", "left out", f"{reason}."))
    return found


def ending(run, summary):
    if not summary:
        return "bad", f"last record at {look.seconds(run.times[-1])}", "There is no summary.json: the run goes on still, or was killed."
    reached, end = summary["simulated_seconds"], summary["end_seconds"]
    answer = f"{summary['status']} at {look.seconds(reached)}"
    if summary["status"] == "finished":
        again = summary.get("continued_from", [])
        return "good", answer, f"Continued {len(again)} time{'' if len(again) == 1 else 's'} from a checkpoint." if again else "In one go."
    state = "bad" if summary["status"] == "failed" else "note"
    return state, f"{answer} of {look.seconds(end)}", f"{summary['reason']} (exit code {summary['exit_code']})."


def balance(run, summary):
    words, error = balance_error(run)
    worst = float(np.nanmax(error))
    name, _, rest = words.partition(": ")
    answer = f"{name} kept to {worst:.1e}" if worst > 0.0 else f"{name} kept to the last bit"
    more = f"Largest of {rest}."
    if run.has("phi_min"):
        more += f" phi stayed between {run.series('phi_min').min():.3g} and 1 {run.series('phi_max').max() - 1.0:+.1e}."
    return judge(worst, BALANCE), answer, more


def well_posedness(run, summary):
    if run.has("class_ill_posed_area"):
        most = float(np.nanmax(run.series("class_ill_posed_area")))
        sentence = str(summary.get("well_posedness_verdict") or "").partition(": ")[2]
        sentence = sentence[:1].upper() + sentence[1:] + "." if sentence else "The summary holds no sentence on it."
    elif not run.has("growing_share"):
        raise Missing("the model does not say where it is well-posed")
    else:
        most = float(np.nanmax(run.series("growing_share")))
        sentence = f"C of (3.18) was positive in at most {percent(np.nanmax(run.series('ill_posed_share')))} of the flowing area."
    return judge(most, ILL_POSED), f"short waves grow in at most {percent(most)}", sentence


def resolution(run, summary):
    if not run.has("speed"):
        raise Missing("the model has no layers: flow on its face is the exact one")
    counted = layers_that_move(run)
    depth, layers, needed = (run.attribute(name) for name in ("flowing_depth_m", "layers_in_flow", "fewest_layers_in_flow"))
    measured = f"Counted in the middle of what flows at {look.seconds(run.times[run.steady_output])}: {counted} faster than 1 % of the surface."
    if layers is None:
        return "none", f"{counted} layers move", f"{measured} No steady state is known to judge it by."
    state = "good" if layers >= needed else "bad"
    return state, f"{layers:.1f} layers in {1e3 * depth:.1f} mm", f"Of the exact steady flow; at least {needed:.0f} are asked for. {measured}"


def layers_that_move(run):
    """Layers in the column in the middle of the right face that are faster than MOVING of the surface."""
    k = run.steady_output
    speed = run.grains_only(run.field("speed", k), k)
    if speed.ndim == 2:
        height = run.field("height", k)
        speed = speed[:, (int(np.argmax(height)) + height.size - 1) // 2]
    speed = speed.compressed()
    return int(np.count_nonzero(speed > MOVING * speed[-1])) if speed.size and speed[-1] > 0.0 else 0


def steadiness(run, summary):
    stop = run.inflow_stop
    end = stop if stop is not None else run.series_times[-1]
    first = run.series_times[0] + 0.9 * (end - run.series_times[0])
    last = np.flatnonzero(run.series_times <= end)[-1]
    begin = int(np.argmin(np.abs(run.series_times - first)))
    if begin == last:
        raise Missing("the last tenth of the time holds one record only")
    when = f"between {look.seconds(run.series_times[begin])} and {look.seconds(run.series_times[last])}"
    if float(run.attribute("inflow_rate_kg_s", 0.0)) > 0.0:
        out = sum(mass[last] - mass[begin] for mass in (run.series("mass_outflow_right"), run.series("mass_outflow_left")))
        ratio = out / (run.series("mass_inflow")[last] - run.series("mass_inflow")[begin])
        words = f"Outflow over inflow {when}"
        if run.has("heap_angle"):
            change = run.series("heap_angle")[last] - run.series("heap_angle")[begin]
            words += f"; the slope changed by {change:+.2f}° in that time" if np.isfinite(change) else "; no face is long enough for a slope"
        return judge(abs(ratio - 1.0), STEADY), f"{100.0 * ratio:.1f} % flows out again", words + "."
    if not run.has("mass_flow"):
        raise Missing("nothing is poured, and the model tells no mass flow")
    flow = run.series("mass_flow")
    largest = np.nanmax(np.abs(flow))
    change = (flow[last] - flow[begin]) / largest if largest > 0.0 else 0.0
    return judge(abs(change), STEADY), f"mass flow changes by {100.0 * change:+.2g} %", f"Of its largest value, {when}."


def slope(run, summary):
    if not run.has("heap_angle"):
        raise Missing("the model has no heap")
    measured = run.series("heap_angle")[int(np.argmin(np.abs(run.series_times - run.times[run.steady_output])))]
    exact = run.attribute("exact_slope_deg")
    if not np.isfinite(measured):
        raise Missing("no face is long enough for a slope")
    if exact is None or float(run.attribute("inflow_rate_kg_s", 0.0)) <= 0.0:
        return "none", f"{measured:.2f}°", "No exact slope is known for this scene."
    words = f"At {look.seconds(run.times[run.steady_output])}; exact and steady {exact:.2f}°, off by {measured - exact:+.2f}°."
    if run.attribute("regularised_slope_deg") is not None:
        words += f" With this scene's wall-friction speed and regularisations {run.attribute('regularised_slope_deg'):.2f}°."
    return "none", f"{measured:.2f}°", words


def percent(share):
    return f"{100.0 * share:.3g} %"
