"""Figures of the section on cost: time to the target over all cases, and the surface over cell size and step."""

import math

import matplotlib
import matplotlib.cm
import numpy
from matplotlib import colors
from matplotlib.patches import Rectangle

import svg
import text
from cost import MORE, MOST, TARGET, YORK, wall_time
from cost_estimates import AT
from figures import Figure, Key, log_axis, tick
from plumbline.reader import COST_FILE

_MARK = {"": "o", "<": "<", ">": ">", AT: "o", MOST: "<", MORE: ">"}
ROW = 0.17  # inches of a row


def relative_to_york(found):
    """One row a case: time to the target over that of York's scheme."""
    rows = []
    for entry in found:
        if not entry.york:
            continue
        ratios = [(line, entry.ratio(line)) for line in entry.lines if line.scheme != YORK]
        ratios = [(line, value) for line, value in ratios if value.sign != "?"]
        if ratios:
            rows.append((entry.name, ratios))
    if not rows:
        return None
    values = [value.value for _, ratios in rows for _, value in ratios]

    def paint(axes):
        axes.axvline(1, color=svg.INK, linewidth=1)
        for place, (_, ratios) in enumerate(reversed(rows)):
            for line, value in sorted(ratios, key=lambda pair: pair[0].scheme == "default" and pair[0].study == "default"):
                _mark(axes, value.value, place, value.sign, _is_default(line))
        axes.set(xscale="log", xlim=(min(values + [1]) / 2.5, max(values + [1]) * 2.5))
        axes.set_xlabel("time to 1 % error over that of york1997")
        _row_labels(axes, [name for name, _ in reversed(rows)])

    caption = (
        "Time to 1 % relative error over the time that York’s own scheme needs on the same problem; left of the line is "
        "cheaper. Triangles are bounds: one that points left stands where the true value is smaller still, because York’s "
        "finest run is not at 1 % yet, or the scheme’s coarsest is already better; one that points right where it is larger. "
        "Cases in which nothing follows (both better than 1 % at their coarsest, or neither there) have no mark; the table "
        "has them."
    )
    return Figure(
        svg.draw(paint, "cost-york", "Time to 1 % error relative to York's scheme, by case", height=0.9 + ROW * len(rows)),
        "Time to 1 % error, relative to york1997",
        caption,
        [COST_FILE],
        _keys(),
    )


def absolute(found):
    """One row a case: the time to the target itself, where there is no study of York's scheme to compare with."""
    rows = [entry for entry in found if not entry.york]
    rows = [entry for entry in rows if entry.line("default")]
    if not rows:
        return None
    costs = [entry.reaches[line.label].cost for entry in rows for line in entry.lines]
    costs = [cost for cost in costs if math.isfinite(cost)]

    def paint(axes):
        for place, entry in enumerate(reversed(rows)):
            for line in sorted(entry.lines, key=_is_default):
                reached = entry.reaches[line.label]
                if math.isfinite(reached.cost):
                    _mark(axes, reached.cost, place, reached.kind, _is_default(line))
            if entry.comparator and math.isfinite(entry.comparator.cost):
                mark = {"at": "D"}.get(entry.comparator.kind, _MARK[entry.comparator.kind])
                axes.plot(entry.comparator.cost, place, mark, color=svg.series_colour(3), markersize=4, markerfacecolor="none")
        axes.set(xscale="log", xlim=(min(costs) / 2.5, max(costs) * 2.5), xlabel="time to 1 % error in s, one thread")
        _row_labels(axes, [entry.name for entry in reversed(rows)])

    caption = (
        "The same for cases that have no study of York’s scheme: there the time stands alone. A triangle to the left: the "
        "coarsest mesh is better than 1 % already. A triangle to the right: the finest mesh is not there, the scheme needs "
        "more than this, or never arrives."
    )
    keys = _keys() + [Key("second-order finite volumes", "var(--s4)", "D")]
    return Figure(
        svg.draw(paint, "cost-absolute", "Time to 1 % error in seconds, by case", height=0.9 + ROW * len(rows)),
        "Time to 1 % error, cases without york1997",
        caption,
        [COST_FILE],
        keys,
    )


