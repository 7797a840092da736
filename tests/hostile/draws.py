"""The kinds of random calls. Each is a generator that yields calls and is sent their outcomes; it ends with `Skipped` where it would
take too long, and yields a `Fault` of its own where two outcomes disagree."""
import dataclasses
import json
import signal

import contract
import files
import values
from outcome import Fault, difference, document
from sandbox import Call



@dataclasses.dataclass(frozen=True)
class Skipped:
    why: str


KINDS = {}


def kind(weight):
    def register(function):
        KINDS[function.__name__] = (weight, function)
        return function
    return register


def pick(dice):
    names = sorted(KINDS)
    return dice.choices(names, [KINDS[name][0] for name in names])[0]


def settings(pairs):
    words = []
    for key, value in pairs:
        words += ["--set", key.encode() + b"=" + value if isinstance(value, bytes) else f"{key}={value}"]
    return words


class Choices:
    """What a random run chooses: case, scheme or integrator, mesh and some keys."""

    def __init__(self, dice, catalog, cases=None, extremes=0.12):
        # The laboratory's cases take seconds before their first step, which no estimate says.
        self.case = dice.choice(cases or catalog.names("cases"))
        if self.case.startswith("stability") and dice.random() < 0.75:
            self.case = dice.choice([name for name in catalog.names("cases") if not name.startswith("stability")])
        self.parameters = {p["key"]: p for p in catalog.parameters(self.case)}
        self.words, self.pairs = [], []
        if dice.random() < 0.35:
            self.words += ["--scheme", dice.choice(catalog.schemes(self.case))]
        elif dice.random() < 0.4:
            self.words += ["--integrator", dice.choice(catalog.names("integrators"))]
        free = [key for key in self.parameters if key not in ("cells", "integrator")]
        for key in dice.sample(sorted(free), k=min(len(free), dice.choice((0, 0, 1, 1, 2, 3, 5)))):
            draw = values.extreme if dice.random() < extremes else values.usual
            self.pairs.append((key, draw(dice, self.parameters[key])))
        low, high = values.ends(self.parameters["cells"])
        self.cells = min(max(dice.randrange(2, 25), low), high) if dice.random() < 0.9 else None

    def arguments(self, command="run", cells=True):
        return (command, self.case, *(("--cells", str(self.cells)) if cells and self.cells else ()), *self.words, *settings(self.pairs))


def expected(outcome):
    """Seconds that --dry-run says."""
    return document(outcome)["estimated_s"]


def dry(call, longest):
    """A trial of the call, and what it is expected to take; None where that is not to be had, `Skipped` where it is too long."""
    outcome = yield Call((*call, "--dry-run", "--json", "-"))
    if outcome.code != 0:
        return None
    seconds = expected(outcome)
    if seconds is None or seconds > longest:
        yield Skipped(f"{seconds} s expected")
        return None
    return seconds


@kind(36)
def one_run(dice, catalog):
    """A run; some of them again, and with two threads: the same to the bit."""
    choices, again, threads = Choices(dice, catalog), dice.random() < 0.25, dice.random() < 0.35
    call = choices.arguments()
    seconds = yield from dry(call, catalog.longest)
    if seconds is None:
        yield Call((*call, "--json", "-"), statuses=(2, 3, 4), why="--dry-run refused the same choices")
        return
    frames = ("--frames", "3") if dice.random() < 0.1 else ()
    first = yield Call((*call, *frames, "--json", "-", "--results", "a"), estimate=seconds)
    for wanted, words, rule in ((again, (), "repeat"), (threads, ("--threads", "2"), "threads")):
        if not wanted or first.code not in (0, 1, 3):
            continue
        second = yield Call((*call, *frames, "--json", "-", "--results", rule, *words), estimate=seconds)
        if second.code != first.code:
            yield Fault(rule, f"exit status {first.code}, then {second.code}")
        elif where := difference(document(first), document(second)):
            yield Fault(rule, f"another document: {where}")
        else:
            yield from same_files(first, second, rule)


