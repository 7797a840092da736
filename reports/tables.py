"""Rows of the tables on the page, ready to print, and the same tables as CSV."""

import itertools
import pathlib
from collections import Counter

import figures
import reproduce
from plumbline import reader
import speed
import stability
import text
from cases import GREEN, URGENCY, VERDICTS, error_of, most_urgent_first

ORIGINS = {
    "theory": "theory",
    "literature": "literature",
    "reference_bound": "accuracy of the reference",
    "identity": "identity",
    "requirement": "requirement: what users of such a code expect",
    "regression": "regression: a run of Plumbline itself",
}
MEANINGS = {
    "PASS": "the measured value meets the gate",
    "FAIL": "the gate is missed",
    "INCONCLUSIVE": "the interval of the measurement straddles the bound; not green",
    "XFAIL": "expected failure: the known wrong value was found inside its band",
    "XPASS": "an expected failure that no longer fails; red until acknowledged",
    "INVALID": "no judgement possible: missing data, or a reference not good enough",
    "NONE": "reported, not judged",
}
RECORDED = "/regression"  # ends the id of a gate on a recorded value
FAILURES_OF = {
    "default": "of the default scheme",
    "other": "of other schemes",
    "york1997": "York's own: his scheme, or figures that he published",
}
_MACHINE = ("version", "git", "dirty", "compiler", "flags", "cpu", "instruction_set", "libraries")
_MACHINE_NAMES = {
    "version": "Plumbline",
    "git": "commit",
    "compiler": "compiler",
    "flags": "compiler flags",
    "cpu": "processor",
    "instruction_set": "instruction set",
    "libraries": "libraries",
}
_HAPPENED = {
    "FAIL": ("is missed", "are missed"),
    "INVALID": ("cannot be judged", "cannot be judged"),
    "INCONCLUSIVE": ("is undecided", "are undecided"),
    "XPASS": ("passes where a failure was expected", "pass where failures were expected"),
}
_FIRST_FIELDS = ("integrator", "shape", "transfer", "density", "points", "ppc", "cfl", "dt")


# --- gates ----------------------------------------------------------------------------------------


def gate_row(gate):
    bounds = gate.get("expected")
    margin = gate.get("margin")
    return {
        "verdict": gate.get("verdict") or "INVALID",
        "id": gate.get("id") or text.MISSING,
        "case": gate.get("case") or "",
        "scheme": gate.get("scheme") or text.MISSING,
        "quantity": gate.get("quantity") or gate.get("id") or text.MISSING,
        "expected": text.expected(bounds),
        "origin": ORIGINS.get(gate.get("origin"), gate.get("origin") or text.MISSING),
        "reason": gate.get("reason") or "",
        "measured": text.measured(gate.get("measured"), bounds),
        "interval": text.interval(gate.get("interval")),
        "margin": text.number(margin, 2),
        "cause": gate.get("cause") or "",
        "share": None if margin is None else round(100 * min(abs(margin), 1)),
        "beyond": margin is not None and margin < 0,
        "tier": gate.get("tier") or "",
        "note": gate.get("note") or "",
        "band": text.expected(gate["band"]) if gate.get("band") else "",
        "recorded": gate.get("recorded") or "",
        "file": gate.get("file") or "",
        "gate_anchor": gate.get("anchor") or "",
        "command": reproduce.gate(gate),
    }


def is_recorded(gate):
    """Whether the gate judges a recorded value: it stands beside the gate whose name it has."""
    return (gate.get("id") or "").endswith(RECORDED)


def fold_recorded(gates):
    """The gates without those on recorded values that hold: their range is shown beside the gate's own bound."""
    gates = list(gates)
    beside = {
        (gate.get("study"), gate["id"].removesuffix(RECORDED)): text.expected(gate.get("expected"))
        for gate in gates
        if is_recorded(gate) and gate.get("verdict") == "PASS"
    }
    return [
        {**gate, "recorded": beside.get((gate.get("study"), gate.get("id")), "")}
        for gate in gates
        if not (is_recorded(gate) and gate.get("verdict") == "PASS")
    ]


