"""The picture of the README, from result files: python3 reports/docs/picture.py RESULTS_DIR OUTPUT.svg

Sod's shock tube by both schemes over the exact solution, and the L1 error of the density against the cell size. No text of the figure is
an image of letters: they are outlines, so that the picture looks the same everywhere. The same files give the same bytes.
"""

import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import matplotlib  # noqa: E402
import plumbline_results  # noqa: E402

matplotlib.use("svg")
import matplotlib.pyplot as pyplot  # noqa: E402

SCHEMES = (("default", "#0069b0", "o"), ("york1997", "#c4490a", "s"))
CELLS = 100


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    folder = plumbline_results.read_folder(arguments[0])
    draw(folder, arguments[1])
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
