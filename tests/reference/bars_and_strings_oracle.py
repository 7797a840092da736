"""Strings and bars in 50-digit arithmetic, apart from the C++ and with other formulas where there are any."""
import mpmath
from second_values import agrees

mp = mpmath.mp
mp.dps = 50
R = mpmath.mpf


def covers(answer, true):
    return agrees(answer, R(true), R(10) ** -40 * max(1, abs(true)))  # the oracle's own rounding


class Slack:
    """The taut motion as one cosine about the rest: d = slack + r + a cos(w t - phase), a^2 = r^2 + (v/w)^2."""

    def __init__(self, youngs_modulus, area, length, mass, gravity, slack):
        E, A, L, m, g, self.slack = (R(v) for v in (youngs_modulus, area, length, mass, gravity, slack))
        self.g, self.k = g, E * A / L
        self.w = mpmath.sqrt(self.k / m)
        self.rest, self.fall = m * g / self.k, mpmath.sqrt(2 * self.slack / g)
        self.speed = g * self.fall
        self.swing = mpmath.hypot(self.rest, self.speed / self.w)
        self.phase = mpmath.acos(-self.rest / self.swing) if self.slack else mp.pi
        self.taut = 2 * self.phase / self.w  # symmetric about the lowest point
        self.period = 2 * self.fall + self.taut

    def values(self):
        lowest = self.slack + self.rest + self.swing
        return (self.fall, self.fall + self.taut, self.period, self.speed, lowest, self.k * (self.rest + self.swing))

    def row(self, t):
        t = R(t) % self.period
        if t > self.period / 2:
            t -= self.period
        if abs(t) < self.fall:
            return self.g * t * t / 2, self.g * t, R(0)
        angle = self.w * ((t if t > 0 else t + self.period) - self.fall) - self.phase
        stretch = self.rest + self.swing * mpmath.cos(angle)
        return self.slack + stretch, -self.w * self.swing * mpmath.sin(angle), self.k * stretch


class Chain:
    def __init__(self, length, gravity, line_density, mode, amplitude):
        self.L, self.g, self.rho, self.A = (R(v) for v in (length, gravity, line_density, amplitude))
        self.j = mpmath.besseljzero(0, int(mode))
        self.w = self.j / 2 * mpmath.sqrt(self.g / self.L)

    def values(self, t):
        energy = self.rho * self.L * (self.w * self.A * mpmath.besselj(1, self.j)) ** 2 / 2
        return self.j, self.w, 2 * mp.pi / self.w, energy, energy * mpmath.sin(self.w * R(t)) ** 2

    def row(self, s, t):
        s, t = R(s), R(t)
        z = 2 * self.w * mpmath.sqrt(s / self.g)
        steep = -mpmath.besselj(1, z) * z / (2 * s) if s else -self.w**2 / self.g
        shape = mpmath.besselj(0, z)
        return (self.A * shape * mpmath.cos(self.w * t), -self.A * self.w * shape * mpmath.sin(self.w * t),
                self.A * steep * mpmath.cos(self.w * t), self.rho * self.g * s)


class Chainline:
    """The catenary by the horizontal force: Newton on H, forms with the ends as Irvine prints them."""

    def __init__(self, span, length, weight, compliance):
        self.d, self.L, self.w, self.c = (R(v) for v in (span, length, weight, compliance))
        def misfit(v):  # v = w L/(2 H)
            return v * self.d / self.L - mpmath.asinh(v) - self.w * self.L * self.c / 2
        high = R(1)
        while misfit(high) <= 0:
            high *= 2
        low = mpmath.sqrt(max(R(0), (self.L / self.d) ** 2 - 1))
        with mp.workdps(90):
            for _ in range(300):
                middle = (low + high) / 2
                low, high = (middle, high) if misfit(middle) < 0 else (low, middle)
        self.H = self.w * self.L / (2 * high)

    def values(self):
        a, half = self.H / self.w, self.L / 2
        pull = (half * mpmath.hypot(a, half) + a * a * mpmath.asinh(half / a)) * self.w * self.c
        return a, -self.row(half)[1], self.H, mpmath.hypot(self.H, self.w * half), self.L + pull

    def row(self, s):
        s, V = R(s), self.w * self.L / 2
        H, w = self.H, self.w
        x = H * s * self.c + H / w * (mpmath.asinh(V / H) - mpmath.asinh((V - w * s) / H))
        y = w * s * self.c * (self.L / 2 - s / 2) + (mpmath.hypot(H, V) - mpmath.hypot(H, V - w * s)) / w
        return x, -y, mpmath.hypot(H, V - w * s), -mpmath.atan((V - w * s) / H)


