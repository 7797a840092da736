"""Maps of stability: a heat map over two axes with the outline of what is stable, exact curves and what runs found.

A map is a small picture, one pixel a value, under lines that the browser draws: a hundred of them weigh little, and one
serves both as thumbnail and, opened, as figure with axes. The outline runs between samples; nothing is interpolated.
"""

import math
from dataclasses import dataclass, field

import numpy
from matplotlib.ticker import MaxNLocator

import raster
import text
from figures import tick

STEPS = 14  # of each scale of colours
UNIT_LEVEL = 1.0  # of limits: outlined is where the rule "Courant number 1" is too large
THRESHOLD = 1e-6  # growth per step that counts as such where the document names none
MOST_LINES = 6  # of the cuts through a map of limits


@dataclass
class Axis:
    """Numbers in ascending order, or names; place() counts samples from 0, halves being the middles."""

    label: str
    values: list

    def __post_init__(self):
        steps = numpy.diff(self.values) if all(isinstance(v, (int, float)) for v in self.values) else None
        self.numeric = steps is not None and bool((steps > 0).all())
        self.even = self.numeric and len(steps) > 0 and bool(numpy.allclose(steps, steps[0], rtol=1e-3))

    def place(self, value):
        """Where a value lies along the axis, beyond its ends as the outermost spacing goes on; None if nowhere."""
        if value is None:
            return None
        if not self.numeric or len(self.values) == 1:
            return self.values.index(value) + 0.5 if value in self.values else None
        known, last = numpy.asarray(self.values, float), len(self.values) - 1
        index = float(numpy.interp(value, known, range(last + 1)))
        if value < known[0]:
            index = (value - known[0]) / (known[1] - known[0])
        elif value > known[-1]:
            index = last + (value - known[-1]) / (known[-1] - known[-2])
        return float(numpy.clip(index, -last, 2 * last)) + 0.5

    def ticks(self, most=5):
        """[(share of the length in %, label)]: round numbers where the samples are even, else some samples."""
        if self.even and len(self.values) > most:
            chosen = MaxNLocator(most - 1, steps=[1, 2, 2.5, 5, 10]).tick_values(self.values[0], self.values[-1])
            half = 0.501 * (self.values[1] - self.values[0])
            chosen = [value for value in chosen if self.values[0] - half <= value <= self.values[-1] + half]
        else:
            last = len(self.values) - 1
            every = numpy.linspace(0, last, min(most, last + 1)).round().astype(int)
            chosen = [self.values[index] for index in numpy.unique(every)]
        return [(_share(self.place(value), len(self.values)), _label(value)) for value in chosen]

    @property
    def ends(self):
        return f"{self.label} {_label(self.values[0])} … {_label(self.values[-1])}"


def _label(value):
    """A number to four digits; a name as it is."""
    return value if isinstance(value, str) else text.number(None if value is None else round(float(value), 12), 4)


def _share(place, length):
    return round(100 * place / length, 2)


# --- colours --------------------------------------------------------------------------------------


