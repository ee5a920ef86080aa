//! Smooth ways through values at times, which do not swing past them.

use glam::{DQuat, DVec3};

/// What a turn between two keys is away from the short arc between them, at most: this part of the arc's angle.
#[cfg(test)]
const ASIDE: f64 = 1.0 / 6.0;

/// The cubics that have the values `p[1]` at 0 and `p[2]` at 1, one for each coordinate, and stay between these
/// (Fritsch & Carlson 1980). `t` are the times of all four, of which the middle two are the ends; a leg without length
/// before or behind them counts as none.
pub(crate) fn cubic(p: [DVec3; 4], t: [f64; 4], s: f64) -> DVec3 {
    let legs = legs(t);
    let coordinate = |k: usize| monotone(p.map(|p| p[k]), legs, s);
    DVec3::new(coordinate(0), coordinate(1), coordinate(2))
}

/// The same for turns: the cubic in the turn vector as seen from the turn at 0. Its slopes are angular velocities.
pub(crate) fn cubic_turn(q: [DQuat; 4], t: [f64; 4], s: f64) -> DQuat {
    // Equal keys stay equal, to the last bit.
    if q[1] == q[2] || q[1] == -q[2] {
        return q[1];
    }
    let legs = legs(t);
    // Each the shortest turn from its neighbour, so that none goes the long way round. Seen from either end it is the
    // same.
    let [before, arc, after] = [0, 1, 2].map(|k| turn_vector(q[k].inverse() * q[k + 1]));
    let m = velocity([before, arc], [legs[0], legs[1]]) * legs[1];
    let n = rate_of(arc, velocity([arc, after], [legs[1], legs[2]]) * legs[1]);
    (q[1] * from_vector(hermite(arc, m, n, s))).normalize()
}

/// From `a` to `b`, never beyond either, and `a` where both are the same.
pub(crate) fn straight(a: DVec3, b: DVec3, s: f64) -> DVec3 {
    (a + (b - a) * s).clamp(a.min(b), a.max(b))
}

fn legs(t: [f64; 4]) -> [f64; 3] {
    [t[1] - t[0], t[2] - t[1], t[3] - t[2]]
}

/// The cubic from 0 to `end`, with slopes `m` and `n`.
fn hermite(end: DVec3, m: DVec3, n: DVec3, s: f64) -> DVec3 {
    let (s2, s3) = (s * s, s * s * s);
    end * (3.0 * s2 - 2.0 * s3) + m * (s3 - 2.0 * s2 + s) + n * (s3 - s2)
}

fn monotone(p: [f64; 4], legs: [f64; 3], s: f64) -> f64 {
    let rise = [p[1] - p[0], p[2] - p[1], p[3] - p[2]];
    let slope = |a: usize| {
        let means = [rise[a] / legs[a], rise[a + 1] / legs[a + 1]];
        match [legs[a] > 0.0, legs[a + 1] > 0.0] {
            [true, true] if means[0] * means[1] > 0.0 => harmonic(means, [legs[a], legs[a + 1]]),
            // It turns back here, or stays.
            [true, true] | [false, false] => 0.0,
            [true, false] => means[0],
            [false, true] => means[1],
        }
    };
    let [m, n] = [slope(0), slope(1)].map(|slope| DVec3::new(slope * legs[1], 0.0, 0.0));
    // Only rounding could still lead it out.
    (p[1] + hermite(DVec3::new(rise[1], 0.0, 0.0), m, n, s).x).clamp(p[1].min(p[2]), p[1].max(p[2]))
}

/// The mean of two slopes of one sign over legs of these lengths: the weighted harmonic one, which is at most three
/// times the smaller, so that no cubic beside it turns back (Fritsch & Butland 1984).
fn harmonic(slopes: [f64; 2], legs: [f64; 2]) -> f64 {
    let [before, after] = [legs[0] + 2.0 * legs[1], 2.0 * legs[0] + legs[1]];
    (before + after) / (before / slopes[0] + after / slopes[1])
}

