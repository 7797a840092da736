"""Scorecards as `plumbline verify --integrator` writes them, and the document of ci/judges, made up: every sort of row."""

import json

EVIL = "<once>"
PROBLEMS = (  # problem, choices, unit, limit, closed form
    ("plane", "linear flip, ppc 1, place_x 0.01, place_y 0.01", "h/c", 0.751288, 0.7512886),
    ("bar", "linear flip, ppc 1, N 0.01", "h/c", 1.0204081, 1.0204082),
    ("bar", "linear flip, ppc 1, N 0.5", "h/c", 2.0, None),
    ("oscillator", "", "1/omega", 2.0, 2.0),
)
LACK = {"trait": "returned-loss", "why": "the gas needs returned-loss: integrator mine does not return what the maps take"}


def gate(name, verdict="PASS", measured=0.2, low=None, high=1.0, **more):
    family = name.split("/")[0]
    return {
        "id": name,
        "case": "integrator",
        "scheme": "mine",
        "study": family,
        "quantity": f"what {name} measures {EVIL}",
        "expected": {"low": low, "high": high},
        "origin": "identity" if family == "identities" else "theory",
        "reason": f"why {family} has this bound",
        "measured": measured,
        "interval": None,
        "margin": 0.8 if verdict == "PASS" else -0.5,
        "verdict": verdict,
        "cause": "known" if verdict in ("XFAIL", "XPASS") else None,
        "band": None,
        "run_ids": [],
        "note": "",
        **more,
    }


def limits(**more):
    rows = [
        {
            **dict(zip(("problem", "choices", "unit", "limit", "closed_form"), row)),
            "endless": False,
            "growth": None,
            "smallest": number == 0,
            "note": "",
            **more,
        }
        for number, row in enumerate(PROBLEMS)
    ]
    coupled = {**rows[0], "problem": "coupled", "choices": "cubic apic", "limit": None, "closed_form": None, "smallest": False}
    return [*rows[:-1], {**coupled, "endless": False, "growth": None, "note": LACK["why"]}, rows[-1]]


def curve(case, factor, measure="density.L1", note=""):
    levels = [
        {"cells": cells, "error": 2.0 / cells**2, "particle_steps": 40 * cells**2, "wall_s": [factor * cells**2 * t for t in (1e-6, 1.2e-6, 0.9e-6)]}
        for cells in (10, 20, 40)
    ]
    return {"case": case, "measure": measure, "levels": [] if note else levels, "note": note}


def half(name, **more):
    """Right in all, and timed."""
    measured = {
        "consistency": "at most 2.7e-08 left for dt -> 0",
        "order": "displacement 2.000, velocity 1.998",
        "stability": "2.0000/omega on the oscillator",
        "energy": "bounded",
    }
    claimed = {"order": "2 of displacement (oscillator)", "stability": "2.0000/omega", "energy": "bounded"}
    families = ("consistency", "order", "stability", "energy", "invariance", "jumps", "identities")
    return {
        "integrator": name,
        "title": f"what {name} does {EVIL}",
        "source": "a book, 1997",
        "parameters": {"rho_b": 0.8},
        "effort": "whole",
        "sentence": f"{name}: consistent, of order 2 (displacement 2.000, velocity 1.998), stable up to 2.0000/omega on an oscillator, energy bounded.",
        "verdict": "PASS",
        "needs": [],
        "offers": ["forward-steps"],
        "families": [
            {
                "family": family,
                "claimed": claimed.get(family),
                "measured": measured.get(family, "2 of 2 gates met"),
                "verdict": "PASS",
                "gates": 2,
                "red": [],
            }
            for family in families
        ],
        "limits": limits(),
        "cost": [curve(case, 1.0) for case in ("mms-bar", "bar-riemann", "sod", "string-vibration")],
        **more,
    }


def green():
    """With costs: one case without a factor, one where the other integrator stopped."""
    against = half("midpoint", cost=[curve("mms-bar", 2.0), curve("bar-riemann", 0.5), curve("sod", 1.0, note="stopped: no number")])
    names = [f"{row['family']}/{part}" for row in against["families"] for part in ("first", "second")]
    gates = [gate(name) for name in names[:-2]]
    gates += [gate(f"identities/{case}/{name}", margin=margin) for case, margin in (("sod", 0.9), ("noh", 0.25)) for name in ("mass", "finite")]
    gates[0].update(interval=[0.1, 0.3], note="the interval is that of the extrapolation")
    return {
        **half("mine"),
        "against": against,
        "factors": [
            {"case": "mms-bar", "factor": 0.5, "low": 0.42, "high": 0.61, "note": ""},
            {"case": "bar-riemann", "factor": 2.0, "low": 1.7, "high": 2.4, "note": ""},
            {"case": "sod", "factor": None, "low": None, "high": None, "note": "stopped: no number"},
        ],
        "factor": {"case": "median", "factor": 1.0, "low": 0.85, "high": 1.21, "note": ""},
        "next": None,
        "gates": gates,
        "not_applicable": [{"what": f"identities/airbag-200/{name}", "integrator": "mine", "missing": [LACK]} for name in ("mass", "finite")]
        + [{"what": "jumps/sod/order", "integrator": "mine", "missing": [LACK, {**LACK, "trait": "forward-steps"}]}],
    }


