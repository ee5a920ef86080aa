"""Outlines that are traced, measured and fitted: exact shapes, and the answers of the package in Node."""

from __future__ import annotations

import base64
import math
from typing import Any

import frond
import numpy as np
import pytest
from asked import node, same


def drawn(inside: Any) -> np.ndarray:
    """A dark shape on a light ground, 400 x 300."""
    y, x = np.mgrid[:300, :400] + 0.5
    return np.where(inside(x, y), 30, 240).astype(np.uint8)


DISC = drawn(lambda x, y: (x - 200) ** 2 + (y - 150) ** 2 < 100**2)
BOX = drawn(lambda x, y: (x > 100) & (x < 300) & (y > 50) & (y < 150))
STAR = [(100 + r * math.cos(k * math.pi / 5), 90 + r * math.sin(k * math.pi / 5)) for k in range(10) for r in [80 - 45 * (k % 2)]]


def as_node(pixels: np.ndarray) -> dict[str, str]:
    whole = np.full((*pixels.shape, 4), 255, np.uint8)
    whole[:, :, :3] = pixels[:, :, np.newaxis]
    return {"bytes": base64.b64encode(whole.tobytes()).decode()}


def test_areas_and_lengths_of_exact_shapes() -> None:
    right = frond.measure([(0, 0), (3, 0), (0, 4)], scale=10)
    assert (right.area, right.perimeter) == (600, 120)
    clockwise = frond.measure(np.array([0, 4j, 3]))
    assert (clockwise.area, clockwise.perimeter) == (6, 12)
    turns = np.exp(2j * np.pi * np.arange(10_000) / 10_000)
    circle = frond.measure(turns)
    assert circle.area == pytest.approx(math.pi, rel=1e-6)
    assert circle.perimeter == pytest.approx(2 * math.pi, rel=1e-6)
    assert circle.dimension == pytest.approx(1, abs=0.02)
    # Koch's snowflake: log 4 / log 3.
    side = np.array([0, 1, np.exp(-1j * np.pi / 3), 0])
    for _ in range(6):
        a, step = side[:-1], np.diff(side) / 3
        side = np.append(np.stack([a, a + step, a + step + step * np.exp(1j * np.pi / 3), a + 2 * step], 1).ravel(), side[-1])
    assert frond.measure(side).dimension == pytest.approx(math.log(4) / math.log(3), abs=0.06)


def test_pictures_of_exact_shapes() -> None:
    disc, box = frond.measure(DISC, scale=0.1), frond.measure(BOX)
    assert disc.area == pytest.approx(math.pi * 100, rel=2e-3)
    assert disc.perimeter == pytest.approx(20 * math.pi, rel=0.02)
    assert box.area == pytest.approx(200 * 100, rel=2e-3)
    assert box.perimeter == pytest.approx(600, rel=0.01)
    # y points up.
    points = frond.trace(BOX).points
    np.testing.assert_allclose([points.min(axis=0), points.max(axis=0)], [[100, 150], [300, 250]], atol=0.01)


def test_pictures_of_every_form_are_the_same() -> None:
    wanted = frond.trace(DISC).points
    colours = np.stack([DISC] * 3, axis=2)
    for image in (
        colours,
        np.concatenate([colours, np.full((*DISC.shape, 1), 255, np.uint8)], axis=2),
        DISC[:, :, np.newaxis],
        np.asfortranarray(colours),
        np.repeat(np.repeat(DISC, 2, 0), 2, 1)[::2, ::2],
    ):
        same(frond.trace(image).points, wanted)
    same(frond.trace(DISC < 100).points, wanted)


