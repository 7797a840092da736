"""Bugs drawn at random in the section "Mutation testing": their rates, and what it says without any."""

import json
import pathlib

import pytest

import draws
import synthetic_draw
import synthetic_mutants
from html_page import shown


@pytest.fixture
def page(tmp_path):
    synthetic_draw.write(tmp_path)
    synthetic_mutants.write(tmp_path)
    return shown(tmp_path)


def test_rates_stand_with_their_intervals_seed_and_commit_beside_the_declared_bugs(page):
    for part in (
        "Gates of cases see 20 % (1 of 5; 0 to 32 %), with the gates of parts of schemes 40 % (2; 15 to 52 %), gates and tests 60 % (3; 35 to 72 %)",
        "a seed (7) drew 6 of 5,000 places",
        "from commit 0123456",
        "gates of cases see 40 % (10 to 80 %)",
        "Passed over for the next of their operator: 2 are in code that the compiler makes nothing of",
        "Cases of more than 30 s took no part",
        "Gates of cases see 2 of the 7; unit tests alone see 2",
    ):
        assert part in page.text, part


def test_operators_and_folders_have_rates_of_their_own(page):
    rows = {cells[0]: cells[1:] for section, cells in page.rows if section == "mutants" and len(cells) == 6}
    assert rows["a term left out"] == ["4,000", "2", "50 % 25 to 62 %", "50 % 25 to 62 %", "100 % 75 to 100 %"]
    assert rows["the other sign"][1:3] == ["0", "—"]
    assert rows["kernel/"][1:] == ["5", "20 % 0 to 32 %", "40 % 15 to 52 %", "60 % 35 to 72 %"]


def test_survivors_and_those_that_only_tests_see_are_named(page):
    rows = {cells[0].split()[0]: cells for section, cells in page.rows if section == "mutants" and cells[0].startswith("s7-")}
    assert rows["s7-stage-000"][1:] == ["a<b of stage-000: left out", "—"]
    assert rows["s7-stage-001"][2] == "No case or test meets this place."
    assert rows["s7-stage-002"][2] == "shape cubic: sum"
    assert rows["s7-term-001"][2] == "tests/kernel: Walls.Reflect" and "s7-term-000" not in rows
    assert rows["s7-sign-000"][2] == "minus nothing is nothing"


def test_a_draw_of_another_commit_says_so():
    assert draws.page(synthetic_draw.document(), "fedcba9")["elsewhere"]
    assert not draws.page(synthetic_draw.document(), "0123456")["elsewhere"]


def test_without_a_draw_the_page_says_how_to_make_one(tmp_path):
    synthetic_mutants.write(tmp_path)
    assert "ci/mutants --draw 1" in shown(tmp_path).text


def test_the_stored_draw_can_be_shown(tmp_path):
    """The one that the report falls back on."""
    stored = pathlib.Path(__file__).resolve().parents[1] / "mutants/last/draw.json"
    if not stored.exists():
        pytest.skip("no draw has been stored yet")
    document = json.loads(stored.read_text(encoding="utf-8"))
    (tmp_path / "draw.json").write_text(json.dumps(document), encoding="utf-8")
    assert draws.page(document)["by_cases"]["share"] in shown(tmp_path).text
