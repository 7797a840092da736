"""The judge of outcomes is judged: programs that end as none should, each seen by its rule; and draws that repeat."""
import json
import signal
import sys

import files
import h5py
import numpy
import outcome
import pytest
import sandbox
import values
from sampler import Sampler, groups
from sandbox import Call

MEASURE = {"error": 0.1, "relative_error": 0.2, "value": None, "reference": None, "reference_bound": 1e-15, "unit": "1"}
ERROR = {"key": "cells", "value": "0", "allowed": "[2, 10]", "nearest": [], "message": "cells = 0 is not allowed"}
GATE = {"id": "run/mass", "verdict": "PASS", "measured": 0.0}


class NoCase:
    """A catalog in which one measure may be undefined."""

    def may_be_undefined(self, case):
        return {"shock_position"} if case == "noh" else set()


@pytest.fixture(autouse=True)
def any_schema(monkeypatch):
    """The schema is tested elsewhere; the documents here have what a rule reads, and no more."""
    monkeypatch.setattr(outcome.contract, "validate", lambda definition, document: document)


@pytest.fixture
def broken(tmp_path):
    """Rules that a program breaks, which is a few lines of Python: broken(lines, arguments)."""
    def make(lines, *arguments, **how):
        program = tmp_path / "program"
        program.write_text(f"#!{sys.executable} -S\nimport json, os, signal, sys, time\n{lines}\n", encoding="utf-8")
        program.chmod(0o755)
        folder = tmp_path / "folder"
        folder.mkdir(exist_ok=True)
        call = Call(tuple(arguments), **{"floor": 0.5, **how})
        return [fault.rule for fault in outcome.faults(sandbox.make(str(program), call, folder), NoCase())]
    return make


def says(document, status=0, also=""):
    return f"print(json.dumps({document!r})); {also}; sys.exit({status})" if also else f"print(json.dumps({document!r})); sys.exit({status})"


RUN = ("run", "sod", "--dry-run", "--json", "-")
REFUSED = "sys.stderr.write('plumbline: no\\n');"


@pytest.mark.parametrize("lines, arguments, how, rules", [
    (says({"case": "sod", "verdict": "PASS", "measures": {"density.L1": MEASURE}, "gates": [GATE]}), RUN, {}, []),
    ("sys.exit(5)", RUN, {}, ["status"]),
    ("os.kill(os.getpid(), signal.SIGSEGV)", RUN, {}, ["crash"]),
    ("os.abort()", RUN, {}, ["crash"]),
    ("while True: pass", RUN, {}, ["hang"]),
    ("time.sleep(60)", RUN, {}, ["hang"]),
    (says({}), RUN, {"statuses": (2,)}, ["expected"]),
    ("print('{'); sys.exit(0)", RUN, {}, ["json"]),
    ("print('{\"a\": NaN}'); sys.exit(0)", RUN, {}, ["json"]),
    ("sys.stdout.buffer.write(b'{\"a\": \"\\xff\"}'); sys.exit(0)", RUN, {}, ["text", "json"]),
    ("sys.stderr.write('plumbline: std::bad_alloc\\n'); print('{}'); sys.exit(0)", RUN, {}, ["text"]),
    ("sys.exit(1)", ("run", "sod"), {}, ["text"]),
    ("sys.exit(0)", ("list",), {}, ["lost output"]),
    ("sys.exit(0)", ("list",), {"stdout": "full"}, ["lost output"]),
    ("print('list'); sys.exit(0)", ("list", "--json", "x.json"), {}, ["lost output"]),
    ("print('done'); sys.exit(0)", ("run", "sod"), {}, ["lost output"]),
    ("print('density.L1 error -nan'); open('a.h5', 'w'); sys.exit(0)", ("run", "sod"), {}, ["not finite"]),
    (REFUSED + says({"error": ERROR}, 2), RUN, {}, []),
    (REFUSED + says({"error": {**ERROR, "key": None}}, 2), RUN, {}, ["refusal"]),
    (REFUSED + says({"error": {**ERROR, "value": None, "allowed": None}}, 2), RUN, {}, ["refusal"]),
    (REFUSED + says({"error": ERROR}, 0), RUN, {}, ["refusal"]),
    (REFUSED + says({"error": ERROR}, 2, "open('left', 'w')"), RUN, {}, ["leftover"]),
    (says({"verdict": "PASS"}, 0, "open('x.h5.host-1.part', 'w')"), RUN, {}, ["leftover"]),
    (says({"stop": {"step": 3, "point": 7, "field": "density", "value": -1.0}}, 3), RUN, {}, []),
    (says({"stop": {"step": 3, "point": None, "field": "", "value": None}}, 3), RUN, {}, ["stop"]),
    (says({"verdict": "FAIL", "gates": [{**GATE, "verdict": "FAIL"}]}, 1), RUN, {}, []),
    (says({"verdict": "PASS", "gates": [GATE]}, 1), RUN, {}, ["red"]),
    (says({"gates": [{**GATE, "verdict": "FAIL"}]}), RUN, {}, ["green"]),
    (says({"gates": [{**GATE, "measured": None}]}), RUN, {}, ["not finite"]),
    (says({"case": "sod", "measures": {"density.L1": {**MEASURE, "error": None}}}), RUN, {}, ["not finite"]),
    (says({"case": "sod", "measures": {"shock_position": {**MEASURE, "error": None}}}), RUN, {}, ["not finite"]),
    (says({"case": "noh", "measures": {"shock_position": {**MEASURE, "error": None}}}), RUN, {}, []),
    (says({"case": "sod", "measures": {"density.L1": {**MEASURE, "relative_error": 3.1}}}), RUN, {}, ["large error"]),
    (says({"case": "sod", "measures": {"density.L1": {**MEASURE, "relative_error": 3.1}}}), ("sweep", "sod"), {}, []),
    (says({"case": "sod", "measures": {"shock_position": {**MEASURE, "error": None}}}), ("sweep", "sod"), {}, []),
    (says({"case": "sod", "measures": {"density.L1": {**MEASURE, "relative_error": None}}}), RUN, {}, []),
    (says({"case": "sod", "measures": {"density.L1": {**MEASURE, "error": None}}}), RUN, {}, ["not finite"]),
    (says({"case": "sod", "measures": {"drift": {**MEASURE, "relative_error": None, "value": 0.1, "reference": 0.0}}}), RUN, {}, []),
    (says({"case": "sod", "measures": {"count": {**MEASURE, "relative_error": 9.0, "value": 9.0}}}), RUN, {}, []),
    (says({"growth": 1e300}), RUN, {}, ["not finite"]),
    (says({"settings": {"cells": 10}}), (*RUN, "--cells", "10"), {}, []),
    (says({"settings": {"cells": 20}}), (*RUN, "--cells", "10"), {}, ["settings"]),
    (says({"settings": {"shape": "gimp"}}), (*RUN, "--set", "shape=linear", "--set", "shape=gimp"), {}, ["settings"]),
    ("sys.stderr.write('plumbline: cannot\\n'); sys.exit(4)", ("list",), {}, ["file error"]),
    ("sys.stderr.write('plumbline: out.json: cannot\\n'); sys.exit(4)", ("list", "--json", "out.json"), {}, []),
], ids=lambda value: None)
def test_each_rule_is_seen_broken(broken, lines, arguments, how, rules):
    assert broken(lines, *arguments, **how) == rules


