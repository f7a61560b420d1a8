"""Importance sampling: directions to the light, given that to the viewer, by a mixture of three densities.

- The lobe: over the part of the coherent lobe above the horizon, in proportion to what it reflects.
- The tables: cells of the (u, v) grid in proportion to the tables, over the disc of (u, v) that is above the horizon.
- The remainder: evenly over solid angle, so that nothing the other two underrate has an unbounded weight.

All are densities over solid angle, and exact; what is prepared for a few polar angles of the viewer only decides how alike the BRDF they
are. The same mixture, with the same numbers, as in the Rust crate `diffraction-brdf`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ._images import chebyshev
from ._optics import Vector, factors, image_radius2
from ._tables import Lobe, Tables

#: Share of the samples that are even over solid angle; lobe and tables get at least SHARE_MIN of the rest.
EVEN_SHARE, SHARE_MIN = 0.1, 0.05
#: Polar angles of the viewer for which densities are prepared: `cos = ((k + 1/2) / NODES)^2`.
NODES = 8
#: Strips across the lobe, cells along a strip, and what each of them gets at least, as a share of the mean.
STRIPS, CELLS, FLOOR = 32, 32, 0.02
#: Values of t at which the tables are looked at; rings of the radius and azimuths of the viewer over which is averaged.
T_VALUES, RINGS, AZIMUTHS = 9, 128, 32
#: Cosines and `|w|` below this count as this in means of what grows without bound.
COSINE_MIN = 0.1
#: What a cell counts of its largest value over t, beside its mean.
PEAK_SHARE = 0.2
#: Pieces of a chord: the edges of half of them lie at `h (1 - 4^-k)` from its middle, and at h.
PIECES = 12


def node_of(cos_o: NDArray) -> NDArray:
    """The prepared polar angle nearest to a viewer's."""
    return np.minimum((NODES * np.sqrt(np.maximum(cos_o, 0))).astype(np.intp), NODES - 1)


def node_cosine(node: int) -> float:
    """Its cosine."""
    return ((node + 0.5) / NODES) ** 2


def choose(mass: NDArray, allowed: NDArray, u: NDArray) -> tuple[NDArray, NDArray]:
    """One of several things each, in proportion to `mass` of shape (draw, thing), and what is left of the number `u` in [0, 1)."""
    mass = np.where(allowed, mass, 0)
    sums = np.cumsum(mass, axis=1)
    total = sums[:, -1]
    flat = ~(total > 0)
    if flat.any():
        mass[flat], sums[flat] = allowed[flat], np.cumsum(allowed[flat], axis=1)
        total = sums[:, -1]
    target = u * total
    last = mass.shape[1] - 1 - np.argmax(mass[:, ::-1] > 0, axis=1)
    index = np.minimum(np.argmax(sums > target[:, None], axis=1), last)
    index = np.where(target < total, index, last)
    here = np.take_along_axis(mass, index[:, None], axis=1)[:, 0]
    below = np.take_along_axis(sums, index[:, None], axis=1)[:, 0] - here
    return index, np.clip((target - below) / np.where(here > 0, here, 1), 0, 1)


def probability(mass: NDArray, allowed: NDArray, index: NDArray) -> NDArray:
    """The probability with which `choose` takes `index`."""
    mass = np.where(allowed, mass, 0)
    total = mass.sum(axis=1)
    here = np.take_along_axis(mass, index[:, None], axis=1)[:, 0]
    count = allowed.sum(axis=1)
    return np.where(total > 0, here / np.where(total > 0, total, 1), 1 / np.maximum(count, 1))


def projection(wo: Vector) -> tuple[NDArray, NDArray, NDArray]:
    """Unit vector along the viewer's projection, x where it has none, and the projection's length."""
    sin = np.hypot(wo[0], wo[1])
    upright = sin < 1e-9
    safe = np.where(upright, 1, sin)
    return np.where(upright, 1, wo[0] / safe), np.where(upright, 0, wo[1] / safe), np.where(upright, 0, sin)


