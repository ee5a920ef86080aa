"""The answers of the package in Node, bit for bit, over the gallery and the exact answers of tests/known."""

from __future__ import annotations

import json
from typing import Any

import frond
import numpy as np
import pytest
from asked import known, node, same

PAIRS = [("dragon-3", "gasket"), ("gasket", "terdragon"), ("dragon", "koch"), ("fern", "tree")]


def gallery() -> dict[str, frond.Preset]:
    return frond.presets()


def plain(ifs: frond.Ifs) -> dict[str, Any]:
    """As JavaScript has it."""
    return {"maps": ifs.maps.tolist()}


def systems() -> list[frond.Ifs]:
    """The known cases, the polygons on both sides of where they fall apart, and the gallery."""
    found = known("connectedness")
    cases = [frond.Ifs(case["maps"]) for case in found["cases"]]
    for case in found["thresholds"]:
        corners = np.exp(2j * np.pi * np.arange(case["n"]) / case["n"])
        for scale in (case["critical_scale"] * (1 + sign * 1e-6) for sign in (-1, 1)):
            cases.append(frond.Ifs(np.stack([np.full(case["n"], scale), (1 - scale) * corners], axis=1)))
    return [*cases, *gallery().values()]


def test_the_gallery() -> None:
    (wanted,) = node([["presets"]])
    assert [(shape.id, shape.name, shape.about) for shape in gallery().values()] == [
        (shape["id"], shape["name"], shape["about"]) for shape in wanted
    ]
    for shape, told in zip(gallery().values(), wanted, strict=True):
        same(shape.maps, np.array(told["maps"]))


def test_points_and_where_they_lie() -> None:
    shapes = list(gallery().values())
    answers = node(
        [["attractor", plain(shape), {"points": 3001, "seed": 7}] for shape in shapes]
        + [["bounds", plain(shape)] for shape in shapes]
    )
    for shape, cloud, box in zip(shapes, answers[: len(shapes)], answers[len(shapes) :], strict=True):
        points, found = shape.attractor(3001, seed=7), shape.bounds()
        same(points.positions.ravel(), cloud["positions"])
        same(points.pieces, cloud["pieces"])
        same(found.min, np.array(box["min"]))
        same(found.max, np.array(box["max"]))
        same(found.hull, np.array(box["hull"]))
        if "dimension" in box:
            assert shape.dimension() == box["dimension"]


@pytest.mark.parametrize("colouring", ["map", "address", "density"])
def test_pictures(colouring: str) -> None:
    shapes = list(gallery().values())
    view = {"x": 0.3, "y": 0.4, "scale": 100}
    answers = node(
        [
            ["rasterize", plain(shape), {"width": 60, "height": 45, "colouring": colouring, **more}]
            for shape in shapes
            for more in ({}, {"view": view, "palette": ["#ff0000", "#00ff00"], "smooth": False})
        ]
    )
    for shape, whole, near in zip(shapes, answers[::2], answers[1::2], strict=True):
        same(shape.rasterize(60, 45, colouring=colouring).ravel(), whole)
        other = shape.rasterize(
            60, 45, colouring=colouring, view=(0.3, 0.4, 100), palette=["#ff0000", "#00ff00"], smooth=False
        )
        same(other.ravel(), near)


def test_probabilities() -> None:
    shape = gallery()["gasket"]
    given = {**plain(shape), "probabilities": [1, 2, 5]}
    weighted = frond.Ifs(shape, [1, 2, 5])
    cloud, picture = node(
        [
            ["attractor", given, {"points": 999, "seed": 3}],
            ["rasterize", given, {"width": 40, "height": 40, "colouring": "density"}],
        ]
    )
    same(weighted.attractor(999, 3).pieces, cloud["pieces"])
    same(weighted.rasterize(40, 40, colouring="density").ravel(), picture)


