"""The exact motion of a spinning top, from Springborn's paper "The Toy Top" (J. Nonlinear Math. Phys. 7, 2000).

>>> import numpy as np
>>> import toytop
>>> top = toytop.Top.sliding(mass=0.05, com_height=0.03, transverse_inertia=3.0e-5, axial_inertia=2.0e-5)
>>> motion = top.release(tilt=0.35, spin=150.0)
>>> now = motion.at(np.linspace(0.0, 10.0, 1001))
>>> now.quaternion.shape, now.tip.shape
((1001, 4), (1001, 2))
>>> motion.error_bound(t=10.0) < 1e-13
True

Units are SI, or any consistent ones. Quaternions are w, x, y, z (scalar first) from body to fixed coordinates; the third fixed axis
points upward, the third body axis from the tip to the centre of mass. All classes are immutable.
"""

from ._fit import Fitted, fit, simulate
from ._many import Many, many
from ._motion import ClosedForm, Motion
from ._notebook import Page
from ._samples import Samples
from ._score import Score, order, score
from ._top import Top
from ._toytop import __version__

__all__ = [
    "ClosedForm",
    "Fitted",
    "Many",
    "Motion",
    "Page",
    "Samples",
    "Score",
    "Top",
    "__version__",
    "fit",
    "many",
    "order",
    "score",
    "simulate",
]
