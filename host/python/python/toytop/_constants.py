"""Constants of a motion that are numbers, as attributes of `Motion`."""

from operator import methodcaller

from ._toytop import Motion

CONSTANTS = {
    "l": "Vertical angular momentum l, kg m²/s.",
    "n": "Axial angular momentum n = C (omega . r) + K, kg m²/s.",
    "h": "Energy h, J; the potential energy is 0 where the centre of mass is at the height of the tip.",
    "e1": "Branch point e1: the least cosine of the tilt.",
    "e2": "Branch point e2: the greatest cosine of the tilt.",
    "e3": "Branch point e3 >= 1.",
    "e4": "Branch point e4 = sqrt(1 + A/(p s)); None for a fixed tip.",
    "one_plus_e1": "Sum 1 + e1, without the rounding of e1.",
    "one_minus_e2": "Difference 1 - e2, without the rounding of e2.",
    "e2_minus_e1": "Difference e2 - e1, without the rounding of either.",
    "e3_minus_one": "Difference e3 - 1, without the rounding of e3.",
    "period": "Nutation period, s; where the tilt is constant, that of a small nutation. None where no motion nearby is periodic.",
    "alpha_turns": "Mean rotation of alpha in a nutation period, turns, whole turns included; None without a period.",
    "beta_turns": "Mean rotation of beta in a nutation period, turns, whole turns included; None without a period.",
    "phi_per_period": "Advance of the tip angle in a nutation period, rad; None without a period, or where the axis is vertical.",
    "min_normal_force": "Least normal force of the plane, in units of the weight; below 0 a real top leaves the plane. None for a fixed tip.",
}

for name, text in CONSTANTS.items():
    setattr(Motion, name, property(methodcaller("_constant", name), doc=text))
