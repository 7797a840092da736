"""Exit statuses and what is said: 2 a wrong call, 3 an inadmissible state, 4 files. Nothing is half-written."""
import pytest
from contract import parse, validate


def refused(plumbline, *arguments, says=(), nearest=None, results=True):
    """Exit status 2, the reason in text and in JSON, no file left behind."""
    folder = ["--results", "results"] if results else []
    text = plumbline(*arguments, *folder)
    result = plumbline(*arguments, *folder, json=True)
    assert (text.code, result.code) == (2, 2), text.text
    error = result.json("error")["error"]
    for word in says:
        assert word in text.err and word in error["message"], (word, text.err, error)
    if nearest is not None:
        assert nearest in error["nearest"], error
        assert nearest in text.err
    assert plumbline.files(".") == []
    return error


def test_run_away_step_stops_with_step_point_and_field(plumbline):
    arguments = ["run", "sod", "--cells", 100, "--set", "cfl=5"]
    result = plumbline(*arguments, json=True)
    assert result.code == 3
    run = result.json()
    stop = run["stop"]
    assert run["finished"] is False and run["verdict"] not in ("PASS", "XFAIL")
    assert isinstance(stop["point"], int) and stop["point"] < run["points"]
    assert run["settings"]["cfl"] == 5
    text = plumbline(*arguments)
    assert text.code == 3
    for word in ("step", str(stop["step"]), "point", str(stop["point"]), stop["field"]):
        assert word in text.text


@pytest.mark.parametrize("key, suggestion", [("cflx", "cfl"), ("shap", "shape"), ("viscosity.liner", "viscosity.linear"), ("gama", "gamma"), ("tend", "t_end")])
def test_unknown_key_suggests_the_nearest(plumbline, key, suggestion):
    error = refused(plumbline, "run", "sod", "--set", f"{key}=1", says=[key], nearest=suggestion)
    assert error["key"] == key


@pytest.mark.parametrize("choice", ["shape=linear", "transfer=flip"])
@pytest.mark.parametrize("how", [["--integrator", "energy"], ["--set", "integrator=energy"]])
def test_combination_that_cannot_work_names_both_choices(plumbline, choice, how):
    refused(plumbline, "run", "sod", "--cells", 20, *how, "--set", choice, says=["energy", *choice.split("=")])


@pytest.mark.parametrize("more", [[], ["--dry-run"]])
def test_scene_that_an_integrator_cannot_move_names_both(plumbline, more):
    error = refused(plumbline, "run", "piston-shock", "--scheme", "york1997", *more, says=["musl", "piston-shock", "returnable-loss"])
    assert (error["key"], error["value"]) == ("integrator", "musl") and error["allowed"]


@pytest.mark.parametrize("arguments, key", [
    (["run", "stability-bar", "--cells", 20], "cells"),
    (["run", "stability-bar", "--set", "shape=linear"], "shape"),
    (["run", "stability-bar", "--integrator", "musl"], "integrator"),
    (["run", "stability-bar", "--frames", 3], "--frames"),
    (["run", "stability-bar", "--checkpoint", "c.h5"], "--checkpoint"),
    (["export", "stability-bar", "--output", "c.h5"], "case"),
    (["converge", "stability-bar", "--cells", "10,20"], "case"),
], ids=lambda value: "-".join(map(str, value)) if isinstance(value, list) else None)
def test_trials_take_no_choices_of_runs(plumbline, arguments, key):
    assert refused(plumbline, *arguments, says=["stability-bar"], results=arguments[0] != "export")["key"] == key


@pytest.mark.parametrize("arguments, nearest", [
    (["run", "sodd"], "sod"),
    (["explain", "spring-mas"], "spring-mass"),
    (["converge", "sob"], "sod"),
    (["run", "sod", "--scheme", "york1979"], "york1997"),
    (["run", "sod", "--integrator", "mussl"], "musl"),
    (["run", "sod", "--set", "integrator=usavgg"], "usavg"),
    (["run", "sod", "--set", "shape=cubik"], "cubic"),
    (["run", "sod", "--set", "transfer=apci"], "apic"),
    (["run", "sod", "--set", "density=quadratc"], "quadratic"),
    (["run", "sod", "--set", "points=equal-mas"], "equal-mass"),
    (["converge", "sod", "--vary", "cell"], "cells"),
])
def test_unknown_name_offers_near_ones(plumbline, arguments, nearest):
    refused(plumbline, *arguments, nearest=nearest, results=arguments[0] != "explain")


def test_unknown_reference_offers_near_ones(plumbline):
    refused(plumbline, "reference", "rieman", nearest="riemann", results=False)


