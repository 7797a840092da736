"""ci/judges on a program that answers as told: what counts as seen, what is a fault; and the changes of the built-in integrators."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import time

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "ci"))

from judging import judge, systematic, tables  # noqa: E402

TOY = """#include "kernel/time_integrator.hpp"

namespace plumbline {
namespace {

class Toy final : public TimeIntegrator {
  void step(Stages& mpm, double dt) override {
    mpm.map_forces();  // mpm.locate_points();
    mpm.move_points(dt, NodalVelocity::midpoint);
    if (mpm.reverse_cooling()) {
      mpm.set_state(2.0 * (mpm.state() + dt * mpm.velocities_of(mpm.rate())));
    }
  }
};
PLUMBLINE_INTEGRATOR(Toy, "toy", "a toy (of one file)", "nobody");

}  // namespace
}  // namespace plumbline
"""


def gate(name, verdict="PASS", case="integrator", **more):
    expected = {"low": None, "high": 0.1}
    return {"id": name, "case": case, "study": name.split("/")[0], "quantity": "q", "expected": expected, "measured": 0.5,
            "margin": -0.4, "verdict": verdict, "note": "", **more}  # fmt: skip


# --- what a document says ---


def test_the_first_red_gate_beyond_the_identities_has_seen_it():
    red = [gate("mass", "FAIL", case="sod"), gate("identities/sod/mass", "FAIL"), gate("energy/bar/slope", "FAIL"), gate("order/x/y", "FAIL")]
    found = judge.read({"gates": [gate("consistency/a/b"), gate("stability/a/b", "INCONCLUSIVE"), *red]})
    assert found.verdict == "red" and found.proven and found.seen_by()["id"] == "energy/bar/slope"
    assert found.seen_by(("order",))["id"] == "order/x/y" and found.seen_by(("jumps",))["id"] == "energy/bar/slope"
    assert len(found.measured) == 6 and found.inconclusive == 1


def test_identities_alone_prove_nothing():
    found = judge.read({"gates": [gate("momentum", "FAIL", case="two-bar"), gate("consistency/a/b")]})
    assert found.verdict == "red" and not found.proven and judge.family_of(found.seen_by()) == "identities"


@pytest.mark.parametrize("verdict, expected", [("PASS", "green"), ("XFAIL", "green"), ("INCONCLUSIVE", "green"), ("NONE", "green"),
                                               ("FAIL", "red"), ("INVALID", "red"), ("XPASS", "red")])  # fmt: skip
def test_what_is_red(verdict, expected):
    assert judge.read({"gates": [gate("consistency/a/b", verdict)]}).verdict == expected


def test_orders_and_limits_agree_to_three_digits():
    known = {"order": 3, "limit": 1.7320508}

    def agreeing(order, limit, known=known):
        card = {"limits": [{"problem": "bar", "limit": 1}, {"problem": "oscillator", "limit": limit}]}
        found = judge.read({"gates": [gate("order/oscillator/displacement", measured=order)], "scorecards": [card]})
        return [entry["agrees"] for entry in tables.against_known(found, known)]

    assert agreeing(3.01, 1.7325) == [True, True]
    assert agreeing(2.98, 1.734) == [False, False]
    assert agreeing(3.02, None) == [False, False]
    assert agreeing(3.01, 1.8, {"order": 3, "limit": None}) == [True]
    assert [entry["agrees"] for entry in tables.against_known(judge.read({}), known)] == [False, False]


def test_the_smallest_defect_is_that_of_each_gate_and_kind():
    one, two = gate("consistency/a/x", "FAIL"), gate("consistency/b/v", "FAIL")
    found = {("strain", 1e-2): judge.read({"gates": [one, two]}), ("strain", 1e-3): judge.read({"gates": [one]}),
             ("force", 1e-3): judge.read({"gates": [two, gate("order/a/x", "FAIL")]})}  # fmt: skip
    assert tables.smallest(judge.read({"gates": [gate("consistency/a/x")]}), found) == [
        {"gate": "consistency/a/x", "strain": 1e-3, "force": None}, {"gate": "consistency/b/v", "strain": 1e-2, "force": 1e-3}]  # fmt: skip
    assert tables.smallest(judge.read({"gates": [one, two]}), found) == []


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGKILL])
def test_whatever_ends_it_ends_what_it_runs(tmp_path, number):
    (tmp_path / "bin").mkdir()
    program = tmp_path / "bin/plumbline"
    listed = json.dumps({"integrators": [{"name": name, "title": name} for name in ("weak-one", "weak-two")]})
    program.write_text(f"#!/bin/sh\ncase $1 in list) echo '{listed}' ;; *) echo $$ > {tmp_path}/$$.pid; exec sleep 600 ;; esac\n")
    program.chmod(0o755)
    judges = subprocess.Popen([sys.executable, ROOT / "ci/judges", "--no-build", "--build", tmp_path, "--only", "weak-one", "weak-two"],
                              stdout=subprocess.DEVNULL)  # fmt: skip
    until(lambda: len([*tmp_path.glob("*.pid")]) == 2)
    started = [path.stem for path in tmp_path.glob("*.pid")]
    judges.send_signal(number)
    judges.wait(10)
    until(lambda: not any(b"sleep" in command_of(pid) for pid in started))


def until(holds, seconds=10):
    end = time.monotonic() + seconds
    while not holds():
        assert time.monotonic() < end
        time.sleep(0.05)


def command_of(pid):
    """Empty once it has ended."""
    try:
        return pathlib.Path(f"/proc/{pid}/cmdline").read_bytes()
    except OSError:
        return b""


# --- the changes of a source ---


def test_every_number_is_scaled_and_every_call_left_out_or_doubled():
    found = [(change.stage, change.what, change.kind) for change in systematic.changes(TOY)]
    both, scaled = ("left-out", "doubled"), ("x0.999", "x1.001")
    assert found == [
        *(("map_forces", "call", kind) for kind in both),
        *(("move_points", "argument 1", kind) for kind in scaled),
        *(("move_points", "call", kind) for kind in both),
        *(("reverse_cooling", "call", kind) for kind in both),
        *(("set_state", "argument 1", kind) for kind in scaled),
        *(("set_state", "call", kind) for kind in both),
        *(("state", "value", kind) for kind in (*scaled, "left-out")),
        ("velocities_of", "call", "left-out"),
        *(("rate", "value", kind) for kind in (*scaled, "left-out")),
    ]
    assert [change.number for change in systematic.changes(TOY)] == list(range(1, len(found) + 1))
    assert len({change.name for change in systematic.changes(TOY)}) == len(found)


RUN = """
#include <cstdio>
%s
namespace plumbline {
namespace {
State one(double x) { return {{x}}; }
struct Told final : public Stages {
  void locate_points() override {}
  void map_mass_and_momentum() override {}
  void map_forces() override { std::printf("forces "); }
  void advance_momentum(double) override {}
  void move_points(double dt, NodalVelocity) override { std::printf("move %%g ", dt); }
  void drift_points(double) override {}
  void kick_points(double) override {}
  void map_momentum() override {}
  void strain_points(double, NodalVelocity) override {}
  void evaluate_stress(NodalVelocity) override {}
  void predict_stress(double, NodalVelocity) override {}
  bool reverse_cooling() override { std::printf("ask "); return true; }
  void return_transfer_loss() override {}
  State state() const override { return one(3); }
  void set_state(const State& s) override { std::printf("set %%.12g ", s.values[0]); }
  State rate() override { return one(5); }
  State velocities_of(State s) const override { return 10 * s; }
};
std::vector<IntegratorEntry> all;
}
RegisterIntegrator::RegisterIntegrator(IntegratorEntry entry, const PluginStamp&) { all.push_back(entry); }
}
int main() {
  plumbline::Told told;
  for (const auto& entry : plumbline::all) {
    std::printf("%%s: ", entry.name.c_str());
    entry.copy(*entry.make())->step(told, 2);
    std::puts("");
  }
}
"""


@pytest.fixture(scope="module")
def steps(tmp_path_factory):
    """{name of a change of the toy: what its step did}, and under "" the toy's own."""
    folder = tmp_path_factory.mktemp("toy")
    (folder / "toy.cpp").write_text(TOY)
    made = systematic.source(folder / "toy.cpp")
    made = made.replace("{{\n", '{{\n    {0, "", "no change"},\n', 1)
    (folder / "run.cpp").write_text(RUN.replace("%%", "\0").replace("%s", made, 1).replace("\0", "%"))
    (folder / "kernel").mkdir()
    (folder / "kernel/header_hash.hpp").write_text('#define PLUMBLINE_VERSION "0"\n#define PLUMBLINE_INTEGRATOR_HEADERS "0"\n')
    eigen = ["-isystem", "/usr/include/eigen3"]
    subprocess.run(["g++", "-std=c++20", "-O0", "-Wall", "-Wextra", "-Werror", f"-I{ROOT}", f"-I{folder}", *eigen, "run.cpp", "-o", "run"], cwd=folder, check=True)
    printed = subprocess.run([folder / "run"], capture_output=True, text=True, check=True).stdout
    return {name: did.strip() for name, _, did in (line.partition(":") for line in printed.splitlines())}


