"""Values: against check values, against the Rust crate, against closed forms; and each comparison on perturbed input."""

from __future__ import annotations

import contextlib
import io
import json
import shutil
import tempfile
import unittest
from pathlib import Path

import numpy as np

import diffraction_atlas as da
from common import atlas, column, directions, largest_difference, rust_values
from diffraction_atlas import _check, _command


class OldAtlases(unittest.TestCase):
    def opened(self, folder: Path, schema: int, factor: str | None) -> da.Specimen:
        """A specimen of the atlas as that schema would have written it, its files linked."""
        source = next(specimen for specimen in atlas().values() if "dielectric" in specimen.about["optics"]["material"])
        about = json.loads(json.dumps(source.about))
        about["schema"] = schema
        about["optics"].pop("factor", None)
        if factor:
            about["optics"]["factor"] = factor
        for key in ("spectral", "energy_limit", "albedo") if schema < 3 else ():
            about.pop(key, None)
        folder.mkdir()
        for file in source.folder.glob("*.exr"):
            (folder / file.name).symlink_to(file.resolve())
        (folder / "specimen.json").write_text(json.dumps(about))
        return da.Specimen(folder)

    def test_schemas_1_and_2_are_read_with_the_scalar_factor_where_none_is_named(self):
        wi, wo = directions(200), directions(200, 2)
        with tempfile.TemporaryDirectory() as place:
            place = Path(place)
            scalar = self.opened(place / "now", 3, "scalar").eval(wi, wo)
            vector = self.opened(place / "vector", 3, "vector").eval(wi, wo)
            self.assertGreater(largest_difference(vector, scalar), 0.01)
            for schema in (1, 2):
                old = self.opened(place / str(schema), schema, None)
                self.assertEqual(largest_difference(old.eval(wi, wo), scalar), 0)
                self.assertFalse(old.has_spectral)
                with self.assertRaisesRegex(ValueError, "no spectral tables"):
                    old.eval_wavelengths(wi, wo, [550])

    def test_other_schemas_are_refused_by_their_number(self):
        with tempfile.TemporaryDirectory() as place:
            for schema in (0, 4):
                with self.assertRaisesRegex(da.AtlasError, f"schema {schema}.*reads 1 to 3"):
                    self.opened(Path(place) / str(schema), schema, "vector")


class CheckValues(unittest.TestCase):
    def test_every_check_value_is_met_and_perturbed_tables_are_found(self):
        for name, specimen in atlas().items():
            for checked in _check.check_specimen(specimen):
                self.assertTrue(checked.met, (name, checked))
        specimen = da.Specimen(atlas()[atlas().names[0]].folder)
        layers = specimen._tables.layers
        right = layers.texels
        image = right.reshape(layers.rows, layers.columns, -1)
        mistakes = {
            "u and v exchanged": image[::-1, ::-1].transpose(1, 0, 2),
            "y downwards": image[::-1],
            "a texel beside": np.roll(image, 1, axis=1),
            "one part in a million": image * np.float32(1.000001),
        }
        for what, wrong in mistakes.items():
            layers.texels = np.ascontiguousarray(wrong).reshape(right.shape)
            self.assertFalse(next(_check.check_specimen(specimen)).met, what)

    def test_the_command_says_so_and_fails_on_wrong_values(self):
        with tempfile.TemporaryDirectory() as folder:
            version = Path(folder) / "v0001"
            name = atlas().names[0]
            shutil.copytree(atlas().folder / name, version / name, ignore=shutil.ignore_patterns("scenes", "*.png"))
            index = {**atlas().index, "specimens": [{"name": name, "species": ""}]}
            (version / "atlas.json").write_text(json.dumps(index))
            (Path(folder) / "latest").write_text("v0001\n")
            self.assertEqual(self.run_check(folder)[0], 0)

            path = version / name / "specimen.json"
            about = json.loads(path.read_text())
            about["check_values"][3]["xyz"][1] *= 1 + 1e-8
            path.write_text(json.dumps(about))
            status, _, error = self.run_check(folder)
            self.assertEqual(status, 2)
            self.assertIn("digest differs", error)
            # As if it had been published so.
            for file in index["files"]:
                if file["path"] == f"{name}/specimen.json":
                    import hashlib

                    file["sha256"] = hashlib.sha256(path.read_bytes()).hexdigest()
            (version / "atlas.json").write_text(json.dumps(index))
            status, said, _ = self.run_check(folder)
            self.assertEqual(status, 1)
            self.assertIn("NOT MET", said)
        self.assertEqual(self.run_check("/nowhere")[0], 2)

    def run_check(self, path):
        said, error = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(error):
            status = _command.main(["check", str(path)])
        return status, said.getvalue(), error.getvalue()


