"""Readers of result files meet damage of every kind with a reason; files of the previous format are read."""

import base64
import gzip
import json
import pathlib
import random
import zlib

import h5py
import numpy
import pytest

import plumbline_results
import synthetic_results

STORED = pathlib.Path(__file__).with_name("stored")
MUTANTS = 200  # of each kind of file and damage


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("damage")
    names = synthetic_results.write_all(folder, damaged=False)
    return {kind: (folder / names[kind]).read_bytes() for kind in ("run", "study", "verdicts", "frames")}


def sealed(content):
    """As the harness writes files."""
    seal = f"plumbline: {len(content)} bytes follow byte 512, CRC-32 {zlib.crc32(content):08x}\n".encode()
    return seal.ljust(512, b"\0") + content


def test_a_sealed_file_is_read(folder, tmp_path):
    path = tmp_path / "whole.h5"
    path.write_bytes(sealed(folder["frames"]))
    assert len(plumbline_results.load(path).frames) == len(synthetic_results.FRAME_TIMES)


def cut(content, dice):
    del content[dice.randrange(len(content)) :]


def change_bytes(content, dice):
    for _ in range(dice.choice((1, 1, 2, 8, 64))):
        content[dice.randrange(len(content))] = dice.randrange(256)


def lose_a_block(content, dice):
    """A block that a disk gave back empty."""
    start, size = dice.randrange(len(content)), dice.choice((4, 64, 512))
    content[start : start + size] = bytes(len(content[start : start + size]))


def flip_a_bit_at_the_start(content, dice):
    content[dice.randrange(min(len(content), 4096))] ^= 1 << dice.randrange(8)


@pytest.mark.parametrize("damage", [cut, change_bytes, lose_a_block, flip_a_bit_at_the_start])
@pytest.mark.parametrize("kind", ["run", "study", "verdicts", "frames"])
def test_no_damage_goes_unnoticed(folder, tmp_path, kind, damage):
    """HDF5 alone would run in circles in some of these files, die of others, and give wrong numbers from most."""
    path = tmp_path / "damaged.h5"
    dice = random.Random(f"{kind} {damage.__name__}")
    whole = sealed(folder[kind])
    for _ in range(MUTANTS):
        content = bytearray(whole)
        damage(content, dice)
        path.unlink(missing_ok=True)  # writing over a file waits for the disk
        path.write_bytes(content)
        if content.rstrip(b"\0")[512:] == whole.rstrip(b"\0")[512:] and len(content) == len(whole):
            continue  # in the room behind the seal
        with pytest.raises(plumbline_results.DamagedFile):
            plumbline_results.load(path)


JUNK = (None, True, 0, -1, 1e400, "", "x", [], [None], {}, {"": []}, [[1, 2], [3]])


@pytest.mark.parametrize("part", ["description", "time", "start", "position", "body", "stress"])
def test_junk_in_a_part_of_the_frames(folder, tmp_path, part):
    for number, junk in enumerate((*JUNK, numpy.zeros((2, 2, 2)), numpy.array([], float), h5py.Empty("f"))):
        path = tmp_path / f"{number}.h5"
        path.write_bytes(folder["frames"])
        with h5py.File(path, "a") as file:
            del file[f"frames/{part}"]
            value = junk if isinstance(junk, (numpy.ndarray, h5py.Empty)) else numpy.bytes_(json.dumps(junk))
            file[f"frames/{part}"] = value
        with pytest.raises(plumbline_results.DamagedFile):
            plumbline_results.load(path)


@pytest.fixture
def old(tmp_path):
    path = tmp_path / "two-disks.h5"
    path.write_bytes(gzip.decompress(base64.b64decode((STORED / "two-disks.format-1.h5.gz.base64").read_bytes())))
    return path


def test_a_run_of_format_1_is_read_whole(old):
    result = plumbline_results.load(old)
    assert result.format == 1 and result.kind == "run" and result.run["case"] == "two-disks"
    assert result.provenance["version"] == "0.5.0" and result.settings["cells"] == 4
    assert result.measures["restitution"]["value"] == result.run["measures"]["restitution"]["value"]
    assert set(result.ledger) >= {"mass", "momentum_x", "momentum_y", "angular_momentum", "energy"}
    frames = result.frames
    assert len(frames) == 2 and [body["name"] for body in frames.bodies] == ["lower", "upper"]
    assert frames.times[0] == 0 and frames.times[1] == pytest.approx(result.run["time"])
    for frame in range(2):
        for body in range(2):
            points = frames.body(frame, body)
            assert len(points["id"]) > 0 and numpy.isfinite(points["position"]).all()


def test_a_folder_may_hold_both_formats(old, folder):
    (old.parent / "new.h5").write_bytes(folder["run"])
    found = plumbline_results.load_folder(old.parent)
    assert sorted(run.format for run in found.runs) == [1, 2] and not found.damaged
