"""What a call may end with. Everything else is a fault, with the rule that it breaks.

Exit status 0: nothing red, all numbers finite unless the case says that a measure may be undefined, errors below 3 of their
scales, the output whole. 1: red, and a gate, measure or change is named. 2: refused, with key, value and what is allowed. 3: stopped, with step,
point and field. 4: a file, with its path. SIGPIPE where the reader has left, 128 + the signal where one was sent. Never: another
status, a signal, no end, JSON that is not strict UTF-8 JSON of the schema, a partial file, a file of a refused call.
"""
import dataclasses
import os
import re
import signal
from pathlib import Path

import contract

RED = {"FAIL", "XPASS", "INVALID"}
SCALES = 3            # largest error of a green run, in scales of what is measured
SENTINEL = 1e290      # no result of a case is of this size
# What people read who have called a function, not a program; of what a plug-in threw its type is told.
INSIDE = re.compile(r"(?<!threw )(?<!no )std::|terminate called|what\(\)|type_error|parse_error\.|json\.exception|HDF5-DIAG|basic_string|vector::_M|bad_alloc"
                    r"|Assertion|AddressSanitizer|runtime error:|\bstod\b|\bstoi\b|bad optional|bad variant|filesystem error: ")
DEFINITIONS = {"run", "converge", "verify", "reference", "stability", "bench", "sweep", "export", "score", "scoreboard", "diff", "tolerances",
               "list", "explain"}
ENDED_BY_SIGNAL = 128
ANSWER = 3.0          # s from a signal to the end: one, and what a busy machine adds


@dataclasses.dataclass(frozen=True)
class Fault:
    rule: str
    text: str


def faults(outcome, catalog):
    """All rules that an outcome breaks."""
    found = list(of_status(outcome))
    if not found:
        found = [*of_text(outcome, catalog), *of_files(outcome), *of_document(outcome, catalog)]
    return found


def of_status(outcome):
    call, code = outcome.call, outcome.code
    if outcome.late:
        yield Fault("hang", f"{outcome.late}: {outcome.seconds:.0f} s on the clock, estimate {call.estimate:.2g} s")
    elif code == -signal.SIGPIPE and call.stdout == "gone":
        pass
    elif call.interrupted and not outcome.heard and code == -call.interrupted[0] and not (outcome.err or outcome.out or outcome.new):
        pass  # it came before the program had begun
    elif code < 0:
        yield Fault("crash", f"ended by signal {signal.Signals(-code).name}: {last_line(outcome)}")
    elif call.interrupted and code == ENDED_BY_SIGNAL + call.interrupted[0]:
        if outcome.answered > ANSWER * max(1.0, os.getloadavg()[0] / os.cpu_count()):
            yield Fault("signal", f"ended {outcome.answered:.1f} s after {call.interrupted[0].name}")
    elif code not in (0, 1, 2, 3, 4):
        yield Fault("status", f"exit status {code}: {last_line(outcome)}")
    elif code not in call.statuses:
        yield Fault("expected", f"exit status {code}, and not {' or '.join(map(str, call.statuses))}{': ' + call.why if call.why else ''}"
                                f": {last_line(outcome)}")


def last_line(outcome):
    lines = [line for line in outcome.err.decode("utf-8", "replace").splitlines() if line.strip()]
    return lines[-1][:400] if lines else "nothing said"


def of_text(outcome, catalog):
    call = outcome.call
    for name, raw in (("standard output", outcome.out), ("standard error", outcome.err)):
        try:
            raw.decode("utf-8")
        except UnicodeDecodeError as error:
            yield Fault("text", f"{name} is not UTF-8: {error}")
    if found := INSIDE.search(outcome.text):
        at = outcome.text[max(0, found.start() - 80):found.end() + 120].replace("\n", " | ")
        yield Fault("text", f"words of a library: {at}")
    if outcome.code in (1, 2, 3, 4) and not (outcome.err or outcome.out) and call.stdout == "pipe":
        yield Fault("text", f"exit status {outcome.code} and nothing said")
    if outcome.code == 0 and call.stdout == "full":
        yield Fault("lost output", "exit status 0 though standard output has no space")
    if outcome.code == 0 and call.stdout == "pipe" and not outcome.out.strip():
        yield Fault("lost output", "exit status 0 and nothing on standard output")
    if outcome.code == 4 and not names_a_path(outcome):
        yield Fault("file error", f"no path is named: {last_line(outcome)}")
    if outcome.code == 0 and call.command in ("run", "converge", "verify", "score", "stability") and not call.json:
        undefined = set().union(*(catalog.may_be_undefined(word) for word in call.arguments if isinstance(word, str)))
        for found in re.finditer(r"^\W*(\S*).*(?<![\w.])-?(nan|inf)(?![\w)]).*$", outcome.out.decode("utf-8", "replace"), re.M):
            if found[1] not in undefined:
                yield Fault("not finite", f"on a green page: {found[0].strip()[:200]}")
                break


