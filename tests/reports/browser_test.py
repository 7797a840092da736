"""The page in a real browser: no sideways scrolling, overlap or messages; phone and desk, light and dark."""

import json
import os
import pathlib
import shutil
import subprocess

import pytest
from matplotlib import image

import libraries
from plumbline import reader
import render
import scorecards
import synthetic_scorecards
import scoreboard
import synthetic_board
import text
from synthetic_results import gate, write_verdicts

SIZES = {"phone": (390, 844), "desk": (1440, 1000)}
OVERLAPS = """(() => {
  const blocks = [...document.querySelectorAll(
      'main > *, section > *, article > *, .plots > *, .tiles > *, .plot > *')]
    .filter(element => element.getClientRects().length);
  const found = [];
  for (const element of blocks) {
    const next = element.nextElementSibling;
    if (!next || !next.getClientRects().length) continue;
    const a = element.getBoundingClientRect(), b = next.getBoundingClientRect();
    const name = entry => entry.id || entry.className || entry.tagName;
    if (Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 1 &&
        Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1)
      found.push(name(element) + ' and ' + name(next));
  }
  return found;
})()"""
OUTSIDE = """(() => [...document.querySelectorAll('main *')].filter(element => {
  const box = element.getBoundingClientRect();
  return box.width && !element.closest('.scroll, pre, .equations, thead') && box.right > innerWidth + 1;
}).map(element => element.tagName + ' ' + element.textContent.slice(0, 40)))()"""
CUT_LABELS = """(() => [...document.querySelectorAll('.plot > svg text')].filter(text => {
  const box = text.getBoundingClientRect(), drawing = text.closest('svg').getBoundingClientRect();
  return box.width && (box.top < drawing.top - 4 || box.bottom > drawing.bottom + 4 || box.left < drawing.left - 4);
}).map(text => text.textContent))()"""
CROWDED_LABELS = """(() => [...document.querySelectorAll('.plot > svg')].flatMap(drawing => {
  const boxes = [...drawing.querySelectorAll('text:not(:has(tspan)), tspan')]
    .map(text => [text.textContent, text.getBoundingClientRect()]).filter(([, box]) => box.width);
  return boxes.flatMap(([words, a], index) => boxes.slice(index + 1).filter(([, b]) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 4)
    .map(([other]) => words + ' | ' + other + ' in ' + drawing.getAttribute('aria-label')));
}))()"""
CROWDED_TICKS = """(() => [...document.querySelectorAll('.map-frame, .map-bar')].flatMap(frame => {
  const boxes = [...frame.querySelectorAll('span')]
    .map(label => [label.textContent, label.getBoundingClientRect()]).filter(([, box]) => box.width);
  return boxes.flatMap(([words, a], index) => boxes.slice(index + 1).filter(([, b]) =>
    Math.min(a.right, b.right) - Math.max(a.left, b.left) > 1 &&
    Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top) > 3).map(([other]) => words + ' | ' + other));
}))()"""


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    """Where screenshots go: PLUMBLINE_SCREENSHOTS, or a temporary folder."""
    folder = pathlib.Path(os.environ.get("PLUMBLINE_SCREENSHOTS") or tmp_path_factory.mktemp("pictures"))
    folder.mkdir(parents=True, exist_ok=True)
    return folder


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", list(SIZES))
def test_layout(browser, page, pictures, size, scheme):
    width, height = SIZES[size]
    browser.messages.clear()
    browser.open(page, width, height, scheme)
    assert browser.evaluate("document.documentElement.scrollWidth") <= width
    assert browser.evaluate(OVERLAPS) == []
    assert browser.evaluate(OUTSIDE) == []
    browser.evaluate("document.querySelectorAll('details').forEach(element => element.open = true)")
    assert browser.evaluate("document.documentElement.scrollWidth") <= width
    assert browser.evaluate(OVERLAPS) == []
    assert browser.evaluate(CROWDED_LABELS) == []
    assert browser.evaluate(CUT_LABELS) == []
    assert browser.messages == []
    target = pictures / f"report-{size}-{scheme}.png"
    browser.evaluate("scrollTo({top: 0, behavior: 'instant'})")
    browser.screenshot(target)
    pixels = image.imread(target)[:, :, :3]
    assert pixels.shape[:2] == (height, width)
    brightness = pixels.mean()
    assert brightness > 0.8 if scheme == "light" else brightness < 0.25
    assert pixels.std() > 0.05, "the page is empty"


