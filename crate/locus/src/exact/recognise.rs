//! Which numbers the doubles of a system most plausibly stand for.

use std::collections::HashMap;

use frond_core::Affine2;
use frond_core::closed_form::{simplest_fraction, simplest_root};
use num_bigint::BigInt;

use crate::exact::quadratic::{Quadratic, QuadraticSystem, dyadic};

/// What a system would be if its numbers were those that they come near.
pub(crate) struct Recognised {
    pub system: QuadraticSystem,
    /// Each number that is read as another one, and as which: "0.3333333333333333 is 1/3".
    pub assuming: Vec<String>,
}

/// `(p + r sqrt(d)) / q`, q positive; times the sine of 72 degrees if it is of a pentagon.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Value {
    p: i64,
    r: i64,
    q: i64,
    d: u8,
    of_pentagon: bool,
}

/// A number of a system: read as this, or as itself.
#[derive(Clone, Copy, Debug)]
enum Read {
    Itself,
    As(Value),
}

/// Where roots may be in the numbers of a system: one root, and for pentagons the axis along which all is measured in
/// sines of 72 degrees.
#[derive(Clone, Copy, Debug)]
struct Guess {
    d: u8,
    axis: Option<usize>,
}

const GUESSES: [Guess; 5] = [
    Guess { d: 3, axis: None },
    Guess { d: 2, axis: None },
    Guess { d: 5, axis: None },
    Guess { d: 5, axis: Some(0) },
    Guess { d: 5, axis: Some(1) },
];
/// Numbers with no more binary digits than this mean what they say.
const SHORT_BITS: i64 = 20;
/// Numbers of a system that fit nothing, after which none of it is read.
const TOO_MANY_STRANGE: usize = 4;

/// A number, where it is in a row, and how far off it may be.
type Number = (f64, usize, f64);
/// A row of numbers with what they stand for.
type Row = [(f64, Read); 6];

/// Reads the maps with roots of as few kinds as will do; `None` if nothing would change, or too many numbers are
/// strange.
pub(crate) fn read(maps: &[Affine2]) -> Option<Recognised> {
    // Rounding leaves more where numbers were added up: ulps of the largest that are of a kind.
    let largest = |of: fn(&Affine2) -> f64| maps.iter().map(of).fold(0.0, f64::max);
    let linear = largest(|map| map.to_row()[..4].iter().fold(0.0, |most, x| x.abs().max(most)));
    let shift = largest(|map| map.translation.abs().max_element());
    let number = |k: usize, x: f64| -> Number {
        let rough = if k < 4 { 2.0 * linear } else { 4.0 * shift };
        (x, k, f64::EPSILON * rough.max(4.0 * x.abs()))
    };
    let rows = maps.iter().map(|map| map.to_row());
    let rows: Vec<[Number; 6]> = rows.map(|row| std::array::from_fn(|k| number(k, row[k]))).collect();
    let mut fractions: HashMap<u64, Option<Read>> = HashMap::new();
    for &(x, _, off) in rows.iter().flatten() {
        fractions.entry(x.to_bits()).or_insert_with(|| of_fraction(x, off));
    }
    let guesses = GUESSES.iter().filter_map(|guess| Some((guess, guess.read(&rows, &fractions)?)));
    let (guess, (_, best)) = guesses.min_by_key(|(_, found)| found.0)?;
    let assuming = assumptions(&best);
    (!assuming.is_empty()).then(|| Recognised { system: system(&best, guess.axis), assuming })
}

