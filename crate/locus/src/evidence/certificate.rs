//! Proofs of disconnection that can be handed on.

use frond_core::{Affine2, Contraction, Ifs};
use glam::DVec2;

use crate::evidence::axis_scales::AxisScales;
use crate::evidence::separate::{Descent, Separation};
use crate::frame::Frame;
use crate::gap::kruskal::KruskalSearch;
use crate::gap::word_tree::WordTree;
use crate::magnification::Magnification;
use crate::overlap_graph::Components;
use crate::support::table::SupportTable;
use crate::support::trapping_polygon::TrappingPolygon;
use crate::verdict::Options;

/// A proof that an attractor is in several pieces, which can be checked without searching.
///
/// # What it proves
///
/// *There is an attractor `A`, and it lies in the polygon `P`.* Every word `u` of `letters` letters maps `P` strictly
/// into itself: `w_u(P)` is in the inside of `P`. Then `D = P - P` is the unit ball of a norm, and for the linear
/// part `M_u D = M_u P - M_u P` lies inside `D`: each of these finitely many words contracts in that norm. So they
/// have an attractor (Hutchinson 1981), which is that of the maps, and it is in every compact set that is mapped into
/// itself.
///
/// *It is in several pieces.* The piece of a word `u` lies in `w_u(P)`. For each of `pairs`, the direction `n` shows
/// that the pieces of its words are apart: `max n . w_u(P) < min n . w_v(P)`. A piece is the union of its parts; from
/// each pair of maps across the cut, splitting words into their parts leads to pairs that are listed. So what is
/// on one side of the cut has no point in common with what is on the other, and both are closed.
///
/// The crate `frond-check`, which shares no code with this one, replays it in exact arithmetic.
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate {
    /// The maps as rows, digit for digit those that it is about.
    pub maps: Vec<[f64; 6]>,
    /// The corners of a strictly convex polygon, counter-clockwise.
    pub polygon: Vec<DVec2>,
    /// Words of this many letters map the polygon into its inside. Mostly 1.
    pub letters: usize,
    /// For each map the side of the cut that it is on, 0 or 1.
    pub side: Vec<u8>,
    /// Pieces that are apart.
    pub pairs: Vec<Separation>,
}

/// A certificate that the attractor is disconnected, or `None` if that is not proved: it takes the verdict
/// [`Disconnected`](crate::Verdict::Disconnected) at these options, and a gap that shows beside rounding. As many looks
/// are spent again at most twice, and where these do not suffice, as many as the default options allow. A shape that is
/// stretched along an axis is also looked at in coordinates in which it is about as wide as high.
///
/// ```
/// use frond_core::{Affine2, Ifs};
/// use frond_locus::{Options, certificate};
///
/// let third = 1.0 / 3.0;
/// let maps = [0.0, 2.0 * third].map(|e| Affine2::from_row([third, 0.0, 0.0, third, e, 0.0]));
/// let found = certificate(&Ifs::new(maps.to_vec())?, &Options::default()).unwrap();
/// assert_eq!((found.side, found.pairs.len()), (vec![0, 1], 1));
/// # Ok::<(), frond_core::IfsError>(())
/// ```
#[must_use]
pub fn certificate(ifs: &Ifs, options: &Options) -> Option<Certificate> {
    let maps = ifs.maps();
    let Some(magnification) = Magnification::of(maps) else {
        return proved(maps, ifs.contraction(), options);
    };
    let seen = magnification.magnify(maps);
    let found = proved(&seen, &Contraction::find(&seen).ok()?, options)?;
    let polygon =
        found.polygon.iter().map(|&corner| magnification.exact_point(corner)).collect::<Option<_>>()?;
    Some(Certificate { maps: maps.iter().copied().map(Affine2::to_row).collect(), polygon, ..found })
}

