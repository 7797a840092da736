"""A second, independent computation of the bar with a tip mass: linear finite elements, scipy's eigensolver.

With the consistent mass matrix the frequencies converge from above with errors in h^2, h^4, ...: two Richardson steps
leave h^6. The motion of the lower end has a kink in its acceleration whenever a wave arrives, which limits it to second
order.
"""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.linalg import eigh

BARS = {
    "york": dict(youngs_modulus=1e6, area=0.1, length=0.3, mass=3.33, density=0.1, gravity=250.0),
    "equal": dict(youngs_modulus=2e5, area=0.02, length=1.7, mass=0.9, density=0.9 / (0.02 * 1.7), gravity=9.81),
    "heavy": dict(youngs_modulus=70.0, area=2.0, length=0.5, mass=0.3, density=2.5, gravity=-3.0),
}


def modes(bar, elements):
    """Frequencies, shapes and gravity's load for the nodes below the support."""
    h = bar["length"] / elements
    n = elements
    stiffness = bar["youngs_modulus"] * bar["area"] / h * (2 * numpy.eye(n) - numpy.eye(n, k=1) - numpy.eye(n, k=-1))
    stiffness[-1, -1] /= 2
    element_mass = bar["density"] * bar["area"] * h
    mass = element_mass / 6 * (4 * numpy.eye(n) + numpy.eye(n, k=1) + numpy.eye(n, k=-1))
    mass[-1, -1] = element_mass / 3 + bar["mass"]
    load = numpy.full(n, element_mass * bar["gravity"])
    load[-1] = (element_mass / 2 + bar["mass"]) * bar["gravity"]
    _, shapes = eigh(stiffness, mass)
    # An eigensolver's small squares carry the rounding of the largest, 1e-16 of it, which is 1e-8 of the first here and
    # differs between linear-algebra libraries. The quotient of energies, strains taken as differences, loses no digits:
    # its error is the square of the shapes' own.
    strains = numpy.diff(shapes, axis=0, prepend=0)
    squares = bar["youngs_modulus"] * bar["area"] / h * numpy.sum(strains**2, axis=0) / numpy.sum(shapes * (mass @ shapes), axis=0)
    return numpy.sqrt(squares), shapes, load


@pytest.mark.parametrize("name", BARS)
def test_frequency_agrees(name):
    bar = BARS[name]
    coarse, middle, fine = (modes(bar, n)[0][0] for n in (16, 32, 64))
    first, second = (4 * middle - coarse) / 3, (4 * fine - middle) / 3
    other = (16 * second - first) / 15
    value, bound = evaluate([request("spring-mass", bar)])[0][3]
    # the sixth-order remainder is below the last correction over 15; 1e-12 for sums over 64 elements, tripled by each step
    assert abs(value - other) <= bound + abs(second - first) / 15 + 1e-12 * other
    assert abs(second - first) <= 1e-6 * other


@pytest.mark.parametrize("name", ["equal", "heavy"])
def test_motion_agrees(name):
    bar = BARS[name]
    wave = bar["length"] / numpy.sqrt(bar["youngs_modulus"] / bar["density"])
    times = wave * numpy.array([0.4, 0.9, 1.3, 2.2, 3.1, 4.7, 8.3])
    answer = evaluate([request("spring-mass", bar, times)])[0]
    exact = numpy.array([value for value, _ in answer[7:][1::2]])
    rest = abs(answer[6][0])
    errors = []
    for elements in (80, 160, 320):
        omega, shapes, load = modes(bar, elements)
        strength = shapes[-1] * (shapes.T @ load) / omega**2
        motion = strength @ (1 - numpy.cos(numpy.outer(omega, times)))
        errors.append(numpy.max(numpy.abs(motion - exact)) / rest)
    assert errors[-1] <= 1e-4  # (h/L)^2 = 1e-5 at 320 elements
    # second order gives 4: the elements converge to *this* motion, not to one nearby
    assert errors[0] / errors[1] >= 2.5 and errors[1] / errors[2] >= 2.5
