"""York's figures and tables on the page: all of them, with the gates of the results that answer for each."""

import cases as gathering
import pytest
import render
import york
from synthetic_results import gate


@pytest.fixture(scope="module")
def part():
    """Of results that hold one of his gates on Sod's problem, and one that answers for no figure."""
    judged = [
        gate("sod", "york1997", "york1997/density-100", "density.L1 at 100", 0.009, 0.011, "PASS", 0.0098, anchor="gate-d"),
        gate("sod", "default", "default/order", "density.L1 order", 0.9, None, "PASS", 0.98, anchor="gate-o"),
    ]
    return render.york_part({"sod": gathering.Case("sod", gates=judged)}, {})


def row_of(part, name):
    return next(row for row in part["rows"] if row["name"] == name)


def test_every_figure_and_table_has_a_row_in_the_order_of_the_report(part):
    names = [f"{series.capitalize()} {number}" for series, count in york.COUNTS.items() for number in range(1, count + 1)]
    assert [row["name"] for row in part["rows"]] == names


def test_gates_of_the_results_stand_with_their_figure(part):
    row = row_of(part, "Figure 14")
    assert [(one["id"], one["verdict"], one["gate_anchor"]) for one in row["gates"]] == [
        ("york1997/density-100", "PASS", "gate-d")
    ]
    assert [(case["name"], case["here"], case["anchor"]) for case in row["cases"]] == [("sod", True, "case-sod")]
    assert sum(len(one["gates"]) for one in part["rows"]) == 1


def test_a_figure_without_results_names_its_gates(part):
    row = row_of(part, "Figure 95")
    assert row["gates"] == [] and row["patterns"] == ["two-bar york1997/restitution"]
    assert row["cases"][0]["here"] is False


def test_counts_are_those_of_results(part):
    results = [row for row in york.load() if row["kind"] == york.RESULT]
    assert part["results"] == len(results) and part["answered"] == sum("gates" in row for row in results)


def test_page_has_the_section_where_a_case_of_his_is_there(page):
    assert 'id="york"' in page.read_text(encoding="utf-8")
    assert york.page({"noh": gathering.Case("noh")}, {}) is None
