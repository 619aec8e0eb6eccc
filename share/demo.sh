#!/usr/bin/env bash
# Installs the packages, builds flownav, and replays the sample drive into out/demo. May be run again at any time.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
drive=$root/share/datasets/corridor.rawlog
program=$root/build/release/apps/replay/flownav-replay
out=$root/out/demo

"$root/share/install-packages.sh"
cd "$root"
cmake --preset release
cmake --build --preset release --target flownav-replay flownav-view

if [ "$out/report.html" -nt "$program" ] && [ "$out/report.html" -nt "$drive" ]; then
    echo "The drive has been replayed already."
else
    mkdir -p "$out"
    "$program" "$drive" --output "$out" --video "$out/drive.mp4" --timing
fi

cat <<END

What the sensor made of the drive is in $out
  report.html                  linked charts, way, map and pictures with vectors and obstacles: open it in a browser
  map.pgm, map.yaml            the occupancy grid
  trajectory.tum               the path of the robot
  egomotion.csv, obstacles.csv the numbers behind them (share/doc/outputs.md explains every column)
  result.rawlog                the same for MRPT's own tools, such as RawLogViewer

Every block of every field, on a screen:
  build/release/apps/view/flownav-view share/datasets/corridor.rawlog
END
