"""The page: complete, self-contained, the same bytes for the same files, and true to what the files state."""

import json
import os
import re
import shutil
import subprocess
import sys
import types
from collections import Counter

import numpy
import pytest

from plumbline import reader
import render
import synthetic_results
from conftest import REPORTS
from html_page import Page, shown, source_of, without_scripts
from synthetic_results import fit, gate, measure, run_object, write_run, write_study, write_verdicts


@pytest.fixture(scope="module")
def source(page):
    return page.read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def parsed(source):
    return Page(source)


# --- form -----------------------------------------------------------------------------------------


def test_page_is_well_formed(source, parsed):
    assert len(source) < 5e6
    assert len(re.findall(r"<svg.*?</svg>", source, re.DOTALL)) > 30
    assert all(parsed.labels) and len(parsed.labels) > 20


def test_every_link_resolves_and_no_identifier_stands_twice(source, parsed):
    twice = [name for name, times in Counter(parsed.ids).items() if times > 1]
    assert not twice
    assert parsed.links and all(link.startswith("#") and link[1:] in parsed.ids for link in parsed.links)
    assert set(re.findall(r'(?:aria-labelledby="|url\(#)([^")]+)', without_scripts(source))) <= set(parsed.ids)


def test_nothing_is_loaded_from_elsewhere(source, parsed):
    inside = ("data:,", "data:image/webp;base64,")
    assert [entry for entry in parsed.loads if not entry[2].startswith(inside)] == []
    bare = without_scripts(source)
    assert not re.search(r"https?:|@import|@font-face|<script|<iframe|<object", bare)
    assert not re.search(r"url\((?!#|data:image/webp;base64,)", bare)


def test_figures_follow_the_colours_of_the_page(source):
    import raster
    import svg

    stand_ins = re.findall("|".join(svg._VARIABLES), source)
    assert not stand_ins and "var(--s1)" in source and "currentColor" in source
    fixed = set(re.findall(r"(?:fill|stroke): ?(#[0-9a-f]{6})", source))
    # Colours that stand for values or bodies in pictures are of middle lightness, the same in both schemes.
    scales = {colour for ramp in (raster.FIELD, raster.STRESS) for count in range(2, 16) for colour in raster.ramp(ramp, count)}
    bodies = {colour for colours in raster.BODIES.values() for colour in colours}
    assert not fixed - scales - bodies, "a drawing has a colour that does not change with the scheme"
    rules = re.findall(r"\.pl (?:text|\.y\d+)\s*\{[^}]*\}", source)
    assert ".pl text { fill: currentColor; }" in rules, "black by default"
    assert not re.search(r"(?:fill|stroke):\s*(?:black|#000)", "".join(rules))


def test_an_area_that_belongs_to_a_line_is_no_mark():
    import svg

    def paint(axes):
        axes.plot([0, 1], [0, 1], label="line")
        svg.belongs(axes.fill_between(numpy.linspace(0, 1, 200), 0, 1, color=svg.series_colour(0), alpha=0.2, linewidth=0), "line")

    paths = re.findall(r'<path class="([^"]*)"[^>]* d="([^"]*)"', svg.draw(paint, "p", "l"))
    ((classes, data),) = [(classes.split(), data) for classes, data in paths if "b" in classes.split()]
    assert "m" not in classes and len(data) < 60, "of four hundred corners four are needed"


def test_a_page_too_large_to_send_is_written_and_said(tmp_path, monkeypatch, capsys):
    synthetic_results.spring_files_only(tmp_path)
    output = tmp_path / "page.html"
    assert render.main([str(tmp_path), str(output), "--single-file"]) == 0
    monkeypatch.setattr(render, "MOST_BYTES", 1000)
    assert render.main([str(tmp_path), str(output), "--single-file"]) == 1
    assert "MB, more than 0.001" in capsys.readouterr().err and output.stat().st_size > 1000


