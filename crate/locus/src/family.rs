//! Families of systems over two parameters, and how fast they change.

use frond_core::{Affine2, Kind, Mode, Morph, Polar2};
use glam::{DMat2, DVec2, DVec3};

/// How one map of a family changes along an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drift {
    /// The derivative in the middle: that of the linear part and that of the translation.
    pub speed: Affine2,
    /// The second derivative of the linear part is of this operator norm at most.
    pub bend: f64,
    /// The second derivative of the translation is of this length at most.
    pub sway: f64,
    /// The third derivative of the linear part is of this operator norm at most; that of the translation is 0.
    pub jerk: f64,
}

impl Drift {
    /// No change at all.
    pub const STILL: Self =
        Self { speed: Affine2::new(DMat2::ZERO, DVec2::ZERO), bend: 0.0, sway: 0.0, jerk: 0.0 };
}

/// A family of systems over two parameters, x and y.
///
/// Each number of its maps is a smooth function of x plus one of y: then what is known in the corners of a box
/// of parameters, and how much things bend along its sides, is enough to know all of the box.
pub trait Family {
    /// The number of maps.
    fn len(&self) -> usize;

    /// Whether there are no maps at all.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The maps at (x, y), written over what `maps` held.
    fn fill(&self, x: f64, y: f64, maps: &mut Vec<Affine2>);

    /// How each map changes along an axis, 0 for x and 1 for y, at all parameters that differ from `at` by
    /// `half` or less along it.
    fn drift(&self, axis: usize, at: DVec2, half: f64, drifts: &mut Vec<Drift>);

    /// Whether the maps are `s z + 1` and `s z - 1` of the complex plane, s = x + i y: the family of the set M, of
    /// which more is known than of others.
    fn is_set_m(&self) -> bool {
        false
    }

    /// Whether all maps of each system have one linear part: then no trap holds its pieces together.
    fn has_one_linear_part(&self) -> bool {
        self.is_set_m()
    }

    /// By how much the numbers of [`Family::fill`] may miss those of a smooth family, rounding aside.
    fn seam(&self) -> f64 {
        0.0
    }
}

/// A plane through the parameters of a morph: x is u, y is v, and w is the same everywhere.
#[derive(Clone, Debug)]
pub struct Slice<'a> {
    morph: &'a Morph,
    w: f64,
    motions: Motions,
}

impl<'a> Slice<'a> {
    /// The plane of this w; w = 0 is that of Burch & Hart (1997, section 5).
    #[must_use]
    pub fn new(morph: &'a Morph, w: f64) -> Self {
        Self { morph, w, motions: Motions::of(morph) }
    }
}

impl Family for Slice<'_> {
    fn len(&self) -> usize {
        self.morph.len()
    }

    fn fill(&self, x: f64, y: f64, maps: &mut Vec<Affine2>) {
        self.morph.fill3(x, y, self.w, maps);
    }

    fn drift(&self, axis: usize, at: DVec2, half: f64, drifts: &mut Vec<Drift>) {
        let velocity = if axis == 0 { DVec3::X } else { DVec3::Y };
        self.motions.drift(at.extend(self.w), velocity, half, drifts);
    }

    fn seam(&self) -> f64 {
        self.motions.seam
    }
}

/// The plane w = 0. For patches a [`Slice`] is faster.
impl Family for Morph {
    fn len(&self) -> usize {
        Self::len(self)
    }

    fn fill(&self, x: f64, y: f64, maps: &mut Vec<Affine2>) {
        Self::fill(self, x, y, maps);
    }

    fn drift(&self, axis: usize, at: DVec2, half: f64, drifts: &mut Vec<Drift>) {
        Slice::new(self, 0.0).drift(axis, at, half, drifts);
    }

    fn seam(&self) -> f64 {
        Motions::of(self).seam
    }
}

/// A straight way through the parameters of a morph, from x = 0 to x = 1; y changes nothing.
#[derive(Clone, Debug)]
pub(crate) struct Leg<'a> {
    pub morph: &'a Morph,
    pub motions: &'a Motions,
    pub from: DVec3,
    pub to: DVec3,
}