def test_verdicts() -> None:
    all_of_them = systems()
    answers = node([["connectedness", plain(ifs), {"epsilon": 1e-4}] for ifs in all_of_them])
    seen = set()
    for ifs, wanted in zip(all_of_them, answers, strict=True):
        found = frond.connectedness(ifs, 1e-4)
        assert found.verdict == wanted["verdict"]
        assert found.gap == (wanted["gap"]["lower"], wanted["gap"]["upper"])
        assert [list(pair) for pair in found.overlaps] == wanted["overlaps"]
        assert (found.components, found.count, found.nodes) == (
            wanted["components"],
            wanted["count"],
            wanted["nodes"],
        )
        assert found.diameter == wanted["diameter"]
        assert found.reason == wanted.get("reason")
        assert (found.closest is None) == ("closest" not in wanted)
        if found.closest is not None:
            same(found.closest, np.array([wanted["closest"]["from"], wanted["closest"]["to"]]))
        seen.add(found.verdict)
    assert seen >= {"connected", "disconnected"}


def test_known_truths() -> None:
    for case in known("connectedness")["cases"]:
        found = frond.connectedness(case["maps"], 1e-6)
        assert found.holds == (case["truth"] == "connected"), case["name"]


def test_certificates() -> None:
    all_of_them = systems()
    answers = node(
        [[name, plain(ifs)] for ifs in all_of_them for name in ("certificate", "connectedCertificate")]
    )
    checks = node([["checkCertificate", found] for found in answers if found])
    kinds = set()
    for ifs, apart, together in zip(all_of_them, answers[::2], answers[1::2], strict=True):
        found = frond.certificate(ifs)
        assert found == (apart or together)
        if found:
            checked = frond.check(found)
            told = {
                "valid": checked.valid,
                "text": checked.text,
                "pairs": checked.pairs,
                "links": checked.links,
                "longest": checked.longest,
            }
            assert checked.valid
            assert told in checks
            assert frond.check(json.dumps(found)) == checked
            kinds.add("links" in found)
    assert kinds == {False, True}


def test_morphs() -> None:
    shapes = gallery()
    random = np.random.default_rng(5)
    places = [tuple(row) for row in random.uniform(-1, 2, (40, 3)).tolist()]
    pairs = node([["pair", plain(shapes[a]), plain(shapes[b])] for a, b in PAIRS])
    for (a, b), paired in zip(PAIRS, pairs, strict=True):
        morph = frond.Morph(shapes[a], shapes[b])
        same(morph.a.maps, np.array(paired["from"]))
        same(morph.b.maps, np.array(paired["to"]))
        assert morph.steps == paired["steps"]
        ends = [{"maps": paired["from"]}, {"maps": paired["to"]}]
        for mode in ("polar", "linear"):
            asked = frond.Morph(shapes[a], shapes[b], mode=mode)
            answers = node(
                [["interpolate", *ends, {"u": u, "v": v, "w": w, "mode": mode}] for u, v, w in places]
            )
            for place, wanted in zip(places, answers, strict=True):
                same(asked.at(*place).maps, np.array(wanted["maps"]))


def test_known_morphs() -> None:
    cases = known("morph")["cases"]
    morphs = [frond.Morph([shrunk(case["from"])], [shrunk(case["to"])]) for case in cases]
    answers = node(
        [
            ["interpolate", plain(morph.a), plain(morph.b), {"u": case["u"], "v": case["v"]}]
            for morph, case in zip(morphs, cases, strict=True)
        ]
    )
    for morph, case, wanted in zip(morphs, cases, answers, strict=True):
        found = morph.at(case["u"], case["v"]).maps[0]
        same(found, np.array(wanted["maps"][0]))
        np.testing.assert_allclose(found * 16, case["polar"], rtol=0, atol=1e-12)


def shrunk(row: list[float]) -> list[float]:
    """A sixteenth, so that there is an attractor: the polar factors stay, and stretches and shifts are linear."""
    return [number / 16 for number in row]


def test_loci() -> None:
    shapes = gallery()
    options = {"width": 13, "height": 10, "epsilon": 0.002, "bounds": {"u0": -1, "v0": -0.7, "u1": 2, "v1": 1.6}}
    pairs = node([["pair", plain(shapes[a]), plain(shapes[b])] for a, b in PAIRS])
    answers = node(
        [["locus", {"maps": pair["from"]}, {"maps": pair["to"]}, {**options, "w": 0.25}] for pair in pairs]
    )
    for (a, b), wanted in zip(PAIRS, answers, strict=True):
        found = frond.locus(
            shapes[a], shapes[b], width=13, height=10, epsilon=0.002, bounds=(-1, -0.7, 2, 1.6), w=0.25
        )
        same(found.state.ravel(), wanted["state"])
        same(found.gap.ravel(), wanted["gap"])
        assert found.u.shape == (13,)
        assert found.v.shape == (10,)
        assert (found.v[0], found.v[-1]) == (-0.7, 1.6)


