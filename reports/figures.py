"""Figures of the refinement studies: convergence, pairwise order, plateau, single-parameter studies, cost.

Each function returns a Figure, or None where the files hold nothing to draw. No number is fitted here:
orders, intervals and constants are those of the study files.
"""

from dataclasses import dataclass, field

import numpy
from matplotlib.ticker import FixedLocator, FuncFormatter, MaxNLocator, NullLocator

import baseline
import reproduce
import svg
import text

ROUNDING = numpy.finfo(float).eps
MOST_SERIES = 8  # lines that one figure tells apart; those first declared, with the default scheme's among them
VARIED = {"cells": "cells", "dt": "time step", "ppc": "points per cell", "offset": "shift of the grid"}
_AXIS = {"dt": "time step in s", "ppc": "points per cell", "offset": "shift of the grid in cells"}


@dataclass
class Key:
    """One entry of the legend beside a figure."""

    label: str
    colour: str  # CSS colour
    mark: str = ""  # o s ^ D v P, or none
    dash: bool = False
    band: bool = False


@dataclass
class Figure:
    svg: str
    title: str
    caption: str
    files: list
    keys: list = field(default_factory=list)
    commands: list = field(default_factory=list)  # that make its numbers again
    further: bool = False  # lines beyond those of another figure


# --- axes -----------------------------------------------------------------------------------------


