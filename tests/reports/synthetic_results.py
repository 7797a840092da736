"""Writes a small results folder with invented but plausible numbers, to test the report without any solver.

    python synthetic_results.py DIR        # writes into DIR, one of the files truncated

The layout is that of the real result files. The Sod profile is the exact solution smeared over a few cells.
"""

import cmath
import hashlib
import json
import math
import pathlib
import sys

import h5py
import numpy

import synthetic_draw
import synthetic_mutants
import synthetic_scorecards

CELLS = (100, 200, 400, 800, 1600)
VERDICTS = ("PASS", "FAIL", "INCONCLUSIVE", "XFAIL", "XPASS", "INVALID", "NONE")
PROVENANCE = {
    "version": "0.1.0",
    "git": "0123456789abcdef0123456789abcdef01234567",
    "dirty": True,
    "compiler": "g++ 12.2.0",
    "flags": "-O3 -DNDEBUG -ffp-contract=off -march=x86-64-v3",
    "cpu": "Synthetic CPU at 3 GHz",
    "instruction_set": "x86-64-v3 (AVX2, FMA)",
    "threads": 1,
    "libraries": {"Eigen": "3.4.0", "GSL": "2.7.1", "HDF5": "1.10.8"},
    "command": "plumbline verify --tier quick",
    "started": "2026-11-21T08:00:00Z",
}
SETTINGS = {
    "integrator": "energy",
    "transfer": "apic",
    "shape": "quadratic",
    "density": "quadratic",
    "cfl": 0.3,
    "points": "equal-mass",
    "viscosity.linear": 1.0,
    "viscosity.quadratic": 1.0,
    "gamma": 1.4,
}
LONG_LABELS = {"displacement": "displacement of the mass, positive downwards from where it was released"}
SKETCH = """<svg viewBox="0 0 320 96" fill="none" stroke="currentColor" stroke-width="1.5">
<rect x="10" y="20" width="300" height="40"/><line x1="160" y1="14" x2="160" y2="66" stroke-dasharray="4 3"/>
<g fill="currentColor" stroke="none" font-size="12"><text x="28" y="44">ρ = 1, p = 1</text>
<text x="178" y="44">ρ = 0.125, p = 0.1</text><text x="160" y="82" text-anchor="middle">x = 0.5</text></g></svg>"""


# --- exact solution of Sod's problem (star states from [Toro table 4.2]) --------------------------


def sod_exact(x, time=0.143):
    """Density, velocity and pressure at the positions x."""
    pressure_star, velocity_star, left_star, right_star = 0.30313, 0.92745, 0.42632, 0.26557
    gamma, sound_left = 1.4, 1.4**0.5
    speed = (x - 0.5) / time
    sound_star = sound_left * (pressure_star ** ((gamma - 1) / (2 * gamma)))
    fan = (2 / (gamma + 1)) * (sound_left + speed)
    fan_sound = sound_left - (gamma - 1) / 2 * fan
    shock = 1.75216
    regions = [speed < -sound_left, speed < velocity_star - sound_star, speed < velocity_star, speed < shock]
    fan_density = (fan_sound / sound_left) ** (2 / (gamma - 1))
    density = numpy.select(regions, [1.0, fan_density, left_star, right_star], 0.125)
    velocity = numpy.select(regions, [0.0, fan, velocity_star, velocity_star], 0.0)
    pressure = numpy.select(regions, [1.0, fan_density**gamma, pressure_star, pressure_star], 0.1)
    return density, velocity, pressure


def smeared(x, width):
    """The exact fields averaged over a few neighbouring positions."""
    shifts = width * numpy.array([-1.5, -0.8, -0.3, 0.0, 0.3, 0.8, 1.5])
    return [sum(fields) / len(shifts) for fields in zip(*(sod_exact(x + shift) for shift in shifts))]


# --- writing --------------------------------------------------------------------------------------


def digest(*parts):
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:12]


def create(path, kind, parts, version=2):
    """A file with its root attributes and JSON parts; returned open."""
    file = h5py.File(path, "w")
    file.attrs["plumbline_format"] = numpy.int64(version)
    file.attrs["kind"] = (
        numpy.bytes_(kind) if kind == "run" else kind
    )  # fixed and variable strings both occur
    for name, value in parts.items():
        file[name] = json.dumps(value, ensure_ascii=False)
    return file


def write_columns(file, group, columns, **attributes):
    for name, values in columns.items():
        file[f"{group}/{name}"] = numpy.asarray(values, dtype=float)
    file[group].attrs.update(attributes)


def measure(error, value=None, reference=None, unit="1", bound=1e-13):
    return {
        "error": error,
        "relative_error": None if error is None else error / (abs(reference) if reference else 0.39),
        "value": value,
        "reference": reference,
        "reference_bound": bound,
        "unit": unit,
    }


def gate(case, scheme, name, quantity, low, high, verdict, measured, **more):
    return {
        "id": name,
        "case": case,
        "scheme": scheme,
        "quantity": quantity,
        "expected": {"low": low, "high": high},
        "origin": "requirement",
        "reason": "as accurate as another method on the same mesh",
        "measured": measured,
        "interval": None,
        "margin": 0.06,
        "verdict": verdict,
        "cause": None,
        "run_ids": [],
        **more,
    }


