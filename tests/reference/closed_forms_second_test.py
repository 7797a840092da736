"""What references give beside what other tests compare: totals, what is left after an impact, frequencies of the higher modes,
states behind fronts. In 30 digits, each by its own route: integrals by quadrature, roots of the equations themselves."""
import mpmath
import numpy
import pytest
from evaluator import evaluate, request
from second_values import agrees, is_near

R, mp = mpmath.mpf, mpmath.mp


@pytest.fixture(autouse=True)
def thirty_digits():
    with mp.workdps(30):
        yield


def answer(name, settings, at=()):
    return {got.name: got for got in evaluate([request(name, settings, at)])[0]}


def exact(settings):
    return {key: R(value) for key, value in settings.items()}


def all_agree(got, own):
    for name, one in own.items():
        assert agrees(got[name], one), (name, got[name], one)


@pytest.mark.parametrize("fixed", [0, 1])
def test_bar_of_two_states(fixed):
    p = dict(youngs_modulus=3e4, density=2.5, area=0.3, length=1.7, middle=0.6, time=1e-3)
    p |= {"left.velocity": 0.7, "left.stress": -40.0, "right.velocity": -0.4, "right.stress": 25.0, "left.fixed": fixed}
    q = exact(p)
    pieces = [(q["middle"], q["left.velocity"], q["left.stress"]),
              (q["length"] - q["middle"], q["right.velocity"], q["right.stress"])]
    energy = q["area"] * sum(long * (q["density"] * v**2 + s**2 / q["youngs_modulus"]) / 2 for long, v, s in pieces)
    momentum = q["area"] * q["density"] * sum(long * v for long, v, _ in pieces)
    all_agree(answer("bar-riemann", p), dict(energy=energy, momentum=momentum))


@pytest.mark.parametrize("share", [-0.5, 0.3, 0.8, 1.4, 1.9, 2.3])
def test_energies_of_bars_that_meet(share):
    """By the length that the waves from the contact have set under stress: it grows for L/c and shrinks for L/c."""
    p = dict(youngs_modulus=2e4, density=3.0, area=0.7, length=0.9, left=-0.2, gap=0.05, velocity_left=1.3, velocity_right=0.4)
    q = exact(p)
    c = mpmath.sqrt(q["youngs_modulus"] / q["density"])
    touch = q["gap"] / (q["velocity_left"] - q["velocity_right"])
    time = float(touch + (q["length"] / c * R(share) if share > 0 else touch * R(share)))
    since = R(time) - touch
    under = max(R(0), min(c * since, 2 * q["length"] - c * since))
    stress = q["density"] * c * (q["velocity_left"] - q["velocity_right"]) / 2
    strain = q["area"] * 2 * under * stress**2 / (2 * q["youngs_modulus"])
    mass = q["density"] * q["area"] * q["length"]
    total = mass * (q["velocity_left"] ** 2 + q["velocity_right"] ** 2) / 2
    all_agree(answer("bar-impact", p | dict(time=time)), dict(restitution=R(1), kinetic_energy=total - strain, strain_energy=strain))


@pytest.mark.parametrize("mode,nu,radius,velocity", [(1, 0.31, 0.8, 0.03), (3, -0.2, 1.7, -0.2)])
def test_motion_of_the_cylinder(mode, nu, radius, velocity):
    """The energy is that of the motion at the start; the frequency from Navier's equation with a surface free of traction."""
    p = dict(radius=radius, youngs_modulus=50.0, poisson=nu, density=2.3, velocity=velocity, mode=mode, time=0.4)
    q = exact(p)
    lam = q["youngs_modulus"] * q["poisson"] / ((1 + q["poisson"]) * (1 - 2 * q["poisson"]))
    mu = q["youngs_modulus"] / (2 * (1 + q["poisson"]))
    c = mpmath.sqrt((lam + 2 * mu) / q["density"])
    def traction(x):
        return (lam + 2 * mu) * mpmath.diff(lambda y: mpmath.besselj(1, y), x) + lam * mpmath.besselj(1, x) / x
    low = mpmath.besseljzero(1, mode - 1) if mode > 1 else R("0.001")
    x = mpmath.findroot(traction, (low, mpmath.besseljzero(0, mode)), solver="anderson")
    omega = x / q["radius"] * c
    share = mpmath.quad(lambda s: s * (mpmath.besselj(1, x * s) / mpmath.besselj(1, x)) ** 2, [0, 1])
    energy = mp.pi * q["density"] * q["velocity"] ** 2 * q["radius"] ** 2 * share
    all_agree(answer("cylinder-vibration", p), dict(wave_speed=c, omega=omega, period=2 * mp.pi / omega,
                                                    amplitude=abs(q["velocity"]) / omega, energy=energy))


