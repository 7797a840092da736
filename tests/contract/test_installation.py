"""An installed Plumbline, moved elsewhere: users add an integrator as a plug-in of one file and need no fork."""
import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml
from contract import ROOT, Plumbline

PLUGIN = Path(__file__).parent / "plugin"


def call(*command, **options):
    process = subprocess.run([str(part) for part in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=900, **options)
    assert process.returncode == 0, process.stdout
    return process.stdout


@pytest.fixture(scope="module")
def prefix(tmp_path_factory):
    folder = tmp_path_factory.mktemp("installed")
    call(os.environ["CMAKE"], "--install", os.environ["PLUMBLINE_BUILD"], "--prefix", folder / "first")
    (folder / "first").rename(folder / "moved")   # nothing in it may know where it was built or installed
    return folder / "moved"


@pytest.fixture(scope="module")
def plugin(prefix, tmp_path_factory):
    """The averaged integrator's own file under another name, built against the installation alone."""
    source = (ROOT / "kernel/integrators/usavg.cpp").read_text(encoding="utf-8")
    assert '"usavg"' in source
    return built(source.replace('"usavg"', '"mine"'), prefix, tmp_path_factory.mktemp("plugin"))


# Parts of a scheme, each of one file: its kind, what runs it, and what it is called there.
EXAMPLES = {
    "bardenhagen": ("contacts", "two-disks", "contact=bardenhagen"),
    "mooney_rivlin": ("materials", "spinning-disk", "material=mooney_rivlin"),
    "pic_flip": ("transfers", "two-disks", "transfer=pic-flip"),
    "moving_least_squares": ("shapes", "two-disks", "shape=moving-least-squares"),
    "corners": ("shapes", "two-disks", "shape=corners"),
    "bonds": ("materials", "two-disks", "material=bonds"),
}


@pytest.fixture(scope="module", params=EXAMPLES)
def example(request, prefix, tmp_path_factory):
    """Name and library of an example outside the repository, built in a folder of its own."""
    source = (PLUGIN / f"examples/{request.param}.cpp").read_text(encoding="utf-8")
    return request.param, built(source, prefix, tmp_path_factory.mktemp(request.param))


def built(source, prefix, folder):
    shutil.copy(PLUGIN / "CMakeLists.txt", folder)
    (folder / "mine.cpp").write_text(source, encoding="utf-8")
    cmake = os.environ["CMAKE"]
    call(cmake, "-S", folder, "-B", folder / "build", "-G", os.environ["GENERATOR"], f"-DCMAKE_CXX_COMPILER={os.environ['CXX']}",
         "-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_PREFIX_PATH={prefix}")
    call(cmake, "--build", folder / "build")
    return folder / "build" / "libmine.so"


@pytest.fixture
def installed(prefix, tmp_path):
    return Plumbline(tmp_path, prefix / "bin" / "plumbline")


def test_installed_executable_runs(installed):
    assert installed("run", "sod", "--cells", 20, json=True).json()["finished"]


def test_installed_kernel_is_free_of_gsl_and_hdf5(prefix):
    libraries = [path for path in prefix.rglob("libplumbline_kernel*") if path.is_file()]
    assert libraries
    for library in libraries:
        if ".so" in library.name:
            needed = re.findall(r"\(NEEDED\).*\[(.*)\]", call("readelf", "-d", library))
            assert needed and not [name for name in needed if re.search("gsl|hdf5|reference", name)]
    for header in (prefix / "include").rglob("*.hpp"):
        assert not re.search(r"#include\s*[<\"](gsl|hdf5|H5|nlohmann|reference|cases)", header.read_text(encoding="utf-8")), header


def test_installation_holds_no_path_of_the_build(prefix):
    for path in (prefix / "lib").rglob("*.cmake"):
        text = path.read_text(encoding="utf-8")
        assert str(ROOT) not in text and os.environ["PLUMBLINE_BUILD"] not in text, path


def test_the_installed_package_runs_the_installed_executable(prefix, tmp_path):
    (package,) = (path for path in prefix.glob("lib/**/plumbline") if (path / "execution.py").exists())
    assert package.parent.name in ("dist-packages", "site-packages") and (package / "py.typed").exists()
    environment = {"PATH": f"{prefix / 'bin'}{os.pathsep}{os.environ['PATH']}", "PYTHONPATH": str(package.parent)}
    program = "import plumbline; run = plumbline.run('sod', cells=20); print(run.provenance['version'], len(run.profile['x']))"
    version, points = call(sys.executable, "-B", "-c", program, cwd=tmp_path, env=environment).split()
    assert version in call(prefix / "bin/plumbline", "--version") and int(points) > 20


def test_plugin_runs_by_its_name_and_gives_the_same_bits(installed, plugin):
    result = installed("run", "sod", "--cells", 50, "--plugin", plugin, "--integrator", "mine", json=True)
    assert result.code == 0, result.err
    mine = result.json()
    own = installed("run", "sod", "--cells", 50, "--integrator", "usavg", json=True).json()
    assert mine["settings"]["integrator"] == "mine"
    assert mine["measures"] == own["measures"] and mine["ledger"] == own["ledger"] and mine["steps"] == own["steps"]


def test_plugin_appears_in_list(installed, plugin):
    assert "mine" in [entry["name"] for entry in installed("list", "--plugin", plugin, json=True).json()["integrators"]]
    assert "mine" not in [entry["name"] for entry in installed("list", json=True).json()["integrators"]]


def test_plugin_converges(installed, plugin):
    study = installed("converge", "sod", "--cells", "20,40,80", "--plugin", plugin, "--integrator", "mine", json=True).json()["studies"][0]
    assert all(level["finished"] for level in study["levels"])


def test_plugin_is_verified_by_its_name(installed, plugin):
    verdicts = installed("verify", "spring-mass", "--tier", "quick", "--plugin", plugin, json=True, timeout=900).json()
    gates = [gate for gate in verdicts["gates"] if re.search(r"\bmine\b", gate["scheme"] + " " + gate["id"])]
    assert gates and {gate["verdict"] for gate in gates} == {"PASS"}
    assert verdicts["executed"] == verdicts["declared"]


def test_the_workflow_of_a_plugin_judges_it(prefix, tmp_path):
    """Its own lines, after the checkouts and the build, with the core set of gates."""
    workflow = yaml.safe_load((PLUGIN / "judge.yml").read_text(encoding="utf-8"))
    (tmp_path / "installed").symlink_to(prefix)
    shutil.copytree(PLUGIN, tmp_path / "plugin")
    source = (ROOT / "kernel/integrators/usavg.cpp").read_text(encoding="utf-8")
    (tmp_path / "plugin/mine.cpp").write_text(source.replace('"usavg"', '"mine"'), encoding="utf-8")
    tools = os.pathsep.join([str(Path(sys.executable).parent), str(Path(os.environ["CMAKE"]).parent), os.environ["PATH"]])
    steps = [step["run"] for step in workflow["jobs"]["judge"]["steps"] if "run" in step and "working-directory" not in step]
    for step in steps:
        call("bash", "-e", "-c", step.replace("verify ", "verify --core "), cwd=tmp_path, env={**os.environ, **workflow["env"], "PATH": tools})
    assert [card["integrator"] for card in json.loads((tmp_path / "judged/verify.json").read_text())["scorecards"]] == ["mine"]
    page = (tmp_path / "judged/card.html").read_text(encoding="utf-8")
    assert "mine: consistent, of order 2" in page and "<h1>" in page


def test_another_part_appears_in_list(installed, example):
    name, library = example
    kind, _, choice = EXAMPLES[name]
    wanted = choice.partition("=")[2]
    assert wanted in [entry["name"] for entry in installed("list", "--plugin", library, json=True).json()[kind]]
    assert wanted not in [entry["name"] for entry in installed("list", json=True).json()[kind]]


def test_another_part_runs_by_its_name(installed, example):
    """To the end, its ledger closed, as another run than without it."""
    name, library = example
    _, case, choice = EXAMPLES[name]
    size = ("--cells", 8) if case == "two-disks" else ("--cells", 4)
    result = installed("run", case, *size, "--plugin", library, "--set", choice, json=True)
    assert result.code == 0, result.text
    own = installed("run", case, *size, json=True).json()
    mine = result.json()
    key, _, wanted = choice.partition("=")
    assert mine["finished"] and mine["settings"][key] == wanted
    assert mine["measures"] != own["measures"]


def test_another_part_is_verified_by_its_name(installed, example):
    name, library = example
    _, case, choice = EXAMPLES[name]
    early = ("--set", "t_end=2.5") if case == "two-disks" else ()  # pressed together at 2 s, they have sprung apart by then
    verdicts = installed("verify", case, "--plugin", library, "--set", choice, *early, json=True, timeout=900).json()
    assert verdicts["executed"] + len(verdicts["not_applicable"]) == verdicts["declared"]
    conserved = [gate for gate in verdicts["gates"] if gate["id"].endswith(("/mass", "/momentum", "/ledger"))]
    assert conserved and {gate["verdict"] for gate in conserved} == {"PASS"}


def test_another_parts_name_is_unknown_without_it(installed, example):
    name, library = example
    _, case, choice = EXAMPLES[name]
    assert installed("run", case, "--set", choice).code == 2
    key, _, wanted = choice.partition("=")
    refused = installed("run", case, "--plugin", library, "--set", f"{key}={wanted[:-1]}", json=True)
    assert refused.code == 2 and wanted in refused.json("error")["error"]["nearest"]


def test_another_part_that_cannot_be_taken_in(installed, example, tmp_path):
    """Built against other headers, or of a name that is taken: nothing of it is used."""
    _, library = example
    content = library.read_bytes()
    place = content.index(b"\nheaders ", content.index(b"registers parts\n")) + len(b"\nheaders ")
    (tmp_path / "changed.so").write_bytes(content[:place] + b"x" + content[place + 1:])
    result = installed("list", "--plugin", tmp_path / "changed.so")
    assert result.code == 4 and "headers x" in result.err
    copy = shutil.copy(library, tmp_path / "copy.so")
    result = installed("list", "--plugin", library, "--plugin", copy)
    assert result.code == 4 and "copy.so" in result.err and "registered twice" in result.err


def test_without_the_plugin_its_name_is_unknown(installed):
    assert installed("run", "sod", "--integrator", "mine").code == 2
