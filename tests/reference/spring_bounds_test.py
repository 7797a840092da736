"""A thousand random bars with a tip mass against 60-digit arithmetic: the true error is within the bound, always."""
import numpy
import pytest
from evaluator import evaluate, request
from spring_oracle import R, Spring, mp
from second_values import agrees

VALUES = ("omega_massless", "period_massless", "max_displacement_massless", "omega", "period", "max_displacement",
          "static_displacement")
YORK = dict(youngs_modulus=1e6, area=0.1, length=0.3, mass=3.33, density=0.1, gravity=250)


def random_bar(random, lightest, heaviest):
    """All parameters over four decades; the density follows from the mass ratio."""
    def wide():
        return float(10 ** random.uniform(-2, 2))
    bar = dict(youngs_modulus=1e4 * wide(), area=wide(), length=wide(), mass=wide())
    ratio = 10 ** random.uniform(numpy.log10(lightest), numpy.log10(heaviest))
    bar["density"] = float(ratio * bar["mass"] / (bar["area"] * bar["length"]))
    bar["gravity"] = wide() * float(random.choice([-1, 1]))
    return bar


@pytest.fixture(scope="module")
def cases():
    """Exact bar, times, answer: 700 of any mass ratio, 300 of a ratio near one, where the waves matter most."""
    random = numpy.random.default_rng(1997)
    bars = [random_bar(random, 1e-10, 1e4) for _ in range(700)] + [random_bar(random, 0.05, 20) for _ in range(300)]
    rows, requests = [], []
    for bar in bars:
        exact = Spring(**bar)
        times = [float(t / exact.rate) for t in random.uniform(0, 9, 2)]
        rows.append((exact, times))
        requests.append(request("spring-mass", bar, times))
    return [(*row, answer) for row, answer in zip(rows, evaluate(requests))]


def covers(answer, true):
    return agrees(answer, R(true))


def test_frequencies_and_rests_are_within_their_bounds(cases):
    for exact, _, answer in cases:
        got = dict(zip(VALUES, answer))
        assert covers(got["omega_massless"], exact.omega_massless)
        assert covers(got["period_massless"], 2 * mp.pi / exact.omega_massless)
        assert covers(got["max_displacement_massless"], 2 * exact.rest)
        assert covers(got["omega"], exact.omega), (exact.mu, got["omega"], exact.omega)
        assert covers(got["period"], 2 * mp.pi / exact.omega)
        assert covers(got["static_displacement"], exact.rest * (1 + exact.mu / 2))


def test_motion_is_within_its_bounds(cases):
    for exact, times, answer in cases:
        rows = answer[len(VALUES) :]
        for i, t in enumerate(times):
            light = exact.rest * (1 - mp.cos(exact.omega_massless * R(t)))
            assert covers(rows[2 * i], light), (float(exact.mu), t, rows[2 * i], light)
            true = exact.displacement(t)
            assert covers(rows[2 * i + 1], true), (float(exact.mu), t, rows[2 * i + 1], true)


def test_first_extremum_is_within_its_bound(cases):
    near_one = [case for case in cases[700:]][::4]
    for exact, _, answer in near_one:
        got = dict(zip(VALUES, answer))["max_displacement"]
        true = exact.max_displacement()
        assert covers(got, true), (float(exact.mu), got, true)


def test_late_times_of_a_light_spring():
    """Ten periods of York's spring. 260 modes leave out 2 mu^2/(3 pi^4 260^3) = 3e-16 of mu: far below rounding."""
    exact, times = Spring(**YORK), [0.003, 0.01, 0.0497, 0.1003, 0.2]
    rows = evaluate([request("spring-mass", YORK, times)])[0][len(VALUES) :]
    for i, t in enumerate(times):
        assert covers(rows[2 * i + 1], exact.displacement_by_modes(t, 260)), t
        assert rows[2 * i + 1][1] <= 1e-12 * float(exact.rest)


def test_bounds_are_not_silly(cases):
    """Frequencies: a few dozen roundings. Motion: rounding and the modes left out, 1e-15 of the static displacement for
    light springs; a heavier one than its mass converges as the cube of the number of modes and gets at most 1e-6."""
    relative = [bound / abs(value) for _, _, answer in cases for value, bound in answer[: len(VALUES) - 2]]
    assert max(relative) <= 1e-12
    for exact, _, answer in cases:
        rest = abs(float(exact.rest * (1 + exact.mu / 2)))
        share = max(bound for _, bound in answer[len(VALUES) + 1 :: 2]) / rest
        assert share <= (1e-12 if exact.mu < 0.01 else 1e-9 if exact.mu < 10 else 1e-6), (float(exact.mu), share)
