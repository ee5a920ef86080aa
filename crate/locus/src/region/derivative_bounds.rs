//! How far attractors move over a box of parameters.
//!
//! A point of the attractor with a fixed address, `x(p) = w_a(p) w_b(p) w_c(p) ..`, is a smooth function of the
//! parameters p. Along an axis, with `w'(x) = L' x + t'` and so on, and with bounds that are valid for every parameter
//! of the box and every point of its attractors:
//!
//! ```text
//! x    = w_a(y)                                    |x|    <= r
//! x'   = w_a'(y) + L_a y'                          |x'|   <= r1
//! x''  = w_a''(y) + 2 L_a' y' + L_a y''            |x''|  <= r2
//! x''' = w_a'''(y) + 3 L_a'' y' + 3 L_a' y'' + ..  |x'''| <= r3
//!
//! r1 = max (|L'| r + |t'|)                               / (1 - |L|)
//! r2 = max (|L''| r + |t''| + 2 |L'| r1)                 / (1 - |L|)
//! r3 = max (|L'''| r + |t'''| + 3 |L''| r1 + 3 |L'| r2)  / (1 - |L|)
//! ```
//!
//! `r1` times half the width of the box bounds the Hausdorff distance from the middle. It is linear in the width, and
//! mostly tells of motions that all pieces make alike. More is gained by looking at the systems on the edge of the box,
//! its *lanes*: left, middle and right along x, below and above along y.
//!
//! Let f be smooth on an interval of half width h, with values l, m, r at its left, middle and right. If `f'' <= b`,
//! f lies nowhere lower than `min(l, m, r) - b h^2 / 8`. And with `c = l - 2 m + r` and `|f'''| <= k`, there is `b
//! h^2 <= c + k h^3`; or, from the parabola through the three values, f lies nowhere lower than `min(l, r) - c / 2 -
//! 0.0642 k h^3` where `c > 0`. So whatever is linear in points of the attractors (how far one is from another, or
//! from a hull, along a direction) is known over the box but for a *dip*, of the third order where c is known: the
//! same direction and the same addresses must serve in all lanes. For the points `w_u(y)` of a whole piece,
//!
//! ```text
//! c(w_u(y)) = c(t_u) + c(L_u) y_m + (L_r - L_l) (y_r - y_l) / 2 + (L_r + L_l) c(y) / 2
//! |c(w_u(y)) - c(t_u)| <= |c(L_u)| r + |L_r - L_l| h r1 + (|L_r| + |L_l|) h^2 r2 / 2
//! ```
//!
//! Along y the lanes are two, and the dip is `h^2 r2 / 2` for each point: 0 along v, as the points of a morph are
//! linear in its translations.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::family::{Drift, Family};
use crate::frame::Frame;
use crate::region::extent::Extent;
use crate::support::extremes::{larger, lesser};
use crate::support::lanes::{Maps, Points, SupportLanes};

/// The systems of the lanes, in coordinates that serve all of a box: the attractors of every parameter of it lie
/// in the unit disc, and all maps contract.
#[derive(Clone, Debug)]
pub(crate) struct Lanes<const L: usize> {
    pub maps: Vec<Maps<L>>,
    /// The operator norm of each map over the box, at most.
    pub norms: Vec<f64>,
    /// The dip of a point: along x without knowing c, and along y.
    dip: f64,
    still: f64,
    /// `h^3 r3` along x, for a point.
    jerk: f64,
    /// `r`, `h r1` and `h^2 r2` along x.
    sizes: [f64; 3],
    /// How far computed points and support values may be off, through rounding, and whatever is not known of the maps.
    pub rounding: f64,
    /// From here to the plane.
    pub from_round: DMat2,
    pub origin: DVec2,
    /// Whether distances here are those of the plane but for a factor.
    pub plain: bool,
    /// The largest of the norms.
    pub factor: f64,
    /// The factor by which each map changes areas over the box, at least.
    pub areas: Vec<f64>,
    /// How far points move from the middle of the box, at most.
    stray: f64,
    bounds: [Vec<Bound>; 2],
    half: DVec2,
    raw: Vec<Affine2>,
    drifts: Vec<Drift>,
}

/// What is known about the change of one map along one axis: the derivatives of its linear part and its translation.
#[derive(Clone, Copy, Debug)]
struct Bound {
    linear: [f64; 3],
    shift: [f64; 3],
}

