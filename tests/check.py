#!/usr/bin/env python3
"""A second checker of Frond's proofs, in fractions alone. It shares no code with crate/check.

    python3 tests/check.py certificate.json ..        replays certificates; exit status 0 if it accepts all of them
    python3 tests/check.py --compare proofs.jsonl     lines {"accepted": true, "proof": {..}}: does it agree with each?

docs/proofs.md has the theorems. Every double is a fraction, so nothing is rounded. Unlike frond-check this program does
not bound its work: give it certificates of some thousand pairs at most.
"""

import json
import re
import sys
from fractions import Fraction
from itertools import product
from math import ulp

MOST = {"maps": 256, "corners": 512, "pairs": 10**6, "cells": 10**5, "word": 1000, "letters": 10**7, "blocks": 4096}
MOST |= {"degree": 16, "numeral": 1000, "numerals": 200_000}
HALVINGS = 256
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
    need(abs(value) < 2**1024 - 2**970, "a number is too large")
    value = float(value)
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


def image_over(m, p):
    """The image of (x, y) / z."""
    x, y, z = p
    return (m[0] * x + m[1] * y + m[4] * z, m[2] * x + m[3] * y + m[5] * z, z)


def step(p, q):
    """From (x, y) / z to another point, but for a positive factor."""
    return (q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2])


def sign(x):
    """Of a number; None where that is not known."""
    return x.sign() if isinstance(x, Number) else (x > 0) - (x < 0)


# Exact numbers: polynomials modulo one of which a real root is meant.

def fraction(text, form=r"-?[0-9]+(/[0-9]+)?"):
    need(isinstance(text, str) and re.fullmatch(form, text), "something is no fraction in digits")
    over, _, under = text.partition("/")
    need(not under or int(under) != 0, "a fraction is over 0")
    return Fraction(int(over), int(under or 1))


class Number:
    """A sum of powers of the root with fractions before them. The same fractions are the same number. Others may be it
    as well, where the polynomial has factors: nothing is concluded from that they differ."""

    def __init__(self, root, value):
        self.root, self.value = root, tuple(value)

    def like(self, x):
        return x if isinstance(x, Number) else Number(self.root, [x] + [Fraction(0)] * (len(self.value) - 1))

    def __add__(self, x):
        return Number(self.root, (a + b for a, b in zip(self.value, self.like(x).value)))

    def __neg__(self):
        return Number(self.root, (-a for a in self.value))

    def __sub__(self, x):
        return self + -x

    def __rsub__(self, x):
        return -self + x

    def __mul__(self, x):
        a, b = self.value, self.like(x).value
        long = [Fraction(0)] * (2 * len(a) - 1)
        for (i, x), (j, y) in product(enumerate(a), enumerate(b)):
            long[i + j] += x * y
        while len(long) > len(a):
            top = long.pop()
            for k, p in enumerate(self.root.polynomial[:-1], len(long) - len(a)):
                long[k] -= top * p / self.root.polynomial[-1]
        return Number(self.root, long)

    __radd__, __rmul__ = __add__, __mul__

    def is_zero(self):
        return not any(self.value)

    def sign(self):
        low, high = self.root.around(self.value)
        if self.is_zero() or low == high == 0:
            return 0
        return 1 if low > 0 else -1 if high < 0 else None


class Root:
    """The one root of a polynomial in an interval, which is made narrow."""

    def __init__(self, polynomial, low, high):
        self.polynomial, self.low, self.high = polynomial, low, high
        below = sign(self.at(low))
        need(low < high and below * sign(self.at(high)) < 0, "the polynomial does not change its sign")
        slope = self.around([k * p for k, p in enumerate(polynomial)][1:])
        need(slope[0] > 0 or slope[1] < 0, "the derivative may be 0")
        for _ in range(HALVINGS):
            middle = (self.low + self.high) / 2
            here = sign(self.at(middle))
            if here == 0:
                self.low = self.high = middle
                break
            if here == below:
                self.low = middle
            else:
                self.high = middle

    def at(self, x):
        value = Fraction(0)
        for p in reversed(self.polynomial):
            value = value * x + p
        return value

    def around(self, coefficients):
        """Bounds of a polynomial, for any number of the interval."""
        low = high = Fraction(0)
        for p in reversed(coefficients):
            ends = [x * y for x in (low, high) for y in (self.low, self.high)]
            low, high = min(ends) + p, max(ends) + p
        return low, high


