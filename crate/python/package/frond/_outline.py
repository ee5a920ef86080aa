"""Outlines: traced in pictures, measured, and shown."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple, Optional

import numpy as np
import numpy.typing as npt

from . import _frond, _values
from ._errors import FrondError, unreadable

MOST_PIXELS = 1 << 22


class Warned(NamedTuple):
    """Something that may be amiss, though there is a result.

    Attributes
    ----------
    code : str
        A name that stays the same over versions.
    message : str
        A sentence or two that say what to try.
    """

    code: str
    message: str


@dataclass(frozen=True, eq=False)
class Outline:
    """A closed line. Where arrays are taken it is the one of its points.

    Attributes
    ----------
    points : ndarray
        Shape (n, 2), float64: x and y of each, y up, counter-clockwise; the first is not repeated at the end.
    area : float
        What it encloses, in square units of the points.
    perimeter : float
        Its length, in units of the points.
    warnings : list[Warned]
        What may be amiss.
    name : str
        As a file calls it; else empty.
    """

    points: npt.NDArray[np.float64]
    area: float
    perimeter: float
    warnings: list[Warned]
    name: str = ""

    def __array__(self, dtype: Any = None, copy: Optional[bool] = None) -> npt.NDArray[Any]:
        return np.array(self.points, dtype=dtype) if copy else np.asarray(self.points, dtype=dtype)

    def __len__(self) -> int:
        return len(self.points)

    def __repr__(self) -> str:
        named = f" {self.name!r}" if self.name else ""
        return f"<Outline{named}: {len(self)} points, area {self.area:.6g}, perimeter {self.perimeter:.6g}>"

    def _repr_svg_(self) -> str:
        """The drawing that a notebook shows."""
        return svg(self.points)


class Measures(NamedTuple):
    """What is measured of an outline.

    Attributes
    ----------
    area : float
        What it encloses, in square units.
    perimeter : float
        Its length, in units.
    dimension : float
        Its box dimension between 1/64 and 1/256 of the diagonal of its box: the slope of a line through the logarithms
        of counts. About 1 of a smooth line.
    """

    area: float
    perimeter: float
    dimension: float


def svg(points: npt.NDArray[np.float64], longest: float = 360.0, fill: str = "#3a7d44") -> str:
    """A drawing (SVG) of a closed line whose longer side is so many pixels; y points up in `points`."""
    low, high = points.min(axis=0), points.max(axis=0)
    scale = longest / max(float((high - low).max()), 1e-300)
    placed = (points - low) * scale
    width, height = ((high - low) * scale).tolist()
    corners = " ".join(f"{x:.2f},{height - y:.2f}" for x, y in placed.tolist())
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-4 -4 {width + 8:.2f} {height + 8:.2f}" '
        f'width="{width + 8:.0f}" height="{height + 8:.0f}"><polygon points="{corners}" fill="{fill}" '
        f'fill-rule="evenodd"/></svg>'
    )


def pixels_of(image: Any) -> npt.NDArray[np.uint8]:
    """A picture as bytes: red, green, blue and alpha, shape (height, width, 4)."""
    what = "The picture"
    mode = getattr(image, "mode", None)
    if isinstance(mode, str) and hasattr(image, "convert") and hasattr(image, "size"):
        size = image.size
        if size[0] * size[1] > MOST_PIXELS:
            raise _too_large(size[1], size[0])
        # Pillow's pictures of palettes, of CMYK and of single bits.
        image = image if mode in ("L", "RGB", "RGBA") else image.convert("RGBA")
    if isinstance(image, (str, bytes, bytearray)) or hasattr(image, "__fspath__"):
        raise unreadable(what, "an array of pixels is needed: open the file with Pillow or imageio first")
    if np.ma.is_masked(image):
        raise unreadable(what, "some of its pixels are masked")
    try:
        found = np.asarray(image)
    except (ValueError, TypeError, OverflowError, RecursionError):
        raise unreadable(what, "an array of pixels is needed") from None
    if not (found.ndim == 2 or (found.ndim == 3 and found.shape[2] in (1, 3, 4))):
        raise unreadable(
            what, f"the shape (height, width), or with 3 or 4 channels, is needed, and it has {found.shape}"
        )
    height, width = found.shape[:2]
    if not height or not width:
        raise unreadable(what, "it has no pixels")
    if height * width > MOST_PIXELS:
        raise _too_large(height, width)
    if found.dtype == np.bool_:
        found = np.where(found, np.uint8(0), np.uint8(255))
    if found.dtype != np.uint8:
        raise unreadable(what, f"bytes (uint8) from 0 to 255 are needed, and it holds {found.dtype.name}")
    whole = np.full((height, width, 4), 255, np.uint8)
    if found.ndim == 2:
        found = found[:, :, np.newaxis]
    whole[:, :, : 4 if found.shape[2] == 4 else 3] = found
    return whole


def _too_large(height: int, width: int) -> FrondError:
    step = 2
    while -(-height // step) * -(-width // step) > MOST_PIXELS:
        step += 1
    return FrondError(
        f"The picture has {width} x {height} pixels, and at most {MOST_PIXELS} are looked at. Make it smaller first: "
        f"image[::{step}, ::{step}] is small enough.",
        "too-large",
    )


def trace(image: Any, *, threshold: float = 0.0, stalk: bool = True, component: int = 0) -> Outline:
    """The outline of what a picture shows: a leaf on a plain ground, a silhouette.

    Parameters
    ----------
    image : array_like
        Bytes (uint8), shape (height, width), (height, width, 3) or (height, width, 4), row 0 on top, at most 4194304
        pixels; or a picture of Pillow. True in an array of bool is leaf. What a camera says about being turned (EXIF)
        is not looked at: ``PIL.ImageOps.exif_transpose`` turns the picture.
    threshold : float
        -1 to 1: less or more is taken for the leaf than is found by itself (0).
    stalk : bool
        Whether a stalk belongs to it.
    component : int
        Which piece of the mask, 0 the largest.

    Returns
    -------
    Outline
        In pixels, y up: the bottom edge of the picture is y = 0. `warnings` says what may be amiss.

    Raises
    ------
    FrondError
        ``bad-input``, and those of tracing, such as ``too-large``, or where nothing is found.

    Notes
    -----
    Otsu's threshold (1979), morphology and connected components; where the ground has shade on it, colours and a random
    walk (Grady 2006).
    """
    pixels = pixels_of(image)
    height, width = pixels.shape[:2]
    level = _values.real("threshold", threshold, -1.0, 1.0)
    kept = _values.flag("stalk", stalk)
    piece = _values.whole("component", component, 0, 63)
    points, area, length, said = _frond.trace(pixels.ravel(), (width, height), level, kept, piece)
    return Outline(points.reshape(-1, 2), area, length, [Warned(*one) for one in said])


def points_of(outline: Any) -> npt.NDArray[np.float64]:
    """The points of an outline, in an array of one's own order."""
    if isinstance(outline, Outline):
        outline = outline.points
    return np.ascontiguousarray(_values.points("The outline", outline))


