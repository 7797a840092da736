"""The bar with a tip mass in many-digit arithmetic, by waves instead of modes.

With L/c = 1, m g/k = 1 and mu the mass ratio, the Laplace transform of the motion of the lower end is
D(s) = mu/s^3 (1 - mu/(s sinh s + mu cosh s)); expanded in exp(-2 s) it is a finite sum for every finite time:
d(t) = mu t^2/2 - 2 mu^2 sum_k I_k(t - 2k - 1), I_k the inverse transform of (s - mu)^k/(s^3 (s + mu)^(k + 1)),
found from its residues at 0 and -mu. Exact up to rounding: no truncation, and nothing shared with the modal series.
"""
import mpmath

mp = mpmath.mp
mp.dps = 60
R = mpmath.mpf


def residue_at_zero(k, tau, order):
    """Of (s - 1)^k/(s^order (s + 1)^(k + 1)) e^(s tau)."""
    taylor = [R(1), -R(2 * k + 1), R(2 * k * k + 2 * k + 1)][:order]
    total = sum(c * tau ** (order - 1 - i) / mpmath.factorial(order - 1 - i) for i, c in enumerate(taylor))
    return total * (-1) ** k


def residue_at_minus_one(k, tau, order):
    """Of the same function: (sigma - 2)^k (sigma - 1)^-order e^(sigma tau) around sigma = s + 1 = 0."""
    numerator = [mpmath.binomial(k, i) * R(-2) ** (k - i) for i in range(k + 1)]
    pole = [(-1) ** order * mpmath.binomial(i + order - 1, order - 1) for i in range(k + 1)]
    total = R(0)
    for j in range(k + 1):
        c = sum(numerator[i] * pole[j - i] for i in range(j + 1))
        total += c * tau ** (k - j) / mpmath.factorial(k - j)
    return total * mpmath.exp(-tau)


def wave(mu, t, order):
    """Sum over the waves that have arrived; order 3 for the displacement, 2 for the velocity."""
    total, k = R(0), 0
    while t > 2 * k + 1:
        tau = mu * (t - 2 * k - 1)
        total += (residue_at_zero(k, tau, order) + residue_at_minus_one(k, tau, order)) / mu ** (order)
        k += 1
    return total


def unit_displacement(mu, t):
    return mu * t * t / 2 - 2 * mu * mu * wave(mu, t, 3)


def unit_velocity(mu, t):
    return mu * t - 2 * mu * mu * wave(mu, t, 2)


def root(mu, n=1):
    """n-th root of x tan x = mu by bisection and Newton."""
    def h(x):
        return x * mpmath.sin(x) - mu * mpmath.cos(x)
    low, high = (n - 1) * mp.pi, (n - R(1) / 2) * mp.pi
    sign = (-1) ** (n - 1)
    if n == 1:
        high = min(high, mpmath.sqrt(mu) * R("1.01"))
        low = high / 2 if mu < 1 else low
    for _ in range(12):
        middle = (low + high) / 2
        low, high = (middle, high) if sign * h(middle) < 0 else (low, middle)
    x = (low + high) / 2
    for _ in range(40):
        step = h(x) / ((1 + mu) * mpmath.sin(x) + x * mpmath.cos(x))
        x -= step
        if abs(step) < x * R(10) ** -54:
            return x
    raise ArithmeticError("no convergence")


class Spring:
    def __init__(self, youngs_modulus, area, length, mass, density, gravity):
        E, A, L, m, rho, g = (R(v) for v in (youngs_modulus, area, length, mass, density, gravity))
        self.rest = m * g * L / (E * A)  # of the massless spring
        self.omega_massless = mpmath.sqrt(E * A / (L * m))
        self.mu = rho * A * L / m
        self.rate = mpmath.sqrt(E / rho) / L if rho else None  # c/L
        self.omega = root(self.mu) * self.rate if rho else self.omega_massless

    def displacement(self, t):
        return self.rest * unit_displacement(self.mu, R(t) * self.rate)

    def displacement_by_modes(self, t, count):
        """For light springs at late times, where the waves are too many and few modes suffice."""
        mu, total = self.mu, self.rest * (1 + self.mu / 2)
        if not hasattr(self, "roots"):
            self.roots = [root(mu, n) for n in range(1, count + 1)]
        for n, x in enumerate(self.roots):
            q = 2 * mu * mu * mpmath.sqrt(x * x + mu * mu) / (x**3 * (x * x + mu * mu + mu))
            total -= (-1) ** n * self.rest * q * mpmath.cos(x * self.rate * R(t))
        return total

    def max_displacement(self):
        """First return to rest of the lower end: scan, then the bracketed secant method."""
        mu = self.mu
        half = mp.pi / root(mu)
        t, step = half / 16, half / 16
        while unit_velocity(mu, t + step) > 0:
            t += step
        rest = mpmath.findroot(lambda s: unit_velocity(mu, s), (t, t + step), solver="anderson", tol=R(10) ** -60)
        return self.rest * unit_displacement(mu, rest)