@dataclass
class Scale:
    """Colours of values between low and high; of growth those of the logarithm of what a step adds."""

    low: float
    high: float
    growth: bool = False
    threshold: float = THRESHOLD

    def __post_init__(self):
        self.colours = raster.ramp(raster.STRESS if self.growth else raster.FIELD, STEPS)
        self.palette = [tuple(bytes.fromhex(colour[1:])) for colour in self.colours]

    def numbers(self, values):
        """Colour number of each value: 0 what is stable or unknown, 1 ... the ramp."""
        values = numpy.asarray(values, float)
        known = numpy.isfinite(values)
        grows = known & (values - 1 > self.threshold) if self.growth else known
        amount = numpy.log10(numpy.where(grows, values - 1, 1)) if self.growth else numpy.where(known, values, 0)
        share = (amount - self.low) / max(self.high - self.low, 1e-300)
        steps = numpy.clip((share * STEPS).astype(int), 0, STEPS - 1)
        return numpy.where(grows, 1 + steps, 0).astype(numpy.uint8)

    def colour(self, value):
        return self.colours[int(self.numbers([[value]])[0, 0]) - 1]

    @property
    def ticks(self):
        """[(share in %, label)] of the bar of colours."""
        if not self.growth:
            found = MaxNLocator(5).tick_values(self.low, self.high) if self.high > self.low else [self.low]
            found = [value for value in found if self.low <= value <= self.high] or [self.low, self.high]
            return [(_share(value - self.low, max(self.high - self.low, 1e-300)), _label(value)) for value in found]
        powers = range(math.ceil(self.low - 1e-9), math.floor(self.high + 1e-9) + 1)
        every = max(1, -(-len(powers) // 6))
        return [(_share(power - self.low, self.high - self.low), tick(10.0**power)) for power in powers[::every]]

    @property
    def picture(self):
        pixels = numpy.arange(1, 1 + STEPS, dtype=numpy.uint8)[None, :]
        return raster.picture(pixels, self.palette)


def scale_of(maps, growth, threshold=THRESHOLD):
    """One scale for all maps of a kind."""
    values = [value for entry in maps for row in entry["values"] for value in row if value is not None]
    if not growth:
        return Scale(min(values, default=0.0), max(values, default=1.0))
    low = round(math.log10(threshold), 9)
    most = max((value - 1 for value in values if value - 1 > threshold), default=10 * threshold)
    return Scale(low, max(math.ceil(math.log10(most)), low + 1), True, threshold)


# --- one map --------------------------------------------------------------------------------------


@dataclass
class Cut:
    """One row of a map of limits as a line: paths in samples across and hundredths up."""

    name: str
    colour: str
    line: str
    closed: str
    bars: str


@dataclass
class Map:
    """What the template draws; paths count samples, from the left and from above."""

    title: str
    own_title: str
    words: str
    label: str
    name: str
    picture: str
    across: int
    down: int
    x: Axis
    y: Axis
    outline: str
    unknown: str  # area of samples without a value
    closed: str
    bars: str  # observed brackets along y
    spans: str  # observed brackets that belong to no single wave number
    dots: list  # (path, colour): observed limits in the colour of their value
    observed: list  # rows of the table
    growth: bool
    cuts: list = field(default_factory=list)
    cut_ticks: list = field(default_factory=list)


def draw(entry, scale, unit):
    """The map as the template needs it, of a map of the document."""
    values = numpy.array([[math.nan if value is None else value for value in row] for row in entry["values"]], float)
    values, closed, x, y = _ascending(values, entry)
    level = 1 + scale.threshold if scale.growth else UNIT_LEVEL
    choices = [str(entry[key]) for key in ("integrator", "transfer") if entry.get(key)]
    title = " · ".join(choices) or entry.get("id") or ""
    words = _words(values, y, scale, unit)
    drawn = Map(
        title=title,
        own_title=entry.get("title") or "",
        words=words,
        label=f"{entry.get('title') or title}: {words}",
        name=entry.get("id") or "",
        picture=raster.picture(scale.numbers(values)[::-1], scale.palette),
        across=values.shape[1],
        down=values.shape[0],
        x=x,
        y=y,
        outline=outline(values, level),
        unknown=_unknown(values),
        closed=_curve(entry, x, y) if scale.growth else outline(closed, level) if closed is not None else "",
        bars="",
        spans="",
        dots=[],
        observed=[],
        growth=scale.growth,
    )
    for found in entry["observed"]:
        _observe(drawn, found, values, scale)
    if not scale.growth:
        _cut(drawn, values, closed, entry["observed"])
    return drawn


def _ascending(values, entry):
    """Values, closed form and axes, turned where an axis descends."""
    closed = entry.get("closed_form")
    if closed is not None:
        closed = numpy.array([[math.nan if value is None else value for value in row] for row in closed], float)
    axes = []
    for number, name in enumerate(("x", "y")):
        known = list(entry[name]["values"])
        label = entry[name].get("label") or entry[name].get("name") or name
        if len(known) > 1 and Axis("", known[::-1]).numeric:
            known = known[::-1]
            values = numpy.flip(values, 1 - number)
            closed = numpy.flip(closed, 1 - number) if closed is not None else None
        axes.append(Axis(label, known))
    return values, closed, *axes


def outline(values, level):
    """Path along the edges between samples above the level and samples not above it."""
    above, known = values > level, numpy.isfinite(values)
    rows = len(values)
    parts = []
    upright = (above[:, 1:] != above[:, :-1]) & known[:, 1:] & known[:, :-1]
    for column in range(upright.shape[1]):
        parts += [f"M{column + 1} {rows - end}V{rows - start}" for start, end in _stretches(upright[:, column])]
    level_edges = (above[1:] != above[:-1]) & known[1:] & known[:-1]
    for row in range(level_edges.shape[0]):
        parts += [f"M{start} {rows - row - 1}H{end}" for start, end in _stretches(level_edges[row])]
    return "".join(parts)


def _unknown(values):
    """Path around each stretch of a row that has no value."""
    rows = len(values)
    return "".join(
        f"M{start} {rows - row}V{rows - row - 1}H{end}V{rows - row}Z"
        for row in range(rows)
        for start, end in _stretches(~numpy.isfinite(values[row]))
    )


def _stretches(flags):
    """[(start, end)] of the stretches of true flags."""
    steps = numpy.flatnonzero(numpy.diff(numpy.concatenate([[0], flags.astype(int), [0]])))
    return list(zip(steps[::2].tolist(), steps[1::2].tolist()))


def _curve(entry, x, y):
    """The closed form over the map, with gaps where it has none."""
    parts, pen = [], "M"
    for point in entry["closed_form_curve"]:
        across, up = x.place(point.get("x")), y.place(point.get("y"))
        if across is None or up is None:
            pen = "M"
            continue
        parts.append(f"{pen}{across:.5g} {len(y.values) - up:.5g}")
        pen = "L"
    return "".join(parts)


def _observe(drawn, found, values, scale):
    """A bracket that runs found: a row of the table, and a mark."""
    low, high = found.get("low"), found.get("high")
    row = {"x": _label(found.get("x")), "y": _label(found.get("y")), "bracket": bracket(low, high)}
    across = drawn.x.place(found.get("x"))
    ends = [end for end in (low, high) if end is not None]
    if drawn.growth:
        up = [drawn.down - drawn.y.place(end) for end in ends] if drawn.y.numeric else []
        if up and across is not None:
            drawn.bars += f"M{across:.5g} {up[0]:.5g}V{up[-1]:.5g}"
        elif up and found.get("x") is None:
            drawn.spans += "".join(f"M0 {place:.5g}H{drawn.across}" for place in dict.fromkeys(up))
    else:
        up = drawn.y.place(found.get("y"))
        if ends and across is not None and up is not None:
            middle = sum(ends) / len(ends)
            drawn.dots.append((f"M{across:.5g} {drawn.down - up:.5g}h0", scale.colour(middle)))
            predicted = _sample(drawn, values, found)
            row["predicted"] = text.number(predicted, 5)
            row["difference"] = percent(middle, predicted)
    drawn.observed.append(row)


def _sample(drawn, values, found):
    """The value of the map at the very place, or None."""
    places = []
    for axis, value in ((drawn.y, found.get("y")), (drawn.x, found.get("x"))):
        index = axis.place(value) - 0.5
        if abs(index - round(index)) > 1e-6 or not 0 <= round(index) < len(axis.values):
            return None
        places.append(round(index))
    value = float(values[tuple(places)])
    return value if math.isfinite(value) else None


def bracket(low, high):
    """'1.832 … 1.834' with digits enough to tell the ends apart."""
    if low is None and high is None:
        return text.MISSING
    if low is None or high is None:
        return f"below {text.number(high, 5)}" if low is None else f"above {text.number(low, 5)}"
    digits = next((d for d in range(5, 16) if text.number(low, d) != text.number(high, d)), 5)
    return f"{text.number(low, digits)} … {text.number(high, digits)}"


def percent(value, over):
    """How far a value lies from another, in % of that other, with its sign."""
    if value is None or not over:
        return text.MISSING
    share = 100 * (value / over - 1)
    return ("+" if share > 0 else "") + text.number(round(share, 12), 2) + "\u202f%"


def _words(values, y, scale, unit):
    known = values[numpy.isfinite(values)]
    if not len(known):
        return "nothing determined"
    if not scale.growth:
        low, high = (text.number(float(value), 4) for value in (known.min(), known.max()))
        missing = values.size - len(known)
        reach = low if low == high else f"{low} … {high}"
        return f"{reach} {unit}".strip() + (f", {missing} undetermined" if missing else "")
    stable = values - 1 <= scale.threshold
    if not stable.any():
        return "grows everywhere"
    grows = numpy.flatnonzero((values - 1 > scale.threshold).any(axis=1))
    if not len(grows):
        return "stable everywhere"
    if grows[0] == 0:
        return "grows at the smallest step"
    return f"stable to {_label(y.values[grows[0] - 1])} {unit}".strip()


# --- cuts -----------------------------------------------------------------------------------------


def _cut(drawn, values, closed, observed):
    """The rows of a map of limits as lines over x."""
    known = values[numpy.isfinite(values)]
    if not len(known) or drawn.across < 2:
        return
    exact = closed[numpy.isfinite(closed)] if closed is not None else known
    top = 1.06 * max(known.max(), exact.max(initial=0), 1e-300)
    chosen = numpy.unique(numpy.linspace(0, drawn.down - 1, min(MOST_LINES, drawn.down)).round().astype(int))
    for number, row in enumerate(chosen):
        here = [entry for entry in observed if drawn.y.place(entry.get("y")) == row + 0.5]
        drawn.cuts.append(
            Cut(
                name=f"{drawn.y.label} {_label(drawn.y.values[row])}",
                colour=f"var(--s{number + 1})",
                line=_polyline(values[row], top),
                closed=_polyline(closed[row], top) if closed is not None else "",
                bars="".join(_bar(drawn.x.place(entry.get("x")), entry, top) for entry in here),
            )
        )
    ticks = MaxNLocator(4).tick_values(0, top)
    drawn.cut_ticks = [(_share(value, top), _label(value)) for value in ticks if 0 <= value <= top]


def _polyline(values, top):
    parts, pen = [], "M"
    for index, value in enumerate(values):
        if not math.isfinite(value):
            pen = "M"
            continue
        parts.append(f"{pen}{index + 0.5:g} {100 - 100 * value / top:.4g}")
        pen = "L"
    return "".join(parts)


def _bar(across, entry, top):
    ends = [100 - 100 * end / top for end in (entry.get("low"), entry.get("high")) if end is not None]
    return f"M{across:.5g} {ends[0]:.4g}V{ends[-1]:.4g}" if ends and across is not None else ""
