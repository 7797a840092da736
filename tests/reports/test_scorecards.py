"""The section "Integrators" and the page of a card: what they show of scorecards and of ci/judges, and what they do without."""

import copy
import json
import os
import pathlib
import re
import subprocess
import sys
from collections import Counter

import jsonschema
import pytest

from plumbline import reader
import scorecards
import svg
import synthetic_results
import synthetic_scorecards
from conftest import REPORTS, each_without
from html_page import Page, shown, source_of, tables_of, without_scripts
from synthetic_scorecards import EVIL, endless, green, judges, red, write_card

SCHEMA = json.loads((REPORTS.parent / "cases/harness/schema/plumbline.schema.json").read_text(encoding="utf-8"))


def loaded(tmp_path, card, name="scorecard-x.json"):
    write_card(tmp_path, name, card)
    return reader.load_scorecard(tmp_path / name)


def page_of(tmp_path, card, name="scorecard-x.json"):
    """The page of a card alone, made by the command."""
    write_card(tmp_path, name, card)
    assert scorecards.main([str(tmp_path / name), str(tmp_path / "card.html")]) == 0
    return (tmp_path / "card.html").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("cards")
    synthetic_scorecards.write(folder)
    return folder


@pytest.fixture(scope="module")
def source(folder):
    return source_of(folder)


@pytest.fixture(scope="module")
def parsed(source):
    return Page(source)


def row(page, first):
    """The cells of the one row of the section whose first cell begins so."""
    found = [cells for section, cells in page.rows if section == "integrators" and cells[0].startswith(first)]
    assert len(found) == 1, (first, found)
    return found[0]


def part(source, name):
    """The markup of one card of the page."""
    begin = source.index(f'id="scorecard-{name}"')
    after = [place for place in (source.find('<details class="more card"', begin), source.find('id="judges"', begin)) if place > 0]
    return source[begin : min(after)]


@pytest.mark.parametrize("card", [green, red, endless])
def test_cards_of_these_tests_are_as_the_program_writes_them(card):
    definition = {"$schema": SCHEMA["$schema"], "$defs": SCHEMA["$defs"], "$ref": "#/$defs/scorecard"}
    jsonschema.Draft202012Validator(definition).validate(card())


# --- the table of all ---------------------------------------------------------------------------------


def test_a_row_says_what_was_claimed_and_measured(parsed):
    cells = row(parsed, "mine mine: consistent")
    assert cells[1:] == [
        "PASS 14 gates, 0 red",
        "displacement 2.000, velocity 1.998 claimed: 2 of displacement (oscillator)",
        "2.0000/ω on the oscillator claimed: 2.0000/ω",
        "0.75129 h/c on plane (linear flip, ppc 1, place_x 0.01, place_y 0.01)",
        "bounded claimed: bounded",
        "1 [0.85, 1.21] of midpoint",
    ]


def test_a_row_of_a_wrong_one(parsed):
    cells = row(parsed, "wrong wrong: not consistent")
    assert cells[1].startswith("INVALID 14 gates, 3 red") and cells[3].startswith("no stable step on the oscillator claimed: nothing")
    assert cells[4] == "—" and cells[6] == "— ranges apart"


def test_a_row_without_limits_and_costs(parsed):
    cells = row(parsed, "endless endless:")
    assert cells[4].startswith("no limit on plane") and cells[6] == "— not timed"
    nothing = "— claimed: nothing"
    assert row(parsed, "bare bare:")[1:] == ["PASS 0 gates, 0 red", nothing, nothing, "—", nothing, "— not timed"]


def test_each_row_leads_to_its_card(parsed):
    for name in ("mine", "wrong", "endless", "bare"):
        assert f"#scorecard-{name}" in parsed.links and f"scorecard-{name}" in parsed.ids
    assert all(link[1:] in parsed.ids for link in parsed.links if link.startswith("#"))
    assert [name for name, times in Counter(parsed.ids).items() if times > 1] == []
    assert "4 integrators, 3 without a red gate" in parsed.text


