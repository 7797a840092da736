"""reports/york.json against the gates that the cases declare: no figure or table of the report is missing, no gate named in vain."""
import copy
import importlib
import sys

import pytest
from contract import ROOT

sys.path.insert(0, str(ROOT / "reports"))
york, york_figures = (importlib.import_module(name) for name in ("york", "york_figures"))


@pytest.fixture(scope="module")
def entries(tmp_path_factory):
    """{name: what `explain` says} of the cases of the list."""
    from contract import Plumbline
    plumbline = Plumbline(tmp_path_factory.mktemp("york"))
    names = {case for row in york.load() for case in row.get("cases", ())}
    return {name: plumbline("explain", name, json=True).json() for name in names}


@pytest.fixture(scope="module")
def gates(entries):
    """{(case, gate): reason} of the cases of the list."""
    return {(name, gate["id"]): gate["reason"] for name, entry in entries.items() for gate in entry["gates"]}


@pytest.fixture(scope="module")
def studies(entries):
    """{case: identifiers of its studies}."""
    return {name: [study["id"] for study in entry["studies"]] for name, entry in entries.items()}


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
    assert "figure 36: a result that no gate answers for, without a reason" in york.faults(changed(36, why=""), gates)


def test_a_gate_that_cites_a_figure_must_be_named_there(gates):
    found = york.faults(york.load(), gates | {("two-bar", "york1997/surprise"): "York reads it off Fig. 95"})
    assert found == ["two-bar york1997/surprise cites figure 95, which does not name it"]


def pictures(number, values):
    """The pictures with other values for one figure."""
    found = copy.deepcopy(york.load("pictures"))
    next(entry for entry in found if entry["figure"] == number).update(values)
    return found


def test_each_figure_with_a_result_has_its_picture_of_studies_that_there_are(studies):
    assert york_figures.faults(york.load("pictures"), york.load(), studies) == []


@pytest.mark.parametrize("figure, values, fault", [
    (13, {"case": "sodd"}, "picture of figure 13: there is no case sodd"),
    (26, {"runs": [{"label": "york1997", "study": "york97", "at": 10}]}, "picture of figure 26: spring-mass has no study york97; there are: "),
    (96, {"runs": [{"label": "default", "study": "default", "at": cells} for cells in (20, 40)]}, "picture of figure 96: two runs are called default"),
    (60, {"panels": [{"quantity": "displacement", "label": "less", "less": "nobody"}]}, "picture of figure 60: no run is called nobody"),
    (26, {"panels": None, "times": [0]}, "picture of figure 26: one of panels, times, methods says what is drawn; there are 2"),
    (26, {"figure": 107}, "figure 26 has neither a picture nor a reason"),
    (26, {"figure": 107}, "picture of figure 107: the report has no such figure"),
    (14, {"figure": 13}, "picture of figure 13 is there twice"),
])
def test_a_picture_of_what_there_is_not_is_an_error_that_names_it(studies, figure, values, fault):
    found = york_figures.faults(pictures(figure, values), york.load(), studies)
    assert [words for words in found if words.startswith(fault)], found


@pytest.mark.parametrize("case, cells, end", [
    ("sod", 20, 0.01), ("spring-mass", 10, 0.001), ("pendulum", 10, 0.01), ("two-bar", 20, 0.01), ("membrane-expansion", 8, 0.01),
])
def test_quantities_and_bodies_of_the_pictures_are_those_of_runs(tmp_path, case, cells, end):
    from contract import Plumbline
    plumbline = Plumbline(tmp_path)
    plumbline("run", case, "--scheme", "york1997", "--cells", cells, "--set", f"t_end={end}", "--frames", 2)
    result = importlib.import_module("plumbline.reader").load(next((tmp_path / "results").glob("*.h5")))
    for entry in york.load("pictures"):
        if entry.get("case") == case:
            york_figures.check_result(entry, result)


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
