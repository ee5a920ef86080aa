//! Words and addresses.

use std::fmt;
use std::str::FromStr;

use glam::DVec2;

use crate::bounds::hull2::Hull;
use crate::ifs::ifs2::Ifs;
use crate::linear::affine2::Affine2;

/// A word `a1 a2 .. an` of maps: it stands for `w_a1 o w_a2 o .. o w_an`, so that the first letter names the
/// largest piece. On screen letters count from 1 and are joined by dots.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Word(pub Vec<u8>);

impl Word {
    /// The composed map. `None` if a letter names no map.
    #[must_use]
    pub fn map(&self, ifs: &Ifs) -> Option<Affine2> {
        self.0.iter().try_fold(Affine2::IDENTITY, |map, &letter| {
            ifs.maps().get(usize::from(letter)).map(|&next| map * next)
        })
    }
}

impl fmt::Display for Word {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (i, letter) in self.0.iter().enumerate() {
            if i > 0 {
                f.write_str(".")?;
            }
            write!(f, "{}", usize::from(*letter) + 1)?;
        }
        Ok(())
    }
}

impl FromStr for Word {
    type Err = std::num::ParseIntError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let letters = text.split('.').filter(|part| !part.is_empty());
        letters
            .map(|part| part.parse::<std::num::NonZeroU8>().map(|n| n.get() - 1))
            .collect::<Result<_, _>>()
            .map(Self)
    }
}

/// An address of a point: the word of `length` letters whose piece holds the point, or comes nearest to
/// it. A point where pieces meet has several; the lowest is given.
#[must_use]
pub fn address_near(ifs: &Ifs, point: DVec2, length: usize) -> Word {
    let hull = Hull::of(ifs);
    // The piece is pulled towards the disc around the hull; a few candidates are kept on the way, since
    // the nearest large piece need not hold the nearest small one.
    let mut best = vec![(0.0, Affine2::IDENTITY, Vec::new())];
    for _ in 0..length {
        let mut next: Vec<(f64, Affine2, Vec<u8>)> = Vec::new();
        for (_, prefix, word) in &best {
            for (i, &map) in ifs.maps().iter().enumerate() {
                let map = *prefix * map;
                let away = map.apply(hull.centre()).distance(point) - map.norm() * hull.radius();
                let mut letters = word.clone();
                letters.push(i as u8);
                next.push((away.max(0.0), map, letters));
            }
        }
        next.sort_by(|a, b| a.0.total_cmp(&b.0));
        next.truncate(32);
        best = next;
    }
    Word(best.swap_remove(0).2)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn gasket() -> Ifs {
        let maps =
            [[0.0, 0.0], [0.5, 0.0], [0.0, 0.5]].map(|[e, f]| Affine2::from_row([0.5, 0.0, 0.0, 0.5, e, f]));
        Ifs::new(maps.to_vec()).unwrap()
    }

    #[test]
    fn words_read_from_the_largest_piece_down() {
        let word: Word = "2.3".parse().unwrap();
        assert_eq!(word, Word(vec![1, 2]));
        assert_eq!(word.to_string(), "2.3");
        // w_2 (w_3 (0)) = w_2 (0, 1/2) = (1/2, 1/4).
        assert_eq!(word.map(&gasket()).unwrap().apply(DVec2::ZERO), DVec2::new(0.5, 0.25));
        assert_eq!(Word(vec![3]).map(&gasket()), None);
        assert!("0".parse::<Word>().is_err() && "x".parse::<Word>().is_err());
        assert_eq!("".parse::<Word>().unwrap(), Word::default());
    }

    #[test]
    fn points_find_their_addresses() {
        let ifs = gasket();
        for text in ["1.2.3.1.2.3", "3.3.3.1.1.1", "2.1.2.1.2.1"] {
            let word: Word = text.parse().unwrap();
            // A point in the middle of the piece, shared with no other.
            let inner: Word = "1.2.3.2.1.3".parse().unwrap();
            let point = word.map(&ifs).unwrap().apply(inner.map(&ifs).unwrap().apply(DVec2::new(0.3, 0.3)));
            let found = address_near(&ifs, point, 6).map(&ifs).unwrap();
            assert!((found.apply(DVec2::ZERO) - point).length() < 0.05);
        }
    }
}
