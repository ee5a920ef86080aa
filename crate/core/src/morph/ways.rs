//! All that is worth trying where the way that is there breaks.

use std::cmp::Ordering;

use glam::{DMat2, DVec2};

use crate::bounds::hull2::Hull;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;
use crate::morph::correspondence2::{Costs, Frame, candidates};
use crate::morph::options::Mode;
use crate::morph::pairing::{Weighted, refined, weighted};
use crate::morph::route::{Route, RouteKind, by_joints, laid, routes};

/// Matchings and windings of each route.
const MOST_MATCHINGS: usize = 12;
/// Ways to split the pieces of one shape.
const MOST_SPLITS: usize = 24;
/// Matchings whose last shape is laid elsewhere.
const MOST_PLACED: usize = 6;

/// Ways to bring two shapes to a morph that are worth being looked at where the plain one breaks, the most promising
/// first, at most `limit`. What is sure comes first: a way that keeps joints joined. Then each of [`routes`] with other
/// matchings and windings, and with the last shape laid elsewhere, where its pieces have less far to go: a conjugate
/// by a similarity is the same shape, but its translations are others, and so is the locus.
#[must_use]
pub fn ways(from: &Ifs, to: &Ifs, limit: usize) -> Vec<Route> {
    let mut sure: Vec<Route> = by_joints(from, to).into_iter().collect();
    let mut others = Vec::new();
    for route in routes(from, to).into_iter().chain(split(from, to)) {
        if route.kind == RouteKind::Joints {
            continue;
        }
        let (Ok(a), Ok(b)) = (Ifs::new(route.from.clone()), Ifs::new(route.to.clone())) else { continue };
        let matched = matched(&route, &a, &b);
        for route in matched.iter().take(MOST_PLACED) {
            others.extend(placed(route, &a, &b));
        }
        others.extend(matched);
    }
    others.sort_by(|a, b| a.cost.total_cmp(&b.cost));
    for other in others {
        if sure.len() >= limit {
            break;
        }
        if !sure.iter().any(|route| route.is_like(&other)) {
            sure.push(other);
        }
    }
    sure
}

/// Pieces of the shape of fewer maps split in all ways, one after the other, until there are as many as of the other.
fn split(from: &Ifs, to: &Ifs) -> Vec<Route> {
    let first = from.len() < to.len();
    let (few, many) = if first { (from, to) } else { (to, from) };
    let gain = few.len() - 1;
    if gain == 0 || many.len() == few.len() || (many.len() - few.len()) % gain != 0 {
        return Vec::new();
    }
    let (few, many) = (weighted(few), weighted(many));
    let mut all = vec![few.clone()];
    while all[0].len() < many.len() {
        let mut next: Vec<Vec<Weighted>> = Vec::new();
        for maps in &all {
            for k in 0..maps.len() {
                let mut longer = refined(maps, &few, k);
                longer
                    .sort_by(|(a, _), (b, _)| a.to_row().partial_cmp(&b.to_row()).unwrap_or(Ordering::Equal));
                // The probabilities of the same maps differ by rounding alone.
                let same =
                    |other: &Vec<Weighted>| other.iter().map(|one| one.0).eq(longer.iter().map(|one| one.0));
                if !next.iter().any(same) {
                    next.push(longer);
                }
            }
        }
        next.truncate(MOST_SPLITS);
        all = next;
    }
    let frames = [Frame::of(from), Frame::of(to)];
    let which = if first { "first" } else { "last" };
    let made = |maps: Vec<Weighted>| {
        let other = many.clone();
        let (from, to) = if first { (maps, other) } else { (other, maps) };
        let about = format!("Pieces of the {which} shape are split, so that it has {} maps.", many.len());
        let mut route = Route::of(RouteKind::Refine, about, from, to);
        route.correspondence = Costs::of(&route.from, &route.to, frames).best();
        route
    };
    all.into_iter().map(made).collect()
}

