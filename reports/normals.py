"""Normals at the points of a membrane: those that methods found beside the exact ones.

Drawn of any profile with x, y, the exact normal_x, normal_y and, of each method, METHOD.normal_x and METHOD.normal_y;
METHOD.angle_error_deg and judged (1: the point counts) are used where they are there.
"""

import numpy

import figures
import reproduce
import svg
import text
from figures import Figure, Key

MOST_POINTS = 24  # of a drawing; of more, evenly chosen ones
MOST_RUNS = 4  # of a case that are drawn
_COLUMNS = 2
_SUFFIX = ".normal_x"


def methods(profile):
    """Names of the methods whose normals a profile holds beside the exact ones."""
    if any(name not in profile for name in ("x", "y", "normal_x", "normal_y")):
        return []
    return [name.removesuffix(_SUFFIX) for name in profile if name.endswith(_SUFFIX)]


def drawings(case, results, prefix):
    """Figures, one a run of the case whose profile holds normals: of studies the finest."""
    found = []
    for entry in case.series:
        names = [level.get("file") for level in entry.levels if level.get("file") in results]
        names = [name for name in names if methods(results[name].profile)]
        if names and entry.vary in ("cells", "") and names[-1] not in [name for _, name in found]:
            found.append((entry, names[-1]))
    return [
        needles(results[name].profile, entry.label, name, f"{prefix}-{number}", run=results[name].run)
        for number, (entry, name) in enumerate(found[:MOST_RUNS])
    ]


def needles(profile, label, file, prefix, names=None, run=None):
    """The normals of a run by the methods of these names, by all if none are given."""
    names = names or methods(profile)
    rows = -(-len(names) // _COLUMNS)
    chosen = numpy.unique(numpy.linspace(0, len(profile["x"]) - 1, MOST_POINTS).round().astype(int))
    places = numpy.stack([profile["x"], profile["y"]])[:, chosen]
    low, high = places.min(axis=1), places.max(axis=1)
    length = 0.13 * max((high - low).max(), 1e-30)

    def paint(axes):
        every = numpy.ravel(axes)
        for panel in every[len(names) :]:
            panel.set_visible(False)
        for panel, name in zip(every, names):
            exact = numpy.stack([profile["normal_x"], profile["normal_y"]])[:, chosen]
            computed = numpy.stack([profile[name + _SUFFIX], profile[f"{name}.normal_y"]])[:, chosen]
            panel.plot(*_needles(places, exact, length), color=svg.INK, linewidth=2.6, alpha=0.22)
            panel.plot(*_needles(places, computed, length), color=svg.SERIES[1], linewidth=0.9)
            panel.plot(*places, ".", markersize=2.2, color=svg.INK)
            panel.set_title(f"{name}\n{_worst(profile, name)}", fontsize=8)
            margin = 1.25 * length
            panel.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin), aspect="equal")
            panel.grid(False)
            for axis in (panel.xaxis, panel.yaxis):
                axis.set_major_locator(figures.MaxNLocator(4))
                figures.plain_axis(axis)

    shape = (high[1] - low[1] + 2.5 * length) / (high[0] - low[0] + 2.5 * length)
    worst = text.listing(f"{name} {_worst(profile, name)}".strip() for name in names)
    caption = (
        "At each point the exact normal (broad) and the computed one (narrow), with the largest angle between them over "
        "the points that are judged. Where the narrow needles cover the broad ones, the method is right; x and y in m."
    )
    keys = [Key("exact", "currentColor", band=True), Key("computed", "var(--s2)")]
    drawing = svg.draw(
        paint,
        prefix,
        f"Normals of {label} by method: {worst}",
        height=min(9.5, rows * (2.1 * shape + 0.55)),
        nrows=rows,
        ncols=_COLUMNS,
        sharex=True,
        sharey=True,
        squeeze=False,
    )
    return Figure(drawing, f"Normals, {label}", caption, [file], keys, [command] if (command := reproduce.run(run or {})) else [])


def _needles(places, directions, length):
    """Lines from each place along its direction as one broken line."""
    gap = numpy.full(places.shape[1], numpy.nan)
    return [numpy.stack([x, x + length * n, gap], axis=1).ravel() for x, n in zip(places, directions)]


def _worst(profile, name):
    errors = profile.get(f"{name}.angle_error_deg")
    if errors is None:
        return ""
    judged = profile["judged"] > 0 if "judged" in profile else numpy.ones(len(errors), bool)
    largest = float(numpy.max(errors[judged], initial=0.0))
    return "< 10⁻⁶°" if largest < 1e-6 else f"{text.number(largest, 2)}°"
