#!/usr/bin/env python3
"""Makes the page of figures from the JSON of flownav-bench: tests/bench/run.sh calls it."""

import argparse
import json
import platform
import re
import subprocess
import sys
import tempfile
from pathlib import Path

INSTRUCTIONS = {"avx512bw": "vdbpsadbw", "avx2": "vmpsadbw", "sse41": "mpsadbw", "portable": "psadbw"}
VECTORS = 350
PAL_FIELDS_A_SECOND = 50
ERRORS = {"mean_px": 3, "median_px": 3, "over_1_percent": 1, "over_3_percent": 1, "kept_percent": 0, "kept_mean_px": 3}


class Runs:
    """The benchmarks by name."""

    def __init__(self, path):
        data = json.loads(Path(path).read_text())
        self.context = data["context"]
        self.by_name = {re.sub("/(real|manual)_time$", "", run["name"]): run for run in data["benchmarks"]
                        if not run.get("error_occurred")}

    def matching(self, pattern):
        """Returns (groups, run) of every benchmark whose name matches."""
        found = ((re.fullmatch(pattern, name), run) for name, run in self.by_name.items())
        return [(match.groups(), run) for match, run in found if match]

    def ms(self, name):
        return milliseconds(self.by_name[name])


def milliseconds(run):
    return run["real_time"] * {"ns": 1e-6, "us": 1e-3, "ms": 1.0, "s": 1e3}[run["time_unit"]]


def per(run, counter):
    """Returns the milliseconds per counted item of a run."""
    return milliseconds(run) / run[counter]


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def cpu_name():
    text = Path("/proc/cpuinfo").read_text()
    fields = {key: re.search(rf"^{key}\s*: (.*)$", text, re.MULTILINE) for key in ("model name", "cpu family", "model")}
    name, family, model = (found[1] if found else "?" for found in fields.values())
    return f"{name} (family {family}, model {model})"


def machine(runs):
    context = runs.context
    return (f"Measured on: {cpu_name()}, {context['num_cpus']} cores; Linux {platform.release()}; "
            f"GCC {context['compiler']}; OpenCV {context['opencv']}. One thread where nothing else is said. "
            f"Load of the machine when it began: {context['load_avg'][0]:.1f}.\n")


def kernels(runs):
    rows = []
    for (name,), run in runs.matching(r"kernel/(\w+)"):
        one = per(run, "vectors")
        limit = runs.by_name.get("limit/" + name)
        share = ["-", "-"]
        if limit:
            share = [f"{1e6 * per(limit, 'vectors'):.0f}", f"{100 * per(limit, 'vectors') / one:.0f} %"]
        rows.append([name, f"{1e6 * one:.0f}", f"{VECTORS * one:.3f}", INSTRUCTIONS.get(name, "-"), *share])
    return """## Matching kernels

All 256 offsets of a 16x16 block, with minimum, second distinct minimum, sum and neighbours. The limit is what independent
instructions of the kind reach in the same run, with nothing around them: no loads, no sums, no search for the minimum.

""" + table(["kernel", "ns a vector", f"ms for {VECTORS}", "instruction", "limit (ns a vector)", "share of the limit"],
            rows)


def comparison(runs):
    text = """## Other methods, on the same images

Flow is known exactly. Error: end-point error over all vectors that a method gives; "kept": those that pass its own sieve.
OpenCV uses one thread. "mestimate" is FFmpeg's, on a grid of blocks of its own.

"""
    for case in dict.fromkeys(groups[0] for groups, _ in runs.matching(r"flow/(\w+)/(.+)")):
        found = runs.matching(rf"flow/({case})/(.+)")
        fastest = min(per(run, "vectors") for (_, name), run in found if name.startswith("flownav"))
        rows = []
        for (_, name), run in found:
            rows.append([name, f"{VECTORS * per(run, 'vectors'):.3f}", f"{per(run, 'vectors') / fastest:.1f}"] +
                        [f"{run[key]:.{digits}f}" for key, digits in ERRORS.items()])
        text += f"### {case}\n\n" + table(
            ["method", f"ms for {VECTORS}", "times the fastest", "mean error (px)", "median (px)", "over 1 px (%)",
             "over 3 px (%)", "kept (%)", "mean error of the kept (px)"], rows) + "\n"
    return text


