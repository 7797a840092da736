"""Killed at any moment, no space, no right to write, two at once, files of the previous version: nothing is lost or half there."""
import base64
import contextlib
import gzip
import json
import os
import platform
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from contract import ROOT, children_of, edited, wait_for_end

sys.path.insert(0, str(ROOT / "reports"))
from plumbline import reader  # noqa: E402

RUN = ("run", "two-disks", "--cells", 10, "--frames", 40)
NOBODY = 65534
STORED = ROOT / "tests/reports/stored/two-disks.format-1.h5.gz.base64"


def start(plumbline, *arguments, **options):
    return subprocess.Popen(plumbline.command(*arguments), cwd=plumbline.folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, encoding="utf-8", **options)


def check_whole(folder):
    """Every file of a final name is whole, and all that a list of frames names is there. Names of the others."""
    parts = []
    for path in sorted(Path(folder).rglob("*")):
        if path.is_dir():
            continue
        if path.name.endswith(".part"):
            parts.append(path.name)
        elif path.suffix == ".h5":
            reader.load(path)
        elif path.suffix == ".hdf":
            reader.check_seal(path)
        elif path.suffix == ".series":
            for entry in json.loads(path.read_text(encoding="utf-8"))["files"]:
                reader.check_seal(path.with_name(entry["name"]))
        elif path.suffix in (".js", ".css"):
            assert path.read_text(encoding="utf-8").rstrip().endswith(("}", ";", ")", "]")), path
        elif path.suffix == ".webp":
            content = path.read_bytes()
            assert content.startswith(b"RIFF") and int.from_bytes(content[4:8], "little") + 8 == len(content), path
        elif path.suffix in (".json", ".html", ".xml"):
            assert path.read_text(encoding="utf-8").rstrip().endswith(("}", "]", "</html>", "</testsuite>")), path
        else:
            raise AssertionError(f"{path}: who wrote this?")
    return parts


# --- killed ---------------------------------------------------------------------------------------


def kill_while_files_come(process, folder, number):
    """kill -9 as soon as there are so many files, whole or not; the later ones meet a writer at work."""
    limit = time.monotonic() + 60
    while process.poll() is None and time.monotonic() < limit:
        if sum(path.is_file() for path in folder.rglob("*")) >= number:
            break
    process.kill()
    process.communicate()


@pytest.mark.parametrize("number", [1, 2, 9, 23, 41])
def test_run_killed_while_it_writes(plumbline, number):
    results = plumbline.folder / "results"
    kill_while_files_come(start(plumbline, *RUN, "--json", "results/run.json"), results, number)
    check_whole(results)
    again = plumbline(*RUN, "--json", "results/run.json")
    assert again.code == 0, again.err
    assert check_whole(results) == [], "what the dead process left is cleared away"
    assert len(list(results.rglob("*.hdf"))) == 40 and len(list(results.rglob("*.series"))) == 1


@pytest.mark.parametrize("number", [1, 4, 7])
def test_verify_killed_while_it_writes(plumbline, number):
    results = plumbline.folder / "results"
    arguments = ("verify", "bar-riemann", "--tier", "quick")
    kill_while_files_come(start(plumbline, *arguments), results, number)
    check_whole(results)
    assert plumbline(*arguments, "--reuse").code == 0
    assert check_whole(results) == []


def render(folder, **options):
    command = [sys.executable, "-B", str(ROOT / "reports/render.py"), "results", "page"]
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", **options)


EARLIER = "an earlier page</html>"


@pytest.fixture
def two_cases(plumbline):
    """Results of two cases, which the report draws side by side, and a page of an earlier report."""
    for case in ("sod", "bar-riemann"):
        assert plumbline("run", case, "--cells", 20).code in (0, 1)
    page = plumbline.folder / "page/index.html"
    page.parent.mkdir()
    page.write_text(EARLIER, encoding="utf-8")
    return plumbline.folder


def drawing(folder):
    """A report at work, and the processes that draw for it: none where one processor draws one case after the other."""
    process = render(folder)
    limit = time.monotonic() + 60
    while not (children := children_of(process)) and process.poll() is None and time.monotonic() < limit:
        time.sleep(0.005)
    return process, children


def test_killed_report_leaves_the_page_that_was_there(two_cases):
    process, children = drawing(two_cases)
    process.kill()
    process.communicate()
    wait_for_end(children)
    assert (two_cases / "page/index.html").read_text(encoding="utf-8") == EARLIER
    assert check_whole(two_cases / "page") == []


def test_report_whose_drawing_process_is_killed_says_so(two_cases):
    process, children = drawing(two_cases)
    if not children:
        process.communicate()
        pytest.skip("one processor: nothing is drawn side by side")
    os.kill(children[0], signal.SIGKILL)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 4 and "was killed" in said, said
    assert (two_cases / "page/index.html").read_text(encoding="utf-8") == EARLIER


