"""A specimen as a tensor file of the RGL material database (Dupuy and Jakob 2018), for renderers that know no diffraction.

Spectral variants of stock Mitsuba 3 (`measured`) and pbrt-v4 read such files. They hold, for light or viewer in a few directions, values over a square that the file itself lays over
the half vectors, by densities `vndf` whose cumulated sums are the coordinates. Here these densities make the square polar coordinates of (u, v), whatever the
first direction: azimuth along one side, the root of the radius along the other. The orders of diffraction then stay where they are from one direction to the next, and
linear interpolation between directions does not blur them. What is left of the error is that of the square's grid and of the directions' steps: the file is a
stand-in, not the material, and `measure` says how good a one.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ._images import AtlasError
from ._specimen import Specimen

#: Azimuths and polar angles of the first direction, both ends counted.
AZIMUTHS, POLAR = 17, 9
WAVELENGTHS = 24
#: Half vectors along an azimuth, at which densities are given.
HALF_VECTORS = 128
#: The last polar angle: at 90 degrees nothing is above the surface.
POLAR_LAST = 0.995 * np.pi / 2
#: Side of the square, least and largest.
SIDES = (16, 512)
DESCRIPTION = (
    "A stand-in for a diffracting surface, made from an atlas of diffraction-atlas; orders are blurred by the grid. "
    "Values are the BRDF times the cosine of the second direction."
)


@dataclass(frozen=True)
class Tensors:
    """What a file holds; shapes as the format has them."""

    #: (AZIMUTHS,), (POLAR,) in radians, (WAVELENGTHS,) in nm.
    phi_i: NDArray
    theta_i: NDArray
    wavelengths: NDArray
    #: (AZIMUTHS, POLAR, side, HALF_VECTORS).
    vndf: NDArray
    #: (AZIMUTHS, POLAR, WAVELENGTHS, side, side): 1/sr, with the cosine.
    spectra: NDArray

    @property
    def bytes(self) -> int:
        return self.vndf.nbytes + self.spectra.nbytes + self.spectra[:, :, 0].nbytes


def side_for(mib: float) -> int:
    """The square's side for a file of so many MiB."""
    pairs = 4 * AZIMUTHS * POLAR
    # pairs (side² (WAVELENGTHS + 1) + side HALF_VECTORS) bytes.
    per_pixel, per_row = WAVELENGTHS + 1, HALF_VECTORS
    side = (-per_row + np.sqrt(per_row**2 + 4 * per_pixel * mib * 2**20 / pairs)) / (2 * per_pixel)
    if not SIDES[0] <= side <= SIDES[1]:
        raise ValueError(f"a file of {mib:g} MiB has squares of {side:.0f} a side; it may be {SIDES[0]} to {SIDES[1]}")
    return int(side)


def tensors(specimen: Specimen, side: int) -> Tensors:
    """The specimen over squares of `side`; AtlasError for one without spectral tables."""
    if not specimen.has_spectral:
        raise AtlasError(f"{specimen.name} has no spectral tables, which this format is made of: run the pipeline with \"spectral\" in tables.hold")
    if specimen._tables.range is not None:
        raise AtlasError(f"the tables of {specimen.name} were made for certain scenes: this format wants every direction")
    shortest, longest = specimen.about["optics"]["wavelength_nm"]
    shortest = max(shortest, specimen.about["spectral"]["shortest_nm"])
    phi_i, theta_i = np.linspace(-np.pi, np.pi, AZIMUTHS), np.linspace(0, POLAR_LAST, POLAR)
    wavelengths = np.linspace(shortest, longest, WAVELENGTHS)
    azimuths, places = np.linspace(-np.pi, np.pi, side), np.linspace(0, 1, side)
    vndf = np.empty((AZIMUTHS, POLAR, side, HALF_VECTORS), np.float32)
    spectra = np.empty((AZIMUTHS, POLAR, WAVELENGTHS, side, side), np.float32)
    for a, phi in enumerate(phi_i):
        for p, theta in enumerate(theta_i):
            vndf[a, p] = densities(theta, phi, azimuths)
            half = half_vectors(vndf[a, p], places, azimuths)
            first = np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])
            second = 2 * (half @ first)[..., None] * half - first
            second /= np.linalg.norm(second, axis=-1, keepdims=True)
            first, cosine = np.broadcast_to(first, second.shape), np.maximum(second[..., 2:], 0)
            spectra[a, p] = np.moveaxis(specimen.eval_wavelengths(first, second, wavelengths, lookup="spline") * cosine, -1, 0)
    single = (array.astype(np.float32) for array in (phi_i, theta_i, wavelengths))
    return Tensors(*single, vndf, spectra)


