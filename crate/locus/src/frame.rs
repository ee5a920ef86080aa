//! Coordinates to search in: centred on the attractor, of its size, and such that the maps contract.

use frond_core::{Affine2, Contraction, IfsError};
use glam::{DMat2, DVec2};

use crate::exact::double_double::DoubleDouble;
use crate::support::extremes::larger;
use crate::verdict::Ellipse;

/// Where the search takes place. The attractor lies in the unit disc of these coordinates.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    /// The maps in these coordinates.
    pub maps: Vec<Affine2>,
    /// From here to the plane; one unit here is of about the attractor's size.
    pub from_round: DMat2,
    /// Its inverse.
    pub to_round: DMat2,
    /// The point of the plane that is 0 here.
    pub origin: DVec2,
    /// The metric of the plane, pulled back: a step `d` here is `sqrt(d . metric d)` long in the plane, roughly. Of
    /// flat shapes this cancels most digits, so that bounds take `from_round * d` instead.
    pub metric: DMat2,
    /// Whether distances here are those of the plane, but for a factor.
    pub plain: bool,
    /// The largest factor by which a distance here grows in the plane.
    pub stretch: f64,
    /// How far the support values of a computed piece may be off, here, through rounding: that of the
    /// given coefficients, of this conjugation and of products along words.
    pub rounding: f64,
    /// How far a computed point of the attractor of the maps as given may be off, here: what [`Frame::rounding`] is
    /// without the rounding of the coefficients, which grows as shapes get flat.
    pub error: f64,
    /// The contraction factor of a map, or of a block of maps.
    pub factor: f64,
    /// The letters of the longest block.
    pub length: usize,
    /// All of the attractor is one point, as far as floating point can tell.
    pub point: bool,
    /// What was found of other maps.
    found: FoundBefore,
}

/// Below this operator norm the plane's own coordinates are good enough.
const PLAIN_FACTOR: f64 = 0.97;

impl Default for Frame {
    fn default() -> Self {
        Self {
            maps: Vec::new(),
            from_round: DMat2::IDENTITY,
            to_round: DMat2::IDENTITY,
            origin: DVec2::ZERO,
            metric: DMat2::IDENTITY,
            plain: true,
            stretch: 1.0,
            rounding: 0.0,
            error: 0.0,
            factor: 0.0,
            length: 1,
            point: true,
            found: FoundBefore::default(),
        }
    }
}

impl Frame {
    /// Sets the frame up for raw maps; the cheap test first, [`Contraction::find`] where it fails.
    pub fn set(&mut self, maps: &[Affine2]) -> Result<(), IfsError> {
        self.set_like(maps, None).map(|_| ())
    }

    /// [`Frame::set`], in the coordinates of maps `like` these if they serve; returns those that were used, where they
    /// are not the plane's own.
    pub fn set_like(
        &mut self,
        maps: &[Affine2],
        like: Option<&Contraction>,
    ) -> Result<Option<Contraction>, IfsError> {
        let fits = |x: f64| x.abs() < 1e100;
        let plain =
            |map: &Affine2| map.norm() < PLAIN_FACTOR && fits(map.translation.x) && fits(map.translation.y);
        // Comparisons with NaN are false, so that bad numbers go the long way and get their message.
        if !maps.is_empty() && maps.iter().all(plain) {
            self.set_plain(maps);
            return Ok(None);
        }
        let found = match like.and_then(|like| Contraction::in_coordinates_of(like, maps)) {
            Some(found) => found,
            None => self.found.find(maps)?,
        };
        self.set_round(maps, &found);
        Ok(Some(found))
    }

    fn set_plain(&mut self, maps: &[Affine2]) {
        let factor = maps.iter().fold(0.0, |most, map| larger(most, map.norm()));
        let origin = mean_point(maps);
        let shift = maps.iter().map(|map| map.apply(origin).distance(origin)).fold(0.0, larger);
        let radius = shift / (1.0 - factor) * (1.0 + 1e-12);
        self.place(maps, DMat2::IDENTITY, DMat2::IDENTITY, origin, radius);
        self.factor = factor;
        self.length = 1;
        self.rounding = ROUNDING_UNIT * (1.0 + origin.length() / radius) / (1.0 - factor);
        self.error = self.rounding;
    }