def ledger_json(drift):
    zero = {"initial": 1.0, "final": 1.0, "relative_drift": 0.0}
    return {
        "mass": zero,
        "momentum_x": {"initial": 0.0, "final": 0.128, "relative_drift": 4e-16},
        "energy": {
            "initial": 1.375,
            "final": 1.375,
            "relative_drift": drift,
            "stores": {"kinetic": 0.187, "internal": 1.188},
            "flows": {"walls": 0.0, "transfer": -2.1e-4, "integration": 3.0e-5},
        },
    }


def write_ledger(file, drift, end, rows=200):
    time = numpy.linspace(0, end, rows)
    wobble = drift * numpy.abs(numpy.sin(40 * time / end)) * time / end
    kinetic = 0.187 * time / end
    write_columns(file, "ledger/mass", {"time": time, "step": range(rows), "residual": 0 * time})
    write_columns(file, "ledger/momentum_x", {"time": time, "step": range(rows), "residual": wobble * 1e-2})
    write_columns(
        file,
        "ledger/energy",
        {
            "time": time,
            "step": range(rows),
            "kinetic": kinetic,
            "internal": 1.375 - kinetic,
            "transfer": -2.1e-4 * time / end,
            "residual": wobble,
        },
    )


def run_object(case, scheme, cells, settings, measures, **more):
    points = more.pop("points", int(4.5 * cells))
    steps = more.pop("steps", int(1.08 * cells))
    wall = more.pop("wall_s", points * steps / 1.2e7)
    name = f"{case}-{scheme}-{cells}-{digest(case, scheme, cells, settings, more.get('value'))}.h5"
    run = {
        "case": case,
        "scheme": scheme,
        "settings": {**settings, "cells": cells},
        "choices": settings,
        "verdict": "NONE",
        "finished": True,
        "stop": None,
        "steps": steps,
        "points": points,
        "wall_s": wall,
        "particle_steps_per_s": points * steps / wall,
        "measures": measures,
        "ledger": ledger_json(more.pop("drift", 3e-15)),
        "gates": [],
        "provenance": PROVENANCE,
        "file": name,
        "h": 1 / cells,
        "time": 0.143,
    }
    return {**run, **more}


def state_command(path, command):
    """Lets a file say that another command than that of the others made it."""
    with h5py.File(path, "r+") as file:
        del file["provenance"]
        file["provenance"] = json.dumps({**PROVENANCE, "command": command})


def write_run(folder, run, profile=None, kind="space"):
    parts = {"run": run, **{name: run[name] for name in ("measures", "gates", "provenance", "settings")}}
    with create(folder / run["file"], "run", parts) as file:
        write_ledger(file, run["ledger"]["energy"]["relative_drift"], run["time"])
        if profile:
            abscissa = "x" if kind == "space" else "time"
            write_columns(file, "profile", profile, abscissa=abscissa, kind=kind)
            for name, data in file["profile"].items():
                data.attrs["unit"] = {"x": "m", "time": "s", "displacement": "m"}.get(name.split("_")[0], "1")
                data.attrs["label"] = LONG_LABELS.get(name, name.replace("_", " "))


FRAME_TIMES = numpy.linspace(0, 0.143, 9)
FRAME_BODIES = [
    {"name": "air", "kind": "gas", "material": "ideal_gas", "chain": False, "closed": False},
    {"name": "bag", "kind": "membrane", "material": "segment_membrane", "chain": True, "closed": True},
    {"name": "probe", "kind": "solid", "material": "linear_elastic", "chain": False, "closed": False},
]


def frame_bodies(number):
    """{field: values} of each body at a frame: a bag that swells, more gas points from the fifth frame on."""
    swell = 0.34 + 0.01 * number
    places = numpy.arange(400 if number < 4 else 600) + 0.5
    radius, angle = 0.95 * swell * numpy.sqrt(places / len(places)), 2.39996 * places
    around = numpy.linspace(0, 2 * numpy.pi, 60, endpoint=False)
    square = numpy.stack(numpy.meshgrid(numpy.linspace(0.4, 0.6, 8), numpy.linspace(0.9, 1, 4)), -1).reshape(-1, 2)
    shapes = (
        numpy.stack([0.5 + radius * numpy.cos(angle), 0.5 + radius * numpy.sin(angle)], axis=1),
        numpy.stack([0.5 + swell * numpy.cos(around), 0.5 + swell * numpy.sin(around)], axis=1),
        square - (0, 0.01 * number),
    )
    nothing = numpy.nan
    fields = (
        (2 - radius**2 - 0.1 * number, nothing),
        (nothing, 10 + numpy.cos(around)),
        (0.1 + 0 * square[:, 0], 5 * square[:, 1]),
    )
    bodies = []
    for position, (pressure, stress) in zip(shapes, fields):
        count = len(position)
        bodies.append(
            {
                "id": numpy.arange(count),
                "position": numpy.column_stack([position, numpy.zeros(count)]),
                "velocity": numpy.zeros((count, 3)),
                "pressure": numpy.broadcast_to(pressure, count),
                "stress": numpy.broadcast_to(stress, count),
            }
        )
    return bodies


