"""The package's sampling densities in kernels of Dr.Jit: see `diffraction_atlas._sampling`, whose numbers these are."""

import drjit as dr
import mitsuba as mi
import numpy as np

from .. import _sampling
from .._sampling import CELLS, FLOOR, NODES, PIECES, STRIPS
from ._lookup import linear


@dr.syntax
def totals(mass, first, last, at):
    """Sum of `mass(k)` from first to last, and the mass at one of them."""
    k, total, here = mi.Int32(first), mi.Float(0), mi.Float(0)
    while dr.hint(k <= last, mode="symbolic"):
        value = mass(k)
        total += value
        here = dr.select(k == at, value, here)
        k += 1
    return total, here


@dr.syntax
def search(mass, first, last, target):
    """The k at which the running sum of `mass(k)` passes `target`, its mass, and the sum before it; the last that has any where none does."""
    k, below, done = mi.Int32(first), mi.Float(0), mi.Bool(False)
    found, here, before = mi.Int32(first), mi.Float(0), mi.Float(0)
    while dr.hint((k <= last) & ~done, mode="symbolic"):
        value = mass(k)
        some = value > 0
        found, here, before = dr.select(some, k, found), dr.select(some, value, here), dr.select(some, below, before)
        below += value
        done |= some & (target < below)
        k += 1
    return found, here, before


def choose(mass, first, last, u):
    """One of first to last in proportion to `mass(k)`, and what is left of the number u."""
    total, _ = totals(mass, first, last, first)
    target = u * total
    found, here, before = search(mass, first, last, target)
    at = u * mi.Float(dr.maximum(last - first + 1, 1))
    even = dr.minimum(mi.Int32(at), last - first)
    flat = ~(total > 0)
    rest = dr.select(flat, at - mi.Float(even), (target - before) / dr.maximum(here, 1e-37))
    return dr.select(flat, first + even, found), dr.clip(rest, 0, 1)


def probability(mass, first, last, at):
    """The probability with which `choose` takes `at`."""
    total, here = totals(mass, first, last, at)
    return dr.select(total > 0, here / dr.maximum(total, 1e-37), 1 / mi.Float(dr.maximum(last - first + 1, 1)))


