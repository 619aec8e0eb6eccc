#!/usr/bin/env bash
# Makes the folder that the paths of real.manifest start from: rawlogs of others' data, imported or linked.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

usage() {
    cat <<END
usage: tests/regression/import_real.sh FLOWNAV-IMPORT DATA OUTPUT_FOLDER
DATA holds scenes, kitti-odometry, kitti-raw and donkeycar-gyro. What is imported already, and newer than the program,
is left as it is.
END
}

if [ $# -ne 3 ]; then
    usage >&2
    exit 1
fi
program=$1
data=$(cd "$2" && pwd)
output=$3
mkdir -p "$output"

ln -sfn "$root/ini" "$output/ini"
ln -sf "$data/scenes/field.rawlog" "$data/scenes/moving2.rawlog" "$output"

import() {
    local rawlog=$output/$1
    if [ "$rawlog" -nt "$program" ]; then return; fi
    "$program" "${@:2}" --output "$rawlog" --quiet
}
import kitti_00.rawlog kitti-odometry "$data/kitti-odometry" 00
import kitti_braking.rawlog kitti-raw "$data/kitti-raw/2011_09_26" braking
import donkeycar.rawlog images "$data/donkeycar-gyro/images" --camera "$root/ini/donkeycar.ini"
