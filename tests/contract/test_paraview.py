"""Frames as ParaView reads them: the files of `run --frames K`, read back by VTK itself, hold what the result file holds."""
import importlib.util
import subprocess
import sys
from pathlib import Path

import numpy
import pytest
from contract import ROOT
from test_frames import FIELDS, RUN, file_of, list_of

sys.path.insert(0, str(ROOT / "reports"))
from plumbline import reader  # noqa: E402

if importlib.util.find_spec("vtkmodules") is None:
    pytest.skip("no VTK is installed (ci/setup --with vtk): no frame was read back", allow_module_level=True)


def read_by_vtk(folder, names):
    """The arrays of each file as VTK's reader gives them. It may hang, and then ignores a kind signal."""
    target = folder / "read.npz"
    command = ["timeout", "-k", "5", "60", sys.executable, "-B", str(Path(__file__).with_name("read_vtkhdf.py")), str(target)]
    process = subprocess.run([*command, *(str(folder / name) for name in names)], capture_output=True, text=True, timeout=90)
    assert process.returncode == 0 and "ERR" not in process.stderr, process.stderr
    with numpy.load(target) as found:
        return [{name.split(".", 1)[1]: found[name] for name in found if name.startswith(f"{k}.")} for k in range(len(names))]


def cells_of(bodies, numbers):
    """Types, offsets and connectivity that a frame must have."""
    types, offsets, connectivity = [], [0], []
    for number, body in enumerate(bodies):
        points = list(numpy.flatnonzero(numbers == number))
        for cell in [points + points[:1] * body["closed"]] if body["chain"] else [[p] for p in points]:
            types.append(4 if body["chain"] else 1)
            connectivity += cell
            offsets.append(len(connectivity))
    return types, offsets, connectivity


# Points without order, gas whose points split on the way, an open chain, a closed chain with gas in it.
@pytest.mark.parametrize("count, run", [
    (5, RUN),
    (9, ("run", "gas-expansion", "--cells", 80)),
    (3, ("run", "pendulum", "--cells", 5, "--set", "t_end=0.01")),
    (2, ("run", "ring-breathing", "--cells", 8, "--set", "periods=2")),
], ids=lambda value: value[1] if isinstance(value, tuple) else None)
def test_vtk_reads_what_the_result_file_says(plumbline, count, run):
    done = plumbline(*run, "--frames", count)
    assert done.code in (0, 1), done.err
    frames = reader.load(file_of(plumbline)).frames
    folder, listed = list_of(plumbline)
    assert len(listed) == len(frames) == count
    assert [time for _, time in listed] == list(frames.times)
    for k, found in enumerate(read_by_vtk(folder, [name for name, _ in listed])):
        part = slice(frames.starts[k], frames.starts[k + 1])
        assert str(found["class"]) == "vtkUnstructuredGrid"
        numpy.testing.assert_array_equal(found["points"], frames.points["position"][part])
        for name in (*FIELDS, "body"):
            numpy.testing.assert_array_equal(found[name], frames.points[name][part], err_msg=f"{name} of frame {k}")
        types, offsets, connectivity = cells_of(frames.bodies, frames.points["body"][part])
        assert list(found["types"]) == types and list(found["offsets"]) == offsets and list(found["connectivity"]) == connectivity
    if "gas-expansion" in run:
        assert len(set(numpy.diff(frames.starts))) > 1, "points split, so that frames differ in size"
