//! Addresses of points that two pieces of space may share.

use frond_core::Affine3;
use glam::DVec3;

use crate::exact::address::Address;

/// Addresses that are tried at most.
const MOST_ADDRESSES: usize = 60_000;

/// Pairs of addresses of two pieces each whose points are one to rounding, over systems of a few letters: short heads
/// and words of one or two letters without end. `near` is how far rounding may take points apart.
pub(crate) fn meetings(maps: &[Affine3], near: f64) -> Vec<(Address, Address, DVec3)> {
    let count = maps.len();
    let letters = || (0..count).map(|i| i as u8);
    let mut repeats: Vec<Vec<u8>> = letters().map(|i| vec![i]).collect();
    if count <= 8 {
        repeats.extend(letters().flat_map(|i| letters().filter(move |&j| j != i).map(move |j| vec![i, j])));
    }
    let mut heads: Vec<Vec<u8>> = vec![vec![]];
    let mut level = heads.clone();
    for _ in 0..3 {
        level = level.iter().flat_map(|head| letters().map(move |i| [&head[..], &[i]].concat())).collect();
        if (heads.len() + level.len()) * repeats.len() > MOST_ADDRESSES {
            break;
        }
        heads.extend(level.iter().cloned());
    }
    let mut found: Vec<(DVec3, Address)> = Vec::new();
    for repeat in &repeats {
        let word = repeat.iter().fold(Affine3::IDENTITY, |map, &l| map * maps[usize::from(l)]);
        let Some(fixed) = word.fixed_point() else { continue };
        for head in &heads {
            // A head that ends as the repetition does names the same point as a shorter one.
            if head.last().is_some() && head.last() == repeat.last() {
                continue;
            }
            let point = head.iter().rev().fold(fixed, |x, &l| maps[usize::from(l)].apply(x));
            found.push((point, Address { head: head.clone(), repeat: repeat.clone() }));
        }
    }
    found.sort_by(|a, b| a.0.x.total_cmp(&b.0.x));
    let mut met = Vec::new();
    let mut seen = vec![0_u8; count * count];
    for (k, (point, address)) in found.iter().enumerate() {
        for (other, second) in &found[k + 1..] {
            if other.x - point.x > near {
                break;
            }
            let (i, j) = (address.first(), second.first());
            let tries = &mut seen[i.min(j) * count + i.max(j)];
            if i != j && other.distance(*point) <= near && *tries < MOST_POINTS_PER_PAIR {
                *tries += 1;
                let (a, b) = if i < j { (address, second) } else { (second, address) };
                met.push((a.clone(), b.clone(), *point));
            }
        }
    }
    met
}

/// Points of two pieces that are kept at most.
const MOST_POINTS_PER_PAIR: u8 = 6;
