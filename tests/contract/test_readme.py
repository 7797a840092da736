"""README's figures are what its own command prints (times apart)."""

import json
import os
import pathlib
import re
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
PLUMBLINE = os.environ["PLUMBLINE"]


def test_the_table_is_what_the_command_prints(tmp_path):
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("$ build/release/bin/plumbline converge sod"))
    shown = []
    for line in lines[start + 1 :]:
        if line.startswith("```"):
            break
        shown.append(line)
    arguments = lines[start].split()[2:]
    process = subprocess.run([PLUMBLINE, *arguments, "--results", str(tmp_path)], capture_output=True, text=True, check=True)
    printed = process.stdout.splitlines()[: len(shown)]
    assert [_without_time(line) for line in shown] == [_without_time(line) for line in printed]


def test_the_table_of_claims_is_what_the_integrators_state():
    listed = json.loads(subprocess.run([PLUMBLINE, "list", "--json", "-"], capture_output=True, text=True, check=True).stdout)
    expected = []
    for integrator in listed["integrators"]:
        claims = integrator["claims"]
        cells = [f"`{integrator['name']}`", *(claims.get(family, "") for family in ("order", "stability", "energy", "invariance"))]
        expected.append("| " + " | ".join(cells) + " |")
    lines = (ROOT / "kernel" / "README.md").read_text(encoding="utf-8").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("| integrator | order in dt | limit | energy | invariance |"))
    assert lines[start + 2 : start + 2 + len(expected)] == expected


def test_the_table_of_schemes_is_what_they_are():
    listed = json.loads(subprocess.run([PLUMBLINE, "list", "--json", "-"], capture_output=True, text=True, check=True).stdout)
    by_default, york = ({kind: values for kind, values in scheme["kinds"].items()} for scheme in listed["schemes"])
    kinds = ["gas", "membrane", "solid", "coupled"]
    expected = []
    for key in dict.fromkeys(key for values in by_default.values() for key in values):
        cells = [_both(by_default[kind][key], york[kind][key]) if key in by_default[kind] else "" for kind in kinds]
        expected.append(f"| `{key}` | " + " | ".join(cells) + " |")
    lines = (ROOT / "README.md").read_text(encoding="utf-8").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("| key | gas | membrane | solid | coupled |"))
    shown = lines[start + 2 : start + 2 + len(expected)]
    assert sorted(shown) == sorted(expected), "\n".join(expected)


def _both(one, other):
    words = ["none" if value is None else f"{value:g}" if isinstance(value, (int, float)) else value for value in (one, other)]
    return words[0] if words[0] == words[1] else " / ".join(words)


def _without_time(line):
    words = line.split()
    if len(words) > 4 and re.fullmatch(r"\d+", words[0]):
        words[3] = "time"
    return words
