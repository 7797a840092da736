"""Second, independent computations of strings, chains and bars: scipy and numpy on the differential equations."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import brentq


def values_of(answer):
    return [value for value, _ in answer]


@pytest.mark.parametrize("p", [
    dict(youngs_modulus=1e6, area=0.1, length=0.3, mass=3.33, gravity=250, slack=0.02),
    dict(youngs_modulus=3e4, area=0.02, length=0.8, mass=2.1, gravity=9.81, slack=0.13)], ids=["york", "soft"])
def test_slack_string_by_integration(p):
    """m d'' = m g - k max(0, d - slack), stopped at each change of the string; rtol 1e-12, three decades of margin."""
    k = p["youngs_modulus"] * p["area"] / p["length"]
    changes, lowest = [], 0
    state, time, carries = [0.0, 0.0], 0.0, False
    end = 3 * numpy.sqrt(8 * p["slack"] / p["gravity"]) + 20 * numpy.sqrt(p["mass"] / k)
    track_times, track = [], []
    while time < end:
        def motion(_, y, pulls=carries):
            return y[1], p["gravity"] - (k / p["mass"] * (y[0] - p["slack"]) if pulls else 0)
        def border(_, y):
            return y[0] - p["slack"]
        border.terminal, border.direction = True, -1 if carries else 1
        path = solve_ivp(motion, (time, end), state, method="DOP853", rtol=1e-12, atol=1e-15, events=border,
                         dense_output=True)
        inner = numpy.linspace(time, path.t[-1], 6)[1:-1]
        track_times += list(inner)
        track += [path.sol(t) for t in inner]
        if carries:
            lowest = max(lowest, path.sol(0.5 * (time + path.t[-1]))[0])
        time, state = path.t[-1], [p["slack"], path.y[1, -1]]
        if path.t_events[0].size:
            changes.append(time)
        carries = not carries
    answer = evaluate([request("slack-string", p, track_times)])[0]
    taut, release, apex, _, deepest = values_of(answer)[:5]
    assert changes[:3] == pytest.approx([taut, release, apex + taut], rel=1e-9)
    assert deepest == pytest.approx(lowest, rel=1e-9)
    rows = numpy.array(values_of(answer[6:])).reshape(-1, 3)[:, :2]
    scale = numpy.array([deepest, answer[3][0]])
    assert numpy.abs(rows - track) / scale == pytest.approx(0, abs=1e-8)


def chain_elements(length, gravity, n):
    """Frequencies of a hanging chain of unit line density: linear elements, tension linear, consistent masses."""
    h = length / n
    stiffness, mass = numpy.zeros((n + 1, n + 1)), numpy.zeros((n + 1, n + 1))
    for e in range(n):
        pull = gravity * (e + 0.5) * h / h
        stiffness[e : e + 2, e : e + 2] += pull * numpy.array([[1, -1], [-1, 1]])
        mass[e : e + 2, e : e + 2] += h / 6 * numpy.array([[2, 1], [1, 2]])
    return numpy.sqrt(eigh(stiffness[:-1, :-1], mass[:-1, :-1], eigvals_only=True))


@pytest.mark.parametrize("length,gravity", [(1, 9.81), (3.7, 0.6)])
def test_hanging_chain_by_finite_elements(length, gravity):
    """Errors in h^2, h^4: one Richardson step, and its last correction bounds what is left by far."""
    coarse, middle, fine = (chain_elements(length, gravity, n)[:4] for n in (100, 200, 400))
    first, second = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    for mode in range(4):
        omega = evaluate([request("hanging-chain", dict(length=length, gravity=gravity, mode=mode + 1))])[0][1][0]
        assert abs(omega - second[mode]) <= abs(second[mode] - first[mode]) + 1e-10 * omega
        assert abs(second[mode] - first[mode]) <= 1e-5 * omega


@pytest.mark.parametrize("mode", [1, 3])
def test_hanging_chain_shape_by_integration(mode):
    """g (s y')' = -w^2 y from the free end, series start, rtol 1e-12."""
    length, gravity, at = 2.0, 3.0, [0.1, 0.7, 1.3, 1.9]
    p = dict(length=length, gravity=gravity, mode=mode, amplitude=1.0)
    answer = evaluate([request("hanging-chain", p, at)])[0]
    square = answer[1][0] ** 2 / gravity
    start = 1e-6
    def bending(s, y):  # y, s y'
        return y[1] / s, -square * y[0]
    first = [1 - square * start + (square * start) ** 2 / 4, start * (-square + square**2 * start / 2)]
    path = solve_ivp(bending, (start, length), first, method="DOP853", rtol=1e-12, atol=1e-14, t_eval=[*at, length])
    rows = numpy.array(values_of(answer[5:])).reshape(-1, 4)
    assert rows[:, 0] == pytest.approx(path.y[0, :-1], abs=1e-9)
    assert rows[:, 2] == pytest.approx(path.y[1, :-1] / at, abs=1e-8)
    assert path.y[0, -1] == pytest.approx(0, abs=1e-9)


@pytest.mark.parametrize("span,length,weight,compliance", [(1, 1.2, 1, 0), (3, 9, 0.4, 0), (2, 1.5, 4, 0.05),
                                                           (300, 310, 46, 1.4e-8), (1, 1, 2, 1e-3)])
def test_catenary_by_shooting(span, length, weight, compliance):
    """Equilibrium integrated from the left support, x' = (1 + c T) H/T, y' = -(1 + c T) V/T, V' = -w; the horizontal
    force H by the distance at the other end. rtol 1e-12."""
    at = numpy.array([0.2, 0.5, 0.9]) * length
    def shape(force, times):
        def slope(s, y):
            vertical = weight * (0.5 * length - s)
            pull = numpy.hypot(force, vertical)
            stretch = 1 + compliance * pull
            return stretch * force / pull, -stretch * vertical / pull, stretch
        return solve_ivp(slope, (0, length), (0, 0, 0), method="DOP853", rtol=1e-12, atol=1e-14 * span, t_eval=times)
    p = dict(span=span, length=length, weight=weight, compliance=compliance)
    answer = evaluate([request("catenary", p, at)])[0]
    guess = answer[2][0]
    force = brentq(lambda f: shape(f, [length]).y[0, -1] - span, 0.5 * guess, 2 * guess, rtol=1e-13)
    path = shape(force, [*at, length])
    condition = 1 + span / abs(length - span) if compliance == 0 else 100
    assert guess == pytest.approx(force, rel=1e-10 * condition)
    assert answer[4][0] == pytest.approx(path.y[2, -1], rel=1e-10)
    assert answer[1][0] == pytest.approx(-shape(force, [0.5 * length]).y[1, -1], rel=1e-10 * condition)
    rows = numpy.array(values_of(answer[5:])).reshape(-1, 4)
    assert rows[:, 0] == pytest.approx(path.y[0, :-1], rel=1e-9)
    assert rows[:, 1] == pytest.approx(path.y[1, :-1], rel=1e-9 * condition)
    assert rows[:, 2] == pytest.approx(numpy.hypot(force, weight * (0.5 * length - at)), rel=1e-10 * condition)


@pytest.mark.parametrize("amplitude", [1e-3, 0.05, 0.6])
def test_kirchhoff_period_by_integration(amplitude):
    """q'' = -w^2 (1 + k^2 q^2/(4 eps0)) q until q = 0: a quarter of the period."""
    p = dict(youngs_modulus=3e5, area=0.02, density=4, strain=0.003, length=1.3, mode=2, amplitude=amplitude)
    answer = evaluate([request("string-vibration", p)])[0]
    k = 2 * numpy.pi / 1.3
    omega = k * numpy.sqrt(3e5 * 0.003 / 4)
    assert answer[2][0] == pytest.approx(omega, rel=1e-14)
    def motion(_, y):
        return y[1], -(omega**2) * (1 + (k * y[0]) ** 2 / (4 * 0.003)) * y[0]
    def passes(_, y):
        return y[0]
    passes.terminal = True
    path = solve_ivp(motion, (0, 9 / omega), (amplitude, 0), method="DOP853", rtol=1e-13, atol=1e-16, events=passes)
    assert answer[4][0] == pytest.approx(4 * path.t[-1], rel=1e-10)


def line_elements(stiffness, mass, length, n, free_end):
    """Frequencies of an elastic line fixed on the left: linear elements, consistent masses, by length."""
    h = length / n
    k = stiffness / h * (2 * numpy.eye(n) - numpy.eye(n, k=1) - numpy.eye(n, k=-1))
    m = mass * h / 6 * (4 * numpy.eye(n) + numpy.eye(n, k=1) + numpy.eye(n, k=-1))
    k[-1, -1] /= 2
    m[-1, -1] /= 2
    kept = slice(None) if free_end else slice(0, -1)
    return numpy.sqrt(eigh(k[kept, kept], m[kept, kept], eigvals_only=True))


@pytest.mark.parametrize("name,p,stiffness,mass,free_end", [
    ("string-vibration", dict(youngs_modulus=3e5, area=0.02, density=4, strain=0.003, length=1.3), 18.0, 0.08, False),
    ("bar-vibration", dict(youngs_modulus=100, density=1, area=1, length=25), 100.0, 1.0, True),
    ("bar-vibration", dict(youngs_modulus=2e5, density=7.8, area=0.3, length=1.9), 6e4, 2.34, True)])
def test_modes_by_finite_elements(name, p, stiffness, mass, free_end):
    coarse, middle, fine = (line_elements(stiffness, mass, p["length"], n, free_end)[:4] for n in (50, 100, 200))
    first, second = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    for mode in range(4):
        answer = evaluate([request(name, {**p, "mode": mode + 1})])[0]
        omega = answer[2 if name == "string-vibration" else 1][0]
        assert abs(omega - second[mode]) <= abs(second[mode] - first[mode]) + 1e-10 * omega
        assert abs(second[mode] - first[mode]) <= 1e-4 * omega


@pytest.mark.parametrize("left_fixed", [0, 1])
@pytest.mark.parametrize("right_fixed", [0, 1])
def test_bar_riemann_on_a_lattice(left_fixed, right_fixed):
    """Invariants moved by one cell a step: exact where jumps lie on cell edges. c = 2, rho c = 6, 30 cells of 0.1."""
    v, s = numpy.where(numpy.arange(30) < 11, 0.4, -1.1), numpy.where(numpy.arange(30) < 11, -2.0, 5.0)
    right, left, moved = v - s / 6, v + s / 6, numpy.zeros(30)
    settings = {"youngs_modulus": 12, "density": 3, "length": 3, "middle": 1.1, "left.velocity": 0.4, "left.stress": -2,
                "right.velocity": -1.1, "right.stress": 5, "left.fixed": left_fixed, "right.fixed": right_fixed}
    places = 0.1 * (numpy.arange(30) + 0.5)
    for step in range(1, 200):
        before = (right + left) / 2
        out_right, out_left = right[-1], left[0]
        right = numpy.concatenate([[-out_left if left_fixed else out_left], right[:-1]])
        left = numpy.concatenate([left[1:], [-out_right if right_fixed else out_right]])
        moved += 0.05 * (before + (right + left) / 2) / 2  # each front passes a middle at half of the step
        if step % 17 == 0:
            answer = evaluate([request("bar-riemann", {**settings, "time": 0.05 * step}, places)])[0]
            rows = numpy.array(values_of(answer[5:])).reshape(-1, 3)
            assert rows[:, 1] == pytest.approx((right + left) / 2, abs=1e-12)
            assert rows[:, 2] == pytest.approx(3 * (left - right), abs=1e-11)
            assert rows[:, 0] == pytest.approx(moved, abs=1e-11)


def test_bar_impact_by_unilateral_springs():
    """Two rows of 400 masses and springs, with a spring between them that only pushes: discrete bars ring at their
    fronts, so contact lasts 2 L/c and the mean velocities are exchanged up to the width of a front, (c t)^(1/3) cells."""
    n, L, E, rho = 400, 1.25, 1e5, 1.0
    h, c = L / n, numpy.sqrt(E / rho)
    x = numpy.concatenate([numpy.linspace(h / 2, L - h / 2, n), L + numpy.linspace(h / 2, L - h / 2, n)])
    start, v = x.copy(), numpy.where(numpy.arange(2 * n) < n, 2.0, 0.0)
    step, released, touched = 0.5 * h / c, None, False
    for i in range(int(1.4 * 2 * L / c / step)):
        pull = E * (numpy.diff(x - start) / h)
        pull[n - 1] = min(pull[n - 1], 0)
        touched = touched or pull[n - 1] < 0
        if touched and released is None and pull[n - 1] == 0 and i * step > L / c:
            released = i * step
        force = numpy.concatenate([pull, [0]]) - numpy.concatenate([[0], pull])
        v += step * force / (rho * h)
        x += step * v
        if abs(i * step - L / c) < step / 2:
            half_way = numpy.mean(pull)
    answer = evaluate([request("bar-impact", dict(gap=0, time=1))])[0]
    margin = n ** (1 / 3) / n  # the width of the front over the bar
    assert released == pytest.approx(answer[3][0], rel=margin)
    assert half_way == pytest.approx(answer[4][0], rel=margin)
    assert v[:n].mean() == pytest.approx(0, abs=2 * margin)
    assert v[n:].mean() == pytest.approx(2, abs=2 * margin)
