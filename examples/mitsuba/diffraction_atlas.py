"""A BSDF for Mitsuba 3 that evaluates the tables of a diffraction atlas.

    import mitsuba as mi
    mi.set_variant("llvm_ad_rgb")               # before the next line; or cuda_ad_rgb
    import diffraction_atlas                    # registers the plugin "diffraction"
    ball = mi.load_dict({"type": "sphere", "bsdf": {
        "type": "diffraction", "atlas": "out/atlas/bundled", "specimen": "sunbeam_snake_like"}})

Parameters:

- `atlas`: an atlas (its latest version is taken), one of its versions, or the folder of a specimen.
- `specimen`: name of the specimen; not needed where `atlas` is its folder or holds only one.
- `turn_deg`: turns the structure about the normal, counter-clockwise seen from outside. Its x axis otherwise runs along
  the texture coordinate u (`dp_du`), its y axis at a right angle to the left of it, mirrored coordinates or not (the
  program's own pictures of meshes mirror the structure with the coordinates). A mesh
  without texture coordinates has no such direction: give it some.
- `scale`: a factor on the BRDF, 1 by default.
- `look_up`: "linear" (default) between texels as graphics hardware, or "cubic", slower and more accurate.
- `energy_limit`: false by default; true keeps every direction from reflecting more than arrives, which ideal reflectors and the
  scalar factor do at grazing angles. Surfaces that never do stay as they are.
- `colours`: "srgb" (default) gives linear sRGB; "xyz" gives CIE XYZ in the three channels, see below.

Light. The tables hold XYZ with the colour of their illuminant (`optics.illuminant` in specimen.json, usually D65) in
them: a perfect white matt surface would read that illuminant's white, over pi. So give emitters as plain relative
numbers, the same in all channels: 1 is light of that illuminant. D65 is white, (1, 1, 1), in linear sRGB. A
coloured emitter multiplies channels of a sum over the spectrum, which is right only for colours that do not differ much
from white. There is no spectrum in the tables: the spectral and polarised variants are refused; "mono" variants get Y.

Colours outside sRGB. The colours of gratings are more saturated than sRGB can hold, and such a value has a negative
channel. It is returned as it is: orders of several wavelengths, or several lights, add up to the right sum only so, and
clipping would make it brighter. Map to the display's gamut at the end, as render.py does; do not denoise
before. With `colours = "xyz"` nothing is negative: the film then holds XYZ, which is to be converted at the
end, and everything else in the scene should be grey. Both give the same picture.

Tables restricted to scenes have no answer for other directions: the value is NaN there, and no such direction is
ever sampled. The surface reflects on its front only; the plugin "twosided" puts it on both.

The formulas are those of FORMAT.md in the atlas. Directions are unit vectors in the local frame of the structure; quantities
called `density` are per unit of (u, v), so that a density over directions is `cos(theta_o)` times it.
"""

import json
import math
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

if mi.variant() is None:
    raise ImportError('diffraction_atlas: choose a variant first, with mitsuba.set_variant("llvm_ad_rgb")')

# With a single thread Mitsuba 3.9 waits for ever for an EXR file to be read.
if dr.thread_count() < 2:
    dr.set_thread_count(2)

# FORMAT.md, "In a renderer".
SRGB_FROM_XYZ = ((3.2404542, -1.5371385, -0.4985314), (-0.9692660, 1.8760108, 0.0415560), (0.0556434, -0.2040259, 1.0572252))
# Of the directions that are not sampled from the lobe, the share sampled from the tables; the rest covers the hemisphere
# evenly in (u, v), so that nothing the tables' mean over t underrates has a large weight.
TABLE_SHARE = 0.85
# The lobe gets at least and at most this share of the samples.
LOBE_SHARE = (0.05, 0.95)
# Values of t over which the tables are averaged to sample (u, v).
SAMPLED_T = 8
# Entries of the energy limit over the root of the cosine.
LIMIT_NODES = 1025
# As the program's own shader: how far `t` may leave the covered range by rounding.
RANGE_SLACK = 0.02