def test_ink_of_the_figures_follows_the_scheme(browser, page):
    found = {}
    for scheme in ("light", "dark"):
        browser.open(page, *SIZES["desk"], scheme)
        found[scheme] = browser.evaluate("getComputedStyle(document.querySelector('.plot > svg text')).fill")
    assert found == {"light": "rgb(26, 30, 35)", "dark": "rgb(229, 232, 235)"}


def test_levels_can_be_hidden(browser, page):
    browser.open(page, *SIZES["desk"], "light")
    shown = (
        "[...document.querySelectorAll('.level-coarsest')]"
        ".filter(element => getComputedStyle(element).display != 'none').length"
    )
    assert browser.evaluate(shown) > 0
    browser.evaluate("document.querySelectorAll('.pick-coarsest').forEach(box => box.click())")
    assert browser.evaluate(shown) == 0
    assert browser.evaluate(shown.replace("coarsest", "finest")) > 0


def test_a_choice_filters_the_safe_courant_numbers(browser, page):
    browser.open(page, *SIZES["desk"], "light")
    shown = (
        "[...document.querySelectorAll('.safe tbody tr')]"
        ".filter(row => getComputedStyle(row).display != 'none').map(row => row.cells[0].textContent)"
    )
    every = browser.evaluate(shown)
    boxes = "[...document.querySelectorAll('[name=only-i]')]"
    integrators = browser.evaluate(f"{boxes}.map(box => box.parentNode.textContent.trim())")
    assert integrators[0] == "all" and len(integrators) > 3
    for number, name in enumerate(integrators):
        browser.evaluate(f"{boxes}[{number}].click()")
        kept = [words for words in every if number == 0 or words.split(" · ")[0] == name]
        assert kept and browser.evaluate(shown) == kept


@pytest.mark.parametrize("size", list(SIZES))
def test_a_map_opens_to_a_figure_with_axes(browser, page, size):
    browser.open(page, *SIZES[size], "light")
    browser.evaluate("document.querySelectorAll('#stability-maps .more').forEach(group => group.open = true)")
    wide = "document.querySelector('.map svg').getBoundingClientRect().width"
    labels = (
        "[...document.querySelectorAll('.map-frame .tick, .map-frame .axis')]"
        ".filter(label => label.getBoundingClientRect().width).length"
    )
    small = browser.evaluate(wide)
    assert browser.evaluate(labels) == 0 and small < 200
    browser.evaluate("document.querySelectorAll('.map > summary').forEach(summary => summary.click())")
    assert browser.evaluate(wide) > 1.4 * small and browser.evaluate(labels) > 20
    assert browser.evaluate(CROWDED_TICKS) == []
    assert browser.evaluate(OUTSIDE) == []


def test_keyboard_reaches_what_scrolls(browser, page):
    browser.open(page, *SIZES["phone"], "light")
    stuck = (
        "[...document.querySelectorAll('.scroll, pre')]"
        ".filter(element => element.scrollWidth > element.clientWidth && element.tabIndex < 0).length"
    )
    assert browser.evaluate(stuck) == 0


# --- what the scripts add ---------------------------------------------------------------------------

