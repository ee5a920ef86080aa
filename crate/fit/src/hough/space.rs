//! The space of clusters: most of what votes tell lies in two or three of its five dimensions (section 5.1).

use serde::Serialize;

use super::cluster::Cluster;
use super::options::{BINS, PLANE};

/// Rounds of Jacobi's method; five dimensions take six or seven.
const JACOBI_ROUNDS: usize = 40;

/// The principal components of clusters, each weighted by its hits.
///
/// a, b, c, d and e have other units, so each is first measured in the range in which it is counted: from -1 to 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Components {
    /// Where the weight's middle is.
    pub mean: [f64; 5],
    /// Directions of unit length, perpendicular to each other, along which clusters spread: most first. The largest
    /// number of each is positive.
    pub axes: [[f64; 5]; 5],
    /// Which part of the whole variance lies along each, from 0 to 1. All are 0 where clusters are one point.
    pub shares: [f64; 5],
}

/// A cluster's a, b, c, d and e in the ranges in which they are counted: from -1 to 1.
#[must_use]
pub fn in_range(cluster: &Cluster) -> [f64; 5] {
    std::array::from_fn(|i| {
        let zero = if i < 3 { BINS / 2 } else { PLANE / 2 } as f64;
        (f64::from(cluster.bins[i]) - zero) / zero
    })
}

impl Components {
    /// Of some clusters; none where no one has hits.
    #[must_use]
    pub fn of(clusters: &[Cluster]) -> Option<Self> {
        let weight: f64 = clusters.iter().map(|cluster| f64::from(cluster.hits)).sum();
        if weight == 0.0 {
            return None;
        }
        let mut mean = [0.0; 5];
        for cluster in clusters {
            for (sum, x) in mean.iter_mut().zip(in_range(cluster)) {
                *sum += f64::from(cluster.hits) / weight * x;
            }
        }
        let mut spread = [[0.0; 5]; 5];
        for cluster in clusters {
            let at = in_range(cluster);
            for (i, row) in spread.iter_mut().enumerate() {
                for (j, sum) in row.iter_mut().enumerate() {
                    *sum += f64::from(cluster.hits) / weight * (at[i] - mean[i]) * (at[j] - mean[j]);
                }
            }
        }
        let (values, vectors) = eigen(spread);
        let mut order = [0, 1, 2, 3, 4];
        order.sort_by(|&i, &j| values[j].total_cmp(&values[i]));
        let whole: f64 = values.iter().map(|value| value.max(0.0)).sum();
        let share = |i: usize| if whole > 0.0 { values[i].max(0.0) / whole } else { 0.0 };
        Some(Self { mean, axes: order.map(|i| upright(vectors[i])), shares: order.map(share) })
    }

    /// Where a cluster lies along the axes, from the middle.
    #[must_use]
    pub fn place(&self, cluster: &Cluster) -> [f64; 5] {
        let at = in_range(cluster);
        self.axes.map(|axis| (0..5).map(|i| axis[i] * (at[i] - self.mean[i])).sum())
    }
}

/// The same direction, its largest number positive: else it would hang on rounding which of the two it is.
fn upright(axis: [f64; 5]) -> [f64; 5] {
    let largest =
        axis.iter().copied().fold(0.0, |most: f64, x| if x.abs() > most.abs() + 1e-9 { x } else { most });
    if largest < 0.0 { axis.map(|x| -x) } else { axis }
}