class LobeDensity:
    """Of the coherent lobe as far as it lies above the horizon."""

    def __init__(self, lobe):
        self.sum = mi.Float(lobe.sum.astype(np.float32).ravel())
        self.rows, self.columns = lobe.sum.shape
        self.radius_max, self.width, self.vector = lobe.radius_max, lobe.width, lobe.vector
        self.reflectance = mi.Float(lobe.reflectance.astype(np.float32))
        self.strips = mi.Float((lobe.strips / lobe.strips.sum(axis=1, keepdims=True)).astype(np.float32).ravel())

    def coherent(self, w, radius):
        inside = radius < self.radius_max
        radius = dr.select(inside, radius, 0)
        y = dr.minimum(w * dr.rsqrt(4 - radius * radius), 1) * (self.rows - 1)
        x = radius * ((self.columns - 1) / self.radius_max)
        row, column = dr.minimum(mi.UInt32(y), self.rows - 2), dr.minimum(mi.UInt32(x), self.columns - 2)
        y, x = y - mi.Float(row), x - mi.Float(column)
        texel = lambda row, column: dr.gather(mi.Float, self.sum, row * self.columns + column)
        along = lambda row: dr.lerp(texel(row, column), texel(row, column + 1), x)
        return dr.select(inside, dr.lerp(along(row), along(row + 1), y), 0)

    def shape(self, sin_o, cos_o, h, y, phi):
        """`f cos_theta_i` of the lobe alone."""
        sin, cos = dr.sincos(phi)
        x, z = h * sin, h * dr.maximum(cos, 0)
        radius2 = (x + sin_o) * (x + sin_o) + y * y
        w = z + cos_o
        q2 = radius2 + w * w
        value = self.coherent(w, dr.sqrt(radius2))
        if self.vector:
            to_i, to_o = z * z / (1 + dr.sqrt(x * x + y * y)), cos_o * cos_o / (1 + sin_o)
            value = (value + self.coherent(w, dr.sqrt(radius2 + 4 * to_i * to_o))) * z
        else:
            value = value * q2 * q2 / (4 * cos_o * w * w)
        return linear(self.reflectance, dr.minimum(dr.sqrt(q2) / 2, 1) * 64, 65) * value

    def strip(self, sin_o, y):
        """First azimuth, step and height of a strip, and whether there is one above the horizon."""
        h = dr.safe_sqrt(1 - y * y)
        half = dr.safe_sqrt(self.radius_max**2 - y * y)
        first, last = (dr.asin(dr.clip(x / dr.maximum(h, 1e-9), -1, 1)) for x in (-sin_o - half, -sin_o + half))
        step = (last - first) / CELLS
        return first, step, h, step > 1e-8

    @dr.syntax
    def cells(self, sin_o, cos_o, h, y, first, step, at, target):
        """Sum of the cells of a strip and the one at `at`; and the first whose sum, with the floor of each, passes `target` for a floor of `target.y`."""
        k, total, here = mi.Int32(0), mi.Float(0), mi.Float(0)
        found, part, before, passed = mi.Int32(0), mi.Float(0), mi.Float(0), mi.Bool(False)
        last = self.shape(sin_o, cos_o, h, y, first)
        while dr.hint(k < CELLS, mode="symbolic"):
            after = self.shape(sin_o, cos_o, h, y, dr.fma(mi.Float(k + 1), step, first))
            cell = dr.maximum(last, after)
            here = dr.select(k == at, cell, here)
            whole = cell + target.y
            start = total + mi.Float(k) * target.y
            reached = ~passed & ((target.x < start + whole) | (k == CELLS - 1))
            found, part, before = dr.select(reached, k, found), dr.select(reached, whole, part), dr.select(reached, start, before)
            passed |= reached
            total += cell
            last = after
            k += 1
        return total, here, found, part, before

    def sample(self, node, wo, u1, u2):
        """A direction, and whether there is one."""
        along_x, along_y, sin_o = projection(wo)
        mass = lambda k: dr.gather(mi.Float, self.strips, node * STRIPS + mi.UInt32(k))
        number, rest = choose(mass, mi.Int32(0), mi.Int32(STRIPS - 1), u1)
        y = dr.fma(mi.Float(number) + rest, self.width, -self.radius_max)
        first, step, h, there = self.strip(sin_o, y)
        place = (sin_o, wo.z, h, y, first, step)
        total, _, _, _, _ = self.cells(*place, mi.Int32(0), mi.Vector2f(0))
        floor = FLOOR * total / CELLS
        target = mi.Vector2f(u2 * total * (1 + FLOOR), floor)
        _, _, cell, part, before = self.cells(*place, mi.Int32(0), target)
        rest = dr.select(part > 0, dr.clip((target.x - before) / dr.maximum(part, 1e-37), 0, 1), u2)
        sin, cos = dr.sincos(dr.fma(mi.Float(cell) + rest, step, first))
        x = h * sin
        return mi.Vector3f(x * along_x + y * along_y, x * along_y - y * along_x, h * cos), there & (total > 0)

    def pdf(self, node, wi, wo):
        """In 1/sr."""
        along_x, along_y, sin_o = projection(wo)
        y = wi.x * along_y - wi.y * along_x
        place = (y + self.radius_max) / self.width
        x = wi.x * along_x + wi.y * along_y
        inside = (place >= 0) & (place < STRIPS) & (dr.abs(x + sin_o) <= self.radius_max)
        first, step, h, there = self.strip(sin_o, y)
        step = dr.select(there, step, 1)
        cell = (dr.atan2(x, wi.z) - first) / step
        inside &= there & (cell >= 0) & (cell < CELLS)
        number = mi.Int32(dr.select(inside, cell, 0))
        total, here, _, _, _ = self.cells(sin_o, wo.z, h, y, first, step, number, mi.Vector2f(0))
        along = (here + FLOOR * total / CELLS) / dr.maximum(total * (1 + FLOOR), 1e-37) / step
        strip = mi.UInt32(dr.select(inside, place, 0))
        across = dr.gather(mi.Float, self.strips, node * STRIPS + strip) / self.width
        return dr.select(inside & (total > 0), along * across, 0)


