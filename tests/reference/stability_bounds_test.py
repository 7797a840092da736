"""A thousand random bars, steps, and oscillators against 50-digit arithmetic: the true error is within the bound, always."""
import mpmath
import numpy
import pytest
from evaluator import evaluate, request

mp = mpmath.mp
mp.dps = 50
R = mpmath.mpf
USL = 2
METHODS = ("forward_euler", "explicit_midpoint", "symplectic_euler", "leapfrog", "ssp_rk3", "rk4", "newmark_trapezoid",
           "newmark_linear", "generalized_alpha")


def covers(answer, true):
    value, bound = answer
    return abs(R(value) - true) <= R(bound)


def greatest_on_unit(coefficients):
    """Of c1 s + c2 s^2 for 0 <= s <= 1: at the end or where the slope vanishes."""
    c1, c2 = coefficients
    at = [R(1)] + ([-c1 / (2 * c2)] if c2 and 0 < -c1 / (2 * c2) < 1 else [])
    return max(c1 * s + c2 * s * s for s in at)


def limit(weight, integrator):
    """C^2 s (1 -+ 4 N (1 - N) s) <= 1 for all s."""
    spread = 4 * R(weight) * (1 - R(weight))
    return 1 / mpmath.sqrt(greatest_on_unit((R(1), spread if integrator == USL else -spread)))


def growth(weight, integrator, courant):
    """The largest root at the extreme s: the end, or that of the largest stiffness."""
    spread, square = 4 * R(weight) * (1 - R(weight)), 4 * R(courant) ** 2
    if integrator == USL:
        x, determinant = square, 1 - square * spread
    else:
        x, determinant = square * greatest_on_unit((R(1), -spread)), R(1)
    roots = [(2 - x + sign * mpmath.sqrt((2 - x) ** 2 - 4 * determinant)) / 2 for sign in (1, -1)]
    return max(R(1), *(abs(root) for root in roots))


@pytest.fixture(scope="module")
def bars():
    random = numpy.random.default_rng(1997)
    rows, requests = [], []
    for k in range(1000):
        near = float(10 ** random.uniform(-12, -1))
        weight = float((random.uniform(), near, 1 - near, 0.5 + near / 2, 0.1464466094067262 + near)[k % 5])
        integrator = int(random.integers(4))
        true = limit(weight, integrator)
        courants = [float(true * R(1 + s * 10 ** random.uniform(-14, 0))) for s in (0.5, 1, -0.5)]
        rows.append((weight, integrator, true, courants))
        requests.append(request("bar-stability", dict(weight=weight, integrator=integrator), courants))
    return list(zip(rows, evaluate(requests)))


def test_limits_of_bars(bars):
    for (weight, integrator, true, _), answer in bars:
        assert covers(answer[0], true), (weight, integrator)
        assert answer[0][1] <= 1e-13
        assert covers(answer[1], 1 / mpmath.sqrt(1 - 3 * R(weight) * (1 - R(weight))))
        assert covers(answer[2], 1 / mpmath.sqrt(2)) and covers(answer[3], 1 / mpmath.sqrt(3))


def test_growth_of_bars(bars):
    for (weight, integrator, _, courants), answer in bars:
        for courant, got in zip(courants, answer[4:]):
            assert covers(got, growth(weight, integrator, courant)), (weight, integrator, courant, got)
            assert got[1] <= 1e-6  # the root of a rounding where two eigenvalues meet


def oscillator(name, w, rho):
    """Coefficients of the characteristic polynomial, from the definitions."""
    w = R(w)
    order = {"forward_euler": 1, "explicit_midpoint": 2, "ssp_rk3": 3, "rk4": 4}.get(name)
    if order:
        return abs(sum((1j * w) ** k / mpmath.factorial(k) for k in range(order + 1)))
    if name != "generalized_alpha":
        beta = {"symplectic_euler": R(0), "leapfrog": R(0), "newmark_trapezoid": R(1) / 4, "newmark_linear": R(1) / 6}[name]
        half = 1 - w * w / 2 / (1 + beta * w * w)  # z^2 - 2 half z + 1
        return R(1) if abs(half) <= 1 else abs(half) + mpmath.sqrt(half * half - 1)
    rho = R(rho)
    alpha = (2 * rho - 1) / (1 + rho)
    gamma, beta = R(3) / 2 - alpha, (5 - 3 * rho) / ((1 + rho) ** 2 * (2 - rho))
    share = w * w / (1 - alpha)
    m = mpmath.matrix([[1 - beta * share, 1, R(1) / 2 - beta - beta * alpha / (1 - alpha)],
                       [-gamma * share, 1, 1 - gamma - gamma * alpha / (1 - alpha)],
                       [-share, 0, -alpha / (1 - alpha)]])
    trace = m[0, 0] + m[1, 1] + m[2, 2]
    minors = sum(m[i, i] * m[j, j] - m[i, j] * m[j, i] for i, j in ((0, 1), (0, 2), (1, 2)))
    roots = mpmath.polyroots([1, -trace, minors, -mpmath.det(m)], maxsteps=500, extraprec=400, error=False)
    return max(abs(root) for root in roots)


def test_oscillators():
    random = numpy.random.default_rng(1996)
    rows, requests = [], []
    for k in range(1000):
        rho = float((random.uniform(), 10 ** random.uniform(-12, 0), 1 - 10 ** random.uniform(-12, 0))[k % 3])
        at = [float(random.uniform(0, 4)), float((1 + rho) * numpy.sqrt(2 - rho))] if k % 4 == 0 else []
        rows.append((rho, at))
        requests.append(request("oscillator-limits", dict(rho_b=rho), at))
    for (rho, at), answer in zip(rows, evaluate(requests)):
        r = R(rho)
        exact = [R(0), R(0), R(2), R(2), mpmath.sqrt(3), mpmath.sqrt(8), mpmath.sqrt(12),
                 mpmath.sqrt(12 * (1 + r) * (2 - r) / (10 - 5 * r + r * r)), (1 + r) * mpmath.sqrt(2 - r)]
        for got, true in zip(answer, exact):
            assert covers(got, true), (rho, got, true)
            assert got[1] <= 1e-14
        for i, w in enumerate(at):
            growths = answer[18 + i * len(METHODS) : 18 + (i + 1) * len(METHODS)]
            for name, got in zip(METHODS, growths):
                assert covers(got, oscillator(name, w, rho)), (name, w, rho, got)
                assert got[1] <= 1e-3 * got[0] + 1e-3  # at the triple root of the bifurcation
