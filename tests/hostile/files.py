"""Hostile files from a grammar: final states for `score`, plans for `sweep`, damaged HDF5, and what is no file at all."""
import json
import os
import random

import contract
import h5py
import numpy

HUGE = (2**25, 2**31, 2**40, 2**62)


# --- any file ---------------------------------------------------------------------------------------


def flip(dice, raw):
    at = dice.randrange(len(raw))
    return raw[:at] + bytes([raw[at] ^ 1 << dice.randrange(8)]) + raw[at + 1:]


def several(change):
    def repeated(dice, raw):
        for _ in range(dice.choice((1, 3, 30))):
            raw = change(dice, raw)
        return raw
    return repeated


DAMAGES = {
    "one bit flipped": flip,
    "some bits flipped": several(flip),
    "cut short": lambda dice, raw: raw[:dice.randrange(len(raw))],
    "emptied": lambda dice, raw: b"",
    "twice in a row": lambda dice, raw: raw + raw,
    "longer than it was": lambda dice, raw: raw + dice.randbytes(4096),
    "other bytes": lambda dice, raw: dice.randbytes(dice.choice((1, 100, 5000))),
    "a text": lambda dice, raw: b'{"no": "HDF5"}\n',
    "a run of zeros": lambda dice, raw: (lambda at: raw[:at] + bytes(min(64, len(raw) - at)) + raw[at + 64:])(dice.randrange(len(raw))),
}


def damage(dice, path):
    """Changes the bytes of a file; what was done."""
    raw = path.read_bytes()
    what = dice.choice(sorted(DAMAGES)) if raw else "emptied"
    path.unlink()
    path.write_bytes(DAMAGES[what](dice, raw))
    return what


def instead(dice, path):
    """Puts what is no file in the place of one; what it is."""
    what = dice.choice(("folder", "dangling link", "loop", "link to a folder", "no file", "link to a device", "empty pipe"))
    if path.is_symlink() or path.exists():
        path.unlink()
    if what == "folder":
        path.mkdir()
    elif what == "dangling link":
        path.symlink_to("nowhere")
    elif what == "loop":
        path.symlink_to(path.name)
    elif what == "link to a folder":
        path.symlink_to(".")
    elif what == "link to a device":
        path.symlink_to("/dev/zero")
    elif what == "empty pipe":
        os.mkfifo(path)
    return what


# --- final states -----------------------------------------------------------------------------------


def handed_back(start, path):
    """The start itself as a final state: a program that did nothing."""
    with h5py.File(start) as source, h5py.File(path, "w") as file:
        file.attrs.update(exchange_format=1, kind="final-state", case=source.attrs["case"], cells=source.attrs["cells"],
                          problem=source.attrs["problem"], start=source.attrs["start"], program="idle", version="1", time=source.attrs["end_time"])
        for body in source["bodies"]:
            group = file.create_group(f"bodies/{body}")
            for key, item in source[f"bodies/{body}"].items():
                if isinstance(item, h5py.Dataset):
                    group[key] = item[()]


def computed(start, run, path):
    """The final state of a run of a tube, from the profile that it keeps of all its points."""
    handed_back(start, path)
    with h5py.File(run) as source, h5py.File(path, "r+") as file:
        profile, (body,) = source["profile"], file["bodies"]
        del file[f"bodies/{body}"]
        group = file.create_group(f"bodies/{body}")
        for name, column in {"position": "x", "velocity": "velocity", "mass": "mass", "volume": "volume", "density": "density",
                             "energy": "energy", "pressure": "pressure"}.items():
            group[name] = profile[column][()].reshape(-1, 1) if name in ("position", "velocity") else profile[column][()]


def columns(file):
    return sorted(f"bodies/{body}/{name}" for body in file["bodies"] for name in file["bodies"][body])


def replace(file, name, value, **layout):
    del file[name]
    if value is None:
        file.create_dataset(name, **layout)
    else:
        file[name] = value


def scaled(factor, *names):
    def change(dice, file):
        for name in columns(file):
            if name.rpartition("/")[2] in names:
                replace(file, name, file[name][()] * factor)
    return change


