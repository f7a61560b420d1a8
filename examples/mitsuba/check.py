"""Checks the BSDF of diffraction_atlas.mitsuba against a version of an atlas.

    python3 examples/mitsuba/check.py out/atlas/bundled

For every specimen: its check values, of X, Y, Z and of single wavelengths; the samples' density and the power they return, at grazing angles too where
that is limited; a ball under a white sky without fireflies; a ball rendered by Mitsuba against the atlas's own picture of it, and its derivative with
respect to the light's direction against differences. Then every check is made once more with a mistake put in, which it has to find.
Exit status 0 if all is well. Wants Python 3.11, mitsuba and the package `diffraction-atlas`; two minutes on two cores.
"""

import json
import math
import sys
import tomllib
from pathlib import Path

import drjit as dr
import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import diffraction_atlas.mitsuba  # noqa: E402  (needs the variant)

# The check values are in double precision; the plugin computes in single. A position in the tables is rounded by
# 2^-23 of its size, 600 texels: 7e-5 texels. Between the orders of a grating the values of neighbouring texels differ up
# to tenfold. Every mistake below shifts a value by more than a hundredth.
VALUE_TOLERANCE = 1e-3
# Directions turned in single precision, 3e-7, shift the look-up by 150 times as many texels.
FRAME_TOLERANCE = 1e-3
# Mitsuba's colours against those of FORMAT.md: constants of four digits more or less.
COLOUR_TOLERANCE = 1e-3
# How often a right sampler may be called wrong, for one test.
SIGNIFICANCE = 1e-6
SAMPLES = 1 << 17
# Angle from the mirror direction, in radians, below which cells of the test are about even in it, and above which in its logarithm.
LOBE_ANGLE = 0.02
# Specimens whose densities, powers and derivatives are tested; at grazing angles the lobe is cut by the horizon.
DENSITIES, THETAS_DEG = slice(0, 3, 2), (0, 35, 70, 85, 89)
# Derivatives against differences over this many radians, of pictures: norm. A look-up's kinks between texels lie within them.
STEP_RADIANS, GRADIENT_TOLERANCE = 1e-3, 0.02
# The power sums of the report are sums over a grid of 256 steps; the mean of samples has a known standard error.
POWER_TOLERANCE, POWER_SIGMAS = 2e-3, 5
# What the energy limit may miss between its angles.
LIMIT_TOLERANCE = 0.01
# The brightest pixel of a ball under a white sky in so many samples, over the mean of the ball: a viewer sees nothing brighter than the sky times albedo,
# and what is beyond is noise of the sampling.
FIREFLY_SAMPLES, FIREFLY_TIMES = 64, 20
# Points of a light's disc against its whole: norm.
FILTERED_TOLERANCE = 5e-3
# Pictures: both sides look through the centre of each pixel at the same points of the lamp. Normals in single precision
# are off by some 1e-7, which grazing directions (1 / cos) and steep lobes raise. Norm, and share of the pixels, brighter than
# a ten-thousandth of the mean, that may differ more.
PICTURE_TOLERANCE, PICTURE_OUTLIERS = 1e-3, 0.01
# Samples of a light in pictures that are compared with a reference.
COMPARED_SAMPLES = 2
# src/scene/light.rs: points of a lamp's disc, and src/scene/sphere.rs: the ball.
GOLDEN_TURNS = 0.381966011250105
BALL_RADIUS = 0.95

CONTEXT = mi.BSDFContext()

def load(version, name, **more):
    """The plugin in XYZ, with the model's own values: check values and pictures are of no energy limit."""
    more = {"colours": "xyz", "energy_limit": False, **more}
    return mi.load_dict({"type": "diffraction", "atlas": str(version), "specimen": name, **more})

def facing(wi, count):
    """Surface points whose shading frame is the structure's."""
    si = dr.zeros(mi.SurfaceInteraction3f, count)
    # A number that kernels hold as such makes every direction a kernel of its own.
    dr.make_opaque(wi)
    si.wi = wi
    return si

# The checks. Each returns how large its error is, as a share of what is allowed: above 1 it has failed.

