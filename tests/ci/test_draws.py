"""Bugs drawn at random: what each operator makes of a small source, what it leaves alone, the draw, and its rates."""

import json
import os
import pathlib
import subprocess
import sys
import types

import pytest

pytest.importorskip("clang.cindex", reason="no Python bindings of clang: ci/setup --with mutants")
from clang.cindex import Index  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "ci"))

from mutation import columns, declarations, drawing, judges, matrix, operators, overlay, rates, sites, state, tree  # noqa: E402

PACK = """struct Pack { double v; Pack(double x) : v(x) {} };
inline Pack operator*(const Pack& a, const Pack& b) { return a.v; }
inline Pack operator+(const Pack& a, const Pack& b) { return b.v; }
"""


def sites_of(folder, source, name="toy.cpp", columns=operators.PointColumns()):
    (folder / name).write_text(source)
    unit = Index.create().parse(str(folder / name), ["-std=c++20"])
    assert not [d for d in unit.diagnostics if d.severity >= 3]
    return sites.of_unit(unit, folder, columns=columns)[name]


def changes(walk, operator):
    return {(site.find, site.replace) for site in walk.sites.values() if site.operator == operator}


def test_two_per_cent_of_a_tolerance_or_of_a_number_whose_sign_alone_is_read_change_nothing(tmp_path):
    source = "bool f(double x, double y) { return 2 * x * y <= 0 || 0 < (3 * x) || 1e-9 * y > x || 4 * x < y || 5 * x + y < 0; }"
    walk = sites_of(tmp_path, source)
    assert changes(walk, "coefficient") == {("4 * x", "1.02 * (4 * x)"), ("5 * x", "1.02 * (5 * x)")}
    assert walk.excluded["coefficient", "sign alone"] == 2 and walk.excluded["coefficient", "tolerance"] == 1


def test_coefficients_are_products_and_numbers_that_stand_alone(tmp_path):
    source = "namespace rounding { double unit; }\ndouble f(double x) { return 2 * x * (0.5 * x) + 3.0 - 1e-9 + rounding::unit * x; }"
    walk = sites_of(tmp_path, source)
    # Not 2, 0.5 and the product in brackets beside the whole product: all would be the same bug.
    assert changes(walk, "coefficient") == {("2 * x * (0.5 * x)", "1.02 * (2 * x * (0.5 * x))"), ("3.0", "1.02 * (3.0)")}
    assert walk.excluded["coefficient", "tolerance"] == 2


def test_terms_and_signs_of_sums_of_any_kind_of_number(tmp_path):
    walk = sites_of(tmp_path, "double f(double x, double y) { double s = x - y; s += 2 * x; return -s; }")
    assert changes(walk, "term") == {("x", "0.0"), ("y", "0.0"), ("2 * x", "0.0")}
    assert changes(walk, "sign") == {("y", "-(y)"), ("2 * x", "-(2 * x)"), ("-s", "(s)")}
    walk = sites_of(tmp_path, PACK + "template <class T> Pack f(T x, Pack p) { return x * x + p; }", "pack.cpp")
    assert ("x * x", "(0.0 * (x * x))") in changes(walk, "term") and ("p", "(-1.0 * (p))") in changes(walk, "sign")


def test_sums_of_whole_numbers_are_places_not_terms(tmp_path):
    walk = sites_of(tmp_path, "int f(int n, const double* x) { return *(x + n) > 0 ? n - 1 : n; }")
    assert not changes(walk, "term") and not changes(walk, "sign")


def test_comparisons(tmp_path):
    walk = sites_of(tmp_path, "bool f(int n, double x, void* p) { return (n < 3 && x < 2.0) || n == 5 || p == nullptr; }")
    assert changes(walk, "comparison") == {("n < 3", "n <= 3"), ("x < 2.0", "x > 2.0"), ("n == 5", "n != 5")}


def test_indices_stay_within_what_is_there(tmp_path):
    walk = sites_of(tmp_path, "double f(const double* x, int n) { return x[n] + x[0] + x[3] + x[n++]; }")
    assert changes(walk, "index") == {("n", "(n) > 0 ? (n) - 1 : (n)"), ("0", "1"), ("3", "2")}