FIRST_COST = """(() => {
  const drawing = document.querySelector('#case-sod svg.pl[id*="convergence"]');
  drawing.scrollIntoView({block: 'center', behavior: 'instant'});
  const marks = [...drawing.querySelectorAll('path.m[data-n]')];
  return marks.flatMap(path => path.getAttribute('d').split('M').slice(1).map((part, index) => {
    const [, x, y] = part.match(/^(-?[\\d.]+) ?(-?[\\d.]+)/);
    const place = new DOMPoint(Number(x), Number(y)).matrixTransform(drawing.getScreenCTM());
    return {series: JSON.parse(drawing.dataset.plot).s[path.dataset.s], note: path.dataset.n.split('|')[path.dataset.n.includes('|') ? index : 0], x: place.x, y: place.y};
  }));
})()"""
READOUT = "document.querySelector('.readout.on')?.innerText || ''"
WAIT = "new Promise(done => setTimeout(done, 350))"


def visible(selector):
    return f"[...document.querySelectorAll({json.dumps(selector)})].filter(element => element.getClientRects().length)"


def click(browser, x, y):
    for kind in ("mousePressed", "mouseReleased"):
        browser.mouse(kind, x, y, button="left", clickCount=1)


def value(words):
    """A number as the page writes it."""
    factor, _, power = words.replace("−", "-").partition("·10")
    digits = "".join(str("⁰¹²³⁴⁵⁶⁷⁸⁹".index(letter)) if letter in "⁰¹²³⁴⁵⁶⁷⁸⁹" else "-" for letter in power)
    return float(factor) * 10.0 ** int(digits or 0)


def test_a_point_tells_its_line_cells_and_values(browser, page, results):
    browser.messages.clear()
    browser.open(page, *SIZES["desk"])
    points = browser.evaluate(FIRST_COST)
    study = next(
        entry for entry in reader.load_folder(results[0]).studies
        if entry.study["case"] == "sod" and entry.study["scheme"] == "york1997" and entry.study["vary"] == "cells"
    )  # fmt: skip
    told = 0
    for level in study.study["levels"]:
        cells = text.count(level["settings"]["cells"])
        for point in points:
            if "York" not in point["series"] or point["note"] != f"{cells} cells":
                continue
            browser.mouse("mouseMoved", point["x"] + 2, point["y"] + 1)
            lines = browser.evaluate(READOUT).split("\n")
            assert lines[:2] == [point["series"], f"{cells} cells"]
            size, error = (value(line.split(" = ")[1]) for line in lines[2:4])
            assert size == pytest.approx(level["h"], rel=2e-3)
            assert error == pytest.approx(level["measures"]["density.L1"]["error"], rel=2e-3)
            told += 1
    assert told >= 3
    browser.mouse("mouseMoved", 2, 2)
    assert browser.evaluate(READOUT) == "" and browser.messages == []


def test_the_wheel_enlarges_a_chosen_figure_and_escape_restores_it(browser, page):
    browser.messages.clear()
    browser.open(page, *SIZES["desk"])
    first = browser.evaluate(FIRST_COST)[0]
    drawing = "document.querySelector('#case-sod svg.pl[id*=\"convergence\"]')"
    state = f"[{drawing}.outerHTML.replace(/<circle.*?circle>| (class|style|tabindex)=\"[^\"]*\"/g, ''), scrollY]"
    browser.mouse("mouseMoved", first["x"], first["y"])
    browser.mouse("mouseWheel", first["x"], first["y"], deltaX=0, deltaY=-120)
    browser.evaluate(WAIT)
    assert browser.evaluate(f"{drawing}.classList.contains('zoomed')") is False, "the page scrolls until a figure is chosen"
    first = browser.evaluate(FIRST_COST)[0]
    before = browser.evaluate(state)
    ticks = f"[...{drawing}.querySelectorAll('text')].filter(text => text.getClientRects().length).map(text => text.textContent)"
    labels = browser.evaluate(ticks)
    browser.mouse("mouseMoved", first["x"], first["y"])
    click(browser, first["x"], first["y"])
    browser.mouse("mouseWheel", first["x"], first["y"], deltaX=0, deltaY=-500)
    browser.evaluate(WAIT)
    assert browser.evaluate(f"{drawing}.classList.contains('zoomed')") is True
    enlarged = browser.evaluate(ticks)
    assert enlarged != labels and set(labels) & set(enlarged), "other ticks, the same labels of the axes"
    assert browser.evaluate(CROWDED_LABELS) == []
    # What is under the pointer stays there, with its values.
    browser.mouse("mouseMoved", first["x"] + 1, first["y"])
    assert browser.evaluate(READOUT).startswith(first["series"])
    browser.press("Escape", 27)
    browser.evaluate(WAIT)
    browser.mouse("mouseMoved", 2, 2)
    assert browser.evaluate(state) == before and browser.messages == []


