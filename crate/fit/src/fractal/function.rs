//! Fractal functions: fractal curves with one coordinate.

use frond_core::shared::sort_indices;
use glam::{DMat2, DVec2};

use crate::error::FunctionError;
use crate::fractal::curve::{FractalCurve, Side};
use crate::fractal::piece::Piece;
use crate::outline::box_slope_of;

/// The most pieces for which the equation of the dimension is solved.
const MAX_EQUATION: usize = 4096;

/// A box dimension, and how it was come by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Dimension {
    /// From the equation that the factors obey.
    Equation(f64),
    /// The slope of a count of boxes of the graph.
    Counted(f64),
}

/// A function F(t) whose graph is made of smaller copies of parts of itself (Cochran, Hart & Flynn, sections 2.1 to
/// 2.3).
#[derive(Clone, Debug, PartialEq)]
pub struct FractalFunction {
    curve: FractalCurve,
}

fn diagonal(c: &[f64]) -> Vec<DMat2> {
    c.iter().map(|&c| DMat2::from_cols(DVec2::new(c, 0.0), DVec2::ZERO)).collect()
}

fn columns(points: &[DVec2]) -> (Vec<f64>, Vec<DVec2>) {
    points.iter().map(|p| (p.x, DVec2::new(p.y, 0.0))).unzip()
}

impl FractalFunction {
    /// A fractal interpolation function through points (t, x) with factors c, one a piece, each piece a copy of the
    /// whole, reflected where told (section 2.1).
    ///
    /// # Errors
    /// Where there are fewer than two points, t does not increase, a number is not finite, a |c| is 1 or more, or lists
    /// are of other lengths.
    pub fn fif(points: &[DVec2], c: &[f64], reflected: &[bool]) -> Result<Self, FunctionError> {
        let (t, x) = columns(points);
        Ok(Self { curve: FractalCurve::fif(&t, &x, &diagonal(c), reflected)? })
    }

    /// A recurrent fractal interpolation function: piece i is a copy of the graph from point `spans[i].0` to
    /// `spans[i].1` (eqs 4 and 5), backwards where the first is the larger.
    ///
    /// # Errors
    /// As [`fif`](Self::fif), and where a copied part is not longer than the piece.
    pub fn rfif(points: &[DVec2], c: &[f64], spans: &[(usize, usize)]) -> Result<Self, FunctionError> {
        let (t, x) = columns(points);
        Ok(Self { curve: FractalCurve::rfif(&t, &x, &diagonal(c), spans)? })
    }

    /// A partitioned fractal interpolation function from maps `[a, b, c, d, e]` (eq 1) and their domains (eq 7), in any
    /// order.
    ///
    /// # Errors
    /// As [`FractalCurve::new`].
    pub fn pfif(maps: &[([f64; 5], [f64; 2])]) -> Result<Self, FunctionError> {
        let pieces: Vec<_> = maps.iter().map(|&(map, domain)| Piece::from_map(map, domain)).collect();
        if let Some(index) = pieces.iter().position(|piece| !piece.is_finite()) {
            return Err(FunctionError::NotFinite { index });
        }
        let mut order: Vec<usize> = (0..pieces.len()).collect();
        sort_indices(&mut order, &|a, b| pieces[a].range[0].total_cmp(&pieces[b].range[0]));
        Ok(Self { curve: FractalCurve::new(order.iter().map(|&i| pieces[i]).collect())? })
    }

    /// The function as a curve whose y is 0.
    #[must_use]
    pub fn curve(&self) -> &FractalCurve {
        &self.curve
    }

    /// F at `t` as [`FractalCurve::precise_at`] has it: right to the last digits.
    #[must_use]
    pub fn precise_at(&self, t: f64) -> f64 {
        self.curve.precise_at(t).x
    }

    /// F at `t` as [`FractalCurve::at`] has it; from the right where pieces do not meet.
    #[must_use]
    pub fn at(&self, t: f64) -> f64 {
        self.curve.at(t).x
    }

    /// F at `t` from a side, within `tolerance`.
    #[must_use]
    pub fn limit(&self, t: f64, side: Side, tolerance: f64) -> f64 {
        self.curve.limit(t, side, tolerance).x
    }

    /// The integral of F over its interval: exact where every domain begins and ends at knots, else none.
    ///
    /// Over piece i it is |a| (b m + e l + c J), with l, m and J the integrals of 1, t and F over the domain; so the
    /// integrals over all pieces are the fixed point of a contraction.
    #[must_use]
    pub fn integral(&self) -> Option<f64> {
        let spans = self.spans()?;
        let pieces = self.curve.pieces();
        let mut parts = vec![0.0; pieces.len()];
        let mut sums = vec![0.0; pieces.len() + 1];
        for _ in 0..10_000 {
            let mut change: f64 = 0.0;
            let mut size: f64 = 0.0;
            for (i, piece) in pieces.iter().enumerate() {
                let [low, high] = piece.domain;
                let copied: f64 = sums[spans[i].1] - sums[spans[i].0];
                let plain = (high - low) * (piece.shear.x * f64::midpoint(low, high) + piece.offset.x);
                let next = piece.a().abs() * (plain + piece.factor.x_axis.x * copied);
                change = change.max((next - parts[i]).abs());
                size = size.max(next.abs());
                parts[i] = next;
            }
            for (i, part) in parts.iter().enumerate() {
                sums[i + 1] = sums[i] + part;
            }
            if change <= 1e-17 * size {
                break;
            }
        }
        sums.last().copied()
    }