def test_the_same_as_in_node() -> None:
    star = [number for point in STAR for number in point]
    traced, box, fitted, within = node(
        [
            ["traceOutline", as_node(DISC), 400, 300],
            ["traceOutline", as_node(BOX), 400, 300, {"threshold": 0.2, "stalk": False}],
            ["fitCurve", {"floats": star}, {"numbers": 12}],
            ["fitWithin", {"floats": star}, 64],
        ]
    )
    found = frond.trace(DISC)
    same(found.points.ravel(), traced["points"])
    assert (found.area, found.perimeter) == (traced["area"], traced["length"])
    assert [list(one) for one in found.warnings] == [[one["code"], one["message"]] for one in traced["warnings"]]
    same(frond.trace(BOX, threshold=0.2, stalk=False).points.ravel(), box["points"])

    def figures(told: dict[str, float]) -> list[float]:
        return [told[key] for key in ("rms", "hausdorff", "lengthRatio", "outlineSlope", "fitSlope")]

    curve = frond.fit_curve(STAR, 12)
    assert curve.knots is not None
    assert curve.edges is not None
    same(curve.knots, np.array(fitted["curve"]["knots"], float))
    assert [None if edge is None else list(edge) for edge in curve.edges] == [
        None if edge is None else [edge[key] for key in ("from", "span", "reversed", "c")]
        for edge in fitted["curve"]["edges"]
    ]
    same(curve.points.ravel(), fitted["points"])
    assert (list(curve.figures), curve.size) == (figures(fitted["figures"]), fitted["bytes"])
    curve = frond.fit_curve(STAR, bytes=64)
    assert curve.data == within["bytes"].tobytes()
    assert (curve.word, curve.corners, curve.bends) == (within["word"], within["corners"], within["bends"])
    same(curve.points.ravel(), within["points"])
    assert list(curve.figures) == figures(within["figures"])
    assert curve.size <= 64


def test_a_fit_of_corners_is_exact() -> None:
    """Twenty numbers hold ten corners."""
    curve = frond.fit_curve(STAR, 20)
    assert curve.figures.rms < 0.01
    assert frond.measure(curve).area == pytest.approx(5 * 80 * 35 * math.sin(math.pi / 5) * 2 / 2, rel=1e-3)


def test_a_notebook_shows_outlines_and_curves() -> None:
    for shown in (frond.trace(DISC), frond.fit_curve(STAR, 12)):
        drawing = shown._repr_svg_()
        assert drawing.startswith('<svg xmlns="http://www.w3.org/2000/svg"')
        assert drawing.count(",") == len(np.asarray(shown))
        assert len(repr(shown)) < 100


@pytest.mark.parametrize(
    ("image", "code"),
    [
        (None, "bad-input"),
        ("leaf.png", "bad-input"),
        (np.zeros((10, 10)), "bad-input"),
        (np.zeros((10, 10), np.uint16), "bad-input"),
        (np.zeros((10, 10, 5), np.uint8), "bad-input"),
        (np.zeros((0, 10), np.uint8), "bad-input"),
        (np.array(5, np.uint8), "bad-input"),
        (np.zeros((10, 10), np.uint8), "no-piece"),
        (np.broadcast_to(np.uint8(0), (10**5, 10**5, 3)), "too-large"),
    ],
    ids=lambda value: str(getattr(value, "shape", value)),
)
def test_pictures_that_are_none(image: Any, code: str) -> None:
    with pytest.raises(frond.FrondError) as caught:
        frond.trace(image)
    assert caught.value.code == code
    assert str(caught.value).endswith(".")


@pytest.mark.parametrize(
    ("outline", "code"),
    [
        (None, "bad-input"),
        ([], "bad-input"),
        ([1, 2, 3], "bad-input"),
        ([(0, 0), (1, 1)], "too-few-points"),
        ([(0, 0), (1, 1), (2, 2)], "flat"),
        ([(0, 0), (1, float("nan")), (2, 0)], "bad-input"),
        ([(0, 0), (1e200, 1), (2, 0)], "not-finite"),
        (np.random.default_rng(1).random((1_100_000, 2)), "too-many-points"),
    ],
    ids=lambda value: str(value)[:20],
)
def test_outlines_that_are_none(outline: Any, code: str) -> None:
    for ask in (
        lambda: frond.measure(outline),
        lambda: frond.fit_curve(outline, 12),
        lambda: frond.fit_curve(outline, bytes=64),
    ):
        with pytest.raises(frond.FrondError) as caught:
            ask()
        assert caught.value.code == code
        assert str(caught.value).endswith(".")


def test_sizes_that_are_none() -> None:
    for ask in (
        lambda: frond.fit_curve(STAR, 11),
        lambda: frond.fit_curve(STAR, 2001),
        lambda: frond.fit_curve(STAR, bytes=31),
        lambda: frond.fit_curve(STAR, 12, bytes=64),
        lambda: frond.measure(STAR, scale=0),
        lambda: frond.measure(STAR, scale=float("nan")),
        lambda: frond.trace(DISC, threshold=2),
        lambda: frond.trace(DISC, component=-1),
    ):
        with pytest.raises(frond.FrondError) as caught:
            ask()
        assert caught.value.code == "bad-input"


def test_a_tangle_is_measured() -> None:
    """A hundred thousand points that cross each other everywhere."""
    found = frond.measure(np.random.default_rng(1).random((100_000, 2)))
    assert 1.8 < found.dimension < 2.1
