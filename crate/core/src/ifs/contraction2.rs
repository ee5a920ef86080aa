//! Whether maps contract together, and coordinates in which they are seen to.

use std::collections::VecDeque;

use glam::{DMat2, DVec2};

use crate::error::{IfsError, MAX_MAPS};
use crate::linear::affine2::{Affine2, singular_values, spectral_radius};

/// A proof, up to rounding, that maps have an attractor: coordinates `y = to_round * x` and a finite set
/// of blocks (words) in which all of them shrink distances by `factor` or less, and of which every
/// endless word is composed.
///
/// Mostly the blocks are the maps themselves (`length` is 1). A sheared map may stretch by any factor
/// in the Euclidean norm and still contract in the long run: then an ellipse is found that all maps
/// shrink, and where none is, longer blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct Contraction {
    /// Takes the ellipse that the maps shrink to the unit disc.
    pub to_round: DMat2,
    /// Its inverse.
    pub from_round: DMat2,
    /// The largest norm of a block in round coordinates, below 1.
    pub factor: f64,
    /// The number of letters of the longest block.
    pub length: usize,
    /// The centre, in the plane, of a disc in round coordinates that holds the attractor.
    pub centre: DVec2,
    /// The radius of that disc, in round coordinates.
    pub radius: f64,
}

/// What a thin ellipse costs in the search for the best.
const ROUNDNESS: f64 = 1e-9;
/// Numbers beyond this make products of maps overflow.
const LARGEST: f64 = 1e100;
/// A word of this spectral radius or more is said not to contract.
const NEUTRAL: f64 = 1.0 - 1e-10;
/// How many words may be looked at before giving up, and how long they may be.
const WORDS: usize = 20_000;
const LETTERS: usize = 48;

impl Contraction {
    /// Finds coordinates and blocks in which the maps contract.
    ///
    /// # Errors
    /// [`IfsError::NoMaps`], [`IfsError::TooManyMaps`] and [`IfsError::NotFinite`] for lists that are
    /// none; [`IfsError::NoAttractor`] when some word does not contract; [`IfsError::Unproved`] when
    /// neither could be shown.
    pub fn find(maps: &[Affine2]) -> Result<Self, IfsError> {
        check(maps)?;
        let plain = worst_norm(maps, DMat2::IDENTITY, DMat2::IDENTITY);
        if plain < 0.95 {
            return Ok(Self::with_maps(maps, DMat2::IDENTITY, DMat2::IDENTITY, plain));
        }
        // Single maps first: they settle most bad cases at once.
        if let Some(map) = (0..maps.len()).find(|&i| maps[i].spectral_radius() >= NEUTRAL) {
            return Err(no_attractor(&[map], maps[map].spectral_radius()));
        }
        let (to_round, from_round, factor) = best_ellipse(maps, plain);
        if factor < 1.0 - 1e-9 {
            return Ok(Self::with_maps(maps, to_round, from_round, factor));
        }
        Self::with_blocks(maps, to_round, from_round)
    }

    fn with_maps(maps: &[Affine2], to_round: DMat2, from_round: DMat2, factor: f64) -> Self {
        let mut this = Self { to_round, from_round, factor, length: 1, centre: DVec2::ZERO, radius: 0.0 };
        this.enclose(maps);
        this
    }

    /// Gripenberg's search: a word is prolonged until its norm is below 1.
    fn with_blocks(maps: &[Affine2], to_round: DMat2, from_round: DMat2) -> Result<Self, IfsError> {
        let mut open = VecDeque::from([(Affine2::IDENTITY, Vec::new())]);
        let mut blocks = Vec::new();
        let (mut factor, mut length, mut seen) = (0.0_f64, 1, 0);
        // Breadth first, so that short words that do not contract are met before long ones.
        while let Some((prefix, word)) = open.pop_front() {
            for (i, &map) in maps.iter().enumerate() {
                seen += 1;
                if seen > WORDS || word.len() >= LETTERS {
                    return Err(IfsError::Unproved);
                }
                let block = prefix * map;
                let mut letters: Vec<usize> = word.clone();
                letters.push(i);
                let norm = singular_values(to_round * block.linear * from_round).0;
                if norm < 0.99 {
                    factor = factor.max(norm);
                    length = length.max(letters.len());
                    blocks.push(block);
                    continue;
                }
                let radius = block.spectral_radius();
                if radius >= NEUTRAL {
                    return Err(no_attractor(&letters, radius));
                }
                open.push_back((block, letters));
            }
        }
        let mut this = Self { to_round, from_round, factor, length, centre: DVec2::ZERO, radius: 0.0 };
        this.enclose(&blocks);
        Ok(this)
    }

