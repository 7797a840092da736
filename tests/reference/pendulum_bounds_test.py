"""Random elastic pendulums against Taylor series in extended precision: the true error is within the bound."""
import numpy
import pendulum_oracle as oracle
import pytest
from evaluator import evaluate, request
from pendulum_oracle import X
from second_values import agrees

COUNT = 60
VALUES = 12


def random_pendulum(random, one_way):
    """Stiffness from 20 to 500 weights, up to 80 degrees; a one-way string starts stretched and goes slack."""
    mass, gravity, area = (float(10 ** random.uniform(-1, 1)) for _ in range(3))
    kappa = 10 ** random.uniform(1.3, 2.7)
    angle = random.uniform(0.05, 1.4) * random.choice([-1, 1])
    length = 10 ** random.uniform(-1, 1)
    p = dict(pivot_x=float(random.uniform(-1, 1)), pivot_y=float(random.uniform(-1, 1)), mass=mass, gravity=gravity,
             area=area, youngs_modulus=float(kappa * mass * gravity / area), density=0, one_way=int(one_way))
    p["bob_x"] = float(p["pivot_x"] + length * numpy.sin(angle))
    p["bob_y"] = float(p["pivot_y"] - length * numpy.cos(angle))
    share = random.uniform(1.5, 3) if one_way else random.uniform(-1, 3)
    p["strain"] = float(min(0.09, share / kappa)) if random.uniform() < 0.7 else 0.0
    return p


def extended(p):
    """kappa, angle, length, unit of time of the same numbers in extended precision."""
    across, down = X(p["bob_x"]) - X(p["pivot_x"]), X(p["pivot_y"]) - X(p["bob_y"])
    length = numpy.hypot(across, down)
    rest = length / (1 + X(p["strain"]))
    kappa = X(p["youngs_modulus"]) * X(p["area"]) / (X(p["mass"]) * X(p["gravity"]))
    return kappa, numpy.arctan2(across, down), rest, numpy.sqrt(rest / X(p["gravity"]))


def pendulums(one_way):
    random = numpy.random.default_rng(1673 + one_way)
    problems = [random_pendulum(random, one_way) for _ in range(COUNT)]
    columns = [numpy.array(c, dtype=X) for c in zip(*(extended(p) for p in problems))]
    return random, problems, columns


def fresh(problems, columns):
    strains, one_way = [X(p["strain"]) for p in problems], [p["one_way"] for p in problems]
    return oracle.Pendulums(columns[0], columns[1], strains, one_way)


def covers(answer, true):
    # the oracle: some thousand roundings of 5e-20 of numbers of order one
    return agrees(answer, X(true), X(1e-15) * (1 + abs(true)))


@pytest.mark.parametrize("one_way", [False, True], ids=["two-way", "one-way"])
def test_turning_points_and_crossings(one_way):
    _, problems, columns = pendulums(one_way)
    answers = evaluate([request("elastic-pendulum", p) for p in problems])
    turns, passes = fresh(problems, columns).zeros(2, (oracle.turns, oracle.verticals), X(20))
    for p, answer, turn, crossing, unit in zip(problems, answers, turns, passes, columns[3]):
        assert covers(answer[0], turn[1][0] * unit), (p, answer[0], turn[1][0] * unit)
        assert covers(answer[3], turn[0][0] * unit), (p, answer[3], turn[0][0] * unit)
        assert covers(answer[4], turn[0][1]), (p, answer[4], turn[0][1])
        assert covers(answer[5], turn[1][1]), (p, answer[5], turn[1][1])
        assert covers(answer[6], crossing[0][0] * unit) and covers(answer[7], crossing[1][0] * unit), p


@pytest.mark.parametrize("one_way", [False, True], ids=["two-way", "one-way"])
def test_motion(one_way):
    random, problems, columns = pendulums(one_way)
    ends = [float(random.uniform(0.1, 9) * float(unit)) for unit in columns[3]]
    answers = evaluate([request("elastic-pendulum", p, [t]) for p, t in zip(problems, ends)])
    exact = fresh(problems, columns)
    exact.advance_to(numpy.array(ends, dtype=X) / columns[3])
    kappa, _, rest, unit = columns
    speed = rest / unit
    r = numpy.hypot(exact.x, exact.y)
    weight = numpy.array([X(p["mass"]) * X(p["gravity"]) for p in problems])
    for i, (p, answer) in enumerate(zip(problems, answers)):
        x, y, u, v, angle, length, tension = answer[VALUES:]
        label = (p, ends[i])
        assert covers(x, X(p["pivot_x"]) + rest[i] * exact.x[i]), (label, x)
        assert covers(y, X(p["pivot_y"]) + rest[i] * exact.y[i]), (label, y)
        assert covers(u, speed[i] * exact.u[i]) and covers(v, speed[i] * exact.v[i]), label
        assert covers(angle, numpy.arctan2(exact.x[i], -exact.y[i])), label
        assert covers(length, rest[i] * r[i]), label
        pull = weight[i] * kappa[i] * (r[i] - 1)
        assert covers(tension, max(X(0), pull) if one_way else pull), (label, tension, pull)


@pytest.mark.parametrize("one_way", [False, True], ids=["two-way", "one-way"])
def test_bounds_are_not_silly(one_way):
    """Rounding of some thousand steps; soft strings that fly slack amplify what came before."""
    _, problems, _ = pendulums(one_way)
    answers = evaluate([request("elastic-pendulum", p) for p in problems])
    relative = sorted(answer[0][1] / answer[0][0] for answer in answers)
    assert relative[len(relative) // 2] <= 1e-11
    assert relative[-1] <= (1e-6 if one_way else 1e-9)