def test_paths() -> None:
    shapes = gallery()
    ends = [plain(shapes[name]) for name in PAIRS[0]]
    (plan,) = node([["planPath", *ends, {"size": 61}]])
    checked, proved = node(
        [
            ["checkPath", *ends, plan["points"], {"samples": 101}],
            ["certifyPath", *ends, plan["points"], {"budget": 200}],
        ]
    )
    morph = frond.Morph(*(shapes[name] for name in PAIRS[0]))
    found = frond.plan_path(morph, size=61)
    same(found.points, np.array(plan["points"]))
    assert (found.gap, found.holds, found.clearance, found.apart, found.step) == tuple(
        plan[key] for key in ("gap", "holds", "clearance", "apart", "step")
    )
    check = frond.check_path(morph, points=found, samples=101)
    assert (check.gap, check.holds) == (checked["gap"], checked["holds"])
    assert [list(one) for one in check.breaks] == checked["breaks"]
    proof = frond.certify_path(morph, points=found, budget=200)
    assert proof._asdict() == proved


def test_links() -> None:
    shapes = gallery()
    text = frond.link(shapes["fern"], shapes["tree"], t=0.25, path=[(0, 0), (0.3, 0.6), (1, 1)])
    (opened,) = node([["decodeScene", text]])
    assert "problem" not in opened
    scene = opened["scene"]
    assert (scene["a"]["preset"], scene["b"]["preset"], scene["t"]) == ("fern", "tree", 0.25)
    assert node([["encodeScene", scene]]) == [text]
    morph, path, t = frond.open_link(f"https://example.org/#{text}")
    assert (path, t) == ([(0.3, 0.6)], 0.25)
    same(morph.at(0.4, 0.7).maps, frond.Morph("fern", "tree").at(0.4, 0.7).maps)


def test_codes() -> None:
    """What is wrong has the same name here and there."""
    grows = {"maps": [[2, 0, 0, 2, 0, 0]]}
    half = {"maps": [[0.5, 0, 0, 0.5, 0, 0]]}
    calls = [
        (["attractor", grows, {"points": 1}], lambda: frond.Ifs(grows["maps"]).attractor(1)),
        (["bounds", {"maps": []}], lambda: frond.Ifs([])),
        (["bounds", {"maps": half["maps"] * 65}], lambda: frond.Ifs(half["maps"] * 65)),
        (["bounds", {"maps": [[1e200, 0, 0, 0.5, 0, 0]]}], lambda: frond.Ifs([[1e200, 0, 0, 0.5, 0, 0]])),
        (["bounds", {**half, "probabilities": [-1]}], lambda: frond.Ifs(half["maps"], [-1])),
        (["bounds", {"maps": [[1, 2]]}], lambda: frond.Ifs([[1, 2, 3]])),
        (["attractor", half, {"points": -1}], lambda: frond.Ifs(half["maps"]).attractor(-1)),
        (
            ["interpolate", half, half, {"u": 0, "v": 0, "correspondence": [1]}],
            lambda: frond.Morph(half["maps"], half["maps"], correspondence=[1]),
        ),
        (
            ["interpolate", half, half, {"u": 0, "v": 0, "turns": [17]}],
            lambda: frond.Morph(half["maps"], half["maps"], turns=[17]),
        ),
        (
            ["rasterize", half, {"width": 4, "height": 4, "view": {"x": 0, "y": 0, "scale": 0}}],
            lambda: frond.Ifs(half["maps"]).rasterize(4, 4, view=(0, 0, 0)),
        ),
    ]
    answers = node([call for call, _ in calls])
    for (call, ask), wanted in zip(calls, answers, strict=True):
        with pytest.raises(frond.FrondError) as caught:
            ask()
        assert caught.value.code == wanted["code"], call
        if wanted["code"] != "bad-input":
            assert str(caught.value) == wanted["message"]