def test_report_clears_away_what_a_killed_one_left(two_cases):
    """As far as it can know: of another machine's processes it cannot."""
    gone = subprocess.Popen(["true"])
    gone.wait()
    mine, foreign = (two_cases / f"page/index.html.{host}-{gone.pid}.part" for host in (platform.node(), "elsewhere"))
    for part in (mine, foreign):
        part.write_text("<html>", encoding="utf-8")
    process = render(two_cases)
    _, said = process.communicate(timeout=120)
    assert process.returncode == 0, said
    assert check_whole(two_cases / "page") == [foreign.name]
    assert "bar-riemann" in (two_cases / "page/index.html").read_text(encoding="utf-8")


# --- no space --------------------------------------------------------------------------------------


def no_room(size):
    """For a child: no file may grow beyond so many bytes, and writing more fails as it does on a full disk."""
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
    return limit


@pytest.mark.parametrize("size", [0, 600, 5000, 40000])
def test_no_room_for_a_result(plumbline, size):
    process = start(plumbline, *RUN, preexec_fn=no_room(size))
    _, said = process.communicate(timeout=60)
    assert process.returncode == 4 and "two-disks-default-10" in said and "File too large" in said, said
    assert plumbline.files(".") == [], "nothing half-written"


def test_no_room_for_a_document(plumbline):
    """The one that was there stays."""
    (plumbline.folder / "list.json").write_text("{}", encoding="utf-8")
    process = start(plumbline, "list", "--json", "list.json", preexec_fn=no_room(3000))
    _, said = process.communicate(timeout=60)
    assert process.returncode == 4 and "list.json" in said and "File too large" in said
    assert plumbline.files(".") == ["list.json"] and (plumbline.folder / "list.json").read_text(encoding="utf-8") == "{}"


def test_device_without_room(plumbline):
    result = plumbline("list", "--json", "/dev/full")
    assert result.code == 4 and "/dev/full" in result.err and "No space left on device" in result.err


@contextlib.contextmanager
def small_disk(folder):
    folder.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=96k", "tmpfs", str(folder)], capture_output=True, check=False).returncode != 0:
        pytest.skip("mounting a small disk needs root")
    try:
        yield folder
    finally:
        subprocess.run(["umount", str(folder)], check=True)


def test_disk_that_fills_up(plumbline):
    with small_disk(plumbline.folder / "results") as results:
        result = plumbline(*RUN)
        assert result.code == 4 and "results/" in result.err and "No space left on device" in result.err
        assert check_whole(results) == [] and not list(results.rglob("*.series"))


