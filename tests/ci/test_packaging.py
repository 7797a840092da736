"""The files of ci/packaging and of the services beside it: their syntax, and that they name what ci/packages, the report and the tree hold."""
import ast
import json
import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "ci/packaging"
# Names of Debian's packages in Spack and in conda-forge.
ELSEWHERE = {
    "cmake": ("cmake", "cmake"), "ninja-build": ("ninja", "ninja"), "libeigen3-dev": ("eigen", "eigen"), "libgsl-dev": ("gsl", "gsl"),
    "libhdf5-dev": ("hdf5", "hdf5"), "nlohmann-json3-dev": ("nlohmann-json", "nlohmann_json"), "libcli11-dev": ("cli11", "cli11"),
    "libfmt-dev": ("fmt", "fmt"), "libboost-dev": ("boost", "libboost-headers"), "python3": ("python", "python"),
    "python3-numpy": ("py-numpy", "numpy"), "python3-scipy": ("py-scipy", "scipy"), "python3-h5py": ("py-h5py", "h5py"),
    "python3-matplotlib": ("py-matplotlib", "matplotlib-base"), "python3-pil": ("py-pillow", "pillow"), "python3-jinja2": ("py-jinja2", "jinja2"),
    "python3-jsonschema": ("py-jsonschema", "jsonschema"), "python3-mpmath": ("py-mpmath", "mpmath"), "python3-pytest": ("py-pytest", "pytest"),
}  # fmt: skip
# Compilers come with every system that builds packages; the others serve the tests and the documents, or speed up repeated builds.
NOT_NEEDED = {"g++", "ccache", "git", "locales", "libgtest-dev", "libgmock-dev", "python3-yaml", "node-d3-zoom", "python3-sphinx", "python3-myst-parser",
              "nodejs", "libjs-katex"}
MODULES = {"numpy": "python3-numpy", "scipy": "python3-scipy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib", "PIL": "python3-pil",
           "jinja2": "python3-jinja2"}  # fmt: skip


def text(path):
    return path.read_text(encoding="utf-8")


def needed():
    """What a package needs to be built: the group `build` of ci/packages without what only tests take."""
    return {line.split()[1] for line in text(ROOT / "ci/packages").splitlines() if line.startswith("build ")} - NOT_NEEDED


def paragraphs(path):
    """The fields of each paragraph of a file in Debian's format."""
    return [dict(re.findall(r"^([\w-]+): *((?:.|\n(?=[ \t]))*)", part, re.MULTILINE)) for part in text(path).strip().split("\n\n")]


def names(dependencies):
    return {re.split(r"[ (]", item.strip())[0] for item in dependencies.split(",") if item.strip()}


