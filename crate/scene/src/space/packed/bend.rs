//! Lattices of a space in a link.

use std::fmt::Write as _;

use frond_deform::{Mesh3, Spin};

use super::words::exactly;
use crate::link::words::numbers;
use crate::space::bend::SpaceBend;

/// In the order of their numbers in links.
pub(super) const SPINS: [Spin; 4] = [Spin::None, Spin::Orthogonal, Spin::Rotation, Spin::Scaled];

pub(super) fn write_bend(word: &mut String, bend: &SpaceBend) {
    let [x, y, z] = bend.sizes;
    let spin = SPINS.iter().position(|spin| *spin == bend.spin).unwrap_or(0);
    let _ = write!(word, "~b{x},{y},{z},{},{spin}", numbers(&[bend.kb, bend.ke, bend.delta]));
    write_moves(word, &bend.moves);
}

/// The control points that are moved.
pub(super) fn write_moves(word: &mut String, moves: &[[f64; 3]]) {
    for (index, by) in moves.iter().enumerate().filter(|(_, by)| **by != [0.0; 3]) {
        let _ = write!(word, ";{index},{}", numbers(by));
    }
}

pub(super) fn read_bend(text: &str) -> Option<SpaceBend> {
    let mut parts = text.split(';');
    let mut settings = parts.next()?.split(',');
    let mut size =
        || settings.next()?.parse::<usize>().ok().filter(|size| (2..=Mesh3::LARGEST).contains(size));
    let sizes = [size()?, size()?, size()?];
    let mut number = || settings.next()?.parse::<f64>().ok();
    let [kb, ke, delta] = [number()?, number()?, number()?];
    let spin = *SPINS.get(settings.next()?.parse::<usize>().ok()?)?;
    let moves = moves_of(sizes.iter().product(), parts)?;
    Some(SpaceBend { sizes, moves, kb, ke, delta, spin })
}

/// The moves of as many control points as are told first.
pub(super) fn read_moves(text: &str) -> Option<Vec<[f64; 3]>> {
    let mut parts = text.split(';');
    let count = parts.next()?.parse::<usize>().ok().filter(|&count| count <= Mesh3::LARGEST.pow(3))?;
    moves_of(count, parts)
}

fn moves_of<'a>(count: usize, parts: impl Iterator<Item = &'a str>) -> Option<Vec<[f64; 3]>> {
    let mut moves = vec![[0.0; 3]; count];
    for part in parts {
        let (index, by) = part.split_once(',')?;
        *moves.get_mut(index.parse::<usize>().ok()?)? = exactly(by)?;
    }
    Some(moves)
}