def split_identities(gates):
    """(rows to show, rows to fold away): identities that hold for every scheme are many and rarely news."""
    gates = fold_recorded(gates)
    folded = [gate for gate in gates if gate.get("verdict") == "PASS" and gate.get("origin") == "identity"]
    return gate_rows(gate for gate in gates if gate not in folded), gate_rows(folded)


def gate_rows(gates):
    return [gate_row(gate) for gate in most_urgent_first(gates)]


def missed(cases):
    return gate_rows(
        gate for case in cases.values() for gate in case.all_gates if gate.get("verdict") not in GREEN
    )


def expected_failures(cases):
    """The gates that fail as expected, a list for each owner that has any: the default scheme's first."""
    gates = [gate for case in cases.values() for gate in case.all_gates if gate.get("verdict") == "XFAIL"]
    lists = (
        {
            "owner": owner,
            "title": title,
            "rows": gate_rows(gate for gate in gates if _failure_of(gate) == owner),
        }
        for owner, title in FAILURES_OF.items()
    )
    return [one for one in lists if one["rows"]]


def _failure_of(gate):
    """Whose failure it is; by the scheme's name alone in files that do not say it."""
    stated = gate.get("failure_of") or gate.get("scheme")
    return stated if stated in FAILURES_OF else "other"


def strips(folder, cases):
    """One strip per verdict file, newest first; one more for gates that stand only in studies and runs."""
    newest_first = sorted(
        folder.verdicts, key=lambda entry: (entry.provenance.get("started") or "", entry.name), reverse=True
    )
    found = [
        _strip(
            f"verify, {result.verdicts.get('tier') or 'unnamed'} tier",
            result.verdicts.get("counts") or {},
            result.verdicts.get("executed"),
            result.verdicts.get("declared"),
            result.name,
        )
        for result in newest_first
    ]
    others = Counter(gate.get("verdict") for case in cases.values() for gate in case.other_gates)
    if others:
        found.append(_strip("judged in single studies and runs", others, sum(others.values()), None, ""))
    return found


def _strip(label, counts, executed, declared, file):
    names = list(VERDICTS) + sorted(str(name) for name in counts if name not in VERDICTS)
    tiles = [
        {"verdict": name, "count": counts.get(name) or 0, "meaning": MEANINGS.get(name, "")} for name in names
    ]
    incomplete = executed is not None and declared is not None and executed != declared
    return {
        "label": label,
        "tiles": tiles,
        "executed": executed,
        "declared": declared,
        "incomplete": incomplete,
        "file": file,
        "total": sum(tile["count"] for tile in tiles),
    }


def counts_row(case):
    return [{"verdict": name, "count": case.counts[name]} for name in URGENCY if case.counts[name]]


def not_run(case):
    """Gates that the catalog declares and no file judged."""
    judged = {(gate.get("scheme"), gate.get("id")) for gate in case.all_gates}
    return [
        gate_row(gate)
        for gate in case.catalog.get("gates") or []
        if (gate.get("scheme"), gate.get("id")) not in judged
    ]


def one_line_reason(case):
    """Why the case shows the verdict it shows, in one sentence made of what the files state."""
    if not case.all_gates:
        return "No gate was judged for this case; what follows is reported only."
    first = most_urgent_first(case.all_gates)[0]
    row, same = gate_row(first), case.counts[first.get("verdict")]
    if case.verdict not in GREEN:
        happened = _HAPPENED.get(case.verdict, (case.verdict,) * 2)[same != 1]
        head = f"{text.plural(same, 'gate')} of {text.count(len(case.all_gates))} {happened}"
        first = f"{'It is' if same == 1 else 'First'}: {row['quantity']} ({row['scheme']})"
        found = f"{row['measured']} {row['interval']}".strip()
        return f"{head}. {first}, measured {found}, expected {row['expected']}."
    words = [
        f"{text.plural(case.counts['PASS'], 'gate passes', 'gates pass')}" if case.counts["PASS"] else "",
        f"{text.plural(case.counts['XFAIL'], 'known failure is', 'known failures are')} found as expected"
        if case.counts["XFAIL"]
        else "",
        f"{text.plural(case.counts['NONE'], 'result is', 'results are')} reported without judgement"
        if case.counts["NONE"]
        else "",
    ]
    sentence = text.listing(word for word in words if word)
    return sentence[0].upper() + sentence[1:] + "."