def test_ranges_lose_their_first_or_last_pass_and_never_turn_negative(tmp_path):
    walk = sites_of(tmp_path, "void g(); void f(int n) { for (int k = 0; k < n; ++k) g(); for (int k = n; k >= 1; --k) g(); }")
    assert changes(walk, "range") == {("0", "(0) + 1"), ("n", "(n) - ((n) > 0)"), ("1", "(1) + 1")}
    assert not changes(walk, "comparison")  # of a loop's end it would be the same bug


def test_stages_and_columns(tmp_path):
    stages = "struct Stages { void map_forces(); double state(); };\n"
    source = stages + "void step(Stages& mpm) { mpm.map_forces(); for (;;) mpm.map_forces(); const double s = mpm.state(); }"
    (tmp_path / "kernel/integrators").mkdir(parents=True)
    walk = sites_of(tmp_path, source, "kernel/integrators/toy.cpp")
    assert [site.replace for site in walk.sites.values() if site.operator == "stage"] == ["", ""]
    source = """#include <initializer_list>
struct ColumnId { const char* name() const; }; struct All { ColumnId* begin() const; ColumnId* end() const; };
struct Points { double& operator()(const ColumnId&) const; }; namespace column { ColumnId mass, velocity; }
void copy(const ColumnId&); All own(); void f(All all, Points points) {
  for (const ColumnId& id : all) { copy(id); }
  for (const ColumnId& id : {column::velocity}) copy(id);
  for (const ColumnId& id : own()) copy(id);
  points(column::mass) /= 2;
}"""
    names = operators.PointColumns(("mass", "velocity"), {"own": ["density"]})
    walk = sites_of(tmp_path, source, "kernel/toy.cpp", columns=names)
    found = {(site.find, site.wrap, site.type) for site in walk.sites.values() if site.operator == "column"}
    assert found == {("{", "skip", 'id.name() == "mass"'), ("{", "skip", 'id.name() == "velocity"'),
                     ("copy", "skip", 'id.name() == "velocity"'), ("copy", "skip", 'id.name() == "density"'),
                     ("points(column::mass) /= 2;", "statement", "")}  # fmt: skip


def test_lists_of_columns_are_found_by_their_names(tmp_path):
    (tmp_path / "kernel").mkdir()
    (tmp_path / "kernel/columns.hpp").write_text('inline const ColumnId mass{"mass", "kg"};\ninline const ColumnId tangent{"tangent", "1"};')
    (tmp_path / "kernel/gas.cpp").write_text("""std::vector<const ColumnId*> Gas::own(const Context& context) const {
  if (context.plane) return {&column::mass};
  return {&column::density};
}
  const std::array<ColumnId, 1>& short_one() const { return {column::tangent}; }
std::vector<ColumnId> of_all() {
  return {};
}
void other() { use(column::mass); }""")
    found = sites.columns_of(tmp_path)
    assert found.all == ("mass", "tangent")
    assert found.listed == {"own": ["density", "mass"], "short_one": ["tangent"], "of_all": []}


def test_where_no_switch_can_stand_and_where_nothing_is_computed_sites_are_counted_and_left_out(tmp_path):
    source = """constexpr double a = 2 * 0.5; constexpr double g(double x) { return 3 * x; }
double f(double x, double y = 2.5) { if (x < 0) throw 7.0 * x; if constexpr (sizeof(double) > 4) x *= 2; return x; }"""
    walk = sites_of(tmp_path, source)
    assert changes(walk, "coefficient") == {("2", "1.02 * (2)")} and not changes(walk, "comparison")
    assert walk.excluded["coefficient", "constant"] == 3 and walk.excluded["coefficient", "error"] == 1
    assert walk.excluded["comparison", "error"] == 1


def test_a_source_whose_names_are_those_of_a_common_header_too_is_read_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(sites, "LIBRARIES", ())
    root, source = tmp_path / "root", "struct Line { double slope = 0.5; };\ndouble f(Line line) { return 2 * line.slope; }\n"
    (root / "kernel").mkdir(parents=True)
    (root / "kernel/other.hpp").write_text("#pragma once\nstruct Line { double angle = 1.5; };\n")
    (root / "kernel/toy.cpp").write_text(source)
    units = list(sites._units(root, ["kernel/toy.cpp"], ["-std=c++20", f"-I{root}"], ["kernel/other.hpp"], tmp_path))
    found = [{file: changes(walk, "coefficient") for file, walk in sites.of_unit(unit, root).items()} for unit in units]
    assert found[0] == {"kernel/other.hpp": {("1.5", "1.02 * (1.5)")}}
    assert found[1] == {"kernel/toy.cpp": {("0.5", "1.02 * (0.5)"), ("2 * line.slope", "1.02 * (2 * line.slope)")}}


