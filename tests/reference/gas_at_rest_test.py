"""A gas at rest in the plane by a von Neumann analysis of its own, beside what the laboratory finds of the kernel's step.

Cubic B-splines, APIC with a filter at a rate, leapfrog, sharpened forces, strains and motion, as by default; lengths in cells, speeds
in c, the gas at rest on a lattice of n x n points a cell. Unknowns of a point: displacement u, velocity v, its gradient C, energy e.
The equations are those of reports/docs/theory/step.md and gases.md, linear about the state at rest:

    f_i = (gamma - 1) sum_p m (e_p grad N_ip + e (u_p . grad) grad N_ip)          pressures at the points, as the kernel has them
    f_i = (gamma - 1) sum_p m e'_p grad N_ip + int p grad N_i, e' = e less its mean at the nodes    sums that are corrected
    f_i = -h^2 grad_h p_i,  p_i = (gamma - 1) sum_p m (e_p N_ip + e u_p . grad N_ip)/h^2     pressures at the nodes

with p of all points, sharpened [Quadrature 1-4], and grad_h the difference of nodes through faces [Pressure 2-4]. The work of the last on a
wave whose grad_h . v vanishes is none.
"""

import itertools
import json
import os
import subprocess

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.optimize import minimize_scalar

gamma = 1.4
energy = 1 / (gamma * (gamma - 1))  # c = 1
inertia = 1 / 3  # of the cubic spline
blur = 1 / 6  # theta of [Sharpening 1]
filter_sound = 2.0  # k_f of [Filter 1]
second = 1.0  # s_2 of [Sharpening 1]; in a gas at rest nothing expands, and all of it is kept [Limiter 2]
U, V, C, E = slice(0, 2), slice(2, 4), slice(4, 8), 8
unknowns = 9


def spline(x):
    """The cubic B-spline with its first two derivatives."""
    a, sign = np.abs(x), np.sign(x)
    inner, middle = a < 1, a < 2
    value = np.where(inner, 2 / 3 - a**2 + a**3 / 2, np.where(middle, (2 - a) ** 3 / 6, 0))
    slope = sign * np.where(inner, -2 * a + 1.5 * a**2, np.where(middle, -((2 - a) ** 2) / 2, 0))
    bend = np.where(inner, -2 + 3 * a, np.where(middle, 2 - a, 0))
    return value, slope, bend


def apart(along, nodes):
    """From the nodes of an axis to the points of a cell along it: a row for each point."""
    return ((np.arange(along) + 0.5) / along)[:, None] - nodes


def symbols(along, theta):
    """Of each point of a cell, sums over the nodes that it reaches: N, N (x_i - x), grad N, grad grad N, each with exp(i theta i)."""
    nodes = np.arange(-1, 3)
    x = apart(along, nodes)
    value, slope, bend = spline(x)
    (a, of_a, da, dda), (b, of_b, db, ddb) = (
        [np.sum(part * np.exp(1j * t * nodes), axis=1) for part in (value, -value * x, slope, bend)] for t in theta
    )
    return [
        (a[k] * b[m], np.array([of_a[k] * b[m], a[k] * of_b[m]]), np.array([da[k] * b[m], a[k] * db[m]]),
         np.array([[dda[k] * b[m], da[k] * db[m]], [da[k] * db[m], a[k] * ddb[m]]]))
        for k, m in itertools.product(range(along), repeat=2)
    ]  # fmt: skip


def wide_spline(u):
    """The quartic B-spline: its slope is the difference of two cubic ones."""
    z = np.abs(u)
    middle = (55 + 20 * z - 120 * z**2 + 80 * z**3 - 16 * z**4) / 96
    return np.where(
        z < 0.5, 115 / 192 - 5 / 8 * z**2 + z**4 / 4, np.where(z < 1.5, middle, np.where(z < 2.5, (5 - 2 * z) ** 4 / 384, 0))
    )


def flows(along, theta):
    """Of each point of a cell and each axis, the sum over the faces across it: splines with exp(i theta face)."""
    nodes, faces = np.arange(-1, 3), np.arange(-2.5, 4)
    across = [np.sum(wide_spline(apart(along, faces)) * np.exp(1j * t * faces), axis=1) for t in theta]
    beside = [np.sum(spline(apart(along, nodes))[0] * np.exp(1j * t * nodes), axis=1) for t in theta]
    return [
        np.array([across[0][k] * beside[1][m], beside[0][k] * across[1][m]])
        for k, m in itertools.product(range(along), repeat=2)
    ]


