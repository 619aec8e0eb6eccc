#!/usr/bin/env python3
"""GNU parallel replays a manifest with the commands of share/doc/clusters.md, is interrupted and continues.
Run by ctest as test_parallel.py PAGE.md BUILD_FOLDER WORK_FOLDER."""

import os
import re
import signal
import subprocess
import sys
import unittest
from pathlib import Path

from rawlog_set import COUNT, RawlogSet, name
from waiting import wait_until

PAGE, BUILD, WORK = (Path(word).resolve() for word in sys.argv[1:4])
DAMAGED = 3
UNDER_WAY = (6, 7)  # when it is interrupted
SECONDS_TO_RUN = 120


def commands():
    """Returns the block of shell commands in the page's section on GNU parallel."""
    section = re.search(r"^## GNU parallel\n(.*?)^## ", PAGE.read_text(), re.MULTILINE | re.DOTALL)[1]
    return re.search(r"^```sh\n(.*?)^```$", section, re.MULTILINE | re.DOTALL)[1]


def start(rawlogs):
    """Runs the commands with two jobs at a time in their own process group, as a terminal does."""
    environment = dict(os.environ, PARALLEL="--jobs 2", PATH=f"{rawlogs.folder}/bin:{os.environ['PATH']}",
                       HOME=str(rawlogs.folder))  # fmt: skip
    return subprocess.Popen(["bash", "-euo", "pipefail", "-c", commands()], cwd=rawlogs.folder, env=environment,
                            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            start_new_session=True)  # fmt: skip


class Parallel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        signal.signal(signal.SIGINT, signal.default_int_handler)  # in the background shells have it ignored
        cls.rawlogs = RawlogSet(WORK, BUILD)
        cls.rawlogs.damage(DAMAGED)
        cls.output = WORK / "out"
        cls.interrupt()
        cls.resume()
        cls.rawlogs.regress("run", "--manifest", cls.rawlogs.manifest, "--output", WORK / "local")

    @classmethod
    def interrupt(cls):
        for number in UNDER_WAY:
            cls.rawlogs.trouble(f"hang-{name(number)}")
        running = start(cls.rawlogs)
        cls.addClassCleanup(cls.kill, running)
        under_way = {name(number) for number in UNDER_WAY}
        wait_until(lambda: under_way <= {call[0] for call in cls.rawlogs.calls()}, SECONDS_TO_RUN, "two replays hang")
        os.killpg(running.pid, signal.SIGINT)
        cls.interrupted = running.communicate(timeout=SECONDS_TO_RUN)[0]
        cls.first_outcome = [cls.rawlogs.outcome(cls.output, name(number)) for number in range(COUNT)]
        cls.first_calls = cls.rawlogs.calls()

    @classmethod
    def resume(cls):
        for number in UNDER_WAY:
            cls.rawlogs.no_trouble(f"hang-{name(number)}")
        running = start(cls.rawlogs)
        cls.addClassCleanup(cls.kill, running)
        cls.said = running.communicate(timeout=SECONDS_TO_RUN)[0]
        cls.status = running.returncode
        cls.second_calls = cls.rawlogs.calls()[len(cls.first_calls) :]

    @staticmethod
    def kill(running):
        if running.poll() is None:
            os.killpg(running.pid, signal.SIGKILL)
            running.communicate()

    def test_what_was_under_way_leaves_nothing_when_it_is_interrupted(self):
        before = UNDER_WAY[0]
        expected = [["failed"] if number == DAMAGED else ["done"] for number in range(before)]
        self.assertEqual(self.first_outcome, expected + [[]] * (COUNT - before), self.interrupted)

    def test_the_same_commands_again_replay_only_what_is_not_done(self):
        replayed = sorted(call[0] for call in self.second_calls)
        self.assertEqual(replayed, [name(number) for number in (DAMAGED, *range(UNDER_WAY[0], COUNT))])

    def test_a_damaged_rawlog_stops_nothing_else_and_the_last_status_tells(self):
        self.assertEqual(self.status, 3, self.said)
        self.assertIn("12 rawlogs: 11 done, 1 failed, 0 missing", self.said)

    def test_the_figures_are_those_of_a_run_without_parallel(self):
        for file in ("merged.json", "merged.csv"):
            self.assertEqual((self.output / file).read_bytes(), (WORK / "local" / file).read_bytes())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
