"""Twelve short rawlogs with their manifest, and a flownav-replay with injected faults, for tests of programs that run
flownav-regress on many rawlogs."""

import os
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

COUNT = 12
SECONDS_TO_RUN = 120

# Called as flownav-replay RAWLOG --output DIR ...; a file in trouble/ selects the fault of a rawlog. Every
# attempt adds a line to `calls`: identifier, node, process.
REPLAY = """#!/bin/bash
here=$(dirname "$0")
case $1 in --version) exec "$here/real-replay" --version ;; esac
id=$(basename "$1" .rawlog)
echo "$id ${SLURMD_NODENAME:-here} $PPID" >> "$here/../calls"
trouble() { [ -e "$here/../trouble/$1" ]; }
if trouble "freeze-on-${SLURMD_NODENAME:-here}"; then  # in the middle of a replay, with no time limit left to end it
    "$here/real-replay" "$@"
    kill -STOP "$PPID"
    echo "$id" >> "$here/../frozen"
    exec tail -f /dev/null
fi
if trouble "hang-$id"; then exec tail -f /dev/null; fi
if trouble "unwritable-$id"; then echo "no space left" >&2; exit 3; fi
exec "$here/real-replay" "$@"
"""


def name(number):
    return f"drive-{number:02}"


def run(command, **more):
    return subprocess.run([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, timeout=SECONDS_TO_RUN, check=False, **more)  # fmt: skip


class RawlogSet:
    """Creates in a new folder: recordings/, rawlogs.txt, and bin/ with flownav-regress and the flownav-replay with
    faults."""

    def __init__(self, folder, build):
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        for part in ("recordings", "bin", "trouble"):
            (folder / part).mkdir(parents=True)
        shutil.copy(build / "apps/regress/flownav-regress", folder / "bin")
        shutil.copy(build / "apps/replay/flownav-replay", folder / "bin/real-replay")
        replay = folder / "bin/flownav-replay"
        replay.write_text(REPLAY)
        replay.chmod(0o755)
        self.regress_program = folder / "bin/flownav-regress"
        self.manifest = folder / "rawlogs.txt"
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(lambda number: self.record(number, build), range(COUNT)))

    def record(self, number, build):
        stem = self.folder / "recordings" / name(number)
        run([build / "tests/support/flownav-make-scene", "s-curve", "--images", 16, "--width", 320, "--height", 240,
             "--seed", number + 1, "--output", stem]).check_returncode()  # fmt: skip

    def damage(self, number):
        rawlog = self.folder / "recordings" / (name(number) + ".rawlog")
        os.truncate(rawlog, rawlog.stat().st_size // 2)

    def write_manifest(self):
        self.regress("manifest", self.folder / "recordings", "--output", self.manifest).check_returncode()

    def trouble(self, what):
        (self.folder / "trouble" / what).touch()

    def no_trouble(self, what):
        (self.folder / "trouble" / what).unlink()

    def regress(self, *words):
        return run([self.regress_program, *words])

    def calls(self):
        """Returns (identifier, node, process of flownav-regress) of every attempt."""
        file = self.folder / "calls"
        return [tuple(line.split()) for line in file.read_text().splitlines()] if file.exists() else []

    def outcome(self, output, identifier):
        """Returns the folders ("done", "failed") that hold the result of a rawlog."""
        return [kind for kind in ("done", "failed") if (Path(output) / kind / identifier).is_dir()]
