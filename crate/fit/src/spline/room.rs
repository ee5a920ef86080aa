//! Whether a piece of a curve has room: it meets the rest nowhere.

use glam::DVec2;

use crate::outline::turn;

/// How many pairs of sides of `line`, an open polyline, meet each other or those of `rest`, where they do not follow
/// on each other. `line` ends where `rest` begins and begins where it ends.
pub fn meetings(line: &[DVec2], rest: &[DVec2]) -> usize {
    let mut many = 0;
    let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    for p in line {
        (low, high) = (low.min(*p), high.max(*p));
    }
    for (i, side) in line.windows(2).enumerate() {
        let later = line.windows(2).skip(i + 1);
        many += later
            .enumerate()
            .filter(|(k, other)| if *k == 0 { folds(side, other) } else { meet(side, other) })
            .count();
    }
    let last = rest.len().saturating_sub(2);
    for (j, other) in rest.windows(2).enumerate() {
        let (a, b) = (other[0].min(other[1]), other[0].max(other[1]));
        if a.cmpgt(high).any() || b.cmplt(low).any() {
            continue;
        }
        for (i, side) in line.windows(2).enumerate() {
            let fault = match (i + 2 == line.len() && j == 0, i == 0 && j == last) {
                (true, _) => folds(side, other),
                (_, true) => folds(other, side),
                _ => meet(side, other),
            };
            many += usize::from(fault);
        }
    }
    many
}

/// Whether the second side goes back along the first; sides of no length do.
fn folds(a: &[DVec2], b: &[DVec2]) -> bool {
    let (u, v) = (a[1] - a[0], b[1] - b[0]);
    turn(a[0], a[1], b[1]) == 0 && u.dot(v) <= 0.0
}

/// Whether two sides have a point in common.
fn meet(a: &[DVec2], b: &[DVec2]) -> bool {
    let apart = a[0].max(a[1]).cmplt(b[0].min(b[1])).any() || b[0].max(b[1]).cmplt(a[0].min(a[1])).any();
    !apart
        && turn(a[0], a[1], b[0]) * turn(a[0], a[1], b[1]) <= 0
        && turn(b[0], b[1], a[0]) * turn(b[0], b[1], a[1]) <= 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn many(line: &[[f64; 2]], rest: &[[f64; 2]]) -> usize {
        let points = |list: &[[f64; 2]]| list.iter().copied().map(DVec2::from).collect::<Vec<_>>();
        meetings(&points(line), &points(rest))
    }

    #[test]
    fn what_meets_is_counted_and_what_follows_on_is_not() {
        let rest = [[4.0, 0.0], [4.0, 3.0], [0.0, 3.0], [0.0, 0.0]];
        assert_eq!(many(&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0]], &rest), 0);
        // Through the far side and back, and up to it.
        assert_eq!(many(&[[0.0, 0.0], [2.0, 4.0], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [1.0, 3.0], [2.0, 1.0], [4.0, 0.0]], &rest), 2);
        // Through itself.
        assert_eq!(many(&[[0.0, 0.0], [3.0, 2.0], [3.0, 1.0], [1.0, 2.0], [4.0, 0.0]], &rest), 2);
        // Back along the side before, at its beginning, inside and at its end: what goes on from there leaves it again.
        assert_eq!(many(&[[0.0, 0.0], [0.0, 1.0], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [2.0, 1.0], [2.0, 2.0], [2.0, 1.5], [4.0, 0.0]], &rest), 2);
        assert_eq!(many(&[[0.0, 0.0], [4.0, 1.0], [4.0, 0.0]], &rest), 2);
    }
}
