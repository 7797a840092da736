"""The Python package: what it gives of results, what it raises, where it looks for the executable, its types and its notebook."""

import importlib.util
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tomllib

import matplotlib
import numpy
import plumbline
import pytest
import synthetic_results
from plumbline import execution, reader

matplotlib.use("agg")
HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
REPORTS = ROOT / "reports"
NOTEBOOK = REPORTS / "docs" / "how-to" / "use-from-python.ipynb"


@pytest.fixture(scope="module")
def sod():
    return plumbline.run("sod", cells=50)


@pytest.fixture
def nowhere(monkeypatch):
    monkeypatch.delenv("PLUMBLINE", raising=False)
    monkeypatch.setenv("PATH", "/nowhere")


@pytest.fixture
def ends(tmp_path):
    """An executable that prints a text on each stream and ends with a status."""

    def made(status, out="", err="", name="stub"):
        path = tmp_path / name
        path.write_text(f"#!/bin/sh\ncat <<'END'\n{out}\nEND\ncat >&2 <<'END'\n{err}\nEND\nexit {status}\n", encoding="utf-8")
        path.chmod(0o755)
        return path

    return made


# --- runs -----------------------------------------------------------------------------------------


def test_a_run_gives_arrays_measures_and_verdict(sod):
    """Every number as the executable prints it: the profile's own error is the measured one, mass is that of the tube."""
    density, exact, volume = (sod.profile[name] for name in ("density", "density_reference", "volume"))
    assert density.dtype == numpy.float64 and len(density) == sod.run["points"] > 50
    l1 = numpy.sum(numpy.abs(density - exact) * volume) / numpy.sum(volume)
    # The norm integrates between the points too; both sums see the same jumps, a cell wide.
    assert l1 == pytest.approx(sod.measures["density.L1"]["error"], rel=0.5)
    tube = 1.0 * 0.5 + 0.125 * 0.5  # kg: two halves of a metre, 1 m^2 wide
    assert numpy.sum(sod.profile["mass"]) == pytest.approx(tube, rel=1e-12)
    assert (sod.case, sod.scheme, sod.verdict, sod.settings["cells"]) == ("sod", "default", "PASS", 50)
    assert sod.profile.units["density"] == "kg/m^3" and sod.run["finished"]


def test_choices_reach_the_executable(tmp_path):
    run = plumbline.run("sod", cells=20, scheme="york1997", gamma=1.67, threads=1, results=tmp_path, **{"viscosity.linear": 0.1})
    assert (run.scheme, run.settings["gamma"], run.settings["viscosity.linear"]) == ("york1997", 1.67, 0.1)
    (kept,) = tmp_path.glob("*.h5")
    assert reader.load(kept).measures == run.measures
    assert plumbline.run("sod", cells=20, integrator="usl", frames=3).settings["integrator"] == "usl"


def test_no_result_is_left_behind_without_a_folder(tmp_path, monkeypatch):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    plumbline.run("sod", cells=20)
    assert list(tmp_path.iterdir()) == []


def test_a_study_gives_errors_order_and_interval(tmp_path):
    study = plumbline.converge("sod", cells=[20, 40, 80], results=tmp_path)
    h, error = study.errors("density.L1")
    assert list(h) == [1 / 20, 1 / 40, 1 / 80] and numpy.all(numpy.diff(error) < 0)
    fit = study.measures["density.L1"]
    # Least squares through three equidistant points in ln h: the slope is that between the outer ones.
    assert fit["order"] == pytest.approx(numpy.log(error[0] / error[2]) / numpy.log(4), rel=1e-9)
    assert study.verdict == "INCONCLUSIVE" and study.kind == "study"  # three levels do not suffice; that is no exception
    other = plumbline.converge("sod", cells=[20, 40, 80], results=tmp_path, gamma=1.67)
    assert other.study["settings"]["gamma"] == 1.67  # two studies of the case are in the folder
    assert len(plumbline.results(tmp_path).studies) == 2
    with pytest.raises(KeyError, match=r"no errors of 'mass'.*density\.L1"):
        study.errors("mass")


