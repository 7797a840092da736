"""Second, independent computations of the elastic pendulum: scipy in Cartesian coordinates, and a string with mass."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.special import ellipk
from second_values import agrees, is_near

YORK = dict(pivot_x=0.33333, pivot_y=0.99990, bob_x=0.101, bob_y=0.303, mass=3.3, gravity=20, youngs_modulus=1e6,
            area=0.1, density=0.1, strain=0)
SOFT = dict(pivot_x=0, pivot_y=0, bob_x=1.2, bob_y=-1.1, mass=2, gravity=9.81, youngs_modulus=700, area=0.5, density=0,
            strain=0.09)


def geometry(p):
    across, down = p["bob_x"] - p["pivot_x"], p["bob_y"] - p["pivot_y"]
    rest = numpy.hypot(across, down) / (1 + p["strain"])
    return across, down, rest, p["youngs_modulus"] * p["area"] / rest


@pytest.mark.parametrize("p", [YORK, SOFT], ids=["york", "soft"])
@pytest.mark.parametrize("one_way", [0, 1])
def test_motion(p, one_way):
    """DOP853, rtol 1e-12, stopped where the string changes; late in a soft slack flight an error of 1e-12 has grown."""
    across, down, rest, k = geometry(p)
    times = numpy.array([0.1, 0.5, 1.0, 1.9])
    time, state, carries = 0.0, [across, down, 0.0, 0.0], True
    found, turns = [], []
    while time < 3:
        def motion(_, y, pulls=carries):
            r = numpy.hypot(y[0], y[1])
            f = k / p["mass"] * (1 - rest / r) if pulls else 0
            return y[2], y[3], -f * y[0], -f * y[1] - p["gravity"]
        def border(_, y):
            return numpy.hypot(y[0], y[1]) - rest
        def turning(_, y):
            return y[0] * y[3] - y[1] * y[2]
        border.terminal, border.direction = True, -1 if carries else 1
        path = solve_ivp(motion, (time, 3), state, method="DOP853", rtol=1e-12, atol=1e-13,
                         events=[border, turning] if one_way else [turning], dense_output=True)
        found += [path.sol(t) for t in times if time < t <= path.t[-1]]
        turns += [t for t in path.t_events[-1] if t > 1e-6]
        time, state = path.t[-1], path.y[:, -1]
        carries = not carries
    answer = evaluate([request("elastic-pendulum", {**p, "one_way": one_way}, times)])[0]
    assert [answer[3][0], answer[0][0]] == pytest.approx(turns[:2], rel=1e-8)
    rows = numpy.array([value for value, _ in answer[12:]]).reshape(-1, 7)
    assert rows[:, 0] == pytest.approx(p["pivot_x"] + numpy.array(found)[:, 0], abs=1e-7)
    assert rows[:, 1] == pytest.approx(p["pivot_y"] + numpy.array(found)[:, 1], abs=1e-7)
    assert rows[:, 2] == pytest.approx(numpy.array(found)[:, 2], abs=1e-5)


def test_rigid_period_is_scipys():
    across, down, rest, _ = geometry(YORK)
    square = numpy.sin(numpy.arctan2(across, -down) / 2) ** 2
    answer = evaluate([request("elastic-pendulum", YORK)])[0]
    period = 4 * numpy.sqrt(rest / 20) * ellipk(square)
    assert is_near(answer[2], period, 1e-13 * period)


@pytest.mark.parametrize("p", [YORK | dict(density=0.7), SOFT | dict(density=0.2)], ids=["york", "soft"])
def test_what_the_string_is_made_of(p):
    """Hooke's law of the string, and Rayleigh's estimate of its mass: a third in the inertia, a half in the weight."""
    across, down, rest, k = geometry(p)
    answer = {got.name: got for got in evaluate([request("elastic-pendulum", p)])[0]}
    ratio = p["density"] * p["area"] * rest / p["mass"]
    heavy = answer["period"].value * numpy.sqrt((1 + ratio / 3) / (1 + ratio / 2))
    own = dict(stiffness=k, axial_omega=numpy.sqrt(k / p["mass"]), rest_length=rest, angle=numpy.arctan2(across, -down),
               heavy_period=heavy)
    for name, one in own.items():
        assert is_near(answer[name], one, 1e-13 * abs(one)), name


def heavy_period(angle, kappa, ratio, elements):
    """Masses and springs in a row, the string's mass lumped (half of an element's at the bob); start straight and
    unstretched. Units: L0, sqrt(L0/g), the bob's mass."""
    n = elements
    mass = numpy.full(n, ratio / n)
    mass[-1] = 1 + ratio / (2 * n)
    direction = numpy.array([numpy.sin(angle), -numpy.cos(angle)])
    start = numpy.concatenate([(numpy.outer(numpy.arange(1, n + 1) / n, direction)).ravel(), numpy.zeros(2 * n)])
    def motion(_, y):
        place, speed = y[: 2 * n].reshape(n, 2), y[2 * n :]
        link = numpy.diff(place, axis=0, prepend=numpy.zeros((1, 2)))
        length = numpy.sqrt((link * link).sum(axis=1))
        pull = (kappa * (length * n - 1) / length)[:, None] * link
        force = -pull
        force[:-1] += pull[1:]
        push = force / mass[:, None]
        push[:, 1] -= 1
        return numpy.concatenate([speed, push.ravel()])
    def turning(_, y):
        return y[2 * n - 2] * y[4 * n - 1] - y[2 * n - 1] * y[4 * n - 2]
    path = solve_ivp(motion, (0, 8), start, method="DOP853", rtol=1e-8, atol=1e-11, events=turning)
    turns = path.t_events[0]
    # turning points of the bob: the string's small waves add others close by; those of the two swings lie near 3 and 6
    return turns[turns > 5][0]


@pytest.mark.parametrize("angle,kappa,ratio", [(0.32, 100, 0.05), (0.9, 100, 0.1)])
def test_mass_of_the_string(angle, kappa, ratio):
    """Two fineness levels and Richardson (errors in 1/n^2); the remainder is below the last correction."""
    coarse, fine = heavy_period(angle, kappa, ratio, 4), heavy_period(angle, kappa, ratio, 8)
    period = (4 * fine - coarse) / 3
    p = dict(pivot_x=0, pivot_y=0, bob_x=float(numpy.sin(angle)), bob_y=float(-numpy.cos(angle)), mass=1, gravity=1,
             area=1, youngs_modulus=kappa, density=ratio, strain=0, one_way=0)
    answer = evaluate([request("elastic-pendulum", p)])[0]
    light, (heavy, bound) = answer[0][0], answer[1]
    assert agrees(answer[1], period, abs(fine - coarse) / 3)
    assert bound <= 0.5 * abs(heavy - light)  # the correction is known to better than half of itself
    assert abs(period - light) > abs(period - heavy)
