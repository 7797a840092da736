"""The reference from what the executable says of itself: commands, cases, keys, schemes, JSON; and the index of equations.

A page holds a line `<!-- generated: NAME -->`, in place of which the part of that name is put.
"""

import concurrent.futures
import json
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCHEMA = ROOT / "cases/harness/schema/plumbline.schema.json"
KINDS = ("gas", "membrane", "solid", "coupled")
PLACE = re.compile(r"^<!-- generated: (\w+) -->$", re.MULTILINE)
SHARED = 12  # a key of so many cases and more belongs to schemes, one of fewer to its cases


class Plumbline:
    """The executable, asked under its bare name, so that no path is printed."""

    def __init__(self, path):
        self._path = str(pathlib.Path(path).resolve())

    def text(self, *arguments):
        return subprocess.run(["plumbline", *arguments], executable=self._path, capture_output=True, text=True, check=True).stdout

    def json(self, *arguments):
        return json.loads(self.text(*arguments, "--json", "-"))


def plain(text):
    """Words of the executable as Markdown: nothing but what stands in backquotes is more than letters."""
    pieces = re.split(r"(`[^`]*`)", str(text))
    return "".join(piece if piece.startswith("`") and len(piece) > 1 else re.sub(r"([\\`*_\[\]<>|$#{}~])", r"\\\1", piece) for piece in pieces)


def cell(text):
    return re.sub(r"\s+", " ", plain(text)).replace("`|`", "`\\|`")


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows]) + "\n"


def code(text):
    return f"```text\n{text.rstrip()}\n```\n"


def number(value):
    return "none" if value is None else f"{value:g}" if isinstance(value, (int, float)) else str(value)


def commands(plumbline, **_):
    overview = plumbline.text("--help")
    names = re.findall(r"^  ([a-z]+) {2,}\S", overview[overview.index("Subcommands:"):], re.MULTILINE)
    return "\n".join([code(overview), *(f"## plumbline {name}\n\n{code(plumbline.text(name, '--help'))}" for name in names)])


def schemes(listed, **_):
    default, york = (scheme["kinds"] for scheme in listed["schemes"])

    def both(kind, key):
        if key not in default[kind]:
            return ""
        one, other = number(default[kind][key]), number(york[kind][key])
        return one if one == other else f"{one} / {other}"

    keys = dict.fromkeys(key for values in default.values() for key in values)
    return table(("key", *KINDS), [(f"`{key}`", *(both(kind, key) for kind in KINDS)) for key in keys])


def integrators(listed, **_):
    families = ("order", "stability", "energy", "invariance")
    rows = [(f"`{entry['name']}`", cell(entry["title"]), *(cell(entry["claims"].get(family, "")) for family in families), cell(entry["source"])) for entry in listed["integrators"]]
    return table(("name", "a step", "order in dt", "limit", "energy", "invariance", "source"), rows)


def named(kind):
    def part(listed, **_):
        return table(("name", "what it is", "source"), [(f"`{entry['name']}`", cell(entry["title"]), cell(entry["source"])) for entry in listed[kind]])
    return part


def keys(explained, **_):
    found = {}
    for name, case in explained.items():
        for parameter in case["parameters"]:
            found.setdefault(parameter["key"], []).append((name, parameter))
    shared = [(f"`{key}`", cell(uses[0][1]["allowed"]), cell(uses[0][1]["description"])) for key, uses in found.items() if len(uses) >= SHARED]
    own = [
        (f"`{key}`", cell(uses[0][1]["description"]), ", ".join(f"[{name}](cases/{name}.md)" for name, _ in uses))
        for key, uses in sorted(found.items())
        if len(uses) < SHARED
    ]
    return f"{table(('key', 'allowed', 'meaning'), shared)}\n## Keys of cases\n\n{table(('key', 'meaning', 'cases'), own)}"


def catalog(listed, explained, **_):
    parts = []
    for kind in dict.fromkeys(case["kind"] for case in listed["cases"]):
        rows = [(f"[{case['name']}](cases/{case['name']}.md)", cell(case["title"]), cell(explained[case["name"]]["claim"])) for case in listed["cases"] if case["kind"] == kind]
        parts.append(f"## {kind[0].upper()}{kind[1:]}\n\n{table(('case', 'title', 'claim'), rows)}")
    names = "\n".join(f"cases/{name}" for name in explained)
    return "\n".join([*parts, f"```{{toctree}}\n:hidden:\n\n{names}\n```\n"])


