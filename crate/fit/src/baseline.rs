//! What a fit is compared with: other ways to spend as many numbers, or bytes, on an outline.

mod bezier;
mod coded;

pub use bezier::{bezier, bezier_segments};
pub use coded::{bezier_within, fourier_within, polyline_within};

use std::f64::consts::TAU;

use glam::DVec2;

use crate::fitting::Straight;
use crate::outline::{Guard, Outline, features};

/// A polyline through feature points: 2 numbers each.
#[must_use]
pub fn split_polyline(outline: &Outline, numbers: usize) -> Vec<DVec2> {
    features(outline, numbers / 2).iter().map(|&i| outline.points()[i]).collect()
}

/// The best polyline that is found: corners chosen in several ways and moved by least squares on the outline's points,
/// kept as a document keeps them. 2 numbers a corner. It crosses itself nowhere but where the outline does. A
/// [`Fitter`](crate::Fitter) begins with it.
#[must_use]
pub fn least_squares_polyline(outline: &Outline, numbers: usize) -> Vec<DVec2> {
    Straight::new(outline, numbers / 2, Guard::new(outline)).finish().knots
}

/// Fourier descriptors: the lowest complex frequencies of the outline by arc length, 2 numbers each, at `count` points.
///
/// Fewer than 2 numbers are taken for 2, fewer than 3 points for 3.
#[must_use]
pub fn fourier(outline: &Outline, numbers: usize, count: usize) -> Vec<DVec2> {
    let count = count.max(3);
    let terms = (numbers / 2).max(1) as i64;
    // 0, 1, -1, 2, -2 ..
    let frequencies = (0..terms).map(|k| if k % 2 == 1 { (k + 1) / 2 } else { -k / 2 });
    let even = outline.resampled((8 * terms as usize).max(2048));
    let samples = even.points();
    let mut points = vec![DVec2::ZERO; count];
    for frequency in frequencies {
        let unit = |i: usize, n: usize| {
            // The product is reduced first: a large angle would lose digits.
            let turns = (frequency * i as i64).rem_euclid(n as i64);
            DVec2::from_angle(TAU * turns as f64 / n as f64)
        };
        let sum: DVec2 = samples
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let turn = unit(i, samples.len());
                DVec2::new(turn.x, -turn.y).rotate(*p)
            })
            .sum();
        let coefficient = sum / samples.len() as f64;
        for (i, point) in points.iter_mut().enumerate() {
            *point += unit(i, count).rotate(coefficient);
        }
    }
    points
}
