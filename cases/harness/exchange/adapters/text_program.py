#!/usr/bin/env python3
"""Adapter for programs that read and write text: fills a template of their input file, runs them, reads their table back.

    text_program.py TEMPLATE COMMAND [--name NAME] [--version VERSION] CASE.h5 RESULT.h5

An adapter for one program is two lines of shell that name the first arguments and pass the last two on:

    #!/bin/sh
    exec python3 text_program.py my_program.in 'my_program input' --name my_program "$@"

COMMAND, whose program is a path from here or a name on PATH, runs in a folder of its own, which holds
    input        TEMPLATE, a Jinja template, filled with the description of the start: {{ end_time }}, {{ grid.h }},
                 {{ bodies[0].material.parameters.gamma.value }}, {{ settings.cells }}; `columns` has the datasets of each body,
                 {{ columns.gas.mass[0] }}, for programs whose input lists the points
    BODY.csv     the points of each body: a line of names, then a row a point
and must leave
    BODY-final.csv   the final state in the same form: the datasets that `final_state` of the description lists, separated by
                     commas or blanks
A column is called as its dataset, or DATASET_COMPONENT where a row has several values: position_x, stress_xy.

Exit status: 0 the result is written; 1 the program or its table failed, with a line that says how. Needs numpy, h5py, jinja2.
"""
import argparse
import json
import pathlib
import shlex
import signal
import subprocess
import sys
import tempfile
import time

import h5py
import jinja2
import numpy

AXES = "xyz"


def column_names(name, columns, components):
    """Names of the columns of a dataset."""
    return [name] if columns == 1 else [f"{name}_{part}" for part in components or AXES[:columns]]


def read_start(path):
    """The description, and the datasets of each body: {body: {dataset: points x columns}}."""
    with h5py.File(path, "r") as file:
        about = json.loads(file["description"].asstr()[()])
        columns = {
            body["name"]: {
                name: file[body["group"]][name][()].reshape(body["points"], -1) for name in body["datasets"]
            }
            for body in about["bodies"]
        }
    return about, columns


def write_inputs(folder, template, about, columns):
    environment = jinja2.Environment(undefined=jinja2.StrictUndefined, keep_trailing_newline=True)
    flat = {
        body: {name: values[:, 0].tolist() if values.shape[1] == 1 else values.tolist() for name, values in datasets.items()}
        for body, datasets in columns.items()
    }
    filled = environment.from_string(template.read_text(encoding="utf-8")).render(**about, columns=flat)
    (folder / "input").write_text(filled, encoding="utf-8")
    for body in about["bodies"]:
        datasets = columns[body["name"]]
        names = [
            column
            for name, values in datasets.items()
            for column in column_names(name, values.shape[1], body["datasets"][name].get("components"))
        ]
        rows = numpy.hstack(list(datasets.values()))
        numpy.savetxt(folder / f"{body['name']}.csv", rows, fmt="%.17g", delimiter=",", header=",".join(names), comments="")


def read_table(path, body):
    """The final state of a body from its table: {dataset: points x columns}."""
    lines = path.read_text(encoding="utf-8").splitlines()
    if len(lines) < 2:
        raise ValueError("a line of names and rows are wanted")
    comma = "," if "," in lines[0] else None
    names = [name.strip() for name in lines[0].lstrip("# ").split(comma)]
    rows = numpy.loadtxt(lines[1:], delimiter=comma, ndmin=2)
    if rows.shape[1] != len(names):
        raise ValueError(f"{len(names)} names stand over {rows.shape[1]} columns")
    found = {}
    for dataset in body["final_state"]["datasets"]:
        parts = body["datasets"].get(dataset["name"], {}).get("components")
        wanted = column_names(dataset["name"], dataset["components"], parts)
        if all(name in names for name in wanted):
            found[dataset["name"]] = rows[:, [names.index(name) for name in wanted]]
    if not found:
        raise ValueError(f"none of the columns of a final state is among {', '.join(names)}")
    return found


def write_result(path, about, bodies, wall_s, arguments):
    with h5py.File(path, "w") as file:
        file.attrs.update(exchange_format=1, kind="final-state", case=about["case"], cells=about["cells"], problem=about["problem"], start=about["start"],
                          time=about["end_time"], wall_s=wall_s, program=arguments.name, version=arguments.version)
        for body, datasets in bodies.items():
            for name, values in datasets.items():
                file[f"bodies/{body}/{name}"] = values


def main():
    parser = argparse.ArgumentParser(description="Adapter for programs that read and write text.")
    parser.add_argument("template")
    parser.add_argument("command", help="split into words as a shell would; runs in a folder of its own")
    parser.add_argument("--name", default="text_program")
    parser.add_argument("--version", default="")
    parser.add_argument("case")
    parser.add_argument("result")
    arguments = parser.parse_args()
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended by a signal"))  # so that the folder goes, too
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        about, columns = read_start(arguments.case)
        try:
            write_inputs(folder, pathlib.Path(arguments.template), about, columns)
        except (OSError, jinja2.TemplateError) as error:
            sys.exit(f"{arguments.template}: {error}")
        words = shlex.split(arguments.command)
        if "/" in words[0]:
            words[0] = str(pathlib.Path(words[0]).resolve())
        begun = time.perf_counter()
        try:
            ended = subprocess.run(words, cwd=folder, check=False)
        except OSError as error:
            sys.exit(f"{words[0]}: {error.strerror}")
        wall_s = time.perf_counter() - begun
        if ended.returncode:
            sys.exit(f"{arguments.command}: exit status {ended.returncode}")
        bodies = {}
        for body in about["bodies"]:
            table = folder / f"{body['name']}-final.csv"
            try:
                bodies[body["name"]] = read_table(table, body)
            except (OSError, ValueError) as error:
                sys.exit(f"{table.name}: {error}")
    write_result(arguments.result, about, bodies, wall_s, arguments)


if __name__ == "__main__":
    main()
