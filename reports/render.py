"""Makes a folder of HTML pages, or one self-contained page, from a folder of result files.

    python render.py RESULTS_DIR OUTPUT_DIR [--csv DIR] [--baseline DIR] [--diff FILE] [--history FILE]
    python render.py RESULTS_DIR OUTPUT.html --single-file

Verdicts, orders and intervals are shown as the files state them; nothing is judged again. The same files
give the same bytes. Exit status: 0; 1 the pages are written and one is larger than it may be; 2 wrong call; 4 the folder or
the output cannot be used, or a file in the folder is damaged (the page is then written all the same, and lists it as
INVALID).
"""

import argparse
import collections
import concurrent.futures
import functools
import gc
import multiprocessing
import os
import pathlib
import re
import sys
import threading

import baseline
import cases as gathering
import catalog
import cost
import cost_charts
import distributions
import draws
import figures
import frame
import history
import mutants
import normals
import pages
import pictures
from plumbline import reader
import profiles
import reproduce
import scorecards
import solutions
import speed
import stability
import svg
import tables
import text
import trust
import york

NORMS = (".L1", ".L2", ".Linf")
MOST_PROFILES = 2  # lines of a case that are drawn over the exact solution, in the field that stands for it
MOST_OTHER_PROFILES = 1  # in every other field
MOST_OTHER_FIELDS = 1  # of a case that are drawn beside it; all are in its CSV
MOST_CONVERGENCE = 2  # measures of a case whose errors are drawn; fits of the others are in the table below
MOST_BYTES = 5_000_000  # of the page, so that it is a file one can send
ROUNDING_OF_A_RUN = 1e-11  # what many roundings add up to; budgets off by less are stated, not drawn
MOST_BUDGETS = 2  # lines of a case whose budgets are shown in full; those of all are in its CSV
MOST_TOLERANCES = 200  # in the ledger of the page; all are in its CSV


def report(folder, earlier=None, kept=None, whole=True):
    """What the report shows; `earlier`: the folder of a baseline, whose curves are drawn along; `kept`: the file of the history; `whole`: with the figures
    that a single file has no space for."""
    cases = gathering.gather(folder)
    if earlier:
        baseline.attach(cases, gathering.gather(earlier))
    results = {result.name: result for result in folder.runs}
    drawn = case_pages(cases, results, folder.cost, whole)
    changed = history.section(kept) if kept else None
    return {"pages": drawn, "catalog": catalog.grid(folder, cases, drawn), **front_page(folder, cases), "changed": changed}


def single_file(shown):
    """The whole report as the text of one page."""
    return frame.page("page.html", shown["stability"].get("style", ""), **shown)


def case_pages(cases, results, costs, whole):
    """The pages of all cases, drawn side by side: most of the time goes into figures."""
    film_characters = pictures.film_characters(cases.values(), results)
    drawn = functools.partial(case_page, results=results, film_characters=film_characters, costs=costs, whole=whole)
    workers = min(len(os.sched_getaffinity(0)), len(cases))
    if workers < 2:
        return [drawn(case) for case in cases.values()]
    gc.freeze()  # the workers share these numbers, and must not touch them to look for garbage
    # A pool would wait forever for a worker that somebody killed.
    fork = multiprocessing.get_context("fork")
    with concurrent.futures.ProcessPoolExecutor(workers, fork, _Worker.begin, (drawn, list(cases.values()))) as pool:
        return list(pool.map(_Worker.page, range(len(cases))))


class _Worker:
    """What a worker has from the moment it is forked: sent with every task it would cost more than the drawing, and a worker
    that is killed while much is sent to it would be waited for."""

    drawn, cases = None, ()

    @classmethod
    def begin(cls, drawn, cases):
        cls.drawn, cls.cases = staticmethod(drawn), cases
        threading.Thread(target=cls.end_with_parent, daemon=True).start()
        gc.disable()  # figures are rings of thousands of parts: looking for garbage once a page is a quarter faster

    @staticmethod
    def end_with_parent():
        """A parent that is killed cannot end its workers."""
        multiprocessing.parent_process().join()
        os._exit(1)

    @classmethod
    def page(cls, number):
        page = cls.drawn(cls.cases[number])
        gc.collect()
        return page


