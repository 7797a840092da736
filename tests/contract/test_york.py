"""reports/york.json against the gates that the cases declare: no figure or table of the report is missing, no gate named in vain."""
import copy
import importlib
import sys

import pytest
from contract import ROOT

sys.path.insert(0, str(ROOT / "reports"))
york = importlib.import_module("york")


@pytest.fixture(scope="module")
def gates(tmp_path_factory):
    """{(case, gate): reason} of the cases of the list."""
    from contract import Plumbline
    plumbline = Plumbline(tmp_path_factory.mktemp("york"))
    found = {}
    for name in {case for row in york.load() for case in row.get("cases", ())}:
        entry = plumbline("explain", name, json=True).json()
        found |= {(name, gate["id"]): gate["reason"] for gate in entry["gates"]}
    return found


def changed(figure, **values):
    """The list with other values for one figure."""
    rows = copy.deepcopy(york.load())
    next(row for row in rows if (row["series"], row["number"]) == ("figure", figure)).update(values)
    return rows


def test_each_figure_and_table_has_its_gates_or_a_reason(gates):
    assert york.faults(york.load(), gates) == []


def test_a_missing_number_is_found(gates):
    rows = [row for row in york.load() if (row["series"], row["number"]) != ("table", 3)]
    assert "table 3 is missing" in york.faults(rows, gates)


def test_a_number_twice_or_beyond_the_report_is_found(gates):
    found = york.faults(changed(105, number=107) + [york.load()[0]], gates)
    assert {"figure 105 is missing", "the report has no figure 107", "figure 1 is there twice"} <= set(found)


def test_a_gate_that_is_not_declared_is_found(gates):
    assert york.faults(changed(91, gates=[["stability-york", "surprise/*"]]), gates)[0] == (
        "figure 91: there is no gate stability-york surprise/*")


def test_a_result_without_gate_or_reason_is_found(gates):
    assert "figure 36: a result that no gate answers for, without a reason" in york.faults(changed(36, gates=[], why=""), gates)


def test_a_gate_that_cites_a_figure_must_be_named_there(gates):
    found = york.faults(york.load(), gates | {("two-bar", "york1997/surprise"): "York reads it off Fig. 95"})
    assert found == ["two-bar york1997/surprise cites figure 95, which does not name it"]


@pytest.mark.parametrize("words, numbers", [
    ("Fig. 37: the loss", [37]), ("Figs. 93-96", [93, 94, 95, 96]), ("tables 5 and 6", [5, 6]), ("Figs. 102 to 104", [102, 103, 104]),
    ("Figs. 79, 83)", [79, 83]), ("(Fig. 80 b)", [80]), ("figure of merit 3", []),
])
def test_figures_are_read_out_of_reasons(words, numbers):
    assert [number for _, number in york.cited_in(words)] == numbers


def test_rows_say_in_few_words_what_is_shown():
    for row in york.load():
        assert set(row) <= {"series", "number", "page", "kind", "shows", "cases", "gates", "why"}
        assert 10 < len(row["shows"]) < 120 and not row["shows"].endswith(".")
        assert (row["kind"] == "sketch") or row["cases"]
