//! The full answer for one system.

use frond_core::{Affine2, Contraction, Ifs};
use glam::DVec2;

use crate::evidence::reason::{self, Points, Reason};
use crate::frame::Frame;
use crate::gap::kruskal::{KruskalSearch, WidestEdge};
use crate::gap::word_tree::WordTree;
use crate::magnification::Magnification;
use crate::overlap_graph::Components;
use crate::support::table::SupportTable;
use crate::verdict::{Gap, Options, Verdict};

/// The answer of [`connectedness`], and with other points and reasons of [`connectedness3`](crate::connectedness3()).
#[derive(Clone, Debug, PartialEq)]
pub struct Connectedness<P = DVec2, R = Reason> {
    /// Whether the attractor is in one piece.
    pub verdict: Verdict,
    /// The widest edge of the minimum spanning tree between the pieces, in their units: zero if and only if the
    /// attractor is connected. Where it is disconnected, the bounds are within 1 in 100 of each other or within 1e-9
    /// of the diameter, unless the budget was spent or, of very flat shapes, the digits of the coefficients do not tell
    /// more. In the plane it does not depend on epsilon: pieces that come within it count as far apart as they are.
    pub gap: Gap,
    /// Pairs of maps whose attractorlets meet, or come within epsilon of each other, the smaller index
    /// first, in ascending order.
    pub overlaps: Vec<(usize, usize)>,
    /// For each map the number, from 0, of the component of the overlap graph that its attractorlet is in.
    pub components: Vec<usize>,
    /// How many components the overlap graph has. The attractor may have more: attractorlets may be in pieces
    /// themselves.
    pub count: usize,
    /// Two points of the attractor in different pieces whose distance is `gap.upper`, but for rounding: the ends of
    /// the widest edge between pieces. `None` where it is proved to be in one piece, or is a single point.
    pub closest: Option<(P, P)>,
    /// An upper bound of the diameter of the attractor: epsilon is relative to it.
    pub diameter: f64,
    /// How many pairs of pieces were looked at.
    pub nodes: usize,
    /// Why it is `Connected`; or, where it is `Touching` or `Undecided`, under which reading of its numbers it would
    /// be.
    pub reason: Option<R>,
}

impl<P, R> Connectedness<P, R> {
    /// What was found out about magnified maps, in the units of those that were given, which `point` and `reason` bring
    /// points and proofs to. A reason that takes numbers for others is dropped: it is about the given numbers, not the
    /// magnified ones.
    pub(crate) fn in_units_before(
        self,
        magnification: Magnification,
        point: impl Fn(P) -> P,
        reason: impl FnOnce(R) -> Option<R>,
    ) -> Self {
        Self {
            gap: magnification.gap(self.gap),
            closest: self.closest.map(|(p, q)| (point(p), point(q))),
            diameter: magnification.up(self.diameter),
            reason: self.reason.and_then(reason),
            ..self
        }
    }

    /// The answer as it is; or `Undecided` where its numbers contradict each other or are none, so that one of them is
    /// wrong, and nobody knows which. Every full answer, of the plane and of space, goes through here.
    pub(crate) fn or_undecided(self) -> Self {
        let apart = self.verdict == Verdict::Disconnected;
        if self.gap.is_possible(self.diameter) && apart == (self.gap.lower > 0.0) {
            return self;
        }
        let count = self.components.len();
        Self {
            verdict: Verdict::Undecided,
            gap: Gap { lower: 0.0, upper: f64::INFINITY },
            overlaps: Vec::new(),
            components: (0..count).collect(),
            count,
            closest: None,
            diameter: f64::INFINITY,
            nodes: self.nodes,
            reason: None,
        }
    }

    /// All pieces are the same point, as far as floating point tells.
    pub(crate) fn in_one_point(count: usize, reason: Option<R>, is_proof: impl FnOnce(&R) -> bool) -> Self {
        let proved = reason.as_ref().is_some_and(is_proof);
        Self {
            verdict: if proved { Verdict::Connected } else { Verdict::Touching },
            gap: Gap::default(),
            overlaps: (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))).collect(),
            components: vec![0; count],
            count: 1,
            closest: None,
            diameter: 0.0,
            nodes: 0,
            reason,
        }
    }
}

