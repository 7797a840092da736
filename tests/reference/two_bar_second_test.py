"""A second, independent computation of the two-bar impact: finite volumes for velocities and stresses, each direction in
turn, in numpy. Pressure waves move one cell a step, exactly; shear waves by a limited upwind scheme; the face presses or
is free cell by cell, by the wave that arrives there. No masses at nodes and no stiffness: nothing is shared with the finite
elements under test.
"""
import numpy
import pytest
from evaluator import evaluate, request
from second_values import agrees

PROBLEMS = {
    "york": dict(width=1.25, height=4.5, youngs_modulus=1e5, poisson=0.3, density=1.0, speed=2.0),
    "square": dict(width=0.8, height=0.8, youngs_modulus=3e4, poisson=0.25, density=2.5, speed=0.3),
    "soft": dict(width=2.0, height=3.2, youngs_modulus=50.0, poisson=0.45, density=7.0, speed=0.01),
}


def carried(w, courant):
    """Values moved to the right by `courant` cells; two more cells at each end give what comes in."""
    d = numpy.diff(w, axis=0)
    a, b = d[:-1], d[1:]
    size = numpy.minimum(2 * numpy.minimum(abs(a), abs(b)), abs(a + b) / 2)
    face = w[1:-1] + (1 - courant) / 2 * numpy.where(a * b > 0, numpy.sign(a) * size, 0)
    return w[2:-2] - courant * (face[1:-1] - face[:-2])


def sweep(v, s, impedance, courant, low, high):
    """Velocity and stress after a step along axis 0; low, high: 1 where the end is held, -1 where it is free."""
    right, left = s - impedance * v, s + impedance * v
    a = carried(numpy.concatenate([low * left[1::-1], right, high * left[:-3:-1]]), courant)
    b = carried(numpy.concatenate([low * right[1::-1], left, high * right[:-3:-1]])[::-1], courant)[::-1]
    return (b - a) / (2 * impedance), (a + b) / 2


class UpperHalf:
    """Of one bar that meets a wall at x = 0 with speed 1; symmetry at y = 0."""

    def __init__(self, p, n):
        E, nu, self.rho = p["youngs_modulus"], p["poisson"], p["density"]
        m = round(p["height"] / 2 / (p["width"] / n))
        self.nu, self.c, self.c_s = nu, (E / (1 - nu**2) / self.rho) ** 0.5, (E / (2 * (1 + nu)) / self.rho) ** 0.5
        self.hy = p["height"] / 2 / m
        self.dt = min(p["width"] / n, self.hy) / self.c
        self.cells = n * m
        self.courant = numpy.array([self.dt * n / p["width"], self.dt / self.hy])  # for a speed of 1
        self.vx = -numpy.ones((n, m))
        self.vy, self.sxx, self.syy, self.sxy = (numpy.zeros((n, m)) for _ in range(4))
        self.gap = numpy.zeros(m)

    def along_x(self):
        z, before = self.rho * self.c, self.sxx
        arrives = self.sxx[0] + z * self.vx[0]
        touch = (self.gap <= 0) & (arrives < 0)
        self.gap = numpy.where(touch, 0, numpy.maximum(self.gap + self.dt * arrives / z, 0))
        self.vx, self.sxx = sweep(self.vx, self.sxx, z, self.c * self.courant[0], numpy.where(touch, 1, -1), -1)
        self.syy = self.syy + self.nu * (self.sxx - before)
        self.vy, self.sxy = sweep(self.vy, self.sxy, self.rho * self.c_s, self.c_s * self.courant[0], -1, -1)
        return -numpy.where(touch, arrives, 0).sum() * self.hy

    def along_y(self):
        before = self.syy
        vy, syy = sweep(self.vy.T, self.syy.T, self.rho * self.c, self.c * self.courant[1], 1, -1)
        self.vy, self.syy = vy.T, syy.T
        self.sxx = self.sxx + self.nu * (self.syy - before)
        vx, sxy = sweep(self.vx.T, self.sxy.T, self.rho * self.c_s, self.c_s * self.courant[1], -1, -1)
        self.vx, self.sxy = vx.T, sxy.T


def impact(p, n):
    """Restitution, end of the force, largest force at the given speed."""
    bar, time, end, peak, step = UpperHalf(p, n), 0.0, 0.0, 0.0, 0
    while time < 3 * p["width"] / bar.c:
        if step % 2:
            bar.along_y()
        force = bar.along_x()
        if not step % 2:
            bar.along_y()
        step, time, peak = step + 1, time + bar.dt, max(peak, force)
        if force > 0.01 * peak:
            end = time
    return bar.vx.mean(), end, bar.dt, peak * p["speed"]


@pytest.mark.parametrize("name", PROBLEMS)
def test_finite_volumes_agree(name):
    p = PROBLEMS[name]
    (coarse, *_), (fine, end, dt, peak) = impact(p, 40), impact(p, 80)
    answer = evaluate([request("two-bar", p)])[0]
    restitution, duration, force = answer[:3]
    own = abs(fine - coarse)  # the finer mesh's error is at most the change that halving the cells made
    assert own <= 3e-3
    assert agrees(restitution, fine, own)
    assert restitution.bound <= 0.01
    assert agrees(duration, end, 2 * dt)
    assert agrees(force, peak, 1e-12 * peak)
