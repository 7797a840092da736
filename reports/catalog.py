"""The catalog as a grid: of each case a small picture, its verdict and one number, by the physics of its scene."""

import numpy

import compact
import frame
import profiles
import tables
import text
from cases import URGENCY, error_of

KINDS = {
    "gas": "Gases",
    "solid": "Solids",
    "membrane": "Membranes",
    "coupled": "Membranes in gases",
    "trials": "Stability limits, single stages of the step, references",
    "": "Other cases",
}
WIDE, HIGH = 160, 80  # of a thumbnail
_BINS = 40
_MOST_LINES = 3  # of refinements in one thumbnail
_MOST_MARGINS = 24


def grid(folder, cases, pages):
    """[{title, cards}] of the kinds of scene that have cases; `pages`: what the pages of the cases show."""
    kinds = {entry["name"]: entry.get("kind") or "" for entry in folder.listed.get("cases") or ()}
    results = {result.name: result for result in folder.runs}
    shown = {page["name"]: page for page in pages}
    groups = {}
    for name, case in cases.items():
        kind = kinds.get(name, "")
        groups.setdefault(kind if kind in KINDS else "", []).append(card(case, results, shown[name]))
    return [{"title": title, "cards": groups[kind]} for kind, title in KINDS.items() if kind in groups]


def card(case, results, page):
    return {
        "name": case.name,
        "anchor": page["anchor"],
        "title": page["title"],
        "verdict": case.verdict,
        "counts": tables.counts_row(case),
        "number": number(case),
        "picture": next((group["strip"].cells[-1]["picture"] for group in page["pictures"]), ""),
        "thumbnail": frame.markup(thumbnail(case, results)),
    }


def number(case):
    """The error, or the value where there is none, that the first line has on its finest mesh in the measure that stands for the case."""
    for entry in case.series:
        for level in reversed(entry.levels):
            measured = (level.get("measures") or {}).get(case.measure) or {}
            kind = "error" if error_of(measured) is not None else "value"
            if measured.get(kind) is None:
                continue
            unit = measured.get("unit") or ""
            cells = (level.get("settings") or {}).get("cells")
            return {
                "words": f"error of {case.measure}" if kind == "error" else case.measure,
                "value": text.number(measured[kind]) + (f" {text.unit(unit)}" if unit not in ("", "1") else ""),
                "where": f"{entry.label}, {text.count(cells)} cells" if isinstance(cells, (int, float)) else entry.label,
            }
    return None


def thumbnail(case, results):
    """A drawing without words: the finest profile over the exact solution, else errors over cell size, else margins of the gates."""
    return _profile(case, results) or _refinement(case) or _margins(case)


def _profile(case, results):
    wanted = (case.measure or "").split(".")[0]
    for entry in case.series:
        for level in reversed(entry.levels):
            columns = results[level["file"]].profile if level.get("file") in results else {}
            names = profiles.fields(columns)
            if not names or columns.abscissa not in columns:
                continue
            name = wanted if wanted in names else names[0]
            curves = [profiles.envelope(columns[columns.abscissa], columns[field], _BINS) for field in (name + profiles.REFERENCE, name)]
            return _drawing(curves, ("exact", "computed"))
    return ""


def _refinement(case):
    curves = []
    for entry in case.series:
        found = [(level.get("h"), error) for level, error in entry.errors(case.measure) if level.get("h") and error > 0]
        if len(found) > 1:
            curves.append(numpy.log(numpy.array(found).T))
    return _drawing(curves[:_MOST_LINES], ("computed", "second", "third")) if curves else ""


def _margins(case):
    """A bar for each gate, the nearest to its bound first."""
    margins = sorted(min(abs(gate["margin"]), 1.0) for gate in case.all_gates if gate.get("margin") is not None)
    if not margins:
        return ""
    margins = [margins[round(place)] for place in numpy.linspace(0, len(margins) - 1, min(len(margins), _MOST_MARGINS))]
    step = WIDE / len(margins)
    bars = "".join(f"M{compact.number((k + 0.5) * step)} {HIGH}v-{compact.number(max(2, 0.9 * HIGH * value))}" for k, value in enumerate(margins))
    return f'<svg class="thumb" viewBox="0 0 {WIDE} {HIGH}" aria-hidden="true"><path class="bars" d="{bars}" style="stroke-width:{compact.number(0.6 * step)}"/></svg>'


def _drawing(curves, looks):
    x, y = (numpy.concatenate([curve[axis] for curve in curves]) for axis in (0, 1))
    x, y = x[numpy.isfinite(x)], y[numpy.isfinite(y)]
    if not len(x) or not len(y):
        return ""

    def placed(values, low, high, size):
        return 4 + (size - 8) * ((values - low) / (high - low) if high > low else numpy.full(len(values), 0.5))

    paths = ""
    for (across, up), look in zip(curves, looks):
        across, up = numpy.asarray(across), numpy.asarray(up)
        finite = numpy.isfinite(across) & numpy.isfinite(up)
        places = zip(placed(across[finite], x.min(), x.max(), WIDE), HIGH - placed(up[finite], y.min(), y.max(), HIGH))
        commands = [("M" if number == 0 else "L", place) for number, place in enumerate(places)]
        paths += f'<path class="{look}" d="{compact.path_data(commands)}"/>' if commands else ""
    return f'<svg class="thumb" viewBox="0 0 {WIDE} {HIGH}" aria-hidden="true">{paths}</svg>'


def verdicts(cases):
    """The verdicts that any case has, the most urgent first."""
    return [name for name in URGENCY if any(case.counts[name] for case in cases.values())]
