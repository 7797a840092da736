"""Our pictures of York's figures: drawn of invented results that hold what each entry names, and of results that do not."""

import copy
import functools
import html
import re

import cases as gathering
import matplotlib
import numpy
import pytest
import svg
import york
import york_figures
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Annotation, Text
from plumbline import reader

BUDGET = "energy."
PICTURES = {entry["figure"]: entry for entry in york.load("pictures")}


def frames(names):
    """Two bodies' worth of points that move, one snapshot a tenth of a second."""
    times = numpy.linspace(0, 1, 11)
    bodies = [{"name": name, "kind": "solid" if name == "probe" else "gas" if name == "gas" else "membrane", "chain": name not in ("probe", "gas")} for name in names]
    places = numpy.array([[0.1, 0.1], [0.3, 0.1], [0.3, 0.3], [0.1, 0.3]])
    count = len(times) * len(bodies) * len(places)
    points = {"position": numpy.tile(places, (len(times) * len(bodies), 1)), "body": numpy.tile(numpy.repeat(numpy.arange(len(bodies)), len(places)), len(times))}
    return reader.Frames(times, bodies, {"dim": 2}, {}, 1, points, numpy.linspace(0, count, len(times) + 1).astype(int))


def results_of(entry):
    """({case: Case}, {name: Result}) that hold each run of an entry with all that it draws."""
    case, results = gathering.Case(entry["case"]), {}
    x = numpy.linspace(0, 1, 50)
    for number, run in enumerate(entry["runs"]):
        name = f"{entry['case']}-{number}.h5"
        result = reader.Result("run", name, 2, run={"h": 0.05})
        columns = {"x": x}
        for panel in entry.get("panels", ()):
            columns |= {panel["quantity"]: 1 + number + x, panel["quantity"] + "_reference": 1 + x}
        for method in entry.get("methods", ()):
            columns |= {part: numpy.cos(x) for part in ("y", "normal_x", "normal_y", f"{method}.normal_x", f"{method}.normal_y")}
        result.profile = reader.Columns({key: value for key, value in columns.items() if not key.startswith(BUDGET)}, {"x": "m"}, {}, "x", "space")
        result.ledger = {"energy": {"time": x, "store": 2 - 0.01 * x}}
        if "bodies" in entry:
            result.frames = frames(entry["bodies"])
        results[name] = result
        case.series.append(gathering.Series("york1997", "cells", {}, [{"file": name, "value": run["at"]}], {}, [name], study=run["study"]))
    return {case.name: case}, results


def drawn(entry):
    figure, why = york_figures.drawing(entry, f"Figure {entry['figure']}", *results_of(entry))
    assert why == ""
    return figure


@functools.cache
def picture(number):
    return drawn(PICTURES[number])


@pytest.mark.parametrize("number", york_figures.PICTURED)
def test_each_figure_that_shows_a_result_has_a_picture_or_a_reason(number):
    entry = PICTURES[number]
    if "why" in entry:
        assert len(entry["why"]) > 20
        return
    assert f'id="{york_figures.anchor(number)}"' in picture(number).svg


def test_pictures_are_on_the_page_and_reasons_in_the_table():
    part = york.page(*results_of(PICTURES[26]))
    rows = {row["name"]: row for row in part["rows"]}
    assert part["pictures"] == [rows["Figure 26"]["picture"]] and rows["Figure 26"]["no_picture"] == ""
    assert rows["Figure 13"]["picture"] is None and rows["Figure 13"]["no_picture"] == "sod is not in these results"


@pytest.mark.parametrize("number", [number for number, entry in PICTURES.items() if entry.get("says")])
def test_marks_are_those_of_the_list(number):
    entry = PICTURES[number]
    figure = picture(number)
    words = html.unescape(figure.svg).replace("\u2212", "-")
    for said in entry["says"]:
        assert f"{said['words']} (p.\u00a0{said['page']})" in figure.caption
        if "value" in said and said.get("axis") != "r":
            given = "" if isinstance(said["value"], list) else f"{said['value']:.5g}, "
            assert f">{given}p.\u00a0{said['page']}<" in words
    unmarked = drawn({**entry, "says": []})
    assert len(re.findall("<path", figure.svg)) - len(re.findall("<path", unmarked.svg)) == marks(entry)


