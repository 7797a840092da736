"""Pictures: what is drawn of the frames of a run, and of normals."""

import dataclasses
import re

import h5py
import numpy
import pytest

import figures
import frame
import normals
import pictures
from plumbline import reader
import raster
import render
import surfaces
import synthetic_results
from html_page import Page, pixels_of, without_scripts


@pytest.fixture(scope="module")
def run(results):
    folder, names = results
    return reader.load(folder / names["frames"])


@pytest.fixture(scope="module")
def axisymmetric(tmp_path_factory):
    folder = tmp_path_factory.mktemp("axisymmetric")
    name = synthetic_results.spring_files_only(folder)
    synthetic_results.add_frames(folder / name, axisymmetric=True)
    return reader.load(folder / name)


def numbers(address, palette):
    """Colour numbers of a picture in a palette, 0 what is transparent; of equal colours the first."""
    pixels = pixels_of(address)
    seen = pixels[..., 3] == 255
    assert (pixels[~seen, 3] == 0).all(), "there or not"
    same = (pixels[..., None, :3] == numpy.array(palette)).all(axis=-1)
    assert same[seen].any(axis=-1).all(), "no other colours"
    return numpy.where(seen, 1 + same.argmax(axis=-1), 0)


# --- reading --------------------------------------------------------------------------------------


def test_reader_gives_back_what_was_written(run):
    frames = run.frames
    assert len(frames) == 9 and frames.every == 3 and frames.grid["dim"] == 2
    assert numpy.array_equal(frames.times, synthetic_results.FRAME_TIMES)
    for frame in (0, 3, 4, 8):
        for number, wanted in enumerate(synthetic_results.frame_bodies(frame)):
            found = frames.body(frame, number)
            assert all(numpy.allclose(found[name], wanted[name], equal_nan=True) for name in wanted)
    assert len(frames.body(3, 0)["id"]) == 400 and len(frames.body(4, 0)["id"]) == 600


def test_a_run_without_frames_has_none(results):
    folder, names = results
    assert reader.load(folder / names["run"]).frames is None


def test_frames_of_the_previous_format_are_read_alike(tmp_path, run):
    path = tmp_path / "old.h5"
    synthetic_results.create(path, "run", {"run": {}}, version=1).close()
    synthetic_results.add_frames(path)
    old = reader.load(path)
    assert old.format == 1 and run.format == 2 and old.frames.bodies == run.frames.bodies
    assert numpy.array_equal(old.frames.times, run.frames.times) and old.frames.grid == run.frames.grid
    for name, values in run.frames.points.items():
        numpy.testing.assert_array_equal(old.frames.points[name], values)


@pytest.fixture
def with_frames(tmp_path):
    name = synthetic_results.spring_files_only(tmp_path)
    synthetic_results.add_frames(tmp_path / name)
    return tmp_path / name


@pytest.mark.parametrize("part", ["description", "start", "time", "body", "stress"])
def test_frames_that_lack_a_part_are_damaged(with_frames, part):
    with h5py.File(with_frames, "a") as file:
        del file[f"frames/{part}"]
    with pytest.raises(reader.DamagedFile):
        reader.load(with_frames)


@pytest.mark.parametrize("part", ["start", "time", "body", "stress", "position"])
def test_frames_of_unequal_length_are_damaged(with_frames, part):
    with h5py.File(with_frames, "a") as file:
        shorter = file[f"frames/{part}"][:-1]
        del file[f"frames/{part}"]
        file[f"frames/{part}"] = shorter
    with pytest.raises(reader.DamagedFile, match="do not fit"):
        reader.load(with_frames)


# --- raster ---------------------------------------------------------------------------------------


def test_a_picture_says_what_the_pixels_were():
    pixels = numpy.arange(12, dtype=numpy.uint8).reshape(3, 4)
    palette = [(10 * k, 5, 255 - k) for k in range(1, 12)]
    assert numpy.array_equal(numbers(raster.picture(pixels, palette), palette), pixels)


def test_y_points_upwards_and_dots_lie_where_points_are():
    canvas = raster.Canvas((0, 0), (2, 1), 201)
    assert canvas.pixels.shape == (101, 201)
    canvas.dots(numpy.array([[0.5, 0.9], [numpy.nan, 0.5], [5, 5]]), 3, 0.03)
    rows, columns = numpy.nonzero(canvas.pixels)
    assert abs(rows.mean() - 10) < 0.5 and abs(columns.mean() - 50) < 0.5
    assert numpy.ptp(rows) == numpy.ptp(columns) == 6


