"""Second, independent computations of the exact gas flows: scipy and numpy on the differential equations themselves."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve
from second_values import agrees, is_near


def rows_of(answer, values, width=4):
    return numpy.array([[value for value, _ in answer[i : i + width]] for i in range(values, len(answer), width)])


@pytest.mark.parametrize("piston,rho,p,gamma", [(1, 1, 1, 1.4), (0.2, 3, 0.7, 5 / 3), (9, 0.4, 2, 1.1)])
def test_piston_shock_by_the_jump_conditions(piston, rho, p, gamma):
    """Mass, momentum and energy solved together for U, rho2, p2. fsolve stops at 1.5e-8 squared by its last step."""
    def jumps(unknown):
        speed, density, pressure = unknown
        energy = pressure / ((gamma - 1) * density) - p / ((gamma - 1) * rho)
        return (rho * speed - density * (speed - piston), pressure - p - rho * speed * piston,
                energy - (p + pressure) / 2 * (1 / rho - 1 / density))
    start = piston + numpy.sqrt(gamma * p / rho)
    found = fsolve(jumps, (start, rho * 1.5, p + rho * start * piston), xtol=1e-13)
    answer = evaluate([request("piston-shock", dict(piston_velocity=piston, density=rho, pressure=p, gamma=gamma))])[0]
    assert [value for value, _ in answer[:3]] == pytest.approx(found, rel=1e-9)


@pytest.mark.parametrize("dimension,gamma", [(1, 1.4), (2, 5 / 3), (3, 1.2), (3, 5 / 3)])
def test_noh_by_the_similarity_equations(dimension, gamma):
    """Cold gas ahead by rho' = -(d - 1) rho/((x + 1) x) over x = r/t from far away (rtol 1e-12), then the jumps."""
    speed = (gamma - 1) / 2
    def thinning(x, y):
        return [-(dimension - 1) * y[0] / (x * (x + 1))]
    far = 1e7  # the density there is 1 + (d - 1)/x, then order 1e-14
    ahead = solve_ivp(thinning, (far, speed), [1 + (dimension - 1) / far], method="DOP853", rtol=1e-12, atol=0).y[0, -1]
    density = ahead * (speed + 1) / speed
    pressure = ahead * (speed + 1)
    answer = evaluate([request("noh", dict(dimension=dimension, gamma=gamma, time=1), [1.0001 * speed])])[0]
    assert [answer[i][0] for i in (0, 2, 3)] == pytest.approx([speed, density, pressure], rel=1e-8)
    assert pressure / ((gamma - 1) * density) == pytest.approx(answer[4][0], rel=1e-8)  # all kinetic energy is heat


@pytest.mark.parametrize("dimension,edge,rho,p,gamma", [(2, 0.38, 1, 100, 1.4), (1, 2, 0.3, 5, 1.4),
                                                        (3, 0.7, 1, 1, 1.1), (3, 1, 2, 3, 5 / 3), (2, 1, 1, 1, 2.7)])
def test_affine_expansion_by_the_motion_of_the_edge(dimension, edge, rho, p, gamma):
    """R'' integrated in time, rtol 1e-12; 1e-9 leaves three decades for the steps taken."""
    force = 2 * gamma / (gamma - 1) * p / rho
    def motion(_, y):
        return y[1], force * (edge / y[0]) ** (dimension * (gamma - 1)) / y[0]
    unit = edge / numpy.sqrt(p / rho)
    times = [0.01 * unit, 0.3 * unit, unit, 20 * unit]
    path = solve_ivp(motion, (0, times[-1]), (edge, 0), method="DOP853", rtol=1e-12, atol=1e-14 * edge, t_eval=times)
    settings = dict(dimension=dimension, edge=edge, density=rho, pressure=p, gamma=gamma)
    answers = evaluate([request("affine-expansion", {**settings, "time": t}) for t in times])
    assert [a[0][0] for a in answers] == pytest.approx(path.y[0], rel=1e-9)
    assert [a[1][0] for a in answers] == pytest.approx(path.y[1], rel=1e-9)


@pytest.mark.parametrize("dimension,gamma", [(1, 1.4), (2, 1.4), (3, 1.4), (1, 1.2), (2, 5 / 3), (3, 5 / 3), (3, 2),
                                             (2, 2), (3, 3)])
