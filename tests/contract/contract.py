"""The executable under test and the JSON Schema, as the contract tests use them. Environment: PLUMBLINE names the executable."""
import contextlib
import json
import os
import subprocess
import time
import zlib
from pathlib import Path

import h5py
import jsonschema
import numpy

ROOT = Path(__file__).resolve().parents[2]
SCHEMA = json.loads((ROOT / "cases/harness/schema/plumbline.schema.json").read_text(encoding="utf-8"))
# Fields that may differ between two runs of the same binary on the same input.
VOLATILE = {"wall_s", "elapsed_s", "particle_steps_per_s", "started", "threads", "command"}


def validate(definition, document):
    """Checks a document against one definition of the schema and names the deepest fault."""
    schema = {"$schema": SCHEMA["$schema"], "$defs": SCHEMA["$defs"], "$ref": f"#/$defs/{definition}"}
    validator = jsonschema.Draft202012Validator(schema)
    errors = list(validator.iter_errors(document))
    if errors:
        error = jsonschema.exceptions.best_match(errors)
        place = "/".join(str(step) for step in error.absolute_path) or "(top)"
        raise AssertionError(f"{definition}: at {place}: {error.message[:600]}")
    return document


def parse(text):
    """JSON as the contract has it: no NaN, no Infinity, and nothing beside it."""
    def refuse(constant):
        raise AssertionError(f"{constant} in JSON: numbers that are not finite are null")
    return json.loads(text, parse_constant=refuse)


def without_volatile(value):
    if isinstance(value, dict):
        return {key: without_volatile(item) for key, item in value.items() if key not in VOLATILE}
    return [without_volatile(item) for item in value] if isinstance(value, list) else value


def contents(path):
    """Everything in a result file: attributes, shapes, types, bytes; JSON and columns without the volatile fields."""
    found = {}

    def visit(name, item):
        found[name + "@"] = {key: str(value) for key, value in item.attrs.items()}
        if isinstance(item, h5py.Dataset) and name.rpartition("/")[2] not in VOLATILE:
            value = item[()]
            if isinstance(value, bytes):
                found[name] = without_volatile(json.loads(value))
            else:
                found[name] = (str(item.dtype), numpy.shape(value), numpy.asarray(value).tobytes())

    with h5py.File(path) as stored:
        visit("", stored["/"])
        stored.visititems(visit)
    return found


@contextlib.contextmanager
def edited(path):
    """A result file to be changed by hand, and sealed again as if it had been written so."""
    with h5py.File(path, "r+") as file:
        yield file
    path = Path(path)
    content = path.read_bytes()[512:]
    seal = f"plumbline: {len(content)} bytes follow byte 512, CRC-32 {zlib.crc32(content):08x}\n".encode()
    path.write_bytes(seal.ljust(512, b"\0") + content)


def children_of(process):
    """Numbers of the processes that a process of ours has started."""
    found = []
    for entry in os.listdir("/proc"):
        if not entry.isdigit():
            continue
        try:
            with open(f"/proc/{entry}/stat", encoding="utf-8") as status:
                if int(status.read().rpartition(")")[2].split()[1]) == process.pid:
                    found.append(int(entry))
        except (OSError, ValueError):
            pass
    return found


def wait_for_end(process_ids):
    deadline = time.monotonic() + 60
    while any(os.path.exists(f"/proc/{number}") for number in process_ids):
        assert time.monotonic() < deadline, "children outlive their parent"
        time.sleep(0.01)


def rows_left(body, rows):
    """A change of a file: of every dataset of a body the rows of this slice are left."""
    def change(file):
        for name in file[f"bodies/{body}"]:
            values = file[f"bodies/{body}/{name}"][()]
            del file[f"bodies/{body}/{name}"]
            file[f"bodies/{body}/{name}"] = values[rows]
    return change


class Result:
    def __init__(self, process, definition):
        self.code, self.out, self.err = process.returncode, process.stdout, process.stderr
        self.definition = definition

    @property
    def text(self):
        return self.out + self.err

    def json(self, definition=None):
        """The document on standard output, valid under the definition of the command (or the one given)."""
        return validate(definition or self.definition, parse(self.out))


class Plumbline:
    """Runs the executable in a folder of its own: `plumbline("run", "sod", json=True)`."""

    def __init__(self, folder, executable=None):
        self.folder = folder
        self.executable = executable or os.environ.get("PLUMBLINE")
        if not self.executable or not os.access(self.executable, os.X_OK):
            raise AssertionError(f"PLUMBLINE={self.executable!r} names no executable; ctest sets it")

    def command(self, *arguments, json=False):
        return [str(self.executable), *map(str, arguments), *(["--json", "-"] if json else [])]

    def __call__(self, *arguments, json=False, timeout=300, environment=None):
        variables = {**os.environ, "OMP_NUM_THREADS": "1", **(environment or {})}
        process = subprocess.run(self.command(*arguments, json=json), cwd=self.folder, env=variables, stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=timeout, encoding="utf-8")
        return Result(process, arguments[0] if arguments else None)

    def files(self, folder="results"):
        """All files below a folder, relative to it."""
        base = self.folder / folder
        return sorted(str(path.relative_to(base)) for path in base.rglob("*") if path.is_file())


def exported(plumbline, case="sod", *arguments, output="start.h5"):
    result = plumbline("export", case, *arguments, "--output", output, json=True)
    assert result.code == 0, result.text
    return result.json("export"), plumbline.folder / output


def hand_in(plumbline, start, name="result.h5", time=None, change=None, attributes=None):
    """The start itself as a final state, changed by `change(group)`: wrong as physics, right as a file."""
    path = plumbline.folder / name
    with h5py.File(start) as source, h5py.File(path, "w") as file:
        file.attrs.update(exchange_format=1, kind="final-state", case=source.attrs["case"], cells=source.attrs["cells"],
                          problem=source.attrs["problem"], start=source.attrs["start"], program="a b/c", version="1.2",
                          time=source.attrs["end_time"] if time is None else time)
        for key, value in (attributes or {}).items():
            if value is None:
                del file.attrs[key]
            else:
                file.attrs[key] = value
        for body in source["bodies"]:
            group = file.create_group(f"bodies/{body}")
            for key in source["bodies"][body]:
                if key != "load":
                    group[key] = source["bodies"][body][key][()]
        if change:
            change(file)
    return path
