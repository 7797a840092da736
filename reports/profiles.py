"""Figures of single runs: the profile over the exact solution, and what the ledger could not account for."""

import numpy

import figures
import reproduce
import svg
import text
from figures import Figure, Key

LEVEL_NAMES = ("coarsest", "middle", "finest")
REFERENCE = "_reference"
_BINS = 100
_MOST_DOTS = 80  # points of a run that are drawn one by one; of more, a line
_RESIDUAL_BINS = 24  # of what is noise but for its size
_ERROR_BINS = 60
MOST_RESIDUALS = 3  # lines of a quantity, the default scheme first
_LONGEST_LABEL = 18     # characters that fit along the vertical axis, unit aside
_QUANTITIES = {
    "mass": "mass",
    "momentum_x": "momentum along x",
    "momentum_y": "momentum along y",
    "angular_momentum": "angular momentum",
    "energy": "energy",
}


def fields(profile):
    """Names of the columns that have an exact counterpart."""
    return [name for name in profile if name + REFERENCE in profile]


def envelope(x, y, bins=_BINS):
    """At most two values per bin, the smallest and the largest in their order: the same picture."""
    order = numpy.argsort(x, kind="stable")
    x, y = x[order], y[order]
    finite = numpy.isfinite(x) & numpy.isfinite(y)
    x, y = x[finite], y[finite]
    if len(x) <= 2 * bins:
        return x, y
    kept = []
    for part in numpy.array_split(numpy.arange(len(x)), bins):
        kept += sorted({part[y[part].argmin()], part[y[part].argmax()]})
    return x[kept], y[kept]