def names_a_path(outcome):
    """An argument of the call, what one of its files is called, or anything with a slash or an ending."""
    said = outcome.text
    words = [word for word in outcome.call.arguments[1:] if isinstance(word, str) and len(word) > 1]
    return any(word in said for word in words) or any(Path(name).name in said for name in outcome.before) or "/" in said \
        or "standard output" in said


def of_files(outcome):
    call = outcome.call
    parts = [name for name in outcome.new if name.endswith(".part") or "/tmp" in name]
    if parts:
        yield Fault("leftover", f"partial files: {', '.join(parts[:3])}")
    new = [name for name in outcome.new if name not in parts]
    if outcome.code == 2 and new:
        yield Fault("leftover", f"refused, and written: {', '.join(new[:3])}")
    target = call.option("--json")
    if outcome.code in (0, 1, 3) and isinstance(target, str) and target not in ("", "-") and not os.path.exists(outcome.folder / target):
        yield Fault("lost output", f"--json {target} is not there")
    if outcome.code == 0 and call.command == "run" and not {"--dry-run", "--help"} & set(call.arguments):
        if not any(name.endswith(".h5") and what[0] == "file" for name, what in outcome.after.items()):
            yield Fault("lost output", "no result file")


# --- the document -----------------------------------------------------------------------------------


def document(outcome):
    """The JSON document of a call, or nothing where it has none; AssertionError or ValueError where it is none."""
    call, raw = outcome.call, None
    if call.json and call.stdout == "pipe":
        raw = outcome.out
    elif isinstance(target := call.option("--json"), str) and target not in ("", "-") and outcome.code in (0, 1, 3):
        path = outcome.folder / target
        raw = path.read_bytes() if os.path.isfile(path) else None
    return None if raw is None else contract.parse(raw.decode("utf-8"))


def of_document(outcome, catalog):
    call = outcome.call
    try:
        said = document(outcome)
    except (AssertionError, ValueError) as error:
        yield Fault("json", f"exit status {outcome.code}, {str(error)[:200]}: {last_line(outcome)}")
        return
    if said is None:
        return
    try:
        contract.validate(definition_of(call, said), said)
    except AssertionError as error:
        yield Fault("schema", str(error)[:400])
        return
    if outcome.code in (2, 4) or "error" in said:
        yield from of_refusal(outcome, said)
    elif outcome.code == 3:
        yield from of_stop(outcome, said)
    elif outcome.code == 1:
        yield from of_red(outcome, said)
    else:
        yield from of_green(outcome, said, catalog)
    if call.command == "run" and outcome.code != 2:
        yield from of_settings(call, said)


def definition_of(call, said):
    """Of the schema."""
    if isinstance(said, dict) and "error" in said:
        return "error"
    if call.command == "sweep" and "--plan" in call.arguments:
        return "plan"
    return "dry_run" if "--dry-run" in call.arguments else call.command


def of_refusal(outcome, said):
    if "error" not in said:
        if outcome.code == 2:
            yield Fault("refusal", f"exit status 2 and no error in the document: {last_line(outcome)}")
        return
    error = said["error"]
    if outcome.code in (0, 1):
        yield Fault("refusal", f"an error in the document and exit status {outcome.code}")
    if outcome.code in (2, 3) and not error["key"]:
        yield Fault("refusal", f"no key is named: {error['message'][:200]}")
    elif outcome.code == 2 and error["value"] is None and not error["allowed"] and not error["nearest"]:
        yield Fault("refusal", f"neither value nor what is allowed: {error['message'][:200]}")


def of_stop(outcome, said):
    stops = [item["stop"] for item in all_objects(said) if isinstance(item.get("stop"), dict)]
    named = [stop for stop in stops if stop.get("field") and stop.get("step") is not None and stop.get("point") is not None]
    if not named and outcome.call.command in ("run", "converge", "sweep"):
        yield Fault("stop", f"no step, point and field: {stops[:1] or last_line(outcome)}")


def of_red(outcome, said):
    red = [item for item in all_objects(said) if item.get("verdict") in RED | {"INCONCLUSIVE"} or ("start" in item and item.get("reason"))]
    named = [item for item in red if item.get("id") or item.get("measure") or item.get("name") or item.get("start")]
    if outcome.call.command in ("run", "converge", "verify", "score", "scoreboard", "stability") and not named:
        yield Fault("red", f"exit status 1 and no red verdict that names a gate: {last_line(outcome)}")


