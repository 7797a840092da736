"""The part of the page on stability: true to the document, whole where the document has gaps, light with many maps."""

import copy
import json
import math
import re

import numpy
import pytest

import cost
import maps
from plumbline import reader
import stability
import synthetic_results
import text
from conftest import each_without
from html_page import Page, pixels_of, source_of, tables_of, without_scripts
from synthetic_results import bar_limit, bar_maps, gate, stability_document, write_stability, write_verdicts


def page_of(folder, document=None):
    write_stability(folder, document)
    return source_of(folder)


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    return page_of(tmp_path_factory.mktemp("stability"))


@pytest.fixture(scope="module")
def parsed(source):
    return Page(source)


def loaded(tmp_path, document):
    write_stability(tmp_path, document)
    return reader.load_stability(tmp_path / "stability.json")


def rows_of(parsed, section):
    return [cells for where, cells in parsed.rows if where == section]


# --- numbers --------------------------------------------------------------------------------------


def test_every_safe_number_is_that_of_the_document(parsed):
    rows = {cells[0]: cells for cells in rows_of(parsed, "stability") if " · " in cells[0] and cells[0][0].islower()}
    assert len(rows) == 6
    assert rows["usf · linear · flip"][1] == "0.99", "the edge with one point per cell has the smallest limit"
    assert "a free edge (problem bar-edge) with 1 per cell" in rows["usf · linear · flip"][2]
    assert rows["usf · linear · flip"][3:] == ["1 at 0 regular 1.2 edge 0.99", "1.414 at 0 regular 1.735 edge 1.399"]
    assert rows["usl · linear · flip"][1] == "0.0141 smallest known"
    assert "0.7071 inside a body (problem bar), but only 0.0141 at a free edge" in rows["usl · linear · flip"][2]
    assert rows["usl · linear · apic"][1] == "none" and "Not safe" in rows["usl · linear · apic"][2]
    assert rows["implicit_midpoint · linear · flip"][1] == "every step"
    assert rows["usl_old · linear · flip"][1:3] == ["—", "Not determined."]
    order = [name.split(" · ")[0] for name in rows]
    assert order[0] == "usl" and order[-1] == "implicit_midpoint", "what grows first, then the smallest"


@pytest.mark.parametrize(
    "value, words", [(1.414, "1.414"), (1.99996, "1.999"), (2.0, "2"), (0.70719, "0.7071"), (0.0, "0")]
)
def test_a_safe_number_is_never_rounded_up(value, words):
    assert stability.floored(value) == words


def test_limits_of_a_problem_are_those_of_the_document(parsed):
    rows = [cells[-7:] for cells in rows_of(parsed, "stability-bar") if len(cells) >= 7 and "…" in "".join(cells)]
    rows = [cells for cells in rows if cells[0].startswith("flip, N 0.")]
    expected = [(name, place) for name in ("usf", "musl", "usl") for place in (0.1, 0.3, 0.5)]
    assert len(rows) == len(expected)
    for cells, (name, place) in zip(rows, expected):
        limit = bar_limit(name, place)
        assert cells[0] == f"flip, N {place}"
        said = {("usf", 0.1): " smallest known"}.get((name, place), "")
        said = " smallest known: 0.0141 on bar-edge" if name == "usl" else said
        assert cells[1] == f"0 … {text.number(limit, 6)}{said}"
        assert cells[2] == f"{text.number(limit, 6)} +3 × 10⁻⁶ %"
        assert cells[3] == maps.bracket(0.998 * limit, 1.001 * limit)
        assert cells[4] == "−0.05 %"


