"""Reads a version of an atlas with the OpenEXR library alone and evaluates its check values as FORMAT.md tells.

    python3 tests/read_with_openexr.py out/atlas/NAME/v0001

Needs OpenEXR and numpy. Shares no code with the program: what agrees here can be read by others.
"""

import json
import sys
from pathlib import Path

import numpy as np
import OpenEXR

# Both sides compute in double precision from the same stored numbers. What remains is rounding of the directions:
# 1e-16 in u and v, steepened by at most (texels per unit of u, about 1e3) x (largest ratio of neighbours, about 1e3).
TOLERANCE = 1e-9
# Between the orders of a grating linear look-ups are exactly 0; splines ring there, to a rounding that is the orders'.
DARK = 1e-6


def read_image(path, scale, corner=(0, 0)):
    """X, Y, Z of shape [rows, columns, 3] in 1/sr, and their type; `corner` is the data window's, as column and row."""
    with OpenEXR.File(str(path), separate_channels=True) as file:
        header = dict(file.header())
        channels = file.channels()
        assert sorted(channels) == ["B", "G", "R"], (path, sorted(channels))
        image = np.stack([np.array(channels[name].pixels) for name in "RGB"], axis=-1)
    assert header["colorInteropID"] == "data", path
    assert not {"chromaticities", "whiteLuminance"} & set(header), path
    if scale is not None:
        assert tuple(header["dataWindow"][0]) == corner, (path, header["dataWindow"])
        stated = json.loads(header["diffractionAtlas"])
        assert stated["scale"] == scale, path
        assert header["atlas:kind"] == stated["kind"] and header["atlas:order"] == stated["order"], path
        assert abs(header["atlas:scale"] - scale) <= 1e-7 * scale, path
    return image.astype(np.float64) * (1.0 if scale is None else scale), image.dtype


def bilinear(image, column, row):
    rows, columns, _ = image.shape
    c, r = min(int(column), columns - 2), min(int(row), rows - 2)
    x, y = column - c, row - r
    top = (1 - x) * image[r, c] + x * image[r, c + 1]
    bottom = (1 - x) * image[r + 1, c] + x * image[r + 1, c + 1]
    return (1 - y) * top + y * bottom


def coefficients(table):
    """Of the cubic B-splines through a square table: (c[i - 1] + 4 c[i] + c[i + 1]) / 6 is value i, mirrored at the ends."""
    size = len(table)
    middle = (size - 1) / 2
    x, y = np.meshgrid(np.arange(size) - middle, np.arange(size) - middle)
    radius = np.maximum(np.hypot(x, y), 1)
    # Beyond two texels outside of the disc values are held.
    held = lambda at: np.where(radius > middle + 2, at * (middle + 2) / radius, at)
    column, row = (np.floor(middle + held(at) + 0.5).astype(int).clip(0, size - 1) for at in (x, y))
    found = table[row, column]
    for _ in range(2):
        found = np.swapaxes(solved(6 * found), 0, 1)
    return found


def solved(right):
    """The tridiagonal system, by elimination along the first axis."""
    last = len(right) - 1
    above = np.empty(last)
    for i in range(last + 1):
        below = 0 if i == 0 else 2 if i == last else 1
        pivot = 4 - below * (above[i - 1] if i else 0)
        right[i] = (right[i] - below * right[i - 1] if i else right[i]) / pivot
        if i < last:
            above[i] = (2 if i == 0 else 1) / pivot
    for i in range(last - 1, -1, -1):
        right[i] -= above[i] * right[i + 1]
    return right


def spline(image, column, row):
    """A look-up of coefficients."""
    rows, columns, _ = image.shape

    def taps(at, count):
        whole = int(at)
        f = at - whole
        weights = [(1 - f) ** 3 / 6, 2 / 3 - f**2 + f**3 / 2, 2 / 3 - (1 - f) ** 2 + (1 - f) ** 3 / 2, f**3 / 6]
        indices = [abs(whole + k) for k in (-1, 0, 1, 2)]
        return [(min(i, 2 * (count - 1) - i), w) for i, w in zip(indices, weights)]

    return sum(wy * wx * image[r, c] for r, wy in taps(row, rows) for c, wx in taps(column, columns))


def cubic(image, column, row):
    """Lagrange's cubic through four by four texels."""
    rows, columns, _ = image.shape

    def taps(at, count):
        if count < 4:
            first = min(int(at), count - 2)
            return [(first, 1 - (at - first)), (first + 1, at - first)]
        first = min(max(int(at) - 1, 0), count - 4)
        nodes = range(4)
        weight = lambda k: np.prod([(at - first - j) / (k - j) for j in nodes if j != k])
        return [(first + k, weight(k)) for k in nodes]

    return sum(wy * wx * image[r, c] for r, wy in taps(row, rows) for c, wx in taps(column, columns))


