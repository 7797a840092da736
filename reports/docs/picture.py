"""The picture of the README, from a folder of results: python3 reports/docs/picture.py RESULTS_DIR OUTPUT.svg

Sod's shock tube by both schemes over the exact solution, and the error of the density against the cell size: two figures of the report's
page of that case. Letters are outlines, so that the picture looks the same everywhere. The same files give the same bytes.
"""

import pathlib
import sys

import matplotlib

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.hashsalt": "plumbline", "font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "path.simplify_threshold": 0.5})

import matplotlib.pyplot as pyplot  # noqa: E402
import numpy  # noqa: E402

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from plumbline import reader  # noqa: E402

SCHEMES = {"default": ("scheme default", "#0069b0", "o"), "york1997": ("scheme york1997", "#c4490a", "s")}
CELLS = 100


def profile(folder, levels):
    """The profile of a study's run at CELLS."""
    (settings,) = (level["settings"] for level in levels if level["settings"]["cells"] == CELLS)
    return next(result.profile for result in folder.runs if result.run["case"] == "sod" and result.run["settings"] == settings and result.profile)


def draw(folder):
    figure, (fields, errors) = pyplot.subplots(1, 2, figsize=(9.2, 3.5), layout="constrained")
    studies = {result.study["id"]: result for result in folder.studies if result.study.get("case") == "sod"}
    for scheme, (label, colour, mark) in SCHEMES.items():
        study = studies[scheme]
        columns = profile(folder, study.study["levels"])
        order = numpy.argsort(columns["x"])
        x, exact, density = (columns[name][order] for name in ("x", "density_reference", "density"))
        if scheme == "default":
            fields.plot(x, exact, color="#1a1e23", linewidth=1, label="exact")
        fields.plot(x, density, mark, color=colour, markersize=2, markeredgewidth=0, label=label)
        h = [level["h"] for level in study.study["levels"]]
        norm = [level["measures"]["density.L1"]["error"] for level in study.study["levels"]]
        fit = study.measures["density.L1"]
        said = f"order {fit['order']:.2f}, {fit['order_low']:.2f} to {fit['order_high']:.2f}" if fit["asymptotic"] else "not asymptotic: no order"
        errors.loglog(h, norm, mark + "-", color=colour, markersize=4, label=f"{scheme}: {said}")
    fields.set(xlabel="x, m", ylabel="density, kg/m³", title=f"Sod's shock tube, {CELLS} cells, t = 0.143 s")
    errors.set(xlabel="cell size h, m", ylabel="L1 error of the density, kg/m³", title="Error and order, with its 95 % interval")
    for axes, place in ((fields, "upper right"), (errors, "lower right")):
        axes.legend(frameon=False, fontsize=8, loc=place)
        axes.grid(color="#e6e8e9", linewidth=0.6)
        axes.set_axisbelow(True)
    return figure


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    draw(reader.load_folder(arguments[0])).savefig(arguments[1], format="svg", metadata={"Date": None, "Creator": None})
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