def test_sedov_by_the_similarity_equations(dimension, gamma):
    """The Euler equations for rho G(x), R' U(x), rho R'^2 P(x), x = r/R, R ~ t^(2/(d + 2)), integrated inwards from
    the shock, rtol 1e-12; the energy by quadrature of that solution."""
    d, g = dimension, gamma
    def euler(x, y):
        density, u, p = y[:3]
        # unknown slopes (G', U', P') of mass, momentum, entropy; R R''/R'^2 = -d/2
        matrix = [[u - x, density, 0], [0, u - x, 1 / density], [-g * p / density * (u - x), 0, u - x]]
        right = [-(d - 1) * density * u / x, d / 2 * u, d * p]
        shell = x ** (d - 1) * (density * u * u / 2 + p / (g - 1))
        return [*numpy.linalg.solve(matrix, right), -shell]
    behind = [(g + 1) / (g - 1), 2 / (g + 1), 2 / (g + 1), 0]
    inner = 0.05
    path = solve_ivp(euler, (1, inner), behind, method="DOP853", rtol=1e-12, atol=1e-16, dense_output=True)
    core = path.y[2, -1] / (g - 1) * inner**d / d  # at rest with even pressure near the centre, to order of its density
    measure = {1: 2, 2: 2 * numpy.pi, 3: 4 * numpy.pi}[d]
    alpha = measure * (2 / (d + 2)) ** 2 * (path.y[3, -1] + core)
    at = [0.1, 0.3, 0.6, 0.9, 0.999]
    answer = evaluate([request("sedov", dict(dimension=d, gamma=g, energy=alpha))])[0]
    # the core: kinetic energy and unevenness of pressure, of the order of x^2 and of the density there
    assert answer[1][0] == pytest.approx(1, abs=2e-5 if d == 1 else 1e-6)
    speed = 2 / (d + 2)
    rows = rows_of(evaluate([request("sedov", dict(dimension=d, gamma=g, energy=answer[0][0]), at)])[0], 6)
    for x, (density, velocity, pressure, _) in zip(at, rows):
        expected = path.sol(x)[:3] * (1, speed, speed**2)
        assert (density, velocity, pressure) == pytest.approx(expected, rel=1e-7)


def spectral(values, length):
    """Derivative of a periodic function sampled evenly along the last axis."""
    n = values.shape[-1]
    wave = 2j * numpy.pi * numpy.fft.rfftfreq(n, length / n)
    wave[-1] = 0
    return numpy.fft.irfft(wave * numpy.fft.rfft(values), n)


def runge_kutta(rate, state, time, steps):
    h = time / steps
    for _ in range(steps):
        a = rate(state)
        b = rate(state + h / 2 * a)
        c = rate(state + h / 2 * b)
        state = state + h / 6 * (a + 2 * b + 2 * c + rate(state + h * c))
    return state


@pytest.mark.parametrize("amplitude,rho,p,gamma", [(0.3, 1, 1, 1.4), (-0.25, 0.5, 2, 5 / 3), (0.02, 2, 1, 1.1)])
def test_simple_wave_by_the_euler_equations(amplitude, rho, p, gamma):
    """Euler equations for rho, u, p on a periodic line, 1024 Fourier modes and RK4, to half the breaking time or one
    width of the pulse. The pulse has five derivatives: coefficients fall as n^-7, steepened, to below 1e-7."""
    length, n = 4.0, 1024
    pulse = dict(amplitude=amplitude, centre=1.2, half_width=0.8, density=rho, pressure=p, gamma=gamma)
    x = numpy.arange(n) * length / n
    breaking = evaluate([request("simple-wave", {**pulse, "time": 0})])[0][1][0]
    time = min(0.5 * breaking, 1.0 / numpy.sqrt(gamma * p / rho))
    start, end = (rows_of(a, 2) for a in evaluate([request("simple-wave", {**pulse, "time": t}, x) for t in (0, time)]))

    def rate(state):
        density, u, pressure = state
        d_density, d_u, d_pressure = spectral(state, length)
        return -numpy.array([u * d_density + density * d_u, u * d_u + d_pressure / density,
                             u * d_pressure + gamma * pressure * d_u])
    found = runge_kutta(rate, start.T[:3], time, 3000)
    scale = numpy.abs(end[:, :3] - (rho, 0, p)).max(axis=0)
    assert numpy.abs(found.T - end[:, :3]).max(axis=0) / scale == pytest.approx(0, abs=1e-6)
    initial = amplitude * numpy.clip(1 - ((x - 1.2) / 0.8) ** 2, 0, None) ** 6
    assert start[:, 1] == pytest.approx(initial, abs=1e-13)


def navier_stokes(p, time, n=48):
    """The gas between walls with all nonlinear terms: rho, u_x, u_y, p over one wave of cos(k x)."""
    length, mu, g = 2 * numpy.pi / p["wavenumber"], p["viscosity"], p["gamma"]
    x = numpy.arange(n) * length / n

    def rate(state):
        density, u, v, pressure = state
        d_density, d_u, d_v, d_pressure = spectral(state, length)
        along, across = spectral(4 / 3 * mu * d_u, length), spectral(mu * d_v, length)
        heat = mu * (4 / 3 * d_u**2 + d_v**2)
        return -numpy.array([u * d_density + density * d_u, u * d_u + (d_pressure - along) / density,
                             u * d_v - across / density, u * d_pressure + g * pressure * d_u - (g - 1) * heat])
    ones = numpy.ones(n)
    start = numpy.array([p["density"] * ones, 0 * ones, p["amplitude"] * numpy.cos(p["wavenumber"] * x),
                         p["pressure"] * ones])
    sound = numpy.sqrt(g * p["pressure"] / p["density"])
    step = 0.25 / (sound * p["wavenumber"] * n / 2 + 4 * mu / p["density"] * (p["wavenumber"] * n / 2) ** 2)
    return x, runge_kutta(rate, start, time, max(50, int(numpy.ceil(time / step))))


