"""Quick check of the rigorous solver and of the stored cases, for CI (under a minute on one core).

    python check.py                    exit status 0 if all holds, 1 if not
    python check.py --perturb NAME     plants a mistake in the model's factors; must end with status 1

First the solver against itself and against what is known exactly, then the factors against the solver where they are
exact (shallow gratings), then a part of `cases.csv` computed anew, then the warning's confusion figures.
"""

import argparse
import os
import sys
import time

# Matrices of a few dozen rows: threads that wait for each other take twenty times as long.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

import rule
from factors import all_cases, model_orders, propagating, read_cases, scalar_factor, solve_case, vector_factor, verdict
from profiles import PROFILES, Profile
from solver import MATERIALS, POLARISATIONS, default_half, fresnel, solve, unpolarised

MISTAKES = ("sign-of-phi", "exchange-a-b", "no-cosine", "sign-of-u")
failures = []


def expect(name, error, limit):
    """Notes an error and whether it stays within its limit (a NaN does not)."""
    good = bool(error <= limit)
    print(f"{'ok  ' if good else 'FAIL'} {name}: {error:.1e} (limit {limit:.0e})")
    if not good:
        failures.append(name)


def farthest(a, b, scale=1.0):
    """Largest difference between the same orders of two results."""
    return max(abs(a[m] - b[m]) for m in a) / scale


def flat_surface():
    """A grating of almost no depth is a mirror with Fresnel's reflectance."""
    worst = 0.0
    for index in MATERIALS.values():
        for theta in (0, 60):
            for kind in PROFILES:
                for pol, exact in zip(POLARISATIONS, fresnel(index, theta)):
                    found = solve(Profile(kind, 1.55, 1e-8), index, theta, pol, half=12).reflected[0]
                    worst = max(worst, abs(found - exact))
    expect("flat surface is Fresnel's", worst, 1e-6)


def energy():
    """What a surface without loss sends out is what came in."""
    for kind, limit in zip(PROFILES, (1e-9, 1e-3, 1e-9)):
        totals = [solve(Profile(kind, d, h), index, theta, pol).total()
                  for index in (None, 1.56) for d, h in ((0.8, 0.3), (2.1, 0.2)) for theta in (0, 60)
                  for pol in POLARISATIONS]
        expect(f"energy, {kind}", max(abs(t - 1) for t in totals), limit)


def reciprocity():
    """Order m is as strong when light comes back along it. (Energy cannot be checked on a metal; this can.)"""
    for kind, limit in zip(PROFILES, (1e-9, 1e-3, 1e-3)):
        worst = 0.0
        for index in MATERIALS.values():
            profile, theta = Profile(kind, 1.55, 0.25), 20.0
            back = -np.degrees(np.arcsin(np.sin(np.radians(theta)) - 1 / profile.period))
            for pol in POLARISATIONS:
                there = solve(profile, index, theta, pol).reflected[-1]
                worst = max(worst, abs(solve(profile, index, back, pol).reflected[-1] / there - 1))
        expect(f"reciprocity, {kind}", worst, limit)


def methods_agree():
    """Different methods on the same grating."""
    for kind in ("sinusoid", "blaze"):
        profile = Profile(kind, 1.05, 0.2)
        for material, pol in (("dielectric", "s"), ("dielectric", "p"), ("aluminium", "s")):
            index = MATERIALS[material]
            smooth = solve(profile, index, 60, pol).reflected
            stairs = solve(profile, index, 60, pol, method="layered", half=25, layers=60).reflected
            expect(f"C-method and RCWA, {kind} {material} {pol}", farthest(smooth, stairs), 1e-3)
    for material in ("dielectric", "aluminium"):
        for pol in POLARISATIONS:
            profile, index = Profile("sinusoid", 1.55, 0.15), MATERIALS[material]
            few = solve(profile, index, 60, pol, method="rayleigh", half=8).reflected
            expect(f"C-method and Rayleigh's, {material} {pol}",
                   farthest(solve(profile, index, 60, pol).reflected, few), 1e-7)


def perfect_limit():
    """An ever better conductor becomes the perfect one: the difference is a series in 1/|n|, taken away up to its square.
    (A little loss keeps RCWA from the spurious modes of a lossless metal.)"""
    for kind, limits in (("blaze", (1e-3, 1e-3)), ("lamellar", (1e-3, 1e-2))):
        profile, half = Profile(kind, 1.55, 0.2), 90 if kind == "lamellar" else None
        for pol, limit in zip(POLARISATIONS, limits):
            exact = solve(profile, None, 60, pol).reflected
            near, mid, far = (solve(profile, k * (0.3 + 1j), 60, pol, half=half).reflected for k in (40.0, 20.0, 10.0))
            found = {m: (8 * near[m] - 6 * mid[m] + far[m]) / 3 for m in exact}
            expect(f"limit of perfect conduction, {kind} {pol}", farthest(exact, found), limit)