class TableDensity:
    """Of the tables as far as they lie above the horizon."""

    def __init__(self, tables):
        self.rows, self.columns, self.step, self.band = tables.rows, tables.columns, tables.step, tables.band
        self.first = tables.first
        self.bands = tables.band_sums.shape[1]
        self.row_sums = mi.Float(tables.row_sums.ravel())
        self.band_sums = mi.Float(tables.band_sums.ravel())

    def sum_at(self, sums, base, x):
        """The sum up to a place, linear between edges."""
        cell = dr.minimum(mi.UInt32(x), self.columns - 1)
        before = dr.gather(mi.Float, sums, base + cell)
        return dr.lerp(before, dr.gather(mi.Float, sums, base + cell + 1), x - mi.Float(cell))

    def column(self, s, wo):
        return dr.clip((s - wo.x - self.first[0]) / self.step, 0, self.columns)

    def wi_y(self, place, wo):
        return place * self.step - self.first[1] - wo.y

    def ends(self, place, wo):
        y = self.wi_y(place, wo)
        half = dr.safe_sqrt(1 - y * y)
        s = lambda column: self.first[0] + column * self.step + wo.x
        return half, dr.maximum(s(0.0), -half), dr.minimum(s(float(self.columns)), half)

    def seen(self, wo):
        """Places of the first and last row that a viewer sees, and whether there are any."""
        top, bottom = (dr.clip((self.first[1] - v) / self.step, 0, self.rows) for v in (1 - wo.y, -1 - wo.y))
        return top, bottom, bottom - top > 1e-6

    def mass(self, sums, base, top, bottom, wo):
        """Sum within the widest chord between two places, over phi, times their distance."""
        middle = (self.first[1] + wo.y) / self.step
        half, low, high = self.ends(dr.clip(middle, dr.minimum(top, bottom), dr.maximum(top, bottom)), wo)
        there = (bottom > top) & (high > low)
        within = self.sum_at(sums, base, self.column(high, wo)) - self.sum_at(sums, base, self.column(low, wo))
        turn = angle(high, half) - angle(low, half)
        return dr.select(there, within * turn / dr.select(there, high - low, 1) * (bottom - top), 0)

    def band_range(self, top, bottom, active):
        row = lambda place: dr.minimum(mi.Int32(place), self.rows - 1)
        first, last = row(top) // self.band, row(bottom) // self.band
        return first, dr.select(active, last, first - 1)

    def band_mass(self, node, top, bottom, wo):
        def mass(k):
            start = mi.Float(k * self.band)
            base = (node * self.bands + mi.UInt32(k)) * (self.columns + 1)
            within = dr.maximum(start, top), dr.minimum(start + self.band, bottom)
            return self.mass(self.band_sums, base, *within, wo) / self.band

        return mass

    def row_range(self, band, top, bottom, active):
        first = dr.maximum(band * self.band, mi.Int32(top))
        last = dr.minimum(dr.minimum((band + 1) * self.band, self.rows), mi.Int32(bottom) + 1) - 1
        return first, dr.select(active, last, first - 1)

    def row_base(self, node, row):
        row = mi.UInt32(dr.clip(row, 0, self.rows - 1))
        return (node * self.rows + row) * (self.columns + 1)

    def row_mass(self, node, top, bottom, wo):
        def mass(k):
            start = mi.Float(k)
            within = dr.maximum(start, top), dr.minimum(start + 1, bottom)
            return self.mass(self.row_sums, self.row_base(node, k), *within, wo)

        return mass

    def chord(self, place, base, wo):
        """Half the chord at a place, and for its pieces: edges, phi and sums at them, masses; and whether all cells are zero."""
        half, low, high = self.ends(place, wo)
        edges = []
        for k in range(PIECES + 1):
            from_middle = abs(k - PIECES // 2)
            share = 1.0 if from_middle == PIECES // 2 else 1 - 0.25**from_middle
            s = half * (share if k >= PIECES // 2 else -share)
            edges.append(dr.maximum(dr.minimum(s, high), low))
        phi = [angle(s, half) for s in edges]
        sums = [self.sum_at(self.row_sums, base, self.column(s, wo)) for s in edges]
        flat = ~(sums[-1] > sums[0])
        masses = []
        for k in range(PIECES):
            width = edges[k + 1] - edges[k]
            there = width > 0
            within = dr.select(flat, width, sums[k + 1] - sums[k])
            masses.append(dr.select(there, within * (phi[k + 1] - phi[k]) / dr.select(there, width, 1), 0))
        return half, edges, phi, sums, masses, flat

    def sample(self, node, wo, u1, u2, active):
        """A direction, and whether there is one."""
        top, bottom, there = self.seen(wo)
        active &= there
        band, rest = choose(self.band_mass(node, top, bottom, wo), *self.band_range(top, bottom, active), u1)
        row, rest = choose(self.row_mass(node, top, bottom, wo), *self.row_range(band, top, bottom, active), rest)
        row = dr.clip(row, 0, self.rows - 1)
        low, high = dr.maximum(mi.Float(row), top), dr.minimum(mi.Float(row) + 1, bottom)
        place = dr.lerp(low, high, rest)
        base = self.row_base(node, row)
        half, edges, phi, sums, masses, flat = self.chord(place, base, wo)
        # A piece in proportion to its mass: unrolled.
        total = sum(masses)
        target, below = u2 * total, mi.Float(0)
        chosen = [mi.Float(x) for x in (0, 1, edges[0], edges[1], phi[0], phi[1], sums[0], sums[1])]
        passed, even = mi.Bool(False), mi.Bool(True)
        for k in range(PIECES):
            some = ~passed & (masses[k] > 0)
            here = [below, masses[k], edges[k], edges[k + 1], phi[k], phi[k + 1], sums[k], sums[k + 1]]
            chosen = [dr.select(some, new, old) for new, old in zip(here, chosen)]
            even = dr.select(some, mi.Bool(k in (0, PIECES - 1)), even)
            below = below + masses[k]
            passed |= some & (target < below)
        rest = dr.clip((target - chosen[0]) / dr.maximum(chosen[1], 1e-37), 0, 1)
        sin, cos = dr.sincos(dr.lerp(chosen[4], chosen[5], rest))
        s = self.first[0] + self.inverse(base, dr.lerp(chosen[6], chosen[7], rest)) * self.step + wo.x
        s = dr.clip(s, chosen[2], chosen[3])
        even |= flat
        x, z = dr.select(even, half * sin, s), dr.select(even, half * cos, dr.safe_sqrt(half * half - s * s))
        return mi.Vector3f(-x, self.wi_y(place, wo), z), active & (total > 0)

    def inverse(self, base, total):
        """The place at which the sum along a row is reached."""
        reached = lambda k: dr.gather(mi.Float, self.row_sums, base + k) <= total
        after = dr.clip(dr.binary_search(0, self.columns, reached), 1, self.columns)
        below = dr.gather(mi.Float, self.row_sums, base + after - 1)
        rise = dr.gather(mi.Float, self.row_sums, base + after) - below
        return mi.Float(after - 1) + dr.select(rise > 0, dr.clip((total - below) / dr.select(rise > 0, rise, 1), 0, 1), 0)

    def pdf(self, node, wi, wo, active):
        """In 1/sr."""
        x = (-wi.x - wo.x - self.first[0]) / self.step
        place = (self.first[1] + wi.y + wo.y) / self.step
        top, bottom, there = self.seen(wo)
        active &= there & (x >= 0) & (x < self.columns) & (place >= 0) & (place < self.rows)
        row = mi.Int32(dr.select(active, place, 0))
        band = row // self.band
        bands, rows = self.band_range(top, bottom, active), self.row_range(band, top, bottom, active)
        height = dr.minimum(mi.Float(row) + 1, bottom) - dr.maximum(mi.Float(row), top)
        for (first, last), at in ((bands, band), (rows, row)):
            active &= (at >= first) & (at <= last)
        active &= height > 0
        base = self.row_base(node, row)
        _, edges, phi, sums, masses, flat = self.chord(dr.select(active, place, 0), base, wo)
        width, mass, within, even = mi.Float(1), mi.Float(0), mi.Float(1), mi.Bool(True)
        for k in range(PIECES):
            # The last piece whose lower edge is not above s.
            below = (edges[k] <= -wi.x) if k > 0 else mi.Bool(True)
            width, mass = dr.select(below, phi[k + 1] - phi[k], width), dr.select(below, masses[k], mass)
            within = dr.select(below, sums[k + 1] - sums[k], within)
            even = dr.select(below, mi.Bool(k in (0, PIECES - 1)), even)
        even |= flat
        cell = mi.UInt32(dr.select(active, x, 0))
        rise = dr.gather(mi.Float, self.row_sums, base + cell + 1) - dr.gather(mi.Float, self.row_sums, base + cell)
        along = dr.select(even, 1 / dr.maximum(width, 1e-12), rise / dr.maximum(within, 1e-37) / self.step * wi.z)
        along *= mass / dr.maximum(sum(masses), 1e-37)
        down = probability(self.band_mass(node, top, bottom, wo), *bands, band)
        down *= probability(self.row_mass(node, top, bottom, wo), *rows, row)
        return dr.select(active & (mass > 0) & (width > 0), along * down / dr.maximum(height, 1e-6) / self.step, 0)


def angle(s, half):
    """phi at `s = half sin phi`."""
    return dr.select(half > 0, dr.asin(dr.clip(s / dr.maximum(half, 1e-12), -1, 1)), 0)


def projection(wo):
    """Unit vector along the viewer's projection, x where it has none, and the projection's length."""
    sin = dr.sqrt(wo.x * wo.x + wo.y * wo.y)
    upright = sin < 1e-9
    safe = dr.select(upright, 1, sin)
    return dr.select(upright, 1, wo.x / safe), dr.select(upright, 0, wo.y / safe), dr.select(upright, 0, sin)


class Sampler:
    """The mixture."""

    def __init__(self, sampler: _sampling.Sampler):
        self.lobe = LobeDensity(sampler.lobe) if sampler.lobe is not None else None
        self.tables = TableDensity(sampler.tables)
        self.shares = mi.Float(sampler.shares.astype(np.float32).ravel())

    def node_and_shares(self, wo):
        node = dr.minimum(mi.UInt32(NODES * dr.safe_sqrt(wo.z)), NODES - 1)
        return node, [dr.gather(mi.Float, self.shares, node * 3 + k) for k in range(3)]

    def sample(self, wo, sample1, sample2, active):
        """A direction to the light for one to the viewer, and whether there is one."""
        node, (even, lobe, _) = self.node_and_shares(wo)
        sin, cos = dr.sincos(2 * dr.pi * sample2.y)
        r = dr.safe_sqrt(1 - sample2.x * sample2.x)
        wi, found = mi.Vector3f(r * cos, r * sin, sample2.x), active & True
        from_lobe, from_tables = (sample1 >= even) & (sample1 < even + lobe), sample1 >= even + lobe
        drawn, there = self.tables.sample(node, wo, sample2.x, sample2.y, active & from_tables)
        wi, found = dr.select(from_tables, drawn, wi), dr.select(from_tables, there, found)
        if self.lobe is not None:
            drawn, there = self.lobe.sample(node, wo, sample2.x, sample2.y)
            wi, found = dr.select(from_lobe, drawn, wi), dr.select(from_lobe, there, found)
        return wi, found & active & (wi.z > 0)

    def pdf(self, wi, wo, active):
        """In 1/sr."""
        node, (even, lobe, tables) = self.node_and_shares(wo)
        value = even * (0.5 * dr.inv_pi) + tables * self.tables.pdf(node, wi, wo, active & True)
        if self.lobe is not None:
            value += lobe * self.lobe.pdf(node, wi, wo)
        return dr.select(active & (wi.z > 0) & (wo.z > 0), value, 0)
