"""`plumbline verify --integrator` on one integrator, and what its gates say of it."""

import json
import os
import pathlib
import subprocess
import tempfile
from dataclasses import dataclass, field

from mutation.judges import run

RED = ("FAIL", "INVALID", "XPASS")
# The families of gates that judge an integrator. Identities hold for wrong physics, too: they alone prove nothing.
FAMILIES = ("consistency", "order", "stability", "energy", "invariance", "jumps", "identities")
PROVING = FAMILIES[:-1]
UNTIL_RED, CORE = ("--until-red",), ("--core",)  # no gate after one that is red; those that take seconds
SECONDS = 1800  # of the processor: many times what the whole set takes


def family_of(gate):
    """That of a gate of an integrator; what cases say of any integrator are identities."""
    return gate["study"] if gate["case"] == "integrator" else FAMILIES[-1]


@dataclass
class Judgement:
    """stopped: why there is no verdict, empty if there is one. red: the red gates, in the order in which they were judged."""

    red: list = field(default_factory=list)
    measured: dict = field(default_factory=dict)  # by the id of each gate
    inconclusive: int = 0
    stopped: str = ""
    seconds: float = 0  # of the processor
    card: dict = field(default_factory=dict)

    @property
    def verdict(self):
        return "stopped" if self.stopped else "red" if self.red else "green"

    def seen_by(self, families=PROVING):
        """The first red gate of these families, else of those that prove something, else the first one; None if all are green."""
        known = [gate for wanted in (families, PROVING, FAMILIES) for gate in self.red if family_of(gate) in wanted]
        return next(iter(known), None)

    @property
    def proven(self):
        return any(family_of(gate) in PROVING for gate in self.red)

    def red_families(self):
        return {family_of(gate) for gate in self.red}


class Program:
    """The executable and the plug-ins that it loads."""

    def __init__(self, build, plugins):
        self.executable = pathlib.Path(build) / "bin/plumbline"
        self.options = [word for plugin in plugins for word in ("--plugin", plugin)]

    def environment(self):
        kept = {k: v for k, v in os.environ.items() if not k.startswith("PLUMBLINE_")}
        return {**kept, "OMP_NUM_THREADS": "1"}

    def integrators(self):
        """{name: {"title", "source"}} of all that are registered."""
        command = [self.executable, "list", *self.options, "--json", "-"]
        listed = subprocess.run(command, env=self.environment(), capture_output=True, text=True, check=True)
        return {entry["name"]: entry for entry in json.loads(listed.stdout)["integrators"]}

    def judge(self, integrator, options=(), settings=()):
        """options: UNTIL_RED or CORE; without, all gates and their scorecard."""
        with tempfile.TemporaryDirectory(prefix="plumbline-judge-") as folder:
            command = [self.executable, "verify", "--integrator", integrator, *options, *self.options, "--json", "verify.json"]
            command += [word for setting in settings for word in ("--set", setting)]
            status, output, seconds, why = run(command, self.environment(), SECONDS, cwd=folder)
            path = pathlib.Path(folder) / "verify.json"
            document = json.loads(path.read_text(encoding="utf-8")) if path.exists() and not why else {}
        judgement = read(document)
        judgement.seconds = round(seconds, 2)
        if why or status not in (0, 1) or "gates" not in document:
            judgement.stopped = why or f"exit status {status}: {last_line(output)}"
        return judgement

    def judge_whole(self, integrator):
        """All gates, with the scorecard of the core set: to that of all gates belong timings, which take as long again."""
        judgement, core = self.judge(integrator, UNTIL_RED), self.judge(integrator, CORE)
        judgement.card, judgement.seconds = core.card, round(judgement.seconds + core.seconds, 2)
        judgement.stopped = judgement.stopped or core.stopped
        return judgement


def read(document):
    gates = document.get("gates", [])
    card = next(iter(document.get("scorecards", [])), {})
    red = [gate for gate in gates if gate["verdict"] in RED]
    measured = {gate["id"]: gate["measured"] for gate in gates}
    return Judgement(red, measured, sum(gate["verdict"] == "INCONCLUSIVE" for gate in gates), card=card)


def last_line(output):
    lines = [line for line in output.splitlines() if line.strip()]
    return lines[-1][:200] if lines else "no output"