impl Guess {
    /// How many numbers stand for nothing but themselves, and what each stands for.
    fn read(self, rows: &[[Number; 6]], fractions: &HashMap<u64, Option<Read>>) -> Option<(usize, Vec<Row>)> {
        let mut strange = 0;
        let mut known: HashMap<(u64, bool), Read> = HashMap::new();
        let mut read = |&(x, k, off): &Number| -> Option<(f64, Read)> {
            let of_pentagon = self.axis.is_some_and(|axis| k == 1 || k == 2 || k == 4 + axis);
            let key = (x.to_bits(), of_pentagon);
            if let Some(&read) = known.get(&key) {
                return Some((x, read));
            }
            let found = if of_pentagon {
                // What is measured so must all be.
                if x == 0.0 { Read::Itself } else { Read::As(in_sines(x, off)?) }
            } else if let Some(read) = fractions[&x.to_bits()] {
                read
            } else if strange >= TOO_MANY_STRANGE {
                return None;
            } else {
                let value = with_root(x, off, self.d);
                strange += usize::from(value.is_none());
                value.map_or(Read::Itself, Read::As)
            };
            known.insert(key, found);
            Some((x, found))
        };
        let mut row = |row: &[Number; 6]| -> Option<Row> {
            let row: Vec<_> = row.iter().map(&mut read).collect::<Option<_>>()?;
            row.try_into().ok()
        };
        let rows = rows.iter().map(&mut row).collect::<Option<_>>()?;
        (strange < TOO_MANY_STRANGE).then_some((strange, rows))
    }
}

/// The sine of 72 degrees; its square is (5 + sqrt 5) / 8.
const SINE_OF_72: f64 = 0.951_056_516_295_153_6;

/// A number of a pentagon, as a multiple of the sine of 72 degrees.
fn in_sines(x: f64, off: f64) -> Option<Value> {
    let (x, off) = (x / SINE_OF_72, off / SINE_OF_72 + 4.0 * f64::EPSILON * x.abs());
    if x.abs() <= off {
        return Some(Value { p: 0, r: 0, q: 1, d: 0, of_pentagon: false });
    }
    let short = |(p, q)| Value { p, r: 0, q, d: 5, of_pentagon: true };
    let value = simplest_fraction(x, off).map(short).or_else(|| with_root(x, off, 5))?;
    Some(Value { of_pentagon: true, ..value })
}

fn assumptions(rows: &[Row]) -> Vec<String> {
    let mut said: Vec<String> = Vec::new();
    for (x, read) in rows.iter().flatten() {
        if let Read::As(value) = read {
            // A number and its opposite are one assumption.
            let value = if *x < 0.0 { Value { p: -value.p, r: -value.r, ..*value } } else { *value };
            let text = format!("{:?} is {}", x.abs(), value.shown());
            if !said.contains(&text) {
                said.push(text);
            }
        }
    }
    said
}

/// All over one denominator.
fn system(rows: &[Row], axis: Option<usize>) -> QuadraticSystem {
    let (mut over, mut power) = (BigInt::from(1), 0);
    for (x, read) in rows.iter().flatten() {
        match read {
            Read::Itself => power = power.max(-dyadic(*x).1),
            Read::As(value) => {
                let q = BigInt::from(value.q);
                over = &over * (&q / gcd(over.clone(), q.clone()));
            }
        }
    }
    let two = |power: i64| BigInt::from(1) << power;
    // Eighths for the square of the sine.
    let over = over * two(power + 3);
    let surd = |(x, read): &(f64, Read)| match read {
        Read::Itself => {
            let (digits, power) = dyadic(*x);
            let whole = if power < 0 { &over / two(-power) } else { &over * two(power) };
            Quadratic::whole(whole * digits)
        }
        Read::As(value) => {
            let scale = &over / value.q;
            let d = if value.r == 0 { 0 } else { value.d };
            Quadratic { a: &scale * value.p, b: &scale * value.r, d }
        }
    };
    // Seen in coordinates where the axis of a pentagon is measured in sines, its shift and the number that leads to
    // it are multiples of 1, and the number that leads from it is a multiple of the square of the sine.
    let from = if axis == Some(0) { 2 } else { 1 };
    let entry = |row: &Row, k: usize| {
        let plain = surd(&row[k]);
        if k == from && of_pentagon(row[k].1) {
            let times = &plain * &Quadratic { a: 5.into(), b: 1.into(), d: 5 };
            Quadratic { a: times.a / 8, b: times.b / 8, d: 5 }
        } else {
            plain
        }
    };
    let rows = rows.iter().map(|row| std::array::from_fn(|k| entry(row, k))).collect();
    QuadraticSystem::new(rows, &Quadratic::whole(over.clone()))
}

