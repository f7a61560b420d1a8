"""Front factors of the scalar model against rigorous diffraction orders: the table of figures, and `cases.csv`.

All factors share the power |c_m|^2 of the phase screen exp(i k w h) (c_m: its Fourier coefficient) and differ in what
stands before it. For order m, with w = -(cos_i + cos_m) and G = (1 + wi.wo)^2 / (cos_i cos_m):

- `scalar`: R(half vector) G / w^2, the factor of the tables' model;
- `vector`: 4 cos_i cos_m (Q_ss + Q_pp) / 2 / w^2, first-order vector perturbation (Rayleigh-Rice);
- either one divided by its power sum over the propagating orders, times the flat surface's reflectance R(theta_i);
- `harvey_shack`: |c_m|^2 renormalised in the same way (Krywonos's form of Harvey and Shack's linear system).

These are power fractions already: integrated over an order, f cos_o d omega = f du dv, and the window's power is 1.

    python factors.py              solve all cases (90 seconds), write cases.csv, print the table
    python factors.py --table      print the table from cases.csv
"""

import argparse
import csv
import sys
from pathlib import Path

import numpy as np

from profiles import PROFILES, Profile
from solver import MATERIALS, fresnel, unpolarised

CSV = Path(__file__).with_name("cases.csv")
# In between, so that no order leaves at exactly 90 degrees (where all efficiencies have a kink).
PERIODS = (0.6, 0.8, 1.05, 1.55, 2.1, 3.1, 4.1, 6.1)
DEPTHS = (0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5)
ANGLES = (0.0, 60.0)
COUNTED = 0.03  # orders above this share of R count
COLUMNS = ("profile", "material", "period_over_lambda", "depth_over_lambda", "theta_i_deg", "reflectance",
           "first_order", "rigorous_efficiency", "scalar_efficiency", "vector_efficiency")
FACTORS = ("scalar", "scalar / sum", "vector", "vector / sum", "harvey_shack")


def all_cases():
    """(material, profile, theta_i_deg) of every case, in the order of the file."""
    for material in MATERIALS:
        for kind in PROFILES:
            for period in PERIODS:
                for depth in DEPTHS:
                    for theta in ANGLES:
                        yield material, Profile(kind, period, depth), theta


def propagating(period, theta_i_deg):
    """Numbers of the reflected orders, and the sines they leave at."""
    sine = np.sin(np.radians(theta_i_deg))
    m = np.arange(int(np.ceil(-(1 + sine) * period)), int(np.floor((1 - sine) * period)) + 1)
    return m, sine + m / period


def reflectance(index, theta_i_deg):
    """Of the flat surface, unpolarised."""
    return float(np.mean(fresnel(index, theta_i_deg)))


def model_orders(profile, index, theta_i_deg, perturb=None):
    """Efficiencies by each factor, as a dict of arrays over the propagating orders.

    `perturb` plants a mistake for the checks to find.
    """
    m, sine_o = propagating(profile.period, theta_i_deg)
    sine_i = np.sin(np.radians(theta_i_deg))
    cos_i, cos_o = np.cos(np.radians(theta_i_deg)), np.sqrt(1 - sine_o**2)
    w = -(cos_i + cos_o)
    power = np.abs(profile.phasor(2 * np.pi * w, -m if perturb == "sign-of-u" else m)) ** 2
    scalar = scalar_factor(index, cos_i, cos_o, sine_i, sine_o) / w**2 * power
    vector = vector_factor(index, cos_i, cos_o, sine_i, sine_o, perturb) / w**2 * power
    if perturb == "no-cosine":
        scalar, vector = scalar / cos_o, vector / cos_o
    flat = reflectance(index, theta_i_deg)
    shared = lambda values: flat * values / values.sum()
    return {"scalar": scalar, "scalar / sum": shared(scalar), "vector": vector, "vector / sum": shared(vector),
            "harvey_shack": shared(power)}


def scalar_factor(index, cos_i, cos_o, sine_i, sine_o):
    """R at the half vector, times G. wi points back along -sine_i: wi.wo = cos_i cos_o - sine_i sine_o."""
    dot = cos_i * cos_o - sine_i * sine_o
    half = np.degrees(np.arccos(np.clip(np.sqrt((1 + dot) / 2), 0, 1)))
    r = np.array([reflectance(index, angle) for angle in half])
    return r * (1 + dot) ** 2 / (cos_i * cos_o)