def test_same_files_give_the_same_bytes(results, page, tmp_path):
    """Another process, place, locale, time zone and hash seed."""
    folder, _ = results
    moved = shutil.copytree(folder, tmp_path / "moved elsewhere")
    environment = {**os.environ, "PYTHONHASHSEED": "2", "TZ": "Asia/Tokyo", "LC_ALL": "C"}
    done = subprocess.run(
        [sys.executable, REPORTS / "render.py", moved, tmp_path / "page.html", "--single-file"],
        env=environment,
        check=False,
        capture_output=True,
    )
    assert done.returncode == 4, done.stderr
    shown = page.read_bytes()
    assert (tmp_path / "page.html").read_bytes() == shown
    assert str(folder).encode() not in shown


# --- truth ----------------------------------------------------------------------------------------


def test_verdicts_shown_are_those_of_the_files(parsed):
    for case in ("sod", "spring-mass"):
        expected = Counter(
            (entry["verdict"], entry["id"], entry["scheme"])
            for entry in synthetic_results.all_gates()
            if entry["case"] == case
        )
        assert Counter(parsed.gate_rows(f"case-{case}")) == expected
    missed = parsed.gate_rows("verdicts")
    assert [verdict for verdict, _, _ in missed] == ["INVALID", "FAIL", "XPASS", "INCONCLUSIVE"]
    assert [verdict for verdict, _, _ in parsed.gate_rows("expected-failures")] == ["XFAIL"]


def test_known_failures_are_listed_by_owner(tmp_path):
    """The default scheme's are a list of their own; a file that names no owner is read by its scheme."""
    failing = [
        gate("sod", scheme, name, "density.L1", None, 0.005, "XFAIL", 0.0064, cause="known", **owner)
        for scheme, name, owner in (
            ("york1997", "stated", {"failure_of": "york1997"}),
            ("default", "his-figures", {"failure_of": "york1997"}),
            ("default", "plain", {"failure_of": "default"}),
            ("default+usl", "of-an-earlier-version", {}),
        )
    ]
    write_verdicts(tmp_path, failing)
    page = shown(tmp_path)
    rows = [name for _, name, _ in page.gate_rows("expected-failures")]
    assert rows[:2] == ["plain", "of-an-earlier-version"] and sorted(rows[2:]) == ["his-figures", "stated"]
    for words in ("1 failure of the default scheme", "1 failure of other schemes", "2 failures York's own"):
        assert words in page.text
    assert "known failures, 1 of the default scheme" in page.text


def test_recorded_values_that_hold_stand_beside_their_gate(tmp_path):
    """The range of a recorded value is a line of the gate's row; one that is left is a row of its own, and comes first."""
    judged = [
        gate("sod", "default", "default/error", "density.L1", None, 0.5, "PASS", 0.01, study="default"),
        gate("sod", "default", "default/error/regression", "density.L1", 0.004, 0.03, "PASS", 0.01, study="default"),
        gate("sod", "default", "default/other", "velocity.L1", None, 0.5, "PASS", 0.1, study="default"),
        gate("sod", "default", "default/other/regression", "velocity.L1", 0.004, 0.03, "FAIL", 0.1, study="default"),
    ]
    write_verdicts(tmp_path, judged)
    page = shown(tmp_path)
    assert [(verdict, name) for verdict, name, _ in page.gate_rows("case-sod")] == [
        ("FAIL", "default/other/regression"), ("PASS", "default/error"), ("PASS", "default/other")]  # fmt: skip
    assert "recorded: 0.004 … 0.03" in page.text
    assert "4 of 4 declared gates executed" in page.text


def test_counts_and_executed_gates(source, parsed):
    tiles = dict(re.findall(r"<dt>(\w+)</dt><dd>(\d+)</dd>", source))
    assert tiles == {
        verdict: str(sum(entry["verdict"] == verdict for entry in synthetic_results.all_gates()))
        for verdict in synthetic_results.VERDICTS
    }
    assert "10 of 10 declared gates executed" in parsed.text


def test_a_verdict_is_never_decided_anew(tmp_path):
    """Verdicts and counts that contradict the numbers beside them are shown as stated."""
    gates = [
        gate("sod", "default", "absurd-pass", "density.L1", None, 0.007, "PASS", 0.9, margin=-100),
        gate("sod", "default", "absurd-fail", "density.L1", None, 0.007, "FAIL", 0.001, margin=1),
    ]
    write_verdicts(tmp_path, gates, declared=3)
    page = shown(tmp_path)
    assert Counter(page.gate_rows("case-sod")) == Counter(
        [("PASS", "absurd-pass", "default"), ("FAIL", "absurd-fail", "default")]
    )
    assert "2 of 3 declared gates executed" in page.text


