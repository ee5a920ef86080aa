//! Whether maps contract together, and coordinates in which they are seen to.

use std::collections::VecDeque;

use crate::dimension::{Dim2, Dim3, Dimension};
use crate::error::{IfsError, MAX_MAPS};
use crate::linear::affine::Affine;
use crate::linear::transform::{lifting, lowered};

/// A proof, up to rounding, that maps have an attractor: coordinates `y = to_round * x` and a finite set
/// of blocks (words) in which all of them shrink distances by `factor` or less, and of which every
/// endless word is composed.
///
/// Mostly the blocks are the maps themselves (`length` is 1). A sheared map may stretch by any factor in the Euclidean
/// norm and still contract in the long run: then an ellipse (in space an ellipsoid) is found that all maps shrink, and
/// where none is, longer blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct Contraction<D: Dimension = Dim2> {
    /// Takes the ellipse that the maps shrink to the unit disc.
    pub to_round: D::Matrix,
    /// Its inverse.
    pub from_round: D::Matrix,
    /// The largest norm of a block in round coordinates, below 1.
    pub factor: f64,
    /// The number of letters of the longest block.
    pub length: usize,
    /// The centre, in coordinates of the shape, of a disc in round coordinates that holds the attractor.
    pub centre: D::Vector,
    /// The radius of that disc, in round coordinates.
    pub radius: f64,
}

/// The same of maps of space, with a ball in the place of the disc.
pub type Contraction3 = Contraction<Dim3>;

/// Numbers beyond this make products of maps overflow.
const LARGEST_NUMBER: f64 = 1e100;
/// A word of this spectral radius or more is said not to contract.
const NEUTRAL_RADIUS: f64 = 1.0 - 1e-10;
/// Maps that shrink at least so much in some coordinates are their own blocks.
const SHRINKING_NORM: f64 = 1.0 - 1e-9;
/// What maps are to leave of 1 when they shrink in the coordinates of others: to slower ones the best are worth more
/// than the time it takes to find them.
const LEAST_ROOM: f64 = 0.1;
/// And so much of what those others leave.
const LEAST_ROOM_LEFT: f64 = 0.95;
/// How many words may be looked at before giving up, and how long they may be.
const MOST_WORDS: usize = 20_000;
const MOST_LETTERS: usize = 48;
/// Fixed points that are tried as the centre of the disc.
const MOST_CENTRES: usize = 64;

impl<D: Dimension> Contraction<D> {
    /// Finds coordinates and blocks in which the maps contract.
    ///
    /// # Errors
    /// [`IfsError::NoMaps`], [`IfsError::TooManyMaps`] and [`IfsError::NotFinite`] for lists that are
    /// none; [`IfsError::NoAttractor`] when some word does not contract; [`IfsError::Unproved`] when
    /// neither could be shown.
    #[inline(never)]
    pub fn find(maps: &[Affine<D>]) -> Result<Self, IfsError> {
        check(maps)?;
        let plain = [D::IDENTITY; 2];
        let factor = worst_norm(maps, plain);
        if factor < 0.95 {
            return Self::with_blocks(maps, plain, factor, 1).ok_or(IfsError::Unproved);
        }
        // Single maps first: they settle most bad cases at once.
        let radii: Vec<f64> = maps.iter().map(|map| map.spectral_radius()).collect();
        if let Some(map) = radii.iter().position(|&radius| radius >= NEUTRAL_RADIUS) {
            return Err(no_attractor(&[map], radii[map]));
        }
        let linear: Vec<D::Matrix> = maps.iter().map(|map| map.linear).collect();
        let round = D::rounding(&linear, factor, radii.into_iter().fold(0.0, f64::max));
        let factor = worst_norm(maps, round);
        if factor < SHRINKING_NORM {
            return Self::with_blocks(maps, round, factor, 1).ok_or(IfsError::Unproved);
        }
        Self::search(maps, round)
    }

    /// The same in coordinates in which `other` maps contract, such as are much like these: `None` where these do not
    /// contract there map by map, and about as fast.
    #[must_use]
    pub fn in_coordinates_of(other: &Self, maps: &[Affine<D>]) -> Option<Self> {
        let round = [other.to_round, other.from_round];
        check(maps).ok()?;
        let factor = worst_norm(maps, round);
        // NaN is refused, too.
        let room = 1.0 - factor;
        let fast = room >= LEAST_ROOM && room >= LEAST_ROOM_LEFT * (1.0 - other.factor);
        if other.length == 1 && fast { Self::with_blocks(maps, round, factor, 1) } else { None }
    }

