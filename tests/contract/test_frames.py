"""Frames: `run --frames K`, what the result file then holds, and the files beside it."""
import json
from pathlib import Path

import h5py
import numpy
import pytest
from contract import without_volatile
from test_errors import refused

RUN = ("run", "two-disks", "--cells", 10)
FIELDS = ("velocity", "pressure", "stress", "id")


def file_of(plumbline):
    (path,) = (plumbline.folder / "results").glob("*.h5")
    return path


def list_of(plumbline):
    """(folder, [(file, time)]) as the list that ParaView opens has it."""
    (path,) = (plumbline.folder / "results").rglob("*.hdf.series")
    document = json.loads(path.read_text(encoding="utf-8"))
    assert document["file-series-version"] == "1.0" and path.parent.name == file_of(plumbline).stem + "-frames"
    return path.parent, [(entry["name"], entry["time"]) for entry in document["files"]]


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
    name = Path(plain["file"]).stem
    assert seen.pop("frames") == {"count": 5, "series": f"{name}-frames/{name}.hdf.series"}
    assert without_volatile(plain) == without_volatile(seen)
    frames = [f"{name}-frames/{name}-000{k}.hdf" for k in range(5)] + [f"{name}-frames/{name}.hdf.series"]
    assert plumbline.files("seen") == sorted([plain["file"], *frames]) and plumbline.files("plain") == [plain["file"]]
    with h5py.File(plumbline.folder / "plain" / plain["file"]) as a, h5py.File(plumbline.folder / "seen" / plain["file"]) as b:
        assert set(b) - set(a) == {"frames"}
        for table in ("ledger", "profile"):
            a[table].visititems(lambda name, data: isinstance(data, h5py.Group) or numpy.testing.assert_array_equal(data, b[table][name]))


def test_the_result_file_is_no_picture_that_readers_take_for_one_step(plumbline):
    assert plumbline(*RUN, "--frames", 5).code == 0
    with h5py.File(file_of(plumbline)) as file:
        assert "VTKHDF" not in file
        group = file["frames"]
        described = json.loads(group["description"][()])
        assert [body["name"] for body in described["bodies"]] == ["lower", "upper"]
        assert described["dim"] == 2 and set(group["body"][()]) == {0, 1}
        assert group["position"].shape[1] == 3 and group["position"].dtype == numpy.float32 and group["position"].compression == "gzip"
        times, start = group["time"][()], group["start"][()]
        assert len(times) == 5 and times[0] == 0 and numpy.all(numpy.diff(times) > 0)
        assert times[-1] == pytest.approx(json.loads(file["run"][()])["time"])
        assert start[0] == 0 and len(start) == 6 and all(len(group[name]) == start[-1] for name in (*FIELDS, "position", "body"))


def test_each_frame_is_a_file_of_version_1_0(plumbline):
    """Attributes as VTK 9.1 wants them: a string of fixed length, ASCII."""
    assert plumbline(*RUN, "--frames", 3).code == 0
    folder, listed = list_of(plumbline)
    for name, _ in listed:
        with h5py.File(folder / name) as file:
            grid = file["VTKHDF"]
            kind = grid.attrs.get_id("Type").get_type()
            assert list(grid.attrs["Version"]) == [1, 0] and grid.attrs["Type"] == b"UnstructuredGrid"
            assert kind.get_cset() == h5py.h5t.CSET_ASCII and not kind.is_variable_str()
            assert "Steps" not in grid


def test_a_shorter_list_leaves_no_frames_of_the_longer_one(plumbline):
    assert plumbline(*RUN, "--frames", 6).code == 0
    assert plumbline(*RUN, "--frames", 3).code == 0
    folder, listed = list_of(plumbline)
    assert len(listed) == 3 and sorted(path.name for path in folder.glob("*.hdf")) == sorted(name for name, _ in listed)


def test_a_list_is_whole_or_absent(plumbline):
    """A frame that cannot be written: exit status 4, the reason, and no list of frames that are not there."""
    assert plumbline(*RUN, "--frames", 3).code == 0
    folder, listed = list_of(plumbline)
    (folder / listed[2][0]).unlink()
    (folder / listed[2][0]).mkdir()
    result = plumbline(*RUN, "--frames", 3)
    assert result.code == 4 and listed[2][0] in result.err
    assert not list(folder.glob("*.series")) and not list(folder.glob("*.part"))


def test_verify_keeps_the_frames_that_a_study_asks_for(plumbline):
    assert plumbline("verify", "two-disks", "--tier", "quick").code == 0
    with_frames = []
    for name in plumbline.files():
        with h5py.File(plumbline.folder / "results" / name) as file:
            with_frames += [name] * ("frames" in file)
            assert "VTKHDF" not in file
    assert len(with_frames) == 1 and with_frames[0].startswith("two-disks-default-40-")
