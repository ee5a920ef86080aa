//! Clusters of votes, and what they are.

use frond_core::shared::sort_indices;

use super::echo::{Letter, Words};
use super::features::Features;
use super::options::{BINS, HoughOptions, PLANE};
use super::pairing::Pairing;
use super::refine::{Candidate, refine};

/// Peaks of one plane that are followed.
const MOST_PEAKS: usize = 32;

/// Maps with a smaller |a| or |c| are clutter.
const CLUTTER_FACTOR: f64 = 0.15;

/// Maps with a larger a and c are, too: they hardly differ from the identity.
const IDENTITY_FACTOR: f64 = 0.9;

/// The strongest maps, whose compositions are echoes.
const MAX_BASES: usize = 7;

/// Votes for one map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cluster {
    /// How many.
    pub hits: u32,
    /// The middle of its bin: a, b, c, d, e of eq 1, in the features' own units.
    pub map: [f64; 5],
    /// Its bins of a, b, c (64 is zero), d and e (128 is zero).
    pub bins: [u16; 5],
}

/// What a cluster is.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// A map of its own.
    Map,
    /// A composition of stronger maps and their inverses, the last letter done first.
    Echo(Vec<Letter>),
    /// So small an |a| or |c| that almost everything is alike, or so large an a and c that nothing is moved.
    Clutter,
}

/// A cluster with its name.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// The votes.
    pub cluster: Cluster,
    /// What it is. Letters of echoes are indices of clusters in the same list.
    pub kind: Kind,
    /// The map by least squares, with the domain on which it holds; none where it holds nowhere.
    pub candidate: Option<Candidate>,
}

/// The highest bins of all planes.
pub(super) fn peaks(pairing: &Pairing, cells: &[u32], counts: &[u32]) -> Vec<Cluster> {
    let mut clusters = Vec::new();
    for (&cell, plane) in cells.iter().zip(counts.chunks_exact(PLANE * PLANE)) {
        let mut highest: Vec<_> = (0..plane.len()).filter(|&at| is_peak(plane, at)).collect();
        sort_indices(&mut highest, &|a, b| plane[b].cmp(&plane[a]));
        for at in highest.into_iter().take(MOST_PEAKS) {
            let cell = cell as usize;
            let abc = [cell / (BINS * BINS), cell / BINS % BINS, cell % BINS];
            let bins = [abc[0], abc[1], abc[2], at / PLANE, at % PLANE].map(|bin| bin as u16);
            let map = pairing.frame.out(pairing.center(bins));
            clusters.push(Cluster { hits: plane[at], map, bins });
        }
    }
    clusters
}

/// Whether no neighbour has more hits; of equals the first counts.
fn is_peak(plane: &[u32], at: usize) -> bool {
    const FEWEST_HITS: u32 = 3;
    let mine = plane[at];
    if mine < FEWEST_HITS {
        return false;
    }
    let (row, column) = (at / PLANE, at % PLANE);
    let rows = row.saturating_sub(1)..=(row + 1).min(PLANE - 1);
    rows.flat_map(|r| (column.saturating_sub(1)..=(column + 1).min(PLANE - 1)).map(move |c| r * PLANE + c))
        .all(|other| plane[other] < mine || (plane[other] == mine && other >= at))
}

/// Names clusters (the strongest first) and refines them by least squares.
#[must_use]
pub fn name_clusters(
    coarse: &Features,
    fine: &Features,
    options: HoughOptions,
    clusters: &[Cluster],
) -> Vec<Found> {
    let pairing = Pairing::new(coarse, fine, options);
    let mut words = Words::default();
    let mut bases = 0;
    let mut found = Vec::with_capacity(clusters.len());
    for (index, &cluster) in clusters.iter().enumerate() {
        let map = pairing.frame.into(cluster.map);
        let refined = refine(&pairing, map);
        let still = map[0].min(map[2]) > IDENTITY_FACTOR;
        let kind = if still || map[0].abs() < CLUTTER_FACTOR || map[2].abs() < CLUTTER_FACTOR {
            Kind::Clutter
        } else if let Some(word) = words.find(map, pairing.quanta()) {
            Kind::Echo(word)
        } else {
            if bases < MAX_BASES {
                bases += 1;
                words.add(index, refined.map_or(map, |(map, _)| map));
            }
            Kind::Map
        };
        found.push(Found { cluster, kind, candidate: refined.map(|(_, candidate)| candidate) });
    }
    found
}

/// Refines a map that was picked by hand: the part on which it holds is found, and b, c and e by least squares there.
#[must_use]
pub fn refine_map(coarse: &Features, fine: &Features, map: [f64; 5]) -> Option<Candidate> {
    let pairing = Pairing::new(coarse, fine, HoughOptions::default());
    map.iter().all(|x| x.abs() <= 1e100).then_some(())?;
    refine(&pairing, pairing.frame.into(map)).map(|(_, candidate)| candidate)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bin_beside_a_higher_one_is_no_peak() {
        let mut plane = vec![0; PLANE * PLANE];
        for (at, hits) in [(0, 9), (1, 8), (PLANE + 1, 9), (5 * PLANE, 4), (7 * PLANE + 9, 2)] {
            plane[at] = hits;
        }
        let peaks: Vec<_> = (0..plane.len()).filter(|&at| is_peak(&plane, at)).collect();
        assert_eq!(peaks, [0, 5 * PLANE]);
    }
}
