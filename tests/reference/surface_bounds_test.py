"""Membranes in space against 40-digit arithmetic: the true error is within the bound."""
import mpmath
import numpy
from evaluator import evaluate, request, wide
from surface_oracle import R, Sphere, covers


def random_sphere(random):
    """A pressed or stretched sphere, released so that it turns: a balloon short of its limit point, 7^(1/6) = 1.38."""
    rubber = int(random.integers(0, 2))
    return dict(youngs_modulus=wide(random), poisson_ratio=float(random.uniform(-0.5, 0.5)), thickness=wide(random),
                density=wide(random), radius=wide(random), stretch=float(random.uniform(0.9, 1.25 if rubber else 2)),
                neo_hookean=rubber, amplitude=wide(random, 1e-6, 0.15) * float(random.choice([-1, 1])))


def test_random_spheres():
    random = numpy.random.default_rng(1961)
    problems = [random_sphere(random) for _ in range(60)]
    places = [[float(random.uniform(0.5, 4))] for _ in problems]
    answers = evaluate([request("pressurised-sphere", p, at) for p, at in zip(problems, places)])
    for p, at, answer in zip(problems, places, answers):
        amplitude = p.pop("amplitude")
        exact = Sphere(**p)
        turning, period = exact.swing(amplitude, answer[4][0])
        assert (turning - exact.l0) * amplitude < 0
        truth = [exact.p, exact.t * exact.stress(exact.l0), exact.omega(), period, turning]
        l = exact.l0 * 0 + at[0]
        truth += [exact.pressure(l), exact.t * exact.stress(l), exact.stress(l)]
        for i, (got, true) in enumerate(zip(answer, truth)):
            assert covers(got, true), (p, amplitude, i, got, true)
            assert got[1] <= 1e-11 * abs(got[0]), (p, i, got)


def test_random_drums():
    random = numpy.random.default_rng(1877)
    problems = [dict(youngs_modulus=wide(random), poisson_ratio=float(random.uniform(-0.5, 0.5)),
                     thickness=wide(random), density=wide(random), stretch=1 + wide(random, 1e-3, 2),
                     radius=wide(random), around=int(random.integers(0, 12)), across=int(random.integers(1, 12)))
                for _ in range(60)]
    places = [[float(p["radius"] * random.uniform())] for p in problems]
    answers = evaluate([request("prestretched-drum", p, at) for p, at in zip(problems, places)])
    taut = [dict(radius=p["radius"], tension=p["youngs_modulus"], area_density=p["density"], around=p["around"],
                 across=p["across"]) for p in problems]
    plain = evaluate([request("drum", p, at) for p, at in zip(taut, places)])
    for p, at, answer, other in zip(problems, places, answers, plain):
        E, nu, t, rho, l, a = (R(p[key]) for key in list(p)[:6])
        tension, mass = t * E / (1 - nu) * (l**2 - 1) / 2, rho * t / l**2
        zero = mpmath.besseljzero(p["around"], p["across"])
        shape = mpmath.besselj(p["around"], zero * R(at[0]) / a)
        speed = mpmath.sqrt(tension / mass)
        for got, true in zip(answer, [tension, mass, speed, zero / a * speed, shape]):
            assert covers(got, true), (p, got, true)
        for got, true in zip(other[2:], [mpmath.sqrt(E / rho), zero / a * mpmath.sqrt(E / rho), shape]):
            assert covers(got, true), (p, got, true)
        assert answer[3][1] <= 1e-12 * answer[3][0] and answer[4][1] <= 1e-11, (p, answer)


def test_balloon_beyond_its_limit_point():
    """Its pressure is known; it does not breathe."""
    p = dict(stretch=2.0, neo_hookean=1)
    pressure, resultant, omega = evaluate([request("pressurised-sphere", p)])[0]
    exact = Sphere(1, 0.3, 0.01, 1, 1, **p)
    assert covers(pressure, exact.p) and covers(resultant, exact.p) and omega == (0.0, omega[1])


def test_random_tension_fields():
    """The largest value of S e - W_c(S) over where it can be attained: no stress, one, or both."""
    random = numpy.random.default_rng(1986)
    problems = [dict(youngs_modulus=wide(random), poisson_ratio=float(random.uniform(-0.5, 0.5)), thickness=wide(random),
                     density=wide(random), stretch=float(random.uniform(0.9, 1.3)), shear=wide(random, 1e-3, 0.3),
                     half_side=wide(random), along=int(random.integers(1, 9)), across=int(random.integers(1, 9)))
                for _ in range(200)]
    places = [[float(random.uniform(0, 0.5))] for _ in problems]
    answers = evaluate([request("tension-field", p, at) for p, at in zip(problems, places)])
    states = set()
    for p, at, answer in zip(problems, places, answers):
        E, nu, t, rho, l, s, a = (R(p[key]) for key in list(p)[:7])
        def relaxed(shear):
            e1, e2 = (((l * (1 + shear)) ** 2 - 1) / 2, ((l * (1 - shear)) ** 2 - 1) / 2)
            both = mpmath.lu_solve(mpmath.matrix([[1 / E, -nu / E], [-nu / E, 1 / E]]), mpmath.matrix([e1, e2]))
            choices = [(R(0), R(0)), (E * e1, R(0)), (R(0), E * e2), (both[0], both[1])]
            return max((s1 * e1 + s2 * e2 - (s1**2 + s2**2 - 2 * nu * s1 * s2) / (2 * E), s1, s2)
                       for s1, s2 in choices if s1 >= 0 and s2 >= 0)
        energy, s1, s2 = relaxed(s)
        states.add((s1 > 0) + (s2 > 0))
        l1, l2 = l * (1 + s), l * (1 - s)
        k = mpmath.pi / (2 * a)
        truth = [energy, s1, s2, t * s1 * l1 / l2, t * s2 * l2 / l1,
                 mpmath.sqrt((s1 * (k * p["along"]) ** 2 + s2 * (k * p["across"]) ** 2) / rho), *relaxed(R(at[0]))]
        for i, (got, true) in enumerate(zip(answer, truth, strict=True)):
            assert covers(got, true), (p, i, got, true)
        assert answer[1][1] <= 1e-11 * p["youngs_modulus"], (p, answer)
    assert states == {0, 1, 2}
