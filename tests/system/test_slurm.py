#!/usr/bin/env python3
"""Replays a manifest on a Slurm cluster with the scripts of share/slurm. One rawlog is damaged, one replay never
ends, one result cannot be written, and one of the two nodes is lost during the run.
Run by tests/run.sh --slurm as test_slurm.py BUILD_FOLDER. Exit status 77: no Slurm, or not root."""

import os
import re
import signal
import sys
import time
import unittest
from pathlib import Path

from rawlog_set import COUNT, RawlogSet, name, run
from slurm_cluster import SlurmCluster, missing_programs
from waiting import wait_until

SKIPPED = 77
ROOT = Path(__file__).resolve().parents[2]
SUBMIT = ROOT / "share/slurm/submit.sh"
DAMAGED, UNWRITABLE, HANGING = 3, 5, 7
LOST = {0, 1}  # the node of less weight gets the first two tasks, one a processor
SECONDS_TO_BEGIN = 30
SECONDS_TO_END = 150
OPTIONS = ["--time-limit", "5"]  # of a replay, each takes less than a second


def say(start, what):
    print(f"{time.monotonic() - start:6.1f} s  {what}", flush=True)


class Slurm(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.began = time.monotonic()
        cls.rawlogs = RawlogSet(BUILD / "slurm", BUILD)
        cls.output = cls.rawlogs.folder / "out"
        cls.rawlogs.damage(DAMAGED)
        cls.rawlogs.write_manifest()
        for what in ("freeze-on-n2", f"hang-{name(HANGING)}", f"unwritable-{name(UNWRITABLE)}"):
            cls.rawlogs.trouble(what)
        say(cls.began, f"{COUNT} rawlogs are there")
        cls.cluster = SlurmCluster(cls.rawlogs.folder / "cluster")
        cls.addClassCleanup(cls.cluster.close)
        cls.cluster.start()
        say(cls.began, "two nodes wait for tasks")
        cls.lose_a_node_in_the_middle()
        cls.resume()
        cls.replay_without_cluster()
        say(cls.began, "resumed, and compared with a run without a cluster")

    @classmethod
    def lose_a_node_in_the_middle(cls):
        cls.first = cls.submit()
        frozen = cls.rawlogs.folder / "frozen"
        wait_until(lambda: frozen.exists() and len(frozen.read_text().split()) == len(LOST), SECONDS_TO_BEGIN,
                   "two replays are under way on n2")  # fmt: skip
        cls.cluster.lose_node("n2")
        say(cls.began, "node n2 is lost")
        cls.cluster.wait_for_jobs(SECONDS_TO_END)
        say(cls.began, "all tasks have ended")
        cls.first_outcome = {name(k): cls.rawlogs.outcome(cls.output, name(k)) for k in range(COUNT)}
        cls.first_calls = cls.rawlogs.calls()
        both = ["--manifest", cls.rawlogs.manifest, "--output", cls.output]
        cls.missing = cls.rawlogs.regress("merge", *both, "--missing")

    @classmethod
    def resume(cls):
        cls.rawlogs.no_trouble(f"unwritable-{name(UNWRITABLE)}")
        cls.second = cls.submit("--missing")
        cls.cluster.wait_for_jobs(SECONDS_TO_END)
        cls.second_calls = cls.rawlogs.calls()[len(cls.first_calls) :]

    @classmethod
    def replay_without_cluster(cls):
        cls.local = cls.rawlogs.folder / "local"
        cls.rawlogs.regress("run", "--manifest", cls.rawlogs.manifest, "--output", cls.local, *OPTIONS)

    @classmethod
    def submit(cls, *more):
        """Returns the numbers of the array job and of the merge job, and the submitted tasks."""
        environment = dict(cls.cluster.environment(), FLOWNAV_REGRESS=str(cls.rawlogs.regress_program), RETRIES="1")
        done = run([SUBMIT, cls.rawlogs.manifest, cls.output, *more, *OPTIONS], env=environment)
        match = re.search(r"Job (\d+) replays shards (\S+) of 12; then job (\d+) merges", done.stdout)
        if not match:
            raise AssertionError(f"submit.sh {more}: status {done.returncode}: {done.stdout}{done.stderr}")
        return match[1], match[3], match[2]

    def attempts(self, number):
        """Returns the nodes of the attempts at a rawlog before the resumption."""
        return [node for identifier, node, _ in self.first_calls if identifier == name(number)]

    def test_what_was_under_way_on_the_lost_node_is_done_on_the_other(self):
        for number in LOST:
            self.assertEqual(self.attempts(number), ["n2", "n1"])
            self.assertEqual(self.first_outcome[name(number)], ["done"])

    def test_a_damaged_rawlog_and_one_that_hangs_fail_once_and_stop_nothing_else(self):
        for number in (DAMAGED, HANGING):
            self.assertEqual(self.attempts(number), ["n1"])
            self.assertEqual(self.first_outcome[name(number)], ["failed"])
        good = set(range(COUNT)) - {DAMAGED, HANGING, UNWRITABLE}
        self.assertEqual({name(k) for k in good}, {i for i, kinds in self.first_outcome.items() if kinds == ["done"]})

    def test_what_cannot_be_written_is_tried_again_but_not_for_ever(self):
        self.assertEqual(self.attempts(UNWRITABLE), ["n1", "n1"])
        self.assertEqual(self.first_outcome[name(UNWRITABLE)], [])

    def test_a_task_that_loses_node_after_node_is_not_tried_for_ever(self):
        task = {"SLURM_RESTART_COUNT": "2", "RETRIES": "1", "FLOWNAV_REGRESS": "true"}
        done = run(["bash", ROOT / "share/slurm/replay.sbatch"], env=dict(os.environ, **task))
        self.assertEqual(done.returncode, 1)
        self.assertIn("at most 1 are allowed", done.stderr)

    def test_the_merge_job_runs_all_the_same_and_tells_that_something_is_missing(self):
        for job in (self.first, self.second):
            self.assertEqual(self.cluster.job(job[1])["ExitCode"], "3:0")
        self.assertEqual((self.missing.returncode, self.missing.stdout), (3, f"{UNWRITABLE}\n"))

    def test_only_what_is_missing_is_replayed_again(self):
        self.assertEqual((self.first[2], self.second[2]), ("0-11", str(UNWRITABLE)))
        self.assertEqual([call[0] for call in self.second_calls], [name(UNWRITABLE)])

    def test_the_figures_are_those_of_a_run_without_a_cluster(self):
        for file in ("merged.json", "merged.csv"):
            self.assertEqual((self.output / file).read_bytes(), (self.local / file).read_bytes())

    def test_when_nothing_is_missing_nothing_is_submitted(self):
        done = run([SUBMIT, self.rawlogs.manifest, self.output, "--missing"],
                   env=dict(self.cluster.environment(), FLOWNAV_REGRESS=str(self.rawlogs.regress_program)))  # fmt: skip
        self.assertEqual((done.returncode, done.stdout), (0, "Nothing to do.\n"), done.stderr)


def why_not():
    """Returns the reason why no cluster can be started here; empty when it can."""
    if os.geteuid() != 0:
        return "only root can start a Slurm cluster"
    if missing := missing_programs():
        return "no " + ", ".join(missing)
    return ""


def end_properly(*_):
    sys.exit(1)  # so that the cluster is closed


if __name__ == "__main__":
    BUILD = Path(sys.argv[1]).resolve()
    if reason := why_not():
        print("skipped:", reason)
        sys.exit(SKIPPED)
    signal.signal(signal.SIGTERM, end_properly)
    unittest.main(argv=sys.argv[:1], verbosity=2)
