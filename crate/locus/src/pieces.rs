//! The pieces of an attractor, as far as they were looked at.

use std::ops::Range;

use frond_core::Affine2;
use glam::DMat2;

use crate::frame::Frame;
use crate::pair::Piece;

/// A tree of words: each piece knows where its parts are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pieces {
    list: Vec<Piece>,
    metric: DMat2,
}

impl Pieces {
    /// Begins again with the pieces of the maps of a frame.
    pub fn begin(&mut self, frame: &Frame) {
        self.list.clear();
        self.metric = frame.metric;
        for &map in &frame.maps {
            self.add(map);
        }
    }

    fn add(&mut self, map: Affine2) {
        let m = map.linear;
        let size = 0.5 * (m.x_axis.dot(self.metric * m.x_axis) + m.y_axis.dot(self.metric * m.y_axis));
        self.list.push(Piece { map, size, parts: 0 });
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
                self.add(whole * map);
            }
        }
        let parts = self.list[large].parts;
        (parts..parts + frame.maps.len() as u32, first)
    }

    /// Whether the sum of the largest stretches of two pieces into the plane is `limit` or less.
    pub fn are_small(&self, u: u32, v: u32, limit: f64) -> bool {
        let limit = limit * limit;
        let (u, v) = (self.get(u), self.get(v));
        // The larger stretch is between one and 1.42 times the mean square one.
        if u.size + v.size > limit {
            return false;
        }
        let stretch = |piece: &Piece| {
            let m = piece.map.linear;
            let (x, y) = (self.metric * m.x_axis, self.metric * m.y_axis);
            let (xx, xy, yy) = (m.x_axis.dot(x), m.x_axis.dot(y), m.y_axis.dot(y));
            (f64::midpoint(xx, yy) + (0.5 * (xx - yy)).hypot(xy)).sqrt()
        };
        let sum = stretch(u) + stretch(v);
        sum * sum <= limit
    }
}