@pytest.mark.parametrize("jobs", [1, 2])
def test_no_room_for_a_sweep(plumbline, jobs):
    """Each run that found no space is told; with space, the next call makes them."""
    plan = {"sweep": {"case": "sod", "cells": [10, 20], "ppc": [4, 8]}}
    (plumbline.folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    call = ("sweep", "--from", "plan.json", "--jobs", jobs)
    process = start(plumbline, *call, preexec_fn=no_room(8000))
    out, said = process.communicate(timeout=60)
    assert process.returncode == 4 and out.count("File too large") == 4 and "0 made, 4 failed" in out, out + said
    assert check_whole(plumbline.folder / "results") == [] and not list((plumbline.folder / "results").glob("*.h5"))
    assert "4 made, 0 failed" in plumbline(*call).out


def test_no_room_for_the_page(two_cases):
    process = render(two_cases, preexec_fn=no_room(50_000))
    _, said = process.communicate(timeout=120)
    assert process.returncode == 4 and "too large" in said, said
    assert (two_cases / "page/index.html").read_text(encoding="utf-8") == EARLIER
    assert check_whole(two_cases / "page") == []


# --- no right to write ----------------------------------------------------------------------------


def as_nobody():
    if os.geteuid() == 0:
        os.setgroups([])
        os.setgid(NOBODY)
        os.setuid(NOBODY)


@pytest.fixture
def read_only(plumbline):
    folder = plumbline.folder
    for above in [folder, *folder.parents][:3]:
        above.chmod(above.stat().st_mode | 0o555)   # pytest's own folders are for one user
    (folder / "results").mkdir()
    (folder / "results").chmod(0o555)
    probe = subprocess.run([plumbline.executable, "--version"], preexec_fn=as_nobody, capture_output=True, check=False)
    if probe.returncode != 0:
        pytest.skip("the executable is not for every user")
    return plumbline


@pytest.mark.parametrize("arguments", [RUN, ("verify", "bar-riemann"), ("converge", "sod", "--cells", "10,20"), ("sweep", "bar-riemann")],
                         ids=lambda arguments: arguments[0])
def test_read_only_folder(read_only, arguments):
    process = start(read_only, *arguments, preexec_fn=as_nobody)
    _, said = process.communicate(timeout=300)
    assert process.returncode == 4 and "results" in said, said
    assert read_only.files("results") == []


# --- no file at all -------------------------------------------------------------------------------


@pytest.mark.parametrize("arguments", [("score", "sod", "--result"), ("tolerances",), ("sweep", "--plan", "-", "--from"),
                                       ("verify", "--integrator", "usl", "--core", "--against")], ids=lambda arguments: arguments[0])
@pytest.mark.parametrize("what", ["pipe", "folder", "device", "loop"])
def test_what_is_no_file_is_not_waited_for(plumbline, arguments, what):
    path = plumbline.folder / "in"
    if (what, arguments[0]) in (("pipe", "sweep"), ("loop", "verify")):
        pytest.skip("a shell makes pipes for plans, and what is not there may be the name of an integrator")
    if what == "pipe":
        os.mkfifo(path)
    elif what == "folder":
        path.mkdir()
    else:
        path.symlink_to("/dev/zero" if what == "device" else "in")
    plans = "--plan" in arguments  # takes no --json
    result = plumbline(*arguments, "in", json=not plans, timeout=60)
    assert result.code == 4 and result.err.startswith("plumbline: in: "), result.text
    if not plans:
        assert result.json("error")["error"]["key"] == "in"


def test_no_folder_for_temporary_files(plumbline):
    """The gate that needs one says so in our words, and the others are judged."""
    result = plumbline("verify", "mms-ring", json=True, environment={"TMPDIR": str(plumbline.folder / "none")})
    invalid = [gate for gate in result.json("verify")["gates"] if gate["verdict"] == "INVALID"]
    assert result.code == 1 and len(invalid) == 1 and invalid[0]["id"].endswith("restart"), result.text
    assert "no folder for temporary files" in json.dumps(invalid[0])


def test_plan_from_a_pipe(plumbline):
    """As bash makes one of `--from <(program)`."""
    reader, writer = os.pipe()
    os.write(writer, b'{"sweep": {"case": "sod", "cells": [4]}}')
    os.close(writer)
    process = subprocess.run(plumbline.command("sweep", "--plan", "-", "--from", f"/dev/fd/{reader}"), cwd=plumbline.folder, pass_fds=(reader,),
                             capture_output=True, timeout=60, check=False)
    os.close(reader)
    assert process.returncode == 0 and json.loads(process.stdout)["plan"] == 1, process.stderr


# --- two at once ----------------------------------------------------------------------------------


def test_the_same_run_many_times_at_once(plumbline):
    running = [start(plumbline, *RUN) for _ in range(4)]
    for process in running:
        _, said = process.communicate(timeout=300)
        assert process.returncode == 0, said
    results = plumbline.folder / "results"
    assert check_whole(results) == [] and len(list(results.glob("*.h5"))) == 1 and len(list(results.rglob("*.hdf"))) == 40


# --- the previous version -------------------------------------------------------------------------


@pytest.fixture
def old_run(plumbline):
    """A folder with a run of format 1 under the name that the same run has today."""
    plan = plumbline.folder / "plan.json"
    plan.write_text(json.dumps({"runs": [{"case": "two-disks", "settings": {"cells": 4}}]}), encoding="utf-8")
    assert plumbline("sweep", "--from", "plan.json").code == 0
    (path,) = (plumbline.folder / "results").glob("two-disks-*.h5")
    path.write_bytes(gzip.decompress(base64.b64decode(STORED.read_bytes())))
    assert reader.load(path).format == 1
    return path


def test_sweep_makes_anew_what_an_older_version_made(plumbline, old_run):
    result = plumbline("sweep", "--from", "plan.json")
    assert result.code == 0 and "0 stored already, 1 made" in result.out, result.text
    assert reader.load(old_run).format == 2


def test_the_page_shows_what_an_older_version_made(plumbline, old_run):
    process = render(plumbline.folder)
    _, said = process.communicate(timeout=300)
    assert process.returncode == 0, said
    assert old_run.name in (plumbline.folder / "page/cases/two-disks.html").read_text(encoding="utf-8")


def test_diff_takes_an_older_version(plumbline, old_run):
    shutil.copytree(plumbline.folder / "results", plumbline.folder / "base")
    result = plumbline("diff", "base", "results", json=True)
    assert result.code in (0, 1, 2), result.text
    assert "damaged" not in result.err


def test_a_newer_version_is_told(plumbline):
    assert plumbline("verify", "bar-riemann").code == 0
    verdicts = next((plumbline.folder / "results").glob("study-*.h5"))
    with edited(verdicts) as file:
        file.attrs.modify("plumbline_format", 99)
    with pytest.raises(reader.NewerFormat, match="format 99"):
        reader.load(verdicts)
    shutil.copytree(plumbline.folder / "results", plumbline.folder / "base")
    result = plumbline("diff", "base", "results")
    assert verdicts.name in result.text and "newer" in result.text, result.text
