//! The law of steps of the first packed curves: it is read, and written no more.

use glam::DVec2;

use super::{NARROWEST, WIDER, exp, shares};

/// Turns that were written.
pub const TURNS: u64 = 20;

/// The shares of steps that are no wider than `most` in x and y. The density falls with the length r of a step as
/// exp(-r (1 - k cos a) / s), where a is the angle to the step before it.
#[derive(Clone, Debug)]
pub struct FormerTable {
    s: f64,
    k: f64,
    most: i64,
    falls: Vec<f64>,
    weights: Vec<f64>,
    along: Vec<f64>,
}

impl FormerTable {
    /// Of the width s and k = turn / 20.
    pub fn new(width: u64, turn: u64, most: i64) -> Self {
        let s = (0..width).fold(NARROWEST, |s, _| s * WIDER);
        let wide = (2 * most + 1) as usize;
        let fall = |x: i64, y: i64| exp(-((x * x + y * y) as f64).sqrt() / s);
        let falls = (-most..=most).flat_map(|x| (-most..=most).map(move |y| fall(x, y))).collect();
        Self { s, k: turn as f64 / TURNS as f64, most, falls, weights: Vec::new(), along: vec![0.0; wide] }
    }

    /// Prepares for a step after this one: the shares of each x.
    pub fn columns(&mut self, before: DVec2) -> Vec<u64> {
        let length = (before.x * before.x + before.y * before.y).sqrt();
        let way = if length > 0.0 { before * (self.k / (self.s * length)) } else { DVec2::ZERO };
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