impl Leg<'_> {
    pub fn at(&self, x: f64) -> DVec3 {
        // The ends to the last bit: a morph gives its ends back so.
        if x == 1.0 { self.to } else { self.from + (self.to - self.from) * x }
    }
}

impl Family for Leg<'_> {
    fn len(&self) -> usize {
        self.morph.len()
    }

    fn fill(&self, x: f64, _: f64, maps: &mut Vec<Affine2>) {
        let at = self.at(x);
        self.morph.fill3(at.x, at.y, at.z, maps);
    }

    fn drift(&self, axis: usize, at: DVec2, half: f64, drifts: &mut Vec<Drift>) {
        if axis == 0 {
            self.motions.drift(self.at(at.x), self.to - self.from, half, drifts);
        } else {
            drifts.clear();
            drifts.resize(self.len(), Drift::STILL);
        }
    }

    fn seam(&self) -> f64 {
        self.motions.seam
    }
}

/// How each map of a morph moves.
#[derive(Clone, Debug)]
pub(crate) struct Motions {
    linear: bool,
    each: Vec<Motion>,
    seam: f64,
}

#[derive(Clone, Copy, Debug)]
struct Motion {
    reflects: bool,
    angle: f64,
    turn: f64,
    /// The stretch at the start, and how much it grows.
    stretch: [DMat2; 2],
    /// What the linear part and the translation differ by between the ends.
    step: Affine2,
}

impl Motions {
    pub fn of(morph: &Morph) -> Self {
        let (from, to) = (morph.at(0.0, 0.0), morph.at(1.0, 1.0));
        let mut seam = 0.0_f64;
        let turns = morph.turns();
        let motions = morph.kinds().into_iter().enumerate().map(|(i, kind)| {
            let reflects = kind == Kind::Reflecting;
            let (angle, turn) = turns[i];
            let [start, end] = [(from[i].linear, angle), (to[i].linear, angle + turn)].map(|(m, angle)| {
                let q = Polar2 { angle, reflects, stretch: DMat2::IDENTITY }.orthogonal();
                let s = q.transpose() * m;
                let off = f64::midpoint(s.x_axis.y, s.y_axis.x);
                let s = DMat2::from_cols(DVec2::new(s.x_axis.x, off), DVec2::new(off, s.y_axis.y));
                seam = seam.max(norm(q * s - m));
                s
            });
            let step = Affine2::new(to[i].linear - from[i].linear, to[i].translation - from[i].translation);
            Motion { reflects, angle, turn, stretch: [start, end - start], step }
        });
        let each = motions.collect();
        let linear = morph.mode() == Mode::Linear;
        Self { linear, each, seam: if linear { 0.0 } else { seam } }
    }

    /// The drift at (u, v, w) when these change with this velocity.
    fn drift(&self, at: DVec3, velocity: DVec3, half: f64, drifts: &mut Vec<Drift>) {
        drifts.clear();
        drifts.extend(self.each.iter().map(|motion| {
            let shift = motion.step.translation * velocity.y;
            if self.linear {
                let speed = Affine2::new(motion.step.linear * velocity.x, shift);
                return Drift { speed, ..Drift::STILL };
            }
            let turn = motion.turn * velocity.x;
            let growth = motion.stretch[1] * (velocity.x + velocity.z);
            let stretch = motion.stretch[0] + motion.stretch[1] * (at.x + at.z);
            let q = Polar2 {
                angle: motion.turn.mul_add(at.x, motion.angle),
                reflects: motion.reflects,
                stretch: DMat2::IDENTITY,
            };
            // What a turn does behind Q: Q' = turn Q J, where J is a quarter turn, the other way round behind
            // a reflection.
            let quarter = if motion.reflects { -QUARTER } else { QUARTER };
            // With L = Q S: L' = Q (turn J S + S'), L'' = Q (2 turn J S' - turn^2 S) and
            // L''' = -Q (turn^3 J S + 3 turn^2 S'), where S is linear.
            let speed = q.orthogonal() * (quarter * stretch * turn + growth);
            let bend = |along: f64| {
                norm(quarter * growth * (2.0 * turn) - (stretch + growth * along) * (turn * turn))
            };
            let jerk = |along: f64| {
                norm((quarter * (stretch + growth * along) * turn + growth * 3.0) * (turn * turn))
            };
            let most = |f: &dyn Fn(f64) -> f64| f(-half).max(f(half)) * (1.0 + 1e-12);
            Drift { speed: Affine2::new(speed, shift), bend: most(&bend), sway: 0.0, jerk: most(&jerk) }
        }));
    }
}

