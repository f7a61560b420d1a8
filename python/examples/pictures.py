"""Runs docs/python.md and draws its pictures.

    python3 python/examples/pictures.py [ATLAS]

Each block of Python on that page is run as it stands, in order; what a block has drawn is written to the picture that is shown after it. ATLAS stands in place of
out/atlas/bundled. Wants matplotlib.
"""

import re
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

PAGE = Path(__file__).resolve().parents[2] / "docs" / "python.md"
PARTS = re.compile(r"```python\n(.*?)```|!\[[^\]]*\]\(([^)]+)\)", re.S)


def main(atlas: str | None) -> None:
    """Runs the page; pictures lie beside it."""
    names: dict = {}
    plt.rcParams.update({"figure.figsize": (5, 3.4), "figure.dpi": 90, "font.size": 9, "svg.hashsalt": ""})
    for code, picture in PARTS.findall(PAGE.read_text(encoding="utf-8")):
        if code:
            exec(compile(code.replace("out/atlas/bundled", atlas or "out/atlas/bundled"), str(PAGE), "exec"), names)
        else:
            # Without a version in it the file stays the same from one matplotlib to the next.
            plt.tight_layout()
            plt.savefig(PAGE.parent / picture, metadata={"Software": None})
            plt.close()
            print(PAGE.parent / picture)


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else None)
