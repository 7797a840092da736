"""The manufactured solutions against a second, independent computation: 60-digit arithmetic, derivatives by differences
of the displacement and of the stress (manufactured_oracle.py). True error <= bound for random materials, bodies, points
and times, and bounds near rounding.
"""
import random

import pytest
from evaluator import evaluate, request
from manufactured_oracle import axis_aligned, ring, state, vortex
from second_values import agrees

COUNT = 12  # problems of each kind; three points each


def material(rng, poisson=True):
    settings = dict(youngs_modulus=10 ** rng.uniform(0, 7), density=10 ** rng.uniform(-1, 3))
    return settings | ({"poisson": rng.uniform(-0.5, 0.45)} if poisson else {})


def wave_time(rng, s, length):
    return rng.uniform(0, 2) * length * (s["density"] / s["youngs_modulus"]) ** 0.5


def draw_bar(rng):
    L = 10 ** rng.uniform(-1, 1)
    s = material(rng) | dict(length=L, amplitude=rng.uniform(-0.3, 0.3) * L)
    s["time"] = wave_time(rng, s, L)
    return "mms-bar", s, axis_aligned(s), [[rng.uniform(0, L)] for _ in range(3)]


def draw_axis_aligned(rng):
    L, dim = 10 ** rng.uniform(-1, 1), rng.choice([2, 3])
    s = material(rng) | dict(length=L, amplitude=rng.uniform(-0.3, 0.3) * L, dimension=dim)
    s |= dict(phase_x=rng.uniform(-2, 2), phase_y=rng.uniform(-2, 2), phase_z=rng.uniform(-2, 2))
    s |= dict(y=rng.uniform(0, L), z=rng.uniform(0, L), time=wave_time(rng, s, L))
    return "mms-axis-aligned", s, axis_aligned(s), [[rng.uniform(0, L), s["y"], s["z"]][:dim] for _ in range(3)]


def draw_ring(rng):
    inner = 10 ** rng.uniform(-1, 1)
    outer = inner * rng.choice([rng.uniform(1.2, 2.5), rng.uniform(4, 6)])
    s = material(rng, poisson=False) | dict(inner=inner, outer=outer, amplitude=rng.uniform(-0.03, 0.03) * inner)
    s |= dict(y=rng.uniform(-0.9, 0.9) * inner, time=wave_time(rng, s, 1))
    return "mms-ring", s, ring(s), within(rng, s)


def draw_vortex(rng):
    inner = 10 ** rng.uniform(-1, 1)
    s = material(rng) | dict(inner=inner, outer=inner * rng.uniform(1.2, 4), amplitude=rng.uniform(-2, 2))
    s |= dict(period=10 ** rng.uniform(-2, 2), y=rng.uniform(-0.9, 0.9) * inner)
    s["time"] = rng.uniform(0, 1) * s["period"]
    return "mms-vortex", s, vortex(s), within(rng, s)


def within(rng, s):
    radii = [s["inner"] + rng.uniform(0.001, 0.999) * (s["outer"] - s["inner"]) for _ in range(3)]
    return [[rng.choice([-1, 1]) * (r * r - s["y"] ** 2) ** 0.5, s["y"]] for r in radii]


@pytest.mark.parametrize("draw", [draw_bar, draw_axis_aligned, draw_ring, draw_vortex])
def test_true_error_is_within_the_bound(draw):
    rng = random.Random(draw.__name__)
    cases = [draw(rng) for _ in range(COUNT)]
    answers = evaluate([request(name, s, [X[0] for X in points]) for name, s, _, points in cases])
    for (name, s, u, points), answer in zip(cases, answers):
        per_row = (len(answer) - 3) // len(points)
        for i, X in enumerate(points):
            row, exact = answer[3 + i * per_row:3 + (i + 1) * per_row], state(u, s, X, s["time"])
            assert len(row) == len(exact)
            for k, (got, true) in enumerate(zip(row, exact)):
                # the second computation's own error is below 1e-24 of the largest of its kind
                own = 1e-22 * (abs(true) + abs(got[0])) + 1e-26 * s["youngs_modulus"]
                assert agrees(got, true, own), (name, k, s, X)


def test_bounds_are_near_rounding_for_the_published_problems():
    """A few hundred roundings at most: of the largest number of its kind in the body, for stresses of Young's modulus, for
    entries of F of 1."""
    points = {"mms-bar": (1, 1e7, 0.003, [0.1, 0.37, 0.8]), "mms-axis-aligned": (2, 1e4, 0.003, [0.1, 0.37, 0.8]),
              "mms-ring": (2, 1e4, 0.008, [0.5, 0.6, 0.87]), "mms-vortex": (2, 1e3, 0.3, [0.75, 0.9, 1.1])}
    for name, (dim, youngs_modulus, time, at) in points.items():
        answer = evaluate([request(name, {"time": time}, at)])[0][3:]
        per_row = len(answer) // len(at)
        rows = [answer[i * per_row:(i + 1) * per_row] for i in range(len(at))]
        kinds = [slice(i * dim, (i + 1) * dim) for i in range(4)]
        kinds += [slice(4 * dim, 4 * dim + dim**2), slice(4 * dim + dim**2, None)]
        for kind, least in zip(kinds, [0, 0, 0, 0, 1, youngs_modulus]):
            numbers = [pair for row in rows for pair in row[kind]]
            sizes = numbers + [pair for row in rows for pair in row[2 * dim:3 * dim]] if kind == kinds[3] else numbers
            scale = max(least, max(abs(value) for value, _ in sizes))  # a body force is what accelerations leave
            margin = 1e-11 if name == "mms-vortex" else 1e-13  # the vortex shears by up to 8: products of F cancel
            assert max(bound for _, bound in numbers) <= margin * scale, (name, kind)
