"""An independent evaluator: X, Y, Z of scans by the plainest sum over their samples, in numpy.

    python evaluate.py --check [ROWS]      compares with every row (or so many of each file) of the CSV files here
    python evaluate.py --write             makes the CSV files of the cases marked as its own anew

Needs numpy, tifffile and colour-science (PyPI), whose tables of the CIE are not this project's. It shares no code and
no data with the program: no FFT, no kernels, no interpolation, and its own quadrature over the wavelength.

The BRDF of wavelength l, with q = (u, v, w) = -wi - wo, k = 2 pi / l and a window g:

    f = G / (l^2 A w^2) |sum g exp(i k (u x + v y + w h)) dx dy|^2    A = sum g^2 dx dy    G = (1 + wi.wo)^2 / (cos_i cos_o)

`fade`: one Gaussian window in the middle of the scan, cut at its edge. `tile`: the scan repeats without end under that
window. X, Y, Z weigh f by D65 and the 2 degree observer, over the illuminant's own Y.
"""

import argparse
import csv
import os
import pathlib
import sys

# Products of a few hundred rows: threads would only wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

SNAKE_PITCH_NM = (65_000 / 1332,) * 2
HERE = pathlib.Path(__file__).resolve().parent

# Name, scan, pitch in nm along x and y, nm per count, sigma of the window in nm, edge, step of the wavelength in nm, and
# whose figures the rows are: those of an evaluator outside this repository, or this one's.
CASES = [
    ("blazed_2500nm", "blazed_2500nm.tif", (50.0, 50.0), 1.0, 5_000.0, "fade", 1.0, "outside"),
    ("sinusoid_1600nm", "sinusoid_1600nm.tif", (40.0, 80.0), 1.0, 5_000.0, "fade", 1.0, "outside"),
    ("elaphe_guttata_fade", "elaphe_guttata_crop.tif", SNAKE_PITCH_NM, 375 / 65_535, 1_100.0, "fade", 1.0, "own"),
    ("elaphe_guttata_tile", "elaphe_guttata_crop.tif", SNAKE_PITCH_NM, 375 / 65_535, 2_000.0, "tile", 1.0, "own"),
    ("xenopeltis_unicolor_fade", "xenopeltis_unicolor_crop.tif", SNAKE_PITCH_NM, 1.0, 1_100.0, "fade", 1.0, "own"),
]
COLUMNS = ["theta_i_deg", "phi_i_deg", "theta_r_deg", "phi_r_deg", "X", "Y", "Z"]


def weights(step_nm):
    """Wavelengths and what each adds to X, Y and Z: the trapezoid rule over 380 to 780 nm."""
    import colour

    nm = np.arange(380.0, 780.0 + 0.5 * step_nm, step_nm)
    observer = colour.MSDS_CMFS["CIE 1931 2 Degree Standard Observer"]
    light = colour.SDS_ILLUMINANTS["D65"]
    table = light.wavelengths % 5 == 0
    power = np.interp(nm, light.wavelengths[table], light.values[table])
    eye = np.stack([np.interp(nm, observer.wavelengths, observer.values[:, c]) for c in range(3)], axis=1)
    trapezoid = np.full(len(nm), step_nm)
    trapezoid[[0, -1]] *= 0.5
    by_nm = power[:, None] * eye * trapezoid[:, None]
    return nm, by_nm / by_nm[:, 1].sum()


def direction(theta_deg, phi_deg):
    """The unit vector of two angles."""
    theta, phi = np.radians([theta_deg, phi_deg])
    return np.array([np.sin(theta) * np.cos(phi), np.sin(theta) * np.sin(phi), np.cos(theta)])


