"""Pictures of membranes in space: surfaces through their points, seen from above and lit from the left, coloured by the
larger principal stress.
"""

import dataclasses

import numpy
import scipy.spatial

import raster

ELEVATION = 25  # of the viewer above the plane of x and y, degrees
_AZIMUTH, _ELEVATION = numpy.radians(-60), numpy.radians(ELEVATION)
_RIGHT = numpy.array([-numpy.sin(_AZIMUTH), numpy.cos(_AZIMUTH), 0])
_TOWARDS = numpy.array(
    [numpy.cos(_ELEVATION) * numpy.cos(_AZIMUTH), numpy.cos(_ELEVATION) * numpy.sin(_AZIMUTH), numpy.sin(_ELEVATION)]
)
_AXES = numpy.stack([_RIGHT, numpy.cross(_TOWARDS, _RIGHT), _TOWARDS])  # right, up, towards the viewer
_LIGHT = numpy.array([-0.5, 0.6, 0.62])  # in these axes
_SHADES = 14
_DARKEST = 0.5
_REACH = 1.1  # of the disc around a point, in mean distances of points
_NEIGHBOURS = 9  # of a point and those around it, through which its tangent plane goes


def surface_of(frames):
    """The frames of the membranes of a run in space, gas inside left out, as it is not seen. None where there is something else, or no place
    and stress that is a number."""
    seen = [number for number, body in enumerate(frames.bodies) if body["kind"] == "membrane" and not body["chain"]]
    gases = [number for number, body in enumerate(frames.bodies) if body["kind"] == "gas"]
    if frames.grid["dim"] != 3 or not seen or len(seen) + len(gases) < len(frames.bodies):
        return None
    kept = numpy.isin(frames.points["body"], seen)
    points = {name: values[kept] for name, values in frames.points.items()}
    points["body"] = numpy.searchsorted(seen, points["body"])
    if not (numpy.isfinite(points["stress"]) & numpy.isfinite(points["position"]).all(axis=1)).any():
        return None
    counts = numpy.concatenate([[0], numpy.cumsum(kept)])
    return dataclasses.replace(
        frames, bodies=[frames.bodies[number] for number in seen], points=points, starts=counts[frames.starts]
    )


def projected(places):
    """Places in space as (right, up, towards the viewer)."""
    return numpy.asarray(places, float) @ _AXES.T


def window(frames):
    """(low, high) of all frames as the viewer sees them."""
    places = projected(frames.points["position"])[:, :2]
    places = places[numpy.isfinite(places).all(axis=1)]
    low, high = places.min(axis=0), places.max(axis=0)
    margin = 0.06 * (high - low).max()
    return low - margin, high + margin


def colours(ramp):
    """Each colour of a ramp in all shades, as one list."""
    shaded = []
    for colour in ramp:
        channels = numpy.array(list(bytes.fromhex(colour[1:])), float)
        for share in numpy.linspace(_DARKEST, 1, _SHADES):
            shaded.append("#%02x%02x%02x" % tuple(round(value) for value in share * channels))
    return tuple(shaded)


def paint(canvas, places, steps, numbers):
    """Draws the surface through points; `steps`: a colour of the ramp for each, `numbers`: those of colours(ramp)."""
    good = numpy.isfinite(places).all(axis=1)
    seen, steps = projected(places)[good], numpy.asarray(steps, float)[good]
    if len(seen) < _NEIGHBOURS:
        return
    distance, nearest = scipy.spatial.cKDTree(seen).query(seen, _NEIGHBOURS)
    normal = _normals(seen[nearest])
    reach = _REACH * numpy.median(distance[:, 1:].mean(axis=1))
    pixel, point, depth, apart = _discs(canvas, seen, normal, reach)
    front = numpy.full(canvas.pixels.size, -numpy.inf)
    numpy.maximum.at(front, pixel, depth)
    shown = depth >= front[pixel] - reach
    pixel, point = pixel[shown], point[shown]
    weight = (1 - (apart[shown] / reach) ** 2) ** 2
    total = numpy.bincount(pixel, weight, canvas.pixels.size)

    def mean(values):
        return numpy.bincount(pixel, weight * values[point], canvas.pixels.size)[covered] / total[covered]

    covered = total > 0
    light = numpy.clip(normal @ (_LIGHT / numpy.linalg.norm(_LIGHT)), 0, 1)
    shade = numpy.rint(mean(light) * (_SHADES - 1)).astype(int)
    step = numpy.rint(mean(steps)).astype(int)
    canvas.pixels.reshape(-1)[covered] = numpy.asarray(numbers, numpy.uint8)[step * _SHADES + shade]


def _normals(clouds):
    """Of each cloud of places the direction that it extends least in, towards the viewer."""
    centred = clouds - clouds.mean(axis=1, keepdims=True)
    normal = numpy.linalg.eigh(numpy.einsum("nki,nkj->nij", centred, centred))[1][:, :, 0]
    return numpy.where(normal[:, 2:] < 0, -normal, normal)


def _discs(canvas, places, normal, reach):
    """(pixel, point, depth there, distance from the point) of each pixel that the disc of a point covers."""
    height, width = canvas.pixels.shape
    centre = (places[:, :2] - canvas.low) * canvas.scale
    far = int(numpy.ceil(reach * canvas.scale))
    offsets = numpy.stack(numpy.meshgrid(range(-far, far + 1), range(-far, far + 1)), axis=-1).reshape(-1, 2)
    at = numpy.rint(centre).astype(int)[:, None, :] + offsets
    off = (at - centre[:, None, :]) / canvas.scale
    slope = normal[:, None, :2] / numpy.maximum(normal[:, None, 2:], 0.05)
    rise = -(slope * off).sum(axis=2)
    apart = numpy.sqrt((off**2).sum(axis=2) + rise**2)
    inside = (apart < reach) & (at >= 0).all(axis=2) & (at < (width, height)).all(axis=2)
    point = numpy.nonzero(inside)[0]
    pixel = ((height - 1 - at[..., 1]) * width + at[..., 0])[inside]
    return pixel, point, (places[:, None, 2] + rise)[inside], apart[inside]
