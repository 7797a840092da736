"""Reads the result files of Plumbline: one run, one refinement study or one set of verdicts per HDF5 file.

    from plumbline import reader
    run = reader.load("results/sod-default-100-0123456789ab.h5")
    run.measures["density.L1"]["error"], run.profile["density"], run.ledger["energy"]["residual"]

    python -m plumbline FILE --csv gates > gates.csv

Needs numpy, and h5py to read a file. Numbers keep the units the file states; non-finite numbers are None in the JSON parts.
Exit status: 0; 1 h5py is not installed; 2 the file has no such table; 4 the file is damaged, missing or of a newer format.
"""

import argparse
import csv
import json
import os
import pathlib
import re
import sys
import zlib
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any, TextIO

import numpy

FORMAT_VERSION = 2
OLDEST_FORMAT_VERSION = 1
KINDS = ("run", "study", "verdicts")
URGENCY = ("INVALID", "FAIL", "XPASS", "INCONCLUSIVE", "XFAIL", "PASS", "NONE")  # the order of lists: missed first
SEAL_SIZE = 512  # bytes in front of the HDF5 part: how many follow, and their checksum
BENCH_FILE = "bench.json"
STABILITY_FILE = "stability.json"
MUTANTS_FILE = "mutants.json"
DRAW_FILE = "draw.json"
COST_FILE = "cost.json"
EQUATIONS_FILE = "equations.json"
LIST_FILE = "list.json"
COVERAGE_FILE = "coverage.json"
DIFF_FILE = "diff.json"
JUDGES_FILE = "judges.json"
SCORECARD_FILES = "scorecard-*.json"
GATE_COLUMNS = (
    "case",
    "id",
    "scheme",
    "quantity",
    "low",
    "high",
    "origin",
    "reason",
    "measured",
    "interval_low",
    "interval_high",
    "margin",
    "verdict",
    "cause",
    "run_ids",
)
MEASURE_COLUMNS = ("value", "error", "relative_error", "reference", "reference_bound", "unit")
FIT_COLUMNS = ("order", "order_low", "order_high", "constant", "asymptotic", "reason")
FRAME_FIELDS = ("position", "velocity", "pressure", "stress", "id")
LEVEL_COLUMNS = (
    "h",
    "value",
    "points",
    "steps",
    "wall_s",
    "particle_steps_per_s",
    "verdict",
    "finished",
    "file",
)


def urgency(verdict: str | None) -> int:
    """Place of a verdict in URGENCY; one that is not known comes before all."""
    return URGENCY.index(verdict) if verdict in URGENCY else -1


def most_urgent(gates: Iterable[Any]) -> str:
    """The most urgent verdict among those of the gates; NONE where nothing was judged."""
    return min((gate.get("verdict") for gate in gates), key=urgency, default="NONE")


class ResultsError(Exception):
    """A result file that cannot be used; the text says why."""


class DamagedFile(ResultsError):
    """The file is truncated, no HDF5, no file of Plumbline, or a part of it is missing or malformed."""


class NewerFormat(ResultsError):
    """The file was made by a newer version of Plumbline than this reader knows."""


class NoSuchTable(ResultsError, KeyError):
    """The file is whole, but holds no table of that name."""

    def __str__(self):
        return self.args[0]


class NotInstalled(ImportError):
    """A library that not every use of the package needs is missing; the text says how to install it."""

    def __init__(self, library: str, use: str) -> None:
        super().__init__(f"{library} is not installed, which {use}: apt-get install python3-{library}, or pip install {library}", name=library)


def hdf5() -> Any:
    """The library that reads result files; gates and settings come without it."""
    try:
        import h5py
    except ImportError as error:
        raise NotInstalled("h5py", "reading result files needs") from error
    return h5py


class Columns(dict[str, numpy.ndarray]):
    """Columns of equal length by name (float64 arrays), with `units`, `labels`, `abscissa` and `kind`."""

    def __init__(
        self,
        columns: dict[str, numpy.ndarray],
        units: dict[str, str] | None = None,
        labels: dict[str, str] | None = None,
        abscissa: str = "",
        kind: str = "",
    ) -> None:
        super().__init__(columns)
        self.units = units or {}
        self.labels = labels or {}
        self.abscissa = abscissa
        self.kind = kind


@dataclass
class Frames:
    """Snapshots of the points of a run. `times` in s; `bodies`: objects with name, kind (gas, membrane, solid),
    material, chain, closed; `grid`: dim, axisymmetric, h, low, high, walls; `units` by field.
    """

    times: numpy.ndarray
    bodies: list[dict]
    grid: dict[str, Any]
    units: dict[str, str]
    every: int  # one point in so many is there of bodies that are no chain
    points: dict[str, numpy.ndarray]  # by field: the values of all frames one after another
    starts: numpy.ndarray  # where each frame begins in them, and their end

    def __len__(self) -> int:
        return len(self.times)

    def body(self, frame: int, number: int) -> dict[str, numpy.ndarray]:
        """{field: values} of one body at one frame: id, position and velocity (n, 3), pressure, stress."""
        part = slice(self.starts[frame], self.starts[frame + 1])
        chosen = self.points["body"][part] == number
        return {name: values[part][chosen] for name, values in self.points.items() if name != "body"}