def specimen_folder(atlas, specimen):
    """The folder with specimen.json that the plugin's parameters name.

    Raises ValueError that says what is there instead.
    """
    folder = Path(atlas)
    if not folder.exists():
        folder = Path(str(mi.file_resolver().resolve(str(atlas))))
    if (folder / "specimen.json").is_file():
        if specimen not in ("", folder.name):
            raise ValueError(f'diffraction: "{atlas}" is the folder of "{folder.name}", not of "{specimen}"')
        return folder
    if (folder / "latest").is_file():
        folder = folder / (folder / "latest").read_text().strip()
    if not (folder / "atlas.json").is_file():
        raise ValueError(
            f'diffraction: atlas = "{atlas}" is neither an atlas (with a file "latest"), nor one of its versions (with '
            '"atlas.json"), nor the folder of a specimen (with "specimen.json")'
        )
    names = [entry["name"] for entry in json.loads((folder / "atlas.json").read_text())["specimens"]]
    if not specimen and len(names) == 1:
        specimen = names[0]
    if specimen not in names:
        raise ValueError(f'diffraction: specimen = "{specimen}"; {folder} has {", ".join(names)}')
    return folder / specimen


def read_image(folder, entry):
    """Values [row, column, 3] of a file named in specimen.json, its scale applied."""
    bitmap = mi.Bitmap(str(folder / entry["file"]))
    if bitmap.pixel_format() != mi.Bitmap.PixelFormat.RGB:
        raise ValueError(f'diffraction: {folder / entry["file"]} has not the channels R, G, B')
    return np.array(bitmap).astype(np.float32) * np.float32(entry["scale"])


class Layers:
    """Images of one size, in an array that a kernel reads: texel (row, column) of layer n and its channel c stand at
    `((row columns + column) layers + n) 4 + c`; the fourth channel is unused and makes one packet of a texel."""

    def __init__(self, images):
        self.rows, self.columns, _ = images[0].shape
        self.count = len(images)
        padded = np.zeros((self.rows, self.columns, self.count, 4), np.float32)
        padded[..., :3] = np.stack(images, axis=2)
        self.texels = mi.Float(padded.ravel())


def stencil(at, count, cubic):
    """First texel and weights along an axis of `count` texels, at a position in texels from the first one's centre."""
    at = dr.clip(at, 0.0, count - 1.0)
    if not cubic or count < 4:
        first = dr.minimum(mi.UInt32(at), count - 2)
        x = at - mi.Float(first)
        return first, (1 - x, x)
    first = mi.UInt32(dr.clip(mi.Int32(at) - 1, 0, count - 4))
    x = at - mi.Float(first)
    # Lagrange's cubic through the nodes 0, 1, 2, 3.
    a, b, c = x - 1, x - 2, x - 3
    return first, (-a * b * c / 6, x * b * c / 2, -x * a * c / 2, x * a * b / 6)


def look_up(layers, basis, column, row, cubic, active):
    """Sum over n of `basis[n]` times layer n at a position in texels: three channels."""
    first_column, column_weights = stencil(column, layers.columns, cubic)
    first_row, row_weights = stencil(row, layers.rows, cubic)
    total = mi.Vector4f(0)
    for dy, row_weight in enumerate(row_weights):
        for dx, column_weight in enumerate(column_weights):
            texel = ((first_row + dy) * layers.columns + first_column + dx) * layers.count
            corner = mi.Vector4f(0)
            for n, factor in enumerate(basis):
                corner = dr.fma(factor, dr.gather(mi.Vector4f, layers.texels, texel + n, active), corner)
            total = dr.fma(row_weight * column_weight, corner, total)
    return mi.Color3f(total.x, total.y, total.z)


def chebyshev(x, count):
    """`T_0` to `T_(count - 1)` at x: of floats, arrays of numpy or of Dr.Jit."""
    values = [0 * x + 1, x]
    while len(values) < count:
        values.append(2 * x * values[-1] - values[-2])
    return values[:count]


