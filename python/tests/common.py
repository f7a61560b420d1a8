"""What the tests share: the atlas they read, and values of the Rust crate where those were made."""

from __future__ import annotations

import json
import os
import unittest
from functools import lru_cache
from pathlib import Path

import numpy as np

import diffraction_atlas as da

ROOT = Path(__file__).resolve().parents[2]


@lru_cache(maxsize=None)
def atlas() -> da.Atlas:
    """The atlas named by ATLAS, or the one that a plain run of the program makes."""
    path = os.environ.get("ATLAS", str(ROOT / "out" / "atlas" / "bundled"))
    if not Path(path).is_dir():
        raise unittest.SkipTest(f"there is no atlas at {path}; name one with ATLAS")
    return da.open(path)


@lru_cache(maxsize=None)
def rust_values() -> dict:
    """What `cargo run -p diffraction-brdf --example values -- ATLAS` printed, from the file named by RUST_VALUES."""
    path = os.environ.get("RUST_VALUES")
    if not path:
        raise unittest.SkipTest("RUST_VALUES names no file with the values of the Rust crate")
    return json.loads(Path(path).read_text())


def column(values: dict, name: str) -> np.ndarray:
    """One of its columns, NaN where there is no answer."""
    return np.array(
        [[np.nan if x is None else x for x in row] if isinstance(row, list) else row for row in values["columns"][name]], float
    )


def directions(count: int, seed: int = 1, dtype=np.float64) -> np.ndarray:
    """Directions even over the hemisphere."""
    random = np.random.default_rng(seed)
    z, phi = random.random(count), 2 * np.pi * random.random(count)
    r = np.sqrt(1 - z * z)
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=-1).astype(dtype)


def largest_difference(found, expected) -> float:
    """Largest difference of rows as a share of the row's largest value, or of 1e-9 of all rows' where that is more: coefficients of splines
    in 32 bits hold no less. Infinite where only one of the two is NaN."""
    found, expected = (np.asarray(array, float).reshape(len(expected), -1) for array in (found, expected))
    if not np.array_equal(np.isnan(found), np.isnan(expected)):
        return np.inf
    error, size = np.nan_to_num(np.abs(found - expected)).max(axis=1), np.nan_to_num(np.abs(expected)).max(axis=1)
    return float(np.max(np.where(error == 0, 0, error / np.maximum(size, max(1e-9 * size.max(initial=0), 1e-300))), initial=0))
