"""A BSDF for Mitsuba 3 that evaluates the tables of a diffraction atlas.

    import mitsuba as mi
    mi.set_variant("llvm_ad_rgb")               # before the next line
    import diffraction_atlas.mitsuba            # registers the plugin "diffraction"
    ball = mi.load_dict({"type": "sphere", "bsdf": {
        "type": "diffraction", "atlas": "out/atlas/bundled", "specimen": "sunbeam_snake_like"}})

Parameters:

- `atlas`: an atlas (its latest version is taken), one of its versions, or the folder of a specimen.
- `specimen`: name of the specimen; not needed where `atlas` is its folder or holds only one.
- `turn_deg`: turns the structure about the normal, a number or a texture (give a bitmap `raw = true`). Its x axis otherwise runs along the texture
  coordinate u (`dp_du`), its y axis at a right angle to the left of it; turns are from x towards y.
- `mirror_with`: "none" (default), or "v": the y axis lies on the side to which the texture coordinate v grows, so that the structure
  is mirrored where the coordinates are, as in the program's own pictures of meshes. "flipped_v" is the same for shapes whose v Mitsuba turns over: .obj
  files unless `flip_tex_coords` is false, and spheres.
- `scale`: a factor on the BRDF, a number or a texture, 1 by default.
- `look_up`: "linear" (default) between texels as graphics hardware; "cubic", slower and more accurate; or "spline", as slow, which keeps the tolerance that
  the tables were made with (what `mi.traverse` then shows as `tables` are the splines' coefficients).
- `light_deg`: 0 by default; else the BRDF is the mean over round lights of this angular diameter, up to about 2 degrees, which stand in the scene as points
  or as directions: the sun is 0.53. Not for lights that have their size in the scene already.
- `energy_limit`: true by default; keeps every direction from reflecting more than arrives, which ideal reflectors and the
  scalar factor do at grazing angles. Surfaces that never do stay as they are. False for comparisons with values of the model.
- `colours`: "srgb" (default) gives linear sRGB in variants of three channels; "xyz" gives CIE XYZ in them, see below.

Variants. `llvm_ad_rgb`, `llvm_ad_mono` (which gets Y), `llvm_ad_spectral`, and the same of `cuda`; `scalar_rgb` and `scalar_spectral`, where Mitsuba calls Python for each
ray, hundreds of times slower: for small comparisons. The spectral ones need spectral tables in the atlas; then lights have spectra, in Mitsuba's own way, and
nothing below about light and colour applies. Wavelengths shorter than the tables' get the value at the shortest. Polarised variants are refused: the tables hold sums
over polarisations.

Light, in the other variants. The tables hold XYZ with the colour of their illuminant (`optics.illuminant` in specimen.json, usually D65) in
them: a perfect white matt surface would read that illuminant's white, over pi. So give emitters as plain relative numbers, the same in all channels: 1 is light of that
illuminant. D65 is white, (1, 1, 1), in linear sRGB. A coloured emitter multiplies channels of a sum over the spectrum, which is right only for colours that do not differ much
from white.

Colours outside sRGB. The colours of gratings are more saturated than sRGB can hold, and such a value has a negative channel. It is returned as it is: orders of several
wavelengths, or several lights, add up to the right sum only so, and clipping would make it brighter. Map to the display's gamut at the end; do not denoise before. With
`colours = "xyz"` nothing is negative: the film then holds XYZ, which is to be converted at the end, and everything else in the scene should be grey.

Directions are drawn from the coherent lobe above the horizon, from the tables, and evenly over solid angle: the same mixture as in the rest of the package and in the
Rust crate, with weights that stay bounded at grazing angles.

`mi.traverse` shows `scale`, `turn_deg`, the index `n` and, of metals, `k`, `tables` and `lobe`; all can be differentiated with respect to, as can
directions, and so lights. Tables that are changed are still sampled as they were.

Tables restricted to scenes have no answer for other directions: the value is NaN there, and no such direction is ever sampled. The surface reflects on
its front only; the plugin "twosided" puts it on both. A mesh without texture coordinates has no direction for the structure to lie along: `warn_of_meshes(scene)` tells of such.
"""

import warnings

import drjit as dr
import mitsuba as mi

if mi.variant() is None:
    raise ImportError('diffraction_atlas.mitsuba: choose a variant first, with mitsuba.set_variant("llvm_ad_rgb")')

# With a single thread Mitsuba 3.9 waits for ever for some files to be read.
if dr.thread_count() < 2:
    dr.set_thread_count(2)

if mi.variant().startswith("scalar"):
    from ._scalar import ScalarDiffraction as Diffraction
else:
    from ._bsdf import Diffraction

mi.register_bsdf("diffraction", Diffraction)


def warn_of_meshes(scene: mi.Scene) -> list[str]:
    """Warns of meshes with this BSDF that have no texture coordinates, and gives their names.

    On such a mesh the structure lies along another direction on every triangle.
    """
    named = []
    for shape in scene.shapes():
        carries = "Diffraction[" in str(shape.bsdf())
        if carries and shape.is_mesh() and not shape.has_vertex_texcoords():
            named.append(shape.id())
    if named:
        warnings.warn(
            f"diffraction: {', '.join(named)} without texture coordinates: the structure lies along another direction on every triangle; give the "
            "mesh texture coordinates",
            stacklevel=2,
        )
    return named


__all__ = ["Diffraction", "warn_of_meshes"]
