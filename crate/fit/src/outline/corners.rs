//! The corners of an outline, without the points along its straight sides.

use glam::DVec2;

use super::near::to_side;
use super::{Nearest, Outline};

/// A point this near to the straight way between its neighbours says nothing, in parts of the diagonal: it is there by
/// rounding.
const IDLE: f64 = 1e-9;

/// The corners of an outline that has `most` at most, in order; none where it has more. They say all that its points
/// say.
pub fn corners(outline: &Outline, most: usize) -> Option<Vec<DVec2>> {
    let points = outline.points();
    let idle = IDLE * outline.diagonal();
    let is_off = |squared: f64| squared > idle * idle;
    // What is farthest from any place is a corner.
    let far = |i: &usize| points[*i].distance_squared(points[0]);
    let start = (0..points.len()).max_by(|i, j| far(i).total_cmp(&far(j)))?;
    let at = |i: usize| points[(start + i) % points.len()];
    let mut found = vec![at(0)];
    for i in 1..points.len() {
        let (before, p, after) = (found[found.len() - 1], at(i), at(i + 1));
        let turns_back = (p - before).dot(after - p) <= 0.0;
        if is_off(p.distance_squared(before)) && (turns_back || is_off(to_side(p, before, after).1)) {
            if found.len() >= most {
                return None;
            }
            found.push(p);
        }
    }
    // Along a bend that is slow enough, each point seems to say nothing.
    let nearest = Nearest::new(&found, true);
    let whole = found.len() >= 3 && !points.iter().any(|&p| is_off(nearest.to(p).squared / 4.0));
    whole.then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: &[DVec2], most: usize) -> Option<usize> {
        corners(&Outline::new(points).unwrap(), most).map(|found| found.len())
    }

    /// A polygon with `each` points a side, turned and put somewhere.
    fn along(corners: &[[f64; 2]], each: u32) -> Vec<DVec2> {
        let place = |p: [f64; 2]| DVec2::from_angle(0.7).rotate(p.into()) * 3.7 + DVec2::new(41.0, -17.3);
        let side = |i: usize| {
            let (a, b) = (place(corners[i]), place(corners[(i + 1) % corners.len()]));
            (0..each).map(move |k| a.lerp(b, f64::from(k) / f64::from(each)))
        };
        (0..corners.len()).flat_map(side).collect()
    }

    #[test]
    fn points_along_sides_are_left_out_whatever_the_angle() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        for each in [1, 2, 25, 25_000] {
            assert_eq!(of(&along(&square, each), 4), Some(4), "{each}");
            assert_eq!(of(&along(&square, each), 3), None, "{each}");
        }
        // The first point is no corner.
        let mut turned = along(&square, 10);
        turned.rotate_left(3);
        assert_eq!(of(&turned, 6), Some(4));
    }

    #[test]
    fn spikes_and_slow_bends_stay() {
        // Out along a line and back, and a point that lies there twice.
        assert_eq!(of(&along(&[[0.0, 0.0], [3.0, 0.0], [1.0, 0.0], [1.0, 1.0]], 1), 4), Some(4));
        assert_eq!(
            of(&along(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1e-12], [1.0, 2.0]], 1), 9),
            Some(3)
        );
        let turn = |i: u32| std::f64::consts::TAU * f64::from(i) / 1e6;
        let circle: Vec<DVec2> = (0..1_000_000).map(|i| DVec2::from_angle(turn(i))).collect();
        assert_eq!(of(&circle, 1000), None);
    }
}
