#!/usr/bin/env python3
"""The MPM of this folder as a program of `plumbline scoreboard`: adapter.py CASE.h5 RESULT.h5.

Exit status 0: the result is written. It knows gases and bars on a line; anything else ends it with a word why.
"""
import sys

from mpm import SECOND_ORDER, Gas, Mpm


def main():
    start, result = sys.argv[1:]
    mpm = Mpm(start, **SECOND_ORDER, transfer="flip")
    if not isinstance(mpm.material, Gas):
        mpm.transfer = "apic"
    elif mpm.material.quadratic > 0:  # shocks are expected; linear viscosity takes the oscillations behind them
        mpm.material.linear = mpm.material.quadratic = 1
    mpm.run(cfl=0.4).write(result)


if __name__ == "__main__":
    main()