def test_without_a_change_the_step_is_the_original(steps):
    assert steps.pop("") == "forces move 2 ask set 206"
    assert len(steps) == len(systematic.changes(TOY))


@pytest.mark.parametrize(
    "change, did",
    [
        ("01-map_forces-left-out", "move 2 ask set 206"),
        ("01-map_forces-doubled", "forces forces move 2 ask set 206"),
        ("02-move_points-arg1-x0.999", "forces move 1.998 ask set 206"),
        ("02-move_points-arg1-x1.001", "forces move 2.002 ask set 206"),
        ("02-move_points-left-out", "forces ask set 206"),
        ("03-reverse_cooling-left-out", "forces move 2"),
        ("03-reverse_cooling-doubled", "forces move 2 ask ask set 206"),
        ("04-set_state-arg1-x1.001", "forces move 2 ask set 206.206"),
        ("05-state-value-x0.999", "forces move 2 ask set 205.994"),
        ("05-state-value-left-out", "forces move 2 ask set 200"),
        ("06-velocities_of-left-out", "forces move 2 ask set 6"),
        ("07-rate-value-x1.001", "forces move 2 ask set 206.2"),
    ],
)
def test_each_change_does_what_it_says(steps, change, did):
    assert steps[f"systematic-toy-{change}"] == did