def front_page(folder, cases):
    commit = (tables.origin(folder) or {}).get("commit", "")
    parts = {
        "cost": cost_part(folder, cases),
        "mutants": mutants.page(folder.mutants, commit),
        "draw": draws.page(folder.draw, commit),
        "integrators": scorecards.page(folder.scorecards, folder.judges),
        "expected_failures": expected_failures_part(cases),
    }
    return {
        **parts,
        "sentence": verdict_sentence(folder, cases, parts["expected_failures"]),
        "glance": glance(cases, parts),
        "strips": tables.strips(folder, cases),
        "missed": _anchored(tables.missed(cases)),
        "expected_failure_count": sum(len(one["rows"]) for one in parts["expected_failures"]),
        "gates": tables.gate_rows(gate for case in cases.values() for gate in case.all_gates),
        "choices": tables.choices(cases),
        "schemes": tables.schemes(folder.listed),
        "verdicts_present": catalog.verdicts(cases),
        "damaged": folder.damaged,
        "meanings": tables.MEANINGS,
        "origin": tables.origin(folder),
        "provenance": tables.provenance(folder),
        "commands": tables.commands(folder),
        "trust": trust_part(folder, cases),
        "speed": speed_part(folder.bench),
        "stability": stability_part(folder.stability, cases),
        "york": york_part(cases, {result.name: result for result in folder.runs}),
        "compared": baseline.section(folder.diff, {name: anchor(name) for name in cases}),
        "file_count": len(folder.runs) + len(folder.studies) + len(folder.verdicts),
    }


def verdict_sentence(folder, cases, failures):
    """What the gates say, in one sentence."""
    counts = sum((case.counts for case in cases.values()), collections.Counter())
    judged = sum(counts.values()) - counts["NONE"]
    if not judged:
        return "No gate was judged in this folder; its figures are reported only." if cases else "There is no readable result file in this folder."
    missed = sum(count for verdict, count in counts.items() if verdict not in gathering.GREEN)
    words = f"{judged - missed if missed else 'All'} {'of ' if missed else ''}{text.plural(judged, 'gate')} meet expectation over {text.plural(len(cases), 'case')}"
    if counts["XFAIL"]:
        of_default = sum(len(one["rows"]) for one in failures if one["owner"] == "default")
        words += f"; {counts['XFAIL']} of them fail as known, {of_default or 'none'} by the default scheme"
    if missed:
        words += "; " + text.listing(f"{counts[verdict]} {verdict}" for verdict in gathering.URGENCY if counts[verdict] and verdict not in gathering.GREEN)
    if folder.damaged:
        words += f"; {text.plural(len(folder.damaged), 'file')} could not be read"
    return words + "."


