//! Proofs of connectedness that can be handed on.

use frond_core::{Affine2, Contraction, Ifs};
use frond_exact::ExactRows;
use glam::DVec2;

use crate::evidence::axis_scales::AxisScales;
use crate::evidence::collinear::overlaps_on_a_line;
use crate::evidence::far_parts::{Far, FarParts};
use crate::evidence::reason::Points;
use crate::exact::address::Address;
use crate::exact::area;
use crate::exact::quadratic::QuadraticSystem;
use crate::frame::Frame;
use crate::gap::difference_set::are_equal;
use crate::gap::kruskal::KruskalSearch;
use crate::gap::word_tree::WordTree;
use crate::magnification::Magnification;
use crate::overlap_graph::{Components, OverlapGraph};
use crate::region::inner_differences::InnerDifferences;
use crate::region::trap::{Crossing, crossings_beside};
use crate::support::extremes::larger;
use crate::support::table::SupportTable;
use crate::support::trapping_polygon::TrappingPolygon;
use crate::verdict::Options;

/// A proof that an attractor is in one piece, which can be checked without searching.
///
/// # What it proves
///
/// *There is an attractor, and it lies in the polygon P*, which each map takes strictly into its own inside: as in a
/// [`Certificate`](crate::Certificate). All maps contract in the norm with the unit ball `P - P`.
///
/// *No gap is wider than `gap`* in that norm, since pieces as near as that reach all maps.
///
/// *Pieces hang together*: by points that both have, by areas too large to lie side by side, or because they
/// lie across each other, where gaps as wide as that would not let one through (see [`crossings`](crate::crossings));
/// and these reach all maps.
///
/// The crate `frond-check`, which shares no code with this one, replays it in exact arithmetic, and says the proof
/// in full.
#[derive(Clone, Debug, PartialEq)]
pub struct ConnectedCertificate {
    /// The maps as rows, digit for digit those that it is about.
    pub maps: Vec<[f64; 6]>,
    /// The corners of a strictly convex polygon, counter-clockwise.
    pub polygon: Vec<DVec2>,
    /// No gap is wider, where the polygon itself is 1 wide in all directions.
    pub gap: f64,
    /// Words of pieces that are so near. Empty where the gap does not matter.
    pub near: Vec<[Vec<u8>; 2]>,
    /// What holds pieces together.
    pub links: Vec<CertifiedLink>,
    /// Where maps have one linear part: squares that hold nothing but differences of two points of the attractor.
    pub squares: Option<Squares>,
}

/// Squares that hold nothing but differences of two points of the attractor.
#[derive(Clone, Debug, PartialEq)]
pub struct Squares {
    /// How wide and how high one is.
    pub size: DVec2,
    /// Of each how many widths and heights it is from the origin to its lower left corner, and two maps k and l: the
    /// inverse L^-1 of the linear part takes it, less `t_k - t_l`, into squares.
    pub cells: Vec<([i32; 2], [u8; 2])>,
}

/// What holds the pieces of two maps together.
#[derive(Clone, Debug, PartialEq)]
pub enum CertifiedLink {
    /// A point that both have: its address in the one and in the other, what comes once and what repeats.
    Point([[Vec<u8>; 2]; 2]),
    /// The areas of the pieces of two maps.
    Area([u8; 2]),
    /// Two points of one piece and one of another that lies between them, where the attractor lies on a line: their
    /// addresses, what comes once and what repeats.
    Between([[Vec<u8>; 2]; 3]),
    /// Two maps i and j, copies of one shape moved by the difference of two of its points: steps `x -> L^-1 (x - (t_k -
    /// t_l))` lead from `L^-1 (t_j - t_i)` into the squares.
    Difference([u8; 2], Vec<[u8; 2]>),
    /// Two pieces that lie across each other: their words, and two parts of the first that jut out beyond the second,
    /// then two of the second.
    Crossing([Vec<u8>; 2], [Far; 4]),
}

