"""The history of results: one line a key, damaged lines survived, and what counts as better or worse."""

import json

import history
import numpy
import order_change
import pytest
import render
from plumbline import reader


def line(commit="a", **parts):
    """An entry with one order, constant, limit, cost and verdict."""
    return {
        "commit": commit,
        "machine": "one",
        "tier": "quick",
        "started": f"2026-01-0{1 + ord(commit[0]) - ord('a')}T00:00:00Z",
        "orders": {"sod · L1": [1.0, 0.9, 1.1]},
        "constants": {"sod · L1": 2.0},
        "limits": {"usl · bar": 0.5},
        "cost": {"sod · default": 1.0},
        "verdicts": {"PASS": 5, "FAIL": 1},
        **parts,
    }


def changed(before, after):
    found = history.compare(before, after)
    return {change: [row["kind"] for row in found[change]] for change in ("worse", "inconclusive", "better", "new", "missing") if found[change]}


def test_a_key_has_one_line(tmp_path):
    path = tmp_path / "deep" / "history.jsonl"
    for entry in (line("a"), line("b"), line("a", machine="two"), line("a", tier="full"), line("a", limits={"usl · bar": 0.4})):
        history.append(path, entry)
    entries, notes = history.read(path)
    assert [(e["commit"], e["machine"], e["tier"]) for e in entries] == [
        ("b", "one", "quick"), ("a", "two", "quick"), ("a", "one", "full"), ("a", "one", "quick")]
    assert entries[-1]["limits"] == {"usl · bar": 0.4} and notes == []


@pytest.mark.parametrize("end", [json.dumps(line("b"))[:40], "\xff\x00", "[]", "{}", json.dumps(line("b", orders={"x": [1]}))])
def test_a_damaged_line_is_named_and_kept(end, tmp_path):
    path = tmp_path / "history.jsonl"
    path.write_bytes(json.dumps(line("a")).encode() + b"\n\n" + end.encode("latin-1"))
    said = ["line 3 of history.jsonl is damaged: it is kept and not used"]
    entries, notes = history.read(path)
    assert entries == [line("a")] and notes == said
    assert history.append(path, line("c")) == said
    assert history.append(path, line("a")) != [] and history.append(path, line("a")) != []  # replaces the first
    assert history.read(path)[0] == [line("c"), line("a")] and end.encode("latin-1") in path.read_bytes().splitlines()


@pytest.mark.parametrize("parts, expected", [
    ({}, {}),
    ({"orders": {"sod · L1": [0.96, 0.959, 0.961]}}, {}),
    ({"orders": {"sod · L1": [0.8, 0.7, 0.9]}}, {"worse": ["orders"]}),
    ({"orders": {"sod · L1": [0.9, 0.8, 1.0]}}, {"inconclusive": ["orders"]}),  # the interval of the difference holds 0
    ({"orders": {"sod · L1": [0.8, 0.5, 1.1]}}, {"inconclusive": ["orders"]}),
    ({"orders": {"sod · L1": [0.8, None, None]}}, {"inconclusive": ["orders"]}),
    ({"orders": {"sod · L1": [1.3, 1.2, 1.4]}}, {"better": ["orders"]}),
    ({"orders": {}}, {"missing": ["orders"]}),
    ({"orders": {"sod · L1": [1.0, 0.9, 1.1], "lax · L1": [1.0, 0.9, 1.1]}}, {"new": ["orders"]}),
    ({"constants": {"sod · L1": 2.01}}, {}),
    ({"constants": {"sod · L1": 2.1}}, {"worse": ["constants"]}),
    ({"constants": {"sod · L1": 1.9}}, {"better": ["constants"]}),
    ({"limits": {"usl · bar": 0.50001}}, {}),
    ({"limits": {"usl · bar": 0.4}}, {"worse": ["limits"]}),
    ({"limits": {"usl · bar": 0.6}}, {"better": ["limits"]}),
    ({"cost": {"sod · default": 9.0}}, {}),  # times are not judged
    ({"verdicts": {"PASS": 5, "FAIL": 2}}, {"worse": ["verdicts"]}),
    ({"verdicts": {"PASS": 7}}, {"better": ["verdicts"]}),
])
def test_what_counts_as_a_change(parts, expected):
    assert changed(line("a"), line("b", **parts)) == expected


H = [1 / cells for cells in (50, 100, 200, 400)]


def levels(order, scatter=0.0):
    return [[h, 2 * h**order * (1 + scatter * (-1) ** number)] for number, h in enumerate(H)]


