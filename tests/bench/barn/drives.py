"""Runs many drives of flownav-nav in parallel; results are kept one by one, so that an interrupted benchmark
continues."""

import argparse
import json
import statistics
import subprocess
from concurrent.futures import ThreadPoolExecutor, as_completed
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
OUTCOMES = ("reached", "blocked", "collision", "fell", "timeout")


def parser(description):
    """Returns a parser for the arguments common to all benchmarks of drives."""
    p = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--output", type=Path, required=True, metavar="DIR", help="runs, pictures and table")
    p.add_argument("--program", type=Path, default=ROOT / "build/release/apps/nav/flownav-nav", metavar="FILE")
    p.add_argument("--navigator", choices=("lanes", "reactive"), default="lanes")
    p.add_argument("--sensor", choices=("flow", "lidar"), default="flow")
    p.add_argument("--jobs", type=int, default=2, help="runs at the same time")
    p.add_argument("more", nargs="*", metavar="-- OPTION", help="further options of flownav-nav")
    return p


def run(arguments, stem, options):
    """Runs one drive; keeps its result as runs/STEM.json and its picture as pictures/STEM.png."""
    result = arguments.output / "runs" / f"{stem}.json"
    if not result.is_file():
        part = result.with_suffix(".part")
        command = [arguments.program, "--navigator", arguments.navigator, "--sensor", arguments.sensor, "--quiet"]
        command += ["--result", part, "--picture", arguments.output / "pictures" / f"{stem}.png"]
        command += list(options) + arguments.more
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        if done.returncode not in (0, 4, 5, 6):
            raise RuntimeError(f"{stem}: {done.stderr.strip() or done.returncode}")
        part.rename(result)
    return json.loads(result.read_text())


def run_all(arguments, jobs):
    """Runs all jobs (options by stem); returns the results by stem, in the order of `jobs`."""
    for folder in ("runs", "pictures"):
        (arguments.output / folder).mkdir(parents=True, exist_ok=True)
    results = {}
    with ThreadPoolExecutor(arguments.jobs) as pool:
        running = {pool.submit(run, arguments, stem, options): stem for stem, options in jobs.items()}
        for job in as_completed(running):
            stem = running[job]
            results[stem] = result = job.result()
            text = f"{len(results)}/{len(jobs)} {stem}: {result['outcome']} {result['time_s']:.1f} s {result['why']}"
            print(text, flush=True)
    return {stem: results[stem] for stem in jobs}


def table_row(name, runs, score=False):
    """Returns the shares of the outcomes (falls count as collisions), mean time of the drives that arrived, smallest
    clearance, and BARN's mean score if any."""
    share = {word: sum(r["outcome"] == word for r in runs) / len(runs) for word in OUTCOMES}
    times = [r["time_s"] for r in runs if r["outcome"] == "reached"]
    mean_time = f"{statistics.mean(times):.1f}" if times else "-"
    last = f"{statistics.mean(r['score'] for r in runs):.3f}" if score else f"{min(r['min_clearance_m'] for r in runs):.2f}"
    return (
        f"| {name} | {share['reached']:.3f} | {share['collision'] + share['fell']:.3f} | {share['timeout'] + share['blocked']:.3f} "
        f"| {mean_time} | {last} | {len(runs)} |"
    )


def write_table(arguments, lines):
    (arguments.output / "table.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
