"""The workflow for a plug-in's own repository: it is one, and all that it calls exists. test_installation.py runs it."""
import json
import re

import pytest
import yaml
from contract import ROOT

FILE = ROOT / "tests/contract/plugin/judge.yml"


@pytest.fixture(scope="module")
def workflow():
    return yaml.safe_load(FILE.read_text(encoding="utf-8"))


@pytest.fixture(scope="module")
def steps(workflow):
    return workflow["jobs"]["judge"]["steps"]


@pytest.fixture(scope="module")
def commands(steps):
    return "".join(step["run"] + "\n" for step in steps if "run" in step)


def test_it_is_a_workflow(workflow, steps):
    assert set(workflow) == {"name", True, "permissions", "env", "jobs"}   # YAML reads the key `on` as true
    assert set(workflow[True]) == {"push", "pull_request"} and workflow["permissions"] == {"contents": "read"}
    assert all(("uses" in step) != ("run" in step) for step in steps)
    assert set().union(*steps) <= {"name", "uses", "run", "with", "if", "working-directory"}


def test_what_it_names_is_there(workflow, commands):
    text = FILE.read_text(encoding="utf-8")
    used = set(re.findall(r"\$\{\{ env\.(\w+) \}\}", text)) | set(re.findall(r"\$(?!PWD)(\w+)", commands))
    assert used == set(workflow["env"])
    presets = [preset["name"] for preset in json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["configurePresets"]]
    assert set(re.findall(r"--preset (\S+)", commands)) <= set(presets)
    assert "run: ci/setup\n" in text and (ROOT / "ci/setup").is_file()
    assert (ROOT / "reports" / re.search(r"plumbline/reports/(\S+)", commands)[1]).is_file()
    assert "share/plumbline/reports" in commands and "DATADIR}/plumbline/reports" in (ROOT / "reports/CMakeLists.txt").read_text()


def test_its_library_is_the_one_of_the_cmake_side(workflow):
    cmake = (FILE.parent / "CMakeLists.txt").read_text(encoding="utf-8")
    name = re.search(r"add_library\((\w+) MODULE", cmake)[1]
    assert workflow["env"]["LIBRARY"] == f"build/lib{name}.so"


def test_the_options_are_those_of_the_command(plumbline, commands):
    (call,) = re.findall(r"bin/plumbline verify (.*)", commands)
    asked = plumbline("verify", "--help").out
    options = re.findall(r"(?<!\S)--[\w-]+", call)
    assert {"--integrator", "--plugin", "--json"} <= set(options)
    assert [option for option in options if not re.search(rf"^  {option} ", asked, re.MULTILINE)] == []
    assert "|| true" not in commands, "the exit status decides"


def test_card_and_json_are_kept_also_where_a_gate_is_red(steps):
    judge = next(k for k, step in enumerate(steps) if "plumbline verify" in step.get("run", ""))
    assert len(steps) == judge + 3 and all(step["if"] == "always()" for step in steps[judge + 1 :])
    assert steps[-1]["uses"].startswith("actions/upload-artifact@") and steps[-1]["with"]["path"] == "judged"