def values_error(bsdf, check_values):
    wi, wo = (mi.Vector3f(np.array([check[key] for check in check_values], np.float32).T) for key in ("wi", "wo"))
    expected = np.array([check["xyz"] for check in check_values])
    found = np.array(bsdf.eval(CONTEXT, facing(wi, len(check_values)), wo) / wo.z).T
    error = np.abs(found - expected).max(axis=1)
    # Between the orders of a grating the value is exactly 0, and so it must be found.
    return (error / (VALUE_TOLERANCE * np.abs(expected).max(axis=1)).clip(1e-30)).max()

def colour_error(bsdf, in_srgb, check_values):
    """Linear sRGB against Mitsuba's own conversion of XYZ."""
    wi, wo = (mi.Vector3f(np.array([check[key] for check in check_values], np.float32).T) for key in ("wi", "wo"))
    si = facing(wi, len(check_values))
    xyz = bsdf.eval(CONTEXT, si, wo)
    found, expected = np.array(in_srgb.eval(CONTEXT, si, wo)), np.array(mi.xyz_to_srgb(xyz))
    return (np.abs(found - expected) / (COLOUR_TOLERANCE * np.array(xyz).max(axis=0)).clip(1e-30)).max()

def density_error(sampled, stated, theta_deg):
    """Chi square of `sampled.sample` against `stated.pdf`, over the angle from the mirror direction and the azimuth around it: there the lobe is as wide
    everywhere."""
    theta = math.radians(theta_deg)
    wi = mi.Vector3f(math.sin(theta), 0, math.cos(theta))
    frame = mi.Frame3f(mi.Vector3f(-math.cos(theta), 0, -math.sin(theta)), mi.Vector3f(0, 1, 0), mi.Vector3f(-math.sin(theta), 0, math.cos(theta)))

    def draw(sample):
        bs, _ = sampled.sample(CONTEXT, facing(wi, dr.width(sample)), sample[0], mi.Point2f(sample[1], sample[2]))
        # Weight 0 where there is no sample, which is not where the BRDF is 0.
        there = bs.pdf > 0
        local = frame.to_local(bs.wo)
        angle = dr.atan2(dr.sqrt(local.x * local.x + local.y * local.y), local.z)
        return dr.select(there, mi.Point2f(dr.asinh(angle / LOBE_ANGLE), dr.atan2(local.y, local.x)), 0), dr.select(there, mi.Float(1), 0)

    def density(place):
        angle = LOBE_ANGLE * dr.sinh(place.x)
        sin, cos = dr.sincos(angle)
        wo = frame.to_world(mi.Vector3f(sin * dr.cos(place.y), sin * dr.sin(place.y), cos))
        density = stated.pdf(CONTEXT, facing(wi, dr.width(place)), wo)
        return density * sin * LOBE_ANGLE * dr.cosh(place.x)

    reach = math.asinh(math.pi / LOBE_ANGLE)
    domain = mi.chi2.PlanarDomain(mi.ScalarBoundingBox2f([0, -math.pi], [reach, math.pi]))
    test = mi.chi2.ChiSquareTest(domain, draw, density, sample_dim=3, sample_count=SAMPLES, res=41, ires=33)
    test.run(significance_level=SIGNIFICANCE, quiet=True)
    # The chance that a right sampler does as badly, in powers of ten.
    chance = 0.0 if test.fail else float(test.p_value)
    return math.log(chance) / math.log(SIGNIFICANCE) if chance > 0 else math.inf

