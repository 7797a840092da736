"""Piston and gas, ring and gas, bag of gas in 50-digit arithmetic, apart from the C++ and by other routes."""
import mpmath
from bars_and_strings_oracle import R, covers  # noqa: F401

mp = mpmath.mp


def root(f, low, high, near=None):
    """The one change of sign of f between low and high, by halving and then the Illinois method. A value `near` it
    only saves time: the sign must change around it."""
    if near is not None:
        narrow = [R(near) - abs(R(near)) * R(10) ** -11, R(near) + abs(R(near)) * R(10) ** -11]
        if low < narrow[0] and narrow[1] < high and (f(narrow[0]) > 0) != (f(narrow[1]) > 0):
            return mpmath.findroot(f, narrow, solver="anderson", tol=64 * mp.eps * min(1, abs(high)), maxsteps=200,
                                   verify=False)
    below, above = f(low), f(high)
    assert (below > 0) != (above > 0), (low, high)
    for _ in range(4):
        middle = (low + high) / 2
        at = f(middle)
        if (at > 0) == (below > 0):
            low, below = middle, at
        else:
            high, above = middle, at
    return mpmath.findroot(f, (low, high), solver="anderson", tol=64 * mp.eps * min(1, abs(high)), maxsteps=200, verify=False)


class Piston:
    """Frequencies from cotangents; the motion by waves: each echo of a wall is one term."""

    def __init__(self, spring_modulus, spring_length, spring_density, area, mass, gas_density, bulk_modulus, gas_length,
                 velocity):
        E, L_s, rho_s, A, self.m, rho, beta, L, self.v = (R(v) for v in (
            spring_modulus, spring_length, spring_density, area, mass, gas_density, bulk_modulus, gas_length, velocity))
        self.K = E * A / L_s
        self.Z, self.tau = mpmath.sqrt(rho * beta) * A, L * mpmath.sqrt(rho / beta)
        self.heavy = rho_s > 0
        self.Z_s, self.tau_s = mpmath.sqrt(rho_s * E) * A, L_s * mpmath.sqrt(rho_s / E)

    def force(self, w):
        spring = self.Z_s * mpmath.cot(w * self.tau_s) if self.heavy else self.K / w
        return spring + self.Z * mpmath.cot(w * self.tau) - self.m * w

    def roots(self, count, near=()):
        poles = [k * mp.pi / self.tau for k in range(1, count + 1)]
        if self.heavy:
            poles += [k * mp.pi / self.tau_s for k in range(1, count + 1)]
        poles = [R(0), *sorted(poles)[:count]]
        found = []
        for low, high in zip(poles, poles[1:]):
            if high - low < R(10) ** -30 * high:
                found.append(high)
                continue
            margin = (high - low) * R(10) ** -25
            guess = near[len(found)] if near else None
            found.append(root(self.force, low + margin, high - margin, guess))
        return found

    def modal_mass(self, w):
        """m + int rho A shape^2, with the integrals of the sines as they are."""
        def part(total, x):
            return total * (R(1) / 2 - mpmath.sin(2 * x) / (4 * x)) / mpmath.sin(x) ** 2
        mass = self.m + part(self.Z * self.tau, w * self.tau)
        return mass + (part(self.Z_s * self.tau_s, w * self.tau_s) if self.heavy else 0)

    def motion(self, t):
        """The powers of t cancel as exp(Z t/m): that many digits more."""
        sides = self.Z + (self.Z_s if self.heavy else 0)
        with mp.workdps(60 + int(3 * sides * R(t) / self.m)):
            return self.waves(t)

    def waves(self, t):
        """x and x': m s^2 + Z_s s coth(s tau_s) + Z s coth(s tau) = D (1 + ...), coth x = 1 + 2 (e^-2x + e^-4x + ...).
        Each term is m v (-2 s)^j/D^(j+1) Z_s^i Z^(j-i) exp(-2 (p tau_s + q tau) s), D = m s^2 + (Z_s + Z) s [+ K]."""
        t, sides = R(t), self.Z + (self.Z_s if self.heavy else 0)
        a, k = sides / self.m, 0 if self.heavy else self.K / self.m
        x, speed, q = R(0), R(0), 0
        while 2 * q * self.tau <= t:
            p = 0
            while 2 * (p * self.tau_s + q * self.tau) <= t:
                for i in range(min(p, 1), p + 1):
                    for l in range(min(q, 1), q + 1):
                        times = mpmath.binomial(i + l, i) * (mpmath.binomial(p - 1, i - 1) if p else 1) * \
                            (mpmath.binomial(q - 1, l - 1) if q else 1)
                        if times:
                            weight = self.v * times * (-2 * self.Z_s / self.m) ** i * (-2 * self.Z / self.m) ** l
                            place, rate = self.echo(i + l, a, k, t - 2 * (p * self.tau_s + q * self.tau))
                            x, speed = x + weight * place, speed + weight * rate
                p += 1
                if not self.heavy:
                    break
            q += 1
        return x, speed

    def echo(self, j, a, k, t):
        """s^j/(s^2 + a s + k)^(j+1) in time and its rate, as a power series of t (entire): with u = 1/s it is
        u^(j+2) (1 + a u + k u^2)^-(j+1)."""
        if t == 0:
            return R(0), R(1 if j == 0 else 0)
        c, before = R(1), R(0)
        place = rate = R(0)
        factor = t ** (j + 1) / mpmath.factorial(j + 1)
        n, largest = 0, R(0)
        while True:
            term = c * factor
            place, rate = place + term, rate + term * (j + 1 + n) / t
            largest = max(largest, abs(term))
            if n > 8 and abs(term) + abs(before * factor) < mp.eps * largest:
                return place, rate
            n += 1
            # (n) c_n + a (n + j) c_(n-1) + k (n + 2 j) c_(n-2) = 0
            c, before = -(a * (n + j) * c + k * (n + 2 * j) * before) / n, c
            factor *= t / (j + 1 + n)


