//! A closer look at shapes so small that the squares of lengths in them are no numbers.

use frond_core::{Affine2, Affine3};
use glam::{DVec2, DVec3};

use crate::connectedness::{Connectedness, Gap};
use crate::evidence::reason::Reason;
use crate::space::{Connectedness3, Reason3};
use crate::verdict::{Bounded, Ellipse};

/// Below this the square of a gap, a small part of it, vanishes.
const SMALL: f64 = 1e-100;

/// A magnification by a power of two: what is seen through it is the same, digit for digit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lens {
    /// The power is their product: it need not be a number itself.
    factors: [f64; 2],
}

impl Lens {
    /// The one through which the longest translation is about 1; `None` where none is needed.
    #[inline]
    pub fn of(maps: &[Affine2]) -> Option<Self> {
        Self::to_see(maps.iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max))
    }

    /// The same in space.
    pub fn of3(maps: &[Affine3]) -> Option<Self> {
        Self::to_see(maps.iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max))
    }

    #[inline]
    fn to_see(most: f64) -> Option<Self> {
        (0.0 < most && most < SMALL).then(|| {
            let power = -most.log2().floor() as i32;
            Self { factors: [power / 2, power - power / 2].map(|power| 2.0_f64.powi(power)) }
        })
    }

    pub fn magnify(self, maps: &[Affine2]) -> Vec<Affine2> {
        let large = |t: DVec2| t * self.factors[0] * self.factors[1];
        maps.iter().map(|map| Affine2::new(map.linear, large(map.translation))).collect()
    }

    pub fn magnify3(self, maps: &[Affine3]) -> Vec<Affine3> {
        let large = |t: DVec3| t * self.factors[0] * self.factors[1];
        maps.iter().map(|map| Affine3::new(map.linear, large(map.translation))).collect()
    }

    fn large(self, x: f64) -> f64 {
        x * self.factors[0] * self.factors[1]
    }

    /// A length as it is, to the nearest number.
    fn small(self, x: f64) -> f64 {
        x / self.factors[0] / self.factors[1]
    }

    /// The same, not below; above what is lost in the last digit there is.
    fn up(self, x: f64) -> f64 {
        let small = self.small(x);
        if self.large(small) < x { small.next_up() } else { small }
    }

    fn down(self, x: f64) -> f64 {
        let small = self.small(x);
        if self.large(small) > x { small.next_down() } else { small }
    }

    fn gap(self, gap: Gap) -> Gap {
        Gap { lower: self.down(gap.lower), upper: self.up(gap.upper) }
    }

    fn point3(self, p: DVec3) -> DVec3 {
        DVec3::from_array(p.to_array().map(|x| self.small(x)))
    }

    fn point(self, p: DVec2) -> DVec2 {
        DVec2::new(self.small(p.x), self.small(p.y))
    }

    /// What was found out about the magnified maps, in the units of those that were given.
    pub fn bounded(self, seen: Bounded) -> Bounded {
        let diameter = self.up(seen.diameter);
        // Relative to a diameter that was rounded up, all is less.
        let whole = self.large(diameter);
        let lower = if whole > seen.diameter {
            seen.lower * (seen.diameter / whole) * (1.0 - 1e-15)
        } else {
            seen.lower
        };
        let ellipse = seen.ellipse.map(|ellipse| Ellipse {
            centre: self.point(ellipse.centre),
            to_round: ellipse.to_round * self.factors[0] * self.factors[1],
            from_round: ellipse.from_round * (1.0 / self.factors[0]) * (1.0 / self.factors[1]),
            ..ellipse
        });
        let ellipse = ellipse.filter(|ellipse| ellipse.to_round.is_finite());
        Bounded { lower, diameter, ellipse, ..seen }
    }

    /// The same for the full answer. A reason that takes numbers for others is about those that were given, not these.
    pub fn connectedness(self, seen: Connectedness) -> Connectedness {
        let mut reason = seen.reason.filter(Reason::is_proof);
        for link in reason.iter_mut().flat_map(|reason| &mut reason.links) {
            link.at = self.point(link.at);
            link.corners.iter_mut().for_each(|corner| *corner = self.point(*corner));
        }
        Connectedness {
            gap: self.gap(seen.gap),
            closest: seen.closest.map(|(p, q)| (self.point(p), self.point(q))),
            diameter: self.up(seen.diameter),
            reason,
            ..seen
        }
    }

    /// The same in space.
    pub fn connectedness3(self, seen: Connectedness3) -> Connectedness3 {
        let mut reason = seen.reason.filter(Reason3::is_proof);
        for shared in reason.iter_mut().flat_map(|reason| &mut reason.points) {
            shared.at = self.point3(shared.at);
        }
        Connectedness3 {
            gap: self.gap(seen.gap),
            closest: seen.closest.map(|(p, q)| (self.point3(p), self.point3(q))),
            diameter: self.up(seen.diameter),
            reason,
            ..seen
        }
    }
}
