"""Reads the report back: a strict parser of the page that keeps what the tests ask for."""

import base64
import csv
import io
import re
from html.parser import HTMLParser

import numpy
from plumbline import reader
import render
from PIL import Image

VOID = {"meta", "link", "br", "input", "img", "hr"}
MAY_CLOSE_THEMSELVES = {"path", "image", "circle", "rect", "line", "use", "polyline", "polygon", "ellipse"}


SCRIPT = re.compile(r"<script>.*?</script>", re.DOTALL)


def without_scripts(source):
    """The page without its own scripts, of which there are five with the library; whatever else runs stays in."""
    bare, count = SCRIPT.subn("", source)
    assert count in (4, 5), f"{count} scripts"
    return bare


def figures_of(sources):
    """[(path, class, title, text)] of the figures of pages, {path: text}."""
    found = []
    for path, source in sources.items():
        for quoted, bare, figure in re.findall(r'<figure class=(?:"([^"]*)"|([^\s>]*))[^>]*>(.*?)</figure>', source, re.DOTALL):
            title = re.search(r"plot-title[^>]*>([^<]*)|<figcaption>([^<]*)", figure)
            found.append((path, quoted or bare, title[1] or title[2], figure))
    return found


def without_command(sources):
    """[(path, title)] of the figures that name no command."""
    return [(path, title) for path, _, title, figure in figures_of(sources) if "Reproduce: <code>plumbline " not in figure]


# What a tag, or the end of its parent, closes by itself in a table.
IMPLIED = {
    "td": ("td", "th"), "th": ("td", "th"), "tr": ("td", "th", "tr"), "tbody": ("td", "th", "tr", "thead", "tbody"),
    "/tr": ("td", "th"), "/thead": ("td", "th", "tr"), "/tbody": ("td", "th", "tr"), "/table": ("td", "th", "tr", "thead", "tbody"),
}  # fmt: skip


class Page(HTMLParser):
    """ids, links, attributes that could load something, tables as rows of texts, and the text of the page."""

    def __init__(self, source):
        super().__init__()
        self.ids, self.links, self.loads, self.words = [], [], [], []
        self.rows = []  # (identifier of the section or case, [texts of cells])
        self.labels = []  # aria-label of drawings
        self.identities = []  # (identifier of the case, scheme and line, name of a gate in the table of identities)
        self._identities = None  # of the table of identities that is read: names of its columns, name of the row
        self._open, self._case, self._row = [], "", None
        self.feed(source)
        self.close()
        assert not self._open, f"left open: {self._open}"

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self._close_implied(tag)
        self._take(tag, attributes)
        if tag == "table":
            self._identities = ([], [""]) if "identities" in attributes.get("class", "").split() else None
        if tag == "td" and self._identities and attributes.get("id", "").startswith("gate-"):
            names, line = self._identities
            self.identities.append((self._case, line[0], names[len(self._row) - 2]))
        if tag not in VOID:
            self._open.append(tag)

    def handle_startendtag(self, tag, attributes):
        assert tag in VOID | MAY_CLOSE_THEMSELVES, f"<{tag}/>"
        self._take(tag, dict(attributes))

    def _close_implied(self, tag):
        while self._open and self._open[-1] in IMPLIED.get(tag, ()):
            self._ended(self._open.pop())

    def handle_endtag(self, tag):
        self._close_implied(f"/{tag}")
        assert self._open and self._open[-1] == tag, f"</{tag}> closes {self._open[-3:]} at {self.getpos()}"
        self._ended(self._open.pop())

    def _ended(self, tag):
        if tag == "tr":
            self.rows.append((self._case, [" ".join("".join(cell).split()) for cell in self._row]))
            self._row = None

    def handle_data(self, data):
        if self._open and self._open[-1] not in ("style", "script"):
            self.words.append(data)
            if self._identities and self._open[-1] == "code":
                names, line = self._identities
                if "thead" in self._open:
                    names.append(data)
                else:
                    line[0] = data
            if self._row:
                self._row[-1].append(data + " ")

    def _take(self, tag, attributes):
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if tag in ("section", "article") and attributes.get("id"):
            self._case = attributes["id"]
        if tag == "tr":
            self._row = []
        if tag in ("td", "th") and self._row is not None:
            self._row.append([])
        if tag in ("a", "use") and "href" in attributes:
            self.links.append(attributes["href"])
        if tag == "svg" and attributes.get("role") == "img":
            self.labels.append(attributes.get("aria-label"))
        self.loads += [
            (tag, name, value)
            for name, value in attributes.items()
            if name in ("src", "srcset", "data", "action", "poster")
            or (name == "href" and tag not in ("a", "use"))
            or (name == "style" and value and "url(" in value.replace("url(data:image/webp;base64,", ""))
        ]

    @property
    def text(self):
        return " ".join("".join(self.words).split())

    def gate_rows(self, section):
        """(verdict, id, scheme) of the gates shown in a case, or in the lists of the front page."""
        found = []
        for where, cells in self.rows:
            if where == section and len(cells) in (6, 7) and cells[0].isupper():
                quantity, scheme = cells[-5], cells[-4]
                name = quantity.split(" · ")[0].split(" ")[-1]
                found.append((cells[0], name, scheme))
        for case, line, name in self.identities:
            if case == section:
                scheme, _, variant = line.partition(" ")
                found.append(("PASS", f"{variant or scheme}/{name}", scheme))
        return found


def source_of(folder):
    return render.single_file(render.report(reader.load_folder(folder), whole=False))


def shown(folder):
    """The page of a folder of results."""
    return Page(source_of(folder))


def tables_of(folder, output, names):
    """Tables of a folder as the report writes them, read back from CSV: {name: rows}."""
    assert render.main([str(folder), str(output / "page.html"), "--single-file", "--csv", str(output / "csv")]) == 0
    tables = {}
    for name in names:
        with open(output / "csv" / f"{name}.csv", encoding="utf-8", newline="") as stream:
            tables[name] = list(csv.DictReader(stream))
    return tables


def pixels_of(address):
    """Red, green, blue and opacity of each pixel of a picture in the page."""
    form, _, content = address.partition(",")
    assert form == "data:image/webp;base64"
    return numpy.array(Image.open(io.BytesIO(base64.b64decode(content))).convert("RGBA"))
