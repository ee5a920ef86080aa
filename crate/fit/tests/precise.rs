//! Values to the last digits: beside places in exact fractions, and through points.

use frond_fit::{FractalFunction, FunctionError, Piece};
use glam::DVec2;
use num_bigint::BigInt;
use proptest::prelude::*;

/// A fraction, its denominator above 0.
#[derive(Clone)]
struct Fraction(BigInt, BigInt);

impl Fraction {
    fn of(x: f64) -> Self {
        // Twice a number is a number: whole after some hundred times.
        let (mut x, mut below) = (x, BigInt::from(1));
        while x.fract() != 0.0 {
            (x, below) = (2.0 * x, below * 2);
        }
        let mut above = BigInt::from(0);
        for shift in (0..=20).rev().map(|k| 50 * k) {
            let part = (x / f64::from(shift).exp2()).trunc();
            above += BigInt::from(part as i64) << shift;
            x -= part * f64::from(shift).exp2();
        }
        Self(above, below)
    }

    fn plus(&self, other: &Self) -> Self {
        Self(&self.0 * &other.1 + &other.0 * &self.1, &self.1 * &other.1)
    }

    fn times(&self, other: &Self) -> Self {
        Self(&self.0 * &other.0, &self.1 * &other.1)
    }

    fn minus(&self, other: &Self) -> Self {
        self.plus(&Self(-&other.0, other.1.clone()))
    }

    fn over(&self, other: &Self) -> Self {
        let one = Self(&self.0 * &other.1, &self.1 * &other.0);
        if one.1 < BigInt::from(0) { Self(-one.0, -one.1) } else { one }
    }

    /// Cut to so many parts, as a value may be that is multiplied by less than 1.
    fn cut(&self, bits: u32) -> Self {
        Self((&self.0 << bits) / &self.1, BigInt::from(1) << bits)
    }

    fn is_below(&self, other: &Self) -> bool {
        &self.0 * &other.1 < &other.0 * &self.1
    }

    fn number(&self) -> f64 {
        let cut: BigInt = (&self.0 << 200) / &self.1;
        cut.to_string().parse::<f64>().unwrap() / 200_f64.exp2()
    }
}

/// F(t) = b s + c F(s) + e with t = a s + d, over and over, by fractions. None where t comes near an end of a piece.
fn by_fractions(function: &FractalFunction, t: f64) -> Option<f64> {
    let pieces: Vec<([Fraction; 5], f64, Fraction, [Fraction; 2])> = function
        .curve()
        .pieces()
        .iter()
        .map(|piece: &Piece| {
            let map = piece.map().map(Fraction::of);
            let first = Fraction::of(piece.domain[usize::from(piece.reflected)]);
            let begin = map[0].times(&first).plus(&map[3]);
            (map, piece.map()[2], begin, piece.domain.map(Fraction::of))
        })
        .collect();
    let (mut place, mut value, mut left) = (Fraction::of(t), Fraction::of(0.0), Fraction::of(1.0));
    let mut size = 1.0_f64;
    while size > 1e-25 {
        if pieces.iter().any(|piece| place.minus(&piece.2).number().abs() < 1e-8) {
            return None;
        }
        let index = pieces.iter().rposition(|piece| !place.is_below(&piece.2))?;
        let ([a, b, c, d, e], factor, _, [first, last]) = &pieces[index];
        place = place.minus(d).over(a);
        // Beyond what is copied its nearer end goes on.
        if place.is_below(first) {
            place = first.clone();
        } else if last.is_below(&place) {
            place = last.clone();
        }
        value = value.plus(&left.times(&b.times(&place).plus(e))).cut(300);
        left = left.times(c).cut(300);
        size *= factor.abs();
    }
    Some(value.number())
}

fn holds(function: &FractalFunction, t: f64) {
    let Some(wanted) = by_fractions(function, t) else { return };
    let got = function.precise_at(t);
    let last = 4.0 * f64::EPSILON * wanted.abs() + 1e-19 * function.curve().bound();
    assert!((got - wanted).abs() <= last, "at {t}: {got} for {wanted}");
}

