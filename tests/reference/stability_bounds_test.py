"""A thousand random bars and oscillators against 50-digit arithmetic: the true error is within the bound, always."""
import mpmath
import numpy
import pytest
from evaluator import evaluate, request
from second_values import agrees

mp = mpmath.mp
mp.dps = 50
R = mpmath.mpf
USL = 2
METHODS = ("forward_euler", "explicit_midpoint", "symplectic_euler", "leapfrog", "ssp_rk3", "rk4", "newmark_trapezoid",
           "newmark_linear", "generalized_alpha")


def covers(answer, true):
    return agrees(answer, R(true))


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


def edge_limit(points, spacing, integrator):
    """Tents, FLIP: 1/C^2 is the largest eigenvalue of G W G', W = M^-1 S'm S M^-1/4, or (2 M^-1 - that)/4."""
    nodes = range(int(mpmath.floor(points[0])), int(mpmath.floor(points[-1])) + 2)
    weight, gradient = mpmath.matrix(len(points), len(nodes)), mpmath.matrix(len(points), len(nodes))
    for p, x in enumerate(points):
        below = int(mpmath.floor(x)) - nodes[0]
        weight[p, below + 1] = x - mpmath.floor(x)
        weight[p, below] = 1 - weight[p, below + 1]
        gradient[p, below], gradient[p, below + 1] = -1, 1
    inverse = mpmath.diag([1 / (spacing * sum(weight[p, i] for p in range(len(points)))) for i in range(len(nodes))])
    kept = inverse * (weight.T * weight * spacing) * inverse
    burden = gradient * (2 * inverse - kept if integrator == USL else kept) * gradient.T * spacing / 4
    return 1 / mpmath.sqrt(max(mpmath.eigsy(burden, eigvals_only=True)))


def test_limits_of_edges():
    random = numpy.random.default_rng(2022)
    rows, requests = [], []
    for k in range(40):
        per_cell, cells, integrator = int(random.integers(1, 4)), int(random.integers(2, 4)), int(random.integers(4))
        depth = float(10 ** random.uniform(-6, 0)) / per_cell
        points = [R(-depth + i / per_cell) for i in range(per_cell * cells)]  # the doubles that the reference takes
        rows.append((edge_limit(points, R(1 / per_cell), integrator), (per_cell, cells, depth, integrator)))
        requests.append(request("mpm-edge-stability", dict(points_per_cell=per_cell, cells=cells, depth=depth,
                                                           integrator=integrator, transfer=1, shape=0)))
    for (true, case), answer in zip(rows, evaluate(requests)):
        assert covers(answer[0], true), (case, answer[0], true)
        # The mass of a node that a point barely touches is a difference: known to 1e-16 over the depth, of itself.
        assert answer[0][1] <= 1e-12 / min(case[2], 0.1) * answer[0][0], case


def oscillator(name, w, rho):
    """Coefficients of the characteristic polynomial, from the definitions."""
    w = R(w)
    order = {"forward_euler": 1, "explicit_midpoint": 2, "ssp_rk3": 3, "rk4": 4}.get(name)
    if order:
        return abs(sum((1j * w) ** k / mpmath.factorial(k) for k in range(order + 1)))
    if name != "generalized_alpha":
        beta = {"newmark_trapezoid": R(1) / 4, "newmark_linear": R(1) / 6}.get(name, R(0))
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
