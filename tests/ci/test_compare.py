"""ci/compare: what it runs in which order, and the exit status it ends with. Both programs are fakes that log."""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "ci/compare"
FAKE = '''#!{python}
import json, pathlib, sys
words, folder = sys.argv[1:], pathlib.Path({folder!r})
with (folder / "log").open("a") as log:
    print({side!r}, *words, file=log)
behave = json.loads((folder / "behave.json").read_text())
after = lambda name: words[words.index(name) + 1]
if words[0] == "list":
    print(json.dumps({{"cases": [{{"name": name}} for name in behave["cases"][{side!r}]]}}))
if words[0] == "bench":
    calls = (folder / "log").read_text().count({side!r} + " bench")
    pathlib.Path(after("--json")).write_text(json.dumps({{"machine": {{}}, "runs": [{{"case": "sod", "scheme": scheme, "study": "cells",
        "vary": "cells", "value": cells, "cells": cells, "wall_s": [calls], "instructions": None}}
        for scheme in behave["schemes"] for cells in (100, 50)]}}))
if words[0] == "diff":
    calls = (folder / "log").read_text().count("head diff")
    change = "inconclusive" if calls < behave["settled"] else "same"
    pathlib.Path(after("--json")).write_text(json.dumps({{"findings": [{{"kind": "cost", "change": change}}]}}))
sys.exit(behave["status"].get(words[0], 0))
'''


class Pair:
    def __init__(self, folder):
        self.folder = folder
        self.behave = {"cases": {"base": ["sod", "lax"], "head": ["sod", "lax"]}, "status": {}, "settled": 0, "schemes": ["default"]}
        for side in ("base", "head"):
            executable = folder / side / "bin/plumbline"
            executable.parent.mkdir(parents=True)
            executable.write_text(FAKE.format(python=sys.executable, folder=str(folder), side=side))
            executable.chmod(0o755)

    def run(self, *options, **more):
        (self.folder / "behave.json").write_text(json.dumps(self.behave))
        return subprocess.run([sys.executable, str(SCRIPT), "--builds", str(self.folder / "base"), str(self.folder / "head"),
                               "--output", str(self.folder / "out"), *options], capture_output=True, text=True, timeout=60,
                              env={**os.environ, **more})

    def calls(self):
        return (self.folder / "log").read_text().splitlines()

    def cost(self, side):
        return json.loads((self.folder / "out" / side / "cost.json").read_text())["runs"][0]["wall_s"]


@pytest.fixture
def pair(tmp_path):
    return Pair(tmp_path)


def test_both_are_verified_timed_in_turns_and_compared(pair):
    result = pair.run("sod", "--rounds", "4")
    assert result.returncode == 0, result.stderr
    kinds = [" ".join(call.split()[:2]) for call in pair.calls()]
    assert kinds[:4] == ["base list", "head list", "base verify", "head verify"]
    assert [kind for kind in kinds if kind.endswith("bench")] == [f"{side} bench" for side in "base head head base base head head base".split()]
    assert kinds[-1] == "head diff", "the newer program judges"
    assert all("verify sod --tier quick" in call for call in pair.calls() if " verify " in call)
    assert pair.cost("base") == pair.cost("head") == [1, 2, 3, 4]


def test_times_are_taken_for_as_long_as_they_say_nothing(pair):
    pair.behave["settled"] = 3
    assert pair.run("--rounds", "4", "--most-rounds", "30").returncode == 0
    assert len(pair.cost("base")) == 12
    pair.behave["settled"] = 99
    pair.run("--rounds", "4", "--most-rounds", "6")
    assert len(pair.cost("base")) == 6


def fake(path, script):
    path.parent.mkdir(exist_ok=True)
    path.write_text(f"#!/bin/sh\n{script}\n")
    path.chmod(0o755)
    return path


@pytest.fixture
def valgrind(pair):
    """A PATH with one that has always counted the same."""
    tool = fake(pair.folder / "tools/valgrind", f'echo "$@" >> {pair.folder}/counted\necho "==1== Collected : 1234" >&2')
    return f"{tool.parent}:{os.environ['PATH']}"


@pytest.fixture
def python(pair):
    """The interpreter that the build knows fails."""
    python = fake(pair.folder / "head/python", f'echo "$@" > {pair.folder}/rendered\nexit 3')
    (pair.folder / "head/CMakeCache.txt").write_text(f"Python3_EXECUTABLE:FILEPATH={python}\n")