def glance(cases, parts):
    """What a newcomer should know first, each a link to where it is shown; `parts`: those of the front page."""
    counts = sum((case.counts for case in cases.values()), collections.Counter())
    missed = sum(count for verdict, count in counts.items() if verdict not in gathering.GREEN)
    judged = sum(counts.values()) - counts["NONE"]
    cards = []
    if counts:
        cards.append(
            {"figure": f"{judged - missed} of {judged}", "target": "verdicts", "look": "fail" if missed else "pass",
             "words": f"gates meet expectation, over {text.plural(len(cases), 'case')}"}
        )  # fmt: skip
    if counts["XFAIL"]:
        of_default = sum(len(one["rows"]) for one in parts["expected_failures"] if one["owner"] == "default")
        cards.append(
            {"figure": str(counts["XFAIL"]), "target": "expected-failures", "look": "xfail",
             "words": f"of them are known failures, {of_default or 'none'} of the default scheme, each with its cause"}
        )  # fmt: skip
    chosen = [choice for choice in (parts["cost"] or {}).get("recommended", ()) if choice["scheme"]]
    for name in dict.fromkeys(choice["scheme"] for choice in chosen):
        own = [choice for choice in chosen if choice["scheme"] == name]
        problems = sum(len(choice["problems"]) for choice in own)
        cards.append(
            {"figure": name, "target": "which-scheme", "look": "",
             "words": f"needs less time to 1 % error than each scheme it was compared with, for {text.listing(choice['job'] for choice in own)}: "
             f"over {text.plural(problems, 'problem')}"}
        )  # fmt: skip
    integrators, mutated = parts["integrators"], parts["mutants"]
    if integrators and integrators["cards"]:
        judged, green = len(integrators["cards"]), integrators["green"]
        cards.append(
            {"figure": f"{green} of {judged}", "target": "integrators", "look": "pass" if green == judged else "fail",
             "words": "time integrators meet all gates that any must meet: judge one of your own"}
        )  # fmt: skip
    if mutated:
        cards.append(
            {"figure": str(mutated["score"]), "target": "mutants", "look": "",
             "words": f"of {mutated['judged']} seeded bugs that change anything are caught by a gate or a named test"}
        )  # fmt: skip
    return cards


def expected_failures_part(cases):
    """The lists of known failures by owner, their rows linked to the cases."""
    return [{**one, "rows": _anchored(one["rows"])} for one in tables.expected_failures(cases)]


def cost_part(folder, cases):
    """What the section on cost shows; None where no cost was measured."""
    if not folder.cost:
        return None
    part = cost.overview(folder.cost, cases, folder.stability)
    found, command = part.pop("found"), reproduce.stated(folder.cost)
    return {
        **part,
        "rows": _anchored(part["rows"]),
        "rule": cost.RULE,
        "charts": frame.ready((cost_charts.relative_to_york(found), cost_charts.absolute(found)), command),
        "surfaces": frame.ready((cost_charts.surface(folder.cost, scheme) for scheme in ("york1997", "default")), command),
        "york_step": cost_charts.york_step(folder.cost),
    }


def trust_part(folder, cases):
    """What the section on trust shows."""
    part = trust.page(folder, cases, trust.load_requirements(), trust.load_widened())
    for row in part["requirements"]:
        row["cases"] = [{**case, "anchor": anchor(case["name"])} for case in row["cases"]]
    part["features"]["cases"] = [{"name": name, "anchor": anchor(name)} for name in part["features"]["cases"]]
    return {
        **part,
        "references": _anchored(part["references"]),
        "first_tolerances": (judged := [row for row in part["tolerances"] if row["origin_key"] != "identity"])[:MOST_TOLERANCES],
        "other_tolerances": max(0, len(judged) - MOST_TOLERANCES),
        "margins": frame.ready([trust.margins(part["tolerances"], [result.name for result in folder.verdicts])], *dict.fromkeys(map(_command, folder.verdicts))),
    }


def _command(result):
    return result.provenance.get("command") or ""


def york_part(cases, results):
    """What answers for York's figures and tables, and our pictures of them; None where none of his cases is there."""
    part = york.page(cases, results)
    if part:
        for row in part["rows"]:
            row["cases"] = _anchored({**case, "case": case["name"]} for case in row["cases"])
        part["pictures"] = frame.ready(part["pictures"])
    return part


def speed_part(bench):
    """What the section on speed shows; None where no speed was measured."""
    if not bench:
        return None
    return {**speed.page(bench), "figures": frame.ready((speed.cost_by_size(bench), speed.memory_by_size(bench)), reproduce.stated(bench))}