def test_what_drums_are_made_of():
    p = dict(radius=0.7, tension=2.3, area_density=0.4)
    all_agree(answer("drum", p), exact({k: p[k] for k in ("tension", "area_density")}))


@pytest.mark.parametrize("law", [0, 1, 2])
def test_higher_modes_of_the_ring_on_gas(law):
    """Roots of the ring's equation of motion between zeros of J1."""
    p = dict(youngs_modulus=1700.0, poisson_ratio=0.2, thickness=0.07, radius=0.9, line_mass=0.06, pressure=11.0,
             gas_density=0.5, gamma=1.3, law=law)
    q = exact(p)
    stiff = q["youngs_modulus"] / (1 - q["poisson_ratio"] ** 2) * q["thickness"] / q["radius"] ** 2
    strain = q["pressure"] * q["radius"] / (stiff * q["radius"] ** 2)
    k = stiff * (1 - 2 * strain) if law == 1 else stiff
    c = mpmath.sqrt(q["gamma"] * q["pressure"] / q["gas_density"])
    def force(z):
        w = z * c / q["radius"]
        return q["line_mass"] * w**2 - k - q["gas_density"] * w * c * mpmath.besselj(0, z) / mpmath.besselj(1, z)
    got = answer("gas-ring", p)
    for n in (8, 9, 10):
        ends = [mpmath.besseljzero(1, m) for m in (n - 1, n)]
        z = mpmath.findroot(force, (ends[0] + R("1e-9"), ends[1] - R("1e-9")), solver="anderson", maxsteps=300)
        all_agree(got, {f"omega_{n}": z * c / q["radius"]})


@pytest.mark.parametrize("neo_hookean", [0, 1])
def test_higher_modes_of_the_sphere_on_gas(neo_hookean):
    """The sheet's stress by differences of its energy, roots between zeros of j1 by its closed form."""
    p = dict(youngs_modulus=1.7, poisson_ratio=0.5 if neo_hookean else 0.3, thickness=0.012, density=1.4, radius=0.8, stretch=1.25,
             neo_hookean=neo_hookean, gas_density=0.02, gamma=1.3)
    q = exact(p)
    E, nu = q["youngs_modulus"], q["poisson_ratio"]
    def energy(l):  # by volume at rest
        if neo_hookean:
            return E / 6 * (2 * l**2 + l**-4 - 3)
        return E / (1 - nu) * ((l**2 - 1) / 2) ** 2
    def pressure(l):  # p d(volume) = d(energy): 4 pi R0^2 t W' = p 4 pi R0^3 l^2
        return q["thickness"] * mpmath.diff(energy, l) / (q["radius"] * l**2)
    l, inside = q["stretch"], pressure(q["stretch"])
    mass = q["density"] * q["thickness"] / l**2
    k = mpmath.diff(pressure, l) / q["radius"]
    radius = l * q["radius"]
    c = mpmath.sqrt(q["gamma"] * inside / q["gas_density"])
    def j0(z):
        return mpmath.sin(z) / z
    def j1(z):
        return mpmath.sin(z) / z**2 - mpmath.cos(z) / z
    def force(z):
        w = z * c / radius
        return (mass * w**2 - k) * j1(z) - q["gas_density"] * w * c * j0(z)
    got = answer("gas-sphere", p)
    all_agree(got, dict(pressure=inside, sheet_stiffness=k, dry_omega=mpmath.sqrt(max(k, 0) / mass)))
    for n in (8, 9, 10):
        ends = [mpmath.findroot(lambda z: mpmath.sin(z) - z * mpmath.cos(z), (m * mp.pi, (m + R("0.5")) * mp.pi),
                                solver="anderson") for m in (n - 1, n)]
        z = mpmath.findroot(force, ends, solver="anderson", maxsteps=300)
        all_agree(got, {f"omega_{n}": z * c / radius})


