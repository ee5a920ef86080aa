"""What is wrong gets a sentence and a code, whatever it is, and nothing panics."""

from __future__ import annotations

import fractions
import itertools
from collections.abc import Callable
from typing import Any

import frond
import numpy as np
import pytest

HALF = [0.5, 0, 0, 0.5, 0, 0]
GASKET = [(0.5, 0), (0.5, 0.5), (0.5, 0.5j)]

NO_MAPS: list[tuple[Any, str]] = [
    (None, "bad-input"),
    (5, "bad-input"),
    (float("nan"), "bad-input"),
    ("fern", "bad-input"),
    (b"fern", "bad-input"),
    ({"maps": [HALF]}, "bad-input"),
    ({1, 2}, "bad-input"),
    (object(), "bad-input"),
    ([], "no-maps"),
    (np.empty((0, 6)), "no-maps"),
    (np.empty((0, 2, 3)), "no-maps"),
    ([[]], "bad-input"),
    (HALF, "bad-input"),
    (np.array(0.5), "bad-input"),
    (np.zeros((1, 7)), "bad-input"),
    (np.zeros((1, 3, 2)), "bad-input"),
    (np.zeros((1, 2, 3, 1)), "bad-input"),
    (np.zeros((6, 0)), "bad-input"),
    (np.zeros((2, 6), complex), "bad-input"),
    (np.zeros((1, 6), bool), "bad-input"),
    (np.zeros((1, 6), "datetime64[s]"), "bad-input"),
    (np.array([["0.5"] * 6]), "bad-input"),
    (np.array([[None] * 6]), "bad-input"),
    ([[0.5, 0, 0, 0.5, 0, "0"]], "bad-input"),
    ([HALF, HALF[:5]], "bad-input"),
    ([[10**400, 0, 0, 0.5, 0, 0]], "bad-input"),
    ([[float("nan"), 0, 0, 0.5, 0, 0]], "not-finite"),
    ([[0.5, 0, 0, 0.5, float("inf"), 0]], "not-finite"),
    ([[1e101, 0, 0, 0.5, 0, 0]], "not-finite"),
    ([(complex("nan"), 0)], "not-finite"),
    ([HALF] * 65, "too-many-maps"),
    (np.zeros((100_000, 6)), "too-many-maps"),
    ((HALF for _ in range(65)), "too-many-maps"),
    (itertools.repeat(HALF), "too-many-maps"),
    (np.broadcast_to(0.5, (10**9, 6)), "bad-input"),
    (np.ma.masked_invalid([[np.nan, 0, 0, 0.5, 0, 0]]), "bad-input"),
]


def refused(ask: Callable[[], Any], code: str) -> str:
    """The sentence, which has to help."""
    with pytest.raises(frond.FrondError) as caught:
        ask()
    assert caught.value.code == code
    assert isinstance(caught.value, ValueError)
    sentence = str(caught.value)
    assert len(sentence) > 20
    assert sentence.endswith(".")
    return sentence


@pytest.mark.parametrize(("maps", "code"), NO_MAPS, ids=repr)
def test_maps(maps: Any, code: str) -> None:
    refused(lambda: frond.Ifs(maps), code)


def test_maps_of_every_form_are_the_same() -> None:
    rows = np.array([[0.5, -0.25, 0.25, 0.5, 1, 2], [0.5, 0, 0, 0.5, 0, 0]])
    wanted = frond.Ifs(rows)
    matrices = np.stack([rows[:, [0, 1, 4]], rows[:, [2, 3, 5]]], axis=1)
    pairs = [(0.5 + 0.25j, 1 + 2j), (0.5, 0)]
    read_only = rows.copy()
    read_only.setflags(write=False)
    wide = np.zeros((4, 12))
    wide[::2, ::2] = rows
    exact = [[fractions.Fraction(number) for number in row] for row in rows.tolist()]
    for maps in (
        rows.tolist(),
        tuple(map(tuple, rows.tolist())),
        iter(rows.tolist()),
        np.asfortranarray(rows),
        rows.astype(np.float32),
        rows.astype(">f8"),
        rows.astype(np.longdouble),
        read_only,
        wide[::2, ::2],
        rows[::-1][::-1],
        matrices,
        matrices.tolist(),
        np.asfortranarray(matrices),
        pairs,
        np.array(pairs),
        np.array(pairs).astype(np.complex64),
        exact,
        wanted,
    ):
        assert frond.Ifs(maps) == wanted
    assert frond.Ifs([(fractions.Fraction(1, 3), 0)]).maps[0, 0] == 1 / 3
    assert frond.Ifs([[1, 0, 0, 1, 0, 0]]).maps.dtype == np.float64


