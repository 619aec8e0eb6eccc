#!/usr/bin/env python3
"""Runs every command of a page of the documentation, as a reader would, and checks what the page promises.
Run by ctest as test_documented_commands.py PAGE.md BUILD_FOLDER.

In an empty home folder, with flownav installed from BUILD_FOLDER into ~/flownav, the fenced blocks of the page are
gone through from top to bottom:
    ```ini NAME     is written to the file NAME
    ```sh           is run line by line by bash; every command must succeed
    ```text         is shown only
Programs with windows run on a virtual display until their window is there. A comment at the end of a line of a
block, "# -> NAME ...", names the files that the command makes. All files stay in one temporary folder."""

import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SKIPPED = 77
# Programs with windows, and a part of the window title.
WINDOWS = {"camera-calib": "Camera calibration", "RawLogViewer": "RawLog", "flownav-view": "flownav-view"}
SECONDS_TO_SHOW_A_WINDOW = 120
SECONDS_TO_RUN = 300


def blocks(page):
    """Returns (kind, name, lines) of each fenced block."""
    for match in re.finditer(r"^```(\w+) ?(\S*)\n(.*?)^```$", page, re.MULTILINE | re.DOTALL):
        yield match[1], match[2], match[3].splitlines()


def commands(lines):
    """Returns (command, files it makes) of the lines of a block; a backslash continues a line."""
    text = "\n".join(lines).replace("\\\n", " ")
    for line in text.splitlines():
        command, _, comment = line.partition(" # ")
        made = re.match(r"-> (.*)", comment.strip())
        if command.strip() and not command.lstrip().startswith("#"):
            yield " ".join(command.split()), made[1].split() if made else []


def program_of(command):
    return Path(re.sub(r"^(?:\w+=\S+ )*", "", command).split()[0]).name


class Display:
    """A virtual display."""

    def __init__(self):
        reading, writing = os.pipe()
        self.server = subprocess.Popen(["Xvfb", "-displayfd", str(writing), "-screen", "0", "1280x1024x24"],
                                       pass_fds=[writing], stderr=subprocess.DEVNULL)
        os.close(writing)
        with os.fdopen(reading) as answer:
            self.name = ":" + answer.readline().strip()

    def close(self):
        self.server.terminate()
        self.server.wait()


class Reader:
    """Runs the commands of a page in an empty home folder."""

    def __init__(self, home, display):
        self.home = home
        self.folder = home / "work"
        self.folder.mkdir()
        self.environment = dict(os.environ, HOME=str(home), LIBGL_ALWAYS_SOFTWARE="1", DISPLAY=display.name)
        self.environment["PATH"] = f"{home}/flownav/bin:{os.environ['PATH']}"

    def follow(self, command):
        shows_a_window = program_of(command) in WINDOWS and "--screenshot" not in command
        (self.show if shows_a_window else self.run)(command)

    def run(self, command):
        """Runs a command and returns its output; raises when it fails."""
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=self.folder, text=True,
                              env=self.environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, timeout=SECONDS_TO_RUN, check=False)
        if done.returncode != 0:
            raise AssertionError(f"status {done.returncode}: {command}\n{done.stdout[-3000:]}")
        return done.stdout

    def show(self, command):
        """Runs a program until its window is visible, then ends it."""
        title = WINDOWS[program_of(command)]
        program = subprocess.Popen(["bash", "-c", "exec " + command], cwd=self.folder, env=self.environment,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   start_new_session=True)
        try:
            # xdotool fails when a window vanishes during the search, as splash windows do.
            look = f'xdotool search --sync --onlyvisible --name "{title}"'
            self.run(f"timeout {SECONDS_TO_SHOW_A_WINDOW} sh -c 'until {look}; do :; done'")
            if program.poll() is not None:
                raise AssertionError(f"ended early: {command}")
        finally:
            os.killpg(program.pid, signal.SIGKILL)
            program.communicate()


class Page(unittest.TestCase):
    def test_every_command_does_what_the_page_says(self):
        home = Path(tempfile.mkdtemp(prefix="flownav-documented-"))
        self.addCleanup(shutil.rmtree, home, ignore_errors=True)
        subprocess.run(["cmake", "--install", BUILD, "--prefix", home / "flownav"], check=True,
                       stdout=subprocess.DEVNULL)
        display = Display()
        self.addCleanup(display.close)
        reader = Reader(home, display)
        count = 0
        for kind, name, lines in blocks(PAGE.read_text()):
            if kind == "ini":
                (reader.folder / name).write_text("\n".join(lines) + "\n")
            for command, made in commands(lines) if kind == "sh" else []:
                start = time.monotonic()
                reader.follow(command)
                for file in made:
                    path = reader.folder / file
                    self.assertTrue(path.is_dir() or path.is_file() and path.stat().st_size > 0, f"{file} by {command}")
                print(f"{time.monotonic() - start:6.1f} s  {command}", flush=True)
                count += 1
        self.assertGreater(count, 5, "the page has commands")


if __name__ == "__main__":
    PAGE, BUILD = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    missing = [name for name in ("Xvfb", "xdotool", "RawLogViewer", "camera-calib") if not shutil.which(name)]
    if missing:
        print("skipped: no", ", ".join(missing))
        sys.exit(SKIPPED)
    unittest.main(argv=sys.argv[:1], verbosity=2)
