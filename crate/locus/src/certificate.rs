//! Proofs of disconnection that can be handed on.

use frond_core::{Affine2, Ifs};
use glam::DVec2;

use crate::connectedness::Options;
use crate::enclosure::Enclosure;
use crate::frame::Frame;
use crate::graph::Components;
use crate::outline::Outline;
use crate::search::Search;
use crate::separate::Descent;

/// A proof that an attractor is in several pieces, which can be checked without searching.
///
/// # What it proves
///
/// *There is an attractor `A`, and it lies in the polygon `P`.* Every word `u` of `letters` letters maps `P` strictly
/// into itself: `w_u(P)` is in the inside of `P`. Then `D = P - P` is the unit ball of a norm, and for the linear part
/// `M_u D = M_u P - M_u P` lies inside `D`: each of these finitely many words contracts in that norm. So they have
/// an attractor (Hutchinson 1981), which is that of the maps, and it is in every compact set that is mapped into itself.
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

/// Two pieces that are apart, and a direction that shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Separation {
    /// The word of a piece on side 0; letters from 0, the largest piece first.
    pub u: Vec<u8>,
    /// The word of a piece on side 1.
    pub v: Vec<u8>,
    /// Along this direction all of the first comes before all of the second. Not of unit length.
    pub normal: DVec2,
}

/// A certificate that the attractor is disconnected, or `None` if that is not proved: it takes the verdict
/// [`Disconnected`](crate::Verdict::Disconnected) at these options, as many looks again, and a gap that shows beside
/// rounding.
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
    let mut frame = Frame::default();
    frame.set_round(maps, ifs.contraction());
    if frame.point {
        return None;
    }
    let mut outline = Outline::default();
    outline.set(&frame.maps, 1e-4 * (1.0 - frame.factor), 4000);
    let mut search = Search::default();
    search.begin(&frame, &outline, options.epsilon.max(0.0));
    search.settle(&frame, &outline, options.budget);
    let parts = search.coarsest();
    if parts.count() < 2 {
        return None;
    }
    // Refines what is known of the distances, so that the cut goes where the gap is widest.
    search.span(&frame, &outline, 0.3, 0.0, search.nodes.saturating_add(options.budget.min(20_000)));
    let side = cut(&search, &parts);
    let enclosure = Enclosure::find(&frame, outline.diameter(glam::DMat2::IDENTITY))?;
    let mut descent = Descent::new(&frame, &enclosure, options.budget);
    for i in (0..maps.len()).filter(|&i| side[i] == 0) {
        for j in (0..maps.len()).filter(|&j| side[j] == 1) {
            if !descent.separate(i as u8, j as u8) {
                return None;
            }
        }
    }
    Some(Certificate {
        maps: maps.iter().copied().map(Affine2::to_row).collect(),
        polygon: enclosure.plane.clone(),
        letters: enclosure.letters,
        side,
        pairs: descent.pairs,
    })
}

/// Parts the maps at the widest gap: all others are closed, nearest first, until two components are left.
fn cut(search: &Search, parts: &Components) -> Vec<u8> {
    let count = search.count;
    let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j)));
    let mut edges: Vec<(f64, usize, usize)> =
        pairs.map(|(i, j)| (search.nearest[i * count + j].reach, i, j)).collect();
    edges.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut components = parts.clone();
    for (_, i, j) in edges {
        if components.count() > 2 {
            components.join(i, j);
        }
    }
    components.labels().into_iter().map(|label| label.min(1) as u8).collect()
}