def test_front_page_counts_integrators(tmp_path):
    synthetic_results.spring_files_only(tmp_path)
    synthetic_scorecards.write(tmp_path)
    found = re.search(r'<li class="v-fail"><a href="#integrators"><strong>(.*?)</strong>', source_of(tmp_path))
    assert found and found[1] == "3 of 4"
    (tmp_path / "scorecard-wrong.json").unlink()
    assert re.search(r'<li class="v-pass"><a href="#integrators"><strong>3 of 3</strong>', source_of(tmp_path))


# --- a card -------------------------------------------------------------------------------------------


def test_a_red_card_is_open_and_says_what_to_do(source):
    card = part(source, "wrong")
    assert 'id="scorecard-wrong" open' in source and 'id="scorecard-mine" open' not in source
    words = re.sub(r"\s+", " ", re.sub(r"<[^>]*>", "", card))
    assert "consistency/first: 5.2 × 10⁻⁴, expected ≤ 1 × 10⁻⁵" in words
    assert words.count("Usual causes: a force is not dt times its rate.") == 1, "two gates of one cause stand together"
    assert "(stopped at step 3). Usual causes: energy comes in at every step." in words
    assert 'href="#gate-scorecard-wrong-stability-first"' in card


def test_a_green_card_has_nothing_to_do(source):
    assert "What to do next" not in part(source, "mine") and "What to do next" in part(source, "wrong")


def test_families_stand_beside_those_of_the_other(tmp_path):
    page = Page(page_of(tmp_path, green()))
    order = next(cells for _, cells in page.rows if cells[0] == "order")
    assert order == ["order", "PASS", "2 of displacement (oscillator)", *["displacement 2.000, velocity 1.998"] * 2, "2", "—"]
    assert next(cells for _, cells in page.rows if cells[0] == "consistency")[3] == "at most 2.7 × 10⁻⁸ left for dt → 0"


def test_the_smallest_limit_stands_first_and_is_marked(tmp_path):
    page = Page(page_of(tmp_path, green()))
    rows = [cells for _, cells in page.rows if cells[-1].endswith(("h/c", "1/ω"))]
    assert [cells[0].split()[0] for cells in rows] == ["plane", "bar", "bar", "oscillator"]
    assert rows[0][0].startswith("plane smallest known linear flip") and "smallest" not in rows[1][0]
    assert rows[0][1:] == ["0.75129 h/c", "0.75129", "0.75129 h/c"] and rows[2][2] == "—"
    assert f"No limit known on coupled (cubic apic): {synthetic_scorecards.LACK['why']}." in page.text


def test_no_stable_step_and_no_limit_are_told_apart(tmp_path):
    words = Page(page_of(tmp_path, red())).text
    assert "no stable step" in words and "the smallest step multiplies by 1.0003" in words and "smallest known" not in words
    words = Page(page_of(tmp_path, endless())).text
    assert "no limit" in words and "no stable step" not in words and "No limit known on" not in words


def test_costs_are_drawn_for_both_and_said(tmp_path):
    source = page_of(tmp_path, green())
    drawing = re.search(r'<svg class="pl" id="scorecard-x-cost".*?</svg>', source, re.DOTALL)[0]
    for words in ("mms-bar: 0.5 [0.42, 0.61]", "bar-riemann: 2 [1.7, 2.4]", ">sod<", ">string-vibration<"):
        assert words in drawing, words
    assert json.loads(re.search(r"data-plot='(.*?)'", drawing)[1])["s"] == ["mine", "midpoint"]
    assert drawing.count('data-n="10 cells|20 cells|40 cells"') == 4 + 2, "sod stopped, and string-vibration was not timed for the other"
    rows = {cells[0]: cells for _, cells in Page(source).rows}
    assert rows["mms-bar"] == ["mms-bar", "density.L1", "0.5", "[0.42, 0.61]", "—"]
    assert rows["sod"][2:] == ["—", "—", "stopped: no number"] and rows["median"][2:4] == ["1", "[0.85, 1.21]"]


def test_nothing_timed_draws_nothing(tmp_path):
    source = page_of(tmp_path, endless())
    assert 'class="pl"' not in source and "Error against cost" not in source and "Measured, " not in source
    assert "Error against cost" in page_of(tmp_path, {**endless(), "factors": green()["factors"]})


def test_what_could_not_be_judged_is_said_with_the_trait(tmp_path):
    words = Page(page_of(tmp_path, green())).text
    assert "identities/airbag-200. Missing: returned-loss (the gas needs returned-loss" in words
    assert "jumps/sod/order. Missing: " in words, "one alone keeps its name"
    assert words.count("returned-loss (the gas") == 2 and "forward-steps (" in words


