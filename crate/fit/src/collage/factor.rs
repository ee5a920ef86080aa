//! The matrix of least squares whose norm is bounded.
//!
//! C is to make the sum of |y - C x|² as small as it can be while no vector becomes longer than `bound` times what it
//! was. With S the sum of x x^T and G that of y x^T the sum is tr(C S C^T) - 2 tr(G C^T) and something that does not
//! hang on C: convex in C, as is the set of all C within the bound. So there is one minimum, and with Λ, symmetric and
//! nowhere negative, as the multiplier of bound² - C^T C it is where C (S + Λ) = G. The rank of Λ says how many
//! singular values are at the bound: none, one or both.

use glam::{DMat2, DVec2};

use crate::fractal::piece::spectral_norm;

/// How thin points may lie along a line, squared, before they are taken to be on it.
const LEAST_THICKNESS: f64 = 1e-24;

/// Where maxima are looked for: more closely near the thin axis of the points, where they may be sharp.
const CELLS: u32 = 32;
const GRADING: i32 = 8;

/// The C of least squares with a spectral norm of `bound` at most, for pairs of x and y. Of many the least: what no x
/// tells of is 0.
pub(super) fn bounded(pairs: impl Iterator<Item = (DVec2, DVec2)> + Clone, bound: f64) -> DMat2 {
    let square = pairs.clone().fold(DMat2::ZERO, |sum, (x, _)| sum + outer(x, x));
    let size = square.x_axis.x + square.y_axis.y;
    if !(size > 0.0 && size.is_finite()) {
        return DMat2::ZERO;
    }
    // The points' own axes, the long one first. Along them sums are taken anew: what is thin would drown in rounding.
    let first = DVec2::from_angle(0.5 * f64::atan2(2.0 * square.y_axis.x, square.x_axis.x - square.y_axis.y));
    let second = first.perp();
    let mut sums = Sums { square: DVec2::ZERO, cross: DMat2::ZERO };
    for (x, y) in pairs {
        let x = DVec2::new(first.dot(x), second.dot(x));
        sums.square += x * x / size;
        sums.cross += outer(y, x / size);
    }
    let Sums { square, cross } = sums;
    if square.y <= LEAST_THICKNESS {
        return outer((cross.x_axis / square.x).clamp_length_max(bound), first);
    }
    let c = sums.bounded(bound);
    outer(c.x_axis, first) + outer(c.y_axis, second)
}

/// The matrix with its singular values cut to a bound: the nearest of all within it.
pub(super) fn clipped(m: DMat2, bound: f64) -> DMat2 {
    let (turn, mirror) = parts(m);
    let (p, q) = (turn.length(), mirror.length());
    let (sum, rest) = ((p + q).min(bound), (p - q).clamp(-bound, bound));
    let turn = turn.normalize_or_zero() * f64::midpoint(sum, rest);
    let mirror = mirror.normalize_or_zero() * f64::midpoint(sum, -rest);
    whole(turn, mirror)
}

/// A turn with a stretch p, plus a mirror with a stretch q; the singular values are p + q and |p - q|.
fn parts(m: DMat2) -> (DVec2, DVec2) {
    let (x, y) = (m.x_axis, m.y_axis);
    (DVec2::new(x.x + y.y, x.y - y.x) / 2.0, DVec2::new(x.x - y.y, x.y + y.x) / 2.0)
}

fn whole(turn: DVec2, mirror: DVec2) -> DMat2 {
    DMat2::from_cols(
        DVec2::new(turn.x + mirror.x, turn.y + mirror.y),
        DVec2::new(mirror.y - turn.y, turn.x - mirror.x),
    )
}

/// a b^T.
fn outer(a: DVec2, b: DVec2) -> DMat2 {
    DMat2::from_cols(a * b.x, a * b.y)
}

/// S, which is diagonal here, and G.
struct Sums {
    square: DVec2,
    cross: DMat2,
}

impl Sums {
    fn bounded(&self, bound: f64) -> DMat2 {
        let free = DMat2::from_cols(self.cross.x_axis / self.square.x, self.cross.y_axis / self.square.y);
        if spectral_norm(free) <= bound {
            return free;
        }
        self.both_at(bound).unwrap_or_else(|| self.one_at(bound, free))
    }

    /// What is to be made small, less what does not hang on C.
    fn cost(&self, c: DMat2) -> f64 {
        let one = |c: DVec2, square: f64, cross: DVec2| c.dot(c * square - 2.0 * cross);
        one(c.x_axis, self.square.x, self.cross.x_axis) + one(c.y_axis, self.square.y, self.cross.y_axis)
    }

