"""sweep: every run of a plan once, whatever is killed; the same numbers as run and verify; wrong plans are refused whole."""
import json
import os
import signal
import subprocess
import time

import h5py
import pytest
from contract import children_of, edited, parse, validate, wait_for_end, without_volatile

# Fifteen runs of a tenth of a second: enough to be caught in the middle.
PLAN = {"sweep": {"case": "sod", "scheme": ["default", "york1997"], "cells": [40, 60, 80, 100, 120], "ppc": [4, 6, 8]}}
SMALL = {"sweep": {"case": ["sod"], "cells": [20, 30], "ppc": [4, 8]}}


def write(plumbline, plan, name="plan.json"):
    (plumbline.folder / name).write_text(json.dumps(plan) if isinstance(plan, dict) else plan, encoding="utf-8")
    return name


def runs(plumbline, folder="results"):
    return [name for name in plumbline.files(folder) if name.endswith(".h5")]


def stamps(plumbline, folder="results"):
    base = plumbline.folder / folder
    return {name: ((base / name).stat().st_ino, (base / name).stat().st_mtime_ns) for name in runs(plumbline, folder)}


def numbers(path):
    """Everything in a run file that may not differ between two runs of one program."""
    with h5py.File(path) as stored:
        run = without_volatile(parse(stored["run"][()].decode()))
        tables = {}
        stored.visititems(lambda name, item: tables.update({name: item[()].tobytes()})
                          if isinstance(item, h5py.Dataset) and name.startswith(("ledger/", "profile/")) else None)
        return run, tables


