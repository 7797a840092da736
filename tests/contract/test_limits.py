"""What a run may take is known before its first step, signals end it wherever it is, and output arrives or is an error."""
import os
import resource
import signal
import subprocess
import time

import h5py
import pytest

from contract import exported, hand_in


# --- steps and memory ---------------------------------------------------------------------------------------------------------

@pytest.mark.parametrize("choice", ["dt=1e-300", "cfl=1e-300", "dt=5e-324", "cfl=1e-9"])
def test_steps_that_lead_nowhere_are_refused(plumbline, choice):
    result = plumbline("run", "sod", "--cells", 10, "--set", choice, json=True, timeout=20)
    assert result.code == 2
    error = result.json("error")["error"]
    assert error["key"] == choice.split("=")[0]
    assert "at least" in error["allowed"] or "larger" in error["allowed"]
    assert "--max-steps" in error["message"] and plumbline.files() == []


def test_fewer_steps_than_a_run_needs(plumbline):
    result = plumbline("run", "sod", "--cells", 10, "--max-steps", 3, json=True)
    assert result.code == 2 and "--max-steps" in result.json("error")["error"]["message"]
    assert plumbline("run", "sod", "--cells", 10, "--max-steps", 5000).code == 0


@pytest.mark.parametrize("arguments", [
    ("run", "mms-ring", "--cells", 16, "--set", "ppc=4879"),
    ("run", "affine-expansion", "--cells", 8, "--scheme", "york1997", "--set", "ppc=8009", "--dry-run"),
    ("run", "sod-3d", "--dry-run", "--cells", 1000000),
    ("converge", "two-disks", "--cells", "16,100000"),
])
def test_more_than_the_machine_has_is_refused_with_the_estimate(plumbline, arguments):
    began = time.monotonic()
    result = plumbline(*arguments, json=True, timeout=60)
    assert result.code == 2, result.text
    error = result.json("error")["error"]
    assert error["key"] == "--max-memory" and "GB" in error["value"] and "GB" in error["allowed"] and " points in " in error["message"]
    assert time.monotonic() - began < 20


def test_more_cells_than_an_int_counts_are_refused(plumbline):
    result = plumbline("run", "bar-vibration", "--set", "youngs_modulus=5e-324", "--dry-run", json=True, timeout=20)
    assert result.code == 2 and "2147483647" in result.json("error")["error"]["allowed"]


def test_choices_for_which_no_reference_is_known_are_refused(plumbline):
    """Each within its range, together beyond what the reference can solve."""
    result = plumbline("run", "toro-3", "--set", "right.density=5e-324", "--dry-run", json=True, timeout=20)
    assert result.code == 2 and result.json("error")["error"]["value"] == "right.density=5e-324"


def test_memory_that_nobody_foresaw_is_refused_too(plumbline):
    """What is asked for beside the points: the limit on allocations."""
    result = plumbline("export", "mms-ring", "--cells", 128, "--set", "ppc=8", "--output", "x.h5", "--max-memory", "100MB", json=True)
    assert result.code == 2 and "--max-memory" in result.json("error")["error"]["key"]
    assert plumbline.files(".") == []


# --- signals ------------------------------------------------------------------------------------------------------------------

# Where nobody looks for a signal: set-up, references and what a run measures.
SLOW = {
    "set-up": ["run", "normals-first-step", "--cells", 6, "--set", "membrane_points=100000"],
    "estimate": ["run", "sod-3d", "--dry-run", "--cells", 10, "--set", "ppc=2197"],
    "reference": ["run", "shear-decay", "--scheme", "york1997", "--set", "shape=linear", "--cells", 200],
    "measures": ["run", "woodward-colella", "--cells", 24],
}


def begun(plumbline, words):
    process = subprocess.Popen(plumbline.command(*words, "--json", "out.json"), cwd=plumbline.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(1.0)
    if process.poll() is not None:
        pytest.skip("over before the signal")
    return process


@pytest.mark.parametrize("name", SLOW)
def test_first_signal_ends_it_within_a_second(plumbline, name):
    process = begun(plumbline, SLOW[name])
    sent = time.monotonic()
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20)
    assert time.monotonic() - sent < 1.5, "a second, and what a busy machine adds"
    assert process.returncode == 130 and "interrupted" in said
    assert not os.path.exists(plumbline.folder / "out.json")


def test_second_signal_ends_it_at_once(plumbline):
    process = begun(plumbline, SLOW["set-up"])
    sent = time.monotonic()
    process.send_signal(signal.SIGINT)
    process.send_signal(signal.SIGTERM)
    process.communicate(timeout=20)
    assert time.monotonic() - sent < 0.5
    assert process.returncode in (130, 143, -signal.SIGTERM, -signal.SIGINT)


# --- output -------------------------------------------------------------------------------------------------------------------

PRINTING = {
    "run": ["run", "sod", "--cells", 10],
    "verify": ["verify", "spring-mass"],
    "reference": ["reference", "riemann", "--json", "-"],
    "list": ["list"],
    "help": ["--help"],
    "plan": ["sweep", "sod", "--plan", "-"],
}


@pytest.mark.parametrize("name", PRINTING)
def test_output_that_is_lost_is_an_error(plumbline, name):
    with open("/dev/full", "w", encoding="ascii") as full:
        process = subprocess.run(plumbline.command(*PRINTING[name]), cwd=plumbline.folder, stdin=subprocess.DEVNULL, stdout=full,
                                 stderr=subprocess.PIPE, text=True, timeout=120)
    assert process.returncode == 4 and "No space left on device" in process.stderr


