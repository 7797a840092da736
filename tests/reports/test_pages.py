"""The folder of pages: every link leads somewhere, sizes hold, every case has a page, and all words can be searched."""

import json
import re
from collections import Counter
from urllib.parse import unquote

import pytest

import pages
import render
import search_index
import synthetic_results
from html_page import figures_of, without_command
from plumbline import reader


def sources(folder):
    return {str(path.relative_to(folder)): path.read_text(encoding="utf-8") for path in sorted(folder.rglob("*.html"))}


@pytest.fixture(scope="module")
def written(folder):
    return sources(folder)


def identifiers(source):
    return re.findall(r'<[^<>]*?\sid="?([^"\s>]+)', source)


def test_every_link_and_every_shared_file_is_there(folder, written):
    broken = []
    for path, source in written.items():
        twice = [name for name, times in Counter(identifiers(source)).items() if times > 1]
        assert not twice, path
        for address in re.findall(r'(?:href|src)="?([^"\s>]+)', source):
            if address.startswith("data:"):
                continue
            file, _, name = unquote(address).partition("#")
            target = (folder / path).parent / file if file else folder / path
            known = target.exists() and (not name or name in identifiers(target.read_text(encoding="utf-8")) or name.startswith("k-"))
            if not known:
                broken.append((path, address))
    assert broken == []


def test_every_case_and_section_has_a_page(written):
    names = {entry["case"] for entry in synthetic_results.all_gates()}
    assert {f"cases/{name}.html" for name in names} <= set(written)
    assert {path for path, *_ in pages.DOORS} <= set(written)
    assert all(source.count("<h1") == 1 for source in written.values())


def test_the_index_says_verdict_commit_date_and_machine_first(written):
    first = written["index.html"].partition('id="overview"')[0]
    stated = synthetic_results.PROVENANCE
    for words in ("gates meet expectation", stated["git"][:7], stated["started"][:10], stated["cpu"], "Duration"):
        assert words in first, words
    assert [title for _, title, *_ in pages.DOORS] == re.findall(r"<strong>([^<]*)</strong> <span>", first)


def test_pages_weigh_no_more_than_they_may(written):
    assert pages.too_large(written) == []
    assert pages.too_large({"index.html": "x" * 200_001, "a.html": "x" * 1_500_001, "shared/words.js": "x" * 9_000_000}) == [
        ("index.html", 200_001, 200_000), ("a.html", 1_500_001, 1_500_000)]  # fmt: skip


def test_a_large_page_is_written_and_said(tmp_path, monkeypatch, capsys):
    synthetic_results.spring_files_only(tmp_path / "results")
    monkeypatch.setattr(pages, "MOST_BYTES_OF_THE_INDEX", 100)
    assert render.main([str(tmp_path / "results"), str(tmp_path / "out")]) == 1
    said = capsys.readouterr()
    assert "index.html has" in said.err and said.out.strip() == str(tmp_path / "out/index.html")


def test_a_folder_is_not_written_over_a_page(tmp_path):
    with pytest.raises(SystemExit) as stop:
        render.main([str(tmp_path), str(tmp_path / "page.html")])
    assert stop.value.code == 2


def test_pages_of_cases_that_are_gone_are_removed(tmp_path):
    synthetic_results.spring_files_only(tmp_path / "results")
    old, other = tmp_path / "out/cases/gone.html", tmp_path / "out/docs/start.html"
    for path in (old, other):
        path.parent.mkdir(parents=True)
        path.write_text("earlier")
    assert render.main([str(tmp_path / "results"), str(tmp_path / "out")]) == 0
    assert not old.exists() and other.exists() and (tmp_path / "out/cases/spring-mass.html").exists()


def test_the_contents_name_the_documents_where_they_are(tmp_path):
    """They are made by a command of their own, before the pages."""
    synthetic_results.spring_files_only(tmp_path / "results")
    for is_there in (False, True):
        if is_there:
            (tmp_path / "out/docs").mkdir()
            (tmp_path / "out/docs/index.html").write_text("made")
        assert render.main([str(tmp_path / "results"), str(tmp_path / "out")]) == 0
        for name, link in (("index.html", "docs/index.html"), ("cases/spring-mass.html", "../docs/index.html")):
            assert (f'href="{link}"' in (tmp_path / "out" / name).read_text(encoding="utf-8")) == is_there


