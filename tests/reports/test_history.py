"""The history of results: one line a key, damaged lines survived, and what counts as better or worse."""

import json

import history
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
    return {change: [row["kind"] for row in found[change]] for change in ("worse", "better", "new", "missing") if found[change]}


def test_a_key_has_one_line(tmp_path):
    path = tmp_path / "deep" / "history.jsonl"
    for entry in (line("a"), line("b"), line("a", machine="two"), line("a", tier="full"), line("a", limits={"usl · bar": 0.4})):
        history.append(path, entry)
    entries, notes = history.read(path)
    assert [(e["commit"], e["machine"], e["tier"]) for e in entries] == [
        ("b", "one", "quick"), ("a", "two", "quick"), ("a", "one", "full"), ("a", "one", "quick")]
    assert entries[-1]["limits"] == {"usl · bar": 0.4} and notes == []


@pytest.mark.parametrize("end", [json.dumps(line("b"))[:40], "\xff\x00", "[]", "{}", json.dumps(line("b", orders={"x": [1]}))])
def test_a_damaged_line_is_left_out_and_named(end, tmp_path):
    path = tmp_path / "history.jsonl"
    path.write_bytes(json.dumps(line("a")).encode() + b"\n" + end.encode("latin-1"))
    entries, notes = history.read(path)
    assert entries == [line("a")] and notes == ["line 2 of history.jsonl is damaged and left out"]
    assert history.append(path, line("c")) == notes
    assert history.read(path) == ([line("a"), line("c")], [])


@pytest.mark.parametrize("parts, expected", [
    ({}, {}),
    ({"orders": {"sod · L1": [0.95, 0.9, 1.0]}}, {}),  # within the interval
    ({"orders": {"sod · L1": [0.96, 0.959, 0.961]}}, {}),
    ({"orders": {"sod · L1": [0.8, 0.7, 0.89]}}, {"worse": ["orders"]}),
    ({"orders": {"sod · L1": [0.8, 0.5, 1.05]}}, {}),  # the earlier one is within the new interval
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
