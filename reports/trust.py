"""What the results can be trusted for: requirements against gates, the ledger of tolerances, references, a self-assessment.

Nothing is judged anew: gates, margins and verdicts are those of the files. What is missing is shown as missing.
"""

import fnmatch
import json
import pathlib
from collections import Counter

import cases as gathering
import svg
import tables
import text
from figures import Figure, Key, log_axis

HERE = pathlib.Path(__file__).resolve().parent
REQUIREMENTS_FILE = HERE / "requirements.json"
TOLERANCES_FILE = HERE.parent / "cases" / "tolerances.json"
GENERIC = frozenset("finite mass momentum angular-momentum ledger".split())  # on every study, whatever it is about
WIDE = 0.9  # margins above this leave nine tenths of the tolerance unused
NEAR = 0.1  # margins below this are close to the bound
ROUNDING = ("identity",)  # origins whose tolerance is about rounding: wide by nature
FEATURES = ("shape", "transfer", "integrator", "density", "normals", "contact")
LEDGER_COLUMNS = (
    "case", "gate", "scheme", "origin", "low", "high", "measured", "margin", "verdict", "flag", "widened", "reason",
)  # fmt: skip
COVERAGE_COLUMNS = ("requirement", "sentence", "source", "cases", "gates", "verdicts", "equations", "tests")
REFERENCE_COLUMNS = ("case", "measure", "bound", "error", "share")


# --- requirements ---------------------------------------------------------------------------------


def load_requirements(path=REQUIREMENTS_FILE):
    return json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["requirements"]


def matches(case, gate, pattern):
    """Whether a pattern [case, gate] takes a gate. A gate that stands on every study must be asked for by name; one on a recorded
    value belongs where the gate does that it stands beside."""
    wanted_case, wanted_gate = pattern
    gate = gate.removesuffix(tables.RECORDED)
    name = gate.rsplit("/", 1)[-1]
    if name in GENERIC and wanted_gate.rsplit("/", 1)[-1] != name:
        return False
    return fnmatch.fnmatchcase(case, wanted_case) and fnmatch.fnmatchcase(gate, wanted_gate)


def faults(requirements, gates, tags, has_file=lambda name: True):
    """What is wrong with the list of requirements, as sentences: [] if nothing is.

    `gates`: (case, gate id) of all that exist; `tags`: of the equations.
    """
    found, taken, seen = [], set(), Counter(entry["id"] for entry in requirements)
    found += [f"{name}: there are {count} requirements of this name" for name, count in seen.items() if count > 1]
    for entry in requirements:
        if not entry["gates"] and not entry["tests"]:
            found.append(f"{entry['id']}: no gate and no test")
        for pattern in entry["gates"]:
            hit = {gate for gate in gates if matches(*gate, pattern)}
            taken |= hit
            if not hit:
                found.append(f"{entry['id']}: the pattern {pattern[0]}: {pattern[1]} matches no gate")
        for pattern in entry["equations"]:
            if not any(fnmatch.fnmatchcase(tag, pattern) for tag in tags):
                found.append(f"{entry['id']}: no equation [{pattern}]")
        found += [f"{entry['id']}: no file {name}" for name in entry["tests"] if not has_file(name)]
    found += [f"{case}: {gate} belongs to no requirement" for case, gate in sorted(set(gates) - taken)]
    return found


def known_gates(cases):
    """{(case, id): gate} of all that were judged or are declared; the judged one where both are there."""
    found = {}
    for name, case in cases.items():
        for gate in (case.catalog.get("gates") or []) + case.all_gates:
            if gate.get("id"):
                found[name, gate["id"]] = gate
    return found


def coverage(requirements, cases, equations):
    """Rows of requirement <-> case <-> gate <-> equation."""
    gates = known_gates(cases)
    rows = []
    for entry in requirements:
        own = {
            key: gate for key, gate in gates.items() if any(matches(*key, pattern) for pattern in entry["gates"])
        }
        by_case = {}
        for (case, name), gate in own.items():
            by_case.setdefault(case, []).append((name, gate))
        tags = [
            row for row in equations if any(fnmatch.fnmatchcase(row["tag"], pattern) for pattern in entry["equations"])
        ]
        verdicts = Counter(gate.get("verdict") or "not run" for gate in own.values())
        rows.append(
            {
                **entry,
                "cases": [{"name": name, "gates": sorted(g for g, _ in found)} for name, found in sorted(by_case.items())],
                "count": len(own),
                "judged": sum(1 for gate in own.values() if gate.get("verdict")),
                "verdicts": [(name, verdicts[name]) for name in (*gathering.URGENCY, "not run") if verdicts[name]],
                "equations": tags,
                "hole": _hole(entry, own),
            }
        )
    return rows


