"""Orientations at single ticks far away, aimed at the fast part of a motion, where an error of the nutation phase counts most.

Prints what tests/suite/table/ticks_of_any_length_and_epoch.rs holds: a tick of 1 MHz, then Re alpha, Im alpha, Re beta and Im beta.
"""
from mpmath import mp, mpf

import exact_motion

mp.dps = 60
exact_motion.QUADRATURE = mpf("1e-52")
BODY = [mpf(x) for x in (1, 1, 4096, 1)]
BRANCH_POINTS = [mpf(x) for x in ("-0.75", "0.75", "1.0625")]
TICKS = (29201518562686, 8269342170972171531)

motion = exact_motion.Motion(BODY, e=BRANCH_POINTS, signs=(1, 1), theta0=mpf(0), args=(mpf(0), mpf(0)))
for tick in TICKS:
    alpha, beta = motion.state(mpf(tick) / 1000000)[2:4]
    print(tick, *(mp.nstr(x, 20) for x in (alpha.real, alpha.imag, beta.real, beta.imag)))
