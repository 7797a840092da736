"""A thousand random bags of gas against 50-digit arithmetic: the true error is within the bound, always."""
import gas_membrane_oracle as oracle
import numpy
from evaluator import evaluate, request, wide
from gas_membrane_oracle import R, covers, mp
from second_values import agrees


def random_bag(random):
    p = dict(gas_area=wide(random, 0.1, 10), gamma=float(random.uniform(1.05, 2)), length=wide(random, 0.1, 10),
             youngs_modulus=1e3 * wide(random, 1e-2, 1e2), poisson_ratio=float(random.uniform(-0.45, 0.45)),
             thickness=wide(random, 1e-2, 1), density=wide(random, 1e-2, 1e2), law=int(random.integers(0, 2)))
    elastic = p["youngs_modulus"] / (1 - p["poisson_ratio"] ** 2) * p["thickness"] * p["length"]
    p["gas_energy"] = elastic * wide(random, 1e-6, 0.5)
    p["lost"] = float(p["gas_energy"] * random.uniform(0, 0.5)) if random.uniform() < 0.5 else 0.0
    return p


KEYS = ("radius", "apothem", "area", "pressure", "tension", "stress", "strain", "gas", "membrane", "dry", "breathing")


def test_bags():
    random = numpy.random.default_rng(1789)
    problems = [random_bag(random) for _ in range(1000)]
    counts = [int(random.choice([1, 2, 3, 10, 100, 1000])) for _ in problems]
    answers = evaluate([request("membrane-equilibrium", p, [n]) for p, n in zip(problems, counts)])
    for i, (p, n, answer) in enumerate(zip(problems, counts, answers)):
        e = oracle.Bag(**p)
        near, slow = R(answer[6][0]), R(answer[14][0]) / e.modulus
        cold, end = e.cold(0, slow), e.end(0, near, i % 4 == 0)
        for start, exact in ((0, end), (18, e.end(n, near, i % 4 == 1))):
            for k, key in enumerate(KEYS):
                if not exact.get(key):  # frequencies not wanted, or none without gas
                    continue
                slack = 1e-24 * abs(exact[key]) if key in ("dry", "breathing") else 0  # of the oracle's differences
                assert agrees(answer[start + k], exact[key], slack), (p, n, key)
            if "breathing" in exact:
                assert covers(answer[start + 11], 2 * mp.pi / R(exact["breathing"]) + R(10) ** -30)
            assert all(bound <= 1e-13 * value for value, bound in answer[start : start + 9]), p
        assert covers(answer[12], cold["pressure"]) and covers(answer[13], cold["radius"]), p
        assert covers(answer[14], cold["stress"]), (p, answer[14], cold["stress"])
        V = e.t * e.L
        assert covers(answer[15], 2 * (e.gamma - 1) * end["gas"] / V)
        assert covers(answer[16], V) and covers(answer[17], V * e.density)
