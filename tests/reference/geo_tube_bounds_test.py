"""Random tubes, flat and round, stiff and elastic, against 40-digit arithmetic: the true error is within the bound."""
import numpy
from evaluator import evaluate, request, wide
from geo_tube_oracle import R, Tube, covers

VALUES, ROW = 7, 5


def random_tube(random):
    """Weight over pressure from nearly round to thirty times flatter than round; up to the strength of the membrane."""
    p = dict(perimeter=wide(random, 1e-2, 1e2), top_pressure=wide(random, 1e-1, 1e5), compliance=0.0)
    p["specific_weight"] = wide(random, 1e-6, 1e2) * p["top_pressure"] / p["perimeter"]
    if random.uniform() < 0.1:
        p["specific_weight"] = 0.0
    if random.uniform() < 0.5:
        p["compliance"] = wide(random, 1e-6, 0.1) * 8 / (p["top_pressure"] * p["perimeter"])
        p["specific_weight"] = min(p["specific_weight"], 4 * p["top_pressure"] / p["perimeter"])
    return p


def test_random_tubes():
    random = numpy.random.default_rng(1998)
    problems = [random_tube(random) for _ in range(150)]
    places = [[0.0, 0.5 * p["perimeter"], *(float(p["perimeter"] * random.uniform()) for _ in range(3))]
              for p in problems]
    answers = evaluate([request("geo-tube", p, s) for p, s in zip(problems, places)])
    for p, at, answer in zip(problems, places, answers):
        exact = Tube(**p)
        for i, (got, true) in enumerate(zip(answer, exact.values())):
            assert covers(got, true), (p, i, got, float(true), float(R(got[0]) - true))
        assert all(bound <= 1e-10 * abs(value) + 1e-300 for value, bound in answer[:VALUES]), (p, answer)
        for j, along in enumerate(at):
            for i, (got, true) in enumerate(zip(answer[VALUES + j * ROW:VALUES + (j + 1) * ROW], exact.at(along))):
                assert covers(got, true), (p, along, i, got, float(true), float(R(got[0]) - true))


def test_end_of_contact():
    """At the doubles next to it the curvature jumps: the bound says so."""
    tube = Tube(4.0, 9810.0, 2000.0, 0.0)
    edge = float(tube.b / 2)
    places = [float(numpy.nextafter(edge, 0)), edge, float(numpy.nextafter(edge, 1)), edge - 1e-9, edge + 1e-9]
    answer = evaluate([request("geo-tube", {}, places)])[0]
    for j, along in enumerate(places):
        for got, true in zip(answer[VALUES + j * ROW:VALUES + (j + 1) * ROW], tube.at(along)):
            assert covers(got, true), (along, got, true)