def test_verify_gives_all_gates():
    judged = plumbline.verify("shear-decay")
    assert judged.verdict in ("PASS", "XFAIL") and len(judged.gates) == judged.verdicts["executed"] > 0
    assert {gate["case"] for gate in judged.gates} == {"shear-decay"}


def test_the_most_urgent_verdict_counts():
    gates = [{"verdict": verdict} for verdict in ("PASS", "XFAIL", "FAIL", "NONE")]
    result = reader.Result("verdicts", "", reader.FORMAT_VERSION, gates=gates)
    assert result.verdict == "FAIL"
    assert reader.Result("verdicts", "", reader.FORMAT_VERSION).verdict == "NONE"


# --- what is refused ------------------------------------------------------------------------------


def test_a_refusal_carries_message_and_status():
    with pytest.raises(plumbline.ExecutionError, match="unknown case 'sodd'; did you mean sod") as refused:
        plumbline.run("sodd")
    assert refused.value.status == 2 and refused.value.command[1:3] == ["run", "sodd"]
    with pytest.raises(plumbline.ExecutionError, match="cells = -4 is not allowed: whole number in"):
        plumbline.run("sod", cells=-4)


def test_a_run_that_stops_says_so_and_keeps_what_there_is():
    """Of Courant number 6: a point moves by more than a cell, which the executable refuses."""
    with pytest.raises(plumbline.RunStopped, match="stopped at step 1: a point moved more than one cell") as stopped:
        plumbline.run("sod", cells=20, cfl=6)
    assert stopped.value.status == 3 and stopped.value.result.run["finished"] is False
    with pytest.raises(plumbline.RunStopped, match="a point moved more than one cell"):
        plumbline.converge("sod", cells=[20, 40], cfl=6)


def test_what_is_no_document_is_an_error(ends):
    with pytest.raises(plumbline.ExecutionError, match="^out of tea$"):
        plumbline.run("sod", executable=ends(4, err="plumbline: out of tea"))
    with pytest.raises(plumbline.ExecutionError, match="ended with status 0"):
        plumbline.run("sod", executable=ends(0, out="no JSON"))
    with pytest.raises(plumbline.ExecutionError, match="left no file of the study"):
        document = {"studies": [{"scheme": "default", "vary": "cells", "settings": {}, "levels": []}]}
        plumbline.converge("sod", executable=ends(0, out=json.dumps(document)))


def test_a_signal_that_ended_the_executable_is_its_status(tmp_path):
    killed = tmp_path / "killed"
    killed.write_text("#!/bin/sh\nkill -9 $$\n", encoding="utf-8")
    killed.chmod(0o755)
    with pytest.raises(plumbline.ExecutionError) as error:
        plumbline.run("sod", executable=killed)
    assert error.value.status == -9


# --- the executable -------------------------------------------------------------------------------


def test_the_executable_is_found_in_this_order(nowhere, ends, monkeypatch):
    given, named, on_path = (str(ends(0, name=name)) for name in ("given", "named", "plumbline"))
    monkeypatch.setenv("PATH", str(pathlib.Path(on_path).parent))
    assert execution.executable_path() == on_path
    monkeypatch.setenv("PLUMBLINE", named)
    assert execution.executable_path() == named
    assert execution.executable_path(given) == given


def test_no_executable_is_a_clear_error(nowhere, monkeypatch):
    with pytest.raises(plumbline.ExecutableNotFound, match="on PATH; name one by the argument executable or .* PLUMBLINE"):
        plumbline.run("sod")
    with pytest.raises(plumbline.ExecutableNotFound, match="executable = /nowhere/p is no file"):
        plumbline.run("sod", executable="/nowhere/p")
    monkeypatch.setenv("PLUMBLINE", "/nowhere/q")
    with pytest.raises(plumbline.ExecutableNotFound, match="environment variable PLUMBLINE = /nowhere/q is no file"):
        plumbline.run("sod")


# --- libraries that are optional -------------------------------------------------------------------


