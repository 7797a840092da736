"""Makes the SVG that matplotlib writes small, and tells the script of the page what is drawn where.

A figure of matplotlib repeats styles, markers and ticks at length; a report of a thousand figures would weigh tens of
megabytes. Here each line becomes one short path with relative coordinates, all marks of a line one path, and the grid
one path. Lines stay where they were to a third of a point, half a pixel on a wide screen.

Structure of a drawing, on which report.js relies: for each pair of axes a group `x` (frame, ticks, labels) and a group
`d` (data, clipped to the axes); lines that can be pointed at have `data-s`, the number of their label, and what vanishes with them too, of class `b`; marks are a path of class `m` in which
each `M x y` begins one mark, `data-n` their notes, or the one note of all. `data-plot` of the drawing holds
{"a": axes, "s": labels}, the axes being [left, top, width, height, x scale, x low, x high, y scale, y low, y high, x label, y label]; a scale is 0 for linear, 1
for logarithmic, [threshold, linear decades] for symmetric logarithmic.
"""

import itertools
import json
import re
import zlib
from xml.etree import ElementTree

import numpy

import raster

TOLERANCE = 0.3  # points by which a simplified line may be off
_FEW = 60  # marks of a line up to which the places have two decimals, so that values read back have three digits
_SVG = "{http://www.w3.org/2000/svg}"
_HREF = "{http://www.w3.org/1999/xlink}href"
# What a drawing has anyway, or what no eye tells apart.
_DEFAULTS = {
    ("fill", "none"),
    ("fill-opacity", "1"),
    ("stroke-dashoffset", "0"),
    ("stroke-linecap", "square"),
    ("stroke-linejoin", "miter"),
    ("stroke-linejoin", "round"),
}


def compact(source, name, label, details):
    """Inline SVG of what matplotlib wrote, with `name` as its identifier on the page.

    `details`: see the top of this file; axes by the gids of their groups.
    """
    prefix = f"f{zlib.crc32(name.encode()):x}"
    root = ElementTree.fromstring(source)
    drawing = _Drawing(root, prefix)
    body = drawing.group(root)
    shown = {"a": [details["axes"][gid] for gid in drawing.axes if gid in details["axes"]]}
    if details["series"]:
        shown["s"] = details["series"]
    plot = f" data-plot='{_attribute(json.dumps(shown, ensure_ascii=False, separators=(',', ':')))}'" if shown["a"] else ""
    box = root.attrib["viewBox"]
    return f'<svg class="pl" id="{name}" viewBox="{box}" role="img" aria-label="{_text(label)}"{plot}>{body}</svg>'


def with_shared_styles(page):
    """The page with each style of its drawings as a class: (page, rules of these classes)."""
    names = {}

    def drawing(found):
        return re.sub(r'<(path|text|g|tspan)(?: class="([^"]*)")?((?: data-\w="[^"]*")*) style="([^"]*)"', element, found.group(0))

    def element(found):
        tag, classes, data, style = found.groups()
        name = names.setdefault(style, f"y{len(names)}")
        return f'<{tag} class="{classes + " " if classes else ""}{name}"{data}'

    page = re.sub(r'<svg class="pl".*?</svg>', drawing, page, flags=re.DOTALL)
    return page, "\n".join(f".pl .{name}{{{style}}}" for style, name in names.items())


def number(value, digits=1):
    """Shortest text of a coordinate: 0.50 is .5, -0 is 0."""
    written = f"{value:.{digits}f}"
    if "." in written:
        written = written.rstrip("0").rstrip(".")
    written = "0" if written in ("-0", "") else written
    return re.sub(r"^(-?)0\.", r"\1.", written)


def _text(words):
    return words.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;").replace('"', "&quot;")


def _attribute(words):
    return words.replace("&", "&amp;").replace("<", "&lt;").replace("'", "&#39;")


# --- paths ----------------------------------------------------------------------------------------


def _commands(path):
    """[(letter, [numbers])] of a path of absolute commands, as matplotlib writes them."""
    found = re.findall(r"([MLCQz])([^MLCQz]*)", path)
    return [(letter, [float(value) for value in numbers.split()]) for letter, numbers in found]


