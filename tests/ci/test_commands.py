"""ci/report and ci/test: what they call, and the exit status they end with. Every tool they call is a fake that logs."""
import copy
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

CI = Path(__file__).resolve().parents[2] / "ci"


class Tree:
    def __init__(self, root):
        self.root, self.log = root, root / "log"
        (root / "ci").mkdir(parents=True)
        for name in ("report", "test", "sanitize", "common.sh"):
            shutil.copy(CI / name, root / "ci" / name)
        (root / "reports").mkdir()
        (root / "build/release").mkdir(parents=True)
        (root / "build/release/CMakeCache.txt").write_text(f"Python3_EXECUTABLE:FILEPATH={root}/bin/chosen-python\n")
        self.fake("ci/setup")
        self.fake("bin/cmake")
        self.fake("bin/ctest")
        self.program()
        self.fake("bin/chosen-python", "mkdir -p report; echo page > report/index.html")

    def fake(self, name, body="", status=0):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(f'#!{shutil.which("bash")}\necho "{Path(name).name} $*" >> {self.log}\n{body}\nexit {status}\n')
        path.chmod(0o755)

    def program(self, body="", status=0):
        """A program of two integrators; it logs, does as told, and lists them all the same."""
        listed = """[[ $1 != list ]] || { echo '{"integrators": [{"name": "musl"}, {"name": "rk4"}]}'; exit 0; }"""
        self.fake("build/release/bin/plumbline", f"{listed}\n{body}", status)

    def run(self, script, *options, cwd=None):
        environment = {**os.environ, "PATH": f"{self.root}/bin:{os.environ['PATH']}"}
        environment.pop("SUDO_UID", None)
        return subprocess.run([str(self.root / "ci" / script), *options], capture_output=True, text=True, env=environment,
                              cwd=cwd or self.root, stdin=subprocess.DEVNULL, timeout=60)

    def calls(self):
        return self.log.read_text().splitlines()

    def copied(self, root):
        """The same elsewhere; the files are as old as they were, but for those that name their place."""
        shutil.copytree(self.root, root)
        for path in (path for path in root.rglob("*") if path.is_file()):
            text = path.read_text()
            if str(self.root) in text:
                path.write_text(text.replace(str(self.root), str(root)))
        tree = copy.copy(self)
        tree.root, tree.log = root, root / "log"
        return tree


@pytest.fixture
def tree(tmp_path):
    return Tree(tmp_path / "tree")


def without_threads(calls):
    """How many threads there are depends on the machine."""
    return [re.sub(r" --(threads|jobs) [1-9]\d*", "", call) for call in calls]


def bench(tier, points):
    return f"plumbline bench --points {points} --tier {tier} --json results/bench.json"


def cost(tier):
    return f"plumbline bench --cases --tier {tier} --results results --json results/cost.json"


def scorecard(integrator, tier="quick"):
    core = " --core" if tier == "quick" else ""
    return f"plumbline verify --integrator {integrator}{core} --results results"


VERSION = "plumbline --version"   # asked for by every document, which is made again by another program


def stability(tier):
    runs = " --no-runs" if tier == "quick" else ""
    return f"plumbline stability all --maps{runs} --tier {tier} --json results/stability.json"


@pytest.mark.parametrize("command, file", [("bench", "bench.json"), ("stability", "stability.json")])
def test_documents_of_an_earlier_build_are_not_shown(tree, command, file):
    stale = tree.root / "results" / file
    stale.parent.mkdir()
    stale.write_text("{}")
    tree.program(f"[[ $1 != {command} ]] || exit 3")
    result = tree.run("report")
    assert result.returncode == 0 and "(exit status 3)" in result.stdout
    assert not stale.exists() and "chosen-python" in tree.calls()[-1]


def made_documents(tree):
    """The documents that were made since the last time this was asked."""
    made = re.findall(r"--json results/(\w+).json", tree.log.read_text())
    tree.log.unlink()
    return made


