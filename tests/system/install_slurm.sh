#!/usr/bin/env bash
# Installs the packages of share/slurm/apt-packages.txt without starting their services. Exit status 77: the
# packages are not available.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
policy=/usr/sbin/policy-rc.d # what Debian asks before it starts a service; 101 is no

if [ "$(id -u)" -ne 0 ]; then
    echo "skipped: only root can start a Slurm cluster" >&2
    exit 77
fi
kept=$(mktemp -d)
restore() {
    rm -f "$policy"
    if [ -e "$kept/policy" ] || [ -L "$kept/policy" ]; then mv "$kept/policy" "$policy"; fi
    rmdir "$kept"
}
trap restore EXIT
if [ -e "$policy" ] || [ -L "$policy" ]; then mv "$policy" "$kept/policy"; fi
printf '#!/bin/sh\nexit 101\n' >"$policy"
chmod +x "$policy"
if ! "$root/share/install-packages.sh" "$root/share/slurm/apt-packages.txt"; then
    echo "skipped: the packages of share/slurm/apt-packages.txt cannot be installed" >&2
    exit 77
fi