class Strip(NamedTuple):
    """Strips of constant y across the lobe, for viewers: their azimuths from `first` on in cells of `step`."""

    first: NDArray
    step: NDArray
    cells: NDArray
    #: Whether there is one: it may lie below the horizon.
    there: NDArray


class LobeDensity:
    """Directions drawn from the coherent lobe.

    In a frame with x along the viewer's projection, a direction is `(h sin phi, -y, h cos phi)` with `h = sqrt(1 - y^2)`, and its solid
    angle `dy dphi` (Archimedes).
    """

    def __init__(self, lobe: Lobe, tables: Tables):
        image = lobe.coherent.image(0).astype(float)
        self.sum = np.maximum(image.sum(axis=2), 0)
        self.radius_max, self.vector = lobe.radius_max, tables.optics.vector
        cos = np.maximum(np.arange(65) / 64, 0.01)
        sin, zero = np.sqrt(1 - cos * cos), np.zeros(65)
        self.reflectance = factors(tables.optics, (sin, zero, cos), (-sin, zero, cos))[1]
        self.width = 2 * self.radius_max / STRIPS
        y = -self.radius_max + (np.arange(STRIPS) + 0.5) * self.width
        strips = []
        for node in range(NODES):
            cos_o = np.full(STRIPS, node_cosine(node))
            strip = self.strip(np.sqrt(1 - cos_o * cos_o), cos_o, y)
            power = np.where(strip.there, strip.cells.sum(axis=1) * strip.step, 0)
            strips.append((power + FLOOR * power.sum() / STRIPS) * self.width)
        #: What strips reflect, by the viewer's node.
        self.strips = np.array(strips)
        self.reflected = self.strips.sum(axis=1)

    def strip(self, sin_o: NDArray, cos_o: NDArray, y: NDArray) -> Strip:
        """Arrays of one shape (position,)."""
        h = np.sqrt(np.maximum(1 - y * y, 0))
        half = np.sqrt(np.maximum(self.radius_max**2 - y * y, 0))
        safe = np.where(h > 0, h, 1)
        first, last = (np.arcsin(np.clip(x / safe, -1, 1)) for x in (-sin_o - half, -sin_o + half))
        step = (last - first) / CELLS
        there = step > 1e-12
        phi = first[:, None] + np.arange(CELLS + 1) * step[:, None]
        values = self.shape(sin_o[:, None], cos_o[:, None], h[:, None], y[:, None], phi)
        cells = np.maximum(values[:, 1:], values[:, :-1])
        cells = cells + FLOOR * cells.mean(axis=1, keepdims=True)
        return Strip(first, np.where(there, step, 1), cells, there)

    def shape(self, sin_o: NDArray, cos_o: NDArray, h: NDArray, y: NDArray, phi: NDArray) -> NDArray:
        """`f cos_theta_i` of the lobe alone, all channels added, without shadowing."""
        x, z = h * np.sin(phi), h * np.maximum(np.cos(phi), 0)
        radius2 = (x + sin_o) ** 2 + y * y
        w = z + cos_o
        q2 = radius2 + w * w
        value = self.coherent(w, np.sqrt(radius2))
        if self.vector:
            zero = np.zeros_like(x)
            image2 = image_radius2((x, -y + zero, z), (sin_o + zero, zero, cos_o + zero))
            value = (value + self.coherent(w, np.sqrt(image2))) * z
        else:
            value = value * q2 * q2 / (4 * cos_o * w * w)
        at = np.minimum(np.sqrt(q2) / 2, 1) * 64
        return np.interp(at, np.arange(65), self.reflectance) * value

    def coherent(self, w: NDArray, radius: NDArray) -> NDArray:
        """The coherent part, linear between texels, 0 from `radius_max` on."""
        rows, columns = self.sum.shape
        inside = radius < self.radius_max
        radius = np.where(inside, radius, 0)
        y = np.minimum(w / np.sqrt(4 - radius * radius), 1) * (rows - 1)
        x = radius / self.radius_max * (columns - 1)
        row, column = np.minimum(y.astype(np.intp), rows - 2), np.minimum(x.astype(np.intp), columns - 2)
        y, x = y - row, x - column
        along = lambda row: (1 - x) * self.sum[row, column] + x * self.sum[row, column + 1]
        return np.where(inside, (1 - y) * along(row) + y * along(row + 1), 0)

    def sample(self, node: NDArray, wo: Vector, u1: NDArray, u2: NDArray) -> tuple[Vector, NDArray]:
        """Directions, and whether there is one."""
        along_x, along_y, sin_o = projection(wo)
        strips = self.strips[node]
        number, rest = choose(strips, np.ones_like(strips, bool), u1)
        y = -self.radius_max + (number + rest) * self.width
        strip = self.strip(sin_o, wo[2], y)
        cell, rest = choose(strip.cells, np.ones_like(strip.cells, bool), u2)
        phi = strip.first + (cell + rest) * strip.step
        h = np.sqrt(np.maximum(1 - y * y, 0))
        x = h * np.sin(phi)
        return (x * along_x + y * along_y, x * along_y - y * along_x, h * np.cos(phi)), strip.there

    def pdf(self, node: NDArray, wi: Vector, wo: Vector) -> NDArray:
        """In 1/sr."""
        along_x, along_y, sin_o = projection(wo)
        y = wi[0] * along_y - wi[1] * along_x
        place = (y + self.radius_max) / self.width
        x = wi[0] * along_x + wi[1] * along_y
        value = np.zeros_like(y)
        (those,) = np.nonzero((place >= 0) & (place < STRIPS) & (np.abs(x + sin_o) <= self.radius_max))
        if not len(those):
            return value
        y, x, z, place, node = y[those], x[those], wi[2][those], place[those], node[those]
        strip = self.strip(sin_o[those], wo[2][those], y)
        cell = (np.arctan2(x, z) - strip.first) / strip.step
        inside = strip.there & (cell >= 0) & (cell < CELLS)
        cell = np.where(inside, cell, 0).astype(np.intp)
        strips = self.strips[node]
        across = probability(strips, np.ones_like(strips, bool), place.astype(np.intp)) / self.width
        along = probability(strip.cells, np.ones_like(strip.cells, bool), cell) / strip.step
        value[those] = np.where(inside, across * along, 0)
        return value


