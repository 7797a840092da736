"""What a kind of random call is, and the table of them."""
import dataclasses


@dataclasses.dataclass(frozen=True)
class Skipped:
    why: str


KINDS = {}


def kind(weight):
    def register(function):
        KINDS[function.__name__] = (weight, function)
        return function
    return register


def pick(dice):
    names = sorted(KINDS)
    return dice.choices(names, [KINDS[name][0] for name in names])[0]


def settings(pairs):
    words = []
    for key, value in pairs:
        words += ["--set", key.encode() + b"=" + value if isinstance(value, bytes) else f"{key}={value}"]
    return words