def vector_factor(index, cos_i, cos_o, sine_i, sine_o, perturb=None):
    """4 cos_i cos_o (Q_ss + Q_pp) / 2. In the plane of incidence cos(phi) sin_i sin_o is the product of signed sines,
    and Q_sp = Q_ps = 0."""
    product = sine_i * sine_o if perturb != "sign-of-phi" else -sine_i * sine_o
    if index is None:  # the limit of a large permittivity
        q_ss, q_pp = 1.0, ((1 - product) / (cos_i * cos_o)) ** 2
        return 2 * cos_i * cos_o * (q_ss + q_pp)
    eps = complex(index) ** 2
    a, b = np.sqrt(eps - sine_i**2), np.sqrt(eps - sine_o**2)
    if perturb == "exchange-a-b":
        a, b = b, a
    q_ss = np.abs((eps - 1) / ((cos_i + a) * (cos_o + b))) ** 2
    q_pp = np.abs((eps - 1) * (a * b - eps * product) / ((eps * cos_i + a) * (eps * cos_o + b))) ** 2
    return 2 * cos_i * cos_o * (q_ss + q_pp)


def solve_case(material, profile, theta):
    """One row of the file."""
    index = MATERIALS[material]
    m, _ = propagating(profile.period, theta)
    reflected = unpolarised(profile, index, theta).reflected
    models = model_orders(profile, index, theta)
    return {"material": material, "profile": profile, "theta": theta, "orders": m,
            "reflectance": reflectance(index, theta), "rigorous": np.array([reflected[int(x)] for x in m]),
            "scalar": models["scalar"], "vector": models["vector"]}


def write_cases(rows, path=CSV):
    """One line per case; the efficiencies of its orders (first_order, first_order + 1, ...) are separated by spaces."""
    pack = lambda values: " ".join(_short(v) for v in values)
    with open(path, "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(COLUMNS)
        for row in rows:
            p = row["profile"]
            out.writerow([p.kind, row["material"], p.period, p.depth, f"{row['theta']:g}", f"{row['reflectance']:.5f}",
                          row["orders"][0], pack(row["rigorous"]), pack(row["scalar"]), pack(row["vector"])])


def _short(value):
    """Four significant digits, nothing below 1e-7 of the incident power."""
    return "0" if value < 1e-7 else f"{value:.4g}".replace("e-0", "e-").removeprefix("0") or "0"


def read_cases(path=CSV):
    """The rows of the file, as `solve_case` gives them."""
    rows = []
    unpack = lambda text: np.array([float(v) for v in text.split()])
    with open(path, newline="") as file:
        for line in csv.DictReader(file):
            profile = Profile(line["profile"], float(line["period_over_lambda"]), float(line["depth_over_lambda"]))
            rigorous = unpack(line["rigorous_efficiency"])
            rows.append({"material": line["material"], "profile": profile, "theta": float(line["theta_i_deg"]),
                         "orders": int(line["first_order"]) + np.arange(rigorous.size),
                         "reflectance": float(line["reflectance"]), "rigorous": rigorous,
                         "scalar": unpack(line["scalar_efficiency"]), "vector": unpack(line["vector_efficiency"])})
    return rows


def verdict(row, model):
    """(every counted order within 10 %, some counted order off by two or more, L1 distance over R)."""
    rigorous, flat = row["rigorous"], row["reflectance"]
    counted = rigorous > COUNTED * flat
    ratio = model[counted] / rigorous[counted]
    distance = np.abs(model - rigorous).sum() / flat
    return bool(np.all(np.abs(ratio - 1) <= 0.1)), bool(np.any((ratio >= 2) | (ratio <= 0.5))), float(distance)


def print_table(rows, out=sys.stdout):
    """Share of cases with every order within 10 % / with some order off by two or more / mean L1 of the orders over R."""
    print(f"{'factor':14}" + "".join(f"{name:>22}" for name in MATERIALS), file=out)
    for factor in FACTORS:
        cells = []
        for material in MATERIALS:
            found = [verdict(r, model_orders(r["profile"], MATERIALS[material], r["theta"])[factor])
                     for r in rows if r["material"] == material]
            good, bad, distance = np.mean(np.array(found, dtype=float), axis=0)
            cells.append(f"{good:.2f} / {bad:.2f} / {distance:.2f}")
        print(f"{factor:14}" + "".join(f"{c:>22}" for c in cells), file=out)
    print(f"{len(rows)} cases; orders above {COUNTED:.0%} of the flat surface's reflectance count", file=out)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--table", action="store_true", help="print the table from the stored cases")
    if not parser.parse_args().table:
        rows = []
        for number, case in enumerate(all_cases()):
            rows.append(solve_case(*case))
            if number % 48 == 47:
                print(f"{number + 1} cases", file=sys.stderr, flush=True)
        write_cases(rows)
    print_table(read_cases())


if __name__ == "__main__":
    main()