def test_the_keyboard_goes_from_point_to_point(browser, page):
    browser.open(page, *SIZES["desk"])
    browser.evaluate("document.querySelector('#case-sod svg.pl[id*=\"convergence\"]').focus()")
    said = "document.querySelector('.readout + [role=status]').textContent"
    told = []
    for key, code in (("ArrowRight", 39), ("ArrowRight", 39), ("ArrowLeft", 37), ("ArrowDown", 40)):
        browser.press(key, code)
        told.append(browser.evaluate(said))
    assert told[0] == told[2] != told[1] and told[3].split(",")[0] != told[0].split(",")[0]
    assert all("cells" in words and "cell size h = " in words for words in told)
    assert "none" not in browser.evaluate("getComputedStyle(document.activeElement).outlineStyle")


def test_values_of_a_figure_open_as_a_table(browser, page):
    browser.open(page, *SIZES["phone"])
    browser.evaluate("document.querySelector('#case-sod svg.pl[id*=\"convergence\"]').focus()")
    tools = "[...document.activeElement.closest('figure').querySelectorAll('.tools button')]"
    browser.evaluate(f"{tools}.at(-1).click()")
    rows = browser.evaluate("[...document.querySelectorAll('.values tbody tr')].map(row => [...row.cells].map(cell => cell.innerText))")
    assert len(rows) > 6 and all(len(row) == 4 and row[1].endswith("cells") and value(row[3]) > 0 for row in rows)
    assert browser.evaluate("document.documentElement.scrollWidth") <= SIZES["phone"][0]


def test_a_legend_switches_a_line_off_in_all_figures_of_its_case(browser, page):
    browser.open(page, *SIZES["desk"])
    drawn = (
        "[...document.querySelectorAll('#case-sod svg.pl')].flatMap(drawing => { const series = (JSON.parse(drawing.dataset.plot || '{}').s "
        "|| []).indexOf(%s); return [...drawing.querySelectorAll(`[data-s=\"${series}\"]`)]; })"
        ".filter(path => getComputedStyle(path).display !== 'none').length"
    )
    buttons = "[...document.querySelectorAll('#case-sod .key button')]"
    name = browser.evaluate(f"{buttons}.map(button => button.textContent.trim()).find(name => name.startsWith('York'))")
    before = browser.evaluate(drawn % json.dumps(name))
    assert before > 4
    press = f"{buttons}.find(button => button.textContent.trim() === {json.dumps(name)}).click()"
    browser.evaluate(press)
    assert browser.evaluate(drawn % json.dumps(name)) == 0
    off = f"{buttons}.filter(button => button.getAttribute('aria-pressed') === 'false').map(button => button.textContent.trim())"
    assert set(browser.evaluate(off)) == {name} and len(browser.evaluate(off)) > 1
    browser.evaluate(press)
    assert browser.evaluate(drawn % json.dumps(name)) == before


def type_into(browser, selector, words):
    browser.evaluate(
        f"(() => {{ const box = document.querySelector({json.dumps(selector)}); box.value = {json.dumps(words)};"
        "box.dispatchEvent(new Event('input', {bubbles: true})); })()"
    )


