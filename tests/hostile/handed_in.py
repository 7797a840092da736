"""Hostile files handed in: final states, plans, damaged results, ledgers and boards."""
import json

import files
import values
from kinds import kind
from outcome import Fault, difference, document
from sandbox import Call


TUBES = ("sod", "lax", "toro-1", "toro-3", "toro-5", "leblanc", "sod-moving", "bar-riemann")


@kind(12)
def scored(dice, catalog):
    """Final states: a right one, then what nobody would call right."""
    computed = dice.random() < 0.4
    case = dice.choice(TUBES[:-1]) if computed else dice.choice(catalog.scored)
    _, high = values.ends({p["key"]: p for p in catalog.parameters(case)}["cells"])
    cells = dice.choice((20, 40)) if computed else min(high, dice.randrange(4, 16))
    exported = yield Call(("export", case, "--cells", str(cells), "--output", "start.h5", "--json", "-"), floor=20)
    if exported.code != 0:
        return
    start, path = exported.folder / "start.h5", exported.folder / "mine.h5"
    if computed:
        made = yield Call(("run", case, "--cells", str(cells), "--results", "own"))
        if made.code != 0:
            return
        files.computed(start, next((made.folder / "own").glob("*.h5")), path)
        yield Call(("score", case, "--result", "mine.h5", "--json", "-"), statuses=(0, 1))
    else:
        files.handed_back(start, path)
    what, right_as_file = files.spoil(dice, path)
    words = list(dice.choice(((), (), (), ("--set", "gamma=1.3"), ("--result", "mine.h5"), ("--json", "s.json"), ("--allow-inconclusive",))))
    other = case if dice.random() < 0.9 else dice.choice(catalog.names("cases"))
    statuses = (1, 2, 4) if not computed or right_as_file else (0, 1, 2, 4)
    words += [] if "--json" in words else ["--json", "-"]
    yield Call(("score", other, "--result", "mine.h5", *words), statuses=statuses, floor=20,
               why=f"{'the start handed back' if not computed else 'a right state'} with: {what}")


@kind(7)
def planned(dice, catalog):
    """`--plan` of `--from`: the whole plan is checked, nothing runs; or a small one runs."""
    case = dice.choice(catalog.runs)
    own = {"sweep": {"case": [case], "cells": [max(4, values.ends(catalog.parameters(case)[0])[0]), 6], "ppc": [2]}}
    plan = dice.choice((own, own, {"runs": [{"case": case, "scheme": "default", "settings": {"cells": 4}}]}, None))
    if plan is None:
        plan = catalog.plan(dice.choice(("bar-riemann", "sod", "spring-mass")))
        plan = {**plan, "batches": [{**batch, "runs": batch["runs"][:2]} for batch in plan["batches"][:2]]}
    raw, form = files.plan_bytes(dice, plan)
    if dice.random() < 0.2:
        checked = yield Call(("sweep", "--from", "-", "--plan", "-"), stdin=raw, statuses=(0, 2, 4))
    else:
        folder = yield None
        (folder / "plan.json").write_bytes(raw)
        if dice.random() < 0.1:
            files.instead(dice, folder / "plan.json") if dice.random() < 0.8 else None
            if (folder / "plan.json").is_fifo():
                return
        checked = yield Call(("sweep", "--from", "plan.json", "--plan", "-"), statuses=(0, 2, 4))
        if checked.code == 0 and form in ("whole", "values") and (found := json.loads(checked.out)):
            seconds = sum(batch["estimated_s"] for batch in found["batches"])
            if seconds < catalog.longest / 2:
                yield Call(("sweep", "--from", "plan.json", "--jobs", str(dice.choice((1, 2))), "--json", "-"), estimate=seconds, floor=40)


@kind(5)
def damaged_results(dice, catalog):
    """Results that are damaged between two calls: made anew, or an error that names the file."""
    case, cells = dice.choice(("sod", "bar-riemann", "spring-mass", "piston-shock")), dice.choice(("4,8", "6,12"))
    call = ("converge", case, "--cells", cells, "--reuse", "--json", "-")
    first = yield Call(call)
    stored = sorted((first.folder / "results").glob("*.h5"))
    if first.code not in (0, 1) or not stored:
        return
    path = dice.choice(stored)
    what = files.spoil_result(dice, path) if dice.random() < 0.75 else files.instead(dice, path)
    second = yield Call(call, statuses=(0, 1, 4), why=f"{path.name}: {what}")
    if second.code in (0, 1):
        if second.code != first.code:
            yield Fault("stale", f"{path.name}: {what}; exit status {first.code}, then {second.code}")
        elif where := difference(document(first)["studies"], document(second)["studies"]):
            yield Fault("stale", f"{path.name}: {what}; another document: {where}")


