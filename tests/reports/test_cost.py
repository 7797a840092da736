"""What accuracy costs: estimators on numbers whose answer is known, and the section of the page made of them."""

import json
import math

import cost
import cost_charts
from plumbline import reader
import pytest
import render
from cases import Case, Series
from cost_estimates import AT, MORE, MOST, NONE, Reach, front, ratio, reach, spread
from synthetic_costs import document, entry, first_order


def test_time_to_the_target_of_a_power_law():
    """error = 0.08 / cost: 0.01 costs 8, whichever levels were run."""
    for costs in ([1, 2, 4, 16, 32], [5, 11], [7.9, 8.1]):
        found = reach([(c, 0.08 / c) for c in costs], 0.01)
        assert found.kind == AT and found.cost == pytest.approx(8, rel=1e-12)


def test_time_to_the_target_on_a_level():
    assert reach([(1, 0.1), (3, 0.01), (9, 0.001)], 0.01).cost == pytest.approx(3, rel=1e-12)


def test_never_there():
    found = reach([(1, 0.2), (2, 0.1), (4, 0.05)], 0.01)
    assert (found.kind, found.cost) == (MORE, 4) and found.never


def test_a_dip_that_does_not_last_does_not_count():
    assert reach([(1, 0.2), (2, 0.009), (4, 0.02)], 0.01).kind == MORE
    found = reach([(1, 0.2), (2, 0.009), (4, 0.02), (8, 0.005)], 0.01)
    assert found.kind == AT and 4 < found.cost < 8


def test_better_already_at_the_coarsest_is_a_bound():
    assert reach([(3, 0.004), (6, 0.002)], 0.01) == Reach(MOST, 3, 2)


def test_one_level_is_a_bound_either_way():
    assert reach([(3, 0.004)], 0.01) == Reach(MOST, 3, 1)
    assert reach([(3, 0.04)], 0.01) == Reach(MORE, 3, 1)


def test_a_level_that_stopped_is_not_there():
    assert reach([(1, 0.2), (2, None)], 0.01).kind == MORE
    assert reach([(1, None), (2, 0.002)], 0.01) == Reach(MOST, 2, 2)
    assert reach([], 0.01).kind == NONE


@pytest.mark.parametrize("own, base, sign", [
    (AT, AT, ""), (AT, MORE, "<"), (AT, MOST, ">"), (MOST, AT, "<"), (MOST, MORE, "<"), (MORE, AT, ">"), (MORE, MOST, ">"),
    (MOST, MOST, "?"), (MORE, MORE, "?"), (NONE, AT, "?"), (AT, NONE, "?"),
])  # fmt: skip
def test_ratio_says_whether_it_is_a_bound(own, base, sign):
    found = ratio(Reach(own, 2, 3), Reach(base, 8, 3))
    assert found.sign == sign and (found.value == 0.25 if sign != "?" else math.isnan(found.value))


def test_front_is_what_nothing_beats():
    points = [(1, 0.1), (2, 0.2), (2, 0.05), (3, 0.05), (4, 0.01), (1, 0.1), (8, 0.02)]
    assert front(points) == [0, 2, 4]
    assert front([]) == [] and front([(1, 1)]) == [0]


def test_spread_of_repeats():
    assert spread([3, 1, 2]) == (2, 1, 3) and spread([4, 1, 2, 3]) == (2.5, 1, 4) and spread([7]) == (7, 7, 7)


# --- the document and the section -----------------------------------------------------------------


class OneCase(Case):
    measure = "density.L1"


def compared(runs):
    (found,) = cost.compare(document(runs), {"sod": OneCase("sod")})
    return found


def test_schemes_are_compared_with_york():
    """Half the error at equal cells: a quarter of the time, where time grows with the square of the cells."""
    found = compared(first_order("default", "default", 1) + first_order("york1997", "york1997", 2))
    assert found.ratio(found.line("default")).value == pytest.approx(0.25) and found.ratio(found.line("default")).sign == ""
    assert found.cheapest.scheme == "default"


