"""A damaged result file, or one of a newer version, is listed as INVALID on the page; the renderer ends with 4."""
import subprocess
import sys

import pytest
from contract import ROOT, edited


def render(folder):
    page = folder / "report" / "index.html"   # in a folder that does not exist yet
    process = subprocess.run([sys.executable, "-B", str(ROOT / "reports/render.py"), str(folder / "results"), str(page.parent)],
                             capture_output=True, text=True, timeout=600, cwd=folder)
    return process, page.read_text(encoding="utf-8") if page.exists() else ""


def truncate(path):
    path.write_bytes(path.read_bytes()[:path.stat().st_size // 2])


def empty(path):
    path.write_bytes(b"")


def lose_format(path):
    with edited(path) as stored:
        del stored.attrs["plumbline_format"]


def from_the_future(path):
    with edited(path) as stored:
        stored.attrs.modify("plumbline_format", 999)


@pytest.fixture
def results(plumbline):
    for cells in (20, 40):
        assert plumbline("run", "sod", "--cells", cells).code in (0, 1)
    assert len(plumbline.files()) == 2
    return plumbline.folder / "results"


def test_whole_files_make_a_page(plumbline, results):
    process, page = render(plumbline.folder)
    assert process.returncode == 0, process.stderr
    assert "sod" in page


@pytest.mark.parametrize("damage", [truncate, empty, lose_format, from_the_future])
def test_damaged_file_is_listed_as_invalid(plumbline, results, damage):
    broken = sorted(results.glob("*.h5"))[0]
    damage(broken)
    process, page = render(plumbline.folder)
    assert process.returncode == 4, process.stderr
    assert "INVALID" in page and broken.name in page


def test_truncated_verdicts(plumbline):
    plumbline("verify", "spring-mass", "--tier", "quick", timeout=600)
    (verdicts,) = (plumbline.folder / "results").glob("verdicts-*.h5")
    truncate(verdicts)
    process, page = render(plumbline.folder)
    assert process.returncode == 4
    assert "INVALID" in page and verdicts.name in page
