"""Snakemake on Slurm: a node dies in the middle of a sweep, which ends complete, with the numbers of every other engine."""
import pytest
from slurm_cluster import Cluster, missing_tools
from sweeps import RUNS, await_, differences, finish, kill_all_of


@pytest.fixture(scope="module")
def cluster():
    if lacking := missing_tools():
        pytest.skip(f"Slurm is not installed: no {', '.join(lacking)}; ci/setup --with slurm")
    with Cluster() as started:
        yield started


def run_and_kill_a_node(cluster, sweeps):
    """(jobs that were hit, what they were doing, runs stored by then, exit status, output)"""
    process = sweeps.snakemake("slurm", "slurm", "--group-components", "small=2", environment=cluster.environment)
    try:
        await_("the first runs", 120, lambda: process.poll() is not None or sweeps.stored("slurm"))
        await_("a run on n1", 120, lambda: process.poll() is not None or cluster.hold("n1", "sweep"))
        jobs, stored = cluster.running_jobs("n1"), len(sweeps.stored("slurm"))
        lines = cluster.kill_node("n1")
        return jobs, lines, stored, *finish(process)
    finally:
        kill_all_of(process)


def test_sweep_survives_the_death_of_a_node(cluster, sweeps):
    jobs, lines, stored, status, output = run_and_kill_a_node(cluster, sweeps)
    assert status == 0, output + cluster.logs()
    assert any("sweep --from" in line for line in lines) and stored < RUNS   # it hit work
    assert cluster.state("n1").endswith("*") and any(cluster.restarts(job) > 0 for job in jobs)
    sweeps.assert_complete("slurm")
    numbers = sweeps.numbers("slurm")

    for jobs in (1, 2):
        direct = sweeps.plumbline("sweep", "--from", "plan.json", "--results", f"jobs-{jobs}", "--jobs", jobs)
        assert direct.code == 0, direct.text
        assert differences(sweeps.numbers(f"jobs-{jobs}"), numbers) == [], f"{jobs} jobs"
    status, output = finish(sweeps.snakemake("local", "local", "--cores", "2"))
    assert status == 0, output
    assert differences(sweeps.numbers("local"), numbers) == []
