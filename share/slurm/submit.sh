#!/usr/bin/env bash
# Submits the replay of a manifest to Slurm: an array of tasks, and a job that merges when all of them have ended.
set -euo pipefail
# Adapt to your cluster. Partition, account, memory and time stand at the top of replay.sbatch and merge.sbatch.
regress=${FLOWNAV_REGRESS:-flownav-regress} # must be there on every node
retries=${RETRIES:-3}                       # of a task whose node was lost or that could not write
most_shards=${MOST_SHARDS:-1000}            # MaxArraySize of the cluster, less one

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

usage() {
    cat <<END
usage: share/slurm/submit.sh MANIFEST OUTPUT [--missing] [--failed] [OPTION of flownav-regress run]...
  --missing   only the rawlogs without any result
  --failed    only the rawlogs that failed; with --missing: both
Both files must be on a file system that every node has. Exit status: 0 submitted, or nothing to do; 1 otherwise.
END
}

fail() {
    echo "submit.sh: $*" >&2
    exit 1
}

# Which tasks of the array have something to do: 0-99, or 3,17,20. Line k of the manifest is of shard k mod shards.
tasks() {
    local lines status=0
    if [ ${#wanted[@]} -eq 0 ]; then
        echo "0-$((shards - 1))"
        return
    fi
    lines=$("$FLOWNAV_REGRESS" merge --manifest "$manifest" --output "$output" "${wanted[@]}") || status=$?
    [ "$status" -eq 0 ] || [ "$status" -eq 3 ] || return "$status"
    tr ',' '\n' <<<"$lines" | awk -v n="$shards" 'NF && !seen[$1 % n]++ { printf "%s%d", comma, $1 % n; comma = "," }'
}

case ${1:-} in
    --help | -h) usage && exit 0 ;;
esac
[ $# -ge 2 ] || { usage >&2 && exit 1; }
manifest=$(realpath "$1")
output=$(realpath --canonicalize-missing "$2")
shift 2
wanted=()
options=()
for argument in "$@"; do
    case $argument in
        --missing | --failed) wanted+=("$argument") ;;
        *) options+=("$argument") ;;
    esac
done

program=$(command -v "$regress") || fail "there is no $regress: put it into PATH, or set FLOWNAV_REGRESS"
FLOWNAV_REGRESS=$(realpath --no-symlinks "$program")
rawlogs=$(grep -cE '^[[:space:]]*[^#[:space:]]' "$manifest") || fail "$manifest: no rawlog in it"
# As a rule a shard is one line of the manifest, and what merge --missing prints are tasks.
shards=$((rawlogs < most_shards ? rawlogs : most_shards))
mkdir -p "$output/log"
array=$(tasks) || fail "cannot tell what is missing"
if [ -z "$array" ]; then
    echo "Nothing to do."
    exit 0
fi
export FLOWNAV_REGRESS SHARD_COUNT=$shards RETRIES=$retries
replay=$(sbatch --parsable --export=ALL --array="$array" --output="$output/log/replay-%A_%a.txt" --open-mode=append \
    "$here/replay.sbatch" --manifest "$manifest" --output "$output" --quiet "${options[@]}")
merge=$(sbatch --parsable --export=ALL --dependency="afterany:${replay%%;*}" --output="$output/log/merge-%j.txt" \
    "$here/merge.sbatch" --manifest "$manifest" --output "$output")
echo "Job ${replay%%;*} replays shards $array of $shards; then job ${merge%%;*} merges."
