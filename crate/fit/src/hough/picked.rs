//! A function of candidates that were picked by hand, with their domains: what the paper's own program was for.

use glam::{DMat2, DVec2};

use super::assemble::{Assembly, Stretch, measured, model_of, piece, whole};
use super::features::Features;
use super::options::HoughOptions;
use super::pairing::Pairing;
use super::refine::Candidate;
use crate::error::FunctionError;
use crate::fractal::function::FractalFunction;
use crate::fractal::piece::Piece;

/// A map with the part that it copies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pick {
    /// a, b, c, d, e of eq 1.
    pub map: [f64; 5],
    /// The part of the interval that it copies; where the copy goes follows from a and d.
    pub domain: [f64; 2],
}

/// Where a pick goes.
struct Place {
    pick: usize,
    range: [f64; 2],
}

/// A whole function of picks, in any order.
///
/// Where copies lie over each other they are cut in the middle; where none lies, a straight piece goes from fine
/// feature point to fine feature point. With `tied` the ends of pieces are moved to feature points, c is found by least
/// squares, and pieces meet. Without, maps stay as they are but for where they end: pieces may leave gaps, as the
/// paper's do.
///
/// Picks that are no copies of anything longer, or lie outside, are left out; `used` of the assembly tells which
/// remain.
///
/// # Errors
/// Where the pieces are no function: where a |c| is 1 or more, above all.
pub fn assemble_picked(
    coarse: &Features,
    fine: &Features,
    picks: &[Pick],
    tied: bool,
) -> Result<Assembly, FunctionError> {
    let places = places(fine, picks);
    let [start, end] = fine.interval();
    if tied {
        let candidates: Vec<_> = picks
            .iter()
            .map(|pick| Candidate { map: pick.map, domain: pick.domain, points: 0, rms: 0.0 })
            .collect();
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut from = 0;
        for place in places {
            let [low, high] = place.range.map(|t| fine.nearest(t));
            if low.max(from) >= high {
                continue;
            }
            if low > from {
                stretches.push(Stretch { from, to: low, candidate: None });
            }
            stretches.push(Stretch { from: low.max(from), to: high, candidate: Some(place.pick) });
            from = high;
        }
        let last = fine.points().len() - 1;
        if from == 0 {
            // Even a straight piece copies something longer.
            stretches.push(Stretch { from, to: last / 2, candidate: None });
            from = last / 2;
        }
        if from < last {
            stretches.push(Stretch { from, to: last, candidate: None });
        }
        let pieces: Vec<_> = stretches.iter().map(|stretch| piece(fine, &candidates, stretch)).collect();
        let used = stretches.iter().map(|stretch| stretch.candidate).collect();
        let pairing = Pairing::new(coarse, fine, HoughOptions::default());
        return whole(&pairing, fine, &pieces, used);
    }
    let near = 1e-6 * (end - start);
    let (mut pieces, mut used) = (Vec::new(), Vec::new());
    let mut from = start;
    for place in places {
        let Place { pick, range: [low, high] } = place;
        if low > from + near {
            pieces.push(straight(fine, [from, low]));
            used.push(None);
            from = low;
        }
        if high <= from + near {
            continue;
        }
        pieces.push(cut(&picks[pick], [from, high], [start, end]));
        used.push(Some(pick));
        from = high;
    }
    if from == start {
        from = f64::midpoint(start, end);
        pieces.push(straight(fine, [start, from]));
        used.push(None);
    }
    if from < end - near {
        pieces.push(straight(fine, [from, end]));
        used.push(None);
    } else if let Some(last) = pieces.last_mut() {
        last.range[1] = end;
    }
    let maps: Vec<_> = pieces.iter().map(|piece| (piece.map(), piece.domain)).collect();
    let model = model_of(fine, &pieces);
    Ok(measured(fine, model, FractalFunction::pfif(&maps)?, used))
}

/// Picks by where they go, from left to right, cut where they lie over each other.
fn places(fine: &Features, picks: &[Pick]) -> Vec<Place> {
    let [start, end] = fine.interval();
    let near = 1e-6 * (end - start);
    let place = |(pick, &Pick { map: [a, b, c, d, e], domain }): (usize, &Pick)| {
        let usable = [a, b, c, d, e, domain[0], domain[1]].iter().all(|x| x.abs() <= 1e100)
            && (1e-6..1.0).contains(&a.abs());
        let domain = domain.map(|t| t.clamp(start, end));
        let [p, q] = domain.map(|t| (a * t + d).clamp(start, end));
        (usable && domain[1] > domain[0] && (p - q).abs() > near)
            .then(|| Place { pick, range: [p.min(q), p.max(q)] })
    };
    let mut places: Vec<_> = picks.iter().enumerate().filter_map(place).collect();
    places.sort_by(|p, q| {
        let middle = |place: &Place| f64::midpoint(place.range[0], place.range[1]);
        middle(p).total_cmp(&middle(q))
    });
    for i in 1..places.len() {
        let (before, here) = (places[i - 1].range, places[i].range);
        if here[0] < before[1] {
            let cut = f64::midpoint(here[0].max(before[0]), before[1].min(here[1]));
            places[i - 1].range[1] = cut;
            places[i].range[0] = cut;
        }
    }
    places.retain(|place| place.range[1] - place.range[0] > near);
    places
}

/// The map of a pick over what is left of its range.
fn cut(pick: &Pick, range: [f64; 2], [start, end]: [f64; 2]) -> Piece {
    let [a, _, _, d, _] = pick.map;
    let mut domain = range.map(|t| ((t - d) / a).clamp(start, end));
    if a < 0.0 {
        domain.reverse();
    }
    Piece { range, domain, ..Piece::from_map(pick.map, domain) }
}

/// The chord over a hole.
fn straight(fine: &Features, range: [f64; 2]) -> Piece {
    let whole = fine.interval();
    let ends = |at: [f64; 2]| at.map(|t| DVec2::new(fine.at(t), 0.0));
    Piece::through([range, whole], false, DMat2::ZERO, ends(range), ends(whole))
}
