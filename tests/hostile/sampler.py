"""Makes draws: each from its seed and number alone, in a folder of its own, every call of it judged."""
import dataclasses
import shutil
import tempfile
import time
from pathlib import Path

import draws
import files
import sandbox
from catalog import Catalog
from outcome import Fault, faults

FLAGS = {"--dry-run", "--allow-inconclusive", "--reuse", "--no-fusion", "--no-runs", "--maps", "--update", "--all", "--core", "--until-red", "--cases", "--help"}
QUICK = 3.0     # s: a draw that took longer is not made again for a shorter call
ATTEMPTS = 30


@dataclasses.dataclass
class Finding:
    seed: str
    number: int
    kind: str
    rule: str
    text: str
    calls: list            # up to the one that showed it, as shell lines
    shorter: str = ""

    def __str__(self):
        lines = [f"seed {self.seed}, draw {self.number} ({self.kind}): {self.rule}: {self.text}", *(f"    {line}" for line in self.calls)]
        return "\n".join(lines + ([f"    shorter: {self.shorter}"] if self.shorter else []))


@dataclasses.dataclass
class Drawn:
    """What came of one draw."""
    number: int
    kind: str
    findings: list
    skipped: str
    statuses: list
    seconds: float


class Sampler:
    """`slow`: how much longer the program takes than a plain build; `memory`: bytes that a call may map, 0 for any; `plugins`: files."""

    def __init__(self, executable, seed, slow=1.0, memory=sandbox.MEMORY, plugins=(), kinds=(), longest=2.0):
        self.executable, self.seed, self.slow, self.memory = str(executable), str(seed), slow, memory
        self.catalog = Catalog(self.executable, plugins, longest)
        self.kinds = kinds

    def begin(self, number):
        """(name of the kind, generator): always the same for a seed and a number."""
        dice = files.of(self.seed, number)
        name = dice.choice(sorted(self.kinds)) if self.kinds else draws.pick(dice)
        return name, draws.KINDS[name][1](dice, self.catalog)

    def make(self, call, folder):
        return sandbox.make(self.executable, call, folder, self.slow, self.memory)

    def draw(self, number, keep=None):
        """One draw. `keep`: a folder to leave what it wrote in."""
        begin = time.monotonic()
        folder = Path(tempfile.mkdtemp(prefix="hostile-"))
        try:
            drawn = self.follow(number, folder, lambda call: self.make(call, folder))
            drawn.seconds = time.monotonic() - begin
            for finding in drawn.findings:
                if drawn.seconds < QUICK and finding.rule not in ("hang", "signal"):
                    finding.shorter = self.shorter(number, len(finding.calls), finding)
            return drawn
        finally:
            if keep:
                shutil.copytree(folder, keep, symlinks=True, dirs_exist_ok=True)
            shutil.rmtree(folder, ignore_errors=True)

    def follow(self, number, folder, make):
        """Makes the calls of a draw with `make` until it ends or a call breaks a rule."""
        name, generator = self.begin(number)
        drawn, calls, answer = Drawn(number, name, [], "", [], 0), [], None
        try:
            while True:
                step = generator.send(answer)
                if step is None:
                    answer = folder
                    continue
                if isinstance(step, draws.Skipped):
                    drawn.skipped = step.why
                    break
                if isinstance(step, Fault):
                    found = [step]
                else:
                    calls.append(step)
                    answer = make(step)
                    drawn.statuses.append(answer.code)
                    found = faults(answer, self.catalog)
                if found:
                    lines = [call.line() for call in calls]
                    drawn.findings += [Finding(self.seed, number, name, fault.rule, fault.text, lines) for fault in found]
                    break
        except StopIteration:
            pass
        return drawn

    def shorter(self, number, count, finding):
        """The call that showed a finding without the options that it does not need; nothing where it needs them all, or two calls."""
        last = None

        def prepare(folder):
            """The folder as it was before the call."""
            nonlocal last
            made = 0

            class Reached(Exception):
                pass

            def make(call):
                nonlocal made, last
                made += 1
                if made == count:
                    last = call
                    raise Reached
                return self.make(call, folder)
            try:
                self.follow(number, folder, make)
            except Reached:
                return True
            return False

        def shows(call):
            folder = Path(tempfile.mkdtemp(prefix="hostile-"))
            try:
                return prepare(folder) and any(fault.rule == finding.rule for fault in faults(self.make(call or last, folder), self.catalog))
            finally:
                shutil.rmtree(folder, ignore_errors=True)

        if not shows(None):
            return ""
        shortest, attempts, at = last, 0, 0
        while at < len(groups(shortest.arguments)) and attempts < ATTEMPTS:
            parts = groups(shortest.arguments)
            trial = dataclasses.replace(shortest, arguments=tuple(word for k, part in enumerate(parts) if k != at for word in part))
            attempts += 1
            if parts[at][0] in ("--json", "--dry-run") or not isinstance(parts[at][0], str) or not parts[at][0].startswith("--") or not shows(trial):
                at += 1
            else:
                shortest = trial
        return shortest.line() if shortest.arguments != last.arguments else ""


def groups(arguments):
    """An option with its value, or a word alone."""
    found, words = [], list(arguments)
    while words:
        word = words.pop(0)
        option = isinstance(word, str) and word.startswith("--") and word not in FLAGS and len(word) > 2
        found.append((word, words.pop(0)) if option and words else (word,))
    return found
