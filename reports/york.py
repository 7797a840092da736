"""Every figure and table of York 1997, SAND97-1893, with the gates that answer for it, as york.json lists them."""

import fnmatch
import json
import pathlib
import re

import tables
import york_figures

HERE = pathlib.Path(__file__).resolve().parent
LIST_FILE = HERE / "york.json"
COUNTS = {"figure": 106, "table": 13}
RESULT = "result"  # the kind of a row that gates answer for
UNJUDGED = {"sketch": "nothing is computed", "input": "the set-up of the case"}
_CITED = re.compile(r"\b(figs?\.|tables?) (\d+)((?:-| to )\d+)?(?:,? and (\d+)|, (\d+))?", re.IGNORECASE)


def load(part="rows"):
    """The rows in their order: series, number, page, kind, shows, and where they have them cases, gates, why. Or the `pictures`,
    which york_figures.py describes.
    """
    return json.loads(LIST_FILE.read_text(encoding="utf-8"))[part]


def faults(rows, gates):
    """What is wrong with the list, as sentences: [] if nothing is. `gates`: {(case, id): reason} of all that are declared."""
    found = []
    for series, count in COUNTS.items():
        numbers = [row["number"] for row in rows if row["series"] == series]
        found += [f"{series} {number} is missing" for number in range(1, count + 1) if number not in numbers]
        found += [f"{series} {number} is there twice" for number in sorted(set(numbers)) if numbers.count(number) > 1]
        found += [f"the report has no {series} {number}" for number in numbers if not 1 <= number <= count]
    cases = {case for case, _ in gates}
    answers = {}
    for row in rows:
        name = f"{row['series']} {row['number']}"
        found += [f"{name}: there is no case {case}" for case in row.get("cases", ()) if case not in cases]
        if row["kind"] not in (RESULT, *UNJUDGED):
            found.append(f"{name}: {row['kind']} is none of {', '.join((RESULT, *UNJUDGED))}")
        if row["kind"] == RESULT and not row.get("gates") and not row.get("why"):
            found.append(f"{name}: a result that no gate answers for, without a reason")
        for pattern in row.get("gates", ()):
            own = [gate for gate in gates if _matches(gate, pattern)]
            answers.setdefault((row["series"], row["number"]), set()).update(own)
            if not own:
                found.append(f"{name}: there is no gate {' '.join(pattern)}")
    for gate, reason in gates.items():
        for cited in cited_in(reason) if gate[0] in _cases_of(rows) else ():
            if gate not in answers.get(cited, ()):
                found.append(f"{' '.join(gate)} cites {cited[0]} {cited[1]}, which does not name it")
    return found


def cited_in(reason):
    """The figures and tables that words name: [(series, number)]."""
    found = []
    for word, first, until, also, listed in _CITED.findall(reason):
        series = "figure" if word.lower().startswith("fig") else "table"
        last = int(re.sub(r"\D", "", until)) if until else int(first)
        found += [(series, number) for number in range(int(first), last + 1)]
        found += [(series, int(other)) for other in (also, listed) if other]
    return found


def page(cases, results):
    """What the page shows: rows with the gates of these results that answer for each, and pictures; None where no case of the
    list is there.
    """
    rows = load()
    known = {(name, gate["id"]): gate for name, case in cases.items() for gate in case.all_gates if gate.get("id")}
    if not set(cases) & _cases_of(rows):
        return None
    drawn = _pictures(rows, cases, results)
    shown = [{**_row(row, cases, known), **drawn.get((row["series"], row["number"]), {})} for row in rows]
    results = [row for row in shown if row["kind"] == RESULT]
    return {
        "rows": shown,
        "unjudged": UNJUDGED,
        "results": len(results),
        "answered": sum(bool(row["patterns"]) for row in results),
        "pictures": [row["picture"] for row in shown if row.get("picture")],
    }


def _pictures(rows, cases, results):
    """{(series, number): {picture, picture_anchor, no_picture: why there is none}} of the figures that have an entry."""
    shows = {row["number"]: row["shows"] for row in rows if row["series"] == "figure"}
    drawn = {}
    for entry in load("pictures"):
        number = entry["figure"]
        picture, why = None, entry.get("why", "")
        if not why:
            try:
                picture, why = york_figures.drawing(entry, f"Figure {number}: {shows[number]}", cases, results)
            except york_figures.UnknownName as error:
                why = str(error)
        drawn["figure", number] = {"picture": picture, "picture_anchor": york_figures.anchor(number), "no_picture": why}
    return drawn


def _row(row, cases, known):
    gates = [
        tables.gate_row(known[gate])
        for pattern in row.get("gates", ())
        for gate in sorted(known)
        if _matches(gate, pattern)
    ]
    return {
        "name": f"{row['series'].capitalize()} {row['number']}",
        "page": row["page"],
        "kind": row["kind"],
        "shows": row["shows"],
        "why": row.get("why", ""),
        "patterns": [" ".join(pattern) for pattern in row.get("gates", ())],
        "gates": gates,
        "cases": [{"name": name, "here": name in cases} for name in row.get("cases", ())],
    }


def _cases_of(rows):
    return {case for row in rows for case in row.get("cases", ())}


def _matches(gate, pattern):
    return gate[0] == pattern[0] and fnmatch.fnmatchcase(gate[1], pattern[1])
