"""Membranes in space in 40-digit arithmetic, by other routes than the C++: from energies alone."""
import mpmath
from second_values import agrees

mpmath.mp.dps = 40
mp, R = mpmath.mp, mpmath.mpf


def covers(answer, true):
    return agrees(answer, R(true), abs(true) * R(10) ** -30)


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


class Sheet:
    """A circular sheet under pressure by power series in x = s^2 about its middle; units of a and E. Unknown: the
    stretch in the middle. Series of r/s, r', y'/s and S1 follow from the balance of forces along axis and radius:
    2 S1 y'/s = q (r/s)^2, (s S1 r')' = S2 r/s - q r y'."""

    def __init__(self, load, poisson_ratio, stretch, terms=110):
        q, nu = R(load), R(poisson_ratio)
        self.q, self.nu, self.terms = q, nu, terms
        plane = 1 - nu**2
        def product(a, b, n):
            return sum(a[k] * b[n - k] for k in range(n + 1))
        l, slope = [R(stretch)], [R(stretch)]                 # r/s and r'
        strain = (R(stretch) ** 2 - 1) / 2
        stress, hoop = [strain / (1 - nu)], [strain / (1 - nu)]  # S1 and S2
        l_square, drop, drop_square = [l[0] ** 2], [], []     # (r/s)^2, y'/s and its square
        for n in range(1, terms):
            # S1 drop = q l^2/2 at order n - 1
            known = sum(stress[k] * drop[n - 1 - k] for k in range(1, n))
            drop.append((q / 2 * l_square[n - 1] - known) / stress[0])
            drop_square.append(product(drop, drop, n - 1))
            # what order n of r'^2, l^2, S1 and of the balance is without l_n; with it, r' has (2 n + 1) l_n
            slope_rest = sum(slope[k] * slope[n - k] for k in range(1, n))
            l_rest = sum(l[k] * l[n - k] for k in range(1, n))
            meridian_rest, hoop_rest = (slope_rest + drop_square[n - 1]) / 2, l_rest / 2
            stress_rest = (meridian_rest + nu * hoop_rest) / plane
            balance = ((2 * n + 1) * (slope[0] * stress_rest + sum(stress[k] * slope[n - k] for k in range(1, n)))
                       - l[0] * (hoop_rest + nu * meridian_rest) / plane - sum(hoop[k] * l[n - k] for k in range(1, n))
                       + q * product(l, drop, n - 1))
            m = 2 * n + 1
            per_l = (m * (stress[0] * m + slope[0] * (slope[0] * m + nu * l[0]) / plane) - hoop[0]
                     - l[0] * (l[0] + nu * slope[0] * m) / plane)
            l.append(-balance / per_l)
            slope.append(m * l[n])
            l_square.append(l_rest + 2 * l[0] * l[n])
            meridian, hooped = meridian_rest + slope[0] * slope[n], hoop_rest + l[0] * l[n]
            stress.append((meridian + nu * hooped) / plane)
            hoop.append((hooped + nu * meridian) / plane)
        self.l, self.slope, self.drop, self.S1, self.S2 = l, slope, drop, stress, hoop
        swept = [product(l_square, drop, n) for n in range(terms - 1)]
        self.swept = swept

    def sum(self, series, s, shift=0):
        """sum of c_n x^n/(2 n + shift); shift 0: without the divisor. What is left out must be nothing."""
        x = R(s) ** 2
        parts = [c * x**n / (2 * n + shift if shift else 1) for n, c in enumerate(series)]
        assert abs(parts[-1]) <= R(10) ** -19 * abs(parts[0]), (s, parts[-1])
        return mpmath.fsum(parts)

    def radius(self, s):
        return R(s) * self.sum(self.l, s)

    def fallen(self, s):
        return R(s) ** 2 * self.sum(self.drop, s, 2)

    def volume(self, s):
        return mp.pi * R(s) ** 4 * self.sum(self.swept, s, 4)

    def stretch(self, s):
        return mpmath.sqrt(self.sum(self.slope, s) ** 2 + R(s) ** 2 * self.sum(self.drop, s) ** 2)