class Diffraction(mi.BSDF):
    """See the top of this file."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        if mi.is_spectral or mi.is_polarized or not dr.is_jit_v(mi.Float):
            raise ValueError(
                f'diffraction: the variant "{mi.variant()}" will not do: tables of XYZ hold no spectrum and no polarisation, '
                'and Python needs a vectorised variant. Use "llvm_ad_rgb" or "cuda_ad_rgb"'
            )
        self.folder = specimen_folder(str(props["atlas"]), str(props.get("specimen", "")))
        self.scale = float(props.get("scale", 1.0))
        self.turn = math.radians(float(props.get("turn_deg", 0.0)))
        self.cubic = {"linear": False, "cubic": True}[choice(props, "look_up", ("linear", "cubic"))]
        self.is_limited = bool(props.get("energy_limit", False))
        self.as_xyz = choice(props, "colours", ("srgb", "xyz")) == "xyz"

        about = json.loads((self.folder / "specimen.json").read_text())
        self.read_optics(about["optics"])
        self.read_tables(about["tables"])
        self.limit = None
        if self.is_limited and about.get("energy_limit"):
            self.limit = limit_by_root(about["energy_limit"])
        reflection = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.Anisotropic
        self.m_components = [reflection]
        self.m_flags = reflection

    # Reading

    def read_optics(self, optics):
        self.shadowing = optics["shadowing"]
        self.vector = optics.get("factor", "scalar") == "vector"
        self.index = None
        if optics["material"] != "ideal":
            ((_, index),) = optics["material"].items()
            self.index = complex(index["n"], index.get("k", 0.0))

    def read_tables(self, stored):
        self.basis = stored["basis"]
        if self.basis not in ("chebyshev", "taylor"):
            raise ValueError(f'diffraction: {self.folder} has tables in the basis "{self.basis}", which is not known here')
        self.u_axis, self.v_axis = stored["u"], stored["v"]
        images = [read_image(self.folder, entry) for entry in stored["tables"]]
        self.tables = Layers(images)
        self.range = None
        if stored.get("served"):
            self.range = Layers([read_image(self.folder, stored["served"]["range"])])
        self.prepare_table_samples(images)

        self.coherent = self.cross = None
        if stored["lobe"]:
            self.radius_max = stored["lobe"]["radius_max"]
            coherent = read_image(self.folder, stored["lobe"]["coherent"])
            self.coherent = Layers([coherent])
            if stored["lobe"]["cross"]:
                self.cross = Layers([read_image(self.folder, entry) for entry in stored["lobe"]["cross"]["patches"]])
            self.prepare_lobe_samples(coherent)

    def prepare_table_samples(self, images):
        """(u, v) is sampled in proportion to the tables' sum, all channels, averaged over t."""
        density = np.zeros(images[0].shape[:2])
        for t in (np.arange(SAMPLED_T) + 0.5) / SAMPLED_T:
            basis = chebyshev(2 * t - 1, len(images))
            if self.basis == "taylor":
                basis = [(2 * t) ** (n - 2) for n in range(len(images))]
            total = sum(factor * image.astype(np.float64) for factor, image in zip(basis, images))
            density += np.maximum(total.sum(axis=2), 0.0)
        if not density.max() > 0:
            density += 1
        self.table_density = mi.MarginalContinuous2D0((density / density.max()).astype(np.float32))
        self.table_area = abs(
            (self.u_axis["last"] - self.u_axis["first"]) * (self.v_axis["last"] - self.v_axis["first"])
        )

    def prepare_lobe_samples(self, coherent):
        """The radius is sampled in proportion to the lobe, all channels, at t = 1; its width changes little with t."""
        radius = np.linspace(0.0, self.radius_max, coherent.shape[1])
        power = coherent.astype(np.float64).mean(axis=2) * radius
        per_radius = (power[-1] / power[-1].max()).astype(np.float32)
        self.radius_density = mi.ContinuousDistribution([0.0, self.radius_max], mi.Float(per_radius))
        # What the lobe reflects of the light, by t: in the mirror direction t = cos(theta_i) and G / w^2 = 1.
        reflected = 2 * np.pi * power.sum(axis=1) * radius[1]
        self.lobe_share_of_row = mi.Float(np.clip(reflected, *LOBE_SHARE).astype(np.float32))

    # The BRDF, as FORMAT.md tells

    def brdf_xyz(self, wi, wo, active):
        """X, Y, Z in 1/sr; 0 where a direction is not above the surface, NaN where the tables have no answer."""
        active = active & (wi.z > 0) & (wo.z > 0)
        one_plus = 1 + dr.dot(wi, wo)
        mirror = self.reflectance(dr.safe_sqrt(one_plus / 2))
        front = mirror * (one_plus / wi.z) * (one_plus / wo.z)
        w = wi.z + wo.z
        coherent = mirror if self.vector else front / w / w
        if self.vector and self.index is not None:
            front = 2 * wi.z * wo.z * self.polarised_sum(wi, wo)
        if self.shadowing:
            m = dr.normalize(wi + wo)
            shadowing = dr.minimum(1, 2 * m.z / dr.dot(wo, m) * dr.minimum(wi.z, wo.z))
            front, coherent = front * shadowing, coherent * shadowing
        value = front * self.diffuse(-(wi + wo), active) + coherent * self.lobe(wi, wo, active)
        if self.limit is not None:
            value = value / dr.maximum(1, dr.maximum(self.albedo(wi.z, active), self.albedo(wo.z, active)))
        return dr.select(active, value, 0.0)

    def albedo(self, cos_theta, active):
        """The largest directional albedo over azimuths."""
        first, weights = stencil(dr.safe_sqrt(cos_theta) * (LIMIT_NODES - 1), LIMIT_NODES, False)
        product = sum(weight * dr.gather(mi.Float, self.limit, first + n, active) for n, weight in enumerate(weights))
        return product / dr.maximum(cos_theta, 1e-9)

    def polarised_sum(self, wi, wo):
        """`Q_ss + Q_sp + Q_ps + Q_pp` of first-order vector perturbation; the azimuth is 0 on the mirror's side."""
        eps = self.index**2
        sine2_i, sine2_o = (d.x * d.x + d.y * d.y for d in (wi, wo))
        sines = dr.sqrt(sine2_i) * dr.sqrt(sine2_o)
        lateral = -(wi.x * wo.x + wi.y * wo.y)
        cos_phi = dr.select(sines > 1e-12, dr.clip(lateral / dr.maximum(sines, 1e-12), -1, 1), 1)
        sin2_phi = 1 - cos_phi * cos_phi
        epsilon = mi.Complex2f(eps.real, eps.imag)
        a, b = dr.sqrt(epsilon - sine2_i), dr.sqrt(epsilon - sine2_o)
        s_i, s_o = (dr.squared_norm(root + d.z) for root, d in ((a, wi), (b, wo)))
        p_i, p_o = (dr.squared_norm(epsilon * d.z + root) for root, d in ((a, wi), (b, wo)))
        across = dr.squared_norm(a * b * cos_phi - epsilon * sines) / (p_i * p_o)
        crossed = dr.squared_norm(b) / (s_i * p_o) + dr.squared_norm(a) / (p_i * s_o)
        return abs(eps - 1) ** 2 * (cos_phi * cos_phi / (s_i * s_o) + sin2_phi * crossed + across)

    def reflectance(self, c):
        """Fresnel's, of unpolarised light; c is the cosine at the half vector."""
        if self.index is None:
            return 1.0
        n2 = mi.Complex2f(self.index.real**2 - self.index.imag**2, 2 * self.index.real * self.index.imag)
        g = dr.sqrt(n2 - 1 + c * c)
        a, b = (c - g) / (c + g), (n2 * c - g) / (n2 * c + g)
        return (dr.squared_norm(a) + dr.squared_norm(b)) / 2

    def diffuse(self, q, active):
        """Tables and cross term without their factor."""
        u, v, w = q.x, q.y, dr.abs(q.z)
        column, row = self.table_position(u, v)
        if self.basis == "taylor":
            powers = [1 / w / w]
            while len(powers) < self.tables.count:
                powers.append(powers[-1] * w)
            return look_up(self.tables, powers, column, row, self.cubic, active)
        reach = dr.safe_sqrt(4 - u * u - v * v)
        t = dr.select(reach > 0, dr.minimum(w / reach, 1), 0)
        s, covered = t, True
        if self.range is not None:
            s, covered = self.share_of_range(t, column, row, active)
        value = look_up(self.tables, chebyshev(2 * s - 1, self.tables.count), column, row, self.cubic, active)
        if self.coherent is not None and self.cross is not None:
            value += self.cross_term(u, v, w, t, active)
        return dr.select(covered, value, dr.nan)

    def table_position(self, u, v):
        """Column and row: axes are given by the centres of their first and last texels."""
        return (
            (x - axis["first"]) * ((axis["samples"] - 1) / (axis["last"] - axis["first"]))
            for axis, x in ((self.u_axis, u), (self.v_axis, v))
        )

    def share_of_range(self, t, column, row, active):
        """Where t lies in the range that the texels cover, 0 to 1, and whether there is an answer."""
        low, high, there = look_up(self.range, [1.0], column, row, self.cubic, active)
        s = (t - low) / (high - low)
        inside = (column >= 0) & (column <= self.range.columns - 1) & (row >= 0) & (row <= self.range.rows - 1)
        covered = inside & (dr.abs(there - 1) < 0.002) & (s >= -RANGE_SLACK) & (s <= 1 + RANGE_SLACK)
        return dr.clip(s, 0, 1), covered

    def lobe(self, wi, wo, active):
        """The coherent lobe without its factor and, with the vector factor, its mirror image in the horizon: the light that
        would leave below."""
        if self.coherent is None:
            return mi.Color3f(0)
        q = -(wi + wo)
        radius2 = q.x * q.x + q.y * q.y
        value = self.lobe_at(dr.sqrt(radius2), dr.abs(q.z), active)
        if self.vector:
            to_horizon = [d.z * d.z / (1 + dr.sqrt(d.x * d.x + d.y * d.y)) for d in (wi, wo)]
            image = dr.sqrt(radius2 + 4 * to_horizon[0] * to_horizon[1])
            value += self.lobe_at(image, dr.abs(q.z), active)
        return value

    def lobe_at(self, radius, w, active):
        in_lobe = active & (radius < self.radius_max)
        t = dr.minimum(w / dr.sqrt(dr.maximum(4 - radius * radius, 1e-12)), 1)
        column, row = radius * ((self.coherent.columns - 1) / self.radius_max), t * (self.coherent.rows - 1)
        return dr.select(in_lobe, look_up(self.coherent, [1.0], column, row, self.cubic, in_lobe), 0.0)

    def cross_term(self, u, v, w, t, active):
        in_patch = active & (dr.abs(u) < self.radius_max) & (dr.abs(v) < self.radius_max)
        texels = (self.cross.columns - 1) / (2 * self.radius_max)
        column, row = (u + self.radius_max) * texels, (self.radius_max - v) * texels
        polynomials = chebyshev(2 * t - 1, self.cross.count)
        cross = look_up(self.cross, polynomials, column, row, self.cubic, in_patch) / w
        return dr.select(in_patch, cross, 0.0)

    def spectrum(self, xyz):
        """What the variant calls a spectrum, of X, Y, Z."""
        if mi.is_monochromatic:
            return mi.Spectrum(self.scale * xyz.y)
        if self.as_xyz:
            return mi.Spectrum(self.scale * xyz)
        return mi.Spectrum(*(self.scale * sum(factor * c for factor, c in zip(line, xyz)) for line in SRGB_FROM_XYZ))

    # Sampling: a mixture of the lobe, the tables and the whole hemisphere

    def lobe_share(self, cos_theta_i):
        """Share of the samples that the lobe gets; what is below the surface gets that of t = 0."""
        if self.coherent is None:
            return mi.Float(0.0)
        first, weights = stencil(cos_theta_i * (self.coherent.rows - 1), self.coherent.rows, False)
        return sum(weight * dr.gather(mi.Float, self.lobe_share_of_row, first + n) for n, weight in enumerate(weights))

    def density(self, wi, wo):
        """Of the mixture, per unit of (u, v)."""
        u, v = -(wi.x + wo.x), -(wi.y + wo.y)
        place = mi.Point2f(
            *((x - axis["first"]) / (axis["last"] - axis["first"]) for axis, x in ((self.u_axis, u), (self.v_axis, v)))
        )
        inside = (place.x >= 0) & (place.x <= 1) & (place.y >= 0) & (place.y <= 1)
        tables = dr.select(inside, self.table_density.eval(place) / self.table_area, 0)
        total = dr.lerp(dr.inv_pi, tables, TABLE_SHARE)
        if self.coherent is None:
            return total
        radius = dr.maximum(dr.sqrt(u * u + v * v), 1e-9)
        lobe = dr.select(
            radius < self.radius_max, self.radius_density.eval_pdf_normalized(radius) / (dr.two_pi * radius), 0
        )
        return dr.lerp(total, lobe, self.lobe_share(wi.z))

    def draw_uv(self, lobe_share, sample1, sample2):
        """(u, v) from the lobe or the tables, and whether to take the whole hemisphere instead."""
        place, _ = self.table_density.sample(sample2)
        u = dr.lerp(self.u_axis["first"], self.u_axis["last"], place.x)
        v = dr.lerp(self.v_axis["first"], self.v_axis["last"], place.y)
        if self.coherent is not None:
            radius, _ = self.radius_density.sample_pdf(sample2.x)
            sin, cos = dr.sincos(dr.two_pi * sample2.y)
            from_lobe = sample1 < lobe_share
            u, v = dr.select(from_lobe, radius * cos, u), dr.select(from_lobe, radius * sin, v)
        return u, v, sample1 >= dr.lerp(lobe_share, 1, TABLE_SHARE)

    # Mitsuba's interface: directions in the shading frame, values times cos(theta_o)

    def structure_axis(self, si):
        """Cosine and sine from the shading frame's x axis to the structure's."""
        along = si.to_local(si.dp_du)
        length = dr.sqrt(along.x * along.x + along.y * along.y)
        cos = dr.select(length > 0, along.x / length, 1)
        sin = dr.select(length > 0, along.y / length, 0)
        c, s = math.cos(self.turn), math.sin(self.turn)
        return cos * c - sin * s, sin * c + cos * s

    def eval(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[0]

    def pdf(self, ctx, si, wo, active=True):
        return self.eval_pdf(ctx, si, wo, active)[1]

    def eval_pdf(self, ctx, si, wo, active=True):
        axis = self.structure_axis(si)
        wi, wo = to_structure(axis, si.wi), to_structure(axis, wo)
        enabled = ctx.is_enabled(mi.BSDFFlags.GlossyReflection)
        active = mi.Bool(active) & enabled & (wi.z > 0) & (wo.z > 0)
        value = self.spectrum(self.brdf_xyz(wi, wo, active)) * wo.z
        return dr.select(active, value, 0.0), dr.select(active, self.density(wi, wo) * wo.z, 0.0)

    def sample(self, ctx, si, sample1, sample2, active=True):
        axis = self.structure_axis(si)
        wi = to_structure(axis, si.wi)
        u, v, anywhere = self.draw_uv(self.lobe_share(wi.z), sample1, sample2)
        disk = mi.warp.square_to_uniform_disk_concentric(sample2)
        x = dr.select(anywhere, disk.x, -wi.x - u)
        y = dr.select(anywhere, disk.y, -wi.y - v)
        z2 = 1 - x * x - y * y
        wo = mi.Vector3f(x, y, dr.safe_sqrt(z2))
        active = mi.Bool(active) & ctx.is_enabled(mi.BSDFFlags.GlossyReflection) & (wi.z > 0) & (z2 > 0)

        bs = dr.zeros(mi.BSDFSample3f)
        bs.wo = to_shading(axis, wo)
        bs.pdf = dr.select(active, self.density(wi, wo) * wo.z, 0.0)
        bs.eta = 1.0
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.sampled_component = mi.UInt32(0)
        value = self.spectrum(self.brdf_xyz(wi, wo, active)) * wo.z / bs.pdf
        # Where the tables have no answer there is no sample; light sampling shows NaN there.
        return bs, dr.select(active & (bs.pdf > 0) & dr.all(dr.isfinite(value)), value, 0.0)

    def to_string(self):
        return f"Diffraction[\n  folder = {self.folder},\n  scale = {self.scale}\n]"


def limit_by_root(stored):
    """`albedo cos_theta` of an energy limit, at even steps of the root of the cosine."""
    cos_theta, albedo = (np.array(stored[key]) for key in ("cos_theta", "albedo"))
    places = np.linspace(0.0, 1.0, LIMIT_NODES) ** 2
    return mi.Float(np.interp(places, cos_theta, albedo * cos_theta).astype(np.float32))


def choice(props, key, allowed):
    """The string of a parameter, the first of `allowed` where it is not given."""
    value = str(props.get(key, allowed[0]))
    if value not in allowed:
        raise ValueError(f'diffraction: {key} = "{value}"; it may be {" or ".join(allowed)}')
    return value


def to_structure(axis, v):
    """A vector of the shading frame in that of the structure."""
    cos, sin = axis
    return mi.Vector3f(cos * v.x + sin * v.y, cos * v.y - sin * v.x, v.z)


def to_shading(axis, v):
    """The inverse."""
    cos, sin = axis
    return mi.Vector3f(cos * v.x - sin * v.y, cos * v.y + sin * v.x, v.z)


mi.register_bsdf("diffraction", Diffraction)
