"""The BRDF of one specimen."""

from __future__ import annotations

import json
import threading
from pathlib import Path
from typing import Any, Callable, Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._directions import as_directions, over_pairs
from ._energy import EnergyLimit
from ._filtered import FilteredSpectral, FilteredTables
from ._footprint import Footprint
from ._images import AtlasError
from ._light import Illuminant, UnderLight, light_of
from ._optics import Vector, read_optics
from ._sampling import Sampler
from ._spectral import SpectralTables
from ._tables import SpectralAlone, Tables

#: Layouts of specimen.json that are read.
SCHEMAS = (1, 2, 3)
#: Directions at a time where each takes many look-ups.
FEW = 512
#: Look-ups at a time of spectral tables.
LOOK_UPS = 16384

Lookup = Literal["linear", "cubic", "spline"]


class Sample(NamedTuple):
    """Directions drawn by `Specimen.sample`."""

    #: (..., 3): unit vectors to the light; along the normal where none was drawn.
    wi: NDArray[np.float64]
    #: (..., 3): `f cos_theta_i / pdf`, X, Y, Z without unit; 0 where none was drawn. Its mean is the directional albedo.
    weight: NDArray[np.float64]
    #: (...): density over directions in 1/sr; 0 where none was drawn.
    pdf: NDArray[np.float64]


