"""Values of a key: as somebody would choose them, at the ends of the range, and such as are wrong."""
import math

HOSTILE = ("", " ", "=", "nan", "-nan", "inf", "-inf", "1e999", "-1e999", "1e-999", "0x10", "1_000", "1,5", "1e3 ", "1;2", "１", "é", "\u202e1",
           "\U0001f600", "9" * 400, "x" * 5000, "--", "-", "%s%n", "{}", "null", "true", "auto", "none", "\t", "1\n2", "../..", "a\\b", "'", '"', "*")
RAW = (b"\xff\xfe", b"a\xc3", b"\x80=1", b"\xed\xa0\x80")  # not UTF-8


def words(parameter):
    """The names that a key takes, or none where it takes a number."""
    allowed = parameter["allowed"]
    return allowed.removeprefix("one of ").split(", ") if allowed.startswith("one of ") else []


def whole(parameter):
    return parameter["allowed"].startswith("whole number")


def text(number):
    return repr(number) if isinstance(number, float) else str(number)


def ends(parameter):
    """(lowest, highest) allowed, an open end already excluded; infinite where there is none."""
    low, high, allowed = parameter["low"], parameter["high"], parameter["allowed"]
    low = -math.inf if low is None else low
    high = math.inf if high is None else high
    if whole(parameter):
        return int(low), int(high) if math.isfinite(high) else 2**31 - 1
    interval = allowed[min((allowed.find(c) for c in "([" if c in allowed), default=0):]
    if interval.startswith("(") and math.isfinite(low):
        low = math.nextafter(low, math.inf)
    if interval.split("]")[0].count(")") and math.isfinite(high):
        high = math.nextafter(high, -math.inf)
    return low, high


def usual(dice, parameter):
    """Near the default."""
    if names := words(parameter):
        return dice.choice(names)
    low, high = ends(parameter)
    given = parameter["default"]
    if not isinstance(given, (int, float)):
        if "auto" in parameter["allowed"] and dice.random() < 0.3:
            return dice.choice(("auto", "none"))
        given = 1e-3 if parameter["key"] == "dt" else 0.3
    wanted = given * 3 ** dice.uniform(-1, 1) if given else dice.choice((0, dice.uniform(0, 1), dice.uniform(-1, 1)))
    if whole(parameter):
        return text(int(min(max(round(wanted), low), min(high, max(12, 2 * given)))))
    return text(float(f"{min(max(wanted, low), high):.6g}")) if low < float(f"{wanted:.6g}") < high else text(min(max(wanted, low), high))


def extreme(dice, parameter):
    """Allowed by the range, and such as nobody would choose."""
    if names := words(parameter):
        return dice.choice(names)
    low, high = ends(parameter)
    choices = [low, high, 1e300, -1e300, 5e-324, 1e-300, 1e-12, 0.0, -0.0, 1e9, 0.1, math.pi, 1 - 2**-53]
    if whole(parameter):
        choices = [low, low + 1, min(high, 10**6), min(high, 2**31 - 1), high, 10**4]
    fitting = [x for x in choices if low <= x <= high and math.isfinite(x)]
    return text(dice.choice(fitting or [parameter["default"]]))


def wrong(dice, parameter):
    """Outside of the range, or no value at all."""
    low, high = ends(parameter)
    outside = []
    if names := words(parameter):
        outside = [misspelt(dice, dice.choice(names)), dice.choice(names).upper(), dice.choice(names) + " "]
    else:
        outside += [text(math.nextafter(low, -math.inf) if isinstance(low, float) else low - 1)] if math.isfinite(low) else []
        outside += [text(math.nextafter(high, math.inf) if isinstance(high, float) else high + 1)] if math.isfinite(high) else []
        outside += ["1.5", "1e-1"] if whole(parameter) else []
        outside += [f"{parameter['default']} {parameter['unit']}", "1.0.0"]
    return dice.choice((*outside, *outside, *HOSTILE, *RAW))


def misspelt(dice, name):
    """A name with one slip of the finger, never the name itself."""
    at = dice.randrange(len(name))
    letter = dice.choice("abcdefghijklmnopqrstuvwxyz-_.0")
    slips = {name[:at] + name[at + 1:], name[:at] + name[at] + name[at:], name[:at] + letter + name[at + 1:],
             name[:at] + name[at + 1:at + 2] + name[at] + name[at + 2:], name.replace("-", "_"), name + "s", name.capitalize()}
    return dice.choice(sorted(slips - {name}))
