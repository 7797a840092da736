"""How an order changed, as `plumbline diff` judges it: by the slope between two studies and its 95 % interval.

Where both have errors of the same cell sizes, the slope is that of ln(new error/old error) over ln h, in which what both have in
common falls out. Else it is the difference of both orders, with both intervals as independent ones. An interval that is not known
is without bound.
"""

import math

import numpy
import scipy.stats

ORDER_CHANGE = 0.05  # of a slope; less does not count
EQUAL_SHARE = 1e-9  # errors that differ by less are equal but for rounding
LEAST_COMMON_LEVELS = 3


def change(old, new, old_errors=(), new_errors=()):
    """worse, inconclusive, better or same. Orders as [order, low, high], errors as [[cell size, error], ...]."""
    slope, half = paired(old_errors, new_errors) or apart(old, new)
    if abs(slope) <= ORDER_CHANGE:
        return "same"
    if abs(slope) <= half:
        return "inconclusive"
    return "better" if slope > 0 else "worse"


def paired(old, new):
    """(slope, half the width of its interval) over the levels of both; None where fewer than three are common."""
    known = {h: error for h, error in old if h > 0 and error > 0}
    common = [(h, known[h], error) for h, error in new if h in known and error > 0]
    if len(common) < LEAST_COMMON_LEVELS:
        return None
    h, before, after = numpy.array(common).T
    if (abs(after - before) <= EQUAL_SHARE * numpy.maximum(before, after)).all():
        return 0, 0
    fit = scipy.stats.linregress(numpy.log(h), numpy.log(after / before))
    return fit.slope, _quantile(len(common) - 2) * fit.stderr


def apart(old, new):
    halves = [math.inf if None in order else (order[2] - order[1]) / 2 for order in (old, new)]
    return (new[0] or 0) - (old[0] or 0), math.hypot(*halves)


def _quantile(degrees):
    return scipy.stats.t.ppf(0.975, degrees)