@pytest.mark.parametrize("plane_strain", [0, 1])
def test_totals_of_the_disk_that_turns(plane_strain):
    """Lame's displacement of small strains, its energies by quadrature. Strains are 2e-5: their squares are below 1e-9; bounds of the
    reference also allow for what is not small."""
    p = dict(radius=0.7, youngs_modulus=9e3, poisson=0.27, density=1.9, angular_velocity=0.8, plane_strain=plane_strain)
    q = exact(p)
    E, nu, a = q["youngs_modulus"], q["poisson"], q["radius"]
    if plane_strain:
        E, nu = E / (1 - nu**2), nu / (1 - nu)
    load = q["density"] * q["angular_velocity"] ** 2
    def u(r):
        return load * (1 - nu) / (8 * E) * r * ((3 + nu) * a**2 - (1 + nu) * r**2)
    def stresses(r):
        e, f = mpmath.diff(u, r), u(r) / r
        return E / (1 - nu**2) * (e + nu * f), E / (1 - nu**2) * (f + nu * e)
    def stored(r):
        s, h = stresses(r)
        return mp.pi * r * (s**2 + h**2 - 2 * nu * s * h) / E
    spin = 2 * mp.pi * q["density"] * q["angular_velocity"] * mpmath.quad(lambda r: r**3 + 2 * r**2 * u(r), [0, a])
    got = answer("rotating-disk", p, [0.0, 0.4])
    centre = stresses(a * R("1e-9"))[0]
    own = dict(centre_stress=centre, angular_momentum=spin, kinetic_energy=spin * q["angular_velocity"] / 2,
               strain_energy=mpmath.quad(stored, [R(0) + R("1e-12"), a]), rim_displacement=u(a))
    for name, one in own.items():
        assert is_near(got[name], one, 1e-9 * abs(one)), (name, got[name], one)
    for k, r in ((0, a * R("1e-9")), (1, R(0.4))):
        one = sum(stresses(r)) * q["poisson"] * plane_strain
        assert is_near(got[f"axial_stress[{k}]"], one, 1e-9 * one), (k, got[f"axial_stress[{k}]"], one)


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_behind_the_front_of_an_explosion(dimension):
    """Scales of energy, density and time; jumps of a strong shock."""
    p = dict(dimension=dimension, gamma=1.3, density=1.7, energy=0.6, time=0.8)
    got, q = answer("sedov", p), exact(p)
    share = R(2) / (dimension + 2)
    radius = mpmath.exp(share * (mpmath.log(q["energy"] / (R(got["alpha"].value) * q["density"])) / 2 + mpmath.log(q["time"])))
    speed = share * radius / q["time"]
    velocity = 2 * speed / (q["gamma"] + 1)
    density = q["density"] * speed / (speed - velocity)
    own = dict(shock_radius=radius, shock_speed=speed, velocity_behind=velocity, density_behind=density,
               pressure_behind=q["density"] * speed * velocity)
    all_agree(got, own)


def test_heat_of_shear():
    """What the motion loses: its energy falls with twice the rate."""
    p = dict(amplitude=0.02, wavenumber=2.7, viscosity=0.013, density=1.3, pressure=0.9, gamma=1.35, time=1.9)
    q = exact(p)
    rate = q["viscosity"] / q["density"] * q["wavenumber"] ** 2
    heat = q["density"] * q["amplitude"] ** 2 / 4 * (1 - mpmath.exp(-2 * rate * q["time"]))
    all_agree(answer("shear-decay", p), dict(decay_rate=rate, heat=heat))


@pytest.mark.parametrize("dimension,rate", [(1, 0.6), (2, -0.4), (3, 0.3)])
def test_gas_that_is_squeezed_without_viscosity(dimension, rate):
    p = dict(dimension=dimension, rate=rate, density=1.7, pressure=0.6, gamma=1.3, time=0.9)
    q = exact(p)
    stretch = 1 - q["rate"] * q["time"]
    density = q["density"] / stretch**dimension
    energy = q["pressure"] * (density / q["density"]) ** q["gamma"] / ((q["gamma"] - 1) * density)
    all_agree(answer("uniform-compression", p), dict(stretch=stretch, isentropic_energy=energy))