def same_files(first, second, rule):
    one, other = (sorted((outcome.folder / name).glob("*.h5")) for outcome, name in ((first, "a"), (second, rule)))
    if [path.name for path in one] != [path.name for path in other]:
        yield Fault(rule, "files of other names")
    for a, b in zip(one, other):
        before, after = contract.contents(a), contract.contents(b)
        if different := sorted(key for key in before.keys() | after.keys() if before.get(key) != after.get(key)):
            yield Fault(rule, f"{a.name}: {', '.join(different[:4])}")


@kind(10)
def wrong_run(dice, catalog):
    """A run with one thing wrong in it, close to what is right."""
    choices = Choices(dice, catalog, extremes=0)
    choices.cells = 4
    slip = dice.choice(("value", "value", "value", "key", "case", "option", "name", "twice", "extra", "mesh"))
    call = list(choices.arguments())
    sure = True
    if slip == "value":
        key = dice.choice(sorted(choices.parameters))
        call += settings([(key, values.wrong(dice, choices.parameters[key]))])
        sure = False
    elif slip == "key":
        key = values.misspelt(dice, dice.choice(sorted(choices.parameters)))
        call += settings([(key, "1")])
        sure = key not in choices.parameters
    elif slip == "case":
        call[1] = values.misspelt(dice, choices.case)
        sure = call[1] not in catalog.names("cases")
    elif slip == "option":
        call += [values.misspelt(dice, dice.choice(("--cells", "--scheme", "--integrator", "--set", "--threads"))), "4"]
        sure = False
    elif slip == "name":
        option, names = dice.choice((("--scheme", catalog.schemes(choices.case)), ("--integrator", catalog.names("integrators"))))
        name = values.misspelt(dice, dice.choice(names))
        call += [option, name]
        sure = name not in names
    elif slip == "twice":
        key = dice.choice(sorted(set(choices.parameters) - {"cells", "integrator"}))
        call += settings([(key, values.usual(dice, choices.parameters[key])), (key, values.usual(dice, choices.parameters[key]))])
        sure = False
    elif slip == "extra":
        call.insert(dice.randrange(len(call) + 1), dice.choice((*values.HOSTILE, *values.RAW)))
        sure = False
    else:
        call += ["--cells", dice.choice(("0", "-1", "1e3", "nan", "2.5", "99999999999999999999", "", "4,8", "ten"))]
    yield Call((*call, "--dry-run", "--json", "-"), statuses=(2,) if sure else (0, 1, 2, 3, 4), why=f"the {slip} is wrong")


@kind(6)
def study(dice, catalog):
    choices = Choices(dice, catalog, extremes=0.05)
    words = []
    low, _ = values.ends(choices.parameters["cells"])
    if dice.random() < 0.7:
        meshes = sorted({max(low, dice.randrange(2, 20)) for _ in range(dice.choice((1, 2, 3, 5)))})
        words += ["--cells", ",".join(map(str, meshes))] if dice.random() < 0.9 else [x for mesh in meshes for x in ("--cells", str(mesh))]
        choices.cells = meshes[-1]
    else:
        words += ["--cells", dice.choice(("", ",", "4,", "4,4", "0,4", "8,4", "4;8", "nan,4", "1e1,2e1", "4-8", "-4,8"))]
        choices.cells = 4
    if dice.random() < 0.3:
        words += ["--vary", dice.choice(("dt", "ppc", "offset", "cells", "h", "Cells"))]
    seconds = yield from dry(choices.arguments(), catalog.longest)
    if seconds is None:
        return
    if "--vary" in words and seconds > catalog.longest / 100:
        yield Skipped("a study of many runs")
        return
    yield Call((*choices.arguments("converge", cells=False), *words, "--json", "-"), estimate=40 * seconds)


@kind(5)
def verified(dice, catalog):
    case = dice.choice(catalog.names("cases"))
    estimate = catalog.estimate(case)
    words = ["--tier", dice.choice(("quick", "quick", "quick", "Quick"))] if dice.random() < 0.5 else []
    words += ["--integrator", dice.choice(catalog.names("integrators"))] if dice.random() < 0.3 else []
    words += ["--junit", dice.choice(("v.xml", "none/v.xml"))] if dice.random() < 0.4 else []
    words += ["--allow-inconclusive"] if dice.random() < 0.2 else []
    if estimate > catalog.longest / 4 or case.startswith("stability"):
        yield Skipped(f"{estimate} s of runs")
        return
    yield Call(("verify", case, *words, "--json", "-"), estimate=2 * estimate, floor=40)


