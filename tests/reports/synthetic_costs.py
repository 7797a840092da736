"""Costs as `plumbline bench --cases` writes them, made up: errors that fall with the mesh, times that grow with its square."""

import json


def entry(scheme, study, cells, error, wall, case="sod", **more):
    relative = None if error is None else error
    return {
        "case": case, "scheme": scheme, "study": study, "kind": "gas", "differs": {}, "vary": "cells", "value": cells,
        "cells": cells, "h": 1 / cells, "dt": 1e-3, "points": 4 * cells, "steps": cells, "particle_steps": 4 * cells**2,
        "finished": error is not None, "source": "timed", "wall_s": [0.9 * wall, wall, 1.2 * wall], "instructions": None,
        "errors": {} if error is None else {"density.L1": {"error": error, "relative_error": relative}}, **more,
    }  # fmt: skip


def document(runs):
    return {"machine": {"cpu": "some"}, "tier": "quick", "repeats": 3, "runs": runs, "provenance": {"command": "plumbline bench --cases"}}


def first_order(scheme, study, constant, **more):
    """error = constant / cells, time = 1e-5 cells^2: 1 % at 100 constant cells."""
    return [entry(scheme, study, cells, constant / cells, 1e-5 * cells**2, **more) for cells in (50, 100, 200, 400)]


def write(folder):
    """The default scheme is at 1 % with half the cells of York's."""
    runs = first_order("default", "default", 1) + first_order("york1997", "york1997", 2)
    (folder / "cost.json").write_text(json.dumps(document(runs)), encoding="utf-8")
