"""The reader: what it gives back, what it refuses, and the CSV it writes."""

import csv
import json
import subprocess
import sys

import h5py
import numpy
import pytest

from plumbline import reader
import synthetic_mutants
import synthetic_results
from conftest import REPORTS
from plumbline.reader import DamagedFile, NewerFormat


def as_rows(path):
    with open(path, encoding="utf-8", newline="") as stream:
        return list(csv.reader(stream))


def test_run_gives_back_what_was_written(results):
    folder, names = results
    run = reader.load(folder / names["run"])
    profile = synthetic_results.spring_profile()
    assert run.kind == "run" and run.run["case"] == "spring-mass" and run.name == names["run"]
    assert run.measures["period"]["reference"] == 0.0198592
    assert run.provenance == synthetic_results.PROVENANCE
    assert run.settings["integrator"] == "musl"
    assert set(run.ledger) == {"mass", "momentum_x", "energy"}
    assert run.ledger["energy"]["residual"].dtype == numpy.float64
    assert (run.profile.abscissa, run.profile.kind) == ("time", "history")
    assert run.profile.units["time"] == "s" and run.profile.labels["kinetic_energy"] == "kinetic energy"
    assert all(numpy.array_equal(run.profile[name], values) for name, values in profile.items())


def test_study_and_verdicts(results):
    folder, names = results
    study = reader.load(folder / names["study"])
    assert len(study.study["levels"]) == 5 and study.measures == study.study["measures"]
    assert study.catalog["name"] == "sod" and study.settings["points"] == "equal-mass"
    verdicts = reader.load(folder / names["verdicts"])
    assert verdicts.gates == synthetic_results.all_gates() and verdicts.verdicts["executed"] == 10
    assert set(verdicts.catalog) == {"sod", "spring-mass"}


@pytest.mark.parametrize("was, name", [("frozen", "regression"), ("target", "requirement")])
def test_the_origin_name_of_the_previous_version_is_read(tmp_path, was, name):
    """Until 0.8, in every file: gates of verdicts and of the catalog, killers of seeded bugs."""
    before = {"id": "a", "origin": was, "settings": {"positions": "frozen"}}
    path = tmp_path / "verdicts.h5"
    with h5py.File(path, "w") as file:
        file.attrs.update(plumbline_format=2, kind="verdicts")
        file["verdicts"] = json.dumps({"gates": [before]})
        file["gates"] = json.dumps([before])
        file["catalog"] = json.dumps({"sod": {"gates": [before]}})
    now = {**before, "origin": name}
    read = reader.load(path)
    assert read.gates == [now] and read.verdicts["gates"] == [now] and read.catalog["sod"]["gates"] == [now]
    matrix = json.loads(json.dumps(synthetic_mutants.document()).replace('"origin": "regression"', f'"origin": "{name}"'))
    path = tmp_path / "mutants.json"
    path.write_text(json.dumps(matrix).replace(f'"origin": "{name}"', f'"origin": "{was}"'), encoding="utf-8")
    assert f'"{was}"' in path.read_text(encoding="utf-8") and reader.load_mutants(path) == matrix


def test_keys_and_units_of_the_previous_version_are_read(tmp_path):
    """Until 0.8: particle-steps had another name."""
    bench = synthetic_results.bench_document()
    now = json.dumps(bench)
    before = now.replace("particle_steps_per_s", "point_steps_per_s").replace("particle-steps/s", "point" + "-steps/s")
    path = tmp_path / "bench.json"
    path.write_text(before, encoding="utf-8")
    assert before != now and reader.load_bench(path) == json.loads(now)


def test_comparator_of_a_study(results):
    folder, names = results
    (columns,) = reader.load(folder / names["study"]).comparators.values()
    assert columns.labels["title"] == "Finite volumes, MUSCL-HLLC"
    assert list(columns["cells"]) == list(synthetic_results.CELLS) and columns["density.L1"][0] == 0.0041