class Ring:
    """The gas by the quotient of Bessel functions, roots between zeros of J1 from mpmath."""
    zeros = [R(0), *(mpmath.besseljzero(1, n) for n in range(1, 11))]

    def __init__(self, youngs_modulus, poisson_ratio, thickness, radius, line_mass, pressure, gas_density, gamma, law,
                 velocity=1.0):
        E, nu, t, self.r, self.m, self.p, self.rho, self.gamma, self.v = (R(v) for v in (
            youngs_modulus, poisson_ratio, thickness, radius, line_mass, pressure, gas_density, gamma, velocity))
        modulus = E / (1 - nu**2)
        self.c = mpmath.sqrt(self.gamma * self.p / self.rho)
        self.strain = self.p * self.r / (modulus * t) if law < 2 else R(0)
        self.r0 = self.r * mpmath.exp(-self.strain) if law == 1 else self.r / (1 + self.strain)
        if law == 1:  # T = E' t r ln(R/R0)/R
            rise, pull = modulus * t * (1 - self.strain) / self.r, modulus * t * self.strain
        elif law == 0:
            rise, pull = modulus * t / self.r0, modulus * t * self.strain
        else:
            rise, pull = modulus * t / self.r, R(0)
        self.k = (rise - pull / self.r) / self.r
        self.dry = mpmath.sqrt(max(self.k, 0) / self.m)
        self.slow = mpmath.sqrt((self.k + 2 * self.gamma * self.p / self.r) / self.m)

    def balance(self, w):
        z = w * self.r / self.c
        gas = self.rho * w * self.c * mpmath.besselj(0, z) / mpmath.besselj(1, z)
        return self.k + gas - self.m * w**2

    def omega(self, n, near):
        low, high = (z * self.c / self.r for z in self.zeros[n - 1 : n + 1])
        margin = (high - low) * R(10) ** -25
        return root(self.balance, low + margin, high - margin, near)

    def modal_mass(self, w):
        z = w * self.r / self.c
        j0, j1 = mpmath.besselj(0, z), mpmath.besselj(1, z)
        disc = 1 - j0 * mpmath.besselj(2, z) / j1**2  # 2 int_0^1 J1(z s)^2 s ds/J1(z)^2
        return mp.pi * (2 * self.r * self.m + self.rho * self.r**2 * disc)

    def shape(self, s, w):
        z = w * self.r / self.c
        return mpmath.besselj(1, z * R(s)) / mpmath.besselj(1, z)

    def pressure(self, s, w):
        z = w * self.r / self.c
        return -self.rho * w * self.c * mpmath.besselj(0, z * R(s)) / mpmath.besselj(1, z)


