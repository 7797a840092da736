"""plumbline diff: what it says of two folders that the executable wrote itself, one of them doctored."""
import json
import shutil

import numpy
import pytest
from contract import Plumbline, edited


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """A folder with the results of one quick case."""
    folder = tmp_path_factory.mktemp("written")
    assert Plumbline(folder)("verify", "spring-mass", "--results", "base").code == 0
    return folder / "base"


@pytest.fixture
def pair(written, plumbline):
    """The same folder twice, as `base` and `new`."""
    for name in ("base", "new"):
        shutil.copytree(written, plumbline.folder / name)
    return plumbline


def edit(file, path, change):
    with edited(file) as stored:
        document = json.loads(stored[path][()].decode())
        change(document)
        attributes = dict(stored[path].attrs)
        del stored[path]
        stored[path] = numpy.bytes_(json.dumps(document).encode() + b"\0")
        stored[path].attrs.update(attributes)


def one(plumbline, pattern):
    return sorted((plumbline.folder / "new").glob(pattern))[0]


def test_identical_folders(pair):
    result = pair("diff", "base", "new", json=True)
    document = result.json()
    assert result.code == 0 and document["nothing_changed"] and document["change"] == "same"
    assert document["baseline"]["executed"] == document["results"]["executed"] > 0
    assert {"verdict", "error"} <= {finding["kind"] for finding in document["findings"]}
    assert pair("diff", "base", "new").out.splitlines()[-1] == "nothing changed"


def test_gate_that_turns_red_and_one_that_is_widened(pair):
    def change(document):
        document["gates"][0]["verdict"] = "FAIL"
        wide = next(gate for gate in document["gates"][1:] if gate["expected"]["high"])
        wide["expected"]["high"] *= 1.01
    edit(one(pair, "verdicts-*.h5"), "verdicts", change)
    result = pair("diff", "base", "new", json=True)
    counts = result.json()["counts"]
    assert result.code == 1 and counts["worse"] == 1 and counts["widened"] == 1
    text = pair("diff", "base", "new").out
    assert text.index("WORSE (1)") < text.index("WIDENED") < text.index("same (") and "PASS -> FAIL" in text
    assert pair("diff", "base", "new", "--allow", "widened").code == 1, "what is worse cannot be allowed"


def test_error_that_grew(pair):
    def change(document):
        for measure in document["levels"][-1]["measures"].values():
            if measure["error"]:
                measure["error"] *= 1.5
    edit(one(pair, "study-*.h5"), "study", change)
    result = pair("diff", "base", "new", json=True)
    worse = [finding for finding in result.json()["findings"] if finding["change"] == "worse"]
    assert result.code == 1 and worse and all(finding["kind"] in ("error", "constant") for finding in worse)
    assert any(finding["size"] == pytest.approx(0.5) for finding in worse)


def test_study_that_is_gone(pair):
    one(pair, "study-*.h5").unlink()
    result = pair("diff", "base", "new", json=True)
    assert result.code == 1 and result.json()["change"] == "missing"
    assert pair("diff", "base", "new", "--allow", "missing").code == 0
    assert pair("diff", "new", "base").code == 0, "what is new is not red"


def test_damaged_file_is_named(pair):
    file = one(pair, "study-*.h5")
    file.write_bytes(file.read_bytes()[:900])
    result = pair("diff", "base", "new", json=True)
    assert result.code == 4
    assert [entry["file"] for entry in result.json()["results"]["damaged"]] == [file.name]
    assert file.name in pair("diff", "base", "new").out


def test_wrong_calls(pair):
    missing = pair("diff", "base", "mew", json=True)
    assert missing.code == 2 and missing.json("error")["error"]["nearest"] == ["new"]
    (pair.folder / "empty").mkdir()
    assert pair("diff", "base", "empty").code == 2
    refused = pair("diff", "base", "new", "--allow", "worse")
    assert refused.code == 2 and "inconclusive, missing, widened" in refused.err
    assert pair("diff", "base").code == 2
