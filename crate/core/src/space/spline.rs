//! Smooth ways through values at times.

use glam::{DQuat, DVec3};

/// The cubic that has value `p[1]` at 0 and `p[2]` at 1, with the slopes of the parabolas through three neighbours
/// (Catmull & Rom 1974, for times at any distance). `t` are the times of all four, of which the middle two are the ends.
pub(crate) fn cubic(p: [DVec3; 4], t: [f64; 4], s: f64) -> DVec3 {
    let span = t[2] - t[1];
    // The slope at the middle one of three.
    let slope = |a: usize| {
        let (before, after) = (t[a] - t[a - 1], t[a + 1] - t[a]);
        let (first, last) = (p[a] - p[a - 1], p[a + 1] - p[a]);
        if before <= 0.0 && after <= 0.0 {
            DVec3::ZERO
        } else if before <= 0.0 {
            last / after
        } else if after <= 0.0 {
            first / before
        } else {
            (first * (after / before) + last * (before / after)) / (before + after)
        }
    };
    let (m, n) = (slope(1) * span, slope(2) * span);
    let (s2, s3) = (s * s, s * s * s);
    p[1] * (2.0 * s3 - 3.0 * s2 + 1.0)
        + m * (s3 - 2.0 * s2 + s)
        + p[2] * (3.0 * s2 - 2.0 * s3)
        + n * (s3 - s2)
}

/// The same for turns: the cubic in the logarithms of the turns as seen from the one at 0, which goes through all four.
pub(crate) fn cubic_turn(q: [DQuat; 4], t: [f64; 4], s: f64) -> DQuat {
    let back = q[1].inverse();
    // Each the shortest turn away from its neighbour, so that none goes the long way round.
    let toward = |from: DVec3, a: DQuat, b: DQuat| from + turn_vector(a.inverse() * b);
    let p1 = DVec3::ZERO;
    let p2 = toward(p1, q[1], q[2]);
    let p0 = turn_vector(back * q[0]);
    // Beyond the far end, its own turn carried over: the slope there is what matters.
    let p3 = toward(p2, q[2], q[3]);
    (q[1] * from_vector(cubic([p0, p1, p2, p3], t, s))).normalize()
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
    use super::*;

    #[test]
    fn lines_stay_lines_and_parabolas_stay_parabolas() {
        let t = [0.0, 1.0, 3.0, 3.5];
        let line = t.map(|t| DVec3::new(2.0 * t, -t, 1.0));
        let bowl = t.map(|t| DVec3::new(t * t, t, 0.0));
        for k in 0..=10 {
            let s = f64::from(k) / 10.0;
            let at = 1.0 + 2.0 * s;
            assert!(cubic(line, t, s).distance(DVec3::new(2.0 * at, -at, 1.0)) < 1e-12);
            assert!(cubic(bowl, t, s).distance(DVec3::new(at * at, at, 0.0)) < 1e-12);
        }
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
