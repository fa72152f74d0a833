#!/usr/bin/env python3
"""Plants each fault of faults.toml in a copy of the tree, builds what its tests need, and looks whether they fail.

    run.py --check                 every fault still has its place: exactly one, in the tree as it is (a second)
    run.py [FILTER]                plant those whose name, file or tests match the regular expression FILTER
    run.py --list [FILTER]

Faults are planted one at a time, never in the tree itself. Their tests must pass in the copy before anything is planted.
A fault is caught when CTest, asked for its tests, builds them and fails; it is missed when they pass.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent


def read_faults():
    with open(HERE / "faults.toml", "rb") as file:
        faults = tomllib.load(file)["fault"]
    for fault in faults:
        if set(fault) != {"name", "file", "before", "after", "target", "tests"}:
            sys.exit(f"faults.toml: {fault.get('name', fault)}: expected name, file, before, after, target, tests")
        # Multi-line strings of TOML end with a line break that is no part of the text.
        for key in ("before", "after"):
            fault[key] = fault[key].removesuffix("\n")
    return faults


def test_names(target):
    """Names of the tests in a target's source, as CTest knows them but for what parameters add to them; none where there is no such
    target."""
    sources = [path for path in ROOT.glob(f"tests/*/{target.removeprefix('test_')}.cpp")
               if path.parent.name != "benchmark"]
    pairs = re.findall(r"\bTEST(?:_P|_F)?\((\w+),\s*(\w+)\)", "".join(path.read_text() for path in sources))
    return [f"{suite}.{name}" for suite, name in pairs]


def check(faults):
    """What is wrong with the list as text: one line a fault."""
    wrong = []
    names = [fault["name"] for fault in faults]
    for fault in faults:
        def complain(what):
            wrong.append(f"{fault['name']}: {what}")
        if names.count(fault["name"]) > 1:
            complain("the name stands twice")
        path = ROOT / fault["file"]
        if not path.is_file():
            complain(f"no file {fault['file']}")
        elif (n := path.read_text().count(fault["before"])) != 1:
            complain(f"the text before occurs {n} times in {fault['file']}, expected once")
        if fault["before"] == fault["after"]:
            complain("nothing changes")
        if not any(re.search(fault["tests"], name) for name in test_names(fault["target"])):
            complain(f"no test of target {fault['target']} matches {fault['tests']}")
    return wrong


class Copy:
    """A copy of the tree with a build of its own, kept between calls so that only what changed is built again."""

    def __init__(self, folder, jobs):
        self.root = folder
        self.build = folder / "build" / "release"
        self.jobs = jobs
        self.log = folder / "build" / "planted.log"

    def refresh(self):
        listed = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                                check=True, capture_output=True, text=True).stdout.split("\0")
        files = {name for name in listed if name and (ROOT / name).is_file()}
        for name in files:
            target = self.root / name
            if not target.is_file() or target.read_bytes() != (ROOT / name).read_bytes():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, target)
        for top in (path for path in self.root.iterdir() if path.name != "build"):
            for path in [top, *top.rglob("*")]:
                if path.is_file() and str(path.relative_to(self.root)) not in files:
                    path.unlink()
        self.build.mkdir(parents=True, exist_ok=True)
        self.log.write_text("")
        self.call(["cmake", "-S", self.root, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release"])

    def call(self, command):
        """True where the command succeeds; its words go to the log."""
        with open(self.log, "a") as log:
            print("+", *command, file=log, flush=True)
            return subprocess.run([str(word) for word in command], stdout=log, stderr=log, check=False).returncode == 0

    def make(self, targets):
        return self.call(["cmake", "--build", self.build, "-j", str(self.jobs), "--target", *targets])

    def passes(self, tests):
        return self.call(["ctest", "--test-dir", self.build, "-R", tests, "--no-tests=error", "--timeout", "900",
                          "--output-on-failure"])

    def write(self, name, text):
        (self.root / name).write_text(text)


def plant(copy, fault):
    """One word: caught, missed, or what went wrong."""
    sound = (ROOT / fault["file"]).read_text()
    copy.write(fault["file"], sound.replace(fault["before"], fault["after"]))
    try:
        if not copy.make([fault["target"]]):
            return "does not build"
        return "missed" if copy.passes(fault["tests"]) else "caught"
    finally:
        copy.write(fault["file"], sound)


def run(faults, copy):
    copy.refresh()
    # Faults of one file one after another: what depends on it is then built once a fault.
    faults.sort(key=lambda fault: (fault["file"], fault["target"]))
    targets = sorted({fault["target"] for fault in faults})
    print(f"{len(faults)} faults; building {len(targets)} tests in {copy.root}", flush=True)
    if not copy.make(targets):
        sys.exit(f"the sound tree does not build, see {copy.log}")
    for tests in sorted({fault["tests"] for fault in faults}):
        if not copy.passes(tests):
            sys.exit(f"the sound tree does not pass {tests}, see {copy.log}")
    rows, begin = [], time.monotonic()
    for number, fault in enumerate(faults, 1):
        outcome = plant(copy, fault)
        rows.append((fault["file"], fault["name"], fault["tests"], outcome))
        print(f"[{number}/{len(faults)}, {time.monotonic() - begin:.0f} s] {outcome}: {fault['name']}"
              f" ({fault['file']}, {fault['tests']})", flush=True)
    table = "| file | fault | tests | |\n|---|---|---|---|\n"
    for row in sorted(rows):
        table += "| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |\n"
    (copy.root / "build" / "planted.md").write_text(table)
    caught = sum(row[3] == "caught" for row in rows)
    print(f"{caught} of {len(rows)} caught; table in {copy.root / 'build' / 'planted.md'}")
    return caught == len(rows)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("filter", nargs="?", default="", help="regular expression over name, file and tests")
    words.add_argument("--check", action="store_true", help="only look whether every fault has its place")
    words.add_argument("--list", action="store_true", help="only list them")
    words.add_argument("--copy", type=pathlib.Path, default=ROOT / "build" / "planted", help="folder of the copy")
    words.add_argument("--jobs", type=int, default=os.cpu_count())
    words = words.parse_args()
    faults = read_faults()
    if wrong := check(faults):
        sys.exit("\n".join(wrong))
    chosen = [fault for fault in faults
              if any(re.search(words.filter, fault[key]) for key in ("name", "file", "tests"))]
    if not chosen:
        sys.exit(f"no fault matches {words.filter}")
    if words.list or words.check:
        for fault in chosen if words.list else []:
            print(f"{fault['name']}: {fault['file']}, {fault['tests']}")
        return
    if not run(chosen, Copy(words.copy.resolve(), words.jobs)):
        sys.exit(1)


main()
