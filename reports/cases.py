"""Gathers the files of a results folder into cases: what each page shows, and nothing decided anew."""

import json
import re
from collections import Counter
from dataclasses import dataclass, field

import reproduce
from plumbline.reader import URGENCY, most_urgent, urgency

VERDICTS = ("PASS", "FAIL", "INCONCLUSIVE", "XFAIL", "XPASS", "INVALID", "NONE")
GREEN = ("XFAIL", "PASS", "NONE")
# What a study resolves level by level; two studies are told apart by the settings that remain.
_VARY_ORDER = {"cells": 0, "": 1, "dt": 2, "ppc": 3, "offset": 4}
SIZE_KEYS = frozenset(("cells", "h", "dt", "offset"))


def error_of(measured, key="error"):
    """The error of a measure, or None: what has a value and no reference beside it has no error, whatever the file says."""
    measured = measured or {}
    return None if measured.get("value") is not None and measured.get("reference") is None else measured.get(key)


@dataclass
class Series:
    """One line of the figures: the levels of a study, or single runs of one scheme and settings."""

    scheme: str
    vary: str  # cells, dt, ppc, offset; "" for single runs
    settings: dict
    levels: list  # run objects, coarse to fine, each with h and value
    measures: dict  # fits by measure, {} for single runs
    files: list  # names of the files behind it
    label: str = ""
    title: str = ""
    why: str = ""
    study: str = ""  # identifier of a declared study
    choices: dict = None  # what differs from the scheme; None in files that do not say it
    style: int = 0  # index into colours and marks
    baseline: "Series" = None  # the same line of an earlier folder

    @property
    def refined(self):
        return len(self.levels) > 1

    def errors(self, measure):
        """(level, error) of the levels that have one."""
        found = [
            (level, error_of((level.get("measures") or {}).get(measure))) for level in self.levels
        ]
        return [(level, error) for level, error in found if error is not None]


@dataclass
class Comparator:
    """Another method on the same problem, to show what errors cost there. Never judged."""

    title: str
    columns: dict  # cells, steps, cell_steps, wall_s and errors by measure: one value a level
    file: str  # the study that it ran with
    style: int = 0

    def costs(self, price, measure):
        """(cost, error) of the levels that have both."""
        pairs = zip(self.columns.get(price, ()), self.columns.get(measure, ()))
        return [(float(cost), float(error)) for cost, error in pairs if cost > 0 and error > 0]


@dataclass
class Case:
    """All that the folder holds about one case."""

    name: str
    catalog: dict = field(default_factory=dict)
    gates: list = field(default_factory=list)  # from verdict files, the newest of each
    other_gates: list = field(default_factory=list)  # judged in a study or run only; each with its "file"
    series: list = field(default_factory=list)  # studies, then single runs
    runs: list = field(default_factory=list)  # run objects of the folder
    comparators: list = field(default_factory=list)

    def studies(self, vary):
        return [entry for entry in self.series if entry.vary == vary]

    @property
    def has_points(self):
        """Whether any of its runs has points; trials compute without."""
        return any(level.get("points") for entry in self.series for level in entry.levels)

    @property
    def counts(self):
        return Counter(gate.get("verdict") for gate in self.all_gates)

    @property
    def all_gates(self):
        return self.gates + self.other_gates

    @property
    def verdict(self):
        """The most urgent verdict among those stated; NONE where nothing was judged."""
        return most_urgent(self.all_gates)

    @property
    def measure(self):
        """The measure that stands for the case: the one that most gates are about, else the first."""
        theory = list(self.catalog.get("theory_order") or {})
        fitted = [name for entry in self.series for name in entry.measures]
        found = fitted or [
            name for entry in self.series for level in entry.levels for name in level.get("measures") or {}
        ]
        names = list(dict.fromkeys([name for name in theory if name in found] + found))
        return max(names, key=lambda name: (name in theory, len(self.gates_about(name))), default=None)

    def gates_about(self, measure, words=""):
        """Declared or judged gates whose quantity names the measure and the words."""
        pattern = re.compile(rf"(?<![\w.]){re.escape(measure)}(?![\w.])")
        quantities = [
            gate.get("quantity") or "" for gate in self.all_gates + (self.catalog.get("gates") or [])
        ]
        return [quantity for quantity in quantities if pattern.search(quantity) and words in quantity]


