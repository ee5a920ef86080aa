//! The paper's fit of a closed outline: collage least squares (Cochran, Hart & Flynn, section 3.2).

mod factor;
mod pieces;

use glam::{DMat2, DVec2};
use thiserror::Error;

use self::factor::{bounded, clipped};
use crate::error::FunctionError;
use crate::fractal::curve::FractalCurve;
use crate::fractal::piece::{Piece, along, spectral_norm};
use crate::outline::bounds;

/// The most votes of range against domain.
const MAX_PAIRS: usize = 1 << 24;

/// How much smaller the bound is made where ends cannot be tied.
const BOUND_STEP: f64 = 0.9;

/// Which parts of the outline may be copied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Domains {
    /// Those that begin where a range begins: the fit is an RFIF.
    Recurrent,
    /// Those that begin at any feature point: the fit is a PFIF.
    Partitioned,
}

/// How factors are kept within their bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bounding {
    /// By constrained least squares: of all factors within the bound the one of the least sum.
    LeastSquares,
    /// The free optimum has its singular values cut, and b and e are solved for anew: what is often done, and never
    /// better. It is here to be compared with.
    Clipped,
}

/// How a ring of feature points is fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CollageOptions {
    /// How many maps; each covers M = points / maps intervals, and copies 2M.
    pub maps: usize,
    /// Whether x and y are copied apart from each other (eq 8) or together (eq 9).
    pub separable: bool,
    /// The bound of the factor's norm, in (0, 1).
    pub bound: f64,
    /// How it is kept.
    pub bounding: Bounding,
    /// Whether copies end where their ranges do. The paper's do not, and leave gaps.
    pub tied: bool,
    /// Which parts may be copied.
    pub domains: Domains,
}

impl Default for CollageOptions {
    fn default() -> Self {
        Self {
            maps: 29,
            separable: false,
            bound: 0.95,
            bounding: Bounding::LeastSquares,
            tied: false,
            domains: Domains::Recurrent,
        }
    }
}

/// Why a ring of points cannot be fitted so.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum CollageError {
    /// A copied part must be longer than the piece and not longer than the ring: two maps and two intervals a map.
    #[error(
        "{points} feature points are too few for {maps} maps. Take at least twice as many points as maps, and two maps."
    )]
    TooFewPoints {
        /// Feature points.
        points: usize,
        /// Maps asked for.
        maps: usize,
    },
    /// More than 2^24 pairs of a piece and a part to copy.
    #[error("{points} feature points and {maps} maps would take too long. Ask for fewer.")]
    TooMany {
        /// Feature points.
        points: usize,
        /// Maps asked for.
        maps: usize,
    },
    /// A point is not finite.
    #[error("Feature point {} is not finite. Mend it or leave it out.", .index + 1)]
    NotFinite {
        /// Index of the point.
        index: usize,
    },
    /// The bound is not between 0 and 1.
    #[error("The bound of the factors must lie between 0 and 1.")]
    BadBound,
}

impl CollageError {
    /// A name that does not change, for programs.
    #[must_use]
    pub const fn code(&self) -> &'static str {
        match self {
            Self::TooFewPoints { .. } => "too-few-points",
            Self::TooMany { .. } => "too-many",
            Self::NotFinite { .. } => "not-finite",
            Self::BadBound => "bad-bound",
        }
    }
}

/// One map of the fit: range point m (0 to M) is `offset + step * m / M + factor * (point 2m of the domain)`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RingMap {
    /// The feature point where the domain begins.
    pub start: usize,
    /// Whether the domain is run through from its other end.
    pub reversed: bool,
    /// The matrix of c's.
    pub factor: DMat2,
    /// b, for the whole range.
    pub step: DVec2,
    /// e.
    pub offset: DVec2,
}

/// The paper's fit of a ring of feature points: the first maps * M of them.
#[derive(Clone, Debug, PartialEq)]
pub struct CollageFit {
    /// The maps, in the order of their ranges.
    pub maps: Vec<RingMap>,
    /// M, the intervals of a range.
    pub intervals: usize,
    /// Whether x and y are copied apart from each other (eq 8): all factors are diagonal.
    pub separable: bool,
    /// The sum of squares of eq 15 over all ranges.
    pub collage: f64,
}

