"""What may kill a bug: the gates of a case, a file of unit tests, the report's own tests.

A judge runs the program once, for one bug or for none, and says which verdicts came out. All runs are bounded in processor
time by what the clean one took: other programs on the machine change nothing.
"""

import ctypes
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import xml.etree.ElementTree
from dataclasses import dataclass, field

RED = ("FAIL", "INVALID", "XPASS", "INCONCLUSIVE", "MISSING")
SLOWER = 5  # times the clean processor time, and these seconds more
MORE_SECONDS = 5
IDLE_SECONDS = 120  # of the clock without one tick of the processor: waits for something that does not come
PR_SET_PDEATHSIG = 1  # of <linux/prctl.h>
LIBC = ctypes.CDLL(None)


@dataclass
class Outcome:
    """Of one run. gates: {id: {"verdict", "origin", "numbers"}}; stopped: why it did not come to its end."""

    gates: dict = field(default_factory=dict)
    stopped: str = ""
    seconds: float = 0  # of the processor
    reached: list = field(default_factory=list)  # numbers of the switches it met, where it ran with none set


def limit_of(clean_seconds):
    return SLOWER * clean_seconds + MORE_SECONDS


def end_with_parent():
    """This process is killed as soon as the one that started it ends, however that ends."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGKILL)


def run(command, environment, seconds, cwd=None):
    """(exit status, output, processor seconds, why it was stopped)."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)

    def bound():
        end_with_parent()
        whole = int(seconds) + 1
        resource.setrlimit(resource.RLIMIT_CPU, (whole, whole + 2))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    child = subprocess.Popen(
        [str(word) for word in command],
        env=environment,
        cwd=cwd,
        preexec_fn=bound,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
        start_new_session=True,
    )
    why = ""
    try:
        while True:
            busy = _busy(child.pid)
            try:
                output, _ = child.communicate(timeout=IDLE_SECONDS)
                break
            except subprocess.TimeoutExpired:
                # The processor bounds what runs, however slowly; one that somebody halted may go on. Left is what waits in vain.
                if busy == _busy(child.pid) and _state(child.pid) == "S":
                    why = "time"
                    os.killpg(child.pid, signal.SIGKILL)
    except BaseException:
        os.killpg(child.pid, signal.SIGKILL)
        raise
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    spent = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    if child.returncode < 0 and not why:
        name = signal.Signals(-child.returncode).name
        why = "time" if name in ("SIGXCPU", "SIGKILL") else name
    return child.returncode, output, spent, why


def _stat(pid):
    try:
        return pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    except (OSError, IndexError):
        return []


def _state(pid):
    return (_stat(pid) or ["?"])[0]


def _busy(pid):
    """Ticks of the processor that a process and its finished children had."""
    return sum(int(ticks) for ticks in _stat(pid)[11:15])


class Judge:
    """name: column of the table; cost: processor seconds of the clean run, once it is known."""

    kind = "case"

    def __init__(self, name):
        self.name = name

    def judge(self, mutant, clean):
        """The outcome with this bug; mutant None: the clean program, clean None: not known yet."""
        raise NotImplementedError

    def _run(self, program, command, mutant, clean, folder, more=None):
        reached = pathlib.Path(folder) / "reached"
        environment = program.environment(**(more or {}), PLUMBLINE_MUTANT=str(mutant.number if mutant else -1))
        environment["PLUMBLINE_REACHED"] = str(reached)
        status, output, seconds, why = run(command, environment, limit_of(clean.seconds) if clean else 3600, cwd=folder)
        numbers = sorted({int(n) for n in reached.read_text().split()}) if reached.exists() else []
        return status, output, Outcome({}, why, seconds, numbers)


class CaseJudge(Judge):
    """`plumbline verify CASE`: all gates of a case."""

    def __init__(self, program, case, tier="quick"):
        super().__init__(case)
        self.program, self.selection = program, [case, "--tier", tier]

    def judge(self, mutant, clean):
        with tempfile.TemporaryDirectory(prefix="plumbline-mutant-") as folder:
            command = [self.program.plumbline, "verify", *self.selection, "--threads", "1"]
            command += ["--results", "results", "--json", "verdicts.json"]
            status, output, outcome = self._run(self.program, command, mutant, clean, folder)
            document = pathlib.Path(folder) / "verdicts.json"
            if not outcome.stopped and (status not in (0, 1) or not document.exists()):
                outcome.stopped = f"exit status {status}"
            if document.exists() and not outcome.stopped:
                outcome.gates = gates_of(json.loads(document.read_text(encoding="utf-8")))
        if status == 1 and not outcome.stopped and not any(g["verdict"] in RED for g in outcome.gates.values()):
            outcome.stopped = "exit status 1 without a red gate"
        return outcome


class PartJudge(CaseJudge):
    """`plumbline verify --shape NAME` and the like: the gates of a part of a scheme, those of an integrator that take seconds."""

    kind = "part"

    def __init__(self, program, sort, name):
        super().__init__(program, f"{sort} {name}")
        self.selection = [f"--{sort}", name, *(["--core"] if sort == "integrator" else [])]


def gates_of(document):
    gates = {}
    for gate in document["gates"]:
        name, count = f"{gate['id']}", 2
        while name in gates:
            name, count = f"{gate['id']} ({count})", count + 1
        numbers = [gate.get("measured"), *(gate.get("interval") or []), gate.get("margin")]
        gates[name] = {"verdict": gate["verdict"], "origin": gate["origin"], "numbers": numbers}
    return gates