fn of_pentagon(read: Read) -> bool {
    matches!(read, Read::As(Value { of_pentagon: true, .. }))
}

fn gcd(mut a: BigInt, mut b: BigInt) -> BigInt {
    while b != BigInt::ZERO {
        (a, b) = (b.clone(), a % b);
    }
    a
}

/// Short binary numbers are themselves; others are a fraction of small numbers, or what was typed.
fn of_fraction(x: f64, off: f64) -> Option<Read> {
    if x == 0.0 || dyadic(x).1 >= -SHORT_BITS {
        return Some(Read::Itself);
    }
    if x.abs() <= off {
        return Some(Read::As(Value { p: 0, r: 0, q: 1, d: 0, of_pentagon: false }));
    }
    let (p, q) = fraction(x, off)?;
    let value = Value { p, r: 0, q, d: 0, of_pentagon: false };
    Some(if p as f64 / q as f64 == x && q.count_ones() == 1 { Read::Itself } else { Read::As(value) })
}

/// The simplest fraction of small numbers, or one that is written in a few decimals.
fn fraction(x: f64, off: f64) -> Option<(i64, i64)> {
    if let Some(short) = simplest_fraction(x, off) {
        return Some(short);
    }
    // The shortest decimal that is this double: what a person typed has few digits.
    let text = format!("{x}");
    let digits =
        text.trim_start_matches('-').trim_start_matches(['0', '.']).bytes().filter(u8::is_ascii_digit);
    if digits.count() > 9 {
        return None;
    }
    let (whole, decimals) = text.split_once('.').unwrap_or((&text, ""));
    let power = 10_i64.checked_pow(u32::try_from(decimals.len()).ok()?)?;
    let p: i64 = format!("{whole}{decimals}").parse().ok()?;
    let common = gcd_i64(p.abs(), power);
    Some((p / common, power / common))
}

fn gcd_i64(mut a: i64, mut b: i64) -> i64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.max(1)
}

/// As [`simplest_root`] has it.
fn with_root(x: f64, off: f64, d: u8) -> Option<Value> {
    let (p, r, q) = simplest_root(x, off, d)?;
    Some(Value { p, r, q, d, of_pentagon: false })
}

