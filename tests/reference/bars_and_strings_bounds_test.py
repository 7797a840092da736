"""Hundreds of random strings, chains and bars against 50-digit arithmetic: the true error is within the bound."""
import bars_and_strings_oracle as oracle
import numpy
import pytest
from bars_and_strings_oracle import R, covers
from evaluator import evaluate, request, wide


def check(label, answer, true):
    assert len(answer) == len(true)
    for i, (got, exact) in enumerate(zip(answer, true)):
        assert covers(got, exact), (label, i, got, float(exact), float(abs(R(got[0]) - exact)))


def rows_of(answer, values, width):
    return [answer[i : i + width] for i in range(values, len(answer), width)]


def test_slack_string():
    random = numpy.random.default_rng(55)
    keys = ("youngs_modulus", "area", "length", "mass", "gravity", "slack")
    problems = [{key: wide(random) for key in keys} for _ in range(1000)]
    for p in problems[::10]:
        p["slack"] = 0
    exact = [oracle.Slack(**p) for p in problems]
    times = [[float(e.period) * t for t in (random.uniform(0, 1), random.uniform(0, 40))] +
             [float(e.fall), float(e.period)]
             for e in exact]
    answers = evaluate([request("slack-string", p, t) for p, t in zip(problems, times)])
    for p, e, ts, answer in zip(problems, exact, times, answers):
        check(p, answer[:6], e.values())
        assert all(bound <= 1e-13 * abs(value) for value, bound in answer[:6])
        for t, row in zip(ts, rows_of(answer, 6, 3)):
            check((p, t), row, e.row(t))


def test_hanging_chain():
    random = numpy.random.default_rng(1738)
    problems, places = [], []
    for _ in range(300):
        p = dict(length=wide(random), gravity=wide(random), line_density=wide(random),
                 mode=int(random.choice([1, 2, 3, 5, 10, 30])), amplitude=wide(random) * random.choice([-1, 1]))
        p["time"] = float(random.uniform(0, 30) * numpy.sqrt(p["length"] / p["gravity"]))
        problems.append(p)
        inside = random.uniform(), wide(random, 1e-20, 1)
        places.append([0.0, p["length"], *(float(p["length"] * share) for share in inside)])
    answers = evaluate([request("hanging-chain", p, s) for p, s in zip(problems, places)])
    for p, at, answer in zip(problems, places, answers):
        time = p.pop("time")
        exact = oracle.Chain(**p)
        check(p, answer[:5], exact.values(time))
        margin = (20 + float(exact.j)) ** 1.5  # the rounding of the argument, over J1 of the size of j^-1/2
        assert all(bound <= 2e-14 * margin * abs(value) for value, bound in answer[:4]), (p, answer[:4])
        for s, row in zip(at, rows_of(answer, 5, 4)):
            check((p, s, time), row, exact.row(s, time))


def test_catenary():
    random = numpy.random.default_rng(1691)
    problems = []
    for _ in range(400):
        p = dict(span=wide(random), weight=wide(random), compliance=0.0)
        kind = random.integers(3)
        p["length"] = p["span"] * float(1 + wide(random, 1e-9, 1e3))
        if kind > 0:
            p["compliance"] = float(wide(random, 1e-9, 1e2) / (p["weight"] * p["span"]))
            if kind == 2:
                p["length"] = p["span"] * float(random.uniform(0.3, 1))
        problems.append(p)
    places = [[0.0, p["length"], 0.5 * p["length"], float(p["length"] * random.uniform())] for p in problems]
    answers = evaluate([request("catenary", p, s) for p, s in zip(problems, places)])
    for p, at, answer in zip(problems, places, answers):
        exact = oracle.Chainline(**p)
        check(p, answer[:5], exact.values())
        for s, row in zip(at, rows_of(answer, 5, 4)):
            check((p, s), row, exact.row(s))
        # the differences of length and span, and of stretch and slack, are the only ones that lose digits
        margin = 1 + p["span"] / abs(p["length"] - p["span"])
        assert all(bound <= 1e-13 * margin * abs(value) for value, bound in answer[:5]), (p, answer[:5])


@pytest.mark.parametrize("name, exact_of, seed, keys, sharp, bound_of", [
    ("string-vibration", oracle.TautString, 1876, ("youngs_modulus", "area", "density", "strain", "length"), 7, 1e-12),
    ("bar-vibration", oracle.Bar, 1994, ("youngs_modulus", "density", "area", "length", "velocity"), 5, 1e-13),
])
def test_vibration(name, exact_of, seed, keys, sharp, bound_of):
    """The first `sharp` values are known to `bound_of` of themselves."""
    random = numpy.random.default_rng(seed)
    problems, places = [], []
    for _ in range(1000):
        p = {key: wide(random) for key in keys}
        p["mode"] = int(random.integers(1, 20))
        if name == "string-vibration":
            p["amplitude"] = p["length"] * wide(random, 1e-6, 10)
        speed = numpy.sqrt(p["youngs_modulus"] * p.get("strain", 1) / p["density"])
        p["time"] = float(random.uniform(0, 30) * p["length"] / speed)
        problems.append(p)
        places.append([0.0, p["length"], float(p["length"] * random.uniform())])
    answers = evaluate([request(name, p, x) for p, x in zip(problems, places)])
    for p, at, answer in zip(problems, places, answers):
        time = p.pop("time")
        exact = exact_of(**p)
        check(p, answer[:8], exact.values(time))
        assert all(bound <= bound_of * abs(value) for value, bound in answer[:sharp]), p
        for x, row in zip(at, rows_of(answer, 8, 3)):
            check((p, x, time), row, exact.row(x, time))


