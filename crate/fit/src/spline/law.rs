//! What it takes to write a step from point to point on a grid.
//!
//! What is written has to be read anywhere: shares are computed by sums, products, quotients and roots alone, which are
//! the same on every machine.

use std::f64::consts::{LN_2, TAU};

use glam::DVec2;

/// Widths and turns that are written.
pub const WIDTHS: u64 = 80;
pub const TURNS: u64 = 20;

/// Widths that double.
const OCTAVE: u64 = 8;

/// The widest: beyond the longest step.
const WIDEST: f64 = 360.0;

/// The narrowest width, and how much wider each is than the one before: the eighth root of 2.
const NARROWEST: f64 = 0.3;
const WIDER: f64 = 1.090_507_732_665_257_7;

/// The sum of shares.
pub const ALL: u64 = 1 << 24;

/// A law of steps on a grid of width 1: the density falls with the length r of a step as exp(-r (1 - k cos a) / s),
/// where a is the angle to the step before it. Its integral over the plane is 2 pi s² / (1 - k²)^(3/2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepLaw {
    /// Which width s, which turn k = turn / 20.
    pub(crate) width: u64,
    pub(crate) turn: u64,
    s: f64,
    k: f64,
    base: f64,
}

impl StepLaw {
    pub(crate) fn new(width: u64, turn: u64) -> Self {
        let s = (0..width).fold(NARROWEST, |s, _| s * WIDER);
        let k = turn as f64 / TURNS as f64;
        Self { width, turn, s, k, base: (TAU * s * s / (1.0 - k * k).powf(1.5)).log2() }
    }

    /// The law by which these steps take the fewest bits, each with the one before it.
    #[must_use]
    pub fn of(pairs: impl Iterator<Item = (DVec2, DVec2)>) -> Self {
        let (mut long, mut ahead, mut many) = (0.0, 0.0, 0.0);
        for (step, before) in pairs {
            long += step.length();
            ahead += step.dot(before.normalize_or_zero());
            many += 1.0;
        }
        let law = |turn: u64| {
            let k = turn as f64 / TURNS as f64;
            let s = 0.5 * (long - k * ahead) / f64::max(many, 1.0);
            let width = ((s / NARROWEST).max(1.0).log2() * 8.0).round().clamp(0.0, WIDEST);
            Self::new(width as u64, turn)
        };
        let bits = |law: &Self| many * law.base + (long - law.k * ahead) / (law.s * LN_2);
        (0..TURNS).map(law).min_by(|a, b| bits(a).total_cmp(&bits(b))).unwrap_or_else(|| law(0))
    }

    /// The law of the same steps in cells of 2^k each way.
    pub(crate) fn of_cells(&self, k: u32) -> Self {
        Self::new(self.width.saturating_sub(OCTAVE * u64::from(k)).min(WIDTHS - 1), self.turn)
    }

    /// About how many bits a step takes, behind another one.
    #[must_use]
    pub fn bits(&self, step: DVec2, before: DVec2) -> f64 {
        self.base + (step.length() - self.k * step.dot(before.normalize_or_zero())) / (self.s * LN_2)
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
    law: StepLaw,
    most: i64,
    falls: Vec<f64>,
    weights: Vec<f64>,
    along: Vec<f64>,
}

impl Table {
    pub fn new(law: StepLaw, most: i64) -> Self {
        let wide = (2 * most + 1) as usize;
        let fall = |x: i64, y: i64| exp(-((x * x + y * y) as f64).sqrt() / law.s);
        let falls = (-most..=most).flat_map(|x| (-most..=most).map(move |y| fall(x, y))).collect();
        Self { law, most, falls, weights: Vec::new(), along: vec![0.0; wide] }
    }

    /// Prepares for a step after this one: the shares of each x.
    pub fn columns(&mut self, before: DVec2) -> Vec<u64> {
        let length = (before.x * before.x + before.y * before.y).sqrt();
        let way = if length > 0.0 { before * (self.law.k / (self.law.s * length)) } else { DVec2::ZERO };
        let wide = self.along.len();
        let most = self.most;
        for (y, along) in (-most..=most).zip(&mut self.along) {
            *along = exp(y as f64 * way.y);
        }
        self.weights.resize(wide, 0.0);
        for (i, x) in (-most..=most).enumerate() {
            let row = &self.falls[i * wide..(i + 1) * wide];
            let sum: f64 = row.iter().zip(&self.along).map(|(fall, along)| fall * along).sum();
            self.weights[i] = sum * exp(x as f64 * way.x);
        }
        shares(&self.weights)
    }

    /// The shares of each y, for an x counted from the left.
    pub fn rows(&mut self, column: usize) -> Vec<u64> {
        let wide = self.along.len();
        let row = &self.falls[column * wide..(column + 1) * wide];
        self.weights.clear();
        self.weights.extend(row.iter().zip(&self.along).map(|(fall, along)| fall * along));
        shares(&self.weights)
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
        for before in [DVec2::ZERO, DVec2::new(3.0, -2.0), DVec2::new(0.0, 40.0)] {
            let law = StepLaw::new(28, 12);
            let mut table = Table::new(law, 90);
            let columns = table.columns(before);
            assert!(columns.is_sorted() && columns[181] == ALL);
            for step in [DVec2::new(0.0, 0.0), DVec2::new(5.0, -3.0), DVec2::new(-8.0, 1.0)] {
                let (i, j) = ((step.x + 90.0) as usize, (step.y + 90.0) as usize);
                let rows = table.rows(i);
                let part = |sums: &[u64], i: usize| (sums[i + 1] - sums[i]) as f64 / ALL as f64;
                let bits = -(part(&columns, i) * part(&rows, j)).log2();
                let told = if before == DVec2::ZERO {
                    law.bits(step, before) - 0.97
                } else {
                    law.bits(step, before)
                };
                assert!((bits - told).abs() < 0.1, "{before} {step}: {bits} {told}");
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