def _is_default(line):
    return line.scheme == "default" and line.study == "default"


def _mark(axes, value, place, sign, leading):
    colour = svg.series_colour(0) if leading else svg.MUTED
    axes.plot(
        value, place, _MARK[sign], color=colour, markersize=5.5 if leading else 3.5, alpha=1.0 if leading else 0.7,
        markeredgewidth=0,
    )  # fmt: skip


def _row_labels(axes, names):
    axes.set_yticks(range(len(names)), names, fontsize=7.5)
    axes.set_ylim(-0.7, len(names) - 0.3)
    axes.tick_params(axis="y", length=0)
    log_axis(axes.xaxis, *axes.get_xlim())


def _keys():
    return [Key("the default scheme", "var(--s1)", "o"), Key("other choices that were studied", "var(--muted)", "dot")]


# --- the surface over cell size and step ----------------------------------------------------------


def surface_runs(document, scheme):
    """{(cells, Courant number): run} of the surface of a scheme, and its axes."""
    runs = [run for run in document["runs"] if run["study"] == "surface" and run["scheme"] == scheme]
    found = {(run["cells"], run["value"]): run for run in runs}
    return found, sorted({cells for cells, _ in found}), sorted({courant for _, courant in found})


def own_courant(document, surface, cells):
    """The Courant number of York's own step at so many cells: steps are in inverse proportion to it."""
    own = [
        run
        for run in document["runs"]
        if run["case"] == "sod" and run["study"] in (YORK, f"levels/{YORK}") and run["cells"] == cells
    ]
    others = [(courant, run) for (count, courant), run in surface.items() if count == cells and run["finished"]]
    if not own or not others:
        return None
    courant, nearest = min(others)
    return courant * nearest["steps"] / own[0]["steps"]


def surface(document, scheme, measure="density.L1"):
    runs, cells, courants = surface_runs(document, scheme)
    if len(cells) < 2 or len(courants) < 2:
        return None
    errors = numpy.array(
        [[_error(runs.get((count, courant)), measure) for count in cells] for courant in courants], dtype=float
    )
    costs = numpy.array(
        [[_cost(runs.get((count, courant))) for count in cells] for courant in courants], dtype=float
    )
    if not numpy.isfinite(errors).any():
        return None
    own = [(place, own_courant(document, runs, count)) for place, count in enumerate(cells)]
    own = [(place, numpy.interp(math.log(value), numpy.log(courants), range(len(courants)))) for place, value in own if value]

    def paint(axes):
        shades = matplotlib.colormaps["viridis_r"]
        scale = colors.LogNorm(numpy.nanmin(errors), numpy.nanmax(errors))
        for row in range(len(courants)):
            for column in range(len(cells)):
                has_stopped = (cells[column], courants[row]) in runs and not math.isfinite(errors[row, column])
                _cell(axes, column, row, errors[row, column], has_stopped, shades, scale)
        known = numpy.ma.masked_invalid(costs)
        if known.count() > 3:
            levels = 10.0 ** numpy.arange(math.floor(math.log10(known.min())), math.ceil(math.log10(known.max())) + 1)
            lines = axes.contour(range(len(cells)), range(len(courants)), known, levels=levels, colors=["#d03030"], linewidths=1.1)
            axes.clabel(lines, fmt=lambda value: text.seconds(value).replace("\u202f", " "), fontsize=7.5, colors=["#b01010"])
        for place, height in own if scheme == YORK else []:
            axes.plot(place, height, "o", markersize=9, markerfacecolor="none", color=svg.INK, markeredgewidth=1.4)
        bar = axes.figure.colorbar(matplotlib.cm.ScalarMappable(scale, shades), ax=axes, label=f"error in {measure}", pad=0.02)
        log_axis(bar.ax.yaxis, scale.vmin, scale.vmax)
        bar.outline.set_visible(False)
        axes.set_xticks(range(len(cells)), [str(count) for count in cells])
        axes.set_yticks(range(len(courants)), [tick(courant) for courant in courants])
        axes.set(xlabel="cells", ylabel="Courant number", xlim=(-0.5, len(cells) - 0.5), ylim=(-0.5, len(courants) - 0.5))
        axes.grid(False)

    caption = (
        f"Sod’s tube under {scheme}: error in {measure} over cells and Courant number, the smaller the lighter; red lines are "
        "equal wall time. "
        + ("Rings: York’s own step, in proportion to the cell size. " if scheme == YORK and own else "")
        + ("An empty field was too long for the tier, a hatched one stopped." if not numpy.isfinite(errors).all() else "")
    )
    return Figure(
        svg.draw(paint, f"cost-surface-{scheme}", f"Error over cells and Courant number under {scheme}", height=3.2),
        f"Error over mesh and step, {scheme}",
        caption.strip(),
        [COST_FILE],
        [Key("equal wall time", "#d03030")] + ([Key("York’s step", "currentColor", "ring")] if scheme == YORK and own else []),
    )


