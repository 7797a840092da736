"""`export` and `score`: what the files hold, and every way in which a handed-in file can be wrong."""
import json
import os
import subprocess
import sys

import h5py
import numpy
import pytest
from contract import ROOT, Plumbline, exported, hand_in, rows_left, validate


def replaced(dataset, values):
    def change(file):
        old = file[f"bodies/gas/{dataset}"][()]
        del file[f"bodies/gas/{dataset}"]
        new = values(old)
        if new is not None:
            file[f"bodies/gas/{dataset}"] = new
    return change


def put(value, row=3):
    def values(old):
        old[row] = value
        return old
    return values


def test_export_writes_the_same_description_beside_and_inside(plumbline):
    description, path = exported(plumbline, "sod", "--cells", "20")
    assert json.loads(path.with_suffix(".json").read_text()) == description
    with h5py.File(path) as file:
        assert json.loads(file["description"].asstr()[()]) == description
        assert dict(file.attrs).keys() == {"exchange_format", "kind", "case", "problem", "start", "cells", "end_time"}
        body = description["bodies"][0]
        assert set(file["bodies/gas"]) == set(body["datasets"])
        for name, about in body["datasets"].items():
            assert list(file[f"bodies/gas/{name}"].shape) == about["shape"]
        mass, volume = file["bodies/gas/mass"][()], file["bodies/gas/volume"][()]
    # Sums over the points are the integrals: a tube of 1 m, half of it 1 kg/m^3, half 0.125.
    assert mass.sum() == pytest.approx(0.5625, rel=1e-14) and volume.sum() == pytest.approx(1, rel=1e-14)
    assert body["material"]["parameters"]["gamma"] == {"value": 1.4, "unit": "1"}
    assert description["grid"]["walls"] == {"x": ["symmetry", "symmetry"]}
    norm = {"name": "density.L1", "unit": "kg/m^3", "norm": "sum_p V_p |e_p| / sum_p V_p"}
    assert description["scored"] and norm in description["measures"]
    assert sorted(plumbline.files(".")) == ["start.h5", "start.json"]


def test_same_export_twice_is_the_same_file(plumbline):
    first, second = (exported(plumbline, "sod", "--cells", "20", output=name)[1] for name in ("a.h5", "b.h5"))
    assert first.read_bytes() == second.read_bytes()


@pytest.mark.parametrize("case, arguments, body, dataset, components", [
    ("bar-riemann", (), "bar", "stress", None),
    ("mms-vortex", ("--cells", "8"), "ring", "deformation", ["xx", "xy", "yx", "yy"]),
    ("spring-mass", (), None, "strain", None),
    ("piston-shock", (), "gas", "pressure", None),
    ("airbag-200", (), None, "rest_length", None),
])
def test_every_kind_of_scene_is_exported(plumbline, case, arguments, body, dataset, components):
    description, path = exported(plumbline, case, *arguments)
    bodies = {b["name"]: b for b in description["bodies"]}
    holder = next(b for b in bodies.values() if dataset in b["datasets"]) if body not in bodies else bodies[body]
    assert holder["datasets"][dataset].get("components") == components
    for name, about in ((name, about) for b in bodies.values() for name, about in b["datasets"].items() if "components" in about):
        assert len(about["components"]) == about["shape"][1], name
    if case == "mms-vortex":
        assert holder["load"]["kind"] == "table"
        with h5py.File(path) as file:
            assert file[holder["group"]]["load/acceleration"].shape == (201, 2 * holder["points"])
    if case == "piston-shock":
        assert len(description["pistons"]) == 1
    if case == "spring-mass":
        assert holder["segments"]["shape"][1] == 2 and not description["scored"]
        assert description["why_not_scored"] and description["measures"] == []


def test_what_is_handed_in_is_judged_as_it_is(plumbline):
    _, start = exported(plumbline, "sod", "--cells", "20")
    results = {}
    for name, dataset in (("plain", None), ("pressure", "pressure"), ("energy", "energy")):
        change = replaced(dataset, lambda old: 2 * old) if dataset else None
        path = hand_in(plumbline, start, f"{name}.h5", change=change)
        document = plumbline("score", "sod", "--result", path.name, json=True).json("score")
        results[name] = {key: m["error"] for key, m in document["levels"][0]["measures"].items()}
    assert document["scheme"] == "foreign:a_b_c" and document["version"] == "1.2" and document["study"] == "default"
    moved = {name: {key for key in results["plain"] if results[name][key] != results["plain"][key]} for name in results}
    assert moved["pressure"] == {f"pressure.{norm}" for norm in ("L1", "L2", "Linf")}
    assert moved["energy"] == {f"energy.{norm}" for norm in ("L1", "L2", "Linf")}


