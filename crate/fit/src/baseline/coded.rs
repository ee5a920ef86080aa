//! Other ways to spend so many bytes on an outline, each on the grid by which it is nearest and coded as well as our
//! own curves.
//!
//! Of polylines all bytes are those that are written, in the form of a [`Spline`]. Of the others bits are what the laws
//! of their codes say, to which an arithmetic coder comes within some bytes; the width of their grid is not counted.

use std::f64::consts::{LN_2, TAU};

use glam::DVec2;

use super::bezier_segments;
use crate::outline::{MAX_PREPARED, Nearest, Outline};
use crate::spline::{StepLaw, nearest_polyline};

/// Bits for how many there are, for a first point, and for a parameter of a code.
const COUNT_BITS: f64 = 12.0;
const FIRST_BITS: f64 = 16.0;
const PARAMETER_BITS: f64 = 5.0;

/// Bits for the two numbers of a [`StepLaw`].
const STEPS_BITS: f64 = 10.0;

/// The nearest so far, and how near it is: the sum of squares of distances.
#[derive(Default)]
struct Best(Option<(f64, Vec<DVec2>)>);

impl Best {
    fn show(&mut self, outline: &Outline, line: Vec<DVec2>) {
        if line.len() < 3 {
            return;
        }
        let near = Nearest::new(&line, true);
        let off = outline.points().iter().map(|&p| near.to(p).squared).sum();
        if self.0.as_ref().is_none_or(|best| off < best.0) {
            self.0 = Some((off, line));
        }
    }

    fn line(self) -> Option<Vec<DVec2>> {
        self.0.map(|best| best.1)
    }
}

/// What is measured: no more points than are seen.
fn measured(outline: &Outline) -> Outline {
    if outline.points().len() > MAX_PREPARED { outline.resampled(MAX_PREPARED) } else { outline.clone() }
}

/// Grids, in parts of the diagonal: each is finer than the one before by a root of two.
fn grids(diagonal: f64) -> impl Iterator<Item = f64> {
    (0..28).map(move |i| diagonal / 12.0 * 0.5_f64.powf(f64::from(i) / 2.0))
}

/// The nearest polyline that is found within so many bytes, in the same form as our own curves: the outline's own
/// corners, or others of the best polylines by least squares, on the grid by which they are nearest.
///
/// Where the outline meets itself nowhere, it does not either. None where nothing fits into so few bytes.
#[must_use]
pub fn polyline_within(outline: &Outline, bytes: usize) -> Option<Vec<DVec2>> {
    nearest_polyline(outline, bytes).map(|spline| spline.polyline(1))
}

/// Fourier descriptors on the grid by which they are nearest: frequencies whose amplitudes fall as a power, each number
/// written by the law of Laplace of that width.
#[must_use]
pub fn fourier_within(outline: &Outline, bytes: usize) -> Option<Vec<DVec2>> {
    let outline = &measured(outline);
    let even = outline.resampled(2048);
    let samples = even.points();
    let most = 700_i64;
    let frequencies: Vec<i64> = (1..most).map(|k| if k % 2 == 1 { (k + 1) / 2 } else { -k / 2 }).collect();
    let unit = |frequency: i64, i: usize, n: usize| {
        DVec2::from_angle(TAU * (frequency * i as i64).rem_euclid(n as i64) as f64 / n as f64)
    };
    let coefficient = |frequency: i64| {
        let sum: DVec2 = samples
            .iter()
            .enumerate()
            .map(|(i, p)| {
                let turn = unit(frequency, i, samples.len());
                DVec2::new(turn.x, -turn.y).rotate(*p)
            })
            .sum();
        sum / samples.len() as f64
    };
    let middle = coefficient(0);
    let all: Vec<DVec2> = frequencies.iter().map(|&f| coefficient(f)).collect();
    let mut best = Best::default();
    for grid in grids(outline.diagonal()) {
        let whole: Vec<DVec2> = all.iter().map(|c| (*c / grid).round()).collect();
        // As many as the bytes allow, by the widths that suit them best.
        let mut terms = 0;
        for many in (1..whole.len()).step_by(2) {
            let bits = [1.0, 1.25, 1.5, 1.75, 2.0, 2.5]
                .map(|power| {
                    let scaled = |i: usize| {
                        (whole[i].x.abs() + whole[i].y.abs()) * (frequencies[i].abs() as f64).powf(power)
                    };
                    let width =
                        (0..many).skip(2).map(scaled).sum::<f64>() / (2.0 * many as f64 - 4.0).max(1.0);
                    let number = |i: usize, x: f64| {
                        let s =
                            (width / (frequencies[i].abs() as f64).powf(power)).max(0.12 * f64::from(i >= 2));
                        laplace(x, s)
                    };
                    (2..many).map(|i| number(i, whole[i].x) + number(i, whole[i].y)).sum::<f64>()
                })
                .into_iter()
                .fold(f64::INFINITY, f64::min);
            if bits + 4.0 * 10.0 + COUNT_BITS + FIRST_BITS + 2.0 * PARAMETER_BITS > 8.0 * bytes as f64 {
                break;
            }
            terms = many;
        }
        if terms < 3 {
            continue;
        }
        let count = 4096;
        let line: Vec<DVec2> = (0..count)
            .map(|i| {
                let term = |k: usize| unit(frequencies[k], i, count).rotate(whole[k] * grid);
                middle + (0..terms).map(term).sum::<DVec2>()
            })
            .collect();
        best.show(outline, line);
    }
    best.line()
}

/// Bits of a whole number by the law of Laplace of mean size s.
fn laplace(x: f64, s: f64) -> f64 {
    let fall = (-1.0 / s.max(1e-3)).exp();
    -((1.0 - fall) / (1.0 + fall)).log2() + x.abs() / (s.max(1e-3) * LN_2)
}

/// Cubic segments on the grid by which they are nearest. Handles are written as steps from where a straight line has
/// them.
#[must_use]
pub fn bezier_within(outline: &Outline, bytes: usize) -> Option<Vec<DVec2>> {
    let outline = &measured(outline);
    let mut best = Best::default();
    let mut many = 3;
    while many * 6 < 2000 && many < outline.points().len() / 2 {
        let segments = bezier_segments(outline, 6 * many);
        for grid in grids(outline.diagonal()) {
            let whole: Vec<[DVec2; 4]> = segments.iter().map(|s| s.map(|p| (p / grid).round())).collect();
            let ends = |i: usize| whole[i][3] - whole[i][0];
            let count = whole.len();
            let chords = (0..count).map(|i| (ends(i), ends((i + count - 1) % count)));
            let handles = |i: usize| {
                let [a, b, c, d] = whole[i];
                [(b - a.lerp(d, 1.0 / 3.0), d - a), (c - a.lerp(d, 2.0 / 3.0), d - a)]
            };
            let bits = StepLaw::told(chords) + StepLaw::told((0..count).flat_map(handles));
            if bits + 2.0 * STEPS_BITS + COUNT_BITS + FIRST_BITS > 8.0 * bytes as f64 {
                break;
            }
            let at = |[a, b, c, d]: [DVec2; 4], t: f64| {
                let s = 1.0 - t;
                a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
            };
            let line: Vec<DVec2> =
                whole.iter().flat_map(|s| (0..16).map(|i| at(*s, f64::from(i) / 16.0) * grid)).collect();
            best.show(outline, line);
        }
        many += 1 + many / 12;
    }
    best.line()
}