#[test]
fn a_rough_function_of_a_short_piece_is_right_where_numbers_lose_their_address() {
    let points = [[0.0, 0.3], [0.12, -0.4], [0.55, 0.9], [1.0, 0.1]].map(DVec2::from);
    let function = FractalFunction::fif(&points, &[0.87, -0.8, 0.6], &[false, true, false]).unwrap();
    let mut worst = 0.0_f64;
    for i in 1..60 {
        let t = f64::from(i) * 0.016_180_339;
        holds(&function, t);
        worst = worst.max((function.at(t) - function.precise_at(t)).abs());
    }
    assert!(worst > 1e-9, "numbers of 53 bits would do: {worst}");
}

#[test]
fn knots_and_ends_are_met_exactly_whatever_the_interval() {
    for (start, scale) in [(0.0, 1.0), (-7.3, 0.013), (1990.1, 29.7), (1e6 + 0.1, 1e-3)] {
        let points = [[0.0, 0.3], [0.12, -0.4], [0.31, 0.9], [0.77, 0.2], [1.0, 0.1]];
        let points = points.map(|[t, x]| DVec2::new(start + scale * t, x));
        let spans = [(0, 4), (4, 2), (1, 3), (0, 3)];
        let whole = FractalFunction::fif(&points, &[0.9, -0.8, 0.6, 0.97], &[true, false, true, false]);
        let parts = FractalFunction::rfif(&points, &[0.9, -0.8, 0.6, -0.97], &spans);
        for function in [whole.unwrap(), parts.unwrap()] {
            for p in points {
                let off = (function.precise_at(p.x) - p.y).abs();
                // Far from t = 0 what b and e add cancels, and they are numbers of 53 bits.
                let sum = |piece: &Piece| (piece.shear.x * p.x).abs() + piece.offset.x.abs() + 1.0;
                let size = function.curve().pieces().iter().map(sum).fold(0.0, f64::max);
                assert!(off <= 4.0 * f64::EPSILON * size / (1.0 - 0.97), "{p}: {off}");
            }
            assert_eq!(function.precise_at(f64::NAN), function.precise_at(f64::NEG_INFINITY));
            assert_eq!(function.precise_at(f64::INFINITY), function.precise_at(points[4].x));
        }
    }
}

#[test]
fn factors_near_one_end_soon() {
    let points = [[0.0, 0.0], [1e-9, 1.0], [1.0, 0.5]].map(DVec2::from);
    for c in [0.998, 0.999_999, 1.0 - f64::EPSILON] {
        let function = FractalFunction::fif(&points, &[c, -c], &[false, false]).unwrap();
        for t in [0.3, 0.5e-9, 0.999_999] {
            assert!(function.precise_at(t).abs() <= function.curve().bound());
        }
    }
}

/// Table 3 of Cochran, Hart & Flynn as it is printed: its pieces leave slits, and two overlap.
#[test]
fn a_table_of_three_digits_is_a_function() {
    let maps = [
        ([-0.333, 0.0, -0.5, 0.222, 0.375], [0.278, 0.667]),
        ([0.333, 0.0, -0.5, 0.074, 0.563], [0.167, 0.5]),
        ([0.333, 0.0, 0.5, 0.185, 0.063], [0.167, 0.444]),
        ([0.333, 0.0, 0.5, 0.333, 0.25], [0.0, 1.0]),
        ([-0.333, 0.0, -0.5, 0.815, 0.938], [0.167, 0.444]),
        ([-0.333, 0.0, 0.5, 0.926, 0.437], [0.167, 0.5]),
        ([0.333, 0.0, 0.5, 0.778, 0.625], [0.277, 0.667]),
    ];
    let function = FractalFunction::pfif(&maps).unwrap();
    let (mut sure, mut plain, count) = (0, 0, 2000);
    for i in 0..count {
        let t = (f64::from(i) + 0.5) / f64::from(count);
        // The fractions keep to the piece on the left of a slit.
        let ends = |k: usize| function.curve().pieces()[k].range;
        let slit = (0..6).any(|k| t > ends(k)[1] && t < ends(k + 1)[0]);
        if !slit && let Some(wanted) = by_fractions(&function, t) {
            sure += usize::from((function.precise_at(t) - wanted).abs() < 1e-12);
            plain += usize::from((function.at(t) - wanted).abs() < 1e-9);
        }
    }
    // Places that come to the middle of a slit, where it jumps, are few.
    assert!(sure > 1900 && plain > 1900, "{sure} {plain}");
    let [slit_start, slit_end] = [0.333 * 1.0 + 0.333, -0.333 * 0.444 + 0.815];
    let (left, right) = (slit_start - 1e-12, slit_end + 1e-12);
    for share in [0.1, 0.4, 0.6, 0.9] {
        let near = if share < 0.5 { left } else { right };
        let at = function.precise_at(slit_start + share * (slit_end - slit_start));
        assert!((at - function.precise_at(near)).abs() < 1e-3, "{share}");
    }
    for points in [
        function.sample(1e-3, [0.0, 1.0], 10_000),
        function.curve().polyline(1e-2, 100_000).unwrap().iter().map(|p| (p.0, p.1.x)).collect(),
    ] {
        assert!(points.windows(2).all(|pair| pair[0].0 <= pair[1].0 + 1e-12), "t goes back");
    }
    assert_eq!(function.to_recurrent(100), None);
    assert!(function.curve().widest_gap() > 1e-4);
    // A hole that is no rounding is none still.
    let mut apart = maps;
    apart[3].0[3] = 0.33;
    assert!(matches!(FractalFunction::pfif(&apart), Err(FunctionError::NotJoined { piece: 3 | 4, .. })));
}

