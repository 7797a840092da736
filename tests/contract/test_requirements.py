"""reports/requirements.json against the gates that the cases declare and the equations of the code: nothing unproven, nothing unowned."""
import importlib
import json
import subprocess
import sys

import pytest
from contract import ROOT

sys.path.insert(0, str(ROOT / "reports"))
trust = importlib.import_module("trust")


@pytest.fixture(scope="module")
def gates(tmp_path_factory):
    """(case, gate) of every case: those that it declares, and those that stand on each of its studies."""
    from contract import Plumbline
    plumbline = Plumbline(tmp_path_factory.mktemp("requirements"))
    found = set()
    for case in plumbline("list", json=True).json()["cases"]:
        entry = plumbline("explain", case["name"], json=True).json()
        found |= {(case["name"], gate["id"]) for gate in entry["gates"]}
        for study in entry["studies"]:
            found |= {(case["name"], f"{study['id']}/{name}") for name in ("finite", "mass", "momentum", "ledger")}
    return found


@pytest.fixture(scope="module")
def tags(tmp_path_factory):
    file = tmp_path_factory.mktemp("equations") / "equations.json"
    subprocess.run([sys.executable, ROOT / "ci/check_equations", "--json", file], check=True, stdout=subprocess.DEVNULL)
    return [row["tag"] for row in json.loads(file.read_text())["equations"]]


def test_every_requirement_has_evidence_and_every_gate_a_requirement(gates, tags):
    # The angular momentum is gated on runs that have one, which only a run tells: one stands for all.
    gates = gates | {("spinning-disk", "default/angular-momentum")}
    assert trust.faults(trust.load_requirements(), gates, tags, lambda name: (ROOT / name).is_file()) == []


def test_requirements_are_sentences():
    for entry in trust.load_requirements():
        assert " shall " in entry["requirement"] and entry["requirement"].endswith(".") and entry["source"]
        assert set(entry) == {"id", "requirement", "source", "gates", "equations", "tests"}


def test_a_gate_without_requirement_is_found(gates, tags):
    assert trust.faults(trust.load_requirements(), gates | {("sod", "default/surprise")}, tags) != []
