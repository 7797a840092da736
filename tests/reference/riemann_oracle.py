"""The Riemann problem in 60-digit arithmetic, written apart from the C++: Newton's method on the exact inputs."""
import mpmath

mp = mpmath.mp
mp.dps = 60
R = mpmath.mpf


class Side:
    def __init__(self, density, velocity, pressure, gamma, sign):
        self.r, self.u, self.p, self.g, self.sign = R(density), R(velocity), R(pressure), R(gamma), sign
        self.c = mpmath.sqrt(self.g * self.p / self.r)

    def shock(self, p):
        return p > self.p

    def change(self, p):  # speed gained or lost through the wave, and its derivative
        g = self.g
        if self.shock(p):
            a, b = 2 / ((g + 1) * self.r), (g - 1) / (g + 1) * self.p
            root = mpmath.sqrt(a / (p + b))
            return (p - self.p) * root, root * (1 - (p - self.p) / (2 * (p + b)))
        if p == 0:
            return -2 * self.c / (g - 1), None
        power = (p / self.p) ** ((g - 1) / (2 * g))
        return 2 * self.c / (g - 1) * (power - 1), self.c * power / (g * p)

    def density(self, p):
        g = (self.g - 1) / (self.g + 1)
        if self.shock(p):
            return self.r * (p + g * self.p) / (g * p + self.p)
        return self.r * (p / self.p) ** (1 / self.g) if p else R(0)

    def speeds(self, p, velocity):  # head and tail
        if self.shock(p):
            flux = mpmath.sqrt(((self.g + 1) * p + (self.g - 1) * self.p) * self.r / 2)
            return (self.u + self.sign * flux / self.r,) * 2
        tail = mpmath.sqrt(self.g * p / self.density(p)) if p else 0
        return self.u + self.sign * self.c, velocity + self.sign * tail

    def ray(self, xi):
        g, s = self.g, self.sign
        c = (2 * self.c - s * (g - 1) * (self.u - xi)) / (g + 1)
        density = self.r * (c / self.c) ** (2 / (g - 1))
        return density, xi - s * c, density * c * c / g


class Solution:
    def __init__(self, left, right, gamma):
        self.g, self.vacuum = R(gamma), True
        self.left = Side(*left, gamma, -1) if left[0] else None
        self.right = Side(*right, gamma, +1) if right[0] else None
        self.p = R(0)
        if self.left and self.right:
            self.p = self.star_pressure()
            self.vacuum = self.total(R(0))[0] >= 0
        l, r = self.left, self.right
        front_l = l.u - l.change(self.p)[0] if l else None
        front_r = r.u + r.change(self.p)[0] if r else None
        front_l, front_r = front_l if l else front_r, front_r if r else front_l
        self.u = (front_l + front_r) / 2
        self.rl = l.density(self.p) if l else R(0)
        self.rr = r.density(self.p) if r else R(0)
        self.edges = [*(l.speeds(self.p, front_l) if l else (front_r, front_r)), self.u,
                      *(reversed(r.speeds(self.p, front_r)) if r else (front_l, front_l))]

    def total(self, p):
        (a, da), (b, db) = self.left.change(p), self.right.change(p)
        return a + b + self.right.u - self.left.u, None if da is None else da + db

    def star_pressure(self):
        l, r, g = self.left, self.right, self.g
        if self.total(R(0))[0] >= 0:
            return R(0)
        low = min(l.p, r.p)
        if self.total(low)[0] >= 0:  # two rarefactions: closed form
            z = (g - 1) / (2 * g)
            return ((l.c + r.c - (g - 1) / 2 * (r.u - l.u)) / (l.c / l.p**z + r.c / r.p**z)) ** (1 / z)
        p = low  # the function is concave: Newton from the left never overshoots
        for _ in range(300):
            value, slope = self.total(p)
            step = -value / slope
            p += step
            if abs(step) < p * R(10) ** -55:
                return p
        raise ArithmeticError("no convergence")

    def sample(self, xi):  # density, velocity, pressure, energy; the value on the right at a jump
        xi, e = R(xi), self.edges
        l, r = self.left, self.right
        if xi < e[0]:
            state = (l.r, l.u, l.p) if l else (R(0), self.u, R(0))
        elif xi < e[1]:
            state = l.ray(xi)
        elif xi < e[3] and self.vacuum:
            state = R(0), xi, R(0)
        elif xi < e[2]:
            state = self.rl, self.u, self.p
        elif xi < e[3]:
            state = self.rr, self.u, self.p
        elif xi < e[4]:
            state = r.ray(xi)
        else:
            state = (r.r, r.u, r.p) if r else (R(0), self.u, R(0))
        energy = state[2] / ((self.g - 1) * state[0]) if state[0] else R(0)
        return (*state, energy)
