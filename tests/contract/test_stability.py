"""The command `stability`: documents, choices, errors, and that numbers do not depend on threads."""

import pytest


def document(plumbline, *arguments):
    result = plumbline("stability", *arguments, json=True)
    assert result.code == 0, result.err
    return result.json()


def test_predicted_and_observed_limits_meet_the_closed_form(plumbline):
    found = document(plumbline, "bar", "--integrator", "usf", "--integrator", "usl", "--over", "N=0.1,0.3", "--set", "ppc=1")
    assert found["problem"] == "bar" and len(found["configurations"]) == 4
    for configuration in found["configurations"]:
        limit = configuration["predicted"][0]["high"]
        assert configuration["predicted"][0]["low"] == 0
        assert limit == pytest.approx(configuration["closed_form"], rel=1e-6)
        seen = configuration["observed"][0]
        assert seen["low"] / 1.01 < limit < seen["high"] * 1.01


def test_without_runs_nothing_is_observed(plumbline):
    found = document(plumbline, "bar", "--no-runs")["configurations"][0]
    assert found["observed"] == [] and found["integrator"] == "musl"


def test_an_unstable_method_has_no_limit_but_growth(plumbline):
    found = document(plumbline, "oscillator", "--integrator", "energy", "--no-runs")["configurations"][0]
    assert found["always"] == "unstable" and found["predicted"] == []
    assert all(entry["per_step"] > 1 for entry in found["growth"])


def test_maps_have_a_row_for_each_value(plumbline):
    maps = document(plumbline, "bar-edge", "--no-runs", "--maps")["maps"]
    assert maps
    for drawn in maps:
        assert len(drawn["values"]) == len(drawn["y"]["values"])
        assert all(len(row) == len(drawn["x"]["values"]) for row in drawn["values"])


def test_numbers_do_not_depend_on_threads(plumbline):
    one, two = (document(plumbline, "bar", "--over", "N=0.1,0.2,0.4", "--threads", n)["configurations"] for n in (1, 2))
    assert one == two


def test_list_names_the_problems(plumbline):
    names = [entry["name"] for entry in plumbline("list", json=True).json()["problems"]]
    assert {"bar", "bar-edge", "york", "plane", "gas", "membrane", "coupled", "axisymmetric", "contact"} <= set(names)


@pytest.mark.parametrize("arguments, key", [
    (["baar"], "bar"), (["bar", "--set", "M=0.5"], "N"), (["bar", "--set", "N=1"], "N"), (["bar", "--over", "N"], "--over"),
    (["bar", "--integrator", "rk4", "--set", "transfer=apic"], "rk4"), (["bar", "--set", "shape=quadratik"], "quadratic")])
def test_wrong_calls_are_named(plumbline, arguments, key):
    result = plumbline("stability", *arguments)
    assert result.code == 2 and key in result.err


def test_auto_is_a_courant_number_that_the_laboratory_found(plumbline):
    run = plumbline("run", "bar-vibration", "--cells", 13, "--set", "cfl=auto", json=True).json()
    assert 0.1 < run["settings"]["cfl"] < 2
    refused = plumbline("run", "bar-vibration", "--set", "cfl=often")
    assert refused.code == 2 and "auto" in refused.err
