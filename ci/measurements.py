"""What ctest and CDash show of a case: numbers and a picture of its studies, as tags that `ctest -T Test` takes up.

    python measurements.py --results DIR --case NAME --picture FILE.png -- plumbline verify NAME --results DIR

Runs the command, passes on what it prints and its exit status, and then prints, of the studies that it wrote: `STUDY.MEASURE.order`,
`STUDY.MEASURE.error` at the finest level, `STUDY.cost_s` of all its runs; of the verdicts `gates.PASS` and so on. The picture has
the errors of the study with most levels over h. What is missing or not finite is left out.
"""

import argparse
import math
import pathlib
import subprocess
import sys
import time
from collections import Counter
from xml.sax.saxutils import escape, quoteattr

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "reports"))
from plumbline import reader  # noqa: E402


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Runs a case's command and prints its measurements for ctest.")
    parser.add_argument("--results", required=True, type=pathlib.Path)
    parser.add_argument("--case", required=True)
    parser.add_argument("--picture", required=True, type=pathlib.Path)
    parser.add_argument("command", nargs="+")
    options = parser.parse_args(arguments)
    start = time.time_ns() - 20_000_000  # times of files are of a coarser clock
    status = subprocess.run(options.command, check=False).returncode
    studies, verdicts = written_since(start, options.results, options.case)
    for name, value in numbers(studies, verdicts):
        print(tag("CTestMeasurement", "numeric/double", name, repr(float(value))))
    if draw(options.case, studies, options.picture):
        print(tag("CTestMeasurementFile", "image/png", "errors", str(options.picture.resolve())))
    return status if status >= 0 else 128 - status


def tag(kind, content_type, name, value):
    return f"<{kind} type={quoteattr(content_type)} name={quoteattr(name)}>{escape(value)}</{kind}>"


def written_since(start, folder, case):
    """Studies of the case and verdicts that the command wrote; the folder may hold those of other choices and days."""
    patterns = (f"study-{case}-*.h5", "verdicts-*.h5")
    new = [path for pattern in patterns for path in sorted(folder.glob(pattern)) if path.stat().st_mtime_ns >= start]
    found = [result for result in map(_loaded, new) if result]
    studies = [result.study for result in found if result.kind == "study" and result.study.get("case") == case]
    verdicts = [result for result in found if result.kind == "verdicts" and set(result.catalog) == {case}]
    return studies, verdicts


def _loaded(path):
    """A file that cannot be used was named by whoever judged it."""
    try:
        return reader.load(path)
    except (reader.ResultsError, OSError) as error:
        print(f"{path.name}: {error}")
        return None


def numbers(studies, verdicts):
    """[(name, number)] in a fixed order."""
    found = []
    for study in sorted(studies, key=lambda study: study["id"]):
        levels = study["levels"]
        for name, fit in study["measures"].items():
            finest = levels[-1]["measures"].get(name, {}) if levels else {}
            found.append((f"{study['id']}.{name}.order", fit.get("order")))
            found.append((f"{study['id']}.{name}.error", finest.get("error")))
        found.append((f"{study['id']}.cost_s", math.fsum(level["wall_s"] for level in levels)))
    for result in verdicts:
        counts = Counter(gate["verdict"] for gate in result.gates)
        found += [(f"gates.{verdict}", count) for verdict, count in sorted(counts.items())]
    return [(name, value) for name, value in found if value is not None and math.isfinite(value)]


def lines(study):
    """[(measure, fit, h, errors)] of the measures that have an error at two levels or more."""
    found = []
    for name, fit in study["measures"].items():
        points = [(level["h"], level["measures"].get(name, {}).get("error")) for level in study["levels"]]
        points = [(h, error) for h, error in points if error is not None and error > 0 and math.isfinite(error)]
        if len({h for h, _ in points}) > 1:
            found.append((name, fit, *zip(*points)))
    return found


def draw(case, studies, path):
    """Writes the picture; whether there was anything to draw."""
    drawable = [(study, lines(study)) for study in studies]
    study, drawn = max(drawable, key=lambda pair: sum(len(h) for *_, h, _ in pair[1]), default=(None, []))
    if not drawn:
        path.unlink(missing_ok=True)
        return False
    # matplotlib takes most of the time, and many cases have one level only in the quick tier.
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7.5, 4), dpi=100, layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots()
    for number, (name, fit, h, errors) in enumerate(drawn):
        order, mark = fit.get("order"), "os^Dv"[number // 10 % 5]  # the colours repeat after ten
        axes.loglog(h, errors, f"{mark}-", label=name if order is None else f"{name}: order {order:.2f}")
    axes.set(xlabel="cell size h in m", ylabel="error, in the unit of each measure", title=f"{case}, {study['id']}")
    axes.grid(True, which="major", alpha=0.4)
    axes.legend(loc="center left", bbox_to_anchor=(1.02, 0.5), fontsize="small")
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path, metadata={"Software": None})
    return True


if __name__ == "__main__":
    sys.exit(main())