impl<const L: usize> Default for Lanes<L> {
    fn default() -> Self {
        Self {
            maps: Vec::new(),
            norms: Vec::new(),
            dip: 0.0,
            still: 0.0,
            jerk: 0.0,
            sizes: [0.0; 3],
            rounding: 0.0,
            from_round: DMat2::IDENTITY,
            origin: DVec2::ZERO,
            plain: true,
            factor: 0.0,
            areas: Vec::new(),
            stray: 0.0,
            bounds: [Vec::new(), Vec::new()],
            half: DVec2::ZERO,
            raw: Vec::new(),
            drifts: Vec::new(),
        }
    }
}

fn norm(linear: DMat2) -> f64 {
    Affine2::new(linear, DVec2::ZERO).norm()
}

/// More than the errors of a few operations, relative to their result.
const ROUND_UP: f64 = 1.0 + 1e-12;
/// `max (t - t^3) / 6`, rounded up.
const CUBIC_DIP: f64 = 0.064_151;

impl<const L: usize> Lanes<L> {
    /// Sets the lanes up for a family over a box; `false` if its maps are not seen to contract everywhere in the
    /// coordinates that suit its middle.
    pub fn set<F: Family + ?Sized>(&mut self, family: &F, extent: Extent, frame: &mut Frame) -> bool {
        let Extent { middle, half } = extent;
        family.fill(middle.x, middle.y, &mut self.raw);
        if !extent.is_usual() || frame.set(&self.raw).is_err() || frame.point || frame.length != 1 {
            return false;
        }
        let (to, from) = (frame.to_round, frame.from_round);
        let (size_to, size_from) = (norm(to), norm(from));
        // Seen from the frame, a motion of the plane is so many times larger: 1 where the frame is plain.
        let condition = if frame.plain { 1.0 } else { size_to * size_from };
        let away = frame.origin.length();
        self.half = half;
        for (axis, bounds) in self.bounds.iter_mut().enumerate() {
            let half = half[axis];
            bounds.clear();
            if half == 0.0 {
                continue;
            }
            family.drift(axis, middle, half, &mut self.drifts);
            bounds.extend(self.drifts.iter().map(|drift| {
                let Drift { speed, bend, sway, jerk } = *drift;
                let (linear, shift) = (condition * bend, size_to * (bend * away + sway));
                let first = norm(to * speed.linear * from) + half * linear;
                let moved = (to * speed.apply(frame.origin)).length() + half * shift;
                Bound {
                    linear: [first * ROUND_UP, linear * ROUND_UP, condition * jerk * ROUND_UP],
                    shift: [moved * ROUND_UP, shift * ROUND_UP, size_to * jerk * away * ROUND_UP],
                }
            }));
        }
        self.place(family, extent, frame) && self.widen(family.seam(), size_to, size_from, away, frame)
    }

