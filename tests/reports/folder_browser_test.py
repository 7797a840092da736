"""The folder of pages in a real browser: search, old links, print, first paint, accessibility."""

import json
import pathlib
import re
import shutil
import subprocess
import time

import pytest

import chromium
import pages

SIZES = {"phone": (390, 844), "desk": (1440, 1000)}
REPORT = pathlib.Path(__file__).resolve().parents[2] / "report"
AXE = pathlib.Path(__file__).resolve().parents[2] / "build/npm/node_modules/axe-core/axe.min.js"
LOOKED_AT = ("index.html", "cases/sod.html", "scheme.html", "step.html", "integrators.html", "gates.html", "trust.html", "failures.html")
MOST_SHEETS = 10
WAIT = "new Promise(done => setTimeout(done, 300))"


@pytest.fixture(scope="module")
def browser():
    if not chromium.executable():
        pytest.skip("no Chromium is installed (apt-get install chromium): the pages were not looked at in a browser")
    with chromium.Chromium() as opened:
        yield opened


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


def test_no_page_but_the_list_of_gates_prints_on_more_than_ten_sheets(browser, folder, tmp_path):
    if not shutil.which("pdfinfo"):
        pytest.skip("pdfinfo is not installed (apt-get install poppler-utils)")
    for path in LOOKED_AT:
        if path == "gates.html":
            continue
        browser.open(folder / path, *SIZES["desk"])
        target = tmp_path / "page.pdf"
        target.write_bytes(browser.pdf())
        said = subprocess.run(["pdfinfo", target], capture_output=True, text=True, check=True).stdout
        assert int(re.search(r"Pages:\s*(\d+)", said)[1]) <= MOST_SHEETS, path
