"""Stability, from the document of `plumbline stability`: safe Courant numbers, limits, growth, maps and orders.

Limits are those that the document states; the page compares them with each other and judges nothing.
"""

import collections
import decimal
import json
import math
import re

import numpy
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator

import maps
import reproduce
import svg
import text
from figures import MOST_SERIES, Figure, Key, plain_axis, tick
from plumbline.reader import STABILITY_FILE

CASE_PREFIX = "stability-"
MOST_ROWS = 24  # of a table of configurations that is shown unfolded
MOST_LINES = 4  # of one panel of growth
MOST_PANELS = 6
MOST_RINGS = 16  # of one line: growth that runs showed; all are in the document
FEW_MAPS = 12  # that are shown unfolded
MOST_MAPS = 10  # of a shape; where there are more, those of one transfer are drawn
DRAWN_TRANSFER = "flip"  # that one, where it is there: the transfer of most codes
EDGE_COLLAPSE = 0.5  # a free edge is named apart where its limit is less than this share of that inside
STEADY_RANGE = 10  # times the smallest step, over which growth of a power of the step is told from rounding
STEADY_POWERS = (0.8, 6)  # rounding of a double eigenvalue goes as the root of the step at most; a limit is a jump
UNITS = {"1/omega": "1/ω"}
COMMON_UNIT = "h/c"  # in which limits of different problems are compared
SAME = 1e-3  # relative: limits in tables are not found as finely as those of single problems
_FIRST_CHOICES = ("shape", "transfer", "ppc", "N")
CONFIGURATION_COLUMNS = (
    "problem",
    "integrator",
    "settings",
    "unit",
    "predicted",
    "closed_form",
    "observed",
    "always",
    "smallest_step",
    "growth_at_smallest_step",
    "threshold",
    "difference_size",
    "difference_error",
    "reach",
    "degrees_of_freedom",
    "sampled",
    "smallest_known",
    "smallest_known_problem",
    "smallest_known_choices",
)
KNOWN_COLUMNS = (
    "integrator",
    "parameters",
    "problem",
    "choices",
    "unit",
    "limit",
    "endless",
    "closed_form",
    "growth",
    "smallest",
    "note",
)
SAFE_COLUMNS = (
    "problem",
    "integrator",
    "shape",
    "transfer",
    "ppc",
    "limit",
    "offset",
    "regular",
    "edge",
    "edge_depth",
    "always",
)
ORDER_COLUMNS = ("problem", "integrator", "settings", "quantity", "order", "low", "high", "theory")


def page(stability, verdicts):
    """What the template shows beside the figures; `verdicts`: {problem: row of its case} of those judged."""
    anchors = _anchors(stability["problems"])
    problems = [_problem(problem, name) for problem, name in zip(stability["problems"], anchors)]
    for problem in problems:
        problem["verdict"] = verdicts.get(problem["name"])
    safe = _safe(stability)
    return {
        "verdicts": list(verdicts.values()),
        "known": sorted(
            (_known_row(entry) for entry in stability.get("known_limits") or []), key=lambda row: (row["least"], row["integrator"])
        ),
        "known_problems": text.listing(_known_problems(stability)),
        "safe": safe,
        "lead": _lead(safe["rows"]),
        "explain": any(problem["rows"] for problem in problems),
        "problems": problems,
        "orders": [row for problem in stability["problems"] for row in _order_rows(problem)],
        "file": STABILITY_FILE,
        "command": (stability.get("provenance") or {}).get("command") or "",
    }


def _anchors(problems):
    """An identifier of each problem; of equal names the later ones get a number."""
    found = []
    for problem in problems:
        name = "stability-" + (re.sub(r"[^A-Za-z0-9_-]+", "-", problem["problem"]) or "unnamed")
        found.append(f"{name}-{found.count(name) + 1}" if name in found else name)
    return found


def unit(name):
    return UNITS.get(name, name or "")


# --- the known limits of each integrator ----------------------------------------------------------


def _known_problems(stability):
    names = [name for entry in stability.get("known_limits") or [] for name in entry["problems"]]
    return list(dict.fromkeys(names))


