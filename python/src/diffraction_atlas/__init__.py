"""Reads atlases of diffraction tables, and evaluates and samples the BRDFs that they hold.

    import diffraction_atlas as da

    atlas = da.open("out/atlas/bundled")
    snake = atlas["sunbeam_snake_like"]
    wi, wo = da.from_angles_deg(35, 20), da.from_angles_deg(range(0, 90), 200)
    xyz = snake.eval(wi, wo)                       # (90, 3), 1/sr
    rgb = da.to_srgb(xyz, exposure=10)             # (90, 3), for a display

Directions are unit vectors in the local frame: x along the columns of the scan, y up the scan, z the outward normal; `wi` leads to the
light and `wo` to the viewer. Needs numpy and OpenEXR, and no other part of the project. `diffraction_atlas.mitsuba` is a BSDF for Mitsuba 3.
"""

from ._atlas import Atlas, open
from ._colour import SRGB_FROM_XYZ, to_linear_srgb, to_srgb
from ._directions import angles_deg, from_angles_deg
from ._footprint import Footprint
from ._images import AtlasError
from ._light import Illuminant, Lines, observer
from ._specimen import Sample, Specimen
from ._version import VERSION

__version__ = VERSION
__all__ = [
    "Atlas", "AtlasError", "Footprint", "Illuminant", "Lines", "SRGB_FROM_XYZ", "Sample", "Specimen", "angles_deg", "from_angles_deg",
    "observer", "open", "to_linear_srgb", "to_srgb",
]
