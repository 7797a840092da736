"""ci/release on a small tree: what it refuses and why, and that what it makes depends on the commit alone."""
import gzip
import hashlib
import io
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = ("-c", "user.name=Somebody", "-c", "user.email=somebody@example.org", "-c", "commit.gpgsign=false", "-c", "tag.gpgsign=false")
COMMIT_TIME = 1767225600

READY = {
    "CMakeLists.txt": "project(Plumbline VERSION 1.2.0 LANGUAGES CXX)\n",
    "CITATION.cff": "cff-version: 1.2.0\nversion: 1.2.0\ndate-released: 2026-01-31\n",
    "CHANGELOG.md": "# Changes\n\n## 1.2.0 - 2026-01-31\n\n- Second entry.\n- Third entry,\n  of two lines.\n\n## 1.1.0\n\n- First entry.\n",
    ".gitattributes": "ci/cmake/archived_commit.txt export-subst\n",
}


def git(root, *arguments, **environment):
    dates = {"GIT_COMMITTER_DATE": f"{COMMIT_TIME} +0100", "GIT_AUTHOR_DATE": f"{COMMIT_TIME} +0100"}
    return subprocess.run(["git", *SETTINGS, "-C", root, *arguments], check=True, capture_output=True, text=True,
                          env={**os.environ, **dates, **environment}).stdout.strip()  # fmt: skip


@pytest.fixture
def tree(tmp_path):
    """Makes the small tree, ready for a release but for the files given (None: taken away), and commits it."""
    def build(files=()):
        root = tmp_path / "tree"
        root.mkdir()
        for name in ("ci/release", "ci/cmake/archived_commit.txt", "ci/packaging/spack/package.py", "ci/packaging/conda/recipe.yaml"):
            (root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, root / name)
        for name, text in {**READY, **dict(files)}.items():
            if text is not None:
                (root / name).write_text(text, encoding="utf-8")
        git(root, "init", "-q")
        git(root, "add", "-A")
        git(root, "commit", "-q", "-m", "All of it")
        return root
    return build


def release(root, *arguments, **options):
    return subprocess.run([sys.executable, root / "ci/release", *arguments], capture_output=True, text=True, **options)


def test_a_ready_tree_is_checked_and_nothing_is_written(tree):
    root = tree()
    result = release(root, "--check")
    assert result.returncode == 0 and "1.2.0 is ready" in result.stdout, result.stderr
    assert git(root, "status", "--porcelain", "--ignored") == ""


@pytest.mark.parametrize("files, complaint", [
    ({"CMakeLists.txt": "project(Plumbline)\n"}, "CMakeLists.txt: project(...) names no VERSION"),
    ({"CMakeLists.txt": "project(Plumbline VERSION 1.2)\n"}, "CMakeLists.txt: VERSION 1.2 is not three numbers"),
    ({"CMakeLists.txt": None}, "CMakeLists.txt: No such file"),
    ({"CITATION.cff": "cff-version: 1.2.0\nversion: 1.1.0\ndate-released: 2026-01-31\n"}, "CITATION.cff: version 1.1.0, but CMakeLists.txt states 1.2.0"),
    ({"CITATION.cff": "cff-version: 1.2.0\ndate-released: 2026-01-31\n"}, "CITATION.cff: version None"),
    ({"CITATION.cff": "version: 1.2.0\n"}, "CITATION.cff: date-released None, but CHANGELOG.md dates 1.2.0 2026-01-31"),
    ({"CITATION.cff": "version: 1.2.0\ndate-released: 2026-01-30\n"}, "CITATION.cff: date-released 2026-01-30"),
    ({"CHANGELOG.md": None}, "CHANGELOG.md: No such file"),
    ({"CHANGELOG.md": "## 1.1.0\n\n- An entry.\n"}, "CHANGELOG.md: no section of 1.2.0 before all others, expected '## 1.2.0 - YYYY-MM-DD'"),
    ({"CHANGELOG.md": "## 1.1.0\n\n- One.\n\n## 1.2.0 - 2026-01-31\n\n- One.\n"}, "CHANGELOG.md: no section of 1.2.0 before all others"),
    ({"CHANGELOG.md": "## 1.2.0\n\n- An entry.\n"}, "CHANGELOG.md: heading '## 1.2.0' has no date"),
    ({"CHANGELOG.md": "## 1.2.0 - 2026-02-30\n\n- An entry.\n"}, "CHANGELOG.md: heading '## 1.2.0 - 2026-02-30' has no date"),
    ({"CHANGELOG.md": "## 1.2.0 - 2999-01-31\n\n- An entry.\n"}, "CHANGELOG.md: the date of 1.2.0, 2999-01-31, is in the future"),
    ({"CHANGELOG.md": "## 1.2.0 - 2026-01-31\n\n- One.\n\n## 1.1.0 - 2026-02-01\n\n- One.\n"}, "is before that of 1.1.0, 2026-02-01"),
    ({"CHANGELOG.md": "## 1.2.0 - 2026-01-31\n\nNothing to say.\n"}, "CHANGELOG.md: the section of 1.2.0 has no entry"),
    ({"CHANGELOG.md": "## Unreleased\n\n- One.\n- Two.\n\n" + READY["CHANGELOG.md"]}, "CHANGELOG.md: 'Unreleased' holds 2 entries"),
])
def test_what_is_not_ready_is_refused_with_the_reason(files, complaint, tree):
    root = tree(files)
    result = release(root)
    assert result.returncode == 1 and complaint in result.stderr
    assert "Traceback" not in result.stderr and not (root / "build").exists()