@pytest.fixture(scope="module")
def reported(tmp_path_factory):
    """A tree whose program writes documents, after one report."""
    tree = Tree(tmp_path_factory.mktemp("reported") / "tree")
    for source in ("kernel/step.cpp", "cases/catalog/gas/lax.cpp", "cases/catalog/stability/bar.cpp", "cases/catalog/membrane/string.cpp",
                   "cases/catalog/membrane/string.hpp"):
        (tree.root / source).parent.mkdir(parents=True, exist_ok=True)
        (tree.root / source).write_text("code")
    tree.program('echo "printed" ; [[ $* != *--json* ]] || echo "{}" > "${@: -1}"')
    assert tree.run("report").returncode == 0
    assert made_documents(tree) == ["bench", "stability", "cost"]
    return tree


@pytest.fixture
def with_documents(reported, tmp_path):
    """A copy of it, for a test to change."""
    return reported.copied(tmp_path / "tree")


def test_documents_of_the_same_code_are_kept(with_documents):
    assert with_documents.run("report").returncode == 0
    assert made_documents(with_documents) == []


@pytest.mark.parametrize("source, made", [
    ("cases/catalog/gas/lax.cpp", ["cost"]), ("cases/catalog/membrane/string.cpp", ["bench", "stability", "cost"]),
    ("cases/catalog/stability/bar.cpp", ["stability", "cost"]), ("cases/catalog/stability/new.cpp", ["stability", "cost"]),
    ("kernel/step.cpp", ["bench", "stability", "cost"]), ("reports/render.py", [])])
def test_documents_of_other_code_are_made_again(with_documents, source, made):
    (with_documents.root / source).write_text("other code")
    assert with_documents.run("report").returncode == 0
    assert made_documents(with_documents) == made


@pytest.mark.parametrize("change", [lambda file: file.unlink(), lambda file: file.write_text("{ }"), lambda file: file.write_text("")])
def test_document_that_is_not_the_one_made_is_made_again(with_documents, change):
    change(with_documents.root / "results/bench.json")
    assert with_documents.run("report").returncode == 0
    assert made_documents(with_documents) == ["bench"]


def test_documents_of_another_tier_or_program_are_made_again(with_documents):
    assert with_documents.run("report", "--full").returncode == 0
    assert made_documents(with_documents) == ["bench", "stability", "cost"]
    with_documents.program('echo printed; echo "another compiler"; [[ $* != *--json* ]] || echo "{}" > "${@: -1}"')
    assert with_documents.run("report", "--full").returncode == 0
    assert made_documents(with_documents) == ["bench", "stability", "cost"]


CARDS = """case "$*" in "verify --integrator "*) echo "{}" > "results/scorecard-$3.json";; esac"""


def judged(tree):
    """The integrators that were judged since the last time this was asked."""
    names = re.findall(r"verify --integrator (\S+)", tree.log.read_text())
    tree.log.unlink()
    return names


def test_scorecards_are_made_once_and_again_by_other_code(tree):
    (tree.root / "cases").mkdir()
    tree.program(CARDS)
    assert tree.run("report").returncode == 0 and judged(tree) == ["musl", "rk4"]
    assert tree.run("report").returncode == 0 and judged(tree) == []
    (tree.root / "results/scorecard-musl.json").write_text("{ }")
    assert tree.run("report").returncode == 0 and judged(tree) == ["musl"]
    (tree.root / "cases/new.cpp").write_text("other code")
    assert tree.run("report").returncode == 0 and judged(tree) == ["musl", "rk4"]
    assert tree.run("report", "--full").returncode == 0 and judged(tree) == ["musl", "rk4"]


def test_a_red_integrator_ends_red_also_when_its_card_is_kept(tree):
    tree.program(CARDS + """\n[[ "$1 $3" != "verify rk4" ]] || exit 1""")
    for made in (["musl", "rk4"], []):
        result = tree.run("report")
        assert result.returncode == 1 and "not green" in result.stdout and judged(tree) == made
        assert (tree.root / "results/scorecard-rk4.json").exists()


