"""The report as a folder of pages: which there are, how they are linked, and how they are written.

Every page is made from the section templates that the single file is made from. A link `#NAME` in a template leads to
whichever page NAME stands on. Pages without a lead of their own have the heading of their section as title.
"""

import base64
import re
from dataclasses import dataclass, field

import frame
import search_index

SHARED = "shared/"  # style sheet, scripts, words and pictures, beside the pages
DOCUMENTS = "docs/index.html"  # made by docs/build.py
OWNED = ("cases", "integrators")  # folders in which nothing but pages of the report stands
MOST_BYTES_OF_A_PAGE = 1_500_000
MOST_BYTES_OF_THE_INDEX = 200_000


@dataclass
class Page:
    path: str  # in the folder
    title: str  # in the contents
    template: str = "sections"
    sections: tuple = ()
    lead: str = ""
    group: str = ""  # pages that list each other in the contents
    shown: dict = field(default_factory=dict)
    verdict: str = ""

    @property
    def root(self):
        return "../" * self.path.count("/")


DOORS = (
    ("scheme.html", "Choose a scheme", ("cost", "choices"),
     "What accuracy costs with each scheme, by kind of scene; which to choose, over which problems and by which criterion."),
    ("step.html", "Choose a step", ("stability",),
     "The largest stable step of each integrator, the smallest known first: predicted, observed, and in closed form."),
    ("integrators.html", "Judge an integrator", ("scorecards",),
     "Every time integrator against the same gates, and how to judge one of your own."),
    ("changes.html", "What changed", ("changes",),
     "Against earlier results: what is better, worse and new."),
)  # fmt: skip
SECTIONS = (
    ("gates.html", "All gates", ("verdicts", "gates"), "What was expected, what was measured, and how near it came to its bound."),
    ("failures.html", "Expected failures", ("failures",)),
    ("york.html", "York's report", ("york",)),
    ("york-figures.html", "York's figures, computed", ("york_pictures",)),
    ("trust.html", "Trust", ("trust",)),
    ("mutants.html", "Mutation testing", ("mutants",)),
    ("speed.html", "Speed", ("speed",)),
    ("reading.html", "How to read", ("reading",)),
    ("reproduce.html", "Reproduce", ("provenance",)),
)


def all_pages(report):
    """The pages of a report; `report`: what the sections show."""
    found = [Page("index.html", "Overview", "index", shown={"doors": doors()})]
    found += [Page(path, title, sections=sections, lead=lead if len(sections) > 1 or sections == ("changes",) else "") for path, title, sections, lead in DOORS]
    york = report["york"] or {}
    empty = {name for name, part in (("york", york), ("york_pictures", york.get("pictures")), ("failures", report["expected_failures"])) if not part}
    found += [Page(path, title, sections=sections, lead=" ".join(lead)) for path, title, sections, *lead in SECTIONS if not empty & set(sections)]
    found += [
        Page(f"integrators/{card['anchor'].removeprefix('scorecard-')}.html", card["name"], "integrator", group="integrators",
             shown={"card": card}, verdict=card["verdict"])
        for card in (report["integrators"] or {}).get("cards", ())
    ]  # fmt: skip
    found += [
        Page(f"cases/{case['anchor'].removeprefix('case-')}.html", case["title"], "case", group="cases", shown={"page": case}, verdict=case["verdict"])
        for case in report["pages"]
    ]
    return found


def doors():
    return [{"path": path, "title": title, "words": words} for path, title, _, words in DOORS]


def folder(report, has_documents=False):
    """{path: text or bytes} of all files of the folder, the index last; `has_documents`: the site of documents stands beside the pages."""
    files = {SHARED + name: text for name, text in frame.shared_files().items()}
    files |= taken_out(report["catalog"])
    pages = all_pages(report)
    menu = [page for page in pages if not page.group]
    sources = {}
    for page in pages:
        siblings = [other for other in pages if page.group and other.group == page.group]
        source = frame.page(
            f"pages/{page.template}.html", report["stability"].get("style", "") if "stability" in page.sections else "",
            beside=page.root + SHARED, root=page.root, here=page, menu=[menu, siblings] if siblings else [menu],
            has_documents=has_documents, **(report | page.shown),
        )  # fmt: skip
        sources[page.path] = source if page.lead or "<h1" in source else lifted(source)
    sources = linked(sources)
    titles = {page.path: page.title for page in pages}
    files[f"{SHARED}words.js"] = search_index.script(sources, titles)
    files |= {path: sources[path] for path in sources if path != "index.html"}
    return files | {"index.html": sources["index.html"]}


def taken_out(catalog):
    """{path: bytes} of the pictures of the catalog, which are then named there instead of written out."""
    files = {}
    for group in catalog:
        for card in group["cards"]:
            if card["picture"]:
                card["file"] = f"{SHARED}{card['anchor']}.webp"
                files[card["file"]] = base64.b64decode(card["picture"].partition(",")[2])
    return files


def lifted(source):
    """The page with each heading one level up: its first section's becomes that of the page."""
    return re.sub(r"<(/?)h([2-6])\b", lambda found: f"<{found[1]}h{int(found[2]) - 1}", source)


def linked(sources):
    """The pages with every link `#NAME` that stands on another page led there."""
    own = {path: set(re.findall(r'<[^<>]*?\sid="?([^"\s>]+)', source)) for path, source in sources.items()}
    homes = {}
    for path in sorted(sources, key=lambda path: path == "index.html"):
        for name in own[path]:
            homes.setdefault(name, path)

    def led(path):
        root = "../" * path.count("/")

        def replaced(found):
            name = found[3]
            if name in own[path] or name not in homes:
                return found[0]
            quote = found[2] or '"'
            return f"{found[1]}{quote}{root}{homes[name]}#{name}{quote}"

        return lambda source: re.sub(r'(<a\b[^<>]*?\bhref=)("?)#([^"\s>]+)\2', replaced, source)

    return {path: led(path)(source) for path, source in sources.items()}


def write(report, target):
    """Writes the folder, the index last, and removes pages of an earlier report that this one does not have."""
    files = folder(report, (target / DOCUMENTS).is_file())
    for path, content in files.items():
        frame.write_whole(target / path, content)
    for name in OWNED:
        for old in (target / name).glob("*.html"):
            if f"{name}/{old.name}" not in files:
                old.unlink()
    return files


def too_large(files):
    """[(path, bytes, most)] of pages above what they may weigh."""
    limits = {path: MOST_BYTES_OF_THE_INDEX if path == "index.html" else MOST_BYTES_OF_A_PAGE for path in files if path.endswith(".html")}
    sizes = {path: len(files[path].encode()) for path in limits}
    return [(path, sizes[path], most) for path, most in limits.items() if sizes[path] > most]