def test_orders_are_those_of_the_files(results, parsed):
    import text

    folder, _ = results
    left_out = []
    for study in reader.load_folder(folder).studies:
        for name, values in study.measures.items():
            low, high = values["order_low"], values["order_high"]
            words = f"{values['order']:.3f} [{low:.3f}, {high:.3f}]".replace("-", "−")
            assert words == text.order(values)
            if words not in parsed.text:
                left_out.append(name)
    assert left_out and not {"density.L1", "period"} & set(left_out), "what is judged is there of every line"
    assert f"{text.plural(len(left_out), 'fit')} of further lines" in parsed.text


def test_what_a_reader_needs_is_there(parsed):
    for words in (
        "SAND97-1893",
        "Cause: the noise of cell crossing",
        "0123456789abcdef0123456789abcdef01234567 — with uncommitted changes",
        "g++ 12.2.0",
        "x86-64-v3 (AVX2, FMA)",
        "plumbline verify --tier quick",
        "plumbline verify sod --tier quick",
        "Eigen 3.4.0",
        "known: 0.005 … 0.0085",
        "regression: a run of Plumbline itself",
        "York’s own choices",
        "ratio of specific heats",
        "ω = √(k/m)",
        "No overshoot limiter at the contact.",
        "Error against wall time",
        "Error against particle-steps",
        "Time step alone",
        "Order and error constant, level by level",
        "Within rounding: over the scale of the run",
        "Closed to the last bit at every stored step: mass",
        "1 gate declared for this case, not judged in these files",
    ):
        assert words in parsed.text, words


# --- speed ----------------------------------------------------------------------------------------


def test_speed_is_shown_as_the_bench_states_it(parsed):
    for words in (
        "Cost of a particle-step",
        "Memory per point",
        "at least 45 million/s",
        "MISSED",
        "moves data at 61 % of the rate at which this machine copies memory, and computes at 42 % of the rate",
        "on 2 threads at 61 % and 42 %",
        "written by plumbline bench --points 1e7",
        "A step of one point takes 0.61 µs",
        "fastest and slowest typically lie 16 % apart",
    ):
        assert words in parsed.text, words


def test_every_timed_choice_has_its_row(parsed):
    timed = {
        (kernel["shape"], kernel["transfer"], kernel["dimension"], kernel["axisymmetric"])
        for kernel in synthetic_results.bench_document()["kernels"]
        if kernel["part"] == "matrix"
    }
    rows = [cells for section, cells in parsed.rows if section == "speed" and {"apic", "flip"} & set(cells)]
    assert len(rows) == len(timed)
    assert sum("46" in cells and "92" in cells for cells in rows) == 4, "a line on one thread and on two"


def test_a_bench_of_little_makes_a_page(tmp_path):
    """A bench of chosen integrators has no scale and no targets; a machine may not tell of its memory."""
    bench = synthetic_results.bench_document()
    kernels = [kernel for kernel in bench["kernels"] if kernel["part"] == "matrix" and kernel["threads"] == 1]
    for kernel in kernels:
        kernel["memory_bytes_per_point"] = None
    (tmp_path / "bench.json").write_text(json.dumps({"machine": {}, "kernels": kernels}), encoding="utf-8")
    words = shown(tmp_path).text
    assert "The default step, wherever it works" in words and "Cost of a particle-step" not in words


def test_another_method_stands_beside_the_schemes(source, parsed):
    drawn = [words for words in parsed.labels if "density.L1: error against" in words]
    assert len(drawn) == 2
    assert len(re.findall("another method on the same problem[:,] Finite volumes, MUSCL-HLLC", parsed.text)) == 2
    assert source.count("Finite volumes, MUSCL-HLLC</li>") == 2