@dataclass
class Result:
    """One result file. `run`, `study` and `verdicts` hold the JSON object of the file's own kind, else {}."""

    kind: str
    name: str
    format: int
    run: dict[str, Any] = field(default_factory=dict)
    study: dict[str, Any] = field(default_factory=dict)
    verdicts: dict[str, Any] = field(default_factory=dict)
    measures: dict[str, Any] = field(default_factory=dict)
    gates: list[dict] = field(default_factory=list)
    provenance: dict[str, Any] = field(default_factory=dict)
    settings: dict[str, Any] = field(default_factory=dict)
    catalog: dict[str, Any] = field(default_factory=dict)
    ledger: dict[str, Columns] = field(default_factory=dict)
    profile: Columns = field(default_factory=lambda: Columns({}))
    comparators: dict[str, Columns] = field(default_factory=dict)  # of a study: levels of other methods, by name
    frames: Frames | None = None  # of a run that kept any

    @property
    def case(self) -> str:
        """Name of the case; of verdicts, which may be those of many, empty."""
        return (self.run or self.study).get("case", "")

    @property
    def scheme(self) -> str:
        """Name of the scheme; of verdicts empty."""
        return (self.run or self.study).get("scheme", "")

    @property
    def verdict(self) -> str:
        """The one the file states of a run, else the most urgent of its gates'."""
        stated = self.run.get("verdict")
        return stated if stated else most_urgent(self.gates or self.study.get("gates") or self.verdicts.get("gates") or [])

    def errors(self, measure: str) -> tuple[numpy.ndarray, numpy.ndarray]:
        """Cell sizes in m and errors of a study's levels, in the order of its file. Levels without that error are left out."""
        levels = [(level.get("h"), (level.get("measures", {}).get(measure) or {}).get("error")) for level in self.study.get("levels", [])]
        known = [(h, error) for h, error in levels if h is not None and error is not None]
        if not known:
            there = sorted({name for level in self.study.get("levels", []) for name in level.get("measures", {})})
            raise KeyError(f"no errors of '{measure}' here; there are: {', '.join(there) or 'none'}")
        h, error = numpy.array(known, dtype=float).T
        return h, error

    def plot(self, name: str = "", axes: Any = None) -> Any:
        """Draws a field of a run over its reference, or the errors of a study over the cell size; returns the axes of matplotlib.

        Without `name` the first field or fitted measure; without `axes` on those of pyplot. Raises KeyError for a name not there.
        """
        from plumbline import plots

        return plots.draw(self, name, axes)

    def table_names(self) -> list[str]:
        """Names of the tables that this file can give as CSV."""
        return [name for name, build in _TABLES.items() if build(self)[1]]

    def table(self, name: str) -> tuple[list[str], list[list]]:
        """(header, rows) of a table; raises NoSuchTable."""
        if name not in _TABLES:
            raise NoSuchTable(f"unknown table '{name}'; there are: {', '.join(_TABLES)}")
        header, rows = _TABLES[name](self)
        if not rows:
            raise NoSuchTable(f"{self.name} has no table '{name}'; it has: {', '.join(self.table_names())}")
        return header, rows

    def to_csv(self, name: str, target: str | os.PathLike[str] | TextIO) -> None:
        """Writes a table to `target`, a path or an open text stream."""
        write_csv(*self.table(name), target)


@dataclass
class Folder:
    """All result files of one folder by kind, each list sorted by file name; `damaged`: (name, reason).

    `bench`: the JSON object of `plumbline bench`, if the folder has one under the name BENCH_FILE; `stability`: that of
    `plumbline stability` under STABILITY_FILE; `mutants`: the kill matrix of ci/mutants under MUTANTS_FILE;
    `draw`: the rates of `ci/mutants --draw` under DRAW_FILE;
    `cost`: that of `plumbline bench --cases` under COST_FILE; `equations`: that of `ci/check_equations` under
    EQUATIONS_FILE; `coverage`: that of `ci/coverage` under COVERAGE_FILE; `judges`: that of `ci/judges` under JUDGES_FILE;
    `listed`: that of `plumbline list` under LIST_FILE; `scorecards`: those of `plumbline verify --integrator` under SCORECARD_FILES.
    """

    runs: list[Result] = field(default_factory=list)
    studies: list[Result] = field(default_factory=list)
    verdicts: list[Result] = field(default_factory=list)
    damaged: list[tuple[str, str]] = field(default_factory=list)
    bench: dict[str, Any] = field(default_factory=dict)
    stability: dict[str, Any] = field(default_factory=dict)
    mutants: dict[str, Any] = field(default_factory=dict)
    draw: dict[str, Any] = field(default_factory=dict)
    cost: dict[str, Any] = field(default_factory=dict)
    equations: dict[str, Any] = field(default_factory=dict)
    listed: dict[str, Any] = field(default_factory=dict)
    coverage: dict[str, Any] = field(default_factory=dict)
    diff: dict[str, Any] = field(default_factory=dict)  # of `plumbline diff` under DIFF_FILE
    judges: dict[str, Any] = field(default_factory=dict)
    scorecards: list[dict] = field(default_factory=list)


def load(path: str | os.PathLike[str]) -> Result:
    """Reads one file. Raises DamagedFile, NewerFormat, or FileNotFoundError."""
    path = pathlib.Path(path)
    if not path.exists():
        raise FileNotFoundError(f"{path}: no such file")
    h5py = hdf5()
    try:
        check_seal(path)
        with h5py.File(path, "r") as file:
            return _read(file, path.name)
    except ResultsError:
        raise
    except (OSError, RuntimeError, LookupError, ValueError, TypeError, AttributeError, ArithmeticError, MemoryError) as error:
        raise DamagedFile(_why_unreadable(error)) from error


