//! Reasons for an attractor to be in one piece that can be shown.

use frond_core::Affine2;
use glam::DVec2;

use crate::evidence::collinear::{Overlap, overlaps_on_a_line};
use crate::evidence::neighbour_graph::NeighbourGraph;
use crate::evidence::shared_points::{Shared, corners};
use crate::exact::address::{Address, shown};
use crate::exact::area;
use crate::exact::quadratic::QuadraticSystem;
use crate::exact::recognise::{self, Recognised};
use crate::frame::Frame;
use crate::gap::difference_set::are_equal;
use crate::overlap_graph::OverlapGraph;
use crate::region::inner_differences::InnerDifferences;
use crate::region::trap::{TRIES, crossings_beside};
use crate::support::table::SupportTable;
use crate::verdict::ReasonKind;

/// What holds two pieces together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum LinkKind {
    /// A point that both have.
    Point,
    /// Two paths that must cross.
    Crossing,
    /// Two segments, which hold the pieces, on the line that the attractor lies on.
    Line,
    /// Too much area to lie side by side.
    Area,
    /// Copies of one shape and direction, moved by what surely is the difference of two of its points.
    Difference,
}

impl LinkKind {
    /// Its name in the programming interface.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Point => "point",
            Self::Crossing => "crossing",
            Self::Line => "line",
            Self::Area => "area",
            Self::Difference => "difference",
        }
    }
}

/// What holds two pieces together, and where.
#[derive(Clone, Debug, PartialEq)]
pub struct Link {
    /// What it is.
    pub kind: LinkKind,
    /// Two maps, from 0, the smaller index first.
    pub pair: (usize, usize),
    /// The addresses of the point in the first piece and in the second, or the words of the pieces, as people read
    /// them: letters from 1, "1(2)" for 1222.. Of more than nine maps letters are joined by dots: "12.3.(10)".
    pub words: [String; 2],
    /// The shared point, to rounding, the middle of the crossing, or where the pieces come near; in the plane.
    pub at: DVec2,
    /// Of a crossing: two far points of the first piece, then two of the second. On a line: the ends of both. Otherwise
    /// empty.
    pub corners: Vec<DVec2>,
}

/// Why an attractor is in one piece.
///
/// With nothing assumed it is a proof about the maps as they are given, computed without rounding. Otherwise it is one
/// about numbers that they come near.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason {
    /// Which kind of reason.
    pub kind: ReasonKind,
    /// What holds the pieces together: enough to reach every piece (Hata 1985). Empty where one fact covers all.
    pub links: Vec<Link>,
    /// Readings of numbers that it hangs on, such as "0.3333333333333333 is 1/3".
    pub assuming: Vec<String>,
    /// In how many ways pieces of like size lie to each other where they meet, if these are finitely many.
    pub neighbours: Option<usize>,
}

impl Reason {
    pub(crate) const fn of(kind: ReasonKind) -> Self {
        Self { kind, links: Vec::new(), assuming: Vec::new(), neighbours: None }
    }

    /// Whether it is a proof about the maps as they are given.
    #[must_use]
    pub fn is_proof(&self) -> bool {
        self.assuming.is_empty()
    }

