"""Seeded bugs as they are declared in tests/mutants/*.json, and what they make of a source file.

A declaration is {"area", "origin": "declared" or "generated", "mutants": [...]}, without an area where the file of each says
it; a mutant
    id, kind, file, what     name, sort of bug, source file, one line for people
    find, replace            the text and what the bug makes of it; `find` occurs once in `context` (or in the file)
    context                  text that occurs once in the file and holds `find`; `find` itself if left out
    wrap                     "expression" (default) and "statement": both texts stand in the program, chosen when it runs;
                             "text": replaced as it stands (files that are not compiled); of drawn ones also "factor" (of a
                             number) and "skip" (of a pass of a loop)
    type                     of an expression whose two forms have different types; the factor; when the pass is left out
    at                       where `find` stands, in characters: of drawn ones, which hold for their commit alone
    killed_by                [{"case", "gate"} or {"test"}]: those that must turn red on it
    equivalent               why no gate could: the program does the same
    quick                    belongs to the subset that the tests of a change run; its file is no header
"""

import json
import pathlib
import re
from dataclasses import dataclass, field

WRAPS = ("expression", "statement", "text", "factor", "skip")
KNOWN = {"id", "kind", "file", "what", "find", "replace", "context", "wrap", "type", "at", "killed_by", "equivalent", "quick"}


AREAS = (
    ("reference/", "references"),
    ("kernel/materials/", "materials"),
    ("kernel/contact/", "contact"),
    ("kernel/walls", "walls"),
    ("kernel/pistons", "walls"),
    ("kernel/", "kernel"),
    ("cases/", "estimators"),
    ("reports/", "reading"),
)


class DeclarationError(Exception):
    """A declaration that is incomplete or does not fit its source; the text names the mutant."""


@dataclass
class Mutant:
    id: str
    kind: str
    file: str
    what: str
    find: str
    replace: str
    area: str
    origin: str
    context: str = ""
    wrap: str = "expression"
    type: str = ""
    killed_by: list = field(default_factory=list)
    equivalent: str = ""
    quick: bool = False
    at: int = -1
    number: int = 0  # what PLUMBLINE_MUTANT is set to; 0 is no mutant

    @property
    def compiled(self):
        return self.wrap != "text"

    def place(self, text):
        """(start, end) of `find` in the file's text."""
        if self.at >= 0:
            if not text.startswith(self.find, self.at):
                raise DeclarationError(f"{self.id}: {self.file} is not as it was when the bug was drawn; check out that commit")
            return self.at, self.at + len(self.find)
        context = self.context or self.find
        if text.count(context) != 1:
            raise DeclarationError(f"{self.id}: {self.file} holds its text {text.count(context)} times, not once")
        if context.count(self.find) != 1:
            raise DeclarationError(f"{self.id}: its context holds what to find {context.count(self.find)} times, not once")
        start = text.index(context) + context.index(self.find)
        return start, start + len(self.find)

    def line(self, text):
        return text.count("\n", 0, self.place(text)[0]) + 1

    def applied(self, text):
        """The file with the bug in it."""
        start, end = self.place(text)
        return text[:start] + self.replace + text[end:]

    def switched(self, otherwise=""):
        """Both forms, chosen by the number of the mutant when the program runs; `otherwise` stands for the clean one."""
        clean = otherwise or self.find
        if self.wrap == "statement":
            return f"if (PLUMBLINE_MUTANT({self.number})) {{ {self.replace} }} else {{ {clean} }}"
        if self.wrap == "factor":
            return f"((PLUMBLINE_MUTANT({self.number}) ? {float(self.type)} : 1.0) * ({clean}))"
        if self.wrap == "skip":
            leave = f"if (({self.type}) && PLUMBLINE_MUTANT({self.number})) continue;"
            return f"{{ {leave}" if self.find == "{" else f"{leave} else {clean}"
        return f"(PLUMBLINE_MUTANT({self.number}) ? {self.type}({self.replace}) : {self.type}({clean}))"


def load(folder):
    """All mutants of a folder of declarations, numbered from 1 in the order of the files and lines."""
    mutants, ids = [], set()
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        document = json.loads(path.read_text(encoding="utf-8"))
        for entry in document["mutants"]:
            name = entry.get("id", "?")
            missing = {"id", "kind", "file", "what", "find", "replace"} - set(entry)
            if missing or set(entry) - KNOWN:
                raise DeclarationError(f"{path.name}, {name}: lacks {sorted(missing)}, has {sorted(set(entry) - KNOWN)}")
            area = document.get("area") or area_of(entry["file"])
            mutant = Mutant(area=area, origin=document["origin"], number=len(mutants) + 1, **entry)
            if mutant.wrap not in WRAPS:
                raise DeclarationError(f"{name}: wrap is one of {', '.join(WRAPS)}, not {mutant.wrap}")
            if not re.fullmatch(r"[a-z0-9-]+", name, re.IGNORECASE) or name in ids:
                raise DeclarationError(f"{name}: an id is a name of its own of letters, digits and dashes")
            if mutant.find == mutant.replace:
                raise DeclarationError(f"{name}: changes nothing")
            ids.add(name)
            mutants.append(mutant)
    return mutants


def load_drawn(path, known=0):
    """The bugs of a draw that results/draw.json holds, numbered from `known` + 1; none where there is no such file."""
    if not path.exists():
        return []
    rows = json.loads(path.read_text(encoding="utf-8"))["mutants"]
    return [
        Mutant(id=row["id"], kind=row["operator"], file=row["file"], what=row["what"], area=area_of(row["file"]), origin="drawn",
               number=known + k, **row["bug"])
        for k, row in enumerate(rows, 1)
    ]  # fmt: skip


def area_of(file):
    return next((area for start, area in AREAS if file.startswith(start)), "")


def switched_text(text, mutants, header):
    """A source file with all its compiled mutants as switches. Mutants of one file have one place or do not overlap."""
    places = {}
    for mutant in mutants:
        places.setdefault(mutant.place(text), []).append(mutant)
    ordered = sorted(places)
    for one, other in zip(ordered, ordered[1:]):
        if other[0] < one[1]:
            raise DeclarationError(f"{places[one][0].id} and {places[other][0].id} overlap in {mutants[0].file}")
    for place in reversed(ordered):
        both = ""
        for mutant in places[place]:
            both = mutant.switched(both)
        text = text[: place[0]] + both + text[place[1] :]
    return f'#include "{header}"\n{text}'
