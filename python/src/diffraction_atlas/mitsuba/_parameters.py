"""The plugin's parameters, as they come from a scene."""

from functools import lru_cache
from pathlib import Path

import mitsuba as mi

from .. import _atlas
from .._specimen import Specimen

#: What the surface is to Mitsuba.
FLAGS = mi.BSDFFlags.GlossyReflection | mi.BSDFFlags.FrontSide | mi.BSDFFlags.Anisotropic


class Parameters:
    """What a scene says of the surface; see `diffraction_atlas.mitsuba`."""

    def __init__(self, props):
        if mi.is_polarized:
            raise ValueError(
                f'diffraction: the variant "{mi.variant()}" will not do: the tables hold sums over polarisations. Use "llvm_ad_rgb", '
                '"llvm_ad_mono", "llvm_ad_spectral", the same of cuda, "scalar_rgb", or "scalar_spectral"'
            )
        self.specimen = open_specimen(str(props["atlas"]), str(props.get("specimen", "")))
        if mi.is_spectral and not self.specimen.has_spectral:
            raise ValueError(
                f'diffraction: the variant "{mi.variant()}" wants spectral tables, and {self.specimen.folder} has none: make the atlas with '
                '"spectral" in tables.hold, or use a variant of rgb'
            )
        self.scale, self.turn_deg = props.get_texture("scale", 1.0), props.get_texture("turn_deg", 0.0)
        self.mirror = {"none": 0, "v": 1, "flipped_v": -1}[choice(props, "mirror_with", ("none", "v", "flipped_v"))]
        self.look_up = choice(props, "look_up", ("linear", "cubic", "spline"))
        self.light_deg = float(props.get("light_deg", 0.0))
        if not 0 <= self.light_deg <= 10:
            raise ValueError(f"diffraction: light_deg = {self.light_deg}; it may be between 0 and 10")
        self.as_xyz = choice(props, "colours", ("srgb", "xyz")) == "xyz"
        self.limited = bool(props.get("energy_limit", True))

    def told(self):
        """The plugin in words."""
        return f"Diffraction[\n  folder = {self.specimen.folder},\n  scale = {self.scale},\n  turn_deg = {self.turn_deg}\n]"


def open_specimen(atlas, specimen) -> Specimen:
    """The specimen that the plugin's parameters name; a ValueError that says what is there instead."""
    folder = Path(atlas)
    if not folder.exists():
        folder = Path(str(mi.file_resolver().resolve(atlas)))
    latest = folder / "latest"
    if latest.is_file():
        folder = folder / latest.read_text(encoding="utf-8").strip()
    return _opened(folder.resolve(), atlas, specimen)


@lru_cache(maxsize=8)
def _opened(folder, atlas, specimen) -> Specimen:
    """Versions of an atlas never change: surfaces of one specimen share what is read and prepared."""
    if (folder / "specimen.json").is_file():
        if specimen not in ("", folder.name):
            raise ValueError(f'diffraction: "{atlas}" is the folder of "{folder.name}", not of "{specimen}"')
        return Specimen(folder)
    opened = _atlas.open(folder)
    if not specimen and len(opened) == 1:
        specimen = opened.names[0]
    if specimen not in opened.names:
        raise ValueError(f'diffraction: specimen = "{specimen}"; {opened.folder} has {", ".join(opened.names)}')
    return opened[specimen]


def choice(props, key, allowed):
    """The string of a parameter, the first of `allowed` where it is not given."""
    value = str(props.get(key, allowed[0]))
    if value not in allowed:
        raise ValueError(f'diffraction: {key} = "{value}"; it may be {" or ".join(allowed)}')
    return value