def red():
    """Wrong: three red gates of two causes, no stable step, no factor anywhere."""
    card = green()
    verdicts = {"consistency": "FAIL", "stability": "INVALID", "energy": "XFAIL"}
    for row in card["families"]:
        row["verdict"] = verdicts.get(row["family"], "PASS")
    card["families"][0].update(measured="at most 5.2e-04 left for dt -> 0", red=["consistency/first", "consistency/second"])
    card["families"][2].update(measured="no stable step on the oscillator", claimed=None, red=["stability/first"])
    why = "a force is not dt times its rate"
    card["gates"][0] = gate("consistency/first", "FAIL", 5.2e-4, high=1e-5, explanation=why)
    card["gates"][1] = gate("consistency/second", "FAIL", 4e-4, high=1e-5, explanation=why, interval=[3e-4, 5e-4])
    card["gates"][4] = gate("stability/first", "INVALID", None, explanation="energy comes in at every step", note="stopped at step 3", margin=None)
    card["gates"][6] = gate("energy/first", "XFAIL", 3.0)
    found = limits(limit=0, growth=1.0003)
    for row in found:
        row["smallest"] = False
    return {
        **card,
        "integrator": "wrong",
        "sentence": "wrong: not consistent, of order 0 (displacement 0.010, velocity 0.002), without a stable step on an oscillator, energy growing.",
        "verdict": "INVALID",
        "limits": found,
        "factors": [{**row, "factor": None, "low": None, "high": None, "note": "every error is above the other's"} for row in card["factors"]],
        "factor": None,
        "next": f"consistency/first: {why}",
    }


def endless():
    """Of the core set alone, without another beside it, stable at every step."""
    families = half("endless")["families"]
    for row in families[4:]:
        row.update(measured="not judged", verdict="NONE", gates=0)
    found = [{**row, "limit": None, "endless": True, "note": ""} for row in limits()]
    return {
        **half("endless", effort="core", families=families, limits=found, cost=[], parameters={}, source=""),
        "sentence": "endless: consistent, of order 2 (displacement 2.000, velocity 1.998), stable at every step on an oscillator, energy bounded.",
        "against": None,
        "factors": [],
        "factor": None,
        "next": None,
        "gates": [gate("consistency/first"), gate("energy/second", measured=None, verdict="NONE", high=None, margin=None)],
        "not_applicable": [],
    }


def bare():
    """What a file of another version may have: all that it must."""
    return {"integrator": "bare", "sentence": "bare: consistent.", "verdict": "PASS"}


def cards():
    return {"scorecard-mine.json": green(), "scorecard-wrong.json": red(), "scorecard-endless.json": endless(), "scorecard-bare.json": bare()}


def judged(name, title, verdict, gate_id=None, **more):
    seen = gate_id and {
        "id": gate_id, "case": "integrator", "quantity": "what it measures", "expected": {"low": None, "high": 1e-5}, "measured": 4.5e-4,
        "margin": -44.0, "verdict": "FAIL", "note": "", "family": gate_id.split("/")[0], "explanation": "a factor",
    }  # fmt: skip
    return {
        "integrator": name, "title": title, "source": "this test", "verdict": verdict, "stopped": None, "gate": seen,
        "proven": bool(gate_id) and not gate_id.startswith("identities"), "gates": 12, "inconclusive": 0, "seconds": 0.4, **more,
    }  # fmt: skip


def judges():
    wrong = [
        judged("wrong-strain-short", f"strains short by 0.1 % {EVIL}", "red", "consistency/spring"),
        judged("wrong-momentum", "a momentum is lost now and then", "red", "identities/impulse"),
        judged("wrong-unseen", "nothing sees this", "green"),
        judged("wrong-stopped", "ends the program", "stopped", stopped="exit status 139: no output"),
    ]
    weak = [judged("weak-heun2", "Heun’s method: growth (w dt)⁴/8 a step", "red", "stability/oscillator/growth")]
    agrees = {"quantity": "order", "known": 3, "measured": 2.998, "agrees": True}
    differs = {"quantity": "limit", "known": 1.7320508, "measured": 1.6, "agrees": False}
    right = [judged("right-kutta3", "Kutta’s method", "green", known=[agrees]), judged("right-ruth3", "Ruth’s method", "green", known=[agrees, differs])]
    changes = [
        judged("systematic-musl-01-map_forces", "musl, call 1 (map_forces): left out", "red", "consistency/spring", stage="map_forces", status="killed", argument=None),
        judged("systematic-musl-02-map_momentum", "musl, call 2 (map_momentum): doubled", "green", stage="map_momentum", status="equivalent", argument="it is the same map again"),
        judged("systematic-musl-03-locate_points", "musl, call 3 (locate_points): left out", "green", stage="locate_points", status="survived", argument=None),
    ]  # fmt: skip
    counts = {"changes": 1, "killed": 0, "equivalent": 0, "survived": 0}
    stages = {row["stage"]: {**counts, row["status"]: 1} for row in changes}
    smallest = [
        {"gate": "consistency/spring", "strain": 1e-4, "force": 1e-4, "motion": 1e-3},
        {"gate": "consistency/difference-bar", "strain": 1e-3, "force": None, "motion": 1e-3},
    ]
    return {
        "wrong": wrong, "weak": weak, "right": right, "systematic": {"stages": stages, "changes": changes}, "smallest": smallest,
        "commit": "0123456789abcdef0123456789abcdef01234567", "dirty": True, "made": "2026-11-23 02:00 UTC",
    }  # fmt: skip


def write_card(folder, name, card):
    (folder / name).write_text(json.dumps(card, allow_nan=False), encoding="utf-8")


def write(folder):
    for name, card in cards().items():
        write_card(folder, name, card)
    (folder / "judges.json").write_text(json.dumps(judges(), allow_nan=False), encoding="utf-8")
