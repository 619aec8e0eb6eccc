#!/usr/bin/env python3
"""Many short rawlogs through flownav-regress: how fast, and whether a run that is killed again and again gives what an
undisturbed one gives. Renders the rawlogs that are not there yet, replays them into OUTPUT/undisturbed, then into
OUTPUT/killed, where flownav-regress gets SIGKILL as soon as a number of rawlogs drawn at random is done, and goes on
after that. Exit status: 0 when nothing was lost, nothing redone and every file has the same bytes, else 1."""

import argparse
import csv
import os
import random
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
KINDS = "free straight s-curve turns corridor stop-and-go mover loop".split()
FLOORS = "carpet tiles lino plain stoneware marbled".split()
SIZES = [(160, 120), (240, 180), (320, 240)]
IMAGES = 20
SECONDS_TO_RUN = 1800
DIFFERS_BETWEEN_RUNS = "timing.json"


class Failure(Exception):
    """A violated guarantee of flownav-regress."""


def scene(seed):
    """Returns the arguments of flownav-make-scene; kind, floor and size follow from the seed and take all
    combinations."""
    width, height = SIZES[seed // len(KINDS) % len(SIZES)]
    return [KINDS[seed % len(KINDS)], "--floor", FLOORS[seed % len(FLOORS)], "--width", width, "--height", height,
            "--images", IMAGES, "--seed", seed]  # fmt: skip


def render(program, folder, seed):
    rawlog = folder / f"{seed:03}-{KINDS[seed % len(KINDS)]}.rawlog"
    if rawlog.exists():
        return
    part = folder / f"part-{seed:03}"
    one_thread = {**os.environ, "OMP_NUM_THREADS": "1"}
    command = [str(word) for word in [program, *scene(seed), "--gz", 1, "--output", part]]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=one_thread)
    part.with_suffix(".rawlog").rename(rawlog)
    for table in folder.glob(f"{part.name}.*"):
        table.unlink()


def render_all(program, folder, count):
    folder.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda seed: render(program, folder, seed), range(1, count + 1)))


class Regress:
    """Runs flownav-regress on one manifest."""

    def __init__(self, build, output):
        """Copies the programs, so that a concurrent build does not change them."""
        for name in ("regress", "replay"):
            shutil.copy(build / f"apps/{name}/flownav-{name}", output)
        self.program = output / "flownav-regress"
        self.manifest = output / "manifest"

    def write_manifest(self, folder):
        subprocess.run([self.program, "manifest", folder, "--output", self.manifest, "--quiet"], check=True)

    def start(self, output):
        return subprocess.Popen([self.program, "run", "--manifest", self.manifest, "--output", output, "--quiet"])

    def run(self, output):
        """Runs to the end and returns the seconds."""
        begin = time.monotonic()
        status = self.start(output).wait(SECONDS_TO_RUN)
        if status != 0:
            raise Failure(f"flownav-regress run ended with status {status}")
        return time.monotonic() - begin

    def run_until(self, output, wanted):
        """Kills the run when `wanted` rawlogs are done and returns the seconds."""
        begin = time.monotonic()
        process = self.start(output)
        try:
            while len(done(output)) < wanted:
                if process.poll() is not None:
                    raise Failure(f"flownav-regress run ended before {wanted} rawlogs were done")
                if time.monotonic() - begin > SECONDS_TO_RUN:
                    raise Failure(f"{wanted} rawlogs were not done within {SECONDS_TO_RUN} s")
                time.sleep(0.002)
        finally:
            process.kill()
            process.wait()
        return time.monotonic() - begin


def done(output):
    folder = output / "done"
    return sorted(entry.name for entry in folder.iterdir()) if folder.exists() else []


