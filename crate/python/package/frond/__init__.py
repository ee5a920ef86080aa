"""Frond: shapes made of smaller copies of themselves, the attractors of iterated function systems (IFS).

    >>> import frond
    >>> fern = frond.presets()["fern"]
    >>> fern.rasterize(600, 600).shape
    (600, 600, 4)
    >>> frond.connectedness(frond.presets()["gasket"]).verdict
    'connected'

A map is a row (a, b, c, d, e, f): x' = a x + b y + e, y' = c x + d y + f, with y pointing up. Arrays are NumPy's. What
is wrong is raised as a `FrondError`, a `ValueError` with a stable ``code``. The answers are those of the package for
JavaScript, bit for bit. While something is computed, other threads go on.
"""

from ._errors import FrondError
from ._frond import __version__
from ._fit import Curve, Edge, Figures, fit_curve
from ._ifs import Box, Ifs, Points, Preset, presets
from ._link import Linked, link, open_link
from ._morph import Morph
from ._outline import Measures, Outline, Warned, measure, trace
from ._verdict import Check, Verdict, certificate, check, connectedness
from ._way import STATES, Locus, Path, PathCheck, PathProof, certify_path, check_path, locus, plan_path

__all__ = [
    "STATES",
    "Box",
    "Check",
    "Curve",
    "Edge",
    "Figures",
    "FrondError",
    "Ifs",
    "Linked",
    "Locus",
    "Measures",
    "Morph",
    "Outline",
    "Path",
    "PathCheck",
    "PathProof",
    "Points",
    "Preset",
    "Verdict",
    "Warned",
    "certificate",
    "certify_path",
    "check",
    "check_path",
    "connectedness",
    "fit_curve",
    "link",
    "locus",
    "measure",
    "open_link",
    "plan_path",
    "presets",
    "trace",
]

# What its users see, in errors and in `help`, is named as they import it.
for _name in __all__:
    if isinstance(_told := globals()[_name], type):
        _told.__module__ = __name__
del _name, _told