def _known_row(entry):
    """One integrator: its smallest limit and on which problem, then all others; what has no limit stands apart."""
    rows = entry["rows"]
    comparable = [row for row in rows if row.get("unit") == COMMON_UNIT]
    smallest = next((row for row in comparable if row.get("smallest")), None)
    limits = [row for row in comparable if row is not smallest and row.get("limit")]
    return {
        "integrator": entry["integrator"],
        "parameters": ", ".join(f"{key} {text.exact(value)}" for key, value in entry["parameters"].items()),
        "smallest": floored(smallest["limit"]) if smallest else "",
        "least": smallest["limit"] if smallest and smallest["limit"] is not None else math.inf,
        "command": reproduce.limit(entry["integrator"], smallest["problem"]) if smallest else "",
        "problem": _where_known(smallest) if smallest else "",
        "others": [f"{floored(row['limit'])} on {_where_known(row)}" for row in limits],
        "endless": [_where_known(row) for row in comparable if row.get("endless")],
        "growing": [_where_known(row) for row in comparable if row.get("limit") == 0],
        "unknown": [
            {"where": row["problem"], "why": row.get("note") or ""}
            for row in rows
            if row.get("limit") is None and not row.get("endless")
        ],
        "apart": [_apart(row) for row in rows if row.get("unit") != COMMON_UNIT and not row.get("note")],
    }


def _where_known(row):
    return row["problem"] + (f" ({row['choices']})" if row.get("choices") else "")


def _apart(row):
    """A limit in another unit than h/c."""
    if row.get("endless"):
        return f"{row['problem']}: every step scanned is stable"
    if row.get("limit") == 0:
        return f"{row['problem']}: no stable step"
    return f"{row['problem']}: {text.number(row.get('limit'), 5)} {unit(row.get('unit'))}"


def smallest_in_words(smallest, own=None):
    """Whether a limit is the smallest known of its integrator, else which is; empty where none is known.

    `smallest`: its problem and limit. `own`: the limit that is shown, where that may be it.
    """
    limit = (smallest or {}).get("limit")
    if not limit:
        return ""
    if smallest.get("is_this") or (own is not None and own <= limit * (1 + SAME)):
        return "smallest known"
    return f"smallest known: {floored(limit)} on {smallest.get('problem')}"


# --- which Courant number is safe -----------------------------------------------------------------


def _safe(stability):
    """Rows by integrator, shape and transfer, what is never safe first, then the smallest number; the choices to pick from."""
    found = {}
    for problem in stability["problems"]:
        for entry in problem["safe"]:
            key = (problem["problem"], *(str(entry.get(name) or "") for name in ("integrator", "shape", "transfer")))
            found.setdefault(key, []).append(entry)
    counts = sorted({entry["ppc"] for entries in found.values() for entry in entries if entry.get("ppc") is not None})
    smallest = {}
    for entry in stability.get("known_limits") or []:
        least = next((row for row in entry["rows"] if row.get("smallest")), None)
        smallest.setdefault(entry["integrator"], least)
    rows = [_safe_row(key, entries, counts, smallest.get(key[1])) for key, entries in found.items()]
    rows.sort(key=lambda row: (-row["rank"], row["value"] or 0, row["key"]))
    choices, several = [], len({row["key"][0] for row in rows}) > 1
    for part, name in enumerate(("Problem", "Integrator", "Shape", "Transfer")):
        values = sorted({row["key"][part] for row in rows})
        if part or several:
            choices.append({"name": name, "values": values, "prefix": "pist"[part]})
        for row in rows:
            row["classes"].append(f"{'pist'[part]}{values.index(row['key'][part])}")
    return {"rows": rows, "counts": [text.number(count) for count in counts], "choices": choices, "several": several}


def _safe_row(key, entries, counts, smallest):
    numbers = [
        (entry[name], name, entry) for entry in entries for name in ("limit", "edge") if entry.get(name) is not None
    ]
    grows = [entry for entry in entries if entry.get("always") == "unstable"]
    value, decided, entry = min(numbers, key=lambda found: found[0], default=(None, "", {}))
    value = None if grows else value
    stable = not numbers and all(entry.get("always") == "stable" for entry in entries)
    return {
        "key": key,
        "rank": 2 if grows else 1 if value is None and not stable else 0,
        "value": math.inf if stable else value,
        "safe": "none" if grows else "every step" if stable else floored(value),
        "none": bool(grows),
        "smallest": "" if value is None or stable else smallest_in_words(smallest, value),
        "words": _safe_words(entries, grows, stable, _where(decided, entry)),
        "cells": [_safe_cell([entry for entry in entries if entry.get("ppc") == count]) for count in counts],
        "classes": [],
    }


def floored(value, digits=4):
    """A number rounded down: what is printed as safe never lies above what was found."""
    if value is None or not math.isfinite(value) or not value:
        return text.number(value)
    exact = decimal.Decimal(repr(float(value)))
    lowest = decimal.Decimal(1).scaleb(exact.adjusted() - digits + 1)
    return text.number(float(exact.quantize(lowest, decimal.ROUND_FLOOR)), digits)


def _where(decided, entry):
    """What decides the safe number: the layout with the smallest limit."""
    ppc = f" with {text.number(entry['ppc'])} per cell" if entry.get("ppc") is not None else ""
    if decided == "edge":
        return f"a free edge (problem bar-edge){ppc}, {_depth(entry)}"
    offset = f" at offset {text.number(entry['offset'], 4)}" if entry.get("offset") is not None else ""
    return f"points{offset}{ppc} (problem bar)"


