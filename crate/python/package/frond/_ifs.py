"""Shapes: iterated function systems of the plane."""

from __future__ import annotations

from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _frond, _values
from ._errors import unreadable
from ._png import png

MOST_POINTS = 16_777_216
LONGEST_SIDE = 8192


class Points(NamedTuple):
    """Points of an attractor.

    Attributes
    ----------
    positions : ndarray
        Shape (n, 2), float32: x and y of each.
    pieces : ndarray
        Shape (n,), uint8: the map, from 0, whose piece each lies in.
    """

    positions: npt.NDArray[np.float32]
    pieces: npt.NDArray[np.uint8]


class Box(NamedTuple):
    """Where an attractor lies, in units of the plane.

    Attributes
    ----------
    min : ndarray
        Shape (2,): the least x and y, or a little less.
    max : ndarray
        Shape (2,): the largest x and y, or a little more.
    hull : ndarray
        Shape (k, 2): the corners of a convex polygon that holds the attractor, counter-clockwise.
    """

    min: npt.NDArray[np.float64]
    max: npt.NDArray[np.float64]
    hull: npt.NDArray[np.float64]


class Ifs:
    """An iterated function system: 1 to 64 affine maps of the plane.

    Its attractor A is the one compact set with A = w1(A) ∪ .. ∪ wN(A) (Hutchinson 1981). It exists where the maps
    shrink in the long run; each of them alone may stretch. Maps without an attractor can be held and asked for their
    `connectedness`, since a morph may lead through such; everything else refuses them by ``"no-attractor"``.

    Parameters
    ----------
    maps : array_like
        One of, for each of the n maps:

        - a row (a, b, c, d, e, f): x' = a x + b y + e, y' = c x + d y + f; shape (n, 6);
        - a matrix ((a, b, e), (c, d, f)); shape (n, 2, 3);
        - a pair (s, t) of complex numbers, z -> s z + t; shape (n, 2).

        y points up. Fractions and integers become the nearest doubles.
    probabilities : array_like, optional
        How often the chaos game takes each map: n numbers, none negative; they are scaled to sum 1. Default: in
        proportion to the areas of the pieces.

    Raises
    ------
    FrondError
        ``bad-input`` for what is no list of maps, ``no-maps``, ``too-many-maps``, ``not-finite``, ``probabilities``.

    Examples
    --------
    >>> gasket = Ifs([(0.5, 0), (0.5, 0.5), (0.5, 0.5j)])
    >>> round(gasket.dimension(), 4)
    1.585
    """

    __slots__ = ("_given", "_maps", "_probabilities")

    def __init__(self, maps: Any, probabilities: Any = None) -> None:
        if isinstance(maps, Ifs):
            given = maps._given if probabilities is None else probabilities
            maps, probabilities = maps._maps, given
        self._maps = _values.rows(maps)
        self._given = _values.probabilities(probabilities)
        self._probabilities = _frond.checked(self._maps, self._given)

    @property
    def maps(self) -> npt.NDArray[np.float64]:
        """The maps as rows (a, b, c, d, e, f): shape (n, 6), float64, read-only."""
        return self._maps

    @property
    def probabilities(self) -> npt.NDArray[np.float64]:
        """How often the chaos game takes each map: shape (n,), sum 1.

        Raises
        ------
        FrondError
            ``no-attractor`` where none were given and the maps have no attractor.
        """
        if self._probabilities is None:
            # Says what is wrong with the maps.
            _frond.dimension(self._maps)
        return np.array(self._probabilities)

    def __len__(self) -> int:
        return len(self._maps)

    def __repr__(self) -> str:
        given = "" if self._given is None else f", probabilities={self._given}"
        return f"Ifs({self._maps.tolist()}{given})"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Ifs):
            return NotImplemented
        return np.array_equal(self._maps, other._maps) and self._given == other._given

    def __hash__(self) -> int:
        return hash((self._maps.tobytes(), None if self._given is None else tuple(self._given)))

    def __reduce__(self) -> tuple[Any, ...]:
        return (Ifs, (self._maps, self._given))

    def attractor(self, n: int, seed: int = 0) -> Points:
        """Points of the attractor by the chaos game (Barnsley 1988): the same seed gives the same points everywhere.

        Parameters
        ----------
        n : int
            How many, 0 to 16777216.
        seed : int
            0 to 2**32 - 1.

        Returns
        -------
        Points
            ``positions``, float32 of shape (n, 2), in units of the plane, and ``pieces``, uint8 of shape (n,).

        Raises
        ------
        FrondError
            ``bad-input``, ``no-attractor``. Ctrl-C ends it.
        """
        count = _values.whole("n", n, 0, MOST_POINTS)
        start = _values.whole("seed", seed, 0, 2**32 - 1)
        positions, pieces = _frond.attractor(self._maps, self._given, count, start)
        return Points(positions.reshape(-1, 2), pieces)

    def rasterize(
        self,
        width: int = 600,
        height: int = 600,
        *,
        view: Optional[tuple[float, float, float]] = None,
        colouring: str = "map",
        palette: Any = None,
        smooth: bool = True,
        exposure: float = 1.0,
        light_ground: Optional[bool] = None,
        draft: bool = False,
    ) -> npt.NDArray[np.uint8]:
        """The complete picture of the attractor: every pixel that it reaches into by a sixteenth of a pixel is lit.

        Parameters
        ----------
        width, height : int
            Pixels, 0 to 8192.
        view : (x, y, scale), optional
            The point of the plane in the middle, and pixels a unit. Default: all of the attractor, with a margin.
        colouring : {"map", "address", "density"}
            Whether colours tell the first letter of addresses, all letters, or how much of the measure lies there.
        palette : sequence of str, optional
            Colours "#rrggbb" of the maps, repeated where there are more maps. Default: Okabe and Ito's.
        smooth : bool
            Whether edges are smoothed.
        exposure : float
            How bright a density is.
        light_ground : bool, optional
            Whether a density is for a light ground. Default: where the colours of the palette are dark.
        draft : bool
            Whether points are enough, as while something moves.

        Returns
        -------
        ndarray
            Shape (height, width, 4), uint8: red, green, blue and straight alpha, row 0 on top, on a transparent ground.

        Raises
        ------
        FrondError
            ``bad-input``, ``no-attractor``, ``view``.
        """
        across = _values.whole("width", width, 0, LONGEST_SIDE)
        up = _values.whole("height", height, 0, LONGEST_SIDE)
        seen = None
        if view is not None:
            numbers = _values.finite("The view", view)
            if numbers.shape != (3,):
                raise unreadable("The view", "three numbers (x, y, scale) are needed")
            seen = (float(numbers[0]), float(numbers[1]), float(numbers[2]))
        asked = (
            across,
            up,
            seen,
            _values.choice("The colouring", colouring, ("map", "address", "density")),
            _values.colours(palette),
            _values.flag("smooth", smooth),
            _values.real("exposure", exposure, 0.0, 1e6),
            None if light_ground is None else _values.flag("light_ground", light_ground),
            _values.flag("draft", draft),
        )
        return _frond.rasterize(self._maps, self._given, asked).reshape(up, across, 4)

    def bounds(self) -> Box:
        """Where the attractor lies: ``min`` and ``max``, shape (2,), and ``hull``, shape (k, 2), in units of the plane.

        Raises
        ------
        FrondError
            ``no-attractor``.
        """
        low, high, hull = _frond.bounds(self._maps)
        return Box(np.array(low), np.array(high), hull.reshape(-1, 2))

    def dimension(self) -> float:
        """An upper bound of the Hausdorff dimension.

        Where all maps are similitudes it is the similarity dimension (Hutchinson 1981), which is the dimension itself
        unless pieces overlap; else the affinity dimension of the maps (Falconer 1988, first level).

        Raises
        ------
        FrondError
            ``no-attractor``.
        """
        similarity, affinity = _frond.dimension(self._maps)
        return affinity if similarity is None else similarity

    def _repr_png_(self) -> Optional[bytes]:
        """The picture that a notebook shows; maps without an attractor have none."""
        return None if self._probabilities is None else picture(self)


