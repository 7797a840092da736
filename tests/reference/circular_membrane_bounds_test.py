"""Circular membranes by power series in 40-digit arithmetic: the true error is within the bound."""
import pytest
from evaluator import evaluate, request
from surface_oracle import Balloon, Clamped, covers


def check(p, answer, exact, places):
    values = exact.values()
    truth = [*values, *(x for s in places for x in exact.at(s))]
    assert len(answer) == len(truth)
    for i, (got, true) in enumerate(zip(answer, truth)):
        assert covers(got, true), (p, i, got, float(true), float(got[0] - true))
    assert all(bound <= 1e-11 * value for value, bound in answer[:len(values)]), (p, answer)


@pytest.mark.parametrize("load, nu", [(1e-8, 0.45), (0.003, 0.0), (0.05, 0.3), (0.7, 0.5)])
def test_clamped(load, nu):
    places = [0.0, 1e-5, 0.35, 0.8, 1.0]
    p = dict(load=load, poisson_ratio=nu)
    answer = evaluate([request("circular-membrane", p, places)])[0]
    check(p, answer, Clamped(load, nu, answer[1][0]), places)


@pytest.mark.parametrize("load, nu", [(1e-7, 0.3), (0.01, 0.3), (0.4, 0.5)])
def test_balloon(load, nu):
    p = dict(load=load, poisson_ratio=nu)
    answer = evaluate([request("mylar-balloon", p, [])])[0]
    (rim, height, volume, stress, edge) = answer
    exact = Balloon(load, nu, stress[0], edge[0])
    places = [0.0, 1e-5, 0.6 * edge[0], 0.3 * edge[0] + 0.7]
    answer = evaluate([request("mylar-balloon", p, places)])[0]
    check(p, [answer[i] for i in (1, 3, 0, 2, *range(4, len(answer)))], exact, places)
