"""The elastic pendulum in Cartesian coordinates by Taylor series of order 24 in extended precision, many at a time.

x'' = -f x, y'' = -1 - f y with f = kappa (1 - 1/r) where the string carries, else 0; in units of L0, sqrt(L0/g).
Steps are short against the axial period, so that truncation is far below rounding; a step ends where a one-way string
starts or stops to carry. Nothing is shared with the C++: other coordinates, other method, other precision.
"""
import numpy

X = numpy.longdouble
ORDER = 24
STEP = X("0.7")  # in units of 1/sqrt(kappa): 0.7^24/24! = 3e-28, and 1e-16 for the small third harmonic


def times(a, b, n):
    return sum(a[i] * b[n - i] for i in range(n + 1))


def series(x, y, u, v, kappa, carries):
    """Taylor coefficients of x and y; kappa is taken as 0 where the string does not carry."""
    k = numpy.where(carries, kappa, X(0))
    cx, cy = [x, u], [y, v]
    square, inverse = [], []  # r^2 and 1/r
    for n in range(ORDER - 1):
        square.append(times(cx, cx, n) + times(cy, cy, n))
        if n == 0:
            inverse.append(1 / numpy.sqrt(square[0]))
        else:  # s w' = -1/2 s' w for w = s^(-1/2)
            total = sum((X(i) / 2 + (n - i)) * square[i] * inverse[n - i] for i in range(1, n + 1))
            inverse.append(-total / (n * square[0]))
        share = (n + 1) * (n + 2)
        pull_x = k * (cx[n] - times(inverse, cx, n))
        pull_y = k * (cy[n] - times(inverse, cy, n)) + (1 if n == 0 else 0)
        cx.append(-pull_x / share)
        cy.append(-pull_y / share)
    return cx, cy


def value(c, t):
    total = c[-1]
    for a in reversed(c[:-1]):
        total = total * t + a
    return total


def rate(c, t):
    total = c[-1] * (len(c) - 1)
    for n in range(len(c) - 2, 0, -1):
        total = total * t + c[n] * n
    return total


def part(c, i):
    return [a[i] for a in c]


def first_zero(function, end):
    """Of many functions with f(0) and f(end) of opposite signs: bisection, then enough of it for extended precision."""
    low, high = numpy.zeros_like(end), end.copy()
    start = function(low)
    for _ in range(75):
        middle = (low + high) / 2
        same = numpy.signbit(function(middle)) == numpy.signbit(start)
        low, high = numpy.where(same, middle, low), numpy.where(same, high, middle)
    return (low + high) / 2


class Pendulums:
    """Many at once; all arguments are arrays."""

    def __init__(self, kappa, angle, strain, one_way):
        self.kappa, self.one_way = X(kappa), numpy.array(one_way, dtype=bool)
        r = 1 + X(strain)
        self.x, self.y = r * numpy.sin(X(angle)), -r * numpy.cos(X(angle))
        self.u, self.v, self.t = (numpy.zeros_like(self.x) for _ in range(3))
        self.carries = (X(strain) >= 0) | ~self.one_way
        self.longest = STEP / numpy.sqrt(self.kappa)

    def until_change(self, cx, cy, h):
        """The step at which each one-way string starts or stops to carry, h where it does not. A visit to the other
        side within a step shows by the rate of r changing its sign."""
        side = numpy.where(self.carries, X(1), X(-1))

        def stretch(t, i=slice(None)):
            x, y = part(cx, i), part(cy, i)
            return side[i] * (value(x, t) ** 2 + value(y, t) ** 2 - 1)

        def stretching(t, i=slice(None)):
            x, y = part(cx, i), part(cy, i)
            return side[i] * (value(x, t) * rate(x, t) + value(y, t) * rate(y, t))

        end = h.copy()
        nearest = numpy.nonzero(self.one_way & (stretching(0 * h) < 0) & (stretching(h) > 0))[0]
        if nearest.size:
            end[nearest] = first_zero(lambda t: stretching(t, nearest), h[nearest])
        wrong = self.one_way & (stretch(end) < 0) & (h > 0)
        i = numpy.nonzero(wrong)[0]
        if i.size:
            early = h[i] * X("1e-6")  # away from a border where the step starts
            h = h.copy()
            h[i] = first_zero(lambda t: stretch(early + t, i), end[i] - early) + early
        return h, wrong

    def step(self, left):
        """Each by its own step, at most `left`. Returns the series and the lengths of the steps."""
        h = numpy.minimum(self.longest, left)
        cx, cy = series(self.x, self.y, self.u, self.v, self.kappa, self.carries)
        h, changes = self.until_change(cx, cy, h)
        self.x, self.y, self.u, self.v = value(cx, h), value(cy, h), rate(cx, h), rate(cy, h)
        self.t = self.t + h
        self.carries = numpy.where(changes, ~self.carries, self.carries)
        return cx, cy, h

    def advance_to(self, time):
        while (self.t < time).any():
            before = self.t
            self.step(time - self.t)
            self.t = numpy.where(time - self.t < X("1e-18") * (1 + time), time, self.t)
            assert ((self.t > before) | (before >= time)).all()

    def zeros(self, count, quantities, end):
        """For each quantity(x, y, u, v), each pendulum: times of the first `count` zeros before `end`, angles there."""
        found = [[[] for _ in self.x] for _ in quantities]
        while min(len(f) for each in found for f in each) < count and (self.t < end).any():
            start, old = self.t, [q(self.x, self.y, self.u, self.v) for q in quantities]
            cx, cy, h = self.step(numpy.full_like(self.t, X(1)))
            for quantity, before, times_found in zip(quantities, old, found):
                crossed = numpy.nonzero(before * quantity(self.x, self.y, self.u, self.v) < 0)[0]
                if crossed.size:
                    x, y = part(cx, crossed), part(cy, crossed)
                    def at(t):
                        return quantity(value(x, t), value(y, t), rate(x, t), rate(y, t))
                    inside = first_zero(at, h[crossed])
                    angles = numpy.arctan2(value(x, inside), -value(y, inside))
                    for i, time, angle in zip(crossed, start[crossed] + inside, angles):
                        times_found[i].append((time, angle))
        return found


def turns(x, y, u, v):
    return x * v - y * u


def verticals(x, y, u, v):
    return x