    /// The reason in a sentence or two.
    #[must_use]
    pub fn text(&self) -> String {
        let example = self.links.first().map_or(String::new(), |link| {
            let [a, b] = &link.words;
            format!("{a} and {b}")
        });
        let count = |kind| self.links.iter().filter(|link| link.kind == kind).count();
        let text = match self.kind {
            ReasonKind::OneMap => "There is one map, and its attractor is one point.".to_owned(),
            ReasonKind::EqualMaps => "All maps are equal, so there is only one piece.".to_owned(),
            ReasonKind::CommonPoint => {
                "All maps keep the same point fixed, and the attractor is this point.".to_owned()
            }
            ReasonKind::Area if self.links.len() < 2 => {
                "Their area factors add up to 1 or more, so the pieces cannot avoid each other."
                    .to_owned()
            }
            ReasonKind::Area => "Enough pairs of pieces have area factors that add up to 1 or more: such a pair cannot avoid each other, \
                                 and these pairs join all the pieces."
                .to_owned(),
            ReasonKind::SharedPoints => match self.links.len() {
                1 => format!("The pieces meet in one point, whose addresses are {example}."),
                count => format!(
                    "The pieces meet in {count} points, which join all of them. One of these points has the addresses {example}."
                ),
            },
            ReasonKind::Crossings => {
                let text = match count(LinkKind::Crossing) {
                    1 => format!("The pieces {example} cross each other, so they must meet."),
                    count => format!(
                        "{count} pairs of pieces cross each other, so they must meet. One such pair is {example}."
                    ),
                };
                match self.links.len() - count(LinkKind::Crossing) {
                    0 => text,
                    1 => format!("{text} Another pair shares a point."),
                    others => format!("{text} {others} other pairs share points."),
                }
            }
            ReasonKind::Line => {
                let link = self.links.iter().find(|link| link.kind == LinkKind::Line);
                let [a, b] = link.map(|link| link.words.clone()).unwrap_or_default();
                let pieces = match count(LinkKind::Line) {
                    1 => format!("the pieces {a} and {b} overlap there"),
                    count => format!("{count} pairs of pieces overlap there, such as {a} and {b}"),
                };
                format!(
                    "The shape lies on a line, and {pieces}. Its widest hole would have to lie inside a piece, and all \
                     holes of a piece are narrower. So it has no hole."
                )
            }
            ReasonKind::Differences => {
                let text = "All pieces are equal copies of one shape. Two of them meet exactly when the shift from one to \
                            the other is the difference of two points of a copy. This is so for enough pairs to join \
                            all the pieces.";
                match self.links.len() - count(LinkKind::Difference) {
                    0 => text.to_owned(),
                    _ => format!("{text} Other pairs share a point."),
                }
            }
            ReasonKind::Neighbours => {
                let ways = self.neighbours.unwrap_or(0);
                format!(
                    "Two pieces that touch lie in one of {ways} positions to each other, and each of these positions \
                     leads to smaller pieces that touch again. One shared point has the addresses {example}."
                )
            }
        };
        match self.assuming.as_slice() {
            [] => text,
            [one] => format!("If {one}, this is a proof. {text}"),
            [one, ..] => format!("If {one} (and so on), this is a proof. {text}"),
        }
    }
}

/// Reasons that cost next to nothing.
pub(crate) fn at_once(maps: &[Affine2]) -> Option<Reason> {
    area::kind(maps).map(Reason::of)
}

/// For an attractor that is one point as far as floating point tells.
pub(crate) fn one_point(maps: &[Affine2]) -> Option<Reason> {
    let fixed = |i: usize| Address { head: vec![], repeat: vec![i as u8] };
    let all_fix = |system: &QuadraticSystem| (1..maps.len()).all(|i| system.coincide(&fixed(0), &fixed(i)));
    let reason = Reason::of(ReasonKind::CommonPoint);
    if QuadraticSystem::as_given(maps).is_some_and(|system| all_fix(&system)) {
        return Some(reason);
    }
    let reading = recognise::read(maps).filter(|reading| all_fix(&reading.system))?;
    Some(Reason { assuming: reading.assuming, ..reason })
}

/// A proof for an attractor that lies on an axis, beside points that are shared.
pub(crate) fn by_line(maps: &[Affine2], shared: &[Link]) -> Option<Reason> {
    let met: Vec<(usize, usize)> = shared.iter().map(|link| link.pair).collect();
    let overlaps =
        overlaps_on_a_line(&met, maps)?.into_iter().map(|Overlap { pair: [i, j], corners, .. }| {
            let words = [i, j].map(|letter| shown(&[letter as u8], maps.len()));
            let [a, b, c, d] = corners;
            // The middle of what both hold: ends are in their order.
            let at = a.max(c).midpoint(b.min(d));
            Link { kind: LinkKind::Line, pair: (i, j), words, at, corners: corners.to_vec() }
        });
    let mut links: Vec<Link> = overlaps.chain(shared.iter().cloned()).collect();
    links.sort_by_key(|link| link.pair);
    Some(Reason { links, ..Reason::of(ReasonKind::Line) })
}