def test_what_is_given_is_not_held() -> None:
    rows = np.array([HALF])
    ifs = frond.Ifs(rows)
    rows[0, 0] = 7
    assert ifs.maps[0, 0] == 0.5
    with pytest.raises(ValueError, match="read-only"):
        ifs.maps[0, 0] = 7


@pytest.mark.parametrize(
    ("given", "code"),
    [
        ([1, 2], "probabilities"),
        ([1, 2, -1], "probabilities"),
        ([0, 0, 0], "probabilities"),
        ([1, 2, float("nan")], "probabilities"),
        ([1, 2, float("inf")], "probabilities"),
        ([1e308, 1e308, 1e308], "probabilities"),
        ([], "probabilities"),
        (1, "bad-input"),
        ([[1, 2, 3]], "bad-input"),
        (["a", "b", "c"], "bad-input"),
        ([1j, 2, 3], "bad-input"),
        ({1: 2}, "bad-input"),
    ],
    ids=repr,
)
def test_probabilities(given: Any, code: str) -> None:
    refused(lambda: frond.Ifs(GASKET, given), code)
    grows = [(2, 0), (0.5, 1), (0.5, 1j)]
    refused(lambda: frond.Ifs(grows, given), code)


def test_probabilities_are_told() -> None:
    assert frond.Ifs(GASKET, [1, 1, 2]).probabilities.tolist() == [0.25, 0.25, 0.5]
    assert frond.Ifs([(2, 0), (0.5, 1)], [1, 3]).probabilities.tolist() == [0.25, 0.75]
    refused(lambda: frond.Ifs([(2, 0)]).probabilities, "no-attractor")


def test_maps_without_an_attractor() -> None:
    grows = frond.Ifs([(2, 0)])
    assert frond.connectedness(grows).verdict == "no-attractor"
    assert grows._repr_png_() is None
    for ask in (
        lambda: grows.attractor(1),
        grows.rasterize,
        grows.bounds,
        grows.dimension,
        lambda: frond.certificate(grows),
        lambda: frond.Morph(grows, "fern"),
        lambda: frond.link(grows),
    ):
        refused(ask, "no-attractor")


NO_NUMBER = [None, "1", [1], np.zeros(2), 1j, True, np.True_, float("nan"), float("inf"), 10**400]


@pytest.mark.parametrize("value", [*NO_NUMBER, -1, 0.5, 2**70], ids=repr)
def test_whole_numbers(value: Any) -> None:
    gasket = frond.Ifs(GASKET)
    for ask in (
        lambda: gasket.attractor(value),
        lambda: gasket.attractor(1, seed=value),
        lambda: gasket.rasterize(value, 10),
        lambda: gasket.rasterize(10, value),
        lambda: frond.locus("fern", "tree", width=value),
        lambda: frond.check_path("fern", "tree", points=[(0, 0)], samples=value),
        lambda: frond.plan_path("fern", "tree", axes=value),
    ):
        refused(ask, "bad-input")


@pytest.mark.parametrize("value", NO_NUMBER, ids=repr)
def test_numbers(value: Any) -> None:
    morph = frond.Morph("fern", "tree")
    for ask in (
        lambda: morph.at(value, 0),
        lambda: morph.at(0, 0, value),
        lambda: frond.locus(morph, epsilon=value, width=2, height=2),
        lambda: frond.certify_path(morph, points=[(0, 0), (1, 1)], t0=value),
        lambda: frond.link(morph, t=value),
    ):
        refused(ask, "bad-input")
    if isinstance(value, (bool, np.bool_)):
        # Among numbers, NumPy makes a number of it.
        return
    for ask in (
        lambda: frond.locus(morph, bounds=(0, 0, 1, value), width=2, height=2),
        lambda: frond.certify_path(morph, points=[(0, 0), (1, value)]),
        lambda: frond.Ifs(GASKET).rasterize(9, 9, view=(0, 0, value)),
    ):
        refused(ask, "bad-input")


def test_numbers_of_numpy() -> None:
    gasket = frond.Ifs(GASKET)
    assert len(gasket.attractor(np.int64(5), seed=np.array(3)).pieces) == 5
    assert len(gasket.attractor(5.0).pieces) == 5
    assert frond.Morph("fern", "tree").at(np.float32(0.5), np.array(0.5)) == frond.Morph("fern", "tree").at(0.5, 0.5)


