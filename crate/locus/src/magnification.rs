//! Magnification of shapes so small that the squares of lengths in them underflow, or so large that products of a few
//! overflow.

use frond_core::{Affine2, Affine3, DirectedMap};
use glam::{DVec2, DVec3};

use crate::verdict::{Bounded, Ellipse, Gap};

/// Below this the square of a gap, which is a small part of it, underflows.
const LEAST_SIZE: f64 = 1e-100;
/// Above this products of a few lengths overflow.
const LARGEST_SIZE: f64 = 1e80;
/// What is as large as this is refused.
const REFUSED_SIZE: f64 = 1e100;

/// A magnification, up or down, by a power of two, which changes no digit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Magnification {
    /// The power is their product: it need not be a number itself.
    factors: [f64; 2],
}

impl Magnification {
    /// The one that makes the longest translation about 1; `None` where none is needed.
    #[inline]
    pub fn of(maps: &[Affine2]) -> Option<Self> {
        Self::for_size(maps.iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max))
    }

    /// The same of the states of a graph-directed system.
    pub fn of_states(states: &[Vec<DirectedMap>]) -> Option<Self> {
        let sizes = states.iter().flatten().map(|part| part.map.translation.abs().max_element());
        Self::for_size(sizes.fold(0.0, f64::max))
    }

    /// The same in space.
    pub fn of3(maps: &[Affine3]) -> Option<Self> {
        Self::for_size(maps.iter().map(|map| map.translation.abs().max_element()).fold(0.0, f64::max))
    }

    #[inline]
    fn for_size(most: f64) -> Option<Self> {
        let fits = most == 0.0 || (LEAST_SIZE..=LARGEST_SIZE).contains(&most);
        (!fits && most < REFUSED_SIZE).then(|| {
            let power = -most.log2().floor() as i32;
            Self { factors: [power / 2, power - power / 2].map(|power| 2.0_f64.powi(power)) }
        })
    }

    pub fn magnify(self, maps: &[Affine2]) -> Vec<Affine2> {
        let large = |t: DVec2| t * self.factors[0] * self.factors[1];
        maps.iter().map(|map| Affine2::new(map.linear, large(map.translation))).collect()
    }

    pub fn magnify_states(self, states: &[Vec<DirectedMap>]) -> Vec<Vec<DirectedMap>> {
        let large = |part: &DirectedMap| {
            let translation = part.map.translation * self.factors[0] * self.factors[1];
            DirectedMap { map: Affine2::new(part.map.linear, translation), ..*part }
        };
        states.iter().map(|maps| maps.iter().map(large).collect()).collect()
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
    pub fn up(self, x: f64) -> f64 {
        let small = self.small(x);
        if self.large(small) < x { small.next_up() } else { small }
    }

    fn down(self, x: f64) -> f64 {
        let small = self.small(x);
        if self.large(small) > x { small.next_down() } else { small }
    }

    pub fn gap(self, gap: Gap) -> Gap {
        Gap { lower: self.down(gap.lower), upper: self.up(gap.upper) }
    }

    pub fn point3(self, p: DVec3) -> DVec3 {
        DVec3::from_array(p.to_array().map(|x| self.small(x)))
    }

    pub fn point(self, p: DVec2) -> DVec2 {
        DVec2::new(self.small(p.x), self.small(p.y))
    }

    /// A point as it is, digit for digit; `None` where no doubles hold it.
    pub fn exact_point(self, p: DVec2) -> Option<DVec2> {
        let here = self.point(p);
        (here * self.factors[0] * self.factors[1] == p).then_some(here)
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
}