/// A certificate that the attractor is connected, or `None` if none was found: of maps whose pieces share points as
/// the numbers are given, overlap in area or on an axis, lie across each other, or are copies of one shape and
/// direction that are moved by differences of its points; and of those whose attractor is one point. Proofs about what
/// numbers are meant to be are not written down as certificates.
///
/// ```
/// use frond_core::{Affine2, Ifs};
/// use frond_locus::{Options, connected_certificate};
///
/// let maps = [0.0, 0.5].map(|e| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, 0.0]));
/// let found = connected_certificate(&Ifs::new(maps.to_vec())?, &Options::default()).unwrap();
/// assert_eq!(found.links.len(), 1);
/// # Ok::<(), frond_core::IfsError>(())
/// ```
#[must_use]
pub fn connected_certificate(ifs: &Ifs, options: &Options) -> Option<ConnectedCertificate> {
    certified(ifs, options, None)
}

/// Exact numbers that the numbers of maps stand for.
#[derive(Clone, Copy)]
pub(crate) struct Meant<'a> {
    pub exact: &'a ExactRows,
    /// Points that two pieces are known to have.
    pub shared: &'a [(Address, Address)],
}

/// As [`connected_certificate`], about numbers that those of the maps stand for. What hangs on them is decided exactly;
/// crossings, which leave room, are found for the doubles.
pub(crate) fn certified_as_meant(
    ifs: &Ifs,
    options: &Options,
    meant: &Meant<'_>,
) -> Option<ConnectedCertificate> {
    certified(ifs, options, Some(meant))
}

fn certified(ifs: &Ifs, options: &Options, meant: Option<&Meant<'_>>) -> Option<ConnectedCertificate> {
    // Where gaps as wide as epsilon let pieces through, narrower ones may not.
    let closer = Options { epsilon: CLOSER * options.epsilon, ..*options };
    [*options, closer].iter().find_map(|options| magnified(ifs, options, meant))
}

fn magnified(ifs: &Ifs, options: &Options, meant: Option<&Meant<'_>>) -> Option<ConnectedCertificate> {
    let maps = ifs.maps();
    let Some(magnification) = Magnification::of(maps) else {
        return proved(maps, ifs.contraction(), options, meant);
    };
    let seen = magnification.magnify(maps);
    let found = proved(&seen, &Contraction::find(&seen).ok()?, options, meant)?;
    let polygon =
        found.polygon.iter().map(|&corner| magnification.exact_point(corner)).collect::<Option<_>>()?;
    Some(ConnectedCertificate { maps: rows(maps), polygon, ..found })
}

fn rows(maps: &[Affine2]) -> Vec<[f64; 6]> {
    maps.iter().copied().map(Affine2::to_row).collect()
}

impl Meant<'_> {
    /// Whether two addresses are of one point.
    fn coincide(&self, a: &Address, b: &Address) -> bool {
        self.exact.coincide([[&a.head, &a.repeat], [&b.head, &b.repeat]])
    }
}

/// So many times closer it is looked again.
const CLOSER: f64 = 1e-3;
/// Pairs of words tried for each two maps.
const TRIES: usize = 3000;
/// Pairs of maps that are looked at for points.
const MOST_PAIRS: usize = 400;

/// In coordinates in which a shape that is stretched along an axis is about as wide as high.
fn stretched(maps: &[Affine2], options: &Options, meant: Option<&Meant<'_>>) -> Option<ConnectedCertificate> {
    let scales = AxisScales::of(maps)?;
    let seen = scales.maps(maps)?;
    let mut found = proved(&seen, &Contraction::find(&seen).ok()?, options, meant)?;
    for link in &mut found.links {
        if let CertifiedLink::Crossing(_, far) = link {
            for far in far {
                far.direction = scales.normal(far.direction)?;
            }
        }
    }
    if let Some(squares) = &mut found.squares {
        squares.size = scales.point(squares.size)?;
    }
    let polygon = found.polygon.iter().map(|&corner| scales.point(corner)).collect::<Option<_>>()?;
    Some(ConnectedCertificate { maps: rows(maps), polygon, ..found })
}