@pytest.mark.parametrize("left_out", ["density", "volume", "energy", "pressure"])
def test_one_of_two_is_enough(plumbline, left_out):
    _, start = exported(plumbline, "sod", "--cells", "20")
    whole = hand_in(plumbline, start, "whole.h5")
    part = hand_in(plumbline, start, "part.h5", change=replaced(left_out, lambda old: None))
    a, b = (plumbline("score", "sod", "--result", path.name, json=True).json("score")["levels"][0]["measures"] for path in (whole, part))
    for name in a:
        assert a[name]["error"] == pytest.approx(b[name]["error"], rel=1e-12), name


WRONG_FILES = [
    ("density", lambda old: None, {}, "volume", ["/bodies/gas/density is missing, and so is volume"]),
    ("mass", lambda old: None, {}, None, ["/bodies/gas/mass is missing", "holds", "position"]),
    ("mass", lambda old: old[:-1], {}, None, ["/bodies/gas/mass", "shape"]),
    ("velocity", lambda old: numpy.hstack([old, old]), {}, None, ["/bodies/gas/velocity", "shape", "2)"]),
    ("velocity", put(numpy.nan), {}, None, ["/bodies/gas/velocity is nan in row 3"]),
    ("position", put(numpy.inf), {}, None, ["/bodies/gas/position is inf in row 3"]),
    ("mass", put(-1.0), {}, None, ["/bodies/gas/mass is -1 in row 3", "> 0"]),
    ("density", put(0.0), {}, None, ["/bodies/gas/density is 0 in row 3", "> 0"]),
    ("energy", put(-1e-9), {}, None, ["/bodies/gas/energy is -1e-09 in row 3", ">= 0"]),
    ("mass", lambda old: old.astype("S8"), {}, None, ["/bodies/gas/mass does not hold numbers"]),
    ("mass", lambda old: old.reshape(-1, 1, 1), {}, None, ["/bodies/gas/mass has 3 dimensions"]),
    ("position", lambda old: old[:0], {}, None, ["/bodies/gas/position has no rows"]),
    (None, None, {"exchange_format": 2}, None, ["exchange_format is 2", "reads 1"]),
    (None, None, {"kind": "initial-state"}, None, ["kind is initial-state", "final-state"]),
    (None, None, {"time": None}, None, ["the attribute time is missing"]),
    (None, None, {"cells": 20.5}, None, ["cells is 20.5"]),
    (None, None, {"cells": "many"}, None, ["cells is not one number"]),
    (None, None, {"steps": -1}, None, ["steps is -1"]),
]


@pytest.mark.parametrize("dataset, values, attributes, also, said", WRONG_FILES)
def test_file_that_is_wrong_is_named(plumbline, dataset, values, attributes, also, said):
    _, start = exported(plumbline, "sod", "--cells", "20")

    def change(file):
        if dataset:
            replaced(dataset, values)(file)
        if also:
            del file[f"bodies/gas/{also}"]
    path = hand_in(plumbline, start, change=change, attributes=attributes)
    result = plumbline("score", "sod", "--result", path.name, json=True)
    assert result.code == 4, result.text
    for words in ["result.h5", *said]:
        assert words in result.err, result.err
    result.json("error")
    assert [name for name in plumbline.files() if name.endswith(".h5")] == []


@pytest.mark.parametrize("attributes, arguments, said", [
    ({"case": "lax"}, (), ["case is lax", "sod is wanted"]),
    ({"time": 0.1}, (), ["time is 0.1", "0.143 s is wanted"]),
    ({}, ("--set", "gamma=1.5"), ["problem is"]),
])
def test_file_of_another_problem_is_a_wrong_call(plumbline, attributes, arguments, said):
    _, start = exported(plumbline, "sod", "--cells", "20")
    path = hand_in(plumbline, start, attributes=attributes)
    result = plumbline("score", "sod", "--result", path.name, *arguments)
    assert result.code == 2, result.text
    for words in said:
        assert words in result.err, result.err


def test_series_takes_each_mesh_once_of_one_program(plumbline):
    _, start = exported(plumbline, "sod", "--cells", "20")
    first, again = hand_in(plumbline, start, "a.h5"), hand_in(plumbline, start, "b.h5")
    result = plumbline("score", "sod", "--result", first.name, "--result", again.name)
    assert result.code == 2 and "each mesh once" in result.err
    other = hand_in(plumbline, start, "c.h5", attributes={"cells": 40, "program": "another"})
    result = plumbline("score", "sod", "--result", first.name, "--result", other.name)
    assert result.code == 2 and "another" in result.err


