"""The lumped airbag a second time, without elliptic integrals: the meridian's differential equations integrated along
the skin and shot at the probe, the motion by scipy's integrator, and the largest volume by search among polygons.
"""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.interpolate import BarycentricInterpolator
from scipy.optimize import fsolve, minimize

YORK = dict(mass=6.03, probe_radius=0.1, speed=3.9, meridian=0.71689571, height=0.0, gamma=1.4, pressure=105325.0,
            ambient_pressure=101325.0)
LARGE = {**YORK, "mass": 8.05, "probe_radius": 0.25, "speed": 4.7}
IMPACTS = {"200": YORK, "200 as York": {**YORK, "pressure": 4000.0, "ambient_pressure": 0.0}, "500": LARGE,
           "pressed before": {**YORK, "height": 0.3}}
VALUES = ("max_displacement", "time_of_max", "contact_duration", "rebound_speed", "peak_force", "peak_pressure",
          "least_volume", "start_height", "start_volume", "free_height", "free_radius", "displacement_limit")
ROW = ("displacement", "velocity", "force", "pressure", "volume", "plate_radius", "equator")


def answer_of(p, times=()):
    answer = evaluate([request("airbag", p, times)])[0]
    values = dict(zip(VALUES, (value for value, _ in answer)))
    rows = [dict(zip(ROW, (v for v, _ in answer[len(VALUES) + 7 * i:]))) for i in range(len(times))]
    return values, rows


def meridian(p, b, tension):
    """r, z, angle, volume along the free skin; tension: meridional tension times radius over pressure difference."""
    end = p["meridian"] - b - min(b, p["probe_radius"])
    def along(_, y):
        r, _, angle, _ = y
        sine = numpy.sin(angle)
        return [numpy.cos(angle), sine, r / tension, numpy.pi * r * r * sine]
    return solve_ivp(along, (0, end), [b, 0, 0, 0], method="DOP853", rtol=1e-12, atol=1e-14, dense_output=True)


def shape(p, gap, guess):
    """b, tension, path and the push on the probe over the pressure difference."""
    def missed(unknown):
        b, tension = unknown * guess
        r, z = meridian(p, b, tension).y[:2, -1]
        return [(r - min(b, p["probe_radius"])) / p["meridian"], (z - gap) / p["meridian"]]
    b, tension = fsolve(missed, [1.0, 1.0], xtol=1e-13) * guess
    path = meridian(p, b, tension)
    r, z, angle, volume = path.y[:, -1]
    assert abs(z - gap) <= 1e-9 * p["meridian"]
    face = min(b, p["probe_radius"])
    push = numpy.pi * face**2 - 2 * numpy.pi * tension * numpy.sin(angle)  # gas on the face, skin on its edge
    return b, tension, path, push


