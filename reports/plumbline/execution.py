"""Runs the executable and gives back what it wrote. A red verdict is a result; what the executable refuses is an exception."""

import json
import os
import pathlib
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from typing import Any

from plumbline import reader
from plumbline.reader import Result

ENVIRONMENT = "PLUMBLINE"
_PASS, _RED, _STOPPED = 0, 1, 3  # exit statuses that come with a result
Path = str | os.PathLike[str]


class ExecutionError(Exception):
    """The executable ended without a result. `status`: its exit status, negative where a signal ended it; `command`: the call."""

    def __init__(self, message: str, status: int, command: Sequence[str]) -> None:
        super().__init__(message)
        self.status = status
        self.command = list(command)


class RunStopped(ExecutionError):
    """A run stopped before its end. `result` holds what there is of it."""

    def __init__(self, message: str, status: int, command: Sequence[str], result: Result) -> None:
        super().__init__(message, status, command)
        self.result = result


class ExecutableNotFound(FileNotFoundError):
    """There is no executable where it was looked for."""


def executable_path(executable: Path | None = None) -> str:
    """The executable: the one given, else that of the environment variable PLUMBLINE, else `plumbline` on PATH."""
    for given, origin in ((executable, "executable"), (os.environ.get(ENVIRONMENT), f"the environment variable {ENVIRONMENT}")):
        if given:
            found = shutil.which(os.fspath(given))
            if found is None:
                raise ExecutableNotFound(f"{origin} = {os.fspath(given)} is no file that can be executed")
            return found
    found = shutil.which("plumbline")
    if found is None:
        raise ExecutableNotFound(
            f"no executable 'plumbline' on PATH; name one by the argument executable or the environment variable {ENVIRONMENT}"
        )
    return found


def run(
    case: str,
    *,
    cells: int | None = None,
    scheme: str | None = None,
    integrator: str | None = None,
    frames: int | None = None,
    threads: int | None = None,
    plugins: Sequence[Path] = (),
    results: Path | None = None,
    executable: Path | None = None,
    **settings: Any,
) -> Result:
    """One run of a case: its profile, measures, ledger and gates.

    `settings` are the keys that `plumbline explain CASE` lists; one with a dot is given as `**{"viscosity.linear": 0.1}`.
    `frames` keeps so many snapshots of all points. The result file stays in the folder `results`, if one is given.
    Raises ExecutionError for what the executable refuses, RunStopped when the run stopped, ExecutableNotFound, NotInstalled without h5py.
    """
    reader.hdf5()  # first, for a run may take hours
    options = [case, *_given(cells=cells, frames=frames), *_common(scheme, integrator, threads, plugins, settings)]
    with _Call("run", options, results, executable) as call:
        return call.result(reader.load(call.folder / call.document["file"]))


def converge(
    case: str,
    *,
    cells: Sequence[int] | None = None,
    vary: str | None = None,
    scheme: str | None = None,
    integrator: str | None = None,
    threads: int | None = None,
    plugins: Sequence[Path] = (),
    results: Path | None = None,
    executable: Path | None = None,
    **settings: Any,
) -> Result:
    """A refinement study of a case: errors of all levels, orders with their 95 % intervals, error constants.

    `cells` are the meshes, else those that the case declares; `vary` is what is refined: cells, dt, ppc or offset. All else as for `run`.
    """
    reader.hdf5()
    meshes = None if cells is None else ",".join(str(number) for number in cells)
    options = [case, *_given(cells=meshes, vary=vary), *_common(scheme, integrator, threads, plugins, settings)]
    with _Call("converge", options, results, executable) as call:
        (study,) = call.document["studies"]
        for file in sorted(call.folder.glob(f"study-{case}-*.h5")):
            found = reader.load(file)
            if all(found.study.get(key) == study[key] for key in ("scheme", "vary", "settings", "levels")):
                return call.result(found)
        raise ExecutionError("the executable left no file of the study", call.status, call.command)


def verify(
    *patterns: str,
    tier: str = "quick",
    scheme: str | None = None,
    integrator: str | None = None,
    core: bool = False,
    threads: int | None = None,
    plugins: Sequence[Path] = (),
    results: Path | None = None,
    executable: Path | None = None,
    **settings: Any,
) -> Result:
    """The gates of all cases that match the patterns, or of an integrator: `.gates`, `.verdict`, and in `.verdicts` the whole document.

    `tier` is quick or full; `core` judges an integrator by the core set of gates. All else as for `run`.
    """
    options = [*patterns, *_given(tier=tier), *(["--core"] if core else [])]
    with _Call("verify", options + _common(scheme, integrator, threads, plugins, settings), results, executable) as call:
        document = call.document
        return call.result(
            Result("verdicts", "", reader.FORMAT_VERSION, verdicts=document, gates=document["gates"], provenance=document["provenance"])
        )


def _given(**options: Any) -> list[str]:
    return [word for name, value in options.items() if value is not None for word in (f"--{name}", str(value))]


def _common(
    scheme: str | None, integrator: str | None, threads: int | None, plugins: Sequence[Path], settings: dict[str, Any]
) -> list[str]:
    choices = [word for key, value in settings.items() for word in ("--set", f"{key}={_written(value)}")]
    libraries = [word for plugin in plugins for word in ("--plugin", os.fspath(plugin))]
    return [*_given(scheme=scheme, integrator=integrator, threads=threads), *libraries, *choices]


def _written(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(float(value)) if isinstance(value, float) else str(value)


class _Call:
    """One call of the executable with a folder for its results, which goes again unless it is the user's."""

    def __init__(self, name: str, options: list[str], results: Path | None, executable: Path | None) -> None:
        self._temporary = None if results else tempfile.TemporaryDirectory(prefix="plumbline-")
        self.folder = pathlib.Path(results or self._temporary.name)  # type: ignore[union-attr]
        self.command = [executable_path(executable), name, *options, "--results", str(self.folder), "--json", "-"]
        self.status = 0
        self.document: dict[str, Any] = {}

    def __enter__(self) -> "_Call":
        try:
            self._run()
        except BaseException:
            self.__exit__()
            raise
        return self

    def __exit__(self, *_: object) -> None:
        if self._temporary:
            self._temporary.cleanup()

    def _run(self) -> None:
        ended = subprocess.run(self.command, capture_output=True, text=True, encoding="utf-8", check=False)
        self.status = ended.returncode
        try:
            document = json.loads(ended.stdout)
        except ValueError:
            document = None
        if self.status not in (_PASS, _RED, _STOPPED) or not isinstance(document, dict) or "error" in document:
            error = (document.get("error") or {}) if isinstance(document, dict) else {}
            said = error.get("message") or ended.stderr.strip().removeprefix("plumbline: ")
            raise ExecutionError(said or f"{self.command[0]} ended with status {self.status}", self.status, self.command)
        self.document = document

    def result(self, result: Result) -> Result:
        """The result, unless a run of it stopped."""
        if self.status != _STOPPED:
            return result
        stops = [entry.get("stop") for entry in (result.run, *(result.study.get("levels") or []))]
        told = [f"a run stopped at step {stop['step']}: {stop['reason']}" for stop in stops if isinstance(stop, dict)]
        raise RunStopped(told[0] if told else "a run stopped", self.status, self.command, result)