    /// A disc that every block maps into itself. It holds the attractor of the blocks, which is that of the maps.
    ///
    /// Its centre is the mean of the fixed points, or one of them where that makes it much smaller: a map that turns
    /// and hardly shrinks swings everything but its own fixed point far about.
    fn enclose(&mut self, blocks: &[Affine2]) {
        let fixed: Vec<DVec2> = blocks.iter().filter_map(|block| block.fixed_point()).collect();
        let norms: Vec<f64> = blocks
            .iter()
            .map(|block| singular_values(self.to_round * block.linear * self.from_round).0)
            .collect();
        let radius = |centre: DVec2| {
            let reach = |(block, norm): (&Affine2, &f64)| {
                let shift = (self.to_round * (block.apply(centre) - centre)).length();
                // Rounded up, but not above what is known of all blocks.
                shift / (1.0 - (norm * (1.0 + 1e-14)).min(self.factor))
            };
            blocks.iter().zip(&norms).map(reach).fold(0.0, f64::max)
        };
        let mean = fixed.iter().sum::<DVec2>() / blocks.len() as f64;
        let mut best = (mean, radius(mean));
        for &centre in fixed.iter().take(MOST_CENTRES) {
            let tried = radius(centre);
            if tried < 0.5 * best.1 {
                best = (centre, tried);
            }
        }
        (self.centre, self.radius) = (best.0, best.1 * (1.0 + 1e-12));
    }
}

/// Fixed points that are tried as the centre of the disc.
const MOST_CENTRES: usize = 64;

fn check(maps: &[Affine2]) -> Result<(), IfsError> {
    if maps.is_empty() {
        return Err(IfsError::NoMaps);
    }
    if maps.len() > MAX_MAPS {
        return Err(IfsError::TooManyMaps { count: maps.len() });
    }
    let fits = |map: &Affine2| map.to_row().iter().all(|x| x.abs() < LARGEST);
    match maps.iter().position(|map| !fits(map)) {
        Some(map) => Err(IfsError::NotFinite { map }),
        None => Ok(()),
    }
}

fn no_attractor(word: &[usize], factor: f64) -> IfsError {
    let word = word.iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(".");
    IfsError::NoAttractor { word, factor }
}

fn worst_norm(maps: &[Affine2], to: DMat2, from: DMat2) -> f64 {
    maps.iter().map(|map| singular_values(to * map.linear * from).0).fold(0.0, f64::max)
}

/// The ellipse `x^2 + 2 p x y + (p^2 + q^2) y^2 = 1` as coordinates that make it round, and back.
fn coordinates(p: f64, q: f64) -> (DMat2, DMat2) {
    let to = DMat2::from_cols(DVec2::new(1.0, 0.0), DVec2::new(p, q));
    let from = DMat2::from_cols(DVec2::new(1.0, 0.0), DVec2::new(-p / q, 1.0 / q));
    (to, from)
}

/// An ellipse whose largest shrunk image is about as small as can be, with that factor: a rounder one than the best, where
/// little is lost by it.
///
/// The factor is quasi-convex in the ellipse's matrix `P` (the condition `M^T P M <= f^2 P` is linear
/// in `P`), so that a search of one number inside a search of the other finds the least.
fn best_ellipse(maps: &[Affine2], plain: f64) -> (DMat2, DMat2, f64) {
    // Where the factor is that of a map which every ellipse shrinks alike, it is level: then the roundest will
    // do, and the search must not run off to the thinnest.
    let factor = |s: f64, log_q: f64| {
        let (to, from) = coordinates(s.sinh(), log_q.exp());
        worst_norm(maps, to, from) + ROUNDNESS * (s.abs() + log_q.abs())
    };
    let best_q = |s: f64| golden(-14.0, 14.0, |log_q| factor(s, log_q));
    let (s, _) = golden(-12.0, 12.0, |s| best_q(s).1);
    let (p, q) = (s.sinh(), best_q(s).0.exp());
    let (to, from) = coordinates(p, q);
    let least = worst_norm(maps, to, from);
    // Only for a gain that shows: the circle has no rounding errors of its own.
    if 1.0 - least <= 1.5 * (1.0 - plain) {
        return (DMat2::IDENTITY, DMat2::IDENTITY, plain);
    }
    // A defective map comes nearer to its spectral radius the thinner the ellipse, without end; and whatever is
    // bounded in a thin ellipse is bounded badly in the plane.
    let price = THINNESS * (1.0 - least).abs() * log_aspect(p, q);
    let rounder = |share: f64| if share < 1.0 { rounder(p, q, share) } else { (to, from) };
    let cost = |share: f64| {
        let (to, from) = rounder(share);
        worst_norm(maps, to, from) + price * share
    };
    let (share, least) = golden(0.0, 1.0, cost);
    let (to, from) = rounder(if least < cost(1.0) { share } else { 1.0 });
    (to, from, worst_norm(maps, to, from))
}

