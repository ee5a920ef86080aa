//! Partitioned functions through points.

use glam::{DMat2, DVec2};

use crate::error::FunctionError;
use crate::fractal::address::LEFT;
use crate::fractal::curve::Side;
use crate::fractal::function::FractalFunction;
use crate::fractal::piece::Piece;

/// The most pieces whose equations are solved at once.
const MOST_SOLVED: usize = 512;

/// How often the values of more are taken anew. They settle like powers of the factors, where they do.
const MOST_ROUNDS: usize = 500;

/// The least pivot of equations that have one solution, where 1 is on the diagonal.
const LEAST_PIVOT: f64 = 1e-10;

/// The greatest value that is kept.
const MOST_VALUE: f64 = 1e90;

/// Equations for the values at the ends of domains, two a piece, of functions through points with factors c: in each
/// row the shares of all values, and what they come to.
///
/// The address of the end of a domain hangs on a and d alone, those of the frame. Along it the value is a sum of what
/// each letter i adds: with u the share of its domain that lies before the place, x0 and x1 what the ends of its domain
/// go to, and p the product of the letters before it, p (x0 + u (x1 - x0) - c_i ((1 - u) F(alpha_i) + u F(beta_i))).
fn equations(frame: &FractalFunction, points: &[DVec2], c: &[f64]) -> Vec<Vec<f64>> {
    let pieces = frame.curve().pieces();
    let [start, end] = frame.curve().interval();
    let near = 4.0 * f64::EPSILON * start.abs().max(end.abs());
    let count = 2 * pieces.len();
    let ends = pieces.iter().flat_map(|piece| piece.domain.into_iter().zip([Side::Right, Side::Left]));
    let row = |(own, (t, side)): (usize, (f64, Side))| {
        let mut row = vec![0.0; count + 1];
        row[own] = 1.0;
        let after = points.partition_point(|p| p.x < t - near);
        if let Some(knot) = points.get(after).filter(|p| p.x <= t + near) {
            row[count] = knot.y;
            return row;
        }
        let mut left = 1.0;
        for letter in frame.curve().letters(t, side, LEFT).0 {
            let i = letter.index;
            let [low, high] = pieces[i].domain;
            let u = letter.source.plus((-low).into()).value() / (high - low);
            let (a, b) = (points[i].y, points[i + 1].y);
            let (first, last) = if pieces[i].reflected { (b, a) } else { (a, b) };
            row[count] += left * (first + u * (last - first));
            left *= c[i];
            row[2 * i] += left * (1.0 - u);
            row[2 * i + 1] += left * u;
        }
        row
    };
    ends.enumerate().map(row).collect()
}

/// The solution by Gauss's elimination, with the greatest of each column as its pivot; none where there is none, or
/// more than one.
fn solved(mut rows: Vec<Vec<f64>>) -> Option<Vec<f64>> {
    let count = rows.len();
    for column in 0..count {
        let size = |row: &usize| rows[*row][column].abs();
        let pivot = (column..count).max_by(|a, b| size(a).total_cmp(&size(b)))?;
        rows.swap(column, pivot);
        let (done, rest) = rows.split_at_mut(column + 1);
        let own = &done[column];
        if own[column].abs() < LEAST_PIVOT {
            return None;
        }
        for other in rest.iter_mut().filter(|other| other[column] != 0.0) {
            let times = other[column] / own[column];
            other[column..].iter_mut().zip(&own[column..]).for_each(|(x, y)| *x -= times * y);
        }
    }
    let mut values = vec![0.0; count];
    for i in (0..count).rev() {
        let known: f64 = (i + 1..count).map(|k| rows[i][k] * values[k]).sum();
        values[i] = (rows[i][count] - known) / rows[i][i];
    }
    values.iter().all(|value: &f64| value.abs() <= MOST_VALUE).then_some(values)
}

impl FractalFunction {
    /// The function through points whose piece i copies what lies over `domains[i]` (Cochran, Hart & Flynn, section
    /// 2.3).
    ///
    /// The ends of a domain need not be points, so that the values there, which the maps hang on, are themselves
    /// unknown. They are those of the function made with them, which is one linear equation for each.
    ///
    /// # Errors
    /// [`FunctionError`] where there is no such function. [`Unsettled`](FunctionError::Unsettled) where the equations
    /// have no solution or many; of more than 512 pieces also where values that are put in over and over do not settle.
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
        let mut values = vec![[0.0; 2]; pieces];
        let mut function = make(&values)?;
        if pieces <= MOST_SOLVED {
            let solution = solved(equations(&function, points, c)).ok_or(FunctionError::Unsettled)?;
            return make(&solution.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>());
        }
        let size = points.iter().map(|p| p.y.abs()).fold(f64::MIN_POSITIVE, f64::max);
        for _ in 0..MOST_ROUNDS {
            let next: Vec<[f64; 2]> = domains.iter().map(|domain| domain.map(|t| function.at(t))).collect();
            let change = next.iter().flatten().zip(values.iter().flatten()).map(|(a, b)| (a - b).abs());
            let change = change.fold(0.0, f64::max);
            if next.iter().flatten().any(|value| value.is_nan() || value.abs() > MOST_VALUE) {
                break;
            }
            values = next;
            function = make(&values)?;
            if change <= 1e-14 * size {
                return Ok(function);
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
                assert!((function.precise_at(p.x) - p.y).abs() < 1e-14, "{c}: {p}");
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
