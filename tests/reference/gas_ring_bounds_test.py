"""A thousand random rings and spheres around a gas against 50-digit arithmetic: the true error is within the bound, always."""
import gas_membrane_oracle as oracle
import numpy
from evaluator import evaluate, request, wide
from gas_membrane_oracle import R, covers, mp


def random_ring(random):
    p = dict(youngs_modulus=1e3 * wide(random, 1e-2, 1e2), poisson_ratio=float(random.uniform(-0.45, 0.45)),
             radius=wide(random, 0.1, 10), thickness=wide(random, 1e-2, 1), gamma=float(random.uniform(1.05, 2)),
             law=int(random.integers(0, 3)))
    modulus = p["youngs_modulus"] / (1 - p["poisson_ratio"] ** 2)
    p["pressure"] = modulus * p["thickness"] / p["radius"] * wide(random, 1e-5, 2)
    p["gas_density"] = wide(random, 1e-2, 1e2)
    p["line_mass"] = p["gas_density"] * p["radius"] * wide(random, 1e-2, 1e2)
    p["velocity"] = wide(random, 1e-2, 1e2) * float(random.choice([-1, 1]))
    return p


def test_rings():
    random = numpy.random.default_rng(1930)
    problems = [random_ring(random) for _ in range(1000)]
    modes = [int(random.integers(1, 8)) for _ in problems]
    times = [[wide(random, 1e-2, 1e2) * p["radius"]] for p in problems]
    requests = [request("gas-ring", dict(p, mode=n), t) for p, n, t in zip(problems, modes, times)]
    for p, n, (t,), answer in zip(problems, modes, times, evaluate(requests)):
        e = oracle.Ring(**p)
        w = e.omega(n, answer[4 + n][0])
        mass = e.modal_mass(w)
        expected = [(0, e.strain), (1, e.r0), (2, e.k), (3, e.dry), (4, e.slow), (4 + n, w), (15, 2 * mp.pi / w), (16, mass),
                    (17, mass * e.v**2 / 2), (18, e.shape(0.5, w)), (19, e.pressure(0, w)), (20, e.pressure(1, w)),
                    (21, e.v / w * mp.sin(w * R(t))), (22, e.v * mp.cos(w * R(t))),
                    (23, e.pressure(1, w) * e.v / w * mp.sin(w * R(t)))]
        for i, true in expected:
            assert covers(answer[i], true), (p, n, i, answer[i], true)
        assert all(bound <= 1e-11 * value for value, bound in answer[5:15]), p  # J1's rounding is absolute: z of 0.1
        assert [value for value, _ in answer[5:15]] == sorted(value for value, _ in answer[5:15])


def random_sphere(random):
    p = dict(youngs_modulus=wide(random, 1e-2, 1e2), poisson_ratio=float(random.uniform(-0.5, 0.5)), thickness=wide(random, 1e-3, 0.1),
             density=wide(random, 1e-2, 1e2), radius=wide(random, 0.1, 10), stretch=1 + wide(random, 1e-3, 1),
             neo_hookean=int(random.integers(0, 2)), gamma=float(random.uniform(1.05, 2)), velocity=wide(random, 1e-2, 1e2))
    return dict(p, gas_density=p["density"] * p["thickness"] / p["radius"] * wide(random, 1e-2, 1e2))


def test_spheres():
    random = numpy.random.default_rng(1806)
    problems = [random_sphere(random) for _ in range(1000)]
    modes = [int(random.integers(1, 8)) for _ in problems]
    times = [[wide(random, 1e-2, 1e2) * p["radius"]] for p in problems]
    requests = [request("gas-sphere", dict(p, mode=n), t) for p, n, t in zip(problems, modes, times)]
    for p, n, (t,), answer in zip(problems, modes, times, evaluate(requests)):
        e = oracle.Sphere(**p)
        w = e.omega(n, answer[4 + n][0])
        expected = [(0, e.p), (1, e.n), (2, e.k), (4, e.slow), (4 + n, w), (15, e.shape(0.5, w)), (16, e.pressure(w)),
                    (17, e.v * mp.cos(w * R(t)))]
        for i, true in expected:
            assert covers(answer[i], true), (p, n, i, answer[i], true)
        assert all(bound <= 1e-10 * value for value, bound in answer[5:15]), p
        assert [value for value, _ in answer[5:15]] == sorted(value for value, _ in answer[5:15])
