"""The command `diffraction-atlas-py`."""

from __future__ import annotations

import argparse
import sys

from . import _rgl
from ._atlas import open
from ._check import check
from ._images import AtlasError


def main(arguments: list[str] | None = None) -> int:
    """Exit status 0 where all is well, 1 where a value is not met, 2 where the atlas cannot be read."""
    parser = argparse.ArgumentParser(prog="diffraction-atlas-py", description="Reads an atlas of diffraction tables.")
    commands = parser.add_subparsers(required=True, metavar="command")
    command = commands.add_parser("check", help="evaluates all check values, X, Y, Z and wavelengths")
    command.add_argument("atlas", help="the folder of an atlas, whose newest version is taken, or of one version")
    command = commands.add_parser("rgl", help="writes a specimen as a tensor file for stock Mitsuba and pbrt-v4, a stand-in whose error it says")
    command.add_argument("atlas", help="as above")
    command.add_argument("specimen", help="its name")
    command.add_argument("--out", required=True, metavar="FILE", help="a file that is not there yet, mostly called .bsdf")
    command.add_argument("--mib", type=float, default=64, help="size of the file, 64 if left out; it takes a few times that in memory")
    given = parser.parse_args(arguments)
    try:
        if "out" in given:
            print(_rgl.export(open(given.atlas)[given.specimen], given.out, given.mib))
            return 0
        return 0 if check(open(given.atlas)) else 1
    except (AtlasError, KeyError, OSError, ValueError) as error:
        print(f"error: {error.args[0] if isinstance(error, KeyError) else error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
