#!/usr/bin/env python3
"""flownav-nav with a real base over loopback and a paced recording as its camera: what it keeps, and how it ends.

Run by ctest as test_real_drive.py NAV SIM BASE WORK_DIR. The base is a script of this test, which remembers every line,
or the reference base, which moves.
"""

import json
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import threading
import unittest

from waiting import wait_until

KEPT = ["result.json", "run.rawlog", "drive.csv", "drive.png", "report.html", "summary.json", "egomotion.csv", "map.pgm"]


class StandingBase:
    """A base that does not move: answers hello, sends its pose, and keeps all received lines."""

    def __init__(self):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.port = self.listener.getsockname()[1]
        self.lines = []
        self.thread = threading.Thread(target=self.serve, daemon=True)
        self.thread.start()

    def serve(self):
        with self.listener:
            connection, _ = self.listener.accept()
        connection.settimeout(0.02)
        text, ticks = b"", 0
        while True:
            try:
                received = connection.recv(4096)
                if not received:
                    break
                text += received
            except TimeoutError:
                pass
            except ConnectionError:
                break
            *whole, text = text.split(b"\n")
            self.lines += [line.decode() for line in whole]
            try:
                if b"hello flownav-base 1" in whole:
                    connection.sendall(b"hello flownav-base 1 300\n")
                connection.sendall(f"odometry {ticks * 0.02:.2f} 0 0 0 0 0\n".encode())
            except ConnectionError:
                break
            ticks += 1
        connection.close()

    def all_lines(self):
        """Returns all received lines after flownav has closed the connection."""
        self.thread.join(timeout=60)
        return self.lines


class RealDrive(unittest.TestCase):
    NAV, SIM, BASE, WORK = "", "", "", pathlib.Path()

    @classmethod
    def setUpClass(cls):
        shutil.rmtree(cls.WORK, ignore_errors=True)
        cls.WORK.mkdir(parents=True)
        cls.recording = cls.WORK / "camera.rawlog"
        subprocess.run([cls.SIM, "--generate", "corridor", "--seed", "1", "--objects", "patterned", "--script",
                        "wait 1; forward 1.2; wait 8", "--width", "160", "--height", "120", "--output", cls.recording, "--quiet"], check=True)

    def camera(self, more=""):
        ini = self.WORK / f"{self.id().rsplit('.', 1)[-1]}.ini"
        ini.write_text("[FLOW]\ndriver = CFlowObstacleSensor\ngrabber_type = rawlog\n"
                       f"rawlog_file = {self.recording}\n{more}\n")
        return ini

    def start(self, port, *more, camera=None):
        self.output = self.WORK / self.id().rsplit(".", 1)[-1]
        command = [self.NAV, "--robot", f"tcp:127.0.0.1:{port}", "--camera", str(camera or self.camera()),
                   "--goal", "3,0", "--output", str(self.output), *more]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def end(self, program):
        out, error = program.communicate(timeout=120)
        return program.returncode, out, error

    def result(self):
        for name in KEPT:
            self.assertGreater((self.output / name).stat().st_size, 100, name)
        return json.loads((self.output / "result.json").read_text())

    def drive_until(self, stop):
        base = StandingBase()
        program = self.start(base.port)
        wait_until(lambda: sum(line.startswith("drive") for line in base.lines) > 50, 60, "commands")
        program.send_signal(stop)
        status, out, error = self.end(program)
        self.assertEqual(status, 7, error)
        self.assertIn("stopped (told to stop)", out)
        *_, before, last = base.all_lines()
        self.assertRegex(before, r"^drive 0 0 \d+$")
        self.assertEqual(last, "bye")
        result = self.result()
        self.assertEqual(result["outcome"], "stopped")
        self.assertGreater(result["time_s"], 0.9)
        self.assertEqual(result["fields_left_out"], 0)
        return result

    def test_sigint_stops_the_base_says_bye_and_keeps_everything(self):
        result = self.drive_until(signal.SIGINT)
        for stop in result["stops"]:
            self.assertLess(stop["time_s"], result["time_s"] + 0.1)  # since the start of the drive

    def test_sigterm_does_the_same(self):
        self.drive_until(signal.SIGTERM)

    def test_a_camera_that_fails_ends_the_drive_and_keeps_what_was_seen(self):
        base = StandingBase()
        whole = self.recording.read_bytes()
        cut = self.WORK / "cut.rawlog"
        cut.write_bytes(whole[: len(whole) // 3])
        camera = self.camera()
        camera.write_text(camera.read_text().replace(str(self.recording), str(cut)))
        status, out, error = self.end(self.start(base.port, camera=camera))
        self.assertEqual(status, 2)
        self.assertIn("cut.rawlog", error)
        self.assertEqual(base.all_lines()[-1], "bye")
        self.assertRegex(base.all_lines()[-2], r"^drive 0 0 \d+$")
        self.assertEqual(self.result()["outcome"], "lost")

    def test_options_hold_as_in_a_simulation(self):
        base = StandingBase()
        record, picture = self.WORK / "own.rawlog", self.WORK / "own.png"
        program = self.start(base.port, "--timeout-s", "2", "--record", str(record), "--picture", str(picture),
                             "--set", "obstacles.tau_px=3.5", "--set", "flow.blocks=200")
        status, _, error = self.end(program)
        self.assertEqual(status, 6, error)
        self.assertGreater(record.stat().st_size, 1000)
        self.assertGreater(picture.stat().st_size, 1000)
        summary = json.loads((self.output / "summary.json").read_text())
        self.assertEqual(float(summary["config"]["obstacles"]["tau_px"]), 3.5)
        self.assertEqual(int(summary["config"]["flow"]["blocks"]), 200)
        self.assertGreater(summary["read"]["fields"], 20)
        self.assertGreater(summary["read"]["odometry"], 50)

    def test_options_of_the_simulation_are_refused(self):
        for option in (["--generate", "hall"], ["--realtime"], ["--noise", "3"]):
            status, _, error = self.end(self.start(1, *option))
            self.assertEqual(status, 1)
            self.assertIn("only with --robot sim", error)

    def test_the_reference_base_moves(self):
        base = subprocess.Popen([self.BASE], stdout=subprocess.PIPE, text=True)
        try:
            port = base.stdout.readline().split()[-1]
            status, out, error = self.end(self.start(port, "--timeout-s", "6"))
            self.assertIn(status, (0, 6), error)
            self.assertGreater(self.result()["path_m"], 0.05, out)
        finally:
            base.terminate()
            base.wait()
            base.stdout.close()


if __name__ == "__main__":
    RealDrive.NAV, RealDrive.SIM, RealDrive.BASE, work = sys.argv[1:5]
    RealDrive.WORK = pathlib.Path(work)
    unittest.main(argv=sys.argv[:1] + sys.argv[5:])
