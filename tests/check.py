#!/usr/bin/env python3
"""A second checker of Frond's proofs, in fractions alone. It shares no code with crate/check.

    python3 tests/check.py certificate.json ..        replays certificates; exit status 0 if it accepts all of them
    python3 tests/check.py --compare proofs.jsonl     lines {"accepted": true, "proof": {..}}: does it agree with each?

docs/proofs.md has the theorems. Every double is a fraction, so nothing is rounded. Unlike frond-check this program does
not bound its work: give it certificates of some thousand pairs at most.
"""

import json
import sys
from fractions import Fraction
from itertools import product

MOST = {"maps": 256, "corners": 512, "pairs": 10**6, "cells": 10**5, "word": 1000, "letters": 10**7, "blocks": 4096}
FARTHEST_CELL = 10**6


class Refused(Exception):
    """Why a certificate is no proof."""


def need(holds, why):
    if not holds:
        raise Refused(why)


# Reading: what is written, and nothing that is nearly that.

def unique(pairs):
    need(len({name for name, _ in pairs}) == len(pairs), "a name is there twice")
    return dict(pairs)


def not_finite(name):
    raise Refused(f"{name} is no number")


def read(text):
    return json.loads(text, object_pairs_hook=unique, parse_constant=not_finite)


def field(of, name):
    need(isinstance(of, dict) and name in of, f"{name} is missing")
    return of[name]


def items(value, count=None):
    need(isinstance(value, list) and count in (None, len(value)), "a list has another form")
    return value


def number(value):
    need(type(value) in (int, float), "something is no number")
    value = float(value)
    need(abs(value) != float("inf"), "a number is too large")
    return Fraction(value)


def whole(value, least, most):
    need(type(value) is int and least <= value <= most, "something is no whole number in its range")
    return value


def numbers(value, count):
    return tuple(number(x) for x in items(value, count))


def word(value):
    return tuple(whole(x, 0, 255) for x in items(value))


# The plane: points are pairs of fractions, maps rows (a, b, c, d, e, f).

def minus(p, q):
    return (p[0] - q[0], p[1] - q[1])


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def image(m, p):
    return (m[0] * p[0] + m[1] * p[1] + m[4], m[2] * p[0] + m[3] * p[1] + m[5])


def after(m, n):
    """The map that applies n first."""
    (a, b), (c, d) = ((m[0] * x + m[1] * y, m[2] * x + m[3] * y) for x, y in ((n[0], n[2]), (n[1], n[3])))
    return (a, c, b, d, *image(m, n[4:]))


def determinant(m):
    return m[0] * m[3] - m[1] * m[2]


class Shape:
    """Maps and a polygon around their attractor."""

    def __init__(self, maps, polygon):
        self.maps, self.polygon = maps, polygon
        self.known = {(): tuple(map(Fraction, (1, 0, 0, 1, 0, 0)))}
        self.edges = [(p, polygon[(k + 1) % len(polygon)]) for k, p in enumerate(polygon)]
        # Outer normals.
        self.normals = [(q[1] - p[1], p[0] - q[0]) for p, q in self.edges]

    def map(self, w):
        if w not in self.known:
            self.known[w] = after(self.map(w[:-1]), self.maps[w[-1]])
        return self.known[w]

    def farthest(self, w, n):
        """The greatest n . x over the image of the polygon under a word."""
        m = self.map(w)
        back = (m[0] * n[0] + m[2] * n[1], m[1] * n[0] + m[3] * n[1])
        return max(dot(back, p) for p in self.polygon) + dot(n, m[4:])

    def nearest(self, w, n):
        return -self.farthest(w, (-n[0], -n[1]))

    def check_convex(self):
        for p, q in self.edges:
            for x in self.polygon:
                # By identity: a corner that is there twice is no end of the other's edge.
                if x is not p and x is not q:
                    need(cross(minus(q, p), minus(x, p)) > 0, "the polygon is not strictly convex")

    def check_inside(self, w):
        for n, (p, _) in zip(self.normals, self.edges):
            need(self.farthest(w, n) < dot(n, p), f"the word {w} does not map the polygon into its inside")

    def point(self, head, repeat):
        """w_head of the point that w_repeat fixes, by Cramer's rule."""
        a, b, c, d, e, f = self.map(repeat)
        under = (1 - a) * (1 - d) - b * c
        fixed = (((1 - d) * e + b * f) / under, ((1 - a) * f + c * e) / under)
        return image(self.map(head), fixed)

    def address(self, value):
        head, repeat = word(field(value, "head")), word(field(value, "repeat"))
        self.check_letters(head, least=0)
        self.check_letters(repeat)
        return head, repeat

    def check_letters(self, w, least=1):
        need(least <= len(w) and all(k < len(self.maps) for k in w), "a word is empty, or has a letter that is no map")
        need(len(w) <= MOST["word"], "a word is too long")