/// What an ellipse costs that is e times as thin, in parts of what the best one shrinks.
const THINNESS: f64 = 0.1;

/// The logarithm of how many times longer than wide the ellipse is.
fn log_aspect(p: f64, q: f64) -> f64 {
    ((1.0 + p * p + q * q) / (2.0 * q)).max(1.0).acosh()
}

/// The ellipse of the same axes as that of `p` and `q`, whose aspect is raised to the power `share`: its matrix is the
/// power of that of the other, at determinant 1. The factor falls from the circle to the best ellipse, since
/// these matrices are, but for their scale, on the straight line between the two.
fn rounder(p: f64, q: f64, share: f64) -> (DMat2, DMat2) {
    let log = log_aspect(p, q);
    if log < 1e-6 {
        return coordinates(p * share, 1.0 + (q - 1.0) * share);
    }
    let of_circle = (log * (1.0 - share)).sinh() / log.sinh();
    let of_ellipse = (log * share).sinh() / log.sinh();
    let first = of_circle + of_ellipse / q;
    coordinates(of_ellipse * p / q / first, 1.0 / first)
}

/// The least value of a quasi-convex function on an interval, by the golden section.
fn golden(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> (f64, f64) {
    const RATIO: f64 = 0.618_033_988_749_894_9;
    let mut left = high - RATIO * (high - low);
    let mut right = low + RATIO * (high - low);
    let (mut at_left, mut at_right) = (f(left), f(right));
    for _ in 0..44 {
        if at_left <= at_right {
            high = right;
            (right, at_right) = (left, at_left);
            left = high - RATIO * (high - low);
            at_left = f(left);
        } else {
            low = left;
            (left, at_left) = (right, at_right);
            right = low + RATIO * (high - low);
            at_right = f(right);
        }
    }
    if at_left <= at_right { (left, at_left) } else { (right, at_right) }
}

/// The spectral radius of the product of maps along a word: below 1 for every word if there is an
/// attractor.
#[must_use]
pub fn word_radius(maps: &[Affine2], word: &[usize]) -> f64 {
    spectral_radius(word.iter().fold(DMat2::IDENTITY, |m, &i| m * maps[i].linear))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(row: [f64; 6]) -> Affine2 {
        Affine2::from_row(row)
    }

    #[test]
    fn plain_contractions_need_no_other_coordinates() {
        let gasket = [[0.5, 0.0, 0.0, 0.5, 0.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.5, 0.0]].map(map);
        let found = Contraction::find(&gasket).unwrap();
        assert_eq!((found.factor, found.length, found.to_round), (0.5, 1, DMat2::IDENTITY));
        // The disc holds both fixed points.
        for fixed in [DVec2::ZERO, DVec2::X] {
            assert!((fixed - found.centre).length() <= found.radius);
        }
    }

    #[test]
    fn sheared_maps_of_a_large_norm_contract_in_an_ellipse() {
        // The gasket in coordinates sheared by 50: the norm of each map stays 0.5 for a multiple of
        // the identity, so take turned maps.
        let shear = map([1.0, 50.0, 0.0, 1.0, 0.0, 0.0]);
        let turned = [0.0, 2.0, 4.0]
            .map(|angle| Affine2::similitude(0.5, angle, DVec2::new(angle, 1.0)).conjugate(shear).unwrap());
        assert!(turned.iter().any(|m| m.norm() > 7.0));
        let found = Contraction::find(&turned).unwrap();
        assert_eq!(found.length, 1);
        assert!(found.factor < 0.51, "{}", found.factor);
        assert!((found.from_round * found.to_round - DMat2::IDENTITY).x_axis.length() < 1e-9);
    }

    #[test]
    fn slow_maps_that_shrink_alike_everywhere_stay_in_round_coordinates() {
        let slow = [0.0, 1.0].map(|f| map([0.999_999, 0.0, 0.0, 0.999_999, 0.0, f]));
        let found = Contraction::find(&slow).unwrap();
        assert_eq!(found.to_round, DMat2::IDENTITY);
        assert!((found.radius - 5e5).abs() < 1.0, "{}", found.radius);
    }

    #[test]
    fn contractive_only_in_longer_words() {
        // Joint spectral radius 0.9 sqrt(golden ratio^..)-like pairs: no ellipse shrinks both, words do.
        let k = 0.6;
        let a = map([k, k, 0.0, k, 0.0, 0.0]);
        let b = map([k, 0.0, k, k, 1.0, 0.0]);
        // The worst word is `a b`, of spectral radius k^2 (golden ratio)^2 = 0.9425.
        let found = Contraction::find(&[a, b]).unwrap();
        assert!(found.factor < 1.0);
        let nilpotent = [map([0.0, 1.2, 0.0, 0.0, 0.0, 0.0]), map([0.0, 0.0, 0.6, 0.0, 1.0, 1.0])];
        let found = Contraction::find(&nilpotent).unwrap();
        assert!(found.factor < 1.0 && found.radius.is_finite());
    }

    #[test]
    fn a_short_word_that_does_not_contract_is_met_before_long_ones_are_followed() {
        // No ellipse shrinks the first and the last together: their product has the spectral radius 1.106. Words of the
        // one between them would have to be followed beyond all bounds.
        let k = 0.65;
        let maps = [
            map([k, k, 0.0, k, 0.0, 0.0]),
            map([0.9999, 0.0, 0.0, 0.9999, 0.0, 1.0]),
            map([k, 0.0, k, k, 1.0, 0.0]),
        ];
        let orders = [[0, 1, 2], [1, 0, 2], [0, 2, 1], [2, 1, 0], [1, 2, 0], [2, 0, 1]];
        for order in orders {
            let error = Contraction::find(&order.map(|i| maps[i])).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{order:?}: {error}");
        }
    }

    #[test]
    fn defective_maps_get_an_ellipse_that_is_round_enough() {
        let aspect = |found: &Contraction| {
            let norm = |m: DMat2| singular_values(m).0;
            norm(found.to_round) * norm(found.from_round)
        };
        // One eigenvalue, 1/4, and one eigenvector: the thinner the ellipse, the nearer is the factor to 1/4, without end.
        let row = |e: f64, f: f64| map([0.75, -1.0, 0.25, -0.25, e, f]);
        let shifts =
            [(1.0, 1.0), (4.0, -2.0), (-2.0, 2.0), (1.0, -3.0), (-2.0, 0.0), (-3.0, 1.0), (1.0, 2.0)];
        let found = Contraction::find(&shifts.map(|(e, f)| row(e, f))).unwrap();
        assert!(found.factor < 0.35 && aspect(&found) < 15.0, "{found:?}, {}", aspect(&found));
        for shear in [1.0, 1e2, 1e4] {
            let found = Contraction::find(&[map([0.5, shear, 0.0, 0.5, 0.0, 1.0])]).unwrap();
            assert!(found.factor < 0.57 && aspect(&found) < 15.0 * shear, "{found:?}, {}", aspect(&found));
        }
    }

    #[test]
    fn expanding_and_neutral_maps_are_refused_with_the_word() {
        for rows in [
            vec![[1.0, 0.0, 0.0, 1.0, 1.0, 0.0]],
            vec![[0.0, -1.0, 1.0, 0.0, 1.0, 0.0], [0.5, 0.0, 0.0, 0.5, 0.0, 0.0]],
            vec![[0.5, 0.0, 0.0, 1.5, 0.0, 0.0]],
            // Each contracts alone, their product does not.
            vec![[0.1, 3.0, 0.0, 0.1, 0.0, 0.0], [0.1, 0.0, 3.0, 0.1, 0.0, 0.0]],
        ] {
            let maps: Vec<_> = rows.into_iter().map(map).collect();
            let error = Contraction::find(&maps).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{error}");
        }
    }

    #[test]
    fn bad_lists_are_refused() {
        assert_eq!(Contraction::find(&[]), Err(IfsError::NoMaps));
        let many = vec![map([0.1, 0.0, 0.0, 0.1, 0.0, 0.0]); 1_000_000];
        assert_eq!(Contraction::find(&many), Err(IfsError::TooManyMaps { count: 1_000_000 }));
        for bad in [f64::NAN, f64::INFINITY, 1e200] {
            let maps = [map([0.5, 0.0, 0.0, 0.5, 0.0, 0.0]), map([0.5, bad, 0.0, 0.5, 0.0, 0.0])];
            assert_eq!(Contraction::find(&maps), Err(IfsError::NotFinite { map: 1 }));
        }
    }

    #[test]
    fn a_map_to_one_point_has_a_disc_of_no_size() {
        let found = Contraction::find(&[map([0.0, 0.0, 0.0, 0.0, 3.0, 4.0])]).unwrap();
        assert_eq!((found.centre, found.radius), (DVec2::new(3.0, 4.0), 0.0));
    }
}
