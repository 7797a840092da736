"""What has been judged already: one line of JSON for each outcome, appended as it comes.

A kill loses what is under way and nothing else; a torn last line is skipped. An outcome counts as long as nothing it could
depend on has changed, which a fingerprint of those sources tells.
"""

import hashlib
import json
import os
import pathlib

from .judges import Outcome

# What every run depends on, and of the cases those of one folder of physics.
EVERYWHERE = ("kernel", "reference", "cases/harness", "cases/plumbline.cpp")
RECORDED = "cases/regressions.json"  # and what gates hold them to


class Fingerprints:
    """Of the sources of a tree; each folder is read once."""

    def __init__(self, root):
        self.root, self.known = pathlib.Path(root), {}

    def of(self, *parts):
        whole = hashlib.sha256()
        for part in parts:
            whole.update(self._of_one(part).encode())
        return whole.hexdigest()[:16]

    def _of_one(self, part):
        if part not in self.known:
            path, whole = self.root / part, hashlib.sha256()
            files = sorted(p for p in path.rglob("*") if p.suffix in (".cpp", ".hpp", ".py", ".html", ".css", ".json", ".in"))
            for file in [path] if path.is_file() else files:
                whole.update(f"{file.relative_to(self.root)}\0".encode())
                whole.update(file.read_bytes())
            self.known[part] = whole.hexdigest()
        return self.known[part]

    def of_mutant(self, mutant):
        at = [str(mutant.at)] if mutant.at >= 0 else []
        text = "\0".join((mutant.file, mutant.context, mutant.find, mutant.replace, mutant.wrap, mutant.type, *at))
        return hashlib.sha256(text.encode()).hexdigest()[:16]


class State:
    """outcomes by (name of the bug or "", name of the judge)."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        self.known = {}
        if not self.path.exists():
            return
        for line in self.path.read_text(encoding="utf-8").splitlines():
            try:
                entry = json.loads(line)
                outcome = Outcome(entry["gates"], entry["stopped"], entry["seconds"], entry["reached"])
                self.known[entry["mutant"], entry["judge"]] = (entry["fingerprint"], outcome)
            except (ValueError, KeyError):
                continue

    def get(self, mutant, judge, fingerprint):
        found = self.known.get((mutant, judge))
        return found[1] if found and found[0] == fingerprint else None

    def put(self, mutant, judge, fingerprint, outcome):
        self.known[mutant, judge] = (fingerprint, outcome)
        entry = {"mutant": mutant, "judge": judge, "fingerprint": fingerprint, "stopped": outcome.stopped,
                 "seconds": outcome.seconds, "reached": outcome.reached, "gates": outcome.gates}  # fmt: skip
        self.path.parent.mkdir(parents=True, exist_ok=True)
        with open(self.path, "a", encoding="utf-8") as stream:
            torn = stream.tell() > 0 and not self._ends_whole()
            stream.write(("\n" if torn else "") + json.dumps(entry) + "\n")
            stream.flush()
            os.fsync(stream.fileno())

    def _ends_whole(self):
        with open(self.path, "rb") as stream:
            stream.seek(-1, os.SEEK_END)
            return stream.read(1) == b"\n"