def shape_of(proof):
    maps = [numbers(row, 6) for row in items(field(proof, "maps"))]
    polygon = [numbers(p, 2) for p in items(field(proof, "polygon"))]
    need(0 < len(maps) <= MOST["maps"], "it has no maps, or too many")
    need(3 <= len(polygon) <= MOST["corners"], "its polygon has too few corners, or too many")
    return Shape(maps, polygon)


def all_reached(count, pairs):
    """Whether pairs join all of so many maps."""
    group = list(range(count))
    for i, j in pairs:
        if group[i] != group[j]:
            group = [group[j] if one == group[i] else one for one in group]
    return len(set(group)) == 1


# In several pieces.

def check_disconnected(proof):
    shape = shape_of(proof)
    count = len(shape.maps)
    letters = whole(field(proof, "letters"), 1, MOST["word"])
    side = [whole(s, 0, 255) for s in items(field(proof, "side"))]
    pairs = [
        (word(field(pair, "u")), word(field(pair, "v")), numbers(field(pair, "normal"), 2))
        for pair in items(field(proof, "pairs"))
    ]
    need(count**letters <= MOST["blocks"], "it has too many words that map the polygon")
    need(len(side) == count and set(side) == {0, 1}, "the cut does not part the maps in two")
    need(0 < len(pairs) <= MOST["pairs"], "it has no pairs, or too many")
    need(sum(len(u) + len(v) for u, v, _ in pairs) <= MOST["letters"], "it has too many letters")
    shape.check_convex()
    for block in product(range(count), repeat=letters):
        shape.check_inside(block)
    for u, v, _ in pairs:
        shape.check_letters(u)
        shape.check_letters(v)
        need(side[u[0]] == 0 and side[v[0]] == 1, "a pair does not go across the cut")
    for i, j in product(range(count), repeat=2):
        if side[i] == 0 and side[j] == 1:
            check_cover(count, [(u, v) for u, v, _ in pairs if u[0] == i and v[0] == j], (i,), (j,))
    for u, v, n in pairs:
        need(shape.farthest(u, n) < shape.nearest(v, n), f"{u} and {v} are not shown to be apart")


def check_cover(count, below, u, v):
    """That splitting u or v again and again leads to pairs: the first one, if no pair below has it whole."""
    todo = [(below, u, v)]
    while todo:
        below, u, v = todo.pop()
        need(below, f"{u} and {v} are not covered")
        if (u, v) in below:
            continue
        which = next((k for k, w in enumerate((u, v)) if all(len(pair[k]) > len(w) for pair in below)), None)
        need(which is not None, f"{u} and {v} are not covered")
        depth = len((u, v)[which])
        for letter in range(count):
            part = [pair for pair in below if pair[which][depth] == letter]
            todo.append((part, u + (letter,), v) if which == 0 else (part, u, v + (letter,)))


# In one piece.

