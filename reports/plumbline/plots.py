"""Figures of one line: a field of a run over its reference, the errors of a study over the cell size."""

from typing import Any

import numpy

from plumbline.reader import Columns, NotInstalled, Result

REFERENCE = "_reference"


def draw(result: Result, name: str = "", axes: Any = None) -> Any:
    """Draws on the axes, or on those of pyplot, and returns them. See `Result.plot`."""
    if result.kind == "run":
        return draw_field(result, name, axes)
    if result.kind == "study":
        return draw_errors(result, name, axes)
    raise TypeError(f"a result of kind '{result.kind}' has nothing to be drawn; runs and studies have")


def draw_field(run: Result, name: str = "", axes: Any = None) -> Any:
    """One column of the profile over its abscissa, above the reference where there is one."""
    profile = run.profile
    fields = [column.removesuffix(REFERENCE) for column in profile if column.endswith(REFERENCE)]
    name = name or next(iter(fields or profile), "")
    if name not in profile:
        raise KeyError(f"no field '{name}' in the profile of {run.name}; there are: {', '.join(sorted(profile)) or 'none'}")
    axes = _axes(axes)
    x = profile[profile.abscissa]
    if name + REFERENCE in profile:
        order = numpy.argsort(x, kind="stable")
        axes.plot(x[order], profile[name + REFERENCE][order], color="0.7", linewidth=3, label="reference")
    axes.plot(x, profile[name], ".", markersize=3, label=_title(run))
    axes.set_xlabel(_label(profile, profile.abscissa))
    axes.set_ylabel(_label(profile, name))
    axes.legend()
    return axes


def draw_errors(study: Result, name: str = "", axes: Any = None) -> Any:
    """Errors of a measure over the cell size, both logarithmic; the legend gives the order with its 95 % interval."""
    fitted = [measure for measure, fit in study.measures.items() if fit.get("order") is not None]
    name = name or next(iter(fitted), "")
    h, error = study.errors(name)
    fit = study.measures.get(name) or {}
    order = [fit.get(key) for key in ("order", "order_low", "order_high")]
    if None in order:
        words = _title(study)
    else:
        words = f"{_title(study)}\norder {order[0]:.2f} [{order[1]:.2f}, {order[2]:.2f}]{'' if fit.get('asymptotic') else ', not asymptotic'}"
    axes = _axes(axes)
    axes.loglog(h, error, "o-", label=words)
    axes.set_xlabel("cell size in m")
    axes.set_ylabel(f"error of {name}")
    axes.legend()
    return axes


def _axes(axes: Any) -> Any:
    if axes is not None:
        return axes
    try:
        from matplotlib import pyplot
    except ImportError as error:
        raise NotInstalled("matplotlib", "figures need") from error
    return pyplot.gca()


def _title(result: Result) -> str:
    cells = result.settings.get("cells") if result.kind == "run" else None
    return f"{result.case}, {result.scheme}" + (f", {cells} cells" if cells is not None else "")


def _label(columns: Columns, name: str) -> str:
    label = columns.labels.get(name) or name.replace("_", " ")
    unit = columns.units.get(name)
    return f"{label} in {unit}" if unit and unit != "1" else label