def most_urgent_first(gates):
    """Missed gates first; within a verdict in the order of case, scheme and name."""
    return sorted(
        gates,
        key=lambda gate: (
            urgency(gate.get("verdict")),
            gate.get("case") or "",
            gate.get("scheme") or "",
            gate.get("id") or "",
        ),
    )


def gather(folder):
    """The cases of a folder by name."""
    cases = {}
    _take_commands(folder)
    gates = newest_gates(folder)
    for result in folder.verdicts + folder.studies:
        _take_catalog(cases, result)
    for gate in gates:
        _case(cases, gate.get("case") or "unnamed").gates.append(gate)
    _take_runs(cases, folder)
    for result in folder.studies + folder.runs:
        _take_other_gates(cases, result)
    for case in cases.values():
        case.gates = most_urgent_first(case.gates)
        case.other_gates = most_urgent_first(case.other_gates)
        _label(case)
        _name_gates(case)
    return dict(sorted(cases.items()))


def _take_commands(folder):
    """What another program computed is made again by no run of ours: its parts name the command that judged it."""
    for result in folder.studies + folder.runs:
        own = result.study or result.run
        if reproduce.is_foreign(own):
            for part in (own, *(own.get("levels") or ()), *result.gates):
                part[reproduce.SCORED_BY] = result.provenance.get("command") or ""


def _name_gates(case):
    """An identifier for links to each gate, which stays the same from run to run."""
    taken = Counter()
    for gate in case.all_gates:
        words = [case.name, gate.get("id") or "unnamed"]
        scheme = gate.get("scheme") or ""
        if scheme and scheme not in words[1]:
            words.insert(1, scheme)
        name = re.sub(r"[^A-Za-z0-9_.-]+", "-", "-".join(words))
        taken[name] += 1
        gate["anchor"] = f"gate-{name}" + (f"-{taken[name]}" if taken[name] > 1 else "")


def newest_gates(folder):
    """Gates of all verdict files; of the same gate in the same tier the one that was started last."""
    found = {}
    for result in sorted(
        folder.verdicts, key=lambda entry: (entry.provenance.get("started") or "", entry.name)
    ):
        tier = result.verdicts.get("tier") or ""
        for gate in result.gates or result.verdicts.get("gates") or []:
            key = (tier, gate.get("case"), gate.get("scheme"), gate.get("study"), gate.get("id"))
            found[key] = {**_stated(gate), "tier": tier, "file": result.name}
    return list(found.values())


def _stated(gate):
    """The gate with a verdict: one that states none lacks data, which is what INVALID means."""
    return {**gate, "verdict": gate.get("verdict") or "INVALID"}


def _case(cases, name):
    return cases.setdefault(name, Case(name))


def _take_catalog(cases, result):
    entries = {result.study.get("case"): result.catalog} if result.kind == "study" else result.catalog
    for name, entry in entries.items():
        if name and isinstance(entry, dict):
            case = _case(cases, name)
            case.catalog = {**entry, **case.catalog}


def _take_other_gates(cases, result):
    name = (result.study or result.run).get("case")
    case = _case(cases, name or "unnamed")
    known = {_identity(gate) for gate in case.all_gates}
    for gate in result.gates:
        if _identity(gate) not in known:
            case.other_gates.append({"case": name, **_stated(gate), "file": result.name})


def _identity(gate):
    return gate.get("scheme"), gate.get("study"), gate.get("id"), gate.get("measured"), gate.get("verdict")


# --- series ---------------------------------------------------------------------------------------


def _take_runs(cases, folder):
    in_studies, planned = set(), set()
    for result in folder.studies:
        study = result.study
        levels = [level for level in study.get("levels") or [] if isinstance(level, dict)]
        in_studies |= {level.get("file") for level in levels}
        planned |= {_but_for_offset(level) for level in levels}
        case = _case(cases, study.get("case") or (levels[0].get("case") if levels else None) or "unnamed")
        _add_comparators(case, result)
        title, declared = study.get("title") or "", study.get("id") or ""
        declared = "" if declared == "study" else declared  # the name of studies that nobody declared
        case.series.append(
            Series(
                study.get("scheme") or "?",
                study.get("vary") or "cells",
                result.settings,
                levels,
                result.measures,
                [result.name],
                title if declared else "",
                title,
                study.get("why") or "",
                declared,
                study.get("choices"),
            )
        )
    for result in folder.runs:
        run = {**result.run, "file": result.name}
        case = _case(cases, run.get("case") or "unnamed")
        case.runs.append(run)
        # A further sub-cell offset of a level belongs to its study, which has used it.
        if result.name not in in_studies and _but_for_offset(run) not in planned:
            _add_single_run(case, result)


