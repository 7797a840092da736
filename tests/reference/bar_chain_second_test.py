"""A second, independent integration of the chain of bars: equations in the original units, scipy's DOP853. The chain of the
same number of elements must come out the same; finer chains must lie within the bound.
"""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from second_values import agrees, is_near

SPRING = dict(support_x=0.0, support_y=0.0, end_x=0.0, end_y=-0.3, mass=3.33, gravity=250.0, youngs_modulus=1e6, area=0.1,
              density=0.1, strain=0.0, one_way=0)
CHAINS = {
    "spring": (SPRING, 0.02),
    "slack": (SPRING | dict(end_y=-0.28, strain=-0.02 / 0.3, one_way=1), 0.016),
    "pendulum": (dict(support_x=0.2, support_y=1.0, end_x=-0.3, end_y=0.5, mass=2.0, gravity=9.81, youngs_modulus=4e3,
                      area=0.1, density=1.4, strain=1e-3, one_way=0), 0.8),
}


def integrate(p, elements, times):
    top = numpy.array([p["support_x"], p["support_y"]])
    end = numpy.array([p["end_x"], p["end_y"]])
    rest = numpy.linalg.norm(end - top) / (1 + p["strain"]) / elements
    mass = numpy.full(elements, p["density"] * p["area"] * rest)
    mass[-1] = mass[-1] / 2 + p["mass"]
    start = top + numpy.outer(numpy.arange(1, elements + 1) / elements, end - top)

    def tensions(x):
        along = numpy.diff(numpy.vstack([top, x]), axis=0)
        length = numpy.linalg.norm(along, axis=1)
        strain = length / rest - 1
        if p["one_way"]:
            strain = numpy.maximum(strain, 0)
        return p["youngs_modulus"] * p["area"] * strain, along / length[:, None], strain

    def rate(_, y):
        x, v = y.reshape(2, elements, 2)
        pull, along, _ = tensions(x)
        force = -pull[:, None] * along
        force[:-1] -= force[1:]
        return numpy.concatenate([v.ravel(), (force / mass[:, None] - [0, p["gravity"]]).ravel()])

    y0 = numpy.concatenate([start.ravel(), numpy.zeros(2 * elements)])
    def turning(_, y):
        (x, z), (u, w) = y.reshape(2, elements, 2)[:, -1] - [top, 0 * top]
        return x * w - z * u if p["end_x"] != p["support_x"] else w

    solution = solve_ivp(rate, (0, times[-1]), y0, method="DOP853", t_eval=times, rtol=1e-8, atol=1e-10, events=turning)
    rows = []
    for y in solution.y.T:
        x, v = y.reshape(2, elements, 2)
        pull, _, strain = tensions(x)
        rows.append([*x[-1], *v[-1], pull[0], 0.5 * (mass[:, None] * v**2).sum(), 0.5 * (pull * strain).sum() * rest,
                     p["gravity"] * (mass * (x - start)[:, 1]).sum()])
    turns = [(t, *y.reshape(2, elements, 2)[0, -1]) for t, y in zip(solution.t_events[0], solution.y_events[0]) if t > 1e-9]
    return numpy.array(rows), turns


def answer(p, elements, times):
    rows = evaluate([request("bar-chain", p | {"elements": elements}, times)])[0][4:]
    return [rows[first : first + 8] for first in range(0, len(rows), 8)]


def margin_of(name):
    """Both tolerances are below 1e-7 of the motion; what the elements of a slack string do on their own grows from rounding: they
    carry 1e-3 of the mass."""
    return 1e-3 if name == "slack" else 1e-5


@pytest.mark.parametrize("name", CHAINS)
def test_the_same_chain_moves_the_same(name):
    p, last = CHAINS[name]
    times = last * numpy.array([0.11, 0.4, 0.73, 1.0])
    (other, _), rows = integrate(p, 4, times), answer(p, 4, times)
    scale = numpy.abs(other).max(axis=0) + 1e-3
    scale[4] = p["mass"] * p["gravity"]
    kept = [0, 1, 2, 3, 5, 7] if name == "slack" else range(8)  # not the tension of a single element, which shows all that it does
    assert all(is_near(row[k], own[k], margin_of(name) * scale[k]) for row, own in zip(rows, other) for k in kept)


def test_finer_chains_lie_within_the_bound():
    p, last = CHAINS["pendulum"]
    times = last * numpy.array([0.2, 0.4, 0.6, 1.0])
    coarse, (fine, _) = answer(p, 8, times), integrate(p, 24, times)
    assert all(agrees(got, own) for row, finer in zip(coarse, fine) for got, own in zip(row[:4], finer[:4]))


@pytest.mark.parametrize("name", CHAINS)
def test_the_same_chain_turns_alike(name):
    p, last = CHAINS[name]
    _, turns = integrate(p, 4, [3.5 * last])
    period, time, x, y = evaluate([request("bar-chain", p | {"elements": 4})])[0]
    size = numpy.hypot(p["end_x"] - p["support_x"], p["end_y"] - p["support_y"])
    of_time, of_place = margin_of(name) * last, margin_of(name) * size
    assert is_near(period, turns[1][0], of_time) and is_near(time, turns[0][0], of_time)
    assert is_near(x, turns[0][1], of_place) and is_near(y, turns[0][2], of_place)
