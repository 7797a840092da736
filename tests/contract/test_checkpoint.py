"""A run that is killed goes on from its checkpoint to the same bits; what is no checkpoint of it is refused by name."""
import json
import signal
import socket
import subprocess
import time

import h5py
import pytest
from contract import contents, edited, without_volatile

# One run of every kind, with steps enough to be killed on the way.
KINDS = {
    "gas": ("sod", "--cells", 100),
    "split points": ("gas-expansion", "--cells", 40, "--set", "split=0.2", "--set", "cfl=0.03"),
    "pistons": ("piston-shock", "--cells", 100),
    "space": ("sod-3d", "--cells", 20),
    "axisymmetric": ("affine-expansion", "--cells", 20, "--set", "body=sphere", "--set", "geometry=axisymmetric"),
    "solid": ("bar-vibration", "--cells", 8),
    "implicit": ("bar-vibration", "--cells", 8, "--integrator", "implicit-midpoint", "--set", "transfer=flip"),
    "memory": ("bar-vibration", "--cells", 8, "--integrator", "generalized-alpha", "--set", "transfer=flip"),
    "last step": ("bar-vibration", "--cells", 8, "--integrator", "central-difference", "--set", "transfer=flip"),
    "contact": ("two-bar", "--cells", 20, "--set", "t_end=0.5"),
    "contact, york1997": ("two-disks", "--scheme", "york1997", "--cells", 10, "--set", "t_end=0.5"),
    "membrane": ("string-vibration", "--cells", 10),
    "slack membrane": ("string-slack", "--cells", 10),
    "gas and membrane": ("ring-breathing", "--cells", 8),
    "load": ("mms-ring", "--cells", 8),
    "normals": ("normals-cylinder", "--set", "membrane.strain=accumulated", "--set", "normals=modern", "--set", "t_end=2e-3"),
    "bag, contact, axisymmetric": ("airbag-200", "--cells", 12, "--set", "t_end=2e-3"),
    "stopped": ("sod", "--cells", 40, "--set", "cfl=5"),
}


