"""The section "Mutation testing": what it shows of a kill matrix, and what it does without one."""

import json
import pathlib

import pytest

import mutants
import synthetic_mutants
from html_page import shown, source_of


def rows(page):
    return [cells for section, cells in page.rows if section == "mutants"]


@pytest.fixture
def folder(tmp_path):
    synthetic_mutants.write(tmp_path)
    return tmp_path


def test_score_and_counts_are_those_of_the_matrix(folder):
    words = shown(folder).text
    for part in (
        "57.1 % of the 7 bugs that change anything (4)",
        "Gates of cases see 2 of the 7; unit tests alone see 2",
        "Of the 36 gates of the cases 8 went red at least once",
        "from commit 0123456",
        "wrong-sign is no longer killed by spring-mass, amplitude",
    ):
        assert part in words, part


def test_a_matrix_of_another_commit_says_so():
    assert mutants.page(synthetic_mutants.document(), "fedcba9")["elsewhere"]
    assert not mutants.page(synthetic_mutants.document(), "0123456")["elsewhere"]


def test_every_sort_of_cell_looks_its_own(folder):
    page = mutants.page(synthetic_mutants.document())
    looks = {row["id"]: [(cell["look"], cell["words"]) for cell in row["cells"]] for area in page["areas"] for row in area["rows"]}
    assert looks["wrong-sign"][:4] == [("red", "6"), ("red", "1"), ("", ""), ("open", "?")]
    assert looks["drifting"][:2] == [("drift", "1"), ("green", "0")]
    assert looks["endless"][2] == ("stop", "×")
    assert looks["narrow"][4:] == [("red", "1"), ("", "")]


def test_a_cell_names_its_gates(folder):
    page = mutants.page(synthetic_mutants.document())
    hints = [cell["hint"] for cell in page["areas"][0]["rows"][0]["cells"]]
    assert hints[0] == "order 0, order 1 and 4 more"
    assert hints[1] == "period (MISSING)" and hints[3] == ""


def test_survivors_and_bugs_that_are_none_are_listed_with_reasons(folder):
    listed = [" | ".join(cells) for cells in rows(shown(folder))]
    for part in (
        "SURVIVED | living",
        "Open.",
        "No case of the tier meets this place.",
        "both forms are the same sum",
        "Only drift: sod: stored",
    ):
        assert any(part in line for line in listed), part


def test_each_case_lists_the_bugs_it_must_catch(folder):
    must = [cells for cells in rows(shown(folder)) if len(cells) == 3 and "of 9" in cells[1]]
    assert must[0] == ["sod", "7 of 9", "wrong-sign"] and must[2][2] == "—"


def test_texts_are_escaped(folder):
    source = source_of(folder)
    assert "what living does &lt;once&gt;" in source and "<once>" not in source


def test_the_stored_matrix_can_be_shown(tmp_path):
    """The one that the report falls back on."""
    stored = pathlib.Path(__file__).resolve().parents[1] / "mutants/last/mutants.json"
    if not stored.exists():
        pytest.skip("no matrix has been stored yet")
    document = json.loads(stored.read_text(encoding="utf-8"))
    (tmp_path / "mutants.json").write_text(json.dumps(document), encoding="utf-8")
    assert mutants.page(document)["score"] in shown(tmp_path).text