def test_cases_by_verdict(browser, page):
    browser.open(page, *SIZES["desk"])
    cases = visible(".catalog [data-case]") + ".map(card => card.dataset.case)"
    box = "document.querySelector('[data-choose=verdict][value=%s]')"
    browser.evaluate(box % "XPASS" + ".click()")
    assert browser.evaluate(cases) == ["case-spring-mass"]
    browser.evaluate(box % "FAIL" + ".click()")
    assert len(browser.evaluate(cases)) == 2


@pytest.fixture(scope="module")
def long_page(tmp_path_factory):
    """A case with thirty gates, some folded away: what a filter is for."""
    folder = tmp_path_factory.mktemp("long")
    gates = [
        gate(
            "sod", "default", f"number-{k}", f"quantity {k}", 0, 1, "PASS" if k != 29 else "FAIL", 0.5 if k != 29 else 2.0,
            origin="identity" if k < 12 else "theory", reason=("reason alpha", "reason beta", "reason gamma")[k % 3],
        )
        for k in range(30)
    ]  # fmt: skip
    write_verdicts(folder, gates, declared=30)
    output = tmp_path_factory.mktemp("page") / "index.html"
    assert render.main([str(folder), str(output), "--single-file"]) == 0
    return output


def test_a_table_is_filtered_by_words_and_verdict(browser, long_page):
    browser.open(long_page, *SIZES["desk"])
    shown = visible("#case-sod table.gates tbody tr:not(.why)") + ".map(row => Number(row.id.split('-').at(-1)))"
    assert sorted(browser.evaluate(shown)) == list(range(12, 30))
    type_into(browser, "#case-sod .filter input[type=search]", "BETA reason")
    assert sorted(browser.evaluate(shown)) == [k for k in range(12, 30) if k % 3 == 1]
    assert browser.evaluate(visible("#case-sod table.gates .why") + ".length") == 1
    assert "6 of 18 rows" in browser.evaluate("document.querySelector('#case-sod .filter').textContent")
    type_into(browser, "#case-sod .filter input[type=search]", "")
    browser.evaluate("document.querySelector('#case-sod .filter input[value=FAIL]').click()")
    assert browser.evaluate(shown) == [29]


# --- links ------------------------------------------------------------------------------------------


def test_every_link_leads_somewhere(browser, page):
    browser.open(page, *SIZES["desk"])
    broken = browser.evaluate(
        "[...document.querySelectorAll('a')].map(link => link.getAttribute('href'))"
        ".filter(href => !href.startsWith('#') || !document.getElementById(decodeURIComponent(href.slice(1))))"
    )
    assert broken == []
    named = browser.evaluate("[...document.querySelectorAll('.anchor')].length")
    figures_drawn = browser.evaluate("document.querySelectorAll('figure > svg.pl').length")
    assert named > figures_drawn > 20
    assert browser.evaluate("[...document.querySelectorAll('figure > svg.pl')].every(drawing => drawing.id)") is True


def test_a_link_to_something_folded_away_opens_it(browser, long_page):
    browser.open(long_page, *SIZES["phone"], hash="#gate-sod-default-number-3")
    browser.evaluate(WAIT)
    row = "document.getElementById('gate-sod-default-number-3')"
    top = browser.evaluate(f"{row}.getBoundingClientRect().top")
    assert browser.evaluate(f"{row}.closest('details').open") is True and -1 <= top < SIZES["phone"][1]
    browser.open(long_page, *SIZES["phone"])
    assert browser.evaluate(f"{row}.closest('details').open") is False
    browser.evaluate("location.hash = '#gate-sod-default-number-3'")
    browser.evaluate(WAIT)
    assert browser.evaluate(f"{row}.closest('details').open") is True


# --- dark page, print, no scripts ---------------------------------------------------------------------


