//! Partitioned functions through points.

use glam::{DMat2, DVec2};

use crate::error::FunctionError;
use crate::fractal::function::FractalFunction;
use crate::fractal::piece::Piece;

/// How often the values at the ends of the domains are taken anew. They settle like powers of the factors.
const MOST_ROUNDS: usize = 500;

impl FractalFunction {
    /// The function through points whose piece i copies what lies over `domains[i]` (Cochran, Hart & Flynn, section
    /// 2.3).
    ///
    /// The ends of a domain need not be points, so that the values there, which the maps hang on, are themselves
    /// unknown. They are those of the function made with them: it is made over and over until they stay.
    ///
    /// # Errors
    /// [`FunctionError`] where there is no such function, or the values at the ends of the domains do not settle.
    pub fn through(
        points: &[DVec2],
        c: &[f64],
        reflected: &[bool],
        domains: &[[f64; 2]],
    ) -> Result<Self, FunctionError> {
        let count = points.len();
        if count < 2 {
            return Err(FunctionError::TooFewPoints { count });
        }
        let pieces = count - 1;
        for given in [c.len(), reflected.len(), domains.len()] {
            if given != pieces {
                return Err(FunctionError::WrongCount { pieces, given });
            }
        }
        let sound = |p: &DVec2| p.x.abs() <= 1e100 && p.y.abs() <= 1e100;
        if let Some(index) = points.iter().position(|p| !sound(p)) {
            return Err(FunctionError::NotFinite { index });
        }
        if let Some(index) = (1..count).find(|&i| points[i].x <= points[i - 1].x) {
            return Err(FunctionError::NotIncreasing { index });
        }
        let inside = |domain: &[f64; 2]| points[0].x <= domain[0] && domain[1] <= points[pieces].x;
        let fits = |(i, domain): (usize, &[f64; 2])| {
            inside(domain) && domain[1] - domain[0] > points[i + 1].x - points[i].x
        };
        if let Some(piece) = domains.iter().enumerate().position(|pair| !fits(pair)) {
            return Err(FunctionError::BadDomain { piece });
        }
        if let Some(index) = c.iter().position(|c| !c.is_finite()) {
            return Err(FunctionError::NotFinite { index });
        }
        if let Some(piece) = c.iter().position(|c| c.abs() >= 1.0) {
            return Err(FunctionError::NotContractive { piece, factor: c[piece].abs() });
        }
        let line = |t: f64| {
            let i = points.partition_point(|p| p.x <= t).clamp(1, pieces);
            let (a, b) = (points[i - 1], points[i]);
            a.y + (b.y - a.y) * (t - a.x) / (b.x - a.x)
        };
        let high = |y: f64| DVec2::new(y, 0.0);
        let make = |values: &[[f64; 2]]| {
            let map = |i: usize| {
                let ranges = [[points[i].x, points[i + 1].x], domains[i]];
                let factor = DMat2::from_cols(high(c[i]), DVec2::ZERO);
                let ends = [high(points[i].y), high(points[i + 1].y)];
                let piece = Piece::through(ranges, reflected[i], factor, ends, values[i].map(high));
                (piece.map(), domains[i])
            };
            Self::pfif(&(0..pieces).map(map).collect::<Vec<_>>())
        };
        let mut values: Vec<[f64; 2]> = domains.iter().map(|domain| domain.map(line)).collect();
        let size = points.iter().map(|p| p.y.abs()).fold(0.0, f64::max);
        for _ in 0..MOST_ROUNDS {
            let function = make(&values)?;
            let next: Vec<[f64; 2]> = domains.iter().map(|domain| domain.map(|t| function.at(t))).collect();
            let change = next.iter().flatten().zip(values.iter().flatten()).map(|(a, b)| (a - b).abs());
            let change = change.fold(0.0, f64::max);
            values = next;
            if change <= 1e-14 * size.max(f64::MIN_POSITIVE) {
                return make(&values);
            }
        }
        Err(FunctionError::Unsettled)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points() -> Vec<DVec2> {
        [[0.0, 0.0], [0.3, 1.0], [0.55, -0.5], [1.0, 0.25]].map(DVec2::from).to_vec()
    }

    #[test]
    fn it_goes_through_its_points_without_gaps() {
        let domains = [[0.1, 0.83], [0.27, 0.9], [0.0, 0.71]];
        for c in [0.0, 0.4, -0.7] {
            let function =
                FractalFunction::through(&points(), &[c, -c, c], &[false, true, false], &domains).unwrap();
            for p in points() {
                assert!((function.at(p.x) - p.y).abs() < 1e-9, "{c}: {p}");
            }
            assert!(function.curve().widest_gap() < 1e-9);
            for (piece, domain) in function.curve().pieces().iter().zip(domains) {
                assert_eq!(piece.domain, domain);
                assert!((piece.map()[2].abs() - c.abs()).abs() < 1e-15);
            }
        }
    }

    #[test]
    fn whole_domains_are_those_of_interpolation() {
        let (c, back) = ([0.3, -0.5, 0.6], [false, true, false]);
        let ours = FractalFunction::through(&points(), &c, &back, &[[0.0, 1.0]; 3]).unwrap();
        let theirs = FractalFunction::fif(&points(), &c, &back).unwrap();
        for i in 0..=100 {
            let t = f64::from(i) / 100.0;
            assert!((ours.at(t) - theirs.at(t)).abs() < 1e-12);
        }
    }

    #[test]
    fn what_is_no_function_is_refused() {
        let fails =
            |points: &[DVec2], c: &[f64], domains: &[[f64; 2]], code: &str| match FractalFunction::through(
                points,
                c,
                &vec![false; c.len()],
                domains,
            ) {
                Err(error) => assert_eq!(error.code(), code),
                Ok(_) => assert_eq!("", code),
            };
        let whole = [[0.0, 1.0]; 3];
        fails(&points()[..1], &[], &[], "too-few-points");
        fails(&points(), &[0.1, 0.1], &whole, "wrong-count");
        fails(&points(), &[0.1; 3], &whole[..2], "wrong-count");
        fails(&points(), &[f64::NAN; 3], &whole, "not-finite");
        fails(&points(), &[-1.0; 3], &whole, "not-contractive");
        fails(&points(), &[0.1; 3], &[[0.0, f64::NAN]; 3], "bad-domain");
        fails(&points(), &[0.1; 3], &[[0.0, 0.3]; 3], "bad-domain");
        fails(&points(), &[0.1; 3], &[[0.0, 1.1]; 3], "bad-domain");
        let mut unsorted = points();
        unsorted.swap(1, 2);
        fails(&unsorted, &[0.1; 3], &whole, "not-increasing");
        unsorted[0].y = f64::INFINITY;
        fails(&unsorted, &[0.1; 3], &whole, "not-finite");
    }
}