def integrals(theta):
    """int N div v by nodal velocities, of a wave along each axis: splines of degree seven are the overlaps of two cubic ones."""
    both = BSpline.basis_element(np.arange(9) - 4.0)
    steps = np.arange(-3, 4)
    even = np.array([np.sum(both(steps) * np.exp(1j * t * steps)) for t in theta])
    slope = np.array([-np.sum(both.derivative()(steps) * np.exp(1j * t * steps)) for t in theta])
    return slope * even[::-1]


def step_matrix(theta, dt, along=2, at_nodes=False, corrected=False, sharpened=True):
    """What one step makes of all unknowns of a cell, in a wave of the wave number theta."""
    points = symbols(along, theta)
    count, mass = len(points), 1 / along**2
    identity = np.eye(count * unknowns, dtype=complex)

    def own(state, p, part):
        return state[p * unknowns : (p + 1) * unknowns][part]

    theta = np.asarray(theta)
    one_axis = blur * (2 - 2 * np.cos(theta))  # B_d
    sharpening = 1 + sharpened * np.sum(one_axis + second * one_axis**2)
    to_faces = sum(b * np.cos((k + 0.5) * theta) for k, b in enumerate((37, -8, 1))) / 30  # of sixth order
    difference = 2j * np.sin(theta / 2) * to_faces
    integral = integrals(theta)
    read_off = (1 + np.sum(one_axis)) ** 2  # [Read-off 1], where no limit acts
    flow = flows(along, theta) if at_nodes else None

    def mapped(state):
        """The nodal velocity: sum_p m N (v + C (x_i - x_p)), of mass 1."""
        total = 0
        for p, (n, arm, _, _) in enumerate(points):
            gradient = own(state, p, C).reshape(2, 2, -1)
            total = total + mass * (np.conj(n) * own(state, p, V) + np.einsum("abk,b->ak", gradient, np.conj(arm)))
        return total

    def corrected_force(state):
        """Displacements count in the mapped densities alone: of even pressures their share in the sums is gone."""
        density = sum(mass * np.conj(slope) @ own(state, p, U) for p, (_, _, slope, _) in enumerate(points)) * read_off
        mean = sum(mass * np.conj(n) * own(state, p, E) for p, (n, _, _, _) in enumerate(points))
        total = -np.outer(integral, energy * density + mean)
        for p, (n, _, slope, _) in enumerate(points):
            total = total + mass * np.outer(np.conj(slope), own(state, p, E) - n * mean)
        return (gamma - 1) * total

    def force(state):
        if corrected:
            return corrected_force(state)
        total, pressure = 0, 0
        for p, (n, _, slope, bend) in enumerate(points):
            e, u = own(state, p, E), own(state, p, U)
            total = total + np.outer(np.conj(slope), e) + energy * np.conj(bend) @ u
            pressure = pressure + np.conj(n) * e + energy * np.conj(slope) @ u
        return (gamma - 1) * mass * (-np.outer(difference, pressure) if at_nodes else total)

    def strained(state, velocity, dt, with_correction):
        """The energies after dt of what the nodal velocity, sharpened, compresses."""
        changed = state.copy()
        mean = sum(mass * np.conj(n) * (slope @ velocity) for n, _, slope, _ in points)
        for p, (n, _, slope, _) in enumerate(points):
            divergence = n * (difference @ velocity) if at_nodes else slope @ velocity
            if with_correction:
                divergence = divergence + n * (integral @ velocity - mean)
            changed[p * unknowns + E] -= dt * (gamma - 1) * energy * sharpening * divergence
        return changed

    state = identity.copy()

    def drift(dt):
        for p in range(count):
            own(state, p, U)[:] += dt * own(state, p, V)

    drift(dt / 2)
    start = mapped(state)
    end = start + dt * sharpening * force(strained(state, start, dt / 2, False))
    kept = 1 - min(1, filter_sound * dt)
    for p, (n, arm, _, _) in enumerate(points):
        taken = end - kept * start
        own(state, p, V)[:] = n * taken + kept * own(state, p, V)
        own(state, p, C)[:] = np.einsum("ak,b->abk", taken, arm / inertia).reshape(4, -1) + kept * own(state, p, C)
        if at_nodes:  # points move with the flow that strains them alone [Pressure 4]
            carried = flow[p] * to_faces
            own(state, p, U)[:] += dt * (sharpening * carried[:, None] * end - own(state, p, V))
        else:
            own(state, p, U)[:] += dt * n * (sharpening - 1) * end  # [Sharpening 2]
    drift(dt / 2)
    return strained(state, (start + end) / 2, dt, corrected)


