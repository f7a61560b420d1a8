"""The BRDF in kernels of Dr.Jit, as FORMAT.md tells: X, Y, Z, and single wavelengths."""

import drjit as dr
import mitsuba as mi
import numpy as np

from .._tables import RANGE_SLACK
from ._lookup import Layers, SingleLayers, chebyshev, linear, normalised

#: Entries of the energy limit over the root of the cosine.
LIMIT_NODES = 1025
#: Entries of a dispersion table, even in wavelength.
INDEX_NODES = 2049
#: Rings and points per ring that stand for a light's disc.
RINGS, POINTS_PER_RING = 4, 8


class Optics:
    """The factors in front."""

    def __init__(self, optics):
        self.vector, self.shadowing = optics.vector, optics.shadowing
        self.n = self.k = None
        if optics.index is not None:
            self.n = mi.Float(optics.index.real)
            self.k = mi.Float(optics.index.imag) if optics.index.imag else None

    def parameters(self):
        return {name: value for name, value in (("n", self.n), ("k", self.k)) if value is not None}

    def factors(self, wi, wo, n=None, k=None):
        """D in front of tables and cross term, C in front of the lobe; `n` and `k` in place of the material's."""
        n, k = (self.n, self.k) if n is None else (n, k)
        one_plus = 1 + dr.dot(wi, wo)
        mirror = reflectance(n, k, dr.safe_sqrt(one_plus / 2))
        w = wi.z + wo.z
        geometry = (one_plus / wi.z) * (one_plus / wo.z)
        coherent = mirror if self.vector else mirror * geometry / w / w
        diffuse = 2 * wi.z * wo.z * polarised_sum(n, k, wi, wo) if self.vector and n is not None else mirror * geometry
        if self.shadowing:
            m = dr.normalize(wi + wo)
            shadowing = dr.minimum(1, 2 * m.z / dr.dot(wo, m) * dr.minimum(wi.z, wo.z))
            diffuse, coherent = diffuse * shadowing, coherent * shadowing
        return diffuse, coherent


def squares(n, k):
    """The dielectric constant, real where nothing is absorbed, and the operations that go with it."""
    if k is None:
        return n * n, dr.safe_sqrt, lambda x: x * x
    return mi.Complex2f(n * n - k * k, 2 * n * k), dr.sqrt, dr.squared_norm


def reflectance(n, k, c):
    """Fresnel's, of unpolarised light; c is the cosine at the half vector."""
    if n is None:
        return mi.Float(1)
    eps, root, norm = squares(n, k)
    g = root(eps - 1 + c * c)
    return (norm((c - g) / (c + g)) + norm((eps * c - g) / (eps * c + g))) / 2


def polarised_sum(n, k, wi, wo):
    """`Q_ss + Q_sp + Q_ps + Q_pp` of first-order vector perturbation; the azimuth is 0 on the mirror's side."""
    eps, root, norm = squares(n, k)
    sine2_i, sine2_o = (d.x * d.x + d.y * d.y for d in (wi, wo))
    sines2 = sine2_i * sine2_o
    known = sines2 > 1e-24
    # The root's derivative has no bound at 0.
    sines = dr.select(known, dr.sqrt(dr.select(known, sines2, 1)), 0)
    lateral = -(wi.x * wo.x + wi.y * wo.y)
    cos_phi = dr.select(known, dr.clip(lateral / dr.select(known, sines, 1), -1, 1), 1)
    sin2_phi = 1 - cos_phi * cos_phi
    a, b = root(eps - sine2_i), root(eps - sine2_o)
    s_i, s_o = norm(a + wi.z), norm(b + wo.z)
    p_i, p_o = norm(eps * wi.z + a), norm(eps * wo.z + b)
    across = norm(a * b * cos_phi - eps * sines) / (p_i * p_o)
    crossed = norm(b) / (s_i * p_o) + norm(a) / (p_i * s_o)
    return norm(eps - 1) * (cos_phi * cos_phi / (s_i * s_o) + sin2_phi * crossed + across)


def image_radius2(wi, wo):
    """Square of the distance of the lobe's mirror image in the horizon."""
    lateral = wi + wo
    to_horizon = [d.z * d.z / (1 + safe_length(d.x, d.y)) for d in (wi, wo)]
    return lateral.x * lateral.x + lateral.y * lateral.y + 4 * to_horizon[0] * to_horizon[1]


def safe_length(x, y):
    """Length of (x, y), whose derivative is 0 at 0."""
    length2 = x * x + y * y
    some = length2 > 0
    return dr.select(some, dr.sqrt(dr.select(some, length2, 1)), 0)