def test_gates_are_folded_by_family_and_identities_to_a_line(source, tmp_path):
    card = part(source, "mine")
    assert re.findall(r"<summary>(\w+): (\d+) gates?</summary>", card)[:2] == [("consistency", "2"), ("order", "2")]
    assert "identities: 4 gates" in card and "4 identities hold: finite (2), mass (2)." in card
    assert "<code>identities/noh/finite</code>, margin 0.25." in card
    page = Page(page_of(tmp_path, green()))
    gates = [cells for _, cells in page.rows if len(cells) == 6 and cells[0] == "PASS"]
    assert len(gates) == 12 and gates[0][3:5] == ["≤ 1", "0.2 [0.1, 0.3]"] and "Note: the interval is that of the extrapolation" in page.text
    assert "why order has this bound" in page.text


def test_an_identity_that_fails_is_not_folded(tmp_path):
    card = green()
    card["gates"][-1].update(verdict="FAIL", explanation="a leak", margin=-2.0)
    card["families"][-1].update(verdict="FAIL", red=[card["gates"][-1]["id"]])
    page = Page(page_of(tmp_path, card))
    assert "3 identities hold" in page.text and [cells for _, cells in page.rows if len(cells) == 6 and cells[0] == "FAIL"]


def test_texts_are_escaped(source, tmp_path):
    assert EVIL not in source and EVIL not in page_of(tmp_path, green()) and "&lt;once&gt;" in source
    evil = json.loads(json.dumps(green()).replace("mine", "<script>alert(1)</script>").replace("midpoint", "<script>"))
    page = page_of(tmp_path, evil)
    assert "<script" not in without_scripts(page)
    Page(page)


# --- the page of a card -------------------------------------------------------------------------------


def test_the_page_of_a_card_is_whole(tmp_path):
    source = page_of(tmp_path, red(), "scorecard-wrong.json")
    page = Page(source)
    assert "<title>Plumbline: scorecard of wrong</title>" in source and re.search(r"<h1>wrong: not consistent", source)
    assert [link for link in page.links if not link.startswith("#") or link[1:] not in page.ids] == []
    assert [entry for entry in page.loads if not entry[2].startswith("data:,")] == []
    assert not re.search(r"https?:|@import", without_scripts(source)) and len(source) < 3e5


def test_exit_status_of_the_command(tmp_path, capsys):
    write_card(tmp_path, "card.json", green())
    assert scorecards.main([str(tmp_path / "card.json"), str(tmp_path / "new" / "card.html")]) == 0
    assert scorecards.main([str(tmp_path / "none.json"), str(tmp_path / "card.html")]) == 4
    (tmp_path / "card.json").write_text("{", encoding="utf-8")
    assert scorecards.main([str(tmp_path / "card.json"), str(tmp_path / "card.html")]) == 4
    said = capsys.readouterr().err
    assert "none.json" in said and "card.json: not valid JSON" in said and not (tmp_path / "card.html").exists()
    with pytest.raises(SystemExit) as stop:
        scorecards.main([])
    assert stop.value.code == 2


def test_same_card_same_bytes(tmp_path):
    pages = set()
    write_card(tmp_path, "card.json", green())
    for seed in "12":
        command = [sys.executable, "-B", REPORTS / "scorecards.py", tmp_path / "card.json", tmp_path / "card.html"]
        subprocess.run(command, env={**os.environ, "PYTHONHASHSEED": seed}, check=True)
        pages.add((tmp_path / "card.html").read_bytes())
    assert len(pages) == 1


def test_a_card_of_the_program(tmp_path):
    program = os.environ.get("PLUMBLINE")
    if not program or not os.access(program, os.X_OK):
        pytest.skip("PLUMBLINE names no program")
    done = subprocess.run([program, "verify", "--integrator", "musl", "--core", "--results", tmp_path], capture_output=True, check=False)
    assert done.returncode in (0, 1), done.stderr
    card = json.loads((tmp_path / "scorecard-musl.json").read_text(encoding="utf-8"))
    page = Page(page_of(tmp_path, card, "scorecard-musl.json"))
    assert card["sentence"].replace("/omega", "/ω") in page.text
    assert {f"gate-scorecard-musl-{svg.identifier(gate['id'])}" for gate in card["gates"]} <= set(page.ids)


