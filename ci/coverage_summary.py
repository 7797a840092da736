"""Coverage by folder from the summary of gcovr, and whether it is enough.

    python coverage_summary.py GCOVR.json coverage.json

Writes {"total": share, "folders": {folder: share}, "files": {path: share}} of lines, in [0, 1], and prints folders and the files with
most lines that no test reaches. Exit status: 1 if a folder is below LEAST or has no lines, 0 otherwise.
"""

import json
import os
import pathlib
import sys

FOLDERS = ("kernel", "reference", "cases/harness")
LEAST = 0.9  # of the lines: see CONTRIBUTING.md, "Coverage"


def share(covered, total):
    return round(covered / total, 4) if total else None


def summary(gcovr):
    """The document from that of `gcovr --json-summary`, and [(lines missed, path)], most first."""
    counts = {file["filename"]: (file["line_covered"], file["line_total"]) for file in gcovr["files"]}
    counts = {path: count for path, count in sorted(counts.items()) if path.startswith(tuple(f"{name}/" for name in FOLDERS))}

    def of(folder):
        inside = [count for path, count in counts.items() if path.startswith(folder)]
        return share(sum(covered for covered, _ in inside), sum(total for _, total in inside))

    document = {
        "total": of(""),
        "folders": {folder: of(f"{folder}/") for folder in FOLDERS},
        "files": {path: share(*count) for path, count in counts.items()},
    }
    missed = sorted(((total - covered, path) for path, (covered, total) in counts.items()), reverse=True)
    return document, missed


def write_whole(path, text):
    part = path.with_name(f"{path.name}.{os.getpid()}.part")
    part.write_text(text, encoding="utf-8")
    part.replace(path)


def main(source, target):
    document, missed = summary(json.loads(pathlib.Path(source).read_text(encoding="utf-8")))
    write_whole(pathlib.Path(target), json.dumps(document, indent=1) + "\n")
    for lines, path in missed[:15]:
        if lines:
            print(f"  {path}: {100 * document['files'][path]:.2f} %, {lines} lines not reached")
    enough = True
    for folder, value in document["folders"].items():
        good = value is not None and value >= LEAST
        enough = enough and good
        print(f"{folder}: {'no lines at all' if value is None else f'{100 * value:.4g} % of lines'}{'' if good else f', below {100 * LEAST:g} %'}")
    return 0 if enough else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
