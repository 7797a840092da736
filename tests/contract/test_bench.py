"""plumbline bench: the document, complete and consistent. Speeds are printed as met or missed; no test fails on time."""
import itertools
import shlex
import sys

import pytest
from contract import ROOT, Plumbline

sys.path.insert(0, str(ROOT / "reports"))
import reproduce  # noqa: E402  (needs the path above)

DRIFT = 1e-12  # the project's bound for the energy of a gas case


@pytest.fixture(scope="module")
def document(tmp_path_factory):
    result = Plumbline(tmp_path_factory.mktemp("bench"))("bench", "--points", 1000, "--threads", 1, json=True, timeout=600)
    assert result.code == 0, result.err
    return result.json()


def part(document, name):
    return [kernel for kernel in document["kernels"] if kernel["part"] == name]


def choices(kernel):
    return kernel["dimension"], kernel["axisymmetric"], kernel["shape"], kernel["transfer"]


def test_every_geometry_shape_and_transfer_is_timed_once(document):
    geometries = [(1, False), (2, False), (2, True), (3, False)]
    wanted = {(*geometry, shape, transfer) for geometry, shape, transfer in
              itertools.product(geometries, ("linear", "quadratic", "cubic"), ("apic", "flip", "pic"))}
    timed = [choices(kernel) for kernel in part(document, "matrix")]
    assert len(timed) == len(wanted) and set(timed) == wanted
    assert all(kernel["threads"] == 1 for kernel in document["kernels"])


def test_the_default_integrator_is_timed_wherever_it_works(document):
    for kernel in part(document, "matrix"):
        works = kernel["shape"] != "linear" and kernel["transfer"] != "flip"
        assert kernel["integrator"] == ("leapfrog" if works else "musl"), choices(kernel)


def test_energy_of_every_timed_flow_is_closed(document):
    for kernel in part(document, "matrix") + part(document, "scale") + part(document, "target"):
        assert abs(kernel["energy_drift"]) <= DRIFT, choices(kernel)
        assert kernel["steps"] > 100


def test_bytes_of_a_point_are_its_columns(document):
    """2-D APIC gas: position, velocity (2 each), affine (4), mass, volume, strain rate, stress, density, energy, pressure, loss; a number."""
    for kernel in part(document, "target"):
        assert kernel["stored_bytes_per_point"] == 8 * (2 + 2 + 4 + 8) + 4
        assert kernel["memory_bytes_per_point"] is None or kernel["memory_bytes_per_point"] > kernel["stored_bytes_per_point"]


def test_fractions_are_of_the_measured_limits(document):
    (peak,) = [entry["flops_per_s"] for entry in document["machine"]["multiply_add"]]
    copies = {entry["bytes"]: entry["bytes_per_s"] for entry in document["machine"]["copy"]}
    for kernel in part(document, "matrix"):
        held = kernel["points"] * kernel["stored_bytes_per_point"]
        size = min(size for size in copies if size >= held)
        moved = kernel["particle_steps_per_s"] * kernel["bytes_per_point"]
        assert kernel["bandwidth_fraction"] == pytest.approx(moved / copies[size], rel=1e-12)
        assert kernel["flop_fraction"] == pytest.approx(kernel["particle_steps_per_s"] * kernel["flops_per_point"] / peak, rel=1e-12)
        assert kernel["fraction_of_limit"] == max(kernel["bandwidth_fraction"], kernel["flop_fraction"])


def test_work_grows_with_dimension_and_reach(document):
    """More nodes, more operations; more components, more bytes. Reach alone moves no byte."""
    work = {choices(kernel): kernel for kernel in part(document, "matrix") if kernel["integrator"] == "leapfrog"}
    for transfer in ("apic", "pic"):
        for shape in ("quadratic", "cubic"):
            line, plane, space = (work[dim, False, shape, transfer] for dim in (1, 2, 3))
            assert line["flops_per_point"] < plane["flops_per_point"] < space["flops_per_point"]
            assert line["bytes_per_point"] < plane["bytes_per_point"] < space["bytes_per_point"]
        for dim in (1, 2, 3):
            near, far = (work[dim, False, shape, transfer] for shape in ("quadratic", "cubic"))
            assert near["flops_per_point"] < far["flops_per_point"] and near["bytes_per_point"] == far["bytes_per_point"]


def test_median_lies_between_the_slowest_and_the_fastest(document):
    for kernel in document["kernels"]:
        assert kernel["slowest"] <= kernel["particle_steps_per_s"] <= kernel["fastest"] and kernel["repeats"] == 5


def test_targets_say_whether_they_are_met(document):
    names = [target["name"] for target in document["targets"]]
    assert any("1600 cells" in name for name in names) and any("spring" in name for name in names)
    for target in document["targets"]:
        met = (target["low"] is None or target["measured"] >= target["low"]) and (target["high"] is None or target["measured"] <= target["high"])
        assert target["met"] == met and (target["low"], target["high"]) != (None, None)


@pytest.fixture(scope="module")
def quick(document, tmp_path_factory):
    """The command that the full document says it was written by, with the quick tier."""
    program, *words = shlex.split(reproduce.stated(document))
    assert program == "plumbline"
    result = Plumbline(tmp_path_factory.mktemp("quick"))(*words, "--tier", "quick", json="--json" not in words, timeout=600)
    assert result.code == 0, result.err
    return result.json("bench")


def test_stated_command_gives_memory_and_counts_again(document, quick):
    """Times are those of the machine; what a step moves, computes and holds is the same again."""
    columns = ("name", "part", "points", "threads", "bytes_per_point", "flops_per_point", "stored_bytes_per_point", "energy_drift")
    first, second = ([[row[name] for name in columns] for row in part(made, "scale")] for made in (document, quick))
    assert first and first == second


def test_quick_tier_leaves_out_the_table_of_choices(document, quick):
    assert part(quick, "matrix") == []
    assert [target["name"] for target in quick["targets"]] == [target["name"] for target in document["targets"]]
    assert {kernel["repeats"] for kernel in part(quick, "run")} == {3}


def test_chosen_integrator_on_one_thread_and_on_several(plumbline):
    result = plumbline("bench", "--points", 1000, "--integrator", "musl", "--threads", 2, json=True, timeout=600)
    assert result.code == 0, result.err
    timed = part(result.json(), "matrix")
    assert timed and {kernel["integrator"] for kernel in timed} == {"musl"} and {kernel["threads"] for kernel in timed} == {1, 2}
    for one, two in zip(timed[::2], timed[1::2]):  # no number depends on threads, the stored bytes among them
        assert choices(one) == choices(two) and one["stored_bytes_per_point"] == two["stored_bytes_per_point"]


@pytest.mark.parametrize("arguments", [["--points", 10], ["--set", "shap=cubic"], ["--integrator", "mule"], ["--tier", "soon"]])
def test_wrong_call(plumbline, arguments):
    assert plumbline("bench", *arguments).code == 2