def radius(theta, dt, **choices):
    return np.abs(np.linalg.eigvals(step_matrix(theta, dt, **choices))).max()


def waves(diagonal=False, count=16):
    """Wave numbers up to pi along each axis: on a grid, or of the diagonal alone."""
    numbers = np.pi * np.arange(1, count + 1) / count
    return [(a, b) for a in numbers for b in (0, *numbers) if (b == a if diagonal else b <= a)]


def growth(dt, thetas, **choices):
    """In a step, of the wave that grows most: among these, then beside the first of them along its direction."""
    first = max(thetas, key=lambda theta: radius(theta, dt, **choices))
    near = minimize_scalar(
        lambda s: -radius((s * first[0], s * first[1]), dt, **choices), bounds=(0.9, 1.1), method="bounded"
    )
    return -near.fun - 1


@pytest.fixture(scope="module")
def laboratory(tmp_path_factory):
    """What the case stability-gas measures of the kernel in the plane, by the ids of the gates that are read below."""
    file = tmp_path_factory.mktemp("gas") / "verify.json"
    gates = ["plane/default-rate", "plane-uncorrected/rate", "plane-uncorrected/ratio", "plane-points/uncorrected"]
    command = [os.environ["PLUMBLINE"], "verify", "stability-gas", "--tier", "full", *(f"--gate={gate}" for gate in gates), "--json", file]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return {gate["id"]: gate["measured"] for gate in json.loads(file.read_text())["gates"]}


@pytest.mark.parametrize("along", [2, 3])
@pytest.mark.parametrize("sharpened", [False, True])
@pytest.mark.parametrize("dt", [0.02, 0.2, 0.8])
def test_no_wave_grows_of_corrected_sums(dt, sharpened, along):
    assert growth(dt, waves(count=12), along=along, corrected=True, sharpened=sharpened) < 1e-6


def test_nor_does_one_in_the_laboratory(laboratory):
    assert laboratory["plane/default-rate"] == pytest.approx(0, abs=1e-5)


def test_the_laboratory_finds_the_growth_of_this_analysis(laboratory):
    # The laboratory looks at other wave numbers: the maximum is flat, and both find it to a thousandth.
    coarse, fine = (growth(dt, waves()) for dt in (0.2, 0.1))
    assert np.log1p(coarse) / 0.2 == pytest.approx(laboratory["plane-uncorrected/rate"], rel=1e-3)
    assert coarse / fine == pytest.approx(laboratory["plane-uncorrected/ratio"], rel=2e-3)


def test_and_that_of_more_points(laboratory):
    of_sixteen, of_four = (growth(0.2, waves(diagonal=True), along=along) for along in (4, 2))
    assert of_sixteen / of_four == pytest.approx(laboratory["plane-points/uncorrected"], rel=2e-3)


@pytest.mark.parametrize("sharpened", [False, True])
@pytest.mark.parametrize("dt", [0.1, 0.3, 0.8])
def test_no_wave_grows_of_pressures_at_the_nodes(dt, sharpened):
    # An eigenvalue 1 of a Jordan block of two, of displacements by velocities, spreads by the root of rounding.
    assert growth(dt, waves(count=12), at_nodes=True, sharpened=sharpened) < 1e-6


@pytest.mark.parametrize("scheme", [{"at_nodes": True}, {"corrected": True}])
def test_sound_is_of_fourth_order(scheme):
    def late(theta, **choices):
        dt = 0.02  # ahead by (theta dt)^2/24
        values = np.linalg.eigvals(step_matrix((theta, 0), dt, **choices))
        return 1 - np.abs(np.angle(values[np.abs(values) > 0.97])).max() / (dt * theta)

    found, points = ([late(theta, **choices) for theta in (0.1, 0.2, 0.4)] for choices in (scheme, {}))
    assert np.all(np.diff(np.log2(found)) > 3.9)  # the next term is of order theta^2 of it, which sharpening leaves
    assert np.all(np.array(found) < points)
