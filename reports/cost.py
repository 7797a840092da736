"""Error against cost, from the document of `plumbline bench --cases`: figures of a case, the chart over all cases, the
table which scheme serves which kind of scene, and the surface over cell size and step.

Times are medians of repeated runs on one thread; errors are those of the same runs. Nothing is judged.
"""

import math
import statistics
from dataclasses import dataclass, field

import figures
import stability as stability_page
import svg
import text
from cost_estimates import AT, MORE, MOST, NONE, front, ratio, reach, spread
from figures import Figure, Key, log_axis
from plumbline.reader import COST_FILE

TARGET = 0.01  # relative error that the costs on the front page are read off at
YORK = "york1997"
# A case's own parameters that choose how it is computed, not what: lines that differ in these solve the same problem.
NUMERICAL = frozenset("strain layout membrane_points net_ppc box t_end dimension".split())
MEANINGLESS = 10  # relative errors above this on the finest mesh compare with a value that is zero
_PLAIN = (
    "case", "kind", "scheme", "study", "vary", "value", "cells", "h", "dt", "points", "steps", "point_steps", "source", "finished",
)  # fmt: skip
CSV_COLUMNS = (*_PLAIN, "samples", "wall_median", "wall_least", "wall_most", "measure", "error", "relative_error")


@dataclass
class Line:
    """One scheme on one case, coarse to fine: a list of entries of the document for each level."""

    case: str
    kind: str
    scheme: str
    study: str
    label: str
    levels: list
    same_problem: bool = True
    style: int = 0
    file: str = COST_FILE

    def points(self, measure, price, relative=False):
        """(cost, error or None) of every level."""
        key = "relative_error" if relative else "error"
        return [(price(level), (level["errors"].get(measure) or {}).get(key) or None) for level in self.levels]

    def reach(self, measure, target=TARGET):
        return reach(self.points(measure, wall_time, relative=True), target)


@dataclass
class Compared:
    """What one case says about cost: its lines that solve the same problem, and what each takes to the target."""

    case: object
    kind: str
    measure: str
    lines: list
    york: object = None  # Line
    reaches: dict = field(default_factory=dict)  # by label
    stick: object = None  # Reach of another method

    def ratio(self, line):
        return ratio(self.reaches[line.label], self.reaches[self.york.label]) if self.york else None

    @property
    def cheapest(self):
        """The line that is at the target for the least time, of those known to be there."""
        there = [line for line in self.lines if self.reaches[line.label].kind in (AT, MOST)]
        return min(there, key=lambda line: self.reaches[line.label].cost, default=None)

    def line(self, scheme):
        return next((line for line in self.lines if line.scheme == scheme), None)


def wall_time(level):
    return spread(level["wall_s"])[0]


def point_steps(level):
    return level["point_steps"]


def csv_rows(document):
    """One row for each measure of each run."""
    return [
        [run.get(column) for column in _PLAIN]
        + [len(run["wall_s"]), *spread(run["wall_s"]), measure, error["error"], error["relative_error"]]
        for run in document["runs"]
        for measure, error in run["errors"].items()
    ]


# --- lines ----------------------------------------------------------------------------------------


def lines_of(document, case):
    """The lines of a case: the default scheme first, then York's, then the others in the order of the document."""
    runs = [run for run in document["runs"] if run["case"] == case.name and run["vary"] == "cells"]
    grouped = {}
    for run in runs:
        grouped.setdefault((run["study"], run["scheme"]), []).append(run)
    titles = {entry.get("id"): entry.get("title") for entry in case.catalog.get("studies") or []}
    york = {key for run in runs if run["study"] == run["scheme"] == YORK for key in run["differs"]}
    lines = []
    for (study, scheme), levels in grouped.items():
        levels = sorted(levels, key=lambda level: level["cells"])
        allowed = NUMERICAL | york if scheme == YORK else NUMERICAL
        same = all(set(level["differs"]) <= allowed for level in levels)
        line = Line(case.name, levels[0]["kind"], scheme, study, titles.get(study) or scheme, levels, same)
        if not _merged(line, lines):
            lines.append(line)
    lines.sort(key=lambda line: (line.study != "default", line.scheme != "default", line.scheme != YORK, line.study != YORK))
    _name_apart(lines)
    known = {entry.study: entry.style for entry in case.series if entry.study}
    free = iter(number for number in range(999) if number not in known.values())
    for line in lines:
        line.style = known[line.study] if line.study in known else next(free)
    return lines