class AgainstRust(unittest.TestCase):
    """The same numbers as `diffraction-brdf` gives, to rounding."""

    # Double precision, steepened as the check values are; closed forms of chords lose some digits to differences.
    TOLERANCE = 1e-9
    # Densities are prepared in single precision on both sides, from sums in another order.
    DENSITY_TOLERANCE = 1e-5

    def each(self):
        for name, values in rust_values().items():
            specimen = atlas()[name]
            yield name, specimen, values, column(values, "wi"), column(values, "wo")

    def same(self, found, values, name, what, tolerance=TOLERANCE):
        expected = column(values, what)
        self.assertLessEqual(largest_difference(found, expected), tolerance, (name, what))
        # What is off by ten times the tolerance is found.
        self.assertGreater(largest_difference(np.asarray(found) * (1 + 10 * tolerance), expected), tolerance, (name, what))

    def test_look_ups(self):
        for name, specimen, values, wi, wo in self.each():
            self.same(specimen.eval(wi, wo), values, name, "linear")
            self.same(specimen.eval(wi, wo, lookup="cubic"), values, name, "cubic")
            # Coefficients have single precision on the other side.
            self.same(specimen.eval(wi, wo, lookup="spline"), values, name, "spline", self.DENSITY_TOLERANCE)
            self.same(specimen.eval(wi, wo, energy_limit=True), values, name, "limited")
            self.assertGreater(largest_difference(specimen.eval(wi, wo), column(values, "cubic")), 1e-6)
            if specimen.has_spectral:
                nm = values["wavelengths_nm"]
                self.same(specimen.eval_wavelengths(wi, wo, nm), values, name, "wavelengths")
                self.same(specimen.eval_wavelengths(wi, wo, nm, lookup="cubic"), values, name, "wavelengths_cubic")
                found = specimen.eval_wavelengths(wi, wo, nm, lookup="spline")
                self.same(found, values, name, "wavelengths_spline", self.DENSITY_TOLERANCE)

    def test_filtered_look_ups(self):
        for name, specimen, values, wi, wo in self.each():
            for diameter in values["diameters_deg"]:
                light = {"angular_diameter_deg": diameter}
                key = next(k for k in values["columns"] if k.startswith("filtered_") and k.split("_")[1] in (str(diameter), f"{diameter:g}"))
                self.same(specimen.eval_filtered(wi, wo, **light), values, name, key)
                cubic = key.replace("filtered", "filtered_cubic")
                self.same(specimen.eval_filtered(wi, wo, lookup="cubic", **light), values, name, cubic)
                if specimen.has_spectral:
                    found = specimen.eval_wavelengths(wi, wo, values["wavelengths_nm"], **light)
                    self.same(found, values, name, f"wavelengths_{key}")

    def test_samples_and_densities(self):
        for name, specimen, values, wi, wo in self.each():
            self.same(specimen.pdf(wi, wo), values, name, "pdf", self.DENSITY_TOLERANCE)
            drawn = specimen.sample(wo, column(values, "u"))
            expected = values["columns"]["sample"]
            self.assertEqual([row is not None for row in expected], list(drawn.pdf > 0), name)
            there = drawn.pdf > 0
            rows = [row for row in expected if row is not None]
            for k, found in enumerate(drawn):
                parts = np.array([row[k] for row in rows])
                self.assertLess(largest_difference(found[there], parts), self.DENSITY_TOLERANCE, (name, k))

    def test_other_lights(self):
        """Both sum few wavelengths; they err by about a thousandth of the brighter values."""
        for name, specimen, values, wi, wo in self.each():
            if not specimen.has_spectral:
                continue
            for light in ("D65", "A", "E", "F11"):
                found, expected = specimen.xyz_under(wi, wo, light), column(values, f"under_{light}")
                norm = np.linalg.norm(found - expected) / np.linalg.norm(expected)
                self.assertLess(norm, 1e-4, (name, light))
                other = column(values, f"under_{'A' if light != 'A' else 'E'}")
                self.assertGreater(np.linalg.norm(found - other) / np.linalg.norm(other), 1e-2)


