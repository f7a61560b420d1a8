"""`diffraction-atlas-py check`: an atlas against the values that it states for itself."""

from __future__ import annotations

from typing import Iterator, NamedTuple

import numpy as np

from ._atlas import Atlas
from ._specimen import Specimen

#: Both sides compute in double precision from the same stored numbers. What remains is rounding of the directions: 1e-16 in u and v,
#: steepened by texels per unit of u, about 1e3, and by the largest ratio of neighbours, about 1e3.
TOLERANCE = 1e-9
#: Between the orders of a grating linear look-ups are exactly 0; splines ring there, to a rounding that is the orders'.
DARK = 1e-6


class Checked(NamedTuple):
    """What came of one kind of check values of a specimen."""

    what: str
    count: int
    #: Largest difference as a share of the largest channel or wavelength of its check value.
    largest: float

    @property
    def met(self) -> bool:
        """Whether all are within the tolerance; NaN is not."""
        return self.count > 0 and self.largest <= TOLERANCE


def check_specimen(specimen: Specimen) -> Iterator[Checked]:
    """Evaluates the check values of one specimen, by each look-up that they state."""
    for lookup, key, spectral_key in (("linear", "xyz", "brdf"), ("spline", "xyz_spline", "brdf_spline")):
        checks = [check for check in specimen.check_values if check.get(key) is not None]
        if checks or (key == "xyz" and not specimen.about["tables"].get("derived_under")):
            wi, wo, expected = (np.array([check[name] for check in checks], float).reshape(-1, 3) for name in ("wi", "wo", key))
            dark = DARK * expected.max(initial=0) if lookup == "spline" else 0
            yield Checked(f"X, Y, Z, {lookup}", len(checks), difference(specimen.eval(wi, wo, lookup=lookup), expected, dark))
        if not specimen.has_spectral:
            continue
        checks = [check for check in specimen.about["spectral"]["check_values"] if check.get(spectral_key)]
        if checks or spectral_key == "brdf":
            found = [specimen.eval_wavelengths(c["wi"], c["wo"], c["wavelength_nm"], lookup=lookup) for c in checks]
            dark = DARK * max(max(c[spectral_key]) for c in checks) if lookup == "spline" else 0
            largest = [difference(value[None], np.array(c[spectral_key])[None], dark) for value, c in zip(found, checks)]
            count = sum(len(c[spectral_key]) for c in checks)
            yield Checked(f"wavelengths, {lookup}", count, float(np.max(largest, initial=0)))


def difference(found: np.ndarray, expected: np.ndarray, dark: float = 0.0) -> float:
    """Largest difference of rows as a share of the row's largest value and `dark`; where both are 0, anything else is infinitely far."""
    error, size = np.abs(found - expected).max(axis=1, initial=0), np.abs(expected).max(axis=1, initial=0) + dark
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(error == 0, 0, error / size)
    return float(np.max(share, initial=0))


def check(atlas: Atlas) -> bool:
    """Prints a line for each specimen; whether all check values are met."""
    fine, largest, count = True, 0.0, 0
    width = max(map(len, atlas.names), default=0)
    for name, specimen in atlas.items():
        for checked in check_specimen(specimen):
            fine &= checked.met
            largest, count = float(np.maximum(largest, checked.largest)), count + checked.count
            word = "met" if checked.met else "NOT MET"
            print(f"{name:{width}}  {checked.count:4} {checked.what:19}  largest difference {checked.largest:.1e}  {word}")
    print(f"{count} check values of {len(atlas)} specimens, largest difference {largest:.1e}, allowed {TOLERANCE:.0e}")
    return fine and count > 0