class Surface:
    """Heights in nm under a window, with places measured from the middle of the scan and y towards row 0."""

    def __init__(self, heights, pitch, sigma, edge):
        rows, columns = heights.shape
        if edge == "tile":
            # Whole scans on every side until the window is below 1e-9.
            more = [int(np.ceil(6.5 * sigma / (n * p))) for n, p in zip((rows, columns), pitch[::-1])]
            heights = np.tile(heights, [2 * n + 1 for n in more])
            rows, columns = heights.shape
        x = (np.arange(columns) - 0.5 * (columns - 1)) * pitch[0]
        y = (0.5 * (rows - 1) - np.arange(rows)) * pitch[1]
        window = [np.exp(-0.5 * (places / sigma) ** 2) for places in (x, y)]
        # What the window leaves nothing of is left out.
        keep = [g > 1e-9 for g in window]
        self.x, self.y = x[keep[0]], y[keep[1]]
        self.window = [window[0][keep[0]], window[1][keep[1]]]
        heights = heights[np.ix_(keep[1], keep[0])]
        # Equal heights need one exponential only: quantised scans and gratings have few.
        self.levels, index = np.unique(heights, return_inverse=True)
        self.index = index.reshape(heights.shape)
        self.cell = pitch[0] * pitch[1]
        self.area = (self.window[0] ** 2).sum() * (self.window[1] ** 2).sum() * self.cell

    def power(self, q, nm):
        """|P|^2 / A of one direction at one wavelength, in nm^2."""
        k = 2 * np.pi / nm
        phasors = np.exp(1j * k * q[2] * self.levels)[self.index]
        along_x = self.window[0] * np.exp(1j * k * q[0] * self.x)
        along_y = self.window[1] * np.exp(1j * k * q[1] * self.y)
        return abs(along_y @ phasors @ along_x * self.cell) ** 2 / self.area

    def xyz(self, wi, wo, nm, by_nm):
        """X, Y and Z in 1/sr."""
        q = -wi - wo
        g = (1 + wi @ wo) ** 2 / (wi[2] * wo[2])
        f = np.array([g / (l * l * q[2] ** 2) * self.power(q, l) for l in nm])
        return f @ by_nm


def surface(case):
    """The surface of a case, from its file here."""
    import tifffile

    _, scan, pitch, scale, sigma, edge, *_ = case
    return Surface(tifffile.imread(HERE / scan).astype(float) * scale, pitch, sigma, edge)


def read(path):
    """Rows of a CSV file, as numbers."""
    with open(path, newline="") as file:
        return [[float(cell) for cell in row] for row in list(csv.reader(file))[1:]]


def check(case, count):
    """Largest deviation of X, Y and Z from the stored rows, in units of their sum."""
    own, worst = surface(case), 0.0
    nm, by_nm = weights(case[6])
    rows = read(HERE / f"{case[0]}.csv")
    for row in rows[:count]:
        found = own.xyz(direction(*row[0:2]), direction(*row[2:4]), nm, by_nm)
        worst = max(worst, np.abs(found - row[4:]).max() / sum(row[4:]))
    print(f"{case[0]}: {len(rows[:count])} rows, worst {worst:.1e}")
    return worst


def drawn(count, seed):
    """Pairs of directions: half all over the hemisphere, half within 25 degrees of the mirror direction."""
    rng = np.random.default_rng(seed)
    for n in range(count):
        theta_i, phi_i = np.degrees(np.arccos(rng.uniform(0.2, 1))), rng.uniform(0, 360)
        if n % 2:
            theta_r = min(abs(theta_i + rng.uniform(-25, 25)), 78.0)
            phi_r = (phi_i + 180 + rng.uniform(-25, 25)) % 360
        else:
            theta_r, phi_r = np.degrees(np.arccos(rng.uniform(0.2, 1))), rng.uniform(0, 360)
        yield [round(float(angle), 4) for angle in (theta_i, phi_i, theta_r, phi_r)]


def write(case, count=32):
    """Rows of a case, by this evaluator."""
    own = surface(case)
    nm, by_nm = weights(case[6])
    with open(HERE / f"{case[0]}.csv", "w", newline="") as file:
        file.write(",".join(COLUMNS) + "\n")
        for angles in drawn(count, 20140623):
            xyz = own.xyz(direction(*angles[:2]), direction(*angles[2:]), nm, by_nm)
            file.write(",".join([f"{a:.4f}" for a in angles] + [f"{value:.9e}" for value in xyz]) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", type=int, nargs="?", const=1_000_000, metavar="ROWS")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    if arguments.write:
        for case in CASES:
            if case[7] == "own":
                write(case)
    if arguments.check:
        worst = [check(case, arguments.check) for case in CASES]
        sys.exit(0 if max(worst) < 1e-4 else 1)


if __name__ == "__main__":
    main()
