"""`scoreboard`: every way in which a result can be there or not, adapters, and what the table says against what `score` and `run` say."""
import json
import os
import random
import signal
import stat
import subprocess
import sys
import time

import h5py
import numpy
import pytest
from contract import ROOT, children_of, exported, hand_in, parse, rows_left, validate, wait_for_end

TEXT_PROGRAM = ROOT / "cases/harness/exchange/adapters/text_program.py"


@pytest.fixture
def board(plumbline):
    return Board(plumbline)


class Board:
    """A folder with starts and results."""

    def __init__(self, plumbline):
        self.plumbline = plumbline
        (plumbline.folder / "board/cases").mkdir(parents=True)
        (plumbline.folder / "board/programs").mkdir()

    def start(self, name, case, *arguments):
        return exported(self.plumbline, case, *arguments, output=f"board/cases/{name}.h5")[1]

    def result(self, program, name, start, **changes):
        (self.plumbline.folder / "board/programs" / program).mkdir(exist_ok=True)
        return hand_in(self.plumbline, start, f"board/programs/{program}/{name}.h5", **changes)

    def adapter(self, name, script):
        """An executable of Python's; `case` and `result` are its arguments."""
        path = self.plumbline.folder / name
        path.write_text(f"#!{sys.executable} -B\nimport os, sys, time, subprocess\ncase, result = sys.argv[1:]\n{script}\n")
        path.chmod(0o755)
        return f"{name}=./{name}"

    def shell(self, name, script):
        path = self.plumbline.folder / name
        path.write_text(f"#!/bin/sh\n{script}\n")
        path.chmod(0o755)
        return f"{name}=./{name}"

    def __call__(self, *arguments, code=None):
        result = self.plumbline("scoreboard", "board", *arguments, json=True)
        assert code is None or result.code == code, result.text
        document = result.json("scoreboard")
        assert parse((self.plumbline.folder / "board/scoreboard.json").read_text()) == document
        return document, result

    def files(self, program):
        return sorted(os.listdir(self.plumbline.folder / "board/programs" / program))


def entries(document, problem=0):
    """{program: [entries]} of one problem."""
    return {program["name"]: program["entries"] for program in document["problems"][problem]["programs"]}


def outcome(document, program):
    (entry,) = entries(document)[program]
    return entry["outcome"], entry["reason"]


# --- results -----------------------------------------------------------------------------------------------------------------


