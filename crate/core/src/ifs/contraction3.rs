//! Whether maps of space contract together, and coordinates in which they are seen to.

use glam::{DMat3, DVec3};

use crate::error::{IfsError, MAX_MAPS};
use crate::hash;
use crate::linear::affine3::Affine3;
use crate::linear::svd3::{norm3, spectral_radius3};

/// A proof, up to rounding, that maps of space have an attractor: coordinates `y = to_round * x` and a finite set
/// of blocks (words) in which all of them shrink distances by `factor` or less, and of which every endless word is
/// composed.
///
/// Mostly the blocks are the maps themselves (`length` is 1): in the Euclidean norm, or in that of an ellipsoid which
/// all maps shrink. Where none is found, the blocks are longer.
#[derive(Clone, Debug, PartialEq)]
pub struct Contraction3 {
    /// Takes the ellipsoid that the maps shrink to the unit ball.
    pub to_round: DMat3,
    /// Its inverse.
    pub from_round: DMat3,
    /// The largest norm of a block in round coordinates, below 1.
    pub factor: f64,
    /// The number of letters of the longest block.
    pub length: usize,
    /// The centre, in space, of a ball in round coordinates that holds the attractor.
    pub centre: DVec3,
    /// The radius of that ball, in round coordinates.
    pub radius: f64,
}

/// Numbers beyond this make products of maps overflow.
const LARGEST: f64 = 1e100;
/// A word of this spectral radius or more is said not to contract.
const NEUTRAL: f64 = 1.0 - 1e-10;
/// How many words may be looked at before giving up, and how long they may be.
const WORDS: usize = 20_000;
const LETTERS: usize = 48;
/// Fixed points that are tried as the centre of the ball.
const MOST_CENTRES: usize = 64;

impl Contraction3 {
    /// Finds coordinates and blocks in which the maps contract.
    ///
    /// # Errors
    /// [`IfsError::NoMaps`], [`IfsError::TooManyMaps`] and [`IfsError::NotFinite`] for lists that are
    /// none; [`IfsError::NoAttractor`] when some word does not contract; [`IfsError::Unproved`] when
    /// neither could be shown.
    pub fn find(maps: &[Affine3]) -> Result<Self, IfsError> {
        check(maps)?;
        let plain = Ellipsoid::BALL.factor(maps);
        if plain < 0.95 {
            return Ok(Self::with_blocks(maps, &Ellipsoid::BALL, plain, 1));
        }
        // Single maps first: they settle most bad cases at once.
        let radii: Vec<f64> = maps.iter().map(|map| spectral_radius3(map.linear)).collect();
        if let Some(map) = radii.iter().position(|&radius| radius >= NEUTRAL) {
            return Err(no_attractor(&[map], radii[map]));
        }
        let least = radii.iter().copied().fold(0.0, f64::max);
        let found = Ellipsoid::best(maps, least);
        let factor = found.factor(maps);
        // Only for a gain that shows: the ball has no rounding errors of its own.
        if 1.0 - factor > 1.5 * (1.0 - plain) && factor < 1.0 - 1e-9 {
            return Ok(Self::with_blocks(maps, &found, factor, 1));
        }
        if plain < 1.0 - 1e-9 {
            return Ok(Self::with_blocks(maps, &Ellipsoid::BALL, plain, 1));
        }
        Self::search(maps, &found)
    }

    fn with_blocks(blocks: &[Affine3], ellipsoid: &Ellipsoid, factor: f64, length: usize) -> Self {
        let Ellipsoid { to, from } = *ellipsoid;
        let mut this =
            Self { to_round: to, from_round: from, factor, length, centre: DVec3::ZERO, radius: 0.0 };
        this.enclose(blocks);
        this
    }

