"""The page of a scoreboard: complete, self-contained, and true to the document."""

import copy
import html
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
from collections import Counter

import pytest

from plumbline import reader
import reproduce
import scoreboard
import synthetic_board
import text
from html_page import Page, without_command, without_scripts


@pytest.fixture(scope="module")
def source(tmp_path_factory):
    folder = synthetic_board.write_board(tmp_path_factory.mktemp("board"))
    assert scoreboard.main([str(folder)]) == 0
    return (folder / scoreboard.PAGE).read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def page(source):
    return Page(source)


def rows(page):
    return [cells for section, cells in page.rows if section == "results"]


def test_page_is_whole_and_loads_nothing(source, page):
    assert [name for name, times in Counter(page.ids).items() if times > 1] == []
    assert page.links and all(link[1:] in page.ids for link in page.links)
    assert [entry for entry in page.loads if not entry[2].startswith("data:,")] == []
    assert not re.search(r"https?:|@import|<script|<iframe|url\((?!#)", without_scripts(source))


def test_same_document_gives_the_same_bytes(source):
    assert scoreboard.render_board(synthetic_board.board()) == source


def test_each_result_of_the_document_is_in_the_table(page):
    shown = rows(page)
    assert len(shown) == 1 + 1 + 5 + 1, "heading, one mesh, five meshes, their order"
    for number, problem in enumerate(synthetic_board.board()["problems"]):
        for k, level in enumerate(problem["own"]["levels"]):
            cells = shown[1 + number + k][-5:]
            own = f"{text.number(level['errors']['density.L1'])} {text.seconds(level['seconds'])}"
            assert cells[:2] == [str(level["cells"]), " ".join(own.split())]
            for program, cell in zip(problem["programs"], cells[2:]):
                entry = program["entries"][k]
                if entry["outcome"] == "scored":
                    ratio = text.number(entry["errors"]["density.L1"]["ratio"])
                    assert f"× {ratio}" in cell and (entry["verdict"] in cell) == (entry["verdict"] != "NONE")
                    assert ("with start-up" in cell) == (entry["timed"] == "adapter")
                else:
                    assert cell.startswith(scoreboard.OUTCOMES[entry["outcome"]][0]) and "×" not in cell
                    assert entry["outcome"] == "missing" or entry["reason"] in cell
    assert shown[-1][-4:] == ["1.000 [1.000, 1.000]", "FAIL 0.400 [0.400, 0.400]", "PASS 1.000 [1.000, 1.000]", "—"]


def test_cards_count_results_and_verdicts(source, page):
    assert "12 of 18 results could be scored" in page.text
    assert "2 of 4 verdicts" in page.text
    green = synthetic_board.board()
    green["problems"] = green["problems"][1:]
    green["problems"][0]["programs"] = green["problems"][0]["programs"][1:2]
    green["refused"] = []
    cards = scoreboard.glance(green)
    assert [(card["figure"], card["look"]) for card in cards] == [("5 of 5", "pass"), ("1 of 1", "pass")]
    assert scoreboard.glance({**green, "refused": [{"start": "a.h5", "reason": "b"}]})[0]["look"] == "invalid"


def test_gates_and_what_was_left_out_are_told(page):
    for words in ("default/order", "requirement: what users of such a code expect", "default/drift", "reads the <ledger>", "cases/cut.h5", "truncated: 7 of 9",
                  "programs/exact/sod-90.h5", "ValueError: <no> such wall", "t_end=1.25", "density.L1 in kg/m³", "plumbline scoreboard board"):
        assert words in page.text, words


def test_errors_are_drawn_where_there_are_several_meshes(source, page):
    (label,) = page.labels
    assert label == "Error of density.L1 over cell size, Sod’s shock tube: Plumbline’s default, coarse and exact"
    assert "troubled" not in label and source.count('class="plot"') == 1


def test_commands_make_each_part_of_the_board_again(source):
    """In the folder of the page: the starts, the default scheme from them, and each program's score."""
    assert without_command({"board": source}) == []
    said = [html.unescape(command) for command in re.findall(r"Reproduce: <code>([^<]*)", source)]
    results = " ".join(f"--result programs/exact/sod-{cells}.h5" for cells in synthetic_board.CELLS)
    assert f"plumbline score sod {results}" in said and "plumbline converge sod --cells 50,100,200,400,800" in said
    assert [command for command in said if command.startswith("plumbline export sod ")][1:2] == ["plumbline export sod --cells 100 --output cases/sod-100.h5"]
    assert "plumbline run bar-riemann --cells 100 --set velocity=1e-05 --set t_end=1.25" in said
    assert not [command for command in said if "verify" in command or "troubled" in command]