@kind(4)
def compared(dice, catalog):
    """Two folders of results, one of them changed by hand."""
    made = yield Call(("verify", "bar-riemann", "--results", "base"))
    base, results = made.folder / "base", made.folder / "results"
    names = sorted(path.name for path in base.glob("*.h5"))
    if made.code not in (0, 1) or not names:
        return
    results.mkdir()
    for name in names:
        (results / name).write_bytes((base / name).read_bytes())
    untouched = yield Call(("diff", "base", "results", "--json", "-"), statuses=(0, 1))
    if untouched.code == 0 and not document(untouched)["nothing_changed"]:
        yield Fault("repeat", "a copy of the results is not equal to them")
    path = dice.choice((base, results)) / dice.choice(names)
    what = dice.choice((files.spoil_result, files.instead))(dice, path)
    after = yield Call(("diff", "base", "results", *dice.choice(((), ("--all",), ("--allow", "missing"), ("--allow", "missing", "--allow", "widened"))),
                        "--json", "-"), statuses=(0, 1, 2, 4), why=f"{path.name}: {what}")
    if after.code == 0:
        said = document(after)
        if said["nothing_changed"] and path.name.startswith("study-") and not path.is_file():
            yield Fault("green", f"{path.name}: {what}, and nothing changed")


@kind(2)
def ledgers(dice, catalog):
    """A ledger of tolerances changed by hand."""
    made = yield Call(("tolerances", "t.json", "--update"), floor=30)
    path = made.folder / "t.json"
    if made.code != 0:
        return
    if dice.random() < 0.3:
        what = files.instead(dice, path)
    else:
        said, what = json.loads(path.read_text(encoding="utf-8")), "changed"
        if dice.random() < 0.5:
            lists = [key for key in said if isinstance(said[key], list)]
            for key in lists:
                said[key] = files.wrong_value(dice, said[key][:5]) if dice.random() < 0.5 else said[key][:-1]
            path.write_text(json.dumps(said), encoding="utf-8")
        else:
            path.write_bytes(files.wrong_text(dice, json.dumps(said)))
    yield Call(("tolerances", "t.json", *dice.choice(((), ("--update",), ("--update", "--why", ""), ("--against", "t.json"))), "--json", "-"), floor=30,
               why=what)


@kind(2)
def boards(dice, catalog):
    """A scoreboard of what is no program."""
    case = dice.choice(("sod", "bar-riemann", "toro-1"))
    folder = yield None
    (folder / "board/cases").mkdir(parents=True)
    exported = yield Call(("export", case, "--cells", "10", "--output", "board/cases/one.h5"))
    if exported.code != 0:
        return
    for program in ("idle", "junk"):
        (folder / f"board/programs/{program}").mkdir(parents=True)
        files.handed_back(folder / "board/cases/one.h5", folder / f"board/programs/{program}/one.h5")
    files.spoil(dice, folder / "board/programs/junk/one.h5")
    if dice.random() < 0.3:
        files.damage(dice, folder / "board/cases/one.h5")
    words = ["--timeout", "5"]
    if dice.random() < 0.6:
        adapter = folder / "adapter"
        adapter.write_text("#!/bin/sh\n" + dice.choice(("exit 0", "exit 3", "kill -9 $$", "echo junk > \"$2\"", "cp \"$1\" \"$2\"", "sleep 60",
                                                        "mkdir \"$2\"", "ln -s \"$2\" \"$2\"", "yes > \"$2\"", "head -c 100 \"$1\" > \"$2\"")) + "\n", encoding="utf-8")
        adapter.chmod(0o755)
        words = ["--timeout", "1", "--run", dice.choice(("mine=./adapter", "idle=./adapter", "=./adapter", "mine=", "a/b=./adapter", "mine=./none"))]
    yield Call(("scoreboard", "board", *words, "--json", "-"), statuses=(1, 2, 4), floor=40, why="no program here computed anything")