/// A turn by a right angle.
const QUARTER: DMat2 = DMat2::from_cols(DVec2::Y, DVec2::NEG_X);

fn norm(linear: DMat2) -> f64 {
    Affine2::new(linear, DVec2::ZERO).norm()
}

/// The systems `s z + exp(2 pi i k / n)`, k = 0 .. n - 1, over the complex s = x + i y: the pieces of a
/// regular polygon, turned and drawn together by s.
///
/// For n = 2 the attractor is that of `{s z - 1, s z + 1}`, and the s where it is connected are the set M of
/// Barnsley & Harrington (1985). M is symmetric about both axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygons {
    corners: Vec<DVec2>,
}

impl Polygons {
    /// The family of this many sides, which are taken into 2 to 64.
    #[must_use]
    pub fn new(sides: usize) -> Self {
        let sides = sides.clamp(2, 64);
        let corner = |k: usize| match (4 * k).checked_rem(sides) {
            // Right angles to the last bit.
            Some(0) => [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y][4 * k / sides % 4],
            _ => DVec2::from_angle(std::f64::consts::TAU * k as f64 / sides as f64),
        };
        Self { corners: (0..sides).map(corner).collect() }
    }

    /// How many sides.
    #[must_use]
    pub fn sides(&self) -> usize {
        self.corners.len()
    }

    /// The least real scale r > 0 at which the attractor is connected; from there on it is for all.
    ///
    /// Neighbouring pieces first meet where each goes farthest towards the other: `r = 1 / (2 (1 + sum cos(2 pi
    /// k / n)))`, k = 1 .. floor(n / 4) (Strichartz 2000; Schlicker & Dennis 1995), and 1/2 for n = 2.
    #[must_use]
    pub fn critical_scale(&self) -> f64 {
        let sides = self.sides();
        let cosines = (1..=sides / 4).map(|k| (std::f64::consts::TAU * k as f64 / sides as f64).cos());
        0.5 / (1.0 + cosines.sum::<f64>())
    }
}

impl Family for Polygons {
    fn len(&self) -> usize {
        self.sides()
    }

    fn fill(&self, x: f64, y: f64, maps: &mut Vec<Affine2>) {
        let linear = DMat2::from_cols(DVec2::new(x, y), DVec2::new(-y, x));
        maps.clear();
        maps.extend(self.corners.iter().map(|&corner| Affine2::new(linear, corner)));
    }

    fn drift(&self, axis: usize, _: DVec2, _: f64, drifts: &mut Vec<Drift>) {
        let linear = if axis == 0 { DMat2::IDENTITY } else { QUARTER };
        drifts.clear();
        drifts.resize(self.len(), Drift { speed: Affine2::new(linear, DVec2::ZERO), ..Drift::STILL });
    }

    fn is_set_m(&self) -> bool {
        self.sides() == 2
    }