def weights(bsdf, theta_deg, phi_deg):
    """Y of the samples of one direction, whose mean is the share of the light that is reflected."""
    random = mi.PCG32(SAMPLES)
    one, two = random.next_float32(), mi.Point2f(random.next_float32(), random.next_float32())
    theta, phi = math.radians(theta_deg), math.radians(phi_deg)
    wi = mi.Vector3f(math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
    _, weight = bsdf.sample(CONTEXT, facing(wi, SAMPLES), one, two)
    return np.array(weight)[1].astype(np.float64)

def limit_error(bsdf):
    """How much more is reflected than arrives."""
    worst = 0.0
    for theta_deg in (60, 80, 89.5):
        for phi_deg in (0, 67):
            y = weights(bsdf, theta_deg, phi_deg)
            worst = np.maximum(worst, (y.mean() - 1) / (LIMIT_TOLERANCE + POWER_SIGMAS * y.std() / math.sqrt(SAMPLES)))
    return worst

def power_error(bsdf, power_sums):
    """Mean weight of the samples, of unit reflectance, against the sums of the report."""
    optics = bsdf.brdf.optics
    index, optics.n, optics.k = (optics.n, optics.k), None, None
    worst = 0.0
    for power in power_sums:
        y = weights(bsdf, power["theta_i_deg"], 0)
        allowed = POWER_TOLERANCE * power["sum"] + POWER_SIGMAS * y.std() / math.sqrt(SAMPLES)
        worst = np.maximum(worst, abs(y.mean() - power["sum"]) / allowed)
    optics.n, optics.k = index
    return worst

def firefly_error(bsdf):
    """The brightest pixel of a ball under a white sky over the mean of the ball."""
    size_px = 64
    sky = {"type": "constant", "radiance": {"type": "rgb", "value": [1.0] * 3}}
    image = np.array(mi.render(ball(bsdf, sky, size_px), spp=FIREFLY_SAMPLES, seed=1))[..., 1].astype(np.float64)
    across = (2 * np.arange(size_px) + 1) / size_px - 1
    # Pixels at the rim see the sky itself.
    on_ball = np.hypot(*np.meshgrid(across, across)) < BALL_RADIUS - 4 / size_px
    return image[on_ball].max() / image[on_ball].mean() / FIREFLY_TIMES

def picture_error(bsdf, scene, expected):
    size_px = scene.get("size_px", 512)
    stride = -(-size_px // expected.shape[0])
    rendered = sum(render_ball(bsdf, *light, size_px) for light in light_samples(scene))[::stride, ::stride]
    error, bright = np.abs(rendered - expected).max(axis=2), np.maximum(rendered, expected).max(axis=2)
    compared = bright > 1e-4 * bright.mean()
    outliers = (error > PICTURE_TOLERANCE * bright)[compared].mean()
    norm = np.linalg.norm(rendered - expected) / np.linalg.norm(expected)
    return np.maximum(norm / PICTURE_TOLERANCE, outliers / PICTURE_OUTLIERS)

def mirror_error(mirrored, plain):
    """A square whose v runs the other way, so that its structure is mirrored, against the BRDF with both directions mirrored."""
    square = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
    mesh = mi.Mesh("square", 4, 2, has_vertex_texcoords=True)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = square.ravel()
    parameters["vertex_texcoords"] = (square[:, :2] * [1, -1]).astype(np.float32).ravel()
    parameters["faces"] = np.array([0, 1, 2, 0, 2, 3], np.uint32)
    parameters.update()
    azimuths_deg = dr.linspace(mi.Float, 0, 360, 256)
    viewer = direction(25, 70)
    si = mi.load_dict({"type": "scene", "mesh": mesh}).ray_intersect(mi.Ray3f(2 * mi.Point3f(viewer), -viewer))
    found = np.array(mirrored.eval(CONTEXT, si, si.to_local(direction(40, azimuths_deg))))
    expected = np.array(plain.eval(CONTEXT, facing(direction(25, -70), 256), direction(40, -azimuths_deg)))
    return np.abs(found - expected).max() / (FRAME_TOLERANCE * expected.max())

def gradient_error(bsdf, factor=1.0):
    """How a picture of a ball changes with the direction of its light: derivatives of the rendered picture against differences."""
    size_px = 64

    def picture(angle):
        scene = ball(bsdf, directional([0.0, 0.0, 1.0], 1.0), size_px)
        parameters = mi.traverse(scene)
        turn = mi.Transform4f().rotate(mi.Vector3f(1, 1, 0), dr.rad2deg(0.5 + angle))
        parameters["light.to_world"] = turn @ mi.Transform4f().look_at([0, 0, 0], [0, 0, -1], [0, 1, 0])
        parameters.update()
        return mi.render(scene, parameters, spp=1, seed=0)

    angle = mi.Float(0)
    dr.enable_grad(angle)
    image = picture(angle)
    dr.forward(angle)
    found = np.array(dr.grad(image)).astype(np.float64)
    low, high = (np.array(picture(mi.Float(step))).astype(np.float64) for step in (-STEP_RADIANS, STEP_RADIANS))
    expected = factor * (high - low) / (2 * STEP_RADIANS)
    return np.linalg.norm(found - expected) / np.linalg.norm(expected) / GRADIENT_TOLERANCE

def filtered_error(version, name, light_deg, asked_deg=None):
    """The mean over a light's disc against the package's, within what thirty-two points miss of an ellipse a few texels wide."""
    bsdf = load(version, name, light_deg=asked_deg or light_deg)
    specimen = bsdf.given.specimen
    random = np.random.default_rng(1).random((2, 512, 2))
    wi, wo = (diffraction_atlas.from_angles_deg(75 * part[:, 0], 360 * part[:, 1]) for part in random)
    # Half of them near the mirror direction.
    wo[:256] = diffraction_atlas.from_angles_deg(75 * random[0, :256, 0] + 2 * random[1, :256, 0], 360 * random[0, :256, 1] + 180)
    expected = specimen.eval_filtered(wi, wo, angular_diameter_deg=light_deg)
    light, viewer = (mi.Vector3f(d.astype(np.float32).T) for d in (wi, wo))
    found = np.array(bsdf.eval(CONTEXT, facing(viewer, 512), light) / light.z).T
    return np.linalg.norm(found - expected) / np.linalg.norm(expected) / FILTERED_TOLERANCE

def frame_error(bsdf, turned):
    """A square whose texture coordinates are turned by 30 degrees, and sheared, against the BRDF with directions turned;
    `turned` has a `turn_deg` of 20 besides."""
    angle = math.radians(30)
    square = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], np.float32)
    along = np.array([math.cos(angle), math.sin(angle)])
    # u grows along `along` when v, whose axis is not at a right angle to it, is kept.
    skew = np.array([math.cos(angle + 1.1), math.sin(angle + 1.1)])
    uv = square[:, :2] @ np.linalg.inv(np.array([along, skew]))
    mesh = mi.Mesh("square", 4, 2, has_vertex_texcoords=True)
    parameters = mi.traverse(mesh)
    parameters["vertex_positions"] = square.ravel()
    parameters["vertex_texcoords"] = uv.astype(np.float32).ravel()
    parameters["faces"] = np.array([0, 1, 2, 0, 2, 3], np.uint32)
    parameters.update()
    viewer, azimuths_deg = direction(25, 70), dr.linspace(mi.Float, 0, 360, 256)
    si = mi.load_dict({"type": "scene", "mesh": mesh}).ray_intersect(mi.Ray3f(2 * mi.Point3f(viewer), -viewer))
    worst = 0.0
    for plugin, turn_deg in ((bsdf, 30), (turned, 50)):
        found = np.array(plugin.eval(CONTEXT, si, si.to_local(direction(40, azimuths_deg))))
        points = facing(direction(25, 70 - turn_deg), 256)
        expected = np.array(bsdf.eval(CONTEXT, points, direction(40, azimuths_deg - turn_deg)))
        worst = np.maximum(worst, np.abs(found - expected).max() / (FRAME_TOLERANCE * expected.max()))
    return worst

