"""plumbline bench --cases: the document of error against cost, complete and of the same numbers as the runs themselves."""
import json
import math

import pytest
from contract import Plumbline, edited


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    plumbline = Plumbline(tmp_path_factory.mktemp("cost"))
    result = plumbline("bench", "--cases", "sod", "--repeats", 3, json=True, timeout=600)
    assert result.code == 0, result.err
    return plumbline, result.json("cost")


def runs(document, **wanted):
    return [run for run in document["runs"] if all(run[key] == value for key, value in wanted.items())]


def named(document, **wanted):
    """Runs that were made or are said to be left out: how many are made in time is a matter of the machine."""
    return runs(document, **wanted) + runs({"runs": document["left_out"]}, **wanted)


def test_refinement_of_the_default_scheme_is_there_and_repeated(made):
    _, document = made
    levels = runs(document, study="default")
    assert [run["cells"] for run in levels][:2] == [100, 200] and document["repeats"] == 3
    assert [run["value"] for run in named(document, study="default")][:4] == [100, 200, 400, 800]
    assert len(levels[0]["wall_s"]) == 3 and all(run["source"] == "timed" and run["finished"] for run in levels)


def test_every_integrator_and_the_other_scheme_are_there(made):
    plumbline, document = made
    integrators = {entry["name"] for entry in plumbline("list", json=True).json()["integrators"]}
    assert {run["study"].split("/")[1] for run in named(document) if run["study"].startswith("integrator/")} == integrators
    assert {run["study"] for run in document["runs"]} >= {"integrator/usl", "integrator/musl", "integrator/leapfrog"}
    assert len(runs(document, scheme="york1997", study="levels/york1997")) >= 2


def test_numbers_are_those_of_the_run(made):
    """Errors, points and steps of one entry against `run` of the same choices."""
    plumbline, document = made
    (entry,) = runs(document, study="york1997", cells=100)
    run = plumbline("run", "sod", "--cells", 100, "--scheme", "york1997", json=True).json()
    assert (entry["points"], entry["steps"], entry["h"]) == (run["points"], run["steps"], run["h"])
    assert entry["particle_steps"] == run["points"] * run["steps"] and entry["dt"] == pytest.approx(run["time"] / run["steps"])
    for name, error in entry["errors"].items():
        assert error == {key: run["measures"][name][key] for key in ("error", "relative_error")}
    assert "density.L1" in entry["errors"]


def test_surface_has_both_schemes_over_cells_and_courant_number(made):
    _, document = made
    for scheme in ("default", "york1997"):
        assert len(named(document, study="surface", scheme=scheme, vary="dt")) == 4 * 7
        surface = runs(document, study="surface", scheme=scheme, vary="dt")
        assert len({run["cells"] for run in surface}) >= 2
        for run in surface:  # the step follows the Courant number: twice of it takes about half the steps
            others = [other for other in surface if other["cells"] == run["cells"] and math.isclose(other["value"], 2 * run["value"])]
            assert all(1.7 < run["steps"] / other["steps"] < 2.3 for other in others if other["steps"] > 50)


def test_a_longer_run_is_taken_from_the_results_folder(made):
    """What is too long to be made is a matter of the machine, so a stored file is made to say that its run took long."""
    plumbline, document = made
    (entry,) = runs(document, study="york1997", cells=100)
    assert entry["source"] == "timed"
    plumbline("run", "sod", "--scheme", "york1997", "--cells", 100)
    (stored,) = plumbline.files()
    with edited(plumbline.folder / "results" / stored) as file:
        run = {**json.loads(file["run"][()]), "wall_s": 1e4}
        del file["run"]
        file["run"] = json.dumps(run)
    document = plumbline("bench", "--cases", "sod", "--repeats", 1, json=True, timeout=600).json("cost")
    (entry,) = runs(document, study="york1997", cells=100)
    assert entry["source"] == "stored" and entry["wall_s"] == [1e4] and entry["steps"] == run["steps"]


@pytest.mark.parametrize("arguments, words", [
    (["--cases", "sodd"], "sod"),
    (["--cases", "sod", "--tier", "quik"], "quick"),
    (["--cases", "sod", "--set", "cfl=0.1"], "--set"),
    (["--cases", "sod", "--scheme", "york1997"], "--scheme"),
    (["--cases", "sod", "--repeats", 0], "--repeats"),
    (["sod"], "--cases"),
])
def test_wrong_call(plumbline, arguments, words):
    result = plumbline("bench", *arguments)
    assert result.code == 2 and words in result.err