    /// The lanes' systems in the coordinates of the frame, and the norms.
    fn place<F: Family + ?Sized>(&mut self, family: &F, extent: Extent, frame: &Frame) -> bool {
        let (to, from) = (frame.to_round, frame.from_round);
        self.maps.clear();
        self.maps.resize(frame.maps.len(), [Affine2::IDENTITY; L]);
        for l in 0..L {
            let place = extent.place::<L>(l);
            family.fill(place.x, place.y, &mut self.raw);
            for (lanes, map) in self.maps.iter_mut().zip(&self.raw) {
                let shift = to * (map.apply(frame.origin) - frame.origin);
                lanes[l] = Affine2::new(to * map.linear * from, shift);
            }
        }
        self.norms.clear();
        self.areas.clear();
        for (i, lanes) in self.maps.iter().enumerate() {
            let bent = self.bent(i, |bound| bound.linear[1]);
            let most = lanes.iter().map(|map| map.norm()).fold(0.0, larger);
            self.norms.push((most + bent) * ROUND_UP);
            // (det L)'' is 2 det L' and no more than 2 |L| |L''| besides.
            let norm = self.norms[i];
            let bent = self.bent(i, |b| 2.0 * (b.linear[0] * b.linear[0] + norm * b.linear[1]));
            let least = lanes.iter().map(|map| map.determinant());
            let (low, high) = least.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), area| {
                (lesser(low, area), larger(high, area))
            });
            self.areas.push(low.max(-high) - bent * ROUND_UP - 1e-9);
        }
        self.factor = self.norms.iter().copied().fold(0.0, larger);
        // Comparisons with NaN are false.
        self.norms.iter().all(|&norm| norm < 1.0 - 1e-6)
    }

    /// Makes the unit disc hold the attractors of the whole box.
    fn widen(&mut self, seam: f64, size_to: f64, size_from: f64, away: f64, frame: &Frame) -> bool {
        // A disc of this radius is taken into itself by every map of every parameter.
        let mut radius = 0.0_f64;
        for (i, lanes) in self.maps.iter().enumerate() {
            let shift = lanes.iter().map(|map| map.translation.length()).fold(0.0, larger);
            radius = larger(
                radius,
                (shift + self.bent(i, |bound| bound.shift[1])) / (1.0 - self.norms[i]) * ROUND_UP,
            );
        }
        let unit = radius.max(0.5);
        if !unit.is_finite() || unit > 100.0 {
            return false;
        }
        for map in self.maps.iter_mut().flatten() {
            map.translation /= unit;
        }
        for bound in self.bounds.iter_mut().flatten() {
            bound.shift = bound.shift.map(|shift| shift * (ROUND_UP / unit));
        }
        self.from_round = frame.from_round * unit;
        self.origin = frame.origin;
        self.plain = frame.plain;
        // The frame reckons with the rounding of the system in the middle: the others contract as well, at most
        // this much more slowly.
        let slower = (1.0 - frame.factor).max(1e-6) / (1.0 - self.factor);
        let seam = seam * size_to * (size_from + away) / (1.0 - self.factor);
        // Each lane is off for itself, and c is a sum of four values.
        self.rounding = 4.0 * (frame.rounding * slower.max(1.0) + seam) / unit * ROUND_UP;
        self.measure(1.0);
        self.rounding < 1e-6
    }

    /// What second derivatives add up to over the box, for map i: how far it may be off what the lanes say.
    fn bent(&self, i: usize, of: impl Fn(&Bound) -> f64) -> f64 {
        let along = |axis: usize| self.bounds[axis].get(i).map_or(0.0, &of) * self.square(axis);
        along(0) + along(1)
    }

    /// What a second derivative is multiplied by.
    fn square(&self, axis: usize) -> f64 {
        let share = if axis == 0 { 0.125 } else { 0.5 };
        share * self.half[axis] * self.half[axis]
    }

    /// The bounds of the module, if a disc of this radius holds all attractors of the box.
    fn measure(&mut self, radius: f64) {
        let rates = |axis: usize| {
            let each = || self.bounds[axis].iter().zip(&self.norms);
            let first = each().map(|(b, norm)| (b.linear[0] * radius + b.shift[0]) / (1.0 - norm));
            let first = first.fold(0.0, larger);
            let second = each().map(|(b, norm)| {
                (b.linear[1] * radius + b.shift[1] + 2.0 * b.linear[0] * first) / (1.0 - norm)
            });
            let second = second.fold(0.0, larger);
            let third = each().map(|(b, norm)| {
                let rest = 3.0 * (b.linear[1] * first + b.linear[0] * second);
                (b.linear[2] * radius + b.shift[2] + rest) / (1.0 - norm)
            });
            [first, second, third.fold(0.0, larger)]
        };
        let [first, second, third] = rates(0);
        let h = self.half.x;
        let [along_y, bent_y, _] = rates(1);
        self.stray = h * first + self.half.y * along_y;
        self.sizes = [radius * ROUND_UP, h * first * ROUND_UP, h * h * second * ROUND_UP];
        self.dip = second * self.square(0) * ROUND_UP;
        self.jerk = third * h * h * h * ROUND_UP;
        self.still = bent_y * self.square(1) * ROUND_UP;
    }

    /// Makes the bounds narrower when the attractors are known better than to lie in the unit disc.
    pub fn refine(&mut self, fan: &SupportLanes<L>) {
        let radius = fan.radius() + self.dip + self.still;
        if radius < 1.0 {
            self.measure(radius);
        }
    }

    /// How far the distance of two points along a unit vector may lie below its least value in the lanes, and what
    /// rounding adds, if c is at most `bow` in all rows of lanes.
    #[inline]
    pub fn margin(&self, bow: f64) -> f64 {
        let (bow, jerk) = (larger(0.0, bow), 2.0 * self.jerk);
        let fine = lesser((bow + jerk) * 0.125, 0.5 * bow + CUBIC_DIP * jerk);
        lesser(fine, 2.0 * self.dip) + 2.0 * self.still + self.rounding
    }

    /// How far points of the attractors move between the middle of the box and its edge, at most.
    pub const fn stray(&self) -> f64 {
        self.stray
    }

    /// Whether there are two maps, and their areas leave no room between the pieces: `|det w_1| + |det w_2| > 1`.
    pub fn areas_fill(&self) -> bool {
        matches!(self.areas[..], [a, b] if a + b > 1.0)
    }

    /// The margin of two points of which nothing is known.
    pub fn widest_margin(&self) -> f64 {
        2.0 * (self.dip + self.still) + self.rounding
    }

    /// By how much c of a point of the piece may differ from c of its map's translation.
    pub fn sag(&self, maps: &Maps<L>) -> f64 {
        if L < 3 {
            return 0.0;
        }
        let [radius, first, second] = self.sizes;
        let sag = |row: usize| {
            let [l, m, r] = [0, 1, 2].map(|k| maps[3 * row + k].linear);
            // Frobenius's norm is no less than the operator norm.
            let size = |m: DMat2| (m.x_axis.length_squared() + m.y_axis.length_squared()).sqrt();
            size(l - m * 2.0 + r) * radius + size(r - l) * first + (size(l) + size(r)) * (0.5 * second)
        };
        (0..L / 3).map(sag).fold(0.0, larger) * ROUND_UP
    }
}

