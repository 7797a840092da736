"""The lumped airbag in 30-digit arithmetic. The motion runs along the contact radius b instead of the displacement: at
each b the meridian fixes the shape, and the volume is the integral of pi r^2 dz in closed form, not by the virial.
"""
from types import SimpleNamespace

import mpmath
import numpy
from scipy import special
from scipy.optimize import brentq
from second_values import agrees

mpmath.mp.dps = 30
R = mpmath.mpf
pi = mpmath.pi
FULL = SimpleNamespace(number=R, sqrt=mpmath.sqrt, RF=mpmath.elliprf, RD=mpmath.elliprd)
ROUGH = SimpleNamespace(number=float, sqrt=numpy.sqrt, RF=special.elliprf, RD=special.elliprd)  # only for first guesses


def covers(answer, true):
    return agrees(answer, true, abs(true) * R(10) ** -17)


class Bag:
    def __init__(self, meridian, probe_radius):
        self.S, self.rp = R(meridian), R(probe_radius)

    def measures(self, b, l, lib=FULL):
        """Meridian, gap, volume for b and l."""
        square, rp = b * b + l * l, lib.number(self.rp)
        radius, m, top = lib.sqrt(square), 2 * l * l / square, min(b, rp)
        length = gap = volume = lib.number(0)
        for r in (b, top):
            sine = (b * b - r * r) / l**2
            s2, c2, d2 = (1 + sine) / 2, (1 - sine) / 2, (r / radius) ** 2
            s = lib.sqrt(s2)
            F, D = s * lib.RF(c2, d2, 1), s**3 / 3 * lib.RD(c2, d2, 1)
            length += l * l / radius * F
            gap += l * l / radius * (F - 2 * D)
            # int cos 2 psi Delta d psi = (F - (2 - m) D + 2 sin cos Delta)/3
            volume += lib.number(pi) * l * l * radius / 3 * (F - (2 - m) * D + 2 * s * lib.sqrt(c2) * r / radius)
        return b + top + length, gap, volume

    def rough(self, b):
        """Gap, volume, l in double precision; nothing if there is no such shape."""
        S, rp = float(self.S), float(self.rp)
        low = max(1e-6 * S, max(0.0, b * b - rp * rp) ** 0.5 * (1 + 1e-12))
        missed = lambda l: self.measures(b, l, ROUGH)[0] - S
        if missed(low) >= 0:
            return None
        l = brentq(missed, low, S, xtol=1e-15)
        return self.measures(b, l, ROUGH)[1:] + (l,)

    def at_radius(self, b):
        """Gap, volume, l: l by the secant method from the rough one."""
        guess = R(self.rough(float(b))[2])
        l = mpmath.findroot(lambda l: self.measures(b, l)[0] - self.S, (guess, guess * (1 + R(10) ** -12)),
                            solver="secant", tol=R(10) ** -46)
        return self.measures(b, l)[1:] + (l,)

    def root(self, f, low):
        """Of a function of gap and volume that rises with b: bracketed and found roughly, then to all digits."""
        step, high, value = float(self.S) / 100, float(low), -1
        while value < 0:
            there = self.rough(high + step)
            if there is None:  # beyond the last shape
                step /= 2
                continue
            high, value = high + step, f(*there[:2])
        guess = R(brentq(lambda b: float(f(*self.rough(b)[:2])), float(low), high, xtol=1e-15))
        return mpmath.findroot(lambda b: f(*self.at_radius(b)[:2]), (guess, guess * (1 + R(10) ** -10)),
                               solver="secant", tol=R(10) ** -40)

    def fall(self, b, l):
        """-dH/db along the family, by central differences of the measures with digits to spare."""
        h = R(10) ** -10 * self.S
        by_b = [(p - q) / (2 * h) for p, q in zip(self.measures(b + h, l), self.measures(b - h, l))]
        by_l = [(p - q) / (2 * h) for p, q in zip(self.measures(b, l + h), self.measures(b, l - h))]
        return by_l[1] * by_b[0] / by_l[0] - by_b[1]


class Impact:
    def __init__(self, mass, probe_radius, speed, meridian, height, gamma, pressure, ambient_pressure,
                 gas_volume=0.0):
        self.bag = Bag(meridian, probe_radius)
        self.m, self.v0, self.g = R(mass), R(speed), R(gamma)
        self.p0, self.pa = R(pressure), R(ambient_pressure)
        self.b0 = self.bag.root(lambda gap, _: R(height) - gap, 0) if height else R(0)
        self.H0, self.V0, _ = self.bag.at_radius(self.b0)
        self.E = self.m * self.v0**2 / 2
        self.bm = self.bag.root(lambda _, volume: self.work(R(volume), self.V0) - self.E, self.b0)
        self.limit = self.state(self.bm)["displacement"]
        if gas_volume:
            far = self.bag.root(lambda _, volume: self.work(R(volume), R(gas_volume)) - self.E, self.b0)
            self.limit = self.H0 - self.bag.at_radius(far)[0]

    def work(self, V, gas):
        """Of the outside on gas that had p0 in the volume `gas`, down to V."""
        return self.p0 * gas / (self.g - 1) * ((gas / V) ** (self.g - 1) - 1) - self.pa * (gas - V)

    def state(self, b):
        gap, volume, l = self.bag.at_radius(b)
        p = self.p0 * (self.V0 / volume) ** self.g
        v = mpmath.sqrt(max(R(0), 2 * (self.E - self.work(volume, self.V0)) / self.m))
        return dict(displacement=self.H0 - gap, velocity=v, force=(p - self.pa) * pi * b * b, pressure=p, volume=volume,
                    plate_radius=b, equator=mpmath.hypot(b, l))

    def time(self, b_end):
        """int dx/v with b from b0 to b_end, b = b0 + (bm - b0) sin u, in pieces at the edge of the probe."""
        span = self.bm - self.b0
        def rate(u):
            b = self.b0 + span * mpmath.sin(u)
            gap, volume, l = self.bag.at_radius(b)
            speed = mpmath.sqrt(2 * (self.E - self.work(volume, self.V0)) / self.m)
            return self.bag.fall(b, l) * span * mpmath.cos(u) / speed
        knots = [R(0)]
        if self.b0 < self.bag.rp < b_end:
            knots.append(mpmath.asin((self.bag.rp - self.b0) / span))
        knots.append(mpmath.asin(min(R(1), (b_end - self.b0) / span)))
        total = R(0)
        for low, high in zip(knots, knots[1:]):
            total += sum(w * rate(low + (high - low) * x) for x, w in NODES) * (high - low)
        return total


def gauss(n):
    """Nodes and weights on [0, 1]: numpy's nodes, polished by Newton's method."""
    nodes = []
    for start in numpy.polynomial.legendre.leggauss(n)[0]:
        x = R(float(start))
        for _ in range(3):
            slope = n * (x * mpmath.legendre(n, x) - mpmath.legendre(n - 1, x)) / (x * x - 1)
            x -= mpmath.legendre(n, x) / slope
        nodes.append(((1 + x) / 2, 1 / ((1 - x * x) * slope**2)))
    return nodes


NODES = gauss(24)
