"""Look-ups of tables in kernels of Dr.Jit."""

import drjit as dr
import mitsuba as mi
import numpy as np


class Layers:
    """Images of one size, in an array that a kernel reads: texel (row, column) of layer n and its channel c stand at
    `((row columns + column) layers + n) 4 + c`; the fourth channel is unused and makes one packet of a texel."""

    def __init__(self, layers, kind):
        """From layers of the package with three channels, for look-ups of a kind; the coefficients where that is by splines."""
        self.rows, self.columns, self.count = layers.rows, layers.columns, layers.count
        self.stencil, texels = ready_for(layers, kind)
        padded = np.zeros((self.rows * self.columns, self.count, 4), np.float32)
        padded[..., :3] = texels.reshape(-1, 3, self.count).transpose(0, 2, 1)
        self.texels = mi.Float(padded.ravel())

    def look_up(self, basis, column, row, active):
        """Sum over n of `basis[n]` times layer n at a position in texels: three channels."""
        total = mi.Vector4f(0)
        for texel, weight in corners(self, column, row):
            corner = mi.Vector4f(0)
            for n, factor in enumerate(basis):
                corner = dr.fma(factor, dr.gather(mi.Vector4f, self.texels, texel * self.count + n, active), corner)
            total = dr.fma(weight, corner, total)
        return mi.Color3f(total.x, total.y, total.z)


class SingleLayers:
    """Images of one channel, four layers to a packet."""

    def __init__(self, layers, kind):
        """From layers of the package with one channel, for look-ups of a kind; the coefficients where that is by splines."""
        self.rows, self.columns, self.count = layers.rows, layers.columns, layers.count
        self.stencil, texels = ready_for(layers, kind)
        self.packets = -(-self.count // 4)
        padded = np.zeros((self.rows * self.columns, 4 * self.packets), np.float32)
        padded[:, : self.count] = texels
        self.texels = mi.Float(padded.ravel())

    def look_up(self, basis, column, row, active):
        """Sum over n of `basis[n]` times layer n at a position in texels."""
        basis = list(basis) + [0.0] * (4 * self.packets - len(basis))
        total = mi.Float(0)
        for texel, weight in corners(self, column, row):
            corner = mi.Float(0)
            for packet in range(self.packets):
                values = dr.gather(mi.Vector4f, self.texels, texel * self.packets + packet, active)
                for n in range(4):
                    if 4 * packet + n < self.count:
                        corner = dr.fma(basis[4 * packet + n], values[n], corner)
            total = dr.fma(weight, corner, total)
        return total


def ready_for(layers, kind):
    """The stencil of a kind of look-up, and the texels that it reads. Splines go through whole images; others are looked up by cubics."""
    if kind == "linear" or min(layers.rows, layers.columns) < 4:
        return linear_stencil, layers.texels
    if kind == "spline" and layers.whole:
        return spline_stencil, layers.splines()
    return cubic_stencil, layers.texels


def corners(image, column, row):
    """Numbers of the texels around a position, and their weights."""
    across, down = image.stencil(column, image.columns), image.stencil(row, image.rows)
    for y, weight_y in down:
        for x, weight_x in across:
            yield y * image.columns + x, weight_x * weight_y


# Stencils: texels and their weights along an axis of `count` texels, at a position in texels from the first one's centre.


def linear_stencil(at, count):
    at = dr.clip(at, 0.0, count - 1.0)
    first = dr.minimum(mi.UInt32(at), count - 2)
    x = at - mi.Float(first)
    return [(first, 1 - x), (first + 1, x)]


def cubic_stencil(at, count):
    at = dr.clip(at, 0.0, count - 1.0)
    first = mi.UInt32(dr.clip(mi.Int32(at) - 1, 0, count - 4))
    x = at - mi.Float(first)
    # Lagrange's cubic through the nodes 0, 1, 2, 3.
    a, b, c = x - 1, x - 2, x - 3
    weights = -a * b * c / 6, x * b * c / 2, -x * a * c / 2, x * a * b / 6
    return [(first + k, weight) for k, weight in enumerate(weights)]


def spline_stencil(at, count):
    """Of coefficients, mirrored at the ends of the axis."""
    at = dr.clip(at, 0.0, count - 1.0)
    whole = mi.Int32(at)
    f = at - mi.Float(whole)
    g = 1 - f
    weights = g * g * g / 6, 2 / 3 - f * f + f * f * f / 2, 2 / 3 - g * g + g * g * g / 2, f * f * f / 6
    index = [dr.abs(whole + (k - 1)) for k in range(4)]
    return [(mi.UInt32(dr.minimum(k, 2 * (count - 1) - k)), weight) for k, weight in zip(index, weights)]


def linear(array, at, count, active=True):
    """Linear between entries of an array, at a position in entries."""
    return sum(weight * dr.gather(mi.Float, array, entry, active) for entry, weight in linear_stencil(at, count))


def chebyshev(x, count):
    """`T_0` to `T_(count - 1)` at x."""
    values = [0 * x + 1, x]
    while len(values) < count:
        values.append(2 * x * values[-1] - values[-2])
    return values[:count]


def normalised(radius2, w):
    """`t = |w| / sqrt(4 - u^2 - v^2)`, at most 1."""
    reach2 = 4 - radius2
    return dr.select(reach2 > 0, dr.minimum(w * dr.rsqrt(dr.maximum(reach2, 1e-12)), 1), 0)
