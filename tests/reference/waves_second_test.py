"""Second, independent computations of waves and of sliding: integrals and roots by numpy and scipy on the laws themselves."""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.optimize import brentq
from second_values import agrees, is_near


@pytest.mark.parametrize("slope,friction,rise", [(0.6, 0.3, 0.0), (0.9, 0.2, 0.7), (0.3, 0.4, 0.5)])
def test_incline_by_integration(slope, friction, rise):
    """Block and disk by Newton's and Coulomb's laws, the disk's friction what keeps it rolling or the most that there is."""
    gravity, angle = 2.3, numpy.arctan(slope)
    times = [0.4, 1.1]
    answer = evaluate([request("incline", dict(slope=slope, friction=friction, gravity=gravity, rise=rise), times)])[0]

    def grown(t):
        s = min(1.0, t / rise) if rise else 1.0
        return s * s * (3 - 2 * s)

    def motion(t, y):
        pull, most = gravity * grown(t) * numpy.sin(angle), friction * gravity * grown(t) * numpy.cos(angle)
        drag, roll = min(pull, most), min(pull / 3, most)
        return [pull - drag, y[0], drag * y[0], pull - roll, y[3], 2 * roll]

    for k, time in enumerate(times):
        middle = min(rise, time)
        path = solve_ivp(motion, (0, middle), numpy.zeros(6), method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
        found = solve_ivp(motion, (middle, time), path, method="DOP853", rtol=1e-12, atol=1e-14).y[:, -1]
        assert all(is_near(got, own, 1e-10) for got, own in zip(answer[4 + 5 * k :], found[:5]))
    full = motion(max(times) + rise, numpy.zeros(6))
    for got, own in zip(answer, (full[0], full[3], full[5], gravity * numpy.cos(angle))):
        assert is_near(got, own, 1e-14 * gravity)


@pytest.mark.parametrize("amplitude,gamma", [(1e-3, 1.4), (-0.005, 5 / 3)])
def test_standing_wave_by_spectra(amplitude, gamma):
    """X'' = -(p0/rho0) d/da (dX/da)^-gamma of places a, Fourier's derivatives of 32 points, DOP853 at rtol 1e-12: exact to 1e-10
    of the velocity."""
    density, pressure, k, time = 1.7, 0.6, 3.1, 2.9
    count = 32
    places = 2 * numpy.pi / k * numpy.arange(count) / count
    waves = 1j * k * numpy.fft.fftfreq(count, 1 / count)
    waves[count // 2] = 0

    def slope(f):
        return numpy.fft.ifft(waves * numpy.fft.fft(f)).real

    def motion(_, y):
        moved, speed = numpy.split(y, 2)
        return numpy.concatenate([speed, -pressure / density * slope((1 + slope(moved)) ** -gamma)])

    start = numpy.concatenate([numpy.zeros(count), amplitude * numpy.sin(k * places)])
    moved, speed = numpy.split(solve_ivp(motion, (0, time), start, method="DOP853", rtol=1e-12, atol=1e-15).y[:, -1], 2)
    rho = density / (1 + slope(moved))
    p = pressure * (rho / density) ** gamma
    at = [1, 5, 12, 22]
    settings = dict(amplitude=amplitude, wavenumber=k, density=density, pressure=pressure, gamma=gamma, time=time)
    answer = evaluate([request("standing-wave", settings, (places + moved)[at])])[0]
    sound = numpy.sqrt(gamma * pressure / density)
    assert is_near(answer[0], sound, 1e-14 * sound) and is_near(answer[1], 2 * numpy.pi / (k * sound), 1e-13)
    own = 1e-10 * abs(amplitude) / sound
    for j, i in enumerate(at):
        row = answer[2 + 4 * j :]
        for got, one, scale in zip(row, (rho[i], speed[i], p[i], p[i] / ((gamma - 1) * rho[i])),
                                   (density, sound, pressure, pressure / density)):
            assert agrees(got, one, own * scale), (i, got)
            assert got.bound <= 0.01 * abs(amplitude) / sound * scale  # or the second order, some 6 %, would not be seen


def hardened(strain, modulus, shear, bulk, yield_stress, hardening):
    """Axial pressure, lateral pressure and plastic strain of small uniaxial compression, from the yield condition by a root."""
    def excess(plastic):  # half of it flows along each lateral direction
        return 2 * shear * (strain - 1.5 * plastic) - yield_stress - hardening * plastic
    plastic = brentq(excess, 0, strain, xtol=1e-18) if excess(0) > 0 else 0.0
    deviator = 2 * shear * (2 / 3 * strain - plastic)
    return bulk * strain + deviator, bulk * strain - deviator / 2, plastic


@pytest.mark.parametrize("rise", [0.0, 1e-3])
def test_elastic_plastic_impact_by_its_curve(rise):
    """Each strain runs at the speed of the slope of the stress there; the yield condition by a root, slopes by chords, which are
    exact for a curve of two straight pieces."""
    p = dict(youngs_modulus=2e5, poissons_ratio=0.3, density=1.3, yield_stress=1.7, hardening_modulus=4e4, velocity=0.02)
    E, nu = p["youngs_modulus"], p["poissons_ratio"]
    shear, bulk = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu))
    law = (E, shear, bulk, p["yield_stress"], p["hardening_modulus"])
    kink = p["yield_stress"] / (2 * shear)  # all of the elastic strain difference is along the axis
    elastic = hardened(kink / 2, *law)[0] / (kink / 2)
    chord = (hardened(3 * kink, *law)[0] - hardened(2 * kink, *law)[0]) / kink
    fast, slow = numpy.sqrt(elastic / p["density"]), numpy.sqrt(chord / p["density"])
    first = fast * kink
    strain = kink + (p["velocity"] - first) / slow
    axial, lateral, plastic = hardened(strain, *law)
    time, places = 2e-3, [0.1, 0.5, 0.78]
    answer = evaluate([request("elastic-plastic-impact", {**p, "rise_time": rise, "time": time}, places)])[0]
    heat = p["yield_stress"] * plastic * slow * (time - rise / 2 * (1 + first / p["velocity"]))
    own = (fast, slow, elastic * kink, first, strain, -axial, -lateral, plastic, heat)
    for got, one in zip(answer, own):
        assert is_near(got, one, 1e-10 * abs(one)), (got.name, one)

    def driven(t):
        return 0.0 if t <= 0 else p["velocity"] * (min(1, t / rise) if rise else 1)

    for j, x in enumerate(places):
        quick, late = min(first, driven(time - x / fast)), max(0.0, driven(time - x / slow) - first)
        state = hardened(quick / fast + late / slow, *law)
        for got, one, scale in zip(answer[9 + 4 * j :], (quick + late, -state[0], -state[1], state[2]),
                                   (p["velocity"], axial, axial, plastic)):
            assert is_near(got, one, 1e-9 * scale), (x, got.name, one)


