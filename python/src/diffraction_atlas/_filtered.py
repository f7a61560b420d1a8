"""Filtered look-ups: means of the BRDF over all that a light's disc or a pixel's footprint reaches.

A light that is even over a disc of directions moves (u, v) evenly over an ellipse. Factors and `t` vary slowly there and are the
centre's; tables and lobe do not, and are averaged.
"""

from __future__ import annotations

from typing import Callable

import numpy as np
from numpy.typing import NDArray

from ._footprint import Axes, axes_of
from ._images import chebyshev, normalised_abs_w, stencil
from ._means import LobeEllipses, Pyramid
from ._optics import Vector, factors
from ._spectral import SpectralTables
from ._tables import Tables

#: Rings and points per ring at which tables are looked up that are not averaged texel by texel.
RINGS, POINTS_PER_RING = 4, 16
#: Semi-axis in texels up to which seven points do.
SEVEN_POINTS_MAX = 1.5
#: Semi-axis in texels from which cubic look-ups give way to linear ones, until twice that.
CUBIC_MAX = 4.0

Covariance = tuple[NDArray, NDArray, NDArray]


class FilteredTables:
    """Tables of X, Y, Z with their coarser copies."""

    def __init__(self, tables: Tables):
        self.tables = tables
        # Each texel of restricted tables has a range of its own: they have no means.
        self.pyramid = None if tables.range is not None else Pyramid(tables.layers)
        cross = tables.lobe.cross if tables.lobe else None
        self.cross_pyramid = Pyramid(cross) if cross is not None else None

    def brdf(self, wi: Vector, wo: Vector, covariance: NDArray, lookup: str) -> NDArray:
        """(direction, 3): X, Y, Z in 1/sr; `covariance` has the shape (direction, 3)."""
        value = np.zeros((len(wi[0]), 3), wi[0].dtype)
        (above,) = np.nonzero((wi[2] > 0) & (wo[2] > 0))
        if len(above):
            wi, wo = (tuple(d[above].astype(float) for d in direction) for direction in (wi, wo))
            value[above] = self._above(wi, wo, tuple(covariance[above].T), lookup)
        return value

    def _above(self, wi: Vector, wo: Vector, covariance: Covariance, lookup: str) -> NDArray:
        tables, lobe = self.tables, self.tables.lobe
        diffuse_factor, coherent_factor = factors(tables.optics, wi, wo)
        u, v, w = -(wi[0] + wo[0]), -(wi[1] + wo[1]), wi[2] + wo[2]
        axes = axes_of(*covariance)
        value = self._diffuse(u, v, w, axes, lookup)
        if lobe is None:
            return diffuse_factor[:, None] * value
        if lobe.cross is not None:
            value += cross_mean(
                self.cross_pyramid, lobe.radius_max, u, v, w, axes, lookup,
                lambda u, v, w: lobe.cross_at(u, v, w, normalised_abs_w(u * u + v * v, w), lookup),
            )
        coherent = self._lobe_mean(LobeEllipses.direct(u, v, axes), w, lookup)
        if tables.optics.vector:
            coherent += self._lobe_mean(LobeEllipses.image(wi, wo, covariance), w, lookup)
        return diffuse_factor[:, None] * value + coherent_factor[:, None] * coherent

    def _diffuse(self, u: NDArray, v: NDArray, w: NDArray, axes: Axes, lookup: str) -> NDArray:
        tables, per_unit = self.tables, (self.tables.size - 1) / 4
        table = lambda u, v, w: tables.diffuse(u, v, w, lookup)
        by_points = lambda those: mean_of_points(u[those], v[those], w[those], _some(axes, those), per_unit, table)
        if self.pyramid is None:
            return by_points(np.arange(len(u)))

        def by_texels(those: NDArray) -> NDArray:
            x, y, z = u[those], v[those], w[those]
            if tables.basis == "taylor":
                basis = z[:, None] ** np.arange(-2, tables.layers.count - 2, dtype=float)
            else:
                basis = chebyshev(normalised_abs_w(x * x + y * y, z), tables.layers.count)
            at = ((x + 2) * per_unit, (2 - y) * per_unit)
            return self.pyramid.means(basis, at, on_image(_some(axes, those), per_unit), edge=True)

        return as_interpolated(lookup, axes, per_unit, 3, by_points, by_texels)

    def _lobe_mean(self, ellipses: LobeEllipses, w: NDArray, lookup: str) -> NDArray:
        lobe = self.tables.lobe
        image = lobe.coherent.image(0)
        rows, columns, _ = image.shape
        value = np.zeros((len(w), 3))
        (those,) = np.nonzero(ellipses.reach(lobe.radius_max))
        if not len(those):
            return value
        ellipses = ellipses.subset(those)
        radius = ellipses.radius()
        # At the centre's t.
        first, shares = stencil(normalised_abs_w(radius * radius, w[those]) * (rows - 1), rows, lookup)
        profile = sum(share[:, None, None] * image[first + k] for k, share in enumerate(shares))
        position = np.arange(len(those))[:, None]

        def at(radius: NDArray) -> NDArray:
            column, shares = stencil(radius / lobe.radius_max * (columns - 1), columns, lookup)
            return sum(share[..., None] * profile[position, column + k] for k, share in enumerate(shares))

        value[those] = ellipses.mean(lobe.radius_max, at)
        return value


