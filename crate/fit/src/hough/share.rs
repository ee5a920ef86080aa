//! The second pass in parts, for workers that share it.

use frond_core::shared::sort_indices;

use super::cluster::Cluster;
use super::features::Features;
use super::options::{BINS, HoughOptions};
use super::pairing::{CELLS, Pairing};

impl Pairing {
    /// Votes in a pass for each bin of a.
    fn votes(&self) -> Vec<f64> {
        let mut votes = vec![0.0; BINS];
        let (coarse, fine) = (self.coarse.points(), self.fine.points());
        let [from, to] = [coarse, fine].map(|points| {
            let last = points.len() - 1;
            (points[last].x - points[0].x) / last as f64
        });
        for width in self.widths() {
            for length in self.lengths() {
                let a = length as f64 * to / (width as f64 * from);
                let many = self.work(width) / width as f64 * (fine.len() - length) as f64;
                for a in [a, -a] {
                    if a.abs() < 1.0 && (a > 0.0 || self.options.reflected) {
                        let bin = (a + 1.0) * BINS as f64 / 2.0;
                        votes[(bin as usize).min(BINS - 1)] += many;
                    }
                }
            }
        }
        votes
    }
}

/// Splits promising cells so that each part of the second pass takes about as long, and none looks at an a of another.
///
/// So each worker has room for its own cells only, and leaves out what does not concern it. The peaks of all parts are
/// [gathered](gather) then.
#[must_use]
pub fn share_cells(
    coarse: &Features,
    fine: &Features,
    options: HoughOptions,
    cells: &[u32],
    parts: usize,
) -> Vec<Vec<u32>> {
    let mut shares = vec![Vec::new(); parts.max(1)];
    let mut loads = vec![0.0; shares.len()];
    let votes = Pairing::new(coarse, fine, options).votes();
    let slab = |cell: u32| (cell as usize / (BINS * BINS)).min(BINS - 1);
    let cells: Vec<_> = cells.iter().copied().filter(|&cell| (cell as usize) < CELLS).collect();
    let mut slabs: Vec<_> = (0..BINS).filter(|&a| cells.iter().any(|&cell| slab(cell) == a)).collect();
    sort_indices(&mut slabs, &|a, b| votes[b].total_cmp(&votes[a]));
    for a in slabs {
        let lightest = (0..loads.len()).min_by(|&i, &j| f64::total_cmp(&loads[i], &loads[j])).unwrap_or(0);
        loads[lightest] += votes[a].max(1.0);
        shares[lightest].extend(cells.iter().copied().filter(|&cell| slab(cell) == a));
    }
    shares
}

/// The clusters among peaks of one pass or of all its parts: those with most hits first, at most `most`, and none
/// beside a higher one.
#[must_use]
pub fn gather(mut peaks: Vec<Cluster>, most: usize) -> Vec<Cluster> {
    peaks.sort_by_key(|cluster| (std::cmp::Reverse(cluster.hits), cluster.bins));
    // What spills over into bins beside a higher one is no map of its own.
    let mut kept: Vec<Cluster> = Vec::new();
    for cluster in peaks {
        let beside = |other: &Cluster| other.bins.iter().zip(cluster.bins).all(|(&x, y)| x.abs_diff(y) <= 1);
        if !kept.iter().any(beside) {
            kept.push(cluster);
        }
    }
    kept.truncate(most);
    kept
}