@pytest.mark.parametrize("velocity", [227.0, 20.0])
def test_plate_impact_by_energy(velocity):
    """The law by differences of its energy, the flow by a root of the yield condition; then mass, momentum of each shock."""
    p = dict(youngs_modulus=117e9, poissons_ratio=0.35, density=8930.0, yield_stress=400e6, hardening_modulus=100e6)
    E, nu, rho = p["youngs_modulus"], p["poissons_ratio"], p["density"]
    shear, bulk, hardening = E / (2 * (1 + nu)), E / (3 * (1 - 2 * nu)), p["hardening_modulus"]

    def flow(e):
        def excess(plastic):
            return 2 * shear * (e - 1.5 * plastic) - p["yield_stress"] - hardening * plastic
        return brentq(excess, 0, e, xtol=1e-18) if excess(0) > 0 else 0.0

    def energy(axial, lateral, plastic):  # of an undeformed volume; compressions -ln of stretches
        elastic = numpy.array([axial - plastic, lateral + plastic / 2, lateral + plastic / 2])
        return bulk / 2 * elastic.sum() ** 2 + shear * ((elastic - elastic.mean()) ** 2).sum()

    def stresses(e):  # Cauchy's, of pressure
        plastic, d = flow(e), 1e-4
        axial = (energy(e + d, 0, plastic) - energy(e - d, 0, plastic)) / (2 * d)  # the energy is quadratic
        lateral = (energy(e, d, plastic) - energy(e, -d, plastic)) / (2 * d) / 2
        return axial * numpy.exp(e), lateral * numpy.exp(e), plastic

    kink = p["yield_stress"] / (2 * shear)

    def lost(e):
        if e <= kink:
            return numpy.sqrt(stresses(e)[0] * -numpy.expm1(-e) / rho)
        ahead, jump = stresses(kink)[0], numpy.exp(-kink) - numpy.exp(-e)
        return numpy.sqrt(ahead * -numpy.expm1(-kink) / rho) + numpy.sqrt((stresses(e)[0] - ahead) * jump / rho)

    e = brentq(lambda x: lost(x) - velocity, 1e-9, 0.5, xtol=1e-17)
    precursor = min(e, kink)
    speed = numpy.sqrt(stresses(precursor)[0] / (rho * -numpy.expm1(-precursor)))
    axial, lateral, plastic = stresses(e)
    answer = {got.name: got for got in evaluate([request("plate-impact", {**p, "velocity": velocity})])[0]}
    own = dict(elastic_speed=speed, precursor_stress=-stresses(precursor)[0], precursor_velocity=lost(precursor),
               plateau_stretch=numpy.exp(-e), plateau_stress=-axial, plateau_lateral_stress=-lateral,
               plateau_plastic_strain=plastic)
    if e > kink:
        own["plastic_speed"] = numpy.sqrt((axial - stresses(kink)[0]) / (rho * (numpy.exp(-kink) - numpy.exp(-e))))
    for name, one in own.items():
        assert is_near(answer[name], one, 1e-8 * abs(one)), (name, one, answer[name])