def test_the_smallest_known_limit_stands_beside_every_other():
    """Whatever limit is shown, the page names its problem and, where it is not the smallest known, the one that is."""
    document = _filled(stability_document())
    shown = stability.page(document, {})
    usl, alpha = shown["known"]
    assert (usl["integrator"], usl["smallest"], usl["problem"]) == ("usl", "0.0141", "bar-edge (linear flip, ppc 2)")
    assert usl["others"] == ["0.7071 on bar (linear flip, ppc 2)"] and usl["growing"] == ["gas (linear flip, ppc 2)"]
    assert alpha["smallest"] == "1.234", "rounded down"
    assert alpha["parameters"] == "rho_b 0.5" and alpha["endless"] == ["bar (linear flip, ppc 2)"]
    assert alpha["unknown"] == [{"where": "coupled", "why": "it gives no loss back"}]
    assert alpha["apart"] == ["oscillator: 1.9 1/ω"]
    rows = shown["problems"][0]["rows"]
    said = {(row["label"], row["choices"]): row["smallest"] for row in rows}
    assert said["usl", "flip, N 0.3"] == "smallest known: 0.0141 on bar-edge"
    assert said["usf", "flip, N 0.1"] == "smallest known" and said["musl", "flip, N 0.1"] == ""
    safe = {row["key"][1:]: row["smallest"] for row in shown["safe"]["rows"]}
    assert safe["usl", "linear", "flip"] == "smallest known" and safe["usf", "linear", "flip"] == ""
    document["problems"][0]["safe"][3]["edge"] = 0.3
    safe = {row["key"][1:]: row["smallest"] for row in stability.page(document, {})["safe"]["rows"]}
    assert safe["usl", "linear", "flip"] == "smallest known: 0.0141 on bar-edge"


def test_known_limits_are_on_the_page(parsed):
    rows = {cells[0]: cells for cells in rows_of(parsed, "stability")}
    assert rows["usl"][1] == "0.0141" and rows["usl"][2].startswith("bar-edge (linear flip, ppc 2)")
    assert rows["usl"][2].endswith("plumbline stability bar-edge --integrator usl --no-runs")
    assert "not found on coupled: it gives no loss back" in rows["generalized-alpha rho_b 0.5"][4]


def test_a_limit_of_the_table_of_schemes_names_its_problem():
    document = _filled(stability_document())
    document["problems"][3] = {**document["problems"][0], "problem": "contact"}
    usl = document["problems"][3]["configurations"][6]
    usl["scheme"] = "default"
    words = cost._limit(document, {"kind": "solid", "scheme": "default"})
    limit = text.number(usl["predicted"][0]["high"], 3)
    assert words == f"0.0141 on bar-edge (smallest known); {limit} h/c on contact"


def test_growth_just_above_a_limit_is_given():
    document = stability_document()
    configuration = document["problems"][0]["configurations"][1]
    limit = bar_limit("usf", 0.3)
    above = next(entry for entry in configuration["growth"] if entry["dt"] > limit)
    row = stability._row(configuration, "")
    assert row["above"] == text.number(above["per_step"] - 1, 3) and row["above_at"] == text.number(above["dt"], 4)
    assert row["seen_at"] == text.number(1.05 * limit, 3)


def test_growth_at_small_steps_stands_apart(parsed):
    """What grows at every step has no limit; its rates are listed, also where the document calls it nothing."""
    rows = [cells for cells in rows_of(parsed, "stability-bar") if "0.0202" in cells or "5 × 10⁻⁵" in cells]
    assert [cells[:2] for cells in rows] == [["usl", "apic, N 0.3"], ["forward_euler", "flip, N 0.3"]]
    assert [cells[2:5] for cells in rows] == [["0.05", "5 × 10⁻⁵", "0.001"], ["0.05", "0.0202", "0.4"]]
    assert "2 configurations of 11" in parsed.text
    assert rows_of(parsed, "stability-oscillator") and "2 configurations of 3" not in parsed.text


def test_slow_growth_below_the_threshold_is_not_hidden_behind_a_limit():
    """Growth that goes as a power of the step and is below the threshold at first; rounding and a limit are none."""
    slow = stability_document()["problems"][0]["configurations"][0]
    slow["growth"] = [{"dt": dt, "per_step": math.exp(2e-7 * dt)} for dt in (0.1, 0.2, 0.4, 0.8, 1.2)]
    assert stability.grows_steadily(slow) and not stability.grows_at_small_steps(slow)
    rows = stability._growing_rows([slow], ["flip"])
    first = {"dt": "0.1", "added": "2\u202f×\u202f10⁻⁸", "rate": "2\u202f×\u202f10⁻⁷"}
    assert rows[0]["slow"] and rows[0]["steps"][0] == first
    slow["growth"] = [{"dt": dt, "per_step": 1 + 2e-8} for dt in (0.1, 0.2, 0.4, 0.8, 1.2)]
    assert not stability.grows_steadily(slow), "the same at every step, as rounding is"
    slow["growth"] = [{"dt": dt, "per_step": 1 + 2e-8} for dt in (1.0, 1.05, 1.1, 1.15)]
    assert not stability.grows_steadily(slow), "too narrow a range of steps to tell"
    for steady, why, added in (
        (True, "fourth power, as of Heun's method", lambda dt: dt**4 / 8),
        (False, "the root, as rounding of a double eigenvalue", lambda dt: 2e-7 * math.sqrt(dt)),
        (False, "a limit", lambda dt: 2e-9 * dt if dt < 0.3 else math.sqrt(dt - 0.25)),
        (False, "damping", lambda dt: -1e-4 * dt),
    ):
        slow["growth"] = [{"dt": dt, "per_step": 1 + added(dt)} for dt in (0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.6)]
        slow["predicted"] = [{"low": 0, "high": 0.26}]
        assert stability.grows_steadily(slow) == steady, why