def imported():
    """The modules that the report imports and Python does not bring."""
    found = set()
    for path in (ROOT / "reports").rglob("*.py"):
        for node in ast.walk(ast.parse(text(path))):
            modules = [alias.name for alias in node.names] if isinstance(node, ast.Import) else [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            found |= {module.partition(".")[0] for module in modules}
    return found & set(MODULES)


def test_the_spack_recipe():
    tree = ast.parse(text(PACKAGING / "spack/package.py"))
    recipe = next(node for node in tree.body if isinstance(node, ast.ClassDef))
    assert recipe.name == "Plumbline" and [base.id for base in recipe.bases] == ["CMakePackage"] and ast.get_docstring(recipe)
    calls = [node.value for node in recipe.body if isinstance(node, ast.Expr) and isinstance(node.value, ast.Call)]
    depends = {re.split(r"[@~+ ]", call.args[0].value)[0] for call in calls if call.func.id == "depends_on"}
    assert depends - {"c", "cxx"} == {ELSEWHERE[name][0] for name in needed()}
    versions = [call for call in calls if call.func.id == "version"]
    assert [call.args[0].value for call in versions] == ["@VERSION@"] and versions[0].keywords[0].arg == "sha256"
    run = {re.split(r"[@~+ ]", call.args[0].value)[0] for call in calls if call.func.id == "depends_on" and "'run'" in ast.unparse(call)}
    assert {ELSEWHERE[MODULES[module]][0] for module in imported()} <= run


def test_the_conda_recipe():
    recipe = yaml.safe_load(text(PACKAGING / "conda/recipe.yaml"))
    assert recipe["schema_version"] == 1
    assert set(recipe) == {"schema_version", "context", "package", "source", "build", "requirements", "tests", "about", "extra"}
    wanted = {ELSEWHERE[name][1] for name in needed()}
    stated = {kind: {item.split()[0] for item in items} for kind, items in recipe["requirements"].items()}
    assert wanted <= stated["build"] | stated["host"]
    assert {ELSEWHERE[MODULES[module]][1] for module in imported()} | {"python"} <= stated["run"]
    assert (ROOT / recipe["about"]["license_file"]).is_file()
    for expression in re.findall(r"\$\{\{(.*?)\}\}", text(PACKAGING / "conda/recipe.yaml")):
        assert re.fullmatch(r" (version|compiler\('cx?x?'\)|stdlib\('c'\)) ", expression)
    header = next(test for test in recipe["tests"] if "package_contents" in test)["package_contents"]["include"][0]
    assert (ROOT / header.removeprefix("plumbline/")).is_file()


def test_options_that_recipes_give_exist():
    options = "".join(text(path) for path in (ROOT / "ci/cmake").glob("*.cmake")) + text(ROOT / "reports/CMakeLists.txt")
    for recipe in ("spack/package.py", "conda/recipe.yaml", "debian/rules"):
        for option in re.findall(r"(?:-D|define\(\")(PLUMBLINE_\w+)", text(PACKAGING / recipe)):
            assert option in options, f"{recipe}: no option {option}"


def test_debian_control():
    source, binary = paragraphs(PACKAGING / "debian/control")
    build = names(source["Build-Depends"])
    assert build - {"debhelper-compat", "dh-python", "help2man"} == needed()
    assert {MODULES[module] for module in imported()} <= names(binary["Depends"])
    assert len(binary["Description"].splitlines()[0]) <= 80 and all(line.startswith(" ") for line in binary["Description"].splitlines()[1:])
    assert [part["Files"] for part in paragraphs(PACKAGING / "debian/copyright") if "Files" in part] == ["*"]
    assert text(PACKAGING / "debian/source/format") == "3.0 (quilt)\n"


def test_what_lintian_may_say_has_a_reason():
    lines = text(PACKAGING / "debian/plumbline.lintian-overrides").splitlines()
    said = [number for number, line in enumerate(lines) if not line.startswith("#")]
    assert lines[0].startswith("# ") and lines[-1].startswith("plumbline: ") and all(lines[number].startswith("plumbline: ") for number in said)


def test_scripts_of_the_debian_package():
    tests = [name for part in paragraphs(PACKAGING / "debian/tests/control") for name in part["Tests"].split()]
    assert sorted(tests) == sorted(path.name for path in (PACKAGING / "debian/tests").iterdir() if path.name != "control")
    for path in [PACKAGING / "debian/rules", PACKAGING / "build_deb", *(PACKAGING / "debian/tests" / name for name in tests)]:
        assert os.access(path, os.X_OK), f"{path.name} cannot be run"
    for name in tests:
        subprocess.run(["sh", "-n", PACKAGING / "debian/tests" / name], check=True)
    targets = re.findall(r"^(\S+):", text(PACKAGING / "debian/rules"), re.MULTILINE)
    assert "%" in targets and all(re.fullmatch(r"%|(override|execute_(before|after))_dh_\w+", target) for target in targets)


def test_build_deb_puts_debian_at_the_root_of_an_exported_copy(tmp_path):
    """With a dpkg-buildpackage that only looks around."""
    root = tmp_path / "tree"
    for name in ("ci/release", "ci/common.sh", "ci/cmake/archived_commit.txt", ".gitattributes"):
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, root / name)
    shutil.copytree(PACKAGING, root / "ci/packaging")
    (root / "CMakeLists.txt").write_text("project(Plumbline VERSION 1.2.0)\n", encoding="utf-8")
    identity = {"GIT_AUTHOR_NAME": "A", "GIT_AUTHOR_EMAIL": "a@example.org", "GIT_COMMITTER_NAME": "A", "GIT_COMMITTER_EMAIL": "a@example.org",
                "GIT_AUTHOR_DATE": "2026-01-31T12:00:00Z", "GIT_COMMITTER_DATE": "2026-01-31T12:00:00Z"}  # fmt: skip
    fake = tmp_path / "bin/dpkg-buildpackage"
    fake.parent.mkdir()
    fake.write_text('#!/bin/sh\necho "called with $*"\nls debian\ncat debian/changelog\n', encoding="utf-8")
    fake.chmod(0o755)
    environment = {**os.environ, **identity, "PATH": f"{fake.parent}:{os.environ['PATH']}"}
    for command in (["init", "-q"], ["add", "-A"], ["commit", "-q", "-m", "All"]):
        subprocess.run(["git", "-C", root, *command], check=True, env=environment)
    commit = subprocess.run(["git", "-C", root, "rev-parse", "HEAD"], check=True, capture_output=True, text=True).stdout.strip()

    def build():
        result = subprocess.run([root / "ci/packaging/build_deb", "-b"], capture_output=True, text=True, env=environment)
        assert result.returncode == 0, result.stderr
        return result.stdout

    between = build()
    assert "called with -us -uc -b" in between and "rules" in between.split()
    version = f"1.2.0+git202601311200.{commit[:7]}"
    assert f"plumbline ({version}-1) unstable" in between and f"Commit {commit}" in between
    lines = between.partition("plumbline (")[2].partition("\n -- ")[0].splitlines()
    assert len(lines) > 3 and max(map(len, lines)) <= 80, "the longest line that lintian lets pass"
    assert (root / f"build/deb/plumbline_{version}.orig.tar.gz").is_file()
    subprocess.run(["git", "-C", root, "-c", "tag.gpgsign=false", "tag", "v1.2.0"], check=True)
    assert "plumbline (1.2.0-1) unstable" in build()