def one_value(value, *names):
    def change(dice, file):
        fitting = [name for name in columns(file) if name.rpartition("/")[2] in names] or columns(file)
        name = dice.choice(fitting)
        values = numpy.array(file[name][()], dtype=float)
        values.reshape(-1)[dice.randrange(values.size)] = value
        replace(file, name, values)
    return change


# Wrong as physics, right as files: no such state is green.
GRAVE = {
    "velocities in cm/s": scaled(100, "velocity"),
    "nothing moves": scaled(0, "velocity"),
    "everything turned round": scaled(-1, "velocity"),
    "pressures in bar": scaled(1e-5, "pressure"),
    "pressures in kPa, energies in kJ": scaled(1e-3, "pressure", "energy"),
    "stresses in MPa": scaled(1e-6, "stress"),
    "lengths in mm": scaled(1000, "position"),
    "masses in g": scaled(1000, "mass"),
    "one mass lost": one_value(1e-30, "mass"),
    "a point outside": one_value(-5e6, "position"),
    "a velocity of 1e200": one_value(1e200, "velocity"),
    "a pressure of 1e200": one_value(1e200, "pressure", "stress", "deformation"),
}


def hollow(size):
    """A data set that says it is huge and holds nothing."""
    return {"shape": (size,), "chunks": (4096,), "dtype": "f8", "compression": "gzip"}


SHAPES = {
    "a column missing": lambda dice, file, name: file.__delitem__(name),
    "another shape": lambda dice, file, name: replace(file, name, numpy.zeros(dice.choice(((0,), (1,), (3, 3), (2, 2, 2), ())))),
    "a row short": lambda dice, file, name: replace(file, name, file[name][:-1]),
    "texts": lambda dice, file, name: replace(file, name, numpy.array([b"\xff\xfe"] * len(file[name]))),
    "compound": lambda dice, file, name: replace(file, name, numpy.zeros(len(file[name]), dtype="i4,f8")),
    "lists of any length": lambda dice, file, name: replace(file, name, None, shape=(len(file[name]),), dtype=h5py.vlen_dtype("f8")),
    "nothing in it": lambda dice, file, name: replace(file, name, h5py.Empty("f8")),
    "a group": lambda dice, file, name: (file.__delitem__(name), file.create_group(name)),
    "a link to itself": lambda dice, file, name: (file.__delitem__(name), file.__setitem__(name, h5py.SoftLink("/" + name))),
    "a link to nowhere": lambda dice, file, name: (file.__delitem__(name), file.__setitem__(name, h5py.SoftLink("/nowhere"))),
    "a link to another file": lambda dice, file, name: (file.__delitem__(name), file.__setitem__(name, h5py.ExternalLink("none.h5", "/x"))),
    "huge and hollow": lambda dice, file, name: replace(file, name, None, **hollow(dice.choice(HUGE))),
    "all huge and hollow": lambda dice, file, name: [replace(file, other, None, **hollow(HUGE[0])) for other in columns(file)],
    "quarters": lambda dice, file, name: replace(file, name, numpy.asarray(file[name][()], dtype="f2")),
    "not a number": one_value(numpy.nan), "infinite": one_value(numpy.inf), "negative": one_value(-1.0, "mass", "volume", "density"),
    "zero": one_value(0.0, "mass", "volume", "density"), "barely a number": one_value(5e-324, "mass", "volume", "density"),
}
ATTRIBUTES = ("exchange_format", "kind", "case", "cells", "problem", "start", "program", "version", "time")


def spoilt_attribute(dice, file):
    name = dice.choice(ATTRIBUTES)
    if dice.random() < 0.3:
        del file.attrs[name]
        return f"no attribute {name}"
    value = dice.choice((numpy.nan, numpy.inf, -1, 0, 1e300, 2**40, "", "x" * 3000, numpy.bytes_(b"\xff\xfe\x80"), numpy.zeros(3), h5py.Empty("f8"),
                         "../../x", "a b\n", "\u202e", 107, numpy.float32(0.1), numpy.array([], dtype="f8")))
    file.attrs[name] = value
    return f"attribute {name} = {str(value)[:20]!r}"


