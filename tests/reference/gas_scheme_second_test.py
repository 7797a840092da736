"""The schemes on coarse meshes, where each of their coefficients shows: `gas_scheme_oracle`, to rounding.

Their own errors do not matter here: both follow one scheme on one mesh. What is left is rounding, which grows over a few
hundred steps by a few orders, and the Newton's method of one of them, that stops where a step changes 1e-10: together
below 1e-9 of the size of what is compared.
"""
import numpy
import pytest
from evaluator import evaluate, request
from gas_scheme_oracle import cell_means, converged, fields, finite_volumes
from riemann_oracle import Solution
from second_values import is_near

SLACK = 1e-9

# Density, velocity, pressure of either side; gamma, time, diaphragm, cells, courant.
TUBES = {
    "sod": ((1, 0, 1), (0.125, 0, 0.1), 1.4, 0.143, 0.5, 24, 0.8),
    "turned": ((0.2, 0.1, 0.15), (1.3, -0.2, 1.1), 5 / 3, 0.2, 0.57, 21, 0.7),
    "parting": ((1, -2, 0.4), (0.8, 2, 0.5), 1.4, 0.1, 0.5, 20, 0.8),
    "far_apart": ((1, -7, 0.4), (0.8, 6, 0.5), 1.4, 0.02, 0.5, 20, 0.4),
    "colliding": ((6, 19.6, 460), (5.9, -6.2, 46), 1.4, 0.02, 0.4, 22, 0.8),
    "fast": ((1, 3.1, 1), (0.6, 2.7, 0.7), 1.3, 0.06, 0.3, 20, 0.6),
    "fast_back": ((0.7, -2.9, 0.8), (1, -3.3, 1.1), 1.3, 0.06, 0.7, 20, 0.6),
    "weak": ((1, 0.02, 1), (0.9, -0.03, 0.95), 1.4, 0.3, 0.45, 20, 0.9),
    "strong": ((1, 0, 1000), (1.2, 0, 0.01), 1.4, 0.012, 0.52, 25, 0.5),
    "through_ends": ((1, 0.4, 1), (0.4, 0.3, 0.3), 1.4, 0.6, 0.5, 10, 0.8),
}


@pytest.mark.parametrize("name", TUBES)
def test_finite_volumes(name):
    left, right, gamma, time, diaphragm, cells, courant = TUBES[name]
    def initial(x):
        return numpy.where(x < diaphragm, numpy.array([left]).T, numpy.array([right]).T)
    edges = numpy.arange(cells + 1) / cells
    w, steps = finite_volumes(cell_means(initial, edges, [diaphragm], gamma), 1.0, gamma, time, courant)
    own = numpy.concatenate([w, [w[2] / ((gamma - 1) * w[0])]])
    exact = Solution(left, right, gamma)
    true = numpy.array([[float(v) for v in exact.sample(((k + 0.5) / cells - diaphragm) / time)] for k in range(cells)]).T
    at_rest = numpy.where(true[0] > 0, true[2] / numpy.where(true[0] > 0, true[0], 1) / (gamma - 1), numpy.nan)
    errors = [*abs(own[:3] - true[:3]).mean(axis=1), abs(own[3] - at_rest).mean()]
    settings = dict(gamma=gamma, time=time, diaphragm=diaphragm, cells=cells, courant=courant)
    for side, state in (("left", left), ("right", right)):
        settings |= {f"{side}.{key}": value for key, value in zip(("density", "velocity", "pressure"), state)}
    sizes = abs(own).max(axis=1)
    spread = numpy.argsort(-abs(numpy.diff(own[0], prepend=own[0, 0])), kind="stable")[:12]  # where most happens
    for some in (spread[:4], spread[4:8], spread[8:]):
        answer = evaluate([request("finite-volume", settings, (some + 0.3) / cells)])[0]
        assert is_near(answer[0], steps * cells, 1e-9)
        for got, error, size in zip(answer[1:5], errors, sizes):
            assert numpy.isnan(error) or is_near(got, error, SLACK * size)
        rows = numpy.array(answer[5:], dtype=object).reshape(len(some), 4, 2)
        assert rows.shape[0] == len(some)
        for k, cell in enumerate(some):
            for got, value, size in zip(answer[5 + 4 * k:9 + 4 * k], own[:, cell], sizes):
                assert is_near(got, value, SLACK * size)


