//! The pieces of an attractor, as far as they were looked at.

use std::ops::Range;

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;

/// One piece: the image of the attractor under the map of a word.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Piece {
    /// The map of the word, in the frame; its translation is the middle of the piece.
    pub map: Affine2,
    /// Half the squared Frobenius norm of the map into the plane: the mean square of its stretches.
    pub size: f64,
    /// The index of its first part, 0 while it is not split.
    pub parts: u32,
    /// The piece that it is a part of: itself if it is an attractorlet.
    parent: u32,
}

/// A tree of words: each piece knows where its parts are.
#[derive(Clone, Debug, Default)]
pub(crate) struct WordTree {
    list: Vec<Piece>,
    /// See [`Frame::from_round`].
    from_round: DMat2,
}

impl WordTree {
    /// Begins again with the pieces of the maps of a frame.
    pub fn begin(&mut self, frame: &Frame) {
        self.list.clear();
        self.from_round = frame.from_round;
        for (k, &map) in frame.maps.iter().enumerate() {
            self.add(map, k as u32);
        }
    }

    fn add(&mut self, map: Affine2, parent: u32) {
        let m = map.linear;
        let square = |side: DVec2| (self.from_round * side).length_squared();
        let size = 0.5 * (square(m.x_axis) + square(m.y_axis));
        self.list.push(Piece { map, size, parts: 0, parent });
    }

    /// Piece `u`.
    #[inline]
    pub fn get(&self, u: u32) -> &Piece {
        &self.list[u as usize]
    }

    /// Pieces that follow one another.
    #[inline]
    pub fn range(&self, range: Range<u32>) -> &[Piece] {
        &self.list[range.start as usize..range.end as usize]
    }

    /// The parts of the larger one of two pieces, and whether that is the first.
    #[inline]
    pub fn parts_of_larger(&mut self, frame: &Frame, u: u32, v: u32) -> (Range<u32>, bool) {
        let first = self.get(u).size >= self.get(v).size;
        let large = if first { u } else { v } as usize;
        if self.list[large].parts == 0 {
            self.list[large].parts = self.list.len() as u32;
            let whole = self.list[large].map;
            for &map in &frame.maps {
                self.add(whole * map, large as u32);
            }
        }
        let parts = self.list[large].parts;
        (parts..parts + frame.maps.len() as u32, first)
    }

    /// The letters that lead from an attractorlet into a piece of it, the first one first.
    pub fn letters(&self, mut piece: u32) -> Vec<u8> {
        let mut letters = Vec::new();
        loop {
            let parent = self.get(piece).parent;
            if parent == piece {
                break;
            }
            letters.push((piece - self.get(parent).parts) as u8);
            piece = parent;
        }
        letters.reverse();
        letters
    }

    /// Whether the sum of the largest stretches of two pieces into the plane is `limit` or less. None is below 0.
    pub fn are_small(&self, u: u32, v: u32, limit: f64) -> bool {
        let limit = limit * limit.abs();
        let (u, v) = (self.get(u), self.get(v));
        // The larger stretch is between one and 1.42 times the mean square one.
        if u.size + v.size > limit {
            return false;
        }
        let stretch = |piece: &Piece| {
            let m = self.from_round * piece.map.linear;
            let (xx, xy, yy) = (m.x_axis.length_squared(), m.x_axis.dot(m.y_axis), m.y_axis.length_squared());
            (f64::midpoint(xx, yy) + (0.5 * (xx - yy)).hypot(xy)).sqrt()
        };
        let sum = stretch(u) + stretch(v);
        sum * sum <= limit
    }
}