def test_cards_of_integrators_that_are_no_more_are_not_shown(tree):
    folder = tree.root / "results"
    folder.mkdir()
    for name in ("scorecard-gone.json", "scorecard-gone.json.origin", "scorecard-gone.txt", "scorecard-mine.json"):
        (folder / name).write_text("{}")
    assert tree.run("report").returncode == 0
    assert sorted(path.name for path in folder.glob("scorecard-[gm]*")) == ["scorecard-mine.json", "scorecard-musl.txt"]


@pytest.mark.parametrize("folder, name", [("mutants", "mutants"), ("mutants", "draw"), ("judges", "judges")])
def test_what_the_last_night_showed_is_shown_unless_there_is_newer(tree, folder, name):
    kept, own = tree.root / f"tests/{folder}/last/{name}.json", tree.root / f"results/{name}.json"
    kept.parent.mkdir(parents=True)
    kept.write_text("kept")
    assert tree.run("report").returncode == 0 and own.read_text() == "kept"
    own.write_text("own")
    os.utime(kept, (1, 1))
    assert tree.run("report").returncode == 0 and own.read_text() == "own"


def test_report_sets_up_builds_verifies_and_renders(tree, tmp_path):
    result = tree.run("report", cwd=tmp_path)   # from any folder
    assert result.returncode == 0, result.stderr
    names = [call.split()[0] for call in tree.calls()]
    assert names[:3] == ["setup", "cmake", "cmake"]
    assert [call for call in without_threads(tree.calls())[3:] if call != VERSION] == [
        "plumbline sweep --tier quick --results results", "plumbline verify --reuse --tier quick --results results",
        bench("quick", "1e5"), stability("quick"), cost("quick"), "plumbline list --json -", scorecard("musl"), scorecard("rk4"),
        "chosen-python reports/history.py results results/history.jsonl --tier quick",
        "chosen-python -B reports/docs/build.py build/release/bin/plumbline report/docs",
        "chosen-python reports/render.py results report --history results/history.jsonl"]
    assert result.stdout.splitlines()[-1].endswith(f"{tree.root}/report/index.html")


def test_full_report(tree):
    assert tree.run("report", "--full").returncode == 0
    assert "plumbline verify --reuse --tier full --results results" in without_threads(tree.calls())
    assert bench("full", "2e6") in tree.calls() and cost("full") in tree.calls()
    assert stability("full") in without_threads(tree.calls())
    assert scorecard("rk4", "full") in without_threads(tree.calls())


@pytest.mark.parametrize("status", [1, 3, 4])
def test_red_verdict_is_shown_and_ends_red(tree, status):
    tree.program(status=status)
    result = tree.run("report")
    assert result.returncode == status
    assert "not green" in result.stdout
    assert result.stdout.splitlines()[-1].endswith("report/index.html")


@pytest.mark.parametrize("status", [2, 130, 143, 139])
def test_verification_that_did_not_run_makes_no_page(tree, status):
    tree.program(status=status)
    result = tree.run("report")
    assert result.returncode == status
    assert "did not run" in result.stderr and not any("render.py" in call for call in tree.calls())


def test_damaged_results_give_their_status(tree):
    tree.fake("bin/chosen-python", "mkdir -p report; echo page > report/index.html", status=4)
    result = tree.run("report")
    assert result.returncode == 4
    assert "report/index.html" in result.stdout


def test_page_of_an_earlier_run_does_not_pass_for_this_ones(tree):
    assert tree.run("report").returncode == 0
    tree.fake("bin/chosen-python")   # ends well, writes nothing
    result = tree.run("report")
    assert result.returncode != 0 and "no report was written" in result.stderr


@pytest.mark.parametrize("script", ["report", "test"])
@pytest.mark.parametrize("broken", ["ci/setup", "bin/cmake"])
def test_failed_set_up_or_build_ends_at_once(tree, script, broken):
    tree.fake(broken, status=7)
    assert tree.run(script).returncode == 7
    assert not any(call.startswith(("plumbline", "ctest", "chosen-python")) for call in tree.calls())


