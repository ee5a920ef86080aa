//! Digit systems.

use glam::{DMat2, DVec2};

use crate::digits::error::{DigitError, LARGEST_DIGIT, LARGEST_ENTRY};
use crate::directed::error::DirectedError;
use crate::directed::map::DirectedMap;
use crate::directed::system::DirectedIfs;
use crate::error::MAX_MAPS;
use crate::linear::affine::Affine2;

/// A shape on a grid: a matrix `M` of whole numbers that stretches every direction, and 1 to 64 digits, points with
/// whole coordinates.
///
/// Its shape is all that can be written with these digits after the point, in the base `M`:
///
/// ```text
/// A = { M^-1 d1 + M^-2 d2 + M^-3 d3 + .. },   or   A = union of M^-1 (A + d)
/// ```
///
/// (integral self-affine sets: Lagarias & Wang 1996). With `M = 3` and the digits 0 and 2 it is Cantor's set, with
/// `M = 1 + i` and the digits 0 and 1 the twin dragon.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DigitSystem {
    matrix: [i64; 4],
    digits: Vec<[i64; 2]>,
}

impl DigitSystem {
    /// The system of a matrix, `[a, b, c, d]` as rows `(a b)` and `(c d)`, and digits `[x, y]`.
    ///
    /// # Errors
    /// [`DigitError`] where numbers are too large, the matrix does not stretch every direction, or digits are none, too
    /// many or repeated.
    pub fn new(matrix: [i64; 4], digits: Vec<[i64; 2]>) -> Result<Self, DigitError> {
        if digits.is_empty() {
            return Err(DigitError::NoDigits);
        }
        if digits.len() > MAX_MAPS {
            return Err(DigitError::TooManyDigits { count: digits.len() });
        }
        let within = |x: &i64, most: i64| (-most..=most).contains(x);
        if !matrix.iter().all(|x| within(x, LARGEST_ENTRY))
            || !digits.iter().flatten().all(|x| within(x, LARGEST_DIGIT))
        {
            return Err(DigitError::TooLarge);
        }
        let repeated =
            |(digit, value)| digits[..digit].iter().position(|old| old == value).map(|old| (digit, old));
        if let Some((digit, before)) = digits.iter().enumerate().find_map(repeated) {
            return Err(DigitError::Repeated { digit, before });
        }
        let [a, b, c, d] = matrix;
        let (trace, area) = (a + d, a * d - b * c);
        // Both roots of x^2 - trace x + area lie outside the unit circle (Jury's test of the reversed polynomial).
        if area.abs() < 2 || trace.abs() >= area.abs() + area.signum() {
            return Err(DigitError::NotExpanding);
        }
        Ok(Self { matrix, digits })
    }

    /// The matrix, as rows `(a b)` and `(c d)`.
    #[must_use]
    pub fn matrix(&self) -> [i64; 4] {
        self.matrix
    }

    /// The digits.
    #[must_use]
    pub fn digits(&self) -> &[[i64; 2]] {
        &self.digits
    }

    /// The map of a digit, `x -> M^-1 (x + d)`. A digit that is not there counts as 0.
    #[must_use]
    pub fn map(&self, digit: usize) -> Affine2 {
        let [a, b, c, d] = self.matrix.map(|x| x as f64);
        let area = a * d - b * c;
        let [x, y] = self.digits.get(digit).copied().unwrap_or_default().map(|x| x as f64);
        let linear = DMat2::from_cols(DVec2::new(d, -c), DVec2::new(-b, a)) * (1.0 / area);
        Affine2::new(linear, DVec2::new((d * x - b * y) / area, (a * y - c * x) / area))
    }

    /// The shape, moved by `shift`, as a graph-directed system of one state.
    ///
    /// # Errors
    /// [`DirectedError`] where the shift is no number.
    pub fn shape(&self, shift: DVec2) -> Result<DirectedIfs, DirectedError> {
        let moved = |map: Affine2| Affine2::new(map.linear, map.translation + shift - map.linear * shift);
        let maps = (0..self.digits.len()).map(|digit| DirectedMap { from: 0, map: moved(self.map(digit)) });
        DirectedIfs::new(vec![maps.collect()])
    }