def test_the_switch_to_the_dark_page_is_remembered(browser, page):
    ground = "getComputedStyle(document.documentElement).backgroundColor"
    browser.open(page, *SIZES["desk"])
    light = browser.evaluate(ground)
    browser.evaluate("document.getElementById('theme').click()")
    dark = browser.evaluate(ground)
    assert dark != light and browser.evaluate("document.getElementById('theme').textContent") == "Light"
    browser.open(page, *SIZES["desk"])
    assert browser.evaluate(ground) == dark
    browser.evaluate("document.getElementById('theme').click()")
    browser.open(page, *SIZES["desk"], "dark")
    assert browser.evaluate(ground) == light, "a choice counts for more than the preference of the system"
    browser.evaluate("localStorage.clear()")
    browser.open(page, *SIZES["desk"], "dark")
    assert browser.evaluate(ground) == dark


def test_refused_storage_breaks_nothing(browser, page):
    browser.messages.clear()
    refuse = "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('refused', 'SecurityError'); }})"
    script = browser.call("Page.addScriptToEvaluateOnNewDocument", source=refuse)["identifier"]
    try:
        browser.open(page, *SIZES["desk"])
        browser.evaluate("document.getElementById('theme').click()")
        assert browser.evaluate("document.documentElement.dataset.theme") == "dark"
        assert browser.messages == []
    finally:
        browser.call("Page.removeScriptToEvaluateOnNewDocument", identifier=script)


def test_without_scripts_all_pictures_and_tables_are_there(browser, page):
    count = (
        "(() => { document.querySelectorAll('details').forEach(element => element.open = true);"
        "return ['figure svg.pl', 'img', 'table', 'figcaption'].map(kind => [...document.querySelectorAll(kind)]"
        ".filter(element => element.getBoundingClientRect().height > 4).length); })()"
    )
    browser.open(page, *SIZES["desk"])
    whole = browser.evaluate(count)
    browser.allow_scripts(False)
    try:
        browser.open(page, *SIZES["desk"])
        assert browser.evaluate(count) == whole and whole[0] > 20
        assert browser.evaluate(visible("[data-needs-script], #theme, .tools") + ".length") == 0
        assert browser.evaluate("document.documentElement.scrollWidth") <= SIZES["desk"][0]
    finally:
        browser.allow_scripts(True)


def test_without_the_library_the_page_works_but_does_not_enlarge(browser, results, tmp_path, monkeypatch):
    monkeypatch.setattr(libraries, "ROOTS", (tmp_path,))
    monkeypatch.setattr(libraries.zoom, "__defaults__", ((tmp_path,),))
    output = tmp_path / "index.html"
    render.main([str(results[0]), str(output), "--single-file"])
    browser.messages.clear()
    browser.open(output, *SIZES["desk"])
    points = browser.evaluate(FIRST_COST)
    browser.mouse("mouseMoved", points[0]["x"] + 1, points[0]["y"])
    assert browser.evaluate(READOUT).startswith(points[0]["series"])
    assert browser.evaluate("[...document.querySelectorAll('.tools button')].map(button => button.textContent)") == ["Values"]
    assert "was not installed" in output.read_text(encoding="utf-8") and browser.messages == []


def test_page_prints(browser, long_page, page, tmp_path):
    for source, folded in ((long_page, "gate-sod-default-number-3"), (page, "")):
        browser.open(source, *SIZES["desk"], "dark")
        printed = browser.pdf()
        assert printed.startswith(b"%PDF")
        assert folded == "" or browser.evaluate(f"document.getElementById('{folded}').closest('details').open") is False, "as before"
        if not shutil.which("pdftotext"):
            continue
        target = tmp_path / "page.pdf"
        target.write_bytes(printed)
        words = subprocess.run(["pdftotext", "-layout", target, "-"], capture_output=True, text=True, check=True).stdout
        assert "Verification report" in words and "Dark" not in words
        assert ("number-3" in words) is False or source is page, "what is folded away stays so in print"


# --- for all readers ----------------------------------------------------------------------------------

