#!/usr/bin/env bash
# Renders the scenes, runs the chain over them and writes share/doc/fidelity.md with its pictures.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../../.." && pwd)

usage() {
    cat <<END
usage: tests/bench/fidelity/run.sh [--cache DIR] [--help]
  --cache DIR   keep the rendered pictures there (1.4 GB) and use them again; without it they are rendered anew
Writes share/doc/fidelity.md and share/doc/fidelity-*.svg; takes about a quarter of an hour on two cores. Exit status:
0 written, 1 otherwise.
END
}

cache=
while [ $# -gt 0 ]; do
    case $1 in
        --cache) cache=${2:?--cache needs a folder} && shift 2 ;;
        --help | -h) usage && exit 0 ;;
        *) echo "run.sh: unknown argument $1" >&2 && usage >&2 && exit 1 ;;
    esac
done
temporary=
if [ -z "$cache" ]; then
    temporary=$(mktemp -d)
    trap 'rm -rf "$temporary"' EXIT
    cache=$temporary
fi
cd "$root"
cmake --preset release
cmake --build --preset release --target flownav-fidelity
build/release/tests/bench/fidelity/flownav-fidelity --page share/doc/fidelity.md --cache "$cache"