    /// Sets the frame up in coordinates that are known to make the maps contract.
    pub fn set_round(&mut self, maps: &[Affine2], found: &Contraction) {
        let Contraction { to_round: to, from_round: from, factor, length, centre, radius } = *found;
        self.place(maps, to, from, centre, radius);
        self.factor = factor;
        self.length = length;
        let stretch = |m: DMat2| Affine2::new(m, DVec2::ZERO).norm();
        // The condition number is what the coefficients' rounding costs; longer blocks may grow before they shrink.
        let condition = stretch(to) * stretch(from);
        let growth = self.maps.iter().fold(1.0, |most, map| larger(most, map.norm()));
        let spread = length as f64 * growth.powi(length as i32 - 1) / (1.0 - factor);
        let size = 1.0 + (to * centre).length() / radius;
        self.rounding = ROUNDING_UNIT * condition * size * growth * spread;
        // The conjugation costs as much only where it is computed in doubles.
        self.error = if self.plain { self.rounding } else { ROUNDING_UNIT * growth * spread };
    }

    /// The same for maps that leave one point where it is, at the distance of that point from 0, or 1 if it is 0.
    pub fn set_about_point(&mut self, maps: &[Affine2], found: &Contraction) {
        let away = (found.to_round * found.centre).length();
        self.set_round(maps, &Contraction { radius: if away > 0.0 { away } else { 1.0 }, ..found.clone() });
    }

    fn place(&mut self, maps: &[Affine2], to: DMat2, from: DMat2, origin: DVec2, radius: f64) {
        self.origin = origin;
        let extent = origin.length().max(maps.iter().map(|m| m.translation.length()).fold(0.0, f64::max));
        // A disc that is nothing but rounding is a point.
        self.point = radius <= 1e-14 * (to * DVec2::splat(extent)).length();
        let unit = if self.point { 1.0 } else { radius };
        self.from_round = from * unit;
        self.metric = self.from_round.transpose() * self.from_round;
        self.plain = to == DMat2::IDENTITY;
        self.maps.clear();
        if self.plain {
            self.to_round = to * (1.0 / unit);
            self.stretch = unit;
            self.maps.extend(maps.iter().map(|map| {
                let translation = to * (map.apply(origin) - origin) * (1.0 / unit);
                Affine2::new(to * map.linear * from, translation)
            }));
        } else {
            let seen = Seen::through(self.from_round);
            self.to_round = seen.to_round();
            self.stretch = Affine2::new(self.from_round, DVec2::ZERO).norm();
            self.maps.extend(maps.iter().map(|map| seen.map(map, origin)));
        }
    }

    /// These coordinates, drawn `aspect` times as long along a unit vector.
    pub fn drawn(&self, along: DVec2, aspect: f64) -> Self {
        let stretched = |by: f64| {
            let square = DMat2::from_cols(along * along.x, along * along.y);
            DMat2::IDENTITY + square * (by - 1.0)
        };
        let (to, from) = (stretched(aspect), stretched(1.0 / aspect));
        let from_round = self.from_round * from;
        let to_round = to * self.to_round;
        let maps = self.maps.iter().map(|map| Affine2::new(to * map.linear * from, to * map.translation));
        Self {
            maps: maps.collect(),
            from_round,
            to_round,
            metric: from_round.transpose() * from_round,
            plain: false,
            stretch: Affine2::new(from_round, DVec2::ZERO).norm(),
            // That of this conjugation, and of products of maps that are longer here.
            rounding: self.rounding * aspect * aspect,
            error: self.error * aspect * aspect,
            found: FoundBefore::default(),
            ..*self
        }
    }

    /// Points of the plane within this distance are not told apart: `epsilon` of the diameter, or as near as
    /// rounding lets one see, unless rounding has become coarse itself.
    pub fn resolution(&self, epsilon: f64, diameter: f64) -> f64 {
        (epsilon * diameter).max((4.0 * self.rounding * self.stretch).min(1e-9 * diameter))
    }

    /// The square of the length, in the plane, of a step here.
    #[inline(always)]
    pub fn square(&self, step: DVec2) -> f64 {
        (self.from_round * step).length_squared()
    }

    /// By how much the distance of two computed points of the attractor may be off, in the plane, at most.
    pub fn off(&self) -> f64 {
        2.0 * self.error * self.stretch
    }

    /// An upper bound of the distance in the plane of two points of the attractor, computed to be `length` apart there,
    /// and `step` here.
    pub fn farthest(&self, length: f64, step: DVec2) -> f64 {
        const UP: f64 = 1.0 + 4.0 * f64::EPSILON;
        let off = self.off();
        // What rounding moves along a flat shape lengthens a step across it by its square only.
        let direction = (self.from_round * step).normalize_or_zero();
        let along = 2.0 * self.error * (self.from_round.transpose() * direction).length();
        let turned = 8.0 * f64::EPSILON * self.stretch * step.length();
        let flat = (length + along + turned).hypot(off + turned) * UP;
        flat.min(length * UP + off)
    }

