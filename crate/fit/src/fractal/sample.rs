//! A fractal curve as a polyline.

use glam::{DMat2, DVec2};

use crate::error::FunctionError;
use crate::fractal::curve::{FractalCurve, Side};

/// How far a point may be from the curve, in parts of the tolerance.
const TRUE: f64 = 1e-7;

/// A piece of a piece: where it comes from and what is done to it.
#[derive(Clone, Copy)]
struct Part {
    /// The interval of the curve that is copied.
    source: [f64; 2],
    /// t = scale * source + shift.
    scale: f64,
    shift: f64,
    shear: DVec2,
    factor: DMat2,
    offset: DVec2,
}

/// The values at the ends of pieces, which most parts of a curve begin with: each is found once.
pub(super) struct Ends<'a> {
    curve: &'a FractalCurve,
    /// From the right at the first t of a piece, from the left at its last.
    known: Vec<[Option<DVec2>; 2]>,
}

impl<'a> Ends<'a> {
    pub(super) fn new(curve: &'a FractalCurve) -> Self {
        Self { curve, known: vec![[None; 2]; curve.pieces().len()] }
    }

    /// As [`FractalCurve::limit`].
    pub(super) fn limit(&mut self, t: f64, side: Side, tolerance: f64) -> DVec2 {
        let index = self.curve.piece_at(t, side);
        let end = usize::from(side == Side::Left);
        if t != self.curve.pieces()[index].range[end] {
            return self.curve.limit(t, side, tolerance);
        }
        *self.known[index][end].get_or_insert_with(|| self.curve.limit_at_end(t, side))
    }
}

impl FractalCurve {
    /// Points (t, curve at t) in the order of t, so that the curve between two that follow each other stays within
    /// `tolerance` of both of them.
    ///
    /// # Errors
    /// [`FunctionError::TooManyPoints`] where that takes more than `most` points.
    pub fn polyline(&self, tolerance: f64, most: usize) -> Result<Vec<(f64, DVec2)>, FunctionError> {
        self.polyline_in(None, tolerance, most)
    }

    /// The same of what may be seen in a window, between two of its opposite corners, the lower first. In place of what
    /// cannot be there stands one point of NaN.
    ///
    /// # Errors
    /// As [`polyline`](Self::polyline).
    pub fn polyline_in(
        &self,
        window: Option<[DVec2; 2]>,
        tolerance: f64,
        most: usize,
    ) -> Result<Vec<(f64, DVec2)>, FunctionError> {
        let whole = Part {
            source: self.interval(),
            scale: 1.0,
            shift: 0.0,
            shear: DVec2::ZERO,
            factor: DMat2::IDENTITY,
            offset: DVec2::ZERO,
        };
        // NaN asks for the finest, and finds that there are too many.
        let tolerance = if tolerance > 0.0 { tolerance } else { 0.0 };
        let (middle, reach) = self.disc();
        let mut ends = Ends::new(self);
        let mut points: Vec<(f64, DVec2)> = Vec::new();
        let mut stack = vec![whole];
        while let Some(part) = stack.pop() {
            let [low, high] = part.source;
            let along = part.shear * (high - low);
            let gain = crate::fractal::piece::spectral_norm(part.factor);
            let spread = along.length() + 2.0 * gain * reach;
            if let Some([lower, upper]) = window {
                let at = part.offset + part.shear * f64::midpoint(low, high) + part.factor * middle;
                // Rounding is a part of what the disc is.
                let margin = 0.5 * spread * (1.0 + 1e-9) + tolerance;
                if (at + margin).cmplt(lower).any() || (at - margin).cmpgt(upper).any() {
                    if points.last().is_none_or(|point| !point.1.is_nan()) {
                        let t = if part.scale > 0.0 { low } else { high };
                        points.push((part.scale * t + part.shift, DVec2::NAN));
                    }
                    continue;
                }
            }
            if spread <= tolerance || high <= low {
                let (t, side) = if part.scale > 0.0 { (low, Side::Right) } else { (high, Side::Left) };
                let value =
                    part.offset + part.shear * t + part.factor * ends.limit(t, side, TRUE * tolerance / gain);
                points.push((part.scale * t + part.shift, value));
                continue;
            }
            if points.len() + stack.len() > most {
                return Err(FunctionError::TooManyPoints { count: points.len() + stack.len() });
            }
            self.split(&part, &mut stack);
        }
        let end = self.interval()[1];
        points.push((end, ends.limit(end, Side::Left, 0.0)));
        if points.len() > most {
            return Err(FunctionError::TooManyPoints { count: points.len() });
        }
        Ok(points)
    }

    /// Puts the copies that `part` is made of on the stack, the leftmost on top.
    fn split(&self, part: &Part, stack: &mut Vec<Part>) {
        let [low, high] = part.source;
        let indices = self.piece_at(low, Side::Right)..=self.piece_at(high, Side::Left);
        let from = stack.len();
        for index in indices {
            let (piece, [first, last]) = (&self.pieces()[index], self.seen(index));
            let seen = [low.max(first), high.min(last)];
            if seen[0] > seen[1] {
                continue;
            }
            let ends = seen.map(|t| piece.source(t));
            let (a, d) = (piece.a(), piece.d());
            stack.push(Part {
                source: if piece.reflected { [ends[1], ends[0]] } else { ends },
                scale: part.scale * a,
                shift: part.scale * d + part.shift,
                shear: part.shear * a + part.factor * piece.shear,
                factor: part.factor * piece.factor,
                offset: part.offset + part.shear * d + part.factor * piece.offset,
            });
        }
        if part.scale > 0.0 {
            stack[from..].reverse();
        }
    }
}