/// A proof by pieces that lie across each other, beside points that are shared, where no gap is known to be wider
/// than `gap` (in the plane). `near` is where two pieces come near each other.
pub(crate) fn by_crossings(
    maps: &[Affine2],
    shared: Vec<Link>,
    gap: f64,
    near: impl Fn(usize, usize) -> DVec2,
) -> Option<Reason> {
    let met: Vec<(usize, usize)> = shared.iter().map(|link| link.pair).collect();
    let found = crossings_beside(&met, maps, gap, 0.0, TRIES)?;
    let crossings = found.into_iter().map(|crossing| {
        let corners = crossing.corners.to_vec();
        Link {
            kind: LinkKind::Crossing,
            pair: (crossing.i, crossing.j),
            words: [crossing.u, crossing.v].map(|word| shown(&word, maps.len())),
            at: corners.iter().sum::<DVec2>() / corners.len() as f64,
            corners,
        }
    });
    // Where pieces fill too much to leave room, none need cross.
    let fill = |i: usize, j: usize| area::areas_fill(&maps[i], &maps[j]);
    let links = join_besides(maps.len(), crossings.chain(shared).collect(), LinkKind::Area, fill, near)?;
    let crosses = links.iter().any(|link| link.kind == LinkKind::Crossing);
    let kind = if crosses { ReasonKind::Crossings } else { ReasonKind::Area };
    Some(Reason { links, ..Reason::of(kind) })
}

/// A proof for copies of one shape and direction, which never cross, beside points that are shared. `diameter` is
/// about that of the attractor.
pub(crate) fn by_differences(
    maps: &[Affine2],
    shared: &[Link],
    diameter: f64,
    near: impl Fn(usize, usize) -> DVec2,
) -> Option<Reason> {
    let mut differences = InnerDifferences::default();
    if !are_equal(maps) || !differences.begin(maps, DVec2::splat(diameter)) {
        return None;
    }
    let meet = |i: usize, j: usize| differences.join(maps, i, j);
    let links = join_besides(maps.len(), shared.to_vec(), LinkKind::Difference, meet, near)?;
    Some(Reason { links, ..Reason::of(ReasonKind::Differences) })
}

/// The links with those of one more kind, where two pieces are not joined yet and `meet`; if they reach every piece.
fn join_besides(
    count: usize,
    mut links: Vec<Link>,
    kind: LinkKind,
    mut meet: impl FnMut(usize, usize) -> bool,
    near: impl Fn(usize, usize) -> DVec2,
) -> Option<Vec<Link>> {
    let mut graph = OverlapGraph::new(count);
    for link in &links {
        graph.add(link.pair.0, link.pair.1);
    }
    for i in 0..count {
        for j in i + 1..count {
            if !graph.components().joined(i, j) && meet(i, j) {
                graph.add(i, j);
                let words = [i, j].map(|i| shown(&[i as u8], count));
                links.push(Link { kind, pair: (i, j), words, at: near(i, j), corners: Vec::new() });
            }
        }
    }
    graph.is_connected().then_some(links)
}

/// Points of two pieces that are checked at most.
const MOST_TRIES_PER_PAIR: usize = 4;

/// Points that pieces share, proposed by floating point and checked without rounding.
pub(crate) struct Points<'a> {
    maps: &'a [Affine2],
    pairs: &'a [(usize, usize)],
    found: Vec<Shared>,
    graph: Option<NeighbourGraph<'a>>,
}

impl<'a> Points<'a> {
    /// Looks for points that are shared, where `pairs` of maps may have some.
    pub fn find(
        maps: &'a [Affine2],
        frame: &'a Frame,
        support: &'a SupportTable,
        pairs: &'a [(usize, usize)],
    ) -> Self {
        let mut found = corners(&frame.maps);
        let graph = NeighbourGraph::new(frame, support).map(|mut graph| {
            graph.explore(pairs);
            found.extend(pairs.iter().filter_map(|&(i, j)| graph.common_point(i, j)));
            graph
        });
        Self { maps, pairs, found, graph }
    }

