//! A whole fractal function from candidate maps.

mod polyline;
mod within;

pub use within::{Within, assemble_within};

use glam::{DMat2, DVec2};

use super::features::Features;
use super::options::HoughOptions;
use super::pairing::Pairing;
use super::polish::polish;
use super::refine::Candidate;
use crate::error::FunctionError;
use crate::fractal::function::FractalFunction;
use crate::fractal::piece::Piece;

/// What one piece costs, in sums of squares of half heights: all are tried. What is cheap by its collage may not be by
/// its attractor.
const PIECE_PRICES: [f64; 5] = [0.005, 0.02, 0.06, 0.15, 0.4];

/// The strongest candidates.
const MOST_CANDIDATES: usize = 32;

/// Copies that hardly shrink are nearly the graph itself, and near it whatever it is: they are also tried without.
const WIDEST_COPY: f64 = 0.75;

/// Of all that were tried, the best few are polished, which takes longest.
const MOST_POLISHED: usize = 3;

/// What a piece counts when they are compared by their attractors, in sums of squares of half heights.
const PIECE_WORTH: f64 = 0.01;

/// What a straight piece from one fine point to the next counts, in pieces: it tells nothing but that point.
const STRAIGHT_PRICE: f64 = 3.0;

/// The largest |c| of a piece.
const MOST_C: f64 = 0.95;

/// The most points of a recurrent function that is looked for.
const MOST_KNOTS: usize = 256;

/// Which kind a function is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Model {
    /// Every piece copies the whole.
    Fif,
    /// Every piece copies what is between two knots.
    Rfif,
    /// Pieces copy any parts.
    Pfif,
}

/// A function put together from candidates.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// Its kind: the simplest that it is.
    pub model: Model,
    /// The function. As FIF or RFIF it is continuous, and goes through its knots.
    pub function: FractalFunction,
    /// The candidate of each piece, before a RFIF was cut finer; none where it is straight, because no candidate holds.
    pub used: Vec<Option<usize>>,
    /// Mean square distance from the fine feature points.
    pub mean_square: f64,
    /// The largest distance from them.
    pub worst: f64,
}

/// Covers the interval with the fewest candidates that do it well, and with straight pieces where none holds.
///
/// Each piece is cut from the range of its candidate; its c is found by least squares with the ends tied to the feature
/// points, so that pieces meet. Which candidate goes where is the cheapest way from left to right over the fine feature
/// points: squares of errors, and a price for each new piece.
///
/// # Errors
/// Where the pieces are no function; not with features and candidates of one graph.
pub fn assemble(
    coarse: &Features,
    fine: &Features,
    candidates: &[Candidate],
) -> Result<Assembly, FunctionError> {
    let pairing = Pairing::new(coarse, fine, HoughOptions::default());
    let mut candidates: Vec<_> = candidates.to_vec();
    // Those that cannot be used keep their places.
    for candidate in &mut candidates {
        let usable = candidate.map.iter().chain(&candidate.domain).all(|x| x.is_finite())
            && candidate.map[0].abs() < 1.0
            && candidate.map[0].abs() > 1e-6;
        if !usable {
            candidate.domain = [f64::INFINITY; 2];
        }
    }
    let unit = pairing.frame.height(1.0);
    let score = |whole: &Assembly| {
        let straight = whole.used.iter().filter(|used| used.is_none()).count() as f64;
        let pieces = whole.used.len() as f64 + (STRAIGHT_PRICE - 1.0) * straight;
        whole.mean_square / (unit * unit) * fine.points().len() as f64 + PIECE_WORTH * pieces
    };
    // Weak candidates may lead to parts that are never closed; the strongest alone are tried, too.
    let strongest = candidates.get(..MOST_CANDIDATES).unwrap_or(&candidates).to_vec();
    let shrinking = |mut pool: Vec<Candidate>| {
        // Again they keep their places.
        for candidate in pool.iter_mut().filter(|candidate| candidate.map[0].abs() > WIDEST_COPY) {
            candidate.domain = [f64::INFINITY; 2];
        }
        pool
    };
    let mut pools = vec![shrinking(candidates.clone()), shrinking(strongest.clone()), candidates, strongest];
    pools.dedup();
    let mut rough = Vec::new();
    for pool in &pools {
        for price in PIECE_PRICES {
            let stretches = cheapest(&pairing, fine, pool, price);
            let pieces: Vec<_> = stretches.iter().map(|stretch| piece(fine, pool, stretch)).collect();
            let used: Vec<_> = stretches.iter().map(|stretch| stretch.candidate).collect();
            let maps: Vec<_> = pieces.iter().map(|piece| (piece.map(), piece.domain)).collect();
            let whole = measured(fine, Model::Pfif, FractalFunction::pfif(&maps)?, used);
            rough.push((score(&whole), pieces, whole.used));
        }
    }
    rough.sort_by(|(a, ..), (b, ..)| a.total_cmp(b));
    rough.dedup_by(|(_, a, _), (_, b, _)| a == b);
    let mut best: Option<Assembly> = None;
    for (_, pieces, used) in rough.into_iter().take(MOST_POLISHED) {
        let next = whole(&pairing, fine, &pieces, used)?;
        if best.as_ref().is_none_or(|best| score(&next) < score(best)) {
            best = Some(next);
        }
    }
    best.ok_or(FunctionError::TooFewPoints { count: 0 })
}