/// Domains of which equations have no solution, and such as values that were put in over and over ran away from.
#[test]
fn equations_without_end_are_solved_or_have_no_solution() {
    let points = [[0.0, 0.0], [0.4, 1.0], [0.5, -1.0], [1.0, 0.3]].map(DVec2::from);
    let mut read = 0;
    for c in [0.3, -0.6, 0.9, -0.95, 0.97] {
        for ends in [[0.05, 0.93], [0.21, 0.83], [0.45, 0.99]] {
            let domains = [[0.05, 0.95], ends, [0.13, 0.87]];
            let Ok(function) =
                FractalFunction::through(&points, &[c, -c, c], &[false, true, false], &domains)
            else {
                continue;
            };
            read += 1;
            for p in points {
                let off = (function.precise_at(p.x) - p.y).abs();
                assert!(off < 1e-11 * function.curve().bound(), "{c} {ends:?}: {off}");
            }
        }
    }
    assert_eq!(read, 15);
}

/// Knots, of which some are close, and factors up to 0.97.
fn any_points() -> impl Strategy<Value = (Vec<DVec2>, Vec<f64>, Vec<bool>)> {
    let step = prop_oneof![3 => 0.1..1.0_f64, 1 => 0.005..0.05_f64];
    let one = (step, -1.0..1.0_f64, -0.97..0.97_f64, any::<bool>());
    (proptest::collection::vec(one, 2..9), -3.0..3.0_f64).prop_map(|(list, start)| {
        let mut points = vec![DVec2::new(start, 0.5)];
        for &(step, x, ..) in &list {
            points.push(DVec2::new(points[points.len() - 1].x + step, x));
        }
        (points, list.iter().map(|one| one.2).collect(), list.iter().map(|one| one.3).collect())
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(frond_testing::cases(60)))]

    #[test]
    fn values_are_those_of_exact_fractions(
        (points, c, reflected) in any_points(),
        shares in proptest::collection::vec(0.0..1.0_f64, 6),
        ends in proptest::collection::vec((0.0..1.0_f64, 0.0..1.0_f64), 9),
    ) {
        let (start, end) = (points[0].x, points[points.len() - 1].x);
        let function = FractalFunction::fif(&points, &c, &reflected).unwrap();
        shares.iter().for_each(|share| holds(&function, start + share * (end - start)));
        // Any parts that are longer than their pieces: equations of random numbers have a solution.
        let domains: Vec<[f64; 2]> = points
            .windows(2)
            .zip(&ends)
            .map(|(pair, (place, more))| {
                let (own, whole) = (pair[1].x - pair[0].x, end - start);
                let long = own + (0.02 + 0.98 * more) * (whole - own);
                let from = start + place * (whole - long);
                [from, (from + long).min(end)]
            })
            .collect();
        let function = FractalFunction::through(&points, &c, &reflected, &domains).unwrap();
        for p in &points {
            let off = (function.precise_at(p.x) - p.y).abs();
            prop_assert!(off <= 1e-9 * function.curve().bound(), "{} off at {}", off, p);
        }
        shares.iter().for_each(|share| holds(&function, start + share * (end - start)));
    }
}