def simplified(places, tolerance=TOLERANCE):
    """The places of a line (n, 2) that it needs to pass all others within the tolerance (Douglas and Peucker)."""
    kept = numpy.zeros(len(places), bool)
    kept[[0, -1]] = True
    spans = [(0, len(places) - 1)]
    while spans:
        first, last = spans.pop()
        if last - first < 2:
            continue
        chord = places[last] - places[first]
        offset = places[first + 1 : last] - places[first]
        length = numpy.hypot(*chord)
        along = numpy.clip(offset @ chord / length**2, 0, 1) if length > 0 else numpy.zeros(len(offset))
        away = numpy.hypot(*(offset - along[:, None] * chord).T)
        if away.max() > tolerance:
            middle = first + 1 + int(away.argmax())
            kept[middle] = True
            spans += [(first, middle), (middle, last)]
    return places[kept]


def path_data(commands, shift=(0.0, 0.0), digits=1):
    """Short text of a path: straight lines simplified, coordinates relative and rounded without adding up."""
    parts, line = [], []
    pen = numpy.zeros(2)  # where the rounded path stands

    def flush():
        nonlocal pen, line
        if line:
            text, pen = _polyline(simplified(numpy.array(line)), digits)
            parts.append(text)
        line = []

    for letter, values in commands:
        places = numpy.reshape(values, (-1, 2)) + shift
        if letter == "M":
            flush()
            line = [places[0]]
        elif letter == "L":
            line = line or [pen]
            line.append(places[0])
        elif letter == "z":
            closed = line[:-1] if len(line) > 2 and numpy.allclose(line[0], line[-1], atol=0.01) else line
            line = closed
            flush()
            parts.append("z")
        else:
            flush()
            relative = numpy.round(places, digits) - pen
            parts.append(letter.lower() + _joined(relative.ravel(), digits))
            pen = numpy.round(places[-1], digits)
    flush()
    return "".join(parts)


def _polyline(places, digits):
    rounded = numpy.round(places, digits)
    return "M" + _joined(rounded[0], digits) + (_segments(numpy.diff(rounded, axis=0), digits) or "h0"), rounded[-1]


def _segments(steps, digits):
    """Straight lines by their steps across and down."""
    text, last = "", ""
    for across, down in steps:
        if abs(across) < 1e-9 and abs(down) < 1e-9:
            continue
        letter, values = ("h", (across,)) if abs(down) < 1e-9 else ("v", (down,)) if abs(across) < 1e-9 else ("l", (across, down))
        words = _joined(values, digits)
        text += (" " if words[0] != "-" and letter == last else "") + words if letter == last else letter + words
        last = letter
    return text


def _joined(values, digits):
    words = ""
    for value in values:
        word = number(value, digits)
        words += (" " if words and word[0] != "-" else "") + word
    return words


# --- elements -------------------------------------------------------------------------------------


def _style(text):
    return dict(part.strip().split(": ", 1) for part in (text or "").split(";") if ": " in part)


def _style_text(style):
    kept = [(name, value) for name, value in style.items() if (name, value) not in _DEFAULTS]
    return f' style="{";".join(f"{name}:{value}" for name, value in kept)}"' if kept else ""


