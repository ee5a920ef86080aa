//! What it takes to write a step from point to point on a grid.
//!
//! What is written has to be read anywhere: shares are computed by sums, products, quotients and roots alone, which are
//! the same on every machine.

mod former;

use std::f64::consts::{LN_2, TAU};

use glam::DVec2;

pub use former::{FormerTable, TURNS};

/// Widths that are written.
pub const WIDTHS: u64 = 80;

/// Widths that double.
const OCTAVE: u64 = 8;

/// The widest: beyond the longest step.
const WIDEST: f64 = 360.0;

/// The narrowest width, and how much wider each is than the one before: the eighth root of 2.
const NARROWEST: f64 = 0.3;
const WIDER: f64 = 1.090_507_732_665_257_7;

/// The sum of shares.
pub const ALL: u64 = 1 << 24;

/// How lengths of steps are spread: the density is as r^near exp(-(r/s)^(halves / 2)).
#[derive(Clone, Copy, Debug, PartialEq)]
struct Spread {
    near: i32,
    halves: i32,
    /// The gamma function at (near + 2) / (halves / 2).
    gamma: f64,
}

const fn spread(near: i32, halves: i32, gamma: f64) -> Spread {
    Spread { near, halves, gamma }
}

const SPREADS: [Spread; 8] = [
    spread(0, 2, 1.0),
    spread(0, 3, 0.892_979_511_569_249),
    spread(0, 4, 1.0),
    spread(1, 2, 2.0),
    spread(1, 3, 1.0),
    spread(1, 4, 0.886_226_925_452_758),
    spread(2, 3, 1.504_575_488_251_556),
    spread(2, 4, 1.0),
];

/// Steps of this spread and longer ones weigh as much as an integral says.
const COARSE: f64 = 4.0;

/// What a step of no length takes where its share is the least there is.
const RARE_BITS: f64 = 24.0;

/// How many spreads there are.
pub const MANY_SPREADS: u64 = SPREADS.len() as u64;

impl Spread {
    /// x^(halves / 2).
    fn power(self, x: f64) -> f64 {
        match self.halves {
            2 => x,
            3 => x * x.sqrt(),
            _ => x * x,
        }
    }

    /// The number that has this power.
    fn root(self, x: f64) -> f64 {
        match self.halves {
            2 => x,
            3 => x.powf(2.0 / 3.0),
            _ => x.sqrt(),
        }
    }

    /// The sum of what all steps weigh, where the spread is s: of short ones point by point.
    fn sum(self, s: f64) -> f64 {
        if s >= COARSE {
            return TAU * s.powi(self.near + 2) * self.gamma / (0.5 * f64::from(self.halves));
        }
        let reach = (8.0 * s).ceil() as i32;
        let weight = |x: i32, y: i32| {
            let r = f64::from(x * x + y * y).sqrt();
            self.near(r) * (-self.power(r / s)).exp()
        };
        // A quarter of the plane, with one of the rays at its rim.
        let quarter = (0..=reach).flat_map(|x| (1..=reach).map(move |y| weight(x, y)));
        weight(0, 0) + 4.0 * quarter.sum::<f64>()
    }

    fn near(self, r: f64) -> f64 {
        match self.near {
            0 => 1.0,
            1 => r,
            _ => r * r,
        }
    }
}

/// Sectors of the angle between a step and the one before it.
const SECTORS: usize = 16;

/// The tangent of an eighth of a half turn.
const TAN: f64 = 0.414_213_562_373_095_03;

/// Which sector a step is in, in order from behind to the right, ahead, to the left and behind; none where it or the
/// one before is none.
fn sector(step: DVec2, before: DVec2) -> Option<usize> {
    let (ahead, left) = (before.dot(step), before.x * step.y - before.y * step.x);
    let (x, y) = (ahead.abs(), left.abs());
    if x == 0.0 && y == 0.0 {
        return None;
    }
    let eighth = usize::from(y >= TAN * x) + usize::from(y >= x) + usize::from(TAN * y >= x);
    let off = if ahead > 0.0 { eighth } else { 7 - eighth };
    Some(if left >= 0.0 { 8 + off } else { 7 - off })
}

