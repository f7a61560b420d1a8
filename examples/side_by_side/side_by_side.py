"""One scene from every reader of an atlas, side by side, and how far each is from this program's own picture.

    cargo run --release -- run examples/side_by_side/scene.toml
    cargo run --release -- export out/atlas/side_by_side --form shaders --out exported/shaders
    cargo run --release -- export out/atlas/side_by_side --form osl --out exported/osl
    python3 examples/side_by_side/side_by_side.py out/atlas/side_by_side exported --out docs/pictures/side_by_side.png

A flat square of side 2 is seen from 2.2 above its middle, under a point light of irradiance 1 in the direction (-1, 0.2, 1). A pixel is the mean of 64 places in it.
What is not here is left out and said: Mitsuba (`pip install mitsuba`), Blender's module (`--blender` names a Python that has `bpy`), node with Chromium and a built
`viewer/three`, a Vulkan driver. Exits with 1 where one that is here is off by more than its row allows.
"""

import argparse
import math
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import OpenEXR

import diffraction_atlas as da

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
SPECIMEN = "sunbeam_snake_like"
SIDE, PARTS = 100, 8
EYE, LIGHT = 2.2, (-1.0, 0.2, 1.0)
# What the program leaves around the square, in pixels.
MARGIN = 2
# Relative L2. Splines in double precision are the program's own look-ups, but for a mean over a pixel in place of 64 places: 2e-4. Halves
# of textures are off by 2^-11; places in Mitsuba's pixels are random, and a value changes by a few hundredths over a pixel; cubics err by up
# to two thousandths between texels that are as wide apart as these.
READERS = {
    "Python": 2e-4,
    "Mitsuba, `llvm_ad_rgb`": 1e-3,
    "Blender, Cycles with OSL": 2e-4,
    "exported WGSL, `examples/engine.rs`": 5e-4,
    "three.js": 2e-3,
}
# In a process of its own: an LLVM that is too old ends it.
KERNEL = "import mitsuba as mi; mi.set_variant('llvm_ad_rgb'); import drjit as dr; dr.eval(dr.maximum(mi.Float(1, 2), 0))"


class Missing(Exception):
    """What a reader wants and this machine has not."""


def places(count):
    """Places along x and y of a grid of `count` pixels on the square, rows from the top."""
    along = (np.arange(count) + 0.5) / count * 2 - 1
    return np.meshgrid(along, -along)


def averaged(image):
    """Means over the parts of each pixel, `[SIDE, SIDE, 3]` of `[PARTS SIDE, PARTS SIDE, 3]`."""
    return image.reshape(SIDE, PARTS, SIDE, PARTS, 3).mean((1, 3))


def light():
    """Unit vector to the light."""
    return np.array(LIGHT) / np.linalg.norm(LIGHT)


def own(atlas):
    """Linear sRGB of the program's picture, whose file holds X, Y, Z."""
    folder = atlas / (atlas / "latest").read_text().strip() if (atlas / "latest").is_file() else atlas
    file = folder / SPECIMEN / "scenes" / "square.exr"
    xyz = OpenEXR.File(str(file)).channels()["RGB"].pixels.astype(float)
    return da.to_linear_srgb(xyz[MARGIN:-MARGIN, MARGIN:-MARGIN])


def in_python(options):
    """By the package, in double precision."""
    x, y = places(PARTS * SIDE)
    to_viewer = np.stack([-x, -y, np.full_like(x, EYE)], -1).reshape(-1, 3)
    to_viewer /= np.linalg.norm(to_viewer, axis=-1, keepdims=True)
    specimen = da.open(options.atlas)[SPECIMEN]
    xyz = specimen.eval(np.broadcast_to(light(), to_viewer.shape), to_viewer, lookup="spline") * light()[2]
    return averaged(da.to_linear_srgb(xyz).reshape(PARTS * SIDE, PARTS * SIDE, 3))


def in_mitsuba(options):
    """By the plugin, in single precision; places in pixels are random."""
    needs("mitsuba from PyPI, and LLVM", sys.executable, "-c", KERNEL)
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    import diffraction_atlas.mitsuba  # registers the plugin

    field = 2 * math.degrees(math.atan(1 / EYE))
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "direct"},
            "sensor": {
                "type": "perspective",
                "fov": field,
                "to_world": mi.ScalarTransform4f().look_at([0, 0, EYE], [0, 0, 0], [0, 1, 0]),
                "sampler": {"type": "multijitter", "sample_count": PARTS**2},
                "film": {"type": "hdrfilm", "width": SIDE, "height": SIDE, "rfilter": {"type": "box"}, "component_format": "float32"},
            },
            "lamp": {"type": "directional", "direction": list(-light()), "irradiance": {"type": "rgb", "value": [1.0] * 3}},
            "square": {"type": "rectangle", "bsdf": {"type": "diffraction", "atlas": str(options.atlas), "specimen": SPECIMEN, "look_up": "spline", "colours": "xyz"}},
        }
    )
    return da.to_linear_srgb(np.array(mi.render(scene, seed=1))[..., :3].astype(float))