    /// A proof for the maps as they are given; or else the points that they do share.
    pub fn as_given(&self) -> Result<Reason, Vec<Link>> {
        let system = QuadraticSystem::as_given(self.maps).ok_or_else(Vec::new)?;
        self.reason(&system)
    }

    /// A proof for the numbers that they come near.
    pub fn as_meant(&self) -> Option<Reason> {
        if !self.is_enough() {
            return None;
        }
        let Recognised { system, assuming } = recognise::read(self.maps)?;
        Some(Reason { assuming, ..self.reason(&system).ok()? })
    }

    /// Whether all of them together, if they were shared, would reach every piece.
    fn is_enough(&self) -> bool {
        let mut graph = OverlapGraph::new(self.maps.len());
        for (a, b) in &self.found {
            graph.add(a.first(), b.first());
        }
        graph.is_connected()
    }

    /// Enough of those that are shared as the maps are given to join all that such points join.
    pub fn given(&self) -> Vec<Shared> {
        let all = |system: QuadraticSystem| self.shared(&[], |a, b| system.coincide(a, b));
        QuadraticSystem::as_given(self.maps).map_or(Vec::new(), all)
    }

    /// Enough of those that are one point, as is decided, to join all that such points join, besides some that are
    /// known.
    pub fn shared(&self, known: &[Shared], coincide: impl Fn(&Address, &Address) -> bool) -> Vec<Shared> {
        self.shared_beside(known, coincide).0
    }

    fn shared_beside(
        &self,
        known: &[Shared],
        coincide: impl Fn(&Address, &Address) -> bool,
    ) -> (Vec<Shared>, OverlapGraph) {
        let mut graph = OverlapGraph::new(self.maps.len());
        let mut shared = Vec::new();
        let mut tried = vec![0; self.maps.len() * self.maps.len()];
        for (a, b) in &self.found {
            let (i, j) = (a.first(), b.first());
            if i == j || graph.components().joined(i, j) {
                continue;
            }
            // Where some points do not fit, others that lie together in the same way hardly will.
            let tries = &mut tried[i * self.maps.len() + j];
            *tries += 1;
            if *tries > MOST_TRIES_PER_PAIR || !coincide(a, b) {
                continue;
            }
            graph.add(i, j);
            shared.push((a.clone(), b.clone()));
        }
        for (a, b) in known {
            if !graph.components().joined(a.first(), b.first()) {
                graph.add(a.first(), b.first());
                shared.push((a.clone(), b.clone()));
            }
        }
        (shared, graph)
    }

    fn reason(&self, system: &QuadraticSystem) -> Result<Reason, Vec<Link>> {
        let (shared, graph) = self.shared_beside(&[], |a, b| system.coincide(a, b));
        let link = |(a, b): &Shared| {
            let (i, j) = (a.first(), b.first());
            Link {
                kind: LinkKind::Point,
                pair: (i.min(j), i.max(j)),
                words: [a, b].map(|address| address.shown(self.maps.len())),
                at: a.point(self.maps).unwrap_or(DVec2::ZERO),
                corners: Vec::new(),
            }
        };
        let mut links: Vec<Link> = shared.iter().map(link).collect();
        links.sort_by_key(|link| link.pair);
        if !graph.is_connected() {
            return Err(links);
        }
        let closed = self.graph.as_ref().filter(|graph| {
            !self.pairs.is_empty() && graph.is_closed() && graph.types() > 0 && graph.is_exact(system)
        });
        let kind = match closed {
            Some(graph) if graph.share_many() => ReasonKind::Neighbours,
            _ => ReasonKind::SharedPoints,
        };
        Ok(Reason { links, neighbours: closed.map(NeighbourGraph::types), ..Reason::of(kind) })
    }
}