/// A function of pieces that are tied to the fine feature points: as RFIF where it is one, and then polished.
pub(super) fn whole(
    pairing: &Pairing,
    fine: &Features,
    pieces: &[Piece],
    used: Vec<Option<usize>>,
) -> Result<Assembly, FunctionError> {
    let maps: Vec<_> = pieces.iter().map(|piece| (piece.map(), piece.domain)).collect();
    let mut function = FractalFunction::pfif(&maps)?;
    let mut model = model_of(fine, pieces);
    if let Some(recurrent) = function.to_recurrent(MOST_KNOTS) {
        function = polish(recurrent, fine, pairing.frame.height(1.0)).function()?;
        if model == Model::Pfif {
            model = Model::Rfif;
        }
    }
    Ok(measured(fine, model, function, used))
}

/// FIF where every piece copies the whole, else PFIF.
pub(super) fn model_of(fine: &Features, pieces: &[Piece]) -> Model {
    let all = fine.interval();
    if pieces.iter().all(|piece| piece.domain == all) { Model::Fif } else { Model::Pfif }
}

/// With how near it comes to the fine feature points.
pub(super) fn measured(
    fine: &Features,
    model: Model,
    function: FractalFunction,
    used: Vec<Option<usize>>,
) -> Assembly {
    let errors: Vec<_> = fine.points().iter().map(|p| (function.at(p.x) - p.y).abs()).collect();
    let mean_square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
    let worst = errors.iter().copied().fold(0.0, f64::max);
    Assembly { model, function, used, mean_square, worst }
}

/// From one fine point to another, by one candidate or straight.
pub(super) struct Stretch {
    pub from: usize,
    pub to: usize,
    pub candidate: Option<usize>,
}

fn source(candidate: &Candidate, t: f64) -> f64 {
    (t - candidate.map[3]) / candidate.map[0]
}

fn cheapest(pairing: &Pairing, fine: &Features, candidates: &[Candidate], price: f64) -> Vec<Stretch> {
    let points = fine.points();
    let [start, end] = fine.interval();
    let slack = 1e-6 * (end - start);
    let unit = pairing.frame.height(1.0);
    let error = |candidate: &Candidate, at: DVec2| {
        let s = source(candidate, at.x);
        let [low, high] = candidate.domain;
        if !(s >= low.max(start) - slack && s <= high.min(end) + slack) {
            return f64::INFINITY;
        }
        let [_, b, c, _, e] = candidate.map;
        ((b * s + c * fine.at(s) + e - at.y) / unit).powi(2)
    };
    // For each candidate: the cost of a way that ends in it here, and where its stretch began.
    let mut now: Vec<(f64, usize)> = candidates.iter().map(|c| (price + error(c, points[0]), 0)).collect();
    let mut best = vec![(0.0, None::<usize>, 0_usize)];
    for (at, &p) in points.iter().enumerate().skip(1) {
        let before = best[at - 1].0;
        let mut here = (before + STRAIGHT_PRICE * price, None, at - 1);
        for (index, candidate) in candidates.iter().enumerate() {
            let turn = before + price + error(candidate, points[at - 1]);
            if turn < now[index].0 {
                now[index] = (turn, at - 1);
            }
            now[index].0 += error(candidate, p);
            if now[index].0 < here.0 {
                here = (now[index].0, Some(index), now[index].1);
            }
        }
        best.push(here);
    }
    let mut stretches = Vec::new();
    let mut to = points.len() - 1;
    while to > 0 {
        let (_, candidate, from) = best[to];
        stretches.push(Stretch { from, to, candidate });
        to = from;
    }
    stretches.reverse();
    stretches
}

/// The piece over a stretch, its ends tied.
pub(super) fn piece(fine: &Features, candidates: &[Candidate], stretch: &Stretch) -> Piece {
    let points = &fine.points()[stretch.from..=stretch.to];
    let (first, last) = (points[0], points[points.len() - 1]);
    let [start, end] = fine.interval();
    let range = [first.x, last.x];
    let ends = [first.y, last.y].map(|x| DVec2::new(x, 0.0));
    let Some(candidate) = stretch.candidate.map(|index| &candidates[index]) else {
        let whole = [start, end].map(|t| DVec2::new(fine.at(t), 0.0));
        return Piece::through([range, [start, end]], false, DMat2::ZERO, ends, whole);
    };
    let snap = |t: f64| {
        let near = fine.points()[fine.nearest(t)].x;
        if (near - t).abs() <= 1e-6 * (end - start) { near } else { t.clamp(start, end) }
    };
    let reflected = candidate.map[0] < 0.0;
    let mut domain = range.map(|t| snap(source(candidate, t)));
    if reflected {
        domain.reverse();
    }
    let heights = domain.map(|t| fine.at(t));
    let (mut both, mut own) = (0.0, 0.0);
    for p in points {
        let share = (p.x - first.x) / (last.x - first.x);
        let along = if reflected { 1.0 - share } else { share };
        let s = domain[0] + along * (domain[1] - domain[0]);
        let bow = fine.at(s) - (heights[0] + along * (heights[1] - heights[0]));
        both += bow * (p.y - (first.y + share * (last.y - first.y)));
        own += bow * bow;
    }
    let c = if own > 0.0 { (both / own).clamp(-MOST_C, MOST_C) } else { 0.0 };
    let factor = DMat2::from_cols(DVec2::new(c, 0.0), DVec2::ZERO);
    Piece::through([range, domain], reflected, factor, ends, heights.map(|x| DVec2::new(x, 0.0)))
}
