//! Descent on pairs of words: which pieces meet, and how far the others are apart.
//!
//! A pair of words stands for the two pieces of the attractor that they name, one in each of two
//! attractorlets. Support functions bound the distance between the two from below, two points of the
//! attractor bound it from above. Pairs that are neither apart nor small are split at the larger
//! piece. First the pairs that are not yet known to be apart are pursued, those that overlap most first: it ends
//! with a verdict. Then the others, nearest first, which is Kruskal's algorithm on the distances between
//! pieces: it ends with the widest edge of their least spanning tree.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::ops::Range;

use frond_core::Affine2;
use glam::{DMat2, DVec2};

use crate::frame::Frame;
use crate::graph::Components;
use crate::outline::Outline;

/// One piece: the image of the attractor under the map of a word.
#[derive(Clone, Copy, Debug)]
struct Piece {
    /// The map of the word, in the frame; its translation is the middle of the piece.
    map: Affine2,
    /// Half the squared Frobenius norm of the map into the plane: the mean square of its stretches.
    size: f64,
    /// Something like the logarithm of `size`, for the order of the search.
    level: f64,
    /// The index of its first part, 0 while it is not split.
    parts: u32,
}

/// A pair of pieces in two attractorlets `i < j`.
#[derive(Clone, Copy, Debug)]
struct Pair {
    /// What it is ordered by, the least first: see [`Search::settle`] and [`Search::span`].
    key: f64,
    u: u32,
    v: u32,
    i: u8,
    j: u8,
}

impl PartialEq for Pair {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Pair {}
impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Pair {
    /// Reversed, since the heap gives the greatest first; ties go by the pieces, so that nothing
    /// depends on how the heap is built.
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key).then_with(|| (other.u, other.v).cmp(&(self.u, self.v)))
    }
}

/// What was found out about one pair.
#[derive(Clone, Copy, Debug)]
struct Look {
    /// A lower bound of the distance in the plane; not above 0 where the pieces may meet.
    apart: f64,
    /// How deep they overlap, relative to their sizes squared: the more negative the more.
    overlap: f64,
    /// The square of the distance between two points of the attractor, one in each piece.
    reach: f64,
    /// These points, in the frame.
    from: DVec2,
    to: DVec2,
}

/// The nearest two points known of a pair of attractorlets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Nearest {
    /// Their squared distance in the plane.
    pub reach: f64,
    pub from: DVec2,
    pub to: DVec2,
    /// Whether the two were found to meet.
    pub met: bool,
}

/// What a descent needs, kept for the next.
#[derive(Clone, Debug, Default)]
pub(crate) struct Search {
    pieces: Vec<Piece>,
    /// Pairs that may meet.
    open: BinaryHeap<Pair>,
    /// Pairs passed over since their attractorlets were in one component already.
    later: Vec<Pair>,
    /// Pairs that are apart.
    apart: Vec<Pair>,
    /// The same while they are taken in the order of their distances.
    by_distance: BinaryHeap<Pair>,
    nearest: Vec<Nearest>,
    pub components: Components,
    /// Pairs of pieces looked at.
    pub nodes: usize,
    count: usize,
    metric: DMat2,
    dual: DMat2,
    /// In which metric to look for lines that separate pieces.
    lean: DMat2,
    rounding: f64,
    /// The largest factor by which a distance of the frame grows in the plane.
    stretch: f64,
    /// The diameter of the attractor in the frame, and in the plane.
    diameter: f64,
    pub plane_diameter: f64,
    /// Pieces within this distance touch.
    resolution: f64,
}

