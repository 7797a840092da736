"""The result of a case at one look: every scheme over the exact solution, one figure a field, all on one mesh where they can be.

Lines are compared that solve the same problem: their exact solutions are the same curve.
"""

from dataclasses import dataclass

import numpy

import profiles
import reproduce
import svg
import text
from figures import Figure, Key

MOST_LINES = 7  # of one figure, beside the exact solution; the rest are in further figures
MOST_FIELDS = 6
_SAME = 0.02  # of the range of a field, by which two exact solutions may differ in the places compared
_PLACES = 64
FIRST = ("default", "york1997")


@dataclass
class Solution(Figure):
    lines: str = ""  # that are drawn


def figures_of(case, results, prefix):
    """[[figure of a field]]: all lines of a case in groups, those of the first problem and its first lines first; the first
    figure of each group has the legend."""
    drawn = []
    for number, lines in enumerate(groups(case, results)):
        fields = list(dict.fromkeys(name for _, _, columns in lines for name in profiles.fields(columns)))
        leading = (case.measure or "").split(".")[0]
        fields = sorted(fields, key=lambda name: name != leading)[:MOST_FIELDS]
        drawn.append([_figure(lines, name, f"{prefix}-{number}-{name}", place == 0) for place, name in enumerate(fields)])
    return drawn


def groups(case, results):
    """[[(series, level, profile)]]: at most MOST_LINES of one problem each, on the finest mesh that the first lines share."""
    problems = []  # [lines of one problem]
    for entry in _chosen_first(case.series):
        levels = _levels(entry, results)
        if not levels:
            continue
        same = next((lines for lines in problems if _same_problem(levels[-1][1], lines[0][1][-1][1])), None)
        if same is None:
            problems.append([(entry, levels)])
        else:
            same.append((entry, levels))
    found = []
    for lines in problems:
        most = _common_mesh([levels for _, levels in lines[: len(FIRST)]])
        lines = [(entry, *_level(levels, most)) for entry, levels in lines]
        found += [lines[start : start + MOST_LINES] for start in range(0, len(lines), MOST_LINES)]
    return found


def _chosen_first(series):
    """Lines of refinements and single runs: one of the default scheme, one of York's, then other refinements, then the rest."""
    lines = [entry for entry in series if entry.vary in ("cells", "")]
    first = [next((entry for entry in lines if entry.scheme == scheme), None) for scheme in FIRST]
    return sorted(lines, key=lambda entry: (first.index(entry) if entry in first else len(FIRST), not entry.refined))


def _levels(entry, results):
    """[(level, profile)] of a line, coarse to fine."""
    found = [(level, results[level["file"]].profile) for level in entry.levels if level.get("file") in results]
    return [(level, columns) for level, columns in found if profiles.fields(columns) and columns.abscissa in columns]


def _common_mesh(lines):
    """Cells of the finest mesh that all these lines have; none where there is no such mesh."""
    common = set.intersection(*({_cells(level) for level, _ in levels} for levels in lines)) - {None}
    return max(common, default=None)


def _level(levels, most):
    """The finest level of at most so many cells, else the coarsest."""
    return next((pair for pair in reversed(levels) if most is None or (_cells(pair[0]) or 0) <= most), levels[0])


def _cells(level):
    return (level.get("settings") or {}).get("cells")


def _same_problem(one, other):
    names = profiles.fields(one)
    if names != profiles.fields(other) or one.abscissa != other.abscissa:
        return False
    low, high = _range(one)
    if not numpy.allclose((low, high), _range(other), rtol=0, atol=0.1 * (high - low)):
        return False
    at = numpy.linspace(low, high, _PLACES + 2)[1:-1]
    for name in names:
        first, second = (_exact(columns, name, at) for columns in (one, other))
        # Beside a jump the places of the points differ, and with them what lies between two of them.
        if numpy.median(numpy.abs(first - second)) > _SAME * (numpy.ptp(first) or abs(first).max() or 1):
            return False
    return True


def _range(columns):
    return numpy.nanmin(columns[columns.abscissa]), numpy.nanmax(columns[columns.abscissa])


def _exact(columns, name, at):
    x, y = columns[columns.abscissa], columns[name + profiles.REFERENCE]
    finite = numpy.isfinite(x) & numpy.isfinite(y)
    order = numpy.argsort(x[finite], kind="stable")
    return numpy.interp(at, x[finite][order], y[finite][order])


def _figure(lines, name, prefix, with_keys):
    lines = [(entry, level, columns) for entry, level, columns in lines if name + profiles.REFERENCE in columns]
    finest = max(lines, key=lambda line: len(line[2][name]))[2]
    field = profiles.column_label(finest, name)
    limits, beyond = profiles.window([columns for _, _, columns in lines], name)

    def paint(axes):
        x, y = profiles.envelope(finest[finest.abscissa], finest[name + profiles.REFERENCE])
        axes.plot(x, y, color=svg.INK, linewidth=3.4, alpha=0.22, solid_capstyle="round", label="exact")
        for entry, _, columns in reversed(lines):
            x, y = profiles.envelope(columns[columns.abscissa], columns[name])
            axes.plot(x, y, color=svg.series_colour(entry.style), linewidth=1.1, label=entry.label, dashes=_dashes(entry, lines))
        axes.set(xlabel=profiles.axis_label(finest, finest.abscissa), ylabel=profiles.axis_label(finest, name))
        if limits:
            axes.set_ylim(limits)
        for axis in (axes.xaxis, axes.yaxis):
            profiles.few_ticks(axis)

    keys = [Key("exact", "currentColor", band=True)]
    keys += [Key(entry.label, f"var(--s{entry.style % len(svg.SERIES) + 1})", dash=_dashes(entry, lines) != (None, None)) for entry, _, _ in lines]
    sizes = [_cells(level) for _, level, _ in lines]
    where = f", {text.count(sizes[0])} cells" if isinstance(sizes[0], (int, float)) else ""
    drawing = svg.draw(paint, prefix, f"{field} of {text.listing(entry.label for entry, _, _ in lines)} over the exact solution{where}", height=2.2)
    others = [f"{entry.label} with {text.count(cells)}" for (entry, _, _), cells in zip(lines, sizes) if cells != sizes[0] and isinstance(cells, (int, float))]
    caption = f"Other numbers of cells: {text.listing(others)}." if others else ""
    caption = " ".join(words for words in (caption if with_keys else "", beyond) if words)
    files = [level.get("file") for _, level, _ in lines]
    names = text.listing(entry.label for entry, _, _ in lines)
    commands = [command for _, level, _ in lines if (command := reproduce.run(level))]
    return Solution(drawing, f"{field[0].upper() + field[1:]}{where}", caption, files, keys if with_keys else [], commands, lines=names)


def _dashes(entry, lines):
    """Broken where an earlier line has the same colour."""
    before = [other for other, _, _ in lines[: [other for other, _, _ in lines].index(entry)]]
    return (4, 1.5) if any(other.style % len(svg.SERIES) == entry.style % len(svg.SERIES) for other in before) else (None, None)
