"""Which bug is shown to which judge, in which order, and what becomes of it."""

import concurrent.futures
import hashlib
import math
import time
from dataclasses import dataclass

from .judges import RED, end_with_parent, red_gates

MARKS = {"ran": "r", "unreached": "u", "not run": "n"}  # of a row's cells, a sign a column; "-": does not concern it
DRIFT = "regression"  # the origin of gates that compare with a run of the same program


@dataclass
class Column:
    """A judge, what its outcomes depend on, and whom it is for: everybody where `files` is empty."""

    judge: object
    fingerprint: str
    files: frozenset = frozenset()
    clean: object = None

    @property
    def name(self):
        return self.judge.name

    def concerns(self, mutant):
        if self.files:
            return mutant.file in self.files
        return mutant.compiled


@dataclass
class Cell:
    """What a judge made of a bug. run: "ran", "unreached" (its place is never met: the clean run, bit for bit) or "not run"."""

    run: str
    red: list
    stopped: str = ""

    @property
    def kills(self):
        return bool(self.red or self.stopped)

    @property
    def kills_beyond_drift(self):
        return bool(self.stopped) or any(gate["origin"] != DRIFT for gate in self.red)


class Matrix:
    """cells[bug, column] as far as they are known."""

    def __init__(self, mutants, columns, state, prints):
        self.mutants, self.columns, self.state, self.prints = mutants, columns, state, prints

    def fingerprint(self, mutant, column):
        return f"{column.fingerprint} {self.prints.of_mutant(mutant) if mutant else ''}".strip()

    # --- the clean program ---

    def judge_clean(self, jobs, say):
        """Every judge without any bug. Returns what is wrong with the clean program: texts, and (column, gate) that are red."""
        wanted = [c for c in self.columns if self._clean_of(c) is None]
        tasks = [(None, column) for column in wanted]
        self._run(tasks, jobs, say)
        wrong, red = [], []
        for column in self.columns:
            column.clean = self._clean_of(column)
            red += [(column, name) for name, gate in column.clean.gates.items() if gate["verdict"] in RED]
            if column.clean.stopped:
                wrong.append(f"{column.name}: {column.clean.stopped}")
            elif not column.clean.gates:
                wrong.append(f"{column.name}: no verdict")
        return wrong, red

    def _clean_of(self, column):
        """What the clean run met holds for the bugs that were there and their numbers: with others it is run again."""
        return self.state.get("", column.name, self._clean_fingerprint(column))

    def _clean_fingerprint(self, column):
        own = [f"{m.number} {self.prints.of_mutant(m)}" for m in self.mutants if column.concerns(m)]
        return f"{column.fingerprint} {self.prints_of(own)}"

    @staticmethod
    def prints_of(own):
        return hashlib.sha256(" ".join(own).encode()).hexdigest()[:16]

    # --- the bugs ---

    def cell(self, mutant, column):
        if not column.concerns(mutant):
            return None
        if self._unreached(mutant, column):
            return Cell("unreached", [])
        outcome = self.state.get(mutant.id, column.name, self.fingerprint(mutant, column))
        if outcome is None:
            return Cell("not run", [])
        return Cell("ran", [] if outcome.stopped else red_gates(column.clean, outcome), outcome.stopped)

    @staticmethod
    def _unreached(mutant, column):
        return mutant.compiled and mutant.number not in column.clean.reached

    def open_cells(self, named_only=False, dear=math.inf, killed_dear=math.inf):
        """(class of cost, ..., bug, column) still to be run, cheap ones first. dear: no column above these seconds; killed_dear: none above
        these for a bug that gates other than drift have killed already; what a bug names in `killed_by` always counts."""
        cells = []
        for mutant in self.mutants:
            killed = None
            named = {entry.get("case") or entry.get("test") for entry in mutant.killed_by}
            for column in self.columns:
                cell = self.cell(mutant, column)
                if cell is None or cell.run != "not run":
                    continue
                cost = column.clean.seconds
                if column.name not in named:
                    if named_only or cost > dear:
                        continue
                    if cost > killed_dear:
                        killed = self.killed(mutant) if killed is None else killed
                        if killed:
                            continue
                cells.append((round(2 * math.log2(max(cost, 0.1))), mutant.number, column.name, mutant, column))
        return sorted(cells, key=lambda c: c[:3])

    def killed(self, mutant):
        return any(c and c.kills_beyond_drift for c in (self.cell(mutant, column) for column in self.columns))

    def run(self, jobs, say, **selection):
        """Until no cell is open. Kills make dear cells superfluous, so the list is made anew now and then."""
        while cells := self.open_cells(**selection):
            alike = [(mutant, column) for cost, *_, mutant, column in cells if cost == cells[0][0]]
            self._run(alike[: max(jobs, 1) * 25], jobs, say, len(cells))

    def run_to_first_red(self, mutants, jobs, say):
        """Each of these bugs against one judge after the other, cheap ones first, until one sees it."""
        columns = sorted(self.columns, key=lambda c: c.clean.seconds)
        for number, column in enumerate(columns, 1):
            alive = [mutant for mutant in mutants if not self.killed(mutant)]
            tasks = [(mutant, column) for mutant in alive if (cell := self.cell(mutant, column)) and cell.run == "not run"]
            say(f"judge {number} of {len(columns)}, {column.name}: {len(tasks)} of {len(alive)} that live meet it")
            self._run(tasks, jobs, say)

    def cells_of(self, mutant):
        """[(column, Cell)] of the judges that it concerns, cheap ones first."""
        columns = sorted((c for c in self.columns if c.clean), key=lambda c: c.clean.seconds)
        return [(column, cell) for column in columns if (cell := self.cell(mutant, column)) is not None]

    def same_numbers(self, mutant):
        """Whether every case that meets the bug ran and came to the numbers of the clean program, bit for bit."""
        for column, cell in self.cells_of(mutant):
            outcome = self.state.get(mutant.id, column.name, self.fingerprint(mutant, column))
            if cell.run == "not run" or (cell.run == "ran" and outcome.gates != column.clean.gates):
                return False
        return True

    def _run(self, tasks, jobs, say, left=None):
        left = len(tasks) if left is None else left
        start = time.monotonic()

        def take(number, mutant, column, outcome):
            print_of = self.fingerprint(mutant, column) if mutant else self._clean_fingerprint(column)
            self.state.put(mutant.id if mutant else "", column.name, print_of, outcome)
            if not mutant:
                say(f"clean, {column.name}: {len(outcome.gates)} verdicts, {outcome.seconds:.1f} s {outcome.stopped}")
                return
            red = outcome.stopped or f"{len(red_gates(column.clean, outcome))} red"
            passed = time.monotonic() - start
            say(f"{left - number:5d} left  {mutant.id} x {column.name}: {red} ({outcome.seconds:.1f} s, {passed:.0f} s since)")

        if jobs <= 1:
            for number, (mutant, column) in enumerate(tasks, 1):
                take(number, mutant, column, column.judge.judge(mutant, column.clean))
            return
        with concurrent.futures.ProcessPoolExecutor(jobs, initializer=end_with_parent) as pool:
            futures = {pool.submit(column.judge.judge, mutant, column.clean): (mutant, column) for mutant, column in tasks}
            for number, future in enumerate(concurrent.futures.as_completed(futures), 1):
                take(number, *futures[future], future.result())