def test_york_that_never_arrives_gives_a_bound():
    york = [entry("york1997", "york1997", cells, 0.03, 1e-5 * cells**2) for cells in (50, 100, 200)]
    found = compared(first_order("default", "default", 1) + york)
    value = found.ratio(found.line("default"))
    assert value.sign == "<" and value.value == pytest.approx(0.1 / 0.4)
    assert cost.reach_words(found.reaches[found.york.label]).startswith("not by")


def with_keys(**numerical):
    """A case whose text says of these keys whether they are numerical."""
    case = OneCase("sod")
    case.catalog = {"parameters": [{"key": key, "numerical": value} for key, value in numerical.items()]}
    return case


def test_the_problem_is_decided_by_the_keys_that_the_case_calls_physical():
    """A run of half a second is no rival of one of five, whoever computes it; how points know their strain is no other problem."""
    case = with_keys(t_end=False, strain=True)
    runs = first_order("default", "default", 1, differs={"t_end": 5}) + first_order("default", "unfolding", 0.01, differs={"t_end": 0.5})
    runs += first_order("york1997", "york1997", 0.01, differs={}) + first_order("default", "summed", 2, differs={"t_end": 5, "strain": "x"})
    (found,) = cost.compare(document(runs), {"sod": case})
    assert [line.study for line in found.lines] == ["default", "summed"] and found.york is None
    pale = [line.study for line in cost.lines_of(document(runs), case) if not line.same_problem]
    assert sorted(pale) == ["unfolding", "york1997"]


def test_a_key_of_which_nothing_is_said_is_physical():
    runs = first_order("default", "default", 1) + first_order("default", "light", 0.01, differs={"mass": 0.1})
    assert [line.study for line in compared(runs).lines] == ["default"]


def test_schemes_on_another_problem_are_compared_with_each_other():
    """York's airbag, whose pressure is an absolute one, and the default on the same: a problem of its own."""
    other = {"pressure": "york"}
    runs = first_order("default", "default", 1) + first_order("york1997", "york1997", 4, differs=other)
    runs += first_order("default", "york-pressure", 2, differs=other) + first_order("default", "alone", 2, differs={"pressure": "x"})
    own, york = cost.compare(document(runs), {"sod": with_keys(pressure=False)})
    assert (own.problem, own.york) == ("", None)
    assert york.problem == "pressure=york" and [line.study for line in york.lines] == ["york-pressure", "york1997"]
    assert york.ratio(york.lines[0]).value == pytest.approx(0.25)
    assert york.name == "sod, pressure=york"


def test_levels_added_for_cost_belong_to_their_study():
    york = [entry("york1997", "york1997", 100, 0.02, 0.1)]
    more = [entry("york1997", "levels/york1997", cells, 2 / cells, 0.1) for cells in (50, 100, 200)]
    (line,) = [line for line in compared(first_order("default", "default", 1) + york + more).lines if line.scheme == "york1997"]
    assert [level["cells"] for level in line.levels] == [50, 100, 200] and line.study == "york1997"


def test_levels_of_other_numbers_stay_apart():
    york = [entry("york1997", "york1997", 100, 0.02, 0.1)]
    more = [entry("york1997", "levels/york1997", cells, 2 / cells, 0.1, steps=7) for cells in (50, 100)]
    lines = cost.lines_of(document(york + more), OneCase("sod"))
    assert [line.study for line in lines] == ["york1997", "levels/york1997"] and len({line.label for line in lines}) == 2


def standings(runs, cases=("sod", "lax", "leblanc")):
    rows = cost.jobs(cost.compare(document(runs), {name: OneCase(name) for name in cases}))
    return {row["scheme"]: row for row in rows}, cost.recommended(rows)


def two_schemes(*constants):
    """The default with the constant 2 and York's with these, one a case."""
    runs = []
    for case, constant in zip(("sod", "lax", "leblanc"), constants):
        runs += first_order("default", "default", 2, case=case) + first_order("york1997", "york1997", constant, case=case)
    return runs


