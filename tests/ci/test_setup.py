"""ci/setup on machines it does not run on: no apt, no root, a package missing. Only the commands given here exist."""
import os
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import pytest

CI = Path(__file__).resolve().parents[2] / "ci"
NEEDED = "bash env dirname realpath nproc sed grep cut xargs cat stat".split()
NOBODY = 65534


class Machine:
    """A folder that holds ci/ and the only commands there are: basic tools and the fakes given (name=body of a script)."""

    def __init__(self, root):
        self.root, self.bin, self.log = root, root / "bin", root / "log"
        root.chmod(0o755)   # readable without root
        self.bin.mkdir()
        (root / "ci").mkdir()
        for name in ("setup", "common.sh", "packages"):
            shutil.copy(CI / name, root / "ci" / name)
        for tool in NEEDED:
            (self.bin / tool).symlink_to(shutil.which(tool))

    def run(self, *options, as_nobody=False, **fakes):
        for name, body in fakes.items():
            path = self.bin / name.replace("_", "-")
            path.unlink(missing_ok=True)   # never write through a link to the real command
            path.write_text(f"#!{shutil.which('bash')}\n{body}\n")
            path.chmod(0o755)
        command = [shutil.which("bash"), str(self.root / "ci" / "setup"), *options]
        if as_nobody and os.geteuid() == 0:
            command = [shutil.which("setpriv"), f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups", *command]
        environment = {"PATH": str(self.bin), "LOG": str(self.log), "STATE": str(self.root / "state")}
        return subprocess.run(command, capture_output=True, text=True, env=environment, stdin=subprocess.DEVNULL, timeout=60)


@pytest.fixture
def machine():
    with tempfile.TemporaryDirectory() as folder:
        yield Machine(Path(folder))


# dpkg-query that knows all packages asked for, except the one named in MISSING until the file STATE exists.
DPKG = 'for p in "${@:4}"; do [[ $p == ninja-build && ! -e $STATE ]] || echo "installed $p"; done'
ALL = 'for p in "${@:4}"; do echo "installed $p"; done'


def test_nothing_missing_ends_at_once_without_apt(machine):
    start = time.monotonic()
    result = machine.run(dpkg_query=ALL, apt_get="echo used >> $LOG; exit 9", sudo="echo used >> $LOG; exit 9")
    assert result.returncode == 0 and "everything is installed" in result.stdout
    assert time.monotonic() - start < 1.0   # the promise of a second run
    assert not machine.log.exists()


def test_without_apt_the_missing_packages_are_named(machine):
    result = machine.run(dpkg_query=DPKG)
    assert result.returncode == 1
    assert "no apt-get" in result.stderr and "\n  ninja-build\n" in result.stderr
    assert "cmake" not in result.stderr


def test_without_dpkg_each_package_is_probed(machine):
    result = machine.run(cmake="", ninja="")
    assert result.returncode == 1
    assert "\n  libeigen3-dev\n" in result.stderr   # no c++ there: no header can be found
    assert "\n  cmake\n" not in result.stderr and "\n  ninja-build\n" not in result.stderr


def test_missing_package_is_installed_unattended(machine):
    log = 'echo "$DEBIAN_FRONTEND $*" >> $LOG; [[ $* != *install* ]] || : > $STATE'
    result = machine.run(dpkg_query=DPKG, apt_get=log, sudo='shift; "$@"')
    assert result.returncode == 0, result.stderr
    calls = machine.log.read_text().splitlines()
    assert len(calls) == 2 and calls[0].endswith("update")
    assert calls[1].startswith("noninteractive") and " -y " in calls[1] and calls[1].endswith("ninja-build")


def test_installation_that_installs_nothing_is_an_error(machine):
    result = machine.run(dpkg_query=DPKG, apt_get="", sudo='shift; "$@"')
    assert result.returncode == 1 and "still missing" in result.stderr


@pytest.mark.parametrize("fakes", [{}, {"sudo": "exit 1"}])
def test_without_root_and_sudo_the_missing_packages_are_named(machine, fakes):
    result = machine.run(dpkg_query=DPKG, apt_get="echo used >> $LOG", as_nobody=True, **fakes)
    assert result.returncode == 1
    assert "needs root" in result.stderr and "\n  ninja-build\n" in result.stderr
    assert not machine.log.exists()


def test_without_root_sudo_is_used_if_it_asks_nothing(machine):
    result = machine.run(dpkg_query=DPKG, apt_get="", sudo='[[ $1 == -n ]] || exit 7; echo "$*"; shift; "$@"', true="", as_nobody=True)
    assert "sudo" not in result.stderr
    assert "-n env DEBIAN_FRONTEND=noninteractive" in result.stdout


def test_unknown_group_and_option_are_refused(machine):
    assert machine.run("--with", "nonsense", dpkg_query=ALL).returncode == 2
    assert machine.run("--nonsense", dpkg_query=ALL).returncode == 2
    assert machine.run("--with", dpkg_query=ALL).returncode == 2


def test_groups_add_their_packages(machine):
    bare = 'for p in "${@:4}"; do [[ $p == chromium || $p == clang* ]] || echo "installed $p"; done'
    assert machine.run(dpkg_query=bare).returncode == 0
    result = machine.run("--with", "clang", "--with", "browser", dpkg_query=bare)
    assert result.returncode == 1
    assert "clang-format" in result.stderr and "chromium" in result.stderr
