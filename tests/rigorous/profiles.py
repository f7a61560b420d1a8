"""The three grating profiles of the check and their Fourier integrals in closed form.

Lengths are in wavelengths, heights count outward from the mean plane's side (vacuum above). A profile is periodic
with the period d and has the depth h from its lowest to its highest point:

- `sinusoid`: (h/2) cos(2 pi x / d);
- `blaze`: rises over 90 % of the period, falls over the remaining 10 %;
- `lamellar`: half of the period at the bottom, half at the top, vertical walls.

Light with theta_i > 0 travels towards +x, that is, it falls on the blaze's long facet.
"""

from dataclasses import dataclass

import numpy as np
from scipy.special import jv

PROFILES = ("sinusoid", "blaze", "lamellar")
RISE = 0.9  # share of the blaze's period that rises
GROOVE = 0.5  # share of the lamellar period that is low, unless a case says otherwise


@dataclass(frozen=True)
class Profile:
    """One grating: its kind, period and depth in wavelengths."""

    kind: str
    period: float
    depth: float
    groove: float = GROOVE  # share of a lamellar period that is low

    def height(self, x):
        """Height at x (both in wavelengths), between -depth/2 and depth/2."""
        t = np.mod(np.asarray(x, dtype=float) / self.period, 1.0)
        if self.kind == "sinusoid":
            return 0.5 * self.depth * np.cos(2 * np.pi * t)
        if self.kind == "blaze":
            return self.depth * (np.where(t < RISE, t / RISE, (1 - t) / (1 - RISE)) - 0.5)
        return self.depth * np.where(t < self.groove, -0.5, 0.5)

    def phasor(self, gamma, orders):
        """(1/d) integral of exp(i gamma h(x)) exp(-2 pi i m x/d) over a period, for each m of `orders`.

        gamma may be complex; it is broadcast against the orders.
        """
        gamma, m = np.broadcast_arrays(np.asarray(gamma, dtype=complex), np.asarray(orders))
        a = gamma * self.depth / 2
        if self.kind == "sinusoid":
            return (1j ** np.mod(m, 4)) * jv(m, a)
        if self.kind == "blaze":
            up = _segment(a * 2 / RISE, m, -a, 0.0, RISE)
            return up + _segment(-a * 2 / (1 - RISE), m, a, RISE, 1.0)
        return _segment(0 * a, m, -a, 0.0, self.groove) + _segment(0 * a, m, a, self.groove, 1.0)

    def slope_coefficients(self, orders):
        """Fourier coefficients of dh/dx (not for the lamellar profile, whose slope is not a function)."""
        m = np.asarray(orders)
        if self.kind == "sinusoid":
            return np.where(np.abs(m) == 1, 1j * m * np.pi * self.depth / (2 * self.period), 0)
        if self.kind == "blaze":
            zero = np.zeros(m.shape, dtype=complex)
            up = self.depth / (RISE * self.period) * _segment(zero, m, zero, 0.0, RISE)
            return up - self.depth / ((1 - RISE) * self.period) * _segment(zero, m, zero, RISE, 1.0)
        raise ValueError("a lamellar profile has no slope: use the layered solver")

    def solid_interval(self, z):
        """The interval [start, end] of a period, as shares of it, in which the solid reaches above height z."""
        level = np.clip(z / self.depth + 0.5, 0.0, 1.0)
        if self.kind == "sinusoid":
            half = np.arccos(np.clip(2 * level - 1, -1, 1)) / (2 * np.pi)
            return -half, half
        if self.kind == "blaze":
            return RISE * level, 1 - (1 - RISE) * level
        return self.groove, 1.0


def _segment(rate, m, start_phase, t0, t1):
    """Integral over t0..t1 of exp(i (start_phase + rate (t - t0))) exp(-2 pi i m t)."""
    q = rate - 2 * np.pi * m
    x = q * (t1 - t0) / 2
    small = np.abs(x) < 1e-6
    safe = np.where(small, 1.0, x)
    sinc = np.where(small, 1 - x * x / 6, np.sin(safe) / safe)
    return (t1 - t0) * np.exp(1j * (start_phase - 2 * np.pi * m * t0 + x)) * sinc


def interval_coefficients(start, end, orders):
    """Fourier coefficients of the function that is 1 between the shares start and end of a period, else 0."""
    m = np.asarray(orders)
    zero = np.zeros(m.shape, dtype=complex)
    return _segment(zero, m, zero, start, end)
