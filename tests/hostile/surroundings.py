"""Where the output goes, signals at any moment, and plug-ins."""
import signal

import files
from kinds import kind
from outcome import Fault, difference, document
from sandbox import Call


SMALL = (("list",), ("explain", "sod"), ("run", "sod", "--cells", "4"), ("run", "sod", "--cells", "4", "--dry-run"), ("reference", "riemann"),
         ("converge", "sod", "--cells", "4,8"), ("verify", "bar-riemann"), ("export", "sod", "--cells", "4", "--output", "s.h5"), ("sweep", "sod", "--plan", "-"),
         ("stability", "york", "--no-runs"))


@kind(10)
def targets(dice, catalog):
    """Output that has nowhere to go, or goes where something else is."""
    call = dice.choice(SMALL)
    where = dice.choice(("full", "full", "closed", "gone", "json", "json", "results", "results", "environment"))
    if where == "full":
        yield Call((*call, *dice.choice(((), ("--json", "-")))), stdout="full", statuses=(4,), why="standard output has no space", floor=40)
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
        name = {"nowhere": "/dev/null/x", "long": "x" * 300, "bytes": b"\xff\xfe", "full": "/dev/full", "empty": ""}[what]
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