/// Eigenvalues and unit eigenvectors of a symmetric matrix, by Jacobi's rotations.
fn eigen(mut m: [[f64; 5]; 5]) -> ([f64; 5], [[f64; 5]; 5]) {
    let mut vectors: [[f64; 5]; 5] =
        std::array::from_fn(|i| std::array::from_fn(|j| f64::from(u8::from(i == j))));
    let size: f64 = (0..5).map(|i| m[i][i].abs()).sum();
    for _ in 0..JACOBI_ROUNDS {
        let off: f64 = (0..5).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| m[i][j].abs()).sum();
        if off <= 1e-15 * size {
            break;
        }
        for (p, q) in (0..5).flat_map(|q| (0..q).map(move |p| (p, q))) {
            if m[p][q] == 0.0 {
                continue;
            }
            let ratio = (m[q][q] - m[p][p]) / (2.0 * m[p][q]);
            let tangent = ratio.signum() / (ratio.abs() + ratio.hypot(1.0));
            let cosine = 1.0 / tangent.hypot(1.0);
            let sine = tangent * cosine;
            for row in &mut m {
                (row[p], row[q]) = (cosine * row[p] - sine * row[q], sine * row[p] + cosine * row[q]);
            }
            for k in 0..5 {
                (m[p][k], m[q][k]) = (cosine * m[p][k] - sine * m[q][k], sine * m[p][k] + cosine * m[q][k]);
                let (x, y) = (vectors[p][k], vectors[q][k]);
                (vectors[p][k], vectors[q][k]) = (cosine * x - sine * y, sine * x + cosine * y);
            }
        }
    }
    (std::array::from_fn(|i| m[i][i]), vectors)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cluster(hits: u32, bins: [u16; 5]) -> Cluster {
        Cluster { hits, map: [0.0; 5], bins }
    }

    #[test]
    fn a_line_of_clusters_has_one_component() {
        // Along (4, 0, -4, 0, 4) bins: (1/16, 0, -1/16, 0, 1/32) in ranges.
        let line: Vec<_> = (0..9)
            .map(|i| cluster(1 + u32::from(i), [30 + 4 * i, 70, 90 - 4 * i, 128, 100 + 4 * i]))
            .collect();
        let components = Components::of(&line).unwrap();
        assert!((components.shares[0] - 1.0).abs() < 1e-12, "{components:?}");
        let expected = [2.0 / 3.0, 0.0, -2.0 / 3.0, 0.0, 1.0 / 3.0];
        for (x, y) in components.axes[0].into_iter().zip(expected) {
            assert!((x - y).abs() < 1e-12, "{components:?}");
        }
        // Hits pull the middle to where they are many: 16/3 along, not 4.
        assert!((components.mean[0] - (30.0 + 4.0 * 16.0 / 3.0 - 64.0) / 64.0).abs() < 1e-12);
        let place = components.place(&line[8]);
        assert!((place[0] - 8.0 / 3.0 * 0.09375).abs() < 1e-12, "{place:?}");
        assert!(place[1..].iter().all(|x| x.abs() < 1e-12));
    }

    #[test]
    fn axes_stand_on_each_other_and_shares_fall() {
        let mut seed = 7_u32;
        let mut bin = |most: u32| {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((seed >> 8) % most) as u16
        };
        let cloud: Vec<_> = (0..200)
            .map(|_| cluster(1 + u32::from(bin(99)), [bin(128), bin(60), bin(128), bin(9), bin(256)]))
            .collect();
        let Components { axes, shares, .. } = Components::of(&cloud).unwrap();
        for i in 0..5 {
            for j in 0..5 {
                let product: f64 = (0..5).map(|k| axes[i][k] * axes[j][k]).sum();
                assert!((product - f64::from(u8::from(i == j))).abs() < 1e-12);
            }
        }
        assert!(shares.windows(2).all(|pair| pair[0] >= pair[1]));
        assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-12);
        // Along the axes nothing goes together any more.
        let components = Components::of(&cloud).unwrap();
        let weight: f64 = cloud.iter().map(|c| f64::from(c.hits)).sum();
        let both: f64 = cloud
            .iter()
            .map(|c| (components.place(c), f64::from(c.hits)))
            .map(|(p, w)| w * p[0] * p[1])
            .sum();
        assert!((both / weight).abs() < 1e-12);
    }

    #[test]
    fn one_point_and_none_have_no_spread() {
        assert_eq!(Components::of(&[]), None);
        assert_eq!(Components::of(&[cluster(0, [0; 5])]), None);
        let one = Components::of(&[cluster(5, [1, 2, 3, 4, 5])]).unwrap();
        assert_eq!(one.shares, [0.0; 5]);
        assert_eq!(one.place(&cluster(5, [1, 2, 3, 4, 5])), [0.0; 5]);
    }
}
