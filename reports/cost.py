"""Error against cost, from the document of `plumbline bench --cases`: figures of a case, the chart over all cases, the
table which scheme serves which kind of scene, and the surface over cell size and step.

Times are medians of repeated runs on one thread; errors are those of the same runs. Nothing is judged.
"""

import itertools
import math
import statistics
from dataclasses import dataclass, field

import figures
import reproduce
import stability as stability_page
import svg
import text
from cost_estimates import AT, MORE, MOST, NONE, Ratio, front, ratio, reach, spread
from figures import Figure, Key, log_axis
from plumbline.reader import COST_FILE

TARGET = 0.01  # relative error that the costs on the front page are read off at
YORK = "york1997"
LEAST_PROBLEMS = 2  # that a recommended scheme must have been compared on
MEANINGLESS = 10  # relative errors above this on the finest mesh compare with a value that is zero
_PLAIN = (
    "case", "kind", "scheme", "study", "vary", "value", "cells", "h", "dt", "points", "steps", "particle_steps", "source", "finished",
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
    problem: tuple = ()  # (key, value) of those keys that decide the problem and differ from the case's own values
    same_problem: bool = True  # as the study `default` of the case
    plain: bool = True  # made with the scheme's own choices
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
    """What one problem of a case says about cost: the lines that solve it, and what each takes to the target."""

    case: object
    kind: str
    measure: str
    lines: list
    problem: str = ""  # in what it differs from that of the study `default`
    york: object = None  # Line
    reaches: dict = field(default_factory=dict)  # by label
    comparator: object = None  # Reach of another method

    def ratio(self, line):
        return ratio(self.reaches[line.label], self.reaches[self.york.label]) if self.york else None

    @property
    def cheapest(self):
        """The line that is at the target for the least time, of those known to be there."""
        there = [line for line in self.lines if self.reaches[line.label].kind in (AT, MOST)]
        return min(there, key=lambda line: self.reaches[line.label].cost, default=None)

    @property
    def name(self):
        return f"{self.case.name}, {self.problem}" if self.problem else self.case.name

    @property
    def title(self):
        title = self.case.catalog.get("title") or self.case.name
        return f"{title}, {self.problem}" if self.problem else title

    def line(self, scheme):
        return next((line for line in self.lines if line.scheme == scheme), None)

    def schemes(self):
        """{scheme: line} of those run with their own choices; of several lines the one of most levels."""
        found = {}
        for line in self.lines:
            if line.plain and len(line.levels) > len(found[line.scheme].levels if line.scheme in found else ()):
                found[line.scheme] = line
        return found

    def at_equal_error(self, own, other, of_own=None, of_other=None):
        """The time of one line over that of another at the smallest error that both come to."""
        lines = (own, of_own or wall_time), (other, of_other or wall_time)
        points = [line.points(self.measure, price, relative=True) for line, price in lines]
        finest = [levels[-1][1] for levels in points]
        if None in finest:
            return Ratio()
        return ratio(*(reach(levels, max(finest)) for levels in points))

    def outcome(self, own, other):
        """1 where a line certainly needs less time at equal error than another, by all repeats, -1 where more, else 0."""
        return int(self._is_certainly_less(own, other)) - int(self._is_certainly_less(other, own))

    def _is_certainly_less(self, own, other):
        found = self.at_equal_error(own, other, slowest, fastest)
        return found.sign in ("", "<") and found.value < 1


def wall_time(level):
    return spread(level["wall_s"])[0]


def fastest(level):
    return min(level["wall_s"])


def slowest(level):
    return max(level["wall_s"])


def particle_steps(level):
    return level["particle_steps"]


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
    numerical = numerical_keys(case)
    lines = []
    for (study, scheme), levels in grouped.items():
        levels = sorted(levels, key=lambda level: level["cells"])
        line = Line(case.name, levels[0]["kind"], scheme, study, titles.get(study) or scheme, levels)
        line.problem = tuple(sorted((key, value) for key, value in levels[0]["differs"].items() if key not in numerical))
        line.plain = _is_plain(line, numerical)
        if not _merged(line, lines):
            lines.append(line)
    leading = next((line.problem for line in lines if line.study == "default"), lines[0].problem if lines else ())
    for line in lines:
        line.same_problem = line.problem == leading
    lines.sort(key=lambda line: (line.study != "default", line.scheme != "default", line.scheme != YORK, line.study != YORK))
    _name_apart(lines)
    known = {entry.study: entry.style for entry in case.series if entry.study}
    free = iter(number for number in range(999) if number not in known.values())
    for line in lines:
        line.style = known[line.study] if line.study in known else next(free)
    return lines


def numerical_keys(case):
    """The keys of a case that its text calls numerical: lines that differ in others solve different problems."""
    return {entry.get("key") for entry in case.catalog.get("parameters") or [] if entry.get("numerical")}


def _is_plain(line, numerical):
    """Whether nothing but the problem and the integrator in the scheme's name differs from the scheme; by the study's name in
    documents that do not list the choices."""
    choices = line.levels[0].get("choices")
    if choices is None or line.study.startswith("integrator/"):
        return line.study in (line.scheme, f"levels/{line.scheme}") or line.study.startswith("integrator/")
    return not set(choices) & numerical - ({"integrator"} if "+" in line.scheme else set())


def _merged(line, lines):
    """Levels that were added for the sake of cost belong to the line whose runs they repeat."""
    if "/" not in line.study:
        return False
    for other in lines:
        shared = [
            (own, level) for own in line.levels for level in other.levels if own["cells"] == level["cells"]
        ]
        if (other.scheme, other.problem) == (line.scheme, line.problem) and shared and all(_same_run(*pair) for pair in shared):
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
    """A Compared for every case whose runs have an error against a reference, and for each other problem of it that two schemes
    solve."""
    found = []
    for case in cases.values():
        lines = lines_of(document, case)
        measure = measure_of(case, lines) if lines else None
        if not measure:
            continue
        by_problem = {}
        for line in lines:
            by_problem.setdefault(line.problem, []).append(line)
        leading = next(line.problem for line in lines if line.same_problem)
        for problem, own in by_problem.items():
            if problem == leading or len({line.scheme for line in own}) > 1:
                found.append(_compared(case, measure, own, "" if problem == leading else _problem_words(case, problem, leading)))
    return found


def _compared(case, measure, lines, problem):
    compared = Compared(case, lines[0].kind, measure, lines, problem)
    york = [line for line in lines if line.scheme == YORK and line.plain]
    compared.york = max(york, key=lambda line: len(line.levels), default=None)
    compared.reaches = {line.label: line.reach(measure) for line in lines}
    compared.comparator = None if problem else _comparator_reach(case, lines, measure)
    return compared


def _problem_words(case, problem, leading):
    """'t_end=0.5' for what makes a problem another one than that of the study `default`."""
    own, usual = dict(problem), dict(leading)
    values = {entry.get("key"): entry.get("value") for entry in case.catalog.get("parameters") or []}
    keys = [key for key in {**own, **usual} if own.get(key, values.get(key)) != usual.get(key, values.get(key))]
    return ", ".join(f"{key}={text.exact(own.get(key, values.get(key)))}" for key in sorted(keys))


def _comparator_reach(case, lines, measure):
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
    "work": (particle_steps, "cell_steps", "particle-steps (points × steps)", "error against particle-steps"),
}


