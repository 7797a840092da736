"""The two numerical schemes for gas flows once more, in numpy and on whole columns: what they make of a coarse mesh.

A scheme is known to rounding, however coarse its mesh: each coefficient of it shows. States are density, velocity,
pressure. Written apart from the C++: HLLC in Toro's other form (10.41), contacts by bisection of the exact function
(4.5), limiters and edges by columns.
"""
import numpy


def conserved(w, g):
    return numpy.array([w[0], w[0] * w[1], w[2] / (g - 1) + w[0] * w[1] ** 2 / 2])


def primitive(q, g):
    return numpy.array([q[0], q[1] / q[0], (g - 1) * (q[2] - q[1] ** 2 / (2 * q[0]))])


def flux(w, g):
    return numpy.array([w[0] * w[1], w[0] * w[1] ** 2 + w[2], w[1] * (g / (g - 1) * w[2] + w[0] * w[1] ** 2 / 2)])


def sound(w, g):
    return numpy.sqrt(g * w[2] / w[0])


def cell_means(initial, edges, jumps, gamma):
    """Planar, by Gauss's rule of three points on each piece between jumps: also what that rule gets wrong."""
    nodes, weights = numpy.polynomial.legendre.leggauss(3)
    states = []
    for a, b in zip(edges[:-1], edges[1:]):
        ends, total = [a, *(j for j in jumps if a < j < b), b], numpy.zeros(3)
        for low, high in zip(ends[:-1], ends[1:]):
            x = (low + high) / 2 + (high - low) / 2 * nodes
            total += (conserved(initial(x), gamma) * weights).sum(axis=1) * (high - low) / 2
        states.append(primitive(total / (b - a), gamma))
    return numpy.array(states).T


# Finite volumes: MUSCL-Hancock on fixed cells (Toro, sections 9.5, 10.4 to 10.6, 14.4).
def pressure_estimate(l, r, g):
    a_l, a_r, du = sound(l, g), sound(r, g), r[1] - l[1]
    low, high = numpy.minimum(l[2], r[2]), numpy.maximum(l[2], r[2])
    primitive_variables = (l[2] + r[2]) / 2 - du * (l[0] + r[0]) / 2 * (a_l + a_r) / 2 / 2
    z = (g - 1) / (2 * g)
    left = numpy.maximum(a_l + a_r - (g - 1) / 2 * du, 0)
    two_rarefactions = (left / (a_l / l[2] ** z + a_r / r[2] ** z)) ** (1 / z)
    guess = numpy.maximum(primitive_variables, 0)
    g_l, g_r = (numpy.sqrt(2 / ((g + 1) * w[0]) / (guess + (g - 1) / (g + 1) * w[2])) for w in (l, r))
    two_shocks = (g_l * l[2] + g_r * r[2] - du) / (g_l + g_r)
    alike = (high / low <= 2) & (low <= primitive_variables) & (primitive_variables <= high)
    return numpy.where(alike, primitive_variables, numpy.where(primitive_variables < low, two_rarefactions, two_shocks))


def hllc(l, r, g):
    p = pressure_estimate(l, r, g)
    q_l, q_r = (numpy.sqrt(1 + (g + 1) / (2 * g) * numpy.maximum(p / w[2] - 1, 0)) for w in (l, r))
    s_l, s_r = l[1] - sound(l, g) * q_l, r[1] + sound(r, g) * q_r
    s = (r[2] - l[2] + l[0] * l[1] * (s_l - l[1]) - r[0] * r[1] * (s_r - r[1])) / (
        l[0] * (s_l - l[1]) - r[0] * (s_r - r[1]))
    def beside(w, edge):
        push = edge * (w[2] + w[0] * (edge - w[1]) * (s - w[1]))
        d = numpy.array([0 * s, 1 + 0 * s, s])
        return (s * (edge * conserved(w, g) - flux(w, g)) + push * d) / (edge - s)
    inner = numpy.where(s >= 0, beside(l, s_l), beside(r, s_r))
    return numpy.where(s_l >= 0, flux(l, g), numpy.where(s_r <= 0, flux(r, g), inner))


