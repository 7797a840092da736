"""Each check of ci/ is shown to fail on a small tree with one fault, and to pass without it."""
import subprocess
import sys
from pathlib import Path

import pytest

CI = Path(__file__).resolve().parents[2] / "ci"

CLEAN = {
    "CMakeLists.txt": "project(Plumbline)\n",
    "kernel/grid.hpp": "#include <vector>\n#include <Eigen/Dense>\n",
    "kernel/step.cpp": '#include "kernel/grid.hpp"\n// v = p / m  [York 3.16-3.18]\n// x += v dt  [York 3.21, 3.22]\n',
    "kernel/CMakeLists.txt": "find_package(Eigen3 REQUIRED)  # never GSL\n",
    "reference/riemann.cpp": "#include <gsl/gsl_roots.h>\n// f(p)  [Toro 4.5]\n",
    "cases/harness/results/build_info.hpp.in": "// made by CMake\n",
    "cases/harness/results/results.cpp": '#include "build_info.hpp"\n#include <hdf5.h>\n#include <nlohmann/json.hpp>\n#include "kernel/grid.hpp"\n',
    "reports/render.py": "import json\nimport numpy as np\nimport matplotlib.pyplot as plt\n",
    "reports/plumbline/execution.py": "import subprocess\nfrom plumbline import reader\n",
    "reports/docs/build.py": "import subprocess\nimport sphinx.errors\n",
    "tests/kernel/step_test.cpp": "#include <gsl/gsl_math.h>\n// [York 3.16, 3.17] and [York 3.18]; [York 3.20-3.22]\n",
    "tests/reference/riemann_test.cpp": "// [Toro 4.5]\n",
}


@pytest.fixture
def tree(tmp_path):
    def build(files=()):
        for name, text in {**CLEAN, **dict(files)}.items():
            path = tmp_path / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        return tmp_path
    return build


def run(check, root, *options):
    return subprocess.run([sys.executable, str(CI / check), *options, str(root)], capture_output=True, text=True)


@pytest.mark.parametrize("check", ["check_includes", "check_equations", "check_text"])
def test_clean_tree_passes(check, tree):
    result = run(check, tree())
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize("name, text, complaint", [
    ("kernel/grid.hpp", "#include <gsl/gsl_math.h>\n", "kernel must not include GSL"),
    ("kernel/grid.hpp", "#include <hdf5.h>\n", "kernel must not include HDF5"),
    ("kernel/grid.hpp", "#include <H5Tpublic.h>\n", "kernel must not include HDF5"),
    ("kernel/grid.hpp", "#  include <nlohmann/json.hpp>\n", "kernel must not include json"),
    ("kernel/grid.hpp", "#include <fmt/core.h>\n", "kernel must not include fmt"),
    ("kernel/step.cpp", '#include "reference/riemann.hpp"\n', "kernel must not include reference"),
    ("kernel/step.cpp", '#include "cases/harness/description/case.hpp"\n', "kernel must not include cases"),
    ("kernel/step.cpp", '#include "grid.hpp"\n', "paths count from the source root"),
    ("kernel/step.cpp", '#include "kernel/gird.hpp"\n', "no such file"),
    ("kernel/step.cpp", "#include <mystery/header.h>\n", "not on the list"),
    ("kernel/CMakeLists.txt", "find_package(GSL REQUIRED)\n", "kernel must not link it"),
    ("reference/riemann.cpp", '#include "kernel/grid.hpp"\n', "reference must not include kernel"),
    ("reference/riemann.cpp", "#include <Eigen/Dense>\n", "reference must not include Eigen"),
    ("cases/harness/results/results.cpp", "#include <gsl/gsl_math.h>\n", "cases must not include GSL"),
    ("cases/catalog/gas/sod.cpp", "#include <gsl/gsl_math.h>\n", "cases must not include GSL"),
    ("cases/CMakeLists.txt", "target_link_libraries(x PRIVATE GSL::gsl)\n", "cases must not link it"),
    ("reports/render.py", "import ctypes\n", "reports read result files only"),
    ("reports/render.py", "from kernel import step\n", "reports read result files only"),
    ("reports/render.py", "def f():\n    import subprocess\n", "reports read result files only"),
    ("reports/plumbline/plots.py", "import subprocess\n", "reports read result files only"),
    ("reports/render.py", "import sphinx.errors\n", "reports read result files only"),
    ("reports/fast.cpp", "\n", "no compiled code"),
])
def test_forbidden_include_is_found(name, text, complaint, tree):
    result = run("check_includes", tree(files={name: text}))
    assert result.returncode == 1
    assert name in result.stdout and complaint in result.stdout


