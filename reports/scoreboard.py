"""Makes one self-contained HTML page of what `plumbline scoreboard` found.

    python scoreboard.py DIR

reads DIR/scoreboard.json and writes DIR/scoreboard.html. Verdicts, errors and orders are those of the document; nothing is
judged again. The same document gives the same bytes. Exit status: 0; 2 wrong call; 4 the document or the page cannot be used.
"""

import argparse
import pathlib
import sys

import numpy

import cases
import figures
import frame
from plumbline import reader
import reproduce
import svg
import tables
import text

DOCUMENT, PAGE = "scoreboard.json", "scoreboard.html"
OWN = "Plumbline’s default"
# What is shown in place of a verdict, and its meaning.
OUTCOMES = {
    "missing": ("missing", "the program has no result of this start"),
    "damaged": ("damaged", "the result is not what a final state should be"),
    "mismatched": ("other problem", "the result is of another case, mesh, time or physics"),
    "failed": ("adapter failed", "the adapter ended without a result"),
    "late": ("too late", "the adapter was ended because its time was up"),
}
STYLES = """
.board td { min-width: 8.5rem; } .board td.num { min-width: 0; } .board tbody { border-bottom: 2px solid var(--rule); }
.board tbody th { min-width: 12rem; } .board .ratio { font-size: 1rem; font-weight: 600; } .board .chip { margin-right: 0.3rem; }
.board .why-not { max-width: 20rem; overflow-wrap: anywhere; } .board tr.all > * { background: var(--sunken); }
"""


def render_board(board):
    """The page as text."""
    names = sorted({program["name"] for problem in board["problems"] for program in problem["programs"]})
    problems = [problem_page(problem, names, f"case-{number}") for number, problem in enumerate(board["problems"])]
    return frame.page(
        "scoreboard.html",
        STYLES,
        own=OWN,
        programs=[{"name": name, **stated(board, name)} for name in names],
        problems=problems,
        glance=glance(board),
        refused=board["refused"],
        strays=board["strays"],
        outcomes=OUTCOMES,
        meanings=tables.MEANINGS,
        machine=tables.provenance_rows(board["provenance"]),
        command=board["provenance"].get("command"),
    )


def entries(board):
    """(entry, its program) of the whole board."""
    return [
        (entry, program)
        for problem in board["problems"]
        for program in problem["programs"]
        for entry in program["entries"]
    ]


def stated(board, name):
    """What the results of a program call themselves beside its name, and for how many starts there is one that can be scored."""
    own = [(entry, program) for entry, program in entries(board) if program["name"] == name]
    said = {
        ", ".join(
            filter(None, (program["program"] if program["program"] != name else "", program["version"] and f"version {program['version']}"))
        )
        for _, program in own
    }
    return {"said": text.listing(sorted(said - {""})), "scored": sum(entry["outcome"] == "scored" for entry, _ in own), "starts": len(own)}


def glance(board):
    """Cards at the top of the page."""
    found = [entry["outcome"] == "scored" for entry, _ in entries(board)]
    judged = [program["verdict"] for problem in board["problems"] for program in problem["programs"] if program["verdict"]]
    green = sum(verdict in cases.GREEN for verdict in judged)
    missed = len(found) - sum(found) + len(board["refused"])
    return [
        {"figure": f"{sum(found)} of {len(found)}", "look": "invalid" if missed else "pass", "target": "results",
         "words": "results could be scored"},
        {"figure": f"{green} of {len(judged)}", "look": "pass" if green == len(judged) else "fail", "target": "results",
         "words": "verdicts on a program’s results of a case are green"},
    ]  # fmt: skip


# --- a problem ------------------------------------------------------------------------------------


def problem_page(problem, names, anchor):
    """What the page shows of the starts of one case."""
    programs = {program["name"]: program for program in problem["programs"]}
    shown = [programs[name] for name in names if name in programs]
    computed = [reproduce.beside(problem), *(reproduce.scored(problem, program) for program in shown)]
    return {
        "anchor": anchor,
        "case": problem["case"],
        "title": problem["title"],
        "settings": problem["settings"],
        "measure": with_unit(problem),
        "rows": [mesh_row(problem, shown, number) for number in range(len(problem["own"]["levels"]))],
        "all": series_row(problem, shown) if len(problem["own"]["levels"]) > 1 else None,
        "figures": frame.ready([convergence(problem, shown, names, anchor)], *computed),
        "commands": [reproduce.exported(problem, entry["start"], entry["cells"]) for entry in (shown[0]["entries"] if shown else ())] + computed[:1],
        "programs": [
            {
                "name": program["name"],
                "anchor": f"{anchor}-{svg.identifier(program['name'])}",
                "verdict": program["verdict"],
                "command": reproduce.scored(problem, program),
                "gates": tables.gate_rows(program["gates"]),
                "not_judged": program["not_judged"],
            }
            for program in shown
            if program["verdict"]
        ],
    }