def without(library, program, *arguments):
    """Ends a program of Python in which the library is not installed."""
    start = f"import sys; sys.modules[{library!r}] = None; sys.path.insert(0, {str(REPORTS)!r})"
    return subprocess.run([sys.executable, "-c", f"{start}\n{program}", *map(str, arguments)], capture_output=True, text=True, check=False)


def test_without_h5py_gates_are_judged_and_files_say_what_is_missing(results, ends):
    judged = json.dumps({"gates": [{"verdict": "PASS"}], "provenance": {}})
    ended = without("h5py", "import plumbline; print(plumbline.verify(executable=sys.argv[1]).verdict)", ends(0, out=judged))
    assert ended.stdout == "PASS\n", ended.stderr
    missing = r"h5py is not installed, which reading result files needs: apt-get install python3-h5py, or pip install h5py"
    for program in ("plumbline.reader.load(sys.argv[1])", "plumbline.results(sys.argv[2])"):
        ended = without("h5py", f"import plumbline; {program}", results[0] / results[1]["run"], results[0])
        assert re.search(f"plumbline.reader.NotInstalled: {missing}", ended.stderr), program
    ended = without("h5py", "from plumbline.reader import main; sys.exit(main(sys.argv[1:]))", results[0] / results[1]["run"])
    assert ended.returncode == 1 and re.fullmatch(f"plumbline: {missing}\n", ended.stderr)


@pytest.mark.parametrize("call", ["run('sod', executable=sys.argv[1])", "converge('sod', executable=sys.argv[1])"])
def test_without_h5py_nothing_is_computed_that_could_not_be_read(tmp_path, call):
    called = tmp_path / "called"
    executable = tmp_path / "executable"
    executable.write_text(f"#!/bin/sh\ntouch {called}\n", encoding="utf-8")
    executable.chmod(0o755)
    ended = without("h5py", f"import plumbline; plumbline.{call}", executable)
    assert "NotInstalled: h5py is not installed" in ended.stderr and not called.exists()


def test_without_matplotlib_a_figure_says_what_is_missing(results):
    program = "import plumbline; plumbline.reader.load(sys.argv[1]).plot()"
    ended = without("matplotlib", program, results[0] / results[1]["run"])
    assert "NotInstalled: matplotlib is not installed, which figures need: apt-get install python3-matplotlib, or pip install matplotlib" in ended.stderr


