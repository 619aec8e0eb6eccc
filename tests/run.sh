#!/usr/bin/env bash
# Installs the packages, builds flownav, and runs every test: optimised, then with sanitizers.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
    cat <<END
usage: tests/run.sh [--quick] [--help]
  --quick   only the optimised build, without the sanitizers
FLOWNAV_DATA names the folder of the optional test data (default: ../shared/data beside the checkout); tests that
need it are skipped where it is absent. Exit status: 0 every test passed, 1 otherwise.
END
}

presets=(release dev)
for argument in "$@"; do
    case $argument in
        --quick) presets=(release) ;;
        --help | -h) usage && exit 0 ;;
        *) echo "tests/run.sh: unknown argument $argument" >&2 && usage >&2 && exit 1 ;;
    esac
done

"$root/share/install-packages.sh"
data=${FLOWNAV_DATA:-$root/../shared/data}
if [ -d "$data" ]; then
    FLOWNAV_DATA=$(cd "$data" && pwd)
    export FLOWNAV_DATA
else
    echo "No test data at $data: tests that need it are skipped."
fi
cd "$root"
# What was compiled in one checkout serves every other.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
jobs=$(nproc)
summary=()
failed=0

run_preset() {
    cmake --preset "$1" && cmake --build --preset "$1" && ctest --preset "$1" --parallel "$jobs"
}

for preset in "${presets[@]}"; do
    start=$SECONDS
    outcome=passed
    run_preset "$preset" || outcome=FAILED
    [ "$outcome" = passed ] || failed=1
    summary+=("$preset: $outcome after $((SECONDS - start)) s")
done

echo
printf '%s\n' "${summary[@]}"
exit "$failed"