def _merged(line, lines):
    """Levels that were added for the sake of cost belong to the line whose runs they repeat."""
    if "/" not in line.study:
        return False
    for other in lines:
        shared = [
            (own, level) for own in line.levels for level in other.levels if own["cells"] == level["cells"]
        ]
        if other.scheme == line.scheme and shared and all(_same_run(*pair) for pair in shared):
            known = {level["cells"] for level in other.levels}
            more = [level for level in line.levels if level["cells"] not in known]
            other.levels = sorted(other.levels + more, key=lambda level: level["cells"])
            return True
    return False


def _same_run(one, other):
    return all(one[key] == other[key] for key in ("points", "steps", "errors"))


def _name_apart(lines):
    seen = set()
    for line in lines:
        if line.label in seen:
            line.label = f"{line.label} · {line.study}"
        seen.add(line.label)


def measure_of(case, lines):
    """The measure that stands for the case, if its relative error means anything; else None."""
    measure = case.measure
    finest = [line.points(measure, wall_time, relative=True)[-1][1] for line in lines if line.study == "default"]
    finest = [error for error in finest or [line.points(measure, wall_time, True)[-1][1] for line in lines] if error]
    return measure if finest and min(finest) < MEANINGLESS else None


def compare(document, cases):
    """A Compared for every case whose runs have an error against a reference."""
    found = []
    for case in cases.values():
        lines = lines_of(document, case)
        measure = measure_of(case, lines) if lines else None
        if not measure:
            continue
        lines = [line for line in lines if line.same_problem]
        compared = Compared(case, lines[0].kind if lines else "", measure, lines)
        compared.york = next((line for line in lines if line.scheme == YORK and line.study in (YORK, f"levels/{YORK}")), None)
        compared.reaches = {line.label: line.reach(measure) for line in lines}
        compared.stick = _stick_reach(case, lines, measure)
        if lines:
            found.append(compared)
    return found


def _stick_reach(case, lines, measure):
    """The time of another method to the target; its errors become relative by the scale of this case's."""
    scales = [
        level["errors"][measure]["error"] / level["errors"][measure]["relative_error"]
        for line in lines
        for level in line.levels
        if (level["errors"].get(measure) or {}).get("relative_error")
    ]
    if not case.comparators or not scales:
        return None
    scale = statistics.median(scales)
    points = case.comparators[0].costs("wall_s", measure)
    return reach([(cost, error / scale) for cost, error in points], TARGET) if points else None


# --- a case ---------------------------------------------------------------------------------------

PRICES = {
    "time": (wall_time, "wall_s", "wall time in s, one thread", "error against wall time"),
    "work": (point_steps, "cell_steps", "particle-steps (points × steps)", "error against particle-steps"),
}


def case_figures(document, case, prefix):
    """Error against wall time and against particle-steps; [] where the document has nothing on the case."""
    lines = lines_of(document, case)
    measure = case.measure
    found = [_case_figure(case, lines, measure, kind, f"{prefix}-{kind}") for kind in PRICES] if lines and measure else []
    return [figure for figure in found if figure]


def _case_figure(case, lines, measure, kind, prefix):
    price, column, axis, title = PRICES[kind]
    rows = []
    for line in lines:
        points = [
            (cost, error, level) for (cost, error), level in zip(line.points(measure, price), line.levels) if error and cost > 0
        ]
        if points:
            rows.append((line, points))
    if not rows:
        return None
    rivals = [(cost, error) for line, points in rows if line.same_problem for cost, error, _ in points]
    best = [rivals[index] for index in front(rivals)]
    sticks = [(entry, entry.costs(column, measure)) for entry in case.comparators]
    sticks = [(entry, points) for entry, points in sticks if points]

    def paint(axes):
        if best:
            axes.plot(*zip(*best), color=svg.INK, linewidth=3.2, alpha=0.16, solid_capstyle="round")
        for line, points in rows:
            _paint_line(axes, line, points, kind)
        for entry, points in sticks:
            axes.plot(
                *zip(*points), svg.series_mark(entry.style), color=svg.series_colour(entry.style), linestyle=(0, (5, 3)),
                linewidth=0.9, label=entry.title,
            )  # fmt: skip
        if best:
            axes.plot(
                *zip(*best), "o", markersize=9, color=svg.INK, markerfacecolor="none", markeredgewidth=0.8, linestyle="none"
            )
        axes.set(xscale="log", yscale="log", xlabel=axis, ylabel=figures.error_label(case, measure))
        costs = [cost for _, points in rows for cost, _, _ in points] + [c for _, points in sticks for c, _ in points]
        errors = [error for _, points in rows for _, error, _ in points] + [e for _, points in sticks for _, e in points]
        axes.set_xlim(min(costs) / 1.8, max(costs) * 1.8)
        axes.set_ylim(min(errors) / 1.8, max(errors) * 1.8)
        log_axis(axes.xaxis, *axes.get_xlim())
        log_axis(axes.yaxis, *axes.get_ylim())

    keys = [
        Key(line.label, f"var(--s{line.style % len(svg.SERIES) + 1})", svg.series_mark(line.style)) for line, _ in rows
    ] + [
        Key(entry.title, f"var(--s{entry.style % len(svg.SERIES) + 1})", svg.series_mark(entry.style), dash=True)
        for entry, _ in sticks
    ]
    return Figure(
        svg.draw(paint, prefix, f"{measure}: {title}", height=2.9),
        title[0].upper() + title[1:],
        _caption(measure, kind, rows, sticks),
        list(dict.fromkeys([COST_FILE] + [entry.file for entry, _ in sticks])),
        keys + [Key("Pareto front", "currentColor", "ring")],
    )