class _Drawing:
    """Turns the elements of one SVG of matplotlib into text."""

    def __init__(self, root, prefix):
        self.prefix = prefix
        self.axes = []  # gids of the axes that have data, in their order
        self.known = {element.get("id"): element for element in root.iter() if element.get("id")}

    def group(self, element, style=None, marks=()):
        """Text of what is in an element; `marks`: classes, number of the label and notes of the line it is part of."""
        parts, uses = [], []
        for child in element:
            name = child.tag.removeprefix(_SVG)
            if name == "use" and (not uses or self._same(uses[-1], child)):
                uses.append(child)
                continue
            parts.append(self._marks(uses, style, marks))
            uses = [child] if name == "use" else []
            if name != "use":
                parts.append(self._element(name, child, style, marks))
        return "".join(parts) + self._marks(uses, style, marks)

    def _element(self, name, element, style, marks):
        if name in ("defs", "metadata", "clipPath"):
            return ""
        if name == "g":
            return self._group(element, {**(style or {}), **_style(element.get("style"))}, marks)
        own = {**(style or {}), **_style(element.get("style"))}
        if name == "path":
            return self._path(element, own, marks)
        if name == "text":
            return self._words(element, own)
        if name == "image":
            element.set(_HREF, raster.smaller("".join(element.get(_HREF).split())))
        attributes = "".join(f' {key.rpartition("}")[2]}="{value}"' for key, value in element.attrib.items() if "clip" not in key and key != "id")
        return f"<{name}{attributes}/>"

    def _group(self, element, style, marks):
        gid = element.get("id") or ""
        if gid.startswith("axes:"):
            return self._axes(element, gid)
        if gid.startswith("hidden:"):
            return ""
        if gid.startswith("line:"):
            marks = tuple(gid.split(":", 3)[1:])
        if element.get("transform"):
            inner = self.group(element, style, marks)
            return f'<g transform="{element.get("transform")}">{inner}</g>' if inner else ""
        return self.group(element, style, marks)

    def _axes(self, element, gid):
        frame, data, above, clip = [], [], [], ""
        for child in element:
            words = self._element(child.tag.removeprefix(_SVG), child, None, ())
            place = child.get("id") or ""
            if place.startswith(("frame", "matplotlib.axis")):
                frame.append(words)
                continue
            inside = next((part.get("clip-path") for part in child.iter() if part.get("clip-path")), "")
            clip = clip or inside
            (above if place.startswith(("axes:", "axes_", "text")) and not inside else data).append(words)
        self.axes.append(gid)
        box = self._clip(clip, len(self.axes))
        data = "".join(data)
        data = f"{box[0]}<g class=\"d\"{box[1]}>{data}</g>"
        return f'<g class="x">{_merged("".join(frame))}</g>{data}{"".join(above)}'

    def _clip(self, clip, count):
        found = self.known.get(clip[5:-1]) if clip else None
        if found is None:
            return "", ""
        box = " ".join(f'{key}="{number(float(found[0].get(key)))}"' for key in ("x", "y", "width", "height"))
        name = f"{self.prefix}-{count}"
        return f'<clipPath id="{name}"><rect {box}/></clipPath>', f' clip-path="url(#{name})"'

    def _path(self, element, style, marks):
        if "stroke" not in style and style.get("fill", "none") == "none":
            return ""
        dashes = style.get("stroke-dasharray", "")
        if dashes:
            style["stroke-dasharray"] = " ".join(number(float(value)) for value in dashes.split(","))
        found = _commands(element.get("d"))
        return f'<path{_line(marks)}{_style_text(style)} d="{path_data(found)}"/>' if found else ""

    @staticmethod
    def _same(one, other):
        return one.get(_HREF) == other.get(_HREF) and one.get("style") == other.get("style")

    def _marks(self, uses, style, marks):
        """All marks of one shape as one path; a filled disc is a line of no length with round ends."""
        if not uses:
            return ""
        shape = self.known[uses[0].get(_HREF)[1:]]
        own = {**(style or {}), **_style(shape.get("style")), **(style or {}), **_style(uses[0].get("style"))}
        commands = _commands(shape.get("d"))
        if not commands:
            return ""
        filled = own.get("fill", "none") != "none" and own.get("fill-opacity") != "0"
        radius = _radius(commands)
        places = [(float(use.get("x")), float(use.get("y"))) for use in uses]
        digits = 2 if len(places) <= _FEW and marks else 1
        if commands[0][0] == "M" and (not marks or "b" in marks[0].split()) and len(places) == 1 and radius is None:
            return f'<path{_line(marks)}{_style_text(own)} d="{path_data(commands, places[0])}"/>'  # an area, not a mark
        if radius is not None and filled:
            edge = float(own.get("stroke-width", 1)) if "stroke" in own else 0
            kept = {key: own[key] for key in ("opacity", "fill-opacity") if key in own}
            own = {"stroke": own["fill"], "stroke-width": number(2 * radius + edge, 2), "stroke-linecap": "round", **kept}
            each = "h0"
            places = _apart(places, 0.3)
        elif radius is not None:
            r = number(radius, 2)
            each = f"m-{r} 0a{r} {r} 0 1 1 0 .1z"  # all but a tenth of a point of the circle, and that straight
        else:
            each = _relative_shape(commands)
        if not filled:
            own = {key: value for key, value in own.items() if key not in ("fill", "fill-opacity")}
        data = "".join(f"M{_joined(place, digits)}{each}" for place in places)
        return f'<path{_line(marks, "m")}{_style_text(own)} d="{data}"/>'

    def _words(self, element, style):
        if len(element):  # parts of a formula: as they are
            inner = "".join(
                f'<tspan{_style_text(_style(part.get("style")))} x="{part.get("x")}" y="{part.get("y")}">{_text(part.text or "")}</tspan>'
                for part in element
            )
            return f"<text{_style_text(style)}>{inner}</text>"
        turned = element.get("transform", "")
        angle = re.match(r"rotate\((-?[\d.]+)", turned)
        x, y = (number(float(element.get(key, 0))) for key in "xy")
        turn = f' transform="rotate({number(float(angle.group(1)))} {x} {y})"' if angle and float(angle.group(1)) else ""
        turn = turn or (f' transform="{turned}"' if turned and not angle else "")
        return f'<text{_style_text(style)} x="{x}" y="{y}"{turn}>{_text(element.text or "")}</text>'


