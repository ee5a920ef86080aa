//! The shortest function of candidates that is nowhere farther off than a tolerance.

use glam::DVec2;

use super::super::features::Features;
use super::super::refine::Candidate;
use super::polyline::Chords;
use super::{Assembly, MOST_C, Model, assemble, measured};
use crate::error::FunctionError;
use crate::fractal::function::FractalFunction;

/// The strongest candidates.
const MOST_COPIES: usize = 96;

/// Copies begin and end at no more feature points than about this, whatever their number.
const MOST_ENDS: usize = 256;

/// A copy of fewer steps costs more numbers than the corners that it spares.
const FEWEST_STEPS: usize = 3;

/// Pieces are so near to copies of the graph, in parts of the tolerance. What they are copies of in the end is the
/// function itself, so that errors add up; which part suffices is tried.
const SHARES: [f64; 6] = [1.0, 0.75, 0.5, 0.3, 0.15, 0.05];

/// What belongs to a copy beside its corner: how rough, and from where to where.
const COPY_NUMBERS: usize = 3;

/// A gap between pieces, in heights: above it a function costs more numbers than are counted here.
const CLOSED: f64 = 1e-6;

/// A function, and what it is worth.
#[derive(Clone, Debug, PartialEq)]
pub struct Within {
    /// The function.
    pub assembly: Assembly,
    /// How many numbers it is made of: two a corner, a factor a copy, and two more where it copies only a part.
    pub numbers: usize,
    /// How many a polyline takes that is as near.
    pub polyline: usize,
}

/// From one feature point to another by a candidate.
#[derive(Clone, Copy)]
struct Copy {
    candidate: usize,
    c: f64,
    off: f64,
}

/// A function of as few numbers as are found that is nowhere farther off than `tolerance`, in heights of the graph.
///
/// The pieces are found by dynamic programming over the fine feature points: each is straight, or a copy that one of
/// the candidates proposes. What it promises holds for what its pieces make in the end, at the fine feature points: it
/// is within the tolerance, and no polyline with corners at fine feature points that is as near has fewer numbers.
/// Where copies do not pay, it is the nearest of these polylines itself.
///
/// A tolerance of 0 or none goes through all points.
///
/// # Errors
/// Where the pieces are no function; not with features of one graph.
pub fn assemble_within(
    coarse: &Features,
    fine: &Features,
    candidates: &[Candidate],
    tolerance: f64,
) -> Result<Within, FunctionError> {
    let [low, high] = fine.heights();
    let tall = high - low;
    let tolerance = if tolerance > 0.0 { tolerance.min(1.0) * tall } else { 0.0 };
    let chords = Chords::of(fine);
    let corners = chords.nearest(chords.fewest(tolerance).len() - 1);
    let straight: Vec<_> = corners.windows(2).map(|pair| (pair[0], pair[1], None)).collect();
    let mut best = made(fine, candidates, &straight)?;
    let polyline = best.numbers;
    let room = tolerance * (1.0 + 1e-9);
    let mut offer = |next: Within| {
        let better = (next.numbers, next.assembly.worst) < (best.numbers, best.assembly.worst);
        if next.assembly.worst <= room && next.numbers < polyline && better {
            best = next;
        }
    };
    if tolerance > 0.0 {
        let copies = copies(fine, candidates);
        for share in SHARES {
            let pieces = cheapest(fine, &chords, &copies, candidates, share * tolerance);
            // What is no function is none of the ways.
            if let Ok(next) = made(fine, candidates, &pieces) {
                offer(next);
            }
        }
        let other = assemble(coarse, fine, candidates)?;
        if other.function.curve().widest_gap() <= CLOSED * tall {
            offer(Within { numbers: numbers(&other.function), polyline, assembly: other });
        }
    }
    Ok(Within { polyline, ..best })
}

/// How many numbers a function without gaps is made of.
fn numbers(function: &FractalFunction) -> usize {
    let curve = function.curve();
    let all = curve.interval();
    let pieces = curve.pieces().iter();
    let copies = pieces.map(|piece| match piece.factor.x_axis.x {
        0.0 => 0,
        _ if piece.domain == all => 1,
        _ => COPY_NUMBERS,
    });
    2 * (curve.pieces().len() + 1) + copies.sum::<usize>()
}

/// The part of the graph that a candidate takes to a range, snapped to feature points that are as good as there.
fn domain(fine: &Features, candidate: &Candidate, range: [f64; 2]) -> Option<[f64; 2]> {
    let [start, end] = fine.interval();
    let near = 1e-6 * (end - start);
    let mut domain = range.map(|t| (t - candidate.map[3]) / candidate.map[0]);
    if candidate.map[0] < 0.0 {
        domain.reverse();
    }
    (domain[0] >= start - near && domain[1] <= end + near).then_some(())?;
    let domain = domain.map(|t| {
        let point = fine.points()[fine.nearest(t)].x;
        if (point - t).abs() <= near { point } else { t.clamp(start, end) }
    });
    (domain[1] - domain[0] > range[1] - range[0]).then_some(domain)
}

