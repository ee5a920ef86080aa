//! A path on which pieces stay joined end to end, proved without looking at any moment of it.
//!
//! If both ends of a linear morph are zippers with the same ends `s`, `e` and signature, every moment of the straight
//! way is one, and its attractor is connected (`frond_core`, `morph/zipper`). Numbers are rounded, so that joints are
//! joined to within some 1e-16 only. What that leaves is bounded here.
//!
//! Let all maps at both ends have norm at most `L < 1`; norms are convex, so they do at every moment. Let `d` bound
//! how far `s` and `e` are from the image of one of them under the first and the last map: that, too, is convex in
//! the maps. With `D` the larger of the distances of `s` and `e` to the attractor `A`, `D <= d + L D`, as a map that
//! takes `x` to within `d` of `s` takes the point of `A` nearest to `x` to within `d + L D`. So `D <= d / (1 - L)`.
//! Pieces that meet in a joint to within `j` are then no further apart than `j + 2 L D`, and the diameter of `A` is
//! at least `|s - e| - 2 D`.

use frond_core::{Affine2, Joints, Mode, Morph, joints};
use glam::{DVec2, DVec3};

/// A bound of the widest gap, relative to the diameter of the attractor, everywhere on a path, and how many joints it
/// rests on; `None` where the path is not the straight way of a linear morph between two zippers.
pub(crate) fn joint_bound(morph: &Morph, points: &[DVec3]) -> Option<(f64, usize)> {
    let straight = |at: &DVec3| at.x == at.y && (0.0..=1.0).contains(&at.x);
    if morph.mode() != Mode::Linear || points.is_empty() || !points.iter().all(straight) {
        return None;
    }
    let lists = [morph.at(0.0, 0.0), morph.at(1.0, 1.0)];
    let Joints { ends: [s, e], reversed } = joints(&lists[0], &lists[1])?;
    let count = reversed.len();
    let side = |k: usize, end: bool| if reversed[k] == end { s } else { e };
    let (mut norm, mut closing, mut joint) = (0.0_f64, 0.0_f64, 0.0_f64);
    for maps in &lists {
        for (k, map) in maps.iter().enumerate() {
            norm = norm.max(map.norm() * (1.0 + 8.0 * f64::EPSILON));
            if k + 1 < count {
                joint = joint.max(apart(*map, side(k, true), maps[k + 1], side(k + 1, false)));
            }
        }
        closing = closing.max(apart(maps[0], side(0, false), Affine2::IDENTITY, s));
        closing = closing.max(apart(maps[count - 1], side(count - 1, true), Affine2::IDENTITY, e));
    }
    let room = 1.0 - norm;
    if room.is_nan() || room <= f64::EPSILON {
        return None;
    }
    let off = closing / room * UP;
    let gap = (joint + 2.0 * norm * off) * UP;
    let diameter = s.distance(e) / UP - 2.0 * off;
    (diameter > 0.0 && gap.is_finite()).then(|| (gap / diameter * UP, count - 1))
}

/// More than what a few operations are off by.
const UP: f64 = 1.0 + 32.0 * f64::EPSILON;

/// An upper bound of the distance of `f(p)` and `g(q)`, in exact numbers.
fn apart(f: Affine2, p: DVec2, g: Affine2, q: DVec2) -> f64 {
    // Three products and two sums each: less than four units of what they are made of.
    let made = |map: Affine2, at: DVec2| {
        let [a, b, c, d, x, y] = map.to_row().map(f64::abs);
        let (u, v) = (at.x.abs(), at.y.abs());
        DVec2::new(a * u + b * v + x, c * u + d * v + y)
    };
    let rounding = 4.0 * f64::EPSILON * (made(f, p) + made(g, q)).length();
    (f.apply(p).distance(g.apply(q)) + rounding) * UP
}

#[cfg(test)]
mod tests {
    use frond_core::Ifs;
    use frond_core::{MorphOptions, RouteKind, ways};

    use super::*;

    fn ifs(rows: &[[f64; 6]]) -> Ifs {
        Ifs::new(rows.iter().map(|&row| Affine2::from_row(row)).collect()).unwrap()
    }

    /// From Koch's curve to Heighway's dragon, joint by joint.
    fn joined() -> [Vec<Affine2>; 2] {
        let (third, h) = (1.0 / 3.0, 0.75_f64.sqrt() / 3.0);
        let koch = ifs(&[
            [third, 0.0, 0.0, third, 0.0, 0.0],
            [0.5 * third, -h, h, 0.5 * third, third, 0.0],
            [0.5 * third, h, -h, 0.5 * third, 0.5, h],
            [third, 0.0, 0.0, third, 2.0 * third, 0.0],
        ]);
        let dragon = ifs(&[[0.5, -0.5, 0.5, 0.5, 0.0, 0.0], [-0.5, -0.5, 0.5, -0.5, 1.0, 0.0]]);
        let way = ways(&koch, &dragon, 1).remove(0);
        assert_eq!((way.kind, way.mode), (RouteKind::Joints, Some(Mode::Linear)));
        [way.from, way.to]
    }

    fn bound(ends: &[Vec<Affine2>; 2], mode: Mode, points: &[DVec3]) -> Option<(f64, usize)> {
        let options = MorphOptions { mode, ..MorphOptions::default() };
        joint_bound(&Morph::new(&ends[0], &ends[1], &options).unwrap(), points)
    }

    const STRAIGHT: [DVec3; 2] = [DVec3::ZERO, DVec3::new(1.0, 1.0, 0.0)];

    #[test]
    fn joints_that_stay_joined_leave_no_gap_but_rounding() {
        let ends = joined();
        let (gap, count) = bound(&ends, Mode::Linear, &STRAIGHT).unwrap();
        assert!(gap > 0.0 && gap < 1e-13, "{gap}");
        assert_eq!(count, ends[0].len() - 1);
    }

    #[test]
    fn other_paths_other_modes_and_loose_joints_are_not_proved_so() {
        let ends = joined();
        assert_eq!(bound(&ends, Mode::Polar, &STRAIGHT), None);
        let round = [STRAIGHT[0], DVec3::new(0.5, 0.4, 0.0), STRAIGHT[1]];
        assert_eq!(bound(&ends, Mode::Linear, &round), None);
        assert_eq!(bound(&ends, Mode::Linear, &[DVec3::new(1.1, 1.1, 0.0)]), None);
        for end in 0..2 {
            for map in 0..4 {
                let mut loose = ends.clone();
                loose[end][map].translation.x += 1e-6;
                assert_eq!(bound(&loose, Mode::Linear, &STRAIGHT), None, "{end} {map}");
            }
        }
    }

    #[test]
    fn the_bound_tells_of_joints_that_are_loose_within_what_counts_as_one_point() {
        let mut ends = joined();
        let (tight, _) = bound(&ends, Mode::Linear, &STRAIGHT).unwrap();
        ends[0][1].translation.x += 1e-10;
        let (loose, _) = bound(&ends, Mode::Linear, &STRAIGHT).unwrap();
        assert!(loose > 0.5e-10 && loose < 4e-10 && tight < 1e-13, "{loose} {tight}");
    }
}