def _line(marks, kind=""):
    classes, label, notes = marks or ("", "", "")
    words = " ".join(word for word in (kind, classes) if word)
    each = notes.split("|")
    said = f' data-n="{_text(each[0] if len(set(each)) == 1 else notes)}"' if kind and notes else ""
    return (f' class="{words}"' if words else "") + (f' data-s="{label}"' if label else "") + said


def _radius(commands):
    """Radius of the circle about the origin that a path of curves draws, else None."""
    if not any(letter == "C" for letter, _ in commands):
        return None
    places = numpy.array([values[-2:] for letter, values in commands if letter != "z"])
    sizes = numpy.hypot(*places.T)
    return float(sizes.mean()) if sizes.min() > 0.95 * sizes.max() > 0 else None


def _relative_shape(commands):
    """A mark drawn from its centre: `M x y` before it places it."""
    text, pen, steps = "", numpy.zeros(2), []
    for letter, values in [*commands, ("", ())]:
        places = numpy.round(numpy.reshape(values, (-1, 2)), 1)
        if letter == "L":
            steps.append(places[0] - pen)
        else:
            text, steps = text + _segments(steps, 1), []
            text += "z" if letter == "z" else ("m" if letter == "M" else letter.lower()) + _joined((places - pen).ravel(), 1)
        pen = places[-1] if len(places) else pen
    return text


def _apart(places, distance):
    """Of places that fall on one another the first."""
    kept = {}
    for x, y in places:
        kept.setdefault((round(x / distance), round(y / distance)), (x, y))
    return list(kept.values())


def _labels(found):
    """Labels in one row, those of a horizontal axis, as one text with a part each; others of one style as a group."""
    rows = []
    for style, x, y, words in re.findall(r'<text( style="[^"]*")? x="([^"]*)" y="([^"]*)">([^<]*)</text>', found.group(0)):
        if not rows or rows[-1][:2] != (style, y):
            rows.append((style, y, []))
        rows[-1][2].append((x, words))
    texts = []
    for style, alike in itertools.groupby(rows, key=lambda row: row[0]):
        alike = list(alike)
        own, group = ("", f"<g{style}>") if style and len(alike) > 1 else (style, "")
        texts += [group, *(_row(own, y, parts) for _, y, parts in alike), "</g>" if group else ""]
    return "".join(texts)


def _row(style, y, parts):
    if len(parts) == 1:
        return f'<text{style} x="{parts[0][0]}" y="{y}">{parts[0][1]}</text>'
    inner = "".join(f'<tspan x="{x}">{words}</tspan>' for x, words in parts)
    return f'<text{style} y="{y}">{inner}</text>'


def _merged(frame):
    """Neighbouring paths of one style as one: the grid, the ticks, the spines."""
    paths, order = {}, []
    for style, data in re.findall(r'<path( style="[^"]*")? d="([^"]*)"/>', frame):
        if style not in paths:
            order.append(style)
        paths.setdefault(style, []).append(data)
    rest = re.sub(r'<path(?: style="[^"]*")? d="[^"]*"/>', "", frame)
    rest = re.sub(r'(?:<text(?: style="[^"]*")? x="[^"]*" y="[^"]*">[^<]*</text>){2,}', _labels, rest)
    return "".join(f'<path{style} d="{"".join(paths[style])}"/>' for style in order) + rest