def test_tests_run_with_their_labels_and_never_none(tree):
    result = tree.run("test")
    assert result.returncode == 0, result.stderr
    (call,) = [call for call in tree.calls() if call.startswith("ctest")]
    for option in ("--label-regex ^(unit|quick|slurm)$", "--no-tests=error", "--output-junit junit.xml", "--test-dir build/release"):
        assert option in call
    tree.run("test", "--full")
    assert "--label-regex" not in tree.calls()[-1]


def test_failed_tests_end_red(tree):
    tree.fake("bin/ctest", status=8)
    assert tree.run("test").returncode == 8


def test_second_compiler_is_installed_for_its_presets(tree):
    for preset in ("clang", "sanitize", "tsan"):
        assert tree.run("test", "--preset", preset).returncode == 0
    setups = [call for call in tree.calls() if call.startswith("setup")]  # with a browser where the system has its package
    assert len(setups) == 3 and all(call.startswith("setup --with clang --with slurm --with vtk --with python") for call in setups)


@pytest.fixture
def sanitized(tree):
    """Programs of which one trips over something in the case noh."""
    for program in ("kernel_test", "reference_test", "cases_test"):
        tree.fake(f"build/sanitize/tests/{program}")
    tree.fake("build/sanitize/bin/plumbline", body="""
case "$1 $2" in
  list*) echo '{"cases": [{"name": "sod"}, {"name": "noh"}, {"name": "sod-3d"}]}' ;;
  "verify noh") echo "SUMMARY: AddressSanitizer: heap-use-after-free gas.cpp:7" > build/sanitize/sanitize/found.42; exit 99 ;;
esac""")
    return tree


def test_sanitizers_run_everything_and_tell_what_they_found(sanitized):
    result = sanitized.run("sanitize", "--only", "address")
    assert result.returncode == 1, result.stderr
    assert "verify-noh: a finding" in result.stdout and "heap-use-after-free gas.cpp:7" in result.stdout
    assert "6 programs run: 1 with findings, 0 ended badly, 0 red" in result.stdout
    verified = [call.split()[2] for call in sanitized.calls() if call.startswith("plumbline verify")]
    assert sorted(verified) == ["noh", "sod", "sod-3d"]  # several at a time
    quiet = sanitized.run("sanitize", "--only", "address", "sod*")
    assert quiet.returncode == 0 and "5 programs run: 0 with findings" in quiet.stdout


def test_sanitizers_end_red_when_a_program_crashes(sanitized):
    sanitized.fake("build/sanitize/tests/cases_test", status=134)
    result = sanitized.run("sanitize", "--only", "address", "sod")
    assert result.returncode == 1 and "cases_test: exit status 134" in result.stdout and "1 ended badly" in result.stdout


@pytest.mark.parametrize("script, options", [("report", ["--fast"]), ("test", ["--fast"]), ("test", ["--preset"]),
                                             ("sanitize", ["--fast"]), ("sanitize", ["--only", "memory"])])
def test_unknown_option_is_refused(tree, script, options):
    assert tree.run(script, *options).returncode == 2
    assert not tree.log.exists()


def test_what_failed_stands_at_the_end(tree):
    """Where a log is cut, its end is what is left: the failed tests' own words, and no word of those that passed."""
    shutil.copy(CI / "failed_tests.py", tree.root / "ci")
    tree.fake("bin/ctest", status=8)
    (tree.root / "build/release/junit.xml").write_text("""<testsuite>
      <testcase name="contract.good" status="run"><system-out>E   not said</system-out></testcase>
      <testcase name="contract.bad" status="fail"><system-out>a line\nE   assert 1 == 2\nFAILED test_bad.py::one</system-out></testcase>
      <testcase name="silent" status="fail"><system-out>it ends\nwith a word</system-out></testcase></testsuite>""")
    done = tree.run("test")
    assert done.returncode == 8 and done.stdout.endswith(
        "== failed: contract.bad\nE   assert 1 == 2\nFAILED test_bad.py::one\n== failed: silent\nit ends\nwith a word\n")