impl Search {
    /// Starts a descent: every two attractorlets that differ are looked at once.
    ///
    /// `epsilon` is relative to the diameter of the attractor.
    pub fn begin(&mut self, frame: &Frame, outline: &Outline, epsilon: f64) {
        let count = frame.maps.len();
        self.count = count;
        self.metric = frame.metric;
        self.dual = frame.dual;
        // Pieces are round in the frame, and most easily told apart there, however flat they are in the plane.
        self.lean = DMat2::IDENTITY;
        self.rounding = frame.rounding;
        self.diameter = outline.diameter(DMat2::IDENTITY);
        self.plane_diameter = outline.diameter(frame.from_round);
        self.pieces.clear();
        self.open.clear();
        self.apart.clear();
        self.by_distance.clear();
        self.nearest.clear();
        self.later.clear();
        let unknown = Nearest { reach: f64::INFINITY, from: DVec2::ZERO, to: DVec2::ZERO, met: false };
        self.nearest.resize(count * count, unknown);
        self.components.reset(count);
        self.nodes = 0;
        self.stretch = Affine2::new(frame.from_round, DVec2::ZERO).norm();
        // No finer than rounding lets one see, unless rounding has become coarse itself.
        let seen = (4.0 * self.rounding * self.stretch).min(1e-9 * self.plane_diameter);
        self.resolution = (epsilon * self.plane_diameter).max(seen);
        for &map in &frame.maps {
            self.add(map);
        }
        for i in 0..count {
            for j in i + 1..count {
                if frame.maps[i] == frame.maps[j] {
                    // The same piece twice.
                    self.nearest[i * count + j].reach = 0.0;
                    self.meet(i, j);
                } else {
                    let look = self.look(outline, i as u32, j as u32);
                    if !self.note(&look, i as u8, j as u8) {
                        self.file(&look, Pair { key: 0.0, u: i as u32, v: j as u32, i: i as u8, j: j as u8 });
                    }
                }
            }
        }
    }

    fn add(&mut self, map: Affine2) {
        let m = map.linear;
        let size = 0.5 * (m.x_axis.dot(self.metric * m.x_axis) + m.y_axis.dot(self.metric * m.y_axis));
        // The bits of a positive float, read as an integer, are its logarithm to within a tenth.
        let level = DEPTH_FIRST * (size.to_bits() as f64 / (1_u64 << 52) as f64);
        self.pieces.push(Piece { map, size, level, parts: 0 });
    }

    /// Pursues the pairs that are not known to be apart until all pieces are in one component, or none
    /// of these pairs is left; `false` if `budget` looks did not suffice.
    pub fn settle(&mut self, frame: &Frame, outline: &Outline, budget: usize) -> bool {
        while self.components.count() > 1 {
            let Some(pair) = self.open.pop() else { return true };
            if self.components.joined(usize::from(pair.i), usize::from(pair.j)) {
                self.later.push(pair);
            } else if !self.pursue(frame, outline, pair, budget) {
                return false;
            }
        }
        true
    }

    /// Goes on where [`Search::settle`] ended, until of every two attractorlets it is known whether they meet.
    pub fn settle_all(&mut self, frame: &Frame, outline: &Outline, budget: usize) -> bool {
        self.open.extend(self.later.drain(..));
        while let Some(pair) = self.open.pop() {
            let met = self.nearest[usize::from(pair.i) * self.count + usize::from(pair.j)].met;
            if !met && !self.pursue(frame, outline, pair, budget) {
                return false;
            }
        }
        true
    }

    /// Decides a pair, or splits it; `false`, leaving it open, if the budget is spent.
    fn pursue(&mut self, frame: &Frame, outline: &Outline, pair: Pair, budget: usize) -> bool {
        if self.is_small(pair) && self.rounding * self.stretch <= self.resolution {
            self.meet(usize::from(pair.i), usize::from(pair.j));
        } else if self.nodes >= budget {
            self.open.push(pair);
            return false;
        } else {
            self.split(frame, outline, pair, 0.0);
        }
        true
    }

    /// Whether some attractorlets are apart whatever becomes of the pairs that are still open.
    pub fn is_apart_anyway(&self) -> bool {
        let mut components = self.components.clone();
        for pair in self.open.iter().chain(&self.later) {
            components.join(usize::from(pair.i), usize::from(pair.j));
        }
        components.count() > 1
    }

    /// Pairs of attractorlets that were found to meet, `i < j`, in ascending order.
    pub fn overlaps(&self) -> Vec<(usize, usize)> {
        let all = self.nearest.iter().enumerate().filter(|(_, nearest)| nearest.met);
        all.map(|(k, _)| (k / self.count, k % self.count)).collect()
    }

    /// Whether both pieces together are no larger than the resolution.
    fn is_small(&self, pair: Pair) -> bool {
        let limit = self.resolution / self.diameter;
        let limit = limit * limit;
        let (u, v) = (&self.pieces[pair.u as usize], &self.pieces[pair.v as usize]);
        // The larger stretch is between one and 1.42 times the mean square one.
        if u.size + v.size > limit {
            return false;
        }
        let stretch = |piece: &Piece| {
            let m = piece.map.linear;
            let (x, y) = (self.metric * m.x_axis, self.metric * m.y_axis);
            let (xx, xy, yy) = (m.x_axis.dot(x), m.x_axis.dot(y), m.y_axis.dot(y));
            (f64::midpoint(xx, yy) + (0.5 * (xx - yy)).hypot(xy)).sqrt()
        };
        let sum = stretch(u) + stretch(v);
        sum * sum <= limit
    }