def start(plumbline, *arguments):
    return subprocess.Popen(plumbline.command("run", *arguments), cwd=plumbline.folder, stdin=subprocess.DEVNULL,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8")


def about(path):
    with h5py.File(path) as file:
        return json.loads(file["checkpoint"][()])


def kill_at(process, path, step):
    """kill -9 as soon as the checkpoint has reached this step; False if the process was at its end before."""
    deadline = time.monotonic() + 120
    while process.poll() is None:
        assert time.monotonic() < deadline, "no checkpoint came"
        if path.exists() and about(path)["step"] >= step:
            break
    process.send_signal(signal.SIGKILL)
    process.communicate()
    return process.returncode == -signal.SIGKILL


def result_files(folder):
    return {path.name: contents(path) for path in folder.glob("*.h5")}


@pytest.mark.parametrize("kind", KINDS)
def test_a_killed_run_goes_on_to_the_same_bits(plumbline, kind):
    arguments, checkpoint = KINDS[kind], plumbline.folder / "run.checkpoint"
    whole = plumbline("run", *arguments, "--results", "whole", json=True)
    # Normals: ends before one of its measures is defined.
    assert whole.code == {"stopped": 3, "normals": 1}.get(kind, 0), whole.text
    steps = whole.json()["steps"]
    every = max(1, steps // 100)  # writing checkpoints takes longer than the steps of small scenes
    killed = kill_at(start(plumbline, *arguments, "--results", "resumed", "--checkpoint", checkpoint, "--every", every),
                     checkpoint, steps // 3)
    # What goes on is killed once more, and writes its checkpoints as the first one did.
    killed_again = kill_at(start(plumbline, "--resume", checkpoint, "--results", "resumed"), checkpoint, 2 * steps // 3)
    if steps > 50:
        assert killed and killed_again, f"{steps} steps are too few to be killed on the way"
    resumed = plumbline("run", "--resume", checkpoint, "--results", "resumed", "--threads", 2, json=True)
    assert resumed.code == whole.code, resumed.text
    assert without_volatile(resumed.json()) == without_volatile(whole.json())
    assert result_files(plumbline.folder / "resumed") == result_files(plumbline.folder / "whole")
    assert about(checkpoint)["every"] == every
    assert not list(plumbline.folder.glob("*.part")), "what the dead processes left is cleared away"


def test_frames_of_a_killed_run(plumbline):
    arguments, checkpoint = ("two-disks", "--cells", 10, "--frames", 20), plumbline.folder / "run.checkpoint"
    whole = plumbline("run", *arguments, "--results", "whole", json=True)
    assert kill_at(start(plumbline, *arguments, "--results", "resumed", "--checkpoint", checkpoint, "--every", 1), checkpoint,
                   whole.json()["steps"] // 2)
    resumed = plumbline("run", "--resume", checkpoint, "--results", "resumed", json=True)
    assert without_volatile(resumed.json()) == without_volatile(whole.json())
    assert result_files(plumbline.folder / "resumed") == result_files(plumbline.folder / "whole")
    films = {name: (plumbline.folder / "whole" / name).read_bytes() for name in plumbline.files("whole") if "frames" in name}
    assert len(films) == 21
    assert films == {name: (plumbline.folder / "resumed" / name).read_bytes() for name in films}


# --- what is asked for --------------------------------------------------------------------------------------------------


@pytest.fixture
def checkpoint(plumbline):
    """A checkpoint of a run of sod, at step 10 of it."""
    path = plumbline.folder / "sod.checkpoint"
    assert plumbline("run", "sod", "--cells", 20, "--checkpoint", path, "--every", 10).code == 0
    assert about(path)["step"] >= 10 and about(path)["step"] % 10 == 0
    return path


def test_without_every_the_start_is_kept(plumbline):
    path = plumbline.folder / "sod.checkpoint"
    assert plumbline("run", "sod", "--cells", 20, "--checkpoint", path).code == 0
    assert about(path)["step"] == 0 and about(path)["every"] == 0
    assert plumbline("run", "--resume", path).code == 0


def test_the_same_choices_may_be_given_again(plumbline, checkpoint):
    for again in (["sod"], ["--cells", 20], ["--scheme", "default"], ["--set", "gamma=1.4"], ["sod", "--set", "cells=20"]):
        assert plumbline("run", *again, "--resume", checkpoint).code == 0, again


@pytest.mark.parametrize("other, key, kept", [
    (["lax"], "case", "sod"), (["--cells", 40], "--cells", "20"), (["--scheme", "york1997"], "--scheme", "default"),
    (["--integrator", "usl"], "--integrator", "leapfrog"), (["--set", "gamma=1.5"], "gamma", "1.4"),
    (["--frames", 5], "--frames", "0"), (["--dry-run"], "--dry-run", None)])
def test_other_choices_are_refused_by_key(plumbline, checkpoint, other, key, kept):
    result = plumbline("run", *other, "--resume", checkpoint, "--results", "none", json=True)
    assert result.code == 2, result.text
    error = result.json("error")["error"]
    assert error["key"] == key and key.lstrip("-") in result.err
    if kept is not None:
        assert error["allowed"] == kept and kept in result.err
    assert not (plumbline.folder / "none").exists(), "nothing was run"


@pytest.mark.parametrize("arguments, key", [
    (["sod", "--every", 5], "--every"), (["sod", "--checkpoint", "f", "--every", 0], "--every"),
    (["sod", "--checkpoint", "f", "--every", -3], "--every"), (["sod", "--checkpoint", ""], "--checkpoint"),
    (["--resume", ""], "--resume"), ([], "case")])
def test_wrong_calls(plumbline, arguments, key):
    result = plumbline("run", *arguments, json=True)
    assert result.code == 2, result.text
    assert result.json("error")["error"]["key"] == key
    assert plumbline.files(".") == []


# --- files --------------------------------------------------------------------------------------------------------------


def refused(plumbline, path):
    result = plumbline("run", "--resume", path, json=True)
    assert result.code == 4, result.text
    assert result.json("error")["error"]["key"] == str(path) and str(path) in result.err
    return result.err


def test_files_that_are_no_checkpoint(plumbline, checkpoint):
    content = checkpoint.read_bytes()
    for size in (0, 5, 100, 512, 600, len(content) // 2, len(content) - 1):
        checkpoint.write_bytes(content[:size])
        refused(plumbline, checkpoint)
    for place in range(0, len(content), len(content) // 23):
        changed = bytearray(content)
        changed[place] ^= 4
        checkpoint.write_bytes(changed)
        refused(plumbline, checkpoint)
    assert "cannot be" in refused(plumbline, plumbline.folder / "absent")
    refused(plumbline, plumbline.folder)
    result_file, = (plumbline.folder / "results").glob("*.h5")
    assert "holds no checkpoint" in refused(plumbline, result_file)
    plain = plumbline.folder / "plain.h5"
    h5py.File(plain, "w").close()
    assert "holds no checkpoint" in refused(plumbline, plain)


@pytest.mark.parametrize("key, value, told", [
    ("fingerprint", "0123456789ab", "begun with other code"), ("case", "sodd", "does not know"),
    ("settings", "cells=20\n", "settings are not those"), ("settings", "no=1\n", "does not know"),
    ("checkpoint", 99, "newer version"), ("step", "ten", "damaged"), ("numbers", [], "is missing"),
    ("numbers", ["nobody"], "nobody")])
def test_checkpoints_of_something_else(plumbline, checkpoint, key, value, told):
    changed = {**about(checkpoint), key: value}
    with edited(checkpoint) as file:
        del file["checkpoint"]
        file["checkpoint"] = json.dumps(changed)
    message = refused(plumbline, checkpoint)
    assert told in message
    if key == "fingerprint":
        own = plumbline("run", "sod", "--cells", 20, json=True).json()["provenance"]["fingerprint"]
        assert value in message and own in message, "both are named"


def test_states_of_something_else(plumbline, checkpoint):
    for name, change in (("bodies/0/velocity", lambda v: v[:-1]), ("bodies/0/id", lambda v: v * 0),
                         ("bodies/0/position", lambda v: v + 5), ("ledger", lambda v: v[:-1]),
                         ("ledger_rows/rows", lambda v: v[:-1]), ("step", lambda v: v + 0.5)):
        content = checkpoint.read_bytes()
        with edited(checkpoint) as file:
            values = file["state"][name][()]
            del file["state"][name]
            file["state"][name] = change(values)
        assert "is damaged" in refused(plumbline, checkpoint), name
        checkpoint.write_bytes(content)


def test_a_place_that_cannot_be_written_is_told_before_the_run(plumbline):
    result = plumbline("run", "sod", "--cells", 20, "--checkpoint", "absent/sod.checkpoint")
    assert result.code == 4 and "absent/sod.checkpoint" in result.err
    assert plumbline.files("results") == []


def test_what_a_dead_process_left_is_cleared_away(plumbline, checkpoint):
    dead = subprocess.Popen(["true"])
    dead.wait()
    left = plumbline.folder / f"sod.checkpoint.{socket.gethostname()}-{dead.pid}.part"
    left.write_bytes(b"half")
    assert plumbline("run", "--resume", checkpoint).code == 0
    assert not left.exists() and checkpoint.exists()