/// The same maps, matched and wound otherwise.
fn matched(route: &Route, a: &Ifs, b: &Ifs) -> Vec<Route> {
    // They have equally many maps.
    let Ok(all) = candidates(a, b, MOST_MATCHINGS) else { return vec![route.clone()] };
    let mut found = vec![route.clone()];
    found.extend(all.into_iter().map(|candidate| {
        let mut about = route.about.clone();
        if candidate.correspondence != route.correspondence {
            about.push_str(" The pieces are matched in another order.");
        }
        match candidate.turns.iter().filter(|&&turn| turn != 0).count() {
            0 => {}
            1 => about.push_str(" One piece turns the other way round."),
            count => about.push_str(&format!(" {count} pieces turn the other way round.")),
        }
        Route {
            kind: RouteKind::Correspondence,
            about,
            correspondence: candidate.correspondence,
            turns: candidate.turns,
            cost: candidate.cost,
            ..route.clone()
        }
    }));
    found
}

/// The same matching with the last shape laid so that its pieces are nearer those that become them: all of them
/// together, or the fixed points of two.
fn placed(route: &Route, a: &Ifs, b: &Ifs) -> Vec<Route> {
    let (h, k) = (Hull::of(a), Hull::of(b));
    let last: Vec<Affine2> = route.correspondence.iter().map(|&j| route.to[j]).collect();
    let mut places = Vec::new();
    let places_of = |maps: &[Affine2], hull: &Hull| -> Vec<DVec2> {
        let mut all: Vec<DVec2> = maps.iter().map(|map| map.apply(hull.centre())).collect();
        all.push(hull.centre());
        all
    };
    places.extend(nearest(&places_of(&last, &k), &places_of(&route.from, &h)));
    let fixed =
        |maps: &[Affine2]| -> Vec<Option<DVec2>> { maps.iter().map(|map| map.fixed_point()).collect() };
    let (p, q) = (fixed(&last), fixed(&route.from));
    for j in 0..p.len() {
        for i in 0..j {
            if let (Some(a), Some(b), Some(c), Some(d)) = (p[i], p[j], q[i], q[j]) {
                places.extend(nearest(&[a, b], &[c, d]));
            }
        }
    }
    let frame = Frame::of(a);
    let mut found = Vec::new();
    for place in places {
        let Some(to) = route.to.iter().map(|map| map.conjugate(place)).collect::<Option<Vec<_>>>() else {
            continue;
        };
        let costs = Costs::of(&route.from, &to, [frame, frame]);
        let cost = costs.candidate(route.correspondence.clone(), route.turns.clone()).cost;
        for mode in [None, Some(Mode::Linear)] {
            if mode.is_some() && route.turns.iter().any(|&turn| turn != 0) {
                continue;
            }
            let about = match mode {
                Some(_) => format!("{}{} The maps are mixed number by number.", route.about, laid(place)),
                None => format!("{}{}", route.about, laid(place)),
            };
            let (kind, to, place) = (RouteKind::Place, to.clone(), Some(place));
            found.push(Route { kind, about, to, mode, place, cost, ..route.clone() });
        }
    }
    found
}

/// The similarity without a reflection that takes points as near to others as can be, by least squares (Umeyama 1991).
fn nearest(from: &[DVec2], to: &[DVec2]) -> Option<Affine2> {
    let middle = |points: &[DVec2]| points.iter().sum::<DVec2>() / points.len() as f64;
    let (a, b) = (middle(from), middle(to));
    let (mut along, mut across, mut size) = (0.0, 0.0, 0.0);
    for (&p, &q) in from.iter().zip(to) {
        let (p, q) = (p - a, q - b);
        along += p.dot(q);
        across += p.perp_dot(q);
        size += p.length_squared();
    }
    let factor = DVec2::new(along, across) / size;
    let scale = factor.length();
    if !(1e-3..=1e3).contains(&scale) {
        return None;
    }
    let linear = DMat2::from_cols(factor, factor.perp());
    Some(Affine2::new(linear, b - linear * a))
}
