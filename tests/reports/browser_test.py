"""The page in a real browser: no sideways scrolling, overlap or messages; phone and desk, light and dark."""

import os
import pathlib

import pytest
from matplotlib import image

import chromium

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
  const boxes = [...drawing.querySelectorAll('text')]
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
def browser():
    if not chromium.executable():
        pytest.skip(
            "no Chromium is installed (apt-get install chromium): the page was not looked at in a browser"
        )
    with chromium.Chromium() as opened:
        yield opened


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


def test_page_prints(browser, page):
    browser.open(page, *SIZES["desk"], "light")
    assert browser.pdf().startswith(b"%PDF")
