"""A scoreboard made up for the tests of its page: documents as `plumbline scoreboard` writes them."""

import json

from synthetic_results import PROVENANCE, fit, gate

CELLS = (50, 100, 200, 400, 800)
SIZES = [1 / cells for cells in CELLS]


def entry(cells, ratio=None, outcome="scored", reason="", seconds=None, timed=None, verdict="NONE"):
    errors = {"density.L1": {"error": 0.5 * ratio / cells, "ratio": ratio}} if ratio else {}
    return {"start": f"sod-{cells}.h5", "cells": cells, "outcome": outcome, "reason": reason, "verdict": verdict if outcome == "scored" else None,
            "errors": errors, "seconds": seconds, "timed": timed}  # fmt: skip


def program(name, entries, verdict, orders=None, gates=(), **more):
    return {"name": name, "program": name if verdict else None, "version": "2.1" if verdict else None, "study": "default" if verdict else None,
            "verdict": verdict, "reason": "", "entries": entries, "orders": {"density.L1": orders} if orders else {}, "gates": list(gates),
            "not_judged": [{"id": "default/drift", "reason": "reads the <ledger>"}] if verdict else [], **more}  # fmt: skip


def problem(case, title, cells, programs, **more):
    levels = [{"cells": n, "h": 1 / n, "errors": {"density.L1": 0.5 / n}, "seconds": 2e-7 * n * n, "stop": None} for n in cells]
    return {"case": case, "title": title, "settings": [], "measure": "density.L1", "units": {"density.L1": "kg/m^3"},
            "own": {"scheme": "default", "levels": levels, "orders": {"density.L1": fit(SIZES, SIZES)} if len(cells) > 1 else {}},
            "programs": programs, **more}  # fmt: skip


def board():
    missed = gate("sod", "foreign:coarse", "default/order", "order of density.L1", 0.9, None, "FAIL", 0.4)
    met = gate("sod", "foreign:exact", "default/order", "order of density.L1", 0.9, None, "PASS", 1.0)
    series = [
        program("coarse", [entry(n, 1.5 + k, seconds=0.1 * n, timed="program") for k, n in enumerate(CELLS)], "FAIL", fit([h**0.4 for h in SIZES], SIZES), [missed]),
        program("exact", [entry(n, 0.25, seconds=3.0, timed="adapter") for n in CELLS], "PASS", fit(SIZES, SIZES), [met]),
        program(
            "troubled",
            [entry(50, outcome="missing", reason="there is no result"),
             entry(100, outcome="damaged", reason="/bodies/gas/velocity is nan in row 3; it must be finite"),
             entry(200, outcome="mismatched", reason="time is 0.1 s; 0.143 s is wanted"),
             entry(400, outcome="failed", reason="exit status 1: ValueError: <no> such wall"),
             entry(800, outcome="late", reason="not done after 10 s")],
            None,
        ),
    ]  # fmt: skip
    single = [
        program("coarse", [entry(100, 12.5, verdict="FAIL")], "FAIL", gates=[missed]),
        program("exact", [entry(100, 0.011, verdict="PASS")], "PASS", gates=[met]),
        program("troubled", [entry(100, outcome="missing", reason="there is no result")], None),
    ]
    problems = [
        problem("bar-riemann", "Impact of a bar", (100,), single, settings=["velocity=1e-05", "t_end=1.25"]),
        problem("sod", "Sod’s shock tube", CELLS, series),
    ]
    return {"scoreboard": 1, "problems": problems, "refused": [{"start": "cut.h5", "reason": "truncated: 7 of 9 bytes are there"}],
            "strays": ["exact/sod-90.h5"], "provenance": {**PROVENANCE, "command": "plumbline scoreboard board"}}  # fmt: skip


def write_board(folder, document=None):
    (folder / "scoreboard.json").write_text(json.dumps(document or board()), encoding="utf-8")
    return folder
