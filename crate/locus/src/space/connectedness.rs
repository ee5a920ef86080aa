//! The full answer for one system of space.

use frond_core::{Affine3, Contraction3, Fan3, Ifs3};
use glam::DVec3;

use crate::magnification::Magnification;
use crate::overlap_graph::OverlapGraph;
use crate::space::bracket::Closest;
use crate::space::frame::Frame3;
use crate::space::reason::{self, Reason3};
use crate::verdict::{Gap, Options, Verdict};

/// The answer of [`connectedness3`]: what [`Connectedness`](crate::Connectedness) is in the plane.
#[derive(Clone, Debug, PartialEq)]
pub struct Connectedness3 {
    /// Whether the attractor is in one piece.
    pub verdict: Verdict,
    /// The widest edge of the minimum spanning tree between the pieces, in units of space: zero if and only if the
    /// attractor is connected. Where it is disconnected, the bounds are within 1 in 100 of each other unless the budget
    /// was spent.
    pub gap: Gap,
    /// Pairs of maps whose attractorlets meet, or come within epsilon of each other, the smaller index first, in
    /// ascending order.
    pub overlaps: Vec<(usize, usize)>,
    /// For each map the number, from 0, of the component of the overlap graph that its attractorlet is in.
    pub components: Vec<usize>,
    /// How many components the overlap graph has.
    pub count: usize,
    /// Two points of the attractor in different pieces whose distance is about `gap.upper`. `None` where it is proved
    /// to be in one piece, or is a single point.
    pub closest: Option<(DVec3, DVec3)>,
    /// An upper bound of the diameter of the attractor: epsilon is relative to it.
    pub diameter: f64,
    /// How many pairs of pieces were looked at.
    pub nodes: usize,
    /// Why it is `Connected`; or, where it is `Touching`, under which reading of its numbers it would be.
    pub reason: Option<Reason3>,
}

impl Connectedness3 {
    /// As in the plane.
    fn in_units_before(self, magnification: Magnification) -> Self {
        let mut reason = self.reason.filter(Reason3::is_proof);
        for shared in reason.iter_mut().flat_map(|reason| &mut reason.points) {
            shared.at = magnification.point3(shared.at);
        }
        Self {
            gap: magnification.gap(self.gap),
            closest: self.closest.map(|(p, q)| (magnification.point3(p), magnification.point3(q))),
            diameter: magnification.up(self.diameter),
            reason,
            ..self
        }
    }
}

/// Cells along an edge of the cube of directions.
const FAN_CELLS: usize = 8;
/// How near the bounds of a gap come.
const BRACKET_WIDTH: f64 = 0.01;

/// Decides whether the attractor of `ifs` is connected, which of its pieces meet, and how wide the widest gap is.
///
/// `Connected` and `Disconnected` are proofs, rounding and that of the coefficients reckoned with; `Touching` is what
/// can be said at the resolution.
///
/// ```
/// use frond_core::{Affine3, Ifs3};
/// use frond_locus::{Options, Verdict, connectedness3};
/// use glam::DVec3;
///
/// // Sierpinski's tetrahedron: four halves that share the middles of its edges.
/// let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
/// let maps = corners.map(|corner| Affine3::scaling(DVec3::splat(0.5)).about(corner));
/// let answer = connectedness3(&Ifs3::new(maps.to_vec())?, &Options::default());
/// assert_eq!(answer.verdict, Verdict::Connected);
/// # Ok::<(), frond_core::IfsError>(())
/// ```
#[must_use]
pub fn connectedness3(ifs: &Ifs3, options: &Options) -> Connectedness3 {
    if let Some(magnification) = Magnification::of3(ifs.maps()) {
        let maps = magnification.magnify3(ifs.maps());
        // Size is no matter for it: those as given have one.
        if let Ok(contraction) = Contraction3::find(&maps) {
            return decided(&maps, &contraction, options).in_units_before(magnification);
        }
    }
    decided(ifs.maps(), ifs.contraction(), options)
}

fn decided(maps: &[Affine3], contraction: &Contraction3, options: &Options) -> Connectedness3 {
    let count = maps.len();
    let mut frame = Frame3::default();
    frame.set_round(maps, contraction);
    if frame.point || count == 1 {
        return in_one_point(count, reason::find(maps, 0.0));
    }
    let mut fan = Fan3::default();
    fan.set(&frame.maps, frame.factor, FAN_CELLS, 1e-4);
    let diameter = fan.diameter(frame.linear);
    let resolution = frame.resolution(options.epsilon.max(0.0), diameter);
    let mut closest = Closest::default();
    closest.begin(&frame, &fan);
    let found = closest.bracket(&frame, &fan, resolution, BRACKET_WIDTH, options.budget);
    let apart = found.lower > 0.0;
    let reason = if apart { None } else { reason::find(maps, diameter) };
    let proved = reason.as_ref().is_some_and(Reason3::is_proof);
    let verdict = if proved {
        Verdict::Connected
    } else if found.upper <= resolution {
        Verdict::Touching
    } else if apart {
        Verdict::Disconnected
    } else {
        Verdict::Undecided
    };
    // Which of the pieces in one component meet as well.
    let limit = closest.nodes.saturating_add(options.budget);
    let mut graph = OverlapGraph::new(count);
    for pair in (0..count * count).filter(|pair| pair / count < pair % count) {
        closest.settle(&frame, &fan, pair, resolution, limit);
        if closest.nearest[pair].reach <= resolution {
            graph.add(pair / count, pair % count);
        }
    }
    for reason in reason.iter().filter(|_| proved) {
        let pairs = reason.points.iter().map(|point| point.pair).chain(reason.volumes.iter().copied());
        pairs.for_each(|(i, j)| graph.add(i, j));
    }
    let widest = found.widest.map(|pair| closest.nearest[pair]).filter(|_| !proved);
    let gap = if proved { Gap::default() } else { Gap { lower: found.lower, upper: found.upper } };
    Connectedness3 {
        verdict,
        gap,
        overlaps: graph.edges(),
        components: graph.components().labels(),
        count: graph.components().count(),
        closest: widest.map(|nearest| (frame.to_space(nearest.from), frame.to_space(nearest.to))),
        diameter,
        nodes: closest.nodes,
        reason,
    }
}

/// All pieces are the same point, as far as floating point tells.
fn in_one_point(count: usize, reason: Option<Reason3>) -> Connectedness3 {
    let proved = reason.as_ref().is_some_and(Reason3::is_proof);
    Connectedness3 {
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
