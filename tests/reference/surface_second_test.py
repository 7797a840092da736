"""Membranes in space a second time: scipy on the differential equations of motion and of equilibrium."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, minimize
from second_values import is_near

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


SHEETS = {
    "clamped": ("circular-membrane", dict(load=0.05, poisson_ratio=0.3)),
    "clamped far": ("circular-membrane", dict(load=0.5, poisson_ratio=0.1)),
    "balloon": ("mylar-balloon", dict(load=0.01, poisson_ratio=0.3)),
    "balloon far": ("mylar-balloon", dict(load=0.3, poisson_ratio=0.45)),
}


def sheet(q, nu, strain, dense=False):
    """r, radial force s S1 r', drop and volume from next to the middle to s = 1, one-way law everywhere:
    S1 = max(e1, (e1 + nu e2)/(1 - nu^2)) decides by itself where the sheet wrinkles."""
    start, stretch = 1e-5, numpy.sqrt(1 + 2 * strain)
    def along(s, y):
        r, pull, _, _ = y
        down = q * r**2 / 2
        force = numpy.hypot(pull, down)
        hoop = ((r / s) ** 2 - 1) / 2
        def largest_root(b, c):  # of l^3 + b l = 2 c, one root above 0
            return max(root.real for root in numpy.roots([1, 0, b, -2 * c]) if abs(root.imag) < 1e-9 * abs(root))
        l = min(largest_root(2 * nu * hoop - 1, (1 - nu**2) * force / s), largest_root(-1, force / s))
        across = max(0, hoop + nu * (l**2 - 1) / 2) / (1 - nu**2)
        fall = l * down / force
        return [l * pull / force, across * r / s - q * r * fall, fall, numpy.pi * r**2 * fall]
    first = [stretch * start, start * strain / (1 - nu) * stretch, 0, 0]
    return solve_ivp(along, (start, 1), first, method="DOP853", rtol=1e-10, atol=1e-13, dense_output=dense)


@pytest.mark.parametrize("name", SHEETS)
def test_sheet_by_shooting(name):
    """Begins within 2 % of the strain under test; start and steps are good for 1e-9."""
    kind, p = SHEETS[name]
    q, nu, clamped = p["load"], p["poisson_ratio"], kind == "circular-membrane"
    places = [0.3, 0.7, 0.95]
    answers = evaluate([request(kind, p, places)])[0]
    answer = [value for value, _ in answers]
    tested = (1 - nu) * answer[1 if clamped else 3]
    def missed(strain):
        r, pull, _, _ = sheet(q, nu, strain).y[:, -1]
        return r - 1 if clamped else pull
    strain = brentq(missed, 0.98 * tested, 1.02 * tested, rtol=1e-12)
    path = sheet(q, nu, strain, dense=True)
    r, _, drop, volume = path.y[:, -1]
    values = [drop, strain / (1 - nu), volume] if clamped else [r, drop, 2 * volume, strain / (1 - nu)]
    assert all(is_near(got, own, 1e-7 * abs(own)) for got, own in zip(answers, values))
    for j, s in enumerate(places):
        row = answers[len(values) + (not clamped) + 5 * j:]
        at = path.sol(s)
        assert is_near(row[0], at[0], 1e-7) and is_near(row[1], drop - at[2], 1e-7)


SHEARED = {
    "wrinkled": dict(stretch=1.0, shear=0.05),
    "taut": dict(stretch=1.08, shear=0.03, poisson_ratio=0.45),
    "slack": dict(stretch=0.9, shear=0.05),
    "nearly taut": dict(stretch=1.03, shear=0.042),
}


def relaxed_energy(strain, modulus, nu):
    """The least energy of plane stress that wrinkles reach: they add any strain without negative eigenvalues, B B^T with B
    lower triangular."""
    def energy(e):
        return modulus / (2 * (1 - nu**2)) * ((1 - nu) * (e * e).sum() + nu * numpy.trace(e) ** 2)
    def wrinkled(b):
        lower = numpy.array([[b[0], 0.0], [b[1], b[2]]])
        return energy(strain + lower @ lower.T) / modulus
    found = [minimize(wrinkled, start, method="BFGS", options=dict(gtol=1e-12))
             for start in ([0.3, 0.0, 0.3], [0.1, 0.2, 0.1], [0.2, -0.2, 0.05], [0.01, 0.01, 0.01])]
    return modulus * min(run.fun for run in found)


@pytest.mark.parametrize("name", SHEARED)
def test_tension_field_by_wrinkles(name):
    """Wrinkles of least energy, in axes turned at random; the minimum is flat, so energies are good for 1e-9, stresses by
    differences of 1e-4 for 1e-4."""
    p = dict(youngs_modulus=3.0, poisson_ratio=0.3, along=2, across=1, half_side=0.7, density=2.0) | SHEARED[name]
    energy, along, across, _, _, omega = [value for value, _ in evaluate([request("tension-field", p)])[0]]
    modulus, nu, angle = p["youngs_modulus"], p["poisson_ratio"], 0.4
    turn = numpy.array([[numpy.cos(angle), -numpy.sin(angle)], [numpy.sin(angle), numpy.cos(angle)]])
    stretches = p["stretch"] * numpy.array([1 + p["shear"], 1 - p["shear"]])
    strains = (stretches**2 - 1) / 2
    def relaxed(e):
        return relaxed_energy(turn @ numpy.diag(e) @ turn.T, modulus, nu)
    assert energy == pytest.approx(relaxed(strains), abs=1e-9 * modulus)
    d = 1e-4
    slopes = [(relaxed(strains + step) - relaxed(strains - step)) / (2 * d) for step in numpy.eye(2) * d]
    assert [along, across] == pytest.approx(slopes, abs=1e-4 * modulus)
    k = numpy.pi / (2 * p["half_side"]) * numpy.array([p["along"], p["across"]])
    assert omega == pytest.approx(numpy.sqrt((numpy.array([along, across]) * k**2).sum() / p["density"]), rel=1e-12)