def harmonic(a, b):
    same = a * b > 0
    return numpy.where(same, 2 / (1 / numpy.where(same, a, 1) + 1 / numpy.where(same, b, 1)), 0)


def finite_volumes(w, length, g, end_time, courant):
    """Open ends. Cell means at the end, and the number of steps."""
    h, time, steps = length / w.shape[1], 0.0, 0
    while time < end_time:
        dt = courant * h / (abs(w[1]) + sound(w, g)).max() / (5 if steps < 5 else 1)
        dt = min(dt, end_time - time)
        wide = numpy.concatenate([w[:, [0, 0]], w, w[:, [-1, -1]]], axis=1)
        d = numpy.diff(wide, axis=1)
        slope, middle = harmonic(d[:, :-1], d[:, 1:]), wide[:, 1:-1]
        faces = [middle - slope / 2, middle + slope / 2]
        gain = dt / (2 * h) * (flux(faces[0], g) - flux(faces[1], g))
        later = [primitive(conserved(face, g) + gain, g) for face in faces]
        good = numpy.logical_and.reduce([(face[0] > 0) & (face[2] > 0) for face in later])
        left, right = (numpy.where(good, face, middle) for face in later)
        across = hllc(right[:, :-1], left[:, 1:], g)
        w = primitive(conserved(w, g) - dt / h * numpy.diff(across, axis=1), g)
        time, steps = (end_time if dt == end_time - time else time + dt), steps + 1
    return w, steps


# Cells that move with the gas, in the plane; in the cylinder from the axis to a free surface, without shocks.
def change(w, p, g):
    """Speed gained through the wave into a gas, Toro (4.6) to (4.9)."""
    shock = (p - w[2]) * numpy.sqrt(2 / ((g + 1) * p + (g - 1) * w[2]) / w[0])
    fan = 2 * sound(w, g) / (g - 1) * ((p / w[2]) ** ((g - 1) / (2 * g)) - 1)
    return numpy.where(p > w[2], shock, fan)


def contacts(l, r, z_l, z_r, g):
    """Pressure and velocity; linear where both waves are weaker than 0.3 %, else the root of the exact function."""
    p = (z_r * l[2] + z_l * r[2] + z_l * z_r * (l[1] - r[1])) / (z_l + z_r)
    u = (z_l * l[1] + z_r * r[1] + l[2] - r[2]) / (z_l + z_r)
    weak = (abs(p / l[2] - 1) < 3e-3) & (abs(p / r[2] - 1) < 3e-3)
    strong = numpy.nonzero(~weak)[0]
    l, r = l[:, strong], r[:, strong]
    low = numpy.log(numpy.minimum(l[2], r[2])) - 40
    high = numpy.log(numpy.maximum(l[2], r[2]) + numpy.maximum(l[0], r[0]) * (l[1] - r[1]) ** 2) + 3
    for _ in range(60):
        middle = (low + high) / 2
        over = change(l, numpy.exp(middle), g) + change(r, numpy.exp(middle), g) + r[1] - l[1] > 0
        low, high = numpy.where(over, low, middle), numpy.where(over, middle, high)
    p[strong] = star = numpy.exp((low + high) / 2)
    u[strong] = (l[1] + r[1] + change(r, star, g) - change(l, star, g)) / 2
    return p, u


def limited(back, front, to_back, to_front, half):
    """Change over half a cell: the harmonic mean of the gradients, each change weighed by the other's distance."""
    same = back * front > 0
    mean = 2 * half * back * front / numpy.where(same, back * to_front + front * to_back, 1)
    most = numpy.minimum(abs(back), abs(front))
    return numpy.where(same, numpy.clip(mean, -most, most), 0)


def mirrored(w):
    return w * numpy.array([[1], [-1], [1]])


def extended(w, walls):
    first, last = w[:, :1], w[:, -1:]
    return numpy.concatenate([mirrored(first) if walls else first, w, mirrored(last) if walls else last], axis=1)


