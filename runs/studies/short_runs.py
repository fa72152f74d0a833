"""Many short runs of one program over a design of settings, each with a limit of CPU time, a few at once."""

import concurrent.futures
import json
import pathlib
import resource
import shutil
import subprocess
import tempfile
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / "build/release/talus"
EXAMPLES = ROOT / "runs/examples"


class Result(NamedTuple):
    """How a run ended: its exit code (negative: the signal), what it said, and its summary.json where it left one."""

    code: int
    said: str
    summary: dict
    folder: pathlib.Path

    def count(self, name):
        """Of its statistics; None where it did not come that far."""
        return (self.summary or {}).get("statistics", {}).get(name)

    def finished(self):
        return self.code == 0 and self.summary is not None and self.summary["status"] == "finished"


def run(out, example, settings, program=PROGRAM, limit=60):
    """`settings` by key, on top of an example scene; `limit` of CPU time [s], beyond which the run is killed (SIGXCPU)."""
    command = [program, "run", EXAMPLES / f"{example}.toml", "--out", out]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    done = subprocess.run(command, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 5)))
    summary = out / "summary.json"
    return Result(done.returncode, done.stderr, json.loads(summary.read_text()) if summary.exists() else None, out)


def run_all(cases, jobs, **more):
    """Results in the order of `cases`, a list of (example, settings). A run's folder is gone when the next result is asked for."""
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        begun = [pool.submit(run, pathlib.Path(folder) / str(i), *case, **more) for i, case in enumerate(cases)]
        for one in begun:
            yield one.result()
            shutil.rmtree(one.result().folder, ignore_errors=True)