def steps(runs):
    rows = [[name, f"{per(run, 'fields'):.3f}", f"{run['match_us'] / 1e3:.3f}",
             f"{per(runs.by_name['step/' + name + '/map'], 'fields'):.3f}"]
            for (name,), run in runs.matching(r"step/(\w+)")]
    stages = [[name, f"{per(run, 'fields'):.3f}"] for (name,), run in runs.matching(r"stage/(.+)")]
    return """## One field through the chain

From two images to obstacle points, in the steady state: each field has just been written to memory, as by a camera or a
decoder, and the first ten of a drive, in which the motion is searched for, are not counted. "Matching" holds the
compensation of the brightness. With map: the local map that a navigator reads as well, whenever a cycle ends.

""" + table(["kernel", "step (ms)", "of it matching (ms)", "with map (ms)"], rows) + "\n" + table(["stage alone", "ms"],
                                                                                                 stages)


def replays(runs):
    rows = []
    for (name,), run in runs.matching(r"decode/(\w+)"):
        row = [name, f"{run['size_MB']:.1f}", f"{1 / per(run, 'fields') * 1e3:.0f}"]
        for threads in (1, 2):
            replay = runs.by_name.get(f"replay/{name}/threads-{threads}")
            row.append(f"{1e3 / per(replay, 'fields'):.0f}" if replay else "-")
        rows.append(row)
    return """## Replay

flownav-replay with all its outputs, by how the images are stored. PAL has 50 fields a second. With two threads, decoding
runs ahead in the second one, which also draws the pictures of the report.

""" + table(["storage", "MB", "decoded alone (fields/s)", "replayed (fields/s)", "with two threads"], rows)


def growth(runs):
    text = "## Growth\n\n"
    sentences = {"vectors": "Matching, by the number of vectors.", "image": "Matching, by the size of the image.",
                 "step": "A whole step, by the size of the image (per field; every size is rendered anew)."}
    for what, sentence in sentences.items():
        sizes = runs.matching(rf"growth/{what}/(\w+)/threads-1")
        rows = []
        for (size,), run in sizes:
            two = runs.by_name[f"growth/{what}/{size}/threads-2"]
            count = run.get("fields", 1)
            rows.append([size, f"{milliseconds(run) / count:.3f}", f"{milliseconds(two) / count:.3f}"])
        text += sentence + "\n\n" + table([what, "1 thread (ms)", "2 threads (ms)"], rows) + "\n"
    windows = [[f"+-{size}", f"{int(run['offsets'])}", f"{milliseconds(run):.3f}"]
               for (size,), run in runs.matching(r"growth/window/(\w+)")]
    text += "Wider windows, put together from several of 16x16 offsets.\n\n"
    return text + table(["window (px)", "offsets", "ms"], windows)


