"""Readers meet damage of every kind with a reason; the page says what is damaged or not there; old files are read."""

import base64
import gzip
import json
import pathlib
import random
import zlib

import h5py
import numpy
import pytest

from plumbline import reader
import synthetic_results
from html_page import Page, shown, source_of

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
    assert len(reader.load(path).frames) == len(synthetic_results.FRAME_TIMES)


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
            continue  # in the space behind the seal
        with pytest.raises(reader.DamagedFile):
            reader.load(path)


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
        with pytest.raises(reader.DamagedFile):
            reader.load(path)


# --- documents --------------------------------------------------------------------------------------


# Name: what the page says in place of its section, contents and the reasons given for them.
DAMAGED = {
    "stability.json": (
        "No maps of stability are in this report",
        {"{": "", "[]": "", "{}": "", '{"problems": [{"problem": "bar", "safe": [{"limit": NaN}]}]}': ""},
    ),
    "bench.json": (
        "No speed was measured for this report",
        {"{": "", "[]": "", "{}": "", '{"kernels": [1]}': "", '{"kernels": NaN}': ""},
    ),
    "scorecard-x.json": (
        "No time integrator was judged for this report",
        {"{": "", "[]": "", "{}": "", '{"integrator": "x", "sentence": "y", "verdict": NaN}': ""},
    ),
    "judges.json": (
        "was not tried for this report",
        {"{": "", "[]": "", "{}": "", '{"wrong": [1]}': "", '{"wrong": [], "systematic": {"stages": {"map": 3}}}': ""},
    ),
    "mutants.json": (
        "was not tried",
        {
            "{": "not valid JSON",
            "[]": "there is no version",
            '{"version": 2}': "made by a newer version",
            '{"version": 1, "columns": [], "mutants": [{"id": "a"}]}': "its mutants are not whole",
            '{"version": 1, "columns": [], "mutants": [], "counts": {}, "score": null}': "there is no score",
        },
    ),
    "draw.json": (
        "of a random draw the gates see was not tried",
        {
            "[]": "there is no version",
            '{"version": 2}': "made by a newer version",
            '{"version": 1, "operators": [], "folders": [], "mutants": [{"id": "a"}]}': "its mutants are not whole",
            '{"version": 1, "operators": [], "folders": [], "mutants": []}': "there are no rates",
        },
    ),
    "equations.json": ("", {"[]": "", '{"equations": [{"tag": 1}]}': ""}),
    "coverage.json": ("", {'{"total": 2, "folders": {}}': "", '{"total": 0.9}': ""}),
    "list.json": ("", {'{"schemes": [{"name": "default"}]}': ""}),
}


@pytest.mark.parametrize("name, content", [(name, content) for name in DAMAGED for content in DAMAGED[name][1]])
def test_a_damaged_document_is_listed(tmp_path, name, content):
    said, reasons = DAMAGED[name]
    (tmp_path / name).write_text(content, encoding="utf-8")
    assert [file for file, _ in reader.load_folder(tmp_path).damaged] == [name]
    page = shown(tmp_path)
    assert said in page.text
    ((verdict, file, reason),) = [cells for _, cells in page.rows if name in cells]
    assert (verdict, file) == ("INVALID", name) and reasons[content] in reason


@pytest.fixture(scope="module")
def bare_pages(tmp_path_factory):
    """Of no results, and of results without the documents of other commands."""
    nothing, springs = (tmp_path_factory.mktemp(name) for name in ("nothing", "springs"))
    synthetic_results.spring_files_only(springs)
    return {"nothing": source_of(nothing), "springs": source_of(springs)}


@pytest.mark.parametrize(
    "folder, said, absent",
    [
        ("nothing", "There is no readable result file in this folder", None),
        ("nothing", "No time integrator was judged for this report", None),
        ("nothing", "whether wrong integrators are found was not tried", None),
        ("nothing", "whether the gates can fail at all was not tried", None),
        ("nothing", "plumbline bench --cases", None),
        ("nothing", "holds no coverage.json", None),
        ("springs", "No maps of stability are in this report", "Which Courant number is safe"),
        ("springs", "No speed was measured for this report", "Cost of a particle-step"),
        ("springs", "", "What it looks like"),
    ],
)
def test_what_is_not_there_is_said(bare_pages, folder, said, absent):
    source = bare_pages[folder]
    words = Page(source).text
    assert said in words and (absent is None or absent not in source + words)


# --- the previous format ------------------------------------------------------------------------------


@pytest.fixture
def old(tmp_path):
    path = tmp_path / "two-disks.h5"
    path.write_bytes(gzip.decompress(base64.b64decode((STORED / "two-disks.format-1.h5.gz.base64").read_bytes())))
    return path


def test_a_run_of_format_1_is_read_whole(old):
    result = reader.load(old)
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
    found = reader.load_folder(old.parent)
    assert sorted(run.format for run in found.runs) == [1, 2] and not found.damaged
