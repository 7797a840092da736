"""Second, independent computations of gas and membrane together: finite elements, integration, general solvers."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import fsolve
from second_values import is_near

PISTONS = {
    "york": dict(spring_modulus=2000, spring_length=20, spring_density=1e-3, area=1, mass=0.1, gas_density=1e-4,
                 bulk_modulus=1.58e6, gas_length=20, velocity=-1),
    "massless": dict(spring_modulus=2000, spring_length=20, spring_density=0, area=1, mass=1, gas_density=1e-4,
                     bulk_modulus=1.58e6, gas_length=20, velocity=-1),
    "alike": dict(spring_modulus=3, spring_length=1.3, spring_density=0.7, area=0.4, mass=0.35, gas_density=0.2,
                  bulk_modulus=1.9, gas_length=0.8, velocity=0.6),
}


def piston_elements(p, n):
    """Linear elements with consistent masses, n in the gas and n in the spring (one if it has no mass)."""
    in_spring = n if p["spring_density"] else 1
    nodes = n + in_spring + 1
    stiffness, mass = numpy.zeros((nodes, nodes)), numpy.zeros((nodes, nodes))
    for e in range(nodes - 1):
        gas = e < n
        modulus, density = (p["bulk_modulus"], p["gas_density"]) if gas else (p["spring_modulus"], p["spring_density"])
        h = p["gas_length"] / n if gas else p["spring_length"] / in_spring
        stiffness[e : e + 2, e : e + 2] += modulus * p["area"] / h * numpy.array([[1, -1], [-1, 1]])
        mass[e : e + 2, e : e + 2] += density * p["area"] * h / 6 * numpy.array([[2, 1], [1, 2]])
    mass[n, n] += p["mass"]
    squares, shapes = eigh(stiffness[1:-1, 1:-1], mass[1:-1, 1:-1])
    return numpy.sqrt(squares), shapes[n - 1]


@pytest.mark.parametrize("name", PISTONS)
def test_piston_by_elements(name):
    """Six frequencies and participations: errors of order h^2 from above, two Richardson steps."""
    p = PISTONS[name]
    w, b = [], []
    for n in (80, 160, 320):
        omega, piston = piston_elements(p, n)
        w.append(omega[:6])
        b.append(p["velocity"] * p["mass"] * piston[:6] ** 2 / omega[:6])  # masses are 1
    answer = numpy.array(evaluate([request("piston-container", p)])[0])[:, 0]
    for levels, exact in ((w, answer[2:8]), (b, answer[8:14])):
        first, second = (4 * levels[1] - levels[0]) / 3, (4 * levels[2] - levels[1]) / 3
        best = (16 * second - first) / 15
        scale = numpy.abs(exact) if levels is w else numpy.max(numpy.abs(exact))
        # the correction over 15 bounds what is left; 1e-8 for an eigensolver that resolves 1e-16 of the largest square
        assert numpy.all(numpy.abs(best - exact) <= numpy.abs(second - first) / 15 + 1e-8 * scale), name
        assert numpy.all(numpy.abs(second - first) <= 1e-3 * scale)


def test_piston_motion_by_elements():
    """All of the modes of 800 elements, summed; the kinks at the echoes leave first order in the velocity."""
    p = PISTONS["alike"]
    times = numpy.linspace(0, 6, 25)
    answer = numpy.array(evaluate([request("piston-container", p, times)])[0])[16:, 0].reshape(-1, 4)
    errors = []
    for n in (100, 200, 400):
        omega, piston = piston_elements(p, n)
        share = p["velocity"] * p["mass"] * piston**2
        errors.append(numpy.max(numpy.abs((share / omega) @ numpy.sin(numpy.outer(omega, times)) - answer[:, 0])))
    assert errors[-1] <= 1e-4 and errors[0] / errors[1] >= 2 and errors[1] / errors[2] >= 2  # at least first order


RINGS = {
    "soft": dict(youngs_modulus=2e3, poisson_ratio=0.3, thickness=0.1, radius=1.4, line_mass=0.05, pressure=30.8,
                 gas_density=0.3083, gamma=1.4, law=0),
    "accumulated": dict(youngs_modulus=2e3, poisson_ratio=0.3, thickness=0.1, radius=1.4, line_mass=0.05, pressure=30.8,
                        gas_density=0.3083, gamma=1.4, law=1),
    "other": dict(youngs_modulus=700, poisson_ratio=-0.1, thickness=0.03, radius=0.6, line_mass=0.4, pressure=12.0,
                  gas_density=1.7, gamma=1.67, law=0),
}


def breathing_elements(p, k, n, around):
    """The gas's radial displacement in linear elements: int gamma p (xi' + around xi/r)^2 r^around dr, in a disc (around = 1) or a ball
    (2), whose edge has the mass p["line_mass"] and the stiffness k per area: the last node."""
    R = p["radius"]
    h = R / n
    stiffness, mass = numpy.zeros((n + 1, n + 1)), numpy.zeros((n + 1, n + 1))
    points, weights = numpy.polynomial.legendre.leggauss(4)
    for e in range(n):
        for at, weight in zip(points, weights):
            s = (at + 1) / 2
            r = (e + s) * h
            area = weight * h / 2 * r**around
            shape = numpy.array([1 - s, s])
            dilation = numpy.array([-1, 1]) / h + around * shape / r
            stiffness[e : e + 2, e : e + 2] += area * p["gamma"] * p["pressure"] * numpy.outer(dilation, dilation)
            mass[e : e + 2, e : e + 2] += area * p["gas_density"] * numpy.outer(shape, shape)
    stiffness[n, n] += k * R**around
    mass[n, n] += p["line_mass"] * R**around
    squares, shapes = eigh(stiffness[1:, 1:], mass[1:, 1:])
    return numpy.sqrt(squares), shapes


def extrapolated(p, k, around):
    """Five frequencies from three meshes, and what the last mesh leaves."""
    levels = [breathing_elements(p, k, n, around)[0][:5] for n in (60, 120, 240)]
    first, second = (4 * levels[1] - levels[0]) / 3, (4 * levels[2] - levels[1]) / 3
    return (16 * second - first) / 15, numpy.abs(second - first)


@pytest.mark.parametrize("name", RINGS)
def test_ring_by_elements(name):
    """Frequencies of ring and gas, k_s from the tension by differences: the law is integrated, not differentiated here."""
    p = RINGS[name]
    R, modulus, t = p["radius"], p["youngs_modulus"] / (1 - p["poisson_ratio"] ** 2), p["thickness"]
    answer = numpy.array(evaluate([request("gas-ring", p)])[0])[:, 0]
    def tension(r):
        if p["law"] == 0:
            return modulus * t * (r / answer[1] - 1)
        strain = solve_ivp(lambda x, _: [1 / x], (answer[1], r), [0.0], rtol=1e-12, atol=1e-15).y[0, -1]
        return modulus * strain * t * R / r  # constant volume: thickness t at R
    assert tension(R) == pytest.approx(p["pressure"] * R, rel=1e-9)
    h = 1e-3 * R
    k = (8 * (tension(R + h) - tension(R - h)) - tension(R + 2 * h) + tension(R - 2 * h)) / (12 * h)
    k = (k - tension(R) / R) / R
    assert k == pytest.approx(answer[2], rel=1e-7)
    best, change = extrapolated(p, k, 1)
    # the correction over 15, doubled: the logarithm of the first element's energy spoils the last step a little
    assert numpy.all(numpy.abs(best - answer[5:10]) <= change / 7 + 1e-7 * answer[5:10])
    assert numpy.all(change <= 1e-4 * answer[5:10])


SPHERES = {
    "default": dict(youngs_modulus=1.0, poisson_ratio=0.3, thickness=0.01, density=1.0, radius=1.0, stretch=1.2, gas_density=0.01,
                    gamma=1.4, neo_hookean=0),
    "rubber": dict(youngs_modulus=3.0, poisson_ratio=0.5, thickness=0.02, density=0.7, radius=0.6, stretch=1.3, gas_density=0.05,
                   gamma=1.67, neo_hookean=1),
}


@pytest.mark.parametrize("name", SPHERES)
def test_sphere_by_elements(name):
    """Frequencies of sheet and gas, the sheet by its energy: pressure and stiffness are its first and second differences here."""
    p = SPHERES[name]
    R, E, nu, t = p["stretch"] * p["radius"], p["youngs_modulus"], p["poisson_ratio"], p["thickness"]
    answers = evaluate([request("gas-sphere", p)])[0]
    answer = numpy.array(answers)[:, 0]
    def energy(r):  # of the whole sheet, over 4 pi
        c = (r / p["radius"]) ** 2
        density = E / 6 * (2 * c + c**-2 - 3) if p["neo_hookean"] else E / (1 - nu) * (c - 1) ** 2 / 4
        return t * p["radius"] ** 2 * density
    def pull(r):  # the pressure that holds it, p r^2 = dU/dr
        h = 1e-3 * R
        return (8 * (energy(r + h) - energy(r - h)) - energy(r + 2 * h) + energy(r - 2 * h)) / (12 * h)
    pressure, h = pull(R) / R**2, 4e-3 * R
    assert is_near(answers[0], pressure, 1e-8 * pressure)
    rise = (8 * (pull(R + h) - pull(R - h)) - pull(R + 2 * h) + pull(R - 2 * h)) / (12 * h)
    k = (rise - 2 * pressure * R) / R**2
    assert is_near(answers[2], k, 1e-6 * k)
    gas = dict(p, radius=R, pressure=pressure, line_mass=p["density"] * t / p["stretch"] ** 2)
    best, change = extrapolated(gas, answer[2], 2)
    assert all(is_near(got, own, left / 7 + 1e-7 * own) for got, own, left in zip(answers[5:10], best, change))
    assert numpy.all(change <= 1e-4 * answer[5:10])


def test_breathing_of_a_ring_in_time():
    """The gas in 240 elements and the ring set off with mode 2: it stays that mode, and its pressure follows."""
    p = dict(RINGS["soft"], mode=2, velocity=0.3)
    answer = numpy.array(evaluate([request("gas-ring", p, [0.02, 0.11])])[0])[:, 0]
    omega, shapes = breathing_elements(p, answer[2], 240, 1)
    ring = shapes[:, 1] / shapes[-1, 1]
    assert ring[119] == pytest.approx(answer[18], rel=1e-4)  # half of the radius
    energy = 2 * numpy.pi * 0.5 * p["velocity"] ** 2 / shapes[-1, 1] ** 2
    assert energy == pytest.approx(answer[17], rel=1e-4)
    for t, row in zip((0.02, 0.11), (answer[21:24], answer[24:27])):
        assert p["velocity"] * numpy.sin(omega[1] * t) / omega[1] == pytest.approx(row[0], rel=1e-3)
        force = (p["line_mass"] * omega[1] ** 2 - answer[2]) * -row[0]
        assert force == pytest.approx(row[2], rel=1e-2)


@pytest.mark.parametrize("law", [0, 1])
@pytest.mark.parametrize("n", [1, 3, 8])
def test_bag_by_a_general_solver(law, n):
    """Free vertices anywhere in the plane, gas of given energy: all forces vanish (minpack); nothing assumes a circle."""
    p = dict(gas_energy=120.0, gas_area=0.5, gamma=1.6, length=1.7, youngs_modulus=900.0, poisson_ratio=-0.2, thickness=0.07,
             density=2.5, lost=11.0, law=law)
    modulus = p["youngs_modulus"] / (1 - p["poisson_ratio"] ** 2)

    def forces(free):
        """Unknowns: x of the vertex on the x axis, both of those between, y of the one on the y axis."""
        x = numpy.concatenate([free[:1], free[1:n], [0.0]])
        y = numpy.concatenate([[0.0], free[n : 2 * n - 1], free[-1:]])
        dx, dy = numpy.diff(x), numpy.diff(y)
        chord = numpy.hypot(dx, dy)
        rest = p["length"] / n
        strain = chord / rest - 1 if law == 0 else numpy.log(chord / rest)
        tension = modulus * p["thickness"] * strain * (1 if law == 0 else rest / chord)
        stored = 0.5 * modulus * p["thickness"] * rest * numpy.sum(strain**2)
        area = 0.5 * numpy.sum(x[:-1] * y[1:] - x[1:] * y[:-1])
        pressure = (p["gamma"] - 1) * (p["gas_energy"] - p["lost"] - stored) / area
        fx, fy = numpy.zeros(n + 1), numpy.zeros(n + 1)
        for k in range(n):
            fx[k] += tension[k] * dx[k] / chord[k] + 0.5 * pressure * dy[k]
            fy[k] += tension[k] * dy[k] / chord[k] - 0.5 * pressure * dx[k]
            fx[k + 1] += -tension[k] * dx[k] / chord[k] + 0.5 * pressure * dy[k]
            fy[k + 1] += -tension[k] * dy[k] / chord[k] - 0.5 * pressure * dx[k]
        return numpy.concatenate([fx[:n], fy[1:]]), (pressure, tension, strain, area)

    angles = numpy.linspace(0, numpy.pi / 2, n + 1)
    start = 1.5 * numpy.concatenate([numpy.cos(angles[:n]), numpy.sin(angles[1:])])
    start[:n] *= 1.1  # not a circle
    found, _, success, message = fsolve(lambda free: forces(free)[0], start, xtol=1e-13, full_output=True)
    assert success == 1, message
    pressure, tension, strain, area = forces(found)[1]
    row = numpy.array(evaluate([request("membrane-equilibrium", p, [n])])[0])[18:, 0]
    vertices = numpy.hypot(numpy.concatenate([found[:n], [0]]), numpy.concatenate([[0], found[n:]]))
    assert vertices == pytest.approx(row[0], rel=1e-9)
    assert (area, pressure) == pytest.approx((row[2], row[3]), rel=1e-9)
    assert tension == pytest.approx(row[4], rel=1e-9) and strain == pytest.approx(row[6], rel=1e-9)


def test_bag_comes_to_its_end_in_time():
    """York's membrane as a ring with a damper whose work heats the gas, integrated until it rests."""
    names = ("gas_energy", "gamma", "length", "youngs_modulus", "poisson_ratio", "thickness", "density")
    p = dict(zip(names, (118.6575, 1.4, 2.19919, 1e6, 0.3, 0.1, 0.5)))
    modulus, quarter = p["youngs_modulus"] / (1 - p["poisson_ratio"] ** 2), numpy.pi / 2
    mass = p["density"] * p["thickness"] * p["length"]

    def motion(_, y):
        r, v, gas = y
        pressure = (p["gamma"] - 1) * gas / (numpy.pi / 4 * r * r)
        tension = modulus * p["thickness"] * max(0.0, quarter * r / p["length"] - 1)
        damping = 60.0
        force = quarter * (pressure * r - tension) - damping * v
        return v, force / mass, -pressure * quarter * r * v + damping * v * v

    path = solve_ivp(motion, (0, 0.7), [0.9, 0.0, p["gas_energy"]], method="DOP853", rtol=1e-10, atol=1e-12, max_step=1e-3)
    assert path.success, path.message
    end = path.y[:, -1]
    answer = numpy.array(evaluate([request("membrane-equilibrium", p)])[0])[:, 0]
    assert abs(end[1]) <= 1e-6
    assert end[0] == pytest.approx(answer[0], rel=1e-8)
    assert (p["gamma"] - 1) * end[2] / (numpy.pi / 4 * end[0] ** 2) == pytest.approx(answer[3], rel=1e-7)
