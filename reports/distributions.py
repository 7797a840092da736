"""Of problems drawn at random: which share of them has a ratio of errors up to a value, one panel a field."""

import numpy

import figures
import reproduce
import svg
import text
from figures import Figure, Key

RATIO = "_ratio_of_errors"  # how the columns of such a profile end


def drawing(case, results, prefix):
    """A line for each trial that has such columns; None where no trial has."""
    lines = [(entry, result.profile) for entry, result in _profiles(case, results)]
    fields = list(dict.fromkeys(name for _, profile in lines for name in profile if name.endswith(RATIO)))
    if not fields:
        return None

    def paint(axes):
        every = numpy.ravel(axes)
        low, high = _limits([profile[name] for _, profile in lines for name in fields if name in profile])
        for panel, name in zip(every, fields):
            for entry, profile in lines:
                if name in profile:
                    ratios, shares = steps(profile[name])
                    panel.plot(ratios, shares, color=svg.series_colour(entry.style), linewidth=1.1, label=entry.label)
            panel.axvline(1, color=svg.MUTED, linewidth=0.9, dashes=(4, 1.5, 1, 1.5))
            panel.axhline(0.5, color=svg.MUTED, linewidth=0.6)
            panel.set(xscale="log", xlim=(low, high), ylim=(0, 1), ylabel=_panel(name))
            panel.yaxis.set_major_locator(figures.MaxNLocator(4))
            figures.log_axis(panel.xaxis, low, high)
        every[-1].set_xlabel("ratio of errors")

    count = max(len(profile[name]) for _, profile in lines for name in fields if name in profile)
    keys = [Key(entry.label, f"var(--s{entry.style % len(svg.SERIES) + 1})") for entry, _ in lines]
    keys.append(Key("equal errors", "var(--muted)", dash=True))
    caption = (
        f"Share of {text.count(count)} problems whose ratio of L1 errors is at most that of the axis, by field; the median "
        "lies where a line passes one half."
    )
    return Figure(
        svg.draw(
            paint, f"{prefix}-draws", "Distributions of the ratios of errors", height=0.5 + 1.3 * len(fields),
            nrows=len(fields), sharex=True, squeeze=False,
        ),
        "Ratios of errors over all problems",
        caption,
        [entry.files[0] for entry, _ in lines],
        keys,
        [command for entry, _ in lines if (command := reproduce.study(entry, case.name))],
    )  # fmt: skip


def steps(values):
    """The empirical distribution function of finite values as corners of its steps: (value, share up to it)."""
    ordered = numpy.sort(values[numpy.isfinite(values)])
    shares = numpy.arange(len(ordered) + 1) / max(len(values), 1)
    return numpy.repeat(ordered, 2), numpy.repeat(shares, 2)[1:-1]


def _profiles(case, results):
    for entry in case.series:
        for level in entry.levels[-1:]:
            result = results.get(level.get("file"))
            if result is not None and any(name.endswith(RATIO) for name in result.profile):
                yield entry, result


def _limits(columns):
    found = numpy.concatenate(columns)
    found = found[numpy.isfinite(found) & (found > 0)]
    return (found.min() / 1.2, found.max() * 1.2) if len(found) else (0.5, 2.0)


def _panel(name):
    return name.removesuffix(RATIO).replace("_", " ")