# --- cases ----------------------------------------------------------------------------------------


def case_row(case):
    judged = sorted(
        {
            gate.get("scheme")
            for gate in case.all_gates
            if gate.get("scheme") and gate.get("verdict") != "NONE"
        }
    )
    return {
        "name": case.name,
        "title": case.catalog.get("title") or case.name,
        "claim": case.catalog.get("claim") or "",
        "schemes": text.listing(judged) if judged else text.MISSING,
        "verdict": case.verdict,
        "counts": counts_row(case),
        "order": default_order(case),
        "measure": case.measure,
    }


def default_order(case):
    """The order that the study `default` shows in the measure that stands for the case, if it is asymptotic; else why there is none."""
    entry = next((entry for entry in case.studies("cells") if entry.study == "default"), None)
    fit = (entry.measures.get(case.measure) or {}) if entry else {}
    if fit.get("order") is None:
        return None
    if not fit.get("asymptotic"):
        return {"order": "not asymptotic", "measure": case.measure, "label": fit.get("reason") or "levels do not settle on one order"}
    return {"order": text.order(fit), "measure": case.measure, "label": entry.label}


def study_rows(case):
    return [
        {
            "style": entry.style,
            "label": entry.label,
            "scheme": entry.scheme,
            "vary": (_varied(entry) if _has_cells(entry) else "") or "single runs",
            "why": entry.why,
            "title": entry.title if entry.title != entry.label else "",
            "levels": list(
                dict.fromkeys(
                    text.exact(level.get("value") if entry.vary else (level.get("settings") or {}).get("cells"))
                    for level in entry.levels
                    if _has_cells(entry)
                )
            )
            or [text.MISSING],
            "command": reproduce.study(entry, case.name),
            "points": _range(entry, "points"),
            "steps": _range(entry, "steps"),
            "file": entry.files[0] if len(entry.files) == 1 else f"{len(entry.files)} files",
        }
        for entry in case.series
    ]


def _varied(entry):
    return figures.VARIED.get(entry.vary, entry.vary)


def _has_cells(entry):
    """Whether the levels are meshes; a trial, which has none, is told as a study of one level."""
    return entry.vary != "cells" or any("cells" in (level.get("settings") or {}) for level in entry.levels)


def _range(entry, key):
    values = [level.get(key) for level in entry.levels if level.get(key)]
    if not values:
        return text.MISSING
    low, high = min(values), max(values)
    return text.count(low) if low == high else f"{text.count(low)} … {text.count(high)}"


def settings_matrix(case):
    """Settings in which the lines of the figures differ, by row, the lines by column; and those that all share."""
    columns = {}
    for entry in case.series:
        if entry.vary in ("cells", ""):
            columns.setdefault(entry.label, (entry.style, entry.settings))
    keys = {key for _, settings in columns.values() for key in settings}
    ordered = [key for key in _FIRST_FIELDS if key in keys] + sorted(keys - set(_FIRST_FIELDS))
    rows = []
    for key in ordered:
        values = [
            text.exact(settings[key]) if key in settings else text.MISSING for _, settings in columns.values()
        ]
        rows.append({"key": key, "values": values, "differs": len(set(values)) > 1})
    return {
        "columns": [{"label": label, "style": style} for label, (style, _) in columns.items()],
        "rows": [row for row in rows if row["differs"]],
        "shared": [f"{row['key']}={row['values'][0]}" for row in rows if not row["differs"]],
    }


def parameter_rows(case):
    """(the case's own parameters, the numerical choices)."""
    rows = _parameter_rows(case)
    return [row for row in rows if not row["numerical"]], [row for row in rows if row["numerical"]]


def schemes(listed):
    """What the schemes are for each kind of scene: {"schemes", "kinds", "rows"}; None where no program listed them."""
    found = listed.get("schemes")
    if not found:
        return None
    kinds = list(dict.fromkeys(kind for scheme in found for kind in scheme["kinds"]))
    keys = dict.fromkeys(key for scheme in found for values in scheme["kinds"].values() for key in values)

    def cell(kind, key):
        values = [scheme["kinds"].get(kind, {}) for scheme in found]
        if not any(key in own for own in values):
            return ""
        words = ["none" if own.get(key) is None else text.exact(own[key]) for own in values]
        return words[0] if len(set(words)) == 1 else " / ".join(words)

    return {"schemes": found, "kinds": kinds, "rows": [{"key": key, "cells": [cell(kind, key) for kind in kinds]} for key in keys]}