class FilteredSpectral:
    """Spectral tables with their coarser copies."""

    def __init__(self, tables: SpectralTables):
        self.tables = tables
        self.pyramid = Pyramid(tables.layers)
        self.cross_pyramid = Pyramid(tables.cross) if tables.cross is not None else None

    def brdf(self, wi: Vector, wo: Vector, covariance: NDArray, wavelength_nm: NDArray, lookup: str) -> NDArray:
        """(direction, wavelength): the BRDF in 1/sr."""
        value = np.zeros((len(wi[0]), wavelength_nm.shape[-1]), wi[0].dtype)
        (above,) = np.nonzero((wi[2] > 0) & (wo[2] > 0))
        if len(above):
            wi, wo = (tuple(d[above].astype(float) for d in direction) for direction in (wi, wo))
            nm = np.broadcast_to(wavelength_nm, value.shape)[above]
            value[above] = self._above(wi, wo, covariance[above], nm, lookup)
        return value

    def _above(self, wi: Vector, wo: Vector, covariance: NDArray, nm: NDArray, lookup: str) -> NDArray:
        tables, shape = self.tables, nm.shape
        diffuse_factor, coherent_factor = tables.front(wi, wo, nm)
        r = np.minimum(tables.shortest_nm / nm, 1)
        u, v, w = -(wi[0] + wo[0]), -(wi[1] + wo[1]), wi[2] + wo[2]
        scaled = [(r * part[:, None]).ravel() for part in (u, v, w)]
        axes = axes_of(*((r * r * part[:, None]).ravel() for part in covariance.T))
        value = r**4 * diffuse_factor * self._diffuse(*scaled, axes, lookup).reshape(shape)
        if tables.power is not None:
            share, lobe_nm = tables.lobe_at(nm)
            width = lobe_nm / (2 * np.pi * tables.lobe_sigma_nm)
            ellipses = [LobeEllipses.direct(u, v, axes_of(*covariance.T))]
            if tables.optics.vector:
                ellipses.append(LobeEllipses.image(wi, wo, tuple(covariance.T)))
            which = np.repeat(np.arange(shape[0]), shape[1])
            form = sum(of.subset(which).gaussian_mean(width.ravel()) for of in ellipses).reshape(shape)
            value += share * coherent_factor * tables.power_at(scaled[2]).reshape(shape) * form
        return value

    def _diffuse(self, u: NDArray, v: NDArray, w: NDArray, axes: Axes, lookup: str) -> NDArray:
        tables, per_unit = self.tables, (self.tables.size - 1) / 4

        def table(u: NDArray, v: NDArray, w: NDArray) -> NDArray:
            t = normalised_abs_w(u * u + v * v, w)
            return tables.layers.look_up(chebyshev(t, tables.layers.count), (u + 2) * per_unit, (2 - v) * per_unit, lookup)

        def by_points(those: NDArray) -> NDArray:
            return mean_of_points(u[those], v[those], w[those], _some(axes, those), per_unit, table)

        def by_texels(those: NDArray) -> NDArray:
            x, y, z = u[those], v[those], w[those]
            basis = chebyshev(normalised_abs_w(x * x + y * y, z), tables.layers.count)
            at = ((x + 2) * per_unit, (2 - y) * per_unit)
            return self.pyramid.means(basis, at, on_image(_some(axes, those), per_unit), edge=True)

        value = as_interpolated(lookup, axes, per_unit, 1, by_points, by_texels)
        if tables.cross is not None:
            value += cross_mean(
                self.cross_pyramid, tables.cross_radius, u, v, w, axes, lookup,
                lambda u, v, w: tables.cross_at(u, v, w, normalised_abs_w(u * u + v * v, w), lookup)[:, None],
            )
        return value[:, 0]


