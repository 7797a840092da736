"""The script library of the page, read from where the distribution installs it; nothing of it is kept here.

d3-zoom and what it needs come from Debian's and Ubuntu's package `node-d3-zoom` and its dependencies: one folder a
module under /usr/share/nodejs, each with dist/NAME.min.js and a package.json that names what it needs.
"""

import json
import pathlib

ROOTS = (pathlib.Path("/usr/share/nodejs"), pathlib.Path("/usr/lib/nodejs"))
MODULE = "d3-zoom"
PACKAGE = "node-d3-zoom"


def zoom(roots=ROOTS):
    """(script, words): d3-zoom with what it needs as one script, "" where it is not installed; and what to say of it."""
    for root in roots:
        parts = _with_dependencies(root, MODULE, {})
        if parts:
            # A script element ends at this text, wherever it stands.
            script = "\n".join(parts.values()).replace("</script", "<\\/script")
            return script, f"{MODULE} {_package(root, MODULE).get('version', '')} from the package {PACKAGE}".replace("  ", " ")
    return "", f"the package {PACKAGE} was not installed when this page was made: figures cannot be enlarged"


def _package(root, name):
    try:
        found = json.loads((root / name / "package.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}
    return found if isinstance(found, dict) else {}


def _with_dependencies(root, name, found):
    """Scripts by module, those that others need first; None where one is missing."""
    source = next((path for path in (root / name / "dist").glob(f"{name}*.js") if path.name == f"{name}.min.js"), None)
    source = source or root / name / "dist" / f"{name}.js"
    for needed in _package(root, name).get("dependencies") or {}:
        if needed not in found and _with_dependencies(root, needed, found) is None:
            return None
    try:
        found[name] = source.read_text(encoding="utf-8")
    except OSError:
        return None
    return found