class GoogleTestJudge(Judge):
    """An executable of unit tests. first_only: a bug ends it at the first red test."""

    kind = "tests"

    def __init__(self, program, path, first_only=False):
        super().__init__(path)
        self.program, self.first_only = program, first_only

    def judge(self, mutant, clean):
        with tempfile.TemporaryDirectory(prefix="plumbline-mutant-") as folder:
            command = [self.program.tests[self.name], "--gtest_output=json:tests.json", "--gtest_brief=1"]
            if self.first_only and mutant:
                command.append("--gtest_fail_fast")
            status, _, outcome = self._run(self.program, command, mutant, clean, folder)
            document = pathlib.Path(folder) / "tests.json"
            if document.exists():
                suites = json.loads(document.read_text(encoding="utf-8"))["testsuites"]
                for test in (t for suite in suites for t in suite["testsuite"] if t["status"] == "RUN"):
                    verdict = "FAIL" if test.get("failures") else "PASS"
                    outcome.gates[f"{test['classname']}.{test['name']}"] = {"verdict": verdict, "origin": "test", "numbers": []}
            elif not outcome.stopped:
                outcome.stopped = f"exit status {status}"
        return outcome


class PythonTestJudge(Judge):
    """A file of pytest. Bugs of the program it drives are switched on; those of Python sources stand in a copy."""

    kind = "tests"

    def __init__(self, python, root, path, program=None):
        super().__init__(path)
        self.python, self.root, self.program = python, pathlib.Path(root), program

    def judge(self, mutant, clean):
        with tempfile.TemporaryDirectory(prefix="plumbline-mutant-") as folder:
            folder = pathlib.Path(folder)
            for part in ("reports", "tests/reports", "tests/reference"):
                shutil.copytree(self.root / part, folder / part, ignore=shutil.ignore_patterns("__pycache__"))
            if mutant and not mutant.compiled:
                target = folder / mutant.file
                target.write_text(mutant.applied(target.read_text(encoding="utf-8")), encoding="utf-8")
            environment = {k: v for k, v in os.environ.items() if not k.startswith("PLUMBLINE_")}
            reached = folder / "reached"
            if self.program:
                environment = self.program.environment(PLUMBLINE_EVALUATE_REFERENCE=str(self.program.evaluate))
                environment["PLUMBLINE_MUTANT"] = str(mutant.number if mutant else -1)
                environment["PLUMBLINE_REACHED"] = str(reached)
            command = [self.python, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider", "--junitxml=tests.xml", self.name]
            seconds = limit_of(clean.seconds) if clean else 3600
            status, _, spent, why = run(command, environment, seconds, cwd=folder)
            numbers = sorted({int(n) for n in reached.read_text().split()}) if reached.exists() else []
            outcome = Outcome({}, why, spent, numbers)
            read_tests(folder / "tests.xml", status, outcome)
        return outcome


def read_tests(document, status, outcome):
    """What pytest wrote, into the outcome."""
    if document.exists() and not outcome.stopped:
        for test in xml.etree.ElementTree.parse(document).iter("testcase"):
            bad = test.find("failure") is not None or test.find("error") is not None
            verdict = "FAIL" if bad else "PASS"
            outcome.gates[test.get("name")] = {"verdict": verdict, "origin": "test", "numbers": []}
    if not outcome.gates and not outcome.stopped:
        outcome.stopped = f"exit status {status}"


class EntryJudge(Judge):
    """A file of pytest as ctest runs it, with the switched program in the place of the finished one; ends at the first red."""

    kind = "tests"

    def __init__(self, program, entry, finished):
        super().__init__(entry["name"])
        self.program, self.command = program, [*entry["command"], "-x", "--junitxml=tests.xml"]
        self.more = {}
        for variable in entry["environment"]:
            name, value = variable.split("=", 1)
            self.more[name] = finished.get(value, value)

    def judge(self, mutant, clean):
        with tempfile.TemporaryDirectory(prefix="plumbline-mutant-") as folder:
            status, _, outcome = self._run(self.program, self.command, mutant, clean, folder, self.more)
            read_tests(pathlib.Path(folder) / "tests.xml", status, outcome)
        return outcome


def red_gates(clean, outcome):
    """[{"gate", "origin", "verdict"}] that were green in the clean run and are red now."""
    red = []
    for name, gate in clean.gates.items():
        if gate["verdict"] in RED:
            continue
        now = outcome.gates.get(name, {}).get("verdict", "MISSING")
        if now in RED:
            red.append({"gate": name, "origin": gate["origin"], "verdict": now})
    return red


def tests_of(root, file):
    """The files of tests that mirror a source; of one without any those of the sources beside it that include it."""
    root, path = pathlib.Path(root), pathlib.Path(file)
    if path.suffix == ".py":
        return [str(p.relative_to(root)) for p in [root / "tests/reports" / f"test_{path.stem}.py"] if p.exists()]
    found = _mirrors(root, path)
    if found:
        return found
    header = f'#include "{path.with_suffix(".hpp")}"'
    nearby = [p.relative_to(root) for p in sorted((root / path.parent).glob("*.?pp")) if header in p.read_text()]
    for includer in nearby:
        found += [test for test in _mirrors(root, includer) if test not in found]
    folder = root / "tests" / path.parent
    return found or [str(p.relative_to(root)) for p in sorted(folder.glob(f"{path.parent.name}_test.cpp"))]


def _mirrors(root, path):
    """Also second computations and bounds in Python, by the name of the source."""
    names = [f"{path.stem}_test.cpp", f"{path.stem}_bounds_test.py", f"{path.stem}_second_test.py"]
    places = [root / "tests" / path.parent / name for name in names]
    return [str(p.relative_to(root)) for p in places if p.exists()]


def python_of(build):
    """The interpreter that the build found."""
    text = (pathlib.Path(build) / "CMakeCache.txt").read_text()
    return re.search(r"^Python3_EXECUTABLE:[^=]*=(.+)$", text, re.MULTILINE).group(1)
