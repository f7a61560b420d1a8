#!/usr/bin/env python3
"""Converts the files of tests/data/formats and compares heights, pitch and missing samples with the truth there.

    python3 tools/test_convert.py     # wants SurfaceTopography
"""

import json
import math
import shutil
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
DATA = HERE.parent / "tests" / "data" / "formats"
# One of each reader that the conversion goes through, with its channel, and one with missing samples.
FILES = ["gwyfile.gwy", "nanoscope_16.spm", "asylum_little.ibw", "nanosurf_16.nid", "topography_16.x3p", "wsxm_16.stp"]


def run(*arguments):
    command = [sys.executable, str(HERE / "convert.py"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True)


def parsed(path):
    """Rows in nm and pitch in nm of a simple field."""
    data = path.read_bytes()
    end = data.index(b"\0")
    entries = dict(line.split(" = ", 1) for line in data[:end].decode().splitlines()[1:])
    nx, ny = int(entries["XRes"]), int(entries["YRes"])
    values = struct.unpack(f"<{nx * ny}f", data[(end // 4 + 1) * 4:])
    assert (entries["XYUnits"], entries["ZUnits"]) == ("m", "m"), entries
    rows = [[1e9 * value for value in values[nx * y:nx * (y + 1)]] for y in range(ny)]
    return rows, (1e9 * float(entries["XReal"]) / nx, 1e9 * float(entries["YReal"]) / ny)


def worst(rows, truth):
    """Largest difference but for a constant."""
    differences = [a - b for row, true in zip(rows, truth) for a, b in zip(row, true) if not math.isnan(a)]
    mean = sum(differences) / len(differences)
    return max(abs(difference - mean) for difference in differences)


def check(target, facts, truth):
    """One converted file against the surface it shows."""
    name, heights = facts["file"], truth["heights_nm"]
    rows, pitch = parsed(target)
    # The file's own rounding, in their reader and in ours; 32-bit floats of metres besides.
    tolerance = 2.0 * facts["tolerance_nm"] + 1e-4
    assert worst(rows, heights) <= tolerance, (name, worst(rows, heights))
    # The comparison can fail.
    assert worst(rows[::-1], heights) > 1.0 and worst([row[::-1] for row in rows], heights) > 1.0, name
    assert all(abs(found / stated - 1.0) < 1e-6 for found, stated in zip(pitch, truth["pitch_nm"])), (name, pitch)
    missing = [[y, x] for y, row in enumerate(rows) for x, value in enumerate(row) if math.isnan(value)]
    assert missing == (sorted(truth["missing"]) if facts["missing"] else []), (name, missing)


def main():
    truth = json.loads((DATA / "truth.json").read_text())
    facts = {row["file"]: row for row in truth["files"]}
    with tempfile.TemporaryDirectory() as place:
        scans, out = Path(place) / "scans", Path(place) / "out"
        (scans / "below").mkdir(parents=True)
        for name in FILES:
            shutil.copy(DATA / name, scans / "below" / name if name.endswith(".nid") else scans)
        (scans / "notes.doc").write_bytes(b"no scan")
        said = run(scans, "--out", out)
        assert said.returncode == 0 and "notes.doc: not converted" in said.stderr, said.stderr
        targets = {name: out / ("below" if name.endswith(".nid") else "") / (Path(name).stem + ".gsf") for name in FILES}
        for name, target in targets.items():
            check(target, facts[name], truth)
        before = {target: target.read_bytes() for target in targets.values()}
        again = run(scans, "--out", out)
        assert again.returncode == 1 and again.stderr.count("is there already") == len(FILES), again.stderr
        assert all(target.read_bytes() == content for target, content in before.items()) and not list(out.rglob("*.part"))
        said = run(DATA / "nanosurf_16.nid", "--list")
        assert "Z-Axis" in said.stdout, said.stdout
    print(f"{len(FILES)} files converted to their truth, and none overwritten")


if __name__ == "__main__":
    main()