def _paint_line(axes, line, points, kind):
    colour, mark = svg.series_colour(line.style), svg.series_mark(line.style)
    costs, errors = [cost for cost, _, _ in points], [error for _, error, _ in points]
    (drawn,) = axes.plot(
        costs, errors, mark + "-", color=colour, linewidth=0.9, alpha=1.0 if line.same_problem else 0.45, label=line.label
    )
    svg.note(drawn, [f"{level['cells']} cells" for _, _, level in points])
    if kind != "time":
        return
    for cost, error, level in points:
        _, least, most = spread(level["wall_s"])
        if most > least:
            (bar,) = axes.plot([least, most], [error, error], color=colour, linewidth=2.2, alpha=0.45, solid_capstyle="butt")
            svg.belongs(bar, line.label)


def _caption(measure, kind, rows, sticks):
    samples = [len(level["wall_s"]) for _, points in rows for _, _, level in points]
    single = sum(1 for count in samples if count == 1)
    words = ""
    if kind == "time":
        words = f"Medians of up to {max(samples)} interleaved repeats on one thread, bars from the fastest to the slowest" + (
            f"; {single} of {len(samples)} marks {'is' if single == 1 else 'are'} one run only. " if single else ". "
        )
    if any(not line.same_problem for line, _ in rows):
        words += "Pale: another problem, not in the front. "
    if sticks:
        words += (
            f"Broken: another method, {text.listing(entry.title for entry, _ in sticks)}; not judged, and not in the front" + ("." if kind == "time" else "; its work is cells × steps.")
        )
    return words.strip()


# --- all cases ------------------------------------------------------------------------------------


def overview(document, cases, folder_stability=None):
    """What the section on cost shows beside its figures."""
    found = compare(document, cases)
    with_york = [entry for entry in found if entry.york]
    return {
        "found": found,
        "rows": [_time_row(entry) for entry in found],
        "jobs": jobs(found, folder_stability),
        "with_york": len(with_york),
        "without": [entry.case.catalog.get("title") or entry.case.name for entry in found if not entry.york],
        "no_reference": _no_reference(document, cases, found),
        "file": COST_FILE,
        "tier": document.get("tier") or "",
        "samples": _sample_words(document),
        "command": (document.get("provenance") or {}).get("command") or "",
        "machine": (document.get("machine") or {}).get("cpu") or "",
    }


def _no_reference(document, cases, found):
    timed = {run["case"] for run in document["runs"]}
    there = {entry.case.name for entry in found}
    return [case.catalog.get("title") or name for name, case in cases.items() if name in timed - there]


def _sample_words(document):
    runs = document["runs"]
    stored = sum(run["source"] == "stored" for run in runs)
    many = [run for run in runs if len(run["wall_s"]) > 1]
    spreads = [max(run["wall_s"]) / max(min(run["wall_s"]), 1e-12) - 1 for run in many]
    return {
        "runs": len(runs),
        "repeated": len(many),
        "once": len(runs) - len(many) - stored,
        "stored": stored,
        "spread": f"{100 * statistics.median(spreads):.0f}\u202f%" if spreads else "",
    }


def reach_words(found):
    """'0.21 s', '≤ 3 ms', 'never: > 3.3 s', '—'."""
    if found is None or found.kind == NONE:
        return text.MISSING
    words = text.seconds(found.cost)
    return {AT: words, MOST: f"≤ {words}", MORE: f"not by {words}"}[found.kind]


def ratio_words(found):
    if found is None or found.sign == "?":
        return text.MISSING
    return f"{found.sign + ' ' if found.sign else ''}{text.number(found.value, 2)}"