def test_every_built_in_integrator_is_changed():
    names = [change.name for change in systematic.all_changes()]
    assert all(len(name) <= 63 for name in names), "the program takes no longer ones"
    assert len(set(names)) == len(names) and len(systematic.built_in()) == len({change.integrator for change in systematic.all_changes()})
    for path in systematic.built_in():
        assert "PLUMBLINE_INTEGRATOR" not in systematic.source(path)


@pytest.mark.parametrize("text, what", [(TOY.replace(" final", ""), "is not declared as other integrators are"), (TOY.replace('"toy"', "toy"), "registers 0"),
                                        (TOY.replace("mpm.map_forces();", "use(mpm.map_forces());"), "nothing is known of its value")])  # fmt: skip
def test_what_cannot_be_changed_is_an_error(tmp_path, text, what):
    (tmp_path / "toy.cpp").write_text(text)
    with pytest.raises(ValueError, match=what):
        systematic.source(tmp_path / "toy.cpp")


def test_a_parenthesis_that_is_not_closed_is_an_error():
    with pytest.raises(ValueError, match="is not closed"):
        systematic.calls("mpm.move_points((dt)")


# --- the command ---

STUB = f"#!{sys.executable}" + """
import json, pathlib, sys
told = json.loads(pathlib.Path(__file__).with_name("told.json").read_text())
words = sys.argv[1:]
if words[0] == "list":
    print(json.dumps({"integrators": [{"name": name, "title": "its defect", "source": "here"} for name in told]}))
    sys.exit(0)
answer = told[words[words.index("--integrator") + 1]]
if isinstance(answer, int):
    print("it cannot step", file=sys.stderr)
    sys.exit(answer)
if words[-1].endswith("_defect=0.01") or words[-1].endswith("_defect=0.001"):
    answer = {"gates": [dict(gate, verdict="FAIL") for gate in answer["gates"]]}
pathlib.Path(words[words.index("--json") + 1]).write_text(json.dumps(answer))
sys.exit(any(gate["verdict"] == "FAIL" for gate in answer["gates"]))
"""
GREEN = {"gates": [gate("consistency/oscillator/displacement")]}
SEEN = {"gates": [gate("consistency/oscillator/displacement", "FAIL")]}
UNSTABLE = {"gates": [gate("stability/oscillator/growth", "FAIL")]}
KNOWN = {
    "gates": [*GREEN["gates"], gate("order/oscillator/displacement", measured=4.0)],
    "scorecards": [{"limits": [{"problem": "oscillator", "limit": 1.5734}]}],
}
BOTH = {"gates": [*SEEN["gates"], *UNSTABLE["gates"]]}


@pytest.fixture
def judges(tmp_path):
    """Calls ci/judges on a program that answers as told: (exit status, output, document)."""

    def call(told, *options):
        build = tmp_path / "build"
        (build / "bin").mkdir(parents=True, exist_ok=True)
        (build / "bin/plumbline").write_text(STUB)
        os.chmod(build / "bin/plumbline", 0o755)
        (build / "bin/told.json").write_text(json.dumps(told))
        output = tmp_path / "judges.json"
        command = [sys.executable, "-B", ROOT / "ci/judges", "--no-build", "--build", build, "--output", output, *options]
        done = subprocess.run(command, capture_output=True, text=True, timeout=60)
        return done.returncode, done.stdout + done.stderr, json.loads(output.read_text()) if output.exists() else None

    return call


GOOD = {"musl": GREEN, "right-forest-ruth": KNOWN, "weak-heun2": UNSTABLE, "wrong-nothing": SEEN, "wrong-half": UNSTABLE}