def stability_part(document, cases):
    """What the section on stability shows; only the gates of the laboratory where nothing else is there."""
    verdicts = {
        name.removeprefix(stability.CASE_PREFIX): {**tables.case_row(case), "anchor": anchor(name)}
        for name, case in cases.items()
        if name.startswith(stability.CASE_PREFIX)
    }
    if not document:
        return {"verdicts": list(verdicts.values())}
    part = stability.page(document, verdicts)
    for problem, shown in zip(document["problems"], part["problems"]):
        command = reproduce.growth(problem["problem"], document)
        shown["growth"] = next(iter(frame.ready([stability.growth(problem, f"{shown['anchor']}-growth")], command)), None)
        shown["maps_command"] = reproduce.maps(problem["problem"], document)
        shown["parts"] = stability.map_parts(problem)
    kinds = [found["growth"] for shown in part["problems"] for found in shown["parts"]]
    return {
        **part,
        "has_maps": bool(kinds),
        "has_limit_maps": not all(kinds),
        "style": stability.filter_rules(part["safe"]),
    }


def anchor(name):
    """An identifier for links from the name of a case."""
    return "case-" + (re.sub(r"[^A-Za-z0-9_-]+", "-", name) or "unnamed")


def _anchored(rows):
    return [{**row, "anchor": anchor(row["case"])} for row in rows]


# --- a case ---------------------------------------------------------------------------------------


def case_page(case, results, film_characters, costs, whole):
    """What the template of a case shows, in the order of the page."""
    name, catalog = anchor(case.name), case.catalog
    finest = finest_results(case, results)
    title = catalog.get("title") or case.name
    own, choices = tables.parameter_rows(case)
    gates, identities = tables.split_identities(case.gates)
    return {
        "name": case.name,
        "anchor": name,
        "title": title,
        "catalog": catalog,
        "verdict": case.verdict,
        "counts": tables.counts_row(case),
        "reason": tables.one_line_reason(case),
        "paragraphs": [part.strip() for part in (catalog.get("physics") or "").split("\n\n") if part.strip()],
        "sketch": frame.markup(svg.sketch(catalog.get("sketch") or "", f"{name}-sketch", f"Sketch of {title}")),
        "described_by": reproduce.description(case.name),
        "parameters": own,
        "choices": [row for row in choices if row["changed"]],
        "default_choices": [row for row in choices if not row["changed"]],
        "budget": tables.reference_budget(case),
        "bound": text.exact(catalog["reference"].get("bound")) if catalog.get("reference") else "",
        "studies": tables.study_rows(case),
        "settings": tables.settings_matrix(case),
        "gates": gates,
        "identities": identities,
        "other_gates": tables.gate_rows(case.other_gates),
        "not_run": tables.not_run(case),
        **tables.fit_rows(case, leading_measures(case)),
        "levels": tables.level_rows(case, case.measure),
        "measure": case.measure,
        "has_norms": any(measure.endswith(NORMS) for measure in convergence_measures(case)),
        "scalars": tables.scalar_rows(case),
        "leads_with_scalars": not (case.measure or "").endswith(NORMS),
        "budgets": tables.ledger_rows(([pair for pair in finest if pair[0].refined] or finest)[:MOST_BUDGETS]),
        "stopped": tables.stopped(case),
        "pictures": picture_groups(case, results, name, film_characters),
        "normals": frame.ready(normals.drawings(case, results, f"{name}-normals")),
        **case_figures(case, results, finest, name, costs),
        "results": [frame.ready(group) for group in solutions.figures_of(case, results, f"{name}-result")] if whole else [],
    }


def picture_groups(case, results, name, film_characters):
    """What can be looked at of the runs that kept frames: points over time, a film, fields."""
    groups = pictures.groups(case, results, f"{name}-pictures", film_characters)
    for group in groups:
        frame.ready([group["strip"], group["film"]])
        group["fields"] = frame.ready(group["fields"])
    return groups