def add_frames(path, axisymmetric=False, times=FRAME_TIMES):
    """Puts frames into a file of a run, in the layout of the real ones."""
    frames = [frame_bodies(number) for number in range(len(times))]
    counts = [sum(len(body["id"]) for body in bodies) for bodies in frames]
    wall = ["symmetry", "symmetry"]
    described = {
        "dim": 2,
        "axisymmetric": axisymmetric,
        "h": 0.05,
        "low": [0.0, 0.0],
        "high": [1.0, 1.2],
        "walls": [wall, ["no_slip", "free"]],
        "every": 3,
        "bodies": FRAME_BODIES,
        "units": {"position": "m", "velocity": "m/s", "pressure": "Pa", "stress": "Pa", "time": "s"},
    }
    bodies = [(number, body) for frame in frames for number, body in enumerate(frame)]
    columns = {
        name: numpy.concatenate([body[name] for _, body in bodies])
        for name in ("position", "velocity", "pressure", "stress", "id")
    }
    columns["body"] = numpy.concatenate([numpy.full(len(body["id"]), number) for number, body in bodies])
    for name in ("position", "velocity", "pressure", "stress"):
        columns[name] = columns[name].astype(numpy.float32)
    with h5py.File(path, "a") as file:
        write = write_frames_of_format_1 if file.attrs["plumbline_format"] == 1 else write_frames
        write(file, described, times, numpy.append(0, numpy.cumsum(counts)), columns)


def write_frames(file, described, times, starts, columns):
    file["frames/description"] = json.dumps(described)
    file["frames/time"], file["frames/start"] = times, starts
    for name, values in columns.items():
        file[f"frames/{name}"] = values


def write_frames_of_format_1(file, described, times, starts, columns):
    file["frames"] = json.dumps(described)
    group = file.create_group("VTKHDF")
    group.attrs.update({"Version": [2, 0], "Type": numpy.bytes_("UnstructuredGrid")})
    group["Steps/Values"], group["Steps/PointOffsets"] = times, starts[:-1]
    for name, values in columns.items():
        group["Points" if name == "position" else f"PointData/{name}"] = values


def normals_profile():
    """Points on an arc with their exact normals and those of two methods, one of them wrong."""
    angle = numpy.linspace(0, numpy.pi / 2, 50)
    columns = {"x": numpy.cos(angle), "y": numpy.sin(angle), "judged": (angle > 0).astype(float)}
    for name, off in (("", 0.0), ("good.", 1e-12), ("wrong.", 0.4)):
        columns[f"{name}normal_x"], columns[f"{name}normal_y"] = numpy.cos(angle + off), numpy.sin(angle + off)
        if name:
            columns[f"{name}angle_error_deg"] = numpy.full(len(angle), numpy.degrees(off))
    columns["wrong.angle_error_deg"][0] = 80.0  # not judged
    return columns


def write_study(folder, case, scheme, vary, levels, measures, catalog, **more):
    settings = {key: value for key, value in levels[0]["settings"].items() if key not in ("cells", vary)}
    gates = more.pop("gates", [])
    study = {
        "scheme": scheme,
        "vary": vary,
        "settings": settings,
        "levels": levels,
        "measures": measures,
        "gates": gates,
        "case": case,
        "id": more.get("id", "study"),
        "title": more.get("title", ""),
        "why": more.get("why", ""),
        "choices": more.get("choices", settings),
    }
    parts = {"study": study, "fit": measures, "gates": gates, "catalog": catalog, "provenance": PROVENANCE}
    name = f"study-{case}-{scheme}-{vary}-{digest(case, scheme, vary, settings)}.h5"
    with create(folder / name, "study", parts) as file:
        for method, (title, columns) in more.get("comparators", {}).items():
            write_columns(file, f"comparator/{method}", columns, title=title)
    return name


def fit(errors, sizes, used=None):
    """Least squares in logarithms, with the interval of the order, as a study states them."""
    used = used or [True] * len(errors)
    x, y = (numpy.log(numpy.array(values)[used]) for values in (sizes, errors))
    order, intercept = numpy.polyfit(x, y, 1)
    spread = ((y - order * x - intercept) ** 2).sum() / (len(x) - 2)
    half = 3.18 * (spread / ((x - x.mean()) ** 2).sum()) ** 0.5
    pairwise = [
        float(numpy.log(a / b) / numpy.log(g / h)) for a, b, g, h in zip(errors, errors[1:], sizes, sizes[1:])
    ]
    return {
        "order": order,
        "order_low": order - half,
        "order_high": order + half,
        "constant": float(numpy.exp(intercept)),
        "asymptotic": bool(half < 0.15),
        "pairwise": pairwise,
        "leave_one_out": [order] * len(errors),
        "plateau": [float(e / h**order) for e, h in zip(errors, sizes)],
        "levels_used": used,
        "reason": "",
    }


# --- the two cases --------------------------------------------------------------------------------