def densities(theta: float, phi: float, azimuths: NDArray) -> NDArray:
    """Densities over the half vectors of each azimuth whose sums are the root of half the radius in (u, v), as far as the second direction is
    above the surface; what is left up to 1 is spread beyond. Shape (azimuths, HALF_VECTORS), each row's integral 1."""
    at = np.pi / 2 * np.linspace(0, 1, HALF_VECTORS) ** 2
    cosine = np.cos(theta) * np.cos(at) + np.sin(theta) * np.sin(at) * np.cos(azimuths - phi)[:, None]
    is_above = 2 * cosine * np.cos(at) > np.cos(theta)
    root = np.sqrt(np.clip(cosine * np.sin(at), 0, 1))
    root = np.maximum.accumulate(np.where(is_above, root, 0), axis=1)
    seen = is_above.sum(axis=1, keepdims=True)
    beyond = np.clip(np.arange(HALF_VECTORS) - seen + 1, 0, None) / np.maximum(HALF_VECTORS - seen, 1)
    root += (1 - root) * np.where(seen < HALF_VECTORS, beyond, 0)
    steps = np.diff(root, axis=1)
    node = np.concatenate([steps[:, :1], (steps[:, 1:] + steps[:, :-1]) / 2, steps[:, -1:]], axis=1)
    node = np.maximum(node, 1e-7)
    return node / (cumulated(node)[:, -1:] / (HALF_VECTORS - 1))


def cumulated(node: NDArray) -> NDArray:
    """Sums of densities up to each node, of rows of nodes a step of 1 apart."""
    return np.concatenate([np.zeros((*node.shape[:-1], 1)), np.cumsum((node[..., 1:] + node[..., :-1]) / 2, axis=-1, dtype=float)], axis=-1)


def half_vectors(node: NDArray, places: NDArray, azimuths: NDArray) -> NDArray:
    """The half vectors at which the sums reach the places: shape (azimuths, places, 3)."""
    node = node.astype(float) / (HALF_VECTORS - 1)
    sums = cumulated(node)
    at = np.empty((len(azimuths), len(places)))
    for row, (density, sum) in enumerate(zip(node, sums)):
        cell = np.clip(np.searchsorted(sum, places, side="right") - 1, 0, HALF_VECTORS - 2)
        left, rise, rest = density[cell], density[cell + 1] - density[cell], np.maximum(places - sum[cell], 0)
        # The root of rest = left x + rise x² / 2 that loses nothing where it is nearly linear.
        at[row] = cell + np.clip(2 * rest / (left + np.sqrt(np.maximum(left * left + 2 * rise * rest, 0)) + 1e-300), 0, 1)
    polar = np.pi / 2 * (at / (HALF_VECTORS - 1)) ** 2
    sine = np.sin(polar)
    return np.stack([sine * np.cos(azimuths)[:, None], sine * np.sin(azimuths)[:, None], np.cos(polar)], axis=-1)


def write(path: str | Path, held: Tensors) -> None:
    """The tensor file; an existing one is not replaced."""
    unit, quarter = np.ones((2, 2), np.float32), np.full((2, 2), 0.25, np.float32)
    fields = {
        "description": np.frombuffer(DESCRIPTION.encode(), np.uint8), "jacobian": np.ones(1, np.uint8),
        "phi_i": held.phi_i, "theta_i": held.theta_i, "wavelengths": held.wavelengths,
        # Values are ndf / (4 sigma) times the spectra: these.
        "ndf": unit, "sigma": quarter, "vndf": held.vndf,
        "luminance": np.maximum(held.spectra.mean(axis=2), 1e-9).astype(np.float32), "spectra": held.spectra,
    }
    kinds = {"uint8": 1, "float32": 10}
    offset = 18 + sum(2 + len(name) + 11 + 8 * array.ndim for name, array in fields.items())
    head, places = [b"tensor_file\0", bytes([1, 0]), struct.pack("<I", len(fields))], []
    for name, array in fields.items():
        offset += -offset % 8
        places.append(offset)
        head += [struct.pack("<H", len(name)), name.encode(), struct.pack("<HBQ", array.ndim, kinds[array.dtype.name], offset)]
        head.append(struct.pack(f"<{array.ndim}Q", *array.shape))
        offset += array.nbytes
    with Path(path).open("xb") as file:
        file.write(b"".join(head))
        for place, array in zip(places, fields.values()):
            file.write(bytes(place - file.tell()))
            file.write(np.ascontiguousarray(array).tobytes())


