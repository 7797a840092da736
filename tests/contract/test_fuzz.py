"""Junk on the command line: the call is refused with a reason and leaves nothing, or it is a call like any other; never a crash."""
import json
import random
import sys

import h5py
import numpy
import pytest
from contract import ROOT, edited

sys.path.insert(0, str(ROOT / "reports"))
from plumbline import reader  # noqa: E402

SEED = 20261122
CALLS = 40  # of each kind; hundredths of a second each
SCRAPS = ["", " ", "=", "==", "0", "-0", "1", "-1", "1e308", "-1e308", "1e-320", "1e999", "nan", "inf", "-inf", "0x10", "1_000", "1,5",
          "１", "é", "\u202e", "\U0001f600", "\\", "/", "..", "%s%n", "{}", "[]", "null", "true", "none", "auto", "cells", "cfl", "shape",
          "linear", "gamma", "transfer", "apic", "x" * 5000, "9" * 400, "--", "-", "'", '"', "\t", "\n", ";", "#", "*", "sod"]
KEYS = ["cells", "cfl", "dt", "ppc", "shape", "transfer", "integrator", "density", "points", "offset", "gamma", "viscosity.linear", "t_end",
        "left.density", "right.pressure", "split", "sharpening"]


def junk(dice, pieces=SCRAPS):
    return "".join(dice.choice(pieces) for _ in range(dice.choice((1, 1, 1, 2, 3))))


def settle(result, arguments, allowed):
    """Refused in words, or one of the statuses that such a call may have."""
    assert result.code in allowed, (arguments, result.code, result.err[-500:])
    if result.code == 2:
        assert result.err.startswith("plumbline: ") and len(result.err) > 20, (arguments, result.err)


def test_settings(plumbline):
    """A legal choice runs: 0, 1 or 3. A few points, one step at most."""
    dice = random.Random(SEED)
    refused = 0
    for _ in range(CALLS):
        key = dice.choice(KEYS) if dice.random() < 0.7 else junk(dice)
        value = junk(dice) if dice.random() < 0.8 else str(dice.choice((dice.uniform(-3, 3), dice.randrange(-5, 300))))
        setting = dice.choice((f"{key}={value}", f"{key}={value}", junk(dice)))
        arguments = ("run", "sod", "--cells", 4, "--set", setting, "--dry-run")
        result = plumbline(*arguments, timeout=60)
        settle(result, arguments, (0, 1, 2, 3))
        refused += result.code == 2
    assert refused > CALLS / 2 and plumbline.files(".") == []


def test_places_of_references(plumbline):
    dice = random.Random(SEED + 1)
    for _ in range(CALLS):
        places = ",".join(junk(dice) for _ in range(dice.choice((1, 2, 3))))
        name = dice.choice(("riemann", "riemann", "sedov", "noh", junk(dice)))
        arguments = ("reference", name, "--at", places)
        result = plumbline(*arguments, json=True, timeout=60)
        settle(result, arguments, (0, 1, 2))
        if result.code == 0:
            result.json()


def mutated(dice, value, depth=0):
    """A plan with something wrong in it, at any depth."""
    wrong = [None, True, 0, -1, 1.5, 1e308, "", "sod", "x" * 300, [], {}, [[]], {"case": "sod"}, "\u0000", "\ud7ff"]
    if depth > 6 or dice.random() < 0.15:
        return dice.choice(wrong)
    if isinstance(value, dict):
        changed = {dice.choice((key, key, key, junk(dice)[:50])): mutated(dice, item, depth + 1) for key, item in value.items()}
        if dice.random() < 0.2:
            changed[junk(dice)[:50]] = dice.choice(wrong)
        return changed
    if isinstance(value, list):
        return [mutated(dice, item, depth + 1) for item in value] * dice.choice((1, 1, 2))
    return value if dice.random() < 0.7 else dice.choice(wrong)


def broken_text(dice, text):
    characters = list(text)
    for _ in range(dice.choice((1, 1, 3, 10))):
        at = dice.randrange(len(characters))
        characters[at:at + dice.choice((0, 1, 1, 5))] = dice.choice(('"', "{", "}", "[", "]", ",", ":", "\\u00", "\x00", "1e", "nul", ""))
    return "".join(characters)


@pytest.mark.parametrize("kind", ["values", "text", "bytes"])
def test_plans(plumbline, kind):
    """`--plan` of a plan `--from` checks all of it and runs nothing."""
    dice = random.Random(f"{SEED} {kind}")
    assert plumbline("sweep", "bar-riemann", "--plan", "whole.json").code == 0
    whole = json.loads((plumbline.folder / "whole.json").read_text(encoding="utf-8"))
    whole["batches"] = [{**batch, "runs": batch["runs"][:2]} for batch in whole["batches"][:2]]
    path, refused = plumbline.folder / "plan.json", 0
    for _ in range(CALLS):
        plan = dice.choice((whole, {"runs": whole["batches"][0]["runs"]}, {"sweep": {"case": ["sod"], "cells": [4, 8], "ppc": [2]}}))
        if kind == "values":
            path.write_text(json.dumps(mutated(dice, plan)), encoding="utf-8")
        elif kind == "text":
            path.write_text(broken_text(dice, json.dumps(plan)), encoding="utf-8")
        else:
            path.write_bytes(dice.randbytes(dice.choice((0, 1, 8, 300))))
        arguments = ("sweep", "--from", "plan.json", "--plan", "-")
        result = plumbline(*arguments, timeout=60)
        settle(result, (arguments, path.read_bytes()[:600]), (0, 2, 4))
        refused += result.code != 0
    assert refused > CALLS / 2 and plumbline.files(".") == ["plan.json", "whole.json"]