def marks(output):
    """Returns inode and time of the result folder and of every file in it, which detect a repeated result."""
    found = {}
    for identifier in done(output):
        folder = output / "done" / identifier
        found[identifier] = [
            (path.name, path.stat().st_ino, path.stat().st_mtime_ns) for path in [folder, *sorted(folder.iterdir())]
        ]
        if not (folder / "result.json").exists():
            raise Failure(f"{identifier} is among what is done without a result")
    return found


def refuse_redone(before, after):
    redone = [identifier for identifier, mark in before.items() if after.get(identifier) != mark]
    if redone:
        raise Failure("redone, or lost: " + ", ".join(redone))


def contents(output):
    """Returns the bytes by path of all files that are the same in every run."""
    files = (path for path in output.rglob("*") if path.is_file() and path.name != DIFFERS_BETWEEN_RUNS)
    return {path.relative_to(output): path.read_bytes() for path in files}


def refuse_differences(one, other, count):
    if len(done(one)) != count or len(done(other)) != count:
        raise Failure(f"of {count} rawlogs {len(done(one))} and {len(done(other))} are done")
    first, second = contents(one), contents(other)
    different = [str(path) for path in sorted({*first, *second}) if first.get(path) != second.get(path)]
    if different:
        raise Failure(f"{len(different)} files differ, such as {', '.join(different[:5])}")
    return len(first)


def driven_s(output):
    with open(output / "merged.csv", newline="", encoding="utf-8") as file:
        return sum(float(row["drive.duration_s"]) for row in csv.DictReader(file))


def row(name, replayed, seconds, recorded_s):
    rates = f"{replayed / seconds:.1f} | {recorded_s / seconds:.2f}"
    print(f"| {name} | {replayed} | {seconds:.1f} | {rates} |", flush=True)


def run_killed(regress, output, moments, recorded_s):
    """Replays all rawlogs, killed at each moment; `recorded_s` is the recorded time of a rawlog."""
    before = {}
    for number, moment in enumerate([*moments, None], 1):
        seconds = regress.run(output) if moment is None else regress.run_until(output, moment)
        after = marks(output)
        refuse_redone(before, after)
        replayed = len(after) - len(before)
        name = f"killed after {moment}" if moment else "the rest"
        row(f"{number}. {name}", replayed, seconds, replayed * recorded_s)
        before = after


def arguments_of():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--build", type=Path, default=ROOT / "build/release", metavar="DIR")
    parser.add_argument("--output", type=Path, default=ROOT / "out/regress-many", metavar="DIR")
    parser.add_argument("--rawlogs", type=int, default=200, metavar="N")
    parser.add_argument("--kills", type=int, default=3, metavar="N")
    parser.add_argument("--seed", type=int, default=1, help="of the moments of the kills")
    arguments = parser.parse_args()
    if not 0 <= arguments.kills < arguments.rawlogs:
        parser.error("fewer kills than rawlogs, please")
    return arguments


def main():
    arguments = arguments_of()
    count, output = arguments.rawlogs, arguments.output
    recordings = output / f"recordings-{count}"
    render_all(arguments.build / "tests/support/flownav-make-scene", recordings, count)
    regress = Regress(arguments.build, output)
    regress.write_manifest(recordings)
    undisturbed, killed = output / "undisturbed", output / "killed"
    for folder in (undisturbed, killed):
        shutil.rmtree(folder, ignore_errors=True)

    print("| run | rawlogs | s | rawlogs per s | seconds of recording per s |\n|---|---|---|---|---|")
    seconds = regress.run(undisturbed)
    recorded_s = driven_s(undisturbed)
    row("undisturbed", count, seconds, recorded_s)
    moments = sorted(random.Random(arguments.seed).sample(range(1, count), arguments.kills))
    run_killed(regress, killed, moments, recorded_s / count)
    files = refuse_differences(undisturbed, killed, count)
    print(f"\nNothing redone, nothing lost, {files} files with the same bytes.")


if __name__ == "__main__":
    try:
        main()
    except Failure as failure:
        sys.exit(f"many.py: {failure}")
