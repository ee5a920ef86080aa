"""The way from one shape to another."""

from __future__ import annotations

from typing import Any, Optional

from . import _frond, _values
from ._errors import unreadable
from ._ifs import Ifs, ifs_of


class Morph:
    """Every shape between two, over the parameters (u, v): u turns and stretches the pieces, v moves them.

    Where the shapes have different numbers of maps, maps of the smaller one are split or doubled, which changes neither
    its shape nor its measure; `steps` says how.

    Parameters
    ----------
    a, b : Ifs, array_like or str
        The first and the last shape: an `Ifs`, maps as it takes them, or the id of a shape of the gallery.
    mode : {"polar", "linear"}
        Whether the polar factors of the linear parts are interpolated (Burch & Hart 1997, eq 6), or the matrices
        element by element, which may flatten a map on the way (their Fig 3).
    correspondence : sequence of int, optional
        ``correspondence[i]`` is the map of the last shape, from 0, that map i of the first becomes. Default: the same.
    turns : sequence of int, optional
        Whole extra turns of each map, counter-clockwise, -16 to 16. Default: the shortest turn.

    Raises
    ------
    FrondError
        ``bad-input``, ``no-attractor``, ``correspondence``, ``turns``.

    Examples
    --------
    >>> len(Morph("dragon", "gasket").at(0.5, 0.5))
    3
    """

    __slots__ = ("_chosen", "_ends", "_given", "a", "b", "steps")

    a: Ifs
    """The first shape, with as many maps as the last."""
    b: Ifs
    """The last shape, with as many maps as the first."""
    steps: list[str]
    """What was done to bring them to one number of maps: a sentence for each step."""

    def __init__(
        self, a: Any, b: Any, *, mode: str = "polar", correspondence: Any = None, turns: Any = None
    ) -> None:
        first, last = ifs_of("The first shape", a), ifs_of("The last shape", b)
        linear = _values.choice("The mode", mode, ("polar", "linear")) == "linear"
        order = _values.integers("The correspondence", correspondence, 0, 63)
        self._chosen = (linear, order, _values.integers("The turns", turns, -(2**31), 2**31 - 1))
        self._ends = (first, last)
        self._given = first._given is not None or last._given is not None
        from_rows, to_rows, from_p, to_p, self.steps = _frond.pair(
            (first.maps, first._given), (last.maps, last._given)
        )
        self.a = Ifs(from_rows.reshape(-1, 6), from_p if self._given else None)
        self.b = Ifs(to_rows.reshape(-1, 6), to_p if self._given else None)
        # Says what is wrong with what was chosen.
        self.at(0.0, 0.0)

    def __repr__(self) -> str:
        linear, order, turns = self._chosen
        chosen = ", mode='linear'" if linear else ""
        chosen += f", correspondence={order}" if order else ""
        chosen += f", turns={turns}" if turns else ""
        return f"Morph({self._ends[0]!r}, {self._ends[1]!r}{chosen})"

    def __reduce__(self) -> tuple[Any, ...]:
        return (_morph, (*self._ends, *self._chosen))

    @property
    def _asked(self) -> tuple[Any, Any, tuple[bool, list[int], list[int]]]:
        return (self.a.maps, self.b.maps, self._chosen)

    def at(self, u: float, v: float, w: float = 0.0) -> Ifs:
        """The shape at (u, v), from (0, 0), the first, to (1, 1), the last.

        Parameters
        ----------
        u, v : float
            How far the pieces have turned and stretched, and how far they have moved. Any finite number: [-1, 2] is
            what the locus shows.
        w : float
            How far the stretch is ahead of the turn.

        Returns
        -------
        Ifs
            It need not have an attractor. Where a shape was given with probabilities, it has those in between.

        Raises
        ------
        FrondError
            ``bad-input``; ``not-finite`` where the maps overflow.
        """
        at = (_values.real("u", u), _values.real("v", v), _values.real("w", w))
        given = (self.a._given, self.b._given) if self._given else None
        rows, probabilities = _frond.interpolate(self._asked, given, at)
        return Ifs(rows.reshape(-1, 6), probabilities)


def _morph(a: Ifs, b: Ifs, linear: bool, order: list[int], turns: list[int]) -> Morph:
    """What a pickled morph is made from."""
    return Morph(
        a, b, mode="linear" if linear else "polar", correspondence=order or None, turns=turns or None
    )


def morph_of(a: Any, b: Any) -> Morph:
    """A morph, or that of two shapes."""
    if isinstance(a, Morph):
        if b is not None:
            raise unreadable("The last shape", "the morph has one already")
        return a
    if b is None:
        raise unreadable("The last shape", "a morph, or two shapes, are needed")
    return Morph(a, b)


def optional(value: Any, low: int, high: int, what: str) -> Optional[int]:
    """A whole number where one is given."""
    return None if value is None else _values.whole(what, value, low, high)
