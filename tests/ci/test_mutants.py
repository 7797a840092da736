"""ci/mutants on a toy tree: the declarations, the switches, what is run and what is not, resuming, and the contract."""

import json
import pathlib
import re
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "ci"))

from mutation import columns, declarations, judges, matrix, overlay, state  # noqa: E402

TOY = """// A toy.
double half(double x) { return 0.5 * x; }
double third(double x) {
  double sum = x;
  sum /= 3;
  return sum;
}
"""


def declared(folder, *entries, **more):
    document = {"area": "kernel", "origin": "declared", "mutants": list(entries), **more}
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "toy.json").write_text(json.dumps(document))
    return declarations.load(folder)


def entry(name, find, replace, **more):
    return {"id": name, "kind": "factor", "file": "toy.cpp", "what": "a toy's bug", "find": find, "replace": replace, **more}


HALF = entry("half", "0.5 * x", "0.6 * x")
THIRD = entry("third", "sum /= 3;", "", wrap="statement")


def test_both_forms_stand_in_the_program_and_a_number_chooses(tmp_path):
    first, second = declared(tmp_path, HALF, THIRD)
    assert (first.number, second.number) == (1, 2)
    text = declarations.switched_text(TOY, [first, second], "switch.hpp")
    assert text.startswith('#include "switch.hpp"\n')
    assert "return (PLUMBLINE_MUTANT(1) ? (0.6 * x) : (0.5 * x));" in text
    assert "if (PLUMBLINE_MUTANT(2)) {  } else { sum /= 3; }" in text


def test_the_compiled_toy_is_the_plain_one_unless_a_bug_is_switched_on(tmp_path):
    mutants = declared(tmp_path / "d", HALF, THIRD)
    main = '#include <cstdio>\n%s\nint main() { std::printf("%%g %%g", half(2), third(9)); }\n'
    (tmp_path / overlay.HEADER).write_text(overlay.switch(2))
    (tmp_path / "toy.cpp").write_text(main % declarations.switched_text(TOY, mutants, overlay.HEADER))
    built = ["g++", "-std=c++20", "-O1", f"-I{tmp_path}", str(tmp_path / "toy.cpp"), "-o", str(tmp_path / "toy")]
    subprocess.run(built, check=True)
    reached = tmp_path / "reached"

    def printed(number):
        environment = {"PLUMBLINE_MUTANT": str(number), "PLUMBLINE_REACHED": str(reached)}
        return subprocess.run([tmp_path / "toy"], env=environment, capture_output=True, text=True, check=True).stdout

    assert [printed(0), printed(1), printed(2)] == ["1 3", "1.2 3", "1 9"]
    assert not reached.exists()
    assert printed(-1) == "1 3" and sorted(reached.read_text().split()) == ["1", "2"]


def test_two_bugs_of_one_place_share_it(tmp_path):
    mutants = declared(tmp_path, HALF, entry("other", "0.5 * x", "0.4 * x"))
    text = declarations.switched_text(TOY, mutants, "switch.hpp")
    assert "(PLUMBLINE_MUTANT(2) ? (0.4 * x) : ((PLUMBLINE_MUTANT(1) ? (0.6 * x) : (0.5 * x))))" in text


@pytest.mark.parametrize(
    "bug, what",
    [
        (entry("a", "sum", "mus"), "3 times, not once"),
        (entry("a", "absent", "b"), "0 times, not once"),
        (entry("a", "x", "y", context="return 0.5 * x; }\ndouble third(double x)"), "its context holds what to find 2 times"),
    ],
)
def test_a_text_that_is_not_there_once_is_an_error(tmp_path, bug, what):
    (mutant,) = declared(tmp_path, bug)
    with pytest.raises(declarations.DeclarationError, match=what):
        mutant.applied(TOY)


def test_overlapping_bugs_are_an_error(tmp_path):
    mutants = declared(tmp_path, HALF, entry("inner", "0.5", "0.7"))
    with pytest.raises(declarations.DeclarationError, match="overlap"):
        declarations.switched_text(TOY, mutants, "switch.hpp")


@pytest.mark.parametrize(
    "bug, what",
    [
        ({"id": "a"}, "lacks"),
        (entry("a", "b", "c", killer="x"), "has .'killer'."),
        (entry("a b", "b", "c"), "a name of its own"),
        (entry("a", "b", "b"), "changes nothing"),
        (entry("a", "b", "c", wrap="function"), "wrap is one of"),
    ],
)
def test_an_incomplete_declaration_is_an_error(tmp_path, bug, what):
    with pytest.raises(declarations.DeclarationError, match=what):
        declared(tmp_path, bug)


