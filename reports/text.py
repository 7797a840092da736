"""Numbers, bounds and settings as the page prints them: independent of the locale, with honest digits."""

import math
import re

from jinja2.utils import markupsafe

MISSING = "—"
_SUPERSCRIPTS = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def superscript(integer):
    return str(integer).translate(_SUPERSCRIPTS)


def number(value, digits=3):
    """A number with `digits` significant digits; powers of ten outside 0.001 ... 99999; None gives a dash."""
    if value is None:
        return MISSING
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return str(value)
    if not math.isfinite(value):
        return MISSING
    if value == 0:
        return "0"
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    exponent = int(exponent)
    sign = "−" if value < 0 else ""
    if -3 <= exponent < 5:
        return sign + _plain(f"{abs(value):.{max(digits - 1 - exponent, 0)}f}")
    mantissa = _plain(mantissa)
    return f"{sign}{mantissa}\u202f×\u202f10{superscript(exponent)}"


def _plain(digits):
    return digits.rstrip("0").rstrip(".") if "." in digits else digits


def unit(name):
    """kg/m^3 as kg/m³."""
    return re.sub(r"\^(-?\d+)", lambda power: superscript(power.group(1)), name)


def count(value):
    """A whole number with narrow spaces between thousands; a long one in powers of ten."""
    if value is None:
        return MISSING
    if abs(value) >= 1e9:
        return number(float(value))
    return f"{int(value):,}".replace(",", "\u202f")


def exact(value):
    """A setting or parameter as it was given, all digits that matter."""
    if value is None:
        return MISSING
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return number(value, 10)
    if isinstance(value, (list, tuple)):
        return ", ".join(exact(item) for item in value)
    if isinstance(value, dict):
        return ", ".join(f"{key} {exact(item)}" for key, item in value.items())
    return str(value)


def interval(pair, digits=3):
    """'[0.952, 1.03]', or nothing where the file states no interval."""
    if not pair or all(end is None for end in pair):
        return ""
    low, high = (number(end, digits) for end in pair)
    return f"[{low}, {high}]"


def expected(bounds):
    """The accepted range of a gate in words of mathematics."""
    low, high = (bounds or {}).get("low"), (bounds or {}).get("high")
    if low is None and high is None:
        return MISSING
    if low is None:
        return f"≤ {number(high, 6)}"
    if high is None:
        return f"≥ {number(low, 6)}"
    if low == high:
        return f"= {number(low, 6)}"
    return f"{number(low, 6)} … {number(high, 6)}"


def measured(value, bounds):
    """The measured value with enough digits to tell it from the bounds it is compared with."""
    ends = [
        end
        for end in ((bounds or {}).get("low"), (bounds or {}).get("high"))
        if end is not None and end != value
    ]
    for digits in range(4, 16):
        if number(value, digits) not in [number(end, digits) for end in ends]:
            break
    return number(value, digits)


def fixed(value, places=3):
    """A number with a fixed count of decimals, so that several stand comparable below each other."""
    return MISSING if value is None else f"{round(value, places) + 0.0:.{places}f}".replace("-", "−")


def order(fit):
    """'0.985 [0.952, 1.031]' of a fitted measure."""
    if fit.get("order") is None:
        return MISSING
    ends = [fit.get("order_low"), fit.get("order_high")]
    return fixed(fit["order"]) + ("" if None in ends else f" [{fixed(ends[0])}, {fixed(ends[1])}]")


def seconds(value):
    """A duration in the unit a reader would choose."""
    if value is None:
        return MISSING
    for scale, unit in ((1e-6, "µs"), (1e-3, "ms"), (1.0, "s")):
        if abs(value) < 1000 * scale:
            return f"{number(value / scale)} {unit}"
    return f"{number(value / 60)} min"


def plural(amount, singular, plural_form=None):
    return f"{count(amount)} {singular if amount == 1 else plural_form or singular + 's'}"


def listing(words):
    """'a, b and c'."""
    words = list(words)
    return " and ".join([", ".join(words[:-1]), words[-1]] if len(words) > 1 else words)


def prose(words):
    """Escaped text in which `name` is set as code."""
    return markupsafe.Markup(re.sub("`([^`]+)`", r"<code>\1</code>", str(markupsafe.escape(words))))
