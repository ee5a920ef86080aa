//! From a PFIF to a RFIF.

use glam::DVec2;

use crate::error::FunctionError;
use crate::fractal::function::FractalFunction;
use crate::fractal::piece::Piece;

/// What may be taken for a knot, in parts of the interval.
const KNOT_DISTANCE: f64 = 1e-7;

/// A recurrent function by its knots: what [`FractalFunction::rfif`] takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Recurrent {
    /// The knots (t, x).
    pub points: Vec<DVec2>,
    /// The factor of each piece.
    pub c: Vec<f64>,
    /// From which knot to which each piece copies, backwards where the first is the larger.
    pub spans: Vec<(usize, usize)>,
}

impl Recurrent {
    /// The function.
    ///
    /// # Errors
    /// As [`FractalFunction::rfif`].
    pub fn function(&self) -> Result<FractalFunction, FunctionError> {
        FractalFunction::rfif(&self.points, &self.c, &self.spans)
    }
}

impl FractalFunction {
    /// The same function as a RFIF; none where it takes more than `most` pieces, or endlessly many.
    ///
    /// Every end of a domain must be a knot. A knot inside a range cuts the piece in two, and where it is copied from
    /// must be a knot, too; and so on, until there are no new ones. This answers the question that Cochran, Hart &
    /// Flynn leave open (section 4.2): the seven maps of Table 3 come to eleven pieces.
    ///
    /// Where pieces did not meet, they do now: at the limit from the right. None where slits are left between pieces.
    #[must_use]
    pub fn to_recurrent(&self, most: usize) -> Option<Recurrent> {
        let pieces = self.curve().pieces();
        let [start, end] = self.curve().interval();
        if pieces.windows(2).any(|pair| pair[0].range[1] != pair[1].range[0]) {
            return None;
        }
        let near = KNOT_DISTANCE * (end - start);
        let ends = pieces.iter().flat_map(|piece| piece.range.into_iter().chain(piece.domain));
        let mut waiting: Vec<f64> = ends.collect();
        let mut knots: Vec<f64> = Vec::new();
        while let Some(t) = waiting.pop() {
            let Err(place) = place(&knots, t, near) else { continue };
            if knots.len() > most {
                return None;
            }
            knots.insert(place, t);
            // Ends of ranges come from ends of domains, which wait already.
            let inside = |piece: &&Piece| t > piece.range[0] + near && t < piece.range[1] - near;
            if let Some(piece) = pieces.iter().find(inside) {
                waiting.push(piece.source(t));
            }
        }
        let (mut c, mut spans) = (Vec::new(), Vec::new());
        for pair in knots.windows(2) {
            let middle = f64::midpoint(pair[0], pair[1]);
            let piece = pieces.iter().find(|piece| middle < piece.range[1])?;
            let knot = |t: f64| place(&knots, piece.source(t), near).ok();
            spans.push((knot(pair[0])?, knot(pair[1])?));
            c.push(piece.factor.x_axis.x);
        }
        let points = knots.iter().map(|&t| DVec2::new(t, self.precise_at(t))).collect();
        Some(Recurrent { points, c, spans })
    }
}

/// Where a knot is, or where it would go.
fn place(knots: &[f64], t: f64, near: f64) -> Result<usize, usize> {
    let after = knots.partition_point(|&knot| knot < t - near);
    if knots.get(after).is_some_and(|knot| (knot - t).abs() <= near) { Ok(after) } else { Err(after) }
}