def shot(load, poisson_ratio, near, missed):
    """The sheet whose stress in the middle is near a given one and which misses nothing."""
    def sheet(stress):
        return Sheet(load, poisson_ratio, mpmath.sqrt(1 + 2 * (1 - R(poisson_ratio)) * stress))
    scale = R(near)
    found = mpmath.findroot(lambda x: missed(sheet(scale * x)), (R(1), 1 + R(10) ** -9), tol=R(10) ** -60, verify=False)
    assert abs(found - 1) < R(10) ** -6
    result = sheet(scale * found)
    assert abs(missed(result)) <= R(10) ** -28
    return result


class Clamped:
    def __init__(self, load, poisson_ratio, near):
        self.sheet = shot(load, poisson_ratio, near, lambda sheet: sheet.radius(1) - 1)

    def values(self):
        return self.sheet.fallen(1), self.sheet.S1[0], self.sheet.volume(1)

    def at(self, s):
        a = self.sheet
        return a.radius(s), a.fallen(1) - a.fallen(s), a.sum(a.S1, s), a.sum(a.S2, s), a.stretch(s)


class Balloon:
    """The wrinkled part by its force N along the meridians and its shape by the radius: dy/dr = r^2/sqrt(R^4 - r^4)."""

    def __init__(self, load, poisson_ratio, near, edge):
        self.q, self.edge = R(load), R(edge)
        self.sheet = shot(load, poisson_ratio, near, self.excess)
        self.excess(self.sheet)

    def excess(self, sheet):
        """Arc to the seam less the length of the sheet that is left."""
        self.edge = mpmath.findroot(lambda s: sheet.sum(sheet.S2, s), (self.edge, self.edge * (1 + R(10) ** -9)),
                                    tol=R(10) ** -70, verify=False)
        self.inner = sheet.radius(self.edge)
        self.force = self.edge * sheet.sum(sheet.S1, self.edge) * sheet.stretch(self.edge)
        self.rim = mpmath.sqrt(2 * self.force / self.q)
        return self.arc(self.inner) - self.length(self.edge)

    def along(self, weight, r):
        """int weight dr from r to the seam, with r = rim (1 - u^2)."""
        rim, top = self.rim, mpmath.sqrt(1 - R(r) / self.rim)
        def f(u):
            v = rim * (1 - u**2)
            return 2 * rim * weight(v) / mpmath.sqrt((1 + v / rim) * (1 + v**2 / rim**2))
        return mpmath.quad(f, [0, top])

    def arc(self, r):
        return self.along(lambda v: 1, r)

    def stretch(self, s):
        c = 2 * self.force / s  # l^3 - l = c, one real root or the largest of three
        return max(root.real for root in mpmath.polyroots([1, 0, -1, -c], maxsteps=200, extraprec=200)
                   if abs(root.imag) < R(10) ** -30)

    def length(self, s):
        """int l ds over s = e^-t."""
        return mpmath.quad(lambda t: self.stretch(mpmath.exp(-t)) * mpmath.exp(-t), [0, -mpmath.log(s)])

    def values(self):
        a = self.sheet
        height = self.along(lambda v: v**2 / self.rim**2, self.inner)
        wrinkled = mp.pi * self.along(lambda v: v**4 / self.rim**2, self.inner)
        return (height + a.fallen(self.edge), a.S1[0], self.rim, 2 * (a.volume(self.edge) + wrinkled), self.edge)

    def at(self, s):
        s = R(s)
        if s <= self.edge:
            a = self.sheet
            top = self.along(lambda v: v**2 / self.rim**2, self.inner) + a.fallen(self.edge)
            return a.radius(s), top - a.fallen(s), a.sum(a.S1, s), a.sum(a.S2, s), a.stretch(s)
        l, length = self.stretch(s), self.length(s)
        r = mpmath.findroot(lambda r: self.arc(r) - length, (self.inner, self.rim * R("0.999")), solver="anderson",
                            tol=R(10) ** -60, verify=False)
        return r, self.along(lambda v: v**2 / self.rim**2, r), (l**2 - 1) / 2, R(0), l