class Moving:
    def __init__(self, edges, w, g, walls, free=False):
        self.x, self.w, self.g, self.walls, self.free = edges, w, g, walls, free
        self.m = w[0] * self.volumes()
        self.adiabat = w[2] / w[0] ** g
        self.e = w[2] / ((g - 1) * w[0]) + w[1] ** 2 / 2

    def volumes(self):
        return numpy.diff(self.x**2) / 2 if self.free else numpy.diff(self.x)

    def areas(self):
        return self.x if self.free else 1 + 0 * self.x

    def stable(self):
        w, g, wide = self.w, self.g, extended(self.w, self.walls)
        if self.free:
            wide[:, -1] = w[:, -1]
        p = numpy.maximum(numpy.maximum(wide[2, :-2], wide[2, 2:]), w[2])
        du = numpy.maximum(abs(w[1] - wide[1, :-2]), abs(wide[1, 2:] - w[1]))
        signal = numpy.sqrt(((g + 1) * p + (g - 1) * w[2]) / 2 * w[0]) + (g + 1) / 2 * du * w[0]
        return (self.m / (self.areas()[1:] * signal)).min()

    def faces(self, dt):
        w, g, m = self.w, self.g, numpy.concatenate([self.m[:1], self.m, self.m[-1:]])
        d, apart = numpy.diff(extended(w, self.walls), axis=1), (m[1:] + m[:-1]) / 2
        if not self.walls:
            d[:, [0, -1]] = 0
        half = limited(d[:, :-1], d[:, 1:], apart[:-1], apart[1:], self.m / 2)
        a, b = self.areas()[:-1], self.areas()[1:]
        swell = dt / (2 * self.m) * (b * (w[1] + half[1]) - a * (w[1] - half[1]))  # half a step's change of specific volume
        shift = numpy.array([-w[0] ** 2 * swell, -dt / self.m * (a + b) / 2 * half[2], -g * w[2] * w[0] * swell])
        left, right = w - half + shift, w + half + shift
        good = (left[[0, 2]] > 0).all(axis=0) & (right[[0, 2]] > 0).all(axis=0)
        good[-1] &= not self.free
        return numpy.where(good, left, w), numpy.where(good, right, w)

    def step(self, dt):
        (left, right), g, z = self.faces(dt), self.g, numpy.sqrt(self.g * self.w[2] * self.w[0])
        p, u = numpy.empty_like(self.x), numpy.empty_like(self.x)
        p[1:-1], u[1:-1] = contacts(right[:, :-1], left[:, 1:], z[:-1], z[1:], g)
        for k, face, pair in ((0, left[:, :1], lambda f: (mirrored(f), f)), (-1, right[:, -1:], lambda f: (f, mirrored(f)))):
            p[k], u[k] = face[2, 0], face[1, 0]
            if self.walls:
                own = numpy.sqrt(g * face[2] * face[0])
                p[k], u[k] = contacts(*pair(face), own, own, g)[0][0], 0
        if self.free:  # into vacuum
            p[-1], u[-1] = 0, right[1, -1] + 2 / (g - 1) * sound(right[:, -1], g)
        before = self.areas()
        self.x = self.x + dt * u
        swept = (before + self.areas()) / 2
        speed = self.w[1] - dt / self.m * (swept[1:] + swept[:-1]) / 2 * numpy.diff(p)
        self.e = self.e - dt / self.m * numpy.diff(swept * p * u)
        density = self.m / self.volumes()
        heated = (g - 1) * density * (self.e - speed**2 / 2)
        self.w = numpy.array([density, speed, self.adiabat * density**g if self.free else heated])


def moved(problem, cells, parts):
    """The gas at the end on the cells that it starts on: each piece between jumps has its share in multiples of parts."""
    (low, high), place = problem["ends"], problem.get("place", lambda s: s)
    pieces, edges = [low, *problem["jumps"], high], [low]
    for a, b in zip(pieces[:-1], pieces[1:]):
        n = parts * max(1, round((b - a) / (high - low) * cells / parts))
        edges += [a + (b - a) * place(k / n) for k in range(1, n)] + [b]
    edges = numpy.array(edges)
    gas = Moving(edges, cell_means(problem["initial"], edges, problem["jumps"], 1.4), 1.4, problem["walls"],
                 "place" in problem)
    time, dt = 0.0, 0.01 * 0.8 * gas.stable()
    while time < problem["time"]:
        dt = min(1.2 * dt, 0.8 * gas.stable(), problem["time"] - time)
        gas.step(dt)
        time = problem["time"] if dt == problem["time"] - time else time + dt
    return gas


