"""Integrators as judged: what the section "Integrators" shows of their scorecards, and a card as a page of its own.

    python scorecards.py results/scorecard-NAME.json CARD.html

A scorecard is what `plumbline verify --integrator NAME` writes. Verdicts, limits and factors are shown as it states them; nothing
is judged again. The page of a card needs no network and no second file. Exit status: 0; 2 wrong call; 4 the card or the output cannot
be used.
"""

import argparse
import pathlib
import re
import sys

import frame
from plumbline import reader
import reproduce
import stability
import svg
import tables
import text
from cost_estimates import spread
from figures import Figure, Key, log_axis
from plumbline.reader import JUDGES_FILE

EFFORTS = {"core": "core set of gates", "whole": "whole set of gates"}
CLASSES = {  # of ci/judges: how they are called, what is expected of them, and whether one meets that
    "wrong": ("wrong", "red by a gate beyond the identities, which hold for wrong physics too", lambda row: row["proven"]),
    "weak": ("weakly unstable", "red by a gate of stability", lambda row: row["gate"]["family"] == "stability"),
    "right": (
        "right",
        "green, with the order and limit that are known",
        lambda row: row["verdict"] == "green" and all(entry["agrees"] for entry in row["known"]),
    ),
}
MOST_TICKS = 3  # along the lower side of a panel of half the width
MOST_ROWS = 60  # of changed stages in a table; all are in the file
LIMIT_COLUMNS = ("integrator", "problem", "choices", "unit", "limit", "endless", "closed_form", "growth", "smallest", "note")
COST_COLUMNS = ("integrator", "case", "measure", "cells", "error", "particle_steps", "wall_median", "wall_least", "wall_most", "note")
FACTOR_COLUMNS = ("integrator", "against", "case", "factor", "low", "high", "note")
FAMILY_COLUMNS = ("integrator", "family", "claimed", "measured", "verdict", "gates", "red")


def page(cards, judges):
    """The section's content; None without any."""
    if not cards and not judges:
        return None
    shown = [card_page(card) for card in cards]
    return {
        "cards": shown,
        "green": sum(not card["red"] for card in shown),
        "judges": judges_page(judges),
    }


def card_page(card):
    """What is shown of one card."""
    limits = _limit_rows(card)
    anchor = svg.identifier(pathlib.Path(card["file"]).stem)
    red = [name for row in card["families"] for name in row["red"]]
    gates = [{**gate, "anchor": f"gate-{anchor}-{svg.identifier(gate['id'])}"} for gate in card["gates"]]
    return {
        "anchor": anchor,
        "name": card["integrator"],
        "title": card["title"],
        "source": card["source"],
        "parameters": ", ".join(f"{name} = {text.exact(value)}" for name, value in card["parameters"].items()),
        "sentence": _words(card["sentence"]),
        "verdict": card["verdict"],
        "effort": EFFORTS.get(card["effort"], card["effort"]),
        "gates": sum(row["gates"] or 0 for row in card["families"]),
        "red": red,
        "against": card["against"]["integrator"] if card["against"] else "",
        "families": _family_rows(card, gates),
        **{row["family"]: row for row in _family_rows(card, gates) if row["family"] in ("order", "stability", "energy")},
        "smallest": next((_limit_words(row) for row in card["limits"] if row["smallest"]), ""),
        "next": _next(card, gates, red),
        "limits": limits,
        "limit_notes": any(row["growth"] or row["note"] for row in limits),
        "no_limits": _without_limits(card),
        "factor_notes": any(row["note"] for row in card["factors"]),
        "factor": _factor(card["factor"]) if card["factor"] else None,
        "factors": [{**_factor(row), "measure": _measure(card, row["case"])} for row in card["factors"]],
        "figures": frame.ready([cost_figure(card, f"{anchor}-cost")], reproduce.scorecard(card)),
        "missing": _missing(card),
        "groups": _gate_groups(card, gates),
        "file": card["file"],
        "command": reproduce.scorecard(card),
    }


# --- the table by family --------------------------------------------------------------------------


def _words(words):
    """What the program writes in letters of a terminal, with the signs of this page."""
    words = re.sub(r"\d+(?:\.\d+)?e[+-]\d+", lambda found: text.number(float(found[0])), words)
    return words.replace("/omega", "/ω").replace("->", "→")


