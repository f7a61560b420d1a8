"""Illuminants and the CIE 1931 observer: from spectral values to X, Y, Z."""

from __future__ import annotations

import csv
from functools import lru_cache
from importlib import resources
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._images import AtlasError
from ._spectral import SpectralTables

#: Distance of the wavenumbers at which values are looked up, in standard deviations of the narrowest pulse that a direction's
#: spectrum may hold.
NODE_STEP = 0.5
#: Fewest wavelengths of a continuous light.
NODES_MIN = 24
#: Nodes that an interpolating polynomial goes through: in the middle, and where one side has fewer.
THROUGH, THROUGH_AT_ENDS = 16, 6
#: Gauss points to a cell over which light and observer are summed.
POINTS = 8
#: Radii in (u, v) within which one set of wavelengths serves.
RING_RATIO, RADIUS_MIN = np.sqrt(2.0), 0.02


class Lines:
    """A light of single lines, such as lasers: a plain sum over them.

    `wavelength_nm` and `power` have the shape (lines,); the power is relative.
    """

    def __init__(self, wavelength_nm: ArrayLike, power: ArrayLike = 1.0):
        nm, power = np.broadcast_arrays(np.atleast_1d(np.asarray(wavelength_nm, float)), np.asarray(power, float))
        if nm.ndim != 1 or not np.all(np.isfinite(nm) & (nm > 0)) or not np.all(np.isfinite(power) & (power >= 0)):
            raise ValueError("lines need wavelengths in nm above 0 and powers that are not negative, both of shape (lines,)")
        self.wavelength_nm, self.power = nm, power


#: What is taken for a light: a name ("D65", "A", "E", "F1" to "F12"), wavelengths in nm with their relative power, or lines.
Illuminant = Union[str, tuple[ArrayLike, ArrayLike], Lines]


def light_of(stored: Any) -> Illuminant:
    """A light as specimen.json states it, in the form that is taken here."""
    if isinstance(stored, str):
        return stored.upper()
    ((kind, of),) = stored.items()
    if kind == "f":
        return f"F{of}"
    if kind == "tabulated":
        return np.asarray(of["wavelength_nm"], float), np.asarray(of["power"], float)
    if kind == "lines":
        return Lines(*([line[key] for line in of] for key in ("wavelength_nm", "power")))
    raise AtlasError(f'specimen.json names the light "{kind}", which this version does not know')


@lru_cache(maxsize=None)
def _table(name: str) -> dict[str, NDArray]:
    text = (resources.files(__package__) / name).read_text()
    rows = list(csv.reader(line for line in text.splitlines() if not line.startswith("#")))
    columns = zip(*rows[1:])
    return {key: np.array([float(x) if x else np.nan for x in column]) for key, column in zip(rows[0], columns)}


def observer(wavelength_nm: ArrayLike) -> NDArray[np.float64]:
    """Colour-matching functions of the CIE 1931 observer, 2 degrees: shape (..., 3), 0 outside 360 to 830 nm."""
    table = _table("cie_observer_1931_2deg.csv")
    return np.stack([np.interp(wavelength_nm, table["nm"], table[c], 0, 0) for c in "xyz"], axis=-1)


def power_at(illuminant: Illuminant, wavelength_nm: ArrayLike) -> NDArray[np.float64]:
    """Relative spectral power of a continuous light: linear between the values of its table, 0 outside."""
    nm = np.asarray(wavelength_nm, float)
    if isinstance(illuminant, Lines):
        raise ValueError("lines have no power per nanometre")
    if not isinstance(illuminant, str):
        at, power = (np.asarray(part, float) for part in illuminant)
        if at.ndim != 1 or at.shape != power.shape or len(at) < 2 or np.any(np.diff(at) <= 0):
            raise ValueError("a light's table needs two or more ascending wavelengths in nm, and as many powers")
        if not (np.isfinite(at).all() and np.isfinite(power).all() and (power >= 0).all()):
            raise ValueError("a light's table must hold finite numbers, and powers that are not negative")
        return np.interp(nm, at, power, 0, 0)
    name, table = illuminant.upper(), _table("cie_lights.csv")
    if name == "E":
        return np.ones_like(nm)
    if name == "A":
        # ISO 11664-2: Planck's law at 2848 K with c2 = 1.435e-2 m K.
        planck = lambda nm: np.expm1(1.435e7 / (2848.0 * nm))
        return 100 * (560.0 / nm) ** 5 * planck(560.0) / planck(nm)
    if name not in table or name == "NM":
        raise ValueError(
            f'there is no light "{illuminant}" here; there are "D65", "A", "E", "F1" to "F12", a pair of arrays (wavelength_nm, power), '
            "and Lines(wavelength_nm, power)"
        )
    known = np.isfinite(table[name])
    return np.interp(nm, table["nm"][known], table[name][known], 0, 0)