def test_newest_of_two_verdict_files_counts(tmp_path):
    old, new = (
        gate("sod", "default", "same", "density.L1", None, 0.007, verdict, value)
        for verdict, value in (("FAIL", 0.008), ("PASS", 0.006))
    )
    for entry, started in ((new, "2026-11-21T09:00:00Z"), (old, "2026-11-20T09:00:00Z")):
        synthetic_results.PROVENANCE["started"], kept = started, synthetic_results.PROVENANCE["started"]
        write_verdicts(tmp_path, [entry])
        synthetic_results.PROVENANCE["started"] = kept
    assert shown(tmp_path).gate_rows("case-sod") == [("PASS", "same", "default")]


# --- damage and gaps ------------------------------------------------------------------------------


def test_damaged_file_is_listed_as_invalid(results, parsed):
    _, names = results
    rows = [cells for _, cells in parsed.rows if len(cells) == 3 and cells[1] == names["truncated"]]
    assert len(rows) == 1 and rows[0][0] == "INVALID" and rows[0][2].startswith("truncated")


def test_exit_status(tmp_path, capsys):
    folder = tmp_path / "results"
    synthetic_results.spring_files_only(folder)
    output = tmp_path / "page.html"
    assert render.main([str(folder), str(output), "--single-file"]) == 0
    (folder / "broken.h5").write_bytes(b"no HDF5")
    assert render.main([str(folder), str(output), "--single-file"]) == 4 and "broken.h5" in output.read_text(encoding="utf-8")
    assert "broken.h5" in capsys.readouterr().err
    assert render.main([str(tmp_path / "nowhere"), str(output), "--single-file"]) == 4
    assert render.main([str(folder), str(output / "below-a-file.html"), "--single-file"]) == 4
    with pytest.raises(SystemExit) as stop:
        render.main([])
    assert stop.value.code == 2


def test_runs_alone_make_a_page(tmp_path):
    run = run_object("sod", "york1997", 100, {"integrator": "musl"}, {"density.L1": measure(0.01)})
    write_run(tmp_path, run, synthetic_results.sod_profile(100, 2.0))
    page = shown(tmp_path)
    assert "No gate was judged in this folder" in page.text and "Density, york1997" in page.text


def test_a_stopped_run_is_named(tmp_path):
    stop = {"reason": "not finite", "step": 17, "time": 0.01, "point": 3, "field": "density", "value": None}
    run = run_object("sod", "default", 100, {}, {}, finished=False, stop=stop, verdict="INVALID")
    write_run(tmp_path, run)
    words = shown(tmp_path).text
    assert "stopped at step 17" in words and "field density, point 3" in words


def test_gaps_do_not_break_the_page(tmp_path):
    """Nulls, empty lists and missing parts, one after the other, in every place that may lack something."""
    bare = {"density.L1": measure(None, bound=None), "velocity.L1": {}}
    levels = [
        run_object("sod", "default", cells, {}, bare, value=None, points=4, steps=2) for cells in (10, 20)
    ]
    levels[0].update(h=None, wall_s=None, points=None, steps=None, measures=None, settings={}, ledger=None)
    empty_fit = {
        "order": None,
        "order_low": None,
        "order_high": None,
        "constant": None,
        "asymptotic": None,
        "pairwise": [None],
        "leave_one_out": [],
        "plateau": [None, None],
        "levels_used": [False, False],
        "reason": "two levels",
    }
    for vary in ("cells", "dt", "ppc", "offset"):
        write_study(
            tmp_path, "sod", "default", vary, levels, {"density.L1": empty_fit, "velocity.L1": {}}, {}
        )
    write_study(
        tmp_path,
        "spring-mass",
        "default",
        "cells",
        levels[1:],
        {},
        {"theory_order": {"period": {}}, "gates": [{}], "parameters": [{}]},
    )
    write_verdicts(
        tmp_path,
        [{"case": "sod"}, {}, gate("sod", None, "x", "", None, None, "NONE", None, margin=None, origin=None)],
    )
    with synthetic_results.create(tmp_path / "bare.h5", "run", {"run": {}}):
        pass
    words = shown(tmp_path).text
    assert "two levels" in words