@pytest.mark.parametrize("setting", ["cfl=0", "cfl=-1", "cfl=inf", "cfl=nan", "cfl=fast", "cfl=", "cfl=0.5x", "cfl=0,5", "ppc=0", "ppc=-3", "offset=1", "offset=-0.1",
                                     "dt=0", "dt=-1e-3", "viscosity.linear=-1", "gamma=1", "gamma=0.5", "t_end=0", "diaphragm=2"])
def test_value_out_of_range_is_told_with_the_range(plumbline, setting):
    key, value = setting.split("=")
    error = refused(plumbline, "run", "sod", "--set", setting, says=[key])
    assert error["key"] == key and error["allowed"]
    assert str(error["value"]) in ("None", value) or float(error["value"]) == float(value)


@pytest.mark.parametrize("arguments", [
    ["run", "sod", "--cells", "0"],
    ["run", "sod", "--cells", "-5"],
    ["run", "sod", "--cells", "many"],
    ["run", "sod", "--cells", "10.5"],
    ["run", "sod", "--threads", "0"],
    ["run", "sod", "--set", "cfl"],
    ["run", "sod", "--set", "=1"],
    ["run", "sod", "--no-such-option"],
    ["run"],
    ["runn", "sod"],
    [],
    ["converge", "sod", "--cells", ","],
    ["converge", "sod", "--cells", "10,ten"],
    ["verify", "sod", "--tier", "medium"],
    ["reference", "riemann", "--at", "middle"],
    ["reference", "riemann", "--set", "left.density=-1"],
    ["reference", "riemann", "--set", "left.densty=1"],
])
def test_wrong_call(plumbline, arguments):
    result = plumbline(*arguments)
    assert result.code == 2, result.text
    assert result.err.strip(), "says what is wrong on standard error"
    assert plumbline.files(".") == []


def test_pattern_that_matches_nothing(plumbline):
    refused(plumbline, "verify", "no-such-case", says=["no-such-case"])
    assert plumbline("verify", "spring-mass", "no-such-case").code == 2, "each pattern counts"


@pytest.mark.parametrize("arguments", [["run", "sod", "--cells", 20], ["converge", "sod", "--cells", "10,20"], ["verify", "spring-mass"]])
def test_results_folder_below_a_file(plumbline, arguments):
    (plumbline.folder / "file").write_text("here already")
    result = plumbline(*arguments, "--results", "file/results", json=True)
    assert result.code == 4
    assert "file/results" in result.json("error")["error"]["message"]
    assert "file/results" in result.err
    assert plumbline.files(".") == ["file"] and (plumbline.folder / "file").read_text() == "here already"


@pytest.mark.parametrize("arguments", [
    ["list", "--json", "file/out.json"],
    ["run", "sod", "--cells", 20, "--json", "file/out.json"],
    ["verify", "spring-mass", "--tier", "quick", "--json", "file/out.json"],
    ["verify", "spring-mass", "--tier", "quick", "--junit", "file/junit.xml"],
])
def test_document_that_cannot_be_written(plumbline, arguments):
    (plumbline.folder / "file").write_text("")
    result = plumbline(*arguments, timeout=600)
    assert result.code == 4 and arguments[-1] in result.err
    assert not [name for name in plumbline.files(".") if ".json" in name or ".xml" in name]


def test_plugin_that_is_no_library(plumbline):
    assert plumbline("run", "sod", "--plugin", "missing.so").code == 4
    (plumbline.folder / "text.so").write_text("not a library")
    result = plumbline("run", "sod", "--plugin", "text.so")
    assert result.code == 4 and "text.so" in result.err
    assert plumbline.files(".") == ["text.so"]


def test_stopped_run_leaves_whole_files_only(plumbline):
    assert plumbline("run", "sod", "--cells", 100, "--set", "cfl=5", "--json", "out.json").code == 3
    assert all(name.endswith(".h5") for name in plumbline.files())
    run = validate("run", parse((plumbline.folder / "out.json").read_text(encoding="utf-8")))
    assert run["finished"] is False


def test_json_output_is_alone_on_standard_output(plumbline):
    for arguments in (["run", "sod", "--cells", 20], ["run", "sod", "--set", "cflx=1"], ["run", "sod", "--cells", 100, "--set", "cfl=5"]):
        result = plumbline(*arguments, json=True)
        assert parse(result.out)


def test_wrong_call_wins_over_unwritable_folder(plumbline):
    (plumbline.folder / "file").write_text("")
    assert plumbline("run", "sod", "--set", "cflx=1", "--results", "file/results").code == 2
    assert plumbline("run", "sod", "--cells", 100, "--set", "cfl=5", "--results", "file/results").code == 4