def _hole(entry, own):
    if not entry["gates"]:
        return "no gate: by tests alone"
    if not own:
        return "no gate in these results"
    if not any(gate.get("verdict") for gate in own.values()):
        return "declared, not run in this tier"
    if all(gate.get("verdict") in ("XFAIL", "FAIL", None) for gate in own.values()):
        return "nothing passes"
    return ""


def without_requirement(requirements, cases, equations):
    """(gates, equations) that no requirement takes."""
    gates = [
        f"{case}: {gate}"
        for case, gate in sorted(known_gates(cases))
        if not any(matches(case, gate, pattern) for entry in requirements for pattern in entry["gates"])
    ]
    tags = [
        row["tag"]
        for row in equations
        if not any(fnmatch.fnmatchcase(row["tag"], pattern) for entry in requirements for pattern in entry["equations"])
    ]
    return gates, tags


# --- features -------------------------------------------------------------------------------------


def features(cases, runs):
    """Features by row, cases by column: how many runs of a case used a choice; holes are zeros."""
    used, names = {}, [name for name in cases if not name.startswith("stability-")]
    for result in runs:
        name = result.run.get("case")
        if name not in names:
            continue
        for key, value in [*_choices(result.settings), ("dimension", _dimension(result)), ("kind", _kind(result.settings))]:
            used.setdefault((key, value), Counter())[name] += 1
    order = ("kind", "dimension", *FEATURES)
    rows = sorted(used, key=lambda choice: (order.index(choice[0]), choice[1]))
    return {
        "cases": names,
        "rows": [
            {"feature": key, "value": value, "counts": [used[key, value][name] for name in names], "cases": len(used[key, value])}
            for key, value in rows
        ],
    }


def _choices(settings):
    return [(key, settings[key]) for key in FEATURES if isinstance(settings.get(key), str)]


def _dimension(result):
    """From the components of momentum that the ledger of the run has."""
    ledger = result.run.get("ledger") or {}
    count = sum(f"momentum_{axis}" in ledger for axis in "xyz")
    return "axisymmetric" if result.settings.get("geometry") == "axisymmetric" else {1: "line", 2: "plane", 3: "space"}.get(count, "?")


def _kind(settings):
    """The kind of scene, by the keys that only it has."""
    if "membrane.ppc" in settings:
        return "gas and membrane"
    if "density" in settings:
        return "gas"
    return "solid" if "contact" in settings else "membrane"


# --- tolerances -----------------------------------------------------------------------------------


def tolerances(cases, widened=()):
    """Every gate with where its bound comes from and the margin it leaves, those to look at first on top."""
    rows = []
    for case in cases.values():
        for gate in tables.fold_recorded(case.all_gates):
            row = tables.gate_row(gate)
            margin, origin = gate.get("margin"), gate.get("origin") or ""
            more = _widened(widened, case.name, gate.get("id") or "")
            rows.append({**row, "value": margin, "origin_key": origin, "flag": _flag(gate, margin, origin), "widened": more})
    order = {"near the bound": 0, "wide": 1, "": 2}
    return sorted(rows, key=lambda row: (not row["widened"], order.get(row["flag"], 2), row["value"] if row["value"] is not None else 9))


def _flag(gate, margin, origin):
    if margin is None or gate.get("verdict") != "PASS" or origin in ROUNDING:
        return ""
    if margin < NEAR:
        return "near the bound"
    if gate.get("recorded"):
        return ""  # a recorded range holds the value closer than the bound does
    return "wide" if margin > WIDE and origin != "regression" and not _is_lower_bound(gate) else ""


def _is_lower_bound(gate):
    """A quantity far above a lower bound is no slack in an error: value / bound - 1 has no upper end."""
    bounds = gate.get("expected") or {}
    return bounds.get("high") is None


def load_widened(path=TOLERANCES_FILE):
    """[(case, id, words)] of the bounds that were widened, from the repository's own record where it is there; case and id
    may be patterns.
    """
    try:
        rows = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))["gates"]
    except (FileNotFoundError, ValueError, KeyError, TypeError):
        return []
    return [
        (row["case"], row["id"], _widened_words(row["widened"]))
        for row in rows
        if isinstance(row, dict) and isinstance(row.get("widened"), dict) and row.get("case") and row.get("id")
    ]


def _widened_words(change):
    return f"widened {change.get('date') or ''}, was {text.expected(change.get('from'))}: {change.get('why') or 'no reason given'}"


def _widened(widened, case, name):
    for wanted_case, wanted_name, words in widened:
        if fnmatch.fnmatchcase(case, wanted_case) and fnmatch.fnmatchcase(name, wanted_name):
            return words
    return ""


