import pytest
from contract import Plumbline


@pytest.fixture
def plumbline(tmp_path):
    return Plumbline(tmp_path)