def test_all_reasons_are_named_at_once(tree):
    result = release(tree({"CITATION.cff": "version: 1.1.0\n", "CHANGELOG.md": "## 1.2.0\n"}), "--check")
    assert len(result.stderr.splitlines()) == 3


@pytest.mark.parametrize("change", ["CITATION.cff", "a_new_file"])
def test_a_tree_with_changes_is_refused(change, tree):
    root = tree()
    with (root / change).open("a", encoding="utf-8") as file:
        file.write("# more\n")
    result = release(root)
    assert result.returncode == 1 and f"the tree is not clean: {change}" in result.stderr


def test_a_version_that_was_released_is_refused(tree):
    root = tree()
    git(root, "tag", "-a", "v1.2.0", "-m", "Released")
    assert release(root, "--check").returncode == 0   # the tag is this commit's
    git(root, "commit", "-q", "--allow-empty", "-m", "Later")
    result = release(root, "--check")
    assert result.returncode == 1 and "the tag v1.2.0 stands at another commit" in result.stderr


def test_what_is_no_checkout_is_refused(tree, tmp_path):
    root = tree()
    shutil.rmtree(root / ".git")
    result = release(root, "--check", env={**os.environ, "GIT_CEILING_DIRECTORIES": str(tmp_path)})
    assert result.returncode == 1 and "git" in result.stderr and "Traceback" not in result.stderr


@pytest.mark.parametrize("arguments", [["--chekc"], ["--check", "--version"], ["--homepage", "example.org"], ["--output"]])
def test_wrong_calls(arguments, tree):
    result = release(tree(), *arguments)
    assert result.returncode == 2 and "ci/release" in result.stderr


def test_archive_checksum_and_notes(tree, tmp_path):
    root = tree()
    result = release(root, "--output", tmp_path / "out")
    assert result.returncode == 0, result.stderr
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == ["plumbline-1.2.0.md", "plumbline-1.2.0.tar.gz", "plumbline-1.2.0.tar.gz.sha256"]
    subprocess.run(["sha256sum", "--check", "--strict", "plumbline-1.2.0.tar.gz.sha256"], cwd=tmp_path / "out", check=True)
    assert (tmp_path / "out/plumbline-1.2.0.md").read_text(encoding="utf-8") == "- Second entry.\n- Third entry,\n  of two lines.\n"
    assert "git tag --annotate v1.2.0" in result.stdout


