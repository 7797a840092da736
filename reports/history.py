"""What the results of each commit and machine were, as lines of JSON, and how the newest compare with earlier ones.

    python history.py RESULTS_DIR HISTORY.jsonl --tier quick

appends one line; a line of the same commit, machine and tier is replaced, so that a repeated report counts once. Exit status: 0; 4 the
results or the file cannot be used. Times are kept and drawn, never judged: they depend on what else the machine does.
"""

import argparse
import json
import os
import pathlib
import statistics
import sys
from collections import Counter

import order_change
import text
from cases import newest_gates
from plumbline import reader

HISTORY_FILE = "history.jsonl"
KEY = ("commit", "machine", "tier")
PARTS = ("orders", "constants", "limits", "cost", "verdicts")
CHANGES = ("worse", "inconclusive", "better", "new", "missing")
# What counts as a change, as for `plumbline diff`; for orders see order_change.py.
CONSTANT_CHANGE = 0.01
LIMIT_CHANGE = 1e-4
MOST_EARLIER = 30  # entries that the page compares with
RED = ("FAIL", "INVALID", "XPASS", "INCONCLUSIVE")


def entry(folder, tier):
    """The line of a results folder. Raises ResultsError where no file states the commit."""
    stated = [result.provenance for result in (*folder.verdicts, *folder.studies, *folder.runs) if result.provenance.get("git")]
    if not stated:
        raise reader.ResultsError("no result file states the commit it was made from")
    newest = max(stated, key=lambda provenance: provenance.get("started") or "")
    studies = [result.study for result in folder.studies]
    found = {
        "commit": newest["git"] + ("+" if newest.get("dirty") else ""),
        "machine": newest.get("cpu") or "",
        "tier": tier,
        "started": newest.get("started") or "",
        "orders": {},
        "constants": {},
        "errors": {},  # of the levels that entered each order
        "limits": {},
        "cost": {},
        "verdicts": dict(Counter(gate.get("verdict") or "" for gate in newest_gates(folder))),
    }
    for study in studies:
        where = [study.get(part) for part in ("case", "scheme", "id", "vary", "title")]
        where = [part for place, part in enumerate(where) if part and (place < 4 or not study.get("id"))]
        for measure, fit in (study.get("measures") or {}).items():
            name = " · ".join(str(part) for part in (*where, measure))
            if fit.get("asymptotic") and fit.get("order") is not None:
                name = _untaken(name, found["orders"])
                found["orders"][name] = [fit.get(key) for key in ("order", "order_low", "order_high")]
                found["constants"][name] = fit.get("constant")
                found["errors"][name] = _errors(study, measure, fit)
    for listed in folder.stability.get("known_limits") or []:
        for row in listed["rows"]:
            if row.get("limit") is not None:
                found["limits"][" · ".join(str(part) for part in (listed["integrator"], row["problem"], row.get("choices")))] = row["limit"]
    for run in folder.cost.get("runs") or []:
        name = f"{run['case']} · {run['scheme']}"
        found["cost"][name] = found["cost"].get(name, 0.0) + statistics.median(run["wall_s"])
    return found


def _errors(study, measure, fit):
    """[[cell size, error], ...] of the levels that the fit uses, with ten digits."""
    levels = study.get("levels") or []
    used = fit.get("levels_used") or [True] * len(levels)
    pairs = [(level.get("h"), ((level.get("measures") or {}).get(measure) or {}).get("error")) for level, enters in zip(levels, used) if enters]
    return [[float(f"{number:.10g}") for number in pair] for pair in pairs if all(pair)]


def _untaken(name, taken):
    """Studies that differ in settings alone are numbered, in the order of their files, which follows from the settings."""
    return next(full for full in (name, *(f"{name} ({number})" for number in range(2, len(taken) + 3))) if full not in taken)


def read(path):
    """Entries, oldest first, and notes on lines that cannot be used. A file that is not there has none."""
    path = pathlib.Path(path)
    parts = _parts(path)
    notes = [f"line {number} of {path.name} is damaged: it is kept and not used" for number, _, found in parts if found is None]
    return [found for _, _, found in parts if found], notes


def _parts(path):
    """[(number, line, its entry or None)] of the file; an empty line is none."""
    lines = path.read_bytes().split(b"\n") if path.exists() else ()
    return [(number, line, _entry_of(line)) for number, line in enumerate(lines, 1) if line.strip()]


def _entry_of(line):
    try:
        found = json.loads(line)
    except ValueError:
        return None
    return found if _is_whole(found) else None


def _is_whole(found):
    if not isinstance(found, dict) or not all(isinstance(found.get(key), str) for key in (*KEY, "started")):
        return False
    if not all(isinstance(found.get(part), dict) for part in PARTS):
        return False
    errors = found.get("errors", {})
    if not isinstance(errors, dict) or not all(_is_list_of_pairs(pairs) for pairs in errors.values()):
        return False
    numbers = [value for part in PARTS[1:] for value in found[part].values()]
    triples = found["orders"].values()
    return all(_is_number(value) for value in numbers) and all(
        isinstance(order, list) and len(order) == 3 and all(map(_is_number, order)) for order in triples
    )