def call(words):
    """Runs another program; ends where it fails."""
    done = subprocess.run([str(word) for word in words], cwd=ROOT, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{words[0]}: {(done.stderr or done.stdout).strip()}")


def needs(what, *words):
    """Asks whether something is here by a program that fails where it is not."""
    try:
        done = subprocess.run([str(word) for word in words], capture_output=True, check=False)
    except FileNotFoundError:
        done = None
    if done is None or done.returncode != 0:
        raise Missing(what)


def floats(file):
    """Linear sRGB of a file of 32-bit floats, three to a pixel of a part, rows from the top."""
    image = np.fromfile(file, "<f4").reshape(PARTS * SIDE, PARTS * SIDE, 3).astype(float)
    return averaged(image)


def in_blender(options):
    """By the emission shader, in another Python where that has the module."""
    needs("a Python with bpy", options.blender, "-c", "import bpy")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "seen.exr")
        script = HERE / "square_in_blender.py"
        call([options.blender, script, options.exported / "osl" / SPECIMEN, PARTS * SIDE, EYE, *light(), file])
        return averaged(OpenEXR.File(str(file)).channels()["RGBA"].pixels[..., :3].astype(float))


def in_engine(options):
    """By the exported shader and bytes, through wgpu."""
    needs("cargo", "cargo", "--version")
    if not list(Path("/usr/share/vulkan/icd.d").glob("*.json")) and sys.platform == "linux":
        raise Missing("a Vulkan driver")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "seen.f32")
        # Far away enough to be a direction in single precision.
        vectors = [",".join(map(str, v)) for v in (1e5 * light(), (0.0, 0.0, EYE))]
        call(["cargo", "run", "--release", "--quiet", "--example", "engine", "--", options.exported / "shaders", SPECIMEN, file, PARTS * SIDE, *vectors])
        return floats(file)


def in_three(options):
    """By the package for three.js, in a browser."""
    needs("node", "node", "--version")
    if not (ROOT / "viewer/three/dist").is_dir() or not (ROOT / "viewer/node_modules").is_dir():
        raise Missing("viewer/three/dist: npm ci --prefix viewer && node viewer/three/build.mjs")
    if not os.environ.get("CHROMIUM") and not any(map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))):
        raise Missing("chromium")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "seen.f32")
        call(["node", HERE / "square_in_three.mjs", options.atlas, SPECIMEN, PARTS * SIDE, EYE, *light(), file])
        return floats(file)


def displayed(linear, exposure):
    """sRGB from 0 to 1."""
    value = np.clip(linear * exposure, 0, 1)
    return np.where(value <= 0.0031308, 12.92 * value, 1.055 * value ** (1 / 2.4) - 0.055)


def lab(linear, exposure):
    """CIE L*a*b* under D65 of what is displayed."""
    from_rgb = np.array([[0.4124564, 0.3575761, 0.1804375], [0.2126729, 0.7151522, 0.0721750], [0.0193339, 0.1191920, 0.9503041]])
    relative = np.clip(linear * exposure, 0, 1) @ from_rgb.T / from_rgb.sum(1)
    f = np.where(relative > (6 / 29) ** 3, np.cbrt(relative), relative * (29 / 6) ** 2 / 3 + 4 / 29)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], -1)


def relative_l2(found, wanted):
    """Root of the squares of differences over that of the values'."""
    return float(np.sqrt(((found - wanted) ** 2).sum() / (wanted**2).sum()))


def arguments():
    """What the command line says."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("atlas", type=Path, help="the atlas of scene.toml")
    parser.add_argument("exported", type=Path, help="a folder with its exports `shaders` and `osl`")
    parser.add_argument("--blender", default=sys.executable, help="a Python that has bpy")
    parser.add_argument("--out", type=Path, help="a PNG with all pictures in a row")
    options = parser.parse_args()
    options.atlas, options.exported = options.atlas.resolve(), options.exported.resolve()
    return options


def main():
    """Draws, compares, prints the table of docs/renderers.md."""
    options = arguments()
    wanted = own(options.atlas)
    # The 99.5th percentile of luminance comes to white.
    exposure = 1 / np.percentile(wanted @ [0.2126729, 0.7151522, 0.0721750], 99.5)
    draw = [in_python, in_mitsuba, in_blender, in_engine, in_three]
    pictures, failed = [displayed(wanted, exposure)], []
    print("| picture | relative L2 | colour difference, mean | largest |\n|---|---|---|---|")
    for (name, allowed), reader in zip(READERS.items(), draw):
        try:
            found = reader(options)
        except Missing as missing:
            print(f"| {name} | SKIPPED: {missing} | | |")
            continue
        pictures.append(displayed(found, exposure))
        apart = np.linalg.norm(lab(found, exposure) - lab(wanted, exposure), axis=-1)
        print(f"| {name} | {relative_l2(found, wanted):.1e} | {apart.mean():.2f} | {apart.max():.1f} |")
        # A picture that is moved by a pixel has to be told.
        if not relative_l2(found, wanted) < allowed:
            failed.append(f"{name}: {relative_l2(found, wanted):.1e}, where {allowed:.0e} is allowed")
        if relative_l2(np.roll(found, 1, axis=1), wanted) < 2 * allowed:
            failed.append(f"{name}: a picture moved by a pixel goes unseen")
    if options.out:
        write(options.out, np.concatenate(pictures, axis=1))
    if failed:
        sys.exit("\n".join(failed))


def write(file, image):
    """A PNG, pixel for pixel."""
    from PIL import Image

    eight = np.round(255 * image).astype(np.uint8)
    Image.fromarray(eight).save(file, optimize=True)


if __name__ == "__main__":
    main()