/// How many numbers a map takes: a, d, two b, two e and the factors, "eight parameters in the separable case (8) or the
/// ten parameters in the non-separable case (9)" (Cochran, Hart & Flynn, section 3.2).
#[must_use]
pub const fn numbers_per_map(separable: bool) -> usize {
    if separable { 8 } else { 10 }
}

/// Fits a ring of feature points by the collage: for each range the domain, way round and factors of least squares.
///
/// Of equals the first in the order of `start`, forwards before reversed. Points beyond maps * M are left out. Where
/// the ends of copies of any part cannot be tied under the bound, a smaller one is taken for all of them.
///
/// # Errors
/// Where there are too few or too many points, one is not finite, or the bound is not in (0, 1).
pub fn fit_collage(points: &[DVec2], options: &CollageOptions) -> Result<CollageFit, CollageError> {
    let maps = options.maps;
    let intervals = points.len().checked_div(maps).unwrap_or(0);
    if maps < 2 || intervals < 2 {
        return Err(CollageError::TooFewPoints { points: points.len(), maps });
    }
    let ring = &points[..maps * intervals];
    let step = if options.domains == Domains::Recurrent { intervals } else { 1 };
    if (ring.len() / step).saturating_mul(maps) > MAX_PAIRS {
        return Err(CollageError::TooMany { points: points.len(), maps });
    }
    if let Some(index) = ring.iter().position(|p| p.is_nan() || p.abs().max_element() > 1e100) {
        return Err(CollageError::NotFinite { index });
    }
    if !(options.bound > 0.0 && options.bound < 1.0) {
        return Err(CollageError::BadBound);
    }
    let mut options = *options;
    let mut fit = nearest(ring, intervals, &options);
    while options.tied && options.domains == Domains::Partitioned && !tie(&mut fit, ring) {
        options.bound *= BOUND_STEP;
        fit = nearest(ring, intervals, &options);
    }
    Ok(fit)
}

/// For each range of a ring the domain, way round and factors of least squares.
fn nearest(ring: &[DVec2], intervals: usize, options: &CollageOptions) -> CollageFit {
    let step = if options.domains == Domains::Recurrent { intervals } else { 1 };
    let maps = options.maps;
    let mut fit =
        CollageFit { maps: Vec::with_capacity(maps), intervals, separable: options.separable, collage: 0.0 };
    let (mut range, mut domain) = (Vec::new(), Vec::new());
    for k in 0..maps {
        range.clear();
        range.extend((0..=intervals).map(|m| ring[(k * intervals + m) % ring.len()]));
        let mut best = None;
        for start in (0..ring.len()).step_by(step) {
            for reversed in [false, true] {
                domain.clear();
                domain
                    .extend((0..=intervals).map(|m| ring[source(start, reversed, m, intervals, ring.len())]));
                // A bound makes nothing better: only where the free optimum is the best so far is it looked at.
                for bound in [f64::INFINITY, options.bound] {
                    let (factor, step, offset) = solve(&domain, &range, options, bound);
                    let squares = misfit(&domain, &range, factor, step, offset);
                    if !best.as_ref().is_none_or(|&(least, _)| squares < least) {
                        break;
                    }
                    if bound <= options.bound || spectral_norm(factor) <= options.bound {
                        best = Some((squares, RingMap { start, reversed, factor, step, offset }));
                        break;
                    }
                }
            }
        }
        if let Some((squares, map)) = best {
            fit.collage += squares;
            fit.maps.push(map);
        }
    }
    fit
}