def test_commands_of_a_board_give_its_numbers(tmp_path):
    program = os.environ.get("PLUMBLINE")
    if not program:
        pytest.skip("the environment variable PLUMBLINE names no executable")

    def plumbline(command):
        done = subprocess.run([program, *shlex.split(command)[1:]], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert done.returncode in (0, 1), done.stderr
        return done

    (tmp_path / "cases").mkdir()
    adapter = pathlib.Path(__file__).resolve().parents[1] / "stranger/adapter.py"
    stranger = tmp_path / "stranger"  # by the interpreter of the tests, which has what it imports
    stranger.write_text(f'#!/bin/sh\nexec {shlex.quote(sys.executable)} -B {shlex.quote(str(adapter))} "$@"\n')
    stranger.chmod(0o755)
    for cells in (10, 14):
        plumbline(f"plumbline export sod --cells {cells} --set ppc=4 --output cases/sod-{cells}.h5")
    plumbline(f"plumbline scoreboard . --run stranger=./stranger")
    (problem,) = reader.load_scoreboard(tmp_path / scoreboard.DOCUMENT)["problems"]
    (entry,) = problem["programs"]
    scored, own = reproduce.scored(problem, entry), reproduce.beside(problem)
    before = (tmp_path / "cases/sod-10.h5").read_bytes()
    (tmp_path / "cases/sod-10.h5").unlink()
    plumbline(reproduce.exported(problem, "sod-10.h5", 10))
    assert (tmp_path / "cases/sod-10.h5").read_bytes() == before
    assert json.loads(plumbline(f"{scored} --json -").stdout)["gates"] == entry["gates"]
    (study,) = json.loads(plumbline(f"{own} --json -").stdout)["studies"]
    for level, stated in zip(study["levels"], problem["own"]["levels"], strict=True):
        assert {name: measure["error"] for name, measure in level["measures"].items()} == stated["errors"]


def test_default_scheme_that_stopped_and_results_that_are_no_series():
    board = synthetic_board.board()
    board["problems"][1]["own"]["levels"][1].update(errors={}, stop="density is not positive")
    programs = board["problems"][1]["programs"]
    programs[0]["entries"][1]["errors"]["density.L1"]["ratio"] = None
    programs[1].update(verdict=None, reason="program is a 2; a 1 is wanted", orders={}, gates=[])
    page = Page(scoreboard.render_board(board))
    assert "stopped: density is not positive" in page.text and "program is a 2; a 1 is wanted" in page.text
    assert rows(page)[3][-3].startswith(text.number(0.5 * 2.5 / 100)), "without a factor the error itself"


def test_empty_board():
    board = {**synthetic_board.board(), "problems": []}
    page = Page(scoreboard.render_board(board))
    assert "0 programs, 0 problems" in page.text and "cases/cut.h5" in page.text


def broken(change):
    board = copy.deepcopy(synthetic_board.board())
    change(board)
    return board


@pytest.mark.parametrize(
    "document, said",
    [
        ("[]", "malformed"),
        ("{", "JSON"),
        ("\xff", ""),
        (broken(lambda board: board.pop("problems")), "scoreboard.problems is missing"),
        (broken(lambda board: board.update(scoreboard=2)), "newer version"),
        (broken(lambda board: board["problems"][0].update(case=1)), "problems[0].case is malformed"),
        (broken(lambda board: board["problems"][0]["own"]["levels"][0].update(h="x")), "levels[0].h is malformed"),
        (broken(lambda board: board["problems"][1]["programs"][0]["entries"][2].pop("outcome")), "entries[2].outcome is missing"),
        (broken(lambda board: board["problems"][1]["programs"][0]["entries"].pop()), "4 entries"),
        (broken(lambda board: board["problems"][1]["programs"][0]["entries"][2]["errors"].update(a=1)), "errors.a is malformed"),
        (broken(lambda board: board["problems"][1]["own"]["orders"].update(a={"order": "x"})), "orders.a.order is malformed"),
        (broken(lambda board: board["strays"].append(None)), "strays[1] is malformed"),
    ],
)
def test_damaged_document_is_named(tmp_path, capsys, document, said):
    (tmp_path / scoreboard.DOCUMENT).write_text(document if isinstance(document, str) else json.dumps(document), encoding="latin-1")
    assert scoreboard.main([str(tmp_path)]) == 4
    told = capsys.readouterr().err
    assert said in told and "scoreboard.json" in told and not (tmp_path / scoreboard.PAGE).exists()


def test_missing_document_says_how_to_make_it(tmp_path, capsys):
    assert scoreboard.main([str(tmp_path)]) == 4
    assert "`plumbline scoreboard" in capsys.readouterr().err


def test_document_that_was_read_is_the_one_that_was_written(tmp_path):
    folder = synthetic_board.write_board(tmp_path)
    assert reader.load_scoreboard(folder / scoreboard.DOCUMENT) == synthetic_board.board()
