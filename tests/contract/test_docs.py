"""Documents: every command that they show is run, and prints what they show; every equation has a tag that the index knows.

In a block ```console lines after `$ ` are commands, and the others what they print: each line in this order, `...` for lines that are left out and
`…` for what differs between machines. All commands exit with 0, but in a block marked `exit=N` at least one with N. A block ```LANGUAGE FILE is
written to that file. The commands of a page are run one after another in a copy of the sources, with the home folder that Start leaves.
What stands in a block ```sh takes too long, or needs what a test has not: it is run elsewhere, by the file named in ELSEWHERE.
"""

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from contract import ROOT

DOCS = ROOT / "reports/docs"
PAGES = [DOCS / "start.md", *sorted((DOCS / "how-to").glob("*.md"))]
PLUMBLINE = os.environ["PLUMBLINE"]
MOST_SECONDS = 900  # what Start promises beside the build: the commands of a page that take longer are ended, which is an error of its test
AXE = ROOT / "build/npm/node_modules/axe-core/axe.min.js"
BLOCK = re.compile(r"^```(\w*) ?([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
ELSEWHERE = {  # a command, as the documents show it: the file that runs it, and what it calls it there
    "git clone REPOSITORY plumbline": (".github/workflows/ci.yml", "actions/checkout"),
    "cd plumbline": (".github/workflows/ci.yml", "actions/checkout"),
    "ci/setup": ("tests/contract/plugin/judge.yml", "ci/setup"),
    "ci/report": (".github/workflows/ci.yml", "ci/report"),
    "ci/test": (".github/workflows/ci.yml", "ci/test"),
    "cmake --preset release": ("tests/contract/plugin/judge.yml", "cmake --preset release"),
    "cmake --build --preset release --target plumbline": ("tests/contract/plugin/judge.yml", "cmake --build --preset release --target plumbline"),
    "ci/compare main --instructions --page": (".github/workflows/compare.yml", "--instructions --page"),
    "snakemake --snakefile ci/sweep/Snakefile --profile ci/sweep/profiles/local --config plan=plan.json": ("tests/sweep/sweeps.py", '"snakemake", "--snakefile"'),
    "snakemake --snakefile ci/sweep/Snakefile --profile ci/sweep/profiles/slurm --config plan=plan.json": ("tests/sweep/sweeps.py", '"snakemake", "--snakefile"'),
}


def text_of(page):
    return page.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def sandbox(tmp_path_factory):
    """A copy of the sources beside a home folder; what is built is the build under test."""
    folder = tmp_path_factory.mktemp("docs")
    aside = shutil.ignore_patterns(".git", "build", "results", "report", "__pycache__", ".cache", "york")
    shutil.copytree(ROOT, folder / "clone", ignore=aside)
    (folder / "clone/build").mkdir()
    (folder / "clone/build/release").symlink_to(os.environ["PLUMBLINE_BUILD"])
    (folder / "home").mkdir()
    return folder


@pytest.fixture(scope="module")
def started(sandbox):
    """The home folder as Start leaves it."""
    return run(sandbox, text_of(DOCS / "start.md"))


def environment(folder):
    tools = [folder / "home/plumbline/bin", Path(sys.executable).parent, Path(os.environ["CMAKE"]).parent]
    return {
        **os.environ, "HOME": str(folder / "home"), "PATH": os.pathsep.join([*map(str, tools), os.environ["PATH"]]),
        "CMAKE_GENERATOR": os.environ["GENERATOR"], "CMAKE_BUILD_TYPE": "Release",
    }


def steps_of(text):
    """(command, lines shown, exit status of the block, number of the block), and (file, content) as they follow each other."""
    for number, (language, words, body) in enumerate(BLOCK.findall(text)):
        if language == "console":
            status = int(words.partition("exit=")[2] or 0)
            command, shown = None, []
            for line in [*body.splitlines(), "$ "]:
                if line.startswith("$ "):
                    if command:
                        yield command, shown, status, number
                    command, shown = line[2:], []
                else:
                    shown.append(line)
        elif words and "=" not in words:
            yield words, body


def run(folder, text):
    """Runs the commands of a page in one shell: a list of (command, shown, status of the block, number, printed, status)."""
    steps, script = list(steps_of(text)), []
    for number, step in enumerate(steps):
        if len(step) == 2:
            script.append(f"cat > {step[0]} <<'END OF THE FILE'\n{step[1]}END OF THE FILE")
        else:
            script.append(f"{{ {step[0]}\n}} > {folder}/printed.{number} 2>&1; echo $? > {folder}/status.{number}")
    subprocess.run(["bash", "-c", "\n".join(script)], cwd=folder / "clone", env=environment(folder), timeout=MOST_SECONDS, check=False)
    return [
        (*step, (folder / f"printed.{number}").read_text(encoding="utf-8"), int((folder / f"status.{number}").read_text()))
        for number, step in enumerate(steps)
        if len(step) == 4
    ]


def missing(shown, printed):
    """The first line shown that is not printed after those before it; None where all are."""
    lines = iter(printed.splitlines())
    for line in shown:
        if line == "...":
            continue
        wanted = re.compile(".*".join(re.escape(piece) for piece in line.split("…")))
        if not any(wanted.fullmatch(candidate) for candidate in lines):
            return line
    return None


def check(ran):
    assert ran
    for command, shown, _, _, printed, _ in ran:
        assert missing(shown, printed) is None, f"{command}\n{missing(shown, printed)}\n--- printed:\n{printed[-3000:]}"
    for block in {step[3] for step in ran}:
        statuses = [(step[0], step[5], step[2], step[4][-2000:]) for step in ran if step[3] == block]
        assert all(status in (0, expected) for _, status, expected, _ in statuses), statuses
        assert any(status == expected for _, status, expected, _ in statuses), statuses


def test_what_start_shows(started):
    check(started)


@pytest.mark.parametrize("page", [page for page in PAGES[1:] if "```console" in text_of(page)], ids=lambda page: page.stem)
def test_what_a_page_shows(page, sandbox, started):
    check(run(sandbox, text_of(page)))


def test_what_the_readme_shows(sandbox, started):
    check(run(sandbox, text_of(ROOT / "README.md")))


def documents():
    return [*sorted(DOCS.rglob("*.md")), ROOT / "README.md"]


def test_other_commands_are_run_elsewhere():
    shown = set()
    for page in documents():
        for language, words, body in BLOCK.findall(text_of(page)):
            assert language or words.startswith("{toctree}"), f"{page}: a block without a language: ```{words}\n{body}"
            if language == "sh":
                shown |= {re.sub(r"\s+#.*", "", line).strip() for line in body.splitlines()}
    assert shown == set(ELSEWHERE)
    for command, (file, called) in ELSEWHERE.items():
        assert called in text_of(ROOT / file), command


def test_commands_within_sentences_are_ones():
    """Each has the options that it is shown with."""
    said = {}
    for page in documents():
        for command in re.findall(r"`plumbline ([^`]+)`", re.sub(BLOCK, "", text_of(page))):
            name, *words = command.split()
            said.setdefault(name, set()).update(word for word in words if word.startswith("--"))
    assert {"verify", "sweep"} <= set(said)
    for name, options in said.items():
        known = subprocess.run([PLUMBLINE, name, "--help"] if not name.startswith("-") else [PLUMBLINE, "--help"], capture_output=True, text=True, check=True).stdout
        assert [option for option in options if not re.search(rf"{option}\b", known)] == [], name


def test_equations_are_those_of_the_index():
    sys.path.insert(0, str(ROOT / "ci"))
    from importlib.machinery import SourceFileLoader

    index = SourceFileLoader("check_equations", str(ROOT / "ci/check_equations")).load_module()
    computed = {tag for part in ("kernel", "reference", "cases") for tag in index.tags_of(ROOT, part)}
    in_kernel = set(index.tags_of(ROOT, "kernel"))
    theory = set()
    for page in (DOCS / "theory").glob("*.md"):
        marked = re.sub(r"\\tag\{([^}]*)\}", r"[\1]", text_of(page))
        theory |= {f"{source} {number}" for source, numbers in index.TAG.findall(marked) for number in index.members(numbers)}
    assert sorted(theory - computed) == [], "no line computes them"
    assert sorted(in_kernel - theory) == [], "theory does not show them"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    pytest.importorskip("sphinx", reason="python3-sphinx is not installed")
    folder = tmp_path_factory.mktemp("site") / "docs"
    process = subprocess.run([sys.executable, DOCS / "build.py", PLUMBLINE, folder], capture_output=True, text=True, timeout=900)
    assert process.returncode == 0, process.stderr
    return folder


def test_the_site_needs_no_network(site):
    for page in site.rglob("*.html"):
        text = text_of(page)
        assert not re.search(r"<(?:script|link|img|iframe)[^>]*(?:src|href)=[\"']?(?:https?:)?//", text), page
    assert (site / "searchindex.js").read_text().startswith("Search.setIndex(")


def test_the_site_has_its_equations_cases_and_a_way_back(site):
    step = text_of(site / "theory/step.html")
    assert step.count("<math") > 50 and "[York 3.15]" in step and "$$" not in step
    listed = json.loads(subprocess.run([PLUMBLINE, "list", "--json", "-"], capture_output=True, text=True, check=True).stdout)
    for case in listed["cases"]:
        assert (site / f"reference/cases/{case['name']}.html").is_file(), case["name"]
    assert 'href="../index.html"' in text_of(site / "index.html") and 'href="../../index.html"' in step


def test_the_reference_is_what_the_executable_says(site):
    plain = re.sub(r"<[^>]+>", "", text_of(site / "reference/commands.html"))
    for option in ("--checkpoint", "--against", "--until-red"):
        assert option in plain
    listed = json.loads(subprocess.run([PLUMBLINE, "list", "--json", "-"], capture_output=True, text=True, check=True).stdout)
    schemes = text_of(site / "reference/schemes.html")
    for kind in ("integrators", "shapes", "transfers", "materials", "contacts"):
        for entry in listed[kind]:
            assert f">{entry['name']}<" in schemes, entry["name"]


@pytest.fixture(scope="module")
def browser():
    sys.path.insert(0, str(ROOT / "tests/reports"))
    import chromium

    if not chromium.executable():
        pytest.skip("no Chromium is installed (apt-get install chromium): the documents were not looked at in a browser")
    with chromium.Chromium() as opened:
        yield opened


LOOKED_AT = ("index.html", "start.html", "theory/step.html", "reference/commands.html", "reference/keys.html")
LISTED = "[...document.querySelectorAll('.pages .list a')].filter(link => link.checkVisibility()).length"


@pytest.mark.parametrize("scripts", [True, False])
@pytest.mark.parametrize("page", LOOKED_AT)
def test_the_text_comes_first_on_a_phone_and_the_list_of_pages_unfolds(site, browser, page, scripts):
    browser.allow_scripts(scripts)
    try:
        browser.open(site / page, 390, 844)
        assert browser.evaluate("document.querySelector('#text h1').getBoundingClientRect().bottom") < 844 / 2
        assert browser.evaluate(LISTED) == 0 and browser.evaluate("document.documentElement.scrollWidth") <= 390
        x, y = browser.evaluate("(() => { const box = document.querySelector('.pages summary').getBoundingClientRect(); return [box.x + 10, box.y + box.height / 2]; })()")
        for kind in ("mousePressed", "mouseReleased"):
            browser.mouse(kind, x, y, button="left", clickCount=1)
        assert browser.evaluate(LISTED) >= 4
        browser.open(site / page, 1440, 1000)
        assert browser.evaluate(LISTED) >= 4 and browser.evaluate("document.querySelector('.pages summary').checkVisibility()") is False
        assert browser.evaluate("document.querySelectorAll('.pages .list').length") == 1
    finally:
        browser.allow_scripts(True)


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", [(390, 844), (1440, 1000)])
def test_the_documents_are_accessible(site, browser, size, scheme):
    if not AXE.exists():
        pytest.skip("axe-core is not installed (ci/setup --with axe): contrast and names were not checked")
    found = {}
    for page in LOOKED_AT:
        browser.open(site / page, *size, scheme)
        browser.evaluate(f"document.querySelectorAll('.pages details').forEach(list => list.open = true); {AXE.read_text(encoding='utf-8')}; 0")
        report = browser.evaluate("axe.run(document, {resultTypes: ['violations']}).then(found => found.violations.map(one => [one.id, one.nodes[0].html.slice(0, 120)]))")
        found |= {page: report} if report else {}
    assert found == {}
