"""The folder of pages in a real browser: search, old links, print, first paint, accessibility."""

import json
import pathlib
import re
import shutil
import subprocess
import time

import pytest

import history
import pages
import render
import synthetic_crowd
import synthetic_results
import york_figures
from plumbline import reader

SIZES = {"phone": (390, 844), "desk": (1440, 1000)}
REPORT = pathlib.Path(__file__).resolve().parents[2] / "report"
AXE = pathlib.Path(__file__).resolve().parents[2] / "build/npm/node_modules/axe-core/axe.min.js"
LOOKED_AT = ("index.html", "cases/sod.html", "scheme.html", "step.html", "integrators.html", "gates.html", "trust.html", "failures.html")
PRINTED = ("step.html", "york.html", "york-figures.html", "trust.html", "mutants.html", "cases/sod.html", f"cases/{synthetic_crowd.CASE}.html")
MOST_SHEETS = 10
WAIT = "new Promise(done => setTimeout(done, 300))"


def words(browser):
    """The text of the page, folded parts too."""
    return " ".join(browser.evaluate("document.querySelector('main').textContent").split())


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", list(SIZES))
def test_pages_are_accessible_and_fit(browser, folder, size, scheme):
    width, height = SIZES[size]
    found = {}
    for path in LOOKED_AT:
        browser.messages.clear()
        browser.open(folder / path, width, height, scheme)
        assert browser.evaluate("document.documentElement.scrollWidth") <= width, path
        assert browser.messages == [], path
        if AXE.exists():
            browser.evaluate(AXE.read_text(encoding="utf-8") + "; 0")
            report = browser.evaluate("axe.run(document, {resultTypes: ['violations']}).then(found => JSON.stringify(found.violations.map(one => [one.id, one.nodes.slice(0, 2).map(node => node.html.slice(0, 120))])))")
            if json.loads(report):
                found[path] = json.loads(report)
    assert found == {}
    if not AXE.exists():
        pytest.skip("axe-core is not installed (ci/setup --with axe): contrast and names were not checked")


def test_the_keyboard_reaches_the_search_and_its_results(browser, folder):
    browser.open(folder / "index.html", *SIZES["desk"])
    browser.press("/", 191, "/")
    assert browser.evaluate("document.activeElement.id") == "search"
    assert search(browser, "amplitude")
    browser.follow("document.querySelector('#search').dispatchEvent(new KeyboardEvent('keydown', {key: 'Enter', bubbles: true}))")
    assert "amplitude" in words(browser).lower()


def search(browser, text):
    """[(words, address)] that the search finds."""
    browser.evaluate(
        f"(() => {{ const box = document.getElementById('search'); box.focus(); box.value = {json.dumps(text)};"
        "box.dispatchEvent(new Event('input', {bubbles: true})); })()"
    )
    for _ in range(40):
        found = browser.evaluate("[...document.querySelectorAll('#found a')].map(link => [link.textContent, link.getAttribute('href')])")
        if found or "No" in browser.evaluate("document.getElementById('found-count').textContent"):
            return found
        browser.evaluate(WAIT)
    return []


@pytest.mark.parametrize("start", ["index.html", "cases/sod.html"])
@pytest.mark.parametrize("text", ["CFL", "hoop", "ring hoop"])
def test_search_finds_words_of_all_pages_offline(browser, folder, start, text):
    browser.messages.clear()
    browser.open(folder / start, *SIZES["desk"])
    found = search(browser, text)
    assert found and all((folder / start).parent.joinpath(address.split("#")[0]).resolve().exists() for _, address in found)
    browser.follow("document.querySelector('#found a').click()")
    assert all(word.lower() in browser.evaluate("document.body.textContent").lower() for word in text.split())
    assert search(browser, "nosuchword") == [] and browser.messages == []


@pytest.mark.parametrize("text", ["CFL", "hoop", "ring hoop", "density.L1"])
def test_search_over_a_single_file(browser, page, text):
    """Its words are those that stand in it: no second file is asked for."""
    browser.messages.clear()
    browser.open(page, *SIZES["desk"])
    found = search(browser, text)
    assert found and all(address.startswith("#") and browser.is_there(address[1:]) for _, address in found)
    browser.evaluate("document.querySelector('#found a').click()")
    target = found[0][1][1:]
    assert browser.evaluate("location.hash") == f"#{target}" and browser.evaluate("document.getElementById('found').hidden")
    part = browser.evaluate(f"document.getElementById({json.dumps(target)}).closest('main > *').textContent").lower()
    assert all(word.lower() in part for word in text.split())
    assert search(browser, "nosuchword") == [] and browser.messages == []


