"""Small pictures of coloured dots and lines with few colours, and how they get into a page.

A picture is an array of colour numbers, one a pixel, 0 being nothing: it compresses well and looks the same on every
machine. The colours are of middle lightness, legible on a light and on a dark page.
"""

import base64
import io

import numpy
from PIL import Image

WALL, AXIS = 1, 2
WIDEST = 16383  # pixels that a WebP picture may have across
_FIXED = {WALL: "#808a94", AXIS: "#808a94"}
BODIES = {  # of each kind, in turn
    "gas": ("#83a9d1", "#9fb98a", "#b9a3cf"),
    "solid": ("#5f97cc", "#d08a4e", "#58a88b", "#b574a8"),
    "membrane": ("#d2532a", "#a04fb8", "#2f9a78"),
}
# Places along viridis and plasma without their ends, which vanish on a dark or on a light page.
FIELD = ("#443983", "#3e4a89", "#37598c", "#31688e", "#2b758e", "#26828e", "#21908d", "#1f9d8a", "#26ab82", "#37b878",
         "#50c46a", "#6ece58", "#90d743", "#b5de2b")
STRESS = ("#5c01a6", "#7401a8", "#8b0aa5", "#a01a9c", "#b42e8d", "#c43e7f", "#d24f71", "#df6263", "#ea7457", "#f3874a",
          "#f99a3e", "#fdaf31", "#fdc627", "#f8df25")


def ramp(colours, count):
    """`count` colours evenly spaced along a list of colours."""
    known = numpy.array([list(bytes.fromhex(colour[1:])) for colour in colours], float)
    places = numpy.linspace(0, len(known) - 1, count)
    mixed = [numpy.interp(places, range(len(known)), channel) for channel in known.T]
    return tuple("#%02x%02x%02x" % tuple(round(value) for value in colour) for colour in zip(*mixed))


def colour_numbers(*groups):
    """Numbers of the colours of each group in one palette, and the palette: [(r, g, b)] from number 1 on."""
    palette = [_FIXED[WALL], _FIXED[AXIS]]
    numbers = []
    for group in groups:
        numbers.append(range(len(palette) + 1, len(palette) + 1 + len(group)))
        palette += group
    return numbers, [tuple(bytes.fromhex(colour[1:])) for colour in palette]


class Canvas:
    """Pixels over a window (low, high) of the plane, y upwards."""

    def __init__(self, low, high, width):
        self.low, self.scale = numpy.asarray(low, float), (width - 1) / (high[0] - low[0])
        height = max(8, round((high[1] - low[1]) * self.scale) + 1)
        self.pixels = numpy.zeros((height, width), numpy.uint8)

    def dots(self, places, colours, radius):
        """A disc for each of `places` (n, 2); `colours` and `radius` (in lengths of the plane) one or n of them."""
        column, row = self._pixels(places)
        colours = numpy.broadcast_to(numpy.asarray(colours, numpy.uint8), len(column))
        sizes = numpy.asarray(radius, float) * self.scale
        sizes = numpy.where(sizes > 3, numpy.rint(sizes), numpy.rint(2 * sizes) / 2)
        sizes = numpy.broadcast_to(numpy.clip(sizes, 0.5, 12), len(column))
        for size in numpy.unique(sizes):
            chosen = sizes == size
            for across, down in _disc(size):
                self._set(column[chosen] + across, row[chosen] + down, colours[chosen])

    def line(self, places, colours, thickness=1.5, dash=0):
        """A line through the places, of one colour or of one for each of its pieces, `thickness` and `dash` (0: none) in
        pixels."""
        places = numpy.asarray(places, float)
        drawn = numpy.isfinite(places[:-1]).all(axis=1) & numpy.isfinite(places[1:]).all(axis=1)
        start, length = places[:-1][drawn], (places[1:] - places[:-1])[drawn]
        colours = numpy.broadcast_to(numpy.asarray(colours, numpy.uint8), len(drawn))[drawn]
        steps = (2 * numpy.abs(length).max(axis=1, initial=0) * self.scale).astype(int) + 2
        piece = numpy.repeat(numpy.arange(len(steps)), steps)
        step = numpy.arange(len(piece)) - numpy.repeat(numpy.cumsum(steps) - steps, steps)
        if dash:
            kept = (step // (2 * dash)) % 2 == 0
            piece, step = piece[kept], step[kept]
        share = step / (steps[piece] - 1)
        self.dots(start[piece] + share[:, None] * length[piece], colours[piece], thickness / 2 / self.scale)

    def area(self, places, colours, radius, gap=3):
        """Dots, and the gaps between them of up to so many pixels: the area that the points occupy."""
        layer = numpy.zeros_like(self.pixels)
        self.pixels, below = layer, self.pixels
        self.dots(places, colours, radius)
        self.pixels = below
        taken = _without_gaps(_without_gaps(layer, gap).T, gap).T
        self.pixels[taken > 0] = taken[taken > 0]

    def _pixels(self, places):
        places = (numpy.asarray(places, float)[:, :2] - self.low) * self.scale
        places = numpy.where(numpy.isfinite(places), places, -1e6)
        return numpy.rint(places[:, 0]).astype(int), len(self.pixels) - 1 - numpy.rint(places[:, 1]).astype(int)

    def _set(self, column, row, colours):
        height, width = self.pixels.shape
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        self.pixels[row[inside], column[inside]] = colours[inside]


def _without_gaps(pixels, gap):
    """Each row with its gaps of up to `gap` pixels filled from their left."""
    columns = numpy.arange(pixels.shape[1])
    last = numpy.maximum.accumulate(numpy.where(pixels > 0, columns, -1), axis=1)
    following = numpy.where(pixels > 0, columns, len(columns) + gap)[:, ::-1]
    following = numpy.minimum.accumulate(following, axis=1)[:, ::-1]
    inside = (pixels == 0) & (last >= 0) & (following - last <= gap + 1)
    return numpy.where(inside, numpy.take_along_axis(pixels, numpy.maximum(last, 0), axis=1), pixels)


def _disc(radius):
    reach = range(-int(radius), int(radius) + 1)
    return [(across, down) for across in reach for down in reach if across**2 + down**2 <= radius**2 + 0.3]


def picture(pixels, palette):
    """Address of a picture in the colours of a palette, number 0 transparent."""
    colours = numpy.zeros((1 + len(palette), 4), numpy.uint8)
    colours[1:, :3] = palette
    colours[1:, 3] = 255
    return _address(Image.fromarray(colours[pixels]))


def smaller(address):
    """Address of the picture that a PNG is."""
    content = base64.b64decode(address.removeprefix("data:image/png;base64,"))
    return _address(Image.open(io.BytesIO(content)).convert("RGBA"))


def _address(image):
    """As WebP without loss, a third smaller than PNG."""
    written = io.BytesIO()
    image.save(written, "WEBP", lossless=True, quality=100, method=4)
    return "data:image/webp;base64," + base64.b64encode(written.getvalue()).decode("ascii")
