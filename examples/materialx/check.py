"""Checks an export's folder `materialx`: the library and its materials are valid MaterialX, what MaterialX generates of them compiles, and USD finds the node.

    pip install MaterialX usd-core
    diffraction-atlas export out/atlas/bundled --form shaders --out exported
    python3 examples/materialx/check.py exported

Wants glslangValidator for compiling; without usd-core the USD part says SKIPPED. Nothing is drawn: that wants a display, and a renderer that binds the
tables (README.md of that folder).
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import MaterialX as mx
from MaterialX import PyMaterialXGenGlsl as gen_glsl
from MaterialX import PyMaterialXGenShader as gen

GENERATORS = {"GLSL": gen_glsl.GlslShaderGenerator, "ESSL": gen_glsl.EsslShaderGenerator}


def require(holds, message):
    """Ends the check where something does not hold."""
    if not holds:
        sys.exit(f"examples/materialx/check.py: {message}")


def documents(folder):
    """The standard library, and the materials with it; both valid."""
    search = mx.getDefaultDataSearchPath()
    search.append(mx.FilePath(str(folder)))
    library = mx.createDocument()
    mx.loadLibraries(mx.getDefaultDataLibraryFolders(), search, library)
    found = sorted(folder.glob("*materials.mtlx"))
    require(len(found) == 1, f"{folder} has {len(found)} files *materials.mtlx: is it the folder `materialx` of an export?")
    materials = mx.createDocument()
    mx.readFromXmlFile(materials, str(found[0]), search)
    materials.setDataLibrary(library)
    valid, message = materials.validate()
    require(valid, f"{found[0].name} is not valid: {message}")
    return search, library, materials


def closure(materials):
    """The node's definition, which has a type of MaterialX that surfaces take."""
    library = {found.getName() for found in materials.getDataLibrary().getNodeDefs()}
    defs = [found for found in materials.getNodeDefs() if found.getName() not in library]
    require(len(defs) == 1 and defs[0].getType() == "BSDF", f"one BSDF is expected, there are {[d.getName() for d in defs]}")
    return defs[0]


def generated(language, search, library, material, folder):
    """Vertex and pixel shader of a material, in a language; code is looked for in the folder first."""
    generator = GENERATORS[language].create()
    context = gen.GenContext(generator)
    context.registerSourceCodeSearchPath(mx.FileSearchPath(str(folder)))
    context.registerSourceCodeSearchPath(search)
    colours = mx_colours(generator, library)
    generator.setColorManagementSystem(colours)
    context.getOptions().fileTextureVerticalFlip = True
    context.getOptions().hwMaxActiveLightSources = 3
    light = library.getNodeDef("ND_directional_light")
    gen.HwShaderGenerator.bindLightShader(light, 1, context)
    shader = generator.generate(material.getName(), material, context)
    return shader.getSourceCode(gen.VERTEX_STAGE), shader.getSourceCode(gen.PIXEL_STAGE)


def mx_colours(generator, library):
    """Colour management with what the library holds."""
    colours = gen.DefaultColorManagementSystem.create(generator.getTarget())
    colours.loadLibrary(library)
    return colours


def compiles(vertex, pixel):
    """Whether glslangValidator takes both stages, and what it says."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, name) for name in ("shader.vert", "shader.frag")]
        for path, text in zip(paths, (vertex, pixel)):
            path.write_text(text)
        done = subprocess.run(["glslangValidator", "-l", *map(str, paths)], capture_output=True, text=True, check=False)
        return done.returncode == 0, done.stdout + done.stderr


def check_code(search, library, materials, folder):
    """Every material in every language: it holds the tables' look-up, and compiles unless the call of it is misspelt."""
    compiler = shutil.which("glslangValidator")
    if compiler is None:
        print("SKIPPED: glslangValidator is not installed; nothing was compiled")
    node = closure(materials).getNodeString()
    names = [material.getName() for material in materials.getMaterialNodes()]
    for language in GENERATORS:
        for material in materials.getMaterialNodes():
            vertex, pixel = generated(language, search, library, material, folder)
            name = f"{material.getName()} in {language}"
            require(f"mx_{node}(" in pixel and "surface_xyz_filtered(" in pixel, f"{name} does not call the tables")
            if compiler is None:
                continue
            taken, said = compiles(vertex, pixel)
            require(taken, f"{name} does not compile:\n{said}")
        if compiler is not None:
            taken, _ = compiles(vertex, pixel.replace("surface_xyz_filtered(wi, wo", "surface_xyz_misspelt(wi, wo"))
            require(not taken, f"a misspelt call compiles in {language}: the compiler looks at nothing")
        print(f"{language}: {len(names)} materials, {pixel.count(chr(10))} lines each")