def largest_in_bins(x, error, bins=_ERROR_BINS):
    """Bin edges and the largest |error| in each of equal intervals; NaN where a bin is empty."""
    edges = numpy.linspace(numpy.nanmin(x), numpy.nanmax(x), min(bins, max(len(x) // 2, 1)) + 1)
    index = numpy.clip(numpy.digitize(x, edges) - 1, 0, len(edges) - 2)
    largest = numpy.full(len(edges) - 1, numpy.nan)
    for place, value in zip(index, numpy.abs(error)):
        if not value <= largest[place]:  # also replaces the first NaN
            largest[place] = value
    return edges, largest


def chosen_levels(entry, results):
    """[(name, run object, profile)]: the coarsest, middle and finest level that have a profile."""
    found = [
        (level, results[level.get("file")].profile) for level in entry.levels if level.get("file") in results
    ]
    found = [(level, profile) for level, profile in found if fields(profile) and profile.abscissa in profile]
    if len(found) > 3:
        found = [found[0], found[len(found) // 2], found[-1]]
    names = {0: (), 1: ("finest",), 2: ("coarsest", "finest")}.get(len(found), LEVEL_NAMES)
    return [(name, level, profile) for name, (level, profile) in zip(names, found)]


def window(columns, name):
    """((low, high) of the axis of a field, words) where computed values lie beyond the exact ones by more than these span, as behind a
    wall that reflects; else (None, ""). `columns`: profiles with the field and its reference."""
    exact, computed = (numpy.concatenate([one[key] for one in columns]) for key in (name + REFERENCE, name))
    exact, computed = exact[numpy.isfinite(exact)], computed[numpy.isfinite(computed)]
    if not len(exact) or not len(computed) or numpy.ptp(exact) <= 1e-9 * numpy.abs(exact).max():
        return None, ""
    span = numpy.ptp(exact)
    if exact.min() - span <= computed.min() and computed.max() <= exact.max() + span:
        return None, ""
    reach = f"{text.number(float(computed.min()))} to {text.number(float(computed.max()))}"
    return (exact.min() - span / 2, exact.max() + span / 2), f"Computed values reach from {reach}, beyond the axis, which ends half the span of the exact ones from them."


def profile(entry, name, levels, prefix):
    """One field of one line of the case: exact and computed above, the error below."""
    last = levels[-1][2]
    present = [(which, level, columns) for which, level, columns in levels if name + REFERENCE in columns]
    if not present:
        return None

    label = column_label(last, name)
    limits, caption = window([columns for _, _, columns in present], name)
    sizes = [f"{which} {_size(level)}" if len(levels) > 1 else _size(level) for which, level, _ in present]

    def paint(axes):
        upper, lower = axes
        columns = present[-1][2]
        x, y = envelope(columns[columns.abscissa], columns[name + REFERENCE])
        upper.plot(x, y, color=svg.INK, linewidth=3.4, alpha=0.22, solid_capstyle="round", label="exact")
        for size, (which, _, columns) in zip(sizes, present):
            _computed(upper, lower, which, columns, name, size)
        upper.set_ylabel(axis_label(last, name))
        if limits:
            upper.set_ylim(limits)
        few_ticks(upper.yaxis)
        _error_axis(lower)
        lower.set_xlabel(axis_label(last, last.abscissa))
        few_ticks(lower.xaxis)

    keys = [Key("exact", "currentColor", band=True)]
    keys += [
        Key(size, _variable(which), "dot" if _is_sparse(columns, name) else "")
        for size, (which, _, columns) in zip(sizes, present)
    ]
    drawing = svg.draw(
        paint,
        prefix,
        f"{label} of {entry.label} over the exact solution, with the error below",
        height=3.5,
        nrows=2,
        sharex=True,
        gridspec_kw={"height_ratios": [2.1, 1]},
    )
    return Figure(
        drawing,
        f"{label[0].upper() + label[1:]}, {entry.label}",
        caption,
        [level.get("file") for _, level, _ in present],
        keys,
        [command for _, level, _ in present if (command := reproduce.run(level))],
    )


def _computed(upper, lower, which, columns, name, label):
    colour = svg.LEVELS[LEVEL_NAMES.index(which)]
    x, y = columns[columns.abscissa], columns[name]
    style = (
        {"marker": ".", "markersize": 3.2, "linestyle": "none"}
        if _is_sparse(columns, name)
        else {"linewidth": 1.0}
    )
    (line,) = upper.plot(*envelope(x, y), color=colour, label=label, **style)
    line.set_gid(f"class:level-{which}")
    edges, largest = largest_in_bins(x, y - columns[name + REFERENCE])
    largest[~(largest > 0)] = numpy.nan
    if numpy.isfinite(largest).any():
        middles = (edges[1:] + edges[:-1]) / 2
        (below,) = lower.plot(middles, largest, color=colour, linewidth=0.9, label=label)
        below.set_gid(f"class:level-{which}")


def few_ticks(axis):
    axis.set_major_locator(figures.MaxNLocator(6, steps=[1, 2, 2.5, 5, 10]))
    figures.plain_axis(axis)


def _is_sparse(columns, name):
    return len(columns[name]) <= _MOST_DOTS and columns.kind == "space"


def _error_axis(axes):
    values = numpy.concatenate([line.get_ydata() for line in axes.lines] or [[]])
    values = values[numpy.isfinite(values)] if len(values) else values
    axes.set_ylabel("|error|")
    if not len(values):
        axes.annotate("no difference", (0.5, 0.5), xycoords="axes fraction", ha="center")
        return
    high = values.max() * 2
    axes.set(yscale="log", ylim=(max(values.min() / 2, high * 1e-5), high))
    figures.log_axis(axes.yaxis, *axes.get_ylim())


def _variable(which):
    return f"var(--l{LEVEL_NAMES.index(which) + 1})"


def _size(level):
    cells = (level.get("settings") or {}).get("cells")
    return f"{text.count(cells)} cells" if isinstance(cells, (int, float)) else level.get("file") or "?"


def column_label(columns, name):
    return columns.labels.get(name) or name.replace("_", " ")


def axis_label(columns, name):
    """Label with unit; the name of the column where the label is too long for an axis."""
    label = column_label(columns, name)
    label = label if len(label) <= _LONGEST_LABEL else name.replace("_", " ")
    unit = columns.units.get(name)
    return f"{label} in {text.unit(unit)}" if unit and unit != "1" else label


# --- ledger ---------------------------------------------------------------------------------------


def quantity_name(quantity):
    return _QUANTITIES.get(quantity, quantity.replace("_", " "))


def drifts(quantities, finest, prefix, worth_drawing=0.0):
    """Residuals of the conservation budgets over their scale against time, a panel a quantity, for [(series, run result)].

    The file states the largest |residual|/scale of all steps (`relative_drift`), which fixes the scale.
    None where all stay below `worth_drawing`: noise of rounding.
    """
    panels = {quantity: _residuals(quantity, finest) for quantity in quantities}
    panels = {quantity: lines for quantity, lines in panels.items() if lines}
    if max((relative.max() for lines in panels.values() for _, _, relative in lines), default=0) < worth_drawing:
        return None

    largest = text.listing(
        f"{quantity_name(quantity)} {text.number(max(relative.max() for _, _, relative in lines), 2)}"
        for quantity, lines in panels.items()
    )
    count = len({entry.label for lines in panels.values() for entry, _, _ in lines})
    panels = {quantity: lines[:MOST_RESIDUALS] for quantity, lines in panels.items()}

    def paint(axes):
        every = numpy.ravel(axes)
        for panel, (quantity, lines) in zip(every, panels.items()):
            for entry, result, relative in lines:
                edges, largest = largest_in_bins(result.ledger[quantity]["time"], relative, _RESIDUAL_BINS)
                largest[~(largest > 0)] = numpy.nan
                middles = (edges[1:] + edges[:-1]) / 2
                panel.plot(middles, largest, color=svg.series_colour(entry.style), linewidth=1.0, label=entry.label)
            panel.axhline(figures.ROUNDING, color=svg.MUTED, linewidth=0.9, dashes=(4, 1.5, 1, 1.5))
            high = max([relative.max() for _, _, relative in lines] + [1e-13])
            panel.set(yscale="log", ylim=(1e-18, high * 10), ylabel=_panel_name(quantity))
            figures.log_axis(panel.yaxis, *panel.get_ylim())
            panel.yaxis.set_minor_locator(figures.NullLocator())
        every[-1].set_xlabel("time in s")
        few_ticks(every[-1].xaxis)

    entries = {entry.label: entry for lines in panels.values() for entry, _, _ in lines}
    some = f" Drawn are {len(entries)} of {count} lines." if len(entries) < count else ""
    caption = f"Finest run of each line; at most, over all lines: {largest}.{some}"
    keys = [Key(label, f"var(--s{entry.style % len(svg.SERIES) + 1})") for label, entry in entries.items()]
    keys.append(Key("rounding of one operation", "var(--muted)", dash=True))
    files = list(dict.fromkeys(result.name for lines in panels.values() for _, result, _ in lines))
    drawing = svg.draw(
        paint, prefix, f"Residuals of the conservation budgets against time: {largest}", height=0.5 + 1.15 * len(panels), nrows=len(panels),
        sharex=True, squeeze=False,
    )  # fmt: skip
    return Figure(drawing, "Residuals of the conservation budgets", caption, files, keys, [command for _, result in finest[:MOST_RESIDUALS] if (command := reproduce.run(result.run))])


def _residuals(quantity, finest):
    found = [(entry, result, relative_residual(result, quantity)) for entry, result in finest]
    return [(entry, result, relative) for entry, result, relative in found if relative is not None and relative.any()]


def at_rounding(quantities, finest, bound):
    """Names of the quantities, with their largest relative residual, where something is left over, but less than `bound`."""
    found = {quantity: _residuals(quantity, finest) for quantity in quantities}
    largest = {quantity: max(relative.max() for _, _, relative in lines) for quantity, lines in found.items() if lines}
    if max(largest.values(), default=0) >= bound:
        return []
    return [f"{quantity_name(quantity)} {text.number(value, 2)}" for quantity, value in largest.items()]


def _panel_name(quantity):
    return quantity_name(quantity).replace(" along ", " ").replace("angular momentum", "angular mom.")


def closed(quantity, finest):
    """Labels of the lines whose budgets of a quantity close to the last bit at every stored step."""
    found = [(entry, relative_residual(result, quantity)) for entry, result in finest]
    return [entry.label for entry, relative in found if relative is not None and not relative.any()]


def quantities(finest):
    """Quantities that the ledgers hold, in the order of the page."""
    held = dict.fromkeys(quantity for _, result in finest for quantity in result.ledger)
    return sorted(
        held,
        key=lambda quantity: list(_QUANTITIES).index(quantity)
        if quantity in _QUANTITIES
        else len(_QUANTITIES),
    )


def relative_residual(result, quantity):
    """|residual|/scale of a ledger quantity, or None where the file does not hold it."""
    columns = result.ledger.get(quantity) or {}
    book = (result.run.get("ledger") or {}).get(quantity) or {}
    stated = book.get("relative_drift")
    if "residual" not in columns or "time" not in columns or not len(columns["time"]) or stated is None:
        return None
    residual = numpy.abs(columns["residual"])
    largest = abs(book.get("largest_residual") or numpy.nanmax(residual, initial=0.0))
    if largest > 0:
        return residual / largest * abs(stated) if stated else None
    return numpy.zeros_like(residual)