    /// What [`Contraction::find`] says of maps that differ from those it was found for in their translations alone, at
    /// once: `None` where the blocks are words, which are not kept.
    #[must_use]
    pub fn moved(&self, maps: &[Affine<D>]) -> Option<Self> {
        check(maps).ok()?;
        if self.length != 1 {
            return None;
        }
        Self::with_blocks(maps, [self.to_round, self.from_round], self.factor, 1)
    }

    /// `None` where no disc is known to hold the attractor: products of large numbers overflowed.
    fn with_blocks(
        blocks: &[Affine<D>],
        [to_round, from_round]: [D::Matrix; 2],
        factor: f64,
        length: usize,
    ) -> Option<Self> {
        let mut this = Self { to_round, from_round, factor, length, centre: D::ZERO, radius: 0.0 };
        this.enclose(blocks);
        (this.radius.is_finite() && Affine::<D>::moving(this.centre).is_finite()).then_some(this)
    }

    /// Gripenberg's search: a word is prolonged until its norm is below 1.
    #[inline(never)]
    fn search(maps: &[Affine<D>], [to, from]: [D::Matrix; 2]) -> Result<Self, IfsError> {
        let norms: Vec<f64> = maps.iter().map(|map| D::norm(map.linear)).collect();
        let mut open = VecDeque::from([(Affine::IDENTITY, 1.0, 0.0, Vec::new())]);
        let mut blocks = Vec::new();
        let (mut factor, mut length, mut seen) = (0.0_f64, 1, 0);
        // Breadth first, so that short words that do not contract are met before long ones.
        while let Some((prefix, area, off, word)) = open.pop_front() {
            for (i, &map) in maps.iter().enumerate() {
                seen += 1;
                if seen > MOST_WORDS || word.len() >= MOST_LETTERS {
                    return Err(IfsError::Unproved);
                }
                let block = prefix * map;
                let mut letters: Vec<usize> = word.clone();
                letters.push(i);
                let norm = D::norm(to * block.linear * from);
                if norm < 0.99 {
                    factor = factor.max(norm);
                    length = length.max(letters.len());
                    blocks.push(block);
                    continue;
                }
                // Products of flat maps cancel most digits: that of determinants has all of them.
                let area = area * D::full_determinant(map.linear);
                let off = (off + 8.0 * f64::EPSILON * D::norm(prefix.linear)) * norms[i];
                let radius = D::certain_radius(block.linear, area, off);
                if radius >= NEUTRAL_RADIUS {
                    return Err(no_attractor(&letters, radius));
                }
                open.push_back((block, area, off, letters));
            }
        }
        Self::with_blocks(&blocks, [to, from], factor, length).ok_or(IfsError::Unproved)
    }

    /// A disc that every block maps into itself. It holds the attractor of the blocks, which is that of the maps.
    ///
    /// Its centre is the mean of the fixed points, or one of them where that makes it much smaller: a map that turns
    /// and hardly shrinks swings everything but its own fixed point far about.
    #[inline(never)]
    fn enclose(&mut self, blocks: &[Affine<D>]) {
        let size = |block: &Affine<D>| D::size(block.translation);
        let lift = lifting(blocks.iter().map(size).fold(0.0, f64::max));
        let lifted = |block: &Affine<D>| Affine::new(block.linear, block.translation * lift);
        let blocks: Vec<Affine<D>> = blocks.iter().map(lifted).collect();
        let fixed: Vec<D::Vector> = blocks.iter().filter_map(|block| block.fixed_point()).collect();
        let norms: Vec<f64> =
            blocks.iter().map(|block| D::norm(self.to_round * block.linear * self.from_round)).collect();
        let radius = |centre: D::Vector| {
            let reach = |(block, norm): (&Affine<D>, &f64)| {
                let shift = D::length(self.to_round * (block.apply(centre) - centre));
                // Rounded up, but not above what is known of all blocks.
                shift / (1.0 - (norm * (1.0 + D::NORM_ERROR)).min(self.factor))
            };
            // Where a number overflowed nothing is known: NaN must not be passed over.
            let farther =
                |most: f64, reach: f64| if reach.is_nan() { f64::INFINITY } else { most.max(reach) };
            blocks.iter().zip(&norms).map(reach).fold(0.0, farther)
        };
        let mean = fixed.iter().sum::<D::Vector>() / fixed.len().max(1) as f64;
        let mut best = (mean, radius(mean));
        for &centre in fixed.iter().take(MOST_CENTRES) {
            let tried = radius(centre);
            if tried < 0.5 * best.1 {
                best = (centre, tried);
            }
        }
        (self.centre, self.radius) = (best.0 * (1.0 / lift), lowered(best.1 * (1.0 + 1e-12), lift));
    }
}

