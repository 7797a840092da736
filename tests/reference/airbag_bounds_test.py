"""Random airbags, pressed before or not, small probes and large, against 30-digit arithmetic: the true error is within
the bound.
"""
import numpy
import pytest
from airbag_oracle import Impact, R, covers
from evaluator import evaluate, request

YORK = dict(mass=6.03, probe_radius=0.1, speed=3.9, meridian=0.71689571, height=0.0, gamma=1.4, pressure=105325.0,
            ambient_pressure=101325.0)
VALUES = ("max_displacement", "time_of_max", "contact_duration", "rebound_speed", "peak_force", "peak_pressure",
          "least_volume", "start_height", "start_volume", "free_height", "free_radius", "displacement_limit")
ROW = ("displacement", "velocity", "force", "pressure", "volume", "plate_radius", "equator")


def random_airbag(random):
    size, ambient = float(10 ** random.uniform(-1, 1)), random.choice([0.0, float(10 ** random.uniform(3, 5))])
    p = dict(mass=float(10 ** random.uniform(-1, 2)), probe_radius=float(size * random.uniform(0.1, 0.5)),
             meridian=size, gamma=float(random.uniform(1.1, 1.7)), ambient_pressure=ambient,
             pressure=ambient + float(10 ** random.uniform(3, 4)))
    p["height"] = float(0.457 * size * random.uniform(0.9, 0.999)) if random.uniform() < 0.3 else 0.0
    if random.uniform() < 0.5:
        p["gas_volume"] = float(size**3 * random.uniform(0.13, 0.148))
    energy = (p["pressure"] - ambient) * size**3 * 0.152 * random.uniform(0.02, 0.3)
    p["speed"] = float(numpy.sqrt(2 * energy / p["mass"]))
    return p


def problems():
    random = numpy.random.default_rng(1994)
    return [YORK, {**YORK, "pressure": 4000.0, "ambient_pressure": 0.0}] + [random_airbag(random) for _ in range(10)]


@pytest.fixture(scope="module")
def airbags():
    return [(p, Impact(**p)) for p in problems()]


def test_values(airbags):
    answers = evaluate([request("airbag", p) for p, _ in airbags])
    for (p, exact), answer in zip(airbags, answers):
        got, end = dict(zip(VALUES, answer)), exact.state(exact.bm)
        true = dict(max_displacement=end["displacement"], peak_force=end["force"], peak_pressure=end["pressure"],
                    least_volume=end["volume"], start_height=exact.H0, start_volume=exact.V0,
                    rebound_speed=exact.v0, displacement_limit=exact.limit)
        for key, value in true.items():
            assert covers(got[key], value), (p, key, got[key], float(value), float(R(got[key][0]) - value))
            assert got[key][1] <= 1e-11 * abs(got[key][0]), (p, key, got[key])


def test_times(airbags):
    some = airbags[:2] + [pair for pair in airbags[2:] if pair[0]["height"]][:1]
    picks = [[exact.b0 + (exact.bm - exact.b0) * R(share) for share in ("0.35", "0.9")] for _, exact in some]
    times = [[exact.time(b) for b in bs] for (_, exact), bs in zip(some, picks)]
    whole = [exact.time(exact.bm) for _, exact in some]
    asked = [[float(t) for t in ts] + [float(2 * end - ts[1])] for ts, end in zip(times, whole)]
    answers = evaluate([request("airbag", p, t) for (p, _), t in zip(some, asked)])
    for (p, exact), bs, ts, end, ask, answer in zip(some, picks, times, whole, asked, answers):
        assert covers(answer[1], end), (p, answer[1], end, float(R(answer[1][0]) - end))
        assert answer[1][1] <= 1e-7 * answer[1][0], (p, answer[1])
        assert covers(answer[2], 2 * end)
        places = zip(bs + bs[1:], ts + [2 * end - ts[1]], ask, (1, 1, -1))
        for j, (b, t, given, way) in enumerate(places):
            row, true = dict(zip(ROW, answer[len(VALUES) + 7 * j:])), exact.state(b)
            late = (R(given) - t) * way  # of the double asked for: first order
            true["displacement"] += true["velocity"] * late
            true["velocity"] = way * (true["velocity"] - true["force"] / exact.m * late)
            for key in ROW:  # the others change by rounding too: at most a few units of 1e-16
                margin = abs(float(true[key])) * 1e-14
                assert covers((row[key][0], row[key][1] + margin), true[key]), (p, j, key, row[key], float(true[key]))