def test_a_recommended_scheme_says_over_which_problems_it_needs_less_time_than_which_others():
    """An error costs time in proportion to the square of the constant: the default is first in two of three problems."""
    rows, (choice,) = standings(two_schemes(1, 4, 40))
    assert (rows["default"]["first"], rows["default"]["shared"]) == (2, 3) and rows["york1997"]["first"] == 1
    assert choice["scheme"] == "default" and choice["problems"] == ["lax", "leblanc", "sod"]
    assert choice["against"] == [{"scheme": "york1997", "less": 2, "more": 1}]
    assert rows["default"]["recommended"] and not rows["york1997"]["recommended"]


def test_nobody_is_recommended_without_a_rival():
    """What was tried alone has not been chosen from anything."""
    runs = first_order("default", "default", 1) + first_order("default", "default", 1, case="lax")
    rows, (choice,) = standings(runs)
    assert not rows["default"]["recommended"] and choice["scheme"] is None
    assert choice["why"] == "no two schemes were run on the same problem"


def test_nobody_is_recommended_over_a_single_problem():
    rows, (choice,) = standings(two_schemes(4))
    assert choice["scheme"] is None and "one problem" in choice["why"] and not any(row["recommended"] for row in rows.values())


def test_nobody_is_recommended_where_each_is_first_as_often():
    _, (choice,) = standings(two_schemes(1, 4))
    assert choice["scheme"] is None and choice["why"] == "each of the schemes is beaten by another on as many problems"


def test_what_is_only_known_as_a_bound_decides_nothing_it_does_not_settle():
    """One mesh each: the better one took longer, and what it would take to be as bad as the other is not known."""
    runs = []
    for case in ("sod", "lax"):
        runs += [entry("default", "default", 50, 0.001, 5, case=case), entry("york1997", "york1997", 50, 0.002, 3, case=case)]
    _, (choice,) = standings(runs)
    assert choice["scheme"] is None and "certain" in choice["why"]


def test_a_bound_that_settles_it_decides():
    """The default's only mesh is better and took less."""
    runs = []
    for case in ("sod", "lax"):
        runs += [entry("default", "default", 50, 0.001, 2, case=case)] + first_order("york1997", "york1997", 4, case=case)
    runs[1]["wall_s"], runs[6]["wall_s"] = [7, 8, 9], [7, 8, 9]  # his coarsest meshes
    _, (choice,) = standings([run for run in runs if run["scheme"] == "default" or run["cells"] == 50])
    assert choice["scheme"] == "default"


def test_repeats_that_overlap_decide_nothing():
    """A tenth of a difference, while repeats lie a third apart."""
    _, (choice,) = standings(two_schemes(2.1, 2.1))
    assert choice["scheme"] is None and "certain" in choice["why"]


def test_choices_of_a_study_are_not_those_of_the_scheme():
    """A cubic shape set by hand is ten times better: the scheme has no credit for it."""
    runs = two_schemes(1, 1)
    for case in ("sod", "lax"):
        runs += first_order("default", "cubic", 0.02, case=case, choices={"shape": "cubic"})
    _, (choice,) = standings(runs)
    assert choice["scheme"] == "york1997"


def test_orders_are_those_of_asymptotic_studies_alone():
    case = OneCase("sod")
    runs = first_order("default", "default", 1) + first_order("york1997", "york1997", 2)
    for study, order, asymptotic in (("default", 0.98, True), ("york1997", 3.7, False)):
        case.series.append(Series(study, "cells", {}, [], {"density.L1": {"order": order, "asymptotic": asymptotic, "reason": ""}}, [], study=study))
    rows = {row["scheme"]: row for row in cost.jobs(cost.compare(document(runs), {"sod": case}))}
    assert rows["default"]["orders"] == "0.980" and rows["york1997"]["orders"] == "—"


def test_a_value_that_is_zero_has_no_relative_error():
    runs = [entry("default", "default", cells, 1e9, 0.1) for cells in (50, 100)]
    assert cost.compare(document(runs), {"sod": OneCase("sod")}) == []


def surface_runs(scheme, error):
    return [
        entry(scheme, "surface", cells, error(cells, courant), 1e-4 * cells**2 / courant, vary="dt", value=courant,
              steps=round(cells / courant))
        for cells in (50, 100, 200)
        for courant in (0.0125, 0.05, 0.5, 0.9)
    ]  # fmt: skip