def _depth(entry):
    depth = entry.get("edge_depth")
    return "depth not stated" if depth is None else f"depth {text.number(depth, 2)}"


def _safe_words(entries, grows, stable, where):
    if grows:
        which = [text.number(entry["ppc"]) for entry in grows if entry.get("ppc") is not None]
        which = f" with {text.listing(which)} per cell" if which and len(grows) < len(entries) else ""
        return f"Not safe: it grows at every step, however small{which}."
    if stable:
        return "Stable at every step scanned."
    inside = min((entry["limit"] for entry in entries if entry.get("limit") is not None), default=None)
    edge = min((entry for entry in entries if entry.get("edge") is not None), key=lambda e: e["edge"], default=None)
    if inside is None and edge is None:
        return "Not determined."
    if inside is not None and edge and edge["edge"] < EDGE_COLLAPSE * inside:
        return (
            f"{floored(inside)} inside a body (problem bar), but only {floored(edge['edge'])} at a free edge whose "
            f"outermost point lies near the face of its cell (problem bar-edge, {_depth(edge)})."
        )
    return f"Stable on the sampled set; the smallest limit is that of {where}." + (
        "" if edge else " No free edge was looked at."
    )


def _safe_cell(entries):
    """Worst offset, regular layout and edge for one number of points per cell."""
    if not entries:
        return None
    entry = entries[0]
    always = {"unstable": "grows at every step", "stable": "every step"}.get(entry.get("always"))
    return {
        "limit": always or floored(entry.get("limit")),
        "offset": text.number(entry.get("offset"), 4) if entry.get("offset") is not None else "",
        "regular": text.number(entry.get("regular"), 4) if entry.get("regular") is not None else "",
        "edge": floored(entry.get("edge")) if entry.get("edge") is not None else "",
        "depth": text.number(entry.get("edge_depth"), 2) if entry.get("edge_depth") is not None else "",
    }


def _lead(rows):
    """The answer in two sentences."""
    if not rows:
        return ""
    found = [row for row in rows if row["value"] is not None]
    stable_at_one = [row for row in found if row["value"] >= 1]
    growing = [row for row in rows if row["none"]]
    grow = f", and {text.plural(len(growing), 'grows', 'grow')} at every step, however small." if growing else "."
    words = [
        f"Of {text.plural(len(rows), 'combination')} of integrator, shape and transfer, {text.count(len(stable_at_one))} "
        f"{'is' if len(stable_at_one) == 1 else 'are'} stable at a Courant number of 1 at the worst place of the points that "
        f"was sampled{grow}"
    ]
    finite = [row for row in found if math.isfinite(row["value"])]
    if len(finite) > 1:
        worst, best = (
            f"{row['safe']} ({' · '.join(part for part in row['key'][1:] if part)})" for row in (finite[0], finite[-1])
        )
        words.append(f"The smallest safe number is {worst}, the largest with a limit {best}.")
    return " ".join(words)


def filter_rules(safe):
    """Style rules by which a choice of the table hides the rows without it."""
    names = [f"{choice['prefix']}{number}" for choice in safe["choices"] for number in range(len(choice["values"]))]
    return "\n".join(
        f".safe:has(.only-{name}:checked) tbody tr:not(.{name}) {{ display: none; }}" for name in names
    )


# --- a problem ------------------------------------------------------------------------------------


def _problem(problem, anchor):
    configurations = problem["configurations"]
    shared, own = _choices(configurations)
    rows = [_row(configuration, keys) for configuration, keys in zip(configurations, own)]
    units = list(dict.fromkeys(unit(configuration.get("unit")) for configuration in configurations))
    sampled = list(dict.fromkeys(configuration.get("sampled") or "" for configuration in configurations))
    if len(sampled) > 1:
        for row, configuration in zip(rows, configurations):
            row["sampled"] = configuration.get("sampled") or ""
    order = list(dict.fromkeys(row["label"] for row in rows))
    rows.sort(key=lambda row: order.index(row["label"]))
    return {
        "anchor": anchor,
        "name": problem["problem"],
        "title": problem.get("title") or problem["problem"],
        "source": problem.get("source") or "",
        "paragraphs": [part.strip() for part in (problem.get("statement") or "").split("\n\n") if part.strip()],
        "equations": problem["equations"],
        "shared": ", ".join(f"{key} {text.exact(value)}" for key, value in shared.items()),
        "rows": rows,
        "fold": len(rows) > MOST_ROWS,
        "summary": _summary(rows) if len(rows) > MOST_ROWS else [],
        "unit": text.listing(name for name in units if name),
        "sampled": sampled[0] if len(sampled) == 1 else "",
        "each_sampled": len(sampled) > 1,
        "growing": _growing_rows(configurations, own),
        "method": _method(configurations),
        "map_count": len(problem["maps"]),
    }


