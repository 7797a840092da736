"""The judges of a run: of the cases and of tests, and what they make of the program without any bug."""

import json
import subprocess

from . import declarations, judges, matrix, overlay, state

JUDGED_BY_TESTS = ("references", "estimators", "reading")
PARTS = ("kernel", "reference", "cases", "parts")  # executables of unit tests
SORTS = ("integrator", "shape", "transfer", "material", "contact")  # of parts that have gates of their own
ENTRIES = ("contract.", "reference.")  # of ctest: files of pytest that drive the program or the references


def tests_wanted(root, mutants):
    return list(dict.fromkeys(test for mutant in mutants for test in tests_on(root, mutant)))


def tests_on(root, mutant):
    """The files of tests that a bug is shown to: those of its source in some areas, and whatever it names itself."""
    own = judges.tests_of(root, mutant.file) if mutant.area in JUDGED_BY_TESTS else []
    return own + [entry["test"] for entry in mutant.killed_by if "test" in entry and entry["test"] not in own]


def case_columns(root, program, prints, names=None):
    listed = subprocess.run([program.plumbline, "list", "--json", "-"], env=program.environment(), capture_output=True)
    cases = [entry["name"] for entry in json.loads(listed.stdout)["cases"]]
    folders = folders_of_cases(root, cases)
    columns = []
    for case in cases:
        if names is None or case in names:
            parts = (*state.EVERYWHERE, state.RECORDED, folders[case])
            columns.append(matrix.Column(judges.CaseJudge(program, case), prints.of(*parts)))
    return columns


def part_columns(program, prints):
    """The gates of all built-in parts of schemes."""
    listed = subprocess.run([program.plumbline, "list", "--json", "-"], env=program.environment(), capture_output=True)
    document, own = json.loads(listed.stdout), prints.of(*state.EVERYWHERE)
    return [matrix.Column(judges.PartJudge(program, sort, entry["name"]), own) for sort in SORTS for entry in document[f"{sort}s"]]


def folders_of_cases(root, cases):
    """Where the sources of a case stand: its folder of the catalog. All of them where none names it."""
    texts = {}
    for path in sorted((root / "cases/catalog").glob("*/*.?pp")):
        texts.setdefault(f"cases/catalog/{path.parent.name}", []).append(path.read_text(encoding="utf-8"))
    texts = {folder: "".join(own) for folder, own in texts.items()}
    return {case: next((folder for folder, text in texts.items() if f'"{case}"' in text), "cases") for case in cases}


def test_columns(root, build, program, prints, tests):
    python = judges.python_of(root / build)
    columns, everything = [], declarations.load(root / "tests/mutants")
    for test in tests:
        if test.endswith(".cpp"):
            own = judges.GoogleTestJudge(program, test)
        else:
            own = judges.PythonTestJudge(python, root, test, program if test.startswith("tests/reference/") else None)
        files = frozenset(mutant.file for mutant in everything if test in tests_on(root, mutant))
        parts = ("kernel", "reference", "cases/harness") if test.endswith(".cpp") else ("reference", "reports")
        columns.append(matrix.Column(own, prints.of(test, *parts), files))
    return columns


def not_dear(own, seconds, root):
    """Those that took no more processor time when the matrix was last made."""
    last = json.loads((root / "tests/mutants/last/mutants.json").read_text(encoding="utf-8"))
    known = {column["name"]: column["seconds"] for column in last["columns"]}
    return [column for column in own if known.get(column.name, 0) <= seconds]


def everything(root, build, program, prints):
    """All tests that take seconds: the executables of unit tests, and what ctest calls a unit test of the whole program."""
    own = [judges.GoogleTestJudge(program, f"tests/{part}", first_only=True) for part in PARTS]
    pairs = {build / "bin/plumbline": program.plumbline, build / "tests/reference/evaluate_reference": program.evaluate}
    pairs |= {build / "lib" / path.name: path for path in program.libraries.glob("*.so*")}
    finished = {str(path): str(switched) for path, switched in pairs.items()}
    own += [judges.EntryJudge(program, entry, finished) for entry in entries_of(build)]
    print_of = prints.of(*state.EVERYWHERE, "cases/catalog", "tests")
    return [matrix.Column(judge, print_of) for judge in own]


def entries_of(build):
    """[{"name", "command", "environment"}] of ctest's entries."""
    listed = subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, text=True, check=True)
    found = []
    for test in json.loads(listed.stdout)["tests"]:
        properties = {entry["name"]: entry["value"] for entry in test.get("properties", ())}
        if test["name"].startswith(ENTRIES) and "unit" in properties.get("LABELS", ()) and "pytest" in test.get("command", ()):
            found.append({"name": test["name"], "command": test["command"], "environment": properties.get("ENVIRONMENT", [])})
    return found


def told_apart(base, red, prints, work, jobs, say):
    """Gates that are red without any bug: those that are green in the finished build, where the compiler fuses products and
    sums, depend on rounding and take no part; the others are an error."""
    columns, finished = {}, overlay.Program(base.build / "bin/plumbline", base.build / "lib")
    for column, _ in red:
        if column.judge.kind == "case":
            own = judges.CaseJudge(finished, column.name)
            columns[column.name] = matrix.Column(own, f"finished {column.fingerprint}")
    fused = matrix.Matrix([], list(columns.values()), state.State(work / "finished.jsonl"), prints)
    fused.judge_clean(jobs, say)
    unsteady, wrong = [], []
    for column, gate in red:
        own = columns[column.name].clean.gates.get(gate, {}) if column.name in columns else {}
        if own.get("verdict", "MISSING") in judges.RED:
            wrong.append(f"{column.name}: {gate} is red without any bug")
        else:
            say(f"{column.name}: {gate} is red where products and sums are not fused; it takes no part")
            unsteady.append((column, gate))
    return unsteady, wrong


def differences(base, work, mutants, table, prints, jobs, dear, say):
    """Where the switched program without a bug is not the plain one, in any bit of what gates read."""
    say("comparing with the plain program, bit for bit")
    program = overlay.build(base, work / "plain", mutants, jobs=jobs, plain=True)
    columns = []
    for column in table.columns:
        if column.judge.kind == "case" and column.clean.seconds <= dear:
            columns.append(matrix.Column(judges.CaseJudge(program, column.name), f"plain {column.fingerprint}"))
    plain = matrix.Matrix(mutants, columns, state.State(work / "plain.jsonl"), prints)
    wrong, _ = plain.judge_clean(jobs, say)
    switched = {column.name: column.clean.gates for column in table.columns}
    return wrong + [f"{c.name}: the switches change its numbers" for c in plain.columns if c.clean.gates != switched[c.name]]