impl Value {
    fn shown(&self) -> String {
        let Self { p, r, q, d, of_pentagon } = *self;
        if of_pentagon {
            let value = Self { of_pentagon: false, ..*self }.shown();
            return match value.as_str() {
                "1" => "sin(72°)".to_owned(),
                "-1" => "-sin(72°)".to_owned(),
                _ if q == 1 && p != 0 && r != 0 => format!("({value}) sin(72°)"),
                _ => format!("{value} sin(72°)"),
            };
        }
        let over = |text: String| if q == 1 { text } else { format!("{text}/{q}") };
        if r == 0 {
            return over(p.to_string());
        }
        let times = if r.abs() == 1 { String::new() } else { format!("{} ", r.abs()) };
        let root = format!("{times}sqrt({d})");
        if p == 0 {
            over(if r < 0 { format!("-{root}") } else { root })
        } else {
            let sum = format!("{p} {} {root}", if r < 0 { '-' } else { '+' });
            if q == 1 { sum } else { format!("({sum})/{q}") }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(x: f64) -> Option<String> {
        let off = 4.0 * f64::EPSILON * x.abs();
        match of_fraction(x, off) {
            Some(Read::Itself) => Some("itself".into()),
            Some(Read::As(value)) => Some(value.shown()),
            None => [2, 3, 5].iter().find_map(|&d| with_root(x, off, d)).map(|value| value.shown()),
        }
    }

    #[test]
    fn numbers_are_named() {
        for (x, wanted) in [
            (0.5, "itself"),
            (0.0, "itself"),
            (-1234.0, "itself"),
            (1.0 / 3.0, "1/3"),
            (-2.0 / 3.0, "-2/3"),
            (1.0 - 1.0 / 3.0, "2/3"),
            (0.1 + 0.2, "3/10"),
            (0.4999, "4999/10000"),
            (-0.044, "-11/250"),
            (3.0_f64.sqrt() / 6.0, "sqrt(3)/6"),
            (-3.0_f64.sqrt() / 2.0, "-sqrt(3)/2"),
            (5.0 * 3.0_f64.sqrt() / 14.0, "5 sqrt(3)/14"),
            (2.0_f64.sqrt(), "sqrt(2)"),
            ((3.0 - 5.0_f64.sqrt()) / 2.0, "(3 - sqrt(5))/2"),
            (1.0 + 2.0_f64.sqrt(), "1 + sqrt(2)"),
        ] {
            assert_eq!(name(x).as_deref(), Some(wanted), "{x}");
        }
        for strange in
            [std::f64::consts::PI, 0.123_456_789_012, 1.0_f64.exp(), 1e-7_f64.sqrt(), 7.0_f64.sqrt()]
        {
            assert_eq!(name(strange), None, "{strange}");
        }
    }

    #[test]
    fn random_numbers_stand_for_themselves() {
        let named = (0..3000_u32).filter(|&k| {
            let x = f64::from(frond_core::hash::counter(3, k)) / f64::from(u32::MAX) * 1.9 - 0.8;
            name(x * 0.987_654_321_987).is_some()
        });
        assert_eq!(named.count(), 0);
    }

    #[test]
    fn systems_are_read_with_one_root() {
        let third = 1.0 / 3.0;
        let koch = Affine2::similitude(third, std::f64::consts::FRAC_PI_3, glam::DVec2::new(third, 0.0));
        let reading = read(&[koch, Affine2::similitude(third, 0.0, glam::DVec2::ZERO)]).unwrap();
        let said: Vec<&str> =
            reading.assuming.iter().map(|text| text.split_once(" is ").unwrap().1).collect();
        assert_eq!(said, ["1/6", "sqrt(3)/6", "1/3"]);
        // Nothing to be said.
        assert!(read(&[Affine2::similitude(0.5, 0.0, glam::DVec2::X)]).is_none());
        // The golden ratio beside sqrt(3): only one of them is read, which helps nobody, but does no harm.
        let odd = Affine2::from_row([0.381_966_011_250_105_2, 0.0, 0.0, 3.0_f64.sqrt() / 6.0, 0.0, 0.0]);
        assert_eq!(read(&[odd]).unwrap().assuming.len(), 1);
        // Turned by a quarter, a pentagon has its sines on the other axis.
        let ratio = f64::midpoint(3.0, -(5.0_f64.sqrt()));
        for quarter in [0.0, std::f64::consts::FRAC_PI_2] {
            let corner = |k| glam::DVec2::from_angle(quarter + std::f64::consts::TAU / 5.0 * f64::from(k));
            let maps: Vec<_> =
                (0..5).map(|k| Affine2::similitude(ratio, 0.0, corner(k) * (1.0 - ratio))).collect();
            let reading = read(&maps).unwrap();
            assert!(reading.assuming.iter().any(|text| text.contains("sin(72")), "{:?}", reading.assuming);
        }
        let random = Affine2::from_row([
            0.1234567890123,
            0.2345678901234,
            0.345678901245,
            0.45678901233,
            0.567890128,
            0.678901236789,
        ]);
        assert!(read(&[random]).is_none());
    }
}