def test_the_containerfile_runs_the_two_commands():
    lines = [line for line in text(PACKAGING / "Containerfile").splitlines() if line and not line.startswith("#")]
    steps = [line.partition(" ")[::2] for line in lines]
    assert {step for step, _ in steps} <= {"ARG", "FROM", "WORKDIR", "COPY", "RUN", "CMD"}
    assert steps[0] == ("ARG", "SYSTEM=debian:12") and steps[1] == ("FROM", "${SYSTEM}")
    assert json.loads(dict(steps)["CMD"]) == ["ci/report"]
    for copied in (rest.split()[:-1] for step, rest in steps if step == "COPY"):
        assert all((ROOT / name).exists() for name in copied)
    for command in re.findall(r"ci/[\w./]*\w", text(PACKAGING / "Containerfile")):
        assert (ROOT / command).exists(), command
    readme = text(ROOT / "README.md")
    assert "ci/report" in readme and "ci/test" in readme and "ci/test" in text(PACKAGING / "Containerfile")


def bibliography():
    """{key: {field: value}} of paper.bib."""
    entries = re.findall(r"^@(\w+)\{(\w+),\n(.*?)^\}", text(PACKAGING / "paper/paper.bib"), re.MULTILINE | re.DOTALL)
    return {key: {"kind": kind, **dict(re.findall(r"^ *(\w+) *= *\{(.*)\},?$", fields, re.MULTILINE))} for kind, key, fields in entries}


def test_the_paper_is_in_the_journals_format():
    _, header, body = text(PACKAGING / "paper/paper.md").split("---\n", 2)
    front = yaml.safe_load(header)
    assert set(front) == {"title", "tags", "authors", "affiliations", "date", "bibliography"}
    assert {str(author["affiliation"]) for author in front["authors"]} == {str(place["index"]) for place in front["affiliations"]}
    assert (PACKAGING / "paper" / front["bibliography"]).is_file()
    headings = re.findall(r"^# (.*)$", body, re.MULTILINE)
    assert headings[:4] == ["Summary", "Statement of need", "State of the field", "Software design"] and headings[-1] == "References"
    assert 750 <= len(body.split()) <= 1750   # what the journal asks for


