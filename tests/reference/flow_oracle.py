"""The exact gas flows in 50-digit arithmetic, apart from the C++ and with other formulas where there are any."""
import mpmath
from second_values import agrees

mp = mpmath.mp
mp.dps = 50
R = mpmath.mpf


def covers(answer, true):
    return answer[1] == mpmath.inf or agrees(answer, R(true))


def measure(dimension):
    return {1: R(2), 2: 2 * mp.pi, 3: 4 * mp.pi}[dimension]


def noh(dimension, gamma, density, velocity):
    """shock speed, density, pressure, energy behind: mass and momentum over a shock into gas of the known density"""
    g, u = R(gamma), R(velocity)
    speed = (g - 1) * u / 2
    ahead = R(density) * (1 + u / speed) ** (dimension - 1)
    behind = ahead * (speed + u) / speed
    return speed, behind, ahead * u * (u + speed), u * u / 2


def piston(velocity, density, pressure, gamma):
    """shock speed, density, pressure, energy behind, by the Mach number: u = 2 c/(gamma + 1) (M - 1/M)"""
    g, rho, p = R(gamma), R(density), R(pressure)
    c = mpmath.sqrt(g * p / rho)
    half = (g + 1) * R(velocity) / (4 * c)
    mach = half + mpmath.sqrt(half**2 + 1)
    pressure_behind = p * (1 + 2 * g / (g + 1) * (mach**2 - 1))
    density_behind = rho * (g + 1) * mach**2 / ((g - 1) * mach**2 + 2)
    return mach * c, density_behind, pressure_behind, pressure_behind / ((g - 1) * density_behind)


class Affine:
    """Time as a function of the speed or the radius of the edge by hypergeometric functions, inverted by Newton."""

    def __init__(self, dimension, edge, density, pressure, gamma):
        self.d, self.r0, self.rho, self.p, self.g = dimension, R(edge), R(density), R(pressure), R(gamma)
        self.n = dimension * (self.g - 1)
        self.final = mpmath.sqrt(4 * self.g * self.p / (dimension * self.rho)) / (self.g - 1)

    def by_speed(self, s):  # t final/r0 and its derivative, s = R'/final
        b = 1 + 1 / self.n
        return 2 / self.n * s * mpmath.hyp2f1(b, R(1) / 2, R(3) / 2, s * s), 2 / self.n * (1 - s * s) ** -b

    def edge(self, time, guess_speed, guess_radius):
        """radius and speed at a time; the guesses need only be good to some digits"""
        with mp.workdps(130):  # late edges have 1 - s^2 as small as 1e-40
            goal = R(time) * self.final / self.r0
            s = R(guess_speed) / self.final
            if R(guess_radius) > 2 * self.r0:
                s = mpmath.sqrt(1 - (self.r0 / R(guess_radius)) ** self.n)
            for _ in range(8):
                value, slope = self.by_speed(s)
                step = (goal - value) / slope
                s += step
                if abs(step) < R(10) ** -40 * s * (1 - s * s):
                    return self.r0 * (1 - s * s) ** (-1 / self.n), s * self.final
        raise ArithmeticError("no convergence")

    def sample(self, radius, edge, speed):
        xi, y = R(radius) / edge, edge / self.r0
        if xi >= 1:
            return R(0), speed, R(0), R(0)
        q = 1 - xi * xi
        density = self.rho * y**-self.d * q ** (1 / (self.g - 1))
        pressure = self.p * y ** (-self.d * self.g) * q ** (self.g / (self.g - 1))
        return density, speed * xi, pressure, pressure / ((self.g - 1) * density)

    def mass(self):
        return measure(self.d) * self.rho * self.r0**self.d * mpmath.beta(R(self.d) / 2, 1 + 1 / (self.g - 1)) / 2

    def energy(self):
        a = self.g / (self.g - 1)
        return measure(self.d) * self.p / (self.g - 1) * self.r0**self.d * mpmath.beta(R(self.d) / 2, 1 + a) / 2


