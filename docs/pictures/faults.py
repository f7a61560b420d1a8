"""Draws what each fault of a scan looks like: heights on the left, the light that they send back on the right, for docs/scans.md.

    python3 docs/pictures/faults.py     # wants numpy and tifffile; writes docs/pictures/faults/*.png

The surface is the bundled specimens/corn_snake_like.tif; each fault is made here. Light: |FFT(window exp(2 i k h))|² at 550 nm from straight above, which is
the transform that docs/optics.md describes, on a scale of six decades; one picture's edge is |(u, v)| = 1.
"""

import struct
import zlib
from pathlib import Path

import numpy as np
import tifffile

ROOT = Path(__file__).resolve().parents[2]
OUT = Path(__file__).resolve().parent / "faults"
PITCH_NM = 62.5
SIDE = 256  # samples
SHOWN = 128  # pixels a side
WAVELENGTH_NM = 550.0
SIGMA_NM = 3000.0
DECADES = 6.0


def clean():
    """A part of the bundled scan, about its mean."""
    heights = tifffile.imread(ROOT / "specimens/corn_snake_like.tif").astype(float)[:SIDE, :SIDE]
    return heights - heights.mean()


def faults():
    """Names and heights in nm."""
    random = np.random.default_rng(16)
    good = clean()
    rows, columns = np.mgrid[0:SIDE, 0:SIDE]
    x, y = columns / SIDE - 0.5, rows / SIDE - 0.5
    yield "clean", good
    yield "stopped", np.where(rows < SIDE // 2, good, 0.0)
    lost = good.copy()
    lost[[60, 61, 150]] = lost[59]
    yield "lost_lines", lost
    mark = good.copy()
    mark[90:96, 120:126] = -9999.0
    yield "mark", mark
    yield "cut_off", np.minimum(good, np.quantile(good, 0.6))
    dust = good.copy()
    for row, column in [(60, 60), (140, 190), (200, 90)]:
        dust[row : row + 7, column : column + 7] += 900.0
    yield "dust", dust
    yield "tilt", good + 3000.0 * x
    yield "bow", good + 1200.0 * (x * x + y * y)
    yield "line_offsets", good + random.normal(0.0, 20.0, SIDE)[:, None]
    scars = good.copy()
    for row in random.choice(np.arange(4, SIDE - 4, 3), 14, replace=False):
        start = random.integers(0, SIDE - 60)
        scars[row, start : start + 50] += 60.0
    yield "scars", scars
    yield "step", good + 50.0 * (columns >= SIDE // 2)
    yield "hum", good + 20.0 * np.cos(2 * np.pi * (3.0 * columns / SIDE + rows / 2.7))


def light(heights):
    """Power over directions to the viewer, in decades below the highest."""
    axis = (np.arange(SIDE) - 0.5 * (SIDE - 1)) * PITCH_NM
    window = np.exp(-0.5 * (axis / SIGMA_NM) ** 2)
    field = window[:, None] * window[None, :] * np.exp(4j * np.pi / WAVELENGTH_NM * heights)
    padded = 1024
    power = np.abs(np.fft.fftshift(np.fft.fft2(field, (padded, padded)))) ** 2
    # u = λ f: |u| = 1 is f = 1/λ.
    reach = int(round(padded * PITCH_NM / WAVELENGTH_NM))
    middle = padded // 2
    power = power[middle - reach : middle + reach, middle - reach : middle + reach]
    index = ((np.arange(SHOWN) + 0.5) * len(power) / SHOWN).astype(int)
    return np.log10(power[np.ix_(index, index)] / power.max() + 1e-30)


def grey(values, low, high):
    """Values as bytes between two ends, in 32 steps, which take half the room of 256."""
    return (np.clip((values - low) / (high - low) * 32.0, 0, 31).astype(np.uint8)) * 8


def write_png(path, pixels):
    """An 8-bit grey picture."""
    def chunk(name, content):
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))

    height, width = pixels.shape
    lines = b"".join(b"\0" + line.tobytes() for line in pixels)
    header = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines, 9)) + chunk(b"IEND", b""))


def main():
    OUT.mkdir(exist_ok=True)
    for name, heights in faults():
        middle = np.sort(heights.ravel())[[len(heights.ravel()) // 200, -len(heights.ravel()) // 200]]
        step = SIDE // SHOWN
        # The brighter of each two rows stays to be seen: lines are one sample wide.
        shown = heights.reshape(SHOWN, step, SHOWN, step)[:, :, :, 0].max(axis=1)
        gap = np.full((SHOWN, 4), 255, np.uint8)
        write_png(OUT / f"{name}.png", np.hstack([grey(shown, *middle), gap, grey(light(heights), -DECADES, 0.0)]))


main()