/// Ties the ends through the attractor: where a domain ends inside a piece, the curve does not pass through the feature
/// point there, and a map that brings feature points to feature points leaves a gap.
///
/// False where that does not come to rest. With each step the way to where it would is multiplied by no more than twice
/// the largest factor, since a point of a domain moves and its chord does, too: below a half it always does, above it
/// often.
fn tie(fit: &mut CollageFit, ring: &[DVec2]) -> bool {
    let (low, high) = bounds(ring);
    let size = low.distance(high);
    let mut moved = 0.0_f64;
    for _ in 0..1000 {
        let (points, _) = fit.attractor();
        moved = 0.0;
        for (k, map) in fit.maps.iter_mut().enumerate() {
            let knot = |k: usize| ring[k * fit.intervals % ring.len()];
            let end = |m| points[source(map.start, map.reversed, m, fit.intervals, ring.len())];
            let (first, last) = (end(0), end(fit.intervals));
            let offset = knot(k) - map.factor * first;
            let step = knot(k + 1) - knot(k) - map.factor * (last - first);
            moved = moved.max(offset.distance(map.offset) + step.distance(map.step));
            (map.offset, map.step) = (offset, step);
        }
        if moved <= 1e-14 * ring[0].length() || moved.is_nan() || moved > 1e3 * size {
            break;
        }
    }
    moved <= 1e-12 * size
}

/// The ring index of sample m of a domain.
fn source(start: usize, reversed: bool, m: usize, intervals: usize, count: usize) -> usize {
    (start + 2 * if reversed { intervals - m } else { m }) % count
}

fn misfit(domain: &[DVec2], range: &[DVec2], factor: DMat2, step: DVec2, offset: DVec2) -> f64 {
    let last = (range.len() - 1) as f64;
    let place = |m: usize| offset + step * (m as f64 / last) + factor * domain[m];
    range.iter().enumerate().map(|(m, p)| place(m).distance_squared(*p)).sum()
}

/// The factor, b and e of least squares under the bound.
///
/// b and e are linear in the rest and not bounded, so both sides are first freed of what b and e can do: of their
/// regression on m, or, with tied ends, of their chords. What is left is a regression of two or of one unknown a
/// coordinate.
fn solve(domain: &[DVec2], range: &[DVec2], options: &CollageOptions, bound: f64) -> (DMat2, DVec2, DVec2) {
    let (d, r) = (line(domain, options.tied), line(range, options.tied));
    let last = (range.len() - 1) as f64;
    let freed = |(m, (p, q)): (usize, (&DVec2, &DVec2))| {
        let share = m as f64 / last;
        (*p - d.0 - d.1 * share, *q - r.0 - r.1 * share)
    };
    let pairs = domain.iter().zip(range).enumerate().map(freed);
    let factor = match options.bounding {
        // Where x and y stand apart each is a parabola: least within an interval nearest to where it is least of all.
        _ if options.separable => {
            let (square, cross) = pairs
                .fold((DVec2::ZERO, DVec2::ZERO), |(square, cross), (x, y)| (square + x * x, cross + x * y));
            let size = square.element_sum();
            let apart = |above: f64, below: f64| if below > 1e-24 * size { above / below } else { 0.0 };
            let free = DVec2::new(apart(cross.x, square.x), apart(cross.y, square.y));
            DMat2::from_diagonal(free.clamp(DVec2::splat(-bound), DVec2::splat(bound)))
        }
        Bounding::Clipped if bound.is_finite() => clipped(bounded(pairs, f64::INFINITY), bound),
        _ => bounded(pairs, bound),
    };
    (factor, r.1 - factor * d.1, r.0 - factor * d.0)
}

/// Start and step of the line through samples: of least squares, or from end to end.
fn line(samples: &[DVec2], tied: bool) -> (DVec2, DVec2) {
    let last = samples.len() - 1;
    if tied {
        return (samples[0], samples[last] - samples[0]);
    }
    let mean: DVec2 = samples.iter().sum::<DVec2>() / samples.len() as f64;
    let share = |m: usize| m as f64 / last as f64 - 0.5;
    let above: DVec2 = samples.iter().enumerate().map(|(m, &p)| (p - mean) * share(m)).sum();
    let below: f64 = (0..samples.len()).map(|m| share(m) * share(m)).sum();
    let step = above / below;
    (mean - step * 0.5, step)
}

impl CollageFit {
    /// How many numbers it is made of: those of its maps.
    #[must_use]
    pub fn numbers(&self) -> usize {
        self.maps.len() * numbers_per_map(self.separable)
    }

