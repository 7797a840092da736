"""Makes the site of documents: the pages here, and the reference from what the executable says of itself.

    python build.py PLUMBLINE OUTPUT_DIR

Needs Sphinx, MyST, node and KaTeX (ci/packages). A link to a page or a heading that is not there is an error. Exit status: 0;
1 the site could not be made, with the reason; an earlier site in OUTPUT_DIR is then left as it is.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import generated

HERE = pathlib.Path(__file__).resolve().parent
STYLES = HERE.parent / "templates"
SCROLLED = re.compile(r'(<pre(?=>)|<table(?= class="docutils))')  # what is wider than a phone: the keyboard scrolls it once it has the focus
OUTSIDE = re.compile(r"\[([^\]]+)\]\((?:\.\./)+(?:kernel|cases|reference|tests|ci|\.github|[A-Z]+\.md|reports)[^)]*\)")


def gather(plumbline, folder):
    """All that Sphinx reads: the pages, with links to sources as plain text and the reference filled in."""
    shutil.copytree(HERE, folder, ignore=shutil.ignore_patterns("__pycache__", "build.py"))
    for page in folder.rglob("*.md"):
        page.write_text(OUTSIDE.sub(r"\1", page.read_text(encoding="utf-8")), encoding="utf-8")
    generated.write(plumbline, folder)
    light, dark, own = ((place / name).read_text(encoding="utf-8") for place, name in ((STYLES, "style.css"), (STYLES, "dark.css"), (HERE / "theme", "docs.css")))
    (folder / "theme/static").mkdir()
    (folder / "theme/static/docs.css").write_text(
        f"{light}\n@media screen and (prefers-color-scheme: dark) {{ :root {{ {dark} }} }}\n{own}", encoding="utf-8")


def build(plumbline, output):
    """An empty text, or why the site could not be made."""
    if not (missing := [tool for tool in ("node",) if not shutil.which(tool)]) and not pathlib.Path("/usr/share/javascript/katex/katex.js").is_file():
        missing = ["KaTeX"]
    if missing:
        return f"{missing[0]} is not installed"
    with tempfile.TemporaryDirectory() as folder:
        sources, made = pathlib.Path(folder, "sources"), pathlib.Path(folder, "made")
        gather(plumbline, sources)
        command = [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", "-d", f"{folder}/doctrees", sources, made]
        process = subprocess.run([str(word) for word in command], capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(sources)})
        if process.returncode:
            return process.stderr
        for left in (".buildinfo", "objects.inv"):
            (made / left).unlink(missing_ok=True)
        for page in made.rglob("*.html"):
            page.write_text(SCROLLED.sub(r'\1 tabindex="0"', page.read_text(encoding="utf-8")), encoding="utf-8")
        shutil.rmtree(output, ignore_errors=True)
        shutil.copytree(made, output)
    return ""


def main(arguments):
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    why = build(*arguments)
    if why:
        print(f"docs: {why}", file=sys.stderr)
    return 1 if why else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
