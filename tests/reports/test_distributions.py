"""Cases that draw problems at random: their ratios of errors as distributions, and what a trial without points shows."""

import re

import numpy

import distributions
import render
from synthetic_results import measure, run_object, write_run


def trial(folder, name, ratios):
    run = run_object("draws", "default", 1, {}, {"density.median": measure(1.0)}, points=0, steps=0,
                     wall_s=1.0, value=name)  # fmt: skip
    run["settings"] = {"trial": name}
    run["file"] = f"draws-default-{name}-0123456789ab.h5"
    write_run(folder, run, {"x": numpy.arange(len(ratios)) + 1.0, "density_ratio_of_errors": numpy.array(ratios)})
    return run["file"]


def page_of(tmp_path):
    output = tmp_path / "index.html"
    assert render.main([str(tmp_path), str(output), "--single-file"]) == 0
    return output.read_text(encoding="utf-8")


def test_steps_rise_by_one_over_the_count_at_each_value():
    ratios, shares = distributions.steps(numpy.array([3.0, 1.0, 2.0, 2.0]))
    assert ratios.tolist() == [1, 1, 2, 2, 2, 2, 3, 3]
    assert shares.tolist() == [0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1]


def test_values_that_are_no_numbers_count_as_missing():
    ratios, shares = distributions.steps(numpy.array([1.0, numpy.nan]))
    assert ratios.tolist() == [1, 1] and shares.tolist() == [0, 0.5]
    assert distributions.steps(numpy.array([numpy.nan]))[0].size == 0


def test_figure_has_a_line_for_each_trial_and_says_how_many_problems(tmp_path):
    files = [trial(tmp_path, "default", [0.5, 1, 2, 4]), trial(tmp_path, "sharper", [0.4, 0.9, 1.5, 3])]
    source = page_of(tmp_path)
    assert "Ratios of errors over all problems" in source and "Share of 4 problems" in source
    assert all(name in source for name in files)


def test_trial_without_points_has_no_cost_and_no_count_of_points(tmp_path):
    trial(tmp_path, "default", [0.5, 1, 2, 4])
    source = page_of(tmp_path)
    assert "<h4>Error against cost</h4>" not in source
    assert not re.search(r"<div class=\"sub\">[^<]* cells</div>", source)


def test_trial_whose_ratios_are_no_numbers_leaves_the_page_whole(tmp_path):
    trial(tmp_path, "default", [numpy.nan, numpy.nan])
    assert "Drawn problems" in page_of(tmp_path)
