"""Membranes in space a second time: scipy on the differential equations of motion and of equilibrium."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp

SPHERES = {
    "default": dict(amplitude=0.05),
    "unstretched": dict(youngs_modulus=2.0, poisson_ratio=0.45, radius=0.7, stretch=1.0, amplitude=-0.3),
    "balloon": dict(youngs_modulus=3.0, thickness=0.02, density=2.0, radius=0.4, stretch=1.25, neo_hookean=1.0,
                    amplitude=0.2),
}


@pytest.mark.parametrize("name", SPHERES)
def test_sphere_by_integration(name):
    """rho t R0 l'' = p l^2 - 2 t l S/R0 from rest until it is at rest again; rtol 1e-12, three decades of margin."""
    p = dict(youngs_modulus=1.0, poisson_ratio=0.3, thickness=0.01, density=1.0, radius=1.0, stretch=1.05,
             neo_hookean=0.0) | SPHERES[name]
    def stress(l):
        if p["neo_hookean"]:
            return p["youngs_modulus"] / 3 * (1 - l**-6)
        return p["youngs_modulus"] / (1 - p["poisson_ratio"]) * (l**2 - 1) / 2
    pressure = 2 * p["thickness"] * stress(p["stretch"]) / (p["stretch"] * p["radius"])
    mass = p["density"] * p["thickness"] * p["radius"]
    def motion(_, y):
        return y[1], (pressure * y[0] ** 2 - 2 * p["thickness"] * y[0] * stress(y[0]) / p["radius"]) / mass
    def rests(_, y):
        return y[1]
    answer = evaluate([request("pressurised-sphere", p)])[0]
    path = solve_ivp(motion, (0, 2.2 * answer[3][0]), [p["stretch"] + p["amplitude"], 0.0], method="DOP853", rtol=1e-12,
                     atol=1e-14, events=rests)
    times, states = path.t_events[0], path.y_events[0]
    half, whole = [i for i, t in enumerate(times) if t > 0.1 * times.max()][:2]
    assert answer[0][0] == pytest.approx(pressure, rel=1e-13)
    assert [2 * times[half], times[whole]] == pytest.approx([answer[3][0]] * 2, rel=1e-9)
    assert states[half][0] == pytest.approx(answer[4][0], rel=1e-9)


@pytest.mark.parametrize("around, across", [(0, 1), (1, 1), (2, 1), (3, 2)])
def test_drum_by_integration(around, across):
    """w'' + w'/x + (1 - m^2/x^2) w = 0 from its power series at x = 0.1, until w vanishes for the n-th time."""
    start, m = 0.1, around
    series = [1, -1 / (4 * (m + 1)), 1 / (32 * (m + 1) * (m + 2)), -1 / (384 * (m + 1) * (m + 2) * (m + 3))]
    first = [sum(c * start ** (m + 2 * k) for k, c in enumerate(series)),
             sum(c * (m + 2 * k) * start ** (m + 2 * k - 1) for k, c in enumerate(series))]
    def motion(x, y):
        return y[1], -y[1] / x - (1 - m**2 / x**2) * y[0]
    def vanishes(_, y):
        return y[0]
    path = solve_ivp(motion, (start, 15), first, method="DOP853", rtol=1e-12, atol=1e-14, events=vanishes,
                     dense_output=True)
    zero = path.t_events[0][across - 1]
    p = dict(radius=0.4, tension=30.0, area_density=0.07, around=around, across=across)
    places = [0.1, 0.25, 0.37]
    answer = evaluate([request("drum", p, places)])[0]
    assert answer[3][0] == pytest.approx(zero / 0.4 * numpy.sqrt(30 / 0.07), rel=1e-9)
    shape = numpy.array([path.sol(zero * r / 0.4)[0] for r in places]) / (2.0**m * numpy.prod(range(1, m + 1)))
    assert [value for value, _ in answer[4:]] == pytest.approx(shape, abs=1e-10)