def test_orders_with_intervals_and_theory(parsed):
    rows = {cells[0]: cells[3:] for cells in rows_of(parsed, "stability-orders")[1:]}
    assert rows == {
        "usf": ["position", "1.004 [0.994, 1.014]", "1"],
        "rk4": ["position", "3.997 [3.987, 4.007]", "4"],
        "implicit_midpoint": ["position", "2.001 [1.991, 2.011]", "—"],
    }


def test_many_configurations_are_summed_up_and_folded():
    document = stability_document()["problems"][0]
    rows = [
        synthetic_results._bar_configuration(name, (number + 0.5) / 15)
        for name in ("usf", "usl")
        for number in range(15)
    ]
    shown = stability._problem({**document, "configurations": rows}, "x")
    assert shown["fold"] and [row["count"] for row in shown["summary"]] == ["15", "15"]
    assert shown["summary"][0]["closed"] == "3\u202f×\u202f10⁻⁶\u202f% of 15"
    assert shown["summary"][0]["observed"] == "0.05\u202f% of 15"


def test_several_limits_each_meet_the_nearest_bracket():
    configuration = {
        **stability_document()["problems"][0]["configurations"][0],
        "predicted": [{"low": 0, "high": 0.7}, {"low": 0.9, "high": 1.2}],
        "observed": [{"low": 1.19, "high": 1.23}, {"low": 0.69, "high": 0.71}, {"low": 0.89, "high": 0.9}],
    }
    row = stability._row(configuration, "")
    assert row["predicted"] == "0 … 0.7; 0.9 … 1.2" and row["limits"] == [0.7, 0.9, 1.2]
    assert [entry["difference"] for entry in row["observed"]] == ["+0.83\u202f%", "0\u202f%", "−0.56\u202f%"]


# --- maps -----------------------------------------------------------------------------------------


def test_every_map_has_an_outline_where_it_must(source):
    """One where samples lie on both sides of the level; none where all lie on one side."""
    drawn = re.findall(r'<details class="map">.*?</details>', source, re.DOTALL)
    document = stability_document()["problems"][0]["maps"]
    assert len(drawn) == len(document)
    for entry in document:
        level = 1 + 1e-6 if entry["kind"] == "growth" else 1
        above = numpy.array(entry["values"]) > level
        mine = [part for part in drawn if f"<code>{entry['id']}</code>" in part]
        assert len(mine) == 1 and ('class="outline"' in mine[0]) == (above.any() and not above.all()), entry["id"]
        assert ('class="closed"' in mine[0]) == (entry["kind"] == "growth")
        marks = len(entry["observed"]) - (entry["kind"] == "growth")
        assert len(re.findall(r'class="ring"', mine[0])) == (1 if entry["kind"] == "growth" else marks)


def test_outline_separates_each_pair_of_samples():
    """Every edge between samples on either side of the level lies on the path, and no other."""
    values = numpy.array([[0.5, 0.5, 2.0], [0.5, 2.0, 2.0], [numpy.nan, 2.0, 0.5]])
    assert _segments(maps.outline(values, 1.0)) == {
        ("V", 2, 2), ("V", 1, 1), ("V", 2, 0), ("H", 1, 2), ("H", 2, 1),
    }  # fmt: skip
    assert maps.outline(numpy.ones((3, 3)), 1.0) == ""


def _segments(path):
    """Unit edges of a path of M x y, V y and H x: (direction, x, y) of their upper or left ends."""
    found = set()
    for x, y, direction, end in re.findall(r"M(\d+) (\d+)([VH])(\d+)", path):
        x, y, end = int(x), int(y), int(end)
        start, last = sorted((y, end)) if direction == "V" else sorted((x, end))
        found |= {(direction, x, at) if direction == "V" else (direction, at, y) for at in range(start, last)}
    return found


