//! Points that several pieces hold, among the images of fixed points.

use std::collections::HashMap;

use frond_core::Affine2;
use glam::DVec2;

use crate::exact::address::Address;

/// A point with two addresses, in two pieces.
pub(crate) type Shared = (Address, Address);

/// Points this near are taken for the same; in units of the attractor.
const CELLS_PER_UNIT: f64 = 67_108_864.0;
/// Words of two letters are tried up to this many maps.
const MOST_MAPS_FOR_TWO_LETTERS: usize = 16;
/// Points that are looked at most.
const MOST_POINTS: usize = 2048;

/// What pieces seem to share, in coordinates where the attractor is of size 1: images, under one to three maps, of
/// the fixed points of words of one or two letters.
///
/// Found in floating point, and so only proposed.
pub(crate) fn corners(maps: &[Affine2]) -> Vec<Shared> {
    let count = maps.len();
    let mut points: Vec<(DVec2, Address)> = Vec::new();
    let mut known = HashMap::new();
    let mut add = |points: &mut Vec<(DVec2, Address)>, point: DVec2, head: Vec<u8>, repeat: Vec<u8>| {
        if let Some(address) = Address::new(head, repeat)
            && known.insert(key(point), ()).is_none()
        {
            points.push((point, address));
        }
    };
    for (i, map) in maps.iter().enumerate() {
        if let Some(point) = map.fixed_point() {
            add(&mut points, point, vec![], vec![i as u8]);
        }
    }
    // Reflections take corners to one another and back: words of two letters fix them.
    for i in 0..if count <= MOST_MAPS_FOR_TWO_LETTERS { count } else { 0 } {
        for j in (0..count).filter(|&j| j != i) {
            if let Some(point) = (maps[i] * maps[j]).fixed_point() {
                add(&mut points, point, vec![], vec![i as u8, j as u8]);
            }
        }
    }
    // Two letters before the repeated ones are enough for the classical shapes; many maps get fewer.
    for _ in 0..2 {
        if points.len() * count > MOST_POINTS {
            break;
        }
        for k in 0..points.len() {
            let (point, address) = points[k].clone();
            for (i, map) in maps.iter().enumerate() {
                let head = std::iter::once(i as u8).chain(address.head.iter().copied()).collect();
                add(&mut points, map.apply(point), head, address.repeat.clone());
            }
        }
    }
    let mut holders: HashMap<[i64; 2], Vec<(usize, Address)>> = HashMap::new();
    let mut found = Vec::new();
    for (point, address) in &points {
        for (i, map) in maps.iter().enumerate() {
            let head = std::iter::once(i as u8).chain(address.head.iter().copied()).collect();
            let Some(address) = Address::new(head, address.repeat.clone()) else { continue };
            let here = holders.entry(key(map.apply(*point))).or_default();
            if here.iter().any(|(holder, _)| *holder == i) {
                continue;
            }
            found.extend(here.iter().map(|(_, other)| (other.clone(), address.clone())));
            // Of points that very many share, a few say enough.
            if here.len() < 4 {
                here.push((i, address));
            }
        }
    }
    for (a, b) in &mut found {
        if a.first() > b.first() {
            std::mem::swap(a, b);
        }
    }
    found.sort_by_key(|(a, b)| {
        (a.head.len() + b.head.len() + a.repeat.len() + b.repeat.len(), a.first(), b.first())
    });
    found
}

fn key(point: DVec2) -> [i64; 2] {
    [point.x, point.y].map(|x| (x * CELLS_PER_UNIT + 0.3719).round() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_gasket_meets_in_its_corners() {
        let gasket =
            [[0.0, 0.0], [0.5, 0.0], [0.1, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]));
        let found = corners(&gasket);
        let shown: Vec<String> =
            found.iter().take(3).map(|(a, b)| format!("{} {}", a.shown(3), b.shown(3))).collect();
        assert_eq!(shown, ["1(2) 2(1)", "1(3) 3(1)", "2(3) 3(2)"]);
    }

    #[test]
    fn singular_maps_have_points_too() {
        let segment = [[0.5, 0.0, 0.0, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0, 0.5, 0.0]].map(Affine2::from_row);
        assert!(!corners(&segment).is_empty());
        assert!(corners(&[segment[0]]).is_empty() && corners(&[]).is_empty());
    }
}
