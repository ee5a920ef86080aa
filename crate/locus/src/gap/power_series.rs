//! Two maps of one linear part: power series with coefficients -1, 0 and 1.
//!
//! The pieces of `M x + s` and `M x + t` are as far apart as 0 is from the values of the series
//! `d + a_1 M d + a_2 M^2 d + ..`, where `d = s - t` and all a_k are -1, 0 or 1: they meet just if one of these
//! vanishes (Barnsley & Harrington 1985; Bousch 1988). A sum of finitely many terms is a value, too.

use frond_core::Affine2;
use glam::DVec2;

/// How far a sum may be from 0 to be gone on with, against the disc that the rest of the series reaches, squared.
const SQUARE_TO_ENTER: f64 = 0.5;
/// How often to go back, and how many steps in all.
const MOST_RETURNS: usize = 12;
const MOST_STEPS: usize = 120;
/// So many of the sums that were passed over last are kept: no fewer than the returns.
const KEPT: usize = 16;
/// Where maps shrink no faster other coordinates may be better.
const LARGEST_NORM: f64 = 0.97;

/// A sum, the next term, and how far, squared, the sum may be from 0 when that is added or left out.
#[derive(Clone, Copy)]
struct Sum {
    at: DVec2,
    term: DVec2,
    limit: f64,
}

/// Whether these are maps that [`nearest`] is for.
pub(crate) fn are_two(maps: &[Affine2]) -> bool {
    let fits = |map: &Affine2| map.translation.abs().max_element() < 1e100;
    matches!(maps, [a, b] if a.linear == b.linear && a.norm() < LARGEST_NORM && fits(a) && fits(b))
}

/// The square of the distance of two points, one in each of the pieces of two maps of one linear part, if it is found
/// to be no more than `epsilon` times the distance of the images of one point, which the attractor has across.
///
/// Always on to where the sum is least, and back to the last that was passed over where that is too far from 0.
pub(crate) fn nearest(maps: &[Affine2], epsilon: f64) -> Option<f64> {
    let [a, b] = maps else { return None };
    let (m, norm, d) = (a.linear, a.norm(), a.translation - b.translation);
    let reach = epsilon * epsilon * d.length_squared();
    // Of the series from the square of M on.
    let rest = d.length_squared() * (norm * norm / (1.0 - norm)).powi(2);
    let mut sum = Sum { at: d, term: m * d, limit: SQUARE_TO_ENTER * rest };
    // A ring.
    let mut passed = [sum; KEPT];
    let (mut end, mut kept, mut back) = (0, 0, 0);
    for _ in 0..MOST_STEPS {
        let Sum { at, term, limit } = sum;
        let square = at.length_squared();
        // All further terms may be left out.
        if square <= reach {
            return Some(square);
        }
        // Of adding the term and taking it away one is worse than leaving it out.
        let along = at.dot(term);
        let (moved, after) = (at - term * along.signum(), square + term.length_squared() - 2.0 * along.abs());
        let ((best, least), (second, more)) =
            if after < square { ((moved, after), (at, square)) } else { ((at, square), (moved, after)) };
        let next = |at: DVec2| Sum { at, term: m * term, limit: limit * (norm * norm) };
        if more < limit {
            passed[end] = next(second);
            (end, kept) = ((end + 1) % KEPT, KEPT.min(kept + 1));
        }
        if least < limit {
            sum = next(best);
        } else {
            back += 1;
            if back > MOST_RETURNS || kept == 0 {
                return None;
            }
            (end, kept) = ((end + KEPT - 1) % KEPT, kept - 1);
            sum = passed[end];
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use glam::DMat2;

    use super::*;

    fn pair(s: DVec2) -> [Affine2; 2] {
        let linear = DMat2::from_cols(s, s.perp());
        [DVec2::X, -DVec2::X].map(|t| Affine2::new(linear, t))
    }

    #[test]
    fn pieces_on_a_line_are_as_near_as_is_said() {
        for k in 0..200 {
            let s = 0.4 + 0.0015 * f64::from(k);
            for sign in [1.0, -1.0] {
                let maps = pair(DVec2::new(sign * s, 0.0));
                assert!(are_two(&maps));
                // Of -s they are those of s.
                let gap = ((1.0 - 2.0 * s) / (1.0 - s)).max(0.0);
                for epsilon in [0.1, 1e-3, 1e-9] {
                    let found = nearest(&maps, epsilon);
                    // Just above one half only sums that reach as far as they can come near 0: those are passed over.
                    assert!(found.is_some() || s < 0.56, "{s} {epsilon}");
                    let (least, most) = (2.0 * gap * (1.0 - 1e-12), 2.0 * epsilon);
                    assert!(found.is_none_or(|square| (least..=most).contains(&square.sqrt())), "{s}");
                }
            }
        }
    }

    #[test]
    fn nothing_is_near_in_the_hole_and_outside() {
        for s in [[0.0227, 0.703], [0.3, 0.4], [0.55, 0.2]] {
            assert_eq!(nearest(&pair(DVec2::from(s)), 1e-6), None);
        }
        assert!(nearest(&pair(DVec2::new(0.2, 0.67)), 1e-6).is_some());
        assert!(!are_two(&pair(DVec2::new(0.98, 0.1))) && !are_two(&pair(DVec2::splat(f64::NAN))));
    }
}
