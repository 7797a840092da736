"""A second, independent computation of the Riemann problem: scipy, other formulas.

Star state: brentq on the Hugoniot locus and the integral curve in the form of R. J. LeVeque, Finite Volume Methods for
Hyperbolic Problems, 2002, section 14.11. Fan: the characteristic equations integrated as an ODE. brentq stops at 4 eps
of p, so 1e-11 leaves three decades for the conditioning of these problems; the ODE has rtol = 1e-12, so 1e-9 leaves as
much.
"""
import numpy
import pytest
from evaluator import evaluate, request
from riemann_bounds_test import settings
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

CASES = {
    "sod": ((1, 0, 1), (0.125, 0, 0.1), 1.4),
    "toro-1-moving": ((1, 0.75, 1), (0.125, 0, 0.1), 1.4),
    "123": ((1, -2, 0.4), (1, 2, 0.4), 1.4),
    "left-blast": ((1, 0, 1000), (1, 0, 0.01), 1.4),
    "right-blast": ((1, 0, 0.01), (1, 0, 100), 1.4),
    "collision": ((5.99924, 19.5975, 460.894), (5.99242, -6.19633, 46.0950), 1.4),
    "stationary-contact": ((1, -19.59745, 1000), (1, -19.59745, 0.01), 1.4),
    "lax": ((0.445, 0.698, 3.528), (0.5, 0, 0.571), 1.4),
    "leblanc": ((1, 0, 2 / 30), (1e-3, 0, 2e-10 / 3), 5 / 3),
    "monatomic-1.67": ((2.3, -0.4, 7.1), (0.37, 0.9, 0.55), 1.67),
    "stiff-3": ((0.2, 3, 11), (4, -1, 0.6), 3.0),
}


def locus(side, p, gamma):
    """Velocity relative to the gas on the curve of states that one wave can reach (LeVeque, section 14.11)."""
    density, _, own = side
    c = numpy.sqrt(gamma * own / density)
    if p > own:
        beta = (gamma + 1) / (gamma - 1)
        return 2 * c / numpy.sqrt(2 * gamma * (gamma - 1)) * (1 - p / own) / numpy.sqrt(1 + beta * p / own)
    return 2 * c / (gamma - 1) * (1 - (p / own) ** ((gamma - 1) / (2 * gamma)))


def star(left, right, gamma):
    def gap(p):
        return left[1] + locus(left, p, gamma) - right[1] + locus(right, p, gamma)
    p = brentq(gap, 1e-12 * min(left[2], right[2]), 1e3 * (left[2] + right[2]) + 1e3, xtol=1e-300, rtol=1e-15)
    def density(side):
        beta = (gamma + 1) / (gamma - 1)
        ratio = p / side[2]
        return side[0] * ((1 + beta * ratio) / (ratio + beta) if ratio > 1 else ratio ** (1 / gamma))
    return p, left[1] + locus(left, p, gamma), density(left), density(right)


@pytest.mark.parametrize("name", CASES)
def test_star_state_agrees(name):
    left, right, gamma = CASES[name]
    answer = evaluate([request("riemann", settings(left, right, gamma))])[0]
    speeds = [abs(s[1]) + numpy.sqrt(gamma * s[2] / s[0]) for s in (left, right)]
    for i, (other, (value, bound)) in enumerate(zip(star(left, right, gamma), answer)):
        scale = max(speeds) if i == 1 else abs(other)
        assert abs(value - other) <= bound + 1e-11 * scale


@pytest.mark.parametrize("name", ["sod", "123", "left-blast", "lax", "leblanc", "monatomic-1.67"])
def test_fan_agrees_with_the_characteristic_equations(name):
    """In the left fan u - c = xi and dp = c^2 drho, dp = -rho c du."""
    left, right, gamma = CASES[name]
    p_star, u_star, density_star, _ = star(left, right, gamma)
    assert p_star < left[2]
    c = numpy.sqrt(gamma * left[2] / left[0])
    head, tail = left[1] - c, u_star - numpy.sqrt(gamma * p_star / density_star)
    rays = head + (tail - head) * numpy.linspace(0.05, 0.95, 7)
    def slopes(_, state):
        density, _, p = state
        a = numpy.sqrt(gamma * p / density)
        u_slope = 2 / (gamma + 1)
        return [-density / a * u_slope, u_slope, -density * a * u_slope]
    ode = solve_ivp(slopes, (head, tail), left, t_eval=rays, rtol=1e-12, atol=1e-18, method="DOP853")
    answer = evaluate([request("riemann", settings(left, right, gamma), rays)])[0][4:]
    speed = abs(head) + c
    for i in range(len(rays)):
        density, velocity, pressure, energy = (pair[0] for pair in answer[4 * i : 4 * i + 4])
        assert density == pytest.approx(ode.y[0, i], rel=1e-9)
        assert velocity == pytest.approx(ode.y[1, i], abs=1e-9 * speed)
        assert pressure == pytest.approx(ode.y[2, i], rel=1e-9)
        assert energy == pytest.approx(ode.y[2, i] / ode.y[0, i] / (gamma - 1), rel=1e-9)
