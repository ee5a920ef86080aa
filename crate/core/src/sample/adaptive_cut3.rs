//! The adaptive cut in space: pieces of one size, to place copies of one cloud of points by.

use std::collections::VecDeque;

use crate::ifs::system::Ifs3;
use crate::linear::affine::Affine3;
use crate::sample::adaptive_cut2::CutOutcome;

/// Visits pieces `w_word(A)` of the attractor that together are all of it: a word is prolonged while its map stretches
/// by `size` or more, the shorter ones first, as long as no more than `most` pieces come of it (Hepting, Prusinkiewicz
/// & Saupe 1990). `size` is that of the pieces, relative to the attractor.
///
/// `visit` gets the map of the word and its first letter. A renderer that has one cloud of points of the attractor
/// draws it once for each piece, moved by this map: close to the eye that shows `most` times as many points. Where
/// `most` is reached first the outcome says so; the pieces are the whole attractor all the same.
pub fn adaptive_cut3(
    ifs: &Ifs3,
    size: f64,
    most: usize,
    mut visit: impl FnMut(&Affine3, usize),
) -> CutOutcome {
    let mut open = VecDeque::from([(Affine3::IDENTITY, 0, true)]);
    let (mut pieces, mut complete) = (0, true);
    // Breadth first: words of one length are of about one size.
    while let Some((map, first, root)) = open.pop_front() {
        let small = map.norm() < size;
        let room = pieces + open.len() + ifs.len() <= most;
        if small || !room {
            complete &= small;
            pieces += 1;
            visit(&map, first);
            continue;
        }
        open.extend(
            ifs.maps()
                .iter()
                .enumerate()
                .map(|(i, &letter)| (map * letter, if root { i } else { first }, false)),
        );
    }
    CutOutcome { pieces, complete }
}

#[cfg(test)]
mod tests {
    use glam::{DQuat, DVec3};

    use super::*;

    fn tetrahedron() -> Ifs3 {
        let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
        Ifs3::new(corners.map(|c| Affine3::similitude(0.5, DQuat::IDENTITY, c * 0.5)).to_vec()).unwrap()
    }

    #[test]
    fn the_tetrahedron_is_cut_into_equal_pieces() {
        let mut letters = [0; 4];
        // Four halvings bring it below 0.07.
        let outcome = adaptive_cut3(&tetrahedron(), 0.07, 1000, |map, first| {
            letters[first] += 1;
            assert!((map.norm() - 1.0 / 16.0).abs() < 1e-12);
        });
        assert_eq!(outcome, CutOutcome { pieces: 256, complete: true });
        assert_eq!(letters, [64; 4]);
    }

    #[test]
    fn no_more_pieces_than_asked_and_they_are_still_all_of_it() {
        for size in [0.0, -1.0, f64::NAN, 1e-300] {
            let mut weight = 0.0;
            let outcome = adaptive_cut3(&tetrahedron(), size, 500, |map, _| weight += map.norm().powi(2));
            assert!(!outcome.complete && outcome.pieces <= 500 && outcome.pieces > 490, "{outcome:?}");
            // Each split keeps the sum of the squares of four halves.
            assert!((weight - 1.0).abs() < 1e-9);
        }
        assert_eq!(adaptive_cut3(&tetrahedron(), 0.0, 0, |_, _| {}).pieces, 1);
    }
}