def york_runs(steps=3846):
    """Steps of a Courant number of 0.026 at 100 cells."""
    return [entry("york1997", "york1997", 100, 0.0100, 0.4, steps=steps)]


def test_what_york_s_step_costs():
    found = cost_charts.york_step(document(york_runs(steps=5000) + surface_runs("york1997", lambda cells, courant: 0.0102)))
    assert [row["factor"] for row in found["rows"]] == ["25", "45"] and found["holds"]
    found = cost_charts.york_step(document(york_runs(steps=5000) + surface_runs("york1997", lambda cells, courant: 0.0120)))
    assert not found["holds"] and found["gain"].startswith("20")
    assert cost_charts.york_step(document(york_runs())) is None


def test_courant_number_of_york_s_step():
    doc = document(york_runs() + surface_runs("york1997", lambda cells, courant: 0.01))
    surface, _, _ = cost_charts.surface_runs(doc, "york1997")
    assert cost_charts.own_courant(doc, surface, 100) == pytest.approx(0.026, rel=1e-3)
    assert cost_charts.own_courant(doc, surface, 50) is None


@pytest.mark.parametrize("scheme", ["york1997", "default"])
def test_surface_is_drawn(scheme):
    doc = document(york_runs() + surface_runs(scheme, lambda cells, courant: 1 / cells + 0.01 * courant))
    drawn = cost_charts.surface(doc, scheme)
    assert drawn.svg.startswith("<svg") and ("ork’s step" in str(drawn.keys)) == (scheme == "york1997")
    assert cost_charts.surface(document([]), scheme) is None


def test_charts_and_figures_of_a_case_are_drawn():
    doc = document(first_order("default", "default", 1) + first_order("york1997", "york1997", 2))
    found = cost.compare(doc, {"sod": OneCase("sod")})
    assert cost_charts.relative_to_york(found).svg.startswith("<svg") and cost_charts.absolute(found) is None
    time, work = cost.case_figures(doc, OneCase("sod"), "case-sod")
    assert "Medians of up to 3" in time.caption and "particle-steps" in work.title.lower()
    assert cost.case_figures(doc, OneCase("lax"), "case-lax") == []


def test_a_figure_tells_eight_lines_apart_and_the_others_are_in_the_next():
    runs = [run for number in range(11) for run in first_order("default", f"study-{number}", 1 + number)]
    time, more, *_ = cost.case_figures(document(first_order("default", "default", 1) + runs), OneCase("sod"), "case-sod")
    assert [len([key for key in figure.keys if key.label != "Pareto front"]) for figure in (time, more)] == [8, 4]
    assert "4 further lines" in time.caption and more.further and not time.further


def test_page_with_costs(tmp_path):
    runs = first_order("default", "default", 1) + first_order("york1997", "york1997", 2)
    (tmp_path / "cost.json").write_text(json.dumps(document(runs)))
    folder = reader.load_folder(tmp_path)
    part = render.cost_part(folder, {"sod": OneCase("sod")})
    assert not folder.damaged and part["jobs"][0]["scheme"] == "default" and len(part["recommended"]) == 1
    figures = part["charts"] + part["surfaces"] + cost.case_figures(folder.cost, OneCase("sod"), "sod")
    assert len(figures) > 2 and [figure.title for figure in figures if not figure.commands] == []


@pytest.mark.parametrize("change", [
    lambda d: d.pop("runs"), lambda d: d["runs"].append(7), lambda d: d["runs"][0].pop("case"),
    lambda d: d["runs"][0].update(wall_s=[]), lambda d: d["runs"][0].update(wall_s=["quick"]), lambda d: d["runs"][0].update(errors=[]),
    lambda d: d["runs"][0]["errors"].update(x={"error": 1}), lambda d: d["runs"][0].update(finished=1),
])  # fmt: skip
def test_damaged_document_is_listed(tmp_path, change):
    doc = document([entry("default", "default", 100, 0.01, 0.1)])
    change(doc)
    (tmp_path / "cost.json").write_text(json.dumps(doc))
    folder = reader.load_folder(tmp_path)
    assert folder.cost == {} and [name for name, _ in folder.damaged] == ["cost.json"]
