"""The plugin in Mitsuba's scalar variants: one pair of directions at a time, through the package's functions for numpy."""

import math

import mitsuba as mi
import numpy as np

from .._colour import SRGB_FROM_XYZ
from ._parameters import FLAGS, Parameters


class ScalarDiffraction(mi.BSDF):
    """The same surface as `Diffraction`; hundreds of times slower."""

    def __init__(self, props):
        mi.BSDF.__init__(self, props)
        self.given = Parameters(props)
        self.m_components = [FLAGS]
        self.m_flags = FLAGS
        self.lookup = {"lookup": self.given.look_up}

    def traverse(self, cb):
        """What can be changed."""
        for name in ("scale", "turn_deg"):
            cb.put(name, getattr(self.given, name), mi.ParamFlags.NonDifferentiable)

    def frame(self, si):
        """The axes of the structure in the shading frame, as rows."""
        along = si.to_local(si.dp_du)
        length = math.hypot(along[0], along[1])
        x = np.array([along[0], along[1]]) / length if length > 0 else np.array([1.0, 0.0])
        y = np.array([-x[1], x[0]])
        if self.given.mirror:
            across = si.to_local(si.dp_dv)
            y = -y if self.given.mirror * (y[0] * across[0] + y[1] * across[1]) < 0 else y
        turn = math.radians(self.given.turn_deg.eval_1(si))
        cos, sin = math.cos(turn), math.sin(turn)
        return np.array([[*(cos * x + sin * y), 0.0], [*(cos * y - sin * x), 0.0], [0.0, 0.0, 1.0]])

    def value(self, si, wi, wo):
        """The BRDF times the cosine, as the variant counts; the light is `wo`."""
        given, specimen = self.given, self.given.specimen
        light = {"angular_diameter_deg": given.light_deg}
        if mi.is_spectral:
            nm = np.maximum(np.array(si.wavelengths, float), specimen._spectral_tables.shortest_nm)
            value = specimen.eval_wavelengths(wo, wi, nm, **self.lookup, **light)
            if given.limited and specimen.has_energy_limit:
                value = value * specimen._limit.factor(wi[2:], wo[2:])
        elif given.light_deg:
            value = specimen.eval_filtered(wo, wi, energy_limit=given.limited, **self.lookup, **light)
        else:
            value = specimen.eval(wo, wi, energy_limit=given.limited, **self.lookup)
        if not mi.is_spectral and not given.as_xyz:
            value = SRGB_FROM_XYZ @ value
        return mi.Spectrum(*(value * (given.scale.eval_1(si) * wo[2])).tolist())

    def pair(self, ctx, si, wo, active):
        """Directions in the frame of the structure; None where nothing is reflected."""
        if not (active and ctx.is_enabled(mi.BSDFFlags.GlossyReflection) and si.wi[2] > 0 and wo[2] > 0):
            return None
        frame = self.frame(si)
        return unit(frame @ np.array(si.wi, float)), unit(frame @ np.array(wo, float))

    def eval_pdf(self, ctx, si, wo, active=True):
        pair = self.pair(ctx, si, wo, active)
        if pair is None:
            return mi.Spectrum(0), 0.0
        return self.value(si, *pair), float(self.given.specimen.pdf(pair[1], pair[0]))

    def eval(self, ctx, si, wo, active=True):
        pair = self.pair(ctx, si, wo, active)
        return mi.Spectrum(0) if pair is None else self.value(si, *pair)

    def pdf(self, ctx, si, wo, active=True):
        pair = self.pair(ctx, si, wo, active)
        return 0.0 if pair is None else float(self.given.specimen.pdf(pair[1], pair[0]))

    def sample(self, ctx, si, sample1, sample2, active=True):
        bs = mi.BSDFSample3f()
        bs.pdf, bs.eta = 0.0, 1.0
        bs.sampled_type, bs.sampled_component = +mi.BSDFFlags.GlossyReflection, 0
        pair = self.pair(ctx, si, [0.0, 0.0, 1.0], active)
        if pair is None:
            return bs, mi.Spectrum(0)
        u = np.minimum([sample1, sample2[0], sample2[1]], 1 - 2**-24)
        drawn = self.given.specimen.sample(pair[0], u)
        wo = self.frame(si).T @ drawn.wi
        bs.wo, bs.pdf = mi.Vector3f(*wo.tolist()), float(drawn.pdf)
        if not bs.pdf > 0:
            return bs, mi.Spectrum(0)
        return bs, self.value(si, pair[0], drawn.wi) / bs.pdf

    def to_string(self):
        return self.given.told()


def unit(vector):
    """Scaled to length 1: Mitsuba's directions are in single precision."""
    return vector / np.linalg.norm(vector)