CONTRAST = """(() => {
  const channel = value => { const c = value / 255; return c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4; };
  const light = ([r, g, b]) => 0.2126 * channel(r) + 0.7152 * channel(g) + 0.0722 * channel(b);
  const canvas = new OffscreenCanvas(1, 1).getContext('2d', {willReadFrequently: true});
  const read = colour => { canvas.clearRect(0, 0, 1, 1); canvas.fillStyle = colour; canvas.fillRect(0, 0, 1, 1); return [...canvas.getImageData(0, 0, 1, 1).data]; };
  const over = ([r, g, b, a], under) => [r, g, b].map((value, index) => value * a / 255 + under[index] * (1 - a / 255));
  const ground = element => {
    const own = read(getComputedStyle(element).backgroundColor);
    return own[3] === 255 || !element.parentElement ? own.slice(0, 3) : over(own, ground(element.parentElement));
  };
  const poor = new Set();
  for (const element of document.querySelectorAll('main *, nav *')) {
    if (element.closest('svg') || ![...element.childNodes].some(node => node.nodeType === 3 && node.data.trim())) continue;
    if (!element.getClientRects().length || element.matches('.anchor')) continue;
    const under = ground(element), words = over(read(getComputedStyle(element).color), under);
    const [a, b] = [light(words), light(under)].sort((one, other) => other - one);
    if ((a + 0.05) / (b + 0.05) < 4.5) poor.add(`${element.tagName}.${element.className} ${((a + 0.05) / (b + 0.05)).toFixed(2)}`);
  }
  return [...poor];
})()"""


@pytest.fixture(scope="module", params=["green", "red", "endless", "bare"])
def card(request, tmp_path_factory):
    """The page of one integrator alone."""
    folder = tmp_path_factory.mktemp(request.param)
    synthetic_scorecards.write_card(folder, "scorecard-mine.json", getattr(synthetic_scorecards, request.param)())
    assert scorecards.main([str(folder / "scorecard-mine.json"), str(folder / "card.html")]) == 0
    return folder / "card.html"


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", list(SIZES))
def test_layout_of_a_card(browser, card, size, scheme):
    browser.messages.clear()
    browser.open(card, *SIZES[size], scheme)
    for opened in (False, True):
        browser.evaluate(f"document.querySelectorAll('details').forEach(element => element.open = {json.dumps(opened)})")
        assert browser.evaluate("document.documentElement.scrollWidth") <= SIZES[size][0]
        for check in (OVERLAPS, OUTSIDE, CUT_LABELS, CROWDED_LABELS, CONTRAST):
            assert browser.evaluate(check) == []
    wide = browser.evaluate("document.querySelector('main').getBoundingClientRect().width")
    assert wide > 0.7 * SIZES[size][0], "there are no contents beside it"
    levels = browser.evaluate("[...document.querySelectorAll('main :is(h1, h2, h3, h4)')].map(heading => Number(heading.tagName[1]))")
    assert levels[0] == 1 and all(after <= before + 1 for before, after in zip(levels, levels[1:]))
    assert browser.messages == []


def test_a_link_to_a_folded_card_opens_it_and_one_to_its_gate_both(browser, page):
    opened = "[...document.querySelectorAll('details.card[open]')].map(card => card.id)"
    browser.open(page, *SIZES["desk"])
    assert browser.evaluate(opened) == ["scorecard-wrong"], "one with a red gate is open"
    browser.evaluate("document.querySelector('#integrators a[href=\"#scorecard-mine\"]').click()")
    browser.evaluate(WAIT)
    assert set(browser.evaluate(opened)) == {"scorecard-mine", "scorecard-wrong"}
    top = browser.evaluate("document.getElementById('scorecard-mine').getBoundingClientRect().top")
    assert -1 <= top < SIZES["desk"][1]
    browser.open(page, *SIZES["phone"], hash="#gate-scorecard-mine-order-first")
    browser.evaluate(WAIT)
    row = "document.getElementById('gate-scorecard-mine-order-first')"
    assert 0 < browser.evaluate(f"{row}.getBoundingClientRect().height")
    assert -1 <= browser.evaluate(f"{row}.getBoundingClientRect().top") < SIZES["phone"][1]


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_words_stand_out_from_the_page(browser, page, scheme):
    browser.open(page, *SIZES["desk"], scheme)
    browser.evaluate("document.querySelectorAll('details').forEach(element => element.open = true)")
    assert browser.evaluate(CONTRAST) == []


