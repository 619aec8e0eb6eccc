#!/usr/bin/env python3
"""Drives flownav's simulated robot through worlds of the BARN benchmark (Perille et al. 2020) and prints its
score. Runs are kept one by one: an interrupted benchmark goes on where it was. share/doc/barn.md explains."""

import ast
import math
import re
import struct
import sys
import tarfile
from pathlib import Path

import drives

START = (-2.25, 3.0)
GOAL = (-2.25, 13.0)
BASELINE = "| published: DWA, 2D lidar, 50 official worlds | 0.850 | 0.056 | 0.094 | 39.5 | - | - |"


def read_path(file):
    """Reads the points (i, j) of a path_N.npy with integers of 8 bytes."""
    data = file.read_bytes()
    length = struct.unpack("<H", data[8:10])[0]
    header = ast.literal_eval(data[10 : 10 + length].decode())
    if header["descr"] != "<i8" or header["fortran_order"]:
        raise ValueError(f"{file}: not the path of a BARN world")
    numbers = struct.unpack(f"<{math.prod(header['shape'])}q", data[10 + length :])
    return list(zip(numbers[::2], numbers[1::2]))


def path_length(file):
    """Returns the length in metres from the start along the reference path to the goal."""
    path = [START] + [(0.15 * i - 4.575, 0.15 * j + 5.075) for i, j in read_path(file)] + [GOAL]
    return sum(math.dist(a, b) for a, b in zip(path, path[1:]))


def number(file):
    return int(re.search(r"\d+", file.stem)[0])


def find_worlds(folder, scratch):
    """Returns every world by its number, with its reference path. Unpacks a worlds.tar.xz into `scratch`."""
    archive = folder if folder.is_file() else folder / "worlds.tar.xz"
    if archive.is_file():
        folder = scratch / "worlds"
        if not folder.is_dir():
            with tarfile.open(archive) as tar:
                tar.extractall(folder)
    worlds = {number(file): file for file in folder.rglob("world_*.world")}
    paths = {number(file): file for file in folder.rglob("path_*.npy")}
    return {n: (file, paths[n]) for n, file in sorted(worlds.items()) if n in paths}


def pick(worlds, arguments):
    if arguments.only:
        wanted = [int(word) for word in arguments.only.split(",")]
        missing = [n for n in wanted if n not in worlds]
        if missing:
            sys.exit(f"barn.py: --only: no world {missing[0]}")
        return wanted
    # Selects worlds evenly; they are numbered in the order of their creation.
    names = list(worlds)
    count = min(arguments.count, len(names))
    return [names[i * len(names) // count] for i in range(count)]


def options(arguments, world, path, seed):
    return [
        "--world", world, "--start", f"{START[0]},{START[1]},90", "--goal", f"{GOAL[0]},{GOAL[1]}", "--seed", seed,
        "--success-radius-m", "1", "--timeout-s", "100", "--reference-path-m", f"{path_length(path):.4f}",
        "--config", arguments.config,
    ]  # fmt: skip


def main():
    here = Path(__file__).resolve().parent
    parser = drives.parser(__doc__)
    parser.add_argument("--worlds", type=Path, default=drives.ROOT.parent / "shared/data/barn", metavar="DIR",
                        help="folder of world_N.world and path_N.npy, or of their worlds.tar.xz")
    parser.add_argument("--config", type=Path, default=here / "jackal.ini", metavar="FILE.ini")
    parser.add_argument("--count", type=int, default=40, help="worlds, spread evenly over all there are")
    parser.add_argument("--only", metavar="N,N,...", help="these worlds instead")
    parser.add_argument("--seeds", type=int, default=3, help="runs of each world")
    arguments = parser.parse_args()
    worlds = find_worlds(arguments.worlds, arguments.output)
    if not worlds:
        sys.exit(f"barn.py: no worlds in {arguments.worlds}")
    jobs = {
        f"world_{n}_seed_{seed}": options(arguments, *worlds[n], seed)
        for n in pick(worlds, arguments)
        for seed in range(1, arguments.seeds + 1)
    }
    results = drives.run_all(arguments, jobs)
    drives.write_table(arguments, [
        "| | success | collision | timeout | mean time (s) | score | runs |", "|---|---|---|---|---|---|---|",
        drives.table_row(f"flownav: {arguments.navigator}, {arguments.sensor}", list(results.values()), score=True), BASELINE,
    ])  # fmt: skip


if __name__ == "__main__":
    main()
