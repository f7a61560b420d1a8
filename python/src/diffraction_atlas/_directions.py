"""Directions, and how a function of two of them is evaluated for whole arrays."""

from __future__ import annotations

import os
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

#: Directions evaluated at a time: what a chunk needs stays in a core's cache.
CHUNK = 8192
#: How far the length of a direction may be from 1: directions in single precision pass, angles and points do not.
LENGTH_TOLERANCE = 1e-3

_pool: ThreadPoolExecutor | None = None
_pool_lock = threading.Lock()


def from_angles_deg(theta_deg: ArrayLike, phi_deg: ArrayLike) -> NDArray[np.float64]:
    """Unit vectors from polar angles in degrees.

    `theta_deg` counts from the normal, `phi_deg` from x towards y. Any shapes that go together; the result has one more axis,
    of three components. At 90 degrees z is exactly 0.
    """
    theta, phi = np.broadcast_arrays(np.radians(theta_deg, dtype=float), np.radians(phi_deg, dtype=float))
    cos = np.cos(theta)
    # The cosine of a right angle is rounded to 6e-17.
    cos = np.where(np.abs(cos) < 1e-12, 0.0, cos)
    return np.stack([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), cos], axis=-1)


def angles_deg(direction: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Polar angles in degrees of directions of shape (..., 3): theta from the normal, phi in [0, 360)."""
    x, y, z = np.moveaxis(np.asarray(direction, float), -1, 0)
    return np.degrees(np.arctan2(np.hypot(x, y), z)), np.degrees(np.arctan2(y, x)) % 360.0


def as_directions(name: str, value: ArrayLike) -> NDArray:
    """`value` as floating point of shape (..., 3), or a ValueError that says what is wrong with it."""
    array = np.asarray(value)
    if array.dtype.kind not in "fiu" or array.ndim == 0 or array.shape[-1] != 3:
        raise ValueError(
            f"{name} must be numbers of shape (..., 3), unit vectors as x, y, z; it has the shape {array.shape} and the type "
            f"{array.dtype}. from_angles_deg(theta_deg, phi_deg) makes such vectors from angles"
        )
    return array if array.dtype in (np.float32, np.float64) else array.astype(np.float64)


def _check_lengths(name: str, x: NDArray, y: NDArray, z: NDArray) -> None:
    length2 = x * x + y * y + z * z
    wrong = ~(np.abs(length2 - 1) <= 2 * LENGTH_TOLERANCE)
    if wrong.any():
        at = int(np.argmax(wrong))
        vector = [float(part[at]) for part in (x, y, z)]
        raise ValueError(f"{name} must hold unit vectors; one of them is {vector}, of length {float(length2[at]) ** 0.5:.6g}")


def threads() -> int:
    """How many threads evaluate large arrays: those this process may use, or DIFFRACTION_ATLAS_THREADS."""
    asked = os.environ.get("DIFFRACTION_ATLAS_THREADS")
    if asked:
        return max(1, int(asked))
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


def _shared_pool() -> ThreadPoolExecutor:
    global _pool
    with _pool_lock:
        if _pool is None:
            _pool = ThreadPoolExecutor(threads(), thread_name_prefix="diffraction_atlas")
        return _pool


def in_chunks(job: Callable[[slice], None], count: int, chunk: int = CHUNK) -> None:
    """Calls `job` for slices of `range(count)`, on several threads where there are several slices."""
    slices = [slice(start, min(start + chunk, count)) for start in range(0, count, chunk)]
    if len(slices) < 2 or threads() < 2:
        for part in slices:
            job(part)
        return
    for _ in _shared_pool().map(job, slices):
        pass


def over_pairs(
    function: Callable[..., NDArray],
    wi: ArrayLike,
    wo: ArrayLike,
    channels: int | None,
    more: NDArray | None = None,
    chunk: int = CHUNK,
) -> NDArray:
    """`function(wi, wo)` for arrays of directions.

    `wi` and `wo` have shapes (..., 3) that go together by numpy's rules of broadcasting. `function` is given the three components of each,
    of shape (n,), and gives (n, channels), or (n,) where `channels` is None; `more`, of shape (..., k), goes with the directions and
    reaches the function as (n, k). The result has single precision where both have.
    """
    wi, wo = as_directions("wi", wi), as_directions("wo", wo)
    batch = [wi.shape[:-1], wo.shape[:-1]] + ([] if more is None else [more.shape[:-1]])
    try:
        shape = np.broadcast_shapes(*batch)
    except ValueError:
        named = ", ".join(map(str, batch))
        raise ValueError(f"the arrays do not go together: apart from the last axis their shapes are {named}") from None
    dtype = np.result_type(wi, wo)
    count = int(np.prod(shape))
    flat_wi, flat_wo = (np.broadcast_to(d, shape + (3,)).reshape(count, 3) for d in (wi, wo))
    flat_more = None if more is None else np.broadcast_to(more, shape + more.shape[-1:]).reshape(count, more.shape[-1])
    tail = () if channels is None else (channels,)
    out = np.empty((count, *tail), dtype)

    def job(part: slice) -> None:
        pair = []
        for name, flat in (("wi", flat_wi), ("wo", flat_wo)):
            components = np.ascontiguousarray(flat[part].T, dtype)
            _check_lengths(name, *components)
            pair.append(tuple(components))
        out[part] = function(*pair) if flat_more is None else function(*pair, flat_more[part])

    in_chunks(job, count, chunk)
    return out.reshape(shape + tail)