# --- gaps and damage ----------------------------------------------------------------------------------


@pytest.mark.parametrize("card", [green, red])
def test_null_everywhere_it_may_stand(tmp_path, card, monkeypatch):
    """Each value in turn gone: the card is shown, or called damaged; nothing else."""
    monkeypatch.setattr(scorecards, "cost_figure", lambda *_: None)  # drawing takes most of the time, see the next test
    whole = 0
    for changed in each_without(card()):
        try:
            found = loaded(tmp_path, changed)
        except reader.DamagedFile:
            continue
        whole += 1
        scorecards.page([found], {})
        scorecards.csv_tables([found])
    assert whole > 200


@pytest.mark.parametrize("part", ["case", "measure", "levels", "note", "cells", "error", "particle_steps", "wall_s"])
def test_costs_with_gaps_are_drawn(tmp_path, part):
    card = green()
    for curve in (card["cost"][0], card["against"]["cost"][0]):
        place = curve if part in curve else curve["levels"][1]
        place[part] = [None, 1e-3] if part == "wall_s" else None
    assert scorecards.cost_figure(loaded(tmp_path, card), "x").svg


@pytest.mark.parametrize("zero", ["error", "wall_s"])
def test_levels_without_a_logarithm_are_not_drawn(tmp_path, zero):
    card = green()
    card["against"] = None
    card["cost"] = card["cost"][:1]
    for level in card["cost"][0]["levels"]:
        level[zero] = [0.0] if zero == "wall_s" else 0.0
    assert scorecards.cost_figure(loaded(tmp_path, card), "x") is None


@pytest.mark.parametrize(
    "change, reason",
    [
        (lambda c: c.pop("integrator"), "integrator, sentence or verdict is missing"),
        (lambda c: c.update(sentence=3), "integrator, sentence or verdict is missing"),
        (lambda c: c.update(families={}), "scorecard.families is no list"),
        (lambda c: c["families"].append(3), "scorecard.families[7] is no object"),
        (lambda c: c["families"][0].update(red=[1]), "scorecard.families[0].red[0] should be a text"),
        (lambda c: c["limits"][1].update(limit="large"), "scorecard.limits[1].limit is no number"),
        (lambda c: c["limits"][1].update(endless=1), "scorecard.limits[1].endless should be true or false"),
        (lambda c: c.update(against=[]), "scorecard.against is no object"),
        (lambda c: c["against"].update(cost=3), "scorecard.against.cost is no list"),
        (lambda c: c["cost"][0]["levels"][0].update(wall_s=1.0), "scorecard.cost[0].levels[0].wall_s is no list"),
        (lambda c: c.update(factor=1.5), "scorecard.factor is no object"),
        (lambda c: c["gates"][0].update(expected=[0, 1]), "scorecard.gates[0].expected is no object"),
        (lambda c: c["gates"][0].update(measured=True), "scorecard.gates[0].measured is no number"),
        (lambda c: c.update(parameters={"rho_b": "x"}), "scorecard.parameters.rho_b is no number"),
    ],
)
def test_a_card_of_another_form_is_listed(tmp_path, change, reason):
    card = green()
    change(card)
    write_card(tmp_path, "scorecard-x.json", card)
    write_card(tmp_path, "scorecard-y.json", endless())
    page = shown(tmp_path)
    assert [reason in cells[2] for _, cells in page.rows if "scorecard-x.json" in cells] == [True]
    assert "#scorecard-y" in page.links and "#scorecard-x" not in page.links, "the others are shown"


def test_an_earlier_card_as_the_other(tmp_path):
    """What --against FILE sets beside is a whole card."""
    page = page_of(tmp_path, {**green(), "against": {**green(), "integrator": "earlier"}})
    assert "Measured, earlier" in page and "set beside <code>earlier</code>" in page


# --- proof that the gates judge -----------------------------------------------------------------------


def test_classes_are_counted_as_expected_of_them(parsed):
    for words in (
        "Of 4 wrong ones 1 is red by a gate beyond the identities",
        "Of 1 weakly unstable ones 1 is red by a gate of stability",
        "Of 2 right ones 1 is green, with the order and limit that are known",
        "from commit 0123456 with changes",
    ):
        assert words in parsed.text, words


