"""Pictures of the points of a run: over time, as a film, and the fields at one instant.

Scenes in the plane, axisymmetric ones, which are shown on both sides of the axis, and membranes in space. Nothing is
computed but colours.
"""

from dataclasses import dataclass, field

import matplotlib.cm
import matplotlib.collections
import matplotlib.colors
import numpy
import scipy.interpolate
import scipy.ndimage
import scipy.spatial
from matplotlib.ticker import MaxNLocator

import figures
import raster
import reproduce
import surfaces
import svg
import text
from figures import Figure, Key

STRIP = 6  # pictures of the points over time
MOST_STUDIES = 1  # of a case, whose frames are drawn
FILM_CHARACTERS = 200_000  # of a film's address at most
ALL_FILM_CHARACTERS = 180_000  # of all films of a page
_STRIP_WIDTH, _FILM_WIDTH, _FIELD_WIDTH, _SURFACE_WIDTH = 210, 440, 320, 420  # pixels
_LEAST_FILM_WIDTH = 220  # below it frames are left out instead
_HOLD = 1.5  # s that a film stays on its last frame
_SECOND_PER_FRAME = 0.16
_NEAR = 0.12  # walls so near to the points, in sizes of what they occupy, are shown
_FIELDS = {
    "gas": ("pressure", "Pressure of the gas", raster.FIELD),
    "membrane": ("stress", "Stress along the membrane", raster.STRESS),
    "solid": ("stress", "Difference of the principal stresses", raster.STRESS),
}


@dataclass
class Strip:
    """Points at some instants: [(time as text, address of the picture)]."""

    title: str
    caption: str
    label: str  # what one sees, for those who do not
    cells: list
    shape: float  # width over height
    files: list
    keys: list = field(default_factory=list)
    svg: str = ""  # the scale of colours, where there is one
    commands: list = field(default_factory=list)


@dataclass
class Film:
    title: str
    caption: str
    label: str
    times: list  # texts
    picture: str  # address: all frames side by side
    shape: float
    seconds: float
    files: list
    keys: list = field(default_factory=list)
    svg: str = ""  # the scale of colours
    commands: list = field(default_factory=list)


