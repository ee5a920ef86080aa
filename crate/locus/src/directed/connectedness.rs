//! Which states of a graph-directed system are in one piece.

use frond_core::{Affine2, DirectedIfs, Ifs};
use glam::DVec2;

use crate::connectedness::connectedness;
use crate::directed::extent::Extent;
use crate::directed::nearest::{Edge, Nearest, Piece};
use crate::directed::shared_points::{Arrows, Shared, closed};
use crate::magnification::Magnification;
use crate::overlap_graph::OverlapGraph;
use crate::verdict::{Gap, Options, Verdict};

/// A point that two pieces of a state share.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectedLink {
    /// Two maps of the state, from 0, the smaller index first.
    pub pair: (usize, usize),
    /// The ways to the point through the first piece and through the second: the maps along them, each by its place
    /// in its state from 1, "1(2)" for 1222.. as of one system.
    pub words: [String; 2],
    /// The point, to rounding.
    pub at: DVec2,
}

/// What is known of one state.
#[derive(Clone, Debug, PartialEq)]
pub struct StateConnectedness {
    /// Whether the state is in one piece.
    pub verdict: Verdict,
    /// The widest edge of the minimum spanning tree between its pieces, in units of the plane. Where it is above 0
    /// the state is in several pieces; where it is 0 the pieces hold together, but may be in several pieces
    /// themselves. Where that is so these are split until a gap of epsilon shows, and it is the widest between such
    /// parts: at least one as wide is there, and finer parts may leave a wider one, so it may vary with epsilon.
    pub gap: Gap,
    /// Pairs of its maps whose pieces meet, or come within epsilon of each other, the smaller index first, ascending.
    pub overlaps: Vec<(usize, usize)>,
    /// The ends of the edge that has `gap.upper`, where that is above 0.
    pub closest: Option<(DVec2, DVec2)>,
    /// Points that pieces share, checked without rounding: enough to join all that were found to be joined. Where
    /// `assuming` is not empty, they are so for the numbers it names.
    pub links: Vec<DirectedLink>,
    /// Readings of numbers under which the state is proved to be in one piece, such as "0.3333333333333333 is 1/3".
    /// Empty where nothing has to be assumed, or nothing is proved.
    pub assuming: Vec<String>,
    /// States in several pieces, or not known to be in one, that keep it open whether this one is in one piece: its
    /// own pieces hold together, but it is made of these.
    pub open_by: Vec<usize>,
    /// An upper bound of its diameter: epsilon is relative to it.
    pub diameter: f64,
    /// How many pairs of pieces were looked at.
    pub nodes: usize,
}

impl StateConnectedness {
    /// What was found out about magnified maps, in the units of those that were given. What takes numbers for others is
    /// dropped: it is about the magnified ones.
    fn in_units_before(self, magnification: Magnification) -> Self {
        let point = |p: DVec2| magnification.point(p);
        let mut links = if self.assuming.is_empty() { self.links } else { Vec::new() };
        links.iter_mut().for_each(|link| link.at = point(link.at));
        Self {
            gap: magnification.gap(self.gap),
            closest: self.closest.map(|(p, q)| (point(p), point(q))),
            links,
            assuming: Vec::new(),
            diameter: magnification.up(self.diameter),
            ..self
        }
    }
}