def test_after_the_impact_of_bars():
    """Momentum and energy of both, from the restitution that other tests compare."""
    p = dict(width=0.9, height=1.3, youngs_modulus=3e4, poisson=0.25, density=2.5, speed=0.3, elements=32)
    got, q = answer("two-bar", p), exact(p)
    e, mass = R(got["restitution"].value), q["density"] * q["width"] * q["height"]
    hit = q["speed"] * (1 + e) / 2
    hitting = q["speed"] - hit
    lost = q["speed"] ** 2 - hit**2 - hitting**2  # of twice the kinetic energy of a mass
    own = dict(impulse=mass * hit, velocity_of_hit_bar=hit, velocity_of_hitting_bar=hitting,
               vibration_share=lost / (q["speed"] ** 2 / 2),
               wave_speed=mpmath.sqrt(q["youngs_modulus"] / (1 - q["poisson"] ** 2) / q["density"]))
    for name, one in own.items():
        assert is_near(got[name], one, 1e-12 * abs(one)), (name, got[name], one)


def test_orders_of_integrators():
    """Of the textbooks."""
    orders = dict(forward_euler=1, explicit_midpoint=2, symplectic_euler=1, leapfrog=2, ssp_rk3=3, rk4=4, newmark_trapezoid=2,
                  newmark_linear=2, generalized_alpha=2)
    all_agree(answer("oscillator-limits", dict(rho_b=0.6)), {name + "_order": order for name, order in orders.items()})


def test_constants_of_manufactured_solids():
    """Lame's constants by the bulk modulus, and the speed of waves in a thin bar."""
    for name in ("mms-bar", "mms-axis-aligned", "mms-ring", "mms-vortex"):
        p = dict(youngs_modulus=700.0, density=1.3) | ({} if name == "mms-ring" else dict(poisson=0.28))
        q = exact(p)
        nu = q.get("poisson", R(0))
        bulk, shear = q["youngs_modulus"] / (3 * (1 - 2 * nu)), q["youngs_modulus"] / (2 * (1 + nu))
        all_agree(answer(name, p), {"lambda": bulk - 2 * shear / 3, "mu": shear,
                                   "wave_speed": mpmath.sqrt(q["youngs_modulus"] / q["density"])})


@pytest.mark.parametrize("dimension", [1, 2, 3])
def test_no_shear_along_the_axes(dimension):
    got = answer("mms-axis-aligned", dict(dimension=dimension, time=0.003), [0.3])
    for kind in ("deformation", "stress"):
        for one in ("xy", "xz", "yx", "yz", "zx", "zy"):
            if f"{kind}_{one}[0]" in got:
                assert is_near(got[f"{kind}_{one}[0]"], 0.0, 0), (kind, one)


def test_first_and_last_of_the_gas_that_expands():
    p = dict(radius=0.3, time=0.004)
    q = exact(p)
    sound = mpmath.sqrt(R("1.4") * 100)
    all_agree(answer("gas-expansion", p), dict(head=q["radius"] - sound * q["time"], front=q["radius"] + 5 * sound * q["time"]))


@pytest.mark.parametrize("place", [0.01, 0.043, 0.07])
def test_gas_and_shocks_of_the_plate(place):
    """States at places: those of the plateau, of the precursor, and of the plate that nothing has reached."""
    p = dict(velocity=180.0, time=1.2e-5)
    got = answer("plate-impact", p, [place])
    behind = got["plastic_speed"].value * p["time"] > place
    ahead = got["elastic_speed"].value * p["time"] < place
    assert (behind, ahead) == {0.01: (True, False), 0.043: (True, False), 0.07: (False, True)}[place]
    rows = {"velocity[0]": p["velocity"], "stress[0]": got["plateau_stress"].value,
            "lateral_stress[0]": got["plateau_lateral_stress"].value, "plastic_strain[0]": got["plateau_plastic_strain"].value}
    for name, one in rows.items():
        assert is_near(got[name], 0.0 if ahead else one, 1e-12 * abs(one)), (name, got[name], one)
