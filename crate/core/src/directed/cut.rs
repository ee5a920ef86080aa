//! The adaptive cut of a state: its copies of one size.

use crate::bounds::hull2::Hull;
use crate::directed::system::DirectedIfs;
use crate::linear::affine::Affine2;
use crate::sample::adaptive_cut2::CutOutcome;

/// A copy that a state is cut into.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DirectedPiece {
    /// Takes the state that is copied to the copy.
    pub map: Affine2,
    /// The map of the cut state that it lies in, from 0.
    pub first: usize,
    /// The state that is copied, from 0.
    pub from: usize,
}

/// Visits the copies that make up a state and are smaller than `size` (plane units), while those that they are part of
/// are not: ways are prolonged only where the shape is still large. The copies together are the whole state.
///
/// At most `budget` copies are looked at. As [`adaptive_cut`](crate::adaptive_cut()), and for a system of one state the
/// same; a state that is not there is cut into nothing.
pub fn directed_cut(
    system: &DirectedIfs,
    state: usize,
    size: f64,
    budget: usize,
    mut visit: impl FnMut(DirectedPiece),
) -> CutOutcome {
    let diameters: Vec<f64> = Hull::of_states(system).iter().map(Hull::diameter).collect();
    let mut open = Vec::new();
    if state < system.len() {
        open.push(DirectedPiece { map: Affine2::IDENTITY, first: 0, from: state });
    }
    let (mut seen, mut pieces) = (0, 0);
    while let Some(piece) = open.pop() {
        seen += 1;
        if seen > budget {
            return CutOutcome { pieces, complete: false };
        }
        let diameter = diameters[piece.from];
        // Not `<=`: a size that is NaN or 0 must not cut for ever without the budget noticing.
        if piece.map.norm() * diameter < size || diameter == 0.0 {
            pieces += 1;
            visit(piece);
            continue;
        }
        let root = seen == 1;
        // The last map first, since the list is a stack.
        for (i, part) in system.states()[piece.from].iter().enumerate().rev() {
            let first = if root { i } else { piece.first };
            open.push(DirectedPiece { map: piece.map * part.map, first, from: part.from });
        }
    }
    CutOutcome { pieces, complete: true }
}
