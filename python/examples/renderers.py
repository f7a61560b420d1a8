"""The table of docs/renderers.md: what reads an atlas, how well and how fast.

    python3 python/examples/renderers.py out/atlas/bundled [--errors]

Exits with 1 where one that is here misses them. Every reader evaluates the check values of every specimen; what it cannot do is said in its row. Times are of one processor, for random directions over the hemisphere. Each
variant of Mitsuba runs in a process of its own; those that this machine does not have are told. With `--errors` nothing is timed.
"""

import importlib.metadata
import math
import subprocess
import sys
import time

import numpy as np

import diffraction_atlas as da

VARIANTS = ("llvm_ad_rgb", "llvm_ad_mono", "llvm_ad_spectral", "cuda_ad_rgb", "scalar_rgb", "scalar_spectral")
SPECIMEN = "sunbeam_snake_like"
# Of a value's largest channel: single precision moves a place among 601 texels by 4e-5 of one, across which a sharp order changes a few times over.
ERROR_MAX = 2e-4
TIMED = "--errors" not in sys.argv


def directions(count: int, seed: int) -> np.ndarray:
    """Even over the hemisphere."""
    random = np.random.default_rng(seed).random((count, 2))
    return da.from_angles_deg(np.degrees(np.arccos(random[:, 0])), 360 * random[:, 1])


def per_call_us(call, count: int) -> float:
    """Microseconds of a processor for one of `count` look-ups; not a number where nothing is timed."""
    if not TIMED:
        return math.nan
    call()
    start = time.process_time()
    call()
    return (time.process_time() - start) / count * 1e6


def checks(atlas):
    """Directions and X, Y, Z of each specimen."""
    for specimen in atlas.values():
        arrays = (np.array([check[key] for check in specimen.check_values], float) for key in ("wi", "wo", "xyz"))
        yield specimen, *arrays


def largest(found, expected) -> float:
    """Largest difference as a share of a value's largest channel."""
    size = np.abs(expected).max(axis=1, keepdims=True)
    # Between the orders of a grating values are too small for single precision.
    return float(np.where(found == expected, 0, np.abs(found - expected) / np.maximum(size, 1e-30)).max())


def in_python(atlas, dtype) -> tuple[float, float, float]:
    """Error, and times of a look-up and of a sample, of the package."""
    error = max(largest(s.eval(wi.astype(dtype), wo.astype(dtype)), xyz) for s, wi, wo, xyz in checks(atlas))
    wi, wo = (directions(1 << 18, seed).astype(dtype) for seed in (1, 2))
    look_up = per_call_us(lambda: atlas[SPECIMEN].eval(wi, wo), len(wi))
    few, u = wo[: 1 << 12], np.random.default_rng(3).random((1 << 12, 3))
    return error, look_up, per_call_us(lambda: atlas[SPECIMEN].sample(few, u), len(few))