class Quadrature:
    """Wavelengths in nm and their weights for X, Y, Z; the sum over weights has Y = 1."""

    def __init__(self, wavelength_nm: NDArray, weights: NDArray):
        luminous = weights[:, 1].sum()
        if not (np.isfinite(luminous) and luminous > 0):
            raise ValueError("the eye does not see this light within the wavelengths of the tables; X, Y, Z need some luminance")
        self.wavelength_nm, self.weights = wavelength_nm, weights / luminous


def fine(illuminant: Illuminant, range_nm: tuple[float, float], widest_nm: float = 1.0) -> Quadrature:
    """Light and observer as they are, in cells no wider than asked for: what every other sum is to be equal to."""
    if isinstance(illuminant, Lines):
        return Quadrature(illuminant.wavelength_nm, illuminant.power[:, None] * observer(illuminant.wavelength_nm))
    low, high = range_nm
    knots = [np.arange(np.ceil(low), np.floor(high) + 1), [low, high]]
    if not isinstance(illuminant, str):
        at = np.asarray(illuminant[0], float)
        knots.append(at[(at > low) & (at < high)])
    parts = max(1, int(np.ceil(1 / widest_nm)))
    knots = np.unique(np.concatenate(knots))
    edges = np.concatenate([np.linspace(a, b, parts, endpoint=False) for a, b in zip(knots, knots[1:])] + [knots[-1:]])
    # Between knots light and observer are straight lines: eight points of Gauss hold their product with a polynomial of degree 13.
    place, share = np.polynomial.legendre.leggauss(POINTS)
    width = np.diff(edges)[:, None] / 2
    nm = ((edges[:-1] + edges[1:])[:, None] / 2 + width * place).ravel()
    return Quadrature(nm, (width * share).ravel()[:, None] * power_at(illuminant, nm)[:, None] * observer(nm))


def by_wavenumbers(illuminant: Illuminant, range_nm: tuple[float, float], deviation: float) -> Quadrature:
    """Few wavelengths, even in 1/nm, for values that vary in 1/nm no faster than Gaussian pulses of a deviation.

    Values between the nodes are taken for those of polynomials through the nodes around, which are summed against light and
    observer as these are, with all their kinks and lines.
    """
    if isinstance(illuminant, Lines):
        return fine(illuminant, range_nm)
    low, high = 1 / range_nm[1], 1 / range_nm[0]
    count = max(NODES_MIN, int(np.ceil((high - low) / (NODE_STEP * deviation))) + 1)
    exact = fine(illuminant, range_nm, (high - low) / (count - 1) * range_nm[0] ** 2)
    place = (1 / exact.wavelength_nm - low) / ((high - low) / (count - 1))
    below = np.clip(place.astype(int) + 1, 1, count - 1)
    through = np.minimum(np.clip(2 * np.minimum(below, count - below), THROUGH_AT_ENDS, THROUGH), count)
    first = np.clip(below - through // 2, 0, count - through)
    weights = np.zeros((count, 3))
    for points in np.unique(through):
        those = through == points
        local = (place - first)[those, None]
        nodes = np.arange(points)
        # Lagrange: the product of (x - m) / (n - m) over the other nodes m.
        cardinals = np.stack(
            [np.prod((local - np.delete(nodes, n)) / (n - np.delete(nodes, n)), axis=1) for n in nodes], axis=1
        )
        for n in nodes:
            np.add.at(weights, first[those] + n, cardinals[:, n, None] * exact.weights[those])
    wavelength_nm = 1 / (low + (high - low) * np.arange(count) / (count - 1))
    wavelength_nm[-1] = range_nm[0]
    return Quadrature(wavelength_nm, weights)


class UnderLight:
    """What wavelengths to sum for a light, by the distance from the mirror direction in (u, v)."""

    def __init__(self, tables: SpectralTables, illuminant: Illuminant):
        if isinstance(illuminant, Lines):
            tables.check_wavelengths(illuminant.wavelength_nm)
        range_nm = (tables.shortest_nm, tables.longest_nm)
        self.inner: list[float] = []
        self.quadratures: list[Quadrature] = []
        outer = 2.0
        while not self.inner or self.inner[-1] > 0:
            inner = 0.0 if outer < RADIUS_MIN or isinstance(illuminant, Lines) else outer / RING_RATIO
            # A spectrum is a sum of waves in 1/nm: the coherence window and the relief limit how fast.
            window = np.sqrt(2) * 2 * np.pi * tables.sigma_nm * outer
            relief = 2 * np.pi * tables.half_height_range_nm * np.sqrt(max(4 - inner * inner, 0))
            self.quadratures.append(by_wavenumbers(illuminant, range_nm, 1 / np.hypot(window, relief)))
            self.inner.append(inner)
            outer = inner

    def ring(self, radius: NDArray) -> NDArray:
        """Number of the ring that a radius lies in."""
        return np.argmax(radius[:, None] >= np.array(self.inner), axis=1)