def cross_mean(
    pyramid: Pyramid, radius_max: float, u: NDArray, v: NDArray, w: NDArray, axes: Axes, lookup: str,
    value: Callable[[NDArray, NDArray, NDArray], NDArray],
) -> NDArray:
    """(position, channel): mean of a cross term over `|w|`; beyond its patches it is 0."""
    patches = pyramid.levels[0]
    per_unit = (patches.columns - 1) / (2 * radius_max)

    def by_points(those: NDArray) -> NDArray:
        return mean_of_points(u[those], v[those], w[those], _some(axes, those), per_unit, value)

    def by_texels(those: NDArray) -> NDArray:
        x, y, z = u[those], v[those], w[those]
        basis = chebyshev(normalised_abs_w(x * x + y * y, z), patches.count)
        at = ((radius_max + x) * per_unit, (radius_max - y) * per_unit)
        return pyramid.means(basis, at, on_image(_some(axes, those), per_unit), edge=False) / z[:, None]

    mean = np.zeros((len(u), patches.channels))
    reach = radius_max + 2 * np.sqrt(axes.major)
    (those,) = np.nonzero(np.maximum(np.abs(u), np.abs(v)) < reach)
    if len(those):
        part = lambda by: lambda some: by(those[some])
        mean[those] = as_interpolated(lookup, _some(axes, those), per_unit, patches.channels, part(by_points), part(by_texels))
    return mean


def on_image(axes: Axes, per_unit: float) -> Axes:
    """Ellipses of (u, v) in texels, whose rows run against v."""
    return Axes(axes.major * per_unit**2, axes.minor * per_unit**2, axes.x, -axes.y)


def as_interpolated(
    lookup: str, axes: Axes, per_unit: float, channels: int,
    by_points: Callable[[NDArray], NDArray], by_texels: Callable[[NDArray], NDArray],
) -> NDArray:
    """(position, channel): means from linear look-ups texel by texel, or, of small ellipses, from cubic ones at a few points."""
    semi_axis = 2 * np.sqrt(axes.major) * per_unit
    share = np.clip(2 - semi_axis / CUBIC_MAX, 0, 1) if lookup != "linear" else np.zeros(len(semi_axis))
    value = np.zeros((len(share), channels))
    for of, by in ((share, by_points), (1 - share, by_texels)):
        (those,) = np.nonzero(of > 0)
        if len(those):
            value[those] += of[those, None] * by(those)
    return value


def mean_of_points(
    u: NDArray, v: NDArray, w: NDArray, axes: Axes, per_unit: float, value: Callable[[NDArray, NDArray, NDArray], NDArray]
) -> NDArray:
    """(position, channel): means over points of the ellipses, at the centre's `t`."""
    few = 2 * np.sqrt(axes.major) * per_unit < SEVEN_POINTS_MAX
    out = None
    for is_part, (x, y, share) in ((few, _seven_points()), (~few, _rings())):
        (those,) = np.nonzero(is_part)
        if not len(those):
            continue
        means = _mean_of(u[those], v[those], w[those], _some(axes, those), (x, y, share), value)
        if out is None:
            out = np.zeros((len(u), means.shape[1]))
        out[those] = means
    return np.zeros((0, 0)) if out is None else out


def _seven_points() -> tuple[NDArray, NDArray, NDArray]:
    """Places of the unit disc and their shares: polynomials of degree five have their mean."""
    angle = np.arange(6) / 6 * 2 * np.pi
    x, y = np.sqrt(2 / 3) * np.cos(angle), np.sqrt(2 / 3) * np.sin(angle)
    return np.append(0, x), np.append(0, y), np.append(0.25, np.full(6, 0.125))


def _rings() -> tuple[NDArray, NDArray, NDArray]:
    """Places of the unit disc on rings of equal areas, and their shares."""
    count = RINGS * POINTS_PER_RING
    ring, k = np.divmod(np.arange(count), POINTS_PER_RING)
    radius, angle = np.sqrt((ring + 0.5) / RINGS), (k + 0.618 * ring) / POINTS_PER_RING * 2 * np.pi
    return radius * np.cos(angle), radius * np.sin(angle), np.full(count, 1 / count)


def _mean_of(
    u: NDArray, v: NDArray, w: NDArray, axes: Axes, places: tuple[NDArray, NDArray, NDArray],
    value: Callable[[NDArray, NDArray, NDArray], NDArray],
) -> NDArray:
    along = 2 * np.sqrt(axes.major)[:, None] * places[0]
    across = 2 * np.sqrt(axes.minor)[:, None] * places[1]
    x = u[:, None] + along * axes.x[:, None] - across * axes.y[:, None]
    y = v[:, None] + along * axes.y[:, None] + across * axes.x[:, None]
    # No two directions reach further than 2.
    distance, most = np.hypot(x, y), 2 - 1e-9
    inwards = np.where(distance > most, most / np.maximum(distance, most), 1)
    x, y = (x * inwards).ravel(), (y * inwards).ravel()
    abs_w = np.repeat(normalised_abs_w(u * u + v * v, w), len(places[0])) * np.sqrt(np.maximum(4 - x * x - y * y, 0))
    values = value(x, y, abs_w)
    return np.einsum("pkc,k->pc", values.reshape(len(u), len(places[0]), -1), places[2])


def _some(axes: Axes, those: NDArray) -> Axes:
    return Axes(*(array[those] for array in axes))
