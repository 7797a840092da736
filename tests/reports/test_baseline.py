"""The baseline on the page: its curves, and what the document of `plumbline diff` states."""

import json

import pytest

import baseline
import cases as gathering
from plumbline import reader
import render
import synthetic_results
from html_page import Page, without_scripts


def finding(change, kind, **more):
    return {"change": change, "kind": kind, "case": "sod", "scheme": "default", "study": "cells", "quantity": "density.L1", "before": None,
            "after": None, "size": None, "interval": None, "equal": False, "note": "", **more}


def document(findings):
    counts = {change: sum(found["change"] == change for found in findings) for change in (*baseline.CHANGES, "same")}
    side = {"folder": "base", "version": "0.6.0", "git": "abc", "started": "", "executed": 12, "damaged": []}
    return {"baseline": side, "results": {**side, "folder": "new"}, "change": "worse", "nothing_changed": not findings,
            "summary": "2 worse" if findings else "nothing changed", "counts": counts, "moved": 0, "largest_move": 0, "machine": [],
            "findings": findings}


FINDINGS = [
    finding("worse", "order", before=1.0, after=0.42, size=-0.58, interval=[-0.61, -0.55]),
    finding("worse", "cost", quantity="wall time in s", before=1.0, after=1.2, size=1.2, interval=[1.18, None]),
    finding("widened", "bound", before={"low": None, "high": 0.007}, after={"low": None, "high": 0.008}, note="lets pass <more>",
            recorded="2026-11-22, because"),
    finding("same", "error", before=1.0, after=1.0),
]


def sod_studies(path):
    """Two studies in cells and one in the step, without the runs behind them: little is drawn."""
    path.mkdir(exist_ok=True)
    synthetic_results.sod_study(path, "default", (0.0066, 0.0033, 0.0017, 0.00084, 0.00044), 1.6, {})
    synthetic_results.sod_dt_study(path)
    for run in path.glob("sod-*.h5"):
        run.unlink()
    return path


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return sod_studies(tmp_path_factory.mktemp("baseline") / "results")


@pytest.fixture(scope="module")
def source(path):
    """With the same folder as its own baseline, and a document."""
    folder = reader.load_folder(path)
    folder.diff = document(FINDINGS)
    return without_scripts(render.single_file(render.report(folder, reader.load_folder(path))))


@pytest.fixture(scope="module")
def alone(path):
    return without_scripts(render.single_file(render.report(reader.load_folder(path))))


def test_without_a_baseline_there_is_no_word_of_it(alone):
    assert 'id="baseline"' not in alone and "</svg>baseline</li>" not in alone


def test_curves_of_the_baseline_are_drawn_along(source, alone):
    assert source.count("</svg>baseline</li>") >= 2, "errors and orders"
    assert "Pale broken lines are the baseline (orders:" in source
    assert source.count("<path") > alone.count("<path")
    assert Page(source)  # well formed


def test_lines_belong_to_those_of_the_same_study(path):
    cases, earlier = (gathering.gather(reader.load_folder(path)) for _ in range(2))
    for case in earlier.values():
        for entry in case.series:
            entry.scheme += "-other" if entry.vary == "dt" else ""
    baseline.attach(cases, earlier)
    lines = [entry for case in cases.values() for entry in case.series]
    assert {entry.vary for entry in lines} == {"cells", "dt"}
    for entry in lines:
        assert (entry.baseline is None) == (entry.vary == "dt")
        assert entry.baseline is None or entry.baseline.files == entry.files


def test_document_is_shown_as_it_is(source):
    part = source[source.index('<section id="baseline"'):source.index('<section id="overview"')]
    for words in ("2 worse.", "−0.580", "−0.610 … −0.550", "× 1.200", "× 1.180 … —", "lets pass &lt;more&gt;",
                  "Recorded reason: 2026-11-22, because.", "href=#case-sod", "1 others are the same"):
        assert words in part, words
    assert 'href="#baseline"' in source
    assert part.index("Worse than the baseline: 2") < part.index("Gates that let pass more than they did: 1")
    assert "Only in the baseline" not in part, "kinds of change without a finding are left out"


def test_many_findings_are_cut_short():
    many = [finding("missing", "verdict", quantity=f"gate-{number}") for number in range(100)]
    (group,) = baseline.section(document(many), {})["groups"]
    assert len(group["rows"]) == baseline.MOST_ROWS and group["left"] == 60 and group["folded"]


def test_no_document_no_section():
    assert baseline.section({}, {}) is None


def test_command_line(tmp_path):
    results, output, diff = sod_studies(tmp_path / "results"), tmp_path / "page.html", tmp_path / "d.json"
    assert render.main([str(results), str(output), "--single-file", "--baseline", str(tmp_path / "none")]) == 4
    diff.write_text("[]")
    assert render.main([str(results), str(output), "--single-file", "--diff", str(diff)]) == 4 and not output.exists()
    (results / "diff.json").write_text(json.dumps(document([])))
    assert render.main([str(results), str(output), "--single-file"]) == 0
    assert "<strong>Nothing changed.</strong>" in output.read_text(encoding="utf-8")