def test_colours_of_a_map_follow_its_values():
    """The picture, decoded, has one pixel a value, the first row above; unstable samples rise along the ramp."""
    entry = next(m for m in bar_maps() if m["kind"] == "growth")
    scale = maps.scale_of([entry], True)
    drawn = maps.draw(entry, scale, "h/c")
    shown = pixels_of(drawn.picture)
    colours = [(0, 0, 0, 0), *((*colour, 255) for colour in scale.palette)]
    pixels = numpy.array([[colours.index(tuple(pixel)) for pixel in row] for row in shown.tolist()])
    values = numpy.array(entry["values"])[::-1]
    assert pixels.shape == values.shape
    assert ((pixels == 0) == (values - 1 <= 1e-6)).all()
    grown = values > 1 + 1e-6
    assert (numpy.diff(pixels[grown][numpy.argsort(values[grown])].astype(int)) >= 0).all()
    assert 1 <= pixels[grown].min() and pixels.max() <= maps.STEPS


def test_maps_of_a_kind_share_one_scale():
    document = stability_document()
    document["problems"][0]["maps"][0]["values"][0][0] = 7.0
    parts = stability.map_parts(_filled(document)["problems"][0])
    assert [part["growth"] for part in parts] == [False, True]
    values = [value for entry in bar_maps() if entry["kind"] == "limit" for row in entry["values"] for value in row]
    assert parts[0]["scale"].high == 7.0 and parts[0]["scale"].low == min(values)


def _filled(document):
    document = copy.deepcopy(document)
    for problem in document["problems"]:
        for part in ("configurations", "maps", "safe", "equations"):
            problem[part] = problem.get(part) or []
        for configuration in problem["configurations"]:
            for part in ("settings", "scanned", "differences", "orders", "smallest_known"):
                configuration[part] = configuration.get(part) or {}
            for part in ("predicted", "observed", "growth", "observed_growth"):
                configuration[part] = configuration.get(part) or []
    return document


def test_marks_and_curves_lie_where_the_document_puts_them():
    entry = next(m for m in bar_maps() if m["kind"] == "growth")
    drawn = maps.draw(entry, maps.scale_of([entry], True), "h/c")
    points = re.findall(r"[ML]([\d.-]+) ([\d.-]+)", drawn.closed)
    assert len(points) == len(entry["closed_form_curve"])
    step = entry["y"]["values"][0]
    for (x, y), (number, point) in zip(points[-10:], list(enumerate(entry["closed_form_curve"]))[-10:]):
        assert float(x) == pytest.approx(number + 0.5, abs=1e-3)
        assert float(y) == pytest.approx(30 - (point["y"] / step - 0.5), abs=1e-3)
    axis = maps.Axis("ppc", [1, 2, 4, 9])
    assert [axis.place(value) for value in (1, 4, 6.5, 9)] == [0.5, 2.5, 3.0, 3.5]
    assert [label for _, label in axis.ticks()] == ["1", "2", "4", "9"]
    assert maps.Axis("", ["centre", "side"]).place("side") == 1.5


def test_a_descending_axis_is_turned():
    entry = next(m for m in bar_maps() if m["kind"] == "limit")
    turned = copy.deepcopy(entry)
    for part in ("values", "closed_form"):
        turned[part] = [row[::-1] for row in turned[part][::-1]]
    for axis in ("x", "y"):
        turned[axis]["values"] = turned[axis]["values"][::-1]
    scale = maps.scale_of([entry], False)
    straight, back = (maps.draw(found | {"closed_form_curve": []}, scale, "h/c") for found in (entry, turned))
    assert straight == back


def test_maps_with_gaps_are_drawn():
    """Values unknown, one row, one sample, nothing known, names along an axis."""
    entry = next(m for m in bar_maps() if m["kind"] == "limit") | {"closed_form_curve": []}
    gaps = copy.deepcopy(entry)
    gaps["values"][0] = [None] * 40
    drawn = maps.draw(gaps, maps.scale_of([gaps], False), "h/c")
    assert "40 undetermined" in drawn.words and drawn.unknown == "M0 4V3H40V4Z"
    problem = {"maps": [gaps], "configurations": []}
    assert stability.map_parts(problem)[0]["missing"]
    assert not stability.map_parts({**problem, "maps": [entry]})[0]["missing"]
    one = {**entry, "values": [[None]], "closed_form": None, "observed": [{"x": None, "low": 1}]}
    one |= {"x": {"values": ["centre"]}, "y": {"values": [1]}}
    for kind in (False, True):
        assert maps.draw(one, maps.scale_of([one], kind), "").words == "nothing determined"