def test_every_declared_bug_fits_its_source():
    mutants = declarations.load(ROOT / "tests/mutants")
    assert len(mutants) >= 60 and sum(mutant.origin == "generated" for mutant in mutants) >= 20
    for file in {mutant.file for mutant in mutants}:
        text, own = (ROOT / file).read_text(encoding="utf-8"), [mutant for mutant in mutants if mutant.file == file]
        assert all(mutant.applied(text) != text for mutant in own)
        declarations.switched_text(text, [mutant for mutant in own if mutant.compiled], "switch.hpp")
    headers = [mutant.id for mutant in mutants if mutant.quick and mutant.file.endswith(".hpp")]
    assert not headers, "the quick subset must not compile the engine again"


class Judge:
    """Of one gate per bug it sees; counts its runs."""

    kind = "case"

    def __init__(self, name, seconds, reached, red=(), drift=(), stops=()):
        self.name, self.seconds, self.reached = name, seconds, reached
        self.red, self.drift, self.stops, self.runs = red, drift, stops, []

    def judge(self, mutant, clean):
        self.runs.append(mutant.id if mutant else "")
        verdict = {True: "FAIL", False: "PASS"}
        gates = {
            "law": {"verdict": verdict[bool(mutant) and mutant.id in self.red], "origin": "theory", "numbers": []},
            "drift": {"verdict": verdict[bool(mutant) and mutant.id in self.drift], "origin": "regression", "numbers": []},
        }
        stopped = "time" if mutant and mutant.id in self.stops else ""
        return judges.Outcome({} if stopped else gates, stopped, self.seconds, [] if mutant else self.reached)


def table(tmp_path, mutants, *own):
    (tmp_path / "toy.cpp").write_text(TOY)
    columns = [matrix.Column(judge, "same") for judge in own]
    made = matrix.Matrix(mutants, columns, state.State(tmp_path / "state.jsonl"), state.Fingerprints(tmp_path))
    assert made.judge_clean(1, quiet) == ([], [])
    return made


def quiet(text):
    pass


def test_what_a_case_never_meets_is_not_run_and_does_not_kill(tmp_path):
    mutants = declared(tmp_path / "d", HALF, THIRD)
    judge = Judge("cheap", 1, [1], red=["half", "third"])
    made = table(tmp_path, mutants, judge)
    made.run(1, quiet)
    assert judge.runs == ["", "half"]
    assert [made.cell(mutant, made.columns[0]).run for mutant in mutants] == ["ran", "unreached"]
    rows = matrix.document(made, {})["mutants"]
    assert [row["status"] for row in rows] == ["killed", "survived"]
    assert rows[0]["killed_by"] == [{"case": "cheap", "gate": "law", "origin": "theory", "verdict": "FAIL"}]


def test_a_run_goes_on_where_it_was_and_skips_a_torn_line(tmp_path):
    mutants = declared(tmp_path / "d", HALF, THIRD)
    first = Judge("cheap", 1, [1, 2], red=["half"])
    table(tmp_path, mutants, first).run(1, quiet)
    with open(tmp_path / "state.jsonl", "a", encoding="utf-8") as stream:
        stream.write('{"mutant": "third", "judge": "che')
    again = Judge("cheap", 1, [1, 2], red=["half"])
    made = table(tmp_path, mutants, again)
    made.run(1, quiet)
    assert again.runs == [] and made.cell(mutants[0], made.columns[0]).kills
    # Another bug of the same name is another bug: it and the clean run are judged again, the other one is not.
    (tmp_path / "d/toy.json").unlink()
    changed = declared(tmp_path / "d", HALF, {**THIRD, "replace": "sum /= 2;"})
    later = Judge("cheap", 1, [1, 2])
    table(tmp_path, changed, later).run(1, quiet)
    assert later.runs == ["", "third"]


