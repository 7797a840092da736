"""Figures and tables that can be read: axes by the exact solution, bars of colours, few lines a figure, no error without a reference."""

import cases as gathering
import cost_charts
import figures
import numpy
import profiles
import render
import stability
import synthetic_results
import tables
from plumbline import reader
from test_cost import document, surface_runs


def fields(computed):
    exact = numpy.linspace(0, 1, len(computed))
    return [{"density": numpy.array(computed, float), "density_reference": exact}]


def test_the_axis_of_a_field_is_that_of_the_exact_solution():
    assert profiles.window(fields([0, 0.4, 0.7, 1.9]), "density") == (None, "")
    limits, words = profiles.window(fields([0, 0.4, 0.7, 4.5]), "density")
    assert limits == (-0.5, 1.5) and "0 to 4.5" in words
    assert profiles.window([{"density": numpy.array([1.0, 9.0]), "density_reference": numpy.ones(2)}], "density") == (None, "")


def test_a_map_of_errors_has_its_bar_of_colours():
    drawn = cost_charts.surface(document(surface_runs("default", lambda cells, courant: 0.01 * 100 / cells)), "default")
    assert "error in density.L1" in drawn.svg


def test_a_value_without_a_reference_has_no_error(tmp_path):
    synthetic_results.spring_files_only(tmp_path)
    case = gathering.gather(reader.load_folder(tmp_path))["spring-mass"]
    row = next(row for row in tables.scalar_rows(case) if row["measure"] == "largest_stretch")
    assert (row["reference"], row["relative"], row["bound"]) == ("no reference", "—", "—")
    assert "largest_stretch" not in [row["measure"] for row in tables.reference_budget(case)]
    run = next(entry for entry in case.series if entry.scheme == "york1997")
    assert run.errors("largest_stretch") == [] and len(run.errors("period")) == 1
    assert {row["error"] for row in tables.level_rows(case, "largest_stretch")} == {"—"}


def test_lines_beyond_the_eighth_are_in_small_multiples(tmp_path):
    """Nothing is dropped: every line is in one of the figures, eight in each at most."""
    for number in range(11):
        synthetic_results.sod_study(tmp_path, "default", [0.01 / (number + 1) / 2**k for k in range(5)], 1.6, {"arc": number}, title=f"Line {number}", id=f"line-{number}")
    case = gathering.gather(reader.load_folder(tmp_path))["sod"]
    drawn = render.case_figures(case, {}, [], "sod", None)
    for found in (drawn["convergence"][0], drawn["costs"]):
        lines = [key.label for figure in found if figure.title == found[0].title for key in figure.keys if key.label.startswith("Line")]
        assert sorted(lines) == sorted(f"Line {number}" for number in range(11)), found[0].title
        assert [figure.further for figure in found if figure.title == found[0].title] == [False, True]
    assert figures.MOST_SERIES == 8


def test_growth_of_more_than_eight_integrators_has_panels():
    names = [f"method-{number}" for number in range(11)]
    configurations = [synthetic_results._bar_configuration("usl", 0.3) | {"integrator": name} for name in names]
    panels = [stability.growth({"problem": "bar", "title": "A bar", "configurations": some}, "growth").svg.count("step in") for some in (configurations[:8], configurations)]
    keys = stability.growth({"problem": "bar", "title": "A bar", "configurations": configurations}, "growth").keys
    assert panels[1] == 2 * panels[0] and [key.label for key in keys] == names
