"""Scenes for Cycles with shaders of `diffraction-atlas export --form osl`.

With Blender, or with its Python module (pip install bpy):

    blender -b -P examples/blender/scene.py -- exported/sunbeam_snake_like --blend ball.blend --out ball.png
    python3 examples/blender/scene.py exported/sunbeam_snake_like --blend ball.blend --out ball.png
"""

import argparse
import math
import site
import sys
from pathlib import Path

import bpy

# The module from PyPI leaves out of the search path what compiles shaders.
for folder in site.getsitepackages():
    sys.path += [str(path) for path in Path(folder).glob("bpy/*/python/lib/*/site-packages")]


def empty_scene(size, samples):
    """A scene without anything, for Cycles with OSL on the processor."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.shading_system = True
    scene.cycles.samples = samples
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.use_denoising = False
    scene.cycles.blur_glossy = 0
    scene.cycles.caustics_reflective = True
    scene.render.resolution_x, scene.render.resolution_y = size, size
    scene.view_settings.view_transform = "Standard"
    return scene


def diffraction_material(folder, shader):
    """A material of `diffraction_emission` or `diffraction_closure` in an exported folder, and its script node."""
    material = bpy.data.materials.new(f"{Path(folder).name} {shader}")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    script = tree.nodes.new("ShaderNodeScript")
    script.mode = "EXTERNAL"
    script.filepath = str(Path(folder).resolve() / f"{shader}.osl")
    if not script.inputs:
        sys.exit(f"{script.filepath}: did not compile, or is not there")
    tangent = tree.nodes.new("ShaderNodeTangent")
    tangent.direction_type = "UV_MAP"
    tree.links.new(tangent.outputs["Tangent"], script.inputs["Tangent"])
    output = tree.nodes.new("ShaderNodeOutputMaterial")
    if shader == "diffraction_emission":
        emission = tree.nodes.new("ShaderNodeEmission")
        tree.links.new(script.outputs["Radiance"], emission.inputs["Color"])
        tree.links.new(emission.outputs["Emission"], output.inputs["Surface"])
    else:
        tree.links.new(script.outputs["BSDF"], output.inputs["Surface"])
    return material, script


def sky(scene, radiance):
    """The same radiance from everywhere."""
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    background = scene.world.node_tree.nodes["Background"]
    background.inputs["Color"].default_value = (1, 1, 1, 1)
    background.inputs["Strength"].default_value = radiance


def camera(scene, towards, distance, width):
    """A camera without perspective at a distance in a direction from the origin, +z up in the picture where it can be."""
    data = bpy.data.cameras.new("camera")
    data.type = "ORTHO"
    data.ortho_scale = width
    seen_from = bpy.data.objects.new("camera", data)
    x, y, z = towards
    seen_from.location = [distance * component for component in towards]
    seen_from.rotation_euler = (math.acos(max(-1.0, min(1.0, z))), 0, math.atan2(y, x) + math.pi / 2)
    scene.collection.objects.link(seen_from)
    scene.camera = seen_from


def lamp(scene, towards, radiance, diameter_deg):
    """A ball of light in a direction."""
    distance = 20.0
    radius = distance * math.sin(math.radians(diameter_deg / 2))
    bpy.ops.mesh.primitive_uv_sphere_add(radius=radius, location=[distance * component for component in towards])
    material = bpy.data.materials.new("lamp")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    emission, output = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeOutputMaterial")
    emission.inputs["Strength"].default_value = radiance
    tree.links.new(emission.outputs["Emission"], output.inputs["Surface"])
    bpy.context.object.data.materials.append(material)


def render(scene, path, exr=False):
    settings = scene.render.image_settings
    settings.file_format = "OPEN_EXR" if exr else "PNG"
    if exr:
        settings.color_depth = "32"
    scene.render.filepath = str(Path(path).resolve())
    bpy.ops.render.render(write_still=True)


def ball(folder, shader, size, samples):
    """A ball under a lamp ten degrees wide and a faint sky, or for the emission shader under a lamp of half a degree alone."""
    scene = empty_scene(size, samples)
    bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=1)
    bpy.ops.object.shade_smooth()
    material, script = diffraction_material(folder, shader)
    bpy.context.object.data.materials.append(material)
    towards = [component / math.sqrt(1.49) for component in (0.6, -1.0, 0.36)]
    length = math.sqrt(sum(component**2 for component in towards))
    towards = [component / length for component in towards]
    if shader == "diffraction_emission":
        script.inputs["ToLamp"].default_value = towards
        script.inputs["Irradiance"].default_value = 30
    else:
        lamp(scene, towards, 600, 10)
        sky(scene, 0.3)
    camera(scene, (0, -1, 0), 10, 2.2)
    return scene


def main():
    words = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else sys.argv[1:]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", help="a specimen's folder in an export")
    parser.add_argument("--shader", default="diffraction_closure", choices=("diffraction_closure", "diffraction_emission"))
    parser.add_argument("--size", type=int, default=400)
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--blend", help="saves the scene for Blender")
    parser.add_argument("--out", help="renders it to a .png")
    options = parser.parse_args(words)
    scene = ball(options.folder, options.shader, options.size, options.samples)
    if options.blend:
        bpy.ops.wm.save_as_mainfile(filepath=str(Path(options.blend).resolve()))
    if options.out:
        render(scene, options.out)


if __name__ == "__main__":
    main()