    /// Gripenberg's search: a word is prolonged until its norm is below 1.
    fn search(maps: &[Affine3], ellipsoid: &Ellipsoid) -> Result<Self, IfsError> {
        let mut open = std::collections::VecDeque::from([(Affine3::IDENTITY, Vec::new())]);
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
                let norm = ellipsoid.norm(block);
                if norm < 0.99 {
                    factor = factor.max(norm);
                    length = length.max(letters.len());
                    blocks.push(block);
                    continue;
                }
                let radius = spectral_radius3(block.linear);
                if radius >= NEUTRAL {
                    return Err(no_attractor(&letters, radius));
                }
                open.push_back((block, letters));
            }
        }
        Ok(Self::with_blocks(&blocks, ellipsoid, factor, length))
    }

    /// A ball that every block maps into itself: it holds the attractor of the blocks, which is that of the maps. Its
    /// centre is the mean of the fixed points, or one of them where that makes it much smaller.
    fn enclose(&mut self, blocks: &[Affine3]) {
        let ellipsoid = Ellipsoid { to: self.to_round, from: self.from_round };
        let fixed: Vec<DVec3> = blocks.iter().filter_map(|block| block.fixed_point()).collect();
        let norms: Vec<f64> = blocks.iter().map(|&block| ellipsoid.norm(block)).collect();
        let radius = |centre: DVec3| {
            let reach = |(block, norm): (&Affine3, &f64)| {
                let shift = (self.to_round * (block.apply(centre) - centre)).length();
                // Rounded up, but not above what is known of all blocks.
                shift / (1.0 - (norm * (1.0 + 1e-13)).min(self.factor))
            };
            blocks.iter().zip(&norms).map(reach).fold(0.0, f64::max)
        };
        let mean = fixed.iter().sum::<DVec3>() / blocks.len() as f64;
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

fn check(maps: &[Affine3]) -> Result<(), IfsError> {
    if maps.is_empty() {
        return Err(IfsError::NoMaps);
    }
    if maps.len() > MAX_MAPS {
        return Err(IfsError::TooManyMaps { count: maps.len() });
    }
    let fits = |map: &Affine3| map.to_row().iter().all(|x| x.abs() < LARGEST);
    match maps.iter().position(|map| !fits(map)) {
        Some(map) => Err(IfsError::NotFinite { map }),
        None => Ok(()),
    }
}

fn no_attractor(word: &[usize], factor: f64) -> IfsError {
    let word = word.iter().map(|i| (i + 1).to_string()).collect::<Vec<_>>().join(".");
    IfsError::NoAttractor { word, factor }
}

/// Coordinates in which an ellipsoid is the unit ball, and back.
#[derive(Clone, Copy, Debug)]
struct Ellipsoid {
    to: DMat3,
    from: DMat3,
}

/// Rounds of weighing the maps, and of trying nearby ellipsoids.
const WEIGHINGS: usize = 60;
const TRIES: u32 = 1500;

impl Ellipsoid {
    const BALL: Self = Self { to: DMat3::IDENTITY, from: DMat3::IDENTITY };

    fn norm(&self, map: Affine3) -> f64 {
        norm3(self.to * map.linear * self.from)
    }

    fn factor(&self, maps: &[Affine3]) -> f64 {
        maps.iter().map(|&map| self.norm(map)).fold(0.0, f64::max)
    }

    /// The ellipsoid `x . P x = 1`; `None` where `P` is not definite enough.
    fn of(p: DMat3) -> Option<Self> {
        // Cholesky: P = R^T R, R upper triangular.
        let a = p.x_axis.x.sqrt();
        let (b, c) = (p.y_axis.x / a, p.z_axis.x / a);
        let d = (p.y_axis.y - b * b).sqrt();
        let e = (p.z_axis.y - b * c) / d;
        let f = (p.z_axis.z - c * c - e * e).sqrt();
        let to = DMat3::from_cols(DVec3::new(a, 0.0, 0.0), DVec3::new(b, d, 0.0), DVec3::new(c, e, f));
        let from = to.inverse();
        let fits = to.is_finite() && from.is_finite() && a.min(d).min(f) > 1e-7 * a.max(d).max(f);
        fits.then_some(Self { to, from })
    }

    /// An ellipsoid whose largest shrunk image is about as small as can be; `least` is a bound that none goes below.
    ///
    /// First `P` is a weighted sum of the images of itself under `P -> M^T P M / f^2`, as in Lyapunov's equation, with more
    /// weight on maps that stretch more. What comes of it is improved by random steps, which need no derivative where
    /// the largest of many norms has none.
    fn best(maps: &[Affine3], least: f64) -> Self {
        let mut best = (Self::BALL.factor(maps), Self::BALL);
        for slack in [1.02, 1.2, 2.0] {
            let scale = 1.0 / (slack * least.max(1e-3)).powi(2);
            let mut weights = vec![1.0 / maps.len() as f64; maps.len()];
            let mut p = DMat3::IDENTITY;
            for round in 0..WEIGHINGS {
                let mut next = DMat3::IDENTITY * 1e-3;
                for (map, weight) in maps.iter().zip(&weights) {
                    next += map.linear.transpose() * p * map.linear * (weight * scale);
                }
                let size = (next.x_axis.x + next.y_axis.y + next.z_axis.z) / 3.0;
                p = p * 0.3 + next * (0.7 / size);
                let Some(tried) = Self::of(p) else { break };
                let norms: Vec<f64> = maps.iter().map(|&map| tried.norm(map)).collect();
                let factor = norms.iter().copied().fold(0.0, f64::max);
                if factor < best.0 {
                    best = (factor, tried);
                }
                let keen = 2.0 + round as f64 / 4.0;
                let raised: Vec<f64> =
                    norms.iter().zip(&weights).map(|(n, w)| w.sqrt() * (n / factor).powf(keen)).collect();
                let sum: f64 = raised.iter().sum();
                weights = raised.iter().map(|w| w / sum + 1e-4).collect();
            }
        }
        // Steps in the six numbers of the triangle, in coordinates where the best so far is round.
        let mut reach = 0.5_f64;
        for i in 0..TRIES {
            if best.0 <= least * (1.0 + 1e-6) || best.0 < 0.9 || reach < 1e-7 {
                break;
            }
            let random = |k: u32| {
                let u = |j| f64::from(hash::unit(hash::counter(17, 24 * i + 4 * k + j)));
                u(0) + u(1) + u(2) + u(3) - 2.0
            };
            let step = DMat3::from_cols(
                DVec3::new((reach * random(0)).exp(), 0.0, 0.0),
                DVec3::new(reach * random(1), (reach * random(2)).exp(), 0.0),
                DVec3::new(reach * random(3), reach * random(4), (reach * random(5)).exp()),
            );
            let to = step * best.1.to;
            let tried = Self { to, from: to.inverse() };
            let factor = tried.factor(maps);
            let thin = norm3(to) * norm3(tried.from) > 1e7;
            if factor < best.0 && !thin {
                best = (factor, tried);
                reach = (reach * 1.5).min(0.5);
            } else {
                reach *= 0.985;
            }
        }
        best.1
    }
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;

    fn similitude(scale: f64, axis: DVec3, angle: f64, at: DVec3) -> Affine3 {
        Affine3::similitude(scale, DQuat::from_axis_angle(axis.normalize(), angle), at)
    }

    fn holds(found: &Contraction3, maps: &[Affine3]) {
        // The ball holds the fixed points of all maps and of all words of two letters.
        let words = maps.iter().flat_map(|&a| maps.iter().map(move |&b| a * b)).chain(maps.iter().copied());
        for word in words {
            let fixed = word.fixed_point().unwrap();
            let away = (found.to_round * (fixed - found.centre)).length();
            assert!(away <= found.radius * (1.0 + 1e-9), "{away} {}", found.radius);
        }
    }

    #[test]
    fn plain_contractions_need_no_other_coordinates() {
        let maps = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z].map(|t| similitude(0.5, DVec3::X, 0.0, t));
        let found = Contraction3::find(&maps).unwrap();
        assert_eq!((found.factor, found.length, found.to_round), (0.5, 1, DMat3::IDENTITY));
        holds(&found, &maps);
    }

    #[test]
    fn sheared_maps_of_a_large_norm_contract_in_an_ellipsoid() {
        let shear = Affine3::shear([40.0, 5.0, 0.0, 20.0, 0.0, 0.0]);
        let axes = [DVec3::X, DVec3::new(1.0, 1.0, 0.3), DVec3::Z, DVec3::new(0.2, 1.0, -1.0)];
        let maps = axes.map(|axis| similitude(0.6, axis, 2.0, axis).conjugate(shear).unwrap());
        assert!(maps.iter().any(|map| norm3(map.linear) > 7.0));
        let found = Contraction3::find(&maps).unwrap();
        assert_eq!(found.length, 1);
        assert!(found.factor < 0.95, "{}", found.factor);
        holds(&found, &maps);
    }

    #[test]
    fn contractive_only_in_longer_words() {
        let a = Affine3::from_row([0.0, 1.2, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([0.0, 0.0, 0.0, 0.6, 0.0, 0.0, 0.0, 0.0, 0.3, 1.0, 1.0, 0.0]);
        let found = Contraction3::find(&[a, b]).unwrap();
        assert!(found.factor < 1.0 && found.radius.is_finite());
        // a b has the spectral radius (0.65 golden ratio)^2 = 1.106.
        let k = 0.65;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        let error = Contraction3::find(&[a, b]).unwrap_err();
        assert_eq!(error.code(), "no-attractor", "{error}");
        let k = 0.6;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        assert!(Contraction3::find(&[a, b]).unwrap().factor < 1.0);
    }

    #[test]
    fn a_short_word_that_does_not_contract_is_met_before_long_ones_are_followed() {
        let k = 0.65;
        let a = Affine3::from_row([k, k, 0.0, 0.0, k, 0.0, 0.0, 0.0, k, 0.0, 0.0, 0.0]);
        let b = Affine3::from_row([k, 0.0, 0.0, k, k, 0.0, 0.0, 0.0, k, 1.0, 0.0, 0.0]);
        let slow = similitude(0.9999, DVec3::X, 0.0, DVec3::Y);
        for maps in [[a, slow, b], [slow, a, b], [a, b, slow]] {
            let error = Contraction3::find(&maps).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{error}");
        }
    }

    #[test]
    fn expanding_and_neutral_maps_are_refused() {
        for map in [
            similitude(1.0, DVec3::X, 0.0, DVec3::X),
            similitude(1.0, DVec3::ONE, 1.0, DVec3::X),
            Affine3::scaling(DVec3::new(0.5, 0.5, 1.5)),
        ] {
            let error = Contraction3::find(&[map, similitude(0.5, DVec3::X, 0.0, DVec3::Y)]).unwrap_err();
            assert_eq!(error.code(), "no-attractor", "{error}");
        }
    }

    #[test]
    fn bad_lists_are_refused() {
        assert_eq!(Contraction3::find(&[]), Err(IfsError::NoMaps));
        let half = similitude(0.5, DVec3::X, 0.0, DVec3::Y);
        assert_eq!(
            Contraction3::find(&vec![half; 1_000_000]),
            Err(IfsError::TooManyMaps { count: 1_000_000 })
        );
        for bad in [f64::NAN, f64::INFINITY, 1e200] {
            let maps = [half, Affine3::moving(DVec3::splat(bad))];
            assert_eq!(Contraction3::find(&maps), Err(IfsError::NotFinite { map: 1 }));
        }
        let point = Affine3::new(DMat3::ZERO, DVec3::new(1.0, 2.0, 3.0));
        let found = Contraction3::find(&[point]).unwrap();
        assert_eq!((found.centre, found.radius), (DVec3::new(1.0, 2.0, 3.0), 0.0));
    }
}
