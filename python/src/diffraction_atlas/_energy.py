"""The limit that keeps a surface from reflecting more than arrives."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from ._images import AtlasError


class EnergyLimit:
    """`energy_limit` of specimen.json: the largest directional albedo over azimuths, by the cosine of the polar angle."""

    def __init__(self, stored: dict):
        self.cos_theta, self.albedo = (np.asarray(stored[key], float) for key in ("cos_theta", "albedo"))
        ascending = len(self.cos_theta) > 0 and np.all(np.diff(self.cos_theta) > 0) and self.cos_theta[0] > 0
        if not ascending or self.cos_theta.shape != self.albedo.shape:
            raise AtlasError("an energy limit must hold ascending cosines above 0 and as many albedos")
        self._product = self.cos_theta * self.albedo

    def albedo_at(self, cos_theta: NDArray) -> NDArray:
        """At cosines above 0: `albedo cos_theta` is linear between the nodes, and constant beyond them."""
        return np.interp(cos_theta, self.cos_theta, self._product) / cos_theta

    def factor(self, z_i: NDArray, z_o: NDArray) -> NDArray:
        """What the BRDF is multiplied by; 1 for directions that are not above the surface."""
        above = (z_i > 0) & (z_o > 0)
        one = z_i.dtype.type(1)
        largest = np.maximum(self.albedo_at(np.where(above, z_i, one)), self.albedo_at(np.where(above, z_o, one)))
        return np.where(above, 1 / np.maximum(largest, 1), 1).astype(z_i.dtype)
