"""Second computations: the rotating disk by finite elements along the radius (numpy, consistent loads, Richardson's
extrapolation), and by finite strain (shooting with a neo-Hookean law) to see that what the bounds allow for small strains
is enough. The flight of two disks and the cylinder that breathes in 50-digit arithmetic.
"""
import mpmath
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_bvp
from second_values import agrees, is_near

mpmath.mp.dps = 50
DISKS = {
    "default": dict(radius=1.0, youngs_modulus=1e4, poisson=0.3, density=1.0, angular_velocity=1.0, plane_strain=0),
    "thick": dict(radius=0.6, youngs_modulus=200.0, poisson=0.42, density=5.0, angular_velocity=0.9, plane_strain=1),
    "fast": dict(radius=1.0, youngs_modulus=100.0, poisson=0.25, density=1.0, angular_velocity=2.0, plane_strain=1),
}


def linear(p, elements):
    """Displacement of the nodes from quadratic elements in r."""
    E, nu = p["youngs_modulus"], p["poisson"]
    if p["plane_strain"]:
        stiff = E / ((1 + nu) * (1 - 2 * nu)) * numpy.array([[1 - nu, nu], [nu, 1 - nu]])
    else:
        stiff = E / (1 - nu**2) * numpy.array([[1, nu], [nu, 1]])
    r = numpy.linspace(0, p["radius"], 2 * elements + 1)
    K, f = numpy.zeros((len(r), len(r))), numpy.zeros(len(r))
    for e in range(elements):
        at = slice(2 * e, 2 * e + 3)
        half = (r[2 * e + 2] - r[2 * e]) / 2
        for x, w in zip(*numpy.polynomial.legendre.leggauss(5)):
            N = numpy.array([x * (x - 1) / 2, 1 - x * x, x * (x + 1) / 2])
            radius = N @ r[at]
            B = numpy.array([numpy.array([x - 0.5, -2 * x, x + 0.5]) / half, N / radius])
            K[at, at] += w * half * radius * B.T @ stiff @ B
            f[at] += w * half * radius * N * p["density"] * p["angular_velocity"] ** 2 * radius
    u = numpy.zeros(len(r))
    u[1:] = numpy.linalg.solve(K[1:, 1:], f[1:])
    return r, u


@pytest.mark.parametrize("name", DISKS)
def test_finite_elements_agree(name):
    p = DISKS[name]
    r, u = linear(p, 40)
    rows = evaluate([request("rotating-disk", p, r)])[0][5:]
    # quadratic elements carry a cubic displacement to fourth order: 80^-4 = 2e-8
    assert all(is_near(got, own, 1e-6 * u.max()) for got, own in zip(rows[::4], u))


@pytest.mark.parametrize("name", ["thick", "fast"])
def test_finite_strain_lies_within_the_bounds(name):
    """Neo-Hookean, plane strain: (R P_r)' = P_t - rho omega^2 R x, x(R) the radius of the turning point."""
    p = DISKS[name]
    E, nu = p["youngs_modulus"], p["poisson"]
    lam, mu = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))

    def stresses(a, b):
        pressure = lam * numpy.log(a * b) - mu
        return pressure / a + mu * a, pressure / b + mu * b

    def stretch(pr, b):
        a = numpy.ones_like(pr)
        for _ in range(60):  # Newton for P_r(a, b) = pr
            value = stresses(a, b)[0] - pr
            a = a - value / ((lam - lam * numpy.log(a * b) + mu) / a**2 + mu)
        return a

    small = 1e-4 * p["radius"]

    def rate(R, y):
        a = stretch(y[1], y[0] / R)
        pr, pt = stresses(a, y[0] / R)
        return numpy.array([a, (pt - pr) / R - p["density"] * p["angular_velocity"] ** 2 * y[0]])

    def ends(low, high):
        a = stretch(low[1:], low[:1] / small)[0]
        return numpy.array([low[0] / small - a, high[1]])

    R = numpy.linspace(small, p["radius"], 200)
    answer = evaluate([request("rotating-disk", p, R)])[0]
    rows = numpy.array(answer[5:]).reshape(-1, 4, 2)
    guess = numpy.array([R + rows[:, 0, 0], rows[:, 1, 0]])
    solution = solve_bvp(rate, ends, R, guess, tol=1e-8, max_nodes=20000)
    assert solution.success
    x, pr = solution.sol(R)
    a, b = stretch(pr, x / R), x / R
    sr, st = pr / b, stresses(a, b)[1] / a  # Cauchy stresses
    own = 1e-6 * rows[0, 1, 0]
    for k, found in enumerate((x - R, sr, st)):
        margin = own if k else 1e-6 * rows[-1, 0, 0]
        assert all(agrees(got, one, margin) for got, one in zip(answer[5 + k :: 4], found))
    spin = 2 * numpy.pi * p["density"] * p["angular_velocity"] * numpy.trapezoid(x**2 * R, R) if hasattr(numpy, "trapezoid") \
        else 2 * numpy.pi * p["density"] * p["angular_velocity"] * numpy.trapz(x**2 * R, R)
    assert agrees(answer[1], spin, 1e-4 * abs(spin))  # 200 panels
    # and the bounds are not silly: at most fifty times what finite strain changes
    assert rows[0, 1, 1] <= 50 * numpy.abs(sr - rows[:, 1, 0]).max()


