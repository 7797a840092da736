"""Frames: `run --frames K` and what the result file then holds, in the layout that ParaView reads."""
import json

import h5py
import numpy
import pytest
from contract import without_volatile
from test_errors import refused

RUN = ("run", "two-disks", "--cells", 10)


def file_of(plumbline):
    (name,) = plumbline.files()
    return h5py.File(plumbline.folder / "results" / name, "r")


@pytest.mark.parametrize("count", ["0", "1", "-3", "1001"])
def test_numbers_out_of_range(plumbline, count):
    error = refused(plumbline, *RUN, "--frames", count, says=["--frames", count, "[2, 1000]"])
    assert error["key"] == "--frames" and error["value"] == count


@pytest.mark.parametrize("count", ["many", "2.5", ""])
def test_what_is_no_number(plumbline, count):
    result = plumbline(*RUN, "--frames", count)
    assert result.code == 2 and "frames" in result.err
    assert plumbline.files(".") == []


def test_no_other_number_changes(plumbline):
    plain = plumbline(*RUN, "--results", "plain", json=True).json()
    seen = plumbline(*RUN, "--results", "seen", "--frames", 5, json=True).json()
    assert without_volatile(plain) == without_volatile(seen)
    assert plumbline.files("plain") == plumbline.files("seen")
    with h5py.File(plumbline.folder / "plain" / plain["file"]) as a, h5py.File(plumbline.folder / "seen" / plain["file"]) as b:
        assert set(b) - set(a) == {"VTKHDF", "frames"}
        for table in ("ledger", "profile"):
            a[table].visititems(lambda name, data: isinstance(data, h5py.Group) or numpy.testing.assert_array_equal(data, b[table][name]))


def test_layout_is_that_of_vtkhdf(plumbline):
    assert plumbline(*RUN, "--frames", 5).code == 0
    with file_of(plumbline) as file:
        grid = file["VTKHDF"]
        assert list(grid.attrs["Version"]) == [2, 0]
        kind = grid.attrs.get_id("Type")
        assert grid.attrs["Type"] == b"UnstructuredGrid"
        assert kind.get_type().get_cset() == h5py.h5t.CSET_ASCII and kind.get_type().get_strpad() == h5py.h5t.STR_NULLPAD
        steps = grid["Steps"]
        assert steps.attrs["NSteps"] == 5
        times = steps["Values"][()]
        assert times[0] == 0 and times[-1] == pytest.approx(json.loads(file["run"][()])["time"]) and numpy.all(numpy.diff(times) > 0)
        points = grid["Points"]
        assert points.shape[1] == 3 and points.dtype == numpy.float32 and points.compression == "gzip"
        for k in range(5):
            part, cell, start = steps["PartOffsets"][k], steps["CellOffsets"][k, 0], steps["ConnectivityIdOffsets"][k, 0]
            number, cells = grid["NumberOfPoints"][part], grid["NumberOfCells"][part]
            offsets = grid["Offsets"][cell + part:cell + part + cells + 1]
            assert offsets[0] == 0 and offsets[-1] == grid["NumberOfConnectivityIds"][part]
            connectivity = grid["Connectivity"][start:start + offsets[-1]]
            assert sorted(connectivity) == list(range(number))
            assert set(grid["Types"][cell:cell + cells]) == {1}
            assert steps["PointOffsets"][k] == k * number
        assert len(points) == 5 * number
        for name, data in grid["PointData"].items():
            assert len(data) == len(points), name
            assert list(steps["PointDataOffsets"][name]) == list(steps["PointOffsets"])
        described = json.loads(file["frames"][()])
        assert [body["name"] for body in described["bodies"]] == ["lower", "upper"]
        assert described["dim"] == 2 and set(grid["PointData/body"][()]) == {0, 1}


def test_points_that_come_later_make_a_new_part(plumbline):
    """Gas that expands is split: frames with more points have cells of their own."""
    assert plumbline("run", "gas-expansion", "--cells", 80, "--frames", 9).code == 0
    with file_of(plumbline) as file:
        grid, steps = file["VTKHDF"], file["VTKHDF/Steps"]
        assert len(grid["NumberOfPoints"]) > 1
        counts = grid["NumberOfPoints"][()][steps["PartOffsets"][()]]
        assert numpy.all(numpy.diff(counts) >= 0) and counts.sum() == len(grid["Points"])
        assert list(steps["PointOffsets"]) == list(numpy.cumsum(counts) - counts)
        for k, (part, cell, start) in enumerate(zip(steps["PartOffsets"], steps["CellOffsets"][:, 0], steps["ConnectivityIdOffsets"][:, 0])):
            offsets = grid["Offsets"][cell + part:cell + part + counts[k] + 1]
            assert list(offsets) == list(range(counts[k] + 1))
            assert list(grid["Connectivity"][start:start + counts[k]]) == list(range(counts[k]))


def test_a_chain_is_one_line(plumbline):
    assert plumbline("run", "pendulum", "--cells", 5, "--set", "t_end=0.01", "--frames", 2).code in (0, 1)
    with file_of(plumbline) as file:
        grid = file["VTKHDF"]
        assert list(grid["Types"]) == [4] and list(grid["Offsets"]) == [0, grid["NumberOfPoints"][0]]
        assert list(grid["Connectivity"]) == list(range(grid["NumberOfPoints"][0]))


def test_verify_keeps_the_frames_that_a_study_asks_for(plumbline):
    assert plumbline("verify", "two-disks", "--tier", "quick").code == 0
    with_frames = []
    for name in plumbline.files():
        with h5py.File(plumbline.folder / "results" / name) as file:
            with_frames += [name] * ("VTKHDF" in file)
    assert len(with_frames) == 1 and with_frames[0].startswith("two-disks-default-40-")