/// c of a point, in each row of lanes.
#[inline]
pub(crate) fn bows<const L: usize>(points: &Points<L>) -> [DVec2; 2] {
    let row = |row: usize| {
        if 3 * row + 2 < L {
            points[3 * row] - points[3 * row + 1] * 2.0 + points[3 * row + 2]
        } else {
            DVec2::ZERO
        }
    };
    [row(0), row(1)]
}

#[cfg(test)]
mod tests {
    use frond_core::{Mode, Morph, MorphOptions, hash};

    use super::*;
    use crate::family::{Polygons, Slice};
    use crate::region::no_attractor::never_contracts;

    fn unit(seed: u32, k: u32) -> f64 {
        f64::from(hash::unit(hash::counter(seed, k)))
    }

    /// A morph of three maps, of which some reflect.
    fn any_morph(seed: u32) -> Morph {
        let end = |seed: u32| -> Vec<Affine2> {
            let number = |k: u32, size: f64| (2.0 * unit(seed, k) - 1.0) * size;
            let row =
                |i: u32| std::array::from_fn(|k| number(6 * i + k as u32, if k < 4 { 0.5 } else { 2.0 }));
            (0..3).map(|i| Affine2::from_row(row(i))).collect()
        };
        let mode = if seed.is_multiple_of(4) { Mode::Linear } else { Mode::Polar };
        let options =
            MorphOptions { mode, turns: vec![0, (seed % 3) as i32 - 1, 0], ..MorphOptions::default() };
        Morph::new(&end(2 * seed), &end(2 * seed + 1), &options).unwrap()
    }

    /// The point of an address in the lanes' coordinates.
    fn point<F: Family>(family: &F, at: DVec2, address: &[usize], lanes: &Lanes<6>) -> DVec2 {
        let mut maps = Vec::new();
        family.fill(at.x, at.y, &mut maps);
        let last = maps[address[0]].fixed_point().unwrap();
        let x = address.iter().rev().fold(last, |x, &i| maps[i].apply(x));
        lanes.from_round.inverse() * (x - lanes.origin)
    }

