"""Draws seeded bugs from the sources: operators, constants and comparisons of lines that compute something.

Which lines is a matter of the seed alone. The draws are committed as declarations (tests/mutants/generated.json), so that
they stay the same while the sources change.
"""

import random
import re

SEED = 1997
SWAPS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", " < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ",
         "min(": "max(", "max(": "min("}  # fmt: skip
# `type name = ...;`, `return ...;`, `name op= ...;` on one line: the right side is a whole expression.
DECLARATION = re.compile(r"^\s*(?:const )?(double|int|bool|Pack|Bounded|Vec) \w+ = ([^=].*);(?:\s*//.*)?$")
OTHER = re.compile(r"^\s*(?:return|[\w\[\]\(\).>-]+ [-+*/]?=) ([^={].*);(?:\s*//.*)?$")
CONSTANT = re.compile(r"(?<![\w.\[<])(\d+\.\d+|\d+)(?![\w.\]>])")


def candidates(file, text):
    """(line number, type, expression, changed expression, kind) of every change that the file offers."""
    for number, line in enumerate(text.splitlines(), 1):
        found = DECLARATION.match(line)
        kind_of_type, expression = (found.group(1), found.group(2)) if found else ("", "")
        if not found:
            found = OTHER.match(line)
            expression = found.group(1) if found else ""
        if not expression or not _is_whole(expression) or text.count(line) != 1 or line.count(expression) != 1:
            continue
        for at, old, new, kind in _changes(expression):
            changed = expression[:at] + new + expression[at + len(old) :]
            yield number, kind_of_type, expression, changed, kind


def _is_whole(expression):
    """Balanced, and no comma outside brackets; no texts, lambdas or template arguments that a swap could break."""
    if any(mark in expression for mark in ('"', "'", "[&]", "[=]", "<<", "{", "?", ".data()")):
        return False
    depth = 0
    for sign in expression:
        depth += (sign in "([") - (sign in ")]")
        if depth < 0 or (sign == "," and depth == 0):
            return False
    return depth == 0


def _changes(expression):
    """Changes of numbers, none of where in memory something is read: that would have no outcome of its own."""
    for at, old, new, kind in _all_changes(expression):
        before, after = expression[:at], expression[at + len(old) :]
        in_index = before.count("[") > before.count("]")
        if not in_index and not re.match(r"(p|n|begin)\b|std::ptrdiff_t|static_cast<std::ptrdiff_t", after):
            yield at, old, new, kind


def _all_changes(expression):
    if CONSTANT.fullmatch(expression):
        return
    for old, new in SWAPS.items():
        for found in re.finditer(r"(?<!\w)" + re.escape(old) if old[0] == "m" else re.escape(old), expression):
            yield found.start(), old, new, f"{old.strip(' (')} for {new.strip(' (')}"
    for found in CONSTANT.finditer(expression):
        old = found.group(1)
        new = f"{float(old) * 1.01:.6g}" if "." in old and float(old) else str(int(float(old)) + 1)
        yield found.start(), old, new, "constant"


def draw(sources, shares, taken=(), seed=SEED):
    """Declarations drawn from {group: {file: text}}, `shares[group]` of each, no two on one line.

    `taken`: (file, line) that others have already.
    """
    drawn, used = [], set(taken)
    for group, wanted in shares.items():
        # All lines first, then the change: a line with many operators is no likelier than one with one.
        lines = {}
        for file, text in sorted(sources[group].items()):
            for number, *rest in candidates(file, text):
                lines.setdefault((file, number), []).append(rest)
        chance = random.Random(f"{seed} {group}")
        order = sorted(lines)
        chance.shuffle(order)
        count = 0
        for place in order:
            kind_of_type, expression, changed, kind = chance.choice(lines[place])
            if count == wanted:
                break
            if place in used:
                continue
            used.add(place)
            count += 1
            file, number = place
            line = sources[group][file].splitlines()[number - 1]
            entry = {
                "id": f"{group}-g{count:02d}",
                "kind": kind,
                "file": file,
                "what": f"{expression} becomes {changed}",
                "context": line.strip() if sources[group][file].count(line.strip()) == 1 else line,
                "find": expression,
                "replace": changed,
            }
            if kind_of_type:
                entry["type"] = kind_of_type
            drawn.append(entry)
    return drawn
