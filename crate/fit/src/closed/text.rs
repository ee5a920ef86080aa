//! A closed curve as a word of a link.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;

use super::{ClosedCurve, PackError};

/// Parts of the box's diagonal: what a document keeps of a knot. A fit is a hundred times coarser.
const FINE: f64 = 1e-5;

/// The longest word that is read, in characters.
pub const MAX_TEXT: usize = 48 * 1024;

impl ClosedCurve {
    /// The curve as documents keep it: knots to a hundred-thousandth of the box's diagonal, factors to 1/2048.
    ///
    /// Doing it again changes nothing.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes).
    pub fn quantised(&self) -> Result<Self, PackError> {
        let mut curve = Self::from_bytes(&self.to_bytes(self.grain())?)?;
        // Where rounding takes the box over a power of two the grid is another one; points of the coarser lie on the finer.
        for _ in 0..4 {
            let again = Self::from_bytes(&curve.to_bytes(curve.grain())?)?;
            if again == curve {
                break;
            }
            curve = again;
        }
        Ok(curve)
    }

    /// The quantised curve in letters, digits, `-` and `_`: some three characters a knot, four more a copied edge.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes).
    pub fn to_text(&self) -> Result<String, PackError> {
        let curve = self.quantised()?;
        Ok(URL_SAFE_NO_PAD.encode(curve.to_bytes(curve.grain())?))
    }

    /// The curve of a word that [`to_text`](Self::to_text) wrote.
    ///
    /// # Errors
    /// Where the word is no curve, or longer than [`MAX_TEXT`].
    pub fn from_text(text: &str) -> Result<Self, PackError> {
        if text.len() > MAX_TEXT {
            return Err(PackError::TooManyKnots);
        }
        let bytes = URL_SAFE_NO_PAD.decode(text).map_err(|_| PackError::CutShort)?;
        Self::from_bytes(&bytes)
    }

    /// The precision of documents: a power of two, so that it stays the same when the curve has moved a little.
    fn grain(&self) -> f64 {
        let (low, high) = crate::outline::bounds(&self.knots);
        let fine = FINE * low.distance(high);
        if fine > 0.0 && fine.is_finite() { fine.log2().floor().exp2() } else { fine }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use proptest::prelude::*;

    use super::*;
    use crate::closed::ArcCopy;

    fn ring(count: usize, size: f64, wobble: &[f64]) -> ClosedCurve {
        let knot = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / count as f64;
            DVec2::from_angle(angle) * size * (1.0 + 0.3 * wobble[i % wobble.len()])
        };
        let edge = |i: usize| {
            let copy = ArcCopy {
                from: (i + 1) % count,
                span: 3,
                reversed: i.is_multiple_of(2),
                c: wobble[i % wobble.len()],
            };
            (i.is_multiple_of(3) && count > 6).then_some(copy)
        };
        ClosedCurve { knots: (0..count).map(knot).collect(), edges: (0..count).map(edge).collect() }
    }

    proptest! {
        #[test]
        fn it_comes_back_as_it_was_written(
            count in 3..120_usize,
            exponent in -30..30_i32,
            wobble in proptest::collection::vec(-0.6..0.6_f64, 1..40),
        ) {
            let curve = ring(count, f64::from(exponent).exp2() * 1.37, &wobble);
            prop_assume!(curve.is_sound());
            let kept = curve.quantised().unwrap();
            prop_assert_eq!(&kept.quantised().unwrap(), &kept);
            let text = curve.to_text().unwrap();
            prop_assert_eq!(&ClosedCurve::from_text(&text).unwrap(), &kept);
            prop_assert_eq!(&kept.to_text().unwrap(), &text);
            let (low, high) = crate::outline::bounds(&curve.knots);
            for (a, b) in curve.knots.iter().zip(&kept.knots) {
                prop_assert!(a.distance(*b) <= 2.0 * FINE * low.distance(high));
            }
        }
    }

    #[test]
    fn words_that_are_no_curve_are_refused() {
        for text in ["", "A", "AQ", "not a word", "____", &"A".repeat(MAX_TEXT + 1)] {
            assert!(ClosedCurve::from_text(text).is_err());
        }
        let text = ring(90, 1.0, &[0.1, -0.4, 0.5]).to_text().unwrap();
        assert!(text.len() < 90 * 9, "{}", text.len());
        for end in [1, text.len() / 2, text.len() - 4] {
            assert!(ClosedCurve::from_text(&text[..end]).is_err(), "{end}");
        }
    }
}