def spoil(dice, path):
    """Makes a final state wrong; (what was done, whether it is right as a file)."""
    kind = dice.choice(("grave", "grave", "shape", "shape", "attribute", "bytes", "instead"))
    if kind == "bytes":
        return damage(dice, path), False
    if kind == "instead":
        return instead(dice, path), False
    with h5py.File(path, "r+") as file:
        if kind == "attribute":
            return spoilt_attribute(dice, file), False
        if kind == "shape":
            what = dice.choice(sorted(SHAPES))
            change, name = SHAPES[what], dice.choice(columns(file))
            change(dice, file) if change.__code__.co_argcount == 2 else change(dice, file, name)
            return what, False
        what = dice.choice(sorted(GRAVE))
        before = {name: file[name][()].tobytes() for name in columns(file)}
        GRAVE[what](dice, file)
        return what, before != {name: file[name][()].tobytes() for name in columns(file)}


# --- results of this program ------------------------------------------------------------------------


def spoil_result(dice, path):
    """A result file changed below its seal, or sealed again over content that nobody would write; what was done."""
    if dice.random() < 0.6:
        return damage(dice, path)
    with contract.edited(path) as file:
        names = []
        file.visit(names.append)
        name = dice.choice(sorted(names))
        item = file[name]
        kind = dice.choice(("gone", "a group", "hollow", "a text", "attribute"))
        if kind == "attribute":
            file.attrs[dice.choice(("plumbline_format", "kind"))] = dice.choice((-1, 2.5, 99, "run", numpy.bytes_(b"\xff")))
            return f"attributes of {name}"
        scalar_text = isinstance(item, h5py.Dataset) and item.shape == () and item.dtype.kind in "SO"
        del file[name]
        if kind == "a group":
            file.create_group(name)
        elif kind == "hollow":
            file.create_dataset(name, **hollow(dice.choice(HUGE)))
        elif kind == "a text" or scalar_text:
            file[name] = numpy.bytes_(dice.choice((b"{}", b"[1, 2]", b'{"a": NaN}', b"\xff{", b"null", b"[" * 3000)))
        return f"{name}: {kind}"


# --- plans ------------------------------------------------------------------------------------------


JUNK = (None, True, 0, -1, 1.5, 1e308, 2**63, "", "sod", "x" * 300, [], {}, [[]], {"case": "sod"}, "\u0000", "\u202e", "nan", [None], 10**400)


def wrong_value(dice, value, depth=0):
    """A JSON value with something else in it at any depth."""
    if depth > 6 or dice.random() < 0.12:
        return dice.choice(JUNK)
    if isinstance(value, dict):
        changed = {(key if dice.random() < 0.9 else dice.choice(("", "x", key + "s", "settings"))): wrong_value(dice, item, depth + 1)
                   for key, item in value.items()}
        return changed if dice.random() < 0.85 else {**changed, "extra": dice.choice(JUNK)}
    if isinstance(value, list):
        return [wrong_value(dice, item, depth + 1) for item in value] * dice.choice((1, 1, 1, 2))
    return value if dice.random() < 0.75 else dice.choice(JUNK)


def wrong_text(dice, text):
    """JSON with characters missing, doubled or in other places, or bytes that are no text."""
    raw = bytearray(text.encode("utf-8"))
    for _ in range(dice.choice((1, 1, 3, 10))):
        at = dice.randrange(len(raw))
        raw[at:at + dice.choice((0, 1, 1, 5))] = dice.choice((b'"', b"{", b"}", b"[", b"]", b",", b":", b"\\u00", b"\0", b"1e", b"nul", b"", b"\xff"))
    return bytes(raw)


def plan_bytes(dice, plan):
    kind = dice.choice(("values", "values", "text", "bytes", "deep", "whole"))
    if kind == "values":
        return json.dumps(wrong_value(dice, plan)).encode("utf-8", "surrogatepass"), kind
    if kind == "text":
        return wrong_text(dice, json.dumps(plan)), kind
    if kind == "bytes":
        return dice.randbytes(dice.choice((0, 1, 8, 300))), kind
    if kind == "deep":
        depth = dice.choice((100, 10_000, 1_000_000))
        return b'{"runs": ' + dice.choice((b"[" * depth + b"]" * depth, b'{"a":' * depth + b"1" + b"}" * depth)) + b"}", kind
    return json.dumps(plan).encode(), kind


def of(*parts):
    """The random numbers of a draw, from its seed and number alone."""
    return random.Random(" ".join(map(str, parts)))