@kind(5)
def catalogued(dice, catalog):
    command = dice.choice(("list", "explain", "explain", "reference", "help", "nothing", "command"))
    target = ("--json", dice.choice(("-", "-", "x.json", "none/x.json", "")))
    if command == "explain":
        case = dice.choice(catalog.names("cases"))
        yield Call(("explain", case if dice.random() < 0.7 else values.misspelt(dice, case), *target))
    elif command == "help":
        yield Call((dice.choice(("run", "verify", "sweep", "score")), "--help"))
    elif command == "nothing":
        yield Call((), statuses=(2,))
    elif command == "command":
        yield Call((values.misspelt(dice, dice.choice(("run", "verify", "sweep", "reference"))), "sod"), statuses=(2,))
    elif command == "list":
        yield Call(("list", *target, *(("extra",) if dice.random() < 0.2 else ())))
    else:
        yield Call(("reference", *target), statuses=(2,))


@kind(8)
def referenced(dice, catalog):
    name = dice.choice(catalog.names("references"))
    about = catalog.reference(name)
    words = []
    keys = sorted(about["settings"])
    for key in dice.sample(keys, k=min(len(keys), dice.choice((0, 1, 1, 2)))):
        default = about["settings"][key]
        wanted = default * 3 ** dice.uniform(-1, 1) if isinstance(default, float) and dice.random() < 0.5 else None
        key = key if dice.random() < 0.95 else values.misspelt(dice, key)
        words += settings([(key, values.text(wanted) if wanted is not None else dice.choice(
            ("0", "-1", "1", "2", "1.4", "1e-12", "1e12", "1e300", "5e-324", "-1e300", "3", "100", "1000000", *values.HOSTILE)))])
    if dice.random() < 0.6:
        places = [values.text(dice.choice((dice.uniform(-2, 2), dice.uniform(0, 100), 0.0, 1e300, -1e300, 5e-324))) for _ in range(dice.choice((1, 3)))]
        words += ["--at", ",".join(places)] if dice.random() < 0.9 else ["--at", dice.choice(values.HOSTILE)]
    yield Call(("reference", name, *words, "--json", "-"), floor=20)


@kind(4)
def limits(dice, catalog):
    problem = dice.choice(catalog.names("problems"))
    words = ["--no-runs"]
    if dice.random() < 0.6:
        words += ["--integrator", dice.choice(catalog.names("integrators"))]
    key, value = dice.choice((("ppc", "1"), ("ppc", "2"), ("ppc", "0"), ("N", "0.3"), ("N", "1e300"), ("N", "nan"), ("rho_b", "0.5"), ("shape", "linear"),
                              ("shape", "lineal"), ("transfer", "pic"), ("place_x", "0.01"), ("place_x", "-1"), ("ratio", "1"), ("ratio", "1e300")))
    if dice.random() < 0.7:
        words += dice.choice((["--set", f"{key}={value}"], ["--over", f"{key}={value},{value}"], ["--over", f"{key}="], ["--over", key]))
    if problem not in ("bar", "oscillator", "york", "wave"):
        words = words if "nan" in str(words) else ["--no-runs", "--set", dice.choice(("ppc=0", "shape=x", "cells=4", "ppc=-1", "integrator=musll", "x"))]
    yield Call(("stability", problem, *words, "--json", "-"), floor=60)


# --- files ------------------------------------------------------------------------------------------


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
    case = dice.choice([name for name in catalog.names("cases") if not name.startswith("stability")])
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


# --- where the output goes, signals, plug-ins -------------------------------------------------------


SMALL = (("list",), ("explain", "sod"), ("run", "sod", "--cells", "4"), ("run", "sod", "--cells", "4", "--dry-run"), ("reference", "riemann"),
         ("converge", "sod", "--cells", "4,8"), ("verify", "bar-riemann"), ("export", "sod", "--cells", "4", "--output", "s.h5"), ("sweep", "sod", "--plan", "-"),
         ("stability", "york", "--no-runs"))


