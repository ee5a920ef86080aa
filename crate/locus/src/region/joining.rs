//! Crossings that join what is not joined yet, for one sample after another: what held before is tried first, and the
//! search stops as soon as one piece has nothing left that it could be joined to.

use glam::DVec2;

use crate::region::descent::{Couple, Descent};
use crate::region::trap::reaching;

/// Pairs of words tried at most for each two maps of a sample.
const TRIES: usize = 600;
/// Looks after which a sample is let be.
const MOST_LOOKS: usize = 60_000;

/// Words of two pieces that cross.
pub(crate) type Words = [Box<[u8]>; 2];

/// Pairs of maps that may cross, the most promising first, and which were tried.
#[derive(Clone, Debug, Default)]
pub(crate) struct Candidates {
    pairs: Vec<Couple>,
    /// A map that nothing joined to the others when a search failed last: mostly that of the sample beside it, too.
    stuck: Option<usize>,
}

impl Candidates {
    /// Those of a system of which nothing was tried yet.
    pub fn begin(&mut self, descent: &mut Descent<1>) {
        self.pairs.clear();
        for i in 0..descent.count {
            for j in i + 1..descent.count {
                let overlap = reaching(&descent.look(i as u32, j as u32));
                if overlap < 1.0 {
                    self.pairs.push(Couple { overlap, u: i as u32, v: j as u32, i: i as u8, j: j as u8 });
                }
            }
        }
        self.pairs.sort_unstable_by(|a, b| a.overlap.total_cmp(&b.overlap));
    }

    /// Looks for crossings that join what is not joined yet, and adds their words to those found. Whether all is
    /// joined; else it can be called again once something else was joined.
    pub fn cross(&mut self, descent: &mut Descent<1>, gap: f64, found: &mut Vec<Words>) -> bool {
        while !descent.is_whole() {
            let Some(next) = self.next(descent) else { return false };
            if descent.nodes > MOST_LOOKS {
                return false;
            }
            let pair = self.pairs.remove(next);
            if let Some((couple, _)) = descent.crossing_of(pair, gap, TRIES) {
                found.push([couple.u, couple.v].map(|piece| descent.word(piece).into()));
                descent.components.join(usize::from(pair.i), usize::from(pair.j));
            }
        }
        true
    }

    /// The pair to try next: one that is the only way out of its component, one of those of a map that was stuck
    /// before, or else the most promising. `None` where some component has no way out.
    fn next(&mut self, descent: &Descent<1>) -> Option<usize> {
        let components = &descent.components;
        let is_open = |pair: &Couple| !components.joined(usize::from(pair.i), usize::from(pair.j));
        self.pairs.retain(is_open);
        let leads_out = |k: usize, pair: &Couple| {
            [pair.i, pair.j].iter().any(|&end| components.joined(k, usize::from(end)))
        };
        let mut only = None;
        for k in (0..descent.count).filter(|&k| components.root(k) == k) {
            let mut out = (0..self.pairs.len()).filter(|&n| leads_out(k, &self.pairs[n]));
            let Some(first) = out.next() else {
                self.stuck = Some(k);
                return None;
            };
            if out.next().is_none() {
                only = only.or(Some(first));
            }
        }
        let stuck = self.stuck.filter(|&k| k < descent.count);
        let of_stuck = || stuck.and_then(|k| self.pairs.iter().position(|pair| leads_out(k, pair)));
        only.or_else(of_stuck).or(Some(0))
    }
}

impl Descent<1> {
    /// Forgets which attractorlets are joined, but for those whose areas leave no room between them.
    pub fn join_filled(&mut self) {
        self.reset();
        for i in 0..self.count {
            for j in i + 1..self.count {
                if self.lanes.areas[i] + self.lanes.areas[j] > 1.0 {
                    self.components.join(i, j);
                }
            }
        }
    }

    pub fn is_whole(&self) -> bool {
        self.components.count() == 1
    }

    /// How wide and how high the attractor is in the plane.
    pub fn size(&self) -> DVec2 {
        let turned = self.lanes.from_round.transpose();
        let reach = |d: DVec2| self.fan.support(turned * d, 0).0;
        let width = |d: DVec2| reach(d) + reach(-d);
        DVec2::new(width(DVec2::X), width(DVec2::Y))
    }

    /// Whether two pieces that crossed in another system do so in this one, and join what was not yet.
    pub fn cross_again(&mut self, [u, v]: &Words, gap: f64) -> bool {
        let (i, j) = (usize::from(u[0]), usize::from(v[0]));
        if self.components.joined(i, j) {
            return false;
        }
        let [u, v] = [u, v].map(|word| self.piece(word));
        self.corners(u, v, gap).is_some() && self.components.join(i, j)
    }

    /// The piece of a word.
    fn piece(&mut self, word: &[u8]) -> u32 {
        let first = u32::from(word[0]);
        word[1..].iter().fold(first, |piece, &letter| self.parts_of(piece).start + u32::from(letter))
    }
}
