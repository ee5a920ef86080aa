//! Which arc an edge should copy, and what a knot more or less would do: estimates without refinement.
//!
//! All stretches of the outline and all arcs of the curve are seen from their chords, as heights over a grid on it.
//! What a line through the heights explains is taken off: knots are free, and will see to it. Then a copy, and a corner
//! as well, is a regression of one unknown.

use glam::DVec2;

use super::heights::{CHORD_PLACES, Heights, Shape, free_of_lines, heights};
use crate::closed::{ArcCopy, CONTRACTION, ClosedCurve, MAX_SPAN};

/// The largest factor that is proposed.
const MAX_FACTOR: f64 = 1.5;

/// The longest edge that copies an arc, in parts of the arc's chord.
const MAX_RATIO: f64 = 0.85 * CONTRACTION;

/// An arc that may be copied.
#[derive(Clone, Debug)]
struct Arc {
    from: usize,
    span: usize,
    length: f64,
    /// Of unit norm, free of lines.
    shape: Shape,
    /// What the norm was: heights are divided by it.
    norm: f64,
}

/// A proposal for a stretch of the outline.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Proposal {
    /// The sum of squares that it takes off.
    pub gain: f64,
    pub copy: ArcCopy,
}

/// A stretch of the outline as one edge.
#[derive(Clone, Debug)]
pub(crate) struct Stretch {
    /// Free of lines, in plane units.
    rest: Shape,
    /// The sum of squares from its best line.
    pub straight: f64,
    /// Points of the outline for each place of the grid.
    weight: f64,
    chord: f64,
}

/// The arcs of a curve, ready to be compared.
#[derive(Clone, Debug)]
pub(crate) struct Library {
    arcs: Vec<Arc>,
    /// Where those of each knot begin in `arcs`, and their number at the end.
    starts: Vec<usize>,
    corners: Vec<(f64, Shape)>,
}

impl Library {
    #[inline(never)]
    pub fn new(curve: &ClosedCurve, tolerance: f64, levels: usize) -> Self {
        let expansion = curve.expand(tolerance, levels);
        let count = curve.knots.len();
        let edges: Vec<_> = (0..count).map(|i| expansion.edge(i)).collect();
        let mut arcs = Vec::new();
        let mut starts = Vec::with_capacity(count + 1);
        for from in 0..count {
            starts.push(arcs.len());
            for span in 2..=MAX_SPAN.min(count - 1) {
                let ends = [curve.knots[from], curve.knot(from + span)];
                let length = ends[0].distance(ends[1]);
                let points = (0..span).flat_map(|k| edges[(from + k) % count].iter().copied());
                let points = points.chain([ends[1]]);
                let Some(mut shape) = heights(points, ends[0], ends[1]) else { continue };
                let norm = free_of_lines(&mut shape).sqrt();
                if norm <= 1e-6 {
                    continue;
                }
                shape.iter_mut().for_each(|h| *h /= norm);
                arcs.push(Arc { from, span, length, shape: Shape::new(&shape), norm });
            }
        }
        starts.push(arcs.len());
        let corner = |at: usize| {
            let place = (at + 1) as f64 / CHORD_PLACES as f64;
            let mut shape: Heights =
                std::array::from_fn(|g| ((g as f64 + 0.5) / CHORD_PLACES as f64 - place).max(0.0));
            let norm = free_of_lines(&mut shape).sqrt();
            shape.iter_mut().for_each(|h| *h /= norm);
            (place, Shape::new(&shape))
        };
        Self { arcs, starts, corners: (2..CHORD_PLACES - 3).map(corner).collect() }
    }

    /// What it costs to look through it for so many edges, in units of the refiner's work.
    pub fn work(&self, edges: usize) -> u64 {
        (self.arcs.len() * (20 + edges) / 4 + 100 * edges) as u64
    }

    /// The best copy for a stretch, among arcs for which `allowed` says so by their first and last knot and span.
    #[inline(never)]
    pub fn best(&self, stretch: &Stretch, mut allowed: impl FnMut(usize, usize) -> bool) -> Option<Proposal> {
        let mut best: Option<Proposal> = None;
        let mut enough = f64::NEG_INFINITY;
        for arc in self.arcs.iter().filter(|arc| stretch.chord <= MAX_RATIO * arc.length) {
            for (reversed, dot) in [false, true].into_iter().zip(stretch.rest.dots(&arc.shape)) {
                // No factor takes off more than this.
                if stretch.weight * dot * dot <= enough {
                    continue;
                }
                let most = MAX_FACTOR.min(0.92 * CONTRACTION * arc.length / stretch.chord);
                let unit = arc.norm * stretch.chord;
                let c = (dot / unit).clamp(-most, most);
                let gain = stretch.weight * c * unit * (2.0 * dot - c * unit);
                if best.is_none_or(|best| gain > best.gain) && allowed(arc.from, arc.span) {
                    let copy = ArcCopy { from: arc.from, span: arc.span, reversed, c };
                    best = Some(Proposal { gain, copy });
                    enough = gain;
                }
            }
        }
        best
    }

    /// What a given copy takes off.
    pub fn gain(&self, stretch: &Stretch, copy: &ArcCopy) -> f64 {
        let arcs = &self.arcs[self.starts[copy.from]..self.starts[copy.from + 1]];
        let Some(arc) = arcs.iter().find(|arc| arc.span == copy.span) else { return 0.0 };
        let dot = stretch.rest.dots(&arc.shape)[usize::from(copy.reversed)];
        let size = copy.c * arc.norm * stretch.chord;
        stretch.weight * size * (2.0 * dot - size)
    }

    /// What a corner takes off, and where it is on the chord.
    #[inline(never)]
    pub fn corner(&self, stretch: &Stretch) -> (f64, f64) {
        let mut best = (0.0, 0.5);
        for (place, shape) in &self.corners {
            let gain = stretch.weight * stretch.rest.dots(shape)[0].powi(2);
            if gain > best.0 {
                best = (gain, *place);
            }
        }
        best
    }
}

impl Stretch {
    /// The points from index `from` to `to` of a ring, as one edge between two knots; none where it turns back on
    /// itself.
    #[inline(never)]
    pub fn new(ring: &[DVec2], from: usize, to: usize, ends: [DVec2; 2]) -> Option<Self> {
        let count = ring.len();
        let many = (to + count - from) % count;
        let points = (0..=many).map(|i| ring[(from + i) % count]);
        let mut rest = heights(points, ends[0], ends[1])?;
        let chord = ends[0].distance(ends[1]);
        rest.iter_mut().for_each(|h| *h *= chord);
        let weight = many.max(1) as f64 / CHORD_PLACES as f64;
        let straight = weight * free_of_lines(&mut rest);
        Some(Self { rest: Shape::new(&rest), straight, weight, chord })
    }
}
