"""From X, Y, Z to what a display shows."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Linear sRGB (D65) from X, Y, Z.
SRGB_FROM_XYZ = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)
_LUMINANCE = np.array([0.2126729, 0.7151522, 0.0721750])


def to_linear_srgb(xyz: ArrayLike) -> NDArray:
    """Linear sRGB of X, Y, Z of shape (..., 3). Colours outside sRGB have negative channels: sum over lights before anything else."""
    xyz = np.asarray(xyz)
    return xyz @ SRGB_FROM_XYZ.T.astype(xyz.dtype if xyz.dtype == np.float32 else float)


def to_srgb(xyz: ArrayLike, exposure: float = 1.0) -> NDArray[np.float64]:
    """sRGB in [0, 1], encoded for a display or an image file, of X, Y, Z of shape (..., 3).

    `exposure` is the factor that brings the luminance wanted for white to 1. Colours that sRGB does not hold lose saturation at
    constant luminance, as far as they must; what is brighter than white is cut off. NaN, which says that tables have no answer, comes out as magenta.
    """
    xyz = np.asarray(xyz, float)
    known = np.isfinite(xyz).all(axis=-1, keepdims=True)
    rgb = exposure * to_linear_srgb(np.where(known, xyz, 0.0))
    luminance = np.maximum(rgb @ _LUMINANCE, 0)[..., None]
    # From grey towards the colour, as far as no channel is negative.
    below = np.minimum(rgb.min(axis=-1, keepdims=True), 0)
    share = luminance / np.where(below < 0, luminance - below, 1)
    rgb = np.where(below < 0, luminance + share * (rgb - luminance), rgb)
    rgb = np.clip(rgb, 0, 1)
    encoded = np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * np.maximum(rgb, 0.0031308) ** (1 / 2.4) - 0.055)
    return np.where(known, encoded, (1.0, 0.0, 1.0))