def chebyshev(t, count):
    values = [1.0, 2 * t - 1]
    while len(values) < count:
        values.append(2 * (2 * t - 1) * values[-1] - values[-2])
    return values[:count]


def fresnel(material, c):
    if material == "ideal":
        return 1.0
    ((_, index),) = material.items()
    m2 = complex(index["n"], index.get("k", 0.0)) ** 2
    g = np.sqrt(m2 - 1 + c * c)
    a, b = (c - g) / (c + g), (m2 * c - g) / (m2 * c + g)
    return (abs(a) ** 2 + abs(b) ** 2) / 2


def vector_factor(material, wi, wo):
    """4 cos_i cos_o (Q_ss + Q_sp + Q_ps + Q_pp) / 2 of first-order vector perturbation."""
    ((_, index),) = material.items()
    eps = complex(index["n"], index.get("k", 0.0)) ** 2
    pi, po = np.array(wi[:2]), np.array(wo[:2])
    sine_i, sine_o = np.linalg.norm(pi), np.linalg.norm(po)
    cos_phi = -pi @ po / (sine_i * sine_o) if sine_i * sine_o > 1e-12 else 1.0
    sin2_phi = 1 - cos_phi**2
    a, b = np.sqrt(eps - sine_i**2), np.sqrt(eps - sine_o**2)
    ss = cos_phi / ((wi[2] + a) * (wo[2] + b))
    sp = b / ((wi[2] + a) * (eps * wo[2] + b))
    ps = a / ((eps * wi[2] + a) * (wo[2] + b))
    pp = (a * b * cos_phi - eps * sine_i * sine_o) / ((eps * wi[2] + a) * (eps * wo[2] + b))
    q = abs(ss) ** 2 + sin2_phi * (abs(sp) ** 2 + abs(ps) ** 2) + abs(pp) ** 2
    return 2 * wi[2] * wo[2] * abs(eps - 1) ** 2 * q


class Specimen:
    def __init__(self, folder):
        self.about = json.loads((folder / "specimen.json").read_text())
        stored = self.about["tables"]
        expected = {"half": np.float16, "float": np.float32}[stored["storage"]]

        self.restriction = stored.get("served")
        row, column = self.restriction["first"] if self.restriction else (0, 0)

        def image(array, dtype=expected, corner=(0, 0)):
            values, found = read_image(folder / array["file"], array["scale"], corner)
            assert found == dtype, (array["file"], found)
            return values

        self.basis = stored["basis"]
        self.tables = [image(array, corner=(column, row)) for array in stored["tables"]]
        self.splines = None
        self.axes = [stored["u"], stored["v"]]
        if self.restriction:
            self.range = image(self.restriction["range"], np.float16, (column, row))
        self.lobe = stored["lobe"]
        if self.lobe:
            self.coherent = image(self.lobe["coherent"], np.float32)
            cross = self.lobe["cross"]
            self.cross = [image(array) for array in cross["patches"]] if cross else []

    def evaluate(self, wi, wo, splines=False):
        """By linear look-ups, or by splines; the lobe's own tables are then looked up by cubics."""
        if splines and self.splines is None:
            self.splines = [coefficients(table) for table in self.tables]
        near = cubic if splines else bilinear
        u, v, w = -(np.array(wi) + np.array(wo))
        # Axes are given by the centres of their first and last texels.
        column, row = (
            (axis["samples"] - 1) * (x - axis["first"]) / (axis["last"] - axis["first"])
            for axis, x in zip(self.axes, (u, v))
        )
        geometry = (1 + np.dot(wi, wo)) ** 2 / (wi[2] * wo[2])
        c = np.linalg.norm(np.array(wi) + np.array(wo)) / 2
        optics = self.about["optics"]
        mirror = fresnel(optics["material"], c)
        vector = optics.get("factor", "scalar") == "vector"
        factor = mirror * geometry
        lobe_factor = mirror if vector else factor / w**2
        if vector and optics["material"] != "ideal":
            factor = vector_factor(optics["material"], wi, wo)
        if optics["shadowing"]:
            m = (np.array(wi) + np.array(wo)) / (2 * c)
            shadowing = min(1.0, 2 * m[2] * wo[2] / np.dot(wo, m), 2 * m[2] * wi[2] / np.dot(wo, m))
            factor, lobe_factor = factor * shadowing, lobe_factor * shadowing
        look_up, tables = (spline, self.splines) if splines else (bilinear, self.tables)
        values = [look_up(table, column, row) for table in tables]
        if self.basis == "taylor":
            return factor * sum(abs(w) ** n * value for n, value in enumerate(values)) / w**2
        t = min(1.0, abs(w) / np.sqrt(4 - u * u - v * v))
        s = t
        if self.restriction:
            low, high, there = bilinear(self.range, column, row)
            assert there > 1 - 1e-9 and low <= t <= high, "a check value lies outside of what is covered"
            s = (t - low) / (high - low)
        total = sum(basis * value for basis, value in zip(chebyshev(s, len(values)), values))
        lobe = 0.0
        if self.lobe:
            r = self.lobe["radius_max"]
            rows, columns, _ = self.coherent.shape
            # The lobe and, with the vector factor, its mirror image in the horizon.
            to_horizon = [d[2] ** 2 / (1 + np.hypot(d[0], d[1])) for d in (wi, wo)]
            image = np.sqrt(u * u + v * v + 4 * to_horizon[0] * to_horizon[1])
            for radius in [np.hypot(u, v)] + [image] * vector:
                if radius < r:
                    row = (rows - 1) * min(1.0, abs(w) / np.sqrt(4 - radius**2))
                    lobe = lobe + near(self.coherent, (columns - 1) * radius / r, row)
            for basis, patch in zip(chebyshev(t, len(self.cross)), self.cross if max(abs(u), abs(v)) < r else []):
                side = patch.shape[0] - 1
                total = total + basis * near(patch, side * (u + r) / (2 * r), side * (r - v) / (2 * r)) / abs(w)
        return factor * total + lobe_factor * lobe


