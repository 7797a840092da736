"""The tolerance ledger of the repository says what the executable declares; a gate that is widened is red until it does."""
import json

import pytest
from contract import ROOT, validate

LEDGER = ROOT / "cases/tolerances.json"


@pytest.fixture
def copied(plumbline):
    """A copy of the ledger that a test may change: its lines, and a function that writes them."""
    ledger = json.loads(LEDGER.read_text(encoding="utf-8"))

    def write():
        (plumbline.folder / "ledger.json").write_text(json.dumps(ledger), encoding="utf-8")
    return ledger["gates"], write


def test_committed_ledger_says_what_is_declared(plumbline):
    result = plumbline("tolerances", LEDGER, json=True)
    assert result.code == 0, "\n".join(entry["message"] for entry in result.json()["discrepancies"])
    assert result.json()["recorded"] == result.json()["declared"] > 500


def test_ledger_lists_every_gate_of_every_case(plumbline):
    recorded = {(line["case"], line["study"], line["id"]) for line in json.loads(LEDGER.read_text(encoding="utf-8"))["gates"]}
    for case in plumbline("list", json=True).json()["cases"]:
        for gate in plumbline("explain", case["name"], json=True).json()["gates"]:
            assert (case["name"], gate["study"], gate["id"]) in recorded


def test_committed_ledger_is_as_the_command_writes_it(plumbline):
    copy = plumbline.folder / "ledger.json"
    copy.write_bytes(LEDGER.read_bytes())
    assert plumbline("tolerances", "ledger.json", "--update").code == 0
    assert copy.read_bytes() == LEDGER.read_bytes()


def test_widened_gate_is_red_until_it_says_why(plumbline, copied):
    lines, write = copied
    line = next(line for line in lines if line["high"] and not line.get("band"))
    line["high"] *= 0.99   # what is declared is now wider than the ledger
    write()
    result = plumbline("tolerances", "ledger.json", json=True)
    (entry,) = result.json()["discrepancies"]
    assert result.code == 1 and entry["kind"] == "widened" and (entry["case"], entry["id"]) == (line["case"], line["id"])
    assert "became" in entry["message"] and "--why" in entry["message"]
    before = (plumbline.folder / "ledger.json").read_bytes()
    refused = plumbline("tolerances", "ledger.json", "--update")
    assert refused.code == 2 and line["id"] in refused.err and (plumbline.folder / "ledger.json").read_bytes() == before
    assert plumbline("tolerances", "ledger.json", "--update", "--why", "the reference is only so good").code == 0
    (widened,) = [found for found in plumbline("tolerances", "ledger.json", json=True).json()["widened"]
                  if (found["case"], found["id"]) == (line["case"], line["id"])]
    assert widened["widened"]["why"] == "the reference is only so good" and widened["widened"]["from"]["high"] == line["high"]


def test_line_widened_by_hand_is_found_against_an_earlier_ledger(plumbline, copied):
    lines, write = copied
    line = next(line for line in lines if line["high"] and not line.get("band"))
    line["high"] *= 0.99
    write()
    assert plumbline("tolerances", LEDGER, "--against", "ledger.json").code == 1
    assert plumbline("tolerances", LEDGER, "--against", LEDGER).code == 0


def test_narrowed_new_and_removed_gates_are_to_be_recorded(plumbline, copied):
    lines, write = copied
    narrowed = next(line for line in lines if line["high"] and not line.get("band"))
    narrowed["high"] *= 1.01
    gone = lines.pop()
    lines.append({**gone, "id": "no-such-gate"})
    write()
    result = plumbline("tolerances", "ledger.json", json=True)
    assert result.code == 1
    assert sorted(entry["kind"] for entry in result.json()["discrepancies"]) == ["narrowed", "new", "removed"]
    assert plumbline("tolerances", "ledger.json", "--update").code == 0
    assert plumbline("tolerances", "ledger.json").code == 0


def test_wrong_calls_and_files(plumbline):
    assert plumbline("tolerances", "none.json").code == 4
    assert plumbline("tolerances", LEDGER, "--why", "x").code == 2
    (plumbline.folder / "damaged.json").write_text("{")
    result = plumbline("tolerances", "damaged.json", json=True)
    assert result.code == 4
    validate("error", json.loads(result.out))


def test_values_are_recorded_kept_and_moved_with_a_reason(plumbline):
    (plumbline.folder / "tolerances.json").write_bytes(LEDGER.read_bytes())
    plumbline("verify", "normals-cell", "--json", "judged.json")
    judged = json.loads((plumbline.folder / "judged.json").read_text(encoding="utf-8"))

    def record(*more):
        (plumbline.folder / "judged.json").write_text(json.dumps(judged), encoding="utf-8")
        return plumbline("tolerances", "tolerances.json", "--record", "judged.json", *more, json=True)

    result = record()
    document = result.json()
    validate("tolerances", document)
    assert result.code == 1 and document["values"] > document["ranges"] > 10
    missing = [entry for entry in document["discrepancies"] if entry["case"] == "sod"]
    assert missing and all(entry["kind"] == "unrecorded" for entry in missing)
    assert "plumbline verify sod --json judged.json" in missing[0]["message"] and "--record judged.json" in missing[0]["message"]
    assert not [entry for entry in document["discrepancies"] if entry["case"] == "normals-cell"]
    file = plumbline.folder / "regressions.json"
    before = file.read_bytes()
    line = next(line for line in json.loads(before)["recorded"] if "low" in line and 0 < 8 * line["low"] < line["high"])
    gate = next(gate for gate in judged["gates"] if gate["id"] == line["id"])
    gate["measured"] *= 1.5
    assert record().code == 1 and file.read_bytes() == before, "a value within its range keeps its line"
    for moved in (10, 0.1):
        gate["measured"] = moved * line["measured"]
        refused = record()
        assert refused.code == 2 and line["id"] in refused.json("error")["error"]["message"] and file.read_bytes() == before
    assert record("--why", "the boxes are narrower").code == 1
    (now,) = [entry for entry in json.loads(file.read_bytes())["recorded"] if entry["id"] == line["id"]]
    assert now["measured"] == gate["measured"] and now["moved"]["why"] == "the boxes are narrower"


def test_runs_with_other_settings_are_not_recorded(plumbline):
    (plumbline.folder / "tolerances.json").write_bytes(LEDGER.read_bytes())
    result = plumbline("verify", "cell-crossing", "--set", "ppc=3", "--json", "judged.json")
    assert json.loads((plumbline.folder / "judged.json").read_text(encoding="utf-8"))["regressions"] == 0, result.out
    refused = plumbline("tolerances", "tolerances.json", "--record", "judged.json")
    assert refused.code == 2 and "--set" in refused.err and not (plumbline.folder / "regressions.json").exists()


def test_bands_wider_than_the_rule_need_an_ensemble(plumbline):
    (plumbline.folder / "tolerances.json").write_bytes(LEDGER.read_bytes())
    document = json.loads((LEDGER.parent / "ensembles.json").read_text(encoding="utf-8"))
    left_out = document["ensembles"].pop()
    (plumbline.folder / "ensembles.json").write_text(json.dumps(document), encoding="utf-8")
    result = plumbline("tolerances", "tolerances.json", json=True)
    validate("tolerances", result.json())
    (wide,) = [entry for entry in result.json()["discrepancies"] if entry["kind"] == "wide"]
    assert result.code == 1 and (wide["case"], wide["id"]) == (left_out["case"], left_out["id"]) and "a factor 1.35" in wide["message"]
