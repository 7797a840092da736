"""Rates as `ci/mutants --draw` writes them, made up: bugs that a gate, a test or nothing sees, and one that changes nothing."""

import json


def rate(killed, of):
    share = killed / of if of else None
    return {"killed": killed, "of": of, "rate": share, "interval": [max(0, share - 0.25), min(1, share + 0.125)] if of else None}


def row(name, case=None, part=None, test=None, **more):
    seen = {"by": "sod", "gate": "order", "stopped": ""}
    return {
        "id": f"s7-{name}",
        "operator": name.split("-")[0],
        "folder": "kernel",
        "file": "kernel/walls.cpp",
        "line": 12,
        "what": f"a<b of {name}: left out",
        "by_case": seen if case else None,
        "by_part": {"by": "shape cubic", "gate": "sum", "stopped": ""} if part else None,
        "by_test": {"by": "tests/kernel", "gate": "Walls.Reflect", "stopped": ""} if test else None,
        "ran": 3,
        "left_out": 0,
        "equivalent": None,
        "in_cases": bool(case),
        "in_gates": bool(case or part),
        "in_all": bool(case or part or test),
        **more,
    }


def document():
    rows = [row("term-000", case=True), row("term-001", test=True), row("stage-000"), row("stage-001", ran=0),
            row("stage-002", part=True),
            row("sign-000", equivalent="minus nothing is nothing")]  # fmt: skip
    sites = {"rate": 0.4, "interval": [0.1, 0.8], "effective": 3.0}
    return {
        "version": 1,
        "seed": "7",
        "commit": "0123456789abcdef0123456789abcdef01234567",
        "dirty": False,
        "made": "2026-11-25 02:00 UTC",
        "cases": 63,
        "dear": 30,
        "all": 6,
        "equivalent": 1,
        "stopped": 0,
        "by_cases": {**rate(1, 5), "by_sites": sites},
        "by_gates": {**rate(2, 5), "by_sites": sites},
        "by_everything": {**rate(3, 5), "by_sites": sites},
        "operators": [
            {"name": "term", "sites": 4000, "excluded": 7, "by_cases": rate(1, 2), "by_gates": rate(1, 2), "by_everything": rate(2, 2)},
            {"name": "stage", "sites": 60, "excluded": 0, "by_cases": rate(0, 3), "by_gates": rate(1, 3), "by_everything": rate(1, 3)},
            {"name": "sign", "sites": 940, "excluded": 0, "by_cases": rate(0, 0), "by_gates": rate(0, 0), "by_everything": rate(0, 0)},
        ],
        "folders": [{"name": "kernel", "by_cases": rate(1, 5), "by_gates": rate(2, 5), "by_everything": rate(3, 5)}],
        "passed_over": {"no code": 2},
        "broken": [],
        "mutants": rows,
    }


def write(folder):
    (folder / "draw.json").write_text(json.dumps(document()), encoding="utf-8")