class Wave:
    """The simple wave: the foot of the characteristic by bisection, then Newton."""

    def __init__(self, amplitude, centre, half_width, density, pressure, gamma):
        self.a, self.x0, self.w, self.rho, self.p, self.g = map(
            R, (amplitude, centre, half_width, density, pressure, gamma))
        self.c = mpmath.sqrt(self.g * self.p / self.rho)

    def velocity(self, position, time):
        place, lead = R(position) - self.x0 - self.c * R(time), (self.g + 1) / 2 * self.a * R(time)
        if abs(place) >= self.w:
            return R(0)
        low, high = R(-1), R(1)
        for _ in range(30):
            s = (low + high) / 2
            if self.w * s + lead * (1 - s * s) ** 6 < place:
                low = s
            else:
                high = s
        for _ in range(30):  # the function rises: Newton stays, bisection where it would leave
            f = self.w * s + lead * (1 - s * s) ** 6 - place
            step = f / (self.w - 12 * lead * s * (1 - s * s) ** 5)
            s -= step
            if abs(step) < R(10) ** -46:
                return self.a * (1 - s * s) ** 6
        raise ArithmeticError("no convergence")

    def sample(self, position, time):
        u = self.velocity(position, time)
        ratio = (self.c + (self.g - 1) / 2 * u) / self.c
        density, pressure = self.rho * ratio ** (2 / (self.g - 1)), self.p * ratio ** (2 * self.g / (self.g - 1))
        return density, u, pressure, pressure / ((self.g - 1) * density)


class Sedov:
    """The formulas of Kamm and Timmes (2007) as printed, in V with exponents a0 ... a5; gamma = 2 is singular there."""

    def __init__(self, dimension, gamma, density, energy):
        self.j, self.g, self.rho, self.e = dimension, R(gamma), R(density), R(energy)
        j, g = self.j, self.g
        self.v0, self.v2 = 2 / ((j + 2) * g), 4 / ((j + 2) * (g + 1))
        self.a0, self.a2 = R(2) / (j + 2), -(g - 1) / (2 * (g - 1) + j)
        self.a1 = (j + 2) * g / (2 + j * (g - 1)) * (2 * j * (2 - g) / (g * (j + 2) ** 2) - self.a2)
        self.a3, self.a4, self.a5 = j / (2 * (g - 1) + j), self.a1 * (j + 2) / (2 - g), -2 / (2 - g)
        self.a, self.b, self.c = (j + 2) * (g + 1) / 4, (g + 1) / (g - 1), (j + 2) * g / 2
        self.d = (j + 2) * (g + 1) / ((j + 2) * (g + 1) - 2 * (2 + j * (g - 1)))
        self.ee = (2 + j * (g - 1)) / 2

    def functions(self, x2):  # of x2 = b (c V - 1); lambda, f, g, h
        v = (x2 / self.b + 1) / self.c
        x1, x3, x4 = self.a * v, self.d * (1 - self.ee * v), self.b * (1 - self.c * v / self.g)
        radius = x1**-self.a0 * x2**-self.a2 * x3**-self.a1
        density = x2**self.a3 * x3**self.a4 * x4**self.a5
        pressure = x1 ** (self.a0 * self.j) * x3 ** (self.a4 - 2 * self.a1) * x4 ** (1 + self.a5)
        slope = (-self.a0 / v - self.a1 * -self.ee / (1 - self.ee * v)) / (self.b * self.c) - self.a2 / x2
        return radius, x1 * radius, density, pressure, slope  # slope = d log lambda/d x2

    def alpha(self):
        k = -self.a2 * self.j  # x2 = y^(1/k) takes the singularity at the centre away

        def integrand(y):
            x2 = y ** (1 / k)
            radius, f, g, h, slope = self.functions(x2)
            return (g * f * f + h) * radius**self.j * slope * x2 / (k * y)

        both = mpmath.quad(integrand, [0, R(1) / 2, R(9) / 10, 1])
        return measure(self.j) * (R(2) / (self.j + 2)) ** 2 * 2 / (self.g**2 - 1) * both

    def x2_of(self, radius):
        low, high = R(0), R(1)  # of x2^-a2, nearly proportional to the radius
        for _ in range(20):
            middle = (low + high) / 2
            low, high = (middle, high) if self.functions(middle ** (-1 / self.a2))[0] < radius else (low, middle)
        x2 = high ** (-1 / self.a2)
        for _ in range(40):  # Newton on log radius against log x2
            now, *_, slope = self.functions(x2)
            step = mpmath.log(radius / now) / (slope * x2)
            x2 = min(x2 * mpmath.exp(step), R(1))
            if abs(step) < R(10) ** -24:
                return x2
        raise ArithmeticError("no convergence")

    def sample(self, radius, time, alpha):
        shock = (self.e * R(time) ** 2 / (alpha * self.rho)) ** (R(1) / (self.j + 2))
        speed = 2 * shock / ((self.j + 2) * R(time))
        if radius >= shock:
            return self.rho, R(0), R(0), R(0)
        _, f, g, h, _ = self.functions(self.x2_of(R(radius) / shock))
        density, pressure = self.rho * self.b * g, 2 * self.rho * speed**2 / (self.g + 1) * h
        return density, 2 * speed / (self.g + 1) * f, pressure, pressure / ((self.g - 1) * density)