class Bag:
    """The radius at which the total of the forces vanishes, found from the energies; nothing of the closed forms."""

    def __init__(self, gas_energy, gas_area, gamma, length, youngs_modulus, poisson_ratio, thickness, density, lost, law):
        self.U, self.A0, self.gamma, self.L, E, nu, self.t, self.density, self.lost = (R(v) for v in (
            gas_energy, gas_area, gamma, length, youngs_modulus, poisson_ratio, thickness, density, lost))
        self.modulus, self.law = E / (1 - nu**2), law

    def shape(self, n):
        """Area/R^2, length/R, apothem/R."""
        if n == 0:
            return mp.pi / 4, mp.pi / 2, R(1)
        theta = mp.pi / (2 * n)
        return n * mpmath.sin(theta) / 2, n * mpmath.sqrt(2 - 2 * mpmath.cos(theta)), mpmath.sqrt((1 + mpmath.cos(theta)) / 2)

    def membrane(self, length):
        """Strain, tension, energy."""
        if self.law == 0:
            strain = length / self.L - 1
            tension = self.modulus * self.t * strain
        else:
            strain = mpmath.log(length / self.L)
            tension = self.modulus * strain * self.t * self.L / length
        return strain, tension, self.modulus * self.t * self.L * strain**2 / 2

    def at(self, n, pressure_of, near):
        """pressure_of(area, membrane energy); p dA/dR = T dLambda/dR solved for the stretched length; `near` the strain."""
        area, length, apothem = self.shape(n)
        def excess(log_strain):
            Lambda = self.L * (1 + mpmath.exp(log_strain))
            radius = Lambda / length
            _, tension, energy = self.membrane(Lambda)
            return tension * length - pressure_of(area * radius**2, energy) * 2 * area * radius
        x = root(excess, R(-60), R(6), mpmath.log(near if self.law == 0 else mpmath.expm1(near)))
        Lambda = self.L * (1 + mpmath.exp(x))
        strain, tension, energy = self.membrane(Lambda)
        radius = Lambda / length
        p = pressure_of(area * radius**2, energy)
        return dict(radius=radius, apothem=radius * apothem, area=area * radius**2, pressure=p, tension=tension,
                    stress=self.modulus * strain, strain=strain, gas=p * area * radius**2 / (self.gamma - 1), membrane=energy)

    def end(self, n, near, breathing=True):
        """The frequencies by differences of the energy, if wanted: they take most of the time."""
        s = self.at(n, lambda A, W: (self.gamma - 1) * (self.U - self.lost - W) / A, near)
        if not breathing:
            return s
        mass = self.density * self.t * self.L
        def energy(r, gas):
            area, length, _ = self.shape(n)
            heat = s["gas"] * (s["area"] / (area * r**2)) ** (self.gamma - 1) if gas else -s["pressure"] * area * r**2
            return self.membrane(length * r)[2] + heat
        for name, gas in (("dry", False), ("breathing", True)):
            square = mpmath.diff(lambda r: energy(r, gas), s["radius"], 2) / mass
            s[name] = mpmath.sqrt(max(square, R(0)))
        return s

    def cold(self, n, near):
        constant = (self.gamma - 1) * self.U * self.A0 ** (self.gamma - 1)
        return self.at(n, lambda A, W: constant / A**self.gamma, near)


class Sphere:
    """A ball of gas in a thin sheet: roots between those of tan z = z, the sheet's law written out."""
    zeros = [R(0), *(mpmath.findroot(lambda z: mpmath.sin(z) - z * mpmath.cos(z), (n + R(1) / 2) * mp.pi - 1 / ((n + R(1) / 2) * mp.pi))
                     for n in range(1, 11))]

    def __init__(self, youngs_modulus, poisson_ratio, thickness, density, radius, stretch, neo_hookean, gas_density, gamma, velocity=1.0):
        E, nu, t, rho, r0, l, self.rho, self.gamma, self.v = (R(v) for v in (
            youngs_modulus, poisson_ratio, thickness, density, radius, stretch, gas_density, gamma, velocity))
        if neo_hookean:
            stress, slope = E / 3 * (1 - l**-6), 2 * E * l**-7
        else:
            stress, slope = E / (1 - nu) * (l**2 - 1) / 2, E / (1 - nu) * l
        self.r, self.m, self.n = l * r0, rho * t / l**2, t * stress
        self.p = 2 * self.n / self.r
        self.k = 2 * t * (l * slope - stress) / self.r**2
        self.c = mpmath.sqrt(self.gamma * self.p / self.rho)
        self.slow = mpmath.sqrt((self.k + 3 * self.gamma * self.p / self.r) / self.m)

    @staticmethod
    def turning(z):
        return mpmath.sin(z) / z**2 - mpmath.cos(z) / z

    def balance(self, w):
        z = w * self.r / self.c
        return self.k + self.rho * w * self.c * mpmath.sin(z) / z / self.turning(z) - self.m * w**2

    def omega(self, n, near):
        low, high = (z * self.c / self.r for z in self.zeros[n - 1 : n + 1])
        margin = (high - low) * R(10) ** -25
        return root(self.balance, low + margin, high - margin, near)

    def shape(self, s, w):
        z = w * self.r / self.c
        return self.turning(z * R(s)) / self.turning(z)

    def pressure(self, w):
        """At the centre, of a displacement of the sheet by 1."""
        z = w * self.r / self.c
        return -self.gamma * self.p / self.r * z / self.turning(z)
