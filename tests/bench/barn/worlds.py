#!/usr/bin/env python3
"""Drives flownav's simulated robot through generated worlds: corridors, offices, halls and forests, stairs and ramps. Runs are kept
one by one: an interrupted benchmark goes on where it was."""

import drives

KINDS = ("corridor", "office", "hall", "forest")
LOOKS = ("real", "patterned", "faint", "plain")


def main():
    parser = drives.parser(__doc__)
    parser.add_argument("--kinds", default=",".join(KINDS), help="some of " + ", ".join(KINDS) + ", stairs, ramp")
    parser.add_argument("--seeds", type=int, default=25, help="worlds of each kind")
    parser.add_argument("--objects", choices=LOOKS, default="patterned", help="look of the worlds")
    parser.add_argument("--config", metavar="FILE.ini", help="configuration of the robot")
    arguments = parser.parse_args()
    kinds = arguments.kinds.split(",")
    more = ["--objects", arguments.objects, "--timeout-s", "180"]
    more += ["--config", arguments.config] if arguments.config else []
    jobs = {
        f"{kind}_{seed}": ["--generate", kind, "--seed", seed] + more
        for kind in kinds
        for seed in range(1, arguments.seeds + 1)
    }
    results = drives.run_all(arguments, jobs)
    lines = ["| | success | collision | timeout | mean time (s) | nearest (m) | runs |", "|---|---|---|---|---|---|---|"]
    for kind in kinds:
        runs = [result for stem, result in results.items() if stem.startswith(kind)]
        lines.append(drives.table_row(f"{kind}: {arguments.navigator}, {arguments.sensor}", runs))
    drives.write_table(arguments, lines)


if __name__ == "__main__":
    main()