def _time_row(entry):
    default, best = entry.line("default"), entry.cheapest
    reaches = entry.reaches
    return {
        "case": entry.case.name,
        "title": entry.case.catalog.get("title") or entry.case.name,
        "kind": entry.kind,
        "measure": entry.measure,
        "default": reach_words(reaches[default.label] if default else None),
        "york": reach_words(reaches[entry.york.label]) if entry.york else "no such study",
        "york_levels": len(entry.york.levels) if entry.york else 0,
        "ratio": ratio_words(entry.ratio(default)) if default and entry.york else text.MISSING,
        "best": f"{best.label}, {reach_words(reaches[best.label])}" if best else "none reaches it",
        "stick": reach_words(entry.stick),
    }


# --- which scheme for which job -------------------------------------------------------------------

JOBS = {"gas": "gas and shocks", "membrane": "membranes and strings", "solid": "solids, contact", "coupled": "gas in membranes"}
RULE = (
    "For each kind of scene, among the schemes that have a name of their own: the one that is at 1 % relative error in most "
    "cases; of those equal in that, the one with the least geometric mean of time over the cheapest scheme of each case."
)


def jobs(found, stability=None):
    """Rows of the table: every named scheme of every kind of scene, the chosen one first."""
    rows = []
    for kind, job in JOBS.items():
        entries = [entry for entry in found if entry.kind == kind]
        schemes = dict.fromkeys(line.scheme for entry in entries for line in entry.lines)
        ranked = sorted((_standing(entries, scheme) for scheme in schemes), key=lambda standing: standing["rank"])
        nowhere = [one["scheme"] for one in ranked if one["there"] == 0 and one["scheme"].startswith("default+")]
        ranked = [one for one in ranked if one["scheme"] not in nowhere]
        for place, standing in enumerate(ranked):
            chosen = place == 0 and standing["there"] > 0
            rows.append({**standing, "kind": kind, "job": job, "chosen": chosen, "nowhere": nowhere})
    for row in rows:
        row["limit"] = _limit(stability, row)
    return rows


def _standing(entries, scheme):
    """How one scheme stands among all of a kind of scene: in how many cases it is at the target, at what cost."""
    there, tried, factors, against_york, orders, failures = 0, 0, [], [], [], 0
    for entry in entries:
        lines = [line for line in entry.lines if line.scheme == scheme]
        if not lines:
            continue
        tried += 1
        reached = [entry.reaches[line.label] for line in lines if not entry.reaches[line.label].never]
        failures += sum(
            gate.get("verdict") == "XFAIL" and gate.get("scheme") == scheme for gate in entry.case.all_gates
        )
        fits = [
            study.measures.get(entry.measure) or {}
            for study in entry.case.studies("cells")
            if study.scheme == scheme and study.study in [line.study for line in lines]
        ]
        orders += [fit.get("order") for fit in fits if not fit.get("reason")]
        if not reached:
            continue
        there += 1
        own = min(reached, key=lambda found: found.cost)
        factors.append(own.cost / entry.reaches[entry.cheapest.label].cost)
        if entry.york and scheme != YORK:
            against = ratio(own, entry.reaches[entry.york.label])
            if against.sign == "":
                against_york.append(against.value)
    orders = [order for order in orders if order is not None]
    mean = math.exp(statistics.fmean(math.log(factor) for factor in factors)) if factors else math.inf
    return {
        "scheme": scheme,
        "there": there,
        "tried": tried,
        "factor": text.number(mean, 3) if factors else text.MISSING,
        "against_york": text.number(statistics.median(against_york), 2) if against_york else text.MISSING,
        "orders": f"{text.fixed(min(orders))} … {text.fixed(max(orders))}" if orders else text.MISSING,
        "xfails": failures,
        "rank": (-there, mean, scheme),
    }


# The problem of the stability laboratory that is nearest to a kind of scene.
_LABORATORY = {"gas": "gas", "membrane": "membrane", "solid": "contact", "coupled": "coupled"}


def _limit(stability, row):
    """The largest step that the laboratory predicts stable for the scene that is nearest, as it states it."""
    for problem in (stability or {}).get("problems") or []:
        if problem["problem"] != _LABORATORY[row["kind"]]:
            continue
        for entry in problem["configurations"]:
            named = f"{entry.get('scheme')}+{entry.get('integrator')}"
            if row["scheme"] in (entry.get("scheme"), named):
                high = entry["predicted"][0].get("high") if entry["predicted"] else None
                if high is None:
                    return text.MISSING
                smallest = stability_page.smallest_in_words(entry.get("smallest_known"))
                words = f"{text.number(high, 3)} {entry.get('unit') or ''} on {problem['problem']}"
                return f"{words}; {smallest}" if smallest else words
    return text.MISSING