def start(plumbline, *arguments):
    return subprocess.Popen(plumbline.command(*arguments), cwd=plumbline.folder, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def wait_for_runs(plumbline, process, count):
    deadline = time.monotonic() + 120
    while len(runs(plumbline)) < count:
        assert process.poll() is None, "it ended before it could be killed"
        assert time.monotonic() < deadline
        time.sleep(0.005)


def test_plan_of_a_tier(plumbline):
    result = plumbline("sweep", "sod*", "--plan", "-")
    plan = result.json("plan")
    files = [run["file"] for batch in plan["batches"] for run in batch["runs"]]
    assert len(files) == len(set(files)) > 50 and plan["tier"] == "quick"
    assert {run["case"] for batch in plan["batches"] for run in batch["runs"]} == {"sod", "sod-3d", "sod-moving", "sod-rotated"}
    for batch in plan["batches"]:
        assert batch["size"] == "small" or len(batch["runs"]) == 1
    assert not (plumbline.folder / "results").exists(), "a plan runs nothing"
    schemes = {run["settings"].get("integrator") for batch in plan["batches"] for run in batch["runs"]}
    assert {"usl", "musl"} <= schemes, "the integrators' own studies are among them"


def test_a_plan_has_no_other_document(plumbline):
    result = plumbline("sweep", "sod", "--plan", "-", "--json", "out.json")
    assert result.code == 2 and result.err.count("--plan") and not result.out and plumbline.files(".") == []


def test_swept_tier_is_all_that_verify_needs(plumbline):
    swept = plumbline("sweep", "spring-mass", "stability-york", "--jobs", 2, json=True, timeout=600)
    document = swept.json()
    assert swept.code == 0 and document["made"] == document["wanted"] > 20 and not document["failed"]
    assert json.loads((plumbline.folder / "results/sweep.json").read_text(encoding="utf-8")) == document
    before = stamps(plumbline)
    reused = plumbline("verify", "spring-mass", "stability-york", "--reuse", json=True, timeout=600)
    assert f"{0} made" in reused.err and reused.code == 0
    after = stamps(plumbline)
    assert {name: after[name] for name in before} == before, "no run is written again"
    fresh = plumbline("verify", "spring-mass", "stability-york", "--results", "fresh", json=True, timeout=600)
    documents = [result.json() for result in (reused, fresh)]
    for document in documents:
        del document["provenance"]
    assert documents[0] == documents[1], "every judged gate to the last digit"


def test_runs_once_and_the_same_for_any_number_of_jobs(plumbline):
    plan = write(plumbline, SMALL)
    for jobs in (1, 2):
        result = plumbline("sweep", "--from", plan, "--jobs", jobs, "--results", f"jobs{jobs}")
        assert result.code == 0, result.text
    assert runs(plumbline, "jobs1") == runs(plumbline, "jobs2") and len(runs(plumbline, "jobs1")) == 4
    one = plumbline("run", "sod", "--cells", 30, "--set", "ppc=4", json=True).json()
    for name in runs(plumbline, "jobs1"):
        first, second = (numbers(plumbline.folder / folder / name) for folder in ("jobs1", "jobs2"))
        assert first == second
        if name == one["file"]:
            assert numbers(plumbline.folder / "results" / name)[1] == first[1]
            assert without_volatile(one)["measures"] == first[0]["measures"]
    assert one["file"] in runs(plumbline, "jobs1")
    before = stamps(plumbline, "jobs1")
    assert "4 stored already, 0 made" in plumbline("sweep", "--from", plan, "--results", "jobs1").text
    assert stamps(plumbline, "jobs1") == before


def test_batches_are_the_plan(plumbline):
    """What another engine does: make the plan, run its batches in any order, and sweep what is missing."""
    own = write(plumbline, SMALL)
    assert plumbline("sweep", "--from", own, "--plan", "batches.json").code == 0
    plan = validate("plan", parse((plumbline.folder / "batches.json").read_text(encoding="utf-8")))
    ids = [batch["id"] for batch in plan["batches"]]
    for batch in reversed(ids):
        assert plumbline("sweep", "--from", "batches.json", "--batch", batch).code == 0
    assert len(runs(plumbline)) == 4 and not (plumbline.folder / "results/sweep.json").exists()
    again = plumbline("sweep", "--from", "batches.json", "--batch", ids[0])
    assert again.code == 0 and "made" not in again.out and "kept" in again.out
    assert "4 stored already" in plumbline("sweep", "--from", "batches.json").text
    assert (plumbline.folder / "results/sweep.json").exists()


def test_stopped_run_is_a_result(plumbline):
    plan = write(plumbline, {"runs": [{"case": "sod", "settings": {"cells": 40, "cfl": 5}}]})
    result = plumbline("sweep", "--from", plan, json=True)
    assert result.code == 0
    assert result.json()["runs"][0]["stop"]["reason"]
    assert "1 stored already" in plumbline("sweep", "--from", plan).text


@pytest.mark.parametrize("number", [signal.SIGKILL, signal.SIGTERM, signal.SIGINT])
def test_resumes_without_doing_anything_twice(plumbline, number):
    plan = write(plumbline, PLAN)
    process = start(plumbline, "sweep", "--from", plan, "--jobs", 2)
    try:
        wait_for_runs(plumbline, process, 4)
        children = children_of(process)
        process.send_signal(number)
        process.communicate(timeout=60)
    finally:
        process.kill()
    assert process.returncode == (-number if number == signal.SIGKILL else 128 + number)
    wait_for_end(children)
    before = stamps(plumbline)
    assert 4 <= len(before) < 30
    result = plumbline("sweep", "--from", plan, "--jobs", 2, json=True)
    document = result.json()
    assert result.code == 0 and document["kept"] == len(before) and document["made"] == 30 - len(before)
    after = stamps(plumbline)
    assert len(after) == 30 and {name: after[name] for name in before} == before
    assert sorted(plumbline.files()) == sorted([*after, "sweep.json"]), "nothing half-written is left"


def test_killed_child_costs_only_the_run_under_way(plumbline):
    plan = write(plumbline, PLAN)
    process = start(plumbline, "sweep", "--from", plan, "--jobs", 1)
    try:
        wait_for_runs(plumbline, process, 3)
        for child in children_of(process):
            os.kill(child, signal.SIGKILL)
        out, error = process.communicate(timeout=120)
    finally:
        process.kill()
    assert process.returncode == 0, out + error
    assert "tried once more alone" in error
    assert len(runs(plumbline)) == 30 and "30 made, 0 failed" in out


def test_two_sweeps_in_one_folder(plumbline):
    plan = write(plumbline, PLAN)
    both = [start(plumbline, "sweep", "--from", plan, "--jobs", 2) for _ in range(2)]
    texts = [process.communicate(timeout=240) for process in both]
    assert [process.returncode for process in both] == [0, 0], texts
    assert len(runs(plumbline)) == 30 and len(plumbline.files()) == 31
    before = stamps(plumbline)
    assert "30 stored already, 0 made" in plumbline("sweep", "--from", plan).text
    assert stamps(plumbline) == before


def test_failed_runs_are_tried_again_and_told(plumbline):
    """A folder in the place of a run's file: it cannot be written, whoever asks."""
    plan = write(plumbline, SMALL)
    made = plumbline("sweep", "--from", plan, "--plan", "-").json("plan")
    blocked = made["batches"][0]["runs"][1]["file"]
    (plumbline.folder / "results" / blocked / "inside").mkdir(parents=True)
    result = plumbline("sweep", "--from", plan, json=True)
    document = result.json()
    assert result.code == 4
    assert document["made"] == 3 and [entry["file"] for entry in document["failed"]] == [blocked]
    assert "1 runs failed, each is tried once more alone" in result.err and blocked in result.err
    (plumbline.folder / "results" / blocked / "inside").rmdir()
    (plumbline.folder / "results" / blocked).rmdir()
    assert "3 stored already, 1 made, 0 failed" in plumbline("sweep", "--from", plan).text


def test_damaged_run_is_made_again(plumbline):
    plan = write(plumbline, SMALL)
    assert plumbline("sweep", "--from", plan).code == 0
    whole = stamps(plumbline)
    broken = plumbline.folder / "results" / sorted(whole)[0]
    broken.write_bytes(broken.read_bytes()[:3000])
    result = plumbline("sweep", "--from", plan)
    assert result.code == 0 and "3 stored already, 1 made" in result.out and broken.name in result.err
    assert numbers(broken)


def test_run_of_other_code_is_made_again(plumbline):
    plan = write(plumbline, SMALL)
    assert plumbline("sweep", "--from", plan).code == 0
    other = plumbline.folder / "results" / runs(plumbline)[0]
    with edited(other) as stored:
        text = stored["restore/run"][()].decode()
        mark = json.loads(text)["fingerprint"]
        assert len(mark) == 12 and mark == json.loads(stored["provenance"][()].decode())["fingerprint"]
        stored["restore/run"][()] = text.replace(mark, "0" * 12)
    assert "3 stored already, 1 made" in plumbline("sweep", "--from", plan).text


@pytest.mark.parametrize("case", ["results is a file", "results cannot be made"])
def test_folder_that_cannot_be_written(plumbline, case):
    plan = write(plumbline, SMALL)
    (plumbline.folder / "results").write_text("x", encoding="utf-8")
    folder = "results" if case == "results is a file" else "results/inside"
    result = plumbline("sweep", "--from", plan, "--results", folder)
    assert result.code == 4 and "results" in result.err


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_read_only_folder(plumbline):
    (plumbline.folder / "results").mkdir(mode=0o555)
    assert plumbline("sweep", "--from", write(plumbline, SMALL)).code == 4


ONE = {"case": "sod", "settings": {"cells": 20}}


@pytest.mark.parametrize("plan, said", [
    ("{", ["no JSON"]),
    ("", ["no JSON"]),
    ("[]", ["an object"]),
    ({}, ["one of batches, runs, sweep"]),
    ({"runs": [ONE], "sweep": {"case": "sod"}}, ["one of batches, runs, sweep"]),
    ({"runs": []}, ["runs", "list of one or more"]),
    ({"runs": ONE}, ["runs", "list of one or more"]),
    ({"run": [ONE]}, ["unknown key 'run'", "did you mean runs"]),
    ({"plan": "1", "runs": [ONE]}, ["plan is 1"]),
    ({"tier": "nightly", "runs": [ONE]}, ["nightly"]),
    ({"runs": [ONE, {"settings": {}}]}, ["runs[1].case"]),
    ({"runs": [ONE, {"case": "sood"}]}, ["runs[1]", "sood", "did you mean sod"]),
    ({"runs": [{**ONE, "scheme": "york"}]}, ["runs[0]", "york", "did you mean york1997"]),
    ({"runs": [{**ONE, "scheme": 7}]}, ["runs[0].scheme", "a name"]),
    ({"runs": [{**ONE, "sttings": {}}]}, ["runs[0]", "did you mean settings"]),
    ({"runs": [{"case": "sod", "settings": {"cels": 20}}]}, ["runs[0]", "cels", "did you mean cells"]),
    ({"runs": [{"case": "sod", "settings": {"cells": -1}}]}, ["runs[0]", "cells = -1 is not allowed", "[2, 1000000]"]),
    ({"runs": [{"case": "sod", "settings": {"cells": "many"}}]}, ["runs[0]", "many", "not a number"]),
    ({"runs": [{"case": "sod", "settings": {"cells": [20]}}]}, ["runs[0].settings.cells", "a number or a name"]),
    ({"runs": [{"case": "sod", "settings": {"shape": "linaer"}}]}, ["runs[0]", "did you mean linear"]),
    ({"runs": [{"case": "sod", "cells": 20, "settings": {"cells": 30}}]}, ["runs[0].settings.cells", "the same as cells"]),
    ({"runs": [{**ONE, "frames": 1}]}, ["runs[0].frames", "[2, 1000]"]),
    ({"runs": [{**ONE, "frames": {"count": 5, "points": 3}}]}, ["runs[0].frames", "points"]),
    ({"runs": [{**ONE, "file": "sod-default-20-0123456789ab.h5"}]}, ["runs[0]", "make it anew"]),
    ({"sweep": {"cells": [20]}}, ["sweep.case"]),
    ({"sweep": {"case": "sod", "cells": []}}, ["sweep.cells", "list of one or more"]),
    ({"sweep": {"case": ["sod", "pendulum"], "density": ["grid"]}}, ["case pendulum", "unknown key of pendulum 'density'"]),
    ({"sweep": {"case": "sod", "integrator": ["leapfrog", "energy"], "transfer": ["apic", "flip"]}}, []),
    ({"sweep": {"case": "sod", **{key: list(range(2, 102)) for key in ("cells", "ppc", "cfl")}}}, ["more than 100000 runs"]),
    ({"batches": [{"id": "a", "runs": [ONE]}, {"id": "a", "runs": [ONE]}]}, ["different ids"]),
    ({"batches": [{"id": "a", "size": "huge", "runs": [ONE]}]}, ["batches[0]", "huge"]),
    ({"batches": [{"id": "a", "estimated_s": "long", "runs": [ONE]}]}, ["batches[0].estimated_s"]),
    ({"batches": [{"id": "a", "runs": [{"case": "sood"}]}]}, ["batches[0].runs[0]", "did you mean sod"]),
])
def test_wrong_plan_is_refused_before_the_first_run(plumbline, plan, said):
    result = plumbline("sweep", "--from", write(plumbline, plan), json=True)
    if not said:
        assert result.code in (0, 2), "a combination that may be refused"
        return
    assert result.code == 2, result.text
    error = result.json("error")["error"]
    for words in said:
        assert words in error["message"], error["message"]
    assert not runs(plumbline) if (plumbline.folder / "results").exists() else True


@pytest.mark.parametrize("arguments, code, said", [
    (["--from", "none.json"], 4, "none.json"),
    (["--from", "newer.json"], 4, "newer version"),
    (["--batch", "0001-small"], 2, "--from"),
    (["--from", "plan.json", "--batch", "0001"], 2, "no batches"),
    (["--tier", "nightly"], 2, "quick"),
    (["--jobs", "0"], 2, "jobs"),
    (["sood"], 2, "did you mean sod"),
    (["--form", "plan.json"], 2, "did you mean --from"),
])
def test_wrong_call(plumbline, arguments, code, said):
    write(plumbline, SMALL)
    write(plumbline, {**SMALL, "plan": 2}, "newer.json")
    result = plumbline("sweep", *arguments)
    assert result.code == code and said in result.text, result.text


def test_unknown_batch_offers_the_nearest(plumbline):
    assert plumbline("sweep", "--from", write(plumbline, SMALL), "--plan", "batches.json").code == 0
    result = plumbline("sweep", "--from", "batches.json", "--batch", "0001-smal")
    assert result.code == 2 and "did you mean 0001-small" in result.err