class Chord(NamedTuple):
    """Parts of rows that are above the horizon and within the grid, in pieces."""

    half: NDArray
    #: `s` at the pieces' edges from low to high, `phi` there, and the sum of the cells up to there: (position, PIECES + 1).
    edges: NDArray
    phi: NDArray
    sums: NDArray

    def flat(self) -> NDArray:
        """Whether all cells are zero."""
        return ~(self.sums[:, -1] > self.sums[:, 0])

    def mass(self) -> NDArray:
        """(position, piece)."""
        width = np.diff(self.edges, axis=1)
        there = width > 0
        sums = np.where(self.flat()[:, None], width, np.diff(self.sums, axis=1))
        return np.where(there, sums * np.diff(self.phi, axis=1) / np.where(there, width, 1), 0)

    def even(self, piece: NDArray) -> NDArray:
        """Whether a piece is drawn from evenly in phi."""
        return (piece == 0) | (piece == PIECES - 1) | self.flat()


class TableDensity:
    """Directions drawn from the tables.

    A band of rows is chosen in proportion to the tables within its widest chord of the disc that the viewer sees, then a row likewise, v evenly
    in the row, and u within the chord at v, cut into pieces that narrow towards its ends.
    """

    def __init__(self, tables: Tables):
        self.rows, self.columns = tables.layers.rows - 1, tables.layers.columns - 1
        self.step = 4 / (tables.size - 1)
        self.first = (-2 + self.step * tables.first[0], 2 - self.step * tables.first[1])
        self.band = int(np.ceil(np.sqrt(self.rows)))
        u = self.first[0] + self.step * np.arange(self.columns + 1)
        v = self.first[1] - self.step * np.arange(self.rows + 1)
        radius = np.hypot(u, v[:, None])
        ring = np.minimum((radius / 2 * RINGS).astype(np.intp), RINGS - 1)
        values = _at_each_t(tables, radius)
        values[radius > 2] = 0
        peak = values.max(axis=2)
        bands = -(-self.rows // self.band)
        self.row_sums = np.zeros((NODES, self.rows, self.columns + 1), np.float32)
        self.band_sums = np.zeros((NODES, bands, self.columns + 1), np.float32)
        self.reflected = np.zeros(NODES)
        for node in range(NODES):
            weights, reflected = _average(tables, node)
            mean = np.einsum("yxt,yxt->yx", weights[ring], values)
            texels = mean + PEAK_SHARE * peak * weights.sum(axis=1)[ring]
            self.reflected[node] = np.einsum("yxt,yxt->", reflected[ring], values) * self.step**2
            texels = texels.astype(np.float32).astype(float)
            # A cell has the largest value of its corners, so that no look-up in it lies far above.
            cells = np.maximum(np.maximum(texels[:-1, :-1], texels[:-1, 1:]), np.maximum(texels[1:, :-1], texels[1:, 1:]))
            sums = np.cumsum(cells, axis=1)
            self.row_sums[node, :, 1:] = sums
            self.band_sums[node, :, 1:] = np.add.reduceat(sums, np.arange(0, self.rows, self.band), axis=0)

    def _s(self, column: NDArray | float, wo_x: NDArray) -> NDArray:
        return self.first[0] + column * self.step + wo_x

    def _column(self, s: NDArray, wo_x: NDArray) -> NDArray:
        return np.clip((s - wo_x - self.first[0]) / self.step, 0, self.columns)

    def _wi_y(self, place: NDArray, wo_y: NDArray) -> NDArray:
        return place * self.step - self.first[1] - wo_y

    def _seen(self, wo: Vector) -> tuple[NDArray, NDArray, NDArray]:
        """Places of the first and last row that a viewer sees, and whether there are any."""
        top, bottom = (np.clip((self.first[1] - v) / self.step, 0, self.rows) for v in (-wo[1] + 1, -wo[1] - 1))
        return top, bottom, bottom - top > 1e-9

    def _ends(self, place: NDArray, wo_x: NDArray, wo_y: NDArray) -> tuple[NDArray, NDArray, NDArray]:
        """Half the chord at a place along v, and the `s` between which it lies in the grid."""
        y = self._wi_y(place, wo_y)
        half = np.sqrt(np.maximum(1 - y * y, 0))
        return half, np.maximum(self._s(0.0, wo_x), -half), np.minimum(self._s(float(self.columns), wo_x), half)

    def _masses(self, sums: NDArray, at: tuple, top: NDArray, bottom: NDArray, wo: Vector) -> NDArray:
        """(position, row): sums within the widest chords between places, over phi, times their distance."""
        wo_x, wo_y = wo[0][:, None], wo[1][:, None]
        middle = (self.first[1] + wo_y) / self.step
        half, low, high = self._ends(np.clip(middle, np.minimum(top, bottom), np.maximum(top, bottom)), wo_x, wo_y)
        there = (bottom > top) & (high > low)
        below, above = (self._sum_at(sums, at, self._column(s, wo_x)) for s in (low, high))
        angle = _angle(high, half) - _angle(low, half)
        return np.where(there, (above - below) * angle / np.where(there, high - low, 1) * (bottom - top), 0)

    def _sum_at(self, sums: NDArray, at: tuple, x: NDArray) -> NDArray:
        """The sum up to a place, linear between edges."""
        cell = np.minimum(x.astype(np.intp), self.columns - 1)
        before, after = sums[(*at, cell)].astype(float), sums[(*at, cell + 1)].astype(float)
        return before + (x - cell) * (after - before)

    def _bands(self, node: NDArray, top: NDArray, bottom: NDArray, wo: Vector) -> tuple[NDArray, NDArray]:
        """Masses of bands, and which of them a viewer sees."""
        number = np.arange(self.band_sums.shape[1])
        row = lambda place: np.minimum(place.astype(np.intp), self.rows - 1)[:, None]
        allowed = (number >= row(top) // self.band) & (number <= row(bottom) // self.band)
        first = np.maximum(number * self.band, top[:, None])
        last = np.minimum((number + 1) * self.band, bottom[:, None])
        masses = self._masses(self.band_sums, (node[:, None], number[None, :]), first, last, wo)
        return masses / self.band, allowed

    def _rows(self, node: NDArray, band: NDArray, top: NDArray, bottom: NDArray, wo: Vector) -> tuple[NDArray, NDArray]:
        """Masses of the rows of a band, and which of them a viewer sees."""
        number = band[:, None] * self.band + np.arange(self.band)
        allowed = (number >= top.astype(np.intp)[:, None]) & (number < self.rows)
        allowed &= number < bottom.astype(np.intp)[:, None] + 1
        first, last = np.maximum(number, top[:, None]), np.minimum(number + 1, bottom[:, None])
        within = np.minimum(number, self.rows - 1)
        return self._masses(self.row_sums, (node[:, None], within), first, last, wo), allowed

    def _chord(self, place: NDArray, node: NDArray, row: NDArray, wo: Vector) -> Chord:
        half, low, high = self._ends(place, wo[0], wo[1])
        from_middle = np.abs(np.arange(PIECES + 1) - PIECES // 2)
        share = np.where(from_middle == PIECES // 2, 1.0, 1 - 0.25**from_middle)
        share[: PIECES // 2] *= -1
        edges = np.maximum(np.minimum(half[:, None] * share, high[:, None]), low[:, None])
        sums = self._sum_at(self.row_sums, (node[:, None], row[:, None]), self._column(edges, wo[0][:, None]))
        return Chord(half, edges, _angle(edges, half[:, None]), sums)

    def sample(self, node: NDArray, wo: Vector, u1: NDArray, u2: NDArray) -> tuple[Vector, NDArray]:
        """Directions, and whether there is one."""
        top, bottom, there = self._seen(wo)
        band, rest = choose(*self._bands(node, top, bottom, wo), u1)
        masses, allowed = self._rows(node, band, top, bottom, wo)
        number, rest = choose(masses, allowed, rest)
        row = np.minimum(band * self.band + number, self.rows - 1)
        first, last = np.maximum(row, top), np.minimum(row + 1, bottom)
        place = first + rest * (last - first)
        chord = self._chord(place, node, row, wo)
        mass = chord.mass()
        piece, rest = choose(mass, np.ones_like(mass, bool), u2)
        at = lambda values, k: np.take_along_axis(values, (piece + k)[:, None], axis=1)[:, 0]
        between = lambda values: at(values, 0) + rest * (at(values, 1) - at(values, 0))
        phi = between(chord.phi)
        s = self._s(self._inverse(node, row, between(chord.sums)), wo[0])
        s = np.clip(s, at(chord.edges, 0), at(chord.edges, 1))
        even = chord.even(piece)
        x = np.where(even, chord.half * np.sin(phi), s)
        z = np.where(even, chord.half * np.cos(phi), np.sqrt(np.maximum(chord.half**2 - s * s, 0)))
        return (-x, self._wi_y(place, wo[1]), z), there

    def _inverse(self, node: NDArray, row: NDArray, total: NDArray) -> NDArray:
        """The places at which sums along rows are reached."""
        low, high = np.zeros(len(row), np.intp), np.full(len(row), self.columns + 1)
        while np.any(low < high):
            middle = (low + high) // 2
            reached = self.row_sums[node, row, np.minimum(middle, self.columns)] <= total
            low, high = np.where((low < high) & reached, middle + 1, low), np.where((low < high) & ~reached, middle, high)
        after = np.clip(low, 1, self.columns)
        below, above = (self.row_sums[node, row, k].astype(float) for k in (after - 1, after))
        rises = above > below
        return after - 1 + np.where(rises, np.clip((total - below) / np.where(rises, above - below, 1), 0, 1), 0)

    def pdf(self, node: NDArray, wi: Vector, wo: Vector) -> NDArray:
        """In 1/sr."""
        value = np.zeros_like(wi[0])
        x = (-wi[0] - wo[0] - self.first[0]) / self.step
        place = (self.first[1] + wi[1] + wo[1]) / self.step
        top, bottom, there = self._seen(wo)
        (those,) = np.nonzero(there & (x >= 0) & (x < self.columns) & (place >= 0) & (place < self.rows))
        if not len(those):
            return value
        x, place, top, bottom, node = (part[those] for part in (x, place, top, bottom, node))
        wi, wo = (tuple(d[those] for d in direction) for direction in (wi, wo))
        row = place.astype(np.intp)
        band = row // self.band
        band_masses, bands = self._bands(node, top, bottom, wo)
        row_masses, rows = self._rows(node, band, top, bottom, wo)
        height = np.minimum(row + 1, bottom) - np.maximum(row, top)
        take = lambda values, k: np.take_along_axis(values, k[:, None], axis=1)[:, 0]
        seen = take(bands, band) & take(rows, row % self.band) & (height > 0)
        chord = self._chord(place, node, row, wo)
        piece = np.clip((chord.edges <= -wi[0][:, None]).sum(axis=1), 1, PIECES) - 1
        mass = chord.mass()
        width, within = take(chord.phi, piece + 1) - take(chord.phi, piece), take(mass, piece)
        seen &= (within > 0) & (width > 0)
        cell = x.astype(np.intp)
        cells = self.row_sums[node, row, cell + 1] - self.row_sums[node, row, cell]
        sums = take(chord.sums, piece + 1) - take(chord.sums, piece)
        by_cells = cells / np.where(sums > 0, sums, 1) / self.step * wi[2]
        along = np.where(chord.even(piece), 1 / np.where(width > 0, width, 1), by_cells)
        along = along * probability(mass, np.ones_like(mass, bool), piece)
        down = probability(band_masses, bands, band) * probability(row_masses, rows, row % self.band)
        value[those] = np.where(seen, along * down / np.where(height > 0, height, 1) / self.step, 0)
        return value


def _angle(s: NDArray, half: NDArray) -> NDArray:
    """phi at `s = half sin phi`."""
    return np.where(half > 0, np.arcsin(np.clip(s / np.where(half > 0, half, 1), -1, 1)), 0)


def _at_each_t(tables: Tables, radius: NDArray) -> NDArray:
    """(row, column, t): X + Y + Z of the tables, 0 where negative and where there is no answer."""
    layers = tables.layers
    sums = layers.texels.reshape(layers.rows, layers.columns, layers.channels, layers.count).sum(axis=2, dtype=float)
    values = np.empty(sums.shape[:2] + (T_VALUES,))
    for k in range(T_VALUES):
        t, answered = k / (T_VALUES - 1), True
        if tables.basis == "taylor":
            w = np.maximum(t * np.sqrt(np.maximum(4 - radius * radius, 0)), COSINE_MIN)
            basis = w[..., None] ** np.arange(-2, layers.count - 2, dtype=float)
        elif tables.range is None:
            basis = chebyshev(np.array(t), layers.count)
        else:
            low, high, there = np.moveaxis(tables.range.image(0).astype(float), -1, 0)
            half = 0.5 / (T_VALUES - 1)
            answered = (there != 0) & (t + half >= low) & (t - half <= high)
            basis = chebyshev(np.clip((t - low) / np.where(high > low, high - low, 1), 0, 1) * (high > low), layers.count)
        values[..., k] = np.where(answered, np.maximum((sums * basis).sum(axis=-1), 0), 0)
    return values


def _average(tables: Tables, node: int) -> tuple[NDArray, NDArray]:
    """(ring, t): how the tables at each t count, for viewers between the edges of a node averaged over their azimuth; and the same without the
    light's cosine and of all azimuths."""
    weights, reflected = np.zeros((RINGS, T_VALUES)), np.zeros((RINGS, T_VALUES))
    seen = np.zeros(RINGS)
    middle = node_cosine(node)
    edges = [max((edge / NODES) ** 2, 1e-3) for edge in (node, node + 1)]
    radius = np.repeat(2 * (np.arange(RINGS) + 0.5) / RINGS, AZIMUTHS)
    ring = np.repeat(np.arange(RINGS), AZIMUTHS)
    azimuth = np.tile(2 * np.pi * np.arange(AZIMUTHS) / AZIMUTHS, RINGS)
    for cos_o in (edges[0], middle, edges[1]):
        sin_o = np.sqrt(1 - cos_o * cos_o)
        x, y = sin_o * np.cos(azimuth), sin_o * np.sin(azimuth)
        cos2 = 1 - (radius + x) ** 2 - y * y
        (those,) = np.nonzero(cos2 > 0)
        cos_i, rings, r = np.sqrt(cos2[those]), ring[those], radius[those]
        np.add.at(seen, rings, 1)
        wi = (-r - x[those], -y[those], cos_i)
        wo = (x[those], y[those], np.full(len(those), cos_o))
        front = factors(tables.optics, wi, wo)[0]
        place = np.minimum((cos_i + cos_o) / np.sqrt(4 - r * r), 1) * (T_VALUES - 1)
        below = np.minimum(place.astype(np.intp), T_VALUES - 2)
        share = place - below
        for k, part in ((below, 1 - share), (below + 1, share)):
            np.add.at(weights, (rings, k), part * front * cos_i * cos_o)
            if cos_o == middle:
                np.add.at(reflected, (rings, k), part * front * np.minimum(cos_i / COSINE_MIN, 1) / AZIMUTHS)
    for r in range(RINGS):
        # Out of sight but for its edge.
        weights[r] = weights[r - 1] if seen[r] == 0 and r > 0 else weights[r] / max(seen[r], 1)
    return weights, reflected


class Sampler:
    """The mixture."""

    def __init__(self, tables: Tables):
        self.lobe = LobeDensity(tables.lobe, tables) if tables.lobe is not None else None
        self.tables = TableDensity(tables)
        lobe = self.lobe.reflected if self.lobe is not None else np.zeros(NODES)
        #: Shares of the remainder, the lobe and the tables by node.
        self.shares = np.array([_shares(*pair) for pair in zip(lobe, self.tables.reflected)])

    def sample(self, wo: Vector, choice: NDArray, u1: NDArray, u2: NDArray) -> tuple[NDArray, NDArray]:
        """(direction, 3) to the light, and whether one was found; `wo` is above the surface."""
        node = node_of(wo[2])
        even, lobe, _ = self.shares[node].T
        wi, found = np.zeros((len(node), 3)), np.zeros(len(node), bool)
        kinds = (choice < even, (choice >= even) & (choice < even + lobe), choice >= even + lobe)
        (those,) = np.nonzero(kinds[0])
        radius = np.sqrt(1 - u1[those] ** 2)
        wi[those] = np.stack([radius * np.cos(2 * np.pi * u2[those]), radius * np.sin(2 * np.pi * u2[those]), u1[those]], axis=1)
        found[those] = True
        for kind, density in zip(kinds[1:], (self.lobe, self.tables)):
            (those,) = np.nonzero(kind)
            if len(those) and density is not None:
                drawn, there = density.sample(node[those], tuple(d[those] for d in wo), u1[those], u2[those])
                wi[those], found[those] = np.stack(drawn, axis=1), there
        return wi, found & (wi[:, 2] > 0)

    def pdf(self, wi: Vector, wo: Vector) -> NDArray:
        """In 1/sr, for directions above the surface."""
        node = node_of(wo[2])
        even, lobe, tables = self.shares[node].T
        value = even / (2 * np.pi) + tables * self.tables.pdf(node, wi, wo)
        return value if self.lobe is None else value + lobe * self.lobe.pdf(node, wi, wo)


def _shares(lobe: float, tables: float) -> tuple[float, float, float]:
    rest = 1 - EVEN_SHARE
    if lobe <= 0 and tables <= 0:
        return 1.0, 0.0, 0.0
    if lobe <= 0 or tables <= 0:
        return EVEN_SHARE, rest * (lobe > 0), rest * (tables > 0)
    share = min(max(lobe / (lobe + tables), SHARE_MIN), 1 - SHARE_MIN)
    return EVEN_SHARE, rest * share, rest * (1 - share)
