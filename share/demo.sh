#!/usr/bin/env bash
# Installs the packages, builds flownav, simulates a drive and replays it, and drives a simulated robot to its goal; all
# into out/demo. May be run again at any time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
apps=$root/build/release/apps
out=$root/out/demo
world=$root/share/worlds/railing_and_chair.world
recording=$out/drive.rawlog

"$root/share/install-packages.sh"
cd "$root"
cmake --preset release
cmake --build --preset release --target flownav-sim flownav-replay flownav-nav flownav-view
mkdir -p "$out"

# newer FILE OTHER...: whether FILE is there and not older than any of the others.
newer() {
    local file=$1 other
    shift
    [ -e "$file" ] || return 1
    for other in "$@"; do
        [ "$file" -nt "$other" ] || return 1
    done
}

if newer "$recording" "$apps/sim/flownav-sim" "$world"; then
    echo "The drive has been simulated already."
else
    echo "Simulating a drive along a railing ..."
    "$apps/sim/flownav-sim" "$world" --interlaced --script "forward 2; left 15 4; right 15 4; forward 3" --output "$recording"
fi
if newer "$out/replay/report.html" "$apps/replay/flownav-replay" "$recording"; then
    echo "The drive has been replayed already."
else
    echo "Replaying it ..."
    "$apps/replay/flownav-replay" "$recording" --output "$out/replay" --video "$out/drive.mp4" --timing
fi
if newer "$out/nav/report.html" "$apps/nav/flownav-nav"; then
    echo "The robot has been to its goal already."
else
    echo "Driving a robot to its goal ..."
    "$apps/nav/flownav-nav" --generate hall --seed 3 --objects patterned --output "$out/nav"
fi

cat <<END

What came of it is in $out
  replay/report.html    what the sensor made of the simulated drive: linked charts, way, map, pictures with vectors and
                        obstacles; open it in a browser
  drive.mp4             the same drive as a video: annotated fields beside the growing map
  nav/drive.png         the robot that drove to its goal, from above: its map, the true outlines, its way
  nav/report.html       what its sensor saw on the way
  nav/drive.csv, nav/result.json   every decision, and what came of it (share/doc/outputs.md explains every column)
  drive.rawlog, nav/run.rawlog     both recordings, for MRPT's own tools too, such as RawLogViewer

Every block of every field, on a screen:
  build/release/apps/view/flownav-view out/demo/nav/run.rawlog
END