    /// The point of the fit at each feature point (the first of the two where pieces do not meet), and where each piece
    /// ends.
    #[must_use]
    pub fn attractor(&self) -> (Vec<DVec2>, Vec<DVec2>) {
        let count = self.maps.len() * self.intervals;
        let image = |points: &[DVec2], k: usize, m: usize| {
            let map = &self.maps[k];
            let from = source(map.start, map.reversed, m, self.intervals, count);
            map.offset + map.step * (m as f64 / self.intervals as f64) + map.factor * points[from]
        };
        let mut points = vec![DVec2::ZERO; count];
        // The norms are below 1, and 0.95 to the power of 1000 is below the last digit.
        for _ in 0..10_000 {
            let next: Vec<_> =
                (0..count).map(|i| image(&points, i / self.intervals, i % self.intervals)).collect();
            let size = next.iter().map(|p| p.length()).fold(0.0, f64::max);
            let moved = points.iter().zip(&next).map(|(a, b)| a.distance(*b)).fold(0.0, f64::max);
            points = next;
            if moved <= 1e-15 * size {
                break;
            }
        }
        let ends = (0..self.maps.len()).map(|k| image(&points, k, self.intervals)).collect();
        (points, ends)
    }

    /// The widest and the mean gap between neighbouring pieces, in plane units.
    #[must_use]
    pub fn gaps(&self) -> (f64, f64) {
        let (points, ends) = self.attractor();
        let next = |k: usize| points[(k + 1) * self.intervals % points.len()];
        let gaps = ends.iter().enumerate().map(|(k, end)| end.distance(next(k)));
        let (widest, sum) = gaps.fold((0.0_f64, 0.0), |(widest, sum), gap| (widest.max(gap), sum + gap));
        (widest, sum / ends.len() as f64)
    }

