"""Our own pictures of the figures of York's report: the runs that an entry of york.json names, in one picture, with what the
report's text says of the figure marked in it.

An entry of `pictures` has `figure`, its number, and either `why`, the reason for which there is no picture, or
  `case`     whose studies it draws;
  `runs`     up to eight of {`label`, `study`, `at`: the value of its level}; a label may stand for one run only;
  `panels`   of lines over place or time: {`quantity`, `label`, `runs`: labels, all if not given}. A quantity is a column of the
             profile, or `energy.NAME` of the conservation budget of energy. `factor`: to another unit; `over_start`: as a share
             of its first value; `exact`: with the case's reference; `less`: the label of a run whose values are taken off;
  or `times` at which the points of `bodies` are drawn, "end" the last, in `window` [x, x, y, y], with `apart` each run by itself;
  or `methods`, whose normals at the points of the first run are drawn;
  `says`     what the report's text says: {`page`, `words`}; with `value`, a number or [low, high], it is drawn too: along `axis` y
             (if not given), x or r, a radius about the origin; in the panel of number `panel`, or in all;
  `note`     what else a reader must know, if anything.
"""

import numpy
import scipy.spatial

import figures
import normals
import profiles
import reproduce
import svg
import text
from figures import Figure, Key

PICTURED = (13, 14, 16, 17, 18, 26, 36, 37, 38, *range(49, 56), *range(58, 64), 86, 87, 96)  # need a picture, or a reason
MOST_RUNS = 8
MOST_DOTS = 600  # of a gas in a panel
KINDS = {"panels": "lines", "times": "points", "methods": "normals"}  # by the key that only its kind has
_BUDGET = "energy."
_PANEL, _FRAME = 1.55, 0.55  # inches: height of a panel of lines, of all that is around them


class UnknownName(Exception):
    """A case, study, quantity, body or method that there is not; the text names it and those that there are."""


def faults(pictures, rows, studies):
    """What is wrong with the entries, as sentences: [] if nothing is. `studies`: {case: identifiers of its studies}."""
    kinds = {row["number"]: row for row in rows if row["series"] == "figure"}
    numbers = [entry["figure"] for entry in pictures]
    found = [f"figure {number} has neither a picture nor a reason" for number in PICTURED if number not in numbers]
    found += [f"picture of figure {number} is there twice" for number in _twice(numbers)]
    for entry in pictures:
        name = f"picture of figure {entry['figure']}"
        if entry["figure"] not in kinds:
            found.append(f"{name}: the report has no such figure")
        if "why" in entry:
            continue
        try:
            _kind(entry)
            check_names(entry, studies)
        except UnknownName as error:
            found.append(f"{name}: {error}")
        if len(entry["runs"]) > MOST_RUNS:
            found.append(f"{name}: {len(entry['runs'])} runs, more than {MOST_RUNS}")
        found += [f"{name}: two runs are called {label}" for label in _twice(run["label"] for run in entry["runs"])]
    return found


def _twice(values):
    values = list(values)
    return sorted({value for value in values if values.count(value) > 1})


def _kind(entry):
    kinds = [kind for key, kind in KINDS.items() if key in entry]
    if len(kinds) != 1:
        raise UnknownName(f"one of {', '.join(KINDS)} says what is drawn; there are {len(kinds)}")
    return kinds[0]


def check_names(entry, studies):
    """Raises UnknownName if the entry's case or a study is none of those that are declared."""
    if entry["case"] not in studies:
        raise UnknownName(f"there is no case {entry['case']}")
    for run in entry["runs"]:
        _known(run["study"], studies[entry["case"]], f"{entry['case']} has no study")
    labels = [run["label"] for run in entry["runs"]]
    for panel in entry.get("panels", ()):
        for label in [*panel.get("runs", ()), *([panel["less"]] if "less" in panel else ())]:
            _known(label, labels, "no run is called")


