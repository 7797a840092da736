"""SIGINT and SIGTERM end a run or a study whole: 130 or 143, every file complete or absent."""
import os
import signal
import subprocess
import time

import h5py
import pytest

# Far longer than the test waits: the signal always meets a running step.
LONG = {
    "run": ["run", "sod", "--cells", 3200, "--set", "cfl=0.0001"],
    "converge": ["converge", "sod", "--cells", "20,3200", "--set", "cfl=0.001"],
    "stability": ["stability", "bar-edge", "--maps", "--tier", "full", "--threads", 2],
    "verify": ["verify", "stability-coupled", "--tier", "full"],  # limits, found in many small steps
    "bench": ["bench", "--points", 1e6],
}


@pytest.mark.parametrize("number, status", [(signal.SIGINT, 130), (signal.SIGTERM, 143)])
@pytest.mark.parametrize("name", LONG)
def test_signal_leaves_nothing_half_written(plumbline, name, number, status):
    process = subprocess.Popen([*plumbline.command(*LONG[name]), "--json", "out.json"], cwd=plumbline.folder, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    try:
        time.sleep(1.0)
        assert process.poll() is None, "still running when the signal comes"
        process.send_signal(number)
        sent = time.monotonic()
        process.communicate(timeout=20)
    finally:
        process.kill()
    assert time.monotonic() - sent < 5, "between two steps, not at the end of the study"
    # A shell reports both a status of 130 and a death by signal 2 as 130.
    assert process.returncode in (status, -number)
    assert not os.path.exists(plumbline.folder / "out.json")
    for file in plumbline.files(".") :
        assert file.startswith("results/") and file.endswith(".h5"), f"{file} is no result"
        with h5py.File(plumbline.folder / file) as stored:
            assert stored.attrs["plumbline_format"] == 2