def test_a_hundred_maps_stay_light(tmp_path):
    integrators, transfers = ("usf", "musl", "usl", "usavg", "rk4"), ("flip", "pic", "apic", "xpic", "mls")
    found = bar_maps(integrators, ("linear", "quadratic"), transfers)
    for entry in found:
        if entry["kind"] == "limit":  # as large as those of growth
            entry["y"]["values"] = list(range(1, 31))
            entry["values"] = [[1.5 + math.sin(37 * x + y) / 3 for x in range(40)] for y in range(30)]
            entry["closed_form"] = None
    assert len(found) == 100
    page = page_of(tmp_path, stability_document(found))
    assert len(page.encode()) < 2e6
    words = Page(page).text
    assert words.count("linear, 5 maps") == 2 and words.count("Not drawn: 5 maps of") == 4, "more would be none to look at"


# --- gaps and damage ------------------------------------------------------------------------------


def test_a_problem_without_anything_says_so(parsed):
    assert "Nothing was computed for this problem." in parsed.text and "stability-contact" in parsed.ids


def test_null_everywhere_it_may_stand(tmp_path):
    """Each value of the document in turn gone: the page is made, or the file is called damaged; nothing else."""
    document = stability_document()
    bar = document["problems"][0]
    bar["configurations"], bar["maps"], bar["safe"] = bar["configurations"][1:2], bar["maps"][:2], bar["safe"][:1]
    for entry in bar["maps"]:
        entry["observed"] = entry["observed"][:2]
    document["problems"] = [bar]
    optional = 0
    for broken in each_without(document, 8):
        write_stability(tmp_path, broken)
        folder = reader.load_folder(tmp_path)
        if not folder.damaged:
            optional += 1
            stability_page(folder)
    assert optional > 100


def stability_page(folder):
    """The numbers of the page without its drawings of matplotlib, which take most of the time."""
    stability.page(folder.stability, {})
    for problem in folder.stability["problems"]:
        stability.map_parts(problem)
    stability.csv_tables(folder.stability)


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d.update(problems=None),
        lambda d: d.update(problems={}),
        lambda d: d.update(problems=[3]),
        lambda d: d["problems"].append({"title": "no name"}),
        lambda d: d["problems"][0].update(configurations="none"),
        lambda d: d["problems"][0].update(safe=[1]),
        lambda d: d["problems"][0].update(equations=[1]),
        lambda d: d.update(known_limits={}),
        lambda d: d["known_limits"][0].update(rows=None, integrator=None),
        lambda d: d["known_limits"][0]["rows"][0].update(limit="small"),
        lambda d: d["known_limits"][0]["rows"][0].update(problem=None),
        lambda d: d["problems"][0]["safe"][0].update(limit="large"),
        lambda d: d["problems"][0]["safe"][0].update(limit=True),
        lambda d: d["problems"][0]["configurations"][0].update(predicted=[1.8]),
        lambda d: d["problems"][0]["configurations"][0].update(predicted=[{"low": 0, "high": "1.8"}]),
        lambda d: d["problems"][0]["configurations"][0].update(closed_form=[1.8]),
        lambda d: d["problems"][0]["configurations"][0].update(settings=[]),
        lambda d: d["problems"][0]["configurations"][0].update(orders={"position": 2}),
        lambda d: d["problems"][0]["maps"][0].update(values=[]),
        lambda d: d["problems"][0]["maps"][0]["values"][1].pop(),
        lambda d: d["problems"][0]["maps"][0]["values"][1].__setitem__(0, "1"),
        lambda d: d["problems"][0]["maps"][0].update(closed_form=[[1.0]]),
        lambda d: d["problems"][0]["maps"][0].update(x=None),
        lambda d: d["problems"][0]["maps"][0]["y"].update(values=[None, 1, 2, 3]),
    ],
)
def test_a_document_of_another_form_is_damaged(tmp_path, change):
    document = stability_document()
    change(document)
    with pytest.raises(reader.DamagedFile):
        loaded(tmp_path, document)