fn proved(
    maps: &[Affine2],
    contraction: &Contraction,
    options: &Options,
    meant: Option<&Meant<'_>>,
) -> Option<ConnectedCertificate> {
    proved_as_is(maps, contraction, options, meant).or_else(|| stretched(maps, options, meant))
}

fn proved_as_is(
    maps: &[Affine2],
    contraction: &Contraction,
    options: &Options,
    meant: Option<&Meant<'_>>,
) -> Option<ConnectedCertificate> {
    let mut frame = Frame::default();
    frame.set_round(maps, contraction);
    if frame.point {
        return one_point(maps, contraction, meant);
    }
    let mut support = SupportTable::default();
    support.set(&frame.maps, 1e-4 * (1.0 - frame.factor), 4000);
    let diameter = support.diameter(frame.to_round * frame.from_round);
    let mut words = WordTree::default();
    let mut search = KruskalSearch::begin(&frame, &mut support, &mut words, options.epsilon.max(0.0));
    if search.settle(options.budget) {
        search.settle_all(options.budget);
    }
    if search.coarsest().count() > 1 {
        return None;
    }
    let mut pairs = search.may_meet();
    pairs.truncate(MOST_PAIRS);
    let gap = search.widest_edge().upper * (1.0 + 1e-9);
    let near: Vec<Near> = tree(&search, maps.len());
    let mut joined = OverlapGraph::new(maps.len());
    let mut links = Vec::new();
    let points = Points::find(maps, &frame, search.support(), &pairs);
    let shared = match meant {
        Some(meant) => points.shared(meant.shared, |a, b| meant.coincide(a, b)),
        None => points.given(),
    };
    for (a, b) in shared {
        joined.add(a.first(), b.first());
        links.push(CertifiedLink::Point([a, b].map(|Address { head, repeat }| [head, repeat])));
    }
    for i in 0..maps.len() {
        for j in i + 1..maps.len() {
            let fill = || match meant {
                Some(meant) => meant.exact.areas_fill(i, j),
                None => area::areas_fill(&maps[i], &maps[j]),
            };
            if !joined.components().joined(i, j) && fill() {
                joined.add(i, j);
                links.push(CertifiedLink::Area([i as u8, j as u8]));
            }
        }
    }
    for overlap in if joined.is_connected() { None } else { overlaps_on_a_line(&joined.edges(), maps) }
        .into_iter()
        .flatten()
    {
        let [i, j] = overlap.pair;
        joined.add(i, j);
        links.push(CertifiedLink::Between(overlap.addresses.map(|Address { head, repeat }| [head, repeat])));
    }
    let squares = if joined.is_connected() || !are_equal(maps) {
        None
    } else {
        Some(differences(maps, search.plane_diameter, &mut joined, &mut links)?)
    };
    let crossings = if joined.is_connected() {
        Vec::new()
    } else {
        let met = joined.edges();
        crossings_beside(&met, maps, gap, 0.0, TRIES)?
    };
    ATTEMPTS.iter().find_map(|attempt| {
        let polygon = TrappingPolygon::find(&frame, diameter, attempt.slack, attempt.coarsest)?;
        if polygon.letters > 1 {
            return None;
        }
        let mut found = ConnectedCertificate {
            maps: rows(maps),
            polygon: polygon.plane.clone(),
            gap: 1.0,
            near: Vec::new(),
            links: links.clone(),
            squares: squares.clone(),
        };
        let parts = FarParts::new(&frame, &polygon);
        (crossings.is_empty() || found.add_crossings(&parts, &near, &crossings, attempt.size))
            .then_some(found)
    })
}