class Disc:
    """A light's disc as points, each of which stands for as large a part of it."""

    def __init__(self, light_deg):
        self.sine = float(np.sin(np.radians(light_deg) / 2))
        ring, k = np.divmod(np.arange(RINGS * POINTS_PER_RING), POINTS_PER_RING)
        radius, angle = np.sqrt((ring + 0.5) / RINGS), (k + 0.618 * ring) / POINTS_PER_RING * 2 * np.pi
        self.points = [mi.Float((radius * of(angle)).astype(np.float32)) for of in (np.cos, np.sin)]

    def over_points(self, value, zero, width):
        """Mean of `value(p, s)` over the points, from `zero` of its type: in a loop, since kernels that hold all of them one after the other take
        minutes to compile."""
        count = dr.width(self.points[0])

        def step(k, total):
            p, s = (dr.gather(mi.Float, part, k) for part in self.points)
            return k + 1, total + value(p, s)

        start = dr.zeros(mi.UInt32, width), zero
        _, total = dr.while_loop(start, lambda k, _: k < count, step, mode="symbolic", max_iterations=count, label="points of a light")
        return total / count

    def mean(self, wi, u, v, w, value, zero):
        """Mean of `value(u, v, |w|)` over the disc around `wi`, at the centre's t."""
        t = normalised(u * u + v * v, w)
        # The disc is an ellipse in (u, v): its axis along the plane of incidence is shorter by the cosine.
        length = safe_length(wi.x, wi.y)
        along = dr.select(length > 0, wi.x / dr.select(length > 0, length, 1), 1), dr.select(length > 0, wi.y / dr.select(length > 0, length, 1), 0)

        def at(p, s):
            p, s = p * self.sine * wi.z, s * self.sine
            x, y = u + along[0] * p - along[1] * s, v + along[1] * p + along[0] * s
            inwards = dr.minimum(1, 1.999999 * dr.rsqrt(dr.maximum(x * x + y * y, 1e-12)))
            x, y = x * inwards, y * inwards
            return value(x, y, t * dr.safe_sqrt(4 - x * x - y * y))

        return self.over_points(at, zero, dr.width(u, v, w))

    def mean_of_image(self, wi, wo, value, zero):
        """Mean of `value(radius^2)` over the ellipse around the lobe's image in the horizon; see `_means.LobeEllipses.image`."""
        x, y = wo.x - wi.x, wo.y - wi.y
        length = safe_length(x, y)
        some = length > 0
        x, y = dr.select(some, x / dr.select(some, length, 1), 1), dr.select(some, y / dr.select(some, length, 1), 0)
        along = (wi.y + wo.y) * x - (wi.x + wo.x) * y
        across = dr.safe_sqrt(image_radius2(wi, wo) - along * along)
        lateral = wi.x * x + wi.y * y, wi.y * x - wi.x * y
        semi = [self.sine * dr.safe_sqrt(1 - part * part) for part in lateral]

        def at(p, s):
            a, b = across + semi[0] * p, along + semi[1] * s
            return value(a * a + b * b)

        return self.over_points(at, zero, dr.width(along, across))


