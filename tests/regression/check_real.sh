#!/usr/bin/env bash
# Imports the data of others and checks their figures; status 77, skipped, where there are no such data.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
    cat <<END
usage: tests/regression/check_real.sh FLOWNAV-REGRESS FLOWNAV-REPLAY FLOWNAV-IMPORT OUTPUT
The data are in FLOWNAV_DATA (default: ../shared/data beside the checkout).
END
}

if [ $# -ne 4 ]; then
    usage >&2
    exit 2
fi
data=${FLOWNAV_DATA:-$here/../../../shared/data}
for needed in scenes kitti-odometry kitti-raw donkeycar-gyro; do
    if [ ! -d "$data/$needed" ]; then
        echo "SKIPPED: no $data/$needed; FLOWNAV_DATA names the folder of the data"
        exit 77
    fi
done
"$here/import_real.sh" "$3" "$data" "$4/rawlogs"
exec "$here/check.sh" "$1" "$2" "$here/real.manifest" "$4/rawlogs" "$here/real.expected.json" "$4/results"
