"""Renders a specimen of an atlas on a ball, a disc or a mesh with Mitsuba 3.

    python3 examples/mitsuba/render.py --specimen sunbeam_snake_like --out ball.png
    python3 examples/mitsuba/render.py --specimen cd_track_like --shape disc --turn-deg 90 --tilt-deg 35 --out cd.png

A name that ends in .exr gets the picture's XYZ instead of its display. `--help` lists the options.
"""

import argparse
import math
import sys

import mitsuba as mi
import numpy as np

SRGB_FROM_XYZ = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)
LUMINANCE_OF_RGB = np.array([0.2126729, 0.7151522, 0.0721750])
# Oklab (B. Ottosson, 2020): cone responses of linear sRGB, and L, a, b of their cube roots.
LMS_FROM_RGB = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
LAB_FROM_ROOTS = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)
# A lamp stands this many object sizes away.
LAMP_DISTANCE = 1000.0


def options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--atlas", default="out/atlas/bundled", help="an atlas, a version or a specimen's folder")
    parser.add_argument("--specimen", default="", help="its name")
    parser.add_argument("--shape", default="ball", help="ball, disc, or a file .obj or .ply with texture coordinates")
    parser.add_argument("--turn-deg", type=float, default=0.0, help="turns the structure on the surface")
    parser.add_argument("--tilt-deg", type=float, default=0.0, help="leans the object's top edge away from the camera")
    parser.add_argument("--distance", type=float, help="of the camera, the object's radius being 1; far away if left out")
    parser.add_argument("--lamp", action="append", metavar="X,Y,Z", type=direction, help="direction to a lamp; x right, y up, z to the camera")
    parser.add_argument("--lamp-deg", type=float, default=0.53, help="angular diameter of the lamps, 0 for points")
    parser.add_argument("--sky", type=float, default=0.0, help="radiance from everywhere; a lamp has irradiance 1")
    parser.add_argument("--sky-image", help="an environment map, relative to the illuminant of the tables; grey is best")
    parser.add_argument("--look-up", default="linear", choices=("linear", "cubic", "spline"))
    parser.add_argument("--size", type=int, default=400, help="side of the picture in pixels")
    parser.add_argument("--spp", type=int, default=64, help="samples per pixel")
    parser.add_argument("--exposure", type=float, help="factor to display values; automatic if left out")
    parser.add_argument("--variant", default="llvm_ad_rgb", help="or cuda_ad_rgb")
    parser.add_argument("--out", required=True, help="a .png or .exr file")
    return parser.parse_args()


def direction(text):
    """The unit vector along three numbers with commas between them."""
    vector = np.array([float(x) for x in text.split(",")])
    if vector.shape != (3,) or not np.linalg.norm(vector) > 0:
        raise ValueError(text)
    return vector / np.linalg.norm(vector)


def lamp(towards, diameter_deg):
    """An emitter of irradiance 1 on a plane that faces it."""
    if diameter_deg == 0:
        return {"type": "directional", "direction": list(-towards), "irradiance": grey(1.0)}
    sine = math.sin(math.radians(diameter_deg) / 2)
    return {
        "type": "sphere",
        "center": list(LAMP_DISTANCE * towards),
        "radius": LAMP_DISTANCE * sine,
        "emitter": {"type": "area", "radiance": grey(1 / (math.pi * sine**2))},
    }


def grey(value):
    return {"type": "rgb", "value": [value] * 3}


def shape(options, bsdf):
    """The object within the unit sphere, its front towards +z."""
    transform = mi.ScalarTransform4f()
    tilt = transform.rotate([1, 0, 0], -options.tilt_deg)
    if options.shape == "ball":
        # Poles above and below, the structure's x axis along the circles of latitude.
        return {"type": "sphere", "to_world": tilt @ transform.scale(0.95) @ transform.rotate([1, 0, 0], -90), "bsdf": bsdf}
    if options.shape == "disc":
        # The structure's x axis along the radius: for the tracks of a disc, turn it by 90 degrees.
        return {"type": "disk", "to_world": tilt @ transform.scale(0.95), "bsdf": bsdf}
    kind = options.shape.rpartition(".")[2].lower()
    if kind not in ("obj", "ply"):
        sys.exit(f'--shape {options.shape}: it may be "ball", "disc", or a file that ends in .obj or .ply')
    mesh = mi.load_dict({"type": kind, "filename": options.shape})
    if not mesh.has_vertex_texcoords():
        sys.exit(f"--shape {options.shape}: the mesh has no texture coordinates, which tell how the structure lies")
    low, high = (np.array(corner, float).ravel() for corner in (mesh.bbox().min, mesh.bbox().max))
    fit = transform.scale(float(1.9 / np.linalg.norm(high - low))) @ transform.translate(list(-(low + high) / 2))
    # v as the file has it, and the structure mirrored where the coordinates are.
    bsdf = {**bsdf, "mirror_with": "v"}
    return {"type": kind, "filename": options.shape, "flip_tex_coords": False, "to_world": tilt @ fit, "bsdf": bsdf}