def test_the_corpus_names_defect_gate_and_margin_the_unseen_first(parsed):
    found = [cells for section, cells in parsed.rows if section == "integrators" and any(word.startswith("wrong-") for word in cells[1].split())]
    assert [cells[0] for cells in found] == ["OTHER GATE", "NOT SEEN", "STOPPED", "SEEN"] and "wrong-momentum" in found[0][1]
    assert found[3] == ["SEEN", "strains short by 0.1 % <once> wrong-strain-short", "consistency/spring", "4.5 × 10⁻⁴", "≤ 1 × 10⁻⁵", "−44"]
    assert found[2][2] == "exit status 139: no output"


def test_a_right_one_that_measures_otherwise_is_said(parsed):
    found = {cells[1].split()[-1]: cells[2] for _, cells in parsed.rows if cells[0] in ("GREEN", "DIFFERS") and len(cells) == 4}
    assert found == {"right-kutta3": "order 3, 2.998", "right-ruth3": "order 3, 2.998; limit 1.7321, 1.6 (differs)"}


def test_smallest_defects_and_stages(parsed):
    assert row(parsed, "consistency/difference-bar") == ["consistency/difference-bar", "0.001", "—", "0.001"]
    assert row(parsed, "map_momentum") == ["map_momentum", "1", "0", "1", "0"]
    assert "equivalent, it is the same map again" in parsed.text and "locate_points): left out. Survived." in parsed.text


def test_judges_of_little(tmp_path):
    write_card(tmp_path, "judges.json", {"wrong": [], "systematic": None, "smallest": [], "weak": None})
    assert "Proof that these gates judge" in shown(tmp_path).text
    for changed in each_without(judges()):
        write_card(tmp_path, "judges.json", changed)
        found = reader.load_folder(tmp_path)
        if not found.damaged:
            scorecards.page([], found.judges)


def test_the_stored_document_can_be_shown(tmp_path):
    """The one that the report falls back on."""
    stored = pathlib.Path(__file__).resolve().parents[1] / "judges/last/judges.json"
    if not stored.exists():
        pytest.skip("no document has been stored yet")
    (tmp_path / "judges.json").write_bytes(stored.read_bytes())
    assert f"from commit {json.loads(stored.read_text(encoding='utf-8'))['commit'][:7]}" in shown(tmp_path).text


# --- CSV, weight --------------------------------------------------------------------------------------


def test_csv_gives_every_number_back(folder, tmp_path):
    names = ("integrators", "integrator-gates", "integrator-limits", "integrator-costs", "integrator-factors")
    tables = tables_of(folder, tmp_path, names)
    found = {name: [entry for entry in tables[name] if entry["integrator"] == "mine"] for name in names}
    card = green()
    assert [float(entry["measured"]) for entry in found["integrator-gates"]] == [gate["measured"] for gate in card["gates"]]
    assert [float(entry["limit"] or "nan") for entry in found["integrator-limits"]][:3] == [0.751288, 1.0204081, 2.0]
    assert float(found["integrator-costs"][1]["wall_median"]) == 1e-6 * 400 and len(found["integrator-costs"]) == 12
    assert [entry["factor"] for entry in found["integrator-factors"]] == ["0.5", "2.0", ""]
    assert found["integrators"][1]["claimed"] == card["families"][1]["claimed"]


def test_twelve_cards_of_the_whole_set_stay_light(tmp_path):
    """As many as there are integrators, each with 280 gates: a fifth of what the page may weigh."""
    card = green()
    for number in range(40):
        card["gates"].append(synthetic_scorecards.gate(f"consistency/difference-scene-{number}"))
    for number in range(220):
        card["gates"].append(synthetic_scorecards.gate(f"identities/case-{number // 5}/name-{number % 5}"))
    for number in range(12):
        own = copy.deepcopy(card)
        own["integrator"] = f"own-{number}"
        write_card(tmp_path, f"scorecard-own-{number}.json", own)
    alone = len(source_of(tmp_path).encode())
    for path in tmp_path.glob("scorecard-*.json"):
        path.unlink()
    assert alone - len(source_of(tmp_path).encode()) < 1e6
