//! Where an attractor of space lies.

use std::collections::BinaryHeap;

use glam::{DMat3, DVec3};

use crate::bounds::support_table3::SupportTable3;
use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;
use crate::linear::transform::{lifting, lowered};
use crate::order::{Ranked, Total};

/// A box and a ball that hold an attractor of space, each tight to about a hundredth of its size where the maps are not
/// too many and not too slow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds3 {
    /// The least coordinates of the box.
    pub min: DVec3,
    /// The largest coordinates of the box.
    pub max: DVec3,
    /// The centre of the ball.
    pub centre: DVec3,
    /// The radius of the ball; 0 for an attractor that is one point.
    pub radius: f64,
    /// An upper bound of the diameter of the attractor.
    pub diameter: f64,
}

/// How hard bounds are looked for.
#[derive(Clone, Copy)]
struct Effort {
    /// Cells along an edge of the cube of directions.
    cells: usize,
    /// How near the support comes.
    support: f64,
    /// Pieces that are looked at for each bound.
    budget: usize,
    /// How near the bounds come, relative to the ball that is known.
    near: f64,
}

const FINE: Effort = Effort { cells: 8, support: 1e-5, budget: 6000, near: 2e-3 };
const COARSE: Effort = Effort { cells: 4, support: 1e-2, budget: 300, near: 3e-2 };

impl Bounds3 {
    /// The bounds of the attractor of `ifs`.
    #[must_use]
    pub fn of(ifs: &Ifs3) -> Self {
        Self::with(ifs, FINE)
    }

    /// Bounds as well, some hundredths wider and found many times faster: for what moves.
    #[must_use]
    pub fn coarse(ifs: &Ifs3) -> Self {
        Self::with(ifs, COARSE)
    }

    fn with(ifs: &Ifs3, effort: Effort) -> Self {
        let size = ifs.maps().iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max);
        let lift = lifting(size);
        if lift != 1.0 {
            let maps =
                ifs.maps().iter().map(|map| Affine3::new(map.linear, map.translation * lift)).collect();
            if let Ok(large) = Ifs3::new(maps) {
                return Self::with(&large, effort).lowered(lift);
            }
        }
        let contraction = ifs.contraction();
        let (to, from, unit) = (contraction.to_round, contraction.from_round, contraction.radius);
        let origin = contraction.centre;
        // A ball that is nothing but rounding is a point.
        let extent = ifs.maps().iter().map(|map| map.translation.length()).fold(origin.length(), f64::max);
        if unit <= 1e-14 * crate::linear::svd3::norm3(to) * extent {
            return Self { min: origin, max: origin, centre: origin, radius: 0.0, diameter: 0.0 };
        }
        let round = |map: &Affine3| {
            Affine3::new(to * map.linear * from, to * (map.apply(origin) - origin) * (1.0 / unit))
        };
        let maps: Vec<Affine3> = ifs.maps().iter().map(round).collect();
        let mut table = SupportTable3::default();
        table.set(&maps, contraction.factor, effort.cells, effort.support);
        let shape = Shape { maps: &maps, table: &table, linear: from * unit, effort };
        // Rounding in the round coordinates, and of these coordinates themselves.
        let slack = 1e-13 * (unit * crate::linear::svd3::norm3(from) + origin.abs().max_element());
        let high = [DVec3::X, DVec3::Y, DVec3::Z].map(|d| shape.support(d) + slack);
        let low = [DVec3::X, DVec3::Y, DVec3::Z].map(|d| -shape.support(-d) - slack);
        let points: Vec<DVec3> = table.points().iter().map(|&p| shape.linear * p).collect();
        let centre = middle(&points);
        let (min, max) = (DVec3::from_array(low), DVec3::from_array(high));
        // The box is around the ball as well.
        let corner = (max - centre).abs().max((min - centre).abs()).length();
        let radius = shape.reach(centre).min(corner) + slack;
        let diameter = table.diameter(shape.linear).min(2.0 * radius).min((max - min).length());
        Self { min: origin + min, max: origin + max, centre: origin + centre, radius, diameter }
    }
}

impl Bounds3 {
    fn lowered(self, lift: f64) -> Self {
        Self {
            min: self.min / lift,
            max: self.max / lift,
            centre: self.centre / lift,
            radius: lowered(self.radius, lift),
            diameter: lowered(self.diameter, lift),
        }
    }
}

/// The attractor in round coordinates; distances are measured after `linear`.
struct Shape<'a> {
    maps: &'a [Affine3],
    table: &'a SupportTable3,
    linear: DMat3,
    effort: Effort,
}

