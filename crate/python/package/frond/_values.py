"""How values are read: whatever is of the wrong form is refused here, with a sentence."""

from __future__ import annotations

import math
import numbers
from collections.abc import Iterable, Sequence
from itertools import islice
from typing import Any, Optional, Union

import numpy as np
import numpy.typing as npt

from ._errors import FrondError, unreadable

Floats = npt.NDArray[np.float64]
"""An array of doubles."""

MOST_MAPS = 64
#: No list is longer that is read as numbers: an attractor of 16777216 points is.
MOST_NUMBERS = 1 << 26
#: Nor a list that has to be walked through one by one.
MOST_ITEMS = 1 << 20
MOST_ON_A_PATH = 1 << 16
MOST_COLOURS = 1024


def _plain(value: Any) -> Any:
    """A number out of an array without dimensions."""
    return value.item() if isinstance(value, np.ndarray) and value.ndim == 0 else value


def real(what: str, value: Any, low: float = -math.inf, high: float = math.inf) -> float:
    """A finite number from low to high."""
    value = _plain(value)
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_)):
        try:
            number = float(value)
        except OverflowError:
            number = math.inf
        if math.isfinite(number) and low <= number <= high:
            return number
    if math.isinf(low) and math.isinf(high):
        raise unreadable(what, "a finite number is needed")
    if math.isinf(high):
        raise unreadable(what, f"a finite number from {low:g} on is needed")
    raise unreadable(what, f"a number from {low:g} to {high:g} is needed")


def whole(what: str, value: Any, low: int, high: int) -> int:
    """A whole number from low to high."""
    value = _plain(value)
    if isinstance(value, numbers.Real) and not isinstance(value, (bool, np.bool_)) and value == value:
        try:
            number = int(value)
        except OverflowError:
            number = high + 1
        if number == value and low <= number <= high:
            return number
    raise unreadable(what, f"a whole number from {low} to {high} is needed")


def flag(what: str, value: Any) -> bool:
    """True or False."""
    value = _plain(value)
    if isinstance(value, (bool, np.bool_)):
        return bool(value)
    raise unreadable(what, "True or False is needed")


def choice(what: str, value: Any, names: Sequence[str]) -> str:
    """One of some names."""
    if isinstance(value, str) and value in names:
        return value
    words = [f'"{name}"' for name in names]
    raise unreadable(what, f"{', '.join(words[:-1])} and {words[-1]} are there")


def text(what: str, value: Any) -> str:
    """A text that other programs can hold."""
    if not isinstance(value, str):
        raise unreadable(what, "a text is needed")
    try:
        value.encode("utf-8")
    except UnicodeEncodeError:
        raise unreadable(what, "it holds half of a character") from None
    return value


def few(what: str, value: Iterable[Any], most: int) -> list[Any]:
    """What an iterable gives, which may never end."""
    listed = list(islice(value, most + 1))
    if len(listed) > most:
        raise unreadable(what, f"it is longer than {most}, and no more is read")
    return listed


def array(what: str, value: Any) -> Union[Floats, npt.NDArray[np.complex128]]:
    """Finite doubles, or complex numbers where some are, of any shape. Nothing is copied that need not be."""
    if isinstance(value, (str, bytes, bytearray, memoryview, dict, set, frozenset)) or value is None:
        raise unreadable(what, "an array of numbers is needed")
    if isinstance(value, Iterable) and not isinstance(value, Sequence) and not hasattr(value, "__array__"):
        if not hasattr(value, "__array_interface__"):
            value = few(what, value, MOST_ITEMS)
    if np.ma.is_masked(value):
        raise unreadable(what, "some of its numbers are masked")
    try:
        found = np.asarray(value)
    except (ValueError, TypeError, OverflowError, RecursionError):
        raise unreadable(what, "its rows must be numbers, and of one length") from None
    if found.dtype == object:
        found = _numbers(what, found)
    if found.dtype.kind not in "fiuc":
        raise unreadable(what, f"numbers are needed, and it holds {found.dtype.name}")
    if found.size > MOST_NUMBERS:
        raise unreadable(what, f"it has {found.size} numbers, and at most {MOST_NUMBERS} are read")
    with np.errstate(over="ignore", invalid="ignore"):
        return found.astype(np.complex128 if found.dtype.kind == "c" else np.float64, copy=False)


