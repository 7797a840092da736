"""Commands that the page prints beside figures and gates give the numbers that it shows: one of each kind, made again in a folder of its own.
Those of the speed page: test_bench.py, which has such documents."""
import shlex
import sys

import pytest
from contract import ROOT, Plumbline

sys.path.insert(0, str(ROOT / "reports"))

import cases as gathering  # noqa: E402  (needs the path above)
import reproduce  # noqa: E402
import york_figures  # noqa: E402
from plumbline import reader  # noqa: E402


def gathered(plumbline, case):
    return gathering.gather(reader.load_folder(plumbline.folder / "results"))[case]


def again(command, tmp_path_factory):
    """The document of a printed command, run where nothing is stored."""
    program, *words = shlex.split(command)
    assert program == "plumbline"
    result = Plumbline(tmp_path_factory.mktemp("again"))(*words, json=True)
    assert result.code in (0, 1), result.text
    return result.json()


@pytest.mark.parametrize("words", [
    ["--cells", "10,14,20", "--set", "t_end=0.1"],
    ["--cells", "10,14", "--scheme", "york1997", "--set", "density=continuity"],
    ["--cells", "20", "--vary", "dt", "--values", "1,0.5,0.25", "--integrator", "musl"],
    ["--cells", "20", "--vary", "ppc", "--values", "6,8", "--set", "gamma=1.5"],
    ["--cells", "20", "--vary", "offset", "--values", "0,0.3"],
])  # fmt: skip
def test_figures_of_a_study(plumbline, tmp_path_factory, words):
    """Convergence and one parameter alone: settings that are not the scheme's, and the very levels."""
    plumbline("converge", "sod", *words)
    (entry,) = [entry for entry in gathered(plumbline, "sod").series if entry.refined]
    (study,) = again(reproduce.study(entry, "sod"), tmp_path_factory)["studies"]
    assert [level["measures"] for level in study["levels"]] == [level["measures"] for level in entry.levels]
    assert study["measures"] == entry.measures and study["settings"] == entry.settings


@pytest.mark.parametrize("words", [["--set", "t_end=0.1"], ["--scheme", "york1997"], ["--integrator", "usl", "--set", "dt=0.001"]])
def test_profile_of_a_run(plumbline, tmp_path_factory, words):
    plumbline("run", "sod", "--cells", 20, *words)
    (level,) = gathered(plumbline, "sod").runs
    run = again(reproduce.run(level), tmp_path_factory)
    assert run["measures"] == level["measures"] and run["settings"] == level["settings"]


@pytest.fixture(scope="module")
def verified(tmp_path_factory):
    """Judged gates of cheap cases: runs, and a table of the laboratory."""
    plumbline = Plumbline(tmp_path_factory.mktemp("verified"))
    return plumbline("verify", "standing-wave", "stability-oscillator", json=True).json()["gates"]


@pytest.mark.parametrize("case, wanted", [
    ("standing-wave", lambda gate: "order of" in gate["quantity"]),
    ("standing-wave", lambda gate: gate["id"].endswith("/regression")),
    ("standing-wave", lambda gate: gate["origin"] == "identity"),
    ("standing-wave", lambda gate: " at " in gate["quantity"]),
    ("stability-oscillator", lambda gate: gate["origin"] == "theory"),
], ids=["order", "regression", "identity", "error", "limit"])  # fmt: skip
def test_each_kind_of_gate(verified, tmp_path_factory, case, wanted):
    gate = next(gate for gate in verified if gate["case"] == case and wanted(gate))
    (same,) = again(reproduce.gate(gate), tmp_path_factory)["gates"]
    assert (same["id"], same["measured"], same["verdict"]) == (gate["id"], gate["measured"], gate["verdict"])


def test_pictures_of_a_run(plumbline, tmp_path_factory):
    """The points at every instant, also in the pictures of York's figures, which are drawn of the same frames."""
    plumbline("run", "two-disks", "--cells", 10, "--frames", 4)
    (result,) = reader.load_folder(plumbline.folder / "results").runs
    command = reproduce.pictures(result.run, len(result.frames))
    assert york_figures._command(result, "points") == command
    elsewhere = Plumbline(tmp_path_factory.mktemp("again"))
    assert elsewhere(*shlex.split(command)[1:]).code == 0
    (same,) = reader.load_folder(elsewhere.folder / "results").runs
    assert len(same.frames) == 4 and (same.frames.times == result.frames.times).all()
    assert (same.frames.points["position"] == result.frames.points["position"]).all()


def test_growth_of_a_problem_among_several(plumbline, tmp_path_factory):
    document = plumbline("stability", "oscillator", "plane", "--no-runs", json=True).json("stabilities")
    wanted = next(problem for problem in document["problems"] if problem["problem"] == "oscillator")
    same = again(reproduce.growth("oscillator", document), tmp_path_factory)
    assert [row["growth"] for row in same["configurations"]] == [row["growth"] for row in wanted["configurations"]]


def test_maps_of_a_problem_among_several(plumbline, tmp_path_factory):
    document = plumbline("stability", "plane", "wave", "--maps", "--no-runs", "--tier", "quick", json=True).json("stabilities")
    wanted = next(problem for problem in document["problems"] if problem["problem"] == "plane")
    assert wanted["maps"] and again(reproduce.maps("plane", document), tmp_path_factory)["maps"] == wanted["maps"]


def test_scorecard_of_an_integrator(plumbline, tmp_path_factory):
    plumbline("verify", "--integrator", "usavg", "--core")
    (card,) = reader.load_folder(plumbline.folder / "results").scorecards
    elsewhere = Plumbline(tmp_path_factory.mktemp("again"))
    assert elsewhere(*shlex.split(reproduce.scorecard(card))[1:]).code in (0, 1)
    (same,) = reader.load_folder(elsewhere.folder / "results").scorecards
    assert [(gate["id"], gate["measured"]) for gate in same["gates"]] == [(gate["id"], gate["measured"]) for gate in card["gates"]]
    errors = [[level["error"] for curve in made["cost"] for level in curve["levels"]] for made in (card, same)]
    assert card["gates"] and errors[0] == errors[1]


def test_no_command_where_a_file_does_not_say_what_was_chosen():
    assert reproduce.run({"case": "sod", "scheme": "default", "settings": {"cells": 10}}) == ""


@pytest.mark.parametrize("words, said", [(["verify", "sod", "--gate", "default/ordr"], "default/order"), (["verify", "--gate", "x"], "case"),
                                         (["converge", "sod", "--values", "1,2"], "--cells"), (["converge", "sod", "--vary", "dt", "--values", "0,1"], "positive")])
def test_wrong_calls(plumbline, words, said):
    result = plumbline(*words)
    assert result.code == 2 and said in result.err
