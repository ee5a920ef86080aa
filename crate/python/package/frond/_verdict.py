"""Whether a shape is in one piece, with proofs."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Optional

import numpy as np
import numpy.typing as npt

from . import _frond, _values
from ._errors import unreadable
from ._ifs import ifs_of


@dataclass(frozen=True, eq=False)
class Verdict:
    """What is known of whether an attractor is in one piece. Lengths are in units of the plane.

    Attributes
    ----------
    verdict : str
        ``"connected"`` and ``"disconnected"`` are proved; ``"touching"``: the pieces come within epsilon of each
        other, so that it is in one piece as far as that resolution tells; ``"undecided"``: the budget was spent;
        ``"no-attractor"``.
    gap : tuple[float, float]
        Bounds of the widest edge of the least spanning tree between the pieces.
    overlaps : list[tuple[int, int]]
        Pairs of maps, from 0, whose pieces meet, or come within epsilon.
    components : list[int]
        For each map the number, from 0, of the cluster of pieces that its own hangs together with.
    count : int
        How many clusters there are.
    closest : ndarray or None
        Shape (2, 2): the points of two clusters that realise the widest gap; `None` where there is none.
    diameter : float
        A bound of the diameter of the attractor: epsilon is relative to it.
    nodes : int
        Pairs of pieces that were looked at.
    reason : dict[str, Any] or None
        Why it is connected, or under which reading of its numbers it would be: ``kind``, ``text`` (a sentence),
        ``links`` (what holds pieces together), ``assuming`` (readings of numbers), and ``neighbours`` (how many
        neighbour types there are) where there are some.
    """

    verdict: str
    gap: tuple[float, float]
    overlaps: list[tuple[int, int]]
    components: list[int]
    count: int
    closest: Optional[npt.NDArray[np.float64]]
    diameter: float
    nodes: int
    reason: Optional[dict[str, Any]]

    def __bool__(self) -> bool:
        raise TypeError("A verdict is more than yes or no: look at .verdict or .holds.")

    @property
    def holds(self) -> bool:
        """Whether it is in one piece as far as is known: connected, or touching."""
        return self.verdict in ("connected", "touching")

    def __str__(self) -> str:
        return self.verdict


@dataclass(frozen=True)
class Check:
    """What came of the replay of a certificate.

    Attributes
    ----------
    valid : bool
        Whether it proves what it says.
    text : str
        What was checked, or what is wrong, in a sentence.
    pairs : int
        How many pairs of pieces are apart.
    links : int
        How many links hold pieces together.
    longest : int
        Letters of the longest word.
    """

    valid: bool
    text: str
    pairs: int
    links: int
    longest: int

    def __bool__(self) -> bool:
        return self.valid


def _asked(epsilon: Any, budget: Any) -> tuple[Optional[float], Optional[int]]:
    return (
        None if epsilon is None else _values.real("epsilon", epsilon, 0.0),
        None if budget is None else _values.whole("budget", budget, 0, 2**53),
    )


def connectedness(ifs: Any, epsilon: Optional[float] = None, *, budget: Optional[int] = None) -> Verdict:
    """Whether an attractor is in one piece, which of its pieces meet, and how wide the widest gap is.

    Parameters
    ----------
    ifs : Ifs or array_like
        The shape, or its maps as `Ifs` takes them.
    epsilon : float, optional
        Pieces within this distance touch, relative to the diameter of the attractor. Default 1/600, what a picture of
        600 pixels resolves.
    budget : int, optional
        The most pairs of pieces to look at. Default 400000.

    Raises
    ------
    FrondError
        ``bad-input``, ``no-maps``, ``too-many-maps``, ``not-finite``. Maps without an attractor are no error.

    Notes
    -----
    A search over pairs of pieces with bounds of their distances from both sides, after the tests of Burch & Hart
    (1997); ``"connected"`` needs a proof in exact arithmetic.

    Examples
    --------
    >>> connectedness([(0.4, 0), (0.4, 0.6), (0.4, 0.6j)]).verdict
    'disconnected'
    """
    shape, asked = ifs_of("The IFS", ifs), _asked(epsilon, budget)
    verdict, gap, overlaps, components, count, closest, diameter, nodes, reason = _frond.connectedness(
        shape.maps, asked
    )
    return Verdict(
        verdict,
        gap,
        overlaps,
        components,
        count,
        None if closest is None else np.array(closest),
        diameter,
        nodes,
        None if reason is None else _reason(json.loads(reason)),
    )


def _reason(told: dict[str, Any]) -> dict[str, Any]:
    """As the JavaScript API has it: what is empty is absent."""
    for link in told["links"]:
        if not link["corners"]:
            del link["corners"]
    if told["neighbours"] is None:
        del told["neighbours"]
    return told


def certificate(
    ifs: Any, *, epsilon: Optional[float] = None, budget: Optional[int] = None
) -> Optional[dict[str, Any]]:
    """A proof that an attractor is in several pieces, or that it is in one; `None` where neither was found.

    Plain lists and numbers, which ``json.dump`` writes and `check` replays. It has the keys of ``Certificate``
    (``maps``, ``polygon``, ``letters``, ``side``, ``pairs``) or of ``ConnectedCertificate`` (``maps``, ``polygon``,
    ``gap``, ``near``, ``links``, and ``squares`` where there are some) of the JavaScript API, and files of its command
    ``frond certificate`` are the same.

    Parameters
    ----------
    ifs : Ifs or array_like
        The shape, or its maps.
    epsilon, budget
        As in `connectedness`.

    Raises
    ------
    FrondError
        ``bad-input``, ``no-attractor``.
    """
    shape, asked = ifs_of("The IFS", ifs), _asked(epsilon, budget)
    for find in (_frond.certificate, _frond.connected_certificate):
        found = find(shape.maps, asked)
        if found is not None:
            return json.loads(found)  # type: ignore[no-any-return]
    return None


def check(certificate: Any) -> Check:
    """Replays a certificate of either kind in exact arithmetic, with none of the code that finds them.

    What is no certificate at all is refused like one that proves nothing: `valid` is False, and `text` says why.

    Parameters
    ----------
    certificate : dict or str
        As `certificate` gives it, or as JSON.

    Raises
    ------
    FrondError
        ``bad-input`` for what is neither, or no JSON.
    """
    if isinstance(certificate, Mapping):
        try:
            certificate = json.dumps(dict(certificate), default=_listed)
        except (ValueError, TypeError, RecursionError):
            raise unreadable("The certificate", "it holds what is neither number, text nor list") from None
    return Check(*_frond.check(_values.text("The certificate", certificate)))


def _listed(value: Any) -> Any:
    """Arrays as lists."""
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    raise TypeError
