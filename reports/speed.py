"""The speed of the kernel, from the document of `plumbline bench`: tables, figures, and what holds the rest."""

import statistics

import svg
import text
from figures import Figure, Key, log_axis, plain_axis
from plumbline.reader import BENCH_FILE

CSV_COLUMNS = (
    "part",
    "name",
    "dimension",
    "axisymmetric",
    "shape",
    "transfer",
    "integrator",
    "points",
    "ppc",
    "threads",
    "steps",
    "particle_steps_per_s",
    "slowest",
    "fastest",
    "bytes_per_point",
    "flops_per_point",
    "bandwidth_fraction",
    "flop_fraction",
    "fraction_of_limit",
    "stored_bytes_per_point",
    "memory_bytes_per_point",
    "energy_drift",
)


def page(bench):
    """What the template shows beside the figures."""
    matrix = _matrix_rows(bench)
    return {
        "machine": _machine(bench),
        "targets": [_target_row(target) for target in bench.get("targets") or []],
        "spread": _spread(bench),
        "fractions": _fraction_words(bench),
        "matrix": [row for row in matrix if row["default"]],
        "others": [row for row in matrix if not row["default"]],
        "threads": _thread_counts(bench, "matrix"),
        "runs": [_run_row(kernel) for kernel in part(bench, "run")],
        "empty_step": text.seconds((bench.get("empty_step") or {}).get("seconds_per_step")),
        "file": BENCH_FILE,
        "command": (bench.get("provenance") or {}).get("command") or "",
    }


def part(bench, name):
    return [kernel for kernel in bench["kernels"] if kernel.get("part") == name]


def csv_rows(bench):
    return [[kernel.get(column) for column in CSV_COLUMNS] for kernel in bench["kernels"]]


# --- tables ---------------------------------------------------------------------------------------


def _machine(bench):
    machine = bench.get("machine") or {}
    rows = [("processor", machine.get("cpu")), ("instruction set", machine.get("instruction_set"))]
    copies = [entry for entry in machine.get("copy") or [] if entry.get("bytes_per_s")]
    for threads in sorted({entry["threads"] for entry in copies}):
        own = sorted((entry["bytes"], entry["bytes_per_s"]) for entry in copies if entry["threads"] == threads)
        words = [f"{text.number(rate / 1e9)} GB/s for {size(bytes)}" for bytes, rate in dict.fromkeys([own[0], own[-1]])]
        rows.append((f"copying, {text.plural(threads, 'thread')}", text.listing(words)))
    for entry in machine.get("multiply_add") or []:
        words = f"{text.number(entry['flops_per_s'] / 1e9)} thousand million operations a second"
        rows.append((f"products with sums, {text.plural(entry['threads'], 'thread')}", words))
    return [(name, value) for name, value in rows if value]


def size(bytes):
    for scale, unit in ((2**10, "KiB"), (2**20, "MiB"), (2**30, "GiB")):
        if bytes < 1024 * scale:
            break
    return f"{text.number(bytes / scale)} {unit}"


def _target_row(target):
    low, high, unit = target.get("low"), target.get("high"), target.get("unit") or ""
    per_second = unit == "particle-steps/s"

    def words(value):
        if per_second:
            return f"{text.number(value / 1e6)} million/s"
        return text.number(value) + ("" if unit == "1" else f" {unit}")

    return {
        "name": target.get("name") or "",
        "measured": words(target["measured"]),
        "wanted": f"at least {words(low)}" if low is not None else f"at most {words(high)}",
        "met": bool(target.get("met")),
    }


def _thread_counts(bench, name):
    return sorted({kernel["threads"] for kernel in part(bench, name)})


def _millions(kernel):
    return text.number(kernel["particle_steps_per_s"] / 1e6)


def _percent(fraction):
    return text.MISSING if fraction is None else f"{100 * fraction:.0f}\u202f%"