def measure(what: Any, *, scale: float = 1.0) -> Measures:
    """The area, the perimeter and the box dimension of an outline, or of what a picture shows.

    Lengths, widths, lobes and teeth are not measured yet.

    Parameters
    ----------
    what : Outline or array_like
        An outline; or its points, shape (n, 2), or n complex numbers; or a picture as `trace` takes it.
    scale : float
        Units a pixel, or a unit of the points: ``25.4 / 300`` for millimetres in a scan of 300 dots per inch.

    Returns
    -------
    Measures
        ``area`` in square units, ``perimeter`` in units, ``dimension``.

    Raises
    ------
    FrondError
        ``bad-input``, ``too-few-points``, ``flat`` and their like, and those of `trace`.

    Examples
    --------
    >>> square = measure([(0, 0), (2, 0), (2, 2), (0, 2)], scale=0.5)
    >>> (square.area, square.perimeter)
    (1.0, 4.0)
    """
    size = _values.real("scale", scale, 1e-100, 1e100)
    if not isinstance(what, Outline) and _is_picture(what):
        what = trace(what)
    _, area, length, slope = _frond.measure(points_of(what))
    return Measures(area * size * size, length * size, slope)


def _is_picture(value: Any) -> bool:
    if hasattr(value, "mode") and hasattr(value, "convert"):
        return True
    if not isinstance(value, np.ndarray):
        return False
    return value.ndim == 3 or (value.ndim == 2 and value.shape[1] != 2)