def choices(cases):
    """The numerical choices that any case has, each once: meaning, unit and range are the same everywhere."""
    found = {}
    for case in cases.values():
        for row in parameter_rows(case)[1]:
            found.setdefault(row["key"], {**row, "changed": False})
    return [found[key] for key in sorted(found)]


def _parameter_rows(case):
    return [
        {
            "key": entry.get("key"),
            "numerical": bool(entry.get("numerical")),
            "value": text.exact(entry.get("value")),
            "default": text.exact(entry.get("default")),
            "unit": "" if isinstance(entry.get("value"), str) else text.unit(entry.get("unit") or ""),
            "range": _parameter_range(entry),
            "description": entry.get("description") or "",
            "changed": entry.get("value") != entry.get("default") and entry.get("default") is not None,
        }
        for entry in case.catalog.get("parameters") or []
    ]


def _parameter_range(entry):
    low, high = entry.get("low"), entry.get("high")
    if low is None and high is None:
        return text.exact(entry.get("allowed") or None)
    return f"{'−∞' if low is None else text.exact(low)} … {'∞' if high is None else text.exact(high)}"


def fit_rows(case, leading):
    """Fits of every study: rows of the leading measures; of all others those of the first line of each scheme, and how many
    more there are; {reason: measures} of those without an order."""
    rows = _fit_rows(case)
    others = [row for row in rows if row["measure"] not in leading]
    fitted = [row for row in others if row["order"] != text.MISSING]
    first = {}
    for row in fitted:
        first.setdefault(row["scheme"], row["label"])
    shown = [row for row in fitted if row["label"] == first[row["scheme"]]]
    without = {}
    for row in others:
        if row["order"] == text.MISSING:
            without.setdefault(row["reason"] or "no reason stated", {})[row["measure"]] = None
    return {
        "fits": [row for row in rows if row["measure"] in leading],
        "further_fits": shown,
        "other_fits": len(fitted) - len(shown),
        "without_order": {reason: list(names) for reason, names in without.items()},
    }


def _fit_rows(case):
    return [
        {
            "style": entry.style,
            "label": entry.label,
            "scheme": entry.scheme,
            "vary": _varied(entry),
            "measure": name,
            "order": text.order(fit),
            "theory": _theory(case, name) if entry.vary == "cells" else text.MISSING,
            "constant": text.number(fit.get("constant")),
            "asymptotic": {True: "yes", False: "no"}.get(fit.get("asymptotic"), text.MISSING),
            "reason": fit.get("reason") or "",
            "leave_one_out": _spread(fit.get("leave_one_out")),
        }
        for entry in case.series
        if entry.refined
        for name, fit in entry.measures.items()
        if isinstance(fit, dict)
    ]


def _theory(case, measure):
    return text.number(((case.catalog.get("theory_order") or {}).get(measure) or {}).get("order"))


def _spread(values):
    values = [value for value in values or [] if value is not None]
    return f"[{text.fixed(min(values))}, {text.fixed(max(values))}]" if values else text.MISSING


def by_reason(rows):
    """Rows in groups that share verdict and reason, in the order in which each group begins."""
    groups = {}
    for row in rows:
        key = tuple(row[name] for name in ("verdict", "cause", "note", "origin", "reason"))
        groups.setdefault(key, []).append(row)
    return list(groups.values())


def identity_matrix(rows):
    """{columns: what must hold, rows: lines with a gate, or None, for each}."""
    columns, lines = {}, {}
    for row in rows:
        line, _, name = row["id"].rpartition("/")
        key = name, row["expected"], row["reason"]
        columns.setdefault(key, {"name": name, "expected": row["expected"], "reason": row["reason"]})
        label = line if row["scheme"] in line else f"{row['scheme']} {line}".strip()
        lines.setdefault(label, {})[key] = row
    return {
        "columns": list(columns.values()),
        "rows": [{"label": label, "cells": [gates.get(key) for key in columns]} for label, gates in lines.items()],
    }


