#!/usr/bin/env bash
# Renders the scenes, runs the chain over them and writes share/doc/fidelity.md with its pictures.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)

usage() {
    cat <<END
usage: tests/bench/fidelity/run.sh [--help]
Writes share/doc/fidelity.md and share/doc/fidelity-*.svg. Takes about a quarter of an hour on two cores, five minutes
when build/fidelity-cache (1.4 GB) still holds the rendered pictures. FLOWNAV_DATA names the folder of the optional
recordings of real drives (default: ../shared/data beside the checkout). Exit status: 0 written, 1 otherwise.
END
}

for argument in "$@"; do
    case $argument in
        --help | -h) usage && exit 0 ;;
        *) echo "run.sh: unknown argument $argument" >&2 && usage >&2 && exit 1 ;;
    esac
done

cd "$root"
cmake --preset release
cmake --build --preset release --target flownav-fidelity
build/release/tests/bench/fidelity/flownav-fidelity --page share/doc/fidelity.md --cache build/fidelity-cache
