//! What it takes to write a step from point to point on a grid, in bits.

use std::f64::consts::{LN_2, TAU};

use glam::DVec2;

/// Bits for the two numbers of a [`Steps`].
pub const STEPS_BITS: f64 = 10.0;

/// A law of steps on a grid of width 1: the density falls with the length r of a step as exp(-r (1 - k cos a) / s),
/// where a is the angle to the step before it. Its integral over the plane is 2 pi s² / (1 - k²)^(3/2).
///
/// An arithmetic coder comes within a byte of the sum of what such laws say.
#[derive(Clone, Copy, Debug)]
pub struct Steps {
    s: f64,
    k: f64,
    base: f64,
}

impl Steps {
    /// The law by which these steps take the fewest bits, each with the one before it.
    pub fn of(pairs: impl Iterator<Item = (DVec2, DVec2)>) -> Self {
        let (mut long, mut ahead, mut many) = (0.0, 0.0, 0.0);
        for (step, before) in pairs {
            long += step.length();
            ahead += step.dot(before.normalize_or_zero());
            many += 1.0;
        }
        let law = |k: f64| {
            let s = (0.5 * (long - k * ahead) / f64::max(many, 1.0)).max(0.3);
            Self { s, k, base: (TAU * s * s / (1.0 - k * k).powf(1.5)).log2() }
        };
        let bits = |law: &Self| many * law.base + (long - law.k * ahead) / (law.s * LN_2);
        let laws = (0..20).map(|i| law(f64::from(i) / 20.0));
        laws.min_by(|a, b| bits(a).total_cmp(&bits(b))).unwrap_or_else(|| law(0.0))
    }

    /// What a step takes.
    pub fn bits(&self, step: DVec2, before: DVec2) -> f64 {
        self.base + (step.length() - self.k * step.dot(before.normalize_or_zero())) / (self.s * LN_2)
    }
}

/// Bits for each of two kinds, where some of all are of the first: what a coder that learns comes to.
pub fn kinds(first: usize, all: usize) -> [f64; 2] {
    let share = |many: usize| -((many as f64 + 0.5) / (all as f64 + 1.0)).log2();
    [share(first), share(all - first)]
}