@pytest.mark.parametrize("after, expected", [
    (levels(1.0), {}),
    (levels(0.97), {}),
    (levels(0.9), {"worse": ["orders"]}),  # however wide the intervals of the orders themselves
    (levels(1.1), {"better": ["orders"]}),
    (levels(0.8, 0.1), {"inconclusive": ["orders"]}),
    (levels(0.9)[:2], {"inconclusive": ["orders"]}),  # two levels alone say nothing of the slope: by both intervals
    ([[h / 3, error] for h, error in levels(0.9)], {"inconclusive": ["orders"]}),  # no level in common
])  # fmt: skip
def test_orders_are_compared_level_by_level_where_both_have_them(after, expected):
    wide = {"sod · L1": [1.0, 0.5, 1.5]}
    order = {"sod · L1": [0.9, 0.4, 1.4]}
    assert changed(line("a", orders=wide, errors={"sod · L1": levels(1.0)}), line("b", orders=order, errors={"sod · L1": after})) == expected


def test_the_slope_is_that_of_plumbline_diff():
    """By hand: ln of the ratios 1, 1.1, 1.3 over ln h in steps of ln 2; Student's t with one degree of freedom, 12.706."""
    before = [[h, 1.0] for h in H[:3]]
    slope, half = order_change.paired(before, [[h, error] for h, error in zip(H, (1.0, 1.1, 1.3))])
    y, x = numpy.log([1.0, 1.1, 1.3]), numpy.log(H[:3])
    residual = y - numpy.polyval(numpy.polyfit(x, y, 1), x)
    assert slope == pytest.approx(numpy.polyfit(x, y, 1)[0])
    assert half == pytest.approx(12.7062 * numpy.sqrt((residual**2).sum() / ((x - x.mean()) ** 2).sum()), rel=1e-5)
    assert order_change.paired(before, before) == (0, 0)


def test_quantities_stand_under_their_case(tmp_path):
    entries = [line(commit, orders={"sod · L1": [1, 0.9, 1.1], "noh · L1": [1, 0.9, 1.1]}, cost={"sod · default": 2.0}) for commit in "ab"]
    groups = history.lines(entries)
    assert [(group["title"], [row["kind"] for row in group["rows"]]) for group in groups] == [
        ("noh", ["orders"]), ("sod", ["orders", "constants", "cost"]), ("usl", ["limits"])]  # fmt: skip
    assert [row["name"] for row in groups[1]["rows"]] == ["L1", "L1", "default"]


def test_sparklines_leave_gaps_out():
    assert history.sparkline([1.0, None, 2.0], width=100, height=20) == "0.0,19.0 100.0,1.0"
    assert history.sparkline([3.0, 3.0], width=100, height=20) == "0.0,10.0 100.0,10.0"


def test_earlier_entries_are_of_the_same_machine_newest_first(tmp_path):
    path = tmp_path / "history.jsonl"
    for entry in (line("a"), line("b"), line("c", machine="two"), line("d")):
        history.append(path, entry)
    section = history.section(path)
    assert [other["entry"]["commit"] for other in section["comparisons"]] == ["b", "a"]
    assert history.section(tmp_path / "none") is None


def test_a_folder_becomes_a_line(results, tmp_path):
    path = tmp_path / "history.jsonl"
    assert history.main([str(results[0]), str(path), "--tier", "full"]) == 0
    (found,), _ = history.read(path)
    folder = reader.load_folder(results[0])
    fits = [fit for study in folder.studies for fit in study.measures.values() if fit.get("asymptotic")]
    assert found["tier"] == "full" and sorted(value[0] for value in found["orders"].values()) == sorted(fit["order"] for fit in fits)
    assert sum(found["verdicts"].values()) > 0
    assert history.main([str(tmp_path), str(path)]) == 4 and history.main([str(tmp_path / "no"), str(path)]) == 4


def test_the_page_shows_the_comparison(results, tmp_path):
    path = tmp_path / "history.jsonl"
    for entry in (line("a"), line("b", limits={"usl · bar": 0.25})):
        history.append(path, entry)
    with path.open("a", encoding="utf-8") as stream:
        stream.write('{"commit": "c", "mach')
    page = render.single_file(render.report(reader.load_folder(results[0]), None, path))
    assert 'id="changed"' in page and "line 3 of history.jsonl is damaged" in page and "<polyline" in page
    assert "1 worse" in page and page.count("data-comparison=") == 1