def test_dear_cases_are_for_those_that_still_live(tmp_path):
    mutants = declared(tmp_path / "d", HALF, THIRD)
    cheap, dear = Judge("cheap", 1, [1, 2], red=["half"]), Judge("dear", 50, [1, 2], red=["third"])
    made = table(tmp_path, mutants, dear, cheap)
    made.run(1, quiet, killed_dear=10)
    assert dear.runs == ["", "third"] and cheap.runs == ["", "half", "third"]
    rows = matrix.document(made, {})["mutants"]
    assert [row["cells"] for row in rows] == ["nr", "rr"] and [row["status"] for row in rows] == ["killed", "killed"]


def test_drift_gates_do_not_count_and_a_stop_does(tmp_path):
    mutants = declared(tmp_path / "d", HALF, THIRD)
    made = table(tmp_path, mutants, Judge("cheap", 1, [1, 2], drift=["half"], stops=["third"]))
    made.run(1, quiet)
    document = matrix.document(made, {})
    assert [row["status"] for row in document["mutants"]] == ["killed_by_drift_only", "killed"]
    assert document["score"] == 0.5 and document["mutants"][1]["stopped"] == [{"by": "cheap", "why": "time"}]


def test_an_equivalent_bug_is_out_of_the_score_and_must_not_be_killed(tmp_path):
    mutants = declared(tmp_path / "d", HALF, {**THIRD, "equivalent": "nobody divides by three"})
    made = table(tmp_path, mutants, Judge("cheap", 1, [1, 2], red=["half"]))
    made.run(1, quiet)
    document = matrix.document(made, {})
    assert document["score"] == 1 and document["counts"]["equivalent"] == 1 and document["broken"] == []
    (tmp_path / "other").mkdir()
    killed = table(tmp_path / "other", mutants, Judge("cheap", 1, [1, 2], red=["half", "third"]))
    killed.run(1, quiet)
    assert "declared equivalent" in matrix.broken_contract(killed)[0]


def test_a_named_killer_that_no_longer_kills_is_told(tmp_path):
    named = {**HALF, "killed_by": [{"case": "cheap", "gate": "law"}, {"case": "gone"}]}
    made = table(tmp_path, declared(tmp_path / "d", named), Judge("cheap", 1, [1], drift=["half"]))
    made.run(1, quiet)
    assert matrix.broken_contract(made) == ["half is no longer killed by cheap, law", "half is no longer killed by gone"]


def test_killers_are_named_cheapest_first_and_drift_last(tmp_path):
    mutants = declared(tmp_path / "d", HALF)
    own = [Judge("dear", 9, [1], red=["half"]), Judge("drifts", 1, [1], drift=["half"]), Judge("cheap", 2, [1], red=["half"])]
    made = table(tmp_path, mutants, *own)
    made.run(1, quiet)
    cases = [entry["case"] for entry in matrix.named_killers(made, mutants[0])]
    assert cases == ["cheap", "dear", "drifts"]


def test_what_is_red_in_the_clean_program_is_told(tmp_path):
    class Red(Judge):
        def judge(self, mutant, clean):
            outcome = super().judge(mutant, clean)
            outcome.gates["law"]["verdict"] = "FAIL"
            return outcome

    mutants = declared(tmp_path / "d", HALF)
    columns = [matrix.Column(Red("cheap", 1, [1]), "same")]
    made = matrix.Matrix(mutants, columns, state.State(tmp_path / "s.jsonl"), state.Fingerprints(tmp_path))
    assert made.judge_clean(1, quiet) == ([], [(columns[0], "law")])


def test_gates_that_go_missing_are_red():
    clean = judges.Outcome({"a": {"verdict": "PASS", "origin": "theory", "numbers": []}})
    assert judges.red_gates(clean, judges.Outcome()) == [{"gate": "a", "origin": "theory", "verdict": "MISSING"}]


def test_processor_time_is_bounded(tmp_path):
    loop = [sys.executable, "-c", "while True: pass"]
    *_, why = judges.run(loop, {}, 0.5)
    assert why == "time"


def test_one_that_waits_in_vain_is_ended_and_one_that_was_halted_is_not(monkeypatch):
    monkeypatch.setattr(judges, "IDLE_SECONDS", 0.3)
    *_, why = judges.run([sys.executable, "-c", "import time; time.sleep(1000)"], {}, 5)
    assert why == "time"
    halted = """import os, signal, time
if os.fork() == 0:
    time.sleep(1)
    os.kill(os.getppid(), signal.SIGCONT)
    os._exit(0)
os.kill(os.getpid(), signal.SIGSTOP)
"""
    status, _, _, why = judges.run([sys.executable, "-c", halted], {}, 5)
    assert (status, why) == (0, "")