class Colours:
    """The tables of X, Y, Z."""

    def __init__(self, specimen, look_up, light_deg):
        tables = specimen._tables
        self.optics = Optics(tables.optics)
        self.disc = Disc(light_deg) if light_deg else None
        self.basis, self.size, self.first = tables.basis, tables.size, tables.first
        self.tables = Layers(tables.layers, look_up)
        self.range = Layers(tables.range, look_up) if tables.range is not None else None
        self.coherent = self.cross = None
        if tables.lobe is not None:
            self.radius_max = tables.lobe.radius_max
            self.coherent = Layers(tables.lobe.coherent, look_up)
            self.cross = Layers(tables.lobe.cross, look_up) if tables.lobe.cross is not None else None

    def parameters(self):
        """What `mi.traverse` shows."""
        named = {**self.optics.parameters(), "tables": self.tables.texels}
        if self.coherent is not None:
            named["lobe"] = self.coherent.texels
        return named

    def value(self, wi, wo, _, active):
        """X, Y, Z in 1/sr; NaN where the tables have no answer."""
        front, coherent = self.optics.factors(wi, wo)
        q = -(wi + wo)
        if self.disc is None:
            return front * self.diffuse(q.x, q.y, -q.z, active) + coherent * self.lobe(wi, wo, active)
        # The light is the direction that Mitsuba gives as `wo`.
        return front * self.disc.mean(
            wo, q.x, q.y, -q.z, lambda u, v, w: self.diffuse(u, v, w, active), mi.Color3f(0)
        ) + coherent * self.lobe_mean(wi, wo, active)

    def answers(self, wi, wo, active):
        """Whether the tables answer."""
        q = -(wi + wo)
        return dr.isfinite(self.diffuse(q.x, q.y, -q.z, active).y)

    def position(self, u, v):
        """Column and row in texels."""
        half = (self.size - 1) / 4
        return (u + 2) * half - self.first[0], (2 - v) * half - self.first[1]

    def diffuse(self, u, v, w, active):
        """Tables and cross term without their factor."""
        column, row = self.position(u, v)
        if self.basis == "taylor":
            powers = [1 / w / w]
            while len(powers) < self.tables.count:
                powers.append(powers[-1] * w)
            return self.tables.look_up(powers, column, row, active)
        t = normalised(u * u + v * v, w)
        s, covered = t, True
        if self.range is not None:
            s, covered = self.share_of_range(t, column, row, active)
        value = self.tables.look_up(chebyshev(2 * s - 1, self.tables.count), column, row, active)
        if self.cross is not None:
            value += self.cross_term(u, v, w, t, active)
        return dr.select(covered, value, dr.nan)

    def share_of_range(self, t, column, row, active):
        """Where t lies in the range that the texels cover, 0 to 1, and whether there is an answer."""
        low, high, there = self.range.look_up([1.0], column, row, active)
        s = (t - low) / (high - low)
        inside = (column >= 0) & (column <= self.range.columns - 1) & (row >= 0) & (row <= self.range.rows - 1)
        covered = inside & (dr.abs(there - 1) < 0.002) & (s >= -RANGE_SLACK) & (s <= 1 + RANGE_SLACK)
        return dr.clip(s, 0, 1), covered

    def cross_term(self, u, v, w, t, active):
        r, half = self.radius_max, (self.cross.columns - 1) / (2 * self.radius_max)
        inside = active & (dr.maximum(dr.abs(u), dr.abs(v)) < r)
        basis = chebyshev(2 * t - 1, self.cross.count)
        value = self.cross.look_up(basis, (u + r) * half, (r - v) * half, inside) / w
        return dr.select(inside, value, 0.0)

    def lobe(self, wi, wo, active):
        """The coherent lobe without its factor and, with the vector factor, its mirror image in the horizon."""
        if self.coherent is None:
            return mi.Color3f(0)
        w = wi.z + wo.z
        value = self.lobe_at(safe_length(wi.x + wo.x, wi.y + wo.y), w, active)
        if self.optics.vector:
            value += self.lobe_at(dr.safe_sqrt(image_radius2(wi, wo)), w, active)
        return value

    def lobe_at(self, radius, w, active, t=None):
        inside = active & (radius < self.radius_max)
        t = normalised(radius * radius, w) if t is None else t
        column, row = radius * ((self.coherent.columns - 1) / self.radius_max), t * (self.coherent.rows - 1)
        return dr.select(inside, self.coherent.look_up([1.0], column, row, inside), 0.0)

    def lobe_mean(self, wi, wo, active):
        """The same over a light's disc, at the centre's t."""
        if self.coherent is None:
            return mi.Color3f(0)
        u, v, w = -(wi.x + wo.x), -(wi.y + wo.y), wi.z + wo.z
        t = normalised(u * u + v * v, w)
        value = self.disc.mean(wo, u, v, w, lambda u, v, w: self.lobe_at(safe_length(u, v), w, active, t), mi.Color3f(0))
        if self.optics.vector:
            t = normalised(image_radius2(wi, wo), w)
            value += self.disc.mean_of_image(wo, wi, lambda radius2: self.lobe_at(dr.safe_sqrt(radius2), w, active, t), mi.Color3f(0))
        return value