/// Decides whether the attractor of `ifs` is connected, which of its pieces meet, and how wide the widest
/// gap is.
///
/// `Connected` and `Disconnected` are proofs, `Touching` is what can be said at the resolution. For
/// [`Verdict::Disconnected`], rounding is reckoned with: also that of the coefficients themselves, so that
/// pieces that meet in one exact point are never called apart.
///
/// ```
/// use frond_core::{Affine2, Ifs};
/// use frond_locus::{Options, Verdict, connectedness};
///
/// // Cantor's dust: two thirds of the unit interval.
/// let third = 1.0 / 3.0;
/// let maps = [0.0, 2.0 * third].map(|e| Affine2::from_row([third, 0.0, 0.0, third, e, 0.0]));
/// let answer = connectedness(&Ifs::new(maps.to_vec())?, &Options::default());
/// assert_eq!(answer.verdict, Verdict::Disconnected);
/// assert!(answer.gap.lower <= third && third <= answer.gap.upper + 1e-12);
/// # Ok::<(), frond_core::IfsError>(())
/// ```
#[must_use]
pub fn connectedness(ifs: &Ifs, options: &Options) -> Connectedness {
    if let Some(magnification) = Magnification::of(ifs.maps()) {
        let maps = magnification.magnify(ifs.maps());
        // Size is no matter for it: those as given have one.
        if let Ok(contraction) = Contraction::find(&maps) {
            let point = |p| magnification.point(p);
            return decided(&maps, &contraction, options).in_units_before(
                magnification,
                point,
                |mut reason| {
                    for link in &mut reason.links {
                        link.at = point(link.at);
                        link.corners.iter_mut().for_each(|corner| *corner = point(*corner));
                    }
                    reason.is_proof().then_some(reason)
                },
            );
        }
    }
    decided(ifs.maps(), ifs.contraction(), options)
}

fn decided(maps: &[Affine2], contraction: &Contraction, options: &Options) -> Connectedness {
    let mut frame = Frame::default();
    frame.set_round(maps, contraction);
    let at_once = reason::at_once(maps);
    if frame.point {
        let reason = at_once.or_else(|| reason::one_point(maps));
        return Connectedness::in_one_point(maps.len(), reason, Reason::is_proof);
    }
    let mut support = SupportTable::default();
    support.set(&frame.maps, 1e-4 * (1.0 - frame.factor), 4000);
    let mut words = WordTree::default();
    let mut search = KruskalSearch::begin(&frame, &mut support, &mut words, options.epsilon.max(0.0));
    if at_once.is_some() && maps.len() == 2 {
        search.join(0, 1);
    }
    if search.settle(options.budget) {
        search.settle_all(options.budget);
    }
    // With a pair left open, some pieces may meet that were not found to: those in different parts do not.
    let (found, parts) = (search.met().clone(), search.coarsest());
    let apart = parts.count() > 1;
    let reason = at_once.or_else(|| {
        if apart {
            return None;
        }
        let mut pairs = search.may_meet();
        pairs.truncate(MOST_PAIRS_FOR_REASON);
        let points = Points::find(maps, &frame, search.support(), &pairs);
        let gap = search.widest_edge().upper * (1.0 + 1e-9);
        let near = &|i: usize, j: usize| {
            let [from, to] = search.edge(i, j).points;
            frame.to_plane(from.midpoint(to))
        };
        let shared = match points.as_given() {
            Ok(reason) => return Some(reason),
            Err(shared) => shared,
        };
        // Pieces that are meant to lie to each other in finitely many ways mostly touch: then nothing is seen to cross.
        match points.as_meant() {
            Some(meant) if meant.neighbours.is_some() => Some(meant),
            meant => reason::by_line(maps, &shared)
                .or_else(|| reason::by_differences(maps, &shared, search.plane_diameter, near))
                .or_else(|| reason::by_crossings(maps, shared, gap, near))
                .or(meant),
        }
    });
    let proved = reason.as_ref().is_some_and(Reason::is_proof);
    let (verdict, components) = if proved {
        (Verdict::Connected, one(maps.len()))
    } else if found.count() == 1 {
        (Verdict::Touching, found)
    } else if apart {
        (Verdict::Disconnected, parts)
    } else {
        (Verdict::Undecided, found)
    };
    let count = components.count();
    let mut overlaps = search.overlaps();
    if proved {
        // What was proved to meet need not have been found.
        overlaps.extend(reason.iter().flat_map(|reason| reason.links.iter().map(|link| link.pair)));
        overlaps.sort_unstable();
        overlaps.dedup();
    }
    let diameter = search.plane_diameter;
    let widest = match verdict {
        Verdict::Connected => WidestEdge::default(),
        Verdict::Touching => search.widest_edge(),
        Verdict::Disconnected => measure(&mut search, options.budget),
        Verdict::Undecided => search.widest_edge(),
    };
    let closest = widest.ends.map(|[from, to]| (frame.to_plane(from), frame.to_plane(to)));
    let found = Connectedness {
        verdict,
        gap: Gap { lower: widest.lower, upper: widest.upper },
        overlaps,
        components: components.labels(),
        count,
        closest,
        diameter,
        nodes: search.nodes(),
        reason,
    };
    found.or_undecided()
}