def test_the_page_can_be_heard(browser, page):
    browser.open(page, *SIZES["desk"])
    assert browser.evaluate("[document.querySelectorAll('main').length, document.querySelectorAll('h1').length, document.documentElement.lang]") == [1, 1, "en"]
    levels = browser.evaluate("[...document.querySelectorAll('main :is(h1, h2, h3, h4)')].map(heading => Number(heading.tagName[1]))")
    assert levels[0] == 1 and all(after <= before + 1 for before, after in zip(levels, levels[1:]))
    unnamed = {
        "figures": "[...document.querySelectorAll('svg[role=img], [role=img]')].filter(drawing => !drawing.getAttribute('aria-label')).length",
        "header cells": "[...document.querySelectorAll('th')].filter(cell => !cell.scope).length",
        "controls": "[...document.querySelectorAll('input, button')].filter(control => !control.textContent.trim() && "
        "!control.labels?.length && !control.getAttribute('aria-label')).length",
        "pictures": "[...document.querySelectorAll('img')].filter(picture => picture.getAttribute('alt') === null).length",
    }  # fmt: skip
    assert {kind: browser.evaluate(count) for kind, count in unnamed.items()} == dict.fromkeys(unnamed, 0)
    browser.press("Tab", 9)
    assert browser.evaluate("document.activeElement.className") == "skip"
    assert browser.evaluate("document.activeElement.getBoundingClientRect().left") >= 0


# --- the scoreboard -----------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def board(tmp_path_factory):
    folder = synthetic_board.write_board(tmp_path_factory.mktemp("board"))
    assert scoreboard.main([str(folder)]) == 0
    return folder / scoreboard.PAGE


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", list(SIZES))
def test_layout_of_the_scoreboard(browser, board, pictures, size, scheme):
    width, height = SIZES[size]
    browser.messages.clear()
    browser.open(board, width, height, scheme)
    browser.screenshot(pictures / f"scoreboard-{size}-{scheme}.png")
    browser.evaluate("document.querySelectorAll('details').forEach(element => element.open = true)")
    assert browser.evaluate("document.documentElement.scrollWidth") <= width
    for check in (OVERLAPS, OUTSIDE, CUT_LABELS, CROWDED_LABELS, CONTRAST):
        assert browser.evaluate(check) == []
    levels = browser.evaluate("[...document.querySelectorAll('main :is(h1, h2, h3, h4)')].map(heading => Number(heading.tagName[1]))")
    assert levels[0] == 1 and all(after <= before + 1 for before, after in zip(levels, levels[1:]))
    assert browser.evaluate("[...document.querySelectorAll('th')].filter(cell => !cell.scope).length") == 0
    assert browser.messages == []


# --- real results -------------------------------------------------------------------------------------


def test_real_results(browser, tmp_path):
    program = os.environ.get("PLUMBLINE")
    if not program or not os.access(program, os.X_OK):
        pytest.skip("PLUMBLINE names no program")
    folder, output = tmp_path / "results", tmp_path / "index.html"
    done = subprocess.run([program, "verify", "spring-mass", "--tier", "quick", "--results", folder], capture_output=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    assert render.main([str(folder), str(output), "--single-file"]) == 0
    browser.messages.clear()
    for size in SIZES.values():
        browser.open(output, *size)
        browser.evaluate("document.querySelectorAll('details').forEach(element => element.open = true)")
        assert browser.evaluate("document.documentElement.scrollWidth") <= size[0]
        for check in (OVERLAPS, OUTSIDE, CUT_LABELS, CROWDED_LABELS):
            assert browser.evaluate(check) == []
    assert browser.evaluate("document.querySelectorAll('svg.pl[tabindex]').length") > 3
    assert browser.messages == []