def _is_list_of_pairs(pairs):
    return isinstance(pairs, list) and all(isinstance(pair, list) and len(pair) == 2 and all(type(n) in (int, float) for n in pair) for pair in pairs)


def _is_number(value):
    return value is None or (isinstance(value, (int, float)) and not isinstance(value, bool))


def append(path, new):
    """Writes the entry at the end in place of one of the same key; damaged lines, which the notes name, stay. Whole or not at all."""
    path = pathlib.Path(path)
    _, notes = read(path)
    kept = [line for _, line, found in _parts(path) if found is None or any(found[key] != new[key] for key in KEY)]
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(path.name + ".new")
    temporary.write_bytes(b"".join(line + b"\n" for line in (*kept, json.dumps(new).encode())))
    os.replace(temporary, path)
    return notes


def compare(before, after):
    """{change: rows} of CHANGES; what moved within the noise is counted under `same`."""
    changes = {**{change: [] for change in CHANGES}, "same": 0}

    def order(name, old, new):
        return order_change.change(old, new, *(found.get("errors", {}).get(name, ()) for found in (before, after)))

    for part, judge in (("orders", order), ("constants", _constant), ("limits", _limit), ("verdicts", _verdicts)):
        for name in sorted(before[part].keys() | after[part].keys()):
            old, new = before[part].get(name), after[part].get(name)
            if part == "verdicts":
                old, new = old or 0, new or 0
            change = ("new" if old is None else "missing") if (old is None) != (new is None) else "same" if old is None else judge(name, old, new)
            if change == "same":
                changes["same"] += 1
            else:
                changes[change].append({"kind": part, "name": name, "before": _value(old), "after": _value(new)})
    return changes


def _constant(_, old, new):
    if abs(new - old) <= CONSTANT_CHANGE * abs(old):
        return "same"
    return "better" if new < old else "worse"


def _limit(_, old, new):
    if abs(new - old) <= LIMIT_CHANGE * abs(old):
        return "same"
    return "better" if new > old else "worse"


def _verdicts(name, old, new):
    """More missed gates are worse; the number of the others depends on how many there are."""
    if name not in RED or old == new:
        return "same"
    return "worse" if new > old else "better"


def _value(value):
    if isinstance(value, list):
        value = value[0]
    return text.number(value, 4) if value is not None else text.MISSING


def section(path):
    """What the page says of the file at this path; None where it has no entry."""
    entries, notes = read(path)
    if not entries:
        return {"notes": notes, "now": None} if notes else None
    now = entries[-1]
    same_kind = [found for found in entries[:-1] if (found["machine"], found["tier"]) == (now["machine"], now["tier"])]
    earlier = (same_kind or [found for found in entries[:-1] if found["tier"] == now["tier"]])[: -MOST_EARLIER - 1 : -1]
    return {
        "notes": notes,
        "now": now,
        "changes": CHANGES,
        "comparisons": [{"entry": found, "changes": compare(found, now)} for found in earlier],
        "lines": lines([*reversed(earlier), now]),
    }


def lines(entries):
    """[{title, rows}] by case, or by integrator for limits: a row with a sparkline for each quantity that is in at least two entries."""
    groups = {}
    for part in ("orders", "constants", "limits", "cost"):
        for name in sorted(entries[-1][part]):
            values = [found[part].get(name) for found in entries]
            values = [value[0] if isinstance(value, list) else value for value in values]
            known = [value for value in values if value is not None]
            if len(known) > 1:
                title, _, rest = name.partition(" · ")
                groups.setdefault(title, []).append({"kind": part, "name": rest or title, "first": _value(known[0]), "last": _value(known[-1]), "points": sparkline(values)})
    return [{"title": title, "rows": groups[title]} for title in sorted(groups)]


def sparkline(values, width=90, height=18):
    """Points of a polyline; entries without a value are left out."""
    known = [(number, value) for number, value in enumerate(values) if value is not None]
    low, high = min(value for _, value in known), max(value for _, value in known)
    scale = (height - 2) / (high - low) if high > low else 0
    step = width / (len(values) - 1)
    middle = height / 2 if high == low else height - 1
    return " ".join(f"{number * step:.1f},{middle - (value - low) * scale:.1f}" for number, value in known)


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Appends what a results folder holds to a history of JSON lines.")
    parser.add_argument("results", metavar="RESULTS_DIR")
    parser.add_argument("history", metavar="HISTORY.jsonl")
    parser.add_argument("--tier", default="quick", choices=("quick", "full"))
    options = parser.parse_args(arguments)
    try:
        notes = append(options.history, entry(reader.load_folder(options.results), options.tier))
    except (OSError, reader.ResultsError) as error:
        print(f"history: {error}", file=sys.stderr)
        return 4
    for note in notes:
        print(f"history: {note}", file=sys.stderr)
    return 0


if __name__ == "__main__":
    sys.exit(main())
