//! Delaunay triangulations of points of a grid, exactly.

use frond_core::hash::pcg;
use glam::DVec2;

/// A point of the grid.
pub(crate) type Place = [i32; 2];

/// Steps of the grid to a unit: with coordinates from -1 to 2 whole numbers of 128 bits hold all that is computed.
pub(crate) const STEPS: f64 = (1 << 29) as f64;

/// Beyond an edge of the outer square.
const NONE: u32 = u32::MAX;

/// A sum nearer to 0 than this share of all that was added up may have the wrong sign: Shewchuk's bound for points in
/// circles (1997), where the differences of coordinates are exact.
const UNSURE: f64 = (10.0 + 96.0 * 0.5 * f64::EPSILON) * 0.5 * f64::EPSILON;

/// The most cells a side of the table where walks begin.
const MOST_CELLS: usize = 256;

/// Triangles in which no circumcircle holds a point, made point by point with flips of edges (Lawson 1977). All signs
/// are exact, so that points in a line or on a circle are no trouble. It stands in the place of a library (spade) that
/// made what every visitor without WebGPU downloads too large: only points of a grid are asked for here.
#[derive(Clone, Debug)]
pub(crate) struct Delaunay {
    points: Vec<Place>,
    /// Counter-clockwise.
    corners: Vec<[u32; 3]>,
    /// For each corner the triangle across the edge that it is not on.
    across: Vec<[u32; 3]>,
    /// A triangle near each cell of the unit square, row by row: where walks begin.
    near: Vec<u32>,
    side: usize,
}

impl Delaunay {
    /// Of points, no two the same, inside of a rectangle whose corners are the last four: lower left, lower right,
    /// upper left, upper right.
    pub fn new(points: Vec<Place>) -> Self {
        let inner = points.len().saturating_sub(4);
        let [a, b, c, d] = std::array::from_fn(|i| (inner + i) as u32);
        let mut this = Self {
            points,
            corners: vec![[a, b, d], [a, d, c]],
            across: vec![[NONE, 1, NONE], [NONE, NONE, 0]],
            near: Vec::new(),
            side: 1,
        };
        // Each round has about twice as many as all before it, and goes in their order (Amenta, Choi and Rote 2003): so
        // whichever points they are, few edges are flipped, and the next point is near.
        let mut order: Vec<u32> = (0..inner as u32).collect();
        order.sort_by_key(|&i| std::cmp::Reverse(pcg(i).trailing_zeros()));
        let mut last = 0;
        let mut open = Vec::new();
        for point in order {
            last = this.walk(this.points[point as usize], last);
            this.insert(point, last, &mut open);
        }
        this.side = (((inner / 2) as f64).sqrt() as usize).clamp(1, MOST_CELLS);
        this.near = vec![NONE; this.side * this.side];
        for (t, corners) in this.corners.iter().enumerate() {
            for &corner in corners {
                let cell = this.cell(this.points[corner as usize]);
                this.near[cell] = t as u32;
            }
        }
        let mut before = 0;
        for cell in &mut this.near {
            before = if *cell == NONE { before } else { *cell };
            *cell = before;
        }
        this
    }

    /// The corners of the triangle that holds a point of the rectangle, and what they count there.
    pub fn weights(&self, point: DVec2) -> [(u32, f64); 3] {
        let steps = point * STEPS;
        let place = [steps.x as i32, steps.y as i32];
        let corners = self.corners[self.walk(place, self.near[self.cell(place)]) as usize];
        let [a, b, c] = corners.map(|i| {
            let [x, y] = self.points[i as usize];
            DVec2::new(f64::from(x), f64::from(y)) - steps
        });
        // Rounded to the grid it is inside; itself it may be a hair beyond.
        let areas = [b.perp_dot(c), c.perp_dot(a), a.perp_dot(b)].map(|area| area.max(0.0));
        let all: f64 = areas.iter().sum();
        // Of a triangle that is hardly one, rounding may leave nothing: there one corner is as good as another.
        let shares = if all > 0.0 { areas.map(|area| area / all) } else { [1.0, 0.0, 0.0] };
        std::array::from_fn(|i| (corners[i], shares[i]))
    }

    fn cell(&self, place: Place) -> usize {
        let most = self.side - 1;
        let [x, y] = place.map(|x| ((f64::from(x) / STEPS * self.side as f64) as usize).min(most));
        y * self.side + x
    }