def in_mitsuba(atlas, variant) -> tuple[float, float, float]:
    """The same of the plugin, and a picture, in this process."""
    import drjit as dr
    import mitsuba as mi

    mi.set_variant(variant)
    import diffraction_atlas.mitsuba  # noqa: F401

    is_scalar, context, error = variant.startswith("scalar"), mi.BSDFContext(), 0.0

    def facing(wi, nm):
        si = mi.SurfaceInteraction3f() if is_scalar else dr.zeros(mi.SurfaceInteraction3f, len(wi))
        si.wi = mi.Vector3f(*wi.astype(np.float32)[0].tolist()) if is_scalar else mi.Vector3f(wi.astype(np.float32).T)
        if mi.is_spectral:
            si.wavelengths = mi.Spectrum(*nm[0].tolist()) if is_scalar else mi.Spectrum(np.repeat(nm[:1], len(wi), axis=0).T)
        return si

    def bsdf(specimen):
        return mi.load_dict({"type": "diffraction", "atlas": str(specimen.folder), "colours": "xyz", "energy_limit": False})

    def value(plugin, wi, wo, nm=None):
        if is_scalar:
            pairs = (plugin.eval(context, facing(v[None], nm), mi.Vector3f(*l.tolist())) for l, v in zip(wi, wo))
            return np.array([np.array(pair) for pair in pairs], float) / wi[:, 2:]
        found = np.array(plugin.eval(context, facing(wo, nm), mi.Vector3f(wi.astype(np.float32).T)), float)
        return found.reshape(-1, len(wi)).T / wi[:, 2:]

    for specimen, wi, wo, xyz in checks(atlas):
        if mi.is_spectral:
            for check in specimen.about["spectral"]["check_values"][:8]:
                nm = np.array([check["wavelength_nm"][:4]], np.float32)
                wi, wo = np.array([check["wi"]]), np.array([check["wo"]])
                error = max(error, largest(value(bsdf(specimen), wi, wo, nm), np.array([check["brdf"][:4]])))
        else:
            error = max(error, largest(value(bsdf(specimen), wi, wo), xyz[:, 1:2] if mi.is_monochromatic else xyz))
    plugin, count = bsdf(atlas[SPECIMEN]), 200 if is_scalar else 1 << 18
    wi, wo = directions(count, 1), directions(count, 2)
    nm = np.array([[450, 500, 550, 600]], np.float32)
    if is_scalar:
        look_up = per_call_us(lambda: value(plugin, wi, wo, nm), count)
        sample = per_call_us(lambda: [plugin.sample(context, facing(v[None], nm), 0.4, mi.Point2f(0.3, 0.6)) for v in wo], count)
        return error, look_up, sample
    si, light = facing(wo, nm), mi.Vector3f(wi.astype(np.float32).T)
    random = mi.PCG32(count)
    one, two = random.next_float32(), mi.Point2f(random.next_float32(), random.next_float32())
    dr.eval(si, light, one, two)

    def run(call):
        dr.eval(call())
        dr.sync_thread()

    look_up = per_call_us(lambda: run(lambda: plugin.eval(context, si, light)), count)
    return error, look_up, per_call_us(lambda: run(lambda: plugin.sample(context, si, one, two)), count)


def row(name, version, result) -> bool:
    """One line of the table; whether the error is one of single precision."""
    error, look_up, sample = result
    print(f"| {name} | {version} | {error:.0e} | {look_up:.2g} | {sample:.2g} |", flush=True)
    return error < ERROR_MAX


def main(path: str) -> bool:
    """Prints the table; whether every reader that is here meets the check values."""
    atlas = da.open(path)
    print("| reader | version | error against check values | look-up in us | sample in us |\n|---|---|---|---|---|")
    version = importlib.metadata.version("numpy")
    good = row("Python, double precision", f"numpy {version}", in_python(atlas, np.float64))
    good &= row("Python, single precision", f"numpy {version}", in_python(atlas, np.float32))
    for variant in VARIANTS:
        done = subprocess.run([sys.executable, __file__, path, variant, *sys.argv[2:]], capture_output=True, text=True)
        lines = [line for line in done.stdout.splitlines() if line.startswith("RESULT ")]
        if done.returncode == 0 and lines:
            mitsuba = importlib.metadata.version("mitsuba")
            good &= row(f"Mitsuba, `{variant}`", f"Mitsuba {mitsuba}", map(float, lines[0].split()[1:]))
        else:
            why = (done.stderr.strip().splitlines() or ["no reason given"])[-1]
            print(f"| Mitsuba, `{variant}` | not here: {why[:80]} | | | |", flush=True)
    return good


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--errors"]
    if len(words) == 2:
        print("RESULT", *in_mitsuba(da.open(words[0]), words[1]))
    elif len(words) == 1:
        sys.exit(0 if main(words[0]) else "a reader misses check values")
    else:
        sys.exit(__doc__)