class Spectral:
    """The tables of single wavelengths."""

    def __init__(self, specimen, look_up, light_deg):
        tables = specimen._spectral_tables
        self.optics = Optics(tables.optics)
        self.disc = Disc(light_deg) if light_deg else None
        self.size, self.shortest_nm = tables.size, tables.shortest_nm
        self.tables = SingleLayers(tables.layers, look_up)
        self.cross = SingleLayers(tables.cross, look_up) if tables.cross is not None else None
        self.cross_radius = tables.cross_radius if tables.cross is not None else 0.0
        self.power = None
        if tables.power is not None:
            self.power, self.power_count = mi.Float(tables.power), len(tables.power)
            self.sigma_nm = tables.lobe_sigma_nm
        self.index = None
        if tables.dispersion is not None:
            self.index_range = tables.dispersion.wavelength_nm[[0, -1]].tolist()
            index = tables.dispersion.index(np.linspace(*self.index_range, INDEX_NODES))
            self.index = [mi.Float(part.astype(np.float32)) for part in (index.real, index.imag)]
            self.absorbs = bool(index.imag.any())

    def parameters(self):
        """What `mi.traverse` shows."""
        named = {"tables": self.tables.texels}
        if self.index is None:
            named.update(self.optics.parameters())
        if self.power is not None:
            named["lobe"] = self.power
        return named

    def answers(self, *_):
        """Spectral tables answer for every direction."""
        return mi.Bool(True)

    def value(self, wi, wo, wavelengths, active):
        """The BRDF in 1/sr at the wavelengths of the rays."""
        q = -(wi + wo)
        plain = self.optics.factors(wi, wo) if self.index is None else None
        image2 = image_radius2(wi, wo)
        value = mi.Spectrum(0)
        for k in range(len(value)):
            nm = dr.maximum(wavelengths[k], self.shortest_nm)
            front, coherent = plain or self.factors_at(wi, wo, nm)
            r = self.shortest_nm / nm
            u, v, w = r * q.x, r * q.y, -r * q.z
            if self.disc is None:
                diffuse = self.diffuse(u, v, w, active)
            else:
                diffuse = self.disc.mean(
                    wo, q.x, q.y, -q.z, lambda x, y, z: self.diffuse(r * x, r * y, r * z, active), mi.Float(0)
                )
            part = r * r * r * r * front * diffuse
            if self.power is not None:
                part += r * r * coherent * self.power_at(w, active) * self.form(wi, wo, q, image2, nm)
            value[k] = part
        return value

    def factors_at(self, wi, wo, nm):
        low, high = self.index_range
        at = (dr.clip(nm, low, high) - low) * ((INDEX_NODES - 1) / (high - low))
        n, k = (linear(part, at, INDEX_NODES) for part in self.index)
        return self.optics.factors(wi, wo, n, k if self.absorbs else None)

    def form(self, wi, wo, q, image2, nm):
        """The lobe's form around the mirror direction and its image."""
        width2 = dr.square(2 * dr.pi * self.sigma_nm / nm)
        if self.disc is None:
            form = dr.exp(-width2 * (q.x * q.x + q.y * q.y))
            return form + dr.exp(-width2 * image2) if self.optics.vector else form
        form = self.disc.mean(wo, q.x, q.y, -q.z, lambda u, v, w: dr.exp(-width2 * (u * u + v * v)), mi.Float(0))
        if self.optics.vector:
            form += self.disc.mean_of_image(wo, wi, lambda radius2: dr.exp(-width2 * radius2), mi.Float(0))
        return form

    def power_at(self, w, active):
        return linear(self.power, dr.clip(w / 2, 0, 1) * (self.power_count - 1), self.power_count, active)

    def diffuse(self, u, v, w, active):
        """Tables and cross term at (u', v', |w'|)."""
        half, x = (self.size - 1) / 4, 2 * normalised(u * u + v * v, w) - 1
        value = self.tables.look_up(chebyshev(x, self.tables.count), (u + 2) * half, (2 - v) * half, active)
        if self.cross is not None:
            r = self.cross_radius
            half = (self.cross.columns - 1) / (2 * r)
            inside = active & (dr.maximum(dr.abs(u), dr.abs(v)) < r)
            patches = self.cross.look_up(chebyshev(x, self.cross.count), (u + r) * half, (r - v) * half, inside)
            value += dr.select(inside, patches / w, 0.0)
        return value


class Limit:
    """The energy limit."""

    def __init__(self, specimen):
        limit = specimen._limit
        places = np.linspace(0.0, 1.0, LIMIT_NODES) ** 2
        product = np.interp(places, limit.cos_theta, limit.albedo * limit.cos_theta)
        #: `albedo cos_theta` at even steps of the root of the cosine.
        self.product = mi.Float(product.astype(np.float32))

    def factor(self, wi, wo, active):
        """What the BRDF is multiplied by."""
        return 1 / dr.maximum(1, dr.maximum(self.albedo(wi.z, active), self.albedo(wo.z, active)))

    def albedo(self, cos_theta, active):
        return linear(self.product, dr.safe_sqrt(cos_theta) * (LIMIT_NODES - 1), LIMIT_NODES, active) / dr.maximum(cos_theta, 1e-9)
