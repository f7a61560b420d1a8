"""Draws where the scalar model ends: period by depth, for each profile, material, angle and front factor.

    python validity_map.py         writes docs/accuracy/validity_map.png from cases.csv (needs matplotlib)

The line encloses the gratings that the warning of `rule.py` names.
"""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import ListedColormap
from matplotlib.patches import Patch

from factors import ANGLES, DEPTHS, PERIODS, PROFILES, read_cases, verdict
from rule import grating_scan, warns

OUT = Path(__file__).parents[2] / "docs" / "accuracy" / "validity_map.png"
# Told apart in greys and by readers who confuse red and green.
COLOURS = ("#2c7fb8", "#c7e3ee", "#e8743b")
WORDS = ("every order within 10 %", "within a factor of 2", "some order off by 2 or more")
ROWS = (("dielectric", "scalar"), ("dielectric", "vector"), ("aluminium", "scalar"), ("aluminium", "vector"),
        ("conductor", "scalar"), ("conductor", "vector"))
NAMES = {"dielectric": "n = 1.56", "aluminium": "aluminium", "conductor": "perfect cond.",
         "scalar": "R G", "vector": "vector factor"}


def grids(rows, material, factor, kind, theta):
    """Verdict (0, 1, 2) and warning per depth (rows) and period (columns)."""
    outcome = np.full((len(DEPTHS), len(PERIODS)), np.nan)
    warned = np.zeros(outcome.shape, dtype=bool)
    for row in rows:
        profile = row["profile"]
        if (row["material"], profile.kind, row["theta"]) != (material, kind, theta):
            continue
        place = DEPTHS.index(profile.depth), PERIODS.index(profile.period)
        good, bad, _ = verdict(row, row[factor])
        outcome[place] = 2 if bad else 0 if good else 1
        warned[place] = warns(*grating_scan(profile), material != "dielectric", factor, theta)
    return outcome, warned


def outline(axes, inside):
    """Lines between cells that are inside and their neighbours that are not."""
    style = {"color": "black", "linewidth": 1.3, "solid_capstyle": "butt"}
    for r, c in zip(*np.nonzero(inside[:, 1:] != inside[:, :-1])):
        axes.plot([c + 0.5, c + 0.5], [r - 0.5, r + 0.5], **style)
    for r, c in zip(*np.nonzero(inside[1:] != inside[:-1])):
        axes.plot([c - 0.5, c + 0.5], [r + 0.5, r + 0.5], **style)


def draw(rows):
    """The whole figure."""
    columns = [(kind, theta) for kind in PROFILES for theta in ANGLES]
    figure, panels = plt.subplots(len(ROWS), len(columns), figsize=(11, 10.6), sharex=True, sharey=True)
    for line, (material, factor) in zip(panels, ROWS):
        for axes, (kind, theta) in zip(line, columns):
            outcome, warned = grids(rows, material, factor, kind, theta)
            axes.imshow(outcome, cmap=ListedColormap(COLOURS), vmin=0, vmax=2, origin="lower", aspect="auto")
            outline(axes, warned)
            axes.set_xticks(range(len(PERIODS)), [f"{p:g}" for p in PERIODS], fontsize=7, rotation=90)
            axes.set_yticks(range(len(DEPTHS)), [f"{d:g}" for d in DEPTHS], fontsize=7)
        line[0].set_ylabel(f"{NAMES[material]}, {NAMES[factor]}\ndepth / λ", fontsize=8)
    for axes, (kind, theta) in zip(panels[0], columns):
        axes.set_title(f"{kind}, {theta:g}°", fontsize=9)
    for axes in panels[-1]:
        axes.set_xlabel("period / λ", fontsize=8)
    keys = [Patch(color=c, label=w) for c, w in zip(COLOURS, WORDS)]
    keys.append(plt.Line2D([], [], color="black", label="the warning's limit (it warns above)"))
    figure.legend(handles=keys, loc="lower center", ncols=4, fontsize=9, frameon=False)
    figure.tight_layout(rect=(0, 0.03, 1, 1))
    return figure


def main():
    OUT.parent.mkdir(parents=True, exist_ok=True)
    draw(read_cases()).savefig(OUT, dpi=100)
    print(OUT.name, OUT.stat().st_size, "bytes")


if __name__ == "__main__":
    main()
