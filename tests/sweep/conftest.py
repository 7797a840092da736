"""Paths for the tests of sweeps on other engines; what they share stands in sweeps.py."""
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "contract"))

from sweeps import Sweeps  # noqa: E402  (needs the path above)


@pytest.fixture(scope="module")
def sweeps(tmp_path_factory):
    return Sweeps(tmp_path_factory.mktemp("sweeps"))