def test_folders_that_include_each_other_are_found(tree):
    gas = "cases/catalog/gas/sod.hpp"
    one_way = {gas: '#include "cases/harness/verdict/gate.hpp"\n', "cases/harness/verdict/gate.hpp": "\n"}
    assert run("check_includes", tree(files=one_way)).returncode == 0
    result = run("check_includes", tree(files={**one_way, "cases/harness/verdict/gate.hpp": f'#include "{gas}"\n'}))
    assert result.returncode == 1 and "folders include each other" in result.stdout


@pytest.mark.parametrize("name, text, tag", [
    ("kernel/step.cpp", "// q  [York 4.10]\n", "York 4.10"),
    ("kernel/step.cpp", "// [York 3.16-3.19]\n", "York 3.19"),
    ("kernel/step.cpp", "// [York 3.22, 3.23]\n", "York 3.23"),
    ("reference/riemann.cpp", "double f;  // [Toro 4.6]\n", "Toro 4.6"),
    ("cases/catalog/gas/sod.cpp", "// [EC-APIC 3]\n", "EC-APIC 3"),
    ("cases/catalog/gas/sod.cpp", "// [Vaucorbeil et al. 41]\n", "Vaucorbeil et al. 41"),
])
def test_equation_without_test_is_found(name, text, tag, tree):
    result = run("check_equations", tree(files={name: text}))
    assert result.returncode == 1
    assert f"[{tag}] at {name}:" in result.stderr
    assert "NO TEST" in result.stdout
    assert "**no test**" in run("check_equations", tree(files={name: text}), "--markdown").stdout


def test_index_names_source_and_test_lines(tree):
    result = run("check_equations", tree(), "--markdown")
    assert "| York 3.17 | kernel/step.cpp:2 | tests/kernel/step_test.cpp:2 |" in result.stdout
    assert "| Toro 4.5 | reference/riemann.cpp:2 | tests/reference/riemann_test.cpp:1 |" in result.stdout


def test_code_that_looks_like_a_tag_is_none(tree):
    text = 'auto f = [A](int i) { return A[i]; };\n[[maybe_unused]] int b[3];  // range [0, 1), unit [m], [N 2](x)\n'
    assert run("check_equations", tree(files={"kernel/step.cpp": text})).returncode == 0


def test_tests_of_the_checks_count_for_no_equation(tree):
    files = {"kernel/step.cpp": "// [York 9.9]\n", "tests/ci/test_checks.py": "# [York 9.9]\n"}
    assert run("check_equations", tree(files=files)).returncode == 1


def test_backward_range_is_refused(tree):
    result = run("check_equations", tree(files={"kernel/step.cpp": "// [York 3.18-3.16]\n"}))
    assert result.returncode == 1 and "not a range" in result.stderr


@pytest.mark.parametrize("name, text, complaint", [
    ("kernel/grid.hpp", 'auto f = "/' + 'home/someone/data";\n', "absolute path"),
    ("cases/plan.json", '["/' + 'tmp/x.h5"]\n', "absolute path"),
    ("kernel/grid.hpp", "// TO" + "DO: later\n", "note to oneself"),
    ("kernel/grid.hpp", "// FIX" + "ME\n", "note to oneself"),
    ("README.md", "<" * 7 + " ours\n", "merge leftover"),
    ("reports/templates/a.html", "<h3>Do it " + "again</h3>\n", "word of our own"),
    ("notes.txt", "\n", "top level"),
    ("scripts/run.sh", "\n", "top level"),
])
def test_forbidden_text_is_found(name, text, complaint, tree):
    result = run("check_text", tree(files={name: text}))
    assert result.returncode == 1
    assert complaint in result.stdout and name.split("/")[0] in result.stdout


def test_text_that_only_looks_like_a_path_passes(tree):
    text = 'See https://example.org/home/page, framework/work/x, ${HOME}/work/x and a/tmp/b; #!/usr/bin/env bash\n'
    assert run("check_text", tree(files={"README.md": text})).returncode == 0


def test_binary_file_is_found(tree):
    root = tree()
    (root / "reports" / "logo.png").write_bytes(b"\x89PNG\xff")
    result = run("check_text", root)
    assert result.returncode == 1 and "not UTF-8" in result.stdout


@pytest.mark.parametrize("check", ["check_includes", "check_equations"])
def test_folder_that_is_no_source_tree_is_refused(check, tmp_path):
    assert run(check, tmp_path).returncode == 2