@pytest.mark.parametrize("name", IMPACTS)
def test_shapes_and_motion(name):
    p = IMPACTS[name]
    values, _ = answer_of(p)
    far, duration = values["max_displacement"], values["contact_duration"]
    times = [share * duration for share in (0.05, 0.2, 0.31, 0.45, 0.6, 0.9)]
    _, rows = answer_of(p, times)
    # shapes from shallow to deep, each from the one before; smooth in the root of how far they are pressed
    free = values["free_height"]
    ends = numpy.sqrt([free - values["start_height"] + 1e-6 * free, free - values["start_height"] + 1.02 * far])
    middle, half = 0.5 * (ends[0] + ends[1]), 0.5 * (ends[1] - ends[0])
    nodes = middle + half * numpy.cos(numpy.pi * (numpy.arange(40) + 0.5) / 40)
    guess = numpy.array([0.01 * free, 0.5 * values["free_radius"] ** 2])
    guess[0] = 0.8 * nodes[-1] * numpy.sqrt(free)
    pushes, volumes = [], []
    for node in nodes[::-1]:
        b, tension, path, push = shape(p, free - node**2, guess)
        guess = numpy.array([b, tension])
        pushes.append(push)
        volumes.append(path.y[3, -1])
        assert push == pytest.approx(numpy.pi * b * b, rel=1e-7, abs=1e-9)  # as much as on the plate
    volume_at = BarycentricInterpolator(nodes[::-1], volumes)
    push_at = BarycentricInterpolator(nodes[::-1], pushes)
    start = values["start_volume"]
    def force(x):
        node = numpy.sqrt(max(free - values["start_height"] + x, 0.0))
        pressure = p["pressure"] * (start / volume_at(node)) ** p["gamma"]
        return (pressure - p["ambient_pressure"]) * push_at(node) if x > 0 else 0.0
    def turning(_, y):
        return y[1]
    turning.direction = -1
    path = solve_ivp(lambda _, y: [y[1], -force(y[0]) / p["mass"]], (0, duration), [0, p["speed"]], method="DOP853",
                     rtol=1e-10, atol=1e-12, events=turning, dense_output=True)
    # where the bag reaches the edge of the probe the force has a kink: the interpolation is good to 1e-5 there
    assert path.t_events[0][0] == pytest.approx(values["time_of_max"], rel=2e-5)
    assert path.y_events[0][0][0] == pytest.approx(far, rel=2e-5)
    assert path.y[1, -1] == pytest.approx(-values["rebound_speed"], rel=1e-4)
    for t, row in zip(times, rows):
        x, v = path.sol(t)
        assert row["displacement"] == pytest.approx(x, abs=2e-5 * far)
        assert row["velocity"] == pytest.approx(v, abs=1e-4 * p["speed"])
        assert row["force"] == pytest.approx(force(x), abs=2e-4 * values["peak_force"])


@pytest.mark.parametrize("probe_radius,share", [(0.1, 0.25), (0.1, 0.6), (0.25, 0.4)])
def test_no_polygon_holds_more(probe_radius, share):
    """Chords of equal length from plate to edge, or to the face, that may lie down on the plate: a polygon of that
    meridian is one of the shapes, so its volume stays below the largest and comes within the cut of its corners, 1/n^2.
    """
    p = {**YORK, "probe_radius": probe_radius}
    values, rows = answer_of(p, [share * 0.0386])
    row = rows[0]
    gap, face, n = values["start_height"] - row["displacement"], min(probe_radius, row["plate_radius"]), 48
    chord = (p["meridian"] - face) / n
    def corners(angle):
        return (numpy.concatenate([[0], chord * numpy.cumsum(numpy.cos(angle))]),
                numpy.concatenate([[0], chord * numpy.cumsum(numpy.sin(angle))]))
    def volume(angle):
        r, z = corners(angle)
        return numpy.pi / 3 * ((r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2) * numpy.diff(z)).sum()
    def slope(angle):
        r, z = corners(angle)
        up, square = numpy.diff(z), r[1:] ** 2 + r[1:] * r[:-1] + r[:-1] ** 2
        by_r = (2 * r[1:] + r[:-1]) * up
        by_r[:-1] += (2 * r[1:-1] + r[2:]) * up[1:]
        later = numpy.cumsum(by_r[::-1])[::-1]
        return numpy.pi / 3 * chord * (-numpy.sin(angle) * later + numpy.cos(angle) * square)
    first = numpy.linspace(0, numpy.pi, n)
    ends = {"type": "eq", "fun": lambda a: [corners(a)[0][-1] - face, corners(a)[1][-1] - gap]}
    floor = {"type": "ineq", "fun": lambda a: corners(a)[1][1:-1]}
    best = minimize(lambda a: -1e3 * volume(a), first, jac=lambda a: -1e3 * slope(a), method="SLSQP",
                    constraints=[ends, floor], options=dict(maxiter=400, ftol=1e-10))
    missed = numpy.abs(ends["fun"](best.x)).max()
    assert missed <= 1e-7
    held = volume(best.x)
    assert held <= row["volume"] * (1 + 1e-5)
    assert held >= row["volume"] * (1 - 3 / n**2)
