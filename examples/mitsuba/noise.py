"""Noise of a ball with a specimen's surface at 64 samples to a pixel, beside Mitsuba's own rough conductor.

    python3 examples/mitsuba/noise.py out/atlas/bundled sunbeam_snake_like

Prints the relative RMSE over the ball, the root of the mean of squared errors over the mean, against a picture of many samples; the same of the 99 darkest of 100 pixels; and the
largest pixel over the mean. Under a sky of radiance 1, a square lamp, and a lamp that is a point.
"""

import sys

import mitsuba as mi
import numpy as np

mi.set_variant("llvm_ad_rgb")
import diffraction_atlas.mitsuba  # noqa: E402, F401  (needs the variant)

SIZE_PX, SAMPLES, MANY = 64, 64, 2048


def lights():
    grey = lambda value: {"type": "rgb", "value": [value] * 3}
    transform = mi.ScalarTransform4f()
    place = transform.look_at([2, 2, 4], [0, 0, 0], [0, 1, 0])
    yield "sky", {"type": "constant", "radiance": grey(1.0)}
    yield "area", {"type": "rectangle", "to_world": place @ transform.scale(0.5), "emitter": {"type": "area", "radiance": grey(20.0)}}
    yield "point", {"type": "point", "position": [2, 2, 4], "intensity": grey(24.0)}


def scene(bsdf, light):
    transform = mi.ScalarTransform4f()
    film = {"type": "hdrfilm", "width": SIZE_PX, "height": SIZE_PX, "rfilter": {"type": "box"}, "component_format": "float32"}
    return mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 3, "hide_emitters": True},
            "sensor": {"type": "orthographic", "to_world": transform.look_at([0, 0, 9], [0, 0, 0], [0, 1, 0]), "film": film},
            "ball": {"type": "sphere", "radius": 0.95, "to_world": transform.rotate([1, 0, 0], -90), "bsdf": bsdf},
            "light": light,
        }
    )


def picture(scene, samples, seed):
    """The mean of renders of at most 256 samples; a sum of 32-bit floats."""
    times = max(1, samples // 256)
    return sum(np.array(mi.render(scene, spp=min(samples, 256), seed=seed + k)).astype(float) for k in range(times)) / times


def main(atlas, specimen):
    surfaces = {
        specimen: {"type": "diffraction", "atlas": atlas, "specimen": specimen, "colours": "xyz"},
        "roughconductor": {"type": "roughconductor", "alpha": 0.1},
    }
    print(f"{'surface':24} {'light':6} relative RMSE  without the brightest 1 %  largest over mean")
    for name, bsdf in surfaces.items():
        for light, emitter in lights():
            made = scene(bsdf, emitter)
            many, few = (picture(made, samples, seed)[..., 1] for samples, seed in ((MANY, 1000), (SAMPLES, 1)))
            lit = many > 0
            squares = np.sort((few - many)[lit] ** 2)
            mean = many[lit].mean()
            rmse, most = np.sqrt(squares.mean()) / mean, np.sqrt(squares[: int(0.99 * len(squares))].mean()) / mean
            print(f"{name:24} {light:6} {rmse:13.4f}  {most:25.4f}  {few[lit].max() / mean:17.1f}", flush=True)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) == 3 else __doc__)