def check_connected(proof):
    shape = shape_of(proof)
    count = len(shape.maps)
    gap = number(field(proof, "gap"))
    near = [tuple(map(word, items(pair, 2))) for pair in items(field(proof, "near"))]
    links = items(field(proof, "links"))
    squares = proof.get("squares")
    need(gap >= 0, "the gap is below 0")
    need(max(len(near), len(links)) <= MOST["pairs"], "it has too many pairs or links")
    for w in (w for pair in near for w in pair):
        shape.check_letters(w)
    differences = None if squares is None else Differences(shape, squares)
    links = [LINKS[kind_of(link)](shape, link) for link in links]
    shape.check_convex()
    for k in range(count):
        shape.check_inside((k,))
    if gap < 1:
        for a, b in near:
            for n in shape.normals:
                most = gap * (shape.farthest((), n) - shape.nearest((), n))
                for p, q in ((a, b), (b, a)):
                    need(shape.farthest(p, n) - shape.nearest(q, n) <= most, "two pieces are not near")
        need(all_reached(count, ((a[0], b[0]) for a, b in near)), "pieces that are near do not reach all maps")
    if differences:
        differences.check()
    known = {"gap": gap, "differences": differences, "line": False}
    joined = []
    for pair, holds in links:
        need(holds(known), f"a link between {pair} does not hold")
        joined.append(pair)
    need(all_reached(count, joined), "the links do not reach all maps")


def kind_of(link):
    kind = field(link, "kind")
    need(isinstance(kind, str) and kind in LINKS, "a link is of no known kind")
    return kind


def pair_of(shape, link):
    pair = word(items(field(link, "pair"), 2))
    shape.check_letters(pair)
    return pair


def first(address):
    return (address[0] + address[1])[0]


def point_link(shape, link):
    a, b = (shape.address(value) for value in items(field(link, "addresses"), 2))
    return (first(a), first(b)), lambda known: shape.point(*a) == shape.point(*b)


def area_link(shape, link):
    i, j = pair_of(shape, link)
    need(i != j, "a link leads from a map to itself")
    return (i, j), lambda known: sum(abs(determinant(shape.maps[k])) for k in (i, j)) >= 1


def difference_link(shape, link):
    i, j = pair_of(shape, link)
    steps = [word(items(step, 2)) for step in items(field(link, "steps"))]
    need(len(steps) <= MOST["word"], "a link has too many steps")
    for step in steps:
        shape.check_letters(step)

    def holds(known):
        squares, at = known["differences"], (Fraction(0), Fraction(0))
        if squares is None:
            return False
        for k, l in [(i, j), *steps]:
            at = squares.back(at, k, l)
        return squares.hold([at])

    return (i, j), holds


def between_link(shape, link):
    """Two points of a piece, and one of another piece between them, on a line that holds the attractor."""
    a, b, c = (shape.address(value) for value in items(field(link, "addresses"), 3))
    need(first(a) == first(b), "the ends are of two pieces")

    def holds(known):
        p, q, r = (shape.point(*address) for address in (a, b, c))
        along = minus(q, p)
        if not known["line"]:
            images = [image(m, x) for m in shape.maps for x in (p, q)]
            known["line"] = p != q and all(cross(along, minus(x, p)) == 0 for x in images)
        return known["line"] and p != q and dot(along, minus(r, p)) >= 0 and dot(along, minus(q, r)) >= 0

    return (first(a), first(c)), holds


