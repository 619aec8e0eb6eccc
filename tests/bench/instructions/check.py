#!/usr/bin/env python3
"""Counts the instructions that matching and a whole step take, with callgrind, and compares them with the committed
figures. Instructions do not depend on how fast or how busy a machine is; they do on the compiler, and a little on the
variant of the C library's functions that the processor is given, hence the tolerance.

Exit status: 0 within the tolerance (or written with --update), 1 otherwise, 77 nothing could be counted here.
"""
import argparse
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

TOLERANCE = 0.05
SKIPPED = 77


class Skipped(Exception):
    pass


def totals_of(folder):
    """Returns {part: instructions} of callgrind's dumps in a folder."""
    totals = {}
    for dump in sorted(Path(folder).glob("out*")):
        text = dump.read_text()
        part = re.search(r"^desc: Trigger: Client Request: (\w+)$", text, re.MULTILINE)
        total = re.search(r"^totals: (\d+)$", text, re.MULTILINE)
        if part and total:
            totals[part[1]] = int(total[1])
    return totals


def count(valgrind, driver, rawlog, kernel):
    """Returns {"match": instructions per field, "step": instructions per field}."""
    if not valgrind or not Path(valgrind).exists():
        raise Skipped("valgrind is not installed")
    with tempfile.TemporaryDirectory() as folder:
        command = [valgrind, "--tool=callgrind", "--instr-atstart=no", f"--callgrind-out-file={folder}/out",
                   driver, rawlog, kernel]
        run = subprocess.run(command, capture_output=True, text=True, check=False)
        if run.returncode == SKIPPED:
            raise Skipped("; ".join(line for line in run.stderr.splitlines() if not line.startswith("==")))
        if run.returncode != 0:
            sys.exit(f"{' '.join(command)} failed:\n{run.stderr}")
        fields = int(run.stdout)
        totals = totals_of(folder)
    if set(totals) != {"match", "step"} or not all(totals.values()):
        sys.exit(f"callgrind counted {totals}; expected match and step")
    return {part: round(total / fields) for part, total in totals.items()}


def problems(kernel, counted, committed, how_to_update):
    """Returns a sentence for every figure that differs from the committed one."""
    if kernel not in committed:
        return [f"kernel {kernel} has no committed figures; if it is as fast as it shall be: {how_to_update}"]
    found = []
    for part, figure in counted.items():
        change = figure / committed[kernel][part] - 1
        print(f"{kernel} {part}: {figure} instructions a field, committed {committed[kernel][part]} ({change:+.1%})")
        if abs(change) > TOLERANCE:
            found.append(f"{kernel} {part}: {change:+.1%} instructions, more than {TOLERANCE:.0%} from the committed "
                         f"figure; if that is meant: {how_to_update}")
    return found


def parsed():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--valgrind", default="valgrind")
    parser.add_argument("--driver", required=True, help="flownav-bench-instructions")
    parser.add_argument("--rawlog", required=True)
    parser.add_argument("--figures", type=Path, required=True, help="the committed figures")
    parser.add_argument("--kernel", action="append", required=True)
    parser.add_argument("--update", action="store_true", help="write the figures instead")
    parser.add_argument("--skip", help="why nothing is counted in this build")
    return parser.parse_args()


def main():
    arguments = parsed()
    committed = json.loads(arguments.figures.read_text()) if arguments.figures.exists() else {}
    update = "cmake --build --preset release --target update-instructions"
    found, done = [], 0
    for kernel in arguments.kernel:
        try:
            if arguments.skip:
                raise Skipped(arguments.skip)
            counted = count(arguments.valgrind, arguments.driver, arguments.rawlog, kernel)
        except Skipped as why:
            print(f"{kernel}: SKIPPED: {why}")
            continue
        done += 1
        if arguments.update:
            committed[kernel] = counted
        else:
            found += problems(kernel, counted, committed, update)
    if arguments.update:
        arguments.figures.write_text(json.dumps(committed, indent=2, sort_keys=True) + "\n")
        print(arguments.figures.read_text(), end="")
    print("\n".join(found))
    return 1 if found else 0 if done else SKIPPED


if __name__ == "__main__":
    sys.exit(main())