# What they need

def direction(theta_deg, phi_deg):
    sin, cos = dr.sincos(dr.deg2rad(mi.Float(theta_deg)))
    sin_phi, cos_phi = dr.sincos(dr.deg2rad(mi.Float(phi_deg)))
    return mi.Vector3f(sin * cos_phi, sin * sin_phi, cos)

def light_samples(scene):
    """Directions and irradiances: the points of every lamp of a scene of the manifest."""
    lights = scene.get("light", {"direction": [0.3, 0.2, 1.0]})
    for light in lights if isinstance(lights, list) else [lights]:
        x, y, z = axis = np.array(light["direction"]) / np.linalg.norm(light["direction"])
        diameter = math.radians(light.get("angular_diameter_deg", 0.53))
        count = min(scene.get("light_samples", 16), COMPARED_SAMPLES) if diameter > 0 else 1
        index = np.arange(count)
        versine = (index + 0.5) / count * 2 * math.sin(diameter / 4) ** 2
        sine, angle = np.sqrt(versine * (2 - versine)), 2 * np.pi * (GOLDEN_TURNS * index % 1)
        # The frame that the shortest turn from the z axis makes.
        first = np.array([1 - x * x / (1 + z), -x * y / (1 + z), -x])
        second = np.array([-x * y / (1 + z), 1 - y * y / (1 + z), -y])
        points = np.outer(sine * np.cos(angle), first) + np.outer(sine * np.sin(angle), second) + np.outer(1 - versine, axis)
        for point in points:
            yield point, light.get("irradiance", 1.0) / (points @ axis).sum()

def render_ball(bsdf, light, irradiance, size_px):
    """The picture of such a ball."""
    return np.array(mi.render(ball(bsdf, directional(light, irradiance), size_px), spp=1)).astype(np.float64)

