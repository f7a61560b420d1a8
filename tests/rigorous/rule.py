"""Which height scans the model should not be trusted on: the warning's rule, and how often it is right.

The rule takes two figures from a height scan, both at the scale of the wavelength and therefore nearly independent of
the scan's pitch, vertical walls included:

- `slope`: root mean square slope over a quarter wavelength, sqrt(D_x(L) + D_y(L)) / L with L = lambda / 4 and D_x(L)
  the mean of (h(x + L, y) - h(x, y))^2, the structure function;
- `walls`: share of points where the height changes by more than lambda / 10 within lambda / 10, along x or y.

    python rule.py                 confusion figures on cases.csv, per material and profile
    python rule.py --held-out      the same on gratings and angles that the thresholds were not chosen on (two minutes)
"""

import argparse

import numpy as np

from factors import PROFILES, Profile, model_orders, read_cases, reflectance, verdict
from solver import MATERIALS, unpolarised

SLOPE_LENGTH = 0.25  # of the wavelength
WALL_LENGTH = 0.1
WALL_HEIGHT = 0.1
WALL_SHARE = 0.01
OBLIQUE_DEG = 45.0  # walls count for light more oblique than this
# Slope above which some order is off by two or more, by (conducts, factor).
SLOPE_LIMIT = {(True, "scalar"): 0.25, (True, "vector"): 0.25, (False, "scalar"): 0.30, (False, "vector"): 0.40}
TRUST_SLOPE = 0.10  # below it, orders are within 10 %
# The factor that is used by default: the perfect conductor ("ideal") has no permittivity and keeps R G.
PAIRS = (("aluminium", "vector"), ("conductor", "scalar"), ("dielectric", "vector"), ("aluminium", "scalar"),
         ("conductor", "vector"), ("dielectric", "scalar"))


def structure_function(heights, pitch, length, axis, tiled):
    """Mean of (h(x + length) - h(x))^2 along an axis, and the length it holds for.

    Between whole steps it is interpolated linearly: for vertical walls it is linear in the length. A scan coarser than
    `length` answers for its own pitch.
    """
    steps = max(length / pitch, 1.0)
    low = int(np.floor(steps))
    share = steps - low

    def at(lag):
        if lag >= heights.shape[axis]:
            return 0.0
        return float(np.mean(_differences(heights, lag, axis, tiled) ** 2))

    value = at(low) if share == 0 else (1 - share) * at(low) + share * at(low + 1)
    return value, steps * pitch


def _differences(heights, lag, axis, tiled):
    moved = np.roll(heights, -lag, axis) - heights
    if tiled:
        return moved
    return np.take(moved, np.arange(heights.shape[axis] - lag), axis)


def slope(heights, pitch, wavelength=1.0, tiled=True):
    """The rule's slope of a scan (rows along y); pitch = (along x, along y), in the unit of heights and wavelength."""
    total = 0.0
    for axis, step in ((1, pitch[0]), (0, pitch[1])):
        value, length = structure_function(heights, step, SLOPE_LENGTH * wavelength, axis, tiled)
        total += value / length**2
    return float(np.sqrt(total))


def walls(heights, pitch, wavelength=1.0, tiled=True):
    """The rule's share of points at walls: the larger one of the two axes."""
    shares = []
    for axis, step in ((1, pitch[0]), (0, pitch[1])):
        lag = max(1, round(WALL_LENGTH * wavelength / step))
        if lag < heights.shape[axis]:
            jumps = np.abs(_differences(heights, lag, axis, tiled)) > WALL_HEIGHT * wavelength
            # A wall is seen from as many points as the lag has steps, so the share grows with the lag's true length.
            shares.append(float(np.mean(jumps)) * WALL_LENGTH * wavelength / (lag * step))
    return max(shares, default=0.0)


def warns(heights, pitch, conducts, factor, theta_i_deg, wavelength=1.0, tiled=True):
    """Whether some order is to be expected off by two or more."""
    if slope(heights, pitch, wavelength, tiled) > SLOPE_LIMIT[conducts, factor]:
        return True
    oblique = conducts and abs(theta_i_deg) > OBLIQUE_DEG
    return oblique and walls(heights, pitch, wavelength, tiled) > WALL_SHARE


def grating_scan(profile, per_wavelength=40):
    """One period of a grating as a scan of one row, and its pitch."""
    count = int(round(profile.period * per_wavelength))
    x = (np.arange(count) + 0.5) / count * profile.period
    return profile.height(x)[None, :], (profile.period / count,) * 2


def confusion(rows, material, factor, per_wavelength=40):
    """[found, off by two, false alarms, good, warned between, between] by profile and in all."""
    table = {name: np.zeros(6, dtype=int) for name in (*PROFILES, "all")}
    for row in rows:
        if row["material"] != material:
            continue
        heights, pitch = grating_scan(row["profile"], per_wavelength)
        warned = warns(heights, pitch, material != "dielectric", factor, row["theta"])
        good, bad, _ = verdict(row, row[factor])
        place = 0 if bad else 2 if good else 4
        for name in (row["profile"].kind, "all"):
            table[name][place] += warned
            table[name][place + 1] += 1
    return table


def print_confusion(rows, per_wavelength=40):
    """Found of those off by two / false alarms of those within 10 % / warned of those in between."""
    for material, factor in PAIRS:
        print(f"{material}, {factor} factor")
        for name, c in confusion(rows, material, factor, per_wavelength).items():
            print(f"  {name:9} finds {c[0]:3}/{c[1]:<3} false {c[2]:3}/{c[3]:<3} in between {c[4]:3}/{c[5]:<3}")


def print_trust(rows):
    """How many cases below the slope of trust have every order within 10 %."""
    for material, factor in PAIRS:
        low = [verdict(r, r[factor])[0] for r in rows
               if r["material"] == material and slope(*grating_scan(r["profile"])) < TRUST_SLOPE]
        print(f"{material}, {factor} factor: slope below {TRUST_SLOPE}: {sum(low)} of {len(low)} within 10 %")


def held_out_cases():
    """Other periods, depths and angles; lamellar gratings of other duty; blazes lit from the steep side."""
    rows = []
    for material, index in MATERIALS.items():
        for period in (0.7, 0.9, 1.3, 1.85, 2.6, 3.6, 5.2):
            for depth in (0.03, 0.08, 0.12, 0.17, 0.25, 0.35, 0.45):
                profiles = [Profile(kind, period, depth) for kind in PROFILES[:2]]
                profiles += [Profile("lamellar", period, depth, groove) for groove in (0.25, 0.7)]
                for profile in profiles:
                    for theta in (10.0, 45.5, 75.0, -40.0, -65.0):
                        if theta > 0 or profile.kind == "blaze":
                            rows.append(_row(material, index, profile, theta))
    return rows


def _row(material, index, profile, theta):
    reflected = unpolarised(profile, index, theta).reflected
    models = model_orders(profile, index, theta)
    return {"material": material, "profile": profile, "theta": theta, "reflectance": reflectance(index, theta),
            "rigorous": np.array([reflected[m] for m in sorted(reflected)]), "scalar": models["scalar"],
            "vector": models["vector"]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--held-out", action="store_true", help="judge the rule on other gratings and angles")
    parser.add_argument("--per-wavelength", type=float, default=40, help="samples of the scan per wavelength")
    options = parser.parse_args()
    rows = held_out_cases() if options.held_out else read_cases()
    print_confusion(rows, options.per_wavelength)
    print_trust(rows)


if __name__ == "__main__":
    main()