def test_h5py_and_matplotlib_are_extras():
    project = tomllib.loads((REPORTS / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert project["dependencies"] == ["numpy"]
    extras = project["optional-dependencies"]
    assert [extras["hdf5"], extras["plots"], extras["full"]] == [["h5py"], ["matplotlib"], ["h5py", "matplotlib"]]


# --- figures --------------------------------------------------------------------------------------


@pytest.fixture
def axes():
    from matplotlib import pyplot

    figure, axes = pyplot.subplots()
    yield axes
    pyplot.close(figure)


def test_a_field_is_drawn_over_its_reference(sod, axes):
    assert sod.plot("velocity", axes) is axes
    reference, computed = axes.get_lines()
    assert list(computed.get_ydata()) == list(sod.profile["velocity"])
    assert sorted(reference.get_ydata()) == sorted(sod.profile["velocity_reference"])
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("position in m", "velocity in m/s")
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["reference", "sod, default, 50 cells"]
    with pytest.raises(KeyError, match=r"no field 'densty'.*density"):
        sod.plot("densty")


def test_errors_of_a_study_are_drawn_with_their_order(results, axes):
    study = reader.load(results[0] / results[1]["study"])
    measure = next(iter(study.measures))
    study.plot(measure, axes)
    (line,) = axes.get_lines()
    assert list(line.get_ydata()) == list(study.errors(measure)[1]) and axes.get_xscale() == axes.get_yscale() == "log"
    (legend,) = axes.get_legend().get_texts()
    assert f"order {study.measures[measure]['order']:.2f}" in legend.get_text()


def test_verdicts_have_no_figure(results):
    with pytest.raises(TypeError, match="'verdicts' has nothing to be drawn"):
        reader.load(results[0] / results[1]["verdicts"]).plot()


def test_a_folder_is_read(results):
    found = plumbline.results(results[0])
    assert found.runs and found.studies and found.damaged
    assert found.verdicts[0].verdict == min((gate["verdict"] for gate in synthetic_results.all_gates()), key=reader.urgency)


# --- package --------------------------------------------------------------------------------------


def test_version_is_that_of_the_project():
    project = re.search(r"project\(Plumbline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))
    assert plumbline.__version__ == project.group(1)
    assert 'dynamic = ["version"]' in (REPORTS / "pyproject.toml").read_text(encoding="utf-8")


def test_it_installs_without_network(tmp_path):
    if missing := [name for name in ("pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]:
        pytest.skip(f"not installed: {', '.join(missing)}")
    source = tmp_path / "source"
    shutil.copytree(REPORTS / "plumbline", source / "plumbline", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(REPORTS / "pyproject.toml", source)
    venv = tmp_path / "venv"
    subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", venv], check=True)
    python = venv / "bin" / "python"
    pip = [python, "-m", "pip", "install", "--quiet", "--no-index", "--no-build-isolation", "--disable-pip-version-check", source]
    ended = subprocess.run(pip, capture_output=True, text=True, check=False)
    assert ended.returncode == 0, ended.stderr
    program = "import plumbline, importlib.metadata as m; print(plumbline.__file__, plumbline.__version__, m.version('plumbline'))"
    where, own, registered = subprocess.run([python, "-c", program], cwd=tmp_path, capture_output=True, text=True, check=True).stdout.split()
    assert pathlib.Path(where).is_relative_to(venv) and own == registered
    assert (pathlib.Path(where).parent / "py.typed").exists()


def test_types_hold(tmp_path):
    if importlib.util.find_spec("mypy") is None:
        pytest.skip("not installed: mypy")
    ended = subprocess.run(
        [sys.executable, "-m", "mypy", "--cache-dir", tmp_path], cwd=REPORTS, capture_output=True, text=True, check=False
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr


def test_the_notebook_gives_what_it_shows(monkeypatch, tmp_path):
    """Executed anew, every cell prints the text that is stored, and draws where a figure is."""
    pytest.importorskip("ipykernel")
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    monkeypatch.setenv("PYTHONPATH", str(REPORTS))
    monkeypatch.setenv("IPYTHONDIR", str(tmp_path))
    stored = nbformat.read(NOTEBOOK, as_version=4)
    fresh = nbformat.read(NOTEBOOK, as_version=4)
    nbclient.NotebookClient(fresh, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    for before, after in zip(stored.cells, fresh.cells):
        assert shown(after) == shown(before), before.source
    assert any("image/png" in kinds for cell in stored.cells for kinds, _ in shown(cell))
    assert not re.search(r"/(home|root|tmp|work)/", NOTEBOOK.read_text(encoding="utf-8"))


def shown(cell):
    """Of each output its kinds and, where it is a text without a figure, the text.

    A stream arrives in as many parts as the kernel happened to send: parts of one stream in succession are one output.
    """
    outputs = []
    for output in cell.get("outputs", []):
        stream = output.get("name")
        if stream and outputs and outputs[-1][0] == [stream]:
            outputs[-1] = ([stream], outputs[-1][1] + output["text"])
            continue
        data = output.get("data") or {stream: output.get("text", "")}
        outputs.append((sorted(data), "" if "image/png" in data else next(iter(data.values())) if stream else data["text/plain"]))
    return outputs


def test_parts_of_a_stream_are_one_output():
    def stream(name, text):
        return {"output_type": "stream", "name": name, "text": text}

    whole = {"outputs": [stream("stdout", "one\ntwo\n")]}
    parts = {"outputs": [stream("stdout", "one\n"), stream("stdout", "two\n")]}
    assert shown(parts) == shown(whole) != shown({"outputs": [stream("stdout", "one\n"), stream("stderr", "two\n")]})