def by_label(rows):
    """Rows in groups of equal label, in their order."""
    return [list(group) for _, group in itertools.groupby(rows, key=lambda row: row["label"])]


def level_rows(case, measure):
    """Every level of every study and run: size, work, time and error."""
    return [
        {
            "style": entry.style,
            "label": entry.label,
            "vary": _varied(entry) or "single run",
            "value": text.exact(level.get("value")),
            "cells": text.exact((level.get("settings") or {}).get("cells")),
            "points": text.count(level.get("points")),
            "steps": text.count(level.get("steps")),
            "wall": text.seconds(level.get("wall_s")),
            "speed": text.number(level.get("particle_steps_per_s")),
            "error": text.number(_error(level, measure)),
            "relative": text.number(_error(level, measure, "relative_error"), 3),
            "file": (level.get("file") or "").rpartition("-")[2],
        }
        for entry in case.series
        for level in entry.levels
    ]


def _error(level, measure, key="error"):
    return error_of((level.get("measures") or {}).get(measure), key)


def scalar_rows(case):
    """Measures with a value of their own (a period, an amplitude), from the finest level of each line."""
    rows = []
    for entry in case.series:
        if entry.vary not in ("cells", "") or not entry.levels:
            continue
        for name, values in (entry.levels[-1].get("measures") or {}).items():
            if isinstance(values, dict) and values.get("value") is not None:
                rows.append(
                    {
                        "style": entry.style,
                        "label": entry.label,
                        "cells": _cells(entry.levels[-1]),
                        "measure": name,
                        "value": text.number(values["value"], 6),
                        "reference": "no reference" if values.get("reference") is None else text.number(values["reference"], 6),
                        "unit": "" if values.get("unit") in (None, "1") else text.unit(values["unit"]),
                        "relative": text.number(error_of(values, "relative_error")),
                        "bound": text.number(None if values.get("reference") is None else values.get("reference_bound"), 2),
                    }
                )
    return rows


def _cells(level):
    settings = level.get("settings") or {}
    return text.exact(settings.get("cells")) if "cells" in settings else ""


def reference_budget(case):
    """Per measure that is judged: the largest reference bound, and the smallest error it is compared with."""
    found = {}
    for entry in case.series:
        for level in entry.levels:
            for name, values in (level.get("measures") or {}).items():
                if (
                    isinstance(values, dict)
                    and values.get("reference_bound") is not None
                    and error_of(values)
                ):
                    bound, error = found.get(name, (0.0, float("inf")))
                    found[name] = max(bound, values["reference_bound"]), min(error, values["error"])
    judged = [name for name in found if case.gates_about(name)] or list(found)
    return [
        {
            "measure": name,
            "bound": text.number(bound, 2),
            "error": text.number(error),
            "share": text.number(bound / error, 2),
        }
        for name, (bound, error) in found.items()
        if name in judged
    ]


def ledger_rows(finest):
    """Budgets of the finest run of each line: [(series, result)]."""
    return [
        {
            "style": entry.style,
            "label": entry.label,
            "cells": _cells(result.run),
            "quantity": quantity.replace("_", " "),
            "initial": text.number(book.get("initial"), 6),
            "final": text.number(book.get("final"), 6),
            "drift": text.number(book.get("relative_drift"), 2),
            "flows": _amounts(book.get("flows")),
            "stores": _amounts(book.get("stores")),
        }
        for entry, result in finest
        for quantity, book in (result.run.get("ledger") or {}).items()
        if isinstance(book, dict) and quantity in result.ledger
    ]


def _amounts(amounts):
    return [
        {"name": name.replace("_", " "), "amount": text.number(amount)}
        for name, amount in (amounts or {}).items()
        if amount != 0
    ]


def stopped(case):
    """Runs that did not reach their end."""
    known = {}
    for run in [level for entry in case.series for level in entry.levels] + case.runs:
        if run.get("finished") is False:
            known[run.get("file") or len(known)] = run
    return [
        {
            "scheme": run.get("scheme"),
            "cells": _cells(run),
            "file": run.get("file") or "",
            **_stop_words(run.get("stop") or {}),
        }
        for run in known.values()
    ]