def toy_sites(count):
    """As many of each operator, one below the other in a file."""
    return [tree.Site(name, "kernel/toy.cpp", 100 * k + 1000 * n, "a * b", "1.02 * (a * b)")
            for n, name in enumerate(operators.OPERATORS) for k in range(count)]  # fmt: skip


def test_a_draw_depends_on_its_seed_alone_and_half_of_it_are_coefficients_and_terms():
    draws = [[mutant.at for mutant in drawing.draw(toy_sites(60), seed, 100).mutants()] for seed in ("1", "1", "2")]
    assert draws[0] == draws[1] != draws[2] and len(draws[0]) == 100
    counts = drawing.draw(toy_sites(60), "1", 100).counts
    assert sum(counts.values()) == 100 and counts["coefficient"] + counts["term"] >= 50
    assert sum(drawing.draw([], "1", 37).counts.values()) == 37


def test_the_next_of_the_same_operator_takes_the_place_of_one_that_is_passed_over():
    drawn = drawing.draw(toy_sites(9), "1", 20)
    first = [mutant.id for mutant in drawn.mutants()]
    drawn.passed_over[first[0]] = "does not compile"
    second = [mutant.id for mutant in drawn.mutants()]
    assert len(second) == len(first) and first[0] not in second
    new = set(second) - set(first)
    assert len(new) == 1 and new.pop().split("-")[1] == first[0].split("-")[1]


def test_one_that_overlaps_an_earlier_one_is_passed_over():
    alike = [tree.Site("coefficient", "toy.cpp", at, "a * b * c", "1.02 * (a * b * c)") for at in (0, 4, 50)]
    drawn = drawing.Draw("1", {"coefficient": 3}, {"coefficient": alike})
    assert [mutant.at for mutant in drawn.mutants()] == [0, 50]
    assert list(drawn.passed_over.values()) == ["overlaps another"]


def test_what_the_compiler_refuses_or_makes_no_code_of_is_found(tmp_path):
    text = """#include <cstdio>
template <class T> double nobody(T x) { return 2.0 * x; }
double used(double x) {
  return 3.0 * x;
}
int main() { std::printf("%g", used(1)); }
"""
    bugs = [declarations.Mutant(f"b{number}", "coefficient", "toy.cpp", "", find, replace, "", "drawn", at=text.index(find), number=number)
            for number, find, replace in ((1, "2.0 * x", "1.02 * (2.0 * x)"), (2, "3.0 * x", "1.02 * (3.0 * x)"))]  # fmt: skip
    folder = tmp_path / "overlay"
    overlay.write(folder / overlay.HEADER, overlay.switch(2))
    command = ["g++", "-std=c++20", "-O2", f"-I{folder}", str(folder / "toy.cpp"), "-o", str(tmp_path / "toy")]

    def compiled(*own):
        overlay.write(folder / "toy.cpp", declarations.switched_text(text, own, overlay.HEADER))
        with open(tmp_path / "build.log", "w") as log:
            return subprocess.run(command, stderr=log).returncode == 0

    assert compiled(*bugs) and drawing.switches_of([tmp_path / "toy"]) == {2}
    printed = [subprocess.run([tmp_path / "toy"], env={"PLUMBLINE_MUTANT": n}, capture_output=True, text=True).stdout for n in "02"]
    assert printed == ["3", "3.06"]
    broken = declarations.Mutant("b2", "coefficient", "toy.cpp", "", "3.0 * x", "no_such * x", "", "drawn", at=bugs[1].at, number=2)
    assert not compiled(bugs[0], broken) and drawing.faulty(tmp_path, [bugs[0], broken]) == ["b2"]

    # What a lambda returns is another type: the error stands below, and names no line of the bug.
    text = """#include <algorithm>
#include <cstdio>
int above() { return 5 - 4; }
int used() {
  const auto most = [](int d) { return d - 3; };
  return std::min(1, most(2));
}
int main() { std::printf("%d", used()); }
"""
    typed = [declarations.Mutant(name, "sign", "toy.cpp", "", find, f"-({find})", "", "drawn", at=text.index(find), wrap="factor", type="-1", number=number)
             for number, name, find in ((1, "above", "4"), (2, "typed", "3"))]  # fmt: skip
    assert not compiled(*typed) and drawing.faulty(tmp_path, typed) == ["typed"]


