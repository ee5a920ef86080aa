//! Taking a bent attractor apart.

use frond_deform::Cursor;

use super::{Bent, Fineness, Placed, Verdict};
use crate::pieces::letters::Letters;

/// A piece and where the bend takes it.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Which piece it is.
    pub cursor: Cursor,
    /// The first letters of its word.
    pub letters: Letters,
    /// Its part of the measure.
    pub mass: f64,
    /// Where it goes, in pixels.
    pub placed: Placed,
}

/// How a cut stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cut {
    /// There is more to visit.
    Working,
    /// These are all pieces, each as even as it should be.
    Complete,
    /// These are all, but some are rougher than the bend.
    Rough,
    /// There are too many.
    TooMany,
}

#[derive(Clone, Debug)]
struct Node {
    cursor: Cursor,
    letters: Letters,
    depth: usize,
    mass: f64,
}

/// A walk down the tree of pieces of a bent attractor, in portions.
#[derive(Debug, Default)]
pub struct Cutter {
    stack: Vec<Node>,
    rough: bool,
    /// Pieces found so far, and how many there may be.
    pieces: usize,
    most: usize,
    /// Visits that are left: words that end outside of the window cost time as well.
    patience: u64,
}

impl Cutter {
    /// Begins anew, for so many pieces at most.
    pub fn begin(&mut self, bent: &Bent<'_>, most: usize) {
        self.stack.clear();
        self.stack.push(Node { cursor: bent.bend.whole(), letters: Letters::NONE, depth: 0, mass: 1.0 });
        (self.rough, self.pieces, self.most) = (false, 0, most);
        self.patience = 16 * most as u64;
    }

    /// Visits at most so many pieces.
    pub fn run(
        &mut self,
        bent: &Bent<'_>,
        fineness: &Fineness,
        visits: u64,
        mut found: impl FnMut(Piece),
    ) -> Cut {
        for _ in 0..visits {
            let Some(Node { cursor, letters, depth, mass }) = self.stack.pop() else {
                return if self.rough { Cut::Rough } else { Cut::Complete };
            };
            if self.pieces >= self.most || self.patience == 0 {
                return Cut::TooMany;
            }
            self.patience -= 1;
            let placed = match bent.judge(&cursor, depth, mass, fineness).0 {
                Verdict::Outside => continue,
                Verdict::Split => {
                    let parts = bent.frame.probabilities.iter().enumerate();
                    self.stack.extend(parts.map(|(letter, probability)| Node {
                        cursor: bent.bend.child(&cursor, letter),
                        letters: letters.then(letter),
                        depth: depth + 1,
                        mass: mass * probability,
                    }));
                    continue;
                }
                Verdict::Whole(placed) => placed,
                Verdict::Rough(placed) => {
                    self.rough = true;
                    placed
                }
            };
            self.pieces += 1;
            found(Piece { cursor, letters, mass, placed });
        }
        if self.stack.is_empty() && !self.rough { Cut::Complete } else { Cut::Working }
    }
}
