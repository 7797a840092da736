"""The schema accepts documents as the contract writes them, and refuses each of them with one fault. Needs no executable."""
import copy

import jsonschema
import pytest
from contract import SCHEMA, parse, validate

PROVENANCE = {"version": "0.1.0", "git": "1a2b3c4", "dirty": False, "fingerprint": "0123456789ab", "compiler": "g++ 12.2.0", "flags": "-O3", "cpu": "some",
              "instruction_set": "x86-64-v3", "threads": 1, "fused": True, "libraries": {"Eigen": "3.4.0"},
              "command": "plumbline run sod", "started": "2026-01-31T12:00:00Z"}
GATE = {"id": "sod/default/density.L1@100", "case": "sod", "scheme": "default", "quantity": "density.L1 at 100 cells",
        "expected": {"low": None, "high": 0.007}, "origin": "requirement", "reason": "first order from a prototype's 0.0066",
        "measured": 0.0066, "interval": None, "margin": 0.06, "verdict": "PASS", "cause": None, "run_ids": ["sod-default-100-0123456789ab"]}
MEASURE = {"error": 0.0066, "relative_error": 0.017, "value": None, "reference": None, "reference_bound": 1e-13, "unit": "1"}
BALANCE = {"initial": 1, "final": 1, "relative_drift": 0}
RUN = {"case": "sod", "scheme": "default", "settings": {"cells": 100, "transfer": "apic", "dt": None}, "verdict": "PASS",
       "finished": True, "stop": None, "steps": 108, "points": 450, "wall_s": 0.004, "particle_steps_per_s": 1.2e7,
       "measures": {"density.L1": MEASURE},
       "ledger": {"mass": BALANCE, "momentum_x": BALANCE, "angular_momentum": BALANCE,
                  "energy": {**BALANCE, "stores": {"kinetic": 0.1, "internal": 0.9}, "flows": {"walls": 0, "transfer": -1e-3}}},
       "gates": [GATE], "provenance": PROVENANCE, "file": "sod-default-100-0123456789ab.h5", "h": 0.01, "time": 0.143}
STOPPED = {**RUN, "finished": False, "verdict": "FAIL",
           "stop": {"reason": "density is not positive", "step": 3, "time": 0.01, "point": 17, "field": "density", "value": None}}
FIT = {"order": 0.97, "order_low": 0.93, "order_high": 1.01, "constant": 0.6, "asymptotic": True, "pairwise": [0.99, 0.96, 0.95, None],
       "leave_one_out": [1.0], "plateau": [0.6], "levels_used": [True, False], "reason": ""}
STUDY = {"scheme": "default", "vary": "cells", "settings": {}, "levels": [{**RUN, "value": 100}], "measures": {"density.L1": FIT}, "gates": [GATE],
         "title": "Sod", "why": "first order: a contact and a shock"}
CATALOG_GATE = {key: GATE[key] for key in ("id", "scheme", "quantity", "expected", "origin", "reason", "cause")}
COST = {"case": "sod", "scheme": "default", "study": "default", "kind": "gas", "differs": {}, "vary": "cells", "value": 100, "cells": 100,
        "h": 0.01, "dt": 1.3e-3, "points": 450, "steps": 108, "particle_steps": 48600, "finished": True, "source": "timed",
        "wall_s": [0.004, 0.0041], "instructions": None, "errors": {"density.L1": {"error": 0.0066, "relative_error": 0.017}}}
COMPARED = {"folder": "base", "version": "0.6.0", "git": "abc", "started": "2026-11-22T00:00:00Z", "executed": 3,
            "damaged": [{"file": "study-sod.h5", "reason": "truncated"}]}
SCORED = {"start": "sod-100.h5", "cells": 100, "outcome": "scored", "reason": "", "verdict": "PASS",
          "errors": {"density.L1": {"error": 0.01, "ratio": 1.8}}, "seconds": 0.3, "timed": "program"}
LATE = {**SCORED, "outcome": "late", "reason": "not done after 10 s", "verdict": None, "errors": {}, "seconds": None, "timed": None}
BOARD = {"scoreboard": 1, "refused": [{"start": "cut.h5", "reason": "truncated"}], "strays": ["other/sod-90.h5"], "provenance": PROVENANCE,
         "problems": [{"case": "sod", "title": "Shock tube", "settings": ["gamma=1.5"], "measure": "density.L1", "units": {"density.L1": "kg/m^3"},
                       "own": {"scheme": "default", "orders": {"density.L1": FIT},
                               "levels": [{"cells": 100, "h": 0.01, "errors": {"density.L1": 0.0056}, "seconds": 0.002, "stop": None}]},
                       "programs": [{"name": "other", "program": "other", "version": "", "study": "default", "verdict": "PASS", "reason": "",
                                     "entries": [SCORED, LATE], "orders": {"density.L1": FIT}, "gates": [GATE],
                                     "not_judged": [{"id": "default/drift", "reason": "reads the ledger"}]}]}]}
