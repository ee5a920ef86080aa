//! Which arc an edge should copy, and what a knot more or less would do: estimates without refinement.
//!
//! All stretches of the outline and all arcs of the curve are seen from their chords, as heights over a grid on it.
//! What a line through the heights explains is taken off: knots are free, and will see to it. Then a copy, and a corner
//! as well, is a regression of one unknown.

use glam::DVec2;

use crate::closed::{ArcCopy, CONTRACTION, ClosedCurve, MAX_SPAN, over};

/// Places on a chord.
const CHORD_PLACES: usize = 28;

/// The largest factor that is proposed.
const MAX_FACTOR: f64 = 1.5;

type Heights = [f64; CHORD_PLACES];

/// Heights over the chord in parts of its length, averaged where there are several; none where the arc leaves its chord
/// too far behind or ahead.
fn heights(points: impl Iterator<Item = DVec2>, from: DVec2, to: DVec2) -> Option<Heights> {
    let chord = to - from;
    let mut sums = [0.0; CHORD_PLACES];
    let mut counts = [0_u32; CHORD_PLACES];
    let mut last: Option<DVec2> = None;
    let place = |g: usize| (g as f64 + 0.5) / CHORD_PLACES as f64;
    for p in points {
        let w = over(p - from, chord);
        if !(w.x.abs() < 3.0 && w.y.abs() < 4.0) {
            return None;
        }
        if let Some(before) = last {
            let (a, b) = if before.x <= w.x { (before, w) } else { (w, before) };
            let first = (a.x * CHORD_PLACES as f64 - 0.5).ceil().max(0.0) as usize;
            for g in first..CHORD_PLACES {
                let u = place(g);
                if u > b.x {
                    break;
                }
                let share = if b.x > a.x { (u - a.x) / (b.x - a.x) } else { 0.5 };
                sums[g] += a.y + share * (b.y - a.y);
                counts[g] += 1;
            }
        }
        last = Some(w);
    }
    let mut grid = [0.0; CHORD_PLACES];
    let mut before = 0.0;
    for g in 0..CHORD_PLACES {
        if counts[g] > 0 {
            before = sums[g] / f64::from(counts[g]);
        }
        grid[g] = before;
    }
    Some(grid)
}

/// Takes a line's share off, and says what is left: the sum of squares.
fn free_of_lines(grid: &mut Heights) -> f64 {
    let mean = grid.iter().sum::<f64>() / CHORD_PLACES as f64;
    let place = |g: usize| (g as f64 + 0.5) / CHORD_PLACES as f64 - 0.5;
    let slope = (0..CHORD_PLACES).map(|g| place(g) * grid[g]).sum::<f64>()
        / (0..CHORD_PLACES).map(|g| place(g) * place(g)).sum::<f64>();
    let mut rest = 0.0;
    for (g, height) in grid.iter_mut().enumerate() {
        *height -= mean + slope * place(g);
        rest += *height * *height;
    }
    rest
}

/// An arc that may be copied.
struct Arc {
    from: usize,
    span: usize,
    reversed: bool,
    length: f64,
    /// Of unit norm, free of lines.
    shape: Heights,
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
pub(crate) struct Stretch {
    /// Free of lines, in plane units.
    rest: Heights,
    /// The sum of squares from its best line.
    pub straight: f64,
    /// Points of the outline for each place of the grid.
    weight: f64,
    chord: f64,
}

/// The arcs of a curve, ready to be compared.
pub(crate) struct Library {
    arcs: Vec<Arc>,
    corners: Vec<(f64, Heights)>,
}

impl Library {
    pub fn new(curve: &ClosedCurve, tolerance: f64, levels: usize) -> Self {
        let expansion = curve.expand(tolerance, levels);
        let count = curve.knots.len();
        let edges: Vec<_> = (0..count).map(|i| expansion.edge(i)).collect();
        let mut arcs = Vec::new();
        for from in 0..count {
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
                let mut back = shape;
                back.reverse();
                back.iter_mut().for_each(|h| *h = -*h);
                arcs.push(Arc { from, span, reversed: false, length, shape, norm });
                arcs.push(Arc { from, span, reversed: true, length, shape: back, norm });
            }
        }
        let corner = |at: usize| {
            let place = (at + 1) as f64 / CHORD_PLACES as f64;
            let mut shape: Heights =
                std::array::from_fn(|g| ((g as f64 + 0.5) / CHORD_PLACES as f64 - place).max(0.0));
            let norm = free_of_lines(&mut shape).sqrt();
            shape.iter_mut().for_each(|h| *h /= norm);
            (place, shape)
        };
        Self { arcs, corners: (2..CHORD_PLACES - 3).map(corner).collect() }
    }

    /// What it costs to look through it for so many edges, in units of the refiner's work.
    pub fn work(&self, edges: usize) -> u64 {
        (self.arcs.len() * (20 + edges) / 8 + 100 * edges) as u64
    }

    /// The best copy for a stretch, among arcs for which `allowed` says so by their first and last knot and span.
    pub fn best(&self, stretch: &Stretch, allowed: impl Fn(usize, usize) -> bool) -> Option<Proposal> {
        let mut best: Option<Proposal> = None;
        for arc in &self.arcs {
            let ratio = stretch.chord / arc.length;
            if ratio > 0.85 * CONTRACTION {
                continue;
            }
            let dot = dot(&stretch.rest, &arc.shape);
            let most = MAX_FACTOR.min(0.92 * CONTRACTION / ratio);
            let unit = arc.norm * stretch.chord;
            let c = (dot / unit).clamp(-most, most);
            let gain = stretch.weight * c * unit * (2.0 * dot - c * unit);
            if best.is_none_or(|best| gain > best.gain) && allowed(arc.from, arc.span) {
                let copy = ArcCopy { from: arc.from, span: arc.span, reversed: arc.reversed, c };
                best = Some(Proposal { gain, copy });
            }
        }
        best
    }

    /// What a given copy takes off.
    pub fn gain(&self, stretch: &Stretch, copy: &ArcCopy) -> f64 {
        let same = |arc: &&Arc| (arc.from, arc.span, arc.reversed) == (copy.from, copy.span, copy.reversed);
        let Some(arc) = self.arcs.iter().find(same) else { return 0.0 };
        let dot = dot(&stretch.rest, &arc.shape);
        let size = copy.c * arc.norm * stretch.chord;
        stretch.weight * size * (2.0 * dot - size)
    }

    /// What a corner takes off, and where it is on the chord.
    pub fn corner(&self, stretch: &Stretch) -> (f64, f64) {
        let mut best = (0.0, 0.5);
        for (place, shape) in &self.corners {
            let gain = stretch.weight * dot(&stretch.rest, shape).powi(2);
            if gain > best.0 {
                best = (gain, *place);
            }
        }
        best
    }
}

fn dot(a: &Heights, b: &Heights) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

impl Stretch {
    /// The points from index `from` to `to` of a ring, as one edge between two knots; none where it turns back on
    /// itself.
    pub fn new(ring: &[DVec2], from: usize, to: usize, ends: [DVec2; 2]) -> Option<Self> {
        let count = ring.len();
        let many = (to + count - from) % count;
        let points = (0..=many).map(|i| ring[(from + i) % count]);
        let mut rest = heights(points, ends[0], ends[1])?;
        let chord = ends[0].distance(ends[1]);
        rest.iter_mut().for_each(|h| *h *= chord);
        let weight = many.max(1) as f64 / CHORD_PLACES as f64;
        let straight = weight * free_of_lines(&mut rest);
        Some(Self { rest, straight, weight, chord })
    }
}
