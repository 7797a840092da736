"""The liquid-filled tube in 40-digit arithmetic, by Legendre's integrals of mpmath."""
import mpmath
from second_values import agrees

mpmath.mp.dps = 40
R = mpmath.mpf


def covers(answer, true):
    return agrees(answer, R(true), abs(true) * R(10) ** -30)


class Tube:
    """v = (k/k')^2 by bisection up from 0 to the first root, everything else from the modulus."""

    def __init__(self, perimeter, specific_weight, top_pressure, compliance):
        self.L0, self.w, self.p1, self.c = (R(x) for x in (perimeter, specific_weight, top_pressure, compliance))
        self.v = self.root() if self.w else R(0)
        self.m, self.kept = self.v / (1 + self.v), 1 / mpmath.sqrt(1 + self.v)
        self.p0 = self.p1 / self.kept
        if self.w:
            self.T = self.p1**2 * self.v / (4 * self.w)
        else:  # 2 pi T/p = L0 (1 + c T)
            self.T = self.L0 / (2 * mpmath.pi / self.p0 - self.c * self.L0)
        self.l, self.L = self.T / self.p0, self.L0 * (1 + self.c * self.T)
        self.b = self.L - 4 * self.l * mpmath.ellipk(self.m)

    def excess(self, v):
        """Length of the curve for v less that of the membrane, over 2 p1/w."""
        m = v / (1 + v)
        length = (mpmath.ellipk(m) - mpmath.ellipe(m)) * mpmath.sqrt(1 + v)
        return length - self.w * self.L0 / (2 * self.p1) - self.c * self.p1 * self.L0 * v / 8

    def root(self):
        """The excess is concave in v and negative at 0: bracketed by its largest value."""
        low, high = R(0), R(1)
        def slope(v):
            return mpmath.ellipk(v / (1 + v)) / (2 * mpmath.sqrt(1 + v)) - self.c * self.p1 * self.L0 / 8
        while self.excess(high) < 0:
            if slope(high) <= 0:
                a, b = R(0), high
                for _ in range(150):
                    mid = (a + b) / 2
                    a, b = (mid, b) if slope(mid) > 0 else (a, mid)
                if self.excess(a) < 0:
                    raise ValueError("no equilibrium")
                high = a
            else:
                low, high = high, 2 * high
        guess = mpmath.findroot(self.excess, (low, high), solver="anderson", tol=R(10) ** -70, maxsteps=400,
                                verify=False)
        assert low <= guess <= high
        return guess

    def values(self):
        height = (self.p0 - self.p1) / self.w if self.w else self.L / mpmath.pi
        area = self.p0 * self.b / self.w if self.w else self.L**2 / (4 * mpmath.pi)
        quarter = self.curve(mpmath.pi / 4)
        contact = self.b if self.w else R(0)
        return height, 2 * quarter[0], contact, self.T, self.c * self.T, area, self.p0

    def curve(self, phi):
        """x, y, pressure at half the tangent's angle phi."""
        m, sine = self.m, mpmath.sin(phi)
        F = mpmath.ellipf(phi, m)
        moved = 2 * self.l * (F - 2 * (F - mpmath.ellipe(phi, m)) / m) if m else self.l * mpmath.sin(2 * phi)
        p = self.p0 * mpmath.sqrt(1 - m * sine**2)
        y = (self.p0 - p) / self.w if self.w else 2 * self.l * sine**2
        return (self.b if self.w else 0) / 2 + moved, y, p

    def at(self, along):
        along = R(along)
        left = along > self.L0 / 2
        s = (self.L0 - along if left else along) * (1 + self.c * self.T)
        u = (s - (self.b if self.w else 0) / 2) / (2 * self.l)
        if u <= 0:
            x, y, angle, bend, p = s, R(0), R(0), R(0), self.p0
        else:
            phi = mpmath.asin(mpmath.ellipfun("sn", u, m=self.m))
            x, y, p = self.curve(phi)
            angle, bend = 2 * phi, p / self.T
        return (-x if left else x), y, (2 * mpmath.pi - angle if left else angle), bend, p
