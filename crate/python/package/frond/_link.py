"""Links: a morph in the address of the studio."""

from __future__ import annotations

import json
from typing import Any, NamedTuple

from . import _frond, _values
from ._errors import unreadable
from ._ifs import Ifs, Preset
from ._morph import Morph, morph_of
from ._way import Path

MOST_BETWEEN = 64


class Linked(NamedTuple):
    """What a link says of a morph.

    Attributes
    ----------
    morph : Morph
        The morph.
    path : Any
        ``"auto"``, ``"straight"``, or the points (u, v) or (u, v, w) between the ends.
    t : float
        The moment, 0 to 1 by length of the path.
    """

    morph: Morph
    path: Any
    t: float


def _shape(ifs: Ifs, name: str) -> dict[str, Any]:
    told: dict[str, Any] = {"name": name, "maps": ifs.maps.tolist()}
    if isinstance(ifs, Preset):
        told["name"] = ifs.name
        if ifs._given is None:
            told["preset"] = ifs.id
    if ifs._given is not None:
        told["weights"] = ifs._given
    return told


def link(
    a: Any,
    b: Any = None,
    *,
    path: Any = "auto",
    t: float = 0.0,
    colouring: str = "map",
    palette: Any = None,
    address: str = "",
) -> str:
    """The link of a morph, which the studio, ``embed.html`` and ``<frond-view>`` open.

    Parameters
    ----------
    a, b
        As in `locus`. One shape alone is linked as a morph into itself.
    path : {"auto", "straight"}, Path or array_like
        Frond's own path, the straight one, or points (u, v) or (u, v, w) from (0, 0) to (1, 1); at most 64 between
        them.
    t : float
        The moment, 0 to 1 by length of the path.
    colouring : {"map", "address", "density"}
        What colours mean.
    palette : sequence of str, optional
        Colours "#rrggbb".
    address : str
        The page of the studio, such as ``"https://example.org/frond/"``. Without it the fragment alone is given, which
        follows the ``#``.

    Raises
    ------
    FrondError
        ``bad-input``, those of `Morph`, and what makes a link that would not open again.
    """
    if b is None and not isinstance(a, Morph):
        b = a
    morph = morph_of(a, b)
    linear, order, turns = morph._chosen
    scene = {
        "a": _shape(morph._ends[0], "First"),
        "b": _shape(morph._ends[1], "Last"),
        "mode": "linear" if linear else "polar",
        "correspondence": order,
        "turns": turns,
        "path": _told_path(path),
        "t": _values.real("t", t, 0.0, 1.0),
        "colouring": _values.choice("The colouring", colouring, ("map", "address", "density")),
        "palette": ["#%02x%02x%02x" % colour for colour in _values.colours(palette)],
    }
    page = _values.text("The address", address)
    fragment = _frond.encode(json.dumps(scene))
    return f"{page.split('#')[0]}#{fragment}" if page else fragment


def _told_path(path: Any) -> dict[str, Any]:
    if isinstance(path, str):
        return {"kind": _values.choice("The path", path, ("auto", "straight")), "points": []}
    points = _values.path(path.points if isinstance(path, Path) else path)
    if len(points) < 2 or points[0] != (0.0, 0.0, 0.0) or points[-1] != (1.0, 1.0, 0.0):
        raise unreadable("The path", "it must lead from (0, 0) to (1, 1)")
    if len(points) > MOST_BETWEEN + 2:
        raise unreadable("The path", f"a link holds at most {MOST_BETWEEN} points between its ends")
    return {"kind": "drawn", "points": [list(point if point[2] else point[:2]) for point in points[1:-1]]}


def open_link(link: str) -> Linked:
    """The morph of a link, or of its fragment.

    Raises
    ------
    FrondError
        With the code of what is wrong with it, such as ``link-cut``.
    """
    found = json.loads(_frond.decode(_values.text("The link", link).split("#", 1)[-1]))
    ends = [
        Preset(shape["preset"], shape["name"], shape["name"], shape["maps"])
        if "preset" in shape
        else Ifs(shape["maps"], shape.get("weights"))
        for shape in (found["a"], found["b"])
    ]
    morph = Morph(
        *ends,
        mode=found["mode"],
        correspondence=found["correspondence"] or None,
        turns=found["turns"] or None,
    )
    kind, points = found["path"]["kind"], found["path"]["points"]
    return Linked(morph, kind if kind == "straight" or not points else [tuple(point) for point in points], found["t"])