def test_what_the_paper_cites():
    entries = bibliography()
    assert set(re.findall(r"@(\w+)", text(PACKAGING / "paper/paper.md"))) == set(entries)
    dois = [entry["doi"] for entry in entries.values() if "doi" in entry]
    assert len(set(dois)) == len(dois) and all(re.fullmatch(r"10\.\d{4,9}/\S+", doi) for doi in dois)
    for key, entry in entries.items():
        assert {"author", "title", "year"} <= set(entry) and {"doi", "number", "url"} & set(entry), key
        assert key.rstrip("0123456789") in entry["author"].lower() + entry["title"].lower(), key


def test_numbers_of_the_paper_on_bugs_and_judges_are_those_kept():
    paper = " ".join(text(PACKAGING / "paper/paper.md").split())
    counts = json.loads(text(ROOT / "tests/mutants/last/mutants.json"))["counts"]
    by_cases = counts["by_gates_of_cases"]
    assert counts["equivalent"] == 1
    assert (f"Of {counts['all']} seeded bugs one is equivalent to the original program; gates of cases notice {by_cases}, "
            f"and named tests the other {counts['killed'] - by_cases} (`ci/mutants`)") in paper  # fmt: skip
    judges = json.loads(text(ROOT / "tests/judges/last/judges.json"))
    for kind, verdict in (("wrong", "red"), ("weak", "red"), ("right", "green")):
        assert {integrator["verdict"] for integrator in judges[kind]} == {verdict}
    status = [change["status"] for change in judges["systematic"]["changes"]]
    red, equivalent, survived = (status.count(kind) for kind in ("killed", "equivalent", "survived"))
    assert f"Of {len(judges['wrong'])} wrong and {len(judges['weak'])} weakly unstable integrators all are red, and {len(judges['right'])} right" in paper
    assert f"of {len(status)} changes made systematically" in paper
    assert f"{red} are red, {equivalent} were argued to be equivalent, and {survived} were not noticed" in paper


def test_hooks_of_pre_commit_need_no_network():
    for repository in yaml.safe_load(text(ROOT / ".pre-commit-config.yaml"))["repos"]:
        assert repository["repo"] == "local"
        for hook in repository["hooks"]:
            assert {"id", "name", "entry", "language"} <= set(hook) and hook["language"] == "system"
            program = hook["entry"].split()[0]
            assert program in ("clang-format", "ruff") or os.access(ROOT / program, os.X_OK), program


@pytest.mark.parametrize("form", sorted((ROOT / ".github/ISSUE_TEMPLATE").glob("*.yml"), key=str), ids=lambda path: path.stem)
def test_forms_of_issues(form):
    """What GitHub asks of a form: without it, none is shown."""
    content = yaml.safe_load(text(form))
    if form.stem == "config":
        assert set(content) <= {"blank_issues_enabled", "contact_links"}
        return
    assert {"name", "description", "body"} <= set(content) and all(isinstance(content[key], str) for key in ("name", "description"))
    fields = [field for field in content["body"] if field["type"] != "markdown"]
    assert fields and len({field["id"] for field in fields}) == len(fields)
    for field in content["body"]:
        assert field["type"] in {"markdown", "textarea", "input", "dropdown", "checkboxes"}
        assert field["attributes"].get("value" if field["type"] == "markdown" else "label")
        assert field["type"] != "dropdown" or field["attributes"]["options"]


def test_files_and_commands_that_documents_name_exist():
    for document in ("SECURITY.md", ".github/PULL_REQUEST_TEMPLATE.md"):
        for name in re.findall(r"`((?:ci|tests|cases|reports)/[\w./]+|[A-Z]+\.md)`", text(ROOT / document)):
            assert (ROOT / name).exists(), f"{document}: {name}"