def test_instructions_of_every_scheme_and_integrator_are_counted_on_the_coarsest_level(pair, valgrind):
    pair.behave["schemes"] = ["york1997", "default+musl"]
    assert pair.run("--rounds", "4", "--instructions", "--jobs", "1", PATH=valgrind).returncode == 0
    counted = [line.split(" run ")[1].split(" --results")[0] for line in (pair.folder / "counted").read_text().splitlines()]
    assert counted == ["sod --scheme york1997 --cells 50", "sod --integrator musl --cells 50"] * 2
    runs = json.loads((pair.folder / "out/head/cost.json").read_text())["runs"]
    assert [run["instructions"] for run in runs] == [None, 1234] * 2


def test_page_is_rendered_by_the_python_of_the_build_and_leaves_the_verdict(pair, python):
    pair.behave["status"]["diff"] = 1
    result = pair.run("--rounds", "0", "--page")
    assert result.returncode == 1 and "no page (exit status 3)" in result.stdout
    assert (pair.folder / "rendered").read_text().split()[1:] == [str(pair.folder / "out" / word) if word[0] != "-" else word
                                                                   for word in ("head", "index.html", "--single-file", "--baseline", "base")]


@pytest.mark.parametrize("status", [0, 1, 4])
def test_exit_status_is_that_of_diff(pair, status):
    pair.behave["status"]["diff"] = status
    assert pair.run("--rounds", "0").returncode == status
    assert not any(" bench " in call for call in pair.calls())


def test_red_verdicts_are_compared_but_a_failed_call_is_not(pair):
    pair.behave["status"]["verify"] = 3
    assert pair.run("--rounds", "0").returncode == 0
    pair.behave["status"]["verify"] = 139
    assert pair.run("--rounds", "0").returncode == 139


def test_case_that_one_side_lacks_is_no_wrong_call(pair):
    pair.behave["cases"]["head"].append("new-case")
    assert pair.run("new-*").returncode == 0
    assert not any(call.startswith("base verify") for call in pair.calls())
    assert pair.run("no-such-*").returncode == 2


def test_program_without_costs_is_compared_all_the_same(pair):
    pair.behave["status"]["bench"] = 2
    result = pair.run()
    assert result.returncode == 0 and "no costs" in result.stdout and pair.calls()[-1].startswith("head diff")


def test_results_of_an_earlier_comparison_do_not_pass_for_these(pair):
    stale = pair.folder / "out/base/study-old.h5"
    stale.parent.mkdir(parents=True)
    stale.write_text("old")
    assert pair.run("--rounds", "0").returncode == 0 and not stale.exists()


@pytest.mark.parametrize("options, words", [(["--rounds", "2"], "needs 4"), (["--allow", "worse"], "invalid choice")])
def test_wrong_options(pair, options, words):
    result = pair.run(*options)
    assert result.returncode == 2 and words in result.stderr


def test_workflow_gives_options_that_there_are(pair, valgrind, python):
    workflow = (SCRIPT.parent.parent / ".github/workflows/compare.yml").read_text(encoding="utf-8")
    (options,) = re.findall(r"ci/compare \$\{\{ github.event.pull_request.base.sha \}\} HEAD (.*)", workflow)
    result = pair.run(*options.split(), PATH=valgrind)
    assert result.returncode == 0 and (pair.folder / "counted").exists() and (pair.folder / "rendered").exists(), result.stderr
    assert pair.calls()[-1].endswith("--allow inconclusive"), "times scatter on shared machines"
    assert "fetch-depth: 0" in workflow and "ci/setup --with compare" in workflow


def test_wrong_revision_and_build(tmp_path):
    def run(*words):
        return subprocess.run([sys.executable, str(SCRIPT), *words], capture_output=True, text=True, timeout=60)
    assert run().returncode == 2
    result = run("--builds", str(tmp_path), str(tmp_path), "--output", str(tmp_path / "out"))
    assert result.returncode == 2 and "bin/plumbline" in result.stderr
    if shutil.which("git"):
        result = run("no-such-revision", "--output", str(tmp_path / "out"))
        assert result.returncode == 2 and "no-such-revision" in result.stderr