    /// The first and last knots of each domain, where all are knots.
    fn spans(&self) -> Option<Vec<(usize, usize)>> {
        let pieces = self.curve.pieces();
        let [start, end] = self.curve.interval();
        let near = |t: f64| {
            let index = pieces.partition_point(|piece| piece.range[1] <= t + 1e-9 * (end - start));
            let knot = if index == 0 { start } else { pieces[index - 1].range[1] };
            ((knot - t).abs() <= 1e-9 * (end - start)).then_some(index)
        };
        pieces.iter().map(|piece| Some((near(piece.domain[0])?, near(piece.domain[1])?))).collect()
    }

    /// The box dimension of the graph.
    ///
    /// Where all domains begin and end at knots it is the D at which the matrix with entry |c_i| |a_i|^(D - 1) wherever
    /// piece i copies piece j has spectral radius 1, and 1 if there is none above (Barnsley, Elton & Hardin 1989; for
    /// a FIF it is the sum of |c_i| |a_i|^(D - 1) that is 1). Else boxes are counted.
    #[must_use]
    pub fn dimension(&self) -> Dimension {
        let pieces = self.curve.pieces();
        let spans = (pieces.len() <= MAX_EQUATION).then(|| self.spans()).flatten();
        let Some(spans) = spans else { return Dimension::Counted(self.counted_dimension()) };
        if self.is_straight() {
            return Dimension::Equation(1.0);
        }
        let above = |dimension: f64| radius_above_one(pieces, &spans, dimension);
        if !above(1.0) {
            return Dimension::Equation(1.0);
        }
        let (mut low, mut high) = (1.0, 2.0);
        for _ in 0..48 {
            let middle = f64::midpoint(low, high);
            if above(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        Dimension::Equation(f64::midpoint(low, high))
    }

    /// Whether all knots lie on one straight line.
    fn is_straight(&self) -> bool {
        let [start, end] = self.curve.interval();
        let (first, last) = (self.at(start), self.limit(end, Side::Left, 0.0));
        let off = |piece: &Piece| {
            let t = piece.range[0];
            let line = first + (last - first) * (t - start) / (end - start);
            (self.at(t) - line).abs()
        };
        self.curve.pieces().iter().map(off).fold(0.0, f64::max) <= 1e-12 * self.curve.bound()
    }

    /// The slope of a count of boxes of 1/64 to 1/512 of the graph, scaled to a square.
    #[must_use]
    pub fn counted_dimension(&self) -> f64 {
        const SAMPLES: usize = 1 << 14;
        let [start, end] = self.curve.interval();
        let t = |i: usize| start + (end - start) * i as f64 / SAMPLES as f64;
        let heights: Vec<f64> = (0..=SAMPLES).map(|i| self.limit(t(i), Side::Right, 0.0)).collect();
        let low = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let high = heights.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let scale = if high > low { 1.0 / (high - low) } else { 0.0 };
        let points: Vec<_> = heights
            .iter()
            .enumerate()
            .map(|(i, x)| DVec2::new(i as f64 / SAMPLES as f64, (x - low) * scale))
            .collect();
        box_slope_of(&points, false, &[1.0 / 64.0, 1.0 / 128.0, 1.0 / 256.0, 1.0 / 512.0])
    }
}

/// Whether the spectral radius is above 1: the powers of the matrix, plus the identity so that they settle, grow by
/// more than 2 a step.
fn radius_above_one(pieces: &[Piece], spans: &[(usize, usize)], dimension: f64) -> bool {
    let weights: Vec<f64> = pieces
        .iter()
        .map(|piece| piece.factor.x_axis.x.abs() * piece.a().abs().powf(dimension - 1.0))
        .collect();
    let mut vector = vec![1.0; pieces.len()];
    let mut sums = vec![0.0; pieces.len() + 1];
    let mut growth = 0.0;
    for _ in 0..2000 {
        for (i, value) in vector.iter().enumerate() {
            sums[i + 1] = sums[i] + value;
        }
        let mut largest: f64 = 0.0;
        for (i, value) in vector.iter_mut().enumerate() {
            *value += weights[i] * (sums[spans[i].1] - sums[spans[i].0]);
            largest = largest.max(*value);
        }
        for value in &mut vector {
            *value /= largest;
        }
        let settled = (largest - growth).abs() <= 1e-15;
        growth = largest;
        if settled {
            break;
        }
    }
    growth > 2.0 + 1e-14
}
