"""What the section "Mutation testing" shows of bugs drawn at random, which `ci/mutants --draw` judges."""

OPERATORS = {
    "coefficient": "a coefficient 2 % larger",
    "term": "a term left out",
    "sign": "the other sign",
    "comparison": "another comparison",
    "range": "a loop without its first or last pass",
    "index": "the element before",
    "column": "a column of points left out",
    "stage": "a stage of an integrator left out",
}
KINDS = ("by_cases", "by_gates", "by_everything")  # gates of cases; of parts, too; and tests
PASSED_OVER = {
    "does not compile": "do not compile",
    "no code": "are in code that the compiler makes nothing of",
    "overlaps another": "overlap another of the draw",
}


def page(document, commit=""):
    """The content of the part; None without a draw. `commit`: that of the results beside it."""
    if not document:
        return None
    judged = [row for row in document["mutants"] if not row["equivalent"]]
    passed = document.get("passed_over", {})
    return {
        "seed": document["seed"],
        "all": document["all"],
        "sites": f"{sum(operator['sites'] for operator in document['operators']):,}",
        "excluded": f"{sum(operator['excluded'] for operator in document['operators']):,}",
        "equivalent": document["equivalent"],
        "stopped": document["stopped"],
        "dear": document.get("dear"),
        "made": document.get("made", ""),
        "commit": document.get("commit", "")[:7] + (" with changes" if document.get("dirty") else ""),
        "elsewhere": bool(commit) and bool(document.get("commit")) and not commit.startswith(document["commit"][:7]),
        **{kind: _rate(document[kind]) for kind in KINDS},
        "operators": [{**_row(entry), "words": OPERATORS.get(entry["name"], ""), "sites": f"{entry['sites']:,}"} for entry in document["operators"]],
        "folders": [_row(entry) for entry in document["folders"]],
        "passed_over": [f"{count} {PASSED_OVER.get(why, why)}" for why, count in passed.items()],
        "survivors": [row for row in judged if not row["in_all"]],
        "only_parts": [row for row in judged if row["in_gates"] and not row["in_cases"]],
        "only_tests": [row for row in judged if row["in_all"] and not row["in_gates"]],
        "equivalents": [row for row in document["mutants"] if row["equivalent"]],
        "broken": document.get("broken", []),
    }


def _row(entry):
    return {"name": entry["name"], "of": entry["by_cases"]["of"], **{kind: _rate(entry[kind]) for kind in KINDS}}


def _rate(rate):
    """{killed, of, share, interval, by_sites}: words of a rate, and of the same with operators as heavy as their places."""
    if not rate["of"]:
        return {"killed": 0, "of": 0, "share": "—", "interval": "", "by_sites": ""}
    sites = rate.get("by_sites")
    return {
        "killed": rate["killed"],
        "of": rate["of"],
        "share": _percent(rate["rate"]),
        "interval": _between(rate["interval"]),
        "by_sites": f"{_percent(sites['rate'])} ({_between(sites['interval'])})" if sites else "",
    }


def _percent(share):
    return f"{100 * share:.0f} %"


def _between(interval):
    return f"{100 * interval[0]:.0f} to {100 * interval[1]:.0f} %"
