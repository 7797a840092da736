"""One plan of 200 short runs, and the engines that run it. Environment: PLUMBLINE names the executable."""
import contextlib
import json
import os
import shutil
import signal
import subprocess
import time
from itertools import product
from pathlib import Path

import pytest
from contract import Plumbline, contents

ROOT = Path(__file__).resolve().parents[2]
ENGINE = ROOT / "ci" / "sweep"
RUNS = 200
RUNS_IN_BATCH = 20


def user_plan():
    """Short runs of two schemes at several meshes, places of the grid and points per cell."""
    axes = product(("default", "york1997"), (30, 40, 50, 60), (4, 6, 7, 8, 9), (0, 0.2, 0.4, 0.6, 0.8))
    return {"runs": [{"case": "sod", "scheme": scheme, "settings": {"cells": cells, "ppc": ppc, "offset": offset}}
                     for scheme, cells, ppc, offset in axes]}


def in_batches_of_twenty(plan):
    """Batches as small as a test needs them, the last one as if it were long: it goes alone."""
    runs = [run for batch in plan["batches"] for run in batch["runs"]]
    parts = [runs[first : first + RUNS_IN_BATCH] for first in range(0, len(runs), RUNS_IN_BATCH)]
    sizes = ["small"] * (len(parts) - 1) + ["large"]
    batches = [{"id": f"{number:04}-{size}", "size": size, "estimated_s": 2, "memory_mb": 10, "runs": part}
               for number, (part, size) in enumerate(zip(parts, sizes), 1)]
    return {**plan, "batches": batches}


def await_(what, seconds, ready):
    """What `ready` gives once it gives something."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if found := ready():
            return found
        time.sleep(0.05)
    raise TimeoutError(f"waited {seconds} s for {what}")


class Sweeps:
    """A folder with the plan; each engine gets its own folder of results in it."""

    def __init__(self, folder):
        if not shutil.which("snakemake"):
            pytest.skip("Snakemake is not installed: ci/setup --with slurm")
        self.folder = folder
        self.plumbline = Plumbline(folder)
        (folder / "user.json").write_text(json.dumps(user_plan()))
        made = self.plumbline("sweep", "--from", "user.json", "--plan", "batched.json")
        assert made.code == 0, made.text
        self.plan = in_batches_of_twenty(json.loads((folder / "batched.json").read_text()))
        self.names = {run["file"] for batch in self.plan["batches"] for run in batch["runs"]}
        assert len(self.names) == RUNS
        (folder / "plan.json").write_text(json.dumps(self.plan))

    def snakemake(self, profile, results, *options, plan="plan.json", environment=None, seconds=300):
        """Starts Snakemake as the head of its own group of processes; `finish` waits for it."""
        command = ["timeout", "-k", "5", str(seconds), "snakemake", "--snakefile", str(ENGINE / "Snakefile"), "--profile",
                   str(ENGINE / "profiles" / profile), *options, "--config", f"plumbline={self.plumbline.executable}",
                   f"plan={plan}", f"results={results}"]
        # CI=true: Snakemake asks the scheduler each second, not every ten.
        variables = {**os.environ, **(environment or {}), "CI": "true", "OMP_NUM_THREADS": "1", "XDG_CACHE_HOME": str(self.folder)}
        return subprocess.Popen(command, cwd=self.folder, env=variables, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, text=True, start_new_session=True)

    def stored(self, results):
        """{name: path} of the files that are whole: others have no such name yet."""
        return {path.name: path for path in (self.folder / results).glob("*.h5") if path.name in self.names}

    def numbers(self, results):
        """All numbers of all runs; every run has to be there."""
        found = self.stored(results)
        assert set(found) == self.names, f"{results}: {len(found)} of {RUNS} runs"
        return {name: contents(path) for name, path in found.items()}

    def markers(self, results):
        return {path.name for path in (self.folder / results / ".sweep").glob("*/*") if path.suffix != ".new"}

    def assert_complete(self, results):
        assert self.markers(results) == {"verdict"} | {batch["id"] for batch in self.plan["batches"]}


def differences(numbers, others):
    """[(file, part)] in which two sweeps differ."""
    assert set(numbers) == set(others)
    return [(name, part) for name in numbers for part in sorted(set(numbers[name]) | set(others[name]))
            if numbers[name].get(part) != others[name].get(part)]


def finish(process):
    """(exit status, output) of a started Snakemake."""
    output, _ = process.communicate(timeout=320)
    return process.returncode, output


def kill_all_of(process):
    """kill -9 to the process and all that it started."""
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()
