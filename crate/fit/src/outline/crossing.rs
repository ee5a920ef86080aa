//! Where an outline crosses or touches itself.

use glam::DVec2;

use super::Nearest;

/// The most pairs of sides that are looked at.
const MAX_PAIRS: usize = 20_000_000;

/// How far rounding may take a determinant, in parts of its two products (Shewchuk, "Adaptive precision floating-point
/// arithmetic", 1997: 3 + 16 e times e, a little more).
const ROUNDING: f64 = 3.4e-16;

/// Pairs of sides of a closed polyline that cross, at most `most` of them, each with the smaller index first.
///
/// None where the polyline is so tangled that the search was given up. Sides that only touch, and neighbours, do not
/// cross.
#[must_use]
pub fn crossings(points: &[DVec2], most: usize) -> Option<Vec<(usize, usize)>> {
    let count = points.len();
    pairs(points, most, |i, j| j - i >= 2 && j - i != count - 1 && cross(side(points, i), side(points, j)))
}

/// Pairs of sides of a closed polyline that have a point in common, neighbours where one folds back on the other: at
/// most `most` of them, each with the smaller index first. None where the polyline is so tangled that the search was
/// given up.
///
/// Where rounding leaves it open whether sides meet, they do: with no pair the polyline does not cross itself for sure.
#[must_use]
pub fn contacts(points: &[DVec2], most: usize) -> Option<Vec<(usize, usize)>> {
    // Sides of no length say nothing, and neighbours are those without them.
    let mut sides: Vec<usize> = Vec::with_capacity(points.len());
    let mut corners: Vec<DVec2> = Vec::with_capacity(points.len());
    for i in 0..points.len() {
        let [a, b] = side(points, i);
        if a != b {
            sides.push(i);
            corners.push(a);
        }
    }
    let count = corners.len();
    let meet = |i: usize, j: usize| {
        let (a, b) = (side(&corners, i), side(&corners, j));
        if j - i == 1 {
            folds(a[0], a[1], b[1])
        } else if j - i == count - 1 {
            folds(b[0], b[1], a[1])
        } else {
            meet(a, b)
        }
    };
    if count < 3 {
        return Some(Vec::new());
    }
    let found = pairs(&corners, most, meet)?;
    Some(found.into_iter().map(|(i, j)| (sides[i], sides[j])).collect())
}

/// The sides of a closed polyline.
fn side(points: &[DVec2], i: usize) -> [DVec2; 2] {
    [points[i], points[if i + 1 == points.len() { 0 } else { i + 1 }]]
}

/// Pairs of sides, among those whose boxes have a point in common, of which `is_one` says so.
fn pairs(
    points: &[DVec2],
    most: usize,
    is_one: impl Fn(usize, usize) -> bool,
) -> Option<Vec<(usize, usize)>> {
    let grid = Nearest::new(points, true);
    let mut found = Vec::new();
    let mut boxes = Vec::new();
    let mut pairs = 0;
    for cell in grid.cells() {
        pairs += cell.len() * cell.len().saturating_sub(1) / 2;
        if pairs > MAX_PAIRS {
            return None;
        }
        if cell.len() > 1 {
            // Side by side in memory, and most pairs are beside each other.
            boxes.clear();
            boxes.extend(cell.iter().map(|&i| {
                let [a, b] = side(points, i as usize);
                (a.min(b), a.max(b))
            }));
        }
        for (k, &i) in cell.iter().enumerate() {
            for (l, &j) in cell.iter().enumerate().skip(k + 1) {
                if beside(boxes[k], boxes[l]) {
                    continue;
                }
                let (i, j) = (i.min(j) as usize, i.max(j) as usize);
                if is_one(i, j) {
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

/// On which side of the line from a to b the point c is: 1, -1, or 0 where rounding leaves it open.
pub(crate) fn turn(a: DVec2, b: DVec2, c: DVec2) -> i8 {
    let (left, right) = ((a.x - c.x) * (b.y - c.y), (a.y - c.y) * (b.x - c.x));
    let determinant = left - right;
    // What is too small for products, or not a number, is open as well.
    let open = ROUNDING * (left.abs() + right.abs()) + f64::MIN_POSITIVE;
    if determinant > open {
        1
    } else if determinant < -open {
        -1
    } else {
        0
    }
}

/// Whether a box lies beside another.
fn beside(a: (DVec2, DVec2), b: (DVec2, DVec2)) -> bool {
    b.1.x < a.0.x || b.1.y < a.0.y || a.1.x < b.0.x || a.1.y < b.0.y
}

/// Whether two sides whose boxes have a point in common have one as well, or may have one.
fn meet(a: [DVec2; 2], b: [DVec2; 2]) -> bool {
    let parts = |line: [DVec2; 2], side: [DVec2; 2]| {
        turn(line[0], line[1], side[0]) * turn(line[0], line[1], side[1]) == 1
    };
    !parts(a, b) && !parts(b, a)
}

/// Whether the side from b to c runs back along that from a to b.
fn folds(a: DVec2, b: DVec2, c: DVec2) -> bool {
    turn(a, b, c) == 0 && (a - b).dot(c - b) > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_eight_crosses_itself_once_and_a_square_does_not() {
        let eight = [DVec2::ZERO, DVec2::ONE, DVec2::X, DVec2::Y];
        assert_eq!(crossings(&eight, 10), Some(vec![(0, 2)]));
        assert_eq!(contacts(&eight, 10), Some(vec![(0, 2)]));
        let square = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        assert_eq!(crossings(&square, 10), Some(vec![]));
        assert_eq!(contacts(&square, 10), Some(vec![]));
    }

    #[test]
    fn a_tangle_is_given_up() {
        let far = |i: usize| DVec2::from_angle(2.5 * i as f64) * (1.0 + (i % 7) as f64);
        let tangle: Vec<_> = (0..20_000).map(far).collect();
        assert_eq!(crossings(&tangle, usize::MAX), None);
    }

    #[test]
    fn sides_that_touch_fold_or_pass_through_a_corner_are_in_contact() {
        let of = |points: &[[f64; 2]]| {
            let points: Vec<_> = points.iter().map(|&p| DVec2::from_array(p)).collect();
            (crossings(&points, 10).unwrap().len(), contacts(&points, 10).unwrap())
        };
        // A corner on a side: no crossing by signs alone.
        let (crossed, touched) = of(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 0.0], [0.0, 4.0]]);
        assert_eq!((crossed, touched.is_empty()), (0, false));
        // A spike of no width.
        assert_eq!(of(&[[0.0, 0.0], [2.0, 0.0], [1.0, 0.0], [1.0, 1.0]]).1[0], (0, 1));
        // Corners that are given twice, and a corner on a straight line, are no contacts.
        assert_eq!(of(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [2.0, 0.0], [1.0, 1.0]]).1, []);
        assert_eq!(of(&[[0.0, 0.0], [1.0, 0.0]]).1, []);
        // Sides on one line, apart from each other.
        assert_eq!(of(&[[0.0, 0.0], [1.0, 1.0], [1.5, 0.0], [2.0, 2.0], [3.0, 3.0], [3.0, -1.0]]).1, []);
    }
}
