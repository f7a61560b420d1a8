"""Look-ups of tables in kernels of Dr.Jit."""

import drjit as dr
import mitsuba as mi
import numpy as np


class Layers:
    """Images of one size, in an array that a kernel reads: texel (row, column) of layer n and its channel c stand at
    `((row columns + column) layers + n) 4 + c`; the fourth channel is unused and makes one packet of a texel."""

    def __init__(self, layers):
        """From layers of the package with three channels."""
        self.rows, self.columns, self.count = layers.rows, layers.columns, layers.count
        padded = np.zeros((self.rows * self.columns, self.count, 4), np.float32)
        padded[..., :3] = layers.texels.reshape(-1, 3, self.count).transpose(0, 2, 1)
        self.texels = mi.Float(padded.ravel())

    def look_up(self, basis, column, row, cubic, active):
        """Sum over n of `basis[n]` times layer n at a position in texels: three channels."""
        total = mi.Vector4f(0)
        for texel, weight in corners(self, column, row, cubic):
            corner = mi.Vector4f(0)
            for n, factor in enumerate(basis):
                corner = dr.fma(factor, dr.gather(mi.Vector4f, self.texels, texel * self.count + n, active), corner)
            total = dr.fma(weight, corner, total)
        return mi.Color3f(total.x, total.y, total.z)


class SingleLayers:
    """Images of one channel, four layers to a packet."""

    def __init__(self, layers):
        """From layers of the package with one channel."""
        self.rows, self.columns, self.count = layers.rows, layers.columns, layers.count
        self.packets = -(-self.count // 4)
        padded = np.zeros((self.rows * self.columns, 4 * self.packets), np.float32)
        padded[:, : self.count] = layers.texels
        self.texels = mi.Float(padded.ravel())

    def look_up(self, basis, column, row, cubic, active):
        """Sum over n of `basis[n]` times layer n at a position in texels."""
        basis = list(basis) + [0.0] * (4 * self.packets - len(basis))
        total = mi.Float(0)
        for texel, weight in corners(self, column, row, cubic):
            corner = mi.Float(0)
            for packet in range(self.packets):
                values = dr.gather(mi.Vector4f, self.texels, texel * self.packets + packet, active)
                for n in range(4):
                    if 4 * packet + n < self.count:
                        corner = dr.fma(basis[4 * packet + n], values[n], corner)
            total = dr.fma(weight, corner, total)
        return total


def corners(image, column, row, cubic):
    """Numbers of the texels around a position, and their weights."""
    first_column, across = stencil(column, image.columns, cubic)
    first_row, down = stencil(row, image.rows, cubic)
    for dy, weight_y in enumerate(down):
        for dx, weight_x in enumerate(across):
            yield (first_row + dy) * image.columns + first_column + dx, weight_x * weight_y


def stencil(at, count, cubic):
    """First texel and weights along an axis of `count` texels, at a position in texels from the first one's centre."""
    at = dr.clip(at, 0.0, count - 1.0)
    if not cubic or count < 4:
        first = dr.minimum(mi.UInt32(at), count - 2)
        x = at - mi.Float(first)
        return first, (1 - x, x)
    first = mi.UInt32(dr.clip(mi.Int32(at) - 1, 0, count - 4))
    x = at - mi.Float(first)
    # Lagrange's cubic through the nodes 0, 1, 2, 3.
    a, b, c = x - 1, x - 2, x - 3
    return first, (-a * b * c / 6, x * b * c / 2, -x * a * c / 2, x * a * b / 6)


def linear(array, at, count, active=True):
    """Linear between entries of an array, at a position in entries."""
    first, weights = stencil(at, count, False)
    return sum(weight * dr.gather(mi.Float, array, first + n, active) for n, weight in enumerate(weights))


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
