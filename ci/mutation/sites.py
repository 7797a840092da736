"""All sites of the sources that a finished build compiles, from their syntax trees (libclang).

Headers that many sources include are read once, as a precompiled header. Any header belongs to the first unit that holds it:
its sites count once, however many sources include it. What was found is kept beside the fingerprint of the sources.
"""

import json
import pathlib
import re
from collections import Counter
from dataclasses import asdict

from clang.cindex import CursorKind, Diagnostic, Index, TranslationUnit

from . import operators, tree
from .state import Fingerprints

FOLDERS = ("kernel", "reference", "cases/harness")
LIBRARIES = ("algorithm", "array", "cmath", "filesystem", "functional", "map", "memory", "optional", "sstream", "string", "thread",
             "vector", "Eigen/Dense", "fmt/format.h", "nlohmann/json.hpp")  # fmt: skip
# A function that returns a list of columns: its name, and its body on one line or on several.
LIST_OF_COLUMNS = re.compile(r"<(?:const )?ColumnId\b[^>\n]*>&? (?:\w+::)?(\w+)\([^)]*\)[^;{]*\{(?:([^\n]+)\}\n|\n(.*?)\n {0,2}\})", re.DOTALL)


def folder_of(file):
    return next((folder for folder in FOLDERS if file.startswith(f"{folder}/")), "")


def columns_of(root):
    """operators.PointColumns of the sources; lists of the same name, as those of materials, are one."""
    found, listed = set(), {}
    for path in (path for folder in FOLDERS for path in (root / folder).rglob("*.[ch]pp")):
        text = path.read_text(encoding="utf-8")
        found |= set(re.findall(r'inline const ColumnId \w+\{"(\w+)"', text))
        for name, *bodies in LIST_OF_COLUMNS.findall(text):
            listed.setdefault(name, set()).update(re.findall(r"column::(\w+)", "".join(bodies)))
    return operators.PointColumns(tuple(sorted(found)), {name: sorted(names) for name, names in listed.items()})


def arguments_of(base):
    """(sources of the folders, arguments for the parser): those of all sources in one, so that one header serves."""
    sources, wanted = set(), {}
    for name, held in base.sources.items():
        own = {source for source in held if folder_of(source)}
        if not own:
            continue
        sources |= own
        words = base.compile[name][1]
        for word, after in zip(words, words[1:]):
            if word == "-isystem":
                wanted[word, after] = None
            elif word.startswith(("-I", "-D", "-std=", "-march=")):
                wanted[(word,)] = None
    return sorted(sources), [word for words in wanted for word in words]


def common_headers(base):
    """Headers of the folders that at least a tenth of the objects need: such stand side by side anyway."""
    counts, own = Counter(), [name for name, held in base.sources.items() if any(map(folder_of, held))]
    for name in own:
        counts.update(file for file in base.needs.get(name, ()) if folder_of(file) and file.endswith(".hpp"))
    return sorted(file for file, count in counts.items() if 10 * count >= len(own))


def gather(base, work, say=print):
    """([Site], {(operator, why): how many no switch can stand at}), in the order of files and places."""
    own = [str(path.relative_to(base.root)) for path in map(pathlib.Path, (__file__, operators.__file__, tree.__file__))]
    print_of = Fingerprints(base.root).of(*FOLDERS, *own)
    kept = work / "sites.json"
    if kept.exists():
        document = json.loads(kept.read_text())
        if document["fingerprint"] == print_of:
            excluded = Counter({tuple(key.split(": ")): count for key, count in document["excluded"].items()})
            return [tree.Site(**site) for site in document["sites"]], excluded
    work.mkdir(parents=True, exist_ok=True)
    found, excluded, done, columns = [], Counter(), set(), columns_of(base.root)
    sources, words = arguments_of(base)
    for number, unit in enumerate(_units(base.root, sources, words, common_headers(base), work)):
        if number % 20 == 0:
            say(f"syntax trees: {number} of {len(sources)} sources")
        for fault in _faults(unit, base.root):
            say(f"what this spoils has no sites: {fault}")
        for file, walk in of_unit(unit, base.root, done, columns).items():
            found += walk.sites.values()
            excluded += walk.excluded
            done.add(file)
    found.sort(key=lambda site: (site.file, site.start, site.operator, site.find, site.replace))
    document = {"fingerprint": print_of, "excluded": {": ".join(key): n for key, n in excluded.items()},
                "sites": [asdict(site) for site in found]}  # fmt: skip
    kept.write_text(json.dumps(document))
    return found, excluded


def _units(root, sources, words, headers, work):
    """The tree of these headers together, then of each source; what templates become at the end of a source holds no site of its own."""
    index, incomplete = Index.create(), TranslationUnit.PARSE_INCOMPLETE
    source, header = work / "headers.hpp", work / "headers.pch"
    source.write_text("".join(f"#include <{name}>\n" for name in (*LIBRARIES, *headers)))
    unit = index.parse(str(source), ["-x", "c++-header", *words], options=incomplete)
    unit.save(str(header))
    yield unit
    for source in sources:
        unit = index.parse(str(root / source), [*words, "-include-pch", str(header)], options=incomplete)
        if _faults(unit, root):  # a name of its own may be one of those headers', too
            unit = min(unit, index.parse(str(root / source), words, options=incomplete), key=lambda u: len(_faults(u, root)))
        yield unit


def _faults(unit, root):
    """What the parser did not understand in files of the project."""
    return [d for d in unit.diagnostics if d.severity >= Diagnostic.Error and _relative(d.location.file, root)]


def _relative(file, root):
    """Of a file of clang; empty where it is none of the project's."""
    path = pathlib.Path(file.name) if file else root.parent
    return str(path.relative_to(root)) if path.is_relative_to(root) else ""


def of_unit(unit, root, done=frozenset(), columns=operators.PointColumns()):
    """{file: Walk} of the project's files that a unit holds and that are not `done`."""
    walks = {}
    for cursor in unit.cursor.get_children():
        place = cursor.location.file
        file = _relative(place, root)
        if not file or file in done or not (folder_of(file) or "/" not in file):
            continue
        if file not in walks:
            walks[file] = operators.Walk(file, (root / file).read_bytes(), columns)
        if cursor.kind != CursorKind.USING_DECLARATION:
            walks[file].walk(cursor)
    return walks
