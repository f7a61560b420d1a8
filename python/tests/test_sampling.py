"""Samples against their densities: chi-square tests, power, and bounded weights at grazing angles."""

from __future__ import annotations

import math
import unittest

import numpy as np

import diffraction_atlas as da
from common import atlas

SAMPLES = 1 << 17
#: How often a right sampler may be called wrong, for one test.
SIGNIFICANCE = 1e-6
#: Cells around the mirror direction: rings, whose `1 - cos` grow geometrically so that the lobe is told apart, and azimuths.
RINGS, AZIMUTHS = np.concatenate([[0], np.geomspace(1e-4, 2, 13)]), 16
#: Points within each cell along both, by which its part above the horizon is counted.
POINTS = 100
THETAS_DEG = (0, 35, 70, 85, 89)


def around(mirror: np.ndarray) -> np.ndarray:
    """Two unit vectors across a direction, and it."""
    x = np.cross([0.0, 1.0, 0.0], mirror)
    x /= np.linalg.norm(x)
    return np.stack([x, np.cross(mirror, x), mirror])


def cell_of(wi: np.ndarray, frame: np.ndarray) -> np.ndarray:
    local = wi @ frame.T
    ring = np.clip(np.searchsorted(RINGS, 1 - local[:, 2], "right") - 1, 0, len(RINGS) - 2)
    turn = np.arctan2(local[:, 1], local[:, 0]) % (2 * np.pi) / (2 * np.pi)
    return ring * AZIMUTHS + np.minimum((turn * AZIMUTHS).astype(int), AZIMUTHS - 1)


def solid_angles(frame: np.ndarray) -> np.ndarray:
    """What of each cell lies above the horizon, in sr."""
    place = (np.arange(POINTS) + 0.5) / POINTS
    z = 1 - (RINGS[:-1, None] + np.diff(RINGS)[:, None] * place)
    r = np.sqrt(np.maximum(1 - z * z, 0))
    turn = 2 * np.pi * (np.arange(AZIMUTHS)[:, None] + place) / AZIMUTHS
    up = frame[:, 2]
    height = r[:, None, :, None] * (np.cos(turn) * up[0] + np.sin(turn) * up[1])[None, :, None, :] + z[:, None, :, None] * up[2]
    return ((height > 0).mean(axis=(2, 3)) * np.diff(RINGS)[:, None] * 2 * np.pi / AZIMUTHS).ravel()


def chance(wi: np.ndarray, pdf: np.ndarray, frame: np.ndarray, count: int) -> float:
    """The chance that chi square is at least as large, for right densities.

    The mean over samples of 1 / pdf within a cell is the cell's solid angle, whatever the density: no density has to be integrated. Chi square
    is the sum of its deviations' squares, each over its variance as counted (Wilson and Hilferty's approximation of the chance).
    """
    cell, solid = cell_of(wi, frame), solid_angles(frame)
    sums, squares = (np.bincount(cell, 1 / pdf**power, len(solid)) / count for power in (1, 2))
    # Means of few samples, or of many that a few outweigh, such as those between the orders of a grating, have no normal distribution.
    told = count * sums**2 >= 50 * np.maximum(squares, 1e-300)
    chi2 = ((sums - solid)[told] ** 2 / ((squares - sums**2)[told] / count)).sum()
    freedom = told.sum()
    z = ((chi2 / freedom) ** (1 / 3) - (1 - 2 / (9 * freedom))) / math.sqrt(2 / (9 * freedom))
    return 0.5 * math.erfc(z / math.sqrt(2))