    /// The triangle that holds a place: from one on, across any edge that the place is behind. No triangle is come to
    /// twice (Edelsbrunner 1990).
    fn walk(&self, place: Place, from: u32) -> u32 {
        let mut at = from;
        loop {
            let [a, b, c] = self.corners[at as usize].map(|i| self.points[i as usize]);
            let edges = [(b, c), (c, a), (a, b)].into_iter().zip(self.across[at as usize]);
            let next = edges.filter(|&(_, next)| next != NONE).find(|&((p, q), _)| area(p, q, place) < 0);
            match next {
                Some((_, next)) => at = next,
                None => return at,
            }
        }
    }

    /// Puts a point into the triangle that holds it. Where it lies on an edge, a triangle without area is made, whose
    /// long edge is flipped at once.
    fn insert(&mut self, point: u32, at: u32, open: &mut Vec<u32>) {
        let ([a, b, c], [beyond_a, beyond_b, beyond_c]) =
            (self.corners[at as usize], self.across[at as usize]);
        let (second, third) = (self.corners.len() as u32, self.corners.len() as u32 + 1);
        self.corners[at as usize] = [point, b, c];
        self.across[at as usize] = [beyond_a, second, third];
        self.corners.extend([[point, c, a], [point, a, b]]);
        self.across.extend([[beyond_b, third, at], [beyond_c, at, second]]);
        self.relink(beyond_b, at, second);
        self.relink(beyond_c, at, third);
        open.extend([at, second, third]);
        while let Some(at) = open.pop() {
            self.flip(at, open);
        }
    }

    /// Flips the edge that the new point, the first corner of a triangle, is not on, where the circle says so.
    fn flip(&mut self, at: u32, open: &mut Vec<u32>) {
        let ([point, u, v], [other, beyond_u, beyond_v]) =
            (self.corners[at as usize], self.across[at as usize]);
        if other == NONE {
            return;
        }
        let (theirs, across) = (self.corners[other as usize], self.across[other as usize]);
        let Some(i) = across.iter().position(|&t| t == at) else { return };
        let far = theirs[i];
        if !in_circle([point, u, v, far].map(|i| self.points[i as usize])) {
            return;
        }
        let (beyond_far_u, beyond_far_v) = (across[(i + 1) % 3], across[(i + 2) % 3]);
        self.corners[at as usize] = [point, u, far];
        self.across[at as usize] = [beyond_far_u, other, beyond_v];
        self.corners[other as usize] = [point, far, v];
        self.across[other as usize] = [beyond_far_v, beyond_u, at];
        self.relink(beyond_far_u, other, at);
        self.relink(beyond_u, at, other);
        open.extend([at, other]);
    }

    fn relink(&mut self, triangle: u32, from: u32, to: u32) {
        if triangle != NONE {
            for slot in &mut self.across[triangle as usize] {
                if *slot == from {
                    *slot = to;
                }
            }
        }
    }
}

