"""What the integrator did: step size, order, failures, CPU time, and the error of the balance that the model keeps."""

import numpy as np

import look
from look import plt

CPU = (("cpu_residual", "residuals", look.BLUE), ("cpu_jacobian", "Jacobians", look.GREEN),
       ("cpu_factor", "factorisations", look.ORANGE), ("cpu_solve", "solves", look.PURPLE))
COUNTS = (("n_steps", "steps", look.INK), ("n_factorisations", "factorisations", look.BLUE),
          ("n_error_test_failures", "error-test failures", look.ORANGE),
          ("n_newton_failures", "Newton failures", look.ACCENT))
TITLES = ("step size", "order of the method", "counters", "CPU time by kind of work")
ROUND_OFF = 1e-17  # errors below are drawn there


def draw(run, folder):
    t = run.series_times
    figure, panels = plt.subplots(5, 1, figsize=(8.2, 12.0), sharex=True, height_ratios=[3, 2, 3, 3, 3])
    size, order, counts, cpu, balance = panels

    step = run.series("last_step")
    size.semilogy(t, np.where(step > 0.0, step, np.nan), color=look.BLUE, linewidth=1.1)
    size.set_ylabel("last step [s]")
    order.step(t, run.series("order"), where="post", color=look.BLUE, linewidth=1.1)
    order.set(ylabel="order", yticks=range(1, 6), ylim=(0.5, 5.5))

    for name, words, colour in COUNTS:
        n = run.series(name)
        counts.plot(t, n, color=colour, label=f"{words}: {n[-1]:.0f}")
    counts.set_yscale("symlog", linthresh=10.0)
    counts.set(ylabel="cumulative count")
    counts.set_ylim(bottom=-0.5)
    counts.legend(loc="upper left", ncol=2, bbox_to_anchor=(0.0, 1.0))
    counts.set_ylim(top=30.0 * max(counts.get_ylim()[1], 10.0))

    used = [run.series(name) for name, _, _ in CPU]
    cpu.stackplot(t, *used, colors=[colour for _, _, colour in CPU], alpha=0.85, linewidth=0,
                  labels=[f"{words}: {seconds[-1]:.1f} s" for (_, words, _), seconds in zip(CPU, used)])
    cpu.set_ylabel("CPU time [s]")
    cpu.legend(loc="upper left", ncol=2)
    cpu.set_ylim(top=1.35 * max(cpu.get_ylim()[1], 1e-6))

    words, error = balance_error(run)
    balance.semilogy(t, np.maximum(error, ROUND_OFF), color=look.BLUE, linewidth=1.1)
    balance.set_ylim(0.5 * ROUND_OFF, max(2.0 * np.nanmax(error), 1e-8))
    balance.set(ylabel="relative error [1]", xlabel="time [s]", xlim=(t[0], max(t[-1], t[0] + 1e-9)))

    for number, (axes, words) in enumerate(zip(panels, (*TITLES, words))):
        look.label(axes, number, words)
        look.grid(axes)
    figure.suptitle(f"{run.name}: integrator")
    return [look.save(figure, folder, "integrator.png")]


def balance_error(run):
    """What the model conserves, in words, and its relative error in time."""
    if run.is_column:
        weight = np.nanmax(np.abs(run.series("weight")))
        return "momentum balance: |forces - rate of momentum| over the weight", np.abs(run.series("momentum_error")) / weight
    handled = max(np.nanmax(run.series("mass_inflow")), np.nanmax(run.series("mass_stored")))
    return "mass balance: |in - out - stored| over the mass handled", np.abs(run.series("mass_error")) / handled
