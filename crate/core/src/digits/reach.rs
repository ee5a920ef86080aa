//! How far a shift may be for two shapes still to reach each other.

use crate::digits::error::DigitError;

/// A bound of all `t` with an endless way `t' = M t - d`, `t'' = M t' - d'`, .. that stays within bounds, where the d
/// are among finitely many differences: in whole numbers, so that no rounding leaves one out.
///
/// The form `P` of Lyapunov's equation `M^T P M = P + 1` makes every vector longer: with `|x|^2 = x . P x`, and `L` an
/// upper bound of the largest eigenvalue of P,
///
/// ```text
/// |M x|^2 = |x|^2 + x . x >= (1 + 1/L) |x|^2
/// ```
///
/// so that what is longer than `max |d| / (sqrt(1 + 1/L) - 1)`, at most `max |d| (2 L + 1/2)`, becomes longer for ever.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// P times its denominator: `[xx, xy, yy]`.
    form: [i128; 3],
    /// The square of the bound in that form, of shifts that are whole.
    most: i128,
}

impl Reach {
    pub fn of(matrix: [i64; 4], differences: &[[i64; 2]]) -> Result<Self, DigitError> {
        let [a, b, c, d] = matrix.map(i128::from);
        let rows =
            [[a * a - 1, 2 * a * c, c * c], [a * b, a * d + b * c - 1, c * d], [b * b, 2 * b * d, d * d - 1]];
        let whole = determinant(rows);
        // Cramer's rule, with 1, 0, 1 in the place of one column after the other.
        let part = |column: usize| {
            let mut rows = rows;
            for (row, value) in rows.iter_mut().zip([1, 0, 1]) {
                row[column] = value;
            }
            determinant(rows) * whole.signum()
        };
        let form = [part(0), part(1), part(2)];
        let shared = form.iter().fold(whole.abs(), |sum, &x| gcd(sum, x.abs()));
        if shared == 0 {
            return Err(DigitError::NotExpanding);
        }
        let (form, whole) = (form.map(|x| x / shared), whole.abs() / shared);
        let largest = (form[0] + form[2]).min(form[0].max(form[2]) + form[1].abs());
        let mut this = Self { form, most: 0 };
        let longest = differences.iter().filter_map(|&d| this.square(d)).max().unwrap_or(0);
        // (2 L + 1/2)^2 = (4 largest + whole)^2 / (4 whole^2).
        let above = longest.checked_mul((4 * largest + whole).pow(2)).ok_or(DigitError::TooLarge)?;
        let below = 4 * whole * whole;
        this.most = above / below + 1;
        Ok(this)
    }

    /// Whether the shift p / q may have an endless way; `false` is certain. What no number holds is not near either.
    pub fn holds(&self, p: [i64; 2], q: i64) -> bool {
        let most = self.most.saturating_mul(i128::from(q) * i128::from(q));
        self.square(p).is_some_and(|square| square <= most)
    }

    fn square(&self, p: [i64; 2]) -> Option<i128> {
        let [x, y] = p.map(i128::from);
        let [xx, xy, yy] = self.form;
        let sum = xx.checked_mul(x * x)?.checked_add(yy.checked_mul(y * y)?)?;
        sum.checked_add(xy.checked_mul(2)?.checked_mul(x * y)?)
    }
}

fn determinant([p, q, r]: [[i128; 3]; 3]) -> i128 {
    p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0])
        + p[2] * (q[0] * r[1] - q[1] * r[0])
}

pub(crate) fn gcd(a: i128, b: i128) -> i128 {
    if b == 0 { a } else { gcd(b, a % b) }
}

#[cfg(test)]
mod tests {
    use frond_testing::cases;
    use proptest::prelude::*;

    use super::*;
    use crate::digits::system::DigitSystem;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(cases(200)))]

        /// Sums of differences after the point are as far as a shift can be: they have an endless way by their making.
        #[test]
        fn no_shift_that_counts_is_left_out(
            matrix in prop::array::uniform4(-6..7_i64),
            differences in prop::collection::vec(prop::array::uniform2(-9..10_i64), 1..5),
            choice in prop::collection::vec(0..5_usize, 60),
        ) {
            prop_assume!(DigitSystem::new(matrix, vec![[0, 0]]).is_ok());
            let reach = Reach::of(matrix, &differences).unwrap();
            let [a, b, c, d] = matrix.map(|x| x as f64);
            let area = a * d - b * c;
            let (mut x, mut y) = (0.0, 0.0);
            for k in choice {
                let [p, q] = differences[k % differences.len()].map(|x| x as f64);
                (x, y) = ((d * (x + p) - b * (y + q)) / area, (a * (y + q) - c * (x + p)) / area);
                let q = 1 << 30;
                let p = [x, y].map(|x| (x * q as f64).round() as i64);
                prop_assert!(reach.holds(p, q), "{x} {y}");
                // And it is a bound.
                prop_assert!(!reach.holds([1 << 40, 0], 1));
            }
        }
    }

    #[test]
    fn the_bound_of_cantors_set_is_near() {
        let reach = Reach::of([3, 0, 0, 3], &[[-2, 0], [0, 0], [2, 0]]).unwrap();
        // By hand: differences of points of the set are at most 1; the bound is 3/2, and the root of 3 as it is
        // rounded.
        assert!(reach.holds([1, 0], 1) && reach.holds([3, 0], 2) && !reach.holds([2, 0], 1));
        assert!(reach.holds([-1000, 0], 1000) && !reach.holds([1733, 0], 1000));
        // Numbers as large as there are.
        assert!(!reach.holds([i64::MAX, i64::MIN], 1));
        assert!(!reach.holds([i64::MIN, i64::MIN], 1_000_000));
    }
}