/// Twice the area of a triangle, above 0 where it is counter-clockwise.
fn area([ax, ay]: Place, [bx, by]: Place, [cx, cy]: Place) -> i64 {
    let [ax, ay, bx, by, cx, cy] = [ax, ay, bx, by, cx, cy].map(i64::from);
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Whether the last is inside of the circle through the first three, which are counter-clockwise.
fn in_circle([a, b, c, d]: [Place; 4]) -> bool {
    let [a, b, c] = [a, b, c].map(|p| [0, 1].map(|i| i64::from(p[i]) - i64::from(d[i])));
    let [p, q, r] = [a, b, c].map(|p| p.map(|x| x as f64));
    let terms = [(p, q, r), (q, r, p), (r, p, q)].map(|([px, py], [qx, qy], [rx, ry])| {
        let lift = px * px + py * py;
        (lift * (qx * ry - qy * rx), lift * ((qx * ry).abs() + (qy * rx).abs()))
    });
    let det: f64 = terms.iter().map(|term| term.0).sum();
    let size: f64 = terms.iter().map(|term| term.1).sum();
    if det.abs() > UNSURE * size {
        return det > 0.0;
    }
    let exact = |[px, py]: [i64; 2], [qx, qy]: [i64; 2], [rx, ry]: [i64; 2]| {
        i128::from(px * px + py * py) * i128::from(qx * ry - qy * rx)
    };
    exact(a, b, c) + exact(b, c, a) + exact(c, a, b) > 0
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    const UNIT: i32 = 1 << 29;

    fn with_corners(inner: &[Place]) -> Vec<Place> {
        let mut points = inner.to_vec();
        points.sort_unstable();
        points.dedup();
        points.extend([[-UNIT, -UNIT], [2 * UNIT, -UNIT], [-UNIT, 2 * UNIT], [2 * UNIT, 2 * UNIT]]);
        points
    }

    /// That the triangles cover the square once, know their neighbours, and have no point in their circles.
    fn check(points: &[Place]) -> Result<(), TestCaseError> {
        let made = Delaunay::new(points.to_vec());
        prop_assert_eq!(made.corners.len(), 2 * (points.len() - 4) + 2);
        let mut all = 0;
        for (t, (corners, across)) in made.corners.iter().zip(&made.across).enumerate() {
            let places = corners.map(|i| points[i as usize]);
            let own = area(places[0], places[1], places[2]);
            prop_assert!(own > 0, "a triangle without area");
            all += i128::from(own);
            for (i, &next) in across.iter().enumerate() {
                let edge = [corners[(i + 1) % 3], corners[(i + 2) % 3]];
                let outside = |&corner: &u32| corner as usize >= points.len() - 4;
                prop_assert!(next != NONE || edge.iter().all(outside));
                if next != NONE {
                    prop_assert!(made.across[next as usize].contains(&(t as u32)));
                    prop_assert!(edge.iter().all(|corner| made.corners[next as usize].contains(corner)));
                }
            }
            let [a, b, c] = places.map(|[x, y]| [i128::from(x), i128::from(y)]);
            for &[x, y] in points {
                let [p, q, r] = [a, b, c].map(|[px, py]| [px - i128::from(x), py - i128::from(y)]);
                let part = |[px, py]: [i128; 2], [qx, qy]: [i128; 2], [rx, ry]: [i128; 2]| {
                    (px * px + py * py) * (qx * ry - qy * rx)
                };
                prop_assert!(part(p, q, r) + part(q, r, p) + part(r, p, q) <= 0, "a point in a circle");
            }
        }
        prop_assert_eq!(all, 18 * i128::from(UNIT) * i128::from(UNIT));
        Ok(())
    }

    fn place(most: i32) -> impl Strategy<Value = Place> {
        (0..=most, 0..=most).prop_map(move |(x, y)| [x, y].map(|x| x * (UNIT / most.max(1))))
    }

    proptest! {
        #[test]
        fn no_circle_holds_a_point(list in proptest::collection::vec(place(UNIT), 0..60)) {
            check(&with_corners(&list))?;
        }

        #[test]
        fn nor_where_many_lie_in_lines_and_on_circles(list in proptest::collection::vec(place(7), 0..64)) {
            check(&with_corners(&list))?;
        }

        #[test]
        fn weights_are_linear(
            list in proptest::collection::vec(place(UNIT), 0..60), x in -0.99..1.99_f64, y in -0.99..1.99_f64,
        ) {
            let points = with_corners(&list);
            let at = DVec2::new(x, y);
            let weights = Delaunay::new(points.clone()).weights(at);
            let mut sum = DVec2::ZERO;
            for (i, share) in weights {
                prop_assert!((0.0..=1.0).contains(&share));
                let [x, y] = points[i as usize];
                sum += share * DVec2::new(f64::from(x), f64::from(y)) / STEPS;
            }
            // As near as the grid is fine.
            prop_assert!((sum - at).length() < 1e-8, "{sum} {at}");
        }
    }

    #[test]
    fn points_on_a_parabola_in_their_order_take_no_longer() -> Result<(), TestCaseError> {
        let on = |i: i32| {
            let x = f64::from(i) / 16_384.0 - 1.0;
            [i << 14, (x * x * STEPS) as i32]
        };
        let points = with_corners(&(0..=32_768).map(on).collect::<Vec<_>>());
        // A flip for each pair of points would be half of a milliard.
        let made = Delaunay::new(points.clone());
        prop_assert_eq!(made.corners.len(), 2 * (points.len() - 4) + 2);
        let weights = made.weights(DVec2::new(0.5, 0.5));
        prop_assert!((weights.iter().map(|weight| weight.1).sum::<f64>() - 1.0).abs() < 1e-12);
        Ok(())
    }

    #[test]
    fn a_point_far_from_a_small_triangle_is_outside() {
        // The sign hangs on the last of 120 bits.
        for (x, y) in (0..1000).map(|i| (i * 537, i * i)) {
            let far = [2 * UNIT - 7 * x, y - UNIT];
            assert!(!in_circle([[x, y], [x + 1, y], [x, y + 1], far]), "{x} {y}");
        }
    }

    #[test]
    fn a_place_on_a_point_is_that_point() {
        let made = Delaunay::new(with_corners(&[[0, 0], [UNIT, 0], [UNIT / 2, UNIT / 2]]));
        let [x, y] = made.points[1];
        let at = DVec2::new(f64::from(x), f64::from(y)) / STEPS;
        let found = made.weights(at).into_iter().max_by(|a, b| a.1.total_cmp(&b.1));
        assert_eq!(found, Some((1, 1.0)));
    }
}