/// The angular velocity between two arcs, which are turn vectors that take these times.
///
/// Along each arc it is neither backwards nor more than three times that of the slower one, and across at most half of
/// that: 0 where the second arc leads back, and where one is none.
fn velocity(arcs: [DVec3; 2], times: [f64; 2]) -> DVec3 {
    let ways = [arcs[0].normalize_or_zero(), arcs[1].normalize_or_zero()];
    let speeds = [arcs[0].length() / times[0], arcs[1].length() / times[1]];
    match [times[0] > 0.0, times[1] > 0.0] {
        [true, true] if speeds[0] > 0.0 && speeds[1] > 0.0 => {}
        [true, true] | [false, false] => return DVec3::ZERO,
        [true, false] => return arcs[0] / times[0],
        [false, true] => return arcs[1] / times[1],
    }
    // Half the angle between the arcs is between each of them and this, which is as much shorter.
    let mean = (ways[0] + ways[1]) * (0.5 * harmonic(speeds, times));
    let across = mean.reject_from(ways[0]).length();
    let most = 0.5 * speeds[0].min(speeds[1]);
    if across > most { mean * (most / across) } else { mean }
}

/// How fast a turn vector changes where its turn has this angular velocity, in its own axes: the inverse of the right
/// Jacobian.
fn rate_of(vector: DVec3, velocity: DVec3) -> DVec3 {
    let angle = vector.length();
    let once = vector.cross(velocity);
    let curved =
        if angle < 1e-4 { 1.0 / 12.0 } else { (1.0 - 0.5 * angle / (0.5 * angle).tan()) / (angle * angle) };
    velocity + once * 0.5 + vector.cross(once) * curved
}

/// The axis of the shortest turn, as long as its angle.
pub(crate) fn turn_vector(q: DQuat) -> DVec3 {
    let q = if q.w < 0.0 { -q } else { q };
    let sine = q.xyz().length();
    if sine < 1e-300 { DVec3::ZERO } else { q.xyz() * (2.0 * sine.atan2(q.w) / sine) }
}