def check_validation(materials):
    """A node of a wrong type is refused, so that validation means something."""
    spoilt = materials.copy()
    spoilt.setDataLibrary(materials.getDataLibrary())
    node = closure(spoilt).getNodeString()
    spoilt.getNodes(node)[0].setType("color3")
    require(not spoilt.validate()[0], "a closure of type color3 is valid: the validation looks at nothing")


def faults_of(prim, node_def):
    """What is amiss with a material of the stage: a list of sentences."""
    from pxr import Sdf, UsdShade

    surface, _, _ = UsdShade.Material(prim).ComputeSurfaceSource("mtlx")
    if not surface or surface.GetIdAttr().Get() != "ND_surface":
        return ["it has no surface for mtlx"]
    source, _, _ = surface.GetInput("bsdf").GetConnectedSource()
    shader, faults = UsdShade.Shader(source), []
    asset = shader.GetSourceAsset("mtlx")
    if asset is None or not Path(asset.resolvedPath).is_file():
        faults.append("its definitions are not there")
    if shader.GetSourceAssetSubIdentifier("mtlx") != node_def.getName():
        faults.append(f"{shader.GetSourceAssetSubIdentifier('mtlx')} is not {node_def.getName()}")
    unknown = [given.GetBaseName() for given in shader.GetInputs() if not node_def.getActiveInput(given.GetBaseName())]
    faults += [f"the node has no input {name}" for name in unknown]
    textures = [found for found in prim.GetAttributes() if found.GetTypeName() == Sdf.ValueTypeNames.Asset]
    if not textures or not all(Path(found.Get().resolvedPath).is_file() for found in textures):
        faults.append("its textures.json is not there")
    return faults


def check_usd(folder, node_def):
    """Every material's surface leads to the node, whose definitions and textures are where it says; as `usd-core` reads the stage."""
    try:
        from pxr import Usd, UsdShade
    except ImportError:
        print("SKIPPED: the USD stage was not read; usd-core is not installed")
        return
    stage = Usd.Stage.Open(str(next(folder.glob("*materials.usda"))))
    materials = [prim for prim in stage.Traverse() if prim.IsA(UsdShade.Material)]
    for prim in materials:
        faults = faults_of(prim, node_def)
        require(not faults, f"{prim.GetPath()}: {'; '.join(faults)}")
    bound = [prim for prim in stage.Traverse() if prim.HasAPI(UsdShade.MaterialBindingAPI)]
    for prim in bound:
        require(UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()[0], f"{prim.GetPath()} has no material")
    require(materials and len(bound) == len(materials), f"{len(materials)} materials on {len(bound)} balls")
    # In memory alone.
    shader = UsdShade.Shader(materials[0].GetChild("Diffraction"))
    shader.SetSourceAssetSubIdentifier("ND_misspelt", "mtlx")
    require(faults_of(materials[0], node_def), "a node that is not there goes unseen")
    print(f"USD: {len(materials)} materials, each with the node {node_def.getName()}")


def main():
    """Checks the folder that is named."""
    parser = argparse.ArgumentParser(description="checks the MaterialX files of an export")
    parser.add_argument("exported", type=Path, help="what `export --form shaders --out` wrote")
    folder = (parser.parse_args().exported / "materialx").resolve()
    require(folder.is_dir(), f"{folder} is not there: name a folder that `export --form shaders` wrote")
    search, library, materials = documents(folder)
    check_validation(materials)
    check_code(search, library, materials, folder)
    check_usd(folder, closure(materials))


if __name__ == "__main__":
    main()
