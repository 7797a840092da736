"""Numbers do not depend on the locale: read with a decimal point, written with one, where the user's has a comma."""
import os
import subprocess

import pytest
from contract import without_volatile


@pytest.fixture(scope="module")
def german(tmp_path_factory):
    folder = tmp_path_factory.mktemp("locale")
    subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(folder / "de_DE.UTF-8")], check=True, capture_output=True)
    environment = {"LOCPATH": str(folder), "LC_ALL": "de_DE.UTF-8", "LANG": "de_DE.UTF-8"}
    printed = subprocess.run(["/usr/bin/printf", "%.1f", "1,5"], env={**os.environ, **environment}, capture_output=True, text=True)
    assert printed.stdout == "1,5", "this locale has a decimal comma"
    return environment


def test_run(plumbline, german):
    arguments = ["run", "sod", "--cells", 20, "--set", "cfl=0.25"]
    expected = plumbline(*arguments, json=True).json()
    result = plumbline(*arguments, json=True, environment=german)
    assert without_volatile(result.json()) == without_volatile(expected)
    assert result.json()["settings"]["cfl"] == 0.25


def test_text(plumbline, german):
    for arguments in (["explain", "sod"], ["reference", "riemann", "--at", "0.5"], ["list"]):
        assert plumbline(*arguments, environment=german).out == plumbline(*arguments).out


def test_comma_stays_wrong(plumbline, german):
    assert plumbline("run", "sod", "--set", "cfl=0,25", environment=german).code == 2