def check_seal(path: str | os.PathLike[str]) -> None:
    """Raises DamagedFile if a sealed file is not what was written: HDF5 may not come back from what is damaged."""
    content = pathlib.Path(path).read_bytes()
    if content.startswith(b"\x89HDF\r\n\x1a\n"):  # without a seal: of format 1, or made by another program
        return
    seal = re.match(rb"plumbline: (\d+) bytes follow byte 512, CRC-32 ([0-9a-f]{8})\n", content)
    if not seal:
        raise DamagedFile("neither HDF5 nor a result file of Plumbline")
    whole = SEAL_SIZE + int(seal.group(1))
    if len(content) < whole:
        raise DamagedFile(f"truncated: {len(content)} of {whole} bytes are there")
    if len(content) > whole or zlib.crc32(content[SEAL_SIZE:]) != int(seal.group(2), 16):
        raise DamagedFile("its content is not what was written")


def load_folder(path: str | os.PathLike[str]) -> Folder:
    """Reads every *.h5 file directly in the folder; what cannot be used is listed, never raised."""
    path = pathlib.Path(path)
    if not path.is_dir():
        raise NotADirectoryError(f"{path}: no such folder")
    folder = Folder()
    lists = {"run": folder.runs, "study": folder.studies, "verdicts": folder.verdicts}
    for file in sorted(path.glob("*.h5"), key=lambda entry: entry.name):
        try:
            result = load(file)
            lists[result.kind].append(result)
        except (ResultsError, OSError) as error:
            folder.damaged.append((file.name, str(error)))
    folder.bench = _load_if_there(load_bench, path / BENCH_FILE, folder)
    folder.stability = _load_if_there(load_stability, path / STABILITY_FILE, folder)
    folder.mutants = _load_if_there(load_mutants, path / MUTANTS_FILE, folder)
    folder.draw = _load_if_there(load_draw, path / DRAW_FILE, folder)
    folder.cost = _load_if_there(load_cost, path / COST_FILE, folder)
    folder.equations = _load_if_there(load_equations, path / EQUATIONS_FILE, folder)
    folder.listed = _load_if_there(load_list, path / LIST_FILE, folder)
    folder.coverage = _load_if_there(load_coverage, path / COVERAGE_FILE, folder)
    folder.diff = _load_if_there(load_diff, path / DIFF_FILE, folder)
    folder.judges = _load_if_there(load_judges, path / JUDGES_FILE, folder)
    cards = [_load_if_there(load_scorecard, file, folder) for file in sorted(path.glob(SCORECARD_FILES))]
    folder.scorecards = [card for card in cards if card]
    return folder


def _load_if_there(read, path, folder):
    """Speed and stability are not measured with every set of results."""
    try:
        return read(path)
    except FileNotFoundError:
        return {}
    except (ResultsError, OSError) as error:
        folder.damaged.append((path.name, str(error)))
        return {}


def _with_list(path, part, command):
    """The JSON object in a file that a command wrote, whose part of this name is a list of objects."""
    document = _json_file(path)
    entries = document.get(part) if isinstance(document, dict) else None
    if not isinstance(entries, list) or not all(isinstance(entry, dict) for entry in entries):
        raise DamagedFile(f"not an output of {command}: there is no list of {part}")
    return document


def load_bench(path):
    """The JSON object that `plumbline bench --json` wrote. Raises DamagedFile or FileNotFoundError."""
    return _with_list(path, "kernels", "plumbline bench")


def _of_mutants(path, parts):
    """The JSON object that ci/mutants wrote, whose lists hold objects with these keys."""
    document = _json_file(path)
    if not isinstance(document, dict) or not isinstance(document.get("version"), int):
        raise DamagedFile("not an output of ci/mutants: there is no version")
    if document["version"] > 1:
        raise NewerFormat(f"made by a newer version: format {document['version']}, this reader knows up to 1")
    for part, keys in parts.items():
        entries = document.get(part)
        if not isinstance(entries, list) or not all(isinstance(e, dict) and set(keys.split()) <= set(e) for e in entries):
            raise DamagedFile(f"not an output of ci/mutants: its {part} are not whole")
    return document


def load_draw(path):
    """The rates that `ci/mutants --draw` wrote. Raises DamagedFile, NewerFormat or FileNotFoundError."""
    kinds = ("by_cases", "by_gates", "by_everything")
    rates = f"name {' '.join(kinds)}"
    row = "id file line what by_case by_part by_test ran left_out equivalent in_cases in_gates in_all"
    draw = _of_mutants(path, {"operators": f"{rates} sites excluded", "folders": rates, "mutants": row})
    own = [entry[key] for entry in (draw, *draw["operators"], *draw["folders"]) for key in kinds if key in entry]
    whole = all(isinstance(rate, dict) and {"killed", "of", "rate", "interval"} <= set(rate) for rate in own)
    if not whole or not {"seed", "all", "equivalent", "stopped", *kinds} <= set(draw):
        raise DamagedFile("not an output of ci/mutants: there are no rates")
    return draw


def load_mutants(path):
    """The kill matrix that ci/mutants wrote. Raises DamagedFile, NewerFormat or FileNotFoundError."""
    row = "id file line area kind origin what status killed_by tests stopped cells must_kill"
    matrix = _of_mutants(path, {"columns": "name kind gates", "mutants": row})
    if not isinstance(matrix.get("counts"), dict) or not _number_or_none(matrix.get("score")) or matrix["score"] is None:
        raise DamagedFile("not an output of ci/mutants: there is no score")
    return matrix


