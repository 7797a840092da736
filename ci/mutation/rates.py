"""What a draw says: rates of kills with their intervals, and the document that holds them.

A rate is that of the bugs drawn: one that was not judged, or not to its end, counts as not killed. Equivalent bugs are out of
it; each is argued, and every case that meets it must come to the same numbers, bit for bit.
"""

from scipy.stats import beta

from .matrix import DRIFT
from .sites import FOLDERS, folder_of

LEVEL = 0.95
RATES = {"by_cases": "in_cases", "by_gates": "in_gates", "by_everything": "in_all"}  # by gates of cases; of parts, too; and by tests


def interval(killed, of):
    """Clopper and Pearson's, which holds for any rate: the tails of the binomial law by the quantiles of beta laws.

    `of` need not be a whole number: Korn and Graubard (1998) put in the effective size of a sample with unequal shares.
    """
    tail = (1 - LEVEL) / 2
    low = beta.ppf(tail, killed, of - killed + 1) if killed > 0 else 0.0
    high = beta.ppf(1 - tail, killed + 1, of - killed) if killed < of else 1.0
    return [float(low), float(high)]


def rate(killed, of):
    return {"killed": killed, "of": of, "rate": killed / of if of else None, "interval": interval(killed, of) if of else None}


def by_sites(rows, sites, key):
    """The rate if every site were as likely as any other: operators by the number of their sites instead of their shares.

    The effective size is Kish's, (sum w)^2 / sum w^2, for weights w of the bugs drawn.
    """
    weights, killed = [], 0.0
    drawn = {}
    for row in rows:
        drawn.setdefault(row["operator"], []).append(row)
    for operator, own in drawn.items():
        weight = sites[operator] / len(own)
        weights += [weight] * len(own)
        killed += weight * sum(row[key] for row in own)
    if not weights:
        return None
    share, size = killed / sum(weights), sum(weights) ** 2 / sum(w * w for w in weights)
    return {"rate": share, "interval": interval(share * size, size), "effective": size}


def row_of(mutant, line, cells, reason, same_numbers):
    """One bug of the draw. cells: [(column, Cell)] in the order they were run: cases, parts, tests."""
    kinds = {"case": None, "part": None, "tests": None}
    for column, cell in cells:
        kind = column.judge.kind
        if kinds[kind] is None and cell.kills_beyond_drift:
            gate = next((gate["gate"] for gate in cell.red if gate["origin"] != DRIFT), "")
            kinds[kind] = {"by": column.name, "gate": gate, "stopped": cell.stopped}
    return {
        "id": mutant.id,
        "operator": mutant.kind,
        "folder": folder_of(mutant.file),
        "file": mutant.file,
        "line": line,
        "what": mutant.what,
        "bug": {"find": mutant.find, "replace": mutant.replace, "wrap": mutant.wrap, "type": mutant.type, "at": mutant.at},
        "by_case": kinds["case"],
        "by_part": kinds["part"],
        "by_test": kinds["tests"],
        "ran": sum(cell.run == "ran" for _, cell in cells),
        "left_out": sum(cell.run == "not run" for _, cell in cells),
        "equivalent": reason,
        "same_numbers": same_numbers,
        "in_cases": bool(kinds["case"]),
        "in_gates": bool(kinds["case"] or kinds["part"]),
        "in_all": any(kinds.values()),
    }  # fmt: skip


def document(rows, drawn, sites, excluded, provenance):
    """What results/draw.json holds. sites, excluded: {operator: how many}."""
    judged = [row for row in rows if not row["equivalent"]]
    broken = [f"{row['id']} is declared equivalent, yet something kills it" for row in rows if row["equivalent"] and row["in_all"]]
    broken += [f"{row['id']} is declared equivalent, yet changes numbers" for row in rows if row["equivalent"] and not row["same_numbers"]]
    return {
        "version": 1,
        "seed": drawn.seed,
        **provenance,
        "all": len(rows),
        "equivalent": len(rows) - len(judged),
        "stopped": sum(bool(row["by_case"] and row["by_case"]["stopped"]) for row in judged),
        **{key: {**_rate(judged, seen), "by_sites": by_sites(judged, sites, seen)} for key, seen in RATES.items()},
        "operators": [
            {"name": name, "sites": sites[name], "excluded": excluded.get(name, 0), **_rates(judged, "operator", name)}
            for name in drawn.counts
        ],
        "folders": [{"name": name, **_rates(judged, "folder", name)} for name in FOLDERS],
        "passed_over": _counted(drawn.passed_over.values()),
        "broken": broken,
        "mutants": rows,
    }  # fmt: skip


def _rates(rows, key, name):
    own = [row for row in rows if row[key] == name]
    return {key: _rate(own, seen) for key, seen in RATES.items()}


def _rate(rows, seen):
    return rate(sum(row[seen] for row in rows), len(rows))


def _counted(values):
    counts = {}
    for value in values:
        counts[value] = counts.get(value, 0) + 1
    return counts
