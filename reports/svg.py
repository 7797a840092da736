"""Turns a matplotlib figure into inline SVG that follows the page: colours and font are CSS variables.

matplotlib draws with stand-in colours; each is replaced by a variable of the style sheet, so that one drawing
is legible on a light and on a dark page. Identifiers get a prefix of their own, as many figures share one
document.
"""

import io
import re
from xml.etree import ElementTree

import matplotlib
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure

import compact

INK, GRID, MUTED = "#010203", "#010204", "#010205"
SERIES = tuple(f"#f100{index:02x}" for index in range(1, 9))  # one colour per line of a case
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
    "xtick.major.size": 0,  # the grid is there
    "ytick.major.size": 0,
    "xtick.minor.size": 0,
    "ytick.minor.size": 0,
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
    """Together with the colour, 48 different looks."""
    return MARKS[(style + style // len(SERIES)) % len(MARKS)]


def draw(paint, prefix, label, height=2.9, **subplots):
    """SVG text of the figure that `paint(axes)` fills; `subplots` goes to Figure.subplots.

    Every line with a label (`axes.plot(..., label=...)`) can be pointed at on the page: its label, its values and what
    `note(line, ...)` says of its points are shown.
    """
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_STYLE)
        figure = Figure(figsize=(WIDTH, height))
        FigureCanvasSVG(figure)
        paint(figure.subplots(**subplots))
        series = _name_parts(figure)
        stream = io.StringIO()
        figure.savefig(stream, format="svg", transparent=True, metadata={"Date": None})
        axes = {part.get_gid(): _axes(part) for part in figure.axes if part.get_gid().startswith("axes:")}
    source = re.sub(r"font: ([\d.]+)px [^;\"]*", r"font: calc(\1px * var(--zoom)) var(--font)", stream.getvalue())
    source = re.sub("|".join(_VARIABLES), lambda match: _VARIABLES[match.group(0)], source)
    return compact.compact(source, identifier(prefix), label, {"axes": axes, "series": series})


def note(line, words):
    """Says of each point of a line what it is, for example the number of cells."""
    line.plumbline_notes = [str(word) for word in words]


def belongs(part, label):
    """Lets a line or an area that cannot be pointed at itself appear and vanish with the line of this label."""
    part.plumbline_series = label


def _name_parts(figure):
    """Gives axes and labelled lines the names by which compact.py finds them; returns the labels and their notes."""
    series = []
    figure.patch.set_gid("frame")
    for number, axes in enumerate(figure.axes):
        axes.patch.set_gid("frame")
        for spine in axes.spines.values():
            spine.set_gid("frame")
        beside = axes.get_label() == "<colorbar>"
        axes.set_gid(f"frame-{number}" if beside else f"axes:{number}")
        for part in [*axes.lines, *axes.collections]:
            own = str(part.get_label())
            label = getattr(part, "plumbline_series", "" if own.startswith("_") else own)
            classes = (part.get_gid() or "").removeprefix("class:") + (" b" if own.startswith("_") and label else "")
            if label and label not in series:
                series.append(label)
            if (label or classes) and not beside:
                notes = "|".join(getattr(part, "plumbline_notes", ()))
                part.set_gid(f"line:{classes.strip()}:{series.index(label) if label else ''}:{notes}")
    return series


def _axes(axes):
    """Place, scales, limits and labels of a pair of axes, as report.js reads them."""
    height = 72 * axes.figure.get_figheight()
    box = axes.get_window_extent().transformed(axes.figure.dpi_scale_trans.inverted())
    place = [72 * box.x0, height - 72 * box.y1, 72 * box.width, 72 * box.height]
    parts = [round(float(value), 2) for value in place]
    for axis, limits in ((axes.xaxis, axes.get_xlim()), (axes.yaxis, axes.get_ylim())):
        scale = axis.get_scale()
        if scale == "symlog":
            transform = axis.get_transform()
            scale = [float(transform.linthresh), float(transform.linscale)]
        parts += [scale if isinstance(scale, list) else int(scale == "log"), *(float(f"{limit:.7g}") for limit in limits)]
    return parts + [_shared_label(axes, "x"), _shared_label(axes, "y")]


def _shared_label(axes, name):
    """The label of an axis; of axes that share one with others, whichever of them states it."""
    group = getattr(axes, f"get_shared_{name}_axes")().get_siblings(axes)
    labels = [getattr(part, f"get_{name}label")() for part in [axes, *sorted(group, key=lambda part: part.get_gid() or "")]]
    return next((label for label in labels if label), name)


def identifier(words):
    """Words as an identifier for links within the page."""
    return re.sub(r"[^A-Za-z0-9_-]+", "-", words).strip("-") or "unnamed"


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