def load_cost(path):
    """The JSON object that `plumbline bench --cases --json` wrote. Raises DamagedFile or FileNotFoundError."""
    cost = _json_file(path)
    runs = cost.get("runs") if isinstance(cost, dict) else None
    if not isinstance(runs, list):
        raise DamagedFile("not an output of plumbline bench --cases: there is no list of runs")
    for number, run in enumerate(runs):
        place = f"runs[{number}]"
        if not isinstance(run, dict):
            raise DamagedFile(f"{place} is no object")
        for name, kind in _COST_PARTS.items():
            if not isinstance(run.get(name), kind) or isinstance(run[name], bool) != (kind is bool):
                raise DamagedFile(f"{place}.{name} is missing or malformed")
        if not run["wall_s"] or not all(isinstance(time, (int, float)) and time >= 0 for time in run["wall_s"]):
            raise DamagedFile(f"{place}.wall_s is no list of times")
        for name, error in run["errors"].items():
            values = [error.get(key) for key in ("error", "relative_error")] if isinstance(error, dict) else [None]
            if not all(isinstance(value, (int, float)) for value in values):
                raise DamagedFile(f"{place}.errors.{name} has no error and relative_error")
    return cost


_COST_PARTS: dict[str, Any] = {
    **dict.fromkeys(("case", "scheme", "study", "kind", "vary", "source"), str),
    **dict.fromkeys(("value", "cells", "points", "steps", "particle_steps"), (int, float)),
    **dict.fromkeys(("differs", "errors"), dict),
    "wall_s": list,
    "finished": bool,
}


def load_list(path):
    """The JSON object that `plumbline list` wrote. Raises DamagedFile or FileNotFoundError."""
    document = _json_file(path)
    schemes = document.get("schemes") if isinstance(document, dict) else None
    whole = isinstance(schemes, list) and all(
        isinstance(scheme, dict)
        and all(isinstance(scheme.get(part), str) for part in ("name", "title", "source"))
        and isinstance(scheme.get("kinds"), dict)
        and all(isinstance(values, dict) for values in scheme["kinds"].values())
        for scheme in schemes
    )
    if not whole:
        raise DamagedFile("not an output of plumbline list: there is no list of schemes with name, title, source and kinds")
    return document


def load_equations(path):
    """The JSON object that `ci/check_equations --json` wrote. Raises DamagedFile or FileNotFoundError."""
    document = _json_file(path)
    rows = document.get("equations") if isinstance(document, dict) else None
    whole = isinstance(rows, list) and all(
        isinstance(row, dict)
        and isinstance(row.get("tag"), str)
        and all(isinstance(row.get(part), list) for part in ("computed", "checked"))
        for row in rows
    )
    if not whole:
        raise DamagedFile("not an output of ci/check_equations: there is no list of equations with tag, computed and checked")
    return document


def load_coverage(path):
    """The JSON object that `ci/coverage` wrote: shares of lines, in all and by folder. Raises as the others."""
    document = _json_file(path)
    folders = document.get("folders") if isinstance(document, dict) else None
    shares = [document.get("total"), *folders.values()] if isinstance(folders, dict) else [None]
    if not all(isinstance(share, (int, float)) and 0 <= share <= 1 for share in shares):
        raise DamagedFile("not an output of ci/coverage: there is no total and no shares of folders in [0, 1]")
    return document


def load_diff(path):
    """The JSON object that `plumbline diff --json` wrote. Raises DamagedFile or FileNotFoundError."""
    return _with_list(path, "findings", "plumbline diff")


def load_scorecard(path):
    """The JSON object that `plumbline verify --integrator` wrote, with the name of its `file`. Raises DamagedFile or
    FileNotFoundError. Parts that it lacks, or gives as null, come back empty; numbers may be None, and so may `against` and `factor`.
    """
    card = _json_file(path)
    if not isinstance(card, dict) or not all(isinstance(card.get(part), str) for part in ("integrator", "sentence", "verdict")):
        raise DamagedFile("not a scorecard of plumbline verify --integrator: integrator, sentence or verdict is missing")
    against, factor = card.get("against"), card.get("factor")
    whole = _formed(card, _SCORECARD_PARTS, "scorecard")
    if against is None:
        whole["against"] = None
    if factor is None:
        whole["factor"] = None
    return {**whole, "file": pathlib.Path(path).name}


def load_judges(path):
    """The JSON object that `ci/judges` wrote. Raises DamagedFile or FileNotFoundError; parts that it lacks come back empty."""
    document = _json_file(path)
    if not isinstance(document, dict) or not isinstance(document.get("wrong"), list):
        raise DamagedFile("not an output of ci/judges: there is no list of wrong integrators")
    return _formed(document, _JUDGES_PARTS, "judges")


def _formed(value, form, place):
    """The value with all parts that its form names there and of their kind. A form is a kind, a list of one form, an object of
    forms, or a tuple of one, which stands for an object of any names."""
    if isinstance(form, tuple):
        form = dict.fromkeys(value, form[0]) if isinstance(value, dict) else {}
    if isinstance(form, dict):
        value = {} if value is None else value
        if not isinstance(value, dict):
            raise DamagedFile(f"{place} is no object")
        return {**value, **{key: _formed(value.get(key), part, f"{place}.{key}") for key, part in form.items()}}
    if isinstance(form, list):
        value = [] if value is None else value
        if not isinstance(value, list):
            raise DamagedFile(f"{place} is no list")
        return [_formed(entry, form[0], f"{place}[{number}]") for number, entry in enumerate(value)]
    if form is float:
        if not _number_or_none(value):
            raise DamagedFile(f"{place} is no number")
        return value
    value = form() if value is None else value
    if not isinstance(value, form):
        raise DamagedFile(f"{place} should be {_KINDS[form]}")
    return value


