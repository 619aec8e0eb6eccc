#!/usr/bin/env bash
# Installs the packages, builds flownav, and runs every test: optimised, then with sanitizers; what starts threads with
# the thread sanitizer as well.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
    cat <<END
usage: tests/run.sh [--quick] [--slurm] [--aarch64] [--help]
  --quick   only the optimised build, without the sanitizers
  --slurm   also installs Slurm, starts a cluster of two nodes on this machine for some minutes and replays on it;
            skipped where one is not root or the packages cannot be had
  --aarch64 also builds the matching kernels for a 64-bit ARM and tests them in an emulator; skipped where the packages
            cannot be had
FLOWNAV_DATA names the folder of the optional test data (default: ../shared/data beside the checkout); tests that
need it are skipped where it is absent. Exit status: 0 every test passed, 1 otherwise.
END
}

more=()
sanitizers=(tsan dev)
for argument in "$@"; do
    case $argument in
        --quick) sanitizers=() ;;
        --slurm | --aarch64) more+=("${argument#--}") ;;
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

run_step() {
    case $1 in
        slurm) tests/system/install_slurm.sh && python3 tests/system/test_slurm.py build/release ;;
        aarch64) tests/aarch64/run.sh ;;
        *) run_preset "$1" ;;
    esac
}

for step in release "${more[@]}" "${sanitizers[@]}"; do
    start=$SECONDS
    outcome=passed
    run_step "$step" || case $step:$? in
        slurm:77 | aarch64:77) outcome=SKIPPED ;;
        *) outcome=FAILED && failed=1 ;;
    esac
    summary+=("$step: $outcome after $((SECONDS - start)) s")
done

echo
printf '%s\n' "${summary[@]}"
exit "$failed"