DOCUMENTS = {
    "run": RUN,
    "dry_run": {"case": "sod", "scheme": "default", "settings": {}, "points": 450, "cells": 100, "steps": 108, "bytes": 90000, "estimated_s": 0.01},
    "converge": {"case": "sod", "studies": [STUDY]},
    "verify": {"gates": [GATE], "counts": {"PASS": 1, "XFAIL": 0}, "executed": 1, "declared": 1, "tier": "quick",
               "parts": [{"kind": "shape", "name": "cubic", "verdict": "PASS", "gates": 68, "red": []}]},
    "stability": {"problem": "bar", "configurations": [
        {"integrator": "musl", "settings": {}, "unit": "h/c", "predicted": [{"low": 0, "high": 1.833}], "closed_form": 1.833,
         "observed": [{"low": 1.832, "high": 1.834}], "always": None, "growth": [{"dt": 0.1, "per_step": 1.0}]}]},
    "bench": {"machine": {"cpu": "some"}, "kernels": [
        {"dimension": 2, "material": "gas", "shape": "quadratic", "transfer": "apic", "integrator": "energy", "points": 1000000, "ppc": 16,
         "threads": 1, "particle_steps_per_s": 5.0e7, "bytes_per_point": 0, "flops_per_point": 0, "fraction_of_limit": 0.5, "energy_drift": 1e-14}]},
    "cost": {"machine": {"cpu": "some"}, "fingerprint": None, "tier": "quick", "repeats": 5, "runs": [COST],
             "left_out": [{"case": "sod", "scheme": "default", "study": "integrator/rk4", "vary": "cells", "value": 400}], "provenance": PROVENANCE},
    "list": {"cases": [{"name": "sod", "title": "Shock tube", "source": "York 4.1", "cells_along": "the tube, 1 m", "keys": ["gamma", "t_end"]}],
             "schemes": [{"name": "default", "title": "the project's best", "source": "this project", "kinds": {"gas": {"shape": "cubic"}}, "settings": {"gas": {"shape": "quadratic"}}}],
             **{kind: [{"name": "usl", "title": "a line", "source": "York 3"}]
                for kind in ("integrators", "shapes", "transfers", "densities", "contacts", "materials", "references")}, "problems": []},
    "explain": {"name": "sod", "title": "Shock tube", "source": "York 4.1", "claim": "a claim", "physics": "first\n\nsecond", "equations": ["p = (γ-1) ρ i"],
                "sketch": "", "cells_along": "the tube", "parameters": [
                    {"key": "gamma", "value": 1.4, "default": 1.4, "unit": "1", "low": 1, "high": None, "description": "ratio of heats"}],
                "reference": {"name": "riemann", "text": "exact", "bound": 1e-13}, "theory_order": {"density.L1": {"order": 1, "why": "contact"}},
                "known_limits": ["none"], "gates": [{**CATALOG_GATE, "tier": "quick"}], "regenerate": "plumbline verify sod --tier quick"},
    "reference": {"name": "riemann", "settings": {"gamma": 1.4}, "values": {"pressure_star": 0.303130}, "bounds": {"pressure_star": 1e-14},
                  "at": [{"xi": 0.5, "density": 0, "velocity": 0, "pressure": 0}]},
    "plan": {"plan": 1, "tier": "quick", "batches": [{"id": "0001-small", "size": "small", "estimated_s": 1.5, "memory_mb": 0.1, "runs": [
        {"case": "sod", "scheme": "default", "study": "default", "cells": 100, "settings": {"ppc": 4, "transfer": "flip"},
         "file": "sod-default-100-0123456789ab.h5", "frames": {"count": 10, "most_points": 20000}}]}]},
    "sweep": {"tier": "none", "wanted": 2, "made": 1, "kept": 0, "runs": [{key: RUN[key] for key in (
        "file", "case", "scheme", "settings", "steps", "points", "wall_s", "stop", "measures")}],
              "failed": [{"file": "sod-default-200-0123456789ab.h5", "case": "sod", "error": "signal 6 (Aborted)"}]},
    "export": {"exchange_format": 1, "kind": "initial-state", "case": "sod", "problem": "0123456789ab", "start": "0123456789ab", "cells": 100, "end_time": 0.143,
               "grid": {"dim": 1, "axisymmetric": False, "h": 0.01, "low": [0], "high": [1], "cells": [100], "walls": {"x": ["symmetry", "free"]}},
               "pistons": [{"direction": "x", "scene_lies": "above", "position": 0, "velocity": 1}], "gravity": [0], "contact": "none",
               "scheme": "default", "settings": {"cells": 100}, "scored": True, "why_not_scored": None, "version": "0.5.0",
               "measures": [{"name": "density.L1", "unit": "kg/m^3", "norm": "mean"}],
               "bodies": [{"name": "gas", "group": "/bodies/gas", "points": 450, "velocity_field": "common",
                           "material": {"name": "ideal_gas", "parameters": {"gamma": {"value": 1.4, "unit": "1"}}},
                           "datasets": {name: {"shape": [450], "unit": "1"} for name in ("position", "velocity", "mass", "volume")},
                           "segments": None, "load": None, "enclosure": None,
                           "final_state": {"points": "any number", "datasets": [
                               {"name": "mass", "unit": "kg", "components": 1, "instead": [], "what": "its mass"}]}}]},
    "score": {"case": "sod", "scheme": "foreign:other", "program": "other", "version": "", "study": "default", "expectation": "declared",
              "verdict": "PASS", "results": ["a.h5"], "levels": [{**RUN, "value": 100}], "measures": {"density.L1": FIT}, "gates": [GATE],
              "not_judged": [{"id": "default/drift", "reason": "reads the ledger"}], "provenance": PROVENANCE},
    "scoreboard": BOARD,
    "diff": {"baseline": COMPARED, "results": COMPARED, "change": "worse", "nothing_changed": False, "summary": "1 worse", "moved": 0,
             "counts": {"worse": 1, "new": 0}, "largest_move": 0, "machine": [{"key": "compiler", "before": "g++ 12", "after": "g++ 13"}],
             "findings": [{"change": "worse", "kind": "order", "case": "sod", "scheme": "default", "study": "cells", "quantity": "density.L1",
                           "before": 1.0, "after": 0.4, "size": -0.6, "interval": [-0.7, None], "equal": False, "note": ""}]},
    "tolerances": {"file": "cases/tolerances.json", "recorded": 1, "declared": 1,
                   "widened": [{"case": "sod", "study": "cells", "id": "a", "tier": "quick", "low": None, "high": 1, "order": True,
                                "origin": "requirement", "reason": "0123456789ab", "since": "2026-11-22",
                                "widened": {"from": {"low": None, "high": 0.9}, "date": "2026-11-22", "why": "because"}}],
                   "discrepancies": [{"kind": "new", "case": "*", "study": "*", "id": "*/mass", "message": "new"}]},
    "error": {"error": {"key": "cflx", "value": "1", "allowed": ["cfl", "dt"], "nearest": ["cfl"], "message": "unknown key cflx"}},
}