def test_text_of_the_files_is_never_markup(tmp_path):
    evil = '<script>alert(1)</script>'
    catalog = {
        **synthetic_results.sod_catalog(),
        "claim": evil,
        "title": evil,
        "name": evil,
        "sketch": '<svg viewBox="0 0 1 1"><script>alert(1)</script></svg>',
    }
    level = run_object("sod", evil, 10, {evil: evil}, {evil: measure(0.1)}, value=1)
    errors = {evil: fit([0.1, 0.05, 0.025], [0.1, 0.05, 0.025])}
    write_study(
        tmp_path,
        "sod",
        "default",
        "cells",
        [level, {**level, "h": 0.05}, {**level, "h": 0.02}],
        errors,
        catalog,
    )
    assert "<script" not in without_scripts(source_of(tmp_path))


def test_sketches_are_checked():
    import svg

    assert "currentColor" in svg.sketch(synthetic_results.SKETCH, "x", "label")
    for bad in (
        "<svg viewBox='0 0 1 1'><image href='a.png'/></svg>",
        "<svg viewBox='0 0 1 1'><foreignObject/></svg>",
        "<svg",
        "<p/>",
        "",
    ):
        assert svg.sketch(bad, "x", "label") == ""
    cleaned = svg.sketch(
        "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 1 1' onload='a()'><path fill='url(//a)' d='M0 "
        "0'/></svg>",
        "x",
        "a<b",
    )
    assert "onload" not in cleaned and "url" not in cleaned and "http" not in cleaned and "a&lt;b" in cleaned


def test_csv_of_the_whole_folder(results, page):
    _, names = results
    tables = page.parent / "csv"
    gates = (tables / "gates.csv").read_text(encoding="utf-8").splitlines()
    assert len(gates) == 11 and gates[0].startswith("case,id,scheme")
    assert names["truncated"] in (tables / "damaged.csv").read_text(encoding="utf-8")
    assert (tables / f"{names['run'].removesuffix('.h5')}.profile.csv").exists()
    bench = (tables / "bench.csv").read_text(encoding="utf-8").splitlines()
    assert len(bench) == 1 + len(synthetic_results.bench_document()["kernels"])
    methods = (tables / f"{names['study'].removesuffix('.h5')}.comparators.csv").read_text(encoding="utf-8")
    assert methods.startswith("method,cell_steps,cells,density.L1") and methods.count("finite-volume") == 5


# --- the arithmetic of the figures ----------------------------------------------------------------


def test_band_is_that_of_linear_regression():
    """Against the textbook formula from the residuals, which the page does not have."""
    import figures
    from scipy import stats

    h = numpy.array([0.01, 0.005, 0.0025, 0.00125, 0.000625])
    error = 0.7 * h**0.9 * numpy.array([1.05, 0.97, 1.02, 0.95, 1.01])
    x, y = numpy.log(h), numpy.log(error)
    line = stats.linregress(x, y)
    t = stats.t.ppf(0.975, len(h) - 2)
    stated = {
        "order": line.slope,
        "order_low": line.slope - t * line.stderr,
        "order_high": line.slope + t * line.stderr,
        "constant": numpy.exp(line.intercept),
    }
    at = numpy.array([0.0007, 0.003, 0.009])
    s = numpy.sqrt(((y - line.intercept - line.slope * x) ** 2).sum() / (len(h) - 2))
    half = t * s * numpy.sqrt(1 / len(h) + (numpy.log(at) - x.mean()) ** 2 / ((x - x.mean()) ** 2).sum())
    low, high = figures.confidence_band(at, h, stated)
    middle = line.intercept + line.slope * numpy.log(at)
    assert numpy.allclose(numpy.log(low), middle - half, rtol=1e-12) and numpy.allclose(
        numpy.log(high), middle + half, rtol=1e-12
    )
    assert figures.confidence_band(at, h, {**stated, "order_low": None}) is None


def test_front_of_cost_and_error():
    import figures

    points = [(1, 10), (2, 11), (2, 5), (3, 5), (4, 1), (5, 2)]
    assert figures.front(points) == [(1, 10), (2, 5), (4, 1)]


def test_thinning_keeps_every_extreme():
    import profiles

    x = numpy.linspace(0, 1, 10000)
    y = numpy.sin(40 * x)
    y[1234], y[7777] = 9.0, -9.0
    thin_x, thin_y = profiles.envelope(x, y)
    assert (
        len(thin_x) <= 640 and thin_y.max() == 9.0 and thin_y.min() == -9.0 and (numpy.diff(thin_x) > 0).all()
    )
    _, largest = profiles.largest_in_bins(x, y)
    assert numpy.nanmax(largest) == 9.0 and (largest == 9.0).sum() == 2