    /// An upper bound of the attractor's diameter in the plane, from one that is computed. It lies in the unit disc.
    pub fn diameter(&self, computed: f64) -> f64 {
        let off = 2.0 * self.rounding * self.stretch;
        (computed + off).min(2.0 * self.stretch) * (1.0 + 4.0 * f64::EPSILON)
    }

    /// Where the attractor lies.
    pub fn ellipse(&self) -> Ellipse {
        Ellipse {
            centre: self.origin,
            to_round: self.to_round,
            from_round: self.from_round,
            factor: self.factor,
            length: self.length,
        }
    }

    /// The point of the plane that is `p` here.
    pub fn to_plane(&self, p: DVec2) -> DVec2 {
        self.origin + self.from_round * p
    }
}

/// The coordinates of maps, by their linear parts. A column of a morph's locus has the same in all of its samples.
#[derive(Clone, Debug, Default)]
struct FoundBefore {
    /// The linear parts, and what was found: `None` where it is unknown whether they contract.
    all: Vec<(Vec<DMat2>, Option<Contraction>)>,
    /// The one to be forgotten next.
    oldest: usize,
}

/// As many columns as a tile has, and more.
const MOST_REMEMBERED: usize = 128;

impl FoundBefore {
    /// [`Contraction::find`], at once for linear parts that were seen before.
    fn find(&mut self, maps: &[Affine2]) -> Result<Contraction, IfsError> {
        let bits = |m: DMat2| m.to_cols_array().map(f64::to_bits);
        let is_this = |linear: &[DMat2]| {
            linear.len() == maps.len() && linear.iter().zip(maps).all(|(&m, map)| bits(m) == bits(map.linear))
        };
        match self.all.iter().find(|(linear, _)| is_this(linear)) {
            Some((_, Some(found))) => {
                if let Some(moved) = found.moved(maps) {
                    return Ok(moved);
                }
            }
            // Other numbers have another message.
            Some((_, None)) if maps.iter().all(|map| map.translation.abs().max_element() < 1e100) => {
                return Err(IfsError::Unproved);
            }
            _ => {}
        }
        let found = Contraction::find(maps);
        let known = match &found {
            Ok(found) if found.length == 1 => Some(found.clone()),
            Err(IfsError::Unproved) => None,
            _ => return found,
        };
        let one = (maps.iter().map(|map| map.linear).collect(), known);
        if self.all.len() < MOST_REMEMBERED {
            self.all.push(one);
        } else {
            self.all[self.oldest] = one;
            self.oldest = (self.oldest + 1) % MOST_REMEMBERED;
        }
        found
    }
}

/// The plane seen in coordinates that `from` takes back to it. Of flat shapes these cancel the digits of the maps
/// twice: all is computed in some 32.
struct Seen {
    from: DMat2,
    determinant: DoubleDouble,
}

impl Seen {
    fn through(from: DMat2) -> Self {
        let DMat2 { x_axis: x, y_axis: y } = from;
        Self { from, determinant: DoubleDouble::product(x.x, y.y) - DoubleDouble::product(x.y, y.x) }
    }

    /// A step of the plane, here.
    fn step(&self, [x, y]: [DoubleDouble; 2]) -> DVec2 {
        let DMat2 { x_axis: a, y_axis: b } = self.from;
        DVec2::new((x * b.y - y * b.x).over(self.determinant), (y * a.x - x * a.y).over(self.determinant))
    }

    fn to_round(&self) -> DMat2 {
        let [zero, one] = [0.0, 1.0].map(DoubleDouble::from);
        DMat2::from_cols(self.step([one, zero]), self.step([zero, one]))
    }

    fn map(&self, map: &Affine2, origin: DVec2) -> Affine2 {
        let DMat2 { x_axis: a, y_axis: b } = map.linear;
        let image = |v: DVec2| {
            let row = |a: f64, b: f64| DoubleDouble::product(a, v.x) + DoubleDouble::product(b, v.y);
            [row(a.x, b.x), row(a.y, b.y)]
        };
        let linear = DMat2::from_cols(self.step(image(self.from.x_axis)), self.step(image(self.from.y_axis)));
        let [x, y] = image(origin);
        let (o, t) = (origin, map.translation);
        let moved = |x: DoubleDouble, t: f64, o: f64| x + (DoubleDouble::from(t) - DoubleDouble::from(o));
        Affine2::new(linear, self.step([moved(x, t.x, o.x), moved(y, t.y, o.y)]))
    }
}

/// A few times the error of one rounding; see [`Frame::rounding`].
const ROUNDING_UNIT: f64 = 24.0 * f64::EPSILON;