/// How often steps were in each sector so far: what comes next is guessed by that.
#[derive(Clone, Debug, PartialEq)]
pub struct Turns {
    counts: [u32; SECTORS],
}

impl Turns {
    /// Nothing is known yet.
    pub fn new() -> Self {
        Self { counts: [1; SECTORS] }
    }

    /// A step more, behind another one.
    pub fn count(&mut self, step: DVec2, before: DVec2) {
        if let Some(sector) = sector(step, before) {
            self.counts[sector] += 4;
        }
    }

    /// How many times as likely as all alike each sector is. Neighbours are like each other.
    fn weights(&self) -> [f64; SECTORS] {
        let all: u32 = self.counts.iter().sum();
        std::array::from_fn(|i| {
            let at = |k: usize| self.counts[k % SECTORS];
            let share = 2 * at(i) + at(i + 1) + at(i + SECTORS - 1);
            f64::from(share) * (SECTORS / 4) as f64 / f64::from(all)
        })
    }
}

/// A law of steps on a grid of width 1: how long they are, and how they turn from the one before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLaw {
    /// Which width s, and which spread.
    pub(crate) width: u64,
    pub(crate) spread: u64,
    kind: Spread,
    s: f64,
    base: f64,
    /// Bits of each power of a length: one over the power of s, in bits.
    fall: f64,
    /// Bits of each sector, beside those of all alike.
    turns: [f64; SECTORS],
}

impl StepLaw {
    pub(crate) fn new(width: u64, spread: u64) -> Self {
        let kind = SPREADS[(spread % MANY_SPREADS) as usize];
        let s = (0..width).fold(NARROWEST, |s, _| s * WIDER);
        let fall = 1.0 / (kind.power(s) * LN_2);
        Self { width, spread, kind, s, base: kind.sum(s).log2(), fall, turns: [0.0; SECTORS] }
    }

    /// The law by which these steps take the fewest bits, each with the one before it.
    #[must_use]
    pub fn of(pairs: impl Iterator<Item = (DVec2, DVec2)>) -> Self {
        let (mut powers, mut logs, mut many, mut zeros) = ([0.0; 3], 0.0, 0.0, 0.0);
        let mut turns = Turns::new();
        for (step, before) in pairs {
            let r = step.length();
            powers[0] += r;
            powers[1] += r * r.sqrt();
            powers[2] += r * r;
            logs += if r > 0.0 { r.log2() } else { 0.0 };
            zeros += f64::from(u8::from(r == 0.0));
            many += 1.0;
            turns.count(step, before);
        }
        let law = |spread: u64| {
            let kind = SPREADS[spread as usize];
            let mean = powers[kind.halves as usize - 2] / f64::max(many, 1.0);
            let s = kind.root(0.5 * f64::from(kind.halves) * mean / f64::from(kind.near + 2));
            let width = ((s / NARROWEST).max(1.0).log2() * 8.0).round().clamp(0.0, WIDEST);
            Self::new(width as u64, spread)
        };
        let bits = |law: &Self| {
            let none = if law.kind.near > 0 { zeros * (RARE_BITS - law.base) } else { 0.0 };
            many * law.base + none - f64::from(law.kind.near) * logs
                + powers[law.kind.halves as usize - 2] * law.fall
        };
        let best = (0..MANY_SPREADS).map(law).min_by(|a, b| bits(a).total_cmp(&bits(b)));
        let turns = turns.weights().map(|weight| -weight.log2());
        Self { turns, ..best.unwrap_or_else(|| law(0)) }
    }