def sod_catalog():
    parameter = {
        "key": "gamma",
        "value": 1.4,
        "default": 1.4,
        "unit": "1",
        "low": 1.01,
        "high": 3,
        "description": "ratio of specific heats",
    }
    end = {
        "key": "t_end",
        "value": 0.143,
        "default": 0.143,
        "unit": "s",
        "low": 0,
        "high": 0.2,
        "description": "end time",
    }
    return {
        "name": "sod",
        "title": "Sod’s shock tube",
        "source": "York 4.1 (SAND97-1893), Figs. 13 and 14; Sod 1978",
        "claim": "The density error of the default scheme falls at first order through all waves.",
        "physics": "A diaphragm parts a dense from a thin gas. When it bursts, a shock runs into the thin gas, "
        "a contact follows it, and a rarefaction runs back.\n\nThe gas is ideal and has no viscosity.",
        "equations": ["∂ρ/∂t + ∂(ρu)/∂x = 0", "∂(ρu)/∂t + ∂(ρu² + p)/∂x = 0", "p = (γ − 1) ρ e"],
        "sketch": SKETCH,
        "cells_along": "the tube, length 1",
        "parameters": [parameter, end],
        "reference": {
            "name": "riemann",
            "text": "Exact Riemann solver [Toro 4.2–4.5], Newton iteration for the pressure between "
            "the waves.",
            "bound": "computed for each call from the residual; about 1e-13 here",
        },
        "theory_order": {
            "density.L1": {"order": 1, "why": "a shock is smeared over a fixed number of cells"}
        },
        "known_limits": ["No overshoot limiter at the contact.", "One wall distance only."],
        "gates": [
            {
                "id": "density-order",
                "scheme": "default",
                "tier": "full",
                "quantity": "density.L1 order",
                "expected": {"low": 0.9, "high": None},
                "origin": "theory",
                "reason": "first order",
                "cause": None,
            }
        ],
        "regenerate": "plumbline verify sod --tier quick",
    }


def sod_profile(cells, wide):
    x = (numpy.arange(int(4.5 * cells)) + 0.5) / int(4.5 * cells)
    columns = {"x": x, "volume": numpy.full(len(x), 1 / len(x))}
    for (name, exact), computed in zip(
        zip(("density", "velocity", "pressure"), sod_exact(x)), smeared(x, wide / cells)
    ):
        columns[name], columns[name + "_reference"] = computed, exact
    columns["energy"] = columns["pressure"] / columns["density"] / 0.4
    columns["energy_reference"] = columns["pressure_reference"] / columns["density_reference"] / 0.4
    return columns


def sod_study(folder, scheme, errors, wide, choices, **more):
    settings = {**SETTINGS, **choices}
    levels = []
    for cells, error in zip(CELLS, errors):
        measures = {
            "density.L1": measure(error),
            "density.Linf": measure(30 * error**0.5 * 0.05),
            "velocity.L1": measure(2 * error),
        }
        levels.append(
            run_object(
                "sod",
                scheme,
                cells,
                settings,
                measures,
                value=cells,
                drift=3e-15 * wide if scheme == "default" else 2e-13,
            )
        )
        write_run(folder, levels[-1], sod_profile(cells, wide))
    sizes = [level["h"] for level in levels]
    fits = {
        name: fit([level["measures"][name]["error"] for level in levels], sizes, more.get("used"))
        for name in levels[0]["measures"]
    }
    return write_study(folder, "sod", scheme, "cells", levels, fits, sod_catalog(), **more)


def finite_volumes(errors):
    """The table of another method at the levels of a study."""
    cells = numpy.array(CELLS[: len(errors)], dtype=float)
    steps = numpy.floor(1.4 * cells)
    columns = {
        "cells": cells,
        "steps": steps,
        "cell_steps": cells * steps,
        "wall_s": cells * steps / 4e7,
        "density.L1": errors,
        "velocity.L1": 2 * numpy.array(errors),
    }
    return {"finite-volume": ("Finite volumes, MUSCL-HLLC", columns)}


def bench_document():
    """What `plumbline bench` writes: times of an invented machine, twice as fast on two threads."""
    kernels = []

    def add(part, dimension, shape, transfer, points, threads, axisymmetric=False):
        works = shape != "linear" and transfer != "flip"
        rate = 4.6e7 * threads * (1.2 if points < 50000 else 1.0) / dimension
        kernels.append(
            {
                "name": f"{dimension}-D {shape} {transfer} {'leapfrog' if works else 'musl'}",
                "part": part,
                "dimension": dimension,
                "axisymmetric": axisymmetric,
                "material": "gas",
                "shape": shape,
                "transfer": transfer,
                "integrator": "leapfrog" if works else "musl",
                "points": points,
                "ppc": 16,
                "threads": threads,
                "steps": 160,
                "repeats": 5,
                "particle_steps_per_s": rate,
                "fastest": 1.04 * rate,
                "slowest": 0.9 * rate,
                "bytes_per_point": 708.0 if works else None,
                "flops_per_point": 926.0 if works else None,
                "bandwidth_fraction": 0.61 if works else None,
                "flop_fraction": 0.42 if works else None,
                "fraction_of_limit": 0.61 if works else None,
                "stored_bytes_per_point": 132.0,
                "memory_bytes_per_point": 214.0 if points > 2000 else 262.0,
                "energy_drift": 3e-16,
            }
        )

    for threads in (1, 2):
        add("target", 2, "quadratic", "apic", 1000000, threads)
    for size in (1000, 10000, 100000, 1000000, 10000000):
        for threads in (1, 2):
            add("scale", 2, "quadratic", "apic", size, threads)
    for dimension, axisymmetric in ((1, False), (2, False), (2, True), (3, False)):
        for shape in ("linear", "quadratic"):
            for transfer in ("apic", "flip"):
                for threads in (1, 2):
                    add("matrix", dimension, shape, transfer, 200000, threads, axisymmetric)
    tube = {**kernels[0], "part": "run", "name": "gas, 1-D, 1600 cells", "steps": 1800, "wall_s": 0.42}
    missing = {name: None for name in ("bytes_per_point", "flops_per_point", "fraction_of_limit")}
    kernels.append({**tube, **missing})
    target = {"name": "2-D quadratic apic leapfrog, 1e+06 points", "unit": "particle-steps/s", "low": 4.5e7, "high": None}
    ratio = {"name": "max over min cost of a particle-step", "unit": "1", "low": None, "high": 1.5}
    return {
        "machine": {
            "cpu": PROVENANCE["cpu"],
            "instruction_set": PROVENANCE["instruction_set"],
            "cache_bytes": [32768, 1048576, 33554432],
            "copy": [{"threads": 1, "bytes": 2.0**28, "bytes_per_s": 2.1e10}],
            "multiply_add": [{"threads": 1, "flops_per_s": 4.4e10}],
        },
        "kernels": kernels,
        "targets": [{**target, "measured": 4.6e7, "met": True}, {**ratio, "measured": 1.8, "met": False}],
        "empty_step": {"seconds_per_step": 6.1e-7},
        "provenance": {**PROVENANCE, "command": "plumbline bench --points 1e7"},
    }


