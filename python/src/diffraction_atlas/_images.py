"""Images of an atlas: read with the OpenEXR package, and looked up between texels."""

from __future__ import annotations

from pathlib import Path
from typing import Sequence

import numpy as np
import OpenEXR
from numpy.typing import NDArray


class AtlasError(ValueError):
    """A file of an atlas is missing, damaged or of another version; the message says which and what to do."""


def read_image(folder: Path, entry: dict) -> NDArray[np.float32]:
    """Values [row, column, 3] in 1/sr of a file named in specimen.json, its scale applied."""
    path = folder / entry["file"]
    try:
        with OpenEXR.File(str(path), separate_channels=True) as file:
            channels = file.channels()
            missing = [name for name in "RGB" if name not in channels]
            if missing:
                raise AtlasError(f"{path} has no channel {' and no channel '.join(missing)}; restore it, or make the atlas anew")
            image = np.stack([np.asarray(channels[name].pixels, np.float32) for name in "RGB"], axis=-1)
    except AtlasError:
        raise
    except Exception as error:
        raise AtlasError(f"{path} cannot be read: {error}. Restore it, or run the pipeline again") from error
    # A power of two: the product is exact.
    image *= np.float32(entry["scale"])
    if not np.isfinite(image).all():
        raise AtlasError(f"{path} holds values that are not finite; restore it, or run the pipeline again")
    return image


class Layers:
    """Images of one size, texel by texel: what a look-up reads lies together in memory."""

    def __init__(self, images: Sequence[NDArray], whole: bool = False):
        """From images of shape [row, column, channel]; `whole` where they cover the square [-2, 2] of (u, v), which splines are for."""
        self.rows, self.columns, self.channels = images[0].shape
        self.count = len(images)
        if any(image.shape != images[0].shape for image in images) or min(self.rows, self.columns) < 2:
            raise AtlasError("images of one stack must have one size of at least 2 x 2 texels")
        self.whole = whole
        self._splines: NDArray | None = None
        #: [texel, channel times layer]: the layers of a channel are neighbours.
        self.texels = np.ascontiguousarray(np.stack(images, axis=-1).reshape(self.rows * self.columns, -1))

    def image(self, layer: int) -> NDArray[np.float32]:
        """One of the images, [row, column, channel]."""
        return self.texels.reshape(self.rows, self.columns, self.channels, self.count)[..., layer]

    def splines(self) -> NDArray[np.float64]:
        """Coefficients of the cubic B-splines through whole images, laid out as the texels; made once."""
        if self._splines is None:
            image = self.texels.reshape(self.rows, self.columns, -1)
            self._splines = coefficients(image).reshape(self.rows * self.columns, -1)
        return self._splines

    def look_up(self, basis: NDArray, column: NDArray, row: NDArray, lookup: str = "linear") -> NDArray:
        """Sum over n of `basis[:, n]` times layer n at positions in texels: shape (position, channel)."""
        by_splines = lookup == "spline" and self.whole
        source = self.splines() if by_splines else self.texels
        along = spline_stencil if by_splines else lambda at, count: stencil(at, count, lookup)
        first_column, across = along(column, self.columns)
        first_row, down = along(row, self.rows)
        corner = first_row * self.columns + first_column
        dtype = np.result_type(column, np.float32)
        texels = np.empty((len(corner), source.shape[1]), source.dtype)
        product = texels if dtype == source.dtype else np.empty(texels.shape, np.result_type(dtype, source.dtype))
        total = np.zeros(texels.shape, dtype)
        for dy, weight_y in enumerate(down):
            for dx, weight_x in enumerate(across):
                # Into one buffer; `mode` spares a check of every index, which the stencil keeps in range.
                source.take(corner + (dy * self.columns + dx), axis=0, out=texels, mode="clip")
                np.multiply(texels, (weight_x * weight_y)[:, None], out=product)
                total += product
        if self.count == 1 and basis is None:
            return total
        return np.einsum("pck,pk->pc", total.reshape(-1, self.channels, self.count), basis)


