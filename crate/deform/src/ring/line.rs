//! A bent closed curve as a polyline.

use glam::DVec2;

use super::RingBend;

/// Parts of the curve in each of which the mesh alone bends it little.
const FEWEST_PARTS: usize = 256;

/// How often such a part is halved where the mesh bends it more than can be seen.
const MOST_HALVINGS: u32 = 8;

/// No more corners than this come of it.
const MOST_FINE: usize = 1 << 16;

/// How coarse it may be where it is not seen, in parts of the polyline's box.
const OUTSIDE_TOLERANCE: f64 = 1.0 / 128.0;

impl RingBend {
    /// A closed polyline, the first corner not repeated, bent: `line` holds the corners of the curve at rest with their
    /// t, which increases from 0 on and stays below 1.
    ///
    /// It follows the bent polyline within `tolerance` inside the window (left, bottom, right, top; none: all is
    /// inside), and coarsely elsewhere, so that nothing comes into the window that does not belong there. There are at
    /// most `most` corners, three or more; a tolerance that would take more is raised.
    #[must_use]
    pub fn polyline(
        &self,
        line: &[(f64, DVec2)],
        tolerance: f64,
        window: Option<[f64; 4]>,
        most: usize,
    ) -> Vec<DVec2> {
        self.corners(line, tolerance, window, most).into_iter().map(|(_, p)| p).collect()
    }

    /// The same, each corner with the t of what is bent there.
    #[must_use]
    pub fn corners(
        &self,
        line: &[(f64, DVec2)],
        tolerance: f64,
        window: Option<[f64; 4]>,
        most: usize,
    ) -> Vec<(f64, DVec2)> {
        let most = most.max(3);
        let mut tolerance = if tolerance > 0.0 { tolerance } else { 0.0 };
        let fine = self.fine(line, 0.25 * tolerance, self.mesh.curvature());
        let start = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        let (low, high) = fine.iter().fold(start, |(low, high), (_, p)| (low.min(*p), high.max(*p)));
        let size = low.distance(high);
        if fine.len() < 4 || !size.is_finite() {
            return fine.into_iter().take(most).collect();
        }
        loop {
            let room = |i: usize| {
                let Some(window) = window else { return tolerance };
                let (before, p, after) =
                    (fine[(i + fine.len() - 1) % fine.len()].1, fine[i].1, fine[(i + 1) % fine.len()].1);
                // As long as no side at the corner comes into the window.
                let away = beside(window, p) - before.distance(p).max(p.distance(after));
                tolerance.max((0.5 * away).min(OUTSIDE_TOLERANCE * size))
            };
            let found = simplified(&fine, room);
            if found.len() <= most {
                return found;
            }
            if tolerance > 2.0 * size {
                return found.into_iter().take(most).collect();
            }
            let more = if found.len() > 4 * most { 4.0 } else { 1.6 };
            tolerance = more * tolerance.max(1e-9 * size);
        }
    }

    /// Where it may be bent: the corners, the ends of parts, and more where the mesh alone, whose curvature is known
    /// inside of its box, bends more than `tolerance`.
    fn fine(&self, line: &[(f64, DVec2)], tolerance: f64, curvature: f64) -> Vec<(f64, DVec2)> {
        let parts = self.values.len().max(FEWEST_PARTS);
        let Some(&(first, _)) = line.first() else { return Vec::new() };
        let (low, high) = self.mesh.bounds();
        let inside = |p: DVec2| p.cmpge(low).all() && p.cmple(high).all();
        let flat = |a: DVec2, b: DVec2| {
            0.125 * curvature * a.distance_squared(b) <= tolerance && inside(a) && inside(b)
        };
        let enough = MOST_FINE + 2 * (line.len() + parts);
        let mut found = Vec::with_capacity(line.len() + parts);
        for (i, &(t0, p0)) in line.iter().enumerate() {
            let (t1, p1) = line.get(i + 1).copied().unwrap_or((first + 1.0, line[0].1));
            let long = t1 - t0;
            let mut from = (t0, p0, self.displaced(t0, p0));
            found.push((from.0, from.2));
            let mut go = |t: f64, found: &mut Vec<(f64, DVec2)>| {
                let p = if t < t1 { p0.lerp(p1, ((t - t0) / long).clamp(0.0, 1.0)) } else { p1 };
                let to = (t, p, self.displaced(t, p));
                if !flat(from.1, p) && found.len() < enough {
                    self.halve(from, to, tolerance, MOST_HALVINGS, found);
                }
                if t < t1 {
                    found.push((to.0, to.2));
                }
                from = to;
            };
            let node = (t0 * parts as f64).floor() + 1.0;
            let nodes = (0..parts).map(|k| (node + k as f64) / parts as f64);
            nodes.take_while(|&t| t < t1).for_each(|t| go(t, &mut found));
            go(t1, &mut found);
        }
        found
    }

    /// Corners between two, as many as the mesh asks for: the shuffled terms are linear there.
    fn halve(
        &self,
        a: (f64, DVec2, DVec2),
        b: (f64, DVec2, DVec2),
        tolerance: f64,
        depth: u32,
        found: &mut Vec<(f64, DVec2)>,
    ) {
        if depth == 0 || a.2.distance_squared(b.2) <= tolerance * tolerance {
            return;
        }
        let (t, p) = (f64::midpoint(a.0, b.0), a.1.midpoint(b.1));
        let middle = (t, p, self.displaced(t, p));
        if middle.2.distance_squared(a.2.midpoint(b.2)) > tolerance * tolerance {
            self.halve(a, middle, tolerance, depth - 1, found);
            found.push((middle.0, middle.2));
            self.halve(middle, b, tolerance, depth - 1, found);
        }
    }
}