def write_bench(folder):
    (folder / "bench.json").write_text(json.dumps(bench_document()), encoding="utf-8")


def bar_radius(integrator, place, wave, dt):
    """Spectral radius of one point a cell at `place`, frozen, of a periodic bar: closed form of the two-point step."""
    s = math.sin(wave / 2) ** 2
    x, h = 4 * dt**2 * s, 1 - 4 * place * (1 - place) * s
    trace, product = (2 - x, 1 - x * (1 - h)) if integrator == "usl" else (2 - x * h, 1.0)
    root = cmath.sqrt(trace**2 / 4 - product)
    return max(abs(trace / 2 + root), abs(trace / 2 - root))


def bar_limit(integrator, place, ppc=1):
    """The limit that belongs to it; with more points a cell an invented one that varies less with their place."""
    n = place * (1 - place)
    if integrator == "usl":
        alone = 1 / math.sqrt(1 + 4 * n)
    else:
        alone = 4 * math.sqrt(n) if n >= 1 / 8 else 1 / abs(1 - 2 * place)
    mean = 0.76 if integrator == "usl" else 1.62
    return mean + (alone - mean) / ppc**2


def _bar_configuration(integrator, place, transfer="flip"):
    limit = bar_limit(integrator, place)
    steps = [0.1 * (number + 1) for number in range(30)]
    waves = [math.pi * (number + 1) / 32 for number in range(32)]

    def largest(dt):
        found = max((bar_radius(integrator, place, wave, dt), wave) for wave in waves)
        return {"dt": dt, "per_step": found[0] + 3e-13, "wave_number": [found[1]]}

    return {
        "integrator": integrator,
        "settings": {"shape": "linear", "transfer": transfer, "ppc": 1, "N": place, "positions": "frozen"},
        "unit": "h/c",
        "predicted": [{"low": 0, "high": limit * (1 + 3e-8)}],
        "closed_form": limit,
        "observed": [{"low": 0.998 * limit, "high": 1.001 * limit}],
        "always": None,
        "growth": [largest(dt) for dt in steps],
        "observed_growth": [
            {"dt": dt, "per_step": 0.99 * largest(dt)["per_step"] + 0.01} for dt in (1.05 * limit, 1.2 * limit)
        ],
        "scanned": {"low": 0.1, "high": 3, "steps": 30},
        "threshold": 1e-6,
        "differences": {"size": 1e-3, "error": 1e-13},
        "reach": 2,
        "degrees_of_freedom": 4,
        "sampled": "stable on the sampled set: 12 offsets, 1 point a cell",
    }


def _growing_configuration(integrator, transfer, rate, always):
    """What grows however small the step is."""
    return {
        **_bar_configuration("usf", 0.3, transfer),
        "integrator": integrator,
        "predicted": [],
        "closed_form": None,
        "observed": [],
        "always": always,
        "growth": [{"dt": 0.05 * n, "per_step": math.exp(rate * 0.05 * n), "wave_number": [0.7]} for n in range(1, 40)],
        "observed_growth": [],
    }


