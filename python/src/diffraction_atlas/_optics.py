"""The factors in front of the tables: how strongly the surface reflects from one direction into another.

Directions are triples of arrays of one shape, unit vectors above the surface.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Vector = tuple[NDArray, NDArray, NDArray]


class Optics(NamedTuple):
    """`optics` of specimen.json, as far as the factors need it."""

    #: Whether the factor is first-order vector perturbation rather than R G.
    vector: bool
    #: Whether V-cavity shadowing is applied.
    shadowing: bool
    #: The refractive index n + i k; None for an ideal reflector.
    index: complex | None


def read_optics(about: dict) -> Optics:
    """From `optics` of specimen.json."""
    material, index = about["material"], None
    if material != "ideal":
        ((kind, numbers),) = material.items()
        if kind not in ("dielectric", "conductor"):
            raise ValueError(f'specimen.json names the material "{kind}", which this version does not know')
        index = complex(numbers["n"], numbers.get("k", 0.0))
    factor = about.get("factor", "scalar")
    if factor not in ("vector", "scalar"):
        raise ValueError(f'specimen.json names the factor "{factor}", which this version does not know')
    return Optics(factor == "vector", bool(about["shadowing"]), index)


def factors(optics: Optics, wi: Vector, wo: Vector, index: complex | NDArray | None = None) -> tuple[NDArray, NDArray]:
    """D, in front of tables and cross term, and C, in front of the lobe, both without unit.

    `index` stands in place of the material's where a dispersion table gives it by wavelength: one number, or an array that goes with
    the directions.
    """
    if index is None:
        index = optics.index
    z_i, z_o = wi[2], wo[2]
    one_plus = 1 + (wi[0] * wo[0] + wi[1] * wo[1] + z_i * z_o)
    mirror = reflectance(index, np.sqrt(np.maximum(one_plus, 0) / 2))
    geometry = one_plus * one_plus / (z_i * z_o)
    coherent = mirror if optics.vector else mirror * geometry / (z_i + z_o) ** 2
    if optics.vector and index is not None:
        diffuse = vector_factor(index, wi, wo)
    else:
        diffuse = mirror * geometry
    if optics.shadowing:
        shadow = shadowing(wi, wo)
        diffuse, coherent = diffuse * shadow, coherent * shadow
    return diffuse, coherent


def reflectance(index: complex | NDArray | None, c: NDArray) -> NDArray:
    """Fresnel's, of unpolarised light, at the cosine `c`."""
    if index is None:
        return np.ones_like(c)
    c = np.clip(c, 0, 1)
    if np.isrealobj(index) or not np.any(np.imag(index)):
        n2 = np.real(index) ** 2
        if np.all(n2 >= 1):
            g = np.sqrt(n2 - 1 + c * c)
            a, b = (c - g) / (c + g), (n2 * c - g) / (n2 * c + g)
            return (a * a + b * b) / 2
    n2 = _as_precise(index, c) ** 2
    g = np.sqrt(n2 - 1 + c * c)
    a, b = (c - g) / (c + g), (n2 * c - g) / (n2 * c + g)
    return (_squared(a) + _squared(b)) / 2


def vector_factor(index: complex | NDArray, wi: Vector, wo: Vector) -> NDArray:
    """D of first-order vector perturbation: unpolarised light, all polarisations seen."""
    sine2_i, sine2_o = (d[0] * d[0] + d[1] * d[1] for d in (wi, wo))
    sines = np.sqrt(sine2_i * sine2_o)
    lateral = -(wi[0] * wo[0] + wi[1] * wo[1])
    known = sines > 1e-12
    cos = np.where(known, np.clip(lateral / np.where(known, sines, 1), -1, 1), 1)
    cos2 = cos * cos
    z_i, z_o = wi[2], wo[2]
    if np.isrealobj(index) or not np.any(np.imag(index)):
        eps = np.real(index) ** 2
        if np.all(eps >= 1):
            return _from_roots(eps, np.sqrt(eps - sine2_i), np.sqrt(eps - sine2_o), z_i, z_o, cos, cos2, sines, np.square)
    eps = _as_precise(index, z_i) ** 2
    return _from_roots(eps, np.sqrt(eps - sine2_i), np.sqrt(eps - sine2_o), z_i, z_o, cos, cos2, sines, _squared)


def _from_roots(eps, a, b, z_i, z_o, cos, cos2, sines, squared) -> NDArray:
    s_i, s_o = squared(a + z_i), squared(b + z_o)
    p_i, p_o = squared(eps * z_i + a), squared(eps * z_o + b)
    crossed = squared(b) / (s_i * p_o) + squared(a) / (p_i * s_o)
    across = squared(a * b * cos - eps * sines) / (p_i * p_o)
    return 2 * z_i * z_o * squared(eps - 1) * (cos2 / (s_i * s_o) + (1 - cos2) * crossed + across)


def shadowing(wi: Vector, wo: Vector) -> NDArray:
    """V-cavity shadowing and masking, in [0, 1]."""
    m = [a + b for a, b in zip(wi, wo)]
    # The half vector's length cancels in m_z / (wo.m).
    along = wo[0] * m[0] + wo[1] * m[1] + wo[2] * m[2]
    scale = np.where(along > 0, 2 * m[2] / np.where(along > 0, along, 1), 0)
    return np.clip(scale * np.minimum(wi[2], wo[2]), 0, 1)


def image_radius2(wi: Vector, wo: Vector) -> NDArray:
    """Square of the distance of the lobe's mirror image in the horizon."""
    lateral2 = (wi[0] + wo[0]) ** 2 + (wi[1] + wo[1]) ** 2
    to_horizon = [d[2] * d[2] / (1 + np.sqrt(d[0] * d[0] + d[1] * d[1])) for d in (wi, wo)]
    return lateral2 + 4 * to_horizon[0] * to_horizon[1]


def _as_precise(index, like: NDArray):
    """A complex index in the precision of an array, so that single precision stays single."""
    return np.asarray(index).astype(np.complex64 if like.dtype == np.float32 else np.complex128)


def _squared(value: NDArray) -> NDArray:
    return value.real * value.real + value.imag * value.imag
