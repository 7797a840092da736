"""Paths and shared results for the tests of the report."""

import pathlib
import sys

import pytest

HERE = pathlib.Path(__file__).resolve().parent
REPORTS = HERE.parent.parent / "reports"
sys.path[:0] = [str(REPORTS), str(HERE)]

import synthetic_results  # noqa: E402  (needs the path above)


@pytest.fixture(scope="session")
def results(tmp_path_factory):
    """A whole folder with one truncated file: (folder, names)."""
    folder = tmp_path_factory.mktemp("results")
    return folder, synthetic_results.write_all(folder)


@pytest.fixture(scope="session")
def page(results, tmp_path_factory):
    """The report of that folder as a file; read-only for the tests."""
    import render

    output = tmp_path_factory.mktemp("page") / "index.html"
    assert render.main([str(results[0]), str(output)]) == 4
    return output