@kind(10)
def targets(dice, catalog):
    """Output that has nowhere to go, or goes where something else is."""
    call = dice.choice(SMALL)
    where = dice.choice(("full", "full", "closed", "gone", "json", "json", "results", "results", "environment"))
    if where == "full":
        yield Call((*call, *dice.choice(((), ("--json", "-")))), stdout="full", statuses=(4,), why="standard output has no room", floor=40)
        return
    if where in ("closed", "gone"):
        yield Call(call, stdout=where, floor=40)
        return
    if where == "environment":
        chosen = dice.choice((("LC_ALL", "xx_XX.UTF-8"), ("LC_ALL", "C"), ("TZ", "Nowhere/At_all"), ("HOME", "/nonexistent"), ("TMPDIR", "/nonexistent"),
                              ("OMP_NUM_THREADS", "nonsense"), ("OMP_NUM_THREADS", "100000"), ("COLUMNS", "-1"), ("PATH", ""), ("NO_COLOR", "")))
        plain = yield Call((*call, "--json", "-"), floor=40)
        other = yield Call((*call, "--json", "-"), environment=(chosen,), floor=40)
        if plain.code != other.code:
            yield Fault("repeat", f"{chosen[0]}={chosen[1]}: exit status {plain.code}, then {other.code}")
        elif plain.code == 0 and call[0] != "export" and (found := difference(document(plain), document(other))):
            yield Fault("repeat", f"{chosen[0]}={chosen[1]}: {found}")
        return
    folder = yield None
    path = folder / "out"
    what = dice.choice(("folder", "dangling link", "loop", "device", "older", "below a file", "nowhere", "link", "long", "bytes", "full", "empty"))
    name = "out"
    if what == "folder":
        path.mkdir() if where == "json" else path.write_text("older\n", encoding="utf-8")
    elif what == "dangling link":
        path.symlink_to("nowhere/at-all")
    elif what == "loop":
        path.symlink_to("out")
    elif what == "device":
        path.symlink_to("/dev/null" if where == "json" else "/dev/full")
    elif what == "older" and where == "json":
        path.write_text("older\n", encoding="utf-8")
    elif what == "link":
        (folder / "elsewhere").mkdir() if where == "results" else (folder / "elsewhere").write_text("older\n", encoding="utf-8")
        path.symlink_to("elsewhere")
    elif what == "below a file":
        path.write_text("older\n", encoding="utf-8")
        name = "out/x"
    elif what in ("nowhere", "long", "bytes", "full", "empty"):
        name = {"nowhere": "/nonexistent/x", "long": "x" * 300, "bytes": b"\xff\xfe", "full": "/dev/full", "empty": ""}[what]
    if where == "results" and call[0] not in ("run", "converge", "verify"):
        call = ("run", "sod", "--cells", "4")
    outcome = yield Call((*call, "--json" if where == "json" else "--results", name), floor=40, why=what)
    older = folder / "out"
    if outcome.code != 0 and what in ("folder", "older", "below a file") and older.is_file() and older.read_text(encoding="utf-8") != "older\n":
        yield Fault("leftover", "the older file is not what it was")
    if outcome.code == 0 and "--dry-run" not in call and (where, what) in (("json", "folder"), ("results", "folder"), ("json", "nowhere"), ("json", "full")):
        yield Fault("lost output", f"--{where} {what}: exit status 0")


LONG = (("verify", "sod", "mms-bar"), ("converge", "sod", "--cells", "200,400,800"), ("run", "sod", "--cells", "2000"), ("sweep", "sod", "--jobs", "2"),
        ("stability", "plane"), ("bench", "--points", "20000"), ("export", "sod-3d", "--cells", "40", "--output", "s.h5"), ("run", "woodward-colella", "--cells", "4"),
        ("run", "shu-osher", "--cells", "2"), ("run", "stability-membrane"), ("verify", "--integrator", "leapfrog", "--core"), ("run", "pendulum", "--cells", "24"))


