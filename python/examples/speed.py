"""How many directions a second are evaluated.

    python3 python/examples/speed.py out/atlas/bundled sunbeam_snake_like

Random directions over the hemisphere. In millions a second of one processor's time, which other load on the machine leaves much the same, and by the clock.
"""

import sys
import time

import numpy as np

import diffraction_atlas as da

REPEATS = 4


def directions(count: int, dtype, seed: int) -> np.ndarray:
    """Even over the hemisphere."""
    random = np.random.default_rng(seed).random((count, 2))
    return da.from_angles_deg(np.degrees(np.arccos(random[:, 0])), 360 * random[:, 1]).astype(dtype)


def main(atlas: str, name: str) -> None:
    """Prints a row of a table for each kind of call."""
    specimen = da.open(atlas)[name]
    nm = np.linspace(400, 700, 31)
    kinds = {
        "X, Y, Z, linear": (1 << 20, lambda wi, wo: specimen.eval(wi, wo)),
        "X, Y, Z, cubic": (1 << 18, lambda wi, wo: specimen.eval(wi, wo, lookup="cubic")),
        "one wavelength": (1 << 18, lambda wi, wo: specimen.eval_wavelengths(wi, wo, 550.0)),
        "31 wavelengths": (1 << 14, lambda wi, wo: specimen.eval_wavelengths(wi, wo, nm)),
        "under another light": (1 << 13, lambda wi, wo: specimen.xyz_under(wi, wo, "A")),
        "mean over the sun": (1 << 13, lambda wi, wo: specimen.eval_filtered(wi, wo, angular_diameter_deg=0.53)),
        "density": (1 << 14, lambda wi, wo: specimen.pdf(wi, wo)),
        "sample": (1 << 14, lambda wi, wo: specimen.sample(wo, np.random.default_rng(1).random((len(wo), 3)))),
    }
    print("| | single: a processor | by the clock | double: a processor | by the clock |\n|---|---|---|---|---|")
    for kind, (count, call) in kinds.items():
        row = []
        for dtype in (np.float32, np.float64):
            wi, wo = directions(count, dtype, 1), directions(count, dtype, 2)
            call(wi, wo)
            times = []
            for _ in range(REPEATS):
                start = time.process_time(), time.perf_counter()
                call(wi, wo)
                times.append((time.process_time() - start[0], time.perf_counter() - start[1]))
            row += [f"{count / min(part) / 1e6:.2g}" for part in zip(*times)]
        print(f"| {kind} | {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:]) if len(sys.argv) == 3 else sys.exit(__doc__)