def film_characters(cases, results):
    """Length of each film's address, so that those of many cases do not outgrow the page."""
    count = sum(len(_with_frames(case, results)) for case in cases)
    return min(FILM_CHARACTERS, ALL_FILM_CHARACTERS // max(1, count))


def groups(case, results, prefix, most_characters):
    """[{title, strip, film, fields}] of the studies and single runs of a case that kept frames."""
    return [
        _group(entry, level, results[name], f"{prefix}-{number}", most_characters)
        for number, (entry, level, name) in enumerate(_with_frames(case, results))
    ]


def _with_frames(case, results):
    """[(series, level, name of the result)] of those that are drawn."""
    found = []
    for entry in case.series:
        for level in entry.levels:
            result = results.get(level.get("file"))
            if result and result.frames and len(result.frames) > 1 and _drawable(result.frames):
                if result.name not in [name for _, _, name in found]:
                    found.append((entry, level, result.name))
    return found[:MOST_STUDIES]


def _drawable(frames):
    return frames.grid["dim"] == 2 or surfaces.surface_of(frames) is not None


def _group(entry, level, result, prefix, most_characters):
    cells = (level.get("settings") or {}).get("cells")
    run = f"{entry.label}, {text.count(cells)} cells" if isinstance(cells, (int, float)) else entry.label
    surface = surfaces.surface_of(result.frames)
    if surface is not None:
        fields, drawn = [], {"strip": surface_strip(surface, run, result.name, f"{prefix}-surface"), "film": None}
    else:
        view = View(result.frames)
        # Of the first run only: those of another differ too little to be worth their weight.
        kinds = _FIELDS if prefix.endswith("-0") else ()
        fields = [field_at_one_time(view, kind, run, result.name, f"{prefix}-{kind}") for kind in kinds]
        drawn = {
            "strip": strip(view, run, result.name),
            "film": film(view, run, result.name, f"{prefix}-film", most_characters),
        }
    command = reproduce.pictures(level, len(result.frames))
    for picture in (*drawn.values(), *fields):
        if picture and command:
            picture.commands = [command]
    return {
        "title": run,
        "points": text.count(level.get("points")) if level.get("points") else "",
        **drawn,
        "fields": [drawn for drawn in fields if drawn],
    }


# --- what there is to see -------------------------------------------------------------------------


class View:
    """The frames of a run, the window that shows all of them, and colours of the bodies."""

    def __init__(self, frames):
        self.frames, self.grid, self.bodies = frames, frames.grid, frames.bodies
        self.mirrored = self.grid["axisymmetric"]
        self.low, self.high = self._window()
        self._spacings = {}
        counts = {}
        self.colours = []
        for body in self.bodies:
            choice = raster.BODIES.get(body["kind"], raster.BODIES["solid"])
            self.colours.append(choice[counts.get(body["kind"], 0) % len(choice)])
            counts[body["kind"]] = counts.get(body["kind"], 0) + 1

    @property
    def shape(self):
        return (self.high[0] - self.low[0]) / (self.high[1] - self.low[1])

    def kinds(self):
        return list(dict.fromkeys(body["kind"] for body in self.bodies))

    def body(self, frame, number):
        """Points of a body; in axisymmetric scenes those of the other side behind them."""
        points = self.frames.body(frame, number)
        places = points["position"][:, :2].astype(float)
        if self.mirrored:
            points = {name: numpy.concatenate([values, values]) for name, values in points.items()}
            places = numpy.concatenate([places, places * (-1, 1)])
        return {**points, "position": places}

    def lines(self, number, places):
        """The lines of a chain: (places, indices of the points at their ends) on each side of the axis."""
        parts = numpy.array_split(numpy.arange(len(places)), 2) if self.mirrored else [numpy.arange(len(places))]
        closed = self.bodies[number].get("closed")
        return [numpy.append(part, part[0]) if closed and len(part) else part for part in parts]

    def spacing(self, frame, number):
        """Of each point of a body, its mean distance from the six next ones, m; at most two cells."""
        if (frame, number) not in self._spacings:
            places = self.body(frame, number)["position"]
            self._spacings[frame, number] = self._distances(places)
        return self._spacings[frame, number]

    def _distances(self, places):
        if len(places) < 2 or not numpy.isfinite(places).all():
            return numpy.full(len(places), self.grid["h"] / 2)
        near = scipy.spatial.cKDTree(places).query(places, min(7, len(places)))[0][:, 1:]
        return numpy.minimum(near.mean(axis=1), 2 * self.grid["h"])

    def walls(self):
        """[(start, end)] of the walls in the window, and of the axis."""
        sides = []
        for direction, kinds in enumerate(self.grid["walls"]):
            for side, kind in enumerate(kinds):
                place = (self.grid["low"], self.grid["high"])[side][direction]
                axis = self.mirrored and direction == 0
                if kind != "free" and not (axis and side == 0):
                    sides += [(direction, place)] + [(direction, -place)] * axis
        return [
            self._across(direction, place)
            for direction, place in sides
            if self.low[direction] <= place <= self.high[direction]
        ]

    def axis(self):
        return self._across(0, 0.0) if self.mirrored else None

    def _across(self, direction, place):
        ends = numpy.array([self.low, self.high], float)
        ends[:, direction] = place
        return ends

    def _window(self):
        places = self.frames.points["position"][:, :2]
        places = places[numpy.isfinite(places).all(axis=1)]
        low, high = places.min(axis=0).astype(float), places.max(axis=0).astype(float)
        if self.mirrored:
            low[0], high[0] = -high[0], high[0]
        size = max((high - low).max(), self.grid["h"])
        for direction, kinds in enumerate(self.grid["walls"]):
            for side, kind in enumerate(kinds):
                place = (self.grid["low"], self.grid["high"])[side][direction]
                if kind == "free" or (self.mirrored and direction == 0 and side == 0):
                    continue
                if side == 0 and 0 <= low[direction] - place < _NEAR * size:
                    low[direction] = place
                if side == 1 and 0 <= place - high[direction] < _NEAR * size:
                    high[direction] = place
                    if self.mirrored and direction == 0:
                        low[0] = -place
        # a thin thing gets some space, or its picture has no height
        margin = numpy.maximum(0.03 * size, (size / 6 - (high - low)) / 2)
        return low - margin, high + margin

    def words(self):
        """The window in words."""
        across, up = ("r", "z") if self.mirrored else ("x", "y")
        return f"{across} from {_length(self.low[0])} to {_length(self.high[0])} m, {up} from " + (
            f"{_length(self.low[1])} to {_length(self.high[1])} m"
        )


def _length(value):
    return text.number(round(float(value), 3), 3)


def _time(value):
    return f"t = {text.number(float(value), 3)} s"


def _draw_walls(view, canvas, thickness=2.0):
    for start_end in view.walls():
        canvas.line(start_end, raster.WALL, thickness)
    if view.mirrored:
        canvas.line(view.axis(), raster.AXIS, 1, dash=5)


def _draw_chain(view, canvas, number, places, colour, thickness):
    for part in view.lines(number, places):
        canvas.line(places[part], colour, thickness)


# --- points over time -----------------------------------------------------------------------------


def chosen_frames(count, wanted=STRIP):
    """Evenly spaced numbers of frames, the first and the last included."""
    return sorted({round(k) for k in numpy.linspace(0, count - 1, min(count, wanted))})


def strip(view, run, file):
    (numbers,), palette = raster.colour_numbers(tuple(view.colours))
    width, share = _strip_size(view)
    cells = []
    for frame in chosen_frames(len(view.frames)):
        canvas = raster.Canvas(view.low, view.high, width)
        _draw_walls(view, canvas)
        for number in _back_to_front(view):
            points = view.body(frame, number)
            places = points["position"]
            if view.bodies[number]["chain"]:
                _draw_chain(view, canvas, number, places, numbers[number], 2.5)
                if len(places) <= 200:
                    canvas.dots(places, numbers[number], 2.5 / canvas.scale)
            else:
                canvas.dots(places, numbers[number], share * view.spacing(frame, number))
        picture = raster.picture(canvas.pixels, palette)
        cells.append({"time": _time(view.frames.times[frame]), "picture": picture})
    every = view.frames.every
    few = f" One point in {every} is drawn." if every > 1 else ""
    sides = " Both sides of the axis are shown, though one is computed." if view.mirrored else ""
    walls = " Grey lines are walls or planes of symmetry." if view.walls() else ""
    caption = f"The material points: {view.words()}.{walls}{few}{sides}"
    names = text.listing(f"{body['name']} ({body['kind']})" for body in view.bodies)
    label = f"Points of {names} at {text.listing(cell['time'] for cell in cells)}"
    keys = [
        Key(body["name"], colour, "" if body["chain"] else "disc")
        for body, colour in zip(view.bodies, view.colours)
    ]
    return Strip("Points over time", caption, label, cells, view.shape, [file], keys)


def _strip_size(view):
    """(width in pixels, radius of a dot over its distance from others): points are told apart, or fill their area."""
    distances = [
        numpy.median(view.spacing(0, number)) for number, body in enumerate(view.bodies) if not body["chain"]
    ]
    pixel = (view.high[0] - view.low[0]) / _STRIP_WIDTH
    apart = min(distances, default=8 * pixel) / pixel
    width = int(_STRIP_WIDTH * min(1.75, max(1, 5 / apart)))
    return (width, 0.27) if apart * width / _STRIP_WIDTH > 3.4 else (_STRIP_WIDTH, 0.62)


def _back_to_front(view):
    order = ("gas", "solid", "membrane")
    return sorted(
        range(len(view.bodies)), key=lambda number: order.index(view.bodies[number]["kind"])
    )


def surface_strip(frames, run, file, prefix):
    """Membranes in space at some instants, coloured by their larger principal stress, one scale for all."""
    name, title, wanted = "stress", "Larger principal stress", raster.STRESS
    values = frames.points[name]
    values = values[numpy.isfinite(values)].astype(float)
    levels = colour_levels(values)
    ramp = raster.ramp(wanted, len(levels) - 1)
    (numbers,), palette = raster.colour_numbers(surfaces.colours(ramp))
    low, high = surfaces.window(frames)
    cells = []
    for frame in chosen_frames(len(frames)):
        canvas = raster.Canvas(low, high, _SURFACE_WIDTH)
        parts = [frames.body(frame, number) for number in range(len(frames.bodies))]
        places = numpy.concatenate([part["position"] for part in parts])
        steps = _steps(numpy.concatenate([part[name] for part in parts]), levels, range(len(ramp)))
        surfaces.paint(canvas, places, steps, numbers)
        cells.append({"time": _time(frames.times[frame]), "picture": raster.picture(canvas.pixels, palette)})
    unit = text.unit(frames.units.get(name))
    span = f"from {_number(values.min())} to {_number(values.max())} {unit}"
    caption = (
        f"The surface through the material points, seen from {surfaces.ELEVATION} degrees above the plane of x and y, coloured by the larger "
        f"principal stress, {span}: the resultant over the thickness at rest. z points upwards."
    )
    names = text.listing(body["name"] for body in frames.bodies)
    label = f"Surface of {names} at {text.listing(cell['time'] for cell in cells)}"
    scale = scale_of_colours(levels, ramp, f"{title} in {unit}", prefix)
    shape = float((high[0] - low[0]) / (high[1] - low[1]))
    return Strip(f"{title} over time", caption, label, cells, shape, [file], svg=scale)


# --- film -----------------------------------------------------------------------------------------


def film(view, run, file, prefix, most_characters=FILM_CHARACTERS):
    """All frames side by side in one picture, made smaller until its address keeps within `most_characters`."""
    kind = next((kind for kind in _FIELDS if kind in view.kinds()), None)
    name, title, colours = _FIELDS[kind]
    values = _values(view, kind, name)
    if not len(values):
        return None
    levels = colour_levels(values)
    ramp = raster.ramp(colours, len(levels) - 1)
    width, frames = _FILM_WIDTH, chosen_frames(len(view.frames), min(len(view.frames), raster.WIDEST // _FILM_WIDTH))
    while True:
        picture = _reel(view, kind, name, ramp, levels, width, frames)
        if len(picture) <= most_characters or (width == _LEAST_FILM_WIDTH and len(frames) < 8):
            break
        if width > _LEAST_FILM_WIDTH:
            width = max(_LEAST_FILM_WIDTH, int(width * min(0.9, (most_characters / len(picture)) ** 0.5)))
        else:
            frames = [frames[k] for k in chosen_frames(len(frames), (len(frames) + 1) // 2)]
    caption = (
        f"The same points coloured by the {title[0].lower() + title[1:]}, one scale for the whole film: "
        f"{len(frames)} instants from {_time(view.frames.times[frames[0]])} to {_time(view.frames.times[frames[-1]])}."
    )
    unit = view.frames.units.get(name)
    label = f"Film of {run}: {title[0].lower() + title[1:]}, " + (
        f"from {_number(values.min())} to {_number(values.max())} {text.unit(unit)}"
    )
    return Film(
        f"{title}: film",
        caption,
        label,
        [_time(view.frames.times[frame]) for frame in frames],
        picture,
        view.shape,
        round(len(frames) * _SECOND_PER_FRAME + _HOLD, 2),
        [file],
        _other_keys(view, kind),
        scale_of_colours(levels, ramp, f"{title} in {text.unit(unit)}", prefix),
    )


def _reel(view, kind, name, ramp, levels, width, frames):
    (bodies, steps), palette = raster.colour_numbers(tuple(view.colours), ramp)
    pictures = []
    for frame in frames:
        canvas = raster.Canvas(view.low, view.high, width)
        _draw_walls(view, canvas)
        for number in _back_to_front(view):
            points = view.body(frame, number)
            places = points["position"]
            coloured = view.bodies[number]["kind"] == kind
            colours = _steps(points[name], levels, steps) if coloured else bodies[number]
            if view.bodies[number]["chain"]:
                _draw_chain(view, canvas, number, places, bodies[number], 2)
                if coloured:
                    _colour_chain(view, canvas, number, places, colours)
            else:
                canvas.area(places, colours, 0.62 * view.spacing(frame, number))
        pictures.append(canvas.pixels)
    return raster.picture(numpy.concatenate(pictures, axis=1), palette)


def _colour_chain(view, canvas, number, places, colours, thickness=4):
    for part in view.lines(number, places):
        canvas.line(places[part], colours[part[:-1]], thickness)


def _other_keys(view, kind):
    return [
        Key(body["name"], colour, "" if body["chain"] else "disc")
        for body, colour in zip(view.bodies, view.colours)
        if body["kind"] != kind
    ]


def _values(view, kind, name, frames=None):
    """Finite values of a field of all bodies of a kind."""
    parts = [
        view.frames.body(frame, number)[name]
        for frame in (range(len(view.frames)) if frames is None else frames)
        for number, body in enumerate(view.bodies)
        if body["kind"] == kind
    ]
    values = numpy.concatenate(parts) if parts else numpy.array([])
    return values[numpy.isfinite(values)].astype(float)


def colour_levels(values):
    """Edges of steps of colour that are centred on round numbers, where fields that are even have their values; from
    the lowest hundredth of the values to the highest.
    """
    low, high = numpy.percentile(values, (1, 99)) if len(values) else (0.0, 1.0)
    least = 1e-6 * max(abs(low), abs(high), 1e-30)
    if high - low < least:
        low, high = low - least, high + least
    centres = MaxNLocator(12, steps=(1, 2, 2.5, 5, 10)).tick_values(low, high)
    return numpy.append(centres[0] - (centres[1] - centres[0]) / 2, (centres + (centres[1] - centres[0]) / 2))


def _ticks(levels):
    centres = (levels[1:] + levels[:-1]) / 2
    return centres[:: 1 + len(centres) // 8]


def _steps(values, levels, steps):
    place = numpy.searchsorted(levels, values, side="right") - 1
    return numpy.asarray(steps, numpy.uint8)[numpy.clip(place, 0, len(steps) - 1)]


def _number(value):
    return text.number(float(value), 3)


def scale_of_colours(levels, ramp, label, prefix):
    def paint(axes):
        colours = matplotlib.colors.ListedColormap(ramp)
        axes.pcolormesh(levels, [0, 1], numpy.arange(len(ramp))[None, :], cmap=colours)
        axes.set(xlabel=label, yticks=[], xticks=_ticks(levels))
        axes.grid(False)
        axes.spines["left"].set_visible(False)
        figures.plain_axis(axes.xaxis)

    return svg.draw(paint, prefix, f"Scale of colours: {label}", height=0.62)


# --- one field at one instant -----------------------------------------------------------------------


def field_at_one_time(view, kind, run, file, prefix):
    """Steps of a field: of gas and solids over the area that their points occupy, of membranes along them."""
    name, title, colours = _FIELDS[kind]
    if kind not in view.kinds():
        return None
    frame, when = len(view.frames) - 1, "at the end of the run"
    if kind == "solid":
        largest = [numpy.max(_values(view, kind, name, [k]), initial=0.0) for k in range(len(view.frames))]
        frame, when = int(numpy.argmax(largest)), "when it is largest"
    values = _values(view, kind, name, [frame])
    if not len(values):
        return None
    levels = colour_levels(values)
    ramp = raster.ramp(colours, len(levels) - 1)
    unit = text.unit(view.frames.units.get(name))

    def paint(axes):
        _paint_field(axes, view, frame, kind, name, ramp, levels, f"{title.split(' of ')[0]} in {unit}")

    time = _time(view.frames.times[frame])
    caption = (
        f"{title} {when}, {time}, from {_number(values.min())} to {_number(values.max())} {unit}; a hundredth of the "
        "points at either end lies beyond the scale."
    )
    if kind != "membrane":
        caption += " Between points the values are interpolated."
    drawing = svg.draw(paint, prefix, f"{title} {when} of {run}", height=min(4.4, max(1.9, 3.2 / view.shape + 0.55)))
    return Figure(drawing, f"{title} {when}", caption, [file], _other_keys(view, kind))


def _paint_field(axes, view, frame, kind, name, ramp, levels, label):
    colours = matplotlib.colors.ListedColormap(ramp)
    steps = matplotlib.colors.BoundaryNorm(levels, len(ramp))
    drawn = matplotlib.cm.ScalarMappable(steps, colours)
    for number in _back_to_front(view):
        points, body = view.body(frame, number), view.bodies[number]
        places = points["position"]
        if body["kind"] == kind and not body["chain"]:
            grid, extent = on_pixels(places, points[name], view.spacing(frame, number), view)
            axes.imshow(grid, extent=extent, origin="lower", cmap=colours, norm=steps, interpolation="none", zorder=1)
        elif body["chain"]:
            _paint_chain(axes, view, number, places, colours(steps(points[name])) if body["kind"] == kind else None)
        else:
            few = places[:: max(1, len(places) // 250)]
            axes.plot(*few.T, ".", markersize=1.6, color=view.colours[number], alpha=0.6, zorder=0)
    for ends in view.walls():
        axes.plot(*ends.T, color=svg.MUTED, linewidth=1.8, zorder=3)
    if view.mirrored:
        axes.plot(*view.axis().T, color=svg.MUTED, linewidth=0.8, dashes=(6, 3, 1, 3), zorder=3)
    axes.set(xlim=(view.low[0], view.high[0]), ylim=(view.low[1], view.high[1]), aspect="equal")
    axes.set(xlabel="r in m" if view.mirrored else "x in m", ylabel="z in m" if view.mirrored else "y in m")
    axes.grid(False)
    figures.plain_axis(axes.xaxis)
    figures.plain_axis(axes.yaxis)
    beside = axes.inset_axes((1.04, 0, 0.09 * min(1, 0.5 / view.shape), 1))
    bar = axes.figure.colorbar(drawn, cax=beside, label=label, ticks=_ticks(levels))
    figures.plain_axis(bar.ax.yaxis)


def _paint_chain(axes, view, number, places, colours):
    for part in view.lines(number, places):
        if colours is None:
            axes.plot(*places[part].T, color=view.colours[number], linewidth=1.6, zorder=2)
            continue
        # Pieces of one colour are one broken line: a picture of hundreds of pieces weighs little.
        shades = colours[part[:-1]]
        gap = numpy.full(2, numpy.nan)
        for shade in numpy.unique(shades, axis=0):
            chosen = numpy.flatnonzero((shades == shade).all(axis=1))
            pieces = []
            for run in numpy.split(chosen, numpy.flatnonzero(numpy.diff(chosen) > 1) + 1):
                pieces += [*places[part[run[0] : run[-1] + 2]], gap]
            axes.plot(*numpy.array(pieces).T, color=shade, linewidth=3.2, zorder=2)


def on_pixels(places, values, spacing, view):
    """Values on square pixels, linear between points, NaN where no point is near; and the extent for imshow."""
    width = _FIELD_WIDTH
    size = (view.high[0] - view.low[0]) / width
    height = max(1, round((view.high[1] - view.low[1]) / size))
    x = view.low[0] + size * (numpy.arange(width) + 0.5)
    y = view.low[1] + size * (numpy.arange(height) + 0.5)
    pixels = numpy.stack(numpy.meshgrid(x, y), axis=-1).reshape(-1, 2)
    distance, nearest = scipy.spatial.cKDTree(places).query(pixels)
    inside = distance <= numpy.maximum(0.8 * spacing[nearest], size)
    inside = scipy.ndimage.binary_closing(inside.reshape(height, width), iterations=3).ravel() | inside
    grid = numpy.full(len(pixels), numpy.nan)
    grid[inside] = values[nearest[inside]]
    if len(places) > 3:
        between = scipy.interpolate.LinearNDInterpolator(places, values.astype(float))(pixels[inside])
        grid[inside] = numpy.where(numpy.isfinite(between), between, grid[inside])
    extent = (view.low[0], view.low[0] + width * size, view.low[1], view.low[1] + height * size)
    return grid.reshape(height, width), extent