def stencil(at: NDArray, count: int, lookup: str) -> tuple[NDArray, tuple[NDArray, ...]]:
    """First texel, and weights of it and those after it, at positions in texels along an axis of `count` of them."""
    at = np.clip(at, 0, count - 1)
    if lookup == "linear" or count < 4:
        first = np.minimum(at.astype(np.intp), count - 2)
        x = at - first.astype(at.dtype)
        return first, (1 - x, x)
    first = np.clip(at.astype(np.intp) - 1, 0, count - 4)
    x = at - first.astype(at.dtype)
    # Lagrange's cubic through the nodes 0, 1, 2, 3.
    a, b, c = x - 1, x - 2, x - 3
    return first, (-a * b * c / 6, x * b * c / 2, -x * a * c / 2, x * a * b / 6)


#: The pole of the filter that turns values into a spline's coefficients, and from how many of them it starts.
POLE, START = np.sqrt(3) - 2, 57
#: Texels beyond the rim of the disc from which on values are held: tables are zero beyond three, and the step must not ring.
HELD_TEXELS = 2


def coefficients(image: NDArray) -> NDArray[np.float64]:
    """Coefficients of the cubic B-splines through a square image [row, column, channel], as FORMAT.md tells."""
    size = len(image)
    middle = (size - 1) / 2
    x, y = np.meshgrid(np.arange(size) - middle, np.arange(size) - middle)
    radius = np.maximum(np.hypot(x, y), 1)
    # Halves away from zero, as the program rounds.
    held = lambda at: np.where(radius > middle + HELD_TEXELS, at * (middle + HELD_TEXELS) / radius, at)
    column, row = (np.clip(np.floor(middle + held(at) + 0.5).astype(np.intp), 0, size - 1) for at in (x, y))
    found = image[row, column].astype(float)
    return _filtered(_filtered(found).swapaxes(0, 1)).swapaxes(0, 1)


def _filtered(lines: NDArray) -> NDArray:
    """Along the first axis, which goes on mirrored at its ends."""
    last = len(lines) - 1
    mirrored = np.arange(START) % (2 * last)
    mirrored = np.minimum(mirrored, 2 * last - mirrored)
    lines[0] = np.tensordot(POLE ** np.arange(START), lines[mirrored], axes=1)
    for k in range(1, last + 1):
        lines[k] += POLE * lines[k - 1]
    lines[last] = POLE / (POLE * POLE - 1) * (lines[last] + POLE * lines[last - 1])
    for k in range(last - 1, -1, -1):
        lines[k] = POLE * (lines[k + 1] - lines[k])
    lines *= 6
    return lines


def spline_stencil(at: NDArray, count: int) -> tuple[NDArray, tuple[NDArray, ...]]:
    """First of four coefficients, and their weights, at positions along an axis of `count`; mirrored at its ends."""
    at = np.clip(at, 0, count - 1)
    whole = at.astype(np.intp)
    f = at - whole.astype(at.dtype)
    g = 1 - f
    weights = [g**3 / 6, 2 / 3 - f * f + f**3 / 2, 2 / 3 - g * g + g**3 / 2, f**3 / 6]
    if count < 5:
        raise AtlasError("splines need images of at least five texels a side")
    first = np.clip(whole - 1, 0, count - 4)
    out = [np.zeros_like(f) for _ in range(4)]
    for k, weight in enumerate(weights):
        index = np.abs(whole - 1 + k)
        index = np.minimum(index, 2 * (count - 1) - index) - first
        for slot in range(4):
            out[slot] += np.where(index == slot, weight, 0)
    return first, tuple(out)


def chebyshev(t: NDArray, count: int) -> NDArray:
    """`T_0(2 t - 1)` to `T_(count - 1)(2 t - 1)`, along a new last axis."""
    values = np.empty(t.shape + (count,), t.dtype)
    x = 2 * t - 1
    values[..., 0] = 1
    if count > 1:
        values[..., 1] = x
    for n in range(2, count):
        values[..., n] = 2 * x * values[..., n - 1] - values[..., n - 2]
    return values


def normalised_abs_w(radius2: NDArray, w: NDArray) -> NDArray:
    """`t = |w| / sqrt(4 - u^2 - v^2)`, at most 1, and 0 where the root is 0."""
    room = 4 - radius2
    reach = np.sqrt(np.maximum(room, 0))
    return np.where(room > 0, np.minimum(w / np.where(room > 0, reach, 1), 1), 0)