def _choices(configurations):
    """(settings that all configurations share, of each configuration those that set it apart in words)."""
    settings = [configuration["settings"] for configuration in configurations]
    keys = list(dict.fromkeys(key for entry in settings for key in entry if key != "integrator"))
    keys.sort(key=lambda key: (_FIRST_CHOICES.index(key) if key in _FIRST_CHOICES else len(_FIRST_CHOICES), key))
    shared = {
        key: settings[0][key]
        for key in keys
        if len(settings) > 1 and all(key in entry and entry[key] == settings[0].get(key) for entry in settings)
    }
    return shared, [
        ", ".join(
            text.exact(entry[key]) if key in ("shape", "transfer") else f"{key} {text.exact(entry[key])}"
            for key in keys
            if key in entry and key not in shared
        )
        for entry in settings
    ]


def _threshold(configurations):
    return next((c["threshold"] for c in configurations if c.get("threshold") is not None), maps.THRESHOLD)


def ends(configuration):
    """All finite limits, ascending: where a stable interval ends, and where one begins above the scan's start."""
    start = configuration["scanned"].get("low") or 0
    found = [interval["high"] for interval in configuration["predicted"] if interval.get("high") is not None]
    found += [entry["low"] for entry in configuration["predicted"] if (entry.get("low") or 0) > max(start, 0)]
    return sorted(set(found))


def _row(configuration, choices):
    limits = ends(configuration)
    closed = configuration.get("closed_form")
    nearest = min(limits, key=lambda limit: abs(limit - closed)) if limits and closed is not None else None
    observed = [_observed(entry, limits) for entry in configuration["observed"]]
    above, above_at = _just_above(configuration["growth"], limits)
    seen, seen_at = _just_above(configuration["observed_growth"], limits)
    small = grows_at_small_steps(configuration) or grows_steadily(configuration)
    below = _most_below(configuration)
    return {
        "label": configuration.get("integrator") or text.MISSING,
        "choices": choices or "default",
        "small": small,
        "predicted": intervals(configuration),
        "scanned": _scanned(configuration),
        "smallest": smallest_in_words(configuration.get("smallest_known")),
        "limits": limits,
        "closed": text.number(closed, 6),
        "closed_off": maps.percent(nearest, closed) if nearest is not None else "",
        "closed_share": abs(nearest / closed - 1) if nearest is not None and closed else None,
        "observed": observed,
        "above": text.number(above, 3) if above is not None else text.MISSING,
        "above_at": text.number(above_at, 4) if above is not None else "",
        "seen": text.number(seen, 2) if seen is not None else "",
        "seen_at": text.number(seen_at, 3) if seen is not None else "",
        "below": text.number(below, 1),
        "contradicts": below is not None and below > _own_threshold(configuration),
        "sampled": "",
    }


def intervals(configuration):
    """The stable intervals in words of mathematics."""
    if configuration.get("always") == "stable":
        return "every step"
    if configuration.get("always") == "unstable":
        return "none"
    words = []
    for entry in configuration["predicted"]:
        low, high = entry.get("low") or 0, entry.get("high")
        words.append(f"{text.number(low, 6)} {'and up' if high is None else '… ' + text.number(high, 6)}")
    return "; ".join(words) or "none found"


def _scanned(configuration):
    """How far was looked, where an interval has no end."""
    ends_known = all(entry.get("high") is not None for entry in configuration["predicted"])
    open_end = configuration.get("always") == "stable" or not ends_known
    high = configuration["scanned"].get("high")
    return f"scanned to {text.number(high)}" if open_end and high is not None else ""


def _observed(entry, limits):
    low, high = entry.get("low"), entry.get("high")
    found = [end for end in (low, high) if end is not None]
    middle = sum(found) / len(found) if found else None
    nearest = min(limits, key=lambda limit: abs(limit - middle)) if limits and found else None
    share = abs(middle / nearest - 1) if nearest else None
    return {"bracket": maps.bracket(low, high), "difference": maps.percent(middle, nearest), "share": share}


def _just_above(growth, limits):
    """(what one step adds, the step) of the first sample above the lowest limit that grows."""
    for dt, added in zip(*_curve(growth)):
        if limits and dt > limits[0] and added > 0:
            return added, dt
    return None, None


def _most_below(configuration):
    """The largest growth per step, minus one, inside the stable intervals; None where nothing is called stable."""
    known = zip(*_curve(configuration["growth"]))
    return max((added for dt, added in known if _is_stable(configuration, dt)), default=None)


