"""How far (u, v) reach for a light with a size and for a pixel of a curved surface."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._directions import as_directions


class Footprint:
    """The (u, v) that one look-up stands for: covariances around the centre's, without unit.

    It stands for the ellipse that has this covariance when evenly filled: semi-axes of twice the standard deviations. `uu`, `uv` and
    `vv` have any shapes that go together, and go together with the directions. Footprints add.
    """

    def __init__(self, uu: ArrayLike = 0.0, uv: ArrayLike = 0.0, vv: ArrayLike = 0.0):
        self.uu, self.uv, self.vv = np.broadcast_arrays(*(np.asarray(part, float) for part in (uu, uv, vv)))
        # A covariance of rank one is rounded to either side of zero.
        fine = (self.uu >= 0) & (self.vv >= 0) & (self.uv**2 <= self.uu * self.vv * (1 + 1e-9)) & np.isfinite(self.uu + self.vv)
        if not np.all(fine):
            raise ValueError("a footprint must be a covariance: variances that are not negative, and uv^2 not above uu vv")

    @classmethod
    def of_light(cls, wi: ArrayLike, angular_diameter_deg: ArrayLike) -> Footprint:
        """Of a round light, even over its disc of a diameter in degrees, around `wi` of shape (..., 3)."""
        diameter = np.asarray(angular_diameter_deg, float)
        if not np.all((diameter >= 0) & (diameter <= 180)):
            raise ValueError(f"a light's angular diameter lies between 0 and 180 degrees, not at {angular_diameter_deg}")
        wi = as_directions("wi", wi).astype(float)
        # In single precision a grazing direction may be longer than 1.
        x, y, _ = np.moveaxis(wi / np.linalg.norm(wi, axis=-1, keepdims=True), -1, 0)
        # Seen along the normal the disc is an ellipse: sin(radius) across the plane of incidence, times the cosine along it.
        variance = 0.25 * np.sin(np.radians(diameter) / 2) ** 2
        return cls(variance * (1 - x * x), -variance * x * y, variance * (1 - y * y))

    @classmethod
    def of_normals(cls, wi: ArrayLike, wo: ArrayLike, covariance: ArrayLike) -> Footprint:
        """Of a pixel over which the normal is tilted by (a, b) along x and y in radians with the covariance (aa, ab, bb)."""
        w2 = (np.asarray(wi, float)[..., 2] + np.asarray(wo, float)[..., 2]) ** 2
        aa, ab, bb = np.moveaxis(np.asarray(covariance, float), -1, 0)
        return cls(w2 * aa, w2 * ab, w2 * bb)

    def __add__(self, other: Footprint) -> Footprint:
        return Footprint(self.uu + other.uu, self.uv + other.uv, self.vv + other.vv)

    def stacked(self) -> NDArray[np.float64]:
        """(..., 3): uu, uv, vv."""
        return np.stack([self.uu, self.uv, self.vv], axis=-1)


class Axes(NamedTuple):
    """Variances along the axes of ellipses, the larger first, and the unit vector (x, y) of the first axis."""

    major: NDArray
    minor: NDArray
    x: NDArray
    y: NDArray

    def covariance(self) -> tuple[NDArray, NDArray, NDArray]:
        """uu, uv, vv."""
        x, y, along, across = self.x, self.y, self.major, self.minor
        return along * x * x + across * y * y, (along - across) * x * y, along * y * y + across * x * x


def axes_of(uu: NDArray, uv: NDArray, vv: NDArray) -> Axes:
    """The axes of covariances."""
    mean, half = (uu + vv) / 2, (uu - vv) / 2
    spread, angle = np.hypot(half, uv), np.arctan2(uv, half) / 2
    return Axes(mean + spread, np.maximum(mean - spread, 0), np.cos(angle), np.sin(angle))