/// The widest gap of an attractor that is in several pieces, from the search that told them apart.
fn measure(search: &mut KruskalSearch, budget: usize) -> WidestEdge {
    let absolute = 1e-9 * search.plane_diameter;
    let mut best = WidestEdge { upper: f64::INFINITY, ..WidestEdge::default() };
    loop {
        let near = search.resolution;
        let found = search.measure(0.01, absolute, search.nodes().saturating_add(budget));
        best.lower = best.lower.max(found.lower);
        if found.upper < best.upper {
            best = WidestEdge { lower: best.lower, ..found };
        }
        // Where it is pieces that were joined for being near that are farthest apart, they are to be told apart as
        // well: but for those that are nearer than the gap is wide.
        let finer = 0.5 * best.lower;
        let loose = best.upper - best.lower > (0.011 * best.upper).max(absolute);
        if !loose || best.upper > 2.0 * near || finer >= near {
            return best;
        }
        let spent = search.nodes();
        search.begin_again(finer / search.plane_diameter);
        let begun = search.resolution < near;
        let settled = begun && search.settle(budget);
        search.add_nodes(spent);
        if !settled {
            return best;
        }
    }
}

/// Pairs of maps whose neighbours are looked at: enough for 64 maps that each touch a few.
const MOST_PAIRS_FOR_REASON: usize = 400;

/// All pieces in one component.
fn one(count: usize) -> Components {
    let mut components = Components::new(count);
    for i in 1..count {
        components.join(0, i);
    }
    components
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_answer_whose_numbers_contradict_each_other_is_none() {
        let dust = [0.0, 0.7].map(|e| Affine2::similitude(0.3, 0.0, DVec2::new(e, 0.0)));
        let contraction = Contraction::find(&dust).unwrap();
        let apart = decided(&dust, &contraction, &Options::default());
        assert_eq!(apart.verdict, Verdict::Disconnected);
        let Gap { lower, upper } = apart.gap;
        for gap in [
            Gap { lower: upper, upper: lower },
            Gap { lower: 0.7, upper: 9e-14 },
            Gap { lower: 0.0, upper },
            Gap { lower: f64::NAN, upper },
            Gap { lower, upper: f64::NAN },
            Gap { lower, upper: 2.0 * apart.diameter },
            Gap { lower: f64::INFINITY, upper: f64::INFINITY },
        ] {
            let answer = Connectedness { gap, ..apart.clone() }.or_undecided();
            assert_eq!((answer.verdict, answer.gap.lower), (Verdict::Undecided, 0.0), "{gap:?}");
            assert_eq!((answer.count, answer.overlaps.len(), answer.closest), (2, 0, None));
        }
        for diameter in [f64::NAN, f64::INFINITY, 0.0] {
            let answer = Connectedness { diameter, ..apart.clone() }.or_undecided();
            assert_eq!(answer.verdict, Verdict::Undecided, "{diameter}");
        }
        let whole = Connectedness { verdict: Verdict::Touching, count: 1, ..apart.clone() };
        assert_eq!(whole.or_undecided().verdict, Verdict::Undecided, "a gap is proved");
        assert_eq!(apart.clone().or_undecided(), apart);
    }
}
