"""A baseline beside the results: its curves under those of the cases, and what `plumbline diff` says of both.

Nothing is compared here: better and worse are as the document of `plumbline diff` states them.
"""

import svg
import text

CHANGES = {  # most serious first, with what they mean
    "worse": "worse than the baseline",
    "widened": "gates that let pass more than they did",
    "missing": "only in the baseline",
    "inconclusive": "these data cannot tell",
    "better": "better than the baseline",
    "new": "only in these results",
}
_CHIPS = dict(zip(CHANGES, ("FAIL", "XPASS", "INVALID", "INCONCLUSIVE", "PASS", "NONE")))
MOST_ROWS = 40  # of one kind of change
_PALE = {"alpha": 0.5, "linewidth": 0.9, "dashes": (1.5, 1.5)}


# --- curves ---------------------------------------------------------------------------------------


def attach(cases, earlier):
    """Gives each study of the cases that of the baseline: same scheme, study and what is varied; same levels first."""
    for name, case in cases.items():
        rivals = earlier[name].series if name in earlier else []
        for entry in case.series:
            same = [other for other in rivals if _identity(other) == _identity(entry)]
            same.sort(key=lambda other: _values(other) != _values(entry))
            entry.baseline = same[0] if same else None


def _identity(series):
    return series.scheme, series.study, series.vary, series.title if not series.study else ""


def _values(series):
    return [level.get("value") for level in series.levels]


def of(series):
    """The lines that have a baseline."""
    return [entry for entry in series if entry.baseline]


def draw_errors(axes, series, measure):
    """The baseline's errors, pale and broken, in the colours of the lines they belong to; returns the errors drawn."""
    shown = []
    for entry in of(series):
        rows = [(level.get("h"), error) for level, error in entry.baseline.errors(measure) if error > 0 and level.get("h")]
        if len(rows) > 1:
            _pale_line(axes, entry, rows)
            shown += [error for _, error in rows]
    return shown


def draw_orders(axes, series, measure):
    """The baseline's orders between neighbouring levels, likewise."""
    shown = []
    for entry in of(series):
        sizes = [level.get("h") for level in entry.baseline.levels]
        orders = (entry.baseline.measures.get(measure) or {}).get("pairwise") or []
        rows = [
            ((coarse * fine) ** 0.5, order)
            for coarse, fine, order in zip(sizes, sizes[1:], orders)
            if coarse and fine and order is not None
        ]
        if rows:
            _pale_line(axes, entry, rows)
            shown += [order for _, order in rows]
    return shown


def _pale_line(axes, entry, rows):
    (line,) = axes.plot(*zip(*rows), color=svg.series_colour(entry.style), zorder=1.5, **_PALE)
    svg.belongs(line, entry.label)


def words(series, measure):
    """What the caption says of it."""
    orders = [
        f"{entry.label} {text.order(entry.baseline.measures[measure])}" for entry in of(series) if entry.baseline.measures.get(measure)
    ]
    if not of(series):
        return ""
    return " Pale broken lines are the baseline" + (f" (orders: {text.listing(orders)})." if orders else ".")


# --- what has changed -----------------------------------------------------------------------------


def section(document, anchors):
    """What the page says of the document of `plumbline diff`; None without one. `anchors`: by name of the case."""
    if not document:
        return None
    findings = document.get("findings") or []
    groups = [_group(change, [found for found in findings if found.get("change") == change], anchors) for change in CHANGES]
    counts = document.get("counts") or {}
    return {
        "summary": document.get("summary") or "",
        "unchanged": bool(document.get("nothing_changed")),
        "tiles": [{"change": change, "chip": _CHIPS[change], "count": counts.get(change) or 0} for change in CHANGES],
        "same": counts.get("same") or 0,
        "moved": document.get("moved") or 0,
        "groups": [group for group in groups if group["rows"]],
        "sides": [{"name": name, **(document.get(key) or {})} for name, key in (("baseline", "baseline"), ("these results", "results"))],
        "machine": document.get("machine") or [],
        "damaged": [
            (side.get("folder"), entry.get("file"), entry.get("reason"))
            for side in (document.get("baseline") or {}, document.get("results") or {})
            for entry in side.get("damaged") or []
        ],
    }


def _group(change, findings, anchors):
    return {
        "change": change,
        "title": CHANGES[change],
        "chip": _CHIPS[change],
        "rows": [_row(found, anchors) for found in findings[:MOST_ROWS]],
        "left": max(0, len(findings) - MOST_ROWS),
        "folded": change in ("better", "new", "missing") and len(findings) > 10,
    }


def _row(found, anchors):
    name = found.get("case") or ""
    return {
        "kind": found.get("kind") or "",
        "case": name,
        "anchor": anchors.get(name, ""),
        "where": " · ".join(part for part in (found.get("scheme"), found.get("study")) if part),
        "quantity": found.get("quantity") or "",
        "before": _value(found.get("before")),
        "after": _value(found.get("after")),
        "size": _size(found),
        "interval": _interval(found),
        "note": " ".join(part for part in (found.get("note"), _recorded(found)) if part),
    }


def _recorded(found):
    return f"Recorded reason: {found['recorded']}." if found.get("recorded") else ""


def _value(value):
    if isinstance(value, dict):
        return text.expected(value)
    return text.number(value, 4) if isinstance(value, (int, float)) else value or text.MISSING


def _amount(kind, value):
    """A difference of orders, a ratio of costs, a relative change of anything else."""
    if value is None:
        return text.MISSING
    if kind == "cost":
        return f"× {value:.3f}"
    sign = "+" if value >= 0 else "−"
    return f"{sign}{abs(value):.3f}" if kind == "order" else f"{sign}{text.number(100 * abs(value), 3)} %"


def _size(found):
    return _amount(found.get("kind"), found["size"]) if found.get("size") is not None else ""


def _interval(found):
    low, high = found.get("interval") or (None, None)
    return "" if low is None and high is None else f"{_amount(found.get('kind'), low)} … {_amount(found.get('kind'), high)}"