def test_deep_plan(plumbline):
    """Nesting that would use up the stack of a parser by recursion."""
    (plumbline.folder / "plan.json").write_text('{"runs": ' + "[" * 100_000 + "]" * 100_000 + "}", encoding="utf-8")
    settle(plumbline("sweep", "--from", "plan.json", "--plan", "-"), "deep", (2,))


# --- files whose seal holds, and whose content nobody would write --------------------------------


def junk_dataset(dice, group, name):
    """In the place of a data set: another type, another shape, or one that claims to be larger than any memory."""
    text = json.dumps(dice.choice((None, [], {}, 1e308, -1, "x", {"format": []}, [[1], "2"])))
    values = (numpy.bytes_(text), text, numpy.bytes_(b"\xff\xfe{"), numpy.zeros(0), numpy.float64(numpy.nan), numpy.zeros((2, 3, 4)),
              numpy.arange(7, dtype="i2"), numpy.full(5, numpy.inf), h5py.Empty("f"), numpy.array([(1, 2.0)], dtype="i4,f8"))
    if dice.random() < 0.15:
        group.create_dataset(name, shape=(dice.choice((2**31, 2**40, 2**62)),), chunks=(4096,), dtype=dice.choice(("f8", "u1")))
    else:
        group[name] = dice.choice(values)


def spoil(dice, path, part=""):
    """Up to three objects of a file, or of one of its groups."""
    with edited(path) as file:
        names = []
        file.visit(lambda name: names.append(name) if name.startswith(part) else None)
        for _ in range(dice.choice((1, 1, 3))):
            name = dice.choice(names)
            if name not in file:
                continue
            kind = dice.choice(("delete", "replace", "text", "group", "attribute"))
            item = file[name]
            text = item[()].decode() if isinstance(item, h5py.Dataset) and item.dtype.kind == "S" and item.shape == () else ""
            if kind == "attribute":
                file.attrs[dice.choice(("plumbline_format", "kind"))] = dice.choice((-1, 2.5, "run", numpy.zeros(3), numpy.bytes_(b"\xff")))
                continue
            del file[name]
            if kind == "group":
                file.create_group(name)
            elif kind == "text" and text:
                file[name] = numpy.bytes_(broken_text(dice, text).encode())
            elif kind == "replace":
                junk_dataset(dice, file, name)


def test_runs_of_any_content(plumbline):
    """A run is used again or made anew; the page's reader reads it or says why not."""
    call = ("converge", "sod", "--cells", "10,20", "--reuse")
    assert plumbline(*call).code in (0, 1)
    (path,) = (plumbline.folder / "results").glob("sod-default-10-*.h5")
    whole, made = path.read_bytes(), 0
    for number in range(CALLS):
        dice = random.Random(f"{SEED} run {number}")
        path.unlink()
        path.write_bytes(whole)
        spoil(dice, path, "restore" if dice.random() < 0.7 else "")
        read_or_refuse(path)
        result = plumbline(*call, timeout=60)
        assert result.code in (0, 1) and result.err.count("std::") == 0, (number, result.text)
        made += "not used again" in result.err
    assert made > CALLS / 4


def test_frames_of_any_content(plumbline):
    assert plumbline("run", "two-disks", "--cells", 4, "--frames", 2).code in (0, 1)
    (path,) = (plumbline.folder / "results").glob("two-disks-*.h5")
    whole = path.read_bytes()
    for number in range(2 * CALLS):
        path.unlink()
        path.write_bytes(whole)
        spoil(random.Random(f"{SEED} frames {number}"), path, "frames" if number % 2 else "")
        read_or_refuse(path)


def test_studies_of_any_content(plumbline):
    """`diff` compares them, or lists them as damaged."""
    assert plumbline("verify", "bar-riemann").code == 0
    (plumbline.folder / "results").rename(plumbline.folder / "base")
    names = [name for name in plumbline.files("base") if name.startswith(("study-", "verdicts-"))]
    (plumbline.folder / "results").mkdir()
    for number in range(CALLS):
        dice = random.Random(f"{SEED} study {number}")
        path = plumbline.folder / "results" / dice.choice(names)
        path.write_bytes((plumbline.folder / "base" / path.name).read_bytes())
        spoil(dice, path)
        read_or_refuse(path)
        result = plumbline("diff", "base", "results", timeout=60)
        settle(result, number, (0, 1, 2, 4))
        assert "terminate" not in result.err and "std::" not in result.text, (number, result.text)
        path.unlink()


def read_or_refuse(path):
    try:
        reader.load(path)
    except reader.ResultsError as error:
        assert str(error)
