"""Draws bugs at random from all sites, and builds those that compile into one program.

Each operator has a share of a draw; within an operator every site is as likely as any other. The sites of an operator are
put in an order by the seed; the first ones are drawn. One that overlaps another of the draw, that does not compile or of
which the compiler makes no code (a template nobody asks for) is passed over for the next in that order, and counted.
"""

import json
import pathlib
import random
import re
import subprocess
import tempfile
from dataclasses import dataclass, field

from . import overlay
from .declarations import Mutant, area_of

SHARES = {"coefficient": 0.3, "term": 0.25, "sign": 0.15, "comparison": 0.08, "range": 0.07, "index": 0.06, "column": 0.05,
          "stage": 0.04}  # fmt: skip
MOST = 500  # numbers of switches that an operator has
WHAT = {"coefficient": "2 % larger", "term": "left out", "sign": "with the other sign", "comparison": "compared otherwise",
        "range": "the first or last pass left out", "index": "the element before", "column": "left out", "stage": "left out"}  # fmt: skip


@dataclass
class Draw:
    seed: int
    counts: dict  # operator: how many
    orders: dict  # operator: its sites in the order of the seed
    passed_over: dict = field(default_factory=dict)  # id: why

    def mutants(self):
        """As many of each operator as wanted, those passed over left out."""
        drawn, taken = [], {}
        for number_of_operator, (operator, wanted) in enumerate(self.counts.items()):
            count = 0
            for place, site in enumerate(self.orders[operator][:MOST]):
                if count == wanted:
                    break
                mutant = self._mutant(site, place, MOST * number_of_operator + place + 1)
                if mutant.id in self.passed_over:
                    continue
                if any(site.start < end and start < site.end for start, end in taken.get(site.file, ())):
                    self.passed_over[mutant.id] = "overlaps another"
                    continue
                taken.setdefault(site.file, []).append((site.start, site.end))
                drawn.append(mutant)
                count += 1
        return drawn

    def _mutant(self, site, place, number):
        find = " ".join(site.find.split())
        what = f"pass of {site.type}" if site.wrap == "skip" else find if len(find) <= 120 else f"{find[:117]}..."
        replaced = f" ({' '.join(site.replace.split())})" if site.operator in ("comparison", "index", "range") else ""
        return Mutant(
            id=f"s{self.seed}-{site.operator}-{place:03d}",
            kind=site.operator,
            file=site.file,
            what=f"{what}: {WHAT[site.operator]}{replaced}",
            find=site.find,
            replace=site.replace,
            area=area_of(site.file),
            origin="drawn",
            wrap=site.wrap,
            type=site.type,
            at=site.start,
            number=number,
        )


def draw(sites, seed, count):
    """Shares of `count`, rounded so that they add up to it; an operator with fewer sites gives what it has."""
    counts = {operator: int(share * count) for operator, share in SHARES.items()}
    for operator in sorted(SHARES, key=lambda o: counts[o] - SHARES[o] * count)[: count - sum(counts.values())]:
        counts[operator] += 1
    orders = {}
    for operator in SHARES:
        own = [site for site in sites if site.operator == operator]
        random.Random(f"{seed} {operator}").shuffle(own)
        orders[operator] = own
    return Draw(seed, counts, orders)


def build(drawn, base, folder, tests, jobs, say):
    """(program, mutants): what compiles, of which there is code; `drawn` takes note of what it passed over."""
    kept = pathlib.Path(folder) / "passed_over.json"
    if kept.exists():
        drawn.passed_over.update(json.loads(kept.read_text()))
    while True:
        mutants = drawn.mutants()
        why = {}
        try:
            program = overlay.build(base, folder, mutants, evaluator=True, jobs=jobs, whole=tests)
            made = switches_of([program.plumbline, *program.libraries.glob("*.so*"), *program.tests.values(), program.evaluate])
            why = {m.id: "no code" for m in mutants if m.number not in made}
        except overlay.BuildError:
            why = {name: "does not compile" for name in faulty(pathlib.Path(folder), mutants)}
            if not why:
                raise
        if not why:
            return program, mutants
        say("passed over: " + ", ".join(f"{name} ({reason})" for name, reason in why.items()))
        drawn.passed_over.update(why)
        kept.write_text(json.dumps(drawn.passed_over))


def switches_of(files):
    """Numbers of the switches that the machine code of these files holds."""
    found = set()
    with tempfile.NamedTemporaryFile() as numbers:
        for file in files:
            command = ["objcopy", "--dump-section", f"{overlay.SECTION}={numbers.name}", str(file), "/dev/null"]
            if subprocess.run(command, capture_output=True).returncode == 0:
                data = pathlib.Path(numbers.name).read_bytes()
                found |= {int.from_bytes(data[k : k + 4], "little") for k in range(0, len(data), 4)}
    return found


def faulty(folder, mutants):
    """Names of the bugs in whose lines the compiler found errors; if there is none, of those whose lines it names otherwise; else of the
    nearest above each error, which may have made another type of what stands there."""
    log = (folder / "build.log").read_text(encoding="utf-8", errors="replace")
    lines = {mutant.id: _lines(folder / "overlay", mutant) for mutant in mutants}
    named = {}
    for marks in (r"error", r"error|note|   required from"):
        named[marks] = {(file, int(line)) for file, line, _ in re.findall(rf"overlay/([^\s:]+):(\d+):\d+:\s+({marks})", log)}
        if names := [name for name, own in lines.items() if named[marks] & own]:
            return names
    above = set()
    for file, line in named["error"]:
        own = [(min(places)[1], name) for name, places in lines.items() if min(places)[0] == file and min(places)[1] < line]
        above |= {max(own)[1]} if own else set()
    return sorted(above)


def _lines(overlay_folder, mutant):
    """(file, line) of the text that holds a switch and both forms of its bug."""
    text = (overlay_folder / mutant.file).read_text(encoding="utf-8")
    at = text.index(f"PLUMBLINE_MUTANT({mutant.number})")
    first = text.count("\n", 0, at) + 1
    return {(mutant.file, line) for line in range(first, first + len(mutant.switched().splitlines()))}
