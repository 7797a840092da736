"""The liquid-filled tube a second time: the membrane's differential equations integrated along the arc by scipy, from
the middle of the floor, and tension, contact and pressure found by shooting; its area by Green's theorem. No elliptic
integrals.
"""
import numpy
import pytest
from evaluator import evaluate, request
from scipy.integrate import solve_ivp
from scipy.optimize import fsolve

TUBES = {
    "default": dict(perimeter=4.0, specific_weight=9810.0, top_pressure=2000.0, compliance=0.0),
    "flat": dict(perimeter=10.0, specific_weight=12e3, top_pressure=900.0, compliance=0.0),
    "nearly round": dict(perimeter=0.3, specific_weight=9810.0, top_pressure=9e4, compliance=0.0),
    "elastic": dict(perimeter=4.0, specific_weight=9810.0, top_pressure=2000.0, compliance=4e-5),
}


def shot(p, tension, contact, bottom, dense=False):
    half = 0.5 * p["perimeter"] * (1 + p["compliance"] * tension)
    def along(_, state):
        x, y, angle, area = state
        return [numpy.cos(angle), numpy.sin(angle), (bottom - p["specific_weight"] * y) / tension,
                2 * x * numpy.sin(angle)]
    return solve_ivp(along, (contact / 2, half), [contact / 2, 0, 0, 0], method="DOP853", rtol=1e-12, atol=1e-13,
                     dense_output=dense)


@pytest.mark.parametrize("name", TUBES)
def test_shooting(name):
    p = TUBES[name]
    radius, weight = p["perimeter"] / (2 * numpy.pi), p["specific_weight"]
    def missed(unknown):
        tension, contact, bottom = unknown * scale
        x, y, angle, _ = shot(p, tension, contact, bottom).y[:, -1]
        return [x / radius, angle - numpy.pi, (bottom - weight * y) / p["top_pressure"] - 1]
    answer = evaluate([request("geo-tube", p, [0.1 * p["perimeter"], 0.3 * p["perimeter"], 0.45 * p["perimeter"]])])[0]
    # starts 2 % off the answer under test and must come back to it; the map is one to one there
    scale = numpy.array([answer[3][0], answer[2][0], answer[6][0]])
    found = fsolve(missed, [1.005, 0.99, 1.003], xtol=1e-13)
    assert numpy.abs(missed(found)).max() <= 1e-9
    tension, contact, bottom = found * scale
    path = shot(p, tension, contact, bottom, dense=True)
    x, y, angle, area = path.y[:, -1]
    assert [answer[3][0], answer[2][0], answer[6][0]] == pytest.approx([tension, contact, bottom], rel=1e-7)
    assert answer[0][0] == pytest.approx(y, rel=1e-8)
    assert answer[5][0] == pytest.approx(area, rel=1e-8)
    stretch = 1 + p["compliance"] * tension
    for j, share in enumerate([0.1, 0.3, 0.45]):
        s = share * p["perimeter"] * stretch
        row = [value for value, _ in answer[7 + 5 * j:12 + 5 * j]]
        if s <= contact / 2:
            assert row[:4] == pytest.approx([s, 0, 0, 0], abs=1e-7)
            continue
        x, y, angle, _ = path.sol(s)
        assert row[:3] == pytest.approx([x, y, angle], abs=1e-7 * max(1, radius))
        assert row[3] == pytest.approx((bottom - weight * y) / tension, rel=1e-6)
    widest = path.sol(numpy.linspace(contact / 2, path.t[-1], 20001))[0].max()
    assert answer[1][0] == pytest.approx(2 * widest, rel=1e-7)