def base_with_unit(root, monkeypatch, made, files, alone=()):
    """A build that compiled these files of a target as one unit, and others alone."""
    unit = root / "build" / made / "Unity/unity_0_cxx.cxx"
    unit.parent.mkdir(parents=True)
    unit.write_text("".join(f'#include "{root / file}"\n' for file in files), encoding="utf-8")
    (root / "build/build.ninja").touch()
    outputs = {str(unit): f"{made}/Unity/unity_0_cxx.cxx.o", **{str(root / file): f"{file}.o" for file in alone}}
    entries = [{"file": file, "command": f"c++ -DA -o {output} -c {file}"} for file, output in outputs.items()]
    (root / "build/compile_commands.json").write_text(json.dumps(entries), encoding="utf-8")
    monkeypatch.setattr(overlay.Base, "_ninja", lambda *_: "")
    return overlay.Base(root, root / "build")


def test_files_of_one_unit_have_commands_of_their_own(tmp_path, monkeypatch):
    made, files = "tests/CMakeFiles/kernel_test.dir", ("tests/kernel/a_test.cpp", "tests/kernel/shapes/b_test.cpp")
    base = base_with_unit(tmp_path, monkeypatch, made, files)
    assert base.units_of_tests == {f"{made}/Unity/unity_0_cxx.cxx.o"}
    for file in files:
        name = f"{made}/{file.removeprefix('tests/')}.o"
        assert base.compile[name] == (file, ["c++", "-DA", "-o", name, "-c", str(tmp_path / file)])


def test_draws_know_the_sources_of_units(tmp_path, monkeypatch):
    made, files = "reference/CMakeFiles/plumbline_reference.dir", ["reference/a.cpp", "reference/catalog/b.cpp"]
    base = base_with_unit(tmp_path, monkeypatch, made, files, ("kernel/c.cpp", "tests/d.cpp"))
    assert base.sources[f"{made}/Unity/unity_0_cxx.cxx.o"] == files
    sites = pytest.importorskip("mutation.sites", reason="no Python bindings of clang: ci/setup --with mutants")
    assert sites.arguments_of(base) == (["kernel/c.cpp", *files], ["-DA"])


def test_copies_of_an_earlier_build_do_not_stay(tmp_path):
    for name in (overlay.HEADER, "kernel/a.cpp", "kernel/b.hpp"):
        overlay.write(tmp_path / name, "text")
    overlay.remove_stale(tmp_path, {"kernel/a.cpp": []})
    assert sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()) == ["kernel/a.cpp", overlay.HEADER]


def test_sources_find_their_tests():
    found = judges.tests_of(ROOT, "reference/wave_curve.cpp")
    assert "tests/reference/riemann_test.cpp" in found and "tests/reference/riemann_second_test.py" in found
    assert judges.tests_of(ROOT, "reports/plumbline/reader.py") == ["tests/reports/test_reader.py"]


def test_one_bug_is_shown_as_a_patch_that_applies(tmp_path):
    command = [sys.executable, str(ROOT / "ci/mutants"), "--plain"]
    patch = subprocess.run([*command, "order-one-sided"], capture_output=True, text=True, check=True).stdout
    assert re.search(r"^\+.*complement\(StudentT\(degrees\), 0\.05\)", patch, re.MULTILINE)
    wrong = subprocess.run([*command, "order-one-side"], capture_output=True, text=True)
    assert wrong.returncode == 2 and "order-one-sided" in wrong.stderr


def test_a_case_is_run_again_where_its_values_were_recorded_anew(tmp_path):
    program = tmp_path / "plumbline"
    program.write_text("""#!/bin/sh\necho '{"cases": [{"name": "toy"}]}'\n""")
    program.chmod(0o755)

    class Built:
        plumbline = program
        environment = staticmethod(lambda: None)

    source, recorded = tmp_path / "cases/catalog/toys/toy.cpp", tmp_path / "cases/regressions.json"
    source.parent.mkdir(parents=True)
    source.write_text('"toy"')
    prints = set()
    for text in ("[1]", "[2]"):
        recorded.write_text(text)
        prints |= {column.fingerprint for column in columns.case_columns(tmp_path, Built, state.Fingerprints(tmp_path))}
    assert len(prints) == 2