class Exact:
    """Entries of maps that are numbers of one field."""

    def __init__(self, value, doubles):
        polynomial, entries = items(field(value, "polynomial")), items(field(value, "entries"))
        ends = items(field(value, "root"), 2)
        degree = len(polynomial) - 1
        need(1 <= degree <= MOST["degree"], "the polynomial has another degree")
        listed = {}
        for entry in entries:
            place = whole(field(entry, "map"), 0, 255), whole(field(entry, "entry"), 0, 255)
            powers = items(field(entry, "value"))
            need(place[0] < len(doubles) and place[1] < 6 and place not in listed, "an exact entry is out of place")
            need(len(powers) <= degree, "an exact entry has too many powers")
            listed[place] = powers
        texts = [*polynomial, *ends, *(text for powers in listed.values() for text in powers)]
        need(all(isinstance(text, str) for text in texts), "a fraction is no text")
        need(max(map(len, texts)) <= MOST["numeral"], "a fraction has too many digits")
        need(sum(map(len, texts)) <= MOST["numerals"], "there are too many digits")
        polynomial = [fraction(text, form="-?[0-9]+") for text in polynomial]
        need(polynomial[-1] != 0, "the highest coefficient is 0")
        self.root = Root(polynomial, *map(fraction, ends))
        self.listed = {}
        rows = [[Number(self.root, [x] + [Fraction(0)] * (degree - 1)) for x in row] for row in doubles]
        for (k, entry), powers in listed.items():
            number = Number(self.root, [*map(fraction, powers), *[Fraction(0)] * (degree - len(powers))])
            rows[k][entry] = number
            double = doubles[k][entry]
            self.listed[k, entry] = unit = Fraction(ulp(double)) if double else Fraction(0)
            within = [sign(unit + off) for off in (number - double, double - number)]
            need(all(one in (0, 1) for one in within), f"number {entry} of map {k} is not near its double")
        self.maps = [tuple(row) for row in rows]

    def off(self, doubles, polygon, letters):
        """For each map a bound of how far its image of a point may be from that of the doubles, along x and along y."""
        units = [[self.listed.get((k, entry), Fraction(0)) for entry in range(6)] for k in range(len(doubles))]
        reach = tuple(max(abs(p[n]) for p in polygon) for n in (0, 1))
        for _ in range(1, letters):
            images = [image([abs(x) + u for x, u in zip(row, unit)], reach) for row, unit in zip(doubles, units)]
            reach = tuple(max([reach[n]] + [one[n] for one in images]) for n in (0, 1))
        return [image(unit, reach) for unit in units]


class Shape:
    """Maps and a polygon around their attractor."""

    def __init__(self, maps, polygon, exact=None, letters=1):
        self.maps, self.polygon, self.exact = maps, polygon, exact
        # For each map how far exact numbers may take the images of points from those of the doubles.
        self.off = exact.off(maps, polygon, letters) if exact else None
        # What is equal is decided of the numbers that are meant.
        self.meant = exact.maps if exact else maps
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
        return max(dot(back, p) for p in self.polygon) + dot(n, m[4:]) + self.more(w, n)

    def more(self, w, n):
        """How much farther than doubles exact numbers may reach: letter by letter along what the rest makes of n."""
        if not self.off:
            return 0
        more = 0
        for k, letter in enumerate(w):
            a, b, c, d, _, _ = self.map(w[:k])
            along = (a * n[0] + c * n[1], b * n[0] + d * n[1])
            more += dot(tuple(map(abs, along)), self.off[letter])
        return more

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
        """w_head of the point that w_repeat fixes, by Cramer's rule: (x, y, z) for (x, y) / z, where z is positive."""
        a, b, c, d, e, f = self.meant_map(repeat)
        under = (1 - a) * (1 - d) - b * c
        return image_over(self.meant_map(head), ((1 - d) * e + b * f, (1 - a) * f + c * e, under))

    def meant_map(self, w):
        if not self.exact:
            return self.map(w)
        m = tuple(map(Fraction, (1, 0, 0, 1, 0, 0)))
        for letter in w:
            m = after(m, self.meant[letter])
        return m

    def address(self, value):
        head, repeat = word(field(value, "head")), word(field(value, "repeat"))
        self.check_letters(head, least=0)
        self.check_letters(repeat)
        return head, repeat

    def check_letters(self, w, least=1):
        need(least <= len(w) and all(k < len(self.maps) for k in w), "a word is empty, or has a letter that is no map")
        need(len(w) <= MOST["word"], "a word is too long")


def shape_of(proof, letters=1):
    maps = [numbers(row, 6) for row in items(field(proof, "maps"))]
    polygon = [numbers(p, 2) for p in items(field(proof, "polygon"))]
    need(0 < len(maps) <= MOST["maps"], "it has no maps, or too many")
    need(3 <= len(polygon) <= MOST["corners"], "its polygon has too few corners, or too many")
    exact = proof.get("exact")
    return Shape(maps, polygon, None if exact is None else Exact(exact, maps), letters)


def all_reached(count, pairs):
    """Whether pairs join all of so many maps."""
    group = list(range(count))
    for i, j in pairs:
        if group[i] != group[j]:
            group = [group[j] if one == group[i] else one for one in group]
    return len(set(group)) == 1


# In several pieces.

def check_disconnected(proof):
    letters = whole(field(proof, "letters"), 1, MOST["word"])
    need(len(items(field(proof, "maps"))) ** letters <= MOST["blocks"], "it has too many words that map the polygon")
    shape = shape_of(proof, letters)
    count = len(shape.maps)
    side = [whole(s, 0, 255) for s in items(field(proof, "side"))]
    pairs = [
        (word(field(pair, "u")), word(field(pair, "v")), numbers(field(pair, "normal"), 2))
        for pair in items(field(proof, "pairs"))
    ]
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
    return (first(a), first(b)), lambda known: all(is_zero(x) for x in step(shape.point(*a), shape.point(*b)))


def is_zero(x):
    return x.is_zero() if isinstance(x, Number) else x == 0


def area_link(shape, link):
    i, j = pair_of(shape, link)
    need(i != j, "a link leads from a map to itself")

    def holds(known):
        areas = [determinant(shape.meant[k]) for k in (i, j)]
        signs = [sign(area) for area in areas]
        return None not in signs and sign(sum(area * s for area, s in zip(areas, signs)) - 1) in (0, 1)

    return (i, j), holds


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
        along = step(p, q)
        if not any(sign(x) in (-1, 1) for x in along):
            return False
        if not known["line"]:
            images = [image_over(m, x) for m in shape.meant for x in (p, q)]
            known["line"] = all(is_zero(cross(along, step(p, x))) for x in images)
        return known["line"] and all(sign(dot(along, way)) in (0, 1) for way in (step(p, r), step(r, q)))

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
        need(shape.exact is None, "squares of exact numbers are not checked")
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