@pytest.mark.parametrize("number", [number for number, entry in PICTURES.items() if any("value" in said for said in entry.get("says", ()))])
def test_words_at_marks_stand_clear_of_other_words_and_marks(number, monkeypatch):
    crowded = []

    def measure(paint, prefix, label, height, **subplots):
        with matplotlib.rc_context(svg._STYLE):
            figure = Figure(figsize=(svg.WIDTH, height))
            canvas = FigureCanvasAgg(figure)
            paint(figure.subplots(**subplots))
            canvas.draw()
        texts = [part for part in figure.findobj(Text) if part.get_visible() and part.get_text() and all(axes.get_visible() for axes in [part.axes] if axes)]
        words = [part for part in texts if isinstance(part, Annotation)]
        dashed = [line for axes in figure.axes for line in axes.lines if line.is_dashed() and len(line.get_xdata()) == 2]
        for part in words:
            box = part.get_window_extent()
            crowded.extend((part.get_text(), other.get_text()) for other in texts if other is not part and box.overlaps(other.get_window_extent()))
            crowded.extend((part.get_text(), "a mark") for line in dashed if box.overlaps(line.get_window_extent()))
        assert words or not any(said.get("axis") != "r" for said in PICTURES[number]["says"] if "value" in said)
        return ""

    monkeypatch.setattr(svg, "draw", measure)
    york_figures.drawing(PICTURES[number], f"Figure {number}", *results_of(PICTURES[number]))
    assert crowded == []


def marks(entry):
    """Dashed lines and bands that an entry asks for: one a panel that it names, or one in each."""
    panels = len(entry.get("panels", entry.get("times", ()))) * (len(entry["runs"]) if entry.get("apart") else 1)
    return sum(1 if "panel" in said else panels for said in entry["says"] if "value" in said)


def test_york_and_default_are_in_one_picture():
    for entry in PICTURES.values():
        if "runs" in entry and "methods" not in entry:
            labels = " ".join(run["label"] for run in entry["runs"])
            assert "default" in labels and ("york1997" in labels or entry["figure"] == 13), entry["figure"]


def test_a_run_that_is_not_there_is_named():
    entry = PICTURES[26]
    cases, results = results_of(entry)
    del results["spring-mass-1.h5"]
    figure, _ = york_figures.drawing(entry, "Figure 26", cases, results)
    missing = "Not in these results: default (study york-load at 10); “plumbline verify spring-mass --tier full” makes all."
    assert missing in figure.caption and figure.files == ["spring-mass-0.h5"]
    assert york_figures.drawing(entry, "Figure 26", cases, {})[1].startswith("not in these results: york1997 (study york1997 at 10)")
    assert york_figures.drawing(entry, "Figure 26", {}, {}) == (None, "spring-mass is not in these results")


def test_the_default_scheme_has_one_colour_in_all_pictures():
    for entry in PICTURES.values():
        colours = {key.label: key.colour for key in picture(entry["figure"]).keys} if "runs" in entry else {}
        assert colours.get("default", "var(--s1)") == "var(--s1)"


@pytest.mark.parametrize("figure, change, message", [
    (26, lambda entry: entry["panels"][0].update(quantity="heigth"), "has no quantity heigth; there are: x, displacement"),
    (49, lambda entry: entry["panels"][2].update(quantity="energy.stores"), "has no quantity energy.stores"),
    (26, lambda entry: entry["panels"][0].update(quantity="x"), "has no quantity x_reference"),
    (52, lambda entry: entry.update(bodies=["membrain"]), "has no body membrain; there are: membrane"),
    (86, lambda entry: entry.update(methods=["york-masses"]), "has no normals by york-masses; there are: york-mass-matrix-quadratic"),
])  # fmt: skip
def test_what_a_result_does_not_hold_is_an_error_that_names_it(figure, change, message):
    cases, results = results_of(PICTURES[figure])
    entry = copy.deepcopy(PICTURES[figure])
    change(entry)
    with pytest.raises(york_figures.UnknownName, match=re.escape(message)):
        york_figures.drawing(entry, "Figure", cases, results)


def test_differences_of_fields_are_those_of_means_over_cells():
    """Of two runs with one field, seen at other points, nothing is left."""
    entry = {"figure": 1, "case": "sod", "runs": [{"label": name, "study": name, "at": 1} for name in ("a", "b")]}
    entry["panels"] = [{"quantity": "density", "label": "difference", "runs": ["b"], "less": "a"}]
    _, results = results_of(entry)
    first, second = results.values()
    for result, places in ((first, (0.01, 0.04, 0.06, 0.09)), (second, (0.02, 0.03, 0.07, 0.08))):
        result.profile.update(x=numpy.array(places), density=numpy.array(places))
    places, left = york_figures._difference(second, first, "density")
    assert places == pytest.approx([0.025, 0.075]) and left == pytest.approx([0, 0])