def crossing_link(shape, link):
    words = [word(w) for w in items(field(link, "words"), 2)]
    far = [(word(field(one, "tail")), numbers(field(one, "direction"), 2)) for one in items(field(link, "far"), 4)]
    for w in words:
        shape.check_letters(w)
    for k, (tail, _) in enumerate(far):
        shape.check_letters(words[k // 2] + tail)

    def holds(known):
        for k, (tail, d) in enumerate(far):
            own, other = words[k // 2], words[1 - k // 2]
            top, bottom = shape.farthest(other, d), shape.nearest(other, d)
            if not top + known["gap"] * (top - bottom) / 2 < shape.nearest(own + tail, d):
                return False
        p, q, r, s = (d for _, d in far)
        return any(between(p, x, q) and between(q, y, p) for x, y in ((r, s), (s, r)))

    return (words[0][0], words[1][0]), holds


def between(a, x, b):
    """Whether a direction lies strictly between two others, counter-clockwise from a to b."""
    if any(v == (0, 0) for v in (a, x, b)):
        return False

    def quarter(v):
        side = cross(a, v)
        return (1 if side > 0 else 3) if side else (0 if dot(a, v) > 0 else 2)

    if quarter(x) != quarter(b):
        return 0 < quarter(x) < quarter(b)
    return quarter(x) in (1, 3) and cross(x, b) > 0


class Differences:
    """Squares full of differences of two points, where all maps have one linear part."""

    def __init__(self, shape, squares):
        self.size = numbers(field(squares, "size"), 2)
        self.cells = []
        cells = items(field(squares, "cells"))
        need(len(cells) <= MOST["cells"], "it has too many squares")
        for cell in cells:
            x, y, k, l = items(cell, 4)
            place = tuple(whole(n, 1 - FARTHEST_CELL, FARTHEST_CELL - 1) for n in (x, y))
            shape.check_letters(word([k, l]))
            self.cells.append((place, k, l))
        self.places = {place for place, _, _ in self.cells}
        linear = {m[:4] for m in shape.maps}
        under = determinant(shape.maps[0])
        need(len(linear) == 1 and under != 0 and min(self.size) > 0, "there are no such squares")
        a, b, c, d = linear.pop()
        self.inverse = (d / under, -b / under, -c / under, a / under, 0, 0)
        self.shifts = [m[4:] for m in shape.maps]

    def back(self, at, k, l):
        return image(self.inverse, minus(at, minus(self.shifts[k], self.shifts[l])))

    def hold(self, points):
        """Whether all squares that the box around some points touches with its inside are there."""
        spans = []
        for n in (0, 1):
            values = [p[n] / self.size[n] for p in points]
            low, high = min(values).__floor__(), max(values).__ceil__()
            # A box without width on a line between squares: those on both sides.
            spans.append(range(low, high) if low < high else range(low - 1, low + 1))
        if len(spans[0]) * len(spans[1]) > len(self.places):
            return False
        return all(place in self.places for place in product(*spans))

    def check(self):
        for (x, y), k, l in self.cells:
            corners = [(self.size[0] * (x + dx), self.size[1] * (y + dy)) for dx, dy in product((0, 1), repeat=2)]
            need(self.hold([self.back(p, k, l) for p in corners]), "a square does not lead back into squares")


LINKS = {
    "point": point_link,
    "area": area_link,
    "difference": difference_link,
    "between": between_link,
    "crossing": crossing_link,
}


def refusal(proof):
    """Why it is no proof; None for one."""
    try:
        need(isinstance(proof, dict), "it is no object")
        (check_disconnected if proof.get("links") is None else check_connected)(proof)
        return None
    except Refused as why:
        return str(why)


def compare(path):
    count = accepted = 0
    other = []
    with open(path, encoding="utf-8") as lines:
        for count, line in enumerate(lines, 1):
            case = read(line)
            why = refusal(case["proof"])
            accepted += why is None
            if (why is None) != case["accepted"]:
                other.append(f"line {count}: {why or 'accepted'}, and frond-check says {case.get('says', 'otherwise')}")
    print("\n".join(other[:20] + [f"{count} proofs, {accepted} accepted, {len(other)} decided otherwise"]))
    return not other and count > 0


def main(arguments):
    if arguments[:1] == ["--compare"]:
        return all([compare(path) for path in arguments[1:]])
    sound = bool(arguments)
    for path in arguments:
        try:
            with open(path, encoding="utf-8") as file:
                why = refusal(read(file.read()))
        except (OSError, ValueError, Refused) as problem:
            why = str(problem)
        print(f"{path}: {'accepted' if why is None else f'refused. {why}'}")
        sound &= why is None
    return sound


if __name__ == "__main__":
    sys.exit(0 if main(sys.argv[1:]) else 1)
