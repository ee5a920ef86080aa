//! Where an outline crosses itself.

use glam::DVec2;

use super::Nearest;

/// The most pairs of sides that are looked at.
const MAX_PAIRS: usize = 20_000_000;

/// Pairs of sides of a closed polyline that cross, at most `most` of them, each with the smaller index first.
///
/// None where the polyline is so tangled that the search was given up. Sides that only touch, and neighbours, do not
/// cross.
#[must_use]
pub fn crossings(points: &[DVec2], most: usize) -> Option<Vec<(usize, usize)>> {
    let count = points.len();
    let grid = Nearest::new(points, true);
    let mut found = Vec::new();
    let mut pairs = 0;
    for cell in grid.cells() {
        pairs += cell.len() * cell.len().saturating_sub(1) / 2;
        if pairs > MAX_PAIRS {
            return None;
        }
        for (k, &i) in cell.iter().enumerate() {
            for &j in &cell[k + 1..] {
                let (i, j) = (i.min(j) as usize, i.max(j) as usize);
                if j - i < 2 || j - i == count - 1 {
                    continue;
                }
                let side = |s: usize| [points[s], points[(s + 1) % count]];
                if cross(side(i), side(j)) {
                    found.push((i, j));
                }
            }
        }
        // A pair may share several cells.
        if found.len() >= most.saturating_mul(2).max(64) {
            found.sort_unstable();
            found.dedup();
            if found.len() >= most {
                break;
            }
        }
    }
    found.sort_unstable();
    found.dedup();
    found.truncate(most);
    Some(found)
}

fn cross(a: [DVec2; 2], b: [DVec2; 2]) -> bool {
    let apart = |line: [DVec2; 2], side: [DVec2; 2]| {
        let direction = line[1] - line[0];
        direction.perp_dot(side[0] - line[0]) * direction.perp_dot(side[1] - line[0]) < 0.0
    };
    apart(a, b) && apart(b, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_eight_crosses_itself_once_and_a_square_does_not() {
        let eight = [DVec2::ZERO, DVec2::ONE, DVec2::X, DVec2::Y];
        assert_eq!(crossings(&eight, 10), Some(vec![(0, 2)]));
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        assert_eq!(crossings(&square, 10), Some(vec![]));
    }

    #[test]
    fn a_tangle_is_given_up() {
        let far = |i: usize| DVec2::from_angle(2.5 * i as f64) * (1.0 + (i % 7) as f64);
        let tangle: Vec<_> = (0..20_000).map(far).collect();
        assert_eq!(crossings(&tangle, usize::MAX), None);
    }
}