/// How far a point is outside of a window.
fn beside([left, bottom, right, top]: [f64; 4], p: DVec2) -> f64 {
    let out = DVec2::new((left - p.x).max(p.x - right), (bottom - p.y).max(p.y - top));
    out.max(DVec2::ZERO).length()
}

/// Fewer corners of a closed polyline: those left out are nearer to a side than `room` says of each.
///
/// Sides are drawn on while they pass all circles of that size around the corners between: it is one sweep (Williams
/// 1978).
fn simplified(points: &[(f64, DVec2)], room: impl Fn(usize) -> f64) -> Vec<(f64, DVec2)> {
    let mut found = vec![points[0]];
    let mut anchor = points[0].1;
    let mut last = points[0];
    // The directions that pass all circles so far, clockwise end first, and how far out the last one is.
    let mut cone: Option<[DVec2; 2]> = None;
    let mut reach = 0.0;
    for i in (1..points.len()).chain([0]) {
        let point = points[i].1;
        let passes = |cone: &Option<[DVec2; 2]>, way: DVec2| {
            cone.is_none_or(|[right, left]| right.perp_dot(way) >= 0.0 && left.perp_dot(way) <= 0.0)
        };
        let way = point - anchor;
        if !passes(&cone, way) || way.length() < reach {
            found.push(last);
            (anchor, cone, reach) = (last.1, None, 0.0);
        }
        let (way, room) = (point - anchor, room(i));
        let distance = way.length();
        if distance > room {
            let (along, across) = ((1.0 - (room / distance).powi(2)).sqrt(), room / distance);
            let ends = [DVec2::new(along, -across), DVec2::new(along, across)].map(|turn| turn.rotate(way));
            cone = Some(match cone {
                None => ends,
                Some([right, left]) => [
                    if right.perp_dot(ends[0]) > 0.0 { ends[0] } else { right },
                    if left.perp_dot(ends[1]) < 0.0 { ends[1] } else { left },
                ],
            });
            reach = f64::max(reach, distance - room);
        }
        last = points[i];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distance(p: DVec2, line: &[DVec2]) -> f64 {
        let sides = line.iter().zip(line.iter().cycle().skip(1));
        let to = |(&a, &b): (&DVec2, &DVec2)| {
            let along = (b - a).length_squared();
            let share = if along > 0.0 { ((p - a).dot(b - a) / along).clamp(0.0, 1.0) } else { 0.0 };
            p.distance(a.lerp(b, share))
        };
        sides.map(to).fold(f64::INFINITY, f64::min)
    }

    /// Corners with a t of their own.
    fn timed(points: &[DVec2]) -> Vec<(f64, DVec2)> {
        points.iter().enumerate().map(|(i, &p)| (i as f64 / points.len() as f64, p)).collect()
    }

    fn plain(points: Vec<(f64, DVec2)>) -> Vec<DVec2> {
        points.into_iter().map(|(_, p)| p).collect()
    }

    /// Out and back, in circles, and all over the place.
    fn tangle() -> Vec<DVec2> {
        let back = (0..50).map(|i| DVec2::new(f64::from(25 - (i - 25_i32).abs()), 0.001 * f64::from(i % 3)));
        let round = (0..300).map(|i| DVec2::from_angle(f64::from(i) * 0.05) * 3.0);
        let wild = (0..500).map(|i| {
            DVec2::new(f64::from(i * 7919 % 101), f64::from(i * 104_729 % 97))
                / if i % 2 == 0 { 10.0 } else { 1e4 }
        });
        back.chain(round).chain(wild).collect()
    }

    #[test]
    fn what_is_left_out_is_near() {
        let points = tangle();
        for room in [0.0, 1e-3, 0.1, 2.0, 50.0] {
            let kept = simplified(&timed(&points), |_| room);
            assert!(kept.is_sorted_by(|p, q| p.0 <= q.0), "what is kept keeps its order and its t");
            assert!(kept.iter().all(|(t, p)| points[(t * points.len() as f64).round() as usize] == *p));
            let few = plain(kept);
            let worst = points.iter().map(|&p| distance(p, &few)).fold(0.0, f64::max);
            assert!(worst <= room * (1.0 + 1e-9) + 1e-12, "{room}: {worst}");
            assert!(few.iter().all(|p| points.contains(p)));
        }
        assert!(simplified(&timed(&points), |_| 0.1).len() * 10 < points.len() * 9);
        assert_eq!(plain(simplified(&timed(&[DVec2::ONE; 40]), |_| 0.0)), [DVec2::ONE]);
    }

    #[test]
    fn a_straight_side_is_one() {
        let side = |a: DVec2, b: DVec2| (0..100).map(move |i| a.lerp(b, f64::from(i) / 100.0));
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let points: Vec<_> = (0..4).flat_map(|i| side(corners[i], corners[(i + 1) % 4])).collect();
        let found = plain(simplified(&timed(&points), |_| 1e-9));
        assert_eq!(found.len(), 4, "{found:?}");
    }
}