def evaluated(held: Tensors, wi: NDArray, wo: NDArray, nm: NDArray) -> NDArray:
    """What a renderer reads from the file, BRDF times the cosine of `wo`, for arrays of pairs with one wavelength each."""
    half = wi + wo
    half /= np.linalg.norm(half, axis=-1, keepdims=True)
    across = np.sqrt(2 / np.pi * np.arccos(np.clip(half[:, 2], -1, 1)))
    turn = np.arctan2(half[:, 1], half[:, 0]) / (2 * np.pi) + 0.5
    phi, theta = np.arctan2(wi[:, 1], wi[:, 0]), np.arccos(np.clip(wi[:, 2], -1, 1))
    of_phi, of_theta, of_nm = (between(axis, x) for axis, x in ((held.phi_i, phi), (held.theta_i, theta), (held.wavelengths, nm)))
    corners = [(a, p, share_a * share_p) for a, share_a in of_phi for p, share_p in of_theta]
    side = held.vndf.shape[2]
    rows, cells = between(np.linspace(0, 1, side), turn), between(np.linspace(0, 1, HALF_VECTORS), across)
    sums = cumulated(held.vndf / (HALF_VECTORS - 1))
    (cell, _), (after, share) = cells
    x = np.zeros(len(wi))
    for a, p, weight in corners:
        for row, row_share in rows:
            left, right = (held.vndf[a, p, row, at] / (HALF_VECTORS - 1) for at in (cell, after))
            x += weight * row_share * (sums[a, p, row, cell] + share * left + share**2 / 2 * (right - left))
    value = np.zeros(len(wi))
    for a, p, weight in corners:
        for wavelength, nm_share in of_nm:
            for row, row_share in rows:
                for column, column_share in between(np.linspace(0, 1, side), x):
                    value += weight * nm_share * row_share * column_share * held.spectra[a, p, wavelength, row, column]
    return value


def between(axis: NDArray, x: NDArray) -> tuple[tuple[NDArray, NDArray], tuple[NDArray, NDArray]]:
    """Indices of the two nodes beside each place of an ascending axis, and their shares."""
    first = np.clip(np.searchsorted(axis, x, side="right") - 1, 0, len(axis) - 2)
    share = np.clip((x - axis[first]) / (axis[first + 1] - axis[first]), 0, 1)
    return (first, 1 - share), (first + 1, share)


def measure(specimen: Specimen, held: Tensors, count: int = 4000, seed: int = 1) -> tuple[float, float]:
    """Median and nine tenths of the relative error over pairs even over the hemisphere up to 75 degrees, at random wavelengths, where the value is above the
    median of such values: gratings are dark nearly everywhere."""
    random = np.random.default_rng(seed)
    z, turn = 1 - random.random((2, count)) * (1 - np.cos(np.radians(75))), 2 * np.pi * random.random((2, count))
    wi, wo = np.stack([np.sqrt(1 - z * z) * np.cos(turn), np.sqrt(1 - z * z) * np.sin(turn), z], axis=-1)
    picked = random.integers(0, 64, count)
    nm = np.linspace(held.wavelengths[0], held.wavelengths[-1], 64)
    right = np.empty(count)
    for n in range(64):
        here = picked == n
        right[here] = specimen.eval_wavelengths(wi[here], wo[here], nm[n : n + 1], lookup="spline")[:, 0] * wo[here, 2]
    lit = right > np.median(right)
    error = np.abs(evaluated(held, wi[lit], wo[lit], nm[picked[lit]]) / right[lit] - 1)
    return float(np.median(error)), float(np.quantile(error, 0.9))


def export(specimen: Specimen, path: str | Path, mib: float) -> str:
    """Writes a file of about so many MiB; what it is worth, in words. An existing file is not replaced (FileExistsError)."""
    if Path(path).exists():
        raise FileExistsError(f"{path} is there already; name another file")
    side = side_for(mib)
    coarse, held = tensors(specimen, max(SIDES[0], round(side / 2**0.5))), tensors(specimen, side)
    (before, _), (median, most) = measure(specimen, coarse), measure(specimen, held)
    write(path, held)
    size = held.bytes / 2**20
    said = f"{path}: {size:.0f} MiB, a stand-in for {specimen.name}: within {median:.1%} at the median, {most:.0%} at nine of ten of the lit directions."
    # What a power law between the two sizes asks for.
    power = np.log(before / median) / np.log(held.bytes / coarse.bytes) if before > median > 0 else 0
    if power > 0.05:
        said += f" {median / 2:.1%} would take about {size * 2 ** (1 / power):.0f} MiB."
    else:
        said += " A larger file is no better: steps of the first direction and of the wavelength decide."
    return said