def test_quantities_of_the_history_fold_and_its_comparisons_are_chosen(browser, tmp_path):
    synthetic_results.spring_files_only(tmp_path / "results")
    for commit, order in (("aaa", 1.0), ("bbb", 1.3), ("ccc", 1.0)):
        entry = {"commit": commit, "machine": "one", "tier": "quick", "started": "2026-01-01T00:00:00Z", "verdicts": {"PASS": 1}, "limits": {}, "cost": {}}
        entry |= {"orders": {"sod · L1": [order, order - 0.01, order + 0.01]}, "constants": {"sod · L1": 2.0, "noh · L1": 1.0}}
        history.append(tmp_path / "results/history.jsonl", entry)
    assert render.main([str(tmp_path / "results"), str(tmp_path / "out")]) == 0
    browser.open(tmp_path / "out/changes.html", *SIZES["desk"])
    shown = "[...document.querySelectorAll('[data-comparison]')].filter(part => part.getClientRects().length).map(part => part.textContent)"
    (first,) = browser.evaluate(shown)
    assert "bbb" in first and "1 worse" in first
    browser.evaluate("(box => { box.value = '1'; box.dispatchEvent(new Event('change', {bubbles: true})); })(document.querySelector('[data-compare]'))")
    (second,) = browser.evaluate(shown)
    assert "aaa" in second and "0 worse" in second
    lines = "[...document.querySelectorAll('#changed polyline')].filter(line => line.closest('details').open).length"
    assert browser.evaluate(lines) == 0
    browser.evaluate("[...document.querySelectorAll('#changed summary')].find(part => part.textContent.startsWith('sod')).click()")
    assert browser.evaluate(lines) == 2


def test_an_old_address_leads_to_the_page_of_its_part(browser, folder):
    for name in ("case-sod", "gate-spring-mass-default-amplitude", "trust"):
        known = re.search(rf'id="?{name}', "".join(path.read_text(encoding="utf-8") for path in folder.rglob("*.html")))
        if not known:
            continue
        browser.open(folder / "index.html", *SIZES["desk"], hash=f"#{name}")
        for _ in range(40):
            if browser.is_there(name):
                break
            time.sleep(0.1)
        assert browser.evaluate("location.hash") == f"#{name}" and browser.evaluate(f"Boolean(document.getElementById('{name}'))")


def test_pages_are_whole_without_scripts(browser, folder):
    browser.allow_scripts(False)
    try:
        for path in ("index.html", "cases/sod.html"):
            browser.open(folder / path, *SIZES["desk"])
            assert browser.evaluate("[...document.querySelectorAll('[data-needs-script], #theme')].filter(part => part.getClientRects().length).length") == 0
            assert browser.evaluate("[...document.querySelectorAll('main svg')].filter(part => part.getBoundingClientRect().height > 4).length") >= 1
            assert browser.evaluate("document.documentElement.scrollWidth") <= SIZES["desk"][0]
    finally:
        browser.allow_scripts(True)


def test_the_index_is_painted_within_a_second(browser, folder, tmp_path):
    assert 0 < painted(browser, folder, tmp_path) < 1000


def painted(browser, report, tmp_path):
    """Milliseconds from the start of loading the index from disk to the first text or picture."""
    browser.open(report / "index.html", *SIZES["desk"])
    browser.screenshot(tmp_path / "index.png")  # a page that nobody sees is not painted
    return browser.evaluate("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0")


def test_the_report_of_the_program_is_light_and_quick(browser, tmp_path):
    """The one that ci/report left, of all cases."""
    if not (REPORT / "shared").is_dir():
        pytest.skip("there is no report of the program (ci/report)")
    sources = {str(path.relative_to(REPORT)): path.read_text(encoding="utf-8") for path in REPORT.rglob("*.html") if path.relative_to(REPORT).parts[0] != "docs"}
    assert pages.too_large(sources) == []
    assert 0 < painted(browser, REPORT, tmp_path) < 1000


def sheets(browser, path, target):
    """On how many sheets a page prints."""
    browser.open(path, *SIZES["desk"])
    target.write_bytes(browser.pdf())
    said = subprocess.run(["pdfinfo", target], capture_output=True, text=True, check=True).stdout
    return int(re.search(r"Pages:\s*(\d+)", said)[1])


@pytest.fixture(scope="module")
def crowded(tmp_path_factory):
    """Pages of results as crowded as the largest real ones, with a picture for each of York's figures that has one."""
    root = tmp_path_factory.mktemp("crowded")
    synthetic_crowd.write(root / "results")
    shown = render.report(reader.load_folder(root / "results"))
    drawn = next(figure for page in shown["pages"] for pair in page["convergence"] for figure in pair)
    shown["york"]["pictures"] = [drawn] * len(york_figures.PICTURED)
    pages.write(shown, root / "report")
    return root / "report"


@pytest.mark.skipif(not shutil.which("pdfinfo"), reason="pdfinfo is not installed (apt-get install poppler-utils)")
def test_no_page_but_the_list_of_gates_prints_on_more_than_ten_sheets(browser, crowded, tmp_path):
    found = {path: sheets(browser, crowded / path, tmp_path / "page.pdf") for path in PRINTED}
    assert {path: count for path, count in found.items() if count > MOST_SHEETS} == {}
