"""Parameters of ISO 25178-2 of four scans, by surfalize from PyPI, against what `inspect --json` says.

    python3 -m venv venv && venv/bin/pip install surfalize tifffile
    venv/bin/python tests/surface_parameters.py PROGRAM SCAN PITCH_NM [SCAN PITCH_NM]...

PROGRAM is the binary; the scans are TIFFs of heights in nm. Fails where a height or hybrid parameter differs by more than 1e-6, which is the
single precision of heights that were stored so; autocorrelation lengths are printed side by side, since that program weighs lags otherwise.
"""

import json
import subprocess
import sys

import numpy as np
import tifffile
from surfalize import Surface

TOLERANCE = 1e-6
# A skewness of symmetric heights is rounding.
SMALLEST = 1e-6
EXACT = {"Sa": "sa_nm", "Sq": "sq_nm", "Ssk": "ssk", "Sku": "sku", "Sz": "sz_nm", "Sdq": "sdq", "Sdr": "sdr"}
SCALE = {"Sa": 1e3, "Sq": 1e3, "Sz": 1e3, "Sdr": 1e-2}  # from um and percent


def levelled(heights):
    """Heights about their best plane."""
    rows, columns = np.indices(heights.shape)
    terms = np.stack([np.ones(heights.size), rows.ravel(), columns.ravel()], axis=1)
    plane = terms @ np.linalg.lstsq(terms, heights.ravel(), rcond=None)[0]
    return heights - plane.reshape(heights.shape)


def check(program, scan, pitch_nm):
    """Whether all parameters of one scan agree."""
    command = [program, "inspect", scan, "--pitch-nm", pitch_nm, "--unit", "nm", "--json"]
    ours = json.loads(subprocess.run(command, check=True, capture_output=True).stdout)["statistics"]["surface"]
    heights = levelled(tifffile.imread(scan).astype(float))
    theirs = Surface(heights / 1e3, float(pitch_nm) / 1e3, float(pitch_nm) / 1e3)
    good = True
    for name, key in EXACT.items():
        expected = float(getattr(theirs, name)()) * SCALE.get(name, 1.0)
        off = abs(ours[key] - expected) / max(abs(expected), SMALLEST)
        good &= off < TOLERANCE
        print(f"{scan} {name}: {ours[key]:.9g}, surfalize {expected:.9g}, off by {off:.1e}")
    print(f"{scan} Sal: {ours['sal_nm']} nm, surfalize {theirs.Sal() * 1e3} nm; Str: {ours['str_ratio']}, {theirs.Str()}")
    return good


if __name__ == "__main__":
    pairs = list(zip(sys.argv[2::2], sys.argv[3::2]))
    sys.exit(not all([check(sys.argv[1], scan, pitch) for scan, pitch in pairs]))
