"""What the program says of itself: the names, and the keys with their ranges, that random calls are drawn from."""
import functools
import json
import subprocess


class Catalog:
    """`plumbline list` and `plumbline explain`, each asked once. `plugins`: files; `longest`: s that a drawn run may be expected to take."""

    def __init__(self, executable, plugins=(), longest=2.0, seconds=120):
        self.executable, self.plugins, self.longest, self.seconds = executable, sorted(plugins), longest, seconds

    def ask(self, *arguments):
        answer = subprocess.run([self.executable, *arguments, "--json", "-"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, timeout=self.seconds, check=True)
        return json.loads(answer.stdout)

    @functools.cached_property
    def listing(self):
        return self.ask("list")

    def names(self, kind):
        """Of `cases`, `schemes`, `integrators`, `shapes`, `transfers`, `references`, `problems`."""
        return sorted(entry["name"] for entry in self.listing[kind])

    @functools.cached_property
    def scored(self):
        return sorted(entry["name"] for entry in self.listing["cases"] if entry["scored"])

    @functools.cached_property
    def runs(self):
        """Names of the cases that run scenes; the others have trials."""
        return sorted(entry["name"] for entry in self.listing["cases"] if entry["kind"] != "trials")

    def schemes(self, case):
        return sorted(entry["name"] for entry in self.listing["schemes"] if case in entry["settings"])

    @functools.lru_cache(maxsize=None)
    def explain(self, case):
        return self.ask("explain", case)

    def parameters(self, case):
        return self.explain(case)["parameters"]

    def may_be_undefined(self, case):
        """Measures that some runs of the case do not have."""
        return set(self.explain(case).get("may_be_undefined", ())) if case in self.names("cases") else set()

    @functools.lru_cache(maxsize=None)
    def reference(self, name):
        return self.ask("reference", name)

    @functools.lru_cache(maxsize=None)
    def estimate(self, *runs):
        """Seconds for the runs of `sweep RUNS --plan -`, without set-up and references."""
        return sum(batch["estimated_s"] for batch in self.plan(*runs)["batches"])

    @functools.lru_cache(maxsize=None)
    def plan(self, *runs):
        answer = subprocess.run([self.executable, "sweep", *runs, "--plan", "-"], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                                stderr=subprocess.DEVNULL, timeout=self.seconds, check=True)
        return json.loads(answer.stdout)