def case_figures(case, results, finest, name, costs):
    """All figures of a case, by the part of the page they stand in; what cannot be drawn is left out."""
    drawn = {"profiles": profile_groups(case, results, name), "convergence": [], "variations": []}
    drawn["draws"] = frame.ready([distributions.drawing(case, results, name)])
    for number, measure in enumerate(convergence_measures(case)[:MOST_CONVERGENCE]):
        drawn["convergence"].append(
            frame.ready(
                figure
                for function in (figures.convergence, figures.level_by_level)[: 2 if number == 0 else 1]
                for figure in figures.parts(functools.partial(function, case, measure), f"{name}-{function.__name__}-{number}")
            )
        )
    if case.measure:
        drawn["variations"] = frame.ready(
            figure
            for vary in ("dt", "ppc", "offset")
            for number, measure in enumerate(figures.variation_measures(case, vary))
            for figure in figures.parts(functools.partial(figures.variation, case, vary, measure), f"{name}-{vary}-{number}")
        )
    if case.has_points:
        drawn["costs"] = frame.ready(cost.case_figures(costs, case, name)) if costs else cost_figures(case, name)
    refined = [pair for pair in finest if pair[0].refined] or finest
    quantities = profiles.quantities(finest)
    drawn["drifts"] = frame.ready([profiles.drifts(quantities, refined, f"{name}-drift", ROUNDING_OF_A_RUN)])
    drawn["rounding"] = profiles.at_rounding(quantities, refined, ROUNDING_OF_A_RUN)
    closed = [
        (profiles.quantity_name(quantity), profiles.closed(quantity, refined)) for quantity in quantities
    ]
    drawn["closed"] = [f"{quantity} ({text.listing(labels)})" for quantity, labels in closed if labels]
    return drawn


def convergence_measures(case):
    """Measures with a theoretical order or a gate on it; without any, the one that stands for the case."""
    fitted = list(
        dict.fromkeys(
            measure for entry in case.studies("cells") if entry.refined for measure in entry.measures
        )
    )
    wanted = [
        measure
        for measure in fitted
        if measure in (case.catalog.get("theory_order") or {}) or case.gates_about(measure, "order")
    ]
    return wanted or [case.measure] * (case.measure in fitted)


def leading_measures(case):
    return convergence_measures(case) + (figures.variation_measures(case, "dt") if case.measure else [])


def cost_figures(case, prefix):
    return (
        frame.ready(
            figure for kind in figures.COSTS for figure in figures.parts(functools.partial(figures.cost, case, case.measure, kind), f"{prefix}-{kind}")
        )
        if case.measure
        else []
    )


def profile_groups(case, results, name):
    """[{title, figures}]: the field of the leading measure first, then single runs, then other fields."""
    lines = [
        (entry, profiles.chosen_levels(entry, results))
        for entry in case.series
        if entry.vary in ("cells", "")
    ]
    lines = [(entry, levels) for entry, levels in lines if levels]
    refined = [line for line in lines if line[0].refined] or lines[:MOST_PROFILES]
    single = [line for line in lines if line not in refined]
    present = list(
        dict.fromkeys(
            field for _, levels in lines for _, _, columns in levels for field in profiles.fields(columns)
        )
    )
    leading = (case.measure or "").split(".")[0]
    present.sort(key=lambda field: field != leading)
    groups = [
        (field.replace("_", " ").capitalize(), field, refined[: MOST_PROFILES if number == 0 else MOST_OTHER_PROFILES])
        for number, field in enumerate(present[: 1 + MOST_OTHER_FIELDS])
    ]
    groups[1:1] = [
        (f"{field.replace('_', ' ').capitalize()}: {title}", field, part)
        for field in present[:1]
        for title, part in (("lines of a single run", single[:MOST_OTHER_PROFILES]),)
        if part
    ]
    return [
        {
            "title": title,
            "figures": _profiles(part, field, f"{name}-profile-{number}"),
            "left": len(single if part and part[0] in single else refined) - len(part),
        }
        for number, (title, field, part) in enumerate(groups)
    ]