def origins(rows):
    """Counts by origin and verdict."""
    names = [name for name in tables.ORIGINS if any(row["origin_key"] == name for row in rows)]
    verdicts = [name for name in gathering.URGENCY if any(row["verdict"] == name for row in rows)]
    table = Counter((row["origin_key"], row["verdict"]) for row in rows)
    return {
        "verdicts": verdicts,
        "rows": [
            {
                "origin": tables.ORIGINS[name],
                "counts": [table[name, verdict] for verdict in verdicts],
                "total": sum(table[name, verdict] for verdict in verdicts),
                "near": sum(row["flag"] == "near the bound" for row in rows if row["origin_key"] == name),
                "wide": sum(row["flag"] == "wide" for row in rows if row["origin_key"] == name),
            }
            for name in names
        ],
    }


def margins(rows, files):
    """Histogram of the margins of gates that pass, identities apart."""
    values = [row["value"] for row in rows if row["value"] is not None and row["verdict"] == "PASS"]
    others = [row["value"] for row in rows if row["value"] is not None and row["verdict"] == "PASS" and row["origin_key"] not in ROUNDING]
    if not others:
        return None
    edges = [step / 20 for step in range(21)]

    def paint(axes):
        axes.hist([min(value, 1) for value in others], bins=edges, color=svg.series_colour(0), alpha=0.85, label="gates")
        for at, words in ((NEAR, "near the bound"), (WIDE, "wide")):
            axes.axvline(at, color=svg.MUTED, linewidth=0.9, dashes=(5, 3))
            axes.annotate(
                words, (at, 1), xycoords=("data", "axes fraction"), ha="left" if at < 0.5 else "right", va="top", fontsize=7.5,
                xytext=(3 if at < 0.5 else -3, -1), textcoords="offset points",
            )  # fmt: skip
        axes.set(xlabel="margin: 0 at the bound, 1 at the centre or at no error", ylabel="gates that pass", xlim=(0, 1))
        axes.yaxis.get_major_locator().set_params(integer=True)
        axes.xaxis.set_ticks([0.2, 0.4, 0.6, 0.8, 1])  # the axes' zeros would stand on each other

    caption = (
        f"Margin that {text.plural(len(others), 'gate')} leave; {text.count(len(values) - len(others))} more are identities, whose "
        "tolerance is rounding and which stay out. A lower bound that is passed by more than its own size counts as 1."
    )
    return Figure(svg.draw(paint, "trust-margins", "Histogram of margins", height=2.4), "Margins of passed gates", caption, files, [])


# --- references -----------------------------------------------------------------------------------


def references(cases):
    """Per case and judged measure: the bound of the reference over the smallest error it is compared with, worst first."""
    found = {}
    for case in cases.values():
        for entry in case.series:
            for level in entry.levels:
                for name, values in (level.get("measures") or {}).items():
                    bound, error = (values or {}).get("reference_bound"), (values or {}).get("error")
                    if bound is None or not error:
                        continue
                    known = found.get((case.name, name))
                    if known is None or bound / error > known[0] / known[1]:
                        found[case.name, name] = (bound, error)
    judged = {key: pair for key, pair in found.items() if cases[key[0]].gates_about(key[1])}
    rows = [
        {"case": case, "measure": measure, "bound": bound, "error": error, "share": bound / error}
        for (case, measure), (bound, error) in judged.items()
        if bound > 0
    ]
    exact = sum(1 for bound, _ in judged.values() if bound == 0)
    return sorted(rows, key=lambda row: -row["share"]), exact


# --- self-assessment ------------------------------------------------------------------------------


