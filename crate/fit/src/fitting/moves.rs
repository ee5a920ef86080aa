//! Trading numbers: knots and copies that do little are given up for some that do more.

use glam::DVec2;

use super::candidates::{Library, Proposal};
use super::marks::Marked;
use crate::closed::{ArcCopy, ClosedCurve, MAX_SPAN};

/// The share of an edge's squares that a knot at its farthest point is thought to take off.
const SPLIT_SHARE: f64 = 0.5;

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
    /// All moves worth a thought: those that free numbers, and those that use them.
    ///
    /// `truth` has for each edge its sum of squares now, and the index of the outline's point farthest from it. What is
    /// `refused`, by [`name`](Self::name), is left out.
    pub fn offers(
        &self,
        ring: &[DVec2],
        library: &Library,
        truth: &[(f64, usize)],
        refused: impl Fn(&Name) -> bool,
    ) -> (Vec<Offer>, Vec<Offer>) {
        let count = self.marks.len();
        let (mut freeing, mut using) = (Vec::new(), Vec::new());
        let stretches: Vec<_> = (0..count).map(|i| self.stretch(ring, i, i + 1)).collect();
        let mut kept = vec![0.0; count];
        for (i, stretch) in stretches.iter().enumerate() {
            let Some(stretch) = stretch else { continue };
            if let Some(copy) = &self.curve.edges[i] {
                kept[i] = library.gain(stretch, copy);
                freeing.push(Offer { action: Move::Straighten(i), cost: kept[i], numbers: -2 });
            }
            let numbers = if self.curve.edges[i].is_some() { 0 } else { 2 };
            if let Some(Proposal { gain, copy }) =
                library.best(stretch, |from, span| !refused(&self.name_of_copy(i, from, span)))
            {
                using.push(Offer { action: Move::Copy(i, copy), cost: kept[i] - gain, numbers });
            }
            let (gain, share) = library.corner(stretch);
            let mark = self.mark_over(ring, i, share);
            using.push(Offer { action: Move::Split(i, mark), cost: kept[i] - gain, numbers });
        }
        // Where the outline turns back over a chord, or is not seen so for another reason, what is true counts: a knot
        // at the farthest point is thought to take off the most part of it.
        for (i, &(error, farthest)) in truth.iter().enumerate() {
            if self.marks[i] != farthest && self.is_inside(i, farthest, ring.len()) {
                let numbers = if self.curve.edges[i].is_some() { 0 } else { 2 };
                using.push(Offer { action: Move::Split(i, farthest), cost: -SPLIT_SHARE * error, numbers });
            }
        }
        for k in 0..count {
            let before = (k + count - 1) % count;
            let (Some(left), Some(right)) = (&stretches[before], &stretches[k]) else { continue };
            let Some(both) = self.stretch(ring, before, k + 1) else { continue };
            let now = left.straight - kept[before] + right.straight - kept[k];
            let copies =
                i32::from(self.curve.edges[before].is_some()) + i32::from(self.curve.edges[k].is_some());
            freeing.push(Offer {
                action: Move::Drop(k),
                cost: both.straight - now,
                numbers: -2 - 2 * copies,
            });
        }
        freeing.retain(|offer| !refused(&self.name(&offer.action)));
        using.retain(|offer| !refused(&self.name(&offer.action)));
        (freeing, using)
    }

    /// What a move is called, by points of the outline: knots change their numbers, these mostly do not.
    pub fn name(&self, action: &Move) -> Name {
        match *action {
            Move::Straighten(i) => (0, self.marks[i], 0, 0),
            Move::Drop(k) => (1, self.marks[k], 0, 0),
            Move::Split(i, mark) => (2, self.marks[i], mark, 0),
            Move::Copy(i, copy) => self.name_of_copy(i, copy.from, copy.span),
        }
    }

    fn name_of_copy(&self, edge: usize, from: usize, span: usize) -> Name {
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