    /// Tries the bounds of a box on addresses and directions; returns how many times most of the margin was
    /// used, so that one knows that none could be narrower.
    fn try_box<F: Family>(family: &F, extent: Extent, seed: u32) -> Option<usize> {
        let mut lanes = Lanes::<6>::default();
        if !lanes.set(family, extent, &mut Frame::default()) {
            return None;
        }
        let mut fan = SupportLanes::default();
        fan.set(&lanes.maps, 0.01, 64);
        lanes.refine(&fan);
        let mut used = 0;
        for n in 0..6 {
            let letter = |k: u32| (unit(seed ^ 77, 100 * n + k) * 3.0) as usize % family.len();
            let words: [Vec<usize>; 2] =
                [0, 1].map(|side| (0..40).map(|k| letter(50 * side + k)).collect::<Vec<_>>());
            let between = |l: usize| {
                let [p, q] =
                    [0, 1].map(|side: usize| point(family, extent.place::<6>(l), &words[side], &lanes));
                q - p
            };
            // Every other time a direction along which nothing changes from left to middle: then the lowest value
            // lies halfway.
            let turned = (between(1) - between(0)).perp();
            let normal = if n % 2 == 0 || turned.length() < 1e-9 {
                DVec2::from_angle(unit(seed, 900 + n) * 6.3)
            } else {
                turned.normalize() * (1.0 - f64::from(n % 4) + 1.0).signum()
            };
            let value = |at: DVec2| {
                let [p, q] = [0, 1].map(|side: usize| point(family, at, &words[side], &lanes));
                assert!(p.length() <= 1.0 + 1e-9 && q.length() <= 1.0 + 1e-9, "outside the disc");
                (p, q, normal.dot(q - p))
            };
            let each: [(DVec2, DVec2, f64); 6] = std::array::from_fn(|l| value(extent.place::<6>(l)));
            let least = each.iter().map(|e| e.2).fold(f64::INFINITY, f64::min);
            let [p, q] = [bows(&each.map(|e| e.0)), bows(&each.map(|e| e.1))];
            let bow = (0..2).map(|row| normal.dot(q[row] - p[row])).fold(f64::NEG_INFINITY, f64::max);
            // What is known of a whole piece, the one of the first two letters of the second word.
            let maps: Maps<6> =
                std::array::from_fn(|l| lanes.maps[words[1][0]][l] * lanes.maps[words[1][1]][l]);
            let (middle, sag) = (bows(&maps.map(|map| map.translation)), lanes.sag(&maps));
            for row in 0..2 {
                let off = (q[row] - middle[row]).length();
                assert!(off <= sag + 1e-12, "c is {off} off, not {sag}");
            }
            for k in 0..60 {
                let place = match k {
                    0 => DVec2::new(-0.5, -1.0),
                    _ => DVec2::new(unit(seed, 1000 + 2 * k), unit(seed, 1001 + 2 * k)) * 2.0 - 1.0,
                };
                let at = extent.middle + extent.half * place;
                let dip = least - value(at).2;
                let margin = lanes.margin(bow).min(lanes.widest_margin());
                assert!(dip <= margin + 1e-12, "{dip} > {margin} at {at} in {extent:?}, seed {seed}");
                used += usize::from(dip > 0.7 * margin && margin > 1e-9);
                let moved = point(family, at, &words[0], &lanes).distance(point(
                    family,
                    extent.middle,
                    &words[0],
                    &lanes,
                ));
                assert!(moved <= lanes.stray() * (1.0 + 1e-9) + 1e-12, "strays {moved}");
                let mut here = Vec::new();
                family.fill(at.x, at.y, &mut here);
                for (i, map) in here.iter().enumerate() {
                    assert!(map.determinant().abs() >= lanes.areas[i]);
                    let linear = lanes.from_round.inverse() * map.linear * lanes.from_round;
                    assert!(norm(linear) <= lanes.norms[i] * (1.0 + 1e-12));
                }
            }
        }
        Some(used)
    }

    #[test]
    fn points_stay_within_the_margins_over_whole_boxes() {
        let (mut boxes, mut used) = (0, 0);
        for seed in 0..400 {
            let middle = DVec2::new(unit(seed, 500), unit(seed, 501)) * 3.0 - 1.0;
            let half = DVec2::new(unit(seed, 502), unit(seed, 503)).powf(3.0) * 0.4;
            let extent = Extent { middle, half };
            let morph = any_morph(seed);
            let slice = Slice::new(&morph, unit(seed, 504) - 0.5);
            if let Some(more) = try_box(&slice, extent, seed) {
                (boxes, used) = (boxes + 1, used + more);
            }
            let s = DVec2::from_angle(unit(seed, 505) * 6.3) * (0.8 * unit(seed, 506));
            let polygons = Polygons::new(2 + seed as usize % 5);
            if let Some(more) = try_box(&polygons, Extent { middle: s, half: half * 0.5 }, seed) {
                (boxes, used) = (boxes + 1, used + more);
            }
        }
        assert!(boxes > 200 && used > 20, "{boxes} boxes, {used} margins used");
    }

    #[test]
    fn empty_and_endless_boxes_are_no_trouble() {
        let morph = any_morph(1);
        let slice = Slice::new(&morph, 0.0);
        let mut lanes = Lanes::<6>::default();
        for half in [0.0, 1e-300, 1e3, 1e300, f64::INFINITY, f64::NAN] {
            let extent = Extent { middle: DVec2::splat(0.5), half: DVec2::splat(half) };
            let set = lanes.set(&slice, extent, &mut Frame::default());
            assert!(!set || half < 1.0, "{half}");
            never_contracts(&slice, extent);
        }
        assert!(lanes.maps.len() <= 3);
    }
}