_KINDS = {str: "a text", bool: "true or false"}
_RANGE: dict[str, Any] = {"low": float, "high": float}
_GATE_PARTS: dict[str, Any] = {
    **dict.fromkeys(("id", "case", "scheme", "study", "quantity", "origin", "reason", "verdict", "cause", "note", "explanation"), str),
    "expected": _RANGE,
    "measured": float,
    "interval": [float],
    "margin": float,
}
_FACTOR_PARTS: dict[str, Any] = {"case": str, "factor": float, "low": float, "high": float, "note": str}
_HALF_PARTS: dict[str, Any] = {
    **dict.fromkeys(("integrator", "title", "source", "effort", "sentence", "verdict"), str),
    "parameters": (float,),
    "needs": [str],
    "offers": [str],
    "families": [{"family": str, "claimed": str, "measured": str, "verdict": str, "gates": float, "red": [str]}],
    "limits": [
        {
            **dict.fromkeys(("problem", "choices", "unit", "note"), str),
            **dict.fromkeys(("limit", "closed_form", "growth"), float),
            **dict.fromkeys(("endless", "smallest"), bool),
        }
    ],
    "cost": [
        {
            **dict.fromkeys(("case", "measure", "note"), str),
            "levels": [{"cells": float, "error": float, "particle_steps": float, "wall_s": [float]}],
        }
    ],
}
_SCORECARD_PARTS: dict[str, Any] = {
    **_HALF_PARTS,
    "against": _HALF_PARTS,
    "factors": [_FACTOR_PARTS],
    "factor": _FACTOR_PARTS,
    "next": str,
    "gates": [_GATE_PARTS],
    "not_applicable": [{"what": str, "missing": [{"trait": str, "why": str}]}],
}
_JUDGED_PARTS = {
    **dict.fromkeys(("integrator", "title", "source", "verdict", "stopped", "stage", "status", "argument"), str),
    "gate": {**_GATE_PARTS, "family": str},
    "proven": bool,
    "known": [{"quantity": str, "known": float, "measured": float, "agrees": bool}],
}
_JUDGES_PARTS: dict[str, Any] = {
    **dict.fromkeys(("wrong", "weak", "right"), [_JUDGED_PARTS]),
    "systematic": {"stages": (dict.fromkeys(("changes", "killed", "equivalent", "survived"), float),), "changes": [_JUDGED_PARTS]},
    "smallest": [{"gate": str, **dict.fromkeys(("strain", "force", "motion"), float)}],
    **dict.fromkeys(("commit", "made"), str),
    "dirty": bool,
}


def load_scoreboard(path):
    """The JSON object that `plumbline scoreboard` wrote. Raises DamagedFile or FileNotFoundError."""
    board = _json_file(path)
    format_ = board.get("scoreboard") if isinstance(board, dict) else None
    if isinstance(format_, int) and format_ > SCOREBOARD_FORMAT:
        raise NewerFormat(f"made by a newer version: format {format_}, this reader knows up to {SCOREBOARD_FORMAT}")
    _check_shape(board, _SCOREBOARD, "scoreboard")
    for problem in board["problems"]:
        levels = len(problem["own"]["levels"])
        for program in problem["programs"]:
            if len(program["entries"]) != levels:
                raise DamagedFile(f"{problem['case']}: {program['name']} has {len(program['entries'])} entries for {levels} starts")
    return board


SCOREBOARD_FORMAT = 1
_NUMBER, _NUMBER_OR_NULL, _TEXT_OR_NULL = (int, float), (int, float, type(None)), (str, type(None))
_FITS = {str: dict.fromkeys(("order", "order_low", "order_high"), _NUMBER_OR_NULL)}
# What a scoreboard is made of: objects with these keys (`str`: with any keys), lists of one kind, types.
_SCOREBOARD = {
    "scoreboard": int,
    "problems": [
        {
            "case": str,
            "title": str,
            "settings": [str],
            "measure": str,
            "units": {str: str},
            "own": {
                "levels": [{"cells": int, "h": _NUMBER, "errors": {str: _NUMBER_OR_NULL}, "seconds": _NUMBER, "stop": _TEXT_OR_NULL}],
                "orders": _FITS,
            },
            "programs": [
                {
                    "name": str,
                    "reason": str,
                    "program": _TEXT_OR_NULL,
                    "version": _TEXT_OR_NULL,
                    "verdict": _TEXT_OR_NULL,
                    "orders": _FITS,
                    "gates": [dict],
                    "not_judged": [{"id": str, "reason": str}],
                    "entries": [
                        {
                            "start": str,
                            "cells": int,
                            "outcome": str,
                            "reason": str,
                            "verdict": _TEXT_OR_NULL,
                            "errors": {str: {"error": _NUMBER_OR_NULL, "ratio": _NUMBER_OR_NULL}},
                            "seconds": _NUMBER_OR_NULL,
                            "timed": _TEXT_OR_NULL,
                        }
                    ],
                }
            ],
        }
    ],
    "refused": [{"start": str, "reason": str}],
    "strays": [str],
    "provenance": dict,
}