def of_green(outcome, said, catalog):
    call = outcome.call
    undefined = undefined_measures(said, catalog)
    expected_failures = any(item.get("verdict") in ("XFAIL", "NONE") for item in all_objects(said))
    for item in all_objects(said):
        if item.get("verdict") in RED and "--allow" not in call.arguments:
            yield Fault("green", f"exit status 0 beside {item['verdict']} of {item.get('id', item.get('name'))}")
            return
        if item.get("verdict") == "PASS" and "measured" in item and item["measured"] is None:
            yield Fault("not finite", f"gate {item.get('id')} passed without a number")
            return
    # A sweep makes runs, and says no verdict: `verify --reuse` does.
    for name, measure in measures(said) if call.command != "sweep" else ():
        if name in undefined:
            continue
        # What is compared with nothing, or with less than the reference's bound, has no scale and no relative error.
        if measure["error"] is None:
            yield Fault("not finite", f"measure {name}: {short(measure)}")
            return
        told = measure.get("value") is not None and measure.get("reference") is None  # a count, with nothing to compare it with
        if (measure.get("relative_error") or 0) > SCALES and not told and not expected_failures:
            yield Fault("large error", f"measure {name}: {short(measure)}")
            return
    if large := next((number for number in numbers(without(said, "settings", "parameters")) if abs(number) >= SENTINEL), None):
        asked = any(re.search(r"=-?[0-9.]+e\+?[23][0-9][0-9]$", str(word)) for word in call.arguments)  # so large a choice gives such numbers
        if not asked and call.command not in ("list", "explain", "diff", "tolerances", "sweep", "reference"):
            yield Fault("not finite", f"a number of size {large:g}")


def of_settings(call, said):
    """Every choice that was asked for is the choice that was made."""
    asked = [word.split("=", 1) for option, word in zip(call.arguments, call.arguments[1:]) if option == "--set" and isinstance(word, str)]
    asked += [["cells", word] for option, word in zip(call.arguments, call.arguments[1:]) if option == "--cells"]
    asked += [["integrator", word] for option, word in zip(call.arguments, call.arguments[1:]) if option == "--integrator"]
    for key, *value in asked:
        used = said.get("settings", {}).get(key.strip(), ())
        if value and used != () and not same_value(value[0], used):
            yield Fault("settings", f"{key} = {value[0][:60]} was asked for, {used} was used")


def same_value(typed, used):
    if used is None:
        return typed.strip() in ("none", "auto")
    if isinstance(used, str):
        return typed.strip() == used
    try:
        return abs(float(typed) - used) <= 1e-12 * abs(used)
    except ValueError:
        return typed.strip() == "auto"


def undefined_measures(said, catalog):
    cases = {item["case"] for item in all_objects(said) if isinstance(item.get("case"), str)}
    return set().union(*(catalog.may_be_undefined(case) for case in cases)) if cases else set()


def all_objects(value):
    if isinstance(value, dict):
        yield value
        value = list(value.values())
    if isinstance(value, list):
        for item in value:
            yield from all_objects(item)


def measures(said):
    for item in all_objects(said):
        group = item.get("measures")
        if isinstance(group, dict):
            yield from ((name, measure) for name, measure in group.items() if isinstance(measure, dict) and "error" in measure)


def numbers(value):
    if isinstance(value, dict):
        value = list(value.values())
    if isinstance(value, list):
        for item in value:
            yield from numbers(item)
    elif isinstance(value, float):
        yield value


def without(value, *keys):
    if isinstance(value, dict):
        return {key: without(item, *keys) for key, item in value.items() if key not in keys}
    return [without(item, *keys) for item in value] if isinstance(value, list) else value


def short(measure):
    return ", ".join(f"{key} {value:.4g}" if isinstance(value, float) else f"{key} {value}" for key, value in measure.items())


# --- two outcomes -----------------------------------------------------------------------------------


def difference(one, other):
    """Why two documents that are to be the same to the bit are not: the first place, or nothing."""
    return first_difference(contract.without_volatile(one), contract.without_volatile(other), "")


def first_difference(one, other, place):
    if isinstance(one, dict) and isinstance(other, dict):
        if one.keys() != other.keys():
            return f"{place}: {sorted(one.keys() ^ other.keys())}"
        return next((found for key in one if (found := first_difference(one[key], other[key], f"{place}/{key}"))), "")
    if isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        return next((found for k, (a, b) in enumerate(zip(one, other)) if (found := first_difference(a, b, f"{place}/{k}"))), "")
    return "" if one == other and type(one) is type(other) else f"{place}: {str(one)[:80]} and {str(other)[:80]}"
