"""Gathers the files of a results folder into cases: what each page shows, and nothing decided anew."""

from collections import Counter
from dataclasses import dataclass, field

VERDICTS = ("PASS", "FAIL", "INCONCLUSIVE", "XFAIL", "XPASS", "INVALID", "NONE")
URGENCY = ("INVALID", "FAIL", "XPASS", "INCONCLUSIVE", "XFAIL", "PASS", "NONE")   # the order of lists: missed first
GREEN = ("XFAIL", "PASS", "NONE")
# What a study resolves level by level; two studies are told apart by the settings that remain.
_VARY_ORDER = {"cells": 0, "": 1, "dt": 2, "ppc": 3, "offset": 4}
SIZE_KEYS = frozenset(("cells", "h", "dt", "offset"))


@dataclass
class Series:
    """One line of the figures: the levels of a refinement study, or single runs of one scheme and settings."""

    scheme: str
    vary: str                 # cells, dt, ppc, offset; "" for single runs
    settings: dict
    levels: list              # run objects, coarse to fine, each with h and value
    measures: dict            # fits by measure, {} for single runs
    files: list               # names of the files behind it
    label: str = ""
    style: int = 0            # index into colours and marks
    title: str = ""
    why: str = ""

    def errors(self, measure):
        """(level, error) of the levels that have one."""
        found = [(level, ((level.get("measures") or {}).get(measure) or {}).get("error")) for level in self.levels]
        return [(level, error) for level, error in found if error is not None]


@dataclass
class Case:
    """All that the folder holds about one case."""

    name: str
    catalog: dict = field(default_factory=dict)
    gates: list = field(default_factory=list)       # from verdict files, the newest of each
    other_gates: list = field(default_factory=list)  # judged in a study or run only; each with its "file"
    series: list = field(default_factory=list)      # studies, then single runs
    runs: list = field(default_factory=list)        # run objects of the folder

    def studies(self, vary):
        return [entry for entry in self.series if entry.vary == vary]

    @property
    def counts(self):
        return Counter(gate.get("verdict") for gate in self.all_gates)

    @property
    def all_gates(self):
        return self.gates + self.other_gates

    @property
    def verdict(self):
        """The most urgent verdict among those stated; NONE where nothing was judged."""
        return min((gate.get("verdict") for gate in self.all_gates), key=urgency, default="NONE")

    @property
    def measure(self):
        """The measure that stands for the case: the first with a theoretical order, else the first fitted."""
        fitted = [name for entry in self.series for name in entry.measures]
        theory = [name for name in self.catalog.get("theory_order") or {}]
        found = [name for entry in self.series for level in entry.levels for name in level.get("measures") or {}]
        return next((name for name in theory if name in fitted), next(iter(fitted or theory or found), None))


def urgency(verdict):
    return URGENCY.index(verdict) if verdict in URGENCY else -1


def most_urgent_first(gates):
    """Missed gates first; within a verdict in the order of case, scheme and name."""
    return sorted(gates, key=lambda gate: (urgency(gate.get("verdict")), gate.get("case") or "", gate.get("scheme") or "",
                                           gate.get("id") or ""))


def gather(folder):
    """The cases of a folder by name."""
    cases = {}
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
    return dict(sorted(cases.items()))


def newest_gates(folder):
    """Gates of all verdict files; of the same gate in the same tier the one that was started last."""
    found = {}
    for result in sorted(folder.verdicts, key=lambda entry: (entry.provenance.get("started") or "", entry.name)):
        tier = result.verdicts.get("tier") or ""
        for gate in result.gates or result.verdicts.get("gates") or []:
            key = (tier, gate.get("case"), gate.get("scheme"), gate.get("id"))
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
    return gate.get("scheme"), gate.get("id"), gate.get("measured"), gate.get("verdict")


# --- series -------------------------------------------------------------------------------------------------

def _take_runs(cases, folder):
    in_studies = set()
    for result in folder.studies:
        study = result.study
        levels = [level for level in study.get("levels") or [] if isinstance(level, dict)]
        in_studies |= {level.get("file") for level in levels}
        case = _case(cases, study.get("case") or (levels[0].get("case") if levels else None) or "unnamed")
        case.series.append(Series(study.get("scheme") or "?", study.get("vary") or "cells", result.settings, levels,
                                  result.measures, [result.name], title=study.get("title") or "", why=study.get("why") or ""))
    for result in folder.runs:
        case = _case(cases, result.run.get("case") or "unnamed")
        case.runs.append({**result.run, "file": result.name})
        if result.name not in in_studies:
            _add_single_run(case, result)


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
    """Names each line by its scheme and by what sets it apart from others of that scheme; equal names, equal colour."""
    for entry in case.series:
        own = _distinctive(entry.settings, entry.vary)
        keys = _differing(case.series, entry, ("cells", "")) | _differing(case.series, entry, (entry.vary,))
        choices = ", ".join(f"{key}={_short(own[key])}" for key in sorted(keys & set(own)))
        entry.label = f"{entry.scheme} · {choices}" if choices else entry.scheme
    _tell_apart(case.series)
    case.series.sort(key=lambda entry: (entry.scheme != "default", entry.scheme, _VARY_ORDER.get(entry.vary, 9), entry.label))
    labels = list(dict.fromkeys(entry.label for entry in case.series))
    for entry in case.series:
        entry.style = labels.index(entry.label)


def _differing(series, entry, kinds):
    """Keys in which the lines of this scheme and of these kinds differ among themselves."""
    rivals = [_distinctive(other.settings, other.vary) for other in series if other.scheme == entry.scheme and other.vary in kinds]
    return {key for settings in rivals for key in settings if any(other.get(key) != settings[key] for other in rivals)}


def _tell_apart(series):
    """Two studies of one kind that differ in no setting are told apart by the hash in their file names."""
    clashes = Counter((entry.label, entry.vary) for entry in series)
    for entry in series:
        if clashes[entry.label, entry.vary] > 1:
            entry.label += f" · {entry.files[0].removesuffix('.h5')[-12:]}"


def _short(value):
    return f"{value:g}" if isinstance(value, float) else "none" if value is None else str(value)
