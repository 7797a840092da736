"""A second, independent computation of the step's limits: particles and nodes in loops, one update after the other.

The step is written as York's chapter 3 tells it, point by point, with scipy's B-splines for shapes; its matrix is what
it does to unit states. Waves are not assumed: a ring of cells holds them all. The reference knows none of this.
"""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.interpolate import BSpline
from second_values import is_near

UPDATES = {"usf": 0, "musl": 1, "usl": 2, "usavg": 3}
SHAPES = {"linear": 0, "boxes": 1, "quadratic": 2, "cubic": 3}
TRANSFERS = {"pic": 0, "flip": 1, "apic": 2, "xpic": 3, "fmpm": 4}
BLUR = {"linear": 1 / 12, "boxes": (1 / 6 + 1 / 48) / 2, "quadratic": 1 / 8, "cubic": 1 / 6}


def spline(degree):
    return BSpline.basis_element(numpy.arange(degree + 2) - (degree + 1) / 2, extrapolate=False)


def weight_and_gradient(shape, r, box):
    """At the distance r of the point from the node."""
    if shape == "boxes":
        tent = spline(1)
        low, high = (min(max(end, -1.0), 1.0) for end in (r - box / 2, r + box / 2))
        return float(tent.integrate(low, high)) / box, float(tent(high) - tent(low)) / box
    form = spline({"linear": 1, "quadratic": 2, "cubic": 3}[shape])
    return (float(numpy.nan_to_num(f(r))) for f in (form, form.derivative()))


class Bar:
    """Points of equal mass; `ring` cells that close on themselves, or None: nodes wherever there is mass."""

    def __init__(self, points, spacing, shape, ring=None):
        self.points, self.spacing = points, spacing
        self.links = []  # of each point: (node, weight, gradient, arm, inertia of the point)
        self.mass = {}
        for x in points:
            own = []
            for node in range(int(numpy.floor(x)) - 2, int(numpy.floor(x)) + 4):
                weight, gradient = weight_and_gradient(shape, x - node, spacing)
                if weight > 0:
                    own.append([node % ring if ring else node, weight, gradient, node - x])
            inertia = sum(link[1] * link[3] ** 2 for link in own)
            self.links.append([(*link, inertia) for link in own])
            for node, weight, *_ in own:
                self.mass[node] = self.mass.get(node, 0) + spacing * weight
        self.ring = ring
        self.blur = BLUR[shape]

    def sharpened(self, nodal, share):
        out = dict(nodal)
        for i in nodal:
            for j in (i - 1, i + 1):
                j = j % self.ring if self.ring else j
                if j in nodal:
                    both = 2 * self.mass[i] * self.mass[j] / (self.mass[i] + self.mass[j])
                    out[i] += share * self.blur / self.mass[i] * both * (nodal[i] - nodal[j])
        return out

    def mapped(self, velocity, slope):
        nodal = dict.fromkeys(self.mass, 0.0)
        for p, links in enumerate(self.links):
            for node, weight, _, arm, _ in links:
                nodal[node] += self.spacing * weight * (velocity[p] + slope[p] * arm) / self.mass[node]
        return nodal

    def filtered(self, nodal, order):
        left, total = dict(nodal), dict(nodal)
        for _ in range(1, order):
            seen = [sum(link[1] * left[link[0]] for link in links) for links in self.links]
            back = self.mapped(seen, [0.0] * len(seen))
            left = {i: left[i] - back[i] for i in left}
            total = {i: total[i] + left[i] for i in total}
        return total

    def step(self, state, dt, update, transfer, order, sharpening):
        count = len(self.points)
        velocity, slope, strain = (list(state[k * count : (k + 1) * count]) for k in range(3))

        def strained(nodal, time):
            smooth = self.sharpened(nodal, sharpening)
            for p, links in enumerate(self.links):
                strain[p] += time * sum(link[2] * smooth[link[0]] for link in links)

        start = self.mapped(velocity, slope)
        if update in ("usf", "usavg"):
            strained(start, dt / 2 if update == "usavg" else dt)
        pull = dict.fromkeys(self.mass, 0.0)
        for p, links in enumerate(self.links):
            for node, _, gradient, _, _ in links:
                pull[node] -= self.spacing * strain[p] * gradient / self.mass[node]
        pull = self.sharpened(pull, sharpening)
        end = {i: start[i] + dt * pull[i] for i in start}
        source = end
        if transfer == "fmpm":
            source = self.filtered(end, order)
        if transfer == "xpic":
            kept = self.filtered(start, order)
            source = {i: kept[i] + dt * pull[i] for i in kept}
        for p, links in enumerate(self.links):
            if transfer == "flip":
                velocity[p] += dt * sum(link[1] * pull[link[0]] for link in links)
            else:
                velocity[p] = sum(link[1] * source[link[0]] for link in links)
            if transfer == "apic":
                slope[p] = sum(link[1] * end[link[0]] * link[3] / link[4] for link in links)
        if update == "usl":
            strained(end, dt)
        if update in ("musl", "usavg"):
            strained(self.mapped(velocity, slope), dt / 2 if update == "usavg" else dt)
        return numpy.array(velocity + slope + strain)

    def growth(self, dt, *scheme):
        size = 3 * len(self.points)
        matrix = numpy.column_stack([self.step(unit, dt, *scheme) for unit in numpy.eye(size)])
        return numpy.max(numpy.abs(numpy.linalg.eigvals(matrix)))