class Sampling(unittest.TestCase):
    def drawn(self, specimen, theta_deg, phi_deg=40.0, count=SAMPLES):
        wo = da.from_angles_deg(theta_deg, phi_deg)
        u = np.random.default_rng(theta_deg).random((count, 3))
        return wo, specimen.sample(wo, u)

    def test_samples_follow_their_density_and_a_wrong_one_is_found(self):
        for name in atlas().names[0:3:2]:
            specimen = atlas()[name]
            if specimen._tables.range is not None:
                continue
            for theta_deg in THETAS_DEG:
                wo, sample = self.drawn(specimen, theta_deg)
                there = sample.pdf > 0
                self.assertGreater(there.mean(), 0.999, (name, theta_deg))
                wi, pdf, frame = sample.wi[there], sample.pdf[there], around(wo * [-1, -1, 1])
                self.assertGreater(chance(wi, pdf, frame, SAMPLES), SIGNIFICANCE, (name, theta_deg))
                self.assertLess(chance(wi, 1.1 * pdf, frame, SAMPLES), SIGNIFICANCE, (name, theta_deg))
                beside = specimen.pdf(wi, da.from_angles_deg(theta_deg + (1 if theta_deg < 60 else 0), 42.0))
                beside = np.maximum(beside, pdf / 100)
                self.assertLess(chance(wi, beside, frame, SAMPLES), SIGNIFICANCE, (name, theta_deg, "a viewer beside"))

    def test_the_density_of_a_sample_is_that_of_its_direction(self):
        specimen = atlas()[atlas().names[1]]
        for theta_deg in THETAS_DEG:
            wo, sample = self.drawn(specimen, theta_deg, count=2000)
            there = sample.pdf > 0
            pdf = specimen.pdf(sample.wi[there], wo)
            self.assertLess(np.abs(pdf / sample.pdf[there] - 1).max(), 1e-9)
            value = specimen.eval(sample.wi[there], wo) * sample.wi[there][:, 2:] / pdf[:, None]
            self.assertLess(np.abs(value - sample.weight[there]).max(), 1e-9 * np.abs(value).max())

    def test_weights_are_bounded_at_grazing_angles_and_give_the_power(self):
        for name in atlas().names[0:3:2]:
            specimen = atlas()[name]
            if specimen._tables.range is not None:
                continue
            for theta_deg in (70, 85, 89):
                wo, sample = self.drawn(specimen, theta_deg)
                y = sample.weight[:, 1]
                # The crate's own bound is 40 times the directional albedo.
                self.assertLess(y.max(), 40 * y.mean(), (name, theta_deg))
                even = da.from_angles_deg(0, 0)
                self.assertTrue(np.isfinite(specimen.pdf(even, wo)))
                # The same power from directions that are even over the hemisphere, where that can be told.
                flat = np.random.default_rng(7).random((SAMPLES, 2))
                r = np.sqrt(1 - flat[:, 0] ** 2)
                wi = np.stack([r * np.cos(2 * np.pi * flat[:, 1]), r * np.sin(2 * np.pi * flat[:, 1]), flat[:, 0]], axis=1)
                plain = specimen.eval(wi, wo)[:, 1] * wi[:, 2] * 2 * np.pi
                error = math.hypot(plain.std(), y.std()) / math.sqrt(SAMPLES)
                self.assertLess(abs(plain.mean() - y.mean()), 6 * error, (name, theta_deg))
                self.assertLess(y.std(), plain.std(), (name, theta_deg))

    def test_no_direction_is_drawn_from_below(self):
        specimen = atlas()[atlas().names[0]]
        sample = specimen.sample([0.6, 0.0, -0.8], [0.3, 0.4, 0.5])
        self.assertEqual((float(sample.pdf), sample.weight.tolist()), (0.0, [0.0, 0.0, 0.0]))
        with self.assertRaisesRegex(ValueError, "numbers in"):
            specimen.sample([0.0, 0.0, 1.0], [0.1, 0.2, 1.0])

    def test_the_energy_limit_keeps_what_is_reflected_below_what_arrives(self):
        limited = [s for s in atlas().values() if s.has_energy_limit]
        if not limited:
            self.skipTest("nothing here reflects more than arrives")
        for theta_deg in (80, 88):
            wo = da.from_angles_deg(theta_deg, 0)
            u = np.random.default_rng(3).random((SAMPLES, 3))
            free, limit = (limited[0].sample(wo, u, energy_limit=on).weight[:, 1] for on in (False, True))
            self.assertLess(limit.mean() - 5 * limit.std() / math.sqrt(SAMPLES), 1.01)
            self.assertGreater(free.mean(), 1.02)


if __name__ == "__main__":
    unittest.main()