def _error(run, measure):
    return (run["errors"].get(measure) or {}).get("error", math.nan) if run and run["finished"] else math.nan


def _cost(run):
    return wall_time(run) if run and run["finished"] else math.nan


def _cell(axes, column, row, error, has_stopped, shades, scale):
    known = math.isfinite(error)
    face = colors.to_hex(shades(scale(error))) if known else "none"
    axes.add_patch(
        Rectangle(
            (column - 0.5, row - 0.5), 1, 1, facecolor=face, edgecolor=svg.GRID, linewidth=0.4, hatch="///" if has_stopped else None
        )
    )
    if known:
        red, green, blue = colors.to_rgb(face)
        dark = 0.3 * red + 0.59 * green + 0.11 * blue < 0.5
        axes.annotate(tick(error), (column, row), ha="center", va="center", fontsize=7.5, color="#ffffff" if dark else "#000000")


def york_step(document, measure="density.L1", cells=100):
    """What York's step costs on Sod's tube, measured: {"rows": [...], "stated": ..., "holds": bool}, or None."""
    runs, _, courants = surface_runs(document, YORK)
    own = next(
        (run for run in document["runs"] if run["case"] == "sod" and run["study"] == YORK and run["cells"] == cells), None
    )
    larger = [(courant, runs.get((cells, courant))) for courant in courants if courant >= 0.4]
    larger = [(courant, run) for courant, run in larger if run and run["finished"] and measure in run["errors"]]
    if not own or measure not in own["errors"] or not larger:
        return None
    error = own["errors"][measure]["error"]
    rows = [
        {
            "courant": text.number(courant),
            "steps": text.count(run["steps"]),
            "factor": own["steps"] / run["steps"],
            "time_factor": wall_time(own) / wall_time(run),
            "change": run["errors"][measure]["error"] / error - 1,
            "error": text.number(run["errors"][measure]["error"]),
        }
        for courant, run in larger
    ]
    low, high = min(row["factor"] for row in rows), max(row["factor"] for row in rows)
    worst = max(row["change"] for row in rows)
    for row in rows:
        row["factor"], row["time_factor"] = text.number(row["factor"], 3), text.number(row["time_factor"], 2)
        row["change"] = f"{100 * row['change']:+.1f}\u202f%".replace("-", "−")
    return {
        "rows": rows,
        "steps": text.count(own["steps"]),
        "error": text.number(error),
        "factors": f"{text.number(low, 2)} to {text.number(high, 2)}",
        "gain": f"{100 * worst:.0f}\u202f%".replace("-", "−"),
        "holds": low >= 0.9 * 25 and high <= 1.1 * 45 and worst <= 0.12,
    }