def density_wave(time, amplitude=0.2, number=5):
    def initial(x):
        return numpy.where(x < -4, [[3.857143], [2.629369], [10.33333]],
                           numpy.array([1 + amplitude * numpy.sin(number * x), 0 * x, 1 + 0 * x]))
    return dict(initial=initial, jumps=[-4], ends=(-4 - 2.2 * time, -4 + 4 * time), domain=(-5, 5), time=time, walls=False)


def blasts(time):
    def initial(x):
        return numpy.array([1 + 0 * x, 0 * x, numpy.where(x < 0.1, 1000, numpy.where(x < 0.9, 0.01, 100))])
    return dict(initial=initial, jumps=[0.1, 0.9], ends=(0, 1), domain=(0, 1), time=time, walls=True)


FLOWS = [("shu-osher", density_wave, dict(time=1.8), 48), ("shu-osher", density_wave, dict(time=0.7), 40),
         ("shu-osher", density_wave, dict(time=1.1, amplitude=0.13, wave_number=3.7), 61),
         ("woodward-colella", blasts, dict(time=0.038), 60), ("woodward-colella", blasts, dict(time=0.05), 90),
         ("woodward-colella", blasts, dict(time=0.011), 40), ("woodward-colella", blasts, dict(time=0.027), 75)]


@pytest.mark.parametrize("flow", range(len(FLOWS)))
def test_moving_cells(flow):
    name, make, settings, cells = FLOWS[flow]
    problem = make(*settings.values())
    fine, errors = converged(problem, cells)
    jumps = abs(numpy.diff(fine.w[2]))
    shock = fine.x[1 + jumps.argmax()]
    order = 1 + numpy.argsort(-jumps[:-1], kind="stable")[:9]
    places = list(fine.x[order] + 0.23 * (fine.x[order + 1] - fine.x[order]))
    if problem["walls"]:
        places += [0.0, 0.003, 1.0]
    else:
        places += [fine.x[0] - 0.03, fine.x[-1] + 0.07, fine.x[-2] + 0.3 * (fine.x[-1] - fine.x[-2])]
    own = fields(fine, places, problem)
    sizes = [abs(fine.w[0]).max(), abs(fine.w[1]).max(), fine.w[2].max(), abs(own[3]).max()]
    for some in (slice(0, 4), slice(4, 8), slice(8, 12)):
        answer = evaluate([request(name, {**settings, "cells": cells}, places[some])])[0]
        assert is_near(answer[0], shock, SLACK)
        for got, error, size in zip(answer[1:5], errors, sizes):
            assert is_near(got, error, SLACK * size)
        values = own[:, some].T.ravel()
        assert len(answer) == 5 + len(values)
        for k, value in enumerate(values):
            assert is_near(answer[5 + k], value, SLACK * sizes[k % 4])


@pytest.mark.parametrize("radius,time,cells", [(0.38, 0.005, 40), (0.7, 0.02, 52), (0.2, 0.012, 44)])
def test_moving_cells_of_a_cylinder(radius, time, cells):
    def initial(x):
        return numpy.array([1 + 0 * x, 0 * x, 100 + 0 * x])
    speed = 5 * numpy.sqrt(140)
    problem = dict(initial=initial, jumps=[], ends=(0, radius), time=time, walls=True, front=(radius + speed * time, speed),
                   place=lambda s: 1 - (1 - s) * numpy.exp(-20 * s**4))
    fine, errors = converged(problem, cells)
    count = len(fine.m)
    places = [fine.x[k] + 0.27 * (fine.x[k + 1] - fine.x[k]) for k in (0, 1, count // 2, 2 * count // 3, count - 4, count - 3,
                                                                     count - 2, count - 1)]
    own = fields(fine, places, problem)
    sizes = [1, speed, 100, 250]
    for some in (slice(0, 4), slice(4, 8)):
        answer = evaluate([request("gas-expansion", dict(radius=radius, time=time, cells=cells), places[some])])[0]
        for got, error, size in zip(answer[2:6], errors, sizes):
            assert is_near(got, error, SLACK * size)
        for k, value in enumerate(own[:, some].T.ravel()):
            assert is_near(answer[6 + k], value, SLACK * sizes[k % 4])