def _family_rows(card, gates):
    anchors = {gate["id"]: gate["anchor"] for gate in gates}
    other = card["against"] or {"families": []}
    return [
        {
            **row,
            **{name: _words(row[name]) for name in ("claimed", "measured")},
            "count": text.count(row["gates"]),
            "other": _words(next((entry["measured"] for entry in other["families"] if entry["family"] == row["family"]), "")),
            "red": [{"id": name, "anchor": anchors.get(name, "")} for name in row["red"]],
        }
        for row in card["families"]
    ]


def _next(card, gates, red):
    """Red gates with what usually causes it, those of one cause together: [{gates: rows, cause}]."""
    causes = {}
    for gate in gates:
        if gate["id"] in red:
            causes.setdefault(gate["explanation"], []).append(tables.gate_row(gate))
    found = [{"cause": cause, "gates": rows} for cause, rows in causes.items()]
    return found or ([{"cause": card["next"], "gates": []}] if card["next"] else [])


# --- limits ---------------------------------------------------------------------------------------


def _has_limit(row):
    return row["endless"] or row["limit"] is not None


def _limit(row):
    if row["endless"]:
        return "no limit"
    return "no stable step" if row["limit"] == 0 else f"{text.number(row['limit'], 5)} {stability.unit(row['unit'])}"


def _limit_words(row):
    """'0.7513 h/c on plane (linear flip, ppc 1)'."""
    return f"{_limit(row)} on {_problem(row)}"


def _problem(row):
    return f"{row['problem']} ({row['choices']})" if row["choices"] else row["problem"]


def _limit_rows(card):
    """The problems with a limit, in the order of the card: the smallest first."""
    others = {(row["problem"], row["choices"]): row for row in card["against"]["limits"]} if card["against"] else {}
    rows = []
    for row in card["limits"]:
        if not _has_limit(row):
            continue
        other = others.get((row["problem"], row["choices"]))
        rows.append(
            {
                **row,
                "limit": _limit(row),
                "closed": text.number(row["closed_form"], 5),
                "other": _limit(other) if other and _has_limit(other) else text.MISSING,
                "growth": text.number(row["growth"], 6) if row["growth"] is not None else "",
            }
        )
    return rows


def _without_limits(card):
    """[{problems, note}] of those of which no limit is known."""
    found = {}
    for row in card["limits"]:
        if not _has_limit(row):
            found.setdefault(row["note"], []).append(_problem(row))
    return [{"problems": text.listing(dict.fromkeys(problems)), "note": note} for note, problems in found.items()]


# --- cost -----------------------------------------------------------------------------------------


def _factor(row):
    ends = text.interval((row["low"], row["high"])) if row["factor"] is not None else ""
    return {"case": row["case"], "factor": text.number(row["factor"]), "interval": ends, "note": row["note"]}


def _measure(card, case):
    return next((curve["measure"] for curve in card["cost"] if curve["case"] == case), "")


def _points(curve):
    """[(cells, error, seconds of each repetition)] of the levels that can be drawn."""
    return [
        (level["cells"], level["error"], [time for time in level["wall_s"] if time])
        for level in curve["levels"]
        if (level["error"] or 0) > 0 and any(level["wall_s"])
    ]