    /// Splits the larger piece of a pair, known to be `apart`, and looks at the pairs of its parts.
    fn split(&mut self, frame: &Frame, outline: &Outline, pair: Pair, apart: f64) {
        let Pair { u, v, i, j, .. } = pair;
        let (parts, first) = self.parts_of_larger(frame, u, v);
        for part in parts {
            let (u, v) = if first { (part, v) } else { (u, part) };
            let look = self.look(outline, u, v);
            if self.note(&look, i, j) {
                return;
            }
            self.file(&look, Pair { key: apart, u, v, i, j });
        }
    }

    /// The parts of the larger one of two pieces, and whether that is the first.
    fn parts_of_larger(&mut self, frame: &Frame, u: u32, v: u32) -> (Range<u32>, bool) {
        let first = self.pieces[u as usize].size >= self.pieces[v as usize].size;
        let large = if first { u } else { v } as usize;
        if self.pieces[large].parts == 0 {
            self.pieces[large].parts = self.pieces.len() as u32;
            let whole = self.pieces[large].map;
            for &map in &frame.maps {
                self.add(whole * map);
            }
        }
        let parts = self.pieces[large].parts;
        (parts..parts + self.count as u32, first)
    }

    /// Takes note of how near two attractorlets come; whether that makes them meet.
    #[inline]
    fn note(&mut self, look: &Look, i: u8, j: u8) -> bool {
        self.nodes += 1;
        let (i, j) = (usize::from(i), usize::from(j));
        let nearest = &mut self.nearest[i * self.count + j];
        if look.reach < nearest.reach {
            *nearest = Nearest { reach: look.reach, from: look.from, to: look.to, met: nearest.met };
            if look.reach.sqrt() <= self.resolution {
                self.meet(i, j);
                return true;
            }
        }
        false
    }

    /// Files a pair with those that are apart, by its distance, or with those that may meet, by how deep they
    /// overlap. Its key is the distance of the pair that it is a part of: parts are no nearer than that, even
    /// if the directions tried on them show less.
    #[inline]
    fn file(&mut self, look: &Look, mut pair: Pair) {
        pair.key = look.apart.max(pair.key);
        if pair.key > 0.0 {
            self.apart.push(pair);
        } else {
            let level = self.pieces[pair.u as usize].level.min(self.pieces[pair.v as usize].level);
            pair.key = look.overlap + level;
            self.open.push(pair);
        }
    }

    /// Records that two attractorlets `i < j` meet, as far as the resolution tells.
    pub fn meet(&mut self, i: usize, j: usize) {
        self.components.join(i, j);
        self.nearest[i * self.count + j].met = true;
    }

    /// Bounds the distance of two pieces: support functions along the line between their middles, then
    /// along better ones (steps of Frank & Wolfe's algorithm on their difference).
    #[inline]
    fn look(&self, outline: &Outline, u: u32, v: u32) -> Look {
        let (a, b) = (&self.pieces[u as usize].map, &self.pieces[v as usize].map);
        let (at, bt) = (a.linear.transpose(), b.linear.transpose());
        let mut step = b.translation - a.translation;
        let mut best = Look {
            apart: 0.0,
            overlap: f64::INFINITY,
            reach: f64::INFINITY,
            from: DVec2::ZERO,
            to: DVec2::ZERO,
        };
        let middle = step;
        for round in 0..ROUNDS {
            let normal = self.lean * step;
            let (far_a, p) = outline.support(at * normal);
            let (far_b, q) = outline.support(-(bt * normal));
            let along = normal.dot(middle);
            let reach = far_a + far_b;
            let apart = along - reach;
            let (from, to) = (a.apply(p), b.apply(q));
            let between = to - from;
            let squared = between.dot(self.metric * between);
            if squared < best.reach {
                best = Look { reach: squared, from, to, ..best };
            }
            if apart > 0.0 {
                let off = self.rounding * normal.length();
                best.apart = (apart - off) / normal.dot(self.dual * normal).sqrt();
                if best.apart > 0.0 {
                    return best;
                }
            }
            best.overlap = best.overlap.min(along / reach);
            if round + 1 < ROUNDS {
                // The point nearest to the origin between `step` and `between`, both differences of points
                // of the two hulls.
                let turn = step - between;
                let length = turn.dot(self.lean * turn);
                let t = (normal.dot(turn) / length).clamp(0.0, 1.0);
                step -= turn * t;
            }
        }
        best
    }

