#!/usr/bin/env bash
# Measures speed and memory, and writes share/doc/benchmark.md. Needs a build: cmake --build --preset release.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

usage() {
    cat <<END
usage: tests/bench/run.sh [--quick] [--realtime-summary FILE] [--output FILE.md] [--help]
  --quick                  a tenth of the time, for a look; the figures are rough
  --realtime-summary FILE  realtime.json of a long run of flownav-replay --realtime beside a busy process, for the page;
                           may be repeated
  --output FILE.md         the page; default share/doc/benchmark.md
Takes about five minutes on a machine that does nothing else. FLOWNAV_DATA names the folder of the optional test data
(default: ../shared/data beside the checkout). Exit status: 0 written, 1 otherwise.
END
}

time=0.5
rounds=20
realtime=()
page=$root/share/doc/benchmark.md
while [ $# -gt 0 ]; do
    case $1 in
        --quick) time=0.05 rounds=2 ;;
        --realtime-summary) realtime+=(--realtime "$2") && shift ;;
        --output) page=$2 && shift ;;
        --help | -h) usage && exit 0 ;;
        *) echo "run.sh: unknown argument $1" >&2 && usage >&2 && exit 1 ;;
    esac
    shift
done

programs=$root/build/release
work=$root/build/bench
mkdir -p "$work"
"$programs/tests/bench/flownav-bench-recordings" "$work/recordings" "$rounds"
FLOWNAV_BENCH_RECORDINGS=$work/recordings "$programs/tests/bench/flownav-bench" --benchmark_min_time="$time" \
    --benchmark_out="$work/bench.json" --benchmark_out_format=json
python3 "$root/tests/bench/page.py" "$work/bench.json" --replay "$programs/apps/replay/flownav-replay" \
    --recordings "$work/recordings" --output "$page" "${realtime[@]}"