def test_the_archive_holds_the_commit_and_nothing_of_the_machine(tree, tmp_path):
    root = tree()
    assert release(root, "--archive", tmp_path / "a.tar.gz").returncode == 0
    content = (tmp_path / "a.tar.gz").read_bytes()
    with tarfile.open(fileobj=io.BytesIO(content)) as archive:
        members = archive.getmembers()
        commit = archive.extractfile("plumbline-1.2.0/ci/cmake/archived_commit.txt").read().decode().strip()
    names = {member.name for member in members if member.isfile()}
    assert names == {f"plumbline-1.2.0/{name}" for name in git(root, "ls-files").splitlines()}
    assert {(member.uid, member.gid, member.uname, member.gname, member.mtime) for member in members} == {(0, 0, "root", "root", COMMIT_TIME)}
    assert {oct(member.mode) for member in members} == {"0o644", "0o755"}
    assert commit == git(root, "rev-parse", "HEAD")


def test_every_clone_makes_the_same_archive(tree, tmp_path):
    """Another folder, another user's settings, and files of another day and mode."""
    root = tree()
    subprocess.run(["git", "clone", "-q", root, tmp_path / "clone"], check=True)
    settings = tmp_path / "settings"
    settings.write_text(f"[tar]\n  umask = 0077\n[core]\n  autocrlf = true\n  attributesFile = {tmp_path}/attributes\n", encoding="utf-8")
    (tmp_path / "attributes").write_text("CITATION.cff export-ignore\n", encoding="utf-8")
    os.utime(tmp_path / "clone/CITATION.cff", (0, 0))
    assert release(root, "--archive", tmp_path / "one.tar.gz").returncode == 0
    other = release(tmp_path / "clone", "--archive", tmp_path / "two.tar.gz", env={**os.environ, "GIT_CONFIG_GLOBAL": str(settings), "TZ": "Asia/Tokyo"})
    assert other.returncode == 0, other.stderr
    one, two = ((tmp_path / name).read_bytes() for name in ("one.tar.gz", "two.tar.gz"))
    assert gzip.decompress(one) == gzip.decompress(two)
    assert one == two


def test_recipes_name_the_archive_that_was_made(tree, tmp_path):
    result = release(tree(), "--output", tmp_path / "out", "--homepage", "https://example.org/plumbline/")
    assert result.returncode == 0, result.stderr
    checksum = hashlib.sha256((tmp_path / "out/plumbline-1.2.0.tar.gz").read_bytes()).hexdigest()
    for recipe in ("spack/package.py", "conda/recipe.yaml"):
        text = (tmp_path / "out" / recipe).read_text(encoding="utf-8")
        assert checksum in text and "https://example.org/plumbline/releases/download/v" in text and not re.search(r"@[A-Z0-9]+@", text)


def test_an_unpacked_archive_knows_its_commit(tree, tmp_path):
    """The build of an archive, inside the checkout of another project, states the commit of the archive."""
    root = tree()
    release(root, "--archive", tmp_path / "a.tar.gz")
    other = tmp_path / "other"
    other.mkdir()
    git(other, "init", "-q")
    git(other, "commit", "-q", "--allow-empty", "-m", "Of another project")
    with tarfile.open(tmp_path / "a.tar.gz") as archive:
        archive.extractall(other)
    for source, commit in ((other / "plumbline-1.2.0", git(root, "rev-parse", "HEAD")), (root, git(root, "rev-parse", "HEAD"))):
        output = tmp_path / "build_info.hpp"
        subprocess.run(["cmake", f"-DSOURCE={source}", f"-DTEMPLATE={ROOT}/cases/harness/results/build_info.hpp.in", f"-DOUTPUT={output}", "-DGIT=git",
                        "-P", ROOT / "ci/cmake/build_info.cmake"], check=True)  # fmt: skip
        text = output.read_text(encoding="utf-8")
        assert f'git = "{commit}"' in text and "dirty = false" in text


def test_this_tree_states_one_version():
    version = release(ROOT, "--version").stdout.strip()
    assert re.search(rf"^version: {re.escape(version)}$", (ROOT / "CITATION.cff").read_text(encoding="utf-8"), re.MULTILINE)
    assert re.search(rf"^## {re.escape(version)}( - .*)?$", (ROOT / "CHANGELOG.md").read_text(encoding="utf-8"), re.MULTILINE)
    for path in (ROOT / "ci/packaging").rglob("*"):
        if path.is_file():
            assert version not in path.read_text(encoding="utf-8"), f"{path} repeats the version, which CMakeLists.txt states"