def verdict_on(mutant, cells):
    """"killed", "killed_by_drift_only", "survived" or "equivalent" of the cells that ran."""
    if any(cell.kills_beyond_drift for cell in cells):
        return "killed"
    if any(cell.kills for cell in cells):
        return "killed_by_drift_only"
    return "equivalent" if mutant.equivalent else "survived"


def broken_contract(matrix):
    """What a bug names in `killed_by` and does not kill it (any more)."""
    broken = []
    by_name = {column.name: column for column in matrix.columns}
    for mutant in matrix.mutants:
        for entry in mutant.killed_by:
            name = entry.get("case") or entry["test"]
            column = by_name.get(name)
            cell = matrix.cell(mutant, column) if column else None
            if cell is not None and cell.run == "not run":
                continue
            gate = entry.get("gate")
            if cell is None or not (cell.stopped or any(gate in (None, red["gate"]) for red in cell.red)):
                broken.append(f"{mutant.id} is no longer killed by {name}{', ' + gate if gate else ''}")
        if mutant.equivalent and any(c and c.kills for c in (matrix.cell(mutant, column) for column in matrix.columns)):
            broken.append(f"{mutant.id} is declared equivalent, yet something kills it")
    return broken


def named_killers(matrix, mutant, most=3):
    """The contract that a run suggests: the cheapest judges that kill, and of each one gate, drift last."""
    found = []
    for column in sorted(matrix.columns, key=lambda c: c.clean.seconds):
        cell = matrix.cell(mutant, column)
        if not cell or not cell.kills:
            continue
        gates = sorted(cell.red, key=lambda gate: gate["origin"] == DRIFT)
        entry = {"case" if column.judge.kind == "case" else "test": column.name}
        if gates:
            entry["gate"] = gates[0]["gate"]
        found.append((not cell.kills_beyond_drift, bool(cell.stopped), len(found), entry))
    return [entry for *_, entry in sorted(found, key=lambda f: f[:3])[:most]]


