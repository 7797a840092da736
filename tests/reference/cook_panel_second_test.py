"""Second computation: Cook's panel by elements of high order, which do not lock, on meshes that shrink geometrically towards all sides."""
import numpy
import pytest
import scipy.sparse
from evaluator import evaluate, request
from numpy.polynomial import legendre
from scipy.sparse.linalg import spsolve
from second_values import agrees

WIDTH, LEFT, RIGHT = 48, 44, 16


def lagrange(nodes, x):
    """Values and derivatives at x of the polynomials that are one at one node each."""
    value, slope = numpy.ones((len(x), len(nodes))), numpy.zeros((len(x), len(nodes)))
    for a, at in enumerate(nodes):
        others = [b for b in nodes if b != at]
        value[:, a] = numpy.prod([(x - b) / (at - b) for b in others], axis=0)
        for left_out in others:
            factors = [(x - b) / (at - b) for b in others if b != left_out]
            slope[:, a] += numpy.prod(factors, axis=0) / (at - left_out)
    return value, slope


def corner(E, nu, load, layers, order):
    """Upward displacement of the corner at the top right."""
    mu = E / (2 * (1 + nu))
    lam = 2 * mu * nu / (1 - 2 * nu)
    half = numpy.concatenate([[0], 0.5 * 0.15 ** numpy.arange(layers, -1, -1)])
    cuts = numpy.concatenate([half, 1 - half[-2::-1]])
    elements, nodes = len(cuts) - 1, numpy.concatenate([[-1], legendre.Legendre.basis(order).deriv().roots(), [1]])
    gauss, weights = legendre.leggauss(order + 2)
    value, slope = lagrange(nodes, gauss)
    lines = elements * order + 1
    rows, columns, entries, f = [], [], [], numpy.zeros(2 * lines**2)
    for i in range(elements):
        for j in range(elements):
            ds, dt = 2 / numpy.diff(cuts)[[i, j]]
            s, t = numpy.meshgrid(cuts[i] + (gauss + 1) / ds, cuts[j] + (gauss + 1) / dt, indexing="ij")
            height, tilt = (LEFT - (LEFT - RIGHT) * s).ravel(), (LEFT - (LEFT - RIGHT) * t).ravel()
            along_t = numpy.kron(value, slope) * dt / height[:, None]
            dx, dy = (numpy.kron(slope, value) * ds - tilt[:, None] * along_t) / WIDTH, along_t
            w = (numpy.outer(weights, weights).ravel() * WIDTH * height / (ds * dt))[:, None]
            strain = numpy.zeros((3, len(w), 2 * dx.shape[1]))
            strain[0][:, 0::2] = strain[2][:, 1::2] = dx
            strain[1][:, 1::2] = strain[2][:, 0::2] = dy
            dilatation = strain[0] + strain[1]
            K = lam * dilatation.T @ (w * dilatation) + sum(
                m * e.T @ (w * e) for m, e in zip((2 * mu, 2 * mu, mu), strain)
            )
            node = ((i * order + numpy.arange(order + 1))[:, None] * lines + j * order + numpy.arange(order + 1)).ravel()
            at = numpy.stack([2 * node, 2 * node + 1], axis=1).ravel()
            rows.append(numpy.repeat(at, len(at)))
            columns.append(numpy.tile(at, len(at)))
            entries.append(K.ravel())
            if i == elements - 1:
                f[2 * node[-order - 1 :] + 1] += weights @ value / dt * load
    K = scipy.sparse.csc_matrix((numpy.concatenate(entries), (numpy.concatenate(rows), numpy.concatenate(columns))))
    free = numpy.arange(2 * lines, 2 * lines**2)
    return spsolve(K[free][:, free], f[free])[-1]


@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.4999])
def test_corner_of_the_panel(poisson):
    p = dict(youngs_modulus=240.565, poisson=poisson, load=100.0)
    deflection = evaluate([request("cook-panel", p, [])])[0][0]
    coarse, fine = (corner(240.565, poisson, 100.0, layers, 6) for layers in (2, 3))
    own = abs(fine - coarse)
    assert own <= 3e-4 * deflection.value
    assert agrees(deflection, fine, own)
    assert deflection.bound <= 1e-3 * deflection.value  # a twentieth of what the case may be wrong by
