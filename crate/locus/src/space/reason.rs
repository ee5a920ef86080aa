//! Reasons for an attractor of space to be in one piece that can be shown.

use frond_core::Affine3;
use glam::DVec3;

use crate::exact::address::Address;
use crate::overlap_graph::OverlapGraph;
use crate::space::rational::Exact;
use crate::space::shared_points::meetings;

/// The kinds of reasons in space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Reason3Kind {
    /// There is one map.
    OneMap,
    /// All maps are the same.
    EqualMaps,
    /// All maps leave one point where it is: it is the attractor.
    CommonPoint,
    /// Enough pairs of maps have determinants that leave no room between their pieces.
    Volume,
    /// Enough pairs of pieces have a point in common; some of them may also be too large to lie side by side.
    SharedPoints,
}

impl Reason3Kind {
    /// Its name in the programming interface.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::OneMap => "one-map",
            Self::EqualMaps => "equal-maps",
            Self::CommonPoint => "common-point",
            Self::Volume => "volume",
            Self::SharedPoints => "shared-points",
        }
    }
}

/// A point that two pieces share.
#[derive(Clone, Debug, PartialEq)]
pub struct Shared3 {
    /// Two maps, from 0, the smaller index first.
    pub pair: (usize, usize),
    /// The addresses of the point in the first piece and in the second: letters from 1, "1(2)" for 1222.. as in the
    /// plane.
    pub words: [String; 2],
    /// The point, to rounding.
    pub at: DVec3,
}

/// Why an attractor of space is in one piece: enough pairs of pieces meet to reach every piece (Hata 1985).
///
/// With nothing assumed it is a proof about the maps as they are given, computed in whole numbers of any length.
/// Otherwise it is one about numbers that they come near.
#[derive(Clone, Debug, PartialEq)]
pub struct Reason3 {
    /// Which kind of reason.
    pub kind: Reason3Kind,
    /// The points that hold pieces together.
    pub points: Vec<Shared3>,
    /// Pairs of pieces that are too large to lie side by side: `|det| + |det| >= 1`. Were they apart, a small enough
    /// neighbourhood of the attractor of these two alone would hold its two disjoint images and more.
    pub volumes: Vec<(usize, usize)>,
    /// Readings of numbers that it hangs on, such as "0.3333333333333333 is 1/3".
    pub assuming: Vec<String>,
}

impl Reason3 {
    const fn of(kind: Reason3Kind) -> Self {
        Self { kind, points: Vec::new(), volumes: Vec::new(), assuming: Vec::new() }
    }

    /// Whether it is a proof about the maps as they are given.
    #[must_use]
    pub fn is_proof(&self) -> bool {
        self.assuming.is_empty()
    }

    /// The reason in a sentence or two.
    #[must_use]
    pub fn text(&self) -> String {
        let text = match self.kind {
            Reason3Kind::OneMap => "There is one map, and its attractor is one point.".to_owned(),
            Reason3Kind::EqualMaps => "All maps are equal, so there is only one piece.".to_owned(),
            Reason3Kind::CommonPoint => {
                "All maps keep the same point fixed, and the attractor is this point.".to_owned()
            }
            Reason3Kind::Volume => {
                "Enough pairs of pieces have volume factors that add up to 1 or more: such a pair cannot avoid each \
                 other, and these pairs join all the pieces."
                    .to_owned()
            }
            Reason3Kind::SharedPoints => {
                let [a, b] = self.points.first().map(|point| point.words.clone()).unwrap_or_default();
                match self.points.len() {
                    1 => format!("The pieces meet in one point, whose addresses are {a} and {b}."),
                    count => format!(
                        "The pieces meet in {count} points, which join all of them. One of these points has the addresses {a} and {b}."
                    ),
                }
            }
        };
        match self.assuming.as_slice() {
            [] => text,
            [one] => format!("If {one}, this is a proof. {text}"),
            [one, ..] => format!("If {one} (and so on), this is a proof. {text}"),
        }
    }
}

/// Looks for a reason; `size` is that of the attractor. A proof, or else what would be one if numbers meant what they
/// come near.
pub(crate) fn find(maps: &[Affine3], size: f64) -> Option<Reason3> {
    match maps {
        [] => return None,
        [_] => return Some(Reason3::of(Reason3Kind::OneMap)),
        [first, rest @ ..] if rest.iter().all(|map| map == first) => {
            return Some(Reason3::of(Reason3Kind::EqualMaps));
        }
        _ if maps.iter().all(|map| map.translation == DVec3::ZERO) => {
            return Some(Reason3::of(Reason3Kind::CommonPoint));
        }
        _ => {}
    }
    let given = Exact::as_given(maps);
    let met = meetings(maps, 1e-10 * size);
    given.and_then(|exact| check(maps, &exact, &met)).or_else(|| check(maps, &Exact::as_meant(maps)?, &met))
}

/// What is left of a reason in whole numbers.
fn check(maps: &[Affine3], exact: &Exact, met: &[(Address, Address, DVec3)]) -> Option<Reason3> {
    let count = maps.len();
    let mut graph = OverlapGraph::new(count);
    let mut volumes = Vec::new();
    for i in 0..count {
        for j in i + 1..count {
            let rough = maps[i].determinant().abs() + maps[j].determinant().abs();
            if rough > 0.999 && !graph.components().joined(i, j) && exact.volumes_fill(i, j) {
                graph.add(i, j);
                volumes.push((i, j));
            }
        }
    }
    let mut points = Vec::new();
    for (a, b, at) in met {
        let (i, j) = (a.first(), b.first());
        if graph.components().joined(i, j) {
            continue;
        }
        let point = |address: &Address| exact.point(&address.head, &address.repeat);
        if let (Some(p), Some(q)) = (point(a), point(b))
            && p == q
        {
            graph.add(i, j);
            points.push(Shared3 { pair: (i, j), words: [a, b].map(|address| address.shown(count)), at: *at });
        }
    }
    points.sort_by_key(|shared| shared.pair);
    let kind = if points.is_empty() { Reason3Kind::Volume } else { Reason3Kind::SharedPoints };
    let assuming = exact.assuming.clone();
    graph.is_connected().then_some(Reason3 { kind, points, volumes, assuming })
}