impl Shape<'_> {
    /// The largest `direction . linear x` over the attractor, from above.
    fn support(&self, direction: DVec3) -> f64 {
        let pulled = self.linear.transpose() * direction;
        self.most(
            |map| self.table.support(map.linear.transpose() * pulled) + map.translation.dot(pulled),
            |map| map.apply(self.table.point(map.linear.transpose() * pulled)).dot(pulled),
        )
    }

    /// The largest distance from `centre` over the attractor, from above.
    fn reach(&self, centre: DVec3) -> f64 {
        // A ball of less than 1 in round coordinates, around their origin.
        let held = (0..3)
            .map(|k| self.table.support(DVec3::AXES[k]).max(self.table.support(-DVec3::AXES[k])))
            .map(|h| h * h)
            .sum::<f64>();
        let held = held.sqrt().min(1.0);
        self.most(
            |map| {
                let away = self.linear * map.translation - centre;
                // Away from the centre the support says more than the ball, beside it the ball does.
                let size = crate::linear::svd3::norm3(self.linear * map.linear) * held;
                let length = away.length();
                let outward = map.linear.transpose()
                    * (self.linear.transpose() * (away / length.max(f64::MIN_POSITIVE)));
                let along = length + self.table.support(outward);
                (length + size).min(along.max(0.0).hypot(size))
            },
            |map| {
                let away = self.linear * map.translation - centre;
                let outward = map.linear.transpose() * (self.linear.transpose() * away);
                (self.linear * map.apply(self.table.point(outward))).distance(centre)
            },
        )
    }

    /// The largest of something over the attractor, by opening the piece that may have most: `bound` is from above, and
    /// `found` is what some point of it has.
    fn most(&self, bound: impl Fn(&Affine3) -> f64, found: impl Fn(&Affine3) -> f64) -> f64 {
        let whole = Affine3::IDENTITY;
        // Pieces, by an upper bound of what is sought in each.
        let mut heap = BinaryHeap::from([Ranked { key: Total(bound(&whole)), item: whole }]);
        let mut best = found(&whole);
        let near = self.effort.near * crate::linear::svd3::norm3(self.linear);
        for _ in 0..self.effort.budget / self.maps.len() {
            let Some(top) = heap.peek() else { break };
            if top.key.0 <= best + near {
                break;
            }
            let Some(Ranked { key: Total(above), item: map }) = heap.pop() else { break };
            for &letter in self.maps {
                let part = map * letter;
                best = best.max(found(&part));
                // A part has no more than the whole.
                heap.push(Ranked { key: Total(bound(&part).min(above)), item: part });
            }
        }
        heap.peek().map_or(best, |top| top.key.0.max(best))
    }
}

/// The centre of nearly the least ball around points (Badoiu & Clarkson 2003).
fn middle(points: &[DVec3]) -> DVec3 {
    let mut centre = points.iter().sum::<DVec3>() / points.len().max(1) as f64;
    for k in 0..400 {
        let far =
            points.iter().max_by(|a, b| a.distance_squared(centre).total_cmp(&b.distance_squared(centre)));
        if let Some(&far) = far {
            centre += (far - centre) / f64::from(k + 2);
        }
    }
    centre
}

#[cfg(test)]
mod tests {
    use glam::DQuat;
    use proptest::prelude::*;

    use super::*;
    use crate::testing3::{any_ifs3, orbit3};

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(48)))]
        #[test]
        fn everything_lies_within_and_little_is_left_over(ifs in any_ifs3()) {
            let bounds = Bounds3::of(&ifs);
            let orbit = orbit3(ifs.maps(), 9, 20_000);
            let mut far = 0.0_f64;
            for x in &orbit {
                let slack = 1e-9 * (1.0 + bounds.radius);
                prop_assert!(x.distance(bounds.centre) <= bounds.radius + slack);
                prop_assert!((*x - bounds.min).min_element() >= -slack && (bounds.max - *x).min_element() >= -slack);
                far = far.max(x.distance(bounds.centre));
            }
            // Orbits visit thin tips seldom, so that this is no sharp test.
            if ifs.contraction().factor < 0.7 {
                prop_assert!(bounds.radius <= 1.15 * far + 1e-6, "{} {far}", bounds.radius);
            }
        }
    }

    #[test]
    fn a_tetrahedron_has_its_own_box_and_ball() {
        // Every other corner of the cube from -1 to 1.
        let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
        let maps = corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, DVec3::from_array(c) * 0.5));
        let bounds = Bounds3::of(&Ifs3::new(maps.to_vec()).unwrap());
        assert!((bounds.max - DVec3::ONE).abs().max_element() < 1e-3, "{bounds:?}");
        assert!((bounds.min + DVec3::ONE).abs().max_element() < 1e-3, "{bounds:?}");
        assert!(bounds.centre.length() < 0.02 && (bounds.radius - 3.0_f64.sqrt()).abs() < 0.02, "{bounds:?}");
        let edge = 8.0_f64.sqrt();
        assert!(bounds.diameter >= edge && bounds.diameter < 1.1 * edge, "{bounds:?}");
        let point = Ifs3::new(vec![Affine3::scaling(DVec3::splat(0.5))]).unwrap();
        assert_eq!(Bounds3::of(&point).radius, 0.0);
    }

    #[test]
    fn coarse_bounds_hold_the_fine_ones_and_are_little_wider() {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        for ratio in [0.3, 0.5, 0.8] {
            let turned = |&c: &DVec3| {
                let turn = DQuat::from_axis_angle(DVec3::ONE.normalize(), c.x + 0.3);
                Affine3::similitude(ratio, turn, c)
            };
            let ifs = Ifs3::new(corners.iter().map(turned).collect()).unwrap();
            let (fine, coarse) = (Bounds3::of(&ifs), Bounds3::coarse(&ifs));
            let wider = coarse.radius / fine.radius;
            assert!((0.99..1.15).contains(&wider), "{ratio}: {wider}");
            for k in 0..3 {
                assert!(coarse.min[k] <= fine.min[k] + 5e-3 && coarse.max[k] >= fine.max[k] - 5e-3);
            }
        }
    }
}