/// Decides for each state of a graph-directed system whether it is in one piece.
///
/// What is known, and what each verdict says (Hata 1985 for one system):
///
/// 1. A state is the union of finitely many compact pieces. If these fall into two sets that do not meet, the state is
///    `Disconnected`. This is said where the distance is above 0 with all rounding reckoned with, of the pieces or of
///    the parts that they are split into.
/// 2. Let S be a set of states that copy states of S alone, and let the pieces of each state of S be joined by pairs
///    that meet. Then every state of S is connected. For let g be the largest number such that some state of S falls
///    into two sets at the distance g, in coordinates of each state in which all maps shrink by a factor f below one.
///    The pieces of that state are copies of states of S, so that none of them falls into two sets farther apart than
///    f g; and as they are joined in points that they share, neither does their union: g <= f g, and g = 0. A compact
///    set that does not fall into two sets at a distance is connected. The largest such S is found by leaving out what
///    does not fit until all does.
/// 3. `Connected` is said by 2 where pieces share points that are one in exact arithmetic (ends of ways that repeat).
///    `Touching` is the same with pieces that come within epsilon of each other, relative to the diameter of each
///    state.
/// 4. `Undecided` is what is left: the budget was spent, or the pieces hold together while some of them are copies of
///    a state that does not (or is not known to). Such a state may be connected all the same. Pieces of that kind are
///    split a few times over, those first whose parts may be farthest apart, which settles some.
///
/// A system of one state is decided as its [`Ifs`] is, by [`connectedness`].
#[must_use]
pub fn directed_connectedness(system: &DirectedIfs, options: &Options) -> Vec<StateConnectedness> {
    if let Some(magnification) = Magnification::of_states(system.states())
        && let Ok(large) = DirectedIfs::found(magnification.magnify_states(system.states()))
    {
        let states = directed_connectedness(&large, options).into_iter();
        return states.map(|state| state.in_units_before(magnification)).collect();
    }
    if let [maps] = system.states()
        && let Ok(ifs) = Ifs::new(maps.iter().map(|part| part.map).collect())
    {
        return vec![of_one(&ifs, options)];
    }
    let extents = Extent::of(system);
    let diameters: Vec<f64> = extents.iter().map(|extent| extent.diameter).collect();
    let epsilon = options.epsilon.max(0.0);
    let looks: Vec<Look> = (0..system.len())
        .map(|state| Look::at(system, &extents, state, epsilon, options.budget, true))
        .collect();
    let shared = Shared::of(system, &diameters);
    let (given, meant) = match &shared {
        Some((given, meant)) => (Some(given), meant.as_ref()),
        None => (None, None),
    };
    let none = vec![false; system.len()];
    let proved = given.map_or(none.clone(), |shared| closed(system, &shared.joined));
    let assumed = meant.map_or(none, |shared| closed(system, &shared.joined));
    // What is proved to meet, or would be, need not have been found to come near.
    let near: Vec<bool> =
        (0..system.len()).map(|state| looks[state].holds || proved[state] || assumed[state]).collect();
    let held = closed(system, &near);
    let arrows = Arrows::of(system);
    (0..system.len())
        .map(|state| {
            let look = &looks[state];
            let (mut verdict, mut widest) = (Verdict::Undecided, look.widest);
            let mut open_by = Vec::new();
            let mut nodes = look.nodes;
            if proved[state] {
                verdict = Verdict::Connected;
                widest = Edge { lower: 0.0, upper: 0.0, ends: None };
            } else if look.widest.lower > 0.0 {
                verdict = Verdict::Disconnected;
            } else if held[state] {
                verdict = Verdict::Touching;
            } else if near[state] {
                open_by = system.states()[state].iter().map(|part| part.from).filter(|&k| !held[k]).collect();
                open_by.sort_unstable();
                open_by.dedup();
                let gaps: Vec<f64> = looks.iter().map(|look| look.widest.lower).collect();
                let (deeper, spent) = deeper(system, &extents, state, &held, &gaps, epsilon, options.budget);
                nodes += spent;
                if let Some((found, split)) = deeper {
                    (verdict, open_by) = (found, Vec::new());
                    widest = split;
                }
            }
            let reason = if proved[state] || !assumed[state] { given } else { meant };
            let links = reason.zip(arrows.as_ref()).map_or(Vec::new(), |(shared, arrows)| {
                let link = |meeting: &crate::directed::shared_points::Meeting| DirectedLink {
                    pair: meeting.pair,
                    words: [0, 1].map(|k| arrows.shown(&meeting.ways[k])),
                    at: meeting.at,
                };
                shared.meetings[state].iter().map(link).collect()
            });
            let mut overlaps = look.overlaps.clone();
            if verdict == Verdict::Connected {
                overlaps.extend(links.iter().map(|link: &DirectedLink| link.pair));
            }
            overlaps.sort_unstable();
            overlaps.dedup();
            let assuming = match meant {
                Some(meant) if !proved[state] && assumed[state] => meant.assuming.clone(),
                _ => Vec::new(),
            };
            StateConnectedness {
                verdict,
                gap: Gap { lower: widest.lower, upper: widest.upper },
                overlaps,
                closest: widest.ends.filter(|_| widest.upper > 0.0).map(|[p, q]| (p, q)),
                links,
                assuming,
                open_by,
                diameter: diameters[state],
                nodes,
            }
        })
        .collect()
}

/// How near the bounds of a gap come.
const BRACKET_WIDTH: f64 = 0.01;

/// What is seen of the pieces of a state.
pub(super) struct Look {
    pub widest: Edge,
    /// Whether they come within the resolution of each other.
    pub holds: bool,
    overlaps: Vec<(usize, usize)>,
    nodes: usize,
}

impl Look {
    /// All `overlaps` are looked for, or only as many as are needed to know whether the pieces hold together.
    pub fn at(
        system: &DirectedIfs,
        extents: &[Extent],
        state: usize,
        epsilon: f64,
        budget: usize,
        all_overlaps: bool,
    ) -> Self {
        let maps = system.states()[state].iter();
        let pieces: Vec<Piece> = maps.map(|part| Piece { map: part.map, from: part.from }).collect();
        let resolution = resolution(&extents[state], epsilon);
        let mut nearest = Nearest::begin(system, extents, state, &pieces);
        let widest = nearest.bracket(resolution, BRACKET_WIDTH, budget);
        let limit = nearest.nodes().saturating_add(budget);
        let (mut overlaps, mut holds) = (Vec::new(), widest.upper <= resolution);
        if all_overlaps || !(holds || widest.lower > 0.0) {
            for i in 0..pieces.len() {
                let near = |&j: &usize| nearest.settle(i, j, resolution, limit);
                overlaps.extend((i + 1..pieces.len()).filter(near).map(|j| (i, j)));
            }
            let mut graph = OverlapGraph::new(pieces.len());
            overlaps.iter().for_each(|&(i, j)| graph.add(i, j));
            holds |= graph.is_connected();
        }
        Self { widest, holds, overlaps, nodes: nearest.nodes() }
    }
}