def test_a_drawn_bug_holds_for_the_sources_it_was_drawn_from(tmp_path):
    bug = {"find": "a * b", "replace": "1.02 * (a * b)", "wrap": "expression", "type": "", "at": 8}
    rows = [{"id": "s1-coefficient-000", "operator": "coefficient", "file": "kernel/toy.cpp", "what": "", "bug": bug}]
    (tmp_path / "draw.json").write_text(json.dumps({"mutants": rows}))
    (mutant,) = declarations.load_drawn(tmp_path / "draw.json", known=149)
    assert (mutant.number, mutant.area) == (150, "kernel")
    assert mutant.applied("a * b + a * b;") == "a * b + 1.02 * (a * b);"
    with pytest.raises(declarations.DeclarationError, match="check out that commit"):
        mutant.applied("a * b;")


@pytest.mark.parametrize("wrap, kind, clean, bug", [("factor", "-1", "5", "-5"), ("skip", "k == 1", "3", "2")])
def test_factors_and_passes_are_switched(tmp_path, wrap, kind, clean, bug):
    text = "double f(double x) { return 5 * x; }\nint g() { int n = 0; for (int k = 0; k < 3; ++k) { ++n; } return n; }\n"
    find = "5 * x" if wrap == "factor" else "{"
    at = text.index(find, 0 if wrap == "factor" else text.index("++k"))
    mutant = declarations.Mutant("m", "", "toy.cpp", "", find, "-", "", "drawn", wrap=wrap, type=kind, at=at, number=7)
    call = "f(1)" if wrap == "factor" else "double(g())"
    main = f'#include <cstdio>\n{declarations.switched_text(text, [mutant], overlay.HEADER)}int main() {{ std::printf("%g", {call}); }}\n'
    (tmp_path / overlay.HEADER).write_text(overlay.switch(7))
    (tmp_path / "toy.cpp").write_text(main)
    subprocess.run(["g++", "-std=c++20", f"-I{tmp_path}", str(tmp_path / "toy.cpp"), "-o", str(tmp_path / "toy")], check=True)
    printed = [subprocess.run([tmp_path / "toy"], env={"PLUMBLINE_MUTANT": n}, capture_output=True, text=True).stdout for n in "07"]
    assert printed == [clean, bug]


TOY_TEST = """import os
def test_program(): assert os.environ["PLUMBLINE"] == "/switched/plumbline" and os.environ["OTHER"] == "kept"
def test_bug(): assert os.environ["PLUMBLINE_MUTANT"] != "7"
def test_later(): pass
"""