def test_drift_is_scaled_to_the_stated_one(results):
    import profiles

    folder, names = results
    run = reader.load(folder / names["run"])
    relative = profiles.relative_residual(run, "energy")
    assert relative.max() == pytest.approx(run.run["ledger"]["energy"]["relative_drift"], rel=1e-14)
    run.run["ledger"]["energy"]["largest_residual"] = (
        -2 * numpy.abs(run.ledger["energy"]["residual"]).max()
    )  # signed, between stored rows
    assert profiles.relative_residual(run, "energy") == pytest.approx(relative / 2, rel=1e-14, abs=0)
    assert not profiles.relative_residual(run, "mass").any()
    assert profiles.relative_residual(run, "angular_momentum") is None


@pytest.mark.parametrize(
    "low, high", [(1e-18, 1e-11), (2e-4, 0.03), (0.0021, 0.0043), (3e-5, 4e-5), (0.9, 1.1), (1, 1e20)]
)
def test_logarithmic_axes_have_distinct_labels(low, high):
    import figures

    ticks = figures.log_ticks(low, high)
    labels = [figures.tick(value) for value in ticks]
    assert (
        2 <= len(ticks) <= 9
        and len(set(labels)) == len(labels)
        and all(low <= value <= high for value in ticks)
    )


@pytest.mark.parametrize(
    "value, words",
    [
        (None, "—"),
        (0, "0"),
        (0.0066, "0.0066"),
        (1.0, "1"),
        (-0.25, "−0.25"),
        (12345.678, "12346"),
        (1e-13, "1\u202f×\u202f10⁻¹³"),
        (9.9999e-4, "0.001"),
        (float("nan"), "—"),
        (0.0198592, "0.0199"),
    ],
)
def test_numbers(value, words):
    import text

    assert text.number(value) == words


def test_measured_value_is_told_from_its_bound():
    import text

    assert text.measured(0.0070000001, {"high": 0.007}) == "0.0070000001"
    assert text.measured(0.007, {"high": 0.007}) == "0.007"
    assert text.expected({"low": 0.005, "high": 0.0085}) == "0.005 … 0.0085"
    assert text.expected({"low": None, "high": 1e-12}) == "≤ 1\u202f×\u202f10⁻¹²"


def test_schemes_stand_side_by_side_for_each_kind_of_scene(tmp_path):
    write_run(tmp_path, run_object("sod", "york1997", 100, {"integrator": "musl"}, {"density.L1": measure(0.01)}))
    assert "id=schemes" not in source_of(tmp_path)
    default = {"name": "default", "title": "the best", "source": "s", "kinds": {"gas": {"shape": "cubic", "ppc": 8}, "solid": {"shape": "linear"}}}
    york = {"name": "york1997", "title": "York's", "source": "s", "kinds": {"gas": {"shape": "linear", "ppc": 8}, "solid": {"shape": None}}}
    (tmp_path / "list.json").write_text(json.dumps({"schemes": [default, york]}))
    page = source_of(tmp_path)
    assert "<td>cubic / linear<td>linear / none" in page
    assert "<code>ppc</code><td>8<td>" in page


def test_first_screen_says_commit_date_and_machine(source):
    words = source[: source.index('id="verdicts"')]
    assert "Computed" in words and "from commit" in words and "all runs together took" in words


def test_origin_is_that_of_the_last_verdicts_and_counts_other_builds():
    import tables

    def result(git, started, wall):
        return types.SimpleNamespace(provenance={"git": git, "started": started, "cpu": "a"}, run={"wall_s": wall})

    early, late = result("1" * 40, "2026-01-01T00:00:00Z", 2.0), result("2" * 40, "2026-02-01T00:00:00Z", 3.0)
    found = tables.origin(types.SimpleNamespace(verdicts=[late, early], studies=[], runs=[early, late]))
    assert (found["commit"], found["date"], found["others"]) == ("2222222", "2026-02-01", 1)
    assert found["wall"].startswith("5")
    assert tables.origin(types.SimpleNamespace(verdicts=[], studies=[], runs=[])) is None