def test_the_result_comes_first_on_the_page_of_a_case(written):
    titles = [re.sub("<[^>]*>", "", title) for title in re.findall(r"<h2 id=.*?</h2>", written["cases/sod.html"])]
    assert [title.split(maxsplit=1)[1] for title in titles] == [
        "Result", "Error and order", "Gates", "Physics", "Reference", "Set-up and refinement", "Known limits", "Reproduce"]  # fmt: skip


# --- words ------------------------------------------------------------------------------------------


def test_every_word_of_every_page_is_found_at_its_place(folder, written):
    script = (folder / "shared/words.js").read_text(encoding="utf-8")
    index = json.loads(script[script.index("(") + 1 : script.rindex(")")])
    paths = [path for path, _ in index["pages"]]
    assert sorted(paths) == sorted(written)
    for word, path in (("cfl", "cases/sod.html"), ("density.l1", "cases/sod.html"), ("sand97", "cases/sod.html")):
        place, found = 0, set()
        for step in index["words"][word].split():
            place += int(step, 36)
            found.add(paths[index["places"][place][0]])
        assert path in found, word
    for page, name, _ in index["places"]:
        assert not name or name in identifiers(written[paths[page]])


def test_places_are_headings_gates_and_figures():
    source = (
        '<main><h2 id="a">First part</h2><p>Hoop stress, <b>Crème</b> 12.5</p><table><tr id="gate-x"><th>period</th><td>1e-3</td></tr></table>'
        '<figure class="plot"><div class="plot-title">Density</div><svg class="pl" id="f" aria-label="density of york"><text>axis</text></svg></figure></main>'
    )
    places = {place.name: place for place in search_index.places_of(source, 0)}
    assert places["a"].title == "First part" and {"hoop", "stress", "creme"} <= places["a"].words and "12.5" not in places["a"].words
    assert places["gate-x"].title == "period" and "period" in places["gate-x"].words
    assert places["f"].title == "Density" and "york" in places["f"].words and "axis" not in places["f"].words


# --- commands ---------------------------------------------------------------------------------------


def test_every_figure_has_the_command_that_makes_it(written, page):
    single = page.read_text(encoding="utf-8")
    assert without_command({**written, "single file": single}) == []
    assert {kind for _, kind, *_ in figures_of({**written, "single file": single})} == {"plot", "plot points", "plot film", "sketch"}
    drawn = {path.partition("/")[0] for path, *_ in figures_of(written)}
    assert drawn >= {"cases", "integrators", "speed.html", "step.html", "trust.html"}


def small_report(tmp_path, change):
    """{path: text} of the pages of a small folder, each of whose run objects, levels of studies among them, was changed first."""
    synthetic_results.spring_files_only(tmp_path)
    folder = reader.load_folder(tmp_path)
    for result in folder.runs + folder.studies:
        for part in (result.run, result.study, *result.study.get("levels", ())):
            if part:
                change(part, result)
    return {path: text for path, text in pages.folder(render.report(folder)).items() if path == "cases/spring-mass.html"}


def test_a_figure_of_files_that_do_not_say_how_they_were_made_says_so(tmp_path):
    """As files of earlier versions, which do not state the choices of a run."""
    written = small_report(tmp_path, lambda part, _: part.pop("choices", None))
    without = without_command(written)
    said = [figure for *_, figure in figures_of(written) if "No command makes this again: the file" in figure]
    assert len(without) == len(said) > 1


def test_what_another_program_computed_has_the_command_that_scored_it(tmp_path):
    command = "plumbline score spring-mass --result other-20.h5"

    def hand_in(part, result):
        part["scheme"] = "foreign:other"
        result.provenance["command"] = command

    written = small_report(tmp_path, hand_in)
    figures = [figure for _, kind, _, figure in figures_of(written) if kind == "plot"]
    assert len(figures) > 1 and all(f"Reproduce: <code>{command}</code>" in figure for figure in figures)
    assert "--scheme foreign" not in "".join(written.values())