def directional(light, irradiance):
    """A light from one direction."""
    return {
        "type": "directional",
        "direction": [-float(x) for x in light],
        "irradiance": {"type": "rgb", "value": [float(irradiance)] * 3},
    }

def ball(bsdf, light, size_px):
    """The atlas's scene "sphere" under a light, through the centres of the pixels."""
    transform = mi.ScalarTransform4f()
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 2},
            "sensor": {
                "type": "orthographic",
                "to_world": transform.look_at([0, 0, 3], [0, 0, 0], [0, 1, 0]),
                "sampler": {"type": "stratified", "sample_count": 1, "jitter": False},
                "film": {
                    "type": "hdrfilm",
                    "width": size_px,
                    "height": size_px,
                    "rfilter": {"type": "box"},
                    "component_format": "float32",
                },
            },
            "light": light,
            # Mitsuba's spheres have their poles on the z axis, the atlas's on the y axis.
            "ball": {"type": "sphere", "radius": BALL_RADIUS, "to_world": transform.rotate([1, 0, 0], -90), "bsdf": bsdf},
        }
    )

def ball_scene(report, name):
    """The first ball of the manifest that this specimen has a picture of, seen through pixels' centres; None without."""
    for scene in tomllib.loads(report["manifest_text"]).get("scene", []):
        plain = not {"turn", "environment", "pixel_samples"} & set(scene)
        if scene["shape"] == "sphere" and plain and scene.get("specimen", name) == name:
            return scene
    return None

def compared_look_up(about):
    """The look-up that pictures are made with: the one that FORMAT.md tells."""
    tables = about["tables"]
    return "linear" if tables.get("restriction") or tables["basis"] == "taylor" else "spline"

def compared_picture(folder, scene):
    """What the tables show where a scene is compared with its reference: that, and the difference."""
    return sum(np.array(mi.Bitmap(str(folder / f"{scene}.{part}.exr"))).astype(np.float64) for part in ("reference", "difference"))

# Mistakes

def with_layers(bsdf, change):
    """The plugin with its tables, [row, column, layer, channel], changed in place."""
    tables = bsdf.brdf.tables
    texels = np.array(tables.texels).reshape(tables.rows, tables.columns, tables.count, 4)
    tables.texels = mi.Float(np.ascontiguousarray(change(texels)).ravel())
    return bsdf

def half_a_texel(bsdf):
    column, row = bsdf.brdf.first
    bsdf.brdf.first = column + 0.5, row
    return bsdf