def test_flight_of_two_disks():
    R = mpmath.mpf
    p = dict(left_x=0.1, left_y=-0.3, right_x=1.7, right_y=0.9, radius=0.31, youngs_modulus=700.0, poisson=0.31,
             density=3.3, speed=0.17)
    q = {key: R(value) for key, value in p.items()}
    gap = mpmath.hypot(q["right_x"] - q["left_x"], q["right_y"] - q["left_y"]) - 2 * q["radius"]
    mass = mpmath.pi * q["radius"] ** 2 * q["density"]
    nu = q["poisson"]
    c = mpmath.sqrt(q["youngs_modulus"] * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / q["density"])
    exact = [gap / (2 * q["speed"]), (q["left_x"] + q["right_x"]) / 2, (q["left_y"] + q["right_y"]) / 2,
             mass * q["speed"] ** 2, mass * q["speed"], mass, c, 2 * q["radius"] / c, gap - 2 * q["speed"]]
    answer = evaluate([request("two-disks", p, [1.0])])[0]
    assert len(answer) == len(exact)
    for got, true in zip(answer, exact):
        assert agrees(got, true) and got[1] <= 1e-14 * max(1, abs(got[0]))


@pytest.mark.parametrize("mode", [1, 2, 5])
@pytest.mark.parametrize("nu", [-0.3, 0.0, 0.3, 0.49])
def test_breathing_cylinder_in_50_digits(mode, nu):
    """Graff's frequency equation for a cylinder that breathes, and the state at a time, by mpmath."""
    p = dict(radius=0.8, youngs_modulus=50.0, poisson=nu, density=2.0, velocity=0.03, mode=mode, time=0.37)
    R, E, rho, v, t = (mpmath.mpf(p[k]) for k in ("radius", "youngs_modulus", "density", "velocity", "time"))
    nu = mpmath.mpf(nu)
    lam, mu = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
    low = mpmath.besseljzero(1, mode - 1) if mode > 1 else mpmath.mpf("0.001")
    surface = lambda x: x * mpmath.besselj(0, x) * (lam + 2 * mu) - 2 * mu * mpmath.besselj(1, x)
    x = mpmath.findroot(surface, (low, mpmath.besseljzero(0, mode)), solver="anderson")
    k, c = x / R, mpmath.sqrt((lam + 2 * mu) / rho)
    u = lambda r: v / (k * c) * mpmath.besselj(1, k * r) / mpmath.besselj(1, x) * mpmath.sin(k * c * t)
    radii = [0.0, 0.2, 0.55, 0.8]
    answer = evaluate([request("cylinder-vibration", p, radii)])[0]
    assert agrees(answer[1], k) and answer[1][1] <= 1e-12 * k
    rows = [answer[first : first + 4] for first in range(6, len(answer), 4)]
    for r, row in zip(radii, rows):
        slope = mpmath.diff(u, r)
        around = u(r) / r if r > 0 else slope
        exact = [u(r), mpmath.mpf(0), (lam + 2 * mu) * slope + lam * around, lam * slope + (lam + 2 * mu) * around]
        exact[1] = v * mpmath.besselj(1, k * r) / mpmath.besselj(1, x) * mpmath.cos(k * c * t)
        assert all(agrees(got, right, 1e-300) for got, right in zip(row, exact))