/// Points within this distance are not told apart: epsilon of the diameter, or as near as rounding lets one see,
/// unless rounding has become coarse itself.
fn resolution(extent: &Extent, epsilon: f64) -> f64 {
    (epsilon * extent.diameter).max((4.0 * extent.off).min(1e-9 * extent.diameter))
}

/// Pieces that a state is split into at most, and how often.
const MOST_PIECES: usize = 128;
const MOST_SPLITS: usize = 5;
/// A gap is looked for down to this part of the widest that the pieces that were split may leave.
const LEAST_OF_PROMISED: f64 = 0.25;

/// What splitting the pieces that are copies of states not known to hold says, where it says something; and the pairs
/// looked at. `gaps` are lower bounds of the gaps of states, in the plane.
pub(super) fn deeper(
    system: &DirectedIfs,
    extents: &[Extent],
    state: usize,
    held: &[bool],
    gaps: &[f64],
    epsilon: f64,
    budget: usize,
) -> (Option<(Verdict, Edge)>, usize) {
    let mut pieces = vec![Piece { map: Affine2::IDENTITY, from: state }];
    let mut nodes = 0;
    for _ in 0..MOST_SPLITS {
        let widest_split = split(system, &mut pieces, held, gaps);
        if widest_split.is_none() || nodes >= budget {
            break;
        }
        let mut nearest = Nearest::begin(system, extents, state, &pieces);
        let resolution = resolution(&extents[state], epsilon);
        // What is in pieces itself leaves a gap that may be finer than epsilon of the whole.
        let promised =
            widest_split.filter(|gap| *gap > 0.0).map_or(resolution, |gap| LEAST_OF_PROMISED * gap);
        let finest = resolution.min(promised);
        let widest = nearest.bracket(finest, BRACKET_WIDTH, budget.saturating_sub(nodes));
        nodes += nearest.nodes();
        if widest.lower > 0.0 {
            return (Some((Verdict::Disconnected, widest)), nodes);
        }
        if widest.upper <= resolution && pieces.iter().all(|piece| held[piece.from]) {
            return (Some((Verdict::Touching, widest)), nodes);
        }
    }
    (None, nodes)
}

/// Splits pieces that are copies of states not known to hold, as long as there are not too many: first those whose
/// parts may be farthest apart. Returns the widest gap that may be left in one of them; `None` where none was split.
fn split(system: &DirectedIfs, pieces: &mut Vec<Piece>, held: &[bool], gaps: &[f64]) -> Option<f64> {
    let promise = |piece: &Piece| piece.map.norm() * gaps[piece.from];
    let (mut whole, mut open): (Vec<Piece>, Vec<Piece>) = pieces.iter().partition(|piece| held[piece.from]);
    open.sort_by(|a, b| promise(b).total_cmp(&promise(a)));
    let mut count = pieces.len();
    let mut widest = None;
    for piece in open {
        let parts = &system.states()[piece.from];
        if count + parts.len() - 1 > MOST_PIECES {
            whole.push(piece);
            continue;
        }
        count += parts.len() - 1;
        widest = Some(promise(&piece).max(widest.unwrap_or(0.0)));
        whole.extend(parts.iter().map(|part| Piece { map: piece.map * part.map, from: part.from }));
    }
    *pieces = whole;
    widest
}

/// A system of one state, by what is known of plain ones.
fn of_one(ifs: &Ifs, options: &Options) -> StateConnectedness {
    let found = connectedness(ifs, options);
    let links = found.reason.iter().flat_map(|reason| &reason.links);
    let points = links.filter(|link| link.kind == crate::evidence::reason::LinkKind::Point);
    let link = |link: &crate::evidence::reason::Link| DirectedLink {
        pair: link.pair,
        words: link.words.clone(),
        at: link.at,
    };
    StateConnectedness {
        verdict: found.verdict,
        gap: found.gap,
        overlaps: found.overlaps,
        closest: found.closest,
        links: points.map(link).collect(),
        assuming: found.reason.as_ref().map_or(Vec::new(), |reason| reason.assuming.clone()),
        open_by: Vec::new(),
        diameter: found.diameter,
        nodes: found.nodes,
    }
}
