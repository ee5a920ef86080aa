//! Whether the pairs of a certificate leave nothing out.

use crate::certificate::Certificate;
use crate::refused::Refused;
use crate::work::{LOOK_UP, Work};

/// A pair of words, and the pairs of the certificate that are below it.
struct Node {
    below: Vec<u32>,
    /// How many letters the two words have.
    depth: [usize; 2],
}

/// What [`check_cover`] takes: each pair is looked at once a letter, and what is split has parts as many as maps.
pub(crate) fn cost_cover(certificate: &Certificate) -> u64 {
    let letters: usize = certificate.pairs.iter().map(|pair| pair.u.len() + pair.v.len()).sum();
    LOOK_UP * (2 * letters + certificate.maps.len().pow(2)) as u64
}

/// Checks that from each two letters across the cut, replacing one word of a pair by all its parts again and again
/// leads to pairs of the certificate.
///
/// Which word is to be replaced is not written down, and need not be: if all pairs below have a longer first word then
/// splitting that one first is right whenever anything is, since where the second is split too, it is so below each
/// part.
pub(crate) fn check_cover(certificate: &Certificate, work: &Work) -> Result<(), Refused> {
    let Certificate { maps, side, pairs, .. } = certificate;
    let count = maps.len();
    work.spend(LOOK_UP * (count * count) as u64)?;
    // By first letters. Words are known not to be empty.
    let mut roots: Vec<Vec<u32>> = vec![Vec::new(); count * count];
    for (k, pair) in pairs.iter().enumerate() {
        roots[usize::from(pair.u[0]) * count + usize::from(pair.v[0])].push(k as u32);
    }
    let mut stack = Vec::new();
    for i in (0..count).filter(|&i| side[i] == 0) {
        for j in (0..count).filter(|&j| side[j] == 1) {
            let below = std::mem::take(&mut roots[i * count + j]);
            if below.is_empty() {
                return Err(Refused::Uncovered { u: vec![i as u8], v: vec![j as u8] });
            }
            stack.push(Node { below, depth: [1, 1] });
        }
    }
    while let Some(node) = stack.pop() {
        work.spend(2 * LOOK_UP * node.below.len() as u64)?;
        let word = |k: u32, which: usize| {
            let pair = &pairs[k as usize];
            if which == 0 { &pair.u } else { &pair.v }
        };
        let longer = |which: usize| node.below.iter().all(|&k| word(k, which).len() > node.depth[which]);
        let ends = |k: &u32| (0..2).all(|which| word(*k, which).len() == node.depth[which]);
        if node.below.iter().any(ends) {
            // Apart as a whole; what else is below says no more.
            continue;
        }
        // There is one below, or it would not be on the stack.
        let first = node.below[0];
        let prefix = |which: usize| word(first, which)[..node.depth[which]].to_vec();
        let Some(which) = (0..2).find(|&which| longer(which)) else {
            return Err(Refused::Uncovered { u: prefix(0), v: prefix(1) });
        };
        let mut parts: Vec<Vec<u32>> = vec![Vec::new(); count];
        for &k in &node.below {
            parts[usize::from(word(k, which)[node.depth[which]])].push(k);
        }
        let mut depth = node.depth;
        depth[which] += 1;
        for (letter, below) in parts.into_iter().enumerate() {
            if below.is_empty() {
                let mut words = [prefix(0), prefix(1)];
                words[which].push(letter as u8);
                let [u, v] = words;
                return Err(Refused::Uncovered { u, v });
            }
            stack.push(Node { below, depth });
        }
    }
    Ok(())
}