def with_unit(problem):
    unit = problem["units"].get(problem["measure"])
    return problem["measure"] + (f" in {text.unit(unit)}" if unit and unit != "1" else "")


def mesh_row(problem, programs, number):
    level = problem["own"]["levels"][number]
    return {
        "cells": text.count(level["cells"]),
        "error": text.number(level["errors"].get(problem["measure"])),
        "seconds": text.seconds(level["seconds"]),
        "stop": level["stop"],
        "results": [mesh_cell(problem, program, number) for program in programs],
    }


def mesh_cell(problem, program, number):
    """A result: how its error compares, its verdict where gates judge this mesh alone, its time; or why there is none."""
    entry = program["entries"][number]
    found = entry["errors"].get(problem["measure"]) or {}
    verdict = entry["verdict"] if entry["verdict"] != "NONE" else None
    chip, look = (verdict, verdict) if entry["outcome"] == "scored" else (OUTCOMES[entry["outcome"]][0], "invalid")
    return {
        "ratio": text.number(found["ratio"]) if found.get("ratio") is not None else "",
        "error": text.number(found["error"]) if found else "",
        "chip": chip,
        "look": look,
        "reason": "" if entry["outcome"] == "missing" else entry["reason"],
        "seconds": text.seconds(entry["seconds"]) if entry["seconds"] is not None else "",
        "with_start": entry["timed"] == "adapter",
    }


def series_row(problem, programs):
    """Orders, and the verdicts that belong to all meshes."""
    measure = problem["measure"]
    return {
        "own": text.order(problem["own"]["orders"].get(measure) or {}),
        "results": [
            {
                "order": text.order(program["orders"].get(measure) or {}),
                "chip": program["verdict"],
                "look": program["verdict"],
                "reason": program["reason"],
            }
            for program in programs
        ],
    }


def convergence(problem, programs, names, anchor):
    """Error over cell size of the default scheme and of each program; None for a single mesh."""
    measure, levels = problem["measure"], problem["own"]["levels"]
    h = numpy.array([level["h"] for level in levels], float)
    lines = [(OWN, 0, [level["errors"].get(measure) for level in levels])]
    for program in programs:
        errors = [(entry["errors"].get(measure) or {}).get("error") for entry in program["entries"]]
        lines.append((program["name"], 1 + names.index(program["name"]), errors))
    lines = [(label, style, numpy.array(errors, float)) for label, style, errors in lines]  # None becomes NaN
    lines = [line for line in lines if (line[2] > 0).any()]
    if len(levels) < 2 or not lines:
        return None

    def paint(axes):
        for label, style, errors in lines:
            drawn = errors > 0
            (line,) = axes.plot(
                h[drawn], errors[drawn], svg.series_mark(style) + "-", color=svg.series_colour(style), linewidth=0.9, label=label
            )
            svg.note(line, [f"{text.count(level['cells'])} cells" for level, there in zip(levels, drawn) if there])
        axes.set(xscale="log", yscale="log", xlabel="cell size h in m", ylabel=f"error of {with_unit(problem)}")
        figures.log_axis(axes.xaxis, *axes.get_xlim())
        figures.log_axis(axes.yaxis, *axes.get_ylim())

    label = f"Error of {measure} over cell size, {problem['title']}: {text.listing(label for label, _, _ in lines)}"
    keys = [figures.Key(label, f"var(--s{style % len(svg.SERIES) + 1})", svg.series_mark(style)) for label, style, _ in lines]
    files = [entry["start"] for entry in programs[0]["entries"]] if programs else []
    return figures.Figure(
        svg.draw(paint, f"{anchor}-convergence", label),
        f"Error of {measure}",
        "Lower is better; the mesh gets finer to the left.",
        files,
        keys,
    )


# --- command line ---------------------------------------------------------------------------------


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Makes one self-contained HTML page of DIR/scoreboard.json.")
    parser.add_argument("folder", metavar="DIR")
    folder = pathlib.Path(parser.parse_args(arguments).folder)
    try:
        page = render_board(reader.load_scoreboard(folder / DOCUMENT))
        frame.write_whole(folder / PAGE, page)
    except FileNotFoundError:
        print(f"scoreboard: {folder / DOCUMENT} is not there: `plumbline scoreboard {folder}` writes it", file=sys.stderr)
        return 4
    except (OSError, reader.ResultsError) as error:
        print(f"scoreboard: {folder / DOCUMENT}: {error}", file=sys.stderr)
        return 4
    return 0


if __name__ == "__main__":
    sys.exit(main())