def _stop_words(stop):
    return {
        "reason": stop.get("reason") or "not stated",
        "step": text.count(stop.get("step")),
        "time": text.number(stop.get("time")),
        "point": text.count(stop.get("point")),
        "field": stop.get("field") or text.MISSING,
        "value": text.number(stop.get("value")),
    }


# --- provenance -----------------------------------------------------------------------------------


def origin(folder):
    """What the first screen says of where the results come from: those of the verdicts that were started last, else of any file;
    None where no file says it. `wall`: what all runs of the folder took together."""
    files = folder.verdicts or folder.studies or folder.runs
    stated = [result.provenance for result in files if result.provenance.get("git")]
    if not stated:
        return None
    last = max(stated, key=lambda one: one.get("started") or "")
    walls = [result.run.get("wall_s") for result in folder.runs]
    return {
        "commit": last["git"][:7],
        "dirty": bool(last.get("dirty")),
        "date": (last.get("started") or "")[:10],
        "machine": last.get("cpu") or "",
        "compiler": last.get("compiler") or "",
        "threads": last.get("threads"),
        "wall": text.seconds(sum(wall for wall in walls if wall)) if any(walls) else "",
        "others": len({(one["git"], one.get("cpu")) for one in stated}) - 1,
    }


def provenance(folder):
    """[(files, rows)]: one entry per distinct build and machine, the one with most files first."""
    groups = {}
    for result in folder.verdicts + folder.studies + folder.runs:
        rows = provenance_rows(result.provenance)
        groups.setdefault(tuple(rows), []).append(result.name)
    return sorted(
        ((names, list(rows)) for rows, names in groups.items()), key=lambda group: (-len(group[0]), group[0])
    )


def provenance_rows(stated):
    rows = []
    for key in _MACHINE:
        if key == "dirty" or not stated.get(key):
            continue
        value = text.exact(stated[key])
        if key == "git":
            value += " — with uncommitted changes" if stated.get("dirty") else " — clean"
        rows.append((_MACHINE_NAMES[key], value))
    return rows


def commands(folder):
    """Distinct command lines, with threads, start, and how many runs they made and in what time: those of verdicts first."""
    found = {}
    for result in folder.verdicts + folder.studies + folder.runs:
        stated = result.provenance
        if stated.get("command"):
            own = found.setdefault(stated["command"], {"threads": stated.get("threads"), "started": stated.get("started"), "walls": []})
            own["walls"] += [result.run["wall_s"]] if result.run.get("wall_s") else []
    return [
        {"command": command, "threads": own["threads"], "started": own["started"], "runs": text.count(len(own["walls"])),
         "took": text.seconds(sum(own["walls"])) if own["walls"] else ""}
        for command, own in found.items()
    ]  # fmt: skip


# --- CSV ------------------------------------------------------------------------------------------


def write_folder(folder, cases, target):
    """Every table of every file, of speed and stability, and over all files, as CSV; returns how many were written."""
    target = pathlib.Path(target)
    target.mkdir(parents=True, exist_ok=True)
    gates = [reader.gate_row(gate) for case in cases.values() for gate in case.all_gates]
    summary = [
        [case.name, case.catalog.get("title"), case.verdict, *(case.counts[name] for name in VERDICTS)]
        for case in cases.values()
    ]
    reader.write_csv(reader.GATE_COLUMNS, gates, target / "gates.csv")
    reader.write_csv(["case", "title", "verdict", *VERDICTS], summary, target / "cases.csv")
    reader.write_csv(["file", "reason"], folder.damaged, target / "damaged.csv")
    written = 3
    if folder.bench:
        reader.write_csv(speed.CSV_COLUMNS, speed.csv_rows(folder.bench), target / "bench.csv")
        written += 1
    if folder.stability:
        for name, (columns, rows) in stability.csv_tables(folder.stability).items():
            reader.write_csv(columns, rows, target / f"{name}.csv")
            written += 1
    for result in folder.runs + folder.studies + folder.verdicts:
        for name in result.table_names():
            result.to_csv(name, target / f"{result.name.removesuffix('.h5')}.{name}.csv")
            written += 1
    return written