@pytest.mark.parametrize("path", [None, 5, [], [1, 2], [(0,)], [(0, 0, 0, 0)], "auto", [[(0, 0)]], [("a", "b")]], ids=repr)
def test_paths(path: Any) -> None:
    refused(lambda: frond.check_path("fern", "tree", points=path), "bad-input")
    refused(lambda: frond.certify_path("fern", "tree", points=path), "bad-input")


ENDLESS: list[Any] = [
    itertools.repeat((0.5, 0.5)),
    np.broadcast_to(0.5, (10**9, 2)),
    [(0.5, 0.5)] * 65537,
]


@pytest.mark.parametrize("path", ENDLESS, ids=["repeat", "broadcast", "list"])
def test_what_does_not_end_is_refused(path: Any) -> None:
    gasket = frond.Ifs(GASKET)
    refused(lambda: frond.check_path("fern", "tree", points=path), "bad-input")
    refused(lambda: frond.Morph("fern", "tree", turns=path), "bad-input")
    refused(lambda: frond.Ifs(GASKET, path), "bad-input")
    refused(lambda: gasket.rasterize(9, 9, palette=path), "bad-input")
    refused(lambda: gasket.rasterize(9, 9, view=path), "bad-input")


def test_what_the_package_computes_with_does_not_panic_either() -> None:
    from frond import _frond

    narrow = np.zeros((1, 3))
    chosen = (False, [], [])
    for ask in (
        lambda: _frond.dimension(narrow),
        lambda: _frond.pair((narrow, None), (narrow, None)),
        lambda: _frond.interpolate((narrow, narrow, chosen), None, (0, 0, 0)),
        lambda: _frond.attractor(np.array([HALF]), None, 2**60, 0),
    ):
        refused(ask, "bad-input")


def test_stretches() -> None:
    for t0, t1 in ((1, 0), (2, 3), (-2, -1)):
        refused(lambda: frond.certify_path("fern", "tree", points=[(0, 0), (1, 1)], t0=t0, t1=t1), "bad-input")


def test_names() -> None:
    gasket = frond.Ifs(GASKET)
    refused(lambda: gasket.rasterize(colouring="loud"), "bad-input")
    refused(lambda: gasket.rasterize(palette=["red"]), "bad-input")
    refused(lambda: gasket.rasterize(palette=5), "bad-input")
    refused(lambda: gasket.rasterize(smooth=1), "bad-input")
    refused(lambda: frond.Morph("fern", "tree", mode="loud"), "bad-input")
    assert "'ferm'" in refused(lambda: frond.Morph("ferm", "tree"), "bad-input")
    refused(lambda: frond.Morph("fern", "tree", correspondence=[0, 0, 1, 2]), "correspondence")
    refused(lambda: frond.Morph("fern", "tree", correspondence=[0, 0.5]), "bad-input")
    refused(lambda: frond.Morph("fern", "tree", correspondence=5), "bad-input")
    refused(lambda: frond.Morph("fern", "tree", turns=[99, 0, 0, 0]), "turns")
    refused(lambda: frond.locus("fern"), "bad-input")
    refused(lambda: frond.locus(frond.Morph("fern", "tree"), "tree"), "bad-input")
    refused(lambda: frond.open_link("v=1&colour=loud"), "link-damaged")
    refused(lambda: frond.open_link("\ud800"), "bad-input")
    refused(lambda: frond.link("fern", path=[(0, 0)]), "bad-input")
    refused(lambda: frond.link("fern", path=[(0, 0), *[(0.5, 0.5)] * 65, (1, 1)]), "bad-input")


def test_certificates() -> None:
    for certificate in (None, 5, "", "{", "[", "\ud800", {"maps": object()}, b"{}"):
        refused(lambda: frond.check(certificate), "bad-input")
    for certificate in ({}, {"links": 5}, "[]", "5", "null", {"maps": [], "links": []}):
        found = frond.check(certificate)
        assert not found
        assert len(found.text) > 20
    nested: Any = []
    for _ in range(100_000):
        nested = [nested]
    refused(lambda: frond.check({"maps": nested}), "bad-input")
    refused(lambda: frond.check("[" * 100_000), "bad-input")
    certificate = frond.certificate([(0.3, 0), (0.3, 0.7)])
    assert certificate is not None
    assert frond.check(certificate)
    certificate["maps"][0][0] = 0.95
    assert not frond.check(certificate)


def test_a_verdict_is_no_yes_or_no() -> None:
    with pytest.raises(TypeError):
        bool(frond.connectedness("fern"))