def _is_stable(configuration, dt):
    if configuration.get("always"):
        return configuration["always"] == "stable"
    return any(
        (entry.get("low") or 0) <= dt and (entry.get("high") is None or dt <= entry["high"])
        for entry in configuration["predicted"]
    )


def _small_steps(configuration):
    """[(step, what one step adds)] from the smallest step on."""
    return list(zip(*_curve(configuration["growth"] or configuration["observed_growth"])))


def grows_at_small_steps(configuration):
    """Called always unstable, or growing at the smallest step that was scanned."""
    if configuration.get("always") == "unstable":
        return True
    steps = _small_steps(configuration)
    if not steps or steps[0][1] <= _own_threshold(configuration):
        return False
    below = any((entry.get("low") or 0) < steps[0][0] for entry in configuration["predicted"])
    return not below or _is_stable(configuration, steps[0][0])


def grows_steadily(configuration):
    """From the smallest step on, growth goes smoothly as a power of the step, at first below what counts as growth.

    Then a limit is but the step at which it passes the threshold, and no smaller step is free of it.
    """
    steps = _small_steps(configuration)
    steps = [(dt, added) for dt, added in steps if 0 < dt <= STEADY_RANGE * steps[0][0]]
    floor = max(_own_threshold(configuration) / 1000, 100 * (configuration["differences"].get("error") or 0))
    if len(steps) < 3 or steps[-1][0] < 2.9 * steps[0][0] or any(added < floor for _, added in steps):
        return False
    powers = [math.log(b[1] / a[1]) / math.log(b[0] / a[0]) for a, b in zip(steps, steps[1:]) if b[0] > a[0]]
    whole = math.log(steps[-1][1] / steps[0][1]) / math.log(steps[-1][0] / steps[0][0])
    low, high = STEADY_POWERS
    return _is_stable(configuration, steps[0][0]) and whole >= low and 0.5 <= min(powers) and max(powers) <= high


def _own_threshold(configuration):
    return _threshold([configuration])


def _growing_rows(configurations, own):
    """Configurations that grow at the smallest steps: what a step adds, and per unit of time."""
    rows = []
    for configuration, choices in zip(configurations, own):
        slow = not grows_at_small_steps(configuration)
        if slow and not grows_steadily(configuration):
            continue
        steps = _small_steps(configuration)[:3]
        rows.append(
            {
                "label": configuration.get("integrator") or text.MISSING,
                "choices": choices or "default",
                "slow": slow,
                "steps": [
                    {"dt": text.number(dt, 4), "added": text.number(added), "rate": text.number(_rate(dt, added))}
                    for dt, added in steps
                ],
                "unit": unit(configuration.get("unit")),
                "waves": _waves(configuration),
            }
        )
    return rows


def _rate(dt, added):
    return math.log1p(added) / dt if dt and added > -1 else None


def _waves(configuration):
    first = min((g for g in configuration["growth"] if g.get("dt") is not None), key=lambda g: g["dt"], default={})
    waves = first.get("wave_number")
    if not isinstance(waves, list):
        return ""
    return ", ".join(text.number(wave, 4) for wave in waves if isinstance(wave, (int, float)))


def _summary(rows):
    """Per integrator: how many configurations, their limits, and the largest differences."""
    found = []
    for label in dict.fromkeys(row["label"] for row in rows):
        own = [row for row in rows if row["label"] == label]
        limits = [limit for row in own for limit in row["limits"]]
        closed = [row["closed_share"] for row in own if row["closed_share"] is not None]
        observed = [entry["share"] for row in own for entry in row["observed"] if entry["share"] is not None]
        low, high = (text.number(end, 5) for end in (min(limits, default=None), max(limits, default=None)))
        found.append(
            {
                "label": label,
                "count": text.count(len(own)),
                "limits": low if low == high else f"{low} … {high}",
                "closed": _largest(closed),
                "observed": _largest(observed),
                "growing": text.count(sum(row["small"] for row in own)),
                "smallest": _smallest_of(own),
            }
        )
    return found


def _smallest_of(rows):
    """What is said of most of the rows of one integrator, which have one list of known limits."""
    words = [row["smallest"] for row in rows if row["smallest"]]
    return next((said for said in words if said == "smallest known"), words[0] if words else "")


def _largest(shares):
    return f"{text.number(100 * max(shares), 2)}\u202f% of {text.count(len(shares))}" if shares else text.MISSING


