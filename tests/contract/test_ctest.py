"""What ctest makes of a case: runs as a fixture of the verdict, and its numbers and picture in the XML for CDash."""
import base64
import http.server
import json
import os
import subprocess
import sys
import threading
import xml.etree.ElementTree as Xml

import h5py
import pytest
from contract import ROOT

CASE = "shear-decay"
DART = "BuildDirectory: {0}\nSourceDirectory: {0}\nSite: here\nBuildName: test\nNightlyStartTime: 00:00:00 UTC\n"


@pytest.fixture
def entries(plumbline):
    """A folder that ctest takes for a build, with the entries of all cases and results of its own."""
    folder = plumbline.folder
    (folder / "DartConfiguration.tcl").write_text(DART.format(folder))
    subprocess.run([os.environ["CMAKE"], f"-DPLUMBLINE={plumbline.executable}", f"-DRESULTS={folder}/results", f"-DPYTHON={sys.executable}",
                    f"-DMEASUREMENTS={ROOT}/ci/measurements.py", f"-DOUTPUT={folder}/CTestTestfile.cmake",
                    "-P", str(ROOT / "ci/cmake/discover_cases.cmake")], check=True)
    return folder


def ctest(folder, *arguments):
    command = [os.path.join(os.path.dirname(os.environ["CMAKE"]), "ctest"), "--test-dir", str(folder), *arguments]
    return subprocess.run(command, capture_output=True, text=True, timeout=300, cwd=folder)


def dashboard(folder):
    """{entry: {name of a measurement: its element}} and {entry: status} of the last `ctest -T Test`."""
    (path,) = folder.glob("Testing/*/Test.xml")
    found = {test.findtext("Name"): test for test in Xml.parse(path).getroot().iter("Test") if test.find("Name") is not None}
    return {name: {m.get("name"): m for m in test.iter("NamedMeasurement")} for name, test in found.items()}, {
        name: test.get("Status") for name, test in found.items()}


def test_one_entry_makes_the_runs_and_one_judges_them(entries):
    listed = ctest(entries, "-N", "-R", rf"^case\.{CASE}\.quick$").stdout
    assert listed.index(f"runs.{CASE}.quick") < listed.index(f"case.{CASE}.quick") and "Total Tests: 2" in listed


def test_numbers_and_picture_reach_the_dashboard(entries):
    done = ctest(entries, "-V", "-T", "Test", "-R", rf"^case\.{CASE}\.quick$")
    assert done.returncode == 0, done.stdout
    assert " 0 made" in done.stdout, "the verdict takes the runs of its fixture"
    measurements, status = dashboard(entries)
    assert status == {f"runs.{CASE}.quick": "passed", f"case.{CASE}.quick": "passed"}
    found = measurements[f"case.{CASE}.quick"]
    studies = {}
    for path in (entries / "results/quick").glob(f"study-{CASE}-*.h5"):
        with h5py.File(path) as file:
            study = json.loads(file["study"][()])
        studies[study["id"]] = study
    assert studies
    for name, study in studies.items():
        for measure, fit in study["measures"].items():
            error = study["levels"][-1]["measures"][measure]["error"]
            for quantity, wanted in (("order", fit["order"]), ("error", error)):
                element = found.get(f"{name}.{measure}.{quantity}")
                assert (element is None) == (wanted is None)
                if wanted is not None:
                    assert element.get("type") == "numeric/double" and float(element.findtext("Value")) == wanted
        assert float(found[f"{name}.cost_s"].findtext("Value")) > 0
    assert float(found["gates.PASS"].findtext("Value")) > 0
    picture = found["errors"]
    assert picture.get("type") == "image/png" and base64.b64decode(picture.findtext("Value"))[:8] == b"\x89PNG\r\n\x1a\n"


    assert "NamedMeasurement" in submitted(entries)


class FakeCdash(http.server.BaseHTTPRequestHandler):
    received = []

    def do_PUT(self):
        self.received.append(self.rfile.read(int(self.headers["Content-Length"])))
        answer = b"<cdash version='3.0'><status>OK</status><message></message><md5>0</md5></cdash>"
        self.send_response(200)
        self.send_header("Content-Length", str(len(answer)))
        self.end_headers()
        self.wfile.write(answer)

    def log_message(self, *_):
        pass


def submitted(folder):
    """What a server gets of the last `ctest -T Test` when its URL is set."""
    with http.server.HTTPServer(("127.0.0.1", 0), FakeCdash) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        with open(folder / "DartConfiguration.tcl", "a") as file:
            file.write(f"SubmitURL: http://127.0.0.1:{server.server_port}/submit.php?project=plumbline\n")
        done = ctest(folder, "-T", "Submit")
        server.shutdown()
    assert done.returncode == 0, done.stdout + done.stderr
    return b"".join(FakeCdash.received).decode()


def measured(entries, *command):
    return subprocess.run([sys.executable, "-B", str(ROOT / "ci/measurements.py"), "--results", str(entries), "--case", CASE,
                           "--picture", str(entries / "p.png"), "--", *command], capture_output=True, text=True, timeout=60)


@pytest.mark.parametrize("status", [0, 1, 3, 4, 130])
def test_the_verdict_keeps_its_exit_status(tmp_path, status):
    done = measured(tmp_path, sys.executable, "-c", f"import sys; print('said'); sys.exit({status})")
    assert done.returncode == status and "said" in done.stdout


def test_a_verdict_that_dies_is_no_success(tmp_path):
    done = measured(tmp_path, sys.executable, "-c", "import os; os.kill(os.getpid(), 11)")
    assert done.returncode == 128 + 11
