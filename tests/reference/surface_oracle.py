"""Membranes in space in 40-digit arithmetic, by other routes than the C++: from energies alone."""
import mpmath

mpmath.mp.dps = 40
mp, R = mpmath.mp, mpmath.mpf


def covers(answer, true):
    value, bound = answer
    return abs(R(value) - true) <= R(bound) + abs(true) * R(10) ** -30


class Sphere:
    """Stress and stiffness by derivatives of the stored energy; the period by time spent at each stretch."""

    def __init__(self, youngs_modulus, poisson_ratio, thickness, density, radius, stretch, neo_hookean):
        self.E, self.nu, self.t, self.rho, self.R0, self.l0 = (
            R(v) for v in (youngs_modulus, poisson_ratio, thickness, density, radius, stretch))
        self.rubber = neo_hookean
        self.p = self.pressure(self.l0)

    def energy(self, l):
        if self.rubber:
            return self.E / 6 * (2 * l**2 + l**-4 - 3)
        return self.E / (1 - self.nu) * ((l**2 - 1) / 2) ** 2

    def stress(self, l):
        with mpmath.workdps(80):
            return mpmath.diff(self.energy, l) / (2 * l)

    def pressure(self, l):
        return 2 * self.t * self.stress(l) / (l * self.R0)

    def potential(self, l):
        return self.t * self.energy(l) - self.p * self.R0 * l**3 / 3

    def omega(self):
        with mpmath.workdps(80):
            square = mpmath.diff(self.potential, self.l0, 2) / (self.rho * self.t * self.R0**2)
        return mpmath.sqrt(square) if square > 0 else R(0)

    def swing(self, amplitude, near):
        """Turning stretch (the one near a given value) and period."""
        a = self.l0 + R(amplitude)
        def missed(b):
            return (self.potential(b) - self.potential(a)) / (b - a)
        with mpmath.workdps(60):
            b = mpmath.findroot(missed, (R(near), R(near) + R(10) ** -12), tol=R(10) ** -100)
            middle, half = (a + b) / 2, (a - b) / 2
            def time(angle):  # of l = middle + half cos(angle), from the speed there
                l = middle + half * mpmath.cos(angle)
                square = 2 * (self.potential(a) - self.potential(l)) / (self.rho * self.t * self.R0**2)
                return abs(half) * mpmath.sin(angle) / mpmath.sqrt(square)
            return b, 2 * mpmath.quad(time, mpmath.linspace(0, mpmath.pi, 5), method="gauss-legendre")