class TautString:
    def __init__(self, youngs_modulus, area, density, strain, length, mode, amplitude):
        self.E, self.S, self.rho, self.e, self.L, self.n, self.A = (
            R(v) for v in (youngs_modulus, area, density, strain, length, mode, amplitude))
        self.T = self.E * self.S * self.e
        self.c = mpmath.sqrt(self.T / (self.rho * self.S))
        self.k = self.n * mp.pi / self.L
        self.w = self.k * self.c

    def values(self, t):
        energy = self.rho * self.S * self.L * (self.w * self.A) ** 2 / 4
        z = (self.k * self.A) ** 2 / (4 * self.e)
        K = mpmath.ellipk(z / (2 * (1 + z)))  # by the parameter m = k^2
        kirchhoff = 4 * K / (self.w * mpmath.sqrt(1 + z))
        return (self.T, self.c, self.w, 2 * mp.pi / self.w, kirchhoff, self.L / (1 + self.e), energy,
                energy * mpmath.sin(self.w * R(t)) ** 2)

    def row(self, x, t):
        x, t = R(x), R(t)
        return (self.A * mpmath.sin(self.k * x) * mpmath.cos(self.w * t),
                -self.A * self.w * mpmath.sin(self.k * x) * mpmath.sin(self.w * t),
                self.A * self.k * mpmath.cos(self.k * x) * mpmath.cos(self.w * t))


class Bar:
    def __init__(self, youngs_modulus, density, area, length, velocity, mode):
        self.E, self.rho, self.S, self.L, self.v = (R(v) for v in (youngs_modulus, density, area, length, velocity))
        self.c = mpmath.sqrt(self.E / self.rho)
        self.k = (2 * int(mode) - 1) * mp.pi / (2 * self.L)
        self.w = self.k * self.c

    def values(self, t):
        energy, angle = self.rho * self.S * self.L * self.v**2 / 4, self.w * R(t)
        return (self.c, self.w, 2 * mp.pi / self.w, abs(self.v) / self.w, energy, energy * mpmath.cos(angle) ** 2,
                energy * mpmath.sin(angle) ** 2, self.v * mpmath.cos(angle) / (self.k * self.L))

    def row(self, x, t):
        x, angle = R(x), self.w * R(t)
        return (self.v / self.w * mpmath.sin(self.k * x) * mpmath.sin(angle),
                self.v * mpmath.sin(self.k * x) * mpmath.cos(angle),
                self.E * self.v / self.c * mpmath.cos(self.k * x) * mpmath.sin(angle))


class TwoStates:
    """d'Alembert with the data continued beyond the ends: velocity even and stress odd about a free end, the other way
    about a fixed one; nothing is followed, the data are looked up."""

    def __init__(self, youngs_modulus, density, length, middle, left, right, fixed):
        self.rho, self.L, self.middle = R(density), R(length), R(middle)
        self.c = mpmath.sqrt(R(youngs_modulus) / self.rho)
        self.left, self.right, self.fixed = [R(v) for v in left], [R(v) for v in right], fixed

    def data(self, x):
        velocity, stress = 1, 1
        while not 0 <= x <= self.L:
            end = 0 if x < 0 else 1
            x = -x if x < 0 else 2 * self.L - x
            if self.fixed[end]:
                velocity = -velocity
            else:
                stress = -stress
        v, s = self.left if x < self.middle else self.right
        return velocity * v, stress * s

    def jumps(self, x, t):
        """Distances of the feet of both characteristics from the nearest jump of the continued data."""
        feet = [(x - self.c * t) % (2 * self.L), (x + self.c * t) % (2 * self.L)]
        places = (R(0), self.middle, self.L, 2 * self.L - self.middle, 2 * self.L)
        return min(abs(foot - place) for foot in feet for place in places)

    def at(self, x, t):
        (v1, s1), (v2, s2) = self.data(x - self.c * t), self.data(x + self.c * t)
        z = self.rho * self.c
        return (v1 + v2) / 2 + (s2 - s1) / (2 * z), (s1 + s2) / 2 + z * (v2 - v1) / 2

    def integral(self, low, high):
        """Of the continued velocity and stress, piece by piece."""
        edges, total = {low, high}, [R(0), R(0)]
        for n in range(int(mpmath.floor(low / self.L)) - 1, int(mpmath.ceil(high / self.L)) + 2):
            edges |= {n * self.L, n * self.L + self.middle, n * self.L - self.middle}
        edges = sorted(e for e in edges if low <= e <= high)
        for a, b in zip(edges, edges[1:]):
            v, s = self.data((a + b) / 2)
            total = [total[0] + v * (b - a), total[1] + s * (b - a)]
        return total

    def displacement(self, x, t):
        left, right = self.integral(x - self.c * t, x), self.integral(x, x + self.c * t)
        return (left[0] + right[0] + (right[1] - left[1]) / (self.rho * self.c)) / (2 * self.c)
