#!/usr/bin/env python3
"""The examples at work. Run by ctest as test_examples.py FOLDER_OF_PROGRAMS CORRIDOR.rawlog."""

import os
import pty
import subprocess
import sys
import threading
import tty
import unittest
from pathlib import Path

PROGRAMS = Path(sys.argv[1])
RAWLOG = sys.argv[2]


def run(name, *arguments):
    return subprocess.run([PROGRAMS / name, *arguments], capture_output=True, text=True, timeout=120)


def count_ticks(line, said):
    """The motor controller: hears commands, and counts 1000 ticks more after each one that drives."""
    ticks = 0
    for command in os.fdopen(os.dup(line), "r"):
        said.append(command.strip())
        if command.startswith("m 0 "):
            return
        ticks += 1000
        os.write(line, f"e {ticks} {ticks}\n".encode())


class Examples(unittest.TestCase):
    def test_sense_prints_obstacle_points_ahead(self):
        result = run("sense", RAWLOG)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        points = [[float(word) for word in line.split()] for line in result.stdout.splitlines()]
        self.assertGreater(len(points), 50)
        self.assertTrue(all(len(point) == 4 for point in points))
        ahead = [point for point in points if 0.0 < point[1] < 10.0]
        self.assertGreater(len(ahead), 0.9 * len(points))

    def test_own_matcher_measures_most_fields(self):
        result = run("own_matcher", RAWLOG)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        measured, fields = (int(word) for word in result.stdout.split() if word.isdigit())
        self.assertGreater(fields, 20)
        self.assertGreater(measured, 0.8 * fields)

    def test_own_base_drives_its_way(self):
        line, device = pty.openpty()
        tty.setraw(device)
        said = []
        controller = threading.Thread(target=count_ticks, args=(line, said))
        controller.start()
        result = run("own_base", os.ttyname(device))
        controller.join(20)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertRegex(result.stdout, r"^x 0\.[23]\d m, y 0\.00 m$")
        self.assertEqual(said[0], "m 2000 2000")
        self.assertEqual(said[-1], "m 0 0")

    def test_bad_arguments_are_one_sentence_and_status_1(self):
        for arguments in (["sense"], ["sense", "none.rawlog"], ["own_matcher"], ["own_base", "/dev/no_such_line"]):
            result = run(*arguments)
            self.assertEqual((result.returncode, result.stderr.count("\n"), result.stdout), (1, 1, ""), arguments)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
