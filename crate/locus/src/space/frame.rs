//! Coordinates to search in: centred on the attractor, of its size, and such that the maps contract.

use frond_core::{Affine3, Contraction3, IfsError};
use glam::{DMat3, DVec3};

/// Where the search takes place. The attractor lies in the unit ball of these coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Frame3 {
    /// The maps in these coordinates.
    pub maps: Vec<Affine3>,
    /// From here to space.
    pub linear: DMat3,
    /// Takes the normals of planes to space: the inverse, transposed.
    pub normal: DMat3,
    /// How far a normal that is taken to space may be off there, against the sum of its sides here.
    pub blur: f64,
    /// The point of space that is 0 here.
    pub origin: DVec3,
    /// The metric of space, pulled back, but for a factor: which directions show a distance best.
    pub metric: DMat3,
    /// The largest factor by which a distance here grows in space.
    pub stretch: f64,
    /// How far a computed piece may be off, here, through rounding: that of the given coefficients, of this conjugation
    /// and of products along words.
    pub rounding: f64,
    /// The contraction factor of a map, or of a block of maps.
    pub factor: f64,
    /// All of the attractor is one point, as far as floating point can tell.
    pub point: bool,
}

impl Default for Frame3 {
    fn default() -> Self {
        Self {
            maps: Vec::new(),
            linear: DMat3::IDENTITY,
            normal: DMat3::IDENTITY,
            blur: 0.0,
            origin: DVec3::ZERO,
            metric: DMat3::IDENTITY,
            stretch: 1.0,
            rounding: 0.0,
            factor: 0.0,
            point: true,
        }
    }
}

/// Below this operator norm the coordinates of space are good enough.
const PLAIN_FACTOR: f64 = 0.9;
/// A few times the error of one rounding; see [`Frame3::rounding`].
const ROUNDING_UNIT: f64 = 48.0 * f64::EPSILON;

impl Frame3 {
    /// Sets the frame up for raw maps; the cheap test first, [`Contraction3::find`] where it fails.
    pub fn set(&mut self, maps: &[Affine3]) -> Result<(), IfsError> {
        let fits = |map: &Affine3| map.norm() < PLAIN_FACTOR && map.translation.abs().max_element() < 1e100;
        // Comparisons with NaN are false, so that bad numbers go the long way and get their message.
        if !maps.is_empty() && maps.len() <= frond_core::MAX_MAPS && maps.iter().all(fits) {
            let factor = maps.iter().map(|map| map.norm()).fold(0.0, f64::max) * (1.0 + 1e-13);
            let origin = mean_point(maps);
            let shift = maps.iter().map(|map| map.apply(origin).distance(origin)).fold(0.0, f64::max);
            let radius = shift / (1.0 - factor) * (1.0 + 1e-12);
            self.place(maps, DMat3::IDENTITY, DMat3::IDENTITY, origin, radius);
            self.factor = factor;
            self.rounding = ROUNDING_UNIT * (1.0 + origin.length() / radius) / (1.0 - factor);
        } else {
            self.set_round(maps, &Contraction3::find(maps)?);
        }
        Ok(())
    }

    /// Sets the frame up in coordinates that are known to make the maps contract.
    pub fn set_round(&mut self, maps: &[Affine3], found: &Contraction3) {
        let Contraction3 { to_round: to, from_round: from, factor, length, centre, radius } = *found;
        self.place(maps, to, from, centre, radius);
        self.factor = factor;
        // The condition number is what the conjugation costs; longer blocks may grow before they shrink.
        let condition = norm(to) * norm(from);
        let growth = self.maps.iter().fold(1.0_f64, |most, map| most.max(map.norm()));
        let spread = length as f64 * growth.powi(length as i32 - 1) / (1.0 - factor);
        let size = 1.0 + (to * centre).length() / radius;
        self.rounding = ROUNDING_UNIT * condition * size * growth * spread;
    }

    fn place(&mut self, maps: &[Affine3], to: DMat3, from: DMat3, origin: DVec3, radius: f64) {
        self.origin = origin;
        let extent = origin.length().max(maps.iter().map(|m| m.translation.length()).fold(0.0, f64::max));
        // A ball that is nothing but rounding is a point.
        self.point = radius <= 1e-14 * (to * DVec3::splat(extent)).length();
        let unit = if self.point { 1.0 } else { radius };
        self.linear = from * unit;
        self.normal = to.transpose() * (1.0 / unit);
        let sides = [self.normal.x_axis, self.normal.y_axis, self.normal.z_axis];
        self.blur =
            ROUNDING_UNIT * sides.map(|side| side.abs().max_element()).into_iter().fold(0.0, f64::max);
        self.blur *= norm(to) * norm(from);
        self.stretch = if from == DMat3::IDENTITY { unit } else { norm(self.linear) };
        // Of size 1, or of small shapes the squares of what is seen would vanish.
        let round = self.linear * (1.0 / self.stretch);
        self.metric = round.transpose() * round;
        self.maps.clear();
        self.maps.extend(maps.iter().map(|map| {
            let translation = to * (map.apply(origin) - origin) * (1.0 / unit);
            Affine3::new(to * map.linear * from, translation)
        }));
    }

    /// Points of space within this distance are not told apart: `epsilon` of the diameter, or as near as rounding
    /// lets one see, unless rounding has become coarse itself.
    pub fn resolution(&self, epsilon: f64, diameter: f64) -> f64 {
        (epsilon * diameter).max((4.0 * self.rounding * self.stretch).min(1e-9 * diameter))
    }

    /// The point of space that is `p` here.
    pub fn to_space(&self, p: DVec3) -> DVec3 {
        self.origin + self.linear * p
    }
}

fn norm(m: DMat3) -> f64 {
    Affine3::new(m, DVec3::ZERO).norm()
}

/// The fixed point of the mean of the maps: the middle of the attractor, each map weighed alike.
fn mean_point(maps: &[Affine3]) -> DVec3 {
    let mut mean = Affine3::new(DMat3::ZERO, DVec3::ZERO);
    for map in maps {
        mean.linear += map.linear;
        mean.translation += map.translation;
    }
    let share = 1.0 / maps.len() as f64;
    let mean = Affine3::new(mean.linear * share, mean.translation * share);
    mean.fixed_point().unwrap_or(DVec3::ZERO)
}
