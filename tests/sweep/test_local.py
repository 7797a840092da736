"""Snakemake on this machine: the numbers of `plumbline sweep`, and a killed sweep goes on where it stood."""
import pytest
from sweeps import RUNS, await_, differences, finish, kill_all_of


def identities(sweeps, results):
    """What tells whether a file was written again."""
    return {name: (path.stat().st_ino, path.stat().st_mtime_ns) for name, path in sweeps.stored(results).items()}


def complete(sweeps, results):
    status, output = finish(sweeps.snakemake("local", results, "--cores", "2"))
    assert status == 0, output
    sweeps.assert_complete(results)
    return output


@pytest.fixture(scope="module")
def killed(sweeps):
    """What a sweep had stored when kill -9 ended it in the middle; since then it has been completed."""
    process = sweeps.snakemake("local", "local", "--cores", "2")
    try:
        await_("the first runs", 120, lambda: process.poll() is not None or len(sweeps.stored("local")) >= RUNS // 4)
    finally:
        kill_all_of(process)
    stored, markers = identities(sweeps, "local"), sweeps.markers("local")
    assert RUNS // 4 <= len(stored) < RUNS and "verdict" not in markers
    complete(sweeps, "local")
    return stored


def test_killed_sweep_goes_on_where_it_stood(sweeps, killed):
    now = identities(sweeps, "local")
    assert len(now) == RUNS and not [name for name, identity in killed.items() if now[name] != identity]


def test_numbers_are_those_of_the_direct_sweep(sweeps, killed):
    direct = sweeps.plumbline("sweep", "--from", "plan.json", "--results", "direct")
    assert direct.code == 0, direct.text
    assert differences(sweeps.numbers("local"), sweeps.numbers("direct")) == []


def test_complete_sweep_is_left_alone(sweeps, killed):
    assert "Nothing to be done" in complete(sweeps, "local")


def test_lost_run_alone_is_repeated(sweeps, killed):
    batch, results = sweeps.plan["batches"][0], sweeps.folder / "local"
    lost = batch["runs"][0]["file"]
    for path in (results / lost, *results.glob(f".sweep/*/{batch['id']}")):
        path.unlink()
    before = identities(sweeps, "local")
    complete(sweeps, "local")
    now = identities(sweeps, "local")
    assert now.pop(lost) and now == before


def test_plan_without_batches_is_refused(sweeps):
    status, output = finish(sweeps.snakemake("local", "none", "--cores", "2", plan="user.json"))
    assert status != 0 and "plumbline sweep --from user.json --plan" in output