    /// Whether no two digits leave the same remainder: none of their differences is `M` times a point of the grid. Then
    /// the digits are among those of a tile, whose copies do not overlap (Bandt 1991), and neither do the pieces
    /// of this shape: the open set condition.
    #[must_use]
    pub fn keeps_apart(&self) -> bool {
        let [a, b, c, d] = self.matrix;
        let area = a * d - b * c;
        let same = |p: &[i64; 2], q: &[i64; 2]| {
            let [x, y] = [p[0] - q[0], p[1] - q[1]];
            (d * x - b * y) % area == 0 && (a * y - c * x) % area == 0
        };
        self.digits.iter().enumerate().all(|(k, digit)| !self.digits[..k].iter().any(|old| same(digit, old)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn code(matrix: [i64; 4], digits: &[[i64; 2]]) -> &'static str {
        DigitSystem::new(matrix, digits.to_vec()).map_or_else(|error| error.code(), |_| "fine")
    }

    #[test]
    fn what_is_no_system_is_refused_with_a_word() {
        let one = [[0, 0]];
        assert_eq!(code([3, 0, 0, 3], &[]), "digits-none");
        assert_eq!(code([3, 0, 0, 3], &[[0, 0]; 65]), "digits-too-many");
        assert_eq!(code([3, 0, 0, 3], &[[0, 0], [1, 0], [0, 0]]), "digits-repeated");
        assert_eq!(code([3, 0, 0, 3], &[[0, i64::MIN]]), "digits-too-large");
        assert_eq!(code([i64::MAX, 0, 0, 3], &one), "digits-too-large");
        // Eigenvalues 1 and 3, 2 and 0, 3 and -1, 1/2-like pairs of area 1, and a turn alone.
        for matrix in [[1, 0, 0, 3], [2, 0, 0, 0], [0, 3, 1, 2], [2, 1, 1, 1], [0, -1, 1, 0], [1, 1, 0, -5]] {
            assert_eq!(code(matrix, &one), "digits-not-expanding", "{matrix:?}");
        }
        // The twin dragon, a reflection, a shear, eigenvalues 2 and -2, and the smallest that there is.
        for matrix in [[1, -1, 1, 1], [2, 0, 0, -3], [2, 5, 0, 2], [0, 4, 1, 0], [0, -2, 1, 1]] {
            assert_eq!(code(matrix, &one), "fine", "{matrix:?}");
        }
    }

    #[test]
    fn a_map_puts_the_shape_where_its_digit_says() {
        let system = DigitSystem::new([2, -1, 1, 2], vec![[3, 4], [-1, 0]]).unwrap();
        // M (x, y) = (0.5, 1) + (3, 4).
        let p = system.map(0).apply(DVec2::new(0.5, 1.0));
        assert!((2.0 * p.x - p.y - 3.5).abs() < 1e-14 && (p.x + 2.0 * p.y - 5.0).abs() < 1e-14);
        let shift = DVec2::new(0.25, -2.0);
        let moved = system.shape(shift).unwrap();
        let fixed = system.map(1).fixed_point().unwrap();
        assert!(moved.states()[0][1].map.apply(fixed + shift).distance(fixed + shift) < 1e-14);
        assert!(system.shape(DVec2::NAN).is_err());
    }

    #[test]
    fn remainders_tell_whether_pieces_keep_apart() {
        let of =
            |matrix, digits: &[[i64; 2]]| DigitSystem::new(matrix, digits.to_vec()).unwrap().keeps_apart();
        assert!(of([3, 0, 0, 3], &[[0, 0], [2, 0], [1, 1]]));
        assert!(!of([3, 0, 0, 3], &[[0, 0], [1, 0], [3, 0]]));
        assert!(of([1, -1, 1, 1], &[[0, 0], [1, 0]]));
        assert!(!of([1, -1, 1, 1], &[[0, 0], [1, 1]]));
    }
}
