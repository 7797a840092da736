"""Wrong integrators made from the built-in ones: of every call of a stage, each number or state given to it times 0.999 and times
1.001, what it returns likewise, and the call left out or made twice. (What a call returns is left out as zero; asked for twice it
is the same, which is no change.)

    python3 systematic.py kernel/integrators/musl.cpp OUTPUT.cpp

writes a source with all changes of one integrator as switches, and registers each of them as an integrator of its own. Without a
change the code is what it was: numbers times one, calls made once. Needs the standard library only.
"""

import pathlib
import re
import sys
from dataclasses import dataclass

ROOT = pathlib.Path(__file__).resolve().parents[2]
SOURCES = "kernel/integrators"
PREFIX = "systematic"
# Calls with a value: how it is wrapped, and the changes of it. What velocities_of is given says all about what it returns.
VALUES = {
    "state": ("scaled", ("x0.999", "x1.001", "left-out")),
    "rate": ("scaled", ("x0.999", "x1.001", "left-out")),
    "velocities_of": ("kept", ("left-out",)),
    "reverse_cooling": ("answer", ("left-out", "doubled")),
}

HEADER = """// Made by ci/judging/systematic.py from {source}.
#include "tests/judges/switched.hpp"

"""


@dataclass(frozen=True)
class Change:
    """One change of one call of a stage: of its k-th number, of its value, or of the call itself."""

    integrator: str  # the built-in one
    number: int  # in its file, from one
    stage: str
    call: int  # which call of a stage in its file, from one
    line: int
    what: str  # "argument 1", "value" or "call"
    kind: str  # x0.999, x1.001, left-out or doubled

    @property
    def name(self):
        """As an integrator; also the key of what is argued in tests/judges/equivalent.json."""
        place = {"call": "", "value": "-value"}.get(self.what, "-" + self.what.replace("argument ", "arg"))
        return f"{PREFIX}-{self.integrator}-{self.call:02}-{self.stage}{place}-{self.kind}"

    @property
    def title(self):
        of = {"call": "", "value": "what it returns, "}.get(self.what, f"{self.what}, ")
        kind = self.kind.replace("x", "times ").replace("left-out", "left out")
        return f"{self.integrator}, call {self.call} ({self.stage}): {of}{kind}"


@dataclass
class Call:
    """mpm.stage(...) in a source: [begin, end) with its arguments as spans."""

    stage: str
    begin: int
    end: int
    arguments: list
    statement: bool


def without_comments(text):
    """The same length: what stands in comments becomes blanks."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", lambda found: re.sub(r"[^\n]", " ", found[0]), text, flags=re.DOTALL)


def calls(text):
    """All calls of stages, by where they begin; one may stand in an argument of another."""
    code = without_comments(text)
    found = []
    for match in re.finditer(r"\bmpm\.(\w+)\(", code):
        arguments, end = _arguments(code, match.end())
        before, after = code[: match.start()].rstrip(), code[end:].lstrip()
        statement = before[-1] in ";{}" and after.startswith(";")
        found.append(Call(match[1], match.start(), end, arguments, statement))
    return found


def _arguments(code, begin):
    """Spans between the top-level commas of a parenthesis that was opened before `begin`, and where it ends."""
    spans, depth, start = [], 1, begin
    for k in range(begin, len(code)):
        if code[k] in "({[":
            depth += 1
        elif code[k] in ")}]":
            depth -= 1
        if depth == 0 or (depth == 1 and code[k] == ","):
            if code[start:k].strip():
                spans.append((start, k))
            start = k + 1
        if depth == 0:
            return spans, k + 1
    raise ValueError(f"a parenthesis is not closed: {code[begin:begin + 60]!r}")


def name_of(text):
    """(class, name) of the integrator that a source registers."""
    found = re.findall(r'PLUMBLINE_INTEGRATOR\(\s*(\w+),\s*"([^"]+)"', text)
    if len(found) != 1:
        raise ValueError(f"registers {len(found)} integrators, not one")
    return found[0]


def changes(text):
    """All changes of a source, in its order."""
    _, integrator = name_of(text)
    found = []

    def add(stage, call, line, what, kinds):
        for kind in kinds:
            found.append(Change(integrator, len(found) + 1, stage, call, line, what, kind))

    for number, call in enumerate(calls(text), 1):
        line = text.count("\n", 0, call.begin) + 1
        for k in _numeric(text, call):
            add(call.stage, number, line, f"argument {k + 1}", ("x0.999", "x1.001"))
        _, kinds = VALUES.get(call.stage, ("", ("left-out", "doubled")))
        add(call.stage, number, line, "value" if kinds[0] != "left-out" else "call", kinds)
    return found


def _numeric(text, call):
    """Which arguments are numbers or states, and not what another call returns, which is changed there."""
    given = [text[begin:end].strip() for begin, end in call.arguments]
    return [k for k, what in enumerate(given) if not what.startswith(("NodalVelocity::", "mpm."))]


def switched(text):
    """The source with all its changes as switches."""
    own = changes(text)
    edits = []  # (position, place among those of one position, text put in)
    for number, call in enumerate(calls(text), 1):
        mine = [change for change in own if change.call == number]
        for k in _numeric(text, call):
            first = next(change.number for change in mine if change.what == f"argument {k + 1}")
            begin, end = call.arguments[k]
            edits.append((begin, 0, f"switched::factor({first}) * ("))
            edits.append((end, 1, ")"))
        first = next(change.number for change in mine if change.what in ("call", "value"))
        if call.stage in VALUES:
            edits.append((call.begin, 1, f"switched::{VALUES[call.stage][0]}({first}, [&] {{ return "))
            edits.append((call.end, 0, "; })"))
        elif call.statement:
            edits.append((call.begin, 0, f"for (int left = switched::repeats({first}); left > 0; --left) "))
        else:
            raise ValueError(f"{call.stage} stands in an expression, and nothing is known of its value")
    for position, _, inserted in sorted(edits, key=lambda edit: edit[:2], reverse=True):
        text = text[:position] + inserted + text[position:]
    return text


def source(path):
    """What is compiled: the switched class, open to be derived from, and an integrator for each change."""
    text = path.read_text(encoding="utf-8")
    kind, _ = name_of(text)
    own = changes(text)
    text = switched(text)
    text, opened = re.subn(rf"class {kind} final : public (\w+) {{", rf"class {kind} : public \1 {{\n public:", text)
    if opened != 1:
        raise ValueError(f"class {kind} is not declared as other integrators are")
    text = re.sub(r"PLUMBLINE_INTEGRATOR\(.*?\);", lambda _: registration(kind, own), text, count=1, flags=re.DOTALL)
    return HEADER.format(source=f"{SOURCES}/{path.name}") + text


def registration(kind, own):
    rows = "".join(f'    {{{change.number}, "{change.name}", "{change.title}"}},\n' for change in own)
    return f"const switched::Registered<{kind}> changes{{{{\n{rows}}}}};"


def built_in():
    """The sources of the built-in integrators."""
    return sorted((ROOT / SOURCES).glob("*.cpp"))


def all_changes():
    return [change for path in built_in() for change in changes(path.read_text(encoding="utf-8"))]


def main(arguments):
    path, output = map(pathlib.Path, arguments)
    try:
        text = source(path)
    except ValueError as error:
        print(f"systematic.py: {path}: {error}", file=sys.stderr)
        return 1
    output.parent.mkdir(parents=True, exist_ok=True)
    output.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
