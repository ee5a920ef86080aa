//! A closed curve as a word of a link.

use base64::Engine as _;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;

use super::{ClosedCurve, PackError};

/// Parts of the box's diagonal: what a document keeps of a knot. A fit is a hundred times coarser.
const DOCUMENT_STEP: f64 = 1e-5;

/// The longest word that is read, in characters.
pub const MAX_TEXT: usize = 48 * 1024;

/// How many times a grid is halved, or doubled, that a document keeps as it is.
const MOST_HALVINGS: i32 = 12;
const MOST_DOUBLINGS: i32 = 10;

impl ClosedCurve {
    /// The curve as documents keep it: knots to a hundred-thousandth of the box's diagonal, factors to 1/2048. One on a
    /// finer grid of the same kind, up to 4096 times as fine, stays as it is, and so does one on a coarser grid, up to
    /// 1024 times as coarse, which takes fewer bytes.
    ///
    /// Doing it again changes nothing.
    ///
    /// # Errors
    /// As [`to_text`](Self::to_text).
    pub fn quantised(&self) -> Result<Self, PackError> {
        Ok(self.packed()?.0)
    }

    /// The curve on a grid that is coarser than that of documents: doubled so many times, 10 at most.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes); where the grid is so coarse that no curve is left, it is not sound.
    pub(crate) fn coarsened(&self, doublings: i32) -> Result<Self, PackError> {
        let grid = self.grain() * 2.0_f64.powi(doublings.clamp(0, MOST_DOUBLINGS));
        Self::from_bytes(&self.to_bytes(grid)?)
    }

    /// The quantised curve in letters, digits, `-` and `_`: some three characters a knot, four more a copied edge.
    ///
    /// # Errors
    /// As [`to_bytes`](Self::to_bytes), and where there would be more than [`MAX_TEXT`] characters.
    pub fn to_text(&self) -> Result<String, PackError> {
        Ok(URL_SAFE_NO_PAD.encode(self.packed()?.1))
    }

    /// The curve of a word that [`to_text`](Self::to_text) wrote. Of any other word it is quantised: what this gives,
    /// [`to_text`](Self::to_text) writes as a word that gives it again.
    ///
    /// # Errors
    /// Where the word is no curve, or this one or that which it would be written as is longer than [`MAX_TEXT`].
    pub fn from_text(text: &str) -> Result<Self, PackError> {
        if text.len() > MAX_TEXT {
            return Err(PackError::TooLong);
        }
        let bytes = URL_SAFE_NO_PAD.decode(text).map_err(|_| PackError::CutShort)?;
        Self::from_bytes(&bytes)?.quantised()
    }

    /// The quantised curve and its bytes, which are those of just this curve.
    fn packed(&self) -> Result<(Self, Vec<u8>), PackError> {
        self.check()?;
        let mut curve = self.clone();
        // Where rounding takes the box over a power of two the grid is another one; points of the coarser lie on the
        // finer.
        for _ in 0..8 {
            let grain = curve.grain();
            let mut finer = (-MOST_DOUBLINGS..=MOST_HALVINGS).map(|k| grain * 0.5_f64.powi(k));
            let bytes = curve.to_bytes(finer.find(|&fine| curve.lies_on_grid(fine)).unwrap_or(grain))?;
            let again = Self::from_bytes(&bytes)?;
            if again == curve {
                // Four characters are three bytes.
                let long = bytes.len() > MAX_TEXT / 4 * 3;
                return if long { Err(PackError::TooLong) } else { Ok((curve, bytes)) };
            }
            curve = again;
        }
        Err(PackError::Size)
    }

