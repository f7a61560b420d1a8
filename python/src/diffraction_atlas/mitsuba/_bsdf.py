"""The plugin "diffraction"; its parameters are told at the top of the package `diffraction_atlas.mitsuba`."""

import drjit as dr
import mitsuba as mi

from .._colour import SRGB_FROM_XYZ
from . import _tables
from ._parameters import FLAGS, Parameters
from ._sampler import Sampler


class Diffraction(mi.BSDF):
    """A surface with a specimen's structure."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.given = given = Parameters(props)
        specimen, self.scale, self.turn_deg = given.specimen, given.scale, given.turn_deg
        if mi.is_spectral:
            self.brdf = _tables.Spectral(specimen, given.look_up, given.light_deg)
        else:
            self.brdf = _tables.Colours(specimen, given.look_up, given.light_deg)
        self.limit = _tables.Limit(specimen) if given.limited and specimen.has_energy_limit else None
        self.is_restricted = specimen._tables.range is not None
        self.sampler = Sampler(specimen._sampler)
        self.m_components = [FLAGS]
        self.m_flags = FLAGS

    def traverse(self, cb):
        """What can be changed, and differentiated with respect to."""
        flags = mi.ParamFlags.Differentiable
        for name in ("scale", "turn_deg"):
            cb.put(name, getattr(self, name), flags)
        for name, value in self.brdf.parameters().items():
            cb.put(name, value, flags)

    # Mitsuba's interface: directions in the shading frame, values times cos(theta_o)

    def structure_frame(self, si):
        """Cosine and sine from the shading frame's x axis to the structure's, and 1 or, where it is mirrored, -1."""
        along = si.to_local(si.dp_du)
        length = dr.sqrt(along.x * along.x + along.y * along.y)
        cos = dr.select(length > 0, along.x / length, 1)
        sin = dr.select(length > 0, along.y / length, 0)
        side = mi.Float(1)
        if self.given.mirror:
            across = si.to_local(si.dp_dv)
            side = dr.select(self.given.mirror * (cos * across.y - sin * across.x) < 0, -1, mi.Float(1))
        turn_sin, turn_cos = dr.sincos(dr.deg2rad(self.turn_deg.eval_1(si)))
        # The turn goes from x towards y, wherever y is.
        turn_sin *= side
        return cos * turn_cos - sin * turn_sin, sin * turn_cos + cos * turn_sin, side

    def value(self, si, wi, wo, active):
        """The BRDF times the cosine, as the variant counts."""
        value = self.brdf.value(wi, wo, si.wavelengths, active)
        if self.limit is not None:
            value = value * self.limit.factor(wi, wo, active)
        scaled = self.scale.eval_1(si, active) * wo.z
        return self.spectrum(value) * scaled

    def spectrum(self, value):
        """What the variant wants of a value at its wavelengths or of X, Y, Z."""
        if mi.is_spectral:
            return value
        if mi.is_monochromatic:
            return mi.Color1f(value.y)
        if self.given.as_xyz:
            return mi.Color3f(value)
        return mi.Color3f(*(sum(factor * value[k] for k, factor in enumerate(row)) for row in SRGB_FROM_XYZ.tolist()))

    def density(self, wi, wo, active):
        """Of `wo`, in 1/sr: the mixture, where the tables answer."""
        with dr.suspend_grad():
            density = self.sampler.pdf(dr.detach(wo), dr.detach(wi), active)
            if self.is_restricted:
                density = dr.select(self.brdf.answers(wi, wo, active), density, 0)
        return density

    def eval(self, ctx, si, wo, active=True):
        frame = self.structure_frame(si)
        wi, wo = to_structure(frame, si.wi), to_structure(frame, wo)
        active = self.is_lit(ctx, wi, wo, active)
        return dr.select(active, self.value(si, wi, wo, active), 0.0)

    def pdf(self, ctx, si, wo, active=True):
        frame = self.structure_frame(si)
        wi, wo = to_structure(frame, si.wi), to_structure(frame, wo)
        active = self.is_lit(ctx, wi, wo, active)
        return dr.select(active, self.density(wi, wo, active), 0.0)

    def eval_pdf(self, ctx, si, wo, active=True):
        frame = self.structure_frame(si)
        wi, wo = to_structure(frame, si.wi), to_structure(frame, wo)
        active = self.is_lit(ctx, wi, wo, active)
        return dr.select(active, self.value(si, wi, wo, active), 0.0), dr.select(active, self.density(wi, wo, active), 0.0)

    def sample(self, ctx, si, sample1, sample2, active=True):
        frame = self.structure_frame(si)
        wi = to_structure(frame, si.wi)
        active = mi.Bool(active) & ctx.is_enabled(mi.BSDFFlags.GlossyReflection) & (wi.z > 0)
        with dr.suspend_grad():
            wo, found = self.sampler.sample(dr.detach(wi), sample1, sample2, active)
        density = dr.select(found, self.density(wi, wo, found), 0.0)

        bs = dr.zeros(mi.BSDFSample3f)
        bs.wo = to_shading(frame, wo)
        bs.pdf = density
        bs.eta = 1.0
        bs.sampled_type = mi.UInt32(+mi.BSDFFlags.GlossyReflection)
        bs.sampled_component = mi.UInt32(0)
        value = self.value(si, wi, wo, found) / dr.select(density > 0, density, 1)
        # Where the tables have no answer there is no sample; light sampling shows NaN there.
        return bs, dr.select(found & (density > 0) & dr.all(dr.isfinite(value)), value, 0.0)

    def is_lit(self, ctx, wi, wo, active):
        return mi.Bool(active) & ctx.is_enabled(mi.BSDFFlags.GlossyReflection) & (wi.z > 0) & (wo.z > 0)

    def to_string(self):
        return self.given.told()


def to_structure(frame, v):
    """A vector of the shading frame in that of the structure."""
    cos, sin, side = frame
    return mi.Vector3f(cos * v.x + sin * v.y, side * (cos * v.y - sin * v.x), v.z)


def to_shading(frame, v):
    """The inverse."""
    cos, sin, side = frame
    y = side * v.y
    return mi.Vector3f(cos * v.x - sin * y, cos * y + sin * v.x, v.z)