def check_result(entry, result):
    """Raises UnknownName if a run's file lacks a quantity, a body or a method that the entry draws."""
    kind = _kind(entry)
    if kind == "points":
        for name in entry["bodies"]:
            _known(name, [body["name"] for body in result.frames.bodies], f"{result.name} has no body")
    if kind == "normals":
        for name in entry["methods"]:
            _known(name, normals.methods(result.profile), f"{result.name} has no normals by")
    for panel in entry.get("panels", ()):
        quantities = [*result.profile, *(_BUDGET + name for name in result.ledger.get("energy", ()))]
        for name in [panel["quantity"]] + [panel["quantity"] + profiles.REFERENCE] * panel.get("exact", False):
            _known(name, quantities, f"{result.name} has no quantity")


def _known(name, names, complaint):
    if name not in names:
        raise UnknownName(f"{complaint} {name}; there are: {', '.join(names)}")


# --- which results ----------------------------------------------------------------------------------


def drawing(entry, title, cases, results):
    """(Figure or None, why not or ""): of what these results hold of it. Raises UnknownName."""
    kind = _kind(entry)
    case = cases.get(entry["case"])
    if case is None:
        return None, f"{entry['case']} is not in these results"
    found = [(run, results.get(_file(case, run))) for run in entry["runs"]]
    there = [(run, result) for run, result in found if result and (kind != "points" or result.frames)]
    missing = [run for run, _ in found if run not in [one for one, _ in there]]
    if not there:
        return None, f"not in these results: {_named(missing)}"
    if kind == "lines" and not any(_drawn(panel, there) for panel in entry["panels"]):
        return None, f"not in these results: {_named(missing)}"
    for _, result in there:
        check_result(entry, result)
    draw = {"lines": _lines, "points": _points, "normals": _normals}[kind]
    styles = _styles(entry["runs"])
    drawn, keys = draw(entry, there, styles, anchor(entry["figure"]), title)
    said = "; ".join(f"{said['words']} (p.\u00a0{said['page']})" for said in entry.get("says", ()))
    words = [f"The report’s text: {said}."] if said else []
    if "note" in entry:
        words.append(f"{entry['note']}.")
    if missing:
        makes = f"“plumbline verify {entry['case']} --tier full” makes all"
        words.append(f"Not in these results: {_named(missing)}; {makes}.")
    commands = [_command(result, kind) for _, result in there]
    return Figure(drawn, title, " ".join(words), [result.name for _, result in there], keys, [command for command in commands if command]), ""


def _command(result, kind):
    return reproduce.pictures(result.run, len(result.frames)) if kind == "points" else reproduce.run(result.run)


def anchor(figure):
    """An identifier for links to the picture of a figure."""
    return f"york-figure-{figure}"


def _file(case, run):
    """The file of the level that an entry's run names; None where these results have none."""
    for series in case.series:
        for level in series.levels:
            if series.study == run["study"] and level.get("value") == run["at"]:
                return level.get("file")
    return None


def _named(runs):
    return text.listing(f"{run['label']} (study {run['study']} at {text.number(run['at'])})" for run in runs)


def _styles(runs):
    """{label: colour}: the same for the default scheme and for York's in all pictures."""
    schemes = ("default", "york1997")
    labels = [run["label"] for run in runs]
    labels.sort(key=lambda label: [label != scheme for scheme in schemes] + [not label.startswith(scheme) for scheme in schemes])
    return {label: svg.series_colour(number) for number, label in enumerate(labels)}


def _run_keys(there, styles, mark=""):
    return [Key(run["label"], f"var(--s{svg.SERIES.index(styles[run['label']]) + 1})", mark) for run, _ in there]


# --- lines over place or time -----------------------------------------------------------------------