def test_an_entry_of_ctest_is_run_on_the_switched_program_and_ends_at_its_first_red(tmp_path):
    (tmp_path / "test_toy.py").write_text(TOY_TEST)
    command = [sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", str(tmp_path / "test_toy.py")]
    entry = {"name": "contract.toy", "command": command, "environment": ["PLUMBLINE=/finished/plumbline", "OTHER=kept"]}
    program = overlay.Program(pathlib.Path("/switched/plumbline"), tmp_path)
    judge = judges.EntryJudge(program, entry, {"/finished/plumbline": "/switched/plumbline"})
    clean = judge.judge(None, None)
    assert {name: gate["verdict"] for name, gate in clean.gates.items()} == dict.fromkeys(("test_program", "test_bug", "test_later"), "PASS")
    mutant = declarations.Mutant("one", "", "toy.cpp", "", "a", "b", "", "drawn", at=0, number=7)
    red = judges.red_gates(clean, judge.judge(mutant, clean))
    assert [(gate["gate"], gate["verdict"]) for gate in red] == [("test_bug", "FAIL"), ("test_later", "MISSING")]


# --- rates ---


def test_the_interval_is_that_of_clopper_and_pearson():
    from scipy.stats import binomtest

    for killed, of in ((0, 10), (7, 10), (10, 10), (82, 100)):
        own = binomtest(killed, of).proportion_ci(0.95, "exact")
        assert rates.interval(killed, of) == pytest.approx([own.low, own.high], abs=1e-12)


def row(operator, killed, tested=False, in_part=False, **more):
    return {"id": operator, "operator": operator, "folder": "kernel", "equivalent": None, "same_numbers": False,
            "by_case": {"by": "sod", "gate": "g", "stopped": ""} if killed else None, "in_cases": killed,
            "in_gates": killed or in_part, "in_all": killed or in_part or tested, **more}  # fmt: skip


def drawn_of(**counts):
    return drawing.Draw("1", counts, {}, {"s1-term-000": "no code"})


def test_rates_are_over_all_that_were_drawn_and_operators_weigh_as_their_sites():
    rows = [row("term", True), row("term", True), row("stage", False), row("stage", False, tested=True)]
    result = rates.document(rows, drawn_of(term=2, stage=2), {"term": 900, "stage": 100}, {"term": 7}, {})
    assert (result["by_cases"]["killed"], result["by_cases"]["of"], result["by_cases"]["rate"]) == (2, 4, 0.5)
    assert result["by_gates"]["rate"] == 0.5 and result["by_everything"]["rate"] == 0.75
    weighted = result["by_cases"]["by_sites"]
    assert weighted["rate"] == pytest.approx(0.9)  # 900 sites of 1000 are of an operator whose bugs all die
    assert weighted["effective"] == pytest.approx(1000**2 / (2 * 450**2 + 2 * 50**2))
    assert result["passed_over"] == {"no code": 1} and result["operators"][0]["excluded"] == 7


def test_an_equivalent_bug_must_change_no_number():
    rows = [row("term", True), row("stage", False, equivalent="why", same_numbers=True)]
    result = rates.document(rows, drawn_of(term=1, stage=1), {"term": 1, "stage": 1}, {}, {})
    assert result["by_cases"]["of"] == 1 and result["equivalent"] == 1 and result["broken"] == []
    rows[1]["same_numbers"] = False
    result = rates.document(rows, drawn_of(term=1, stage=1), {"term": 1, "stage": 1}, {}, {})
    assert result["broken"] == ["stage is declared equivalent, yet changes numbers"]


def test_parts_of_schemes_are_judged_by_their_gates(tmp_path):
    listed = {"integrators": [{"name": "musl"}], "shapes": [{"name": "cubic"}], "transfers": [], "materials": [], "contacts": []}
    program = tmp_path / "plumbline"
    program.write_text(f"#!/bin/sh\necho '{json.dumps(listed)}'\n")
    program.chmod(0o755)
    found = columns.part_columns(overlay.Program(program, tmp_path), state.Fingerprints(tmp_path))
    assert [(own.name, own.judge.kind, own.judge.selection) for own in found] == [
        ("integrator musl", "part", ["--integrator", "musl", "--core"]), ("shape cubic", "part", ["--shape", "cubic"])]  # fmt: skip


class CaseOfOneGate:
    kind = "case"

    def __init__(self, name, seconds, red=(), number=1.0):
        self.name, self.seconds, self.red, self.number, self.runs = name, seconds, red, number, []

    def judge(self, mutant, clean):
        self.runs.append(mutant.id if mutant else "")
        verdict = "FAIL" if mutant and mutant.id in self.red else "PASS"
        gates = {"law": {"verdict": verdict, "origin": "theory", "numbers": [self.number if mutant else 1.0]}}
        return judges.Outcome(gates, "", self.seconds, [] if mutant else [1, 2])


def test_a_bug_ends_at_its_first_red_gate_and_cases_come_by_their_cost(tmp_path):
    mutants = [declarations.Mutant(name, "", "toy.cpp", "", "a", "b", "", "drawn", at=0, number=number) for number, name in ((1, "one"), (2, "two"))]
    dear, cheap = CaseOfOneGate("dear", 9, red=["two"]), CaseOfOneGate("cheap", 1, red=["one"])
    columns = [matrix.Column(judge, "same") for judge in (dear, cheap)]
    table = matrix.Matrix(mutants, columns, state.State(tmp_path / "state.jsonl"), state.Fingerprints(tmp_path))
    table.judge_clean(1, lambda text: None)
    table.run_to_first_red(mutants, 1, lambda text: None)
    assert cheap.runs == ["", "one", "two"] and dear.runs == ["", "two"]
    found = rates.row_of(mutants[0], 1, table.cells_of(mutants[0]), None, table.same_numbers(mutants[0]))
    assert found["by_case"] == {"by": "cheap", "gate": "law", "stopped": ""} and found["in_all"] and found["left_out"] == 1


def test_numbers_are_the_same_only_if_every_case_that_meets_the_bug_ran(tmp_path):
    mutant = declarations.Mutant("one", "", "toy.cpp", "", "a", "b", "", "drawn", at=0, number=1)
    same, other = CaseOfOneGate("same", 1), CaseOfOneGate("other", 2, number=1.0 + 2e-16)
    for own, expected in (([same], True), ([same, other], False)):
        columns = [matrix.Column(judge, "same") for judge in own]
        table = matrix.Matrix([mutant], columns, state.State(tmp_path / "state.jsonl"), state.Fingerprints(tmp_path))
        table.judge_clean(1, lambda text: None)
        assert not table.same_numbers(mutant)  # nothing has run
        table.run_to_first_red([mutant], 1, lambda text: None)
        assert table.same_numbers(mutant) is expected
        (tmp_path / "state.jsonl").unlink()


def test_what_a_clean_run_met_holds_for_the_numbers_that_the_bugs_had(tmp_path):
    kept, judge = state.State(tmp_path / "state.jsonl"), CaseOfOneGate("case", 1)
    for number, runs in ((1, 1), (1, 1), (2, 2)):  # another bug stands before it at last
        mutant = declarations.Mutant("one", "", "toy.cpp", "", "a", "b", "", "drawn", at=0, number=number)
        matrix.Matrix([mutant], [matrix.Column(judge, "same")], kept, state.Fingerprints(tmp_path)).judge_clean(1, lambda text: None)
        assert judge.runs == [""] * runs


UNIT_TESTS = """#!/usr/bin/env python3
import json, os, sys
bug = os.environ["PLUMBLINE_MUTANT"] != "-1"
ends = "--gtest_fail_fast" in sys.argv
def test(name, red, run=True):
    return {"name": name, "classname": "Toy", "status": "RUN" if run else "NOTRUN", **({"failures": [{}]} if red else {})}
tests = [test("First", %(clean)s or bug), test("Second", False, not (ends and (%(clean)s or bug)))]
json.dump({"testsuites": [{"testsuite": tests}]}, open("tests.json", "w"))
"""


class UnitTests:
    def __init__(self, folder, red_without_any_bug):
        program = folder / "toy_test"
        program.write_text(UNIT_TESTS % {"clean": red_without_any_bug})
        program.chmod(0o755)
        self.tests = {"tests/toy": program}

    @staticmethod
    def environment(**more):
        return {**os.environ, **more}


def test_unit_tests_run_to_their_end_without_any_bug_and_to_the_first_red_one_with_a_bug(tmp_path):
    judge = judges.GoogleTestJudge(UnitTests(tmp_path, False), "tests/toy", first_only=True)
    clean = judge.judge(None, None)
    assert {name: gate["verdict"] for name, gate in clean.gates.items()} == {"Toy.First": "PASS", "Toy.Second": "PASS"}
    bug = declarations.Mutant("one", "", "toy.cpp", "", "a", "b", "", "drawn", at=0, number=1)
    outcome = judge.judge(bug, clean)
    assert {name: gate["verdict"] for name, gate in outcome.gates.items()} == {"Toy.First": "FAIL"}


def test_unit_tests_that_are_red_without_any_bug_are_no_judges(tmp_path):
    judge = judges.GoogleTestJudge(UnitTests(tmp_path, True), "tests/toy", first_only=True)
    table = matrix.Matrix([], [matrix.Column(judge, "same")], state.State(tmp_path / "state.jsonl"), state.Fingerprints(tmp_path))
    stopped, red = table.judge_clean(1, lambda text: None)
    base = types.SimpleNamespace(build=tmp_path)
    _, wrong = columns.told_apart(base, red, state.Fingerprints(tmp_path), tmp_path, 1, lambda text: None)
    assert stopped == [] and wrong == ["tests/toy: Toy.First is red without any bug"]
    assert len(table.columns[0].clean.gates) == 2
