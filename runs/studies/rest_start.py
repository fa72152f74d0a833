"""What it costs to start a layer from rest: Newton failures, steps and factorisations against the grid and each regularisation that
makes rest stiff, as tables in Markdown. With several programs (--program, say of two versions) the same tables of each.
"""

import argparse
import pathlib

from short_runs import PROGRAM, run_all

COLUMN = {"model.name": "column", "grid.spacing": "uniform", "rheology.cap": "smooth", "rheology.eta_max": 1e8, "rheology.p_0": 0.0,
          "integrator.linear_solver": "banded", "time.end": 2.0, "output.times": [], "output.series_interval": 2.0}
LOOSE = {"integrator.rtol": 1e-4, "integrator.atol_velocity": 1e-6}
TIGHT = {"integrator.rtol": 1e-8, "integrator.atol_velocity": 1e-10}
LAYER = {"rheology.cap": "smooth", "rheology.p_0": 0.0, "time.end": 2.0, "output.times": [], "output.fields": "false",
         "output.series_interval": 2.0, **LOOSE}
HEAP = {"rheology.rate_speed": 0.0, "output.times": [], "time.end": 1.0, "output.fields": "false"}
FINE = [25, 50, 100, 200, 400, 800]
TABLES = [
    ("column, u_c = 1e-6 m/s, rtol 1e-4: eta_max [Pa s]", "chute_periodic", {**COLUMN, **LOOSE, "wall.u_c": 1e-6}, "rheology.eta_max",
     [1e2, 1e4, 1e6, 1e8, 1e10], FINE),
    ("column, eta_max = 1e8 Pa s, rtol 1e-4: u_c [m/s]", "chute_periodic", {**COLUMN, **LOOSE}, "wall.u_c", [1e-2, 1e-3, 1e-4, 1e-5, 1e-6], FINE),
    ("column, eta_max = 1e4 Pa s, rtol 1e-4: p_0 [Pa]", "chute_periodic", {**COLUMN, **LOOSE, "rheology.eta_max": 1e4}, "rheology.p_0",
     [100, 10, 1, 0.1], FINE),
    ("column, eta_max = 1e8 Pa s, rtol 1e-8: p_0 [Pa]", "chute_periodic", {**COLUMN, **TIGHT}, "rheology.p_0", [100, 10, 1], FINE[:-1]),
    ("periodic layer of 4 columns, rtol 1e-4: eta_max [Pa s]", "chute_periodic", LAYER, "rheology.eta_max", [1e2, 1e4, 1e6, 1e8, 1e10],
     [16, 32, 64, 128]),
    ("first second of the heap on 60 columns: eta_max [Pa s]", "heap_q46", {**HEAP, "grid.columns": 60}, "rheology.eta_max",
     [1e2, 1e4, 1e6, 1e8], [8, 16, 32]),
]


def cell(result):
    if result.summary is None:
        return f"exit {result.code}"
    counts = "/".join(str(result.count(name)) for name in ("newton_failures", "steps", "factorisations"))
    return counts if result.finished() else f"**failed** {counts}"


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--program", type=pathlib.Path, action="append", help="talus; may be given again")
    arguments.add_argument("--jobs", type=int, default=2, help="runs at once")
    arguments.add_argument("--limit", type=int, default=60, help="CPU time of one run [s]")
    choice = arguments.parse_args()
    for title, example, base, key, values, grids in TABLES:
        for program in choice.program or [PROGRAM]:
            print(f"\n{title} against layers, {program.name}: Newton failures/steps/factorisations\n\n| | "
                  + " | ".join(str(n) for n in grids) + " |\n|" + "---|" * (len(grids) + 1))
            cases = [(example, {**base, key: v, "grid.layers": n}) for v in values for n in grids]
            cells = [cell(r) for r in run_all(cases, choice.jobs, program=program.resolve(), limit=choice.limit)]
            for i, value in enumerate(values):
                print(f"| {value:g} | " + " | ".join(cells[i * len(grids):(i + 1) * len(grids)]) + " |", flush=True)


if __name__ == "__main__":
    main()