def test_area_fills_gaps_of_a_body_and_no_others():
    canvas = raster.Canvas((0, 0), (1, 1), 101)
    canvas.dots(numpy.array([[0.5, 0.5]]), 9, 0.005)
    canvas.area(numpy.array([[0.1, 0.2], [0.13, 0.2], [0.5, 0.2]]), 4, 0.005)
    row = canvas.pixels[80]
    assert list(row[9:15]) == [0, 4, 4, 4, 4, 0] and row[50] == 4 and not row[20:49].any()
    assert canvas.pixels[50, 50] == 9


def test_lines_in_pieces_of_their_own_colour_and_none_to_places_that_are_no_numbers():
    canvas = raster.Canvas((0, 0), (1, 1), 101)
    canvas.line([(0, 0.5), (0.5, 0.5), (1, 0.5)], [3, 4], thickness=1)
    assert canvas.pixels[50, 20] == 3 and canvas.pixels[50, 80] == 4 and set(canvas.pixels[50]) == {3, 4}
    assert not canvas.pixels[:49].any() and not canvas.pixels[52:].any()
    for bad in (numpy.nan, numpy.inf):
        canvas = raster.Canvas((0, 0), (1, 1), 101)
        canvas.line([(0, 0.5), (0.25, 0.5), (0.5, bad), (0.75, 0.5), (1, 0.5)], 3, thickness=1)
        assert canvas.pixels[50, 10] == canvas.pixels[50, 90] == 3 and not canvas.pixels[:, 30:70].any()
    canvas = raster.Canvas((0, 0), (1, 1), 101)
    canvas.line([(0, 0.5), (1, 0.5)], 3, thickness=1, dash=5)
    assert set(canvas.pixels[50]) == {0, 3}


def test_ramp_keeps_its_ends():
    assert raster.ramp(("#000000", "#ffffff"), 3) == ("#000000", "#808080", "#ffffff")


# --- what is chosen -------------------------------------------------------------------------------


@pytest.mark.parametrize("count, wanted, chosen", [(2, 6, [0, 1]), (6, 6, [0, 1, 2, 3, 4, 5]), (25, 6, [0, 5, 10, 14, 19, 24]), (9, 3, [0, 4, 8])])
def test_frames_of_the_strip(count, wanted, chosen):
    assert pictures.chosen_frames(count, wanted) == chosen


@pytest.mark.parametrize("low, high", [(0, 110), (-3e-7, 8e-7), (99.99, 100.02), (7, 7), (0, 0)])
def test_steps_of_colour_are_centred_on_round_numbers(low, high):
    levels = pictures.colour_levels(numpy.linspace(low, high, 1001))
    size = levels[1] - levels[0]
    assert len(levels) <= 15 and numpy.allclose(numpy.diff(levels), size, rtol=1e-6)
    centres = (levels[1:] + levels[:-1]) / 2 / size
    assert numpy.allclose(centres, numpy.rint(centres), atol=1e-4)
    assert levels[0] <= low + 0.011 * (high - low) and levels[-1] >= high - 0.011 * (high - low)


def test_window_holds_all_points_and_the_walls_near_them(run):
    view = pictures.View(run.frames)
    places = run.frames.points["position"][:, :2]
    assert (places >= view.low).all() and (places <= view.high).all()
    assert len(view.walls()) == 3, "left, right and below; nothing stands above"
    assert view.axis() is None


