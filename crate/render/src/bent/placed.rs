//! Where the bend takes a piece.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::pieces::letters::Letters;
use crate::points::Instance;

/// A map from the unit disc to pixels that bends a little: affine, plus a `twist` times how far a point is `along`
/// one direction and `up` another. So a parallelogram goes to any quadrilateral, and its sides stay straight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    /// The affine part.
    pub map: Affine2,
    /// In pixels.
    pub twist: DVec2,
    /// How far along a point of the disc is: its dot product with this.
    pub along: DVec2,
    /// The same for the other direction.
    pub up: DVec2,
}

/// The triangle or parallelogram that is taken to where the bend takes it, as seen from the unit disc.
#[derive(Clone, Copy, Debug)]
pub struct Sides {
    /// From the unit disc to how far a point is along the two sides that leave the first anchor, less those of the
    /// disc's middle.
    linear: DMat2,
    /// How far the disc's middle is.
    middle: DVec2,
    /// Where the last anchor is in the list.
    last: usize,
}

impl Sides {
    /// Those of the anchors, three or four in cyclic order, points of the plane. `to_world` takes the unit disc there.
    /// Anchors in one line give sides of no use, but finite ones.
    pub fn of(anchors: &[DVec2], to_world: Affine2) -> Self {
        let at = |i: usize| anchors.get(i).copied().unwrap_or(DVec2::ZERO);
        let last = anchors.len().clamp(3, 4) - 1;
        let inverse = DMat2::from_cols(at(1) - at(0), at(last) - at(0)).inverse();
        let inverse = if inverse.is_finite() { inverse } else { DMat2::ZERO };
        Self { linear: inverse * to_world.linear, middle: inverse * (to_world.translation - at(0)), last }
    }

    /// The map that takes the anchors to these four points, of which the last is not looked at where there are three.
    #[inline]
    pub fn placed(&self, points: [DVec2; 4]) -> Placed {
        let twist = if self.last == 3 { points[0] - points[1] + points[2] - points[3] } else { DVec2::ZERO };
        let (along, up) = (points[1] - points[0], points[self.last] - points[0]);
        let DVec2 { x: s, y: t } = self.middle;
        let linear = DMat2::from_cols(along + twist * t, up + twist * s) * self.linear;
        let translation = points[0] + along * s + up * t + twist * (s * t);
        let rows = self.linear.transpose();
        Placed { map: Affine2::new(linear, translation), twist, along: rows.x_axis, up: rows.y_axis }
    }

    /// As the graphics card gets them.
    pub fn to_card(self) -> [f32; 4] {
        let m = self.linear;
        [m.x_axis.x, m.y_axis.x, m.x_axis.y, m.y_axis.y].map(|x| x as f32)
    }
}

impl Placed {
    /// Where a point of the unit disc goes.
    #[inline]
    pub fn at(&self, point: DVec2) -> DVec2 {
        self.map.apply(point) + self.twist * (self.along.dot(point) * self.up.dot(point))
    }

    /// How far a point of the disc is taken away from where the affine part takes it, at most.
    #[inline]
    pub fn wobble(&self) -> f64 {
        self.twist.length() * self.along.length() * self.up.length()
    }

    /// No two points are taken farther apart than so many times their distance over two.
    #[inline]
    pub fn size(&self) -> f64 {
        2.0 * self.map.norm() + 4.0 * self.wobble()
    }

    /// The same for a part: first `part`, a map of the unit disc into itself.
    #[inline]
    pub fn then(&self, part: &Affine2) -> Self {
        let mut map = self.map * *part;
        let inner = part.linear.transpose();
        let (along, up) = (inner * self.along, inner * self.up);
        let (s, t) = (self.along.dot(part.translation), self.up.dot(part.translation));
        let tilt = up * s + along * t;
        map.linear += DMat2::from_cols(self.twist * tilt.x, self.twist * tilt.y);
        map.translation += self.twist * (s * t);
        Self { map, twist: self.twist, along, up }
    }

    /// As the graphics card gets it. It must come straight from [`Sides::placed`].
    pub fn to_card(self, letters: Letters, tint: u32) -> Instance {
        let twist = [self.twist.x as f32, self.twist.y as f32];
        Instance { twist, tint, ..Instance::new(&self.map, letters, 1.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: DVec2, b: DVec2) -> bool {
        (a - b).length() < 1e-9
    }

    #[test]
    fn anchors_go_where_they_are_sent() {
        let to_world = Affine2::from_row([2.0, 0.3, -0.1, 1.5, 4.0, -3.0]);
        let back = to_world.inverse().unwrap();
        let corners = [(0.0, 0.0), (3.0, 1.0), (2.0, 4.0), (-1.0, 3.0)].map(|(x, y)| DVec2::new(x, y));
        let goals = [(10.0, 9.0), (40.0, 20.0), (70.0, 90.0), (0.0, 50.0)].map(|(x, y)| DVec2::new(x, y));
        for count in [3, 4] {
            let placed = Sides::of(&corners[..count], to_world).placed(goals);
            for (corner, goal) in corners[..count].iter().zip(goals) {
                assert!(near(placed.at(back.apply(*corner)), goal), "{count} {goal}");
            }
            // Sides stay straight: what is in the middle stays there.
            let middle = placed.at(back.apply(corners[0].midpoint(corners[1])));
            assert!(near(middle, goals[0].midpoint(goals[1])));
        }
    }

    #[test]
    fn parts_are_placed_as_their_points_are() {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        let goals = [(10.0, 9.0), (40.0, 20.0), (70.0, 90.0), (0.0, 50.0)].map(|(x, y)| DVec2::new(x, y));
        let whole = Sides::of(&corners, Affine2::similitude(0.7, 0.0, DVec2::splat(0.5))).placed(goals);
        let parts =
            [[0.5, 0.1, -0.2, 0.4, 0.3, -0.1], [0.3, 0.0, 0.0, -0.6, -0.2, 0.2]].map(Affine2::from_row);
        let placed = whole.then(&parts[0]).then(&parts[1]);
        for i in 0..12 {
            let point = DVec2::from_angle(f64::from(i)) * 0.3 * f64::from(i % 4);
            assert!(near(placed.at(point), whole.at(parts[0].apply(parts[1].apply(point)))), "{i}");
            let off = (placed.at(point) - placed.map.apply(point)).length();
            assert!(off <= placed.wobble() + 1e-9);
            for j in 0..12 {
                let other = DVec2::from_angle(f64::from(j) + 0.5);
                let apart = (placed.at(point) - placed.at(other)).length();
                assert!(apart <= 0.5 * placed.size() * point.distance(other) + 1e-9);
            }
        }
    }

    #[test]
    fn anchors_in_one_line_do_no_harm() {
        for anchors in [&[][..], &[DVec2::ZERO; 4], &[DVec2::ZERO, DVec2::X, DVec2::X * 2.0]] {
            let placed = Sides::of(anchors, Affine2::IDENTITY).placed([DVec2::ONE; 4]);
            assert!(placed.at(DVec2::X).is_finite() && placed.size().is_finite());
        }
    }
}