def _method(configurations):
    """How the limits were found, in one sentence of what the document states."""
    parts = [
        ("step differentiated with differences of ", [c["differences"].get("size") for c in configurations]),
        ("error of these at most ", [c["differences"].get("error") for c in configurations]),
        ("called growth: more than 1 + ", [c.get("threshold") for c in configurations]),
        ("degrees of freedom: ", [c.get("degrees_of_freedom") for c in configurations]),
        ("reach of a point in cells: ", [c.get("reach") for c in configurations]),
        ("steps scanned: ", [c["scanned"].get("steps") for c in configurations]),
    ]
    words = []
    for name, values in parts:
        known = sorted({value for value in values if value is not None})
        if not known:
            continue
        most = name.startswith("error") or len(known) == 1
        least = "" if most else f"{text.number(known[0])} … "
        words.append(name + least + text.number(known[-1]))
    return "; ".join(words).capitalize()


def _order_rows(problem):
    _, own = _choices(problem["configurations"])
    return [
        {
            "problem": problem.get("title") or problem["problem"],
            "integrator": configuration.get("integrator") or text.MISSING,
            "choices": choices or "default",
            "quantity": name,
            "order": text.order({**order, "order_low": order.get("low"), "order_high": order.get("high")}),
            "theory": text.number(order.get("theory")),
        }
        for configuration, choices in zip(problem["configurations"], own)
        for name, order in configuration["orders"].items()
    ]


# --- growth over the step -------------------------------------------------------------------------


