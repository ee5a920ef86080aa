"""The connectedness locus of a morph, and paths through it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _frond, _values
from ._errors import unreadable
from ._morph import morph_of, optional

EPSILON = 1 / 600
MOST_SAMPLES = 8192
STATES = ("connected", "touching", "disconnected", "undecided", "no-attractor")
"""What the numbers of `Locus.state` mean."""


class Locus(NamedTuple):
    """Where a morph stays in one piece.

    Attributes
    ----------
    state : ndarray
        Shape (height, width), uint8: 0 connected, 1 touching, 2 disconnected, 3 undecided, 4 no attractor. Row 0 is
        the least v: ``matplotlib.pyplot.imshow(.., origin="lower")``.
    gap : ndarray
        Shape (height, width), float32: the widest gap over the diameter of the attractor, 0 where it holds together,
        NaN where there is none.
    u : ndarray
        Shape (width,): the u of each column.
    v : ndarray
        Shape (height,): the v of each row.
    """

    state: npt.NDArray[np.uint8]
    gap: npt.NDArray[np.float32]
    u: npt.NDArray[np.float64]
    v: npt.NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Path:
    """A path through the parameters of a morph, and what was met along it.

    Attributes
    ----------
    points : ndarray
        Shape (n, 2), or (n, 3) where it leaves the plane w = 0: from (0, 0) to (1, 1), both included.
    gap : float
        The widest gap that was met, relative to the diameter of the attractor; 0 if it holds all the way.
    holds : bool
        Whether no sample along it was broken.
    clearance : float
        The least distance, in (u, v, w), from what is broken.
    worst : tuple[float, ...] or None
        Where the gap is widest; `None` if it holds.
    apart : bool
        Whether the ends lie in different components of what holds on the samples: then no path within them holds.
    step : float
        How far the samples were from each other.
    """

    points: npt.NDArray[np.float64]
    gap: float
    holds: bool
    clearance: float
    worst: Optional[tuple[float, ...]]
    apart: bool
    step: float


class PathCheck(NamedTuple):
    """What was met along a path.

    Attributes
    ----------
    gap : float
        The widest relative gap; infinity where there is no attractor.
    holds : bool
        Whether no sample was broken.
    breaks : list[tuple[float, float]]
        Broken stretches, as fractions of the length of the path in (u, v).
    """

    gap: float
    holds: bool
    breaks: list[tuple[float, float]]


class PathProof(NamedTuple):
    """What is proved of a stretch of a path.

    Attributes
    ----------
    gap : float
        No relative gap is wider anywhere on the stretch: proved. Infinity where nothing is.
    holds : bool
        Whether that is no more than was asked for.
    boxes : int
        Boxes that cover the stretch.
    worst : float
        Where the least could be proved, by length of the whole path.
    complete : bool
        Whether the question is answered: it holds, or a gap as wide is there.
    joints : int
        How many joints of pieces the bound rests on, which stay joined on the whole path; 0 where it rests on boxes.
    """

    gap: float
    holds: bool
    boxes: int
    worst: float
    complete: bool
    joints: int


def locus(
    a: Any,
    b: Any = None,
    *,
    width: int = 121,
    height: int = 121,
    bounds: tuple[float, float, float, float] = (-1.0, -1.0, 2.0, 2.0),
    epsilon: float = EPSILON,
    w: float = 0.0,
) -> Locus:
    """The connectedness locus of a morph (Burch & Hart 1997, section 5): the verdict of every sample of a grid.

    Parameters
    ----------
    a : Morph
        The morph; or the first shape, and
    b : Ifs, array_like or str
        the last, as `Morph` takes them.
    width, height : int
        Samples across and up, both ends included, 1 to 8192: 3 k + 1 puts (0, 0) and (1, 1) on the default grid.
    bounds : (u0, v0, u1, v1)
        The rectangle.
    epsilon : float
        The gap that counts as none, relative to the diameter of each attractor.
    w : float
        The slice: how far the stretch is ahead of the turn.

    Returns
    -------
    Locus
        ``state``, ``gap``, ``u`` and ``v``.

    Raises
    ------
    FrondError
        ``bad-input``, ``locus-size``, ``locus-bounds``, and those of `Morph`. Ctrl-C ends it after a row.
    """
    morph = morph_of(a, b)
    across = _values.whole("width", width, 1, MOST_SAMPLES)
    up = _values.whole("height", height, 1, MOST_SAMPLES)
    box = _values.finite("The bounds", bounds)
    if box.shape != (4,):
        raise unreadable("The bounds", "four numbers (u0, v0, u1, v1) are needed")
    near = _values.real("epsilon", epsilon, 0.0)
    slice_ = _values.real("w", w)
    corners = box.tolist()
    state, gap = _frond.locus(morph._asked, corners, (across, up), near, slice_)
    u0, v0, u1, v1 = corners
    return Locus(
        state.reshape(up, across), gap.reshape(up, across), _samples(u0, u1, across), _samples(v0, v1, up)
    )


def _samples(low: float, high: float, count: int) -> npt.NDArray[np.float64]:
    """As `LocusGrid` of crate/locus places them."""
    found = low + (high - low) * np.arange(count) / (max(count, 2) - 1)
    if count > 1:
        found[-1] = high
    return found


def plan_path(
    a: Any, b: Any = None, *, epsilon: float = EPSILON, size: Optional[int] = None, axes: int = 2
) -> Path:
    """Plans a path from (0, 0) to (1, 1) along which the shape stays in one piece, or comes as near to that as can be.

    Parameters
    ----------
    a, b
        As in `locus`.
    epsilon : float
        The relative gap that counts as none.
    size : int, optional
        Samples a side of the locus that it looks through, 2 to 1024.
    axes : {2, 3}
        3: the stretch may also be ahead of the turn, where the plane has no path.

    Raises
    ------
    FrondError
        ``bad-input``, and those of `Morph`. Ctrl-C ends it within a second or so.
    """
    morph = morph_of(a, b)
    near, side = _values.real("epsilon", epsilon, 0.0), optional(size, 2, 1024, "size")
    space = _values.whole("axes", axes, 2, 3) == 3
    points, gap, holds, clearance, worst, apart, step = _frond.plan_path(morph._asked, near, side, space)
    found = np.array(points)
    flat = not found[:, 2].any()
    return Path(
        found[:, :2].copy() if flat else found,
        gap,
        holds,
        clearance,
        None if worst is None else tuple(worst if worst[2] else worst[:2]),
        apart,
        step,
    )


def check_path(
    a: Any, b: Any = None, *, points: Any, epsilon: float = EPSILON, samples: int = 400
) -> PathCheck:
    """Looks along a path at so many samples, ends included, and tells where it breaks.

    Parameters
    ----------
    a, b
        As in `locus`.
    points : Path or array_like
        Points (u, v) or (u, v, w).
    epsilon : float
        The relative gap that counts as none.
    samples : int
        2 to 100000.

    Raises
    ------
    FrondError
        ``bad-input``, and those of `Morph`.
    """
    morph = morph_of(a, b)
    way = _values.path(points.points if isinstance(points, Path) else points)
    near = _values.real("epsilon", epsilon, 0.0)
    return PathCheck(*_frond.check_path(morph._asked, way, near, _values.whole("samples", samples, 2, 100_000)))


def certify_path(
    a: Any,
    b: Any = None,
    *,
    points: Any,
    within: float = EPSILON,
    t0: float = 0.0,
    t1: float = 1.0,
    budget: Optional[int] = None,
) -> PathProof:
    """Proves as small a bound as it can of the widest gap along a stretch of a path, everywhere and not at samples.

    Parameters
    ----------
    a, b
        As in `locus`.
    points : Path or array_like
        Points (u, v) or (u, v, w).
    within : float
        The relative gap that is to be excluded.
    t0, t1 : float
        The stretch, by length of the path; one moment where they are one number.
    budget : int, optional
        The most boxes to look at, at most 200000.

    Raises
    ------
    FrondError
        ``bad-input``, and those of `Morph`.
    """
    morph = morph_of(a, b)
    way = _values.path(points.points if isinstance(points, Path) else points)
    near = _values.real("within", within, 0.0)
    stretch = (_values.real("t0", t0), _values.real("t1", t1))
    return PathProof(
        *_frond.certify_path(morph._asked, way, near, stretch, optional(budget, 0, 200_000, "budget"))
    )
