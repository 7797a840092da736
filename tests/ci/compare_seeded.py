"""ci/compare on real builds: two equal ones, one that has lost an order, one that is slower. The second build is the first
with one file of the kernel changed: that file is compiled and the kernel linked again, nothing else.
Environment: PLUMBLINE_BUILD names the build."""
import json
import os
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ.get("PLUMBLINE_BUILD", ROOT / "build/release"))
CASE = "acoustic-pulse"   # of second order, with the default scheme of gases: leapfrog
SOURCE = ROOT / "kernel/integrators/leapfrog.cpp"
PREDICTION = "mpm.predict_stress(dt / 2);"
MAP = "mpm.map_mass_and_momentum();"
pytestmark = pytest.mark.skipif(not (BUILD / "build.ninja").exists(), reason="asks ninja how the build was made")
COUNTS = shutil.which("valgrind") is not None


def changed_build(folder, old, new):
    """A build folder whose kernel has `new` in the place of `old`."""
    text = SOURCE.read_text(encoding="utf-8")
    assert text.count(old) == 1, f"{SOURCE.name} has changed: choose another seed"
    (folder / "lib").mkdir(parents=True)
    source, compiled, library = folder / SOURCE.name, folder / "changed.o", folder / "lib/libplumbline_kernel.so.0"
    source.write_text(text.replace(old, new), encoding="utf-8")
    commands = subprocess.run(["ninja", "-C", str(BUILD), "-t", "commands", "lib/libplumbline_kernel.so"], capture_output=True,
                              text=True, check=True).stdout.splitlines()
    compile_it, unit = next((shlex.split(line), unit) for line in commands if " -c " in line and (unit := unit_of(line)))
    if unit != SOURCE:
        text = unit.read_text(encoding="utf-8").replace(f'"{SOURCE}"', f'"{source}"')
        source = folder / unit.name
        source.write_text(text, encoding="utf-8")
    built = compile_it[compile_it.index("-o") + 1]
    for option in ("-MF", "-MT"):
        compile_it[compile_it.index(option) + 1] = str(folder / "changed.d")
    link_it = shlex.split(next(line for line in commands if " -shared " in line).split("&&")[1])
    made = link_it[link_it.index("-o") + 1]
    for command, renamed in ((compile_it, {compile_it[-1]: source, built: compiled}), (link_it, {built: compiled, made: library})):
        subprocess.run([str(renamed.get(word, word)) for word in command], cwd=BUILD, check=True)
    script = folder / "bin/plumbline"
    script.parent.mkdir()
    script.write_text(f"#!/bin/sh\nLD_LIBRARY_PATH={folder}/lib exec {BUILD}/bin/plumbline \"$@\"\n")
    script.chmod(0o755)
    return folder


def unit_of(line):
    """The file that a command compiles, if SOURCE is in it: itself, or one that includes several sources."""
    unit = BUILD / shlex.split(line)[-1]
    is_in = unit == SOURCE or ("/Unity/" in str(unit) and f'"{SOURCE}"' in unit.read_text(encoding="utf-8"))
    return unit if is_in else None


def compare(head, output, *options):
    result = subprocess.run([sys.executable, str(ROOT / "ci/compare"), "--builds", str(BUILD), str(head), CASE, "--output", str(output),
                             "--jobs", "1", *options], capture_output=True, text=True, timeout=900)
    sys.stdout.write(result.stdout + result.stderr)
    document = json.loads((output / "head/diff.json").read_text(encoding="utf-8"))
    return result, document, [found for found in document["findings"] if found["change"] == "worse"]


def test_identical_builds(tmp_path):
    """Times alone may stay inconclusive on a busy machine; counts of instructions do not."""
    result, document, worse = compare(BUILD, tmp_path, "--instructions")
    assert not worse and document["moved"] == 0
    if COUNTS:
        assert result.returncode == 0 and document["nothing_changed"]
        assert result.stdout.splitlines()[-1] == "nothing changed"
        (cost,) = (found for found in document["findings"] if found["kind"] == "cost")
        assert cost["size"] == pytest.approx(1, abs=1e-3) if cost["quantity"] == "instructions" else "instructions x 1.000" in cost["note"]


def test_lost_order(tmp_path):
    head = changed_build(tmp_path / "build", PREDICTION, "mpm.predict_stress(0 * dt);")
    result, _, worse = compare(head, tmp_path / "out", "--rounds", "0", "--page")
    assert result.returncode == 1
    orders = [found for found in worse if found["kind"] == "order" and found["case"] == CASE]
    assert orders and all(found["size"] < -0.3 and found["interval"][1] < 0 for found in orders)
    assert any(found["kind"] == "verdict" and found["after"] == "FAIL" for found in worse), "the gates see it, too"
    said = [line for line in result.stdout.splitlines() if line.startswith("  order ")]
    assert "WORSE" in result.stdout and CASE in said[0] and " -> " in said[0]
    page = (tmp_path / "out/index.html").read_text(encoding="utf-8")
    assert "Against the baseline" in page and "Pale broken lines are the baseline" in page


@pytest.fixture(scope="module")
def slower(tmp_path_factory):
    """Points are located and mapped three times, with the same outcome: no number changes but the cost, by a sixth."""
    again = f" mpm.locate_points(); {MAP}"
    return changed_build(tmp_path_factory.mktemp("slower") / "build", MAP, MAP + 2 * again)


@pytest.mark.skipif(not COUNTS, reason="valgrind is not installed (ci/setup --with compare)")
def test_slowdown_by_instructions(slower, tmp_path):
    result, document, worse = compare(slower, tmp_path, "--instructions", "--rounds", "4", "--most-rounds", "4")
    assert result.returncode == 1 and document["moved"] == 0
    assert [found["kind"] for found in worse] == ["cost"] and result.stdout.splitlines()[-1] == "1 worse"
    if worse[0]["quantity"] == "instructions":
        assert 1.12 < worse[0]["size"] < 1.22
    else:  # the times were sure enough by themselves
        assert worse[0]["interval"][0] > 1.1 and "instructions x 1." in worse[0]["note"]


def test_slowdown_by_times(slower, tmp_path):
    """Worse, or inconclusive where the machine does too much else; never the same, and the rest is the same."""
    result, document, worse = compare(slower, tmp_path)
    assert result.returncode == 1 and document["moved"] == 0
    (cost,) = (found for found in document["findings"] if found["change"] != "same")
    assert cost["kind"] == "cost" and cost["change"] in ("worse", "inconclusive") and cost["interval"][1] > 1.1
    assert worse == ([cost] if cost["interval"][0] > 1.1 else [])
