"""Same binary: bitwise the same results, run by run and for any number of threads, but for the fields that tell of the run itself."""
import pytest
from contract import Plumbline, contents, without_volatile

RUNS = {
    "sod": ["run", "sod", "--cells", 200],
    "sod york1997": ["run", "sod", "--cells", 100, "--scheme", "york1997"],
    "sod musl cubic": ["run", "sod", "--cells", 100, "--integrator", "musl", "--set", "shape=cubic"],
    "spring-mass": ["run", "spring-mass"],
    "spring-mass york1997": ["run", "spring-mass", "--scheme", "york1997"],
    "many points on a line": ["run", "sod", "--cells", 800, "--set", "t_end=0.01"],
    "many points in the plane": ["run", "gas-expansion", "--cells", 60],
    "stopped": ["run", "sod", "--cells", 100, "--set", "cfl=5"],
    "study": ["converge", "sod", "--cells", "20,40,80"],
    "verdicts": ["verify", "spring-mass", "--tier", "quick"],
}


def outcome(folder, arguments):
    folder.mkdir()
    plumbline = Plumbline(folder)
    result = plumbline(*arguments, json=True, timeout=600)
    files = {name: contents(folder / "results" / name) for name in plumbline.files()}
    assert files
    return result.code, without_volatile(result.json()), files


def differences(one, other, place=""):
    """Where two outcomes differ, by name: the whole of them would fill pages."""
    if isinstance(one, dict) and isinstance(other, dict):
        return [d for key in sorted({*one, *other}) for d in differences(one.get(key), other.get(key), f"{place}/{key}")]
    if isinstance(one, (list, tuple)) and isinstance(other, (list, tuple)) and len(one) == len(other):
        return [d for k, pair in enumerate(zip(one, other)) for d in differences(*pair, f"{place}/{k}")]
    return [] if one == other else [f"{place}: {one!r:.60} and {other!r:.60}"]


@pytest.mark.parametrize("name", RUNS)
def test_bitwise_the_same(tmp_path, name):
    first = outcome(tmp_path / "first", RUNS[name])
    assert differences(first, outcome(tmp_path / "again", RUNS[name])) == []
    for threads in (1, 2):
        assert differences(first, outcome(tmp_path / f"threads-{threads}", [*RUNS[name], "--threads", threads])) == [], f"{threads} threads"


def test_differences_are_seen(tmp_path):
    """Of another mesh, in the document as in the file: what compares must be able to fail."""
    first, other = (outcome(tmp_path / str(cells), ["run", "sod", "--cells", cells]) for cells in (20, 21))
    found = differences(first, other)
    assert any("/measures/density.L1/error" in place for place in found) and any(".h5" in place for place in found)


def test_settings_decide_the_name_of_the_file(tmp_path):
    names = set()
    for i, setting in enumerate(["cfl=0.3", "cfl=0.31", "gamma=1.41", "shape=cubic"]):
        (tmp_path / str(i)).mkdir()
        plumbline = Plumbline(tmp_path / str(i))
        plumbline("run", "sod", "--cells", 20, "--set", setting)
        names.update(plumbline.files())
    assert len(names) == 4


def test_single_stages_are_the_same_to_rounding_and_say_so(plumbline):
    call = ("run", "sod", "--cells", 50)
    fused, single = (plumbline(*call, *more, json=True).json() for more in ((), ("--no-fusion", "--results", "single")))
    assert (fused["provenance"]["fused"], single["provenance"]["fused"]) == (True, False)
    assert fused["provenance"]["fingerprint"] != single["provenance"]["fingerprint"] and fused["steps"] == single["steps"]
    for name, measure in fused["measures"].items():
        assert single["measures"][name]["error"] == pytest.approx(measure["error"], rel=1e-9), name


def test_runs_of_single_stages_are_not_taken_for_others(plumbline):
    call = ("verify", "spring-mass", "--reuse")
    assert plumbline(*call, timeout=600).code == 0
    assert ", 0 made" in plumbline(*call, timeout=600).text
    assert ", 0 made" not in plumbline(*call, "--no-fusion", timeout=600).text