def cost_figure(card, prefix):
    """Error over seconds of both integrators, one panel a case; None where nothing was timed."""
    other = card["against"] or {"integrator": "", "cost": []}
    panels = []
    for curve in card["cost"]:
        theirs = next((entry for entry in other["cost"] if entry["case"] == curve["case"]), {"levels": []})
        lines = [(card["integrator"], _points(curve)), (other["integrator"], _points(theirs))]
        if any(points for _, points in lines):
            panels.append((curve, [(number, name, points) for number, (name, points) in enumerate(lines) if points]))
    if not panels:
        return None
    factors = {row["case"]: _factor(row) for row in card["factors"] if row["factor"] is not None}
    columns = min(2, len(panels))
    rows = -(-len(panels) // columns)

    def paint(axes):
        for place in axes.flat[len(panels) :]:
            place.set_axis_off()
        for place, (curve, lines) in zip(axes.flat, panels):
            for number, name, points in lines:
                _cost_line(place, number, name, points)
            _cost_axes(place, curve, [point for _, _, points in lines for point in points])
            factor = factors.get(curve["case"])
            place.set_title(curve["case"] + (f": {factor['factor']} {factor['interval']}" if factor else ""), fontsize=8)

    drawn = {number: name for _, lines in panels for number, name, _ in lines}
    drawing = svg.draw(
        paint, prefix, f"Error over time of {text.listing(drawn.values())}, by case", height=0.2 + 1.9 * rows, nrows=rows,
        ncols=columns, squeeze=False,
    )  # fmt: skip
    caption = (
        "Lower and further left is better. Marks are meshes, at the median of repeated timings in turns on one thread; bars reach "
        "from the shortest to the longest."
        + (f" Above each: cost at equal error over that of {other['integrator']}, with its interval." if factors else "")
    )
    keys = [Key(name, f"var(--s{number + 1})", svg.series_mark(number)) for number, name in drawn.items()]
    return Figure(drawing, "Error over wall time, by case", caption, [card["file"]], keys)


def _cost_line(place, number, name, points):
    colour = svg.series_colour(number)
    middle, least, most = zip(*(spread(times) for _, _, times in points))
    below, above = ([abs(end - value) for end, value in zip(ends, middle)] for ends in (least, most))
    bars = place.errorbar(
        middle, [error for _, error, _ in points], xerr=(below, above), fmt=svg.series_mark(number) + "-", color=colour,
        linewidth=0.9, elinewidth=0.8, markersize=3.5,
    )  # fmt: skip
    bars[0].set_label(name)
    svg.note(bars[0], [f"{text.count(cells)} cells" for cells, _, _ in points])


def _cost_axes(place, curve, points):
    times, errors = [time for _, _, times in points for time in times], [error for _, error, _ in points]
    place.set(xscale="log", yscale="log", xlabel="wall time in s", ylabel=f"error of {curve['measure']}")
    place.set(xlim=(min(times) / 1.6, 1.6 * max(times)), ylim=(min(errors) / 1.6, 1.6 * max(errors)))
    log_axis(place.xaxis, *place.get_xlim(), most=MOST_TICKS)
    log_axis(place.yaxis, *place.get_ylim(), most=MOST_TICKS + 1)


# --- gates ----------------------------------------------------------------------------------------


def _missing(card):
    """What could not be judged, by what is missing: [{what, count, lacks: [{trait, why}]}]."""
    found = {}
    for entry in card["not_applicable"]:
        lacks = tuple((lack["trait"], lack["why"]) for lack in entry["missing"])
        found.setdefault(lacks, []).append(entry["what"])
    return [
        {"what": text.listing(_places(names)), "count": len(names), "lacks": [{"trait": trait, "why": why} for trait, why in lacks]}
        for lacks, names in found.items()
    ]


def _places(names):
    """Identifiers of gates, those that differ in their last part alone as one."""
    above = [name.rpartition("/")[0] for name in names]
    return list(dict.fromkeys(place if above.count(place) > 1 and "/" in place else name for name, place in zip(names, above)))


def _gate_groups(card, gates):
    """The gates by family, red ones first; identities that hold as one line."""
    names = [row["family"] for row in card["families"]]
    names += sorted({gate["study"] for gate in gates} - set(names))
    groups = []
    for name in names:
        own = [gate for gate in gates if gate["study"] == name]
        if own:
            rows, identities = tables.split_identities(own)
            groups.append({"family": name or "others", "count": len(own), "rows": rows, "identities": _identities(own, identities)})
    return groups


def _identities(gates, folded):
    """One line on identities that hold: how often each, and the one that is nearest to its bound."""
    if not folded:
        return None
    held = {row["id"] for row in folded}
    counts = {}
    for name in held:
        last = name.rpartition("/")[2]
        counts[last] = counts.get(last, 0) + 1
    margins = [(gate["margin"], gate["id"]) for gate in gates if gate["id"] in held and gate["margin"] is not None]
    return {
        "count": len(folded),
        "names": ", ".join(f"{name} ({count})" if count > 1 else name for name, count in sorted(counts.items())),
        "margin": text.number(min(margins)[0], 2) if margins else "",
        "nearest": min(margins)[1] if margins else "",
    }


# --- proof that the gates judge -------------------------------------------------------------------


def judges_page(document):
    """What is shown of integrators that are known to be wrong, weakly unstable or right; None without."""
    if not document:
        return None
    classes = []
    for name, (words, expected, meets) in CLASSES.items():
        rows = sorted(document[name], key=meets)  # those that are not as expected first
        if rows:
            met = sum(map(meets, rows))
            classes.append({"name": name, "words": words, "met": met, "expected": expected, "rows": [_judged_row(row, name, meets(row)) for row in rows]})
    changes = document["systematic"]["changes"]
    kinds = [kind for kind in ("strain", "force", "motion") if any(row[kind] is not None for row in document["smallest"])]
    return {
        "classes": classes,
        "stages": [
            {"stage": stage, **{name: text.count(counts[name]) for name in counts}}
            for stage, counts in document["systematic"]["stages"].items()
        ],
        "changes": len(changes),
        "survived": [row for row in changes if row["status"] == "survived"][:MOST_ROWS],
        "equivalent": [row for row in changes if row["status"] == "equivalent"][:MOST_ROWS],
        "kinds": kinds,
        "smallest": [
            {"gate": row["gate"], "sizes": [text.number(row[kind]) for kind in kinds]} for row in document["smallest"]
        ],
        "made": document["made"],
        "commit": document["commit"][:7] + (" with changes" if document["dirty"] else ""),
        "file": JUDGES_FILE,
    }


def _found(row, name, met):
    """(word, colour) of what was made of an integrator of this class, `met`: what is expected."""
    if row["verdict"] == "stopped":
        return "stopped", "invalid"
    if name == "right":
        return (row["verdict"], "pass" if met else "fail") if met or row["verdict"] != "green" else ("differs", "fail")
    if met:
        return "seen", "pass"
    return ("other gate", "inconclusive") if row["verdict"] == "red" else ("not seen", "fail")


def _judged_row(row, name, met):
    gate = row["gate"]
    word, look = _found(row, name, met)
    return {
        **row,
        "found": word,
        "look": look,
        "gate": gate["id"],
        "family": gate["family"],
        "measured": text.measured(gate["measured"], gate["expected"]),
        "expected": text.expected(gate["expected"]),
        "margin": text.number(gate["margin"], 2),
        "known": [
            {**entry, "known": text.number(entry["known"], 5), "measured": text.number(entry["measured"], 5)} for entry in row["known"]
        ],
    }


# --- CSV ------------------------------------------------------------------------------------------


def csv_tables(cards):
    """{name: (columns, rows)}; nothing without cards."""
    if not cards:
        return {}
    return {
        "integrators": (FAMILY_COLUMNS, [[card["integrator"], *_picked(row, FAMILY_COLUMNS[1:])] for card in cards for row in card["families"]]),
        "integrator-gates": (
            ("integrator", *reader.GATE_COLUMNS),
            [[card["integrator"], *reader.gate_row(gate)] for card in cards for gate in card["gates"]],
        ),
        "integrator-limits": (LIMIT_COLUMNS, [[card["integrator"], *_picked(row, LIMIT_COLUMNS[1:])] for card in cards for row in card["limits"]]),
        "integrator-costs": (COST_COLUMNS, [row for card in cards for row in _cost_rows(card)]),
        "integrator-factors": (
            FACTOR_COLUMNS,
            [
                [card["integrator"], (card["against"] or {}).get("integrator"), *_picked(row, FACTOR_COLUMNS[2:])]
                for card in cards
                for row in card["factors"]
            ],
        ),
    }


def _picked(row, columns):
    return [row[column] for column in columns]


def _cost_rows(card):
    for curve in card["cost"]:
        if not curve["levels"]:
            yield [card["integrator"], curve["case"], curve["measure"], *(None,) * 6, curve["note"]]
        for level in curve["levels"]:
            times = [time for time in level["wall_s"] if time is not None]
            seconds = spread(times) if times else (None,) * 3
            yield [
                card["integrator"], curve["case"], curve["measure"], level["cells"], level["error"], level["particle_steps"], *seconds,
                curve["note"],
            ]  # fmt: skip


# --- command line ---------------------------------------------------------------------------------


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Makes one self-contained HTML page from the scorecard of an integrator.")
    parser.add_argument("card", metavar="SCORECARD.json")
    parser.add_argument("output", metavar="CARD.html")
    options = parser.parse_args(arguments)
    try:
        card = reader.load_scorecard(options.card)
        frame.write_whole(pathlib.Path(options.output), frame.page("card.html", card=card_page(card)))
    except reader.ResultsError as error:
        print(f"scorecards: {options.card}: {error}", file=sys.stderr)
        return 4
    except OSError as error:
        print(f"scorecards: {error}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