def fields(gas, x, problem):
    """Density, velocity, pressure, specific energy at places: linear in cells, as at the start beyond open ends."""
    x = numpy.asarray(x)
    j = numpy.clip(numpy.searchsorted(gas.x, x, side="right") - 1, 0, len(gas.m) - 1)
    all_four = numpy.concatenate([gas.w, [gas.w[2] / ((gas.g - 1) * gas.w[0])]])
    centre, i = (gas.x[1:] + gas.x[:-1]) / 2, numpy.clip(j, 1, len(gas.m) - 2)
    half = (gas.x[i + 1] - gas.x[i]) / 2
    slope = limited(all_four[:, i] - all_four[:, i - 1], all_four[:, i + 1] - all_four[:, i], centre[i] - centre[i - 1],
                    centre[i + 1] - centre[i], half)
    found = all_four[:, j] + numpy.where(i == j, slope * (numpy.clip(x, gas.x[j], gas.x[j + 1]) - centre[j]) / half, 0)
    if gas.free:
        found[[0, 2, 3]] *= x <= gas.x[-1]
    if problem["walls"]:
        return found
    first = problem["initial"](numpy.array([problem["ends"][0]]))[1, 0]
    start = problem["initial"](x - first * problem["time"] * (x < gas.x[0]))
    start = numpy.concatenate([start, [start[2] / (0.4 * start[0])]])
    return numpy.where((x < gas.x[0]) | (x > gas.x[-1]), start, found)


def converged(problem, cells):
    """The flow on the finest of three meshes, and Roache's estimate of its mean errors over the domain, by field."""
    coarse, medium, fine = (moved(problem, cells * parts // 4, parts) for parts in (1, 2, 4))
    if fine.free:
        return fine, free_errors(problem, coarse, medium, fine)
    low, high = problem["domain"]
    x = numpy.concatenate([a + (b - a) * (numpy.arange(5) + 0.5) / 5 for a, b in zip(fine.x[:-1], fine.x[1:])])
    share = numpy.diff(fine.x).repeat(5) / 5 / (high - low) * ((x >= low) & (x <= high))
    middle = fields(medium, x, problem)
    finer = (share * abs(fields(fine, x, problem) - middle)).sum(axis=1)
    coarser = (share * abs(middle - fields(coarse, x, problem))).sum(axis=1)
    fall = 2.0 ** -numpy.clip(numpy.log2(coarser / finer), 0.5, 1)
    return fine, 1.25 * fall / (1 - fall) * numpy.maximum(finer, fall * coarser)


def free_errors(problem, coarse, medium, fine):
    """The same in the cylinder up to the free surface's known place: beyond the last edge the last cell's bound counts."""
    front, speed = problem["front"]
    parts = (numpy.arange(5) + 0.5) / 5
    x = fine.x[:-1, None] + numpy.diff(fine.x)[:, None] * parts
    middle, flat = fields(medium, x.ravel(), problem), x.ravel()
    near = abs(fields(fine, flat, problem) - middle).reshape(4, -1, 5)
    far = abs(middle - fields(coarse, flat, problem)).reshape(4, -1, 5)
    finer, coarser = ((d * fine.volumes()[:, None] / 5).sum(axis=(1, 2)) for d in (near, far))
    fall = 2.0 ** -numpy.clip(numpy.log2(coarser / finer), 0.5, 2)
    factor = 1.25 * fall / (1 - fall)
    last = factor * numpy.maximum(near[:, -5:].max(axis=(1, 2)), fall * far[:, -5:].max(axis=(1, 2)))
    last[1] = max(last[1], abs(speed - fine.w[1, -1]))
    whole = front**2 / 2
    return (factor * numpy.maximum(finer, fall * coarser) + last * (whole - fine.x[-1] ** 2 / 2)) / whole
