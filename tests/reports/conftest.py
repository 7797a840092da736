"""Paths, shared results and changed documents for the tests of the report."""

import copy
import pathlib
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
REPORTS = HERE.parent.parent / "reports"
sys.path[:0] = [str(REPORTS), str(HERE)]

import chromium  # noqa: E402  (needs the path above)
import synthetic_results  # noqa: E402


def each_without(document, depth=7):
    """Copies of a document in which one value after the other is null; of long lists the first two entries only."""

    def ways(value, depth):
        entries = value.items() if isinstance(value, dict) else enumerate(value[:2]) if isinstance(value, list) else ()
        for key, entry in entries:
            yield (key,)
            if depth > 1:
                yield from ((key, *rest) for rest in ways(entry, depth - 1))

    for way in ways(document, depth):
        changed = place = copy.deepcopy(document)
        for step in way[:-1]:
            place = place[step]
        place[way[-1]] = None
        yield changed


@pytest.fixture(scope="module")
def browser():
    if not chromium.executable():
        pytest.skip("no Chromium is installed (apt-get install chromium): the pages were not looked at in a browser")
    with chromium.Chromium() as opened:
        yield opened


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """A whole folder with one truncated file: (folder, names)."""
    folder = tmp_path_factory.mktemp("results")
    return folder, synthetic_results.write_all(folder)


@pytest.fixture(scope="session")
def page(results, tmp_path_factory):
    """The report of that folder as a single file, its numbers in the folder csv beside it; read-only for the tests."""
    import render

    output = tmp_path_factory.mktemp("page") / "index.html"
    assert render.main([str(results[0]), str(output), "--single-file", "--csv", str(output.parent / "csv")]) == 4
    return output


@pytest.fixture(scope="session")
def folder(results, tmp_path_factory):
    """The report of that folder as a folder of pages; read-only for the tests."""
    import render

    output = tmp_path_factory.mktemp("folder")
    assert render.main([str(results[0]), str(output)]) == 4
    return output
