"""Turns a matplotlib figure into inline SVG that follows the page: colours and font are CSS variables.

matplotlib draws with stand-in colours; each is replaced by a variable of the style sheet, so that one drawing
is legible on a light and on a dark page. Identifiers get a prefix of their own, as many figures share one
document.
"""

import io
import re
import zlib
from xml.etree import ElementTree

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

INK, GRID, MUTED = "#010203", "#010204", "#010205"
SERIES = tuple(f"#f100{index:02x}" for index in range(1, 7))  # one colour per line of a case
LEVELS = tuple(f"#f200{index:02x}" for index in range(1, 4))  # coarsest, middle, finest
MARKS = ("o", "s", "^", "D", "v", "P")
_VARIABLES = {
    INK: "currentColor",
    GRID: "var(--grid)",
    MUTED: "var(--muted)",
    **{colour: f"var(--s{index + 1})" for index, colour in enumerate(SERIES)},
    **{colour: f"var(--l{index + 1})" for index, colour in enumerate(LEVELS)},
}
_STYLE = {
    "svg.fonttype": "none",
    "svg.hashsalt": "plumbline",
    "font.family": "DejaVu Sans",
    "font.size": 8.5,
    "axes.facecolor": "none",
    "axes.edgecolor": MUTED,
    "axes.labelcolor": INK,
    "axes.linewidth": 0.7,
    "text.color": INK,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "axes.labelsize": 8.5,
    "axes.labelpad": 8,
    "axes.grid": True,
    "grid.color": GRID,
    "grid.linewidth": 0.6,
    "axes.axisbelow": True,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "lines.linewidth": 1.4,
    "lines.markersize": 4.5,
    "path.simplify": True,
    "path.simplify_threshold": 0.3,
    "figure.constrained_layout.use": True,
}
WIDTH = 4.7  # inches; at 390 pixels of page the text is then still about 9 pixels high


def series_colour(style):
    return SERIES[style % len(SERIES)]


def series_mark(style):
    """Together with the colour, 36 different looks."""
    return MARKS[(style + style // len(SERIES)) % len(MARKS)]


def draw(paint, prefix, label, height=2.9, **subplots):
    """SVG text of the figure that `paint(axes)` fills; `subplots` goes to Figure.subplots."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_STYLE)
        figure = Figure(figsize=(WIDTH, height))
        FigureCanvasSVG(figure)
        paint(figure.subplots(**subplots))
        stream = io.StringIO()
        figure.savefig(stream, format="svg", transparent=True, metadata={"Date": None})
    return _inline(stream.getvalue(), prefix, label)


def escape(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def _inline(text, prefix, label):
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>|<style.*?</style>|<!--.*?-->", "", text, flags=re.DOTALL)
    box = re.search(r'viewBox="[^"]*"', text).group(0)
    text = re.sub(r"^<svg[^>]*>", f'<svg {box} role="img" aria-label="{escape(label)}">', text)
    text = text.replace("xlink:href", "href").replace(' transform="rotate(-0 ', ' transform="rotate(0 ')
    text = re.sub(r"font: ([\d.]+)px [^;\"]*", r"font: calc(\1px * var(--zoom)) var(--font)", text)
    text = re.sub("|".join(_VARIABLES), lambda match: _VARIABLES[match.group(0)], text)
    text = re.sub(r'id="class:([\w-]+)[^"]*"', r'class="\1"', text)
    text = re.sub(r' (?:d|x|y|width|height|transform)="[^"]*"', _rounded, text)
    text = re.sub(r"<g[^>]*/>", "", text)  # parts that nothing was drawn in
    text = re.sub(r"<g([^>]*)>\s*((?:<use [^>]*/>\s*){3,})</g>", _shared_style, text)
    text = _own_identifiers(text, f"f{zlib.crc32(prefix.encode()):x}")
    return re.sub(r">\s+<", "><", re.sub(r" *\n *", " ", text)).strip()


def _shared_style(group):
    """Marks of one line repeat their style hundreds of times: it moves to the group around them."""
    attributes, marks = group.groups()
    styles = set(re.findall(r' style="([^"]*)"', marks))
    if len(styles) != 1 or "style=" in attributes:
        return group.group(0)
    return f'<g{attributes} style="{styles.pop()}">' + re.sub(r' style="[^"]*"', "", marks) + "</g>"


def _rounded(attribute):
    """Two decimals of a point are finer than any screen; matplotlib writes six."""
    return re.sub(r"(\.\d\d)\d+", r"\1", attribute.group(0))


def _own_identifiers(text, prefix):
    used = set(re.findall(r'(?:href="#|url\(#)([^")]+)', text))
    text = re.sub(
        r' id="([^"]*)"', lambda m: f' id="{prefix}-{m.group(1)}"' if m.group(1) in used else "", text
    )
    return re.sub(r'(href="#|url\(#)', rf"\g<1>{prefix}-", text)


# --- sketches from the catalog --------------------------------------------------------------------

_SHAPES = frozenset(
    "svg g path line polyline polygon rect circle ellipse text tspan defs marker use title desc "
    "linearGradient radialGradient stop pattern clipPath".split()
)


def sketch(source, prefix, label):
    """A drawing of the catalog, checked: shapes and text only, nothing that runs or loads; else ""."""
    try:
        root = ElementTree.fromstring(source)
    except ElementTree.ParseError:
        return ""
    for element in root.iter():
        element.tag = _local(element.tag)
        if element.tag not in _SHAPES:
            return ""
        element.attrib = {
            _local(name): value for name, value in element.attrib.items() if _harmless(_local(name), value)
        }
    if root.tag != "svg" or "viewBox" not in root.attrib:
        return ""
    for name in ("width", "height"):
        root.attrib.pop(name, None)
    root.attrib.update({"role": "img", "aria-label": label})
    return _own_identifiers(
        ElementTree.tostring(root, encoding="unicode", short_empty_elements=False), prefix
    )


def _local(name):
    return name.rpartition("}")[2]


def _harmless(name, value):
    loads = "url(" in value.replace("url(#", "") or "javascript:" in value.lower()
    return not name.lower().startswith("on") and not loads and (name != "href" or value.startswith("#"))