fn check<D: Dimension>(maps: &[Affine<D>]) -> Result<(), IfsError> {
    if maps.is_empty() {
        return Err(IfsError::NoMaps);
    }
    if maps.len() > MAX_MAPS {
        return Err(IfsError::TooManyMaps { count: maps.len() });
    }
    let fits = |map: &Affine<D>| map.to_row().as_ref().iter().all(|x| x.abs() < LARGEST_NUMBER);
    match maps.iter().position(|map| !fits(map)) {
        Some(map) => Err(IfsError::NotFinite { map }),
        None => Ok(()),
    }
}

fn no_attractor(word: &[usize], factor: f64) -> IfsError {
    let word = word.iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(".");
    IfsError::NoAttractor { word, factor }
}

fn worst_norm<D: Dimension>(maps: &[Affine<D>], [to, from]: [D::Matrix; 2]) -> f64 {
    maps.iter().map(|map| D::norm(to * map.linear * from)).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use glam::{DMat2, DVec2};

    use super::*;
    use crate::Affine2;
    use crate::linear::svd2::singular_values;

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
        // One eigenvalue, 1/4, and one eigenvector: the thinner the ellipse, the nearer is the factor to 1/4, without
        // end.
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

    /// Two to four similitudes, mirrored or not, seen in the coordinates that `by` takes to the plane.
    fn similitudes(roll: &mut impl FnMut() -> f64, exact: bool, by: Affine2) -> Vec<Affine2> {
        let count = 2 + (3.0 * roll()) as usize;
        let mut map = || {
            let (angle, ratio) = (6.3 * roll(), 0.1 + 0.8 * roll());
            let turn = match (exact, (4.0 * roll()) as usize) {
                (false, _) => DMat2::from_angle(angle) * ratio,
                (true, 0) => DMat2::IDENTITY * 0.75,
                (true, 1) => DMat2::from_cols(DVec2::Y, -DVec2::X) * 0.75,
                (true, 2) => DMat2::IDENTITY * 0.5,
                (true, _) => DMat2::from_cols(DVec2::Y, -DVec2::X) * 0.25,
            };
            let mirror = DMat2::from_diagonal(DVec2::new(1.0, if roll() < 0.7 { -1.0 } else { 1.0 }));
            Affine2::new(turn * mirror, DVec2::new(roll(), roll())).conjugate(by).unwrap()
        };
        (0..count).map(|_| map()).collect()
    }

    #[test]
    fn mirrored_similitudes_seen_in_any_shear_are_not_said_to_have_no_attractor() {
        let mut seed = 1_u64;
        let mut roll = move || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (seed >> 33) as f64 / (1_u64 << 31) as f64
        };
        for round in 0..600 {
            // Without rounding where the shear is a power of two; turned, its square loses as many digits twice.
            let exact = round % 2 == 0;
            let shear = if exact { 2.0_f64.powi(round % 24) } else { 10.0_f64.powf(3.4 * roll()) };
            let turn = if exact { 0.0 } else { 6.3 * roll() };
            let by = Affine2::similitude(1.0, turn, DVec2::ZERO)
                * Affine2::from_row([1.0, shear, 0.0, 1.0, 0.0, 0.0]);
            let maps = similitudes(&mut roll, exact, by);
            let found = Contraction::find(&maps);
            let context = || format!("{round}: shear {shear}, {found:?}, {maps:?}");
            assert!(matches!(found, Ok(_) | Err(IfsError::Unproved)), "{}", context());
            assert!(found.is_ok() || shear > 900.0, "{}", context());
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
        assert_eq!(Contraction::<Dim2>::find(&[]), Err(IfsError::NoMaps));
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