def test_folder_sorts_by_kind_and_lists_the_damaged(results):
    folder, names = results
    found = reader.load_folder(folder)
    assert [name for name, _ in found.damaged] == [names["truncated"]]
    assert "truncated" in found.damaged[0][1]
    assert len(found.studies) == 5 and len(found.verdicts) == 1
    kinds = {result.kind for result in found.runs}
    assert kinds == {"run"} and [result.name for result in found.runs] == sorted(
        result.name for result in found.runs
    )


def test_truncated_at_any_length_is_damaged(results, tmp_path):
    folder, names = results
    content = (folder / names["verdicts"]).read_bytes()
    path = tmp_path / "cut.h5"
    for length in (0, 7, 100, len(content) // 3, len(content) - 1):
        path.write_bytes(content[:length])
        with pytest.raises(DamagedFile):
            reader.load(path)


def _file(path, kind="verdicts", version=1, **parts):
    with h5py.File(path, "w") as file:
        if version is not None:
            file.attrs["plumbline_format"] = version
        file.attrs["kind"] = kind
        for name, value in parts.items():
            file[name] = value
    return path


@pytest.mark.parametrize(
    "what, reason",
    [
        ({"version": None, "verdicts": "{}"}, "plumbline_format"),
        ({"version": 0, "verdicts": "{}"}, "format 0"),
        ({"kind": "picture", "verdicts": "{}"}, "picture"),
        ({}, "/verdicts is missing"),
        ({"verdicts": "{"}, "not valid JSON"),
        ({"verdicts": "[]"}, "should be a JSON object"),
        ({"verdicts": "{}", "gates": "{}"}, "should be a JSON list"),
        ({"verdicts": '{"executed": NaN}'}, "NaN"),
        (
            {"verdicts": "{}", "ledger/mass/time": [0.0, 1.0], "ledger/mass/residual": [0.0]},
            "differ in length",
        ),
    ],
)
def test_what_is_refused_and_why(tmp_path, what, reason):
    with pytest.raises(DamagedFile, match=reason):
        reader.load(_file(tmp_path / "bad.h5", **what))


def test_newer_format_is_told_apart(tmp_path):
    version = reader.FORMAT_VERSION + 1
    path = _file(tmp_path / "new.h5", version=version, verdicts="{}")
    with pytest.raises(NewerFormat, match=f"format {version}"):
        reader.load(path)
    assert reader.load_folder(tmp_path).damaged[0][0] == "new.h5"


def test_missing_file_and_folder(tmp_path):
    with pytest.raises(FileNotFoundError):
        reader.load(tmp_path / "nowhere.h5")
    with pytest.raises(NotADirectoryError):
        reader.load_folder(tmp_path / "nowhere")


def test_csv_gives_the_same_numbers_back(results, tmp_path):
    folder, names = results
    run = reader.load(folder / names["run"])
    run.to_csv("profile", tmp_path / "profile.csv")
    rows = as_rows(tmp_path / "profile.csv")
    assert rows[0][0] == "time" and len(rows) == 401
    column = rows[0].index("displacement")
    assert [float(row[column]) for row in rows[1:]] == list(run.profile["displacement"])
    run.to_csv("measures", tmp_path / "measures.csv")
    measures = {row[0]: row for row in as_rows(tmp_path / "measures.csv")[1:]}
    assert float(measures["period"][1]) == 0.01987 and measures["energy_drift"][2] == ""


def test_a_ledger_table_has_every_row_from_the_first(results):
    folder, names = results
    run = reader.load(folder / names["run"])
    header, rows = run.table("ledger")
    step = header.index("step")
    for quantity, columns in run.ledger.items():
        assert [row[step] for row in rows if row[0] == quantity] == list(columns["step"])


def test_a_frame_holds_all_its_points_and_no_others(results):
    folder, names = results
    frames = reader.load(folder / names["frames"]).frames
    for number in range(len(frames)):
        bodies = [frames.body(number, body) for body in range(len(frames.bodies))]
        made = synthetic_results.frame_bodies(number)
        assert [list(body["id"]) for body in bodies] == [list(body["id"]) for body in made]


def test_verdicts_without_a_part_of_gates_give_those_of_their_object(tmp_path):
    gate = synthetic_results.all_gates()[0]
    path = _file(tmp_path / "verdicts.h5", verdicts=json.dumps({"gates": [gate]}))
    header, rows = reader.load(path).table("gates")
    assert rows[0][header.index("id")] == gate["id"]


def test_the_ends_of_a_two_sided_gate_keep_their_places():
    gate = {"id": "a", "expected": {"low": 1.0, "high": 2.0}, "interval": [1.2, 1.4]}
    row = dict(zip(reader.GATE_COLUMNS, reader.gate_row(gate)))
    assert (row["low"], row["high"], row["interval_low"], row["interval_high"]) == (1.0, 2.0, 1.2, 1.4)


def test_documents_that_are_none_are_refused(tmp_path):
    (tmp_path / "bench.json").write_text('{"machine": {}}', encoding="utf-8")
    with pytest.raises(DamagedFile, match="no list of kernels"):
        reader.load_bench(tmp_path / "bench.json")
    document = synthetic_results.stability_document()
    found = next(problem["maps"][0] for problem in document["problems"] if problem.get("maps"))
    found["values"].append(list(found["values"][0]))
    (tmp_path / "stability.json").write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(DamagedFile, match="is not a matrix of"):
        reader.load_stability(tmp_path / "stability.json")


def test_every_table_of_every_file(results, tmp_path):
    folder, _ = results
    found = reader.load_folder(folder)
    expected = {
        "run": {"measures", "ledger", "profile", "settings", "provenance"},
        "study": {"measures", "levels", "settings", "provenance"},
        "verdicts": {"gates", "provenance"},
    }
    for result in found.runs + found.studies + found.verdicts:
        more = {"comparators"} if result.comparators else set()
        assert set(result.table_names()) == expected[result.kind] | more
        for name in result.table_names():
            result.to_csv(name, tmp_path / "table.csv")
            rows = as_rows(tmp_path / "table.csv")
            assert len({len(row) for row in rows}) == 1 and len(rows) > 1


def _command(*arguments):
    return subprocess.run(
        [sys.executable, "-m", "plumbline", *map(str, arguments)],
        cwd=REPORTS,
        capture_output=True,
        text=True,
        check=False,
    )


def test_command_line(results):
    folder, names = results
    gates = _command(folder / names["verdicts"], "--csv", "gates")
    rows = list(csv.DictReader(gates.stdout.splitlines()))
    assert gates.returncode == 0 and [row["verdict"] for row in rows] == [
        gate["verdict"] for gate in synthetic_results.all_gates()
    ]
    assert rows[2]["interval_low"] == "0.952" and rows[2]["high"] == ""
    summary = _command(folder / names["study"])
    assert summary.returncode == 0 and "study" in summary.stdout and "levels" in summary.stdout
    missing = _command(folder / names["run"], "--csv", "gates")
    assert missing.returncode == 2 and "measures" in missing.stderr
    damaged = _command(folder / names["truncated"])
    assert damaged.returncode == 4 and "truncated" in damaged.stderr
    assert _command(folder / "nowhere.h5").returncode == 4
    assert _command().returncode == 2


def test_strings_may_be_fixed_or_variable(tmp_path):
    with h5py.File(tmp_path / "fixed.h5", "w") as file:
        file.attrs["plumbline_format"] = numpy.array([1])
        file.attrs["kind"] = numpy.bytes_("verdicts")
        file["verdicts"] = numpy.bytes_(json.dumps({"executed": 3}))
    assert reader.load(tmp_path / "fixed.h5").verdicts == {"executed": 3}