def random_shears(count):
    random = numpy.random.default_rng(1822)
    for _ in range(count):
        rho, pressure, gamma, k = *(10 ** random.uniform(-1, 1, 2)), random.uniform(1.1, 3), 10 ** random.uniform(-1, 1)
        sound = numpy.sqrt(gamma * pressure / rho)
        amplitude, thickness = sound * 10 ** random.uniform(-2, -0.302), 10 ** random.uniform(-3, -0.35)
        p = dict(amplitude=amplitude, wavenumber=k, density=rho, pressure=pressure, gamma=gamma,
                 viscosity=rho * sound / k * thickness)
        yield {key: float(value) for key, value in p.items()}, float(10 ** random.uniform(-1, 1.3) / (sound * k))


def test_shear_decay_bounds_hold_for_the_nonlinear_gas():
    """Every field of 30 random gases stays within its bound, which is a bound for what the second order leaves out; the
    numerical solution itself is exact to 1e-9 of each scale (RK4 at a quarter of its limit, 48 modes of a cosine)."""
    used = []
    for p, time in random_shears(30):
        x, (density, u, v, pressure) = navier_stokes(p, time)
        answer = evaluate([request("shear-decay", {**p, "time": time}, x)])[0][2:]
        energy = pressure / ((p["gamma"] - 1) * density)
        sound = numpy.sqrt(p["gamma"] * p["pressure"] / p["density"])
        fields = (density, v, pressure, energy, u)
        scales = (p["density"], abs(p["amplitude"]), p["pressure"], energy[0], sound)
        for field, (found, scale) in enumerate(zip(fields, scales)):
            value, bound = numpy.array(answer[field::5]).T
            assert all(agrees(got, one, 1e-9 * scale) for got, one in zip(answer[field::5], found)), (p, time, field)
            used.append(numpy.max(numpy.abs(found - value)) / numpy.max(bound + 1e-9 * scale))
    assert max(used) > 0.02  # the bounds are not a matter of course


def test_shear_decay_is_second_order_accurate_in_the_amplitude():
    """Halving the amplitude divides what the pressure and the density leave out by about 2^4, the velocity by 2^3."""
    errors = []
    for amplitude in (0.2, 0.1):
        p = dict(amplitude=amplitude, wavenumber=2.0, viscosity=0.02, density=1.0, pressure=1.0, gamma=1.4)
        x, (density, _, v, pressure) = navier_stokes(p, 1.5)
        rows = rows_of(evaluate([request("shear-decay", {**p, "time": 1.5}, x)])[0], 2, 5)
        errors.append([numpy.abs(a - b).max() for a, b in zip((density, v, pressure), rows.T)])
    orders = numpy.log2(numpy.divide(*errors))
    assert orders == pytest.approx((4, 3, 4), abs=0.2)  # the next order is (U/c)^2 = 3 % at 0.2


def random_compressions(count):
    random = numpy.random.default_rng(1899)
    for number in range(count):
        p = dict(dimension=int(random.integers(1, 4)), rate=random.uniform(-0.9, 0.9), density=10 ** random.uniform(-1, 1),
                 pressure=10 ** random.uniform(-1, 1), gamma=random.uniform(1.1, 3))
        kinds = ({"linear": 1}, {"viscosity": 1, "quadratic": 1})[number % 2]
        yield {**p, **{kind: 10 ** random.uniform(-3, 0) for kind in kinds}}, random.uniform(0.1, 1)


def test_uniform_compression_by_the_energy_equation():
    """e' = sigma : grad v/rho of a gas that contracts uniformly, 30 random ones, by DOP853 at rtol 1e-12."""
    for p, time in random_compressions(30):
        d, g = p["dimension"], p["gamma"]
        gradient = -p["rate"] * numpy.eye(3) * (numpy.arange(3) < d)[:, None]

        def heating(t, e):
            now = gradient / (1 - p["rate"] * t)
            rho = p["density"] * (1 - p["rate"] * t) ** -d
            closing, sound = max(0, -numpy.trace(now)), numpy.sqrt(g * (g - 1) * e[0])
            q = rho * (p.get("linear", 0) * sound * closing + p.get("quadratic", 0) * closing**2)
            stress = 2 * p.get("viscosity", 0) * (now - numpy.trace(now) * numpy.eye(3) / 3)
            stress -= ((g - 1) * rho * e[0] + q) * numpy.eye(3)
            return [numpy.sum(stress * now) / rho]

        start = p["pressure"] / ((g - 1) * p["density"])
        found = solve_ivp(heating, (0, time), [start], method="DOP853", rtol=1e-12, atol=0).y[0, -1]
        _, (rest, _), heat = evaluate([request("uniform-compression", {**p, "time": time})])[0]
        assert is_near(heat, found - rest, 1e-10 * found), p
        assert 0 <= heat.bound <= 1e-11 * max(heat.value, 1e-3 * rest)