def _check_shape(value, shape, place):
    if isinstance(shape, dict):
        _check_shape(value, dict, place)
        for key, part in (dict.fromkeys(value, shape[str]) if str in shape else shape).items():
            if key not in value:
                raise DamagedFile(f"{place}.{key} is missing")
            _check_shape(value[key], part, f"{place}.{key}")
    elif isinstance(shape, list):
        _check_shape(value, list, place)
        for number, item in enumerate(value):
            _check_shape(item, shape[0], f"{place}[{number}]")
    elif not isinstance(value, shape) or isinstance(value, bool):
        raise DamagedFile(f"{place} is malformed")


def load_stability(path):
    """The JSON object that `plumbline stability --json` wrote. Raises DamagedFile or FileNotFoundError.

    Parts that a problem lacks, or gives as null, come back empty; numbers may be None.
    """
    stability = _json_file(path)
    if not isinstance(stability, dict) or not isinstance(stability.get("problems"), list):
        raise DamagedFile("not an output of plumbline stability: there is no list of problems")
    for number, problem in enumerate(stability["problems"]):
        place = f"problems[{number}]"
        stability["problems"][number] = problem = _filled(problem, _STABILITY_PARTS["problem"], place)
        if not isinstance(problem.get("problem"), str):
            raise DamagedFile(f"{place} has no name")
        for part, kind in (("configurations", "configuration"), ("maps", "map"), ("safe", "safe")):
            problem[part] = [
                _filled(entry, _STABILITY_PARTS[kind], f"{place}.{part}[{index}]")
                for index, entry in enumerate(problem[part])
            ]
        for index, entry in enumerate(problem["maps"]):
            _check_map(entry, f"{place}.maps[{index}]")
    stability["known_limits"] = _known_limits(stability.get("known_limits"))
    return stability


def _known_limits(lists):
    """Of each integrator its limits on all problems; empty for files from before they were written."""
    if not isinstance(lists, (list, type(None))):
        raise DamagedFile("known_limits should be a list")
    found = [
        _filled(entry, {"problems": "texts", "parameters": "object", "rows": "objects"}, f"known_limits[{number}]")
        for number, entry in enumerate(lists or [])
    ]
    for number, entry in enumerate(found):
        if not isinstance(entry.get("integrator"), str):
            raise DamagedFile(f"known_limits[{number}] has no integrator")
        if not all(isinstance(row.get("problem"), str) for row in entry["rows"]):
            raise DamagedFile(f"known_limits[{number}] has a row without a problem")
    return found


# What the parts of a document of `plumbline stability` are made of; a matrix is checked with the axes of its map.
_STABILITY_PARTS: dict[str, Any] = {
    "problem": {"configurations": "parts", "maps": "parts", "safe": "parts", "equations": "texts"},
    "configuration": {
        "settings": "object",
        "scanned": "object",
        "differences": "object",
        "smallest_known": "object",
        "orders": "object",
        "predicted": "objects",
        "observed": "objects",
        "growth": "objects",
        "observed_growth": "objects",
    },
    "map": {
        "x": "object",
        "y": "object",
        "values": "matrix",
        "closed_form": "matrix",
        "observed": "objects",
        "closed_form_curve": "objects",
    },
    "safe": {},
}
_NUMBERS = frozenset(
    "closed_form low high dt per_step steps threshold size error reach degrees_of_freedom order theory ppc limit offset "
    "regular edge edge_depth x y".split()
)


def _filled(entry, parts, place):
    """The object with all its parts there and of their kind."""
    if not isinstance(entry, dict):
        raise DamagedFile(f"{place} is no object")
    entry = dict(entry)
    for name, kind in parts.items():
        if kind == "matrix":
            continue
        value = entry.get(name)
        value = ({} if kind == "object" else []) if value is None else value
        if not isinstance(value, dict if kind == "object" else list):
            raise DamagedFile(f"{place}.{name} should be {'an object' if kind == 'object' else 'a list'}")
        for number, item in enumerate(value if kind == "objects" else []):
            _check_numbers(item, f"{place}.{name}[{number}]")
        if kind == "texts" and not all(isinstance(item, str) for item in value):
            raise DamagedFile(f"{place}.{name} should be a list of texts")
        entry[name] = value
    _check_numbers({key: value for key, value in entry.items() if key not in parts}, place)
    for name in ("scanned", "differences", "smallest_known"):
        _check_numbers(entry.get(name, {}), f"{place}.{name}")
    for name, order in entry.get("orders", {}).items():
        _check_numbers(order, f"{place}.orders.{name}")
    return entry


def _check_numbers(entry, place):
    if not isinstance(entry, dict):
        raise DamagedFile(f"{place} is no object")
    for name, value in entry.items():
        if name in _NUMBERS and not _number_or_none(value):
            raise DamagedFile(f"{place}.{name} is no number")


def _number_or_none(value):
    return value is None or (isinstance(value, (int, float)) and not isinstance(value, bool))


