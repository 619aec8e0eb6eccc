#!/usr/bin/env python3
"""The benchmark of BARN drives every world, scores it by BARN's formula, and continues after an interruption.
Run by ctest as test_barn.py BARN.PY FLOWNAV-NAV WORLD WORK_FOLDER."""

import json
import shutil
import struct
import subprocess
import sys
import unittest
from pathlib import Path

BARN, PROGRAM, WORLD, WORK = (Path(word) for word in sys.argv[1:5])
# The centre of each row of BARN's grid on the straight line from start to goal.
STRAIGHT = [(15, j) for j in range(-13, 53)]


def write_path(file, cells):
    header = f"{{'descr': '<i8', 'fortran_order': False, 'shape': ({len(cells)}, 2), }}\n".encode()
    numbers = [number for cell in cells for number in cell]
    file.write_bytes(b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + struct.pack(f"<{len(numbers)}q", *numbers))


def run(output, *options):
    command = [sys.executable, BARN, "--worlds", WORK / "worlds", "--output", output, "--program", PROGRAM,
               "--sensor", "lidar", *options]  # fmt: skip
    return subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)


class Barn(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        shutil.rmtree(WORK, ignore_errors=True)
        (WORK / "worlds").mkdir(parents=True)
        for number in (3, 12):  # nothing stands on the way from BARN's start to its goal
            shutil.copy(WORLD, WORK / f"worlds/world_{number}.world")
            write_path(WORK / f"worlds/path_{number}.npy", STRAIGHT)
        cls.done = run(WORK / "out", "--seeds", "1")

    def result(self, stem):
        return json.loads((WORK / f"out/runs/{stem}.json").read_text())

    def test_every_world_is_driven_and_drawn(self):
        self.assertEqual(self.done.returncode, 0, self.done.stderr)
        for stem in ("world_3_seed_1", "world_12_seed_1"):
            self.assertEqual(self.result(stem)["outcome"], "reached")
            self.assertGreater((WORK / f"out/pictures/{stem}.png").stat().st_size, 1000)

    def test_the_score_is_that_of_the_benchmark(self):
        result = self.result("world_3_seed_1")
        best_s = 10.0 / 2.0  # m, m/s
        expected = best_s / min(max(result["time_s"], 2 * best_s), 8 * best_s)
        self.assertAlmostEqual(result["score"], expected, delta=0.01)
        row = next(line for line in self.done.stdout.splitlines() if line.startswith("| flownav"))
        self.assertEqual([cell.strip() for cell in row.split("|")][2:5], ["1.000", "0.000", "0.000"])

    def test_what_is_there_is_not_driven_again(self):
        kept = WORK / "out/runs/world_3_seed_1.json"
        lost = WORK / "out/runs/world_12_seed_1.json"
        before = lost.read_text()
        kept.write_text(kept.read_text().replace('"reached"', '"blocked"'))
        lost.unlink()
        again = run(WORK / "out", "--seeds", "1")
        self.assertIn("| 0.500 | 0.000 | 0.500 |", again.stdout)
        self.assertEqual(lost.read_text(), before)
        kept.write_text(kept.read_text().replace('"blocked"', '"reached"'))

    def test_worlds_that_are_not_there_are_named(self):
        missing = run(WORK / "other", "--only", "5")
        self.assertNotEqual(missing.returncode, 0)
        self.assertIn("no world 5", missing.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
