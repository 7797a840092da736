"""What was judged, as the rows of results/judges.json and as tables for people."""

from .judge import PROVING, family_of

DIGITS = 5e-4  # of a limit, relative: three digits
ORDER = 5e-3  # of an order, relative: it is fitted to steps of finite size


def row(integrator, entry, judgement, families=PROVING):
    """Of one integrator; `entry` as it is registered: title and source. Of its red gates the row shows one of `families`."""
    gate = judgement.seen_by(families)
    return {
        "integrator": integrator,
        "title": entry["title"],
        "source": entry["source"],
        "verdict": judgement.verdict,
        "stopped": judgement.stopped or None,
        "gate": gate and of_gate(gate),
        "red_families": sorted(judgement.red_families()),
        "proven": judgement.proven,
        "gates": len(judgement.measured),
        "inconclusive": judgement.inconclusive,
        "seconds": judgement.seconds,
    }


def of_gate(gate):
    kept = {key: gate.get(key) for key in ("id", "case", "quantity", "expected", "measured", "margin", "verdict", "note")}
    return {**kept, "family": family_of(gate), "explanation": gate.get("explanation", "")}


def against_known(judgement, known):
    """[{"quantity", "known", "measured", "agrees"}] of the order in dt and the limit of the oscillator, where one is known."""
    order = judgement.measured.get("order/oscillator/displacement")
    limits = judgement.card.get("limits", [])
    limit = next((entry["limit"] for entry in limits if entry["problem"] == "oscillator"), None)
    pairs = (("order", order, ORDER), ("limit", limit, DIGITS))
    return [compared(what, known[what], measured, share * known[what]) for what, measured, share in pairs if known[what] is not None]


def compared(quantity, known, measured, tolerance):
    agrees = measured is not None and abs(measured - known) <= tolerance
    return {"quantity": quantity, "known": known, "measured": measured, "agrees": agrees}


def smallest(clean, judgements):
    """Of each gate of consistency the smallest defect of each kind that it sees, None where it sees none. judgements[kind, size];
    a gate that is red without a defect is left out."""
    red_anyway = {gate["id"] for gate in clean.red}
    seen = {}
    for (kind, size), judgement in judgements.items():
        for gate in judgement.red:
            if family_of(gate) == "consistency" and gate["id"] not in red_anyway:
                seen.setdefault(gate["id"], {}).setdefault(kind, []).append(size)
    kinds = list(dict.fromkeys(kind for kind, _ in judgements))
    return [{"gate": gate, **{kind: min(found.get(kind, []), default=None) for kind in kinds}} for gate, found in sorted(seen.items())]


def by_stage(rows):
    """{stage: {"changes", "killed", "equivalent", "survived"}}"""
    stages = {}
    for entry in rows:
        counts = stages.setdefault(entry["stage"], {"changes": 0, "killed": 0, "equivalent": 0, "survived": 0})
        counts["changes"] += 1
        counts[entry["status"]] += 1
    return dict(sorted(stages.items()))


def number(value):
    return "-" if value is None else f"{value:.4g}"


def expected(gate):
    low, high = (gate["expected"] or {}).get("low"), (gate["expected"] or {}).get("high")
    if low is not None and high is not None:
        return f"{low:.4g} ... {high:.4g}"
    return f">= {low:.4g}" if low is not None else f"<= {high:.4g}" if high is not None else "-"


def line(entry):
    """One row for people: verdict, name, the gate that saw it with what it measured, the defect."""
    gate, words = entry["gate"], entry["stopped"] or ""
    if gate:
        words = f"{gate['id']}: {number(gate['measured'])}, expected {expected(gate)}"
    return f"{entry['verdict']:8} {entry['integrator']:34} {words:90} {entry['title']}".rstrip()
