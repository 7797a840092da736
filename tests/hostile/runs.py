"""Random runs, studies and questions: what is chosen from the names and ranges that the program states."""
import contract
import values
from kinds import Skipped, kind, settings
from outcome import Fault, difference, document
from sandbox import Call


class Choices:
    """What a random run chooses: case, scheme or integrator, mesh and some keys."""

    def __init__(self, dice, catalog, extremes=0.12):
        self.case = dice.choice(catalog.runs)
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


@kind(4)
def trial(dice, catalog):
    """A trial, which takes no choice of a run but a scheme, of which it makes nothing."""
    case = dice.choice([name for name in catalog.names("cases") if name not in catalog.runs])
    right = (), ("--scheme", "york1997"), ("--threads", "2")
    wrong = ("--cells", "8"), ("--integrator", "musl"), ("--set", "shape=linear"), ("--set", "trial=none"), ("--frames", "3"), ("--checkpoint", "c.h5")
    words = dice.choice(right + wrong)
    yield Call(("run", case, *words, "--dry-run", "--json", "-"), statuses=(0,) if words in right else (2,), why=" ".join(words))


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
    if estimate > catalog.longest / 4 or case not in catalog.runs:
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