def test_lost_mass_and_space_are_red_by_name(plumbline):
    _, start = exported(plumbline, "sod", "--cells", "20")
    for name, change, wanted in (("whole", None, ("PASS", "PASS")), ("lost", rows_left("gas", slice(-2)), ("FAIL", "FAIL")),
                                 ("dense", replaced("density", lambda old: 1.03 * old), ("PASS", "FAIL"))):
        path = hand_in(plumbline, start, f"{name}.h5", change=change)
        result = plumbline("score", "sod", "--result", path.name, json=True)
        gates = {gate["id"]: gate["verdict"] for gate in result.json("score")["gates"]}
        assert (gates["default/foreign-mass"], gates["default/foreign-coverage"]) == wanted, name


def test_gates_that_say_nothing_of_another_program_are_listed_with_the_reason(plumbline):
    arguments = []
    for cells in (100, 400):
        _, start = exported(plumbline, "sod", "--cells", cells)
        arguments += ["--result", hand_in(plumbline, start, f"{cells}.h5").name]
    document = plumbline("score", "sod", *arguments, json=True).json("score")
    judged = {gate["id"]: gate["verdict"] for gate in document["gates"]}
    left_out = {gate["id"]: gate["reason"] for gate in document["not_judged"]}
    assert not judged.keys() & left_out.keys()
    assert judged["default/density-100"] == "FAIL" and judged["default/order"] == "INCONCLUSIVE"
    gate = next(gate for gate in document["gates"] if gate["id"] == "default/order")
    assert gate["expected"]["low"] == 0.4 and gate["origin"] == "theory", "what is required of Plumbline's own scheme binds nobody else"
    assert "a run of Plumbline's own scheme" in left_out["default/density-400"]
    assert "expected to miss" in left_out["default/comparator-density-100"]
    assert "ledger" in left_out["default/drift"]
    assert "1600 cells" in left_out["default/density-1600"]
    assert "pushes" in left_out["default/foreign-momentum"]


def verdict(plumbline, case, path):
    result = plumbline("score", case, "--result", path.name, json=True)
    return result, (result.json("score")["verdict"] if result.code in (0, 1) else None)


def scored_cases(plumbline):
    return [entry["name"] for entry in plumbline("list", json=True).json("list")["cases"] if entry["scored"]]


@pytest.fixture(scope="module")
def starts(tmp_path_factory):
    """{case: its start of twelve cells} of all cases that can be judged: the reference at the start is most of what a call takes."""
    plumbline, made = Plumbline(tmp_path_factory.mktemp("starts")), {}
    for case in scored_cases(plumbline):
        made[case] = exported(plumbline, case, "--cells", "12", output=f"{case}.h5")[1]
    return made


def test_the_start_handed_back_is_green_nowhere(plumbline, starts):
    assert len(starts) > 25
    for case, coarse in starts.items():
        for cells in (12, 24):
            start = coarse if cells == 12 else exported(plumbline, case, "--cells", cells)[1]
            result, said = verdict(plumbline, case, hand_in(plumbline, start))
            assert result.code == 1 and said in ("FAIL", "INVALID"), (case, cells, result.text)
            assert energy_verdict(result) == "PASS", (case, cells)


def energy_verdict(result):
    return next(gate["verdict"] for gate in result.json("score")["gates"] if gate["id"].endswith("/foreign-energy"))


def test_one_point_that_is_too_fast_is_seen_wherever_it_is(plumbline, starts):
    """Fields are judged where the reference is known; what no field shows is in the sum of all energies."""
    def fast(file):
        body = next(iter(file["bodies"].values()))
        body["velocity"][-1] = 1e200
    for case, start in starts.items():
        result, _ = verdict(plumbline, case, hand_in(plumbline, start, change=fast))
        assert result.code == 1 and energy_verdict(result) in ("FAIL", "INVALID"), (case, result.text)


@pytest.fixture(scope="module")
def right_result(tmp_path_factory):
    """A tube at its end by a program that is right, green: what is changed in it is what a gate sees."""
    plumbline = Plumbline(tmp_path_factory.mktemp("right"))
    _, start = exported(plumbline, "sod", "--cells", "90", "--set", "ppc=4")  # no gate asks for this mesh
    path = plumbline.folder / "right.h5"
    subprocess.run([sys.executable, ROOT / "tests/stranger/adapter.py", start, path], check=True)
    assert verdict(plumbline, "sod", path)[1] == "PASS"
    return path