    /// The fit as a fractal curve over [0, 2]: twice round, since a domain may run over the seam. Feature point i of n
    /// is at i / n, and again one later.
    ///
    /// # Errors
    /// None for a fit that [`fit_collage`] made; else as [`FractalCurve::new`].
    pub fn curve(&self) -> Result<FractalCurve, FunctionError> {
        let maps = self.maps.len();
        let count = (maps * self.intervals) as f64;
        let pieces = (0..2 * maps).map(|k| {
            let map = &self.maps[k % maps];
            let range = [k as f64 / maps as f64, (k + 1) as f64 / maps as f64];
            let start = map.start as f64 / count;
            let domain = [start, start + 2.0 / maps as f64];
            // m / M is the share of the domain that has been run through.
            let rate = maps as f64 / 2.0 * if map.reversed { -1.0 } else { 1.0 };
            let from = domain[usize::from(map.reversed)];
            let shear = map.step * rate;
            Piece {
                range,
                domain,
                reflected: map.reversed,
                shear,
                factor: map.factor,
                offset: map.offset - shear * from,
                along: along([range, domain], map.reversed),
            }
        });
        FractalCurve::new(pieces.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ring(count: usize) -> Vec<DVec2> {
        let point = |i: usize| {
            let angle = std::f64::consts::TAU * i as f64 / count as f64;
            DVec2::from_angle(angle) * (2.0 + (5.0 * angle).sin() + 0.3 * (23.0 * angle).cos())
        };
        (0..count).map(point).collect()
    }

    #[test]
    fn tied_ends_leave_no_gap_and_free_ones_fit_better() {
        for separable in [false, true] {
            for domains in [Domains::Recurrent, Domains::Partitioned] {
                // With a bound of 0.95 what rounding does to a periodic address would be seen.
                let options =
                    CollageOptions { maps: 20, separable, domains, bound: 0.5, ..CollageOptions::default() };
                let free = fit_collage(&ring(120), &options).unwrap();
                let tied = fit_collage(&ring(120), &CollageOptions { tied: true, ..options }).unwrap();
                assert!(tied.gaps().0 < 1e-12, "{:?}", tied.gaps());
                assert!(free.gaps().0 > 1e-3);
                assert!(free.collage < tied.collage);
                assert!(tied.maps.iter().all(|map| spectral_norm(map.factor) <= 0.5 + 1e-12));
                let curve = tied.curve().unwrap();
                for (i, p) in tied.attractor().0.into_iter().enumerate() {
                    assert!(curve.at(i as f64 / 120.0).distance(p) < 1e-9, "point {i}");
                }
            }
        }
    }

    #[test]
    fn a_map_takes_ten_numbers_and_a_separable_one_eight() {
        for (separable, maps, numbers) in
            [(true, 29, 232), (true, 52, 416), (false, 29, 290), (false, 52, 520)]
        {
            let options = CollageOptions { maps, separable, ..CollageOptions::default() };
            assert_eq!(fit_collage(&ring(261), &options).unwrap().numbers(), numbers);
        }
    }

    #[test]
    fn ends_of_rough_copies_of_any_part_are_tied_too() {
        let mut shrunk = 0;
        for seed in 0..8_u32 {
            let rough = |i: usize| {
                let unit = f64::from(frond_core::hash::unit(frond_core::hash::counter(seed, i as u32)));
                DVec2::from_angle(std::f64::consts::TAU * i as f64 / 60.0) * (1.0 + unit)
            };
            let ring: Vec<_> = (0..60).map(rough).collect();
            let options = CollageOptions {
                maps: 10,
                separable: seed % 2 == 0,
                domains: Domains::Partitioned,
                tied: true,
                ..CollageOptions::default()
            };
            let fit = fit_collage(&ring, &options).unwrap();
            assert!(fit.gaps().0 < 1e-12, "{seed}: {:?}", fit.gaps());
            assert!(fit.attractor().0.iter().all(|p| p.length() < 20.0), "{seed}");
            shrunk += usize::from(fit.maps.iter().all(|map| spectral_norm(map.factor) < 0.86));
        }
        assert!(shrunk > 2, "{shrunk}");
    }

    #[test]
    fn more_freedom_never_fits_worse() {
        let fit = |separable, domains| {
            let options = CollageOptions { maps: 15, separable, domains, ..CollageOptions::default() };
            fit_collage(&ring(120), &options).unwrap().collage
        };
        assert!(fit(false, Domains::Partitioned) <= fit(false, Domains::Recurrent));
        assert!(fit(false, Domains::Recurrent) <= fit(true, Domains::Recurrent));
    }

    #[test]
    fn least_squares_under_the_bound_are_nearer_than_the_free_optimum_cut() {
        for tied in [false, true] {
            for separable in [false, true] {
                let options = CollageOptions { maps: 15, separable, tied, ..CollageOptions::default() };
                let best = fit_collage(&ring(120), &options).unwrap();
                let clipped = CollageOptions { bounding: Bounding::Clipped, ..options };
                let clipped = fit_collage(&ring(120), &clipped).unwrap();
                let most = best.maps.iter().map(|map| spectral_norm(map.factor)).fold(0.0, f64::max);
                assert!((most - 0.95).abs() < 1e-12, "{most}");
                if separable {
                    assert_eq!(best, clipped);
                } else {
                    assert!(best.collage < 0.99 * clipped.collage, "{} {}", best.collage, clipped.collage);
                }
            }
        }
    }

    #[test]
    fn bad_input_has_codes_and_no_panics() {
        let fit = |points: &[DVec2], maps, bound| {
            let options = CollageOptions { maps, bound, ..CollageOptions::default() };
            fit_collage(points, &options).map_err(|error| error.code())
        };
        assert_eq!(fit(&[], 0, 0.9), Err("too-few-points"));
        assert_eq!(fit(&ring(10), 6, 0.9), Err("too-few-points"));
        assert_eq!(fit(&ring(100), 10, f64::NAN), Err("bad-bound"));
        assert_eq!(fit(&[DVec2::NAN; 30], 3, 0.9), Err("not-finite"));
        assert_eq!(fit(&vec![DVec2::ZERO; 1 << 20], 1 << 19, 0.9), Err("too-many"));
        assert!(fit(&[DVec2::ONE; 30], 3, 0.9).unwrap().collage < 1e-20);
    }
}