def case_figures(document, case, prefix):
    """Error against wall time and against particle-steps; [] where the document has nothing on the case."""
    lines = lines_of(document, case)
    measure = case.measure
    if not lines or not measure:
        return []
    return [
        figure for kind in PRICES
        for figure in figures.parts(lambda name, part: _case_figure(case, lines, measure, kind, name, part), f"{prefix}-{kind}")
    ]  # fmt: skip


def _case_figure(case, lines, measure, kind, prefix, part):
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
    further = figures.left_out(rows) if part == 0 else ""
    rows = sorted(rows, key=lambda row: not row[0].same_problem)
    rivals = [(cost, error) for line, points in rows if line.same_problem for cost, error, _ in points]
    best = [rivals[index] for index in front(rivals)]
    others = [(entry, entry.costs(column, measure)) for entry in case.comparators]
    others = [(entry, points) for entry, points in others if points]
    every, rows = rows, figures.of_part(rows, part)  # small multiples have the same axes
    if not rows:
        return None

    def paint(axes):
        if best:
            axes.plot(*zip(*best), color=svg.INK, linewidth=3.2, alpha=0.16, solid_capstyle="round")
        for line, points in rows:
            _paint_line(axes, line, points, kind)
        for entry, points in others:
            axes.plot(
                *zip(*points), svg.series_mark(entry.style), color=svg.series_colour(entry.style), linestyle=(0, (5, 3)),
                linewidth=0.9, label=entry.title,
            )  # fmt: skip
        if best:
            axes.plot(
                *zip(*best), "o", markersize=9, color=svg.INK, markerfacecolor="none", markeredgewidth=0.8, linestyle="none"
            )
        axes.set(xscale="log", yscale="log", xlabel=axis, ylabel=figures.error_label(case, measure))
        costs = [cost for _, points in every for cost, _, _ in points] + [c for _, points in others for c, _ in points]
        errors = [error for _, points in every for _, error, _ in points] + [e for _, points in others for _, e in points]
        axes.set_xlim(min(costs) / 1.8, max(costs) * 1.8)
        axes.set_ylim(min(errors) / 1.8, max(errors) * 1.8)
        log_axis(axes.xaxis, *axes.get_xlim())
        log_axis(axes.yaxis, *axes.get_ylim())

    keys = [
        Key(line.label, f"var(--s{line.style % len(svg.SERIES) + 1})", svg.series_mark(line.style)) for line, _ in rows
    ] + [
        Key(entry.title, f"var(--s{entry.style % len(svg.SERIES) + 1})", svg.series_mark(entry.style), dash=True)
        for entry, _ in others
    ]
    return Figure(
        svg.draw(paint, prefix, f"{measure}: {title}", height=2.9),
        title[0].upper() + title[1:],
        _caption(measure, kind, rows, others) + further,
        list(dict.fromkeys([COST_FILE] + [entry.file for entry, _ in others])),
        keys + [Key("Pareto front", "currentColor", "ring")],
        [reproduce.costs(case.name)],
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


def _caption(measure, kind, rows, others):
    samples = [len(level["wall_s"]) for _, points in rows for _, _, level in points]
    single = sum(1 for count in samples if count == 1)
    words = ""
    if kind == "time":
        words = f"Medians of up to {max(samples)} interleaved repeats on one thread, bars from the fastest to the slowest" + (
            f"; {single} of {len(samples)} marks {'is' if single == 1 else 'are'} one run only. " if single else ". "
        )
    if any(not line.same_problem for line, _ in rows):
        words += "Pale: another problem, not in the Pareto front. "
    if others:
        words += (
            f"Broken: another method, {text.listing(entry.title for entry, _ in others)}; not judged, and not in the Pareto front" + ("." if kind == "time" else "; its work is cells × steps.")
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
        "jobs": (rows := jobs(found, folder_stability)),
        "recommended": recommended(rows),
        "with_york": len(with_york),
        "without": [entry.title for entry in found if not entry.york],
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
        "title": entry.title,
        "kind": entry.kind,
        "measure": entry.measure,
        "default": reach_words(reaches[default.label] if default else None),
        "york": reach_words(reaches[entry.york.label]) if entry.york else "no such study",
        "york_levels": len(entry.york.levels) if entry.york else 0,
        "ratio": ratio_words(entry.ratio(default)) if default and entry.york else text.MISSING,
        "best": f"{best.label}, {reach_words(reaches[best.label])}" if best else "none reaches it",
        "comparator": reach_words(entry.comparator),
    }


# --- which scheme for which job -------------------------------------------------------------------

JOBS = {"gas": "gas and shocks", "membrane": "membranes and strings", "solid": "solids, contact", "coupled": "gas in membranes"}
RULE = (
    "A problem is a case with the values of all keys that its text does not call numerical. Two schemes are compared on each problem "
    "that both were run on with their own choices: which needs less time at the smallest error that both come to, where all repeats "
    "say the same. Recommended is the scheme that needs less on more of these problems than it needs more on, against every scheme "
    f"it was compared with, over at least {LEAST_PROBLEMS} problems."
)


def jobs(found, stability=None):
    """Rows of the table: every scheme of every kind of scene that was run on a problem with a second one, those first most often at
    the top; in a kind without rivals the schemes that were run."""
    rows = []
    for kind, job in JOBS.items():
        entries = [entry for entry in found if entry.kind == kind]
        shared = [entry for entry in entries if len(entry.schemes()) > 1]
        schemes = dict.fromkeys(scheme for entry in shared or entries for scheme in entry.schemes())
        ranked = sorted((_standing(entries, shared, scheme) for scheme in schemes), key=lambda standing: standing["rank"])
        for standing in ranked:
            rows.append({**standing, "kind": kind, "job": job, "recommended": False})
    for row in rows:
        row["limit"] = _limit(stability, row)
    for choice in recommended(rows):
        for row in rows:
            row["recommended"] = row["recommended"] or (row["kind"], row["scheme"]) == (choice["kind"], choice["scheme"])
    return rows


def recommended(rows):
    """Of every kind of scene: the scheme, the problems that speak of it, and how often it needs less and more time than each other
    one; or no scheme, and why."""
    choices = []
    for kind, group in itertools.groupby(rows, key=lambda row: row["kind"]):
        group = list(group)
        choice = {"kind": kind, "job": group[0]["job"], "scheme": None, "problems": [], "against": [], "why": ""}
        unbeaten = [row for row in group if row["duels"] and all(len(one["less"]) > len(one["more"]) for one in row["duels"])]
        if not any(row["shared"] for row in group):
            choice["why"] = "no two schemes were run on the same problem"
        elif not any(row["duels"] for row in group):
            choice["why"] = "on no problem is it certain which of two schemes needs less time"
        elif not unbeaten:
            choice["why"] = "each of the schemes is beaten by another on as many problems"
        else:
            best = unbeaten[0]
            problems = sorted({name for one in best["duels"] for name in one["less"] + one["more"]})
            choice["problems"] = problems
            choice["against"] = [
                {"scheme": one["scheme"], "less": len(one["less"]), "more": len(one["more"])} for one in best["duels"]
            ]
            if len(problems) < LEAST_PROBLEMS:
                choice["why"] = f"the schemes can be compared on one problem alone, {problems[0]}"
            else:
                choice["scheme"] = best["scheme"]
        choices.append(choice)
    return choices


def _duels(shared, scheme):
    """Against each other scheme: the problems on which this one needs certainly less time at equal error, and more."""
    found = {}
    for entry in shared:
        lines = entry.schemes()
        for other in lines if scheme in lines else ():
            outcome = entry.outcome(lines[scheme], lines[other]) if other != scheme else 0
            if outcome:
                duel = found.setdefault(other, {"scheme": other, "less": [], "more": []})
                duel["less" if outcome > 0 else "more"].append(entry.name)
    return list(found.values())


def _standing(entries, shared, scheme):
    """How one scheme stands among all of a kind of scene: on how many of the problems that it shares with others it is first."""
    own = [entry for entry in shared if scheme in entry.schemes()]
    first, against_york = 0, []
    for entry in own:
        lines = entry.schemes()
        first += all(entry.outcome(lines[scheme], line) > 0 for other, line in lines.items() if other != scheme)
        if scheme != YORK and YORK in lines and (against := entry.at_equal_error(lines[scheme], lines[YORK])).sign == "":
            against_york.append(against.value)
    orders = [order for entry in entries for order in _asymptotic_orders(entry, scheme)]
    failures = sum(
        gate.get("verdict") == "XFAIL" and gate.get("scheme") == scheme
        for case in {entry.case.name: entry.case for entry in entries}.values()
        for gate in case.all_gates
    )
    ends = list(dict.fromkeys(text.fixed(order) for order in (min(orders), max(orders)))) if orders else []
    tried = [entry for entry in entries if scheme in entry.schemes()]
    return {
        "scheme": scheme,
        "first": first,
        "shared": len(own),
        "there": sum(not entry.reaches[entry.schemes()[scheme].label].never for entry in tried),
        "tried": len(tried),
        "against_york": text.number(statistics.median(against_york), 2) if against_york else text.MISSING,
        "york_count": len(against_york),
        "orders": " … ".join(ends) or text.MISSING,
        "order_count": len(orders),
        "xfails": failures,
        "duels": _duels(shared, scheme),
        "rank": (-first, -len(own), scheme),
    }


def _asymptotic_orders(entry, scheme):
    studies = [line.study for line in entry.lines if line.scheme == scheme and line.plain]
    fits = [study.measures.get(entry.measure) or {} for study in entry.case.studies("cells") if study.study in studies]
    return [fit["order"] for fit in fits if fit.get("asymptotic") and fit.get("order") is not None]


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
                if smallest.startswith("smallest known: "):
                    return f"{smallest.removeprefix('smallest known: ')} (smallest known); {words}"
                return f"{words} (smallest known)" if smallest else words
    return text.MISSING