@pytest.mark.parametrize("dataset, values, code", [
    ("position", put(-5.0), 4), ("position", put(1e9), 4), ("position", put(1e300), 4),
    ("velocity", put(1e200), 1), ("velocity", lambda old: 0 * old, 1), ("velocity", lambda old: -old, 1),
    ("pressure", lambda old: 1e-5 * old, 1), ("pressure", lambda old: 1e308 + 0 * old, 1), ("energy", lambda old: 1e3 * old, 1),
    ("density", lambda old: 1e-3 * old, 1), ("velocity", lambda old: 3.6 * old, 1),
])
def test_a_right_result_that_is_tampered_with_is_not_green(plumbline, right_result, dataset, values, code):
    path = plumbline.folder / "changed.h5"
    path.write_bytes(right_result.read_bytes())
    with h5py.File(path, "r+") as file:
        replaced(dataset, values)(file)
    result, said = verdict(plumbline, "sod", path)
    assert result.code == code and said in (None, "FAIL", "INVALID"), result.text


def test_solids_are_judged_particle_by_particle(plumbline):
    _, start = exported(plumbline, "bar-riemann", "--cells", "50")
    path = hand_in(plumbline, start, change=rows_left("bar", slice(1, None)))
    result = plumbline("score", "bar-riemann", "--result", path.name)
    assert result.code == 4 and "particle by particle" in result.err, result.text
    path = hand_in(plumbline, start)
    document = plumbline("score", "bar-riemann", "--result", path.name, json=True).json("score")
    names = set(document["levels"][0]["measures"])
    assert "displacement.L1" in names and not names & {"displacement.worst", "energy_rise", "energy_lost"}
    assert {gate["id"] for gate in document["not_judged"]} >= {"default/velocity.L1-order"}
    momentum = next(gate for gate in document["gates"] if gate["id"] == "default/foreign-momentum")
    assert momentum["verdict"] == "PASS"


@pytest.mark.parametrize("arguments, code, said", [
    (("export", "sodd", "--output", "a.h5"), 2, "sod"),
    (("export", "sod", "--output", "a.json"), 2, ".json"),
    (("export", "sod", "--output", "nowhere/a.h5"), 4, "nowhere/a.h5"),
    (("export", "sod"), 2, "--output"),
    (("score", "sod"), 2, "--result"),
    (("score", "sod", "--result", "nothing.h5"), 4, "nothing.h5"),
    (("score", "pendulum", "--result", "nothing.h5"), 2, "membranes"),
    (("score", "two-disks", "--result", "nothing.h5"), 2, "on the way"),
])
def test_wrong_calls(plumbline, arguments, code, said):
    result = plumbline(*arguments)
    assert result.code == code and said in result.err, result.text


def test_file_that_is_no_hdf5(plumbline):
    (plumbline.folder / "text.h5").write_text("no such thing")
    (plumbline.folder / "empty.h5").write_bytes(b"")
    _, start = exported(plumbline, "sod", "--cells", "20")
    whole = hand_in(plumbline, start).read_bytes()
    (plumbline.folder / "cut.h5").write_bytes(whole[: len(whole) // 2])
    for name in ("text.h5", "empty.h5", "cut.h5"):
        result = plumbline("score", "sod", "--result", name)
        assert result.code == 4 and name in result.err, result.text


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_folder_that_cannot_be_written_to(plumbline):
    plumbline.folder.chmod(0o500)
    result = plumbline("export", "sod", "--output", "a.h5")
    plumbline.folder.chmod(0o700)
    assert result.code == 4 and plumbline.files(".") == []


def test_list_and_explain_say_what_can_be_scored(plumbline):
    scored = set(scored_cases(plumbline))
    assert scored >= {"sod", "lax", "gas-expansion", "affine-expansion", "acoustic-pulse", "shear-decay", "noh", "piston-shock",
                      "mms-bar", "mms-vortex", "mms-ring", "mms-axis-aligned", "bar-riemann", "bar-vibration", "plane-stress"}
    assert not scored & {"pendulum", "spring-mass", "airbag-200", "two-bar", "two-disks", "stability-bar", "normals-cell", "ball-net"}
    assert "can be judged" in plumbline("explain", "sod").out
    assert "cannot be judged, points of membranes" in plumbline("explain", "pendulum").out


def test_schema_refuses_other_documents():
    with pytest.raises(AssertionError):
        validate("score", {"case": "sod"})
