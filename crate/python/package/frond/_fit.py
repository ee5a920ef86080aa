"""Curves that are near an outline, within so many numbers or bytes."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _frond, _values
from ._errors import unreadable
from ._outline import points_of, svg


class Figures(NamedTuple):
    """How near a fit is to its outline; errors in percent of the diagonal of the outline's box.

    Attributes
    ----------
    rms : float
        Root mean square distance from the points of the outline to the fit.
    hausdorff : float
        No point of either is farther from the other.
    length_ratio : float
        The length of the fit over that of the outline.
    outline_slope, fit_slope : float
        Box dimensions between 1/64 and 1/256 of the diagonal.
    """

    rms: float
    hausdorff: float
    length_ratio: float
    outline_slope: float
    fit_slope: float


class Edge(NamedTuple):
    """An edge of a curve that is a copy of an arc of it.

    Attributes
    ----------
    start : int
        The knot, from 0, at which the arc begins.
    span : int
        Over how many edges it goes.
    reversed : bool
        Whether it is copied backwards.
    c : float
        The free number of the copy.
    """

    start: int
    span: int
    reversed: bool
    c: float


@dataclass(frozen=True, eq=False)
class Curve:
    """A closed curve that was fitted to an outline.

    Attributes
    ----------
    points : ndarray
        Shape (n, 2), float64: a polyline of it, closed without repeating the first point.
    figures : Figures
        How near it is to the outline.
    size : int
        Bytes that it takes up, everything counted.
    knots : ndarray or None
        Shape (k, 2), of a fit by numbers: where its edges begin.
    edges : list or None
        Of a fit by numbers: an `Edge` for each knot that copies an arc of the curve, `None` for a straight one.
    data : bytes or None
        Of a fit by bytes: the curve itself, which ``unpackSpline`` of the JavaScript package reads.
    word : str or None
        The same in letters.
    corners, bends : int
        Of a fit by bytes: corners and parabolas; else 0.
    """

    points: npt.NDArray[np.float64]
    figures: Figures
    size: int
    knots: Optional[npt.NDArray[np.float64]] = None
    edges: Optional[list[Optional[Edge]]] = None
    data: Optional[bytes] = None
    word: Optional[str] = None
    corners: int = 0
    bends: int = 0

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        return np.array(self.points, dtype=dtype) if copy else np.asarray(self.points, dtype=dtype)

    def __repr__(self) -> str:
        parts = (
            f"{len(self.knots)} knots" if self.knots is not None else f"{self.corners} corners, {self.bends} bends"
        )
        return f"<Curve: {parts}, {self.size} bytes, rms {self.figures.rms:.3g} % of the diagonal>"

    def _repr_svg_(self) -> str:
        """The drawing that a notebook shows."""
        return svg(self.points)


def fit_curve(outline: Any, numbers: Optional[int] = None, *, bytes: Optional[int] = None) -> Curve:
    """The nearest closed curve that is found within so many numbers, or so many bytes.

    Parameters
    ----------
    outline : Outline or array_like
        The outline: as `trace` and `read` give it, or points, shape (n, 2), or n complex numbers.
    numbers : int, optional
        12 to 2000: a curve of knots whose edges are straight or copies of arcs of the curve itself. It is no farther
        from the outline than the best polyline of as many numbers. Default 260, where `bytes` is not given.
    bytes : int, optional
        32 to 4000: a curve of corners and parabolas on a grid, everything counted.

    Returns
    -------
    Curve
        ``points``, ``figures``, ``size``, and the curve itself.

    Raises
    ------
    FrondError
        ``bad-input``, ``too-few-points``, ``flat``, ``no-fit`` and their like. Ctrl-C ends it after a step.

    Notes
    -----
    Curves of copies are after Cochran, Hart and Flynn, "On Approximating Rough Curves With Fractal Functions".
    One of 12 numbers takes a tenth of a second, one of hundreds some seconds.
    """
    if numbers is not None and bytes is not None:
        raise unreadable("The size", "numbers or bytes are needed, and both are given")
    given = points_of(outline)
    if bytes is not None:
        word, data, corners, bends, points, figures = _frond.fit_bytes(
            given, _values.whole("bytes", bytes, 32, 4000)
        )
        return Curve(
            points.reshape(-1, 2), Figures(*figures), len(data), data=data, word=word, corners=corners, bends=bends
        )
    count = _values.whole("numbers", 260 if numbers is None else numbers, 12, 2000)
    knots, edges, points, figures, size = _frond.fit_numbers(given, count)
    return Curve(
        points.reshape(-1, 2),
        Figures(*figures),
        size,
        knots=knots.reshape(-1, 2),
        edges=[None if edge is None else Edge(*edge) for edge in edges],
    )