def camera(distance, sampler, film):
    """Looks from +z at the square [-1, 1]^2 of the plane z = 0."""
    # A little more than the unit circle, for what leans towards the camera.
    view = {} if distance is None else {"fov": 2 * math.degrees(math.atan(1.1 / distance))}
    return {
        "type": "orthographic" if distance is None else "perspective",
        "to_world": mi.ScalarTransform4f().look_at([0, 0, distance or 3], [0, 0, 0], [0, 1, 0]),
        "sampler": sampler,
        "film": film,
        **view,
    }


def scene(options):
    film = {"type": "hdrfilm", "width": options.size, "height": options.size, "component_format": "float32"}
    bsdf = {
        "type": "diffraction",
        "atlas": options.atlas,
        "specimen": options.specimen,
        "turn_deg": options.turn_deg,
        "look_up": options.look_up,
        # The film then holds XYZ: nothing else in this scene has a colour.
        "colours": "xyz",
    }
    parts = {
        "type": "scene",
        "integrator": {"type": "path", "max_depth": 4, "hide_emitters": True},
        "sensor": camera(options.distance, {"type": "multijitter", "sample_count": options.spp}, film),
        "object": shape(options, bsdf),
    }
    lamps = options.lamp or ([] if options.sky or options.sky_image else [direction("0.3,0.2,1")])
    for index, towards in enumerate(lamps):
        parts[f"lamp{index}"] = lamp(towards, options.lamp_deg)
    if options.sky_image:
        parts["sky"] = {"type": "envmap", "filename": options.sky_image}
    elif options.sky:
        parts["sky"] = {"type": "constant", "radiance": grey(options.sky)}
    return mi.load_dict(parts)


def automatic_exposure(xyz):
    """Brings the 99.5th percentile of the lit pixels' luminance to white, as the atlas's pictures do."""
    lit = xyz[..., 1][xyz[..., 1] > 0]
    return 1 / np.quantile(lit, 0.995) if lit.size else 1.0


def display(xyz, exposure):
    """8-bit sRGB. What no display can show loses saturation at constant Oklab hue and luminance, and highlights roll off:
    the chain of src/ground/colour.rs. Magenta where there is no answer."""
    known = np.isfinite(xyz).all(axis=-1)
    rgb = exposure * np.where(known[..., None], xyz, 0) @ SRGB_FROM_XYZ.T
    luminance = np.maximum(rgb @ LUMINANCE_OF_RGB, 0)
    # Colours of a hue: cubes of roots 1 + s (directions), s from 0 (grey) to the colour's own.
    lightness, a, b = np.moveaxis(np.cbrt(rgb @ LMS_FROM_RGB.T) @ LAB_FROM_ROOTS.T, -1, 0)
    chroma = np.maximum(np.hypot(a, b), 1e-12)
    hue = np.stack([np.zeros_like(a), a / chroma, b / chroma], axis=-1) @ np.linalg.inv(LAB_FROM_ROOTS).T

    def of_saturation(s):
        return (1 + s[..., None] * hue) ** 3 @ np.linalg.inv(LMS_FROM_RGB).T

    outside = chroma / np.maximum(lightness, 1e-12)
    inside = np.where((rgb >= 0).all(axis=-1), outside, 0)
    for _ in range(40):
        middle = (inside + outside) / 2
        fits = (of_saturation(middle) >= 0).all(axis=-1)
        inside, outside = np.where(fits, middle, inside), np.where(fits, outside, middle)
    rgb = of_saturation(inside)
    rgb *= (luminance / np.maximum(rgb @ LUMINANCE_OF_RGB, 1e-12))[..., None]

    # The shoulder and the paling of the Khronos PBR Neutral tone mapper.
    peak = np.maximum(rgb.max(axis=-1), 1e-12)
    new_peak = np.where(peak > 0.8, 1 - 0.04 / np.maximum(peak - 0.6, 0.2), peak)
    paled = of_saturation(inside / (1 + 0.15 * (peak - new_peak)))
    rgb = paled * (new_peak / paled.max(axis=-1))[..., None]
    rgb = np.clip(np.where(known[..., None], rgb, (1, 0, 1)), 0, 1)
    encoded = np.where(rgb <= 0.0031308, 12.92 * rgb, 1.055 * rgb ** (1 / 2.4) - 0.055)
    return np.round(255 * encoded).astype(np.uint8)


def main():
    asked = options()
    mi.set_variant(asked.variant)
    import diffraction_atlas.mitsuba  # registers the plugin; needs the variant

    made = scene(asked)
    diffraction_atlas.mitsuba.warn_of_meshes(made)
    xyz = np.array(mi.render(made, spp=asked.spp))[..., :3]
    unknown = int((~np.isfinite(xyz).all(axis=-1)).sum())
    if unknown:
        print(f"{unknown} pixels look up directions that the tables do not cover: NaN, shown in magenta", file=sys.stderr)
    if asked.out.endswith(".exr"):
        mi.Bitmap(xyz.astype(np.float32)).write(asked.out)
        return
    exposure = asked.exposure or automatic_exposure(xyz)
    mi.Bitmap(display(xyz, exposure)).write(asked.out)
    print(f"{asked.out}: exposure {exposure:.4g}")


if __name__ == "__main__":
    main()