def _numbers(what: str, found: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Fractions and their like, as the nearest doubles."""
    items = found.ravel().tolist()
    if not all(isinstance(item, numbers.Complex) and not isinstance(item, bool) for item in items):
        raise unreadable(what, "its rows must be numbers, and of one length")
    real_ones = all(isinstance(item, numbers.Real) for item in items)
    try:
        plain = [float(item) if real_ones else complex(item) for item in items]
    except OverflowError:
        raise unreadable(what, "a number is too large") from None
    return np.array(plain).reshape(found.shape)


def reals(what: str, value: Any) -> Floats:
    """Doubles of any shape, NaN and infinity among them."""
    found = array(what, value)
    if found.dtype.kind == "c":
        raise unreadable(what, "its numbers must be real")
    return found  # type: ignore[return-value]


def finite(what: str, value: Any) -> Floats:
    """Finite doubles of any shape."""
    found = reals(what, value)
    if not np.isfinite(found).all():
        raise unreadable(what, "it holds a number that is NaN or infinite")
    return found


_FORMS = "rows of six numbers, 2 x 3 matrices or pairs (s, t) of complex numbers are needed, one for each map"


def rows(maps: Any) -> Floats:
    """Maps as rows (a, b, c, d, e, f), in an array that nobody can write to."""
    if not hasattr(maps, "__array__") and isinstance(maps, Iterable) and not isinstance(maps, (str, bytes, dict)):
        count = len(maps) if isinstance(maps, Sequence) else None
        maps = list(islice(maps, MOST_MAPS + 1))
        if len(maps) > MOST_MAPS:
            raise too_many(count)
    found = array("The maps", maps)
    if found.ndim >= 1 and found.size == 0 and found.shape[0] == 0:
        return _kept(np.empty((0, 6)))
    if found.ndim >= 2 and len(found) > MOST_MAPS:
        raise too_many(len(found))
    if found.ndim == 2 and found.shape[1] == 2:
        return _kept(_similitudes(found))
    if found.dtype.kind == "c":
        raise unreadable("The maps", _FORMS)
    if found.ndim == 3 and found.shape[1:] == (2, 3):
        linear, shift = found[:, :, :2].reshape(-1, 4), found[:, :, 2]
        return _kept(np.concatenate([linear, shift], axis=1))
    if found.ndim == 2 and found.shape[1] == 6:
        return _kept(found)
    raise unreadable("The maps", f"{_FORMS}, and it has the shape {found.shape}")


def too_many(count: Optional[int]) -> FrondError:
    """The error of a list of maps that is too long, before anything else is looked at."""
    told = f"more than {MOST_MAPS}" if count is None else count
    return FrondError(f"There are {told} maps, and the most is {MOST_MAPS}. Remove some.", "too-many-maps")


def _similitudes(pairs: npt.NDArray[Any]) -> Floats:
    """z -> s z + t, as rows."""
    s, t = pairs[:, 0], pairs[:, 1]
    return np.stack([s.real, -s.imag, s.imag, s.real, t.real, t.imag], axis=1)


def _kept(found: npt.NDArray[Any]) -> Floats:
    """A copy of one's own, in the order of C: what its owner does to the original changes nothing."""
    kept = np.array(found, dtype=np.float64, order="C")
    kept.setflags(write=False)
    return kept


def probabilities(value: Any) -> Optional[list[float]]:
    """A list of numbers; how many there must be, and which, is said by who takes them."""
    if value is None:
        return None
    found = reals("The probabilities", value)
    if found.ndim != 1:
        raise unreadable("The probabilities", f"a list of numbers is needed, and it has the shape {found.shape}")
    return found.tolist()  # type: ignore[no-any-return]


def integers(what: str, value: Any, low: int, high: int) -> list[int]:
    """A list of whole numbers; none where nothing is given."""
    if value is None:
        return []
    found = reals(what, value)
    if found.ndim != 1 or found.size > MOST_MAPS:
        raise unreadable(what, "a list of whole numbers is needed, one for each map")
    return [whole(what, number, low, high) for number in found.tolist()]


def points(what: str, value: Any) -> Floats:
    """Finite points (x, y): an array of shape (n, 2), or of n complex numbers."""
    found = array(what, value)
    if found.dtype.kind == "c":
        if found.ndim != 1:
            raise unreadable(what, "a list of points is needed, complex numbers or rows (x, y)")
        found = np.stack([found.real, found.imag], axis=1)
    if found.ndim != 2 or found.shape[1] != 2:
        raise unreadable(what, f"points are rows (x, y), and it has the shape {found.shape}")
    return finite(what, found)


def path(value: Any) -> list[tuple[float, float, float]]:
    """Points (u, v) or (u, v, w) of a path."""
    what = "The path"
    if isinstance(value, np.ndarray) and value.ndim > 0 and len(value) > MOST_ON_A_PATH:
        raise unreadable(what, f"it has {len(value)} points, and at most {MOST_ON_A_PATH} are read")
    try:
        listed = [finite(what, point).tolist() for point in few(what, value, MOST_ON_A_PATH)]
    except TypeError:
        raise unreadable(what, "a list of points (u, v) or (u, v, w) is needed") from None
    if not listed:
        raise unreadable(what, "it must have a point or more")
    if not all(isinstance(point, list) and len(point) in (2, 3) for point in listed):
        raise unreadable(what, "each point must be two or three finite numbers")
    if not all(isinstance(number, float) for point in listed for number in point):
        raise unreadable(what, "each point must be two or three finite numbers")
    return [(point[0], point[1], point[2] if len(point) == 3 else 0.0) for point in listed]


def colours(value: Any) -> list[tuple[int, int, int]]:
    """Colours "#rrggbb"; none where nothing is given."""
    if value is None:
        return []
    listed = [value] if isinstance(value, str) else value
    try:
        listed = few("The palette", listed, MOST_COLOURS)
    except TypeError:
        raise unreadable("The palette", "colours are written #rrggbb") from None
    found = []
    for colour in listed:
        digits = colour[1:] if isinstance(colour, str) and colour.startswith("#") else ""
        if len(digits) != 6 or any(digit not in "0123456789abcdefABCDEF" for digit in digits):
            raise unreadable("The palette", "colours are written #rrggbb")
        number = int(digits, 16)
        found.append((number >> 16, number >> 8 & 255, number & 255))
    return found