    /// Joins the components in the order of their distances until one is left, or `budget` looks are
    /// spent, and so measures the widest gap.
    ///
    /// A distance is known well enough when its bounds differ by `relative` of it or by `absolute`.
    pub fn span(
        &mut self,
        frame: &Frame,
        outline: &Outline,
        relative: f64,
        absolute: f64,
        budget: usize,
    ) -> Span {
        // From here on pieces are known to be apart, however near they come.
        self.resolution = -1.0;
        // Distances are those of the plane, and so are the directions that show them best.
        self.lean = self.metric;
        let mut span = Span::default();
        while self.components.count() > 1 {
            self.by_distance.extend(self.apart.drain(..));
            let Some(pair) = self.by_distance.pop() else { break };
            let (i, j) = (usize::from(pair.i), usize::from(pair.j));
            if self.components.joined(i, j) {
                continue;
            }
            // Whatever is still to be joined is at least as far apart as the nearest pair left.
            span.lower = span.lower.max(pair.key);
            let nearest = self.nearest[i * self.count + j];
            let reach = nearest.reach.sqrt();
            if reach - pair.key <= (relative * reach).max(absolute) {
                self.components.join(i, j);
                span.widen(reach, nearest);
            } else if self.nodes < budget {
                self.split(frame, outline, pair, pair.key);
            } else {
                self.dive(frame, outline, pair);
                break;
            }
        }
        self.bridge(&mut span);
        span
    }

    /// Follows the nearest parts of some of the nearest pairs down, for points that are nearer than those met
    /// by a search that was cut short.
    fn dive(&mut self, frame: &Frame, outline: &Outline, first: Pair) {
        let mut pairs = vec![first];
        pairs.extend(std::iter::from_fn(|| self.by_distance.pop()).take(DIVES));
        for Pair { mut u, mut v, i, j, .. } in pairs {
            for _ in 0..DEPTH {
                let (parts, first) = self.parts_of_larger(frame, u, v);
                let mut nearest = (f64::INFINITY, u, v);
                for part in parts {
                    let (u, v) = if first { (part, v) } else { (u, part) };
                    let look = self.look(outline, u, v);
                    self.note(&look, i, j);
                    if look.reach < nearest.0 {
                        nearest = (look.reach, u, v);
                    }
                }
                (_, u, v) = nearest;
            }
        }
    }

    /// An upper bound of the widest gap from the nearest points known alone.
    pub fn reach(&mut self) -> Span {
        let mut span = Span::default();
        self.components.reset(self.count);
        self.bridge(&mut span);
        span
    }

    /// Joins what is left by the nearest points known.
    fn bridge(&mut self, span: &mut Span) {
        while self.components.count() > 1 {
            let mut best: Option<(f64, usize, usize)> = None;
            for i in 0..self.count {
                for j in i + 1..self.count {
                    let reach = self.nearest[i * self.count + j].reach;
                    if best.is_none_or(|(least, ..)| reach < least) && !self.components.joined(i, j) {
                        best = Some((reach, i, j));
                    }
                }
            }
            let Some((reach, i, j)) = best else { return };
            self.components.join(i, j);
            span.widen(reach.sqrt(), self.nearest[i * self.count + j]);
        }
    }
}

/// The widest gap, in the plane.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Span {
    pub lower: f64,
    pub upper: f64,
    /// The points that realise the upper bound.
    pub widest: Option<Nearest>,
}

impl Span {
    fn widen(&mut self, reach: f64, nearest: Nearest) {
        if reach >= self.upper {
            self.upper = reach;
            self.widest = Some(nearest);
        }
    }
}

/// How many pairs are followed down after a search that was cut short, and how far.
const DIVES: usize = 8;
const DEPTH: usize = 24;
/// Directions tried on a pair.
const ROUNDS: usize = 2;
/// How much more a pair of half the area counts against one that overlaps twice as deep. Some preference
/// for small pieces makes the search go deep at once where it can.
const DEPTH_FIRST: f64 = 0.25;