    /// About how many bits these steps take, each with the one before it, where it is learned on the way how they turn.
    #[must_use]
    pub fn told(pairs: impl Iterator<Item = (DVec2, DVec2)> + Clone) -> f64 {
        let law = Self::of(pairs.clone());
        let mut turns = Turns::new();
        pairs
            .map(|(step, before)| {
                let turn = sector(step, before).map_or(0.0, |i| turns.weights()[i].log2());
                turns.count(step, before);
                law.length_bits(step) - turn
            })
            .sum()
    }

    /// The law of the same steps in cells of 2^k each way.
    pub(crate) fn of_cells(&self, k: u32) -> Self {
        Self::new(self.width.saturating_sub(OCTAVE * u64::from(k)).min(WIDTHS - 1), self.spread)
    }

    fn length_bits(&self, step: DVec2) -> f64 {
        let r = step.length();
        if self.kind.near == 0 {
            self.base + self.kind.power(r) * self.fall
        } else if r > 0.0 {
            self.base + self.kind.power(r) * self.fall - f64::from(self.kind.near) * r.log2()
        } else {
            RARE_BITS
        }
    }

    /// About how many bits a step takes, behind another one.
    #[must_use]
    pub fn bits(&self, step: DVec2, before: DVec2) -> f64 {
        self.length_bits(step) + sector(step, before).map_or(0.0, |sector| self.turns[sector])
    }
}

/// exp(x), the same on every machine; x is held to ±300.
fn exp(x: f64) -> f64 {
    let x = x.clamp(-300.0, 300.0) / 65_536.0;
    let mut e = 1.0 + x * (1.0 + x / 2.0 * (1.0 + x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0))));
    for _ in 0..16 {
        e *= e;
    }
    e
}

/// The shares of steps by a law that are no wider than `most` in x and y.
#[derive(Clone, Debug)]
pub struct Table {
    most: i64,
    /// How they turned so far.
    turns: Turns,
    falls: Vec<f64>,
    weights: Vec<f64>,
}

impl Table {
    pub fn new(law: StepLaw, most: i64) -> Self {
        let scale = 1.0 / law.kind.power(law.s);
        let fall = |x: i64, y: i64| {
            let r = ((x * x + y * y) as f64).sqrt();
            law.kind.near(r) * exp(-law.kind.power(r) * scale)
        };
        let falls: Vec<f64> = (-most..=most).flat_map(|x| (-most..=most).map(move |y| fall(x, y))).collect();
        Self { most, turns: Turns::new(), weights: falls.clone(), falls }
    }

    /// Prepares for a step after this one: the shares of each x.
    pub fn columns(&mut self, before: DVec2) -> Vec<u64> {
        let turns = self.turns.weights();
        let most = self.most;
        let places = (-most..=most).flat_map(|x| (-most..=most).map(move |y| DVec2::new(x as f64, y as f64)));
        for ((weight, fall), place) in self.weights.iter_mut().zip(&self.falls).zip(places) {
            *weight = sector(place, before).map_or(*fall, |sector| fall * turns[sector]);
        }
        let wide = (2 * most + 1) as usize;
        let sums: Vec<f64> = self.weights.chunks_exact(wide).map(|row| row.iter().sum()).collect();
        shares(&sums)
    }

    /// The shares of each y, for an x counted from the left.
    pub fn rows(&self, column: usize) -> Vec<u64> {
        let wide = (2 * self.most + 1) as usize;
        shares(&self.weights[column * wide..(column + 1) * wide])
    }

    /// The step that it was, behind another one.
    pub fn count(&mut self, step: DVec2, before: DVec2) {
        self.turns.count(step, before);
    }
}