def growth(problem, prefix):
    """What a step adds over the step, a panel an integrator; None where nothing was scanned."""
    _, own = _choices(problem["configurations"])
    lines = [(c, choices) for c, choices in zip(problem["configurations"], own) if len(_curve(c["growth"])[0]) > 1]
    if not lines:
        return None
    panels = list(dict.fromkeys(c.get("integrator") or "" for c, _ in lines))
    single = len(lines) == len(panels)
    names = panels if single else list(dict.fromkeys(choices for _, choices in lines))
    chosen = names if single else [names[index] for index in _evenly(len(names), MOST_LINES)]
    drawn = [(c, choices) for c, choices in lines if single or choices in chosen]
    # Of single lines each panel tells the next ones apart; else each panel is an integrator.
    groups = [names[at : at + MOST_SERIES] for at in range(0, len(names), MOST_SERIES)]
    shown = groups if single else panels[:MOST_PANELS]
    threshold = _threshold(problem["configurations"])
    columns = 1 if len(shown) == 1 else 2

    def paint(axes):
        every = numpy.ravel(axes)
        for panel in every[len(shown) :]:
            panel.set_visible(False)
        for panel, group in zip(every, shown):
            for configuration, choices in drawn:
                integrator = configuration.get("integrator") or ""
                if integrator in group if single else integrator == group:
                    style = chosen.index((configuration.get("integrator") or "") if single else choices)
                    _growth_line(panel, configuration, style, chosen[style] or "default")
            panel.axhspan(-threshold, threshold, color=svg.MUTED, alpha=0.15, linewidth=0)
            if not single:
                panel.set_title(group, fontsize=8)
        _growth_axes(every, drawn, threshold)
        units = list(dict.fromkeys(unit(c.get("unit")) for c, _ in drawn))
        for panel in every[max(0, len(shown) - columns) : len(shown)]:
            panel.tick_params(labelbottom=True)
            panel.set_xlabel(f"step in {units[0]}" if len(units) == 1 and units[0] else "step")
        for panel in every[: len(shown) : columns]:
            panel.set_ylabel("spectral radius − 1")

    title = problem.get("title") or problem["problem"]
    left = len(names) - len(chosen)
    folded = len(panels) - len(shown) if not single else 0
    caption = (
        f"Largest growth of a perturbation in one step over the size of the step. In the shaded band, within "
        f"{text.number(threshold, 2)} of 1, growth is not told from rounding; the vertical axis is linear there and "
        "logarithmic beyond. Rings: growth measured in runs. Vertical lines: predicted limits, dotted; closed form, "
        "broken."
        + (f" Drawn are {len(chosen)} of {len(names)} choices, evenly chosen" if left else "")
        + (f"; {text.plural(folded, 'further integrator')} in the table." if folded else "." if left else "")
    )
    keys = [
        Key(name or "default", f"var(--s{number % len(svg.SERIES) + 1})", _mark(number))
        for number, name in enumerate(chosen)
    ]
    rows = -(-len(shown) // columns)
    drawing = svg.draw(
        paint,
        prefix,
        f"Growth per step over the step, {title}",
        height=2.9 if columns == 1 else 0.5 + 1.75 * rows,
        nrows=rows,
        ncols=columns,
        sharex=True,
        sharey=True,
        squeeze=False,
    )
    return Figure(drawing, f"Growth per step: {title}", caption, [STABILITY_FILE], keys)


def _mark(style):
    """Marks only where colours repeat."""
    return "" if style < len(svg.SERIES) else svg.series_mark(style)


def _evenly(count, most):
    return sorted(set(numpy.linspace(0, count - 1, min(count, most)).round().astype(int).tolist()))


def _curve(entries):
    """(steps from the smallest on, what one step adds) of the samples that have both."""
    pairs = [(entry.get("dt"), entry.get("per_step")) for entry in entries]
    known = sorted((dt, rate - 1) for dt, rate in pairs if dt is not None and rate is not None)
    return [dt for dt, _ in known], [added for _, added in known]


def _growth_line(panel, configuration, style, label):
    colour = svg.series_colour(style)
    steps, added = _curve(configuration["growth"])
    mark = _mark(style)
    every = max(1, len(steps) // 6)
    panel.plot(
        steps, added, mark + "-", color=colour, linewidth=1.0, markersize=3, markevery=every, label=label
    )
    seen = _curve(configuration["observed_growth"])
    chosen = _evenly(len(seen[0]), MOST_RINGS)
    seen = [[values[index] for index in chosen] for values in seen]
    if seen[0]:
        (rings,) = panel.plot(
            *seen, "o", color=colour, markerfacecolor="none", markersize=4, markeredgewidth=0.9, label=label
        )
        svg.note(rings, ["measured in runs"] * len(seen[0]))
    for limit in ends(configuration):
        svg.belongs(panel.axvline(limit, color=colour, linewidth=0.8, dashes=(1, 1.5)), label)
    if configuration.get("closed_form") is not None:
        panel.axvline(configuration["closed_form"], color=svg.MUTED, linewidth=0.7, dashes=(5, 3))


def _growth_axes(panels, drawn, threshold):
    """The same symmetric logarithmic axis for all panels."""
    values = [a for c, _ in drawn for part in ("growth", "observed_growth") for a in _curve(c[part])[1]]
    top = max(10 * threshold, 2 * max(values))
    bottom = min(-3 * threshold, 2 * min(values))
    for panel in panels:
        panel.set_yscale("symlog", linthresh=threshold, linscale=0.7)
        panel.set_ylim(bottom, top)
        panel.yaxis.set_major_locator(FixedLocator(_symmetric_ticks(bottom, top, threshold)))
        panel.yaxis.set_major_formatter(FuncFormatter(lambda value, _: _signed_tick(value)))
        panel.yaxis.set_minor_locator(NullLocator())
        plain_axis(panel.xaxis)


def _signed_tick(value):
    return "0" if not value else ("−" if value < 0 else "") + tick(abs(value))


def _symmetric_ticks(bottom, top, threshold):
    first = round(math.log10(threshold))
    found = [0.0]
    for end, sign in ((top, 1), (bottom, -1)):
        last = math.floor(math.log10(abs(end)))
        every = max(2, -(-(last - first) // 4))
        found += [sign * 10.0**power for power in range(first, last + 1, every) if (power > first or sign > 0)]
    return sorted(found)


# --- maps -----------------------------------------------------------------------------------------


def map_parts(problem):
    """[{title, growth, unit, ticks and picture of the scale, groups by shape}] by kind and unit; limits first."""
    parts = []
    kinds = {}
    for entry in problem["maps"]:
        kinds.setdefault((entry.get("kind") == "growth", unit(entry.get("unit"))), []).append(entry)
    for (grows, measured_in), chosen in sorted(kinds.items(), key=lambda kind: kind[0]):
        scale = maps.scale_of(chosen, grows, _threshold(problem["configurations"]))
        entries = {}
        for entry in chosen:
            entries.setdefault(str(entry.get("shape") or "any shape"), []).append(entry)
        groups = [_group(shape, found, scale, measured_in) for shape, found in entries.items()]
        for number, group in enumerate(groups):
            group["open"] = len(chosen) <= FEW_MAPS or number == 0
        every = [drawn for group in groups for drawn in group["maps"]]
        parts.append(
            {
                "growth": grows,
                "unit": measured_in,
                "scale": scale,
                "count": len(chosen),
                "groups": groups,
                "observed": any(drawn.observed for drawn in every),
                "closed": any(drawn.closed or any(cut.closed for cut in drawn.cuts) for drawn in every),
                "spans": any(drawn.spans for drawn in every),
                "missing": any(drawn.unknown for drawn in every),
            }
        )
    return parts


def _group(shape, entries, scale, measured_in):
    """Maps of one shape, their common axes and, where all have the same curves, the legend of these."""
    shown, left_out = _of_one_transfer(entries)
    drawn = _told_apart([maps.draw(entry, scale, measured_in) for entry in shown])
    legends = [[(cut.name, cut.colour) for cut in m.cuts] for m in drawn]
    return {
        "shape": shape,
        "maps": sorted(drawn, key=lambda m: m.title),
        "axes": _common_axes(drawn),
        "cuts": drawn[0].cuts if all(legend == legends[0] for legend in legends) else [],
        "left_out": left_out,
    }


def _of_one_transfer(entries):
    """(maps to draw, {transfer: number of its maps that are not drawn})."""
    transfers = collections.Counter(str(entry.get("transfer") or "") for entry in entries)
    if len(entries) <= MOST_MAPS or len(transfers) < 2:
        return entries, {}
    drawn = DRAWN_TRANSFER if DRAWN_TRANSFER in transfers else next(iter(transfers))
    return [entry for entry in entries if str(entry.get("transfer") or "") == drawn], {
        name or "without one": count for name, count in transfers.items() if name != drawn
    }


def _told_apart(drawn):
    """Maps of the same choices get their own titles or names."""
    titles = [m.title for m in drawn]
    for m in drawn:
        if titles.count(m.title) > 1:
            m.title = m.own_title or m.name
    return drawn


def _common_axes(drawn):
    across, up = ({getattr(m, axis).ends for m in drawn} for axis in ("x", "y"))
    if len(across) > 1 or len(up) > 1:
        return ""
    return f"Across: {across.pop()}; up: {up.pop()}."


# --- CSV ------------------------------------------------------------------------------------------


def csv_tables(stability):
    """{name: (columns, rows)} of all that the document holds."""
    problems = stability["problems"]
    growth_rows, map_rows = [], []
    for problem in problems:
        for c in problem["configurations"]:
            key = [problem["problem"], c.get("integrator"), _settings(c)]
            for origin, part in (("predicted", "growth"), ("observed", "observed_growth")):
                growth_rows += [[*key, origin, g.get("dt"), g.get("per_step")] for g in c[part]]
        for entry in problem["maps"]:
            map_rows += _map_rows(problem, entry)
    return {
        "stability": (CONFIGURATION_COLUMNS, [_csv_row(p, c) for p in problems for c in p["configurations"]]),
        "stability-growth": (("problem", "integrator", "settings", "origin", "dt", "per_step"), growth_rows),
        "stability-safe": (
            SAFE_COLUMNS,
            [[p["problem"], *(entry.get(name) for name in SAFE_COLUMNS[1:])] for p in problems for entry in p["safe"]],
        ),
        "stability-maps": (("problem", "map", "kind", "part", "x", "y", "low", "high"), map_rows),
        "stability-known": (
            KNOWN_COLUMNS,
            [
                [
                    entry["integrator"],
                    json.dumps(entry["parameters"], sort_keys=True),
                    *(row.get(name) for name in KNOWN_COLUMNS[2:]),
                ]
                for entry in stability.get("known_limits") or []
                for row in entry["rows"]
            ],
        ),
        "stability-orders": (
            ORDER_COLUMNS,
            [
                [p["problem"], c.get("integrator"), _settings(c), name, *(order.get(key) for key in ORDER_COLUMNS[4:])]
                for p in problems
                for c in p["configurations"]
                for name, order in c["orders"].items()
            ],
        ),
    }


def _settings(configuration):
    return json.dumps(configuration["settings"], sort_keys=True, ensure_ascii=False)


def _csv_row(problem, c):
    steps = _small_steps(c)
    first = (steps[0][0], steps[0][1]) if steps else (None, None)
    return [
        problem["problem"],
        c.get("integrator"),
        _settings(c),
        c.get("unit"),
        _pairs(c["predicted"]),
        c.get("closed_form"),
        _pairs(c["observed"]),
        c.get("always"),
        *first,
        c.get("threshold"),
        c["differences"].get("size"),
        c["differences"].get("error"),
        c.get("reach"),
        c.get("degrees_of_freedom"),
        c.get("sampled"),
        *(c["smallest_known"].get(key) for key in ("limit", "problem", "choices")),
    ]


def _pairs(entries):
    """'0 1.833; 2.1 2.4' of intervals, with an empty end where there is none."""
    pairs = [(entry.get("low"), entry.get("high")) for entry in entries]
    return "; ".join(" ".join("" if end is None else repr(end) for end in pair) for pair in pairs)


def _map_rows(problem, entry):
    key = [problem["problem"], entry.get("id"), entry.get("kind")]
    rows = []
    for part in ("values", "closed_form"):
        for y, row in zip(entry["y"]["values"], entry.get(part) or []):
            rows += [[*key, part, x, y, value, value] for x, value in zip(entry["x"]["values"], row)]
    rows += [[*key, "closed_form", p.get("x"), p.get("y"), None, None] for p in entry["closed_form_curve"]]
    rows += [[*key, "observed", o.get("x"), o.get("y"), o.get("low"), o.get("high")] for o in entry["observed"]]
    return rows