def test_a_signal_is_answered(broken, monkeypatch):
    monkeypatch.setattr(outcome.os, "getloadavg", lambda: (0.0, 0.0, 0.0))
    monkeypatch.setattr(outcome, "ANSWER", 10.0)   # this machine may be busy, too
    deaf = "signal.signal(signal.SIGINT, lambda *_: None); end = time.monotonic() + {}\nwhile time.monotonic() < end: time.sleep(0.01)\nsys.exit(130)"
    sent = {"interrupted": (signal.SIGINT, 2.0), "floor": 20}
    assert broken(deaf.format(4.0), "run", "sod", **sent) == []
    assert broken(deaf.format(14.0), "run", "sod", **sent) == ["signal"]
    assert broken("time.sleep(60)", "run", "sod", **sent) == ["crash"]   # Python ends by the signal itself
    deaf = "signal.signal(signal.SIGINT, signal.SIG_DFL); time.sleep(60)"   # as a program that is not loaded yet
    assert broken(deaf, "run", "sod", **sent) == []
    assert broken("print('begun', flush=True); " + deaf, "run", "sod", **sent) == ["crash"]


def test_a_reader_that_has_left_may_end_it(broken):
    quiet = "signal.signal(signal.SIGPIPE, signal.SIG_DFL); time.sleep(0.1); print('x'); sys.stdout.flush()"
    assert broken(quiet, "list", stdout="gone") == []
    assert broken("signal.signal(signal.SIGPIPE, signal.SIG_DFL); os.kill(os.getpid(), signal.SIGPIPE)", "list") == ["crash"]


def test_two_documents_are_compared_to_the_bit():
    one = {"measures": {"x": {"error": 0.1}}, "wall_s": 1.0, "list": [1, 2]}
    assert outcome.difference(one, {**one, "wall_s": 2.0}) == ""
    assert outcome.difference(one, {**one, "measures": {"x": {"error": 0.1 + 2e-17}}}).startswith("/measures/x/error")
    assert outcome.difference(one, {**one, "list": [1, 2.0]}).startswith("/list/1")


