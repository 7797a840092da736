"""What accuracy costs, as numbers: the cost at which a refinement reaches an error, ratios of such costs, and fronts.

Pure arithmetic on (cost, error) pairs in the order of refinement; nothing here knows of files or pages.
"""

import math
from dataclasses import dataclass

AT, MOST, MORE, NONE = "at", "most", "more", "none"


@dataclass(frozen=True)
class Reach:
    """The cost of reaching an error: `at` it; at `most` it (the coarsest level is better already); `more` than it (the
    finest level is not there yet); or `none`, where no level has an error.
    """

    kind: str
    cost: float = math.nan
    levels: int = 0

    @property
    def never(self):
        return self.kind in (MORE, NONE)


def reach(levels, target):
    """The cost from which on all finer levels have at most the error `target`.

    `levels`: (cost, error) from coarse to fine; between two of them ln error is a straight line in ln cost. A level
    whose error is no number (the run stopped) is not at the target. Costs must be positive.
    """
    if not levels:
        return Reach(NONE)
    count = len(levels)
    good = [error is not None and error <= target for _, error in levels]
    if not good[-1]:
        return Reach(MORE, max(cost for cost, _ in levels), count)
    first = count
    while first > 0 and good[first - 1]:
        first -= 1
    if first == 0:
        return Reach(AT if levels[0][1] == target else MOST, levels[0][0], count)
    (cost, error), (fine_cost, fine_error) = levels[first - 1], levels[first]
    if error is None or fine_error <= 0:
        return Reach(MOST, fine_cost, count)
    share = math.log(error / target) / math.log(error / fine_error)
    return Reach(AT, math.exp(math.log(cost) + share * math.log(fine_cost / cost)), count)


@dataclass(frozen=True)
class Ratio:
    """A cost over another: `sign` is "" where both are known, "<" or ">" where it is a bound, "?" where nothing follows."""

    value: float = math.nan
    sign: str = "?"


_SIGNS = {
    (AT, AT): "",
    (AT, MOST): ">",
    (AT, MORE): "<",
    (MOST, AT): "<",
    (MOST, MORE): "<",
    (MORE, AT): ">",
    (MORE, MOST): ">",
}


def ratio(own, base):
    """`own` relative to `base`, two Reach."""
    sign = _SIGNS.get((own.kind, base.kind), "?")
    return Ratio(own.cost / base.cost, sign) if sign != "?" else Ratio()


def front(points):
    """Indices of those (cost, error) that no other beats in both, by growing cost; of equal ones the first."""
    best, chosen = math.inf, []
    for index in sorted(range(len(points)), key=lambda k: (points[k], k)):
        if points[index][1] < best:
            best = points[index][1]
            chosen.append(index)
    return chosen


def spread(samples):
    """(median, least, most) of repeated times."""
    ordered = sorted(samples)
    middle = len(ordered) // 2
    median = ordered[middle] if len(ordered) % 2 else (ordered[middle - 1] + ordered[middle]) / 2
    return median, ordered[0], ordered[-1]