def changed(document, path, value):
    """A copy with the entry at `path` replaced; ... removes it."""
    document = copy.deepcopy(document)
    place = document
    for step in path[:-1]:
        place = place[step]
    if value is ...:
        del place[path[-1]]
    else:
        place[path[-1]] = value
    return document


def test_schema_is_a_schema():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("name", DOCUMENTS)
def test_document_of_the_contract_is_accepted(name):
    validate(name, DOCUMENTS[name])
    jsonschema.Draft202012Validator(SCHEMA).validate(DOCUMENTS[name])


@pytest.mark.parametrize("name", DOCUMENTS)
def test_each_required_key_is_missed_and_no_other_is_let_in(name):
    required = SCHEMA["$defs"][name]["required"]
    assert required
    for key in required:
        with pytest.raises(AssertionError):
            validate(name, changed(DOCUMENTS[name], [key], ...))
    with pytest.raises(AssertionError):
        validate(name, {**DOCUMENTS[name], "surprise": 1})


def test_stopped_run():
    validate("run", STOPPED)


@pytest.mark.parametrize("name, path, value", [
    ("run", ["verdict"], "GREEN"),
    ("run", ["steps"], 1.5),
    ("run", ["steps"], -1),
    ("run", ["wall_s"], None),
    ("run", ["finished"], False),                                    # unfinished without a stop
    ("run", ["stop"], STOPPED["stop"]),                              # finished with one
    ("run", ["settings", "list"], [1]),
    ("run", ["measures", "density.L1", "error"], "0.0066"),
    ("run", ["measures", "density.L1", "unit"], ...),
    ("run", ["measures", "density L1"], MEASURE),
    ("run", ["ledger", "energy", "flows"], ...),
    ("run", ["ledger", "energy", "flows", "friction"], 0),           # a flow that no ledger books
    ("run", ["ledger", "energy", "stores", "heat"], 0),
    ("run", ["ledger", "mass", "relative_drift"], ...),
    ("run", ["ledger", "momentum_x"], ...),
    ("run", ["provenance", "started"], "yesterday"),
    ("run", ["provenance", "threads"], 0),
    ("run", ["provenance", "dirty"], "no"),
    ("run", ["file"], "/" + "elsewhere/sod.h5"),                     # stored paths are relative
    ("run", ["gates", 0, "reason"], ""),                             # no number without a reason
    ("run", ["gates", 0, "origin"], "guess"),
    ("run", ["gates", 0, "expected"], {"low": None, "high": None}),  # no gate without a bound
    ("run", ["gates", 0, "expected"], {"high": 1}),
    ("run", ["gates", 0, "measured"], None),                         # PASS without a measured value
    ("run", ["gates", 0, "verdict"], "XFAIL"),                       # an expected failure without its cause
    ("run", ["gates", 0, "interval"], [1]),
    ("run", ["gates", 0, "run_ids"], "all"),
    ("converge", ["studies"], {}),
    ("converge", ["studies"], []),
    ("converge", ["studies", 0, "vary"], "everything"),
    ("converge", ["studies", 0, "levels", 0, "h"], ...),
    ("converge", ["studies", 0, "measures", "density.L1", "pairwise"], 0.9),
    ("converge", ["studies", 0, "measures", "density.L1", "asymptotic"], "yes"),
    ("verify", ["counts", "GREEN"], 1),
    ("verify", ["counts", "PASS"], -1),
    ("verify", ["tier"], "nightly"),
    ("verify", ["parts", 0, "kind"], "case"),
    ("stability", ["configurations", 0, "always"], "mostly"),
    ("stability", ["configurations", 0, "unit"], "s"),
    ("bench", ["kernels"], []),
    ("bench", ["kernels", 0, "particle_steps_per_s"], None),
    ("cost", ["runs", 0, "wall_s"], []),
    ("cost", ["runs", 0, "source"], "guessed"),
    ("cost", ["runs", 0, "vary"], "ppc"),
    ("cost", ["runs", 0, "errors", "density.L1", "relative_error"], None),
    ("list", ["cases", 0, "cells_along"], ...),
    ("list", ["cases", 0, "surprise"], 1),
    ("list", ["integrators", 0, "source"], ""),
    ("list", ["schemes", 0, "settings"], {}),
    ("explain", ["parameters", 0, "unit"], ...),
    ("explain", ["gates", 0, "reason"], " "),
    ("explain", ["regenerate"], "make"),
    ("export", ["grid", "walls", "x"], ["symmetry", "sticky"]),
    ("export", ["bodies", 0, "material", "parameters", "gamma", "unit"], ...),
    ("export", ["bodies", 0, "datasets", "mass"], ...),
    ("score", ["scheme"], "default"),                                # a foreign result says so
    ("score", ["not_judged", 0, "reason"], ""),
    ("score", ["levels", 0, "value"], ...),
    ("scoreboard", ["problems", 0, "programs", 0, "entries", 0, "outcome"], "lost"),
    ("scoreboard", ["problems", 0, "programs", 0, "entries", 0, "reason"], "why"),   # scored, and yet a reason
    ("scoreboard", ["problems", 0, "programs", 0, "entries", 1, "reason"], ""),      # not scored without one
    ("scoreboard", ["problems", 0, "programs", 0, "entries", 1, "verdict"], "PASS"),
    ("scoreboard", ["problems", 0, "own", "levels", 0, "h"], 0),
    ("reference", ["values", "pressure_star"], "0.3"),
    ("error", ["error", "message"], ""),
    ("error", ["error", "nearest"], "cfl"),
])
def test_document_with_one_fault_is_refused(name, path, value):
    with pytest.raises(AssertionError, match=rf"^{name}: at "):
        validate(name, changed(DOCUMENTS[name], path, value))


@pytest.mark.parametrize("text", ['{"a": NaN}', '{"a": -Infinity}'])
def test_numbers_that_are_not_finite_are_no_json(text):
    with pytest.raises(AssertionError, match="not finite"):
        parse(text)


@pytest.mark.parametrize("text", ["plumbline\n{}", "{} done", ""])
def test_text_beside_json_is_no_json(text):
    with pytest.raises(ValueError):
        parse(text)
