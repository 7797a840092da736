"""A thousand random pistons against 50-digit arithmetic: the true error is within the bound, always."""
import gas_membrane_oracle as oracle
import numpy
from evaluator import evaluate, request, wide
from gas_membrane_oracle import R, covers, mp


PISTON = ("spring_modulus", "spring_length", "spring_density", "area", "mass", "gas_density", "bulk_modulus", "gas_length",
          "velocity")


def random_piston(random, heavy, low, high):
    """The ratios of masses and of transit times decide: masses on the piston's over [low, high], the stiffnesses freely."""
    p = {key: wide(random, 1e-2, 1e2) for key in PISTON}
    p["gas_density"] = p["mass"] * wide(random, low, high) / (p["area"] * p["gas_length"])
    p["spring_density"] = p["mass"] * wide(random, low, high) / (p["area"] * p["spring_length"]) if heavy else 0.0
    p["velocity"] *= float(random.choice([-1, 1]))
    return p


def test_pistons():
    """700 with a heavy spring, 300 with a massless one; three frequencies and participations, six of every tenth."""
    random = numpy.random.default_rng(1997)
    problems = [random_piston(random, i < 700, 1e-6, 1e3) for i in range(1000)]
    relative = []
    for i, (p, answer) in enumerate(zip(problems, evaluate([request("piston-container", p) for p in problems]))):
        exact = oracle.Piston(**p)
        assert covers(answer[0], exact.K)
        roots = exact.roots(3 if i % 10 else 6, [value for value, _ in answer[2:8]])
        assert covers(answer[1], 2 * mp.pi / roots[0])
        for n, w in enumerate(roots):
            mass = exact.modal_mass(w)
            assert covers(answer[2 + n], w), (p, n, answer[2 + n], w)
            assert covers(answer[8 + n], exact.v * exact.m / mass / w), (p, n, answer[8 + n])
            relative.append(answer[2 + n][1] / answer[2 + n][0])
        mass = exact.modal_mass(roots[0])
        assert covers(answer[14], mass) and covers(answer[15], mass * exact.v**2 / 2), p
    assert max(relative) <= 1e-12  # roundings of the phase, times the number of poles


def test_pistons_with_nearly_coinciding_poles():
    """Transit times equal to within 1e-3 down to rounding: roots between poles that can hardly be told apart."""
    random = numpy.random.default_rng(62)
    problems = []
    for i in range(100):
        p = random_piston(random, True, 1e-2, 1e2)
        apart = 10 ** random.uniform(-16, -3) if i % 4 else 0.0
        p["spring_modulus"] = p["bulk_modulus"] * p["spring_density"] / p["gas_density"] * \
            (p["spring_length"] / p["gas_length"]) ** 2 * (1 + apart)
        problems.append(p)
    for p, answer in zip(problems, evaluate([request("piston-container", p) for p in problems])):
        exact = oracle.Piston(**p)
        with mp.workdps(80):
            roots = exact.roots(6)
        for n, w in enumerate(roots):
            assert covers(answer[2 + n], w), (p, n, answer[2 + n], w)
            assert answer[2 + n][1] <= 1e-12 * answer[2 + n][0]


def test_motion_of_the_piston():
    """By waves, up to five echoes; a bound from the modes left out, 1e-6 of the amplitude for masses alike."""
    random = numpy.random.default_rng(6)
    problems, times, exact = [], [], []
    for i in range(100):
        p = random_piston(random, i % 3 > 0, 0.05, 20)
        if i % 3:  # transit times alike, or the echoes of one side are too many
            p["spring_modulus"] = p["bulk_modulus"] * p["spring_density"] / p["gas_density"] * \
                (p["spring_length"] / p["gas_length"]) ** 2 * wide(random, 0.3, 3)
        else:  # and the spring's frequency no more than some times the gas's
            stiffness = p["mass"] * (wide(random, 0.1, 5) / float(oracle.Piston(**p).tau)) ** 2
            p["spring_modulus"] = stiffness * p["spring_length"] / p["area"]
        e = oracle.Piston(**p)
        problems.append(p)
        exact.append(e)
        scale = float(min(e.tau, e.tau_s) if e.heavy else e.tau)
        times.append([scale * t for t in random.uniform(0, [2, 11])])
    answers = evaluate([request("piston-container", p, t) for p, t in zip(problems, times)])
    for p, e, ts, answer in zip(problems, exact, times, answers):
        w = e.roots(1, [answer[2][0]])[0]
        for t, row in zip(ts, (answer[16:20], answer[20:24])):
            place, speed = e.motion(t)
            assert covers(row[0], place), (p, t, row[0], place)
            assert covers(row[1], speed), (p, t, row[1], speed)
            assert covers(row[2], e.v / w * mp.sin(w * R(t))) and covers(row[3], e.v * mp.cos(w * R(t)))
            assert row[0][1] <= 1e-5 * abs(p["velocity"]) / float(w) and row[1][1] <= 2e-2 * abs(p["velocity"])
