//! The adaptive cut: the attractor as its pieces of one size.

use crate::bounds::hull2::Hull;
use crate::ifs::system::Ifs;
use crate::linear::affine::Affine2;

/// How a cut ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CutOutcome {
    /// Pieces that were visited.
    pub pieces: usize,
    /// Whether all were: `false` when the budget was spent first.
    pub complete: bool,
}

/// Visits the pieces `w_word(A)` of the attractor that are smaller than `size` (plane units) while the
/// piece one letter shorter is not: words are prolonged only where the shape is still large (Hepting,
/// Prusinkiewicz & Saupe 1990).
///
/// `visit` gets the map of the word and its first letter. At most `budget` words are looked at. The
/// pieces together are the whole attractor.
pub fn adaptive_cut(
    ifs: &Ifs,
    size: f64,
    budget: usize,
    mut visit: impl FnMut(&Affine2, usize),
) -> CutOutcome {
    let diameter = Hull::of(ifs).diameter();
    let mut open = vec![(Affine2::IDENTITY, 0)];
    let (mut seen, mut pieces) = (0, 0);
    while let Some((map, first)) = open.pop() {
        seen += 1;
        if seen > budget {
            return CutOutcome { pieces, complete: false };
        }
        // Not `<=`: a size that is NaN or 0 must not cut for ever without the budget noticing.
        if map.norm() * diameter < size || diameter == 0.0 {
            pieces += 1;
            visit(&map, first);
            continue;
        }
        let root = seen == 1;
        // The last map first, since the list is a stack.
        for (i, &letter) in ifs.maps().iter().enumerate().rev() {
            open.push((map * letter, if root { i } else { first }));
        }
    }
    CutOutcome { pieces, complete: true }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    fn gasket() -> Ifs {
        let maps =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]));
        Ifs::new(maps.to_vec()).unwrap()
    }

    #[test]
    fn the_gasket_is_cut_into_equal_pieces() {
        let mut letters = [0; 3];
        // The diameter is the root of 2: five halvings bring it below 0.05.
        let outcome = adaptive_cut(&gasket(), 0.05, 10_000, |map, first| {
            letters[first] += 1;
            assert!((map.norm() - 1.0 / 32.0).abs() < 1e-15);
        });
        assert_eq!(outcome, CutOutcome { pieces: 243, complete: true });
        assert_eq!(letters, [81; 3]);
    }

    #[test]
    fn the_budget_holds_whatever_is_asked() {
        for size in [0.0, -1.0, f64::NAN, 1e-300] {
            let outcome = adaptive_cut(&gasket(), size, 1000, |_, _| {});
            assert!(!outcome.complete);
        }
    }

    #[test]
    fn uneven_maps_give_pieces_of_even_size() {
        let maps = vec![Affine2::similitude(0.9, 0.3, DVec2::ZERO), Affine2::similitude(0.1, 0.0, DVec2::X)];
        let ifs = Ifs::new(maps).unwrap();
        let diameter = Hull::of(&ifs).diameter();
        adaptive_cut(&ifs, 0.1, 10_000, |map, _| {
            let size = map.norm() * diameter;
            assert!(size < 0.1 && size > 0.1 * 0.1 * 0.99);
        });
    }
}