/// The fixed point of the mean of the maps: the middle of the attractor, each map weighed alike.
fn mean_point(maps: &[Affine2]) -> DVec2 {
    let mut mean = Affine2::new(DMat2::ZERO, DVec2::ZERO);
    for map in maps {
        mean.linear += map.linear;
        mean.translation += map.translation;
    }
    let share = 1.0 / maps.len() as f64;
    let mean = Affine2::new(mean.linear * share, mean.translation * share);
    mean.fixed_point().unwrap_or(DVec2::ZERO)
}

#[cfg(test)]
mod tests {
    use frond_core::hash;

    use super::*;

    /// Three turned or mirrored similitudes, seen in coordinates sheared and turned.
    fn sheared(seed: u32, shear: f64) -> Option<Vec<Affine2>> {
        let number = |k: u32| f64::from(hash::counter(seed, k)) / f64::from(u32::MAX);
        let by = Affine2::similitude(1.0, 6.3 * number(0), DVec2::new(3.0, -2.0))
            * Affine2::from_row([1.0, shear, 0.0, 1.0, 0.0, 0.0]);
        let map = |k: u32| {
            let [ratio, angle, x, y] = [1, 2, 3, 4].map(|i| number(10 * k + i));
            let mirror = DMat2::from_diagonal(DVec2::new(1.0, if k == 1 { -1.0 } else { 1.0 }));
            let linear = DMat2::from_angle(6.3 * angle) * mirror * (0.2 + 0.4 * ratio);
            Affine2::new(linear, DVec2::new(x, y)).conjugate(by)
        };
        (1..4).map(map).collect()
    }

    #[test]
    fn what_was_found_before_changes_nothing() {
        let mut frame = Frame::default();
        let shifts = [DVec2::ZERO, DVec2::new(3.0, -1.0), DVec2::X * 1e200, DVec2::NAN, DVec2::Y];
        let neutral = |angle: f64| Affine2::similitude(0.999_999_999_5, angle, DVec2::X);
        let (mut coordinates, mut errors) = (0, Vec::new());
        // More systems than are remembered, each three times.
        for seed in (0..200).flat_map(|seed| [seed, seed, seed / 2]) {
            let mut maps = match seed % 40 {
                0 => vec![neutral(f64::from(seed)), neutral(1.0)],
                _ => sheared(seed, 30.0).unwrap_or_default(),
            };
            for shift in shifts {
                maps.iter_mut().for_each(|map| map.translation += shift);
                let (fresh, found) = (Frame::default().set_like(&maps, None), frame.set_like(&maps, None));
                coordinates += usize::from(matches!(fresh, Ok(Some(_))));
                if let Err(error) = &fresh {
                    errors.push(error.code());
                }
                assert_eq!(format!("{found:?}"), format!("{fresh:?}"), "{seed}");
            }
        }
        errors.sort_unstable();
        errors.dedup();
        assert!(coordinates > 1000 && errors.contains(&"attractor-unproved"), "{coordinates}, {errors:?}");
        assert!(frame.found.all.len() <= MOST_REMEMBERED);
    }

    #[test]
    fn no_two_points_are_farther_apart_than_computed_and_rounding_says() {
        let mut tried = 0;
        for seed in 0..200 {
            let shear = 10.0_f64.powf(f64::from(seed % 11) * 0.3);
            let Some(maps) = sheared(seed, shear) else { continue };
            let mut frame = Frame::default();
            if frame.set(&maps).is_err() || frame.length > 1 {
                continue;
            }
            // The images of the origin under a word, here and, in twice the digits, in the plane.
            let word = |k: u32| {
                let letters = (0..1 + k % 12).map(|i| hash::counter(seed, 1000 + 20 * k + i) as usize % 3);
                let [x, y] = [frame.origin.x, frame.origin.y].map(DoubleDouble::from);
                letters.fold((DVec2::ZERO, x, y), |(here, x, y), i| {
                    let [a, b, c, d, e, f] = maps[i].to_row();
                    let row = |a: f64, b: f64, e: f64| x * a + y * b + DoubleDouble::from(e);
                    (frame.maps[i].apply(here), row(a, b, e), row(c, d, f))
                })
            };
            for k in 0..40 {
                let ((from, x, y), (to, u, v)) = (word(2 * k), word(2 * k + 1));
                let double = |x: DoubleDouble| x.over(DoubleDouble::from(1.0));
                let exact = double(u - x).hypot(double(v - y)) * (1.0 - 1e-15);
                let step = to - from;
                let most = frame.farthest((frame.from_round * step).length(), step);
                let context = format!("{seed}, {k}: {exact:e} {most:e}, shear {shear}");
                assert!(exact <= most, "{context}");
                // And not by much: where the two are apart by more than the coordinates' last digits.
                assert!(most <= 1.001 * exact || exact < 1e-12 * frame.stretch, "{context}");
                tried += 1;
            }
        }
        assert!(tried > 6000, "{tried}");
    }
}