def settings(update, shape, transfer, order, sharpening, **rest):
    return dict(integrator=UPDATES[update], shape=SHAPES[shape], transfer=TRANSFERS[transfer], order=order,
                sharpening=sharpening, **rest)


def schemes(seed, count):
    """Every update, shape and transfer several times, at random."""
    random = numpy.random.default_rng(seed)
    for _ in range(count):
        transfer = str(random.choice(list(TRANSFERS)))
        yield random, (str(random.choice(list(UPDATES))), str(random.choice(list(SHAPES))), transfer,
                       int(random.integers(1, 5)), float(random.choice([0.0, random.uniform()])))


def test_growth_of_all_waves_on_a_ring():
    cells = 8
    rows, requests = [], []
    for random, (update, shape, transfer, order, sharpening) in schemes(8, 60):
        per_cell, offset, courant = int(random.integers(1, 4)), random.uniform(0, 0.2), random.uniform(0.3, 3)
        points = [i + (k + 0.5) / per_cell + offset for i in range(cells) for k in range(per_cell)]
        bar = Bar(points, 1 / per_cell, shape, ring=cells)
        growth = bar.growth(courant, update, transfer, order, sharpening)
        rows.append((growth, (update, shape, transfer, order, sharpening, per_cell, offset, courant)))
        chosen = settings(update, shape, transfer, order, sharpening, points_per_cell=per_cell, offset=offset,
                          courant=courant)
        requests.append(request("mpm-stability", chosen, 2 * numpy.pi * numpy.arange(cells // 2 + 1) / cells))
    for (growth, case), answer in zip(rows, evaluate(requests)):
        seen = max(answer[3:])
        # A ring's double eigenvalues are known to the root of a rounding, 1e-8, times their condition.
        assert is_near(seen, growth, 2e-6 * growth), case


def limit_on_ring(cells, per_cell, offset, update, shape):
    """The least step at which something grows, by halving. It grows as the root of the excess, or as the excess: 2e-6 of growth is
    within 1e-5 of the limit. Points that are worst on a node stand 1e-7 of a cell beside it, where the node behind has a mass."""
    points = [i + (k + 0.5) / per_cell + offset - 1e-7 * (offset != 0) for i in range(cells) for k in range(per_cell)]
    bar = Bar(points, 1 / per_cell, shape, ring=cells)
    low, high = 0.05, 8.0
    while high - low > 1e-5:
        middle = (low + high) / 2
        stable = bar.growth(middle, update, "flip", 2, 0.0) <= 1 + 2e-6
        low, high = (middle, high) if stable else (low, middle)
    return low


@pytest.mark.parametrize("update", UPDATES)
def test_limits_of_a_ring(update):
    """FLIP on rings that hold the fastest wave. Where infinitely long waves grow first the longest of a ring stands for them: what
    that leaves falls at least with the first power of its number, so that twice as many cells are off by no more than both differ."""
    shape = "linear"
    for per_cell in (1, 2):
        chosen = settings(update, shape, "flip", 2, 0.0, points_per_cell=per_cell, offset=0.0)
        answer = {got.name: got for got in evaluate([request("mpm-stability", chosen)])[0]}
        for offset, name in ((0.0, "courant_limit"), (answer["worst_offset"].value, "worst_offset_limit")):
            coarse, fine = (limit_on_ring(cells, per_cell, offset, update, shape) for cells in (12, 24))
            assert is_near(answer[name], fine, abs(fine - coarse) + 2e-5), (per_cell, name, answer[name], coarse, fine)


@pytest.mark.parametrize("seed", [1, 2])
def test_limits_of_free_bars(seed):
    rows, requests = [], []
    for random, (update, shape, transfer, order, sharpening) in schemes(seed, 12):
        per_cell, cells = int(random.integers(1, 4)), int(random.integers(2, 6))
        depth = random.uniform(0.05, 0.95) / per_cell
        points = [-depth + i / per_cell for i in range(per_cell * cells)]
        bar = Bar(points, 1 / per_cell, shape)
        rows.append((bar, (update, transfer, order, sharpening), (shape, per_cell, cells, depth)))
        chosen = settings(update, shape, transfer, order, sharpening, points_per_cell=per_cell, depth=depth,
                          cells=cells)
        requests.append(request("mpm-edge-stability", chosen))
    for (bar, scheme, case), answer in zip(rows, evaluate(requests)):
        limit, bound = answer[0]
        assert bound <= 1e-9 * limit
        # Beyond the limit two eigenvalues part as the root of the excess or one leaves as the excess itself: 1e-4 is
        # above the 1e-7 to which a double one is known.
        assert bar.growth(0.9999 * limit, *scheme) <= 1 + 1e-6, (scheme, case)
        assert bar.growth(1.0001 * limit, *scheme) >= 1 + 2e-6, (scheme, case)
        assert bar.growth(0.5 * limit, *scheme) <= 1 + 1e-6, (scheme, case)


@pytest.mark.parametrize("integrator,update", [(0, "usf"), (1, "musl"), (2, "usl"), (3, "usavg")])
def test_closed_forms_of_one_point_a_cell(integrator, update):
    cells = 8
    for weight in (0.07, 0.31, 0.5):
        bar = Bar([i + weight for i in range(cells)], 1, "linear", ring=cells)
        for courant in (0.6, 1.3, 2.4):
            # A ring of 8 holds theta = pi, the fastest wave where N (1 - N) < 1/8 or straining last, and pi/2 at 1/2.
            growth = bar.growth(courant, update, "flip", 2, 0.0)
            chosen = dict(weight=weight, integrator=integrator)
            value, bound = evaluate([request("bar-stability", chosen, [courant])])[0][4]
            if update == "usl" or weight != 0.31:
                assert abs(growth - value) <= bound + 1e-6 * value
            else:
                assert growth <= value * (1 + 1e-6)


RUNS = {  # what a step does to (u, v) of u'' = -u
    "forward_euler": lambda u, v, w: (u + w * v, v - w * u),
    "explicit_midpoint": lambda u, v, w: (u + w * (v - w / 2 * u), v - w * (u + w / 2 * v)),
    "symplectic_euler": lambda u, v, w: (u + w * (v - w * u), v - w * u),
    "leapfrog": lambda u, v, w: (u + w * (v - w / 2 * u), v - w / 2 * u - w / 2 * (u + w * (v - w / 2 * u))),
}
NAMES = ("forward_euler", "explicit_midpoint", "symplectic_euler", "leapfrog", "ssp_rk3", "rk4", "newmark_trapezoid",
         "newmark_linear", "generalized_alpha")


def ssp_rk3(u, v, w):
    def euler(a, b):
        return a + w * b, b - w * a
    one = euler(u, v)
    two = euler(*one)
    two = tuple(0.75 * o + 0.25 * n for o, n in zip((u, v), two))
    three = euler(*two)
    return tuple(o / 3 + 2 * n / 3 for o, n in zip((u, v), three))


def rk4(u, v, w):
    def rate(a, b):
        return numpy.array([b, -a])
    y = numpy.array([u, v], dtype=float)
    k1 = rate(*y)
    k2 = rate(*(y + w / 2 * k1))
    k3 = rate(*(y + w / 2 * k2))
    k4 = rate(*(y + w * k3))
    return y + w / 6 * (k1 + 2 * k2 + 2 * k3 + k4)


def newmark(beta):
    def step(u, v, w):
        ahead = u + w * v - w * w * (0.5 - beta) * u
        new = ahead / (1 + beta * w * w)
        return new, v - w / 2 * (u + new)
    return step


def generalized_alpha(rho):
    alpha = (2 * rho - 1) / (1 + rho)
    gamma, beta = 1.5 - alpha, (5 - 3 * rho) / ((1 + rho) ** 2 * (2 - rho))

    def step(d, v, a, w):
        new = (-w * w * d - alpha * a) / (1 - alpha)
        return d + v + (0.5 - beta) * a + beta * new, v + (1 - gamma) * a + gamma * new, new
    return step


def test_growth_of_oscillators():
    for rho in (0.0, 0.3665, 0.5, 0.8, 1.0):
        steps = {**RUNS, "ssp_rk3": ssp_rk3, "rk4": rk4, "newmark_trapezoid": newmark(0.25),
                 "newmark_linear": newmark(1 / 6), "generalized_alpha": generalized_alpha(rho)}
        at = [0.2, 1.1, 1.7, 1.9, 2.2, 3.0, 3.6]
        answer = evaluate([request("oscillator-limits", dict(rho_b=rho), at)])[0]
        rows = answer[-len(at) * len(NAMES):]
        for i, w in enumerate(at):
            for name, (value, bound) in zip(NAMES, rows[i * len(NAMES) : (i + 1) * len(NAMES)]):
                size = 3 if name == "generalized_alpha" else 2
                matrix = numpy.column_stack([steps[name](*unit, w) for unit in numpy.eye(size)])
                growth = numpy.max(numpy.abs(numpy.linalg.eigvals(matrix)))
                assert abs(growth - value) <= bound + 1e-9 * value, (name, w, rho)