def _add_comparators(case, result):
    """Of the same method in several studies the one with most levels."""
    for name, columns in result.comparators.items():
        found = Comparator(columns.labels.get("title") or name, columns, result.name)
        rivals = [entry for entry in case.comparators if entry.title == found.title]
        if rivals and max(_level_count(entry.columns) for entry in rivals) >= _level_count(columns):
            continue
        case.comparators = [entry for entry in case.comparators if entry.title != found.title] + [found]


def _level_count(columns):
    return len(next(iter(columns.values()), ()))


def _but_for_offset(run):
    settings = {key: value for key, value in (run.get("settings") or {}).items() if key != "offset"}
    return json.dumps([run.get("case"), run.get("scheme"), settings], sort_keys=True)


def _add_single_run(case, result):
    run = {**result.run, "file": result.name}
    settings = result.settings or run.get("settings") or {}
    kept = _distinctive(settings)
    for entry in case.series:
        if not entry.vary and entry.scheme == run.get("scheme") and _distinctive(entry.settings) == kept:
            entry.levels = sorted(entry.levels + [run], key=_cells)
            entry.files.append(result.name)
            return
    case.series.append(Series(run.get("scheme") or "?", "", settings, [run], {}, [result.name]))


def _cells(run):
    cells = (run.get("settings") or {}).get("cells")
    return cells if isinstance(cells, (int, float)) else 0


def _distinctive(settings, vary=""):
    return {key: value for key, value in settings.items() if key not in SIZE_KEYS and key != vary}


def _label(case):
    """Names each line, a declared study by its title, another by its scheme and what sets it apart.

    Lines of equal choices have the same colour.
    """
    titles = Counter((entry.label, entry.vary) for entry in case.series)
    for entry in case.series:
        if not entry.label or titles[entry.label, entry.vary] > 1:
            entry.label = _choices_label(case.series, entry)
    _tell_apart(case.series)
    declared = [study.get("id") for study in case.catalog.get("studies") or []]
    case.series.sort(
        key=lambda entry: (
            _VARY_ORDER.get(entry.vary, 9),
            not entry.refined,
            declared.index(entry.study) if entry.study in declared else len(declared),
            entry.scheme != "default",
            entry.scheme,
            entry.label,
        )
    )
    colours = []
    for entry in case.series:
        choices = entry.scheme, _distinctive(entry.settings)
        if choices not in colours:
            colours.append(choices)
        entry.style = colours.index(choices)
    for number, entry in enumerate(case.comparators):
        entry.style = len(colours) + number


def _choices_label(series, entry):
    own = _distinctive(entry.settings, entry.vary)
    keys = _differing(series, entry, ("cells", "")) | _differing(series, entry, (entry.vary,))
    choices = ", ".join(f"{key}={_short(own[key])}" for key in sorted(keys & set(own)))
    return f"{entry.scheme} · {choices}" if choices else entry.scheme


def _differing(series, entry, kinds):
    """Keys in which the lines of this scheme and of these kinds differ among themselves."""
    rivals = [
        _distinctive(other.settings, other.vary)
        for other in series
        if other.scheme == entry.scheme and other.vary in kinds
    ]
    return {
        key
        for settings in rivals
        for key in settings
        if any(other.get(key) != settings[key] for other in rivals)
    }


def _tell_apart(series):
    """Two studies of one kind that differ in no setting are told apart by the hash in their file names."""
    clashes = Counter((entry.label, entry.vary) for entry in series)
    for entry in series:
        if clashes[entry.label, entry.vary] > 1:
            entry.label += f" · {entry.files[0].removesuffix('.h5')[-12:]}"


def _short(value):
    return f"{value:g}" if isinstance(value, float) else "none" if value is None else str(value)