def evenly_sampled(bsdf):
    """Leaves lobe and tables to the chance that even samples have of meeting them."""
    sampler = bsdf.sampler
    sampler.shares = mi.Float([1, 0, 0] * (dr.width(sampler.shares) // 3))
    return bsdf

def more_of(bsdf, lobe, tables):
    """States more of the lobe's or the tables' density than is drawn."""
    shares = bsdf.sampler.shares
    bsdf.sampler.shares = shares * mi.Float([1, lobe, tables] * (dr.width(shares) // 3))
    return bsdf


def without_scale(bsdf, scales):
    def change(texels):
        return texels / np.array(scales, np.float32)[:, None]

    return with_layers(bsdf, change)

def right(version, name, about, power_sums, scene, picture, has_densities):
    """Every check and how much of what is allowed it takes."""
    bsdf = load(version, name)
    yield "values", values_error(bsdf, about["check_values"])
    yield "colours", colour_error(bsdf, load(version, name, colours="srgb"), about["check_values"])
    # Tables restricted to scenes have no sums in the report, and answer for no other direction.
    if power_sums:
        yield "frame", frame_error(bsdf, load(version, name, turn_deg=20))
        for theta_deg in THETAS_DEG if has_densities else ():
            yield f"density at {theta_deg} deg", density_error(bsdf, bsdf, theta_deg)
        if has_densities:
            yield "power", power_error(bsdf, power_sums)
        yield "fireflies", firefly_error(load(version, name, energy_limit=True))
    if about.get("energy_limit"):
        yield "limit", limit_error(load(version, name, energy_limit=True))
    if picture is not None:
        yield "picture", picture_error(load(version, name, look_up=compared_look_up(about)), scene, picture)
        yield "mirrored coordinates", mirror_error(load(version, name, mirror_with="v"), bsdf)
        # Kernels of cubic look-ups with derivatives take a minute to compile for eight tables.
        if has_densities:
            yield "derivative", gradient_error(load(version, name, look_up="cubic"))
        yield "a light's size", filtered_error(version, name, 0.53)

def mistakes(version, name, about, power_sums, scene, picture, _):
    """What was done wrong, and how much of what is allowed the check takes that is to find it."""

    def swapped(**more):
        return with_layers(load(version, name, **more), lambda texels: texels[::-1, ::-1].transpose(1, 0, 2, 3))

    def upside_down(**more):
        return with_layers(load(version, name, **more), lambda texels: texels[::-1])

    checks = about["check_values"]
    scales = [entry["scale"] for entry in about["tables"]["tables"]]
    yield "u and v exchanged: values", values_error(swapped(), checks)
    yield "y downwards: values", values_error(upside_down(), checks)
    # Tables of 32-bit floats have a scale of 1.
    if scales[0] != 1:
        yield "scales left out: values", values_error(without_scale(load(version, name), scales), checks)
    yield "half a texel beside: values", values_error(half_a_texel(load(version, name)), checks)
    yield "sRGB left as XYZ: colours", colour_error(load(version, name), load(version, name), checks)
    yield "turn left out: frame", frame_error(load(version, name), load(version, name))
    for what, theta_deg, lobe, tables in (("tables", 35, 1, 1.1), ("lobe", 89, 1.1, 1)):
        wrong = more_of(load(version, name), lobe, tables)
        yield f"a tenth more of the {what} at {theta_deg} deg: density", density_error(load(version, name), wrong, theta_deg)
    yield "even samples: fireflies", firefly_error(evenly_sampled(load(version, name, energy_limit=True)))
    yield "factor of 1.02: power", power_error(load(version, name, scale=1.02), power_sums)
    if about.get("energy_limit"):
        yield "energy limit left off: limit", limit_error(load(version, name))
    if picture is not None:
        look_up = {"look_up": compared_look_up(about)}
        yield "u and v exchanged: picture", picture_error(swapped(**look_up), scene, picture)
        yield "y downwards: picture", picture_error(upside_down(**look_up), scene, picture)
        yield "turned by a degree: picture", picture_error(load(version, name, turn_deg=1, **look_up), scene, picture)
        if look_up != {"look_up": "linear"}:
            yield "linear look-ups: picture", picture_error(load(version, name), scene, picture)
        yield "mirrored coordinates left alone: mirror", mirror_error(bsdf := load(version, name), bsdf)
        yield "differences too large by a twentieth: derivative", gradient_error(load(version, name, look_up="cubic"), 1.05)
        yield "half as large a light: light's size", filtered_error(version, name, 2.0, 1.0)

def material(version, report, entry):
    """What a specimen is checked with."""
    has_densities = entry in report["specimens"][DENSITIES]
    name = entry["name"]
    about = json.loads((version / name / "specimen.json").read_text())
    scene = ball_scene(report, name)
    picture = compared_picture(version / name / "scenes", scene["name"]) if scene else None
    return version, name, about, entry["power_sums"], scene, picture, has_densities

def tell(what, errors, passes, otherwise):
    """Prints the errors as they come, and whether all of them are as they should be."""
    fine = True
    print(f"{what}:", flush=True)
    for check, error in errors:
        # Written so that NaN does not pass.
        well = passes(error)
        print(f"  {check} {error:.2g}{'' if well else '   ' + otherwise}", flush=True)
        fine &= well
    return fine

def main(atlas):
    version = atlas / (atlas / "latest").read_text().strip() if (atlas / "latest").is_file() else atlas
    report = json.loads((version / "report.json").read_text())
    print("Errors as shares of what is allowed.")
    fine = all(
        [
            tell(entry["name"], right(*material(version, report, entry)), lambda error: error <= 1, "FAILED")
            for entry in report["specimens"]
        ]
    )
    # The mistakes want tables that answer everywhere, of a structure without symmetry.
    entry = next((entry for entry in report["specimens"] if entry["power_sums"]), None)
    if entry:
        errors = mistakes(*material(version, report, entry))
        fine &= tell(f"{entry['name']} with mistakes, to be found", errors, lambda error: error > 1, "NOT FOUND")
    return None if fine else "The checks failed."

if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])) if len(sys.argv) == 2 else __doc__)