def _check_map(entry, place):
    """Rows and columns of the values are those of the axes."""
    for axis in ("x", "y"):
        values = entry[axis].get("values")
        if not isinstance(values, list) or not values or not all(isinstance(v, (int, float, str)) for v in values):
            raise DamagedFile(f"{place}.{axis} has no list of values")
    columns, rows = (len(entry[axis]["values"]) for axis in ("x", "y"))
    for name in ("values", "closed_form"):
        matrix = entry.get(name)
        if matrix is None and name == "closed_form":
            continue
        whole = (
            isinstance(matrix, list)
            and len(matrix) == rows
            and all(isinstance(row, list) and len(row) == columns for row in matrix)
            and all(_number_or_none(value) for row in matrix for value in row)
        )
        if not whole:
            raise DamagedFile(f"{place}.{name} is not a matrix of {rows} rows and {columns} columns of numbers")


def _json_file(path):
    try:
        return _parsed(pathlib.Path(path).read_text(encoding="utf-8"))
    except ValueError as error:
        raise DamagedFile(f"not valid JSON: {_first_line(error)}") from error


def write_csv(header, rows, target):
    """Comma-separated, a point as decimal mark, shortest digits that give the same number back."""
    if hasattr(target, "write"):
        writer = csv.writer(target, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([_cell(value) for value in row] for row in rows)
        return
    with open(target, "w", encoding="utf-8", newline="") as stream:
        write_csv(header, rows, stream)


# --- reading --------------------------------------------------------------------------------------


def _read(file, name):
    version = _format_version(file)
    kind = _text(file.attrs.get("kind"))
    if kind not in KINDS:
        raise DamagedFile(f"unknown kind of result '{kind}'")
    result = Result(kind=kind, name=name, format=version)
    setattr(result, kind, _json(file, kind, dict, required=True))
    for part, shape in (
        ("measures", dict),
        ("gates", list),
        ("provenance", dict),
        ("settings", dict),
        ("catalog", dict),
    ):
        setattr(result, part, _json(file, part, shape))
    if kind == "study":
        result.measures = _json(file, "fit", dict) or result.study.get("measures") or {}
        result.settings = result.settings or result.study.get("settings") or {}
        result.comparators = {name: _comparator(group) for name, group in _groups(file, "comparator")}
    result.ledger = {quantity: Columns(_columns(group)) for quantity, group in _groups(file, "ledger")}
    if "profile" in file:
        result.profile = _profile(file["profile"])
    if "frames" in file:
        result.frames = _frames_of_format_1(file) if version == 1 else _frames(file["frames"])
    return result


def _format_version(file):
    if "plumbline_format" not in file.attrs:
        raise DamagedFile("not a result file of Plumbline: the attribute plumbline_format is missing")
    version = int(numpy.asarray(file.attrs["plumbline_format"]).reshape(-1)[0])
    if version > FORMAT_VERSION:
        raise NewerFormat(
            f"made by a newer version: format {version}, this reader knows up to {FORMAT_VERSION}"
        )
    if version < OLDEST_FORMAT_VERSION:
        raise DamagedFile(f"format {version} is not known, the oldest known is {OLDEST_FORMAT_VERSION}")
    return version


def _json(file, part, shape, required=False):
    if part not in file:
        if required:
            raise DamagedFile(f"the part /{part} is missing")
        return shape()
    try:
        value = _parsed(_text(file[part][()]))
    except ValueError as error:
        raise DamagedFile(f"the part /{part} is not valid JSON: {_first_line(error)}") from error
    if not isinstance(value, shape):
        raise DamagedFile(f"the part /{part} should be a JSON {'object' if shape is dict else 'list'}")
    return value


def _parsed(words):
    return json.loads(words, parse_constant=_refuse_constant, object_hook=_renamed)


_FORMER_KEYS = {f"point_{name}": f"particle_{name}" for name in ("steps", "steps_per_s")}
_FORMER_VALUES = {
    "origin": {"frozen": "regression", "target": "requirement"},
    "unit": {"point" + "-steps/s": "particle-steps/s"},
}


def _renamed(entry):
    """Until 0.8: names that files of the previous version have for what has another name now."""
    entry = {_FORMER_KEYS.get(key, key): value for key, value in entry.items()}
    for key, names in _FORMER_VALUES.items():
        if isinstance(entry.get(key), str):
            entry[key] = names.get(entry[key], entry[key])
    return entry


def _refuse_constant(name):
    raise ValueError(f"{name} stands where a number or null should")


def _text(value):
    """Fixed and variable strings of HDF5 alike."""
    if isinstance(value, numpy.ndarray):
        value = value.reshape(-1)[0]
    if isinstance(value, bytes):
        return value.decode("utf-8").rstrip("\0")
    return "" if value is None else str(value)


def _groups(file, name):
    return list(file[name].items()) if name in file else []


def _columns(group):
    columns = {name: numpy.asarray(data[()], dtype=float).reshape(-1) for name, data in group.items()}
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        raise DamagedFile(f"the columns of {group.name} differ in length: {lengths}")
    return columns


def _profile(group):
    units = {name: _text(data.attrs.get("unit")) for name, data in group.items()}
    labels = {name: _text(data.attrs.get("label")) for name, data in group.items()}
    return Columns(
        _columns(group), units, labels, _text(group.attrs.get("abscissa")), _text(group.attrs.get("kind"))
    )


def _frames(group):
    described = _json(group, "description", dict, required=True)
    points = {name: group[name][()] for name in ("body", *FRAME_FIELDS)}
    return _checked_frames(described, group["time"][()], group["start"][()], points)


def _frames_of_format_1(file):
    """Format 1 kept them as VTK's format has it, all steps in one group."""
    described, data = _json(file, "frames", dict, required=True), file["VTKHDF"]
    points = {name: data[f"PointData/{name}"][()] for name in ("body", *FRAME_FIELDS) if name != "position"}
    points["position"] = data["Points"][()]
    starts = numpy.append(data["Steps/PointOffsets"][()], len(data["Points"]))
    return _checked_frames(described, data["Steps/Values"][()], starts, points)


def _checked_frames(described, times, starts, points):
    lengths = {name: len(values) for name, values in points.items()}
    whole = (
        set(lengths.values()) == {int(starts[-1])}
        and len(starts) == len(times) + 1
        and not numpy.any(numpy.diff(starts) < 0)
    )
    if not whole:
        raise DamagedFile(f"the frames do not fit their points: {lengths}")
    grid = {name: described[name] for name in ("dim", "axisymmetric", "h", "low", "high", "walls")}
    return Frames(times, described["bodies"], grid, described["units"], described["every"], points, starts)


def _comparator(group):
    return Columns(_columns(group), labels={"title": _text(group.attrs.get("title"))}, kind="comparator")


def _why_unreadable(error):
    ends = re.search(r"truncated file: eof = (\d+).*stored_eof = (\d+)", str(error))
    if ends:
        return f"truncated: {ends.group(1)} of {ends.group(2)} bytes are there"
    return f"cannot be read: {_first_line(error)}"


def _first_line(error):
    lines = str(error).splitlines()
    return lines[0] if lines else type(error).__name__


# --- tables ---------------------------------------------------------------------------------------


def _cell(value):
    if value is None:
        return ""
    if isinstance(value, (bool, numpy.bool_)):
        return "true" if value else "false"
    if isinstance(value, (float, numpy.floating)):
        return repr(float(value))
    if isinstance(value, (list, tuple)):
        return ";".join(str(_cell(item)) for item in value)
    if isinstance(value, dict):
        return json.dumps(value, sort_keys=True, ensure_ascii=False)
    return value


def gate_row(gate):
    """One gate in the order of GATE_COLUMNS."""
    expected = gate.get("expected") or {}
    low, high = gate.get("interval") or (None, None)
    flat = {
        **gate,
        "low": expected.get("low"),
        "high": expected.get("high"),
        "interval_low": low,
        "interval_high": high,
    }
    return [flat.get(column) for column in GATE_COLUMNS]


def _gates_table(result):
    return list(GATE_COLUMNS), [gate_row(gate) for gate in result.gates or result.verdicts.get("gates", [])]


def _measures_table(result):
    columns = FIT_COLUMNS if result.kind == "study" else MEASURE_COLUMNS
    rows = [
        [name] + [values.get(column) for column in columns]
        for name, values in sorted(result.measures.items())
    ]
    return ["measure", *columns], rows


def _levels_table(result):
    levels = result.study.get("levels") or []
    names = sorted({name for level in levels for name in level.get("measures") or {}})
    rows = [
        [level.get("settings", {}).get("cells")]
        + [level.get(column) for column in LEVEL_COLUMNS]
        + [(level.get("measures", {}).get(name) or {}).get("error") for name in names]
        for level in levels
    ]
    return ["cells", *LEVEL_COLUMNS, *(f"{name}.error" for name in names)], rows


def _comparators_table(result):
    names = sorted({column for columns in result.comparators.values() for column in columns})
    rows = [
        [name] + [columns[column][row] if column in columns else None for column in names]
        for name, columns in sorted(result.comparators.items())
        for row in range(len(next(iter(columns.values()), ())))
    ]
    return ["method", *names], rows


def _ledger_table(result):
    names = ["time", "step"]
    names += sorted({name for columns in result.ledger.values() for name in columns} - set(names))
    rows = [
        [quantity] + [columns[name][row] if name in columns else None for name in names]
        for quantity, columns in sorted(result.ledger.items())
        for row in range(len(next(iter(columns.values()), ())))
    ]
    return ["quantity", *names], rows


def _profile_table(result):
    first = result.profile.abscissa
    names = sorted(result.profile, key=lambda name: (name != first, name))
    return names, [list(row) for row in zip(*(result.profile[name] for name in names))]


def _pairs_table(part):
    return lambda result: (
        ["key", "value"],
        [[key, value] for key, value in sorted(getattr(result, part).items())],
    )


_TABLES = {
    "measures": _measures_table,
    "gates": _gates_table,
    "ledger": _ledger_table,
    "profile": _profile_table,
    "levels": _levels_table,
    "comparators": _comparators_table,
    "settings": _pairs_table("settings"),
    "provenance": _pairs_table("provenance"),
}


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="python -m plumbline",
        description="Shows what a result file holds, or writes one of its tables as CSV."
    )
    parser.add_argument("file", metavar="FILE")
    parser.add_argument("--csv", metavar="TABLE", choices=list(_TABLES), help=f"one of: {', '.join(_TABLES)}")
    options = parser.parse_args(arguments)
    try:
        result = load(options.file)
        if options.csv:
            result.to_csv(options.csv, sys.stdout)
        else:
            print(
                f"{result.name}: {result.kind}, format {result.format}; tables: "
                f"{', '.join(result.table_names())}"
            )
        sys.stdout.flush()
    except NotInstalled as error:
        return _complain(error, 1)
    except NoSuchTable as error:
        return _complain(error, 2)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except (ResultsError, OSError) as error:
        return _complain(f"{options.file}: {error}" if isinstance(error, ResultsError) else error, 4)
    return 0


def _complain(message, status):
    print(f"plumbline: {message}", file=sys.stderr)
    return status

