"""ci/coverage: sums by folder and the bound."""
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SCRIPT = ROOT / "ci/coverage_summary.py"
sys.path.insert(0, str(ROOT / "reports"))

from plumbline import reader  # noqa: E402


def evaluate(tmp_path, **counts):
    """Exit status, document and words for {path: (covered, total)}."""
    files = [{"filename": path, "line_covered": covered, "line_total": total, "line_percent": 0} for path, (covered, total) in counts.items()]
    (tmp_path / "gcovr.json").write_text(json.dumps({"files": files}))
    done = subprocess.run([sys.executable, str(SCRIPT), str(tmp_path / "gcovr.json"), str(tmp_path / "coverage.json")],
                          capture_output=True, text=True, timeout=30)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["coverage.json", "gcovr.json"], done.stderr
    return done.returncode, json.loads((tmp_path / "coverage.json").read_text()), done.stdout


def test_the_report_reads_it(tmp_path):
    _, document, _ = evaluate(tmp_path, **GOOD)
    assert reader.load_coverage(tmp_path / "coverage.json") == document


GOOD = {"kernel/a.cpp": (90, 100), "reference/b.cpp": (10, 10), "cases/harness/c.cpp": (45, 50)}


def test_lines_are_summed_over_the_files_of_a_folder(tmp_path):
    status, document, _ = evaluate(tmp_path, **GOOD, **{"kernel/engine/d.cpp": (300, 300), "cases/catalog/gas/sod.cpp": (0, 1000)})
    assert status == 0
    assert document["folders"] == {"kernel": 0.975, "reference": 1.0, "cases/harness": 0.9}
    assert document["total"] == 0.9674 and "cases/catalog/gas/sod.cpp" not in document["files"]
    assert document["files"]["kernel/a.cpp"] == 0.9


@pytest.mark.parametrize("folder, path", [("kernel", "kernel/a.cpp"), ("reference", "reference/b.cpp"), ("cases/harness", "cases/harness/c.cpp")])
def test_one_folder_below_the_bound_is_red(tmp_path, folder, path):
    status, _, words = evaluate(tmp_path, **{**GOOD, path: (899, 1000)})
    assert status == 1 and f"{folder}: 89.9 % of lines, below 90 %" in words and "101 lines not reached" in words


def test_a_folder_that_was_not_counted_is_red(tmp_path):
    status, document, words = evaluate(tmp_path, **{"kernel/a.cpp": (1, 1), "reference/b.cpp": (1, 1)})
    assert status == 1 and document["folders"]["cases/harness"] is None and "cases/harness: no lines at all" in words
