#!/usr/bin/env python3
"""Renders the rawlogs of tests/regression/manifest, the same bytes everywhere:
    make_rawlogs.py FLOWNAV-MAKE-SCENE OUTPUT_FOLDER
What is there already and newer than the renderer and this file is left as it is."""

import gzip
import subprocess
import sys
import tempfile
from pathlib import Path

# Images, seed, and the words for flownav-make-scene.
SCENES = {
    "carpet": (40, 1, "s-curve --floor carpet"),
    "tiles": (40, 2, "s-curve --floor tiles"),
    "lino": (40, 3, "s-curve --floor lino"),
    "plain": (40, 4, "s-curve --floor plain"),
    "stoneware": (40, 5, "s-curve --floor stoneware"),
    "marbled": (40, 6, "corridor --floor marbled"),
    "sharp_turns": (60, 7, "turns --turn 60"),
    "vibration": (40, 8, "s-curve --vibration 0.3"),
    "mover": (50, 9, "mover"),
    "light": (40, 10, "s-curve --exposure-step 0.1 --flicker 0.03 --exposure 0.01"),
    "pal_fields": (40, 11, "s-curve --interlaced --width 768 --height 576"),
    "blur": (40, 12, "s-curve --blur 0.02"),
    "stop_and_go": (50, 13, "stop-and-go"),
    "long_straight": (90, 14, "straight"),
}
SMALL = ["--width", "320", "--height", "240"]


def render(program, name, folder):
    """The rawlog of a scene, unpacked: what deflate makes of it is another matter with every version of zlib."""
    images, seed, words = SCENES[name]
    size = [] if "--width" in words else SMALL
    subprocess.run([program, *words.split(), *size, "--images", str(images), "--seed", str(seed), "--gz", "1",
                    "--output", folder / name], check=True, stdout=subprocess.DEVNULL)  # fmt: skip
    return gzip.decompress((folder / f"{name}.rawlog").read_bytes())


def packed_and_cut(rawlog):
    """A gzip file of stored blocks that ends in the middle of a block, as where a disk was full."""
    blocks = [rawlog[at : at + 0xFFFF] for at in range(0, len(rawlog), 0xFFFF)]
    stored = b"".join(
        b"\0" + len(block).to_bytes(2, "little") + (len(block) ^ 0xFFFF).to_bytes(2, "little") + block
        for block in blocks
    )
    return b"\x1f\x8b\x08\0\0\0\0\0\0\xff" + stored[: len(stored) // 2]


def flipped(rawlog):
    """Damaged in a picture, which nobody can tell, and where an object begins, which ends the reading."""
    damaged = bytearray(rawlog)
    a_picture = rawlog.index(b"CObservationImage", len(rawlog) // 4)
    an_object = rawlog.index(b"CObservationOdometry", len(rawlog) * 3 // 4)
    for first, length in ((a_picture + 20000, 500), (an_object - 4, 40)):
        for at in range(first, first + length):
            damaged[at] ^= 0xFF
    return bytes(damaged)


DAMAGED = {"cut": ("carpet", packed_and_cut), "flipped_bytes": ("tiles", flipped)}


def is_up_to_date(file, program):
    newest = max(program.stat().st_mtime, Path(__file__).stat().st_mtime)
    return file.exists() and file.stat().st_mtime > newest


def write(file, content):
    """At once or not at all."""
    part = file.with_suffix(".part")
    part.write_bytes(content)
    part.replace(file)


def main(program, output):
    output.mkdir(parents=True, exist_ok=True)
    wanted = {name: output / f"{name}.rawlog" for name in [*SCENES, *DAMAGED]}
    missing = [name for name, file in wanted.items() if not is_up_to_date(file, program)]
    for name in missing:
        if name in SCENES:
            with tempfile.TemporaryDirectory(dir=output) as folder:
                write(wanted[name], render(program, name, Path(folder)))
    for name in missing:
        if name in DAMAGED:
            whole, damage = DAMAGED[name]
            write(wanted[name], damage(wanted[whole].read_bytes()))
    print(f"{len(missing)} rawlogs made, {len(wanted) - len(missing)} were there")


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]))
