//! How far two pieces of the attractor are apart, from both sides.

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::gap::pair_descent::Sight;
use crate::gap::word_tree::Piece;
use crate::support::f64x4::{DVec2x4, F64x4};
use crate::support::table::SupportTable;

/// What was found out about up to four pieces, each against one and the same other.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Distances {
    /// Lower bounds of the distances in the plane; not above 0 where the two may meet.
    pub apart: [f64; 4],
    /// How near their middles are, against what reaches from one to the other: 0 if they coincide, 1 if the
    /// hulls touch.
    pub overlap: [f64; 4],
    /// The squares of the distances between two points of the attractor, one in each piece.
    pub reach: [f64; 4],
}

impl Distances {
    /// What was seen of piece `k`.
    #[inline(always)]
    pub fn sight(&self, k: usize) -> Sight<()> {
        Sight { apart: self.apart[k], overlap: self.overlap[k], reach: self.reach[k], points: () }
    }
}

/// [`Distances`], and the points that are so near.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Looks {
    pub distances: Distances,
    /// These points, in the frame: in the pieces, and in the other.
    points: [DVec2x4; 2],
}

impl Looks {
    /// The two points of piece `k`: in it, and in the other.
    #[inline]
    pub fn points(&self, k: usize) -> (DVec2, DVec2) {
        (self.points[0].at(k), self.points[1].at(k))
    }
}

/// How lengths and directions are measured.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Metric {
    /// Whether lengths are those of the plane, but for a factor: its square, and the inverse of that.
    plain: Option<[f64; 2]>,
    /// Takes steps to the plane.
    to_plane: DMat2,
    /// Takes the normals of lines to the plane.
    normal_to_plane: DMat2,
    /// How far a normal that is taken to the plane may be off there, against the sum of its sides here.
    blur: f64,
    /// In which metric to look for lines that separate pieces.
    search_metric: DMat2,
    rounding: f64,
}

/// The linear parts of four maps, and what they do to vectors.
#[derive(Clone, Copy)]
struct Linear4 {
    x: DVec2x4,
    y: DVec2x4,
}

impl Linear4 {
    #[inline(always)]
    fn splat(m: DMat2) -> Self {
        Self { x: DVec2x4::splat(m.x_axis), y: DVec2x4::splat(m.y_axis) }
    }

    #[inline(always)]
    fn times(self, v: DVec2x4) -> DVec2x4 {
        DVec2x4 { x: self.x.x * v.x + self.y.x * v.y, y: self.x.y * v.x + self.y.y * v.y }
    }

    #[inline(always)]
    fn transposed_times(self, v: DVec2x4) -> DVec2x4 {
        DVec2x4 { x: self.x.dot(v), y: self.y.dot(v) }
    }
}

impl Metric {
    /// To tell pieces apart: they are round in the frame, and most easily told apart there, however flat they
    /// are in the plane.
    pub fn to_separate(frame: &Frame) -> Self {
        let factor = |m: DMat2| m.x_axis.x * m.x_axis.x;
        let to_round = frame.to_round;
        let largest = to_round.x_axis.abs().max(to_round.y_axis.abs()).max_element();
        Self {
            plain: frame.plain.then_some([factor(frame.from_round), factor(to_round)]),
            to_plane: frame.from_round,
            normal_to_plane: to_round.transpose(),
            blur: NORMAL_ROUNDING * largest,
            search_metric: DMat2::IDENTITY,
            rounding: frame.rounding,
        }
    }

    /// To measure how far apart they are: distances are those of the plane, and so are the directions that
    /// show them best.
    pub fn to_measure(frame: &Frame) -> Self {
        // Of size 1, or of small shapes the squares of what is seen would vanish.
        let search_metric = frame.metric * (1.0 / (frame.stretch * frame.stretch));
        Self { search_metric, ..Self::to_separate(frame) }
    }

