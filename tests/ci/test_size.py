"""ci/size counts what git keeps, by kind and folder."""
import json
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture
def tree(tmp_path):
    for name, lines in {"ci/size": None, "kernel/a.cpp": 3, "kernel/a.hpp": 2, "cases/b.md": 5, "cases/b.svg": 1, "ci/tool": 4,
                        "reports/c.py": 7, "kernel/not_kept.cpp": 9}.items():
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        shebang = "#!/usr/bin/env python3" if name == "ci/tool" else "x"
        path.write_text((ROOT / "ci/size").read_text() if lines is None else f"{shebang}\n" + "x\n" * (lines - 1))
    for command in (["init", "-q"], ["add", "kernel/a.cpp", "kernel/a.hpp", "cases", "ci/tool", "reports"]):
        subprocess.run(["git", "-C", tmp_path, *command], check=True)
    return tmp_path


def test_lines_by_folder_and_kind(tree):
    made = subprocess.run([sys.executable, tree / "ci/size", "--json", "--files", "1"], stdout=subprocess.PIPE, check=True)
    document = json.loads(made.stdout)
    assert document["folders"] == {"kernel": {"C++": 5}, "cases": {"Markdown": 5, "SVG": 1}, "ci": {"Python": 4}, "reports": {"Python": 7}}
    assert document["total"] == {"C++": 5, "Markdown": 5, "SVG": 1, "Python": 11}
    assert document["longest"] == [{"file": "reports/c.py", "lines": 7}]
