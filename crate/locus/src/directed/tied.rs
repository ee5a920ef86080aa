//! Pieces that are tied together in two points of each state, all the way from one system to another.

use frond_core::{Affine2, DirectedIfs, DirectedMap};
use glam::DVec2;

use crate::overlap_graph::OverlapGraph;

/// Of two systems of one graph, between which all maps go straight, the states whose pieces are joined at every moment
/// by images of 0 and of (0, 1).
///
/// Whether a state has these points is the largest answer that agrees with itself: a state has one if one of its
/// maps puts there one that the state it copies has, at both ends and so always, since images of a fixed point go
/// straight. From such a map one goes on to the next for ever, and what all of them shrink to is that point. Pieces
/// whose points are one at both ends share it always, and so do pieces that are the same at both ends.
///
/// All that is compared are sums of two numbers, without rounding.
pub(crate) fn tied(first: &DirectedIfs, last: &DirectedIfs) -> Vec<bool> {
    let has = marks(first, last);
    (0..first.len())
        .map(|state| {
            let [maps, others] = [first, last].map(|end| &end.states()[state]);
            let points: Vec<Vec<Ends>> =
                maps.iter().zip(others).map(|(a, b)| points(&has, [first, last], a, b)).collect();
            let mut graph = OverlapGraph::new(maps.len());
            for i in 0..maps.len() {
                for j in i + 1..maps.len() {
                    let same = maps[i] == maps[j] && others[i] == others[j];
                    if same || points[i].iter().any(|p| points[j].contains(p)) {
                        graph.add(i, j);
                    }
                }
            }
            graph.is_connected()
        })
        .collect()
}

/// A number as it is rounded, and what that leaves.
type Sum = [f64; 2];
/// A point at either end.
type Ends = [[Sum; 2]; 2];

/// a + b without rounding (Knuth 1969).
fn sum(a: f64, b: f64) -> Sum {
    let sum = a + b;
    let part = sum - a;
    [sum, (a - (sum - part)) + (b - part)]
}

/// The image of 0, or of (0, 1).
fn image(map: &Affine2, tip: bool) -> [Sum; 2] {
    let column = if tip { map.linear.y_axis } else { DVec2::ZERO };
    let at = map.translation;
    [sum(at.x, column.x), sum(at.y, column.y)]
}

fn ends(a: &DirectedMap, b: &DirectedMap, tip: bool) -> Ends {
    [image(&a.map, tip), image(&b.map, tip)]
}

/// Whether each state has 0 and (0, 1), always.
fn marks(first: &DirectedIfs, last: &DirectedIfs) -> Vec<[bool; 2]> {
    let mut has = vec![[true; 2]; first.len()];
    loop {
        let next: Vec<[bool; 2]> = (0..first.len())
            .map(|state| {
                let pairs = || first.states()[state].iter().zip(&last.states()[state]);
                [false, true].map(|tip| {
                    let own = image(&Affine2::IDENTITY, tip);
                    pairs().any(|(a, b)| {
                        [false, true]
                            .into_iter()
                            .any(|of| has[a.from][usize::from(of)] && ends(a, b, of) == [own, own])
                    })
                })
            })
            .collect();
        if next == has {
            return has;
        }
        has = next;
    }
}

/// Points of a piece that go straight: images of those that its state has. Of one that is a state as it is, at both
/// ends, those of that state's pieces.
fn points(has: &[[bool; 2]], both: [&DirectedIfs; 2], a: &DirectedMap, b: &DirectedMap) -> Vec<Ends> {
    let of = |a: &DirectedMap, b: &DirectedMap| -> Vec<Ends> {
        let there = |tip: &bool| has[a.from][usize::from(*tip)];
        [false, true].into_iter().filter(there).map(|tip| ends(a, b, tip)).collect()
    };
    if a.map == Affine2::IDENTITY && b.map == Affine2::IDENTITY {
        let parts = both[0].states()[a.from].iter().zip(&both[1].states()[b.from]);
        return of(a, b).into_iter().chain(parts.flat_map(|(a, b)| of(a, b))).collect();
    }
    of(a, b)
}
