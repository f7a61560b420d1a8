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

    def __init__(self, images: Sequence[NDArray[np.float32]]):
        """From images of shape [row, column, channel]."""
        self.rows, self.columns, self.channels = images[0].shape
        self.count = len(images)
        if any(image.shape != images[0].shape for image in images) or min(self.rows, self.columns) < 2:
            raise AtlasError("images of one stack must have one size of at least 2 x 2 texels")
        #: [texel, channel times layer]: the layers of a channel are neighbours.
        self.texels = np.ascontiguousarray(np.stack(images, axis=-1).reshape(self.rows * self.columns, -1))

    def image(self, layer: int) -> NDArray[np.float32]:
        """One of the images, [row, column, channel]."""
        return self.texels.reshape(self.rows, self.columns, self.channels, self.count)[..., layer]

    def look_up(self, basis: NDArray, column: NDArray, row: NDArray, cubic: bool = False) -> NDArray:
        """Sum over n of `basis[:, n]` times layer n at positions in texels: shape (position, channel)."""
        first_column, across = stencil(column, self.columns, cubic)
        first_row, down = stencil(row, self.rows, cubic)
        corner = first_row * self.columns + first_column
        dtype = np.result_type(column, np.float32)
        texels = np.empty((len(corner), self.texels.shape[1]), np.float32)
        product = texels if dtype == np.float32 else np.empty(texels.shape, dtype)
        total = np.zeros(texels.shape, dtype)
        for dy, weight_y in enumerate(down):
            for dx, weight_x in enumerate(across):
                # Into one buffer; `mode` spares a check of every index, which the stencil keeps in range.
                self.texels.take(corner + (dy * self.columns + dx), axis=0, out=texels, mode="clip")
                np.multiply(texels, (weight_x * weight_y)[:, None], out=product)
                total += product
        if self.count == 1 and basis is None:
            return total
        return np.einsum("pck,pk->pc", total.reshape(-1, self.channels, self.count), basis)


def stencil(at: NDArray, count: int, cubic: bool) -> tuple[NDArray, tuple[NDArray, ...]]:
    """First texel, and weights of it and those after it, at positions in texels along an axis of `count` of them."""
    at = np.clip(at, 0, count - 1)
    if not cubic or count < 4:
        first = np.minimum(at.astype(np.intp), count - 2)
        x = at - first.astype(at.dtype)
        return first, (1 - x, x)
    first = np.clip(at.astype(np.intp) - 1, 0, count - 4)
    x = at - first.astype(at.dtype)
    # Lagrange's cubic through the nodes 0, 1, 2, 3.
    a, b, c = x - 1, x - 2, x - 3
    return first, (-a * b * c / 6, x * b * c / 2, -x * a * c / 2, x * a * b / 6)


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
