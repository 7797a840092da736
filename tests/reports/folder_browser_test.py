"""The folder of pages in a real browser: search, old links, print, first paint, accessibility, and ten questions of readers."""

import json
import pathlib
import re
import shutil
import subprocess
import time

import pytest

import chromium
import history
import pages
import render
import synthetic_crowd
import synthetic_results
import york_figures
from plumbline import reader

SIZES = {"phone": (390, 844), "desk": (1440, 1000)}
AXE = pathlib.Path(__file__).resolve().parents[2] / "build/npm/node_modules/axe-core/axe.min.js"
LOOKED_AT = ("index.html", "cases/sod.html", "scheme.html", "step.html", "integrators.html", "gates.html", "trust.html", "failures.html")
PRINTED = ("step.html", "york.html", "york-figures.html", "trust.html", "mutants.html", "cases/sod.html", f"cases/{synthetic_crowd.CASE}.html")
MOST_SHEETS = 10
WAIT = "new Promise(done => setTimeout(done, 300))"


@pytest.fixture(scope="module")
def browser():
    if not chromium.executable():
        pytest.skip("no Chromium is installed (apt-get install chromium): the pages were not looked at in a browser")
    with chromium.Chromium() as opened:
        yield opened


def follow(browser, text, within="main, nav"):
    """Clicks the link with these words, as a reader would."""
    places = " , ".join(f"{part.strip()} a" for part in within.split(","))
    link = (
        f"[...document.querySelectorAll({json.dumps(places)})].find(link => link.getClientRects().length && "
        f"link.textContent.trim().startsWith({json.dumps(text)}))"
    )
    assert browser.evaluate(f"Boolean({link})"), f"no link {text!r} on {browser.evaluate('location.pathname')}"
    browser.follow(f"{link}.click()")


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
    browser.open(folder / "index.html", *SIZES["desk"])
    browser.screenshot(tmp_path / "index.png")  # a page that nobody sees is not painted
    painted = browser.evaluate("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? 0")
    assert 0 < painted < 1000


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


# --- ten questions of readers, each answered in at most three clicks from the index ----------------------


@pytest.fixture
def index(browser, folder):
    browser.open(folder / "index.html", *SIZES["desk"])
    return browser


def test_is_my_integrator_as_good_as_the_default(index, results):
    follow(index, "Judge an integrator")
    card = json.loads((results[0] / "scorecard-mine.json").read_text(encoding="utf-8")) if (results[0] / "scorecard-mine.json").exists() else None
    if card is None:
        pytest.skip("no scorecard in these results")
    name = card["integrator"]["name"] if isinstance(card.get("integrator"), dict) else card["integrator"]
    follow(index, name, "main table")
    assert name in words(index) and f"{sum(row['gates'] or 0 for row in card['families'])} gates" in words(index)


def test_which_scheme_to_choose(index, results):
    follow(index, "Choose a scheme")
    assert "Error against cost" in words(index)
    if (results[0] / "cost.json").exists():
        assert "Which scheme" in words(index)


def test_which_step_is_the_largest_stable_one(index, results):
    """Also: both limits of one integrator stand beside each other."""
    follow(index, "Choose a step")
    document = results[0] / "stability.json"
    if document.exists():
        assert all(problem["problem"] in words(index) for problem in json.loads(document.read_text(encoding="utf-8"))["problems"])


def test_what_changed(index):
    """The page is there; its history is told where the report was given one."""
    follow(index, "What changed")
    assert "What changed" in words(index)


def test_how_york_did_on_sod(index):
    follow(index, synthetic_results.sod_catalog()["title"])
    legend = index.evaluate("[...document.querySelectorAll('.results .key li')].map(entry => entry.textContent.trim())")
    assert any("York" in name for name in legend) and "exact" in legend
    titles = index.evaluate("[...document.querySelectorAll('.results .plot-title')].map(title => title.textContent.toLowerCase())")
    fields = [name for name in synthetic_results.sod_profile(100, 2.0) if name.endswith("_reference")]
    assert len(titles) >= len(fields) and any("density" in title for title in titles)


def test_reproduce_this_number(index):
    follow(index, synthetic_results.sod_catalog()["title"])
    assert synthetic_results.sod_catalog()["regenerate"] in words(index).replace("\xa0", " ")


def test_what_failed_by_default(index):
    follow(index, "Expected failures", "nav")
    failing = [entry for entry in synthetic_results.all_gates() if entry["verdict"] == "XFAIL"]
    assert failing and all(entry["id"] in words(index) and entry["cause"] in words(index) for entry in failing)


def test_gates_without_the_identities(index):
    follow(index, synthetic_results.sod_catalog()["title"])
    judged = [entry for entry in synthetic_results.all_gates() if entry["case"] == "sod" and entry["verdict"] == "FAIL"]
    assert all(f"{entry['measured']:.3g}" in words(index) for entry in judged)


def test_where_the_numbers_come_from(index):
    stated = synthetic_results.PROVENANCE
    assert stated["git"][:7] in words(index) and stated["started"][:10] in words(index) and stated["cpu"] in words(index)


def test_what_is_wrong_first(index):
    missed = sum(entry["verdict"] in ("FAIL", "XPASS", "INCONCLUSIVE", "INVALID") for entry in synthetic_results.all_gates())
    judged = sum(entry["verdict"] != "NONE" for entry in synthetic_results.all_gates())
    assert f"{judged - missed} of {judged} gates" in index.evaluate("document.querySelector('h1').textContent")
    follow(index, "All gates", "nav")
    assert all(entry["id"] in words(index) for entry in synthetic_results.all_gates())