PARAMETERS = [
    {"key": "cells", "default": 100, "unit": "1", "low": 2.0, "high": 1e6, "allowed": "whole number in [2, 1000000]"},
    {"key": "cfl", "default": 0.5, "unit": "1", "low": 0.0, "high": None, "allowed": "(0, inf), or auto, or none"},
    {"key": "dt", "default": None, "unit": "s", "low": 0.0, "high": None, "allowed": "(0, inf) s, or none"},
    {"key": "offset", "default": 0, "unit": "1", "low": 0.0, "high": 1.0, "allowed": "[0, 1)"},
    {"key": "gamma", "default": 1.4, "unit": "1", "low": 1.0, "high": 10.0, "allowed": "(1, 10]"},
    {"key": "velocity", "default": 0, "unit": "m/s", "low": None, "high": None, "allowed": "(-inf, inf) m/s"},
    {"key": "shape", "default": "cubic", "unit": "1", "low": None, "high": None, "allowed": "one of linear, cubic"},
]


@pytest.mark.parametrize("parameter", PARAMETERS, ids=lambda parameter: parameter["key"])
def test_values_that_are_meant_to_be_allowed_are(parameter):
    dice = files.of("values", parameter["key"])
    low, high = parameter["low"], parameter["high"]
    for _ in range(300):
        value = dice.choice((values.usual, values.extreme))(dice, parameter)
        if value in ("auto", "none", "linear", "cubic"):
            assert value in parameter["allowed"]
            continue
        number = float(value)
        closed = parameter["allowed"].replace("whole number in ", "")
        assert low is None or number > low or (number == low and closed.startswith("[")), value
        assert high is None or number < high or (number == high and "]" in closed), value


def test_slips_are_no_names():
    dice = files.of("slips")
    assert all(values.misspelt(dice, "cells") != "cells" for _ in range(200))


def test_what_is_grave_changes_a_state_and_keeps_a_file(tmp_path):
    with h5py.File(tmp_path / "start.h5", "w") as start:
        start.attrs.update(case="sod", cells=4, problem="0", start="0", end_time=0.1)
        for name in ("position", "velocity", "mass", "pressure", "energy"):
            start[f"bodies/gas/{name}"] = numpy.arange(1.0, 9.0)
    files.handed_back(tmp_path / "start.h5", tmp_path / "mine.h5")
    with h5py.File(tmp_path / "mine.h5") as mine:
        assert mine.attrs["kind"] == "final-state" and mine.attrs["time"] == 0.1
        whole = {name: mine[name][()] for name in files.columns(mine)}
    for what, change in files.GRAVE.items():
        files.handed_back(tmp_path / "start.h5", tmp_path / "mine.h5")
        with h5py.File(tmp_path / "mine.h5", "r+") as mine:
            change(files.of(what), mine)
            changed = [name for name in whole if not numpy.array_equal(mine[name][()], whole[name])]
        assert changed or what == "stresses in MPa", what


class Listing:
    """Enough of a program to draw from."""
    text = f"""#!{sys.executable} -S
import json, sys
parameters = {PARAMETERS!r}
if sys.argv[1] == "list":
    print(json.dumps({{"cases": [{{"name": "sod", "kind": "gas", "scored": False}}], "integrators": [{{"name": "usl"}}],
                      "schemes": [{{"name": "default", "settings": {{"sod": {{}}}}}}]}}))
elif sys.argv[1] == "explain":
    print(json.dumps({{"parameters": parameters}}))
else:
    sys.stderr.write("plumbline: cells = 1 is not allowed\\n")
    print(json.dumps({{"error": {json.dumps(ERROR)}}}))
    sys.exit(2)
"""


def test_a_draw_repeats(tmp_path):
    program = tmp_path / "program"
    program.write_text(Listing.text, encoding="utf-8")
    program.chmod(0o755)

    def lines(seed, number):
        made = []

        def make(call):
            made.append(call.line())
            return sandbox.make(str(program), call, tmp_path)
        Sampler(program, seed, kinds=("one_run", "wrong_run")).follow(number, tmp_path, make)
        return made

    drawn = [lines("s", number) for number in range(12)]
    assert drawn == [lines("s", number) for number in range(12)]
    assert drawn != [lines("t", number) for number in range(12)] and all(drawn)


def test_options_are_dropped_with_their_values():
    assert groups(("run", "sod", "--dry-run", "--set", "a=1", "--cells", "4")) == [
        ("run",), ("sod",), ("--dry-run",), ("--set", "a=1"), ("--cells", "4")]


def test_lines_are_for_a_shell():
    assert Call(("run", "a b", b"\xff'", "x" * 300), stdout="full").line() == \
        "plumbline run 'a b' $'\\xff\\x27' \"$(head -c 300 < /dev/zero | tr '\\0' x)\" > /dev/full"
    assert json.dumps(Call(("list",), stdin=b"{}").line()) == '"printf \'{}\' | plumbline list"'