class Specimen:
    """The BRDF of one specimen: `atlas["name"]`, or `Specimen(folder)` with the folder that holds specimen.json.

    Directions `wi`, to the light, and `wo`, to the viewer, are unit vectors in the local frame: x along the columns of the scan, y up the
    scan, z the outward normal. They come as arrays of shape (..., 3) that go together by numpy's rules of broadcasting. Results have single precision
    where both have it, double precision otherwise. The BRDF has the unit 1/sr and does not contain the cosine. It is 0 where a direction is not above the
    surface (z > 0), and NaN where the tables have no answer, which only tables made for certain scenes do. Values may lie slightly below 0.

    Large arrays are evaluated on all of the process's processors (`DIFFRACTION_ATLAS_THREADS` sets how many threads). Objects may be shared between
    threads.
    """

    def __init__(self, folder: str | Path, about: dict[str, Any] | None = None):
        self.folder = Path(folder)
        self.about = read_about(self.folder) if about is None else about
        try:
            self._optics = read_optics(self.about["optics"])
            stored = self.about["tables"]
            self._tables = SpectralAlone(self.folder) if stored.get("derived_under") else Tables(self.folder, stored, self._optics)
            limit = self.about.get("energy_limit")
            self._limit = EnergyLimit(limit) if limit else None
        except KeyError as error:
            raise AtlasError(f"{self.folder / 'specimen.json'} lacks the field {error}; restore it, or run the pipeline again") from None
        self._lock = threading.RLock()

    def __repr__(self) -> str:
        return f"<Specimen {self.name!r} of {self.folder.parent}>"

    @property
    def name(self) -> str:
        """Its name in the atlas."""
        return self.about["name"]

    @property
    def species(self) -> str:
        """Its scientific name, or what it is made of."""
        return self.about["species"]

    @property
    def illuminant(self) -> Any:
        """The light that X, Y, Z are relative to, as specimen.json states it; "d65" mostly."""
        return self.about["optics"]["illuminant"]

    @property
    def has_spectral(self) -> bool:
        """Whether there are tables of single wavelengths."""
        return bool(self.about.get("spectral"))

    @property
    def has_energy_limit(self) -> bool:
        """Whether there is a limit: whether something would reflect more than arrives."""
        return self._limit is not None

    @property
    def check_values(self) -> list[dict[str, Any]]:
        """Directions to test an implementation with: X, Y, Z from linear look-ups as `xyz`, and by splines as `xyz_spline`."""
        return self.about["check_values"]

    def eval(
        self, wi: ArrayLike, wo: ArrayLike, *, lookup: Lookup = "linear", energy_limit: bool = False
    ) -> NDArray:
        """X, Y, Z of the BRDF in 1/sr: shape (..., 3). Where the atlas holds spectral tables alone, from these, under its own light.

        `lookup` says how values between texels are found: "linear" as graphics hardware does, "cubic" from sixteen texels, with less error between them,
        "spline" by the cubic B-spline through all of them, which keeps the tolerance that the tables were made with (its coefficients, twice the tables'
        memory, are made at the first such call; the lobe, and tables made for certain scenes, are looked up as by "cubic"). `energy_limit` divides by what keeps every direction from reflecting more than arrives, where the specimen needs it.
        """
        lookup = _known(lookup)
        limit = self._limit if energy_limit else None
        own = self._own_light if isinstance(self._tables, SpectralAlone) else None

        def evaluate(wi: Vector, wo: Vector) -> NDArray:
            value = self._tables.brdf(wi, wo, lookup) if own is None else self._sum_under(own, wi, wo, lookup)
            return value if limit is None else value * limit.factor(wi[2], wo[2])[:, None]

        return over_pairs(evaluate, wi, wo, 3)

    def eval_filtered(
        self,
        wi: ArrayLike,
        wo: ArrayLike,
        *,
        angular_diameter_deg: ArrayLike = 0.0,
        footprint: Footprint | None = None,
        lookup: Lookup = "linear",
        energy_limit: bool = False,
    ) -> NDArray:
        """Mean of the BRDF over a light with a size around `wi`, X, Y, Z in 1/sr: shape (..., 3).

        With the light's irradiance E on a plane that faces it, evenly over its disc of `angular_diameter_deg` (the sun: 0.53), the radiance is this times
        `cos_theta_i E`. `footprint` adds what else a look-up stands for, such as a pixel on a curved surface. Tables and lobe are averaged over the ellipse, at the centre's
        factor and |w|: within 0.1 % for the sun, 1 % for a lamp two degrees wide, at 95 of 100 directions; sample much larger lights instead.
        """
        lookup = _known(lookup)
        wi, wo = as_directions("wi", wi), as_directions("wo", wo)
        covariance = self._covariance(wi, angular_diameter_deg, footprint)
        limit, filtered = self._limit if energy_limit else None, self._filtered

        def evaluate(wi: Vector, wo: Vector, covariance: NDArray) -> NDArray:
            value = filtered.brdf(wi, wo, covariance, lookup)
            return value if limit is None else value * limit.factor(wi[2], wo[2])[:, None]

        return over_pairs(evaluate, wi, wo, 3, covariance, FEW)

    def eval_wavelengths(
        self,
        wi: ArrayLike,
        wo: ArrayLike,
        wavelengths_nm: ArrayLike,
        *,
        lookup: Lookup = "linear",
        angular_diameter_deg: ArrayLike = 0.0,
        footprint: Footprint | None = None,
    ) -> NDArray:
        """The BRDF in 1/sr at wavelengths in nm: shape (..., wavelengths).

        `wavelengths_nm` has the shape (wavelengths,), or (..., wavelengths) where each pair of directions has its own. A light's size or a footprint make it a
        mean, as in `eval_filtered`.
        """
        tables, lookup = self._spectral_tables, _known(lookup)
        nm = np.atleast_1d(np.asarray(wavelengths_nm, float))
        tables.check_wavelengths(nm)
        chunk = max(1, LOOK_UPS // max(1, nm.shape[-1]))
        if footprint is None and not np.any(angular_diameter_deg):
            if nm.ndim == 1:
                return over_pairs(lambda wi, wo: tables.brdf(wi, wo, nm, lookup), wi, wo, nm.shape[-1], None, chunk)
            evaluate = lambda wi, wo, nm: tables.brdf(wi, wo, nm, lookup)
            return over_pairs(evaluate, wi, wo, nm.shape[-1], nm, chunk)
        wi, wo = as_directions("wi", wi), as_directions("wo", wo)
        covariance = self._covariance(wi, angular_diameter_deg, footprint)
        shape = np.broadcast_shapes(nm.shape[:-1], covariance.shape[:-1])
        both = [np.broadcast_to(part, shape + part.shape[-1:]) for part in (covariance, nm)]
        filtered = self._filtered_spectral

        def evaluate_filtered(wi: Vector, wo: Vector, both: NDArray) -> NDArray:
            return filtered.brdf(wi, wo, both[:, :3], both[:, 3:], lookup)

        chunk = max(1, FEW // max(1, nm.shape[-1]))
        return over_pairs(evaluate_filtered, wi, wo, nm.shape[-1], np.concatenate(both, axis=-1), chunk)

    def xyz_under(self, wi: ArrayLike, wo: ArrayLike, illuminant: Illuminant, *, lookup: Lookup = "linear") -> NDArray:
        """X, Y, Z of the BRDF in 1/sr under any light, from the spectral tables: shape (..., 3).

        `illuminant` is "D65", "A", "E", "F1" to "F12", a pair of arrays (wavelength in nm, relative power), or `Lines`. Values are relative to that light: a white matt
        surface has Y = 1/pi. The light counts from the tables' shortest wavelength to their longest.
        """
        lookup, light = _known(lookup), self._under(illuminant)
        return over_pairs(lambda wi, wo: self._sum_under(light, wi, wo, lookup), wi, wo, 3)

    def sample(self, wo: ArrayLike, u: ArrayLike, *, lookup: Lookup = "linear", energy_limit: bool = False) -> Sample:
        """Directions to the light, given those to the viewer and numbers that are uniform in [0, 1): `wo` and `u` of shape (..., 3).

        The density is a mixture of the coherent lobe above the horizon, the tables, and a remainder that is even over solid angle, so that weights are bounded at grazing
        angles too. The model is reciprocal: light paths may swap the roles of wi and wo.
        """
        random = np.asarray(u, float)
        if random.ndim == 0 or random.shape[-1] != 3 or not np.all((random >= 0) & (random < 1)):
            raise ValueError(f"u must hold numbers in [0, 1) of shape (..., 3); its shape is {random.shape}")
        sampler, up = self._sampler, np.array([0.0, 0.0, 1.0])

        def draw(wo: Vector, _: Vector, random: NDArray) -> NDArray:
            out = np.zeros((len(wo[0]), 4))
            out[:, 2] = 1
            (above,) = np.nonzero(wo[2] > 0)
            if len(above):
                viewer = tuple(d[above].astype(float) for d in wo)
                wi, found = sampler.sample(viewer, *random[above].T)
                wi[~found] = up
                pdf = np.where(found, sampler.pdf(tuple(wi.T), viewer), 0)
                out[above] = np.concatenate([wi, pdf[:, None]], axis=1)
            return out

        wo = as_directions("wo", wo).astype(float)
        drawn = over_pairs(draw, wo, up, 4, random, FEW)
        wi, pdf = drawn[..., :3], drawn[..., 3]
        value = self.eval(wi, wo, lookup=lookup, energy_limit=energy_limit)
        # Where the tables have no answer there is no sample.
        found = (pdf > 0) & np.isfinite(value).all(axis=-1)
        weight = np.where(found[..., None], value * (wi[..., 2] / np.where(found, pdf, 1))[..., None], 0)
        return Sample(np.where(found[..., None], wi, up), weight, np.where(found, pdf, 0))

    def pdf(self, wi: ArrayLike, wo: ArrayLike) -> NDArray[np.float64]:
        """Density in 1/sr with which `sample` draws `wi` for these `wo`: shape (...). 0 where it never does."""
        sampler, tables = self._sampler, self._tables

        def density(wi: Vector, wo: Vector) -> NDArray:
            value = np.zeros(len(wi[0]))
            (above,) = np.nonzero((wi[2] > 0) & (wo[2] > 0))
            if len(above):
                pair = [tuple(d[above].astype(float) for d in direction) for direction in (wi, wo)]
                value[above] = sampler.pdf(*pair)
                if tables.range is not None:
                    value[above[~np.isfinite(tables.brdf(*pair, "linear")).all(axis=1)]] = 0
            return value

        return over_pairs(density, as_directions("wi", wi).astype(float), as_directions("wo", wo).astype(float), None, None, FEW)

    def _sum_under(self, light: UnderLight, wi: Vector, wo: Vector, lookup: str) -> NDArray:
        """(direction, 3): spectral tables summed over a light."""
        value = np.zeros((len(wi[0]), 3), wi[0].dtype)
        ring = light.ring(np.hypot(wi[0] + wo[0], wi[1] + wo[1]))
        for number in np.unique(ring):
            (those,) = np.nonzero(ring == number)
            sums = light.quadratures[number]
            step = max(1, LOOK_UPS // len(sums.wavelength_nm))
            for start in range(0, len(those), step):
                part = those[start : start + step]
                pair = [tuple(d[part] for d in direction) for direction in (wi, wo)]
                spectrum = self._spectral_tables.brdf(*pair, sums.wavelength_nm, lookup)
                value[part] = spectrum @ sums.weights.astype(spectrum.dtype)
        return value

    # Made when they are needed

    def _covariance(self, wi: NDArray, diameter_deg: ArrayLike, footprint: Footprint | None) -> NDArray:
        light = Footprint.of_light(wi, diameter_deg)
        return (light if footprint is None else light + footprint).stacked()

    def _once(self, key: str, make: Callable[[], Any]) -> Any:
        with self._lock:
            if key not in self.__dict__:
                self.__dict__[key] = make()
            return self.__dict__[key]

    @property
    def _spectral_tables(self) -> SpectralTables:
        stored = self.about.get("spectral")
        if not stored:
            raise ValueError(
                f'{self.name} has no spectral tables: run the pipeline with "spectral" in tables.hold, or ask for X, Y, Z under the light of its tables'
            )
        return self._once("_spectral_made", lambda: SpectralTables(self.folder, stored, self._optics))

    @property
    def _own_light(self) -> UnderLight:
        """The light that X, Y, Z are relative to."""
        tables = self._spectral_tables
        return self._once("_own_light_made", lambda: UnderLight(tables, light_of(self.illuminant)))

    @property
    def _filtered(self) -> FilteredTables:
        return self._once("_filtered_made", lambda: FilteredTables(self._tables))

    @property
    def _filtered_spectral(self) -> FilteredSpectral:
        return self._once("_filtered_spectral_made", lambda: FilteredSpectral(self._spectral_tables))

    @property
    def _sampler(self) -> Sampler:
        return self._once("_sampler_made", lambda: Sampler(self._tables))

    def _under(self, illuminant: Illuminant) -> UnderLight:
        if not isinstance(illuminant, str):
            return UnderLight(self._spectral_tables, illuminant)
        tables = self._spectral_tables
        return self._once(f"_under {illuminant.upper()}", lambda: UnderLight(tables, illuminant))


def _known(lookup: str) -> str:
    if lookup not in get_args(Lookup):
        raise ValueError(f'lookup is "linear", "cubic" or "spline", not {lookup!r}')
    return lookup


def read_about(folder: Path) -> dict[str, Any]:
    """specimen.json of a specimen's folder."""
    path = folder / "specimen.json"
    try:
        about = json.loads(path.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise AtlasError(f"there is no {path}: give the folder of an atlas, of one of its versions, or of a specimen") from None
    except (OSError, ValueError) as error:
        raise AtlasError(f"{path} cannot be read: {error}. Restore it, or run the pipeline again") from error
    if about.get("schema") not in SCHEMAS:
        raise AtlasError(f"{path} has the schema {about.get('schema')}; this version of diffraction_atlas reads {SCHEMAS[0]} to {SCHEMAS[-1]}")
    return about
