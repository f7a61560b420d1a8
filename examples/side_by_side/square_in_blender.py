"""Blender's part of side_by_side.py: a square under a point light by the emission shader, seen in perspective, as an EXR.

    python3 square_in_blender.py EXPORTED_SPECIMEN PIXELS EYE LIGHT_X LIGHT_Y LIGHT_Z OUT.exr
"""

import math
import sys
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parent.parent / "blender"))

import bpy

from scene import diffraction_material, empty_scene, render


def main():
    """Draws one sample in the middle of each pixel."""
    folder, pixels, eye, *towards, out = sys.argv[1:]
    scene = empty_scene(int(pixels), 1)
    scene.cycles.filter_width = 0.01
    bpy.ops.mesh.primitive_plane_add(size=2)
    material, script = diffraction_material(folder, "diffraction_emission")
    bpy.context.object.data.materials.append(material)
    script.inputs["ToLamp"].default_value = [float(component) for component in towards]
    script.inputs["DiameterDeg"].default_value = 0
    data = bpy.data.cameras.new("camera")
    data.angle = 2 * math.atan(1 / float(eye))
    seen_from = bpy.data.objects.new("camera", data)
    seen_from.location = (0, 0, float(eye))
    scene.collection.objects.link(seen_from)
    scene.camera = seen_from
    render(scene, out, exr=True)


if __name__ == "__main__":
    main()
