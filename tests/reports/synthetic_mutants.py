"""A kill matrix as ci/mutants writes it, made up: every sort of cell and of status."""

import json

CASES = ("sod", "spring-mass", "two-disks", "membrane-expansion")
TESTS = ("tests/cases/harness/verdict/order_test.cpp", "tests/reports/test_reader.py")


def mutant(name, area, status, **more):
    row = {
        "id": name,
        "file": {"reading": "reports/plumbline/reader.py"}.get(area, f"kernel/{area}.cpp"),
        "line": 12,
        "area": area,
        "kind": "factor",
        "origin": "declared",
        "what": f"what {name} does <once>",
        "status": status,
        "equivalent": None,
        "must_kill": [],
        "killed_by": [],
        "tests": [],
        "stopped": [],
        "cells": "rrrr--",
    }
    return {**row, **more}


def red(judge, gate, origin="theory", verdict="FAIL"):
    return {"test" if "/" in judge else "case": judge, "gate": gate, "origin": origin, "verdict": verdict}


def document():
    rows = [
        mutant(
            "wrong-sign",
            "kernel",
            "killed",
            killed_by=[red("sod", f"order {k}") for k in range(6)] + [red("spring-mass", "period", verdict="MISSING")],
            must_kill=[{"case": "sod", "gate": "order 0"}],
            cells="rrun--",
        ),
        mutant("endless", "walls", "killed", stopped=[{"by": "two-disks", "why": "time"}], origin="generated"),
        mutant("drifting", "materials", "killed_by_drift_only", killed_by=[red("sod", "stored", "regression")]),
        mutant("living", "contact", "survived"),
        mutant("unmet", "references", "survived", cells="uuuu--"),
        mutant("no-bug", "kernel", "equivalent", equivalent="both forms are the same sum"),
        mutant("narrow", "estimators", "killed", tests=[red(TESTS[0], "Order.Width", "test")], cells="rrrrr-"),
        mutant("swallowed", "reading", "killed", tests=[red(TESTS[1], "test_nan", "test")], cells="-----r"),
    ]
    columns = [{"name": name, "kind": "case", "seconds": 1.5, "gates": 9} for name in CASES]
    columns += [{"name": name, "kind": "tests", "seconds": 0.5, "gates": 20} for name in TESTS]
    return {
        "version": 1,
        "commit": "0123456789abcdef0123456789abcdef01234567",
        "dirty": False,
        "made": "2026-11-22 02:00 UTC",
        "columns": columns,
        "mutants": rows,
        "counts": {"killed": 4, "killed_by_drift_only": 1, "survived": 2, "equivalent": 1, "all": 8, "by_gates_of_cases": 2},
        "score": 4 / 7,
        "broken": ["wrong-sign is no longer killed by spring-mass, amplitude"],
    }


def write(folder):
    (folder / "mutants.json").write_text(json.dumps(document()), encoding="utf-8")