/// Of maps that all leave one point where it is, which is then the attractor: one map, equal maps, and others.
fn one_point(
    maps: &[Affine2],
    contraction: &Contraction,
    meant: Option<&Meant<'_>>,
) -> Option<ConnectedCertificate> {
    let fixed = |i: usize| Address { head: vec![], repeat: vec![i as u8] };
    let all_fix = |coincide: &dyn Fn(&Address, &Address) -> bool| {
        (1..maps.len()).all(|i| coincide(&fixed(0), &fixed(i)))
    };
    if !match meant {
        Some(meant) => all_fix(&|a, b| meant.coincide(a, b)),
        None => QuadraticSystem::as_given(maps).is_some_and(|system| all_fix(&|a, b| system.coincide(a, b))),
    } {
        return None;
    }
    let link = |i: usize| CertifiedLink::Point([0, i].map(|k| [vec![], vec![k as u8]]));
    let mut frame = Frame::default();
    frame.set_about_point(maps, contraction);
    let attempt = |attempt: &Attempt| TrappingPolygon::find(&frame, 1.0, attempt.slack, attempt.coarsest);
    let polygon = ATTEMPTS.iter().find_map(attempt).filter(|polygon| polygon.letters == 1)?;
    Some(ConnectedCertificate {
        maps: rows(maps),
        polygon: polygon.plane,
        gap: 1.0,
        near: Vec::new(),
        links: (1..maps.len()).map(link).collect(),
        squares: None,
    })
}

/// Joins pieces that are moved by differences of points of one of them.
fn differences(
    maps: &[Affine2],
    diameter: f64,
    joined: &mut OverlapGraph,
    links: &mut Vec<CertifiedLink>,
) -> Option<Squares> {
    let mut all = InnerDifferences::default();
    if !all.begin(maps, DVec2::splat(diameter)) {
        return None;
    }
    for i in 0..maps.len() {
        for j in i + 1..maps.len() {
            if joined.components().joined(i, j) {
                continue;
            }
            if let Some(steps) = all.steps(maps, i, j) {
                joined.add(i, j);
                links.push(CertifiedLink::Difference([i as u8, j as u8], steps));
            }
        }
    }
    let (size, cells) = all.squares();
    joined.is_connected().then_some(Squares { size, cells })
}

/// Two maps, and a point of each one's piece.
type Near = ([u8; 2], [DVec2; 2]);

/// The minimum spanning tree of what is known of the distances of pieces.
fn tree(search: &KruskalSearch, count: usize) -> Vec<Near> {
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    let mut edges: Vec<_> = pairs.map(|(i, j)| (search.edge(i, j), [i as u8, j as u8])).collect();
    edges.sort_by(|a, b| a.0.reach.total_cmp(&b.0.reach));
    let mut components = Components::new(count);
    edges.retain(|(_, [i, j])| components.join(usize::from(*i), usize::from(*j)));
    edges.into_iter().map(|(edge, pair)| (pair, edge.points)).collect()
}

impl ConnectedCertificate {
    /// Whether all of them show in images of the polygon.
    fn add_crossings(&mut self, parts: &FarParts, near: &[Near], crossings: &[Crossing], size: f64) -> bool {
        let mut gap = 0.0;
        for (pair, points) in near {
            let Some((words, upper)) = parts.near(*pair, *points, size) else { return false };
            self.near.push(words);
            gap = larger(gap, upper);
        }
        self.gap = gap * (1.0 + 1e-9);
        crossings.iter().all(|crossing| {
            let far = parts.across([&crossing.u, &crossing.v], self.gap, size);
            let words = [crossing.u.clone(), crossing.v.clone()];
            far.map(|far| self.links.push(CertifiedLink::Crossing(words, far))).is_some()
        })
    }
}

/// A way to try.
struct Attempt {
    /// How much larger than the attractor the polygon may be, relative to that.
    slack: f64,
    /// The coarsest fan of directions to try, by its number.
    coarsest: usize,
    /// How wide parts about near points may be, in widths of the polygon, and those about far points, in widths of
    /// their pieces.
    size: f64,
}

/// Few corners of few digits, and short words, first.
const ATTEMPTS: [Attempt; 4] = [
    Attempt { slack: 0.02, coarsest: 0, size: 5e-3 },
    Attempt { slack: 2e-3, coarsest: 1, size: 5e-4 },
    Attempt { slack: 1e-4, coarsest: 2, size: 5e-5 },
    Attempt { slack: 1e-5, coarsest: 2, size: 2e-6 },
];
