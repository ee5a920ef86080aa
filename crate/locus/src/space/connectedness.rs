//! The full answer for one system of space.

use frond_core::{Affine3, Contraction3, Ifs3, SupportTable3};
use glam::DVec3;

use crate::connectedness::Connectedness;
use crate::magnification::Magnification;
use crate::overlap_graph::OverlapGraph;
use crate::space::bracket::Closest;
use crate::space::frame::Frame3;
use crate::space::reason::{self, Reason3};
use crate::verdict::{Gap, Options, Verdict};

/// The answer of [`connectedness3`].
pub type Connectedness3 = Connectedness<DVec3, Reason3>;

/// Cells along an edge of the cube of directions.
const TABLE_CELLS: usize = 8;
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
            let point = |p| magnification.point3(p);
            return decided(&maps, &contraction, options).in_units_before(
                magnification,
                point,
                |mut reason| {
                    reason.points.iter_mut().for_each(|shared| shared.at = point(shared.at));
                    reason.is_proof().then_some(reason)
                },
            );
        }
    }
    decided(ifs.maps(), ifs.contraction(), options)
}

fn decided(maps: &[Affine3], contraction: &Contraction3, options: &Options) -> Connectedness3 {
    let count = maps.len();
    let mut frame = Frame3::default();
    frame.set_round(maps, contraction);
    if frame.point || count == 1 {
        return Connectedness3::in_one_point(count, reason::find(maps, 0.0), Reason3::is_proof);
    }
    let mut table = SupportTable3::default();
    table.set(&frame.maps, frame.factor, TABLE_CELLS, 1e-4);
    let diameter = table.diameter(frame.linear);
    let resolution = frame.resolution(options.epsilon.max(0.0), diameter);
    let mut closest = Closest::default();
    closest.begin(&frame, &table);
    let found = closest.bracket(&frame, &table, resolution, BRACKET_WIDTH, options.budget);
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
    let limit = closest.nodes().saturating_add(options.budget);
    let mut graph = OverlapGraph::new(count);
    for pair in (0..count * count).filter(|pair| pair / count < pair % count) {
        if closest.settle(&frame, &table, pair, resolution, limit) {
            graph.add(pair / count, pair % count);
        }
    }
    for reason in reason.iter().filter(|_| proved) {
        let pairs = reason.points.iter().map(|point| point.pair).chain(reason.volumes.iter().copied());
        pairs.for_each(|(i, j)| graph.add(i, j));
    }
    let widest = found.pair.map(|pair| closest.near(pair).points).filter(|_| !proved);
    let unknown = Gap { lower: 0.0, upper: f64::INFINITY };
    let gap = if proved { Gap::default() } else { found.gap(diameter).unwrap_or(unknown) };
    let found = Connectedness3 {
        verdict,
        gap,
        overlaps: graph.edges(),
        components: graph.components().labels(),
        count: graph.components().count(),
        closest: widest.map(|[from, to]| (frame.to_space(from), frame.to_space(to))),
        diameter,
        nodes: closest.nodes(),
        reason,
    };
    found.or_undecided()
}