class Interface(unittest.TestCase):
    def setUp(self):
        self.specimen = atlas()[atlas().names[0]]

    def test_shapes_go_together_and_types_are_kept(self):
        wi, wo = directions(5), directions(7, 2)
        grid = self.specimen.eval(wi[:, None], wo[None])
        self.assertEqual(grid.shape, (5, 7, 3))
        self.assertTrue(np.array_equal(grid[3, 4], self.specimen.eval(wi[3], wo[4])))
        self.assertEqual(self.specimen.eval(wi[0], wo[0]).shape, (3,))
        single = self.specimen.eval(wi.astype(np.float32), wo[:5].astype(np.float32))
        self.assertEqual(single.dtype, np.float32)
        double = self.specimen.eval(wi, wo[:5])
        self.assertLess(largest_difference(single, double), 1e-3)
        if self.specimen.has_spectral:
            nm = np.array([[450.0, 550], [500, 600], [510, 610], [520, 620], [530, 630]])
            each = self.specimen.eval_wavelengths(wi, wo[:5], nm)
            self.assertTrue(np.array_equal(each[2], self.specimen.eval_wavelengths(wi[2], wo[2], nm[2])))

    def test_large_arrays_are_what_small_ones_are(self):
        wi, wo = directions(20_000), directions(20_000, 2)
        whole = self.specimen.eval(wi, wo)
        self.assertTrue(np.array_equal(whole[12_345], self.specimen.eval(wi[12_345], wo[12_345])))

    def test_below_the_surface_is_zero_and_reciprocity_holds(self):
        wi, wo = directions(64), directions(64, 2)
        self.assertFalse(self.specimen.eval(wi * [1, 1, -1], wo).any())
        self.assertFalse(self.specimen.eval(wi, wo * [1, 1, -1]).any())
        self.assertLess(largest_difference(self.specimen.eval(wi, wo), self.specimen.eval(wo, wi)), 1e-10)

    def test_spectral_tables_alone_answer_in_x_y_z(self):
        if not self.specimen.has_spectral:
            self.skipTest("the first specimen has no spectral tables")
        about = self.specimen.about
        light = {"illuminant": self.specimen.illuminant, "wavelength_nm": about["optics"]["wavelength_nm"]}
        tables = {**about["tables"], "tables": [], "lobe": None, "derived_under": light}
        alone = da.Specimen(self.specimen.folder, {**about, "tables": tables, "check_values": []})
        wi, wo = directions(256), directions(256, 2)
        found, expected = (s.eval(wi, wo, lookup="spline") for s in (alone, self.specimen))
        self.assertLess(np.linalg.norm(found - expected), 3e-3 * np.linalg.norm(expected))
        other = alone.xyz_under(wi, wo, "E")
        self.assertGreater(np.linalg.norm(other - expected), 1e-2 * np.linalg.norm(expected))
        self.assertEqual([checked.what for checked in _check.check_specimen(alone)][0], "wavelengths, linear")
        with self.assertRaisesRegex(da.AtlasError, "spectral tables alone"):
            alone.sample([0.0, 0.0, 1.0], [0.5, 0.5, 0.5])

    def test_errors_are_words(self):
        up = [0.0, 0.0, 1.0]
        for wi, wo, words in (
            ([0.0, 0.0], up, "shape"),
            ([0.0, 0.0, 2.0], up, "length 2"),
            ([np.nan, 0.0, 1.0], up, "unit vectors"),
            (np.tile(up, (3, 1)), np.tile(up, (2, 1)), "do not go together"),
        ):
            with self.assertRaisesRegex(ValueError, words):
                self.specimen.eval(wi, wo)
        with self.assertRaisesRegex(ValueError, "linear"):
            self.specimen.eval(up, up, lookup="nearest")
        with self.assertRaisesRegex(KeyError, atlas().names[0]):
            atlas()["nobody"]
        with self.assertRaisesRegex(da.AtlasError, "no folder"):
            da.open("/nowhere")
        with self.assertRaisesRegex(ValueError, "between 0 and 180"):
            self.specimen.eval_filtered(up, up, angular_diameter_deg=-1)
        if self.specimen.has_spectral:
            with self.assertRaisesRegex(ValueError, "begin at"):
                self.specimen.eval_wavelengths(up, up, 200.0)
            with self.assertRaisesRegex(ValueError, "there is no light"):
                self.specimen.xyz_under(up, up, "moon")

    def test_small_lights_are_points_and_large_ones_are_means(self):
        wi, wo = directions(64), directions(64, 2)
        point = self.specimen.eval(wi, wo)
        self.assertLess(largest_difference(self.specimen.eval_filtered(wi, wo), point), 1e-12)
        self.assertLess(largest_difference(self.specimen.eval_filtered(wi, wo, angular_diameter_deg=1e-4), point), 1e-3)
        self.assertGreater(largest_difference(self.specimen.eval_filtered(wi, wo, angular_diameter_deg=5), point), 1e-2)
        one, two = da.Footprint.of_light(wi, 1.0), da.Footprint.of_light(wi, 2.0)
        sum_of_both = self.specimen.eval_filtered(wi, wo, footprint=one + two)
        self.assertLess(largest_difference(self.specimen.eval_filtered(wi, wo, angular_diameter_deg=1, footprint=two), sum_of_both), 1e-12)

    def test_grazing_lights_in_single_precision_have_a_size_too(self):
        wi = da.from_angles_deg(89.9999, np.arange(0.0, 360, 0.5)).astype(np.float32)
        self.assertTrue((np.linalg.norm(wi.astype(float), axis=1) > 1).any())
        self.assertEqual(self.specimen.eval_filtered(wi, wi[0], angular_diameter_deg=0.5).dtype, np.float32)

    def test_a_mean_is_that_of_many_points(self):
        # On the lobe's flank.
        wi, wo, diameter = da.from_angles_deg(35, 20), da.from_angles_deg(36, 200.5), np.radians(2.0)
        index = np.arange(4000)
        versine = (index + 0.5) / len(index) * 2 * np.sin(diameter / 4) ** 2
        sine, turn = np.sqrt(versine * (2 - versine)), 2.399963229728653 * index
        across = np.cross(wi, [0.3, -0.5, 0.81])
        across /= np.linalg.norm(across)
        points = np.outer(1 - versine, wi) + np.outer(sine * np.cos(turn), across) + np.outer(sine * np.sin(turn), np.cross(wi, across))
        mean = (self.specimen.eval(points, wo) * points[:, 2:]).mean(axis=0) / wi[2]
        found = self.specimen.eval_filtered(wi, wo, angular_diameter_deg=2.0)
        self.assertLess(np.abs(found - mean).max() / mean.max(), 5e-3)
        self.assertGreater(np.abs(self.specimen.eval(wi, wo) - mean).max() / mean.max(), 2e-2)