def _profiles(lines, field, prefix):
    return frame.ready(
        profiles.profile(entry, field, levels, f"{prefix}-{number}")
        for number, (entry, levels) in enumerate(lines)
    )


def finest_results(case, results):
    """[(series, run result)] of the finest level with a ledger, for mesh studies and single runs."""
    found = []
    for entry in case.series:
        names = [
            level.get("file")
            for level in entry.levels
            if level.get("file") in results and results[level["file"]].ledger
        ]
        if names and entry.vary in ("cells", ""):
            found.append((entry, results[names[-1]]))
    return found


# --- command line ---------------------------------------------------------------------------------


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Makes a folder of HTML pages from a folder of result files, and prints the path of its index.")
    parser.add_argument("results", metavar="RESULTS_DIR")
    parser.add_argument("output", metavar="OUTPUT", help="folder for the pages; with --single-file the page")
    parser.add_argument("--single-file", action="store_true", help="write one self-contained page instead, to be sent")
    parser.add_argument("--csv", metavar="DIR", help="also write every table as CSV into this folder")
    parser.add_argument("--baseline", metavar="DIR", help="results folder whose curves are drawn along")
    parser.add_argument(
        "--diff", metavar="FILE", help="document of `plumbline diff --json` (default: diff.json in the results folder)"
    )
    parser.add_argument(
        "--history", metavar="FILE", help=f"what earlier results were (default: {history.HISTORY_FILE} in the results folder)"
    )
    options = parser.parse_args(arguments)
    output = pathlib.Path(options.output)
    if not options.single_file and output.suffix == ".html":
        parser.error(f"OUTPUT is {output}, and a folder is written; for one page add --single-file")
    try:
        folder = reader.load_folder(options.results)
        earlier = reader.load_folder(options.baseline) if options.baseline else None
        if options.diff:
            folder.diff = load_diff(options.diff)
        kept = options.history or pathlib.Path(options.results) / history.HISTORY_FILE
        shown = report(folder, earlier, kept, whole=not options.single_file)
        large = write_single_file(shown, output) if options.single_file else write_folder(shown, output)
        if options.csv:
            write_tables(folder, gathering.gather(folder), pathlib.Path(options.csv))
    except (OSError, reader.ResultsError) as error:
        print(f"render: {error}", file=sys.stderr)
        return 4
    except concurrent.futures.BrokenExecutor:
        print("render: a process that drew figures was killed, perhaps for want of memory; no page was written", file=sys.stderr)
        return 4
    for name, reason in folder.damaged:
        print(f"render: {name}: {reason}", file=sys.stderr)
    for path, size, most in large:
        print(f"render: {path} has {size / 1e6:.2f} MB, more than {most / 1e6:g}", file=sys.stderr)
    if folder.damaged:
        return 4
    return 1 if large else 0


def write_single_file(shown, output):
    """Writes the page; [(path, bytes, most)] where it is larger than it may be."""
    page = single_file(shown)
    frame.write_whole(output, page)
    size = len(page.encode())
    return [(output, size, MOST_BYTES)] if size > MOST_BYTES else []


def write_folder(shown, target):
    """Writes the pages and says where they begin; [(path, bytes, most)] of those larger than they may be."""
    files = pages.write(shown, target)
    print(target / "index.html")
    return pages.too_large(files)


def write_tables(folder, cases, target):
    """Every table of the page as CSV."""
    tables.write_folder(folder, cases, target)
    more = trust.csv_tables(folder, cases)
    if folder.cost:
        more["cost"] = cost.CSV_COLUMNS, cost.csv_rows(folder.cost)
    more |= scorecards.csv_tables(folder.scorecards)
    for name, (columns, rows) in more.items():
        reader.write_csv(columns, rows, target / f"{name}.csv")


def load_diff(path):
    try:
        return reader.load_diff(path)
    except reader.ResultsError as error:
        raise reader.ResultsError(f"{path}: {error}") from error


if __name__ == "__main__":
    sys.exit(main())