    /// Bounds the distances of one to four pieces from another: support functions along the lines between their
    /// middles, then along better ones (steps of Frank & Wolfe's algorithm on their difference).
    ///
    /// The four are independent of each other, and a processor works on them at once. Lanes that are left over
    /// repeat the last piece.
    pub fn look(&self, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Looks {
        self.look_as::<false>(support, parts, other)
    }

    /// [`Metric::look`] without points.
    pub fn distances(&self, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Distances {
        let looks = if self.plain.is_some() {
            self.look_as::<true>(support, parts, other)
        } else {
            self.look_as::<false>(support, parts, other)
        };
        looks.distances
    }

    /// The same for sets of differences: bounds the distances of four points from the image, under `power`, of the
    /// attractor that `support` bounds, which is symmetric about 0.
    pub fn differences(&self, support: &SupportTable, power: DMat2, offsets: DVec2x4) -> Distances {
        let m = Linear4::splat(power);
        let see = |normal: DVec2x4| {
            let (far, p) = support.support4(m.transposed_times(normal));
            (far, [m.times(p), offsets])
        };
        let looks = if self.plain.is_some() {
            self.steps::<true>(offsets, see)
        } else {
            self.steps::<false>(offsets, see)
        };
        looks.distances
    }

    #[inline(always)]
    fn look_as<const PLAIN: bool>(&self, support: &SupportTable, parts: &[Piece], other: &Affine2) -> Looks {
        let Sides { a, b, a0, b0 } = Sides::new(parts, other);
        self.steps::<PLAIN>(b0 - a0, |normal| {
            let (far_a, p) = support.support4(a.transposed_times(normal));
            let pulled = b.transposed_times(normal);
            let (far_b, q) = support.support4(DVec2x4 { x: -pulled.x, y: -pulled.y });
            (far_a + far_b, [a.times(p) + a0, b.times(q) + b0])
        })
    }

    /// Looks along `middle`, from one middle to the other, then along a better direction. `see` gives for a
    /// normal how far the two reach towards each other, and points of both that do.
    ///
    /// `PLAIN` where lengths are those of the plane, but for a factor.
    #[inline(always)]
    fn steps<const PLAIN: bool>(
        &self,
        middle: DVec2x4,
        see: impl Fn(DVec2x4) -> (F64x4, [DVec2x4; 2]),
    ) -> Looks {
        let first = self.along::<PLAIN>(middle, middle, &see);
        if first.apart.all_positive() {
            let apart = self.distance::<PLAIN>(first.apart, first.scale, first.blur).to_array();
            let distances =
                Distances { apart, overlap: first.overlap.to_array(), reach: first.reach.to_array() };
            return Looks { distances, points: first.points };
        }
        // The point nearest to the origin between `middle` and the difference of the points, both of them
        // differences of points of the two hulls.
        let turn = middle - (first.points[1] - first.points[0]);
        let length = turn.dot(if PLAIN { turn } else { Linear4::splat(self.search_metric).times(turn) });
        let t = (first.normal.dot(turn) / length).max(F64x4::default()).min(F64x4::splat(1.0));
        let step = DVec2x4 { x: middle.x - turn.x * t, y: middle.y - turn.y * t };
        let second = self.along::<PLAIN>(middle, step, &see);
        // The greater of the two bounds: of their squares, with their signs, so that no root is taken for each.
        let signed = |a: F64x4, other: F64x4| a * a.abs() * other;
        let (a, b) = (signed(first.apart, second.scale), signed(second.apart, first.scale));
        let apart = a.choose_less(b, second.apart, first.apart);
        let scale = a.choose_less(b, second.scale, first.scale);
        let blur = if PLAIN { first.blur } else { a.choose_less(b, second.blur, first.blur) };
        let nearer = |a: F64x4, b: F64x4| second.reach.choose_less(first.reach, b, a);
        let chosen = |k: usize| DVec2x4 {
            x: nearer(first.points[k].x, second.points[k].x),
            y: nearer(first.points[k].y, second.points[k].y),
        };
        let distances = Distances {
            apart: self.distance::<PLAIN>(apart, scale, blur).to_array(),
            overlap: first.overlap.min(second.overlap).to_array(),
            reach: first.reach.min(second.reach).to_array(),
        };
        Looks { distances, points: [chosen(0), chosen(1)] }
    }

    /// What is seen along lines of the directions `step`.
    #[inline(always)]
    fn along<const PLAIN: bool>(
        &self,
        middle: DVec2x4,
        step: DVec2x4,
        see: &impl Fn(DVec2x4) -> (F64x4, [DVec2x4; 2]),
    ) -> View {
        let normal = if PLAIN { step } else { Linear4::splat(self.search_metric).times(step) };
        let (reach, points) = see(normal);
        let along = normal.dot(middle);
        let between = points[1] - points[0];
        // Rounding outward; the sum of the sides is no shorter than the normal.
        let sides = normal.x.abs() + normal.y.abs();
        let off = F64x4::splat(self.rounding) * sides;
        let squares = |v: DVec2x4, linear: DMat2, factor: f64| {
            if PLAIN {
                v.dot(v) * F64x4::splat(factor)
            } else {
                let there = Linear4::splat(linear).times(v);
                there.dot(there)
            }
        };
        let [to_plane, normal_to_plane] = self.plain.unwrap_or_default();
        View {
            normal,
            apart: along - reach - off,
            scale: squares(normal, self.normal_to_plane, normal_to_plane),
            blur: if PLAIN { F64x4::default() } else { F64x4::splat(self.blur) * sides },
            overlap: along / reach,
            reach: squares(between, self.to_plane, to_plane),
            points,
        }
    }

    /// A lower bound of the distance in the plane, 0 where it is less.
    #[inline(always)]
    fn distance<const PLAIN: bool>(&self, apart: F64x4, scale: F64x4, blur: F64x4) -> F64x4 {
        let length = if PLAIN { scale.sqrt() } else { scale.sqrt() + blur };
        F64x4::default().choose_less(apart, apart * F64x4::splat(ROUND_DOWN) / length, F64x4::default())
    }
}

/// By how much a number that is computed from given ones in two or three steps may be off, relative to their sizes. A
/// frame's inverse has no more of its own.
const NORMAL_ROUNDING: f64 = 16.0 * f64::EPSILON;
/// What takes care of the rounding of a few last operations.
const ROUND_DOWN: f64 = 1.0 - 8.0 * f64::EPSILON;

/// The maps of four pieces and of another one.
struct Sides {
    a: Linear4,
    b: Linear4,
    a0: DVec2x4,
    b0: DVec2x4,
}

impl Sides {
    #[inline(always)]
    fn new(parts: &[Piece], other: &Affine2) -> Self {
        let last = parts.len() - 1;
        let lanes = [&parts[0], &parts[last.min(1)], &parts[last.min(2)], &parts[last.min(3)]];
        let four = |f: fn(&Affine2) -> f64| F64x4::new(lanes.map(|piece| f(&piece.map)));
        let a = Linear4 {
            x: DVec2x4 { x: four(|m| m.linear.x_axis.x), y: four(|m| m.linear.x_axis.y) },
            y: DVec2x4 { x: four(|m| m.linear.y_axis.x), y: four(|m| m.linear.y_axis.y) },
        };
        Self {
            a,
            b: Linear4::splat(other.linear),
            a0: DVec2x4 { x: four(|m| m.translation.x), y: four(|m| m.translation.y) },
            b0: DVec2x4::splat(other.translation),
        }
    }
}

/// What is seen of two pieces along one direction, in four lanes.
struct View {
    normal: DVec2x4,
    /// How far they are apart along the normal, which is `scale.sqrt()` long in the plane, and `blur` more at most.
    apart: F64x4,
    scale: F64x4,
    blur: F64x4,
    overlap: F64x4,
    reach: F64x4,
    points: [DVec2x4; 2],
}