fn from_vector(v: DVec3) -> DQuat {
    let angle = v.length();
    if angle < 1e-300 { DQuat::IDENTITY } else { DQuat::from_axis_angle(v / angle, angle) }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Times of four keys; now and then a leg is tiny, or the first or the last is none.
    fn any_times() -> impl Strategy<Value = [f64; 4]> {
        let leg = || prop_oneof![4 => 0.05..4.0_f64, 1 => 1e-9..1e-2_f64];
        let end = || prop_oneof![5 => leg(), 1 => Just(0.0)];
        (-9.0..9.0_f64, end(), leg(), end()).prop_map(|(t, a, b, c)| [t, t + a, t + a + b, t + a + b + c])
    }

    fn any_value() -> impl Strategy<Value = DVec3> {
        let number = || prop_oneof![6 => -9.0..9.0_f64, 1 => Just(0.0), 1 => -1e9..1e9_f64];
        [number(), number(), number()].prop_map(DVec3::from_array)
    }

    fn any_turn() -> impl Strategy<Value = DQuat> {
        (proptest::array::uniform3(-1.0..1.0_f64), -3.1..3.1_f64).prop_map(|(axis, angle)| {
            let axis = DVec3::from_array(axis).try_normalize().unwrap_or(DVec3::Z);
            DQuat::from_axis_angle(axis, angle)
        })
    }

    /// The angle between two turns.
    fn apart(a: DQuat, b: DQuat) -> f64 {
        turn_vector(a.inverse() * b).length()
    }

    proptest! {
        #[test]
        fn no_coordinate_leaves_the_range_of_two_keys_or_turns_back(
            p in proptest::array::uniform4(any_value()), t in any_times(),
        ) {
            let (low, high) = (p[1].min(p[2]), p[1].max(p[2]));
            let mut last = p[1];
            for k in 0..=100 {
                let now = cubic(p, t, f64::from(k) / 100.0);
                prop_assert!(now.cmpge(low).all() && now.cmple(high).all(), "{now} {low} {high}");
                let on = (now - last) * (p[2] - p[1]).signum();
                prop_assert!(on.min_element() >= -1e-15 * (high.abs() + low.abs()).max_element(), "{k}: {on}");
                last = now;
            }
        }

        #[test]
        fn equal_keys_stay_equal(
            value in any_value(), turn in any_turn(), p in any_value(), q in any_turn(), t in any_times(), s in 0.0..1.0_f64,
        ) {
            prop_assert_eq!(cubic([p, value, value, -p], t, s), value);
            prop_assert_eq!(cubic_turn([q, turn, turn, q.inverse()], t, s), turn);
            prop_assert_eq!(cubic_turn([q, turn, -turn, q], t, s), turn);
            prop_assert_eq!(straight(value, value, s), value);
        }

        #[test]
        fn a_turn_stays_near_the_short_arc(q in proptest::array::uniform4(any_turn()), t in any_times()) {
            let arc = turn_vector(q[1].inverse() * q[2]);
            // Of a half turn there are two short arcs.
            prop_assume!(arc.length() < std::f64::consts::PI - 1e-3);
            for k in 0..=50 {
                let now = cubic_turn(q, t, f64::from(k) / 50.0);
                let near = (0..=200)
                    .map(|j| apart(q[1] * from_vector(arc * (f64::from(j) / 200.0)), now))
                    .fold(f64::INFINITY, f64::min);
                prop_assert!(near <= (ASIDE + 0.003) * arc.length() + 1e-7, "{k}: {near} of {}", arc.length());
                let [gone, left] = [apart(q[1], now), apart(now, q[2])];
                prop_assert!(gone.max(left) <= arc.length() * (1.0 + ASIDE) + 1e-7, "{gone} {left}");
            }
        }

        #[test]
        fn the_velocity_is_the_same_on_both_sides_of_a_key(
            q in proptest::array::uniform5(any_turn()), legs in proptest::array::uniform4(0.3..2.0_f64),
        ) {
            let t = [0.0, legs[0], legs[0] + legs[1], legs[0] + legs[1] + legs[2], legs.iter().sum()];
            let arcs: Vec<f64> = q.windows(2).map(|two| apart(two[0], two[1])).collect();
            prop_assume!(arcs.iter().all(|arc| *arc < 3.0));
            let h = 1e-5;
            let before = cubic_turn([q[0], q[1], q[2], q[3]], [t[0], t[1], t[2], t[3]], 1.0 - h / legs[1]);
            let after = cubic_turn([q[1], q[2], q[3], q[4]], [t[1], t[2], t[3], t[4]], h / legs[2]);
            let [into, out] = [turn_vector(before.inverse() * q[2]), turn_vector(q[2].inverse() * after)].map(|v| v / h);
            prop_assert!(into.distance(out) < 1e-2, "{into} {out}");
        }
    }

    #[test]
    fn lines_stay_lines() {
        let t = [0.0, 1.0, 3.0, 3.5];
        let line = t.map(|t| DVec3::new(2.0 * t, -t, 1.0));
        for k in 0..=10 {
            let s = f64::from(k) / 10.0;
            let at = 1.0 + 2.0 * s;
            assert!(cubic(line, t, s).distance(DVec3::new(2.0 * at, -at, 1.0)) < 1e-12);
            // Also where there are but two keys.
            let two = cubic([line[1], line[1], line[2], line[2]], [1.0, 1.0, 3.0, 3.0], s);
            assert!(two.distance(cubic(line, t, s)) < 1e-12);
        }
    }

    #[test]
    fn a_tiny_leg_does_not_drive_a_long_one() {
        // From 0 to 60 in six seconds, and back in no time.
        let p = [60.0, 0.0, 60.0, 0.0].map(DVec3::splat);
        let t = [-0.02, 0.0, 5.98, 6.0];
        let steps: Vec<f64> = (0..=6).map(|k| cubic(p, t, f64::from(k) / 6.0).x).collect();
        assert!(steps.is_sorted() && steps[0] == 0.0 && steps[6] == 60.0, "{steps:?}");
        // The same way as before: no faster than three times the slower.
        let p = [0.0, 60.0, 66.0, 72.0].map(DVec3::splat);
        let first = cubic(p, [-0.001, 0.0, 1.0, 2.0], 0.01).x - 60.0;
        assert!(first > 0.0 && first < 0.01 * 3.0 * 6.0, "{first}");
    }

    #[test]
    fn even_turns_about_one_axis_stay_even() {
        let axis = DVec3::new(2.0, -1.0, 2.0) / 3.0;
        let turns = [0.0, 1.0, 2.0, 3.0].map(|angle| DQuat::from_axis_angle(axis, angle));
        let middle = cubic_turn(turns, [0.0, 1.0, 2.0, 3.0], 0.25);
        assert!(middle.dot(DQuat::from_axis_angle(axis, 1.25)).abs() > 1.0 - 1e-12);
        // The other sign of a quaternion is the same turn.
        let flipped = [turns[0], -turns[1], turns[2], -turns[3]];
        assert!(cubic_turn(flipped, [0.0, 1.0, 2.0, 3.0], 0.25).dot(middle).abs() > 1.0 - 1e-12);
    }
}