def test_all_is_well(judges):
    status, output, document = judges(GOOD)
    assert status == 0 and "wrong: 2 of 2 red" in output and "FAULT" not in output
    assert [row["integrator"] for row in document["wrong"]] == ["wrong-nothing", "wrong-half"]
    row = document["wrong"][0]
    assert (row["verdict"], row["title"], row["gate"]["id"], row["gate"]["family"]) == ("red", "its defect", "consistency/oscillator/displacement", "consistency")
    assert {row["integrator"]: row.get("known", []) for row in document["right"]}["musl"] == []
    assert [entry["agrees"] for entry in document["right"][1]["known"]] == [True, True]
    assert document["systematic"] is None and document["smallest"] == [] and document["commit"]


@pytest.mark.parametrize(
    "told, what",
    [
        ({"wrong-nothing": GREEN}, "wrong-nothing is not seen"),
        ({"wrong-nothing": {"gates": [gate("identities/sod/mass", "FAIL")]}}, "wrong-nothing is not seen"),
        ({"wrong-nothing": 3}, "wrong-nothing is not seen"),
        ({"weak-heun2": BOTH}, "weak-heun2 is red by consistency, stability: stability is expected"),
        ({"weak-heun2": GREEN}, "weak-heun2 is red by nothing"),
        ({"musl": SEEN}, "musl is red"),
        ({"right-forest-ruth": SEEN}, "right-forest-ruth is red"),
        ({"right-forest-ruth": 2}, "right-forest-ruth is stopped"),
        ({"right-forest-ruth": GREEN}, "order -, known 4"),
    ],
)
def test_each_fault_is_named_and_red(judges, told, what):
    status, output, _ = judges({**GOOD, **told})
    assert status == 1 and f"{what}" in output


def test_why_an_integrator_was_not_judged_is_said(judges):
    _, output, document = judges({**GOOD, "right-forest-ruth": 3})
    assert document["right"][1]["stopped"] == "exit status 3: it cannot step" and "it cannot step" in output


def test_one_in_twenty_may_escape(judges):
    wrong = {f"wrong-{k}": SEEN for k in range(19)}
    assert judges({**wrong, "wrong-none": GREEN})[0] == 0
    assert judges({**wrong, "wrong-none": GREEN, "wrong-other": GREEN})[0] == 1


def test_changes_of_stages_are_counted_by_stage(judges):
    found, twice, mapped, mapped_twice = [change.name for change in systematic.all_changes() if change.integrator == "musl"][:4]
    told = {**GOOD, found: SEEN, twice: GREEN, mapped: GREEN, mapped_twice: GREEN}
    status, output, document = judges(told, "--systematic")
    assert status == 0, output
    assert document["systematic"]["stages"] == {"locate_points": {"changes": 2, "killed": 1, "equivalent": 1, "survived": 0},
                                                "map_mass_and_momentum": {"changes": 2, "killed": 0, "equivalent": 1, "survived": 1}}  # fmt: skip
    assert [row["status"] for row in document["systematic"]["changes"]] == ["killed", "equivalent", "survived", "equivalent"]
    status, output, _ = judges({**told, twice: SEEN}, "--systematic")
    assert status == 1 and f"{twice} is argued to be right, yet it is red" in output


def test_the_smallest_defects_are_a_table(judges):
    status, output, document = judges({**GOOD, "defective": GREEN}, "--smallest")
    assert status == 0, output
    assert document["smallest"] == [{"gate": "consistency/oscillator/displacement", "strain": 1e-3, "force": 1e-3, "motion": 1e-3}]


def test_an_unknown_name_is_a_wrong_call(judges):
    status, output, _ = judges(GOOD, "--only", "wrong-nothin")
    assert status == 2 and "no integrator wrong-nothin" in output


# --- the corpus ---


def test_the_corpus_is_large_enough_and_known():
    text = "".join(path.read_text(encoding="utf-8") for path in (ROOT / "tests/judges").glob("*.cpp"))
    names = systematic.re.findall(r'"((?:wrong|weak|right)-[\w-]+)"', text)
    assert len(set(names)) == len(names)
    right = [name for name in names if name.startswith("right-")]
    assert sum(name.startswith("wrong-") for name in names) >= 30 and len(right) >= 10
    assert sorted(json.loads((ROOT / "tests/judges/known.json").read_text())) == sorted(right)


def test_twelve_are_quick():
    quick = subprocess.run([sys.executable, "-B", "-c", f"import runpy; print(len(runpy.run_path({str(ROOT / 'ci/judges')!r})['QUICK']))"],
                           capture_output=True, text=True)  # fmt: skip
    assert quick.stdout.strip() == "12"
