"""The command that makes a number of the page again, from what the result file itself states.

A command names case, scheme, cells and the choices in which the run differs from its scheme; what a file of an earlier version does
not state leaves no command rather than one that runs another problem. Commands are told as they are typed, "plumbline" first.
"""

import shlex

PROGRAM = "plumbline"
FOREIGN = "foreign:"  # what the scheme of another program's result begins with
SCORED_BY = "scored_by"  # of such a result, its levels and gates: the command that judged it


def is_foreign(part):
    """Whether another program computed a run, a level or what a gate judges."""
    return (part.get("scheme") or "").startswith(FOREIGN)


def run(level):
    """One run, of a file or of a level of a study; "" where it does not state its choices."""
    if is_foreign(level):
        return level.get(SCORED_BY, "")
    if not level.get("case") or level.get("choices") is None:
        return ""
    return _command("run", level["case"], _cells(level), *_choices(level["scheme"], level["choices"]))


def study(entry, case):
    """The levels of a line of the figures, with the orders fitted to them; a single run where nothing is refined."""
    if entry.levels and is_foreign(entry.levels[0]):
        return entry.levels[0].get(SCORED_BY, "")
    if len(entry.levels) < 2 or "trial" in entry.settings:
        return gates(case, f"{entry.study}/*") if "trial" in entry.settings and entry.study else run(entry.levels[-1]) if entry.levels else ""
    if entry.choices is None or not entry.vary:
        return ""
    values = ",".join(_plain(level.get("value")) for level in entry.levels)
    refined = ["--cells", values] if entry.vary == "cells" else ["--vary", entry.vary, "--values", values, *_cells(entry.levels[0])]
    return _command("converge", case, refined, *_choices(entry.scheme, entry.choices))


def gate(judged):
    """The gate alone, with the runs that it needs; one of an integrator or a part with all of its kind."""
    if is_foreign(judged):
        return judged.get(SCORED_BY, "")
    case, scheme, name = judged.get("case"), judged.get("scheme"), judged.get("id")
    if case == "integrator":
        return _command("verify", "", ["--integrator", scheme, "--core"])
    if not case or not name:
        return ""
    return gates(case, name, judged.get("tier"))


def gates(case, pattern, tier=""):
    return _command("verify", case, ["--gate", pattern, *(["--tier", tier] if tier == "full" else [])])


def pictures(level, frames):
    """A run with the snapshots that its pictures are drawn from."""
    command = run(level)
    return f"{command} --frames {frames}" if command else ""


def scorecard(card):
    return _command("verify", "", ["--integrator", card["integrator"], *(["--core"] if card.get("effort") == "core" else [])])


def limit(integrator, problem):
    """The predicted limit of an integrator on a problem of the laboratory."""
    return _command("stability", problem, ["--integrator", integrator, "--no-runs"])


def growth(problem, document):
    """The configurations of one problem, as the document has them: with runs where it has some."""
    return _command("stability", problem, ["--no-runs"] if "--no-runs" in stated(document) else [])


def maps(problem, document):
    words = shlex.split(stated(document))
    tier = words[words.index("--tier") + 1 :][:1] if "--tier" in words else []
    return _command("stability", problem, ["--maps", "--no-runs", *(["--tier", *tier] if tier else [])])


def stated(document):
    """The command that a document says it was written by; of times, all else is the same again."""
    return (document.get("provenance") or {}).get("command") or ""


def description(case):
    """What a case says of itself, its sketch among it."""
    return _command("explain", case, ["--json", "-"])


def exported(problem, start, cells):
    """A start of a scoreboard's problem, in the folder of the scoreboard."""
    return _command("export", problem["case"], ["--cells", _plain(cells)], _typed(problem), ["--output", f"cases/{start}"])


def beside(problem):
    """The default scheme from the starts of a scoreboard's problem."""
    cells = [_plain(level["cells"]) for level in problem["own"]["levels"]]
    return _command("converge" if len(cells) > 1 else "run", problem["case"], ["--cells", ",".join(cells)], _typed(problem))


def scored(problem, program):
    """The verdict on what a program has of a scoreboard's problem, in the folder of the scoreboard; "" where there is none."""
    starts = [entry["start"] for entry in program["entries"] if entry["outcome"] == "scored"]
    if not starts:
        return ""
    results = [word for start in starts for word in ("--result", f"programs/{program['name']}/{start}")]
    return _command("score", problem["case"], results, _typed(problem))


def _typed(problem):
    return [word for setting in problem["settings"] for word in ("--set", setting)]


def costs(case):
    """Errors are the same again; times are those of the machine."""
    return _command("bench", "", ["--cases", case])


def _command(name, case, *parts):
    words = [PROGRAM, name, *([case] if case else []), *(word for part in parts for word in part)]
    return shlex.join(str(word) for word in words)


def _cells(level):
    cells = (level.get("settings") or {}).get("cells")
    return ["--cells", _plain(cells)] if cells is not None else []


def _choices(scheme, choices):
    """--scheme and --set; an integrator that the scheme's name carries is among the choices."""
    base = scheme.split("+")[0]
    named = [] if base == "default" else ["--scheme", base]
    return named, [word for key, value in sorted(choices.items()) if key != "cells" for word in ("--set", f"{key}={_plain(value)}")]


def _plain(value):
    """A number with all its digits, as --set and --cells read it."""
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e15:
        return str(int(value))
    return repr(value) if isinstance(value, float) else "none" if value is None else str(value)