def test_axisymmetric_scenes_are_mirrored(axisymmetric):
    view = pictures.View(axisymmetric.frames)
    assert view.low[0] == -view.high[0]
    places = view.body(0, 1)["position"]
    assert len(places) == 120 and numpy.array_equal(places[:60] * (-1, 1), places[60:])
    assert [len(part) for part in view.lines(1, places)] == [61, 61], "closed on either side"
    assert view.axis()[:, 0].tolist() == [0, 0]
    assert sorted(ends[0, 0] for ends in view.walls() if ends[0, 0] == ends[1, 0]) == [-1, 1], "the axis is no wall"
    drawn = pictures.strip(view, "run", "file")
    _, palette = raster.colour_numbers(tuple(view.colours))
    pixels = numbers(drawn.cells[-1]["picture"], palette)
    other = numpy.count_nonzero(pixels[:, : pixels.shape[1] // 2] > 2) / numpy.count_nonzero(pixels > 2)
    assert other == pytest.approx(0.5, abs=0.03)
    assert "Both sides of the axis" in drawn.caption


# --- what is drawn --------------------------------------------------------------------------------


def test_strip_shows_six_instants_with_their_times(run):
    view = pictures.View(run.frames)
    drawn = pictures.strip(view, "run", "file")
    _, palette = raster.colour_numbers(tuple(view.colours))
    assert [cell["time"] for cell in drawn.cells][:1] + [drawn.cells[-1]["time"]] == ["t = 0 s", "t = 0.143 s"]
    assert len(drawn.cells) == 6
    assert [key.label for key in drawn.keys] == ["air", "bag", "probe"]
    assert "One point in 3" in drawn.caption and "walls" in drawn.caption
    for cell in drawn.cells:
        pixels = numbers(cell["picture"], palette)
        assert set(numpy.unique(pixels)) == {0, raster.WALL, 3, 4, 5}, "nothing, walls, and each body"
        assert pixels.shape[1] / pixels.shape[0] == pytest.approx(drawn.shape, rel=0.02)


def test_film_has_all_frames_side_by_side(run):
    view = pictures.View(run.frames)
    drawn = pictures.film(view, "run", "file", "p")
    assert len(drawn.times) == 9 and "pressure of the gas" in drawn.caption.lower()
    shown = pixels_of(drawn.picture)
    assert shown.shape[1] % 9 == 0
    frames = numpy.split(shown, 9, axis=1)
    assert all(not numpy.array_equal(one, other) for one, other in zip(frames, frames[1:]))
    assert [key.label for key in drawn.keys] == ["bag", "probe"], "what is coloured has the scale of colours instead"
    # The pressure falls from 2 at the start, in the middle of the bag, to 1.2 at the end, down a scale that grows lighter.
    middle = [frame[frame.shape[0] * 6 // 10, frame.shape[1] // 2].astype(int) @ (299, 587, 114, 0) for frame in frames]
    assert middle[0] > middle[-1] > 0 and numpy.all(numpy.diff(middle) <= 0)


def test_film_is_no_wider_than_a_picture_may_be(run):
    frames, often = run.frames, 10
    starts = numpy.concatenate([[0], numpy.cumsum(numpy.tile(numpy.diff(frames.starts), often))])
    points = {name: numpy.concatenate([values] * often) for name, values in frames.points.items()}
    longer = dataclasses.replace(frames, times=numpy.linspace(0, 1, len(starts) - 1), points=points, starts=starts)
    drawn = pictures.film(pictures.View(longer), "run", "file", "p", most_characters=10**7)
    assert 8 < len(drawn.times) < 90 and drawn.times[-1] == "t = 1 s"
    assert pixels_of(drawn.picture).shape[1] <= raster.WIDEST


def test_film_keeps_within_its_bytes(run):
    view = pictures.View(run.frames)
    drawn = pictures.film(view, "run", "file", "p", most_characters=12000)
    assert len(drawn.picture) <= 12000
    assert len(drawn.times) >= 5


def test_fields_of_each_kind_of_body(run):
    view = pictures.View(run.frames)
    drawn = {kind: pictures.field_at_one_time(view, kind, "run", "file", kind) for kind in ("gas", "membrane", "solid")}
    assert drawn["gas"].title == "Pressure of the gas at the end of the run" and "t = 0.143 s" in drawn["gas"].caption
    assert "from 9 to 11 Pa" in drawn["membrane"].caption
    assert "when it is largest, t = 0 s" in drawn["solid"].caption
    assert drawn["gas"].svg.count("<image") == 1 and drawn["membrane"].svg.count("<image") == 0
    assert all("Pa" in figure.svg for figure in drawn.values())
    assert drawn["gas"].keys[0].label == "bag"


def test_values_between_points_and_none_outside():
    class Square:
        low, high = numpy.zeros(2), numpy.ones(2)

    side = (numpy.arange(20) + 0.5) / 40  # the lower left quarter
    places = numpy.stack(numpy.meshgrid(side, side), -1).reshape(-1, 2)
    grid, extent = pictures.on_pixels(places, 3 * places[:, 0], numpy.full(len(places), 1 / 40), Square)
    assert extent == pytest.approx((0, 1, 0, 1))
    height, width = grid.shape
    inner = grid[20 : height // 2 - 20, 20 : width // 2 - 20]
    x = (numpy.arange(width) + 0.5) / width
    assert numpy.allclose(inner, 3 * x[20 : width // 2 - 20], atol=1e-6)
    assert numpy.isnan(grid[height // 2 + 15 :]).all() and numpy.isnan(grid[:, width // 2 + 15 :]).all()


# --- the page -------------------------------------------------------------------------------------


def test_page_shows_them(page):
    source = page.read_text(encoding="utf-8")
    parsed = Page(source)
    assert "Fields and points over time" in parsed.text and "Points over time" in parsed.text
    assert len(re.findall(r'<ol class="strip-of-points"', source)) == 1
    reel = re.search(r'<div class="reel" role="img" aria-label="([^"]+)"', source)
    assert "pressure of the gas" in reel.group(1)
    assert "prefers-reduced-motion: no-preference" in source and 'class="pause"' in source
    assert "<script" not in without_scripts(source)


# --- normals --------------------------------------------------------------------------------------


def test_normals_of_each_method():
    profile = reader.Columns(synthetic_results.normals_profile())
    assert sorted(normals.methods(profile)) == ["good", "wrong"]
    drawn = normals.needles(profile, "line", "file", "p")
    assert "good" in drawn.svg and "&lt; 10⁻⁶°" in drawn.svg
    assert "23°" in drawn.svg and "80°" not in drawn.svg, "points that are not judged do not count"
    assert isinstance(drawn, figures.Figure)


def test_profiles_without_normals_have_none():
    profile = synthetic_results.normals_profile()
    del profile["normal_x"]
    assert normals.methods(reader.Columns(profile)) == []
    assert normals.methods(reader.Columns(synthetic_results.spring_profile())) == []


def test_needles_stand_on_their_points():
    places, directions = numpy.array([[1.0, 2.0], [0.0, 0.0]]), numpy.array([[0.0, 1.0], [1.0, 0.0]])
    x, y = normals._needles(places, directions, 0.5)
    assert numpy.array_equal(x, [1, 1, numpy.nan, 2, 2.5, numpy.nan], equal_nan=True)
    assert numpy.array_equal(y, [0, 0.5, numpy.nan, 0, 0, numpy.nan], equal_nan=True)


# --- membranes in space ---------------------------------------------------------------------------


def sphere(count=1500, radius=1.0):
    """Evenly spread points on a sphere."""
    place = numpy.arange(count) + 0.5
    z, angle = 1 - 2 * place / count, 2.39996 * place
    across = numpy.sqrt(1 - z**2)
    return radius * numpy.stack([across * numpy.cos(angle), across * numpy.sin(angle), z], axis=1)


def painted(places, steps, ramp=("#ff0000", "#00ff00", "#0000ff"), half=1.5):
    """Numbers of the colours of the ramp that the pixels show, 0 for none, and their shades."""
    canvas = raster.Canvas((-half, -half), (half, half), 301)
    (numbers,), _ = raster.colour_numbers(surfaces.colours(ramp))
    surfaces.paint(canvas, places, steps, numbers)
    number = canvas.pixels.astype(int) - numbers[0]
    shades = len(numbers) // len(ramp)
    return numpy.where(number < 0, 0, 1 + number // shades), numpy.where(number < 0, -1, number % shades)


def test_a_sphere_is_seen_as_a_disc_that_is_lit_from_the_upper_left():
    colour, shade = painted(sphere(), numpy.ones(1500))
    assert set(numpy.unique(colour)) == {0, 2}
    # pixels are 0.01 wide; discs reach 1.1 spacings, 0.1, beyond the last point, less what they bend away from the viewer
    assert abs((colour > 0).sum() * 1e-4 / numpy.pi - 1) < 0.1
    rows, columns = numpy.nonzero(colour)
    assert abs(rows.mean() - 150) < 1 and abs(columns.mean() - 150) < 1
    left_above, right_below = shade[90:130, 90:130].mean(), shade[190:210, 190:210].mean()
    assert left_above > right_below + 3


def test_what_is_nearer_to_the_viewer_hides_what_is_behind():
    towards = numpy.linalg.inv(surfaces.projected(numpy.eye(3)))[2]  # of the viewer, in space
    sheet = sphere()
    both = numpy.concatenate([sheet, 0.5 * sheet + 2 * towards])
    steps = numpy.repeat([0, 2], 1500)
    for order in (slice(None), slice(None, None, -1)):
        colour, _ = painted(both[order], steps[order])
        assert (colour[110:190, 140:160] == 3).all() and colour[150, 80] == 1
    behind, _ = painted(numpy.concatenate([sheet, 0.5 * sheet - 2 * towards]), steps)
    assert set(numpy.unique(behind)) == {0, 1}


def test_values_stand_where_their_points_are():
    places = sphere()
    colour, _ = painted(places, numpy.where(places[:, 2] > 0, 2, 0))
    assert colour[70, 150] == 3 and colour[230, 150] == 1


def test_places_that_are_no_numbers_are_left_out():
    places = sphere()
    places[::7] = numpy.nan
    colour, _ = painted(places, numpy.ones(1500))
    assert abs((colour > 0).sum() * 1e-4 / numpy.pi - 1) < 0.1
    assert not painted(places[:1], [0])[0].any()


@pytest.fixture
def in_space(run):
    """Frames of a sphere that grows, its stress by its height."""
    places = [sphere(400, radius) for radius in (1.0, 1.1, 1.2)]
    count = 400 * len(places)
    points = {
        "position": numpy.concatenate(places),
        "velocity": numpy.zeros((count, 3)),
        "pressure": numpy.full(count, numpy.nan),
        "stress": numpy.concatenate(places)[:, 2] + 5,
        "id": numpy.tile(numpy.arange(400), len(places)),
        "body": numpy.zeros(count, int),
    }
    body = {"name": "sphere", "kind": "membrane", "material": "surface_membrane", "chain": False, "closed": False}
    return dataclasses.replace(
        run.frames,
        times=numpy.array([0.0, 1.0, 2.0]),
        bodies=[body],
        grid={**run.frames.grid, "dim": 3},
        points=points,
        starts=400 * numpy.arange(len(places) + 1),
    )


def test_surfaces_are_drawn_with_one_scale_of_stress(in_space):
    assert surfaces.surface_of(in_space).points["stress"].size == 1200
    drawn = pictures.surface_strip(in_space, "run", "file", "p")
    assert [cell["time"] for cell in drawn.cells] == ["t = 0 s", "t = 1 s", "t = 2 s"]
    sizes = [(pixels_of(cell["picture"])[..., 3] == 255).sum() for cell in drawn.cells]
    assert sizes == sorted(sizes) and abs(sizes[2] / sizes[0] - 1.44) < 0.05
    assert "from 3.8 to 6.2 Pa" in drawn.caption and "principal stress" in drawn.svg


def test_the_scale_of_a_strip_is_drawn_on_the_page_not_written(in_space, monkeypatch):
    drawn = pictures.surface_strip(in_space, "run", "file", "p")
    monkeypatch.setattr(pictures, "groups", lambda *_: [{"strip": drawn, "film": None, "fields": []}])
    (group,) = render.picture_groups(None, {}, "name", 0)
    page = frame.environment().from_string('{% from "macros.html" import strip %}{{ strip(drawn) }}').render(drawn=group["strip"])
    assert "<svg" in page and "&lt;svg" not in page


def test_gas_inside_a_surface_is_not_drawn(in_space):
    """Every other point is the gas's, which has no stress and comes first: what is left is the membrane, frame by frame."""
    points = {**in_space.points, "body": numpy.tile([0, 1], 600)}
    points["stress"] = numpy.where(points["body"] == 0, numpy.nan, points["stress"])
    gas = {**in_space.bodies[0], "name": "gas", "kind": "gas"}
    surface = surfaces.surface_of(dataclasses.replace(in_space, bodies=[gas, *in_space.bodies], points=points))
    assert [body["name"] for body in surface.bodies] == ["sphere"] and list(surface.starts) == [0, 200, 400, 600]
    for frame in range(3):
        assert numpy.array_equal(surface.body(frame, 0)["position"], in_space.body(frame, 0)["position"][1::2])
    assert len(pictures.surface_strip(surface, "run", "file", "p").cells) == 3


def test_no_surface_is_what_holds_something_else(in_space, run):
    assert surfaces.surface_of(run.frames) is None
    solid = {**in_space.bodies[0], "kind": "solid"}
    assert surfaces.surface_of(dataclasses.replace(in_space, bodies=[*in_space.bodies, solid])) is None
    for name in ("stress", "position"):
        lost = {**in_space.points, name: numpy.full_like(in_space.points[name], numpy.nan)}
        assert surfaces.surface_of(dataclasses.replace(in_space, points=lost)) is None