def _matrix_rows(bench):
    """One row per geometry, shape, transfer and integrator, with a speed for each number of threads."""
    threads, found = _thread_counts(bench, "matrix"), {}
    for kernel in part(bench, "matrix"):
        key = (kernel["dimension"], bool(kernel.get("axisymmetric")))
        found.setdefault((key, kernel["shape"], kernel["transfer"], kernel["integrator"]), {})[
            kernel["threads"]
        ] = kernel
    rows = []
    for (geometry, shape, transfer, integrator), kernels in found.items():
        first = kernels[min(kernels)]
        rows.append(
            {
                "label": _geometry(*geometry),
                "shape": shape,
                "transfer": transfer,
                "integrator": integrator,
                "default": integrator == "leapfrog",
                "speeds": [_millions(kernels[count]) if count in kernels else text.MISSING for count in threads],
                "moved": text.number(first.get("bytes_per_point")),
                "flops": text.number(first.get("flops_per_point")),
                "memory": _percent(first.get("bandwidth_fraction")),
                "arithmetic": _percent(first.get("flop_fraction")),
                "stored": text.number(first.get("stored_bytes_per_point")),
                "held": text.number(first.get("memory_bytes_per_point")),
                "drift": text.number(first.get("energy_drift"), 1),
            }
        )
    return rows


def _geometry(dimension, axisymmetric):
    return {1: "line", 2: "axisymmetric" if axisymmetric else "plane", 3: "space"}[dimension]


def _run_row(kernel):
    return {
        "name": kernel.get("name") or "",
        "points": text.count(kernel.get("points")),
        "steps": text.count(kernel.get("steps")),
        "wall": text.seconds(kernel.get("wall_s")),
        "speed": _millions(kernel),
    }


def _spread(bench):
    """How far the repeats of a measurement lie apart: the middle one of all, in words."""
    found = [
        kernel["fastest"] / kernel["slowest"] - 1
        for kernel in bench["kernels"]
        if kernel.get("fastest") and kernel.get("slowest")
    ]
    return _percent(statistics.median(found)) if found else ""


def _fraction_words(bench):
    """The fraction of each limit that the leading scheme reaches, in a sentence."""
    kernels = [kernel for kernel in part(bench, "target") if kernel.get("fraction_of_limit") is not None]
    if not kernels:
        return ""
    first, *others = [kernel for kernel in kernels if kernel["integrator"] == kernels[0]["integrator"]]
    more = "".join(
        f"; on {text.plural(kernel['threads'], 'thread')} at {_percent(kernel['bandwidth_fraction'])} and "
        f"{_percent(kernel['flop_fraction'])}"
        for kernel in others
    )
    return (
        f"With {text.count(first['points'])} points on {text.plural(first['threads'], 'thread')}, the step "
        f"({first['name']}) moves data at {_percent(first['bandwidth_fraction'])} of the rate at which this machine "
        f"copies memory, and computes at {_percent(first['flop_fraction'])} of the rate at which it multiplies and "
        f"adds{more}."
    )


# --- figures --------------------------------------------------------------------------------------


def _by_threads(bench):
    """{threads: entries of the scale series by points}."""
    return {
        threads: sorted(
            (kernel for kernel in part(bench, "scale") if kernel["threads"] == threads),
            key=lambda kernel: kernel["points"],
        )
        for threads in _thread_counts(bench, "scale")
    }


def _thread_keys(series):
    return [
        Key(text.plural(threads, "thread"), f"var(--s{number + 1})", svg.series_mark(number))
        for number, threads in enumerate(series)
    ]