def test_closed_standard_output(plumbline):
    """Nothing else becomes standard output, and what is lost is told."""
    command = " ".join(plumbline.command("run", "sod", "--cells", 10)) + " >&-"
    process = subprocess.run(["/bin/sh", "-c", command], cwd=plumbline.folder, stderr=subprocess.PIPE, text=True, timeout=120)
    assert process.returncode == 4 and "standard output" in process.stderr
    (file,) = [name for name in plumbline.files() if name.endswith(".h5")]
    with h5py.File(plumbline.folder / "results" / file) as stored:
        assert stored.attrs["plumbline_format"] == 2


def test_reader_that_leaves_ends_it_quietly(plumbline):
    command = " ".join(plumbline.command("list")) + " | head -1 >/dev/null; exit ${PIPESTATUS[0]}"
    process = subprocess.run(["/bin/bash", "-c", command], cwd=plumbline.folder, stderr=subprocess.PIPE, text=True, timeout=120)
    assert process.returncode in (0, 141) and process.stderr == ""


@pytest.mark.parametrize("option", ["--json", "--junit"])
def test_files_that_cannot_be_written_are_known_before_the_work(plumbline, option):
    result = plumbline("verify", "spring-mass", option, "none/x.json")
    assert result.code == 4 and "none/x.json" in result.err and plumbline.files() == []


def test_json_is_utf8_whatever_is_quoted(plumbline):
    _, start = exported(plumbline, "sod", "--cells", 20)
    path = hand_in(plumbline, start)
    with h5py.File(path, "r+") as file:
        del file.attrs["version"]
        file.attrs.create("version", b"\xff\xfe", dtype=h5py.string_dtype("utf-8", 2))
    result = plumbline("score", "sod", "--result", path.name, json=True)
    assert result.code == 1 and result.json("score")["version"] == "\ufffd\ufffd"


@pytest.mark.parametrize("more", [(), ("--dry-run",)])
def test_an_end_that_no_run_reaches_is_refused(plumbline, more):
    """Of two bars at a speed of 5e-324 m/s, whose end is that of their meeting."""
    result = plumbline("run", "two-bar", "--set", "speed=5e-324", *more, json=True, timeout=20)
    error = result.json("error")["error"]
    assert result.code == 2 and error["key"] == "end time" and error["value"] == "inf" and plumbline.files() == []


# --- calls that contradict themselves -------------------------------------------------------------------------------------------

@pytest.mark.parametrize("key, arguments", [
    ("integrator", ("run", "sod", "--set", "integrator=usl", "--integrator", "musl")),
    ("cells", ("run", "sod", "--cells", 10, "--set", "cells=20")),
    ("gamma", ("run", "sod", "--set", "gamma=1.5", "--set", "gamma=1.6")),
    ("dt", ("run", "sod", "--set", "dt=1e-4", "--set", "cfl=0.5")),
    ("--json", ("run", "sod", "--json", "")),
    ("--results", ("run", "sod", "--results", "")),
    ("--cells", ("run", "sod", "--cells", "1e3", "--json", "-")),
    ("--cells", ("converge", "sod", "--cells", "", "--json", "-")),
    ("--cells", ("converge", "sod", "--cells", "10,10", "--json", "-")),
    ("--points", ("bench", "--points", "nan", "--json", "-")),
    ("split", ("run", "lax", "--cells", 10, "--set", "split=5e-324")),
    ("split", ("run", "lax", "--cells", 10, "--set", "split=1e-3")),
])
def test_a_call_that_contradicts_itself_is_refused_by_key(plumbline, key, arguments):
    result = plumbline(*arguments, timeout=20)
    assert result.code == 2 and key in result.err
    if "-" in arguments:
        assert result.json("error")["error"]["key"] == key


# --- runs that say nothing --------------------------------------------------------------------------------------------------------

def test_step_far_above_every_limit_is_said(plumbline):
    result = plumbline("run", "piston-shock", "--cells", 3, "--set", "cfl=50")
    assert result.code == 1 and "INCONCLUSIVE" in result.out and "far above every limit" in result.out


def test_errors_larger_than_what_was_computed_are_red(plumbline):
    result = plumbline("run", "bar-riemann", "--cells", 10, "--set", "dt=1.0")
    assert result.code in (1, 3) and ("run/errors" in result.out or "STOPPED" in result.out)
    if result.code == 1:
        assert "FAIL" in result.out


# --- files of others ---------------------------------------------------------------------------------------------------------------

def test_a_file_that_says_another_size_than_it_holds(plumbline):
    _, start = exported(plumbline, "sod", "--cells", 20)
    path = hand_in(plumbline, start, attributes={"cells": 24})
    result = plumbline("score", "sod", "--result", path.name, json=True)
    assert result.code == 2 and "24 cells" in result.json("error")["error"]["message"]


def test_a_size_without_content_is_refused_before_it_is_read(plumbline):
    _, start = exported(plumbline, "sod", "--cells", 20)
    path = hand_in(plumbline, start)
    with h5py.File(path, "r+") as file:
        for name in list(file["bodies/gas"]):
            shape = (2**25,) + file["bodies/gas"][name].shape[1:]
            del file["bodies/gas"][name]
            file.create_dataset(f"bodies/gas/{name}", shape, dtype="f8", chunks=(2**16,) + shape[1:], fillvalue=1.0)
    assert os.path.getsize(path) < 1e6
    began = time.monotonic()
    result = plumbline("score", "sod", "--result", path.name, timeout=60)
    assert result.code == 4 and "more than what is stored" in result.err
    assert time.monotonic() - began < 2
    assert resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss < 2e6, "kB"