def assessment(cases, rows, reference_rows, folder):
    """The six elements of PCMM, the level this project claims for two of them, and what stands behind it."""
    orders = sum(len(entry.measures) for case in cases.values() for entry in case.studies("cells") if entry.refined)
    counts = Counter(row["verdict"] for row in rows)
    covered = folder.coverage.get("total")
    worst = reference_rows[0]["share"] if reference_rows else None
    spans = [case for case in cases.values() if any(gate.get("id", "").endswith("/uncertainty") for gate in case.all_gates)]
    return [
        {
            "element": "Code verification",
            "level": "2 of 3",
            "evidence": (
                f"{text.plural(len(rows), 'gate')} on {text.plural(len(cases), 'case')} with exact or semi-exact solutions, "
                f"{text.plural(orders, 'fitted order')} with intervals; manufactured solutions at large strain; every equation "
                "has a test; references with computed bounds; mutation testing shows that gates can fail"
                + (f"; {100 * covered:.0f}\u202f% of lines are run by tests" if covered is not None else "")
            ),
            "links": [("requirements", "#trust-requirements"), ("references", "#trust-references"), ("cases", "#overview")],
            "missing": (
                f"Level 3 wants independent review, which has not taken place; {counts['XFAIL']} gates fail as known, and no "
                "order is proven for contact, nor in space beyond two families of cases."
            ),
        },
        {
            "element": "Solution verification",
            "level": "1 to 2 of 3",
            "evidence": (
                "discretisation errors are measured where an exact solution exists, and refinement of mesh, step, points and "
                f"offset is separate; {text.plural(len(spans), 'case')} without one {'states' if len(spans) == 1 else 'state'} the uncertainty of three meshes"
                + (f"; the worst reference bound is {text.number(100 * worst, 2)}\u202f% of the smallest error it judges" if worst else "")
            ),
            "links": [("error against cost", "#cost"), ("tolerances", "#trust-tolerances")],
            "missing": "No error estimate of a user’s own run without a reference; three meshes are few; input and output are checked, not reviewed.",
        },
        *(
            {"element": element, "level": level, "evidence": evidence, "links": [], "missing": missing}
            for element, level, evidence, missing in (
                ("Representation and geometric fidelity", "out of scope", "", "The cases are idealised on purpose."),
                ("Physics and material model fidelity", "out of scope", "", "Ideal gas and elastic materials only; whether they describe a real thing is not asked."),
                ("Model validation", "out of scope", "", "No experiment is compared with; York’s airbag test is a comparison of codes."),
                ("Uncertainty quantification", "partial", "scatter over offsets of the grid, intervals of orders, bounds of references", "Nothing is said of uncertain input."),
            )
        ),
    ]  # fmt: skip


# --- the part of the page -------------------------------------------------------------------------


def page(folder, cases, requirements, widened):
    """What the template shows, and what the CSV tables hold."""
    equations = folder.equations.get("equations") or []
    ledger = tolerances(cases, widened)
    reference_rows, exact = references(cases)
    loose_gates, loose_tags = without_requirement(requirements, cases, equations)
    covered = coverage(requirements, cases, equations)
    return {
        "requirements": covered,
        "holes": [row for row in covered if row["hole"]],
        "loose_gates": loose_gates,
        "loose_tags": loose_tags,
        "equations": len(equations),
        "features": features(cases, folder.runs),
        "tolerances": ledger,
        "origins": origins(ledger),
        "near": sum(row["flag"] == "near the bound" for row in ledger),
        "wide": sum(row["flag"] == "wide" for row in ledger),
        "widened": [row for row in ledger if row["widened"]],
        "references": [
            {**row, "bound": text.number(row["bound"], 2), "error": text.number(row["error"], 2), "share": _percent(row["share"])}
            for row in reference_rows
        ],
        "exact": exact,
        "assessment": assessment(cases, ledger, reference_rows, folder),
        "coverage": _coverage_rows(folder.coverage),
    }


def _percent(share):
    return f"{text.number(100 * share, 2)}\u202f%"


def _coverage_rows(document):
    if not document:
        return []
    rows = [("all", document["total"])] + sorted(document["folders"].items())
    return [{"folder": name, "share": f"{100 * share:.1f}\u202f%", "width": round(100 * share)} for name, share in rows]


def csv_tables(folder, cases):
    """{name: (columns, rows)} of what the section shows."""
    equations = folder.equations.get("equations") or []
    gates = [
        [
            gate.get("case"), gate.get("id"), gate.get("scheme"), gate.get("origin"), (gate.get("expected") or {}).get("low"),
            (gate.get("expected") or {}).get("high"), gate.get("measured"), gate.get("margin"), gate.get("verdict"),
            _flag(gate, gate.get("margin"), gate.get("origin") or ""), "", gate.get("reason"),
        ]
        for case in cases.values()
        for gate in case.all_gates
    ]  # fmt: skip
    widened = load_widened()
    for row in gates:
        row[10] = _widened(widened, row[0] or "", row[1] or "")
    requirements = [
        [
            row["id"], row["requirement"], row["source"], " ".join(case["name"] for case in row["cases"]), row["count"],
            " ".join(f"{name}:{count}" for name, count in row["verdicts"]), "; ".join(tag["tag"] for tag in row["equations"]),
            " ".join(row["tests"]),
        ]
        for row in coverage(load_requirements(), cases, equations)
    ]  # fmt: skip
    rows = [[row[column] for column in REFERENCE_COLUMNS] for row in references(cases)[0]]
    return {
        "requirements": (COVERAGE_COLUMNS, requirements),
        "tolerances": (LEDGER_COLUMNS, gates),
        "references": (REFERENCE_COLUMNS, rows),
    }