def document(matrix, provenance, unsteady=()):
    """What results/mutants.json holds. unsteady: (column, gate) that take no part."""
    columns = []
    for column in matrix.columns:
        clean = column.clean
        kind = "case" if column.judge.kind == "case" else "tests"
        columns.append({"name": column.name, "kind": kind, "seconds": round(clean.seconds, 2), "gates": len(clean.gates)})
    rows, counts = [], {}
    for mutant in matrix.mutants:
        cells = {c.name: matrix.cell(mutant, c) for c in matrix.columns}
        cells = {name: cell for name, cell in cells.items() if cell is not None}
        status = verdict_on(mutant, cells.values())
        counts[status] = counts.get(status, 0) + 1
        rows.append(
            {
                "id": mutant.id,
                "file": mutant.file,
                "line": mutant.line((matrix.prints.root / mutant.file).read_text(encoding="utf-8")),
                "area": mutant.area,
                "kind": mutant.kind,
                "origin": mutant.origin,
                "what": mutant.what,
                "status": status,
                "equivalent": mutant.equivalent or None,
                "must_kill": mutant.killed_by,
                "killed_by": _killers(matrix, cells, "case"),
                "tests": _killers(matrix, cells, "tests"),
                "stopped": [{"by": name, "why": cell.stopped} for name, cell in cells.items() if cell.stopped],
                "cells": "".join(MARKS[cells[c.name].run] if c.name in cells else "-" for c in matrix.columns),
            }
        )
    judged = len(rows) - counts.get("equivalent", 0)
    by_cases = sum(1 for row in rows if any(gate["origin"] != DRIFT for gate in row["killed_by"]) or _stopped_case(matrix, row))
    score = counts.get("killed", 0) / judged if judged else 0
    return {
        "version": 1,
        **provenance,
        "columns": columns,
        "mutants": rows,
        "counts": {**counts, "all": len(rows), "by_gates_of_cases": by_cases},
        "score": score,
        "broken": broken_contract(matrix),
        "unsteady": [{"case": column.name, "gate": gate} for column, gate in unsteady],
    }


def _stopped_case(matrix, row):
    cases = {column.name for column in matrix.columns if column.judge.kind == "case"}
    return any(entry["by"] in cases for entry in row["stopped"])


def _killers(matrix, cells, kind):
    name = "case" if kind == "case" else "test"
    names = [c.name for c in matrix.columns if c.judge.kind == kind and c.name in cells]
    return [{name: own, **gate} for own in names for gate in cells[own].red]
