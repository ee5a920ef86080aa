//! Which numbers the entries of maps are, and that they are near their doubles.

use std::cmp::Ordering;

use num_bigint::BigInt;

use crate::exact::{Exact, ExactEntry};
use crate::limits::{DEGREE, HELD, NUMERAL, NUMERALS, at_most};
use crate::refused::Refused;
use crate::whole::{Whole, unit};
use crate::work::{digits, product};

use super::numeral::{Numeral, common_multiple, whole};
use super::ring::{Element, Ring, minus, plus, times};

/// The maps in a ring.
pub(crate) struct Field {
    pub ring: Ring,
    /// Their entries, each times `scale`.
    pub rows: Vec<[Element; 6]>,
    pub scale: BigInt,
    /// By so many binary digits numbers grow with each letter of a word.
    pub letter: u64,
    /// Map and entry of what is not its double.
    listed: Vec<[usize; 2]>,
}

/// Binary digits of a text of decimal ones, at the most.
fn length(text: &str) -> u64 {
    4 * text.len() as u64
}

/// Sizes and forms, and what [`Field::read`] takes.
pub(crate) fn cost_reading(exact: &Exact, maps: &[[f64; 6]]) -> Result<u64, Refused> {
    let Exact { polynomial, root, entries } = exact;
    let degree = polynomial.len().saturating_sub(1);
    at_most(degree, DEGREE, "powers of the root")?;
    if degree == 0 {
        return Err(Refused::Form { why: "its polynomial is a number" });
    }
    let mut is_listed = vec![[false; 6]; maps.len()];
    for ExactEntry { map, entry, value } in entries {
        let known = is_listed.get_mut(usize::from(*map)).and_then(|row| row.get_mut(usize::from(*entry)));
        if value.len() > degree || known.is_none_or(|known| std::mem::replace(known, true)) {
            return Err(Refused::Form {
                why: "an exact entry is there twice, of no map, or of more powers than the field has",
            });
        }
    }
    let texts = || polynomial.iter().chain(root).chain(entries.iter().flat_map(|entry| &entry.value));
    at_most(texts().map(String::len).max().unwrap_or(0), NUMERAL, "digits in a fraction")?;
    at_most(texts().map(String::len).sum(), NUMERALS, "digits in fractions")?;
    // How long the common denominator can be: a factor of each text, of each power of the highest coefficient, and of
    // the doubles.
    let highest = length(&polynomial[degree]);
    let doubles = Whole::of(maps).ok_or(Refused::NotFinite { place: "maps" })?.bits;
    let all = texts().map(|text| length(text)).sum::<u64>() + degree as u64 * highest + doubles;
    let numbers = texts().count() + 6 * maps.len();
    at_most(numbers.saturating_mul(all as usize / 8), HELD, "bytes of exact numbers over one denominator")?;
    let fraction = |text: &String| {
        let own = length(text);
        // Euclid's algorithm takes three steps for two digits, at the most; what is before it one division.
        (3 * own + 8) * product(own, 0) + 4 * product(all, own) + 2 * product(all, degree as u64 * highest)
    };
    let powers = (degree * degree) as u64 * product(degree as u64 * highest, highest);
    let rows = 6 * maps.len() as u64 * 2 * product(all, 64);
    Ok(texts().map(fraction).fold(powers.saturating_add(rows), u64::saturating_add))
}