def picture(ifs: Ifs, width: int = 480, height: int = 360) -> Optional[bytes]:
    """A PNG of a shape, `None` where it has no attractor."""
    try:
        return png(ifs.rasterize(width, height))
    except ValueError:
        return None


class Preset(Ifs):
    """A shape of the gallery."""

    __slots__ = ("about", "id", "name")

    def __init__(self, id: str, name: str, about: str, maps: Any) -> None:
        super().__init__(maps)
        self.id = id
        self.name = name
        self.about = about

    def __repr__(self) -> str:
        return f"<Preset {self.id!r}: {self.about}>"

    def __reduce__(self) -> tuple[Any, ...]:
        return (Preset, (self.id, self.name, self.about, self._maps))


def presets() -> dict[str, Preset]:
    """The gallery: shapes by their ids, which links name. Each is an `Ifs` with ``id``, ``name`` and ``about``."""
    return {
        id: Preset(id, name, about, maps.reshape(-1, 6)) for id, name, about, maps in _frond.presets()
    }


def ifs_of(what: str, value: Any) -> Ifs:
    """A shape, or what one can be made of."""
    if isinstance(value, Ifs):
        return value
    if isinstance(value, str):
        found = presets().get(value)
        if found is None:
            raise unreadable(what, f"the gallery has no shape {value!r}")
        return found
    return Ifs(value)