def log_axis(axis, low, high, most=None):
    """Ticks of a logarithmic axis: decades; 1, 2, 5; all digits; whatever gives at least three labels. Where that is more
    than `most`: the decades among them, or each second or so.
    """
    ticks = log_ticks(low, high)
    if most and len(ticks) > most:
        decades = [value for value in ticks if f"{value:e}".startswith("1.000000e")]
        ticks = decades if 1 < len(decades) <= most else ticks[:: -(-len(ticks) // most)]
    axis.set_major_locator(FixedLocator(ticks))
    axis.set_major_formatter(FuncFormatter(lambda value, _: tick(value)))
    axis.set_minor_locator(NullLocator())


def log_ticks(low, high):
    """Tick positions within [low, high], 0 < low < high."""
    first, last = int(numpy.floor(numpy.log10(low))), int(numpy.ceil(numpy.log10(high)))
    every = max(1, round((last - first) / 6))
    for digits in ((1,), (1, 2, 5), (1, 1.5, 2, 3, 4, 5, 6, 8)):
        ticks = [
            digit * 10.0**power
            for power in range(first, last + 1, every if digits == (1,) else 1)
            for digit in digits
        ]
        inside = [value for value in ticks if low <= value <= high]
        if len(inside) >= 3:
            return inside
    return [value for value in MaxNLocator(5).tick_values(low, high) if low <= value <= high]


def tick(value):
    """Tick labels: 0.001 ... 9999 plainly, powers of ten otherwise."""
    if 0.0009 < abs(value) < 10000:
        return text.number(value, 3)
    power = int(numpy.floor(numpy.log10(abs(value)) + 1e-9)) if value else 0
    factor = text.number(round(value / 10.0**power, 2))
    return f"10{text.superscript(power)}" if factor == "1" else f"{factor}·10{text.superscript(power)}"


def plain_axis(axis):
    axis.set_major_formatter(FuncFormatter(lambda value, _: text.number(round(value, 12), 5)))


def error_label(case, measure):
    """Label of an error axis with its unit."""
    units = [
        ((level.get("measures") or {}).get(measure) or {}).get("unit")
        for entry in case.series
        for level in entry.levels
    ]
    unit = next((unit for unit in units if unit and unit != "1"), None)
    return (
        ("" if measure.endswith(".step") else "error of ")
        + measure
        + (f" in {text.unit(unit)}" if unit else "")
    )


def _margins(values, factor=1.6):
    positive = [value for value in values if value and value > 0]
    return min(positive) / factor, max(positive) * factor


def _marks(axes, entry, x, y, used, notes):
    """Filled marks for levels that enter the fit, hollow ones for those that do not."""
    colour, mark = svg.series_colour(entry.style), svg.series_mark(entry.style)
    sizes = numpy.array(notes)
    for chosen, fill in ((used, colour), (~used, "none")):
        if chosen.any():
            (line,) = axes.plot(
                x[chosen], y[chosen], mark, color=colour, markerfacecolor=fill, markeredgewidth=1.1, label=entry.label
            )
            svg.note(line, sizes[chosen])


def marked_line(axes, entry, x, y, joined="-"):
    """Values of one line of the case in its colour and with its marks; it can be pointed at on the page."""
    style = svg.series_mark(entry.style) + joined
    (line,) = axes.plot(x, y, style, color=svg.series_colour(entry.style), linewidth=0.9, label=entry.label)
    return line


def _keys(series):
    return [
        Key(entry.label, f"var(--s{entry.style % len(svg.SERIES) + 1})", svg.series_mark(entry.style))
        for entry in series
    ]


def _baseline_key(series):
    return [Key("baseline", "var(--muted)", dash=True)] if baseline.of(series) else []


def _with_errors(case, vary, measure):
    return [entry for entry in case.studies(vary) if sum(error > 0 for _, error in entry.errors(measure)) > 1]


def _files(series):
    return [name for entry in series for name in entry.files]


def of_part(series, part):
    """Those that the figure of this number shows: the first tells the first ones apart, the next the next ones."""
    return series[MOST_SERIES * part :][:MOST_SERIES]


def left_out(series):
    """What a caption says of the lines beyond those that a figure can tell apart."""
    further = len(series) - MOST_SERIES
    return f" {text.plural(further, 'further line')}, up to {MOST_SERIES} a figure, below." if further > 0 else ""


def parts(draw, prefix):
    """The figures of all lines, `draw(prefix, part)` until there is none left."""
    drawn = []
    while figure := draw(f"{prefix}-part-{len(drawn)}" if drawn else prefix, len(drawn)):
        figure.further = bool(drawn)
        drawn.append(figure)
    return drawn


def _commands(case, series):
    return list(dict.fromkeys(command for entry in series if (command := reproduce.study(entry, case.name))))


def theory(case, measure):
    """The order that theory allows for a measure, or None."""
    order = ((case.catalog.get("theory_order") or {}).get(measure) or {}).get("order")
    return order if isinstance(order, (int, float)) else None


# --- convergence ----------------------------------------------------------------------------------


@dataclass
class _Levels:
    """The levels of one study as arrays: those with a positive error and a cell size."""

    h: numpy.ndarray
    error: numpy.ndarray
    used: numpy.ndarray
    notes: list  # what each level is
    fit: dict


def _levels(entry, measure):
    fit = entry.measures.get(measure) or {}
    used = fit.get("levels_used") or [True] * len(entry.levels)
    rows = [
        (level.get("h"), ((level.get("measures") or {}).get(measure) or {}).get("error"), flag, level_note(level))
        for level, flag in zip(entry.levels, used)
    ]
    rows = [row for row in rows if row[0] and row[1] and row[1] > 0]
    h, error, used, notes = zip(*rows) if rows else ((),) * 4
    return _Levels(numpy.array(h), numpy.array(error), numpy.array(used, bool), list(notes), fit)


def level_note(level):
    """What a level is, beside its place in a figure: its number of cells."""
    cells = (level.get("settings") or {}).get("cells")
    return f"{text.count(cells)} cells" if isinstance(cells, (int, float)) else ""


def confidence_band(h, used_h, fit):
    """(low, high) of the fitted line at h, from the interval of the order that the file states.

    For a straight line through n points, the half width at x is t s sqrt(1/n + (x - mean)^2/Sxx), and that of
    the slope is t s/sqrt(Sxx): the first follows from the second without fitting again.
    """
    low, high = fit.get("order_low"), fit.get("order_high")
    if None in (low, high, fit.get("order"), fit.get("constant")) or len(used_h) < 3:
        return None
    x, mean = numpy.log(used_h), numpy.log(used_h).mean()
    sxx = ((x - mean) ** 2).sum()
    half = (high - low) / 2 * numpy.sqrt(sxx / len(x) + (numpy.log(h) - mean) ** 2)
    line = fit["constant"] * h ** fit["order"]
    return line * numpy.exp(-half), line * numpy.exp(half)


def floors(series, measure):
    """(largest reference bound, largest rounding floor) over the levels; None where not stated."""
    found = [(level.get("measures") or {}).get(measure) or {} for entry in series for level in entry.levels]
    bounds = [entry["reference_bound"] for entry in found if entry.get("reference_bound")]
    scales = [
        entry["error"] / entry["relative_error"]
        for entry in found
        if entry.get("error") and entry.get("relative_error")
    ]
    return max(bounds, default=None), ROUNDING * max(scales) if scales else None


def convergence(case, measure, prefix, part=0):
    every = _with_errors(case, "cells", measure)
    series = of_part(every, part)
    if not series:
        return None
    bound, rounding = floors(series, measure)
    order = theory(case, measure)

    def paint(axes):
        shown = []
        for entry in series:
            levels = _levels(entry, measure)
            shown += list(levels.error)
            _fitted_line(axes, entry, levels)
            _marks(axes, entry, levels.h, levels.error, levels.used, levels.notes)
        shown += baseline.draw_errors(axes, series, measure)
        _theory_line(axes, order, _levels(series[0], measure), shown)
        low, high = _margins(shown, 2.2)
        low = min([low] + _floor_lines(axes, low, bound, rounding))
        axes.set(
            xscale="log",
            yscale="log",
            ylim=(low, high),
            xlabel="cell size h",
            ylabel=error_label(case, measure),
        )
        log_axis(axes.xaxis, *axes.get_xlim())
        log_axis(axes.yaxis, *axes.get_ylim())

    orders = text.listing(
        f"{entry.label}: order {text.order(entry.measures.get(measure) or {})}" for entry in series
    )
    caption = f"Fitted orders with 95 % intervals: {orders}. {_floor_words(bound, rounding)}".strip()
    caption += baseline.words(series, measure) + (left_out(every) if part == 0 else "")
    keys = _keys(series) + _baseline_key(series) + (
        [Key(f"theory: slope {text.number(order)}", "var(--muted)", dash=True)] if order is not None else []
    )
    return Figure(
        svg.draw(paint, prefix, f"Error in {measure} against cell size", height=3.7),
        f"Convergence of {measure}",
        caption,
        _files(series),
        keys,
        _commands(case, series),
    )


def _fitted_line(axes, entry, levels):
    if levels.fit.get("order") is None or levels.fit.get("constant") is None or not levels.used.any():
        return
    colour = svg.series_colour(entry.style)
    used_h = levels.h[levels.used]
    h = numpy.geomspace(used_h.min(), used_h.max(), 30)
    (line,) = axes.plot(h, levels.fit["constant"] * h ** levels.fit["order"], color=colour, linewidth=1.1)
    svg.belongs(line, entry.label)
    band = confidence_band(h, used_h, levels.fit)
    if band:
        svg.belongs(axes.fill_between(h, *band, color=colour, alpha=0.16, linewidth=0), entry.label)


def _theory_line(axes, order, levels, shown):
    if order is None or not len(levels.h):
        return
    h = numpy.array([levels.h.min(), levels.h.max()])
    start = 0.62 * levels.error[levels.h.argmin()]
    axes.plot(h, start * (h / h[0]) ** order, color=svg.MUTED, linewidth=0.9, dashes=(5, 3))
    shown.append(start)


def _floor_lines(axes, low, bound, rounding):
    """Draws floors within three decades of the data, returns their halves; names others at the lower edge."""
    drawn, below = [], []
    for value, name, dashes in (
        (bound, "reference bound", (1, 1.5)),
        (rounding, "rounding", (4, 1.5, 1, 1.5)),
    ):
        if value and value > low * 1e-3:
            axes.axhline(value, color=svg.MUTED, linewidth=0.9, dashes=dashes)
            axes.annotate(
                name, (1, value), xycoords=("axes fraction", "data"), ha="right", va="bottom", fontsize=7.5
            )
            drawn.append(value / 2)
        elif value:
            below.append(f"{name} {text.number(value, 2)}")
    if below:
        axes.annotate(
            "↓ far below: " + ", ".join(below),
            (1, 0.015),
            xycoords="axes fraction",
            ha="right",
            va="bottom",
            fontsize=7.5,
            color=svg.MUTED,
        )
    return drawn


def _floor_words(bound, rounding):
    known = [
        f"the reference is sure to {text.number(bound, 2)}" if bound else "",
        f"rounding sets in near {text.number(rounding, 2)}" if rounding else "",
    ]
    known = text.listing(words for words in known if words)
    return f"{known[0].upper()}{known[1:]}." if known else ""


def level_by_level(case, measure, prefix, part=0):
    """Order between neighbouring levels above, and below it E/hᵖ over the levels, relative to the finest."""
    series = [
        entry
        for entry in _with_errors(case, "cells", measure)
        if any((entry.measures.get(measure) or {}).get("pairwise") or [])
        or any((entry.measures.get(measure) or {}).get("plateau") or [])
    ]
    series = of_part(series, part)
    if not series:
        return None
    order = theory(case, measure)

    def paint(axes):
        upper, lower = axes
        shown = [order] if order is not None else []
        for entry in series:
            sizes = [level.get("h") or numpy.nan for level in entry.levels]
            pairs = [
                (numpy.sqrt(coarse * fine), value)
                for coarse, fine, value in zip(sizes, sizes[1:], entry.measures[measure].get("pairwise") or [])
                if value is not None
            ]
            shown += [value for _, value in pairs]
            if pairs:
                marked_line(upper, entry, *zip(*pairs))
            _plateau_line(lower, entry, measure)
        shown += baseline.draw_orders(upper, series, measure)
        if order is not None:
            upper.axhline(order, color=svg.MUTED, linewidth=0.9, dashes=(5, 3))
        upper.set(xscale="log", ylabel="order")
        if shown:
            upper.set_ylim(min(shown) - 0.25, max(shown) + 0.25)
        lower.axhspan(0.85, 1.15, color=svg.MUTED, alpha=0.14, linewidth=0)
        lower.set(xscale="log", xlabel="cell size h", ylabel="E/hᵖ, relative")
        low, high = lower.get_ylim()
        lower.set_ylim(min(low, 0.7), max(high, 1.3))
        log_axis(lower.xaxis, *lower.get_xlim())
        for panel in axes:
            panel.yaxis.set_major_locator(MaxNLocator(5))
            plain_axis(panel.yaxis)

    caption = (
        "Above, the order from each pair of neighbouring levels, at the geometric mean of their sizes; below, the error "
        "over hᵖ, p being the fitted order, relative to the finest level."
    )
    keys = _keys(series) + _baseline_key(series)
    if order is not None:
        keys.append(Key(f"theory: {text.number(order)}", "var(--muted)", dash=True))
    keys.append(Key("± 15 % of the finest", "var(--muted)", band=True))
    drawing = svg.draw(
        paint, prefix, f"Order of {measure} between neighbouring levels, and plateau of its error constant",
        height=3.2, nrows=2, sharex=True,
    )  # fmt: skip
    return Figure(drawing, "Order and error constant, level by level", caption, _files(series), keys, _commands(case, series))


def _plateau_line(axes, entry, measure):
    plateau = entry.measures[measure].get("plateau") or []
    rows = [(level.get("h"), value) for level, value in zip(entry.levels, plateau) if value and level.get("h")]
    if rows:
        x, y = (numpy.array(column) for column in zip(*rows))
        marked_line(axes, entry, x, y / y[x.argmin()])


# --- one parameter alone --------------------------------------------------------------------------


def variation_measures(case, vary):
    """The measure of the case; for the step also the distance to the next smaller step, which needs no
    exact solution.
    """
    steps = case.measure.split(".")[0] + ".step"
    return [case.measure] + [steps] * (
        vary == "dt" and any(steps in entry.measures for entry in case.studies(vary))
    )


def variation(case, vary, measure, prefix, part=0):
    """Error against the time step, the points per cell or the offset of the grid alone."""
    series = of_part([entry for entry in case.studies(vary) if any(error > 0 for _, error in entry.errors(measure))], part)
    if not series:
        return None
    distance = measure.endswith(".step")

    def paint(axes):
        values, shown = [], []
        for entry in series:
            rows = sorted(
                (varied(level, vary), error)
                for level, error in entry.errors(measure)
                if varied(level, vary) is not None and error > 0
            )
            x, y = (numpy.array(column) for column in zip(*rows)) if rows else (numpy.array([]),) * 2
            values, shown = values + list(x), shown + list(y)
            if distance:
                _fitted_line(axes, entry, _levels(entry, measure))
            marked_line(axes, entry, x, y, "" if distance else "-")
        scale = "linear" if vary == "offset" else "log"
        axes.set(xscale=scale, yscale="log", xlabel=_AXIS.get(vary, vary), ylabel=error_label(case, measure))
        if shown:
            axes.set_ylim(*_margins(shown, 1.4))
            log_axis(axes.yaxis, *axes.get_ylim())
        if scale == "log" and values:
            log_axis(axes.xaxis, *axes.get_xlim())

    why = " ".join(
        dict.fromkeys(entry.why[0].upper() + entry.why[1:].rstrip(".") + "." for entry in series if entry.why)
    )
    name = VARIED.get(vary, vary)
    caption = (
        f"Distance of each run in {measure} from that with the next smaller step. {why}"
        if distance
        else f"Error in {measure} when only the {name} changes. {why}"
    ).strip()
    orders = text.listing(
        f"{text.order(entry.measures[measure])} ({entry.label})"
        for entry in series
        if entry.measures.get(measure)
    )
    caption += f" Fitted order: {orders}." if distance and orders else ""
    title = f"Distance between neighbouring steps, {measure}" if distance else f"{name.capitalize()} alone"
    return Figure(
        svg.draw(paint, prefix, f"Error in {measure} against {name}", height=2.5),
        title,
        caption,
        _files(series),
        _keys(series),
        _commands(case, series),
    )


def varied(level, vary):
    """What was varied; a step in seconds, where the level states it."""
    return level.get("h") if vary == "dt" and level.get("h") else level.get("value")


# --- cost -----------------------------------------------------------------------------------------


def wall_time(level):
    return level.get("wall_s")


def particle_steps(level):
    return level["points"] * level["steps"] if level.get("points") and level.get("steps") else None


COSTS = {
    "time": (
        wall_time,
        "wall_s",
        "wall time in s, one core",
        "error against wall time",
    ),
    "work": (
        particle_steps,
        "cell_steps",
        "particle-steps (points × steps)",
        "error against particle-steps",
    ),
}


def front(points):
    """Those (cost, error) that no other beats in both, by growing cost."""
    best, chosen = numpy.inf, []
    for cost, error in sorted(points):
        if error < best:
            best = error
            chosen.append((cost, error))
    return chosen


def cost(case, measure, kind, prefix, part=0):
    """Error against cost of every line of the case, with the Pareto front, beside other methods."""
    price, column, axis, title = COSTS[kind]
    rows = [
        (
            entry,
            [(price(level), error) for level, error in entry.errors(measure) if price(level) and error > 0],
        )
        for entry in case.series
        if entry.vary in ("cells", "")
    ]
    rows = [(entry, points) for entry, points in rows if points]
    if not rows:
        return None
    every, further, rows = rows, left_out(rows) if part == 0 else "", of_part(rows, part)
    if not rows:
        return None
    notes = {
        id(entry): [level_note(level) for level, error in entry.errors(measure) if price(level) and error > 0]
        for entry, _ in rows
    }
    others = [(entry, entry.costs(column, measure)) for entry in case.comparators]
    others = [(entry, points) for entry, points in others if points]

    def paint(axes):
        best = front([point for _, points in every for point in points])
        axes.plot(*zip(*best), color=svg.INK, linewidth=3.2, alpha=0.16, solid_capstyle="round")
        for entry, points in rows:
            line = marked_line(axes, entry, *zip(*points))
            svg.note(line, notes[id(entry)])
        for entry, points in others:
            axes.plot(
                *zip(*points),
                svg.series_mark(entry.style),
                color=svg.series_colour(entry.style),
                linestyle=(0, (5, 3)),
                linewidth=0.9,
                label=entry.title,
            )
        axes.plot(
            *zip(*best),
            "o",
            markersize=9,
            color=svg.INK,
            markerfacecolor="none",
            markeredgewidth=0.8,
            linestyle="none",
        )
        axes.set(xscale="log", yscale="log", xlabel=axis, ylabel=error_label(case, measure))
        axes.set_ylim(*_margins([error for _, points in every + others for _, error in points], 1.8))
        axes.set_xlim(*_margins([value for _, points in every + others for value, _ in points], 1.8))
        log_axis(axes.xaxis, *axes.get_xlim())
        log_axis(axes.yaxis, *axes.get_ylim())

    series = [entry for entry, _ in rows]
    beside = [entry for entry, _ in others]
    caption = "One mark per run; ringed marks on the broad line are the Pareto front, which no other run beats in both."
    if beside:
        caption += (
            f" Broken: another method on the same problem, {text.listing(entry.title for entry in beside)}, as a comparator"
            + ("; its work is cells × steps." if kind == "work" else ".")
        )
    keys = _keys(series) + [
        Key(entry.title, f"var(--s{entry.style % len(svg.SERIES) + 1})", svg.series_mark(entry.style), dash=True)
        for entry in beside
    ]
    caption += further
    return Figure(
        svg.draw(paint, prefix, f"{measure}: {title}", height=2.7),
        title[0].upper() + title[1:],
        caption,
        list(dict.fromkeys(_files(series) + [entry.file for entry in beside])),
        keys + [Key("Pareto front", "currentColor", "ring")],
        _commands(case, series),
    )