def test_text_of_the_document_is_never_markup(tmp_path):
    evil = "<script>alert(1)</script>"
    words = json.dumps(stability_document())
    for name in ("usf", "h/c", "York", "flip", "points per cell", "offsets"):
        words = words.replace(name, evil)
    document = json.loads(words)
    for problem in document["problems"]:
        problem["problem"] += evil
    page = page_of(tmp_path, document)
    assert "<script" not in without_scripts(page) and "alert(1)" in page
    Page(page)


# --- gates, links, CSV ----------------------------------------------------------------------------


def test_gates_of_the_laboratory_are_linked(tmp_path):
    gates = [
        gate("stability-bar", "usf", "limit", "predicted limit", 1.8, 1.9, "PASS", 1.833),
        gate("stability-bar", "usl", "limit", "predicted limit", 0.7, 0.8, "FAIL", 0.9),
        gate("sod", "default", "order", "density.L1 order", 0.9, None, "PASS", 0.985),
    ]
    write_verdicts(tmp_path, gates)
    page = page_of(tmp_path)
    strip = re.search(r'<ul class="verdict-strip".*?</ul>', page, re.DOTALL).group(0)
    assert 'href="#case-stability-bar"' in strip and "FAIL 1" in strip and "PASS 1" in strip and "sod" not in strip
    section = page[page.index('<section id="stability-bar"') : page.index('<section id="stability-oscillator"')]
    assert 'href="#case-stability-bar"' in section
    (tmp_path / "stability.json").unlink()
    alone = source_of(tmp_path)
    assert "No maps of stability" in alone and 'class="verdict-strip"' in alone


def test_every_link_and_choice_has_its_aim(source, parsed):
    assert "#stability" in parsed.links and "#stability-bar-maps" in parsed.links
    assert all(link[1:] in parsed.ids for link in parsed.links)
    assert len(parsed.ids) == len(set(parsed.ids))
    rules = re.findall(r"\.safe:has\(\.only-(\w+):checked\) tbody tr:not\(\.(\w+)\)", source)
    assert rules and all(first == second for first, second in rules)
    for name, _ in rules:
        assert f'class="only-{name}"' in source and re.search(rf'<tr class="[^"]*\b{name}\b', source)


def test_two_problems_of_one_name_have_own_anchors(tmp_path):
    document = {"problems": [{"problem": "bar"}, {"problem": "bar"}]}
    ids = Page(page_of(tmp_path, document)).ids
    assert ids.count("stability-bar") == 1 and ids.count("stability-bar-2") == 1


def test_csv_gives_every_number_back(tmp_path):
    document = stability_document()
    write_stability(tmp_path, document)
    parts = ("", "-growth", "-safe", "-known", "-maps", "-orders")
    tables = tables_of(tmp_path, tmp_path, [f"stability{part}" for part in parts])
    bar = document["problems"][0]
    configurations = [c for problem in document["problems"] for c in problem.get("configurations") or []]
    assert len(tables["stability"]) == len(configurations)
    first = tables["stability"][0]
    assert json.loads(first["settings"]) == bar["configurations"][0]["settings"]
    assert float(first["predicted"].split()[1]) == bar["configurations"][0]["predicted"][0]["high"]
    growth = [float(row["per_step"]) for row in tables["stability-growth"][:30]]
    assert growth == [entry["per_step"] for entry in bar["configurations"][0]["growth"]]
    assert [float(row["limit"] or "nan") for row in tables["stability-safe"][:4]] == [1.0, 1.414, 2.24, 0.7071]
    assert first["smallest_known_problem"] == "bar" and tables["stability"][6]["smallest_known"] == "0.0141"
    known = [(row["integrator"], row["problem"], row["limit"], row["smallest"]) for row in tables["stability-known"]]
    assert known[0] == ("usl", "bar-edge", "0.0141", "true") and known[-1][:2] == ("generalized-alpha", "oscillator")
    values = [row for row in tables["stability-maps"] if row["part"] == "values"]
    assert len(values) == sum(len(m["values"]) * len(m["values"][0]) for m in bar["maps"])
    assert float(values[41]["low"]) == bar["maps"][0]["values"][1][1]
    assert [row["theory"] for row in tables["stability-orders"]] == ["1", "4", ""]
