#!/usr/bin/env bash
# Replays the rawlogs of a manifest, what is not replayed yet, and compares their figures with those expected.
set -euo pipefail

usage() {
    cat <<END
usage: tests/regression/check.sh FLOWNAV-REGRESS FLOWNAV-REPLAY MANIFEST ROOT EXPECTED.json OUTPUT
The paths of MANIFEST start from ROOT. OUTPUT becomes the folder of the results, OUTPUT.xml the report for a CI server.
Exit status: that of flownav-regress check, or of its run where that did not end properly.
END
}

if [ $# -ne 6 ]; then
    usage >&2
    exit 2
fi
regress=$1 replay=$2 manifest=$3 root=$4 expected=$5 output=$6

# Status 1 is for check to judge: of a damaged rawlog a failed replay is expected.
status=0
"$regress" run --manifest "$manifest" --root "$root" --program "$replay" --output "$output" || status=$?
[ "$status" -le 1 ] || exit "$status"
exec "$regress" check --manifest "$manifest" --output "$output" --expected "$expected" --junit "$output.xml"
