//! Trading numbers: knots and copies that do little are given up for some that do more.

use glam::DVec2;

use super::candidates::Library;
use super::marks::Marked;
use crate::closed::{ArcCopy, ClosedCurve, MAX_SPAN};

/// A change of the structure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Move {
    /// The edge becomes straight.
    Straighten(usize),
    /// The knot goes.
    Drop(usize),
    /// The edge gets a knot at this point of the outline; a copy becomes two straight edges.
    Split(usize, usize),
    /// The edge becomes a copy, or copies another arc.
    Copy(usize, ArcCopy),
}

/// What a move is called: its kind, and points of the outline.
pub(crate) type Name = (u8, usize, usize, usize);

/// A move, the sum of squares that it is thought to add, and the numbers that it adds.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Offer {
    pub action: Move,
    pub cost: f64,
    pub numbers: i32,
}

impl Marked {
    /// What a move is called, by points of the outline: knots change their numbers, these mostly do not.
    pub fn name(&self, action: &Move) -> Name {
        match *action {
            Move::Straighten(i) => (0, self.marks[i], 0, 0),
            Move::Drop(k) => (1, self.marks[k], 0, 0),
            Move::Split(i, mark) => (2, self.marks[i], mark, 0),
            Move::Copy(i, copy) => self.name_of_copy(i, copy.from, copy.span),
        }
    }

    /// The name of a copy of an arc by an edge.
    pub fn name_of_copy(&self, edge: usize, from: usize, span: usize) -> Name {
        (3, self.marks[edge], self.marks[from], span)
    }

    /// The curve after moves on edges that are no neighbours of each other. Copies of arcs that lost an end get another
    /// one, or become straight where there is none.
    pub fn after(&self, moves: &[Move], ring: &[DVec2], library: &Library) -> Self {
        let count = self.marks.len();
        let mut dropped = vec![false; count];
        let mut split = vec![None; count];
        let mut edges = self.curve.edges.clone();
        for action in moves {
            match *action {
                Move::Straighten(i) => edges[i] = None,
                Move::Copy(i, copy) => edges[i] = Some(copy),
                Move::Split(i, mark) => {
                    edges[i] = None;
                    split[i] = Some(mark);
                }
                Move::Drop(k) => {
                    dropped[k] = true;
                    edges[(k + count - 1) % count] = None;
                    edges[k] = None;
                }
            }
        }
        // Where each knot goes, and how many there are after the last.
        let mut place = vec![0; count + 1];
        for i in 0..count {
            place[i + 1] = place[i] + usize::from(!dropped[i]) + usize::from(split[i].is_some());
        }
        let total = place[count];
        let mut next = Self { curve: ClosedCurve::polygon(Vec::with_capacity(total)), marks: Vec::new() };
        next.curve.edges.clear();
        for i in 0..count {
            if !dropped[i] {
                next.curve.knots.push(self.curve.knots[i]);
                next.marks.push(self.marks[i]);
                let copy = edges[i].and_then(|copy| {
                    let kept = |from: usize, span: usize| !dropped[from] && !dropped[(from + span) % count];
                    let copy = if kept(copy.from, copy.span) {
                        copy
                    } else {
                        library.best(&self.stretch(ring, i, i + 1)?, kept)?.copy
                    };
                    let end = copy.from + copy.span;
                    let end = place[end % count] + if end >= count { total } else { 0 };
                    let from = place[copy.from];
                    let span = end - from;
                    (2..=MAX_SPAN).contains(&span).then_some(ArcCopy { from, span, ..copy })
                });
                next.curve.edges.push(copy);
            }
            if let Some(mark) = split[i] {
                next.curve.knots.push(ring[mark]);
                next.marks.push(mark);
                next.curve.edges.push(None);
            }
        }
        next
    }

    /// The knots whose surroundings a move changes: it must not meet another one there.
    pub fn touched(&self, action: &Move) -> [usize; 3] {
        let count = self.marks.len();
        match *action {
            Move::Straighten(i) | Move::Copy(i, _) | Move::Split(i, _) => [i, i, (i + 1) % count],
            Move::Drop(k) => [(k + count - 1) % count, k, (k + 1) % count],
        }
    }
}
