"""What the section "Mutation testing" shows of the kill matrix that ci/mutants writes."""

import itertools

import text

DRIFT = "regression"
AREAS = {
    "kernel": "Kernel: shapes, maps, integrators, normals",
    "materials": "Materials",
    "walls": "Walls and pistons",
    "contact": "Contact",
    "references": "References",
    "estimators": "Estimators: norms, orders, gates, ledger",
    "reading": "Reading of results",
}
STATUSES = {  # how each is shown: name, colour, meaning
    "killed": ("killed", "pass", "a gate or named test that compares with theory, a reference or an identity went red"),
    "killed_by_drift_only": ("drift only", "inconclusive", "nothing but a comparison with a run of this program went red"),
    "survived": ("survived", "fail", "nothing went red"),
    "equivalent": ("equivalent", "none", "the program does the same with it, so nothing can go red; the reason is given"),
}
RAN, UNREACHED, NOT_RUN = "r", "u", "n"  # the sign of a cell in its row
MOST_NAMES = 2  # gates that a cell names


def page(document, commit=""):
    """The section's content; None without a matrix. `commit`: that of the results beside it."""
    if not document:
        return None
    columns = [_column(column, document["mutants"]) for column in document["columns"]]
    counts = document["counts"]
    judged = counts["all"] - counts.get("equivalent", 0)
    rows = document["mutants"]
    return {
        "score": f"{100 * document['score']:.1f} %",
        "judged": judged,
        "killed": counts.get("killed", 0),
        "by_cases": counts.get("by_gates_of_cases", 0),
        "by_tests": counts.get("killed", 0) - counts.get("by_gates_of_cases", 0),
        "elsewhere": bool(commit) and bool(document.get("commit")) and not commit.startswith(document["commit"][:7]),
        "page_commit": commit[:7],
        "generated": sum(row["origin"] == "generated" for row in rows),
        "all": counts["all"],
        "made": document.get("made", ""),
        "commit": document.get("commit", "")[:7] + (" with changes" if document.get("dirty") else ""),
        "tiles": [
            {"name": name, "colour": colour, "count": counts.get(status, 0), "meaning": meaning}
            for status, (name, colour, meaning) in STATUSES.items()
        ],
        "columns": columns,
        "areas": [
            {"title": title, "rows": [_row(row, columns) for row in rows if row["area"] == area]}
            for area, title in AREAS.items()
            if any(row["area"] == area for row in rows)
        ],
        "unkilled": [_reasoned(row) for row in rows if row["status"] != "killed"],
        "broken": document.get("broken", []),
        "must": _must(columns, rows),
        "bitten": sum(column["bitten"] for column in columns if column["kind"] == "case"),
        "gates": sum(column["gates"] for column in columns if column["kind"] == "case"),
        "cells": _cells(rows),
    }


def _column(column, rows):
    name = column["name"]
    gates = {gate["gate"] for row in rows for gate in row["killed_by"] + row["tests"] if _by(gate) == name}
    short = name if column["kind"] == "case" else name.rsplit("/", 1)[-1].replace("_test", "").replace("test_", "")
    return {**column, "short": short, "bitten": len(gates)}


def _by(gate):
    return gate.get("case") or gate.get("test")


def _row(row, columns):
    found = {}
    for gate in row["killed_by"] + row["tests"]:
        found.setdefault(_by(gate), []).append(gate)
    stops = {entry["by"]: entry["why"] for entry in row["stopped"]}
    name, colour, _ = STATUSES[row["status"]]
    return {
        **row,
        "place": f"{row['file']}:{row['line']}",
        "status": name,
        "colour": colour,
        "cells": _spanned(_cell(column["name"], found, stops, mark) for column, mark in zip(columns, row["cells"])),
    }


def _spanned(cells):
    """The cells of a row, neighbours that say nothing of their own as one: most cells are such."""
    spanned = []
    for look, alike in itertools.groupby(cells, key=lambda cell: cell["look"]):
        alike = list(alike)
        spanned += [{**alike[0], "span": len(alike)}] if look in ("", "open") else [{**cell, "span": 1} for cell in alike]
    return spanned


def _cell(name, found, stops, mark):
    """{look, words, hint}: what stands in a cell, and what it says when pointed at."""
    if name in stops:
        return {"look": "stop", "words": "×", "hint": f"the run did not end: {_why(stops[name])}"}
    if name in found:
        gates = found[name]
        drift = all(gate["origin"] == DRIFT for gate in gates)
        named = [f"{gate['gate']}{'' if gate['verdict'] == 'FAIL' else ' (' + gate['verdict'] + ')'}" for gate in gates[:MOST_NAMES]]
        more = f" and {len(gates) - MOST_NAMES} more" if len(gates) > MOST_NAMES else ""
        return {
            "look": "drift" if drift else "red",
            "words": str(len(gates)),
            "hint": f"{', '.join(named)}{more}",
        }
    if mark == RAN:
        return {"look": "green", "words": "0", "hint": ""}
    if mark == NOT_RUN:
        return {"look": "open", "words": "?", "hint": ""}
    return {"look": "", "words": "", "hint": ""}


def _why(stop):
    return {"time": "it took more than five times as long"}.get(stop, stop)


def _reasoned(row):
    name, colour, _ = STATUSES[row["status"]]
    gates = [f"{_by(gate)}: {gate['gate']}" for gate in row["killed_by"] + row["tests"]]
    return {
        "id": row["id"],
        "what": row["what"],
        "place": f"{row['file']}:{row['line']}",
        "status": name,
        "colour": colour,
        "reason": row["equivalent"] or (f"Only drift: {', '.join(gates[:MOST_NAMES])}" if gates else ""),
        "unmet": RAN not in row["cells"] and NOT_RUN not in row["cells"],
        "not_run": row["cells"].count(NOT_RUN),
    }


def _must(columns, rows):
    """By judge: the bugs that name it as a killer, and how many of its gates went red at all."""
    shown = []
    for column in columns:
        bugs = [row["id"] for row in rows if any(_by(entry) == column["name"] for entry in row["must_kill"])]
        shown.append({**column, "bugs": bugs})
    return shown


def _cells(rows):
    """How many cells of the table are of which sort."""
    marks = "".join(row["cells"] for row in rows)
    return {name: text.count(marks.count(mark)) for name, mark in (("ran", RAN), ("unreached", UNREACHED), ("not_run", NOT_RUN))}
