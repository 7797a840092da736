"""The twisted ring a second time: polynomials of least energy, which know nothing of lines of tension; and its equations in 25 digits."""
import mpmath
import numpy
import pytest
from evaluator import evaluate, request
from numpy.polynomial import legendre
from scipy.optimize import root
from second_values import agrees, is_near

R = mpmath.mpf
RINGS = {
    "default": {},
    "narrow": dict(youngs_modulus=3.0, poisson_ratio=0.3, thickness=0.02, inner_radius=1.4, outer_radius=2.0, twist=0.05),
    "far": dict(poisson_ratio=0.0, inner_radius=0.6, outer_radius=1.0, twist=0.3),
}
DEFAULT = dict(youngs_modulus=1.0, poisson_ratio=0.1, thickness=0.01, inner_radius=0.5, outer_radius=1.0, twist=0.05)


class Ritz:
    """r = R + w sum c_k P_k and theta = the straight one + w sum d_k P_k, w = 1 - x^2 on the ring mapped to -1 ... 1."""
    def __init__(self, p, terms=24, nodes=80):
        self.p, self.terms = p, terms
        self.half = (p["outer_radius"] - p["inner_radius"]) / 2
        self.middle = (p["outer_radius"] + p["inner_radius"]) / 2
        self.x, weights = legendre.leggauss(nodes)
        self.weights = weights * self.half * self.place(self.x)

    def place(self, x):
        return self.middle + self.half * x

    def functions(self, x):
        values = legendre.legvander(x, self.terms - 1)
        slopes = numpy.stack([legendre.legval(x, legendre.legder(row)) for row in numpy.eye(self.terms)], axis=1)
        w, dw = (1 - x**2)[:, None], (-2 * x)[:, None]
        return w * values, (dw * values + w * slopes) / self.half

    def shape(self, unknown, x):
        values, slopes = self.functions(x)
        c, d = unknown[:self.terms], unknown[self.terms:]
        twist = self.p["twist"]
        return (self.place(x) + values @ c, 1 + slopes @ c, twist * (x - 1) / 2 + values @ d,
                twist / (2 * self.half) + slopes @ d)

    def stress(self, unknown, x):
        """Of the larger principal strain alone: its nominal stress, polar components rR, tR, tT; and that strain."""
        f = self.gradient(unknown, x)
        strain = (numpy.einsum("kia,kib->kab", f, f) - numpy.eye(2)) / 2
        largest, directions = numpy.linalg.eigh(strain)
        assert (largest[:, 0] + self.p["poisson_ratio"] * largest[:, 1] < 0).all()
        n = directions[:, :, 1]
        nominal = numpy.einsum("k,kia,ka,kb->kib", largest[:, 1], f, n, n)
        return nominal[:, 0, 0], nominal[:, 1, 0], nominal[:, 1, 1], largest[:, 1]

    def gradient(self, unknown, x):
        r, dr, _, turn = self.shape(unknown, x)
        f = numpy.zeros((len(x), 2, 2))
        f[:, 0, 0], f[:, 1, 0], f[:, 1, 1] = dr, r * turn, r / self.place(x)
        return f

    def determinant(self, unknown, x):
        return numpy.linalg.det(self.gradient(unknown, x))

    def directions(self, unknown, x):
        """Angles of the lines of tension from the radius, at rest and in the twisted ring."""
        f = self.gradient(unknown, x)
        n = numpy.linalg.eigh(numpy.einsum("kia,kib->kab", f, f))[1][:, :, 1]
        m = numpy.einsum("kia,ka->ki", f, n)
        return (abs(numpy.arctan2(v[:, 1] * numpy.sign(v[:, 0]), abs(v[:, 0]))) for v in (n, m))

    def slopes(self, unknown):
        """Of the energy by the unknowns, over E."""
        values, slopes = self.functions(self.x)
        r, _, _, turn = self.shape(unknown, self.x)
        radial, around, hoop, _ = self.stress(unknown, self.x)
        by_r = self.weights * (around * turn + hoop / self.place(self.x))
        return numpy.concatenate([slopes.T @ (self.weights * radial) + values.T @ by_r,
                                  slopes.T @ (self.weights * around * r)])


