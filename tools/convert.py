#!/usr/bin/env python3
"""Converts microscopes' files to Gwyddion simple fields (.gsf), which diffraction-atlas reads.

    python3 tools/convert.py scan.mi                  # writes scan.gsf beside it
    python3 tools/convert.py scans/ --out converted/  # every file of a folder, and of those below
    python3 tools/convert.py scan.h5 --list           # which channels there are
    python3 tools/convert.py scan.h5 --channel Height

For formats that the program does not read itself; about forty are known to SurfaceTopography, which does the reading:
`python3 -m pip install SurfaceTopography`. Pitch, unit and missing samples are kept; nothing that is there is overwritten.
"""

import argparse
import math
import os
import struct
import sys
from pathlib import Path

# Length units that appear in files, in metres.
METRES = {"m": 1.0, "cm": 1e-2, "mm": 1e-3, "µm": 1e-6, "μm": 1e-6, "um": 1e-6, "nm": 1e-9, "Å": 1e-10, "pm": 1e-12}
# Names of channels that are no heights even where their unit is a length.
OTHERS = ("amplitude", "phase", "deflection", "error", "friction", "lateral", "adhesion", "deformation", "indentation", "intensity")
HEIGHTS = ("height", "topo", "z-axis", "zsensor", "z sensor")


class Refused(Exception):
    """A file that is not converted, with the reason."""


def simple_field(rows, extent_m, title):
    """The bytes of a simple field: `rows` are heights in m, row 0 at +y, NaN where missing."""
    ny, nx = rows.shape
    header = ["Gwyddion Simple Field 1.0", f"XRes = {nx}", f"YRes = {ny}", f"XReal = {extent_m[0]!r}", f"YReal = {extent_m[1]!r}",
              "XYUnits = m", "ZUnits = m", "Title = " + " ".join(title.split())]
    text = ("\n".join(header) + "\n").encode("utf-8")
    return text + b"\0" * (4 - len(text) % 4) + struct.pack(f"<{nx * ny}f", *(float(height) for height in rows.ravel()))


def channel_of(reader, wanted):
    """The channel to convert: the one asked for, the only one, or the only one named a height."""
    channels = list(enumerate(reader.channels))
    if not channels:
        raise Refused("it holds no height map")
    names = ", ".join(repr(channel.name) for _, channel in channels)
    if wanted is not None:
        fits = [pair for pair in channels if wanted.lower() == pair[1].name.lower()]
        fits = fits or [pair for pair in channels if wanted.lower() in pair[1].name.lower()]
        if len(fits) != 1:
            raise Refused(f"{len(fits)} of its channels fit {wanted!r}: {names}")
        return fits[0]
    maps = [(i, c) for i, c in channels if c.dim == 2 and not any(word in c.name.lower() for word in OTHERS)]
    heights = [pair for pair in maps if any(word in pair[1].name.lower() for word in HEIGHTS)]
    # The scanner's way back shows the same surface.
    forward = [pair for pair in heights if not any(word in pair[1].name.lower() for word in ("retrace", "backward"))]
    for choice in (forward, heights, maps):
        if len(choice) == 1:
            return choice[0]
    raise Refused(f"which of its channels is the height is not clear; say --channel NAME: {names}")


def read(path, wanted):
    """Heights in m with row 0 at +y, extent in m, and the channel's name."""
    import numpy
    from SurfaceTopography.IO import open_topography

    try:
        reader = open_topography(str(path))
        index, channel = channel_of(reader, wanted)
        if channel.dim != 2:
            raise Refused(f"its channel {channel.name!r} is a profile")
        surface = reader.topography(channel_index=index)
        heights = numpy.ma.filled(numpy.ma.masked_invalid(surface.heights().astype(float)), math.nan)
    except Refused:
        raise
    except Exception as error:  # Whatever a reader of forty formats may raise on a file.
        raise Refused(f"SurfaceTopography cannot read it: {str(error).strip().splitlines()[0] if str(error).strip() else type(error).__name__}") from None
    unit = METRES.get(surface.unit)
    if unit is None:
        raise Refused(f"its unit is {surface.unit!r}, not a length")
    # Their arrays are [x, y], shown with y down.
    return heights.T * unit, tuple(float(side) * unit for side in surface.physical_sizes), channel.name


def convert(path, target, wanted):
    """Writes `target` from `path`; neither file may be harmed."""
    if target.exists():
        raise Refused(f"{target} is there already")
    rows, extent_m, title = read(path, wanted)
    target.parent.mkdir(parents=True, exist_ok=True)
    part = target.with_name(target.name + ".part")
    try:
        with open(part, "xb") as file:
            file.write(simple_field(rows, extent_m, title))
        # A link fails where the name is taken; a rename would overwrite.
        os.link(part, target)
    except FileExistsError as error:
        raise Refused(f"{error.filename2 or error.filename} is there already") from None
    finally:
        part.unlink(missing_ok=True)


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("source", type=Path, help="a file, or a folder of them")
    words.add_argument("--out", type=Path, help="folder for the .gsf files; beside each file by default")
    words.add_argument("--channel", help="channel of files with several: its name or a part of it")
    words.add_argument("--list", action="store_true", help="list the channels and convert nothing")
    args = words.parse_args()
    try:
        from SurfaceTopography.IO import open_topography
    except ImportError:
        sys.exit("convert.py needs SurfaceTopography: python3 -m pip install SurfaceTopography")
    if not args.source.exists():
        sys.exit(f"{args.source}: there is no such file or folder")
    root = args.source if args.source.is_dir() else args.source.parent
    files = sorted(path for path in args.source.rglob("*") if path.is_file()) if args.source.is_dir() else [args.source]
    if args.list:
        for path in files:
            try:
                print(f"{path}: " + ", ".join(repr(channel.name) for channel in open_topography(str(path)).channels))
            except Exception as error:
                print(f"{path}: not read ({type(error).__name__})")
        return
    done = 0
    for path in files:
        if path.suffix.lower() == ".gsf":
            continue
        # Files that differ in their ending alone get different names.
        rivals = [other for other in files if other.parent == path.parent and other.stem == path.stem and other.suffix.lower() != ".gsf"]
        name = path.stem + (path.suffix.replace(".", "_") if len(rivals) > 1 else "") + ".gsf"
        target = (args.out / path.parent.relative_to(root) if args.out else path.parent) / name
        try:
            convert(path, target, args.channel)
        except Refused as reason:
            print(f"{path}: not converted: {reason}", file=sys.stderr)
        else:
            done += 1
            print(f"{path} -> {target}")
    print(f"{done} of {len(files)} files converted", file=sys.stderr)
    sys.exit(0 if done else 1)


if __name__ == "__main__":
    main()
