"""Tables of X, Y, Z: what FORMAT.md calls diffuse, cross and lobe."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ._images import AtlasError, Layers, chebyshev, normalised_abs_w, read_image, stencil
from ._optics import Optics, Vector, factors, image_radius2

#: How far `t` may leave the range of restricted tables, as a share of it.
RANGE_SLACK = 0.02


class Lobe:
    """The coherent lobe and its cross term."""

    def __init__(self, folder: Path, stored: dict):
        self.radius_max = float(stored["radius_max"])
        self.coherent = Layers([read_image(folder, stored["coherent"])])
        cross = stored["cross"]
        self.cross = Layers([read_image(folder, entry) for entry in cross["patches"]]) if cross else None

    def coherent_at(self, radius: NDArray, w: NDArray, lookup: str) -> NDArray:
        """(position, 3): the table at a radius, 0 from `radius_max` on."""
        value = np.zeros((len(radius), 3), radius.dtype)
        (inside,) = np.nonzero(radius < self.radius_max)
        if len(inside):
            radius, w = radius[inside], w[inside]
            t = normalised_abs_w(radius * radius, w)
            column = radius * ((self.coherent.columns - 1) / self.radius_max)
            value[inside] = self.coherent.look_up(None, column, t * (self.coherent.rows - 1), lookup)
        return value

    def cross_at(self, u: NDArray, v: NDArray, w: NDArray, t: NDArray, lookup: str) -> NDArray:
        """(position, 3): the cross term, over `|w|`."""
        value = np.zeros((len(u), 3), u.dtype)
        (inside,) = np.nonzero(np.maximum(np.abs(u), np.abs(v)) < self.radius_max)
        if len(inside):
            u, v, r = u[inside], v[inside], self.radius_max
            half = (self.cross.columns - 1) / (2 * r)
            basis = chebyshev(t[inside], self.cross.count)
            patches = self.cross.look_up(basis, (u + r) * half, (r - v) * half, lookup)
            value[inside] = patches / w[inside, None]
        return value


class SpectralAlone:
    """Stands where an atlas of spectral tables alone has no tables of X, Y, Z."""

    def __init__(self, folder: Path):
        self._folder = folder

    def __getattr__(self, name: str):
        raise AtlasError(
            f"{self._folder} holds spectral tables alone, which `eval`, `eval_wavelengths` and `xyz_under` answer from; means of X, Y, Z and samples take "
            'tables of X, Y, Z: run the pipeline with "xyz" in tables.hold'
        )


class Tables:
    """The tables of a specimen."""

    def __init__(self, folder: Path, stored: dict, optics: Optics):
        self.optics = optics
        self.basis = stored["basis"]
        if self.basis not in ("chebyshev", "taylor"):
            raise AtlasError(f'{folder / "specimen.json"} names the basis "{self.basis}", which this version does not know')
        self.u, self.v = stored["u"], stored["v"]
        served = stored.get("served")
        self.layers = Layers([read_image(folder, entry) for entry in stored["tables"]], whole=not served)
        if (self.layers.columns, self.layers.rows) != (self.u["samples"], self.v["samples"]):
            raise AtlasError(f"{folder}: the tables' images are not of the size that specimen.json states")
        self.range = Layers([read_image(folder, served["range"])]) if served else None
        #: Texels a side of the whole grid over [-2, 2], and column and row at which the tables begin in it.
        self.size = served["size"] if served else self.layers.columns
        self.first = (served["first"][1], served["first"][0]) if served else (0, 0)
        self.lobe = Lobe(folder, stored["lobe"]) if stored["lobe"] else None

    def position(self, u: NDArray, v: NDArray) -> tuple[NDArray, NDArray]:
        """Column and row in texels."""
        scale = (self.size - 1) / 4
        return (u + 2) * scale - self.first[0], (2 - v) * scale - self.first[1]

    def brdf(self, wi: Vector, wo: Vector, lookup: str) -> NDArray:
        """(direction, 3): X, Y, Z in 1/sr; 0 below the surface, NaN where the tables have no answer."""
        above = (wi[2] > 0) & (wo[2] > 0)
        if above.all():
            return self._above(wi, wo, lookup)
        value = np.zeros((len(above), 3), wi[0].dtype)
        if above.any():
            value[above] = self._above(tuple(d[above] for d in wi), tuple(d[above] for d in wo), lookup)
        return value

    def _above(self, wi: Vector, wo: Vector, lookup: str) -> NDArray:
        diffuse_factor, coherent_factor = factors(self.optics, wi, wo)
        u, v, w = -(wi[0] + wo[0]), -(wi[1] + wo[1]), wi[2] + wo[2]
        value = self.diffuse(u, v, w, lookup)
        if self.lobe is None:
            return diffuse_factor[:, None] * value
        if self.lobe.cross is not None:
            value += self.lobe.cross_at(u, v, w, normalised_abs_w(u * u + v * v, w), lookup)
        value *= diffuse_factor[:, None]
        value += coherent_factor[:, None] * self.coherent(wi, wo, u, v, w, lookup)
        return value

    def coherent(self, wi: Vector, wo: Vector, u: NDArray, v: NDArray, w: NDArray, lookup: str) -> NDArray:
        """The lobe, with its image in the horizon where the factor is the vector one."""
        value = self.lobe.coherent_at(np.sqrt(u * u + v * v), w, lookup)
        if self.optics.vector:
            value += self.lobe.coherent_at(np.sqrt(image_radius2(wi, wo)), w, lookup)
        return value

    def diffuse(self, u: NDArray, v: NDArray, w: NDArray, lookup: str) -> NDArray:
        """(position, 3): the tables, without any factor."""
        column, row = self.position(u, v)
        if self.basis == "taylor":
            powers = w[:, None] ** np.arange(-2, self.layers.count - 2, dtype=w.dtype)
            return self.layers.look_up(powers, column, row, lookup)
        t = normalised_abs_w(u * u + v * v, w)
        if self.range is None:
            return self.layers.look_up(chebyshev(t, self.layers.count), column, row, lookup)
        share, answered = self.share_of_range(t, column, row, lookup)
        value = self.layers.look_up(chebyshev(share, self.layers.count), column, row, lookup)
        value[~answered] = np.nan
        return value

    def share_of_range(self, t: NDArray, column: NDArray, row: NDArray, lookup: str) -> tuple[NDArray, NDArray]:
        """Where `t` lies in what the texels are made for, 0 to 1, and whether the tables answer there."""
        inside = (column >= 0) & (column <= self.range.columns - 1) & (row >= 0) & (row <= self.range.rows - 1)
        low, high, _ = self.range.look_up(None, column, row, lookup).T
        # Every texel that counts has to be covered.
        answered = inside & self._covered(column, row, lookup)
        answered &= high > low
        share = np.where(answered, (t - low) / np.where(answered, high - low, 1), 0)
        answered &= (share >= -RANGE_SLACK) & (share <= 1 + RANGE_SLACK)
        return np.clip(share, 0, 1), answered

    def _covered(self, column: NDArray, row: NDArray, lookup: str) -> NDArray:
        first_column, across = stencil(column, self.range.columns, lookup)
        first_row, down = stencil(row, self.range.rows, lookup)
        there = self.range.texels[:, 2]
        covered = np.ones(len(column), bool)
        for dy, weight_y in enumerate(down):
            for dx, weight_x in enumerate(across):
                texel = there[(first_row + dy) * self.range.columns + first_column + dx]
                covered &= (texel != 0) | (weight_x == 0) | (weight_y == 0)
        return covered
