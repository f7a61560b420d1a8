"""Holds the OSL shaders in Cycles to an atlas: what the emission shader shows to the check values, what the closure reflects of a sky to the albedo.

    python3 examples/blender/check.py ATLAS_VERSION EXPORTED [SPECIMEN ...]
"""

import json
import math
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np
import OpenEXR

from scene import camera, diffraction_material, empty_scene, render, sky

RGB_FROM_XYZ = np.array(
    [[3.2404542, -1.5371385, -0.4985314], [-0.9692660, 1.8760108, 0.0415560], [0.0556434, -0.2040259, 1.0572252]]
)
LUMINANCE = np.array([0.2126729, 0.7151522, 0.0721750])
# Single precision of directions where a value changes within a texel, three hundredths of it at the flank of a sharp order.
SHOWN_MAX = 2e-3
# Four deviations of what 262144 samples leave.
REFLECTED_MAX = 0.02


def plane(size, samples, folder, shader, towards):
    """A square seen from a direction, its script node, and the scene."""
    scene = empty_scene(size, samples)
    scene.cycles.filter_width = 0.01
    bpy.ops.mesh.primitive_plane_add(size=2)
    material, script = diffraction_material(folder, shader)
    bpy.context.object.data.materials.append(material)
    camera(scene, towards, 5, 0.1)
    return scene, script


def pixels(scene):
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "seen.exr"
        render(scene, path, exr=True)
        channels = OpenEXR.File(str(path)).channels()
        return channels["RGBA"].pixels[..., :3].astype(float)


def unlike(found, wanted):
    """The largest difference of a channel, relative to the largest channel."""
    return np.abs(found - wanted).max() / np.abs(wanted).max()


def check_emission(specimen, folder):
    """The worst of the brighter check values, and what a structure turned by 5 degrees makes of it."""
    lobe = (specimen["tables"]["lobe"] or {}).get("radius_max", 0)
    # Outside the lobe, which is the same however the structure is turned.
    outside = [value for value in specimen["check_values"] if math.dist(value["wi"][:2], [-x for x in value["wo"][:2]]) > lobe]
    values = sorted(outside, key=lambda value: -value["xyz_spline"][1])[:6]
    worst, turned = 0.0, 0.0
    for value in values:
        wi, wo, xyz = (np.array(value[key]) for key in ("wi", "wo", "xyz_spline"))
        wanted = RGB_FROM_XYZ @ xyz * wi[2]
        scene, script = plane(2, 1, folder, "diffraction_emission", wo)
        script.inputs["ToLamp"].default_value = wi
        script.inputs["DiameterDeg"].default_value = 0
        worst = max(worst, unlike(pixels(scene).mean((0, 1)), wanted))
        script.inputs["TurnDeg"].default_value = 5
        turned = max(turned, unlike(pixels(scene).mean((0, 1)), wanted))
    return worst, turned


def check_closure(specimen, folder):
    """Where a sky of 1 is farthest from the albedo, relative to it."""
    worst = 0.0
    for entry in specimen["albedo"]:
        if entry["theta_i_deg"] not in (0, 45, 75):
            continue
        theta = math.radians(entry["theta_i_deg"])
        scene, _ = plane(32, 256, folder, "diffraction_closure", (math.sin(theta), 0, math.cos(theta)))
        sky(scene, 1)
        found = LUMINANCE @ pixels(scene).mean((0, 1))
        worst = max(worst, abs(found / entry["albedo"] - 1))
    return worst


def main():
    atlas, exported = Path(sys.argv[1]), Path(sys.argv[2])
    failed = 0
    for name in sys.argv[3:] or sorted(path.name for path in exported.iterdir() if path.is_dir()):
        specimen = json.loads((atlas / name / "specimen.json").read_text())
        shown, turned = check_emission(specimen, exported / name)
        reflected = check_closure(specimen, exported / name)
        good = shown < SHOWN_MAX < turned and reflected < REFLECTED_MAX
        print(f"{name}: emission within {shown:.1e} of check values ({turned:.2g} where turned), sky within {reflected:.2%} of the albedo{'' if good else ': TOO FAR'}")
        failed += not good
    print(f"Blender {bpy.app.version_string}: {failed} of the specimens are off")
    sys.exit(failed > 0)


if __name__ == "__main__":
    main()