def peak_mb(replay, rawlog):
    with tempfile.TemporaryDirectory() as folder:
        command = [replay, rawlog, "--output", folder, "--quiet"] if rawlog else [replay, "--version"]
        code = ("import resource, subprocess, sys; subprocess.run(sys.argv[1:], check=True); "
                "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
        run = subprocess.run([sys.executable, "-c", code, *map(str, command)], check=True, capture_output=True,
                             text=True)
        return int(run.stdout.split()[-1]) / 1024


def memory(peaks):
    return """## Memory

Peak of flownav-replay over the sample, and over the same many times. "started": of the program that only says its
version, with all the libraries it needs.

""" + table(["drive", "MB"], [[name, f"{peak:.0f}"] for name, peak in peaks.items()])


def realtime(latencies):
    if not latencies:
        return ""
    rows = [[run["scheduling"], str(run["fields"]), str(run["dropped"])] +
            [f"{run['latency_ms'][key]:.2f}" for key in ("median", "p99", "p99_9", "worst")] for run in latencies]
    return """## Latency

`flownav-replay --realtime`: fields at their times, beside a process that keeps a core busy; from the arrival of a field
until the local map was ready. "fifo": run by `chrt -f 10`, before all that is not as urgent. A recording shorter than
the run is played again and again; where it begins anew the view jumps, and a search takes some milliseconds.

""" + table(["scheduling", "fields", "dropped", "median (ms)", "99 % (ms)", "99.9 % (ms)", "worst (ms)"], rows)


def targets(runs, peaks, latencies):
    """Returns the targets beside the measured values; rows whose benchmarks did not run are left out."""
    rows = []

    def row(what, target, value, unit, met):
        rows.append([what, target, f"{value:.3g} {unit}".strip(), "yes" if met else "no"])

    def ratio(name, of):
        return per(runs.by_name[name], "vectors") / per(runs.by_name[of], "vectors")

    for name, share in {"avx512bw": 75, "avx2": 75, "sse41": 70}.items():
        if "limit/" + name in runs.by_name:
            reached = 100 * ratio("limit/" + name, "kernel/" + name)
            row(f"{name} of the limit of {INSTRUCTIONS[name]}", f">= {share} %", reached, "%", reached >= share)
    portable = VECTORS * per(runs.by_name["kernel/portable"], "vectors")
    row(f"portable kernel, {VECTORS} vectors", "<= 0.6 ms", portable, "ms", portable <= 0.6)
    matching = "flow/rendered/flownav-integer-" + runs.context["kernel"]
    for other, times in {"PyrLK-16": 20, "PyrLK-21": 40, "DIS-ultrafast": 40}.items():
        faster = ratio("flow/rendered/" + other, matching)
        row(f"matching faster than {other}", f">= {times} x", faster, "x", faster >= times)
    faster = ratio("flow/rendered/PyrLK-16", "flow/rendered/flownav-default")
    row("with sub-pixel faster than PyrLK-16", ">= 8 x", faster, "x", faster >= 8)
    for key, what in {"mean_px": "all vectors", "kept_mean_px": "the kept vectors"}.items():
        ours, theirs = (runs.by_name["flow/rendered/" + name][key] for name in ("flownav-default", "PyrLK-16"))
        row(f"error beside PyrLK-16, {what}", "<= 1.5 x", ours / theirs, "x", ours <= 1.5 * theirs)
    for name, most in {"avx512bw": 0.25, "avx2": 0.35}.items():
        for suffix, what, limit in (("", "step", most), ("/map", "step with local map", 0.5)):
            if f"step/{name}{suffix}" in runs.by_name:
                ms = per(runs.by_name[f"step/{name}{suffix}"], "fields")
                row(f"{what}, {name}", f"<= {limit} ms", ms, "ms", ms <= limit)
    if "replay/gz6/threads-2" in runs.by_name:
        times = 1e3 / per(runs.by_name["replay/gz6/threads-2"], "fields") / PAL_FIELDS_A_SECOND
        row("replay of gz 6 with two threads", ">= 20 x PAL", times, "x", times >= 20)
    for run in latencies:
        ms = run["latency_ms"]["p99_9"]
        row(f"99.9 % latency, {run['scheduling']}", "< 2 ms", ms, "ms", ms < 2)
        row(f"dropped fields, {run['scheduling']}", "0", run["dropped"], "", run["dropped"] == 0)
    row("memory", "< 100 MB", max(peaks.values()), "MB", max(peaks.values()) < 100)
    return "## What was aimed at\n\n" + table(["what", "target", "measured", "met"], rows)


def parsed():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("json", type=Path)
    parser.add_argument("--replay", type=Path, required=True)
    parser.add_argument("--recordings", type=Path, required=True)
    parser.add_argument("--realtime", type=Path, action="append", default=[])
    parser.add_argument("--output", type=Path, required=True)
    return parser.parse_args()


def main():
    arguments = parsed()
    runs = Runs(arguments.json)
    latencies = [json.loads(path.read_text()) for path in arguments.realtime]
    peaks = {"started": peak_mb(arguments.replay, None)}
    for name in ("jpeg", "long"):
        peaks[name] = peak_mb(arguments.replay, arguments.recordings / (name + ".rawlog"))
    parts = ["# Speed and memory\n\n`tests/bench/run.sh` measures this and writes the page.\n", machine(runs),
             targets(runs, peaks, latencies), kernels(runs), comparison(runs), steps(runs), replays(runs), growth(runs),
             memory(peaks), realtime(latencies)]
    arguments.output.write_text("\n".join(part.rstrip("\n") + "\n" for part in parts if part))
    print(f"wrote {arguments.output}")


if __name__ == "__main__":
    main()
