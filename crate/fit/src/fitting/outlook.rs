//! What could be done to a curve: all moves, with what they are thought to come to.

use std::collections::BTreeMap;

use glam::DVec2;

use super::candidates::{Library, Proposal, Stretch};
use super::marks::Marked;
use super::moves::{Move, Name, Offer};

/// The share of an edge's squares that a knot at its farthest point is thought to take off.
const SPLIT_SHARE: f64 = 0.5;

/// The best copy for an edge that was found, and until which round it stands: then what was refused is not any more.
#[derive(Clone, Copy, Debug)]
struct Known {
    proposal: Option<Proposal>,
    until: usize,
}

/// Estimates for one curve. It holds as long as the curve is not changed.
#[derive(Clone, Debug)]
pub(crate) struct Outlook {
    library: Library,
    stretches: Vec<Option<Stretch>>,
    /// What the copy of each edge takes off.
    kept: Vec<f64>,
    /// For each edge what a corner takes off, and at which point of the outline.
    corners: Vec<Option<(f64, usize)>>,
    copies: Vec<Option<Known>>,
    /// For each edge its sum of squares now, and the index of the outline's point farthest from it.
    truth: Vec<(f64, usize)>,
    drops: Vec<Offer>,
}

impl Outlook {
    /// Measures what the moves of a curve would do; `ring` are the outline's points. `truth` has for each edge its sum
    /// of squares now, and the index of the outline's point farthest from it.
    pub fn new(now: &Marked, ring: &[DVec2], library: Library, truth: Vec<(f64, usize)>) -> Self {
        let count = now.marks.len();
        let stretches: Vec<_> = (0..count).map(|i| now.stretch(ring, i, i + 1)).collect();
        let mut kept = vec![0.0; count];
        let mut corners = vec![None; count];
        for (i, stretch) in stretches.iter().enumerate() {
            let Some(stretch) = stretch else { continue };
            if let Some(copy) = &now.curve.edges[i] {
                kept[i] = library.gain(stretch, copy);
            }
            let (gain, share) = library.corner(stretch);
            corners[i] = Some((gain, now.mark_over(ring, i, share)));
        }
        let mut drops = Vec::new();
        for k in 0..count {
            let before = (k + count - 1) % count;
            let (Some(left), Some(right)) = (&stretches[before], &stretches[k]) else { continue };
            let Some(both) = now.stretch(ring, before, k + 1) else { continue };
            let cost = both.straight - (left.straight - kept[before] + right.straight - kept[k]);
            let copies =
                i32::from(now.curve.edges[before].is_some()) + i32::from(now.curve.edges[k].is_some());
            drops.push(Offer { action: Move::Drop(k), cost, numbers: -2 - 2 * copies });
        }
        Self { library, stretches, kept, corners, copies: vec![None; count], truth, drops }
    }

    /// The arcs that may be copied.
    pub fn library(&self) -> &Library {
        &self.library
    }

    /// All moves worth a thought: those that free numbers, and those that use them. What is refused beyond this round,
    /// by [`name`](Marked::name), is left out.
    pub fn offers(
        &mut self,
        now: &Marked,
        ring: &[DVec2],
        round: usize,
        refused: &BTreeMap<Name, usize>,
    ) -> (Vec<Offer>, Vec<Offer>) {
        let until = |name: &Name| refused.get(name).copied().filter(|&until| until > round);
        let (mut freeing, mut using) = (Vec::new(), Vec::new());
        for (i, stretch) in self.stretches.iter().enumerate() {
            let (Some(stretch), Some((gain, mark))) = (stretch, self.corners[i]) else { continue };
            let kept = self.kept[i];
            let mut numbers = 2;
            if now.curve.edges[i].is_some() {
                freeing.push(Offer { action: Move::Straighten(i), cost: kept, numbers: -2 });
                numbers = 0;
            }
            let name = |copy: &Proposal| now.name_of_copy(i, copy.copy.from, copy.copy.span);
            let stands = |known: &Known| {
                round < known.until && known.proposal.as_ref().is_none_or(|copy| until(&name(copy)).is_none())
            };
            let known = self.copies[i].filter(stands).unwrap_or_else(|| {
                let mut end = usize::MAX;
                let proposal = self.library.best(stretch, |from, span| {
                    let refused = until(&now.name_of_copy(i, from, span));
                    end = end.min(refused.unwrap_or(usize::MAX));
                    refused.is_none()
                });
                Known { proposal, until: end }
            });
            self.copies[i] = Some(known);
            if let Some(Proposal { gain, copy }) = known.proposal {
                using.push(Offer { action: Move::Copy(i, copy), cost: kept - gain, numbers });
            }
            using.push(Offer { action: Move::Split(i, mark), cost: kept - gain, numbers });
        }
        // Where the outline turns back over a chord, or is not seen so for another reason, what is true counts: a knot
        // at the farthest point is thought to take off the most part of it.
        for (i, &(error, farthest)) in self.truth.iter().enumerate() {
            if now.marks[i] != farthest && now.is_inside(i, farthest, ring.len()) {
                let numbers = if now.curve.edges[i].is_some() { 0 } else { 2 };
                using.push(Offer { action: Move::Split(i, farthest), cost: -SPLIT_SHARE * error, numbers });
            }
        }
        freeing.extend_from_slice(&self.drops);
        freeing.retain(|offer| until(&now.name(&offer.action)).is_none());
        using.retain(|offer| until(&now.name(&offer.action)).is_none());
        (freeing, using)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::closed::ClosedCurve;
    use crate::grown::maple_leaf;
    use crate::outline::{Outline, decimated};

    #[test]
    fn what_is_kept_in_mind_is_what_would_be_found_anew() {
        let outline = Outline::new(&maple_leaf(1)).unwrap();
        let ring = outline.points();
        let marks = decimated(&outline, 40);
        let now = Marked { curve: ClosedCurve::polygon(marks.iter().map(|&i| ring[i]).collect()), marks };
        let anew = || {
            let library = Library::new(&now.curve, 1e-3 * outline.diagonal(), 3);
            Outlook::new(&now, ring, library, Vec::new())
        };
        let told = |(freeing, using): (Vec<Offer>, Vec<Offer>)| {
            let told = |offer: &Offer| (now.name(&offer.action), offer.cost.to_bits(), offer.numbers);
            (freeing.iter().map(told).collect::<Vec<_>>(), using.iter().map(told).collect::<Vec<_>>())
        };
        let mut kept = anew();
        let mut refused = BTreeMap::new();
        let first = told(kept.offers(&now, ring, 0, &refused));
        for round in 0..12 {
            let offers = kept.offers(&now, ring, round, &refused);
            // The best copies are refused for some rounds, and then those that came in their place.
            let copies = offers.1.iter().filter(|offer| matches!(offer.action, Move::Copy(..)));
            if round < 4 {
                for offer in copies.step_by(round + 1) {
                    refused.insert(now.name(&offer.action), round + 3 + round % 2);
                }
            }
            let fresh = told(anew().offers(&now, ring, round, &refused));
            assert_eq!(told(kept.offers(&now, ring, round, &refused)), fresh, "round {round}");
            assert_eq!(fresh == first, round >= 7, "round {round}");
        }
    }
}