impl Field {
    /// Reads what [`cost_reading`] has looked at.
    ///
    /// With the highest coefficient h of the polynomial p, `y = h x` is a root of `h^(d - 1) p(y / h)`, whose highest
    /// coefficient is 1.
    pub fn read(exact: &Exact, maps: &[[f64; 6]]) -> Result<Self, Refused> {
        let Exact { polynomial, root, entries } = exact;
        let none = || Refused::Form { why: "an exact number is no fraction" };
        let mut coefficients =
            polynomial.iter().map(|text| whole(text)).collect::<Option<Vec<_>>>().ok_or_else(none)?;
        let highest = coefficients.pop().filter(|x| *x != BigInt::ZERO);
        let highest =
            highest.ok_or(Refused::Form { why: "the highest coefficient of its polynomial is 0" })?;
        let degree = coefficients.len();
        let mut powers = vec![BigInt::from(1)];
        for k in 0..degree {
            powers.push(&powers[k] * &highest);
        }
        for (k, x) in coefficients.iter_mut().enumerate() {
            *x *= &powers[degree - 1 - k];
        }
        let [low, high] = root.each_ref().map(|text| Numeral::of(text));
        let (low, high) = low.zip(high).ok_or_else(none)?;
        let under = &low.under * &high.under;
        let ends = [low.over * &high.under * &highest, high.over * &low.under * &highest];
        let [low, high] = ends;
        let ends = if highest < BigInt::ZERO { [high, low] } else { [low, high] };
        let ring = Ring::new(coefficients, ends, under);

        let mut doubles = maps.to_vec();
        let mut listed = Vec::with_capacity(entries.len());
        let mut values = Vec::with_capacity(entries.len());
        for ExactEntry { map, entry, value } in entries {
            let place = [usize::from(*map), usize::from(*entry)];
            doubles[place[0]][place[1]] = 0.0;
            listed.push(place);
            values.push(
                value.iter().map(|text| Numeral::of(text)).collect::<Option<Vec<_>>>().ok_or_else(none)?,
            );
        }
        let doubles = Whole::of(&doubles).ok_or(Refused::NotFinite { place: "maps" })?;
        let most = values.iter().map(Vec::len).max().unwrap_or(0).saturating_sub(1);
        let under = values
            .iter()
            .flatten()
            .fold(BigInt::from(1) << doubles.bits, |all, x| common_multiple(&all, &x.under));
        let scale = under * BigInt::from(powers[most].magnitude().clone());
        let factor = &scale >> doubles.bits;
        let mut rows: Vec<[Element; 6]> =
            doubles.rows.into_iter().map(|row| row.map(|x| ring.whole(x * &factor))).collect();
        for ([map, entry], value) in listed.iter().zip(values) {
            let row = &mut rows[*map][*entry];
            for (k, x) in value.into_iter().enumerate() {
                // Nothing is left over, and the power divides the scale with the sign that it has.
                row[k] = &scale / x.under / &powers[k] * x.over;
            }
        }
        let longest = digits(rows.iter().flatten().flatten()).max(scale.bits());
        let letter = longest + ring.growth + 2;
        Ok(Self { ring, rows, scale, letter, listed })
    }

    /// What [`Self::check`] takes.
    pub fn cost_check(&self) -> u64 {
        // A double and its unit have less than 1100 binary digits before and behind the point.
        let value = self.letter + 2200;
        let one = 2 * self.ring.cost_sign(value) + 4 * product(self.letter, 2200);
        self.ring.cost_narrow().saturating_add((self.listed.len() as u64).saturating_mul(one))
    }

    /// Checks that the polynomial has one root in its interval, and that each exact entry is within a unit in the last
    /// place of the double that stands for it. A double of 0 stands for 0 alone.
    pub fn check(&mut self, maps: &[[f64; 6]]) -> Result<(), Refused> {
        if !self.ring.narrow() {
            return Err(Refused::Root);
        }
        for &[map, entry] in &self.listed {
            let double = maps[map][entry];
            let Whole { rows, bits } =
                Whole::of(&[[double, unit(double)]]).ok_or(Refused::NotFinite { place: "maps" })?;
            let [double, unit] = rows[0].each_ref().map(|x| self.ring.whole(x * &self.scale));
            let off = minus(&times(&self.rows[map][entry], &(BigInt::from(1) << bits)), &double);
            let is_within =
                |x: &Element| matches!(self.ring.sign(x), Some(Ordering::Equal | Ordering::Greater));
            if !is_within(&plus(&unit, &off)) || !is_within(&minus(&unit, &off)) {
                return Err(Refused::Entry { map, entry });
            }
        }
        Ok(())
    }

    /// What [`Self::fill`] takes.
    pub fn cost_fill(&self) -> u64 {
        let area = 2 * self.letter;
        4 * self.ring.cost_product(self.letter, self.letter) + 3 * self.ring.cost_sign(area + 2)
    }

    /// Whether two maps scale areas by factors with a sum of 1 or more.
    pub fn fill(&self, pair: [usize; 2]) -> bool {
        let area = |k: usize| {
            let [a, b, c, d, ..] = &self.rows[k];
            let area = minus(&self.ring.product(a, d), &self.ring.product(b, c));
            match self.ring.sign(&area)? {
                Ordering::Less => Some(times(&area, &BigInt::from(-1))),
                _ => Some(area),
            }
        };
        let [Some(one), Some(other)] = pair.map(area) else { return false };
        let room = minus(&plus(&one, &other), &self.ring.whole(&self.scale * &self.scale));
        matches!(self.ring.sign(&room), Some(Ordering::Equal | Ordering::Greater))
    }
}
