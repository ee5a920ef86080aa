//! The first pass of the Hough transform as section 3.1 has it, word for word: the nearest point is looked for, and eq
//! 14 is solved as a 3 x 3 system, for every candidate.

use frond_fit::{BINS, HoughOptions};
use glam::{DMat3, DVec2, DVec3};

/// What was counted.
pub struct Counted {
    /// Hits of (a, b, c) that are sure: votes that are nearer than [`EDGE`] to the edge of a bin are left out.
    pub counts: Vec<u32>,
    /// How many were left out so.
    pub unsure: u64,
    /// How many candidates there were.
    pub votes: u64,
}

/// In bins.
const EDGE: f64 = 0.01;

/// Counts domains of the given widths only. Both sets of features have t and x from -1 to 1.
pub fn count(
    coarse: &[DVec2],
    fine: &[DVec2],
    options: HoughOptions,
    widths: std::ops::Range<usize>,
) -> Counted {
    let mut counted = Counted { counts: vec![0; BINS * BINS * BINS], unsure: 0, votes: 0 };
    for i in 0..coarse.len() {
        for k in i + 2..coarse.len() {
            if !widths.contains(&(k - i)) {
                continue;
            }
            for l in 0..fine.len() {
                for n in l + 2..fine.len() {
                    if fine[n].x - fine[l].x >= (coarse[k].x - coarse[i].x) * (1.0 - 1e-9) {
                        break;
                    }
                    for (from, until) in [(l, n), (n, l)] {
                        if from > until && !options.reflected {
                            continue;
                        }
                        let a = (fine[until].x - fine[from].x) / (coarse[k].x - coarse[i].x);
                        if a.abs() < options.least_a - 1e-9 || (a * 64.0).round() >= 64.0 {
                            continue;
                        }
                        let d = fine[from].x - a * coarse[i].x;
                        for j in i + 1..k {
                            counted.votes += u64::from(vote(
                                [coarse[i], coarse[j], coarse[k]],
                                &fine[l + 1..n],
                                [fine[from].y, fine[until].y],
                                [a, d],
                                options,
                                &mut counted,
                            ));
                        }
                    }
                }
            }
        }
    }
    counted
}

fn vote(
    triple: [DVec2; 3],
    inside: &[DVec2],
    ends: [f64; 2],
    [a, d]: [f64; 2],
    options: HoughOptions,
    counted: &mut Counted,
) -> bool {
    let image = a * triple[1].x + d;
    let mut middle = inside[0];
    for p in inside {
        // Of two that are as near the first counts, whatever the last digits say.
        if (p.x - image).abs() < (middle.x - image).abs() - 1e-9 {
            middle = *p;
        }
    }
    let matrix =
        DMat3::from_cols(DVec3::from(triple.map(|p| p.x)), DVec3::from(triple.map(|p| p.y)), DVec3::ONE);
    let determinant = matrix.determinant();
    if (determinant / (triple[2].x - triple[0].x)).abs() < 1e-5 {
        return false;
    }
    let [b, c, _] = (matrix.inverse() * DVec3::new(ends[0], middle.y, ends[1])).to_array();
    let places = [a * 64.0, b / options.most_b * 64.0, c * 64.0].map(|x| x + 64.0);
    let bins = places.map(f64::round);
    let outside = |&x: &f64| !(-0.5 - EDGE..127.5 + EDGE).contains(&x);
    if places.iter().any(outside) {
        return true;
    }
    if places.iter().zip(bins).any(|(x, bin)| (x - bin).abs() > 0.5 - EDGE) {
        counted.unsure += 1;
    } else {
        let [a, b, c] = bins.map(|bin| bin as usize);
        counted.counts[(a * BINS + b) * BINS + c] += 1;
    }
    true
}
