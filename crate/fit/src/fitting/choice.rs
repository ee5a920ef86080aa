//! Which moves are made: numbers are bought where they gain most, and paid for with the cheapest.

use frond_core::hash;
use frond_core::shared::sort_indices;

use super::marks::Marked;
use super::moves::{Move, Offer};

/// How bold a choice is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Temper {
    /// How much chance there is in what estimates are taken for; 0 is none.
    pub jitter: f64,
    /// What may be paid, in parts of what is gained.
    pub greed: f64,
    /// Of the chance.
    pub seed: u32,
}

/// Offers by what they cost.
pub(crate) fn cheapest_first(offers: &[Offer], cost: &dyn Fn(&Offer) -> f64) -> Vec<Offer> {
    let costs: Vec<f64> = offers.iter().map(cost).collect();
    let mut order: Vec<usize> = (0..offers.len()).collect();
    sort_indices(&mut order, &|i, j| costs[i].total_cmp(&costs[j]));
    order.into_iter().map(|i| offers[i]).collect()
}

/// Moves for a curve, of at most so many pairs of numbers.
pub(crate) struct Choice<'a> {
    now: &'a Marked,
    pairs: usize,
    batch: usize,
    error: f64,
}

impl<'a> Choice<'a> {
    /// Prepares for at most `batch` pairs of moves on a curve, whose sum of squares is `error`.
    pub fn new(now: &'a Marked, pairs: usize, batch: usize, error: f64) -> Self {
        Self { now, pairs, batch, error }
    }

    /// Pairs of offers that gain more than they cost, far from each other, the best first.
    #[inline(never)]
    pub fn of(&self, mut freeing: Vec<Offer>, mut using: Vec<Offer>, temper: Temper) -> Vec<Move> {
        let mut chance = 0;
        let mut shake = |offer: &mut Offer| {
            chance += 1;
            let random = f64::from(hash::unit(hash::counter(temper.seed, chance)));
            offer.cost *= (temper.jitter * 2.0 * (random - 0.5)).exp();
        };
        if temper.jitter > 0.0 {
            freeing.iter_mut().for_each(&mut shake);
            using.iter_mut().for_each(&mut shake);
        }
        let per = |offer: &Offer| offer.cost / f64::from(offer.numbers.abs().max(1));
        let freeing = cheapest_first(&freeing, &per);
        let least = 1e-4 * self.error;
        using.retain(|offer| offer.cost < -least);
        let using = cheapest_first(&using, &|offer| offer.cost);
        let mut touched = vec![false; self.now.marks.len()];
        let mut claim = |action: &Move| {
            let knots = self.now.touched(action);
            let free = knots.iter().all(|&k| !touched[k]);
            if free {
                knots.iter().for_each(|&k| touched[k] = true);
            }
            free
        };
        let mut moves = Vec::new();
        let used = self.now.curve.knots.len() + self.now.curve.copies();
        let mut spare = 2 * (self.pairs as i32 - used as i32);
        let mut sellers = freeing.iter();
        let mut owed = 0.0;
        for offer in &using {
            if moves.len() >= 2 * self.batch {
                break;
            }
            // Without a price it may be had at once.
            while offer.numbers > spare {
                let Some(seller) = sellers.next() else { return moves };
                if owed + seller.cost > -offer.cost * temper.greed {
                    return moves;
                }
                if claim(&seller.action) {
                    owed += seller.cost;
                    spare -= seller.numbers;
                    moves.push(seller.action);
                }
            }
            if owed < -offer.cost * temper.greed && claim(&offer.action) {
                spare -= offer.numbers;
                owed = 0.0;
                moves.push(offer.action);
            }
        }
        moves
    }
}