def _lines(entry, there, styles, prefix, title):
    panels = [(number, panel) for number, panel in enumerate(entry["panels"]) if _drawn(panel, there)]
    columns = 2 if len(panels) > 3 else 1
    rows = -(-len(panels) // columns)
    alike = not any("runs" in panel for _, panel in panels)

    def paint(axes):
        every = numpy.ravel(axes)
        for axis in every[len(panels) :]:
            axis.set_visible(False)
        for place, (axis, (number, panel)) in enumerate(zip(every, panels)):
            along = _panel(axis, panel, there, styles)
            _mark(axis, entry, number, outside=True, first=place == 0 or not alike)
            axis.set_ylabel(panel["label"])
            _few_ticks(axis.yaxis)
            _few_ticks(axis.xaxis)
            if not alike or place >= len(panels) - columns:
                axis.set_xlabel(along)

    drawn = svg.draw(
        paint, prefix, title, height=_FRAME + _PANEL * rows, nrows=rows, ncols=columns, sharex=alike, squeeze=False
    )
    keys = _run_keys(there, styles)
    if any(panel.get("exact") for _, panel in panels):
        keys.append(Key("exact", "currentColor", band=True))
    return drawn, keys + _says_keys(entry)


def _drawn(panel, there):
    """The runs whose lines a panel has: [(run, result)]; none if what is to be taken off is not there."""
    labels = [run["label"] for run, _ in there]
    if panel.get("less", labels[0]) not in labels:
        return []
    return [pair for pair in there if pair[0]["label"] in panel.get("runs", labels)]


def _panel(axis, panel, there, styles):
    """The lines of a panel; returns the label of what they are drawn over."""
    quantity, runs = panel["quantity"], _drawn(panel, there)
    if panel.get("exact"):
        # Of runs that end at different times the longest.
        x, y, _ = max((_values(result, quantity + profiles.REFERENCE) for _, result in runs), key=lambda columns: columns[0].max())
        y = y * panel.get("factor", 1)
        axis.plot(*profiles.envelope(x, y), color=svg.INK, linewidth=3.4, alpha=0.22, solid_capstyle="round", label="exact")
    base = next((result for run, result in there if run["label"] == panel.get("less")), None)
    for run, result in runs:
        x, y, along = _values(result, quantity)
        y = y * panel.get("factor", 1)
        if panel.get("over_start"):
            y = y / y[0]
        if base is not None:
            x, y = _difference(result, base, quantity)
        axis.plot(*profiles.envelope(x, y), color=styles[run["label"]], linewidth=1.0, label=run["label"])
    return along


def _values(result, quantity):
    """(where or when, values, label of the first) of a quantity of a run."""
    if quantity.startswith(_BUDGET):
        columns = result.ledger["energy"]
        return columns["time"], columns[quantity.removeprefix(_BUDGET)], "time in s"
    columns = result.profile
    order = numpy.argsort(columns[columns.abscissa], kind="stable")
    label = profiles.axis_label(columns, columns.abscissa)
    return columns[columns.abscissa][order], columns[quantity][order], label


def _difference(result, base, quantity):
    """(where or when, difference): of fields that of the means over the cells, which points of two runs are in at other places."""
    columns = []
    for one in (result, base):
        x, y, _ = _values(one, quantity)
        if one.profile.kind == "space":
            cells, which = numpy.unique(numpy.floor(x / one.run["h"]), return_inverse=True)
            x, y = (cells + 0.5) * one.run["h"], numpy.bincount(which, y) / numpy.bincount(which)
        columns.append((x, y))
    (x, y), (places, values) = columns
    return places, numpy.interp(places, x, y) - values


def _few_ticks(axis):
    axis.set_major_locator(figures.MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]))
    figures.plain_axis(axis)


# --- what the report's text says --------------------------------------------------------------------


def _mark(axis, entry, number, outside=False, first=True):
    """What the text gives as a number, in the panel of this number: a dashed line or a band, with its page.

    `outside`: there is nothing above the panel, and the words at a place on the x axis stand there; `first`: no panel above has the same words.
    """
    for said in entry.get("says", ()):
        if "value" not in said or said.get("panel", number) != number:
            continue
        low, high = said["value"] if isinstance(said["value"], list) else (said["value"],) * 2
        along = said.get("axis", "y")
        if along == "r":
            turn = numpy.linspace(0, 2 * numpy.pi, 181)
            axis.plot(low * numpy.cos(turn), low * numpy.sin(turn), color=svg.INK, linewidth=0.8, dashes=(4, 3), scalex=False, scaley=False)
            continue
        line, band = (axis.axhline, axis.axhspan) if along == "y" else (axis.axvline, axis.axvspan)
        if high > low:
            band(low, high, color=svg.INK, alpha=0.12, linewidth=0)
        else:
            line(low, color=svg.INK, linewidth=0.8, dashes=(4, 3))
        page = f"p.\u00a0{said['page']}"
        words = f"{text.number(low, 5)}, {page}" if low == high else page
        place = {"xy": (1, high), "xycoords": ("axes fraction", "data"), "xytext": (0, 2), "ha": "right", "va": "bottom"}
        if along == "x":
            left = high < numpy.mean(axis.get_xlim())
            place = {"xy": (high, 1), "xycoords": ("data", "axes fraction")}
            place |= {"xytext": (0, 2), "ha": "left" if left else "right", "va": "bottom"} if outside else {"xytext": (-3, 0), "ha": "right", "va": "top"}
        if along == "y" or first:
            axis.annotate(words, textcoords="offset points", fontsize=7.5, **place)