/// Sums of shares from the left, 0 first, [`ALL`] last: each has one at least.
fn shares(weights: &[f64]) -> Vec<u64> {
    let all: f64 = weights.iter().sum();
    let left = (ALL - weights.len() as u64) as f64;
    let mut sum = 0;
    let mut sums = vec![0];
    for weight in weights {
        let share = weight / all * left;
        sum += 1 + if share > 0.0 { share.min(left) as u64 } else { 0 };
        sums.push(sum);
    }
    // Rounded down: what is missing is the last one's. Should rounding have given too much, it is taken from it.
    if let Some(last) = sums.last_mut() {
        *last = ALL;
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_say_what_the_law_does() {
        for (width, spread) in [(28, 0), (30, 4), (34, 7)] {
            let law = StepLaw::new(width, spread);
            let mut table = Table::new(law, 90);
            for before in [DVec2::ZERO, DVec2::new(3.0, -2.0), DVec2::new(0.0, 40.0)] {
                let columns = table.columns(before);
                assert!(columns.is_sorted() && columns[181] == ALL);
                for step in [DVec2::new(5.0, -3.0), DVec2::new(-8.0, 1.0)] {
                    let (i, j) = ((step.x + 90.0) as usize, (step.y + 90.0) as usize);
                    let rows = table.rows(i);
                    let part = |sums: &[u64], i: usize| (sums[i + 1] - sums[i]) as f64 / ALL as f64;
                    let bits = -(part(&columns, i) * part(&rows, j)).log2();
                    let told = law.bits(step, before);
                    assert!((bits - told).abs() < 0.15, "{spread} {before} {step}: {bits} {told}");
                }
            }
        }
    }

    #[test]
    fn sectors_are_even_and_in_order() {
        for turn in [0.0, 0.7, 2.9] {
            let before = DVec2::from_angle(turn) * 7.0;
            for i in 0..SECTORS {
                let angle = (i as f64 + 0.5 - 8.0) * TAU / 16.0;
                assert_eq!(sector(DVec2::from_angle(angle + turn) * 0.3, before), Some(i));
            }
            assert_eq!(sector(DVec2::ZERO, before), None);
        }
        assert_eq!(sector(DVec2::ONE, DVec2::ZERO), None);
    }

    #[test]
    fn what_turns_always_the_same_way_takes_fewer_bits() {
        let ring: Vec<DVec2> = (0..60).map(|i| DVec2::from_angle(0.3 * f64::from(i)) * 9.0).collect();
        let pairs = ring.windows(2).map(|w| (w[1], w[0]));
        let law = StepLaw::of(pairs.clone());
        let each: f64 = pairs.clone().map(|(step, before)| law.bits(step, before)).sum();
        let told = StepLaw::told(pairs.clone());
        let alike: f64 = pairs.map(|(step, _)| law.length_bits(step)).sum();
        assert!(each < told && told < alike - 80.0, "{each} {told} {alike}");
    }

    #[test]
    fn short_steps_take_as_many_bits_as_their_shares_say() {
        let ahead = DVec2::new(1.0, 0.0);
        let mixed: Vec<DVec2> =
            (0..90).map(|i| if i % 3 == 0 { ahead } else { DVec2::ZERO }).chain([DVec2::ONE]).collect();
        for steps in [vec![DVec2::ZERO; 50], vec![ahead; 50], mixed] {
            let law = StepLaw::of(steps.iter().map(|&step| (step, DVec2::ZERO)));
            let mut table = Table::new(law, 8);
            let columns = table.columns(DVec2::ZERO);
            for step in [DVec2::ZERO, ahead, DVec2::ONE] {
                let (i, j) = ((step.x + 8.0) as usize, (step.y + 8.0) as usize);
                let rows = table.rows(i);
                let part = |sums: &[u64], i: usize| (sums[i + 1] - sums[i]) as f64 / ALL as f64;
                let bits = -(part(&columns, i) * part(&rows, j)).log2();
                let told = law.bits(step, DVec2::ZERO);
                assert!(told > 0.0 && (bits - told).abs() < 0.2 || bits > 18.0, "{step} {bits} {told}");
            }
        }
    }

    #[test]
    fn the_exponential_is_one() {
        for i in -3000..=3000 {
            let x = f64::from(i) / 10.0;
            assert!((exp(x) / x.exp() - 1.0).abs() < 1e-8, "{x}");
        }
    }
}