def test_every_way_a_result_can_be_is_a_row(plumbline, board):
    start = board.start("tube", "sod", "--cells", 20)
    lax, finer, bar = (board.start(name, case, "--cells", cells) for name, case, cells in
                       (("lax", "lax", 20), ("finer", "sod", 40), ("bar", "bar-riemann", 50)))
    for path in (lax, finer, bar):
        path.unlink()
    whole = board.result("good", "tube", start)
    for name, change in (("cut", lambda content: content[: len(content) // 2]), ("junk", lambda _: b"no such thing"), ("empty", lambda _: b"")):
        board.result(name, "tube", start).write_bytes(change(whole.read_bytes()))
    (plumbline.folder / "board/programs/absent").mkdir()

    def not_a_number(file):
        file["bodies/gas/velocity"][3] = numpy.nan
    board.result("nan", "tube", start, change=not_a_number)
    board.result("early", "tube", start, time=0.1)
    board.result("another", "tube", start, attributes={"case": "lax"})
    board.result("mesh", "tube", start, attributes={"cells": 40})
    board.result("physics", "tube", start, attributes={"problem": "0123456789ab"})
    document, result = board(code=1)
    found = {program: outcome(document, program) for program in entries(document)}
    wanted = {
        "good": ("scored", ""), "absent": ("missing", "there is no result"), "cut": ("damaged", "HDF5"), "junk": ("damaged", "HDF5"),
        "empty": ("damaged", "HDF5"), "nan": ("damaged", "/bodies/gas/velocity is nan in row 3"),
        "early": ("mismatched", "time is 0.1 s; 0.143 s is wanted"), "another": ("mismatched", "it is of lax at 20 cells; sod at 20 cells"),
        "mesh": ("mismatched", "it is of sod at 40 cells"), "physics": ("mismatched", "problem is 0123456789ab"),
    }  # fmt: skip
    assert found.keys() == wanted.keys()
    for program, (how, words) in wanted.items():
        assert found[program][0] == how and words in found[program][1], (program, found[program])
        assert program in result.err and found[program][1] in result.err
    verdicts = {program["name"]: program["verdict"] for program in document["problems"][0]["programs"]}
    assert verdicts.pop("good") == "FAIL" and set(verdicts.values()) == {None}


def test_solids_of_another_size_are_damaged(board):
    start = board.start("bar", "bar-riemann", "--cells", 50)
    board.result("short", "bar", start, change=rows_left("bar", slice(1, None)))
    how, reason = outcome(board(code=1)[0], "short")
    assert how == "damaged" and "particle by particle" in reason


def test_results_that_hdf5_does_not_come_back_from(plumbline, board):
    """Damaged at random, and a pipe that nobody writes to: some end the process that reads them, or hold it for ever."""
    whole = board.result("whole", "tube", board.start("tube", "sod", "--cells", 20)).read_bytes()
    dice = random.Random(20261123)
    for number in range(40):
        content = bytearray(whole)
        for _ in range(dice.choice((1, 4, 30))):
            content[dice.randrange(min(len(content), dice.choice((2000, len(content)))))] = dice.randrange(256)
        board.result(f"bytes-{number}", "tube", plumbline.folder / "board/cases/tube.h5").write_bytes(content)
    (plumbline.folder / "board/programs/pipe").mkdir()
    os.mkfifo(plumbline.folder / "board/programs/pipe/tube.h5")
    document, _ = board("--timeout", 2, code=1)
    assert outcome(document, "pipe") == ("damaged", "cannot be read: a device or a pipe, not a file")
    assert len(entries(document)) == 42 and outcome(document, "whole") == ("scored", "")


def test_factor_is_the_error_over_that_of_the_default_scheme(plumbline, board):
    start = board.start("tube", "sod", "--cells", 20)
    result = board.result("good", "tube", start, attributes={"wall_s": 0.25})
    document, _ = board(code=1)  # a start that has not moved
    own = plumbline("run", "sod", "--cells", 20, json=True).json("run")["measures"]
    scored = plumbline("score", "sod", "--result", str(result), json=True).json("score")["levels"][0]["measures"]
    (problem,) = document["problems"]
    (entry,) = entries(document)["good"]
    assert problem["measure"] == "density.L1" and problem["settings"] == []
    assert (entry["seconds"], entry["timed"]) == (0.25, "program")
    for measure, of_program in scored.items():
        assert entry["errors"][measure]["error"] == of_program["error"]
        assert problem["own"]["levels"][0]["errors"][measure] == own[measure]["error"]
        ratio = of_program["error"] / own[measure]["error"] if own[measure]["error"] else None
        assert entry["errors"][measure]["ratio"] == (None if ratio is None else pytest.approx(ratio, rel=1e-15))


def test_several_meshes_have_an_order(plumbline, board):
    arguments = []
    for cells in (100, 20, 40):
        start = board.start(f"tube-{cells}", "sod", "--cells", cells)
        arguments += ["--result", str(board.result("good", f"tube-{cells}", start))]
        if cells != 40:
            board.result("part", f"tube-{cells}", start, attributes={"version": str(cells)})
    document, result = board(code=1)
    scored = plumbline("score", "sod", *arguments, json=True).json("score")
    (problem,) = document["problems"]
    good, part = problem["programs"]
    assert [entry["cells"] for entry in good["entries"]] == [level["cells"] for level in problem["own"]["levels"]] == [20, 40, 100]
    assert good["orders"] == scored["measures"] and good["verdict"] == scored["verdict"] == "FAIL"
    assert good["gates"] == scored["gates"] and good["not_judged"] == scored["not_judged"]
    own = plumbline("converge", "sod", "--cells", "20,40,100", json=True).json("converge")["studies"][0]
    assert problem["own"]["orders"] == own["measures"]
    # At 20 and 40 cells no gate reads the mesh alone; the one at 100 cells is missed by a start that has not moved.
    assert [entry["verdict"] for entry in good["entries"]] == ["NONE", "NONE", "FAIL"]
    assert [entry["outcome"] for entry in part["entries"]] == ["scored", "missing", "scored"]
    assert part["verdict"] is None and "good 1.2" not in part["reason"] and "program is" in part["reason"]
    assert f"order {scored['measures']['density.L1']['order']:.3f}" in result.err


def test_runs_of_the_default_scheme_are_made_once(plumbline, board):
    board.result("good", "tube", board.start("tube", "sod", "--cells", 20))
    board(code=1)
    (file,) = plumbline.files()
    made = os.stat(plumbline.folder / "results" / file).st_mtime_ns
    board(code=1)
    assert plumbline.files() == [file] and os.stat(plumbline.folder / "results" / file).st_mtime_ns == made


def test_problems_are_told_apart_by_their_physics(plumbline, board):
    usual = board.start("usual", "sod", "--cells", 20)
    other = board.start("other", "sod", "--cells", 20, "--set", "gamma=1.5", "--set", "ppc=4", "--scheme", "york1997")
    board.result("good", "usual", usual)
    board.result("good", "other", other)
    document, _ = board(code=1)
    assert [problem["settings"] for problem in document["problems"]] == [["ppc=4", "points=equal-volume", "gamma=1.5"], []]
    run = plumbline("run", "sod", "--cells", 20, *(part for key in document["problems"][0]["settings"] for part in ("--set", key)), json=True)
    own = document["problems"][0]["own"]["levels"][0]["errors"]
    assert own == {name: measure["error"] for name, measure in run.json("run")["measures"].items()}
    board.result("good", "other", usual)
    document, _ = board(code=1)
    (entry,) = entries(document)["good"]
    assert entry["outcome"] == "mismatched" and "problem is" in entry["reason"]


def test_starts_that_score_nothing_are_listed(plumbline, board):
    start = board.start("tube", "sod", "--cells", 20)
    board.result("good", "tube", start)
    board.result("good", "tub", start)
    board.start("again", "sod", "--cells", 20)
    board.start("string", "pendulum")
    folder = plumbline.folder / "board/cases"
    (folder / "cut.h5").write_bytes(start.read_bytes()[:-100])
    (folder / "text.h5").write_text("junk")
    board.result("good", "state", start).rename(folder / "state.h5")
    document, result = board(code=1)
    refused = {entry["start"]: entry["reason"] for entry in document["refused"]}
    assert refused.keys() == {"tube.h5", "string.h5", "cut.h5", "text.h5", "state.h5"}
    assert refused["tube.h5"] == "the same start as again.h5"
    assert "membranes" in refused["string.h5"] and "bytes are there" in refused["cut.h5"]
    assert "description" in refused["state.h5"]
    assert document["strays"] == ["good/tub.h5"] and "good/tub.h5" in result.err


def test_start_of_a_case_that_has_changed_since(board):
    start = board.start("tube", "sod", "--cells", 20)
    board.result("good", "tube", start)
    with h5py.File(start) as file:
        about = json.loads(file["description"].asstr()[()])
        bodies = {name: file["bodies/gas"][name][()] for name in file["bodies/gas"]}
    for change, words in (({"problem": "0123456789ab"}, "the case has changed since"), ({"case": "sodd"}, "sodd"), ({"cells": "many"}, "damaged"),
                          ({"cells": -1}, "cells"), ({"settings": {"gamma": []}}, "damaged"), ({"settings": {"gamma": -1}}, "gamma")):
        with h5py.File(start, "w") as file:
            file["description"] = json.dumps({**about, **change})
            for name, values in bodies.items():
                file[f"bodies/gas/{name}"] = values
        document, _ = board(code=1)
        assert [words in entry["reason"] for entry in document["refused"]] == [True], (change, document["refused"])


# --- adapters ----------------------------------------------------------------------------------------------------------------

HAND_IN = f"""
sys.path.insert(0, {str(ROOT / "tests/contract")!r})
import contract
class Here: folder = contract.Path("/")
contract.hand_in(Here, case, result)
"""


def test_adapters_are_run_and_timed(plumbline, board):
    board.start("tube", "sod", "--cells", 20)
    board.start("finer", "sod", "--cells", 40)
    adapter = board.adapter("copies", HAND_IN + "print('said', os.path.isabs(case), os.path.isabs(result))\nassert sys.stdin.read() == ''")
    document, result = board("--run", adapter)
    assert [(entry["outcome"], entry["timed"]) for entry in entries(document)["copies"]] == [("scored", "adapter")] * 2
    assert all(0.01 < entry["seconds"] < 60 for entry in entries(document)["copies"])
    assert board.files("copies") == ["finer.h5", "finer.json", "finer.log", "tube.h5", "tube.json", "tube.log"]
    assert (plumbline.folder / "board/programs/copies/tube.log").read_text() == "said True True\n"
    assert "copies tube.h5" in result.err
    again, _ = board()
    assert again["problems"] == document["problems"], "a later call reads what the adapters left"


FAILING = {
    "status": ("open(result, 'w').write('half'); print('it broke', file=sys.stderr); sys.exit(3)", "failed", "exit status 3: it broke"),
    "raises": ("raise ValueError('no such wall')", "failed", "exit status 1: ValueError: no such wall"),
    "nothing": ("print('done')", "failed", "no result was written, exit status 0: done"),
    "killed": ("os.kill(os.getpid(), 9)", "failed", "signal 9"),
    "rubbish": ("open(result, 'w').write('rubbish')", "damaged", "HDF5"),
    "bytes": ("sys.stdout.buffer.write(b'\\xff\\xfe' * 1000); sys.exit(1)", "failed", "exit status 1"),
}


def test_adapters_that_fail_are_rows(plumbline, board):
    board.start("tube", "sod", "--cells", 20)
    runs = [part for name, (script, _, _) in FAILING.items() for part in ("--run", board.adapter(name, script))]
    no_program = plumbline.folder / "binary"
    no_program.write_bytes(b"\x7fELF and no more")
    no_program.chmod(0o755)
    document, _ = board(*runs, "--run", "binary=binary", code=1)
    for name, (_, how, words) in {**FAILING, "binary": ("", "failed", "cannot be started")}.items():
        found = outcome(document, name)
        assert found[0] == how and words in found[1], (name, found)
        assert ("tube.h5" in board.files(name)) == (how == "damaged"), "what a failed adapter wrote is no result"


def test_result_of_an_earlier_run_does_not_stand_for_a_failed_one(board):
    board.start("tube", "sod", "--cells", 20)
    board("--run", board.adapter("turns", HAND_IN), code=1)
    assert board.files("turns") == ["tube.h5", "tube.json", "tube.log"]
    board("--run", board.adapter("turns", "sys.exit(1)"), code=1)
    assert outcome(board(code=1)[0], "turns") == ("failed", "exit status 1")


def test_late_adapter_is_ended_with_its_children(plumbline, board):
    board.start("tube", "sod", "--cells", 20)
    script = ("open(result, 'w').write('half')\nchild = subprocess.Popen(['sleep', '600'])\n"
              "stubborn = subprocess.Popen(['sh', '-c', 'trap \"\" TERM; while :; do sleep 0.1; done'])\n"
              f"open({str(plumbline.folder / 'children')!r}, 'w').write(f'{{os.getpid()}} {{child.pid}} {{stubborn.pid}}')\ntime.sleep(600)")
    begun = time.monotonic()
    document, _ = board("--run", board.adapter("slow", script), "--timeout", 1.5, code=1)
    assert time.monotonic() - begun < 30
    assert outcome(document, "slow") == ("late", "not done after 1.5 s")
    wait_for_end((plumbline.folder / "children").read_text().split())
    assert board.files("slow") == ["tube.json", "tube.log"]
    assert outcome(board(code=1)[0], "slow")[0] == "late"


def test_signal_ends_the_adapter_and_leaves_nothing_half_written(plumbline, board):
    board.start("tube", "sod", "--cells", 20)
    adapter = board.adapter("slow", "open(result, 'w').write('half')\ntime.sleep(600)")
    process = subprocess.Popen(plumbline.command("scoreboard", "board", "--run", adapter), cwd=plumbline.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE)
    half = plumbline.folder / "board/programs/slow/tube.h5"
    deadline = time.monotonic() + 60
    while not half.exists() and time.monotonic() < deadline:
        time.sleep(0.01)
    children = children_of(process)
    assert children
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=20)
    assert process.returncode == 130
    wait_for_end(children)
    assert board.files("slow") == ["tube.log"] and not (plumbline.folder / "board/scoreboard.json").exists()


def test_program_in_numpy(board):
    """The MPM of tests/stranger: a right one. On 50 cells its error is that of a first-order method, as is the default's."""
    board.start("tube", "sod", "--cells", 50, "--set", "ppc=4")
    board.start("sheet", "plane-stress")
    adapter = board.shell("numpy", f"exec {sys.executable} -B {ROOT}/tests/stranger/adapter.py \"$@\"")
    document, _ = board("--run", adapter, code=1)
    sheet, tube = (entries(document, number)["numpy"][0] for number in (0, 1))
    assert sheet["outcome"] == "failed" and "this program knows a line" in sheet["reason"]
    assert tube["outcome"] == "scored" and tube["timed"] == "program"
    assert document["problems"][1]["programs"][0]["program"] == "stranger"
    start = board.result("start", "tube", board.plumbline.folder / "board/cases/tube.h5")
    assert start.exists()
    document, _ = board()
    moved, at_rest = (entries(document, 1)[name][0]["errors"]["density.L1"]["ratio"] for name in ("numpy", "start"))
    assert moved < at_rest / 2, "what has moved is near the solution, which the start is not"


# --- programs that read and write text ---------------------------------------------------------------------------------------

TEMPLATE = "end_time,{{ end_time }}\nlength,{{ settings.length }}\nmodulus,{{ bodies[0].material.parameters.youngs_modulus.value }}\n" \
           "density,{{ bodies[0].material.parameters.density.value }}\npoints,{{ columns.bar.mass | length }}\n"
# The standing wave of the linear bar, from its input and its points: X + u, v cos wt, E u'.
STANDING_WAVE = r"""
FNR == NR { at[$1] = $2; next }
FNR == 1 { for (k = 1; k <= NF; k++) column[$k] = k; print "position,velocity,mass,volume,stress" > "bar-final.csv"; next }
{
  wavenumber = atan2(0, -1) / (2 * at["length"]); frequency = wavenumber * sqrt(at["modulus"] / at["density"])
  x = $column["position"]; v = $column["velocity"]; phase = frequency * at["end_time"]
  amplitude = v / sin(wavenumber * x) / frequency * sin(phase)
  printf "%.17g,%.17g,%.17g,%.17g,%.17g\n", x + amplitude * sin(wavenumber * x), v * cos(phase), $column["mass"], $column["volume"],
    at["modulus"] * amplitude * wavenumber * cos(wavenumber * x) > "bar-final.csv"
}
END { if (FNR != at["points"] + 1) exit 1 }
"""
# Blanks between columns: every point goes on as it began.
FREE_FLIGHT = r"""
FNR == NR { end = $2; next }
FNR == 1 { for (k = 1; k <= NF; k++) column[$k] = k; print "# position velocity mass density pressure" > "gas-final.csv"; next }
{
  x = $column["position"] + end * $column["velocity"]
  printf "%.17g %.17g %.17g %.17g %.17g\n", x, $column["velocity"], $column["mass"], $column["density"], $column["pressure"] > "gas-final.csv"
}
"""


def text_adapter(board, name, template, command, options=""):
    (board.plumbline.folder / f"{name}.in").write_text(template)
    return board.shell(name, f"exec {sys.executable} -B {TEXT_PROGRAM} {name}.in \"{command}\" {options} \"$@\"")


def test_exact_program_of_text_has_no_error_but_rounding(plumbline, board):
    board.start("bar", "bar-vibration", "--cells", 16, "--set", "t_end=1.25", "--set", "velocity=1e-5")
    (plumbline.folder / "wave.awk").write_text(STANDING_WAVE)
    adapter = text_adapter(board, "wave", TEMPLATE, f"awk -F, -f {plumbline.folder}/wave.awk input bar.csv", "--name awk --version 7")
    document, _ = board("--run", adapter, code=0)
    (problem,) = document["problems"]
    (program,) = problem["programs"]
    assert (program["program"], program["version"], program["verdict"]) == ("awk", "7", "PASS")
    assert problem["settings"] == ["velocity=1e-05", "t_end=1.25"] and program["entries"][0]["timed"] == "program"
    # Amplitudes: velocity 1e-5, displacement 1e-5 / 0.63, stress 1e-4. Positions up to 25 are rounded to 4e-15.
    for measure, scale in (("velocity.Linf", 1e-5), ("stress.Linf", 1e-4)):
        assert program["entries"][0]["errors"][measure]["error"] < 1e-12 * scale, measure
    assert program["entries"][0]["errors"]["displacement.Linf"]["error"] < 1e-14


def test_free_flight_of_a_gas_is_failed(plumbline, board):
    board.start("tube", "sod", "--cells", 100)
    (plumbline.folder / "flight.awk").write_text(FREE_FLIGHT)
    command = f"awk -F, -f {plumbline.folder}/flight.awk input gas.csv"
    document, result = board("--run", text_adapter(board, "flight", "end_time,{{ end_time }}\n", command), code=1)
    (program,) = document["problems"][0]["programs"]
    assert program["verdict"] == "FAIL" and program["entries"][0]["outcome"] == "scored"
    assert {gate["id"]: gate["verdict"] for gate in program["gates"]}["default/density-100"] == "FAIL"
    assert "default/density-100" in result.err


TEXT_FAULTS = {
    "status": ("", "sh -c 'echo out of memory; exit 7'", "failed", "exit status 7"),
    "nothing": ("", "true", "failed", "gas-final.csv"),
    "junk": ("", "sh -c 'echo rubbish > gas-final.csv'", "failed", "a line of names and rows are wanted"),
    "words": ("", "sh -c '(echo mass,density; echo one,two) > gas-final.csv'", "failed", "gas-final.csv: could not convert"),
    "columns": ("", "sh -c '(echo mass,density; echo 1,2,3) > gas-final.csv'", "failed", "2 names stand over 3 columns"),
    "others": ("", "sh -c '(echo a,b; echo 1,2) > gas-final.csv'", "failed", "none of the columns of a final state is among a, b"),
    "part": ("", "sh -c '(echo mass,density; echo 1,2) > gas-final.csv'", "damaged", "/bodies/gas/position is missing"),
    "nan": ("", "sh -c '(echo position,velocity,mass,density,pressure; echo 1,nan,1,1,1) > gas-final.csv'", "damaged",
            "/bodies/gas/velocity is nan in row 0"),
    "template": ("{{ no_such_thing }}", "true", "failed", "'no_such_thing' is undefined"),
    "program": ("", "no-such-program-anywhere", "failed", "no-such-program-anywhere: No such file"),
}


def test_faults_of_programs_of_text_are_rows(board):
    board.start("tube", "sod", "--cells", 20)
    runs = [part for name, (template, command, _, _) in TEXT_FAULTS.items() for part in ("--run", text_adapter(board, name, template, command))]
    document, _ = board(*runs, code=1)
    for name, (_, _, how, words) in TEXT_FAULTS.items():
        found = outcome(document, name)
        assert found[0] == how and words in found[1], (name, found)


def test_columns_of_several_components(board):
    """Position and velocity in the plane, a tensor: names of columns, and back."""
    board.start("sheet", "plane-stress", "--cells", 8)
    copy = "sh -c 'cp sheet.csv sheet-final.csv'"
    document, _ = board("--run", text_adapter(board, "copy", "", copy))
    start, result = (h5py.File(board.plumbline.folder / "board" / name) for name in ("cases/sheet.h5", "programs/copy/sheet.h5"))
    with start, result:
        assert set(result["bodies/sheet"]) == {"position", "velocity", "mass", "volume", "stress"}
        for name, handed in result["bodies/sheet"].items():
            assert numpy.array_equal(handed[()].ravel(), start[f"bodies/sheet/{name}"][()].ravel()), name
    assert entries(document)["copy"][0]["outcome"] == "scored"


# --- calls -------------------------------------------------------------------------------------------------------------------


def test_wrong_calls(plumbline, board):
    def refused(said, *arguments):
        result = plumbline("scoreboard", *arguments, json=True)
        assert result.code == 2 and said in result.err, result.text
        result.json("error")
    (plumbline.folder / "file").write_text("")
    refused("not a folder", "nowhere")
    refused("not a folder", "file")
    refused("no starts in board/cases", "board")
    board.start("tube", "sod", "--cells", 20)
    refused("no programs in board/programs", "board")
    for run in ("", "=file", "name", "name=", "a/b=file", ".hidden=file", "name=file", "name=nowhere", "name=board"):
        refused("--run", "board", "--run", run)
    good = board.adapter("good", "")
    for seconds in ("0", "-1", "soon"):
        refused("--timeout", "board", "--run", good, "--timeout", seconds)
    refused("DIR")
    assert not (plumbline.folder / "board/scoreboard.json").exists() and not (plumbline.folder / "results").exists()


def test_board_that_cannot_be_written_to(plumbline, board):
    board.result("good", "tube", board.start("tube", "sod", "--cells", 20))
    (plumbline.folder / "board/scoreboard.json").mkdir()
    result = plumbline("scoreboard", "board", json=True)
    assert result.code == 4 and "scoreboard.json" in result.err, result.text


@pytest.mark.skipif(os.geteuid() == 0, reason="root may read everywhere")
def test_folder_that_cannot_be_read(plumbline, board):
    board.result("good", "tube", board.start("tube", "sod", "--cells", 20))
    for folder in ("cases", "programs", "programs/good"):
        path = plumbline.folder / "board" / folder
        mode = stat.S_IMODE(path.stat().st_mode)
        path.chmod(0)
        result = plumbline("scoreboard", "board")
        path.chmod(mode)
        assert result.code == 4 and folder in result.err, result.text


def test_inconclusive_is_red_unless_allowed(board):
    """Two meshes are too few for the order that the case asks for, and nothing is missed at 20 and 40 cells."""
    for cells in (20, 40):
        board.start(f"tube-{cells}", "sod", "--cells", cells, "--set", "ppc=4")
    numpy_mpm = board.shell("numpy", f'exec {sys.executable} -B {ROOT}/tests/stranger/adapter.py "$@"')
    document, _ = board("--run", numpy_mpm, code=1)
    assert document["problems"][0]["programs"][0]["verdict"] == "INCONCLUSIVE"
    board("--allow-inconclusive", code=0)


def test_schema_refuses_other_documents():
    with pytest.raises(AssertionError):
        validate("scoreboard", {"scoreboard": 1})