def converged():
    """More orders change nothing that matters."""
    for kind in PROFILES:
        for material, index in MATERIALS.items():
            profile, worst = Profile(kind, 1.55, 0.3), 0.0
            method = "coordinate" if kind != "lamellar" else "layered" if index else "groove_modes"
            half = default_half(profile, method)
            for theta in (0, 60):
                usual = unpolarised(profile, index, theta).reflected
                more = unpolarised(profile, index, theta, half=int(1.3 * half)).reflected
                worst = max(worst, farthest(usual, more, np.mean(fresnel(index, theta))))
            expect(f"converged, {kind} {material}", worst, 2e-3 if material == "aluminium" else 1e-3)


def first_order(perturb):
    """On a shallow sinusoid the vector factor is exact; in the mirror direction both factors are R G."""
    for material, index in MATERIALS.items():
        worst, mirror = 0.0, 0.0
        for period, theta in ((1.55, 0), (0.8, 60), (1.55, 60), (3.1, 30)):
            profile = Profile("sinusoid", period, 2e-3)
            m, _ = propagating(period, theta)
            exact = unpolarised(profile, index, theta).reflected
            model = model_orders(profile, index, theta, perturb)["vector"]
            worst = max(worst, *(abs(v / exact[n] - 1) for n, v in zip(m.tolist(), model) if abs(n) == 1))
            cosine, sine = np.cos(np.radians(theta)), np.sin(np.radians(theta))
            there = (index, cosine, np.array([cosine]), sine, np.array([sine]))
            mirror = max(mirror, abs(scalar_factor(*there)[0] / vector_factor(*there)[0] - 1))
        expect(f"shallow limit of the vector factor, {material}", worst, 1e-3)
        expect(f"both factors at the mirror, {material}", mirror, 1e-9)


def blaze_leans(perturb):
    """A gentle blaze throws its light to the side that the model says: the sign of m, which a symmetric profile hides."""
    profile, index = Profile("blaze", 4.1, 0.2), MATERIALS["dielectric"]
    exact = solve_case("dielectric", profile, 0.0)
    strong = exact["rigorous"] > 0.03 * exact["reflectance"]
    for factor in ("scalar", "vector"):
        model = model_orders(profile, index, 0.0, perturb)[factor]
        expect(f"gentle blaze, {factor} factor", np.abs(model / exact["rigorous"] - 1)[strong].max(), 0.1)


def stored_cases(perturb):
    """A part of cases.csv computed anew, and all of its model columns."""
    rows = read_cases()
    if len(rows) != sum(1 for _ in all_cases()):
        failures.append("number of cases")
    names = [(r["material"], r["profile"], r["theta"]) for r in rows]
    expect("cases in order", float(sum(a != b for a, b in zip(names, all_cases()))), 0.5)
    worst = {"rigorous": 0.0, "scalar": 0.0, "vector": 0.0}
    # Small periods are quick; 11 is prime to the numbers of depths and angles, so all of them take part.
    for row in [r for r in rows if r["profile"].period < 3][::11]:
        fresh = solve_case(row["material"], row["profile"], row["theta"])
        error = np.abs(fresh["rigorous"] - row["rigorous"]).max() / row["reflectance"]
        worst["rigorous"] = max(worst["rigorous"], error)
    for row in rows:
        fresh = model_orders(row["profile"], MATERIALS[row["material"]], row["theta"], perturb)
        for factor in ("scalar", "vector"):
            # Four digits are stored, and nothing below 1e-7.
            error = np.abs(fresh[factor] - row[factor]) / (np.abs(row[factor]) + 2e-4)
            worst[factor] = max(worst[factor], error.max())
    for column, error in worst.items():
        expect(f"cases.csv, {column}", error, 1e-3)


def warning():
    """The rule finds 95 % of the bad cases and names at most 10 % of the good ones, for the factors used by default."""
    rows = read_cases()
    for material, factor in rule.PAIRS[:3]:
        found, bad, false, good, _, _ = rule.confusion(rows, material, factor)["all"]
        expect(f"warning misses, {material}", 1 - found / bad, 0.05)
        expect(f"warning cries wolf, {material}", false / good, 0.1)
    # Something must be there to find, or the lines above say nothing.
    share = np.mean([verdict(r, r["vector"])[1] for r in rows])
    expect("share of bad cases is 21 %", abs(share - 0.21), 0.03)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--perturb", choices=MISTAKES, help="plant a mistake that must be found")
    perturb = parser.parse_args().perturb
    start = time.monotonic()
    for check in (flat_surface, energy, reciprocity, methods_agree, perfect_limit, converged, warning):
        check()
    first_order(perturb)
    blaze_leans(perturb)
    stored_cases(perturb)
    print(f"{time.monotonic() - start:.0f} s; " + (f"{len(failures)} failed: {failures}" if failures else "all good"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