def bar_maps(integrators=("usf", "musl", "usl"), shapes=("linear",), transfers=("flip",), across=40, up=30):
    """A map of limits and one of growth for each combination, with observed limits."""
    found = []
    places = [(number + 0.5) / across for number in range(across)]
    waves = [math.pi * (number + 1) / across for number in range(across)]
    steps = [3 * (number + 1) / up for number in range(up)]
    for shape in shapes:
        for integrator in integrators:
            for transfer in transfers:
                name = f"bar/{integrator}/{shape}/{transfer}"
                common = {"integrator": integrator, "shape": shape, "transfer": transfer, "unit": "h/c"}
                limits = [[bar_limit(integrator, place, ppc) for place in places] for ppc in (1, 2, 3, 4)]
                found.append(
                    {
                        **common,
                        "id": f"{name}/limit",
                        "title": f"Largest stable step, {integrator}",
                        "kind": "limit",
                        "x": {"name": "N", "label": "place of the points in their cell", "values": places},
                        "y": {"name": "ppc", "label": "points per cell", "values": [1, 2, 3, 4]},
                        "values": limits,
                        "closed_form": [limits[0], *([None] * across for _ in range(3))],
                        "observed": [
                            {"x": places[index], "y": ppc, **_around(limits[ppc - 1][index], 0.997, 1)}
                            for index in range(3, across, 9)
                            for ppc in (1, 3)
                        ],
                    }
                )
                radii = [[bar_radius(integrator, 0.3, wave, dt) for wave in waves] for dt in steps]
                closed = [{"x": wave, "y": _closed_step(integrator, wave)} for wave in waves]
                found.append(
                    {
                        **common,
                        "id": f"{name}/growth",
                        "title": f"Growth, {integrator}",
                        "kind": "growth",
                        "x": {"name": "theta", "label": "wave number times cell size", "values": waves},
                        "y": {"name": "dt", "label": "step in h/c", "values": steps},
                        "values": radii,
                        "closed_form_curve": closed,
                        "observed": [
                            {"x": None, "y": None, **_around(min(c["y"] for c in closed), 0.99, 1.01)},
                            *(
                                {**closed[index], **_around(closed[index]["y"], 0.98, 1.01)}
                                for index in range(across // 2, across, 6)
                            ),
                        ],
                    }
                )
    return found


def _around(value, low, high):
    return {"low": low * value, "high": high * value}


def _closed_step(integrator, wave):
    """Where the spectral radius of a wave passes 1 [points at N = 0.3]."""
    s = math.sin(wave / 2) ** 2
    h = 1 - 0.84 * s
    return math.sqrt(4 / (4 * s * (2 - h))) if integrator == "usl" else 1 / math.sqrt(s * h)


def _known(integrator, parameters, rows):
    problems = list(dict.fromkeys(row["problem"] for row in rows))
    return {"integrator": integrator, "parameters": parameters, "problems": problems, "rows": rows}


def _limit(problem, limit, **more):
    row = {"problem": problem, "choices": "linear flip, ppc 2", "unit": "h/c", "limit": limit, "endless": False}
    return {**row, "closed_form": None, "growth": None, "smallest": False, "note": "", **more}


def _safe(integrator, shape, transfer, ppc, limit, **more):
    offset, edge = (0.0, 0.99 * limit) if limit else (None, None)
    entry = {"integrator": integrator, "shape": shape, "transfer": transfer, "ppc": ppc, "limit": limit}
    entry |= {"offset": offset, "regular": limit and 1.2 * limit, "edge": edge, "edge_depth": 1e-4 if limit else None}
    return {**entry, "always": None, **more}


def stability_document(maps=None):
    """What `plumbline stability all --maps` writes, with nulls and empty lists wherever there may be some."""
    bar = [_bar_configuration(name, place) for name in ("usf", "musl", "usl") for place in (0.1, 0.3, 0.5)]
    bar.append(_growing_configuration("usl", "apic", 1e-3, None))
    bar.append(_growing_configuration("forward_euler", "flip", 0.4, "unstable"))
    safe = [
        _safe("usf", "linear", "flip", 1, 1.0),
        _safe("usf", "linear", "flip", 2, 1.414, regular=1.735),
        _safe("musl", "quadratic", "flip", 2, 2.24),
        _safe("usl", "linear", "flip", 2, 0.7071, edge=0.0141),
        _safe("usl", "linear", "apic", 2, None, always="unstable"),
        _safe("implicit_midpoint", "linear", "flip", 2, None, always="stable"),
        _safe("usl_old", "linear", "flip", 2, None),
    ]
    oscillator = {
        "problem": "oscillator",
        "title": "A linear oscillator",
        "source": None,
        "statement": "One mass on one spring.",
        "equations": ["a = −ω² u"],
        "configurations": [
            {
                **_bar_configuration("usf", 0.5),
                "integrator": name,
                "settings": {},
                "unit": "1/omega",
                "predicted": [{"low": 0, "high": high}],
                "closed_form": high,
                "always": always,
                "observed": observed,
                "orders": {"position": {"order": order, "low": order - 0.01, "high": order + 0.01, "theory": theory}},
            }
            for name, high, always, observed, order, theory in (
                ("usf", 2.0, None, [{"low": 1.9995, "high": 2.0001}], 1.004, 1),
                ("rk4", 2.8284271, None, [{"low": 2.82, "high": None}], 3.997, 4),
                ("implicit_midpoint", None, "stable", [], 2.001, None),
            )
        ],
        "safe": [],
    }
    bare = {
        "integrator": None,
        "settings": {},
        "predicted": [{"low": None, "high": 0.7}, {"low": 0.9, "high": None}],
        "closed_form": None,
        "observed": [{"low": None, "high": None}],
        "always": None,
        "growth": [{"dt": None, "per_step": None}, {"dt": 0.8, "per_step": 1.02}],
        "observed_growth": None,
        "scanned": None,
        "threshold": None,
        "sampled": None,
    }
    smallest = {"problem": "bar-edge", "choices": "linear flip, ppc 2, depth 0.01", "limit": 0.0141}
    for configuration in bar[6:9]:
        configuration["smallest_known"] = {**smallest, "is_this": False}
    bar[0]["smallest_known"] = {"problem": "bar", "choices": "linear flip, N 0.1", "limit": bar_limit("usf", 0.1), "is_this": True}
    return {
        "known_limits": [
            _known("usl", {}, [_limit("bar-edge", 0.0141, smallest=True), _limit("bar", 0.7071), _limit("gas", 0.0, growth=1.02)]),
            _known(
                "generalized-alpha",
                {"rho_b": 0.5},
                [
                    _limit("plane", 1.2345678, smallest=True),
                    _limit("bar", None, endless=True),
                    _limit("coupled", None, note="it gives no loss back"),
                    _limit("oscillator", 1.9, unit="1/omega"),
                ],
            ),
        ],
        "problems": [
            {
                "problem": "bar",
                "title": "A periodic bar",
                "source": "York, SAND97-1893, chapter 8",
                "statement": "Small waves on a periodic bar.\n\nThe points rest; `N` is their place in the cell.",
                "equations": ["σ = E ∂u/∂x", "ρ ∂²u/∂t² = ∂σ/∂x"],
                "configurations": bar,
                "maps": bar_maps() if maps is None else maps,
                "safe": safe,
            },
            oscillator,
            {"problem": "gas", "title": None, "statement": None, "configurations": [bare], "maps": None, "safe": None},
            {"problem": "contact"},
        ],
        "provenance": {**PROVENANCE, "command": "plumbline stability all --maps"},
    }


def write_stability(folder, document=None):
    document = stability_document() if document is None else document
    (folder / "stability.json").write_text(json.dumps(document, allow_nan=False), encoding="utf-8")


def sod_dt_study(folder):
    levels = []
    for level, dt in enumerate((2e-4, 1e-4, 5e-5, 2.5e-5, 1.25e-5)):
        settings = {**SETTINGS, "cfl": None, "dt": dt}
        levels.append(
            run_object(
                "sod",
                "default",
                200,
                settings,
                {"density.L1": measure(0.0030 + 2 * dt)},
                value=dt,
                h=dt,
                steps=int(0.143 / dt),
            )
        )
    errors, steps = [entry["measures"]["density.L1"]["error"] for entry in levels], [
        entry["value"] for entry in levels
    ]
    write_study(
        folder,
        "sod",
        "default",
        "dt",
        levels,
        {"density.L1": {**fit(errors, steps), "reason": "space error dominates"}},
        sod_catalog(),
        title="Time step alone",
        why="an error that grows as dt falls would be a leak per step",
    )


def spring_catalog():
    return {
        "name": "spring-mass",
        "title": "Mass on a massless spring",
        "source": "York 5.5 (SAND97-1893), Fig. 26",
        "claim": "Period and amplitude of a mass on a membrane spring agree with the closed form.",
        "physics": "A mass hangs on a string of ten points and is released from rest.",
        "equations": ["ω = √(k/m)", "k = E A / L"],
        "sketch": "",
        "cells_along": "height of the grid",
        "parameters": [],
        "reference": {"name": "spring", "text": "Closed form [York 5.11].", "bound": 1e-15},
        "theory_order": {"period": {"order": 1, "why": "the mass is smeared over the kernel"}},
        "known_limits": [],
        "gates": [],
        "regenerate": "plumbline verify spring-mass --tier quick",
    }


def spring_profile():
    time = numpy.linspace(0, 0.1, 400)
    exact, close = (-0.0025 * (1 - numpy.cos(2 * numpy.pi * time / period)) for period in (0.01986, 0.01987))
    return {
        "time": time,
        "displacement": close,
        "displacement_reference": exact,
        "kinetic_energy": close**2,
        "kinetic_energy_reference": exact**2,
        "elastic_energy": -close,
        "elastic_energy_reference": -exact,
    }


def spring_files(folder):
    settings = {"integrator": "musl", "transfer": "flip", "shape": "linear", "dt": 1.8e-6}
    measures = {
        "period": measure(1.2e-5, 0.01987, 0.0198592, "s"),
        "max_displacement": measure(2e-6, 0.004997, 0.004995, "m"),
        "energy_drift": measure(None, 2e-3, None, "1", None),
        "largest_stretch": measure(0.0, 1.625, None, "1", 0.0),  # a value without a reference, whose file states an error
    }
    run = run_object(
        "spring-mass", "york1997", 20, settings, measures, points=10, steps=55556, wall_s=0.07, time=0.1
    )
    write_run(folder, run, spring_profile(), "history")
    levels = [
        run_object(
            "spring-mass",
            "default",
            cells,
            {"integrator": "energy", "transfer": "apic", "shape": "quadratic"},
            {"period": measure(2e-4 * 20 / cells, 0.0199, 0.0198592, "s")},
            value=cells,
            points=cells,
        )
        for cells in (20, 40, 80, 160, 320)
    ]
    errors, sizes = [level["measures"]["period"]["error"] for level in levels], [
        level["h"] for level in levels
    ]
    write_study(
        folder, "spring-mass", "default", "cells", levels, {"period": fit(errors, sizes)}, spring_catalog()
    )
    return run["file"]


def all_gates():
    order = {
        "interval": [0.952, 1.031],
        "origin": "theory",
        "reason": "first order where a shock is smeared over a fixed number of cells",
    }
    cause = "the noise of cell crossing does not fall with the mesh, and a fixed step per cell keeps it"
    return [
        gate("sod", "default", "density-100", "density.L1 at 100 cells", None, 0.0070, "PASS", 0.0066),
        gate(
            "sod",
            "default",
            "density-1600",
            "density.L1 at 1600 cells",
            None,
            0.0005,
            "PASS",
            0.00044,
            margin=0.12,
        ),
        gate("sod", "default", "order", "density.L1 order", 0.9, None, "PASS", 0.985, **order),
        gate(
            "sod",
            "default",
            "velocity-order",
            "velocity.L1 order",
            0.9,
            None,
            "INCONCLUSIVE",
            0.93,
            **{**order, "interval": [0.84, 1.02]},
        ),
        gate(
            "sod",
            "default",
            "default/energy-drift",
            "relative drift of energy",
            None,
            1e-12,
            "PASS",
            3.1e-15,
            origin="identity",
            margin=0.99,
        ),
        gate(
            "sod",
            "york1997",
            "stall",
            "density.L1 at 400 cells",
            None,
            0.0025,
            "XFAIL",
            0.0064,
            band={"low": 0.005, "high": 0.0085},
            origin="regression",
            cause=cause,
        ),
        gate(
            "sod",
            "york1997",
            "density-100",
            "density.L1 at 100 cells",
            0.009,
            0.011,
            "FAIL",
            0.0117,
            origin="literature",
            reason="York's Fig. 14, read off the print",
            margin=-0.7,
        ),
        gate(
            "spring-mass",
            "york1997",
            "period",
            "period",
            0.0198195,
            0.0198989,
            "XPASS",
            0.01987,
            margin=0.7,
            cause="drift",
        ),
        gate(
            "spring-mass",
            "york1997",
            "amplitude",
            "max_displacement",
            0.00494505,
            0.00504495,
            "INVALID",
            None,
            margin=None,
        ),
        gate(
            "spring-mass",
            "usavg",
            "finite",
            "finite",
            None,
            None,
            "NONE",
            None,
            reason="no expectation is stated for this scheme",
        ),
    ]


def write_verdicts(folder, gates=None, declared=None):
    gates = all_gates() if gates is None else gates
    counts = {verdict: sum(entry.get("verdict") == verdict for entry in gates) for verdict in VERDICTS}
    verdicts = {
        "gates": gates,
        "counts": counts,
        "executed": len(gates),
        "declared": len(gates) if declared is None else declared,
        "tier": "quick",
    }
    parts = {
        "verdicts": verdicts,
        "gates": gates,
        "catalog": {"sod": sod_catalog(), "spring-mass": spring_catalog()},
        "provenance": PROVENANCE,
    }
    name = f"verdicts-quick-{digest(gates)}.h5"
    create(folder / name, "verdicts", parts).close()
    return name


def write_truncated(folder, whole):
    """A copy of a whole file that lost its second half."""
    content = (folder / whole).read_bytes()
    name = "sod-default-50-00000000dead.h5"
    (folder / name).write_bytes(content[: len(content) // 2])
    return name


def write_all(folder, damaged=True):
    """The whole folder; returns the names of the files that tests ask for."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    names = {
        "study": sod_study(
            folder,
            "default",
            (0.0066, 0.0033, 0.0017, 0.00084, 0.00044),
            1.6,
            {},
            title="Points of equal mass",
            why="a shock is smeared over a fixed number of cells",
            comparators=finite_volumes((0.0041, 0.0021, 0.0011, 0.00056, 0.0003)),
        )
    }
    write_bench(folder)
    write_stability(folder)
    synthetic_draw.write(folder)
    synthetic_mutants.write(folder)
    synthetic_scorecards.write(folder)
    sod_study(
        folder,
        "default",
        (0.0081, 0.0049, 0.0031, 0.0019, 0.0012),
        2.6,
        {"points": "equal-volume"},
        title="Points of equal volume",
        why="the jump in point mass at the contact costs about 0.3 of the order",
    )
    sod_study(
        folder,
        "york1997",
        (0.0098, 0.0066, 0.0064, 0.0089, 0.0131),
        2.0,
        used=[True, True, True, True, False],
        choices={"integrator": "musl", "transfer": "flip", "shape": "linear", "cfl": None},
        title="York’s own choices",
        id="york1997",
    )
    sod_dt_study(folder)
    names["run"] = spring_files(folder)
    names["frames"] = add_frames_to_the_finest(folder, "sod-default-1600-*.h5")
    names["verdicts"] = write_verdicts(folder)
    if damaged:
        names["truncated"] = write_truncated(folder, names["run"])
    return names


def add_frames_to_the_finest(folder, pattern):
    name = sorted(path.name for path in folder.glob(pattern))[0]
    add_frames(folder / name)
    return name


def spring_files_only(folder):
    """A small whole folder."""
    folder.mkdir(parents=True, exist_ok=True)
    return spring_files(folder)


if __name__ == "__main__":
    write_all(sys.argv[1])