def case_page(case):
    lines = [f"# {case['name']}\n", f"{plain(case['title'])}. {plain(case['source'])}\n", f"{plain(case['claim'])}\n"]
    if case.get("sketch"):
        lines.append('<div class="sketch">\n' + re.sub(r"\n\s*\n", "\n", case["sketch"].strip()) + "\n</div>\n")
    lines += [plain(case["physics"]) + "\n"]
    if case["equations"]:
        lines.append(code("\n".join(case["equations"])))
    reference = case["reference"]
    if reference["name"]:
        lines.append(f"## Reference `{reference['name']}`\n\n{plain(reference['text'])}\n\nBound: {plain(reference['bound'])}\n")
    lines.append(f"## Keys\n\n`cells` count along {plain(case['cells_along'])}.\n" if case["cells_along"] else "## Keys\n")
    lines.append(table(("key", "default", "allowed", "meaning"), [(f"`{p['key']}`", cell(number(p["default"])), cell(p["allowed"]), cell(p["description"])) for p in case["parameters"]]))
    lines.append("## Studies and gates\n")
    for study in case["studies"]:
        lines.append(f"### {plain(study['id'])}: {plain(study['title'])}\n\nVaries `{study['vary']}`, scheme `{study['scheme']}`. {plain(study['why'])}\n")
        lines.append(gates([gate for gate in case["gates"] if gate["study"] == study["id"]]))
    ids = {study["id"] for study in case["studies"]}
    lines.append(gates([gate for gate in case["gates"] if gate["study"] not in ids]))
    if case["known_limits"]:
        lines.append("## Known limits\n\n" + "\n".join(f"- {plain(limit)}" for limit in case["known_limits"]) + "\n")
    return "\n".join(lines)


def gates(found):
    def bounds(expected):
        low, high = expected["low"], expected["high"]
        return f"≤ {high:g}" if low is None else f"≥ {low:g}" if high is None else f"{low:g} … {high:g}"

    def reason(gate):
        known = f"; expected to fail: {cell(gate['cause'])}" if gate["cause"] else ""
        return f"{gate['origin'].replace('_', ' ')}: {cell(gate['reason'])}{known}"

    return table(("gate", "quantity", "bound", "origin and reason"), [(cell(g["id"]), cell(g["quantity"]), bounds(g["expected"]), reason(g)) for g in found]) if found else ""


def json_documents(**_):
    schema = json.loads(SCHEMA.read_text(encoding="utf-8"))
    parts = []
    for name, definition in schema["$defs"].items():
        said = plain(definition.get("description", ""))
        fields = definition.get("properties")
        if fields:
            required = definition.get("required", ())
            said += "\n\n" + table(("field", "", "type", "meaning"), [(f"`{field}`", "" if field in required else "optional", kind(value), cell(value.get("description", ""))) for field, value in fields.items()])
        else:
            said += "\n\n" + kind(definition)
        parts.append(f"## {plain(name)}\n\n{said}\n")
    return "\n".join([plain(schema["description"]) + "\n", *parts])


def kind(value):
    """What a value of the schema may be, in a few words; definitions are links."""
    if not isinstance(value, dict):
        return "anything"
    if "$ref" in value:
        name = value["$ref"].split("/")[2]
        return f"[{plain(name)}](#{name})"
    for several in ("oneOf", "anyOf", "allOf"):
        if several in value:
            return (" and " if several == "allOf" else " or ").join(dict.fromkeys(kind(one) for one in value[several]))
    if "enum" in value:
        return ", ".join(f"`{json.dumps(one)}`" for one in value["enum"])
    if "const" in value:
        return f"`{json.dumps(value['const'])}`"
    if value.get("type") == "array":
        return f"list of {kind(value['items'])}" if "items" in value else "list"
    if value.get("type") == "object" and isinstance(value.get("additionalProperties"), dict):
        return f"object of {kind(value['additionalProperties'])}"
    types = value.get("type", "anything")
    return " or ".join(types) if isinstance(types, list) else str(types)


def equations(tags, **_):
    return table(("equation", "computed at", "checked by"), [(f"[{row['tag']}]".replace("[", "\\[").replace("]", "\\]"), *("<br>".join(f"`{place}`" for place in row[side]) for side in ("computed", "checked"))) for row in tags])


PARTS = {
    "commands": commands, "schemes": schemes, "integrators": integrators, "keys": keys, "catalog": catalog, "json": json_documents, "equations": equations,
    **{kind: named(kind) for kind in ("shapes", "transfers", "densities", "contacts", "materials", "references", "problems")},
}


def known_equations():
    with tempfile.NamedTemporaryFile(mode="r", encoding="utf-8") as file:
        subprocess.run([sys.executable, ROOT / "ci/check_equations", "--json", file.name], capture_output=True, check=True)
        return json.load(file)["equations"]


def write(path, folder):
    """Fills in the pages of `folder` and adds a page for each case."""
    plumbline = Plumbline(path)
    listed = plumbline.json("list")
    names = [case["name"] for case in listed["cases"]]
    with concurrent.futures.ThreadPoolExecutor() as pool:
        explained = dict(zip(names, pool.map(lambda name: plumbline.json("explain", name), names)))
    known = {"plumbline": plumbline, "listed": listed, "explained": explained, "tags": known_equations()}
    for page in sorted(folder.rglob("*.md")):
        text = page.read_text(encoding="utf-8")
        page.write_text(PLACE.sub(lambda match: PARTS[match[1]](**known), text), encoding="utf-8")
    (folder / "reference/cases").mkdir()
    for name, case in explained.items():
        (folder / f"reference/cases/{name}.md").write_text(case_page(case), encoding="utf-8")
