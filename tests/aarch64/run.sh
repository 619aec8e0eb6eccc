#!/usr/bin/env bash
# Builds the kernels for a 64-bit ARM and runs their tests in an emulator.
# Exit status 77: the packages cannot be had here.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/aarch64

if ! "$root/share/install-packages.sh" "$root/tests/aarch64/apt-packages.txt"; then
    echo "skipped: the packages of tests/aarch64/apt-packages.txt cannot be installed" >&2
    exit 77
fi
cmake -S "$root/tests/aarch64" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_TOOLCHAIN_FILE="$root/tests/aarch64/toolchain.cmake"
cmake --build "$build"
ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" --no-tests=error