class Lights(unittest.TestCase):
    def test_whites_are_the_published_ones_and_tables_those_of_the_program(self):
        from diffraction_atlas import _light

        # CIE 15:2018: sums over 5 nm, of which those from 380 to 780 nm lack 3e-4.
        nm = np.arange(380.0, 781, 5)
        for light, x, z in (("D65", 0.95047, 1.08883), ("A", 1.0985, 0.35585), ("E", 1, 1), ("F2", 0.99186, 0.67393), ("F11", 1.00962, 0.6435)):
            sums = _light.power_at(light, nm) @ _light.observer(nm)
            self.assertLess(np.abs(sums / sums[1] - [x, 1, z]).max(), 4e-4, light)
        text = (Path(__file__).resolve().parents[2] / "crates/brdf/src/cie_data.rs").read_text()
        for nm, power in ((300, "0.0341"), (780, "63.3828")):
            self.assertEqual(_light.power_at("D65", nm), float(power))
            self.assertIn(power, text)
        for nm in range(360, 831):
            self.assertIn(f"[{', '.join(map(repr, _light.observer(nm).tolist()))}]", text)

    def test_few_wavelengths_sum_as_many_do(self):
        from diffraction_atlas import _light

        specimen = next(s for s in atlas().values() if s.has_spectral)
        tables = specimen._spectral_tables
        wi, wo = directions(12), directions(12, 2)
        for light in ("D65", "F11", ([400.0, 500, 700], [0.2, 1, 0.6]), da.Lines([450.0, 600], [1, 2])):
            exact = _light.fine(light, (tables.shortest_nm, tables.longest_nm), 0.25)
            # By splines: between linear look-ups' kinks few wavelengths are few.
            expected = specimen.eval_wavelengths(wi, wo, exact.wavelength_nm, lookup="spline") @ exact.weights
            found = specimen.xyz_under(wi, wo, light, lookup="spline")
            self.assertLess(np.linalg.norm(found - expected) / np.linalg.norm(expected), 1e-4)
            self.assertGreater(np.linalg.norm(specimen.xyz_under(wi, wo, "A", lookup="spline") - expected) / np.linalg.norm(expected), 1e-2)


class Colours(unittest.TestCase):
    def test_white_is_white_and_what_is_outside_keeps_its_luminance(self):
        white = [0.95047, 1.0, 1.08883]
        self.assertLess(np.abs(da.to_srgb(white) - 1).max(), 1e-3)
        self.assertTrue((da.to_linear_srgb([0.1, 0.3, 0.05]) < 0).any())
        rgb = da.to_srgb([0.1, 0.3, 0.05])
        linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
        self.assertAlmostEqual(float(linear @ [0.2126729, 0.7151522, 0.0721750]), 0.3, places=3)
        self.assertTrue(np.array_equal(da.to_srgb([np.nan] * 3), [1, 0, 1]))


if __name__ == "__main__":
    unittest.main()