fn proved(maps: &[Affine2], contraction: &Contraction, options: &Options) -> Option<Certificate> {
    let mut frame = Frame::default();
    frame.set_round(maps, contraction);
    if frame.point {
        return None;
    }
    let mut support = SupportTable::default();
    support.set(&frame.maps, 1e-4 * (1.0 - frame.factor), 4000);
    let mut words = WordTree::default();
    let mut search = KruskalSearch::begin(&frame, &mut support, &mut words, options.epsilon.max(0.0));
    search.settle(options.budget);
    let parts = search.coarsest();
    if parts.count() < 2 {
        return None;
    }
    // Refines what is known of the distances, so that the cut goes where the gap is widest.
    search.measure(0.3, 0.0, search.nodes().saturating_add(options.budget.min(20_000)));
    let side = cut(&search, maps.len(), &parts);
    let from = frame.from_round;
    let drawn = drawn(&frame, &support);
    let attempt = |attempt: &Attempt, budget: usize| {
        let frame = if attempt.drawn { drawn.as_ref()? } else { &frame };
        let polygon = TrappingPolygon::find(
            frame,
            support.diameter(frame.to_round * from),
            attempt.slack,
            attempt.coarsest,
        )?;
        let mut descent = Descent::new(frame, &polygon, budget / attempt.share);
        let across = (0..maps.len()).flat_map(|i| (0..maps.len()).map(move |j| (i, j)));
        let mut across = across.filter(|&(i, j)| side[i] == 0 && side[j] == 1);
        across.all(|(i, j)| descent.separate(i as u8, j as u8)).then(|| Certificate {
            maps: maps.iter().copied().map(Affine2::to_row).collect(),
            polygon: polygon.plane.clone(),
            letters: polygon.letters,
            side: side.clone(),
            pairs: descent.pairs,
        })
    };
    let within = |budget: usize| ATTEMPTS.iter().find_map(|way| attempt(way, budget));
    // A polygon shows less than the shape itself: what took few looks may take many of it.
    let more = Options::default().budget;
    let again = || if options.budget < more { within(more) } else { None };
    within(options.budget).or_else(|| stretched(maps, options)).or_else(again)
}

/// In coordinates in which a shape that is stretched along an axis is about as wide as high.
fn stretched(maps: &[Affine2], options: &Options) -> Option<Certificate> {
    let scales = AxisScales::of(maps)?;
    let seen = scales.maps(maps)?;
    let found = proved(&seen, &Contraction::find(&seen).ok()?, options)?;
    let polygon = found.polygon.iter().map(|&corner| scales.point(corner)).collect::<Option<_>>()?;
    let back = |pair: Separation| Some(Separation { normal: scales.normal(pair.normal)?, ..pair });
    let pairs = found.pairs.into_iter().map(back).collect::<Option<_>>()?;
    Some(Certificate { maps: maps.iter().copied().map(Affine2::to_row).collect(), polygon, pairs, ..found })
}

/// A way to try.
struct Attempt {
    /// How much larger than the attractor the polygon may be, relative to that.
    slack: f64,
    /// Whether in coordinates in which the attractor is about as wide as long.
    drawn: bool,
    /// The coarsest fan of directions to try, by its number.
    coarsest: usize,
    /// The part of the budget that may be spent.
    share: usize,
}

/// Few corners of few digits first. Where pieces come near each other, and all the more where the attractor is flat,
/// they are told apart much sooner in a polygon that lies close.
const ATTEMPTS: [Attempt; 5] = [
    Attempt { slack: 0.02, drawn: false, coarsest: 0, share: 16 },
    Attempt { slack: 0.02, drawn: true, coarsest: 0, share: 16 },
    Attempt { slack: 1e-3, drawn: true, coarsest: 1, share: 4 },
    Attempt { slack: 1e-3, drawn: false, coarsest: 1, share: 2 },
    Attempt { slack: 3e-5, drawn: false, coarsest: 2, share: 1 },
];

/// The frame, drawn along the shorter axis of the attractor.
fn drawn(frame: &Frame, support: &SupportTable) -> Option<Frame> {
    let points = support.points();
    let mean = points.iter().sum::<DVec2>() / points.len() as f64;
    let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
    for &point in points {
        let p = point - mean;
        (xx, xy, yy) = (xx + p.x * p.x, xy + p.x * p.y, yy + p.y * p.y);
    }
    let axis = DVec2::from_angle(0.5 * (2.0 * xy).atan2(xx - yy));
    let spread = |axis: DVec2| points.iter().map(|&p| (p - mean).dot(axis).abs()).fold(0.0, f64::max);
    // Rounding grows by the square: products of maps are computed there.
    let most = (MOST_ROUNDING / frame.rounding).sqrt();
    let aspect = (spread(axis) / spread(axis.perp())).min(most);
    (aspect > FLAT_ASPECT).then(|| frame.drawn(axis.perp(), aspect))
}

/// An attractor is flat if it is so many times longer than wide.
const FLAT_ASPECT: f64 = 4.0;
/// What rounding may come to when a flat one is drawn.
const MOST_ROUNDING: f64 = 1e-5;

/// Parts the maps at the widest gap: all others are closed, nearest first, until two components are left.
fn cut(search: &KruskalSearch, count: usize, parts: &Components) -> Vec<u8> {
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    let mut edges: Vec<(f64, usize, usize)> = pairs.map(|(i, j)| (search.edge(i, j).reach, i, j)).collect();
    edges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut components = parts.clone();
    for (_, i, j) in edges {
        if components.count() > 2 {
            components.join(i, j);
        }
    }
    components.labels().into_iter().map(|label| label.min(1) as u8).collect()
}
