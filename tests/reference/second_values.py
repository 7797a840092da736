"""Keeps what second computations find: reference/second_values.json, against which the case `second-computations` judges.

A test compares a value of a reference with that of its own computation by `agrees()`. Of each test the first numbers of
each quantity are kept. A run of the tests fails where the file holds other requests than the tests make; with
PLUMBLINE_KEEP_SECOND_VALUES set it writes them instead."""
import json
import os
import pathlib

FILE = pathlib.Path(__file__).parents[2] / "reference" / "second_values.json"
OF_TEST, OF_REQUEST = 12, 4  # of each quantity: the rest says the same again
ROUGH = 0.05  # a number that may be off by more of its size says little: at a front the bound covers both sides
NEAR = 1e-9  # settings are drawn; powers and sines of two libraries differ in the last digits

kept = {}  # by test: entries by request


def agrees(answer, second, within=0):
    """Whether a reference's (value, bound) holds what a second computation found, itself known to `within` (>= 0)."""
    bound, kind = answer[1], type(second)
    _keep(answer, float(second), float(within), float(bound))
    return abs(kind(answer[0]) - second) <= kind(bound) + kind(within)


def is_near(answer, second, tolerance):
    """Whether a reference's value is that of a second computation of the same model, whatever bound it has."""
    _keep(answer, float(second), float(tolerance))
    return abs(type(second)(answer[0]) - second) <= tolerance


def _keep(answer, second, within, bound=0.0):
    if not hasattr(answer, "request") or within + bound > ROUGH * max(abs(second), abs(answer.value)):
        return
    test = os.environ["PYTEST_CURRENT_TEST"].rpartition(" ")[0]
    entries = kept.setdefault(pathlib.Path(test.split("::")[0]).name + "::" + test.split("::", 1)[1], {})
    values = entries.get(answer.request, {})
    of_test = sum(_has(others, answer.name) for others in entries.values())
    if answer.name in values or (of_test < OF_TEST and _has(values, answer.name) < OF_REQUEST):
        entries[answer.request] = {**values, answer.name: [second, within, bound]}


def _has(values, name):
    """How many of the values are of the quantity of `name`, whatever their rows."""
    return sum(one.partition("[")[0] == name.partition("[")[0] for one in values)


def entries_of_this_run():
    made = []
    for test in sorted(kept):
        for request, values in kept[test].items():
            words, _, at = request.partition(" @")
            name, *settings = words.split()
            made.append({"reference": name, "by": test, "at": [float(x) for x in at.split()], "values": values,
                         "settings": {k: float(v) for k, v in (s.split("=") for s in settings)}})
    return made


def stored():
    return json.loads(FILE.read_text()) if FILE.exists() else []


def write(entries):
    lines = ",\n".join(json.dumps(e) for e in sorted(entries, key=lambda e: (e["reference"], e["by"])))
    FILE.write_text(f"[\n{lines}\n]\n")


def _near(a, b):
    return abs(a - b) <= NEAR * max(abs(a), abs(b))


def _same(a, b):
    return (a["reference"] == b["reference"] and list(a["values"]) == list(b["values"])
            and a["settings"].keys() == b["settings"].keys() and len(a["at"]) == len(b["at"])
            and all(_near(a["settings"][k], b["settings"][k]) for k in a["settings"]))


def complaints(tests):
    """Of these tests, what they keep and the file does not, and the other way round."""
    of_file = {}
    for entry in stored():
        of_file.setdefault(entry["by"], []).append(entry)
    of_run = {}
    for entry in entries_of_this_run():
        of_run.setdefault(entry["by"], []).append(entry)
    differ = []
    for test in sorted(tests):
        mine, theirs = of_run.get(test, []), of_file.get(test, [])
        if len(mine) != len(theirs) or not all(any(_same(m, t) for t in theirs) for m in mine):
            differ.append(test)
    return differ
