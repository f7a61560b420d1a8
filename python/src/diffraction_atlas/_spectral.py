"""Tables of single wavelengths: the BRDF at every wavelength from the shortest on."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ._images import AtlasError, Layers, chebyshev, normalised_abs_w, read_image
from ._optics import Optics, Vector, factors, image_radius2

#: A wavelength may be this much shorter than the shortest, by rounding.
WAVELENGTH_SLACK = 1e-9


def unpacked(folder: Path, entries: list[dict], count: int, whole: bool = False) -> Layers:
    """Tables that lie three to a file, as layers of one channel."""
    images = [read_image(folder, entry) for entry in entries]
    if len(images) != -(-count // 3):
        raise AtlasError(f"{folder}: {count} tables do not lie in {len(images)} files")
    return Layers([images[n // 3][:, :, n % 3, None] for n in range(count)], whole)


class Dispersion:
    """A refractive index by wavelength: monotone cubics between the wavelengths of a table."""

    def __init__(self, stored: dict):
        self.name = stored.get("name", "the material")
        self.wavelength_nm = np.asarray(stored["wavelength_nm"], float)
        self.n, self.k = (np.asarray(stored[key], float) for key in ("n", "k"))
        if len(self.wavelength_nm) < 2 or np.any(np.diff(self.wavelength_nm) <= 0):
            raise AtlasError(f"the dispersion table of {self.name} must hold two or more wavelengths in ascending order")
        self._slopes = [self._slopes_of(values) for values in (self.n, self.k)]

    def _slopes_of(self, values: NDArray) -> NDArray:
        width, slopes = np.diff(self.wavelength_nm), np.zeros(len(values))
        secant = np.diff(values) / width
        slopes[0], slopes[-1] = secant[0], secant[-1]
        for knot in range(1, len(values) - 1):
            before, after, a, b = secant[knot - 1], secant[knot], width[knot - 1], width[knot]
            if before * after > 0:
                # The harmonic mean of the secants, weighted by (2 b + a, 2 a + b) / 3 (a + b).
                slopes[knot] = 3 * (a + b) / ((2 * b + a) / before + (2 * a + b) / after)
        return slopes

    def index(self, wavelength_nm: NDArray) -> NDArray[np.complex128]:
        """n + i k at wavelengths in nm; a ValueError outside the table."""
        low, high = self.wavelength_nm[[0, -1]]
        if np.any(~((wavelength_nm >= low) & (wavelength_nm <= high))):
            raise ValueError(f"the refractive index of {self.name} is known from {low} to {high} nm only")
        first = np.clip(np.searchsorted(self.wavelength_nm, wavelength_nm, "right") - 1, 0, len(self.n) - 2)
        width = self.wavelength_nm[first + 1] - self.wavelength_nm[first]
        t = (wavelength_nm - self.wavelength_nm[first]) / width
        s = 1 - t
        parts = []
        for values, slopes in zip((self.n, self.k), self._slopes):
            ends = values[first] * (1 + 2 * t) * s * s + values[first + 1] * t * t * (3 - 2 * t)
            parts.append(ends + width * t * s * (slopes[first] * s - slopes[first + 1] * t))
        return parts[0] + 1j * parts[1]


class SpectralTables:
    """The tables of `spectral` in specimen.json."""

    def __init__(self, folder: Path, stored: dict, optics: Optics):
        self.optics = optics
        self.shortest_nm, self.longest_nm = float(stored["shortest_nm"]), float(stored["longest_nm"])
        self.sigma_nm = float(stored["sigma_nm"])
        self.half_height_range_nm = float(stored["half_height_range_nm"])
        self.layers = unpacked(folder, stored["images"], stored["tables"], whole=True)
        self.size = self.layers.columns
        self.dispersion = Dispersion(stored["dispersion"]) if stored.get("dispersion") else None
        lobe = stored.get("lobe")
        self.power = self.cross = None
        if lobe:
            self.power = read_image(folder, lobe["power"])[0, :, 0]
            self.lobe_sigma_nm = float(lobe["sigma_nm"])
            #: Whether it grows in proportion to the wavelength, as under a source of fixed size.
            self.sigma_grows = bool(lobe.get("sigma_grows", False))
            cross = lobe.get("cross")
            if cross:
                self.cross = unpacked(folder, cross["images"], cross["patches"])
                #: Half the side of the patches in (u', v').
                self.cross_radius = float(cross["xi_per_nm"]["last"]) * self.shortest_nm

    def check_wavelengths(self, wavelength_nm: NDArray) -> None:
        """A ValueError for wavelengths that the tables cannot tell of."""
        wrong = ~(np.isfinite(wavelength_nm) & (wavelength_nm >= self.shortest_nm * (1 - WAVELENGTH_SLACK)))
        if wrong.any():
            raise ValueError(
                f"the spectral tables begin at {self.shortest_nm} nm and cannot tell of {wavelength_nm[wrong].flat[0]} nm; "
                "optics.wavelength_nm of the manifest sets where they begin"
            )

    def brdf(self, wi: Vector, wo: Vector, wavelength_nm: NDArray, lookup: str) -> NDArray:
        """(direction, wavelength): the BRDF in 1/sr. `wavelength_nm` has the shape (wavelength,) or (direction, wavelength)."""
        dtype, count = wi[0].dtype, wavelength_nm.shape[-1]
        value = np.zeros((len(wi[0]), count), dtype)
        (above,) = np.nonzero((wi[2] > 0) & (wo[2] > 0))
        if not len(above):
            return value
        nm = wavelength_nm if wavelength_nm.ndim == 1 else wavelength_nm[above]
        wi, wo = (tuple(d[above] for d in direction) for direction in (wi, wo))
        value[above] = self._above(wi, wo, nm, lookup)
        return value

    def front(self, wi: Vector, wo: Vector, nm: NDArray) -> tuple[NDArray, NDArray]:
        """D and C, (direction, 1) or, with dispersion, (direction, wavelength)."""
        pair = [tuple(d[:, None] for d in direction) for direction in (wi, wo)]
        index = None if self.dispersion is None else self.dispersion.index(np.asarray(nm, float))
        return factors(self.optics, *pair, index)

    def _above(self, wi: Vector, wo: Vector, nm: NDArray, lookup: str) -> NDArray:
        dtype = wi[0].dtype
        diffuse_factor, coherent_factor = self.front(wi, wo, nm)
        q = [(-(wi[0] + wo[0]))[:, None], (-(wi[1] + wo[1]))[:, None], (wi[2] + wo[2])[:, None]]
        r = np.minimum(self.shortest_nm / nm, 1).astype(dtype)
        shape = (len(wi[0]), nm.shape[-1])
        u, v, w = (np.ascontiguousarray(np.broadcast_to(r * part, shape)).reshape(-1) for part in q)
        value = self.diffuse(u, v, w, lookup).reshape(shape)
        value *= r**4 * diffuse_factor
        if self.power is not None:
            share, nm = self.lobe_at(nm)
            value += share.astype(dtype) * coherent_factor * self.power_at(w).reshape(shape) * self.shape(wi, wo, q, nm)
        return value

    def lobe_at(self, nm: NDArray) -> tuple[NDArray, NDArray]:
        """What the lobe's power counts at wavelengths, and those at which its form has the width that it has there with `lobe_sigma_nm`."""
        if self.sigma_grows:
            return np.ones_like(nm), np.full_like(nm, self.shortest_nm)
        return np.minimum(self.shortest_nm / nm, 1) ** 2, nm

    def shape(self, wi: Vector, wo: Vector, q: list[NDArray], nm: NDArray) -> NDArray:
        """The lobe's form: Gaussians around the mirror direction and, with the vector factor, its image in the horizon."""
        width2 = ((2 * np.pi * self.lobe_sigma_nm / nm) ** 2).astype(wi[0].dtype)
        form = np.exp(-width2 * (q[0] * q[0] + q[1] * q[1]))
        if self.optics.vector:
            form += np.exp(-width2 * image_radius2(wi, wo)[:, None])
        return form

    def power_at(self, w: NDArray) -> NDArray:
        """The lobe's power at `|w'|`."""
        last = len(self.power) - 1
        at = np.clip(w / 2, 0, 1) * last
        first = np.minimum(at.astype(np.intp), last - 1)
        return self.power[first] + (at - first.astype(w.dtype)) * (self.power[first + 1] - self.power[first])

    def diffuse(self, u: NDArray, v: NDArray, w: NDArray, lookup: str) -> NDArray:
        """Tables and cross term at (u', v', |w'|), arrays of one shape (position,)."""
        half = (self.size - 1) / 4
        t = normalised_abs_w(u * u + v * v, w)
        value = self.layers.look_up(chebyshev(t, self.layers.count), (u + 2) * half, (2 - v) * half, lookup)[:, 0]
        if self.cross is not None:
            value += self.cross_at(u, v, w, t, lookup)
        return value

    def cross_at(self, u: NDArray, v: NDArray, w: NDArray, t: NDArray, lookup: str) -> NDArray:
        """The cross term, over `|w'|`."""
        value, radius = np.zeros_like(u), self.cross_radius
        (inside,) = np.nonzero(np.maximum(np.abs(u), np.abs(v)) < radius)
        if len(inside):
            half = (self.cross.columns - 1) / (2 * radius)
            basis = chebyshev(t[inside], self.cross.count)
            patches = self.cross.look_up(basis, (u[inside] + radius) * half, (radius - v[inside]) * half, lookup)
            value[inside] = patches[:, 0] / w[inside]
        return value