def test_bar_riemann():
    random = numpy.random.default_rng(1747)
    problems, places, exact = [], [], []
    for _ in range(600):
        p = {key: wide(random) for key in ("youngs_modulus", "density", "length")}
        p["middle"] = float(p["length"] * random.uniform(0.05, 0.95))
        states = [[wide(random) * random.choice([-1, 1]) for _ in range(2)] for _ in range(2)]
        fixed = [int(f) for f in random.integers(0, 2, 2)]
        e = oracle.TwoStates(p["youngs_modulus"], p["density"], p["length"], p["middle"], *states, fixed)
        exact.append(e)
        p |= {"left.velocity": states[0][0], "left.stress": states[0][1], "right.velocity": states[1][0],
              "right.stress": states[1][1], "left.fixed": fixed[0], "right.fixed": fixed[1]}
        p["time"] = float(wide(random, 0.01, 20) * p["length"] / float(e.c))
        problems.append(p)
        at = [float(x) for x in random.uniform(0, p["length"], 2)] + [0.0, p["length"]]
        front = float(((R(p["middle"]) + e.c * R(p["time"])) % (2 * e.L)))
        places.append(at + [min(front, p["length"])])
    answers = evaluate([request("bar-riemann", p, x) for p, x in zip(problems, places)])
    sharp = 0
    for p, e, at, answer in zip(problems, exact, places, answers):
        t = R(p["time"])
        assert covers(answer[0], e.c) and covers(answer[1], e.rho * e.c) and covers(answer[2], e.L / e.c)
        largest = max(abs(p[key]) for key in ("left.velocity", "right.velocity"))
        largest += max(abs(p[key]) for key in ("left.stress", "right.stress")) / float(e.rho * e.c)
        for x, row in zip(at, rows_of(answer, 5, 3)):
            v, s = e.at(R(x), t)
            u = e.displacement(R(x), t)
            check((p, x), row, (u, v, s))
            assert row[0][1] <= 1e-13 * largest * float(t + e.L / e.c)
            if e.jumps(R(x), t) > R(1e-11) * (e.L + e.c * t):  # away from fronts nothing is left open
                sharp += 1
                assert row[1][1] <= 1e-14 * largest and row[2][1] <= 1e-14 * largest * float(e.rho * e.c)
    assert sharp > 1500  # the ends are jumps of the continued data: they are always "near" one only at rare times


def test_bar_impact():
    """Against the same oracle: both bars as one free bar from the contact on."""
    random = numpy.random.default_rng(1906)
    problems, requests = [], []
    for _ in range(200):
        p = {key: wide(random) for key in ("youngs_modulus", "density", "length", "gap")}
        p["left"] = wide(random) * random.choice([-1, 1])
        p["velocity_right"] = wide(random, 0.1, 10) * random.choice([-1, 1])
        p["velocity_left"] = p["velocity_right"] + wide(random, 0.1, 10)
        v1, v2, L = R(p["velocity_left"]), R(p["velocity_right"]), R(p["length"])
        e = oracle.TwoStates(p["youngs_modulus"], p["density"], 2 * p["length"], p["length"], [v1, 0], [v2, 0], [0, 0])
        touch, lasts = R(p["gap"]) / (v1 - v2), 2 * L / e.c
        for share in (-0.3, 0.17, 0.45, 0.88, 1.4):
            t, away = float(touch + share * lasts), [0.0, float(L * R(random.uniform(0.05, 0.95)))]
            if t >= 0:
                problems.append((v1, v2, L, e, touch, lasts, t, away))
                requests.append(request("bar-impact", {**p, "time": t}, away))
    for (v1, v2, L, e, touch, lasts, t, away), answer in zip(problems, evaluate(requests)):
        stress, mean, since = -e.rho * e.c * (v1 - v2) / 2, (v1 + v2) / 2, R(t) - touch
        check(t, answer[:5], (e.c, touch, touch + lasts, lasts, stress))
        for distance, row in zip(away, rows_of(answer, 8, 6)):
            for side, x, v in ((row[:3], L - R(distance), v1), (row[3:], L + R(distance), v2)):
                if since < 0:
                    true = v * R(t), v, R(0)
                elif since < lasts:
                    waves = e.at(x, since) if distance else (mean, stress)
                    true = (v * touch + e.displacement(x, since), *waves)
                else:
                    true = v * touch + mean * lasts + (v1 + v2 - v) * (since - lasts), v1 + v2 - v, R(0)
                check((t, distance), side, true)