def index_at(table, nm):
    """n and k at a wavelength: monotone cubics between those of the table."""
    at = np.array(table["wavelength_nm"])
    first = min(int(np.searchsorted(at, nm, "right")) - 1, len(at) - 2)

    def slope(values, knot):
        secant = lambda i: (values[i + 1] - values[i]) / (at[i + 1] - at[i])
        if knot in (0, len(at) - 1):
            return secant(max(knot - 1, 0))
        before, after = secant(knot - 1), secant(knot)
        if before * after <= 0:
            return 0.0
        a, b = at[knot] - at[knot - 1], at[knot + 1] - at[knot]
        return 3 * (a + b) / ((2 * b + a) / before + (2 * a + b) / after)

    def cubic(values):
        width = at[first + 1] - at[first]
        t = (nm - at[first]) / width
        s, (p, q) = 1 - t, values[first : first + 2]
        d, e = width * slope(values, first), width * slope(values, first + 1)
        return p * (1 + 2 * t) * s * s + q * t * t * (3 - 2 * t) + d * t * s * s - e * t * t * s

    return cubic(table["n"]), cubic(table["k"])


class Spectral:
    """The tables of single wavelengths."""

    def __init__(self, folder, about):
        self.about, self.optics = about["spectral"], about["optics"]
        expected = {"half": np.float16, "float": np.float32}[self.about["storage"]]

        def images(arrays, count, dtype=expected):
            found = [read_image(folder / array["file"], array["scale"]) for array in arrays]
            assert all(kind == dtype for _, kind in found), arrays
            return [found[n // 3][0][:, :, n % 3] for n in range(count)]

        self.tables = images(self.about["images"], self.about["tables"])
        self.splines = None
        self.lobe = self.about.get("lobe")
        if self.lobe:
            (self.power,) = images([self.lobe["power"]], 1, np.float32)
            cross = self.lobe.get("cross")
            self.cross = images(cross["images"], cross["patches"]) if cross else []

    def factors(self, wi, wo, nm):
        material = self.optics["material"]
        if "dispersion" in self.about:
            n, k = index_at(self.about["dispersion"], nm)
            material = {"conductor": {"n": n, "k": k}}
        c = np.linalg.norm(np.array(wi) + np.array(wo)) / 2
        mirror = fresnel(material, c)
        geometry = (1 + np.dot(wi, wo)) ** 2 / (wi[2] * wo[2])
        vector = self.optics.get("factor", "scalar") == "vector"
        diffuse = vector_factor(material, wi, wo) if vector and material != "ideal" else mirror * geometry
        lobe = mirror if vector else mirror * geometry / (wi[2] + wo[2]) ** 2
        shadowing = 1.0
        if self.optics["shadowing"]:
            m = (np.array(wi) + np.array(wo)) / (2 * c)
            shadowing = min(1.0, 2 * m[2] * wo[2] / np.dot(wo, m), 2 * m[2] * wi[2] / np.dot(wo, m))
        return diffuse * shadowing, lobe * shadowing, vector

    def evaluate(self, wi, wo, nm, splines=False):
        if splines and self.splines is None:
            self.splines = [coefficients(table) for table in self.tables]
        u, v, w = -(np.array(wi) + np.array(wo))
        r = self.about["shortest_nm"] / nm
        xi, eta = self.about["xi_per_nm"], self.about["eta_per_nm"]
        column, row = (
            (axis["samples"] - 1) * (x / nm - axis["first"]) / (axis["last"] - axis["first"])
            for axis, x in ((xi, u), (eta, v))
        )
        scaled_w = r * abs(w)
        t = min(1.0, scaled_w / np.sqrt(4 - r * r * (u * u + v * v)))
        by, near = (spline, cubic) if splines else (bilinear, bilinear)
        look_up = lambda by, image, x, y: by(image[:, :, None], x, y)[0]
        tables = self.splines if splines else self.tables
        total = sum(p * look_up(by, table, column, row) for p, table in zip(chebyshev(t, len(tables)), tables))
        diffuse, lobe_factor, vector = self.factors(wi, wo, nm)
        lobe = 0.0
        if self.lobe:
            if self.cross:
                axis = self.lobe["cross"]["xi_per_nm"]
                k, side = axis["last"], axis["samples"] - 1
                if max(abs(u), abs(v)) / nm < k:
                    x, y = side * (u / nm + k) / (2 * k), side * (k - v / nm) / (2 * k)
                    for p, patch in zip(chebyshev(t, len(self.cross)), self.cross):
                        total += p * look_up(near, patch, x, y) / scaled_w
            line = self.power[0]
            power = np.interp(scaled_w / 2 * (len(line) - 1), np.arange(len(line)), line)
            to_horizon = [d[2] ** 2 / (1 + np.hypot(d[0], d[1])) for d in (wi, wo)]
            distances = [u * u + v * v] + [u * u + v * v + 4 * to_horizon[0] * to_horizon[1]] * vector
            # A coherence that grows with the wavelength leaves the lobe what it is at the shortest.
            grows = self.lobe.get("sigma_grows", False)
            width = 2 * np.pi * self.lobe["sigma_nm"] / (self.about["shortest_nm"] if grows else nm)
            lobe = (1.0 if grows else r**2) * power * sum(np.exp(-(width**2) * distance) for distance in distances)
        return r**4 * diffuse * total + lobe_factor * lobe


def main(version):
    index = json.loads((version / "atlas.json").read_text())
    images = [file["path"] for file in index["files"] if file["path"].endswith(".exr")]
    for path in images:
        read_image(version / path, None)
    checked = 0
    for entry in index["specimens"]:
        specimen = Specimen(version / entry["name"])
        brightest = max((max(check["xyz"]) for check in specimen.about["check_values"]), default=0)
        for check in specimen.about["check_values"]:
            for key in [key for key in ("xyz", "xyz_spline") if key in check]:
                splines = key == "xyz_spline"
                expected, found = np.array(check[key]), specimen.evaluate(check["wi"], check["wo"], splines)
                size = np.max(np.abs(expected)) + (DARK * brightest if splines else 0)
                if not np.max(np.abs(found - expected)) <= TOLERANCE * size:
                    sys.exit(f"{entry['name']}, {key}: expected {expected}, found {found} at wi {check['wi']}, wo {check['wo']}")
                checked += 1
        if "spectral" not in specimen.about:
            continue
        spectral = Spectral(version / entry["name"], specimen.about)
        brightest = max(max(check["brdf"]) for check in spectral.about["check_values"])
        for check in spectral.about["check_values"]:
            for key in [key for key in ("brdf", "brdf_spline") if key in check]:
                expected, splines = np.array(check[key]), key == "brdf_spline"
                found = np.array([spectral.evaluate(check["wi"], check["wo"], nm, splines) for nm in check["wavelength_nm"]])
                size = np.max(np.abs(expected)) + (DARK * brightest if splines else 0)
                if not np.max(np.abs(found - expected)) <= TOLERANCE * size:
                    sys.exit(f"{entry['name']}, {key}: expected {expected}, found {found} at wi {check['wi']}, wo {check['wo']}")
                checked += len(expected)
    print(f"{len(images)} images read, {checked} check values met")
    if not images or not checked:
        sys.exit("nothing to check")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