    /// Both singular values at the bound: a turn or a mirror, that nearest to G, if Λ = C^T G / bound² - S is one.
    fn both_at(&self, bound: f64) -> Option<DMat2> {
        let (turn, mirror) = parts(self.cross);
        let (turn, mirror) = if turn.length_squared() >= mirror.length_squared() {
            (turn.normalize_or_zero(), DVec2::ZERO)
        } else {
            (DVec2::ZERO, mirror.normalize_or_zero())
        };
        let c = whole(turn, mirror);
        let multiplier = c.transpose() * self.cross * bound.recip() - DMat2::from_diagonal(self.square);
        let trace = multiplier.x_axis.x + multiplier.y_axis.y;
        (trace >= 0.0 && multiplier.determinant() >= 0.0).then(|| c * bound)
    }

    /// One at the bound: C takes a unit vector v to a vector of length `bound`.
    ///
    /// For any v the least rise of the cost at which |C v| is no more than `bound` is (|C0 v| - bound)² / (v^T S^-1 v),
    /// with the free C0 = G S^-1. None rises more than C itself, and its own v just as much: v is where that is
    /// greatest. With v along S^1/2 t and a unit t = (sin θ, cos θ) its root is |N t| - bound |S^1/2 t|, N = G S^-1/2.
    /// The first term falls on both sides of N's longest axis, the second grows towards θ = 0, and between the two the
    /// greatest is.
    fn one_at(&self, bound: f64, free: DMat2) -> DMat2 {
        let root = DVec2::new(self.square.x.sqrt(), self.square.y.sqrt());
        let (a, b) = (self.cross.x_axis / root.x, self.cross.y_axis / root.y);
        // With the first axis, or its opposite, N's longest axis is at a θ between 0 and a quarter turn.
        let side = if a.dot(b) < 0.0 { -1.0 } else { 1.0 };
        let gain = |s: f64, c: f64| (a * (side * s) + b * c, root * DVec2::new(side * s, c));
        let slope = |angle: f64| {
            let (s, c) = angle.sin_cos();
            let ((n, h), (dn, dh)) = (gain(s, c), gain(c, -s));
            n.normalize_or_zero().dot(dn) - bound * h.normalize_or_zero().dot(dh)
        };
        let most = 0.5 * f64::atan2(2.0 * side * a.dot(b), b.length_squared() - a.length_squared());
        // At its ends the slope is known to be upwards and downwards, or level.
        let mark = |cell: u32| most * (f64::from(cell) / f64::from(CELLS)).powi(GRADING);
        let rises: Vec<bool> =
            (0..=CELLS).map(|cell| cell == 0 || cell < CELLS && slope(mark(cell)) > 0.0).collect();
        let mut best = clipped(free, bound);
        for cell in 0..CELLS {
            if !rises[cell as usize] || rises[cell as usize + 1] {
                continue;
            }
            let (mut low, mut high) = (mark(cell), mark(cell + 1));
            for _ in 0..60 {
                let middle = f64::midpoint(low, high);
                *(if slope(middle) > 0.0 { &mut low } else { &mut high }) = middle;
            }
            let (s, c) = f64::midpoint(low, high).sin_cos();
            let (n, h) = gain(s, c);
            let (u, v) = (n.normalize_or_zero(), h.normalize_or_zero());
            // The other singular value, whose vectors stand upright on these.
            let other = u.perp().dot(self.cross * v.perp()) / v.perp().dot(self.square * v.perp());
            let found = outer(u * bound, v) + outer(u.perp() * other.clamp(-bound, bound), v.perp());
            if self.cost(found) < self.cost(best) {
                best = found;
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// S and G of pairs of points.
    fn sums(pairs: &[(DVec2, DVec2)]) -> (DMat2, DMat2) {
        pairs.iter().fold((DMat2::ZERO, DMat2::ZERO), |(square, cross), &(x, y)| {
            (square + outer(x, x), cross + outer(y, x))
        })
    }

    fn squares(pairs: &[(DVec2, DVec2)], c: DMat2) -> f64 {
        pairs.iter().map(|&(x, y)| y.distance_squared(c * x)).sum()
    }

    /// Pairs of points in general, and such as lie near a line, are nearly copies, or very large beside each other.
    fn any_pairs() -> impl Strategy<Value = Vec<(DVec2, DVec2)>> {
        let unit = || (-1.0..1.0_f64, -1.0..1.0_f64).prop_map(DVec2::from);
        let matrix = (unit(), unit()).prop_map(|(x, y)| DMat2::from_cols(x, y) * 2.0);
        let flat = prop_oneof![4 => Just(1.0), 2 => 1e-3..1.0_f64, 1 => 1e-9..1e-3_f64, 1 => Just(0.0)];
        let noise = prop_oneof![Just(1.0), Just(0.1), Just(1e-6), Just(0.0)];
        let scale = prop_oneof![4 => Just(0), 1 => -40..40_i32];
        let list = proptest::collection::vec((unit(), unit()), 2..10);
        (list, matrix, flat.clone(), flat, noise, -4.0..4.0_f64, scale).prop_map(
            |(list, matrix, thin, low, noise, turn, scale)| {
                let (turn, size) = (DMat2::from_angle(turn), 10_f64.powi(scale));
                let pair = |(x, y): (DVec2, DVec2)| {
                    let x = turn * DVec2::new(x.x, thin * x.y);
                    (x, (matrix * x + y * DVec2::new(noise, noise * low)) * size)
                };
                list.into_iter().map(pair).collect()
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(2000)))]

        #[test]
        fn nothing_within_the_bound_is_nearer(
            pairs in any_pairs(),
            bound in 0.02..0.99_f64,
            others in proptest::collection::vec((proptest::array::uniform4(-1.0..1.0_f64), -12..=0_i32), 20),
        ) {
            let (square, cross) = sums(&pairs);
            let c = bounded(pairs.iter().copied(), bound);
            prop_assert!(spectral_norm(c) <= bound * (1.0 + 1e-12), "{c}");
            let least = squares(&pairs, c);
            let size: f64 = pairs.iter().map(|(x, y)| x.length_squared() + y.length_squared()).sum();
            let round = 1e-13 * size;
            // What was done before: the free optimum, cut.
            let free = bounded(pairs.iter().copied(), f64::INFINITY);
            prop_assert!(least <= squares(&pairs, clipped(free, bound)) + round);
            prop_assert!(squares(&pairs, free) <= least + round);
            for (numbers, small) in others {
                let near = DMat2::from_cols_array(&numbers) * 10_f64.powi(small);
                for other in [near, c + near] {
                    let other = clipped(other, bound);
                    prop_assert!(squares(&pairs, other) >= least - round, "{other} is nearer than {c}");
                }
            }
            // Karush, Kuhn and Tucker: no way within the bound leads down. The most that any D there can do along the
            // steepest way R = G - C S is bound times the sum of R's singular values, and C does that.
            let down = cross - c * square;
            let (turn, mirror) = parts(down);
            let most = bound * 2.0 * turn.length().max(mirror.length());
            let own = down.x_axis.dot(c.x_axis) + down.y_axis.dot(c.y_axis);
            prop_assert!(most - own <= 1e-10 * size, "{most} {own}");
        }
    }

    #[test]
    fn a_bound_on_both_axes_gives_a_turn_and_on_one_axis_does_not_touch_the_other() {
        let close = |a: DMat2, b: DMat2| assert!(spectral_norm(a - b) < 1e-12, "{a} {b}");
        let points = [DVec2::X, -DVec2::X, DVec2::Y * 0.5, DVec2::Y * -0.5];
        let under = |image: DMat2, bound| bounded(points.into_iter().map(|x| (x, image * x)), bound);
        // S is diag(2, 1/2), and G the turned stretch: its own turn is taken, not that of the free optimum.
        let turn = DMat2::from_angle(0.7);
        let stretch = DMat2::from_cols(DVec2::new(2.0, 0.5), DVec2::new(0.5, 1.0));
        let free = turn * stretch * DMat2::from_diagonal(DVec2::new(0.5, 2.0));
        close(under(free, f64::INFINITY), free);
        close(under(free, 0.5), turn * 0.5);
        assert!(spectral_norm(clipped(free, 0.5) - turn * 0.5) > 0.05);
        let apart = DMat2::from_diagonal(DVec2::new(0.2, -3.0));
        close(under(apart, 0.9), DMat2::from_diagonal(DVec2::new(0.2, -0.9)));
        let small = DMat2::from_diagonal(DVec2::new(0.05, 0.2));
        close(under(small, 0.9), small);
        assert_eq!(bounded([].into_iter(), 0.9), DMat2::ZERO);
        // Points on a line upwards, taken to the side: the matrix of a separable map could not.
        let line = [(DVec2::Y, DVec2::X * 0.3), (-DVec2::Y, DVec2::X * -0.3)];
        assert!(squares(&line, bounded(line.into_iter(), 0.9)) < 1e-30);
    }
}
