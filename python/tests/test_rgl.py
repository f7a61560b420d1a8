"""The tensor file: its square is polar (u, v), its values are the specimen's there, and stock Mitsuba reads what the package says it does."""

from __future__ import annotations

import contextlib
import io
import tempfile
import unittest
from functools import lru_cache
from pathlib import Path

import numpy as np

import diffraction_atlas as da
from common import atlas, directions
from diffraction_atlas import _command, _rgl

SIDE = 24


@lru_cache(maxsize=None)
def held() -> _rgl.Tensors:
    return _rgl.tensors(specimen(), SIDE)


def specimen() -> da.Specimen:
    return next(one for one in atlas().values() if one.has_spectral)


class Square(unittest.TestCase):
    def test_places_are_polar_coordinates_of_uv_for_every_first_direction(self):
        azimuths, places = np.linspace(-np.pi, np.pi, 33), np.linspace(0, 1, 65)
        for theta, phi in ((0.0, 0.0), (0.6, 1.0), (1.3, -2.5)):
            density = _rgl.densities(theta, phi, azimuths)
            np.testing.assert_allclose(_rgl.cumulated(density)[:, -1], _rgl.HALF_VECTORS - 1)
            half = _rgl.half_vectors(density, places, azimuths)
            first = np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])
            second = 2 * (half @ first)[..., None] * half - first
            uv = -(first + second)[..., :2]
            wanted = -2 * places[:, None] ** 2 * np.stack([np.cos(azimuths), np.sin(azimuths)], axis=-1)[:, None]
            seen = second[..., 2] > 0.05
            self.assertGreater(seen.sum(), 300)
            # The trapezoid rule over 128 half vectors: a step is 2/128 of the radius at most.
            self.assertLess(np.abs(uv - wanted)[seen].max(), 1.5e-2)

    def test_at_nodes_the_file_holds_the_specimen(self):
        tensors = held()
        phi, theta = tensors.phi_i[5].astype(float), tensors.theta_i[3].astype(float)
        wi = np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])
        half = _rgl.half_vectors(tensors.vndf[5, 3], np.linspace(0, 1, SIDE), np.linspace(-np.pi, np.pi, SIDE))[2:-2, 2:12].reshape(-1, 3)
        wo = 2 * (half @ wi)[:, None] * half - wi
        up = wo[:, 2] > 0.05
        pairs, wo = np.broadcast_to(wi, wo.shape)[up], wo[up]
        nm = np.full(len(wo), tensors.wavelengths[7], float)
        right = specimen().eval_wavelengths(pairs, wo, nm[:1], lookup="spline")[:, 0] * wo[:, 2]
        found = _rgl.evaluated(tensors, pairs, wo, nm)
        self.assertLess(np.abs(found - right).max(), 2e-3 * right.max())
        self.assertGreater(np.abs(found[1:] - right[:-1]).max(), 2e-3 * right.max())

    def test_a_finer_square_is_better(self):
        coarse, fine = (_rgl.measure(specimen(), _rgl.tensors(specimen(), side), 1000)[0] for side in (16, 32))
        self.assertLess(fine, 0.9 * coarse)


class File(unittest.TestCase):
    def test_the_command_says_what_the_file_is_worth_and_replaces_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "snake.bsdf"
            said, status = self.run_command(str(path))
            self.assertEqual(status, 0)
            self.assertRegex(said, r"MiB, a stand-in for .* at the median")
            self.assertTrue(path.read_bytes().startswith(b"tensor_file\0\1\0"))
            self.assertLess(abs(path.stat().st_size / (6 * 2**20) - 1), 0.15)
            self.assertEqual(self.run_command(str(path))[1], 2)

    def run_command(self, path):
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            status = _command.main(["rgl", str(specimen().folder.parent), specimen().name, "--out", path, "--mib", "6"])
        return out.getvalue(), status

    def test_stock_mitsuba_reads_what_the_package_says_it_does(self):
        try:
            import mitsuba as mi

            mi.set_variant("scalar_spectral")
        except ImportError as error:
            raise unittest.SkipTest(f"Mitsuba is not here: {error}")
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "snake.bsdf"
            _rgl.write(path, held())
            plugin = mi.load_dict({"type": "measured", "filename": str(path)})
        wi, wo = directions(300), directions(300, 2)
        lit = (wi[:, 2] > 0.2) & (wo[:, 2] > 0.2)
        wi, wo = wi[lit], wo[lit]
        nm = 400 + 300 * np.random.default_rng(3).random(len(wi))
        context, found = mi.BSDFContext(), []
        for first, second, wavelength in zip(wi, wo, nm):
            si = mi.SurfaceInteraction3f()
            si.wi, si.wavelengths = mi.Vector3f(*first), mi.Spectrum(*[float(wavelength)] * 4)
            found.append(plugin.eval(context, si, mi.Vector3f(*second))[0])
        expected = _rgl.evaluated(held(), wi, wo, nm)
        # Its sums are in single precision, which moves places by some 1e-5 of the square's side.
        self.assertLess(np.abs(np.array(found) - expected).max(), 2e-3 * expected.max())
        self.assertGreater(np.abs(np.array(found) - np.roll(expected, 1)).max(), 0.1 * expected.max())


if __name__ == "__main__":
    unittest.main()