def cost_by_size(bench):
    """Cost of a particle-step against the number of points, with the spread of the repeats."""
    series = _by_threads(bench)
    if not series:
        return None
    caches = _caches(bench)

    def paint(axes):
        for number, kernels in enumerate(series.values()):
            points = [kernel["points"] for kernel in kernels]
            cost = [1e9 / kernel["particle_steps_per_s"] for kernel in kernels]
            below = [c - 1e9 / kernel["fastest"] for c, kernel in zip(cost, kernels)]
            above = [1e9 / kernel["slowest"] - c for c, kernel in zip(cost, kernels)]
            colour = svg.series_colour(number)
            bars = axes.errorbar(
                points, cost, (below, above), fmt=svg.series_mark(number) + "-", color=colour, linewidth=0.9,
                elinewidth=0.9, capsize=2.5,
            )  # fmt: skip
            bars[0].set_label(text.plural(list(series)[number], "thread"))
        most = max(1e9 / kernel["slowest"] for kernels in series.values() for kernel in kernels)
        sizes = [kernel["points"] for kernels in series.values() for kernel in kernels]
        axes.set(xscale="log", xlim=(min(sizes) / 1.7, 1.7 * max(sizes)))
        axes.set(yscale="log" if most > 10 * _least_cost(series) else "linear")
        low, high = axes.get_xlim()
        for name, points in caches:
            if low < points < high:
                axes.axvline(points, color=svg.MUTED, linewidth=0.8, dashes=(1, 1.5))
                axes.annotate(
                    name, (points, 1), xycoords=("data", "axes fraction"), ha="right", va="top", rotation=90,
                    fontsize=7.5, xytext=(-2, -2), textcoords="offset points",
                )  # fmt: skip
        axes.set(xlabel="number of points", ylabel="cost of a particle-step in ns")
        log_axis(axes.xaxis, *axes.get_xlim())
        if axes.get_yscale() == "log":
            log_axis(axes.yaxis, *axes.get_ylim())
        else:
            axes.set_ylim(bottom=0)
            plain_axis(axes.yaxis)

    caption = (
        f"{_scheme(series)}: time of a step over the number of points; bars reach from the fastest to the slowest repeat. "
        "A level line means that a large run costs no more per point than a small one. "
        + ("Dotted: where the points alone fill a cache." if caches else "")
    )
    return Figure(
        svg.draw(paint, "speed-cost", "Cost of a particle-step against the number of points"),
        "Cost of a particle-step",
        caption,
        [BENCH_FILE],
        _thread_keys(series),
    )


def _least_cost(series):
    return min(1e9 / kernel["fastest"] for kernels in series.values() for kernel in kernels)


def _scheme(series):
    kernel = next(iter(series.values()))[0]
    shape = {"linear": "linear shapes"}.get(kernel["shape"], f"{kernel['shape']} B-splines")
    return f"Plane, {shape}, {kernel['transfer']}, {kernel['integrator']}, {text.number(kernel['ppc'])} points per cell"


def _caches(bench):
    """(name, number of points whose columns fill it) of the second cache and those above."""
    stored = next((kernel.get("stored_bytes_per_point") for kernel in part(bench, "scale")), None)
    sizes = (bench.get("machine") or {}).get("cache_bytes") or []
    return [(f"cache {level}", bytes / stored) for level, bytes in enumerate(sizes, 1) if stored and level > 1]


def memory_by_size(bench):
    """Bytes held for each point, measured, over those that its columns need."""
    series = {
        threads: [kernel for kernel in kernels if kernel.get("memory_bytes_per_point")]
        for threads, kernels in list(_by_threads(bench).items())[:1]
    }
    kernels = next(iter(series.values()), [])
    if not kernels:
        return None
    stored = kernels[-1]["stored_bytes_per_point"]

    def paint(axes):
        points = [kernel["points"] for kernel in kernels]
        held = [kernel["memory_bytes_per_point"] for kernel in kernels]
        axes.plot(
            points, held, svg.series_mark(0) + "-", color=svg.series_colour(0), linewidth=0.9, label="held, measured"
        )
        axes.axhline(stored, color=svg.MUTED, linewidth=0.9, dashes=(5, 3))
        axes.set(xscale="log", xlabel="number of points", ylabel="memory per point in bytes")
        axes.set_ylim(0, 1.15 * max(held + [stored]))
        log_axis(axes.xaxis, *axes.get_xlim())
        plain_axis(axes.yaxis)

    caption = (
        f"Memory that a run holds between steps, measured, over its number of points. The broken line is what the columns "
        f"of a point need as counted, {text.number(stored)} bytes; the rest is the grid, the order of the points, their "
        "places at the start of the step, and space to sort one column."
    )
    keys = _thread_keys(series)
    keys[0].label = "held, measured"
    return Figure(
        svg.draw(paint, "speed-memory", "Memory per point against the number of points"),
        "Memory per point",
        caption,
        [BENCH_FILE],
        keys + [Key("columns, counted", "var(--muted)", dash=True)],
    )
