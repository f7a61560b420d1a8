"""Means over ellipses: of tables, texel by texel, and of what depends on the distance from a point alone."""

from __future__ import annotations

from functools import lru_cache
from typing import Callable

import numpy as np
from numpy.typing import NDArray

from ._footprint import Axes
from ._images import Layers
from ._optics import Vector, image_radius2

#: Chords across an ellipse on a table.
CHORDS = 48
#: Semi-axes in texels from which coarser levels are mixed in: the longer one, and the geometric mean of both.
SEMI_AXES_MAX = (6.0, 3.5)
#: Coarsest levels have at least this many texels a side.
SIDE_MIN = 4
#: Chords across a lobe's ellipse, and places along a chord.
NODES = 24
#: Texels that are gathered at a time.
TEXELS_AT_A_TIME = 1 << 20
#: A chord shorter than this many texels is a point.
POINT_LENGTH = 1e-6

# Tables


class Pyramid:
    """Layers, and coarser copies of them: each level holds the means of two by two texels of the one before."""

    def __init__(self, layers: Layers):
        self.levels = [layers]
        while min(self.levels[-1].rows, self.levels[-1].columns) >= 2 * SIDE_MIN:
            self.levels.append(_halved(self.levels[-1]))

    def means(self, basis: NDArray, at: tuple[NDArray, NDArray], axes: Axes, edge: bool) -> NDArray:
        """(position, channel): `basis` times the layers' means over ellipses, in texels.

        `at` holds columns and rows, `axes` the ellipses with x along columns and y along rows. Beyond the images lie the values at
        their edges, or nothing where `edge` is false.
        """
        longer, middle = 2 * np.sqrt(axes.major), 2 * (axes.major * axes.minor) ** 0.25
        with np.errstate(divide="ignore"):
            level = np.log2(np.maximum(longer / SEMI_AXES_MAX[0], middle / SEMI_AXES_MAX[1]))
        level = np.clip(level, 0, len(self.levels) - 1)
        total = np.zeros((len(basis), self.levels[0].channels))
        for number in range(len(self.levels)):
            share = 1 - np.abs(level - number)
            (those,) = np.nonzero(share > 0)
            if len(those):
                part = Axes(*(array[those] for array in axes))
                mean = self._on_level(number, basis[those], [a[those] for a in at], part, edge)
                total[those] += share[those, None] * mean
        return total

    def _on_level(self, number: int, basis: NDArray, at: list[NDArray], axes: Axes, edge: bool) -> NDArray:
        layers, step = self.levels[number], float(1 << number)
        # A level's means and its interpolation blur by so much more than the tables' own interpolation.
        blur = 0.25 * (1 - 1 / step**2)
        narrower = [np.maximum(variance / step**2 - blur, 0) for variance in (axes.major, axes.minor)]
        xx, xy, yy = Axes(*narrower, axes.x, axes.y).covariance()
        place = lambda x: (x - 0.5 * (step - 1)) / step
        column, row = place(at[0]), place(at[1])
        ends = [(place(0.0), place(float(finest - 1))) for finest in (self.levels[0].columns, self.levels[0].rows)]
        half_width, half_height = 2 * np.sqrt(xx), 2 * np.sqrt(yy)
        first_column, columns = _reach(column, half_width, layers.columns)
        first_row, rows = _reach(row, half_height, layers.rows)
        total = np.empty((len(column), layers.channels))
        at_a_time = max(1, TEXELS_AT_A_TIME // (max(rows, 1) * max(columns, 1) * layers.texels.shape[1]))
        for start in range(0, len(column), at_a_time):
            part = slice(start, start + at_a_time)
            weights = _weights(
                (column[part], row[part]), (xx[part], xy[part], yy[part]), (first_column[part], first_row[part]),
                (columns, rows), (layers.columns, layers.rows), ends, edge,
            )
            texel_rows = np.minimum(first_row[part, None] + np.arange(rows), layers.rows - 1)
            texel_columns = np.minimum(first_column[part, None] + np.arange(columns), layers.columns - 1)
            texels = layers.texels[(texel_rows[:, :, None] * layers.columns + texel_columns[:, None, :])]
            sums = np.einsum("pyx,pyxk->pk", weights, texels).reshape(-1, layers.channels, layers.count)
            total[part] = np.einsum("pck,pk->pc", sums, basis[part])
        return total


def _halved(layers: Layers) -> Layers:
    """Means of two by two texels; at an odd edge the last texel counts twice."""
    image = layers.texels.reshape(layers.rows, layers.columns, -1).astype(np.float64)
    image = np.pad(image, ((0, layers.rows % 2), (0, layers.columns % 2), (0, 0)), mode="edge")
    rows, columns = image.shape[0] // 2, image.shape[1] // 2
    means = image.reshape(rows, 2, columns, 2, -1).mean(axis=(1, 3)).astype(np.float32)
    coarser = Layers.__new__(Layers)
    coarser.rows, coarser.columns, coarser.channels, coarser.count = rows, columns, layers.channels, layers.count
    coarser.texels = means.reshape(rows * columns, -1)
    return coarser


def _cell(at: NDArray, count: int) -> NDArray:
    return np.minimum(np.clip(at, 0, count - 1).astype(np.intp), count - 2)


def _reach(at: NDArray, half: NDArray, count: int) -> tuple[NDArray, int]:
    """First texels that ellipses reach along an axis, and the most texels that one of them does."""
    # Rounding must not leave the texels.
    first, last = _cell(at - half - 1e-9, count), _cell(at + half + 1e-9, count) + 1
    return first, int((last - first).max(initial=1)) + 1


def _weights(at, covariance, first, reach, counts, ends, edge) -> NDArray:
    """(position, row, column): weights of texels, of the mean over each ellipse of the linear interpolation between texels."""
    (column, row), (xx, xy, yy) = at, covariance
    # Chords along rows at places between -1 and 1: Gauss's rule whose weight is the chord's length.
    angle = np.arange(1, CHORDS + 1) * np.pi / (CHORDS + 1)
    place, share = -np.cos(angle), 2 / (CHORDS + 1) * np.sin(angle) ** 2
    slope = np.where(yy > 0, xy / np.where(yy > 0, yy, 1), 0)
    half_height = (2 * np.sqrt(yy))[:, None]
    half_chord = 2 * np.sqrt(np.maximum(xx - slope * xy, 0))[:, None] * np.sqrt(1 - place**2)
    y = row[:, None] + half_height * place
    x = column[:, None] + slope[:, None] * half_height * place
    length = 2 * half_chord
    low, high = x - half_chord, x + half_chord
    shares = np.broadcast_to(share, y.shape)
    if not edge:
        (left, right), (top, bottom) = ends
        shares = np.where((y >= top) & (y <= bottom), shares, 0)
        point = length < POINT_LENGTH
        shares = np.where(point & ((x < left) | (x > right)), 0, shares)
        low, high = np.maximum(low, left), np.minimum(high, right)
        shares = np.where(~point & (high <= low), 0, shares)
    across = _hats_between(low, high, length, first[0], reach[0], counts[0])
    down = _hats(np.clip(y, 0, counts[1] - 1), first[1], reach[1])
    return np.swapaxes(down * shares[..., None], 1, 2) @ across


def _hats(at: NDArray, first: NDArray, reach: int) -> NDArray:
    """(position, chord, texel): weights of linear interpolation at places."""
    texel = (first[:, None] + np.arange(reach))[:, None, :]
    return np.maximum(1 - np.abs(at[..., None] - texel), 0)


def _hats_between(low: NDArray, high: NDArray, length: NDArray, first: NDArray, reach: int, count: int) -> NDArray:
    """(position, chord, texel): their integrals from `low` to `high`, over `length`; at the middle where that is a point."""
    last = count - 1
    texel = (first[:, None] + np.arange(reach))[:, None, :]
    clipped_low, clipped_high = np.clip(low, 0, last), np.clip(high, 0, last)
    point = length < POINT_LENGTH
    single = point | (np.floor(clipped_low) == np.floor(clipped_high))
    middle = (clipped_low + clipped_high) / 2
    inside = np.where(point, 1, (clipped_high - clipped_low) / np.where(point, 1, length))
    at_middle = np.maximum(1 - np.abs(middle[..., None] - texel), 0) * inside[..., None]

    def integral(x: NDArray) -> NDArray:
        # Of the hat around each texel, from far left.
        x = np.clip(x[..., None] - texel, -1, 1)
        return np.where(x < 0, (1 + x) ** 2 / 2, 1 - (1 - x) ** 2 / 2)

    whole = (integral(clipped_high) - integral(clipped_low)) / np.where(point, 1, length)[..., None]
    weights = np.where(single[..., None], at_middle, whole)
    # Beyond the edges stands the edge's value.
    beyond = [np.where(point, 0, part / np.where(point, 1, length)) for part in (
        np.maximum(np.minimum(high, 0) - low, 0), np.maximum(high - np.maximum(low, last), 0))]
    weights += np.where(texel == 0, beyond[0][..., None], 0) + np.where(texel == last, beyond[1][..., None], 0)
    return weights


# The lobe


@lru_cache(maxsize=None)
def _nodes() -> tuple[NDArray, NDArray, NDArray]:
    """Places in [-1, 1], with Gauss's weights for what vanishes at the ends like a chord, and Fejer's for the rest."""
    angle, step = np.arange(1, NODES + 1) * np.pi / (NODES + 1), np.pi / (NODES + 1)
    odd = 2 * np.arange(1, -(-NODES // 2) + 1) - 1
    sums = (np.sin(odd * angle[:, None]) / odd).sum(axis=1)
    return -np.cos(angle), step * np.sin(angle), 4 / np.pi * step * np.sin(angle) * sums


class LobeEllipses:
    """Ellipses as a lobe's centre sees them: their centres and semi-axes, in the frame of their axes, arrays of shape (position,)."""

    def __init__(self, centre: tuple[NDArray, NDArray], semi_axes: tuple[NDArray, NDArray]):
        self.centre, self.semi_axes = centre, semi_axes

    @classmethod
    def direct(cls, u: NDArray, v: NDArray, axes: Axes) -> LobeEllipses:
        """Around (u, v)."""
        x, y = axes.x, axes.y
        return cls((u * x + v * y, v * x - u * y), (2 * np.sqrt(axes.major), 2 * np.sqrt(axes.minor)))

    @classmethod
    def image(cls, wi: Vector, wo: Vector, covariance: tuple[NDArray, NDArray, NDArray]) -> LobeEllipses:
        """Around the place of the lobe's image in the horizon: the distance across the horizon moves as that of the lobe does."""
        x, y = wo[0] - wi[0], wo[1] - wi[1]
        length = np.hypot(x, y)
        x, y = np.where(length > 0, x / np.where(length > 0, length, 1), 1), np.where(length > 0, y / np.where(length > 0, length, 1), 0)
        along = (wi[1] + wo[1]) * x - (wi[0] + wo[0]) * y
        across = np.sqrt(np.maximum(image_radius2(wi, wo) - along * along, 0))
        uu, uv, vv = covariance
        variances = (x * x * uu + 2 * x * y * uv + y * y * vv, y * y * uu - 2 * x * y * uv + x * x * vv)
        return cls((across, along), tuple(2 * np.sqrt(np.maximum(variance, 0)) for variance in variances))

    def subset(self, those: NDArray) -> LobeEllipses:
        """Some of them."""
        return LobeEllipses(tuple(c[those] for c in self.centre), tuple(a[those] for a in self.semi_axes))

    def radius(self) -> NDArray:
        """Distance of their centres from the lobe's."""
        return np.hypot(*self.centre)

    def reach(self, distance: float) -> NDArray:
        """Whether their bounding rectangles come within a distance of the lobe's centre."""
        x, y = (np.maximum(np.abs(c) - a, 0) for c, a in zip(self.centre, self.semi_axes))
        return np.hypot(x, y) < distance

    def mean(self, distance: float, value: Callable[[NDArray], NDArray]) -> NDArray:
        """Means of `value(radius)`, which takes (position, places) and gives (position, places, channels): 0 from `distance` on."""
        _, chord_share, weight = _nodes()
        y, low, high, half = self._chords(np.full(len(self.centre[0]), distance))
        place = _nodes()[0]
        width = (high - low) / 2
        x = low[..., None] + width[..., None] * (1 + place)
        x = self.centre[0][:, None, None] + self.semi_axes[0][:, None, None] * x
        radius = np.hypot(x, y[..., None])
        count = len(radius)
        values = value(radius.reshape(count, -1)).reshape(count, NODES, NODES, -1)
        shares = half[:, None] * chord_share / np.pi * width
        return np.einsum("py,x,pyxc->pc", shares, weight, values)

    def gaussian_mean(self, width: NDArray) -> NDArray:
        """Means of `exp(-(distance / width)^2)`: along chords in closed form."""
        _, chord_share, _ = _nodes()
        y, low, high, half = self._chords(6 * width)
        from_, to = ((self.centre[0][:, None] + self.semi_axes[0][:, None] * end) / width[:, None] for end in (low, high))
        wide = to - from_ > 1e-5
        mean = np.where(
            wide,
            0.5 * np.sqrt(np.pi) * (_erf(to) - _erf(from_)) / np.where(wide, to - from_, 1),
            np.exp(-(((from_ + to) / 2) ** 2)),
        )
        values = (high - low) * mean * np.exp(-((y / width[:, None]) ** 2))
        return (half[:, None] * chord_share / np.pi * values).sum(axis=1)

    def _chords(self, distance: NDArray) -> tuple[NDArray, NDArray, NDArray, NDArray]:
        """Chords within a distance: y of each, its ends in the unit disc, and half the height of what they cover."""
        place = _nodes()[0]
        one = np.ones(len(distance))
        low, high = _within(self.centre[1], self.semi_axes[1], distance, one)
        middle, half = (low + high) / 2, np.maximum((high - low) / 2, 0)
        eta = middle[:, None] + half[:, None] * place
        y = self.centre[1][:, None] + self.semi_axes[1][:, None] * eta
        limit = np.sqrt(np.maximum(1 - eta * eta, 0))
        left = np.sqrt(np.maximum(distance[:, None] ** 2 - y * y, 0))
        low, high = _within(self.centre[0][:, None], self.semi_axes[0][:, None], left, limit)
        return y, low, np.maximum(high, low), half


def _within(centre: NDArray, semi_axis: NDArray, reach: NDArray, limit: NDArray) -> tuple[NDArray, NDArray]:
    """The part of [-limit, limit] where `|centre + semi_axis x| < reach`; its end is not above its start where there is none."""
    wide = semi_axis > 0
    divisor = np.where(wide, semi_axis, 1)
    low, high = np.maximum((-reach - centre) / divisor, -limit), np.minimum((reach - centre) / divisor, limit)
    hit = np.abs(centre) < reach
    return np.where(wide, low, np.where(hit, -limit, 0)), np.where(wide, high, np.where(hit, limit, 0))


_erf_vector = None


def _erf(x: NDArray) -> NDArray:
    """The error function; numpy has none."""
    global _erf_vector
    if _erf_vector is None:
        from math import erf

        _erf_vector = np.frompyfunc(erf, 1, 1)
    return _erf_vector(x).astype(float)