/// The nearest copy between any two ends, at `from * count + to`.
fn copies(fine: &Features, candidates: &[Candidate]) -> Vec<Option<Copy>> {
    let points = fine.points();
    let count = points.len();
    let step = (count - 1).div_ceil(MOST_ENDS);
    let mut nearest: Vec<Option<Copy>> = vec![None; count * count];
    let mut images = vec![0.0; count];
    for (index, candidate) in candidates.iter().take(MOST_COPIES).enumerate() {
        let [a, .., d, _] = candidate.map;
        if !(1e-6..1.0).contains(&a.abs()) || !d.is_finite() {
            continue;
        }
        for (image, p) in images.iter_mut().zip(points) {
            *image = fine.at((p.x - d) / a);
        }
        for from in (0..count).step_by(step) {
            for to in (from + FEWEST_STEPS..count).filter(|to| to % step == 0 || to + 1 == count) {
                if domain(fine, candidate, [points[from].x, points[to].x]).is_none() {
                    continue;
                }
                let found = &mut nearest[from * count + to];
                let least = found.map_or(f64::INFINITY, |copy| copy.off);
                if let Some((c, off)) = laid(&points[from..=to], &images[from..=to], least) {
                    *found = Some(Copy { candidate: index, c, off });
                }
            }
        }
    }
    nearest
}

/// The factor by least squares of a copy that is tied at its ends, and how far it is off, where that is less than the
/// least.
fn laid(points: &[DVec2], images: &[f64], least: f64) -> Option<(f64, f64)> {
    let last = points.len() - 1;
    let (a, b) = (points[0], points[last]);
    let bows = |k: usize| {
        let share = (points[k].x - a.x) / (b.x - a.x);
        let gap = points[k].y - (a.y + share * (b.y - a.y));
        (gap, images[k] - (images[0] + share * (images[last] - images[0])))
    };
    let (mut both, mut own) = (0.0, 0.0);
    for k in 1..last {
        let (gap, bow) = bows(k);
        both += gap * bow;
        own += bow * bow;
    }
    if !(own > 0.0 && both.is_finite()) {
        return None;
    }
    let c = (both / own).clamp(-MOST_C, MOST_C);
    let mut off = 0.0_f64;
    for k in 1..last {
        let (gap, bow) = bows(k);
        off = off.max((gap - c * bow).abs());
        if off >= least {
            return None;
        }
    }
    Some((c, off))
}

type Stretch = (usize, usize, Option<Copy>);

/// The pieces of fewest numbers that are each within a tolerance; of equals those that are nearest.
fn cheapest(
    fine: &Features,
    chords: &Chords,
    copies: &[Option<Copy>],
    candidates: &[Candidate],
    tolerance: f64,
) -> Vec<Stretch> {
    let points = fine.points();
    let count = points.len();
    let all = fine.interval();
    // Numbers, the sum of errors, and where the last piece began.
    let mut best: Vec<(usize, f64, usize, Option<Copy>)> = vec![(2, 0.0, 0, None)];
    for to in 1..count {
        let (numbers, errors, ..) = best[to - 1];
        let mut here = (numbers + 2, errors, to - 1, None);
        let mut offer = |next: (usize, f64, usize, Option<Copy>)| {
            if (next.0, next.1) < (here.0, here.1) {
                here = next;
            }
        };
        for from in (0..to).filter(|&from| chords.is_part(from, to)) {
            let (numbers, errors, ..) = best[from];
            let off = chords.farthest(from, to);
            if off <= tolerance {
                offer((numbers + 2, errors + off, from, None));
            }
            let Some(copy) = copies[from * count + to].filter(|copy| copy.off <= tolerance) else { continue };
            let domain = domain(fine, &candidates[copy.candidate], [points[from].x, points[to].x]);
            let costs = if domain == Some(all) { 1 } else { COPY_NUMBERS };
            offer((numbers + 2 + costs, errors + copy.off, from, Some(copy)));
        }
        best.push(here);
    }
    let mut pieces = Vec::new();
    let mut to = count - 1;
    while to > 0 {
        let (_, _, from, copy) = best[to];
        pieces.push((from, to, copy));
        to = from;
    }
    pieces.reverse();
    pieces
}

/// The function through the ends of pieces, with how near it comes.
fn made(fine: &Features, candidates: &[Candidate], pieces: &[Stretch]) -> Result<Within, FunctionError> {
    let points = fine.points();
    let all = fine.interval();
    let corners: Vec<_> =
        std::iter::once(points[0]).chain(pieces.iter().map(|&(_, to, _)| points[to])).collect();
    let (mut factors, mut mirrors, mut domains) = (Vec::new(), Vec::new(), Vec::new());
    for &(from, to, copy) in pieces {
        let part = copy.and_then(|copy| {
            let candidate = &candidates[copy.candidate];
            Some((copy.c, candidate.map[0] < 0.0, domain(fine, candidate, [points[from].x, points[to].x])?))
        });
        let (c, mirrored, domain) = part.unwrap_or((0.0, false, all));
        factors.push(c);
        mirrors.push(mirrored);
        domains.push(domain);
    }
    let function = FractalFunction::through(&corners, &factors, &mirrors, &domains)?;
    let is_corner = |t: f64| corners.iter().any(|p| p.x == t);
    let model = if domains.iter().all(|&domain| domain == all) {
        Model::Fif
    } else if domains.iter().flatten().all(|&t| is_corner(t)) {
        Model::Rfif
    } else {
        Model::Pfif
    };
    let used = pieces.iter().map(|(.., copy)| copy.map(|copy| copy.candidate)).collect();
    let numbers = numbers(&function);
    Ok(Within { assembly: measured(fine, model, function, used), numbers, polyline: numbers })
}
