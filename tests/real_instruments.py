"""Files that instruments wrote, as the program reads them and as SurfaceTopography from PyPI does, or NSFopen those of Nanosurf that it cannot.

    python3 -m venv venv && venv/bin/pip install SurfaceTopography NSFopen tifffile
    venv/bin/python tests/real_instruments.py PROGRAM FILE...

PROGRAM is the binary. Each file's heights about their best plane have to agree within a millionth of their range, half a step of an instrument's
16-bit numbers, or the single precision of the heights that `--save-heights` writes, and the pitch within 1e-6, with some
channel of theirs, which is printed; a file that the program refuses is told with its
words. Where to find such files: docs/formats.md.
"""

import json
import re
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np
import tifffile
from SurfaceTopography.IO import open_topography

warnings.filterwarnings("ignore")
METRES = {"m": 1.0, "mm": 1e-3, "µm": 1e-6, "um": 1e-6, "nm": 1e-9, "pm": 1e-12, "Å": 1e-10}
TOLERANCE = 1e-6


def levelled(heights):
    """Heights about their best plane."""
    rows, columns = np.indices(heights.shape)
    terms = np.stack([np.ones(heights.size), rows.ravel(), columns.ravel()], axis=1)
    plane = terms @ np.linalg.lstsq(terms, heights.ravel(), rcond=None)[0]
    return heights - plane.reshape(heights.shape)


def theirs(path):
    """Name, heights in nm with row 0 at +y, and pitch in nm of every channel of heights."""
    try:
        reader = open_topography(str(path))
    except Exception:  # whatever it is that no reader of that program takes it for
        yield from by_nsfopen(path)
        return
    for index, channel in enumerate(reader.channels):
        try:
            topography = reader.topography(channel_index=index)
            unit = METRES[topography.unit] * 1e9
        except Exception:  # no height, or one of many channels that it cannot read
            continue
        heights = np.ma.filled(topography.heights(), np.nan).T * unit
        yield channel.name, heights, [side * unit / count for side, count in zip(topography.physical_sizes, topography.nb_grid_pts)]


def by_nsfopen(path):
    """As `theirs`, by the maker's own reader, whose rows begin at -y and whose sizes stand in the file's text."""
    from NSFopen.read import read

    images = read(str(path), verbose=False).data["Image"]
    text = path.read_bytes().decode("latin-1")
    text = text[text.index("Frame=Scan") :]
    side = [float(re.search(rf"Dim{axis}Range=([-+0-9.eE]+)", text).group(1)) * 1e9 for axis in (0, 1)]
    for way, channel in images.keys():
        if channel.startswith(("Z-Axis", "Topography")):
            heights = np.asarray(images[way][channel])[::-1] * 1e9
            yield f"{channel}, {way}", heights, [side[0] / heights.shape[1], side[1] / heights.shape[0]]


def check(program, path, folder):
    """Whether the file is read alike, or refused."""
    out = Path(folder) / "heights.tif"
    called = subprocess.run([program, "inspect", path, "--json", "--save-heights", out, *(["--force"] if out.exists() else [])], capture_output=True, text=True)
    if called.returncode:
        print(f"{path.name}: refused: {called.stderr.splitlines()[0].split(': ', 2)[-1]}")
        return True
    facts = json.loads(called.stdout)["provenance"]
    stored = tifffile.imread(out).astype(float)
    ours = levelled(stored)
    single = np.abs(stored).max() * 2.0**-23
    span = np.ptp(ours)
    step = span / 2**16 if "16" in facts["sample_format"] else 0.0
    best = (np.inf, "none", np.inf)
    for name, heights, pitch in theirs(path):
        if heights.shape != ours.shape or not np.isfinite(heights).all():
            continue
        apart = np.abs(levelled(heights) - ours).max()
        of_pitch = max(abs(a / b - 1) for a, b in zip(pitch, facts["pitch_nm"]))
        best = min(best, (apart, name, of_pitch))
    apart, name, of_pitch = best
    good = apart <= max(TOLERANCE * span, 0.5 * step, single) and of_pitch < 1e-6
    print(f"{path.name}: {facts['format']}, {facts.get('channel')} (theirs: {name}): {apart:.2g} nm apart in a range of {span:.4g} nm, pitch {of_pitch:.1e}{'' if good else ' FAILED'}")
    return good


def main():
    program, *files = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        good = [check(program, Path(file), folder) for file in files]
    sys.exit(0 if all(good) and files else 1)


main()