@pytest.mark.parametrize("name", RINGS)
def test_least_energy(name):
    """From the ring twisted evenly; 24 polynomials leave less than 1e-9 of the shape and 1e-7 of its slopes. Directions are known to
    that over the difference of the principal stretches."""
    p = DEFAULT | RINGS[name]
    ritz = Ritz(p)
    found = root(ritz.slopes, numpy.zeros(2 * ritz.terms), method="hybr", tol=1e-13)
    assert numpy.abs(found.fun).max() <= 1e-12
    x = numpy.array([-0.9, -0.3, 0.4, 0.95])
    answer = evaluate([request("twisted-annulus", p, ritz.place(x))])[0]
    r, _, turned, _ = ritz.shape(found.x, x)
    _, around, _, strain = ritz.stress(found.x, x)
    stiff = p["youngs_modulus"] * p["thickness"]
    torque = 2 * numpy.pi * stiff * ritz.place(x) * r * around
    assert all(is_near(answer[2], one, 1e-7 * abs(one)) for one in torque)
    energy = numpy.pi * stiff * (ritz.weights * ritz.stress(found.x, ritz.x)[3] ** 2).sum()
    assert is_near(answer[3], energy, 1e-9 * energy)
    at_rest, now = ritz.directions(found.x, x)
    lengths = numpy.sqrt(1 + 2 * strain)
    stretched = ritz.determinant(found.x, x) / lengths
    turn = 1e-7 / abs(lengths - stretched)
    for k, (found, margin) in {0: (r, 1e-9), 1: (turned, 1e-9), 2: (lengths, 1e-7), 3: (stretched, 1e-7), 5: (at_rest, turn),
                               6: (now, turn),
                               4: (p["youngs_modulus"] * strain, 1e-7 * p["youngs_modulus"] * strain)}.items():
        margins = numpy.broadcast_to(margin, found.shape)
        assert all(is_near(got, one, own) for got, one, own in zip(answer[4 + k :: 7], found, margins))


def lines(p, arm, kappa):
    """Length u - U that lines gain from rim to rim, and the twist, straight from u' = l^2/q."""
    a, b = R(p["inner_radius"]), R(p["outer_radius"])
    def q(place):
        square, load = 1 - (arm / place)**2, 2 * kappa / place
        q = mpmath.sqrt(square) + mpmath.cbrt(load)
        for _ in range(8):  # Newton's steps, from above a convex root
            q -= (q**3 - square * q - load) / (3 * q**2 - square)
        return q
    def integral(f):
        return mpmath.quad(f, [a, a + (b - a) / 9, a + (b - a) / 3, b], method="gauss-legendre", maxdegree=5)
    def out(place):
        return mpmath.sqrt(place**2 - arm**2)
    long = integral(lambda x: q(x) + (arm / x)**2 / q(x)) - out(b) + out(a)
    turn = mpmath.acos(arm / b) - mpmath.acos(arm / a) - integral(lambda x: arm / (x**2 * q(x)))
    return long, turn - R(p["twist"])


def test_bounds():
    """Rings of random sizes and twists: torque and arm of a solution with 25 digits are within their bounds."""
    random = numpy.random.default_rng(1938)
    with mpmath.workdps(25):
        for _ in range(4):
            inner = float(random.uniform(0.2, 0.9))
            p = DEFAULT | dict(poisson_ratio=0.0, inner_radius=inner, outer_radius=1.0,
                               twist=float(10 ** random.uniform(-4, -1) * (1 - inner)))
            arm, pull, torque, *_ = evaluate([request("twisted-annulus", p)])[0]
            kappa = pull.value / p["thickness"]
            true_arm, true_kappa = mpmath.findroot(lambda x, y: lines(p, x, y), (R(arm.value), R(kappa)), tol=1e-44)
            assert agrees(arm, true_arm) and arm.bound <= 1e-11 * arm.value, p
            true = 2 * mpmath.pi * R(p["thickness"]) * true_kappa * true_arm
            assert agrees(torque, true) and torque.bound <= 1e-10 * torque.value, p
