//! Which pairs of words show that two pieces are apart.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::support::trapping_polygon::TrappingPolygon;

/// Two pieces that are apart, and a direction that shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Separation {
    /// The word of a piece on side 0; letters from 0, the largest piece first.
    pub u: Vec<u8>,
    /// The word of a piece on side 1.
    pub v: Vec<u8>,
    /// Along this direction all of the first comes before all of the second. Not of unit length.
    pub normal: DVec2,
}

/// A descent on pairs of words whose pieces are bounded by images of a polygon.
pub(crate) struct Descent<'a> {
    frame: &'a Frame,
    polygon: &'a TrappingPolygon,
    /// From the frame to the plane, for directions.
    to_plane: DMat2,
    middle: DVec2,
    words: Vec<Node>,
    /// What was found to be apart.
    pub pairs: Vec<Separation>,
    /// Looks left.
    budget: usize,
}

/// A word: its last letter and what is before it.
struct Node {
    map: Affine2,
    size: f64,
    parent: u32,
    letter: u8,
    letters: u16,
    /// The first of its parts, 0 while there are none.
    parts: u32,
}

/// More letters than this, and rounding has taken over.
const MOST_LETTERS: u16 = 600;
/// Directions tried on a pair.
const DIRECTIONS_PER_PAIR: usize = 8;
/// Digits after the point that directions are rounded to, at first.
const DIRECTION_BITS: [i32; 4] = [3, 8, 16, 32];

impl<'a> Descent<'a> {
    pub fn new(frame: &'a Frame, polygon: &'a TrappingPolygon, budget: usize) -> Self {
        let here = &polygon.here;
        let mut this = Self {
            frame,
            polygon,
            to_plane: frame.from_round.inverse().transpose(),
            middle: here.iter().sum::<DVec2>() / here.len() as f64,
            words: Vec::new(),
            pairs: Vec::new(),
            budget,
        };
        for (letter, &map) in frame.maps.iter().enumerate() {
            this.add(map, u32::MAX, letter as u8, 1);
        }
        this
    }

    fn add(&mut self, map: Affine2, parent: u32, letter: u8, letters: u16) {
        let m = map.linear;
        let size = m.x_axis.length_squared() + m.y_axis.length_squared();
        self.words.push(Node { map, size, parent, letter, letters, parts: 0 });
    }

    /// Appends the pairs that show that the pieces of two maps are apart; `false` if the budget does not suffice, or
    /// rounding is in the way.
    pub fn separate(&mut self, i: u8, j: u8) -> bool {
        let mut stack = vec![(u32::from(i), u32::from(j))];
        while let Some((u, v)) = stack.pop() {
            if self.budget == 0 {
                return false;
            }
            self.budget -= 1;
            let (a, b) = (self.words[u as usize].map, self.words[v as usize].map);
            if let Some(normal) = self.direction(&a, &b).and_then(|normal| self.in_the_plane(normal, &a, &b))
            {
                self.pairs.push(Separation { u: self.word(u), v: self.word(v), normal });
                continue;
            }
            let first = self.words[u as usize].size >= self.words[v as usize].size;
            let Some(parts) = self.parts(if first { u } else { v }) else { return false };
            // Last in, first out: the first letter on top.
            stack.extend(parts.rev().map(|part| if first { (part, v) } else { (u, part) }));
        }
        true
    }

    fn parts(&mut self, word: u32) -> Option<std::ops::Range<u32>> {
        let Node { map, letters, parts, .. } = self.words[word as usize];
        let count = self.frame.maps.len() as u32;
        if parts > 0 {
            return Some(parts..parts + count);
        }
        if letters >= MOST_LETTERS {
            return None;
        }
        let first = self.words.len() as u32;
        self.words[word as usize].parts = first;
        for letter in 0..count {
            let next = map * self.frame.maps[letter as usize];
            self.add(next, word, letter as u8, letters + 1);
        }
        Some(first..first + count)
    }

    fn word(&self, mut k: u32) -> Vec<u8> {
        let mut letters = Vec::new();
        while k != u32::MAX {
            let node = &self.words[k as usize];
            letters.push(node.letter);
            k = node.parent;
        }
        letters.reverse();
        letters
    }

    /// The greatest `normal . x` over the image of the polygon, and where.
    fn support(&self, map: &Affine2, normal: DVec2) -> (f64, DVec2) {
        let pulled = map.linear.transpose() * normal;
        let corners = self.polygon.here.iter();
        let (far, corner) = corners
            .map(|&p| (pulled.dot(p), p))
            .fold((f64::NEG_INFINITY, DVec2::ZERO), |best, next| if next.0 > best.0 { next } else { best });
        (far + map.translation.dot(normal), map.apply(corner))
    }

    /// By how much a direction separates two images of the polygon, beyond rounding, with the nearest corners: each
    /// image may be off, and so may the corners themselves.
    fn between(&self, normal: DVec2, a: &Affine2, b: &Affine2) -> (f64, DVec2) {
        let ((most, p), (least, q)) = (self.support(a, normal), self.support(b, -normal));
        (-least - most - 4.0 * self.frame.rounding * normal.length(), q - p)
    }

    /// A direction that separates: along the line between the middles, then better ones (Frank & Wolfe's algorithm for
    /// the nearest points of the two).
    fn direction(&self, a: &Affine2, b: &Affine2) -> Option<DVec2> {
        let mut step = b.apply(self.middle) - a.apply(self.middle);
        for _ in 0..DIRECTIONS_PER_PAIR {
            let (apart, between) = self.between(step, a, b);
            if apart > 0.0 {
                return Some(step);
            }
            let turn = step - between;
            let length = turn.length_squared();
            if length == 0.0 {
                break;
            }
            step -= turn * (step.dot(turn) / length).clamp(0.0, 1.0);
        }
        None
    }

    /// The direction in the plane, its longer number of size 1, with as few digits as will do. `None` if none of the
    /// directions that can be written down there is near enough.
    fn in_the_plane(&self, normal: DVec2, a: &Affine2, b: &Affine2) -> Option<DVec2> {
        let normal = self.to_plane * normal;
        let normal = normal / normal.abs().max_element();
        let rounded = |digits: i32| {
            let scale = 2.0_f64.powi(digits);
            (normal * scale).round() / scale
        };
        let separates = |normal: &DVec2| {
            let back = self.frame.from_round.transpose() * *normal;
            self.between(back, a, b).0 > 0.0
        };
        DIRECTION_BITS.into_iter().map(rounded).chain([normal]).find(separates)
    }
}
