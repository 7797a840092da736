"""The section on trust: requirements against gates, the ledger of tolerances, bounds of references."""

import json

import numpy
from plumbline import reader
import pytest
import render
import trust
from cases import Case, Series
from html_page import source_of

REQUIREMENTS = [
    {"id": "mass", "requirement": "The solver shall keep mass.", "source": "York", "gates": [["*", "*/mass"]],
     "equations": ["York 3.*"], "tests": []},
    {"id": "order", "requirement": "The solver shall converge.", "source": "Toro", "gates": [["sod*", "*/order"]],
     "equations": [], "tests": []},
]  # fmt: skip
GATES = {("sod", "default/mass"), ("lax", "default/mass"), ("sod", "default/order")}
TAGS = ["York 3.19", "Toro 4.5"]


def changed(number, **more):
    return [{**entry, **more} if at == number else entry for at, entry in enumerate(REQUIREMENTS)]


def test_whole_list_has_no_fault():
    assert trust.faults(REQUIREMENTS, GATES, TAGS) == []


@pytest.mark.parametrize("requirements, gates, words", [
    (changed(1, gates=[]), GATES - {("sod", "default/order")}, "order: no gate and no test"),
    (changed(1, gates=[["sod*", "*/order"], ["noh*", "*/order"]]), GATES, "the pattern noh*: */order matches no gate"),
    (changed(0, equations=["York 9.*"]), GATES, "no equation [York 9.*]"),
    (changed(0, id="order"), GATES, "2 requirements of this name"),
    (changed(0, tests=["tests/nowhere.cpp"]), GATES, "no file tests/nowhere.cpp"),
    (REQUIREMENTS, GATES | {("noh", "default/drift")}, "noh: default/drift belongs to no requirement"),
])  # fmt: skip
def test_fault_is_named(requirements, gates, words):
    assert any(words in fault for fault in trust.faults(requirements, gates, TAGS, has_file=lambda name: False))


def test_gate_that_stands_on_every_study_must_be_asked_for_by_name():
    assert not trust.matches("noh", "default/mass", ["noh", "*/*"]) and trust.matches("noh", "default/mass", ["*", "*/mass"])
    assert trust.matches("noh", "default/drift", ["noh", "*/*"]) and not trust.matches("sod", "default/drift", ["noh", "*/*"])
    assert trust.matches("noh", "default/mass/regression", ["*", "*/mass"]) and not trust.matches("noh", "default/mass/regression", ["noh", "*/*"])


def gate(name, margin, origin="requirement", verdict="PASS", high=1.0, low=None):
    return {"id": name, "case": "sod", "scheme": "default", "quantity": "x", "expected": {"low": low, "high": high},
            "origin": origin, "reason": "for a test", "measured": 0.5, "interval": None, "margin": margin, "verdict": verdict}  # fmt: skip


def one_case(*gates, **more):
    return {"sod": Case("sod", gates=list(gates), **more)}


def test_holes_are_shown():
    cases = one_case(gate("default/mass", 0.5, verdict="XFAIL"), catalog={"gates": [{"id": "default/order"}]})
    rows = trust.coverage(REQUIREMENTS + [{**REQUIREMENTS[0], "id": "same", "gates": [], "tests": ["a"]}], cases, [])
    assert [row["hole"] for row in rows] == ["nothing passes", "declared, not run in this tier", "no gate: by tests alone"]
    assert rows[1]["verdicts"] == [("not run", 1)]


def test_flags_of_margins():
    gates = [gate("a", 0.95), gate("b", 0.04), gate("c", 0.5), gate("d", 0.99, origin="identity"), gate("e", 3, high=None, low=1),
             gate("f", 0.04, verdict="XFAIL"), gate("g", None), gate("h", 0.95, origin="regression")]  # fmt: skip
    rows = trust.tolerances(one_case(*gates))
    assert {row["id"]: row["flag"] for row in rows if row["flag"]} == {"a": "wide", "b": "near the bound"}
    assert [row["id"] for row in rows][:2] == ["b", "a"]
    table = trust.origins(rows)
    required = next(row for row in table["rows"] if row["origin"].startswith("requirement"))
    assert (required["total"], required["near"], required["wide"]) == (6, 1, 1)


def test_widened_tolerances_come_first(tmp_path):
    path = tmp_path / "tolerances.json"
    change = {"from": {"low": None, "high": 0.5}, "date": "2026-11-22", "why": "coarser mesh"}
    path.write_text(json.dumps({"gates": [{"case": "*", "id": "c", "widened": change}, {"case": "sod", "id": "a"}]}))
    rows = trust.tolerances(one_case(gate("a", 0.04), gate("c", 0.5)), trust.load_widened(path))
    assert [row["id"] for row in rows] == ["c", "a"] and rows[1]["widened"] == ""
    assert rows[0]["widened"] == "widened 2026-11-22, was ≤ 0.5: coarser mesh"
    assert trust.load_widened(tmp_path / "none.json") == []


def level(error, bound):
    return {"measures": {"density.L1": {"error": error, "reference_bound": bound}}}


def test_worst_share_of_a_reference_is_that_of_the_hardest_run():
    series = Series("default", "cells", {}, [level(0.1, 1e-6), level(0.001, 1e-5)], {}, ["a.h5"])
    cases = one_case({**gate("a", 0.5), "quantity": "density.L1 at 100"}, series=[series])
    rows, exact = trust.references(cases)
    assert [(row["measure"], row["share"]) for row in rows] == [("density.L1", pytest.approx(0.01))] and exact == 0
    series.levels = [level(0.1, 0.0)]
    assert trust.references(cases) == ([], 1)


def test_histogram_leaves_identities_out():
    rows = trust.tolerances(one_case(gate("a", 0.5), gate("b", 0.7, origin="identity")))
    assert "1 gate " in trust.margins(rows, ["v.h5"]).caption and trust.margins(rows[1:], []) is None


def test_features_are_those_of_the_runs():
    def run(**settings):
        return reader.Result("run", "a.h5", 1, run={"case": "sod", "ledger": {"momentum_x": {}, "momentum_y": {}}}, settings=settings)

    found = trust.features({"sod": 1, "lax": 1}, [run(shape="cubic", density="grid"), run(shape="linear", density="grid", geometry="axisymmetric")])
    rows = {(row["feature"], row["value"]): row["counts"] for row in found["rows"]}
    assert rows["shape", "cubic"] == [1, 0] and rows["density", "grid"] == [2, 0] and rows["dimension", "axisymmetric"] == [1, 0]
    assert rows["kind", "gas"] == [2, 0] and rows["dimension", "plane"] == [1, 0]


def test_coverage_of_lines_is_shown(tmp_path):
    (tmp_path / "coverage.json").write_text(json.dumps({"total": 0.932, "folders": {"kernel": 0.951}}))
    page = source_of(tmp_path)
    assert "93.2" in page and "95.1" in page and 'id="trust"' in page


def test_tables_are_had_as_csv(tmp_path):
    folder = reader.Folder(equations={"equations": [{"tag": "York 3.19", "computed": ["a:1"], "checked": []}]})
    render.write_tables(folder, one_case(gate("default/mass", 0.95)), tmp_path)
    assert "default/mass" in (tmp_path / "tolerances.csv").read_text() and "York 3.19" in (tmp_path / "requirements.csv").read_text()
    assert numpy.loadtxt(tmp_path / "references.csv", delimiter=",", dtype=str).tolist() == list(trust.REFERENCE_COLUMNS)