@kind(3)
def interrupted(dice, catalog):
    """A signal at any moment: ended within a second, nothing half-written."""
    call, after = dice.choice(LONG), dice.uniform(0.02, 1.5)
    number = dice.choice((signal.SIGINT, signal.SIGTERM))
    yield Call(call, interrupted=(number, after), floor=60)


PLUGIN_CALLS = (("run", "sod", "--cells", "4"), ("run", "bar-riemann", "--cells", "4"), ("verify", "sod"), ("stability", "oscillator", "--no-runs"), ("list",),
                ("converge", "sod", "--cells", "4,8"), ("sweep", "sod", "--plan", "-"))


@kind(4)
def plugged(dice, catalog):
    """Plug-ins, built hostile or broken as files; without a folder of built ones only the latter."""
    folder = yield None
    call = dice.choice(PLUGIN_CALLS)
    if catalog.plugins and dice.random() < 0.8:
        library = str(dice.choice(catalog.plugins))
        listed = yield Call(("list", "--plugin", library, "--json", "-"), floor=30)
        if listed.code != 0:
            return
        names = sorted({entry["name"] for entry in document(listed)["integrators"]} - set(catalog.names("integrators")))
        name = dice.choice(names) if names else "musl"
        if name == "hostile":
            yield from misbehaving(dice, library)
            return
        words = ("--integrator", name) if call[0] not in ("list", "sweep") else ()
        yield Call((*call, *words, "--plugin", library, "--json", "-"), floor=90)
        return
    path = folder / "mine.so"
    path.write_bytes(dice.choice((b"", b"\x7fELF", b"\x7fELF" + bytes(200), dice.randbytes(5000), b"INPUT(-lc)\n", b"#!/bin/sh\n")))
    if dice.random() < 0.4:
        files.instead(dice, path)
        if path.is_fifo():
            return
    yield Call((*call, "--plugin", dice.choice(("mine.so", "./mine.so", "mine", "", "/nonexistent.so")), "--json", "-"), statuses=(2, 4))


# What tests/contract/hostile/hostile.cpp does when it is asked to.
MISDEEDS = {
    "HOSTILE_LOAD": ("throw", "throw-int", "exit", "_exit", "abort", "terminate", "crash", "loop", "nothing", "twice", "no-copy", "bad-text", "at-exit"),
    "HOSTILE_NAME": ("", "musl", "bad name", "../x", "x" * 64, "\u00e4"),
    "HOSTILE_MAKE": ("null", "throw", "null-copy", "throw-parameters", "null-parameter", "parameter-out-of-range", "null-memory", "exit-claims"),
    "HOSTILE_STEP": ("throw", "throw-int", "throw-odd", "throw-silent", "throw-noexcept", "exit", "quick-exit", "thread-exit", "_exit", "abort", "terminate",
                     "crash", "overflow", "kill", "loop", "sleep", "any-order", "never-located", "nan", "short-state", "long-state", "long-rate"),
}
HARMLESS = {"any-order", "long-rate", "at-exit", "exit-claims"}   # may end well


def misbehaving(dice, library):
    """The plug-in of the contract tests, told by the environment what to do."""
    variable = dice.choice(sorted(MISDEEDS))
    misdeed = dice.choice(MISDEEDS[variable])
    environment = ((variable, misdeed), ("HOSTILE_AT", str(dice.choice((1, 1, 2, 7)))), ("HOSTILE_SEED", str(dice.randrange(1000))))
    call = dice.choice(PLUGIN_CALLS)
    runs = call[0] in ("run", "converge", "verify", "stability")
    words = (("--integrator", "hostile"),) if call[0] not in ("list", "sweep") else ()
    sure = call[0] in ("run", "converge") and misdeed not in HARMLESS
    yield Call((*call, *(word for pair in words for word in pair), "--plugin", library, *(("--step-limit", "1") if runs else ()), "--json", "-"),
               environment=environment, floor=60, statuses=(1, 2, 3, 4) if sure else (0, 1, 2, 3, 4), why=f"{variable}={misdeed}")