def _says_keys(entry):
    drawn = [said["value"] for said in entry.get("says", ()) if "value" in said]
    bands = [value for value in drawn if isinstance(value, list)]
    keys = [Key("a number of the report’s text", "currentColor", dash=True)] if len(bands) < len(drawn) else []
    return keys + ([Key("a range of the report’s text", "currentColor", band=True)] if bands else [])


# --- points -----------------------------------------------------------------------------------------


def _points(entry, there, styles, prefix, title):
    """A panel for each time, and for each run where they are apart; the axes alike."""
    bodies = {run["label"]: _bodies(result, entry["bodies"]) for run, result in there}
    groups = [[pair] for pair in there] if entry.get("apart") else [there]
    panels = [(number, time, runs) for number, time in enumerate(entry["times"]) for runs in groups]
    columns = min(len(panels), 2 if len(panels) in (2, 4) else 3)
    rows = -(-len(panels) // columns)
    window = entry["window"]
    shape = (window[3] - window[2]) / (window[1] - window[0])

    def paint(axes):
        every = numpy.ravel(axes)
        for axis in every[len(panels) :]:
            axis.set_visible(False)
        for axis, (number, time, runs) in zip(every, panels):
            whens = []
            for run, result in runs:
                frame = _frame_at(result.frames.times, time)
                whens.append(text.number(float(result.frames.times[frame]), 2))
                for body in bodies[run["label"]]:
                    _body(axis, result.frames, frame, body, styles[run["label"]], run["label"])
            _mark(axis, entry, number)
            named = f"{runs[0][0]['label']}\n" if entry.get("apart") else ""
            axis.set_title(f"{named}t = {', '.join(dict.fromkeys(whens))} s", fontsize=8)
            axis.set(xlim=window[:2], ylim=window[2:], aspect="equal")
            axis.grid(False)
            for side in (axis.xaxis, axis.yaxis):
                side.set_major_locator(figures.MaxNLocator(3, steps=[1, 2, 4, 5, 10]))
                figures.plain_axis(side)

    height = min(9.5, rows * (shape * 4.3 / columns + (0.55 if entry.get("apart") else 0.4)) + 0.2)
    drawn = svg.draw(paint, prefix, title, height=height, nrows=rows, ncols=columns, sharex=True, sharey=True, squeeze=False)
    return drawn, _run_keys(there, styles) + _says_keys(entry)


def _frame_at(times, time):
    """Number of the frame next to a time, or of the last."""
    return len(times) - 1 if time == "end" else int(numpy.argmin(numpy.abs(times - time)))


def _bodies(result, names):
    """Numbers of the bodies of these names."""
    return [number for number, body in enumerate(result.frames.bodies) if body["name"] in names]


def _body(axis, frames, frame, number, colour, label):
    """A membrane as a line, a solid by its convex outline, a gas by its points or some of them."""
    places = frames.body(frame, number)["position"][:, :2].astype(float)
    if frames.bodies[number]["kind"] == "solid":
        outline = scipy.spatial.ConvexHull(places).vertices
        places = places[numpy.append(outline, outline[0])]
    if frames.bodies[number]["kind"] == "gas":
        # Multiples of the golden section leave out points evenly.
        kept = numpy.arange(len(places)) * 0.6180339887 % 1 < MOST_DOTS / max(len(places), 1)
        axis.plot(*places[kept].T, ".", color=colour, markersize=1.6)
    else:
        axis.plot(*places.T, color=colour, linewidth=1.0, label=label)


# --- normals ----------------------------------------------------------------------------------------


def _normals(entry, there, styles, prefix, title):
    run, result = there[0]
    figure = normals.needles(result.profile, run["label"], result.name, prefix, entry["methods"])
    return figure.svg, figure.keys