    fn has_one_linear_part(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use frond_core::MorphOptions;

    use super::*;

    fn apart(a: &Affine2, b: &Affine2) -> f64 {
        norm(a.linear - b.linear) + a.translation.distance(b.translation)
    }

    /// Compares the derivatives with differences, and the bends with how far the middle is off a chord.
    fn check(family: &impl Family, at: DVec2, half: f64) {
        let maps = |p: DVec2| {
            let mut maps = Vec::new();
            family.fill(p.x, p.y, &mut maps);
            maps
        };
        for (axis, along) in [DVec2::X, DVec2::Y].into_iter().enumerate() {
            let mut drifts = Vec::new();
            family.drift(axis, at, half, &mut drifts);
            let tiny = 1e-6;
            let (before, after) = (maps(at - along * tiny), maps(at + along * tiny));
            let (left, middle, right) = (maps(at - along * half), maps(at), maps(at + along * half));
            for (i, drift) in drifts.iter().enumerate() {
                let speed = Affine2::new(
                    (after[i].linear - before[i].linear) * (0.5 / tiny),
                    (after[i].translation - before[i].translation) * (0.5 / tiny),
                );
                assert!(apart(&speed, &drift.speed) < 1e-7, "map {i}, axis {axis}: {drift:?}, not {speed:?}");
                let chord = (left[i].linear + right[i].linear) * 0.5;
                let off = norm(chord - middle[i].linear);
                assert!(off <= 0.5 * half * half * drift.bend + 1e-14, "map {i}: {off}, {drift:?}");
                assert!(off >= 0.1 * half * half * drift.bend - 1e-14, "a loose bound: {off}, {drift:?}");
            }
        }
    }

    fn morph(mode: Mode) -> Morph {
        let from = [
            [0.5, -0.2, 0.3, 0.6, 1.0, 0.0],
            [0.4, 0.1, 0.2, -0.5, 0.0, 2.0],
            [0.1, 0.0, 0.0, 0.3, 0.0, 0.0],
        ];
        let to = [
            [-0.3, 0.4, 0.2, 0.4, 0.0, 1.0],
            [-0.4, 0.3, 0.1, 0.5, 3.0, 0.0],
            [0.2, 0.1, 0.3, -0.4, 1.0, 1.0],
        ];
        let options = MorphOptions { mode, turns: vec![0, 1, 0], ..MorphOptions::default() };
        Morph::new(&from.map(Affine2::from_row), &to.map(Affine2::from_row), &options).unwrap()
    }

    #[test]
    fn derivatives_are_those_of_the_maps() {
        for mode in [Mode::Polar, Mode::Linear] {
            let morph = morph(mode);
            for w in [0.0, 0.3, -0.7] {
                let slice = Slice::new(&morph, w);
                assert!(slice.seam() < 1e-14, "{}", slice.seam());
                for at in [DVec2::new(0.3, 0.6), DVec2::new(-0.9, 1.7), DVec2::new(1.4, -0.2)] {
                    check(&slice, at, 1e-3);
                }
            }
            let (motions, from, to) =
                (Motions::of(&morph), DVec3::new(0.1, 0.4, 0.2), DVec3::new(0.7, 0.2, -0.3));
            check(&Leg { morph: &morph, motions: &motions, from, to }, DVec2::new(0.4, 0.0), 1e-2);
        }
        for sides in [2, 3, 7, 64] {
            check(&Polygons::new(sides), DVec2::new(0.3, 0.5), 1e-2);
        }
    }

    #[test]
    fn bends_hold_over_the_whole_width() {
        let morph = morph(Mode::Polar);
        let slice = Slice::new(&morph, 0.1);
        let mut drifts = Vec::new();
        let (at, half) = (DVec2::new(0.5, 0.5), 0.6);
        slice.drift(0, at, half, &mut drifts);
        for k in -100..=100 {
            let x = at.x + half * f64::from(k) / 100.0;
            let mut here = Vec::new();
            slice.drift(0, DVec2::new(x, 0.5), 0.0, &mut here);
            for (wide, narrow) in drifts.iter().zip(&here) {
                assert!(narrow.bend <= wide.bend * (1.0 + 1e-9), "{narrow:?} {wide:?}");
            }
        }
    }

    #[test]
    fn polygons_have_exact_corners_and_scales() {
        let mut maps = Vec::new();
        Polygons::new(2).fill(0.5, 0.25, &mut maps);
        assert_eq!(maps[0].to_row(), [0.5, -0.25, 0.25, 0.5, 1.0, 0.0]);
        assert_eq!(maps[1].to_row(), [0.5, -0.25, 0.25, 0.5, -1.0, 0.0]);
        Polygons::new(4).fill(0.5, 0.0, &mut maps);
        assert_eq!(maps[3].translation, DVec2::NEG_Y);
        assert_eq!([0, 1, 2, 64, 65, usize::MAX].map(|n| Polygons::new(n).sides()), [2, 2, 2, 64, 64, 64]);
        let golden = (3.0 - 5.0_f64.sqrt()) / 2.0;
        for (n, scale) in [(2, 0.5), (3, 0.5), (4, 0.5), (5, golden), (6, 1.0 / 3.0)] {
            assert!((Polygons::new(n).critical_scale() - scale).abs() < 1e-15, "{n}");
        }
    }
}