    /// The precision of documents: a power of two, so that it stays the same when the curve has moved a little.
    fn grain(&self) -> f64 {
        let (low, high) = crate::outline::bounds(&self.knots);
        let fine = DOCUMENT_STEP * low.distance(high);
        if fine > 0.0 && fine.is_finite() { fine.log2().floor().exp2() } else { fine }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;
    use proptest::prelude::*;

    use super::*;
    use crate::closed::{ArcCopy, MAX_KNOTS};

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
                prop_assert!(a.distance(*b) <= 2.0 * DOCUMENT_STEP * low.distance(high));
            }
        }
    }

    /// A word of bytes that [`ClosedCurve::to_bytes`] need not have written.
    fn word(numbers: [f64; 3], tail: &[u8]) -> String {
        let head = numbers.into_iter().flat_map(|x| x.to_bits().to_be_bytes());
        URL_SAFE_NO_PAD.encode([1].into_iter().chain(head).chain(tail.iter().copied()).collect::<Vec<u8>>())
    }

    fn any_number() -> impl Strategy<Value = f64> {
        prop_oneof![
            3 => -2.0..2.0_f64,
            1 => Just(0.0),
            1 => Just(-0.0),
            3 => any::<u64>().prop_map(f64::from_bits),
            2 => (-320..308_i32, -1.0..1.0_f64).prop_map(|(power, x)| x * 10_f64.powi(power)),
        ]
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(2000)))]

        #[test]
        fn whatever_word_is_read_is_written_as_one_that_brings_it_back(
            numbers in proptest::array::uniform3(any_number()),
            count in 3..9_usize,
            order in 0..32_u8,
            tail in proptest::collection::vec(any::<u8>(), 0..80),
            wobble in proptest::collection::vec(-0.6..0.6_f64, 1..9),
            halvings in -4..30_i32,
            size in any_number(),
        ) {
            // The count and the order begin the tail: 13 and 5 bits.
            let head = [0, (count << 3) as u8 | order >> 2, order << 6 | tail.first().unwrap_or(&0) & 63];
            let hostile = word(numbers, &[&head, &tail[..]].concat());
            // A curve on grids that Frond does not write, and one of any size.
            let curve = ring(12, 1.0, &wobble);
            let bytes = curve.to_bytes(1e-5 * 0.7_f64.powi(halvings)).unwrap();
            let finer = URL_SAFE_NO_PAD.encode(&bytes);
            let mut large = bytes;
            large[17..25].copy_from_slice(&size.to_bits().to_be_bytes());
            for text in [hostile, finer, URL_SAFE_NO_PAD.encode(large)] {
                let Ok(curve) = ClosedCurve::from_text(&text) else { continue };
                let again = curve.to_text().unwrap();
                prop_assert_eq!(&ClosedCurve::from_text(&again).unwrap(), &curve, "{}", text);
                prop_assert_eq!(curve.to_text().unwrap(), again);
            }
        }

        #[test]
        fn a_finer_grid_is_kept(
            wobble in proptest::collection::vec(-0.6..0.6_f64, 1..9),
            halvings in 0..=MOST_HALVINGS,
        ) {
            let curve = ring(12, 1.37, &wobble);
            prop_assume!(curve.is_sound());
            let fine = curve.grain() * 0.5_f64.powi(halvings);
            let bytes = curve.to_bytes(fine).unwrap();
            let kept = ClosedCurve::from_bytes(&bytes).unwrap();
            prop_assume!(kept.grain() == curve.grain());
            prop_assert_eq!(ClosedCurve::from_text(&URL_SAFE_NO_PAD.encode(&bytes)).unwrap(), kept);
        }
    }

    #[test]
    fn a_coarser_grid_is_kept_and_takes_fewer_letters() {
        let curve = ring(60, 1.37, &[0.1, -0.4, 0.5, 0.23, -0.31]);
        let mut long = curve.to_text().unwrap().len();
        for doublings in 1..=6 {
            let coarse = curve.coarsened(doublings).unwrap();
            let text = coarse.to_text().unwrap();
            assert_eq!(ClosedCurve::from_text(&text).unwrap(), coarse, "{doublings}");
            // Two bits fewer a knot, more or less: 60 of them are 20 letters.
            assert!(text.len() + 10 < long, "{doublings}: {} {long}", text.len());
            long = text.len();
        }
    }

    #[test]
    fn a_grid_of_tiny_steps_is_told_and_does_not_panic() {
        let word = "AT_wAAAAAAAAAAAAA-AAAAAA-9mZmZmZmgAj3ttXttntt3ttXtuHttQA";
        assert_eq!(ClosedCurve::from_text(word), Err(PackError::Size));
        let tiny = ClosedCurve::polygon([1.0, 2.0, -1.0].map(|y| DVec2::new(1.0, y * 1e-299)).to_vec());
        assert_eq!(tiny.to_text(), Err(PackError::Size));
        let far = ClosedCurve::polygon([1.0, 2.0, -1.0].map(|y| DVec2::new(1.0, y * 1e160)).to_vec());
        assert_eq!(far.to_text(), Err(PackError::Size));
        let point = ClosedCurve::polygon(vec![DVec2::ONE; 3]);
        assert_eq!(ClosedCurve::from_text(&point.to_text().unwrap()), Ok(point));
    }

    #[test]
    fn what_would_be_too_long_a_word_is_told() {
        let knot = |i: usize| DVec2::new((i * 7919 % 9973) as f64, (i * 104_729 % 9967) as f64) * 1.37;
        let mut curve = ClosedCurve::polygon((0..MAX_KNOTS).map(knot).collect());
        for index in 0..MAX_KNOTS {
            let copies = (0..MAX_KNOTS).map(|from| Some(ArcCopy { from, span: 2, reversed: false, c: 0.1 }));
            for copy in copies.chain([None]) {
                curve.edges[index] = copy;
                if curve.shrinks_by(index, 0.8) {
                    break;
                }
            }
        }
        assert!(curve.to_text().unwrap().len() < MAX_TEXT);
        // The same on the finest grid that would be kept.
        let bytes = curve.to_bytes(curve.grain() * 0.5_f64.powi(MOST_HALVINGS)).unwrap();
        let fine = ClosedCurve::from_bytes(&bytes).unwrap();
        assert_eq!(fine.to_text(), Err(PackError::TooLong));
        assert_eq!(ClosedCurve::from_text(&URL_SAFE_NO_PAD.encode(bytes)), Err(PackError::TooLong));
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
